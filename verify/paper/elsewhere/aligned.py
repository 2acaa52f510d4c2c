"""A collapse on a line, for r = 1/20: all its numbers, and what it says about the comparisons.

Balls 1 and 2 are on opposite sides of 0, and all velocities lie on the line: with a unit vector e,
omega_1 = e, omega_2 = -e, W_2 = ye, W_1 = (y/8)e. The mapping keeps this form; y, d and tau fall by
the factors 2/5, 1/8 and 5/16 at each collision. T is the time so far.
"""

from __future__ import annotations

from collections.abc import Iterator
from fractions import Fraction

from verify.language.argument import (
    ByInduction,
    BySum,
    Chapter,
    Item,
    Line,
    Opened,
    identity,
    proof,
    scaled,
    times,
)
from verify.language.statement import Always, Given
from verify.language.terms import Claim, Term, as_term, equal, substitute, substitute_claim
from verify.language.vectors import basis_vector, scale
from verify.paper.elsewhere import mapping
from verify.paper.letters import Letters, Refuted, Space, minus, refuted
from verify.paper.rows import BREAKS, SLIP

LARGE = "EQUATSS3.3PROPOComp1PerpG"
PROPOSITION = "PROPOSS3.3AsympCompa__I__"

n = Letters("line", y="|η₂|", d="d", T="T")
r = Fraction(1, 20)
START = n.point("1 1 0")
SHRUNK, FALLEN = Fraction(1, 8), Fraction(2, 5)

e = basis_vector("e")
dot = Space({("e", "e"): as_term(1)}).dot
omega_1, omega_2, W_1, W_2 = e, scale(-1, e), scale(SHRUNK * n.y, e), scale(n.y, e)
tangential = minus(W_2, scale(dot(W_2, omega_2), omega_2))
tau, spread, grown = n.d / n.y, 1 + n.d, 1 + SHRUNK * n.d

#: The numbers of the mapping on the line.
VALUES = mapping.n.at(
    r=r, d=n.d, y=n.y, eta=dot(omega_1, W_1), cos=dot(omega_1, omega_2), a=dot(omega_1, W_2),
    b=dot(omega_2, W_1), A=dot(W_2, W_2), B=dot(W_1, W_1), w=dot(W_1, W_2), S=1 / spread, tau=tau,
    D=grown, p_1=0, p_2=0, q_1=0, q_2=0,
)  # fmt: skip


def chapters() -> Iterator[Chapter]:
    """The orbit from its start, by induction; its time is bounded, and it stays on the line."""
    says = "a collapse on a line, r = 1/20, after any number of collisions"
    givens = tuple(Given(f"line-{name}", claim, "carried") for name, claim in carried().items())
    context = n.opened(says, "1 1 0", {})._replace(givens=givens)
    begin = tuple(Line(f"first-{name}", substitute_claim(claim, START), at_start(claim))
                  for name, claim in carried()
                  .items())  # fmt: skip
    premises = tuple(f"first-{name}" for name in carried())
    always = Line("line-always", Always(n.context, START, following()),
                  ByInduction(premises, tuple(f"next-{name}" for name in carried())), LARGE,
                  "the orbit of y = d = 1 has infinitely many collisions: all this holds after "
                  "each")  # fmt: skip
    yield Chapter(None, (*begin, Opened(context, premises)))
    yield Chapter(n.context, (*_images(), *_steps(), *_collapse()))
    yield Chapter(None, (always,))


def carried() -> dict[str, Claim]:
    """What holds after each collision."""
    return {
        "closing": 0 < n.y,
        "apart": 0 < n.d,
        "clock": equal(11 * n.T * n.y + 16 * n.d, 16 * n.y),
    }


def following() -> dict[str, Term]:
    """The state after the next collision, in which 1 and 2 have exchanged their names."""
    return n.at(y=FALLEN * n.y, d=SHRUNK * n.d, T=n.T + tau)


def at_start(claim: Claim) -> BySum:
    """Why a claim between numbers holds at the start."""
    return identity() if claim.relation == "=" else proof(1)


