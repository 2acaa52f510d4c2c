"""The JSON of the extracted program against that of `verify/check.py`, on files that are broken.

python -m tests.coq.fuzz READER        # whole pairs, too: the same verdict on each
"""

from __future__ import annotations

import json
import random
import subprocess
import sys
import tempfile
from collections.abc import Iterator
from functools import cache
from hashlib import sha256
from pathlib import Path
from typing import Any

from tests.check.support import answer
from tests.lies.lies import LIES, honest
from verify import check

ROOT = Path(__file__).resolve().parents[2]
#: JSON and SHA-256 as a program; a byte is a char there.
EXTRACTED = """From Verify Require Import Sha256 ReadJson.
From Coq Require Import ExtrOcamlBasic ExtrOcamlChar.
Extraction Language OCaml.
Extraction "document.ml" document sha256 hexadecimal.
"""
#: Pieces that parsers of JSON disagree on.
PIECES = [
    rb'"\u0_41"', rb'"\u+041"', rb'"\u 041"', rb'"\u00e9"', rb'"\uD83D\uDE00"', rb'"\ud83d"',
    rb'"\ud83dx"', rb'"\ud83d\u0041"', rb'"\ude00\ud83d"', rb'"\u004"', rb'"\x41"',
    rb'"\U00000041"',
    rb'"\u0041"', rb'"\/\b\f\n\r\t"', b'"\xff"', b'"\xc0\x80"', b'"\xed\xa0\x80"', b'"\x7f"',
    b'"\xe0\x80\x80"', b'"\xf0\x80\x80\x80"', b'"\xf4\x90\x80\x80"',
    b'"\n"',
    b'"\0"', b"\0", b"\xef\xbb\xbf", b"\xc2\xa0", b"\x0b", b"\x0c", b" \t\r\n", b"NaN",
    b"Infinity",
    b"-Infinity", b"-0", b"-1", b"+1", b"0", b"00", b"01", b"1_0", b"0x1", b"1.", b".5", b"1.0",
    b"1e2",
    b"999999999", b"1000000000", b"1E400", b"\xd9\xa3", b"null", b"nul", b"true", b"True",
    b"false",
    b"{}", b"[]", b"[,]", b"[1,]", b"{,}", b'{"a":1,}', b'{"a":1,"a":2}', rb'{"a":1,"\u0061":2}',
    b"{1:2}", b'{"a"}', b'{"a" 1}', b"'a'", b"//", b"/**/", b",", b":", b'"', b"\\", b"[", b"]",
    b"}",
    b"1 2", b"", b"[" * 99 + b"]" * 99, b"[" * 100 + b"]" * 100, b"[" * 101 + b"]" * 101,
    b"[" * 100 + b"1" + b"]" * 100, b'{"a":' * 100 + b"{}" + b"}" * 100, b"[" * 5000,
]  # fmt: skip


def anything(_: str, value: Any) -> None:
    """Each shape is good."""


@cache
def documents() -> list[bytes]:
    """The files of all lies, and of an honest pair."""
    pairs = [honest().files(), *(lie.files() for lie in LIES.values())]
    return sorted({data for pair in pairs for data in pair})


def mutated(data: bytes, chance: random.Random) -> bytes:
    """The bytes with a few changes."""
    for _ in range(chance.choice((1, 1, 1, 2, 5))):
        i = chance.randrange(len(data) + 1)
        j = min(len(data), i + chance.choice((0, 0, 1, 1, 2, 9)))
        other = chance.choice((
            b"", chance.choice(PIECES), bytes([chance.randrange(256)]), data[i:j] * 2,
            bytes([chance.choice(b'{}[]",:\\u019ef \n')]),
        ))  # fmt: skip
        data = data[:i] + other + data[j:]
    return data


def pieces() -> list[bytes]:
    """The pieces, alone and in brackets."""
    return [*PIECES, *(b"[" + piece + b"]" for piece in PIECES)]


