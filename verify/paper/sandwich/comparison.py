"""The map of two numbers (Q, U) that bounds the dynamics, and what orders its orbits.

With alpha, rho and R it is P = alpha (1-U) - Q - rho U, Q' = R (1-U)/P, and 1 - (1-U')^2 = rho U
(2 Q + rho U)/P^2. The map that the dynamics stays below goes on from (Q, U) if P > 0 and U' <= U_b,
the one that it stays above if P > 0 and U' < 1. Stairs are numbers that satisfy the same with
inequalities, rounded up, and the orbit stays below them; it stays above floors, rounded down.
"""

from __future__ import annotations

from collections.abc import Iterator

from verify.language.argument import (
    ByRoot,
    Chapter,
    Item,
    Line,
    Opened,
    plus,
    power,
    proof,
    scaled,
    times,
)
from verify.language.record import Record
from verify.language.statement import Context, Given
from verify.language.terms import Claim, Term, sqrt
from verify.paper.letters import Letters

LABEL = "THEORSS4.1ExistenCollapse"


class Step(Record):
    """One step of the map: rho U, the factor P of the speeds, and 1 - (1-U')^2 times P^2."""

    push: Term
    P: Term
    load: Term
    next_q: Term

    @property
    def approaches(self) -> Claim:
        """That the speeds stay positive."""
        return 0 < self.P

    @property
    def meets(self) -> Claim:
        """That the next U is below 1."""
        return self.load < self.P**2

    def meets_below(self, U_b: Term) -> Claim:
        """That the next U is at most U_b."""
        return self.load <= U_b * (2 - U_b) * self.P**2

    @property
    def radicand(self) -> Term:
        """The square of 1 - U' for the next U."""
        return 1 - self.load / self.P / self.P

    @property
    def next_u(self) -> Term:
        """The next U."""
        return 1 - sqrt(self.radicand)


def step(alpha: Term, rho: Term, R: Term, Q: Term, U: Term) -> Step:
    """One step from (Q, U)."""
    push = rho * U
    P = alpha * (1 - U) - Q - push
    return Step(push, P, push * (2 * Q + push), R * (1 - U) / P)


class Model(Record):
    """What does not depend on which of the particles is next: C bounds -cos theta from below.

    The factor rho does: it is G w_s^2/w_c^2, where w_c and w_s bound the speeds from above.
    """

    r: Term
    G: Term
    U_b: Term
    C: Term

    @property
    def alpha(self) -> Term:
        """The factor of 1 - U in P."""
        return (1 + self.r) / 2 * self.C

    @property
    def share(self) -> Term:
        """The factor in Q'."""
        return self.r * self.G

    def rho(self, w_c: Term, w_s: Term) -> Term:
        """The factor of U in P."""
        return self.G * (w_s / w_c) ** 2

    def step(self, Q: Term, U: Term, w_c: Term, w_s: Term) -> Step:
        """One step from (Q, U), where the particle c is next."""
        return step(self.alpha, self.rho(w_c, w_s), self.share, Q, U)


n = Letters(
    "stair", alpha="α", rho="ρ", R="R", U_b="U*", Q="Q_n", U="U_n", Q_next="Q_{n+1}",
    U_next="U_{n+1}",
)  # fmt: skip
x = Letters("orbit", Q="Q", U="U")


def stair() -> Context:
    """Numbers that bound one step of the map."""
    return n.opened(
        "a step of a stair: numbers Q_{n+1}, U_{n+1} above where the map leads from Q_n, U_n",
        "1/2 1 3/100 1/10 1/10 1/50 1/10 1/50",
        {
            "alpha": 0 <= n.alpha,
            "rho": 0 <= n.rho,
            "R": 0 <= n.R,
            "U_b": n.U_b < 1,
            "Q": 0 <= n.Q,
            "U": 0 <= n.U,
            "U_next": 0 <= n.U_next,
            "U-most": n.U <= n.U_b,
            "U_next-most": n.U_next <= n.U_b,
            "approaches": above.approaches,
            "falls-Q": n.R * (1 - n.U) <= n.Q_next * above.P,
            "falls-U": above.load <= n.U_next * (2 - n.U_next) * above.P**2,
        },
    )


