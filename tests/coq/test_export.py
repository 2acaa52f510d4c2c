"""What is exported for Coq is what the files say, read by another way; and what is not exported."""

from __future__ import annotations

import json
import re
import shutil
from fractions import Fraction
from hashlib import sha256
from pathlib import Path

import pytest

from tests.coq.closing import unread
from tests.coq.everything import (
    COLLAPSING,
    DISPERSING,
    FINITE,
    OWN_SCENES,
    POINTS,
    collapsing,
    dispersing,
    finite,
    followed,
    scene_file,
)
from tests.coq.readback import Exported, Interner, Written
from tests.lies.lies import honest
from verify import check
from verify.cli import main
from verify.wire.coq.export import export
from verify.wire.coq.named import called, named
from verify.wire.coq.reading import NotAcceptedError

ROOT = Path(__file__).resolve().parents[2]
FOLDERS = sorted(path.parent for path in (ROOT / "certificates").rglob("certificate.json"))


@pytest.mark.parametrize("folder", FOLDERS, ids=lambda folder: folder.name)
def test_the_definitions_say_what_the_statement_says(folder: Path) -> None:
    """What Coq cannot read is known."""
    (found,) = check.read_folders([str(folder)])
    if folder in unread():
        with pytest.raises(NotAcceptedError, match=f"^{re.escape(unread()[folder])}$"):
            export(found)
        return
    text = export(found)
    assert f"SHA-256 {sha256(found.statement).hexdigest()}, which Coq\n" in text
    intern = Interner()
    exported = Exported(text, intern)
    available = {sha256(data).hexdigest(): data for data in found.cited}
    written = Written(json.loads(found.statement), available, intern)
    assert exported.said == written.said
    assert [*map(int, exported.own)] == written.own
    assert not re.search(r"Axiom|Admitted|Parameter|Hypothesis [a-z]", text)


def test_another_term_is_seen() -> None:
    pair = honest()
    text = export(check.Folder("", *pair.files(), []))
    document = json.loads(pair.files()[0])
    for other in (text.replace("NMul", "NAdd", 1), text.replace("Less", "AtMost", 1)):
        intern = Interner()
        assert other != text
        assert Exported(other, intern).said != Written(document, {}, intern).said


@pytest.mark.parametrize("other", [b"{}", b"square"])
def test_what_cites_a_refused_certificate_is_not_exported(
    capsys: pytest.CaptureFixture[str], tmp_path: Path, other: bytes
) -> None:
    folder = tmp_path / "applied"
    shutil.copytree(ROOT / "certificates/examples/mean-applied", folder)
    assert main(["export", "coq", str(folder)]) == 0
    beside = folder / "cited/mean.certificate.json"
    honest = beside.read_bytes()
    beside.write_bytes(honest.replace(other, b"root") if other in honest else other)
    capsys.readouterr()
    assert main(["export", "coq", str(folder)]) == 2
    captured = capsys.readouterr()
    assert (captured.out, captured.err.count("\n")) == ("", 1)
    assert "cited certificate" in captured.err


def test_what_is_not_accepted_is_not_exported(
    capsys: pytest.CaptureFixture[str], tmp_path: Path
) -> None:
    source = ROOT / "certificates/examples/interval"
    assert main(["export", "coq", str(source)]) == 0
    assert "Theorem proved" in capsys.readouterr().out
    certificate = (source / "certificate.json").read_bytes()
    (tmp_path / "statement.json").write_bytes((source / "statement.json").read_bytes())
    for other in (certificate.replace(b'"64"', b'"0"').replace(b": 64", b": 2"), b"{}", b""):
        (tmp_path / "certificate.json").write_bytes(other)
        assert main(["export", "coq", str(tmp_path)]) == 2
        captured = capsys.readouterr()
        assert captured.out == ""
        assert captured.err.count("\n") == 1
    assert main(["export", "lean", str(source)]) == 2
    assert main(["export", "coq", str(tmp_path / "nothing")]) == 2


