"""Citations that Coq closes: what a statement cites is proved in another file of the same run.

python -m tests.coq.closing DIRECTORY        # writes Closed.v; says what stays open
"""

from __future__ import annotations

import json
import re
import sys
from hashlib import sha256
from pathlib import Path

ROOT = Path(__file__).resolve().parents[2] / "certificates"


def module(folder: Path) -> str:
    """The Coq file of a folder, as `.ci/coq` calls it."""
    return "Checked_" + re.sub("[^A-Za-z0-9]", "_", str(folder.relative_to(ROOT)))


def main(directory: Path) -> None:
    """Write one theorem for each statement that cites just one other."""
    statements = {path.parent: path.read_bytes() for path in sorted(ROOT.rglob("statement.json"))}
    folders = {sha256(data).hexdigest(): folder for folder, data in statements.items()}
    lines = ["From Verify Require Import Meaning Citations."]
    for folder, data in statements.items():
        cites = [item["statement_sha256"] for item in json.loads(data)["cites"]]
        if len(cites) > 1:
            print(f"open in Coq, since it cites several: {folder.name}")
        if len(cites) != 1:
            continue
        own, other = module(folder), module(folders[cites[0]])
        lines.append(f"Require {own} {other}.")
        lines.append(f"Theorem closed_{own} : true_statement {own}.the_statement.")
        lines.append(f"Proof. apply {own}.proved, (citations_closed {other}.the_statement")
        lines.append(f"  {own}.the_statement (size {other}.the_statement {own}.the_statement)).")
        lines.append(f"  vm_compute; reflexivity. exact {other}.proved. Qed.")
        print(f"closed in Coq: {folder.name} with {folders[cites[0]].name}")
    (directory / "Closed.v").write_text("\n".join(lines) + "\n")


if __name__ == "__main__":
    main(Path(sys.argv[1]))
