"""The table of what each technique finds is about the techniques that there are."""

from __future__ import annotations

from tests.measure.techniques import TABLE, Counts, collections, names
from verify.measure.inequalities import entries, question


def test_the_table_has_the_techniques_in_their_order() -> None:
    lines = TABLE.read_text(encoding="utf-8").splitlines()
    rows = [line.split(" | ") for line in lines if line.startswith("| ")]
    assert [row[0].removeprefix("| ") for row in rows[1:-1]] == names()
    assert rows[0][1:] == [*list(collections())[:-1], f"{list(collections())[-1]} |"]


def test_rows_and_lemmas_are_counted() -> None:
    entry = next(entry for entry in entries() if entry["name"] == "lotka-volterra")
    counts = Counts()
    counts.count((question(entry), {}, 60_000_000))
    assert (counts.asked, counts.proved) == (1, 1)
    assert sum(counts.rows.values()) == 1
    assert counts.rows <= counts.found
    assert {*counts.found} <= {*names()}


def test_each_technique_has_one_name() -> None:
    assert len(names()) == len({*names()}) > 30
