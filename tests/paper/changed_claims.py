"""Claims that are nearly those of a page: the checker refuses them with the proofs of its rows."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from functools import cache

from tests.paper.changed_statements import report
from verify.language.statement import NEEDED, Obligation
from verify.language.terms import Claim, Term, as_term, names_of, substitute
from verify.paper.commands.pages import decide, page
from verify.prover.proof import LemmaStep, ObligationStep


def made_from(claim: Claim, variables: Sequence[str]) -> Iterator[tuple[str, Claim]]:
    """With another sign or factor, a little stronger, and with another of the variables."""
    is_left = claim.rhs.op == "rational"
    side = claim.lhs if is_left else claim.rhs

    def with_side(term: Term) -> Claim:
        return Claim(claim.relation, *((term, claim.rhs) if is_left else (claim.lhs, term)))

    yield "sign", with_side(-side)
    if as_term(0) not in (claim.lhs, claim.rhs):
        yield "factor", with_side(side * 2)
    yield "stronger", Claim(claim.relation, claim.lhs + as_term(1) / 1000, claim.rhs)
    names = list(dict.fromkeys(names_of(side)))
    chosen = [name for name in names if name in variables]
    instead = [name for name in variables if name not in names] or chosen[1:]
    if chosen and instead:
        yield "index", with_side(substitute(side, {chosen[0]: Term("symbol", instead[0])}))


def changed_claims(name: str) -> dict[str, tuple[Obligation, Claim]]:
    """For each needed row of a page claims that are nearly the same."""
    statement = page(name).statement
    variables = {c.name: [v.name for v in c.variables] for c in statement.contexts}
    return {
        f"{row.name}.{kind}": (row, claim)
        for row in statement.obligations
        if isinstance(row.claim, Claim) and row.role == NEEDED
        for kind, claim in made_from(row.claim, variables.get(row.context or "", ()))
    }


@cache
def refused(name: str) -> set[str]:
    """Those that the checker refuses, each before the row and with the row's proof."""
    changed, steps = changed_claims(name), list[object]()
    for step in decide(name).steps:
        if isinstance(step, ObligationStep):
            for own, (row, claim) in changed.items():
                if row.name == step.name:
                    steps.append(LemmaStep(own, row.context, claim, step.proof))
        steps.append(step)
    found = report(decide(name)._replace(steps=tuple(steps)))  # type: ignore[arg-type]
    lines = [line for line in found.lines if line.startswith("REFUSED lemma ")]
    return {line.split()[2].rstrip(":") for line in lines}
