"""Where printed rows hold that depend on the parameters: accepted, and true at random points."""

from __future__ import annotations

import random
from collections.abc import Iterator
from fractions import Fraction

import pytest

from tests.paper.changed_statements import report
from verify.cli import main
from verify.language.fold import fails, holds
from verify.language.statement import PROVED, REFUTED, UNDECIDED
from verify.language.terms import Claim, Term
from verify.paper.commands import pages
from verify.paper.commands import thresholds as paper
from verify.paper.commands.thresholds import shares
from verify.paper.parameters import PRINTED
from verify.paper.theorem1 import theorem
from verify.prover import balls
from verify.prover.balls import BallArithmetic
from verify.prover.outcome import Decision
from verify.prover.program import Machine, Program
from verify.prover.proof import LemmaStep
from verify.views.all_parameters import LEFT_OPEN
from verify.wire.text.read_page import read_page


def test_every_strip_is_a_row_of_the_statement() -> None:
    names = {row.name for row in pages.decide("thresholds").statement.obligations}
    assert {strip.by for strip in paper.STRIPS} <= names
    for strip in paper.STRIPS:
        assert strip.low < strip.high


def test_little_is_undecided() -> None:
    for row in dict.fromkeys(strip.row for strip in paper.STRIPS):
        found = dict(shares(row, pages.decide("thresholds")))
        assert found[UNDECIDED][1] < Fraction(1, 10000)
        low, high = found.pop(LEFT_OPEN, (Fraction(0), Fraction(0)))
        assert high - low <= paper.STRIP
        assert (low, high) == (Fraction(0), Fraction(0)) or high == paper.DRIFT_ENDS
        assert sum(low for low, _ in found.values()) <= 1 <= sum(high for _, high in found.values())


def test_what_is_left_open_is_said(capsys: pytest.CaptureFixture[str]) -> None:
    assert main(["theorem1", "--all", "--constants", "printed"]) == 1
    said = " ".join(capsys.readouterr().out.split())
    assert "nothing is proved where 5/33 - 10⁻⁵ ≤ φ⁺ < 5/33" in said


def test_the_share_of_a_strip_that_is_not_proved_is_undecided() -> None:
    outcome = pages.decide("thresholds")
    lost = {**outcome.decisions, "angle-absorbed.fails": Decision(UNDECIDED)}
    before = shares("angle-absorbed", outcome)
    found = shares("angle-absorbed", outcome._replace(decisions=lost))
    assert found[REFUTED] == (0, 0) != before[REFUTED]
    assert found[UNDECIDED][1] > Fraction(1, 10) > before[UNDECIDED][1]


def points() -> Iterator[tuple[Fraction, tuple[Fraction, ...]]]:
    """Values of phi_plus, with r and c, anywhere in the chart and next to the thresholds."""
    chosen = random.Random(7)
    near = [paper.DRIFT_ENDS, paper.SLOPE_STARTS]
    tiny = Fraction(1, 10**6)
    ends = [x + sign * (paper.STRIP + tiny) for x in near for sign in (-1, 1)]
    ends += [paper.DRIFT_ENDS, paper.SLOPE_STARTS + tiny, paper.SLOPE_STARTS - tiny]
    for _ in range(60):
        p = chosen.choice([*ends, Fraction(chosen.randrange(1, 500), 1000)])
        u = chosen.choice([Fraction(chosen.randrange(1, 1000), 1000), tiny, 1 - tiny])
        r, c = u * p**3, 2 * (p + u * p**2) / (1 + u * p**3)
        if c <= 1:
            yield p, (r, c)


