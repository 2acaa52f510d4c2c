"""Boxes that disperse by the theorem `outside`: its rows, the pair that never meets, the log."""

from __future__ import annotations

import random
from fractions import Fraction
from typing import Any

import pytest

from tests.check.test_check_map_families import PHI, Lines, checked, log_of
from verify import check_map
from verify.check_map import ONE, LogError, RefusedError, Run, Sight, Three, Work
from verify.prover import balls
from verify.spheres.flow.collapse import Start

F = Fraction
#: Up to r = 0.05195 these scenes collapse. From 0.05198 on they disperse, after 205 collisions at
#: 0.052.
WEDGE: dict[str, Any] = {
    "name": "family", "r": "x",
    "positions": [["0", "0"], ["101/100", "0"], ["-11/10", "1/5"]],
    "velocities": [["0", "0"], ["-1", "3/10"], ["1", "-3/20"]],
    "axes": ["r"], "x": ["1/20", "7/125"],
}  # fmt: skip
#: At a closing speed of 10^-8 the separatrix has this u for r = 3/100, C = 1 and q = 1/10.
BORDER = F(517786, 10**7)


def state(**changes: Fraction) -> Sight:
    """A state just above the separatrix; 1-2 are at a distance of almost 2."""
    u = changes.pop("u", BORDER + F(1, 10**5))
    numbers = {
        "v": F(1, 10**8), "lam": F(1), "rho": F(1, 10), "eps": u * (2 - u), "A": F(1), "B": F(1),
        "C": F(1), "a": F(0), "b": F(0), "w": F(0),
    }  # fmt: skip
    return Sight(**{name: check_map.around(x) for name, x in (numbers | changes).items()})


def parts(**changes: Fraction) -> bool:
    return check_map.parts(check_map.law_of(F(3, 100)), state(**changes))


# --- the rows -------------------------------------------------------------------------------------


def test_it_reaches_down_to_the_separatrix() -> None:
    assert parts()
    assert not parts(u=BORDER - F(1, 10**5))
    assert not parts(v=F(1, 10**5))  # by a multiple of the closing speed
    assert parts(v=F(1, 10**5), u=BORDER + F(1, 10**4))


@pytest.mark.parametrize(
    ("row", "changes", "better"),
    [
        ("start-y", {"lam": F(0)}, {}),
        ("start-recedes", {"rho": F(0), "u": F(1, 2)}, {"rho": F(1, 10**9)}),
        ("start-d", {"eps": F(0), "rho": F(2)}, {"eps": F(1, 10**9)}),
        ("v-positive", {"A": F(0)}, {}),
        ("v-positive", {"B": F(0)}, {}),
        ("decay-positive", {"v": F(3, 5), "u": F(1, 2)}, {"v": F(1, 10**3)}),
        ("v_0-least", {"v": F(1, 5), "u": F(1, 2)}, {"v": F(1, 10**3)}),
        ("C-room", {"C": F(201, 100), "u": F(9, 10)}, {"C": F(199, 100)}),
        ("C-room", {"v": F(1, 10), "u": F(9, 10)}, {"v": F(1, 40)}),
        ("U_0-room", {"eps": F(101, 100)}, {"eps": F(99, 100)}),
        ("start-q", {"rho": F(1, 11)}, {}),
        ("apart now", {"C": F(-51, 100)}, {"C": F(-49, 100)}),
        ("apart soon", {"a": F(5, 2)}, {"a": F(24, 10)}),
        ("apart soon", {"b": F(5, 2)}, {"b": F(24, 10)}),
        ("swing", {"w": F(1), "a": F(-1)}, {"w": F(99, 100)}),
    ],
)
def test_each_row_alone(
    row: str, changes: dict[str, Fraction], better: dict[str, Fraction]
) -> None:
    assert not parts(**changes), row
    assert parts(**(changes | better)) or not better, row


@pytest.mark.parametrize("place", ["lam", "rho", "eps", "A", "B", "C", "a", "b", "w"])
def test_the_worst_states_of_a_box_decide(place: str) -> None:
    """Each number is taken at its end on the bad side: a box is no better than both its ends."""
    law, middle = check_map.law_of(F(3, 100)), state(u=F(2, 10), C=F(19, 20))
    assert check_map.parts(law, middle)
    x, found = getattr(middle, place), []
    for size in (F(1, 100), F(1, 10), F(3, 10), F(1), F(4)):
        by = int(size * ONE)
        wide = middle._replace(**{place: (x[0] - by, x[1] + by)})
        ends = [middle._replace(**{place: (y, y)}) for y in wide[Sight._fields.index(place)]]
        whole = check_map.parts(law, wide)
        assert not whole or all(check_map.parts(law, end) for end in ends)
        found.append(whole)
    assert not found[-1]
    assert found[0]


