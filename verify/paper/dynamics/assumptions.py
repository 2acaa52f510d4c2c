"""What every theorem on the recursion takes on trust."""

from __future__ import annotations

from verify.language.statement import Assumption
from verify.paper.parameters import THEOREM

HARD_SPHERES = Assumption(
    "hard-spheres",
    "EQUATSS2.2IterationSystm1",
    "Three particles of equal mass and diameter 1 move freely until two of them are at "
    "distance 1 and approach each other. If these are 0 and c, then v_0 and v_c become "
    "v_0 + J ω and v_c - J ω with J = (1+r)/2 (v_c - v_0)·ω, where ω is the unit vector from 0 "
    "to c; the third keeps its velocity.",
    "definition",
)
BOUNDED_MONOTONE = Assumption(
    "bounded-monotone",
    THEOREM,
    "A bounded monotone sequence of real numbers converges.",
    "general mathematics",
)
GLUE_NEXT = Assumption(
    "glue-next",
    "EQUATSS4.1SysteDynamColSp",
    "1. By colliding-pair-apart, spectator-apart with recedes, and outer-pair-apart no pair "
    "meets after the state and before the time τ, and at τ, which is positive by tau-positive, "
    "0-c is the only pair in contact, by contact; it approaches there, by impact-speed and "
    "impact-positive. By impact-velocity-s and impact-velocity-c, with the roles exchanged, "
    "the inner products just after that collision are those of the constants named ..._next.",
    "numbered glue",
)
