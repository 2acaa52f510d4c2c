"""The same terms in two other arithmetics give enclosures that intersect Arb's."""

from __future__ import annotations

import random
from fractions import Fraction
from typing import Any

import pytest

from tests.points import ADMISSIBLE, parameters
from verify.measure.bench import claims_of, definitions_program, theorem_program
from verify.measure.engines import ArbEngine, CheckerEngine, MpmathEngine, load
from verify.paper.commands.theorem1 import decide_point
from verify.prover.outcome import Ends, Outcome
from verify.prover.program import ExactArithmetic


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
    outcome = decide_point(parameters(*point))
    balls = enclosures(outcome, ArbEngine())
    for engine in (MpmathEngine(), CheckerEngine()):
        other = enclosures(outcome, engine)
        assert len(balls.keys() & other.keys()) > 450
        assert all(meet(balls[slot], other[slot]) for slot in balls.keys() & other.keys())
    for slot, (low, high) in exact(outcome).items():
        if slot in balls:
            assert balls[slot][0] <= low == high <= balls[slot][1]


@pytest.mark.parametrize("point", POINTS[:12])
def test_what_is_certified_agrees_with_the_checkers_arithmetic(
    point: tuple[str, str, str, str],
) -> None:
    """Enclosures of constants and of both sides of rows, against four times as many bits."""
    outcome = decide_point(parameters(*point))
    program, _ = theorem_program(outcome)
    engine, compared = CheckerEngine(), 0
    with engine.at(512):
        run = load(program, engine).run(())
        pairs = [(run.values[program.slots[n]], e.ends[0]) for n, e in outcome.enclosures.items()]
        for name, claim in claims_of(outcome):
            sides = outcome.decisions[name].sides
            if sides is not None:
                terms = (claim.lhs, claim.rhs)
                pairs += [(run[t], ends) for t, ends in zip(terms, sides.ends, strict=True)]
        for value, ends in pairs:
            if value is not None:
                assert ends[0] <= value.low
                assert value.high <= ends[1]
                compared += 1
    assert compared > 500


def enclosures(outcome: Outcome, engine: Any) -> dict[int, Ends]:
    """The ends of everything in the theorem's program, by slot, where there is a value."""
    program, _ = theorem_program(outcome)
    with engine.at(128):
        values = load(program, engine).run(()).values
        return {slot: engine.ends(x) for slot, x in enumerate(values) if x is not None}


def exact(outcome: Outcome) -> dict[int, Ends]:
    program, _ = theorem_program(outcome)
    values = load(program, ExactArithmetic()).run(()).values
    return {slot: (x, x) for slot, x in enumerate(values) if x is not None}


def meet(a: Ends, b: Ends) -> bool:
    return a[0] <= b[1] and b[0] <= a[1]


def test_rational_fixed_points_make_everything_but_roots_of_v_1_exact() -> None:
    """r = m p and c = 2(m+p)/(1+mp) with rational m and p: the fixed points are m and p."""
    m, p = Fraction(1, 15), Fraction(1, 3)
    outcome = decide_point(parameters(str(m * p), str(2 * (m + p) / (1 + m * p))))
    program = definitions_program(outcome)
    values = load(program, ExactArithmetic()).run(()).values
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
        assert values[program.slots[name]] == value
