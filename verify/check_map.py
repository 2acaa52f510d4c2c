#!/usr/bin/env python3
"""Check the log of a map.

    python3 -I verify/check_map.py LOG [LOG ...]

A map is a rectangle of scenes, each with three spheres, cut into boxes. The log says of a box that
all its scenes collapse, or that in all of them no two spheres meet any more after finitely many
collisions, or nothing. This program reads the log, proves every verdict anew, and counts areas.

It needs Python 3.11 and nothing else, calculates with whole numbers only, and searches nothing:
which collision is the next one is derived anew; that a collapse follows is shown by the six numbers
that the log has for it. What it takes on trust, besides itself and Python:

* the law of collision in inner products, and that three inequalities show a pair to be apart until
  the next collision: the theorem of `certificates/flow`;
* that the inequalities of `closes` imply a collapse: the theorem of `certificates/sharper`.

A scene in which two spheres just graze has the verdict that it gets whether this counts as a
collision or not. Scenes in which all three touch at once, or overlap, at the start are not meant.

The exit code is 0 if all is proved, 1 if a verdict is not, 4 if the log is malformed.
"""

from __future__ import annotations

import json
import re
import sys
from collections.abc import Iterator
from fractions import Fraction
from hashlib import sha256
from math import isqrt
from typing import Any, NamedTuple

#: Numbers are counted in units of 2^-PLACES; the six numbers of a collapse in units of 2^-30.
PLACES, GRID = 96, 30
ONE = 1 << PLACES
#: How far a box is followed, in all its branches together: so checking ends.
MAX_STEPS = 2000
MAX_LEVEL, MAX_DIGITS = 40, 40

#: Two whole numbers of units with a number between them, ends included.
Interval = tuple[int, int]


class LogError(ValueError):
    """The log is malformed."""


class RefusedError(ValueError):
    """A verdict is not proved."""


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
    if c <= 0:
        raise RefusedError("a divisor may be 0")
    return (a << PLACES) // (d if a >= 0 else c), -((-b << PLACES) // (c if b >= 0 else d))


def root(x: Interval) -> Interval:
    """The root.

    Raises:
        RefusedError: if the number may be negative.
    """
    if x[0] < 0:
        raise RefusedError("a radicand may be negative")
    return isqrt(x[0] << PLACES), isqrt(x[1] << PLACES) + 1


UNIT: Interval = (ONE, ONE)

# --- states and their collisions -----------------------------------------------------------------


class Sight(NamedTuple):
    """Spheres s and c seen from o; s is in contact with o and does not approach it.

    Centres x_s, x_c and velocities W_s, W_c, with a unit v > 0 of speed: x_c·W_c = -lam v,
    |x_c|² = 1 + eps v², x_s·W_s = rho v with rho >= 0, A = |W_c|², B = |W_s|², C = -x_s·x_c,
    a = x_s·W_c, b = x_c·W_s, w = W_s·W_c.
    """

    v: Interval
    lam: Interval
    rho: Interval
    eps: Interval
    A: Interval
    B: Interval
    C: Interval
    a: Interval
    b: Interval
    w: Interval


class Three(NamedTuple):
    """Two spheres: g = |x|² - 1, p = x·w and m = |w|²."""

    g: Interval
    p: Interval
    m: Interval


def own(z: Sight) -> Three:
    """The pair o, c."""
    low, high = mul(z.lam, z.v)
    return Three(mul(z.eps, square(z.v)), (-high, -low), z.A)


def far(z: Sight) -> Three:
    """The pair s, c."""
    g = add(add(UNIT, mul(z.eps, square(z.v))), add(z.C, z.C))
    p = sub(mul(sub(z.rho, z.lam), z.v), add(z.a, z.b))
    return Three(g, p, sub(add(z.A, z.B), add(z.w, z.w)))


def from_s(z: Sight, pair: Three) -> Sight:
    """The same moment seen from s, which now has o for the spectator."""
    g, p, m = pair
    rho = mul(z.rho, z.v)
    C = (-z.C[1] - ONE, -z.C[0] - ONE)
    return Sight(
        UNIT, (-p[1], -p[0]), rho, g, m, z.B, C, sub(rho, z.a), sub(rho, z.b), sub(z.B, z.w)
    )


