"""The classification for any masses: accepted as it is, refused with anything changed, and true."""

from __future__ import annotations

from fractions import Fraction
from random import Random

import mpmath
import pytest

from tests.paper.changed_statements import answer, changed, without
from verify.language.statement import PROVED
from verify.language.terms import Claim
from verify.paper.commands.pages import content, decide, page
from verify.prover.budget import WorkBudget
from verify.prover.outcome import Outcome
from verify.wire.questions import decide_page
from verify.wire.text.read_page import read_page

PAGE = "classification_of_balls"
STATEMENT = page(PAGE).statement
#: What the theorems on concrete balls ask for.
APPLIED = {
    name: claim
    for context in ("excluded", "rests", "deadline", "touching")
    for name, claim in STATEMENT.context(context).claims.items()
}
#: What only the sentences use: t is the cube root of r_1 r_2, or less.
OF_SENTENCES = {"rests-r-1", "rests-r-2", "rests-t", "rests-t-most", "rests-cube"}
#: Rows with a wrong sign, index or factor: what is written, and what stands there instead.
LIES = {
    "two-steps": ("- e*f*u_1", "+ e*f*u_1"),
    "impact-share": ("m_1/(m + m_1)*h", "m/(m + m_1)*h"),
    "never-in-the-middle": ("2*sqrt(r_1*r_2)", "sqrt(r_1*r_2)"),
    "rests-in-the-middle": ("< t + t^2", "< t^2 + t^3"),
    "second-growth": ("e*f/t/t/t", "e*f/t/t/t/t"),
    "second-falls": ("R - t^3", "R - t^2"),
    "second-speed": ("A*tau <= D*y", "A*tau <= c*y"),
    "second-law": ("k*l*C_next", "l*l*C_next"),
    "ratio-falls": ("2*s - d", "2*s"),
    "scene-radicand": ("A^2*R", "A^2"),
    "spread-law": ("dot(z - y, z - y)", "dot(z + y, z + y)"),
    "spread-at-collapse": ("(s_1 + s_2)^2", "(s_1^2 + s_2^2)"),
}


def decided() -> Outcome:
    """The theorem, with the verdict of the checker."""
    return decide(PAGE)


@pytest.mark.parametrize("name", sorted(APPLIED.keys() - OF_SENTENCES))
def test_each_given_is_used(name: str) -> None:
    assert answer(without(decided(), name)) in {"REFUSED", "MALFORMED"}


@pytest.mark.parametrize("name", ["excluded-share", "excluded-root", "rests-share"])
def test_a_weaker_given_is_refused(name: str) -> None:
    claim = APPLIED[name]
    weaker = Claim(claim.relation, claim.lhs, claim.rhs + Fraction(1, 10**6))
    assert answer(changed(decided(), name, weaker)) == "REFUSED"


def test_lies_are_not_proved() -> None:
    text, end = content(PAGE).decode(), ""
    for name, (right, wrong) in LIES.items():
        before, found, rest = text.partition(f"\n{name}: ")
        claim, end, after = rest.partition(";")
        assert found
        assert end
        assert claim.count(right) == 1, name
        text = before + found + claim.replace(right, wrong) + end + after
    lying = read_page("a", text.encode(), (), lambda _: b"")
    verdicts = {row.name: found.claimed for row, found in decide_page(lying, WorkBudget()).rows}
    assert [name for name in LIES if verdicts[name] == PROVED] == []
    assert sum(verdict == PROVED for verdict in verdicts.values()) > 15


# --- true ----------------------------------------------------------------------------------------


def test_runs_of_the_recursion_end_where_the_theorem_says_so() -> None:
    """Ratios of speeds on a line, p' = b - r/p with r in turn: endless just if b >= √r + √r'."""
    rng, ended = Random(3), 0
    with mpmath.workdps(60):
        for _ in range(300):
            one, two = (mpmath.mpf(rng.uniform(0.01, 1)) for _ in "ab")
            side = rng.choice((-1, 1))
            b = (mpmath.sqrt(one) + mpmath.sqrt(two)) * (1 + side * mpmath.mpf("0.001"))
            p, count = b, 0
            while p > 0 and count < 10_000:
                p, count = b - (one, two)[count % 2] / p, count + 1
            assert (p <= 0) == (side < 0)
            ended += p <= 0
    assert ended > 100


def test_the_second_condition_of_the_limit_map() -> None:
    """With u = 0 the stable cycle has p p' = z; two steps multiply a small u by rr'/z³."""
    rng = Random(4)
    with mpmath.workdps(60):
        for _ in range(300):
            one, two = (mpmath.mpf(rng.uniform(0.001, 0.9)) for _ in "ab")
            t, side = mpmath.cbrt(one * two), rng.choice((-1, 1))
            d = (t + t * t) * (1 + side * mpmath.mpf("0.0001"))
            root = d * d - 4 * one * two
            if root < 0:
                assert side < 0
                continue
            z = (d + mpmath.sqrt(root)) / 2
            assert (one * two / z**3 < 1) == (side > 0)
