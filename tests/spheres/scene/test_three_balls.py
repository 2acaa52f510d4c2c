"""Scenes of different masses and radii that collapse by the theorem on three balls."""

from __future__ import annotations

import json
from collections import Counter
from collections.abc import Callable
from fractions import Fraction
from functools import cache
from hashlib import sha256
from random import Random
from typing import Any

import pytest

from tests.spheres.scene.agreement import contradictions
from verify import check
from verify.language.statement import PROVED
from verify.paper.commands.regenerate import is_right_statement
from verify.paper.commands.scene import scene_outcome
from verify.prover.outcome import Outcome
from verify.spheres.flow.collapse import LINE, THREE_BALLS
from verify.spheres.flow.contexts import FLOW_OF_BALLS
from verify.spheres.scene.decide import COLLAPSES, DISPERSES, UNDECIDED, Budget, Fate, decide_scene
from verify.spheres.scene.scene import PAIRS, Bodies, Scene, coordinates
from verify.spheres.scene.verdict import central, told
from verify.wire.judge import judged
from verify.wire.write import write

ONE = Fraction(1)
#: What a simulation keeps, and how many collisions are followed.
DIGITS, FEW = 500, Budget(collisions=200)
#: Nearly in line; the bead between the two others is light, or small and light.
BEADS = {
    "light, r = 0.9": ("9/10", (ONE, Fraction(1, 1000), ONE), (Fraction(1, 2),) * 3),
    "light, r = 0.3": ("3/10", (ONE, Fraction(1, 100), ONE), (Fraction(1, 2),) * 3),
    "small, r = 0.8": ("4/5", (ONE, Fraction(27, 8000), ONE), (ONE, Fraction(3, 20), ONE)),
}


def bead(r: str, masses: tuple[Fraction, ...], radii: tuple[Fraction, ...]) -> Scene:
    """The middle ball is 1, in contact with none."""
    left, right = (radii[1] + radii[i] for i in (0, 2))
    aside, zero = Fraction(1, 1000), Fraction(0)
    places = ((-left - Fraction(1, 10), aside), (zero, zero), (right + Fraction(1, 5), zero))
    speeds = ((zero, zero), (Fraction(-1, 10), aside), (-ONE, zero))
    return Scene(Fraction(r), places, speeds, bodies=Bodies(masses, radii))


@pytest.mark.parametrize("name", BEADS)
def test_a_bead_between_two_heavy_balls(name: str) -> None:
    found = decide_scene(bead(*BEADS[name]))
    assert (found.verdict, found.name, central(found)) == (COLLAPSES, THREE_BALLS, 1)
    assert told(found).theorems == [FLOW_OF_BALLS, THREE_BALLS]
    assert contradictions(found, DIGITS) == []


def test_digits_of_the_time_can_be_asked_for() -> None:
    found = decide_scene(bead(*BEADS["small, r = 0.8"]), Budget(digits=20))
    assert found.collapse is not None
    low, high = told(found).time or (Fraction(0), ONE)
    assert 0 < high - low <= low / 10**20
    assert contradictions(found, DIGITS) == []


def random_scene(rng: Random, *, heavy: bool) -> Scene:
    """Ball 0 between two others that come nearly along one line; they are in no contact."""

    def number(low: float, high: float) -> Fraction:
        return Fraction(low * (high / low) ** rng.random()).limit_denominator(10**6)

    dimension = rng.choice((2, 3))
    masses = (number(0.01, 10), number(0.01, 10), number(0.01, 10))
    masses = (masses[0] * 10, *masses[1:]) if heavy else masses
    radii = (number(0.1, 3), number(0.1, 3), number(0.1, 3))
    aside = [[number(1e-4, 0.05) * rng.choice((-1, 1)) for _ in range(dimension)] for _ in range(6)]
    along = (
        Fraction(0), radii[0] + radii[1] + number(0.01, 0.5), -radii[0] - radii[2] - number(1, 2),
    )  # fmt: skip
    rates = (Fraction(0), -number(0.5, 2), number(0.5, 2))
    rows = [(value, *rest[1:]) for value, rest in zip((*along, *rates), aside, strict=True)]
    return Scene(number(1e-3, 0.3), tuple(rows[:3]), tuple(rows[3:]), bodies=Bodies(masses, radii))


def scenes(seed: int, count: int, *, heavy: bool = False) -> list[Scene]:
    """So many scenes without overlap."""
    rng, found = Random(seed), []
    while len(found) < count:
        scene = random_scene(rng, heavy=heavy)
        given = coordinates(scene, Fraction)
        if all(given.pair(i, j).g > 0 for i, j in PAIRS):
            found.append(scene)
    return found


