"""Theorems of the paper: accepted as they are, refused with anything missing or changed."""

from __future__ import annotations

import re
from collections import Counter
from fractions import Fraction
from typing import NamedTuple

import pytest
from flint import arb

from tests.citing import cited
from tests.paper.changed_statements import (
    accepted_lies,
    answer,
    changed,
    claim_of,
    fewer,
    report,
    standing,
    stronger,
    without,
)
from tests.paper.sandwich.states import holds
from verify.language.statement import PROVED
from verify.language.terms import Claim
from verify.paper.commands import pages
from verify.paper.commands.regenerate import is_right_statement
from verify.prover import balls
from verify.prover.proof import LemmaStep
from verify.wire.packaged import PAGES
from verify.wire.read import read
from verify.wire.write import write

#: For each theorem how many bytes its files have at most.
SMALL = {
    "step": 200_000,
    "sharper": 120_000,
    "sandwich_below": 150_000,
    "sandwich_above": 120_000,
    "three_balls": 200_000,
    "classification": 150_000,
    "classification_of_balls": 100_000,
    "alexander": 160_000,
    "flow_of_balls": 150_000,
    "spectrum": 260_000,
    "thresholds": 100_000,
}
#: How many definitions, sentences of general mathematics, and pieces of glue each assumes.
ASSUMED = {
    "step": (1, 4, 4),
    "sharper": (1, 3, 3),
    "sandwich_below": (2, 3, 4),
    "sandwich_above": (2, 1, 3),
    "three_balls": (2, 3, 4),
    "classification": (2, 4, 8),
    "classification_of_balls": (2, 1, 5),
    "alexander": (2, 3, 6),
    "separatrix": (2, 1, 3),
    "sections_1_to_4": (0, 1, 3),
}
KINDS = ("definition", "general mathematics", "numbered glue")
#: Words of the glue that are no names.
PROSE = {"n-th", "so-called", "inside-", "a-F", "s-q"}
#: The page of which the glue of another one names rows.
NAMED = {"sections_1_to_4": "classification", "alexander": "classification_of_balls"}
#: How many sums without one of their addends there are at least; what is left of an inequality of
#: vectors is too long for the checker.
SUMS = {
    "step": 500,
    "sharper": 300,
    "sandwich_below": 250,
    "sandwich_above": 250,
    "three_balls": 250,
    "classification": 150,
    "alexander": 150,
    "sections_1_to_4": 80,
    "all_parameters": 400,
    "separatrix": 250,
}


@pytest.mark.parametrize("name", sorted(PAGES))
def test_a_theorem_is_proved_and_small_and_the_program_s_own(name: str) -> None:
    outcome = pages.decide(name)
    files = write(outcome)
    assert report(outcome).verdict == "PROVED"
    assert outcome.verdict == PROVED
    own = [files["statement.json"], files["certificate.json"]]
    assert sum(map(len, own)) < SMALL.get(name, 10**6)
    assert read(*own, cited(files)) == outcome.draft
    assert is_right_statement(own[0]) == (name != "printed_rows")  # whose set is not repaired


@pytest.mark.parametrize("name", ASSUMED)
def test_what_is_assumed(name: str) -> None:
    kinds = Counter(assumption.kind for assumption in pages.statement(name).assumptions)
    assert tuple(kinds[kind] for kind in KINDS) == ASSUMED[name]
    assert {*kinds} <= {*KINDS}


@pytest.mark.parametrize("name", ASSUMED)
def test_glue_names_facts_that_are_there(name: str) -> None:
    statement = pages.statement(name)
    known = {given.name for context in statement.contexts for given in context.givens}
    known |= {context.name for context in statement.contexts}
    known |= {step.name for step in pages.decide(name).steps if isinstance(step, LemmaStep)}
    known |= {assumption.name for assumption in statement.assumptions}
    for page in (name, NAMED.get(name, name)):
        known |= {row.name for row in pages.statement(page).obligations}
    glue = [a.sentence for a in statement.assumptions if a.kind == "numbered glue"]
    assert [sentence.split(". ")[0] for sentence in glue] == [
        str(number) for number, _ in enumerate(glue, 1)
    ]
    named = {
        word
        for sentence in glue
        for word in re.findall(r"(?<![-\w])[a-z]+(?:-[A-Za-z]+)+(?![-\w])", sentence)
    }
    assert len(named) > 2 * len(glue)
    assert named - known <= PROSE


