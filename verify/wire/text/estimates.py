"""Values at a point: about, in floats; and exactly, where all numbers on the way are rational."""

from __future__ import annotations

import math
from collections.abc import Callable, Mapping
from fractions import Fraction
from functools import lru_cache
from typing import Any

from verify.language.fold import BOUNDED, MissingOperationError, fold, holds
from verify.language.terms import Claim, Term, names_of, substitute_claim, symbol

#: The exponential of this is beyond all floats.
MOST_EXPONENT = 709.0
#: Two numbers that are as near as this are taken for equal.
NEAR = 1e-9
#: Bits of what is enclosed where floats do not suffice.
BITS = 2048


def _float(number: Fraction) -> float:
    try:
        return float(number)
    except OverflowError:
        return math.inf if number > 0 else -math.inf


def _power(x: float, exponent: int) -> float:
    try:
        return x**exponent
    except OverflowError:
        return -math.inf if x < 0 and exponent % 2 else math.inf


_ALGEBRA: Mapping[str, Callable[..., float]] = {
    **{name: getattr(math, name) for name in ("sqrt", "log", "sin", "cos", "atan")},
    "exp": lambda x: math.inf if x >= MOST_EXPONENT else math.exp(x),
    "pi": lambda: math.pi,
    "rational": _float,
    "cos_pi": lambda x: math.cos(math.pi * x),
    "min": min,
    "max": max,
    "add": lambda x, y: x + y,
    "sub": lambda x, y: x - y,
    "mul": lambda x, y: x * y,
    "div": lambda x, y: x / y,
    "neg": lambda x: -x,
    "pow": _power,
    "root": lambda x, index: x ** (1 / index) if x >= 0 else math.nan,
}


def estimate(term: Term, values: Mapping[str, float]) -> float:
    """About the value of a term; NaN where it has none, or where a name in it has none."""
    found: list[float] = []
    try:
        if not term.children and term.op == "rational":
            return _float(term.value)
        for function, places, rest in _steps(term):
            if function is None:
                found.append(values.get(rest[0], math.nan))
            else:
                found.append(function(*[found[i] for i in places], *rest))
    except (ArithmeticError, ValueError):
        return math.nan
    return found[-1]


#: A function of the values in some places and of other arguments; without one, a name.
Step = tuple[Callable[..., float] | None, tuple[int, ...], tuple[Any, ...]]


@lru_cache(maxsize=4096)
def _steps(term: Term) -> list[Step]:
    """How a value is computed, one part after another; a loop is faster than a recursion here."""
    steps: list[Step] = []
    places: dict[Term, int] = {}
    waiting = [term]
    while waiting:
        part = waiting[-1]
        missing = [child for child in part.children if child not in places]
        waiting += missing
        if missing or waiting.pop() in places:
            continue
        places[part] = len(steps)
        function = None if part.op == "symbol" else _ALGEBRA.get(part.op, _unknown)
        at = tuple(places[child] for child in part.children)
        steps.append((function, at, part.args[len(at) :]))
    return steps


def _unknown(*_: object) -> float:
    raise ArithmeticError


def seems(claim: Claim, at: Mapping[str, float], point: Mapping[str, Term]) -> bool:
    """Whether a claim holds as far as floats tell; next to equality exactly, if that can be."""
    left, right = estimate(claim.lhs, at), estimate(claim.rhs, at)
    near = NEAR * (1 + abs(left))
    if abs(left - right) > near:
        return claim.relation != "=" and left < right
    sides = exactly(claim, point)
    if sides is None and math.inf in (abs(left), abs(right)):
        return _holds_far_out(substitute_claim(claim, point))
    if sides is None:
        return claim.relation != "<" and abs(left - right) <= near
    return holds(claim.relation, *sides)


def _holds_far_out(claim: Claim) -> bool:
    """Whether a claim without names holds, as its enclosures tell."""
    from verify.prover.ground import Ground  # loaded only where it is used
    from verify.prover.session import Session

    if claim.lhs is claim.rhs:
        return claim.relation != "<"
    has_names = any(names_of(claim.lhs, claim.rhs))
    return not has_names and Ground(Session()).holds_at(claim, BITS)


def exactly(claim: Claim, point: Mapping[str, Term]) -> list[Fraction] | None:
    """The sides at a point, if all numbers on the way are rational and not long."""
    numbers = {
        symbol(n): point[n].value
        for n in names_of(claim.lhs, claim.rhs)
        if n in point and point[n].op == "rational"
    }
    try:
        return [fold(side, BOUNDED, numbers) for side in (claim.lhs, claim.rhs)]
    except (ArithmeticError, MissingOperationError, RecursionError):
        return None


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
