"""Each page is the statement of its committed certificate, and the checker accepts it."""

from __future__ import annotations

from pathlib import Path

import pytest

from verify.language.statement import PROVED
from verify.paper.commands.pages import decide
from verify.wire.write import write

#: The pages of arguments, with the folders of their certificates.
PAGES = {
    "classification": "classification",
    "line": "line",
    "sandwich_above": "outside",
    "sandwich_below": "sandwich",
    "sections_1_to_4": "elsewhere",
    "separatrix": "separatrix",
    "sharper": "sharper",
    "step": "step",
}
CERTIFICATES = Path(__file__).parents[2] / "certificates"


@pytest.mark.parametrize("name", PAGES)
def test_a_page_is_the_statement_of_its_certificate(name: str) -> None:
    outcome = decide(name, PAGES[name])
    files = write(outcome)
    assert outcome.verdict == PROVED
    for file in ("statement.json", "certificate.json"):
        assert files[file] == (CERTIFICATES / PAGES[name] / file).read_bytes()
