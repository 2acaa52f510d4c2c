"""The job `box`: Theorem 1 at all points of a box of parameters, from the facts for all of them."""

from __future__ import annotations

from collections.abc import Mapping
from fractions import Fraction

from verify.language.argument import Chapter, Line, Opened, ToBeFound
from verify.language.errors import OwnError
from verify.language.fold import RATIONAL, fold
from verify.language.statement import PROVED, REFUTED, UNDECIDED, Constant, Statement
from verify.language.terms import Claim, Term, as_term, symbol
from verify.paper import box as paper
from verify.paper.commands import pages
from verify.prover.arguments import Writing, proof_of
from verify.prover.decimals import round_decimal
from verify.prover.ground import Ground
from verify.prover.outcome import Decision, Enclosure, Outcome
from verify.prover.rules import Applying
from verify.views.findings import Answer, ParameterBox
from verify.wire.judge import judged

#: Digits of the last r of a part on which the hypotheses hold.
DIGITS = 9
#: How many parts the interval of c is cut into to look for the largest such part.
PARTS = 16


def answer(box: ParameterBox, v_0: Fraction, delta_theta: Fraction) -> Answer:
    """Whether the hypotheses, and the theorem, hold at all points of a box."""
    found = verdict(box)
    part = largest_part(box) if found == UNDECIDED else box
    return Answer(box, part, decide_box(part, v_0, delta_theta))


def _excess(r: Fraction, c: Fraction) -> Fraction:
    return fold(paper.EXCESS, RATIONAL, {symbol("r"): r, symbol("c"): c})


def verdict(box: ParameterBox) -> str:
    """Whether the hypotheses hold on the whole box, fail on the whole box, or neither."""
    if _excess(box.r[1], box.c[0]) > 0:
        return PROVED
    return REFUTED if _excess(box.r[0], box.c[1]) <= 0 else UNDECIDED


def largest_part(box: ParameterBox) -> ParameterBox:
    """A part of an undecided box on which the hypotheses hold: the largest of some."""
    (low, high), (first, last) = box
    ends = [first + (last - first) * k / PARTS for k in range(PARTS + 1)]
    if low == high:
        ends = [_first_c(low, first, last)]
    good = [c for c in ends if _excess(low, c) > 0]
    parts = [ParameterBox((low, _last_r(low, high, c)), (c, last)) for c in good]
    return max(parts, key=lambda part: (part.area, part.r[1]))


def _last_r(low: Fraction, high: Fraction, c: Fraction) -> Fraction:
    """An r up to which the condition holds with this c, close to the last such r."""
    if _excess(high, c) > 0:
        return high
    good, bad = low, high
    while (bad - good) * 10**DIGITS > bad:
        middle = (good + bad) / 2
        good, bad = (middle, bad) if _excess(middle, c) > 0 else (good, middle)
    mantissa, exponent = round_decimal(good, DIGITS, up=False)
    return max(low, mantissa * Fraction(10) ** exponent)


def _first_c(r: Fraction, first: Fraction, last: Fraction) -> Fraction:
    """A c from which on the condition holds with this r, close to the first such c."""
    bad, good = first, last
    while (good - bad) * 10**DIGITS > good:
        middle = (good + bad) / 2
        bad, good = (bad, middle) if _excess(r, middle) > 0 else (middle, good)
    mantissa, exponent = round_decimal(good, DIGITS, up=True)
    return min(last, mantissa * Fraction(10) ** exponent)


def decide_box(box: ParameterBox, v_0: Fraction, delta_theta: Fraction) -> Outcome:
    """The theorem at all points of a box on which its hypotheses hold, or fail, everywhere.

    Raises:
        ValueError: if they do neither.
    """
    found = verdict(box)
    if found == UNDECIDED:
        raise ValueError("the hypotheses hold on a part of the box only")
    values = dict(zip(paper.PARAMETERS, (*box.r, *box.c, v_0, delta_theta), strict=True))
    cite = pages.cite("all_parameters")._replace(name=paper.CITED)
    holds = found == PROVED
    terms = {name: as_term(value) for name, value in values.items()}
    return BoxRun(paper.statement(terms, cite, holds=holds)).run(holds=holds)


def are_ends(parameters: Mapping[str, Term]) -> bool:
    """Whether these are the parameters of a box on which the hypotheses hold everywhere."""
    if tuple(sorted(parameters)) != tuple(sorted(paper.PARAMETERS)):
        return False
    if any(term.op != "rational" for term in parameters.values()):
        return False
    ((r_low, r_high), (c_low, c_high)), v_0, delta_theta = read_box(parameters)
    in_range = 0 < r_low <= r_high < 1 and 0 < c_low <= c_high <= 1 and min(v_0, delta_theta) > 0
    return in_range and verdict(ParameterBox((r_low, r_high), (c_low, c_high))) == PROVED


def read_box(parameters: Mapping[str, Term]) -> tuple[ParameterBox, Fraction, Fraction]:
    """The box, V_0 and delta_theta that are the parameters of a statement."""
    r_low, r_high, c_low, c_high, *others = (parameters[n].value for n in paper.PARAMETERS)
    return ParameterBox((r_low, r_high), (c_low, c_high)), others[0], others[1]


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
            self.writing.decide(self.writing.rows[paper.APPLIED], Applying(self._premises()))
        else:
            proof = proof_of(paper.unstable())
            self.session.prove_row(stability, proof, holds=False)
            self.writing.decisions[stability.name] = Decision(REFUTED, proof)
        steps = tuple(self.session.steps)
        return judged(Outcome(self.statement, self.writing.decisions, steps, self._enclosures()))

    @staticmethod
    def _premises() -> tuple[str, ...]:
        """The facts which say that the hypotheses of the theorem for all parameters hold."""
        (everywhere,) = pages.statement("all_parameters").contexts
        return tuple(given.name for given in everywhere.givens)

    def _number(self, line: Line) -> None:
        if not isinstance(line.reason, ToBeFound):
            self.writing.line(line, None)
        elif isinstance(line.claim, Claim):
            found, proof = self.ground.prove(line.claim)
            if found != PROVED or proof is None:
                raise OwnError(f"{line.name} is not proved; nothing was written")
            self.session.lemma(line.claim, proof, None, line.name)

    def _enclosures(self) -> Mapping[str, Enclosure]:
        terms: Mapping[str, Term] = self.statement.parameters
        found = {name: self.ground.enclose(term) for name, term in terms.items()}
        return {name: enclosure for name, enclosure in found.items() if enclosure is not None}
