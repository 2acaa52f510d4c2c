"""From one collision to the next: sizes, the map, the time between them, and the next distance.

Until the collision, and at its instant, no other pair of particles is in contact.
"""

from __future__ import annotations

from collections.abc import Iterator
from fractions import Fraction

from verify.language.argument import (
    ByRoot,
    Chapter,
    Defined,
    Item,
    Line,
    Value,
    identity,
    plus,
    power,
    proof,
    scaled,
    square,
    times,
)
from verify.language.terms import as_term, equal, sqrt
from verify.language.vectors import add, omega_c, omega_s, scale
from verify.paper.dynamics import laws
from verify.paper.dynamics.apart import colliding, contexts, opened, spectator, t
from verify.paper.dynamics.carried import start
from verify.paper.dynamics.laws import DISTANCE, TIME
from verify.paper.dynamics.state import (
    A,
    B,
    C,
    D,
    S,
    away,
    contact,
    d,
    difference,
    frame,
    tau,
    y,
    zeta,
)
from verify.paper.parameters import THEOREM
from verify.paper.sandwich.comparison import LABEL
from verify.paper.sandwich.state import (
    G_POSITIVE,
    HALF,
    G,
    Q,
    Q_next,
    U,
    U_b,
    U_next,
    carried,
    g,
    load,
    model,
    pace,
    rho,
    step,
    w_b,
    w_c,
    w_s,
)

PUSH = times("rho-positive", "U-positive")
GROWN = times("gain-positive", "g-positive")


def sizes() -> Iterator[Item]:
    """What the conditions say of a state."""
    yield from _sizes()
    speeds = (w_c, "w_c-positive"), (w_s, "w_s-positive")
    yield from laws.components(*speeds, times("w_c-positive", "w_s-positive"))
    yield from laws.root()
    yield from laws.between_zero_and_one()
    yield from _root()


def next_point() -> Iterator[Item]:
    """P, Q' and U', and where they lie."""
    radicand = 1 - load / pace / pace
    both = times(plus("U-room", "U-next-one"), power("pace-positive", 2))
    yield from (
        Line("Q-positive", 0 < Q, scaled(times("goal", "Cnd1"), "q-bound", "recedes")),
        Defined("rho"),
        Line("rho-positive", 0 < rho,
             proof(times(G_POSITIVE, power("w_s-positive", 2)), using="rho")),
        Defined("pace"),
        Line("pace-positive", 0 < pace, proof("approaches", using="pace")),
        Line("pace-law", equal(pace, model.alpha * (1 - U) - Q - rho * U), identity("pace rho"),
             LABEL, "P = α(1-U) - Q - ρU"),
        Defined("load"),
        Line("load-law", equal(load, rho * U * (2 * Q + rho * U)), identity("load rho"),
             LABEL, "P²(1-(1-U')²) = ρU(2Q+ρU)"),
        Line("load-positive", 0 < load,
             proof(times(PUSH, plus(times(2, "Q-positive"), PUSH)),
                   using="load-law")),
        Defined("Q_next"),
        Line("Q-next-law", equal(Q_next * pace, model.share * (1 - U)), identity("Q_next"),
             LABEL, "Q' = R(1-U)/P"),
        Line("meets-here", load <= U_b * (2 - U_b) * pace**2, proof("meets", using="load pace")),
        Line("radicand", 0 < radicand,
             proof("meets-here", times(power("U-room", 2), power("pace-positive", 2)))),
        Line("map-root", 0 < sqrt(radicand), ByRoot()),
        Defined("U_next"),
        Line("U-next-law", equal(U_next * (2 - U_next) * pace**2, load),
             identity("U_next"), LABEL, "1-(1-U')² = ρU(2Q+ρU)/P²"),
        Line("U-next-one", 0 < 1 - U_next, proof("map-root", using="U_next")),
        Line("next-U-bound", carried.at_next("U-bound"),
             scaled(times("goal", both), "meets-here", equations=(("U-next-law", as_term(-1)),)),
             says="U' ≤ U*"),
    )  # fmt: skip


def lines() -> Iterator[Item]:
    """Everything about the time tau between the two collisions, and d_next."""
    yield from laws.time(times("d-positive", plus(2, "d-positive")))
    yield from _time()
    yield from laws.distance()
    yield from _distance()


