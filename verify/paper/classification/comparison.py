"""What the recursion of closing speeds implies: u_3 <= a u_2 - r u_1 with a < 2 sqrt(r) ends.

s stands for the square root of r.
"""

from __future__ import annotations

from collections.abc import Iterator
from fractions import Fraction
from itertools import pairwise

from verify.language.argument import (
    ByInduction,
    ByInterval,
    ByRoot,
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
from verify.language.statement import Always
from verify.language.terms import equal, sqrt, substitute_claim
from verify.paper.letters import Letters

EXISTENCE = "EQUATSS3.4ZKCl1CondiExist"
TEXT = "SSSCT3.4.2LineaZhou-Kadan"

u = Letters("speeds", u_1="u_n", u_2="u_{n+1}", u_3="u_{n+2}", a="a", r="r")
q = Letters("ratio", q="q", s="√r", a="a")
c = Letters("final", s="√r", C="C")
above = Letters("above", r="r")
below = Letters("below", r="r")
n = Letters("line", x="x", a="a", r="r", s_0="s_{n-2}", s_1="s_{n-1}")
k = Letters("endless", low="s_n", high="s_{n+1}")
k_0 = Letters("unbounded", a="a", r="r")
root_3 = sqrt(3)


def chapters() -> Iterator[Chapter]:
    """The fall of the ratio, the least angle, the values of r."""
    yield Chapter(None, (Line("root-three", 0 < root_3, ByInterval()),))
    yield from _ratio()
    yield from _final()
    yield from _values()
    yield from _endless()
    yield from _line()


def _ratio() -> Iterator[Chapter]:
    speeds = u.opened(
        "three closing speeds in turn with u_{n+2} ≤ a u_{n+1} - r u_n",
        "1 1 0 1 1",
        {"first": 0 < u.u_1, "second": 0 < u.u_2, "recursion": u.u_3 <= u.a * u.u_2 - u.r * u.u_1},
    )
    ratio = q.opened(
        "q > 0, √r > 0 and a < 2√r",
        "1 1 1",
        {"positive": 0 < q.q, "root": 0 < q.s, "small": q.a < 2 * q.s},
    )
    yield Chapter(None, (Opened(speeds), Opened(ratio)))
    quotient = Line("speeds-ratio", 0 < u.u_2 / u.u_1, proof("speeds-second"))
    yield Chapter(u.context, (
        quotient,
        Line("ratio-law", u.u_3 / u.u_2 <= u.a - u.r / (u.u_2 / u.u_1),
             proof(times("speeds-second", "speeds-recursion")),
             EXISTENCE, "q_{n+1} ≤ a - r/q_n for the ratios q_n = u_{n+1}/u_n"),
    ))  # fmt: skip
    yield Chapter(q.context, (
        Line("ratio-falls",   2 * q.s - q.a <= q.q - (q.a - q.s**2 / q.q), proof(square(q.q - q.s)),
             EXISTENCE, "q - (a - r/q) ≥ 2√r - a, since (q-√r)² ≥ 0"),
        Line("fall-positive", 0 < 2 * q.s - q.a, proof("ratio-small"),
             EXISTENCE, "so the ratio falls by a fixed amount each time"),
    ))  # fmt: skip


def _final() -> Iterator[Chapter]:
    least = 4 * c.s / (1 + c.s**2)
    context = c.opened(
        "√r > 0, and the cosine at 0 stays below the bound: C < 4√r/(1+r)",
        "1 0",
        {"root": 0 < c.s, "size": 0 < 1 + c.s**2, "angle": c.C < least},
    )
    yield Chapter(None, (Opened(context),))
    small = Line("angle-small", (1 + c.s**2) / 2 * c.C < 2 * c.s,
                 scaled(times(2, "goal"), "final-angle"),
                 EXISTENCE, "if -cos θ < 4√r/(1+r), then a = (1+r)/2 (-cos θ) < 2√r")  # fmt: skip
    yield Chapter(c.context, (small,))


def _values() -> Iterator[Chapter]:
    high = above.opened(
        "r in ]7-4√3, 1]", "1/2", {"low": 7 - 4 * root_3 < above.r, "high": above.r <= 1}
    )
    low = below.opened(
        "r in ]0, 7-4√3]", "1/20", {"low": 0 < below.r, "high": below.r <= 7 - 4 * root_3}
    )
    bound = Line("r-exist-positive", 0 < 7 - 4 * root_3, ByInterval())
    yield Chapter(None, (bound, Opened(high), Opened(low)))
    yield Chapter(above.context, tuple(_above()))
    root = sqrt(below.r)
    apart = times("below-high", plus("below-high", times(8, "root-three")))
    size = plus(1, "below-low")
    yield Chapter(below.context, (
        Line("below-size",      0 < 1 + below.r, proof(size)),
        Line("below-root",      0 < root, ByRoot()),
        Line("below-square",    0 <= below.r**2 - 14 * below.r + 1, proof(apart),
             TEXT, "r² - 14r + 1 ≥ 0 for r in ]0, 7-4√3], so that its sign decides"),
        Line("below-real",      4 * below.r <= ((1 + below.r) / 2) ** 2,
             proof(times(Fraction(1, 4), "below-square")),
             TEXT, "a² ≥ 4r for a = (1+r)/2 and these r"),
        Line("bound-below-one", 4 * root / (1 + below.r) <= 1,
             scaled(times("goal", plus("goal", times(2, size))), apart),
             TEXT, "for r ≤ 7-4√3 the bound 4√r/(1+r) excludes nothing on a line"),
    ))  # fmt: skip


def _above() -> Iterator[Item]:
    r = above.r
    yield from (
        Line("above-positive",  0 < r, proof("r-exist-positive", "above-low")),
        Line("above-size",      0 < 1 + r, proof(1, "above-positive")),
        Line("above-root",      0 < sqrt(r), ByRoot()),
        Line("above-square",    r**2 - 14 * r + 1 < 0,
             proof(times("above-low", plus("above-high", 6, times(4, "root-three")))),
             TEXT, "r² - 14r + 1 < 0 for r in ]7-4√3, 1]"),
        Line("bound-above-one", 1 < 4 * sqrt(r) / (1 + r),
             scaled(times("goal", plus(1, "above-positive", times(4, "above-root"))),
                    "above-square"),
             TEXT, "for r > 7-4√3 the bound 4√r/(1+r) exceeds every cosine"),
    )  # fmt: skip


def _endless() -> Iterator[Chapter]:
    parent = k_0.opened(
        "a² ≥ 4r, a > 0, r > 0; this is so for a = (1+r)/2 and r ≤ 7-4√3",
        "1 1/4",
        {"a": 0 < k_0.a, "r": 0 < k_0.r, "real": 4 * k_0.r <= k_0.a**2},
    )
    following = k_0.a * k.high - k_0.r * k.low
    givens = {"high": 0 < k.high, "grows": k_0.a / 2 * k.low <= k.high}
    start, after = k.at(low=0, high=1), k.at(low=k.high, high=following)
    at_start = {n: substitute_claim(claim, start) for n, claim in givens.items()}
    context = k.opened("two terms in turn of the comparison sequence", "0 1", givens, k_0.context)
    carried = tuple(given._replace(kind="carried") for given in context.givens)
    names = tuple(f"start-{name}" for name in givens)
    yield Chapter(None, (Opened(parent),))
    opening = tuple(Line(f"start-{n}", claim, proof(1)) for n, claim in at_start.items())
    yield Chapter(k_0.context, (*opening, Opened(context._replace(givens=carried), names)))
    half = Fraction(1, 2)
    grows = Line("next-grows", substitute_claim(givens["grows"], after),
                 scaled(times("unbounded-a", "goal"), times(half, "endless-high", "unbounded-real"),
                        times(2, "unbounded-r", "endless-grows")))  # fmt: skip
    high = Line("next-high", substitute_claim(givens["high"], after),
                proof("next-grows", times(half, "unbounded-a", "endless-high")))  # fmt: skip
    yield Chapter(k.context, (grows, high))
    always = Line("comparison-endless", Always(k.context, start, after),
                  ByInduction(names, ("next-high", "next-grows")), TEXT,
                  "if a² ≥ 4r, then s_n > 0 for every n ≥ 1: the comparison sequence ends no run",
    )  # fmt: skip
    yield Chapter(k_0.context, (always,))


def _line() -> Iterator[Chapter]:
    following = n.a * n.s_1 - n.r * n.s_0
    after = n.a * following - n.r * n.s_1
    terms = (n.s_0, n.s_1, following, after)
    first, second, third = (n.x * high - n.r * low for low, high in pairwise(terms))
    context = n.opened(
        "three balls on a line: u_n = x s_{n-1} - r s_{n-2}, so that u_1 = 1 and u_2 = x; x is "
        "larger than r s_{n-2}/s_{n-1}",
        "1 1 1 0 1",
        {"term": 0 < n.s_1, "large": n.r * n.s_0 / n.s_1 < n.x},
    )
    yield Chapter(None, (Opened(context),))
    yield Chapter(n.context, (
        Line("line-solution", equal(third, n.a * second - n.r * first), identity(),
             EXISTENCE, "these u_n solve u_{n+2} = a u_{n+1} - r u_n"),
        Line("line-positive", 0 < first, proof("line-large"),
             EXISTENCE, "and u_n > 0 while s_{n-1} > 0, if u_2 = x is large enough"),
    ))  # fmt: skip
