"""How much work a search may do: counted, so that its results do not depend on the machine."""

from __future__ import annotations

from collections.abc import Callable, Iterator
from contextlib import contextmanager
from time import monotonic

#: About the number of microseconds that a search for one row may take.
WORK = 60_000_000


class SpentError(ArithmeticError):
    """The work, or the time, is used up."""


def _unseen(_name: str) -> None:
    pass


class WorkBudget:
    """Units of work, about a microsecond each, for each row; and seconds for all rows together.

    Time only ends the search: what is found before is the same on any machine. A row gets an equal
    share of the time that is left, and what it does not need goes to those after it.

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
        self.work, self.left = work, work
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

    def begin(self, name: str, rows: int) -> None:
        """A row begins, and with it so many are left."""
        if self.interrupted:
            return
        self.watch(name)
        if self._end is not None:
            now = monotonic()
            self._row_end = now + (self._end - now) / rows

    def refill(self) -> None:
        """A new row has all the work before it."""
        self.left = self.work

    @property
    def spent(self) -> int:
        """The units that this row has taken."""
        return min(self.work, self.work - self.left)

    def spend(self, units: int) -> None:
        """Count work that is done next.

        Raises:
            SpentError: if there is none left.
        """
        self.left -= units
        if self.interrupted:
            raise SpentError("the search was interrupted before")
        if self._row_end is not None and monotonic() > self._row_end:
            raise SpentError("its share of the time is over; allow more, by --time")
        if self.left < 0:
            raise SpentError("the work for a row is used up; allow it more, by --work")
