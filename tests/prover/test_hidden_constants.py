"""Terms with variables in them whose values do not depend on these: x - x, x/x, exp(0*x).

Facts about such a term are facts without variables, which enclosures prove; sums that use them need
the signs of their divisors all the same.
"""

from __future__ import annotations

import random

import pytest

from tests.prover.test_interior import page, verdict
from verify.prover.budget import WorkBudget
from verify.wire.questions import decide, read_page_of
from verify.wire.text.estimates import estimate

#: Those that found something when they were drawn, and others.
SEEDS = (12, 41, 194, 596, *range(1000, 1020))
WORK = 300_000


@pytest.mark.parametrize(
    ("given", "row"),
    [
        ("-2 <= x <= 1/2", "1/exp(x - x) <= 2"),
        ("-2 <= x <= 1/2", "1/sqrt(x - x + 1) <= 2"),
        ("-2 <= x <= 1/2", "2.7 <= exp(1)/exp(x - x)"),
        ("-5/2 <= x <= -2", "tan(x/x) <= 1.8574077247"),
    ],
)
def test_a_constant_divisor_is_seen_to_be_positive(given: str, row: str) -> None:
    assert verdict(["x"], [given], row) == "proved"


def constant(draw: random.Random, depth: int) -> str:
    """A term that is constant, with variables in it."""
    kind = draw.randint(0, 14) if depth else draw.randint(0, 5)
    x = draw.choice(["x", "y", "x*y", "(x+1)", "sin(x)", "exp(y)"])
    match kind:
        case 0:
            return f"({x} - {x})"
        case 1:
            return f"({x} - {x} + {draw.randint(1, 4)})"
        case 2:
            return draw.choice(["x/x", "(x+1)/(x+1)", "exp(y)/exp(y)", "(2*x)/x"])
        case 3:
            return f"(0*{x} + {draw.choice(['1/2', '2', '3'])})"
        case 4:
            return f"({x} + 2 - {x})"
        case 5:
            return draw.choice(["1", "2", "pi", "sqrt(2)", "e"])
    a, b = constant(draw, depth - 1), constant(draw, depth - 1)
    forms = ("exp({0})", "sqrt({0} + 1)", "cos({0})", "({0} + {1})", "({0}*{1})")
    forms += ("({0})/({1} + 5)", "log({0} + 2)")
    if kind == 13:
        return draw.choice(
            [f"tan({a}/4)", f"abs({a})", f"max({a},{b})", f"atan({a})", f"cbrt({a})"]
        )
    return f"({a})^2" if kind == 14 else forms[kind - 6].format(a, b)


ROWS = ("1/{0} <= {1}", "{1} <= {0}", "{0} <= {1}", "{1} < 1/({0}+7)", "x*{0} <= {1}")
ROWS += ("{0} = {1}", "{0} <= {2}", "y/{0} <= {1}")
GIVEN = (
    ["1/4 <= x <= 1/2", "-1 <= y <= 2"],
    ["1 <= x", "0 <= y"],
    ["1 <= x <= 3", "y <= x"],
    ["-3 <= x <= -1", "0 < y"],
)
#: A point of each.
POINTS = ((0.3, 1.7), (5.0, 3.0), (2.5, -1.0), (-1.5, 0.25))


@pytest.mark.parametrize("seed", SEEDS)
def test_a_drawn_row_is_decided_rightly_or_not_at_all(seed: int) -> None:
    draw = random.Random(seed)
    term, form = constant(draw, 3), draw.choice(ROWS)
    bound = draw.choice(["2", "1/3", "10", "-4", "1.8574077247"])
    row = form.format(term, bound, constant(draw, 2))
    given = draw.choice(GIVEN)
    asked = read_page_of("a.toml", page(["x", "y"], given, row), {}).statement
    found = decide(asked, WorkBudget(WORK)).decisions["row"]
    assert "search failed" not in found.reason
    if found.verdict == "proved":
        claim = next(one.claim for one in asked.obligations if one.name == "row")
        x, y = POINTS[GIVEN.index(given)]
        left, right = (estimate(side, {"x": x, "y": y}) for side in (claim.lhs, claim.rhs))
        assert left <= right + 1e-9 * (1 + abs(left))


@pytest.mark.parametrize(
    ("term", "row"),
    [
        ("sum(1/k^2, k, 1, 100)", "s < 2"),
        ("sum(1/k^2, k, 1, 1000)", "s < 1.644"),
        ("prod(1 + 1/k^2, k, 1, 1000)", "s < 4"),
    ],
)
def test_a_long_sum_does_not_nest(term: str, row: str) -> None:
    text = f'title = "t"\n[constants]\ns = "{term}"\n[rows]\nrow = "{row}"\n'
    asked = read_page_of("a.toml", text.encode(), {}).statement
    assert decide(asked).decisions["row"].verdict == "proved"
