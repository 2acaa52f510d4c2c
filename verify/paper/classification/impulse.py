"""The whole system in the frame of its centre of mass: the total impulse, and infinite time.

Positions and velocities of all balls are two vectors with the inner product Sum m x.v. R and e are
their lengths, A is their product. In free flight the one moves in a straight line, so that R is
a distance like any other. The total impulse is bounded for ever.

If there are infinitely many collisions in infinite time, then A <= 0 always, and the impulses
times their times have a finite sum. Q is the sum over the collisions so far of sigma t_n J_n, T the
time. No integral is taken: the number Q + R^2/2 - T A never rises.
"""

from __future__ import annotations

from collections.abc import Iterator
from fractions import Fraction

from verify.language.argument import (
    ByInstance,
    Chapter,
    Item,
    Line,
    Opened,
    identity,
    plus,
    power,
    proof,
    scaled,
    square,
    times,
)
from verify.language.terms import as_term, equal
from verify.paper.classification import flight
from verify.paper.letters import Letters

LABEL = "PROPOSS3.2SommaCompNormlV"
COLLAPSE = "DEFINSS3.1Collapse_Inelas"

w = Letters("whole", R="R", e="e", A="A", t="t", R_t="R(t)")
g = Letters("total", R="R", e="e", A="A", P="P", I="I", S="Σσ J", R_0="R(0)", A_0="A(0)", t="t",
            R_t="R(t)", slow="e'", hit="σ J")  # fmt: skip
s = Letters("spin", X="|x|²", V="|v|²", s="x·v", a="x·p", b="x·q", c="v·p", d="v·q", t="t")


def chapters() -> Iterator[Chapter]:
    """Flight, the sums along an orbit, and the angular momentum."""
    whole = w.opened(
        "a system of balls in free flight for a time t > 0",
        f"1 1 0 {Fraction(3, 4)} {Fraction(5, 4)}",
        {
            "R": 0 < w.R,
            "e": 0 <= w.e,
            "time": 0 < w.t,
            "later": 0 < w.R_t,
            "cs": w.A**2 <= w.R**2 * w.e**2,
            "distance": equal(w.R_t**2, w.R**2 + 2 * w.t * w.A + w.t**2 * w.e**2),
        },
    )
    yield Chapter(None, (Opened(whole),))
    yield Chapter(w.context, (*_whole(), *_ratio()))
    yield from _total()
    yield from _spin()


def _whole() -> Iterator[Item]:
    uses = ("cauchy-schwarz",)
    size = times(2, "whole-R", "whole-e")
    for name, side, letter in (("upper", w.A, "A"), ("lower", -w.A, "-A")):
        yield Line(f"virial-{name}", side <= w.R * w.e,
                   scaled(times("goal", plus("goal", size)), "whole-cs"),
                   LABEL, f"{letter} ≤ R e", uses)  # fmt: skip
    yield from (
        Line("growth",       w.R_t <= w.R + w.t * w.e,
             scaled(times("goal",
                          plus("goal", times(2, plus("whole-R", times("whole-time", "whole-e"))))),
                    times(2, "whole-time", "virial-upper"))
             ._replace(equations=(("whole-distance", as_term(-1)),)),
             LABEL, "R grows at most as fast as e: R(t) ≤ R + te", uses),
        Line("trapezoid",    equal(w.R_t**2 - w.R**2, w.t * (w.A + (w.A + w.t * w.e**2))),
             identity("", (("whole-distance", as_term(1)),)),
             LABEL, "(R²)' = 2A and A' = e², between two instants: R(t)² - R² = t (A + A(t))"),
        Line("energy-least", w.A / w.R <= w.e, proof("virial-upper"), COLLAPSE, "A/R ≤ e", uses),
    )  # fmt: skip


def _ratio() -> Iterator[Item]:
    at = flight.values(w.R, w.A / w.R, w.e**2, w.t, w.R_t)
    yield from (
        Line("whole-cs-path", flight.given_at("cs", at),
             proof(times(power("whole-R", 2), "whole-cs"))),
        Line("whole-path",    flight.given_at("distance", at),
             identity("", (("whole-distance", w.R),))),
    )  # fmt: skip
    premises = ("whole-R", "whole-later", "whole-time", "whole-cs-path", "whole-path")
    yield from flight.used("whole-normal", flight.NORMAL, at, premises)
    yield Line("ratio-flight", w.A / w.R <= (w.A + w.t * w.e**2) / w.R_t,
               scaled(times("whole-R", "goal"), "whole-normal"), COLLAPSE,
               "A/R never falls in free flight: it is the ρ of the whole system",
               ("cauchy-schwarz",))  # fmt: skip


def _total() -> Iterator[Chapter]:
    context = g.opened(
        "a system after some collisions: P is R(0) plus the integral of e, I the integral of e²; "
        "then a flight of length t, and a collision, or several of disjoint pairs at one time, "
        "with σJ > 0 in all, after which e' ≤ e",
        f"1 1 0 1 0 0 1 0 {Fraction(3, 4)} {Fraction(5, 4)} 1 1",
        {
            "R": 0 < g.R,
            "e": 0 <= g.e,
            "time": 0 < g.t,
            "later": 0 < g.R_t,
            "cs": g.A**2 <= g.R**2 * g.e**2,
            "distance": equal(g.R_t**2, g.R**2 + 2 * g.t * g.A + g.t**2 * g.e**2),
            "path": g.R <= g.P,
            "start": g.R_0 <= g.P,
            "virial": equal(g.A, g.A_0 + g.I + g.S),
            "weighted": g.P * g.e <= g.R_0 * g.e + g.I,
            "slow": 0 <= g.slow,
            "slower": g.slow <= g.e,
            "hit": 0 < g.hit,
        },
    )
    yield Chapter(None, (Opened(context),))
    yield Chapter(g.context, tuple(_sums()))


