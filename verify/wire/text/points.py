"""A guess of a point at which the givens of a context hold, where an author writes none.

Floating-point numbers only choose between exact candidates: the checker decides whether the givens
hold at the one that is chosen.
"""

from __future__ import annotations

import math
from collections import defaultdict
from collections.abc import Callable, Collection, Iterator, Mapping, Sequence
from fractions import Fraction

from verify.language.fold import BOUNDED, MissingOperationError, fold
from verify.language.fold import holds as fold_holds
from verify.language.statement import Given
from verify.language.terms import (
    Claim,
    Term,
    as_term,
    names_of,
    parts_of,
    substitute,
    symbol,
)
from verify.prover.budget import WorkBudget

#: How many candidates are looked at one variable after another.
MOST = 2_000
#: Parts of givens that are looked at, for one context and for all of a file.
WORK, WORK_OF_FILE = 10_000_000, 15_000_000
#: So many of them take a microsecond; and so many microseconds a linear programme may take.
UNITS, PROGRAMME = 5, 300_000
#: Fractions with larger denominators come near solutions of equations by accident.
SIMPLE = 100
#: Numbers between solutions are tried for so many variables, the first ones.
FEW = 12
#: The exponential of this is beyond all floats.
MOST_EXPONENT = 709.0
#: Two numbers that are as near as this are taken for equal.
NEAR = 1e-9

_SIMPLE = tuple(map(Fraction, ("1", "0", "1/2", "2", "-1", "-1/2", "1/10", "3", "10", "-2", "100")))
_ALGEBRA: Mapping[str, Callable[..., float]] = {
    **{name: getattr(math, name) for name in ("sqrt", "log", "sin", "cos", "atan")},
    "exp": lambda x: math.exp(x) if x < MOST_EXPONENT else math.inf,
    "pi": lambda: math.pi,
    "cos_pi": lambda x: math.cos(math.pi * x),
    "min": min,
    "max": max,
    "rational": float,
    "add": lambda x, y: x + y,
    "sub": lambda x, y: x - y,
    "mul": lambda x, y: x * y,
    "div": lambda x, y: x / y,
    "neg": lambda x: -x,
    "pow": lambda x, exponent: x**exponent,
    "root": lambda x, index: x ** (1 / index) if x >= 0 else math.nan,
}


def estimate(term: Term, values: Mapping[str, float]) -> float:
    """About the value of a term; NaN where it has none, or where a name in it has none."""

    def named(name: str) -> float:
        return values.get(name, math.nan)

    try:
        return fold(term, {**_ALGEBRA, "symbol": named}, {})
    except (ArithmeticError, ValueError, MissingOperationError, RecursionError):
        return math.nan


