"""What `.ci/coq` compares, where no Coq is needed; all of it is done there, with Coq."""

from __future__ import annotations

import os
import re
import subprocess
from pathlib import Path

import pytest

from tests.coq.closing import BALLS, module
from tests.coq.decoding import PINNED, UNPROVED, VERDICTS
from tests.coq.everything import (
    COLLAPSING,
    DISPERSING,
    FINITE,
    OWN_SCENES,
    compiled,
    everything,
    folders,
    printed,
)
from tests.coq.lies import is_right
from tests.coq.readback import in_digits
from tests.coq.record import AnotherError, found, said_by_coq
from tests.coq.sources import NOTATIONS, complaints, sentences, unexpected
from tests.coq.tampering import (
    ALEXANDER,
    ASSUMED,
    ASSUMPTIONS,
    DEFINITIONS,
    FALSE,
    OTHERS,
    PRINTED,
    SENTENCES,
    SOURCES,
    SPELLED,
    Definition,
    unknown,
)
from verify import check
from verify.wire.coq.export import export

ROOT = SOURCES.parents[1]
EXAMPLE = ROOT / "certificates/examples/interval"


def test_the_files_for_coq_have_only_sentences_on_the_list() -> None:
    assert complaints(SOURCES) == []
    assert sum(len([*sentences(path.read_text())]) for path in SOURCES.glob("*.v")) > 5000
    for folder in folders()[:3]:
        (data,) = check.read_folders([str(folder)])
        assert unexpected(export(data, ordinary=True)) == []


def test_no_files_for_coq_are_a_complaint(tmp_path: Path) -> None:
    assert complaints(tmp_path)


@pytest.mark.parametrize(
    "line",
    ["-arg -l -arg evil", "-arg -type-in-type", "-arg -ri -arg Evil", "-Q .. Verify", "../Evil.v",
     "-arg -q -arg -impredicative-set", "-arg -w"],
)  # fmt: skip
def test_another_option_is_seen(line: str, tmp_path: Path) -> None:
    for name in ("Sequences.v", "_CoqProject"):
        (tmp_path / name).write_text((SOURCES / name).read_text())
    assert complaints(tmp_path) == []
    with (tmp_path / "_CoqProject").open("a") as file:
        file.write(f"{line}\n")
    assert len(complaints(tmp_path)) == 1


@pytest.mark.parametrize("text", SENTENCES)
def test_another_sentence_is_seen(text: str) -> None:
    page = (SOURCES / "Sequences.v").read_text()
    assert unexpected(text)
    assert unexpected(f"{page}{text}\n")
    assert unexpected(page.replace("Open Scope R_scope.", f"Open Scope R_scope. {text}"))
    assert not unexpected(f"(* {text} (* {text} *) *) {page}")


def test_a_notation_is_allowed_in_its_file_only() -> None:
    """As it is written there; and no line allows what is not there."""
    for line in NOTATIONS:
        name, _, sentence = line.partition(": ")
        assert sentence in sentences((SOURCES / f"{name}.v").read_text())
        assert not unexpected(f"{sentence}.", name)
        for text, other in ((sentence, "Pinned"), (sentence, ""), (f"{sentence} -> True", name)):
            assert unexpected(f"Section S. {text}. End S.", other)
    pages = {"Pinned", "Theorem1", "PinnedPrintedSet", "PrintedSet"}
    assert not pages & {line.partition(":")[0] for line in NOTATIONS}


@pytest.mark.parametrize("name", sorted({*ASSUMPTIONS} - {"type-in-type"}))
def test_an_assumption_is_seen_in_the_file(name: str) -> None:
    assert unexpected(ASSUMPTIONS[name][0] + FALSE)


def test_in_a_proof_and_in_a_section_other_sentences_are_allowed() -> None:
    for text in ("Variable x : R.", "Hypothesis a : True.", "Context {A : Type}."):
        assert unexpected(text)
        assert not unexpected(f"Section S. {text} End S.")
        assert unexpected(f"Section S. End S. {text}")
    assert not unexpected("Lemma a : True. Proof. - { trivial. } Qed.")
    assert unexpected("Lemma a : True. Proof. - { trivial. } Admitted.")
    assert unexpected('Definition a := "x. Axiom y : False.')


PLACES = [DEFINITIONS, SPELLED, PRINTED, OTHERS, ALEXANDER, PINNED, UNPROVED, VERDICTS]


@pytest.mark.parametrize("way", [way for ways in PLACES for way in ways.values()])
def test_what_is_tampered_with_is_there_once(way: Definition | tuple[Definition, str]) -> None:
    file, old, new = way if isinstance(way, Definition) else way[0]
    assert (SOURCES / f"{file}.v").read_text().count(old) == 1 or (old, new) == ("", "")


