"""The sharper theorem: accepted as it is, refused with anything missing or changed, and true."""

from __future__ import annotations

from fractions import Fraction
from functools import cache

import pytest
from flint import arb

from tests.evaluation import value
from tests.paper.changed_statements import answer, but, changed, claim_of, report, standing, without
from tests.paper.sharper.particles import Particles, dot
from tests.paper.sharper.states import Numbers, Random
from verify import check
from verify.language.statement import NEEDED, PROVED, Applies, Cite, Context, Obligation, Statement
from verify.language.terms import Claim, Term, as_term, sqrt
from verify.paper.commands.collapse import decide_sharper
from verify.paper.commands.pages import page
from verify.prover import balls
from verify.prover.outcome import Decision, Outcome
from verify.prover.proof import LemmaStep, ObligationStep, Step
from verify.prover.rules import Applying, Interval, Sum
from verify.wire.read import read
from verify.wire.write import write

SHARPER = page("sharper").statement
START = SHARPER.context("start")
GIVENS = START.claims
#: What is asked of the numbers alone.
ROOM = [claim for name, claim in GIVENS.items() if not name.startswith("start-")]
BITS = 4000
COLLISIONS = 40


def test_the_theorem_is_proved_and_small() -> None:
    outcome = decide_sharper()
    files = write(outcome)
    assert report(outcome).verdict == "PROVED"
    assert outcome.verdict == PROVED
    assert sum(map(len, files.values())) < 120_000
    assert read(files["statement.json"], files["certificate.json"], {}) == outcome.draft


def test_what_is_assumed() -> None:
    kinds = [assumption.kind for assumption in decide_sharper().assumptions]
    assert sorted(kinds) == ["definition", *["general mathematics"] * 3, *["numbered glue"] * 3]


def test_glue_names_rows_that_are_there() -> None:
    rows = {row.name for row in SHARPER.obligations}
    rows |= {given.name for context in SHARPER.contexts for given in context.givens}
    lemmas = {step.name for step in decide_sharper().steps if isinstance(step, LemmaStep)}
    named = {
        word.strip(".,:")
        for assumption in decide_sharper().assumptions
        if assumption.kind == "numbered glue"
        for word in assumption.sentence.split()
        if "-" in word and word.strip(".,:").replace("-", "").isalpha()
    }
    assert len(named & rows) >= 12
    assert named - rows - lemmas <= {"-cos", "n-th", "glue-next", "finite-length"}


def test_the_point_is_inside() -> None:
    """No given is sharp at the point: the theorem is about a set with an interior."""
    point = {name: term.value for name, term in START.point.items()}
    for name, claim in GIVENS.items():
        assert value(claim.lhs, point) < value(claim.rhs, point), name


# --- what is refused -----------------------------------------------------------------------------


@pytest.mark.parametrize("name", GIVENS)
def test_each_inequality_and_entry_condition_is_used(name: str) -> None:
    assert answer(without(decide_sharper(), name)) in {"REFUSED", "MALFORMED"}


@pytest.mark.parametrize("name", [*standing(SHARPER), "s-upper", "t-lower", "t-upper"])
def test_each_pair_of_vectors_and_each_time_is_used(name: str) -> None:
    assert answer(without(decide_sharper(), name)) in {"REFUSED", "MALFORMED"}


def weaker(claim: Claim) -> Claim:
    """The claim with a little more room on its greater side."""
    return Claim(claim.relation, claim.lhs, claim.rhs + Fraction(1, 10**6))


@pytest.mark.parametrize("name", [*GIVENS][::3])
def test_a_weaker_given_is_refused(name: str) -> None:
    assert answer(changed(decide_sharper(), name, weaker(GIVENS[name]))) == "REFUSED"


#: The theorem as it might be miswritten: a sign, a factor, a power, an end.
MUTANTS = {
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


@pytest.mark.parametrize("mutant", MUTANTS)
def test_a_mutant_is_refused(mutant: str) -> None:
    name, text = MUTANTS[mutant]
    assert answer(changed(decide_sharper(), name, claim_of(SHARPER, name, text))) == "REFUSED"


@pytest.mark.parametrize("name", ["tau", "D", "C_next", "y_next", "eta_s_next", "A_next", "B_next"])
def test_another_collision_map_is_refused(name: str) -> None:
    outcome = decide_sharper()

    def other(context: Context) -> Context:
        constants = (
            c._replace(term=c.term * 2) if c.name == name else c for c in context.constants
        )
        return context._replace(constants=tuple(constants))

    contexts = tuple(map(other, outcome.statement.contexts))
    statement = outcome.statement._replace(contexts=contexts)
    assert answer(outcome._replace(statement=statement)) == "REFUSED"


def sums() -> list[tuple[Step, Claim, str | None, Sum]]:
    """Every sum of the certificate with its claim and context."""
    rows = {row.name: row for row in SHARPER.obligations}
    found: list[tuple[Step, Claim, str | None, Sum]] = []
    for step in decide_sharper().steps:
        if isinstance(step, LemmaStep) and isinstance(step.proof, Sum):
            found.append((step, step.claim, step.context, step.proof))
        if isinstance(step, ObligationStep) and isinstance(step.proof, Sum):
            claim = rows[step.name].claim
            assert isinstance(claim, Claim)
            found.append((step, claim, rows[step.name].context, step.proof))
    return found


def accepted(lies: dict[str, list[LemmaStep]]) -> list[str]:
    """Which lies are accepted, each put before the step of its name."""
    steps = [new for old in decide_sharper().steps for new in (*lies.get(old.name, []), old)]
    names = {lie.name for group in lies.values() for lie in group}
    lines = report(decide_sharper()._replace(steps=tuple(steps))).lines
    return sorted(
        names - {line.split()[2].rstrip(":") for line in lines if line.startswith("REFUSED lemma")}
    )


def test_a_sum_without_one_of_its_addends_is_refused() -> None:
    lies: dict[str, list[LemmaStep]] = {}
    for number, (step, claim, context, proof) in enumerate(sums()):
        for i in range(len(proof.addends)):
            fewer = proof._replace(addends=but(proof.addends, i))
            lie = LemmaStep(f"lie.{number}.{i}", context, claim, fewer)
            lies.setdefault(step.name, []).append(lie)
    assert sum(map(len, lies.values())) > 300
    for part in (0, 1):  # the checker bounds its work
        assert accepted(dict(list(lies.items())[part::2])) == []


def test_a_stronger_claim_is_refused() -> None:
    lies: dict[str, list[LemmaStep]] = {}
    for number, (step, claim, context, proof) in enumerate(sums()):
        stronger = Claim(claim.relation, claim.lhs + Fraction(1, 1000), claim.rhs)
        lies[step.name] = [LemmaStep(f"lie.{number}", context, stronger, proof)]
    assert accepted(lies) == []


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
    theorem = write(decide_sharper())
    applies = Applies(f"sharper:{START.name}", values)
    row = Obligation("collapse", "", "", NEEDED, "the particles collapse", applies)
    cite = Cite("sharper", "sharper", theorem["statement.json"])
    statement = Statement("scene", "Three particles", {}, (), (), (row,), (), (cite,))
    proof = Applying(tuple(Interval(64) for _ in GIVENS))
    decisions = {row.name: Decision(PROVED, proof)}
    files = write(Outcome(statement, decisions, (ObligationStep(row.name, proof),), {}))
    cited = {name[6:-5]: data for name, data in files.items() if name.startswith("cited/")}
    return check.check(files["statement.json"], files["certificate.json"], cited).verdict
