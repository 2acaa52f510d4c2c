"""Sets of constants with one list of rows, and constants that may be chosen, on a page."""

from __future__ import annotations

import time
from fractions import Fraction
from pathlib import Path

import pytest

from verify.language.statement import NEEDED, PRINTED, PROVED, REFUTED, Choice, Constant, Obligation
from verify.language.terms import as_term, minimum, symbol
from verify.library import read_page as read_statement
from verify.paper import theorem1
from verify.prover.budget import WorkBudget
from verify.wire.compiled import Compiled, Kept, compiled, read_compiled
from verify.wire.inputs import InputError
from verify.wire.questions import decide_page
from verify.wire.text.read_page import read_page

PAGE = """
title = "Two sets"

[sets]
old = "printed"
new = "needed"

[constants]
q = { value = "sqrt(2)", letter = "Q", label = "L" }

[[chapters]]
in = ["old", "new"]
label = "L"

[chapters.let]
"old.bounds" = ["q", "2"]
"new.bounds" = ["q/2", "1/3"]

[chapters.constants]
b = { value = "min(bounds)", letter = "β" }

[[chapters]]
in = "new"
label = "M"

[chapters.constants]
q = { value = "q/3", choose = "down" }
u = { value = "q + b", choose = "up", above = "1/8" }

[[chapters]]
in = ["old", "new"]
group = "rows"
says = "s"

[chapters.rows]
below = { claim = "b <= bounds[2]", label = "N" }
small = { claim = "b < 1", severity = "bad" }
"old.only" = { claim = "b = q", severity = "worse", corrected_by = "new.small" }
"new.own" = { claim = "0 < u" }
"""


def page(text: str = PAGE):  # type: ignore[no-untyped-def]
    return read_page("page.toml", text.encode())


def test_each_set_has_its_own_constants_and_the_same_rows() -> None:
    found = page()
    root = symbol("q")
    values = {constant.name: constant.term for constant in found.statement.constants}
    assert list(values) == ["q", "old.b", "new.b", "new.q", "new.u"]
    assert values["old.b"] == minimum(root, 2)
    assert values["new.b"] == minimum(root / 2, as_term(Fraction(1, 3)))
    assert values["new.q"] == root / 3
    assert values["new.u"] == symbol("new.q") + symbol("new.b")
    rows = {row.name: row for row in found.statement.obligations}
    assert list(rows) == [
        "old.below",
        "old.small",
        "old.only",
        *map("new.".__add__, ("below", "small", "own")),
    ]
    assert rows["old.below"].claim == (symbol("old.b") <= as_term(2))
    assert rows["new.below"].claim == (symbol("new.b") <= as_term(Fraction(1, 3)))
    assert rows["old.only"].claim.rhs == root
    assert {rows[name].role for name in rows if name.startswith("old")} == {PRINTED}
    assert {rows[name].role for name in rows if name.startswith("new")} == {NEEDED}
    assert {row.group for row in rows.values()} == {"rows"}


def test_the_severity_of_a_row_concerns_the_printed_set() -> None:
    rows = {row.name: row for row in page().statement.obligations}
    assert (rows["old.small"].severity, rows["old.small"].corrected_by) == ("bad", "new.small")
    assert (rows["new.small"].severity, rows["new.small"].corrected_by) == (None, None)
    assert (rows["old.only"].severity, rows["old.only"].corrected_by) == ("worse", "new.small")
    assert (rows["old.below"].severity, rows["old.below"].label) == (None, "N")


def test_a_constant_of_a_set_is_called_as_an_earlier_one_of_its_name() -> None:
    found = {constant.name: constant for constant in page().statement.constants}
    assert (found["new.q"].letter, found["new.q"].label) == ("Q", "L")
    assert {found[name].letter for name in ("old.b", "new.b")} == {"β"}
    assert found["new.u"].label == "M"


