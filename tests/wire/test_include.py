"""Pages that include others, and what their chapters share."""

from __future__ import annotations

from pathlib import Path

import pytest

from verify.language.argument import Argument
from verify.language.statement import PROVED, REFUTED
from verify.paper.commands import pages
from verify.prover.arguments import write_down
from verify.wire.inputs import InputError
from verify.wire.judge import judged
from verify.wire.text.read_page import read_page
from verify.wire.toml import toml_of

CHART = """
[contexts.c]
variables = ["x"]
point = { x = 1 }
[contexts.c.given]
positive = "0 < x"
[contexts.c.constants]
a = "min(x, 2*x)"
[[chapters]]
in = "c"
facts = "positive"
"""
PAGE = """title = "t"
include = "chart.toml"
[contexts.c.constants]
b = "a + x"
[[chapters]]
in = "c"
[chapters.rows]
least = { claim = "0 < a", rule = "least", of = "a", says = "a" }
a-entry = { entries = "a", says = "entry {i}" }
square = { claim = "0 < x^2 + x", says = "s" }
value = { claim = "a < b", at = "x = 2", says = "v" }
wrong = { claim = "x < 0", verdict = "refuted", role = "printed", says = "w" }
"""


def written(folder: Path, **files: str) -> Path:
    for name, text in files.items():
        (folder / f"{name}.toml").write_text(text)
    return folder / "page.toml"


def test_a_page_has_what_it_includes(tmp_path: Path) -> None:
    path = written(tmp_path, page=PAGE, chart=CHART)
    page = read_page(str(path), path.read_bytes())
    outcome = judged(write_down(Argument(page.statement, page.chapters)))
    found = {name: decision.verdict for name, decision in outcome.decisions.items()}
    assert found.pop("wrong") == REFUTED
    assert [*found] == ["least", "a-entry-1", "a-entry-2", "square", "value"]
    assert set(found.values()) == {PROVED}
    assert outcome.statement.obligations[-2].context is None
    assert [c.name for c in page.statement.contexts[0].constants] == ["a", "b"]


@pytest.mark.parametrize(
    ("files", "words"),
    [
        ({"chart": 'include = "page.toml"\n' + CHART}, ("chart.toml, line 1", "page.toml")),
        ({}, ("page.toml, line 2", "chart.toml")),
        ({"chart": CHART.replace("0 < x", "0 < z")}, ("chart.toml, line 6", "z")),
        ({"chart": CHART + '[chapters.rows]\nl = "0 <'}, ("chart.toml",)),
        ({"chart": 'rows_of = "page.toml"\n' + CHART}, ("chart.toml, line 1", "rows_of")),
        ({"chart": "#" * (1 << 21)}, ("page.toml, line 2", "chart.toml", "bytes")),
        ({"chart": CHART.replace('a = "', 'b = "')}, ("page.toml, line 4", "included")),
    ],
)
def test_what_cannot_be_included_is_refused(
    files: dict[str, str], words: tuple[str, ...], tmp_path: Path
) -> None:
    path = written(tmp_path, page=PAGE, **files)
    with pytest.raises(InputError) as error:
        read_page(str(path), path.read_bytes())
    assert all(word in str(error.value) for word in words), str(error.value)


@pytest.mark.parametrize("name", pages.names())
def test_the_digest_of_a_page_covers_what_it_includes(name: str) -> None:
    table, _ = toml_of(name, pages.content(name), "")
    assert bool({"include", "rows_of"} & {*table}) == bool(pages.included(name))
    assert all(text in pages.whole(name) for text in pages.included(name).values())


STATED = """
title = "At a point"
[parameters]
a = "1/2"
[[chapters]]
group = "squares"
[chapters.rows]
small = { claim = "a^2 < a", says = "the square is smaller", label = "(1)" }
large = { claim = "1 < a", says = "a is large", role = "printed", severity = "slip" }
"""
SHOWN = """
title = "For all"
rows_of = "stated.toml"
[contexts.all]
variables = "a"
given = ["0 < a", "a < 1"]
[[chapters]]
in = "all"
group = "here"
rows = """
SHOWN_ROWS = "'small: a^2 < a; by all.1 all.2; label (2); new: a < 2; by all.2'"


def test_a_page_shows_the_rows_of_another(tmp_path: Path) -> None:
    """Of a row with the same name the other page says what it means."""
    text = SHOWN + SHOWN_ROWS
    path = written(tmp_path, page=text, stated=STATED)
    rows = {row.name: row for row in read_page(str(path), path.read_bytes()).statement.obligations}
    assert (rows["small"].says, rows["small"].label) == ("the square is smaller", "(2)")
    assert (rows["small"].group, rows["new"].group, rows["new"].says) == ("squares", "here", "")


@pytest.mark.parametrize(
    ("stated", "rows", "words"),
    [
        (STATED, "'small: a^3 < a; by all.1'", ("page.toml", "small", "another claim")),
        ("rows_of = 'page.toml'\n" + STATED, SHOWN_ROWS, ("stated.toml", "rows_of")),
        ("", SHOWN_ROWS, ("stated.toml", "title")),
        ("title = 1", SHOWN_ROWS, ("stated.toml", "rows")),
    ],
)
def test_another_claim_of_a_row_is_refused(
    stated: str, rows: str, words: tuple[str, ...], tmp_path: Path
) -> None:
    path = written(tmp_path, page=SHOWN + rows, stated=stated)
    with pytest.raises(InputError) as error:
        read_page(str(path), path.read_bytes())
    assert all(word in str(error.value) for word in words), str(error.value)


def test_the_other_page_has_to_be_there(tmp_path: Path) -> None:
    path = written(tmp_path, page=SHOWN + SHOWN_ROWS)
    with pytest.raises(InputError, match=r"stated\.toml"):
        read_page(str(path), path.read_bytes())


@pytest.mark.parametrize(("count", "is_read"), [(90, True), (3000, False)])
def test_a_long_chain_of_pages(count: int, is_read: bool, tmp_path: Path) -> None:
    for i in range(count):
        (tmp_path / f"{i}.toml").write_text(f'include = "{i + 1}.toml"')
    (tmp_path / f"{count}.toml").write_text('rows = "x: 1 < 2"')
    page = b'title = "t"\ninclude = "0.toml"'
    path = str(tmp_path / "page.toml")
    if is_read:
        assert [row.name for row in read_page(path, page).statement.obligations] == ["x"]
    else:
        with pytest.raises(InputError):
            read_page(path, page)