def looks(lam: Interval, A: Interval, eps: Interval) -> int:
    """-1 if a pair never meets in free flight, 1 if it always does, 0 if that is open."""
    low, high = sub(square(lam), mul(A, eps))
    if lam[1] <= 0 or high < 0:
        return -1
    return 1 if lam[0] > 0 and low > 0 else 0


class Way(NamedTuple):
    """The flight until o and c meet: y, q, s, T of the theorem; the time is y T."""

    y: Interval
    q: Interval
    s: Interval
    T: Interval


def way_of(z: Sight) -> Way | None:
    """The flight of those states from which o and c meet: lam² >= A eps and 0 <= s <= 1.

    None if it may take for ever.
    """
    least = isqrt(max(z.A[0], 0) * max(z.eps[0], 0))
    lam = (min(max(z.lam[0], least), z.lam[1]), z.lam[1])
    if lam[0] <= 0:
        return None
    kap = div(div(z.eps, lam), lam)
    low, high = sub(UNIT, mul(z.A, kap))
    s = root((max(low, 0), max(min(high, ONE), 0)))
    return Way(mul(lam, z.v), div(z.rho, lam), s, div(kap, add(UNIT, s)))


def is_apart(pair: Three, way: Way) -> bool:
    """Whether a pair is shown to be apart until o and c have met: Bernstein's coefficients."""
    g, p, m = pair
    time = mul(way.y, way.T)
    step = mul(p, time)
    last = add(g, mul(time, add(add(p, p), mul(m, time))))
    return g[0] >= 0 and g[0] + step[0] >= 0 and last[0] > 0


def collide(law: Law, z: Sight, way: Way) -> Sight:
    """The state just after o and c have collided; now c is the spectator."""
    y, q, s, T = way
    speed, time = mul(y, s), mul(y, T)
    turned, TB = mul(time, z.w), mul(T, z.B)
    push, f = mul(law.half, speed), add(z.b, turned)
    C = sub(z.C, mul(time, add(z.a, f)))
    lam = sub(sub(mul(mul(law.half, s), C), q), TB)
    double, other = add(f, f), mul(law.r, speed)
    A = add(z.B, mul(push, add(double, push)))
    B = sub(z.A, mul(law.lost, square(speed)))
    pushed = mul(push, C)
    a, b = add(f, push), sub(add(z.a, turned), add(pushed, pushed))
    w = add(z.w, mul(push, add(double, other)))
    eps = mul(T, add(add(q, q), TB))
    return Sight(y, lam, mul(law.r, s), eps, A, B, C, a, b, w)


class Law(NamedTuple):
    """r, (1+r)/2 and 1 - r²."""

    r: Interval
    half: Interval
    lost: Interval


def law_of(r: Fraction) -> Law:
    """The coefficients of the law of collision."""
    return Law(around(r), around((1 + r) / 2), around(1 - r * r))


def after(law: Law, z: Sight) -> tuple[bool, list[Sight]]:
    """Whether some states have no further collision, and the states after that of the others.

    Where it is open whether a pair meets, states are followed in both branches.

    Raises:
        RefusedError: if it is open which collision is the next one.
    """
    if z.rho[0] <= 0 and z.B[0] <= 0:
        raise RefusedError("the spectator may stay in contact")
    pair = far(z)
    near, away = looks(z.lam, z.A, z.eps), looks((-pair.p[1], -pair.p[0]), pair.m, pair.g)
    if near < 0 and away < 0:
        return True, []
    may_end = near < 1 and away < 1
    way = way_of(z) if near >= 0 else None
    if way is not None and (away < 0 or is_apart(pair, way)):
        # Where both meet, o and c are first; s and c meet only where o and c do not.
        first, other = collide(law, z, way), None if near > 0 else _other(law, z, pair, away)
        return may_end, [first] if other is None else [first, other]
    seen = from_s(z, pair)
    seen_way = way_of(seen) if away >= 0 else None
    if seen_way is None or not (near < 0 or is_apart(own(z), seen_way)):
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
    seen = from_s(z, pair)
    way = way_of(seen)
    if way is None:
        raise RefusedError("it is open whether s and c meet")
    return collide(law, seen, way)


# --- what implies a collapse ---------------------------------------------------------------------


