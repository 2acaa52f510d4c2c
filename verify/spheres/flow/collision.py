"""One flight and the collision at its end: o and c meet, no other pair does, and what comes after.

The variables are the state at the start, the flight, and the state just after the collision; what
is given are the definitions, and the inequalities that say that o and c are the next pair.
"""

from __future__ import annotations

from collections.abc import Iterator
from fractions import Fraction

from verify.language.argument import (
    ByRoot,
    Chapter,
    Item,
    Line,
    Opened,
    identity,
    power,
    proof,
    square,
    times,
)
from verify.language.statement import Context
from verify.language.terms import Claim, Term, as_term, equal, sqrt, symbol
from verify.language.vectors import add, scale
from verify.spheres.flow.frame import BASIS, Frame, W_c, W_s, minus, moved, x_c, x_s
from verify.spheres.flow.law import Flight, Number, State, collided, flight, outer
from verify.spheres.flow.pairs import FREE, bernstein_claims, between
from verify.spheres.flow.spaces import space, state_of

CONTEXT, DURING, AFTER = "collision", "during", "after"
LAW = "EQUATSS2.1VitesPost-Colli"

r, share, t_after = map(symbol, ("r", "share", "t_after"))
now = state_of("")
way = Flight(*map(symbol, Flight._fields))
#: The numbers of the next state that have names of their own.
NAMED = ("lam", "eps", "A", "B", "C", "a", "b", "w")


def definitions() -> dict[str, Claim]:
    """What each number of the flight, and of the next state, is."""
    found: dict[str, Claim] = {}

    def define(name: str, term: Number) -> Term:
        found[f"{name}-is"] = equal(symbol(name), term)
        return symbol(name)

    flight(now, sqrt, define)
    collided(r, now, way, lambda name, term: define(f"{name}_next", term))
    return found


def conditions() -> dict[str, Claim]:
    """Why the flight exists, and why no other pair meets before its end, or at it."""
    return {
        "r-positive": 0 < r,
        "v-positive": 0 < now.v,
        "lam-positive": 0 < now.lam,
        "A-nonnegative": 0 <= now.A,
        "kap-nonnegative": 0 <= way.kap,
        "meet": 0 < 1 - now.A * way.kap,
        "divisor": 0 < 1 + way.s,
        "spectator-first": 0 <= now.sig,
        "spectator-middle": 0 <= now.sig + way.T * now.lam * now.rho,
        "spectator-last": 0 < symbol("eps_next"),
        **bernstein_claims("outer", outer(now), way.y * way.T),
        "B-nonnegative": 0 <= symbol("B_next"),
    }


def givens() -> dict[str, Claim]:
    """All that is given, each after what it needs."""
    free = {**definitions(), **conditions()}
    first = "r-positive v-positive lam-positive A-nonnegative y-is q-is kap-is kap-nonnegative"
    order = [*first.split(), "meet", "s-is", "divisor", "T-is"]
    return {name: free[name] for name in (*order, *(n for n in free if n not in order))}


def next_state() -> State:
    """The next state, whose numbers are variables where they have names."""
    return collided(r, now, way, lambda name, _: symbol(f"{name}_next"))


def context() -> Context:
    """The states from which o and c are the next to collide."""
    says = "o and c are the next pair to meet; what the state is just after their collision"
    return space(CONTEXT, says, _point(), givens())


def _point() -> dict[str, int | Fraction | Term]:
    """A collision in rational numbers."""
    r, one = Fraction(1, 2), Fraction(1)
    state = State(one, one, one, one, 0, 3 * one / 4, one, one, 0, 0, 0)
    point: dict[str, int | Fraction | Term] = {"r": r, **state._asdict()}
    way = flight(state, lambda _: one / 2, lambda name, x: point.setdefault(name, x))
    collided(r, state, way, lambda name, x: point.setdefault(f"{name}_next", x))
    return point


# --- the argument --------------------------------------------------------------------------------

frame, frame_next = Frame(now), Frame(next_state())
tau = way.y * way.T
omega = moved(x_c, tau, W_c)
speed = frame.dot(W_c, omega)
W_c_next = add(W_c, scale(-((1 + r) * speed), omega))
W_s_next = add(W_s, scale(-((1 + r) / 2 * speed), omega))
#: The vectors of the next state, in which c is the spectator.
NEXT = {"x_s": omega, "W_s": W_c_next, "x_c": moved(x_s, tau, W_s), "W_c": W_s_next}
#: What the numbers are in terms of v, lam, q, T and the inner products.
BASE = "s-linear eps-is rho-is y-is"


