"""The cycle of the limit map: the only state on the separatrix that returns after two collisions.

That there is no other, and that it lies on the curve, is proved in `verify/coq/Separatrix.v`; that
it lies in the box printed is shown by Newton's method in balls.
"""

from __future__ import annotations

from verify.prover import balls
from verify.prover.balls import Ball
from verify.spheres.limit_map import DOUBLINGS, GUARD_BITS, Curve, CurveAt, Orbits, Point, direction

#: The digits of the first state on the curve, and how many steps of Newton's method follow.
NEAR_DIGITS, NEWTON_STEPS = 12, 30
#: Who decides where the cycle is.
NEWTON = "interval Newton in balls"

Matrix = tuple[Ball, Ball, Ball, Ball]


def cycle(curve: Curve, digits: int) -> tuple[Ball, ...]:
    """Enclosures of q and u of the cycle and of the state after it, verified; or nothing.

    A box around a point holds a cycle if Newton's map takes it into its interior and both
    collisions happen everywhere in it. Coq proves that there is no other, and that it is on the
    curve.
    """
    with balls.precision(4 * NEAR_DIGITS):
        s = balls.cube_root(balls.from_fraction(curve.parameters.r))
        q = balls.short_rational(s * s, NEAR_DIGITS)
    start = curve.strip(q, NEAR_DIGITS)
    if not start.reached:
        return ()
    bits = digits * 3322 // 1000 + GUARD_BITS
    for _ in range(DOUBLINGS):
        orbits = curve.orbits(bits)
        with balls.precision(bits):
            found = _verified(orbits, _polished(orbits, _near(orbits, start)))
            both = _with_next(orbits, found)
            if both and all(_width(ball) * 10**digits < ball for ball in both):
                return both
        bits *= 2
    return ()


def _with_next(orbits: Orbits, state: Point | None) -> tuple[Ball, ...]:
    """The state and the one after it; nothing if there is none for certain."""
    known, after = (0, None) if state is None else orbits.image(orbits.ratios[0], state)
    return () if state is None or after is None or known <= 0 else (*state, *after)


def _near(orbits: Orbits, start: CurveAt) -> Point:
    """The first state after an even number of collisions that two more move in order, unproved.

    On the curve they never do so, and all orbits tend to the cycle: this one has left the curve by
    no more than what is left of the way.
    """
    state = balls.from_fraction(start.q).mid(), balls.from_fraction((start.low + start.high) / 2)
    while orbits.budget.left > 0:
        orbits.budget.left -= 2
        after = _twice(orbits, state)
        if after is None or direction(state, _middle(after[0])):
            return state
        state = _middle(after[0])
    return state


def _polished(orbits: Orbits, state: Point) -> Point:
    """The state after some steps of Newton's method, without proof."""
    for _ in range(NEWTON_STEPS):
        after = _newton(orbits, state, state)
        if after is None:
            return state
        moved = abs(after[0] - state[0]) + abs(after[1] - state[1])
        state = _middle(after)
        if not moved > abs(state[1]) / (1 << (orbits.bits - 12)):
            return state
    return state


def _verified(orbits: Orbits, state: Point) -> Point | None:
    """A box around the state in which there is a cycle; None if that is not known."""
    size = orbits.bits // 2
    box = balls.around(state[0], size), balls.around(state[1], size)
    found = _newton(orbits, state, box)
    if found is None or not all(map(balls.inside, found, box)):
        return None
    found = _newton(orbits, _middle(found), found) or found
    return found if found[0] > 0 and found[1] > 0 and found[1] < 1 else None


def _width(ball: Ball) -> Ball:
    return ball.upper() - ball.lower()


def _newton(orbits: Orbits, state: Point, box: Point) -> Point | None:
    """Newton's map from the state, with the derivatives over the box; None if there are none.

    That it is not None says that both collisions happen everywhere in the box.
    """
    at_state, over_box = _twice(orbits, state), _twice(orbits, box)
    if at_state is None or over_box is None:
        return None
    (q, u), (a, b, c, d) = at_state[0], over_box[1]
    x, y = q - state[0], u - state[1]
    a, d = a - 1, d - 1
    determinant = a * d - b * c
    found = state[0] - (d * x - b * y) / determinant, state[1] - (a * y - c * x) / determinant
    return found if found[0].is_finite() and found[1].is_finite() else None


def _twice(orbits: Orbits, state: Point) -> tuple[Point, Matrix] | None:
    """The state after two collisions, and its derivatives."""
    known, middle = orbits.image(orbits.ratios[0], state)
    if known <= 0:
        return None
    known, after = orbits.image(orbits.ratios[1], middle)
    if known <= 0:
        return None
    a, b, c, d = _derivatives(orbits, orbits.ratios[0], state, middle)
    e, f, g, h = _derivatives(orbits, orbits.ratios[1], middle, after)
    return after, (e * a + f * c, e * b + f * d, g * a + h * c, g * b + h * d)


def _derivatives(orbits: Orbits, ratio: Ball, state: Point, after: Point) -> Matrix:
    """Of the next q by q and u, then of the next u, which is 1 - √(1-h) with h = top/p^2."""
    (q, u), (next_q, next_u) = state, after
    product, slope = ratio * u, orbits.a + ratio
    p = orbits.a * (1 - u) - q - product
    h = product * (2 * q + product) / (p * p)
    by_q = 2 * product / (p * p) + 2 * h / p
    by_u = 2 * ratio * (q + product) / (p * p) + 2 * h * slope / p
    root = 2 * (1 - next_u)
    return next_q / p, (next_q * slope - orbits.r) / p, by_q / root, by_u / root


def _middle(state: Point) -> Point:
    return balls.middle(state[0]), balls.middle(state[1])
