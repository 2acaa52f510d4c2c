"""Formulas, numbers and rows of one outcome, as parts of a page."""

from __future__ import annotations

from collections.abc import Iterable, Iterator, Sequence

from verify.language.simplify import simplified_claim
from verify.language.statement import HYPOTHESES, PRINTED, Always, Applies, Obligation, Publication
from verify.language.terms import Claim, Term
from verify.prover.decimals import decimal_text, round_decimal, short
from verify.prover.outcome import Decision, Ends, Outcome
from verify.views.mathml import MathML
from verify.views.page.blocks import Cell, Code, Inline, Math, Number, Table, Text, Verdict
from verify.views.words import in_letters, letters, sides_of

Row = tuple[Obligation, Decision]

SIGNS = {"<": "<", "<=": "≤", "=": "="}

#: Formulas with more letters than this stay in the statement file.
LONGEST = 400

#: A summand with more letters than this is too wide for a line.
WIDEST = 90

#: A min with more entries than this is written one entry a line.
MANY = 2


class Writer:
    """Formulas and numbers of one outcome."""

    def __init__(self, outcome: Outcome, paper: Publication) -> None:
        self.outcome, self.paper = outcome, paper
        self.causes = paper.notes().causes
        self.typesetter = letters(outcome)
        statement = outcome.statement
        tex = {constant.name: constant.tex for constant in statement.constants}
        for context in statement.contexts:
            tex |= {variable.name: variable.tex for variable in context.variables}
            tex |= {constant.name: constant.tex for constant in context.constants}
        self._mathml = MathML(tex | ({"c": r"(-\cos\theta_0)"} if statement.parameters else {}))
        self.rows = {row.name: (row, found) for row, found in outcome.rows}

    def claim(self, claim: Claim | Applies | Always) -> Math | Text | None:
        """A claim, unless it is too long to be read; in letters only if no line can break in it."""
        if isinstance(claim, Claim):
            claim = simplified_claim(claim)
        text = self.typesetter.claim(claim)
        if len(text) > LONGEST:
            return None
        if not isinstance(claim, Claim):
            return Text(text)
        widest = max(len(self.typesetter.term(part)) for part in summands(claim))
        return Math(self._mathml.claim(claim) if widest <= WIDEST else "", text)

    def plain(self, term: Term) -> str:
        """A term in plain letters."""
        return self.typesetter.term(term)

    def term(self, term: Term, before: str = "") -> Math:
        """A term after a relation."""
        text = f"{before} {self.typesetter.term(term)}".strip()
        if term.op == "min" and len(term.children) > MANY:
            return Math(self._mathml.entries(term, before), text)
        return Math(self._mathml.term(term, before), text)


def summands(claim: Claim) -> Iterator[Term]:
    """The parts of both sides between which a line can break."""
    left = [claim.rhs, claim.lhs]
    while left:
        term = left.pop()
        if term.op in ("add", "sub"):
            left += reversed(term.children)
        else:
            yield term


def number_of(ends: Ends | None, digits: int = 8, unfolds: bool = False) -> Number | None:
    """An enclosure with both ends as they stand in the certificate."""
    if ends is None:
        return None
    low, high = (decimal_text(*round_decimal(end, 40, up=False)) for end in ends)
    return Number(short(ends, digits), (low, high), unfolds)


def sides_shown(row: Obligation, found: Decision) -> tuple[Number | None, Number | None]:
    """Both sides of a row, where they are numbers."""
    sides = sides_of(row, found)
    return (None, None) if sides is None else (number_of(sides[0]), number_of(sides[1]))


def cell(*parts: Math | Number | Text | None) -> Cell:
    """What there is of these parts."""
    return [part for part in parts if part is not None]


def with_verdict(rows: Iterable[Row], verdict: str) -> list[Row]:
    """The rows with a verdict."""
    return [(row, found) for row, found in rows if found.verdict == verdict]


def of_role(rows: Iterable[Row], role: str) -> list[Row]:
    """The rows with a role."""
    return [(row, found) for row, found in rows if row.role == role]


def rows_as_printed(outcome: Outcome) -> list[Row]:
    """What the paper says, of the hypotheses and of the printed set."""
    return of_role(outcome.of_group(HYPOTHESES, PRINTED), PRINTED)


def label_cell(label: str, paper: Publication) -> Cell:
    """A label of the paper, after the number that is printed there."""
    number = paper.printed(label)
    return [Code(label)] if number is None else [Text(f"{number} "), Code(label)]


def rows_table(writer: Writer, title: str, rows: Sequence[Row], name: str = "") -> Table:
    """Rows with formulas and both sides, one below the other; folded away."""
    head = ("Verdict", "Label", "Step", "Claim", "Sides or rule")
    return Table(title, head, [_row(writer, *pair) for pair in rows], True, name, True)


def _row(writer: Writer, row: Obligation, found: Decision) -> list[Cell]:
    claim = writer.claim(row.claim)
    lhs, rhs = sides_shown(row, found)
    last: list[Inline] = [Text(f"by {found.method}" if found.method else "")]
    if lhs is not None and rhs is not None and isinstance(row.claim, Claim):
        last = [lhs, Text(f" {SIGNS[row.claim.relation]} "), rhs]
    return [
        [Verdict(found.verdict)],
        label_cell(row.label, writer.paper),
        [Text(in_letters(row.says))],
        [Text("(long: see the statement file)") if claim is None else claim],
        last,
    ]


def plain_rows(writer: Writer, title: str, rows: Sequence[Row]) -> Table:
    """Many rows: formulas in plain letters."""
    shown: list[list[Cell]] = []
    for row, found in rows:
        claim = writer.claim(row.claim)
        text = "(long: see the statement file)" if claim is None else claim.text
        last = f"by {found.method}" if found.method else ""
        shown.append(
            [
                [Verdict(found.verdict)],
                label_cell(row.label, writer.paper),
                [Text(in_letters(row.says))],
                [Text(text)],
                [Text(last)],
            ]
        )
    return Table(title, ("Verdict", "Label", "Step", "Claim", "Rule"), shown, True, "", True)
