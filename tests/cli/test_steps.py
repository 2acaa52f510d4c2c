"""Long jobs say how far they are, at a terminal only."""

from __future__ import annotations

import inspect
import io
import sys

import pytest

from verify.cli.steps import Clock, Steps, time_in_words, watched
from verify.cli.terminal import erase
from verify.measure import bench


class Terminal(io.StringIO):
    """A stream that somebody watches."""

    def isatty(self) -> bool:
        return True


def test_each_step_and_what_is_left(monkeypatch: pytest.MonkeyPatch) -> None:
    stream = Terminal()
    monkeypatch.setattr(sys, "stderr", stream)
    monkeypatch.setenv("COLUMNS", "80")
    clock = iter([10.0, 20.0])
    monkeypatch.setattr("time.monotonic", lambda: next(clock))
    progress = Steps(3)
    for text in ("one", "two", "three" * 50):
        progress(text)
    erase()
    erase()
    shown = stream.getvalue().split("\r")
    assert shown == [
        "",
        "[1/3] one …\x1b[K",
        "[2/3] two …\x1b[K",
        f"[3/3] {'three' * 50}"[:79] + "\x1b[K",
        "\x1b[K",
    ]


def test_the_first_part_does_not_count(monkeypatch: pytest.MonkeyPatch) -> None:
    """A scan of 5000 points was said to take 29 min after the first one, and took 27 s."""
    now = [0.0]
    monkeypatch.setattr("time.monotonic", lambda: now[0])
    clock, found = Clock(5000), []
    for done in range(1, 5000):
        now[0] += 0.35 if done == 1 else 27 / 5000
        found.append(clock.rest(done))
    assert found[:100] == [""] * 100
    for done, text in enumerate(found, 1):
        assert not text or abs(int(text.split()[1]) - 27 * (5000 - done) / 5000) <= 1
    assert " (about 26 s left)" in found


def test_a_bar_and_what_is_left(monkeypatch: pytest.MonkeyPatch) -> None:
    """The bar is erased before what comes next is printed, and at the end."""
    stream = Terminal()
    monkeypatch.setattr(sys, "stderr", stream)
    clock = iter(range(0, 1000, 10))
    monkeypatch.setattr("time.monotonic", lambda: float(next(clock)))
    for apart in (True, False):
        stream.truncate(0)
        stream.seek(0)
        for part in watched("abcd", 4, apart=apart):
            stream.write(part)
        text = stream.getvalue()
        assert "] 3 of 4 (about " in text
        assert "4 of 4" not in text
        assert text.endswith("\r\x1b[Kd")
        assert ("\r\x1b[Kb" in text) == apart


def test_nothing_is_said_where_nobody_watches(capsys: pytest.CaptureFixture[str]) -> None:
    Steps(2)("one")
    assert list(watched("abc", 3)) == ["a", "b", "c"]
    assert capsys.readouterr() == ("", "")


def test_times_in_words() -> None:
    assert (time_in_words(7.6), time_in_words(99), time_in_words(150)) == ("8 s", "99 s", "2 min")


def test_the_number_of_steps_of_bench() -> None:
    assert inspect.getsource(bench.run_benchmarks).count("    progress(") == bench.STEPS