def closes(law: Law, z: Sight, numbers: tuple[Interval, ...]) -> bool:
    """Whether the sharper theorem says that all states collapse, by these numbers.

    T has 2k = T (2 - T V²), Theta is the sum of all turns, and C_0 is -cos of the state itself.
    """
    m, p, X, Y, k, V = numbers
    if z.lam[0] <= 0 or z.rho[0] <= 0:
        return False
    reach = root(add(UNIT, mul(z.eps, square(z.v))))
    y, mX, mx = div(z.lam, reach), add(m, X), sub(m, X)
    # The entry: m - X <= eta_s/y <= m + X and d <= k y², in units of speed.
    if z.rho[1] > mul(mX, y)[0] or mul(mx, y)[1] > z.rho[0]:
        return False
    if div(z.eps, add(UNIT, reach))[1] > mul(k, square(y))[0]:
        return False
    L, least, kVV = add(p, Y), sub(p, Y), mul(k, square(V))
    free, under = sub(UNIT, L), sub(UNIT, add(kVV, kVV))
    if mx[0] < 0 or free[0] <= 0 or least[0] <= 0 or under[0] <= 0 or L[0] < 0:
        return False
    speed = isqrt(max(z.A[1], z.B[1], 0) << PLACES) + 1
    top = max(mul(y, z.v)[1], 0)
    eta, s = (top, top), root(under)
    T = div(add(k, k), add(UNIT, s))
    return _rows(law, div(z.C, reach), (mX, mx, L, least, k, V, T, s), eta, max(speed, top))


def _rows(law: Law, C: Interval, numbers: tuple[Interval, ...], eta: Interval, speed: int) -> bool:
    mX, mx, L, least, k, V, T, s = numbers
    TV, eta_2, L_2 = mul(T, V), square(eta), square(L)
    G = add(UNIT, mul(k, eta_2))
    TVV, free = mul(TV, V), sub(UNIT, L)
    turn = add(
        div(mul(add(TV, TV), eta), free),
        div(mul(add(k, square(TV)), eta_2), sub(UNIT, L_2)),
    )
    turn = add(turn, div(mul(mul(TV, k), mul(eta_2, eta)), sub(UNIT, mul(L_2, L))))
    jump = mul(law.half, G)
    high = mul(mul(jump, G), add(C, turn))
    low = sub(sub(mul(mul(law.half, s), sub(C, turn)), mX), TVV)
    low_2, high_2 = square(TV)
    drift = add(mul(mX, T), (low_2 >> 1, -(-high_2 >> 1)))
    return (
        turn[1] < C[0]
        and mul(jump, eta)[1] <= mul((V[0] - speed, V[1] - speed), free)[0]
        and high[1] <= add(mul(L, G), mx)[0]
        and least[1] <= low[0]
        and mul(law.r, G)[1] <= mul(mX, least)[0]
        and mul(mx, L)[1] <= mul(law.r, s)[0]
        and drift[1] <= mul(k, square(least))[0]
    )


# --- the plane of a map --------------------------------------------------------------------------


class Plane(NamedTuple):
    """φ1 = eta_s/(-eta_c) and φ2 = d/eta_c² in a rectangle; the rest of the scene is the same.

    W_c = eta_c ω_c + u_c n_c and W_s = eta_s ω_s + u_s n_s, with n a right angle to the left of ω.
    """

    r: Fraction
    neg_cos: Fraction
    speed: Fraction
    tangential: tuple[Fraction, Fraction]
    x: tuple[Fraction, Fraction]
    y: tuple[Fraction, Fraction]


def part(ends: tuple[Fraction, Fraction], place: int, level: int) -> Interval:
    """One of 2^level equal parts of a side."""
    width = (ends[1] - ends[0]) / 2**level
    return around(ends[0] + width * place)[0], around(ends[0] + width * (place + 1))[1]


