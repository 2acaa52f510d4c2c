"""The theorem on three balls: accepted as it is, refused with anything changed, and true."""

from __future__ import annotations

import re
from collections import Counter
from fractions import Fraction
from functools import cache
from pathlib import Path

import pytest
from flint import arb

from tests.paper.changed_statements import (
    accepted_lies,
    answer,
    changed,
    claim_of,
    report,
    standing,
    without,
)
from tests.paper.sandwich.states import holds
from tests.paper.three_balls.states import (
    GIVENS,
    STAIR,
    STATEMENT,
    Applied,
    Random,
    Values,
    fails,
)
from verify.language.argument import Argument
from verify.language.statement import PROVED
from verify.language.terms import Claim
from verify.paper.commands.collapse import decide_three_balls
from verify.paper.commands.pages import cite, content
from verify.prover import balls
from verify.prover.arguments import write_down
from verify.prover.proof import LemmaStep
from verify.wire.judge import judged
from verify.wire.read import read
from verify.wire.text.read_page import read_page
from verify.wire.write import write

#: 430 digits.
BITS = 1430
COLLISIONS = 30


def test_the_theorem_is_proved_and_small() -> None:
    outcome = decide_three_balls()
    files = write(outcome)
    assert report(outcome).verdict == "PROVED"
    assert outcome.verdict == PROVED
    assert sum(map(len, files.values())) < 200_000
    assert read(files["statement.json"], files["certificate.json"], {}) == outcome.draft


def test_what_is_assumed() -> None:
    kinds = [assumption.kind for assumption in decide_three_balls().assumptions]
    expected = [*["definition"] * 2, *["general mathematics"] * 3, *["numbered glue"] * 4]
    assert sorted(kinds) == expected


def test_glue_names_facts_that_are_there() -> None:
    known = {row.name for row in STATEMENT.obligations}
    known |= {given.name for context in STATEMENT.contexts for given in context.givens}
    known |= {context.name for context in STATEMENT.contexts}
    known |= {step.name for step in decide_three_balls().steps if isinstance(step, LemmaStep)}
    known |= {assumption.name for assumption in STATEMENT.assumptions}
    named = {
        word
        for assumption in STATEMENT.assumptions
        if assumption.kind == "numbered glue"
        for word in re.findall(r"(?<![-\w])[a-z]+(?:-[A-Za-z]+)+(?![-\w])", assumption.sentence)
    }
    assert len(named) > 15
    assert named - known <= {"n-th"}


def test_the_point_is_inside() -> None:
    """No inequality is sharp at the point, and no two numbers of the balls are equal."""
    point = {n: balls.exact(term.value) for n, term in STATEMENT.context("start").point.items()}
    for name, claim in GIVENS.items():
        if claim.relation != "=":
            assert holds(Claim("<", claim.lhs, claim.rhs), point), name
    for name in ("m", "r", "sigma", "beta", "Y", "E"):
        assert point[f"{name}_0"] != point[f"{name}_1"], name


def test_equal_particles_are_a_special_case() -> None:
    """What the sandwich theorem asks implies what this one asks: the page beside this test."""
    path = Path(__file__).with_name("equal.toml")
    cited = (cite("three_balls"),)
    read_here = read_page(str(path), path.read_bytes(), cited, lambda _: content("sandwich_below"))
    found = judged(write_down(Argument(read_here.statement, read_here.chapters)))
    assert found.decisions["equal"].verdict == found.verdict == PROVED


# --- what is refused -----------------------------------------------------------------------------


@pytest.mark.parametrize(
    "name", [*GIVENS, *standing(STATEMENT), *STAIR, *STATEMENT.context("orbit").claims]
)
def test_each_given_is_used(name: str) -> None:
    assert answer(without(decide_three_balls(), name)) in {"REFUSED", "MALFORMED"}


@pytest.mark.parametrize("name", [*GIVENS])
def test_a_weaker_given_is_refused(name: str) -> None:
    claim = GIVENS[name]
    weaker = Claim(claim.relation, claim.lhs, claim.rhs + Fraction(1, 10**6))
    assert answer(changed(decide_three_balls(), name, weaker)) == "REFUSED"


