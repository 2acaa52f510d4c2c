"""A ball between a flat wall and another ball: from its state after a bounce, why it collapses.

Ball 0 has just met the wall and meets ball 1 next; lengths are in units of their contact distance.
The theorem, which `docs/explanation/wall.md` proves, is that of three balls with one that has
neither a curvature nor a speed: between two bounces on the wall the state Q, U becomes

    P = b_1 C (1 - U) - Q,  Q' = r_1 Γ (1 - U)/P,  z = Γ Q U/P²    by the contact with ball 1,
    P = b_w C - Q' - z,  Q'' = r_w/P,  h(U'') P² = z (2Q' + z)     by the bounce,

with b_1 = (1+r_1) m_1/(m_0+m_1), b_w = 1 + r_w and h(U) = U(2-U). Floats find the numbers; what
the theorem asks of them is decided exactly, and of the state in balls.
"""

from __future__ import annotations

import math
from fractions import Fraction
from itertools import pairwise

from verify.language.record import Record
from verify.prover import balls
from verify.spheres.flow.law import Number
from verify.spheres.flow.sandwich import (
    ABOVE,
    LEAST,
    MOST,
    ROUNDS,
    SLACK,
    STEPS,
    TINY,
    above,
    root_part,
)
from verify.spheres.flow.three_balls import below, decay

Point = tuple[Fraction, Fraction]


class WallPair(Record):
    """What the wall and ball 1 give to ball 0: shares and coefficients of restitution.

    The first is that of ball 1, the second that of the wall. ``least_cosine`` keeps ball 1 off the
    wall; ``contact`` is the distance at which the balls touch, and ``given`` what ball 1 gets of a
    speed in a contact.
    """

    shares: tuple[Fraction, Fraction]
    r: tuple[Fraction, Fraction]
    least_cosine: Fraction
    contact: Fraction
    given: Fraction

    def share(self, i: int) -> Fraction:
        """What ball 0 gets of the speed of a contact with ball 1, or with the wall."""
        return self.shares[i]


class Start(Record):
    """Just after a bounce, lengths in units of the contact distance.

    ``y`` and ``eta`` are the speeds at which ball 0 meets ball 1 and leaves the wall, ``d`` the
    gap, ``A`` the square of the relative speed, ``C`` the cosine between the normal of the wall and
    the direction of ball 1.
    """

    y: Number
    eta: Number
    d: Number
    A: Number
    C: Number


class Bounds(Record):
    """The numbers of the theorem; speeds in a unit. E times the speed y is the time that is left.

    The first of two is that of contacts with ball 1, the second that of bounces.
    """

    pair: WallPair
    G: Fraction
    w: Fraction
    U_b: Fraction
    z_b: Fraction
    C_0: Fraction
    Theta: Fraction
    Y: tuple[Fraction, Fraction]
    k: tuple[Fraction, Fraction]
    E: Fraction


class WallCollapse(Record):
    """After what time the collapse is over at most, and how much velocities change until then."""

    later: Number
    reach: tuple[Number, Number]
    cosine: tuple[Number, Number]


def find_wall(pair: WallPair, start: Start) -> WallCollapse | None:
    """Why the balls collapse; None if the search finds no numbers, or balls do not show it."""
    y, eta, d, A, C = start
    if not (y > 0 and eta > 0 and d > 0 and A > 0 and C > 0):
        return None
    unit = balls.decimal(balls.any_root(A), 6 - balls.exponent(balls.any_root(A)), above=True)
    found = search(pair, start, balls.fraction_of(unit))
    if found is None:
        return None
    x, points = found
    if not shows(x, points, start, unit):
        return None
    rest = balls.fmpq_of(1 - x.Y[0] * x.Y[1])
    first = balls.fmpq_of(x.G) * y / rest * balls.fmpq_of(pair.contact)
    bounces = balls.fmpq_of(x.Y[0]) * y / rest * balls.fmpq_of(pair.contact * pair.share(1))
    middle = first * balls.fmpq_of(pair.share(0)) + bounces
    later = balls.fmpq_of(x.E) * y / (unit * unit)
    low, high = (balls.fmpq_of(end) for end in (x.C_0 - x.Theta, min(x.C_0 + x.Theta, Fraction(1))))
    return WallCollapse(later, (middle, first * balls.fmpq_of(pair.given)), (low, high))


