"""Any statement, decided: its contexts opened, its constants defined, its rows one by one."""

from __future__ import annotations

from verify.language.statement import UNDECIDED, Constant, Obligation, Statement
from verify.language.terms import Claim, names_of
from verify.prover.budget import SpentError, WorkBudget
from verify.prover.ground import DEFAULT_MAX_PRECISION, DEFAULT_PRECISION, Ground
from verify.prover.outcome import Decision, Enclosure, Outcome
from verify.prover.rows_in_contexts import RowsInContexts
from verify.prover.session import Session
from verify.prover.universal import Universal


def prove(
    statement: Statement,
    start_bits: int = DEFAULT_PRECISION,
    max_bits: int = DEFAULT_MAX_PRECISION,
    budget: WorkBudget | None = None,
) -> Outcome:
    """Decide every row of a statement; what is not found is left undecided.

    Args:
        statement: what is claimed.
        start_bits: the first precision for claims without variables.
        max_bits: the last one.
        budget: how much work each row may be.
    """
    ground = Ground(Session(), start_bits, max_bits)
    universal = Universal(ground, budget or WorkBudget())
    spent = _defined(statement, ground)
    for context in statement.contexts:
        if not spent and not universal.open(context):
            spent = f"the context {context.name} was not seen to have a point"
    decisions = {
        row.name: Decision(UNDECIDED) if spent else _decide(row, ground, universal)
        for row in statement.obligations
    }
    names = (*statement.parameters, *(constant.name for constant in statement.constants))
    enclosures = {} if spent else _enclosures(names, ground)
    return Outcome(statement, decisions, tuple(ground.session.steps), enclosures, spent)


def _defined(statement: Statement, ground: Ground) -> str:
    """Define all constants without variables; what could not be, in words."""
    parameters = [Constant(n, n, n, "", term) for n, term in statement.parameters.items()]
    for constant in (*parameters, *statement.constants):
        if not ground.define(constant):
            return f"{constant.name} has no value at {ground.max_bits} bits"
    return ""


def _decide(row: Obligation, ground: Ground, universal: Universal) -> Decision:
    universal.budget.refill()
    if isinstance(row.claim, Claim):
        names = names_of(row.claim.lhs, row.claim.rhs)
        if all(name in ground.definitions for name in names):
            found = ground.decide(row)
            if found.verdict != UNDECIDED:
                return found
    try:
        universal.budget.spend(0)
        return RowsInContexts(universal).decide(row)
    except (SpentError, RecursionError):  # terms may be deeper than Python goes
        return Decision(UNDECIDED)


def _enclosures(names: tuple[str, ...], ground: Ground) -> dict[str, Enclosure]:
    found = {name: ground.enclose(ground.definitions[name]) for name in names}
    return {name: enclosure for name, enclosure in found.items() if enclosure is not None}
