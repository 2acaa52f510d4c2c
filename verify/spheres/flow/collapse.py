"""From a state just after a collision: numbers with which the sharper theorem shows a collapse.

They are found by a fixed-point iteration in floats, which proves nothing; that they satisfy what
the theorem asks for is then decided in balls, with the letters of that statement.
"""

from __future__ import annotations

import math
from collections.abc import Mapping
from fractions import Fraction

from verify.language.record import Record
from verify.prover import balls
from verify.spheres.flow.law import EQUAL, Number, Sizes, State

#: What the theorems on collapses are cited as.
SHARPER, SANDWICH, LINE, THREE_BALLS = "sharper", "sandwich", "line", "three-balls"
#: By how much the iteration widens what it finds, so that inequalities become strict.
SLACK = 1.001
ROUNDS = 60
#: How many decimals of a root are taken, the next where there is none.
ROOT_PLACES = (12, 50, 200)
#: Widths of ratios below this one are not worth a float, and nothing is smaller than that one.
LEAST, TINY = 1e-11, 1e-250


class Start(Record):
    """The state in the paper's letters: unit vectors, and d the distance of the colliding pair."""

    y: Number
    eta_s: Number
    C: Number
    a: Number
    b: Number
    A: Number
    B: Number
    w: Number
    d: Number


class Collapse(Record):
    """The numbers of a theorem on collapses, and what these conclude.

    ``stair`` has the points with which the sandwich theorem or that on three balls applies, and is
    empty for the others.
    """

    numbers: Mapping[str, Number]
    start: Start
    time: tuple[Number, Number]
    stair: tuple[tuple[Fraction, Fraction], ...] = ()

    @property
    def is_on_a_line(self) -> bool:
        """Whether the spheres are on a line."""
        return "E" in self.numbers

    @property
    def theorem(self) -> str:
        """What the theorem is cited as."""
        if self.is_on_a_line:
            return LINE
        if "beta_0" in self.numbers:
            return THREE_BALLS
        return SANDWICH if self.stair else SHARPER

    @property
    def ratio(self) -> float:
        """About how much shorter the time that is left becomes with each collision."""
        if self.is_on_a_line:
            return 1 - 1 / balls.as_float(self.numbers["E"])
        if "p" in self.numbers:
            return balls.as_float(self.numbers["m"] / self.numbers["p"])
        C = balls.as_float(self.numbers["C_0"])
        if "beta_0" in self.numbers:
            return self._ratio_of_pairs(C)
        r = balls.as_float(self.numbers["r"])
        alpha = (1 + r) / 2 * C
        p = (alpha + math.sqrt(max(0.0, alpha * alpha - 4 * r))) / 2
        return r / p**2

    def _ratio_of_pairs(self, C: float) -> float:
        """The same where shares and coefficients of restitution alternate: over two collisions."""
        names = ("r_0", "r_1", "beta_0", "beta_1")
        r_0, r_1, beta_0, beta_1 = (balls.as_float(self.numbers[name]) for name in names)
        t = beta_0 * beta_1 * C**2 - r_0 - r_1
        z = (t + math.sqrt(max(0.0, t * t - 4 * r_0 * r_1))) / 2
        return math.sqrt(r_0 * r_1) / z

    @property
    def angle(self) -> tuple[Fraction, Fraction]:
        """Between what -cos of the final angle lies."""
        if self.is_on_a_line:
            return Fraction(1), Fraction(1)
        C, theta = (balls.fraction_of(self.numbers[name]) for name in ("C_0", "Theta"))
        return C - theta, min(C + theta, Fraction(1))


def start_of(state: State, sizes: Sizes = EQUAL) -> Start:
    """The state with ω_c = x_c/|x_c|, where s is in contact with o.

    For spheres of other sizes ω_s is x_s/|x_s|, and d is in units of the contact distance of o, c.
    """
    gap = state.eps * state.v**2
    reach = balls.any_root(sizes.c + gap)
    touch, near = (1 if sizes is EQUAL else balls.any_root(x) for x in (sizes.c, sizes.s))
    return Start(
        y=state.lam * state.v / reach,
        eta_s=state.rho * state.v / near,
        C=state.C / (reach * near),
        a=state.a / near,
        b=state.b / reach,
        A=state.A,
        B=state.B,
        w=state.w,
        d=gap / (touch * (touch + reach)),
    )