def first_state(plane: Plane, key: str) -> Sight:
    """All scenes of a box with φ1 > 0 and φ2 > 0; a digit of its key is x + 2y, a level each.

    Raises:
        RefusedError: if s and c may touch.
    """
    column = int("".join("01"[int(digit) & 1] for digit in key), 2)
    row = int("".join("01"[int(digit) >> 1] for digit in key), 2)
    phi_1, phi_2 = part(plane.x, column, len(key)), part(plane.y, row, len(key))
    C, v = around(plane.neg_cos), around(plane.speed)
    u_c, u_s = map(around, plane.tangential)
    sine = root(around(1 - plane.neg_cos**2))
    d, eta_s = mul(phi_2, square(v)), mul(phi_1, v)
    D = add(UNIT, d)
    turned = sub(mul(eta_s, v), mul(u_c, u_s))
    w = sub(mul(C, turned), mul(sine, add(mul(u_s, v), mul(u_c, eta_s))))
    state = Sight(
        v,
        D,
        phi_1,
        mul(phi_2, add(UNIT, D)),
        add(square(v), square(u_c)),
        add(square(eta_s), square(u_s)),
        mul(D, C),
        sub(mul(C, v), mul(sine, u_c)),
        mul(D, sub(mul(sine, u_s), mul(C, eta_s))),
        w,
    )
    if far(state).g[0] <= 0:
        raise RefusedError("the spheres s and c may touch")
    return state


def prove(law: Law, state: Sight, verdict: str, numbers: list[tuple[Interval, ...]]) -> None:
    """Show a verdict for all branches of a box.

    Raises:
        RefusedError: if that fails.
    """
    waiting, steps = [state], 0
    while waiting:
        state, steps = waiting.pop(), steps + 1
        if steps > MAX_STEPS:
            raise RefusedError(f"there is no end after {MAX_STEPS} collisions")
        if any(closes(law, state, six) for six in numbers):
            continue
        may_end, states = after(law, state)
        if may_end and verdict == "c":
            raise RefusedError("it may be that no two spheres meet any more")
        waiting += states


# --- the log -------------------------------------------------------------------------------------

FORMAT = "verify-map-log/1"
HEADER = ("format", "plane", "first_level", "code", "sha256")
RECORD = ("level", "keys", "verdicts", "numbers", "sha256")
PLANE = ("name", "r", "neg_cos", "speed", "tangential", "x", "y")


class Areas(NamedTuple):
    """How many boxes the log has, how many have a verdict, and the share of each verdict."""

    boxes: int
    proved: int
    collapses: Fraction
    disperses: Fraction


def check_log(lines: Iterator[bytes]) -> tuple[Plane, Areas]:
    """Prove every verdict of a log, and that its boxes cover the rectangle once.

    Raises:
        LogError: if it is malformed.
        RefusedError: if a verdict is not proved.
    """
    chain, header = _line(next(lines, b""), "", HEADER)
    if header["format"] != FORMAT:
        raise LogError(f"expected the format {FORMAT}")
    plane, level = plane_of(header["plane"]), header["first_level"]
    if type(level) is not int or not 1 <= level <= 8:
        raise LogError("expected a first level from 1 to 8")
    law, boxes, proved = law_of(plane.r), 0, 0
    shares = {"c": Fraction(0), "d": Fraction(0)}
    due, children = [_key(i, level) for i in range(4**level)], list[str]()
    at = 0
    for line in lines:
        chain, record = _line(line, chain, RECORD)
        if at == len(due):
            level, due, children, at = level + 1, children, [], 0
        keys, letters, numbers = _boxes(record, level)
        if not keys or keys != due[at : at + len(keys)]:
            raise LogError("boxes are not those that the boxes before have left, in their order")
        at += len(keys)
        boxes += len(keys)
        given = iter(numbers)
        for key, letter in zip(keys, letters, strict=True):
            if letter == "u":
                children += [key + digit for digit in "0123"]
                continue
            prove_box(law, plane, key, letter, next(given, []) if letter == "c" else [])
            shares[letter] += Fraction(1, 4**level)
            proved += 1
    return plane, Areas(boxes, proved, shares["c"], shares["d"])


def prove_box(
    law: Law, plane: Plane, key: str, letter: str, numbers: list[tuple[Interval, ...]]
) -> None:
    """Show the verdict on a box.

    Raises:
        RefusedError: if that fails.
    """
    try:
        prove(law, first_state(plane, key), letter, numbers)
    except RefusedError as error:
        raise RefusedError(f"box {key}, {letter}: {error}") from None


def _key(place: int, level: int) -> str:
    return "".join(str(place >> 2 * i & 3) for i in reversed(range(level)))


