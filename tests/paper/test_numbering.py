"""The table of printed numbers covers each label that the program cites."""

from __future__ import annotations

import re
from pathlib import Path

import verify
from verify.paper.numbering import cited, printed_numbers

PREFIXES = "EQUAT|THEOR|PROPO|SECTION|SECT|SSECT|SSSCT|DEFIN|LEMME|REMAR|APPEN"
LABEL = re.compile(rf'"((?:{PREFIXES})S?[^" {{}}]{{6,}})"')
ROOMS = ("paper", "jobs", "views")


def test_every_label_in_the_code_is_one_of_the_paper() -> None:
    root = Path(verify.__file__).parent
    texts = (path.read_text() for room in ROOMS for path in (root / room).rglob("*.py"))
    labels = {label for text in texts for label in LABEL.findall(text)}
    assert len(labels) > 50
    assert labels <= set(printed_numbers())


def test_the_numbers_are_those_of_the_print() -> None:
    assert cited("EQUATSS4.1Recurrence_Cnd9") == "(4.53), EQUATSS4.1Recurrence_Cnd9"
    assert printed_numbers()["THEORSS4.1ExistenCollapse"] == "Theorem 1"
    assert cited("no-label") == "no-label"
