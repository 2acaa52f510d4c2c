"""What has to be believed: three checkers, and the assumptions of each theorem."""

from __future__ import annotations

from collections.abc import Iterator

from verify.language.statement import Assumption, Publication
from verify.views.material import Material
from verify.views.page.blocks import (
    Block,
    Cell,
    Code,
    Commands,
    Heading,
    Items,
    Paragraph,
    Strong,
    Table,
    Text,
)
from verify.views.page.coq import checked_in_coq
from verify.views.page.writer import label_cell

#: The certificates, for a shell.
EVERY = "certificates/*/certificate.json certificates/scenes/*/certificate.json"


def trust(material: Material) -> Iterator[Block]:
    """The checkers, how to run them, and what is assumed."""
    yield Heading("trust", "Trust")
    yield from _checkers(material)
    yield from _recheck(material)
    yield from _assumptions(material)


def _checkers(material: Material) -> Iterator[Block]:
    rows: list[list[Cell]] = [
        [
            [Code("verify/check.py")],
            [Text("Python's standard library; it searches for nothing")],
            [Text(f"accepted all {len(material.folders)} certificates when this page was written")],
        ],
        [
            [Code("verify/coq")],
            [Text("Coq: that the checker is right is a theorem there")],
            checked_in_coq(material),
        ],
    ]
    if material.maps:
        rows.append([
            [Code("verify/check_map.py")],
            [Text("Python's standard library, in whole numbers; it takes the theorems "),
             Code("flow"), Text(" and "), Code("sharper"), Text(" for granted")],
            [Text(f"accepted {_logs(material)} when this page was written")],
        ])  # fmt: skip
    yield Table("Three checkers", ("Checker", "What it rests on", "What it has checked"), rows)


def _logs(material: Material) -> str:
    number = len(material.maps)
    logs = "the log of the map" if number == 1 else f"the {number} logs of maps"
    return f"{logs}, but not that of the strip," if material.strips else logs


def _recheck(material: Material) -> Iterator[Block]:
    yield Heading("check", "Check it yourself", 3)
    yield Paragraph([
        Text("You need not believe the program. What it claims and how each claim is proved are "
             "files, and a checker reads them: at a point, for all parameters, and the step for "
             "every state. In the folder of the project:"),
    ])  # fmt: skip
    lines = [
        "python3 -I verify/check.py certificates/theorem1-all certificates/step",
        f"python3 -I verify/check.py $(dirname {EVERY})",
    ]
    logs = [f"certificates/{name}" for name in material.logs]
    lines += [f"python3 -I verify/check_map.py {' '.join(logs)}"] if logs else []
    yield Commands(lines)
    yield Paragraph([
        Text("With the program installed, "), Code("verify check --statement FOLDER"),
        Text(" also makes the statement anew and compares it byte for byte, and "),
        Code("verify report --compare"), Text(" does so with the numbers of this page."),
    ])  # fmt: skip


def _assumptions(material: Material) -> Iterator[Block]:
    yield Heading("assumptions", "Taken on trust", 3)
    yield Paragraph([Text(
        "What is used and not proved by the program, here or in a statement that is cited. The "
        "checker prints the names with each verdict."
    )])  # fmt: skip
    seen: set[str] = set()
    for folder in material.folders:
        statement = folder.outcome.statement
        if statement.theorem not in seen:
            seen.add(statement.theorem)
            yield Paragraph([Strong("For "), Code(statement.theorem), Text(":")])
            yield Items([_assumption(a, material.paper) for a in folder.outcome.assumptions])
            if folder.outcome.printed_assumptions:
                yield Paragraph([Text("and for its printed rows only:")])
                yield Items(
                    [_assumption(a, material.paper) for a in folder.outcome.printed_assumptions]
                )


def _assumption(assumption: Assumption, paper: Publication) -> Cell:
    return [
        *label_cell(assumption.label, paper),
        Text(f" ({assumption.kind}): {assumption.sentence}"),
    ]
