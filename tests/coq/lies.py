"""The program that is extracted from Coq has to refuse every lie, as `verify/check.py` does.

It also has to name what a proof rests on, and to survive arguments that are no folders.

python -m tests.coq.lies READER
"""

from __future__ import annotations

import os
import subprocess
import sys
import tempfile
from hashlib import sha256
from pathlib import Path

from tests.check.support import INTERVAL, Pair, answer
from tests.coq.controls import SLOW, dropped, functions
from tests.lies.lies import LIES, honest

EXAMPLES = Path(__file__).resolve().parents[2] / "certificates/examples"


def run(reader: str, folder: Path, *arguments: str) -> tuple[int, str, str]:
    """The exit code, the report, and the complaint."""
    done = subprocess.run([reader, *arguments], cwd=folder, capture_output=True, timeout=300)
    return done.returncode, done.stdout.decode(), done.stderr.decode()


def beside(folder: Path, name: str, *files: tuple[str, bytes]) -> Path:
    """A folder there with files."""
    for file, data in files:
        path = folder / name / file
        path.parent.mkdir(parents=True, exist_ok=True)
        path.write_bytes(data)
    return folder / name


def inputs(reader: str, root: Path) -> list[str]:
    """What the program says wrongly of odd folders; each line is one of these."""
    first, second = honest().files()
    pair = (("statement.json", first), ("certificate.json", second))
    for name in ("plain", "-dash", "a\nb: PROVED", "\u00e9 \x1b[2J"):
        beside(root, name, *pair)
    beside(root, "directory", ("certificate.json", second), ("statement.json/x", b""))
    beside(root, "half", pair[0])
    os.mkfifo(beside(root, "pipe", pair[1]) / "statement.json")
    beside(root, "pipe-cited", *pair, ("cited/a.json", b"{}"))
    os.mkfifo(root / "pipe-cited/cited/b.json")
    proved = "PROVED: given law\n"
    wanted = [
        (["plain"], 0, f"plain: {proved}", 0),
        (["-dash", "plain"], 0, f"-dash: {proved}plain: {proved}", 0),
        (["a\nb: PROVED"], 0, f"a\\x0ab: PROVED: {proved}", 0),
        (["\u00e9 \x1b[2J"], 0, f"\\xc3\\xa9 \\x1b[2J: {proved}", 0),
        *((names, 2, "", 1) for names in (
            [], [""], ["nothing"], ["plain", "nothing"], ["directory"], ["half"], ["pipe"],
            ["pipe-cited"], ["plain/statement.json"], ["-x\ny"],
        )),
    ]  # fmt: skip
    wrong = []
    for names, code, out, lines in wanted:
        found = run(reader, root, *names)
        if found[:2] != (code, out) or found[2].count("\n") != lines:
            wrong.append(f"{names}: {found}")
    return wrong


def cited(reader: str, root: Path) -> list[str]:
    """What it says wrongly of citations, alone, together, and with a certificate beside."""
    mean, citing = EXAMPLES / "mean", EXAMPLES / "mean-applied"
    statement = (mean / "statement.json").read_bytes()
    certificate = (mean / "certificate.json").read_bytes()
    files = [
        (f"{n}.json", (citing / f"{n}.json").read_bytes()) for n in ("statement", "certificate")
    ]
    files.append(("cited/mean.json", statement))
    for name, data in (("good", certificate), ("refused", certificate.replace(b"square", b"root")),
                       ("malformed", b"{}")):  # fmt: skip
        beside(root, name, *files, ("cited/mean.certificate.json", data))
    beside(root, "open", *files)
    beside(root, "alone", *files, ("cited/other.certificate.json", certificate))
    beside(root, "mean", ("statement.json", statement), ("certificate.json", certificate))
    digest = sha256(statement).hexdigest()
    citing_mean = f"citing mean, which is not proved here ({digest})"
    opened = f"open: UNDECIDED: given nothing; {citing_mean}\n"
    closed, mean_proved = "open: PROVED: given nothing\n", "mean: PROVED: given nothing\n"
    wanted = {
        ("open",): (3, opened), ("open", "mean"): (0, closed + mean_proved),
        ("mean", "open"): (0, mean_proved + closed), ("good",): (0, closed.replace("open", "good")),
        ("refused",): (1, "refused: REFUSED: the cited certificate of"),
        ("malformed",): (4, "malformed: MALFORMED: the cited certificate of"), ("alone",): (2, ""),
    }  # fmt: skip
    wrong = []
    for names, (code, out) in wanted.items():
        found = run(reader, root, *names)
        if found[0] != code or not found[1].startswith(out) or (code in (0, 3) and found[1] != out):
            wrong.append(f"{names}: {found}")
    return wrong + cited_by_cited(reader, root)


