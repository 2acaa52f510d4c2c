"""The table of printed numbers covers each label that the program cites."""

from __future__ import annotations

import re
from pathlib import Path

import verify
from verify.paper.glossary import LETTERS
from verify.paper.source import PAPER, labels_called, printed_number, printed_numbers
from verify.views.plots.letters import letters_drawing

PREFIXES = "EQUAT|THEOR|PROPO|SECTION|SECT|SSECT|SSSCT|DEFIN|LEMME|REMAR|APPEN"
LABEL = re.compile(rf'"((?:{PREFIXES})S?[^" {{}}]{{6,}})"')
#: The same in the text of a page.
IN_TEXT = re.compile(rf"\blabel\s+((?:{PREFIXES})[^\s;]{{6,}}?)(?=;|'''|\n)")
ROOMS = ("paper", "spheres", "views")


def test_every_label_in_the_code_is_one_of_the_paper() -> None:
    root = Path(verify.__file__).parent
    texts = (
        path.read_text()
        for room in ROOMS
        for path in (root / room).rglob("*")
        if path.suffix in (".py", ".toml")
    )
    labels = {label for text in texts for kind in (LABEL, IN_TEXT) for label in kind.findall(text)}
    assert len(labels) > 50
    assert labels <= set(printed_numbers())


def test_the_numbers_are_those_of_the_print() -> None:
    assert PAPER.cited("EQUATSS4.1Recurrence_Cnd9") == "(4.53), EQUATSS4.1Recurrence_Cnd9"
    assert printed_numbers()["THEORSS4.1ExistenCollapse"] == "Theorem 1"
    assert PAPER.cited("no-label") == "no-label"


def test_one_number_is_read_as_all_are() -> None:
    for label, number in printed_numbers().items():
        assert printed_number(label) == number
    for other in ("no-label", "source_sha256", "numbers", ""):
        assert printed_number(other) is None
        assert PAPER.number(other) == other


def test_a_number_leads_to_its_labels() -> None:
    assert labels_called("(4.53)") == labels_called("4.53") == ["EQUATSS4.1Recurrence_Cnd9"]
    assert labels_called("Theorem 1") == ["THEORSS4.1ExistenCollapse"]
    assert labels_called("EQUATSS4.1Recurrence_Cnd9") == []


def test_every_letter_of_the_glossary_has_a_place_in_the_paper() -> None:
    assert {letter.label for letter in LETTERS} <= set(printed_numbers())
    shown = letters_drawing()
    for letter in ("ω", "W", "η", "θ"):
        assert f">{letter}<" in shown
