"""Spheres of different masses and radii: followed as a simulation says, and what is not known."""

from __future__ import annotations

import json
import math
from collections import Counter
from fractions import Fraction
from itertools import pairwise
from pathlib import Path
from random import Random
from typing import Any

import jsonschema
import mpmath
import pytest

from tests.spheres.scene.agreement import contradictions
from tests.spheres.scene.kinds import random_scene_of
from tests.spheres.scene.scenes import aligned
from verify.cli import main
from verify.measure.simulation import simulate
from verify.prover import balls
from verify.spheres.flow.law import Sizes
from verify.spheres.scene.criteria import spread, whole
from verify.spheres.scene.decide import (
    COLLAPSES,
    DISPERSES,
    FINITE,
    UNDECIDED,
    Budget,
    Fate,
    decide_scene,
    told_event,
)
from verify.spheres.scene.families import read_family
from verify.spheres.scene.scene import FIRST_FRAMES, PAIRS, Bodies, Frame, Scene, coordinates
from verify.spheres.scene.scene_files import read_scene
from verify.spheres.scene.trajectory import trajectory
from verify.spheres.scene.verdict import steps, told
from verify.views.plots.scene_drawing import legs
from verify.wire.inputs import InputError

SCHEMA = Path(__file__).resolve().parents[3] / "certificates/schema/scene.schema.json"
FILE = """r = "0.3"
positions = [[0, 0], [2, "0.1"], [-3, "0.2"]]
velocities = [[0, 0], [-1, 0], [1, 0]]
"""
SIZES = """masses = [1, 5, "0.5"]
radii = ["0.5", 1, "0.25"]
"""


def unequal(rng: Random) -> Scene:
    """A scene of some kind with other masses and radii, moved apart so that none overlap."""
    kind = rng.choice(("far-plane", "far-space", "five-dimensions", "hardly-inelastic"))
    scene = random_scene_of(kind, rng)
    masses, radii = (
        tuple(Fraction(rng.randint(1, 40), 10) for _ in range(3)),
        tuple(Fraction(rng.randint(1, 20), 20) for _ in range(3)),
    )
    places = tuple(tuple(2 * a for a in row) for row in scene.positions)
    return scene._replace(positions=places, bodies=Bodies(masses, radii))


def is_free(scene: Scene) -> bool:
    """Whether no spheres overlap."""
    given = coordinates(scene, Fraction)
    return all(given.pair(i, j).g >= 0 for i, j in PAIRS)


def unequals(seed: int, count: int) -> list[Scene]:
    """So many scenes."""
    rng, found = Random(seed), []
    while len(found) < count:
        scene = unequal(rng)
        if is_free(scene):
            found.append(scene)
    return found


def test_random_scenes_against_a_simulation() -> None:
    found = [decide_scene(scene, Budget(collisions=60)) for scene in unequals(1, 120)]
    assert [contradictions(one) for one in found] == [[]] * len(found)
    kinds = Counter(one.verdict for one in found)
    assert kinds[DISPERSES] > 60
    assert {*kinds} <= {COLLAPSES, DISPERSES, FINITE, UNDECIDED}
    assert sum(one.collisions for one in found) > 140


def test_unequal_spheres_collapse_by_the_theorem_about_them() -> None:
    """The others are about equal ones; more in `test_three_balls.py`."""
    masses = Bodies((Fraction(1), Fraction(2), Fraction(1)), (HALF,) * 3)
    radii = Bodies((Fraction(1),) * 3, (HALF, HALF, Fraction(49, 100)))
    for bodies in (masses, radii):
        found = decide_scene(aligned()._replace(bodies=bodies), Budget(collisions=40))
        assert (found.verdict, found.name) == (COLLAPSES, "three-balls")
        assert contradictions(found) == []


def on_a_line(rng: Random, radii: tuple[Fraction, ...], r: Fraction) -> tuple[Scene, Scene]:
    """A scene on a line with these radii, and one of equal spheres with the same gaps."""
    gaps = [Fraction(rng.randint(1, 900), 1000) for _ in range(2)]
    speeds = [Fraction(rng.randint(-100, 100), 100) for _ in range(3)]
    rows = []
    for a, b, c in (radii, (HALF,) * 3):
        along = (Fraction(0), a + b + gaps[0], -a - c - gaps[1])
        rows.append(tuple((3 * x / 5, 4 * x / 5) for x in along))
    velocities = tuple((3 * v / 5, 4 * v / 5) for v in speeds)
    bodies = Bodies((Fraction(2),) * 3, radii)
    return Scene(r, rows[0], velocities, bodies=bodies), Scene(r, rows[1], velocities)


