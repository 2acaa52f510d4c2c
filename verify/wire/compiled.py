"""A page without contexts, compiled: what it says in lines that are read in a few milliseconds.

The first line has the digest of the text of the page; of another text nothing is taken from here.
Then come terms, each with the numbers of those before it, and what the page says in their place.
No row is trusted: what is read goes the way of a page. What is kept of algebra is: see `Kept`.
"""

from __future__ import annotations

from collections.abc import Iterable, Iterator, Mapping
from fractions import Fraction
from hashlib import sha256

from verify.language.record import Record
from verify.language.statement import Assumption, Choice, Constant, Obligation
from verify.language.terms import INDEXED, Claim, Term, symbol

#: Between the parts of a line, and in place of what there is none of.
TAB, NONE = "\t", "-"


class Kept(Record):
    """A verdict that algebra gives on a claim wherever some other claims hold.

    The checker has accepted the proof when this was written down, by `tests/bring.py`.
    """

    verdict: str
    needs: tuple[Claim, ...]


class Compiled(Record):
    """The name of a theorem, and what its page says; a constant that may be chosen is a choice."""

    theorem: str
    parameters: tuple[str, ...]
    constants: tuple[Constant | Choice, ...]
    rows: tuple[Obligation, ...]
    assumptions: tuple[Assumption, ...]
    kept: Mapping[Claim, Kept]


def compiled(page: Compiled, content: bytes) -> str:
    """What a page with this content says, as lines.

    Raises:
        ValueError: for a text with a tabulator or a line break in it, and for a row in a context.
    """
    terms = _Terms()
    said = list(_said(page, terms))
    if any(TAB in part or "\n" in part for line in said for part in line):
        raise ValueError("a tabulator or a line break stands in a text; write a space")
    lines = [[sha256(content).hexdigest()], *terms.lines, [""], *said]
    return "".join(f"{TAB.join(line)}\n" for line in lines)


class _Terms:
    """The terms so far, each with its number."""

    def __init__(self) -> None:
        self.lines: list[list[str]] = []
        self._numbers: dict[Term, str] = {}

    def number(self, term: Term) -> str:
        """The number of a term, whose line stands there afterwards."""
        if term not in self._numbers:
            self.lines.append([term.op, *self._arguments(term)])
            self._numbers[term] = str(len(self._numbers))
        return self._numbers[term]

    def claim(self, claim: Claim) -> list[str]:
        """The relation of a claim and the numbers of its sides."""
        relation, lhs, rhs = claim.key
        return [relation, self.number(lhs), self.number(rhs)]

    def _arguments(self, term: Term) -> list[str]:
        if term.op == "rational":
            return [str(term.value.numerator), str(term.value.denominator)]
        if term.op == "symbol":
            return [term.name]
        own = [str(term.exponent)] if term.op in INDEXED else []
        return [*own, *map(self.number, term.children)]


def _said(page: Compiled, terms: _Terms) -> Iterator[list[str]]:
    yield ["theorem", page.theorem, *page.parameters]
    for item in page.constants:
        bound = item.constant if isinstance(item, Choice) else item
        line = ["constant", *bound[:-1], terms.number(bound.term)]
        if isinstance(item, Choice):
            line += [item.direction, NONE if item.base is None else terms.number(item.base)]
        yield line
    for row in page.rows:
        if not isinstance(row.claim, Claim) or row.context is not None:
            raise ValueError(f"the row {row.name} is about a context, which is not compiled")
        claim = terms.claim(row.claim)
        said = [row.name, row.group, row.label, row.role, row.says]
        yield ["row", *said, *claim, row.severity or NONE, row.corrected_by or NONE, *row.uses]
    for assumption in page.assumptions:
        yield ["assumption", *assumption]
    for about, kept in page.kept.items():
        claims = (about, *kept.needs)
        yield ["kept", kept.verdict, *(part for one in claims for part in terms.claim(one))]


def read_compiled(text: str, content: bytes) -> Compiled | None:
    """What these lines say of a page with this content; None if they are about another text."""
    digest, _, rest = text.partition("\n")
    if digest != sha256(content).hexdigest():
        return None
    first, _, second = rest.partition("\n\n")
    terms = _read_terms(first.split("\n"))
    theorem, *others = (line.split(TAB) for line in second.removesuffix("\n").split("\n"))
    kinds: dict[str, list[list[str]]] = {"constant": [], "row": [], "assumption": [], "kept": []}
    for kind, *line in others:
        kinds[kind].append(line)
    return Compiled(
        theorem[1],
        tuple(theorem[2:]),
        tuple(_constant(line, terms) for line in kinds["constant"]),
        tuple(_row(line, terms) for line in kinds["row"]),
        tuple(Assumption(*line) for line in kinds["assumption"]),
        dict(_kept(line, terms) for line in kinds["kept"]),
    )


def _read_terms(lines: Iterable[str]) -> list[Term]:
    found: list[Term] = []
    for line in lines:
        op, *rest = line.split(TAB)
        if op == "symbol":
            term = symbol(rest[0])
        elif op == "rational":
            term = Term(op, Fraction(int(rest[0]), int(rest[1])))
        elif op in INDEXED:
            term = Term(op, found[int(rest[1])], int(rest[0]))
        else:
            term = Term(op, *[found[int(number)] for number in rest])
        found.append(term)
    return found


def _constant(line: list[str], terms: list[Term]) -> Constant | Choice:
    name, letter, tex, label, number, *choice = line
    constant = Constant(name, letter, tex, label, terms[int(number)])
    if not choice:
        return constant
    direction, base = choice
    return Choice(constant, direction, None if base == NONE else terms[int(base)])


def _row(line: list[str], terms: list[Term]) -> Obligation:
    name, group, label, role, says, relation, lhs, rhs, severity, corrected, *uses = line
    claim = Claim(relation, terms[int(lhs)], terms[int(rhs)])
    bad = None if severity == NONE else severity
    better = None if corrected == NONE else corrected
    return Obligation(name, group, label, role, says, claim, tuple(uses), better, bad, None)


def _kept(line: list[str], terms: list[Term]) -> tuple[Claim, Kept]:
    verdict, *parts = line
    claim, *needs = (
        Claim(relation, terms[int(lhs)], terms[int(rhs)])
        for relation, lhs, rhs in zip(parts[::3], parts[1::3], parts[2::3], strict=True)
    )
    return claim, Kept(verdict, tuple(needs))
