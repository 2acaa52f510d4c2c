"""The step as a statement, and its argument in the order in which it is proved."""

from __future__ import annotations

from collections.abc import Iterator
from functools import cache

from verify.language.argument import Argument, Chapter, Item, Opened, argue
from verify.paper.assumptions import STEP_ASSUMPTIONS
from verify.paper.dynamics import model
from verify.paper.dynamics.state import CONTEXT
from verify.paper.step import collision, flight, initial, numbers, state

TITLE = (
    "One step of the recursion, for every state that satisfies the conditions and all numbers that "
    "satisfy the rows of the hypotheses and of the repaired set; and the induction on the number "
    "of collisions"
)


@cache
def step() -> Argument:
    """The step, built once per process."""
    return argue(numbers.STEP, TITLE, chapters(), STEP_ASSUMPTIONS)


def chapters() -> Iterator[Chapter]:
    """The chapters of the step, in the order in which each uses what stands before it."""
    spaces = (Opened(numbers.context()), *model.spaces())
    yield Chapter(None, (*flight.ground_lines(), *spaces))
    yield from model.chapters(state.PAIRS)
    inside: tuple[Item, ...] = (*flight.rearranged(), *initial.inside_the_set())
    opened = Opened(initial.context(), tuple(f"at-{name}" for name in initial.GIVENS))
    yield Chapter(numbers.CONTEXT, (*inside, opened))
    yield Chapter(initial.CONTEXT, tuple(initial.lines()))
    yield Chapter(numbers.CONTEXT, tuple(initial.instances()))
    here = state.context(initial.CONTEXT, initial.state_point)
    yield Chapter(initial.CONTEXT, (Opened(here, initial.opening()),))
    yield Chapter(
        CONTEXT,
        (*flight.lines(), *collision.lines(), *collision.conditions(), *collision.conclusion()),
    )
    yield from flight.apart()
    premises = map(initial.premise, state.carried.conditions)
    always = state.carried.always(premises, STEP_ASSUMPTIONS)
    yield Chapter(initial.CONTEXT, (always,))
