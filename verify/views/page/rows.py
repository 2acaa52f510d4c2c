"""Formulas, numbers and rows of one outcome, as the page shows them."""

from __future__ import annotations

from collections.abc import Iterable, Iterator

from verify.language.record import Record
from verify.language.simplify import simplified_claim
from verify.language.statement import PRINTED, Always, Applies, Constant, Obligation
from verify.language.terms import Claim, Term, symbol
from verify.language.typeset import LONG
from verify.prover.decimals import decimal_text, outward, round_decimal, short
from verify.prover.outcome import Decision, Ends, Outcome
from verify.publication import HYPOTHESES, Publication
from verify.views import words
from verify.views.mathml import MathML

Row = tuple[Obligation, Decision]

#: A summand with more letters than this is too wide for a line.
WIDEST = 90

#: A min with more entries than this is written one entry a line.
MANY = 2


class Math(Record):
    """A formula as MathML, where that can be read, and as text."""

    mathml: str
    text: str


class Number(Record):
    """An enclosure: its short form, and both ends as they stand in the certificate."""

    short: str
    ends: tuple[str, str]


class Shown(Record):
    """A row with its formula, and both sides where they are numbers with ``sign`` between them."""

    row: Obligation
    found: Decision
    verdict: str
    claim: Math
    lhs: Number | None
    sign: str
    rhs: Number | None


class Refuted(Record):
    """A refuted row: by how much, or where it is false; what is wrong; what takes its place.

    ``cause`` is empty where none is known; ``margin`` is an enclosure of right - left.
    """

    shown: Shown
    margin: Number | None
    false_at: str
    cause: str
    repair: Shown | None


class Writer:
    """Formulas and numbers of one outcome."""

    def __init__(self, outcome: Outcome, paper: Publication) -> None:
        self.outcome, self.notes = outcome, paper.notes()
        self.typesetter, tex = words.letters_and_tex(outcome)
        of_parameters = {"c": r"(-\cos\theta_0)"} if outcome.statement.parameters else {}
        self._mathml, self._simple = MathML(tex | of_parameters), dict[Term, Term]()
        self._rows = {row.name: (row, found) for row, found in outcome.rows}

    def claim(self, claim: Claim | Applies | Always) -> Math:
        """A claim, unless it is too long to be read; in letters only if no line can break in it."""
        if self.typesetter.lengths.is_long_claim(claim):
            return Math("", LONG)
        if isinstance(claim, Claim):
            claim = simplified_claim(claim, self._simple)
        text = self.typesetter.claim(claim)
        if len(text) > words.MAX_FORMULA or not isinstance(claim, Claim):
            return Math("", text if len(text) <= words.MAX_FORMULA else LONG)
        is_wide = len(text) > WIDEST and any(
            len(self.typesetter.term(part)) > WIDEST for part in summands(claim)
        )
        return Math("" if is_wide else self._mathml.claim(claim), text)

    def term(self, term: Term, before: str = "") -> Math:
        """A term after a relation."""
        told = self.typesetter.term(term)
        text = f"{before} {told}".strip()
        if LONG in told:
            return Math("", text)
        if term.op == "min" and len(term.children) > MANY:
            return Math(self._mathml.entries(term, before), text)
        return Math(self._mathml.term(term, before), text)

    def constant(self, constant: Constant) -> tuple[Math, Number | None, Math]:
        """The letter of a constant, its value, and its definition or bound after the sign."""
        sign, bound = self.notes.bounds[constant.name]
        value = number_of(words.ends_of(self.outcome, constant.name))
        return self.term(symbol(constant.name)), value, self.term(bound.term, sign)

    def shown(self, row: Obligation, found: Decision) -> Shown:
        """A row with its formula and numbers."""
        sides = words.sides_of(row, found)
        lhs, rhs = (None, None) if sides is None else map(number_of, sides)
        sign = words.SIGNS[row.claim.relation] if isinstance(row.claim, Claim) else ""
        verdict = words.fair(self.outcome, row, found)
        return Shown(row, found, verdict, self.claim(row.claim), lhs, sign, rhs)

    def all_shown(self, rows: Iterable[Row]) -> list[Shown]:
        """Some rows."""
        return [self.shown(row, found) for row, found in rows]

    def refuted(self, rows: Iterable[Row]) -> Iterator[Refuted]:
        """Some refuted rows; what is wrong is said where it is met first."""
        first: dict[str, str] = {}
        for row, found in rows:
            cause = next((text for names, text in self.notes.causes if row.name in names), "")
            before = first.setdefault(cause, row.name)
            if cause and before != row.name:
                cause = f"The cause is that of `{before}`."
            other = self._rows.get(row.corrected_by or "")
            repair = None if other is None else self.shown(*other)
            margin, false_at = self._margin(row, found)
            yield Refuted(self.shown(row, found), margin, false_at, cause, repair)

    def _margin(self, row: Obligation, found: Decision) -> tuple[Number | None, str]:
        """An enclosure of right - left, from the certified ends of both; or where a claim fails."""
        sides = words.sides_of(row, found)
        if sides is not None:
            lhs, rhs = sides
            margin = (rhs[0] - lhs[1], rhs[1] - lhs[0])
            low, high = outward(margin, 20)
            return Number(short(margin, 4), (low, high)), ""
        values = words.witness_shown(self.outcome, row, found)
        return None, words.values_told(values, self.typesetter)


def summands(claim: Claim) -> Iterator[Term]:
    """The parts of both sides between which a line can break."""
    left = [claim.rhs, claim.lhs]
    while left:
        term = left.pop()
        if term.op in ("add", "sub"):
            left += reversed(term.children)
        else:
            yield term


def number_of(ends: Ends | None) -> Number | None:
    """An enclosure with both ends as they stand in the certificate."""
    if ends is None:
        return None
    low, high = (decimal_text(*round_decimal(end, 40, up=False)) for end in ends)
    return Number(short(ends), (low, high))


def with_verdict(rows: Iterable[Row], verdict: str, outcome: Outcome) -> list[Row]:
    """The rows of an outcome with a verdict on what they say."""
    return [(row, found) for row, found in rows if words.fair(outcome, row, found) == verdict]


def of_role(rows: Iterable[Row], role: str) -> list[Row]:
    """The rows with a role."""
    return [(row, found) for row, found in rows if row.role == role]


def rows_as_printed(outcome: Outcome) -> list[Row]:
    """What the paper says, of the hypotheses and of the printed set."""
    return of_role(outcome.of_group(HYPOTHESES, PRINTED), PRINTED)
