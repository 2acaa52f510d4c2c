"""The list of displayed formulas: nothing is left out, and every name in it exists."""

from __future__ import annotations

import re
from pathlib import Path

from verify.language.statement import Obligation
from verify.paper import theorem1

TABLE = Path(theorem1.__file__).parent / "formulas.md"

#: How many displayed formulas Section 4 has, counted in the LaTeX text.
DISPLAYED = 106


def table() -> list[list[str]]:
    """The cells of each line of the table: number, formula, what it says, carried by."""
    lines = TABLE.read_text(encoding="utf-8").splitlines()
    entries = [line for line in lines if re.match(r"\| \d+ \|", line)]
    return [[cell.strip() for cell in re.split(r"(?<!\\)\|", entry)[1:-1]] for entry in entries]


def rows() -> list[Obligation]:
    return [row for part in theorem1.theorem().parts.values() for row in part.obligations]


def constants() -> set[str]:
    statement = theorem1.theorem()
    chosen = [constant for part in statement.parts.values() for constant in part.bounds]
    return {constant.name for constant in (*statement.common, *chosen)}


def names(cell: str) -> list[str]:
    return re.findall(r"`([^`]+)`", cell)


def labels() -> list[str]:
    return [names(cells[1])[0] for cells in table() if not cells[1].startswith("(none)")]


def test_there_is_one_line_for_every_displayed_formula() -> None:
    assert [cells[0] for cells in table()] == [str(n) for n in range(1, DISPLAYED + 1)]
    for cells in table():
        assert len(cells) == 4
        assert all(cells)
        assert len(names(cells[1])) == 1
    assert f"All {DISPLAYED} displayed formulas" in TABLE.read_text(encoding="utf-8")


def test_every_name_that_carries_a_formula_exists() -> None:
    statement = theorem1.theorem()
    known = {row.name for row in rows()} | constants()
    known |= {assumption.name for assumption in statement.assumptions}
    unknown = [
        (cells[0], name) for cells in table() for name in names(cells[3]) if name not in known
    ]
    assert unknown == []


def test_every_constant_and_assumption_carries_a_formula() -> None:
    statement = theorem1.theorem()
    carrying = {name for cells in table() for name in names(cells[3])}
    # The collapse time and the induction are not displayed: the paper leaves them out.
    assert constants() - carrying == {"printed.T_star", "repaired.T_star"}
    assert {assumption.name for assumption in statement.assumptions} - carrying == {"induction"}


def test_every_label_of_a_row_is_in_the_table() -> None:
    listed = labels()
    assert len(listed) == len(set(listed))
    used = {row.label for row in rows()}
    assert {label for label in used if label.startswith("EQUATSS4.1")} <= set(listed)


def test_every_misprint_of_a_display_is_in_the_table() -> None:
    carrying = {name for cells in table() for name in names(cells[3])}
    displayed = set(labels())
    missing = {row.name for row in rows() if row.severity and row.label in displayed} - carrying
    assert missing == set()


def test_remarks_and_causes_name_things_that_exist() -> None:
    statement = theorem1.theorem()
    displayed = set(labels())
    for remark in statement.remarks:
        assert remark.label in displayed or remark.label == statement.name
    known = {row.name for row in rows()}
    short = {name.partition(".")[2] for name in known}
    mentioned = [name for remark in statement.remarks for name in names(remark.text)]
    mentioned += [name for cause in statement.causes for name in names(cause.text)]
    earlier = {"EQUATSS2.2LoiEvDistaInit1", "EQUATSS2.2LoiEvW1Om1Init1"}
    assert {n for n in mentioned if n.startswith("EQUATSS2")} == earlier
    assert set(mentioned) <= short | displayed | earlier
