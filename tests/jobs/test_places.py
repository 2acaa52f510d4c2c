"""Every name of a statement leads to the place in the paper's room where it is written."""

from __future__ import annotations

from verify.jobs import everywhere, spectrum, step
from verify.jobs.places import ROOT, near, places, written
from verify.paper.theorem1 import theorem


def test_every_row_has_a_place() -> None:
    rows = [row for part in theorem().parts.values() for row in part.obligations]
    for outcome in (everywhere.decide_everywhere(), step.decide_step(), spectrum.decide_spectrum()):
        rows += outcome.statement.obligations
    known = {place.name for place in places()}
    assert {row.name for row in rows} <= known


def test_a_place_is_where_the_row_is_written() -> None:
    """Its own words stand there: the yield that makes it names it within the next few lines."""
    for name in (
        "repaired.init-Cnd4",
        "repaired.set-x_0",
        "next-d-one",
        "next-d-small",
        "matrix-stated",
    ):
        (place,) = (p for p in written(name) if p.part in ("", "step", "spectrum"))
        lines = (ROOT / place.path).read_text(encoding="utf-8").splitlines()
        near_by = "\n".join(lines[place.line - 2 : place.line + 6])
        assert f'"{name.rpartition(".")[2]}"' in near_by, name


def test_a_label_has_its_rows() -> None:
    label = "EQUATSS4.1Recurrence_CndT"
    found = written(label)
    assert {place.label for place in found} == {label}
    assert {place.part for place in found} >= {"", "step"}
    for place in found:  # and the label itself can be searched for in the file
        assert label in (ROOT / place.path).read_text(encoding="utf-8"), place


def test_a_slip_of_the_pen_finds_its_row() -> None:
    assert near("zeta-totl")[0] == "zeta-total"
    assert near("EQUATSS4.1Recurrence_Cnd_T")[0].startswith("EQUATSS4.1Recurrence_Cnd")
    assert near("qqqqqqqqqq") == []
