"""Spheres on a line: each scene is decided, and as exact rational numbers say."""

from __future__ import annotations

import random
from fractions import Fraction
from itertools import pairwise

import pytest

from verify import check
from verify.language.statement import Applies
from verify.language.terms import as_term
from verify.paper.commands.scene import scene_outcome
from verify.prover import balls
from verify.spheres.flow.follow import Flow
from verify.spheres.flow.line import follow_line, is_on_a_line
from verify.spheres.scene.decide import COLLAPSES, DISPERSES, FINITE, decide_scene
from verify.spheres.scene.scene import Bodies, Scene
from verify.wire.judge import report_on
from verify.wire.write import digest, write

#: 7 - 4√3 is a little more.
LARGEST = Fraction("0.0717967697")


def simulated(scene: Scene, direction: list[int]) -> tuple[str, int]:
    """What exact numbers say, within 400 collisions: by the ratio of the two speeds alone."""
    size = sum(x * x for x in direction)
    x, v = (
        [sum(a * b for a, b in zip(row, direction, strict=True)) / Fraction(size) for row in rows]
        for rows in (scene.positions, scene.velocities)
    )
    order = sorted(range(3), key=lambda i: x[i])
    x, v, touch = [x[i] for i in order], [v[i] for i in order], Fraction(1)
    half, count, pair = (1 + scene.r) / 2, 0, -1
    while count < 400:
        speeds = [v[0] - v[1], v[1] - v[2]]
        times = [
            (x[i + 1] - x[i] - touch) / speeds[i] if speeds[i] > 0 and i != pair else None
            for i in (0, 1)
        ]
        ahead = [t for t in times if t is not None]
        if not ahead:
            return DISPERSES, count
        time = min(ahead)
        pair = times.index(time)
        x = [a + time * b for a, b in zip(x, v, strict=True)]
        push = half * speeds[pair]
        v[pair], v[pair + 1] = v[pair] - push, v[pair + 1] + push
        count += 1
        other = 1 - pair
        closing, parting = (v[0] - v[1], v[1] - v[2])[other], scene.r * speeds[pair]
        if closing > 0:
            q = parting / closing
            if 2 * q < half and 4 * scene.r < half**2:
                return COLLAPSES, count
    return FINITE, count


def random_scene(choice: random.Random, r: Fraction) -> tuple[Scene, list[int]]:
    """Three spheres on a line in some direction, two of which approach the third."""
    direction = choice.choice([[1], [3, 4], [2, -1, 2], [0, 5]])
    size = {1: 1, 25: 5, 9: 3}[sum(x * x for x in direction)]
    places = [Fraction(0), Fraction(choice.randrange(1001, 9000), 1000)]
    places.append(-Fraction(choice.randrange(1001, 9000), 1000))
    speeds = [Fraction(choice.randrange(-300, 300), 100) for _ in range(3)]
    shift = choice.randrange(-3, 4)

    def rows(values: list[Fraction]) -> tuple[tuple[Fraction, ...], ...]:
        return tuple(tuple(value * x / size for x in direction) for value in values)

    return Scene(r, rows(places), rows([speed + shift for speed in speeds])), direction


@pytest.mark.parametrize("seed", range(120))
def test_random_scenes(seed: int) -> None:
    choice = random.Random(seed)
    r = choice.choice([Fraction(6, 100), LARGEST, LARGEST - Fraction(1, 10**5), Fraction(7, 100),
                       Fraction(1, 100), Fraction(8, 100), Fraction(1, 2)])  # fmt: skip
    scene, direction = random_scene(choice, r)
    if scene.dimension == 1:
        scene = Scene(r, *(tuple((*row, Fraction(0)) for row in rows) for rows in scene[1:3]))
        direction = [1, 0]
    assert is_on_a_line(scene)
    verdict, _ = simulated(scene, direction)
    found = decide_scene(scene)
    if verdict == FINITE:
        assert found.verdict in (FINITE, "undecided")
    else:
        assert found.verdict == verdict


