"""What is said of rows of the print that are false: why, and how bad it is.

What a row says of itself is fixed on its page, before anything is decided. So is its severity where
it concerns the wording; whether a step that is false breaks the argument follows from the verdicts,
by `graded`.
"""

from __future__ import annotations

from collections.abc import Mapping

from verify.language.record import Record
from verify.language.statement import PROVED, Obligation
from verify.publication import BREAKS as BREAKS
from verify.publication import HARMLESS as HARMLESS
from verify.publication import OTHERWISE as OTHERWISE
from verify.publication import REMARK as REMARK
from verify.publication import SEVERITIES as SEVERITIES
from verify.publication import SLIP as SLIP


class Cause(Record):
    """What is wrong, once, with the names of all rows that show it."""

    rows: tuple[str, ...]
    text: str


class Remark(Record):
    r"""A sentence about the text near one of the paper's ``\label``s."""

    label: str
    text: str


def graded(row: Obligation, verdicts: Mapping[str, str]) -> Obligation:
    """The row with the severity that follows from verdicts, where it has one that can be computed.

    A step breaks the argument unless rows about the same constants do its work: then the paper
    reaches its conclusion without it, and it is harmless. A slip of wording stays one.
    """
    if row.severity not in (BREAKS, HARMLESS) or row.name not in INSTEAD:
        return row
    instead = INSTEAD[row.name]
    reached = bool(instead) and all(verdicts.get(name) == PROVED for name in instead)
    return row._replace(severity=HARMLESS if reached else BREAKS)


#: For each step of the printed proof of Theorem 1 that may be false, the printed rows that do its
#: work if they hold: what the text concludes from the step, with nothing else than its constants.
INSTEAD: Mapping[str, tuple[str, ...]] = {
    "printed.set-interior": (),
    "printed.norm-law-as-printed": (
        "printed.norm-factor-2",
        "printed.norm-c-upper",
        "printed.norm-c-lower",
    ),
    "printed.zeta-x-bound": ("printed.zeta-total",),
    "printed.zeta-term-2": ("printed.zeta-total",),
    "printed.zeta-remainders": ("printed.zeta-total",),
    "printed.zeta-total": (),
    "printed.x-term-1-d": ("printed.x-term-1-factor",),
    "printed.y-term-3": ("printed.y-term-3-factor",),
    "printed.final-angle": (),
}