def broken(count: int) -> Iterator[bytes]:
    """Documents of which most are no JSON, the same ones each time."""
    chance = random.Random(2026)
    found = documents()
    yield from found
    yield from pieces()
    short = sorted(found, key=len)[: len(found) // 2]
    for _ in range(count):
        yield mutated(chance.choice(short), chance)


def wanted(data: bytes) -> Any:
    """What the checker reads, in a list; none if it refuses."""
    try:
        return [check.parsed("document", data, anything)]
    except check.Malformed:
        return None


def compiled(directory: Path, line: str = "", other: str = "") -> str:
    """The program that reads documents and writes what it has read; with another line in it.

    Only what is extracted is compiled, not the proofs about it, which such a line would break.
    """
    names = ("Words", "Sha256", "Json", "ReadJson")
    texts = {name: (ROOT / f"verify/coq/{name}.v").read_text() for name in names}
    for name, text in {**texts, "Extracted": EXTRACTED}.items():
        (directory / f"{name}.v").write_text(text.replace(line, other) if line else text)
        _run(directory, "coqc", "-q", "-R", ".", "Verify", f"{name}.v")
    (directory / "document.mli").unlink()
    (directory / "echo.ml").write_text((ROOT / "tests/coq/echo.ml").read_text())
    sources = ("document.ml", "echo.ml")
    _run(directory, "ocamlfind", "ocamlopt", "-w", "-a", "-linkpkg", *sources, "-o", "echo")
    return str(directory / "echo")


def _run(directory: Path, *command: str) -> None:
    subprocess.run(command, cwd=directory, check=True, capture_output=True)


def disagreements(program: str, found: list[bytes]) -> list[bytes]:
    """The documents that one of the two refuses, or of which they read different things."""
    lines = "".join(f"{data.hex()}\n" for data in found)
    done = subprocess.run([program], input=lines, capture_output=True, text=True, check=True)
    other = []
    for data, line in zip(found, done.stdout.splitlines(), strict=True):
        digest, read = line.split(" ")
        try:
            text = bytes.fromhex(read.strip("-")).decode("utf-8", "surrogatepass")
            same = ([json.loads(text)] if text else None) == wanted(data)
        except UnicodeDecodeError:
            same = False
        known = sha256(data).hexdigest() if len(data) < 250 else "-"
        if not same or digest != known:
            other.append(data)
    return other


def pairs(count: int) -> Iterator[tuple[bytes, bytes]]:
    """Pairs of which one file is changed; a certificate knows the digest of what it belongs to."""
    chance = random.Random(21)
    first, second = honest().files()
    digest = sha256(first).hexdigest().encode()
    for _ in range(count):
        if chance.random() < 0.5:
            statement = mutated(first, chance)
            yield statement, second.replace(digest, sha256(statement).hexdigest().encode())
        else:
            yield first, mutated(second, chance)


def other_verdicts(reader: str, count: int) -> list[str]:
    """The pairs that are proved for one of the two only."""
    with tempfile.TemporaryDirectory() as path:
        found = {str(i): pair for i, pair in enumerate(pairs(count))}
        for name, (first, second) in found.items():
            folder = Path(path, name)
            folder.mkdir()
            (folder / "statement.json").write_bytes(first)
            (folder / "certificate.json").write_bytes(second)
        done = subprocess.run([reader, *found], cwd=path, capture_output=True, text=True)
    said = dict(line.split(": ", 1) for line in done.stdout.splitlines())
    lines = [f"the reader says {done.stderr}"] if done.stderr else []
    for name, pair in found.items():
        code, report = answer(pair)
        if said.get(name, "").startswith("PROVED") != (code == 0):
            lines.append(f"{name}: {said.get(name)}, where the checker says {report[-1][:200]}")
    return lines


def main(reader: str) -> int:
    """Compare the two; 1 if they disagree."""
    found = [*broken(10_000)]
    with tempfile.TemporaryDirectory() as path:
        other = disagreements(compiled(Path(path)), found)
    lines = [*map(repr, other), *other_verdicts(reader, 1000)]
    for line in lines:
        print(line, file=sys.stderr)
    print(f"fuzz: {len(found)} documents and 1000 pairs, {len(lines)} with another verdict")
    return bool(lines)


if __name__ == "__main__":
    sys.exit(main(sys.argv[1]))
