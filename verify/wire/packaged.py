"""The certificates that come with the program: they are cited, and not checked in each run."""

from __future__ import annotations

import os
from functools import cache
from hashlib import sha256

from verify.language.errors import OwnError

#: The folder with copies of some of those in `certificates`.
PACKAGED = os.path.join(os.path.dirname(os.path.dirname(__file__)), "data")
#: The one about all parameters.
ALL = "theorem1-all"
#: Those about the theorem as printed: its set with > for <, and that with < it is false.
PRINTED_SET, PRINTED_SIGN = "printed-set", "printed-sign"
#: Their files with their digests. Who cites one rests on them: it is not checked again in each run.
PACKAGED_FILES = {
    "step": {
        "statement.json": "920523cdfa1f9afd807f321e05b78cadd7ee760b1a5764d4e1f36c9a7e786716",
        "certificate.json": "e4e3e744a3142e236b59757410c5fe701264a16adff1ba3fabf43296df9f548d",
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
        "statement.json": "051d302264aa218308a0ff3ff4ed25489ae0f81f5ecf5d0c32f0684978ad706a",
        "certificate.json": "d1ea6c1643a8dbfc87883eefad90b83fedc4ff6fe37bec8e463aaf6900622549",
    },
}


@cache
def packaged_files(name: str) -> tuple[bytes, bytes]:
    """A statement and its certificate, which come with the program: the step, or all parameters.

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
