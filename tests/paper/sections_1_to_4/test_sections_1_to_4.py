"""What the paper prints elsewhere: right rows are proved, wrong ones refused or refuted."""

from __future__ import annotations

from fractions import Fraction

import pytest

from tests.pages import Variables, context, headings, rows
from tests.paper.changed_claims import changed_claims, refused
from tests.paper.changed_statements import report
from tests.paper.sections_1_to_4.values import holds, value, with_constants
from verify.language.argument import ByWitness, Line
from verify.language.statement import NEEDED, PROVED, REFUTED
from verify.language.terms import Claim, as_term, substitute_claim
from verify.paper.commands import pages
from verify.paper.commands.pages import page
from verify.paper.commands.places import places
from verify.paper.source import printed_numbers
from verify.prover.proof import ObligationStep
from verify.prover.rules import Witness
from verify.publication import BREAKS, HARMLESS, OTHERWISE, REMARK, SEVERITIES, SLIP
from verify.views.words import fair

PAGE = "sections_1_to_4"
#: The points at which misprints are false.
WRONG = {
    item.name: item.reason.at
    for chapter in page(PAGE).chapters
    for item in chapter.items
    if isinstance(item, Line) and isinstance(item.reason, ByWitness)
}
ROWS = rows(PAGE)
CONTEXTS = {context.name: context for context in page(PAGE).statement.contexts}


# --- as they are ----------------------------------------------------------------------------------


def test_each_part_has_rows() -> None:
    assert len(headings(PAGE)) == 10
    assert "" not in headings(PAGE)


def test_labels_are_those_of_the_paper_and_every_row_has_a_place() -> None:
    assert {row.label for row in ROWS.values()} <= set(printed_numbers())
    assert set(ROWS) <= {place.name for place in places() if place.part == PAGE}


# --- what is refuted ------------------------------------------------------------------------------


@pytest.mark.parametrize("name", WRONG)
def test_a_misprint_is_false_at_its_point(name: str) -> None:
    row, at = ROWS[name], dict(WRONG[name])
    context = CONTEXTS[str(row.context)]
    assert set(at) == {variable.name for variable in context.variables}
    known = with_constants(context, at)
    assert [g.name for g in context.givens if not holds(g.claim, known)] == []
    assert isinstance(row.claim, Claim)
    assert not holds(row.claim, known)


@pytest.mark.parametrize("name", WRONG)
def test_a_misprint_is_corrected_by_a_row_that_is_proved(name: str) -> None:
    row = ROWS[name]
    assert row.severity in SEVERITIES
    assert ROWS[str(row.corrected_by)].role == NEEDED
    assert pages.decide("sections_1_to_4").decisions[str(row.corrected_by)].verdict == PROVED


def test_a_correction_holds_where_the_misprint_does_not() -> None:
    """Where both are about the same numbers; the others are in a context of their own."""
    seen = 0
    for name, at in WRONG.items():
        row = ROWS[str(ROWS[name].corrected_by)]
        if row.context == ROWS[name].context and isinstance(row.claim, Claim):
            known = with_constants(CONTEXTS[str(row.context)], dict(at))
            assert holds(row.claim, known), name
            seen += 1
    assert seen > 8


def test_the_severities() -> None:
    kinds = [row.severity for row in ROWS.values() if row.severity]
    found = {kind: kinds.count(kind) for kind in kinds}
    assert found == {BREAKS: 2, HARMLESS: 4, SLIP: 5, OTHERWISE: 4, REMARK: 5}


@pytest.mark.parametrize(
    ("name", "verdict"),
    [
        ("quoted-limit", OTHERWISE),
        ("travel-first-order", OTHERWISE),
        ("two-laws-determine", OTHERWISE),
        ("next-collision", REMARK),
        ("far-component-printed", REMARK),
        ("negligible-printed", REMARK),
        ("angle-for-every-r", REMARK),
        ("law-at-every-contact", REMARK),
        ("tangential-large", REFUTED),
        ("forced-exponential", OTHERWISE),
    ],
)
def test_what_the_text_says_is_told_fairly(name: str, verdict: str) -> None:
    outcome = pages.decide("sections_1_to_4")
    assert outcome.decisions[name].verdict == REFUTED
    assert fair(outcome, ROWS[name], outcome.decisions[name]) == verdict


def test_nothing_is_called_proved_without_its_proof() -> None:
    """The row by which a sentence is true has to be proved itself."""
    outcome = pages.decide("sections_1_to_4")
    row, found = ROWS["quoted-limit"], outcome.decisions["quoted-limit"]
    assert fair(outcome.draft, row, found) == REFUTED
    assert fair(outcome, row._replace(corrected_by="no-such-row"), found) == REFUTED
    assert fair(outcome, row._replace(role=NEEDED), found) == REFUTED


