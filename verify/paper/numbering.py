r"""What the paper prints beside each ``\label``: the number of the formula, section or theorem."""

from __future__ import annotations

import json
from collections.abc import Mapping
from functools import cache
from importlib import resources


@cache
def printed_numbers() -> Mapping[str, str]:
    """Each label with what it is called in print: ``(4.25)``, ``Theorem 1``, ``Section 4.1``."""
    table = resources.files("verify").joinpath("data", "numbers.json").read_text(encoding="utf-8")
    return dict(json.loads(table)["numbers"])


def labels_called(number: str) -> list[str]:
    """The labels of what is called so in print: ``(4.25)``, ``4.25`` or ``Theorem 1``."""
    called = (number, f"({number})")
    return [label for label, known in printed_numbers().items() if known in called]


def cited(label: str) -> str:
    """A label with its printed number before it; a label that has none as it is."""
    number = printed_numbers().get(label)
    return label if number is None else f"{number}, {label}"
