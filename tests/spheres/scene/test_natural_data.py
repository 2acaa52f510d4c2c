"""Data as people write them: symmetric, in contact, grazing; exact answers with names."""

from __future__ import annotations

import csv
from fractions import Fraction
from pathlib import Path

import pytest

from tests.spheres.scene.scenes import REST, Rows, scene
from verify.cli import main
from verify.prover import balls
from verify.spheres.scene.decide import EXACT, decide_scene
from verify.spheres.scene.verdict import told
from verify.views.scene import UNDECIDED_CODE, exit_code

TRIPLE, GRAZING, APART, SHARPER = "triple-contact", "grazing", "apart", "sharper"
CORNER = ("1/2", "1/2", "1/2", "1/2")
TRIANGLE = ((0,) * 4, (1, 0, 0, 0), CORNER)
#: Positions, velocities, the reason, the collisions before, and the time of an exact event.
KINDS: dict[str, tuple[Rows, Rows, str, int, str | None]] = {
    "both-meet-one": ((REST, (2, 0), (-2, 0)), (REST, (-1, 0), (1, 0)), TRIPLE, 0, "1"),
    "both-meet-one-unlike": ((REST, (3, 0), ("-7/2", 0)), (REST, (-1, 0), ("5/4", 0)),
                             TRIPLE, 0, "2"),
    "both-meet-one-in-space": (((0, 0, 0), (2, "0.3", "0.1"), (-2, "0.3", "0.1")),
                               ((0, 0, 0), (-1, 0, 0), (1, 0, 0)), TRIPLE, 0, None),
    "rest-in-contact": ((REST, (1, 0), (5, 5)), (REST, REST, REST), APART, 0, None),
    "rest-and-move": ((REST, (1, 0), (-5, 9)), ((1, 0), (1, 0), (2, 0)), APART, 0, None),
    "rest-and-are-hit": ((REST, (1, 0), (4, 0)), ((1, 0), (1, 0), REST), TRIPLE, 0, "2"),
    "rest-and-are-hit-beside": ((REST, (1, 0), (-3, "1/2")), (REST, REST, (1, 0)),
                                TRIPLE, 0, None),
    "rest-and-are-grazed": ((REST, (1, 0), (-3, 1)), (REST, REST, (1, 0)), TRIPLE, 0, "3"),
    "all-rest-in-contact": ((REST, (1, 0), (-1, 0)), (REST, REST, REST), APART, 0, None),
    "a-triangle-rests": (TRIANGLE, ((0,) * 4,) * 3, APART, 0, None),
    "a-triangle-parts": (TRIANGLE, TRIANGLE, APART, 0, None),
    "a-triangle-meets": (TRIANGLE, ((0,) * 4, (-1, 0, 0, 0), CORNER), APART, 1, None),
    "touch-and-recede": ((REST, (1, 0), ("-1.5", "0.1")), (REST, ("0.1", 0), (1, 0)),
                         SHARPER, 2, None),
    "touch-and-slide": ((REST, (1, 0), ("-1.5", "0.1")), (REST, (0, 1), (1, 0)), APART, 1, None),
    "both-touch-and-recede": ((REST, (1, 0), (0, 1)), (REST, (1, 0), (0, 1)), APART, 0, None),
    "touch-and-meet": ((REST, (1, 0), (-1, 0)), (REST, (-1, 0), (-1, 0)), APART, 1, None),
    "graze": ((REST, (-3, 1), (9, "0.2")), (REST, (1, 0), (-1, 0)), GRAZING, 0, "3"),
    "graze-twice": ((REST, (-3, 1), (5, -1)), (REST, (1, 0), (-1, 0)), GRAZING, 0, "3"),
    "graze-twice-at-once": ((REST, (-3, 1), (3, -1)), (REST, (1, 0), (-1, 0)), TRIPLE, 0, "3"),
    "graze-and-meet-at-once": ((REST, (-3, 1), (4, 0)), (REST, (1, 0), (-1, 0)), TRIPLE, 0, "3"),
    "graze-after-a-collision": ((REST, (2, 0), (-9, 1)), (REST, (-1, 0), (1, 0)),
                                GRAZING, 1, "1903/303"),
    "meet-after-a-collision": (((0, 5), (2, 0), (-2, 0)), ((0, -1), (-1, 0), (1, 0)),
                               TRIPLE, 1, None),
}  # fmt: skip


@pytest.mark.parametrize("name", KINDS)
def test_natural_data_have_exact_answers(name: str) -> None:
    places, speeds, reason, count, time = KINDS[name]
    found = decide_scene(scene("0.03", places, speeds))
    assert (found.name, found.collisions) == (reason, count)
    assert exit_code(told(found)) == (UNDECIDED_CODE if reason in EXACT else 0)
    assert (found.event is not None) == (reason in EXACT)
    assert found.flow.bits == 128, "more bits would not decide it"
    if found.event is not None and time is not None:
        assert balls.fraction_of(found.event.time) == Fraction(time)


def test_a_script_finds_reason_and_time_in_the_table(tmp_path: Path) -> None:
    folder, table = tmp_path / "scenes", tmp_path / "table.csv"
    folder.mkdir()
    for name in ("both-meet-one", "graze", "rest-in-contact"):
        places, speeds, *_ = KINDS[name]
        rows = [[[str(x) for x in row] for row in rows] for rows in (places, speeds)]
        text = f'r = "0.03"\npositions = {rows[0]}\nvelocities = {rows[1]}\n'
        (folder / f"{name}.toml").write_text(text, encoding="utf-8")
    assert main(["scene", str(folder), "--csv", str(table)]) == UNDECIDED_CODE
    with table.open(encoding="utf-8") as file:
        rows_of = {row["file"]: row for row in csv.DictReader(file)}
    seen = {name: (row["reason"], row["event_time_low"]) for name, row in rows_of.items()}
    assert seen == {
        "both-meet-one.toml": (TRIPLE, "1"),
        "graze.toml": (GRAZING, "3"),
        "rest-in-contact.toml": (APART, ""),
    }