@pytest.mark.parametrize("name", SUMS)
def test_a_sum_without_one_of_its_addends_is_refused(name: str) -> None:
    count, accepted = accepted_lies(pages.decide(name), 4, fewer, ("tau",))
    assert count > SUMS[name]
    assert accepted == set()


@pytest.mark.parametrize("name", ["step", "sharper"])
def test_a_stronger_claim_is_refused(name: str) -> None:
    assert accepted_lies(pages.decide(name), 1, stronger)[1] == set()


# --- collisions that never end --------------------------------------------------------------------


class Collapse(NamedTuple):
    """A theorem on what follows from a state and numbers: which other statements are false."""

    contexts: tuple[str, ...]  # all of whose givens are used
    mutants: dict[str, tuple[str, str]]
    sharp: tuple[str, ...] = ()  # givens that hold with equality at the point


#: Theorems as they might be miswritten: a factor, a sign, a power, an index, what is forgotten.
SHARPER: dict[str, tuple[str, str]] = {
    "half-forgotten": (
        "y-upper-room",
        "(1 + k*eta_0^2)^2*(C_0 + Theta)*r <= (p + Y)*(1 + k*eta_0^2)",
    ),
    "reach-once": (
        "y-upper-room",
        "(1 + r)/2*(1 + k*eta_0^2)*(C_0 + Theta) <= (p + Y)*(1 + k*eta_0^2) + (m - X)",
    ),
    "upper-of-q-for-lower": (
        "y-upper-room",
        "(1 + r)/2*(1 + k*eta_0^2)^2*(C_0 + Theta) <= (p + Y)*(1 + k*eta_0^2) + (m + X)",
    ),
    "lower-of-q-for-upper": (
        "y-lower-room",
        "p - Y <= (1 + r)/2*(1 - T*V^2)*(C_0 - Theta) - (m - X) - T*V^2",
    ),
    "gain-forgotten": ("y-lower-room", "p - Y <= (1 + r)/2*(1 - T*V^2)*(C_0 - Theta) - (m + X)"),
    "sign-of-the-angle": (
        "y-lower-room",
        "p - Y <= (1 + r)/2*(1 - T*V^2)*(C_0 + Theta) - (m + X) - T*V^2",
    ),
    "least-for-greatest": ("x-upper-room", "r*(1 + k*eta_0^2) <= (m + X)*(p + Y)"),
    "greatest-for-least": ("x-lower-room", "(m - X)*(p - Y) <= r*(1 - T*V^2)"),
    "root-forgotten": ("x-lower-room", "(m - X)*(p + Y) <= r"),
    "square-of-the-time": ("d-room", "(m + X)*T <= k*(p - Y)^2"),
    "power-of-the-ratio": ("d-room", "(m + X)*T + V^2*T^2/2 <= k*(p - Y)"),
    "one-for-two": ("time-room", "k <= T*(2 - T*V^2)"),
    "time-of-no-root": ("time-room", "2*k <= 2*T"),
    "series-forgotten": ("speed-room", "(1 + r)/2*(1 + k*eta_0^2)*eta_0 <= V - V_0"),
    "one-way": ("start-C-upper", "C_start - C_0 <= Theta"),
    "slope-of-d": ("start-d-small", "d_start <= k*y_start"),
}
ABOVE: dict[str, tuple[str, str]] = {
    "the-other-speed": (
        "start-u",
        "U_0*(2 - U_0)*(1 + d_start)^2*y_start^2 <= d_start*(2 + d_start)*w_0^2",
    ),
    "no-later-loss": ("start-B-least", "v_1^2 <= B_start"),
    "no-turning": ("start-C", "C_start <= C_p"),
    "reach-forgotten": ("start-reach", "y_start^2 <= v^2*(G^2 - 1)"),
    "share-forgotten": ("floor-rises-Q", "Q_next <= R*(1 - U_n)"),
    "power-of-P": (
        "floor-rises-U",
        "U_next*(2 - U_next)*(alpha*(1 - U_n) - Q_n - rho*U_n) <= rho*U_n*(2*Q_n + rho*U_n)",
    ),
    "twice-the-load": (
        "floor-rises-U",
        "U_next*(2 - U_next)*(alpha*(1 - U_n) - Q_n - rho*U_n)^2 <= 2*(rho*U_n*(2*Q_n + rho*U_n))",
    ),
    "grazing": ("floor-meets", "rho*U*(2*Q + rho*U) <= (alpha*(1 - U) - Q - rho*U)^2"),
    "once-only": ("meets-again", "0 <= y"),
}
EXCHANGED = """
    G*(w_0/w_1)^2*U_0*(2*Q_0 + G*(w_0/w_1)^2*U_0) <= U_b*(2 - U_b)*
    ((1 + r)/2*(C_0 - Theta)*(1 - U_0) - Q_0 - G*(w_0/w_1)^2*U_0)^2"""
