"""The rows of Theorem 1: their grammar, their severities, and what is wrong with the print."""

from __future__ import annotations

from collections import Counter
from fractions import Fraction
from functools import cache
from pathlib import Path
from typing import Any

import pytest
from mpmath import mp, mpf

from tests.paper.changed_page import changed_page
from tests.points import parameters
from verify.language.statement import NEEDED, PRINTED, PROVED, REFUTED, Obligation
from verify.language.terms import cos_pi
from verify.paper import theorem1
from verify.paper.commands.citing import COLLAPSE
from verify.paper.commands.theorem1 import INSTEAD, decide_point, graded
from verify.paper.parameters import GROUPS, REPAIRED
from verify.paper.theorem1 import theorem
from verify.prover.outcome import Outcome
from verify.publication import BREAKS, HARMLESS, OTHERWISE, SEVERITIES

#: The parameters of the committed certificates.
POINTS = {
    "3/100": parameters("3/100", "1"),
    "1/1000": parameters("1/1000", "1"),
    "near r_stabi": parameters("0.055728", "1"),
    "near the threshold": parameters("1/64", "0.615384616"),
    "nearly a right angle": parameters("1/1000000", "1/20"),
    "5 pi/6": parameters("1/100", "1") | {"c": -cos_pi(Fraction(5, 6))},
}


@cache
def at(point: str) -> Outcome:
    return decide_point(POINTS[point])


def all_rows() -> list[Obligation]:
    return [row for part in theorem().parts.values() for row in part.obligations]


def refuted(outcome: Outcome) -> set[str]:
    return {row.name for row, found in outcome.rows if found.verdict == REFUTED}


# --- the grammar ---------------------------------------------------------------------------------


def test_the_group_is_a_field_and_names_are_unique() -> None:
    names = [row.name for row in all_rows()]
    assert len(names) == len(set(names))
    for group, part in theorem().parts.items():
        assert group in GROUPS
        assert {row.group for row in part.obligations} == {group}


def test_severity_and_correction_stand_on_misprints_only() -> None:
    names = {row.name for row in all_rows()}
    roles = {row.name: row.role for row in all_rows()}
    for row in all_rows():
        assert (row.severity is None) == (row.corrected_by is None)
        if row.severity is not None:
            assert row.role == PRINTED
            assert row.severity in SEVERITIES
            assert row.corrected_by in names
            assert roles[row.corrected_by] == (PRINTED if row.severity == OTHERWISE else NEEDED)


def test_assumptions_have_a_kind_and_are_used() -> None:
    used = {name for row in all_rows() for name in row.uses}
    assert used | {"collision-map-roles"} == {a.name for a in theorem().assumptions}
    assert {a.kind for a in theorem().assumptions} == {"law of motion", "calculus", "glue"}


# --- severities ----------------------------------------------------------------------------------


@pytest.mark.parametrize("point", POINTS)
def test_the_repaired_set_is_proved(point: str) -> None:
    found = at(point).of_group(REPAIRED)
    rows = theorem().parts[REPAIRED].obligations
    assert [row.name for row, _ in found] == [*(row.name for row in rows), COLLAPSE]
    assert {decision.verdict for _, decision in found} == {PROVED}
    assert at(point).verdict == PROVED


@pytest.mark.parametrize("point", POINTS)
def test_every_refuted_row_says_how_bad_it_is_and_what_corrects_it(point: str) -> None:
    outcome = at(point)
    proved = {row.name for row, found in outcome.rows if found.verdict == PROVED}
    for row, found in outcome.rows:
        if found.verdict == REFUTED:
            assert row.severity in SEVERITIES
            assert row.corrected_by in proved


@pytest.mark.parametrize("point", POINTS)
def test_the_same_rows_are_refuted_at_every_point_but_near_a_right_angle(point: str) -> None:
    """There the angles are absorbed, and another row fails."""
    wide = point == "nearly a right angle"
    absorbed = {"printed.angle-absorbed", "printed.y-term-3"} if wide else set()
    more = {"printed.x-term-1-d"} if wide else set()
    assert absorbed <= refuted(at("3/100"))
    assert refuted(at(point)) == refuted(at("3/100")) - absorbed | more


def test_only_rows_that_are_known_to_fail_somewhere_have_a_severity() -> None:
    seen = set().union(*(refuted(at(point)) for point in POINTS))
    seen |= refuted(decide_point(parameters("3/100", "1", "1", "1/1000")))
    assert seen == {row.name for row in all_rows() if row.severity}