# --- the search, in floats ------------------------------------------------------------------------


def search(pair: WallPair, start: Start, unit: Fraction) -> tuple[Bounds, list[Point]] | None:
    """Numbers, and points of which the last is below the one before."""
    size = balls.fmpq_of(unit)
    e, W = balls.as_float(start.y / size), balls.as_float(balls.any_root(start.A) / size)
    reach = (1 + start.d) * start.y
    zeta = balls.as_float(start.d * (2 + start.d) * start.A / (reach * reach))
    q = balls.as_float(start.eta / start.y)
    if not (0 < zeta < 1 and e > 0 and W > 0):
        return None
    widest, z_b, G = above(max(zeta, LEAST)), Fraction(0), Fraction(1)
    for _ in range(2 * ROUNDS):
        bounds = _bounds(pair, (e, W, q, balls.as_float(start.C)), min(widest, MOST), z_b, G)
        if bounds is None or bounds.C_0 - bounds.Theta <= max(Fraction(0), pair.least_cosine):
            return None
        faster = zeta * (float(bounds.w) / W) ** 2 * SLACK
        if faster >= 1:
            return None
        at = above(max(q, LEAST) * SLACK), above(max(root_part(Fraction(faster)), LEAST))
        points = _stair(bounds, at)
        if points is None:
            return None
        most = max(U for _, U in points)
        far = max(z for one in points[:-1] if (z := _height(bounds, one)) is not None)
        if most <= bounds.U_b and far <= bounds.z_b and bounds.G <= G:
            return bounds, points
        widest, z_b = max(widest, above(float(most) * SLACK)), max(z_b, above(float(far) * SLACK))
        G = max(G, bounds.G)
    return None


def _bounds(
    pair: WallPair,
    at: tuple[float, float, float, float],
    widest: Fraction,
    z_b: Fraction,
    G: Fraction,
) -> Bounds | None:
    """All bounds, where no U and no z are larger than these, and G is not smaller."""
    e, W, q, C = at
    Y, k = decay(pair, float(G), q, float(widest))
    if min(Y) <= 0 or Y[0] * Y[1] >= 1:
        return None
    b_w = float(pair.share(1))
    w = W + b_w * Y[0] * e / (1 - Y[0] * Y[1])
    part = float(widest * (2 - widest)) * (e / w) ** 2 * SLACK
    if part >= 1:
        return None
    root = math.sqrt(1 - part)
    G = max(G, 1 + above(part / (root * (1 + root)) * SLACK))
    least = below(k[0]), below(k[1])
    fall = [
        max(above((float(b * G) - float(low) / float(G)) * (1 + TINY)), above(LEAST))
        for b, low in zip(pair.shares, least, strict=True)
    ]
    rest = 1 - float(fall[0] * fall[1])
    if rest <= 0:
        return None
    speed = above((W + b_w * float(fall[0]) * e / rest) * (1 + TINY))
    later = above(float(G * widest + z_b * fall[0]) / float(speed) ** 2 / rest * SLACK)
    theta = max(float(speed * later) * e * SLACK, LEAST)
    power = Fraction(10) ** (4 - math.floor(math.log10(theta)))
    C_0 = min(Fraction(round(Fraction(C) * power)) / power, Fraction(1))
    wide = above(theta * 1.002 + abs(float(C_0) - C))
    return Bounds(pair, G, speed, widest, z_b, C_0, wide, (fall[0], fall[1]), least, later)


def _stair(x: Bounds, at: Point) -> list[Point] | None:
    """Points, each above what the one before becomes, of which the last is below the one before."""
    found = [at]
    for _ in range(STEPS):
        Q, U = found[-1]
        for begin in (Q, *(above(float(Q) * (1 + share)) for share in ABOVE)):
            after = _after(x, (begin, U))
            if after is not None and after[0] <= begin and after[1] <= U:
                return [*found[:-1], (begin, U), (begin, U)]
        after = _after(x, found[-1])
        if after is None:
            return None
        found.append(after)
    return None


