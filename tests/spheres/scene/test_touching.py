"""Scenes in which three touch at once, although the law of pairs says what happens."""

from __future__ import annotations

from collections import Counter
from fractions import Fraction
from itertools import permutations
from random import Random

import pytest

from verify.language.statement import PROVED
from verify.paper.commands.pages import decide
from verify.paper.commands.regenerate import is_right_statement
from verify.paper.commands.scene import scene_outcome
from verify.prover import balls
from verify.spheres.flow.contexts import TOUCHING
from verify.spheres.flow.exact_events import TRIPLE
from verify.spheres.scene.decide import COLLAPSES, DISPERSES, UNDECIDED, Budget, Fate, decide_scene
from verify.spheres.scene.scene import Bodies, Scene
from verify.spheres.scene.scene_files import read_scene
from verify.spheres.scene.verdict import pairs_of, theorems
from verify.wire.judge import judged
from verify.wire.write import write

CRADLE = b"""r = "0.95"
positions = [[0, 0], [2, 0], [3, 0]]
velocities = [[1, 0], [0, 0], [0, 0]]
"""
RIGHT_ANGLE = b"""r = "0.5"
positions = [[0, 0], [2, 0], [0, 2]]
velocities = [[0, 0], [-1, 0], [0, -1]]
"""
HALF = Fraction(1, 2)
ORDERS = [*permutations(range(3))]


def times_of(found: Fate) -> list[Fraction | None]:
    """The times of the collisions, where they are rational."""
    times = (move.after.time for move in found.flow.collisions)
    return [balls.fraction_of(x) if balls.is_rational(x) else None for x in times]


def renamed(scene: Scene, order: tuple[int, ...]) -> Scene:
    """The scene with other names of its particles."""
    rows = [tuple(row[i] for i in order) for row in (scene.positions, scene.velocities)]
    return scene._replace(positions=rows[0], velocities=rows[1])


def back(pairs: list[str], order: tuple[int, ...]) -> list[str]:
    """Names of pairs in the scene before."""
    return ["".join(sorted(str(order[int(i)]) for i in pair)) for pair in pairs]


@pytest.mark.parametrize("order", ORDERS)
def test_a_ball_that_rests_in_contact_is_not_approached(order: tuple[int, ...]) -> None:
    found = decide_scene(renamed(read_scene("a", CRADLE), order))
    assert (found.verdict, back(pairs_of(found), order)) == (DISPERSES, ["01", "12", "01"])
    assert times_of(found) == [1, 1, 1]
    assert theorems(found) == ["flow-of-balls", "touching"]
    assert judged(scene_outcome(found, found.flow.bits)).verdict == PROVED


@pytest.mark.parametrize("order", ORDERS)
def test_impacts_at_a_right_angle_commute(order: tuple[int, ...]) -> None:
    """The two others meet later: at the time 5 - 2√2."""
    found = decide_scene(renamed(read_scene("a", RIGHT_ANGLE), order))
    pairs = back(pairs_of(found), order)
    assert [balls.fraction_of(move.after.time) for move in found.flow.collisions[:2]] == [1, 1]
    assert (found.verdict, sorted(pairs[:2]), pairs[2:]) == (DISPERSES, ["01", "02"], ["12"])
    with balls.precision(found.flow.bits):
        low, high = balls.ends(balls.as_ball(found.flow.collisions[-1].after.time))
    assert (5 - high) ** 2 <= 8 <= (5 - low) ** 2
    assert judged(scene_outcome(found, found.flow.bits)).verdict == PROVED


def test_other_angles_stay_undecided() -> None:
    """2 comes from another side, at the same time."""
    text = RIGHT_ANGLE.replace(b"[0, 2]]", b'["-1.2", "1.6"]]')
    found = decide_scene(read_scene("a", text.replace(b"[0, -1]]", b'["0.6", "-0.8"]]')))
    assert (found.verdict, found.why, found.collisions) == (UNDECIDED, TRIPLE, 0)


@pytest.mark.parametrize("later", [b'"2.0000001"', b'"1.9999999"'])
def test_one_after_the_other_needs_no_such_theorem(later: bytes) -> None:
    found = decide_scene(read_scene("a", RIGHT_ANGLE.replace(b"[0, 2]]", b"[0, " + later + b"]]")))
    assert (found.verdict, theorems(found)) == (DISPERSES, ["flow"])


