"""Each page is the statement of its committed certificate, and the checker accepts it."""

from __future__ import annotations

from pathlib import Path
from typing import Any

import pytest

from verify.cli import main
from verify.language.statement import PROVED
from verify.paper.commands import pages
from verify.paper.commands.citing import COLLAPSE
from verify.paper.commands.theorem1 import decide_point
from verify.prover.arguments import write_down
from verify.wire.judge import judged
from verify.wire.packaged import PACKAGED, PAGES, became
from verify.wire.text import Page
from verify.wire.write import write

#: Commands that rest on pages, and need not read them.
WORDS = (
    "classification --r 3/100",
    "elsewhere",
    "separatrix --all",
    "theorem1 --all",
    "spectrum",
    "scene certificates/scenes/in-space.toml",
)

#: A test of `verify/wire/packaged.py` says that these are those of `certificates`.
DATA = Path(PACKAGED)
NAMES = sorted(PAGES)
#: What is proved for the parameters of a command has no certificate here.
AT_A_POINT = "theorem1"


def test_every_page_has_a_certificate() -> None:
    assert pages.names() == sorted([*PAGES, AT_A_POINT])


@pytest.mark.parametrize("name", NAMES)
def test_a_page_is_the_statement_of_its_certificate(name: str) -> None:
    outcome = pages.decide(name)
    files = write(outcome)
    assert outcome.verdict == PROVED
    for file in ("statement.json", "certificate.json"):
        assert files[file] == (DATA / PAGES[name][0] / file).read_bytes()


def test_the_page_of_theorem_1_is_proved_at_its_own_point() -> None:
    """Every row has the verdict that the command finds, and the chosen constants are the same."""
    found = pages.decide(AT_A_POINT)
    own = decide_point(found.statement.parameters)
    verdicts = {row.name: decision.verdict for row, decision in own.rows if row.name != COLLAPSE}
    assert {row.name: decision.verdict for row, decision in found.rows} == verdicts
    assert found.statement.constants == own.statement.constants
    assert found.verdict == PROVED


# --- without reading the page ---------------------------------------------------------------------


@pytest.mark.parametrize("name", NAMES)
def test_what_came_with_the_program_is_what_the_page_says(name: str) -> None:
    """If the digest is not that of the page: python -m tests.bring."""
    assert became(name, pages.whole(name)) == PAGES[name][0]
    assert pages.statement(name) == pages.page(name).statement
    assert pages.accepted(name) == pages.decide(name)
    assert pages.cite(name).content == write(pages.decide(name))["statement.json"]


@pytest.mark.parametrize("words", WORDS)
def test_a_command_does_not_read_a_page(words: str, monkeypatch: pytest.MonkeyPatch) -> None:
    def never(name: str) -> Page:
        raise AssertionError(f"{words} reads {name}")

    for function in (pages.statement, pages.accepted, pages.cite, pages.decide):
        function.cache_clear()
    monkeypatch.setattr(pages, "page", never)
    assert main(words.split()) == 0


@pytest.mark.parametrize("function", [pages.statement, pages.accepted, pages.cite])
def test_a_changed_page_is_read(function: Any, monkeypatch: pytest.MonkeyPatch) -> None:
    """Anything else than the recorded text is a page of its own, and has the title that it says."""
    text = pages.content("line")
    for changed in (text.replace(b'title = """', b'title = """Lo: ', 1), text + b"\n"):
        assert changed != text
        monkeypatch.setattr(pages, "content", lambda name, changed=changed: changed)
        pages.page.cache_clear()
        pages.decide.cache_clear()
        function.cache_clear()
        assert became("line", changed) is None
        found = str(function("line"))
        assert ("Lo: " in found) == (b"Lo: " in changed)
    monkeypatch.undo()
    pages.page.cache_clear()
    pages.decide.cache_clear()
    function.cache_clear()


@pytest.mark.parametrize("name", [*filter(pages.is_argued, NAMES)])
def test_a_page_is_proved_without_its_certificate(name: str) -> None:
    """Where a line has names only, the sum is found, and the checker accepts it."""
    assert judged(write_down(pages.argument(name))).verdict == PROVED
