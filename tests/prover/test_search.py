"""The search for claims about all values: each technique, and random claims with known truth.

Whatever is decided is written down and accepted by the checker. Random claims are true because of
how they are made (a sum of squares, a product of factors of known sign), some of them with equality
somewhere; what is false has a point that says so.
"""

from __future__ import annotations

import os
import random
import time
from collections.abc import Mapping
from fractions import Fraction
from typing import Any

import pytest

from verify import check
from verify.language.statement import (
    NEEDED,
    PROVED,
    REFUTED,
    UNDECIDED,
    Context,
    Given,
    Obligation,
    Statement,
    Variable,
)
from verify.language.terms import (
    Claim,
    Term,
    as_term,
    cos_pi,
    equal,
    maximum,
    minimum,
    sqrt,
    symbol,
)
from verify.paper.commands.spectrum import state_spectrum
from verify.prover.budget import WorkBudget
from verify.prover.outcome import Outcome
from verify.prover.prove import prove
from verify.prover.search.local_minima import Minima
from verify.wire.write import write

FIRST = int(os.environ.get("SEARCH_FIRST", "0"))
ROUNDS = int(os.environ.get("SEARCH_ROUNDS", "40"))

x, y, z = (symbol(name) for name in "xyz")
Ranges = Mapping[str, tuple[int | Fraction | None, int | Fraction | None]]


def asked(claim: Claim, ranges: Ranges) -> Statement:
    givens, point = [], {}
    for name, (low, high) in ranges.items():
        if low is not None:
            givens.append(Given(f"{name}.low", as_term(low) < symbol(name)))
        if high is not None:
            givens.append(Given(f"{name}.high", symbol(name) < as_term(high)))
        least = Fraction(high - 2 if low is None and high is not None else low or 0)
        point[name] = as_term((least + (least + 2 if high is None else high)) / 2)
    variables = tuple(Variable(name, name, name) for name in ranges)
    context = Context("all", variables, tuple(givens), point)
    row = Obligation("row", "", "", NEEDED, "", claim, context="all")
    return Statement("test", "test", {}, (), (context,), (row,), ())


def judged(claim: Claim, ranges: Ranges, work: int = 20_000_000) -> Outcome:
    """The outcome, which the checker accepts if it is decided."""
    outcome = prove(asked(claim, ranges), budget=WorkBudget(work))
    if outcome.claimed != UNDECIDED:
        files = write(outcome)
        report = check.check(files["statement.json"], files["certificate.json"], {})
        assert report.verdict == outcome.claimed.upper(), report.lines
    return outcome


EVERYWHERE = (None, None)
POSITIVE = (0, None)
UNIT = (0, 1)
BOX = (-2, 2)


