"""The job `theorem1`: verdicts, and near misses of everything that is proved."""

from __future__ import annotations

from fractions import Fraction
from functools import cache

import pytest

from tests.points import ADMISSIBLE, parameters
from verify.jobs import theorem1
from verify.paper.theorem1 import theorem
from verify.prover.ground import PROVED, REFUTED, UNDECIDED, Prover
from verify.language.statement import HYPOTHESES, PRINTED, REPAIRED
from verify.language.terms import Claim, as_term, cos, cos_pi
from verify.jobs.theorem1 import Outcome, decide

#: What the printed proof gets wrong at r = 3/100, theta_0 = pi; the README lists them.
REFUTED_AT_3_100 = {
    "r_stabi-gives-fixed-points",
    "phi-minus-called-unstable",
    "second-assumption-as-printed",
    "set-distance",
    "set-interior",
    "init-zeta-bound-2",
    "d-index",
    "norm-law-as-printed",
    "Cnd5-lower-as-printed",
    "zeta-time-square",
    "zeta-x-bound",
    "zeta-term-2",
    "zeta-remainders",
    "zeta-total",
    "CndT-as-printed",
    "angle-sign",
    "angle-absorbed",
    "y-term-3",
    "alone-eta-y-1",
    "alone-eta-y-2",
    "alone-eta-x-1",
    "alone-zeta-y-2",
    "alone-zeta-x-1",
    "alone-zeta-y-4",
    "alone-d-y-3",
    "alone-d-x-1",
}


@cache
def outcome_at(r: str, c: str) -> Outcome:
    return decide(parameters(r, c))


@pytest.mark.parametrize(("r", "c"), ADMISSIBLE)
def test_the_repaired_set_is_proved_and_the_printed_refuted(r: str, c: str) -> None:
    outcome = outcome_at(r, c)
    assert outcome.hypotheses_verdict == PROVED
    assert outcome.set_verdict(REPAIRED) == PROVED
    assert outcome.set_verdict(PRINTED) == REFUTED
    assert outcome.verdict == PROVED
    assert outcome.exit_code == 0
    assert all(len(outcome.rows[group]) >= 60 for group in (PRINTED, REPAIRED))


def test_the_list_of_defects_at_3_100() -> None:
    rows = outcome_at("3/100", "1").rows[PRINTED]
    refuted = {row.name.removeprefix("printed.") for row, d in rows if d.verdict == REFUTED}
    assert refuted == REFUTED_AT_3_100
    names = {row.name for row in theorem().obligations}
    for row, decision in rows:
        if decision.verdict == REFUTED:
            assert row.corrected_by in names


@pytest.mark.parametrize("selection", ["printed", "repaired", "all"])
def test_a_selection_leaves_only_its_sets(selection: str) -> None:
    outcome = decide(parameters("3/100", "1"), selection)
    assert set(outcome.rows) == {HYPOTHESES, *theorem1.SELECTIONS[selection]}
    assert outcome.exit_code == (1 if selection == "printed" else 0)


def test_every_corrected_row_that_is_refuted_somewhere_names_an_existing_row() -> None:
    names = {row.name for row in theorem().obligations}
    missing = [
        r.name for r in theorem().obligations if r.corrected_by and r.corrected_by not in names
    ]
    assert missing == []


def test_every_assumption_is_used_and_every_use_is_an_assumption() -> None:
    used = {name for row in theorem().obligations for name in row.uses}
    assert used == {assumption.name for assumption in theorem().assumptions}


def rows_at_3_100() -> list[tuple[str, Claim]]:
    outcome = outcome_at("3/100", "1")
    return [(row.name, row.claim) for row, d in outcome.all_rows if d.verdict == PROVED]


@pytest.mark.parametrize(("name", "claim"), rows_at_3_100())
def test_the_near_miss_of_a_proved_row_is_refuted(name: str, claim: Claim) -> None:
    """The left side raised by the margin, and by 10^-30 of the margin or side more."""
    prover = outcome_at("3/100", "1").prover
    lhs, rhs = prover.enclose(claim.lhs), prover.enclose(claim.rhs)
    assert lhs is not None
    assert rhs is not None
    gap = rhs[1] - lhs[0]
    slip = (max(abs(gap), abs(lhs[1]), abs(rhs[1])) or Fraction(1)) / 10**30
    assert prover.decide(claim.lhs + as_term(gap + slip) <= claim.rhs).verdict == REFUTED
    if gap > slip:
        barely = claim.lhs + as_term(gap - 3 * slip) <= claim.rhs
        assert prover.decide(barely).verdict == PROVED


def test_equalities_are_not_strict_inequalities() -> None:
    outcome = outcome_at("3/100", "1")
    structural = [row.claim for row, d in outcome.all_rows if d.closing == "identity"]
    assert len(structural) > 30
    for claim in structural:
        if outcome.prover.decide(Claim("<=", claim.rhs, claim.lhs)).verdict == PROVED:
            assert outcome.prover.decide(Claim("<", claim.lhs, claim.rhs)).verdict == REFUTED


@pytest.mark.parametrize(
    "name",
    ["V_1", "delta_x", "x_0", "Delta_theta", "eta_bar", "zeta_bar", "d_slope", "d_const", "T_star"],
)
def test_each_chosen_constant_is_the_last_that_works(name: str) -> None:
    """One more unit in the last digit breaks a row: no slack was built in."""
    chosen = outcome_at("3/100", "1").prover.definitions
    part = theorem().of_group(REPAIRED)
    prover = Prover(theorem().of_group(HYPOTHESES), parameters("3/100", "1"))
    for constant in part.constants:
        if not constant.name.startswith("repaired."):
            continue
        if constant.name == f"repaired.{name}":
            value = chosen[constant.name].value
            unit = Fraction(1, 10 ** decimals(value))
            value += -unit if constant.direction == "up" else unit
            prover.define(constant._replace(term=as_term(value), chosen=False))
        else:
            prover.define(constant._replace(term=chosen[constant.name], chosen=False))
    verdicts = {prover.decide(row.claim).verdict for row in part.obligations}
    assert REFUTED in verdicts


