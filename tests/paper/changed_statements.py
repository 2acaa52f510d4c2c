"""Statements with something missing or changed, and what the checker says of them."""

from __future__ import annotations

from typing import Any

from verify import check
from verify.language.statement import Context, Statement
from verify.language.terms import Claim
from verify.prover.outcome import Outcome
from verify.prover.proof import LemmaStep, ObligationStep, OpenStep
from verify.prover.rules import Sum
from verify.wire.text.infix import Names, read_claims
from verify.wire.write import write


def report(outcome: Outcome) -> check.Report:
    """What the checker finds."""
    files = write(outcome)
    return check.check(files["statement.json"], files["certificate.json"], {})


def answer(outcome: Outcome) -> str:
    """Its verdict."""
    try:
        return report(outcome).verdict
    except check.Malformed:
        return "MALFORMED"


def but(items: tuple[Any, ...], at: int) -> tuple[Any, ...]:
    """All items but one."""
    return items[:at] + items[at + 1 :]


def without(outcome: Outcome, name: str) -> Outcome:
    """The theorem without a given, and without what is said of it."""
    contexts, steps = list(outcome.statement.contexts), list(outcome.steps)
    for number, context in enumerate(contexts):
        names = [given.name for given in context.givens]
        if name not in names:
            continue
        at = names.index(name)
        contexts[number] = context._replace(givens=but(context.givens, at))
        for i, step in enumerate(steps):
            if isinstance(step, OpenStep) and step.name == context.name:
                steps[i] = step._replace(givens=but(step.givens, at))
    statement = outcome.statement._replace(contexts=tuple(contexts))
    return outcome._replace(statement=statement, steps=tuple(steps))


def changed(outcome: Outcome, name: str, claim: Claim) -> Outcome:
    """The theorem with another claim in place of a given."""

    def other(context: Context) -> Context:
        givens = (g._replace(claim=claim) if g.name == name else g for g in context.givens)
        return context._replace(givens=tuple(givens))

    contexts = tuple(map(other, outcome.statement.contexts))
    return outcome._replace(statement=outcome.statement._replace(contexts=contexts))


def claim_of(statement: Statement, name: str, text: str) -> Claim:
    """A claim in the letters of the context in which something of this name is given."""
    (here,) = (context for context in statement.contexts if name in context.claims)
    known = {v.name.removeprefix(f"{here.name}."): v.name for v in here.variables}
    (claim,) = read_claims(name, text, Names(known))
    return claim


def standing(statement: Statement) -> list[str]:
    """The names of what is given of every state, such as Cauchy-Schwarz."""
    return [g.name for g in statement.context("state").givens if g.kind == "standing"]


def accepted_lies(
    outcome: Outcome, parts: int, too_long: tuple[str, ...] = ()
) -> tuple[int, set[str]]:
    """How many sums there are without one of their addends, and those that are not refused.

    The checker bounds its work, so that they are tried in several parts.
    """
    rows = {row.name: row for row in outcome.statement.obligations}
    lies: dict[str, list[LemmaStep]] = {}
    for step in outcome.steps:
        if isinstance(step, LemmaStep):
            claim: Any = step.claim
            context, proof = step.context, step.proof
        elif isinstance(step, ObligationStep):
            claim, context, proof = rows[step.name].claim, rows[step.name].context, step.proof
        else:
            continue
        if not isinstance(proof, Sum) or proof.using == too_long:
            continue
        for i in range(len(proof.addends)):
            fewer = proof._replace(addends=but(proof.addends, i))
            lie = LemmaStep(f"lie.{step.name}.{i}", context, claim, fewer)
            lies.setdefault(step.name, []).append(lie)
    left: set[str] = set()
    for part in range(parts):
        here = dict(list(lies.items())[part::parts])
        steps = [new for old in outcome.steps for new in (*here.get(old.name, []), old)]
        names = {lie.name for group in here.values() for lie in group}
        lines = report(outcome._replace(steps=tuple(steps))).lines
        left |= names - {
            line.split()[2].rstrip(":") for line in lines if line.startswith("REFUSED lemma")
        }
    return sum(map(len, lies.values())), left
