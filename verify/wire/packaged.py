"""What comes with the program: certificates that are not checked in each run; what Coq checked."""

from __future__ import annotations

import os
from collections.abc import Iterable, Mapping
from functools import cache
from hashlib import sha256

from verify.language.errors import OwnError
from verify.language.record import Record

#: The folder with copies of some of those in `certificates`.
PACKAGED = os.path.join(os.path.dirname(os.path.dirname(__file__)), "data")
#: The one about all parameters.
ALL = "theorem1-all"
#: Those about the theorem as printed: its set with > for <, and that with < it is false.
PRINTED_SET, PRINTED_SIGN = "printed-set", "printed-sign"
#: The rows of the printed set for all parameters, of which some are refuted.
AS_PRINTED = "printed"
#: Their files with their digests. Who cites one rests on them: it is not checked again in each run.
PACKAGED_FILES = {
    "step": {
        "statement.json": "920523cdfa1f9afd807f321e05b78cadd7ee760b1a5764d4e1f36c9a7e786716",
        "certificate.json": "e4e3e744a3142e236b59757410c5fe701264a16adff1ba3fabf43296df9f548d",
    },
    "step-printed": {
        "statement.json": "1aa67de5dabc18e6bcb076c0e7974e19b4363aa9f9b1935d8ef599e125b1a25b",
        "certificate.json": "110f629fda69ecbf7743e02d761091b238c0bc41f303678c41271f0320e7e3f2",
    },
    ALL: {
        "statement.json": "8732bbdf352eef2623fb3cb50fd30b6ab0b4e6fb49f2b4592ba61278b9a95619",
        "certificate.json": "5f527050284e5b954d8c976fbdc9656f3e4aa41f93df710007b31a2ecdaaaa4e",
    },
    PRINTED_SET: {
        "statement.json": "0cc7a4cc9fbe85282249c5391d26d9d73b5a7a88e07f9294c400f171538a48b1",
        "certificate.json": "037733b107fc28348a289c512da9ecc538d539b8222511dbcfd3c01c32c07baf",
    },
    PRINTED_SIGN: {
        "statement.json": "463af7a92b5e55614165a6db3576bbdc71f2369147ab8e69e1116bd12ed9cd30",
        "certificate.json": "6b0089b72d47f818129de9aabe2bebf1f3560d69bfb08a0f7704064d01a43783",
    },
    "thresholds": {
        "statement.json": "cd4602cefb1bfc76902297d936571f3de8ddb6e51fe4789ca75bdc3f263bc9c5",
        "certificate.json": "d68006b185a1ff0d6fa98beb6f19dc49455995db3e1d2bfad950a528e7192659",
    },
    "spectrum": {
        "statement.json": "cb88e35f0984c1c4533cbdb35be8510235da71449440e01f380931109a05b129",
        "certificate.json": "9f781f3d28e8fa570f4e0cbca191582b9fc5500969df7fdead9c151fbe1b6f03",
    },
    "classification": {
        "statement.json": "569536f6f737b332a6639a14e1b17d8a66ed12a481014b00afc956fabfa560ab",
        "certificate.json": "77e14ada4e990b1de451b3281f197e7a160c07d7bbf045696399507e362c65cf",
    },
    "elsewhere": {
        "statement.json": "181792ad7ec7f2175bb89072eab89add2312e806111684bdafdf88cb98b09151",
        "certificate.json": "5f052fcffe1ab50e2ecc9b5c9c81b579108920f1c9be235ba192734622daf698",
    },
    "sharper": {
        "statement.json": "52d5abca77e65dd9c6c064ef529d4774214a42f6914bb076b725552dd0940776",
        "certificate.json": "a49535e50d393bee1f52c0109a8c150900385155560a6e59bacb466ce2aa646b",
    },
    "sandwich": {
        "statement.json": "c4a6b29d0fb22d2b4c1b93aef03e7f3b1df83d4922468a59103e03abd25083b9",
        "certificate.json": "dcb54182b3a7bd03e43f2ce67135bcea39e93f2ff71878de722da2070fabadbf",
    },
    "flow": {
        "statement.json": "63e41a57a263ab3bc26da25168946bcc4dbcc0661e77b674833aa1c073e32efd",
        "certificate.json": "e77585726a1125ad1a12969b6e4bf3eda959260a29cb2b5ed0293b7e1ac1d6fb",
    },
    "line": {
        "statement.json": "09664db03596164c5321ce9bcc389c1d0589751d06d8b3c71a47c971b80a81d4",
        "certificate.json": "01c491731d5f3d8abb9745a19378efcda818d40a83fddd47828cbe1719f0b07e",
    },
    AS_PRINTED: {
        "statement.json": "5c9a22d238e60320ab5e80a982eba34ca454f3ac39e3e63bc9f15dc32133b5d6",
        "certificate.json": "6308896c4fa435cd7c67b77d1fc5c0f7d05d0c083735dbdf51168a85a10d677d",
    },
}


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
