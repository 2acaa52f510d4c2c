"""What terms and relations mean: the value of a term in an algebra, and when a relation holds.

Nothing else takes a term apart by its operation, or gives `<`, `<=` and `=` a meaning.
"""

from __future__ import annotations

from collections.abc import Callable, Mapping
from fractions import Fraction
from functools import partial
from operator import le, lt

from verify.language.record import Any, Record, TypeVar
from verify.language.terms import OPERATIONS, Claim, Term

Value = TypeVar("Value")


class MissingOperationError(LookupError):
    """An algebra does not have an operation of a term."""


def fold(
    term: Term, algebra: Mapping[str, Callable[..., Value]], known: dict[Term, Value]
) -> Value:
    """The value of a term, by a function for each of its operations.

    A function gets the values of the subterms; that of ``rational`` gets the number, that of
    ``symbol`` the name, that of ``pow`` the exponent after the value, and that of ``root`` the
    index. ``known`` has the values of parts that are known, and keeps those that are computed.

    Raises:
        MissingOperationError: for an operation that the algebra does not have.
    """
    if term in known:
        return known[term]
    function = algebra.get(term.op)
    if function is None:
        raise MissingOperationError(f"there is no {term.op} among {', '.join(sorted(algebra))}")
    children = term.children
    values = [fold(child, algebra, known) for child in children]
    found = known[term] = function(*values, *term.args[len(children) :])
    return found


#: The algebra of terms: each is put together again.
TERMS: Mapping[str, Callable[..., Term]] = {op: partial(Term, op) for op in OPERATIONS}


def replaced(term: Term, chosen: Mapping[Term, Term]) -> Term:
    """The term with some of its parts replaced, all at once."""
    return fold(term, TERMS, dict(chosen))


#: The operations on rational numbers whose results are rational.
RATIONAL: Mapping[str, Callable[..., Fraction]] = {
    "rational": lambda number: number,
    "add": lambda x, z: x + z,
    "sub": lambda x, z: x - z,
    "mul": lambda x, z: x * z,
    "div": lambda x, z: x / z,
    "neg": lambda x: -x,
    "pow": lambda x, exponent: x**exponent,
}


#: The longest numbers, in bits, of `BOUNDED`.
MAX_BITS = 10_000


def bits_of(number: Fraction) -> int:
    """About how long the longer part of a number is."""
    return max(number.numerator.bit_length(), number.denominator.bit_length())


def _bounded(op: str, function: Callable[..., Fraction]) -> Callable[..., Fraction]:
    def found(*values: Fraction) -> Fraction:
        if op == "pow" and bits_of(values[0]) * values[1] > 2 * MAX_BITS:
            raise OverflowError(f"a power has more than {MAX_BITS} bits")
        number = function(*values)
        if bits_of(number) > MAX_BITS:
            raise OverflowError(f"a number has more than {MAX_BITS} bits")
        return number

    return found


#: The same, where longer numbers are an OverflowError: a short term may be a number of any length.
BOUNDED = {op: _bounded(op, function) for op, function in RATIONAL.items()}


#: What a claim comes to, in compiled code: the claim is certified, its negation is, or neither.
HOLDS, FAILS, OPEN = 1, 2, 0


class Meaning(Record):
    """When a relation holds, and when it fails, between two values of an ordered type.

    Each is true only if it is so for all numbers of both values, so that balls can be compared.
    """

    holds: Callable[[Any, Any], bool]
    fails: Callable[[Any, Any], bool]


def _equal(x: Any, y: Any) -> bool:
    return bool(x <= y) and bool(y <= x)


def _different(x: Any, y: Any) -> bool:
    return bool(x < y) or bool(y < x)


MEANINGS = {
    "<": Meaning(lt, lambda x, y: y <= x),
    "<=": Meaning(le, lambda x, y: y < x),
    "=": Meaning(_equal, _different),
}


def holds(relation: str, x: Any, y: Any) -> bool:
    """True only if the relation holds between all numbers of x and y.

    Raises:
        KeyError: for an unknown relation.
    """
    return bool(MEANINGS[relation].holds(x, y))


def fails(relation: str, x: Any, y: Any) -> bool:
    """True only if the relation fails between all numbers of x and y.

    Raises:
        KeyError: for an unknown relation.
    """
    return bool(MEANINGS[relation].fails(x, y))


def negation(claim: Claim) -> Claim | None:
    """The claim that holds where this one fails, unless that takes two claims."""
    swapped = {"<": "<=", "<=": "<"}
    if claim.relation not in swapped:
        return None
    return Claim(swapped[claim.relation], claim.rhs, claim.lhs)