def _sums() -> Iterator[Item]:
    at = w.at(R=g.R, e=g.e, A=g.A, t=g.t, R_t=g.R_t)
    premises = tuple(f"total-{n}" for n in ("R", "e", "time", "later", "cs", "distance"))
    yield Line("total-upper", g.A <= g.R * g.e, ByInstance("virial-upper", at, premises))
    yield Line("total-growth", g.R_t <= g.R + g.t * g.e, ByInstance("growth", at, premises))
    move = times("total-time", "total-e")
    further, longer = g.P + g.t * g.e, g.I + g.t * g.e**2
    yield from (
        Line("next-path", g.R_t <= further, proof("total-growth", "total-path"),
             LABEL, "R stays at most P"),
        Line("next-start", g.R_0 <= further, proof("total-start", move), LABEL, "P stays ≥ R(0)"),
        Line("next-virial", equal((g.A + g.t * g.e**2) + g.hit, g.A_0 + longer + (g.S + g.hit)),
             identity("", (("total-virial", as_term(1)),)), LABEL, "A = A(0) + I + Σσ J goes on"),
        Line("next-weighted", further * g.slow <= g.R_0 * g.slow + longer,
             proof("total-weighted", times(plus("total-start", move), "total-slower")),
             LABEL, "P e ≤ R(0) e + I goes on, as e never rises"),
        Line("total-impulse", g.S <= g.R_0 * g.e - g.A_0,
             proof("total-upper", times("total-path", "total-e"), "total-weighted",
                   equations=(("total-virial", as_term(1)),)),
             LABEL, "so Σ σ J ≤ R(0) e - A(0) for all time", ("cauchy-schwarz",)),
    )  # fmt: skip


def _spin() -> Iterator[Chapter]:
    context = s.opened(
        "x and v are the place and the velocity of a ball, p and q any vectors, t any time",
        "1 1 0 0 0 0 0 0",
        {},
    )
    yield Chapter(None, (Opened(context),))
    yield Chapter(s.context, (
        Line("spin-flight",
             equal((s.a + s.t * s.c) * s.d - (s.b + s.t * s.d) * s.c, s.a * s.d - s.b * s.c),
             identity(), LABEL, "the angular momentum is kept in free flight, x becomes x+tv"),
        Line("spin-length", s.X * s.V - s.s**2 <= s.X * s.V, proof(square(s.s)),
             LABEL, "|x∧v|² = |x|²|v|² - (x·v)² ≤ |x|²|v|²", ("cauchy-schwarz",)),
    ))  # fmt: skip


HALF = Fraction(1, 2)

i = Letters("inward", R="R", e="e", A="A", t="t", R_t="R(t)", T="T", Q="Σσ t_n J_n", R_0="R(0)",
      hit="σ J")  # fmt: skip


def endless() -> Iterator[Chapter]:
    """One flight and one collision, while A <= 0."""
    context = i.opened(
        "a system at the time T with A ≤ 0, then a flight of length t to a collision with σJ, "
        "before which A ≤ 0 still",
        "2 1 -2 1 1 0 0 2 1",
        {
            "R": 0 < i.R,
            "time": 0 < i.t,
            "T": 0 <= i.T,
            "A": i.A <= 0,
            "A-later": i.A + i.t * i.e**2 <= 0,
            "distance": equal(i.R_t**2, i.R**2 + 2 * i.t * i.A + i.t**2 * i.e**2),
            "weighted": i.Q + i.R**2 / 2 - i.T * i.A <= i.R_0**2 / 2,
            "hit": 0 < i.hit,
        },
    )
    yield Chapter(None, (Opened(context),))
    yield Chapter(i.context, tuple(_inward()))


def _inward() -> Iterator[Item]:
    later = i.T + i.t
    virial = i.A + i.t * i.e**2 + i.hit
    yield from (
        Line("ratio-collision", i.A / i.R <= (i.A + i.hit) / i.R,
             proof(times("inward-R", "inward-hit")), COLLAPSE, "A/R jumps up at a collision"),
        Line("shrinks",         i.R_t**2 <= i.R**2,
             proof(times("inward-time", "inward-A"), times("inward-time", "inward-A-later"),
                   equations=(("inward-distance", as_term(-1)),)), COLLAPSE, "R falls while A ≤ 0"),
        Line("next-times",      i.Q + later * i.hit + i.R_t**2 / 2 - later * virial <= i.R_0**2 / 2,
             proof("inward-weighted", times(HALF, square(i.t * i.e)),
                   times("inward-T", "inward-time", square(i.e)),
                   equations=(("inward-distance", as_term(-HALF)),)),
             COLLAPSE, "Σσ t_n J_n + R²/2 - T A never rises"),
        Line("impulse-times",   i.Q <= i.R_0**2 / 2,
             proof("inward-weighted", times("inward-T", "inward-A"), times(HALF, square(i.R))),
             COLLAPSE, "so Σσ t_n J_n ≤ R(0)²/2"),
    )  # fmt: skip
