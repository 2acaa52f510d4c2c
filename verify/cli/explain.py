"""Print a row with the facts that prove it and the identity, so that it can be checked by hand."""

from __future__ import annotations

import glob
import json
import os
import re
from collections.abc import Iterator
from difflib import get_close_matches

from verify.cli.files import MAX_BYTES, print_document
from verify.cli.options import COLOR, JSON, Options, Usage, field
from verify.cli.proofs import (
    MAIN,
    accepted_outcome,
    explained_in,
    names_with,
    outcome_of,
    with_something_proved,
)
from verify.cli.terminal import show
from verify.language.record import TYPE_CHECKING
from verify.paper.parameters import AS_PRINTED
from verify.wire.inputs import InputError, regular_file, shown
from verify.wire.packaged import PACKAGED_FILES

if TYPE_CHECKING:
    from collections.abc import Mapping
    from typing import Any

    from verify.language.terms import Term
    from verify.paper.commands.place import Place
    from verify.prover.outcome import Outcome

FORMAT = "verify-explain/1"
#: What the prover calls the lemmas that it finds: they stand nowhere in the paper's pages.
NUMBERED = re.compile(r".*\.[0-9]+")

#: The other parameters of a point.
ANGLES = ("--theta0", "--neg-cos", "--delta-theta", "--V0")

#: The point at which a formula or a constant is told, if none is asked for.
_SAMPLE: dict[str, Any] = dict.fromkeys(map(field, ("--r", *ANGLES))) | {"r": "3/100"}
#: What constants are called: a name or a letter, and no row, whose names have hyphens.
CONSTANT = re.compile(r"(printed\.|repaired\.)?[^-.\s]+")

#: Where the committed certificates are, of scenes and points too.
COMMITTED = "certificates"


USAGE = Usage(
    {
        "row [row ...]": "FOLDER ROW, or ROW: a row, a lemma or a constant, with or without its "
        "group; a label, or (4.25). FOLDER has a certificate, or is one of step, flow, sharper, "
        "theorem1-all, …",
        "-v, --verbose": "claims as the statement has them, not simplified",
        "--r R": "the row at this point of Theorem 1, as verify theorem1 has it",
        **{f"{name} {name[2:].upper()}": "the same: see verify theorem1 --help" for name in ANGLES},
        **JSON,
        **COLOR,
    },
    example="zeta-x-bound",
)


def run(options: Options) -> int:
    """Print what is known of the row, or which rows a label has; return 0."""
    *folders, word = options.row
    if len(folders) > 1:
        raise InputError(f"row: unexpected argument {shown(word)}; write FOLDER ROW, or ROW")
    word, parameters = _label(word), _parameters(options)
    if parameters and folders:
        raise InputError(f"row: leave out {shown(folders[0])} with --r; write --r R ROW")
    answer = _answer(word, parameters) if parameters and not options.verbose else []
    if answer:
        text = answer
    elif parameters:
        from verify.paper.commands.theorem1 import decide_point  # loaded only where it is used

        text = _inside("theorem1", accepted_outcome(decide_point(parameters)), word, options)
    elif folders:
        text = _inside(folders[0], outcome_of(folders[0]), word, options)
    else:
        text = _anywhere(word, options)
    if options.json:
        asked = {"row": options.row[-1], "folder": folders[0] if folders else None}
        print_document({"format": FORMAT, "command": "explain", **asked, "text": text})
    else:
        show(text, options)
    return 0


def _label(word: str) -> str:
    """The label of what the paper prints as ``(4.25)``; another word as it is."""
    from verify.paper.source import labels_called

    return next(iter(labels_called(word)), word)


def _parameters(options: Options) -> Mapping[str, Term] | None:
    """The parameters of the point that the options name; None if they name none."""
    given = {name: getattr(options, field(name)) for name in ("--r", *ANGLES)}
    if given["--r"] is None:
        for name in (name for name, value in given.items() if value is not None):
            raise InputError(f"{name}: is for a point; write --r too")
        return None
    from verify.spheres.parameters import read_parameters  # loaded only where it is used

    return read_parameters({field(name): value for name, value in given.items()})


def _inside(folder: str, outcome: Outcome, word: str, options: Options) -> list[str]:
    """The row in one statement, or the rows of a label there."""
    from verify.paper.source import PAPER  # loaded only where they are used
    from verify.views.explain import explain, labelled
    from verify.views.words import DOES_NOT_APPLY, headline

    text = explain(outcome, word, PAPER, exact=options.verbose) or labelled(outcome, word)
    if not text:
        names = get_close_matches(word, sorted(explained_in(outcome)), 3, 0.6)
        near = f"is it {', '.join(names)}?" if names else "write a name of its report, or a label"
        if headline(outcome) == DOES_NOT_APPLY:
            near = "a hypothesis does not hold there; write numbers at which all hold: --r 0.03"
        raise InputError(f"row: there is no row {shown(word)} in {shown(folder)}; {near}")
    return [_title(folder, outcome), *text]


def _title(where: str, outcome: Outcome) -> str:
    """Which statement it is whose row is shown."""
    from verify.views.words import in_letters  # loaded only where it is used

    return f"in {where}: {in_letters(outcome.statement.title)}"


