"""What is printed and false: accepted with its states, refused with any other, and fair."""

from __future__ import annotations

from collections.abc import Mapping
from fractions import Fraction
from pathlib import Path

import pytest
from flint import fmpq

from tests.paper.changed_statements import report
from verify import check
from verify.language.argument import ByWitness, Line
from verify.language.statement import PRINTED, PROVED, REFUTED, Obligation
from verify.language.terms import Claim, Term, as_term
from verify.paper.commands import pages
from verify.paper.commands.pages import page
from verify.paper.commands.regenerate import is_right_statement
from verify.paper.parameters import PARAMETERS
from verify.paper.theorem1 import theorem
from verify.prover.outcome import Outcome
from verify.prover.rules import Witness
from verify.wire.read import read
from verify.wire.write import write

from . import second_estimates
from .printed_states import DECAY, VECTORS, WITNESSES, state
from .second_constants import Constants, hypothesis
from .second_reading import READINGS, Place, State, dot, holds, links
from .states import STEP

ROOT = Path(check.__file__).parents[1]
CONTEXT = "printed-state"


def printed() -> list[Obligation]:
    """The rows of the page that are false."""
    return [row for row in page("step_as_printed").statement.obligations if row.severity]


def states() -> dict[str, Mapping[str, Term]]:
    """The state of each line that is false at one."""
    lines = (item for part in page("step_as_printed").chapters for item in part.items)
    return {
        line.name: line.reason.at
        for line in lines
        if isinstance(line, Line) and isinstance(line.reason, ByWitness)
    }


#: The second reading's lines that are false where these rows are refuted.
SAME_LINES = {
    "law-norm-c": "law of |W_c|^2",
    "d-index": "bound on d_n",
    "time-square": "tau / (-eta_c) by zeta^2",
    "x-small": "x_n is small",
    "term-2-sign": "second term of zeta_{n+1}",
    "term-2": "second term of zeta_{n+1}",
    "three-terms": "three remainder terms",
    "zeta-falls": "zeta_{n+1} <= (1 - h_5/4) zeta_n",
    "angle-equation": "step of the angle",
    "angle-sign": "step of the angle",
}


def rational(term: Term) -> fmpq:
    return fmpq(term.value.numerator, term.value.denominator)


def place(name: str) -> Place:
    """The state of a witness, for the second reading."""
    found = {key: rational(x) for key, x in state(WITNESSES[name]).items()}
    vectors = {v: [found[f"{v}_{i}"] for i in "123"] for v in VECTORS}
    values = [rational(page("step_as_printed").statement.parameters[p]) for p in PARAMETERS]
    r, c, V_0, delta_theta = values
    return Place(r, State(d=found["d"], **vectors), Constants(r, c, delta_theta, V_0))


def test_every_printed_row_is_refuted_and_every_other_proved() -> None:
    outcome = pages.decide("step_as_printed")
    files = write(outcome)
    found = check.check(files["statement.json"], files["certificate.json"], {})
    assert found.verdict == "PROVED"
    assert read(files["statement.json"], files["certificate.json"], {}) == outcome.draft
    assert not outcome.assumptions
    for row, decision in outcome.rows:
        assert decision.verdict == (REFUTED if row.severity else PROVED), row.name


def test_each_is_corrected_by_a_row_that_is_proved_elsewhere() -> None:
    known = {row.name for row in STEP.obligations}
    known |= {row.name for part in theorem().parts.values() for row in part.obligations}
    for row in printed():
        assert row.corrected_by in known, row.name
        assert row.corrected_by != row.name


def test_what_is_proved_here_has_the_names_and_labels_of_the_step() -> None:
    labels = {row.name: row.label for row in STEP.obligations}
    for row in page("step_as_printed").statement.obligations:
        if not row.severity and not row.name.startswith("angle"):
            assert labels[row.name] == row.label


# --- fair -----------------------------------------------------------------------------------------


@pytest.mark.parametrize("name", WITNESSES)
def test_a_second_reader_allows_the_states(name: str) -> None:
    """All conditions hold for the reader's own vectors, collision and constants."""
    q = place(name)
    for label, parts in hypothesis(q).items():
        assert all(holds(*part) for part in parts), label
    assert second_estimates.SAID


