"""Which proof a command is to show: that in a folder, or one that the program makes."""

from __future__ import annotations

import os
from collections.abc import Callable, Mapping
from difflib import get_close_matches
from functools import cache

from verify.cli.files import progress, read_bytes, read_cited
from verify.jobs.inputs import InputError, shown
from verify.language.record import TYPE_CHECKING

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
    from verify.jobs import certificates, everywhere  # load flint

    return {**certificates.THEOREMS, AS_PRINTED: everywhere.decide_printed_everywhere}


def outcome_of(where: str) -> Outcome:
    """The outcome in a folder, as it is written there, or that of one of `statements`, made anew.

    Raises:
        InputError: if it is neither, or the folder has no certificate.
    """
    if os.path.isdir(where):
        return _read(where)
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
    from verify.jobs.acceptance import judged  # loaded only where it is used

    if outcome.spent:
        raise InputError(f"row: nothing is proved there: {outcome.spent}; name another statement")
    return judged(outcome)


def _read(folder: str) -> Outcome:
    from verify import check
    from verify.jobs.acceptance import read_judged
    from verify.wire.term_json import WireError
    from verify.wire.write import digest

    first, second = (read_bytes("folder", os.path.join(folder, name)) for name in NAMES)
    contents = read_cited("folder", folder)
    known = {digest(content): content for content in contents}
    try:
        return read_judged(first, second, known)
    except check.Refused as error:
        where = shown(folder)
        raise InputError(f"folder: {where}: verify/check.py refuses the certificate") from error
    except (WireError, check.Malformed, RecursionError) as error:
        raise InputError(f"folder: {shown(folder)} has no certificate ({error})") from error
