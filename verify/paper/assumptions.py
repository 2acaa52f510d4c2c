"""What is used and not proved: by the rows of Theorem 1, and by the step that they apply.

The rows use the laws, and estimates for every state. The state just after the n-th collision is the
inner products of (omega_s, W_s, omega_c, W_c) and the distance d. The step proves these laws and
estimates; it takes on trust one definition, sentences of general mathematics, and glue. Each
sentence is listed with every verdict that uses it.
"""

from __future__ import annotations

from verify.language.statement import Assumption
from verify.paper.parameters import THEOREM

#: What follows from the definition of the flow by computation alone.
LAW = "law of motion"

#: An inequality that holds for all numbers (or vectors) in a range that the sentence names.
CALCULUS = "calculus"

#: A step of the argument from one row, or one state, to another.
GLUE = "glue"

KINDS = (LAW, CALCULUS, GLUE)

ASSUMPTIONS = (
    Assumption("collision-map", "EQUATSS2.2IterationSystm1",
        "The single-collision mapping describes the motion from one collision of the central "
        "particle to the next, as long as η_c < 0, ζ < 1, d > 0 and the outer pair stays apart; "
        "the pair that just met, with η_s > 0, does not meet again meanwhile.", LAW),
    Assumption("collision-map-roles", "EQUATSS4.1SysteDynamColSp",
        "The same mapping with the roles colliding and spectator exchanged at each collision.",
        LAW),
    Assumption("law-eta-c", "EQUATSS4.1EvoluCompoNormC",
        "η_{c,n+1} = η_{s,n}/(1+d_{n+1}) - (1+r)/2 (1+d_n)√(1-ζ_n) (-cos θ_{n+1})(-η_{c,n}) + τ_n "
        "|W_{s,n}|²/(1+d_{n+1}), for n ≥ 0.", LAW),
    Assumption("law-eta-s", "EQUATSS4.1EvoluCompoNormC",
        "η_{s,n+1} = r (1+d_n)√(1-ζ_n) (-η_{c,n}).", LAW),
    Assumption("law-norms", "EQUATSS4.1EvoluNormeVitRl",
        "With a = W_{c,n}·ω_{s,n+1} = -(1+d_n)√(1-ζ_n)(-η_{c,n}): |W_{c,n+1}|² = |W_{s,n}|² - "
        "(1+r) a (W_{s,n}·ω_{s,n+1}) + ((1+r)²/4) a² (printed with 2 in place of 4) and "
        "|W_{s,n+1}|² = |W_{c,n}|² - (1-r²) a².", LAW),
    Assumption("law-angle", "EQUATSS4.1EvoluCosinAngle",
        "-cos θ_{n+1} = [(1+d_n)(-cos θ_n) - τ_n (ω_s·W_c) - (1+d_n) τ_n (ω_c·W_s) - τ_n² "
        "(W_s·W_c)]/(1+d_{n+1}).", LAW),
    Assumption("zeta-from-distance", "EQUATSS4.1BorneParam_ZK0_",
        "x(2+x)/(1+x)² ≤ 2x for x ≥ 0 and ≥ 3x/4 for 0 ≤ x ≤ 1, hence ζ ≤ 2 d |W_c|²/η_c² and, if "
        "d ≤ 1, (3/4) d |W_c|²/η_c² ≤ ζ.", CALCULUS),
    Assumption("root-crude", "EQUATSS4.1Recurrence_Cnd3", "1 - √(1-ζ) ≤ ζ for 0 ≤ ζ ≤ 1.",
        CALCULUS),
    Assumption("root-fine", "EQUATSS4.1Recurrence_Cnd4",
        "1 - √(1-ζ) ≤ ζ/2 + ζ²/4 for 0 ≤ ζ ≤ 2(√2-1).", CALCULUS),
    Assumption("root-product", "EQUATSS4.1Lien_x_n_&_y_n_",
        "|(1+d)√(1-ζ) - 1| ≤ max(d, 2ζ) for d ≥ 0 and 0 ≤ ζ ≤ 1.", CALCULUS),
    Assumption("time", "EQUATSS4.1_Controle_Tau_n",
        "τ_n ≤ 2(-η_{c,n})ζ_n/|W_{c,n}|² if 0 ≤ d_n ≤ 1, η_{c,n} < 0, 0 ≤ ζ_n ≤ 1 and W_{c,n} ≠ "
        "0; and that is at most 2(-η_{c,n})ζ_n/V₀ if |W_{c,n}|² ≥ V₀ > 0.", CALCULUS),
    Assumption("distance", "EQUATSS4.1BorneDista_d_1_",
        "d_{n+1} = √(1+2η_{s,n}τ_n+|W_{s,n}|²τ_n²) - 1 ≤ η_{s,n}τ_n + |W_{s,n}|²τ_n²/2 always. If "
        "also τ_n ≥ 0, |W_{s,n}|² ≤ V₁ and V₁^{1/2} τ_n ≤ 1, that is at most (3/2) V₁^{1/2} τ_n, "
        "and at most 3 (V₁^{1/2}/V₀)(-η_{c,n}) if τ_n ≤ 2(-η_{c,n})/V₀. And d_{n+1} > 0 if "
        "η_{s,n} > 0 and τ_n > 0.", CALCULUS),
    Assumption("outer-distance", "EQUATSS4.1Recurrence_CndT",
        "|(1+d_n)ω_c - ω_s + t(W_c-W_s)| ≥ |ω_c-ω_s| - d_n - 2V₁^{1/2}τ_n for unit vectors ω_c "
        "and ω_s, d_n ≥ 0, 0 ≤ t ≤ τ_n and |W_c|², |W_s|² ≤ V₁; and |ω_c-ω_s| = √(2+2(-cos θ)), "
        "where cos θ = ω_c·ω_s.", CALCULUS),
    Assumption("angle-step", "EQUATSS4.1Recurrence_Cnd8",
        "|cos θ_{n+1} - cos θ_n| ≤ d_n + d_{n+1} + τ_n|W_c| + 2τ_n|W_s| + τ_n²|W_s||W_c| if 0 ≤ "
        "d_n ≤ 1, d_{n+1} ≥ 0 and τ_n ≥ 0; with -η_{c,n} ≤ C_η^n (-η_{c,0}) the steps add up to "
        "the geometric sum of Cnd8.", GLUE),
    Assumption("norm-step", "EQUATSS4.1Recurrence_Cnd6",
        "The changes of |W_c|², |W_s|² at one collision are bounded, from above and from below, "
        "by law-norms with |W_{s,n}·ω_{s,n+1}| ≤ V₁^{1/2} and |a| ≤ (1+d_n)(-η_{c,n}); with "
        "-η_{c,n} ≤ C_η^n (-η_{c,0}) they add up to the geometric sum Σ C_η^k < 1/(1-C_η).", GLUE),
    Assumption("zeta-step", "EQUATSS4.1Recurrence_Cnd4",
        "If d_n, d_{n+1} ≥ 0, η_{s,n} ≥ 0, η_{c,n} < 0, η_{c,n+1} ≠ 0, W_{c,n} ≠ 0, ζ_n ≤ "
        "2(√2-1), d_n ≤ 1 and d_n(1+ζ_n/2) ≤ ζ_n/2, then ζ_{n+1} is at most the sum of the four "
        "printed terms (the last of these conditions absorbs the factor 1+d_n that the print "
        "drops); and if V₀ ≤ |W_c|², |W_s|² ≤ V₁ at n and n+1, the ratios of norms in them are at "
        "most V₁/V₀ and V₁²/V₀².", CALCULUS),
    Assumption("x-step", "EQUATSS4.1DefinReste_x_n_",
        "x_{n+1} = r(1+d_n)√(1-ζ_n)/(α₀-φ⁻-y_n) - φ⁻; and |r/(α₀-φ⁻-y) - φ⁻| ≤ K|y| if 0 ≤ δ < "
        "α₀-φ⁻, r/(α₀-φ⁻-δ)² ≤ K and |y| ≤ δ (mean value theorem).", CALCULUS),
    Assumption("y-step", "EQUATSS4.1Lien_x_n_&_y_n_",
        "The identity for y_n follows from law-eta-c. If d_n, d_{n+1} ≥ 0, 0 ≤ ζ_n ≤ 1, τ_n ≥ 0, "
        "η_{c,n} < 0 ≤ η_{s,n}, 0 < r ≤ 1 and |W_{s,n}|² ≤ V₁, its terms are at most "
        "d_{n+1}η_{s,n}/(-η_{c,n}), max(d_n, 2ζ_n), |(-cos θ_{n+1}) - (-cos θ₀)|, "
        "V₁τ_n/(-η_{c,n}) and |x_n|, in this order; n = 0 is included.", CALCULUS),
    Assumption("induction", "THEORSS4.1ExistenCollapse",
        "The conditions Cnd1 to Cnd10 and CndT for every n follow from the rows of the "
        "initialization and of the recursion by induction on n.", GLUE),
    Assumption("interior", "THEORSS4.1ExistenCollapse",
        "The initial data whose inequalities are strict form a non-empty open part of the contact "
        "surface |x₁-x₀| = 1, η_s > 0; flowing for a short time before the next collision, they "
        "sweep out an open set.", GLUE),
)  # fmt: skip


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
