"""Intervals just as the checker computes them, for the leaves that floats leave open."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from fractions import Fraction

from verify import check
from verify.language.terms import Term


class ExactRanges:
    """The checker's intervals of terms, at its precision, for ends of variables."""

    def __init__(self, names: Sequence[str], definitions: Mapping[str, Term], bits: int) -> None:
        kernel = check.Kernel()
        kernel.work = 1 << 62
        self._scope = check.Enclosing(kernel, bits, None)
        self._names, self._definitions = tuple(names), definitions

    def of(
        self, ends: Sequence[tuple[Fraction, Fraction]], *terms: Term
    ) -> list[check.Interval] | None:
        """The intervals of terms; None where the checker would refuse one."""
        known = {
            name: check.Interval(low, high)
            for name, (low, high) in zip(self._names, ends, strict=True)
        }
        done: dict[Term, check.Interval] = {}
        try:
            return [self._value(term, known, done) for term in terms]
        except (check.Refused, check.Malformed):
            return None

    def _value(
        self, term: Term, known: dict[str, check.Interval], done: dict[Term, check.Interval]
    ) -> check.Interval:
        if term.op == "symbol":
            if term.name not in known:
                known[term.name] = self._value(self._definitions[term.name], known, done)
            return known[term.name]
        if term not in done:
            children = [self._value(child, known, done) for child in term.children]
            rest: tuple[int, ...] = (term.exponent,) if term.op == "pow" else ()
            if term.op == "rational":
                rest = term.value.numerator, term.value.denominator
            result = check.OPERATIONS[term.op](self._scope, *children, *rest)
            done[term] = self._scope.outward(result)
        return done[term]
