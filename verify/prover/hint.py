"""Where the author of a row lets the search look first: hints prove nothing."""

from __future__ import annotations

from verify.language.record import Record


class Hint(Record):
    """The only techniques that are tried on a row, and the only facts that it may use.

    ``by`` has words of the names of techniques, of which one is enough; none restricts nothing, and
    neither does None for ``using``. That has names of givens and earlier rows; bounds of variables
    by numbers are always used. If nothing is found with these, other givens are used too, but no
    other rows. Where the row ``follows`` from these facts, a sum of their products is looked for
    first, and nothing else is used.
    """

    by: tuple[str, ...] = ()
    using: tuple[str, ...] | None = None
    follows: bool = False

    def admits(self, technique: str) -> bool:
        """Whether a technique of this name may be tried."""
        return not self.by or any(word in technique for word in self.by)
