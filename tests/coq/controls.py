"""Certificates that Coq has to refuse, and at which step: the lies that have the format.

python -m tests.coq.controls DIRECTORY           # writes Controls.v
coqc -R CHECKER Verify Controls.v | python -m tests.coq.controls --compare
"""

from __future__ import annotations

import json
import re
import sys
from collections.abc import Iterator
from copy import deepcopy
from hashlib import sha256
from pathlib import Path
from typing import Any

from tests.coq.closing import unread
from tests.lies.lies import LIES, honest
from verify import check
from verify.wire.coq.export import data
from verify.wire.coq.reading import NotAcceptedError, Reading, label, read

EXAMPLES = Path(__file__).resolve().parents[2] / "certificates/examples"
HEAD = """From Coq Require Import ZArith QArith List.
From Verify Require Import Meaning Clearing Kernel Checker.
Import ListNotations.
Open Scope positive_scope.
Set Printing Width 1000000.
"""


def packed(statement: Any, certificate: Any) -> tuple[bytes, bytes]:
    """Two files that belong together."""
    first = json.dumps(statement).encode()
    certificate["statement_sha256"] = sha256(first).hexdigest()
    return first, json.dumps(certificate).encode()


def sums(value: Any) -> Iterator[Any]:
    """All objects inside a value, the outer ones first."""
    if isinstance(value, dict):
        yield value
    for item in value.values() if isinstance(value, dict) else value:
        if isinstance(item, dict | list):
            yield from sums(item)


#: Of a long certificate only some places are changed, since Coq checks it again for each.
BYTES = 1_000_000


def spread(places: list[int], size: int) -> list[int]:
    """Places of a certificate of so many bytes, from the first to the last in equal steps."""
    most = max(2, BYTES // size)
    return places if len(places) <= most else places[:: len(places) // most + 1]


def dropped(folder: Path) -> Iterator[tuple[str, tuple[bytes, bytes]]]:
    """The certificate of an example without an addend, a cut, a given, or with another digit."""
    first = json.loads((folder / "statement.json").read_bytes())
    data = (folder / "certificate.json").read_bytes()
    second = json.loads(data)
    for key, change in (("addends", "addend"), ("equations", "equation"), ("using", "using")):
        places = [i for i, item in enumerate(sums(second)) if item.get(key)]
        for i in spread(places, len(data)):
            certificate = deepcopy(second)
            del [*sums(certificate)][i][key][-1]
            yield f"{folder.name}:{i}:without-{change}", packed(first, certificate)
    cuts = [i for i, item in enumerate(sums(second)) if item.get("rule") == "cuts"]
    for i in spread(cuts, len(data)):
        certificate = deepcopy(second)
        proof = [*sums(certificate)][i]
        del proof["at"][0], proof["branches"][0]
        yield f"{folder.name}:{i}:without-cut", packed(first, certificate)
    for i, context in enumerate(first["contexts"]):
        for j, given in enumerate(context["givens"]):
            statement, certificate = deepcopy(first), deepcopy(second)
            del statement["contexts"][i]["givens"][j]
            for step in certificate["steps"]:
                if step.get("open") == context["name"]:
                    del step["givens"][j]
            yield f"{folder.name}:{given['name']}:without-given", packed(statement, certificate)
    for kind in ("constants", "rows"):
        for name, found in second["enclosures"][kind].items():
            ends = "ends" if kind == "constants" else "lhs"
            certificate = deepcopy(second)
            text = found[ends][1]
            certificate["enclosures"][kind][name][ends] = [
                f"{text}1" if "." in text else f"{text}.1"
            ] * 2
            yield f"{folder.name}:{name}:another-digit", packed(first, certificate)


def controls() -> Iterator[tuple[str, Reading]]:
    """What has the format and is refused, and two that are honest."""
    pairs = [("honest", honest().files())]
    pairs += [(name, lie.files()) for name, lie in LIES.items()]
    for folder in sorted({path for path in EXAMPLES.iterdir() if path.is_dir()} - unread().keys()):
        pairs += dropped(folder)
    for name, (first, second) in pairs:
        try:
            yield name, read(check.Folder(name, first, second, []))
        except NotAcceptedError:
            continue  # not in the format: Coq never sees it


def transcribed() -> Iterator[tuple[str, Reading, list[str]]]:
    """The controls that can be written as data."""
    for name, reading in controls():
        try:
            yield name, reading, data(reading)
        except (check.Malformed, NotAcceptedError):
            continue  # a term in a proof that was refused before is none, or Coq has no such rule


def write(directory: Path) -> None:
    """One module for each control, with what Coq has to complain about."""
    parts = [HEAD]
    for i, (_, _, text) in enumerate(transcribed()):
        parts += [f"Module Control{i}.", *text, f"End Control{i}."]
        parts.append(f"Eval vm_compute in ({i}%nat, complaint_about")
        parts.append(f"  Control{i}.the_statement Control{i}.the_certificate).")
    (directory / "Controls.v").write_text("\n".join(parts))


def expected(reading: Reading) -> str:
    """The first refused step, or what else is refused."""
    if not reading.complaints:
        return "None"
    if reading.refused:
        labels = [label(step) for step in reading.certificate["steps"]]
        return f"Some (AtStep {labels.index(reading.refused[0]) + 1})"
    return "Some"


def compare(output: str) -> int:
    """Whether Coq refuses all that the checker refuses, and at the same step."""
    found = dict(re.findall(r"= \((\d+)%?n?a?t?, (.*)\)\s+:", output))
    accepted, elsewhere, count = [], [], 0
    for i, (name, reading, _) in enumerate(transcribed()):
        answer, wanted = found[str(i)], expected(reading)
        count += 1
        if (answer == "None") != (wanted == "None"):
            accepted.append(f"{name}: Coq says {answer}, the checker {wanted}")
        elif not answer.startswith(wanted):
            elsewhere.append(f"{name}: Coq says {answer}, the checker {wanted}")
    for line in accepted + elsewhere:
        print(line, file=sys.stderr)
    print(f"controls: {count}, {len(accepted)} with another verdict, {len(elsewhere)} elsewhere")
    return bool(accepted)


if __name__ == "__main__":
    if sys.argv[1] == "--compare":
        sys.exit(compare(sys.stdin.read()))
    write(Path(sys.argv[1]))
