"""Which entries of the minima matter: some are never the least, each other one sometimes is."""

from __future__ import annotations

from collections.abc import Iterator
from fractions import Fraction

from verify.language.statement import NEEDED, Obligation
from verify.language.terms import Term, as_term, minimum, substitute
from verify.paper.everywhere.chart import CONTEXT, constants
from verify.paper.groups import REPAIRED
from verify.paper.initial_data import D_0, DELTA, ETA, X_0, ZETA, ConstantSet

LABELS = {
    "delta_x": DELTA,
    "x_0": X_0,
    "Delta_theta": X_0,
    "eta_bar": ETA,
    "zeta_bar": ZETA,
    "d_const": D_0,
    "d_bar": D_0,
}

#: For each constant its redundant entries, each with an entry that is at most as large.
REDUNDANT = {
    "delta_x": {1: 6, 2: 6, 3: 6, 4: 6, 5: 6},
    "x_0": {2: 1},
    "Delta_theta": {1: 2},
    "eta_bar": {2: 4, 5: 6, 7: 6},
    "zeta_bar": {1: 3, 2: 3, 3: 4},
    "d_const": {1: 2, 4: 3},
    "d_bar": {1: 2},
}

#: For the other entries r, -cos theta_0, V_0 and delta_theta where it is less than all others.
LEAST = {
    "Delta_theta": {2: ("3/100", "1", "1", "1/10"), 3: ("3/100", "1", "1", "1/1000000")},
    "eta_bar": {
        1: ("3/100", "1", "10000000000000000", "1/10"),
        3: ("3/100", "1", "1", "1/10"),
        4: ("3/100", "1", "1/100000000000000000000", "1/10"),
        6: ("1/1000000", "1/20", "1", "1/10"),
    },
    "zeta_bar": {4: ("1/20", "1", "1", "1/10"), 5: ("3/100", "1", "1", "1/10")},
    "d_const": {2: ("3/100", "1", "1", "1/10"), 3: ("1/1000000", "1/20", "1", "1/10")},
}


def rows() -> Iterator[Obligation]:
    """Each redundant entry is at least another one, whatever the parameters."""
    bounds = ConstantSet(REPAIRED).bounds()
    for name, pairs in REDUNDANT.items():
        for entry, other in pairs.items():
            yield Obligation(
                f"redundant.{name}-{entry}",
                REPAIRED,
                LABELS[name],
                NEEDED,
                f"entry {entry} of the minimum for {name} can be left out: it is at least entry "
                f"{other}",
                bounds[name][other - 1] <= bounds[name][entry - 1],
                context=CONTEXT,
            )


def active_rows() -> Iterator[Obligation]:
    """Each other entry is the only least one at some parameters."""
    bounds = ConstantSet(REPAIRED).bounds()
    for name, points in LEAST.items():
        for entry, point in points.items():
            values = values_at(point)
            entries = [substitute(term, values) for term in bounds[name]]
            others = entries[: entry - 1] + entries[entry:]
            r, c, V_0, delta_theta = point
            yield Obligation(
                f"active.{name}-{entry}",
                REPAIRED,
                LABELS[name],
                NEEDED,
                f"entry {entry} of the minimum for {name} is the least at r = {r}, "
                f"-cos θ₀ = {c}, V₀ = {V_0}, δ_θ = {delta_theta}",
                entries[entry - 1] < minimum(*others),
            )


def values_at(point: tuple[str, ...]) -> dict[str, Term]:
    """All constants at r, -cos theta_0, V_0 and delta_theta, as terms without names."""
    names = ("r", "c", "V_0", "delta_theta")
    values = {name: as_term(Fraction(x)) for name, x in zip(names, point, strict=True)}
    for constant in constants():
        values[constant.name] = substitute(constant.term, values)
    return values
