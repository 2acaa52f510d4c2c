"""The record of what Coq has checked, and that the page counts no file that has changed since."""

from __future__ import annotations

import json
import re
from types import SimpleNamespace
from typing import Any

import pytest

from docs import generated
from docs.generated import believed_and_proved
from tests.coq.closing import BALLS
from tests.coq.everything import SAYS, SCENES
from tests.coq.record import RECORD, theorems
from verify.views.findings import CoqRecord
from verify.views.page.build import checked_in_coq
from verify.wire.packaged import checked


def said(digests: list[dict[str, str]]) -> str:
    """The cell of the page for certificates with these digests."""
    folders = [
        SimpleNamespace(name=f"number {i}", digests=pair) for i, pair in enumerate(digests, 1)
    ]
    record = checked()
    coq = CoqRecord(record.version, {one.name: record.has(one.digests) for one in folders})
    material: Any = SimpleNamespace(folders=folders, coq=coq)
    return checked_in_coq(material)


def test_the_record_is_read() -> None:
    record = json.loads(RECORD.read_text())
    found = checked()
    assert re.fullmatch(r"8\.\d+\.\d+", found.version)
    assert len(found.pairs) == len(record["certificates"]) > 30
    assert record["counts"].keys() == {"controls", "lies"}
    for words in record["counts"].values():
        assert re.match(r"[1-9]\d\d+, 0 with another verdict, ", words)
    for item in record["certificates"]:
        assert (RECORD.parents[2] / item["folder"] / "statement.json").exists()


def test_where_coq_has_a_theorem_on_the_balls_no_sentence_is_believed() -> None:
    record = json.loads(RECORD.read_text())["certificates"]
    theorems = {item["folder"]: item["theorem"] for item in record if "theorem" in item}
    assert theorems == {f"certificates/{name}": SAYS[name] for name in BALLS}
    lines = [line.strip("|").split(" | ") for line in believed_and_proved().splitlines()[2:]]
    scenes = {line[0].strip(): line[4].strip() for line in lines if "scene: " in line[0]}
    assert len(scenes) == len(SCENES)
    for said, theorem in zip(sorted(scenes.values()), sorted(SCENES), strict=True):
        assert said == f"that `{theorem}` says what is meant (definition)"


def test_what_coq_proves_from_definitions_is_in_the_record(
    monkeypatch: pytest.MonkeyPatch,
) -> None:
    record = json.loads(RECORD.read_text())
    assert record["theorems"] == theorems()
    assert {*generated.FROM_DEFINITIONS.values()} <= {*theorems()}
    names = [line.split(" | ")[0] for line in believed_and_proved().splitlines()]
    monkeypatch.setattr(generated, "in_coq", lambda: record | {"theorems": []})
    fewer = [line.split(" | ")[0] for line in believed_and_proved().splitlines()]
    assert len(names) == len(fewer) + len(generated.FROM_DEFINITIONS)


def test_without_the_record_the_sentences_are_believed(monkeypatch: pytest.MonkeyPatch) -> None:
    record = json.loads(RECORD.read_text())
    for item in record["certificates"]:
        item.pop("theorem", None)
    monkeypatch.setattr(generated, "in_coq", lambda: record)
    (finite,) = (line for line in believed_and_proved().splitlines() if "scene: finite" in line)
    assert "scene-finite" in finite.split(" | ")[4]


def test_a_file_that_has_changed_is_not_counted() -> None:
    (statement, certificate), *_ = checked().pairs
    right = {"statement.json": statement, "certificate.json": certificate}
    assert said([right]).startswith("accepted all 1 certificates, with Coq 8.")
    for name in right:
        text = said([right, {**right, name: "0" * 64}])
        assert text.startswith("accepted 1 of 2 certificates, with Coq 8.")
        assert text.endswith("; not number 2, which it cannot read or which may have changed since")