def test_the_severity_of_each_false_step_is_computed() -> None:
    """What does its work is rows of the printed set: with the paper's own constants."""
    steps = {row.name for row in all_rows() if row.severity in (BREAKS, HARMLESS)}
    assert set(INSTEAD) == steps
    known = {row.name for row in theorem().parts[PRINTED].obligations}
    assert {name for names in INSTEAD.values() for name in names} <= known


@pytest.mark.parametrize(("verdict", "severity"), [(PROVED, HARMLESS), (REFUTED, BREAKS)])
def test_a_step_breaks_the_argument_unless_others_do_its_work(verdict: str, severity: str) -> None:
    (row,) = (row for row in all_rows() if row.name == "printed.y-term-3")
    assert graded(row, {"printed.y-term-3-factor": verdict}).severity == severity
    assert graded(row, {}).severity == BREAKS
    (slip,) = (row for row in all_rows() if row.name == "printed.angle-sign")
    assert graded(slip, {}) == slip


def test_each_row_with_a_severity_has_one_cause() -> None:
    listed = [name for cause in theorem().causes for name in cause.rows]
    assert Counter(listed) == Counter(row.name for row in all_rows() if row.severity)


def test_the_printed_final_angle_fails_for_a_small_delta_theta() -> None:
    cause = {"printed.angle-absorbed", "printed.y-term-3", "printed.final-angle"}
    small = refuted(decide_point(parameters("3/100", "1", "1", "1/1000")))
    assert small & cause == {"printed.angle-absorbed", "printed.final-angle"}
    assert refuted(at("3/100")) & cause == {"printed.angle-absorbed", "printed.y-term-3"}


def test_the_printed_hypothesis_fails_wherever_the_needed_one_holds() -> None:
    for point in POINTS:
        decisions = at(point).decisions
        assert decisions["hypotheses.stability"].verdict == PROVED
        assert decisions["hypotheses.angle-as-printed"].verdict == REFUTED


# --- sums in a min -------------------------------------------------------------------------------


def kept(folder: Path, *changes: tuple[str, str]) -> set[str]:
    """What is refuted of the repaired set at r = 3/100 with one of its constants as printed."""
    with changed_page(folder, *changes):
        return refuted(decide_point(POINTS["3/100"], "repaired"))


def repaired(*names: str) -> set[str]:
    return {f"repaired.{name}" for name in names}


HYPOTHESIS = {"hypotheses.angle-as-printed"}
#: The entries of the repaired minima that take the place of a sum, and what the paper prints.
ZETA = (
    "h_4*delta_x/16, delta_2/4*(h_4*delta_x), V_0/V_1/16*(h_4*delta_x)]",
    "(1 + 4*delta_2 + V_0/V_1)/16*h_4*delta_x]",
)
ETA = (
    """V_0/speed/(12*alpha_0)*(h_4*delta_x), V_0/speed*(delta_2/6)*(h_4*delta_x),
    V_0/speed/24*(h_4*delta_x)]""",
    "V_0/speed*(2/(15*alpha_0) + h_4*delta_2/6 + h_4/(12*alpha_0) + h_4/24)*delta_x]",
)
D = (
    "delta_2/2*(h_4*delta_x), h_4*delta_x/8]",
    "(1 + delta_2*h_4)*delta_x/5, (1 + 2*delta_2)/4*h_4*delta_x]",
)


def without(*rows: str) -> list[tuple[str, str]]:
    """The changes that take away rows about entries which a minimum has no longer."""
    return [
        (line.removesuffix("'''"), "")
        for line in Path(theorem1.PAGE).read_text(encoding="utf-8").splitlines()
        if line.startswith(tuple(f"repaired.{row}:" for row in rows))
    ]


def test_once_delta_x_is_repaired_the_entries_of_zeta_are_needed(tmp_path: Path) -> None:
    found = kept(tmp_path, ZETA, *without("zeta_bar-entry-4", "zeta_bar-entry-5"))
    assert found - HYPOTHESIS >= repaired("y-term-2-zeta", "x-term-1-zeta", "y-term-4")
    steps = repaired("y-term-1", "y-term-2-d", "x-term-1-d", "init-y-term-3-d", "x-term-1-d_0")
    assert not found & steps


def test_the_sum_in_eta_is_harmless_there_even_then(tmp_path: Path) -> None:
    changes = (ETA, *without("eta_bar-entry-6", "eta_bar-entry-7"))
    assert kept(tmp_path, *changes) == HYPOTHESIS


def test_the_sum_in_d_is_harmless_there_even_then(tmp_path: Path) -> None:
    assert kept(tmp_path, D) == HYPOTHESIS


