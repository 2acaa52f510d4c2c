"""Problems of other provers, drawn with a seed: what the search has learnt to decide."""

from __future__ import annotations

from pathlib import Path

import pytest

from verify import check
from verify.language.statement import PROVED
from verify.prover.budget import WorkBudget
from verify.wire.questions import decide, read_page_of
from verify.wire.write import write

DRAWN = Path(__file__).with_name("drawn")

#: By what a search needs for them; none was decided before it was there.
LEARNT = {
    "a claim without its divisors": ("sin-problem-3", "tan-problem-9.1", "exp-361-neg-6-e"),
    "no refutation by rounding": ("sin-cos-problem-diff2b-below", "sin-cos-problem-diff4a-above"),
    "ranges of functions in sums": ("exp-lower-16", "atan-problem-7"),
    "bounds that an equation of squares gives": ("Chua-2-VC1-U",),
    "a modulus that is bounded": ("abs-problem-2",),
    "values at multiples of pi": ("cos-problem-2", "cos-problem-9"),
    "an end that is no rational number": ("tan-problem-1",),
    "an end that is another variable": ("two-variable-problem-1",),
    "powers of roots": ("cbrt-problem-1", "nthrt_cbrt-problem-4-weak-2var"),
    "functions that rise": ("two-variable-problem-2",),
    "arguments that givens bound": ("sin-cos-2var3",),
    "arguments that are inverses": ("sin-problem-11", "tan-problem-8"),
    "slopes": ("no-913", "no-914"),
}


@pytest.mark.parametrize("name", [name for names in LEARNT.values() for name in names])
def test_a_drawn_problem_is_proved_and_the_checker_accepts_it(name: str) -> None:
    path = DRAWN / f"{'flyspeck' if name.startswith('no-') else 'metitarski'}.toml"
    page = read_page_of(str(path), path.read_bytes(), {})
    (row,) = (row for row in page.statement.obligations if row.name == name)
    contexts = tuple(c for c in page.statement.contexts if c.name == row.context)
    statement = page.statement._replace(obligations=(row,), contexts=contexts)
    outcome = decide(statement, WorkBudget())
    assert outcome.decisions[name].claimed == PROVED
    files = write(outcome)
    report = check.check(files["statement.json"], files["certificate.json"], {})
    assert report.verdict == "PROVED"


#: Flyspeck's FWGKMBZ: 144 times the square of a tetrahedron's volume is positive, for these edges.
DELTA = b"""
title = "Volumes"
[contexts.edges]
variables = ["a", "b", "c", "d", "e", "f"]
given = [
  "2.4635088 <= a <= 2.6508", "2 <= b <= sqrt(8)", "2 <= c <= sqrt(8)",
  "2 <= d <= sqrt(8)", "2 <= e <= sqrt(8)", "2 <= f <= sqrt(8)",
]
constants.first = "a^2*d^2*(-a^2 + b^2 + c^2 - d^2 + e^2 + f^2)"
constants.second = "b^2*e^2*(a^2 - b^2 + c^2 + d^2 - e^2 + f^2)"
constants.third = "c^2*f^2*(a^2 + b^2 - c^2 + d^2 + e^2 - f^2)"
constants.rest = "b^2*c^2*d^2 + a^2*c^2*e^2 + a^2*b^2*f^2 + d^2*e^2*f^2"
[contexts.edges.rows]
volume = "rest < first + second + third"
"""


def test_a_polynomial_in_squares_is_one_of_half_the_degree() -> None:
    outcome = decide(read_page_of("delta.toml", DELTA, {}).statement, WorkBudget())
    assert outcome.decisions["volume"].claimed == PROVED
    files = write(outcome)
    report = check.check(files["statement.json"], files["certificate.json"], {})
    assert report.verdict == "PROVED"
