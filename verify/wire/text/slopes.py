"""The derivative of a term by a variable, with a value just where the term has one near by."""

from __future__ import annotations

from collections.abc import Mapping, Sequence

from verify.language.terms import Term, names_of, parts_of
from verify.prover.search.derivatives import derivative
from verify.prover.session import ZERO
from verify.wire.text.matrices import has_value, times_zero


def slope(arguments: Sequence[Term], are_variables: Mapping[str, bool]) -> Term:
    """The derivative of the one argument by the other, a variable; other variables stay.

    Raises:
        ValueError: if it is not by a variable, or the term has no derivative that is known.
    """
    if len(arguments) != 2:
        raise ValueError(f"a derivative is of a term by a variable, not of {len(arguments)}")
    term, x = arguments
    if x.op != "symbol" or not are_variables.get(x.name):
        raise ValueError("a derivative is by a variable")
    for name in names_of(term):
        if name not in are_variables:
            raise ValueError(f"{name} may depend on {x.name}: use its formula")
    found = derivative(term, x.name) if x in parts_of(term) else ZERO
    if found is None:
        raise ValueError("a minimum, a maximum or a modulus has corners: use its parts")
    for part in _lost(term, found):
        found = found + times_zero(part)
    return found


def _lost(term: Term, found: Term) -> list[Term]:
    """What has no value somewhere in a term, and is not in its derivative."""
    parts = {*parts_of(found)}
    divisors = {part.children[1] for part in parts if part.op == "div"}
    return [
        part
        for part in parts_of(term)
        if part.op in ("div", "sqrt", "root", "log")
        and part not in parts
        and not (part.op == "div" and divisors & {part.children[1], part.children[1] ** 2})
        and not has_value(part)
    ]
