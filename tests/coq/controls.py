"""Certificates that Coq has to refuse, and at which step: the lies that have the format.

python -m tests.coq.controls DIRECTORY           # writes Controls.v, and controls.json beside it
coqc -R CHECKER Verify Controls.v | python -m tests.coq.controls DIRECTORY --compare
"""

from __future__ import annotations

import json
import re
import sys
from collections.abc import Iterator
from copy import deepcopy
from hashlib import sha256
from pathlib import Path
from typing import Any, TypeVar

from tests.check import test_rule_law, test_rule_monotony, test_rule_range
from tests.check.support import INTERVAL, ROOT, Pair, term, total
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


#: Where a certificate is changed.
Place = TypeVar("Place")
#: Of a long certificate only some places are changed, since Coq checks it again for each.
BYTES = 300_000
#: For each of these it takes seconds, up to ten, and the extracted program a fifth of that, which
#: gets them instead, with one change of each kind.
SLOW = {"bb84", "flow", "max-cut"}


def spread(places: list[Place], folder: Path) -> list[Place]:
    """Places of a certificate, from the first to the last in equal steps."""
    size = (folder / "certificate.json").stat().st_size
    most = 1 if folder.name in SLOW else max(2, BYTES // size)
    return places if len(places) <= most else places[:: len(places) // most + 1]


def dropped(folder: Path) -> Iterator[tuple[str, tuple[bytes, bytes]]]:
    """The certificate of an example without an addend, a cut, a given, or with another digit."""
    first = json.loads((folder / "statement.json").read_bytes())
    second = json.loads((folder / "certificate.json").read_bytes())
    for key, change in (("addends", "addend"), ("equations", "equation"), ("using", "using")):
        places = [i for i, item in enumerate(sums(second)) if item.get(key)]
        for i in spread(places, folder):
            certificate = deepcopy(second)
            del [*sums(certificate)][i][key][-1]
            yield f"{folder.name}:{i}:without-{change}", packed(first, certificate)
    cuts = [i for i, item in enumerate(sums(second)) if item.get("rule") == "cuts"]
    for i in spread(cuts, folder):
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
    enclosed = [
        (kind, ends, name)
        for kind, ends in (("constants", "ends"), ("rows", "lhs"))
        for name in second["enclosures"][kind]
    ]
    for kind, ends, name in spread(enclosed, folder):
        certificate = deepcopy(second)
        found = certificate["enclosures"][kind][name]
        text = found[ends][1]
        found[ends] = [f"{text}1" if "." in text else f"{text}.1"] * 2
        yield f"{folder.name}:{name}:another-digit", packed(first, certificate)


#: Claims on roots with their proofs.
ROOTS: list[tuple[str, Any]] = [
    ("root(27, 3) = 3", INTERVAL), ("root(27, 4) = 3", INTERVAL), ("root(0, 3) <= 0", INTERVAL),
    ("root(8/27, 3) <= 2/3", INTERVAL), ("root(9/27, 3) <= 2/3", INTERVAL),
    ("root(-1, 3) <= 0", INTERVAL), ("root(1 - sqrt(1), 3) <= 1", INTERVAL),
    ("root(2, 3) < 1259921049894873165/1000000000000000000", INTERVAL),
    ("root(2, 3) < 1259921049894873164/1000000000000000000", INTERVAL),
    ("root(2, 3)**3 = 2", total()), ("root(2, 3)**2 = 2", total()),
    ("root(2, 3)**7 = 4*root(2, 3)", total()), ("root(2, 3)**7 = 4*root(2, 4)", total()),
    ("root(1/root(2, 3), 4)**4 = 1/root(2, 3)", total()), ("root(0, 5)**5 = 0", total()),
    ("-1 < root(2, 3)", total("goal", ["root", term("root(2, 3)")], "1")),
    ("1 < root(2, 3)", total("goal", ["root", term("root(2, 3)")], "1")),
    ("0 < root(2, 3)", ROOT), ("0 < root(3, 3)", ROOT), ("1 < root(2, 3)", ROOT),
]  # fmt: skip


def rising_within() -> Iterator[Pair]:
    """Values of functions in proofs within proofs and of givens; of each a near miss, too."""
    monotony = test_rule_monotony.monotony

    def context(proof: Any = INTERVAL) -> Pair:
        givens = {"less": "x < y", "most": "x <= y"}
        return Pair().context("c", {"x": "1", "y": "2"}, givens, [proof, INTERVAL])

    for given in ("less", "most"):
        inner = monotony(monotony(given), "atan")
        yield context().row("row", "exp(x) < exp(y)", monotony(inner), "c")
        inner = monotony(monotony(monotony(given)), "exp")
        yield context().row("row", "x < y", monotony(inner, "exp"), "c")
    for under in ("exp", "sqrt"):
        yield context(monotony(INTERVAL, under)).row("row", "0 < 1", INTERVAL)
    for numbers in ({"x": "2", "y": "3"}, {"x": "3", "y": "2"}):
        proofs = [monotony(INTERVAL, "exp"), INTERVAL]
        applies = {"rule": "instance", "givens": proofs}
        yield context().row("row", ["applies", "c", numbers], applies)
        pair = context().row("one", "exp(x) < exp(y)", monotony("less"), "c")
        instance = {"rule": "instance", "of": "one", "at": numbers, "givens": proofs}
        a, b = numbers.values()
        yield pair.row("row", f"exp({a}) < exp({b})", instance)


def functions() -> dict[str, tuple[bytes, bytes]]:
    """Laws, ranges, roots and functions that rise: true ones, and near misses of them."""
    laws = [test_rule_law.statement(claim) for claim, _ in test_rule_law.CASES]
    ranges = [test_rule_range.statement(claim) for claim, _ in test_rule_range.CASES]
    rising = [pair for pair, _ in test_rule_monotony.statements()]
    two = ("two", "0 < 2", INTERVAL)
    roots = [Pair().lemma(*two).row("row", claim, proof) for claim, proof in ROOTS]
    rules = {"root": roots, "law": laws, "range": ranges, "monotony": rising}
    rules["within"] = [*rising_within()]
    return {
        f"{rule}-{i}": one.files() for rule, found in rules.items() for i, one in enumerate(found)
    }


def controls() -> Iterator[tuple[str, Reading]]:
    """What has the format and is refused, and some that are honest."""
    pairs = [("honest", honest().files()), *functions().items()]
    pairs += [(name, lie.files()) for name, lie in LIES.items()]
    for folder in sorted({path for path in EXAMPLES.iterdir() if path.is_dir()} - unread().keys()):
        pairs += () if folder.name in SLOW else dropped(folder)
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
    """One module for each control, and what Coq has to say of each."""
    parts, wanted = [HEAD], []
    first: dict[str, str] = {}  # where a list stands first: Coq reads it once
    for i, (name, reading, text) in enumerate(transcribed()):
        wanted.append((name, expected(reading)))
        parts.append(f"Module Control{i}.")
        for definition in text:
            head, _, _ = definition.partition(" := [")
            named = f"Control{i}.{head.split()[1]}"
            where = first.setdefault(definition, named) if head != definition else named
            parts.append(definition if where == named else f"{head} := {where}.")
        parts.append(f"End Control{i}.")
        parts.append(f"Eval vm_compute in ({i}%nat, complaint_about")
        parts.append(f"  Control{i}.the_statement Control{i}.the_certificate).")
    (directory / "Controls.v").write_text("\n".join(parts))
    (directory / "controls.json").write_text(json.dumps(wanted))


def expected(reading: Reading) -> str:
    """The first refused step, or what else is refused."""
    if not reading.complaints:
        return "None"
    if reading.refused:
        labels = [label(step) for step in reading.certificate["steps"]]
        return f"Some (AtStep {labels.index(reading.refused[0]) + 1})"
    return "Some"


def compare(directory: Path, output: str) -> int:
    """Whether Coq refuses all that the checker refuses, and at the same step."""
    found = dict(re.findall(r"= \((\d+)%?n?a?t?, (.*)\)\s+:", output))
    accepted, elsewhere = [], []
    controls = json.loads((directory / "controls.json").read_text())
    for i, (name, wanted) in enumerate(controls):
        answer = found[str(i)]
        if (answer == "None") != (wanted == "None"):
            accepted.append(f"{name}: Coq says {answer}, the checker {wanted}")
        elif not answer.startswith(wanted):
            elsewhere.append(f"{name}: Coq says {answer}, the checker {wanted}")
    for line in accepted + elsewhere:
        print(line, file=sys.stderr)
    wrong = f"{len(accepted)} with another verdict, {len(elsewhere)} elsewhere"
    print(f"controls: {len(controls)}, {wrong}")
    return bool(accepted)


if __name__ == "__main__":
    if sys.argv[2:] == ["--compare"]:
        sys.exit(compare(Path(sys.argv[1]), sys.stdin.read()))
    write(Path(sys.argv[1]))
