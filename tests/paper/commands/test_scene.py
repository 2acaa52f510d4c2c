"""Certificates of scenes: accepted as they are, and no other number proves another thing."""

from __future__ import annotations

import copy
import json
import re
from collections.abc import Iterator
from fractions import Fraction
from hashlib import sha256
from pathlib import Path
from random import Random
from typing import Any

import pytest

from tests.spheres.scene import scenes
from tests.spheres.scene.random_scenes import random_scene
from tests.spheres.scene.scenes import CASES, aligned, at_angle
from verify import check
from verify.paper.commands.regenerate import is_right_statement
from verify.paper.commands.scene import read_back, scene_outcome
from verify.spheres.flow.follow import Flow
from verify.spheres.scene.decide import FINITE, UNDECIDED, Budget, decide_scene
from verify.spheres.scene.scene import Scene
from verify.spheres.scene.scene_files import read_scene
from verify.wire.term_json import TermReader
from verify.wire.write import write

SCENES = Path(__file__).resolve().parents[3] / "certificates" / "scenes"
NUMBER = re.compile(r"-?[0-9]+(\.[0-9]+)?(e-?[0-9]+)?(/[0-9]+)?")
#: With more digits, squares of the numbers in `touching` over a common divisor are too long.
SHORT = 6
FEW = Budget(collisions=1)
SLOW = ("below-9", "above", "thousand", "ray", "threshold-0.51", "doubles")


def files_of(scene: Scene, budget: Budget = Budget()) -> dict[str, bytes]:  # noqa: B008
    found = decide_scene(scene, budget)
    return write(scene_outcome(found, found.flow.bits))


def report(files: dict[str, bytes]) -> check.Report:
    cited = {sha256(data).hexdigest(): data for name, data in files.items() if "cited" in name}
    return check.check(files["statement.json"], files["certificate.json"], cited)


@pytest.mark.parametrize(
    "name",
    [name for name, case in CASES.items() if case[1] != UNDECIDED and not name.startswith(SLOW)],
)
def test_certificates_are_accepted(name: str) -> None:
    found = report(files_of(CASES[name][0]))
    assert found.verdict == "PROVED", [line for line in found.lines if "REFUSED" in line]
    assert found.summary.startswith(CASES[name][1])


def finite(name: tuple[str, bool]) -> tuple[Scene, Budget]:
    """A scene that is not followed to its end, with the reason why it does not collapse."""
    rng = Random(11)
    while True:
        scene, budget = random_scene(rng), Budget(collisions=rng.choice((0, 1)))
        criterion = decide_scene(scene, budget).criterion
        if criterion is not None and (criterion.name, criterion.at_start) == name:
            return scene, budget


REASONS = [("receding", True), ("receding", False), ("turning", True), ("turning", False)]


@pytest.mark.parametrize("name", REASONS)
def test_finite_for_each_reason(name: tuple[str, bool]) -> None:
    scene, budget = finite(name)
    files = files_of(scene, budget)
    found = report(files)
    assert found.verdict == "PROVED"
    assert found.summary.startswith("finite: ")
    rows = [row["name"] for row in json.loads(files["statement.json"])["obligations"]]
    assert {"finite.far", f"finite.{name[0]}"} <= {*rows}
    assert decide_scene(scene).verdict in ("disperses", "finite")


def test_finite_by_the_coefficient_of_restitution() -> None:
    scene, budget = CASES["threshold-0.46"][0], Budget(collisions=1)
    assert decide_scene(scene, budget).verdict == UNDECIDED
    files = files_of(scene._replace(r=scene.r * 50), budget)
    assert report(files).verdict == "PROVED"
    assert b'"finite.restitution"' in files["statement.json"]


