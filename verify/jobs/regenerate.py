"""Is a statement the one that the program makes from its parameters?

A certificate for a weaker theorem checks, because the checker does not know the paper. This module
does: it reads only the parameters out of the statement and makes everything else anew.
"""

from __future__ import annotations

import json
from collections.abc import Iterator

from verify.jobs import spectrum
from verify.wire import spectrum_wire
from verify.language.terms import Term
from verify.jobs.theorem1 import SELECTIONS, decide
from verify.wire.wire import files, term_from_document


def is_right_statement(content: bytes) -> bool:
    """Whether the bytes are those of the statement made anew from the parameters in it."""
    try:
        document = json.loads(content)
        parameters = {
            name: term_from_document(term) for name, term in document["parameters"].items()
        }
        return content in _statements(parameters)
    except (KeyError, TypeError, ValueError, AttributeError, RecursionError):
        return False


def _statements(parameters: dict[str, Term]) -> Iterator[bytes]:
    """The statements that the program makes from these parameters."""
    if not parameters:
        yield spectrum_wire.files(spectrum.decide())["statement.json"]
        return
    for selection in SELECTIONS:
        yield files(decide(parameters, selection))["statement.json"]
