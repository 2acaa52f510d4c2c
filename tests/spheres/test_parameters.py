"""Which parameters the program takes."""

from __future__ import annotations

from fractions import Fraction

import pytest

from tests.points import parameters
from verify.language.terms import Term, as_term, cos, cos_pi, symbol
from verify.spheres.parameters import are_allowed, is_obtuse

HONEST = parameters("3/100", "1")


@pytest.mark.parametrize(
    "c",
    [
        as_term(1),
        as_term(Fraction(1, 10**30)),
        -cos_pi(Fraction(1)),
        -cos_pi(Fraction(501, 1000)),
        -cos(Fraction(22, 7) - Fraction(1, 100)),
        -cos(Fraction("1.5708")),
    ],
)
def test_allowed(c: Term) -> None:
    assert are_allowed(HONEST | {"c": c})


@pytest.mark.parametrize(
    ("name", "value"),
    [
        ("r", as_term(0)),
        ("r", as_term(1)),
        ("r", -as_term(Fraction(1, 2))),
        ("r", as_term(1) / 2),
        ("V_0", as_term(0)),
        ("V_0", 2 * cos_pi(Fraction(1, 3))),
        ("delta_theta", as_term(-1)),
        ("delta_theta", as_term(1) / 0),
        ("c", as_term(0)),
        ("c", as_term(2)),
        ("c", cos_pi(Fraction(1, 3))),
        ("c", -cos_pi(Fraction(1, 2))),
        ("c", -cos_pi(Fraction(11, 10))),
        ("c", -cos(Fraction("1.5707"))),
        ("c", -cos(Fraction(22, 7))),
        ("c", -cos(as_term(3) / 1)),
        ("c", Term("neg", -cos(Fraction(3)))),
        ("c", symbol("t.1")),
    ],
)
def test_not_allowed(name: str, value: Term) -> None:
    assert not are_allowed(HONEST | {name: value})


def test_a_parameter_more_or_less() -> None:
    assert not are_allowed(HONEST | {"x": as_term(1)})
    assert not are_allowed({name: term for name, term in HONEST.items() if name != "V_0"})
    assert not are_allowed({})


def test_obtuse_angles_next_to_the_ends() -> None:
    """With 60 digits of pi, one unit in the last place to either side."""
    pi = Fraction("3.14159265358979323846264338327950288419716939937510582097494")
    unit = Fraction(1, 10**59)
    assert is_obtuse(pi)
    assert not is_obtuse(pi + unit)
    assert is_obtuse(pi / 2 + unit)
    assert not is_obtuse(pi / 2)
    assert not is_obtuse(Fraction(-3))
    assert not is_obtuse(Fraction(10**3000))
