"""From a state just after a collision: numbers with which any three balls collapse.

The search is that of `sandwich.py`, with shares, coefficients of restitution and bounds of the
decay that alternate. It proves nothing; what the theorem asks for is then decided, with the letters
of that statement: of rational numbers exactly, of the state in balls.
"""

from __future__ import annotations

import math
from collections.abc import Mapping
from fractions import Fraction
from typing import Protocol

from verify.language.record import Record
from verify.prover import balls
from verify.spheres.flow.collapse import Collapse, Start, short_above
from verify.spheres.flow.law import Number
from verify.spheres.flow.sandwich import (
    DIGITS,
    LEAST,
    MOST,
    SLACK,
    TINY,
    TURN_SLACK,
    Stair,
    above,
    closes,
    find_stair,
)

#: How often all bounds are found anew, and those of the decay.
ROUNDS, DECAY_ROUNDS = 16, 40
#: By how much the bounds of q from below are made smaller.
SAFE = 1 - 1e-5
#: Digits of the bounds of the time that is left: their difference has to be positive.
TIME_DIGITS = 15


class Bodies(Record):
    """The middle ball, that which it meets next, and the one that it met last.

    ``m`` is the mass of the middle one; ``masses``, the distances ``contacts`` at which it touches
    the others, and the coefficients of restitution ``r`` are those of the two others, in this
    order; ``outer`` is the distance at which these touch each other.
    """

    m: Fraction
    masses: tuple[Fraction, Fraction]
    contacts: tuple[Fraction, Fraction]
    outer: Fraction
    r: tuple[Fraction, Fraction]

    def share(self, i: int) -> Fraction:
        """What the other ball gets of the speed at which i meets the middle one, both scaled."""
        own, other = self.contacts[i], self.contacts[1 - i]
        return (1 + self.r[i]) * self.masses[i] / (self.m + self.masses[i]) * own / other

    @property
    def least_cosine(self) -> Fraction:
        """-cos θ at which all three touch."""
        (a, b), c = self.contacts, self.outer
        return (c**2 - a**2 - b**2) / (2 * a * b)


class Bounds(Record):
    """The numbers of the theorem but Q_0 and U_0; the state in units of the larger speed."""

    bodies: Bodies
    G: Fraction
    w: tuple[Fraction, Fraction]
    U_b: Fraction
    C_0: Fraction
    Theta: Fraction
    Y: tuple[Fraction, Fraction]
    k: tuple[Fraction, Fraction]
    E: tuple[Fraction, Fraction]
    z: Fraction

    def alpha(self, n: int) -> Fraction:
        """The factor of 1 - U in P at the n-th step: the balls exchange their roles each time."""
        return self.bodies.share(n % 2) * (self.C_0 - self.Theta)

    def restitution(self, n: int) -> Fraction:
        """The factor of (1 - U)/P in Q'."""
        return self.bodies.r[n % 2] * self.G

    def rho(self, n: int) -> Fraction:
        """The factor of U in P."""
        return self.G * (self.w[1 - n % 2] / self.w[n % 2]) ** 2


class Sizes(Record):
    """The state in floats: closing speed, q, ζ, -cos θ, and both speeds."""

    e: float
    q: float
    zeta: float
    C: Number
    W: tuple[float, float]


def below(value: float) -> Fraction:
    """A decimal with few digits that is positive and no more than a number, or 0."""
    if value <= LEAST:
        return Fraction(0)
    power = Fraction(10) ** (DIGITS - 1 - math.floor(math.log10(value)))
    return math.floor(Fraction(value) * power) / power


def may_collapse(bodies: Bodies, C: float) -> bool:
    """Whether the first condition of Zhou and Kadanoff holds at this angle, about."""
    roots = sum(math.sqrt(r) for r in bodies.r)
    return C > 0 and math.sqrt(bodies.share(0) * bodies.share(1)) * C > roots


class Shares(Protocol):
    """What ball 0 gets of the speed of each of two contacts, and their restitutions."""

    @property
    def r(self) -> tuple[Fraction, Fraction]:
        """The coefficients of restitution."""

    def share(self, i: int) -> Fraction:
        """The share of a contact."""


def decay(bodies: Shares, G: float, q: float, widest: float) -> tuple[list[float], list[float]]:
    """Bounds Y of what one collision leaves of the closing speed, with bounds k of q from below."""
    share, r = [[float(x) for x in f] for f in (map(bodies.share, (0, 1)), bodies.r)]
    k, Y = [0.0, 0.0], [x * G for x in share]
    for _ in range(DECAY_ROUNDS):
        if min(Y) <= 0:
            break
        # A larger k_0 needs a smaller Y_1, and the other way round.
        room = 1 - widest - TINY
        k = [min(q, r[1] * room / Y[1]) * SAFE, r[0] * room / Y[0] * SAFE]
        Y = [x * G - y / G for x, y in zip(share, k, strict=True)]
    return Y, k


