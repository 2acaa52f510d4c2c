"""Random states just after a collision, and numbers with which their collisions in turn end."""

from __future__ import annotations

from fractions import Fraction
from itertools import pairwise
from typing import NamedTuple

from flint import arb

from tests.paper.sandwich.states import Random, Values, holds, start_of
from tests.paper.sharper.particles import Particles
from verify.paper.commands.pages import page
from verify.prover import balls
from verify.prover.choices import round_to_digits
from verify.spheres.flow.collapse import Start
from verify.spheres.flow.sandwich import above

ABOVE = page("sandwich_above").statement
GIVENS = ABOVE.context("start").claims
FLOOR = ABOVE.context("floor").claims

#: No floor has more steps.
STEPS = 60
#: By how much bounds are widened.
SLACK = 1 + 1e-6

Point = tuple[Fraction, Fraction]


class Ending(NamedTuple):
    """Particles, the numbers of the theorem, and a floor that ends with its last point."""

    particles: Particles
    values: Values
    points: tuple[Point, ...]


def below(number: float) -> Fraction:
    """A decimal with few digits that is no more than a positive number."""
    return round_to_digits(Fraction(number), up=False, digits=7)


def step_at(at: Values, n: int, here: Point) -> tuple[arb, arb, arb]:
    """P, the load and r (1-U), at the n-th step from a point."""
    v_s, w_c = (at["v_0"], at["w_1"]) if n % 2 else (at["v_1"], at["w_0"])
    Q, U = map(balls.fmpq_of, here)
    push = (v_s / w_c) ** 2 * U
    P = (1 + at["r"]) / 2 * at["G"] * at["C_p"] * (1 - U) - Q - push
    return P, push * (2 * Q + push), at["r"] * (1 - U)


def ends(at: Values, n: int, here: Point) -> bool:
    """Whether the map certainly does not go on from a point."""
    P, load, _ = step_at(at, n, here)
    return bool(P <= 0 or load >= P**2)


def fails(at: Values, points: tuple[Point, ...]) -> list[str]:
    """The hypotheses that are not certain."""
    found = [name for name, claim in GIVENS.items() if not holds(claim, at)]
    steps = {name: claim for name, claim in FLOOR.items() if "rises" in name or "next" in name}
    for n, (here, following) in enumerate(pairwise(points)):
        v_s, w_c = (at["v_0"], at["w_1"]) if n % 2 else (at["v_1"], at["w_0"])
        named = dict(zip(("Q_n", "U_n", "Q_next", "U_next"), (*here, *following), strict=True))
        known = {f"floor.{name}": balls.fmpq_of(x) for name, x in named.items()}
        known |= {"floor.alpha": (1 + at["r"]) / 2 * at["G"] * at["C_p"], "floor.R": at["r"]}
        known["floor.rho"] = (v_s / w_c) ** 2
        found += [name for name, claim in steps.items() if not holds(claim, known)]
    return [*found, *([] if ends(at, len(points) - 1, points[-1]) else ["end"])]


def numbers_of(r: Fraction, start: Start) -> tuple[Values, Point] | None:
    """The numbers of the theorem for a state, if there are any."""
    y, A, B = (balls.as_float(x) for x in (start.y, start.A.sqrt(), start.B.sqrt()))
    least = min(A, B) - 3 * y
    if not 0 < y < least:
        return None
    G = 1 + above(((1 - (y / least) ** 2) ** -0.5 - 1) * SLACK)
    ratio = (1 + float(r)) / 2 * float(G)
    gain = float(G) / (1 - ratio) * y * SLACK
    if gain >= min(A, B):
        return None
    v_0, v_1 = below((A - gain) / SLACK), below((B - gain) / SLACK)
    v = min(v_0, v_1)
    if float(v) < least or ratio >= 1:
        return None
    w_0, w_1 = above((A + gain) * SLACK), above((B + gain) * SLACK)
    turning = (float(w_0 + w_1) + 2 * y) * float(G / v**2) / (1 - ratio)
    C_p = above((balls.as_float(start.C) + turning * y) * SLACK)
    d, v_c = start.d, balls.fmpq_of(v_0)
    zeta = d * (2 + d) * v_c**2 / ((1 + d) * start.y) ** 2
    if C_p > 2 or not zeta < 1:
        return None
    U_0 = below(balls.as_float(1 - (1 - zeta).sqrt()) / SLACK)
    Q_0 = below(balls.as_float(start.eta_s / start.y) / SLACK)
    found = {"r": r, "G": G, "v": v, "v_0": v_0, "v_1": v_1, "w_0": w_0, "w_1": w_1, "C_p": C_p}
    exact = {name: balls.fmpq_of(x) for name, x in (found | {"Q_0": Q_0, "U_0": U_0}).items()}
    return {**exact, **{f"{name}_start": x for name, x in start._asdict().items()}}, (Q_0, U_0)


def floor_of(at: Values, first: Point) -> tuple[Point, ...] | None:
    """Points below the orbit, each rounded down, up to one from which the map does not go on."""
    points = [first]
    for n in range(STEPS):
        P, load, share = step_at(at, n, points[-1])
        if P <= 0 or load >= P**2:
            return tuple(points)
        share_of = balls.as_float(load / P**2)
        U = share_of / (1 + (1 - share_of) ** 0.5) / SLACK
        points.append((below(balls.as_float(share / P) / SLACK), below(max(U, 1e-280))))
    return None


def ending(draw: Random) -> Ending | None:
    """Particles with numbers and a floor, if both are found."""
    particles = draw.particles()
    start, r = start_of(particles), balls.short_rational(particles.r)
    particles.r = balls.from_fraction(r)
    found = numbers_of(r, start)
    points = None if found is None else floor_of(*found)
    if found is None or points is None or fails(found[0], points):
        return None
    return Ending(particles, found[0], points)


def collisions_in_turn(particles: Particles, most: int) -> int:
    """How many collisions of 0-2, 0-1, 0-2, ... there are, up to so many."""
    for count in range(most):
        meeting = particles.next()
        if meeting is None or meeting[1:] != (0, 2 - count % 2):
            return count
        particles.collide(*meeting)
    return most
