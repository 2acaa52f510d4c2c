"""The roots of Q as r runs over (0, 1), by the parameter m with -m^3 the real one."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from fractions import Fraction

from verify.prover.outcome import Ends
from verify.views.findings import Roots
from verify.views.plots.shapes import Areas, Disc, Figure, Panel, Scale, Shape, Words, marks


def figure(cells: Sequence[Roots]) -> Figure:
    """The complex plane, and the real root between its bounds."""
    widest = max(cell.re[1] - cell.re[0] for cell in cells)
    return Figure(
        "roots",
        "The roots of Q for every r in (0, 1)",
        f"{len(cells)} intervals of m, where λ₀ = -m³ is the real root and "
        f"r = m(4m²-m+1)/(m²-m+4). "
        f"Left: each box contains a root for every r of its interval (the widest is "
        f"{float(widest):.2g} wide); λ₀ in orange, the complex pair in blue, and the unit circle, "
        f"which they reach only as r → 1. Right: λ₀ (orange) between its bounds -r "
        f"and -r³ (grey), as boxes too. That λ₀ lies between them for every r is proved in the "
        f"spectral claims, not by this drawing.",
        (
            Panel("Complex plane", _RE, _IM, lambda: _plane(cells), _TOLD_PLANE, 420, 448),
            Panel("The real root", _R, _REAL, lambda: _real(cells), _TOLD_REAL, 420, 448),
        ),
    )


def _plane(cells: Sequence[Roots]) -> Iterator[Shape]:
    yield Disc((0, 0), 1, "faint")
    pair = [
        _box(cell.re, (sign * cell.im[0], sign * cell.im[1])) for cell in cells for sign in (1, -1)
    ]
    yield Areas(pair, "series-1", 0.8, "complex pair")
    thin = (Fraction(-1, 250), Fraction(1, 250))
    yield Areas([_box(cell.real, thin) for cell in cells], "series-2", 0.8, "λ₀")
    yield Words((0.14, -0.03), "r → 0")
    yield Words((-0.56, 0.68), "r → 1")


def _real(cells: Sequence[Roots]) -> Iterator[Shape]:
    for attribute, colour in (
        ("minus_r", "series-3"),
        ("minus_r_cubed", "series-3"),
        ("real", "series-2"),
    ):
        yield Areas([_box(cell.r, getattr(cell, attribute)) for cell in cells], colour, 0.8)
    yield Words((0.43, -0.52), "−r", "end")
    yield Words((0.6, -0.14), "−r³")
    yield Words((0.57, -0.4), "λ₀")


_UNIT = marks("-1", "-0.5", "0", "0.5", "1")
_RE, _IM = Scale("Re λ", -1.1, 1.1, _UNIT), Scale("Im λ", -1.1, 1.1, _UNIT)
_R = Scale("r", 0, 1, marks("0", "0.2", "0.4", "0.6", "0.8", "1"))
_REAL = Scale("λ₀", -1, 0, marks("-1", "-0.8", "-0.6", "-0.4", "-0.2", "0"))
_TOLD_PLANE = (
    "Inside of the unit circle two arcs, mirrored at the real axis, lead from near 0 to the circle "
    "and λ₀ runs along the negative real axis."
)
_TOLD_REAL = "λ₀ falls from 0 to −1 as r grows, between −r and −r³."


def _box(x: Ends, y: Ends) -> tuple[float, float, float, float]:
    return float(x[0]), float(x[1]), float(min(y)), float(max(y))
