"""``angles``: 2 cos u cos v = cos (u + v) + cos (u - v)."""

from __future__ import annotations

import pytest

from tests.check.support import ANGLES, INTERVAL, Pair, box, cuts, ground, term, verdict

WRONG = "angles that differ"


@pytest.mark.parametrize(
    ("claim", "reason"),
    [
        ("2*(cos(x)*cos(y)) = cos(x + y) + cos(x - y)", "proved"),
        ("2*(cos(x)*cos(y)) = cos(y + x) + cos(x - y)", "proved"),
        ("2*(cos_pi(x)*cos_pi(x)) = cos_pi(2*x) + cos_pi(0)", "proved"),
        ("2*(cos_pi(1/7)*cos_pi(2/7)) = cos_pi(3/7) + cos_pi(-1/7)", "proved"),
        ("2*(cos(x/(1 + p))*cos(y)) = cos(y + x/(1 + p)) + cos((x - y - p*y)/(1 + p))", "proved"),
        ("2*(cos(sqrt(p))*cos(y)) = cos(sqrt(p) + y) + cos(p/sqrt(p) - y)", "REFUSED"),
        ("2*(cos(sqrt(p)**2)*cos(y)) = cos(p + y) + cos(p - y)", "proved"),
        ("2*(cos(x)*cos(y)) = cos(x + y) + cos(y - x)", WRONG),
        ("2*(cos(x)*cos(y)) = cos(x - y) + cos(x + y)", WRONG),
        ("2*(cos(x)*cos(y)) = cos(x + y) + cos(x - x)", WRONG),
        ("2*(cos(x)*cos(y)) = cos(x + x) + cos(x - y)", WRONG),
        ("2*(cos_pi(1/7)*cos_pi(2/7)) = cos_pi(3/7) + cos_pi(1/7)", WRONG),
        ("1*(cos(x)*cos(y)) = cos(x + y) + cos(x - y)", "expected 2 cos u cos v"),
        ("-2*(cos(x)*cos(y)) = cos(x + y) + cos(x - y)", "expected 2 cos u cos v"),
        ("2*(cos(x)*cos(y)) <= cos(x + y) + cos(x - y)", "expected 2 cos u cos v"),
        ("2*(cos(x)*cos(y)) < cos(x + y) + cos(x - y)", "expected 2 cos u cos v"),
        ("2*(cos(x)*cos(y)) = cos(x + y) - cos(x - y)", "found sub, expected add"),
        ("2*(cos(x) + cos(y)) = cos(x + y) + cos(x - y)", "found add, expected mul"),
        ("2*cos(x)*cos(y) = cos(x + y) + cos(x - y)", "expected 2 cos u cos v"),
        ("2*(cos(x)*cos(y)) = cos_pi(x + y) + cos_pi(x - y)", "found cos, expected cos_pi"),
        ("2*(cos(x)*cos(y)) = cos(x + y) + cos_pi(x - y)", "found cos_pi, expected cos"),
        ("2*(cos(x)*cos_pi(y)) = cos(x + y) + cos(x - y)", "found cos_pi, expected cos"),
        ("2*(sqrt(p)*sqrt(p)) = sqrt(p + p) + sqrt(p - p)", "found sqrt, expected a cosine"),
        ("2*(cos(x)*cos(y)) = x + y", "found name, expected a cosine"),
        ("cos(x) = cos(x)", "found cos, expected mul"),
        ("2*(cos(1/x)*cos(1/x)) = cos(2/x) + cos(0)", "a division by a term"),
        ("2*(cos(sqrt(x))*cos(0)) = cos(sqrt(x)) + cos(sqrt(x))", "the root of a term"),
    ],
)
def test_angles(claim: str, reason: str) -> None:
    """A division inside the angles needs a positive divisor, as everywhere."""
    pair = Pair().context(
        "c", {"x": "0", "y": "1", "p": "2"}, {"p-pos": "0 < p", "q-pos": "0 < 1 + p"}
    )
    assert reason in verdict(pair.row("row", claim, ANGLES, "c"))


def test_without_variables() -> None:
    claim = "2*(cos_pi(1)*cos_pi(1)) = cos_pi(2) + cos_pi(0)"
    assert ground(claim, ANGLES) == "proved"


def test_a_constant_needs_its_definition() -> None:
    pair = Pair().step(
        lemma="l", context=None, claim=term("2*(cos(m)*cos(m)) = cos(2*m) + cos(0)"), proof=ANGLES
    )
    pair.constant("m", "1", INTERVAL).row("row", "0 < m", INTERVAL)
    assert "before its definition" in verdict(pair)


def test_hypotheses_do_not_change_angles() -> None:
    """That x = 0 in a branch is no identity."""
    claim = "2*(cos(x)*cos(x)) = cos(0) + cos(0)"
    proof = cuts("x", ["0"], ANGLES, ANGLES)
    assert WRONG in verdict(box(("0", "0")).row("row", claim, proof, "box"))
