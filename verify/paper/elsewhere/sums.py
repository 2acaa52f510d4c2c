"""Section 3.2 and the notation of 3.3: sums of times, of flights and of normal components."""

from __future__ import annotations

from collections.abc import Iterator
from fractions import Fraction

from verify.language.argument import (
    Chapter,
    Item,
    Line,
    identity,
    plus,
    power,
    proof,
    scaled,
    square,
    times,
)
from verify.language.terms import as_term, equal
from verify.paper.letters import Letters, Refuted, refuted, subject
from verify.paper.rows import BREAKS, HARMLESS, REMARK, SLIP

INTERVALS = "PROPOSS3.2ConveInterTemps"
PLACES = "PROPOSS3.2ConveAngleDista"
NOT_COLLIDING = "EQUATSS3.2eta_ij_CasNColl"
SUMMABLE = "PROPOSS3.2SommaCompNormlV"
NOTATION = "SSECTI03.3CompoAsympVaria"

clock = Letters("clock", t_0="t₀", t_1="t₁", t_2="t₂", t_3="t₃")
path = Letters("path", moved="x-x₀", time="t", speed="v", V="sup|v|", tau="τ")
free = Letters("free", D="|x|", rho="ρ", w="|w|", t="t", E="|x+tw|")
window = Letters("window", s="η", b="a", c="c", Q="Σa²", alpha="α")
small = Letters("small", s="x", q="q")


def chapters() -> Iterator[Chapter]:
    """One context a subject; the numbers in each are any that satisfy what is listed."""
    yield from _clock()
    yield from _path()
    yield from _free()
    yield from _window()
    says = "a number x > 0, and q with 0 < q < 1"
    yield from subject(
        small, says, "1 1/2", {"x": 0 < small.s, "q": 0 < small.q, "q-one": small.q < 1}
    )


def _clock() -> Iterator[Chapter]:
    c = clock
    telescope = Line("intervals-telescope",
                     equal((c.t_1 - c.t_0) + (c.t_2 - c.t_1) + (c.t_3 - c.t_2), c.t_3 - c.t_0),
                     identity(), INTERVALS,
                     "τ_n = t_n - t_{n-1} add up to t_N - t_0, so they are summable in a collapse",
    )  # fmt: skip
    givens = {"first": c.t_0 < c.t_1, "second": c.t_1 < c.t_2, "third": c.t_2 < c.t_3}
    yield from subject(clock, "four times of collisions in a row", "0 1 2 3", givens, (telescope,))


def _path() -> Iterator[Chapter]:
    givens = {
        "time": 0 <= path.tau,
        "upper": path.speed <= path.V,
        "lower": -path.speed <= path.V,
        "moved-upper": path.moved <= path.V * path.time,
        "moved-lower": -path.moved <= path.V * path.time,
    }
    later = path.V * (path.time + path.tau)
    end = path.moved + path.tau * path.speed
    lines = (Line(f"path-{side}-next", term <= later,
                  proof(f"path-moved-{side}", times("path-time", f"path-{side}")), PLACES,
                  "each flight adds τv: |x(t_p) - x(t_q)| ≤ sup|v| Σ τ_n goes on")
             for side, term in (("upper", end), ("lower", -end)))  # fmt: skip
    says = "a coordinate of a ball after some flights, and one more of length τ"
    yield from subject(path, says, "0 1 1 1 1", givens, lines)


def _free() -> Iterator[Chapter]:
    f = free
    givens = {
        "now-apart": 0 < f.D,
        "later-apart": 0 < f.E,
        "time": 0 < f.t,
        "upper": f.rho <= f.w,
        "lower": -f.rho <= f.w,
        "speed": 0 <= f.w,
        "distance": equal(f.E**2, f.D**2 + 2 * f.t * (f.D * f.rho) + f.t**2 * f.w**2),
    }
    says = "a pair in free flight for a time t, ρ = x·w/|x| its normal component"
    yield from subject(free, says, "1 0 1 3/4 5/4", givens, _gain())


