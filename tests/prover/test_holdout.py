"""Published inequalities that are not those of `bench`: each is decided, rightly, and checked.

`holdout.json` has them with their sources, in the same format. The suite takes each third of them;
with ``HEAVY=all``, as in CI, all of them.
"""

from __future__ import annotations

import json
import os
from pathlib import Path
from typing import Any

import pytest

from verify.language.statement import PROVED, REFUTED
from verify.measure.inequalities import entries, judge

HOLDOUT: list[dict[str, Any]] = json.loads(
    (Path(__file__).parent / "holdout.json").read_text(encoding="utf-8")
)
CHOSEN = HOLDOUT[:: 1 if os.environ.get("HEAVY") == "all" else 3]


def test_they_are_others() -> None:
    known = [(entry["variables"], entry["claim"]) for entry in entries()]
    assert not [e["name"] for e in HOLDOUT if (e["variables"], e["claim"]) in known]
    assert {entry["truth"] for entry in HOLDOUT} == {True, False}


@pytest.mark.parametrize("entry", CHOSEN, ids=[entry["name"] for entry in CHOSEN])
def test_decided(entry: dict[str, Any]) -> None:
    found = judge(entry, 60)
    assert found.verdict == (PROVED if entry["truth"] else REFUTED)
    assert found.accepted, found.why
