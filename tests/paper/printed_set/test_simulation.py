"""The printed and the repaired set against plain motion: three balls followed with 330 digits.

Nothing of the paper is used but its constants and its set: no normal components, no recursion. All
three pairs are followed, in dimensions 2 to 4, at random parameters that the theorem admits.
"""

from __future__ import annotations

import operator
import random
from collections.abc import Iterator
from typing import Any

import pytest
from mpmath import mp, mpf

from verify.language.statement import PRINTED
from verify.language.terms import Term
from verify.paper.theorem1 import theorem
from verify.publication import REPAIRED

DIGITS, ORBITS, COLLISIONS = 330, 1000, 20
PAIRS = ((0, 1), (0, 2), (1, 2))
Vector = list[Any]
Constants = dict[str, Any]


#: Terms by the functions of mpmath.
ALGEBRA = {
    "rational": lambda number: mpf(number.numerator) / number.denominator,
    "add": operator.add,
    "sub": operator.sub,
    "mul": operator.mul,
    "div": operator.truediv,
    "neg": operator.neg,
    "pow": operator.pow,
    "sqrt": mp.sqrt,
    "min": min,
    "max": max,
}


def value(term: Term, known: Constants) -> Any:
    """A term with numbers for its symbols."""
    if term.op == "symbol":
        return known[term.name]
    if term.op == "rational":
        return ALGEBRA["rational"](term.value)
    parts = [value(child, known) for child in term.children]
    parts += [term.exponent] if term.op == "pow" else []
    return ALGEBRA[term.op](*parts)


def constants(group: str, r: Any, c: Any, v_0: Any, delta: Any) -> Constants:
    """All constants of a set at these parameters, by their names without the set."""
    known = {"r": r, "c": c, "V_0": v_0, "delta_theta": delta}
    for constant in (*theorem().common, *theorem().parts[group].bounds):
        known[constant.name] = value(constant.term, known)
    return {name.rpartition(".")[2]: number for name, number in known.items()}


def dot(x: Vector, z: Vector) -> Any:
    return sum((p * q for p, q in zip(x, z, strict=True)), mpf(0))


def along(x: Vector, t: Any, z: Vector) -> Vector:
    return [p + t * q for p, q in zip(x, z, strict=True)]


def unit(choose: random.Random, dimension: int, *others: Vector) -> Vector:
    """A random direction that is orthogonal to some unit vectors, which are so to each other."""
    x = [mpf(choose.gauss(0, 1)) for _ in range(dimension)]
    for other in others:
        x = along(x, -dot(x, other), other)
    return [p / mp.sqrt(dot(x, x)) for p in x]


def share(choose: random.Random) -> Any:
    """A number from 0 to 1; often an end of that."""
    return mpf(choose.choice([0, 1, choose.random(), choose.random()]))


def start(choose: random.Random, k: Constants, printed: bool) -> tuple[list[Vector], list[Vector]]:
    """Positions and velocities of a state of the set; its edge is in it."""
    dimension = choose.choice([2, 3, 4])
    room = 0 if printed else k["Delta_theta"] / 4
    cosine = min(k["c"] + room * (2 * share(choose) - 1), mpf(1))
    to_s = unit(choose, dimension)
    across = unit(choose, dimension, to_s)
    sine = mp.sqrt(1 - cosine**2)
    to_c = along([-cosine * p for p in to_s], sine, across)
    y = k["eta_bar"] * mpf(10) ** (-6 * share(choose))
    low, high = max(k["phi_minus"] - k["x_0"], mpf(0)), k["phi_minus"] + k["x_0"]
    eta_s = (low + (high - low) * max(share(choose), mpf("1e-9"))) * y  # 0 and 1 recede
    gap = min(k["d_const"], k["d_slope"] * y**2) * max(share(choose), mpf("1e-9"))
    third = (k["V_1"] - k["V_0"]) / 3
    speeds = [k["V_0"] + third * (1 + share(choose)) for _ in range(2)]
    w_s = along([eta_s * p for p in to_s], mp.sqrt(speeds[0] - eta_s**2),
                unit(choose, dimension, to_s))  # fmt: skip
    w_c = along([-y * p for p in to_c], mp.sqrt(speeds[1] - y**2), unit(choose, dimension, to_c))
    places = [[mpf(0)] * dimension, to_s, [(1 + gap) * p for p in to_c]]
    frame = [mpf(choose.gauss(0, 1)) for _ in range(dimension)]
    return places, [frame, along(w_s, 1, frame), along(w_c, 1, frame)]


