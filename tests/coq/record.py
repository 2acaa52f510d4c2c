"""The record of what Coq has checked: `verify/data/coq.json`.

    python -m tests.coq.record DIRECTORY             # compared with what `.ci/coq` has just found
    python -m tests.coq.record DIRECTORY --write     # written

DIRECTORY has the file ``checked``, a line for each certificate with its folder and the seconds it
took, the file ``digests``, in which Coq prints the digest in each of these proofs, and ``version``.
Times are for the reader and are not compared.
"""

from __future__ import annotations

import json
import re
import sys
from hashlib import sha256
from pathlib import Path
from typing import Any

ROOT = Path(__file__).resolve().parents[2]
RECORD = ROOT / "verify/data/coq.json"


def found(directory: Path) -> dict[str, Any]:
    """What the run has checked; the digests of statements are those that Coq prints."""
    lines = [line.split() for line in (directory / "checked").read_text().splitlines()]
    printed = re.search(r"= \[(.*?)\]", (directory / "digests").read_text(), re.DOTALL)
    assert printed
    digests = [f"{int(number):064x}" for number in re.findall(r"\d+", printed[1])]
    certificates = []
    for (folder, seconds), digest in zip(lines, digests, strict=True):
        statement, certificate = (
            sha256((ROOT / folder / f"{name}.json").read_bytes()).hexdigest()
            for name in ("statement", "certificate")
        )
        assert digest == statement, f"{folder}: Coq has proved another statement"
        certificates.append({
            "folder": folder, "statement_sha256": statement, "certificate_sha256": certificate,
            "seconds": int(seconds),
        })  # fmt: skip
    version = (directory / "version").read_text().strip()
    return {"format": 1, "coq": version, "certificates": certificates}


def without_times(record: dict[str, Any]) -> dict[str, Any]:
    """What is compared."""
    items = [{**item, "seconds": 0} for item in record["certificates"]]
    return {**record, "certificates": items}


def main(directory: Path, *, write: bool) -> int:
    """Write the record or compare it; 1 if it is another one."""
    record = found(directory)
    if write:
        RECORD.write_text(json.dumps(record, indent=1) + "\n")
        return 0
    committed = json.loads(RECORD.read_text())
    if without_times(committed) == without_times(record):
        return 0
    print(
        f"{RECORD.relative_to(ROOT)} is not what Coq has checked: .ci/coq --record", file=sys.stderr
    )
    return 1


if __name__ == "__main__":
    sys.exit(main(Path(sys.argv[1]), write="--write" in sys.argv[2:]))
