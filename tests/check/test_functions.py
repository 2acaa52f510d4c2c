"""Exponentials, logarithms, sines, inverse tangents and roots, against mpmath."""

from __future__ import annotations

import random
from collections.abc import Callable
from fractions import Fraction
from typing import Any

import mpmath
import pytest

from tests.check.support import INTERVAL, Pair, verdict
from tests.check.test_arithmetic import BITS, contains, enclose, enclosing, exact, number, width
from verify.check import Interval, Malformed, Refused

F = Fraction
#: Each function with what mpmath makes of it, and the exponents of 10 of its arguments.
FUNCTIONS: dict[str, tuple[Callable[[Any], Any], int, int]] = {
    "exp": (mpmath.exp, -30, 4),
    "log": (mpmath.log, -300, 300),
    "atan": (mpmath.atan, -40, 40),
    "sin": (mpmath.sin, -40, 20),
}


def samples(op: str, count: int) -> list[Fraction]:
    """Arguments decades apart, near 1 and at ends of pieces too; of both signs but for log."""
    _, low, high = FUNCTIONS[op]
    numbers = random.Random(f"functions {op}")
    found = [F(1), F(1, 256), F(2, 5), F(5, 2), F(2), 1 + F(1, 2**80), 1 - F(1, 2**80), F(255, 256)]
    for _ in range(count):
        size = F(numbers.randint(1, 10**12), numbers.randint(1, 10**12))
        found.append(size * F(10) ** numbers.randint(low, high - 1))
    found = [min(x, F(6 * 10**4)) for x in found] if op == "exp" else found
    return found if op == "log" else [x * numbers.choice((1, -1)) for x in found]


@pytest.mark.parametrize("bits", BITS)
@pytest.mark.parametrize("op", FUNCTIONS)
def test_values_lie_in_their_enclosures(op: str, bits: int) -> None:
    for x in samples(op, 40):
        found = getattr(enclosing(bits), op)(Interval(x, x))
        with mpmath.workprec(bits + 1500):
            value = exact(FUNCTIONS[op][0](number(str(x))))
        assert contains(found, value, abs(value) / 2 ** (bits + 200)), (op, x)


@pytest.mark.parametrize("op", ["exp", "log", "atan"])
def test_enclosures_are_as_narrow_as_their_bits(op: str) -> None:
    for bits in (16, 64, 300):
        for x in samples(op, 40):
            found = getattr(enclosing(bits), op)(Interval(x, x))
            assert width(found) <= abs(found.high) / 2 ** (bits - 2), (op, x)


@pytest.mark.parametrize("op", FUNCTIONS)
def test_boxes_contain_the_values_of_what_is_inside(op: str) -> None:
    numbers = random.Random("boxes")
    for x in samples(op, 30):
        y = x + abs(x) * F(numbers.randint(0, 10**6), 10 ** numbers.randint(3, 9))
        if op == "exp" and y > 65000:
            continue
        inner = x + (y - x) * F(numbers.randint(0, 1000), 1000)
        found = getattr(enclosing(64), op)(Interval(x, y))
        with mpmath.workprec(1500):
            value = exact(FUNCTIONS[op][0](number(str(inner))))
        assert contains(found, value, abs(value) / 2**200), (op, x, y)


def test_extremes_of_a_sine() -> None:
    """Between -pi/2 and pi/2 it rises; at a maximum inside it is 1, and no more."""
    scope = enclosing()
    assert scope.sin(Interval(F(1), F(2))).high == 1 > scope.sin(Interval(F(1), F(3, 2))).high
    assert scope.sin(Interval(F(4), F(5))).low == -1
    assert scope.sin(Interval(F(0), F(1))).low == 0
    assert scope.sin(Interval(F(0), F(7))) == (-1, 1)


@pytest.mark.parametrize("bits", BITS[1:])
def test_values_that_are_exact(bits: int) -> None:
    for text, value in [
        ("exp(0)", 1), ("log(1)", 0), ("sin(0)", 0), ("atan(0)", 0), ("root(0, 3)", 0),
        ("root(27, 3)", 3), ("root(32/243, 5)", F(2, 3)), ("root(1, 99)", 1), ("root(4, 2)", 2),
    ]:  # fmt: skip
        assert enclose(text, bits) == (value, value), text


