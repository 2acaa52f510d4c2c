"""A coefficient of restitution for each pair: read, followed as a simulation says, certified."""

from __future__ import annotations

from collections import Counter
from fractions import Fraction
from pathlib import Path
from random import Random
from typing import Any

import mpmath
import pytest

from tests.spheres.scene.agreement import contradictions
from tests.spheres.scene.test_unequal import unequals
from verify.cli import main
from verify.language.statement import PROVED
from verify.measure.simulation import simulate
from verify.paper.commands.regenerate import is_right_statement
from verify.paper.commands.scene import scene_outcome
from verify.spheres.flow.collapse import LINE, THREE_BALLS
from verify.spheres.scene.criteria import INELASTIC
from verify.spheres.scene.decide import COLLAPSES, DISPERSES, FINITE, Budget, decide_scene
from verify.spheres.scene.energy import energy_at_start
from verify.spheres.scene.families import read_family
from verify.spheres.scene.middle import Middle, excluded, middles
from verify.spheres.scene.scene import PAIRS, Bodies, Scene
from verify.spheres.scene.scene_files import read_scene
from verify.spheres.scene.trajectory import trajectory
from verify.spheres.scene.verdict import told
from verify.wire.inputs import InputError
from verify.wire.judge import judged
from verify.wire.write import write

FILE = """restitution = {"01" = "0.3", "02" = "0.2", "12" = "0.5"}
masses = [1, 20, 20]
positions = [[0, 0], ["1.01", 0], ["-1.01", "0.01"]]
velocities = [[0, 0], [-1, "0.1"], [1, "0.07"]]
"""
HALF = Fraction(1, 2)


def of(text: str) -> Scene:
    """The scene in a file."""
    return read_scene("a", text.encode())


def with_restitutions(scene: Scene, rng: Random, most: int = 999) -> Scene:
    """The scene with three coefficients of restitution."""
    found = [Fraction(rng.randint(1, most), 1000) for _ in PAIRS]
    return scene._replace(r=max(found), restitutions=(found[0], found[1], found[2]))


def nearly_in_line(rng: Random) -> Scene:
    """Three balls nearly in line, of which a light one is often in the middle."""
    o, i, j = rng.sample(range(3), 3)
    radii = [Fraction(rng.randint(1, 20), 10) for _ in range(3)]
    masses = [Fraction(rng.randint(1, 100), 10) for _ in range(3)]
    masses[o] = masses[o] / rng.choice((1, 10))
    x = {o: (Fraction(0), Fraction(0))}
    v = {o: (Fraction(0), Fraction(rng.randint(-20, 20), 100))}
    for k, side in ((i, 1), (j, -1)):
        gap = radii[o] + radii[k] + Fraction(rng.randint(1, 60), 1000)
        x[k] = (side * gap, Fraction(rng.randint(-20, 20), 1000))
        v[k] = (-side * Fraction(rng.randint(50, 150), 100), Fraction(rng.randint(-20, 20), 100))
    rows = [tuple(places[k] for k in range(3)) for places in (x, v)]
    return Scene(HALF, rows[0], rows[1], bodies=Bodies(tuple(masses), tuple(radii)))


# --- files ---------------------------------------------------------------------------------------


def test_a_file_has_one_or_three() -> None:
    scene = of(FILE)
    assert [scene.restitution(i, j) for i, j in PAIRS] == [Fraction(x, 10) for x in (3, 2, 5)]
    assert scene.restitution(2, 1) == HALF
    one = FILE.splitlines()[1:]
    three = '{"01" = "0.3", "02" = "3/10", "12" = "0.3"}'
    lines = ('r = "0.3"', 'restitution = "0.3"', f"restitution = {three}")
    same = [of("\n".join([line, *one])) for line in lines]
    assert same[0] == same[1] == same[2]
    assert same[0].restitutions is None


@pytest.mark.parametrize(
    "line",
    [
        'restitution = ["0.3", "0.2", "0.5"]',
        'restitution = {"01" = "0.3", "02" = "0.2"}',
        'restitution = {"01" = "0.3", "02" = "0.2", "21" = "0.2"}',
        'restitution = {"01" = "0.3", "02" = "0.2", "12" = "1.1"}',
        'restitution = {"01" = "0.3", "02" = "0.2", "12" = "0"}',
        'restitution = {"01" = "0.3", "02" = "0.2", "12" = 0.5e}',
        'restitution = "0.3"\nr = "0.3"',
        "restitution = true",
        "",
    ],
)
def test_what_is_refused(line: str) -> None:
    with pytest.raises(InputError):
        of("\n".join([line, *FILE.splitlines()[1:]]))


