"""Random pages: what is said to be proved is true, and what is refuted is false somewhere."""

from __future__ import annotations

import pytest

from tests.wire.random_pages import Pages, Row
from verify.language.statement import PROVED, REFUTED, UNDECIDED
from verify.prover.budget import WorkBudget
from verify.wire.inputs import InputError
from verify.wire.questions import decide_page
from verify.wire.text.read_page import read_page

WORK, TOGETHER = 30_000, 20


def wrong(drawn: Pages, row: Row, verdict: str) -> bool:
    """Whether a verdict contradicts the values of a row at points."""
    true = [drawn.is_true(row, values) for values in drawn.points(row.context)]
    if verdict == PROVED:
        return not all(true)
    return verdict == REFUTED and row.negated and any(true)


def judged(seed: int) -> int:
    """How many rows of a page have right verdicts, which is compared; 0 if it cannot be used."""
    drawn = Pages(seed)
    try:
        page = read_page("p.toml", drawn.text.encode())
        outcome = decide_page(page, WorkBudget(WORK))
    except InputError as error:
        if "\n" in str(error) or not str(error).startswith("p.toml"):
            raise
        return 0
    verdicts = {row.name: found.verdict for row, found in outcome.rows}
    asked = [(row, verdicts[row.name]) for row in drawn.rows if row.name in verdicts]
    assert not [(seed, row.name) for row, verdict in asked if wrong(drawn, row, verdict)]
    return sum(verdict != UNDECIDED for _, verdict in asked)


@pytest.mark.parametrize("first", range(0, 80, TOGETHER))
def test_pages_mean_what_they_look_like(first: int) -> None:
    assert sum(map(judged, range(first, first + TOGETHER))) > TOGETHER
