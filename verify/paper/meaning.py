"""What the theorems of the classification mean for the text: remarks at its labels."""

from __future__ import annotations

from verify.publication import Remark

MEANING = (
    Remark("PROPOSS3.5OrdreTriagColla",
        "The order theorem is about a collapse that does not exist (I). Its proof stops one line "
        "short: as long as the triangle is acute, as near an equilateral one, a pair that has "
        "collided does not collide again, so that nothing follows after 0-1, 0-2 and 1-2."),
    Remark("EQUATSS3.5Minor_z'__Triag",
        "The cone asks that 0-1 and 0-2 take place, and forgets to ask it of 1-2. With all three "
        "conditions the image has x' > 0 and z' > 0 for every r in (0, 1), and 1-2 recedes as "
        "well: in the linear model not even one collision follows."),
    Remark("THEORSS3.5SpectMatricVitLm",
        "The spectrum is right as algebra; the matrix describes a limit that no orbit has."),
    Remark("DEFINSS3.5CollapseTriangu",
        "The conclusion leaves open whether there is a triangular collapse, one in which all three "
        "pairs collide infinitely often: there is none, for any masses, radii, dimension and "
        "restitution (I). It hopes for an Alexander theorem for three particles of equal mass: for "
        "r > 7-4√3 here is one (II with IV), and for any r in (0, 1), any masses and radii in "
        "dimension 2 or more certificates/alexander is one: almost every start has finitely many "
        "collisions, or a collapse in the regime of Zhou and Kadanoff."),
    Remark("EQUATSS3.4ZKCl1CondiExist",
        "The first condition, which the text quotes from Zhou and Kadanoff as necessary, is "
        "necessary for the full dynamics: no limit of velocities or angles is taken in the "
        "recursion (II)."),
    Remark("EQUATSS3.4ZKCl2CondiStabi",
        "The second condition, with ≥, is necessary for the full dynamics as well, in every "
        "collapse in which the two relative velocities do not both tend to 0 (II)."),
    Remark("PROPOSS3.2SommaCompNormlV",
        "The normal components at the collisions are summable, not only their squares, and without "
        "an assumption on gaps or on the order (III)."),
)  # fmt: skip
