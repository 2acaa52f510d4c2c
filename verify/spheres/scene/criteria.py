"""Why only finitely many collisions are possible although they were not all followed.

What the last moment does not show the start may. A criterion about the time of a collapse would add
nothing: once that time has passed, R² >= 2 and A >= 0.

R² = Σ|x_i|², A = Σ x_i·v_i and L², the square of the angular momentum, belong to the frame of the
centre of mass; they are polynomials in the inner products of a state.
"""

from __future__ import annotations

from collections.abc import Callable
from functools import reduce
from itertools import permutations
from operator import add

from verify.language.record import Record
from verify.prover import balls
from verify.spheres.flow.follow import Flow
from verify.spheres.flow.law import EQUAL, Number, Sizes, State, inner, outer
from verify.spheres.scene.scene import FIRST_FRAMES, Bodies, Frame

INELASTIC, RECEDING, TURNING, MOMENTUM = "restitution", "receding", "turning", "momentum"
#: What each criterion says, in words; and for spheres of which some are not equal.
SAYS_OF_UNEQUAL = {
    INELASTIC: "r > 7 - 4√3: three spheres of one mass with this r never collapse",
    RECEDING: "A >= 0 and R² = Σ m|x|² >= B: they recede as a whole; a collapse would need R² <= B",
    TURNING: "A²R² < (R² - B)L² and R² = Σ m|x|² >= B: with this angular momentum R² never falls "
    "to B, the most that it is in a collapse",
    MOMENTUM: "r > 9 - 4√5 and L ≠ 0: in a collapse of three spheres of one mass with this r the "
    "angular momentum is 0",
}
SAYS = {
    INELASTIC: "r > 7 - 4√3: three equal spheres with this r never collapse",
    RECEDING: "A >= 0 and R² >= 2: the spheres recede as a whole; a collapse would need R² <= 2",
    TURNING: "A²R² < (R² - 2)L² and R² >= 2: with this angular momentum R² never falls to 2",
    MOMENTUM: "r > 9 - 4√5 and L ≠ 0: in a collapse of three equal spheres with this r the angular "
    "momentum is 0",
}


class Whole(Record):
    """R², A and L² of three spheres."""

    R2: Number
    A: Number
    L2: Number


def whole(state: State) -> Whole:
    """The three numbers of a state."""
    pairs = (*inner(state), outer(state))
    R2 = 1 + (pairs[0].g + pairs[1].g + pairs[2].g) / 3
    A = (pairs[0].p + pairs[1].p + pairs[2].p) / 3
    return Whole(R2, A, angular(state))


def angular(state: State) -> Number:
    """L² for L = (2/3)(x_s∧W_s + x_c∧W_c) - (1/3)(x_s∧W_c + x_c∧W_s)."""
    return _turned(state, EQUAL, (2, 2, -1)) / 9


def _turned(state: State, sizes: Sizes, shares: tuple[Number, Number, Number]) -> Number:
    """The square of S x_s∧W_s + K x_c∧W_c + M (x_s∧W_c + x_c∧W_s) for shares S, K, M."""
    v, (own, other, mixed) = state.v, shares
    xx = {"ss": sizes.s + state.sig * v**2, "cc": sizes.c + state.eps * v**2, "sc": -state.C}
    ww = {"ss": state.B, "cc": state.A, "sc": state.w}
    xw = {"ss": state.rho * v, "cc": -(state.lam * v), "sc": state.a, "cs": state.b}

    def product(i: str, j: str, k: str, m: str) -> Number:
        """(x_i∧W_j)·(x_k∧W_m)."""
        return _of(xx, i, k) * _of(ww, j, m) - xw[i + m] * xw[k + j]

    blades = ((own, "s", "s"), (other, "c", "c"), (mixed, "s", "c"), (mixed, "c", "s"))
    parts = (n * k * product(i, j, x, y) for n, i, j in blades for k, x, y in blades)
    return reduce(add, parts)


