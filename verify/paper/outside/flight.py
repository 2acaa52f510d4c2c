"""Sizes of a state, the time to the next collision, and how far the other particle is then."""

from __future__ import annotations

from collections.abc import Iterator

from verify.language.argument import (
    Defined,
    Item,
    Line,
    Value,
    plus,
    power,
    proof,
    scaled,
    square,
    times,
)
from verify.language.terms import as_term
from verify.paper.dynamics import laws
from verify.paper.dynamics.carried import start
from verify.paper.dynamics.laws import DISTANCE, TIME, absolute
from verify.paper.dynamics.state import A, B, S, a, d, tau, y, zeta
from verify.paper.outside.state import G_POSITIVE, G, U, rho, step, v, v_c, v_s, w_c, w_s
from verify.paper.sandwich.comparison import LABEL
from verify.paper.sandwich.flight import GROWN, slow

ONE = as_term(1)


def sizes() -> Iterator[Item]:
    """What the conditions say of a state."""
    yield from slow()
    for i, size, most, least in (("c", A, w_c, v_c), ("s", B, w_s, v_s)):
        name = {"c": "A", "s": "B"}[i]
        yield Line(f"v_{i}-positive", 0 < least, proof(f"v_{i}-least", "v-positive"))
        yield Line(f"w_{i}-positive", 0 < most, proof(f"high-{i}", GROWN))
        yield Line(f"{name}-below", size <= most**2,
                   proof(f"{name}-upper", times(GROWN, plus(f"high-{i}", f"w_{i}-positive"))),
                   says=f"|W_{i}| ≤ w_{i}")  # fmt: skip
        yield Line(f"{name}-above", least**2 <= size,
                   proof(f"{name}-lower", times(GROWN, plus(times(2, f"v_{i}-positive"), GROWN))),
                   says=f"|W_{i}| ≥ v_{i}")  # fmt: skip
    yield from absolute("a", a, (w_c, "w_c-positive"), ("cs-a", "A-below"))
    yield from laws.root()
    yield from laws.between_zero_and_one()
    yield from _root()


def _root() -> Iterator[Item]:
    bent = times(power("d-sum-positive", 2), power("Cnd1", 2))
    closer = times("d-positive", plus(2, "d-positive"))
    yield from (
        Line("zeta-least", U * (2 - U) <= zeta,
             scaled(times("goal", bent), "u-bound", times(closer, "A-above"),
                    equations=(("zeta-product", -ONE),))),
        Line("S-most",     S <= 1 - U,
             scaled(times("goal", plus("goal", times(2, "U-one"))), "zeta-least",
                    using="S-square"), LABEL, "u = 1 - √(1-ζ) ≥ U"),
        Line("far-least",  0 < v**2 - start.y**2,
             scaled(times("goal", power(G_POSITIVE, 2)), "start-reach", power("v-positive", 2))),
        Line("reach-here", 1 + d <= G, scaled(*_reach(bent, closer),
                                              equations=(("zeta-product", -ONE),)), TIME,
             "1 + d ≤ Γ"),
    )  # fmt: skip


def _reach(bent: Value, closer: Value) -> Iterator[Value]:
    """(1+d)^2 (v^2 - y_0^2) < v^2, since zeta < 1; and G is that far at least."""
    longer = times("goal", plus("goal", times(2, G_POSITIVE)))
    faster = times("v_c-least", plus("v_c-least", times(2, "v-positive")))
    yield times("far-least", longer)
    yield "start-reach"
    yield times("zeta-one", bent)
    yield times(closer, plus("A-above", faster))
    yield times(power("d-sum-positive", 2), "y-most", plus("start-y", "Cnd1"))


def lines() -> Iterator[Item]:
    """Everything about the time tau between the two collisions, and d_next."""
    yield from laws.time(times("d-positive", plus(2, "d-positive")))
    faster = times("v_c-least", plus("v_c-least", times(2, "v-positive")))
    short = plus("A-above", faster)
    yield from (
        Line("time",        tau <= step * y,
             proof(times("tau-positive", short), times("reach-here", "Cnd1"),
                   times("d-sum-positive", "Cnd1", "S-positive"),
                   equations=(("tau-product", -ONE),)), TIME, "τ ≤ Γ(-η_c)/v²"),
        Line("swift-least", U * y <= w_c**2 * tau,
             proof(times("tau-positive", "A-below"), times("d-positive", "Cnd1", "S-one"),
                   times("Cnd1", "S-most"), equations=(("tau-product", ONE),)), TIME,
             "w_c² τ ≥ U(-η_c)"),
        Defined("rho"),
        Line("rho-positive", 0 < rho, proof(power("v_s-positive", 2), using="rho")),
        Line("pull-least",  rho * U * y <= v_s**2 * tau,
             proof(times(square(v_s), "swift-least"), using="rho"), LABEL, "v_s² τ ≥ ρU(-η_c)"),
        Line("push-least",  rho * U * y <= B * tau,
             proof("pull-least", times("tau-positive", "B-above")), says="|W_s|² τ ≥ ρU(-η_c)"),
        Line("inward",      d <= tau * y,
             scaled(times("goal", plus("goal", 2)), times(power("tau-positive", 2), "cs-c"),
                    equations=(("contact", -ONE),)), DISTANCE, "d ≤ τ(-η_c)"),
    )  # fmt: skip
    yield from laws.distance()
    yield laws.NEXT_D_POSITIVE
    yield laws.NEXT_D_SUM_POSITIVE
