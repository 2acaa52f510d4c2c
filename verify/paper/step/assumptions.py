"""What the step takes on trust: one definition, three sentences of general mathematics, glue."""

from __future__ import annotations

from verify.language.statement import Assumption
from verify.paper.parameters import THEOREM

ASSUMPTIONS = (
    Assumption(
        "hard-spheres",
        "EQUATSS2.2IterationSystm1",
        "Three particles of equal mass and diameter 1 move freely until two of them are at "
        "distance 1 and approach each other. Then v_0 and v_c become v_0 + J ω and v_c - J ω with "
        "J = (1+r)/2 (v_c - v_0)·ω, where ω is the unit vector from 0 to c; the third keeps its "
        "velocity.",
        "definition",
    ),
    Assumption(
        "cauchy-schwarz",
        THEOREM,
        "(x·z)² ≤ |x|²|z|² for any two vectors; and unit vectors ω_s, ω_c with -cos θ = C, and "
        "vectors W_s, W_c with normal components η_s, η_c and squares B, A exist in any dimension "
        "above 1 if C² ≤ 1, η_s² ≤ B and η_c² ≤ A.",
        "general mathematics",
    ),
    Assumption(
        "bounded-monotone",
        THEOREM,
        "A bounded monotone sequence of real numbers converges.",
        "general mathematics",
    ),
    Assumption(
        "open-condition",
        THEOREM,
        "Finitely many strict inequalities between continuous functions describe an open set.",
        "general mathematics",
    ),
    Assumption(
        "glue-next",
        "EQUATSS4.1SysteDynamColSp",
        "1. By colliding-pair-apart, spectator-apart, outer-pair-apart and contact no pair meets "
        "before the time τ after a state, and at τ particle c is the only one in contact with "
        "another; it approaches particle 0 there, by impact-speed and impact-positive. By "
        "impact-velocity-s and impact-velocity-c, with the roles exchanged, the inner products "
        "just after that collision are those of the constants named ..._next.",
    ),
    Assumption(
        "glue-collapse",
        THEOREM,
        "2. So by always the collisions go on for ever, 0-1 and 0-2 in turn; their times increase, "
        "by tau-positive, and are at most T*, by time-total, so that they converge: infinitely "
        "many collisions in finite time.",
    ),
    Assumption(
        "glue-angle",
        THEOREM,
        "3. By angle-monotone-upper and angle-monotone-lower -cos θ_n converges, as g_n = "
        "C_η^n g_0 and d_n tend to 0 by distance-speed and Cnd2; the limit is within δ_θ of "
        "-cos θ_0 by angle-final-upper and angle-final-lower.",
    ),
    Assumption(
        "glue-interior",
        "EQUATSS4.1DescrDoIniColla",
        "4. By the rows named inside-... a configuration satisfies all inequalities of the initial "
        "set strictly; vectors for it exist by at-angle, room-c and room-s. The data from which "
        "free flight backwards for a time in ]0,ε[ leads to a contact with strict inequalities "
        "are given by finitely many strict inequalities between continuous functions: an open set "
        "of data, not empty, that collapse.",
    ),
)
