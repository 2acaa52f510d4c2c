"""Is a statement the one that the program makes from its parameters?

A certificate for a weaker theorem checks, because the checker does not know the paper. This module
does: it reads only the parameters out of the statement and makes everything else anew.
"""

from __future__ import annotations

import json
from typing import Any

from verify.theorem1 import SELECTIONS, decide
from verify.wire import WireError, files, term_from_document


def is_right_statement(content: bytes) -> bool:
    """Whether the bytes are those of the statement made anew from the parameters in it."""
    try:
        document = json.loads(content)
        parameters = {
            name: term_from_document(term) for name, term in document["parameters"].items()
        }
        return _is_theorem1(content, parameters)
    except (KeyError, TypeError, ValueError, AttributeError, RecursionError, WireError):
        return False


def _is_theorem1(content: bytes, parameters: dict[str, Any]) -> bool:
    return any(
        files(decide(parameters, selection))["statement.json"] == content
        for selection in SELECTIONS
    )
