"""For scenes: when there is no collision, no collapse, or no collapse after a time.

Diameter 1 and equal masses 1. A collapse of three has R² ≤ 2: two distances are 1 there.
"""

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
    power,
    proof,
    scaled,
    square,
    times,
)
from verify.language.terms import Term, equal, sqrt
from verify.language.vectors import add, basis_vector, scale
from verify.paper.letters import Letters, Space, minus

LABEL = "DEFINSS3.1Collapse_Inelas"
MISS = "EQUATSS2.2DiscrTrinox2-x0"

away = Letters("away", X="|x|²", p="x·w", W="|w|²", t="t")
miss = Letters("miss", X="|x|²", p="x·w", W="|w|²", t="t")
three = Letters("three", yy="|y|²", zz="|z|²", yz="y·z")
touch = Letters("touching", yz="y·z")
out = Letters("outward", R="R²", e="e", A="A", t="t")
turn = Letters("turning", L="L²", R="R²", rho="ρ²", e="e²")
late = Letters("late", R="R(0)²", A="A(0)", m="L²/ρ²", T="T", R_T="R²", A_T="A", e="e²", t="t",
               hit="σ J")  # fmt: skip
dead = Letters("deadline", R="R(0)²", A="A(0)", m="L²/ρ²", T="T")
THIRD, MORE = Fraction(1, 3), Fraction(3, 2)


def chapters() -> Iterator[Chapter]:
    """No collision; no collapse; no collapse later."""
    yield from _pair()
    yield from _spread()
    yield from _turning()
    yield from _later()
    yield from _deadline()


def _pair() -> Iterator[Chapter]:
    apart = {"W": 0 <= away.W, "p": 0 <= away.p, "time": 0 <= away.t}
    opened = away.opened("a pair that recedes, x·w ≥ 0, after a time t", "1 0 1 1", apart)
    missing = {"X": 1 <= miss.X, "W": 0 <= miss.W, "miss": miss.W < miss.X * miss.W - miss.p**2}
    says = "a pair whose lines miss: |x|²|w|²-(x·w)² > |w|²; t is any time"
    yield Chapter(None, (Opened(opened), Opened(miss.opened(says, "3 0 1 0", missing))))
    line = Line("scene-away", away.X <= away.X + 2 * away.t * away.p + away.t**2 * away.W,
                proof(times(2, "away-time", "away-p"), times(power("away-time", 2), "away-W")),
                MISS, "(i) a pair with x·w ≥ 0 does not come closer")  # fmt: skip
    yield Chapter(away.context, (line,))
    yield Chapter(miss.context, (
        Line("miss-moves", 0 < miss.W,
             scaled(times("goal", "miss-X"), "miss-miss", square(miss.p))),
        Line("scene-miss", 1 < miss.X + 2 * miss.t * miss.p + miss.t**2 * miss.W,
             scaled(times("miss-moves", "goal"), "miss-miss", square(miss.t * miss.W + miss.p)),
             MISS, "(i) a pair with |x|²|w|²-(x·w)² > |w|² never touches in free flight"),
    ))  # fmt: skip


def _spread() -> Iterator[Chapter]:
    y, z = basis_vector("y"), basis_vector("z")
    space = Space({("y", "y"): three.yy, ("z", "z"): three.zz, ("y", "z"): three.yz})
    places = (
        scale(-THIRD, add(y, z)),
        scale(THIRD, minus(scale(2, y), z)),
        scale(THIRD, minus(scale(2, z), y)),
    )
    total = [space.dot(x, x) for x in places]
    side = minus(z, y)
    sides = three.yy + three.zz + space.dot(side, side)
    law = Line("spread-law", equal(total[0] + total[1] + total[2], sides / 3), identity(),
               LABEL, "R² is a third of the sum of the squares of the three distances")  # fmt: skip
    touching = {"cs": touch.yz**2 <= 1}
    says = "the vectors from one ball to two others that touch it, |y| = |z| = 1"
    outward = {"time": 0 < out.t, "A": 0 <= out.A, "e": 0 < out.e}
    yield Chapter(None, (
        Opened(three.opened("y, z are the vectors from ball 0 to the others", "1 1 0", {})),
        Opened(touch.opened(says, "0", touching)),
        Opened(out.opened("a system with A ≥ 0 in free flight", "2 1 0 1", outward)),
    ))  # fmt: skip
    yield Chapter(three.context, (law,))
    limit = Line("spread-at-collapse", (1 + 1 + (1 + 1 - 2 * touch.yz)) / 3 <= 2,
                 scaled(times(MORE, "goal", plus(times(MORE, "goal"), 2)), "touching-cs"),
                 LABEL, "R² ≤ 2 where one ball touches two", ("cauchy-schwarz",))  # fmt: skip
    yield Chapter(touch.context, (limit,))
    rises = Line("scene-outward", out.R < out.R + 2 * out.t * out.A + out.t**2 * out.e**2,
                 proof(times(2, "outward-time", "outward-A"),
                       power(times("outward-time", "outward-e"), 2)),
                 LABEL, "(iii) if A ≥ 0 and anything moves, R² grows")  # fmt: skip
    yield Chapter(out.context, (rises,))


