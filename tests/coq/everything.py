"""What `.ci/coq` has compiled, asked of Coq at once.

    python -m tests.coq.everything DIRECTORY     # writes Everything.v and Printed.v there

Everything.v has a definition for each committed certificate, whose type says that its statement is
true: a file that proves something else, or nothing, stops it there. Printed.v prints the statements
as Coq has them.
"""

from __future__ import annotations

import json
import sys
from pathlib import Path

from tests.coq.closing import ROOT, module, unread
from verify.paper.in_coq import IN_COQ

#: What Theorem1.v says and Pinned.v says once more, each of them proved.
SENTENCES = (
    "theorem_1", "interior", "positive_volume", "determined", "constants_defined",
    "same_hypothesis", "printed_theorem",
)  # fmt: skip
#: What follows from the point runs at r = 0.03, and at r = 0.01 and theta_0 = 5 pi / 6.
POINTS = (
    "Definition point : forall d s d_0 y, FromNumbers.initial_with",
    "  (Theorem1.phi_minus (3 / 100) 1) (637 / 1000000) (13 / 25000000) (147 / 10000000)",
    "  (59 / 6250000) 1 (1249 / 1000) (59 / 1000000) 1 d s d_0 y ->",
    "  Theorem1.collapse d (3 / 100) s (89 / 1000000000000) 1 (1 / 10)",
    "  := Point.three_balls_collapse.",
    "Definition angle : forall d s d_0 y, FromNumbers.initial_with",
    "  (Theorem1.phi_minus (1 / 100) (- cos (PI * (5 / 6)))) (291 / 500000) (289 / 500000000)",
    "  (161 / 10000000) (427 / 50000000) 1 (11 / 8) (647 / 10000000) (- cos (PI * (5 / 6)))",
    "  d s d_0 y -> Theorem1.collapse d (1 / 100) s (463 / 5000000000000)",
    "  (- cos (PI * (5 / 6))) (1 / 10) := Angle.three_balls_collapse.",
)
PARTS = ("the_nodes", "the_contexts", "the_rows", "the_citations", "the_statement")


def conjunction(prefix: str) -> str:
    """What is said of three balls, by names with a prefix."""
    return " /\\ ".join(f"{prefix}{name}" for name in SENTENCES)


def discharging() -> list[str]:
    """The theorems and definitions in Coq that stand for sentences taken on trust."""
    sentences = [names for found in IN_COQ.values() for names in found.values()]
    return [*dict.fromkeys(name for names in sentences for name in names)]


def folders() -> list[Path]:
    """Those with a certificate that the checker in Coq can read; each statement has to have one."""
    found = sorted(path.parent for path in ROOT.rglob("certificate.json"))
    if found != sorted(path.parent for path in ROOT.rglob("statement.json")) or not found:
        raise SystemExit("a folder has a statement without a certificate, or there are none")
    return [folder for folder in found if folder not in unread()]


def everything(folders: list[Path]) -> str:
    """The theorems about what is committed, one with another, and what they assume."""
    own = {module(folder): folder for folder in folders}
    lines = [f"From Verify Require {name}." for name in own]
    lines += [
        "From Verify Require Meaning Checker Accepted Closed Point Angle Pinned PinnedMeaning.",
        "From Coq Require Import Reals.",
        "From Verify Require Theorem1 FromNumbers.",
        "Open Scope R_scope.",
        *POINTS,
        "Definition soundness : forall S C, Checker.accepts S C = true ->",
        "  Meaning.citations_true S -> Meaning.true_statement S := Accepted.accepts_sound.",
        f"Definition theorem_1 : {conjunction('Pinned.')}",
        "  := Pinned.proved.",
        "From Verify Require Separatrix SeparatrixProof.",
        "Definition separatrix : Separatrix.separatrix_theorem := SeparatrixProof.separatrix.",
    ]
    theorems = discharging()
    files = dict.fromkeys(["Sentences", *(name.split(".")[0] for name in theorems)])
    lines.append(f"From Verify Require {' '.join(files)}.")
    lines.append(f"Definition discharged := ({', '.join(theorems)}).")
    for name, folder in own.items():
        cites = json.loads((folder / "statement.json").read_bytes())["cites"]
        proof = f"Closed.closed_{name}" if cites else f"{name}.proved"
        lines.append(f"Definition true_{name} : Meaning.true_statement {name}.the_statement")
        lines.append(f"  := {proof}.")
    names = "".join(f", true_{name}" for name in own)
    main = "soundness, theorem_1, point, angle, Pinned.collapsing_scene, separatrix, discharged"
    lines.append(f"Definition everything := ({main}{names}).")
    return "\n".join([*lines, "Print Assumptions everything.", ""])


def printed(folders: list[Path]) -> str:
    """Coq prints the data of each statement, in the notation in which they were written."""
    names = [module(folder) for folder in folders]
    lines = [
        "From Coq Require Import ZArith List.",
        f"From Verify Require Import Meaning. From Verify Require {' '.join(names)}.",
        "Import ListNotations.",
        "Open Scope positive_scope.",
        "Set Printing Width 100000000. Set Printing Depth 100000000. Unset Printing Records.",
        *(f"Print {name}.{part}." for name in names for part in PARTS),
    ]
    return "\n".join([*lines, ""])


if __name__ == "__main__":
    directory = Path(sys.argv[1])
    (directory / "Everything.v").write_text(everything(folders()))
    (directory / "Printed.v").write_text(printed(folders()))
