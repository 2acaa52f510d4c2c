"""How far a long job is, for who watches it at a terminal."""

from __future__ import annotations

import sys
import time


class Steps:
    """Says on stderr which step of how many begins, and about how long the rest will take.

    The estimate takes all steps to be alike; nothing is said where nobody watches.

    Args:
        count: how many steps there are.
    """

    def __init__(self, count: int) -> None:
        self._count, self._done, self._start = count, 0, time.monotonic()

    def __call__(self, text: str) -> None:
        """Begin a step."""
        if sys.stderr is not None and sys.stderr.isatty():
            number = f"[{min(self._done + 1, self._count)}/{self._count}]"
            print(f"{number} {text} …{self._rest()}", file=sys.stderr)
        self._done += 1

    def _rest(self) -> str:
        left = self._count - self._done
        if not self._done or left <= 0:
            return ""
        seconds = (time.monotonic() - self._start) / self._done * left
        return f" (about {time_in_words(seconds)} left)"


def time_in_words(seconds: float) -> str:
    """A time in words: ``8 s``, ``3 min``."""
    return f"{seconds:.0f} s" if seconds < 100 else f"{seconds / 60:.0f} min"