BELOW: dict[str, tuple[str, str]] = {
    "the-other-speed": (
        "start-u",
        "d_start*(2 + d_start)*w_1^2 <= U_0*(2 - U_0)*(1 + d_start)^2*y_start^2",
    ),
    "one-for-two": (
        "start-u",
        "d_start*(1 + d_start)*w_0^2 <= U_0*(2 - U_0)*(1 + d_start)^2*y_start^2",
    ),
    "no-later-gain": ("start-B-most", "B_start <= w_1^2"),
    "no-turning": ("start-C-lower", "C_0 - C_start <= Theta"),
    "upper-angle": (
        "start-approaches",
        "0 < (1 + r)/2*(C_0 + Theta)*(1 - U_0) - Q_0 - G*(w_1/w_0)^2*U_0",
    ),
    "indices-exchanged": (
        "start-meets",
        EXCHANGED,
    ),
    "share-forgotten": ("stair-falls-Q", "R*(1 - U) <= Q_next"),
    "power-of-P": (
        "stair-falls-U",
        "rho*U*(2*Q + rho*U) <= U_next*(2 - U_next)*(alpha*(1 - U) - Q - rho*U)",
    ),
    "half-of-the-load": (
        "stair-falls-U",
        "rho*U*(2*Q + rho*U)/2 <= U_next*(2 - U_next)*(alpha*(1 - U) - Q - rho*U)^2",
    ),
}
THREE_BALLS: dict[str, tuple[str, str]] = {
    "the-other-speed": (
        "start-u",
        "d_start*(2 + d_start)*w_1^2 <= U_0*(2 - U_0)*(1 + d_start)^2*y_start^2",
    ),
    "the-other-share": ("fall_0", "G^2*beta_1 <= G*Y_0 + k_0"),
    "the-other-restitution": ("floor_0", "k_1*Y_0 <= r_1*(1 - U_b)"),
    "the-other-floor": ("floor_0", "k_0*Y_0 <= r_0*(1 - U_b)"),
    "the-other-mass": ("share_0", "beta_0*(m + m_1)*sigma_1 = (1 + r_0)*m_0*sigma_0"),
    "contacts-exchanged": ("share_0", "beta_0*(m + m_0)*sigma_0 = (1 + r_0)*m_0*sigma_1"),
    "one-step-decays": ("decay-positive", "0 < 1 - Y_0"),
    "larger-decay": ("decay-positive", "0 < 2 - Y_0*Y_1"),
    "no-later-time": ("rest_0", "G*U_b <= w_0^2*E_0"),
    "time-at-the-other-speed": ("rest_0", "G*U_b <= w_1^2*(E_0 - Y_0*E_1)"),
    "gain-of-the-other": ("start-B-most", "B_start <= (w_1 - beta_1*G/(1 - Y_0*Y_1)*y_start)^2"),
    "no-later-gain": ("start-B-most", "B_start <= w_1^2"),
    "no-turning": ("start-C-lower", "C_0 - C_start <= Theta"),
    "outer-pair-forgotten": ("outer", "sigma_12^2 < sigma_0^2 + sigma_1^2 + 2*sigma_0*sigma_1"),
    "outer-pair-at-the-centre": (
        "outer", "sigma_12^2 < sigma_0^2 + sigma_1^2 + 2*sigma_0*sigma_1*C_0",
    ),
    "blunt-angle-forgotten": ("obtuse", "Theta < C_0 + 1"),
    "q-at-first-too-small": ("start-least", "k_1*y_start <= eta_s_start"),
    "far-at-the-second": ("start-reach_1", "U_b*(2 - U_b)*(Y_0*y_start)^2 <= w_1^2*(G^2 - 1)"),
    "upper-angle": (
        "start-approaches",
        "0 < beta_0*(C_0 + Theta)*(1 - U_0) - Q_0 - G*(w_1/w_0)^2*U_0",
    ),
    "share-forgotten": ("stair-falls-Q", "R*(1 - U) <= Q_next"),
    "power-of-P": (
        "stair-falls-U",
        "rho*U*(2*Q + rho*U) <= U_next*(2 - U_next)*(alpha*(1 - U) - Q - rho*U)",
    ),
}  # fmt: skip