def test_at_the_threshold_itself_the_row_holds() -> None:
    """There both sides may be equal; the statement says so of all values from 1/22 on."""
    known_rows = pages.statement("thresholds").obligations
    rows = (*known_rows, *theorem().parts[PRINTED].obligations)
    claims = {row.name: row.claim for row in rows}
    known, printed = claims["x-term-1-d.holds"], claims[f"{PRINTED}.x-term-1-d"]
    assert isinstance(known, Claim)
    assert isinstance(printed, Claim)
    assert known.relation == printed.relation == "<="
    with balls.precision(300):
        run, (x, y, a, b) = machine([printed.lhs, printed.rhs, known.lhs, known.rhs])
        p, u = paper.SLOPE_STARTS, Fraction(1, 10)
        r, c = u * p**3, 2 * (p + u * p**2) / (1 + u * p**3)
        for delta in (Fraction(1, 10), Fraction(1, 10**9)):
            values = run.run(list(map(balls.from_fraction, (r, c, Fraction(1), delta)))).values
            for own, of_row in ((a, x), (b, y)):
                low, high = balls.ends(values[own] / values[of_row])
                assert low <= 1 <= high < 1 + Fraction(1, 10**60)


def machine(terms: list[Term]) -> tuple[Machine, list[int]]:
    program = Program(("r", "c", "V_0", "delta_theta"))
    for constant in pages.decide("thresholds").statement.contexts[0].constants:
        program.define(constant.name, constant.term)
    return Machine(program, BallArithmetic()), [program.add(term) for term in terms]


def test_the_strips_tell_the_verdicts_of_the_printed_rows() -> None:
    rows = {row.name: row.claim for row in theorem().parts[PRINTED].obligations}
    seen = set()
    for name in dict.fromkeys(strip.row for strip in paper.STRIPS):
        claim = rows[f"{PRINTED}.{name}"]
        assert isinstance(claim, Claim)
        with balls.precision(300):
            run, (x, y) = machine([claim.lhs, claim.rhs])
            for p, (r, c) in points():
                data = map(balls.from_fraction, (r, c, Fraction(1), Fraction(1, 10)))
                values = run.run(list(data)).values
                for strip in paper.STRIPS:
                    if strip.row == name and strip.low < p < strip.high:
                        decide = holds if strip.verdict == PROVED else fails
                        assert decide(claim.relation, values[x], values[y]), (name, p)
                        seen.add((name, strip.verdict))
    assert len(seen) == len(paper.STRIPS)


def test_every_fact_holds_at_random_parameters() -> None:
    claims = {
        item.name: item.claim
        for item in pages.decide("thresholds").steps
        if isinstance(item, LemmaStep) and item.context is not None
    }
    claims |= {
        row.name: row.claim
        for row in pages.decide("thresholds").statement.obligations
        if isinstance(row.claim, Claim)
    }
    chosen = random.Random(11)
    with balls.precision(600):
        run, slots = machine([side for claim in claims.values() for side in claim.key[1:]])
        for _, (r, c) in points():
            v_0 = chosen.choice([Fraction(1, 16), Fraction(1), Fraction(10) ** chosen.randrange(7)])
            delta = Fraction(10) ** chosen.randrange(-6, 2)
            values = run.run(list(map(balls.from_fraction, (r, c, v_0, delta)))).values
            for number, (name, claim) in enumerate(claims.items()):
                x, y = slots[2 * number : 2 * number + 2]
                assert not fails(claim.relation, values[x], values[y]), name


@pytest.mark.parametrize(
    ("old", "new", "rows"),
    [
        ("5/33 - p", "(5/33 - 1/5000) - p", 2),
        ("p - 499967/3300000", "p - (499967/3300000 + 1/5000)", 2),
        ("4*(h_4*printed.delta_x/8)", "(88/23)*(h_4*printed.delta_x/8)", 1),
        ("28.00033", "28.000001", 1),
        ("1/37", "1/40", 1),
    ],
)
def test_other_thresholds_are_refused(old: str, new: str, rows: int) -> None:
    """The same proofs do not prove rows with another number in the place of a threshold."""
    outcome = pages.decide("thresholds")
    text = pages.content("thresholds").decode()
    changed = read_page(
        f"{pages.FOLDER}/thresholds.toml", text.replace(old, new).encode()
    ).statement
    pairs = zip(outcome.statement.obligations, changed.obligations, strict=True)
    assert sum(one.claim != other.claim for one, other in pairs) >= rows
    assert report(outcome._replace(statement=changed)).verdict == "REFUSED"
