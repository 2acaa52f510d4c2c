"""The page with Theorem 1 in Coq can be read alone, and what is proved is what it says.

That it is proved is for Coq to say, in `.ci/coq`.
"""

from __future__ import annotations

import json
import re
from pathlib import Path

from tests.coq import sentences
from tests.coq.everything import SENTENCES, conjunction, discharging
from verify.paper.commands import pages
from verify.paper.in_coq import CITED_IN_COQ, IN_COQ, WHOLE_IN_COQ
from verify.wire.coq.export import export
from verify.wire.coq.second_citation import beside

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
    assert len(contexts[1]) == len(contexts[0]) + 4


def test_everything_of_the_proof_is_compiled() -> None:
    project = (SOURCES / "_CoqProject").read_text()
    compiled = re.findall(r"^(\w+)\.v$", project, re.MULTILINE)
    made = ["Step", "All", "Flow", "Sharper", "AsPrinted", "Collapsing", "Balls", "BallsFlow"]
    made += ["Inner", "Ends", "Almost"]
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
    for path in [*pages, SOURCES / "Sentences.v", SOURCES / "BeyondSentences.v"]:
        found = re.findall(r"^From (\w+) Require Import", path.read_text(), re.MULTILINE)
        assert found == sorted(found, reverse=True), path


PAGES = ("Sentences", "BeyondSentences", "SeparatrixProof", "PinnedSeparatrix")
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
        defines = file in (
            "Theorem1",
            "Separatrix",
            "Spectrum",
            "Line",
            "ThreeBalls",
            "Outside",
            "Sandwich",
        )
        kinds = "Definition|Record|Fixpoint" if defines else "Theorem|Lemma"
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
    for theorem in ("step", "sharper"):
        for one in pages.statement(theorem).assumptions:
            if one.name in IN_COQ[theorem]:
                assert one.sentence == pinned[theorem, one.name], one.name


def test_what_coq_proves_of_cited_theorems_and_as_a_whole_is_there() -> None:
    statements = {
        statement["theorem"]: statement
        for path in ROOT.glob("certificates/*/statement.json")
        for statement in [json.loads(path.read_bytes())]
    }
    for theorem, cited in CITED_IN_COQ.items():
        assert {cite["theorem"] for cite in statements[theorem]["cites"]} == {*cited}
    for theorem in WHOLE_IN_COQ:
        needed = {
            one["name"] for one in statements[theorem]["assumptions"] if one["kind"] != "definition"
        }
        assert needed <= {*IN_COQ[theorem]}
        assert theorem in CITED_IN_COQ or not statements[theorem]["cites"]
    assert [name for names in WHOLE_IN_COQ.values() for name in names] == [
        "PinnedPrintedSign.printed_sign_proved"
    ]


def test_the_theorem_about_files_is_the_one_on_the_page() -> None:
    page = (ROOT / "docs/explanation/coq.md").read_text()
    shown = re.findall(r"^Theorem accepts_beside_sound.*?\.$", page, re.DOTALL | re.MULTILINE)
    assert len(shown) == 1
    assert f"{shown[0]}\nProof." in (SOURCES / "AcceptsFiles.v").read_text()


