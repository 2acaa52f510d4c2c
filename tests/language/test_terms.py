"""The language of the paper room refuses what is not exact or not a claim."""

from __future__ import annotations

import pytest

from verify.language.terms import as_term, names_of, substitute, symbol

x, y = symbol("x"), symbol("y")


def test_a_float_is_refused_with_what_to_write_instead() -> None:
    with pytest.raises(TypeError, match="write a fraction"):
        x + 0.5  # type: ignore[operator]
    with pytest.raises(TypeError, match="exact"):
        as_term("1/2")  # type: ignore[arg-type]
    with pytest.raises(TypeError, match="exact"):
        as_term(True)


def test_terms_and_claims_have_no_truth_value() -> None:
    with pytest.raises(TypeError, match="truth value"):
        bool(x)
    with pytest.raises(TypeError, match="truth value"):
        bool(x < y)
    with pytest.raises(TypeError, match="truth value"):
        0 < x < y  # noqa: B015


@pytest.mark.parametrize("exponent", [0, -1, 0.5, True])
def test_a_power_needs_a_positive_integer(exponent: object) -> None:
    with pytest.raises(TypeError, match="positive integer"):
        x**exponent  # type: ignore[operator]


def test_equality_is_how_a_term_is_written() -> None:
    assert x + y == x + y
    assert x + y != y + x
    assert len({x * 2, x * 2, 2 * x}) == 2


def test_substitution_replaces_every_occurrence() -> None:
    term = x**2 + y / x
    assert substitute(term, {"x": y}) == y**2 + y / y
    assert substitute(term, {"x": y, "y": x}) == y**2 + x / y
    assert set(names_of(term)) == {"x", "y"}
