"""A proof that uses a given is refused if the statement does not give that."""

from __future__ import annotations

from functools import partial

import pytest

from verify import check
from verify.language.statement import Statement
from verify.language.terms import Claim, as_term
from verify.paper.commands import pages
from verify.prover.outcome import Outcome
from verify.prover.proof import OpenStep, Step
from verify.prover.rules import Interval
from verify.prover.uses import nodes
from verify.wire.write import digest, write

#: What stands in the place of a given that is dropped: its name says nothing any more.
NOTHING = Claim("<", as_term(0), as_term(1))
OUTCOMES = {
    "everywhere": partial(pages.decide, "all_parameters"),
    "step": partial(pages.decide, "step"),
}


def used_givens(outcome: Outcome) -> list[str]:
    """The plain givens that some proof names."""
    found = nodes(outcome)
    used = {name for node in found.values() for name in node.uses}
    contexts = outcome.statement.contexts
    givens = (given for context in contexts for given in context.givens if given.kind == "plain")
    return [given.name for given in givens if given.name in used]


def without(outcome: Outcome, name: str) -> Outcome:
    contexts, steps = [], list(outcome.steps)
    for context in outcome.statement.contexts:
        names = [given.name for given in context.givens]
        if name in names:
            i = names.index(name)
            given = context.givens[i]._replace(claim=NOTHING)
            givens = (*context.givens[:i], given, *context.givens[i + 1 :])
            steps = [_opened(step, context.name, i) for step in steps]
            context = context._replace(givens=givens)
        contexts.append(context)
    statement: Statement = outcome.statement._replace(contexts=tuple(contexts))
    return outcome._replace(statement=statement, steps=tuple(steps))


def _opened(step: Step, context: str, i: int) -> Step:
    if not isinstance(step, OpenStep) or step.name != context:
        return step
    return step._replace(givens=(*step.givens[:i], Interval(64), *step.givens[i + 1 :]))


def verdict(outcome: Outcome) -> str:
    files = write(outcome)
    cited = {digest(data): data for name, data in files.items() if name.startswith("cited/")}
    return check.check(files["statement.json"], files["certificate.json"], cited).verdict


def test_every_given_of_the_theorem_is_used() -> None:
    givens = [g.name for c in pages.decide("all_parameters").statement.contexts for g in c.givens]
    assert used_givens(pages.decide("all_parameters")) == givens


@pytest.mark.parametrize(("name", "every"), [("everywhere", 1), ("step", 8)])
def test_without_a_given_the_certificate_is_refused(name: str, every: int) -> None:
    outcome = OUTCOMES[name]()
    for given in used_givens(outcome)[::every]:
        assert verdict(without(outcome, given)) == "REFUSED", given
