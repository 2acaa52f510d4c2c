"""Variables without bounds: where the claim fails they may have some, from linear facts.

If x <= q follows from the facts and the negation of the claim, the claim holds for all x >= q' > q,
and a search is needed below q' only.
"""

from __future__ import annotations

from fractions import Fraction

from verify.language.terms import symbol
from verify.prover.goal import Bounds
from verify.prover.proof import Proof
from verify.prover.rules import Cuts, Sum
from verify.prover.search.bernstein_boxes import by_bernstein
from verify.prover.search.linear import Multiple, least, sum_of_facts
from verify.prover.search.question import Question
from verify.prover.search.system import System

#: How far beyond the bound the cut lies, as a share of its size.
ROOM = Fraction(1, 1000)
MAX_CUTS = 4


class Restriction:
    """Cuts of variables, and why the claim holds beyond each."""

    def __init__(self, question: Question) -> None:
        self.question, self.system = question, System(question)
        self.cuts: list[tuple[str, Fraction, int, Sum]] = []
        self.variables = dict(question.goal.variables)
        for name in self.variables:
            for sign in (1, -1):
                self._cut(name, sign)

    def _cut(self, name: str, sign: int) -> None:
        """Bound a variable below (above) where the claim fails, if it has no bound yet."""
        system, bounds = self.system, self.variables[name]
        known = bounds.low if sign > 0 else bounds.high
        generator = system.clearing.generators.get(symbol(name))
        if known is not None or generator is None:
            return
        one = system.clearing.one
        multiples = [Multiple(p, key, one) for key, p in system.equations.items()]
        facts = [system.goal, *system.facts]
        found = least(system, facts, sign * generator, multiples)
        if found is None:
            return
        bound, weights, shares = found
        room = (1 + abs(bound)) * ROOM
        at = (sign * (bound - room)).limit_denominator(int(4 / room) + 1)
        rest = bound - sign * at
        if rest <= 0:
            return
        fact = f"@{len(self.cuts) + 1}"
        beyond = sum_of_facts(system, (str(rest), fact), (weights, facts), (shares, multiples))
        self.cuts.append((name, at, sign, beyond))
        new = {"low": at, "low_fact": fact, "low_relation": "<="}
        if sign < 0:
            new = {"high": at, "high_fact": fact, "high_relation": "<="}
        self.variables[name] = Bounds(**{**bounds._asdict(), **new})

    def written(self, proof: Proof) -> Proof:
        """The proof inside all cuts, with those beyond them."""
        for name, at, sign, beyond in reversed(self.cuts):
            branches = (beyond, proof) if sign > 0 else (proof, beyond)
            proof = Cuts(symbol(name), (at,), branches)
        return proof


def by_restriction(question: Question, parts: int) -> Proof | None:
    """A proof on a box, outside of which linear facts show the claim."""
    found = Restriction(question)
    if not 0 < len(found.cuts) <= MAX_CUTS:
        return None
    goal = question.goal._replace(variables=found.variables)
    proof = by_bernstein(Question(goal, question.known), parts, len(found.cuts))
    return None if proof is None else found.written(proof)
