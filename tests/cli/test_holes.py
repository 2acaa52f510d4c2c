"""What attacks found: each hole in the prover and the command line, closed.

The holes of `check --statement`, (e), (f) and (g), are in `test_check`.
"""

from __future__ import annotations

from fractions import Fraction
from math import isqrt
from pathlib import Path

import pytest

from tests.citing import cited_in
from verify import check
from verify.cli import main
from verify.language.statement import PROVED, REFUTED, UNDECIDED, Constant, Obligation
from verify.language.terms import Claim, Term, as_term, equal, minimum, sqrt, symbol
from verify.prover.ground import Ground
from verify.prover.session import Session

FILES = ("statement.json", "certificate.json")


def verdict(claim: Claim, **constants: Term) -> str:
    ground = Ground(Session(), max_bits=512)
    for name, term in constants.items():
        assert ground.define(Constant(name, name, name, "", term))
    return ground.decide(Obligation("row", "", "", "needed", "", claim)).verdict


def checked(folder: Path) -> str:
    files = ((folder / name).read_bytes() for name in FILES)
    return check.check(*files, cited_in(folder)).verdict


def test_a_an_entry_is_not_the_minimum_on_the_way_to_it() -> None:
    """1/(1-m)² = 1/(2-√2)² for m = min(√2-1, 3); at the entry 3 the left side is smaller."""
    m = symbol("m")
    claim = 1 / (1 - m) ** 2 < 1 / (2 - sqrt(2)) ** 2
    assert verdict(claim, m=minimum(sqrt(2) - 1, 3)) != PROVED


def test_a_a_point_whose_certificate_was_refused(tmp_path: Path) -> None:
    words = ["theorem1", "--r", "1e-3", "--neg-cos", "0.3", "--out", str(tmp_path / "x")]
    assert main(words) == 0
    assert checked(tmp_path / "x") == "PROVED"


def test_b_an_equation_is_not_an_inequality() -> None:
    assert verdict(equal(1, 2)) == REFUTED
    assert verdict(equal(2, 1)) == REFUTED
    assert verdict(equal(sqrt(2), Fraction(3, 2))) in (REFUTED, UNDECIDED)
    assert verdict(equal(as_term(1) / 3, Fraction(1, 3))) == PROVED


@pytest.mark.parametrize("relation", ["==", ">", "≤", "!=", ""])
def test_b_an_unknown_relation_is_an_error(relation: str) -> None:
    with pytest.raises((KeyError, ValueError)):
        verdict(Claim(relation, as_term(1), as_term(2)))


@pytest.mark.parametrize("words", [["--r", "0.5"], ["--r", "0.03", "--neg-cos", "1/2"]])
def test_c_constants_that_do_not_exist(tmp_path: Path, words: list[str]) -> None:
    assert main(["theorem1", *words, "--out", str(tmp_path / "x")]) == 1
    assert checked(tmp_path / "x") == "REFUTED"
    assert main(["check", str(tmp_path / "x")]) == 1


@pytest.mark.parametrize("digits", [50, 200])
def test_d_next_to_a_threshold_with_many_digits(
    capsys: pytest.CaptureFixture[str], tmp_path: Path, digits: int
) -> None:
    r = 9 - Fraction(isqrt(80 * 10 ** (2 * digits)) + 1, 10**digits)
    code = main(["theorem1", "--r", str(r), "--out", str(tmp_path / "x")])
    assert code in (0, 2, 3)
    assert (tmp_path / "x").exists() == (code == 0)
    assert code != 0 or checked(tmp_path / "x") == "PROVED"
    assert "Traceback" not in capsys.readouterr().err