def _gain() -> Iterator[Item]:
    f = free
    forward, backward = "free-lower", "free-upper"
    half = Fraction(1, 2)
    yield from (
        Line("free-upper-distance", f.E <= f.D + f.t * f.w,
             scaled(times("goal",
                          plus("goal",
                               times(2, plus("free-now-apart", times("free-time", "free-speed"))))),
                    times(2, "free-time", "free-now-apart", backward))
             ._replace(equations=(("free-distance", as_term(-1)),))),
        Line("free-tangent",        f.D + f.t * f.rho <= f.E,
             scaled(times("goal", plus("goal", times(2, "free-later-apart"))),
                    times(power("free-time", 2), forward, backward))
             ._replace(equations=(("free-distance", as_term(1)),))),
        Line("flight-gain",         f.D * f.rho + f.t * f.w**2 <= f.E * f.rho + 2 * f.t * f.w**2,
             proof(times(half, forward, "free-tangent"),
                   times(half, backward, "free-upper-distance"),
                   times(half, "free-time", power(forward, 2))), NOT_COLLIDING,
             "|x+tw| (ρ' - ρ) ≤ 2t|w|²: a flight adds at most 2t|w|² to a normal component"),
    )  # fmt: skip


def _window() -> Iterator[Chapter]:
    w = window
    c_2 = power("window-c", 2)
    bound = Line("window-next", (w.s + w.b) ** 2 <= (w.c + 1) ** 2 * (w.Q + w.b**2),
                 scaled(times("goal", c_2), times("window-so-far", plus(1, c_2)),
                        square(w.s - w.c**2 * w.b),
                        times(2, power("window-c", 3), plus("window-Q", square(w.b)))), SUMMABLE,
                 "so η² ≤ c² Σa² over a window goes on with c+1: with finite gaps Σ η² is finite",
    )  # fmt: skip
    givens = {"Q": 0 <= w.Q, "c": 0 < w.c, "so-far": w.s**2 <= w.c**2 * w.Q}
    says = "a normal component η, η² ≤ c² Σa², which others' collisions and flights change by a"
    yield from subject(window, says, "1 1 1 1 1/2", givens, (bound,))


def misprints() -> Iterator[Refuted]:
    """What is false here, each with a point at which it is."""
    yield from (
        refuted(clock, "interval-index",
                equal(clock.t_3 - (clock.t_2 - clock.t_1), clock.t_3 - clock.t_2), "0 1 2 3",
                label=INTERVALS,
                says="τ_n = t_n - τ_{n-1}, twice; here n = 3, with τ_2 = t_2 - t_1", severity=SLIP,
                corrected_by="intervals-telescope"),
        refuted(free, "flight-forgotten",
                equal(free.D * free.rho + free.t * free.w**2, free.E * free.rho), "1 0 1 3/4 5/4",
                label=NOT_COLLIDING,
                says="η'_p = η_{p+1}: the normal component just after a collision is the one just "
                     "before the next; the free flight between them is forgotten", severity=BREAKS,
                corrected_by="flight-gain"),
        refuted(window, "window-same",
                equal((window.s + window.alpha * window.b) ** 2,
                      (window.s + window.alpha * window.s) ** 2), "1 0 1 1 1/2", label=SUMMABLE,
                says="η²_k = a²_{φ(n)-1}(1+kα_n)² in the last display of the proof: each step adds "
                     "an a_k of its own, not the same one", severity=HARMLESS,
                corrected_by="window-next"),
        refuted(small, "negligible-printed", small.s <= small.q * small.s, "1 1/2", label=NOTATION,
                says="the definition of y = o(x) is |y| ≤ φ(|x|) for a function φ that vanishes at "
                     "0: it means less than negligible, as with φ(x) = x it holds for y = x, which "
                     "is not below qx", severity=REMARK,
                corrected_by="distance-by-time"),
    )  # fmt: skip
