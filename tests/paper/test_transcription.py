"""The paper room against a second, blind transcription of the proof.

`transcription.py` was written from the LaTeX text alone, by somebody who had not seen this
project. Its constants must be ours; each of its rows must have the two sides of one of ours (up to
a common positive factor), or be listed below with the reason why not.
"""

from __future__ import annotations

from fractions import Fraction
from typing import Any

import pytest
from mpmath import mp, mpf

from tests.measure.test_second_opinion import random_points
from tests.paper import transcription
from tests.points import parameters
from verify.paper.commands.theorem1 import decide_point
from verify.paper.parameters import HYPOTHESES, PRINTED
from verify.paper.theorem1 import theorem
from verify.prover.outcome import Outcome

#: Rows of the blind transcription that have no row with the same two sides here: the number of the
#: row there, and either the row here that carries the step or the assumption that does.
ELSEWHERE = {
    2: "hypotheses.r-below-stabi",
    46: "printed.init-zeta-bound-2",
    47: "zeta-from-distance",
    55: "printed.init-d_0-below-one",
    56: "root-crude",
    60: "printed.init-CndT",
    62: "distance",
    65: "distance",
    67: "printed.init-d_0-below-one",
    68: "angle-step",
    71: "printed.angle-absorbed",
    77: "root-product",
    78: "printed.init-y-term-3-d",
    85: "printed.init-Cnd10",
    88: "printed.norm-c-upper",
    92: "distance",
    96: "root-crude",
    100: "printed.norm-factor-3",
    102: "printed.norm-s-upper",
    104: "norm-step",
    106: "printed.Cnd5-upper",
    107: "printed.Cnd5-lower",
    116: "zeta-from-distance",
    117: "printed.zeta-time-square",
    118: "repaired.zeta-time-square",
    120: "root-fine",
    121: "printed.zeta-dropped-factor",
    124: "printed.zeta-denominator",
    130: "printed.zeta-ratio",
    140: "printed.zeta-total",
    143: "distance",
    148: "printed.obtuse",
    149: "printed.obtuse-distance",
    150: "printed.CndT-as-printed",
    152: "printed.CndT-half",
    153: "printed.d-below-one",
    154: "angle-step",
    160: "root-product",
    161: "printed.x-term-1-d_0",
    162: "printed.x-term-1-d",
    163: "printed.x-term-1-zeta",
    166: "printed.x-contraction",
    169: "printed.x-improved",
    174: "printed.y-term-2-d",
    175: "printed.y-term-2-zeta",
    180: "printed.y-sum",
    183: "printed.collapse-time",
    187: "printed.set-eta_s-positive",
}


#: Blind rows whose two sides happen to be those of several rows here: the one that is meant.
MEANT = {82: "printed.init-y-term-5", 83: "printed.init-y-term-5"}

#: Rows here that the blind transcription does not have: entries of a min one by one, the needed
#: form of a hypothesis, counterexamples and judgements of what is printed, and what a repair adds.
HERE_ONLY = {
    "printed.x-term-1-factor",  # r in front of the bracket, which the next line drops
    "printed.y-term-3-factor",  # (1+r)/2 in `EQUATSS4.1Lien_x_n_&_y_n_`, which is dropped later
    "hypotheses.r-below-one",
    "hypotheses.stability",
    "printed.r_stabi-gives-fixed-points",
    "printed.phi-minus-called-unstable",
    "printed.second-assumption-as-printed",
    "printed.Delta_theta-entry-1",
    "printed.eta_bar-entry-2",
    "printed.eta_bar-entry-5",
    "printed.zeta_bar-entry-3",
    "printed.d_slope-positive",
    "printed.d_const-positive",
    "printed.d_const-entry-1",
    "printed.d_const-entry-3",
    "printed.d_const-entry-4",
    "printed.d_bar-entry-1",
    "printed.set-eta_s",
    "printed.d-index",
    "printed.norm-law-as-printed",
    "printed.norm-c-lower",
    "printed.norm-s-lower",
    "printed.Cnd5-lower-as-printed",
    "printed.angle-sign",
    "printed.eta_s-stays-positive",
}


def number(value: Any) -> Any:
    if isinstance(value, int | Fraction):
        value = Fraction(value)
        return mpf(value.numerator) / value.denominator
    return value


