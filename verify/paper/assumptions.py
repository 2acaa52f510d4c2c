"""What the step uses and does not prove: one definition, general mathematics, and glue.

Each sentence is listed with every verdict that uses it. They are those of the page `step.toml`, for
those who cite it without reading the page.
"""

from __future__ import annotations

from verify.language.statement import Assumption
from verify.paper.parameters import THEOREM

#: What the sharper theorem takes on trust, too.
HARD_SPHERES, BOUNDED_MONOTONE, FINITE_LENGTH, GLUE_NEXT = (
    Assumption("hard-spheres", "EQUATSS2.2IterationSystm1",
         "Three particles of equal mass and diameter 1 move freely until two of them are at "
         "distance 1 and approach each other. If these are 0 and c, then v_0 and v_c become "
         "v_0 + J ω and v_c - J ω with J = (1+r)/2 (v_c - v_0)·ω, where ω is the unit vector from "
         "0 to c; the third keeps its velocity.", "definition"),
    Assumption("bounded-monotone", THEOREM,
         "A bounded monotone sequence of real numbers converges.", "general mathematics"),
    Assumption("finite-length", THEOREM,
         "A continuous path on [0,T[ that consists of straight pieces, finitely many in each "
         "closed part of [0,T[, and has finite length, has a limit at T.", "general mathematics"),
    Assumption("glue-next", "EQUATSS4.1SysteDynamColSp",
         "1. By colliding-pair-apart, spectator-apart with recedes, and outer-pair-apart no pair "
         "meets after the state and before the time τ, and at τ, which is positive by "
         "tau-positive, 0-c is the only pair in contact, by contact; it approaches there, by "
         "impact-speed and impact-positive. By impact-velocity-s and impact-velocity-c, with the "
         "roles exchanged, the inner products just after that collision are those of the constants "
         "named ..._next.", "numbered glue"),
)  # fmt: skip

STEP_ASSUMPTIONS = (
    HARD_SPHERES,
    Assumption("cauchy-schwarz", THEOREM,
         "Cauchy-Schwarz, and that no other condition binds two vectors: in any dimension above 1, "
         "for any vector x and all numbers p and b, if a vector z has x·z = p and |z|² = b, then "
         "p² ≤ |x|² b; and if p² ≤ |x|² b and x is not 0, there is such a vector z.",
         "general mathematics"),
    BOUNDED_MONOTONE,
    FINITE_LENGTH,
    Assumption("open-condition", THEOREM,
         "Finitely many strict inequalities between continuous functions describe an open set.",
         "general mathematics"),
    GLUE_NEXT,
    Assumption("glue-collapse", THEOREM,
         "2. By induction on n there is an n-th collision: the states up to it are those of real "
         "vectors, so that always applies to them, and glue-next gives the next one. So the "
         "collisions go on for ever, first 0-2, then 0-1 and 0-2 in turn; their times increase, by "
         "tau-positive, and are at most T*, by time-total, so that they converge: infinitely many "
         "collisions in finite time.", "numbered glue"),
    Assumption("glue-angle", THEOREM,
         "3. -cos θ_n + d_n + β g_n falls and -cos θ_n - d_n - β g_n rises, by "
         "angle-monotone-upper and angle-monotone-lower; both are bounded, as -cos θ_n is a cosine "
         "and d_n and g_n = C_η^n g_0 tend to 0, by distance-speed, Cnd2 and C_eta-below-one; so "
         "-cos θ_n converges. The relative velocities are bounded, by A-below and B-below, and the "
         "times converge, so that the relative positions converge, by finite-length, to distances "
         "that are at least 1: the limit of -cos θ_n is that at the time of the collapse. It is "
         "within δ_θ of -cos θ_0 by angle-final-upper and angle-final-lower.", "numbered glue"),
    Assumption("glue-interior", "EQUATSS4.1DescrDoIniColla",
         "4. By the rows named inside-... a configuration satisfies all inequalities of the "
         "initial set strictly; vectors for it exist by at-angle, room-c and room-s. Take the data "
         "with |x_1 - x_0| > 1 from which free flight backwards reaches, after a time t > 0, a "
         "first contact of 0 and 1 with η_s > 0, where the inequalities of the initial set are "
         "strict and t < τ, and ball 2 is apart from both all the while: so the datum lies in "
         "phase space, and not at its edge. That the flight backwards meets the sphere of contact, "
         "at a smaller root that is simple as η_s > 0, is a strict inequality for the "
         "discriminant: the flight backwards is defined on an open set of data, and there t and "
         "the configuration at the contact depend continuously on the datum. So these are finitely "
         "many strict inequalities between continuous functions: an open set of data, not empty, "
         "from which the particles collapse.",
         "numbered glue"),
)  # fmt: skip
