"""How much work a search may do: counted, so that its results do not depend on the machine."""

from __future__ import annotations

from time import monotonic

#: About the number of microseconds that a search for one row may take.
WORK = 60_000_000


class SpentError(ArithmeticError):
    """The work, or the time, is used up."""


class WorkBudget:
    """Units of work, about a microsecond each, for each row; and seconds for all rows together.

    Time only ends the search: what is found before is the same on any machine.
    """

    def __init__(self, work: int = WORK, seconds: float | None = None) -> None:
        self.work, self.left = work, work
        self._end = None if seconds is None else monotonic() + seconds

    def refill(self) -> None:
        """A new row has all the work before it."""
        self.left = self.work

    def spend(self, units: int) -> None:
        """Count work that is done next.

        Raises:
            SpentError: if there is none left.
        """
        self.left -= units
        if self._end is not None and monotonic() > self._end:
            raise SpentError("the time is over; allow more, by --time")
        if self.left < 0:
            raise SpentError("the work for a row is used up; allow it more, by --work")
