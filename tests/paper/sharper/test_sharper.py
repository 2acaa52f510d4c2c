"""The sharper theorem: accepted as it is, refused with anything missing or changed, and true."""

from __future__ import annotations

from fractions import Fraction
from functools import cache

import pytest
from flint import arb

from tests.evaluation import value
from tests.paper.changed_statements import answer
from tests.paper.sharper.particles import Particles, dot
from tests.paper.sharper.states import Numbers, Random
from verify import check
from verify.language.statement import NEEDED, PROVED, Applies, Cite, Context, Obligation, Statement
from verify.language.terms import Claim, Term, as_term, sqrt
from verify.paper.commands import pages
from verify.paper.commands.pages import page
from verify.prover import balls
from verify.prover.outcome import Decision, Outcome
from verify.prover.proof import ObligationStep
from verify.prover.rules import Applying, Interval
from verify.wire.write import write

SHARPER = page("sharper").statement
START = SHARPER.context("start")
GIVENS = START.claims
#: What is asked of the numbers alone.
ROOM = [claim for name, claim in GIVENS.items() if not name.startswith("start-")]
BITS = 4000
COLLISIONS = 40


@pytest.mark.parametrize("name", ["tau", "D", "C_next", "y_next", "eta_s_next", "A_next", "B_next"])
def test_another_collision_map_is_refused(name: str) -> None:
    outcome = pages.decide("sharper")

    def other(context: Context) -> Context:
        constants = (
            c._replace(term=c.term * 2) if c.name == name else c for c in context.constants
        )
        return context._replace(constants=tuple(constants))

    contexts = tuple(map(other, outcome.statement.contexts))
    statement = outcome.statement._replace(contexts=contexts)
    assert answer(outcome._replace(statement=statement)) == "REFUSED"


# --- what is true --------------------------------------------------------------------------------


def room_for_the_angle(at: Numbers) -> Fraction:
    """How far -cos theta may be from C_0 at the start."""
    at_start = {**at, "C_start": at["C_0"]}
    claim = GIVENS["start-C-upper"]
    return value(claim.rhs, at_start) - value(claim.lhs, at_start)


def what_fails(at: Numbers, particles: Particles) -> list[str]:
    """The conclusions that the next collisions contradict."""
    n = {name: balls.from_fraction(number) for name, number in at.items()}
    end = n["T"] * n["eta_0"] / (1 - n["p"] - n["Y"])
    s, c, clock, before = 1, 2, arb(0), None
    one = 1 + arb(10) ** -100
    for _ in range(COLLISIONS):
        (x_s, W_s), (x_c, W_c) = particles.relative(0, s), particles.relative(0, c)
        far = dot(x_c, x_c).sqrt()
        y, eta_s, cosine = -dot(x_c, W_c) / far, dot(x_s, W_s), -dot(x_s, x_c) / far
        meeting = particles.next()
        held = {
            "pair": meeting is not None and meeting[1:] == (0, c),
            "q": (n["m"] - n["X"]) * y <= eta_s * one and eta_s <= (n["m"] + n["X"]) * y * one,
            "d": far - 1 <= n["k"] * y**2 * one,
            "angle": abs(cosine - n["C_0"]) <= n["Theta"],
            "speeds": dot(W_s, W_s) <= n["V"] ** 2 and dot(W_c, W_c) <= n["V"] ** 2,
            "ratio": before is None
            or ((n["p"] - n["Y"]) * before <= y and y <= (n["p"] + n["Y"]) * before),
        }
        if meeting is None or not all(held.values()):
            return [name for name, holds in held.items() if not holds]
        clock += meeting[0]
        if not (meeting[0] <= n["T"] * y and clock <= end):
            return ["time"]
        particles.collide(*meeting)
        before, s, c = y, c, s
    return []


@cache
def draws(dimension: int) -> tuple[Random, tuple[Numbers, ...]]:
    """Numbers that satisfy all inequalities."""
    draw, found = Random(dimension, dimension), []
    while len(found) < 12:
        at = draw.numbers()
        if at is not None and all(holds(claim, at) for claim in ROOM):
            found.append(at)
    return draw, tuple(found)


def holds(claim: Claim, at: Numbers) -> bool:
    lhs, rhs = value(claim.lhs, at), value(claim.rhs, at)
    return lhs < rhs if claim.relation == "<" else lhs <= rhs


@pytest.mark.parametrize("dimension", [2, 3])
def test_particles_do_as_they_are_told(dimension: int) -> None:
    draw, found = draws(dimension)
    followed = 0
    with balls.precision(BITS):
        for at in found:
            for _ in range(3):
                particles = draw.particles(at, room_for_the_angle(at))
                if particles is not None:
                    assert what_fails(at, particles) == []
                    followed += 1
    assert followed > 25


@pytest.mark.parametrize("dimension", [2, 3])
def test_a_follower_that_contradicts_would_be_seen(dimension: int) -> None:
    """With bounds that are too narrow something fails."""
    draw, found = draws(dimension)
    with balls.precision(BITS):
        at = found[0]
        particles = draw.particles(at, room_for_the_angle(at))
        assert particles is not None
        narrow = {**at, "Y": at["Y"] / 1000, "X": at["X"] / 1000}
        assert what_fails(narrow, particles) != []


# --- how a scene cites it ------------------------------------------------------------------------


def test_a_statement_cites_the_theorem() -> None:
    """Values of all variables, and each given decided by enclosures: a scene shows no more."""
    values: dict[str, Term] = dict(START.point)
    values |= {"C_start": sqrt(as_term(Fraction(90249999, 10**8))), "B_start": sqrt(2) / 3}
    assert verdict_of_scene(values) == "PROVED"
    values["B_start"] = sqrt(2)
    assert verdict_of_scene(values) == "REFUSED"


def verdict_of_scene(values: dict[str, Term]) -> str:
    """Whether the checker accepts that the theorem applies to these values."""
    theorem = write(pages.decide("sharper"))
    applies = Applies(f"sharper:{START.name}", values)
    row = Obligation("collapse", "", "", NEEDED, "the particles collapse", applies)
    cite = Cite("sharper", "sharper", theorem["statement.json"])
    statement = Statement("scene", "Three particles", {}, (), (), (row,), (), (cite,))
    proof = Applying(tuple(Interval(64) for _ in GIVENS))
    decisions = {row.name: Decision(PROVED, proof)}
    files = write(Outcome(statement, decisions, (ObligationStep(row.name, proof),), {}))
    cited = {name[6:-5]: data for name, data in files.items() if name.startswith("cited/")}
    return check.check(files["statement.json"], files["certificate.json"], cited).verdict
