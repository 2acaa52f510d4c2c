"""Numbers at which the derivative of a difference is 0, as terms: log 3 for x - exp(x)/3."""

from __future__ import annotations

from collections.abc import Callable, Iterator, Mapping

from verify.language.terms import Claim, Term, as_term, exp, log, names_of, sqrt, tan
from verify.prover.clearing import Clearing, TooLongError, coefficients
from verify.prover.search.compiled import estimates
from verify.prover.search.derivatives import derivative

#: What a function is of, by its value.
INVERSES: Mapping[str, Callable[[Term], Term]] = {
    "exp": log,
    "log": exp,
    "atan": tan,
    "sqrt": lambda value: value**2,
}
#: Two numbers that are as near as this are taken for equal, and functions inside one another.
NEAR, MAX_DEPTH = 1e-6, 3


def stationary(claim: Claim, name: str, near: float) -> Term | None:
    """A number near by where the sides of a claim about one variable rise equally."""
    slope = derivative(claim.rhs - claim.lhs, name)
    for number in () if slope is None else _zeros(slope, name, MAX_DEPTH):
        try:
            value = estimates([], [number], {})()[0]
        except (ArithmeticError, ValueError, TypeError):
            continue
        if isinstance(value, float) and abs(value - near) <= NEAR * (1 + abs(near)):
            return number
    return None


def _zeros(term: Term, name: str, depth: int) -> Iterator[Term]:
    """Numbers at which a term may be 0: factors in which one function varies are solved for it."""
    try:
        clearing = Clearing((term,), {})
        factors = clearing.clear(term)[0].factor()[1]
    except TooLongError:
        return
    for factor, _ in factors:
        used = (a for a, d in zip(clearing.atoms, factor.degrees(), strict=True) if d > 0)
        moving = [atom for atom in used if name in names_of(atom)]
        if len(moving) != 1:
            continue
        (atom,) = moving
        parts = {
            power: clearing.term(part)
            for power, part in coefficients(factor, clearing.atoms.index(atom)).items()
        }
        for value in _roots(parts):
            if atom.op == "symbol":
                yield value
            elif atom.op in INVERSES and depth:
                inner = atom.children[0] - INVERSES[atom.op](value)
                yield from _zeros(inner, name, depth - 1)


def _roots(parts: Mapping[int, Term]) -> Iterator[Term]:
    """The roots of a polynomial of degree 1 or 2."""
    a, b, c = (parts.get(power, as_term(0)) for power in (2, 1, 0))
    if max(parts) == 1:
        yield _over(-c, b)
    elif max(parts) == 2:
        root = sqrt(b**2 - 4 * a * c)
        yield from ((-b + root) / (2 * a), (-b - root) / (2 * a))


def _over(above: Term, below: Term) -> Term:
    """A quotient, written out: of polynomials without a divisor, if there is none."""
    clearing = Clearing((above, below), {})
    (p, _), (q, _) = clearing.clear(above), clearing.clear(below)
    return clearing.term(p / q.leading_coefficient()) if q.is_constant() else above / below
