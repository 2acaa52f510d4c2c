"""The page with Theorem 1 in Coq can be read alone, and what is proved is what it says.

That it is proved is for Coq to say, in `.ci/coq`.
"""

from __future__ import annotations

import json
import re
from pathlib import Path

from verify.paper.sharper.sharper import ASSUMPTIONS as SHARPER_ASSUMPTIONS

from tests.coq import sentences
from tests.coq.everything import SENTENCES, conjunction, discharging
from verify.paper.assumptions import STEP_ASSUMPTIONS
from verify.paper.in_coq import IN_COQ
from verify.wire.coq.beside import beside
from verify.wire.coq.export import export

ROOT = Path(__file__).resolve().parents[2]
SOURCES = ROOT / "verify/coq"
PAGE = (SOURCES / "Theorem1.v").read_text()
PINNED = (SOURCES / "Pinned.v").read_text()


def test_the_page_has_only_definitions() -> None:
    assert re.findall(r"^.*\bImport\b.*$", PAGE, re.MULTILINE) == [
        "From Coq Require Import Reals List Arith.",
        "Import ListNotations.",
    ]
    words = "Theorem|Lemma|Proof|Axiom|Parameter|Hypothesis|Notation"
    assert not re.search(f"^({words})\\b", PAGE, re.MULTILINE)


def test_the_theorem_is_what_the_page_says() -> None:
    for page in (PAGE, PINNED):
        for name in SENTENCES:
            assert re.search(rf"^Definition {name} : Prop :=\n  forall (d )?r ", page, re.MULTILINE)
        for name in ("interior", "positive_volume", "printed_theorem"):
            assert re.search(rf"^Definition {name} : Prop :=\n[^.]* \(2 <= d\)", page, re.MULTILINE)
    last = " ".join((SOURCES / "AllProved.v").read_text().split())
    pinned = " ".join(PINNED.split())
    assert f"Theorem all_proved : {conjunction('')}. Proof." in last
    assert last.endswith("Qed.")
    assert f"Check (AllProved.all_proved : {conjunction('Theorem1.')})." in pinned
    assert f"Theorem proved : {conjunction('')}. Proof." in pinned
    assert PINNED.endswith("Qed.\nPrint Assumptions collapsing_scene.\n")


def constants(page: str) -> dict[str, str]:
    """The definitions of numbers on a page."""
    found = re.findall(r"^Definition (\w+) :=(.*?)\.$", page, re.DOTALL | re.MULTILINE)
    return {
        name: " ".join(body.split()) for name, body in found if re.search("[+*/]| - |least", body)
    }


def test_both_pages_have_the_same_numbers() -> None:
    found = constants(PINNED.replace("minimum", "least"))
    assert len(found) == 19
    assert found == constants(PAGE)
    for sentence in (
        "0 < r < 1", "0 < c <= 1", "0 < V_0", "0 < delta_theta", "0 < y <= eta_bar",
        "3 * r * ((1 + r) / 2 * c) + r * (1 + r) < ((1 + r) / 2 * c) ^ 3",
        "0 < d_0 <= Rmin d_const (d_slope * y ^ 2)", "Un_cv time T", "T <= by_time",
        "(T_star r c V_0 delta_theta) c (Delta_theta r c V_0 delta_theta)",
        "0 < Delta_theta r c V_0 delta_theta <= delta_theta", "0 < r < 9 - 4 * sqrt 5",
        "by_time (- cos theta_0) delta_theta", "PI / 2 < theta_0 <= PI",
        "i <> j -> 1 < distance d (",
    ):  # fmt: skip
        assert sentence in PINNED
        assert sentence in PAGE


def test_the_page_that_pins_it_takes_no_notation_from_others() -> None:
    assert re.findall(r"^.*\b(?:Import|Require)\b.*$", PINNED, re.MULTILINE) == [
        "From Coq Require Import Reals List Arith Lra FunctionalExtensionality.",
        "From Verify Require Theorem1 AllProved.",
        "Import ListNotations.",
    ]
    assert not re.search(r"^(Notation|Infix)", PINNED, re.MULTILINE)
    for name in SENTENCES:
        assert f"Theorem1.{name} <-> {name}.\nProof." in PINNED
    assert "Theorem admissible_parameters : admissible (3 / 100) 1 1 1.\nProof." in PINNED


