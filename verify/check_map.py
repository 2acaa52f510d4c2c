#!/usr/bin/env python3
"""Check the log of a map.

    python3 -I verify/check_map.py [--long] LOG [LOG ...]

A map is a rectangle of scenes, each with three spheres, cut into boxes; or an interval of them, cut
into parts. The log says of a box that all its scenes collapse, or that in all of them no two
spheres meet any more after finitely many collisions, or that only finitely many are possible, or
nothing. This program reads the log, proves every verdict anew, and counts areas.

It needs Python 3.11 and nothing else, calculates with whole numbers only, and searches nothing:
which collision is the next one is derived anew; that a collapse follows is shown by the six numbers
that the log has for it. What it takes on trust, besides itself and Python:

* the law of collision in inner products, and that three inequalities show a pair to be apart until
  the next collision: the theorem of `certificates/flow`;
* that the inequalities of `closes` imply a collapse: the theorem of `certificates/sharper`;
* for spheres on a line, that those of `closes_on_a_line` do: the theorem of `certificates/line`;
* that r > 7 - 4√3 leaves finitely many collisions, and so does r > 9 - 4√5 where the angular
  momentum about the centre of mass is not 0: the theorem of `certificates/classification`;
* that the inequalities of `parts` leave finitely many collisions of one sphere with the two others
  in turn: the theorem of `certificates/outside`; that these two never meet is proved in `parts`.

A scene in which two spheres just graze has the verdict that it gets whether this counts as a
collision or not. Scenes with a triple contact or an overlap at the start are excluded.
That only finitely many collisions are possible is said unless three touch at once or two graze.

The exit code is 0 if all is proved, 1 if a verdict is not, 4 if a log is malformed, 2 if a file
cannot be read, 5 if this program fails, for example where there is too little memory. Work is
counted: a box, and a log without `--long`, is refused where it is too much.
"""

from __future__ import annotations

import json
import os
import re
import sys
from collections.abc import Callable, Iterator, Mapping, Sequence
from fractions import Fraction
from functools import cache, lru_cache, partial
from hashlib import sha256
from itertools import chain, count
from math import isqrt
from typing import Any, NamedTuple

#: Numbers are counted in units of 2^-PLACES; the six numbers of a collapse in units of 2^-30.
PLACES, GRID = 96, 30
ONE = 1 << PLACES
#: How far a box is followed, in all its branches together, and all boxes: so checking ends. A step
#: is a collision, or the six numbers of a collapse tried once.
MAX_STEPS, MAX_WORK = 2000, 290_000
#: To begin with a box costs as much as so many steps.
BOX_PRICE = 3
MAX_FIRST, MAX_LEVEL, MAX_DIGITS, MAX_SIXES = 8, 40, 40, 64
#: `parts` is asked once in so many steps, costs as much as so many, and tries so long a floor.
EACH, PARTS_PRICE, MAX_FLOOR = 8, 200, 1000
#: Of a line in bytes, and of a number of a state or a term in bits: a collision can double it.
MAX_LINE, MAX_BITS = 1 << 24, 16 * PLACES
#: Of the fraction of the area, in bits.
MAX_AREA = 1 << 13

#: The theorems that are taken on trust; their certificates have these names. The last three only
#: where they are used: on a line; where the verdict is that there are finitely many collisions; and
#: where collisions are shown to end that were not followed to the last one.
GIVEN, LINE, CLASSIFICATION, OUTSIDE = ("flow", "sharper"), "line", "classification", "outside"
#: Of the terms of a family: how many operations they have in all, and how deep one goes.
MAX_OPERATIONS, MAX_DEPTH = 1000, 60

#: Two whole numbers of units with a number between them, ends included.
Interval = tuple[int, int]


class LogError(ValueError):
    """The log is malformed."""


class RefusedError(ValueError):
    """A verdict is not proved."""


class Work:
    """What may still be spent, in steps with short intervals; None for any amount."""

    def __init__(self, left: int | None = MAX_WORK) -> None:
        self.left = left

    def spend(self, price: int) -> None:
        """Less is left afterwards.

        Raises:
            RefusedError: if nothing is.
        """
        if self.left is not None:
            self.left -= price
            if self.left < 0:
                raise RefusedError("all boxes together are more work than the limit; use --long")


# --- whole numbers around real ones --------------------------------------------------------------


def around(value: Fraction) -> Interval:
    """A rational number lies between these."""
    top, under = value.numerator << PLACES, value.denominator
    return top // under, -(-top // under)


def add(x: Interval, y: Interval) -> Interval:
    """The sum."""
    return x[0] + y[0], x[1] + y[1]


def sub(x: Interval, y: Interval) -> Interval:
    """The difference."""
    return x[0] - y[1], x[1] - y[0]


def mul(x: Interval, y: Interval) -> Interval:
    """The product."""
    a, b = x
    c, d = y
    if a >= 0 and c >= 0:
        return a * c >> PLACES, -(-b * d >> PLACES)
    ac, ad, bc, bd = a * c, a * d, b * c, b * d
    return min(ac, ad, bc, bd) >> PLACES, -(-max(ac, ad, bc, bd) >> PLACES)


def square(x: Interval) -> Interval:
    """The square."""
    a, b = x
    if a < 0:
        if b > 0:
            b = max(-a, b)
            return 0, -(-b * b >> PLACES)
        a, b = -b, -a
    return a * a >> PLACES, -(-b * b >> PLACES)


def div(x: Interval, y: Interval) -> Interval:
    """The quotient.

    Raises:
        RefusedError: if the divisor is not positive.
    """
    a, b = x
    c, d = y
    if c <= 0 or d <= 0:
        raise RefusedError("a divisor may be 0")
    return (a << PLACES) // (d if a >= 0 else c), -((-b << PLACES) // (c if b >= 0 else d))


def root(x: Interval) -> Interval:
    """The root.

    Raises:
        RefusedError: if the number may be negative.
    """
    if x[0] < 0 or x[1] < 0:
        raise RefusedError("a radicand may be negative")
    return isqrt(x[0] << PLACES), isqrt(x[1] << PLACES) + 1


def neg(x: Interval) -> Interval:
    """The negative."""
    return -x[1], -x[0]


def root_of_share(x: Interval) -> Interval:
    """The root, of those numbers that are in [0, 1]."""
    return root((max(x[0], 0), max(min(x[1], ONE), 0)))


def above(x: Interval, least: int) -> Interval:
    """The same numbers where they are no less than that."""
    return min(max(x[0], least), x[1]), x[1]


UNIT: Interval = (ONE, ONE)

# --- polynomials around numbers that depend on two parameters ------------------------------------

#: low, high, c0, …, c5, e: for all |x|, |y| <= 1 the number is in [low, high], and within e of
#: c0 + c1 x + c2 y + c3 x² + c4 xy + c5 y².
Model = tuple[int, int, int, int, int, int, int, int, int]


def model(bounds: Interval, c: Sequence[int], e: int) -> Model:
    """The bounds are cut with the range of the polynomial."""
    (low, high), (c0, c1, c2, c3, c4, c5) = bounds, c
    radius = abs(c1) + abs(c2) + abs(c3) + abs(c4) + abs(c5) + e
    least, most = c0 - radius, c0 + radius
    if low < least:
        low = least
    if high > most:
        high = most
    return low, high, c0, c1, c2, c3, c4, c5, e


def flat(x: Interval) -> Model:
    """Only the bounds are known."""
    middle = (x[0] + x[1]) >> 1
    return x[0], x[1], middle, 0, 0, 0, 0, 0, max(x[1] - middle, middle - x[0])


def add_models(x: Model, y: Model) -> Model:
    """The sum."""
    k, j, a0, a1, a2, a3, a4, a5, e = x
    m, n, b0, b1, b2, b3, b4, b5, f = y
    return model((k + m, j + n), (a0 + b0, a1 + b1, a2 + b2, a3 + b3, a4 + b4, a5 + b5), e + f)


def neg_model(x: Model) -> Model:
    """The negative."""
    return -x[1], -x[0], -x[2], -x[3], -x[4], -x[5], -x[6], -x[7], x[8]


def sub_models(x: Model, y: Model) -> Model:
    """The difference."""
    k, j, a0, a1, a2, a3, a4, a5, e = x
    m, n, b0, b1, b2, b3, b4, b5, f = y
    return model((k - n, j - m), (a0 - b0, a1 - b1, a2 - b2, a3 - b3, a4 - b4, a5 - b5), e + f)


def product(x: Model, y: Model) -> tuple[tuple[int, ...], int]:
    """The polynomial of a product, and its error; the bounds of the factors have no part in it.

    Each coefficient is rounded once, by less than a unit; products of a higher degree are errors.
    """
    _, _, a0, a1, a2, a3, a4, a5, e = x
    _, _, b0, b1, b2, b3, b4, b5, f = y
    c = (
        a0 * b0 >> PLACES,
        a0 * b1 + a1 * b0 >> PLACES,
        a0 * b2 + a2 * b0 >> PLACES,
        a0 * b3 + a1 * b1 + a3 * b0 >> PLACES,
        a0 * b4 + a1 * b2 + a2 * b1 + a4 * b0 >> PLACES,
        a0 * b5 + a2 * b2 + a5 * b0 >> PLACES,
    )
    first, second = abs(a1) + abs(a2), abs(a3) + abs(a4) + abs(a5)
    third, fourth = abs(b1) + abs(b2), abs(b3) + abs(b4) + abs(b5)
    rest = first * fourth + second * (third + fourth) + (abs(b0) + third + fourth + f) * e
    return c, (rest + (abs(a0) + first + second) * f >> PLACES) + 7


def mul_models(x: Model, y: Model) -> Model:
    """The product."""
    bounds = mul(x[:2], y[:2])
    if not (y[3] or y[4] or y[5] or y[6] or y[7]):
        return _scaled(bounds, x, y[2], y[8])
    if not (x[3] or x[4] or x[5] or x[6] or x[7]):
        return _scaled(bounds, y, x[2], x[8])
    return model(bounds, *product(x, y))