def test_a_point_that_breaks_a_given_is_refused() -> None:
    outcome = pages.decide("sections_1_to_4")
    steps: list[object] = []
    for step in outcome.steps:
        if isinstance(step, ObligationStep) and step.name == "next-collision":
            assert isinstance(step.proof, Witness)
            at = {**step.proof.at, "three.t": as_term(3)}
            steps.append(step._replace(proof=step.proof._replace(at=at)))
        else:
            steps.append(step)
    wrong = outcome._replace(steps=tuple(steps))  # type: ignore[arg-type]
    assert report(wrong).verdict == "REFUSED"


# --- the collapse on a line, again, by numbers ----------------------------------------------------


def test_the_orbit_on_the_line_is_that_of_the_mapping() -> None:
    """Ten collisions in rational numbers; nothing of the mapping's equations is used."""
    r, positions = Fraction(1, 20), [Fraction(0), Fraction(1), Fraction(-2)]
    speeds = [Fraction(0), Fraction(1, 8), Fraction(1)]
    colliding, time = 2, Fraction(0)
    for n in range(10):
        side = 1 if colliding == 1 else -1
        gap = side * (positions[colliding] - positions[0]) - 1
        closing = -side * (speeds[colliding] - speeds[0])
        assert gap == Fraction(1, 8) ** n
        assert closing == Fraction(2, 5) ** n
        assert 11 * time * closing + 16 * gap == 16 * closing
        step = gap / closing
        time += step
        positions = [x + step * v for x, v in zip(positions, speeds, strict=True)]
        change = (1 + r) / 2 * (speeds[0] - speeds[colliding])
        speeds[0], speeds[colliding] = speeds[0] - change, speeds[colliding] + change
        colliding = 3 - colliding
    assert time < Fraction(16, 11)


@pytest.mark.parametrize("n", range(5))
def test_the_line_satisfies_what_the_mapping_assumes(n: int) -> None:
    """Balls 1 and 2 are on opposite sides of 0, and vectors on the line are numbers."""
    y, d = Fraction(2, 5) ** n, Fraction(1, 8) ** n
    omega_1, omega_2, W_1, W_2, r = 1, -1, y / 8, y, Fraction(1, 20)
    at = Variables(PAGE, "map").at(
        r=r, d=d, y=y, eta=omega_1 * W_1, cos=omega_1 * omega_2, a=omega_1 * W_2, b=omega_2 * W_1,
        A=W_2**2, B=W_1**2, w=W_1 * W_2, S=1 / (1 + d), tau=d / y, D=1 + d / 8, p_1=0, p_2=0,
        q_1=0, q_2=0,
    )  # fmt: skip
    assert [g.name for g in context(PAGE, "map").givens if not holds(g.claim, at)] == []


def test_the_energy_bound_is_missed_by_far() -> None:
    """The left side of the misprint exceeds the right one; four times the energy suffices."""
    at, claim = dict(WRONG["change-bound"]), ROWS["change-bound"].claim
    assert isinstance(claim, Claim)
    assert value(claim.lhs, at) > 2 * value(claim.rhs, at)
    a_x, a_y, b_x, b_y, c_x, c_y = (
        value(at[f"plane.{name}"], {}) for name in ("a_x", "a_y", "b_x", "b_y", "c_x", "c_y")
    )
    speed = (b_x - a_x) ** 2 + (b_y - a_y) ** 2
    energy = (a_x**2 + a_y**2 + b_x**2 + b_y**2 + c_x**2 + c_y**2) / 2
    assert 3 * energy <= speed * Fraction(1001, 1000)
    assert speed <= 4 * energy


# --- what is refused ------------------------------------------------------------------------------


#: Mutants that are true: these two numbers are 0, whatever their letters and sign are.
TRUE = {
    f"{name}.{kind}"
    for name in ("line-tangential", "tangential-orthogonal")
    for kind in ("sign", "index")
}


MUTANTS = changed_claims(PAGE).keys() - TRUE


@pytest.mark.parametrize("name", sorted(MUTANTS))
def test_a_wrong_claim_is_refused(name: str) -> None:
    assert name in refused(PAGE)


def test_there_are_many_wrong_claims() -> None:
    assert len(MUTANTS) > 250


def test_a_substituted_claim_is_the_claim_at_the_point() -> None:
    """The helper of these tests evaluates as the program substitutes."""
    for name, at in WRONG.items():
        claim = ROWS[name].claim
        assert isinstance(claim, Claim)
        if not CONTEXTS[str(ROWS[name].context)].constants:
            assert holds(substitute_claim(claim, at), {}) is holds(claim, dict(at))