#: What the pages on the sign as printed, the collapses and the spectrum have to say, word for word:
#: a page and the file that it pins could be weakened together.
SAID = {
    "PinnedPrintedSign": (
        "0 < r < 9 - 4 * sqrt 5 /\\ PI / 2 < theta_0 <= PI /\\",
        (
            "0 < - cos theta_0 < 2 * Rpower r (1 / 3) * (1 + Rpower r (1 / 3)) / (1 + r) /\\ 0 < "
            "delta_theta."
        ),
        (
            "forall r theta_0 delta_theta d, (2 <= d)%nat -> hypotheses_as_printed r theta_0 "
            "delta_theta -> as_printed_at d r theta_0 delta_theta."
        ),
        (
            "as_printed_at d r theta_0 delta_theta : Prop := exists set, has_interior d set /\\ "
            "forall x v, set x v -> nearly_linear d r x v (- cos theta_0) delta_theta."
        ),
        (
            "~ as_printed /\\ (forall d r theta_0 delta_theta, (2 <= d)%nat -> 0 < r < 1 -> "
            "- cos theta_0 + delta_theta < 2 * Rpower r (1 / 3) * (1 + Rpower r (1 / 3)) / (1 + "
            "r) -> ~ as_printed_at d r theta_0 delta_theta) /\\"
        ),
        (
            "(forall d r x v c delta_theta, 0 < r < 1 -> 0 < spin2 d x v -> c + delta_theta < 2 * "
            "Rpower r (1 / 3) * (1 + Rpower r (1 / 3)) / (1 + r) -> ~ nearly_linear d r x v c "
            "delta_theta) /\\"
        ),
        (
            "(exists r theta_0 delta_theta, hypotheses_as_printed r theta_0 "
            "delta_theta /\\ - cos theta_0 + delta_theta < 4 * sqrt r / (1 + r)) /\\"
        ),
        (
            "(forall d r x v c delta_theta, 0 < r < 1 -> c + delta_theta < 4 * sqrt r / (1 + r) "
            "-> ~ nearly_linear d r x v c delta_theta) /\\"
        ),
        "collapse d r x v by_time c tolerance -> nearly_linear d r x v c tolerance).",
        (
            "endless d r x v places velocities time i j /\\ Un_cv time T /\\ in_turn_from N i j "
            "B0 a b /\\ settles d places at_T /\\ Rabs (minus_cosine d at_T - c) <= tolerance."
        ),
        "Print Assumptions printed_sign_proved.",
    ),
    "PinnedClassification": (
        (
            "forall d mass radius places velocities time T i j, (forall b, 0 < mass b) -> (forall "
            "b, 0 < radius b) -> collisions d mass radius places velocities time i j -> Un_cv "
            "time T ->"
        ),
        "dot d (from_to at_T o a) (from_to at_T o c) <= 0.",
        "0 <= rate d x w i j <= - rate d x v i j.",
        (
            "i n <> j n /\\ 0 < t /\\ places (S n) = moved t (places n) (velocities n) /\\ "
            "distance d (places (S n)) (i n) (j n) = 1 /\\ rate d (places (S n)) (velocities n) "
            "(i n) (j n) < 0 /\\"
        ),
        "collide d r (places (S n)) (velocities n) (i n) (j n) (velocities (S n)).",
        (
            "4 * sqrt r / (1 + r) <= minus_cosine_at d at_T o a c <= 1 /\\ (2 * Rpower r (1 / 3) "
            "* (1 + Rpower r (1 / 3)) / (1 + r) <= minus_cosine_at d at_T o a c \\/"
        ),
        (
            "forall d m radius r places velocities time i j, 0 < m -> (forall b, 0 < radius b) "
            "-> 0 < r <= 1 -> collisions d (fun _ => m) radius places velocities time i j -> "
            "restituted d r places velocities i j -> exists at_T o a c N, "
            "settles d places at_T /\\ in_turn_from N i j o a c /\\ distance d at_T o a = radius "
            "o + radius a /\\ distance d at_T o c = radius o + radius c /\\ 4 * sqrt r / (1 + r) "
            "<= minus_cosine_at d at_T o a c <= 1 /\\ (2 * Rpower r (1 / 3) * (1 + Rpower r (1 / "
            "3)) / (1 + r) <= minus_cosine_at d at_T o a c \\/ forall a b k, (k < d)%nat -> Un_cv "
            "(fun n => from_to (velocities n) a b k) 0)."
        ),
        (
            "forall n, rate d (places (S n)) (velocities (S n)) (i n) (j n) = - r * rate d "
            "(places (S n)) (velocities n) (i n) (j n)."
        ),
        (
            "-> 7 - 4 * sqrt 3 < r <= 1 -> collisions d (fun _ => m) radius places velocities "
            "time i j -> ~ restituted d r places velocities i j."
        ),
        (
            "collisions d mass radius places velocities time i j -> ~ (exists T, Un_cv time T) "
            "-> (forall a b k, (k < d)%nat -> Un_cv (fun n => from_to (velocities n) a b k) 0) "
            "/\\ (forall n, over_pairs mass (rate d (places n) (velocities n)) <= 0) /\\ (forall n "
            "k l, (k < d)%nat -> (l < d)%nat -> over_pairs mass (moment (places n) (velocities "
            "n) k l) = 0) /\\ exists at_T o a c N, settles d places at_T /\\ in_turn_from N i j o "
            "a c /\\"
        ),
        "mass B0 * mass B1 * f B0 B1 + mass B0 * mass B2 * f B0 B2 + mass B1 * mass B2 * f B1 B2.",
        (
            "endless d r x v places velocities time i j -> 0 < spin2 d x v -> exists T, Un_cv "
            "time T."
        ),
        ("trajectory d r x v T X V -> forall t, 0 < t < T -> collision_at d X V t -> In t times."),
        (
            "forall d r x v, 0 < r <= 1 -> 7 - 4 * sqrt 3 < r \\/ 9 - 4 * sqrt 5 < r /\\ 0 < spin2 "
            "d x v \\/ 0 <= growth d x v /\\ 6 <= size d x \\/ growth d x v ^ 2 * size d x < "
            "(size d x - 6) * spin2 d x v -> finite d r x v."
        ),
        "forall d r x v, 0 < r <= 1 -> finite d r x v \\/ exists places",
        "Print Assumptions classification_proved.",
    ),
    "PinnedBounds": (
        (
            "forall d last mass sigma x v t i j J, (forall b, 0 < mass b) -> (forall a b, 0 < "
            "sigma a b) -> many_collide d last mass sigma x v t i j J ->"
        ),
        (
            "(i n <= last)%nat /\\ (j n <= last)%nat /\\ i n <> j n) /\\ 0 <= t n /\\ x (S n) = "
            "(fun b k => x n b k + t n * v n b k) /\\ dot d e e = s * s /\\ 0 <= J n /\\"
        ),
        ("0 <= dot d e (apart (v (S n)) (i n) (j n)) <= - dot d e (apart (v n) (i n) (j n))."),
        (
            "sqrt (product d last mass x_0 x_0) * sqrt (product d last mass v_0 v_0) - product d "
            "last mass x_0 v_0) /\\ (exists bound, forall n, sum_f_R0 J n <= bound) /\\"
        ),
        "(forall b k, (k < d)%nat -> exists l, Un_cv (fun n => v n b k) l) /\\",
        (
            "turning2 d last mass x_0 v_0 <= product d last mass x_0 x_0 * product d last mass "
            "v_0 v_0."
        ),
        (
            "0 < r <= 1 -> distinct o a c -> run d m radius r k places velocities time o a c -> "
            "(forall n, (2 <= n < k)%nat -> (1 + r) / 2 * minus_cosine_at d (places n) o a c <= "
            "most) -> compares most r s -> forall n, (1 <= n < k)%nat -> 0 < s n."
        ),
        "s 0%nat = 0 /\\ s 1%nat = 1 /\\ forall n, s (S (S n)) = a * s (S n) - r * s n.",
        (
            "(1 <= d)%nat -> 0 < m -> (forall b, 0 < radius b) -> 0 < r <= 1 -> distinct o a c -> "
            "compares ((1 + r) / 2) r s -> (forall n, (1 <= n < k)%nat -> 0 < s n) -> exists "
            "places velocities time, run d m radius r k places velocities time o a c /\\"
        ),
        (
            "let z := if Nat.even n then a else c in radius o + radius z < distance d (places (S "
            "n)) o z"
        ),
        (
            "0 < r <= 7 - 4 * sqrt 3 -> compares ((1 + r) / 2) r s -> forall n, (1 <= n)%nat -> "
            "0 < s n."
        ),
        "Print Assumptions bounds_proved.",
    ),
    "PinnedLine": (
        (
            "forall d mass radius r x v o a c e parting gap closing Q, (forall b, 0 < mass b) "
            "-> (forall b, 0 < radius b) -> 0 < r -> (a <> o /\\ c <> o /\\ a <> c) -> line d "
            "radius e x v o a c parting gap closing -> slow mass r o a c parting closing Q -> "
            "exists places velocities time T, turns d mass radius r x v o a c places velocities "
            "time /\\ Un_cv time T /\\ T <= (1 - Q) / (1 - 2 * Q) * (gap / closing) /\\ (forall "
            "n, minus_cosine_at d (places n) o a c = 1) /\\ (r < 1 -> exists at_T, settles d "
            "places at_T /\\ distance d at_T o a = radius o + radius a /\\ distance d at_T o c "
            "= radius o + radius c /\\ minus_cosine_at d at_T o a c = 1)."
        ),
        (
            "0 < t /\\ (forall u a b, 0 < u < t -> a <> b -> radius a + radius b < distance d "
            "(moved u x v) a b) /\\ distance d (moved t x v) i j = radius i + radius j /\\ rate "
            "d (moved t x v) v i j < 0 /\\ (forall k, k <> i -> k <> j -> radius i + radius k < "
            "distance d (moved t x v) i k /\\ radius j + radius k < distance d (moved t x v) j "
            "k)."
        ),
        (
            "exists J, (forall k, w i k = v i k - J / mass i * from_to x i j k) /\\ (forall k, "
            "w j k = v j k + J / mass j * from_to x i j k) /\\ (forall b k, b <> i -> b <> j -> "
            "w b k = v b k) /\\ rate d x w i j = - r * rate d x v i j."
        ),
        (
            "forall n, let b := if Nat.even n then c else a in let t := time (S n) - time n in "
            "meet_first d radius (places n) (velocities n) o b t /\\ places (S n) = moved t "
            "(places n) (velocities n) /\\ part d mass r (places (S n)) (velocities n) o b "
            "(velocities (S n))."
        ),
        (
            "dot d e e = 1 /\\ 0 < parting /\\ 0 < gap /\\ 0 < closing /\\ forall k, (k < "
            "d)%nat -> from_to x o a k = - (radius o + radius a) * e k /\\ from_to v o a k = - "
            "parting * e k /\\ from_to x o c k = (radius o + radius c + gap) * e k /\\ from_to "
            "v o c k = - closing * e k."
        ),
        (
            "let b := (1 + r) * mass c / (mass o + mass c) in let b' := (1 + r) * mass a / "
            "(mass o + mass a) in parting <= Q * b * closing /\\ r <= b * b' * Q * (1 - Q) /\\ "
            "2 * Q < 1."
        ),
        "collapse d r x v ((1 - Q) / (1 - 2 * Q) * (gap / closing)) 1 0.",
        "Print Assumptions line_proved.",
    ),
    "PinnedThreeBalls": (
        (
            "forall d mass radius r o a c w Y k E G U_b C_0 Theta z Q_0 U_0 x v, "
            "(forall b, 0 < mass b) -> (forall b, 0 < radius b) -> (forall b, 0 < r b "
            "<= 1) -> (a <> o /\\ c <> o /\\ a <> c) -> numbers mass radius r o a c w Y k"
            " E G U_b C_0 Theta U_0 -> endless_map mass radius r o a c w G U_b C_0 "
            "Theta Q_0 U_0 -> start d mass radius r o a c w Y k E G U_b C_0 Theta z Q_0"
            " U_0 x v -> exists places velocities time T at_T, in_turn d mass radius r "
            "o a c x v places velocities time /\\ Un_cv time T /\\ T <= E c * "
            "closing_speed d radius o c x v /\\ settles d places at_T /\\ distance d at_T"
            " o a = radius o + radius a /\\ distance d at_T o c = radius o + radius c /\\"
            " Un_cv (fun n => minus_cosine_at d (places n) o a c) (minus_cosine_at d "
            "at_T o a c) /\\ Rabs (minus_cosine_at d at_T o a c - C_0) <= Theta."
        ),
        (
            "forall mass radius r o a c w G U_b C_0 Theta Q_0 U_0 N Q U, (forall b, 0 <"
            " mass b) -> (forall b, 0 < radius b) -> (forall b, 0 < r b) -> 1 <= G -> "
            "U_b < 1 -> Theta < C_0 -> stairs mass radius r o a c w G U_b C_0 Theta Q_0"
            " U_0 N Q U -> endless_map mass radius r o a c w G U_b C_0 Theta Q_0 U_0."
        ),
        (
            "forall d r w Y k E G U_b C_0 Theta z Q_0 U_0 x v, 0 < r < 1 -> numbers "
            "(fun _ => 1) (fun _ => 1 / 2) (fun _ => r) B0 B1 B2 w Y k E G U_b C_0 "
            "Theta U_0 -> endless_map (fun _ => 1) (fun _ => 1 / 2) (fun _ => r) B0 B1 "
            "B2 w G U_b C_0 Theta Q_0 U_0 -> start d (fun _ => 1) (fun _ => 1 / 2) (fun"
            " _ => r) B0 B1 B2 w Y k E G U_b C_0 Theta z Q_0 U_0 x v -> collapse d r x "
            "v (E B2 * closing_speed d (fun _ => 1 / 2) B0 B2 x v) C_0 Theta."
        ),
        (
            "(places O = x /\\ velocities O = v /\\ time O = 0) /\\ forall n, let t := "
            "time (S n) - time n in meet_first d radius (places n) (velocities n) o (c_"
            " n) t /\\ places (S n) = moved t (places n) (velocities n) /\\ part d mass "
            "(r (c_ n)) (places (S n)) (velocities n) o (c_ n) (velocities (S n))."
        ),
        (
            "distance d x o a = sigma a /\\ let y := closing_speed x v in let eta := "
            "rate d x v o a / sigma a ^ 2 in let gap := distance d x o c / sigma c - 1 "
            "in let gain := G / (1 - Y c * Y a) in 0 < gap /\\ 0 < y /\\ 0 < eta /\\ k c *"
            " y <= eta <= Q_0 * y /\\ gap * (2 + gap) * w c ^ 2 <= U_0 * (2 - U_0) * (1 "
            "+ gap) ^ 2 * y ^ 2 /\\ U_b * (2 - U_b) * G ^ 2 * y ^ 2 <= w c ^ 2 * (G ^ 2 "
            "- 1) /\\ U_b * (2 - U_b) * G ^ 2 * (Y c * y) ^ 2 <= w a ^ 2 * (G ^ 2 - 1) "
            "/\\ y <= z /\\ Y c * y <= z /\\ beta c a * y <= z /\\ beta a c * (Y c * y) <= "
            "z /\\ speed x v c <= w c - beta a c * Y c * gain * y /\\ speed x v a <= w a "
            "- beta c a * gain * y /\\ Rabs (minus_cosine_at d x o a c - C_0) + (w c + w"
            " a + z) * E c * y <= Theta."
        ),
        (
            "1 <= G /\\ U_0 <= U_b < 1 /\\ Y c * Y a < 1 /\\ Theta < C_0 <= 1 /\\ "
            "numbers_for c a /\\ numbers_for a c /\\ (radius a + radius c) ^ 2 < sigma c "
            "^ 2 + sigma a ^ 2 + 2 * sigma c * sigma a * (C_0 - Theta)."
        ),
        (
            "0 < Y b /\\ 0 <= k b /\\ 0 < w b /\\ G ^ 2 * beta b b' <= G * Y b + k b /\\ k "
            "b' * Y b <= r b * (1 - U_b) /\\ G * U_b <= w b ^ 2 * (E b - Y b * E b')."
        ),
        (
            "0 <= Q_0 <= Q O /\\ 0 <= U_0 <= U O /\\ (forall n, (n <= S N)%nat -> let p "
            ":= (Q n, U n) in 0 <= Q n /\\ 0 <= U n <= U_b /\\ 0 <= U (S n) <= U_b /\\ 0 <"
            " P (alpha n) (rho n) p /\\ r (c_ n) * G * (1 - U n) <= Q (S n) * P (alpha "
            "n) (rho n) p /\\ L (rho n) p <= U (S n) * (2 - U (S n)) * P (alpha n) (rho "
            "n) p ^ 2) /\\ Q (S (S N)) <= Q N /\\ U (S (S N)) <= U N."
        ),
        (
            "forall n, 0 < P (alpha n) (rho n) (orbit n) /\\ L (rho n) (orbit n) <= U_b "
            "* (2 - U_b) * P (alpha n) (rho n) (orbit n) ^ 2."
        ),
        (
            "Fixpoint orbit (n : nat) : R * R := match n with O => (Q_0, U_0) | S n => "
            "next (alpha n) (rho n) (r (c_ n) * G) (orbit n) end."
        ),
        "Definition alpha (n : nat) : R := beta (c_ n) (s_ n) * (C_0 - Theta).",
        "Definition rho (n : nat) : R := G * (w (s_ n) / w (c_ n)) ^ 2.",
        (
            "Definition beta (b b' : ball) : R := (1 + r b) * mass b / (mass o + mass "
            "b) * (sigma b / sigma b')."
        ),
        "Definition sigma (b : ball) : R := radius o + radius b.",
        (
            "Definition P (alpha rho : R) (p : R * R) : R := alpha * (1 - snd p) - fst "
            "p - rho * snd p."
        ),
        "Definition L (rho : R) (p : R * R) : R := rho * snd p * (2 * fst p + rho * snd p).",
        (
            "(ratio * (1 - snd p) / P alpha rho p, 1 - sqrt (1 - L rho p / P alpha rho "
            "p / P alpha rho p))."
        ),
        "Definition c_ (n : nat) : ball := if Nat.even n then c else a.",
        "Definition s_ (n : nat) : ball := if Nat.even n then a else c.",
        (
            "Definition closing_speed (x v : ball -> nat -> R) : R := - rate d x v o c "
            "/ (distance d x o c * sigma c)."
        ),
        (
            "Definition speed (x v : ball -> nat -> R) b : R := sqrt (dot d (from_to v "
            "o b) (from_to v o b)) / sigma b."
        ),
        (
            "forall d mass radius r x u o i c v lam rho eps sig A B C a b w y q kap s T"
            " C' lam' A' B' a' b' w' eps', (forall b, 0 < mass b) -> (forall b, 0 < "
            "radius b) -> (i <> o /\\ c <> o /\\ i <> c) -> products d radius x u o i c v"
            " lam rho eps sig A B C a b w -> collision_numbers ((radius o + radius c) ^"
            " 2) ((radius o + radius i) ^ 2) ((radius i + radius c) ^ 2) (1 + mass o / "
            "mass c) r v lam rho eps sig A B C a b w y q kap s T C' lam' A' B' a' b' w'"
            " eps' -> exists u', meet_first d radius x u o c (y * T) /\\ part d mass r "
            "(moved (y * T) x u) u o c u' /\\ products d radius (moved (y * T) x u) u' o"
            " c i y lam' (r * s) eps' 0 A' B' C' a' b' w'."
        ),
        (
            "let x_i := from_to x o i in let x_c := from_to x o c in let W_i := from_to"
            " u o i in let W_c := from_to u o c in dot d x_i x_i = (radius o + radius "
            "i) ^ 2 + sig * v ^ 2 /\\ dot d x_c x_c = (radius o + radius c) ^ 2 + eps * "
            "v ^ 2 /\\ dot d x_i x_c = - C /\\ dot d x_i W_i = rho * v /\\ dot d x_c W_c ="
            " - (lam * v) /\\ dot d x_i W_c = a /\\ dot d x_c W_i = b /\\ dot d W_i W_i = "
            "B /\\ dot d W_c W_c = A /\\ dot d W_i W_c = w."
        ),
        (
            "0 < r /\\ 0 < v /\\ 0 < lam /\\ 0 <= A /\\ y = lam * v /\\ q = rho / lam /\\ kap"
            " = eps / lam / lam /\\ 0 < kap /\\ 0 < 1 - A * kap /\\ s = sqrt (1 - A * kap)"
            " /\\ T = kap / (1 + s) /\\ C' = C - y * T * (a + (b + y * T * w)) /\\ lam' = "
            "(1 + r) / n * s * C' / K_c - q - T * B /\\ A' = B + (1 + r) / n * (y * s) *"
            " (2 * (b + y * T * w) + (1 + r) / n * (y * s)) / K_c /\\ B' = A - (1 - r ^ "
            "2) * (y * s) ^ 2 / K_c /\\ a' = b + y * T * w + (1 + r) / n * (y * s) /\\ b'"
            " = a + y * T * w - n * ((1 + r) / n * (y * s)) * C' / K_c /\\ w' = w + (1 +"
            " r) / n * (y * s) * (n * (b + y * T * w) + r * (y * s)) / K_c /\\ eps' = "
            "sig / lam / lam + T * (2 * q + T * B) /\\ 0 <= sig /\\ 0 <= sig + T * lam * "
            "rho /\\ 0 < eps' /\\ 0 <= K_c + K_s - K_o + (eps + sig) * v ^ 2 + 2 * C /\\ 0"
            " <= K_c + K_s - K_o + (eps + sig) * v ^ 2 + 2 * C + ((rho - lam) * v - a -"
            " b) * (y * T) /\\ 0 < K_c + K_s - K_o + (eps + sig) * v ^ 2 + 2 * C + y * T"
            " * (2 * ((rho - lam) * v - a - b) + (A + B - 2 * w) * (y * T)) /\\ 0 <= B'."
        ),
        "Print Assumptions three_balls_proved.",
    ),
    "PinnedSandwich": (
        "Definition c_ (n : nat) : ball := if Nat.even n then B2 else B1.",
        "Definition s_ (n : nat) : ball := if Nat.even n then B1 else B2.",
        "Definition alpha : R := (1 + r) / 2 * (C_0 - Theta).",
        "Definition rho (n : nat) : R := G * (w (s_ n) / w (c_ n)) ^ 2.",
        (
            "Fixpoint orbit (n : nat) : R * R := match n with O => (Q_0, U_0) | S n => "
            "PinnedThreeBalls.next alpha (rho n) (r * G) (orbit n) end."
        ),
        (
            "Definition endless_map : Prop := forall n, let P := PinnedThreeBalls.P alpha "
            "(rho n) (orbit n) in 0 < P /\\ PinnedThreeBalls.L (rho n) (orbit n) <= U_b * (2"
            " - U_b) * P ^ 2."
        ),
        (
            "Definition stairs (N : nat) (Q U : nat -> R) : Prop := 0 <= Q_0 <= Q O /\\ 0 <="
            " U_0 <= U O /\\ (forall n, (n <= S N)%nat -> let P := PinnedThreeBalls.P alpha "
            "(rho n) (Q n, U n) in 0 <= Q n /\\ 0 <= U n <= U_b /\\ 0 <= U (S n) <= U_b /\\ 0 "
            "< P /\\ r * G * (1 - U n) <= Q (S n) * P /\\ PinnedThreeBalls.L (rho n) (Q n, U "
            "n) <= U (S n) * (2 - U (S n)) * P ^ 2) /\\ Q (S (S N)) <= Q N /\\ U (S (S N)) <="
            " U N."
        ),
        (
            "Definition numbers : Prop := 0 < r /\\ 1 <= G /\\ (1 + r) / 2 * G < 1 /\\ 0 < "
            "slow /\\ slow <= w B2 /\\ slow <= w B1 /\\ U_0 <= U_b < 1 /\\ Theta < C_0 <= 1."
        ),
        (
            "Definition closing d (x v : ball -> nat -> R) : R := - rate d x v B0 B2 / "
            "distance d x B0 B2."
        ),
        (
            "Definition start d (x v : ball -> nat -> R) : Prop := let y := closing d x v "
            "in let gap := distance d x B0 B2 - 1 in let fall := (1 + r) / 2 * G in let "
            "gain := fall / (1 - fall ^ 2) in let speed b := sqrt (dot d (from_to v B0 b) "
            "(from_to v B0 b)) in distance d x B0 B1 = 1 /\\ 0 < gap /\\ 0 < y /\\ 0 < rate d "
            "x v B0 B1 <= Q_0 * y /\\ gap * (2 + gap) * w B2 ^ 2 <= U_0 * (2 - U_0) * (1 + "
            "gap) ^ 2 * y ^ 2 /\\ U_b * (2 - U_b) * y ^ 2 * G ^ 2 <= slow ^ 2 * (G ^ 2 - 1) "
            "/\\ speed B2 <= w B2 - fall * gain * y /\\ speed B1 <= w B1 - gain * y /\\ Rabs "
            "(minus_cosine d x - C_0) + (w B2 + w B1 + y) * (G * U_b / slow / slow) / (1 - "
            "fall) * y <= Theta."
        ),
        (
            "Definition sandwich_theorem : Prop := forall d r G slow U_b C_0 Theta Q_0 U_0 "
            "w x v, numbers r G slow U_b C_0 Theta U_0 w -> endless_map r G U_b C_0 Theta "
            "Q_0 U_0 w -> start r G slow U_b C_0 Theta Q_0 U_0 w d x v -> collapse d r x v "
            "(G * U_b / slow / slow / (1 - (1 + r) / 2 * G) * closing d x v) C_0 Theta."
        ),
        (
            "Definition stairs_theorem : Prop := forall r G U_b C_0 Theta Q_0 U_0 w N Q U, "
            "0 < r -> 1 <= G -> U_b < 1 -> Theta < C_0 -> stairs r G U_b C_0 Theta Q_0 U_0 "
            "w N Q U -> endless_map r G U_b C_0 Theta Q_0 U_0 w."
        ),
        "Print Assumptions sandwich_proved.",
    ),
    "PinnedOutside": (
        (
            "Definition strike d x v (i j : ball) : Prop := distance d x i j = 1 /\\ rate d "
            "x v i j < 0."
        ),
        "Definition closing d x v i j : R := - rate d x v i j / distance d x i j.",
        (
            "Definition zeta d x v i j : R := let e := distance d x i j in (e ^ 2 - 1) / e "
            "^ 2 * (dot d (from_to v i j) (from_to v i j) / closing d x v i j ^ 2)."
        ),
        (
            "Definition next_theorem : Prop := forall d x v i j t, 1 < distance d x i j -> "
            "0 < t -> strike d (moved t x v) v i j -> 0 < closing d x v i j /\\ zeta d x v i"
            " j < 1 /\\ t = (distance d x i j ^ 2 - 1) / distance d x i j / closing d x v i "
            "j / (1 + sqrt (1 - zeta d x v i j))."
        ),
        "Definition c_ (n : nat) : ball := if Nat.even n then B2 else B1.",
        "Definition s_ (n : nat) : ball := if Nat.even n then B1 else B2.",
        "Definition alpha : R := (1 + r) / 2 * G * C_most.",
        "Definition rho (n : nat) : R := (v_ (s_ n) / w_ (c_ n)) ^ 2.",
        (
            "Fixpoint orbit (n : nat) : R * R := match n with O => (Q_0, U_0) | S n => "
            "PinnedThreeBalls.next alpha (rho n) r (orbit n) end."
        ),
        (
            "Definition ends (rho : R) (p : R * R) : Prop := PinnedThreeBalls.P alpha rho p"
            " <= 0 \\/ PinnedThreeBalls.P alpha rho p ^ 2 <= PinnedThreeBalls.L rho p."
        ),
        "Definition map_ends (N : nat) : Prop := ends (rho N) (orbit N).",
        (
            "Definition floor (N : nat) (Q U : nat -> R) : Prop := Q O <= Q_0 /\\ U O <= U_0"
            " /\\ (forall n, (n <= N)%nat -> 0 <= Q n /\\ 0 <= U n <= 1) /\\ (forall n, (n < "
            "N)%nat -> let P := PinnedThreeBalls.P alpha (rho n) (Q n, U n) in Q (S n) * P "
            "<= r * (1 - U n) /\\ U (S n) * (2 - U (S n)) * P ^ 2 <= PinnedThreeBalls.L (rho"
            " n) (Q n, U n)) /\\ ends (rho N) (Q N, U N)."
        ),
        (
            "Definition numbers : Prop := 0 < r /\\ 1 <= G /\\ (1 + r) / 2 * G < 1 /\\ 0 < "
            "slow /\\ slow <= v_ B2 /\\ slow <= v_ B1 /\\ C_most <= 2 /\\ 0 <= Q_0 /\\ 0 <= U_0 "
            "< 1."
        ),
        (
            "Definition speed d (v : ball -> nat -> R) b : R := sqrt (dot d (from_to v B0 "
            "b) (from_to v B0 b))."
        ),
        (
            "Definition start d (x v : ball -> nat -> R) : Prop := distance d x B0 B1 = 1 "
            "/\\ let y := closing d x v B0 B2 in let eta := rate d x v B0 B1 in let gap := "
            "distance d x B0 B2 - 1 in let gain := G / (1 - (1 + r) / 2 * G) in let turning"
            " := (w_ B2 + w_ B1 + 2 * y) * (G / slow / slow) / (1 - (1 + r) / 2 * G) in 0 <"
            " gap /\\ 0 < y /\\ 0 < eta /\\ Q_0 * y <= eta /\\ U_0 * (2 - U_0) * (1 + gap) ^ 2 "
            "* y ^ 2 <= gap * (2 + gap) * v_ B2 ^ 2 /\\ y ^ 2 * G ^ 2 <= slow ^ 2 * (G ^ 2 -"
            " 1) /\\ v_ B2 + gain * y <= speed d v B2 <= w_ B2 - gain * y /\\ v_ B1 + gain * "
            "y <= speed d v B1 <= w_ B1 - gain * y /\\ 0 <= C_most - turning * y /\\ "
            "minus_cosine d x <= C_most - turning * y."
        ),
        (
            "Definition strikes_in_turn d T (X V : R -> ball -> nat -> R) (time : nat -> R)"
            " (M : nat) : Prop := time O = 0 /\\ forall n, (n < M)%nat -> time n < time (S "
            "n) < T /\\ (forall t, time n <= t < time (S n) -> X t = moved (t - time n) (X "
            "(time n)) (V (time n)) /\\ V t = V (time n)) /\\ strike d (moved (time (S n) - "
            "time n) (X (time n)) (V (time n))) (V (time n)) B0 (c_ n)."
        ),
        (
            "Definition outside_theorem : Prop := forall d r G slow C_most Q_0 U_0 v_ w_ x "
            "v N, numbers r G slow C_most Q_0 U_0 v_ -> start r G slow C_most Q_0 U_0 v_ w_"
            " d x v -> map_ends r G C_most Q_0 U_0 v_ w_ N -> forall T X V time, trajectory"
            " d r x v T X V -> ~ strikes_in_turn d T X V time (N + 2)."
        ),
        (
            "Definition floor_theorem : Prop := forall r G slow C_most Q_0 U_0 v_ w_ N Q U,"
            " numbers r G slow C_most Q_0 U_0 v_ -> 0 <= C_most -> floor r G C_most Q_0 U_0"
            " v_ w_ N Q U -> exists M, (M <= N)%nat /\\ map_ends r G C_most Q_0 U_0 v_ w_ M."
        ),
        (
            "Definition no_collapse : Prop := forall d r G slow C_most Q_0 U_0 v_ w_ x v N,"
            " numbers r G slow C_most Q_0 U_0 v_ -> start r G slow C_most Q_0 U_0 v_ w_ d x"
            " v -> map_ends r G C_most Q_0 U_0 v_ w_ N -> forall by_time c tolerance, ~ "
            "collapse d r x v by_time c tolerance."
        ),
        "Print Assumptions outside_proved.",
    ),
    "PinnedAlexander": (
        "Definition vector : Set := nat -> R.",
        (
            "Fixpoint dot (d : nat) (u v : vector) : R := match d with O => 0 | S k => dot k "
            "u v + u k * v k end."
        ),
        (
            "Definition S_ (A kappa y : R) : R := let gap := kappa * y ^ 2 in sqrt (1 - A * "
            "kappa * (2 + gap) / (1 + gap) ^ 2)."
        ),
        (
            "Definition T_ (A kappa y : R) : R := let gap := kappa * y ^ 2 in kappa * (2 + "
            "gap) / ((1 + gap) * (1 + S_ A kappa y))."
        ),
        (
            "Definition collision_theorem : Prop := forall d e beta kappa y q (n_s n_c V_s "
            "V_c : vector), let A := dot d V_c V_c in let B := dot d V_s V_s in let gap := "
            "kappa * y ^ 2 in let S := S_ A kappa y in let T := T_ A kappa y in let U := y * "
            "(1 + gap) * S in let x_c := fun i => (1 + gap) * n_c i + y * T * V_c i in let "
            "x_s := fun i => n_s i + y * T * V_s i in let E := sqrt (dot d x_s x_s) in let "
            "m_s := fun i => x_s i / E in let W_c := fun i => V_c i + (1 + e) * U * x_c i in "
            "let W_s := fun i => V_s i + beta * U * x_c i in let p := - dot d m_s W_s / y in "
            "let q' := dot d x_c W_c / (p * y) in let kappa' := (E - 1) / (p * y) ^ 2 in 0 < "
            "e -> 0 < beta -> 0 < kappa -> 0 < y -> 0 < q -> dot d n_s n_s = 1 -> dot d n_c "
            "n_c = 1 -> dot d n_s V_s = q * y -> dot d n_c V_c = - y -> 0 < S -> 0 < p -> "
            "(dot d x_c x_c = 1 /\\ dot d x_c V_c = - U) /\\ (E ^ 2 = 1 + y ^ 2 * (T * (2 * q"
            " + B * T)) /\\ p = beta * (1 + gap) * - dot d x_c m_s * S - (q + B * T) / E /\\ "
            "q' = e * (1 + gap) * S / p /\\ kappa' = T * (2 * q + B * T) / ((1 + E) * p ^ 2))"
            " /\\ forall i, x_c i = n_c i + y * (kappa * y * n_c i + T * V_c i) /\\ E * m_s i"
            " = n_s i + y * (T * V_s i) /\\ W_c i - e * U * x_c i = V_c i + y * n_c i + y * "
            "((1 + gap) * S * x_c i - n_c i) /\\ W_s i + p * y * m_s i = V_s i - q * y * n_s "
            "i + y * (beta * (1 + gap) * S * x_c i + p * m_s i + q * n_s i)."
        ),
        "Definition p_ (q kappa : R) : R := alpha * S_ A kappa 0 - q - B * T_ A kappa 0.",
        "Definition next_q (q kappa : R) : R := e * S_ A kappa 0 / p_ q kappa.",
        (
            "Definition next_kappa (q kappa : R) : R := T_ A kappa 0 * (2 * q + B * T_ A "
            "kappa 0) / (2 * p_ q kappa ^ 2)."
        ),
        (
            "Definition below (q kappa Q K : R) : Prop := 0 < alpha /\\ 0 < e /\\ 0 <= A /\\ "
            "0 <= B /\\ 0 < q <= Q /\\ 0 < kappa <= K /\\ 2 * A * K < 1 /\\ 0 < p_ Q K."
        ),
        (
            "Definition order_theorem : Prop := forall alpha e A B q kappa Q K, below alpha e"
            " A B q kappa Q K -> let p := p_ alpha A B q kappa in let P := p_ alpha A B Q K "
            "in let q' := next_q alpha e A B q kappa in let Q' := next_q alpha e A B Q K in "
            "let kappa' := next_kappa alpha A B q kappa in let K' := next_kappa alpha A B Q K"
            " in 0 < P <= p /\\ (alpha * A + B) * (K - kappa) + (Q - q) <= p - P /\\ 0 < q' "
            "<= Q' /\\ 0 < kappa' <= K' /\\ kappa' / K' <= kappa / K * (P / p) ^ 2 /\\ e * (q"
            " * A + B) * (K - kappa) / (p * P) <= Q' - q'."
        ),
        (
            "Definition growth_theorem : Prop := forall alpha e A B q kappa Q K m l M c, "
            "below alpha e A B q kappa Q K -> kappa < K -> 0 < m <= alpha * A + B -> l <= "
            "kappa -> p_ alpha A B Q K <= M -> 0 < c -> c * M <= 2 * (m * l) -> c * M <= 2 ->"
            " let x := K / kappa - 1 in 1 + x + c * (x + (Q - q)) <= next_kappa alpha A B Q K"
            " / next_kappa alpha A B q kappa."
        ),
        (
            "Definition beneath_theorem : Prop := forall alpha e A B q kappa Q K m c L, below"
            " alpha e A B q kappa Q K -> 0 < m <= alpha * A + B -> 0 < c <= K -> kappa / K <="
            " L < 1 -> next_kappa alpha A B q kappa / next_kappa alpha A B Q K <= (1 - m * (1"
            " - L) * c / alpha) * (kappa / K)."
        ),
        (
            "Definition two_orbits_theorem : Prop := forall c K g (x D Y H : nat -> R), 0 < c"
            " <= 1 -> 1 <= K -> 0 <= g -> 80 * K ^ 3 * g <= c ^ 3 -> 0 < x O -> D O = 0 -> Y "
            "O = 0 -> H O = 0 -> (forall n, let off := H n + g * Y n + g * (x n + D n) in x n"
            " + c * (x n + D n) - K * off <= x (S n) /\\ c * x n - K * off <= D (S n) /\\ D "
            "(S n) <= K * (x n + D n + H n + g * Y n) /\\ Y (S n) <= Y n + K * (x n + D n + H"
            " n + g * Y n) /\\ 0 <= H (S n) <= H n + K * g * (x n + D n + H n + Y n)) -> "
            "forall n, x O * (1 + c / 2) ^ n <= x n /\\ 0 <= D n."
        ),
        "Definition next_z (e f D z : R) : R := D - e - f - e * f / z.",
        "Definition factor (e D z : R) : R := e * (D - e - z) / ((z + e) * z ^ 2).",
        (
            "Definition turn_theorem : Prop := forall a a' e f q, let p := a - q in let q' :="
            " e / p in let p' := a' - q' in let q'' := f / p' in let p'' := a - q'' in let z "
            ":= p * p' in 0 < e -> 0 < p -> 0 < p' -> 0 < p'' -> q / p ^ 2 * (q' / p' ^ 2) = "
            "factor e (a * a') z /\\ p'' * (a' - e / p'') = next_z e f (a * a') z."
        ),
        (
            "Definition trap_theorem : Prop := forall e f t D h, 0 < e -> 0 < f -> 0 < t -> 0"
            " < h -> t ^ 3 = e * f -> e + f + t + t ^ 2 < D -> factor e D h = 1 -> (t < h < "
            "next_z e f D h) /\\ exists rho, 0 <= rho < 1 /\\ forall z kappa : nat -> R, 0 < "
            "z O -> (forall n, 0 < kappa n /\\ z (S n) = next_z e f D (z n) /\\ kappa (S n) ="
            " factor e D (z n) * kappa n) -> kappa 1%nat <= kappa O -> forall n, h <= z n /\\"
            " kappa (S n) <= kappa 1%nat * rho ^ n."
        ),
        (
            "Definition threshold_theorem : Prop := forall e f t z, 0 < e -> 0 < t -> 0 < z "
            "-> t ^ 3 = e * f -> let D := e + f + t + t ^ 2 in (t <= z -> next_z e f D z - t "
            "<= t * (z - t) /\\ 1 - (1 + 3 * t) / t ^ 2 * (z - t) <= factor e D z) /\\ (z <= "
            "t -> next_z e f D z <= t /\\ 1 <= factor e D z)."
        ),
        (
            "Definition stays_theorem : Prop := forall t m L (kappa x eps : nat -> R), t < 1 "
            "-> m < 1 -> 0 < L -> (forall n, 0 < kappa n /\\ 0 <= x n /\\ 0 <= eps n /\\ x (S"
            " n) <= t * x n + eps n /\\ eps (S n) <= m * eps n /\\ kappa n * (1 - L * x n - "
            "eps n) <= kappa (S n)) -> let W := (L * x O + (1 - t + L) / (1 - m) * eps O) / "
            "(1 - t) in W < 1 -> forall n, kappa O * (1 - W) <= kappa n."
        ),
    ),
    "PinnedSpectrum": (
        (
            "forall d r x v w u e f, triangle d x -> triple d r x v w -> coordinates d 1 x v u e "
            "f -> coordinates d 1 x w (image r u) e f."
        ),
        (
            "exists v w u e f, triple d r x v w /\\ coordinates d (-1) x v u e f /\\ ~ "
            "coordinates d (-1) x w (image r u) e f."
        ),
        (
            "collide d r x v B0 B1 v_1 /\\ collide d r x v_1 B0 B2 v_2 /\\ collide d r x v_2 B1 "
            "B2 w."
        ),
        (
            "forall r, 0 < r < 1 -> exists l_0 re im, -1 < - r < l_0 /\\ l_0 < - r ^ 3 < 0 /\\ 0 "
            "< im /\\ 0 < l_0 ^ 2 < re ^ 2 + im ^ 2 /\\ re ^ 2 + im ^ 2 < 1 /\\ (forall l, Q r l "
            "= 0 <-> l = l_0) /\\"
        ),
        (
            "(forall mu nu, (exists u v, eigenvector r mu nu u v) <-> mu = 1 /\\ nu = 0 \\/ mu = "
            "l_0 /\\ nu = 0 \\/ mu = re /\\ nu = im \\/ mu = re /\\ nu = - im) /\\"
        ),
        (
            "exists a b, u' = combination a u (- b) v /\\ v' = combination b u a v) /\\ (forall "
            "u, image r u = u <-> exists y, u = Column 0 y 0 y)."
        ),
        "= (l - 1) * Q r l.",
        (
            "exists q, 0 < q < 1 /\\ forall u, exists y K, forall n, close_to (K * q ^ n) (orbit "
            "r u n) (Column 0 y 0 y)."
        ),
        "Print Assumptions all_proved.",
    ),
}
#: Each makes one of these pages say less: in the page alone nothing else would see it.
WEAKER = (
    ("PinnedPrintedSign", "(2 <= d)%nat", "(d = 2)%nat"),
    ("PinnedPrintedSign", "(2 <= d)%nat -> 0 < r", "(d = 2)%nat -> 0 < r"),
    ("PinnedPrintedSign", "0 < spin2 d x v", "1 < spin2 d x v"),
    ("PinnedPrintedSign", "~ as_printed_at d r theta_0 delta_theta) /", "True) /"),
    ("PinnedPrintedSign", "has_interior d set /\\", "(exists x v, set x v) /\\"),
    ("PinnedPrintedSign", "0 < delta_theta.", "0 <= delta_theta."),
    ("PinnedPrintedSign", "in_turn_from N i j B0 a b", "in_turn_from N i j a B0 b"),
    ("PinnedPrintedSign", "+ delta_theta < 4 * sqrt r / (1 + r)) /\\", "+ delta_theta < 4) /\\"),
    ("PinnedClassification", "4 * sqrt r / (1 + r) <=", "3 * sqrt r / (1 + r) <="),
    ("PinnedClassification", "(from_to at_T o c) <= 0.", "(from_to at_T o c) <= 1."),
    ("PinnedClassification", "collisions d (fun _ => m)", "collisions 2 (fun _ => m)"),
    ("PinnedClassification", "    - r * rate d (places", "    - rate d (places"),
    ("PinnedClassification", "~ (exists T, Un_cv time T) ->", "(exists T, Un_cv time T) ->"),
    ("PinnedClassification", "(velocities n)) <= 0) /\\", "(velocities n)) <= 1) /\\"),
    ("PinnedClassification", "mass B1 * mass B2 * f B1 B2", "mass B1 * f B1 B2"),
    ("PinnedClassification", "(velocities n) k l) = 0)", "(velocities n) k k) = 0)"),
    ("PinnedBounds", "forall d last mass sigma", "forall d mass sigma"),
    ("PinnedBounds", "    0 <= t n /\\", "    0 < t n /\\"),
    ("PinnedBounds", "sum_f_R0 J n <= bound", "J n <= bound"),
    ("PinnedBounds", "(2 <= n < k)%nat", "(1 <= n < k)%nat"),
    ("PinnedBounds", "forall n, (1 <= n < k)%nat -> 0 < s n.", "(2 < k)%nat -> 0 < s 2%nat."),
    ("PinnedBounds", "(1 <= d)%nat -> 0 < m", "(2 <= d)%nat -> 0 < m"),
    ("PinnedBounds", "0 < r <= 7 - 4 * sqrt 3", "0 < r <= 6 - 4 * sqrt 3"),
    ("PinnedClassification", "0 < m -> (forall b, 0 < rad", "0 < m -> (forall b, 1 < rad"),
    ("PinnedClassification", "7 - 4 * sqrt 3 < r \\/", "1 < r \\/"),
    ("PinnedClassification", "6 <= size d x \\/", "7 <= size d x \\/"),
    ("PinnedClassification", "0 <= rate d x w i j <=", "0 < rate d x w i j <="),
    ("PinnedLine", "2 * Q < 1.", "2 * Q < 0."),
    ("PinnedLine", "0 < gap /\\ 0 < closing", "0 < gap /\\ closing < 0"),
    ("PinnedLine", "rate d x w i j = - r *", "rate d x w i j >= - r *"),
    ("PinnedLine", "Nat.even n then c else a", "Nat.even n then a else c"),
    ("PinnedLine", "b * b' * Q", "b * b * Q"),
    ("PinnedLine", "(k < d)%nat", "(k < 2)%nat"),
    ("PinnedLine", "T <= (1 - Q)", "T <= 2 * (1 - Q)"),
    ("PinnedLine", "rate d (moved t x v) v i j < 0", "rate d (moved t x v) v i j <= 0"),
    ("PinnedLine", "(gap / closing)) 1 0.", "(gap / closing)) 1 2."),
    ("PinnedThreeBalls", "0 < r b <= 1)", "0 < r b < 1)"),
    ("PinnedThreeBalls", "0 < gap /\\ 0 < y", "0 < gap /\\ y < 0"),
    ("PinnedThreeBalls", "Nat.even n then c else a.", "Nat.even n then a else c."),
    ("PinnedThreeBalls", "part d mass (r (c_ n))", "part d mass (r c)"),
    ("PinnedThreeBalls", "forall d mass radius r o a c", "forall mass radius r o a c"),
    ("PinnedThreeBalls", "T <= E c *", "T <= 2 * E c *"),
    ("PinnedThreeBalls", "- C_0) <= Theta.", "- C_0) <= 2 * Theta."),
    ("PinnedThreeBalls", "distance d at_T o c = radius", "distance d at_T o c >= radius"),
    ("PinnedThreeBalls", "mass b / (mass o + mass b)", "mass b / (mass b + mass b)"),
    ("PinnedThreeBalls", "forall n, 0 < P (alpha n)", "forall n, 0 <= P (alpha n)"),
    ("PinnedThreeBalls", "(n <= S N)%nat", "(n <= S (S N))%nat"),
    ("PinnedThreeBalls", "(radius a + radius c) ^ 2 <", "(radius a + radius c) ^ 2 <="),
    ("PinnedThreeBalls", "B0 B2 x v) C_0 Theta.", "B0 B2 x v) C_0 (2 * Theta)."),
    ("PinnedThreeBalls", "meet_first d radius (places n)", "meet_first 2 radius (places n)"),
    ("PinnedThreeBalls", "u' o c i y lam'", "u' o i c y lam'"),
    ("PinnedThreeBalls", "0 < kap /\\", "kap < 0 /\\"),
    ("PinnedThreeBalls", "(1 + mass o / mass c)", "(1 + mass c / mass o)"),
    ("PinnedSandwich", "0 < gap /\\ 0 < y", "0 < gap /\\ y < 0"),
    ("PinnedSandwich", "(r * G) (orbit n)", "r (orbit n)"),
    ("PinnedSandwich", "w (s_ n) / w (c_ n)", "w (c_ n) / w (s_ n)"),
    ("PinnedSandwich", "Theta < C_0 <= 1.", "Theta < C_0 <= 0."),
    ("PinnedSandwich", "collapse d r x v (G", "collapse d r x v (2 * G"),
    ("PinnedSandwich", "(n <= S N)%nat", "(n <= S (S N))%nat"),
    ("PinnedOutside", "rate d x v i j < 0.", "rate d x v i j < 1."),
    ("PinnedOutside", "zeta d x v i j < 1 /\\", "True /\\"),
    ("PinnedOutside", "Nat.even n then B2 else B1.", "Nat.even n then B1 else B2."),
    ("PinnedOutside", "(1 + r) / 2 * G * C_most.", "(1 + r) / 2 * C_most."),
    ("PinnedOutside", "(v_ (s_ n) / w_ (c_ n)) ^ 2", "(v_ (c_ n) / w_ (s_ n)) ^ 2"),
    ("PinnedOutside", "rho p <= 0 \\/", "rho p <= - 1 \\/"),
    ("PinnedOutside", "(n < N)%nat -> let P", "(n <= N)%nat -> let P"),
    ("PinnedOutside", "(M <= N)%nat /\\ map_ends", "map_ends"),
    ("PinnedOutside", "0 < gap /\\ 0 < y", "0 < gap /\\ y < 0"),
    ("PinnedOutside", "(1 + r) / 2 * G < 1 /\\", "(1 + r) / 2 * G < 0 /\\"),
    ("PinnedOutside", "speed d v B2 <= w_ B2 - gain * y", "speed d v B2 <= 0"),
    ("PinnedOutside", "X V time (N + 2).", "X V time (N + 3)."),
    ("PinnedOutside", "X V time, trajectory d r x v T X V ->", "X V time, T < 0 ->"),
    ("PinnedOutside", "time n < time (S n) < T /\\", "time n < time (S n) < 0 /\\"),
    ("PinnedOutside", "forall d r G slow", "let d := 2%nat in forall r G slow"),
    ("PinnedOutside", "~ collapse d r x v by", "by_time < 0 -> ~ collapse d r x v by"),
    ("PinnedAlexander", "dot d n_c V_c = - y ->", "dot d n_c V_c = - y -> d = 2%nat ->"),
    ("PinnedAlexander", "0 < e -> 0 < beta", "e = beta -> 0 < beta"),
    ("PinnedAlexander", "E * m_s i = n_s i + y * (T * V_s i)", "E * m_s i = x_s i"),
    ("PinnedAlexander", "0 <= A /\\ 0 <= B", "0 < A /\\ 0 < B"),
    ("PinnedAlexander", "0 < q' <= Q' /\\", "True /\\"),
    ("PinnedAlexander", "(alpha * A + B) * (K - kappa) + (Q - q)", "alpha * A * (K - kappa)"),
    ("PinnedAlexander", "(P / p) ^ 2 /\\", "(P / p) /\\"),
    ("PinnedAlexander", "c * M <= 2 * (m * l)", "c * M <= m * l"),
    ("PinnedAlexander", "1 + x + c * (x + (Q - q))", "1 + x"),
    ("PinnedAlexander", "kappa / K <= L < 1", "kappa / K <= L < 1 / 2"),
    ("PinnedAlexander", "80 * K ^ 3 * g", "81 * K ^ 3 * g"),
    ("PinnedAlexander", "x O * (1 + c / 2) ^ n", "x O"),
    ("PinnedAlexander", "0 <= H (S n) <= H n", "0 <= H (S n) <= 0 * H n"),
    ("PinnedAlexander", "= next_z e f (a * a') z.", "= p'' * (a' - e / p'')."),
    ("PinnedAlexander", "e + f + t + t ^ 2 < D", "e + f + t + 2 * t ^ 2 < D"),
    ("PinnedAlexander", "0 <= rho < 1", "0 <= rho"),
    ("PinnedAlexander", "t * (z - t) /\\", "(z - t) /\\"),
    ("PinnedAlexander", "/\\ 1 <= factor e D z", "/\\ 0 <= factor e D z"),
    ("PinnedAlexander", "kappa O * (1 - W) <=", "0 * (1 - W) <="),
    ("PinnedSpectrum", "0 < im /\\", "0 <= im /\\"),
    ("PinnedSpectrum", "re ^ 2 + im ^ 2 < 1 /\\", "re ^ 2 + im ^ 2 <= 1 /\\"),
    ("PinnedSpectrum", "eigenvector r mu nu u v) <->", "eigenvector r mu nu u v) ->"),
    ("PinnedSpectrum", "v_2 B1 B2 w.", "v_2 B2 B1 v."),
)  # fmt: skip


