"""The enclosures contain the roots computed by mpmath at a much higher precision."""

from __future__ import annotations

import random
from fractions import Fraction

import mpmath
import pytest
from hypothesis import given
from hypothesis import strategies as st

from tests.paper.spectrum.page import table, terms
from verify.paper.commands import eigenvalues
from verify.paper.commands.eigenvalues import Spectrum, at, over
from verify.prover import balls
from verify.prover.balls import Ball
from verify.prover.program import ExactArithmetic, Machine, Program

HARD = [
    Fraction(1, 20),
    Fraction(1, 5),
    Fraction(5, 51),
    Fraction(1, 10**50),
    1 - Fraction(1, 10**30),
    1 - Fraction(1, 10**100),
    Fraction(1, 10**400),
    # Next to 7 - 4 sqrt(3), where the real part of the pair vanishes.
    Fraction("0.07179676972449082589"),
    Fraction(2, 3),
    Fraction(1, 10**30),
    Fraction(1, 1000),
]


def contains(ball: Ball, value: mpmath.mpf) -> bool:
    with balls.precision(mpmath.mp.prec):
        low, high = balls.ends(ball)
    slack = mpmath.mpf(2) ** (8 - mpmath.mp.prec) * (1 + abs(value))
    return bool(to_mp(low) - slack <= value <= to_mp(high) + slack)


def to_mp(value: Fraction) -> mpmath.mpf:
    return mpmath.mpf(value.numerator) / value.denominator


def exact(term: object, r: Fraction) -> Fraction:
    program = Program(["r"])
    slot = program.add(term)  # type: ignore[arg-type]
    value = Machine(program, ExactArithmetic()).run([r]).values[slot]
    assert isinstance(value, Fraction)
    return value


def check(found: Spectrum, r: Fraction, bits: int) -> None:
    """Compare with the roots of the printed Q and with the printed matrix."""
    size = bits + 64 + 4 * r.denominator.bit_length()
    with mpmath.workprec(size):
        a_0, a_1, a_2 = (to_mp(exact(entry, r)) for entry in terms("r^3", "a_1(r)", "a_2(r)"))
        roots = mpmath.polyroots([1, a_2, a_1, a_0], maxsteps=2000, extraprec=2 * size)
        real = min(roots, key=lambda z: abs(mpmath.im(z)))
        pair = max(roots, key=mpmath.im)
        assert contains(found.lambda_0, mpmath.re(real))
        assert contains(found.plus.real, mpmath.re(pair))
        assert contains(found.plus.imaginary, mpmath.im(pair))
        assert contains(found.modulus, abs(pair))
        assert contains(found.argument, mpmath.arg(pair))
    assert all(balls.accuracy_bits(ball) >= bits for ball in found.parts)


def check_vectors(found: Spectrum, r: Fraction, bits: int) -> None:
    """The balls of A v - lambda v contain 0; lambda and v have their own narrow balls."""
    with balls.precision(2 * bits + r.denominator.bit_length()):
        program = Program(["r"])
        slots = [[program.add(entry) for entry in row] for row in table("A(r)")]
        values = Machine(program, balls.BallArithmetic()).run([balls.from_fraction(r)]).values
        matrix = [[values[slot] for slot in row] for row in slots]
        for i in range(4):
            image = sum(
                (matrix[i][j] * found.vector_0[j] for j in range(4)), start=0 * matrix[0][0]
            )
            assert (image - found.lambda_0 * found.vector_0[i]).contains(0)
            v, (x, y) = found.vector_plus, found.plus
            re = sum((matrix[i][j] * v[j].real for j in range(4)), start=0 * matrix[0][0])
            im = sum((matrix[i][j] * v[j].imaginary for j in range(4)), start=0 * matrix[0][0])
            assert (re - (x * v[i].real - y * v[i].imaginary)).contains(0)
            assert (im - (x * v[i].imaginary + y * v[i].real)).contains(0)