def find_collapse(r: Fraction, state: State, time: Number) -> Collapse | None:
    """Why the state collapses; None if the search finds no numbers, or balls do not show it."""
    if not state.lam > 0 or not may_collapse(float(r), balls.as_float(state.C)):
        return None
    start = start_of(state)
    if not (start.A > 0 and start.B > 0 and start.y > 0):
        return None
    numbers = search_numbers(r, start)
    if numbers is None or not satisfies(numbers, start):
        return None
    T, eta_0, p, Y = (numbers[name] for name in ("T", "eta_0", "p", "Y"))
    return Collapse(numbers, start, (time, time + T * eta_0 / (1 - p - Y)))


def find_line_collapse(
    r: Fraction, state: State, time: Number, sizes: Sizes, other: Sizes
) -> Collapse | None:
    """Why spheres on a line collapse; None if balls do not show it.

    The sizes are those of o, s and c, and the other ones with s and c exchanged.
    """
    if not (state.lam > 0 and state.C > 0):
        return None
    start = start_of(state, sizes)
    b, b_s = (balls.fraction_of((1 + balls.fmpq_of(r)) / of.ratio) for of in (sizes, other))
    if not (start.y > 0 and start.eta_s > 0 and start.d > 0):
        return None
    least = _fixed_point(r / (b * b_s))
    if least is None:
        return None
    q = start.eta_s / (balls.fmpq_of(b) * start.y)
    Q = max(balls.fraction_of(short_above(q)), least)
    is_below = start.eta_s <= balls.fmpq_of(Q * b) * start.y
    if not (2 * Q < 1 and r <= b * b_s * Q * (1 - Q) and is_below):
        return None
    E = balls.fmpq_of((1 - Q) / (1 - 2 * Q))
    reach = 1 if sizes is EQUAL else balls.any_root(sizes.c)
    later = E * (start.d * reach / start.y)
    return Collapse({"Q": balls.fmpq_of(Q), "E": E}, start, (time, time + later))


def _fixed_point(r: Fraction) -> Fraction | None:
    """A rational number just above the smaller root of Q(1 - Q) = r; None without two roots."""
    discriminant = 1 - 4 * r
    for places in ROOT_PLACES:
        scale = 10**places
        root = math.isqrt(max(0, math.floor(discriminant * scale**2)))
        if root:
            return (1 - Fraction(root, scale)) / 2
    return None


def may_collapse(r: float, C: float) -> bool:
    """Whether the first condition of Zhou and Kadanoff holds at this angle, about."""
    return (1 + r) / 2 * C > 2 * math.sqrt(r)


# --- the search ----------------------------------------------------------------------------------


class Trial:
    """Bounds in floats, with velocities in units of the larger relative speed."""

    def __init__(self, r: float, e: float, q: float, C: float, k: float) -> None:
        self.r, self.e, self.q, self.C, self.h = r, e, q, C, (1 + r) / 2
        alpha = self.h * C
        self.p, self.Y = (alpha + math.sqrt(alpha * alpha - 4 * r)) / 2, LEAST
        self.m, self.X = r / self.p, LEAST
        self.k0 = self.k = max(k * SLACK, TINY)
        self.V = self.T = self.Theta = 0.0

    def step(self) -> bool:
        """One round: each bound from the others; False where they leave the theorem's range."""
        r, e, h, L = self.r, self.e, self.h, self.p + self.Y
        G = 1 + self.k * e * e
        if L >= 1 or self.p <= self.Y:
            return False
        self.V = V = (1 + h * G * e / (1 - L)) * SLACK
        if 2 * self.k * V * V >= 1:
            return False
        self.T = T = 2 * self.k / (1 + math.sqrt(1 - 2 * self.k * V * V)) * SLACK
        s, TV = 1 - T * V * V, T * V
        total = 2 * TV * e / (1 - L) + (self.k + TV * TV) * e * e / (1 - L * L)
        self.Theta = max((total + TV * self.k * e**3 / (1 - L**3)) * SLACK, TINY)
        self.m, self.X = widened(min(self.q, r * s / L), max(self.q, r * G / (self.p - self.Y)))
        self.m = max(self.m, self.X)  # which the theorem asks for
        low, high = max(self.m - self.X, 0.0), self.m + self.X
        top = h * G * (self.C + self.Theta) - low / G
        bottom = h * s * (self.C - self.Theta) - high - T * V * V
        if s <= 0 or bottom <= 0:
            return False
        self.p, self.Y = widened(bottom, top)
        lower = self.p - self.Y
        if lower < LEAST:
            return False
        self.k = max(self.k0, (high * T + TV * TV / 2) / (lower * lower) * SLACK)
        return True


def widened(low: float, high: float) -> tuple[float, float]:
    """The middle, and a little more than half the width."""
    return (low + high) / 2, (high - low) / 2 * SLACK + LEAST