above = step(n.alpha, n.rho, n.R, n.Q, n.U)
below = step(n.alpha, n.rho, n.R, x.Q, x.U)


def orbit() -> Context:
    """A point below a step."""
    givens = {"Q-least": 0 <= x.Q, "U-least": 0 <= x.U, "Q": x.Q <= n.Q, "U": x.U <= n.U}
    named = tuple(Given(f"orbit-{name}", claim) for name, claim in givens.items())
    point = x.at(Q=n.Q, U=n.U)
    return Context(x.context, x.variables(), named, point, n.context, "a point below the step")


def chapters() -> Iterator[Chapter]:
    """What lies below a step of a stair stays below the next one."""
    yield Chapter(None, (Opened(stair()),))
    here = (
        Line("same-Q", n.Q <= n.Q, proof()),
        Line("same-U", n.U <= n.U, proof()),
        Opened(orbit(), ("stair-Q", "stair-U", "same-Q", "same-U")),
    )
    yield Chapter(n.context, here)
    yield Chapter(x.context, tuple(_below()))


def _below() -> Iterator[Item]:
    lower = times(plus("stair-alpha", "stair-rho"), "orbit-U")
    U_room = plus("orbit-U", "stair-U-most", "stair-U_b")
    falls = times(
        "stair-rho",
        plus(times(2, "orbit-U", "stair-Q"), times(2, "orbit-U-least", "orbit-Q"),
             times("stair-rho", "orbit-U", plus("stair-U", "orbit-U-least"))),
    )  # fmt: skip
    most = plus("stair-U-most", "stair-U_b")
    order = plus(
        times(most, plus("orbit-Q", times("stair-rho", "orbit-U"))),
        times("orbit-U", plus("stair-Q", times("stair-rho", "stair-U"))),
    )
    higher = times("orbit-pace", plus("orbit-approaches", "stair-approaches"))
    small = times("stair-U_next", plus(1, "stair-U_next-most", "stair-U_b"), higher)
    room = times("stair-U_next-most", plus(times(2, "stair-U_b"), "stair-U_next-most"))
    yield from (
        Line("orbit-pace",       above.P <= below.P, proof("orbit-Q", lower)),
        Line("orbit-approaches", below.approaches, proof("orbit-pace", "stair-approaches"),
             LABEL, "the map goes on from a point below a step: P > 0"),
        Line("orbit-load",       below.load <= n.U_next * (2 - n.U_next) * below.P**2,
             proof("stair-falls-U", falls, small)),
        Line("orbit-meets",      below.meets_below(n.U_b),
             proof("orbit-load", times(room, power("orbit-approaches", 2))),
             LABEL, "and the next U is at most U*"),
        Line("orbit-Q-falls",    below.next_q <= n.Q_next,
             scaled(times("goal", "stair-approaches"), times("stair-falls-Q", "orbit-approaches"),
                    times("stair-R", order)), LABEL, "Q' ≤ Q_{n+1}"),
        Line("orbit-radicand",   0 < below.radicand,
             proof("orbit-meets", times(power("stair-U_b", 2), power("orbit-approaches", 2)))),
        Line("orbit-root",       0 < sqrt(below.radicand), ByRoot()),
        Line("orbit-U-falls",    below.next_u <= n.U_next,
             scaled(times("goal", plus("goal", times(2, "orbit-root")),
                          power("orbit-approaches", 2)), "orbit-load"),
             LABEL, "U' ≤ U_{n+1}: it is below the next step"),
        Line("orbit-Q-stays",    0 <= below.next_q, proof(times("stair-R", U_room))),
        Line("orbit-U-stays",    0 <= below.next_u,
             scaled(times("goal", plus("goal", 2), power("orbit-approaches", 2)),
                    times("stair-rho", "orbit-U-least",
                          plus(times(2, "orbit-Q-least"), times("stair-rho", "orbit-U-least"))))),
    )  # fmt: skip


