"""What holds in each test, and which tests a person need not wait for.

`pytest` without a file leaves out the tests in `slow.txt`, which take most of the time; `pytest -m
slow` runs them, as CI does, and a file that is named is run as it is.
"""

from __future__ import annotations

import gc
import signal
import sys
from collections.abc import Iterator
from pathlib import Path

import pytest

SLOW = Path(__file__).with_name("slow.txt").read_text(encoding="utf-8").split()


def pytest_configure(config: pytest.Config) -> None:
    """The marker is known; whoever starts tests in the background ignores no signal of theirs."""
    signal.signal(signal.SIGINT, signal.default_int_handler)
    for number in (signal.SIGTERM, signal.SIGHUP):
        signal.signal(number, signal.SIG_DFL)
    config.addinivalue_line("markers", "slow: left out where no file is named; see slow.txt")


def pytest_collection_modifyitems(config: pytest.Config, items: list[pytest.Item]) -> None:
    """Mark slow tests; where the whole suite is run, and no marker is asked for, leave them out."""
    slow, names = [], set()
    for item in items:
        test = item.nodeid.partition("[")[0]
        found = {test, test.partition("::")[0]} & {*SLOW}
        names |= found
        if found:
            item.add_marker("slow")
            slow.append(item)
    if [Path(name).name for name in config.args] != [Path(__file__).parent.name]:
        return
    stale = [name for name in SLOW if name not in names]
    if stale:
        raise pytest.UsageError(f"tests/slow.txt: there is no test {', '.join(stale)}")
    if not config.option.markexpr and not config.option.keyword:
        config.hook.pytest_deselected(items=slow)
        items[:] = [item for item in items if not item.get_closest_marker("slow")]


def pytest_terminal_summary(terminalreporter: pytest.TerminalReporter) -> None:
    """Where tests fail, and the program has changed since its certificates were made, say so."""
    if not terminalreporter.stats.get("failed"):
        return
    from verify.paper.commands import index  # loaded only where it is used

    if index.lines() is None:
        terminalreporter.write_line(
            "verify/data was made by another version of the program, which may be why tests fail: "
            "run `verify certify` and `python -m tests.bring` until nothing is written"
        )


@pytest.fixture(autouse=True)
def no_callbacks_of_the_collector() -> None:
    """Hypothesis times the garbage collector, and an alarm that rings there is lost."""
    gc.callbacks.clear()


@pytest.fixture(autouse=True)
def whole_lines(monkeypatch: pytest.MonkeyPatch) -> None:
    """Lines are not broken: tests of the terminal say themselves how wide it is."""
    monkeypatch.setenv("COLUMNS", "99999")


@pytest.fixture
def a_new_process() -> Iterator[None]:
    """Nothing that the program has read or computed before is remembered; nor is it afterwards."""
    _forget()
    yield
    _forget()


def _forget() -> None:
    for name in [name for name in sys.modules if name.partition(".")[0] == "verify"]:
        for found in [*vars(sys.modules[name]).values()]:
            if callable(getattr(found, "cache_clear", None)):
                found.cache_clear()
