"""The root of a term between two numbers, as a context of a statement.

No term stands for such a number, so that the statement says what is proved of it: rows that the
term has different signs at two numbers, 1e-12 apart, and that it rises (or falls) between the two
numbers that were given. By the intermediate value theorem there is a root between the former, and
it is the only one between the latter. What is asked in the context is proved of *all* numbers
between the former, and so of the root; an equation that holds for the root alone is not provable.
"""

from __future__ import annotations

import math
from collections.abc import Mapping, Sequence
from fractions import Fraction

from verify.language.record import Record
from verify.language.statement import NEEDED, Constant, Context, Given, Obligation, Variable
from verify.language.terms import Claim, Term, as_term, names_of, substitute, symbol
from verify.prover import balls
from verify.prover.program import Machine, Program
from verify.prover.search.derivatives import derivative
from verify.wire.inputs import InputError, shown

#: The ends between which a root is named have so many decimals.
DIGITS = 12
#: The numbers beside a root are not larger, so that few steps lead to it.
LARGEST = 10**300
#: Bits of the balls that tell a sign, one after another.
PRECISIONS = (64, 256, 1024, 4096, 2**14)
_SIGNS = {-1: "negative", 0: "0, or of no sign that is known", 1: "positive"}


class Isolated(Record):
    """The context of a root, the one of its whole range, and the rows that show that it exists."""

    context: Context
    range: Context
    rows: tuple[Obligation, ...]


def about(
    term: Term, constants: Sequence[Constant], floats: Mapping[str, float]
) -> dict[str, Term]:
    """What the names in a term stand for, over earlier ones, or a number near it."""
    needed, found = {*names_of(term)}, dict[str, Term]()
    for constant in reversed(constants):
        if constant.name in needed:
            found[constant.name] = constant.term
            needed |= {*names_of(constant.term)}
    near = {name: floats.get(name, math.nan) for name in sorted(needed - found.keys())}
    exact = dict(reversed(found.items()))
    return {name: as_term(Fraction(x)) for name, x in near.items() if math.isfinite(x)} | exact


def isolated(
    name: str,
    variables: tuple[Variable, Variable],
    term: Term,
    between: tuple[Fraction, Fraction],
    known: Mapping[str, Term],
) -> Isolated:
    """What a statement needs for a root.

    Args:
        name: of the context.
        variables: that of the context, over which the term is, and one for the whole range.
        term: is 0 at the root.
        between: the numbers between which it is the only root.
        known: what other names in the term stand for, or about that, over earlier names.

    Raises:
        InputError: if the term does not change its sign, or has no derivative.
    """
    (variable, other), (low, high) = variables, between
    x = variable.name
    slope = derivative(term, x) if x in names_of(term) else None
    if slope is None:
        raise InputError(f"{shown(name)}: the term has no derivative by {shown(x)}; write another")
    left, right, rising = _narrow(name, term, x, between, known)
    whole = symbol(other.name)
    slope = substitute(slope, {x: whole})
    sides = (as_term(0), slope) if rising else (slope, as_term(0))
    claims = {
        "begins": _sign(substitute(term, {x: as_term(left)}), positive=not rising),
        "ends": _sign(substitute(term, {x: as_term(right)}), positive=rising),
        "rises" if rising else "falls": Claim("<", *sides),
    }
    only = [*claims][2]
    says = {
        "begins": f"so that with {name}.ends there is a root, by the intermediate value theorem",
        "ends": f"at the other end, as {name}.begins says of the one",
        only: f"so that the root is the only one from {low} to {high}",
    }
    rows = tuple(
        Obligation(
            f"{name}.{key}",
            "",
            "",
            NEEDED,
            says[key],
            claim,
            context=f"{name}.range" if key == only else None,
        )
        for key, claim in claims.items()
    )
    told = (
        f"the root of the rows {name}.begins to {name}.{only}, and every other number as near to it"
    )
    return Isolated(
        _context(name, variable, (left, right), told),
        _context(f"{name}.range", other, between, ""),
        rows,
    )


def _context(name: str, variable: Variable, ends: tuple[Fraction, Fraction], says: str) -> Context:
    low, high, x = as_term(ends[0]), as_term(ends[1]), symbol(variable.name)
    givens = Given(f"{name}.1", Claim("<=", low, x)), Given(f"{name}.2", Claim("<=", x, high))
    return Context(name, (variable,), givens, {variable.name: low}, None, says, ())


def _sign(term: Term, *, positive: bool) -> Claim:
    return Claim("<", as_term(0), term) if positive else Claim("<", term, as_term(0))


def _narrow(
    name: str, term: Term, x: str, between: tuple[Fraction, Fraction], known: Mapping[str, Term]
) -> tuple[Fraction, Fraction, bool]:
    """Ends with few decimals around a change of sign, and whether the term rises there.

    The rows say that it is so.
    """
    low, high = between
    if max(abs(low), abs(high)) > LARGEST:
        raise InputError(f"{shown(name)}: the numbers beside it are too large; write others")
    signs = _Signs(term, x, known)
    first, last = map(signs.at, between)
    if not low < high or first * last >= 0:
        told = [_SIGNS[sign] for sign in (first, last)]
        raise InputError(
            f"{shown(name)}: the term does not change its sign from {low} to {high}, where it is "
            f"{told[0]} and {told[1]}; write numbers between which its root lies"
        )
    unit = Fraction(1, 10**DIGITS)
    while high - low > unit / 4:
        middle = (low + high) / 2
        sign = signs.at(middle)
        low, high = (middle, high if sign else middle) if sign != last else (low, middle)
    near = round((low + high) / 2 / unit) * unit
    return max(between[0], near - unit), min(between[1], near + unit), first < 0


class _Signs:
    """The signs of a term at numbers: 0 where it is 0, has no value, or balls do not tell."""

    def __init__(self, term: Term, x: str, known: Mapping[str, Term]) -> None:
        self._term, program = term, Program([x])
        for name, value in known.items():
            if all(part in program.slots for part in names_of(value)):
                program.define(name, value)
        is_known = all(part in program.slots for part in names_of(term))
        self._machines = {
            bits: Machine(program, balls.BallArithmetic()) for bits in PRECISIONS if is_known
        }

    def at(self, number: Fraction) -> int:
        """The sign there."""
        for bits, machine in self._machines.items():
            with balls.precision(bits):
                value = machine.run([balls.from_fraction(number)])[self._term]
                sign = 0 if value is None else balls.strict_sign(value)
            if sign or value is None:
                return sign
        return 0
