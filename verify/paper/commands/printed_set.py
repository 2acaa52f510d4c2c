"""The job `printed-set`: the set as printed does what the theorem claims, for all parameters."""

from __future__ import annotations

from functools import cache

from verify.language.argument import Chapter, Opened
from verify.language.statement import PROVED, REFUTED, UNDECIDED, Statement
from verify.language.terms import symbol
from verify.paper.commands import pages
from verify.paper.commands.classification import decide_classification
from verify.paper.commands.everywhere import Everywhere
from verify.paper.everywhere import chart, hints
from verify.paper.parameters import PRINTED
from verify.paper.printed_set import numbers, printed_set, sign
from verify.paper.step import STEP
from verify.prover.arguments import Writing
from verify.prover.ground import Ground
from verify.prover.outcome import Outcome
from verify.prover.rules import Applying
from verify.wire.judge import judged, known
from verify.wire.packaged import PRINTED_SET, PRINTED_SIGN, packaged_files
from verify.wire.read import cite_of
from verify.wire.write import write


@cache
def decide_printed_set() -> Outcome:
    """Every row, and that the sharper theorem applies; the checker has judged it."""
    statement = _stated()
    here, start = statement.contexts[1], pages.statement("sharper").context("start")
    work = Everywhere(statement, PRINTED)
    work.prepare()
    least = f"{PRINTED}.delta_x"
    work._prove(hints.LEAST, chart.LEAST_DELTA <= symbol(least), work._least(least))
    work.lines(hints.about_zeta_bar(numbers.k))
    for constant in numbers.CONSTANTS:
        work.constant(constant, constant.name)
    work.lines(numbers.room(start))
    for constant in numbers.turned(start):
        work.constant(constant, constant.name)
    work.lines(numbers.conclusions())
    work.lines(printed_set.inside(here))
    point = tuple(f"at-{name}" for name in here.claims)
    work.writing.chapter(Chapter(None, (Opened(here, point),)))
    work.writing.chapter(Chapter(here.name, tuple(printed_set.lines(start))))
    givens = tuple(printed_set.premises(here, start))
    work.writing.decide(work.writing.rows[printed_set.COLLAPSE], Applying(givens))
    return work.outcome()


def _stated() -> Statement:
    """The statement, which cites the sharper theorem."""
    initial = pages.statement(STEP).context("initial")
    return printed_set.statement(initial, pages.statement("sharper"), pages.cite("sharper"))


@cache
def decide_printed_sign() -> Outcome:
    """That the theorem is false with the sign as printed; the checker has judged it."""
    files = write(decide_classification())
    argument = sign.sign(cite_of(files["statement.json"], files["certificate.json"]))
    writing = Writing(argument.statement)
    for chapter in argument.chapters:
        writing.chapter(chapter)
    ground = Ground(writing.session)
    for row in sign.at_the_point():
        writing.decisions[row.name] = ground.decide(row)
    writing.decide(writing.rows[sign.COLLAPSE], Applying(sign.PREMISES))
    return judged(Outcome(argument.statement, writing.decisions, tuple(writing.session.steps), {}))


def verdicts_as_printed() -> dict[str, str]:
    """The verdicts on the theorem with its sign as printed, and on its set with the other sign.

    They are those of the certificates that come with the program; what differs is decided anew.
    """
    stated = sign.sign(cite_of(*packaged_files("classification"))).statement
    with_sign = known(PRINTED_SIGN, stated) or decide_printed_sign()
    of_set = known(PRINTED_SET, _stated()) or decide_printed_set()
    return {"sign": REFUTED if with_sign.verdict == PROVED else UNDECIDED, "set": of_set.verdict}