def meeting(x: Vector, w: Vector) -> Any:
    """When a pair that approaches comes into contact for the first time; None if never."""
    b, size = dot(x, w), dot(w, w)
    root = b**2 - size * (dot(x, x) - 1)
    return (-b - mp.sqrt(root)) / size if b < 0 and root > 0 else None


def follow(r: Any, places: list[Vector], speeds: list[Vector]) -> Iterator[tuple[Any, Any, Any]]:
    """The pair of each collision, its time, and -cos of the angle at ball 0 then."""
    time = mpf(0)
    while True:
        times = {}
        for i, j in PAIRS:
            x, w = along(places[j], -1, places[i]), along(speeds[j], -1, speeds[i])
            found = meeting(x, w)
            if found is not None:
                times[i, j] = found
        assert times, "the balls fly apart"
        i, j = pair = min(times, key=lambda one: times[one])
        time += times[pair]
        places = [along(x, times[pair], v) for x, v in zip(places, speeds, strict=True)]
        e = along(places[j], -1, places[i])
        push = (1 + r) / 2 * dot(along(speeds[j], -1, speeds[i]), e)
        speeds[i], speeds[j] = along(speeds[i], push, e), along(speeds[j], -push, e)
        sides = [along(places[k], -1, places[0]) for k in (1, 2)]
        lengths = mp.sqrt(dot(sides[0], sides[0]) * dot(sides[1], sides[1]))
        yield pair, time, -dot(*sides) / lengths


def parameters(choose: random.Random) -> tuple[Any, Any, Any, Any]:
    """r, c, V_0 and delta_theta that satisfy the hypothesis with > for <."""
    r = mpf(choose.choice([choose.uniform(0, 0.0557), 10 ** choose.uniform(-6, -2)]))
    s = mp.cbrt(r)
    least = 2 * s * (1 + s) / (1 + r)
    c = least + (1 - least) * mpf(choose.uniform(0.001, 1))
    return r, c, mpf(10) ** choose.uniform(-3, 3), mpf(10) ** choose.uniform(-6, 0)


@pytest.mark.parametrize("group", [PRINTED, REPAIRED])
def test_every_start_of_the_set_collides_in_turn(group: str) -> None:
    choose = random.Random(24)
    with mp.workdps(DIGITS):
        for _ in range(ORBITS):
            r, c, v_0, delta = parameters(choose)
            k = constants(group, r, c, v_0, delta)
            running = follow(r, *start(choose, k, group == PRINTED))
            for n in range(COLLISIONS):
                pair, time, cosine = next(running)
                assert pair == PAIRS[1 - n % 2], (n, r, c)
                assert time <= k["T_star"]
                assert abs(cosine - c) <= delta


def test_a_state_outside_of_the_set_is_seen_to_fail() -> None:
    """Much further apart, the balls do not go on in turn: the test can fail."""
    choose = random.Random(24)
    with mp.workdps(DIGITS):
        k = constants(PRINTED, mpf("0.03"), mpf(1), mpf(1), mpf("0.1"))
        far = k | {"d_slope": k["d_slope"] * 10**6, "eta_bar": mpf("0.01"), "d_const": mpf(1)}
        failed = 0
        for _ in range(20):
            running = follow(k["r"], *start(choose, far, True))
            try:
                pairs = [next(running)[0] for _ in range(COLLISIONS)]
            except AssertionError:
                pairs = []
            failed += pairs != [PAIRS[1 - n % 2] for n in range(COLLISIONS)]
        assert failed > 0
