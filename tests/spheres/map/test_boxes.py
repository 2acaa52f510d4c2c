"""Verdicts on boxes: each depends on its box alone, and a simulation of points agrees."""

from __future__ import annotations

import random
from collections.abc import Iterator
from fractions import Fraction

import pytest

from tests.spheres.map.map_simulation import fate
from verify import check_map
from verify.spheres.map.boxes import Verdicts, corners, verdicts
from verify.spheres.map.log import all_keys, plane_document
from verify.spheres.map.planes import Phi, Plane, Through
from verify.spheres.scene.scene import Scene

ONE = Fraction(1)
ZERO = Fraction(0)
NEARLY_ALIGNED = Scene(
    Fraction(3, 100),
    ((ZERO, ZERO), (Fraction("1.002"), ZERO), (Fraction("-1.006"), Fraction("0.08"))),
    ((ZERO, ZERO), (Fraction("-1.4"), ZERO), (Fraction("0.7"), Fraction("-0.1"))),
)
#: 0 and 1 are in contact, and part.
IN_CONTACT = Scene(
    Fraction(3, 100),
    ((ZERO, ZERO), (-ONE, ZERO), (Fraction("1.1"), Fraction("0.15"))),
    ((ZERO, ZERO), (Fraction("-0.1"), Fraction("0.5")), (ZERO, ZERO)),
)
IN_SPACE = Scene(
    Fraction(1, 50),
    ((ZERO, ZERO, ZERO), (Fraction("1.1"), ZERO, Fraction("0.02")), (Fraction("-1.2"), ZERO, ZERO)),
    ((ZERO, ZERO, ZERO), (-ONE, Fraction("0.1"), ZERO), (ONE, ZERO, Fraction("0.1"))),
)
V_X, V_Y = ("velocities", 2, 0), ("velocities", 2, 1)
SIDES = ((-3 * ONE / 2, ZERO), (-ONE, ONE))
PLANES: dict[str, Plane] = {
    "straight": Phi(Fraction(3, 100), ONE),
    "same-side": Phi(Fraction(3, 100), ONE, tangential=(ONE, -ONE)),
    "bent": Phi(Fraction(1, 20), Fraction(97, 100)),
    "slow": Phi(Fraction(1, 100), Fraction(9, 10), Fraction(1, 3), (Fraction(2), Fraction(1, 7))),
    "at-rest": Phi(Fraction(3, 100), ONE, Fraction(1, 2), (Fraction(0), Fraction(0))),
    "slice": Through(NEARLY_ALIGNED, V_X, V_Y, *SIDES),
    "slice-contact": Through(IN_CONTACT, V_X, V_Y, *SIDES),
    "slice-space": Through(
        IN_SPACE,
        ("positions", 1, 1),
        ("velocities", 0, 2),
        (-ONE / 3, ONE / 3),
        (-2 * ONE, 2 * ONE),
    ),
    "elastic": Phi(Fraction(1, 2), Fraction(3, 5), Fraction(1)),
}


def refined(plane: Plane, levels: int) -> Iterator[tuple[str, str, list[tuple[int, ...]]]]:
    keys = list(all_keys(3))
    for _ in range(levels):
        found = verdicts(plane, keys)
        yield from zip(keys, found.letters, found.numbers, strict=True)
        pairs = zip(keys, found.letters, strict=True)
        keys = [key + digit for key, letter in pairs if letter == "u" for digit in "0123"]
        if not keys:
            return


def point(rng: random.Random, plane: Plane, key: str) -> tuple[Fraction, Fraction]:
    """A point of a box, often on its edge."""
    (column,), (row,) = corners([key])

    def place(ends: tuple[Fraction, Fraction], at: int) -> Fraction:
        share = rng.choice((Fraction(0), ONE, Fraction(rng.random())))
        return ends[0] + (ends[1] - ends[0]) * (at + share) / 2 ** len(key)

    return place(plane.x, column), place(plane.y, row)


@pytest.mark.parametrize("name", PLANES)
def test_points_of_decided_boxes_do_what_was_proved(name: str) -> None:
    plane, rng = PLANES[name], random.Random(name)
    boxes = [(key, letter) for key, letter, _ in refined(plane, 3) if letter != "u"]
    assert len(boxes) >= 20
    for key, letter in rng.sample(boxes, 12) + boxes[-6:]:
        phi_1, phi_2 = point(rng, plane, key)
        if not isinstance(plane, Phi) or (phi_1 > 0 and phi_2 > 0):
            assert fate(plane, phi_1, phi_2) == letter, (key, phi_1, phi_2)


@pytest.mark.parametrize("name", PLANES)
def test_the_checker_accepts_the_boxes(name: str) -> None:
    plane = check_map.plane_of(plane_document(PLANES[name]))
    law = check_map.law_in(plane)
    begin = check_map.beginning(law, plane)
    boxes = [box for box in refined(PLANES[name], 3) if box[1] != "u"]
    for key, letter, numbers in random.Random(name).sample(boxes, min(len(boxes), 50)):
        flat = [number for six in numbers for number in six]
        check_map.prove_box(law, begin, key, letter, check_map.sixes(flat, letter))


@pytest.mark.parametrize(("name", "key"), [("slice", "122102021"), ("slice-contact", "2112311120")])
def test_a_branch_that_no_state_is_in(name: str, key: str) -> None:
    """A grazing branch with bounds that contradict each other says nothing, and is no obstacle."""
    plane = check_map.plane_of(plane_document(PLANES[name]))
    law = check_map.law_in(plane)
    assert verdicts(PLANES[name], [key]).letters == "d"
    check_map.prove_box(law, check_map.beginning(law, plane), key, "d", [])
    with pytest.raises(check_map.RefusedError):
        check_map.prove_box(law, check_map.beginning(law, plane), key, "c", [])


def test_a_verdict_depends_on_its_box_alone() -> None:
    plane, rng = PLANES["straight"], random.Random(5)
    keys = [key for key, _, _ in refined(plane, 4) if len(key) == 6]
    together = verdicts(plane, keys)
    for i in rng.sample(range(len(keys)), 40):
        assert verdicts(plane, keys[i : i + 1]) == Verdicts(
            together.letters[i], [together.numbers[i]], [0] * (i in together.late)
        )


def test_grazing_branches_must_agree() -> None:
    """Near the border some states collapse and others miss: no verdict."""
    plane = PLANES["straight"]
    assert verdicts(plane, ["0000"]).letters == "c"
    assert verdicts(plane, ["0", "1"]).letters == "uu"
