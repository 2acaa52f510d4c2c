"""The jobs `step` and `step-printed`: one step of the recursion, for every state and all numbers.

`step-printed` is what the recursion prints and is false, each at a state of its own.
"""

from __future__ import annotations

from collections.abc import Mapping
from fractions import Fraction
from functools import cache

from verify.language.argument import Chapter
from verify.language.statement import REFUTED, Constant, Statement
from verify.language.terms import Term, as_term
from verify.paper import step_as_printed as misprints
from verify.paper.commands.elsewhere import premise
from verify.paper.commands.pages import decide
from verify.prover.arguments import Writing
from verify.prover.ground import Ground
from verify.prover.outcome import Decision, Outcome
from verify.prover.rules import Interval, Witness
from verify.wire.judge import judged


@cache
def decide_step() -> Outcome:
    """The step, each line with the proof that its reason describes."""
    return decide("step")


#: Enough for the sides of the conditions at the states, some of which differ by 10^-25.
BITS = 256

PARAMETERS = {name: as_term(Fraction(text)) for name, text in misprints.PARAMETERS.items()}

Vector = tuple[Fraction, Fraction, Fraction]


@cache
def decide_step_printed() -> Outcome:
    """Every row with its proof, or the state that refutes it; the checker decides whether."""
    points = {name: state(numbers) for name, numbers in misprints.WITNESSES.items()}
    statement = _statement(points[misprints.FIRST])
    writing = Writing(statement)
    session, ground = writing.session, Ground(writing.session)
    given = [Constant(name, name, name, "", x) for name, x in statement.parameters.items()]
    names = [constant.name for constant in (*given, *statement.constants)]
    for constant in (*given, *statement.constants):
        ground.define(constant)
    for name, claim in misprints.signs().items():
        session.lemma(claim, Interval(BITS), name=name)
    premises = tuple(premise(claim, BITS) for claim in misprints.conditions().values())
    session.open(statement.contexts[0], premises)
    writing.chapter(Chapter(misprints.CONTEXT, tuple(misprints.lines())))
    for row in misprints.printed():
        at = points[misprints.FALSE_AT.get(row.name, misprints.FIRST)]
        proof = Witness(at, premises, Interval(BITS))
        session.prove_row(row, proof, holds=False)
        writing.decisions[row.name] = Decision(REFUTED, proof)
    found = {name: ground.enclose(ground.definitions[name]) for name in names}
    enclosures = {name: ends for name, ends in found.items() if ends is not None}
    return judged(Outcome(statement, writing.decisions, tuple(session.steps), enclosures))


def _statement(point: Mapping[str, Term]) -> Statement:
    rows = (*misprints.needed(), *misprints.printed())
    contexts = (misprints.context(point),)
    return Statement(
        misprints.NAME, misprints.TITLE, PARAMETERS, misprints.constants(), contexts, rows, ()
    )


# --- states ---------------------------------------------------------------------------------------


def state(numbers: misprints.Witnessed) -> Mapping[str, Term]:
    """The coordinates and numbers of a state, all rational, without a root.

    The directions before and after the flight are drawn; with the time they give the velocities.
    """
    t, y, tau = Fraction(numbers.half), Fraction(numbers.y), Fraction(numbers.tau)
    cosine, sine = (1 - t**2) / (1 + t**2), 2 * t / (1 + t**2)
    zero, one = Fraction(0), Fraction(1)
    omega_s, omega_c = (one, zero, zero), (-cosine, sine, zero)
    contact = _turned(omega_c, (sine, cosine, zero), numbers.turn_c)
    distance = _dot(contact, omega_c) + tau * y
    W_c = _velocity(omega_c, distance, contact, one, tau)
    end = _turned(omega_s, (zero, one, zero), numbers.turn_s)
    D = (1 + tau * Fraction(numbers.ratio) * y) / _dot(end, omega_s)
    W_s = _velocity(omega_s, one, end, D, tau)
    vectors = zip(misprints.VECTORS, (omega_s, W_s, omega_c, W_c), strict=True)
    found = {
        f"{name}_{i}": x
        for name, vector in vectors
        for i, x in zip(misprints.AXES, vector, strict=True)
    }
    found |= {"d": distance - 1, "S": -_dot(W_c, contact) / (distance * y), "tau": tau, "D": D}
    g, d_0 = map(Fraction, misprints.START)
    found |= {"g": g, "d_0": d_0, "decay": Fraction(misprints.DECAY) ** numbers.n}
    return {name: as_term(value) for name, value in found.items()}


def _dot(x: Vector, z: Vector) -> Fraction:
    return x[0] * z[0] + x[1] * z[1] + x[2] * z[2]


def _turned(omega: Vector, side: Vector, turn: tuple[str, str]) -> Vector:
    """The unit vector whose stereographic coordinates from omega are given, the second in space."""
    p, q = map(Fraction, turn)
    scale = 1 + p**2 + q**2
    x, z, up = (((2 - scale) * a + 2 * p * b) / scale for a, b in zip(omega, side, strict=True))
    return x, z, up + 2 * q / scale


def _velocity(old: Vector, before: Fraction, new: Vector, after: Fraction, tau: Fraction) -> Vector:
    """The velocity that takes a particle from one place to the other in the time tau."""
    x, z, up = ((after * b - before * a) / tau for a, b in zip(old, new, strict=True))
    return x, z, up
