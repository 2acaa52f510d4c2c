"""The sharper theorem as a statement, and its argument in the order in which it is proved.

It takes on trust one definition, general mathematics, and glue.
"""

from __future__ import annotations

from collections.abc import Iterator
from functools import cache

from verify.language.argument import Argument, Chapter, Opened, argue
from verify.language.statement import Assumption
from verify.paper.assumptions import BOUNDED_MONOTONE, FINITE_LENGTH, GLUE_NEXT, HARD_SPHERES
from verify.paper.dynamics import model
from verify.paper.dynamics.carried import START
from verify.paper.dynamics.state import CONTEXT
from verify.paper.parameters import THEOREM
from verify.paper.sharper import collision, flight, state

ASSUMPTIONS = (
    HARD_SPHERES,
    Assumption("cauchy-schwarz",
         THEOREM, "(x·z)² ≤ |x|²|z|² for any two vectors.", "general mathematics"),
    BOUNDED_MONOTONE,
    FINITE_LENGTH,
    GLUE_NEXT,
    Assumption("glue-collapse", THEOREM,
         "2. The start is a state just after a collision of 0 with s, in which 0-s is the only "
         "pair in contact; its inner products satisfy the givens. By induction on n there is an "
         "n-th later collision: the states up to it are those of real vectors, so that always "
         "applies to them, and glue-next gives the next one. So the collisions go on for ever, "
         "0-c, then 0-s and 0-c in turn; their times increase, by tau-positive, and are at most "
         "Tη₀/(1-p-Y) after the start, by time-total, so that they converge: infinitely many "
         "collisions in finite time.", "numbered glue"),
    Assumption("glue-angle", THEOREM,
         "3. -cos θ_n + G(g_n) falls and -cos θ_n - G(g_n) rises, by angle-monotone-upper and "
         "angle-monotone-lower; both are bounded, and G(g_n) tends to 0 with g_n = (p+Y)^n η₀, by "
         "decay-positive and growth-positive; so -cos θ_n converges. The relative velocities are "
         "bounded, by A-below and B-below, and the times converge, so that the relative positions "
         "converge, by finite-length, to distances that are at least 1: the limit of -cos θ_n is "
         "that at the time of the collapse. It is within Θ of C₀ by angle-final-upper and "
         "angle-final-lower.", "numbered glue"),
)  # fmt: skip


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
    spaces = (Opened(state.start_context()), *model.spaces())
    yield Chapter(None, spaces)
    yield from model.chapters(state.PAIRS)
    yield Chapter(
        START, (*state.consequences(), *state.lines(), Opened(state.context(), state.opening()))
    )
    yield Chapter(
        CONTEXT,
        (*flight.lines(), *collision.lines(), *collision.conditions(), *collision.conclusion()),
    )
    yield from flight.apart()
    premises = (f"start-{name}" for name in state.CONDITIONS)
    always = state.carried.always(premises, ASSUMPTIONS)
    yield Chapter(START, (always,))
