"""A name in the paper's pages, and where it is written."""

from __future__ import annotations

import os

from verify.language.record import Record

#: The folder in which `verify` is.
ROOT = os.path.dirname(os.path.dirname(os.path.dirname(os.path.dirname(__file__))))


class Place(Record):
    """A name in the paper's pages, what it says there, and where it is written."""

    name: str
    label: str
    says: str
    path: str
    line: int

    @property
    def part(self) -> str:
        """The page, or the folder inside `verify/paper/`, or '' for Theorem 1 at a point."""
        first, *others = self.path.split("/")[2:]
        page = first.removesuffix(".toml")
        return page if others or page not in ("theorem1", first) else ""

    @property
    def short(self) -> str:
        """The name without its group."""
        return self.name.partition(".")[2]
