"""The order of folders changes no report, also beside lies; and nothing of a check stays."""

from __future__ import annotations

import gc
import json
import random
import weakref
from collections.abc import Callable
from hashlib import sha256
from pathlib import Path
from typing import Any

import pytest

from tests.check.support import INTERVAL, Pair, total
from tests.check.test_citations import cited
from tests.citing import cited_in
from tests.lies.lies import LIES
from verify import check

SCENES = Path(__file__).parents[2] / "certificates" / "scenes"
APPLIED = {"rule": "instance", "givens": [INTERVAL]}
#: What a statement adds to what it cites as ``c0``.
MORE: list[Callable[[Pair], Any]] = [
    lambda pair: pair.lemma("more", ["<", "0", "c0:root"], INTERVAL),
    lambda pair: pair.lemma("wrong", ["<", "c0:root", "1"], INTERVAL),
    lambda pair: pair.define("third", ["div", "c0:root", "3"]),
    lambda pair: pair.row("used", ["applies", "c0:free", {"v": "1"}], APPLIED),
    lambda pair: pair.lemma("inside", ["<=", "0", "c0:v"], total("goal", "c0:v-low"), "c0:free"),
    lambda pair: pair,
]


def theorem(statement: bytes) -> str:
    """The theorem of a statement; nothing if it is in no format."""
    try:
        return str(json.loads(statement)["theorem"])
    except (ValueError, TypeError, KeyError):
        return ""


def citing(rnd: random.Random, citable: list[bytes]) -> tuple[Pair, list[bytes]]:
    """A statement that cites one or two others, and what lies beside it."""
    pair, beside = Pair("MAIN"), rnd.sample(citable, rnd.choice([1, 1, 2]))
    for i, data in enumerate(beside):
        item = {"name": f"c{i}", "theorem": theorem(data)}
        pair.statement["cites"].append({**item, "statement_sha256": sha256(data).hexdigest()})
    rnd.choice(MORE)(pair.row("row", "0 <= 1", INTERVAL))
    return pair, beside


def drawn(rnd: random.Random) -> list[check.Folder]:
    """Folders that cite good statements and malformed ones, in one step and in two; and scenes."""
    lies = [lie.files()[0] for lie in rnd.sample([*LIES.values()], 12)]
    citable = [cited().files()[0]] * 30 + lies
    found = check.read_folders([str(path.parent) for path in SCENES.glob("*/statement.json")])
    for _ in range(30):
        pair, beside = citing(rnd, citable)
        found.append(check.Folder("one step", *pair.files(), beside))
        top = Pair("TOP").cite("c0", pair).row("row", "0 <= 1", INTERVAL)
        found.append(check.Folder("two steps", *top.files(), [pair.files()[0], *beside]))
    return found


@pytest.mark.parametrize("seed", range(3))
def test_the_order_of_folders_changes_nothing(seed: int) -> None:
    """Each report is that of a kernel which has read everything itself, with the same work."""
    rnd = random.Random(seed)
    folders = drawn(rnd)
    beside = [data for folder in folders for data in (folder.statement, *folder.cited)]
    available = {sha256(data).hexdigest(): data for data in beside}

    def alone(folder: check.Folder, limit: int = check.MAX_WORK) -> check.Report:
        return check.examined(folder.statement, folder.certificate, available, limit)

    expected = [(folder, alone(folder)) for folder in folders]
    verdicts = {report.verdict for _, report in expected}
    assert verdicts == {"PROVED", "REFUSED", "MALFORMED"}
    for _ in range(3):
        rnd.shuffle(expected)
        found = check.judged([folder._replace(proofs=()) for folder, _ in expected])
        assert [report for report, _ in found] == [report for _, report in expected]


@pytest.mark.parametrize(
    ("work", "verdict"), [(10**6, "PROVED"), (10**5, "MALFORMED"), (300, "MALFORMED")]
)
def test_a_kernel_is_freed_without_looking_for_circles(
    monkeypatch: pytest.MonkeyPatch, work: int, verdict: str
) -> None:
    """The command collects no garbage: in a folder of scenes nothing may pile up.

    Also where it ends early, at a step or at a citation: here by the limit of work. What is cited
    is kept for the next folder, until it is dropped.
    """
    folder = SCENES / "nearly-aligned"
    files = [(folder / f"{name}.json").read_bytes() for name in ("statement", "certificate")]
    seen: list[Any] = []

    class Seen(check.Kernel):
        def __init__(self) -> None:
            super().__init__()
            seen.extend(map(weakref.ref, (self, self.outermost)))

    monkeypatch.setattr(check, "Kernel", Seen)
    gc.disable()
    try:
        check.BEGINNINGS.clear()
        assert check.examined(files[0], files[1], cited_in(folder), work).verdict == verdict
        check.BEGINNINGS.clear()
        assert {item() for item in seen} == {None}
    finally:
        gc.enable()
