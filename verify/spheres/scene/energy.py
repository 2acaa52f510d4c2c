"""How fast the spheres of a scene meet, and how much energy they lose; each has the mass 1.

A collision with the normal speed u takes (1 - r²)u²/4 from the kinetic energy. The energy of the
centre of mass stays; that of the motion relative to it is Σ|v_i - v_j|²/6, over the three pairs.
"""

from __future__ import annotations

from fractions import Fraction

from verify.prover import balls
from verify.spheres.flow.collapse import LINE, SHARPER
from verify.spheres.flow.follow import Flow
from verify.spheres.flow.law import Number
from verify.spheres.scene.decide import DISPERSES, Fate
from verify.spheres.scene.scene import PAIRS


def normal_speeds(found: Fate) -> list[Number]:
    """The normal relative speed just before each collision that was followed."""
    with balls.precision(found.flow.bits):
        ways = [move.way for move in found.flow.collisions]
        return [way.y * way.s for way in ways if way is not None]


def energy_at_start(flow: Flow) -> Fraction:
    """The kinetic energy relative to the centre of mass."""
    squares = [flow.start.pair(i, j).m for i, j in PAIRS]
    return balls.as_fraction(sum(squares[1:], squares[0]) / 6)


def energy_lost(found: Fate) -> tuple[Fraction, Fraction]:
    """Between what the energy lies that all collisions together take."""
    all_of_it = energy_at_start(found.flow)
    with balls.precision(found.flow.bits):
        share = (1 - found.flow.r**2) / 4
        lost = balls.as_ball(balls.exact(Fraction(0)))
        for speed in normal_speeds(found):
            lost += share * speed**2
        most = balls.ends(lost + share * _later(found))[1]
        least = balls.ends(lost)[0]
    if not _is_bounded(found):
        most = all_of_it
    return max(least, Fraction(0)), min(most, all_of_it)


def _is_bounded(found: Fate) -> bool:
    """Whether all collisions were followed, or a theorem bounds the speeds of the others."""
    if found.collapse is not None:
        return found.collapse.theorem in (LINE, SHARPER)
    return found.verdict == DISPERSES and found.line is None


def _later(found: Fate) -> Number:
    """At least the sum of the squares of all later speeds of a collapse: y²/(1 - L²).

    The speeds at which the pairs in turn approach begin with y and each is at most L times the one
    before; they meet no faster. On a line the factor is (1+r)/2 - q; in the sharper theorem it is
    at most p + Y; the sandwich theorem is not asked for one.
    """
    end = found.collapse
    if end is None or not _is_bounded(found):
        return balls.exact(Fraction(0))
    x = end.numbers
    largest = (1 + found.flow.r) / 2 if end.is_on_a_line else x["p"] + x["Y"]
    return end.start.y**2 / (1 - largest**2)
