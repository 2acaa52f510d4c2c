"""The page with the separatrix theorem in Coq can be read alone, and the theorem is what it says.

That it is proved is for Coq to say: `verify/coq/build`.
"""

from __future__ import annotations

import re
from pathlib import Path

SOURCES = Path(__file__).resolve().parents[2] / "verify/coq"
PAGE = (SOURCES / "Separatrix.v").read_text()


def test_the_page_has_only_definitions() -> None:
    imports = re.findall(r"^.*\bImport\b.*$", PAGE, re.MULTILINE)
    assert imports == ["From Coq Require Import Reals Arith."]
    words = "Theorem|Lemma|Proof|Axiom|Parameter|Hypothesis|Notation"
    assert not re.search(f"^({words})\\b", PAGE, re.MULTILINE)


def test_the_theorem_is_what_the_page_says() -> None:
    assert PAGE.count("separatrix_theorem") == 1
    assert "Definition separatrix_theorem : Prop :=\n  forall r a rho s, 0 < r < 1 ->" in PAGE
    last = (SOURCES / "SeparatrixProof.v").read_text()
    assert "Lemma separatrix : separatrix_theorem.\nProof.\n" in last
    assert "\nCheck (separatrix : separatrix_theorem).\n" in last
    assert last.endswith(").\nPrint Assumptions separatrix.\n")


def test_the_proof_uses_no_certificate() -> None:
    for path in SOURCES.glob("Separatrix*.v"):
        imported = re.findall(r"^From Verify Require Import (.*)\.$", path.read_text(), re.M)
        names = {name for line in imported for name in line.split()}
        assert all(name.startswith("Separatrix") for name in names), path.name
