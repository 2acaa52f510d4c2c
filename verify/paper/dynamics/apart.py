"""Until the collision the pair that will collide is apart, and the pair that just met separates."""

from __future__ import annotations

from collections.abc import Iterator
from fractions import Fraction

from verify.language.argument import (
    Chapter,
    Item,
    Line,
    Opened,
    identity,
    plus,
    proof,
    scaled,
    times,
)
from verify.language.statement import Context, Given, Variable
from verify.language.terms import Term, as_term, equal, symbol
from verify.paper.dynamics.state import CONTEXT, A, S, away, contact, d, frame, tau, y
from verify.paper.parameters import THEOREM

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


def opened() -> Chapter:
    """Both contexts, at half of the time."""
    before, meanwhile = contexts()
    return Chapter(
        CONTEXT,
        (
            Line("half-positive", 0 <= tau / 2, proof(times(Fraction(1, 2), "tau-positive"))),
            Line("half-before", tau / 2 < tau, proof(times(Fraction(1, 2), "tau-positive"))),
            Line("half-until", tau / 2 <= tau, proof(times(Fraction(1, 2), "tau-positive"))),
            Opened(before, ("half-positive", "half-before")),
            Opened(meanwhile, ("half-positive", "half-until")),
        ),
    )


def colliding() -> Iterator[Item]:
    """Before the collision, of the pair that will collide."""
    place = contact(frame, s)
    left = A * tau - A * s
    rest = left * (left + 2 * (1 + d) * y * S)
    yield Line("approach", equal(A * (dot(place, place) - 1), rest), identity("tau S"), THEOREM,
               "|path|² - 1 has the contact at τ as its first root")  # fmt: skip
    factor = times("A-positive", "s-upper")
    impact = times(2, "d-sum-positive", "Cnd1", "S-positive")
    yield Line("colliding-pair-apart", 1 < dot(place, place),
               scaled(times("A-positive", "goal"), times(factor, plus(factor, impact)))
               ._replace(equations=(("approach", as_term(1)),)), THEOREM,
               "the pair 0-c does not meet before τ")  # fmt: skip


def spectator() -> Line:
    """Up to the collision, of the pair that just met."""
    place = away(t)
    return Line("spectator-apart", 1 + 2 * t * frame.eta_s <= dot(place, place),
                proof(times("t-lower", "t-lower", "B-positive")), THEOREM,
                "the pair 0-s that just met recedes: it does not meet again")  # fmt: skip
