"""The theorem on the limit map as a statement: what is a row, and what is glue."""

from __future__ import annotations

from functools import cache

from verify.language.argument import Argument, argue
from verify.language.statement import Assumption
from verify.paper.assumptions import BOUNDED_MONOTONE
from verify.paper.separatrix import growth, order, regime, trap
from verify.paper.separatrix.model import DEFINITIONS, LABEL, THRESHOLD

NAME = "separatrix"
TITLE = (
    "Whatever lies below a state of the limit map whose collisions never end is in the "
    "Zhou-Kadanoff regime; there are such states if and only if a > s + s², where s³ = r; and none "
    "has q ≥ φ⁺"
)

GLUE = (
    Assumption("glue-regime", LABEL,
         "1. Let (Q, U) be in K and (q, u) ≤ (Q, U) another state with u > 0. If u = U, then q < "
         "Q, and after one step u < U by apart-strictly and q ≤ Q by below-x-below. So let u < U "
         "and L = u/U: by falls-always the collisions of (q, u) never end, and all u_n together "
         "are at most L/(1-L). So u_n tends to 0: the Zhou-Kadanoff regime. In particular K has "
         "with a state all those below it with u > 0.",
         "numbered glue"),
    Assumption("glue-exists", THRESHOLD,
         "2. If a > s + s², then room-trap and trapped-always show that (s², U) is in K, with U "
         "as in room.", "numbered glue"),
    Assumption("glue-none", THRESHOLD,
         "3. Let a ≤ s + s², which flat-low shows without roots, and let (q, u) be in K. The state "
         "(q, u/2) is in K, and u_n tends to 0 on its orbit, by 1; from n = 1 on q_n > 0. If some "
         "q_n ≥ s² with n ≥ 1, then grows-always from there on, with F = s² by short-fits and "
         "short-size, m = u/q² and c the smaller one of m and ρm, keeps u_n above cF²: a "
         "contradiction. Otherwise climbs-always does so, with m = uq/(s-q)³. Now let a > s + s² "
         "and q ≥ φ⁺, that is F = q with 2F ≥ a and F(a-F) ≤ r; then a² > 4r, and by beyond-size "
         "grows-always contradicts in the same way: K has no such state, and f(q) = 0.",
         "numbered glue"),
)  # fmt: skip


@cache
def separatrix() -> Argument:
    """The theorem, built once per process."""
    chapters = (*order.chapters(), *regime.chapters(), *trap.chapters(), *growth.chapters())
    return argue(NAME, TITLE, chapters, (*DEFINITIONS, BOUNDED_MONOTONE, *GLUE))
