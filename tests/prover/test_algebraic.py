"""Equality of nested roots and of cosines of rational multiples of pi: found, and checked."""

from __future__ import annotations

import pytest

from tests.check.support import term
from verify import check
from verify.language.statement import NEEDED, Obligation, Statement
from verify.prover.prove import prove
from verify.wire.term_json import TermReader
from verify.wire.write import write


def verdict(text: str) -> str:
    """What the checker says of what is found; REFUSED if nothing is."""
    claim = TermReader({}).comparison(term(text))
    row = Obligation("row", "", "", NEEDED, "", claim)
    files = write(prove(Statement("T", "T", {}, (), (), (row,), ())))
    return check.check(files["statement.json"], files["certificate.json"], {}).verdict


ROOTS = "sqrt(17 + 3*sqrt(17) - sqrt(34 - 2*sqrt(17)) - 2*sqrt(34 + 2*sqrt(17)))"


@pytest.mark.parametrize(
    "claim",
    [
        "sqrt(5 + 2*sqrt(6)) = sqrt(2) + sqrt(3)",
        "sqrt(3 + 2*sqrt(2)) <= 1 + sqrt(2)",
        "sqrt(6) = sqrt(2)*sqrt(3)",
        "sqrt(4 + sqrt(15)) = (sqrt(10) + sqrt(6))/2",
        "1/(sqrt(2) + sqrt(3)) + 1/(sqrt(3) + sqrt(4)) = 2 - sqrt(2)",
        "sqrt(26 + 15*sqrt(3)) = (3*sqrt(3) + 5)/sqrt(2)",
        "cos_pi(1/5) = (1 + sqrt(5))/4",
        "cos_pi(0 - 2/5) = (sqrt(5) - 1)/4",
        "cos_pi(1/12) = (sqrt(6) + sqrt(2))/4",
        "cos_pi(1/7) - cos_pi(2/7) + cos_pi(3/7) = 1/2",
        "cos_pi(1/9)*cos_pi(2/9)*cos_pi(4/9) = 1/8",
        "cos_pi(1/7 + 2/7)*cos_pi(0 - 1/7)*cos_pi(2/7) <= 1/8",
        "cos_pi(8/3) = cos_pi(0 - 2/3)",
        f"16*cos_pi(2/17) = -1 + sqrt(17) + sqrt(34 - 2*sqrt(17)) + 2*{ROOTS}",
    ],
)
def test_equal_numbers(claim: str) -> None:
    assert verdict(claim) == "PROVED"
    if " = " in claim:
        assert verdict(claim.replace(" = ", " < ")) == "REFUTED"


@pytest.mark.parametrize(
    "claim",
    [
        "sqrt(5 + 2*sqrt(6)) = sqrt(2) + sqrt(3) + 1/10**50",
        "sqrt(2) = 0 - sqrt(2)",
        "cos_pi(1/7) - cos_pi(2/7) + cos_pi(3/7) < 1/2",
        "cos_pi(3/7) = cos_pi(4/7)",
    ],
)
def test_other_numbers(claim: str) -> None:
    assert verdict(claim) == "REFUTED"