def test_the_greatest_closing_speed_of_a_box_decides() -> None:
    law, z = check_map.law_of(F(3, 100)), state(u=F(6, 100))
    assert check_map.parts(law, z)
    assert check_map.parts(law, z._replace(v=(1, 2 * z.v[1])))
    assert not check_map.parts(law, z._replace(v=(1, ONE // 20)))


def test_r_of_a_box_is_taken_at_both_ends() -> None:
    above = state(u=BORDER + F(1, 10**4))
    law = check_map.law_of(F(3, 100))
    assert check_map.parts(law, above)
    low, high = law.bounds
    for low_by, high_by in ((ONE // 1000, 0), (0, ONE // 1000)):
        assert not check_map.parts(law._replace(bounds=(low - low_by, high + high_by)), above)


@pytest.mark.parametrize("v", [F(1, 10**3), F(1, 10**8)])
def test_the_numbers_satisfy_the_givens_of_the_theorem(
    monkeypatch: pytest.MonkeyPatch, v: Fraction
) -> None:
    """By the terms of its statement, with what `parts` says of its numbers."""
    from tests.paper.sandwich_above.states import fails  # reads a whole page

    given: list[Any] = []
    monkeypatch.setattr(check_map, "_floor_ends", lambda *found: given.append(found) or True)
    z = state(v=v, B=F(101, 100), u=F(6, 100), a=v, b=-v)
    assert check_map.parts(check_map.law_of(F(3, 100)), z)
    ((alpha, least_r, rhos, Q, U),) = given
    with balls.precision(400):
        r, tiny = balls.from_fraction(F(3, 100)), 1 + balls.from_fraction(F(1, 2**200))
        lam, rho, eps, A, B, C, a, b, w = (balls.from_fraction(F(x[0], ONE)) for x in z[1:])
        unit = balls.from_fraction(F(z.v[0], ONE))
        reach = (1 + eps * unit**2).sqrt()
        y, slow = lam * unit / reach, A.sqrt() / 2
        G = 1 + (y / slow) ** 2 + balls.from_fraction(F(1, 2**40))
        shift = tiny * G * y / (1 - (1 + r) / 2 * G)
        (v_0, w_0), (v_1, w_1) = ((x.sqrt() - shift, x.sqrt() + shift) for x in (A, B))
        C_p = C / reach + (w_0 + w_1 + 2 * y) * shift / slow**2
        start = Start(y, rho * unit, C / reach, a, b / reach, A, B, w, reach - 1)
        values = {"r": r, "G": G, "v": slow, "v_0": v_0, "v_1": v_1, "w_0": w_0, "w_1": w_1}
        values |= {"C_p": C_p, "Q_0": balls.fmpq_of(F(Q, ONE)), "U_0": balls.fmpq_of(F(U, ONE))}
        values |= {f"{name}_start": x for name, x in start._asdict().items()}
        assert fails(values, ((F(Q, ONE), F(U, ONE)),)) == ["end"]
        more = {"U_0": balls.fmpq_of(F(U + 2**50, ONE))}
        assert fails(values | more, ((F(Q, ONE), F(U, ONE)),)) == ["start-u", "end"]
        worst = (1 + r) / 2 * G * C_p, r, (v_1 / w_0) ** 2, (v_0 / w_1) ** 2
        for x, exact in zip((alpha, -least_r, -rhos[0], -rhos[1]), worst, strict=True):
            share = balls.from_fraction(F(abs(x), ONE)) / exact
            assert abs(share - 1) < 2.0**-60
    assert least_r <= F(3, 100) * ONE


def test_a_floor_ends_where_the_map_does() -> None:
    choose, seen = random.Random(5), {True: 0, False: 0}
    for _ in range(200):
        r, alpha = F(choose.randint(10, 60), 1000), F(choose.randint(440, 540), 1000)
        rhos = [F(choose.randint(5, 20), 10)] * 2
        rhos[1] = 1 / rhos[0]
        Q, U = F(choose.randint(1, 250), 1000), F(choose.randint(1, 100), 1000)
        point, found = [Q, U], False
        with balls.precision(300):
            q, u, r_b, alpha_b = map(balls.from_fraction, (Q, U, r, alpha))
            for n in range(check_map.MAX_FLOOR):
                pull = balls.from_fraction(rhos[n % 2]) * u
                P, load = alpha_b * (1 - u) - q - pull, pull * (2 * q + pull)
                if P <= 0 or load >= P**2:
                    found = True
                    break
                q, u = r_b * (1 - u) / P, 1 - (1 - load / P**2).sqrt()
                q, u = balls.middle(q), balls.middle(u)
        units = [int(x * ONE) for x in (alpha, r, *rhos, *point)]
        said = check_map._floor_ends(units[0], units[1], units[2:4], *units[4:])
        assert said == found, (r, alpha, rhos, point)
        seen[said] += 1
    assert min(seen.values()) > 30


def test_a_floor_has_a_limit(monkeypatch: pytest.MonkeyPatch) -> None:
    """This one ends after some steps, none of which may be missing."""
    numbers = [int(x * ONE) for x in (F(1, 2), F(3, 100), F(1, 10), F(6, 100))]
    alpha, r, Q, U = numbers
    assert check_map._floor_ends(alpha, r, (ONE, ONE), Q, U)
    ends = []
    for most in range(30):
        monkeypatch.setattr(check_map, "MAX_FLOOR", most)
        ends.append(check_map._floor_ends(alpha, r, (ONE, ONE), Q, U))
    assert ends == sorted(ends)
    assert (ends[2], ends[-1]) == (False, True)


def test_the_least_u() -> None:
    for load, P in ((F(3, 4), F(1)), (F(3, 16), F(1, 2)), (F(0), F(1)), (F(1, 10**9), F(3, 7))):
        u = F(check_map._least_u(int(load * ONE), int(P * ONE)), ONE)
        share = load / F(int(P * ONE), ONE) ** 2
        assert 0 <= u <= 1
        assert 0 <= share - u * (2 - u) <= F(1, 2**90)


# --- s and c, which never meet --------------------------------------------------------------------


@pytest.mark.parametrize(
    ("g", "p", "m", "shift", "good"),
    [
        (F(3), F(1), F(1), F(0), True), (F(0), F(1), F(1), F(0), False),
        (F(3), F(-1), F(1), F(0), True), (F(1), F(-1), F(1), F(0), False),
        (F(3), F(-1), F(1), F(1, 3), True), (F(3), F(-1), F(1), F(7, 10), False),
        (F(3), F(1), F(1), F(99, 100), True), (F(3), F(2), F(1), F(1), False),
        (F(3), F(1), F(0), F(0), False),
    ],
)  # fmt: skip
def test_two_spheres_stay_apart(
    g: Fraction, p: Fraction, m: Fraction, shift: Fraction, good: bool
) -> None:
    pair = Three(*(check_map.around(x) for x in (g, p, m)))
    assert check_map._stay_apart(pair, int(shift * ONE)) is good
    if good:
        for k in range(400):
            t = F(k, 20)
            assert 1 + g + 2 * p * t + m * t**2 > (1 + shift * t) ** 2


def test_all_impacts_together_are_what_two_spheres_are_kept_apart_by() -> None:
    """Beside the row of `apart soon`: the sum of all impacts counts where they nearly meet."""
    v, u, half = F(1, 40), F(9, 10), F(103, 200)
    least = v / (1 + v**2) / (1 - half)  # for G = 1, and an angle that is no better
    near = F(0)
    for bit in range(1, 30):
        near += F(4, 2**bit) if parts(v=v, u=u, a=near + F(4, 2**bit)) else 0
    found = state(v=v, u=u, a=near)
    g, p, m = (F(x[0], ONE) for x in check_map.far(check_map.INTERVALS, found))
    # With this a the row holds, and a larger one fails: the shift is what is left.
    assert p < 0 < g
    assert (m - least**2) * g >= (least - p) ** 2
    assert (m - least**2) * g <= (least - p + least / 20) ** 2


def test_two_spheres_of_a_box_stay_apart_in_all_its_scenes() -> None:
    good = Three(*(check_map.around(F(x)) for x in (3, 1, 1)))
    assert check_map._stay_apart(good, ONE // 2)
    for name, low in (("g", F(-1, 4)), ("p", F(-4)), ("m", F(-1, 4))):
        wide = good._replace(**{name: (int(low * ONE), getattr(good, name)[1])})
        assert not check_map._stay_apart(wide, ONE // 2), name


def test_a_gap_of_a_box_is_positive_in_all_its_scenes() -> None:
    """Where q is large, the floor ends with any gap."""
    law, z = check_map.law_of(F(3, 100)), state(rho=F(2))
    for name in ("lam", "rho", "eps", "A", "B"):
        high = getattr(z, name)[1]
        assert check_map.parts(law, z)
        for low in (0, -ONE // 4):
            assert not check_map.parts(law, z._replace(**{name: (low, high)})), name


def test_a_floor_that_goes_down_is_given_up(monkeypatch: pytest.MonkeyPatch) -> None:
    steps, least = [], check_map._least_u
    monkeypatch.setattr(check_map, "_least_u", lambda *x: steps.append(x) or least(*x))
    alpha, r, Q, U = (int(x * ONE) for x in (F(1, 2), F(3, 100), F(1, 5), F(1, 1000)))
    assert not check_map._floor_ends(alpha, r, (ONE, ONE), Q, U)
    assert len(steps) == 4
    assert not check_map._floor_ends(alpha, r, (ONE, ONE), ONE // 100, U)
    assert 4 < len(steps) < 200


# --- the log --------------------------------------------------------------------------------------


def one_box(letter: str, key: str, **changes: Any) -> Lines:
    """Of a level all boxes but one are undecided."""
    keys = [format(i, f"0{len(key)}b") for i in range(2 ** len(key))]
    letters = "".join(letter if other == key else "u" for other in keys)
    numbers = [[0] * 6] * letters.count("c")
    return log_of(WEDGE | changes, len(key), (" ".join(keys), letters, numbers))


def test_a_box_above_the_border_disperses() -> None:
    """r in [0.0520625, 0.05225], after 83 to 136 collisions: followed, so wide a box has no end."""
    plane, areas = checked(one_box("o", "01011"))
    assert areas == check_map.Areas(
        32, 1, F(0), F(1, 32), False, F(0), (Run("d", *areas.runs[0][1:]),), is_outside=True
    )
    assert check_map.cites(plane, areas) == ("flow", "sharper", "outside")
    assert "certificates/sharper and certificates/outside; " in check_map.given(plane, areas)
    assert "disperses in [" in check_map.says(plane, areas)
    with pytest.raises(RefusedError, match="box 01011, d: it is open"):
        checked(one_box("d", "01011"))


@pytest.mark.parametrize("key", ["00000", "00100", "01010", "010100"])
def test_a_box_with_a_collapse_does_not_disperse(key: str) -> None:
    with pytest.raises(RefusedError, match=f"box {key}, o: "):
        checked(one_box("o", key))


def test_neighbours_that_disperse_are_one_part() -> None:
    keys = " ".join(format(i, "05b") for i in range(32))
    _, areas = checked(log_of(WEDGE, 5, (keys, "u" * 28 + "oddo", [])))
    assert [run.letter for run in areas.runs] == ["d"]
    assert (areas.disperses, areas.is_outside) == (F(1, 8), True)
    _, areas = checked(log_of(WEDGE, 5, (keys, "u" * 28 + "dddd", [])))
    assert not areas.is_outside


def test_the_letter_has_no_numbers() -> None:
    lines = one_box("o", "01011")
    lines[1]["numbers"] = [[0] * 6]
    with pytest.raises(LogError, match="expected numbers for each box that collapses"):
        checked(lines)


def test_it_is_for_every_plane() -> None:
    """Also where what is followed are intervals."""
    letters = "".join("o" if i == 240 else "u" for i in range(256))
    keys = " ".join(check_map._key(i, 4) for i in range(256))
    _, areas = checked(log_of(PHI, 4, (keys, letters, [])))
    assert areas.disperses == F(1, 256)


def test_it_is_asked_at_each_eighth_state_and_costs_200_steps() -> None:
    law, above, work = check_map.law_of(F(3, 100)), state(), Work(1000)
    closing = check_map.parting(work)
    assert [closing(law, above) for _ in range(24)] == ([False] * 7 + [True]) * 3
    assert work.left == 400
    with pytest.raises(RefusedError, match="more work"):
        [closing(law, above) for _ in range(24)]
