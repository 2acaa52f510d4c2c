"""The certificates that come with the program: they are cited, and not checked in each run."""

from __future__ import annotations

import os
from collections.abc import Iterable
from functools import cache
from hashlib import sha256

from verify.language.errors import OwnError

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
        "statement.json": "126aefb84a92dd59e6c4afa380a85ba3b094248f5695d8074561208f75bd11cb",
        "certificate.json": "988994f4ca7086141430bca7e6bc35f058d4d39bdc48e62c1319d3d91d84aa84",
    },
    "step-printed": {
        "statement.json": "1aa67de5dabc18e6bcb076c0e7974e19b4363aa9f9b1935d8ef599e125b1a25b",
        "certificate.json": "110f629fda69ecbf7743e02d761091b238c0bc41f303678c41271f0320e7e3f2",
    },
    ALL: {
        "statement.json": "da36718f361cf3ab0f00c8f9fbdbc74e8f5a4b127fb80946b6524da2e6143539",
        "certificate.json": "8c8468593e3ffa2bfd9cca1739c6e81e545c7074fc5ed7e2dfcfc9564a4fbbfb",
    },
    PRINTED_SET: {
        "statement.json": "8e75d8078c911f7d02e201247b6db6f5ba1dd163fec39f88a7838953beeb41d4",
        "certificate.json": "3dfc710e8a17fb645a98620facd45327b068413af9c8a126346faa43405734fb",
    },
    PRINTED_SIGN: {
        "statement.json": "051d302264aa218308a0ff3ff4ed25489ae0f81f5ecf5d0c32f0684978ad706a",
        "certificate.json": "d1ea6c1643a8dbfc87883eefad90b83fedc4ff6fe37bec8e463aaf6900622549",
    },
    "thresholds": {
        "statement.json": "cd4602cefb1bfc76902297d936571f3de8ddb6e51fe4789ca75bdc3f263bc9c5",
        "certificate.json": "d68006b185a1ff0d6fa98beb6f19dc49455995db3e1d2bfad950a528e7192659",
    },
    "spectrum": {
        "statement.json": "c58bb964a809d4a1b61cd0e4592d2d841a301a8db580c97e71690aed783bfaf3",
        "certificate.json": "3e65921b212a72e762ce9e280f4eaddd03ccba8289df115508cf40993068e868",
    },
    "classification": {
        "statement.json": "00c7b3c38373fe992a8095f0615964a22e612f9320a683471e38045ba1864b37",
        "certificate.json": "d3b96768736f453fb90305f269c4ff1907fa66b3274254fc480b15e097aac4e4",
    },
    "elsewhere": {
        "statement.json": "4064bd6ccf264475a3143bb612f7128b04b416e9b0715ff7cbd8aa2e22cf0830",
        "certificate.json": "3f3d3f7c245f57e6d5543b39391dd518f8b27ab26ed2f6c00709c2190f543b3f",
    },
    "sharper": {
        "statement.json": "52d5abca77e65dd9c6c064ef529d4774214a42f6914bb076b725552dd0940776",
        "certificate.json": "a49535e50d393bee1f52c0109a8c150900385155560a6e59bacb466ce2aa646b",
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
        "statement.json": "f95189c317b4bb59bf85cef2b399bc347b0d698496a5385b8f9c70119cd1193b",
        "certificate.json": "174a6c89880f6a25051f791995d11539aea5ed154a455cfbacd26a2d02864b31",
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
