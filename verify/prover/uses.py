"""Which facts a proof names: the edges of the graph of a proof."""

from __future__ import annotations

from collections.abc import Iterator
from typing import Any

from verify.language.record import Record
from verify.language.statement import Always, Applies
from verify.language.terms import Claim, equal, symbol
from verify.prover.outcome import Outcome
from verify.prover.proof import (
    ConstantStep,
    DefinitionStep,
    LemmaStep,
    ObligationStep,
    OpenStep,
    Proof,
    leaves,
)

#: Values of sums that are no names of facts.
_NO_FACTS = ("goal", "add", "mul", "pow", "square", "root")


class Node(Record):
    """A fact, and the names of those that its proof uses, in the order of first use."""

    name: str
    kind: str  # given, constant, definition, lemma or obligation
    context: str | None
    claim: Claim | Applies | Always
    proof: Proof | None
    uses: tuple[str, ...]


def nodes(outcome: Outcome) -> dict[str, Node]:
    """The facts of an outcome by their names, each after those it uses."""
    rows = {row.name: row for row in outcome.statement.obligations}
    contexts = {context.name: context for context in outcome.statement.contexts}
    homes = {c.name: k for k, context in contexts.items() for c in context.constants}
    terms = dict(outcome.statement.parameters)
    for constants in (outcome.statement.constants, *(c.constants for c in contexts.values())):
        terms |= {constant.name: constant.term for constant in constants}
    variables = {variable.name for c in contexts.values() for variable in c.variables}
    found: dict[str, Node] = {}
    for step in outcome.steps:
        if isinstance(step, OpenStep):
            for given in contexts[step.name].givens:
                node = Node(given.name, "given", step.name, given.claim, None, ())
                found[given.name] = node
            continue
        names = dict.fromkeys(facts_of(step.proof))
        used = tuple(name for name in names if name not in variables)
        if isinstance(step, ObligationStep):
            row = rows[step.name]
            node = Node(step.name, "obligation", row.context, row.claim, step.proof, used)
        elif isinstance(step, LemmaStep):
            node = Node(step.name, "lemma", step.context, step.claim, step.proof, used)
        elif isinstance(step, DefinitionStep):
            claim = equal(symbol(step.name), step.term)
            node = Node(step.name, "definition", step.context, claim, step.proof, used)
        elif isinstance(step, ConstantStep):
            claim = equal(symbol(step.name), terms[step.name])
            node = Node(step.name, "constant", homes.get(step.name), claim, step.proof, used)
        found[step.name] = node
    return found


def facts_of(proof: Any) -> Iterator[str]:
    """The names of facts in a proof, and of variables; hypotheses of its branches are left out."""
    if isinstance(proof, str):
        yield from () if proof.startswith("@") else (proof,)
        return
    for leaf, value in leaves(proof):
        if leaf in ("proof", "premise"):
            yield from facts_of(value)
        elif leaf in ("reference", "context_name", "value"):
            yield from (fact for fact in _names(value) if not fact.startswith("@"))


def _names(value: Any) -> Iterator[str]:
    if isinstance(value, str):
        if value not in _NO_FACTS and value[0].isalpha():
            yield value
    elif isinstance(value, tuple):
        for item in value:
            yield from _names(item)
