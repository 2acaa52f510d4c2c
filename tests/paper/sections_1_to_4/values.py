"""Terms and claims at rational values, evaluated here and not by the program."""

from __future__ import annotations

from collections.abc import Mapping
from fractions import Fraction
from math import prod

from verify.language.statement import Context
from verify.language.terms import Claim, Term, as_term


def value(term: Term, at: Mapping[str, Term]) -> Fraction:
    """A term without a root at rational values."""
    if term.op == "rational":
        return Fraction(term.args[0])
    if term.op == "symbol":
        return value(at[term.args[0]], {})
    parts = [value(arg, at) for arg in term.args if isinstance(arg, Term)]
    exponent = next((arg for arg in term.args if isinstance(arg, int)), 1)
    return {
        "add": lambda: sum(parts, Fraction(0)),
        "sub": lambda: parts[0] - parts[1],
        "neg": lambda: -parts[0],
        "mul": lambda: prod(parts, start=Fraction(1)),
        "div": lambda: parts[0] / parts[1],
        "pow": lambda: parts[0] ** exponent,
    }[term.op]()


def holds(claim: Claim, at: Mapping[str, Term]) -> bool:
    """Whether a claim is true at rational values."""
    left, right = value(claim.lhs, at), value(claim.rhs, at)
    return {"<": left < right, "<=": left <= right, "=": left == right}[claim.relation]


def with_constants(context: Context, at: Mapping[str, Term]) -> dict[str, Term]:
    """The values with those of the constants of a context."""
    found = dict(at)
    for constant in context.constants:
        found[constant.name] = as_term(value(constant.term, found))
    return found
