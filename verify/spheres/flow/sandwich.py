"""From a state just after a collision: numbers with which the sandwich theorem shows a collapse.

The search is in floats for the start and in short decimals for the stair, and proves nothing; what
the theorem asks for is then decided, with the letters of that statement: of rational numbers
exactly, of the state in balls.
"""

from __future__ import annotations

import math
from collections.abc import Iterator, Mapping, Sequence
from fractions import Fraction
from itertools import pairwise
from typing import Protocol

from verify.language.record import Record
from verify.prover import balls
from verify.spheres.flow.collapse import Collapse, Start, may_collapse, short_above, start_of
from verify.spheres.flow.law import Number, State

#: By how much bounds are widened, so that inequalities become strict; speeds, and the angle.
SLACK, TINY, TURN_SLACK = 1.0005, 1e-7, 1.002
#: No number is smaller than this one, and no U larger than that one.
LEAST, MOST = 1e-250, Fraction(9, 10)
#: How many steps a stair has at most, and how often the bound of all U is found anew.
STEPS, ROUNDS = 60, 8
#: Significant digits of the numbers.
DIGITS = 7
#: How far above the fixed point the last two steps of a stair may begin, relatively.
ABOVE = (1e-5, 1e-4, 1e-3, 0.01, 0.03, 0.1, 0.2, 0.4)

Point = tuple[Fraction, Fraction]


class Fixed(Protocol):
    """The map of two numbers with fixed parameters; those of its steps may alternate."""

    @property
    def U_b(self) -> Fraction:  # noqa: N802
        """No U is larger."""

    def alpha(self, n: int) -> Fraction:
        """The factor of 1 - U in P at the n-th step."""

    def rho(self, n: int) -> Fraction:
        """The factor of U in P at the n-th step."""

    def restitution(self, n: int) -> Fraction:
        """The factor of (1 - U)/P in Q' at the n-th step."""


class Bounds(Record):
    """The numbers of the theorem but Q_0 and U_0; the state in units of the larger speed."""

    r: Fraction
    G: Fraction
    w_0: Fraction
    w_1: Fraction
    U_b: Fraction
    C_0: Fraction
    Theta: Fraction

    def alpha(self, _: int) -> Fraction:
        """The factor of 1 - U in P."""
        return (1 + self.r) / 2 * (self.C_0 - self.Theta)

    def restitution(self, _: int) -> Fraction:
        """The factor of (1 - U)/P in Q'."""
        return self.r * self.G

    def rho(self, n: int) -> Fraction:
        """The factor of U in P at the n-th step: the particles exchange their roles each time."""
        return self.G * (self.w_0 / self.w_1 if n % 2 else self.w_1 / self.w_0) ** 2


def step_of(bounds: Fixed, n: int, at: Point) -> Point | None:
    """A point above where the n-th step leads; None if it leads nowhere below U_b."""
    Q, U = at
    push = bounds.rho(n) * U
    P = bounds.alpha(n) * (1 - U) - Q - push
    if P <= 0:
        return None
    load = push * (2 * Q + push) / P**2
    if load >= bounds.U_b * (2 - bounds.U_b):
        return None
    found = above(root_part(load))
    if found > bounds.U_b or load > found * (2 - found):
        return None
    return above(bounds.restitution(n) * (1 - U) / P), found


def root_part(load: Fraction) -> float:
    """1 - sqrt(1 - load), and a little more."""
    x = float(load)
    return x / (1 + math.sqrt(1 - x)) * (1 + 1e-12)


def above(value: float | Fraction, digits: int = DIGITS) -> Fraction:
    """A decimal with few digits that is no less than a positive number."""
    exact = Fraction(value)
    if exact <= 0:
        return Fraction(0)
    power = Fraction(10) ** (digits - 1 - math.floor(math.log10(exact)))
    return math.ceil(exact * power) / power


class Stair(Record):
    """Points Q_n, U_n; two steps lead from each of the last two but two to below it."""

    points: tuple[Point, ...]

    @property
    def last(self) -> int:
        """N, where the last N + 2 points repeat."""
        return len(self.points) - 3


def cycle_of(bounds: Fixed) -> tuple[float, float] | None:
    """What Q tends to where U is 0, before even and odd steps; None if Q does not go on."""
    alpha, R = ([float(f(n)) for n in (0, 1)] for f in (bounds.alpha, bounds.restitution))
    if min(alpha) <= 0:
        return None
    found = []
    for n in (0, 1):
        half = alpha[0] * alpha[1] + R[1 - n] - R[n]
        root = half * half - 4 * alpha[0] * alpha[1] * R[1 - n]
        if half <= 0 or root <= 0:
            return None
        found.append(2 * R[1 - n] * alpha[n] / (half + math.sqrt(root)))
    return found[0], found[1]


