"""The job `box`: Theorem 1 at all points of a box of parameters, from the facts for all of them."""

from __future__ import annotations

from collections.abc import Mapping
from fractions import Fraction
from typing import NamedTuple

from verify.jobs.arguments import Writing, proof_of
from verify.jobs.everywhere import decide_everywhere
from verify.language.statement import PROVED, REFUTED, UNDECIDED, Cite, Constant, Statement
from verify.language.terms import Claim, Term, as_term
from verify.paper.argument import Chapter, Line, Opened, ToBeFound
from verify.paper.everywhere import box as paper
from verify.paper.everywhere.theorem import NAME as EVERYWHERE
from verify.prover.ground import Ground
from verify.prover.outcome import Decision, Enclosure, Outcome
from verify.prover.rules import Applying
from verify.wire.write import write

Side = tuple[Fraction, Fraction]

#: The largest denominator of an end of the part where the hypotheses hold.
FINEST = 10**9


class Box(NamedTuple):
    """Closed intervals of r and of -cos theta_0."""

    r: Side
    c: Side


def excess(r: Fraction, c: Fraction) -> Fraction:
    """Positive where the stability condition holds: it falls in r and, where it is 0, grows in c."""
    return (1 + r) ** 2 * c**3 / 8 - 3 * r * c / 2 - r


def verdict(box: Box) -> str:
    """Whether the hypotheses hold on the whole box, fail on the whole box, or neither."""
    if excess(box.r[1], box.c[0]) > 0:
        return PROVED
    return REFUTED if excess(box.r[0], box.c[1]) <= 0 else UNDECIDED


def largest_part(box: Box) -> Box:
    """A part of an undecided box on which the hypotheses hold: the largest of some."""
    (low, high), (first, last) = box
    found = []
    for k in range(17):
        c = first + (last - first) * k / 16
        if excess(low, c) > 0:
            found.append(Box((low, _last_r(low, high, c)), (c, last)))
    if not found:  # only next to the corner
        found.append(Box((low, low), (last, last)))
    return max(found, key=lambda part: (_length(part.r) * _length(part.c), _length(part.r)))


def _length(side: Side) -> Fraction:
    return side[1] - side[0]


def _last_r(low: Fraction, high: Fraction, c: Fraction) -> Fraction:
    """An r up to which the condition holds with this c, close to the last one."""
    if excess(high, c) > 0:
        return high
    good, bad = low, high
    while bad - good > Fraction(1, FINEST):
        middle = (good + bad) / 2
        good, bad = (middle, bad) if excess(middle, c) > 0 else (good, middle)
    short = Fraction(good.numerator * FINEST // good.denominator, FINEST)
    return max(low, short)


def decide_box(box: Box, v_0: Fraction, delta_theta: Fraction) -> Outcome:
    """The theorem at all points of a box on which its hypotheses hold, or fail, everywhere.

    Raises:
        ValueError: if they do neither.
    """
    found = verdict(box)
    if found == UNDECIDED:
        raise ValueError("the hypotheses hold on a part of the box")
    values = dict(zip(paper.PARAMETERS, (*box.r, *box.c, v_0, delta_theta), strict=True))
    files = write(decide_everywhere())
    cite = Cite(
        paper.CITED, EVERYWHERE, files["statement.json"], decide_everywhere().statement.cites
    )
    holds = found == PROVED
    terms = {name: as_term(value) for name, value in values.items()}
    return BoxRun(paper.statement(terms, cite, holds=holds)).run(holds=holds)


class BoxRun:
    """The steps for one box."""

    def __init__(self, statement: Statement) -> None:
        self.statement = statement
        self.writing = Writing(statement)
        self.session = self.writing.session
        self.ground = Ground(self.session)

    def run(self, *, holds: bool) -> Outcome:
        """Numbers first, then what follows from the corner at all points."""
        for name, term in self.statement.parameters.items():
            self.ground.define(Constant(name, name, name, "", term))
        for line in paper.numbers(holds=holds):
            self._number(line)
        opened = Opened(self.statement.contexts[0], ("r-there", "r-ends", "c-ends", "c-there"))
        self.writing.chapter(Chapter(None, (opened,)))
        self.writing.chapter(Chapter(paper.CONTEXT, paper.lines()))
        stability = self.writing.rows[paper.STABILITY]
        if holds:
            self.writing.decide(stability, proof_of(paper.stable()))
            self.writing.decide(self.writing.rows[paper.APPLIED], Applying(paper.premises()))
        else:
            proof = proof_of(paper.unstable())
            self.session.prove_row(stability, proof, holds=False)
            self.writing.decisions[stability.name] = Decision(REFUTED, proof)
        steps = tuple(self.session.steps)
        return Outcome(self.statement, self.writing.decisions, steps, self._enclosures())

    def _number(self, line: Line) -> None:
        if not isinstance(line.reason, ToBeFound):
            self.writing.line(line, None)
        elif isinstance(line.claim, Claim):
            found, proof = self.ground.prove(line.claim)
            if found != PROVED or proof is None:
                raise ArithmeticError(f"{line.name} is not proved")
            self.session.lemma(line.claim, proof, None, line.name)

    def _enclosures(self) -> Mapping[str, Enclosure]:
        terms: Mapping[str, Term] = self.statement.parameters
        found = {name: self.ground.enclose(term) for name, term in terms.items()}
        return {name: enclosure for name, enclosure in found.items() if enclosure is not None}
