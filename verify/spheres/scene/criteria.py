"""Why only finitely many collisions are possible although they were not all followed.

What the last moment does not show the start may. A criterion about the time of a collapse would add
nothing: once that time has passed, R² >= 2 and A >= 0.

R² = Σ|x_i|², A = Σ x_i·v_i and L², the square of the angular momentum, belong to the frame of the
centre of mass; they are polynomials in the inner products of a state.
"""

from __future__ import annotations

from collections.abc import Sequence
from functools import reduce
from operator import add

from verify.language.record import Record
from verify.prover import balls
from verify.spheres.flow.follow import Flow
from verify.spheres.flow.law import EQUAL, Number, Sizes, State, inner, outer
from verify.spheres.scene.middle import excluded, middles, rests
from verify.spheres.scene.scene import FIRST_FRAMES, PAIRS, Frame

INELASTIC, RECEDING, TURNING, MOMENTUM = "restitution", "receding", "turning", "momentum"
#: What each criterion says, in words; and for spheres of which some are not equal.
SAYS_OF_UNEQUAL = {
    INELASTIC: "b < √r + √r' for each sphere in the middle, b² being the product of its shares: "
    "three such spheres never collapse",
    RECEDING: "A >= 0 and R² = Σ m|x|² >= B: they recede as a whole; a collapse would need R² <= B",
    TURNING: "A²R² < (R² - B)L² and R² = Σ m|x|² >= B: with this angular momentum R² never falls "
    "to B, the most that it is in a collapse",
    MOMENTUM: "b² < r + r' + t + t² with t³ = rr' for each sphere in the middle, b² being the "
    "product of its shares, and L ≠ 0: in a collapse of such spheres the angular momentum is 0",
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

    ``touching`` has, for each sphere, the most that R² can be where it touches both others; that
    is 2 where all masses and diameters are 1.
    """

    R2: Number
    A: Number
    L2: Number
    touching: tuple[Number, Number, Number]


def spread(
    state: State, frame: Frame, masses: Sequence[Number], contacts: Sequence[Number], sizes: Sizes
) -> Spread:
    """These of a state: sums over pairs with m_i m_j/M, M being the sum of all masses.

    The contact distances are those of `PAIRS`; the sizes are those in the frame.
    """
    o, s, c = frame
    total = masses[0] + masses[1] + masses[2]
    weights = [masses[i] * masses[j] / total for i, j in PAIRS]
    oc, os, sc = weights[o + c - 1], weights[o + s - 1], weights[s + c - 1]
    own, spectator = inner(state)
    found = ((oc, own, sizes.c), (os, spectator, sizes.s), (sc, outer(state, sizes), sizes.outer))
    squares = [weight * (pair.g + square) for weight, pair, square in found]
    rates = [weight * pair.p for weight, pair, _ in found]
    most = []
    for i, j, k in ((0, 1, 2), (1, 0, 2), (2, 0, 1)):
        one, two, far = i + j - 1, i + k - 1, j + k - 1
        near, next_to = contacts[one], contacts[two]
        inside = weights[one] * near**2 + weights[two] * next_to**2
        most.append(inside + weights[far] * (near + next_to) ** 2)
    turned = _turned(state, sizes, (os + sc, oc + sc, -sc))
    R2, A = squares[0] + squares[1] + squares[2], rates[0] + rates[1] + rates[2]
    return Spread(R2, A, turned, (most[0], most[1], most[2]))


def _of(table: dict[str, Number], i: str, j: str) -> Number:
    return table["sc"] if i != j else table[i + j]


def inelastic(r: Number) -> Number:
    """What is negative if r > 7 - 4√3, for r in (0, 1)."""
    return r**2 - 14 * r + 1


def comes_to_rest(r: Number) -> Number:
    """What is negative if r > 9 - 4√5, for r in (0, 1)."""
    return r**2 - 18 * r + 1


def turning(now: Whole | Spread, most: Number = 2) -> Number:
    """What is positive if the angular momentum keeps R² above its value at a collapse.

    R² is not below that value now.
    """
    return (now.R2 - most) * now.L2 - now.A**2 * now.R2


# --- decided in balls ----------------------------------------------------------------------------


class Criterion(Record):
    """A criterion that holds, of the last moment or already at the start."""

    name: str
    at_start: bool


def finitely_many(flow: Flow) -> Criterion | None:
    """A criterion that holds, if any."""
    scene, are_equal = flow.scene, flow.scene.bodies is None
    if inelastic(flow.r) < 0 if are_equal else all(map(excluded, middles(scene))):
        return Criterion(INELASTIC, at_start=True)
    first = _all_three(flow, FIRST_FRAMES[0], flow.start.state(FIRST_FRAMES[0], flow.keep))
    name = _of_whole(first)
    if name is None and first.L2 > 0:
        rest = comes_to_rest(flow.r) < 0 if are_equal else all(map(rests, middles(scene)))
        name = MOMENTUM if rest else None
    if name is not None:
        return Criterion(name, at_start=True)
    now = flow.now
    name = None if now is None else _of_whole(_all_three(flow, now.frame, now.state))
    return None if name is None else Criterion(name, at_start=False)


def _all_three(flow: Flow, frame: Frame, state: State) -> Whole | Spread:
    bodies = flow.scene.bodies
    if bodies is None:
        return whole(state)
    masses = [balls.fmpq_of(mass) for mass in bodies.masses]
    contacts = [balls.fmpq_of(bodies.radii[i] + bodies.radii[j]) for i, j in PAIRS]
    return spread(state, frame, masses, contacts, flow.sizes(frame))


def _of_whole(now: Whole | Spread) -> str | None:
    bounds = now.touching if isinstance(now, Spread) else (2,)
    if not all(now.R2 >= most for most in bounds):
        return None
    if now.A >= 0:
        return RECEDING
    return TURNING if all(turning(now, most) > 0 for most in bounds) else None