def unsaid(page: str, text: str) -> list[str]:
    """What a page does not say although it has to."""
    text = " ".join(text.split())
    return [sentence for sentence in SAID[page] if sentence not in text]


def test_the_pages_say_the_whole_theorems() -> None:
    for page in SAID:
        text = (SOURCES / f"{page}.v").read_text()
        assert unsaid(page, text) == []
        assert not re.search(r"^(Notation|Infix|Axiom|Parameter|Hypothesis)", text, re.MULTILINE)
        assert re.findall(r"^From Verify Require Import (.*)\.$", text, re.MULTILINE) in (
            [], ["Pinned"], ["Pinned PinnedClassification"],
            ["Pinned PinnedClassification PinnedLine"],
        )  # fmt: skip


def test_a_page_that_says_less_is_seen() -> None:
    for page, old, new in WEAKER:
        text = (SOURCES / f"{page}.v").read_text()
        assert text.count(old) >= 1, old
        assert unsaid(page, text.replace(old, new)), (page, old)


def test_a_matrix_is_the_same_on_both_pages() -> None:
    page, pinned = ((SOURCES / f"{name}.v").read_text() for name in ("Spectrum", "PinnedSpectrum"))
    for name in ("image", "Q", "det2", "det4", "combination", "r_of", "eigenvector_of"):
        found = [
            re.findall(rf"^Definition {name} .*?\.$", text, re.DOTALL | re.MULTILINE)
            for text in (page, pinned)
        ]
        assert len(found[0]) == 1
        assert found[0] == found[1], name