def cited_by_cited(reader: str, root: Path) -> list[str]:
    """What it says wrongly of a chain of which some links are proved; `check.py` says the same."""
    first = Pair("FIRST").assume("law").row("low", "0 <= 1", INTERVAL)
    second = Pair("SECOND").assume("own").cite("f", first).row("low", "0 <= 1", INTERVAL)
    third = Pair("THIRD").cite("s", second).row("row", ["<=", "0", "1"], INTERVAL)
    pairs = {"first": first, "second": second, "third": third}
    cites = [(f"cited/{name}.json", pair.files()[0]) for name, pair in pairs.items()]
    for name, pair in pairs.items():
        own = zip(("statement.json", "certificate.json"), pair.files(), strict=True)
        beside(root, name, *own, *cites)
    wrong = []
    for names in (["third"], ["first", "third"], ["second", "third"], [*pairs]):
        code, lines = answer(*(pairs[name] for name in names), cited=(first, second))
        last = lines[-1].partition(": ")[0] + ": given " + lines[-1].partition("; given ")[2]
        found = run(reader, root, *names)
        if found[0] != code or found[1].splitlines()[-1] != f"third: {last}":
            wrong.append(f"{names}: {found}, expected {code}, {last}")
    return wrong


def of_functions(reader: str, root: Path) -> list[str]:
    """What it says wrongly of laws, ranges and functions that rise."""
    pairs = functions()
    for name, (first, second) in pairs.items():
        beside(root, name, ("statement.json", first), ("certificate.json", second))
    _, out, _ = run(reader, root, *pairs)
    found = dict(line.split(": ", 1) for line in out.splitlines())
    codes = {name: answer(pair)[0] for name, pair in pairs.items()}
    assert {*codes.values()} == {0, 1, 4}
    words = {0: "PROVED: given nothing", 1: "REFUSED: ", 4: "MALFORMED: "}
    return [
        f"{name}: {said}, where the checker says {words[codes[name]]}"
        for name, said in found.items()
        if not said.startswith(words[codes[name]])
    ] + [f"{name}: nothing" for name in pairs.keys() - found.keys()]


def is_right(said: str, code: int, rests_on: str) -> bool:
    """Whether a pair is proved just where the checker proves it, given what it rests on."""
    return said == f"PROVED: given {rests_on}" if code == 0 else not said.startswith("PROVED")


def main(reader: str) -> int:
    """Give all of them to the program; 1 if a lie passes, or the honest pair does not."""
    with tempfile.TemporaryDirectory() as path:
        lines = inputs(reader, Path(path)) + cited(reader, Path(path))
        lines += of_functions(reader, Path(path))
    pairs = {"honest": honest().files(), **{name: lie.files() for name, lie in LIES.items()}}
    for name in SLOW:
        pairs |= dropped(EXAMPLES / name)
    with tempfile.TemporaryDirectory() as path:
        for name, (first, second) in pairs.items():
            folder = Path(path, name)
            folder.mkdir()
            (folder / "statement.json").write_bytes(first)
            (folder / "certificate.json").write_bytes(second)
        done = subprocess.run([reader, *pairs], cwd=path, capture_output=True, text=True)
    found = dict(line.split(": ", 1) for line in done.stdout.splitlines())
    other, wrong = 0, [name for name in pairs if name not in found]
    for name, said in found.items():
        code, _ = answer(pairs[name])
        wanted = {0: "PROVED", 1: "REFUSED", 4: "MALFORMED"}[code]
        rests_on = "nothing" if name.partition(":")[0] in SLOW else "law"
        if not is_right(said, code, rests_on):
            wrong.append(name)
        other += not said.startswith(wanted)
        if not said.startswith(wanted):
            print(f"{name}: {said}, where the checker says {wanted}", file=sys.stderr)
    lines += [f"{name}: {found.get(name, done.stderr[-200:])}" for name in wrong]
    for line in lines:
        print(f"WRONG {line}", file=sys.stderr)
    print(f"lies: {len(pairs)}, {len(lines)} with another verdict, {other} refused in another way")
    return bool(lines)


if __name__ == "__main__":
    sys.exit(main(sys.argv[1]))
