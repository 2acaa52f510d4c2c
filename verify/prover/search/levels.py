"""A cosine beside the value that it has at a rational angle: the difference as a product.

Where cos(pi a) = K, the rule *angles* says cos(pi u) - K = 2 cos(pi p) cos(pi q), with p = (1 - a +
u)/2 and q = (1 - a - u)/2. The signs of the factors are claims of their own.
"""

from __future__ import annotations

from fractions import Fraction
from math import acos, pi

from verify.language.statement import PROVED
from verify.language.terms import Claim, Term, as_term, equal, names_of
from verify.prover.algebraic import MAX_MULTIPLE
from verify.prover.proof import Proof
from verify.prover.rules import Sum
from verify.prover.search.cosine_bounds import CosineBounds
from verify.prover.session import ZERO

BITS = 128


def by_levels(bounds: CosineBounds) -> Proof | None:
    """A proof of `b cos(pi u) + constant < 0`, or `<=`, for an angle u with variables."""
    moving = [c for c in bounds.parts if next(names_of(c), None) is not None]
    if len(moving) != 1 or moving[0].op != "cos_pi" or not bounds.parts[moving[0]].is_constant():
        return None
    (cosine,) = moving
    number = bounds.clearing.term(bounds.parts[cosine]).value
    scale = bounds.clearing.constant(-1 / number)
    level = bounds.clearing.term(bounds.constant * scale)
    for other, b in bounds.parts.items():
        if other != cosine:
            level = level + bounds.clearing.term(b * scale) * other
    if level == ZERO or next(names_of(level), None) is not None:
        return None
    found = _angle(bounds, level)
    if found is None:
        return None
    a, equation = found
    (u,) = cosine.children
    first, second = (1 - a + u) / 2, (1 - a - u) / 2
    one, two = Term("cos_pi", first), Term("cos_pi", second)
    signs = _signs(bounds, [one, two], 1 if number < 0 else -1)
    if signs is None:
        return None
    opposite = Term("cos_pi", as_term(1 - a))
    turned = bounds.relations.turned(as_term(1 - a), as_term(a), 1, same=False)
    product = bounds.relations.product(one, two, opposite, cosine)
    return Sum(
        ("goal", ("mul", str(2 * abs(number)), *signs)),
        tuple(bounds.linear.using),
        (
            *bounds.linear.cofactors(-1),
            (product, as_term(number)),
            (turned, as_term(number)),
            (equation, as_term(-number)),
        ),
    )


def _angle(bounds: CosineBounds, level: Term) -> tuple[Fraction, str] | None:
    """A rational angle whose cosine this is, and the name of that fact."""
    ground = bounds.question.known.ground
    ball = ground.ball(level, BITS)
    if ball is None or not abs(float(ball.mid())) <= 1:
        return None
    a = Fraction(acos(float(ball.mid())) / pi).limit_denominator(MAX_MULTIPLE)
    claim = equal(Term("cos_pi", as_term(a)), level)
    verdict, proof = ground.prove(claim)
    if verdict != PROVED or proof is None:
        return None
    return a, bounds.relations.session.ensure(claim, proof)


def _signs(bounds: CosineBounds, factors: list[Term], wanted: int) -> list[str] | None:
    """Facts on the signs of the factors, whose product has to have this sign."""
    relation = bounds.goal.claim.relation
    for first in (1, -1):
        claims = [
            Claim(relation, ZERO, factor if sign == 1 else -factor)
            for factor, sign in zip(factors, (first, first * wanted), strict=True)
        ]
        if any(bounds.is_false(claim) for claim in claims):
            continue
        names = [bounds.question.fact(claim) for claim in claims]
        known = [name for name in names if name is not None]
        if len(known) == len(names):
            return known
    return None
