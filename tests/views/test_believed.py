"""What is believed, and what Coq proves: the line on the terminal, and the table of the pages."""

from __future__ import annotations

import json
import re
from collections.abc import Iterator
from typing import Any

import pytest

from docs.generated import JUDGES, ROOT, RUNS, believed, believed_and_proved, sharper_givens
from verify.cli import main
from verify.paper.commands import pages

#: What Coq proves of the sentences of the classification.
OF_CLASSIFICATION = (
    "cauchy-schwarz, bounded-monotone, finite-length, glue-lemma, glue-classification, "
    "glue-run, glue-impulse, glue-endless, glue-scenes, glue-second"
)


def line(capsys: pytest.CaptureFixture[str], *words: str) -> str:
    """The sentence that a command prints on what is believed."""
    assert main([*words]) == 0
    out = " ".join(capsys.readouterr().out.split())
    return "Uses " + out.partition("Uses ")[2].partition(" Their text:")[0]


def test_coq_has_proved_all_but_the_definition_of_the_step(
    capsys: pytest.CaptureFixture[str],
) -> None:
    expected = (
        "Uses 9 assumptions. 1 is believed: hard-spheres (definition). 8 are proved in Coq: "
        "cauchy-schwarz, bounded-monotone, finite-length, open-condition, glue-next, "
        "glue-collapse, glue-angle, glue-interior."
    )
    assert line(capsys, "theorem1", "--r", "0.03").startswith(expected)
    assert line(capsys, "theorem1", "--all") == expected


@pytest.mark.parametrize(
    "words", [["theorem1", "--all"], ["spectrum"], ["classification"], ["elsewhere"]]
)
def test_the_parts_add_up_to_what_the_verdict_is_given(
    capsys: pytest.CaptureFixture[str], words: list[str]
) -> None:
    """One counting: believed, proved in Coq and not needed are all that the verdict counts."""
    found = line(capsys, *words)
    total, *parts = map(int, re.findall(r"(?:Uses|\.) ([0-9]+)(?= \w)", found))
    main([*words])
    verdict = " ".join(capsys.readouterr().out.split()).partition("; given ")[2]
    assert total == sum(parts) == sum(map(int, re.findall(r"(\d+) assumption", verdict)))


def test_what_coq_has_not_proved_is_believed(capsys: pytest.CaptureFixture[str]) -> None:
    found = line(capsys, "classification")
    assert found.startswith("Uses 14 assumptions. 4 are believed: ")
    believed, _, proved = found.partition(" 10 are proved in Coq: ")
    assert proved == f"{OF_CLASSIFICATION}."
    assert believed.endswith("glue-null.")
    assert "smooth-images" in believed


def test_what_coq_proves_of_a_cited_theorem_needs_none_of_its_sentences(
    capsys: pytest.CaptureFixture[str],
) -> None:
    found = line(capsys, "spectrum")
    believed, _, proved = found.partition(" 10 are proved in Coq: ")
    assert believed == (
        "Uses 26 assumptions. 4 are believed: collision-law (definition), linear-model "
        "(definition), hard-spheres (definition), alternating-run (definition)."
    )
    assert proved.endswith(
        "no-triangular-collapse. 12 are not needed: the others of classification, as Coq proves "
        "what is used of it."
    )
    # One word in both: the five sentences that are mere glue are theorems in Coq.
    assert main(["spectrum"]) == 0
    text = " ".join(capsys.readouterr().out.split())
    assert main(["spectrum", "--json"]) == 0
    document = json.loads(capsys.readouterr().out)
    assert "Verdict: proved: Spectral claims" in text
    assert document["headline"] == document["verdict"] == "proved"


def test_the_first_screen_says_that_coq_refutes_the_printed_sign(
    capsys: pytest.CaptureFixture[str],
) -> None:
    for words in (["--r", "0.03"], ["--all"]):
        main(["theorem1", *words])
        first = " ".join(capsys.readouterr().out.split()).partition("With >")[0]
        assert first.endswith(" As printed, with <: refuted (Coq), certificates/printed-sign ")


