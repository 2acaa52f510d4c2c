"""Sums found from the names of facts alone; what does not follow from them is not found."""

from __future__ import annotations

import pytest

from verify.language.argument import Argument, ByNames, Chapter, Line, Opened
from verify.language.statement import (
    NEEDED,
    PROVED,
    UNDECIDED,
    Context,
    Given,
    Obligation,
    Statement,
    Variable,
)
from verify.language.terms import Claim, as_term, equal, sqrt, symbol
from verify.prover.arguments import write_down
from verify.prover.budget import WorkBudget
from verify.wire.inputs import InputError
from verify.wire.judge import judged
from verify.wire.questions import decide_page
from verify.wire.text.read_page import read_page

x, y = symbol("x"), symbol("y")
GIVENS = {"x-positive": 0 < x, "y-positive": 0 < y, "order": x <= y, "same": equal(y, x + 1)}


def verdict(claim: Claim, *facts: object, givens: dict[str, Claim] = GIVENS) -> str:
    """The verdict on a claim that names these facts."""
    variables = (Variable("x", "x", "x"), Variable("y", "y", "y"))
    point = {"x": as_term(1), "y": as_term(2)}
    given = tuple(Given(name, known) for name, known in givens.items())
    context = Context("here", variables, given, point)
    row = Obligation("row", "", "", NEEDED, "", claim, context="here")
    statement = Statement("t", "t", {}, (), (context,), (row,), ())
    opened = Chapter(None, (Opened(context, None),))
    line = Chapter("here", (Line("row", claim, ByNames(facts)),))
    return judged(write_down(Argument(statement, (opened, line)))).verdict


@pytest.mark.parametrize(
    ("claim", "facts"),
    [
        (x**2 <= y**2, ("order", "x-positive", "y-positive")),
        (x**3 <= y**3, ("order", "x-positive", "y-positive")),
        (0 < x * y + x, ("x-positive", "y-positive")),
        (equal(y**2, x**2 + 2 * x + 1), ("same",)),
        (2 * x * y <= x**2 + y**2, (("square", x - y),)),
        (x * y <= y**2 + 1, ("order", "y-positive")),
        (0 < 1 / y, ("y-positive",)),
        (x <= x, ()),
    ],
)
def test_what_follows_from_the_facts_is_found(claim: Claim, facts: tuple[object, ...]) -> None:
    assert verdict(claim, *facts) == PROVED


@pytest.mark.parametrize(
    ("claim", "facts"),
    [
        (x**2 <= y**2, ("order",)),
        (0 < x * y, ("x-positive",)),
        (0 < x * y, ()),
        (y <= x, ("order", "x-positive", "y-positive")),
        (equal(y, x + 2), ("same",)),
        (equal(y, x + 1), ("order",)),
        (0 <= sqrt(x), ("order",)),
    ],
)
def test_what_does_not_follow_from_them_is_left_undecided(
    claim: Claim, facts: tuple[object, ...]
) -> None:
    assert verdict(claim, *facts) == UNDECIDED


def test_what_rests_on_a_line_that_is_not_shown_is_undecided() -> None:
    variables = (Variable("x", "x", "x"),)
    context = Context("here", variables, (Given("positive", 0 < x),), {"x": as_term(1)})
    rows = tuple(
        Obligation(name, "", "", NEEDED, "", claim, context="here")
        for name, claim in (("first", 1 < x), ("second", 1 < x + 1), ("third", 0 < x + 1))
    )
    statement = Statement("t", "t", {}, (), (context,), rows, ())
    opened = Chapter(None, (Opened(context, None),))
    reasons = (ByNames(()), ByNames(("first",)), ByNames(("positive",)))
    lines = tuple(Line(row.name, row.claim, by) for row, by in zip(rows, reasons, strict=True))
    found = write_down(Argument(statement, (opened, Chapter("here", lines))))
    verdicts = {name: decision.verdict for name, decision in judged(found).decisions.items()}
    assert verdicts == {"first": UNDECIDED, "second": UNDECIDED, "third": PROVED}
    assert "first" in found.decisions["second"].reason


PAGE = """title = "t"
[contexts.c]
variables = ["Q", "b", "y", "eta", "x"]
[contexts.c.given]
share = "0 < b"
speed = "0 < y"
recedes = "0 < eta"
ratio = "eta <= Q*b*y"
other = "0 < x"
[contexts.c.point]
Q = 1
b = 1
y = 1
eta = 1
x = 1
[rows]
positive = {{ claim = "0 < Q", by = "{by}" }}
"""


@pytest.mark.parametrize(
    ("by", "wanted"),
    [
        ("share speed recedes ratio", PROVED),
        ("share speed recedes ratio other", PROVED),
        ("other", UNDECIDED),
    ],
)
def test_a_row_of_a_page_names_its_facts(by: str, wanted: str) -> None:
    page = read_page("page.toml", PAGE.format(by=by).encode())
    assert decide_page(page, WorkBudget(10**6)).verdict == wanted


def test_a_row_names_facts_that_stand_before_it() -> None:
    with pytest.raises(InputError, match="positive"):
        read_page("page.toml", PAGE.format(by="share positive").encode())
