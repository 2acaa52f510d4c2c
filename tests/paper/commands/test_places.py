"""Every name of a statement leads to the place in the paper's room where it is written."""

from __future__ import annotations

import re
from pathlib import Path

import pytest

from verify.paper.commands import index, pages, spectrum
from verify.paper.commands.index import near, written
from verify.paper.commands.pages import content, included, names, page
from verify.paper.commands.place import ROOT
from verify.paper.commands.places import places
from verify.paper.theorem1 import theorem


def test_every_row_has_a_place() -> None:
    rows = [row for part in theorem().parts.values() for row in part.obligations]
    for outcome in (pages.decide("all_parameters"), pages.decide("step"), spectrum.cite_spectrum()):
        rows += outcome.statement.obligations
    known = {place.name for place in places()}
    assert {row.name for row in rows} <= known


def test_a_row_of_both_sets_has_one_line() -> None:
    for name in ("init-Cnd4", "set-norms", "zeta-total"):
        places = [p for p in written(name) if p.path == "verify/paper/theorem1.toml"]
        assert {p.name for p in places} == {f"printed.{name}", f"repaired.{name}"}
        assert len({p.line for p in places}) == 1


@pytest.mark.parametrize("name", names())
def test_a_name_of_a_page_is_where_its_line_begins(name: str) -> None:
    """Rows, lemmas and what is given begin an entry there."""
    texts = {f"{name}.toml": content(name), **included(name)}
    lines = {f"verify/paper/{path}": text.decode().splitlines() for path, text in texts.items()}
    found = [place for place in places() if place.path in lines]
    rows = page(name).statement.obligations
    assert len(found) > len(rows) > 5
    assert {row.name for row in rows} <= {place.name for place in found}
    for place in found:
        line = lines[place.path][place.line - 1]
        ends = (place.name, place.name.rpartition(".")[2], place.name.rpartition("-")[0])
        assert any(re.search(rf"(^|[ .']){re.escape(end)}( =|:)", line) for end in ends), place


def test_a_row_of_a_table_has_a_line_of_its_own() -> None:
    """Of two entries with one name the misprint is the printed one."""
    found = {place.name: place for place in written("zeta-time-square")}
    for group in ("printed", "repaired"):
        place = found[f"{group}.zeta-time-square"]
        lines = Path(ROOT, place.path).read_text(encoding="utf-8").splitlines()
        assert lines[place.line - 1].startswith(f"{group}.zeta-time-square:")


def test_a_label_has_its_rows() -> None:
    label = "EQUATSS4.1Recurrence_CndT"
    found = written(label)
    assert {place.label for place in found} == {label}
    assert {place.part for place in found} >= {"", "step"}
    for place in found:  # and the label can be searched for in the file, or in that of its rows
        text = Path(ROOT, place.path).read_text(encoding="utf-8")
        assert label in text or "rows_of" in text, place


def test_a_slip_of_the_pen_finds_its_row() -> None:
    assert near("zeta-totl")[0] == "zeta-total"
    assert near("EQUATSS4.1Recurrence_Cnd_T")[0].startswith("EQUATSS4.1Recurrence_Cnd")
    assert near("qqqqqqqqqq") == []


def test_the_index_has_what_a_search_finds(monkeypatch: pytest.MonkeyPatch, tmp_path: Path) -> None:
    """An index of these sources is believed, and one of other sources is not."""
    monkeypatch.setattr(index, "INDEX", str(tmp_path / "places.txt"))
    words = ("set-x_0", "EQUATSS4.1Recurrence_CndT", "delta_1", "no-such-name")
    try:
        index.lines.cache_clear()
        assert index.lines() is None
        expected = {word: (written(word), near(word)) for word in words}
        Path(index.INDEX).write_text(index.text(places()), encoding="utf-8")
        index.lines.cache_clear()
        assert len(index.lines() or ()) == len(places())
        assert {word: (written(word), near(word)) for word in words} == expected
        monkeypatch.setattr(index, "PAGES", "verify/paper/commands")
        index.lines.cache_clear()
        assert index.lines() is None
    finally:
        index.lines.cache_clear()
