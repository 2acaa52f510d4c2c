"""Print a row with the facts that prove it and the identity, so that it can be checked by hand."""

from __future__ import annotations

import re
from collections.abc import Iterator

from verify.cli.graph import outcome_of
from verify.cli.options import Options, Parser
from verify.cli.terminal import add_color, show
from verify.jobs.inputs import InputError, shown
from verify.language.record import TYPE_CHECKING

if TYPE_CHECKING:
    from verify.jobs.places import Place
    from verify.prover.outcome import Outcome

#: What the prover calls the lemmas that it finds: they stand nowhere in the paper's room.
NUMBERED = re.compile(r".*\.[0-9]+")


def add_arguments(parser: Parser) -> None:
    """The options."""
    text = "the name of a row, a lemma or a constant, with or without its group; a label, or (4.25)"
    parser.place("row", text)
    text = "a folder with a certificate (default: what the program proves for all parameters)"
    parser.option("--folder", text, "DIR")
    add_color(parser)


def run(options: Options) -> int:
    """Print what is known of the row, or which rows a label has; return 0."""
    from verify.views.explain import explain  # loaded only where it is used

    word = _label(options.row)
    if options.folder is not None:
        text = explain(outcome_of(options.folder), word)
    else:
        from verify.jobs.places import written

        found = written(word)
        text = [line for place in found for line in _where(place, word)]
        if not any(place.label == word for place in found):
            outcomes = _outcomes(found) if found or NUMBERED.fullmatch(word) else ()
            text += [line for outcome in outcomes for line in explain(outcome, word)]
    if not text:
        raise InputError(f"row: there is no row {shown(word)}; {_instead(word)}")
    show(text, options)
    return 0


def _label(word: str) -> str:
    """The label of what the paper prints as ``(4.25)``; another word as it is."""
    from verify.paper.numbering import labels_called

    return next(iter(labels_called(word)), word)


def _where(place: Place, word: str) -> Iterator[str]:
    yield f"{place.name} is written in {place.path}:{place.line}"
    if place.label == word:
        yield f"  {place.says}"


def _outcomes(found: list[Place]) -> Iterator[Outcome]:
    """The outcomes in which places lie, decided; those for all values if there is no place."""
    from verify.jobs import (
        classification,
        elsewhere,
        everywhere,
        spectrum,
        step,
        step_printed,
        thresholds,
    )
    from verify.paper.groups import PRINTED

    rows = [place for place in found if place.part in ("", "everywhere")]
    printed = [place for place in rows if place.name.startswith(f"{PRINTED}.")]
    parts = {place.part for place in found}
    if not found or len(rows) > len(printed):
        yield everywhere.decide_everywhere()
    if printed:
        yield everywhere.decide_printed_everywhere()
    if not found or "step" in parts:
        yield step.decide_step()
    if any(place.path.endswith(("thresholds.py", "minima.py")) for place in found):
        yield thresholds.decide_thresholds()
    if any(place.path.endswith("printed_estimates.py") for place in found):
        yield step_printed.decide_step_printed()
    if not found or "spectrum" in parts:
        yield spectrum.decide_spectrum()
    if not found or "classification" in parts:
        yield classification.decide_classification()
    if not found or "elsewhere" in parts:
        yield elsewhere.decide_elsewhere()


def _instead(word: str) -> str:
    from verify.jobs.places import near

    names = near(word)
    return f"is it {', '.join(names)}?" if names else "write a name of a report, or a label"