def decimals(value: Fraction) -> int:
    count = 0
    while (value * 10**count).denominator != 1:
        count += 1
    return count


def test_chosen_constants_are_short_and_do_not_depend_on_the_precision() -> None:
    values = [
        [
            decide(parameters("3/100", "1"), "repaired", bits).prover.definitions[c.name]
            for c in theorem().constants
            if c.chosen
        ]
        for bits in (64, 128, 1000)
    ]
    assert values[0] == values[1] == values[2]
    assert values[0][0].value == Fraction("1.249")


def test_equality_in_the_hypothesis_is_a_definite_no() -> None:
    outcome = decide(parameters("1/64", "8/13"))
    verdicts = {row.name: d for row, d in outcome.rows[HYPOTHESES]}
    assert verdicts["hypotheses.stability"].verdict == REFUTED
    assert verdicts["hypotheses.stability"].method == "exact" or (
        verdicts["hypotheses.stability"].lhs == verdicts["hypotheses.stability"].rhs
    )
    assert verdicts["hypotheses.angle-as-printed"].verdict == REFUTED
    assert outcome.exit_code == 1
    assert list(outcome.rows) == [HYPOTHESES]


@pytest.mark.parametrize("exponent", [30, 100, 300])
def test_next_to_the_thresholds_the_hypotheses_are_decided(exponent: int) -> None:
    step = Fraction(1, 10**exponent)
    root = Fraction(_isqrt(5 * 10 ** (2 * exponent + 20)), 10 ** (exponent + 10))
    below = str(9 - 4 * root - 2 * step)
    assert decide(parameters(below, "1"), "repaired").verdict == PROVED
    above = str(9 - 4 * root + 2 * step)
    assert decide(parameters(above, "1"), "repaired").verdict == REFUTED
    # At r = 1/64 the threshold for c is exactly 8/13.
    assert decide(parameters("1/64", str(Fraction(8, 13) + step)), "repaired").verdict == PROVED
    assert decide(parameters("1/64", str(Fraction(8, 13) - step)), "repaired").verdict == REFUTED


def _isqrt(number: int) -> int:
    from math import isqrt

    return isqrt(number)


@pytest.mark.parametrize(
    ("r", "v_0", "delta_theta"),
    [("1e-300", "1", "1/10"), ("3/100", "1e100", "1e-100"), ("3/100", "1e-100", "1e100")],
)
def test_extreme_parameters(r: str, v_0: str, delta_theta: str) -> None:
    outcome = decide(parameters(r, "1", v_0, delta_theta))
    assert outcome.verdict == PROVED
    assert outcome.set_verdict(PRINTED) == REFUTED


@pytest.mark.parametrize("angle", [-cos_pi(Fraction(5, 6)), -cos(Fraction("2.9"))])
def test_irrational_angles(angle: object) -> None:
    point = parameters("1/100", "1") | {"c": angle}
    assert decide(point).verdict == PROVED


@pytest.mark.parametrize(
    ("r", "c"),
    [
        ("1/25", "25/26"),
        ("1/200", "36/67"),
        ("1/85", "97/172"),
        ("7/240", "16/19"),
        ("4/125", "35/43"),
    ],
)
def test_a_choice_that_meets_its_bound_exactly(r: str, c: str) -> None:
    """Rational fixed points, at which a rounded constant equals its bound."""
    assert decide(parameters(r, c)).verdict == PROVED


def test_the_choices_do_not_depend_on_the_last_precision() -> None:
    """V_1 - V_0 is within 10^-300 of a decimal with three digits."""
    h = decide(parameters("1/25", "25/26")).prover
    ratio = h.exact(h.definitions["V_1"])
    assert ratio is not None
    v_0 = str(Fraction("0.249") / (ratio - 1) + Fraction(1, 10**300))
    chosen = [
        decide(parameters("1/25", "25/26", v_0), "repaired", 128, last)
        .prover.definitions["repaired.V_1"]
        .value
        for last in (256, 512, 65536)
    ]
    assert chosen[0] == chosen[1] == chosen[2]


def test_undecided_printed_rows_are_left_out_of_the_certificate() -> None:
    """At delta_2 = 1/44 two sides are equal by a coincidence that no rule sees."""
    outcome = decide(parameters("1/11000", "348/3667"))
    assert outcome.verdict == PROVED
    assert len(outcome.all_rows) - len(outcome.decided_rows) == 1


def test_a_spent_budget_is_undecided() -> None:
    near = str(Fraction(8, 13) + Fraction(1, 10**300))
    outcome = decide(parameters("1/64", near), "repaired", 64, 64)
    assert outcome.verdict == UNDECIDED
    assert outcome.exit_code == 3


def test_a_broken_bound_is_refuted(monkeypatch: pytest.MonkeyPatch) -> None:
    """If the share of |Delta theta| were 7/(1-C_eta) instead of 28, the angle sum would fail."""
    statement = theorem()
    changed = tuple(
        c._replace(term=c.term.children[0]) if c.name == "repaired.eta_bar" else c
        for c in statement.constants
    )
    monkeypatch.setattr(theorem1, "theorem", lambda: statement._replace(constants=changed))
    outcome = decide(parameters("3/100", "1"))
    assert outcome.verdict == REFUTED
    assert outcome.exit_code == 1