def test_on_a_line_radii_do_not_matter() -> None:
    """Only gaps do, so that the theorem on a line is about any radii."""
    rng, seen = Random(8), Counter[str]()
    for _ in range(120):
        r = Fraction(rng.choice(("0.03", "0.0717", "0.0718", "0.3")))
        radii = tuple(Fraction(rng.randint(1, 30), 20) for _ in range(3))
        uneven, even = on_a_line(rng, radii, r)
        one, two = decide_scene(uneven), decide_scene(even)
        assert (one.verdict, one.name, one.collisions) == (two.verdict, two.name, two.collisions)
        assert contradictions(one, 600) == []
        if one.collapse is not None:
            ends, others = (told(x).time for x in (one, two))
            assert ends is not None
            assert others is not None
            assert ends[0] <= others[1]
            assert others[0] <= ends[1]
            assert told(one).theorems == ["flow-of-balls", "line"]
        seen[one.verdict] += 1
    assert min(seen["collapses"], seen["disperses"]) > 10


def test_masses_matter_on_a_line_and_above_the_thresholds() -> None:
    """7 - 4√3 and 9 - 4√5 are about one mass; with others there are other thresholds."""
    radii = (HALF, Fraction(1), Fraction(1, 4))
    scene, _ = on_a_line(Random(2), radii, Fraction(1, 100))
    speeds = ((Fraction(0),) * 2, (Fraction(-3), Fraction(-4)), (Fraction(3), Fraction(4)))
    scene = scene._replace(velocities=speeds)
    few = Budget(collisions=1)
    assert decide_scene(scene, few).verdict == "collapses"
    fast = scene._replace(r=Fraction(1, 2))
    assert decide_scene(fast, few).name == "restitution"
    beside = ((Fraction(0),) * 2, (Fraction(-3), Fraction(-4)), (Fraction(3), Fraction(5)))
    slow = scene._replace(velocities=beside, r=Fraction(3, 50))
    assert decide_scene(slow, few).name == "momentum"
    masses = Bodies((Fraction(2), Fraction(2), Fraction(1)), radii)
    assert decide_scene(scene._replace(bodies=masses), few).verdict == "collapses"
    assert decide_scene(fast._replace(bodies=masses), few).name == "restitution"
    light = Bodies((Fraction(1, 20), Fraction(2), Fraction(1)), radii)
    for one in (fast, slow):
        assert decide_scene(one._replace(bodies=light), few).name in {"line", "budget"}


HALF = Fraction(1, 2)


def test_equal_masses_and_radii_are_the_scene_without_them() -> None:
    plain = read_scene("a", FILE.encode())
    same = read_scene("a", f"{FILE}masses = [3, 3, 3]\nradii = ['1/2', 0.5, 0.50]\n".encode())
    assert same.mass == 3  # on which energies depend, and nothing else
    assert same._replace(mass=Fraction(1)) == plain
    scaled = FILE.replace("[2,", "[4,").replace("[-3,", "[-6,").replace("0.1", "0.2")
    scaled = scaled.replace('[-6, "0.2"]', '[-6, "0.4"]')
    scaled = scaled.replace("[-1, 0], [1, 0]", "[-2, 0], [2, 0]")
    assert read_scene("a", f"{scaled}radii = [1, 1, 1]\n".encode()) == plain


def test_units_of_unequal_radii_are_those_of_the_file() -> None:
    labels = 'length_unit = "mm"\n'
    for more, unit in (
        ('radii = ["0.5", 1, "0.25"]', "lengths are in mm"),
        ('radii = ["0.4", "0.4", "0.4"]', "lengths are in diameters, each 0.8 mm"),
        ('diameter = "0.9"\nmasses = [1, 2, 3]', "lengths are in diameters, each 0.9 mm"),
    ):
        scene = read_scene("a", f"{FILE}{labels}{more}\n".encode())
        assert told(decide_scene(scene)).lines[-1] == unit


@pytest.mark.parametrize(
    ("more", "words"),
    [
        ("masses = [1, 2]", "masses: write one for each particle"),
        ("masses = [1, 0, 2]", "masses of particle 1: '0' is not positive"),
        ("radii = [1, -1, 2]", "radii of particle 1: '-1' is not positive"),
        ("radii = [1, 'x', 2]", "radii of particle 1"),
        ("radii = [1, 2, 1]", "overlap by about 0.998: their distance has to be at least 3"),
        ("diameter = 1\nradii = [1, 1, 1]", "the file has a diameter too"),
    ],
)
def test_unusable_sizes_are_refused_in_a_line(more: str, words: str) -> None:
    with pytest.raises(InputError) as caught:
        read_scene("a", f"{FILE}{more}\n".encode())
    assert words in str(caught.value)