@pytest.mark.parametrize(
    ("claim", "ranges"),
    [
        # squares, with zeros inside, on lines, and nowhere
        (
            0 <= x**4 + y**4 + z**4 + 1 - 4 * x * y * z,
            {"x": EVERYWHERE, "y": EVERYWHERE, "z": EVERYWHERE},
        ),
        (x * y <= (x**2 + y**2) / 2, {"x": EVERYWHERE, "y": EVERYWHERE}),
        (0 <= (x**2 - 2) ** 2, {"x": (0, 3)}),
        (0 <= x**4 * y**2 + x**2 * y**4 + 1 - 3 * x**2 * y**2, {"x": EVERYWHERE, "y": EVERYWHERE}),
        # squares times facts
        (x + y - 1 <= x * y, {"x": (1, None), "y": (1, None)}),
        (3 * x <= x**3 + 2, {"x": POSITIVE}),
        (2 <= x + 1 / x, {"x": POSITIVE}),
        (sqrt(x * y) <= (x + y) / 2, {"x": POSITIVE, "y": POSITIVE}),
        (sqrt(1 + x) <= 1 + x / 2, {"x": (-1, None)}),
        # zeros that lie on the faces between boxes
        (0 <= x**2 * (1 - x**2), {"x": (-1, 1)}),
        (0 <= (x**2 + y**2) * (5 - x * y), {"x": BOX, "y": BOX}),
        # minima and maxima
        (
            maximum(x - z, z - x) <= maximum(x - y, y - x) + maximum(y - z, z - y),
            {"x": EVERYWHERE, "y": EVERYWHERE, "z": EVERYWHERE},
        ),
        (minimum(x, y) ** 2 <= x * y, {"x": POSITIVE, "y": POSITIVE}),
        (0 <= maximum(x * x + y * y - 1, 1 - x * y), {"x": EVERYWHERE, "y": EVERYWHERE}),
        # by the order of the variables
        (
            0 <= x * (x - y) * (x - z) + y * (y - x) * (y - z) + z * (z - x) * (z - y),
            {"x": POSITIVE, "y": POSITIVE, "z": POSITIVE},
        ),
        # parts with variables of their own
        (
            (cos_pi(3 * x) + cos_pi(5 * x + 1)) * (cos_pi(y) - cos_pi(2 * y + 1)) < as_term(5),
            {"x": (-3, 3), "y": (-3, 3)},
        ),
        # trees
        (0 <= 20 + x**2 + y**2 - 10 * cos_pi(2 * x) - 10 * cos_pi(2 * y), {"x": BOX, "y": BOX}),
        (x / (1 + x * x) < as_term(Fraction(51, 100)), {"x": (-5, 5)}),
        (x - 2 * x * x < sqrt(x), {"x": UNIT}),
        # the ends of variables
        (x * y * z + x + y + z < as_term(4), {"x": UNIT, "y": UNIT, "z": UNIT}),
        (0 < 3 - x**2 - y**2 - z**2, {"x": UNIT, "y": UNIT, "z": UNIT}),
    ],
)
def test_true(claim: Claim, ranges: Ranges) -> None:
    assert judged(claim, ranges).claimed == PROVED


@pytest.mark.parametrize(
    ("claim", "ranges"),
    [
        (0 < x**2 * (1 - x**2), {"x": (-1, 1)}),  # the zero is no end of the box
        (0 < (2 * x - y) ** 2, {"x": BOX, "y": BOX}),
        (x**2 * y**2 < x**4 + y**4, {"x": EVERYWHERE, "y": EVERYWHERE}),
        (as_term(Fraction(1, 10**6)) <= (3 * x - 1) ** 2, {"x": UNIT}),
        (sqrt(x) <= x, {"x": (0, 2)}),
        (maximum(x, y) <= x + y, {"x": (-1, 1), "y": (-1, 1)}),
        (x < as_term(1 - Fraction(1, 10**12)), {"x": UNIT}),  # only next to an end
        (cos_pi(x) < as_term(Fraction(99999, 100000)), {"x": (-1, 1)}),
    ],
)
def test_false(claim: Claim, ranges: Ranges) -> None:
    outcome = judged(claim, ranges)
    assert outcome.claimed == REFUTED
    assert outcome.decisions["row"].witness


@pytest.mark.parametrize(
    ("claim", "ranges"),
    [
        (0 < x, {"x": (-1, 1)}),
        (0 <= x * y, {"x": BOX, "y": BOX}),
        (x < x, {"x": EVERYWHERE}),
        (0 < x * (1 - x) - Fraction(1, 4), {"x": UNIT}),
    ],
)
def test_nothing_false_is_proved(claim: Claim, ranges: Ranges) -> None:
    assert judged(claim, ranges).claimed != PROVED


def test_what_is_false_at_a_simple_point_needs_no_minimum(monkeypatch: pytest.MonkeyPatch) -> None:
    """The three rows of the spectrum that are false were searched for their minima first."""

    search = Minima.found

    def found(self: Minima) -> Any:
        if type(self) is Minima:  # not where givens are violated least, which is quick
            raise AssertionError("a search for minima")
        return search(self)

    monkeypatch.setattr(Minima, "found", found)
    outcome = prove(state_spectrum(), max_bits=1024)
    assert [row.name for row, found in outcome.rows if found.claimed == REFUTED]
    undecided = [row.name for row, found in outcome.rows if found.claimed == UNDECIDED]
    assert undecided == ["existence-cited"]  # what is cited is not known to this search