COLLAPSES = {
    "sharper": Collapse(("start",), SHARPER),
    "sandwich_above": Collapse(("start", "floor"), ABOVE, ("v_0-least", "v_1-least")),
    "sandwich_below": Collapse(("start", "stair", "orbit"), BELOW, ("w_0-least", "w_1-least")),
    "three_balls": Collapse(("start", "stair", "orbit"), THREE_BALLS),
}
#: What else is given, of each pair of vectors and each time.
MORE = {"sharper": ("s-upper", "t-lower", "t-upper")}


def givens(name: str) -> dict[str, Claim]:
    """What is given of the state and the numbers of a theorem."""
    return pages.statement(name).context("start").claims


ALL = [
    (name, given)
    for name, theorem in COLLAPSES.items()
    for given in (
        *(g for context in theorem.contexts for g in pages.statement(name).context(context).claims),
        *standing(pages.statement(name)),
        *MORE.get(name, ()),
    )
]


@pytest.mark.parametrize("name", COLLAPSES)
def test_the_point_is_inside(name: str) -> None:
    """No given is sharp at the point but that a speed is the smaller one: there is an interior."""
    with balls.precision(4000):
        terms = pages.statement(name).context("start").point
        point = {key: arb(balls.fmpq_of(term.value)) for key, term in terms.items()}
        for given, claim in givens(name).items():
            if claim.relation != "=" and given not in COLLAPSES[name].sharp:
                assert holds(Claim("<", claim.lhs, claim.rhs), point), given


@pytest.mark.parametrize(("name", "given"), ALL)
def test_each_given_is_used(name: str, given: str) -> None:
    assert answer(without(pages.decide(name), given)) in {"REFUSED", "MALFORMED"}


@pytest.mark.parametrize(("name", "given"), [(n, g) for n in COLLAPSES for g in givens(n)])
def test_a_weaker_given_is_refused(name: str, given: str) -> None:
    claim = givens(name)[given]
    weaker = Claim(claim.relation, claim.lhs, claim.rhs + Fraction(1, 10**6))
    assert answer(changed(pages.decide(name), given, weaker)) == "REFUSED"


@pytest.mark.parametrize(
    ("name", "mutant"), [(n, m) for n, t in COLLAPSES.items() for m in t.mutants]
)
def test_a_mutant_is_refused(name: str, mutant: str) -> None:
    given, text = COLLAPSES[name].mutants[mutant]
    lie = changed(pages.decide(name), given, claim_of(pages.statement(name), given, text))
    assert answer(lie) == "REFUSED"
