"""Proofs of rows in the chart: by a hint, by cases of a maximum, by roots, or by a sum."""

from __future__ import annotations

from collections.abc import Iterator, Mapping

from verify.language.argument import Reason
from verify.language.fold import replaced
from verify.language.terms import Claim, Term, names_of, parts_of, substitute_claim
from verify.prover import arguments
from verify.prover.clearing import divisors
from verify.prover.positivity import NotFoundError
from verify.prover.proof import Proof
from verify.prover.ring import Ring
from verify.prover.rules import Cases, Root, Sum
from verify.prover.session import ZERO


class RowProofs:
    """What proves a claim about the names of a ring.

    Args:
        ring: the facts, and where lemmas are written down.
        hints: reasons for rows by their names, one for each entry of a maximum.
        split: the minimum of which each entry is tried where no sum is found.
    """

    def __init__(self, ring: Ring, hints: Mapping[str, tuple[Reason, ...]], split: str) -> None:
        self.ring, self.hints, self.split = ring, hints, split
        self.session = ring.session

    def proof(self, name: str, claim: Claim) -> Proof:
        """A proof of the claim of a row; a name without a hint leaves all to the search.

        Raises:
            NotFoundError: if none is found.
        """
        known = self.hints.get(name)
        if known is not None:
            return self._hinted(claim, known)
        for term in _parts(claim.lhs, claim.rhs, "min", "max"):
            return self._cases(claim, term)
        for term in _parts(claim.rhs, claim.lhs, "sqrt"):
            if term not in self.ring.values and term not in self.ring.replaced:
                return self._root(claim, term)
        try:
            return self.ring.prove(claim)
        except NotFoundError:
            return self._split(claim)

    def _split(self, claim: Claim) -> Proof:
        """A branch for each entry of the minimum that delta_x is."""
        name = self.split
        if name not in set(names_of(claim.lhs, claim.rhs)):
            raise NotFoundError("nothing to split")
        term = self.session.definitions[name]
        branches = []
        for entry in term.children:
            values = {name: entry}
            found = self.ring.prove(substitute_claim(claim, values))
            branches.append(found._replace(using=(*found.using, name, "@1")))
        return Cases(term, tuple(branches))

    def _hinted(self, claim: Claim, reasons: tuple[Reason, ...]) -> Proof:
        """The reasons that the paper's room gives; several are one for each entry."""
        self.ring.ensure(claim.lhs, claim.rhs)
        proofs = tuple(map(arguments.proof_of, reasons))
        return (
            proofs[0]
            if len(proofs) == 1
            else Cases(next(_parts(claim.lhs, claim.lhs, "min", "max")), proofs)
        )

    def _cases(self, claim: Claim, term: Term) -> Proof:
        """A branch for each entry of a maximum."""
        self.ring.ensure(term)
        branches = (self._branch(claim, term, entry) for entry in term.children)
        return Cases(term, tuple(branches))

    def _branch(self, claim: Claim, term: Term, entry: Term) -> Sum:
        sides = (replaced(side, {term: entry}) for side in (claim.lhs, claim.rhs))
        there = Claim(claim.relation, *sides)
        found = self.ring.prove(there)
        return found._replace(using=(*found.using, "@1"))

    def _root(self, claim: Claim, root: Term) -> Proof:
        """sqrt(x) <= sqrt(y) from x <= y; 0 < x sqrt(y) from the signs of both."""
        inside = root.children[0]
        self.ring.ensure(inside)
        self.ring.lemma(0 < inside)
        sign = self.session.known(0 < root, self.ring.context)
        if sign is None:
            sign = self.session.lemma(0 < root, Root(), self.ring.context)
        if claim.lhs is ZERO:
            other = self.ring.lemma(0 < claim.rhs.children[0])
            return Sum(("goal", ("mul", other, sign)))
        if claim.rhs is not root or claim.lhs.op != "sqrt":
            raise NotFoundError("two roots are not compared")
        squares = self.ring.lemma(claim.lhs.children[0] <= inside)
        scale = [self.ring.lemma(0 < part) for part in divisors(inside)]
        goal = ("mul", *scale, "goal", ("add", "root-two", sign))
        return Sum((goal, squares))


def _parts(first: Term, second: Term, *ops: str) -> Iterator[Term]:
    """The parts of two terms by these operations, from the outside in."""
    return (part for part in parts_of(first, second) if part.op in ops)
