"""The theorem: where the map of two numbers ends, so do the collisions in turn.

Every line is proved; what is used and not proved is a definition, general mathematics, and glue.
"""

from __future__ import annotations

from collections.abc import Iterator
from functools import cache

from verify.language.argument import Argument, Chapter, Opened, argue
from verify.language.statement import Assumption
from verify.paper.assumptions import HARD_SPHERES
from verify.paper.dynamics import model
from verify.paper.dynamics.carried import START
from verify.paper.dynamics.state import CONTEXT
from verify.paper.outside import collision, state
from verify.paper.parameters import THEOREM
from verify.paper.sandwich import comparison

ASSUMPTIONS = (
    HARD_SPHERES,
    Assumption("goes-on", THEOREM,
         "The theorem is about states just after a collision of 0 with s that are followed by two "
         "collisions in turn: first of 0 with c, then of 0 with s, and no other before these.",
         "definition"),
    Assumption("cauchy-schwarz",
         THEOREM, "(x·z)² ≤ |x|²|z|² for any two vectors.", "general mathematics"),
    Assumption("glue-next", THEOREM,
         "1. If 0 and c collide next, they do so after the time τ, at the first of the two times "
         "at which they are at distance 1. By impact-velocity-s and impact-velocity-c, with the "
         "roles exchanged, the inner products just after that collision are those of the constants "
         "named ..._next. If 0 and s collide after that, approaches-again and meets-again hold, by "
         "closing-law and next-meets: 0 and s approach, and ζ' < 1.", "numbered glue"),
    Assumption("glue-ends", THEOREM,
         "2. Let a state satisfy the givens of start, and let the sequence of (Q, U) that begins "
         "at (Q_0, U_0) stop at its step N, counted from 0: approaches or meets is false there. "
         "If the run had N+2 more collisions in turn, 0-c, 0-s, 0-c, …, each of the states 0 to N "
         "would be followed by two of them, so that always applies to these states, by glue-next, "
         "and approaches and meets would hold in each. So at most N+1 collisions in turn follow "
         "the start.", "numbered glue"),
    Assumption("glue-floor", THEOREM,
         "3. Let Q_n and U_n be numbers, n = 0 … N, with the Q_0 and U_0 of the start, that "
         "satisfy the givens of floor at each step n < N, with α = (1+r)/2 ΓC₊ and R = r, and with "
         "ρ = v_s²/w_c², where c is 0 and s is 1 for even n, and the other way round for odd n; "
         "and let P ≤ 0 or ρU(2Q+ρU) ≥ P² at (Q_N, U_N). Then the map from (Q_0, U_0) stops at "
         "step N or sooner: as long as it goes on it is above (Q_n, U_n), by over-Q-rises and "
         "over-U-rises, and by over-goes and over-met it does not go on above (Q_N, U_N).",
         "numbered glue"),
)  # fmt: skip


NAME = "outside"
TITLE = (
    "From every state just after a collision that lies above an orbit of a map of two numbers the "
    "collisions in turn end when that orbit ends: 0-1 and 0-2 cannot go on colliding in turn"
)


@cache
def outside() -> Argument:
    """The theorem, built once per process."""
    return argue(NAME, TITLE, _chapters(), ASSUMPTIONS)


def _chapters() -> Iterator[Chapter]:
    yield from comparison.floor_chapters()
    yield Chapter(None, (Opened(state.start_context()), Opened(model.impact())))
    yield from model.chapters(())
    yield Chapter(START, (*state.lines(), Opened(state.context(), state.opening())))
    yield Chapter(CONTEXT, (*collision.sizes(), *collision.flight(), *collision.lines()))
    premises = map(state.begins, state.CONDITIONS)
    where = " for which two more follow in turn"
    always = state.carried.always(premises, ASSUMPTIONS, where)
    yield Chapter(START, (always,))