def slow() -> Iterator[Item]:
    """Signs, and that the speed of approach is at most that at the start."""
    yield Line("g-positive", 0 < g, proof("Cnd2", "Cnd1"))
    yield Line("y-most", y <= start.y, proof("Cnd2", "g-bound"))
    yield Line("A-positive", 0 < A, proof("cs-c", power("Cnd1", 2)))
    yield Line("B-positive", 0 < B, proof("cs-s", power("recedes", 2)))


def _sizes() -> Iterator[Item]:
    yield from slow()
    for name, i, size, speed, gone in (
        ("A", "c", A, w_c, times("ratio-positive", GROWN)),
        ("B", "s", B, w_s, GROWN),
    ):
        yield Line(f"{name}-below", size <= speed**2,
                   proof(f"{name}-upper", times(gone, plus(f"high-{i}", f"w_{i}-positive"))),
                   says=f"|W_{i}| ≤ w_{i}")  # fmt: skip


def _root() -> Iterator[Item]:
    bent = times(power("d-sum-positive", 2), power("Cnd1", 2))
    closer = times("d-positive", plus(2, "d-positive"))
    both = plus("U-one", "U-room")
    yield from (
        Line("zeta-bound", zeta <= U * (2 - U),
             scaled(times("goal", bent), "u-bound", times(closer, "A-below"),
                    equations=(("zeta-product", as_term(1)),))),
        Line("S-least",    1 - U <= S,
             scaled(times("goal", plus("goal", times(2, "S-positive"))), "zeta-bound",
                    using="S-square"), LABEL, "u = 1 - √(1-ζ) ≤ U"),
        Line("U-positive", 0 < U,
             scaled(times("goal", plus(1, "U-bound", "U-room")), "zeta-bound", "zeta-positive")),
        Line("U-one",      0 < 1 - U, proof("U-bound", "U-room")),
        Line("room-here",  U * (2 - U) * y**2 <= far,
             proof(times("U-bound", both, power("start-y", 2)),
                   times("U-positive", plus(1, "U-one"), "y-most", plus("start-y", "Cnd1")))),
        Line("far-least",  0 < w_b**2 - far,
             scaled(times("goal", power(G_POSITIVE, 2)), "start-reach", power("w_b-positive", 2))),
        Line("reach-here", 1 + d <= G, scaled(*_reach()), TIME, "1 + d ≤ Γ"),
    )  # fmt: skip


#: zeta times the square of the speed is at most this.
far = U_b * (2 - U_b) * start.y**2


def _reach() -> Iterator[Value]:
    """(1+d)^2 (w^2 - far) <= w^2, also with w_c for w; and G is that far at least."""
    longer = times("goal", plus("goal", times(2, G_POSITIVE)))
    square_ = power("d-sum-positive", 2)
    faster = times("w_c-least", plus("w_c-least", times(2, "w_b-positive")))
    yield times(power("w_c-positive", 2), "far-least", longer)
    yield times(power("w_c-positive", 2), "start-reach")
    yield times(square_, "U_b-positive", plus(1, "U-room"), power("start-y", 2), faster)
    yield times(power("w_b-positive", 2), plus("u-bound", times(square_, "room-here")))


def _time() -> Iterator[Item]:
    bent = times(power("d-sum-positive", 2), power("Cnd1", 2), "U-positive")
    longer = times("reach-here", "U-positive", power("Cnd1", 2), "d-sum-positive",
                   plus(1, "S-positive"))  # fmt: skip
    faster = times("w_c-least", plus("w_c-least", times(2, "w_b-positive")))
    yield from (
        laws.TIME_ROOT,
        Line("swift",     w_c**2 * tau <= G * U * y,
             scaled(times("goal", "d-sum-positive", "Cnd1", plus(1, "S-positive")), "u-bound",
                    longer, times(bent, "S-least"),
                    equations=(("time-root", -(w_c**2)),)), TIME, "w_c² τ ≤ ΓU(-η_c)"),
        Line("time",      tau <= step * y,
             proof("swift", times("tau-positive", faster), times(G_POSITIVE, "Cnd1", "U-bound")),
             TIME, "τ ≤ ΓU*(-η_c)/w²"),
        Line("pull",      w_s**2 * tau <= rho * U * y,
             proof(times(square(w_s), "swift"), using="rho"), LABEL, "w_s² τ ≤ ρU(-η_c)"),
        Line("inward",    d <= tau * y,
             scaled(times("goal", plus("goal", 2)), times(power("tau-positive", 2), "cs-c"),
                    equations=(("contact", as_term(-1)),)), DISTANCE, "d ≤ τ(-η_c)"),
    )  # fmt: skip