def test_finite_by_the_angular_momentum() -> None:
    """At r > 9 - 4√5 = 0.0557280900008…, where L is not 0; nothing is said of other scenes."""
    found = decide_scene(CASES["above-9-4√5"][0], Budget(collisions=1))
    assert (found.verdict, found.name) == (FINITE, "momentum")

    def accepted(r: str, scene: Scene = found.flow.scene) -> bool:
        """As it would be written by a program that says it of any scene."""
        scene = scene._replace(r=Fraction(r))
        lie = found._replace(flow=Flow(scene, found.flow.bits))
        return report(write(scene_outcome(lie, 4 * lie.flow.bits))).verdict == "PROVED"

    assert accepted("0.0558")
    assert accepted("0.0557280901")
    assert not accepted("0.05572809")
    assert not accepted("0.0558", CASES["without-angular-momentum"][0])
    assert decide_scene(found.flow.scene._replace(r=Fraction("0.05572809")), FEW).name == "budget"
    for name in ("without-angular-momentum", "a-thousand-on-a-line"):
        assert decide_scene(CASES[name][0]._replace(r=Fraction("0.06")), FEW).name != "momentum"


def test_random_scenes_with_every_kind_of_move() -> None:
    """Collisions, another central particle, and a cut of a flight in which two pass each other."""
    rng, kinds = Random(5), set[str]()
    while kinds < {"collide", "recentre", "drift"}:
        found = decide_scene(random_scene(rng))
        new = {move.kind for move in found.flow.moves} - kinds
        if new:
            assert report(write(scene_outcome(found, found.flow.bits))).verdict == "PROVED"
        kinds |= new


