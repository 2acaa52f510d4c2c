"""The list of displayed formulas: nothing is left out, and every name in it exists."""

from __future__ import annotations

import re
from pathlib import Path

from verify.paper import theorem1

TABLE = Path(theorem1.__file__).parent / "formulas.md"

#: How many displayed formulas Section 4 has, counted in the LaTeX text.
DISPLAYED = 106


def table() -> list[list[str]]:
    """The cells of each line of the table: number, formula, what it says, carried by."""
    lines = TABLE.read_text(encoding="utf-8").splitlines()
    rows = [line for line in lines if re.match(r"\| \d+ \|", line)]
    return [[cell.strip() for cell in re.split(r"(?<!\\)\|", row)[1:-1]] for row in rows]


def names(cell: str) -> list[str]:
    return re.findall(r"`([^`]+)`", cell)


def labels() -> list[str]:
    return [names(cells[1])[0] for cells in table() if not cells[1].startswith("(none)")]


def test_there_is_one_line_for_every_displayed_formula() -> None:
    rows = table()
    assert [cells[0] for cells in rows] == [str(n) for n in range(1, DISPLAYED + 1)]
    for cells in rows:
        assert len(cells) == 4
        assert all(cells)
        assert len(names(cells[1])) == 1
    assert f"All {DISPLAYED} displayed formulas" in TABLE.read_text(encoding="utf-8")


def test_every_name_that_carries_a_formula_exists() -> None:
    statement = theorem1.theorem()
    known = {row.name for row in statement.obligations}
    known |= {constant.name for constant in statement.constants}
    known |= {assumption.name for assumption in statement.assumptions}
    unknown = [
        (cells[0], name) for cells in table() for name in names(cells[3]) if name not in known
    ]
    assert unknown == []


def test_every_constant_and_assumption_carries_a_formula() -> None:
    statement = theorem1.theorem()
    carrying = {name for cells in table() for name in names(cells[3])}
    # The collapse time and the induction are not displayed: the paper leaves them out.
    missing = {constant.name for constant in statement.constants} - carrying
    assert missing == {"printed.T_star", "repaired.T_star"}
    assert {assumption.name for assumption in statement.assumptions} - carrying == {"induction"}


def test_every_label_of_a_row_is_in_the_table() -> None:
    listed = labels()
    assert len(listed) == len(set(listed))
    used = {row.label for row in theorem1.theorem().obligations}
    assert {label for label in used if label.startswith("EQUATSS4.1")} <= set(listed)
