"""How fast the spheres of a scene meet, and how much energy they lose.

A collision with the normal speed u takes μ(1 - r²)u²/2 from the kinetic energy, for the reduced
mass μ of its pair. The energy of the centre of mass stays; that of the motion relative to it is
Σ m_i m_j |v_i - v_j|²/2M, over the three pairs, M being the sum of all masses. Each mass is 1 where
nothing else is said.
"""

from __future__ import annotations

from fractions import Fraction

from verify.prover import balls
from verify.spheres.flow.collapse import LINE, SHARPER, THREE_BALLS, Collapse
from verify.spheres.flow.follow import Flow, Move
from verify.spheres.flow.law import Number
from verify.spheres.scene.decide import DISPERSES, Fate
from verify.spheres.scene.scene import PAIRS, Scene


def normal_speeds(found: Fate) -> list[Number]:
    """The normal relative speed just before each collision that was followed."""
    bodies = found.flow.scene.bodies
    with balls.precision(found.flow.bits):
        speeds = [(move, move.way.y * move.way.s) for move in found.flow.collisions if move.way]
        if bodies is None:
            return [speed for _, speed in speeds]
        frames = [(move.before.frame, speed) for move, speed in speeds]
        return [speed / balls.exact(bodies.radii[o] + bodies.radii[c])
                for (o, _, c), speed in frames]  # fmt: skip


def masses_of(scene: Scene) -> tuple[Fraction, ...]:
    """The masses."""
    return (scene.mass,) * 3 if scene.bodies is None else scene.bodies.masses


def _share(found: Fate, move: Move) -> Number:
    """What the square of the normal speed is multiplied with for the energy that is lost."""
    masses, (o, _, c) = masses_of(found.flow.scene), move.before.frame
    reduced = masses[o] * masses[c] / (masses[o] + masses[c])
    r = found.flow.scene.restitution(o, c)
    return balls.exact((1 - r**2) * reduced / 2)


def energy_at_start(flow: Flow) -> Fraction:
    """The kinetic energy relative to the centre of mass."""
    masses = masses_of(flow.scene)
    parts = [balls.as_fraction(flow.start.pair(i, j).m) * masses[i] * masses[j] for i, j in PAIRS]
    return sum(parts, Fraction(0)) / (2 * sum(masses))


def energy_lost(found: Fate) -> tuple[Fraction, Fraction]:
    """Between what the energy lies that all collisions together take."""
    all_of_it = energy_at_start(found.flow)
    with balls.precision(found.flow.bits):
        lost = balls.as_ball(balls.exact(Fraction(0)))
        for move, speed in zip(found.flow.collisions, normal_speeds(found), strict=True):
            lost += _share(found, move) * speed**2
        most = balls.ends(lost + _later(found))[1]
        least = balls.ends(lost)[0]
    if not _is_bounded(found):
        most = all_of_it
    return max(least, Fraction(0)), min(most, all_of_it)


def _is_bounded(found: Fate) -> bool:
    """Whether all collisions were followed, or a theorem bounds the speeds of the others."""
    if found.collapse is not None:
        scene = found.flow.scene
        is_one = scene.has_one_mass and scene.restitutions is None
        theorem = found.collapse.theorem
        return theorem == THREE_BALLS or (is_one and theorem in (LINE, SHARPER))
    return found.verdict == DISPERSES and found.line is None


def _later(found: Fate) -> Number:
    """At least the energy that all later collisions of a collapse take.

    The speeds at which the pairs in turn approach begin with y and each is at most L times the one
    before; they meet no faster, so that the sum of their squares is at most y²/(1 - L²). On a line
    the factor is (1+r)/2 - q; in the sharper theorem it is at most p + Y; the sandwich theorem is
    not asked for one.
    """
    end = found.collapse
    if end is None or not _is_bounded(found):
        return balls.exact(Fraction(0))
    x = end.numbers
    if end.theorem == THREE_BALLS:
        return _later_of_balls(end)
    largest = (1 + found.flow.r) / 2 if end.is_on_a_line else x["p"] + x["Y"]
    mass = balls.exact(masses_of(found.flow.scene)[0])
    square = end.start.y**2 / (1 - largest**2)
    return (1 - found.flow.r**2) * mass / 4 * square


def _later_of_balls(end: Collapse) -> Number:
    """The same by the theorem on three balls, with speeds in units of the distances of contact.

    They are at most y and Y_0 y in turn, and the product of Y_0 and Y_1 smaller with each two; a
    pair meets at no more than Γ times the speed at which it approaches.
    """
    x = end.numbers
    fall, total = x["Y_0"] * x["Y_1"], balls.exact(Fraction(0))
    for i, factor in ((0, 1), (1, x["Y_0"])):
        speed = x["G"] * x[f"sigma_{i}"] * factor * end.start.y
        reduced = x["m"] * x[f"m_{i}"] / (x["m"] + x[f"m_{i}"])
        total += (1 - x[f"r_{i}"] ** 2) * reduced / 2 * speed**2 / (1 - fall**2)
    return total