def _anywhere(word: str, options: Options) -> list[str]:
    """Where the word is written, and the row in the first statement that has it."""
    from verify.paper.commands.index import written  # loaded only where they are used
    from verify.paper.source import PAPER
    from verify.views.explain import explain

    answer = _answer(word, _parameters(Options(**_SAMPLE)))
    if answer and not options.verbose:
        return [*answer, f"Where it is written, with all rows: verify explain -v {word}"]
    found = written(word) if word else []
    places = [line for place in found for line in _where(place, word)]
    if any(place.label == word for place in found):
        return [*answer, *places]
    text, there = answer, _statements_with(word, found)
    if {MAIN, AS_PRINTED} <= {*there}:  # first what is printed, then what repairs it
        there.remove(AS_PRINTED)
        printed = outcome_of(AS_PRINTED)
        claimed = explain(printed, word, PAPER, exact=options.verbose, has_proof=False)
        proof = f"  its proof: verify explain {AS_PRINTED} {word}"
        text += [_title(AS_PRINTED, printed), *claimed, proof, ""]
    for first in there[:1]:
        outcome = outcome_of(first)
        shown_there = explain(outcome, word, PAPER, exact=options.verbose)
        text += [_title(first, outcome), *shown_there, ""]
    text += [*places, ""] if places else []
    others = [*there[1:], *_committed(word)]
    if others:
        text += [f"{word} stands in other statements too:" if there else f"{word} stands in:"]
        text += [f"  verify explain {other} {word}" for other in others]
    if any(not place.part for place in found):
        text += [f"At a point of Theorem 1: verify explain --r 3/100 {word}"]
    if not text:
        raise InputError(f"row: {_instead(word)}")
    return text


def _answer(word: str, parameters: Mapping[str, Term] | None) -> list[str]:
    """What a label or a constant comes to: at a point of Theorem 1, or in another statement.

    The verdicts at the point are those that `verify theorem1` prints there, by the same judges.
    """
    from verify.paper.source import PAPER, printed_number  # loaded only where they are used

    is_label = printed_number(word) is not None
    if parameters is None or not (is_label or CONSTANT.fullmatch(word)):
        return []
    from verify.paper.commands.theorem1 import decide_point
    from verify.views.explain import about_constant, about_label

    outcome = with_something_proved(decide_point(parameters, all_sides=is_label))
    if not is_label:
        return about_constant(outcome, word, PAPER)
    text = about_label(outcome, word, PAPER)
    for name in ("elsewhere", "spectrum", "classification"):
        found = [] if text else about_label(outcome_of(name), word, PAPER)
        text = [f"in {name}", *found] if found else text
    return text


def _where(place: Place, word: str) -> Iterator[str]:
    yield f"{place.name} is written in {place.path}:{place.line}"
    if place.label == word:
        yield f"  {place.says}"


def _statements_with(word: str, found: list[Place]) -> list[str]:
    """The statements that have this name, those first in which it is a row.

    Those about all parameters are named for what their part of the paper has, or for what no other
    statement has.
    """
    about_all = (MAIN, AS_PRINTED)
    there = {name: names_with(name, word) for name in PACKAGED_FILES if name not in about_all}
    there = {name: names for name, names in there.items() if word in names}
    theirs = [place for place in found if place.part in ("", "everywhere")]
    if theirs or (not there and (found or NUMBERED.fullmatch(word))):
        printed = [place for place in theirs if place.name.startswith(f"{AS_PRINTED}.")]
        wanted = [MAIN] if len(printed) < len(theirs) or not theirs else []
        wanted += [AS_PRINTED] if printed else []
        asked = {name: names_with(name, word) for name in wanted}
        there |= {name: names for name, names in asked.items() if word in names}
    return sorted(there, key=lambda name: not there[name][word])


def _committed(word: str) -> Iterator[str]:
    """The folders of scenes and points that have this row, where the certificates are at hand."""
    for path in sorted(glob.glob(os.path.join(COMMITTED, "**", "statement.json"), recursive=True)):
        folder = os.path.dirname(path)
        if os.path.basename(folder) in PACKAGED_FILES:
            continue
        try:
            rows = {row["name"] for row in json.loads(regular_file(path, MAX_BYTES))["obligations"]}
        except (OSError, ValueError, KeyError, TypeError):
            continue
        if word in rows:
            yield folder


def _instead(word: str) -> str:
    from verify.paper.commands.index import near  # loaded only where they are used
    from verify.paper.source import printed_number

    number = re.fullmatch(r"\(?([0-9]+)\.([0-9]+)\)?", printed_number(word) or word)
    if number:
        return _near_numbers(int(number[1]), int(number[2]))
    names = near(word)
    no_row = f"there is no row {shown(word)}; "
    return no_row + (
        f"is it {', '.join(names)}?" if names else "write a name of a report, or a label"
    )


def _near_numbers(section: int, number: int) -> str:
    """What is said of a number of which there is no row: which numbers have some."""
    from verify.paper.commands.index import written  # loaded only where they are used
    from verify.paper.source import printed_numbers

    called = re.compile(r"\(([0-9]+)\.([0-9]+)\)")
    found = {label: called.fullmatch(text) for label, text in printed_numbers().items()}
    numbers = {(int(m[1]), int(m[2])) for label, m in found.items() if m and written(label)}
    known = sorted(numbers, key=lambda n: (abs(n[0] - section), abs(n[1] - number), n))
    near = ", ".join(f"({a}.{b})" for a, b in sorted(known[:3]))
    return f"no row is about ({section}.{number}); write one of the nearest that have rows: {near}"