def _scaled(bounds: Interval, x: Model, by: int, off: int) -> Model:
    """The product with a number that is the same for all parameters."""
    _, _, c0, c1, c2, c3, c4, c5, e = x
    c = [n * by >> PLACES for n in (c0, c1, c2, c3, c4, c5)]
    size = abs(c0) + abs(c1) + abs(c2) + abs(c3) + abs(c4) + abs(c5) + e
    return model(bounds, c, (abs(by) * e + size * off >> PLACES) + 7)


def square_model(x: Model) -> Model:
    """The square."""
    return model(square(x[:2]), *product(x, x))


def series(
    x: Model, f: tuple[int, int, int], off: tuple[int, int, int], rest: int
) -> tuple[Sequence[int], int]:
    """f0 + f1 t + f2 t² for t = x - c0, each f off by so much, and its error."""
    _, _, _, c1, c2, c3, c4, c5, e = x
    f0, f1, f2 = f
    linear = abs(c1) + abs(c2)
    others = abs(c3) + abs(c4) + abs(c5) + e
    size = (linear + others) ** 2 + ONE >> PLACES
    # t² is (c1 x + c2 y)² and a rest, in units of 2^-PLACES again.
    past = (2 * linear + others) * others + ONE >> PLACES
    both = (
        f0,
        f1 * c1 >> PLACES,
        f1 * c2 >> PLACES,
        f1 * c3 + f2 * (c1 * c1 >> PLACES) >> PLACES,
        f1 * c4 + f2 * (2 * c1 * c2 >> PLACES) >> PLACES,
        f1 * c5 + f2 * (c2 * c2 >> PLACES) >> PLACES,
    )
    e = abs(f1) * e + abs(f2) * (past + 3) + off[1] * (linear + others) + off[2] * size
    return both, (e >> PLACES) + 7 + off[0] + rest


def div_models(x: Model, y: Model) -> Model:
    """The quotient.

    1/(c0 + t) = 1/c0 - t/c0² + t²/c0³ - t³/(c0³ (c0 + t)), where |t| <= radius < c0.

    Raises:
        RefusedError: if the divisor is not positive.
    """
    bounds, inverse = div(x[:2], y[:2]), _inverse(y)
    return flat(bounds) if inverse is None else model(bounds, *product(x, inverse))


