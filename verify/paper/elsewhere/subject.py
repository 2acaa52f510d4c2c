"""A subject of the text: a context with its lines; and a row that is false, with where it is."""

from __future__ import annotations

from collections.abc import Iterable, Mapping

from verify.language.argument import Chapter, Item, Opened
from verify.language.record import Record
from verify.language.statement import Obligation
from verify.language.terms import Claim, Term
from verify.paper.classification.settings import Letters
from verify.paper.rows import misprint


def subject(
    letters: Letters, says: str, point: str, givens: Mapping[str, Claim], lines: Iterable[Item] = ()
) -> tuple[Chapter, ...]:
    """The chapters that open a context without a parent, and prove lines in it."""
    opened = Chapter(None, (Opened(letters.opened(says, point, givens)),))
    return opened, Chapter(letters.context, tuple(lines))


class Refuted(Record):
    """A misprint in a context, and a point of the context at which the claim is false."""

    row: Obligation
    at: Mapping[str, Term]


def refuted(
    letters: Letters,
    name: str,
    claim: Claim,
    at: str,
    *,
    label: str,
    says: str,
    severity: str,
    corrected_by: str,
) -> Refuted:
    """The row, and the numbers of the point in the order of the letters."""
    row = misprint(name, label, says, claim, group="", severity=severity, corrected_by=corrected_by,
                   context=letters.context)  # fmt: skip
    return Refuted(row, letters.point(at))
