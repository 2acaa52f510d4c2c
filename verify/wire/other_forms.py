"""Rows of a page in another form that says the same, where the first one is undecided."""

from __future__ import annotations

from collections.abc import Callable, Mapping

from verify.language.statement import UNDECIDED, Statement
from verify.prover.budget import WorkBudget
from verify.prover.outcome import Outcome
from verify.wire.text import OTHERS, Page

Decides = Callable[..., Outcome]


def with_other_forms(first: Outcome, page: Page, budget: WorkBudget, decide: Decides) -> Outcome:
    """The outcome in which rows that are open have other forms, if they are decided in these."""
    undecided = {row.name for row, found in first.rows if found.claimed == UNDECIDED}
    open_rows = [row.name for row in page.statement.obligations if row.name in undecided]
    found: dict[str, Outcome] = {}
    for left, name in zip(range(len(open_rows), 0, -1), open_rows, strict=True):
        outcome = _by_other_forms(page, name, budget, left, decide)
        if outcome is not None:
            found[name] = outcome
    if not found or len(page.statement.obligations) == 1:
        return next(iter(found.values()), first)
    return decide(_with_forms(page.statement, found), budget, page.hints)


def _by_other_forms(
    page: Page, name: str, budget: WorkBudget, rows: int, decide: Decides
) -> Outcome | None:
    """The outcome of the first other form of a row that is decided; None if none is."""
    for left in range(OTHERS, 0, -1):
        form = None if budget.is_over else next(page.forms[name], None)
        if form is None:
            break
        context, row = form
        contexts = () if context is None else (context,)
        asked = page.statement._replace(obligations=(row,), contexts=contexts)
        with budget.part(2 * OTHERS, left * rows + (len(page.forms) > 1)) as share:
            outcome = decide(asked, share)
        if outcome.claimed != UNDECIDED:
            return outcome
    return None


def _with_forms(statement: Statement, found: Mapping[str, Outcome]) -> Statement:
    """The statement with other forms of some of its rows."""
    contexts = {context.name: context for context in statement.contexts}
    rows = {row.name: row for row in statement.obligations}
    for outcome in found.values():
        contexts |= {context.name: context for context in outcome.statement.contexts}
        rows |= {row.name: row for row in outcome.statement.obligations}
    return statement._replace(contexts=(*contexts.values(),), obligations=(*rows.values(),))