def test_the_certificate_is_accepted_and_a_lie_is_not() -> None:
    zero, one = Fraction(0), Fraction(1)
    positions = ((zero, zero), (2 * one, zero), (Fraction(-5, 2), zero))
    scene = Scene(Fraction(6, 100), positions, ((zero, zero), (-one, zero), (one, zero)))
    found = decide_scene(scene)
    assert (found.verdict, found.collisions) == (COLLAPSES, 1)
    outcome = scene_outcome(found, found.flow.bits)
    files = write(outcome)
    cited = {digest(data): data for name, data in files.items() if name.startswith("cited/")}
    report = check.check(files["statement.json"], files["certificate.json"], cited)
    assert report.verdict == "PROVED"
    (row,) = (row for row in outcome.statement.obligations if row.name == "collapse")
    assert isinstance(row.claim, Applies)
    for name, lie in (("start.Q", Fraction(7, 100)), ("start.E", Fraction(1))):
        claim = row.claim._replace(at={**row.claim.at, name: as_term(lie)})
        rows = [
            one._replace(claim=claim) if one is row else one
            for one in outcome.statement.obligations
        ]
        lied = outcome._replace(statement=outcome.statement._replace(obligations=tuple(rows)))
        assert report_on(lied).verdict == "REFUSED"
    bent = ((zero, zero), (2 * one, Fraction(1, 10**9)), positions[2])
    assert not is_on_a_line(scene._replace(positions=bent))


def exact_collisions(scene: Scene, most: int) -> tuple[list[Fraction], bool]:
    """The times of collisions on a line by exact numbers, for any masses and radii; do they end?"""
    bodies = scene.bodies
    assert bodies is not None
    m, radii = bodies.masses, bodies.radii
    x, v = [row[0] for row in scene.positions], [row[0] for row in scene.velocities]
    order, now, times = sorted(range(3), key=lambda i: x[i]), Fraction(0), []
    while len(times) < most:
        flights = [
            ((x[j] - x[i] - radii[i] - radii[j]) / (v[i] - v[j]), i, j)
            for i, j in pairwise(order)
            if v[i] > v[j]
        ]
        if not flights:
            return times, True
        time, i, j = min(flights)
        x, now = [a + time * b for a, b in zip(x, v, strict=True)], now + time
        push = (1 + scene.r) * (v[i] - v[j]) / (m[i] + m[j])
        v[i], v[j] = v[i] - push * m[j], v[j] + push * m[i]
        times.append(now)
    return times, False


@pytest.mark.parametrize("seed", range(40))
def test_masses_on_a_line(seed: int) -> None:
    """The threshold is 4r = (1+r)²/((1 + m_o/m_s)(1 + m_o/m_c)); exact numbers never disagree."""
    choice = random.Random(f"masses-on-a-line-{seed}")
    m = [Fraction(choice.randrange(1, 200), choice.randrange(1, 20)) for _ in range(3)]
    radii = [Fraction(choice.randrange(3, 8), 10) for _ in range(3)]
    share = float(1 / ((1 + m[0] / m[1]) * (1 + m[0] / m[2])))
    r = Fraction(choice.randrange(1, 1000), 1000)
    if choice.random() < 0.5:  # near the threshold, where share r² + 2(share - 2) r + share = 0
        root = (2 - share - 2 * (1 - share) ** 0.5) / share
        r = Fraction(int(root * choice.choice([0.9, 0.99, 1.02, 1.1]) * 10**6) + 1, 10**6)
    x = [0, radii[0] + radii[1] + choice.randrange(1, 9), -radii[0] - radii[2] - Fraction(98, 97)]
    v = [
        Fraction(choice.randrange(-9, 10), 30),
        Fraction(-choice.randrange(1, 20), 10),
        Fraction(1),
    ]
    places, speeds = ((Fraction(a),) for a in x), ((Fraction(a),) for a in v)
    scene = Scene(r, tuple(places), tuple(speeds), bodies=Bodies(tuple(m), tuple(radii)))
    found = decide_scene(scene)
    times, is_end = exact_collisions(scene, 60 if found.collapse else found.collisions + 1)
    if found.collapse is None:
        assert (found.verdict, is_end, len(times)) == (DISPERSES, True, found.collisions)
        with balls.precision(256):
            flow = Flow(scene, 256)
            run = follow_line(flow, 400) if flow.advance() else None
        assert run is None or (run.ends, run.collisions) == (True, len(times))
        assert (run is None) == (not times)
        return
    assert (found.verdict, is_end) == (COLLAPSES, False)
    assert 4 * r < (1 + r) ** 2 / ((1 + m[0] / m[1]) * (1 + m[0] / m[2]))
    low, high = (balls.ends(balls.as_ball(end)) for end in found.collapse.time)
    assert low[0] <= times[found.collisions - 1] <= times[-1] <= high[1]