def test_little_work_leaves_a_row_undecided() -> None:
    claim = 0 <= x**4 + y**4 + z**4 + 1 - 4 * x * y * z
    ranges = dict.fromkeys("xyz", EVERYWHERE)
    assert judged(claim, ranges, work=10).claimed == UNDECIDED


def test_what_is_long_when_expanded_is_left_undecided() -> None:
    total = as_term(1)
    for name in "abcdef":
        total = total + symbol(name)
    claim = equal(total**24, total**12 * total**12)
    start = time.process_time()
    found = judged(claim, dict.fromkeys("abcdef", EVERYWHERE))
    assert found.claimed == UNDECIDED
    assert time.process_time() - start < 5


def test_no_row_is_begun_when_the_time_is_over() -> None:
    statement = asked(as_term(0) <= x**2 - 2 * x * y + y**2, dict.fromkeys("xy", EVERYWHERE))
    assert prove(statement, budget=WorkBudget(seconds=60)).claimed == PROVED
    late = prove(statement, budget=WorkBudget(seconds=0))
    assert late.claimed == UNDECIDED
    assert "the time is over" in late.spent + late.decisions["row"].reason
    ground = statement._replace(
        contexts=(), obligations=(Obligation("one", "", "", NEEDED, "", as_term(0) <= as_term(1)),)
    )
    assert prove(ground, budget=WorkBudget(seconds=0)).claimed == UNDECIDED


def test_the_files_are_the_same_each_time() -> None:
    claim, ranges = 3 * x <= x**3 + 2, {"x": POSITIVE}
    first, second = (write(judged(claim, ranges)) for _ in range(2))
    assert first == second


# --- random claims -------------------------------------------------------------------------------


class Maker:
    """Random polynomials of small degree and known sign."""

    def __init__(self, seed: int) -> None:
        self.random = random.Random(seed)
        self.names = [x, y, z][: self.random.choice((1, 1, 2, 2, 3))]

    def number(self) -> Fraction:
        return Fraction(self.random.randrange(-6, 7), self.random.choice((1, 1, 2, 3, 7)))

    def linear(self) -> Term:
        total = as_term(self.number())
        for name in self.names:
            total = total + self.number() * name
        return total

    def claim(self) -> tuple[Claim, Ranges, bool]:
        """A claim, its ranges, and whether it is true."""
        r = self.random
        box = r.random() < 0.6
        ranges: Ranges = {
            name.name: (-1, r.choice((1, 2))) if box else EVERYWHERE for name in self.names
        }
        total: Term = as_term(0)
        for _ in range(r.randrange(1, 3)):
            first = self.linear()
            square = (first * self.linear() if r.random() < 0.3 else first) ** 2
            total = total + square
        kind = r.randrange(4)
        if kind == 0:  # true: not negative, with zeros or without
            return as_term(0) <= total, ranges, True
        if kind == 1:
            return as_term(0) < total + Fraction(1, r.choice((2, 100, 10**4))), ranges, True
        at = {name: Fraction(r.randrange(-9, 10), 10) for name in self.names}
        value = at_point(total, at)
        if kind == 2:  # false at a point, by little
            return (
                total.__lt__(as_term(0)) if value > 0 else as_term(0) < total - total,
                ranges,
                False,
            )
        return as_term(value + Fraction(1, 10**5)) <= total, ranges, False


def at_point(term: Term, at: Mapping[Term, Fraction]) -> Fraction:
    if term.op == "rational":
        return term.value
    if term.op == "symbol":
        return at[term]
    a, *others = (at_point(child, at) for child in term.children)
    if term.op == "pow":
        return a**term.exponent
    b = others[0]
    return {"add": a + b, "sub": a - b, "mul": a * b}[term.op]


def test_random_claims() -> None:
    decided = 0
    for seed in range(FIRST, FIRST + ROUNDS):
        claim, ranges, truth = Maker(seed).claim()
        verdict = judged(claim, ranges).claimed
        assert verdict in (UNDECIDED, PROVED if truth else REFUTED), (seed, claim)
        decided += verdict != UNDECIDED
    assert decided >= ROUNDS * 9 // 10