def test_the_readable_form_has_a_lemma_for_every_row(capsys: pytest.CaptureFixture[str]) -> None:
    for folder in ("define", "witness", "interval", "induction", "mean-applied", "maximum"):
        path = ROOT / "certificates/examples" / folder
        assert main(["export", "coq", "--readable", str(path)]) == 0
        text = capsys.readouterr().out
        statement = json.loads((path / "statement.json").read_bytes())
        lemmas = re.findall(r"^Lemma (\S+) :", text, re.MULTILINE)
        assert len(lemmas) == len({*lemmas})
        for row in statement["obligations"]:
            name = re.sub("[^A-Za-z0-9_]", "_", row["name"])
            undecided = row["verdict"] == "undecided"
            found = [lemma for lemma in lemmas if lemma.rstrip("_").removeprefix("its_") == name]
            assert len(found) == (not undecided), row["name"]
            assert not undecided or f"{row['name']} is undecided" in text


def test_names_of_the_readable_form_are_those_of_nothing_else(
    tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    """A row may be called like what the file defines beside it, or needs."""
    used = [
        "proved",
        "Definition",
        "says",
        "ordered",
        "one_more",
        "proved_row",
        "Forall",
        "said_row",
        "rows",
    ]
    rows = [*used, "a_is", "a", "a_is_is", "b", "b_is", "row_of_a", "all_values", "values_1"]
    lines = ["title = 't'", "[constants]", "right_values = '1'", "c_is = '2'", "c = '3'", "[rows]"]
    page = tmp_path / "p.toml"
    page.write_text("\n".join([*lines, *(f"{row} = 'c_is < c'" for row in rows)]))
    assert main(["prove", str(page), "--out", str(tmp_path / "p")]) == 0
    capsys.readouterr()
    assert main(["export", "coq", "--readable", str(tmp_path / "p")]) == 0
    text = re.sub(r"\(\*.*?\*\)", "", capsys.readouterr().out, flags=re.DOTALL)
    named = re.findall(r"^(?:Definition|Lemma|Theorem) (\w+)", text, re.MULTILINE)
    assert len(named) == len({*named})
    readable = text[text.index("Definition the_table") :]
    lemmas = re.findall(r"^Lemma (\w+) : [^.]*<[^.]*\.$", readable, re.MULTILINE)
    assert len(lemmas) == len(rows)
    assert all(len(re.findall(rf"\b{lemma}\b", readable)) == 1 for lemma in lemmas)


def test_a_point_run_ends_in_a_theorem_on_three_balls(capsys: pytest.CaptureFixture[str]) -> None:
    path = ROOT / "certificates/theorem1-r-3-100"
    assert main(["export", "coq", "--balls", str(path)]) == 0
    text = " ".join(capsys.readouterr().out.split())
    said = " ".join(" ".join(POINTS[:5]).partition(" : ")[2].partition(" :=")[0].split())
    assert f"Theorem three_balls : {said}. Proof." in text
    assert text.endswith("Qed. Print Assumptions three_balls.")


@pytest.mark.parametrize("folder", ["theorem1-all", "step", "flow"])
def test_other_statements_have_no_such_theorem(
    folder: str, capsys: pytest.CaptureFixture[str]
) -> None:
    assert main(["export", "coq", "--balls", str(ROOT / "certificates" / folder)]) == 2
    err = capsys.readouterr().err
    assert "does not apply the step" in err
    assert "Traceback" not in err


def test_a_collision_at_the_start_has_no_such_theorem(
    tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    """In Coq a collision happens after a time; a file that does not compile was written once."""
    scene, folder = tmp_path / "scene.toml", str(tmp_path / "made")
    scene.write_text(
        "r = 0.03\npositions = [[0, 0], [1, 0], [-3, 0]]\n"
        "velocities = [[0.1, 0], [-0.1, 0], [-1, 0]]\n"
    )
    assert main(["scene", str(scene), "--out", folder]) == 0
    assert "after 1 collision" in capsys.readouterr().out
    assert main(["export", "coq", folder]) == 0
    capsys.readouterr()
    assert main(["export", "coq", "--balls", folder]) == 2
    out, err = capsys.readouterr()
    assert not out
    assert "two balls touch and collide at once" in err


def scene_folder(name: str, made: Path) -> str:
    """The certificate of a scene: a committed one, or one that is made."""
    if scene_file(name).parent != OWN_SCENES:
        return str(ROOT / "certificates/scenes" / name)
    assert main(["scene", str(scene_file(name)), *followed(name), "--out", str(made)]) == 0
    return str(made)


def theorem_of(name: str, path: Path, capsys: pytest.CaptureFixture[str]) -> tuple[str, str]:
    """What is exported of a scene, and what its theorem says."""
    folder = scene_folder(name, path / "made")
    capsys.readouterr()
    assert main(["export", "coq", "--balls", folder]) == 0
    text = " ".join(capsys.readouterr().out.split())
    return text, text.partition("Theorem three_balls : ")[2].partition(". Proof.")[0]


@pytest.mark.parametrize(
    ("name", "criterion"),
    [*zip(FINITE, ("restitution", "momentum", "turning", "turning", "receding"), strict=True)],
)
def test_a_scene_with_finitely_many_collisions_ends_in_its_theorem(
    name: str, criterion: str, tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    text, said = theorem_of(name, tmp_path, capsys)
    assert f"finite_by_{criterion}" in text
    assert said.startswith("FiniteScenes.finite_after ")
    pairs = enumerate(FINITE[name].split(), 1)
    listed = "; ".join(f"(Theorem1.B{i}, Theorem1.B{j}, the_time_{n})" for n, (i, j) in pairs)
    assert said.endswith(f" the_scene_0 [{listed}]")
    places = finite(name).partition("Theorem1.Scene ")[2].partition(") (fun")[0]
    assert f"Definition the_scene_0 : Theorem1.scene := Theorem1.Scene {places}" in text


@pytest.mark.parametrize("name", DISPERSING)
def test_a_scene_that_disperses_ends_in_its_theorem(
    name: str, tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    text, said = theorem_of(name, tmp_path, capsys)
    assert re.findall(r"B(\d), Theorem1\.B(\d), ", said) == [
        tuple(x) for x in DISPERSING[name].split()
    ]
    places = dispersing(name).partition("Theorem1.Scene ")[2].partition(") (fun")[0]
    assert f"Definition the_scene_0 : Theorem1.scene := Theorem1.Scene {places}" in text


@pytest.mark.parametrize(
    ("file", "name"),
    [("Step", "step"), ("All", "theorem1-all"), ("Flow", "flow"), ("Almost", "alexander")],
)
def test_the_rows_that_theorems_name_are_exported_and_no_others(file: str, name: str) -> None:
    (folder,) = check.read_folders([str(ROOT / "certificates" / name)])
    text, whole = named(file, folder), export(folder, ordinary=True)
    words = called(file)
    assert words
    assert [word for word in words if not re.search(rf"\b{word}\b", text)] == []
    rows, all_rows = (set(re.findall(r"^Definition row_of_(\w+) ", x, re.M)) for x in (text, whole))
    assert rows < all_rows
    assert {row for row in all_rows if {row, f"row_of_{row}", f"row_of_{row}_is"} & words} == rows
    assert len(text) < len(whole) * 2 / 3


@pytest.mark.parametrize("name", COLLAPSING)
def test_a_scene_that_collapses_ends_in_its_theorem(
    name: str, tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    text, said = theorem_of(name, tmp_path, capsys)
    collisions, _, after = said.partition("[")[2].partition("] ")
    pairs, roles, bounds = COLLAPSING[name]
    assert re.findall(r"B(\d), Theorem1\.B(\d), ", collisions) == [tuple(x) for x in pairs.split()]
    assert "".join(re.findall(r"Theorem1\.B(\d)", after)) == roles
    assert [Fraction(*map(int, x)) for x in re.findall(r"\((\d+) / (\d+)\)", after)] == [
        Fraction(x) for x in bounds.split()
    ]
    places = collapsing(name).partition("Theorem1.Scene ")[2].partition(") (fun")[0]
    assert f"Definition the_scene_0 : Theorem1.scene := Theorem1.Scene {places}" in text
