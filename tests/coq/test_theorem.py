"""The page with Theorem 1 in Coq can be read alone, and what is proved is what it says.

That it is proved is for Coq to say, in `.ci/coq`.
"""

from __future__ import annotations

import re
from pathlib import Path

SOURCES = Path(__file__).resolve().parents[2] / "verify/coq"
PAGE = (SOURCES / "Theorem1.v").read_text()


def test_the_page_has_only_definitions() -> None:
    assert re.findall(r"^.*\bImport\b.*$", PAGE, re.MULTILINE) == [
        "From Coq Require Import Reals List Arith.",
        "Import ListNotations.",
    ]
    words = "Theorem|Lemma|Proof|Axiom|Parameter|Hypothesis|Notation"
    assert not re.search(f"^({words})\\b", PAGE, re.MULTILINE)


def test_the_theorem_is_what_the_page_says() -> None:
    assert re.search(
        r"^Definition theorem_1 : Prop :=\n  forall r c V_0 delta_theta, admis", PAGE, re.M
    )
    assert re.search(r"^Definition not_empty : Prop :=\n(.*\n)  forall d, \(2 <= d\)", PAGE, re.M)
    last = (SOURCES / "Inhabited.v").read_text()
    assert "Theorem theorem_1_proved : theorem_1 /\\ not_empty /\\ determined.\n" in last
    assert last.endswith("Qed.\nPrint Assumptions theorem_1_proved.\n")


def test_everything_of_the_proof_is_compiled() -> None:
    scripts = ("build", "build-theorem", "build-separatrix")
    build = "".join((SOURCES / script).read_text() for script in scripts)
    compiled = {
        word for names in re.findall("for name in (.*); do", build) for word in names.split()
    }
    assert compiled == {path.stem for path in SOURCES.glob("*.v")} - {"Extract"} | {"Step", "All"}