def search_numbers(r: Fraction, start: Start) -> dict[str, Number] | None:
    """Numbers that probably satisfy what the theorem asks for, as exact rationals."""
    speed = balls.any_root(balls.larger(start.A, start.B))
    V_0, eta_0 = short_above(speed), short_above(start.y)
    e, C = balls.as_float(eta_0 / V_0), balls.as_float(start.C)
    if e == 0 or not may_collapse(float(r), C):
        return None
    k = balls.as_float(start.d / (start.y * start.y) * (V_0 * V_0))
    trial = Trial(float(r), e, balls.as_float(start.eta_s / start.y), C, k)
    before = 0.0
    for _ in range(ROUNDS):
        if not trial.step():
            return None
        size = trial.Y + trial.k + trial.X
        if abs(size - before) < 2e-5 * size:
            break
        before = size
    low, high = balls.ends(balls.as_ball(start.C))
    trial.Theta = max(trial.Theta, 4 * float(high - low))  # no less than what is known of the angle
    return _rational(trial, start) | {"r": balls.fmpq_of(r), "V_0": V_0, "eta_0": eta_0}


def _rational(trial: Trial, start: Start) -> dict[str, Number]:
    """The bounds as short decimals, each rounded to the side where it is weaker."""
    X, unit = _short(trial.X), short_above(balls.any_root(balls.larger(start.A, start.B)))
    C_0 = balls.decimal(start.C, 3 + _places(trial.Theta))
    square = unit * unit
    return {
        "m": max(_near(trial.m), X),
        "p": _near(trial.p),
        "X": X,
        "Y": _short(trial.Y),
        "k": _short(trial.k) / square,
        "V": _short(trial.V) * unit,
        "T": _short(trial.T) / square,
        "C_0": min(C_0, balls.ratio(1, 1)),
        "Theta": _short(trial.Theta),
    }


def _places(value: float) -> int:
    return max(0, -math.floor(math.log10(value)))


def short_above(value: Number) -> Number:
    """A decimal with about six digits that is no less than a positive number."""
    return balls.decimal(value, 5 - balls.exponent(value), above=True)


def _near(value: float) -> Number:
    """A decimal with twelve places."""
    return balls.ratio(round(value * 10**12), 10**12)


def _short(value: float) -> Number:
    """A decimal with about five digits that is no less."""
    power = 10 ** (_places(value) + 4)
    top, divisor = value.as_integer_ratio()
    return balls.ratio(-(-top * power // divisor), power)


# --- the conditions ------------------------------------------------------------------------------


def satisfies(x: Mapping[str, Number], start: Start) -> bool:
    """True only if the numbers and the state satisfy all that the sharper theorem asks for."""
    return _close(x) and _begin(x, start)


def _close(x: Mapping[str, Number]) -> bool:
    """The inequalities between the numbers."""
    r, m, p, X, Y, k, V, T = (x[name] for name in ("r", "m", "p", "X", "Y", "k", "V", "T"))
    h, s, G, L = (1 + r) / 2, 1 - T * V * V, 1 + k * x["eta_0"] ** 2, p + Y
    C, theta = x["C_0"], x["Theta"]
    return bool(
        X <= m
        and L < 1
        and p > Y
        and theta < C
        and C <= 1
        and x["eta_0"] <= x["V_0"]
        and h * G * x["eta_0"] <= (V - x["V_0"]) * (1 - L)
        and 2 * k <= T * (2 - T * V * V)
        and h * G * G * (C + theta) <= L * G + (m - X)
        and p - Y <= h * s * (C - theta) - (m + X) - T * V * V
        and r * G <= (m + X) * (p - Y)
        and (m - X) * L <= r * s
        and (m + X) * T + V * V * T * T / 2 <= k * (p - Y) ** 2
    )


def _begin(x: Mapping[str, Number], start: Start) -> bool:
    """The inequalities between the numbers and the state."""
    m, X, k, V, T, eta, L = *(x[n] for n in ("m", "X", "k", "V", "T", "eta_0")), x["p"] + x["Y"]
    total = 2 * T * V / (1 - L) * eta + (k + (T * V) ** 2) / (1 - L**2) * eta**2
    total += T * V * k / (1 - L**3) * eta**3
    room = x["Theta"] - total
    return bool(
        start.y > 0
        and start.y <= eta
        and start.eta_s > 0
        and start.eta_s <= (m + X) * start.y
        and (m - X) * start.y <= start.eta_s
        and start.d > 0
        and start.d <= k * start.y**2
        and start.A > 0
        and start.A <= x["V_0"] ** 2
        and start.B <= x["V_0"] ** 2
        and start.C - x["C_0"] <= room
        and x["C_0"] - start.C <= room
    )