def _images() -> Iterator[Item]:
    """The mapping on the line."""
    yield Line("line-spread", 0 < spread, proof(1, "line-apart"))
    yield Line("line-grown", 0 < grown, proof(1, times(SHRUNK, "line-apart")))
    next_y = as_term(FALLEN) * n.y
    for name, term, value, says in (
        ("distance", mapping.n.D - 1, SHRUNK * n.d, "d' = d/8"),
        ("normal-1", mapping.dot(mapping.speed_1, mapping.new_1), -next_y, "η₁' = (2/5)η₂"),
        ("normal-2", mapping.dot(mapping.speed_2, mapping.new_2), SHRUNK * next_y,
         "η₂' = -(1/8)η₁': so the new colliding ball and the new spectator are as before"),
        ("cosine",   mapping.dot(mapping.new_1, mapping.new_2), as_term(-1), "ω₁'·ω₂' = -1"),
        ("speed-1",  mapping.dot(mapping.speed_1, mapping.speed_1), next_y**2, "|W₁'|² = η₁'²"),
        ("speed-2",  mapping.dot(mapping.speed_2, mapping.speed_2), (SHRUNK * next_y) ** 2,
         "|W₂'|² = η₂'²"),
    ):  # fmt: skip
        yield Line(f"line-{name}", equal(on_the_line(term), value), identity(),
                   LARGE, f"on the line: {says}")  # fmt: skip
    for name in ("contact-time", "speed-time", "distance"):
        claim = mapping.givens()[name]
        held = equal(on_the_line(claim.lhs), on_the_line(claim.rhs))
        yield Line(f"line-{name}-held", held, identity())


def on_the_line(term: Term) -> Term:
    """A term of the mapping with the numbers of the line."""
    products = {
        "map-kappa": mapping.dot(mapping.W_2, mapping.new_2),
        "map-c": mapping.dot(mapping.new_1, mapping.new_2),
    }
    return substitute(substitute(term, products), VALUES)


def _steps() -> Iterator[Item]:
    steps = {name: substitute_claim(claim, following()) for name, claim in carried().items()}
    yield Line("next-closing", steps["closing"], proof(times(FALLEN, "line-closing")))
    yield Line("next-apart", steps["apart"], proof(times(SHRUNK, "line-apart")))
    yield Line("next-clock", steps["clock"], identity("", (("line-clock", FALLEN * n.y),)))


def _collapse() -> Iterator[Item]:
    yield from (
        Line("line-time",       11 * n.T < as_term(16),
             scaled(times("goal", "line-closing"), times(16, "line-apart"))
             ._replace(equations=(("line-clock", as_term(-1)),)),
             LARGE, "all collisions happen before the time 16/11: it is a collapse"),
        Line("line-tangential", equal(dot(tangential, tangential), 0), identity(),
             LARGE, "|W₂⊥| = 0 at every collision: so |W₂⊥| = o(-η₂)"),
    )  # fmt: skip


#: The state after six collisions.
_Y, _D = FALLEN**6, SHRUNK**6
SIXTH = f"{_Y} {_D} {Fraction(16, 11) * (1 - _D / _Y)}"
ETA_1 = SHRUNK * n.y
#: d' eta_1 + tau |W_1|^2 + d (-eta_2) + tau |W_2|^2
REST = SHRUNK * n.d * ETA_1 + tau * ETA_1**2 + n.d * n.y + tau * n.y**2


def misprints() -> Iterator[Refuted]:
    """What is false here, each with a point at which it is."""
    yield from (
        refuted(n, "tangential-large", n.y**2 <= 10**6 * dot(tangential, tangential), SIXTH,
                label=LARGE,
                says="|W₂⊥| = o(-η₂) or |W₂⊥| = O(-η₂) cannot hold: a claim of the proposition, "
                     "which no other one uses; here with the constant 1000: at some collision "
                     "-η₂ ≤ 1000|W₂⊥|, but on the line W₂⊥ = 0",
                severity=BREAKS, corrected_by="line-tangential"),
        refuted(n, "change-1-sign", (1 + r) * n.y <= 1000 * REST, SIXTH, label=PROPOSITION,
                says="η₁' - η₁ - (1+r)/2 cos θ̄ η₂ = O(d'η₁, τ|W₁|², dη₂, τ|W₂|²), here with the "
                     "constant 1000: on the line the left side is (1+r)η₂, and the right side "
                     "falls with dη₂", severity=SLIP, corrected_by="change-1"),
        refuted(n, "change-2-sign", 2 * r * n.y <= 1000 * (n.d * n.y + tau * n.y**2), SIXTH,
                label=PROPOSITION,
                says="η₂' - rη₂ = O(dη₂, τ|W₂|²), here with the constant 1000: on the line the "
                     "left side is -2rη₂, and the right side falls with dη₂", severity=SLIP,
                corrected_by="change-2"),
    )  # fmt: skip
