"""The record of what Coq has checked: `verify/data/coq.json`.

    python -m tests.coq.record DIRECTORY             # compared with what `.ci/coq` has just found
    python -m tests.coq.record DIRECTORY --write     # written

DIRECTORY has the file ``checked``, a line for each certificate with its folder; ``printed``, in
which Coq prints the statements that it has proved; ``counts``, how many controls and lies were
refused and accepted; and ``version``. Each printed statement has to say what ``statement.json``
says, whose digest is then recorded. Where the file of a certificate ends in a theorem on three
balls, for which Everything.v asks, the definition is recorded that says what it says. So are the
theorems on the pages that can be read alone.
"""

from __future__ import annotations

import json
import re
import sys
from hashlib import sha256
from pathlib import Path
from typing import Any

from tests.coq.closing import ROOT as CERTIFICATES
from tests.coq.closing import module
from tests.coq.everything import AFTER_FLOW, SAYS, everything, folders
from tests.coq.readback import Exported, Interner, Written, as_exported

ROOT = CERTIFICATES.parent
RECORD = ROOT / "verify/data/coq.json"


class AnotherError(ValueError):
    """Coq has not checked what is committed."""


def said_by_coq(
    folder: Path, printed: str, available: dict[str, bytes], after_flow: str = ""
) -> None:
    """Nothing, if the statement that Coq prints is the one in the folder; or that, after the flow.

    ``after_flow`` is the name of the file that has it after the flow.

    Raises:
        AnotherError: if it is another one.
    """
    intern = Interner()
    name = after_flow or module(folder)
    text = as_exported(printed, name)
    if not text:
        raise AnotherError(f"{folder.name}: Coq has printed no statement")
    exported = Exported(text, intern)
    document = json.loads((folder / "statement.json").read_bytes())
    if after_flow:
        digest = sha256((CERTIFICATES / "flow/statement.json").read_bytes()).hexdigest()
        document["cites"].insert(0, {"name": "beside", "statement_sha256": digest})
    written = Written(document, available, intern)
    if (exported.said, [*map(int, exported.own)]) != (written.said, written.own):
        raise AnotherError(f"{name}: Coq has proved another statement")


def found(directory: Path) -> dict[str, Any]:
    """What the run has checked.

    Raises:
        AnotherError: if that is not every committed certificate that Coq can read.
    """
    lines = (directory / "checked").read_text().splitlines()
    if sorted(ROOT / line for line in lines) != folders():
        raise AnotherError("a committed certificate was not checked, or twice")
    # In the order of the files in them.
    in_order = sorted(folders(), key=lambda folder: f"{folder}/")
    statements = [(folder / "statement.json").read_bytes() for folder in in_order]
    available = {sha256(data).hexdigest(): data for data in statements}
    printed = (directory / "printed").read_text()
    certificates = []
    for folder, digest in zip(in_order, available, strict=True):
        said_by_coq(folder, printed, available)
        certificates.append(_item(folder, digest))
    # The theorems on scenes and on the printed set use these with the numbers after the flow.
    for name, folder_name in AFTER_FLOW.items():
        said_by_coq(CERTIFICATES / folder_name, printed, available, name)
    counts = dict(line.split(": ") for line in (directory / "counts").read_text().splitlines())
    version = (directory / "version").read_text().strip()
    return {
        "format": 1, "coq": version, "counts": counts, "theorems": theorems(),
        "certificates": certificates,
    }  # fmt: skip


def theorems() -> list[str]:
    """The theorems on the pages that can be read alone, for which Everything.v asks."""
    return re.findall(
        r":= ((?:Pinned\w*|SeparatrixProof|AlexanderProof)\.\w+)\.$", everything([]), re.MULTILINE
    )


def _item(folder: Path, digest: str) -> dict[str, str]:
    """What is recorded of a folder."""
    name = str(folder.relative_to(CERTIFICATES))
    certificate = sha256((folder / "certificate.json").read_bytes()).hexdigest()
    found = {
        "folder": str(folder.relative_to(ROOT)), "statement_sha256": digest,
        "certificate_sha256": certificate,
    }  # fmt: skip
    return found | ({"theorem": SAYS[name]} if name in SAYS else {})


def main(directory: Path, *, write: bool) -> int:
    """Write the record or compare it; 1 if it is another one."""
    try:
        record = found(directory)
    except AnotherError as error:
        print(error, file=sys.stderr)
        return 1
    if write:
        RECORD.write_text(json.dumps(record, indent=1) + "\n")
        return 0
    committed = json.loads(RECORD.read_text())
    if committed == record:
        return 0
    print(
        f"{RECORD.relative_to(ROOT)} is not what Coq has checked: .ci/coq --record", file=sys.stderr
    )
    return 1


if __name__ == "__main__":
    sys.exit(main(Path(sys.argv[1]), write="--write" in sys.argv[2:]))
