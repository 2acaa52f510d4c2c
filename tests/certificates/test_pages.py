"""The committed pages of constants: their certificates are about them, and are found again."""

from __future__ import annotations

from pathlib import Path

import pytest

from verify.language.statement import PROVED
from verify.paper.source import PAPER
from verify.views.markdown import report
from verify.wire.judge import read_judged
from verify.wire.questions import decide
from verify.wire.text.read_page import read_page

EXAMPLES = Path(__file__).parents[2] / "certificates/examples"
PAGES = sorted(EXAMPLES.glob("*.toml"))


@pytest.mark.parametrize("path", PAGES, ids=lambda path: path.stem)
def test_a_page_has_its_certificate_and_report(path: Path) -> None:
    page, folder = read_page(str(path), path.read_bytes()), path.with_suffix("")
    files = ((folder / f"{name}.json").read_bytes() for name in ("statement", "certificate"))
    stored = read_judged(*files, {})
    assert stored.statement == page.statement
    assert {found.verdict for _, found in stored.rows} == {PROVED}
    assert (folder / "report.md").read_text(encoding="utf-8") == report(stored, PAPER)


@pytest.mark.parametrize("path", PAGES, ids=lambda path: path.stem)
def test_a_page_is_proved_anew(path: Path) -> None:
    page = read_page(str(path), path.read_bytes())
    assert {found.verdict for _, found in decide(page.statement, None, page.hints).rows} == {PROVED}


def test_the_pages_are_there() -> None:
    assert len(PAGES) >= 3
