"""What the theorems on collapses say of three equal balls with one coefficient of restitution."""

from __future__ import annotations

from collections.abc import Iterator
from fractions import Fraction

#: What stands after finitely many collisions: the law of collisions is about a pair.
UNLESS = ", unless three touch at once (a triple contact)"

#: What is known of every r, by II.
LEAST_ANGLE = (
    "in a collapse the final -cos θ is at least 4√r/(1+r) (theorem II, certificates/classification)"
)


def never(r: Fraction) -> bool:
    """Whether 7-4√3 < r ≤ 1: then r² - 14r + 1, of which 7-4√3 is a root, is negative."""
    return r**2 - 14 * r + 1 < 0


def comes_to_rest(r: Fraction) -> bool:
    """Whether 9-4√5 < r ≤ 1, so that the bound of the second condition exceeds 1.

    With t³ = r that bound is 2t(1+t)/(1+r): it does just if t² - 3t + 1 < 0, that is, above a root
    of r² - 18r + 1.
    """
    return r**2 - 18 * r + 1 < 0


def without_interior(r: Fraction) -> Iterator[str]:
    """Why three equal balls do not collapse from a set with interior, and with which final angles.

    It is true of every restitution coefficient of at least r, and below 1.
    """
    if never(r):
        yield (
            "for r > 7-4√3 = 0.0717… three balls of equal mass never collapse, whatever the angle "
            "(theorem II, certificates/classification); by theorem IV they have finitely many "
            f"collisions{UNLESS}"
        )
    elif comes_to_rest(r):
        yield (
            "for r > 9-4√5 = 0.0557… three balls of equal mass collapse only if their angular "
            "momentum about the centre of mass is 0 (theorem IV b, certificates/classification). "
            "So in dimension 2 or more no set with interior consists of states that collapse, and "
            "the conclusion of the theorem is false here"
        )
    else:
        yield (
            "a collapse with a final -cos θ below 2r^(1/3)(1+r^(1/3))/(1+r) has angular momentum 0 "
            "about the centre of mass, as all relative velocities tend to 0 in it (theorem II b, "
            "certificates/classification). So in dimension 2 or more no set with interior consists "
            "of states that collapse with such an angle"
        )