def _turning() -> Iterator[Chapter]:
    turning = turn.opened(
        "L² ≤ R²e² and R² ≤ ρ²",
        "1 1 1 1",
        {
            "rho": 0 < turn.rho,
            "e": 0 <= turn.e,
            "spin": turn.L <= turn.R * turn.e,
            "R": turn.R <= turn.rho,
        },
    )
    bound = Line("spin-energy", turn.L / turn.rho <= turn.e,
                 proof("turning-spin", times("turning-R", "turning-e")),
                 LABEL, "(iv) e² ≥ L²/ρ² while R² ≤ ρ²")  # fmt: skip
    yield Chapter(None, (Opened(turning),))
    yield Chapter(turn.context, (bound,))


def _later() -> Iterator[Chapter]:
    context = late.opened(
        "a system at the time T, then a flight of length t to a collision with σJ",
        "2 0 1 0 2 0 1 1 1",
        {
            "T": 0 <= late.T,
            "time": 0 < late.t,
            "hit": 0 < late.hit,
            "energy": late.m <= late.e,
            "slope": late.A + late.T * late.m <= late.A_T,
            "square": late.R + 2 * late.T * late.A + late.T**2 * late.m <= late.R_T,
        },
    )
    yield Chapter(None, (Opened(context),))
    then = late.T + late.t
    yield Chapter(late.context, (
        Line("late-slope-next",  late.A + then * late.m <= late.A_T + late.t * late.e + late.hit,
             proof("late-slope", times("late-time", "late-energy"), "late-hit"),
             LABEL, "(iv) A ≥ A(0) + T L²/ρ² goes on"),
        Line("late-square-next",
             late.R + 2 * then * late.A + then**2 * late.m
             <= late.R_T + 2 * late.t * late.A_T + late.t**2 * late.e,
             proof("late-square", times(2, "late-time", "late-slope"),
                   times(power("late-time", 2), "late-energy")), LABEL,
             "(iv) R² ≥ R(0)² + 2T A(0) + T² L²/ρ² goes on"),
    ))  # fmt: skip


def _deadline() -> Iterator[Chapter]:
    radicand = dead.A**2 + (2 - dead.R) * dead.m
    context = dead.opened(
        "a collapse at the time T: R² ≤ 2 there",
        "2 -1 1 1",
        {
            "T": 0 < dead.T,
            "m": 0 < dead.m,
            "square": dead.R + 2 * dead.T * dead.A + dead.T**2 * dead.m <= 2,
        },
    )
    yield Chapter(None, (Opened(context),))
    yield Chapter(dead.context, tuple(_last(radicand)))


def _last(radicand: Term) -> Iterator[Item]:
    room = times("deadline-m", "deadline-square")
    root = sqrt(radicand)
    yield from (
        Line("scene-radicand", 0 <= radicand, proof(room, square(dead.m * dead.T + dead.A)),
             LABEL, "(iv) the radicand A² + (2-R²)L²/ρ² is not negative if there is a collapse"),
        Line("scene-deadline", dead.T <= (root - dead.A) / dead.m,
             scaled(times("goal", plus("goal", times(2, ("root", root)))), room),
             LABEL, "(iv) and it takes place at a time T ≤ (ρ²/L²)(-A + √(A²+(2-R²)L²/ρ²))"),
    )  # fmt: skip
