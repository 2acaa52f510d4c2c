"""Random claims about functions on boxes, proved by slopes or enclosures, against 100 digits.

The checker alone decides: what it accepts holds at all points that are tried, by mpmath with 100
digits. The suite takes some claims; ``CLAIM_FIRST`` and ``CLAIM_ROUNDS`` choose others.
"""

from __future__ import annotations

import os
import random
from fractions import Fraction
from typing import Any

import mpmath
import pytest

from tests.check.support import BINARY, Pair, interval, verdict

Json = Any
FIRST = int(os.environ.get("CLAIM_FIRST", "0"))
ROUNDS = int(os.environ.get("CLAIM_ROUNDS", "400"))
DIGITS = 100
POINTS = 12
#: Of larger arguments these digits say nothing of a sine, and its reduction may take hours.
FAR = 10**60
ONE = ("exp", "log", "sin", "cos", "cos_pi", "atan", "sqrt", "neg")
BOUNDS = [(name, f"{name}-low", f"{name}-high") for name in "xy"]


class TooFarError(Exception):
    """A number that is not computed."""


class Claims:
    """One random difference on a random box, and a bound that is nearly its least value."""

    def __init__(self, seed: int) -> None:
        self.random = random.Random(seed)
        self.box = {name: self.ends() for name in "xy"}
        self.term = self.made(4)
        values = [self.at(point) for point in self.points()]
        real = [value for value in values if value is not None]
        self.least = min(real) if len(real) == len(values) else None

    def ends(self) -> tuple[Fraction, Fraction]:
        """An interval: short ones often, and far ones now and then."""
        r = self.random
        low = Fraction(r.randrange(-40, 41), r.choice((1, 2, 3, 8)))
        low *= r.choice((1, 1, 1, Fraction(1, 50), 10**6, 10**15))
        width = Fraction(r.randrange(1, 20), r.choice((10, 50, 1000, 10**9)))
        return low, low + width

    def made(self, depth: int) -> Json:
        """A term."""
        r = self.random
        if depth == 0 or r.random() < 0.1:
            number = f"{r.randrange(-9, 10)}" if r.random() < 0.5 else str(Fraction(1, 7))
            return r.choice(("x", "x", "y", number))
        a = self.made(depth - 1)
        match r.randrange(5):
            case 0 | 1:
                return [r.choice(ONE), a]
            case 2:
                op, index = r.choice((("pow", "2"), ("pow", "3"), ("root", "3"), ("root", "4")))
                return [op, a, index]
        return [r.choice([*BINARY.values()]), a, self.made(depth - 1)]

    def points(self) -> list[dict[str, Fraction]]:
        """The corners of the box, and points inside."""
        r = self.random
        corners = [{"x": x, "y": y} for x in self.box["x"] for y in self.box["y"]]
        inside = [
            {n: a + (b - a) * Fraction(r.randrange(1001), 1000) for n, (a, b) in self.box.items()}
            for _ in range(POINTS)
        ]
        return corners + inside

    def at(self, point: dict[str, Fraction]) -> Any:
        """The value at a point; None where there is none, infinity where it is not computed."""
        with mpmath.workdps(DIGITS):
            try:
                return value(self.term, point)
            except (ValueError, ZeroDivisionError, OverflowError):
                return None
            except TooFarError:
                return mpmath.inf

    def answer(self) -> tuple[str, bool]:
        """The checker's answer to a bound of the term, and whether that holds where it was tried.

        The bound is the least value that was seen, or a little more or less.
        """
        r = self.random
        if self.least is None or not mpmath.isfinite(self.least) or abs(self.least) > 1e20:
            bound = Fraction(r.randrange(-5, 6))
        else:
            off = Fraction(r.choice((-1, -1, -1, 0, 1)), 10 ** r.randrange(0, 12))
            bound = Fraction(int(mpmath.floor(self.least * 10**25)), 10**25) + off
        relation = r.choice(("<", "<="))
        givens = {
            f"{name}-{side}": ["<=", *pair]
            for name, (low, high) in self.box.items()
            for side, pair in (("low", (str(low), name)), ("high", (name, str(high))))
        }
        pair = Pair().context("c", {n: str(low) for n, (low, _) in self.box.items()}, givens)
        proof = {**interval(*BOUNDS, bits=r.choice((16, 32, 64))), "rule": "mean_value"}
        proof["at"] = {
            name: str(low + (high - low) * r.choice((0, Fraction(1, 2), 1)))
            for name, (low, high) in self.box.items()
            if occurs(name, self.term)
        }
        found = verdict(pair.row("row", [relation, str(bound), self.term], proof, "c"))
        if found != "proved":
            return found, True
        with mpmath.workdps(DIGITS):
            least = mpmath.mpf(bound.numerator) / bound.denominator
            least -= (1 + abs(least)) * mpmath.mpf(10) ** (20 - DIGITS)
            values = [self.at(point) for point in self.points() + self.points()]
            return found, all(v is not None and v >= least for v in values)


def occurs(name: str, term: Json) -> bool:
    """Whether a variable occurs in a term."""
    return term == name or (isinstance(term, list) and any(occurs(name, t) for t in term[1:]))


def value(term: Json, point: dict[str, Fraction]) -> Any:
    """The value of a term, by mpmath."""
    if isinstance(term, str):
        number = point.get(term)
        number = Fraction(term) if number is None else number
        return mpmath.mpf(number.numerator) / number.denominator
    op, *rest = term
    if op in ("pow", "root"):
        a, k = value(rest[0], point), int(rest[1])
        if op == "root" and a < 0:
            raise ValueError(op)
        return a**k if op == "pow" else mpmath.root(a, k)
    a, *others = (value(t, point) for t in rest)
    if (op == "log" and a <= 0) or (op == "sqrt" and a < 0):
        raise ValueError(op)
    if op == "exp" and abs(a) > 10**6:
        raise TooFarError
    if others:
        (b,) = others
        return {"add": a + b, "sub": a - b, "mul": a * b}[op] if op != "div" else a / b
    if op == "neg":
        return -a
    if op in ("sin", "cos", "cos_pi") and abs(a) > FAR:
        raise TooFarError
    return mpmath.cos(mpmath.pi * a) if op == "cos_pi" else getattr(mpmath, op)(a)


@pytest.mark.parametrize("first", range(FIRST, FIRST + ROUNDS, 100))
def test_random_claims(first: int) -> None:
    seeds = range(first, min(first + 100, FIRST + ROUNDS))
    answers = {seed: Claims(seed).answer() for seed in seeds}
    assert [seed for seed, (_, good) in answers.items() if not good] == []
    assert sum(found == "proved" for found, _ in answers.values()) >= len(seeds) // 20


def test_wrong_claims_are_seen() -> None:
    """With a value that is not that of the term, the test fails."""
    made = Claims(1)
    made.term, made.box, made.least = "x", {n: (Fraction(0), Fraction(1)) for n in "xy"}, None
    assert all(made.at(point) == mpmath.mpf(str(point["x"])) for point in made.points()[:4])
    for _ in range(20):
        assert made.answer()[1]
    made.at = lambda _: mpmath.mpf(-10)  # type: ignore[method-assign]
    assert not all(made.answer()[1] for _ in range(40))