#: The theorem as it might be miswritten: an index, a factor, a sign, a ball that is forgotten.
MUTANTS = {
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


@pytest.mark.parametrize("mutant", MUTANTS)
def test_a_mutant_is_refused(mutant: str) -> None:
    name, text = MUTANTS[mutant]
    lie = changed(decide_three_balls(), name, claim_of(STATEMENT, name, text))
    assert answer(lie) == "REFUSED"


def test_a_sum_without_one_of_its_addends_is_refused() -> None:
    """What is left of an inequality of vectors is too long for the checker."""
    count, accepted = accepted_lies(decide_three_balls(), 4, ("tau",))
    assert count > 250
    assert accepted == set()


# --- what is true --------------------------------------------------------------------------------


def what_fails(applied: Applied) -> list[str]:
    """The conclusions that the next collisions contradict."""
    bodies, at, points = applied
    repeats = len(points) - 3
    at = {name: arb(x) for name, x in at.items()}
    end = at["E_0"] * at["y_start"]
    s, c, clock, most, one = 1, 2, arb(0), at["y_start"], 1 + arb(10) ** -100
    for number in range(COLLISIONS):
        here = bodies.start(s, c)
        index = number if number <= repeats else repeats + (number - repeats) % 2
        Q, U = (balls.from_fraction(x) for x in points[index])
        far, w_c, w_s = 1 + here.d, at[f"w_{number % 2}"], at[f"w_{1 - number % 2}"]
        meeting = bodies.next()
        held = {
            "pair": meeting is not None and meeting[1:] == (0, c),
            "closing": here.y <= most * one,
            "q": here.eta_s <= Q * here.y * one,
            "k": at[f"k_{number % 2}"] * here.y <= here.eta_s * one,
            "u": (far**2 - 1) * w_c**2 <= U * (2 - U) * far**2 * here.y**2 * one,
            "angle": abs(here.C - at["C_0"]) <= at["Theta"],
            "speeds": here.A <= w_c**2 and here.B <= w_s**2,
            "distance": far <= at["G"],
        }
        if meeting is None or not all(held.values()):
            return [name for name, is_so in held.items() if not is_so]
        clock += meeting[0]
        if not (clock <= end and meeting[0] * w_c**2 <= at["G"] * U * here.y * one):
            return ["time"]
        bodies.collide(*meeting)
        s, c, most = c, s, most * at[f"Y_{number % 2}"]
    return []


@cache
def draws(dimension: int, count: int, *, equal: bool = False) -> tuple[Applied, ...]:
    """States to which the theorem applies."""
    draw, found = Random(43 + dimension, dimension, equal=equal), []
    while len(found) < count:
        applied = draw.applied()
        if applied is not None:
            found.append(applied)
    return tuple(found)


@pytest.mark.parametrize("dimension", [2, 3])
def test_balls_do_as_they_are_told(dimension: int) -> None:
    with balls.precision(BITS):
        assert [what_fails(one) for one in draws(dimension, 40)] == [[]] * 40


@pytest.mark.parametrize("part", range(4))
def test_many_states_do_as_they_are_told(part: int) -> None:
    """Among them light middle balls, for which q has to be bounded from below, and C* > 0."""
    with balls.precision(BITS):
        draw, kinds = Random(1000 + part, 2 + part % 2), Counter[str]()
        while kinds["all"] < 500:
            applied = draw.applied()
            if applied is None:
                continue
            bodies, at, _ = applied
            assert what_fails(applied) == []
            kinds["all"] += 1
            kinds["light"] += bool(at["G"] ** 2 * at["beta_0"] * at["beta_1"] >= 1)
            kinds["large"] += bodies.bodies(1, 2).least_cosine > 0
            kinds["two"] += at["r_0"] != at["r_1"]
        assert min(kinds.values()) >= 10
        assert len(kinds) == 4


def edges(at: Values) -> dict[str, tuple[str, arb]]:
    """For each hypothesis on the state the number that it bounds, and the bound."""
    y, w_0 = at["y_start"], at["w_0"]
    gain = at["G"] / (1 - at["Y_0"] * at["Y_1"]) * y
    room = at["Theta"] - (w_0 + at["w_1"] + at["z_b"]) * at["E_0"] * y
    zeta = at["U_0"] * (2 - at["U_0"]) * y**2 / w_0**2
    return {
        "start-q": ("eta_s_start", at["Q_0"] * y),
        "start-u": ("d_start", 1 / (1 - zeta).sqrt() - 1),
        "start-A-most": ("A_start", (w_0 - at["beta_1"] * at["Y_0"] * gain) ** 2),
        "start-B-most": ("B_start", (at["w_1"] - at["beta_0"] * gain) ** 2),
        "start-C-upper": ("C_start", at["C_0"] + room),
        "start-C-lower": ("C_start", at["C_0"] - room),
        "start-cs-c": ("A_start", y**2),
        "start-cs-s": ("B_start", at["eta_s_start"] ** 2),
        "start-least": ("eta_s_start", at["k_0"] * y),
    }


@pytest.mark.parametrize("name", ["start-q", "start-u", "start-A-most", "start-B-most",
                                  "start-C-upper", "start-C-lower", "start-cs-c", "start-cs-s",
                                  "start-least"])  # fmt: skip
def test_a_state_just_outside_is_not_accepted(name: str) -> None:
    """One part in 10^30 beyond a hypothesis it fails, and no other one; just inside it holds."""
    least = {"start-cs-c", "start-cs-s", "start-C-lower", "start-least"}
    with balls.precision(BITS):
        tiny = arb(10) ** -30 * (-1 if name in least else 1)
        for _, at, points in draws(2, 40):
            number, edge = edges(at)[name]
            assert name in fails({**at, number: edge * (1 + tiny)}, points)
            assert name not in fails({**at, number: edge * (1 - tiny)}, points)


def test_a_simulation_that_contradicts_would_be_seen() -> None:
    """With a stair that is too low, something fails."""
    with balls.precision(BITS):
        for bodies, at, points in draws(3, 10):
            low = tuple((Q / 2, U / 4) for Q, U in points)
            assert set(what_fails(Applied(bodies, at, low))) & {"q", "u"}
