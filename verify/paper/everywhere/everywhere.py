"""Theorem 1 for all parameters, as a statement: every row, and that the step applies."""

from __future__ import annotations

from collections.abc import Iterator

from verify.language.statement import Cite, Obligation, Statement
from verify.paper.assumptions import STEP_ASSUMPTIONS
from verify.paper.everywhere import angle_display, redundant
from verify.paper.everywhere.chart import CONTEXT, DERIVED, context, hypothesis
from verify.paper.groups import HYPOTHESES, PRINTED, REPAIRED
from verify.paper.initial_data import ConstantSet
from verify.paper.parameters import THEOREM
from verify.paper.step.numbers import STEP, collapse
from verify.paper.theorem1 import theorem

NAME = f"{THEOREM} for all parameters"
TITLE = (
    "For all 0 < r < 1, V_0 > 0, delta_theta > 0 and all theta_0 with 0 < -cos theta_0 <= 1 that "
    "satisfy the stability condition: every row of the repaired set, and the step applies"
)
PRINTED_NAME = f"{THEOREM} as printed, for all parameters"
PRINTED_TITLE = (
    "For all parameters that satisfy the stability condition, the rows of the printed set: which "
    "hold, and which do not"
)


def rows() -> Iterator[Obligation]:
    """The rows of the theorem, for all parameters."""
    parts = theorem().parts
    for row in parts[HYPOTHESES].obligations:
        if row.name in map(hypothesis, DERIVED):
            yield row._replace(context=CONTEXT, says=f"{row.says}: it follows")
    for row in parts[REPAIRED].obligations:
        yield row._replace(context=CONTEXT, uses=())
    yield from redundant.rows()
    yield from redundant.active_rows()
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
