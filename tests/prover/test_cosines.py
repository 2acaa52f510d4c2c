"""Claims with cosines of variables, many of which hold with equality somewhere: found, checked."""

from __future__ import annotations

from typing import Any

import pytest

from tests.check.support import term
from verify import check
from verify.measure.inequalities import question
from verify.prover.prove import prove
from verify.wire.write import write

LINE = (None, None)


def verdict(claim: str, **ranges: tuple[str | None, str | None]) -> str:
    """What the checker says of what is found; REFUSED if nothing is."""
    entry: dict[str, Any] = {"name": "T", "claim": term(claim), "variables": ranges}
    files = write(prove(question(entry)))
    return check.check(files["statement.json"], files["certificate.json"], {}).verdict


@pytest.mark.parametrize(
    "claim",
    [
        "cos(2*x) = 2*cos(x)**2 - 1",
        "cos(3*x) = 4*cos(x)**3 - 3*cos(x)",
        "cos(0 - x) = cos(x)",
        "cos_pi(x + 1) + cos_pi(x) = 0",
        "cos_pi(x + 2) = cos_pi(x)",
        "cos_pi(5 - x) = 0 - cos_pi(x)",
        "cos_pi(1/2 - x)**2 + cos_pi(x)**2 = 1",
        "cos(x)**2 <= 1",
        "0 - 1 <= cos(x)",
        "cos(x) <= 1",
        "0 <= 1 + cos_pi(3*x - 1)",
        "1 - x**2/2 <= cos(x)",
        "cos(x) <= 1 - x**2/2 + x**4/24",
        "1 - x**2/2 + x**4/24 - x**6/720 <= cos(x)",
    ],
)
def test_on_the_line(claim: str) -> None:
    assert verdict(claim, x=LINE) == "PROVED"


@pytest.mark.parametrize(
    ("claim", "low", "high"),
    [
        ("1 - 2*x < cos_pi(x)", "0", "1/2"),
        ("cos_pi(x) < 1 - 2*x", "1/2", "1"),
        ("2*x <= cos_pi(1/2 - x)", "0", "1/2"),
        ("cos_pi(1/2 - x) <= 22/7*x", "0", "1"),
        ("1 - x**2/2 < cos(x)", "0", "1"),
        ("cos_pi(x) <= 1 - (x - 2)**2", "3/2", "5/2"),
        ("x*cos(x) <= x", "0", "3"),
        ("0 < cos_pi(x)", "-1/2", "1/2"),
        ("sqrt(3)/2 <= cos_pi(x)", "0", "1/6"),
        ("cos_pi(x) < 1/2", "1/3", "1"),
        ("cos_pi(1/3) <= cos_pi(x)", "0", "1/3"),
    ],
)
def test_on_an_interval(claim: str, low: str, high: str) -> None:
    assert verdict(claim, x=(low, high)) == "PROVED"


@pytest.mark.parametrize(
    "claim",
    [
        "cos(x + y) + cos(x - y) = 2*cos(x)*cos(y)",
        "cos(x)*cos(y) <= 1",
        "cos(x*y) <= 1",
        "0 <= 20 + x**2 + y**2 - 10*cos_pi(2*x) - 10*cos_pi(2*y)",
    ],
)
def test_in_the_plane(claim: str) -> None:
    assert verdict(claim, x=LINE, y=LINE) == "PROVED"


@pytest.mark.parametrize(
    ("claim", "low", "high"),
    [
        ("cos(x) <= 1 - x**2/2", "0", "1"),
        ("cos_pi(x) <= 1 - 2*x", "0", "1/2"),
        ("cos(2*x) <= 2*cos(x)**2 - 101/100", "0", "1"),
        ("1/2 < cos_pi(x)", "0", "34/100"),
    ],
)
def test_false(claim: str, low: str, high: str) -> None:
    assert verdict(claim, x=(low, high)) == "REFUTED"


@pytest.mark.parametrize(
    "claim", ["cos(2*x) < 2*cos(x)**2 - 1", "4*cos(x)**3 - 3*cos(x) < cos(3*x)"]
)
def test_equal_sides_of_which_none_is_less(claim: str) -> None:
    """No cosine is left when the sides are compared; the search ends nevertheless."""
    assert verdict(claim, x=("-1", "1")) in ("REFUSED", "REFUTED")
