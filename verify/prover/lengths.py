"""Numbers that are too long for the checker, which reads terms only up to a length."""

from __future__ import annotations

from collections.abc import Callable, Iterable, Mapping
from fractions import Fraction
from math import log2

from verify.language.fold import fold
from verify.language.terms import OPERATIONS, Term, names_of, parts_of
from verify.prover.goal import definitions_below

#: The checker reads numbers of at most so many bits.
MAX_BITS = 2**19

#: The sign of a number and the logarithm of its absolute value; None where that is not seen.
Size = tuple[int, float] | None


class Lengths:
    """About how long numbers in terms are, where names have definitions; each is looked at once."""

    def __init__(self) -> None:
        self._named: dict[str, Size] = {}
        self._algebra: dict[str, Callable[..., Size]] = {
            **dict.fromkeys(OPERATIONS, lambda *_: None),
            **_OPERATIONS,
            "symbol": self._named.get,
        }

    def is_too_long(self, terms: Iterable[Term], definitions: Mapping[str, Term]) -> bool:
        """Whether a number in them is so large, or so near to 0, that nobody can write it down."""
        every, known = [*terms], dict[Term, Size]()
        new = {name: term for name, term in definitions.items() if name not in self._named}
        for name, term in definitions_below(names_of(*every), new).items() if new else ():
            self._named[name] = fold(term, self._algebra, {})
        sizes = (fold(part, self._algebra, known) for part in parts_of(*every))
        return any(size is not None and abs(size[1]) > MAX_BITS for size in sizes)


def _rational(value: Fraction) -> Size:
    if not value:
        return None
    top, bottom = abs(value.numerator), value.denominator
    return (1 if value > 0 else -1), log2(top) - log2(bottom)


def _sum(a: Size, b: Size) -> Size:
    return (a[0], max(a[1], b[1])) if a and b and a[0] == b[0] else None


def _product(a: Size, b: Size) -> Size:
    return (a[0] * b[0], a[1] + b[1]) if a and b else None


def _negative(a: Size) -> Size:
    return (-a[0], a[1]) if a else None


_OPERATIONS: Mapping[str, Callable[..., Size]] = {
    "rational": _rational,
    "add": _sum,
    "sub": lambda a, b: _sum(a, _negative(b)),
    "neg": _negative,
    "mul": _product,
    "div": lambda a, b: _product(a, (b[0], -b[1]) if b else None),
    "pow": lambda a, k: (a[0] ** k, a[1] * k) if a else None,
}
