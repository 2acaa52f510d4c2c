"""Statements with something missing or changed, and what the checker says of them."""

from __future__ import annotations

from collections.abc import Callable, Iterable, Iterator
from fractions import Fraction
from typing import Any

from tests.citing import cited
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
    return check.check(files["statement.json"], files["certificate.json"], cited(files))


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


def fewer(claim: Claim, proof: Sum) -> Iterator[tuple[Claim, Sum]]:
    """The same claim by the sum without one of its addends."""
    for i in range(len(proof.addends)):
        yield claim, proof._replace(addends=but(proof.addends, i))


def stronger(claim: Claim, proof: Sum) -> Iterator[tuple[Claim, Sum]]:
    """A little more on the smaller side, by the same sum."""
    yield Claim(claim.relation, claim.lhs + Fraction(1, 1000), claim.rhs), proof


def accepted_lies(
    outcome: Outcome,
    parts: int,
    lies_about: Callable[[Claim, Sum], Iterable[tuple[Claim, Sum]]] = fewer,
    too_long: tuple[str, ...] | None = None,
) -> tuple[int, set[str]]:
    """How many lies there are about the sums of a certificate, and those that are not refused.

    Each is a lemma before the step that it is about. The checker bounds its work, so that they are
    tried in several parts; sums that use just the equations in `too_long` are left out.
    """
    rows = {row.name: row for row in outcome.statement.obligations}
    lies: dict[str, list[LemmaStep]] = {}
    for step in outcome.steps:
        if not isinstance(step, LemmaStep | ObligationStep) or not isinstance(step.proof, Sum):
            continue
        place = step if isinstance(step, LemmaStep) else rows[step.name]
        if isinstance(place.claim, Claim) and step.proof.using != too_long:
            lies[step.name] = [
                LemmaStep(f"lie.{step.name}.{i}", place.context, *lie)
                for i, lie in enumerate(lies_about(place.claim, step.proof))
            ]
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
