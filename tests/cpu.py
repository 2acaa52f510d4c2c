"""CPU time that does not depend on how deep the stack is.

Where a frame does not fit into its piece of the stack, Python 3.11 asks the system for another one
at each call, and gives it back: the same loop may take four times as long inside of a test.
"""

from __future__ import annotations

import time
from collections.abc import Callable
from threading import Thread
from typing import TypeVar

Result = TypeVar("Result")


def seconds_of(work: Callable[[], Result]) -> tuple[float, Result]:
    """How long it works in a thread of its own, whose stack is new, and what comes of it."""
    found: list[tuple[float, Result]] = []

    def run() -> None:
        begin = time.thread_time()
        result = work()
        found.append((time.thread_time() - begin, result))

    thread = Thread(target=run)
    thread.start()
    thread.join()
    return found[0]
