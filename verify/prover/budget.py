"""How much work a search may do: counted, so that its results do not depend on the machine."""

from __future__ import annotations

import contextlib
import signal
import sys
import threading
from collections.abc import Callable, Iterator
from contextlib import contextmanager
from time import monotonic
from types import FrameType

#: About the number of microseconds that a search for one row may take.
WORK = 60_000_000


class SpentError(ArithmeticError):
    """The work, or the time, is used up."""


#: The files with what runs while a block with an alarm is entered and left.
_ON_THE_WAY = (__file__, contextlib.__file__)
#: An alarm rings again after so many seconds.
RINGS_AGAIN = 0.05
TOO_LATE = "its share of the time is over; allow more, by --time"


def _unseen(_name: str) -> None:
    pass


class Share:
    """A part of a budget: whether all of it was taken."""

    is_over = False


class WorkBudget:
    """Units of work, about a microsecond each, for each row; and seconds for all rows together.

    Time only ends the search: what is found before is the same on any machine. A row gets an equal
    share of the time that is left, and what it does not need goes to those after it. The limit is
    for the search together with the check of what it finds.

    Args:
        work: the units for each row.
        seconds: the time for all rows; None for no limit.
        watch: called with the name of each row that begins.
        catches: whether an interruption ends the search, and not the program: what is proved by
            then is kept.
    """

    def __init__(
        self,
        work: int = WORK,
        seconds: float | None = None,
        watch: Callable[[str], None] = _unseen,
        *,
        catches: bool = False,
    ) -> None:
        self.work, self.left, self._kept = work, work, 0
        self.watch, self.catches = watch, catches
        self.interrupted = False
        self._end = None if seconds is None else monotonic() + seconds
        self._row_end = self._end

    @property
    def is_over(self) -> bool:
        """Whether the time is over, or the search was interrupted."""
        return self.interrupted or (self._end is not None and monotonic() > self._end)

    @contextmanager
    def part(self, work: int, time: float) -> Iterator[WorkBudget]:
        """A budget with one of so many parts of the work for each row, and of the time left."""
        found = WorkBudget(self.work // work, None, self.watch, catches=self.catches)
        if self._end is not None:
            now = monotonic()
            found._end = found._row_end = now + (self._end - now) / time
        try:
            yield found
        finally:
            self.interrupted |= found.interrupted

    @contextmanager
    def at_most(self, units: int) -> Iterator[Share]:
        """What is inside ends without an error when it has taken so many units of work."""
        kept, share = max(0, self.left - units), Share()
        self.left, self._kept = self.left - kept, self._kept + kept
        try:
            yield share
        except SpentError:
            late = self._row_end is not None and monotonic() > self._row_end
            if self.interrupted or late or self.left + kept < 0:
                raise
            share.is_over = True
        finally:
            self.left, self._kept = self.left + kept, self._kept - kept

    def begin(self, name: str, rows: int) -> None:
        """A row begins, and with it so many are left."""
        if self.interrupted:
            return
        self.watch(name)
        if self._end is not None:
            now = monotonic()
            self._row_end = now + (self._end - now) / rows

    @contextmanager
    def alarm(self) -> Iterator[None]:
        """What takes longer than a row may, and counts no work meanwhile, ends by a `SpentError`.

        An alarm of the operating system rings where there is a limit of time, in the main thread.
        It rings again until it is heard: an error is lost where Python itself calls a function (a
        finalizer, a callback of the garbage collector), and nothing is printed about that. It is
        silent on the way into the block and out of it, where nobody could take it back.
        """
        can_ring = self._row_end is not None and hasattr(signal, "setitimer")
        if not can_ring or threading.current_thread() is not threading.main_thread():
            yield
            return

        def ring(_number: int, frame: FrameType | None) -> None:
            if frame is None or frame.f_code.co_filename not in _ON_THE_WAY:
                raise SpentError(TOO_LATE)

        before, told = signal.signal(signal.SIGALRM, ring), sys.unraisablehook
        sys.unraisablehook = lambda lost: lost.exc_type is SpentError or told(lost)
        try:
            left = (self._row_end or 0) - monotonic()
            signal.setitimer(signal.ITIMER_REAL, max(1e-3, left), RINGS_AGAIN)
            yield
        finally:
            signal.setitimer(signal.ITIMER_REAL, 0)
            signal.signal(signal.SIGALRM, before)
            sys.unraisablehook = told

    def set_aside(self, seconds: float) -> None:
        """So much of the time is needed at the end, to check what was found."""
        if self._end is not None:
            self._end -= seconds

    def refill(self) -> None:
        """A new row has all the work before it."""
        self.left, self._kept = self.work, 0

    @property
    def spent(self) -> int:
        """The units that this row has taken."""
        return min(self.work, self.work - self._kept - self.left)

    def spend(self, units: int) -> None:
        """Count work that is done next.

        Raises:
            SpentError: if there is none left.
        """
        self.left -= units
        if self.interrupted:
            raise SpentError("the search was interrupted before")
        if self._row_end is not None and monotonic() > self._row_end:
            raise SpentError(TOO_LATE)
        if self.left < 0:
            raise SpentError("the work for a row is used up; allow it more, by --work")
