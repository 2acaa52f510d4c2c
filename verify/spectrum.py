"""The spectrum of three collisions in the limit, for a program: ``verify spectrum --r R``.

It is loaded when it is used.
"""

from __future__ import annotations

from fractions import Fraction
from typing import Any

from verify.library import Interval, called, exact_bits, exact_text
from verify.paper.commands import eigenvalues
from verify.prover import balls
from verify.prover.balls import Ball
from verify.spheres.parameters import restitution
from verify.views.findings import Rectangle, Spectrum
from verify.views.spectrum import EXTRA_BITS

__all__ = ["Rectangle", "Spectrum", "at"]


def at(r: str | int | Fraction, *, bits: int = 128) -> Spectrum:
    """The spectrum at r in (0, 1), each part known to ``bits`` relative bits.

    Raises:
        TypeError: for a float.
        InputError: for a number that is not in (0, 1).
    """
    bits = exact_bits("bits", bits, 1 << 22)
    with called():
        exact_r = restitution(exact_text("r", r))
    found = eigenvalues.at(exact_r, bits)
    with balls.precision(bits + EXTRA_BITS):  # at which the ends of balls are rounded
        return Spectrum(*map(_intervals, found))


def _intervals(part: Any) -> Any:
    """A part of a spectrum with intervals in place of its balls."""
    if isinstance(part, Ball):
        return Interval(*balls.ends(part))
    if not isinstance(part, tuple):
        return part
    return getattr(part, "_make", tuple)(map(_intervals, part))