def bounds_of(bodies: Bodies, at: Sizes, widest: Fraction, before: Bounds | None) -> Bounds | None:
    """All bounds, where no U is larger than the widest; from those of the last round, if any."""
    e, (W_0, W_1) = at.e, at.W
    G = 1.0 if before is None else float(before.G)
    Y, k = decay(bodies, G, at.q, float(widest))
    if min(Y) <= 0 or Y[0] * Y[1] >= 1:
        return None
    share = [float(bodies.share(i)) for i in (0, 1)]
    rest = 1 - Y[0] * Y[1]
    zeta = float(widest * (2 - widest))
    size = max(e / (W_0 + share[1] * Y[0] * e / rest), Y[0] * e / (W_1 + share[0] * e / rest)) ** 2
    part = zeta * size * SLACK
    if part >= 1:
        return None
    found = 1 + above(part / (math.sqrt(1 - part) * (1 + math.sqrt(1 - part))) * SLACK)
    G_new = found if before is None else max(found, before.G)
    least = below(k[0]), below(k[1])
    fall = [
        above((share[i] * float(G_new) - float(least[i]) / float(G_new)) * (1 + TINY))
        for i in (0, 1)
    ]
    fall = [max(x, above(LEAST)) for x in fall]
    rest = 1 - float(fall[0] * fall[1])
    if rest <= 0:
        return None
    gain = float(G_new) / rest * e * (1 + TINY)
    w_0 = above((W_0 + share[1] * float(fall[0]) * gain) * (1 + TINY))
    w_1 = above((W_1 + share[0] * gain) * (1 + TINY))
    step = [float(G_new * widest / w**2) * SLACK for w in (w_0, w_1)]
    E = [above((step[i] + float(fall[i]) * step[1 - i]) / rest, TIME_DIGITS) for i in (0, 1)]
    z = above(e * max(1, float(fall[0]), share[0], share[1] * float(fall[0])) * (1 + TINY))
    theta = max(float(w_0 + w_1 + z) * float(E[0]) * e * TURN_SLACK, LEAST)
    C_0 = min(
        balls.fraction_of(balls.decimal(at.C, 4 - math.floor(math.log10(theta)))), Fraction(1)
    )
    return Bounds(
        bodies, G_new, (w_0, w_1), MOST, C_0, above(theta), (fall[0], fall[1]), least,
        (E[0], E[1]), z,
    )  # fmt: skip


def search(bodies: Bodies, start: Start, unit: Fraction) -> tuple[Bounds, Stair] | None:
    """A stair that probably begins above a state, with bounds that decay, in a unit of speed."""
    size = balls.fmpq_of(unit)
    speeds = [balls.as_float(balls.any_root(x) / size) for x in (start.A, start.B)]
    reach = (1 + start.d) * start.y
    zeta = balls.as_float(start.d * (2 + start.d) * start.A / (reach * reach))
    at = Sizes(
        balls.as_float(start.y / size), balls.as_float(start.eta_s / start.y), zeta, start.C,
        (speeds[0], speeds[1]),
    )  # fmt: skip
    if not (0 < zeta < 1 and at.e > 0 and min(speeds) > 0):
        return None
    widest, bounds = above(max(zeta, LEAST)), None
    q = above(max(at.q, LEAST) * SLACK)
    for _ in range(ROUNDS):
        bounds = bounds_of(bodies, at, min(widest, MOST), bounds)
        if bounds is None or bounds.C_0 - bounds.Theta <= max(Fraction(0), bodies.least_cosine):
            return None
        faster = zeta * (float(bounds.w[0]) / speeds[0]) ** 2 * SLACK
        if faster >= 1:
            return None
        u = above(max(faster / (1 + math.sqrt(1 - faster)), LEAST))
        stair = find_stair(bounds, (q, u))
        if stair is None:
            return None
        most = max(U for _, U in stair.points)
        if most <= widest:
            kept = bounds._replace(U_b=widest)
            if decays(kept):
                return kept, stair
        widest = max(widest, above(float(most) * SLACK))
    return None


def scaled(start: Start, contacts: tuple[Fraction, Fraction]) -> Start:
    """A state where lengths of the pair of 0 and i are in units of the distance of their contact.

    The contacts are those of c and s; d is measured in the first one before, too.
    """
    c, s = map(balls.fmpq_of, contacts)
    return Start(
        start.y / c, start.eta_s / s, start.C, start.a / c, start.b / s, start.A / (c * c),
        start.B / (s * s), start.w / (c * s), start.d,
    )  # fmt: skip


