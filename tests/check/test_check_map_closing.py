"""What the checker of maps takes for a collapse satisfies every condition of the sharper theorem.

At single scenes, with numbers changed at random around those that the prover finds: where the
checker accepts them, the conditions hold in exact rationals, by the terms of that theorem.
"""

from __future__ import annotations

import random
from fractions import Fraction
from math import isqrt
from typing import Any

import pytest

from verify import check_map
from verify.language.terms import symbol
from verify.paper.commands.pages import page
from verify.prover.program import ExactArithmetic, Machine, Program
from verify.spheres.map.boxes import verdicts
from verify.spheres.map.closing import NUMBERS, OTHERS
from verify.spheres.map.log import plane_document
from verify.spheres.map.planes import Phi

START = page("sharper").statement.context("start")
#: What is asked of the numbers alone.
ROOM = {name: claim for name, claim in START.claims.items() if not name.startswith("start-")}
PLANE = Phi(Fraction(3, 100), Fraction(1))
#: Nearly: roots are rounded up to so many digits.
ABOVE = 10**40
#: Numbers for boxes of this width around a scene leave some room there.
WIDE = Fraction(1, 400)


def root_above(x: Fraction) -> Fraction:
    return Fraction(isqrt(x.numerator * ABOVE**2 // x.denominator) + 1, ABOVE)


def violated(numbers: dict[str, Fraction], z: check_map.Sight) -> set[str]:
    """The conditions that do not hold, at the one scene of a sight."""
    one = check_map.ONE
    at = {name: Fraction(x[0], one) for name, x in z._asdict().items()}
    reach = root_above(1 + at["eps"] * at["v"] ** 2)
    y = at["lam"] / reach
    square = 1 - 2 * numbers["k"] * numbers["V"] ** 2
    if square <= 0:
        return {"time-room"}
    values = dict(numbers, r=PLANE.r, C_0=at["C"] / reach, eta_0=y * at["v"])
    values["T"] = 2 * numbers["k"] / (1 + root_above(square) - Fraction(2, ABOVE))
    values["V_0"] = max(root_above(max(at["A"], at["B"])), values["eta_0"])
    program = Program((*NUMBERS, *OTHERS))
    turns = {constant.name: constant.term for constant in START.constants}
    first, second, third = (turns[f"turn_{i}"] * symbol("eta_0") ** i for i in (1, 2, 3))
    program.define("Theta", first + second + third)
    for claim in ROOM.values():
        program.add(claim.lhs), program.add(claim.rhs)
    names = (*NUMBERS, *OTHERS)
    run = Machine(program, ExactArithmetic()).run([values[name] for name in names])
    bad = {
        name
        for name, claim in ROOM.items()
        if not (
            run[claim.lhs] < run[claim.rhs]
            if claim.relation == "<"
            else run[claim.lhs] <= run[claim.rhs]
        )
    }
    ratio, slope = at["rho"] / y, at["eps"] / (1 + reach) / y**2
    if not numbers["m"] - numbers["X"] <= ratio <= numbers["m"] + numbers["X"]:
        bad.add("entry-ratio")
    return bad | ({"entry-slope"} if slope > numbers["k"] else set())


def test_what_closes_satisfies_all_conditions() -> None:
    rng = random.Random(3)
    plane = check_map.plane_of(plane_document(PLANE))
    law, found = check_map.law_of(plane.r), {True: 0, False: 0}
    failing: set[str] = set()
    for phi_1, phi_2 in ((0.07, 0.004), (0.1, 0.01), (0.09, 0.002), (0.05, 0.001)):
        x, y = Fraction(phi_1), Fraction(phi_2)
        near = PLANE._replace(x=(x - WIDE, x + WIDE), y=(y / 2, 3 * y / 2))
        six = verdicts(near, ["0"]).numbers[0][0]
        point = [check_map.around(value) for value in (x, y)]
        state = check_map._at_contact(check_map.INTERVALS, plane)(*point)
        for _ in range(150):
            at = rng.randrange(6)
            share = rng.choice((1.05, 1.2, 1.5, 2))
            wider = [n * c for n, c in zip(six, (1, 1, share, share, share, 1.01), strict=True)]
            wider[at] *= rng.choice((0.5, 0.9, 0.98, 0.999, 1, 1.001, 1.02, 1.1, 3))
            flat = [round(n) for n in wider]
            (numbers,) = check_map.sixes(flat, "c")
            named = {
                n: Fraction(i, 1 << check_map.GRID) for n, i in zip(NUMBERS, flat, strict=True)
            }
            bad = violated(named, state)
            accepted = check_map.closes(law, state, numbers)
            found[accepted] += 1
            assert not (accepted and bad), (bad, flat)
            if len(bad) == 1:
                failing |= bad
    # Both happen, and most conditions are at some time the only one that fails.
    assert min(found.values()) > 20
    assert len(failing) >= 5, failing


def one_state() -> tuple[check_map.Law, check_map.Sight, tuple[check_map.Interval, ...]]:
    """A state that collapses, by these numbers."""
    plane = check_map.plane_of(plane_document(PLANE))
    x, y = Fraction(0.07), Fraction(0.004)
    near = PLANE._replace(x=(x - WIDE, x + WIDE), y=(y / 2, 3 * y / 2))
    (numbers,) = check_map.sixes([*verdicts(near, ["0"]).numbers[0][0]], "c")
    point = [check_map.around(value) for value in (x, y)]
    state = check_map._at_contact(check_map.INTERVALS, plane)(*point)
    return check_map.law_of(plane.r), state, numbers


def test_the_ratio_of_the_speeds_has_to_be_between_its_bounds() -> None:
    law, state, numbers = one_state()
    assert check_map.closes(law, state, numbers)
    assert not check_map.closes(law, state._replace(lam=(0, state.lam[1])), numbers)
    low, high = state.rho
    for other in ((low * 100, high * 100), (1, 1), (1, high), (low, high * 100)):
        assert not check_map.closes(law, state._replace(rho=other), numbers)


def test_a_ratio_of_1_leaves_no_room() -> None:
    """Where p + Y is 1, the numbers are no good; nothing is divided by 0."""
    law, state, (m, p, X, Y, k_, V_) = one_state()
    at_1 = (check_map.ONE - Y[0],) * 2
    assert check_map.closes(law, state, (m, p, X, Y, k_, V_))
    assert not check_map.closes(law, state, (m, at_1, X, Y, k_, V_))


def test_the_angle_is_that_of_the_unit_vectors(monkeypatch: pytest.MonkeyPatch) -> None:
    """-cos of the state is C over the length of the vector between the centres, and so below C."""
    law, state, numbers = one_state()
    state = state._replace(C=(check_map.ONE // 2,) * 2)
    asked: list[check_map.Interval] = []
    monkeypatch.setattr(check_map, "_rows", lambda _law, C, *_: asked.append(C))
    check_map.closes(law, state, numbers)
    one = check_map.ONE
    eps, v = (Fraction(z[0], one) for z in (state.eps, state.v))
    exact = Fraction(one, 2) / root_above(1 + eps * v**2)
    ((low, high),) = asked
    assert low <= exact <= high <= low + 4


def test_the_speeds_are_the_greatest_of_a_box(monkeypatch: pytest.MonkeyPatch) -> None:
    """The greatest |W| and -eta_c, and both are points."""
    law, state, numbers = one_state()
    asked: list[tuple[check_map.Interval, int]] = []
    monkeypatch.setattr(check_map, "_rows", lambda *found: asked.append(found[3:]))
    one = check_map.ONE
    for v, A, B in ((100, 1, 1), (100, 0, 0), (101, 1, 1), (101, 3, 1), (101, 1, 3), (101, -2, 1)):
        wide = state._replace(
            v=(state.v[0], v * state.v[1] // 100), A=(0, A * state.A[1]), B=(0, B * state.B[1])
        )
        check_map.closes(law, wide, numbers)
        eta, speed = asked.pop()
        top = Fraction(wide.lam[1] * wide.v[1], one**2)
        reach = root_above(1 + Fraction(wide.eps[0] * wide.v[0] ** 2, one**3))
        assert eta[0] == eta[1]
        assert top / (reach + Fraction(1, 10**9)) <= Fraction(eta[0], one) <= top
        size = root_above(Fraction(max(wide.A[1], wide.B[1], 0), one))
        assert max(size, Fraction(eta[0], one)) <= Fraction(speed, one) <= size + top
    law, state, numbers = one_state()
    check_map.closes(law, state._replace(v=(-9, -9), A=(-2, -1), B=(-2, -1)), numbers)
    assert asked.pop() == ((0, 0), 1)


def rows_hold(*given: Fraction) -> list[bool]:
    """The last conditions of the theorem at single numbers, exactly."""
    r, C, mX, mx, L, least, k, V, T, s, eta, speed = given
    half, G, jump = (1 + r) / 2, 1 + k * eta**2, (1 + r) / 2 * (1 + k * eta**2)
    turn = 2 * T * V * eta / (1 - L) + (k + (T * V) ** 2) * eta**2 / (1 - L**2)
    turn += T * V * k * eta**3 / (1 - L**3)
    return [
        turn < C,
        jump * eta <= (V - speed) * (1 - L),
        jump * G * (C + turn) <= L * G + mx,
        least <= half * s * (C - turn) - mX - T * V * V,
        r * G <= mX * least,
        mx * L <= r * s,
        mX * T + (T * V) ** 2 / 2 <= k * least**2,
    ]


#: r, C, mX, mx, L, least, k, V, T, s and -eta_c: one of them moved down (0) or up (1), or none.
MOVED = (None, (2, 0), (3, 0), (4, 1), (5, 0), (6, 1), (7, 1))


@pytest.mark.parametrize("moved", MOVED)
def test_the_last_conditions_hold_in_whole_intervals(moved: tuple[int, int] | None) -> None:
    """Each number in turn lies in an interval that is widened as far as the checker accepts it."""
    law, state, numbers = one_state()
    given: list[Any] = []
    with pytest.MonkeyPatch.context() as patch:
        patch.setattr(check_map, "_rows", lambda *found: given.append(found))
        check_map.closes(law, state, numbers)
    ((law, C, others, eta, speed),) = given
    points = [((low + high) // 2,) * 2 for low, high in (law.bounds, C, *others, eta)]

    def accepted(found: list[check_map.Interval]) -> bool:
        bounds, C, *others, eta = found
        return check_map._rows(law._replace(bounds=bounds), C, tuple(others), eta, speed)

    def widened(at: int, side: int, by: int) -> list[check_map.Interval]:
        low, high = points[at]
        return [*points[:at], (low - by * (1 - side), high + by * side), *points[at + 1 :]]

    def most(at: int, side: int) -> int:
        """How far it can be widened, up to 1/4."""
        least, most = 0, check_map.ONE // 4
        while most - least > 1:
            by = (least + most) // 2
            least, most = (by, most) if accepted(widened(at, side, by)) else (least, by)
        return least

    def exactly(found: list[check_map.Interval], ends: int) -> list[bool]:
        return rows_hold(*(Fraction(x[ends], check_map.ONE) for x in (*found, (speed,) * 2)))

    if moved is not None:
        at, side = moved
        points[at] = (widened(at, side, most(at, side) * 9 // 10)[at][side],) * 2
    assert accepted(points)
    bad: set[int] = set()
    for at in range(len(points)):
        for side in (0, 1):
            by = most(at, side)
            assert all(exactly(widened(at, side, by), side)), (at, side)
            more = exactly(widened(at, side, by + by // 100 + 1), side)
            bad |= {i for i, holds in enumerate(more) if not holds}
    assert len(bad) >= 5, bad


def test_the_letters_are_those_of_the_theorem() -> None:
    assert {*NUMBERS, *OTHERS, "Theta"} <= {variable.name for variable in START.variables}
