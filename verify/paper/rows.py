"""How a row is written down: one call for each kind of row.

The name of a row is unique in its statement; the group that it belongs to is a field. What a row
says of itself, its severity included, is fixed here, before anything is decided.
"""

from __future__ import annotations

from collections.abc import Iterable

from verify.language.record import Record
from verify.language.statement import (
    BREAKS,
    HARMLESS,
    NEEDED,
    PRINTED,
    SEVERITIES,
    SLIP,
    Always,
    Applies,
    Obligation,
)
from verify.language.terms import Claim

__all__ = [
    "BREAKS",
    "HARMLESS",
    "SEVERITIES",
    "SLIP",
    "Cause",
    "Remark",
    "misprint",
    "needed",
    "printed",
]


class Cause(Record):
    """What is wrong, once, with the names of all rows that show it."""

    rows: tuple[str, ...]
    text: str


class Remark(Record):
    r"""A sentence about the text near one of the paper's ``\label``s."""

    label: str
    text: str


def needed(
    name: str,
    label: str,
    says: str,
    claim: Claim | Applies | Always,
    uses: Iterable[str] = (),
    *,
    group: str,
    context: str | None = None,
) -> Obligation:
    """A row that has to hold: a premise of the step, or the paper's own way to what that proves."""
    return Obligation(name, group, label, NEEDED, says, claim, tuple(uses), context=context)


def printed(
    name: str,
    label: str,
    says: str,
    claim: Claim | Applies | Always,
    uses: Iterable[str] = (),
    *,
    group: str,
    context: str | None = None,
) -> Obligation:
    """A row of the paper against which nothing is known."""
    return Obligation(name, group, label, PRINTED, says, claim, tuple(uses), context=context)


def misprint(
    name: str,
    label: str,
    says: str,
    claim: Claim | Applies | Always,
    severity: str,
    corrected_by: str,
    uses: Iterable[str] = (),
    *,
    group: str,
    context: str | None = None,
) -> Obligation:
    """A row of the paper that is refuted, at least for some parameters.

    ``severity`` is how bad that is, ``corrected_by`` the name of the row that replaces it.

    Raises:
        ValueError: if the severity is not one of `SEVERITIES`.
    """
    if severity not in SEVERITIES:
        raise ValueError(f"row {name}: {severity!r} is not one of {', '.join(SEVERITIES)}")
    row = printed(name, label, says, claim, uses, group=group, context=context)
    return row._replace(severity=severity, corrected_by=corrected_by)
