"""The roots of Q as r runs over ]0,1[, by the parameter m with -m^3 the real one."""

from __future__ import annotations

from fractions import Fraction
from typing import Any

from verify.jobs.covers import ROOT_CELLS, roots
from verify.prover.outcome import Ends
from verify.views.plots.drawing import COLOURS, Panel, boxes
from verify.views.plots.figure import Figure


def figure() -> Figure:
    """The complex plane, and the real root between its bounds."""
    widest = max(cell.re[1] - cell.re[0] for cell in roots())
    return Figure(
        "roots",
        "The roots of Q for every r in ]0,1[",
        f"{ROOT_CELLS} intervals of m, where λ₀ = -m³ is the real root and "
        f"r = m(4m²-m+1)/(m²-m+4). "
        f"Left: each box contains a root for every r of its interval (the widest is "
        f"{float(widest):.2g} wide); λ₀ in orange, the complex pair in blue, and the unit circle, "
        f"which they reach only as r → 1. Right: λ₀ (orange) between its bounds -r "
        f"and -r³ (grey), as boxes too. That λ₀ lies between them for every r is proved in the "
        f"spectral claims, not by this drawing.",
        (
            Panel("Complex plane", _draw_plane, 400, 380),
            Panel("The real root", _draw_real, 400, 380),
        ),
    )


def _draw_plane(axis: Any) -> None:
    from matplotlib.patches import Circle

    axis.add_patch(Circle((0, 0), 1, fill=False, edgecolor=COLOURS["faint"], linewidth=1))
    pair = [
        _box(cell.re, (sign * cell.im[0], sign * cell.im[1]))
        for cell in roots()
        for sign in (1, -1)
    ]
    boxes(axis, pair, "series-1", edge=0.8)
    thin = (Fraction(-1, 500), Fraction(1, 500))
    boxes(axis, [_box(cell.real, thin) for cell in roots()], "series-2", edge=0.8)
    axis.text(0.14, -0.03, "r → 0", ha="left")
    axis.text(-0.56, 0.68, "r → 1", ha="left")
    axis.set_xlim(-1.1, 1.1)
    axis.set_ylim(-1.1, 1.1)
    axis.set_aspect("equal")
    axis.set_xlabel("Re λ")
    axis.set_ylabel("Im λ")


def _draw_real(axis: Any) -> None:
    cells = roots()
    for attribute, colour in (
        ("minus_r", "faint"),
        ("minus_r_cubed", "faint"),
        ("real", "series-2"),
    ):
        boxes(axis, [_box(cell.r, getattr(cell, attribute)) for cell in cells], colour, edge=0.6)
    axis.text(0.45, -0.5, "−r", ha="right", va="top")
    axis.text(0.6, -0.16, "−r³", ha="left", va="bottom")
    axis.text(0.55, -0.42, "λ₀", ha="left", va="bottom")
    axis.set_xlim(0, 1)
    axis.set_ylim(-1, 0)
    axis.set_xlabel("r")
    for side in ("top", "right"):
        axis.spines[side].set_visible(False)


def _box(x: Ends, y: Ends) -> tuple[float, float, float, float]:
    return float(x[0]), float(x[1]), float(min(y)), float(max(y))