@pytest.mark.parametrize("bits", BITS)
def test_roots(bits: int) -> None:
    numbers = random.Random("roots")
    for _ in range(60):
        k = numbers.choice((2, 3, 4, 5, 7, 10, 30))
        x = F(numbers.randint(1, 10**9), numbers.randint(1, 10**9)) * F(10) ** (
            numbers.randint(-20, 20)
        )
        low, high = enclosing(bits).root(Interval(x, x), k)
        assert low >= 0
        assert low**k <= x <= high**k, (k, x)
        assert high - low <= F(1, x.denominator * 2**bits)
    assert enclosing(bits).root(Interval(F(8), F(27)), 3) == (2, 3)


def test_what_is_not_defined_is_refused() -> None:
    for text in (
        "log(0)",
        "log(-1)",
        "root(-1, 3)",
        "exp(65537)",
        "exp(10**400)",
        "sin(1/(1 - 1))",
    ):
        with pytest.raises(Refused):
            enclose(text)
    with pytest.raises(Refused):
        enclosing().log(Interval(F(0), F(1)))
    with pytest.raises(Refused):
        enclosing().root(Interval(F(-1), F(1)), 3)


def test_exponentials_of_large_numbers() -> None:
    low, high = enclose("exp(-10**400)")
    assert low == 0 < high <= F(1, 2**65536)
    assert enclose("exp(-65536)").low > 0
    assert enclose("exp(65536)").low > 2**94547


def test_what_is_too_much_work_is_told_at_once() -> None:
    """The work is counted before it is done."""
    for text, bits in (("exp(1/3)", 65536), ("log(3)", 65536), ("atan(3)", 65536)):
        with pytest.raises(Malformed, match="work"):
            enclose(text, bits)
    with pytest.raises(Malformed, match="bits"):
        enclose("root(3**400, 99)", 20000)


@pytest.mark.parametrize(
    ("claim", "found"),
    [
        ("exp(1) < 2718281828459045236/1000000000000000000", "proved"),
        ("2718281828459045235/1000000000000000000 < exp(1)", "proved"),
        ("exp(1) < 2718281828459045235/1000000000000000000", "REFUSED"),
        ("pi() < 3141592653589793239/1000000000000000000", "proved"),
        ("pi() < 3141592653589793238/1000000000000000000", "REFUSED"),
        ("exp(0) = 1", "proved"),
        ("exp(0) = 0", "REFUSED"),
        ("log(1) = 0", "proved"),
        ("0 < log(1)", "REFUSED"),
        ("sin(0) = 0", "proved"),
        ("atan(0) = 0", "proved"),
        ("0 < atan(0)", "REFUSED"),
        ("root(27, 3) = 3", "proved"),
        ("root(27, 4) = 3", "REFUSED"),
        ("log(2) < 6931471805599453095/10000000000000000000", "proved"),
        ("log(2) < 6931471805599453094/10000000000000000000", "REFUSED"),
        ("4*atan(1/5) - atan(1/239) <= pi()/4", "REFUSED"),
        ("exp(pi()*sqrt(163)) < 262537412640768744", "REFUSED"),
        ("root(2, 3) < 1259921049894873165/1000000000000000000", "proved"),
        ("sin(355) < 0", "proved"),
        ("0 < sin(355)", "REFUSED"),
    ],
)
def test_claims_by_intervals(claim: str, found: str) -> None:
    assert found in verdict(Pair().row("row", claim, INTERVAL))


def test_the_number_of_ramanujan() -> None:
    claim = "exp(pi()*sqrt(163)) < 262537412640768744"
    proof = {**INTERVAL, "bits": 128}
    assert verdict(Pair().row("row", claim, proof)) == "proved"


def test_a_root_has_no_integer_above_it() -> None:
    scope = enclosing()
    for k in (2, 3, 7, 99):
        for n in [*range(40), 2**99, 2**99 - 1, 3**99, 3**99 - 1, 10**40]:
            root = scope.whole_root(n, k)
            assert root**k <= n < (root + 1) ** k
