"""Theorem 1 on boxes of parameters: corners decide, and the checker accepts it."""

from __future__ import annotations

import random
from fractions import Fraction
from hashlib import sha256

import pytest

from verify import check
from verify.language.fold import holds
from verify.language.statement import PROVED, REFUTED, UNDECIDED
from verify.language.terms import Claim, Term, as_term
from verify.paper import box as paper
from verify.paper.commands.box import (
    ParameterBox,
    answer,
    are_ends,
    decide_box,
    largest_part,
    read_box,
    verdict,
)
from verify.paper.commands.regenerate import is_right_statement
from verify.paper.theorem1 import theorem
from verify.prover.outcome import Outcome
from verify.prover.program import ExactArithmetic, Machine, Program
from verify.wire.read import read as read_files
from verify.wire.write import write

V_0, DELTA = Fraction(1), Fraction(1, 10)


def box(*ends: str) -> ParameterBox:
    a, b, c, d = map(Fraction, ends)
    return ParameterBox((a, b), (c, d))


HOLDS = box("0.02", "0.04", "0.97", "1")
FAILS = box("0.06", "0.08", "0.5", "1")
MIXED = box("0.02", "0.08", "0.9", "1")
#: Boxes with a corner at which both sides of the stability condition are equal.
TOUCHING = box("1/64", "1/2", "1/100", "8/13")
NEARLY = box("1/128", "1/64", "8/13", "1")


def report(outcome: Outcome) -> check.Report:
    files = write(outcome)
    cited = {sha256(d).hexdigest(): d for name, d in files.items() if name.startswith("cited/")}
    assert read_files(files["statement.json"], files["certificate.json"], cited) == outcome.draft
    return check.check(files["statement.json"], files["certificate.json"], cited)


@pytest.mark.parametrize(
    ("some", "expected"), [(HOLDS, PROVED), (FAILS, REFUTED), (TOUCHING, REFUTED)]
)
def test_the_checker_agrees(some: ParameterBox, expected: str) -> None:
    outcome = decide_box(some, V_0, DELTA)
    assert verdict(some) == outcome.verdict == expected
    assert report(outcome).verdict == expected.upper()


def test_the_certified_part_of_an_undecided_box() -> None:
    for some in (MIXED, NEARLY):
        found = answer(some, V_0, DELTA)
        assert found.verdict == UNDECIDED
        assert report(found.outcome).verdict == "PROVED"
        for inner, outer in zip(found.part, some, strict=True):
            assert outer[0] <= inner[0] <= inner[1] <= outer[1]
        assert found.part.area > some.area / 10
    with pytest.raises(ValueError, match="part"):
        decide_box(MIXED, V_0, DELTA)


def test_with_one_r_the_certified_part_begins_next_to_the_threshold() -> None:
    r, threshold = Fraction(1, 64), Fraction(8, 13)
    part = largest_part(ParameterBox((r, r), (threshold, Fraction(1))))
    assert part.r == (r, r)
    assert part.c[1] == 1
    assert threshold < part.c[0] < threshold + Fraction(1, 10**8)
    assert verdict(part) == PROVED


def test_random_boxes_against_the_hypothesis_itself() -> None:
    """No point of a box has another verdict than the box, and undecided boxes have both."""
    chosen = random.Random(5)
    claim = next(
        row.claim
        for row in theorem().parts["hypotheses"].obligations
        if row.name == paper.STABILITY
    )
    assert isinstance(claim, Claim)
    relation, *terms = claim.key
    program = Program(("r", "c"))
    sides = [program.add(term) for term in terms]
    machine = Machine(program, ExactArithmetic())

    def stable(r: Fraction, c: Fraction) -> bool:
        values = machine.run([r, c]).values
        return holds(relation, values[sides[0]], values[sides[1]])

    seen = set()
    for _ in range(200):
        r = sorted(Fraction(chosen.randrange(1, 999), 1000) ** 3 for _ in range(2))
        c = sorted(Fraction(chosen.randrange(1, 1001), 1000) for _ in range(2))
        some = ParameterBox((r[0], r[1]), (c[0], c[1]))
        share = [Fraction(k, 4) for k in range(5)]
        points = [
            (r[0] + (r[1] - r[0]) * x, c[0] + (c[1] - c[0]) * y) for x in share for y in share
        ]
        found = {stable(*point) for point in points}
        seen.add(verdict(some))
        assert found == {PROVED: {True}, REFUTED: {False}, UNDECIDED: {True, False}}[verdict(some)]
        if verdict(some) == UNDECIDED:
            part = largest_part(some)
            assert stable(part.r[1], part.c[0])
    assert seen == {PROVED, REFUTED, UNDECIDED}


def test_the_statement_is_the_one_that_the_program_makes() -> None:
    content = write(decide_box(HOLDS, V_0, DELTA))["statement.json"]
    assert is_right_statement(content)
    assert not is_right_statement(content.replace(b'"c_low": "97/100"', b'"c_low": "1/100"'))
    assert not is_right_statement(write(decide_box(FAILS, V_0, DELTA))["statement.json"])


def test_what_the_ends_of_a_box_may_be() -> None:
    ends: dict[str, Term] = dict(decide_box(HOLDS, V_0, DELTA).statement.parameters)
    assert read_box(ends) == (HOLDS, V_0, DELTA)
    assert are_ends(ends)
    for name, value in (("r_low", 0), ("r_low", 1), ("c_high", 2), ("V_0", 0), ("c_low", -1)):
        assert not are_ends({**ends, name: as_term(value)}), name
    assert not are_ends({**ends, "c_low": -as_term(1)})
    assert not are_ends({"r": as_term(1)})


def test_a_larger_box_is_refused() -> None:
    """The certificate of a box does not prove the same of a larger one."""
    outcome = decide_box(HOLDS, V_0, DELTA)
    parameters = {**outcome.statement.parameters, "r_high": as_term(Fraction(1, 10))}
    statement = outcome.statement._replace(parameters=parameters)
    lies = outcome._replace(statement=statement, enclosures={
        **outcome.enclosures, "r_high": outcome.enclosures["V_0"]._replace(
            ends=((Fraction(1, 10), Fraction(1, 10)),))})  # fmt: skip
    assert report(lies).verdict == "REFUSED"
