"""What algebra decides of Theorem 1 at every point, kept so that a point run need not look for it.

Some rows hold with equality, so that no enclosure decides them; which ones depends on which entry
of a minimum is the least. Their proofs are found at two points that differ in this, each of them
alone: beside definitions it uses nothing but claims that enclosures have shown
on the way. The checker accepts it. No proof is kept that uses the value of a parameter, or of a
constant that is rounded. So the proof holds wherever those claims hold, and a point run shows them
by enclosures of its own.
"""

from __future__ import annotations

from fractions import Fraction
from typing import Any

from verify.language.errors import OwnError
from verify.language.statement import Choice, Constant, Obligation, Statement
from verify.language.terms import Claim, as_term
from verify.paper.commands.theorem1 import decide_point
from verify.paper.theorem1 import theorem
from verify.prover.ground import ALGEBRA, Ground
from verify.prover.outcome import Outcome
from verify.prover.proof import LemmaStep, OpenStep
from verify.prover.rules import Interval
from verify.prover.session import Session
from verify.wire.compiled import Kept
from verify.wire.judge import judged

#: The values of r at which the proofs are looked for.
POINTS = Fraction(3, 100), Fraction(1, 100)


def kept() -> dict[Claim, Kept]:
    """The verdicts on claims of rows, with the claims on which their proofs rest."""
    found: dict[Claim, Kept] = {}
    for r in POINTS:
        values: dict[str, Fraction | int] = {
            "r": r,
            "c": 1,
            "V_0": 1,
            "delta_theta": Fraction(1, 10),
        }
        outcome = decide_point({name: as_term(value) for name, value in values.items()})
        for row, decision in outcome.rows:
            if (
                isinstance(row.claim, Claim)
                and decision.judge == ALGEBRA
                and row.claim not in found
            ):
                alone = _alone(outcome.statement, row)
                if not _numbers() & _used(alone):
                    found[row.claim] = Kept(alone.decisions[row.name].verdict, _needs(alone))
    return found


def _alone(statement: Statement, row: Obligation) -> Outcome:
    """The row, decided without the other rows, and judged by the checker."""
    session = Session()
    ground = Ground(session)
    values = (Constant(name, name, name, "", term) for name, term in statement.parameters.items())
    for constant in (*values, *statement.constants):
        ground.define(constant)
    decision = ground.decide(row)
    if decision.proof is None:
        raise OwnError(f"{row.name} is not decided without other rows")
    alone = statement._replace(obligations=(row._replace(uses=()),), assumptions=(), cites=())
    return judged(Outcome(alone, {row.name: decision}, tuple(session.steps), {}))


def _needs(outcome: Outcome) -> tuple[Claim, ...]:
    """The claims that enclosures have shown."""
    lemmas = (step for step in outcome.steps if isinstance(step, LemmaStep))
    return tuple(step.claim for step in lemmas if isinstance(step.proof, Interval))


def _used(outcome: Outcome) -> set[str]:
    """All words in proofs: among them are the definitions and facts that they use."""
    waiting: list[Any] = [step.proof for step in outcome.steps if not isinstance(step, OpenStep)]
    found: set[str] = set()
    while waiting:
        part = waiting.pop()
        if isinstance(part, tuple):
            waiting += part
        elif isinstance(part, str):
            found.add(part)
    return found


def _numbers() -> set[str]:
    """The names whose definitions are numbers of a point: parameters, and what is rounded."""
    choices = (c for part in theorem().parts.values() for c in part.constants)
    return {*theorem().parameters, *(c.constant.name for c in choices if isinstance(c, Choice))}