def test_the_printed_set_is_spelled_out_twice() -> None:
    page, pinned = (
        (SOURCES / f"{name}.v").read_text() for name in ("PrintedSet", "PinnedPrintedSet")
    )
    assert not re.search("^(Theorem|Lemma|Proof|Axiom|Parameter|Notation)\\b", page, re.MULTILINE)
    assert re.findall(r"^.*\b(?:Import|Require)\b.*$", pinned, re.MULTILINE) == [
        "From Verify Require Import Pinned.",
        "From Verify Require Theorem1 AllProved PrintedSet PrintedProof.",
        "From Coq Require Import Reals List Arith Lra.",
        "Import ListNotations.",
    ]
    found = constants(pinned.replace("minimum", "least"))
    assert len(found) == 9
    assert found == constants(page)
    # What the paper prints is not what is repaired.
    assert {name for name in found if found[name] == constants(PAGE).get(name)} == {
        "x_0", "d_slope", "T_star",
    }  # fmt: skip
    (theorem,) = re.findall(
        r"^Definition printed_set_theorem.*?\.$", pinned, re.DOTALL | re.MULTILINE
    )
    assert theorem.replace(" x v", " s") in page
    for sentence in (
        "0 < y <= eta_bar", "0 < d_0 <= Rmin d_const (d_slope * y ^ 2)", "minus_cosine d x = c",
        "distance d x B0 B1 = 1", "Rabs (rate d x v B0 B1 - phi_minus * y) <= x_0 * y",
        "Rabs (minus_cosine d x - c) <= Theta / 6", "0 < w <= u -> i <> j -> 1 < distance d (",
        "V_0 + (V_1 - V_0) / 3 <= dot d (from_to v B0 B2) (from_to v B0 B2) <= V_1",
        # The whole theorem: a weaker one would agree on both pages.
        "forall r theta_0 V_0 delta_theta d, (2 <= d)%nat -> PI / 2 < theta_0 <= PI ->\n",
        "printed_hypothesis r (- cos theta_0) -> 0 < V_0 -> 0 < delta_theta ->\n",
        "let c := - cos theta_0 in\n", "let Theta := Theta r c V_0 delta_theta in\n",
        "let as_printed := printed_set r c V_0 delta_theta d in\n",
        "let roomy := with_room r c V_0 delta_theta d in\n",
        "(exists x v, as_printed x v) /\\ ~ has_interior d as_printed /\\\n",
        "(forall x v, as_printed x v -> roomy x v) /\\ has_interior d roomy /\\ contains_a_",
        "(forall x v, roomy x v -> collapse d r x v (T_star r c V_0 delta_theta) c Theta) /\\\n",
        "Theta <= delta_theta.\n",
    ):  # fmt: skip
        assert sentence in pinned
    assert "Check (PrintedProof.printed_set_theorem_holds : PrintedSet." in pinned
    assert pinned.endswith("Qed.\nPrint Assumptions printed_set_proved.\n")


def test_a_statement_after_another_one_begins_as_what_it_cites_does() -> None:
    """So that a theorem about the numbers of the one is about those of the other."""
    cited, citing = (
        export(beside(ROOT / f"certificates/{name}", ROOT / "certificates/flow"))
        for name in ("sharper", "printed-set")
    )
    # The nodes of its terms, up to the last variable, and its contexts; comments have the names.
    nodes, contexts = (
        [re.findall(rf"^  ({kind}.*?);? *\(\*", text, re.MULTILINE) for text in (cited, citing)]
        for kind in ("N[A-Z]", "Context")
    )
    last = max(i for i, node in enumerate(nodes[0]) if node.startswith("NVariable"))
    assert last > 1000
    assert nodes[0][: last + 1] == nodes[1][: last + 1]
    assert len(contexts[0]) > 10
    assert len(contexts[1]) == len(contexts[0]) + 2


def test_everything_of_the_proof_is_compiled() -> None:
    project = (SOURCES / "_CoqProject").read_text()
    compiled = re.findall(r"^(\w+)\.v$", project, re.MULTILINE)
    made = ["Step", "All", "Flow", "Sharper", "AsPrinted"]
    assert sorted(compiled) == sorted([*made, *(path.stem for path in SOURCES.glob("*.v"))])


def test_the_files_are_short_say_what_they_prove_and_name_what_they_need() -> None:
    sections: dict[str, str] = {}
    for path in sorted(SOURCES.glob("*.v")):
        text = path.read_text()
        assert text.startswith("(* "), path
        assert text.count("\n") <= 400, path
        assert not re.search(r"^Require", text, re.MULTILINE), path
        # A context of a certificate has a name: its number changes with the statement.
        assert not re.search(r"\b(scope S\w|flow_givens?|parent_of S\w) [0-9]", text), path
        for name in re.findall(r"^Section (\w+)\.$", text, re.MULTILINE):
            assert name not in sections, (name, path, sections[name])
            sections[name] = path.name


