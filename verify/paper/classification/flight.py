"""Two balls in free flight: their distance lies above its tangent, and rho never falls.

x is the vector from one to the other and w their relative velocity; D = |x|, rho = x.w/|x|, and
E = |x + tw| after the time t. Nothing is differentiated: the two claims compare two instants.
"""

from __future__ import annotations

from collections.abc import Iterator, Mapping
from fractions import Fraction

from verify.language.argument import (
    ByInstance,
    Chapter,
    Item,
    Line,
    Opened,
    plus,
    power,
    scaled,
    times,
)
from verify.language.statement import Context
from verify.language.terms import Claim, Number, Term, as_term, equal, substitute_claim
from verify.paper.letters import Letters

CONTEXT = "flight"
LABEL = "EQUATSS2.1_Loi_de_Newton_"
GIVENS = ("now-apart", "later-apart", "time", "cs", "distance")

v = Letters(CONTEXT, D="|x|", rho="ρ", W="|w|²", t="t", E="|x+tw|")


def context() -> Context:
    """Two balls whose centres are apart now and after a time without collisions of theirs."""
    return v.opened(
        "two balls in free flight for a time t > 0; x is the vector between them, w their "
        "relative velocity, ρ = x·w/|x|",
        f"1 0 1 {Fraction(3, 4)} {Fraction(5, 4)}",
        {
            "now-apart": 0 < v.D,
            "later-apart": 0 < v.E,
            "time": 0 < v.t,
            "cs": (v.D * v.rho) ** 2 <= v.D**2 * v.W,
            "distance": equal(v.E**2, v.D**2 + 2 * v.t * (v.D * v.rho) + v.t**2 * v.W),
        },
    )


def values(D: Number, rho: Number, W: Number, t: Number, E: Number) -> dict[str, Term]:
    """Values at which the two claims are used."""
    return v.at(D=D, rho=rho, W=W, t=t, E=E)


TANGENT: Claim = v.D + v.t * v.rho <= v.E
NORMAL: Claim = v.rho <= (v.D * v.rho + v.t * v.W) / v.E


def chapters() -> Iterator[Chapter]:
    """The distance is convex: it lies above its tangent, and its slope rho does not fall."""
    yield Chapter(None, (Opened(context()),))
    yield Chapter(CONTEXT, tuple(_lines()))


def _lines() -> Iterator[Item]:
    uses = ("cauchy-schwarz",)
    square = power("flight-now-apart", 2)
    yield from (
        Line("flight-tangent", TANGENT,
             scaled(times("goal", plus("goal", times(2, "flight-later-apart")), square),
                    times(power("flight-time", 2), "flight-cs"))
             ._replace(equations=(("flight-distance", v.D**2),)),
             LABEL, "|x| + tρ ≤ |x+tw|: in free flight the distance lies above its tangent", uses),
        Line("flight-normal",  NORMAL,
             scaled(times("flight-time", "goal"),
                    times(plus("flight-now-apart", "flight-later-apart"), "flight-tangent"))
             ._replace(equations=(("flight-distance", as_term(-1)),)), LABEL,
             "in free flight ρ = x·w/|x|, the speed at which the distance grows, never falls",
             uses),
    )  # fmt: skip


def used(
    name: str, claim: Claim, at: Mapping[str, Term], premises: tuple[str, ...]
) -> Iterator[Item]:
    """One of the two claims at some values; what the givens say there is proved by the premises.

    A premise is the name of a fact that is the given itself.
    """
    fact = "flight-tangent" if claim is TANGENT else "flight-normal"
    yield Line(name, substitute_claim(claim, at), ByInstance(fact, at, premises))


def given_at(name: str, at: Mapping[str, Term]) -> Claim:
    """What a given of this context says at some values."""
    claims = {given.name: given.claim for given in context().givens}
    return substitute_claim(claims[f"{CONTEXT}-{name}"], at)
