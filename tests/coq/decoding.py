"""Ways to read files wrongly. `.ci/coq` sees each of them: a page, a proof, or a verdict changes.

    python -m tests.coq.decoding DIRECTORY       # exit code 1 if one is not seen

DIRECTORY has everything that `.ci/coq` has compiled, as in `tampering.py`.
"""

from __future__ import annotations

import re
import sys
from pathlib import Path

from tests.check.support import answer
from tests.coq.closing import ROOT
from tests.coq.tampering import (
    SOURCES,
    Definition,
    Way,
    changed,
    coqc,
    modules,
    run,
    tried,
    written,
)
from tests.lies.lies import LIES

#: What a statement says then is not what PinnedFiles.v says that it does.
PINNED = {
    "operation": Definition("DecodeTerms", '("sin", NOf Sin)', '("sin", NOf Atan)'),
    "operands": Definition("DecodeTerms", "Some f => Some (f a b)", "Some f => Some (f b a)"),
    "first-root": Definition("Decode", "if (2 <=? n)%positive && (n <=? 99", "if (n <=? 99"),
    "last-root": Definition("Decode", "(n <=? 99)%positive", "(n <=? 100)%positive"),
    "leading-zero": Definition("Decode", 'negb (Byte.eqb b "0"%byte) && at', "at"),
    "sign": Definition("Decode", "then Z.opp (Z.of_N n)", "then Z.of_N n"),
    "relation": Definition("DecodeTerms", '("<=", AtMost)', '("<=", Less)'),
    "scope": Definition(
        "DecodeTerms", 'need (is_inside c d) "a name that', 'need (is_inside c root) "a name that'
    ),
    "name-twice": Definition(
        "DecodeTerms", 'is "goal" s) && negb used', 'is "goal" s) && (used || negb used)'
    ),
    "kind": Definition("DecodeStatement", '("standing", Standing)', '("standing", Carried)'),
    "verdict": Definition("DecodeStatement", '("refuted", Refuted)', '("refuted", Undecided)'),
    "role": Definition("DecodeStatement", '("printed", false)', '("printed", true)'),
    "next-state": Definition(
        "DecodeStatement", "Always (nat_of d) start later,", "Always (nat_of d) later start,"
    ),
    "parent": Definition(
        "DecodeStatement", "Context (nat_of parent) (map", "Context 0 (map"
    ),
    "assumption-twice": Definition("DecodeStatement", "no_text_twice assumptions", "true"),
    "cited-refuted": Definition(
        "DecodeStatement", "if negb (is_own prefix) && proved then", "if negb (is_own prefix) then"
    ),
    "cited-names": Definition("DecodeStatement", 'prefix ++ s ++ [":"%byte]', "prefix ++ s"),
}  # fmt: skip
#: These have no proof.
UNPROVED = {
    "accepted-always": Definition("AcceptsFiles", "if accepts larger C then", "if true then"),
    "names-of-others": Definition("AcceptsFiles", "if names_its_own S then", "if true then"),
    "other-file": Definition("AcceptsFiles", "match parsed s nothing", "match parsed c nothing"),
    "other-digest": Definition(
        "AcceptsFiles", "map (fun text => (digest_of text, text))",
        "map (fun text => (text, text))",
    ),
    "other-text": Definition("Decode", "if same s t then Some x", "if same s s then Some x"),
}  # fmt: skip
#: These are proved, since they refuse more, or call refused what is malformed; each with a folder
#: or a lie of which the program then says something else than the checker.
VERDICTS = {
    "rule": (
        Definition("DecodeProof", '("range", alone Range)', '("range", alone Angles)'),
        "examples/exponential",
    ),
    "digest": (
        Definition("DecodeFiles", "need (same of_ hash)", "need (same of_ of_)"),
        "a-digest-of-zeros",
    ),
    "the-same": (Definition("DecodeFiles", "", ""), "examples/exponential"),
}  # fmt: skip


def order() -> list[str]:
    """The files up to the theorem in the order in which they are compiled."""
    names = re.findall(r"^(\w+)\.v$", (SOURCES / "_CoqProject").read_text(), re.MULTILINE)
    return names[names.index("Words") : names.index("AcceptsFiles") + 1]


def following(way: Definition, names: list[str]) -> dict[str, str]:
    """The text of each file from a changed one on."""
    after = names[names.index(way.file) + 1 :]
    return {way.file: changed(way)} | {name: (SOURCES / f"{name}.v").read_text() for name in after}


def first_not_compiled(directory: Path, parts: dict[str, str]) -> str:
    """The first of some files that does not compile, each beside those before it; or empty.

    A process for each: these are long, and a toplevel takes longer for a text than the compiler.
    """
    text = "".join(modules(parts).values())
    written(directory, "Tampered", text)
    done = coqc(directory, "Tampered", "-w", "none")
    if not done.returncode:
        return ""
    line = re.search(r'^File "./Tampered.v", line (\d+), .*\nError', done.stdout, re.MULTILINE)
    if not line:
        raise ValueError(f"Coq stops without a place: {done.stdout}")
    before = "\n".join(text.split("\n")[: int(line[1])])
    return re.findall(r"^Module (\w+)\.$", before, re.MULTILINE)[-1]


def on_the_page(name: str, directory: Path) -> bool:
    """Whether the page that pins statements does not compile, and all before it does."""
    names = ["Decode", "DecodeTerms", "DecodeStatement", "PinnedFiles"]
    return first_not_compiled(directory, following(PINNED[name], names)) == "PinnedFiles"


def without_proof(name: str, directory: Path) -> bool:
    """Whether the theorem about files has no proof then."""
    return first_not_compiled(directory, following(UNPROVED[name], order())) == "AcceptsFiles"


def another_verdict(name: str, directory: Path) -> bool:
    """Whether the program has another exit code than the checker."""
    way, said_of = VERDICTS[name]
    for file, text in following(way, [*order(), "FileNames", "Extract"]).items():
        written(directory, file, text)
        if coqc(directory, file).returncode:
            raise ValueError(f"{file} does not compile")
    (directory / "checker.mli").unlink(missing_ok=True)
    (directory / "reader.ml").write_text((SOURCES / "reader.ml").read_text())
    sources = ("-package", "unix", "-linkpkg", "checker.ml", "reader.ml", "-o", "other")
    done = run(directory, "ocamlfind", "ocamlopt", "-w", "-a", *sources)
    if done.returncode:
        raise ValueError(f"it does not compile: {done.stdout}")
    folder, files = ROOT / said_of, ("statement.json", "certificate.json")
    if said_of in LIES:
        folder = directory / "lie"
        folder.mkdir()
        for file, data in zip(files, LIES[said_of].files(), strict=True):
            (folder / file).write_bytes(data)
    first, second = ((folder / file).read_bytes() for file in files)
    code, _ = answer((first, second))
    return (run(directory, "./other", str(folder)).returncode == code) == (name == "the-same")


def ways() -> list[Way]:
    """Each with what says whether it is seen; and where there is nothing to see, that."""
    found: list[Way] = [(name, another_verdict) for name in VERDICTS]
    found += [(name, on_the_page) for name in PINNED]
    return [*found, *((name, without_proof) for name in UNPROVED)]


def main(source: Path) -> int:
    """Try each of them on a copy."""
    lines = [*filter(None, (tried(source, way) for way in ways()))]
    for line in lines:
        print(line)
    print(f"{len(ways())} ways to read wrongly, {len(lines)} not seen")
    return bool(lines)


if __name__ == "__main__":
    sys.exit(main(Path(sys.argv[1]).resolve()))
