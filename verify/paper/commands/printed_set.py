"""The job `printed-set`: the set as printed does what the theorem claims, for all parameters."""

from __future__ import annotations

from functools import cache

from verify.language.argument import Chapter, Opened
from verify.language.statement import PROVED, REFUTED, UNDECIDED, Statement
from verify.language.terms import symbol
from verify.paper.commands import pages
from verify.paper.commands.everywhere import Everywhere
from verify.paper.everywhere import chart, hints
from verify.paper.parameters import PRINTED
from verify.paper.printed_set import numbers, printed_set
from verify.paper.step import STEP
from verify.prover.outcome import Outcome
from verify.prover.rules import Applying
from verify.wire.judge import known
from verify.wire.packaged import PRINTED_SET


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


def verdicts_as_printed() -> dict[str, str]:
    """The verdicts on the theorem with its sign as printed, and on its set with the other sign.

    They are those of the certificates that come with the program; what differs is decided anew.
    """
    with_sign = pages.accepted("printed_sign", anew=False)
    of_set = known(PRINTED_SET, _stated()) or decide_printed_set()
    return {"sign": REFUTED if with_sign.verdict == PROVED else UNDECIDED, "set": of_set.verdict}