def test_in_a_family_they_may_be_terms(tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    text = FILE.replace('"0.3"', '"2*e"') + '[parameters]\ne = "0.1..0.2"\n'
    family = read_family("a", text.encode())
    assert family.at({"e": Fraction("0.15")}) == of(FILE)
    file = tmp_path / "family.toml"
    file.write_text(text, encoding="utf-8")
    assert main(["map", str(file), "--x", "e", "--y", "velocities[2][1]=0..1"]) == 2
    assert "equal particles" in capsys.readouterr().err


# --- followed ------------------------------------------------------------------------------------


def test_random_scenes_against_a_simulation() -> None:
    rng = Random(1)
    found = [decide_scene(with_restitutions(one, rng), Budget(60)) for one in unequals(21, 80)]
    assert [contradictions(one, 200) for one in found] == [[]] * len(found)
    assert Counter(one.verdict for one in found)[DISPERSES] > 40


def test_scenes_nearly_in_line_against_a_simulation() -> None:
    rng, kinds = Random(2), Counter[str]()
    for _ in range(60):
        scene = with_restitutions(nearly_in_line(rng), rng, rng.choice((50, 300, 999)))
        found = decide_scene(scene, Budget(60))
        assert contradictions(found, 200) == []
        kinds[found.verdict] += 1
        if found.verdict == COLLAPSES:
            assert found.name == THREE_BALLS
    assert min(kinds[COLLAPSES], kinds[DISPERSES]) > 10


def test_on_a_line() -> None:
    """Where the middle ball has one coefficient with both, the theorem on a line is about it."""
    text = (
        FILE.replace('"-1.01"', '"-1.02"')
        .replace('"0.01"', "0")
        .replace('"0.1"', "0")
        .replace('"0.07"', "0")
    )
    assert decide_scene(of(text)).name == THREE_BALLS
    assert decide_scene(of(text.replace('"0.3"', '"0.2"'))).name == LINE
    ends = decide_scene(of(text.replace('"0.3"', '"0.99"').replace('"0.2"', '"0.98"')), Budget(2))
    assert (ends.verdict, ends.name) == (FINITE, INELASTIC)


def test_equal_coefficients_change_nothing() -> None:
    """The law for pairs, with three numbers that are the same, is that with one."""
    for scene in unequals(23, 20):
        several = scene._replace(restitutions=(scene.r,) * 3)
        one, two = (told(decide_scene(x, Budget(30))) for x in (scene, several))
        assert one[2:] == two[2:]


def test_momentum_is_kept_and_energy_lost() -> None:
    found = decide_scene(of(FILE.replace('"0.3"', '"0.9"')))
    moments = [*trajectory(found)]
    masses = found.flow.scene.bodies.masses
    speeds = [[[(a + b) / 2 for a, b in row[2:]] for row in moments[k].particles] for k in (0, -1)]
    for k in range(2):
        before, after = (sum(m * v[k] for m, v in zip(masses, x, strict=True)) for x in speeds)
        assert abs(before - after) < Fraction(1, 10**15)
    before, after = (
        sum(m * sum(a * a for a in v) for m, v in zip(masses, x, strict=True)) / 2 for x in speeds
    )
    low, high = told(found).energy
    assert low - Fraction(1, 10**15) <= before - after <= high + Fraction(1, 10**15)


# --- certificates --------------------------------------------------------------------------------


def test_certificates() -> None:
    rng, kinds = Random(4), Counter[str]()
    for n in range(40):
        scene = with_restitutions(nearly_in_line(rng), rng, rng.choice((50, 300, 999)))
        found = decide_scene(scene, Budget(2 if n % 2 else 40))
        if found.verdict in (COLLAPSES, DISPERSES, FINITE):
            outcome = judged(scene_outcome(found, 4 * found.flow.bits))
            assert outcome.verdict == PROVED
            kinds[found.verdict] += 1
    assert min(kinds[COLLAPSES], kinds[DISPERSES], kinds[FINITE]) > 3


def test_a_certificate_is_made_again_from_its_parameters() -> None:
    found = decide_scene(of(FILE))
    files = write(judged(scene_outcome(found, found.flow.bits)))
    assert is_right_statement(files["statement.json"])
    assert not is_right_statement(files["statement.json"].replace(b"scene-restitutions", b"scene"))


def test_a_condition_takes_the_pairs_of_the_middle_ball() -> None:
    scene = of(FILE)
    found = {x.ball: x.r for x in middles(scene)}
    tenths = {o: [10 * x for x in pair] for o, pair in found.items()}
    assert tenths == {0: [3, 2], 1: [3, 5], 2: [2, 5]}
    near = Middle(
        0, (1, 2), Fraction(1), (Fraction(1), Fraction(1)), (Fraction(1, 4), Fraction(1, 100))
    )
    assert excluded(near) is not None  # b² = 101/320 < (1/2 + 1/10)²


# --- the energy at the end -----------------------------------------------------------------------


def lost_in(scene: Scene, collisions: int, digits: int) -> Any:
    """The energy that so many collisions take in a simulation."""
    with mpmath.workdps(digits):
        seen = simulate(scene, collisions, digits)
        masses = [mpmath.mpf(m.numerator) / m.denominator for m in scene.bodies.masses]
        times = [mpmath.mpf(0), *(impact.time for impact in seen)]
        start = [[mpmath.mpf(a.numerator) / a.denominator for a in x] for x in scene.positions]
        places = [start, *(impact.positions for impact in seen)]

        def energy(n: int) -> Any:
            """Of the n-th flight, from where it begins and ends."""
            wait = times[n + 1] - times[n]
            speeds = (
                [(b - a) / wait for a, b in zip(*rows, strict=True)]
                for rows in zip(places[n], places[n + 1], strict=True)
            )
            both = zip(masses, speeds, strict=True)
            return sum(m * mpmath.fdot(v, v) for m, v in both) / 2

        return energy(0) - energy(len(seen) - 1)


def test_the_energy_that_a_collapse_takes_is_enclosed() -> None:
    """A simulation goes on for 60 collisions more."""
    rng, count = Random(6), 0
    while count < 8:
        scene = with_restitutions(nearly_in_line(rng), rng, 100)
        found = decide_scene(scene, Budget(400, digits=12))
        if found.verdict != COLLAPSES or found.name != THREE_BALLS:
            continue
        count += 1
        low, high = told(found).energy
        with mpmath.workdps(400):
            lost = lost_in(scene, found.collisions + 60, 400)
            least, most = (mpmath.mpf(x.numerator) / x.denominator for x in (low, high))
            assert least <= lost <= most
        more = told(decide_scene(scene, Budget(400, digits=120))).energy
        assert low <= more[0] <= more[1] <= high <= energy_at_start(found.flow)
        assert more[1] - more[0] < (high - low) / 2