def _distance() -> Iterator[Item]:
    pushed = plus("pull", times("tau-positive", "B-below"))
    angle = plus("angle-real", "Theta-positive", times("U-positive", "obtuse"))
    yield from (
        Line("pull-most", B * tau <= rho * U * y, proof(pushed), says="|W_s|² τ ≤ ρU(-η_c)"),
        Line("light",     Q + rho * U <= 1,
             proof("pace-positive", times(HALF, angle), times(Fraction(1, 2), "r-below-one"),
                   using="pace-law")),
        Line("outward",   D - 1 <= tau * y,
             proof("distance", times("tau-positive", "q-bound"),
                   times("tau-positive", Fraction(1, 2), "pull-most"),
                   times("tau-positive", Fraction(1, 2), "rho-positive", "U-positive", "Cnd1"),
                   times("tau-positive", "Cnd1", "light")), DISTANCE, "d' ≤ τ(-η_c)"),
        laws.NEXT_D_POSITIVE,
        laws.NEXT_D_SUM_POSITIVE,
    )  # fmt: skip


dot = frame.dot
#: From particle s to particle c at the start.
outer = add(scale(1 + d, omega_c), scale(-1, omega_s))


def apart() -> Iterator[Chapter]:
    """The three pairs."""
    before, meanwhile = contexts()
    yield opened()
    yield Chapter(before.name, tuple(colliding()))
    yield Chapter(meanwhile.name, (spectator(), *_outer_pair()))


def _outer_pair() -> Iterator[Item]:
    """The angle at particle 0 stays obtuse."""
    left = A * tau - A * t
    place, other = contact(frame, t), away(t)
    path = add(outer, scale(t, difference))
    fast = 2 * (1 + d) * y * S
    sum_speeds = t * (w_c + w_s)
    yield from (
        Line("later",          0 <= C - sum_speeds,
             proof("turn-short", times(plus("w_c-positive", "w_s-positive"), "t-upper"),
                   times("start-y", "tau-positive"), equations=(("w-sum", -tau),))),
        Line("approach-until", equal(A * (dot(place, place) - 1), left * (left + fast)),
             identity("tau S")),
        Line("colliding-until", 1 <= dot(place, place),
             scaled(times("A-positive", "goal"),
                    times("A-positive", "t-upper",
                          plus(times("A-positive", "t-upper"),
                               times(2, "d-sum-positive", "Cnd1", "S-positive"))),
                    equations=(("approach-until", as_term(1)),)), THEOREM,
             "the pair 0-c does not overlap up to τ"),
        Line("outer-obtuse",   dot(place, other) <= Fraction(1, 4), proof(*_obtuse()), THEOREM,
             "x_s·x_c ≤ 1/4 up to τ"),
        Line("outer-pair-apart", 1 < dot(path, path),
             proof("colliding-until", "spectator-apart", times(2, "t-lower", "recedes"),
                   times(2, "outer-obtuse"), Fraction(1, 2)),
             THEOREM, "the outer pair s-c is apart for all times from 0 to τ, both included"),
    )  # fmt: skip


def _obtuse() -> Iterator[Value]:
    """C - tw - t²w_c w_s + 1/4 > 0 with w = w_c + w_s and tw <= C, and the rest of the product."""
    moved_c, moved_s = times("t-lower", "w_c-positive"), times("t-lower", "w_s-positive")
    yield times("d-positive", plus("later", moved_c))
    yield times("t-lower", "a-upper")
    yield times("d-sum-positive", "t-lower", "b-upper")
    yield times("t-lower", "t-lower", "w-upper")
    yield times(Fraction(1, 4), square(t * (w_c - w_s)))
    yield times(Fraction(1, 4), "C-one", plus(1, "C-positive"))
    yield times(Fraction(1, 4), "later", plus("C-positive", moved_c, moved_s))
    yield "later"