# --- floors ---------------------------------------------------------------------------------------


f = Letters(
    "floor", alpha="α", rho="ρ", R="R", Q_n="Q_n", U_n="U_n", Q_next="Q_{n+1}", U_next="U_{n+1}",
    Q="Q", U="U",
)  # fmt: skip
floor_step = step(f.alpha, f.rho, f.R, f.Q_n, f.U_n)
over_step = step(f.alpha, f.rho, f.R, f.Q, f.U)


def floor() -> Context:
    """Numbers from which one step of the map is bounded from below, and a point above them."""
    return f.opened(
        "a step of a floor: numbers Q_{n+1}, U_{n+1} below where the map leads from Q_n, U_n; and "
        "a point (Q, U) above, from which the map goes on",
        "1/2 1 3/100 1/10 1/10 1/50 1/50 1/10 1/10",
        {
            "alpha": 0 <= f.alpha,
            "rho": 0 <= f.rho,
            "R": 0 <= f.R,
            "Q": 0 <= f.Q_n,
            "U": 0 <= f.U_n,
            "U_next": 0 <= f.U_next,
            "U_next-room": f.U_next <= 1,
            "rises-Q": f.Q_next * floor_step.P <= f.R * (1 - f.U_n),
            "rises-U": f.U_next * (2 - f.U_next) * floor_step.P**2 <= floor_step.load,
            "over-Q": f.Q_n <= f.Q,
            "over-U": f.U_n <= f.U,
            "room": 0 < 1 - f.U,
            "approaches": over_step.approaches,
            "meets": over_step.meets,
        },
    )


def floor_chapters() -> Iterator[Chapter]:
    """What lies above a step of a floor stays above the next one, or stops."""
    yield Chapter(None, (Opened(floor()),))
    yield Chapter(f.context, tuple(_above()))


def _above() -> Iterator[Item]:
    lower = times(plus("floor-alpha", "floor-rho"), "floor-over-U")
    least = plus("floor-approaches", "over-pace")
    U_least, Q_least = plus("floor-U", "floor-over-U"), plus("floor-Q", "floor-over-Q")
    heavier = times(
        "floor-rho",
        plus(times(2, "floor-over-U", Q_least), times(2, "floor-U", "floor-over-Q"),
             times("floor-rho", "floor-over-U", plus("floor-U", U_least))),
    )  # fmt: skip
    slower = times("over-pace", plus("floor-approaches", least))
    order = plus(
        times("floor-room", plus("floor-over-Q", times("floor-rho", "floor-over-U"))),
        times("floor-over-U", plus(Q_least, times("floor-rho", U_least))),
    )
    small = times("floor-U_next", plus(1, "floor-U_next-room"), slower)
    yield from (
        Line("over-pace",       over_step.P <= floor_step.P, proof("floor-over-Q", lower)),
        Line("over-goes",       floor_step.approaches, proof("over-pace", "floor-approaches"),
             LABEL, "where the map goes on from a point above a floor, P > 0 on the floor"),
        Line("over-load",       floor_step.load <= over_step.load, proof(heavier)),
        Line("over-met",        floor_step.meets, proof("over-load", "floor-meets", slower),
             LABEL, "and ρU(2Q+ρU) < P² there: so where the floor ends, so does every orbit above"),
        Line("over-Q-rises",    f.Q_next <= over_step.next_q,
             scaled(times("goal", "over-goes"),
                    times("floor-rises-Q", "floor-approaches"), times("floor-R", order)),
             LABEL, "Q_{n+1} ≤ Q'"),
        Line("over-radicand",   0 < over_step.radicand, proof("floor-meets")),
        Line("over-root",       0 < sqrt(over_step.radicand), ByRoot()),
        Line("over-U-rises",    f.U_next <= over_step.next_u,
             scaled(times("goal", plus("over-root", "floor-U_next-room"),
                          power("floor-approaches", 2)),
                    "floor-rises-U", "over-load", small),
             LABEL, "U_{n+1} ≤ U': it is above the next step"),
    )  # fmt: skip
