"""The sharper theorem as a statement, and its argument in the order in which it is proved."""

from __future__ import annotations

from collections.abc import Iterator
from functools import cache

from verify.language.argument import Argument, ByInduction, Chapter, Line, Opened, argue
from verify.language.statement import Always
from verify.paper.dynamics import impact, plane
from verify.paper.dynamics.state import CONTEXT
from verify.paper.parameters import THEOREM
from verify.paper.sharper import (
    apart,
    bounds,
    collision,
    conclusion,
    flight,
    numbers,
    recursion,
    start,
    state,
)
from verify.paper.sharper.assumptions import ASSUMPTIONS

NAME = "sharper"
TITLE = (
    "From every state just after a collision that satisfies finitely many inequalities the "
    "particles collapse: only 0-1 and 0-2 collide, in turn, for ever, within a known time, with "
    "-cos of the final angle within known bounds"
)


@cache
def sharper() -> Argument:
    """The theorem, built once per process."""
    return argue(NAME, TITLE, _chapters(), ASSUMPTIONS)


def _chapters() -> Iterator[Chapter]:
    spaces = (numbers.context(), plane.context(), impact.context())
    yield Chapter(None, tuple(Opened(space) for space in spaces))
    yield Chapter(impact.CONTEXT, tuple(impact.lines()))
    yield Chapter(plane.CONTEXT, tuple(plane.lines(state.PAIRS)))
    yield Chapter(
        numbers.CONTEXT, (*bounds.lines(), *start.lines(), Opened(state.context(), start.opening()))
    )
    yield Chapter(
        CONTEXT, (*flight.lines(), *collision.lines(), *recursion.lines(), *conclusion.lines())
    )
    yield from apart.chapters()
    yield Chapter(numbers.CONTEXT, (_always(),))


def _always() -> Line:
    conditions = state.conditions()
    return Line("always", Always(CONTEXT, state.beginning, state.following()),
                ByInduction(tuple(f"start-{name}" for name in conditions),
                            tuple(f"next-{name}" for name in conditions)), THEOREM,
                "by induction on n all conditions hold after the n-th collision, for every n",
                tuple(assumption.name for assumption in ASSUMPTIONS))  # fmt: skip
