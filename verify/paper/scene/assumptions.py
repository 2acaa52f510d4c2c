"""What a scene takes on trust besides the theorems that it cites."""

from __future__ import annotations

from verify.language.statement import Assumption

ASSUMPTIONS = (
    Assumption(
        "scene",
        "EQUATSS2.1_Loi_de_Newton_",
        "1. The first state is the scene, seen from the particle o: x_s, x_c, W_s and W_c are the "
        "differences of the given centres and velocities. Each row begins with the state with which "
        "the one before it ends. So, by the rows collision.n, recentre.n and drift.n, which apply "
        "the flow, the collisions are those of the rows collision.n, at the times t_n, and no "
        "others; by the rows end.ij no pair collides after the last one.",
    ),
    Assumption(
        "finitely-many",
        "EQUATSS2.1_Loi_de_Newton_",
        "Let three equal spheres collide with one r in ]0,1[, without triple or grazing contacts; "
        "let R² = Σ|x|², A = Σ x·v and L, the angular momentum, be those of the frame of the centre "
        "of mass. There are only finitely many collisions if r > 7 - 4√3; or if at some moment "
        "R² >= 2 and either A >= 0 or A²R² < (R² - 2)L²; or if there is no collapse until the time "
        "(ρ²/L²)(√(A² + (2-R²)L²/ρ²) - A), where ρ² = max(R², 2) and L ≠ 0.",
        "general mathematics",
    ),
)