class Context:
    """High-precision numbers for the blind transcription: enough to compare, not to prove."""

    @staticmethod
    def sqrt(x: Any) -> Any:
        return mp.sqrt(number(x))

    @staticmethod
    def min(*xs: Any) -> Any:
        return min(map(number, xs))

    @staticmethod
    def max(*xs: Any) -> Any:
        return max(map(number, xs))

    @staticmethod
    def abs(x: Any) -> Any:
        return abs(number(x))


def blind(point: tuple[str, str, str, str]) -> tuple[dict[str, Any], list[Any]]:
    values = [number(Fraction(text)) for text in point]
    constants = transcription.constants(Context, *values)
    return constants, transcription.rows(Context, constants)


@pytest.fixture(autouse=True)
def digits() -> Any:
    with mp.workdps(60):
        yield


POINTS = [("3/100", "1", "1", "1/10"), *random_points(12)]


@pytest.mark.parametrize("point", POINTS)
def test_the_constants_are_the_same(point: tuple[str, str, str, str]) -> None:
    outcome = decide_point(parameters(*point), "printed")
    theirs, _ = blind(point)
    compared = 0
    for constant in outcome.statement.constants:
        if constant.short_name in theirs:
            low, _ = outcome.enclosures[constant.name].ends[0]
            assert close(theirs[constant.short_name], low)
            compared += 1
    assert compared == 19


def close(a: Any, b: Any) -> bool:
    a, b = number(a), number(b)
    return bool(abs(a - b) <= mpf(10) ** -25 * max(abs(a), abs(b)))


@pytest.mark.parametrize("point", POINTS)
def test_every_blind_row_is_here_or_accounted_for(point: tuple[str, str, str, str]) -> None:
    outcome = decide_point(parameters(*point), "printed")
    ours = named_sides(outcome).values()
    names = {row.name for part in theorem().parts.values() for row in part.obligations}
    assumptions = {assumption.name for assumption in theorem().assumptions}
    _, rows = blind(point)
    missing = []
    for index, row in enumerate(rows, 1):
        if index in ELSEWHERE:
            assert ELSEWHERE[index] in names | assumptions
        elif not any(same_claim((row.lhs, row.rhs), pair) for pair in ours):
            missing.append((index, row.line, row.quote[:50]))
    assert missing == []


def test_every_row_here_has_a_blind_row_or_is_accounted_for() -> None:
    point = POINTS[0]
    _, blind_rows = blind(point)
    accounted = HERE_ONLY | set(ELSEWHERE.values())
    missing = [
        name
        for name, pair in named_sides(decide_point(parameters(*point), "printed")).items()
        if name not in accounted
        and ".alone-" not in name
        and not any(same_claim((row.lhs, row.rhs), pair) for row in blind_rows)
    ]
    assert not missing, (
        f"{', '.join(missing)}: read the sentence in the LaTeX text once more and write its row in "
        "tests/paper/transcription.py; or, if the text has no such sentence, say in HERE_ONLY why "
        "the row is here"
    )


def test_rows_with_the_same_sides_are_not_confused() -> None:
    point = POINTS[0]
    _, blind_rows = blind(point)
    ours = named_sides(decide_point(parameters(*point), "printed"))
    for index, name in MEANT.items():
        row = blind_rows[index - 1]
        assert same_claim((row.lhs, row.rhs), ours[name])


def named_sides(outcome: Outcome) -> dict[str, tuple[Fraction, Fraction]]:
    return {
        row.name: (decision.sides.ends[0][0], decision.sides.ends[1][0])
        for row, decision in outcome.of_group(HYPOTHESES, PRINTED)
        if decision.sides is not None
    }


def same_claim(a: tuple[Any, Any], b: tuple[Any, Any]) -> bool:
    """The same two sides, or both multiplied by one positive number, or both sides swapped over
    zero (x < 0 is 0 < -x)."""
    (a_left, a_right), (b_left, b_right) = (tuple(map(number, pair)) for pair in (a, b))
    if a_right == 0:
        a_left, a_right = mpf(0), -a_left
    if b_right == 0:
        b_left, b_right = mpf(0), -b_left
    if a_left == 0 or b_left == 0:
        return a_left == b_left and (a_right > 0) == (b_right > 0) and close(a_right, b_right)
    return bool(a_left * b_left > 0 and a_right * b_right > 0) and close(
        a_left * b_right, b_left * a_right
    )
