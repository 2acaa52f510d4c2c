r"""Which paper it is, and what it prints beside each ``\label``."""

from __future__ import annotations

import os
from functools import cache

from verify.language.statement import PRINTED, Constant
from verify.paper.in_coq import CITED_IN_COQ, IN_COQ, WHOLE_IN_COQ
from verify.paper.parameters import THEOREM
from verify.publication import REPAIRED, Notes, Publication

TABLE = os.path.join(os.path.dirname(os.path.dirname(__file__)), "data", "numbers.json")
_START = '"numbers": '


@cache
def _text() -> str:
    """The table of printed numbers as it is written."""
    with open(TABLE, encoding="utf-8") as file:
        return file.read().partition(_START)[2]


def printed_number(label: str) -> str | None:
    """What one label is called in print: ``(4.25)``, ``Theorem 1``, ``Section 4.1``.

    The table is not read as JSON for that; a label that it does not have has no number.
    """
    _, found, rest = _text().partition(f'"{label}": "')
    return rest.partition('"')[0] if found else None


@cache
def printed_numbers() -> dict[str, str]:
    """Each label with its printed number."""
    import json  # loaded only where it is used

    with open(TABLE, encoding="utf-8") as file:
        return dict(json.load(file)["numbers"])


@cache
def source_sha256() -> str:
    """The SHA-256 of the LaTeX text of the paper that was read."""
    import json  # loaded only where it is used

    with open(TABLE, encoding="utf-8") as file:
        return str(json.load(file)["source_sha256"])


def labels_called(number: str) -> list[str]:
    """The labels of what is called so in print: ``(4.25)``, ``4.25`` or ``Theorem 1``."""
    called = (number, f"({number})")
    return [label for label, known in printed_numbers().items() if known in called]


def notes() -> Notes:
    """What is said of Theorem 1 beside its rows."""
    from verify.paper.theorem1 import theorem  # loaded only where it is used

    found = theorem()
    bounds = {constant.name: ("=", constant) for constant in found.common}
    for item in (item for set_ in (PRINTED, REPAIRED) for item in found.parts[set_].constants):
        if isinstance(item, Constant):
            bounds[item.name] = ("=", item)
        else:
            sign = "≤" if item.direction == "down" else "≥"
            bounds[item.constant.name] = (sign, item.constant)
    return Notes(found.changes, found.causes, found.remarks, bounds)


PAPER = Publication(
    authors="Théophile Dolmaire and Juan J. L. Velázquez",
    title="Collapse of inelastic hard spheres in dimension d ≥ 2",
    companion="arXiv:2403.16905",  # of the same authors; it builds on that
    theorem=THEOREM,
    printed=printed_number,
    folders={
        "step": "certificates/step",
        f"{THEOREM} for all parameters": "certificates/theorem1-all",
    },
    in_coq=IN_COQ,
    cited_in_coq=CITED_IN_COQ,
    whole_in_coq=WHOLE_IN_COQ,
    notes=notes,
    source=source_sha256,
    fatal={"printed.second-assumption-as-printed": "in (4.10), < should be >"},
)
