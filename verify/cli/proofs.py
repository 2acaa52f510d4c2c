"""Which proof a command is to show: that in a folder, or one that the program makes."""

from __future__ import annotations

import os
from collections.abc import Callable, Mapping
from difflib import get_close_matches
from functools import cache

from verify.cli.files import progress, read_bytes
from verify.language.record import TYPE_CHECKING
from verify.wire.inputs import InputError, shown

if TYPE_CHECKING:
    from verify.prover.outcome import Outcome

#: The statement whose proof is shown where nobody names one.
MAIN = "theorem1-all"
#: The rows of the printed set for all parameters, which have no certificate: some are refuted.
AS_PRINTED = "printed"

#: What a folder of a certificate has.
NAMES = ("statement.json", "certificate.json")


@cache
def statements() -> Mapping[str, Callable[[], Outcome]]:
    """What the program proves for all values, by the names of the committed folders."""
    from verify.paper.commands import (
        certificates,  # load flint
        everywhere,  # load flint
    )

    return {**certificates.THEOREMS, AS_PRINTED: everywhere.decide_printed_everywhere}


def outcome_of(where: str) -> Outcome:
    """The outcome in a folder, as it is written there, or that of one of `statements`.

    That about all parameters comes with the program; the others are made anew.

    Raises:
        InputError: if it is neither, or the folder has no certificate.
    """
    if os.path.isdir(where):
        return _read(where)
    if where == MAIN:
        from verify.wire.judge import packaged  # loaded only where it is used

        return packaged(where)
    if where not in statements():
        near = get_close_matches(where, statements(), 3, 0.5) or statements()
        raise InputError(
            f"folder: {shown(where)} is no folder; name one with a certificate, or write one of: "
            f"{', '.join(near)}"
        )
    progress(f"proving {where}")
    return accepted_outcome(statements()[where]())


def accepted_outcome(outcome: Outcome) -> Outcome:
    """The outcome, which `verify/check.py` accepts.

    Raises:
        InputError: if there is nothing that it could judge.
        OwnError: if it does not.
    """
    from verify.wire.judge import judged  # loaded only where it is used

    if outcome.spent:
        raise InputError(f"row: nothing is proved there: {outcome.spent}; name another statement")
    return judged(outcome)


def _read(where: str) -> Outcome:
    from verify import check
    from verify.wire.judge import with_verdicts
    from verify.wire.read import read
    from verify.wire.term_json import WireError
    from verify.wire.write import digest

    first, second = (read_bytes("folder", os.path.join(where, name)) for name in NAMES)
    try:
        cited = check.read_cited(os.path.join(where, "cited"))
    except OSError as error:
        raise InputError(f"folder: {shown(where)} cannot be read ({error})") from error
    ((report, _),) = check.judged([check.Folder(where, first, second, *cited)])
    if report.verdict == "MALFORMED":
        raise InputError(f"folder: {shown(where)} has no certificate ({report.summary})")
    if report.verdict == "REFUSED":
        raise InputError(f"folder: {shown(where)}: verify/check.py refuses the certificate")
    try:
        outcome = read(first, second, {digest(content): content for content in cited[0]})
    except (WireError, RecursionError) as error:
        raise InputError(f"folder: {shown(where)} has no certificate ({error})") from error
    return with_verdicts(outcome, report)
