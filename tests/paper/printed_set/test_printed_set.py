"""The set as printed, with > for <: what is claimed, near misses, and orbits that start in it."""

from __future__ import annotations

import json
import os
import random
from fractions import Fraction

import pytest
from flint import arb, ctx

from tests.paper.sections_1_to_4.values import holds
from tests.paper.sharper.particles import Particles, Vector, combine, dot
from verify.cli import main
from verify.language.errors import OwnError
from verify.language.statement import PRINTED, PROVED, REFUTED
from verify.language.terms import Claim, as_term, substitute_claim, symbol
from verify.paper.commands import pages
from verify.paper.commands.citing import as_printed
from verify.paper.commands.theorem1 import decide_point
from verify.paper.parameters import PRINTED_SET
from verify.wire.judge import report_on
from verify.wire.packaged import PACKAGED_FILES
from verify.wire.write import write

#: Orbits in a run; PRINTED_ORBITS chooses more.
ORBITS = int(os.environ.get("PRINTED_ORBITS", "40"))
COLLISIONS, BITS = 12, 2000


def test_both_statements_are_proved() -> None:
    for outcome in (pages.decide("printed_set"), pages.decide("printed_sign")):
        assert outcome.verdict == PROVED
        assert report_on(outcome).verdict == "PROVED"


def test_the_set_is_the_printed_one() -> None:
    statement = pages.decide("printed_set").statement
    (row,) = (row for row in statement.obligations if row.name == "collapse")
    assert row.context == "initial"
    names = {constant.name for context in statement.contexts for constant in context.constants}
    assert not any(name.startswith("repaired") for name in names)
    assert [given.name for given in statement.contexts[0].givens] == [
        "hypotheses.r-positive",
        "hypotheses.r-below-one",
        "hypotheses.angle-obtuse",
        "hypotheses.angle-real",
        "hypotheses.stability",
        "hypotheses.V_0-positive",
        "hypotheses.delta-theta-positive",
    ]


def test_the_set_is_that_of_the_step() -> None:
    """But for the printed constants, and the room for the angle, which an interior needs."""
    own = ("V_1", *(f"printed.{name}" for name in ("eta_bar", "x_0", "d_const", "d_slope")))
    meaning = {name.removeprefix("printed."): symbol(name) for name in own}
    initial = pages.statement("step").context("initial").claims
    known = {name: substitute_claim(claim, meaning) for name, claim in initial.items()}
    found = pages.statement("printed_set").context("initial").claims
    assert found.keys() == known.keys() | {"start-C-upper", "start-C-lower"}
    angle = {"start-C-upper", "start-C-lower"}
    assert {n: c for n, c in found.items() if n not in angle} == {
        n: c for n, c in known.items() if n not in angle
    }


def test_a_wider_set_is_refused(monkeypatch: pytest.MonkeyPatch) -> None:
    """With twice the room for d, or for the angle, the same certificate proves nothing."""
    outcome = pages.decide("printed_set")
    around, inner, *others = outcome.statement.contexts
    for name, wider in (
        ("start-d-slope", lambda c: Claim(c.relation, c.lhs, 2 * c.rhs)),
        ("start-C-upper", lambda c: Claim(c.relation, c.lhs, 2 * c.rhs)),
        ("start-x-upper", lambda c: Claim(c.relation, c.lhs, 2 * c.rhs)),
        ("start-A-below", lambda c: Claim(c.relation, c.lhs, c.rhs + (symbol("V_1") - 0) / 9)),
    ):
        givens = tuple(
            given._replace(claim=wider(given.claim)) if given.name == name else given
            for given in inner.givens
        )
        contexts = (around, inner._replace(givens=givens), *others)
        changed = outcome.statement._replace(contexts=contexts)
        report = report_on(outcome._replace(statement=changed))
        assert report.verdict == "REFUSED", name


def test_the_printed_set_has_measure_0() -> None:
    """Random contacts satisfy the equation if their angle is the printed one, and no others do."""
    outcome = pages.decide("printed_set")
    rows = {row.name: (row, found) for row, found in outcome.rows if row.name.startswith("set-")}
    assert list(rows) == ["set-angle", "set-angle-else"]
    assert {(row.role, found.verdict) for row, found in rows.values()} == {(PRINTED, PROVED)}
    chosen = random.Random(0)
    for _ in range(20):
        c, gap, share = (Fraction(chosen.randint(1, 99), 100) for _ in range(3))
        for name, cosine in (("set-angle", c), ("set-angle-else", c * share)):
            row, _ = rows[name]
            context = outcome.statement.context(row.context)
            own_gap, product = (variable.name for variable in context.variables)
            at = {"c": as_term(c), own_gap: as_term(gap), product: as_term(-cosine * (1 + gap))}
            assert all(holds(claim, at) for claim in (*context.claims.values(), row.claim))
            assert not holds(row.claim, at | {product: as_term(-(c + 1) * (1 + gap))})


