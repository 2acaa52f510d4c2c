"""Terms and claims as JSON values, and back; repeated subterms get names."""

from __future__ import annotations

import re
from collections import Counter
from collections.abc import Callable, Iterable, Mapping
from fractions import Fraction
from typing import Any

from verify.language.statement import Always, Applies
from verify.language.terms import (
    INDEXED,
    OPERATIONS,
    Claim,
    Term,
    as_term,
    nth_root,
    operations_in,
    symbol,
)

#: The operations that are written as lists.
WRITTEN = tuple(op for op in OPERATIONS if op not in ("rational", "symbol"))

#: A repeated subterm gets a name from this number of operations on.
SHARED_SIZE = 6


class WireError(ValueError):
    """A document that does not have the described form."""


class _Parts:
    """What is in the fields of proofs, which is read as it is written: leaf by leaf."""

    #: What becomes of a rational, and of an exponent.
    number: Callable[[Any], Any]
    exponent: Callable[[Any], Any]
    term: Callable[[Any], Any]
    claim: Callable[[Any], Any]

    def leaf(self, proof: Callable[[Any, Any], Any], name: str, item: Any) -> Any:
        """What a leaf of this name becomes; ``proof`` says what a proof does."""
        match name:
            case "term" | "claim" | "value" | "number":
                return getattr(self, name)(item)
            case "proof" | "premise" if not isinstance(item, str):
                return proof(item, self)
        return item

    def value(self, value: Any) -> Any:
        """A number that is >= 0."""
        if isinstance(value, str):
            return value
        op, *rest = value
        if op in ("square", "root"):
            return op, self.term(rest[0])
        if op == "pow":
            return op, self.value(rest[0]), self.exponent(rest[1])
        return op, *map(self.value, rest)


class TermWriter(_Parts):
    """Writes terms; subterms that occur again in what was announced are written as names."""

    number = exponent = str

    def __init__(self, prefix: str, terms: Iterable[Term], known: Mapping[Term, str]) -> None:
        self._names: dict[Term, str] = dict(known)
        counts = _occurrences(terms, self._names)
        for term, count in counts.items():
            if count > 1 and operations_in(term) >= SHARED_SIZE:
                self._names[term] = f"{prefix}.{len(self._names) - len(known) + 1}"
        self._own = {term: name for term, name in self._names.items() if term not in known}

    @property
    def names(self) -> Mapping[Term, str]:
        """The names of shared subterms, those that were known before included."""
        return self._names

    def shared(self) -> dict[str, Any]:
        """The table of the shared subterms that were found here."""
        return {name: self._operation(term) for term, name in self._own.items()}

    def term(self, term: Term) -> Any:
        """A term as JSON."""
        name = self._names.get(term)
        return self._operation(term) if name is None else name

    def _operation(self, term: Term) -> Any:
        if term.op == "rational":
            return str(term.value)
        if term.op == "symbol":
            return term.name
        if term.op in INDEXED:
            return [term.op, self.term(term.children[0]), str(term.exponent)]
        return [term.op, *map(self.term, term.children)]

    def claim(self, claim: Claim | Applies | Always) -> Any:
        """A claim as JSON."""
        if isinstance(claim, Applies):
            return ["applies", claim.context, self.table(claim.at)]
        if isinstance(claim, Always):
            return ["always", claim.context, self.table(claim.start), self.table(claim.next)]
        return [claim.relation, self.term(claim.lhs), self.term(claim.rhs)]

    def table(self, terms: Mapping[str, Term]) -> dict[str, Any]:
        """A table of terms as JSON."""
        return {name: self.term(term) for name, term in terms.items()}


def _occurrences(terms: Iterable[Term], known: Mapping[Term, str]) -> Counter[Term]:
    """How often each operation is written down, if it is written once for each of its users."""
    counts: Counter[Term] = Counter()
    waiting = list(terms)
    while waiting:
        term = waiting.pop()
        if term.children and term not in known:
            counts[term] += 1
            if counts[term] == 1:
                waiting += term.children
    return Counter(dict(sorted(counts.items(), key=lambda pair: operations_in(pair[0]))))


class TermReader(_Parts):
    """Reads terms, with a table of shared ones."""

    number, exponent = Fraction, int

    def __init__(self, *tables: Mapping[str, Any]) -> None:
        self._documents = {name: value for table in tables for name, value in table.items()}
        self._terms: dict[str, Term] = {}

    def term(self, document: Any) -> Term:
        """The term that a JSON value stands for.

        Raises:
            WireError: for anything that is not a term.
        """
        if isinstance(document, str) and document:
            return self._leaf(document)
        if isinstance(document, list) and document and document[0] in WRITTEN:
            op, *arguments = document
            if op in INDEXED:
                base, exponent = self.term(arguments[0]), int(arguments[1])
                return base**exponent if op == "pow" else nth_root(base, exponent)
            return Term(op, *map(self.term, arguments))
        raise WireError(f"{str(document)[:40]!r} is not a term")

    def _leaf(self, text: str) -> Term:
        if text in self._documents:
            if text not in self._terms:
                self._terms[text] = self.term(self._documents[text])
            return self._terms[text]
        if text[0].isalpha():
            return symbol(text)
        if re.fullmatch(r"-?[0-9]+(/[0-9]*[1-9][0-9]*)?", text, re.ASCII):
            return as_term(Fraction(text))
        raise WireError(f"{text[:40]!r} is not a term")

    def claim(self, document: Any) -> Claim | Applies | Always:
        """The claim that a JSON value stands for."""
        kind, *rest = document
        if kind == "applies":
            return Applies(rest[0], self.table(rest[1]))
        if kind == "always":
            return Always(rest[0], self.table(rest[1]), self.table(rest[2]))
        return self.comparison(document)

    def comparison(self, document: Any) -> Claim:
        """The claim that compares two terms."""
        relation, lhs, rhs = document
        return Claim(relation, self.term(lhs), self.term(rhs))

    def table(self, document: Mapping[str, Any]) -> dict[str, Term]:
        """A table of terms."""
        return {name: self.term(term) for name, term in document.items()}