@lru_cache(maxsize=4)
def _inverse(y: Model) -> Model | None:
    """1/y without bounds, if its radius is less than c0."""
    c0, radius = y[2], sum(map(abs, y[3:]))
    if c0 <= radius:
        return None
    cube = c0 * c0 * c0
    f = ((ONE * ONE) // c0, -(ONE**3 // (c0 * c0)), ONE**4 // cube)
    rest = (radius**3 * ONE * ONE) // (cube * (c0 - radius)) + 1
    c, e = series(y, f, (1, 1, 1), rest)
    return 0, 0, c[0], c[1], c[2], c[3], c[4], c[5], e


def root_model(x: Model) -> Model:
    """The root.

    Raises:
        RefusedError: if the number may be negative.
    """
    return _root_within(x, root(x[:2]))


def root_of_share_model(x: Model) -> Model:
    """The root, of those numbers that are in [0, 1]."""
    return _root_within(x, root_of_share(x[:2]))


def _root_within(x: Model, bounds: Interval) -> Model:
    """√(c0 + t) = q + t/(2q) - t²/(8q³) + R, q = √c0, |R| <= |t|³/(16 (c0 - radius)^(5/2))."""
    c0, radius = x[2], sum(map(abs, x[3:]))
    least = c0 - radius
    if least <= 0:
        return flat(bounds)
    q = isqrt(c0 << PLACES)
    f = (q, ONE * ONE // (2 * q), -(ONE**4 // (8 * q**3)))
    off = (1, ONE * ONE // (2 * q * q) + 2, 3 * ONE**4 // (8 * q**4) + 2)
    # |R|² in units is at most radius^6 ONE / (256 least^5).
    rest = isqrt(radius**6 * ONE // (256 * least**5)) + 1
    return model(bounds, *series(x, f, off, rest))


def above_model(x: Model, least: int) -> Model:
    """The same numbers where they are no less than that."""
    return *above(x[:2], least), *x[2:]


class Arithmetic(NamedTuple):
    """The operations on one kind of numbers."""

    add: Callable[[Any, Any], Any]
    sub: Callable[[Any, Any], Any]
    mul: Callable[[Any, Any], Any]
    div: Callable[[Any, Any], Any]
    square: Callable[[Any], Any]
    neg: Callable[[Any], Any]
    root: Callable[[Any], Any]
    root_of_share: Callable[[Any], Any]
    above: Callable[[Any, int], Any]
    one: Any
    price: int


INTERVALS = Arithmetic(add, sub, mul, div, square, neg, root, root_of_share, above, UNIT, 1)
MODELS = Arithmetic(
    add_models,
    sub_models,
    mul_models,
    div_models,
    square_model,
    neg_model,
    root_model,
    root_of_share_model,
    above_model,
    flat(UNIT),
    10,
)

# --- states and their collisions -----------------------------------------------------------------

#: An interval, or a model: its first two entries are its bounds.
Number = Any


class Law(NamedTuple):
    """A kind of numbers, and r, (1+r)/2, 1 - r² in it; r as an interval too."""

    kind: Arithmetic
    r: Number
    half: Number
    lost: Number
    bounds: Interval


#: The law, or what it is on the box with a key.
Laws = Law | Callable[[str], Law]


def on_box(law: Laws, key: str) -> Law:
    """The law on a box."""
    return law if isinstance(law, Law) else law(key)


def law_of(r: Fraction, kind: Arithmetic = INTERVALS) -> Law:
    """The coefficients of the law of collision."""
    half, lost = number(kind, (1 + r) / 2), number(kind, 1 - r * r)
    return Law(kind, number(kind, r), half, lost, around(r))


def law_around(r: Number, kind: Arithmetic = MODELS) -> Law:
    """The same for an r that is one of the numbers of a box.

    Raises:
        RefusedError: if it may not be in (0, 1).
    """
    if r[0] <= 0 or r[1] >= ONE:
        raise RefusedError("r may not be in (0, 1)")
    half = kind.mul(kind.add(kind.one, r), number(kind, Fraction(1, 2)))
    return Law(kind, r, half, kind.sub(kind.one, kind.square(r)), r[:2])


@cache
def number(kind: Arithmetic, value: Fraction) -> Number:
    """A rational number."""
    return around(value) if kind is INTERVALS else flat(around(value))


class Sight(NamedTuple):
    """Spheres s and c seen from o; s is in contact with o and does not approach it.

    Centres x_s, x_c and velocities W_s, W_c, with a unit v > 0 of speed: x_c·W_c = -lam v,
    |x_c|² = 1 + eps v², x_s·W_s = rho v with rho >= 0, A = |W_c|², B = |W_s|², C = -x_s·x_c,
    a = x_s·W_c, b = x_c·W_s, w = W_s·W_c.
    """

    v: Number
    lam: Number
    rho: Number
    eps: Number
    A: Number
    B: Number
    C: Number
    a: Number
    b: Number
    w: Number


class Three(NamedTuple):
    """Two spheres: g = |x|² - 1, p = x·w and m = |w|²."""

    g: Number
    p: Number
    m: Number


def own(kind: Arithmetic, z: Sight) -> Three:
    """The pair o, c."""
    p = kind.neg(kind.mul(z.lam, z.v))
    return Three(kind.mul(z.eps, kind.square(z.v)), p, z.A)


def far(kind: Arithmetic, z: Sight) -> Three:
    """The pair s, c."""
    add, sub, mul = kind[:3]
    g = add(add(kind.one, mul(z.eps, kind.square(z.v))), add(z.C, z.C))
    p = sub(sub(mul(sub(z.rho, z.lam), z.v), z.a), z.b)
    return Three(g, p, sub(add(z.A, z.B), add(z.w, z.w)))


def from_s(kind: Arithmetic, z: Sight, pair: Three) -> Sight:
    """The same moment seen from s, which now has o for the spectator."""
    sub, neg = kind.sub, kind.neg
    g, p, m = pair
    rho, C = kind.mul(z.rho, z.v), sub(neg(z.C), kind.one)
    a, b = sub(rho, z.a), sub(rho, z.b)
    return Sight(kind.one, neg(p), rho, g, m, z.B, C, a, b, sub(z.B, z.w))


def looks(kind: Arithmetic, lam: Number, A: Number, eps: Number) -> int:
    """-1 if a pair never meets in free flight, 1 if it always does, 0 if that is open."""
    if lam[1] <= 0:
        return -1
    if kind is not INTERVALS and (told := looks(INTERVALS, lam[:2], A[:2], eps[:2])):
        return told
    low, high = kind.sub(kind.square(kind.above(lam, 0)), kind.mul(A, eps))[:2]
    if high < 0:
        return -1
    return 1 if lam[0] > 0 and low > 0 else 0


class Way(NamedTuple):
    """The flight until o and c meet: lam, y, q, s, T of the theorem; the time is y T."""

    lam: Number
    y: Number
    q: Number
    s: Number
    T: Number


def way_of(kind: Arithmetic, z: Sight) -> Way | None:
    """The flight of those states from which o and c meet: lam² >= A eps and 0 <= s <= 1.

    None if it may take for ever.
    """
    div, one = kind.div, kind.one
    lam = kind.above(z.lam, isqrt(max(z.A[0], 0) * max(z.eps[0], 0)))
    if lam[0] <= 0:
        return None
    kap = div(div(z.eps, lam), lam)
    s = kind.root_of_share(kind.sub(one, kind.mul(z.A, kap)))
    return Way(lam, kind.mul(lam, z.v), div(z.rho, lam), s, div(kap, kind.add(one, s)))


def is_apart(kind: Arithmetic, pair: Three, way: Way) -> bool:
    """Whether a pair is shown to be apart until o and c have met: Bernstein's coefficients."""
    add, mul = kind.add, kind.mul
    g, p, m = pair
    time = mul(way.y, way.T)
    last = add(g, mul(time, add(add(p, p), mul(m, time))))
    return bool(g[0] >= 0 and add(g, mul(p, time))[0] >= 0 and last[0] > 0)


def collide(law: Law, z: Sight, way: Way, sig: Number | None = None) -> Sight:
    """The state just after o and c have collided; now c is the spectator.

    Before the first collision s need not be in contact: |x_s|² = 1 + sig v².
    """
    add, sub, mul, div, square = law.kind[:5]
    lam, y, q, s, T = way
    speed, time = mul(y, s), mul(y, T)
    turned, TB = mul(time, z.w), mul(T, z.B)
    push, f = mul(law.half, speed), add(z.b, turned)
    C = sub(z.C, mul(time, add(z.a, f)))
    double, other = add(f, f), mul(law.r, speed)
    A = add(z.B, mul(push, add(double, push)))
    B = sub(z.A, mul(law.lost, square(speed)))
    pushed = mul(push, C)
    a, b = add(f, push), sub(add(z.a, turned), add(pushed, pushed))
    w = add(z.w, mul(push, add(double, other)))
    eps = mul(T, add(add(q, q), TB))
    if sig is not None:
        eps = add(eps, div(div(sig, lam), lam))
    lam = sub(sub(mul(mul(law.half, s), C), q), TB)
    return Sight(y, lam, mul(law.r, s), eps, A, B, C, a, b, w)


def bounds(z: Sight) -> Sight:
    """The same in intervals."""
    return Sight(*(x[:2] for x in z))


def is_plain(z: Sight, way: Way) -> bool:
    """Whether bounds alone tell that o and c are the first to meet, if they do."""
    pair = far(INTERVALS, bounds(z))
    if looks(INTERVALS, neg(pair.p), pair.m, pair.g) < 0:
        return True
    return is_apart(INTERVALS, pair, Way(*(x[:2] for x in way)))


def after(law: Law, z: Sight) -> tuple[bool, list[Sight]]:
    """Whether some states have no further collision, and the states after that of the others.

    Where it is open whether a pair meets, states are followed in both branches.

    Raises:
        RefusedError: if it is open which collision is the next one.
    """
    if z.rho[0] <= 0 and z.B[0] <= 0:
        raise RefusedError("the spectator may stay in contact")
    kind, near = law.kind, looks(law.kind, z.lam, z.A, z.eps)
    way = way_of(kind, z) if near >= 0 else None
    if near > 0 and way is not None and kind is not INTERVALS and is_plain(z, way):
        return False, [collide(law, z, way)]
    pair = far(kind, z)
    away = looks(kind, kind.neg(pair.p), pair.m, pair.g)
    if near < 0 and away < 0:
        return True, []
    may_end = near < 1 and away < 1
    if way is not None and (away < 0 or is_apart(kind, pair, way)):
        # Where both meet, o and c are first; s and c meet only where o and c do not.
        first, other = collide(law, z, way), None if near > 0 else _other(law, z, pair, away)
        return may_end, [first] if other is None else [first, other]
    if away < 0:
        raise RefusedError("it is open whether o and c meet")
    seen = from_s(kind, z, pair)
    seen_way = way_of(kind, seen)
    if seen_way is None or not (near < 0 or is_apart(kind, own(kind, z), seen_way)):
        raise RefusedError("it is open which collision is the next one")
    first = collide(law, seen, seen_way)
    if near < 0 or away > 0:
        return may_end, [first]
    if way is None:
        raise RefusedError("it is open whether o and c meet")
    return may_end, [first, collide(law, z, way)]


def _other(law: Law, z: Sight, pair: Three, away: int) -> Sight | None:
    """The state after the collision of s and c, where o and c miss each other."""
    if away < 0:
        return None
    seen = from_s(law.kind, z, pair)
    way = way_of(law.kind, seen)
    if way is None:
        raise RefusedError("it is open whether s and c meet")
    return collide(law, seen, way)


def first_after(
    law: Law, pairs: Sequence[Three], sight: Callable[[int], tuple[Sight, Number]]
) -> tuple[bool, list[Sight]]:
    """The same for the first collision: the three pairs, each with a sight of its own, and sig.

    Of two pairs that may both meet one has to be shown to be apart until the other has met; a pair
    is not the first where another one always meets before.

    Raises:
        RefusedError: if that is open, or the spheres may overlap.
    """
    kind = law.kind
    if any(pair.g[0] < 0 for pair in pairs):
        raise RefusedError("spheres may overlap")
    touching = [pair for pair in pairs if pair.g[0] == 0]
    if len(touching) > 1 or any(pair.m[0] <= 0 for pair in touching):
        raise RefusedError("three spheres may touch, or two of them may stay in contact")
    meets = [looks(kind, kind.neg(pair.p), pair.m, pair.g) for pair in pairs]
    sights = [sight(i) if meet >= 0 else None for i, meet in enumerate(meets)]
    ways = [None if seen is None else way_of(kind, seen[0]) for seen in sights]
    states = []
    for i, (way, seen) in enumerate(zip(ways, sights, strict=True)):
        if seen is None:
            continue
        others = [j for j in range(3) if j != i and meets[j] >= 0]
        before = [j for j in others if _is_before(kind, pairs, ways, j, i)]
        for j in others:
            if j not in before and not _is_before(kind, pairs, ways, i, j):
                raise RefusedError("it is open which collision is the first one")
        if any(meets[j] > 0 and not _is_before(kind, pairs, ways, i, j) for j in before):
            continue
        if way is None:
            raise RefusedError("it is open whether a pair meets")
        states.append(collide(law, seen[0], way, seen[1]))
    return max(meets) < 1, states


def _is_before(
    kind: Arithmetic, pairs: Sequence[Three], ways: Sequence[Way | None], i: int, j: int
) -> bool:
    """Whether the pair j is shown to be apart until the pair i has met."""
    way = ways[i]
    return way is not None and is_apart(kind, pairs[j], way)


# --- what implies a collapse ---------------------------------------------------------------------


def closes(law: Law, z: Sight, numbers: tuple[Interval, ...]) -> bool:
    """Whether the sharper theorem says that all states collapse, by these numbers.

    T has 2k = T (2 - T V²), Theta is the sum of all turns, and C_0 is -cos of the state itself.
    """
    m, p, X, Y, k, V = numbers
    if z.lam[0] <= 0 or z.rho[0] <= 0:
        return False
    mX, mx = add(m, X), sub(m, X)
    kind = law.kind
    reach = kind.root(kind.add(kind.one, kind.mul(z.eps, kind.square(z.v))))
    # The entry: m - X <= eta_s/(-eta_c) <= m + X and d <= k eta_c².
    inverse = kind.div(reach, z.lam)
    ratio = kind.mul(z.rho, inverse)
    if ratio[1] > mX[0] or mx[1] > ratio[0]:
        return False
    slope = kind.mul(kind.div(z.eps, kind.add(kind.one, reach)), kind.square(inverse))
    if slope[1] > k[0]:
        return False
    L, least, kVV = add(p, Y), sub(p, Y), mul(k, square(V))
    free, under = sub(UNIT, L), sub(UNIT, add(kVV, kVV))
    if mx[0] < 0 or free[0] <= 0 or least[0] <= 0 or under[0] <= 0 or L[0] < 0:
        return False
    speed = isqrt(max(z.A[1], z.B[1], 0) << PLACES) + 1
    top = max(kind.div(kind.mul(z.lam, z.v), reach)[1], 0)
    eta, s = (top, top), root(under)
    T = div(add(k, k), add(UNIT, s))
    return _rows(
        law, kind.div(z.C, reach)[:2], (mX, mx, L, least, k, V, T, s), eta, max(speed, top)
    )


def _rows(law: Law, C: Interval, numbers: tuple[Interval, ...], eta: Interval, speed: int) -> bool:
    r = law.bounds
    half = (r[0] + ONE) >> 1, -(-(r[1] + ONE) >> 1)
    mX, mx, L, least, k, V, T, s = numbers
    TV, eta_2, L_2 = mul(T, V), square(eta), square(L)
    G = add(UNIT, mul(k, eta_2))
    TVV, free = mul(TV, V), sub(UNIT, L)
    turn = add(
        div(mul(add(TV, TV), eta), free),
        div(mul(add(k, square(TV)), eta_2), sub(UNIT, L_2)),
    )
    turn = add(turn, div(mul(mul(TV, k), mul(eta_2, eta)), sub(UNIT, mul(L_2, L))))
    jump = mul(half, G)
    high = mul(mul(jump, G), add(C, turn))
    low = sub(sub(mul(mul(half, s), sub(C, turn)), mX), TVV)
    low_2, high_2 = square(TV)
    drift = add(mul(mX, T), (low_2 >> 1, -(-high_2 >> 1)))
    return (
        turn[1] < C[0]
        and mul(jump, eta)[1] <= mul((V[0] - speed, V[1] - speed), free)[0]
        and high[1] <= add(mul(L, G), mx)[0]
        and least[1] <= low[0]
        and mul(r, G)[1] <= mul(mX, least)[0]
        and mul(mx, L)[1] <= mul(r, s)[0]
        and drift[1] <= mul(k, square(least))[0]
    )


def closes_on_a_line(law: Law, z: Sight) -> bool:
    """Whether the theorem on a line says that all states collapse; the spheres are on a line.

    Its number Q is the ratio of the two speeds, or about the smaller root of Q((1+r)/2 - Q) = r.
    """
    if min(z.lam[0], z.rho[0], z.eps[0], z.v[0], z.C[0]) <= 0:
        return False
    kind, r = law.kind, law.bounds[1]
    reach = kind.root(kind.add(kind.one, kind.mul(z.eps, kind.square(z.v))))
    half = (law.bounds[0] + ONE) >> 1
    under = half * half - 4 * r * ONE
    if under <= 0:
        return False
    least = ((half - isqrt(under) + 1) >> 1) + (1 << PLACES - 60)
    Q = max(kind.mul(z.rho, kind.div(reach, z.lam))[1], least)
    return bool(2 * Q < half and r <= Q * (half - Q) >> PLACES)


def parts(law: Law, z: Sight) -> bool:
    """Whether all spheres part: o meets c and s in turn only so often, by `outside`, s never c.

    The numbers of that theorem are chosen: v as half of the least speed, the others nearly as well
    as they can be.

    Until s and c meet, o meets them in turn. Say one of them, at x with a velocity W, approaches at
    a speed y when it becomes the next one, and hits at a normal speed h. In free flight (x·W)² -
    |W|²|x|² stays the same, so |x|²(|W|² - y²) = |W|² - h² <= |W|². As y <= -eta_c < v <= |W|,
    start-reach gives |x| <= Γ, and h <= |x| y <= Γ y. The hit changes the velocity of o by (1+r)/2
    h; the other one had x·W > 0 after its own hit (s at the start has), which grows in free flight,
    so now it approaches at (1+r)/2 h <= Λ y at most. So the n-th h is at most Γ Λⁿ⁻¹ (-eta_c), and
    their sum is at most shift = Γ (-eta_c)/(1 - Λ). It bounds what |W| loses: v + shift <= |W| at
    the start is enough. The velocity of s seen from c changes by less: the two never meet if in
    free flight their distance is above 1 + t shift at all times t.
    """
    if min(z.lam[0], z.rho[0], z.eps[0], z.A[0], z.B[0]) <= 0:
        return False
    kind, half = law.kind, (-(-(law.bounds[1] + ONE) >> 1),) * 2
    reach = kind.root(kind.add(kind.one, kind.mul(z.eps, kind.square(z.v))))
    y = (kind.div(kind.mul(z.lam, z.v), reach)[1],) * 2
    speeds = root(z.A[:2]), root(z.B[:2])
    v = (min(speeds[0][0], speeds[1][0]) >> 1,) * 2
    G = ((ONE >> 40) + add(UNIT, div(square(y), square(v)))[1],) * 2
    Lambda = mul(half, G)
    free = sub(UNIT, Lambda)
    if free[0] <= 0:  # decay-positive
        return False
    shift = div(mul(G, y), free)[1]
    (v_0, w_0), (v_1, w_1) = ((low - shift, high + shift) for low, high in speeds)
    turning = div(mul(mul(add(add((w_0, w_0), (w_1, w_1)), add(y, y)), G), y), mul(square(v), free))
    C = max(kind.div(z.C, reach)[1], 0) + turning[1]
    zeta = mul(kind.div(z.eps, kind.square(z.lam))[:2], square((v_0, v_0)))[0]
    if min(v_0, v_1) < v[0] or zeta >= ONE:  # v_0-least, v_1-least, U_0-room
        return False
    Q = kind.mul(z.rho, kind.div(reach, z.lam))[0]
    rhos = [square(div((v_s, v_s), (w_c, w_c)))[0] for v_s, w_c in ((v_1, w_0), (v_0, w_1))]
    return (
        C <= 2 * ONE  # C-room
        and mul(square(y), square(G))[1] <= mul(square(v), sub(square(G), UNIT))[0]  # start-reach
        and _stay_apart(far(kind, z), shift)
        and _floor_ends(mul(Lambda, (C, C))[1], law.bounds[0], rhos, Q, _least_u(zeta, ONE))
    )


def parting(work: Work) -> Callable[[Law, Sight], bool]:
    """The same, asked once in so many steps."""
    steps = count(1)

    def closing(law: Law, z: Sight) -> bool:
        if next(steps) % EACH:
            return False
        work.spend(PARTS_PRICE)
        return parts(law, z)

    return closing


def _stay_apart(pair: Three, shift: int) -> bool:
    """Whether |x + w t| > 1 + t shift for all t >= 0."""
    g, p, m = (x[:2] for x in pair)
    slower, wide = sub(m, square((shift, shift))), (shift, shift)
    return min(g[0], slower[0]) > 0 and looks(INTERVALS, sub(wide, p), slower, g) < 0


def _least_u(load: int, P: int) -> int:
    """A number u in [0, 1] with u (2 - u) <= load/P², where this is less than 1."""
    return max(ONE - isqrt(ONE * ONE - load * ONE**3 // (P * P)) - 1, 0)


def _floor_ends(alpha: int, r: int, rhos: Sequence[int], Q: int, U: int) -> bool:
    """Whether a floor that begins at (Q, U) ends: P <= 0, or load >= P²; rhos alternate."""
    old_Q, old_U = -1, -1
    for n in range(MAX_FLOOR):
        if n % 2 == 0:
            if Q <= old_Q and U <= old_U:
                return False  # it goes on, as the map keeps the order of points
            old_Q, old_U = Q, U
        pull = rhos[n % 2] * U >> PLACES
        P = -(-alpha * (ONE - U) >> PLACES) - Q - pull
        load = pull * (2 * Q + pull) >> PLACES
        if P <= 0 or load * ONE >= P * P:
            return True
        Q, U = r * (ONE - U) // P, _least_u(load, P)  # floor-rises-Q, floor-rises-U
    return False


def check_finite(law: Law, turns: Callable[[], bool] = lambda: False) -> None:
    """Afterwards there are finitely many collisions; `turns` says whether L is not 0.

    Above 7 - 4√3, where r² - 14 r + 1 < 0, there is no collapse. Above 9 - 4√5, where
    r² - 18 r + 1 < 0, all velocities about the centre of mass vanish at a collapse, so that L is 0.

    Raises:
        RefusedError: if that is not shown.
    """
    r = law.bounds[0]
    if r >= ONE or r * r - 18 * r * ONE + ONE * ONE >= 0:
        raise RefusedError("r may be 9 - 4√5 or less")
    if r * r - 14 * r * ONE + ONE * ONE >= 0 and not turns():
        raise RefusedError("r may be 7 - 4√3 or less, and the angular momentum 0")


# --- the planes of maps --------------------------------------------------------------------------

Side = tuple[Fraction, Fraction]


class Phi(NamedTuple):
    """φ1 = eta_s/(-eta_c) and φ2 = d/eta_c² in a rectangle; the rest of the scene is the same.

    W_c = eta_c ω_c + u_c n_c and W_s = eta_s ω_s + u_s n_s, with n a right angle to the left of ω.
    """

    r: Fraction
    neg_cos: Fraction
    speed: Fraction
    tangential: Side
    x: Side
    y: Side


#: Positions or velocities, a sphere, a coordinate.
Place = tuple[str, int, int]
Rows = tuple[tuple[Fraction, ...], ...]


class Through(NamedTuple):
    """A scene, of which two numbers vary in a rectangle."""

    r: Fraction
    positions: Rows
    velocities: Rows
    x_at: Place
    y_at: Place
    x: Side
    y: Side


class Strip(NamedTuple):
    """Over equal parts of x curves f = c0 + c1 t + c2 t², at the distance t from the middle.

    Below φ2 = (1 - u)(f - δ), above φ2 = (1 - u)(f + δ) + u top; the bands of u are rows of tiles.
    """

    phi: Phi
    delta: Fraction
    curve: Rows
    below: tuple[Fraction, ...]
    above: tuple[Fraction, ...]


#: A number, or x or y, or an operation on two terms.
Term = Any


class Family(NamedTuple):
    """Scenes whose numbers are terms of x and y in a rectangle; or of x in an interval."""

    r: Term
    positions: tuple[tuple[Term, ...], ...]
    velocities: tuple[tuple[Term, ...], ...]
    axes: tuple[str, ...]
    x: Side
    y: Side | None


Plane = Phi | Through | Strip | Family


def digits_of(plane: Plane) -> str:
    """The digits of a key: a box is cut into as many."""
    return "01" if isinstance(plane, Family) and plane.y is None else "0123"


def part(ends: Side, place: int, level: int) -> Interval:
    """One of 2^level equal parts of a side."""
    (p, m), (q, n) = (end.as_integer_ratio() for end in ends)
    first, step, under = p * n << level, q * m - p * n, m * n << level
    low, high = (first + step * i << PLACES for i in (place, place + 1))
    return low // under, -(-high // under)


def corner(key: str) -> tuple[int, int]:
    """The column and the row of a box: a digit of its key is x + 2y, a level each."""
    column = int("".join("01"[int(digit) & 1] for digit in key), 2)
    return column, int("".join("01"[int(digit) >> 1] for digit in key), 2)


def sides(plane: Phi | Through | Family, key: str) -> tuple[Interval, Interval]:
    """A box; in an interval of scenes y does not occur."""
    column, row = corner(key)
    x = part(plane.x, column, len(key))
    return x, (0, 0) if plane.y is None else part(plane.y, row, len(key))


def _on_box(kind: Arithmetic, plane: Phi | Through | Family, key: str) -> tuple[Number, Number]:
    """The two parameters."""
    x, y = sides(plane, key)
    return parameter(kind, 0, x), parameter(kind, 1, y)


class Tile(NamedTuple):
    """A tile of a strip: its part, whether it is above, and the ends of t and of u."""

    place: int
    above: bool
    t: Side
    u: Side


def tile(plane: Strip, key: str) -> Tile:
    """The tile with a key; the rows below the curve come first, the lowest one first."""
    (column, row), parts = corner(key), len(plane.curve)
    depth = len(key) - parts.bit_length() + 1
    count = len(plane.below) - 1
    place, band = column >> depth, row >> depth
    ends = plane.above[band - count :] if band >= count else plane.below[count - 1 - band :]
    rest, lift = column - (place << depth), row - (band << depth)
    half, share = (plane.phi.x[1] - plane.phi.x[0]) / parts / 2, Fraction(1, 1 << depth)
    t = (half * (2 * rest * share - 1), half * (2 * (rest + 1) * share - 1))
    width = (ends[1] - ends[0]) * share
    return Tile(place, band >= count, t, (ends[0] + width * lift, ends[0] + width * (lift + 1)))


def is_above(plane: Strip, key: str) -> bool:
    """Whether a tile is above the curve."""
    row, depth = corner(key)[1], len(key) - len(plane.curve).bit_length() + 1
    return row >> depth >= len(plane.below) - 1


def _on_tile(kind: Arithmetic, plane: Strip, key: str) -> tuple[Number, Number]:
    """φ1 and φ2."""
    found, phi = tile(plane, key), plane.phi
    t, u = (
        parameter(kind, i, (around(ends[0])[0], around(ends[1])[1]))
        for i, ends in enumerate((found.t, found.u))
    )
    half = (phi.x[1] - phi.x[0]) / len(plane.curve) / 2
    c_0, c_1, c_2 = (number(kind, c) for c in plane.curve[found.place])
    f = kind.add(c_0, kind.mul(t, kind.add(c_1, kind.mul(t, c_2))))
    delta = number(kind, plane.delta if found.above else -plane.delta)
    goal = number(kind, phi.y[1] if found.above else Fraction(0))
    rest = kind.mul(kind.sub(kind.one, u), kind.add(f, delta))
    middle = number(kind, phi.x[0] + half * (2 * found.place + 1))
    return kind.add(t, middle), kind.add(rest, kind.mul(u, goal))


def share_of(plane: Plane, key: str) -> Fraction:
    """The share of the area of the rectangle that a box has."""
    if not isinstance(plane, Strip):
        return Fraction(1, len(digits_of(plane)) ** len(key))
    found, phi = tile(plane, key), plane.phi
    c_0, c_1, c_2 = plane.curve[found.place]
    low, high = found.t
    area = sum(c * (high**i - low**i) / i for i, c in enumerate((c_0, c_1, c_2), 1)) - (
        high - low
    ) * (0 if found.above else plane.delta)
    if found.above:
        area = (phi.y[1] - plane.delta) * (high - low) - area
    whole = (phi.x[1] - phi.x[0]) * (phi.y[1] - phi.y[0])
    return Fraction(area * (found.u[1] - found.u[0]) / whole)


def parameter(kind: Arithmetic, place: int, x: Interval) -> Number:
    """A number that runs over an interval as one of the two parameters does over [-1, 1]."""
    if kind is INTERVALS:
        return x
    middle = (x[0] + x[1]) >> 1
    slope = [0] * 5
    slope[place] = max(x[1] - middle, middle - x[0])
    return (*x, middle, *slope, 0)


#: From the key of a box to all its scenes, or to what they are after their first collision.
#: None stands for scenes that have none.
Beginning = Callable[[str], list[Sight | None]]


def beginning(law: Laws, plane: Plane) -> Beginning:
    """How the boxes of a plane begin.

    It raises RefusedError if it is open which collision is the first one, or spheres may overlap.
    """
    kind = law.kind if isinstance(law, Law) else MODELS
    if isinstance(plane, Strip):
        on_tile = _at_contact(kind, plane.phi)
        return lambda key: [on_tile(*_on_tile(kind, plane, key))]
    if isinstance(plane, Phi):
        on_rectangle = _at_contact(kind, plane)
        return lambda key: [on_rectangle(*_on_box(kind, plane, key))]
    products = [_products(kind, plane, place) for place in PAIRS]

    def begin(key: str) -> list[Sight | None]:
        varied = _varied(kind, plane, *_on_box(kind, plane, key))
        may_end, states = first_after(on_box(law, key), *_scenes(kind, products, varied))
        return [*states, None] if may_end else [*states]

    return begin


def _at_contact(kind: Arithmetic, plane: Phi) -> Callable[[Number, Number], Sight]:
    """The scenes with given φ1 > 0 and φ2 > 0."""
    add, sub, mul, _, square = kind[:5]
    C, v, u_c, u_s = (number(kind, x) for x in (plane.neg_cos, plane.speed, *plane.tangential))
    sine = kind.root(number(kind, 1 - plane.neg_cos**2))
    vv, u_cs, across = square(v), mul(u_c, u_s), mul(sine, u_s)
    a, A, turn = sub(mul(C, v), mul(sine, u_c)), add(vv, square(u_c)), mul(u_s, v)

    def state(phi_1: Number, phi_2: Number) -> Sight:
        eta_s = mul(phi_1, v)
        D = add(kind.one, mul(phi_2, vv))
        turned = sub(mul(eta_s, v), u_cs)
        w = sub(mul(C, turned), mul(sine, add(turn, mul(u_c, eta_s))))
        b = mul(D, sub(across, mul(C, eta_s)))
        B = add(square(eta_s), square(u_s))
        eps = mul(phi_2, add(kind.one, D))
        # As -cos > 0, the spheres s and c are apart.
        return Sight(v, D, phi_1, eps, A, B, mul(D, C), a, b, w)

    return state


#: The pairs as o, c, with the sphere s.
PAIRS = ((0, 1, 2), (0, 2, 1), (1, 2, 0))
#: A coordinate of a vector between spheres: positions or velocities, from, to, which one.
Coordinate = tuple[str, int, int, int]
#: A number, and products to be added: at least one factor is a coordinate that varies.
Products = tuple[Number, list[tuple[Coordinate | Number, Coordinate | Number]]]


def varying(plane: Through | Family) -> list[tuple[Place, Term]]:
    """The coordinates that vary, as terms."""
    if isinstance(plane, Through):
        return [(plane.x_at, "x"), (plane.y_at, "y")]
    return [
        ((name, i, k), term)
        for name, rows in (("positions", plane.positions), ("velocities", plane.velocities))
        for i, row in enumerate(rows)
        for k, term in enumerate(row)
        if not isinstance(term, Fraction)
    ]


#: A polynomial of x and y: the coefficient of x^i y^j, by i and j.
Polynomial = dict[tuple[int, int], Fraction]
#: Polynomials with more coefficients, or with more than MAX_BITS bits in one, are not used.
MAX_COEFFICIENTS = 100


def polynomial(term: Term) -> Polynomial | None:
    """A term as a polynomial; None if it divides by x or y, or is long."""
    if isinstance(term, Fraction):
        return {(0, 0): term}
    if isinstance(term, str):
        return {(int(term == "x"), int(term == "y")): Fraction(1)}
    name, one, two = term
    a, b = polynomial(one), polynomial(two)
    if a is None or b is None:
        return None
    if name == "/":
        if {*b} != {(0, 0)} or b[0, 0] == 0:
            return None
        name, b = "*", {(0, 0): 1 / b[0, 0]}
    if name == "*":
        products = [((i + k, j + m), p * q) for (i, j), p in a.items() for (k, m), q in b.items()]
    else:
        products = [*a.items(), *((power, q if name == "+" else -q) for power, q in b.items())]
    found: Polynomial = {}
    for power, value in products:
        found[power] = found.get(power, Fraction(0)) + value
    parts = chain.from_iterable(value.as_integer_ratio() for value in found.values())
    is_short = max(map(int.bit_length, parts)) <= MAX_BITS
    return found if is_short and len(found) <= MAX_COEFFICIENTS else None


def on_a_line(plane: Plane) -> bool:
    """Whether all vectors between spheres are multiples of one vector, in every scene.

    Where a coordinate is no polynomial, this is only said if at most one, the same for all spheres,
    ever differs between them.
    """
    if not isinstance(plane, Through | Family):
        return False
    terms = dict(varying(plane))
    line: list[Fraction] = []
    for name, rows in (("positions", plane.positions), ("velocities", plane.velocities)):
        for i in (1, 2):
            vector = []
            for k in range(len(rows[0])):
                to, start = (terms.get((name, j, k), rows[j][k]) for j in (i, 0))
                found = polynomial(("-", to, start))
                if found is None:
                    return _along_an_axis(plane)
                vector.append(found)
            for power in {power for cell in vector for power in cell}:
                part = [cell.get(power, Fraction(0)) for cell in vector]
                line = line or ([] if not any(part) else part)
                if any(p * line[m] != q * line[k] for k, p in enumerate(part)
                       for m, q in enumerate(part) if line):  # fmt: skip
                    return False
    return True


def _along_an_axis(plane: Through | Family) -> bool:
    rows = (*plane.positions, *plane.velocities)
    moving = {k for (_, _, k), _ in varying(plane)}
    for one, two, three in (rows[:3], rows[3:]):
        moving |= {k for k, x in enumerate(one) if not x == two[k] == three[k]}
    return len(moving) <= 1


def value_of(kind: Arithmetic, term: Term, x: Number, y: Number) -> Number:
    """A term at the parameters.

    Raises:
        RefusedError: if a divisor may be 0, or a number is very long.
    """
    if isinstance(term, Fraction):
        return number(kind, term)
    if isinstance(term, str):
        return x if term == "x" else y
    name, one, two = term
    a = value_of(kind, one, x, y)
    if name == "*" and one == two:
        return kind.square(a)
    b = value_of(kind, two, x, y)
    if name == "/" and b[1] < 0:
        a, b = kind.neg(a), kind.neg(b)
    found = {"+": kind.add, "-": kind.sub, "*": kind.mul, "/": kind.div}[name](a, b)
    if max(map(int.bit_length, found)) > MAX_BITS:
        raise RefusedError("the numbers of a term are too large to go on")
    return found


def turns(plane: Plane, key: str) -> bool:
    """Whether the angular momentum L about the centre of mass is nowhere 0 on a box.

    A component of 3 L = (x_1 - x_0)∧(2 v_1 - v_2 - v_0) + (x_2 - x_0)∧(2 v_2 - v_1 - v_0) has one
    sign in all scenes; all masses are 1.
    """
    if not isinstance(plane, Through | Family):
        return False
    add, sub, mul = MODELS[:3]
    x, y = _on_box(MODELS, plane, key)
    at = dict(varying(plane))

    def rows(name: str, given: Sequence[Sequence[Term]]) -> list[list[Number]]:
        return [
            [value_of(MODELS, at.get((name, i, k), cell), x, y) for k, cell in enumerate(row)]
            for i, row in enumerate(given)
        ]

    places, (v_0, v_1, v_2) = (
        rows("positions", plane.positions),
        rows("velocities", plane.velocities),
    )
    arms = [[sub(a, b) for a, b in zip(place, places[0], strict=True)] for place in places[1:]]
    pushes = [
        [sub(sub(add(a, a), b), c) for a, b, c in zip(*three, strict=True)]
        for three in ((v_1, v_2, v_0), (v_2, v_1, v_0))
    ]
    for k in range(len(v_0)):
        for m in range(k):
            one, two = (
                sub(mul(arm[m], push[k]), mul(arm[k], push[m]))
                for arm, push in zip(arms, pushes, strict=True)
            )
            low, high = add(one, two)[:2]
            if low > 0 or high < 0:
                return True
    return False


def operations(term: Term) -> int:
    """How many operations a term has."""
    return 1 + operations(term[1]) + operations(term[2]) if isinstance(term, tuple) else 0


def price_of(plane: Plane) -> int:
    """What it costs to begin with a box: for many coordinates, and long terms, it is more.

    There are 30 inner products in n dimensions, and `turns` has 2 n (n - 1) products, which cost
    twice as much.
    """
    if not isinstance(plane, Through | Family):
        return BOX_PRICE
    n, found = len(plane.positions[0]), varying(plane)
    moving = len({(name, k) for (name, _, k), _ in found})
    products = max(15 * moving, 4 * n * (n - 1))
    r = operations(plane.r) + sum(operations(term) for _, term in found)
    return BOX_PRICE + r // 8 + products // 32


def _products(
    kind: Arithmetic, plane: Through | Family, place: tuple[int, int, int]
) -> list[Products]:
    """The inner products of the vectors from o; for |x_c|² and |x_s|² what they are above 1."""
    o, c, s = place
    x_c, W_c, x_s, W_s = (
        [(name, o, other, k) for k in range(len(plane.positions[0]))]
        for other in (c, s)
        for name in ("positions", "velocities")
    )
    pair = ((x_c, x_c), (x_c, W_c), (W_c, W_c))
    others = ((x_s, x_s), (x_s, W_s), (W_s, W_s), (x_s, x_c), (x_s, W_c), (x_c, W_s), (W_s, W_c))
    return [_dot(kind, plane, *two) for two in (*pair, *others)]


def _dot(
    kind: Arithmetic, plane: Through | Family, a: list[Coordinate], b: list[Coordinate]
) -> Products:
    """What does not vary is added up exactly: so spheres can be in contact."""
    exact, rest = Fraction(-1 if a == b and a[0][0] == "positions" else 0), []
    varied = {place for place, _ in varying(plane)}
    for one, two in zip(a, b, strict=True):
        p, q = _fixed(plane, varied, one), _fixed(plane, varied, two)
        if p is not None and q is not None:
            exact += p * q
        else:
            factors = ((one, p), (two, q))
            first, second = (x if c is None else number(kind, c) for x, c in factors)
            rest.append((first, second))
    return number(kind, exact), rest


def _fixed(plane: Through | Family, varied: set[Place], x: Coordinate) -> Fraction | None:
    """The value of a coordinate, unless it varies."""
    name, i, j, k = x
    if {(name, i, k), (name, j, k)} & varied:
        return None
    rows = plane.positions if name == "positions" else plane.velocities
    difference: Fraction = rows[j][k] - rows[i][k]
    return difference


def _varied(
    kind: Arithmetic, plane: Through | Family, x: Number, y: Number
) -> dict[Coordinate, Number]:
    """The coordinates that vary."""
    at, found = {place: value_of(kind, term, x, y) for place, term in varying(plane)}, {}
    for name, i, k in at:
        rows = plane.positions if name == "positions" else plane.velocities
        for j in {0, 1, 2} - {i}:
            here, there = at[name, i, k], at.get((name, j, k)) or number(kind, rows[j][k])
            found[name, i, j, k] = kind.sub(there, here)
            found[name, j, i, k] = kind.sub(here, there)
    return found


def _scenes(
    kind: Arithmetic, products: list[list[Products]], varied: Mapping[Coordinate, Number]
) -> tuple[list[Three], Callable[[int], tuple[Sight, Number]]]:
    """The three pairs, and the scene seen with each of them as o, c."""

    def total(sum_: Products) -> Number:
        found, rest = sum_
        for a, b in rest:
            one, two = varied.get(a, a), varied.get(b, b)
            found = kind.add(found, kind.square(one) if a == b else kind.mul(one, two))
        return found

    pairs = [Three(*map(total, found[:3])) for found in products]

    def sight(place: int) -> tuple[Sight, Number]:
        eps, p, A = pairs[place]
        sig, rho, B, C, a, b, w = map(total, products[place][3:])
        return Sight(kind.one, kind.neg(p), rho, eps, A, B, kind.neg(C), a, b, w), sig

    return pairs, sight


def prove(
    law: Law,
    states: Sequence[Sight | None],
    verdict: str,
    numbers: list[tuple[Interval, ...]],
    work: Work,
    closing: Callable[[Law, Sight], bool] = lambda _, __: False,
) -> None:
    """Show a verdict for all branches of a box; None is one that ends.

    A branch that collapses has six numbers; or nothing is left to show where it is closing.

    Raises:
        RefusedError: if that fails.
    """
    waiting, steps = [*states], 0
    while waiting:
        state, steps = waiting.pop(), steps + 1
        if steps > MAX_STEPS:
            raise RefusedError(f"there is no end after {MAX_STEPS} steps")
        if state is None:
            if verdict == "c":
                raise RefusedError("it may be that no two spheres meet any more")
            continue
        if any(x[0] > x[1] for x in state):
            continue  # no state of the box is in this branch
        bits = max(map(int.bit_length, chain.from_iterable(state)))
        if bits > MAX_BITS:
            raise RefusedError("the numbers of a state are too large to go on")
        steps += len(numbers)
        work.spend(law.kind.price * (1 + len(numbers)) * (1 + (bits >> 8)))
        if any(closes(law, state, six) for six in numbers):
            continue
        if closing(law, state):
            continue
        may_end, more = after(law, state)
        waiting += [None, *more] if may_end else more


# --- the log -------------------------------------------------------------------------------------

FORMAT = "verify-map-log/1"
HEADER = ("format", "plane", "first_level", "code", "sha256")
RECORD = ("level", "keys", "verdicts", "numbers", "sha256")
PHI = ("name", "r", "neg_cos", "speed", "tangential", "x", "y")
STRIP = (*PHI, "delta", "curve", "below", "above")
THROUGH = ("name", "r", "positions", "velocities", "x_at", "y_at", "x", "y")
SEGMENT = ("name", "r", "positions", "velocities", "axes", "x")
FAMILY = (*SEGMENT, "y")


class Run(NamedTuple):
    """An interval of a parameter in which all scenes have one verdict."""

    letter: str
    low: Fraction
    high: Fraction


class Areas(NamedTuple):
    """How many boxes the log has, how many have a verdict, and the share of each verdict.

    `is_strip`: all tiles below the curve collapse, and all above it disperse. `runs` are those of
    an interval of scenes, in order; what is between them is undecided. `is_outside`: of some
    boxes the theorem `outside` shows that they disperse.
    """

    boxes: int
    proved: int
    collapses: Fraction
    disperses: Fraction
    is_strip: bool = False
    finite: Fraction = Fraction(0)
    runs: tuple[Run, ...] = ()
    is_outside: bool = False

    @property
    def undecided(self) -> Fraction:
        """The share without a verdict."""
        return 1 - self.collapses - self.disperses - self.finite


def check_log(lines: Iterator[bytes], most: int | None = MAX_WORK) -> tuple[Plane, Areas]:
    """Prove every verdict of a log, with so much work, and that its boxes cover the rectangle once.

    Raises:
        LogError: if it is malformed.
        RefusedError: if a verdict is not proved.
    """
    chain, header = _line(next(lines, b""), "", HEADER)
    if header["format"] != FORMAT:
        raise LogError(f"expected the format {FORMAT}")
    if type(header["code"]) is not int or not 0 <= header["code"] < 1 << 31:
        raise LogError("expected a whole number for the code")
    plane, level = plane_of(header["plane"]), header["first_level"]
    if type(level) is not int or not 1 <= level <= MAX_FIRST:
        raise LogError(f"expected a first level from 1 to {MAX_FIRST}")
    if isinstance(plane, Strip) and 1 << level != len(plane.curve):
        raise LogError("expected a first box for each part of the curve")
    tally, rules, law = Tally(plane), rules_of(plane), law_in(plane)
    begin, work, digits = beginning(law, plane), Work(most), digits_of(plane)
    least = 0 if rules.is_line else 6
    due, children = [_key(i, level, digits) for i in range(len(digits) ** level)], list[str]()
    at = 0
    for line in lines:
        chain, record = _line(line, chain, RECORD)
        if at == len(due):
            level, due, children, at = level + 1, children, [], 0
        keys, letters, numbers = _boxes(record, level)
        if not keys or keys != due[at : at + len(keys)]:
            raise LogError("boxes are not those that the boxes before have left, in their order")
        at += len(keys)
        tally.boxes += len(keys)
        given = iter(numbers)
        for key, letter in zip(keys, letters, strict=True):
            if letter == "u":
                children += [key + digit for digit in digits]
                continue
            found = sixes(next(given), "c", least) if letter == "c" else []
            prove_box(law, begin, key, letter, found, work, rules)
            tally.add(key, letter)
    return plane, tally.areas(is_whole=at == len(due) and not children)


class Tally:
    """What is proved so far."""

    def __init__(self, plane: Plane) -> None:
        self.plane, self.boxes, self.proved = plane, 0, 0
        self.shares = {"c": Fraction(0), "d": Fraction(0), "f": Fraction(0)}
        self.is_strip = isinstance(plane, Strip)
        self.parts: list[tuple[str, str]] = []
        self.is_outside = False

    def add(self, key: str, letter: str) -> None:
        """A box with its verdict."""
        plane = self.plane
        self.proved += 1
        if letter == "o":
            letter, self.is_outside = "d", True
        self.shares[letter] = _and_share(self.shares[letter], plane, key)
        if isinstance(plane, Strip):
            self.is_strip = self.is_strip and letter == "cd"[is_above(plane, key)]
        if isinstance(plane, Family) and plane.y is None:
            self.parts.append((key, letter))

    def areas(self, *, is_whole: bool) -> Areas:
        """The areas; the log is whole if it leaves no box to be decided."""
        c, d, f = (self.shares[letter] for letter in "cdf")
        runs = tuple(_runs(self.plane, self.parts))
        return Areas(
            self.boxes, self.proved, c, d, self.is_strip and is_whole, f, runs, self.is_outside
        )


def _runs(plane: Plane, parts: list[tuple[str, str]]) -> Iterator[Run]:
    """Neighbours with the same verdict, in one."""
    run: Run | None = None
    if not isinstance(plane, Family):
        return
    low, width = plane.x[0], plane.x[1] - plane.x[0]
    for key, letter in sorted(parts):
        share = Fraction(1, 2 ** len(key))
        first = low + width * int(key, 2) * share
        if run is not None and run[::2] == (letter, first):
            run = run._replace(high=first + width * share)
            continue
        if run is not None:
            yield run
        run = Run(letter, first, first + width * share)
    if run is not None:
        yield run


def _and_share(share: Fraction, plane: Plane, key: str) -> Fraction:
    found = share + share_of(plane, key)
    if found.denominator.bit_length() > MAX_AREA:
        raise LogError("expected a plane whose areas are shorter fractions")
    return found


class Rules(NamedTuple):
    """What it costs to begin with a box, whether all spheres are on a line, and where they turn."""

    price: int = BOX_PRICE
    is_line: bool = False
    turns: Callable[[str], bool] = lambda _: False


def rules_of(plane: Plane) -> Rules:
    """The rules for the boxes of a plane."""
    return Rules(price_of(plane), on_a_line(plane), partial(turns, plane))


def law_in(plane: Plane) -> Laws:
    """The law, in the kind of numbers that a plane is decided in."""
    if isinstance(plane, Strip):
        return law_of(plane.phi.r, MODELS)
    if isinstance(plane, Family) and not isinstance(plane.r, Fraction):
        return lambda key: law_around(value_of(MODELS, plane.r, *_on_box(MODELS, plane, key)))
    return law_of(plane.r, INTERVALS if isinstance(plane, Phi) else MODELS)


def prove_box(
    law: Laws,
    begin: Beginning,
    key: str,
    letter: str,
    numbers: list[tuple[Interval, ...]],
    work: Work | None = None,
    rules: Rules | None = None,
) -> None:
    """Show the verdict on a box.

    Raises:
        RefusedError: if that fails.
    """
    work, rules = work or Work(), rules or Rules()
    try:
        here = on_box(law, key)
        work.spend(rules.price * here.kind.price)
        if letter == "f":
            check_finite(here, partial(rules.turns, key))
        elif letter == "o":
            prove(here, begin(key), "d", [], work, parting(work))
        elif letter == "c" and rules.is_line and not numbers:
            prove(here, begin(key), letter, numbers, work, closes_on_a_line)
        else:
            prove(here, begin(key), letter, numbers, work)
    except RefusedError as error:
        raise RefusedError(f"box {key}, {letter}: {error}") from None


def _key(place: int, level: int, digits: str = "0123") -> str:
    size = len(digits)
    return "".join(digits[place // size**i % size] for i in reversed(range(level)))


def _line(line: bytes, chain: str, names: tuple[str, ...]) -> tuple[str, dict[str, Any]]:
    """One line of the log, and the digest of it and of all before it."""
    if len(line) > MAX_LINE:
        raise LogError(f"a line has more than {MAX_LINE} bytes")
    body, found, digest = line.rpartition(b',"sha256":"')
    try:
        content = json.loads(
            line.decode("ascii"),
            parse_int=_whole,
            parse_float=_no_float,
            parse_constant=_no_float,
            object_pairs_hook=_object,
        )
    except LogError:
        raise
    except (ValueError, RecursionError) as error:
        raise LogError(f"a line is no JSON ({error})") from None
    if not isinstance(content, dict) or tuple(content) != names or not found:
        raise LogError(f"expected a line with {', '.join(names)}")
    chain = sha256(chain.encode() + body).hexdigest()
    if digest != chain.encode() + b'"}\n':
        raise LogError("a digest is not that of the lines up to it")
    return chain, content


def _whole(text: str) -> int:
    if len(text) > MAX_DIGITS:
        raise LogError(f"expected whole numbers of at most {MAX_DIGITS} digits")
    return int(text)


def _no_float(_: str) -> None:
    raise LogError("expected whole numbers")


def _object(pairs: list[tuple[str, Any]]) -> dict[str, Any]:
    found = dict(pairs)
    if len(found) < len(pairs):
        raise LogError("expected no key twice")
    return found


def _boxes(record: dict[str, Any], level: int) -> tuple[list[str], str, list[object]]:
    keys, letters, numbers = record["keys"], record["verdicts"], record["numbers"]
    if type(record["level"]) is not int or record["level"] != level or level > MAX_LEVEL:
        raise LogError(f"expected boxes of level {level}")
    if not isinstance(keys, str) or not re.fullmatch("[0-3 ]*", keys):
        raise LogError("expected keys")
    found = keys.split(" ")
    if not isinstance(letters, str) or not re.fullmatch("[cdfou]*", letters):
        raise LogError("expected verdicts c, d, f, o, u")
    if len(found) != len(letters) or not isinstance(numbers, list):
        raise LogError("expected a verdict for each key")
    if len(numbers) != letters.count("c"):
        raise LogError("expected numbers for each box that collapses")
    return found, letters, numbers  # which `sixes` reads one by one: there may be very many


def sixes(flat: object, letter: str, least: int = 6) -> list[tuple[Interval, ...]]:
    """Read the numbers of a box: six for each branch that collapses, and so many at least.

    Raises:
        LogError: if they are no such numbers.
    """
    if (letter != "c" and not flat) or (least == 0 and flat == []):
        return []
    if not isinstance(flat, list) or not 0 < len(flat) <= 6 * MAX_SIXES or len(flat) % 6:
        raise LogError("expected six numbers for each branch of a box that collapses")
    if not all(type(n) is int and 0 <= n < 1 << 2 * GRID for n in flat):
        raise LogError("expected whole numbers")
    scaled = [(n << PLACES - GRID,) * 2 for n in flat]
    return [tuple(scaled[i : i + 6]) for i in range(0, len(scaled), 6)]


def plane_of(found: object) -> Plane:
    """Read a plane.

    Raises:
        LogError: if it is none.
    """
    if isinstance(found, dict) and tuple(found) == PHI and found["name"] == "phi":
        return _phi(found)
    if isinstance(found, dict) and tuple(found) == THROUGH and found["name"] == "scene":
        return _through(found)
    if isinstance(found, dict) and tuple(found) == STRIP and found["name"] == "strip":
        return _strip(found)
    if isinstance(found, dict) and tuple(found) in (FAMILY, SEGMENT) and found["name"] == "family":
        return _family(found)
    expected = (("phi", PHI), ("scene", THROUGH), ("strip", STRIP), ("family", FAMILY))
    words = (f"{name} with {', '.join(names)}" for name, names in expected)
    raise LogError(f"expected a plane: {'; or '.join(words)}")


def _phi(found: dict[str, Any]) -> Phi:
    r, neg_cos, speed = (_rational(found[name]) for name in PHI[1:4])
    u, x, y = (_two(found[name]) for name in PHI[4:])
    if not (0 < r < 1 and 0 < neg_cos <= 1 and speed > 0):
        raise LogError("expected 0 < r < 1, 0 < -cos <= 1 and a positive speed")
    if not (0 <= x[0] < x[1] and 0 <= y[0] < y[1]):
        raise LogError("expected a rectangle of numbers that are not negative")
    return Phi(r, neg_cos, speed, u, x, y)


def _strip(found: dict[str, Any]) -> Strip:
    phi, delta = _phi(found), _rational(found["delta"])
    curve = found["curve"]
    if not isinstance(curve, list) or len(curve) > 1 << MAX_FIRST:
        raise LogError(f"expected a curve of at most {1 << MAX_FIRST} parts")
    coefficients = tuple(_row(part) for part in curve)
    bands = _row(found["below"]), _row(found["above"])
    if {*map(len, coefficients)} != {3} or sum(map(len, bands)) - 2 != len(curve):
        raise LogError("expected three coefficients for each part, and as many bands as parts")
    for ends in bands:
        if len(ends) < 2 or ends[0] != 0 or ends[-1] != 1 or [*ends] != sorted({*ends}):
            raise LogError("expected bands from 0 to 1")
    half = (phi.x[1] - phi.x[0]) / len(curve) / 2
    for c_0, c_1, c_2 in coefficients:
        spread = abs(c_1) * half + abs(c_2) * half**2 + delta
        if not (0 < delta <= spread < c_0 < phi.y[1] - spread and phi.y[0] == 0):
            raise LogError("expected a curve between 0 and the top")
    return Strip(phi, delta, coefficients, *bands)


def _through(found: dict[str, Any]) -> Through:
    r, x, y = _rational(found["r"]), _two(found["x"]), _two(found["y"])
    positions, velocities = _rows_of(found["positions"]), _rows_of(found["velocities"])
    size = len(positions[0])
    if not 0 < r < 1 or not 2 <= size <= 20 or {*map(len, positions + velocities)} != {size}:
        raise LogError("expected 0 < r < 1, and vectors of one length from 2 to 20")
    places = []
    for name in ("x_at", "y_at"):
        text = found[name] if isinstance(found[name], str) else ""
        match = re.fullmatch(r"(positions|velocities)\[([0-2])\]\[([0-9]{1,2})\]", text)
        if not match or int(match[3]) >= size:
            raise LogError("expected the places of two numbers, like velocities[2][0]")
        places.append((match[1], int(match[2]), int(match[3])))
    if places[0] == places[1] or not (x[0] < x[1] and y[0] < y[1]):
        raise LogError("expected two places, and a rectangle")
    return Through(r, positions, velocities, places[0], places[1], x, y)


def _family(found: dict[str, Any]) -> Family:
    axes, count = found["axes"], 2 if "y" in found else 1
    x, y = _two(found["x"]), _two(found["y"]) if "y" in found else None
    if not isinstance(axes, list) or not all(isinstance(name, str) for name in axes):
        raise LogError("expected the names of the axes")
    if len({*axes}) != count or len(axes) != count:
        raise LogError("expected a name for each axis")
    if not all(re.fullmatch(r"[A-Za-z][A-Za-z0-9_]{0,30}(\[[0-9]{1,2}\]){0,2}", a) for a in axes):
        raise LogError("expected names of axes, like vy")
    if not x[0] < x[1] or (y is not None and not y[0] < y[1]):
        raise LogError("expected an interval for each axis")
    letters = "xy"[:count]
    r = _term(found["r"], letters)
    positions, velocities = (
        tuple(tuple(_term(cell, letters) for cell in _list(row)) for row in _list(found[name]))
        for name in ("positions", "velocities")
    )
    size = len(positions[0]) if positions else 0
    if (len(positions), len(velocities)) != (3, 3) or not 1 <= size <= 20:
        raise LogError("expected three vectors of 1 to 20 numbers")
    if {*map(len, positions + velocities)} != {size}:
        raise LogError("expected vectors of one length")
    if isinstance(r, Fraction) and not 0 < r < 1:
        raise LogError("expected 0 < r < 1")
    plane = Family(r, positions, velocities, tuple(axes), x, y)
    if operations(r) + sum(operations(term) for _, term in varying(plane)) > MAX_OPERATIONS:
        raise LogError(f"expected at most {MAX_OPERATIONS} operations in all terms")
    return plane


def _term(found: object, letters: str, depth: int = 0) -> Term:
    if isinstance(found, str):
        return found if len(found) == 1 and found in letters else _rational(found)
    if not isinstance(found, list) or len(found) != 3 or depth > MAX_DEPTH:
        raise LogError("expected a term: p/q, or x, or y, or an operation on two terms, not deep")
    name, one, two = found
    if name not in ("+", "-", "*", "/"):
        raise LogError("expected one of the operations + - * /")
    return name, _term(one, letters, depth + 1), _term(two, letters, depth + 1)


def _list(found: object) -> list[Any]:
    if not isinstance(found, list):
        raise LogError("expected a list")
    return found


def _rows_of(found: object) -> Rows:
    if not isinstance(found, list) or len(found) != 3:
        raise LogError("expected three vectors")
    return tuple(map(_row, found))


def _row(found: object) -> tuple[Fraction, ...]:
    if not isinstance(found, list):
        raise LogError("expected a list of numbers")
    return tuple(map(_rational, found))


def _two(found: object) -> tuple[Fraction, Fraction]:
    row = _row(found)
    if len(row) != 2:
        raise LogError("expected two numbers")
    return row[0], row[1]


def _rational(text: object) -> Fraction:
    pattern = f"-?[0-9]{{1,{MAX_DIGITS}}}(/[0-9]{{1,{MAX_DIGITS}}})?"
    if not isinstance(text, str) or not re.fullmatch(pattern, text):
        raise LogError("expected an exact number p/q")
    try:
        return Fraction(text)
    except ZeroDivisionError:
        raise LogError("expected q > 0") from None


# --- what is said --------------------------------------------------------------------------------


#: The verdicts of boxes in words.
VERDICTS = {"c": "collapses", "d": "disperses", "f": "finitely many collisions"}


def says(plane: Plane, areas: Areas) -> str:
    """What was proved, with all that it was proved for."""
    shares = ", ".join(
        f"{name} {share} (about {float(100 * share):.4f} %)"
        for name, share in (
            ("collapses", areas.collapses),
            ("disperses", areas.disperses),
            ("finitely many collisions", areas.finite),
            ("undecided", areas.undecided),
        )
        if share or name != "finitely many collisions"
    )
    told = f"{areas.boxes} boxes, {areas.proved} of them proved"
    if isinstance(plane, Strip) and areas.is_strip:
        told = (
            "every such state with 0 < φ2 <= f - δ collapses and every one with "
            f"f + δ <= φ2 <= {plane.phi.y[1]} disperses; {areas.proved} tiles"
        )
    if isinstance(plane, Family) and plane.y is None:
        runs = "".join(f"; {VERDICTS[run.letter]} in [{run.low}, {run.high}]" for run in areas.runs)
        return f"{hypotheses(plane)}: {told}{runs}; of the interval: {shares}"
    return f"{hypotheses(plane)}: {told}; of the area: {shares}"


def given(plane: Plane, areas: Areas) -> str:
    """The theorems that are taken on trust, and which scenes are excluded."""
    names = [f"certificates/{name}" for name in cites(plane, areas)]
    theorems = f"{', '.join(names[:-1])} and {names[-1]}"
    limits = "scenes with an overlap or a triple contact at the start are excluded"
    if areas.finite:
        possible = "only finitely many collisions are possible"
        limits += f"; {possible}, unless three touch at once or two graze"
    return f"given the theorems of {theorems}; {limits}"


def cites(plane: Plane, areas: Areas) -> tuple[str, ...]:
    """The theorems that are taken on trust."""
    line, outside = (LINE,) if on_a_line(plane) else (), (OUTSIDE,) if areas.is_outside else ()
    return (*GIVEN, *line, *outside, *((CLASSIFICATION,) if areas.finite else ()))


def term_text(term: Term, axes: Sequence[str]) -> str:
    """A term for a reader."""
    if not isinstance(term, tuple):
        return axes["xy".index(term)] if isinstance(term, str) else str(term)
    name, one, two = term
    divisor = term_text(two, axes)
    if name == "/" and "/" in divisor and not isinstance(two, tuple):
        divisor = f"({divisor})"
    return f"({term_text(one, axes)} {name} {divisor})"


def hypotheses(plane: Plane) -> str:
    """All that a plane fixes, and what varies in it."""
    if isinstance(plane, Strip):
        numbers = ";".join(
            ",".join(map(str, row)) for row in (*plane.curve, plane.below, plane.above)
        )
        digest = sha256(numbers.encode()).hexdigest()
        return (
            f"{hypotheses(plane.phi)}, δ = {plane.delta}, f the curve of the log over "
            f"{len(plane.curve)} equal parts of φ1 (SHA-256 of its numbers and bands: {digest})"
        )
    if isinstance(plane, Family):
        return _of_family(plane)
    x, y = (f"[{low}, {high}]" for low, high in (plane.x, plane.y))
    if isinstance(plane, Phi):
        u_c, u_s = plane.tangential
        return (
            f"r = {plane.r}, -cos θ = {plane.neg_cos}, -eta_c = {plane.speed}, tangential speeds "
            f"u_c = {u_c} and u_s = {u_s}, φ1 = eta_s/(-eta_c) in {x}, φ2 = d/eta_c² in {y}"
        )
    rows = {
        name: [[str(number) for number in row] for row in found]
        for name, found in (("positions", plane.positions), ("velocities", plane.velocities))
    }
    for letter, (name, i, k) in (("x", plane.x_at), ("y", plane.y_at)):
        rows[name][i][k] = letter
    places = ", ".join(
        f"{name} {' '.join('(' + ', '.join(row) + ')' for row in found)}"
        for name, found in rows.items()
    )
    return f"spheres of diameter 1 with r = {plane.r}, {places}, x in {x}, y in {y}"


def _of_family(plane: Family) -> str:
    def vectors(rows: Sequence[Sequence[Term]]) -> str:
        found = (", ".join(term_text(cell, plane.axes) for cell in row) for row in rows)
        return " ".join(f"({row})" for row in found)

    sides = (plane.x,) if plane.y is None else (plane.x, plane.y)
    axes = (f"{name} in [{a}, {b}]" for name, (a, b) in zip(plane.axes, sides, strict=True))
    r = term_text(plane.r, plane.axes)
    return (
        f"spheres of diameter 1{'' if r == 'r' else f' with r = {r}'}, "
        f"positions {vectors(plane.positions)}, velocities {vectors(plane.velocities)}, "
        f"{', '.join(axes)}"
    )


def main(arguments: list[str]) -> int:
    """Check logs, say what they prove, and return the exit code."""
    paths = [path for path in arguments if path != "--long"]
    most = MAX_WORK if len(paths) == len(arguments) else None
    lines, worst = [], 0
    try:
        if not paths:
            raise OSError("found no log; write: check_map.py [--long] LOG")
        for path in paths:  # nobody waits for a pipe
            if not os.path.isfile(path):
                raise OSError(f"found {path!r}, which is no file; name a log")
        for path in paths:
            code, line = answer(path, most)
            worst = max(worst, code)
            lines.append(line if line.isprintable() else ascii(line))
    except (OSError, ValueError) as error:
        return complaint(str(error), 2)
    except KeyboardInterrupt:
        return complaint("interrupted", 130)
    return output(lines, worst)


def answer(path: str, most: int | None) -> tuple[int, str]:
    """The exit code for a log, and a line about it.

    Raises:
        OSError: if it cannot be read.
    """
    try:
        with open(path, "rb") as file:
            lines = iter(lambda: file.readline(MAX_LINE + 1), b"")
            plane, areas = check_log(lines, most)
            return 0, f"PROVED {path}: {says(plane, areas)}; {given(plane, areas)}"
    except RefusedError as error:
        return 1, f"REFUSED {path}: {error}"
    except LogError as error:
        return 4, f"MALFORMED {path}: {error}"


def complaint(words: str, code: int) -> int:
    """Say why there is no report, if anybody listens, and return the exit code."""
    try:
        if sys.stderr is not None:
            line = f"check_map: {words}"
            print(line if line.isprintable() else ascii(line), file=sys.stderr, flush=True)
    except OSError:
        os.dup2(os.open(os.devnull, os.O_WRONLY), sys.stderr.fileno())
    return code


def unexpected(kind: type[BaseException], *_: object) -> None:
    """End with code 5 where nobody has caught an error: Python ends with 1, which means refused."""
    os.write(2, b"check_map: no verdict, as this program failed: %s\n" % kind.__name__.encode())
    os._exit(5)


def output(lines: list[str], code: int) -> int:
    """Print the lines, and return the exit code; 141 if their reader has left, 2 if they cannot."""
    try:
        if sys.stdout is None:
            raise OSError("stdout is closed")
        encoding = sys.stdout.encoding or "ascii"
        print("\n".join(lines).encode(encoding, "backslashreplace").decode(encoding), flush=True)
    except OSError as error:
        if sys.stdout is not None:
            os.dup2(os.open(os.devnull, os.O_WRONLY), sys.stdout.fileno())
        if isinstance(error, BrokenPipeError):
            return 141
        return complaint(f"the report cannot be written ({error})", 2)
    return code


if __name__ == "__main__":
    sys.excepthook = unexpected
    sys.exit(main(sys.argv[1:]))