def test_without_the_angle_the_measure_is_not_0() -> None:
    outcome = pages.decide("printed_set")
    for name, weaker in (
        ("as-printed-angle", lambda c: Claim("<=", c.lhs, c.rhs)),
        ("another-angle-smaller", lambda c: Claim("<", 2 * c.lhs, c.rhs)),
        ("another-angle-not-acute", lambda c: Claim("<=", c.lhs, c.rhs + 1)),
    ):
        contexts = tuple(
            context._replace(
                givens=tuple(
                    given._replace(claim=weaker(given.claim)) if given.name == name else given
                    for given in context.givens
                )
            )
            for context in outcome.statement.contexts
        )
        report = report_on(
            outcome._replace(statement=outcome.statement._replace(contexts=contexts))
        )
        assert report.verdict == "REFUSED", name


def test_the_sign_is_false_at_the_point() -> None:
    point = pages.statement("printed_sign").context("excluded").point
    r, c, delta = (point[name].value for name in ("r", "c", "delta_theta"))
    half = (1 + r) / 2 * c
    assert r**2 - 18 * r + 1 > 0
    assert half**3 < 3 * r * half + r * (1 + r)
    assert (c + delta) ** 2 < 16 * r / (1 + r) ** 2


def test_certificates_cite_what_they_rest_on() -> None:
    for outcome, cited in (
        (pages.decide("printed_set"), "sharper"),
        (pages.decide("printed_sign"), "class"),
    ):
        assert [cite.name.startswith(cited) for cite in outcome.statement.cites] == [True]
        assert any(name.startswith("cited/") for name in write(outcome))


# --- orbits ---------------------------------------------------------------------------------------


def number(value: Fraction) -> arb:
    return arb(value.numerator) / value.denominator


class Printed:
    """The constants, transcribed from the paper once more, in balls."""

    def __init__(self, r: arb, c: arb, v_0: arb, delta: arb) -> None:
        self.r, self.c, self.v_0 = r, c, v_0
        alpha = (1 + r) / 2 * c
        root = (alpha**2 - 4 * r).sqrt()
        self.minus, plus = 2 * r / (alpha + root), (alpha + root) / 2
        decay = 1 - (1 - plus) / 2
        h_4, self.h_5 = (1 - r / plus**2) / 2, (1 - self.minus / plus**2) / 2
        self.delta_2 = plus / 2
        width = [(plus - self.minus) / 2, self.delta_2, (1 - plus) / 2]
        width += [plus - (r / (1 - h_4)).sqrt(), plus - (self.minus / (1 - self.h_5)).sqrt()]
        delta_x = least(width)
        v_1 = self.v_1 = v_0 * (1 - self.h_5 / 2) / (1 - self.h_5)
        self.x_0 = least([(1 - h_4) * delta_x, self.x_most])
        turn = least([c / 2, h_4 / 8 * delta_x, delta])
        speed = v_1.sqrt()
        two = arb(2).sqrt()
        share = 2 / (15 * alpha) + h_4 * self.delta_2 / 6 + h_4 / (12 * alpha) + h_4 / 24
        self.eta = least([arb(1), (two - 1) / 16 * v_0 / speed, v_0 / (33 * speed) * turn,
                          (1 - decay) * (v_1 - v_0) / (12 * (speed + 2)),
                          v_0 / speed * share * delta_x])  # fmt: skip
        self.zeta = least([2 * (two - 1),
                           v_0 * self.h_5 / (3 * v_1 * (alpha + 8 * v_1 / v_0)) * self.delta_2**2,
                           (1 + 4 * self.delta_2 + v_0 / v_1) * h_4 * delta_x / 16])  # fmt: skip
        self.d_const = least([(two - 1) / 4, turn / 3, (1 + self.delta_2 * h_4) * delta_x / 5,
                              (1 + 2 * self.delta_2) * h_4 * delta_x / 4])  # fmt: skip
        self.final = 3 * self.zeta * self.eta / speed
        self.time = 2 * self.eta * self.zeta / (v_0 * (1 - decay))

    @property
    def x_most(self) -> arb:
        """The bound of |x_n| that the paper uses for every n."""
        return self.v_0 / self.v_1 * self.delta_2**2 * self.h_5 / 12


def least(entries: list[arb]) -> arb:
    found = entries[0]
    for entry in entries[1:]:
        found = found.min(entry)
    return found


