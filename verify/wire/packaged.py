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
#: Their files with their digests. Who cites one rests on them: it is not checked again in each run.
PACKAGED_FILES = {
    "step": {
        "statement.json": "126aefb84a92dd59e6c4afa380a85ba3b094248f5695d8074561208f75bd11cb",
        "certificate.json": "988994f4ca7086141430bca7e6bc35f058d4d39bdc48e62c1319d3d91d84aa84",
    },
    ALL: {
        "statement.json": "da36718f361cf3ab0f00c8f9fbdbc74e8f5a4b127fb80946b6524da2e6143539",
        "certificate.json": "8c8468593e3ffa2bfd9cca1739c6e81e545c7074fc5ed7e2dfcfc9564a4fbbfb",
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
