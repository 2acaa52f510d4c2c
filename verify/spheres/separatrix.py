"""What is enclosed of a separatrix: the curve at some places, its fixed points, its cycle."""

from __future__ import annotations

from collections.abc import Iterator
from fractions import Fraction

from verify.language.record import Record
from verify.language.statement import PROVED, UNDECIDED
from verify.prover import balls
from verify.spheres.limit_cycle import NEWTON, cycle
from verify.spheres.limit_map import (
    RATIONALS,
    SIGNS,
    Allowance,
    Curve,
    CurveAt,
    Ends,
    Parameters,
    beyond,
    fixed_points,
    has_separatrix,
    root_ends,
)

#: Digits beyond those that are shown, so that those agree at both ends.
MORE_DIGITS = 2
#: At which a and the ratio are shown.
SHOWN_BITS = 128
#: How many places of the curve a picture has, and their digits.
CORNERS, DRAWN_DIGITS = 160, 4
#: Values of q in a table that are tried for its step.
SCALES = (Fraction(1, 2), Fraction(2, 5), Fraction(1, 2))


class Separatrix(Record):
    """What is known of f: whether it is 0 everywhere, and otherwise its strips and its points.

    ``exists`` is None where that is not decided. ``fixed`` has phi_minus and phi_plus; ``cycle``
    has q and u of the saddle, and of the state after it, which is another one unless the ratio is
    1; if that was asked for (with a table it is) and found. The last ones are the judges.
    """

    parameters: Parameters
    at: Fraction | None
    digits: int
    exists: bool | None
    strips: tuple[CurveAt, ...] = ()
    fixed: tuple[Ends, ...] = ()
    cycle: tuple[Ends, ...] = ()
    exists_by: str = RATIONALS
    fixed_by: str = SIGNS
    cycle_by: str = NEWTON

    @property
    def a(self) -> Ends:
        """Around a."""
        return root_ends(self.parameters.square_a, SHOWN_BITS)

    @property
    def rho(self) -> Ends:
        """Around the ratio in the map."""
        return root_ends(self.parameters.square_rho, SHOWN_BITS)

    @property
    def scale(self) -> Ends:
        """Around what a ratio of normal speeds is multiplied by to be q."""
        return root_ends(self.parameters.scale, SHOWN_BITS)

    @property
    def is_steady(self) -> bool:
        """Whether the ratio in the map is 1: then its cycle is one state."""
        return self.parameters.square_rho == 1

    @property
    def verdict(self) -> str:
        """*Proved* where it is decided whether f exists, and f is enclosed as asked."""
        known = self.exists is not None and all(strip.reached for strip in self.strips)
        return PROVED if known else UNDECIDED

    @property
    def exit_code(self) -> int:
        """What the command returns."""
        return 0 if self.verdict == PROVED else 3


def decide_separatrix(
    parameters: Parameters, at: Fraction | None, digits: int, steps: int
) -> Separatrix:
    """Enclose f at one q, or make a table of it, following at most so many collisions."""
    exists = has_separatrix(parameters)
    if not exists:
        return Separatrix(parameters, at, digits, exists)
    curve = Curve(parameters, Allowance(steps))
    places = tuple(table_of(parameters)) if at is None else (at,)
    strips = tuple(curve.strip(q, digits + MORE_DIGITS) for q in places)
    found = cycle(curve, digits + MORE_DIGITS) if at is None else ()
    bits = 2 * (digits * 4 + parameters.r.denominator.bit_length() + 64)
    with balls.precision(bits):  # at which the ends of balls are rounded
        ends = tuple(map(balls.ends, found))
    return Separatrix(parameters, at, digits, exists, strips, fixed_points(parameters, bits), ends)


def staircase(found: Separatrix, steps: int, corners: int = CORNERS) -> tuple[CurveAt, ...]:
    """Enclosures of f at so many places from 0 to phi_plus, and where it is 0; for a picture.

    Only those that were reached: between two of them all states below the right one collapse.
    """
    if not found.exists or not found.fixed:
        return ()
    curve = Curve(found.parameters, Allowance(steps))
    low, high = found.fixed[1]
    places = (low * Fraction(k, corners) for k in range(corners))
    known = tuple(strip for q in places if (strip := curve.strip(q, DRAWN_DIGITS)).reached)
    last = curve.strip(high, DRAWN_DIGITS)
    return (*known, last, curve.strip(high * Fraction(23, 20), DRAWN_DIGITS)) if known else ()


def table_of(parameters: Parameters) -> Iterator[Fraction]:
    """Some eight to sixteen round values of q, from 0 to the first one that is not below phi_plus.

    The step is 1, 2 or 5 times a power of ten.
    """
    step = Fraction(1)
    for factor in SCALES * 4000:
        if not beyond(parameters, 8 * step):
            break
        step *= factor
    q = Fraction(0)
    while not beyond(parameters, q):
        yield q
        q += step
    yield q