def _after(x: Bounds, at: Point) -> Point | None:
    """A point above what a contact with ball 1 and a bounce lead to; None if they lead nowhere."""
    once = _contact(x, at)
    if once is None:
        return None
    (Q, z), C = once, x.C_0 - x.Theta
    P = x.pair.share(1) * C - Q - z
    if P <= 0 or z * (2 * Q + z) >= MOST * (2 - MOST) * P**2:
        return None
    return above(x.pair.r[1] / P), above(root_part(z * (2 * Q + z) / P**2))


def _contact(x: Bounds, at: Point) -> Point | None:
    """Q and z before the bounce, exactly; None where none follows."""
    (Q, U), C = at, x.C_0 - x.Theta
    P = x.pair.share(0) * C * (1 - U) - Q
    if P <= 0:
        return None
    return x.pair.r[0] * x.G * (1 - U) / P, x.G * Q * U / P**2


def _height(x: Bounds, at: Point) -> Fraction | None:
    once = _contact(x, at)
    return None if once is None else once[1]


# --- the conditions -------------------------------------------------------------------------------


def shows(x: Bounds, points: list[Point], start: Start, unit: Number) -> bool:
    """True only if the numbers, whose speeds are in a unit, satisfy all that the theorem asks."""
    return _closes(x, points) and _decays(x) and _holds_at(x, points[0], start, unit)


def _closes(x: Bounds, points: list[Point]) -> bool:
    """True only if the points satisfy what the theorem asks of them."""
    C = x.C_0 - x.Theta
    for (Q, U), (Q_next, U_next) in pairwise(points):
        once = _contact(x, (Q, U))
        if once is None or not (0 <= Q and 0 <= U <= x.U_b < 1 and once[1] <= x.z_b):
            return False
        P = x.pair.share(1) * C - once[0] - once[1]
        load = once[1] * (2 * once[0] + once[1])
        if P <= 0 or x.pair.r[1] > Q_next * P or load > U_next * (2 - U_next) * P**2:
            return False
    (Q, U), (Q_last, U_last) = points[-2:]
    return Q_last <= Q and U_last <= U


def _decays(x: Bounds) -> bool:
    """True only if the bounds without the state satisfy what the theorem asks of them."""
    G, Y, k, r = x.G, x.Y, x.k, x.pair.r
    return bool(
        G >= 1
        and min(Y) > 0
        and min(k) >= 0
        and Y[0] * Y[1] < 1
        and x.w > 0
        and all(G**2 * x.pair.share(i) <= G * Y[i] + k[i] for i in (0, 1))
        and k[1] * Y[0] <= r[0] * (1 - x.U_b)
        and k[0] * Y[1] <= r[1]
        and G * x.U_b + x.z_b * Y[0] <= x.E * x.w**2 * (1 - Y[0] * Y[1])
        and max(Fraction(0), x.pair.least_cosine) < x.C_0 - x.Theta
        and x.C_0 <= 1
    )


def _holds_at(x: Bounds, point: Point, start: Start, unit: Number) -> bool:
    """True only if the numbers and the state satisfy what the theorem asks of them."""
    exact, (y, eta, d, A, C) = balls.fmpq_of, start
    (Q, U), w = point, exact(x.w) * unit
    wide = x.U_b * (2 - x.U_b) * x.G**2
    high = w - exact(x.pair.share(1) * x.Y[0] / (1 - x.Y[0] * x.Y[1])) * y
    room = exact(x.Theta) - exact(x.w * x.E) * y / unit
    reach = (1 + d) * y
    return bool(
        eta <= exact(Q) * y
        and exact(x.k[0]) * y <= eta
        and d * (2 + d) * w * w <= exact(U * (2 - U)) * reach * reach
        and exact(wide) * y * y <= w * w * exact(x.G**2 - 1)
        and high > 0
        and A <= high * high
        and C - exact(x.C_0) <= room
        and exact(x.C_0) - C <= room
    )
