"""A limit of time is kept, also where a technique counts no work or the check takes long."""

from __future__ import annotations

import gc
import signal
import sys
import time
from contextlib import contextmanager
from types import SimpleNamespace
from typing import Any

import pytest

from tests.prover.test_interior import page
from verify.prover import techniques
from verify.prover.budget import SpentError, WorkBudget
from verify.prover.proof import Proof
from verify.prover.search.question import Question
from verify.prover.techniques import Technique
from verify.wire.questions import Reading, decide, read_page_of

SECONDS = 1.0
#: What a loaded machine needs besides.
MORE = 1.5
MANY = [f"x{i}" for i in range(20)]


def endless(_question: Question) -> Proof | None:
    while True:
        pass


def test_a_technique_that_counts_nothing_is_ended(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(techniques, "FREE", (Technique("endless", endless),))
    asked = read_page_of("a.toml", page(["x"], ["0 <= x"], "0 <= x + 1"), {}).statement
    begin = time.monotonic()
    found = decide(asked, WorkBudget(seconds=SECONDS))
    assert time.monotonic() - begin < 1.5 * SECONDS + MORE
    assert found.decisions["row"].verdict == "undecided"
    assert "--time" in found.decisions["row"].reason


@pytest.mark.parametrize(
    ("variables", "given", "row"),
    [
        (["x"], ["0 <= x <= 1/2"], "sum(x^k, k, 0, 500) <= 2"),
        (["x"], ["x <= x"], "0 <= x^900 - 900*x + 899"),
        (MANY, ["x0 <= 1"], f"0 <= ({'+'.join(MANY)})^4 + 1 - x0"),
    ],
)  # fmt: skip
def test_hard_rows_end_in_time(variables: list[str], given: list[str], row: str) -> None:
    asked = read_page_of("a.toml", page(variables, given, row), {}).statement
    begin = time.monotonic()
    found = decide(asked, WorkBudget(seconds=SECONDS))
    assert time.monotonic() - begin < 1.5 * SECONDS + MORE
    assert "search failed" not in found.decisions["row"].reason


def test_what_is_proved_in_time_is_kept() -> None:
    text = page(["x"], ["0 <= x <= 1/2"], "x <= 1").decode()
    text += 'hard = "sum(x^k, k, 0, 500) <= 2"\nlast = "x <= 2"\n'
    found = decide(read_page_of("a.toml", text.encode(), {}).statement, WorkBudget(seconds=3))
    assert [d.verdict for d in found.decisions.values()] == ["proved", "undecided", "proved"]


def test_an_alarm_at_the_end_of_a_check_ends_no_program(monkeypatch: pytest.MonkeyPatch) -> None:
    """A check that is over by a hair rings where its answer is already on the way."""
    price = Reading.price

    def slow(self: Reading, *row: Any) -> str:
        found = price(self, *row)
        if row[0] is not None:
            time.sleep(SECONDS)
        return found

    monkeypatch.setattr(Reading, "price", slow)
    asked = read_page_of("a.toml", page(["x"], ["0 <= x"], "0 <= x + 1"), {}).statement
    found = decide(asked, WorkBudget(seconds=SECONDS / 2))
    assert found.decisions["row"].verdict in ("proved", "undecided")


def test_an_alarm_is_silent_where_its_block_is_left() -> None:
    """An error there would leave it ringing, in whatever comes next."""
    ended = contextmanager(lambda: iter([0]))().__exit__
    inner = (ended.__func__.__code__, WorkBudget.alarm.__wrapped__.__code__)
    with WorkBudget(seconds=60).alarm():
        ring: Any = signal.getsignal(signal.SIGALRM)
        for code in inner:
            ring(signal.SIGALRM, SimpleNamespace(f_code=code))
        with pytest.raises(SpentError):
            ring(signal.SIGALRM, sys._getframe())


def test_an_alarm_rings_only_inside() -> None:
    budget = WorkBudget(seconds=0.05)
    with pytest.raises(SpentError, match="--time"), budget.alarm():
        time.sleep(5)
    time.sleep(0.1)
    with WorkBudget().alarm():
        time.sleep(0.01)


@pytest.mark.filterwarnings("error::pytest.PytestUnraisableExceptionWarning")
def test_an_alarm_that_was_lost_rings_again() -> None:
    """An error in a callback of the garbage collector ends nothing, and nothing is said of it."""
    begin = time.monotonic()

    def callback(_phase: str, _info: dict[str, int]) -> None:
        while time.monotonic() < begin + 0.3:
            pass

    budget = WorkBudget(seconds=0.05)
    budget.begin("row", 1)
    gc.callbacks.append(callback)

    def collect() -> None:
        with budget.alarm():
            gc.collect()
            while time.monotonic() < begin + 5:
                pass

    with pytest.raises(SpentError, match="--time"):
        collect()
    assert time.monotonic() < begin + 4