def parameters(choice: random.Random) -> tuple[Fraction, Fraction, Fraction, Fraction]:
    """Decades apart, some next to the threshold; the hypothesis holds with >."""
    while True:
        r = Fraction(choice.randrange(1, 10**6), 10 ** choice.randrange(7, 13))
        c = Fraction(choice.randrange(1, 10**6), 10**6)
        half = (1 + r) / 2 * c
        if half**3 > 3 * r * half + r * (1 + r):
            break
    v_0 = Fraction(choice.randrange(1, 1000)) * Fraction(10) ** choice.randrange(-6, 7)
    return r, c, v_0, Fraction(choice.randrange(1, 1000)) / 10 ** choice.randrange(1, 9)


def direction(choice: random.Random, away: Vector) -> Vector:
    """A unit vector that is orthogonal to another one."""
    while True:
        found = [arb(choice.randrange(-999, 1000)) for _ in away]
        found = combine(found, -dot(found, away), away)
        size = dot(found, found)
        if size > 1:
            return [x / size.sqrt() for x in found]


def state(choice: random.Random, k: Printed) -> tuple[Particles, arb]:
    """Particles in the set, often at its edges, and -eta_c."""
    share = lambda: number(Fraction(choice.choice((1, 999, 1000, choice.randrange(1, 1000))), 1000))  # noqa: E731
    dimension = choice.choice((2, 3, 4))
    omega_s = [arb(int(i == 0)) for i in range(dimension)]
    side = direction(choice, omega_s)
    cosine = -(
        k.c if choice.random() < 0.5 else least([k.c + k.final / 6 * (2 * share() - 1), arb(1)])
    )
    omega_c = combine(
        [cosine * x for x in omega_s], abs(1 - cosine**2).sqrt() if k.c < 1 else arb(0), side
    )
    y = k.eta * share()
    eta_s = y * (k.minus + k.x_0 * (2 * share() - 1))
    if not eta_s > 0:
        eta_s = y * k.minus
    d = least([k.d_const, k.zeta / (2 * k.v_1) * y**2]) * share()
    third = (k.v_1 - k.v_0) / 3
    velocities = []
    for omega, normal in ((omega_s, eta_s), (omega_c, -y)):
        square = k.v_0 + third + third * share()
        tangent = direction(choice, [x / dot(omega, omega).sqrt() for x in omega])
        velocities.append(
            combine([normal * x for x in omega], (square - normal**2).sqrt(), tangent)
        )
    zero = [arb(0)] * dimension
    places = [zero, omega_s, [(1 + d) * x for x in omega_c]]
    return Particles(places, [zero, *velocities], k.r), y


def check_orbit(seed: int) -> None:
    """Collisions 0-2, 0-1, 0-2, ... within the time and the angle; |x_n| <= X at each."""
    choice = random.Random(seed)
    k = Printed(*map(number, parameters(choice)))
    particles, _ = state(choice, k)
    clock = arb(0)
    for n in range(COLLISIONS):
        step = pair_at(particles, expected=2 - n % 2)
        assert step is not None, (seed, n)
        clock += step
        particles.collide(step, 0, 2 - n % 2)
        s, c = (2 - n % 2, 1 + n % 2)
        (x_s, w_s), (x_c, w_c) = particles.relative(0, s), particles.relative(0, c)
        reach = dot(x_c, x_c).sqrt()
        y, eta_s = -dot(x_c, w_c) / reach, dot(x_s, w_s)
        assert y > 0, (seed, n)
        assert eta_s > 0, (seed, n)
        assert not abs(eta_s / y - k.minus) > k.x_most, (seed, n)
        assert not abs(-dot(x_s, x_c) / reach - k.c) > k.final, (seed, n)
        assert not clock > k.time, (seed, n)


def pair_at(particles: Particles, expected: int) -> arb | None:
    """The time to the next collision, if it is one of 0 with that particle."""
    other = 3 - expected
    x, w = particles.relative(0, other)
    if not dot(x, w) > 0:  # the pair in contact recedes
        return None
    time, outer = particles.meeting(0, expected), particles.meeting(1, 2)
    if time is None or not time > 0 or (outer is not None and not time < outer):
        return None
    return time


@pytest.mark.parametrize("seed", range(ORBITS))
def test_an_orbit_of_the_set(seed: int) -> None:
    before = ctx.prec
    ctx.prec = BITS
    try:
        check_orbit(seed)
    finally:
        ctx.prec = before


# --- what is said ---------------------------------------------------------------------------------


@pytest.mark.usefixtures("a_new_process")
def test_an_altered_file_is_noticed(monkeypatch: pytest.MonkeyPatch) -> None:
    lies = {"statement.json": "0" * 64, "certificate.json": "0" * 64}
    monkeypatch.setitem(PACKAGED_FILES, PRINTED_SET, lies)
    with pytest.raises(OwnError, match="is not the file that came with the program"):
        as_printed(decide_point(PARAMETERS))


PARAMETERS = {"r": as_term(Fraction(3, 100)), "c": as_term(1), "V_0": as_term(1),
              "delta_theta": as_term(Fraction(1, 10))}  # fmt: skip