def test_energy_and_trajectory_follow_the_masses() -> None:
    """The total momentum is kept, and the energy that is lost is that of the velocities."""
    for scene in unequals(5, 12):
        found = decide_scene(scene, Budget(collisions=20))
        if found.verdict != DISPERSES:
            continue
        moments = [*trajectory(found)]
        first, last = (speeds_at(moments[k].particles, scene.dimension) for k in (0, -1))
        masses = found.flow.scene.bodies.masses
        for k in range(scene.dimension):
            sums = [sum(m * v[k] for m, v in zip(masses, rows, strict=True))
                    for rows in (first, last)]  # fmt: skip
            assert abs(sums[0] - sums[1]) < Fraction(1, 10**15)
        lost = energy(masses, first) - energy(masses, last)
        low, high = told(found).energy
        assert low - Fraction(1, 10**15) <= lost <= high + Fraction(1, 10**15)
        assert lost > 0 or not found.collisions


def test_energies_are_in_the_unit_of_mass_whether_masses_differ_or_not() -> None:
    """Of which masses there is one only, does not change the unit."""
    lost = []
    for masses in ('["2", "2", "2"]', '["2", "2", "2.0000000001"]'):
        scene = read_scene("a", f"{FILE}masses = {masses}\n".encode())
        lost.append(told(decide_scene(scene, Budget(collisions=20))).energy)
    (low, high), (least, most) = lost
    assert low > 0
    assert abs(low - least) < low / 10**8
    assert abs(high - most) < high / 10**8


def speeds_at(particles: Any, dimension: int) -> list[list[Fraction]]:
    """The middles of the enclosures of the velocities."""
    return [[(low + high) / 2 for low, high in row[dimension:]] for row in particles]


def energy(masses: tuple[Fraction, ...], speeds: list[list[Fraction]]) -> Fraction:
    """Half the sum of m v²."""
    return sum(m * sum(a * a for a in row) for m, row in zip(masses, speeds, strict=True)) / 2


def test_the_normal_speed_and_the_angle_are_those_of_the_simulation() -> None:
    for scene in unequals(9, 20):
        found = decide_scene(scene, Budget(collisions=8))
        seen = simulate(scene, found.collisions)
        for before, (impact, step) in pairwise([None, *zip(seen, steps(found), strict=True)]):
            if before is None:
                continue
            with balls.precision(found.flow.bits):
                o, c = step.hit
                s = 3 - o - c
                x = impact.positions
                a, b = ([q - p for p, q in zip(x[o], x[k], strict=True)] for k in (c, s))
                cosine = -sum(p * q for p, q in zip(a, b, strict=True)) / mpmath.sqrt(
                    sum(p * p for p in a) * sum(q * q for q in b)
                )
                assert abs(float(cosine) - balls.as_float(step.after.C)) < 1e-9


def test_the_sums_of_equal_spheres_are_those_of_the_classification() -> None:
    equal = Bodies((Fraction(1),) * 3, (HALF,) * 3)
    rng = Random(3)
    for _ in range(20):
        scene = random_scene_of("far-space", rng)
        for frame in FIRST_FRAMES:
            state = coordinates(scene, Fraction).state(frame, lambda _, value: value)
            found = spread(state, frame, *sizes_of(equal, frame))
            assert found[:3] == tuple(whole(state))
            assert found.touching == (2, 2, 2)


def test_the_sums_are_those_of_the_vectors() -> None:
    for scene in unequals(4, 20):
        m, x, v = scene.bodies.masses, *centred(scene)
        state = coordinates(scene, Fraction).state(FIRST_FRAMES[1], lambda _, value: value)
        found = spread(state, FIRST_FRAMES[1], *sizes_of(scene.bodies, FIRST_FRAMES[1]))
        assert found.R2 == sum(w * dot(a, a) for w, a in zip(m, x, strict=True))
        assert found.A == sum(w * dot(a, b) for w, a, b in zip(m, x, v, strict=True))
        n = scene.dimension
        spins = [
            sum(w * (a[i] * b[k] - a[k] * b[i]) for w, a, b in zip(m, x, v, strict=True))
            for i in range(n)
            for k in range(i)
        ]
        assert found.L2 == sum(spin * spin for spin in spins)


def sizes_of(bodies: Bodies, frame: Frame) -> tuple[Any, Any, Sizes]:
    """Masses, contact distances, and what the law of collision needs."""
    contacts = [bodies.radii[i] + bodies.radii[j] for i, j in PAIRS]
    return bodies.masses, contacts, bodies.sizes(frame, Fraction)


