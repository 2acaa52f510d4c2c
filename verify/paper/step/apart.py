"""Until the collision, and at its instant, no other pair of particles is in contact."""

from __future__ import annotations

from collections.abc import Iterator
from fractions import Fraction

from verify.language.statement import Context, Given, Variable
from verify.language.terms import Term, as_term, equal, symbol
from verify.paper.argument import (
    BySum,
    Chapter,
    Item,
    Line,
    Opened,
    identity,
    plus,
    proof,
    scaled,
    square,
    times,
)
from verify.paper.parameters import THEOREM
from verify.paper.step.state import (
    CONTEXT,
    A,
    S,
    away,
    b,
    contact,
    d,
    difference,
    frame,
    tau,
    y,
)
from verify.paper.step.vectors import Combination, add, omega_c, omega_s, scale

t, s = symbol("t"), symbol("s")
dot = frame.dot


def contexts() -> tuple[Context, Context]:
    """The times before the collision, and those up to and including it."""
    return (
        _times("before", s, (Given("s-lower", 0 <= s), Given("s-upper", s < tau))),
        _times("meanwhile", t, (Given("t-lower", 0 <= t), Given("t-upper", t <= tau))),
    )


def _times(name: str, time: Term, givens: tuple[Given, ...]) -> Context:
    variable = Variable(time.name, time.name, time.name)
    return Context(
        name, (variable,), givens, {time.name: tau / 2}, CONTEXT, "a time within the step"
    )


def chapters() -> Iterator[Chapter]:
    """The three pairs."""
    before, meanwhile = contexts()
    yield Chapter(
        CONTEXT,
        (
            Line("half-positive", 0 <= tau / 2, proof(times(Fraction(1, 2), "tau-positive"))),
            Line("half-before", tau / 2 < tau, proof(times(Fraction(1, 2), "tau-positive"))),
            Line("half-until", tau / 2 <= tau, proof(times(Fraction(1, 2), "tau-positive"))),
            Opened(before, ("half-positive", "half-before")),
            Opened(meanwhile, ("half-positive", "half-until")),
        ),
    )
    yield Chapter(before.name, tuple(_colliding()))
    yield Chapter(meanwhile.name, tuple(_others()))


def _colliding() -> Iterator[Item]:
    place = contact(frame, s)
    left = A * tau - A * s
    rest = left * (left + 2 * (1 + d) * y * S)
    yield Line(
        "approach",
        equal(A * (dot(place, place) - 1), rest),
        identity("tau S"),
        THEOREM,
        "|path|² - 1 has the contact at τ as its first root",
    )
    factor = times("A-positive", "s-upper")
    impact = times(2, "d-sum-positive", "Cnd1", "S-positive")
    yield Line(
        "colliding-pair-apart",
        1 < dot(place, place),
        scaled(times("A-positive", "goal"), times(factor, plus(factor, impact)))._replace(
            equations=(("approach", as_term(1)),)
        ),
        THEOREM,
        "the pair 0-c does not meet before τ",
    )


def _others() -> Iterator[Item]:
    place = away(t)
    yield Line(
        "spectator-apart",
        1 + 2 * t * frame.eta_s <= dot(place, place),
        proof(times("t-lower", "t-lower", "B-positive")),
        THEOREM,
        "the pair 0-s that just met recedes: it does not meet again",
    )
    outer: Combination = add(add(scale(1 + d, omega_c), scale(-1, omega_s)), scale(t, difference))
    yield Line(
        "outer-pair-apart",
        1 < dot(outer, outer),
        _outer_reason(),
        "EQUATSS4.1Recurrence_CndT",
        "the outer pair s-c is apart for all times from 0 to τ, both included",
    )


def _outer_reason() -> BySum:
    v0, speed = "V_0-positive", "speed-positive"
    together = plus(
        times(2, "C-positive", "d-sum-positive"),
        times(2, "d-positive"),
        square(d - t * (y + b)),
        times(square(t), "cs-outer"),
        times(2, "t-lower", plus("y-upper", "a-upper", "b-upper", "recedes")),
        times(6, "t-upper", speed),
    )
    return scaled(
        times(v0, "goal"),
        times(v0, together),
        times(6, speed, "time-crude"),
        times(12, speed, "y-bound"),
        times(Fraction(12, 7), "time-short"),
        times(Fraction(12, 7), v0, "root-two-upper"),
    )