def chapters() -> Iterator[Chapter]:
    """The contact, the law of collision, and the three pairs."""
    until = {"share-positive": 0 < share, "share-most": 0 <= 1 - share}
    during = space(DURING, "a share of the time of flight", {share.name: 1}, until, CONTEXT)
    later = {"t_after-positive": 0 < t_after}
    after = space(AFTER, "a time after the collision", {t_after.name: 1}, later, CONTEXT)
    yield Chapter(None, (Opened(context()),))
    yield Chapter(CONTEXT, (*_numbers(), *_contact(), *_law(), Opened(during), Opened(after)))
    yield Chapter(DURING, tuple(_pairs()))
    yield Chapter(AFTER, (_parting(),))


def _numbers() -> Iterator[Item]:
    s, T = way.s, way.T
    one = as_term(1)
    cofactors = (("kap-is", as_term(-1)), ("kap-linear", now.lam**2))
    yield Line("root-positive", 0 < definitions()["s-is"].rhs, ByRoot())
    yield Line("s-positive", 0 < s, proof("root-positive", using="s-is"))
    yield Line("T-linear", equal(now.A * T, 1 - s), identity("T-is s-is"))
    yield Line("s-linear", equal(s, 1 - now.A * T), identity("", (("T-linear", one),)))
    yield Line("kap-linear", equal(way.kap, T * (1 + s)), identity("T-is"))
    yield Line("eps-is", equal(now.eps, T * (1 + s) * now.lam**2), identity("", cofactors))
    yield Line("rho-is", equal(now.rho, way.q * now.lam), identity("q-is"))
    yield Line("y-positive", 0 < way.y, proof(times("lam-positive", "v-positive"), using="y-is"))


def _contact() -> Iterator[Item]:
    yield from (
        Line("contact",         equal(frame.square(omega), 1), identity(BASE), FREE,
             "at the time y T the spheres o and c are in contact: |ω| = 1 for ω = x_c + yT W_c"),
        Line("impact",          equal(speed, -(way.y * way.s)), identity(BASE),
             LAW, "and approach with the speed y s: W_c·ω = -y s"),
        Line("impact-positive", 0 < way.y * way.s, proof(times("y-positive", "s-positive")),
             LAW, "which is positive"),
    )  # fmt: skip


def _law() -> Iterator[Item]:
    using = " ".join((BASE, *(f"{name}_next-is" for name in NAMED)))
    for k, i in enumerate(BASIS):
        for j in BASIS[k:]:
            yield Line(f"next-{i}-{j}", equal(frame.dot(NEXT[i], NEXT[j]), frame_next.gram(i, j)),
                       identity(using), LAW,
                       f"the next {i}·{j}, where c is the spectator: x_s' = ω, W_s' = W_c - "
                       "(1+r)(W_c·ω)ω, x_c' = x_s + yT W_s and W_c' = W_s - (1+r)/2 (W_c·ω)ω",
                       ("hard-spheres",))  # fmt: skip


def _pairs() -> Iterator[Item]:
    path = moved(x_c, share * tau, W_c)
    yield Line("colliding-pair-apart",
               1 + 2 * (1 - share) * tau * (way.y * way.s) <= frame.square(path),
               proof(times("A-nonnegative", square((1 - share) * tau)), using=BASE), FREE,
               "o and c are apart before: |x_c + tW_c|² >= 1 + 2(τ-t) y s for t = share τ, τ = yT",
    )  # fmt: skip
    path, scaled = moved(x_s, share * tau, W_s), power("v-positive", 2)
    yield Line("spectator-apart", 1 < frame.square(path),
               proof(times(scaled, between("spectator", "share-positive", "share-most")),
                     using=f"{BASE} eps_next-is"),
               FREE, "o and s are apart in ]0, τ]: |x_s + tW_s| > 1")  # fmt: skip
    path = moved(minus(x_c, x_s), share * tau, minus(W_c, W_s))
    yield Line("outer-apart", 1 < frame.square(path),
               proof(between("outer", "share-positive", "share-most")),
               FREE, "s and c are apart in ]0, τ]: |x_c - x_s + t(W_c - W_s)| > 1")  # fmt: skip


def _parting() -> Line:
    push = times(2, "t_after-positive", "r-positive", "s-positive", "y-positive")
    return Line("pair-that-met-parts", 1 < frame_next.square(moved(x_s, t_after, W_s)),
                proof(push, times(square(t_after), "B-nonnegative")), FREE,
                "after the collision o and c do not meet again in free flight: |x_s' + tW_s'| > 1, "
                "t > 0")  # fmt: skip