@pytest.mark.parametrize("words", ["--r 0.03", "--all"])
def test_the_first_screen_answers_three_questions(
    words: str, capsys: pytest.CaptureFixture[str], monkeypatch: pytest.MonkeyPatch
) -> None:
    """Is the theorem true as printed, is its set right, which steps fail and how bad is that."""
    monkeypatch.setenv("COLUMNS", "80")
    main(["theorem1", *words.split()])
    lines = capsys.readouterr().out.splitlines()[:24]
    assert max(map(len, lines)) <= 80
    first = " ".join(line.strip() for line in lines)
    assert "As printed, with <: refuted" in first
    assert "With >, its set as printed: proved" in first
    assert "is true once one sign is corrected: in (4.10), < should be >." in first
    assert "The printed argument: refuted" in first
    assert "steps" in first
    assert "break it" in first
    for name in ("set-interior", "zeta-x-bound", "zeta-term-2", "zeta-remainders", "zeta-total"):
        assert f"{name} " in first
    assert "Why set-interior: ω_{c,0}·ω_{s,0} = cos θ₀ is an equation" in first
    assert "Why zeta-x-bound and 3 more: The bound" in first
    assert "final-angle" in first
    assert "The theorem with repaired constants: proved" in first


def test_a_referee_reads_the_verdicts(capsys: pytest.CaptureFixture[str]) -> None:
    said = {}
    for line in ("--r 0.03", "--all", "--all --constants printed"):
        code = main(["theorem1", *line.split()])
        said[line] = capsys.readouterr().out
        assert code == (1 if "printed" in line else 0)
        assert "As printed, with <: refuted" in said[line]
        assert "With >, its set as printed: proved" in said[line]
    last = " ".join(said["--all --constants printed"].partition("Verdict: ")[2].split())
    assert last.startswith("refuted: the printed argument, for all parameters")
    assert last.endswith("; proved: the set as printed, with > for <")


def test_programs_read_the_verdicts(capsys: pytest.CaptureFixture[str]) -> None:
    for line in ("--r 0.03", "--all --constants printed"):
        main(["theorem1", *line.split(), "--json"])
        printed = json.loads(capsys.readouterr().out)["sets"]["printed"]
        assert [printed[key] for key in ("verdict", "sign", "set")] == [REFUTED, REFUTED, PROVED]


@pytest.mark.parametrize(
    ("words", "known"),
    [
        (["0.03", "--neg-cos", "0.5"], "below that: no state collapses as the theorem says"),
        (["0.03", "--neg-cos", "0.6"], "is at least 4√r/(1+r)"),
        (["0.03", "--neg-cos", "0.6"], "angle; -cos θ₀ + δ_θ is below that: the conclusion of the"),
        (
            ["0.03", "--neg-cos", "0.7"],
            "no set with interior consists of states that collapse with",
        ),
        (["0.06"], "no set with interior consists of states that collapse, and the conclusion of"),
        (["0.06", "--neg-cos", "0.9"], "is at least 4√r/(1+r)"),
        (["0.08"], "three balls of equal mass never collapse, whatever the angle"),
    ],
)
def test_a_theorem_does_not_apply(
    words: list[str],
    known: str,
    capsys: pytest.CaptureFixture[str],
    monkeypatch: pytest.MonkeyPatch,
) -> None:
    monkeypatch.setenv("COLUMNS", "9999")
    assert main(["theorem1", "--r", *words]) == 1
    said = capsys.readouterr().out
    assert "Verdict: does not apply: a hypothesis is refuted (exit code 1): Theorem 1" in said
    assert known in said
    assert "as printed, with <" not in said
    assert main(["theorem1", "--r", *words, "--json"]) == 1
    assert json.loads(capsys.readouterr().out)["verdict"] == "does not apply"


@pytest.mark.parametrize(
    ("words", "is_false"),
    [
        (["0.03", "--neg-cos", "0.7", "--delta-theta", "0.09"], True),
        (["0.03", "--neg-cos", "0.7", "--delta-theta", "0.091"], False),  # 0.7908… is between
        (["1/64", "--neg-cos", "8/13", "--delta-theta", "1/1000000"], False),  # just the bound
        (["0.05572809"], False),  # one digit below 9-4√5; -cos θ₀ = 1
        (["0.0557280901"], True),
    ],
)
def test_when_the_conclusion_is_false(
    words: list[str], is_false: bool, capsys: pytest.CaptureFixture[str]
) -> None:
    """A collapse with -cos below the second bound has no angular momentum: no interior there."""
    code = main(["theorem1", "--r", *words])
    said = " ".join(capsys.readouterr().out.split())
    assert ("the conclusion of the theorem is false here" in said) == is_false
    assert code == (0 if "Known" not in said else 1)