def find_three_balls(bodies: Bodies, start: Start, time: Number) -> Collapse | None:
    """Why the balls collapse; None if the search finds no numbers, or balls do not show it.

    The state is a scaled one.
    """
    if not may_collapse(bodies, balls.as_float(start.C)):
        return None
    if not (start.A > 0 and start.B > 0 and start.y > 0 and start.eta_s > 0 and start.d > 0):
        return None
    unit = short_above(balls.any_root(balls.larger(start.A, start.B)))
    found = search(bodies, start, balls.fraction_of(unit))
    if found is None:
        return None
    bounds, stair = found
    numbers = numbers_of(bounds, stair, unit)
    if not (closes(bounds, stair) and holds_at(numbers, start)):
        return None
    later = numbers["E_0"] * start.y
    return Collapse(numbers, start, (time, time + later), stair.points)


def numbers_of(x: Bounds, stair: Stair, unit: Number) -> dict[str, Number]:
    """The numbers by their names in the statement."""
    (Q_0, U_0), of = stair.points[0], x.bodies
    pairs = {
        "m": of.masses, "r": of.r, "sigma": of.contacts, "beta": (of.share(0), of.share(1)),
        "Y": x.Y, "k": x.k,
    }  # fmt: skip
    others = {"m": of.m, "sigma_12": of.outer, "G": x.G, "U_b": x.U_b, "C_0": x.C_0}
    others |= {"Theta": x.Theta, "Q_0": Q_0, "U_0": U_0}
    others |= {f"{name}_{i}": pair[i] for name, pair in pairs.items() for i in (0, 1)}
    exact = {name: balls.fmpq_of(value) for name, value in others.items()}
    exact |= {f"w_{i}": balls.fmpq_of(x.w[i]) * unit for i in (0, 1)}
    exact |= {f"E_{i}": balls.fmpq_of(x.E[i]) / (unit * unit) for i in (0, 1)}
    return exact | {"z_b": balls.fmpq_of(x.z) * unit}


# --- the conditions ------------------------------------------------------------------------------


def decays(x: Bounds) -> bool:
    """True only if the bounds without the state satisfy what the theorem asks of them."""
    G, Y, k, E, r = x.G, x.Y, x.k, x.E, x.bodies.r
    pairs = ((0, 1), (1, 0))
    return bool(
        G >= 1
        and min(Y) > 0
        and min(k) >= 0
        and Y[0] * Y[1] < 1
        and min(x.w) > 0
        and x.U_b < 1
        and all(0 < one <= 1 for one in r)
        and all(G**2 * x.bodies.share(i) <= G * Y[i] + k[i] for i, _ in pairs)
        and all(k[j] * Y[i] <= r[i] * (1 - x.U_b) for i, j in pairs)
        and all(G * x.U_b <= x.w[i] ** 2 * (E[i] - Y[i] * E[j]) for i, j in pairs)
        and max(Fraction(0), x.bodies.least_cosine) < x.C_0 - x.Theta
        and x.C_0 <= 1
    )


def holds_at(x: Mapping[str, Number], start: Start) -> bool:
    """True only if the numbers and the state satisfy what the theorem asks of them."""
    G, U_b, y, (w_0, w_1), Y_0 = x["G"], x["U_b"], start.y, (x["w_0"], x["w_1"]), x["Y_0"]
    gain = G / (1 - Y_0 * x["Y_1"])
    high_0, high_1 = w_0 - x["beta_1"] * Y_0 * gain * y, w_1 - x["beta_0"] * gain * y
    room = x["Theta"] - (w_0 + w_1 + x["z_b"]) * x["E_0"] * y
    gap, reach = start.d * (2 + start.d) * w_0 * w_0, (1 + start.d) * y
    far, wide = U_b * (2 - U_b) * G * G, G * G - 1
    return bool(
        x["U_0"] <= U_b
        and y * y <= start.A
        and start.eta_s * start.eta_s <= start.B
        and start.eta_s <= x["Q_0"] * y
        and x["k_0"] * y <= start.eta_s
        and gap <= x["U_0"] * (2 - x["U_0"]) * reach * reach
        and far * y * y <= w_0 * w_0 * wide
        and far * (Y_0 * y) * (Y_0 * y) <= w_1 * w_1 * wide
        and all(part * y <= x["z_b"] for part in (1, Y_0, x["beta_0"], x["beta_1"] * Y_0))
        and high_0 > 0
        and high_1 > 0
        and start.A <= high_0 * high_0
        and start.B <= high_1 * high_1
        and start.C - x["C_0"] <= room
        and x["C_0"] - start.C <= room
    )