def dot(a: list[Fraction], b: list[Fraction]) -> Fraction:
    """The inner product."""
    return sum(p * q for p, q in zip(a, b, strict=True))


def centred(scene: Scene) -> list[list[list[Fraction]]]:
    """Positions and velocities about the centre of mass."""
    masses = scene.bodies.masses
    found = []
    for rows in (scene.positions, scene.velocities):
        middle = [sum(m * a for m, a in zip(masses, column, strict=True)) / sum(masses)
                  for column in zip(*rows, strict=True)]  # fmt: skip
        found.append([[a - b for a, b in zip(row, middle, strict=True)] for row in rows])
    return found


def test_few_collisions_that_recede_are_finite() -> None:
    """Far apart and receding as a whole, with more collisions than were followed."""
    scene = read_scene("a", (FILE + SIZES).encode())
    full = decide_scene(scene)
    assert (full.verdict, full.collisions) == (DISPERSES, 3)
    seen = {decide_scene(scene, Budget(collisions=n)).verdict for n in range(3)}
    assert seen <= {FINITE, UNDECIDED}
    assert FINITE in {decide_few(one).verdict for one in unequals(11, 60)}


def decide_few(scene: Scene) -> Fate:
    """A scene with a budget of one collision."""
    return decide_scene(scene, Budget(collisions=1))


def test_what_the_command_says(tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    file = tmp_path / "sizes.toml"
    file.write_text(FILE + SIZES, encoding="utf-8")
    assert main(["scene", str(file)]) == 0
    assert "given certificates/flow-of-balls; judged by FLINT" in capsys.readouterr().out
    assert main(["scene", str(file), "--json"]) == 0
    document = json.loads(capsys.readouterr().out)
    schema = json.loads(SCHEMA.read_text(encoding="utf-8"))
    jsonschema.Draft202012Validator(schema).validate(document)
    assert (document["cites"], document["judged_by"][:5]) == (["flow-of-balls"], "FLINT")
    assert main(["scene", str(file), "--out", str(tmp_path / "out")]) == 0
    assert "judged by the checker" in capsys.readouterr().out
    assert main(["check", str(tmp_path / "out")]) == 0
    axes = ["--x", "velocities[2][0]=0.5..1", "--y", "velocities[2][1]=0..1"]
    assert main(["map", str(file), *axes, "--out", str(tmp_path / "map")]) == 2
    assert "masses: maps are about equal particles" in capsys.readouterr().err


def test_symmetric_positions_with_different_masses_meet_at_once_all_the_same() -> None:
    """The times of two contacts are the same; the masses do not matter to them."""
    text = (
        "r = 0.5\npositions = [[0], [2], [-2]]\nvelocities = [[0], [-1], [1]]\nmasses = [1, 2, 3]"
    )
    found = decide_scene(read_scene("a", text.encode()))
    assert found.name == "triple-contact"
    assert found.event is not None
    assert told_event(found.event).startswith("triple contact: 01 and 02")


def test_a_mass_may_be_a_parameter() -> None:
    text = f'{FILE}masses = [1, "m", "2*m"]\nparameters = {{m = "1..2"}}\n'
    family = read_family("a", text.encode())
    scene = family.at({"m": Fraction(3, 2)})
    assert scene.bodies == Bodies((Fraction(1), Fraction(3, 2), Fraction(3)), (HALF,) * 3)


def test_drawings_have_the_radii_and_the_units(tmp_path: Path) -> None:
    """In a drawing spheres touch where they collide."""
    file, svg, page = (tmp_path / name for name in ("sizes.toml", "a.svg", "a.html"))
    units = 'length_unit = "mm"\ntime_unit = "ms"\n'
    file.write_text(FILE + SIZES + units, encoding="utf-8")
    assert main(["scene", str(file), "--plot", str(svg)]) == 0
    text = svg.read_text(encoding="utf-8")
    assert ">2 mm</text>" in text
    assert "normal speed, mm per ms" in text
    assert main(["scene", str(file), "--plot", str(page)]) == 0
    assert '"radii": [0.5, 1.0, 0.25]' in page.read_text(encoding="utf-8")
    for scene in unequals(21, 12):
        found = decide_scene(scene, Budget(collisions=6))
        radii = scene.bodies.radii
        path = legs(told(found), steps(found))
        for leg in path[1:]:
            i, j = map(int, leg.pair)
            if scene.dimension == 2:
                assert math.dist(leg.places[i], leg.places[j]) == pytest.approx(
                    float(radii[i] + radii[j]), abs=1e-9
                )
