"""Quadratic polynomials that are nowhere negative: one square is completed after the other."""

from __future__ import annotations

from fractions import Fraction

from flint import fmpq_mpoly

from verify.language.record import TYPE_CHECKING
from verify.prover.balls import fraction_of
from verify.prover.proof import Proof
from verify.prover.search.domain import Domain, Factor
from verify.prover.search.question import Question

if TYPE_CHECKING:
    from verify.prover.search.squares import Summand


def by_completing_squares(question: Question) -> Proof | None:
    """A proof where rhs - lhs is quadratic, and not negative whatever its variables are.

    The definitions of constants take their places, so the checker has to be able to clear them.
    """
    domain = Domain(question.goal, {}, None, question.is_negative)
    if not domain.is_plain or domain.p.total_degree() != 2 or not question.clears():
        return None
    question.budget.spend(len(domain.used) * len(domain.p))
    squares = completed(domain)
    if squares is None:
        return None
    from verify.prover.search.positive import Attempt, written  # loaded only where they are used

    attempt = Attempt([Factor(domain.number(1), "1", True, ())], [])
    proof = written(domain, attempt, squares, None)
    return None if proof is None else proof._replace(using=question.using)


def completed(domain: Domain) -> list[Summand] | None:
    """Squares that add up to the quadratic p; None if p is negative somewhere.

    With d > 0 in front of x^2, p is d (p'/(2 d))^2 plus what is free of x, for p' the derivative.
    """
    from verify.prover.search.squares import Summand  # loaded only where it is used

    found, rest = [], domain.p
    for i in domain.used:
        slope = rest.derivative(i)
        twice = _constant(slope.derivative(i))
        if twice > 0:
            square = slope * domain.number(1 / twice)
            found.append(Summand(twice / 2, 0, square))
            rest -= domain.number(twice / 2) * square**2
        elif not slope.is_zero():
            return None
    last = _constant(rest)
    if last > 0:
        found.append(Summand(last, 0, domain.number(1)))
    return found if last >= 0 else None


def _constant(polynomial: fmpq_mpoly) -> Fraction:
    return Fraction(0) if polynomial.is_zero() else fraction_of(polynomial.leading_coefficient())
