"""How fast the spheres of a scene meet, and how much energy they lose.

A collision with the normal speed u takes μ(1 - r²)u²/2 from the kinetic energy, for the reduced
mass μ of its pair. The energy of the centre of mass stays; that of the motion relative to it is
Σ m_i m_j |v_i - v_j|²/2M, over the three pairs, M being the sum of all masses. Each mass is 1 where
nothing else is said.
"""

from __future__ import annotations

from fractions import Fraction

from verify.prover import balls
from verify.spheres.flow.collapse import SHARPER, THREE_BALLS, Collapse
from verify.spheres.flow.follow import Flow
from verify.spheres.flow.law import Number
from verify.spheres.scene.decide import DISPERSES, Fate
from verify.spheres.scene.scene import PAIRS, Scene


def normal_speeds(found: Fate) -> list[Number]:
    """The normal relative speed just before each collision that was followed."""
    scene = found.flow.scene
    with balls.precision(found.flow.bits):
        return [
            move.way.y
            * move.way.s
            / balls.fmpq_of(scene.contact(move.before.frame[0], move.before.frame[2]))
            for move in found.flow.collisions
            if move.way
        ]


def masses_of(scene: Scene) -> tuple[Fraction, ...]:
    """The masses."""
    return (scene.mass,) * 3 if scene.bodies is None else scene.bodies.masses


def _share(scene: Scene, o: int, c: int) -> Number:
    """What the square of the normal speed is multiplied with for the energy that is lost."""
    masses, r = masses_of(scene), scene.restitution(o, c)
    return balls.fmpq_of((1 - r**2) * masses[o] * masses[c] / (masses[o] + masses[c]) / 2)


def energy_at_start(flow: Flow) -> Fraction:
    """The kinetic energy relative to the centre of mass."""
    masses = masses_of(flow.scene)
    parts = [balls.fraction_of(flow.start.pair(i, j).m) * masses[i] * masses[j] for i, j in PAIRS]
    return sum(parts, Fraction(0)) / (2 * sum(masses))


def energy_lost(found: Fate) -> tuple[Fraction, Fraction]:
    """Between what the energy lies that all collisions together take.

    A collapse on a line takes all of that relative to the centre of mass: there the relative
    velocities tend to 0.
    """
    all_of_it, end = energy_at_start(found.flow), found.collapse
    if end is not None and found.flow.is_on_a_line:
        return all_of_it, all_of_it
    scene = found.flow.scene
    with balls.precision(found.flow.bits):
        lost = balls.as_ball(balls.fmpq_of(Fraction(0)))
        for move, speed in zip(found.flow.collisions, normal_speeds(found), strict=True):
            lost += _share(scene, move.before.frame[0], move.before.frame[2]) * speed**2
        least = max(balls.ends(lost)[0], Fraction(0))
        if end is not None and found.flow.now is not None:
            o, s, c = found.flow.now.frame
            speeds, fall = later_speeds(found.flow.r, end)
            for other, speed in zip((c, s), speeds, strict=True):
                lost += _share(scene, o, other) * speed**2 / (1 - fall**2)
        most = balls.ends(lost)[1]
    # Without a collapse, collisions that were not followed may take all that is left.
    is_followed = end is not None or (found.verdict == DISPERSES and found.line is None)
    return least, min(most, all_of_it) if is_followed else all_of_it


def later_speeds(r: Number, end: Collapse) -> tuple[tuple[Number, Number], Number]:
    """The most at which o meets c and then s, and a factor by which two collisions slow them.

    For a collapse that is not on a line. The speeds at which the pairs in turn approach begin with
    y. Each is at most L times the one before: p + Y in the sharper theorem, (1+r)Γ/2 in the
    sandwich theorem. In the theorem on three balls they are in units of the distances of contact,
    at most y and Y_0 y in turn, and two collisions leave at most Y_0 Y_1. A pair meets at no more
    than the speed at which it approaches, or Γ times that in these units.
    """
    x, y = end.numbers, end.start.y
    if end.theorem == THREE_BALLS:
        one = x["G"] * x["sigma_0"] * y
        return (one, x["G"] * x["sigma_1"] * x["Y_0"] * y), x["Y_0"] * x["Y_1"]
    factor = x["p"] + x["Y"] if end.theorem == SHARPER else (1 + r) / 2 * x["G"]
    return (y, factor * y), factor**2
