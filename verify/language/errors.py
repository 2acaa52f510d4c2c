"""What goes wrong on our side."""

from __future__ import annotations


class OwnError(RuntimeError):
    """What this program made is not accepted by its own checker."""


class UnreadError(OwnError):
    """The checker does not get to the end of a file: it is too large, or too much work."""
