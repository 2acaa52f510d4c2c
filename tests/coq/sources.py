"""No file for Coq assumes anything, or changes what Coq checks or how it reads.

    python -m tests.coq.sources DIRECTORY        # exit code 1 if a file does

Only commands on a list are allowed, since no list of forbidden ones is complete. `coqchk` decides
afterwards what the compiled files rest on; this says in a second which line is to blame.
"""

from __future__ import annotations

import re
import sys
from collections.abc import Iterator
from pathlib import Path

#: What a sentence outside a proof may be.
ALLOWED = (
    r"(From (Coq|Interval|Verify) )?Require( Import)? [\w. ]+", r"Import ListNotations",
    r"Open Scope (R|positive)_scope", r"Definition \w.*",
    r"Fixpoint \w.*", r"Inductive \w.*", r"Record \w.*", r"Lemma \w.*", r"Theorem \w.*",
    r"Ltac \w.*", r"Proof", r"Qed", r"Defined", r"Check .*",
    r"Print Assumptions \w+",
    r'Set Default Proof Using "All"',  # each lemma of a section takes all its hypotheses
)  # fmt: skip
#: What it may be in a section besides: it does not reach beyond.
LOCAL = (r"(Variables?|Hypothesis|Let) \w.*", r"Context \{\w+ : \w+\}")
#: What gives words another meaning, each line after the file in which alone it may stand.
NOTATIONS = Path(__file__).with_name("notations.txt").read_text(encoding="utf-8").splitlines()
#: In the files for extraction; the axiom is Coq's, and nothing that is computed uses it.
EXTRACTING = (
    "Extraction Language OCaml", r'Extraction "checker\.ml" [\w. ]+',
    r'Extract Constant xorb => "fun \(a : bool\) b -> a <> b"',
    r"Extract Constant ClassicalDedekindReals\.sig_forall_dec => \"fun _ -> assert false\"",
)  # fmt: skip
#: How the files are compiled: no option may load another file, or change what Coq checks.
OPTIONS = r"-R \. Verify|-arg -q|-arg -w -arg -unused-intro-pattern|\w+\.v|# .*|"
#: What an allowed sentence may have inside that is not: a notation, and a coercion.
HIDDEN = r'\bwhere ?"|:>'
#: A step of a proof. One that opens braces for a goal is none, since a command may follow in them.
STEP = r"(?!(\[[^]]*\]|\w+) ?: ?\{)([0-9]+: )?[a-z\[(]|[{}]$|[*+-]+$"


def without_comments(text: str) -> str:
    """The text without comments, which may be nested and may have strings."""
    kept, depth = [], 0
    for piece in re.findall(r'"[^"]*"|\(\*|\*\)|[^("*]+|.', text, re.DOTALL):
        depth += piece == "(*"
        if not depth:
            kept.append(piece)
        depth -= piece == "*)" and depth > 0
    return "".join(kept)


def sentences(text: str) -> Iterator[str]:
    """The sentences, each in one line; bullets and braces of a proof are sentences, too."""
    pieces = re.findall(
        r'\s*([-+*]+(?=\s)|[{}]|(?:"[^"]*"|[^".]|\.(?!\s|$))+\.(?=\s|$)|\S+)',
        without_comments(text),
    )
    yield from (" ".join(piece.split()).removesuffix(".") for piece in pieces)


def unexpected(text: str, name: str = "") -> list[str]:
    """The sentences that are not allowed, in a file of this name."""
    found, depth, proving = [], 0, False
    for sentence in sentences(text):
        if re.fullmatch(r"Section [A-Z]\w*", sentence):
            depth += 1
        elif depth and re.fullmatch(r"End [A-Z]\w*", sentence):
            depth -= 1
        elif proving and sentence not in ("Qed", "Defined"):
            if not re.match(STEP, sentence):
                found.append(sentence)
        else:
            allowed = ALLOWED + LOCAL * (depth > 0) + EXTRACTING * (name == "Extract")
            known = f"{name}: {sentence}" in NOTATIONS
            plain = any(re.fullmatch(pattern, sentence) for pattern in allowed)
            if not known and (not plain or re.search(HIDDEN, sentence)):
                found.append(sentence)
            proving = sentence == "Proof"
    return found


def complaints(directory: Path) -> list[str]:
    """What is not allowed in the files of a directory, a line each."""
    files = sorted(directory.glob("*.v"))
    if not files:
        return [f"{directory}: there are no files for Coq"]
    found = [
        (path, sentence) for path in files for sentence in unexpected(path.read_text(), path.stem)
    ]
    project = directory / "_CoqProject"
    found += [
        (project, line)
        for line in project.read_text().splitlines()
        if not re.fullmatch(OPTIONS, line)
    ]
    return [f"{path.name}: this is not allowed here: {text[:200]}" for path, text in found]


if __name__ == "__main__":
    lines = complaints(Path(sys.argv[1]))
    print("\n".join(lines), end="\n" * bool(lines), file=sys.stderr)
    sys.exit(bool(lines))
