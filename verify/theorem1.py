"""Theorem 1 at a point, for a program of one's own: what ``verify theorem1 --r R`` decides.

It is loaded when it is used: ``import verify`` does not read the paper.
"""

from __future__ import annotations

from collections.abc import Mapping
from fractions import Fraction

from verify.language.statement import PRINTED, REFUTED
from verify.library import Interval, Result, called, exact_bits, exact_text
from verify.paper.commands.citing import as_printed
from verify.paper.commands.theorem1 import decide_point
from verify.paper.source import PAPER
from verify.spheres.parameters import read_parameters
from verify.views.point import screen
from verify.views.words import fair
from verify.wire.inputs import InputError


class Point(Result):
    """Theorem 1 at a point: an outcome whose text is what the command prints."""

    @property
    def constants(self) -> dict[str, Interval]:
        """Enclosures of the parameters and constants: ``phi_minus``, ``repaired.delta_x``."""
        found = self.enclosures.items()
        return {name: Interval(*enclosure.ends[0]) for name, enclosure in found}

    @property
    def verdicts(self) -> Mapping[str, str]:
        """The verdict on each row by its name: that on what the text says, as it is printed."""
        return {row.name: fair(self, row, decision) for row, decision in self.rows}

    @property
    def refuted(self) -> list[str]:
        """The names of the printed rows that are refuted, in the order of the paper."""
        rows = [row.name for row, _ in self.rows if row.role == PRINTED]
        return [name for name in rows if self.verdicts[name] == REFUTED]

    def __str__(self) -> str:
        return "\n".join(screen(self, PAPER, as_printed(self)))


def at(
    r: str | int | Fraction,
    *,
    theta0: str | None = None,
    neg_cos: str | int | Fraction | None = None,
    delta_theta: str | int | Fraction = "1/10",
    V_0: str | int | Fraction = 1,
    bits: int = 128,
    max_bits: int = 1 << 16,
) -> Point:
    """Decide the constants and every inequality, with printed and with repaired constants.

    ``theta0`` is written as for the command (``"5pi/6"``); the other numbers are exact: a text, an
    integer or a fraction. ``bits`` is the precision of the first try, ``max_bits`` of the last one.

    Raises:
        TypeError: for a float, or what is no number.
        InputError: for a number outside its range, or two angles.
    """
    given = {"r": r, "neg_cos": neg_cos, "delta_theta": delta_theta, "V0": V_0}
    texts = {
        name: None if name == "neg_cos" and v is None else exact_text(name, v)  # type: ignore[arg-type]
        for name, v in given.items()
    }
    angle = None if theta0 is None else exact_text("theta0", theta0)
    bits, max_bits = (exact_bits(*p, 1 << 16) for p in (("bits", bits), ("max_bits", max_bits)))
    if max_bits < bits:
        raise InputError(f"max_bits: {max_bits} is below bits, {bits}; write at least {bits}")
    with called(V0="V_0"):
        parameters = read_parameters({"theta0": angle, **texts})
    return Point(*decide_point(parameters, "all", bits, max_bits, all_sides=True))