def test_the_table_of_the_pages_says_the_same() -> None:
    lines = believed_and_proved().split("\n")[2:]
    rows = [[cell.strip() for cell in text.split("|")[1:-1]] for text in lines]
    table = {row[0]: row[2:] for row in rows if row[1] != "Coq"}
    assert [*table] == [*RUNS]
    assert table["theorem1 --all"][2] == "hard-spheres (definition)"
    assert table["theorem1 --r R"] == table["theorem1 --all"]
    assert table["separatrix --all"][2] == "limit-map (definition), unending (definition)"
    assert table["map"][0] == "the theorems, not the log"
    assert table["classification"][1] == OF_CLASSIFICATION
    assert table["the printed sign, which makes the theorem false"][1:] == [
        "glue-as-printed", "hard-spheres (definition), alternating-run (definition)",
    ]  # fmt: skip
    assert not re.search("glue|spiral", table["spectrum"][2])
    assert "FiniteScenes.finite_after" in table["scene: finite"][2]
    assert "Runs.collapses_after" in table["scene: collapses"][2]
    theorems = [row[3].partition(": ")[2] for row in rows if row[1] == "Coq"]
    assert len(theorems) == 3
    for theorem in theorems:
        file, _, name = theorem.strip("`").partition(".")
        assert name in (ROOT / "verify" / "coq" / f"{file}.v").read_text(encoding="utf-8")


#: Commands of each kind that is told of in README.md.
SHOWN = {
    "`verify theorem1 --r R`, `verify scene`": (
        "theorem1 --r 0.03",
        "scene {scenes}/in-space.toml",
    ),
    "either with `--out` (except many balls), and all commands not named here": (
        "scene {scenes}/in-space.toml --out {out}/scene",
        "theorem1 --all",
        "theorem1 --r 0.02..0.03",
        "spectrum",
        "classification",
        "elsewhere",
        "separatrix --all",
        "prove {examples}/mean/statement.json",
    ),
    "`verify map`": ("map phi --r 0.03 --undecided 20%",),
    "`verify separatrix` without `--all` and `--out`": ("separatrix --r 0.03 --at 1/10",),
}


def judges(document: Any) -> Iterator[str]:
    """Who judged what a document says."""
    inner: Any = ()
    if isinstance(document, dict):
        yield from (document[key] for key in ("judged_by", "judge") if document.get(key))
        inner = document.values()
    elif isinstance(document, list):
        inner = document
    for part in inner:
        yield from judges(part)


@pytest.mark.parametrize("run", JUDGES)
def test_who_judges_what_one_runs(
    run: str, tmp_path: Any, capsys: pytest.CaptureFixture[str]
) -> None:
    places = {"scenes": ROOT / "certificates/scenes", "examples": ROOT / "certificates/examples"}
    for words in SHOWN[run]:
        assert main([*words.format(**places, out=tmp_path).split(), "--json"]) == 0
        found = {judge.partition(",")[0] for judge in judges(json.loads(capsys.readouterr().out))}
        others = {judge for one, judge in JUDGES.items() if one != run}
        assert JUDGES[run] in found, words
        assert not found & others, words


def test_a_point_with_a_certificate_is_judged_by_the_checker(
    tmp_path: Any, capsys: pytest.CaptureFixture[str]
) -> None:
    out = str(tmp_path / "point")
    assert main(["theorem1", "--r", "0.03", "--out", out]) == 0
    assert main(["check", out]) == 0
    assert "proved" in capsys.readouterr().out


def test_the_readme_has_the_table() -> None:
    assert SHOWN.keys() == JUDGES.keys()
    assert f"\n\n{believed()}\n\n" in (ROOT / "README.md").read_text(encoding="utf-8")


def test_all_that_the_sharper_theorem_asks_is_on_its_page() -> None:
    givens = pages.statement("sharper").context("start").claims

    lines = sharper_givens().split("\n")[2:]
    assert [line.split("`")[1] for line in lines] == [*givens]
    assert "| `speed-start` | η₀ ≤ V₀ |" in lines
