"""What a scene takes on trust besides the theorems that it cites."""

from __future__ import annotations

from verify.language.statement import Assumption

#: The sentences between the rows and the motion, by their names.
GLUE = {
    "scene": (
        "1. The first state is the scene, seen from the particle o: x_s, x_c, W_s and W_c are the "
        "differences of the given centres and velocities. Each row begins with the state with "
        "which the one before it ends. So, by the rows collision.n, recentre.n and drift.n, which "
        "apply the flow, the collisions are those of the rows collision.n, at the times t_n, and "
        "there are no others before the last one."
    ),
    "scene-restitutions": (
        "1'. Each pair has its coefficient of restitution: r.01 is that of the particles 0 and 1, "
        "and so on. The r of a row collision.n is that of its pair, with which the law of "
        "collision holds for it."
    ),
    "scene-touching": (
        "1''. A row collision.n that applies touching is about a collision while others may be in "
        "contact; as glue-touching says there, it is the next one, or may count as the next."
    ),
    "scene-disperses": (
        "2. By the rows end.ij, which apply the flow to the pairs of the last state, each pair of "
        "particles parts or passes by for ever: there is no further collision."
    ),
    "scene-finite": (
        "2. R² = Σ|x|², A = Σ x·v and L belong to the frame of the centre of mass. By the criteria "
        "for scenes of the classification, (ii) to (iv), the rows finite show that from the moment "
        "that they are about, or from the start, there is no collapse any more, and that only "
        "finitely many collisions are possible, unless a triple or a grazing contact comes before."
    ),
    "scene-momentum": (
        "2. L belongs to the frame of the centre of mass. By the rows finite it is not 0, and r > "
        "9-4√5, where the bound of glue-second of the classification exceeds 1: with its t³ = r, "
        "2t(1+t) > 1+r just if t² - 3t + 1 < 0, and r² - 18r + 1 has the sign of that. So in every "
        "collapse both relative velocities tend to 0, and all velocities in this frame. There L "
        "is kept, by glue-impulse, and at most R e, which tends to 0 as positions converge: so "
        "there is no collapse, and as L is not 0 only finitely many collisions are possible, by "
        "glue-endless, unless a triple or a grazing contact comes before."
    ),
    "scene-finite-balls": (
        "2. The particles are balls of the classification of balls, with the r of their pairs, and "
        "R², A and L are as there. By its glue-scenes the rows finite show that from the moment "
        "that they are about, or from the start, there is no collapse any more, and that only "
        "finitely many collisions are possible, unless a triple or a grazing contact comes before: "
        "(i) where the rows finite.middle apply excluded, (ii) where they apply rests, and L² > 0, "
        "(iii) and (iv) where they are about R², A and L² of this moment."
    ),
    "scene-collapses": (
        "2. After the last collision s and o are in contact, ω_s = x_s and ω_c = x_c/|x_c|; by the "
        "row unit, which applies the flow, the numbers in the row collapse are those of this state "
        "in the letters of the sharper theorem. So that applies to it: the time of the collapse "
        "and its final angle are as it says, and as the rows time and angle enclose them."
    ),
    "scene-stair": (
        "2. By the row unit, which applies the flow, the numbers in the row collapse are those of "
        "the state after the last collision, in the letters of the sandwich theorem. The rows "
        "stair.n are the steps n = 0 … N+1 of a stair that begins at the Q_0 and U_0 of that row, "
        "with its numbers; by the rows period it ends below itself. So comparison holds, by "
        "glue-stairs of that theorem, and it applies: the time of the collapse and its final angle "
        "are as it says, and as the rows time and angle enclose them."
    ),
    "scene-balls": (
        "2. The row unit, which applies the flow, is about the state after the last collision: "
        "with X = x/l and V = W/l for the distance l at which a ball touches o, the numbers in the "
        "row collapse are those of this state in the letters of the theorem on three balls, and m, "
        "r and σ there are those of o, c and s. The rows stair.n are the steps n = 0 … N+1 of a "
        "stair that begins at the Q_0 and U_0 of that row, with its numbers; by the rows period it "
        "ends below itself. So comparison holds, by glue-stairs of that theorem, and it applies: "
        "the time of the collapse and its final angle are as it says, and as the rows time and "
        "angle enclose them."
    ),
    "scene-on-a-line": (
        "2. By the rows line.n all relative positions and velocities at the start are multiples of "
        "one vector, so that the particles stay on a line. After the last collision s and o are in "
        "contact, and o is between s and c, by the row between; by the row unit, which applies the "
        "flow, they part at η and o and c close at y, at the distance d from contact: 0 and c of "
        "the theorem on a line meet after d/y. So that applies to this state: the particles "
        "collapse within the time that it says, as the rows time enclose it, and the angle is π."
    ),
}
ASSUMPTIONS = tuple(
    Assumption(name, "EQUATSS2.1_Loi_de_Newton_", says, "numbered glue")
    for name, says in GLUE.items()
)
