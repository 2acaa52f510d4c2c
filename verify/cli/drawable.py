"""Errors of a drawing, told as what is wrong with --plot."""

from __future__ import annotations

from collections.abc import Iterator
from contextlib import contextmanager

from verify.wire.inputs import InputError


@contextmanager
def drawable() -> Iterator[None]:
    """Inside, something is drawn.

    Raises:
        InputError: if numbers are too large or too small for that, or have no value.
    """
    try:
        yield
    except InputError:
        raise
    except (OverflowError, ZeroDivisionError, ValueError) as error:
        raise InputError(
            "--plot: some numbers are too large or too small to draw; leave it out"
        ) from error