def find_stair(bounds: Fixed, at: Point) -> Stair | None:
    """A stair that begins above a point, and ends below itself."""
    points: list[Point] = []
    cycle = cycle_of(bounds)
    if cycle is None or not may_close(bounds, at, cycle):
        return None
    for n in range(STEPS):
        for Q in _candidates(at[0], cycle[n % 2]):
            here = (Q, at[1])
            end = _closes(bounds, n, here)
            if end is not None:
                return Stair((*points, here, *end))
        points.append(at)
        following = step_of(bounds, n, at)
        if following is None:
            return None
        at = following
    return None


def may_close(bounds: Fixed, at: Point, cycle: tuple[float, float]) -> bool:
    """Whether a stair closes in floats: most do not, and this says so far sooner.

    It is the search of `find_stair` without its rounding up, so that it gives up later.
    """
    top = float(bounds.U_b) + TINY
    alpha, R, rho = (
        [float(f(n)) for n in (0, 1)] for f in (bounds.alpha, bounds.restitution, bounds.rho)
    )

    def step(n: int, Q: float, U: float) -> tuple[float, float] | None:
        push = rho[n % 2] * U
        P = alpha[n % 2] * (1 - U) - Q - push
        if P <= 0:
            return None
        load = push / P * ((2 * Q + push) / P)
        found = load / (1 + math.sqrt(1 - load)) if load < 1 else 1.0
        return None if found > top else (R[n % 2] * (1 - U) / P, found)

    # What a step leads to grows with Q: where two steps from (Q, U) end above U, or nowhere, so do
    # those from every larger Q.
    Q, U = map(float, at)
    once = step(0, Q, U)
    for n in range(STEPS):
        twice = None if once is None else step(n + 1, *once)
        if once is None or twice is None:
            return False
        if twice[1] <= U * (1 + TINY):
            for begin in (Q, *(cycle[n % 2] * (1 + share) for share in ABOVE)):
                one = step(n, begin, U) if begin >= Q else None
                two = None if one is None else step(n + 1, *one)
                if two and two[0] <= begin * (1 + TINY) and two[1] <= U * (1 + TINY):
                    return True
        (Q, U), once = once, twice
    return False


def _candidates(Q: Fraction, fixed: float) -> Iterator[Fraction]:
    yield Q
    for share in ABOVE:
        found = above(fixed * (1 + share))
        if found > Q:
            yield found


def _closes(bounds: Fixed, n: int, here: Point) -> tuple[Point, Point] | None:
    """The two points after this one, if the second is below it."""
    once = step_of(bounds, n, here)
    twice = None if once is None else step_of(bounds, n + 1, once)
    if once is None or twice is None or twice[0] > here[0] or twice[1] > here[1]:
        return None
    return once, twice


def search(r: Fraction, start: Start, unit: Fraction) -> tuple[Bounds, Stair] | None:
    """A stair that probably begins above a state; speeds are in this unit."""
    size = balls.fmpq_of(unit)
    e = balls.as_float(start.y / size)
    speeds = [balls.as_float(balls.any_root(x) / size) for x in (start.A, start.B)]
    reach = (1 + start.d) * start.y
    zeta = balls.as_float(start.d * (2 + start.d) * start.A / (reach * reach))
    q = above(max(balls.as_float(start.eta_s / start.y), LEAST) * SLACK)
    if not (0 < zeta < 1 and 0 < e):
        return None
    widest = above(max(zeta, LEAST))
    for _ in range(ROUNDS):
        bounds = bounds_of(r, start.C, (e, *speeds), min(widest, MOST))
        faster = 0.0 if bounds is None else zeta * (float(bounds.w_0) / speeds[0]) ** 2 * SLACK
        if bounds is None or faster >= 1:
            return None
        u = above(max(faster / (1 + math.sqrt(1 - faster)), LEAST))
        stair = find_stair(bounds, (q, u))
        if stair is None:
            return None
        most = max(U for _, U in stair.points)
        if most <= widest:
            return bounds._replace(U_b=widest), stair
        widest = above(float(most) * SLACK)
    return None


def bounds_of(r: Fraction, C: Number, sizes: Sequence[float], widest: Fraction) -> Bounds | None:
    """Bounds of the speeds and of the angle, where no U is larger than the widest."""
    e, W_0, W_1 = sizes
    half, zeta = (1 + float(r)) / 2, float(widest * (2 - widest))
    kick = half / (1 - half * half) * e  # the gain for G = 1, which is no more than for any other
    share = zeta * (e / min(W_0 + half * kick, W_1 + kick)) ** 2 * SLACK
    if share >= 1:
        return None
    G = 1 + above(share / (math.sqrt(1 - share) * (1 + math.sqrt(1 - share))) * SLACK)
    ratio = half * float(G)
    if ratio >= 1:
        return None
    gain = ratio / (1 - ratio * ratio) * e * (1 + TINY)
    w_0, w_1 = above((W_0 + ratio * gain) * (1 + TINY)), above((W_1 + gain) * (1 + TINY))
    step = float(G * widest / min(w_0, w_1) ** 2) / (1 - ratio)
    theta = max((float(w_0 + w_1) + e) * step * e * TURN_SLACK, LEAST)
    C_0 = min(balls.fraction_of(balls.decimal(C, 4 - math.floor(math.log10(theta)))), Fraction(1))
    return Bounds(r, G, w_0, w_1, MOST, C_0, above(theta))


