"""What the step takes on trust: one definition, three sentences of general mathematics, glue."""

from __future__ import annotations

from verify.language.statement import Assumption
from verify.paper.dynamics.assumptions import BOUNDED_MONOTONE, GLUE_NEXT, HARD_SPHERES
from verify.paper.parameters import THEOREM

ASSUMPTIONS = (
    HARD_SPHERES,
    Assumption("cauchy-schwarz", THEOREM,
         "Cauchy-Schwarz, and that no other condition binds two vectors: in any dimension above 1, "
         "for any vector x and all numbers p and b, if a vector z has x·z = p and |z|² = b, then "
         "p² ≤ |x|² b; and if p² ≤ |x|² b and x is not 0, there is such a vector z.",
         "general mathematics"),
    BOUNDED_MONOTONE,
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
         "times converge, so that the relative positions converge, and the limit is that of the "
         "angle at the time of the collapse. It is within δ_θ of -cos θ_0 by angle-final-upper and "
         "angle-final-lower.", "numbered glue"),
    Assumption("glue-interior", "EQUATSS4.1DescrDoIniColla",
         "4. By the rows named inside-... a configuration satisfies all inequalities of the "
         "initial set strictly; vectors for it exist by at-angle, room-c and room-s. Take the data "
         "with |x_1 - x_0| > 1 from which free flight backwards reaches, after a time t > 0, a "
         "first contact of 0 and 1 with η_s > 0, where the inequalities of the initial set are "
         "strict and t < τ. As η_s > 0, t and the configuration at the contact depend continuously "
         "on the datum; so these are finitely many strict inequalities between continuous "
         "functions: an open set of data, not empty, from which the particles collapse.",
         "numbered glue"),
)  # fmt: skip