@pytest.mark.parametrize("part", range(4))
def test_random_scenes_nearly_in_line(part: int) -> None:
    """A simulation contradicts none, and few are undecided, with light and with heavy middles."""
    found = [decide_scene(one, FEW) for one in scenes(part, 60, heavy=part % 2 == 1)]
    kinds = Counter(one.verdict for one in found)
    assert [one for one in map(_wrong, found) if one] == []
    assert kinds[COLLAPSES] >= 5
    assert kinds[UNDECIDED] <= 1


def _wrong(found: Fate) -> list[str]:
    return contradictions(found, DIGITS)


# --- certificates --------------------------------------------------------------------------------


def report(outcome: Outcome, change: Callable[[Any], None] = lambda _: None) -> check.Report:
    """What the checker says of a certificate, after a change of its statement."""
    files = write(outcome)
    statement = json.loads(files["statement.json"])
    certificate = json.loads(files["certificate.json"])
    change(statement)
    content = json.dumps(statement).encode()
    certificate["statement_sha256"] = sha256(content).hexdigest()
    cited = [text for name, text in files.items() if name.startswith("cited/")]
    statements = {sha256(text).hexdigest(): text for text in cited}
    return check.check(content, json.dumps(certificate).encode(), statements)


@cache
def certified() -> Outcome:
    """The certificate of a bead."""
    found = decide_scene(bead(*BEADS["light, r = 0.3"]))
    return scene_outcome(found, found.flow.bits)


def is_refused(change: Callable[[Any], None]) -> bool:
    """Whether the checker refuses it after a change."""
    return any(line.startswith("REFUSED") for line in report(certified(), change).lines)


def test_a_certificate_is_accepted() -> None:
    assert not is_refused(lambda _: None)
    assert certified().statement.cites[1].name == THREE_BALLS


#: Upper bounds, which may not be lower; and numbers of the balls and lower bounds, which may not be
#: higher.
LOWERED = ("E_0", "w_0", "w_1", "Y_0", "z_b", "Q_0", "U_0", "Theta", "beta_0", "m_1")
RAISED = ("k_1", "beta_0", "sigma_12", "m_1")


@pytest.mark.parametrize(
    ("number", "factor"), [*((n, "1/3") for n in LOWERED), *((n, "3") for n in RAISED)]
)
def test_a_changed_number_is_refused(number: str, factor: str) -> None:
    def change(statement: Any) -> None:
        (row,) = (row for row in statement["obligations"] if row["name"] == "collapse")
        values = row["claim"][2]
        values[number] = ["mul", values[number], factor]

    assert is_refused(change)


@pytest.mark.parametrize("name", ["m.0", "m.1", "m.2", "R.0", "R.1", "R.2", "r"])
def test_another_ball_is_refused(name: str) -> None:
    """The numbers belong to these masses, radii and r."""

    def change(statement: Any) -> None:
        statement["parameters"][name] = ["mul", statement["parameters"][name], "101/100"]

    assert is_refused(change)


def test_random_certificates_are_accepted() -> None:
    kinds = Counter[str]()
    for scene in scenes(9, 24):
        found = decide_scene(scene, FEW)
        if found.verdict in (COLLAPSES, DISPERSES):
            assert judged(scene_outcome(found, found.flow.bits)).verdict == PROVED
            kinds[found.name] += 1
    assert min(kinds[THREE_BALLS], kinds["apart"]) >= 3


def test_a_line_of_different_balls_has_a_certificate() -> None:
    masses, radii = (ONE, Fraction(1, 5), Fraction(3)), (ONE, Fraction(1, 2), Fraction(2))
    places = tuple((Fraction(x),) for x in (-2, 0, 4))
    speeds = tuple((Fraction(v),) for v in (1, 0, -1))
    found = decide_scene(Scene(Fraction(1, 20), places, speeds, bodies=Bodies(masses, radii)))
    assert (found.verdict, found.name) == (COLLAPSES, LINE)
    assert judged(scene_outcome(found, found.flow.bits)).verdict == PROVED


def test_the_program_recognises_its_own_statement() -> None:
    """It is what the program makes of these masses and radii; a negative mass is that of none."""
    content = write(certified())["statement.json"]
    assert is_right_statement(content)
    statement = json.loads(content)
    statement["parameters"]["m.1"] = "-1/100"
    assert not is_right_statement(json.dumps(statement).encode())
