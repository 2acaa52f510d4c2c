"""A statement with the numbers that its terms have where it is cited second.

    python -m verify.wire.coq.beside FOLDER FIRST      # prints the file for Coq, readable

A statement has the terms and contexts of those that it cites first, in order, so that it begins
with the numbers of the first one. Of a second one the numbers come after those: it is exported once
more, as a statement that cites the first one, too.
"""

from __future__ import annotations

import json
import sys
from hashlib import sha256
from pathlib import Path

from verify import check
from verify.wire.coq.export import export
from verify.wire.coq.reading import NotAcceptedError


def beside(folder: Path, first: Path) -> check.Folder:
    """A certificate whose statement cites another one, without use of it.

    Raises:
        NotAcceptedError: for a statement that cites something already.
    """
    other = (first / "statement.json").read_bytes()
    statement = json.loads((folder / "statement.json").read_bytes())
    certificate = json.loads((folder / "certificate.json").read_bytes())
    if statement["cites"]:
        raise NotAcceptedError(f"{folder} cites something already")
    theorem = json.loads(other)["theorem"]
    cite = {"name": "beside", "statement_sha256": sha256(other).hexdigest(), "theorem": theorem}
    data = json.dumps({**statement, "cites": [cite]}).encode()
    certificate["statement_sha256"] = sha256(data).hexdigest()
    return check.Folder(folder.name, data, json.dumps(certificate).encode(), [other])


if __name__ == "__main__":
    sys.stdout.write(export(beside(Path(sys.argv[1]), Path(sys.argv[2])), ordinary=True))
