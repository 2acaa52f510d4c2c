"""Givens that are defined because of others: as they stand, or because they follow."""

from __future__ import annotations

import random

import pytest

from tests.prover.test_interior import page, verdict
from tests.prover.test_missing import outcome
from verify import check
from verify.wire.write import write

PROVED = [
    (["2 <= n <= 4", "1/n <= 2"], "n <= 4"),
    (["1/n <= 2", "2 <= n <= 4"], "n <= 4"),
    (["n <= -2", "-1 <= 1/n"], "n <= -1"),
    (["0 < n", "1/(n+1) <= 1/2"], "1 <= n"),
    (["1 <= n", "2 <= m", "n/m <= 3"], "n <= 3*m"),
    (["n^2 + m^2 <= 1", "1/(2 + n) <= m"], "0 < m"),
    (["n <= -1", "1/n <= m", "sqrt(m + 1) <= 1"], "m <= 0"),
    (["1 <= n", "log(1/n) <= m", "1/(1 + exp(n)) <= m"], "0 < m"),
]


@pytest.mark.parametrize(("given", "row"), PROVED)
def test_definedness_is_proved_like_a_row(given: list[str], row: str) -> None:
    assert verdict(["n", "m"], given, row) == "proved"
    text = page(["n", "m"], given, row).decode()
    point = "point = { n = -3, m = 1 }" if "n <= -" in given[0] else "point = { n = 3, m = 2 }"
    if given[-1] != "1/(2 + n) <= m" and len(given) < 3:
        assert outcome(text.replace("[rows]", f"{point}\n[rows]")).verdict == "proved"


def test_the_certificate_has_a_row_for_it() -> None:
    found = outcome(page(["n"], ["2 <= n <= 4", "1/n <= 2"], "n <= 4"))
    assert [row.context for row in found.statement.obligations] == ["box", "box.defined.1"]
    assert found.exit_code == 0
    files = write(found)
    report = check.check(files["statement.json"], files["certificate.json"], {})
    assert report.verdict == "PROVED"


def test_a_given_that_nothing_defines_is_named() -> None:
    found = outcome(page(["n"], ["n <= 5", "1/n <= 2"], "n <= 5"))
    assert found.exit_code == 3
    assert len(found.statement.obligations) == 1
    assert "its given box.2 was not seen to be defined" in found.decisions["row"].reason


@pytest.mark.parametrize(
    "given",
    ["n <= log(0)", "n*1/0 <= 1", "n <= log(-1)", "n <= sqrt(-1)", "n <= (-8)^(1/3) + 1/n"],
)
def test_what_no_sign_defines_ends_the_search(given: str) -> None:
    text = page(["n"], ["0 <= n", given], "0 <= n + 1").decode()
    found = outcome(text.replace("[rows]", "point = { n = 1 }\n[rows]"))
    assert found.exit_code == 3


INDUCTION = """title = "t"
[contexts.step]
variables = ["n", "s"]
carried = ["1 <= n", "{carried}"]
[rows.all]
always = "step"
start = {{ n = 1, s = 1 }}
next = {{ n = "n + 1", s = "{next}" }}
"""


@pytest.mark.parametrize(
    ("carried", "following"),
    [
        ("s <= 2 - 1/n", "s + 1/(n+1)^2"),
        ("2*sqrt(n+1) - 2 <= s", "s + 1/sqrt(n+1)"),
        ("1/n <= s", "s + 1/(n+1)"),
        ("s <= n", "s + 1/n"),
    ],
)
def test_inductions_carry_what_has_to_be_defined(carried: str, following: str) -> None:
    found = outcome(INDUCTION.format(carried=carried, next=following))
    assert found.decisions["all"].verdict == "proved"
    assert found.exit_code == 0


@pytest.mark.parametrize("seed", range(24))
def test_drawn_givens_are_opened(seed: int) -> None:
    """Bounds on both sides of a divisor, radicand or logarithm, in any order, at random."""
    draw = random.Random(seed)
    sign, low = draw.choice(("", "-")), draw.randint(1, 5)
    inner = draw.choice(
        (f"({sign}n)", f"({sign}n + 1/2)", f"(2*({sign}n) - 1)", f"({sign}n*3 + m^2)")
    )
    outer = draw.choice(("1/{} <= 2", "1/({}*7) <= m + 2", "-9 <= log({})", "0 <= sqrt({})"))
    given = [f"{low} <= {sign}n", f"{sign}n <= {low + 2}", "0 <= m", "m <= 1", outer.format(inner)]
    draw.shuffle(given)
    assert verdict(["n", "m"], given, f"{sign}n <= {low + 3}") == "proved"