@pytest.mark.parametrize("r", HARD, ids=lambda r: f"{r}"[:24])
@pytest.mark.parametrize("bits", [64, 128, 500])
def test_hard_cases(r: Fraction, bits: int) -> None:
    found = at(r, bits)
    check(found, r, bits)
    check_vectors(found, r, bits)


def test_random_values_of_r() -> None:
    chance = random.Random(20240607)
    for _ in range(60):
        r = Fraction(chance.randrange(1, 10**9), 10**9)
        found = at(r, 128)
        check(found, r, 128)
        check_vectors(found, r, 128)


@given(st.fractions(min_value=Fraction(1, 10**6), max_value=1 - Fraction(1, 10**6)))
def test_the_modulus_statements(r: Fraction) -> None:
    found = at(r, 128)
    with balls.precision(160):
        low, high = balls.ends(found.lambda_0)
    assert -1 < -r < low <= high < -(r**3) < 0
    assert -low < balls.ends(found.modulus)[0] <= balls.ends(found.modulus)[1] < 1


@pytest.mark.parametrize(
    ("r", "root"),
    [("1/20", "-1/125"), ("1/5", "-1/8"), ("5/51", "-1/27"), ("3/100", None), ("1/2", None)],
)
def test_rational_roots(r: str, root: str | None) -> None:
    found = at(Fraction(r), 128)
    assert found.exact == (None if root is None else Fraction(root))
    if root is not None:
        low, high = balls.ends(found.lambda_0)
        assert low <= Fraction(root) <= high


@given(st.fractions(min_value=0, max_value=1).filter(lambda m: 0 < m < 1))
def test_every_rational_root_is_found(m: Fraction) -> None:
    r = m * (4 * m**2 - m + 1) / (m**2 - m + 4)
    assert at(r, 64).exact == -(m**3)


def test_close_to_a_rational_root_is_not_one() -> None:
    assert at(Fraction(1, 20) + Fraction(1, 10**60), 64).exact is None


def test_three_moduli_next_to_one_are_told_apart() -> None:
    found = at(1 - Fraction(1, 10**30), 128)
    with balls.precision(160):
        real, pair = balls.ends(-found.lambda_0), balls.ends(found.modulus)
    assert real[1] < pair[0] <= pair[1] < 1


@pytest.mark.parametrize(
    ("low", "high"),
    [("0.02", "0.04"), ("0.0001", "0.9999"), ("0.5", "0.5000001"), ("1e-40", "1e-3")],
)
def test_an_interval_covers_its_points(low: str, high: str) -> None:
    first, last = Fraction(low), Fraction(high)
    whole = over(first, last, 128).parts
    for i in range(41):
        parts = at(first + (last - first) * i / 40, 128).parts
        for big, small in zip(whole, parts, strict=True):
            (a, b), (c, d) = balls.ends(big), balls.ends(small)
            assert a <= d
            assert c <= b
            if 0 < i < 40:
                assert a <= c
                assert d <= b


def test_an_interval_is_not_much_wider_than_needed() -> None:
    first, last = Fraction("0.02"), Fraction("0.04")
    whole = over(first, last, 128)
    low, high = balls.ends(whole.lambda_0)
    ends = balls.ends(at(first, 128).lambda_0)[0], balls.ends(at(last, 128).lambda_0)[0]
    assert high - low < (ends[0] - ends[1]) * Fraction(101, 100)
    low, high = balls.ends(whole.plus.real)
    assert high - low < Fraction(3, 100)


def test_a_wrong_estimate_is_never_believed(monkeypatch: pytest.MonkeyPatch) -> None:
    def wrong(_r: Fraction, _ball: Ball) -> Ball:
        return balls.from_fraction(Fraction(1, 3))

    monkeypatch.setattr(eigenvalues, "_estimate", wrong)
    with pytest.raises(ArithmeticError, match="too far off"):
        at(Fraction(1, 20), 128)
