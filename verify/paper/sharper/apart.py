"""Until the collision, and at its instant, no other pair of particles is in contact."""

from __future__ import annotations

from collections.abc import Iterator
from fractions import Fraction

from verify.language.argument import ByRoot, Chapter, Item, Line, plus, proof, scaled, square, times
from verify.language.terms import sqrt
from verify.language.vectors import add, omega_c, omega_s, scale
from verify.paper.dynamics.apart import colliding, contexts, opened, spectator, t
from verify.paper.dynamics.state import CONTEXT, d, difference, frame
from verify.paper.parameters import THEOREM
from verify.paper.sharper.numbers import V

dot = frame.dot
#: From particle s to particle c at the start, and its length.
outer = add(scale(1 + d, omega_c), scale(-1, omega_s))
length = sqrt(dot(outer, outer))
close = dot(outer, difference)


def chapters() -> Iterator[Chapter]:
    """The three pairs."""
    before, meanwhile = contexts()
    yield Chapter(CONTEXT, tuple(_outer()))
    yield opened()
    yield Chapter(before.name, tuple(colliding()))
    yield Chapter(meanwhile.name, (spectator(), *_outer_pair()))


def _outer() -> Iterator[Item]:
    positive = plus(times(2, "C-positive", "d-sum-positive"), times(2, "d-positive"), square(d))
    yield from (
        Line("outer-least",    2 <= dot(outer, outer), proof(positive)),
        Line("outer-positive", 0 < dot(outer, outer), proof("outer-least", 2)),
        Line("outer-root",     0 < length, ByRoot()),
        Line("outer-length",   Fraction(7, 5) < length,
             scaled(times("goal", plus(Fraction(7, 5), "outer-root")), "outer-least",
                    Fraction(1, 25)),
             says="√2 > 7/5: how far the outer particles are from one another, as θ is obtuse"),
        Line("outer-speed",    dot(difference, difference) <= 4 * V**2,
             proof("A-below", "B-below", times(2, "w-lower"))),
        Line("outer-closing",  -close <= 2 * V * length,
             scaled(times("goal", plus("goal", times(4, "V-positive", "outer-root"))), "cs-apart",
                    times("outer-positive", "outer-speed")),
             says="by Cauchy-Schwarz: they approach one another with 2V at most"),
    )  # fmt: skip


def _outer_pair() -> Iterator[Item]:
    path = add(outer, scale(t, difference))
    more = plus("outer-turn", times(2, "outer-root"))
    yield from (
        Line("outer-turn",       length < dot(outer, outer) + t * close,
             proof(times("outer-root", "outer-length"), times("t-lower", "outer-closing"),
                   times(2, "V-positive", "outer-root", "t-upper"),
                   times(Fraction(2, 5), "outer-root", "time-short"))),
        Line("outer-pair-apart", 1 < dot(path, path),
             scaled(times("outer-positive", "goal"), times(square(t), "cs-apart"),
                    times("outer-turn", more)),
             THEOREM, "the outer pair s-c is apart for all times from 0 to τ, both included"),
    )  # fmt: skip
