"""Theorem 1 for all parameters, as a statement: every row, and that the step applies.

Rows of its own say which entries of the minima matter: some are never the least, each other one
sometimes is.
"""

from __future__ import annotations

from collections.abc import Iterator
from fractions import Fraction

from verify.language.statement import Cite, Obligation, Statement
from verify.language.terms import Term, as_term, minimum, substitute
from verify.paper.assumptions import STEP_ASSUMPTIONS
from verify.paper.everywhere import angle_display
from verify.paper.everywhere.chart import CONTEXT, DERIVED, constants, context, hypothesis
from verify.paper.initial_data import WRITTEN, ConstantSet
from verify.paper.parameters import HYPOTHESES, PRINTED, REPAIRED, THEOREM
from verify.paper.rows import needed
from verify.paper.step import STEP, collapse
from verify.paper.theorem1 import theorem

TITLE = (
    "For all 0 < r < 1, V_0 > 0, delta_theta > 0 and all theta_0 with 0 < -cos theta_0 <= 1 that "
    "satisfy the stability condition: every row of the repaired set, and the step applies"
)
PRINTED_TITLE = (
    "For all parameters that satisfy the stability condition, the rows of the printed set: which "
    "hold, and which do not"
)

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


def redundant_rows() -> Iterator[Obligation]:
    """Each redundant entry is at least another one, whatever the parameters."""
    bounds = ConstantSet(REPAIRED).bounds()
    for name, pairs in REDUNDANT.items():
        for entry, other in pairs.items():
            says = f"entry {entry} of the minimum for {name} can be left out: it is at least entry"
            yield needed(f"redundant.{name}-{entry}", WRITTEN[name][2], f"{says} {other}",
                bounds[name][other - 1] <= bounds[name][entry - 1],
                group=REPAIRED, context=CONTEXT)  # fmt: skip


def active_rows() -> Iterator[Obligation]:
    """Each other entry is the only least one at some parameters."""
    bounds = ConstantSet(REPAIRED).bounds()
    for name, points in LEAST.items():
        for entry, point in points.items():
            values = values_at(point)
            entries = [substitute(term, values) for term in bounds[name]]
            others = entries[: entry - 1] + entries[entry:]
            r, c, V_0, delta_theta = point
            says = f"entry {entry} of the minimum for {name} is the least at r = {r}, -cos θ₀ = {c}"
            yield needed(f"active.{name}-{entry}", WRITTEN[name][2],
                f"{says}, V₀ = {V_0}, δ_θ = {delta_theta}",
                entries[entry - 1] < minimum(*others), group=REPAIRED)  # fmt: skip


def values_at(point: tuple[str, ...]) -> dict[str, Term]:
    """All constants at r, -cos theta_0, V_0 and delta_theta, as terms without names."""
    names = ("r", "c", "V_0", "delta_theta")
    values = {name: as_term(Fraction(x)) for name, x in zip(names, point, strict=True)}
    for constant in constants():
        values[constant.name] = substitute(constant.term, values)
    return values


NAME = f"{THEOREM} for all parameters"
PRINTED_NAME = f"{THEOREM} as printed, for all parameters"


def rows() -> Iterator[Obligation]:
    """The rows of the theorem, for all parameters."""
    parts = theorem().parts
    for row in parts[HYPOTHESES].obligations:
        if row.name in map(hypothesis, DERIVED):
            yield row._replace(context=CONTEXT, says=f"{row.says}: it follows")
    for row in parts[REPAIRED].obligations:
        yield row._replace(context=CONTEXT, uses=())
    yield from redundant_rows()
    yield from active_rows()
    yield collapse(REPAIRED)._replace(context=CONTEXT)


def printed_rows() -> Iterator[Obligation]:
    """The rows of the printed set, each either true for all parameters or false for some."""
    parts = theorem().parts
    for row in parts[HYPOTHESES].obligations:
        if row.name in map(hypothesis, DERIVED):
            yield row._replace(context=CONTEXT, says=f"{row.says}: it follows")
        elif row.severity is not None:
            yield row._replace(context=CONTEXT)
    for row in parts[PRINTED].obligations:
        yield row._replace(context=CONTEXT, uses=())


def printed_statement() -> Statement:
    """The printed set, row by row."""
    own = context(ConstantSet(PRINTED))
    contexts = (own, angle_display.context())
    return Statement(PRINTED_NAME, PRINTED_TITLE, {}, (), contexts, tuple(printed_rows()), ())


def statement(step: bytes, certificate: bytes) -> Statement:
    """The statement; it cites the step, whose statement and certificate are given."""
    cite = Cite(STEP, STEP, step, (), STEP_ASSUMPTIONS, certificate)
    return Statement(NAME, TITLE, {}, (), (context(),), tuple(rows()), (), (cite,))
