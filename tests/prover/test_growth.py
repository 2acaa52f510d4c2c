"""Claims that touch, or hold on unbounded ranges, by signs of derivatives; each is checked."""

from __future__ import annotations

import random
from fractions import Fraction
from typing import Any

import pytest

from tests.check.support import term as document
from verify import check
from verify.language.statement import PROVED, UNDECIDED
from verify.language.terms import Term
from verify.measure.inequalities import judge
from verify.prover.search.derivatives import derivative
from verify.prover.search.exact import ExactRanges
from verify.wire.term_json import TermReader

Ends = tuple[str | None, str | None]
LINE, HALF = (None, None), ("0", None)


def judged(claim: str, ends: Ends) -> tuple[str, bool]:
    entry: dict[str, Any] = {"name": "", "category": "", "truth": True}
    entry |= {"variables": {"x": list(ends)}, "claim": document(claim)}
    found = judge(entry, 60)
    return found.verdict, found.accepted


@pytest.mark.parametrize(
    ("claim", "ends"),
    [
        ("sin(x) <= x", HALF),
        ("sin(x) < x", ("0", "1")),
        ("1 + x <= exp(x)", LINE),
        ("log(x) <= x - 1", HALF),
        ("log(1 + x) < x", HALF),
        ("2*x/(2 + x) <= log(1 + x)", HALF),
        ("log(x)/(x - 1) <= 1/sqrt(x)", ("1", "3500")),
        ("atan(x) <= x", HALF),
        ("3*x/(1 + 2*sqrt(1 + x**2)) < atan(x)", ("0", "10")),
        ("8*x/(3 + sqrt(25 + 80*x**2/3)) < atan(x)", ("0", "10")),
        ("exp(x) <= (2 + x)/(2 - x)", ("0", "2")),
        ("1 + x + x**2/2 + x**3/6 <= exp(x)", LINE),
        ("x*log(x) <= x**2 - x", HALF),
        ("x - x**3/6 <= sin(x)", HALF),
        ("2*x/pi() <= sin(x)", ("0", "3/2")),
        ("x < sin(x)/cos(x)", ("0", "3/2")),
        ("exp(x - x**2) <= 1 + x", ("0", "1")),
        ("log(1 - x) <= -x", ("0", "9/10")),
        ("x**2/(2 + 2*x/3) <= (1 + x)*log(1 + x) - x", HALF),
    ],
)
def test_what_touches_is_proved(claim: str, ends: Ends) -> None:
    assert judged(claim, ends) == (PROVED, True)


@pytest.mark.parametrize(
    ("claim", "ends"),
    [
        ("x <= sin(x)", HALF),
        ("1 + x < exp(x)", LINE),
        ("1 + x + x**2/2 <= exp(x)", LINE),
        ("log(x) < x - 1", HALF),
        ("exp(x) <= (2 + x)/(2 - x)", ("-1", "1")),
        ("sin(x) <= x - x**3/5", ("0", "1")),
    ],
)
def test_what_is_false_is_not_proved(claim: str, ends: Ends) -> None:
    assert judged(claim, ends)[0] != PROVED
    assert judged(claim, ends)[0] == UNDECIDED or judged(claim, ends)[1]


TERMS = (
    "x**3 - 2*x*exp(2*x)", "exp(x)/(1 + x**2)", "log(1 + x**2)/x", "atan(3*x) - x/y", "y/x + y*x",
    "sin(x**2)*cos(y*x)", "cos_pi(x/2)", "root(1 + x, 5)", "sqrt(x)*(x - y)", "-(x - 1)**1",
    "(y - x)/(x - y)", "y - exp(-x)", "pi()*x",
)  # fmt: skip


@pytest.mark.parametrize("text", TERMS)
def test_the_checker_builds_the_same_derivative(text: str) -> None:
    kernel = check.Kernel()
    context = check.Context("c", kernel.outermost)
    x, _ = (kernel.new_name(name, context) for name in "xy")
    wanted = check.Slopes(kernel, context, x).of(kernel.read("", document(text), context))
    found = derivative(TermReader({}).term(document(text)), "x")
    assert found is not None
    assert kernel.read("", written(found), context) == wanted


def written(term: Term) -> Any:
    from verify.wire.term_json import TermWriter

    return TermWriter("", (), {}).term(term)


@pytest.mark.parametrize("op", ["exp", "log", "atan", "sin"])
def test_ranges_of_the_search_contain_those_of_the_checker(op: str) -> None:
    """What the search takes for shown the checker shows."""
    numbers = random.Random(op)
    for bits in (48, 64):
        scope = check.Enclosing(check.Kernel(), bits, None)
        for _ in range(60):
            low = Fraction(numbers.randint(1, 10**6), numbers.randint(1, 10**6))
            high = low + Fraction(numbers.randint(0, 10**6), 10**7)
            wide = ExactRanges(("x",), {}, bits).of([(low, high)], TermReader({}).term([op, "x"]))
            narrow = scope.outward(check.OPERATIONS[op](scope, check.Interval(low, high)))
            assert wide is not None
            assert wide[0][0] <= narrow.low
            assert narrow.high <= wide[0][1]
            assert wide[0][1] - wide[0][0] <= narrow.high - narrow.low + Fraction(
                1, 2 ** (bits - 24)
            )
