"""Elastic collisions, of all pairs or of some: counted, and no collapse where all are elastic."""

from __future__ import annotations

from fractions import Fraction
from pathlib import Path
from random import Random

import pytest

from tests.spheres.scene.agreement import contradictions
from tests.spheres.scene.kinds import KINDS, random_scene_of
from tests.spheres.scene.test_restitutions import with_restitutions
from tests.spheres.scene.test_unequal import is_free, unequal
from verify.cli import main
from verify.language.statement import PROVED
from verify.paper.commands.regenerate import is_right_statement
from verify.paper.commands.scene import scene_outcome
from verify.spheres.scene.criteria import INELASTIC
from verify.spheres.scene.decide import DISPERSES, FINITE, Budget, Fate, decide_scene
from verify.spheres.scene.scene import Bodies, Scene
from verify.spheres.scene.scene_files import read_scene
from verify.wire.judge import judged
from verify.wire.write import write

ONE = Fraction(1)


def drawn(rng: Random) -> Scene:
    """A scene of some kind, with masses that are decades apart in half of them."""
    while True:
        scene = unequal(rng) if rng.random() < 0.4 else random_scene_of(rng.choice([*KINDS]), rng)
        if rng.random() < 0.5:
            bodies = scene.bodies or Bodies((ONE,) * 3, (ONE / 2,) * 3)
            masses = tuple(Fraction(10) ** rng.randint(-6, 4) for _ in range(3))
            scene = scene._replace(bodies=bodies._replace(masses=masses))
        if is_free(scene):
            return scene


def is_confirmed(found: Fate) -> bool:
    """Whether a simulation and the checker say the same."""
    return not contradictions(found) and judged(scene_outcome(found, found.flow.bits)).verdict == (
        PROVED
    )


def test_elastic_scenes_end() -> None:
    rng = Random(3)
    found = [decide_scene(drawn(rng)._replace(r=ONE), Budget(collisions=40)) for _ in range(60)]
    assert {one.verdict for one in found} <= {DISPERSES, FINITE}
    assert all(map(is_confirmed, found))
    assert sum(one.collisions for one in found) > 40


def test_some_pairs_are_elastic() -> None:
    rng, found = Random(4), []
    for _ in range(40):
        scene = with_restitutions(drawn(rng), rng)
        given = [*(scene.restitutions or ())]
        for i in rng.sample(range(3), rng.choice((1, 2))):
            given[i] = ONE
        bodies = scene.bodies or Bodies((ONE,) * 3, (ONE / 2,) * 3)
        scene = scene._replace(r=ONE, restitutions=(given[0], given[1], given[2]), bodies=bodies)
        found.append(decide_scene(scene, Budget(collisions=40)))
    assert all(is_confirmed(one) for one in found if one.verdict in (DISPERSES, FINITE))


def test_a_light_middle_ball_has_finitely_many_collisions() -> None:
    text = """r = 1
masses = ["1e-6", 1, 1]
positions = [[0, "0.001"], [2, 0], [-1.5, 0]]
velocities = [[0, 0], [-1, 0], [1, 0]]
"""
    found = decide_scene(read_scene("a", text.encode()), Budget(collisions=20))
    assert (found.verdict, found.criterion and found.criterion.name) == (FINITE, INELASTIC)
    outcome = scene_outcome(found, found.flow.bits)
    assert judged(outcome).verdict == PROVED
    assert is_right_statement(write(outcome)["statement.json"])


def test_no_map_is_about_elastic_scenes(tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    path, rows = tmp_path / "a.toml", "[[0, 0], [2, 0], [-2, 0]]"
    path.write_text(f"r = 1\npositions = {rows}\nvelocities = {rows}\n")
    assert main(["map", str(path), "--x", "velocities[1][1]=0..1"]) == 2
    assert "a map is about r < 1" in capsys.readouterr().err