# --- the state of `angle-sign` -------------------------------------------------------------------


def middle(outcome: Outcome, name: str) -> Any:
    low, high = outcome.enclosures[name].ends[0]
    return (number(low) + number(high)) / 2


def number(value: Fraction) -> Any:
    return mpf(value.numerator) / value.denominator


def dot(a: Any, b: Any) -> Any:
    return sum(x * y for x, y in zip(a, b, strict=True))


def vectors(outcome: Outcome) -> dict[str, Any]:
    """The state as vectors in three dimensions."""
    value = {name: middle(outcome, name) for name in outcome.enclosures}
    eta = value["C_eta"] * value["printed.eta_bar"]
    eta_s = value["phi_minus"] * eta
    root = mp.sqrt(value["V_1"])
    cosine = value["c"] - 11 * root / value["V_0"] * value["printed.eta_bar"]
    sine = mp.sqrt(1 - cosine**2)
    w = mp.sqrt((value["V_0"] + value["V_1"]) / 2)
    zero = mpf(0)
    return value | {
        "eta": eta,
        "omega_c": (mpf(1), zero, zero),
        "omega_s": (-cosine, sine, zero),
        "W_c": (-eta, -eta * cosine / sine, w),
        "W_s": (zero, eta_s / sine, -w),
        "d": value["printed.d_slope"] * eta**2,
        "cosine": cosine,
    }


@pytest.mark.parametrize("point", POINTS)
def test_angle_sign_is_refuted_at_a_state_that_the_conditions_allow(point: str) -> None:
    with mp.workdps(60):
        s = vectors(at(point))
        assert abs(dot(s["omega_s"], s["W_c"])) < 1e-40
        assert abs(dot(s["omega_c"], s["W_s"])) < 1e-40
        assert dot(s["omega_c"], s["W_c"]) == -s["eta"] < 0
        assert dot(s["W_s"], s["W_c"]) < 0 < dot(s["omega_s"], s["W_s"])
        for name in ("W_c", "W_s"):
            assert s["V_0"] <= dot(s[name], s[name]) <= s["V_1"]
        d, norm = s["d"], dot(s["W_c"], s["W_c"])
        zeta = d * (2 + d) / (1 + d) ** 2 * norm / s["eta"] ** 2
        assert 0 < zeta <= s["printed.zeta_bar"]
        tau = (1 + d) / norm * s["eta"] * (1 - mp.sqrt(1 - zeta))
        assert_display_fails(s, tau)


def assert_display_fails(s: dict[str, Any], tau: Any) -> None:
    """Move the vectors to the next collision, and compare the change of the angle."""
    d = s["d"]
    moved_s = [x + tau * w for x, w in zip(s["omega_s"], s["W_s"], strict=True)]
    moved_c = [(1 + d) * x + tau * w for x, w in zip(s["omega_c"], s["W_c"], strict=True)]
    assert abs(dot(moved_c, moved_c) - 1) < 1e-40
    after = mp.sqrt(dot(moved_s, moved_s))
    change = abs(-dot(moved_s, moved_c) / after - s["cosine"])
    last = abs(dot(s["W_s"], s["W_c"])) * tau**2 / after
    first = abs((1 + d) / after - 1) * s["cosine"]
    assert first - last < change
    assert abs(change - (first + last)) < 1e-40  # with + the display is an equality here


def test_angle_sign_is_the_display_at_that_state() -> None:
    outcome = at("3/100")
    row = next(row for row, _ in outcome.rows if row.name == "printed.angle-sign")
    sides = outcome.decisions[row.name].sides
    assert sides is not None
    with mp.workdps(60):
        s = vectors(outcome)
        d, norm, norm_s = s["d"], dot(s["W_c"], s["W_c"]), dot(s["W_s"], s["W_s"])
        zeta = d * (2 + d) / (1 + d) ** 2 * norm / s["eta"] ** 2
        tau = (1 + d) / norm * s["eta"] * (1 - mp.sqrt(1 - zeta))
        after = mp.sqrt(1 + 2 * s["phi_minus"] * s["eta"] * tau + norm_s * tau**2)
        last = -dot(s["W_s"], s["W_c"]) * tau**2 / after
        first = ((1 + d) / after - 1) * s["cosine"]
        for (low, high), value in zip(sides.ends, (first + last, first - last), strict=True):
            assert (
                number(low) * (1 - mpf(10) ** -15) <= value <= number(high) * (1 + mpf(10) ** -15)
            )
