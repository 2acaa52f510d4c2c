"""From one collision to the next: sizes, the time between them, and the next distance.

Until the collision, and at its instant, no other pair of particles is in contact.
"""

from __future__ import annotations

from collections.abc import Iterator
from fractions import Fraction

from verify.language.argument import (
    Chapter,
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
from verify.language.terms import as_term, equal
from verify.language.vectors import add, omega_c, omega_s, scale
from verify.paper.dynamics import laws
from verify.paper.dynamics.apart import colliding, contexts, opened, spectator, t
from verify.paper.dynamics.laws import DISTANCE, TIME, absolute
from verify.paper.dynamics.state import (
    A,
    B,
    C,
    D,
    S,
    a,
    away,
    b,
    contact,
    d,
    difference,
    eta_s,
    frame,
    tau,
    w,
    y,
    zeta,
)
from verify.paper.parameters import THEOREM
from verify.paper.sandwich.comparison import LABEL
from verify.paper.sandwich.numbers import G_POSITIVE, G, gain, start, step, v
from verify.paper.sandwich.state import U, g, rho, v_c, w_c, w_s

GROWN = times("gain-positive", "g-positive")
#: The bounds of both speeds from below.
LOW = {"c": plus("v_c-positive", GROWN), "s": plus("v_s-positive", GROWN)}


def sizes() -> Iterator[Item]:
    """What the conditions say of a state."""
    yield from _sizes()
    yield from _components()
    yield from laws.root()
    yield from laws.between_zero_and_one()
    yield from _root()


def lines() -> Iterator[Item]:
    """Everything about the time tau between the two collisions, and d_next."""
    yield from laws.time(times("d-positive", plus(2, "d-positive")))
    yield from _time()
    yield from laws.distance()
    yield from _distance()


def _sizes() -> Iterator[Item]:
    yield Line("g-positive", 0 < g, proof("Cnd2", "Cnd1"))
    yield Line("y-most", y <= start.y, proof("Cnd2", "g-bound"))
    fall = times(2, "gain-positive", "g-bound")
    for name, i, size in (("A", "c", A), ("B", "s", B)):
        high = (w_c if i == "c" else w_s) - gain * g
        slower = plus(f"v_{i}-least", GROWN)
        yield from (
            Line(f"{name}-positive", 0 < size, proof(f"{name}-lower", power(LOW[i], 2))),
            Line(f"{name}-least", v**2 <= size,
                 proof(f"{name}-lower", times(slower, plus(slower, times(2, "v-positive"))))),
            Line(f"high-{i}", 0 < high, proof(f"room-{i}", fall, LOW[i])),
            Line(f"w_{i}-positive", 0 < (w_c if i == "c" else w_s), proof(f"high-{i}", GROWN)),
            Line(f"{name}-below", size <= (w_c if i == "c" else w_s) ** 2,
                 proof(f"{name}-upper", times(GROWN, plus(f"high-{i}", f"w_{i}-positive"))),
                 says=f"|W_{i}| ≤ w_{i}"),
        )  # fmt: skip


def _components() -> Iterator[Item]:
    yield from absolute("a", a, (w_c, "w_c-positive"), ("cs-a", "A-below"))
    yield from absolute("b", b, (w_s, "w_s-positive"), ("cs-b", "B-below"))
    facts = (times("A-below", "B-positive"), times(square(w_c), "B-below"))
    both = times("w_c-positive", "w_s-positive")
    yield from absolute("w", w, (w_c * w_s, both), ("cs-w", *facts))
    for name, size, i, pair, norm in (
        ("closing-speed", y, "c", "cs-c", "A-below"),
        ("parting-speed", eta_s, "s", "cs-s", "B-below"),
    ):
        goal = times("goal", plus("goal", times(2, f"w_{i}-positive")))
        yield Line(name, size <= (w_c if i == "c" else w_s), scaled(goal, pair, norm))
    yield Line("C-one", C <= 1, scaled(times("goal", plus("goal", 2)), "cs-omega"))


def _root() -> Iterator[Item]:
    bent = times(power("d-sum-positive", 2), plus("start-y", "Cnd1"), "y-most")
    longer = times("goal", plus("goal", times(2, G_POSITIVE)))
    far = times(longer, "slow", plus("slow", times(2, "start-y")))
    yield from (
        Line("zeta-bound", zeta <= U * (2 - U), proof("u-bound", using="zeta")),
        Line("S-least",    1 - U <= S,
             scaled(times("goal", plus("goal", times(2, "S-positive"))), "zeta-bound",
                    using="S-square"), LABEL, "u = 1 - √(1-ζ) ≤ U"),
        Line("U-positive", 0 < U,
             scaled(times("goal", plus(1, "U-bound", "U-room")), "zeta-bound", "zeta-positive")),
        Line("U-one",      0 < 1 - U, proof("U-bound", "U-room")),
        Line("reach-here", 1 + d <= G,
             scaled(times(far, "A-positive"), times("A-positive", "start-reach"),
                    times("A-positive", bent),
                    times(power("d-sum-positive", 2), power("Cnd1", 2), "A-least"),
                    times(power("v-positive", 2), power("d-sum-positive", 2), power("Cnd1", 2),
                          "zeta-one"))
             ._replace(equations=(("zeta-product", -(v**2)),)), TIME, "1 + d ≤ Γ, as ζ < 1"),
    )  # fmt: skip


def _time() -> Iterator[Item]:
    near = times("Cnd1", "reach-here", "S-one")
    quick = times("tau-positive", "A-quick")
    yield from (
        Line("time",    tau <= step * y,
             proof(times("tau-positive", "A-least"), near,
                   times("Cnd1", "S-least", G_POSITIVE), times(G_POSITIVE, "Cnd1", "U-bound"),
                   equations=(("tau-product", as_term(-1)),)),
             TIME, "τ ≤ ΓU*(-η_c)/v²"),
        Line("A-quick", v_c**2 <= A,
             proof("A-lower", times(GROWN, plus(GROWN, times(2, "v_c-positive"))))),
        Line("pull",    B * tau <= rho * (1 - S) * y,
             proof(times("tau-positive", "B-below", power("v_c-positive", 2)),
                   times(square(w_s), quick), times(square(w_s), near),
                   using="rho", equations=(("tau-product", -(w_s**2)),)),
             LABEL, "|W_s|² τ ≤ ρu(-η_c)"),
        Line("inward",  d <= tau * y,
             scaled(times("goal", plus("goal", 2)), times(power("tau-positive", 2), "cs-c"),
                    equations=(("contact", as_term(-1)),)), DISTANCE, "d ≤ τ(-η_c)"),
    )  # fmt: skip


def _distance() -> Iterator[Item]:
    outward = plus("goal", 2, times(2, "tau-positive", "w_s-positive"))
    yield from (
        Line("outward", D - 1 <= tau * w_s,
             scaled(times("goal", outward), times(2, "tau-positive", "parting-speed"),
                    times(power("tau-positive", 2), "B-below"),
                    equations=(("D-square", as_term(-1)),)), DISTANCE, "d' ≤ τw_s"),
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
        Line("later",          0 <= C - 2 * sum_speeds,
             proof("turn-short", times(2, plus("w_c-positive", "w_s-positive"), "t-upper"),
                   equations=(("w-sum", -(2 * tau)),))),
        Line("approach-until", equal(A * (dot(place, place) - 1), left * (left + fast)),
             identity("tau S")),
        Line("colliding-until", 1 <= dot(place, place),
             scaled(times("A-positive", "goal"),
                    times("A-positive", "t-upper",
                          plus(times("A-positive", "t-upper"),
                               times(2, "d-sum-positive", "Cnd1", "S-positive"))),
                    equations=(("approach-until", as_term(1)),)), THEOREM,
             "the pair 0-c does not overlap up to τ"),
        Line("outer-obtuse",   dot(place, other) < 0, proof(*_obtuse()), THEOREM,
             "the angle at 0 is obtuse up to τ"),
        Line("outer-pair-apart", 1 < dot(path, path),
             proof("colliding-until", "spectator-apart", times(2, "t-lower", "recedes"),
                   times(2, "outer-obtuse"), 1),
             THEOREM, "the outer pair s-c is apart for all times from 0 to τ, both included"),
    )  # fmt: skip


def _obtuse() -> Iterator[Value]:
    """C - tw - t²w_c w_s > 0 with w = w_c + w_s and 2tw <= C, and what is left of the product."""
    moved_c, moved_s = times("t-lower", "w_c-positive"), times("t-lower", "w_s-positive")
    yield times("d-positive", plus("later", moved_s, times(2, moved_c)))
    yield times("t-lower", "a-upper")
    yield times("d-sum-positive", "t-lower", "b-upper")
    yield times("t-lower", "t-lower", "w-upper")
    yield times(Fraction(1, 4), square(t * (w_c - w_s)))
    yield times(Fraction(1, 16), "C-positive", plus("C-one", 7, times(2, "later")))
    yield times(Fraction(1, 16), "later", plus(7, "C-one", times(2, moved_c), times(2, moved_s)))
