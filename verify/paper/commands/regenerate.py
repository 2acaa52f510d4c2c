"""Is a statement the one that the program makes, and calls proved?

A certificate for a weaker theorem checks, because the checker does not know the paper. This module
does: it takes only the parameters from the statement and makes everything else anew.
"""

from __future__ import annotations

import json
from collections.abc import Callable, Iterator, Mapping
from functools import partial

from verify.language.statement import PROVED, Statement
from verify.language.terms import Term
from verify.paper.commands import box, pages, scene, separatrix, spectrum, theorem1
from verify.paper.commands.certificates import THEOREMS
from verify.paper.parameters import ALL_PARAMETERS, REPAIRED
from verify.prover.outcome import Outcome
from verify.spheres.parameters import are_allowed
from verify.wire.term_json import TermReader
from verify.wire.write import write

#: The sets of constants with which Theorem 1 is proved; the printed set alone proves nothing.
SELECTIONS = ("all", REPAIRED)

#: What states the theorems without parameters that take long to decide.
ONLY_STATED: dict[str, Callable[[], Statement]] = {
    ALL_PARAMETERS: partial(pages.statement, "all_parameters"),
    "THEORSS3.5SpectMatricVitLm": spectrum.state_spectrum,
}


def is_right_statement(content: bytes) -> bool:
    """Whether the bytes are those of a statement that the program makes and calls proved.

    The parameters in it must be allowed ones. What is compared has a verdict on the needed rows,
    and that verdict is `proved`.
    """
    try:
        document = json.loads(content)
        theorem = str(document["theorem"])
        parameters = TermReader().table(document["parameters"])
        rows = document["obligations"]
        collisions = sum(row["name"].startswith("collision.") for row in rows)
    except (KeyError, TypeError, ValueError, AttributeError, IndexError, RecursionError):
        return False
    return any(
        outcome.claimed == PROVED and _written(outcome) == content
        for outcome in _outcomes(theorem, parameters, collisions, len(rows))
    )


def is_right_when_accepted(content: bytes, accepted: Outcome) -> bool:
    """The same for a statement whose certificate is accepted: every verdict in it is certain.

    So only the claims are made anew where it would take long to decide them again.
    """
    if accepted.statement.theorem not in ONLY_STATED or accepted.statement.parameters:
        return is_right_statement(content)
    stated = ONLY_STATED[accepted.statement.theorem]()
    own = Outcome(stated, accepted.decisions, (), {})
    return own.claimed == PROVED and _written(own) == content


def _written(outcome: Outcome) -> bytes | None:
    """The bytes of the statement; None if a number in it has more digits than can be written."""
    try:
        return write(outcome)["statement.json"]
    except ValueError:
        return None


def _outcomes(
    theorem: str, parameters: Mapping[str, Term], collisions: int, rows: int
) -> Iterator[Outcome]:
    """The outcomes that the program makes for a theorem of this name and these parameters."""
    if not parameters:
        yield from (one.decide() for one in THEOREMS if one.name == theorem)
    elif (found := scene.read_back(parameters)) is not None:
        yield from scene.statements_of(found, collisions)
    elif (point := separatrix.read_point(parameters)) is not None:
        yield from separatrix.outcomes_at(point, rows)
    elif box.are_ends(parameters):
        yield box.decide_box(*box.read_box(parameters))
    elif are_allowed(parameters):
        if (
            theorem == "step-printed"
            and parameters == pages.statement("step_as_printed").parameters
        ):
            yield pages.decide("step_as_printed")
        for selection in SELECTIONS:
            yield theorem1.decide_point(parameters, selection)
