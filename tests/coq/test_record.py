"""The record of what Coq has checked, and that the page counts no file that has changed since."""

from __future__ import annotations

import json
import re
from types import SimpleNamespace
from typing import Any

from tests.coq.record import RECORD
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


def test_a_file_that_has_changed_is_not_counted() -> None:
    (statement, certificate), *_ = checked().pairs
    right = {"statement.json": statement, "certificate.json": certificate}
    assert said([right]).startswith("accepted all 1 certificates, with Coq 8.")
    for name in right:
        text = said([right, {**right, name: "0" * 64}])
        assert text.startswith("accepted 1 of 2 certificates, with Coq 8.")
        assert text.endswith("; not number 2, which it cannot read or which may have changed since")
