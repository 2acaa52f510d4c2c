"""Two spheres in free flight: three numbers show that they stay apart, two that they never meet.

With g = |x|² - 1, p = x·w and m = |w|² the squared distance after t is 1 + g + 2pt + mt².
"""

from __future__ import annotations

from collections.abc import Iterator

from verify.language.argument import (
    Chapter,
    Line,
    Opened,
    Value,
    plus,
    proof,
    scaled,
    square,
    times,
)
from verify.language.terms import Claim, symbol
from verify.spheres.flow.law import Number, Pair
from verify.spheres.flow.spaces import space

PARTING, PASSING = "parting", "passing"
FREE = "EQUATSS2.1_Loi_de_Newton_"


def bernstein_claims(name: str, pair: Pair, time: Number) -> dict[str, Claim]:
    """What shows that a pair is apart at all times in ]0, time].

    g, g + p time and the last value are the coefficients of the squared distance less 1 in
    Bernstein's basis.
    """
    g, p, m = pair
    return {
        f"{name}-first": 0 <= g,
        f"{name}-middle": 0 <= g + p * time,
        f"{name}-last": 0 < g + time * (2 * p + m * time),
    }


def chapters() -> Iterator[Chapter]:
    """Two pairs that do not collide any more: one that recedes, one that misses."""
    yield from _parting()
    yield from _passing()


def _numbers(prefix: str) -> Pair:
    return Pair(*(symbol(f"{prefix}.{name}") for name in Pair._fields))


def _parting() -> Iterator[Chapter]:
    (_, p, m), t = _numbers(PARTING), symbol("t_parting")
    givens = {"parting-slow": 0 <= p, "parting-speed": 0 <= m}
    says = "two spheres do not approach: x·w = p >= 0, |w|² = m"
    outside = space(PARTING, says, {"parting.p": 0, "parting.m": 1}, givens)
    time = {"t_parting-positive": 0 <= t}
    inside = space("parting-later", "a later time", {t.name: 1}, time, PARTING)
    yield Chapter(None, (Opened(outside),))
    yield Chapter(PARTING, (Opened(inside),))
    line = Line("never-approach", 0 <= p + t * m,
                proof("parting-slow", times("t_parting-positive", "parting-speed")), FREE,
                "nor do they after any time t of free flight: (x + tw)·w >= 0, so they do not "
                "collide")  # fmt: skip
    yield Chapter(inside.name, (line,))


def _passing() -> Iterator[Chapter]:
    (g, p, m), t = _numbers(PASSING), symbol("t_passing")
    givens = {"passing-speed": 0 < m, "passing-far": p**2 < m * g}
    point = {"passing.g": 1, "passing.p": 0, "passing.m": 1}
    says = "two spheres pass each other: |x|² - 1 = g, x·w = p, |w|² = m, and p² < mg"
    outside = space(PASSING, says, point, givens)
    inside = space("passing-time", "a time", {t.name: 1}, {}, PASSING)
    yield Chapter(None, (Opened(outside),))
    yield Chapter(PASSING, (Opened(inside),))
    line = Line("never-touch", 0 < g + t * (2 * p + m * t),
                scaled(times("goal", "passing-speed"), square(m * t + p), "passing-far"),
                FREE, "they never touch: |x + tw| > 1 at any time t")  # fmt: skip
    yield Chapter(inside.name, (line,))


def between(name: str, share: str, rest: str) -> Value:
    """The squared distance less 1, at a share of the time of flight, in Bernstein's basis."""
    return plus(
        times(rest, rest, f"{name}-first"),
        times(2, share, rest, f"{name}-middle"),
        times(share, share, f"{name}-last"),
    )
