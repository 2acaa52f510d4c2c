"""Pictures of numbers that a drawing can have."""

from __future__ import annotations

from collections.abc import Iterator
from contextlib import contextmanager

from verify.wire.inputs import InputError


@contextmanager
def drawable() -> Iterator[None]:
    """What is done inside draws.

    Raises:
        InputError: if numbers are too large or too small for that, or are no numbers.
    """
    try:
        yield
    except InputError:
        raise
    except (OverflowError, ZeroDivisionError, ValueError) as error:
        raise InputError(
            "--plot: some numbers are too large or too small to draw; leave it out"
        ) from error
