"""The same terms in two other arithmetics give enclosures that intersect Arb's."""

from __future__ import annotations

import random
from fractions import Fraction
from typing import Any

import pytest

from tests.points import ADMISSIBLE, parameters
from verify.measure.engines import CheckerEngine, MpmathEngine, load
from verify.prover.program import Program
from verify.prover.ground import Prover
from verify.language.terms import as_term
from verify.jobs.theorem1 import Outcome, decide


def random_points(count: int) -> list[tuple[str, str, str, str]]:
    """Points with c between the threshold and 1, in exact decimals."""
    source = random.Random(20240229)
    points = []
    while len(points) < count:
        r = Fraction(source.randrange(1, 5572), 10 ** source.choice([5, 6, 8]))
        c = Fraction(source.randrange(1, 10001), 10000)
        x = (1 + r) / 2 * c
        if x**3 > 3 * r * x + r * (1 + r):
            v_0 = str(Fraction(source.randrange(1, 1000), source.randrange(1, 1000)))
            points.append((str(r), str(c), v_0, str(Fraction(1, source.randrange(2, 1000)))))
    return points


POINTS = [(r, c, "1", "1/10") for r, c in ADMISSIBLE] + random_points(25)


@pytest.mark.parametrize("point", POINTS)
def test_interval_arithmetic_and_rationals_agree_with_balls(
    point: tuple[str, str, str, str],
) -> None:
    outcome = decide(parameters(*point))
    for engine in (MpmathEngine(), CheckerEngine()):
        compare(outcome, engine)
    compare_with_rationals(outcome)


def compare(outcome: Outcome, engine: Any) -> None:
    prover = outcome.prover
    program = Program(())
    for name, term in prover.definitions.items():
        program.define(name, term)
    terms = [t for row, _ in outcome.all_rows for t in (row.claim.lhs, row.claim.rhs)]
    compared = 0
    with engine.at(128):
        run = load(program, engine).run(())
        for term in (*prover.definitions.values(), *terms):
            ends, other = prover.enclose(term), run[term]
            if ends is None or other is None:
                continue
            low, high = engine.ends(other)
            assert low <= ends[1]
            assert ends[0] <= high
            compared += 1
    assert compared > 500


def compare_with_rationals(outcome: Outcome) -> None:
    """Where a term is rational the balls contain it; `enclose` returns it, so ask the balls."""
    prover = outcome.prover
    for row, _ in outcome.all_rows:
        for term in (row.claim.lhs, row.claim.rhs):
            value = prover.exact(term)
            if value is not None:
                ball = prover.ball(term, 128)
                assert not ball < prover.ball(as_term(value), 128)
                assert not ball > prover.ball(as_term(value), 128)


def test_rational_fixed_points_make_everything_but_roots_of_v_1_exact() -> None:
    """r = m p and c = 2(m+p)/(1+mp) with rational m and p: the fixed points are m and p."""
    m, p = Fraction(1, 15), Fraction(1, 3)
    point = parameters(str(m * p), str(2 * (m + p) / (1 + m * p)))
    prover: Prover = decide(point).prover
    chart = {
        "phi_minus": m,
        "phi_plus": p,
        "delta_1": (p - m) / 2,
        "delta_2": p / 2,
        "delta_3": (1 - p) / 2,
        "C_eta": (1 + p) / 2,
        "h_4": (1 - m / p) / 2,
        "h_5": (1 - m / p**2) / 2,
    }
    for name, value in chart.items():
        assert prover.exact(prover.definitions[name]) == value
