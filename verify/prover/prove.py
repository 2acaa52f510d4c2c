"""Any statement, decided: its contexts opened, its constants defined, its rows one by one."""

from __future__ import annotations

import re
from collections.abc import Callable, Mapping, Sequence
from types import MappingProxyType

from verify.language.statement import PROVED, UNDECIDED, Constant, Obligation, Statement
from verify.language.terms import Claim, names_of
from verify.prover.budget import SpentError, WorkBudget
from verify.prover.constants import DEFAULT_MAX_PRECISION, DEFAULT_PRECISION
from verify.prover.ground import Ground
from verify.prover.hint import Hint
from verify.prover.outcome import Decision, Enclosure, Outcome
from verify.prover.proof import Step
from verify.prover.rows_in_contexts import RowsInContexts
from verify.prover.session import Session
from verify.prover.techniques import find
from verify.prover.universal import Universal

NOTHING_FOUND = "neither a proof nor an example against it was found"

NO_HINTS: Mapping[str, Hint] = MappingProxyType({})

#: Why steps that show a row (none: what all rows rest on) are too much for the checker; or nothing.
Price = Callable[[Obligation | None, str, Sequence[Step]], str]


def prove(
    statement: Statement,
    start_bits: int = DEFAULT_PRECISION,
    max_bits: int = DEFAULT_MAX_PRECISION,
    budget: WorkBudget | None = None,
    price: Price = lambda _row, _claimed, _steps: "",
    hints: Mapping[str, Hint] = NO_HINTS,
) -> Outcome:
    """Decide every row of a statement; what is not found is left undecided, with the reason.

    Args:
        statement: what is claimed.
        start_bits: the first precision for claims without variables.
        max_bits: the last one.
        budget: how much work each row may be.
        price: asked before anything is claimed of a row.
        hints: where to look for the proofs of some rows, by their names.
    """
    ground = Ground(Session(_unused_prefix(statement)), start_bits, max_bits)
    universal = Universal(ground, budget or WorkBudget(), find)
    spent = _opened(statement, universal) or price(None, "", ground.session.steps)
    rows = statement.obligations
    decisions = {}
    for left, row in zip(range(len(rows), 0, -1), rows, strict=True):
        universal.budget.begin(row.name, left)
        hint = hints.get(row.name, Hint())
        decisions[row.name] = (
            Decision(UNDECIDED, reason=spent) if spent else _hinted(row, universal, price, hint)
        )
    names = (*statement.parameters, *(constant.name for constant in statement.constants))
    enclosures = {} if spent else _enclosures(names, ground)
    return Outcome(statement, decisions, tuple(ground.session.steps), enclosures, spent)


def _unused_prefix(statement: Statement) -> str:
    """What begins the names of lemmas, and no name of the statement."""
    prefix = "l"
    names = [row.name for row in statement.obligations]
    names += [given.name for context in statement.contexts for given in context.givens]
    while any(re.fullmatch(rf"{prefix}\.[0-9]+", name) for name in names):
        prefix += "l"
    return prefix


def _opened(statement: Statement, universal: Universal) -> str:
    """Define all constants and open all contexts; what could not be, in words."""
    try:
        spent = _defined(statement, universal.ground)
        for context in statement.contexts:
            universal.budget.refill()
            if not spent and not universal.open(context):
                spent = f"the context {context.name} was not seen to have a point"
    except (ArithmeticError, RecursionError) as error:
        return f"its constants and contexts were not decided: {_why(error)}"
    return spent


def _defined(statement: Statement, ground: Ground) -> str:
    """Define all constants without variables; what could not be, in words."""
    parameters = [Constant(n, n, n, "", term) for n, term in statement.parameters.items()]
    for constant in (*parameters, *statement.constants):
        if not ground.define(constant):
            return f"{constant.name} has no value at {ground.max_bits} bits"
    return ""


def _hinted(row: Obligation, universal: Universal, price: Price, hint: Hint) -> Decision:
    """The decision on a row that may use what its hint says."""
    if hint == Hint() or not isinstance(row.claim, Claim):
        return _priced(row, universal, price)
    others = set() if hint.using is None else universal.rows - {*hint.using}
    universal.rows -= others
    universal.hints = {row.claim: hint}
    found = _priced(row, universal, price)
    universal.hints = {}
    universal.rows |= others
    return found


def _priced(row: Obligation, universal: Universal, price: Price) -> Decision:
    """The decision on a row, if the checker can afford to read its proof."""
    undo, first = universal.mark(), len(universal.session.steps)
    universal.reasons.clear()
    try:
        found = _decide(row, universal.ground, universal)
    except Exception as error:
        found = Decision(UNDECIDED, reason=_why(error))
    except KeyboardInterrupt:
        if not universal.budget.catches:
            raise
        universal.budget.interrupted = True
        found = Decision(UNDECIDED, reason="the search was interrupted")
    if found.claimed == UNDECIDED:
        undo()
        return found._replace(reason=found.reason or "; ".join((NOTHING_FOUND, *universal.reasons)))
    reason = price(row, found.claimed, universal.session.steps[first:])
    if reason:
        undo()
        return Decision(UNDECIDED, reason=reason)
    return found


def _why(error: Exception) -> str:
    """In words why a search ended."""
    if isinstance(error, SpentError):
        return str(error)
    if isinstance(error, RecursionError):
        return "its terms are too deep"
    return f"the search failed: {type(error).__name__}: {error!s:.200}"


def _decide(row: Obligation, ground: Ground, universal: Universal) -> Decision:
    universal.budget.refill()
    universal.budget.spend(0)  # no row is begun when the time is over
    if isinstance(row.claim, Claim):
        names = names_of(row.claim.lhs, row.claim.rhs)
        if all(name in ground.definitions for name in names):
            found = ground.decide(row)
            if found.claimed != UNDECIDED:
                if found.claimed == PROVED:
                    universal.rows.add(row.name)
                return found
    return RowsInContexts(universal).decide(row)


def _enclosures(names: tuple[str, ...], ground: Ground) -> dict[str, Enclosure]:
    found = {name: ground.enclose(ground.definitions[name]) for name in names}
    return {name: enclosure for name, enclosure in found.items() if enclosure is not None}