class Spread(Record):
    """R² = Σ m|x|², A = Σ m x·v and L² of spheres with masses and radii.

    ``touching`` is the most that R² can be where one sphere touches both others; it is 2 where all
    masses and diameters are 1.
    """

    R2: Number
    A: Number
    L2: Number
    touching: Number


def spread(state: State, frame: Frame, bodies: Bodies, number: Callable[..., Number]) -> Spread:
    """These four of a state: sums over pairs with m_i m_j/M, M being the sum of all masses."""
    (o, s, c), sizes = frame, bodies.sizes(frame, number)
    total = sum(bodies.masses)
    weights = {
        (i, j): bodies.masses[i] * bodies.masses[j] / total for i, j in permutations(frame, 2)
    }
    oc, os, sc = (number(weights[pair]) for pair in ((o, c), (o, s), (s, c)))
    own, spectator = inner(state)
    found = ((oc, own, sizes.c), (os, spectator, sizes.s), (sc, outer(state, sizes), sizes.outer))
    squares = [weight * (pair.g + square) for weight, pair, square in found]
    rates = [weight * pair.p for weight, pair, _ in found]
    most = max(
        weights[i, j] * bodies.square(i, j)
        + weights[i, k] * bodies.square(i, k)
        + weights[j, k] * (2 * bodies.radii[i] + bodies.radii[j] + bodies.radii[k]) ** 2
        for i, j, k in ((0, 1, 2), (1, 0, 2), (2, 0, 1))
    )
    turned = _turned(state, sizes, (os + sc, oc + sc, -sc))
    R2, A = squares[0] + squares[1] + squares[2], rates[0] + rates[1] + rates[2]
    return Spread(R2, A, turned, number(most))


def _of(table: dict[str, Number], i: str, j: str) -> Number:
    return table["sc"] if i != j else table[i + j]


def inelastic(r: Number) -> Number:
    """What is negative if r > 7 - 4√3, for r in ]0,1[."""
    return r**2 - 14 * r + 1


def comes_to_rest(r: Number) -> Number:
    """What is negative if r > 9 - 4√5, for r in ]0,1[."""
    return r**2 - 18 * r + 1


def turning(now: Whole | Spread) -> Number:
    """What is positive if the angular momentum keeps R² above 2, where R² >= 2 now."""
    most = now.touching if isinstance(now, Spread) else 2
    return (now.R2 - most) * now.L2 - now.A**2 * now.R2


# --- decided in balls ----------------------------------------------------------------------------


class Criterion(Record):
    """A criterion that holds, of the last moment or already at the start."""

    name: str
    at_start: bool


def finitely_many(flow: Flow) -> Criterion | None:
    """A criterion that holds, if any."""
    if flow.scene.has_one_mass and inelastic(flow.r) < 0:
        return Criterion(INELASTIC, at_start=True)
    first = _all_three(flow, FIRST_FRAMES[0], flow.start.state(FIRST_FRAMES[0], flow.keep))
    name = _of_whole(first)
    if name is None and flow.scene.has_one_mass and comes_to_rest(flow.r) < 0 and first.L2 > 0:
        name = MOMENTUM
    if name is not None:
        return Criterion(name, at_start=True)
    now = flow.now
    name = None if now is None else _of_whole(_all_three(flow, now.frame, now.state))
    return None if name is None else Criterion(name, at_start=False)


def _all_three(flow: Flow, frame: Frame, state: State) -> Whole | Spread:
    bodies = flow.scene.bodies
    return whole(state) if bodies is None else spread(state, frame, bodies, balls.exact)


def _of_whole(now: Whole | Spread) -> str | None:
    most = now.touching if isinstance(now, Spread) else 2
    if not now.R2 >= most:
        return None
    if now.A >= 0:
        return RECEDING
    return TURNING if turning(now) > 0 else None
