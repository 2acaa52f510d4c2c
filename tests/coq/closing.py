"""Citations that Coq closes: what a statement cites is proved in other files of the same run.

    python -m tests.coq.closing DIRECTORY        # writes Closed.v, and the files it needs

What is cited second is exported once more, as `verify.wire.coq.second_citation` does.
"""

from __future__ import annotations

import json
import re
import sys
from hashlib import sha256
from pathlib import Path

from verify.wire.coq.export import export
from verify.wire.coq.second_citation import beside

ROOT = Path(__file__).resolve().parents[2] / "certificates"


#: What `verify/coq/build` makes of some folders, for the theorems that use them.
BUILT = {
    "step": "Step", "theorem1-all": "All", "flow": "Flow", "three-balls": "Balls",
    "flow-of-balls": "BallsFlow", "sandwich": "Inner",
    "outside": "Ends", "alexander": "Almost",
}  # fmt: skip
#: What ends in a theorem on three balls: two point runs, and five scenes.
BALLS = {"theorem1-r-3-100": "Point", "theorem1-theta-5pi-6": "Angle"} | {
    f"scenes/{name}": f"Scene_{name.replace('-', '_')}"
    for name in ("passing", "parting", "nearly-aligned", "in-space", "on-a-line")
}


def module(folder: Path) -> str:
    """The Coq file of a folder."""
    name = str(folder.relative_to(ROOT))
    return (BUILT | BALLS).get(name) or "Checked_" + re.sub("[^A-Za-z0-9]", "_", name)


def closed(name: str, own: str, others: list[str], proofs: list[str]) -> list[str]:
    """The theorem that a statement is true, from proofs of those that it cites."""
    sizes = "; ".join(
        f"({other}.the_statement, size {other}.the_statement {own}.the_statement)"
        for other in others
    )
    return [
        f"Theorem {name} : true_statement {own}.the_statement.",
        f"Proof. apply {own}.proved, (citations_closed [{sizes}]).",
        "  vm_cast_no_check (eq_refl true).",  # computed once, at the end
        f"  repeat apply Forall_cons; [{' | '.join(f'exact {x}' for x in proofs)} | constructor].",
        "Qed.",
    ]


def unread() -> dict[Path, str]:
    """The committed folders that the checker in Coq cannot read, each with the reason it gives."""
    lines = Path(__file__).with_name("unread.txt").read_text(encoding="utf-8").splitlines()
    return {ROOT / name: reason for name, _, reason in (line.partition(": ") for line in lines)}


def main(directory: Path) -> None:
    """Write one theorem for each statement that cites others."""
    statements = {path.parent: path.read_bytes() for path in sorted(ROOT.rglob("statement.json"))}
    for folder in unread():
        del statements[folder]
    folders = {sha256(data).hexdigest(): folder for folder, data in statements.items()}
    lines = ["From Coq Require Import List.", "From Verify Require Import Meaning Citations."]
    lines += ["Import ListNotations."]
    made: set[str] = set()
    for folder, data in statements.items():
        cited = [folders[item["statement_sha256"]] for item in json.loads(data)["cites"]]
        if not cited:
            continue
        assert len(cited) <= 2, folder  # a third one would have to be exported beside two
        own, modules = module(folder), [module(cited[0])]
        proofs = [f"{modules[0]}.proved"]
        lines.append(f"From Verify Require {own} {modules[0]}.")
        for other in cited[1:]:
            name = f"{module(other)}_beside_{module(cited[0])}"
            if name not in made:
                text = export(beside(other, cited[0])).rpartition("Print Assumptions")[0]
                (directory / f"{name}.v").write_text(text)
                lines.append(f"From Verify Require {name}.")
                lines += closed(f"closed_{name}", name, modules[:1], proofs[:1])
                made.add(name)
            modules.append(name)
            proofs.append(f"closed_{name}")
        lines += closed(f"closed_{own}", own, modules, proofs)
    (directory / "Closed.v").write_text("\n".join(lines) + "\n")


if __name__ == "__main__":
    main(Path(sys.argv[1]))