def touching(digits: int) -> Scene:
    """Two that touch in a direction with so many digits, and part; the third one is far away."""
    t = Fraction(10**digits // 3, 10**digits)
    way = ((1 - t**2) / (1 + t**2), 2 * t / (1 + t**2))
    still = (Fraction(0), Fraction(0))
    return Scene(Fraction(3, 100), (still, way, (Fraction(-9), t)), (still, way, still))


@pytest.mark.parametrize("digits", range(1, 20))
def test_what_follows_from_long_numbers_is_a_row_of_its_own(digits: int) -> None:
    """An exact contact is seen by intervals as long as they keep the numbers."""
    files = files_of(touching(digits))
    assert report(files).verdict == "PROVED"
    proofs = json.loads(files["certificate.json"])["steps"]
    rows = {
        step["obligation"]: check.rule_of(step["proof"], check.RULES | check.APPLYING)
        for step in proofs
        if "obligation" in step
    }
    others = {name: rule for name, rule in rows.items() if not name.startswith("end.")}
    starts = {f"start.{pair}": "interval" for pair in ("01", "02", "12")}
    if digits <= SHORT:
        assert others == starts
    else:
        assert len(others) > len(starts)
        assert {*others.values()} == {"sum"}


def test_many_collisions_fit() -> None:
    """At about this size 1000 collisions stay below the checker's limits of bytes and of work."""
    files = files_of(at_angle(0.47, "1e-20"))
    names = re.findall(rb'"name": "collision\.([0-9]+)"', files["statement.json"])
    assert len(names) > 60
    assert report(files).verdict == "PROVED"
    for name in ("statement.json", "certificate.json"):
        assert len(files[name]) / len(names) * 1000 < check.MAX_BYTES


def numbers(value: Any) -> Iterator[tuple[Any, Any]]:
    """Each place in a document where a number stands, but for the bits of enclosures."""
    items = value.items() if isinstance(value, dict) else enumerate(value)
    for key, item in items:
        if isinstance(item, dict | list):
            yield from numbers(item)
        elif isinstance(item, str) and NUMBER.fullmatch(item):
            yield value, key


def changed(item: str, rng: Random) -> str:
    """The number with another digit."""
    places = [i for i, digit in enumerate(item) if digit.isdigit()]
    i = rng.choice(places)
    return item[:i] + str((int(item[i]) + rng.randint(1, 9)) % 10) + item[i + 1 :]


def corrupted(files: dict[str, bytes], name: str, rng: Random) -> dict[str, bytes]:
    """The files with another number in one of them, and the digest that fits."""
    documents = {key: json.loads(files[f"{key}.json"]) for key in ("statement", "certificate")}
    before = copy.deepcopy(documents)
    while documents == before:
        holder, key = rng.choice([*numbers(documents[name])])
        holder[key] = changed(holder[key], rng)
    first = json.dumps(documents["statement"]).encode()
    if name == "statement":
        documents["certificate"]["statement_sha256"] = sha256(first).hexdigest()
    else:
        first = files["statement.json"]
    second = json.dumps(documents["certificate"]).encode()
    return files | {"statement.json": first, "certificate.json": second}


@pytest.mark.parametrize("seed", range(12))
def test_another_number_in_the_certificate_proves_nothing_else(seed: int) -> None:
    files = files_of(aligned())
    try:
        found = report(corrupted(files, "certificate", Random(seed)))
    except check.Malformed:
        return
    assert found.digest == report(files).digest


#: The first collision is at 1/700.
TIME_LIE = tuple(
    f'["0.001428571428571428{low}", "0.001428571428571428{low + 1}"]'.encode() for low in (5, 6)
)


def test_numbers_of_a_certificate_matter() -> None:
    files = files_of(aligned())
    for lie in ((b'"proof": 128', b'"proof": 4'), TIME_LIE):
        assert lie[0] in files["certificate.json"]
        found = files | {"certificate.json": files["certificate.json"].replace(*lie)}
        assert report(found).verdict == "REFUSED"


@pytest.mark.parametrize("seed", range(12))
def test_another_number_in_the_statement_is_refused_or_is_not_ours(seed: int) -> None:
    files = corrupted(files_of(aligned()), "statement", Random(seed))
    try:
        if report(files).verdict != "PROVED":
            return
    except check.Malformed:
        return
    assert not is_right_statement(files["statement.json"])


def test_a_statement_is_recognised_whatever_the_digits() -> None:
    for budget in (Budget(), Budget(digits=9)):
        content = files_of(aligned(), budget)["statement.json"]
        assert is_right_statement(content)
        assert not is_right_statement(content.replace(b"collapses", b"disperses"))


@pytest.mark.parametrize("collisions", [3, 5, 6])
def test_a_collapse_that_is_not_followed_far_enough_has_a_certificate(collisions: int) -> None:
    files = files_of(aligned(), Budget(collisions, digits=20))
    assert report(files).verdict == "PROVED"
    assert is_right_statement(files["statement.json"])


def test_a_statement_is_recognised_however_many_collisions_were_asked_for() -> None:
    for name in REASONS:
        found, budget = finite(name)
        assert is_right_statement(files_of(found, budget)["statement.json"])


@pytest.mark.parametrize("r", ["-1", "0", "1.001", "2", "20"])
def test_scenes_that_no_file_may_hold_are_not_ours(r: str) -> None:
    rest = ((0, 0), (2, 0), (0, 2)), ((0, 0), (0, 0), (0, 0))
    files = files_of(scenes.scene(r, *rest))
    assert report(files).verdict == "PROVED"
    assert not is_right_statement(files["statement.json"])


def test_finitely_many_collisions_need_a_coefficient_below_one() -> None:
    """With r = 20, nearly on a line, there are very many in finite time, though R² grows."""
    endless = scenes.scene("20", ((0, 0), ("1.1", 0), (-3, "1e-90")), ((0, 0), (-1, 0), (-1, 0)))
    files = files_of(endless, Budget(15))
    assert b'"finite.receding"' in files["statement.json"]
    found = report(files)
    assert found.verdict == "REFUSED"
    assert [line.split()[1] for line in found.lines if "REFUSED" in line] == ["range.high"]


#: The scenes in `certificates/scenes` that are decided; a bead is lighter than its neighbours.
EXAMPLES = ["nearly-aligned", "in-space", "on-a-line", "parting", "passing",
            "bead", "light-bead", "small-bead"]  # fmt: skip


@pytest.mark.parametrize("name", EXAMPLES)
def test_the_examples_are_those_of_the_files(name: str) -> None:
    scene = read_scene(name, (SCENES / f"{name}.toml").read_bytes())
    stored = json.loads((SCENES / name / "statement.json").read_text())
    assert read_back(TermReader().table(stored["parameters"])) == scene
    assert stored["title"] == json.loads(files_of(scene)["statement.json"])["title"]
