"""What is believed, and what Coq proves: the line on the terminal, and the table of the pages."""

from __future__ import annotations

import pytest

from docs.generated import RUNS, believed_and_proved
from verify.cli import main


def line(capsys: pytest.CaptureFixture[str], *words: str) -> str:
    """The sentence that a command prints on what is believed."""
    assert main([*words]) == 0
    out = " ".join(capsys.readouterr().out.split())
    return "Rests on " + out.partition("Rests on ")[2].partition(" The sentences:")[0]


def test_coq_has_proved_all_but_the_definition_of_the_step(
    capsys: pytest.CaptureFixture[str],
) -> None:
    expected = (
        "Rests on 9 sentences. Believed: hard-spheres (definition). Proved in Coq: "
        "cauchy-schwarz, bounded-monotone, finite-length, open-condition, glue-next, "
        "glue-collapse, glue-angle, glue-interior."
    )
    assert line(capsys, "theorem1", "--r", "0.03").startswith(expected)
    assert line(capsys, "theorem1", "--all") == expected


def test_what_coq_has_not_proved_is_believed(capsys: pytest.CaptureFixture[str]) -> None:
    found = line(capsys, "classification")
    assert found.startswith("Rests on 14 sentences. Believed: ")
    assert found.endswith("glue-second. Proved in Coq: none.")
    assert "glue-impulse" in found


def test_the_table_of_the_pages_says_the_same() -> None:
    lines = believed_and_proved().split("\n")[2:]
    rows = [[cell.strip() for cell in text.split("|")[1:-1]] for text in lines]
    assert [row[0] for row in rows] == [*RUNS]
    table = {row[0]: row[2:] for row in rows}
    assert table["theorem1 --all"][2] == "hard-spheres (definition)"
    assert table["theorem1 --r R"] == table["theorem1 --all"]
    assert table["separatrix --all"][2] == "limit-map (definition), unending (definition)"
    assert table["map"][0] == "the theorems, not the log"
    assert table["classification"][1] == "–"
    assert "glue-second" in table["scene: finite"][2]
    assert "scene-collapses" in table["scene: collapses"][2]
