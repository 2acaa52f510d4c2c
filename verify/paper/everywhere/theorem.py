"""Theorem 1 for all parameters, as a statement: every row, and that the step applies."""

from __future__ import annotations

from collections.abc import Iterator

from verify.language.statement import NEEDED, Applies, Cite, Obligation, Statement
from verify.language.terms import substitute_claim
from verify.paper.everywhere import redundant
from verify.paper.everywhere.chart import CONTEXT, DERIVED, context, hypothesis
from verify.paper.groups import HYPOTHESES, REPAIRED
from verify.paper.parameters import THEOREM
from verify.paper.step import numbers
from verify.paper.step.theorem import NAME as STEP
from verify.paper.theorem1 import theorem

NAME = f"{THEOREM} for all parameters"
TITLE = (
    "For all 0 < r < 1, V_0 > 0, delta_theta > 0 and all theta_0 with 0 < -cos theta_0 <= 1 that "
    "satisfy the stability condition: every row of the repaired set, and the step applies"
)
APPLIES = "collapse"

#: What the step needs and is no row, about the constants of the theorem: signs of divisors, and
#: r = phi_minus phi_plus.
BETWEEN = {
    name: substitute_claim(claim, numbers.MEANING)
    for name, claim in (numbers.SIGNS | numbers.DEFINITIONS).items()
}
#: The definitions that the step needs, by the names of the constants.
DEFINED = {
    "alpha": "alpha_0",
    "same-delta": f"{REPAIRED}.delta_y",
    "d_bar-least": f"{REPAIRED}.d_bar",
}


def applies() -> Applies:
    """The claim that the constants of the theorem satisfy all that the step needs."""
    return Applies(f"{STEP}:{numbers.CONTEXT}", numbers.MEANING)


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
    yield Obligation(
        APPLIES,
        REPAIRED,
        THEOREM,
        NEEDED,
        "the constants satisfy what the step needs: for each datum of the set the particles "
        "collapse",
        applies(),
        context=CONTEXT,
    )


def statement(step: bytes) -> Statement:
    """The statement; it cites the step, whose statement is given."""
    cite = Cite(STEP, STEP, step)
    return Statement(NAME, TITLE, {}, (), (context(),), tuple(rows()), (), (cite,))
