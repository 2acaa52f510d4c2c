"""Which proof a command is to show: that in a folder, or one that the program makes."""

from __future__ import annotations

import json
import os
from collections.abc import Callable, Mapping
from difflib import get_close_matches
from functools import cache, partial

from verify.cli.files import command_for, example, read_bytes
from verify.cli.terminal import progress
from verify.paper.commands import index
from verify.paper.parameters import ALL, AS_PRINTED
from verify.prover.outcome import Outcome
from verify.wire.inputs import InputError, shown
from verify.wire.packaged import PACKAGED_FILES, packaged_files

#: The statement whose proof is shown where nobody names one.
MAIN = ALL

#: What a folder of a certificate has.
NAMES = ("statement.json", "certificate.json")


@cache
def statements() -> Mapping[str, Callable[[], Outcome]]:
    """What decides each of the statements that come with the program."""
    from verify.paper.commands import certificates, pages  # load flint

    decided = {theorem.folder: theorem.decide for theorem in certificates.THEOREMS}
    return {**decided, AS_PRINTED: partial(pages.decide, "printed_rows")}


def names_with(where: str, word: str) -> dict[str, bool]:
    """The names in one of `statements`, each with whether it is a row there.

    A row has its name and the one without its group. What comes with the program is searched for
    the word before anything of it is read.
    """
    if index.lines() is None:
        return explained_in(statements()[where]())
    statement, certificate = packaged_files(where)
    end = json.dumps(word, ensure_ascii=False)[1:].encode("utf-8", "surrogatepass")
    if end not in statement and end not in certificate:
        return {}
    said, steps = json.loads(statement), json.loads(certificate)["steps"]
    rows = said["obligations"]
    opened = {step["open"] for step in steps if "open" in step}
    givens = [c["givens"] for c in said["contexts"] if c["name"] in opened]
    kinds = ("constant", "lemma", "define")
    found = dict.fromkeys((given["name"] for names in givens for given in names), False)
    found |= {step[kind]: False for step in steps for kind in kinds if kind in step}
    for row in rows:
        found |= {row["name"]: True, row["name"].removeprefix(f"{row['group']}."): True}
    return found


def explained_in(outcome: Outcome) -> dict[str, bool]:
    """The names of rows, with and without groups, of lemmas and of constants; which are rows."""
    from verify.prover.uses import nodes  # loaded only where it is used
    from verify.views.words import short_name

    found = dict.fromkeys(nodes(outcome), False)
    for row, _ in outcome.rows:
        found |= {row.name: True, short_name(row): True}
    return found


def outcome_of(where: str) -> Outcome:
    """The outcome in a folder, as it is written there, or that of one of `statements`.

    The latter come with the program; they are made anew where what it says has changed since.

    Raises:
        InputError: if it is neither, or the folder has no certificate.
    """
    if os.path.isdir(where):
        return _read(where)
    if where in PACKAGED_FILES and index.lines() is not None:
        from verify.wire.judge import packaged  # loaded only where it is used

        return packaged(where)
    if where not in PACKAGED_FILES:
        page = example(where)
        if page.endswith(".toml") and os.path.isfile(page):
            raise InputError(
                f"folder: {shown(where)} is a page or a scene; write its certificate first: "
                f"verify {command_for(page)} {where} --out DIR, and then verify explain DIR ROW"
            )
        near = get_close_matches(where, PACKAGED_FILES, 3, 0.5) or list(PACKAGED_FILES)
        raise InputError(
            f"folder: {shown(where)} is no folder; name one with a certificate, or write one of: "
            f"{', '.join(near)}"
        )
    progress(f"proving {where} …")
    return accepted_outcome(statements()[where]())


def accepted_outcome(outcome: Outcome) -> Outcome:
    """The outcome, which `verify/check.py` accepts.

    Raises:
        InputError: if there is nothing that it could judge.
        OwnError: if it does not.
    """
    from verify.wire.judge import judged  # loaded only where it is used

    return judged(with_something_proved(outcome))


def with_something_proved(outcome: Outcome) -> Outcome:
    """The outcome.

    Raises:
        InputError: if the precision did not suffice for all of it.
    """
    if outcome.spent:
        raise InputError(f"row: nothing is proved there: {outcome.spent}; name another statement")
    return outcome


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
