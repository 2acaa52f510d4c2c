"""The erratum says what the program has found, and each of its lines names rows that are proved."""

from __future__ import annotations

import re
from collections.abc import Mapping
from functools import cache

import pytest

from verify.cli import main
from verify.language.statement import NEEDED, PROVED
from verify.paper.commands.citing import verdicts_as_printed
from verify.paper.commands.pages import accepted
from verify.paper.commands.repaired_theorem import whole
from verify.paper.source import PAPER
from verify.prover.outcome import Outcome
from verify.prover.uses import nodes
from verify.publication import BREAKS, REPAIRED
from verify.views import words as said
from verify.views.erratum import _Erratum, erratum
from verify.views.point import printed_lines

EVERYWHERE = accepted("all_parameters")
PRINTED = accepted("printed_rows")
ROWS = {row.name: (row, found) for row, found in EVERYWHERE.rows}


@pytest.fixture(scope="module")
def text() -> str:
    return erratum(EVERYWHERE, PRINTED, whole(), verdicts_as_printed(), PAPER)


@cache
def behind() -> Mapping[str, frozenset[str]]:
    """All facts on which each rests."""
    found: dict[str, frozenset[str]] = {}
    for name, node in nodes(EVERYWHERE).items():
        inner = (found.get(one, frozenset()) for one in node.uses)
        found[name] = frozenset(node.uses).union(*inner)
    return found


def test_it_replaces_each_formula_in_the_order_of_the_paper(text: str) -> None:
    found = re.findall(r"^\\textbf\{\((4\.\d+)\)\}", text, re.MULTILINE)
    assert {"4.10", "4.37", "4.40", "4.41", "4.42", "4.43", "4.47", "4.53"} <= {*found}
    assert found == sorted(found, key=lambda number: int(number.partition(".")[2]))
    breaking = {row.label for row, _ in PRINTED.rows if row.severity == BREAKS}
    changed = {change.label for change in PAPER.notes().changes}
    assert text.count("\n\\textbf{") == len(breaking | changed) + 1  # and the title


def test_each_line_names_rows_that_are_proved_for_all_parameters(text: str) -> None:
    lines = [line for line in text.splitlines() if re.match(r"\\textbf\{(\(4|Theorem)", line)]
    for line in lines:
        names = re.findall(r"\[\\texttt\{(.*?)\}: \$", line.replace(r"\allowbreak{}", ""))
        assert names
        for name in names:
            row, found = ROWS[f"{REPAIRED}.{name.replace(chr(92), '')}"]
            assert (row.role, found.verdict) == (NEEDED, PROVED)
    for row, found in PRINTED.rows:
        if row.severity == BREAKS:
            assert ROWS[row.corrected_by or ""][1].verdict == PROVED
            assert found.verdict == "refuted"


def test_the_rows_of_a_change_rest_on_the_constants_that_it_changes() -> None:
    constants = {one.label: one for one in whole().constants if one.name.startswith(REPAIRED)}
    for change in PAPER.notes().changes:
        for name in change.rows:
            assert f"{REPAIRED}.{name}" in ROWS
        if change.label in constants and constants[change.label].term.op == "min":
            entries = [one for one in whole().constants if one.label == change.label]
            wanted = {f"{one.name}-entry-{k}" for one in entries for k in range(1, 9)}
            wanted |= {f"{one.name}-positive" for one in entries}
            for name in change.rows:
                assert behind()[f"{REPAIRED}.{name}"] & wanted, (change.label, name)


def test_an_entry_that_is_left_out_is_at_least_one_that_stays() -> None:
    made = _Erratum(EVERYWHERE, PRINTED, whole(), PAPER)
    left_out = 0
    for constant in whole().constants:
        if constant.term.op != "min":
            continue
        kept = made.least(constant)
        stays = {*kept.children} if kept.op == "min" else {kept}
        for place, entry in enumerate(constant.term.children, 1):
            while entry not in stays:
                claim = ROWS[f"redundant.{constant.short_name}-{place}"][0].claim
                assert (claim.relation, claim.rhs) == ("<=", entry)  # type: ignore[union-attr]
                entry = claim.lhs  # type: ignore[union-attr]
                place = constant.term.children.index(entry) + 1
                left_out += 1
    assert left_out >= 10


def test_what_would_not_be_proved_is_an_error() -> None:
    row, found = ROWS[f"{REPAIRED}.zeta-x-bound"]
    decisions = {**EVERYWHERE.decisions, row.name: found._replace(judged=None)}
    open_ = Outcome(EVERYWHERE.statement, decisions, EVERYWHERE.steps, EVERYWHERE.enclosures)
    with pytest.raises(KeyError):
        erratum(open_, PRINTED, whole(), verdicts_as_printed(), PAPER)


def test_its_latex_is_closed(text: str) -> None:
    bare = re.sub(r"\\[\\{}$]", "", text)
    depth = 0
    for sign in bare:
        depth += {"{": 1, "}": -1}.get(sign, 0)
        assert depth >= 0
    assert depth == 0
    for line in text.splitlines():
        assert len(re.findall(r"(?<!\\)\$", line)) % 2 == 0
        assert line.isascii() or all(sign in "éáèü" for sign in line if not sign.isascii())
    assert re.findall(r"\\(begin|end)\{(\w+)\}", text) == [
        ("begin", "document"),
        ("end", "document"),
    ]
    assert text.count(r"\Bigl(") == text.count(r"\Bigr)")
    words = re.sub(r"\\[A-Za-z]+|[{}$\\]", "", text)
    assert len(words) < 7_500  # a page of footnotes


def test_the_command(capsys: pytest.CaptureFixture[str], text: str) -> None:
    assert main(["theorem1", "--erratum"]) == 0
    assert capsys.readouterr().out == text
    for more in (["--r", "0.03"], ["--all"], ["--json"], ["--out", "x"], ["-v"]):
        assert main(["theorem1", "--erratum", *more]) == 2
        assert "leave it out with --erratum" in capsys.readouterr().err


def test_the_room_for_the_angle_is_that_of_the_certificate() -> None:
    """A reader of the summary is told what Θ is, as the statement about the printed set has it."""
    outcome = accepted("printed_set")
    (found,) = (c for one in outcome.statement.contexts for c in one.constants if c.name == "Theta")
    told = said.letters(outcome).term(found.term).replace("·", " ")
    assert f"Θ = {told}" in " ".join(printed_lines(verdicts_as_printed(), PAPER))
