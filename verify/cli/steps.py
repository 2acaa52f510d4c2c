"""How far a long job is, for who watches it at a terminal."""

from __future__ import annotations

import time
from collections.abc import Callable, Iterable, Iterator
from typing import TypeVar

from verify.cli.terminal import erase, is_watched, progress

Part = TypeVar("Part")
Task = TypeVar("Task")

#: So many processes may be asked for; more would be a mistake.
MAX_JOBS = 256
#: The width of a bar, and how many seconds it stays as it is at least.
WIDTH, PAUSE = 30, 0.1
#: Seconds after which the rest of a job is estimated.
LEAST = 1


class Clock:
    """Estimates how long the rest of a job takes; all parts of it are taken to be alike.

    Args:
        count: how many parts there are.
    """

    def __init__(self, count: int) -> None:
        self._count = count
        self._first: tuple[int, float] | None = None

    def rest(self, done: int) -> str:
        """About how long the rest will take, in words; nothing at the start, and near the end.

        The first part does not count, which loads what all need.
        """
        if not 0 < done < self._count:
            return ""
        now = time.monotonic()
        if self._first is None:
            self._first = (done, now)
        first, start = self._first
        if done == first or now < start + LEAST:
            return ""
        seconds = (now - start) / (done - first) * (self._count - done)
        return "" if seconds < 1 else f" (about {time_in_words(seconds)} left)"


class Steps:
    """Says on stderr which step of how many begins, and about how long the rest will take.

    Nothing is said where nobody watches.

    Args:
        count: how many steps there are.
    """

    def __init__(self, count: int) -> None:
        self._count, self._done, self._clock = count, 0, Clock(count)

    def __call__(self, text: str) -> None:
        """Begin a step."""
        if is_watched():
            number = f"[{min(self._done + 1, self._count)}/{self._count}]"
            progress(f"{number} {text} …{self._clock.rest(self._done)}")
        self._done += 1


def watched(parts: Iterable[Part], count: int, *, apart: bool = False) -> Iterator[Part]:
    """The parts of a job, with a bar on stderr that grows as they come, and an estimate.

    The bar is gone after the last part; ``apart``: also while each part is dealt with, so that
    what is printed then has lines of its own.
    """
    clock, shown = Clock(count), 0.0
    for done, part in enumerate(parts, 1):
        if shown and (apart or done == count):
            erase()
        yield part
        if is_watched() and done < count and (apart or time.monotonic() > shown + PAUSE):
            filled = WIDTH * done // count
            bar = "#" * filled + "." * (WIDTH - filled)
            text = f"[{bar}] {done} of {count}{clock.rest(done)}"
            progress(text)
            shown = time.monotonic()


def in_order(work: Callable[[Task], Part], tasks: Iterable[Task], jobs: int) -> Iterator[Part]:
    """The results in the order of the tasks, whatever the number of processes."""
    if jobs == 1:
        yield from map(work, tasks)
        return
    from verify.spheres.map.workers import workers  # loaded only where it is used

    with workers(jobs, None) as staff:
        yield from staff.in_order(work, tasks)


def time_in_words(seconds: float) -> str:
    """A time in words: ``8 s``, ``3 min``."""
    return f"{seconds:.0f} s" if seconds < 100 else f"{seconds / 60:.0f} min"