def test_no_name_hides_one_of_coq_on_a_page_that_imports_ours() -> None:
    """A name that is imported last hides others: a `Cauchy_crit` of ours would be another one."""
    pages = [path for path in SOURCES.glob("*.v") if "Pinned" in path.stem]
    for path in [*pages, SOURCES / "Sentences.v"]:
        found = re.findall(r"^From (\w+) Require Import", path.read_text(), re.MULTILINE)
        assert found == sorted(found, reverse=True), path


PAGES = ("Sentences", "SeparatrixProof", "PinnedSeparatrix")
PINS = "".join((SOURCES / f"{name}.v").read_text() for name in PAGES)


def pinned(name: str) -> bool:
    """Whether a file says what a theorem is, or what a definition says."""
    file, _, theorem = name.partition(".")
    short = theorem if file.startswith("Separatrix") else name
    checks = re.findall(r"^Check .*?\.$", PINS, re.DOTALL | re.MULTILINE)
    by_type = any(check.startswith(f"Check ({short} : ") for check in checks)
    by_value = any(re.search(rf"eq_refl :\s[^=]*\b{short}\b[^=]* =", check) for check in checks)
    return by_type or by_value or f"{short} d s i j t <-> hard_spheres_meet d s i j t." in PINS


def test_what_coq_proves_of_the_sentences_taken_on_trust_is_pinned() -> None:
    for name in discharging():
        file, _, theorem = name.partition(".")
        text = (SOURCES / f"{file}.v").read_text()
        kinds = "Definition|Record" if file in ("Theorem1", "Separatrix") else "Theorem|Lemma"
        assert len(re.findall(rf"^({kinds}) {theorem}\b", text, re.MULTILINE)) == 1, name
        assert pinned(name), name
    assert not pinned("Trajectory.cosine_is")
    assert not pinned("Sentences.same_meeting")


def test_the_sentences_in_coq_are_those_of_the_statements() -> None:
    statements = [
        json.loads(path.read_bytes()) for path in ROOT.glob("certificates/*/statement.json")
    ]
    by_theorem = {statement["theorem"]: statement["assumptions"] for statement in statements}
    said: dict[tuple[str, ...], set[str]] = {}
    for theorem, found in IN_COQ.items():
        items = {item["name"]: item for item in by_theorem[theorem]}
        assert [name for name in items if name in found] == [*found], theorem
        for name, theorems in found.items():
            if items[name]["kind"] == "general mathematics":
                said.setdefault(theorems, set()).add(items[name]["sentence"])
    assert all(len(sentences) == 1 for sentences in said.values())
    assert [*IN_COQ["step"]] == [item["name"] for item in by_theorem["step"]]
    assert [*IN_COQ["separatrix"]] == [item["name"] for item in by_theorem["separatrix"]]


def test_a_sentence_and_what_coq_proves_are_pinned_together() -> None:
    """Where one is changed: read both in `sentences.txt`, then `python -m tests.coq.sentences`."""
    assert sentences.PINNED.read_text(encoding="utf-8") == sentences.pinned()
    found = sentences.sentences()
    assert sum(name.startswith("glue-") for _, name in found) >= 10
    for theorem, name in found:
        assert all(sentences.proved(one) for one in IN_COQ[theorem][name]), (theorem, name)


def test_the_sentences_of_the_program_are_those_that_are_pinned() -> None:
    """A sentence that is changed in the code, and not yet in a certificate, is seen, too."""
    pinned = sentences.sentences()
    for theorem, every in (("step", STEP_ASSUMPTIONS), ("sharper", SHARPER_ASSUMPTIONS)):
        for one in every:
            if one.name in IN_COQ[theorem]:
                assert one.sentence == pinned[theorem, one.name], one.name


def test_the_theorem_about_files_is_the_one_on_the_page() -> None:
    page = (ROOT / "docs/explanation/coq.md").read_text()
    shown = re.findall(r"^Theorem accepts_beside_sound.*?\.$", page, re.DOTALL | re.MULTILINE)
    assert len(shown) == 1
    assert f"{shown[0]}\nProof." in (SOURCES / "AcceptsFiles.v").read_text()
