"""A scene that the sandwich theorem decides, with its certificate."""

from __future__ import annotations

import json
from functools import cache
from random import Random

from tests.spheres.scene.random_scenes import random_scene
from verify import check
from verify.paper.commands.scene import scene_outcome
from verify.prover import balls
from verify.spheres.flow.collapse import find_collapse
from verify.spheres.scene.decide import Fate, decide_scene
from verify.spheres.scene.verdict import theorems
from verify.wire.write import write

SEED = 2026


@cache
def found() -> Fate:
    """The first of the random scenes that the sharper theorem does not decide so early."""
    rng = Random(SEED)
    while True:
        fate = decide_scene(random_scene(rng))
        if fate.collapse is not None and fate.collapse.stair:
            return fate


def test_it_stops_where_the_sharper_theorem_does_not_apply() -> None:
    fate, now = found(), found().flow.now
    assert theorems(fate) == ["flow", "sandwich"]
    assert now is not None
    with balls.precision(fate.flow.bits):
        assert find_collapse(fate.flow.scene.r, now.state, now.time) is None


def report(change: tuple[str, str] | None = None) -> check.Report:
    """What the checker says, after a change of one number in the statement."""
    files = write(scene_outcome(found(), found().flow.bits))
    statement = json.loads(files["statement.json"])
    certificate = json.loads(files["certificate.json"])
    if change is not None:
        row = next(r for r in statement["obligations"] if r["name"] == change[0])
        row["claim"][2][change[1]] = ["div", row["claim"][2][change[1]], "2"]
    content = json.dumps(statement).encode()
    certificate["statement_sha256"] = check.sha256(content).hexdigest()
    cited = {name: text for name, text in files.items() if name.startswith("cited/")}
    statements = {check.sha256(text).hexdigest(): text for text in cited.values()}
    return check.check(content, json.dumps(certificate).encode(), statements)


def test_its_certificate_is_accepted() -> None:
    assert report().verdict in {"PROVED", "UNDECIDED"}
    assert not [line for line in report().lines if line.startswith("REFUSED")]


def test_a_stair_that_is_too_low_is_refused() -> None:
    for name in ("stair.Q_next", "stair.U_next"):
        lines = report(("stair.0", name)).lines
        assert [line for line in lines if line.startswith("REFUSED stair.0")]