def find_sandwich(r: Fraction, state: State, time: Number) -> Collapse | None:
    """Why the state collapses; None if the search finds no numbers, or balls do not show it."""
    if not state.lam > 0 or not may_collapse(float(r), balls.as_float(state.C)):
        return None
    start = start_of(state)
    if not (start.A > 0 and start.B > 0 and start.y > 0 and start.eta_s > 0 and start.d > 0):
        return None
    unit = short_above(balls.any_root(balls.larger(start.A, start.B)))
    found = search(r, start, balls.fraction_of(unit))
    if found is None:
        return None
    bounds, stair = found
    numbers = numbers_of(bounds, stair, unit)
    if not (closes(bounds, stair) and holds_at(numbers, start)):
        return None
    later = duration(numbers) * start.y
    return Collapse(numbers, start, (time, time + later), stair.points)


def numbers_of(x: Bounds, stair: Stair, unit: Number) -> dict[str, Number]:
    """The numbers by their names in the statement."""
    Q_0, U_0 = stair.points[0]
    others = {name: getattr(x, name) for name in ("r", "G", "U_b", "C_0", "Theta")}
    others |= {"Q_0": Q_0, "U_0": U_0}
    exact = {name: balls.fmpq_of(value) for name, value in others.items()}
    w_0, w_1 = (balls.fmpq_of(w) * unit for w in (x.w_0, x.w_1))
    return exact | {"w_0": w_0, "w_1": w_1, "w_b": min(w_0, w_1)}


# --- the conditions ------------------------------------------------------------------------------


def closes(bounds: Fixed, stair: Stair) -> bool:
    """True only if the points satisfy what the theorem asks of a stair."""
    points, U_b = stair.points, bounds.U_b
    (Q_N, U_N), (Q, U) = points[-3], points[-1]
    pairs = enumerate(pairwise(points))
    return (
        Q <= Q_N
        and U <= U_N
        and all(0 <= Q and 0 <= U <= U_b < 1 for Q, U in points)
        and all(_is_step(bounds, n, here, following) for n, (here, following) in pairs)
    )


def _is_step(x: Fixed, n: int, here: Point, following: Point) -> bool:
    (Q, U), (Q_next, U_next) = here, following
    push = x.rho(n) * U
    P = x.alpha(n) * (1 - U) - Q - push
    load = push * (2 * Q + push)
    falls = load <= U_next * (2 - U_next) * P**2
    return x.alpha(n) >= 0 and P > 0 and x.restitution(n) * (1 - U) <= Q_next * P and falls


def duration(x: Mapping[str, Number]) -> Number:
    """A bound of the time that is left, per closing speed."""
    return x["G"] * x["U_b"] / (x["w_b"] * x["w_b"]) / (1 - (1 + x["r"]) / 2 * x["G"])


def holds_at(x: Mapping[str, Number], start: Start) -> bool:
    """True only if the numbers and the state satisfy what the theorem asks of them."""
    G, U_b, w, y, ratio = x["G"], x["U_b"], x["w_b"], start.y, (1 + x["r"]) / 2 * x["G"]
    if not (0 < ratio < 1 and G >= 1 and 0 < w):
        return False
    gain = ratio / (1 - ratio * ratio) * y
    high_0, high_1 = x["w_0"] - ratio * gain, x["w_1"] - gain
    room = x["Theta"] - (x["w_0"] + x["w_1"] + y) * duration(x) * y
    gap, reach = start.d * (2 + start.d) * x["w_0"] * x["w_0"], (1 + start.d) * y
    return bool(
        w <= x["w_0"]
        and w <= x["w_1"]
        and U_b < 1
        and x["U_0"] <= U_b
        and x["Theta"] < x["C_0"] <= 1
        and y * y <= start.A
        and start.eta_s * start.eta_s <= start.B
        and start.eta_s <= x["Q_0"] * y
        and gap <= x["U_0"] * (2 - x["U_0"]) * reach * reach
        and U_b * (2 - U_b) * y * y * G * G <= w * w * (G * G - 1)
        and high_0 > 0
        and high_1 > 0
        and start.A <= high_0 * high_0
        and start.B <= high_1 * high_1
        and start.C - x["C_0"] <= room
        and x["C_0"] - start.C <= room
    )
