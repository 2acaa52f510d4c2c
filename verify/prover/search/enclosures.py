"""Claims on a box by the enclosures of both sides with many bits: on all of it, or on few parts."""

from __future__ import annotations

from verify.prover import balls
from verify.prover.constants import DEFAULT_PRECISION
from verify.prover.goal import Bounds
from verify.prover.proof import Proof
from verify.prover.search.question import Question
from verify.prover.search.tree import Halves, Piece, Tree

#: As many as claims without variables get at first: the checker encloses constants once.
BITS = 224
LEAVES = 1024


def by_interval(question: Question) -> Proof | None:
    """The enclosures on the whole box."""
    tree = InTurn.of(question)
    return tree.leaf(tree.root) if tree is not None and tree.is_shown(tree.root.ends) else None


def by_cuts(question: Question) -> Proof | None:
    """The enclosures on parts of the box."""
    tree = InTurn.of(question) if question.plain.variables else None
    return None if tree is None else tree.prove(LEAVES)


class InTurn(Tree):
    """A tree in which the variables are cut one after the other, each in its middle.

    Constants without variables are numbers between the ends of their balls, which nothing cuts.
    """

    bits, most_cuts = BITS, 16

    @classmethod
    def of(cls, question: Question) -> InTurn | None:
        """The tree of a claim about variables between numbers; None for others."""
        goal, constants = question.plain, {}
        if goal.box is None or goal.claim.relation == "=":
            return None
        for name in goal.constants:
            ball = question.known.enclosed(name, DEFAULT_PRECISION)
            if ball is None:
                return None
            with balls.precision(BITS):  # at which the ends of balls are rounded
                constants[name] = Bounds(*balls.ends(ball))
        tree = cls(goal.claim, {**goal.variables, **constants}, goal.definitions, question.budget)
        tree.cut = len(goal.variables)
        return tree

    cut = 0  # how many of the names are variables

    def best(self, box: Piece) -> tuple[int, Halves]:
        """The next variable, and its two halves."""
        index = box.depth % self.cut
        low, high = box.ends[index]
        return index, self.halves(box, index, (low + high) / 2)