class Points:
    """The search for the points of one file, which looks at so much in all."""

    def __init__(self, seconds: float | None = None) -> None:
        """Half of some seconds may go into the search, as far as its work is counted."""
        parts = math.inf if seconds is None else 500_000 * UNITS * seconds
        self.left, self._is_short = int(min(WORK_OF_FILE, parts)), parts < WORK_OF_FILE

    @property
    def in_time(self) -> str:
        """What to write first, where the time has ended the search."""
        is_over = self._is_short and self.left < UNITS
        return "a longer --time, or " if is_over else ""

    def find(
        self,
        variables: Sequence[str],
        givens: Sequence[Given],
        values: Mapping[str, float],
        around: Collection[str] = (),
    ) -> dict[str, Term] | None:
        """Terms for the variables at which the givens seem to hold; None if none were found.

        ``values`` has about what the other names stand for, those that vary ``around`` at one
        point.
        """
        if self.left <= 0:
            return None
        claims = [given.claim for given in givens]
        left = [min(WORK, self.left)]
        self.left -= left[0]
        found = _one_by_one(variables, claims, values, around, left)
        self.left += max(left[0], 0)
        if found is None:
            budget = WorkBudget(min(PROGRAMME, self.left // UNITS))
            found = _in_the_middle(variables, claims, values, budget)
            self.left -= UNITS * (budget.work - budget.left)
        return found


def contradiction(variables: Sequence[str], givens: Sequence[Given]) -> str:
    """A sum of linear givens that cannot hold, in words; nothing if none was found."""
    from verify.prover.search.interior import contradiction_of  # only where it is needed

    found = contradiction_of(variables, [given.claim for given in givens])
    return "" if found is None else found.words


def _in_the_middle(
    variables: Sequence[str],
    claims: Sequence[Claim],
    values: Mapping[str, float],
    budget: WorkBudget,
) -> dict[str, Term] | None:
    """Numbers for the variables, by a linear programme and near the places that violate least."""
    from verify.prover.search.interior import interior  # only where it is needed

    def holds(point: Sequence[Fraction]) -> bool:
        exact = dict(zip(variables, map(as_term, point), strict=True))
        at = dict(values) | dict(zip(variables, map(float, point), strict=True))
        return all(_seems(claim, at, exact) and _may_hold(claim, exact) for claim in claims)

    found = interior(variables, claims, values, holds, budget)
    return None if found is None else dict(zip(variables, map(as_term, found), strict=True))


def _one_by_one(
    variables: Sequence[str],
    claims: Sequence[Claim],
    values: Mapping[str, float],
    around: Collection[str],
    left: list[int],
) -> dict[str, Term] | None:
    """Terms for the variables, each chosen after those before it, while there is work ``left``."""
    tried = iter(range(MOST))

    def complete(found: dict[str, Term], at: dict[str, float]) -> dict[str, Term] | None:
        if len(found) == len(variables):
            return found
        name = variables[len(found)]
        ready = complete_at[len(found)]
        left[0] -= sum(parts.values())
        before = dict(found)
        for term in _candidates(name, claims, ready, before, at, around):
            left[0] -= len(at) + sum(parts[claim] for claim in ready)
            if next(tried, None) is None or left[0] < 0:
                return None
            there = at | {name: estimate(term, at)}
            found[name] = term
            if all(_seems(claim, there, found) for claim in ready):
                result = complete(dict(found), there)
                if result is not None:
                    return result
        return None

    places = {name: i for i, name in enumerate(variables)}
    complete_at: dict[int, list[Claim]] = defaultdict(list)  # by the last variable of a claim
    for claim in claims:
        found = (places.get(name, 0) for name in names_of(claim.lhs, claim.rhs))
        complete_at[max(found, default=0)].append(claim)
    parts = {claim: sum(1 for _ in parts_of(claim.lhs, claim.rhs)) for claim in claims}
    try:
        return complete({}, dict(values))
    except RecursionError:
        return None


def _seems(claim: Claim, at: Mapping[str, float], point: Mapping[str, Term]) -> bool:
    """Whether a claim holds as far as floats tell; next to equality exactly, if that can be."""
    left, right = estimate(claim.lhs, at), estimate(claim.rhs, at)
    near = NEAR * (1 + abs(left))
    if abs(left - right) > near:
        return claim.relation != "=" and left < right
    try:
        sides = [_exactly(side, point) for side in (claim.lhs, claim.rhs)]
    except (ArithmeticError, MissingOperationError, RecursionError):
        return claim.relation != "<" and abs(left - right) <= near
    return fold_holds(claim.relation, *sides)


def _exactly(term: Term, point: Mapping[str, Term]) -> Fraction:
    """The value at a point, where all numbers on the way are rational and not long."""
    numbers = {
        symbol(n): point[n].value
        for n in names_of(term)
        if n in point and point[n].op == "rational"
    }
    return fold(term, BOUNDED, numbers)


def _may_hold(claim: Claim, at: Mapping[str, Term]) -> bool:
    """False for an equation between different numbers, or that long numbers only seem to solve."""
    if claim.relation != "=":
        return True
    try:
        left, right = (_exactly(side, at) for side in (claim.lhs, claim.rhs))
    except (ArithmeticError, MissingOperationError):
        return all(x.value.denominator <= SIMPLE for x in at.values())
    return bool(left == right)


def _candidates(
    name: str,
    claims: Sequence[Claim],
    ready: Sequence[Claim],
    found: Mapping[str, Term],
    at: Mapping[str, float],
    around: Collection[str],
) -> Iterator[Term]:
    """Between the bounds of a variable, then the bounds themselves, then simple numbers."""
    lows, highs = _bounds(name, claims, found, at)
    low = max(lows, key=lambda pair: pair[0], default=None)
    high = min(highs, key=lambda pair: pair[0], default=None)
    ends = [end[1] for end in (low, high) if end]
    moves = not {*around}.isdisjoint(names_of(*ends))
    if low and high and low[0] < high[0]:
        middle = (low[1] + high[1]) / 2
        yield middle if moves else as_term(simplest(low[0], high[0]))
    elif low:
        yield low[1] + 1 if moves else as_term(math.floor(low[0]) + 1)
    elif high:
        yield high[1] - 1 if moves else as_term(math.ceil(high[0]) - 1)
    yield from ends
    from verify.wire.text.solutions import between, solutions  # loaded only where they are used

    for claim in claims:
        if claim.relation == "=":
            yield from solutions(name, claim, found)
    yield from map(as_term, _SIMPLE)
    if len(found) < FEW:
        yield from between(name, ready, found)


Bound = tuple[float, Term]


def _bounds(
    name: str, claims: Sequence[Claim], found: Mapping[str, Term], at: Mapping[str, float]
) -> tuple[list[Bound], list[Bound]]:
    """The terms that are below and above a variable, with about their values."""
    lows: list[Bound] = []
    highs: list[Bound] = []
    others = {key: x for key, x in at.items() if key != name}
    for claim in claims:
        for side, other, bounds in (
            (claim.lhs, claim.rhs, [highs]),
            (claim.rhs, claim.lhs, [lows]),
        ):
            if side.op != "symbol" or side.name != name:
                continue
            value = estimate(other, others)
            if math.isfinite(value):
                for one in bounds if claim.relation != "=" else (lows, highs):
                    one.append((value, substitute(other, found)))
    return lows, highs


def simplest(low: float, high: float) -> Fraction:
    """A rational number with a small denominator well between two numbers."""
    middle, width = (low + high) / 2, high - low
    if not math.isfinite(middle) or width <= 0:
        return Fraction(0)
    for digits in range(1, 60):
        found = Fraction(middle).limit_denominator(2**digits)
        if abs(found - Fraction(middle)) < width / 4:
            return found
    return Fraction(middle)
