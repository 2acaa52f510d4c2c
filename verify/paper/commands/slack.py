"""The job `slack`: which bounds of Theorem 1 for all parameters could be sharper.

A row is strengthened by taking nine tenths of its larger side; a row that says the sign of a term
is left as it is. The proof of the row must not prove the stronger claim, and the checker has to
say so. Where another sum proves it, of products of the same facts, of the signs of the chart, and
of the entries of the minima that are in the row, and the checker accepts it, the bound has slack.
"""

from __future__ import annotations

from collections.abc import Collection, Iterable, Iterator
from fractions import Fraction

from verify import check
from verify.language.argument import ByNames, BySum
from verify.language.record import Record
from verify.language.statement import Obligation
from verify.language.terms import Claim, Term, as_term, names_of, substitute
from verify.paper.commands import pages
from verify.paper.parameters import PARAMETERS, REPAIRED
from verify.prover.arguments import Writing, facts_of
from verify.prover.budget import WorkBudget
from verify.prover.ground import Ground
from verify.prover.outcome import Outcome
from verify.prover.proof import LemmaStep, Proof, Step
from verify.prover.rules import Sum
from verify.prover.session import ZERO
from verify.wire.write import digest, write

SHARE = Fraction(9, 10)
#: The signs of the chart, and the work for one bound.
SIGNS = ("u-positive", "u-below-one", "p-positive", "p-below-half")
WORK = 2_000_000
#: The page with the bounds, and its context.
PAGE, CONTEXT = "all_parameters", "everywhere"
#: Where the signs of the sides are looked up: r, -cos theta_0, V_0 and delta_theta.
POINT = ("3/100", "1", "1", "1/10")


class Bound(Record):
    """A row with its stronger claim; ``fresh`` is a proof of that, if one was found."""

    row: Obligation
    stronger: Claim
    proof: Proof
    fresh: Proof | None = None


class Slack(Record):
    """What the checker says: the bounds that the old proofs prove, too, and those with new ones."""

    bounds: list[Bound]
    accepted: set[str]
    slack: set[str]


def stronger(claim: Claim, values: dict[str, Term], ground: Ground) -> Claim | None:
    """The claim with nine tenths of its larger side; None if that has no sign, or is 0."""
    relation, lhs, rhs = claim.key
    left, right = (ground.sign(substitute(side, values)) for side in (lhs, rhs))
    if right > 0 and left:
        return Claim(relation, lhs, SHARE * rhs)
    return Claim(relation, SHARE * lhs, rhs) if left < 0 and right else None


def find_slack(rows: Collection[str] | None = None, *, search: bool = True) -> Slack:
    """Bounds strengthened and judged by the checker: all, or those of some rows.

    Without ``search`` no other proofs are looked for.
    """
    argument = pages.argument(PAGE)
    work = Writing(argument.statement, budget=WorkBudget(WORK))
    for chapter in argument.chapters:
        work.chapter(chapter)
    outcome = Outcome(argument.statement, work.decisions, tuple(work.session.steps), {})
    bounds = [
        bound._replace(fresh=_fresh(work, bound)) if search else bound
        for bound in _bounds(work, outcome)
        if rows is None or bound.row.name in rows
    ]
    steps = (*work.session.steps, *_steps(bounds))
    lines = _report(outcome._replace(steps=steps))
    refused = {line.split()[2].rstrip(":") for line in lines if line.startswith("REFUSED lemma")}
    return Slack(
        bounds,
        {b.row.name for b in bounds if f"old.{b.row.name}" not in refused},
        {b.row.name for b in bounds if b.fresh and f"new.{b.row.name}" not in refused},
    )


def _bounds(work: Writing, outcome: Outcome) -> Iterator[Bound]:
    values, ground = values_at(POINT), Ground(work.session)
    for row, found in outcome.rows:
        if isinstance(row.claim, Claim) and row.context == CONTEXT and found.proof is not None:
            sharper = stronger(row.claim, values, ground)
            if sharper is not None:
                yield Bound(row, sharper, found.proof)


def _fresh(work: Writing, bound: Bound) -> Proof | None:
    """Another sum of products, if one is found."""
    if not isinstance(bound.proof, Sum):
        return None
    old = BySum(bound.proof.addends, bound.proof.using, bound.proof.equations)
    facts = dict.fromkeys((*facts_of(old), *SIGNS, *_entries(work, bound.stronger)))
    return work.found(bound.stronger, ByNames((*facts,)), CONTEXT)


def _entries(work: Writing, claim: Claim) -> Iterator[str]:
    """What is known of the minima in a claim, and of no others, in the chart."""
    own = _minima(claim)
    for name, known in work.session.claims.items():
        if known.lhs == ZERO and own.issuperset(_minima(known)) and _minima(known):
            yield name


def _minima(claim: Claim) -> set[str]:
    """The constants of the set in a claim."""
    return {name for name in names_of(claim.lhs, claim.rhs) if name.startswith(f"{REPAIRED}.")}


def values_at(point: tuple[str, ...]) -> dict[str, Term]:
    """All constants at r, -cos theta_0, V_0 and delta_theta, as terms without names."""
    values = {name: as_term(Fraction(x)) for name, x in zip(PARAMETERS, point, strict=True)}
    for constant in pages.statement(PAGE).context(CONTEXT).constants:
        values[constant.name] = substitute(constant.term, values)
    return values


def _steps(bounds: Iterable[Bound]) -> Iterator[Step]:
    for bound in bounds:
        name = bound.row.name
        yield LemmaStep(f"old.{name}", CONTEXT, bound.stronger, bound.proof)
        if bound.fresh is not None:
            yield LemmaStep(f"new.{name}", CONTEXT, bound.stronger, bound.fresh)


def _report(outcome: Outcome) -> list[str]:
    """What the checker says of a certificate, line by line."""
    files = write(outcome)
    cited = {digest(data): data for name, data in files.items() if name.startswith("cited/")}
    return check.check(files["statement.json"], files["certificate.json"], cited).lines
