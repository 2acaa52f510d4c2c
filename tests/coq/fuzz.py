"""The JSON of the extracted program against that of `verify/check.py`, on files that are broken.

python -m tests.coq.fuzz DIRECTORY     # whole pairs, too: the same verdict on each

DIRECTORY has everything that `.ci/coq` has compiled. Readers that are laxer than the committed one
have to disagree with the checker, or the comparison sees nothing.
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
from tests.coq.tampering import modules
from tests.lies.lies import LIES, honest
from verify import check

ROOT = Path(__file__).resolve().parents[2]
#: Lines of the reader, and what makes each of them laxer.
LAXER = (
    ("if distinct PositiveSet.empty l then Some (JObj l, rest) else None", "Some (JObj l, rest)"),
    ("value 100 (skip s)", "value 101 (skip s)"),
    ("between 65 70 b", "between 65 95 b"),
    ("(n <=? 0xdbff)", "(n <=? 0xd7ff)"),
    ("else if 32 <=? Byte.to_N b", "else if 1 <=? Byte.to_N b"),
    ("if utf8 s then", "if utf8 [] then"),
    ("digits 8", "digits 9"),
    ('if Byte.eqb b "0"%byte then Some (0, rest)', "if false then Some (0, rest)"),
    ("(0x800 <=? n) && negb", "negb"),
    ("if at_most most_bytes s then", "if at_most (most_bytes + 1) s then"),
)
#: The files of the reader.
READING = ("Json", "ReadJson")
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


def anything(value: Any) -> None:
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


def compiled(source: Path, directory: Path) -> list[str]:
    """Programs that read documents and write what they have read: the committed one, laxer ones.

    Of a laxer one only what is extracted is compiled, not the proofs about it, which would break.
    """
    texts = {name: (ROOT / f"verify/coq/{name}.v").read_text() for name in READING}
    readers = [f"Reader{n}" for n in range(1 + len(LAXER))]
    lines = ["From Verify Require Import Sha256.", "From Coq Require ExtrOcamlBasic ExtrOcamlChar."]
    for reader, (line, other) in zip(readers, (("", ""), *LAXER), strict=True):
        parts = {name: text.replace(line, other) if line else text for name, text in texts.items()}
        lines += [f"Module {reader}.", *modules(parts).values(), f"End {reader}."]
    documents = " ".join(f"{reader}.ReadJson.document" for reader in readers)
    lines.append("Extraction Language OCaml.")
    lines.append(f'Extraction "document.ml" {documents} sha256 hexadecimal.')
    (directory / "Extracted.v").write_text("\n".join(lines))
    _run(directory, "coqc", "-q", "-w", "none", "-R", str(source), "Verify", "Extracted.v")
    (directory / "document.mli").unlink()
    build = ("ocamlfind", "ocamlopt", "-w", "-a", "-linkpkg")
    _run(directory, *build, "-c", "document.ml")
    echo = (ROOT / "tests/coq/echo.ml").read_text()
    for reader in readers:
        opened = f"open Document\nopen {reader}.Json\nopen {reader}.ReadJson\n"
        (directory / f"{reader}.ml").write_text(echo.replace("open Document\n", opened))
        _run(directory, *build, "document.cmx", f"{reader}.ml", "-o", reader)
    return [str(directory / reader) for reader in readers]


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


def laxer(programs: list[str]) -> list[str]:
    """The changes that none of the pieces shows."""
    longest = b"[" + b" " * (check.MAX_BYTES - 1) + b"]"
    return [
        f"nothing shows what is laxer with {other!r}"
        for program, (line, other) in zip(programs, LAXER, strict=True)
        if not disagreements(program, [*pieces(), *[longest] * ("most_bytes" in line)])
    ]


def main(source: Path) -> int:
    """Compare the two; 1 if they disagree."""
    of_each_length = [b"[" + b" " * n + b"]" for n in range(200)]
    found = [*of_each_length, *broken(10_000)]
    with tempfile.TemporaryDirectory() as path:
        program, *others = compiled(source, Path(path))
        unseen = laxer(others)
        other = disagreements(program, found)
    lines = [*unseen, *map(repr, other), *other_verdicts(str(source / "reader"), 1000)]
    for line in lines:
        print(line, file=sys.stderr)
    print(f"fuzz: {len(found)} documents and 1000 pairs, {len(lines)} with another verdict")
    return bool(lines)


if __name__ == "__main__":
    sys.exit(main(Path(sys.argv[1]).resolve()))