@pytest.mark.parametrize("n", [1, 2, 3, 10, 255, 256, 2**61 - 1, 3**200])
def test_numbers_are_read_by_the_constructors_by_which_coq_prints_them(n: int) -> None:
    digits = "xH" + "".join(f"~{digit}" for digit in f"{n:b}"[1:])
    small = n % 9
    natural = f"{'S (' * (small - 1)}{'S ' * (small > 0)}O{')' * (small - 1)}"
    said = f"Cuts [{natural}; O] (f {digits} (Z.neg {digits})) (Z.pos {digits}) Z0 ({natural}, S O)"
    assert in_digits(said) == f"Cuts [{small}; 0] (f {n} (-{n})) ({n}) 0 ({small}, 1)"


def test_what_all_theorems_rest_on_is_committed() -> None:
    text = ASSUMED.read_text()
    printed = re.findall(r"^(\w+\.\w+)(?: : |$)", text, re.MULTILINE)
    checked = re.findall(r"^    (\S+)$", text, re.MULTILINE)
    assert sorted(printed) == sorted(name.split(".", 2)[2] for name in checked)
    assert sorted(checked) == [
        "Coq.Logic.Classical_Prop.classic",
        "Coq.Logic.FunctionalExtensionality.functional_extensionality_dep",
        "Coq.Reals.ClassicalDedekindReals.sig_forall_dec",
        "Coq.Reals.ClassicalDedekindReals.sig_not_dec",
    ]
    assert re.findall(r"^\* (.*)$", text, re.MULTILINE) == [
        "Theory: Set is predicative", "Axioms:",
        "Constants/Inductives relying on type-in-type: <none>",
        "Constants/Inductives relying on unsafe (co)fixpoints: <none>",
        "Inductives whose positivity is assumed: <none>",
    ]  # fmt: skip
    assert unknown(text) == []
    for line in ("lemma1 : theorem_1", "    Verify.Collapse.lemma1"):
        assert unknown(f"{text}{line}\n") == [line.strip()]


def test_every_committed_certificate_is_asked_for() -> None:
    text = everything(folders())
    assert len(folders()) > 30
    for folder in folders():
        name = module(folder)
        assert f" : Meaning.true_statement {name}.the_statement\n" in text
        assert text.count(f"true_{name},") + text.count(f"true_{name})") == 1
    paths = {re.sub("[^A-Za-z0-9]", "_", str(path)) for path in folders()}
    assert len({*map(module, folders())}) == len(paths) == len(folders())
    for name in ("Pinned.theorem_1", "Accepted.accepts_sound", "AcceptsFiles.accepts_beside_sound"):
        assert name in text
    asked = re.search(r"^Definition everything := \((.*?)\)\.$", text, re.MULTILINE)
    assert asked
    names = {*asked[1].split(", ")}
    assert names >= {"soundness", "files", "theorem_1", "printed_set", "separatrix", "discharged"}
    # What is compiled because it ends in a theorem on three balls, and no more, is asked for that.
    balls = {file.lower().removeprefix("scene_") for file in BALLS.values()}
    balls |= {compiled(path.stem) for path in OWN_SCENES.glob("*.toml")}
    assert balls == {"point", "angle", *map(compiled, (*DISPERSING, *COLLAPSING, *FINITE))}
    assert balls <= names
    assert text.endswith("Print Assumptions everything.\n")


def as_printed(folder: Path) -> str:
    """What Coq would print of an exported file."""
    (data,) = check.read_folders([str(folder)])
    parts = re.findall(r"^Definition (the_\w+) : (.*?) :=(.*?)\.$", export(data), re.S | re.M)
    name = re.search(r"Print Verify\.(\w+)\.the_nodes", printed([module(folder)]))
    assert name
    lines = [
        f"{name[1]}.{part} = {' '.join(text.split())}\n     : {kind}\n"
        for part, kind, text in parts
    ]
    plain = re.sub(r"\(\*.*?\*\)", "", "".join(lines))
    return re.sub(r"(?<= )(?=the_(nodes|contexts|rows|citations) )", f"{name[1]}.", plain)


def test_another_statement_than_that_of_the_file_is_seen() -> None:
    text = as_printed(EXAMPLE)
    said_by_coq(EXAMPLE, text, {})
    others = ["", text.replace("the_rows = ", "the_rows_ = ")]
    others += [text.replace(old, new, 1) for old, new in (("Proved", "Refuted"), ("true", "false"))]
    for number in ("Less", "AtMost", "Equal"):
        others += [text.replace(number, other, 1) for other in ("Less", "AtMost") if number in text]
    for other in others:
        if other != text:
            with pytest.raises((AnotherError, AssertionError)):
                said_by_coq(EXAMPLE, other, {})


