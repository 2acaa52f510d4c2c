"""The certificate that comes with the program: points of Theorem 1 cite it, and do not check it."""

from __future__ import annotations

import os
from functools import cache
from hashlib import sha256

from verify.language.errors import OwnError

#: The folder of the step, a copy of the one in `certificates`.
PACKAGED = os.path.join(os.path.dirname(os.path.dirname(__file__)), "data", "step")
#: Its files with their digests. Who cites it rests on them: it is not checked again in each run.
PACKAGED_FILES = {
    "statement.json": "126aefb84a92dd59e6c4afa380a85ba3b094248f5695d8074561208f75bd11cb",
    "certificate.json": "988994f4ca7086141430bca7e6bc35f058d4d39bdc48e62c1319d3d91d84aa84",
}


@cache
def packaged_files() -> tuple[bytes, bytes]:
    """The statement and the certificate of the step, which come with the program.

    Raises:
        OwnError: if they are not those that the checker has accepted.
    """
    found = []
    for name, expected in PACKAGED_FILES.items():
        path = os.path.join(PACKAGED, name)
        with open(path, "rb") as file:
            found.append(file.read())
        if sha256(found[-1]).hexdigest() != expected:
            raise OwnError(f"{path} is not the file that came with the program; install it anew")
    return found[0], found[1]