def test_two_that_approach_at_once_on_a_line_stay_undecided() -> None:
    both = CRADLE.replace(b"[[1, 0], [0, 0], [0, 0]]", b"[[1, 0], [0, 0], [-1, 0]]")
    both = both.replace(b"[3, 0]]", b"[4, 0]]")
    found = decide_scene(read_scene("a", both))
    assert (found.verdict, found.why, found.collisions) == (UNDECIDED, TRIPLE, 0)
    later = both.replace(b"[4, 0]]", b"[3, 0]]")  # in contact, and approached: it collides first
    assert decide_scene(read_scene("a", later)).collisions >= 1


def test_collisions_without_end_at_one_time_are_no_answer() -> None:
    """The ball that is hit throws itself to and fro between the two others, in no time."""
    text = CRADLE.replace(b"0.95", b"0.03")
    found = decide_scene(read_scene("a", text), Budget(300))
    assert (found.verdict, found.why, found.collisions) == (UNDECIDED, TRIPLE, 0)
    masses = read_scene("a", text + b"masses = [1, 1, 2]\n")
    found = decide_scene(masses, Budget(300))
    assert (found.verdict, found.why, found.collisions) == (UNDECIDED, TRIPLE, 0)
    assert found.event is not None
    assert (found.event.time, found.event.pairs) == (1, ("01", "12"))


# --- a second way of computing -------------------------------------------------------------------


def exactly(scene: Scene, most: int) -> tuple[list[str], list[Fraction], str]:
    """The motion of three balls on a line, in order, in rational numbers; how it ends."""
    masses, radii = scene.bodies.masses, scene.bodies.radii
    x, v = ([row[0] for row in rows] for rows in (scene.positions, scene.velocities))
    pairs: list[str] = []
    times: list[Fraction] = []
    now = Fraction(0)
    while len(pairs) < most:
        gaps = {(i, j): x[j] - x[i] - radii[i] - radii[j] for i, j in ((0, 1), (1, 2))}
        waits = {p: gaps[p] / (v[p[0]] - v[p[1]]) for p in gaps if v[p[0]] > v[p[1]]}
        if not waits:
            return pairs, times, DISPERSES
        wait = min(waits.values())
        if len(waits) == 2 and len({*waits.values()}) == 1:
            return pairs, times, TRIPLE
        i, j = min(waits, key=waits.__getitem__)
        x = [a + wait * b for a, b in zip(x, v, strict=True)]
        now += wait
        share = (1 + scene.restitution(i, j)) * (v[i] - v[j]) / (masses[i] + masses[j])
        v[i], v[j] = v[i] - share * masses[j], v[j] + share * masses[i]
        pairs.append(f"{i}{j}")
        times.append(now)
    return pairs, times, "budget"


def on_a_line(rng: Random) -> Scene:
    """Balls on a line at whole numbers, often in contact, often at rest."""
    r = Fraction(rng.randint(1, 19), 20)
    masses = tuple(Fraction(rng.choice((1, 1, 2, 3))) for _ in range(3))
    gaps = [Fraction(rng.choice((0, 0, 1, 2))) for _ in range(2)]
    speeds = tuple((Fraction(rng.choice((-1, 0, 0, 1, 2))),) for _ in range(3))
    x = (Fraction(0), 1 + gaps[0], 2 + gaps[0] + gaps[1])
    bodies = Bodies(masses, (HALF,) * 3)
    return Scene(r, tuple((a,) for a in x), speeds, bodies=bodies)


def test_random_cradles() -> None:
    rng, seen = Random(7), Counter[str]()
    for _ in range(300):
        scene = on_a_line(rng)
        found = decide_scene(scene, Budget(12))
        pairs, times, end = exactly(scene, 12)
        if end == TRIPLE:
            assert (found.why, pairs_of(found)) == (TRIPLE, pairs)
        else:
            count = len(pairs_of(found))
            assert pairs_of(found) == pairs[:count]
            assert times_of(found) == times[:count]
            assert (found.verdict == DISPERSES) == (end == DISPERSES)
            assert found.verdict == COLLAPSES or count == len(pairs)
        touched = any(move.weights is not None for move in found.flow.moves)
        seen[end, touched] += 1
        if touched and found.verdict == DISPERSES:
            outcome = judged(scene_outcome(found, found.flow.bits))
            assert outcome.verdict == PROVED
            assert is_right_statement(write(outcome)["statement.json"])
    assert seen[DISPERSES, True] > 20
    assert seen[TRIPLE, False] > 5


def test_the_theorem() -> None:
    found = decide(TOUCHING)
    assert found.verdict == PROVED
    assert [a.kind for a in found.assumptions] == ["definition", "numbered glue"]
