"""A statement with the numbers that its terms have where another one is cited first.

A statement has the terms and contexts of those that it cites first, in order, so that it begins
with the numbers of the first one. Of a second one the numbers come after those: it is exported once
more, as a statement that cites the first one, too, and so is what cites it.
"""

from __future__ import annotations

import json
from hashlib import sha256
from pathlib import Path

from verify import check


def beside(folder: Path, first: Path) -> check.Folder:
    """A certificate whose statement cites another one first, without use of it."""
    (read,) = check.read_folders([str(folder)])
    other = (first / "statement.json").read_bytes()
    statement, certificate = json.loads(read.statement), json.loads(read.certificate)
    theorem = json.loads(other)["theorem"]
    cite = {"name": "beside", "statement_sha256": sha256(other).hexdigest(), "theorem": theorem}
    data = json.dumps({**statement, "cites": [cite, *statement["cites"]]}).encode()
    certificate["statement_sha256"] = sha256(data).hexdigest()
    proof = json.dumps(certificate).encode()
    return check.Folder(folder.name, data, proof, [other, *read.cited], read.proofs)
