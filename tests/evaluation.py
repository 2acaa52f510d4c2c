"""The value of a term of the four operations, powers and square roots, as the tests compute it."""

from __future__ import annotations

import operator
from collections.abc import Callable, Mapping
from fractions import Fraction
from typing import Any

from verify.language.terms import Term

OPERATIONS: Mapping[str, Callable[..., Any]] = {
    "add": operator.add,
    "sub": operator.sub,
    "mul": operator.mul,
    "div": operator.truediv,
    "neg": operator.neg,
    "sqrt": lambda x: x.sqrt(),
}


def value(term: Term, at: Mapping[str, Any], number: Callable[[Fraction], Any] = Fraction) -> Any:
    """The value of a term where symbols have these values, and ``number`` makes one of a rational.

    Raises:
        KeyError: for another operation, or a symbol without a value.
    """
    if term.op == "rational":
        return number(term.value)
    if term.op == "symbol":
        return at[term.name]
    parts = [value(child, at, number) for child in term.children]
    return parts[0] ** term.exponent if term.op == "pow" else OPERATIONS[term.op](*parts)
