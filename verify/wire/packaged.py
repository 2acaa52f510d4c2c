"""What comes with the program: certificates that are not checked in each run; what Coq checked."""

from __future__ import annotations

import os
from collections.abc import Iterable, Iterator, Mapping
from functools import cache
from hashlib import sha256

from verify.language.errors import OwnError
from verify.language.record import Record

#: The folder with copies of some of those in `certificates`.
PACKAGED = os.path.join(os.path.dirname(os.path.dirname(__file__)), "data")
#: Their names, and digests; the pages that they were made of.
DIGESTS = os.path.join(PACKAGED, "packaged.txt")


def recorded(kind: str) -> Iterator[list[str]]:
    """The lines of one kind."""
    with open(DIGESTS, encoding="ascii") as file:
        found = [line.split() for line in file]
    return (words for first, *words in found if first == kind)


#: Files with their digests. Who cites one rests on them: it is not checked again in each run.
PACKAGED_FILES = {
    name: {"statement.json": statement, "certificate.json": certificate}
    for name, statement, certificate, _ in recorded("certificate")
}
#: How much work the checker counts for each of them.
WORK = {name: int(work) for name, _, _, work in recorded("certificate")}
#: The pages of the paper: which of these each has become, and the digest of its text then.
PAGES = {page: (name, digest) for page, name, digest in recorded("page")}


def became(page: str, text: bytes) -> str | None:
    """The name of what this text of a page has become, if that comes with the program.

    The digest is recorded only of a text that makes the very files: see `tests/bring.py`.
    """
    name, digest = PAGES.get(page, ("", ""))
    return name if sha256(text).hexdigest() == digest else None


def packaged_statements(digests: Iterable[str]) -> dict[str, bytes]:
    """The statements with these digests that come with the program, and what those cite.

    Raises:
        OwnError: if one is not as the checker has accepted it.
    """
    names = {files["statement.json"]: name for name, files in PACKAGED_FILES.items()}
    found: dict[str, bytes] = {}
    missing = [digest for digest in digests if digest in names]
    while missing:
        digest = missing.pop()
        content = packaged_files(names[digest])[0]
        found[digest] = content
        missing += [other for other in cited_digests(content) if other not in found]
    return found


def cited_digests(statement: bytes) -> list[str]:
    """The digests of statements that come with the program and are named in a statement."""
    return [
        files["statement.json"]
        for files in PACKAGED_FILES.values()
        if files["statement.json"].encode() in statement
    ]


@cache
def packaged_files(name: str) -> tuple[bytes, bytes]:
    """A statement and its certificate, which come with the program.

    Raises:
        OwnError: if they are not those that the checker has accepted.
    """
    found = []
    for file, expected in PACKAGED_FILES[name].items():
        path = os.path.join(PACKAGED, name, file)
        with open(path, "rb") as opened:
            found.append(opened.read())
        if sha256(found[-1]).hexdigest() != expected:
            raise OwnError(f"{path} is not the file that came with the program; install it anew")
    return found[0], found[1]


def packaged_work(statement: bytes, certificate: bytes) -> int | None:
    """How much work the checker counts for these files; None if they did not come with us."""
    given = [sha256(content).hexdigest() for content in (statement, certificate)]
    known = (name for name, files in PACKAGED_FILES.items() if [*files.values()] == given)
    name = next(known, None)
    return None if name is None else WORK[name]


def packaged_certificate(digest: str) -> bytes:
    """The certificate of the statement with this digest, if it comes with the program."""
    for name, files in PACKAGED_FILES.items():
        if files["statement.json"] == digest:
            return packaged_files(name)[1]
    return b""


# --- what Coq has checked ------------------------------------------------------------------------


class Checked(Record):
    """The version of Coq, and the digests of each statement that it has checked, with its proof."""

    version: str
    pairs: frozenset[tuple[str, str]]

    def has(self, digests: Mapping[str, str]) -> bool:
        """Whether Coq has checked these very files, given by their digests."""
        return (digests["statement.json"], digests["certificate.json"]) in self.pairs


def checked() -> Checked:
    """The committed record."""
    import json  # loaded only where it is used

    with open(os.path.join(PACKAGED, "coq.json"), encoding="utf-8") as file:
        record = json.load(file)
    pairs = (
        (item["statement_sha256"], item["certificate_sha256"]) for item in record["certificates"]
    )
    return Checked(record["coq"], frozenset(pairs))