@pytest.mark.parametrize(
    ("said", "code"),
    [
        ("PROVED: given law", 1),
        ("PROVED: given another law", 1),  # once counted as refused in another way
        ("PROVED: given nothing", 4),
        ("PROVED: given nothing", 0),
        ("REFUSED: step 1 is refused", 0),
    ],
)
def test_a_lie_that_is_proved_is_seen_whatever_it_rests_on(said: str, code: int) -> None:
    assert not is_right(said, code, "law")
    assert is_right("PROVED: given law", 0, "law")
    assert is_right("MALFORMED: no JSON", 1, "law")


def test_a_certificate_that_was_not_checked_is_missed(tmp_path: Path) -> None:
    lines = [f"{folder.relative_to(ROOT)}\n" for folder in folders()]
    for some in ([], lines[1:], lines[:-1], [*lines, lines[-1]]):
        (tmp_path / "checked").write_text("".join(some))
        with pytest.raises(AnotherError, match="was not checked"):
            found(tmp_path)
    (tmp_path / "checked").write_text("".join(lines))
    with pytest.raises(FileNotFoundError, match="printed"):
        found(tmp_path)


def test_without_coq_nothing_is_said_to_be_checked(tmp_path: Path) -> None:
    (tmp_path / "dirname").symlink_to("/usr/bin/dirname")
    done = subprocess.run(
        ["/bin/bash", str(ROOT / ".ci/coq")],
        env={"PATH": str(tmp_path)},
        capture_output=True,
        text=True,
    )
    assert done.returncode == 77
    assert done.stdout == ""
    assert done.stderr.startswith("coq: NOTHING WAS CHECKED")


#: Instead of what `.ci/coq` calls: it writes down who it is, and complains if that is asked for.
FAKE = """#!/bin/bash
me="$(basename "$0") $*"
case "$me" in
"coqc -where") echo "$LIB" && exit ;;
*--certificates) echo certificates/a ;;
*--compare) echo "controls: 1" ;;
*lies*) echo "lies: 1" ;;
"build "*) cp "$0" "$1/reader" ;;
esac
echo "$me" >>"$LIB/calls"
if [[ "$me" =~ $BROKEN ]]; then echo "THIS IS BROKEN" | tee /dev/stderr; exit "$CODE"; fi
"""
CALLS = (
    "everything .*--certificates", "closing", "build", "sources", "everything [^-]*$", "Everything",
    "coqchk", "controls [^-]*$", "Controls", "--compare", "reader certificates", "lies", "fuzz",
    "tampering", "decoding", "Printed", "record",
)  # fmt: skip


#: These also fail it by what they say: it is not what all theorems rest on.
SAYING = ("Everything", "coqchk")


@pytest.mark.parametrize(
    ("broken", "code"),
    [("nothing", 0), *((name, 3) for name in CALLS), *((name, 0) for name in SAYING)],
)
def test_whatever_fails_in_the_run_fails_it(broken: str, code: int, tmp_path: Path) -> None:
    """The script itself, with other programs."""
    for place in ("bin/coqc", "bin/coqchk", "bin/ocamlfind", "bin/make", "bin/python",
                  "verify/coq/build"):  # fmt: skip
        (tmp_path / place).parent.mkdir(parents=True, exist_ok=True)
        (tmp_path / place).write_text(FAKE)
        (tmp_path / place).chmod(0o755)
    for place in (".ci", "tests/coq", "user-contrib/Interval"):
        (tmp_path / place).mkdir(parents=True, exist_ok=True)
    script, calls = tmp_path / ".ci/coq", tmp_path / "calls"
    script.write_text((ROOT / ".ci/coq").read_text())
    (tmp_path / "tests/coq/unread.txt").write_text("a: b\n")
    (tmp_path / "verify/coq/assumed.txt").write_text("")
    done = subprocess.run(
        ["/bin/bash", str(script)],
        env={"PATH": f"{tmp_path}/bin:{os.environ['PATH']}", "PYTHON": f"{tmp_path}/bin/python",
             "LIB": str(tmp_path), "BROKEN": broken, "CODE": str(code)},
        capture_output=True, text=True, timeout=60,
    )  # fmt: skip
    found = calls.read_text()
    if broken == "nothing":
        assert done.returncode == 0, done.stderr
        assert "proved in Coq" in done.stdout
        assert all(re.search(call, found, re.MULTILINE) for call in CALLS)
    else:
        assert done.returncode not in (0, 77)
        assert "proved in Coq" not in done.stdout
        assert "THIS IS BROKEN" in done.stdout + done.stderr
        assert re.search(broken, found, re.MULTILINE)
