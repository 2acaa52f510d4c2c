r"""What the paper prints beside each ``\label``: the number of the formula, section or theorem."""

from __future__ import annotations

import os
from collections.abc import Iterable, Mapping
from functools import cache

TABLE = os.path.join(os.path.dirname(os.path.dirname(__file__)), "data", "numbers.json")


@cache
def printed_numbers() -> Mapping[str, str]:
    """Each label with what it is called in print: ``(4.25)``, ``Theorem 1``, ``Section 4.1``."""
    import json  # loaded only where it is used

    return dict(json.loads(_text())["numbers"])


@cache
def _text() -> str:
    with open(TABLE, encoding="utf-8") as file:
        return file.read()


def printed_number(label: str) -> str:
    """What one label is called in print, or the label itself, without reading all of the table."""
    _, found, rest = _text().partition(f'"{label}": "')
    return rest.partition('"')[0] if found else label


def is_in_paper(labels: Iterable[str]) -> bool:
    """Whether one of the labels is the paper's: a statement without any is somebody else's."""
    return any(label and printed_number(label) != label for label in labels)


def labels_called(number: str) -> list[str]:
    """The labels of what is called so in print: ``(4.25)``, ``4.25`` or ``Theorem 1``."""
    called = (number, f"({number})")
    return [label for label, known in printed_numbers().items() if known in called]


def cited(label: str) -> str:
    """A label with its printed number before it; a label that has none as it is."""
    number = printed_numbers().get(label)
    return label if number is None else f"{number}, {label}"