def test_a_constant_that_may_be_chosen_is_a_short_decimal_on_its_side(tmp_path: Path) -> None:
    found = page()
    assert {name: c.direction for name, c in found.choices.items()} == {
        "new.q": "down",
        "new.u": "up",
    }
    outcome = decide_page(found, WorkBudget())
    values = {constant.name: constant.term for constant in outcome.statement.constants}
    assert values["new.q"] == as_term(Fraction("0.471"))  # √2/3 = 0.47140…
    assert values["new.u"] == as_term(Fraction(1, 8) + Fraction("0.680"))  # 0.6793… above 1/8
    path = tmp_path / "page.toml"
    path.write_text(PAGE, encoding="utf-8")
    assert read_statement(path).constants == outcome.statement.constants
    verdicts = {row.name: decision.verdict for row, decision in outcome.rows}
    assert {n for n, verdict in verdicts.items() if verdict != PROVED} == {"old.small"}
    assert verdicts["old.small"] == REFUTED


@pytest.mark.parametrize(
    ("old", "new", "said"),
    [
        ('in = "new"', 'in = "newer"', "in"),
        ('in = ["old", "new"]\ngroup', 'in = ["old", "none"]\ngroup', "in"),
        ('new = "needed"', 'new = "wanted"', "sets.new"),
        ('choose = "down"', 'choose = "left"', "choose"),
        ('choose = "up", above', "above", "above"),
        ('b = { value = "min(bounds)"', '"none.b" = { value = "min(bounds)"', "none.b"),
        ('"new.own" =', '"new.small" =', "new.small"),
        ('b = { value = "min(bounds)"', 'bounds = { value = "min(bounds)"', "something else"),
        ('"old.only" = { claim = "b = q"', '"old.only" = { claim = "u = q"', "u"),
        ('above = "1/8"', 'above = "q/q + sqrt(3)"', "not rational"),
        ('value = "q/3"', 'value = "-q"', "positive"),
    ],
)
def test_what_does_not_fit_is_refused(old: str, new: str, said: str) -> None:
    assert PAGE.count(old) == 1
    with pytest.raises(InputError, match=said) as found:
        decide_page(page(PAGE.replace(old, new)), WorkBudget())
    assert "\n" not in str(found.value)


def test_a_constant_of_a_context_is_not_chosen() -> None:
    text = (
        PAGE
        + """
[contexts.c]
variables = "x"
given = "0 < x"
constants = { y = { value = "x", choose = "down" } }
"""
    )
    with pytest.raises(InputError, match="choose"):
        page(text)


# --- what is compiled -----------------------------------------------------------------------------


def test_what_comes_with_the_program_is_what_its_page_says() -> None:
    content = Path(theorem1.PAGE).read_bytes()
    read = theorem1.as_read(content)
    text = Path(theorem1.COMPILED).read_text(encoding="utf-8")
    read = read._replace(kept=theorem1.theorem().kept)  # which are no words of the page
    assert read_compiled(text, content) == read
    assert compiled(read, content) == text
    assert read_compiled(text, content + b"\n") is None


def test_a_text_that_is_not_one_line_is_not_compiled() -> None:
    row = Obligation("a", "g", "L", NEEDED, "says", as_term(0) < symbol("q"))
    constant = Constant("q", "q", "q", "", as_term(1))
    one = Compiled("t", ("p",), (constant, Choice(constant, "up", as_term(0))), (row,), (), {})
    one = one._replace(kept={row.claim: Kept(PROVED, (row.claim, as_term(1) <= symbol("q")))})
    assert read_compiled(compiled(one, b"x"), b"x") == one
    for said in ("two\nlines", "a\ttabulator"):
        with pytest.raises(ValueError, match="write a space"):
            compiled(one._replace(rows=(row._replace(says=said),)), b"x")
    with pytest.raises(ValueError, match="about a context"):
        compiled(one._replace(rows=(row._replace(context="c"),)), b"x")


def test_many_sets_are_read_soon() -> None:
    sets = "".join(f's{i} = "needed"\n' for i in range(80))
    constants = "".join(f'c{j} = "{j} + 1"\n' for j in range(24))
    rows = "".join(f'r{j} = {{ claim = "0 < c{j}" }}\n' for j in range(24))
    homes = [f"s{i}" for i in range(80)]
    text = f'title = "t"\n[sets]\n{sets}[[chapters]]\nin = {homes}\n'.replace("'", '"')
    begin = time.process_time()
    read_page("p.toml", f"{text}[chapters.constants]\n{constants}[chapters.rows]\n{rows}".encode())
    assert time.process_time() - begin < 6