def _line(line: bytes, chain: str, names: tuple[str, ...]) -> tuple[str, dict[str, Any]]:
    """One line of the log, and the digest of it and of all before it."""
    body, found, digest = line.rpartition(b',"sha256":"')
    try:
        content = json.loads(line, parse_float=_no_float, parse_constant=_no_float)
    except (ValueError, RecursionError) as error:
        raise LogError(f"a line is no JSON ({error})") from None
    if not isinstance(content, dict) or tuple(content) != names or not found:
        raise LogError(f"expected a line with {', '.join(names)}")
    chain = sha256(chain.encode() + body).hexdigest()
    if digest != chain.encode() + b'"}\n':
        raise LogError("a digest is not that of the lines up to it")
    return chain, content


def _no_float(text: str) -> None:
    raise LogError(f"{text} is no whole number")


def _boxes(
    record: dict[str, Any], level: int
) -> tuple[list[str], str, list[list[tuple[Interval, ...]]]]:
    keys, letters, numbers = record["keys"], record["verdicts"], record["numbers"]
    if record["level"] != level or level > MAX_LEVEL:
        raise LogError(f"expected boxes of level {level}")
    if not isinstance(keys, str) or not re.fullmatch("[0-3 ]*", keys):
        raise LogError("expected keys")
    found = keys.split(" ")
    if not isinstance(letters, str) or not re.fullmatch("[cdu]*", letters):
        raise LogError("expected verdicts c, d, u")
    if len(found) != len(letters) or not isinstance(numbers, list):
        raise LogError("expected a verdict for each key")
    if len(numbers) != letters.count("c"):
        raise LogError("expected numbers for each box that collapses")
    return found, letters, [sixes(flat, "c") for flat in numbers]


def sixes(flat: object, letter: str) -> list[tuple[Interval, ...]]:
    """Read the numbers of a box: six for each branch that collapses.

    Raises:
        LogError: if they are no such numbers.
    """
    if letter == "d" and not flat:
        return []
    if not isinstance(flat, list) or not flat or len(flat) % 6:
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
    if not isinstance(found, dict) or tuple(found) != PLANE or found["name"] != "phi":
        raise LogError(f"expected a plane phi with {', '.join(PLANE)}")
    r, neg_cos, speed = (_rational(found[name]) for name in PLANE[1:4])
    u, x, y = (_two(found[name]) for name in PLANE[4:])
    if not (0 < r < 1 and 0 < neg_cos <= 1 and speed > 0):
        raise LogError("expected 0 < r < 1, 0 < -cos <= 1 and a positive speed")
    if not (0 <= x[0] < x[1] and 0 <= y[0] < y[1]):
        raise LogError("expected a rectangle of numbers that are not negative")
    return Plane(r, neg_cos, speed, u, x, y)


def _two(found: object) -> tuple[Fraction, Fraction]:
    if not isinstance(found, list) or len(found) != 2:
        raise LogError("expected two numbers")
    return _rational(found[0]), _rational(found[1])


def _rational(text: object) -> Fraction:
    pattern = f"-?[0-9]{{1,{MAX_DIGITS}}}(/[0-9]{{1,{MAX_DIGITS}}})?"
    if not isinstance(text, str) or not re.fullmatch(pattern, text):
        raise LogError("expected an exact number p/q")
    try:
        return Fraction(text)
    except ZeroDivisionError:
        raise LogError("expected q > 0") from None


def says(plane: Plane, areas: Areas) -> str:
    """What was proved."""
    rest = 1 - areas.collapses - areas.disperses
    shares = ", ".join(
        f"{name} {share} (about {float(100 * share):.4f} %)"
        for name, share in (
            ("collapses", areas.collapses),
            ("disperses", areas.disperses),
            ("undecided", rest),
        )
    )
    return (
        f"r = {plane.r}, -cos = {plane.neg_cos}, φ1 in [{plane.x[0]}, {plane.x[1]}], "
        f"φ2 in [{plane.y[0]}, {plane.y[1]}]: {areas.boxes} boxes, {areas.proved} of them proved; "
        f"of the area: {shares}"
    )


def main(paths: list[str]) -> int:
    """Check logs and say what they prove."""
    worst = 0
    for path in paths:
        try:
            with open(path, "rb") as file:
                print(f"PROVED {path}: {says(*check_log(iter(file)))}")
        except RefusedError as error:
            print(f"REFUSED {path}: {error}")
            worst = worst or 1
        except (LogError, OSError) as error:
            print(f"MALFORMED {path}: {error}")
            worst = 4
    if not paths:
        print(__doc__)
        return 4
    return worst


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))