@pytest.mark.parametrize("name", WITNESSES)
def test_the_numbers_of_a_state_are_those_of_its_collision(name: str) -> None:
    q, found = place(name), state(WITNESSES[name])
    assert q.n.tau == rational(found["tau"])
    assert q.n.still == rational(found["S"])
    assert 1 + q.m.d == rational(found["D"])
    n = WITNESSES[name].n
    assert found["decay"].value == Fraction(DECAY) ** n
    assert q.K.C_eta == fmpq(*Fraction(DECAY).as_integer_ratio())
    assert all(dot(v, v) == 1 for v in (q.n.omega_s, q.n.omega_c, q.m.omega_s, q.m.omega_c))


def test_the_second_reader_finds_the_same_lines_wrong_at_these_states() -> None:
    for row, line in SAME_LINES.items():
        (at,) = (name for name, n in WITNESSES.items() if state(n) == states()[f"state.{row}"])
        q, reading = place(at), READINGS[line]
        assert reading.view == "wrong"
        assert any(holds(*part) is False for part in reading.parts(q)), row
        if reading.instead is not None:
            assert all(holds(*part) is not False for part in links(reading.instead(q))), row


def test_every_state_refutes_a_row_and_is_computed_from_its_few_numbers() -> None:
    assert {*states()} == {row.name for row in printed()}
    used = {name for at in states().values() for name, n in WITNESSES.items() if state(n) == at}
    assert used == {*WITNESSES}
    assert all(at in map(state, WITNESSES.values()) for at in states().values())
    assert page("step_as_printed").statement.context(CONTEXT).point in states().values()


def test_its_constants_are_the_printed_ones() -> None:
    part = theorem().parts[PRINTED]
    assert page("step_as_printed").statement.constants == (*theorem().common, *part.bounds)


def test_a_state_in_the_plane_has_no_third_coordinate() -> None:
    for name, numbers in WITNESSES.items():
        third = {v: state(numbers)[f"{v}_3"].value for v in VECTORS}
        assert any(third.values()) == (name == "space")


# --- refused --------------------------------------------------------------------------------------


def changed(row: str, claim: Claim) -> Outcome:
    """The same with another claim in place of a refuted one."""
    outcome = pages.decide("step_as_printed")
    rows = tuple(
        old._replace(claim=claim) if old.name == row else old
        for old in outcome.statement.obligations
    )
    return outcome._replace(statement=outcome.statement._replace(obligations=rows))


def test_what_is_right_is_not_refuted_by_the_same_state() -> None:
    claims = {row.name: row.claim for row in pages.decide("step_as_printed").statement.obligations}
    rights = ("law-norm-c", "distance", "time-product", "angle-step-upper")
    wrongs = ("law-norm-c", "d-index", "time-square", "angle-sign")
    for right, wrong in zip(rights, wrongs, strict=True):
        claim = claims[right]
        assert isinstance(claim, Claim)
        upper = Claim("<=", claim.lhs, claim.rhs)
        assert report(changed(f"state.{wrong}", upper)).verdict == "REFUSED", right


@pytest.mark.parametrize("name", ["d", "tau", "W_s_2", "omega_c_1", "decay", "S", "D"])
def test_another_state_is_refused(name: str) -> None:
    outcome = pages.decide("step_as_printed")
    found = []
    for old in outcome.steps:
        proof = getattr(old, "proof", None)
        if isinstance(proof, Witness):
            number = proof.at[name].value
            at = {**proof.at, name: as_term(number * 2 + Fraction(1, 10))}
            old = old._replace(proof=proof._replace(at=at))
        found.append(old)
    assert report(outcome._replace(steps=tuple(found))).verdict == "REFUSED"


def test_a_statement_with_fewer_rows_is_another_one() -> None:
    outcome = pages.decide("step_as_printed")
    statement = outcome.statement
    fewer = outcome._replace(statement=statement._replace(obligations=statement.obligations[:-1]))
    assert not is_right_statement(write(fewer)["statement.json"])
