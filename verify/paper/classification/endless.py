"""Infinitely many collisions in infinite time: then A <= 0 always, and impulses sum with times.

Q is the sum over the collisions so far of sigma t_n J_n, T the time. No integral is taken: the
number Q + R^2/2 - T A never rises.
"""

from __future__ import annotations

from collections.abc import Iterator
from fractions import Fraction

from verify.language.argument import Chapter, Item, Line, Opened, proof, square, times
from verify.language.terms import as_term, equal
from verify.paper.classification.settings import Letters

LABEL = "DEFINSS3.1Collapse_Inelas"
HALF = Fraction(1, 2)

v = Letters("inward", R="R", e="e", A="A", t="t", R_t="R(t)", T="T", Q="Σσ t_n J_n", R_0="R(0)",
            hit="σ J")  # fmt: skip


def chapters() -> Iterator[Chapter]:
    """One flight and one collision, while A <= 0."""
    context = v.opened(
        "a system at the time T with A ≤ 0, then a flight of length t to a collision with σJ, "
        "before which A ≤ 0 still",
        "2 1 -2 1 1 0 0 2 1",
        {
            "R": 0 < v.R,
            "time": 0 < v.t,
            "T": 0 <= v.T,
            "A": v.A <= 0,
            "A-later": v.A + v.t * v.e**2 <= 0,
            "distance": equal(v.R_t**2, v.R**2 + 2 * v.t * v.A + v.t**2 * v.e**2),
            "weighted": v.Q + v.R**2 / 2 - v.T * v.A <= v.R_0**2 / 2,
            "hit": 0 < v.hit,
        },
    )
    yield Chapter(None, (Opened(context),))
    yield Chapter(v.context, tuple(_lines()))


def _lines() -> Iterator[Item]:
    later = v.T + v.t
    virial = v.A + v.t * v.e**2 + v.hit
    yield from (
        Line("ratio-collision", v.A / v.R <= (v.A + v.hit) / v.R,
             proof(times("inward-R", "inward-hit")), LABEL, "A/R jumps up at a collision"),
        Line("shrinks",         v.R_t**2 <= v.R**2,
             proof(times("inward-time", "inward-A"), times("inward-time", "inward-A-later"),
                   equations=(("inward-distance", as_term(-1)),)), LABEL, "R falls while A ≤ 0"),
        Line("next-times",      v.Q + later * v.hit + v.R_t**2 / 2 - later * virial <= v.R_0**2 / 2,
             proof("inward-weighted", times(HALF, square(v.t * v.e)),
                   times("inward-T", "inward-time", square(v.e)),
                   equations=(("inward-distance", as_term(-HALF)),)),
             LABEL, "Σσ t_n J_n + R²/2 - T A never rises"),
        Line("impulse-times",   v.Q <= v.R_0**2 / 2,
             proof("inward-weighted", times("inward-T", "inward-A"), times(HALF, square(v.R))),
             LABEL, "so Σσ t_n J_n ≤ R(0)²/2"),
    )  # fmt: skip
