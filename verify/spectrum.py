"""The spectrum of three collisions in the limit, for a program: ``verify spectrum --r R``.

It is loaded when it is used.
"""

from __future__ import annotations

from fractions import Fraction

from verify.language.record import Record
from verify.library import Interval, called, exact_text
from verify.paper.commands import eigenvalues
from verify.prover import balls
from verify.prover.balls import Ball
from verify.spheres.parameters import restitution
from verify.views.findings import Complex
from verify.views.spectrum import EXTRA_BITS, complex_told

VECTORS = ("vector_0", "vector_plus")


class Rectangle(Record):
    """Enclosures of the real and the imaginary part of a complex number."""

    real: Interval
    imaginary: Interval

    def __str__(self) -> str:
        return complex_told(str(self.real), str(self.imaginary))


class Spectrum(Record):
    """The eigenvalues beside 1, and eigenvectors with first coordinate 1.

    ``exact`` is lambda_0 where it is rational; ``plus`` is the complex eigenvalue with positive
    imaginary part, with its modulus and its argument; its conjugate is the last one.
    """

    r: Fraction
    exact: Fraction | None
    lambda_0: Interval
    plus: Rectangle
    modulus: Interval
    argument: Interval
    vector_0: tuple[Interval, ...]
    vector_plus: tuple[Rectangle, ...]

    def __str__(self) -> str:
        told = {name: getattr(self, name) for name in ("lambda_0", "plus", "modulus", "argument")}
        lines = [f"{name} = {value}" for name, value in told.items()]
        vectors = [f"{name} = ({', '.join(map(str, getattr(self, name)))})" for name in VECTORS]
        return "\n".join((f"r = {self.r}", *lines, *vectors))


def at(r: str | int | Fraction, *, bits: int = 128) -> Spectrum:
    """The spectrum at r in (0, 1), each part known to ``bits`` relative bits.

    Raises:
        TypeError: for a float.
        InputError: for a number that is not in (0, 1).
    """
    with called():
        exact_r = restitution(exact_text("r", r))
    found = eigenvalues.at(exact_r, bits)
    with balls.precision(bits + EXTRA_BITS):  # at which the ends of balls are rounded
        return Spectrum(
            exact_r,
            found.exact,
            _interval(found.lambda_0),
            _rectangle(found.plus),
            _interval(found.modulus),
            _interval(found.argument),
            tuple(map(_interval, found.vector_0)),
            tuple(map(_rectangle, found.vector_plus)),
        )


def _interval(ball: Ball) -> Interval:
    return Interval(*balls.ends(ball))


def _rectangle(value: Complex) -> Rectangle:
    return Rectangle(_interval(value.re), _interval(value.im))
