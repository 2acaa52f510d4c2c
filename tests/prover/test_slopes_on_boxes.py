"""Claims on boxes that slopes decide, and claims about functions of terms that have bounds."""

from __future__ import annotations

import pytest

from verify import check
from verify.language.statement import PROVED
from verify.prover.budget import WorkBudget
from verify.prover.outcome import Outcome
from verify.wire.questions import decide, read_page_of
from verify.wire.write import write

PAGE = """
title = "Boxes"
[contexts.box]
variables = ["x", "y"]
given = ["{low} <= x", "x <= {high}", "{low} <= y", "y <= {high}"]
rows = {{ row = "{claim}" }}
"""


def found(page: str) -> Outcome:
    outcome = decide(read_page_of("page.toml", page.encode(), {}).statement, WorkBudget(20_000_000))
    if outcome.decisions["row"].claimed == PROVED:
        files = write(outcome)
        report = check.check(files["statement.json"], files["certificate.json"], {})
        assert report.verdict == "PROVED"
    return outcome


#: x and y occur so often that enclosures need very many parts.
CANCELLING = "atan((x*y - x - y + x*(1 - y))/sqrt(x*y*(x + y))) + x*exp(-y) - y*exp(-x)"


def test_slopes() -> None:
    """The greatest value is 0.2128..., at a corner."""
    claim = f'{{ claim = "{CANCELLING} < BOUND", by = "slopes" }}'
    page = PAGE.format(low="1", high="2", claim="CLAIM").replace('"CLAIM"', claim)
    outcome = found(page.replace("BOUND", "0.213"))
    assert outcome.decisions["row"].claimed == PROVED
    assert found(page.replace("BOUND", "0.212")).decisions["row"].claimed != PROVED


@pytest.mark.parametrize(
    ("given", "claim"),
    [
        ("-1 < x - 2*y < 1", "0 < cos(x - 2*y)"),
        ("0 <= x + y <= 3", "0 <= sin(x + y)"),
        ("x*y <= 2, 1 <= x*y", "exp(x*y) < 8"),
    ],
)
def test_arguments_that_givens_bound(given: str, claim: str) -> None:
    givens = ", ".join(f'"{part.strip()}"' for part in given.split(","))
    page = (
        f'title = "t"\n[contexts.c]\nvariables = ["x", "y"]\ngiven = [{givens}]\n'
        f'rows = {{ row = "{claim}" }}\n'
    )
    assert found(page).decisions["row"].claimed == PROVED


@pytest.mark.parametrize("claim", ["cos(1/x)/x < 1", "0 < 3*cos(1/x)/x^2 - sin(1/x)/x^3"])
def test_arguments_that_are_inverses(claim: str) -> None:
    page = (
        f'title = "t"\n[contexts.c]\nvariables = ["x"]\ngiven = ["1 < x"]\n'
        f'rows = {{ row = "{claim}" }}\n'
    )
    assert found(page).decisions["row"].claimed == PROVED


@pytest.mark.parametrize("one", ["max(1, -(1))", "max(1, 3 - 2 - 1)", "min(1, 2*1)"])
def test_a_constant_maximum_stays_as_it_is(one: str) -> None:
    """A nested form of its arguments is another term, of which no rule says that it is the same."""
    for claim in (f"x^3 - {one}/(x/x) <= 63", f"x^3 - {one}*x/x <= 63", f"x^3 - {one} <= 63"):
        assert found(PAGE.format(low="1", high="4", claim=claim)).decisions["row"].claimed == PROVED
