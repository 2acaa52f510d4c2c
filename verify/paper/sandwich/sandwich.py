"""The sandwich theorem as a statement, and its argument in the order in which it is proved.

It takes on trust definitions, general mathematics, and glue.
"""

from __future__ import annotations

from collections.abc import Iterator
from functools import cache

from verify.language.argument import Argument, Chapter, Opened, argue
from verify.language.statement import Assumption
from verify.paper.assumptions import BOUNDED_MONOTONE, GLUE_NEXT, HARD_SPHERES
from verify.paper.dynamics import model
from verify.paper.dynamics.carried import START
from verify.paper.dynamics.state import CONTEXT
from verify.paper.parameters import THEOREM
from verify.paper.sandwich import collision, comparison, exact, flight, state

ASSUMPTIONS = (
    HARD_SPHERES,
    Assumption("comparison", THEOREM,
         "The theorem is about starts from which the map of two numbers goes on for ever: in the "
         "sequence of (Q, U) that begins at (Q_0, U_0), approaches and meets hold at every step.",
         "definition"),
    Assumption("cauchy-schwarz",
         THEOREM, "(x·z)² ≤ |x|²|z|² for any two vectors.", "general mathematics"),
    BOUNDED_MONOTONE,
    Assumption("finite-length", THEOREM,
         "A continuous path on [0,T[ that consists of straight pieces, finitely many in each "
         "closed part of [0,T[, and has finite length, has a limit at T.", "general mathematics"),
    GLUE_NEXT,
    Assumption("glue-stairs", THEOREM,
         "2. Let Q_n and U_n be numbers, n = 0 … N+2, that satisfy the givens of stair at each "
         "step n ≤ N+1, with the α, R and U* of the start, and with ρ = Γw_s²/w_c², where c is 0 "
         "and s is 1 for even n, and the other way round for odd n; and let Q_{N+2} ≤ Q_N and "
         "U_{N+2} ≤ U_N. Then comparison holds for this start: by induction the n-th (Q, U) is not "
         "negative and below (Q_n, U_n), by orbit-Q-falls, orbit-U-falls, orbit-Q-stays and "
         "orbit-U-stays, and later ones are below the steps N and N+1 in turn; so the map goes on, "
         "by orbit-approaches and orbit-meets.", "numbered glue"),
    Assumption("glue-collapse", THEOREM,
         "3. The start is a state just after a collision of 0 with s, in which 0-s is the only "
         "pair in contact; its inner products satisfy the givens, and comparison holds. By "
         "induction on n there is an n-th later collision: the states up to it are those of real "
         "vectors, so that always applies to them, and glue-next gives the next one. So the "
         "collisions go on for ever, 0-c, then 0-s and 0-c in turn; their times increase, by "
         "tau-positive, and are at most G_T η₀ after the start, by time-total, so that they "
         "converge: infinitely many collisions in finite time.", "numbered glue"),
    Assumption("glue-angle", THEOREM,
         "4. -cos θ_n + G_C g_n falls and -cos θ_n - G_C g_n rises, by angle-monotone-upper and "
         "angle-monotone-lower; both are bounded, and g_n = Λⁿη₀ tends to 0, by decay-positive and "
         "ratio-positive; so -cos θ_n converges. The relative velocities are bounded, by A-below "
         "and B-below, and the times converge, so that the relative positions converge, by "
         "finite-length, to distances that are at least 1: the limit of -cos θ_n is that at the "
         "time of the collapse. It is within Θ of C₀ by angle-final-upper and angle-final-lower.",
         "numbered glue"),
)  # fmt: skip


NAME = "sandwich"
TITLE = (
    "One step of the full dynamics is a map of two numbers, exactly; and from every state just "
    "after a collision that lies below an endless orbit of that map with fixed parameters the "
    "particles collapse: only 0-1 and 0-2 collide, in turn, for ever, within a known time"
)


@cache
def sandwich() -> Argument:
    """The theorem, built once per process."""
    return argue(NAME, TITLE, _chapters(), ASSUMPTIONS)


def _chapters() -> Iterator[Chapter]:
    yield from exact.chapters()
    yield from comparison.chapters()
    yield Chapter(None, (Opened(state.start_context()), *model.spaces()))
    yield from model.chapters(state.PAIRS)
    yield Chapter(START, (*state.lines(), Opened(state.context(), state.opening())))
    yield Chapter(
        CONTEXT,
        (*flight.sizes(), *flight.next_point(), *flight.lines(), *collision.lines(),
         *collision.conclusion()),
    )  # fmt: skip
    yield from flight.apart()
    premises = map(state.begins, state.CONDITIONS)
    always = state.carried.always(premises, ASSUMPTIONS)
    yield Chapter(START, (always,))
