"""The rows of the printed set that hold for some parameters and not for others, and where.

For V_0 between 1/16 and 10^6 the third entry of eta_bar is always the least (outside these bounds
it may be 1, or the fourth), and |Delta_theta| is the smaller one of h_4 delta_x/8 and delta_theta.
So the drift of the angle is |Delta_theta| times 28/(33 (1 - phi_plus)), but for d_bar, which is
tiny; and d_n/delta_2 is |Delta_theta| times 2/(11 phi_plus). What is left are thresholds of
phi_plus alone.

A row `0 <= max(a, b)` is the sentence "0 <= a or 0 <= b".
"""

from __future__ import annotations

from collections.abc import Iterator
from fractions import Fraction

from verify.language.argument import (
    ByEntry,
    ByLeast,
    Line,
    Reason,
    ToBeFound,
    plus,
    proof,
    row_of,
    scaled,
    times,
)
from verify.language.record import Record
from verify.language.statement import PROVED, REFUTED, Given, Statement
from verify.language.terms import Claim, maximum, minimum
from verify.paper.everywhere import chart
from verify.paper.everywhere.chart import p, u
from verify.paper.initial_data import ETA, X_0, C_eta, ConstantSet, delta_2, h_4
from verify.paper.parameters import PRINTED, THEOREM, V_0, delta_theta
from verify.paper.theorem1 import theorem

LEAST_V_0, GREATEST_V_0 = Fraction(1, 16), Fraction(10**6)
k = ConstantSet(PRINTED)
angle = k.Delta_theta

#: The second entry of |Delta_theta|, and what |Delta_theta| is.
SHARE = h_4 * k.delta_x / 8
LEAST = minimum(SHARE, delta_theta)
THIRD = V_0 / (33 * k.speed) * k.Delta_theta
SHARE_MOST = Fraction(1, 64)


def of(name: str) -> str:
    """The full name of a fact about a constant of the set."""
    return f"{PRINTED}.{name}"


V_0s, ANGLE, ONE = chart.hypothesis("V_0-positive"), of("Delta_theta-positive"), "p-below-one"
ROOT = "V_1-root"
#: V_1 times 3+u, in the chart.
SPEED = times("v-positive", "v-positive", plus(3, "u-positive"))


def speeds() -> Iterator[Line]:
    """What the bounds on V_0 say about the root of V_1."""
    top = 1000
    yield from (
        Line("V_0-below-V_1", 0 < k.V_1 - V_0, ToBeFound()),
        Line("speed-least",   Fraction(1, 4) <= k.speed,
            scaled(times("goal", plus(ROOT, Fraction(1, 4))), "V_0-below-V_1", "V_0-least")),
        Line("V_0-speed",     V_0 <= top * k.speed,
            scaled(times("goal", plus(times(top, ROOT), V_0s)), times(V_0s, "V_0-greatest"),
            times(top**2, "V_0-below-V_1"))),
    )  # fmt: skip


def least() -> Iterator[Line]:
    """The least entries of the minima for |Delta_theta| and eta_bar."""
    branches = (proof("least-1", "share-half"), proof("least-1"), proof("least-2"))
    yield from (
        Line("share-positive",    0 < SHARE, ToBeFound()),
        Line("share-half",        SHARE <= k.bounds()["Delta_theta"][0], ToBeFound()),
        Line("share-small",       SHARE <= SHARE_MOST, ToBeFound(),
            X_0, "h₄δ_x/8 ≤ 1/64, so that δ_θ matters only below 1/64"),
        Line("least-1",           LEAST <= SHARE, ByEntry()),
        Line("least-2",           LEAST <= delta_theta, ByEntry()),
        Line("Delta_theta.least", LEAST <= angle, ByLeast(branches, angle.name),
            X_0, "|Δθ| is the smaller one of h₄δ_x/8 and δ_θ"),
        Line("angle-small", angle <= SHARE_MOST, proof(of("Delta_theta-entry-2"), "share-small")),
    )  # fmt: skip
    yield from _third()


def _third() -> Iterator[Line]:
    entries = k.bounds()["eta_bar"]
    rest = 33 - 1000 * SHARE_MOST
    reasons: dict[int, Reason] = {
        1: proof(times(ANGLE, "V_0-speed"), times(ROOT, plus(times(1000, "angle-small"), rest))),
        2: ToBeFound(),
        4: proof(times(3, ROOT, "room"), times(96, V_0s, ANGLE, "speed-least")),
        5: ToBeFound(),
    }
    yield from _room()
    for number, reason in reasons.items():
        yield Line(f"third-{number}", THIRD <= entries[number - 1], reason)
    branches = tuple(proof(*([] if n == 3 else [f"third-{n}"])) for n in range(1, 6))
    yield Line("eta_bar.least", THIRD <= k.eta_bar, ByLeast(branches, k.eta_bar.name),
        ETA, "entry 3 of the minimum for η̄ is the least")  # fmt: skip


def _room() -> Iterator[Line]:
    """Near u = 1 both |Delta_theta| and V_1 - V_0 tend to 0, as delta_5 is at most p (1-u)."""
    u_plus, u_left = plus(1, "u-positive"), "u-below-one"
    up = times("u-positive", "p-positive")
    yield from (
        Line("root-5-least",  u * p <= chart.root_5,
            scaled(times(u_plus, plus("root-5", up), "goal"),
            times(up, "p-positive", u_left, plus(2, "u-positive")), using="m.chart h_5.chart")),
        Line("delta_x-small", k.delta_x <= p * (1 - u),
            proof(of("delta_x-entry-5"), "root-5-least", using="delta_5.chart")),
        Line("angle-chart",   angle <= (1 - u * p) * p * (1 - u) / 16,
            proof(of("Delta_theta-entry-2"),
            times(Fraction(1, 16), plus(u_left, times("u-positive", ONE)), "delta_x-small"),
            using="h_4.chart")),
        Line("room-left",     0 < 11 * (1 - p) - 9 * (1 + u) * (1 - u * p) * p, ToBeFound()),
        Line("room",          36 * V_0 * angle <= 11 * (1 - C_eta) * (k.V_1 - V_0),
            proof(times(72, SPEED, u_plus, "angle-chart"),
            times(chart.HALF, SPEED, u_left, "room-left"),
            using="C_eta.chart V_0.chart V_1.chart")),
    )  # fmt: skip


NAME = f"{THEOREM} as printed, where it depends"
TITLE = (
    "Where the printed rows hold that hold for some parameters only, for 1/16 <= V_0 <= 10^6 and "
    "all other parameters that satisfy the stability condition"
)

#: Where the drift is |Delta_theta|, were it not for d_bar.
DRIFT_ENDS = Fraction(5, 33)
#: Where d_n/delta_2 is h_4 delta_x/2.
SLOPE_STARTS = Fraction(1, 22)
#: How far from a threshold nothing is said.
STRIP = Fraction(1, 100000)
#: What d_bar adds to 28 |Delta_theta|, at most, in units of |Delta_theta|.
TINY = 33 * STRIP

drift, d_later = k.drift, k.d_later / delta_2
FINAL_MOST = Fraction(1, 37)


class Strip(Record):
    """A row that is proved, or refuted, for phi_plus from ``low`` to ``high``; ``by`` says so."""

    row: str
    verdict: str
    low: Fraction
    high: Fraction
    by: str


#: What is certified at V_0 = 1 and delta_theta = 1/10; phi_plus is less than 1/2.
STRIPS = (
    Strip("angle-absorbed", PROVED, Fraction(0), DRIFT_ENDS - STRIP, "angle-absorbed.holds"),
    Strip("angle-absorbed", REFUTED, DRIFT_ENDS, chart.HALF, "angle-absorbed.fails"),
    Strip("x-term-1-d", REFUTED, Fraction(0), SLOPE_STARTS, "x-term-1-d.fails"),
    Strip("x-term-1-d", PROVED, SLOPE_STARTS, chart.HALF, "x-term-1-d.holds"),
    Strip("y-term-3", PROVED, Fraction(0), DRIFT_ENDS - STRIP, "y-term-3.holds"),
    Strip("y-term-3", REFUTED, DRIFT_ENDS, chart.HALF, "y-term-3.fails"),
    Strip("final-angle", PROVED, Fraction(0), chart.HALF, "final-angle.wide"),
)


def statement() -> Statement:
    """The statement: two more givens about V_0, and rows that name thresholds."""
    own = chart.context(k)
    more = (Given("V_0-least", LEAST_V_0 <= V_0), Given("V_0-greatest", V_0 <= GREATEST_V_0))
    context = own._replace(givens=(*own.givens, *more), says=f"{own.says}, and 1/16 ≤ V₀ ≤ 10⁶")
    rows = tuple(row_of(line, PRINTED, chart.CONTEXT) for line in lines() if line.says)
    return Statement(NAME, TITLE, {}, (), (context,), rows, ())


def lines() -> Iterator[Line]:
    """From the givens about V_0 to the thresholds."""
    yield from (
        *speeds(),
        *least(),
    )  # fmt: skip
    yield from _drift()
    yield from _angle_rows()
    yield from _final_rows()
    yield from _slope_rows()


def label(name: str) -> str:
    """The label of a printed row."""
    rows = theorem().parts[PRINTED].obligations
    return next(row.label for row in rows if row.name == of(name))


#: The denominator of the drift, in the chart.
SCALE = times(chart.HALF, ONE, V_0s)
DECAY = "C_eta.chart"


def _tiny() -> Reason:
    """d_bar is at most zeta_bar eta_bar^2/(2 V_1), and eta_bar is at most its third entry."""
    V_1s, zeta, third = "V_1-sign", of("zeta_bar-positive"), of("eta_bar-entry-3")
    root, square = Fraction(1, 32), 2 * 33**2 * STRIP
    room = plus(
        times(zeta, "angle-small"),
        times(SHARE_MOST, of("zeta_bar-entry-1")),
        times(root, "rest-small"),
        square - root * Fraction(21, 50),
    )
    return scaled(
        times(2 * 33**2, V_1s, V_1s, "goal"),
        times(33**2, V_1s, of("d_bar-entry-2")),
        times(zeta, third, plus(times(V_0s, ANGLE), times(33, ROOT, of("eta_bar-positive")))),
        times(ANGLE, square, "V_0-below-V_1", plus(V_1s, V_0s)),
        times(ANGLE, V_0s, V_0s, room),
        using=of("d_slope"),
    )


def _drift() -> Iterator[Line]:
    d_bar = of("d_bar-positive")
    small = plus("d_bar-tiny", times("p-positive", d_bar))
    yield from (
        Line("d_bar-tiny",  k.d_bar <= STRIP * angle, _tiny()),
        Line("drift.above", 28 * angle < 33 * (1 - p) * drift,
            proof(times(Fraction(33, 2), d_bar, V_0s, ONE, ONE), times(14, ONE, "eta_bar.least"),
            using=DECAY), label("angle-absorbed"),
            "the drift of the angle is more than 28/(33(1-φ⁺)) |Δθ|"),
        Line("drift.below", 33 * (1 - p) * drift <= (28 + TINY) * angle,
            proof(times(14, ONE, of("eta_bar-entry-3")), times(Fraction(33, 2), ONE, V_0s, small),
            using=DECAY), label("angle-absorbed"),
            "the drift of the angle is at most (28 + 33/100000)/(33(1-φ⁺)) |Δθ|"),
    )  # fmt: skip


def _either(name: str, claim: Claim, reason: Reason, says: str) -> Iterator[Line]:
    """One of the two entries of the maximum on the right is positive, or >= 0."""
    for number, entry in enumerate(claim.rhs.children, 1):
        yield Line(f"{name}.{number}", entry <= claim.rhs, ByEntry(side="rhs"))
    yield Line(name, claim, reason, label(name.partition(".")[0]), says)


def _angle_rows() -> Iterator[Line]:
    """`angle-absorbed` and `y-term-3`: (1-phi_plus) and |Delta_theta| are the weights."""
    below, above = DRIFT_ENDS - STRIP, DRIFT_ENDS
    cases = {
        "angle-absorbed.holds": (0 <= maximum(p - below, angle - drift), "drift.below", None),
        "angle-absorbed.fails": (0 < maximum(above - p, drift - angle), "drift.above", None),
        "y-term-3.holds": (
            0 <= maximum(p - below, SHARE - drift),
            "drift.below",
            of("Delta_theta-entry-2"),
        ),
        "y-term-3.fails": (
            0 < maximum(above - p, drift - LEAST),
            "drift.above",
            "Delta_theta.least",
        ),
    }
    says = {
        "angle-absorbed.holds": "it holds where φ⁺ < 5/33 - 1/100000",
        "angle-absorbed.fails": "it fails where φ⁺ ≥ 5/33",
        "y-term-3.holds": "it holds where φ⁺ < 5/33 - 1/100000",
        "y-term-3.fails": "it fails where φ⁺ ≥ 5/33 and h₄δ_x/8 ≤ δ_θ",
    }
    for name, (claim, fact, more) in cases.items():
        sides = [times(33, ANGLE, SCALE, f"{name}.1"), times(33, ONE, f"{name}.2"), fact]
        sides += [] if more is None else [times(33, ONE, SCALE, more)]
        goal = times(SCALE, plus(times(33, ONE), times(33, ANGLE)), "goal")
        yield from _either(name, claim, scaled(goal, *sides, using=DECAY), says[name])


def _final_rows() -> Iterator[Line]:
    """`final-angle`: the weights are 1 and (1-phi_plus)."""
    most, bound = (28 + TINY) * angle, 33 * (1 - p) * delta_theta
    cases = {
        "final-angle.holds": (
            0 <= maximum(most - bound, delta_theta - drift),
            "drift.below",
            "it holds where (28 + 33/100000) |Δθ| < 33(1-φ⁺) δ_θ",
        ),
        "final-angle.fails": (
            0 < maximum(bound - 28 * angle, drift - delta_theta),
            "drift.above",
            "it fails where 28 |Δθ| ≥ 33(1-φ⁺) δ_θ: for δ_θ ≤ h₄δ_x/8 that is φ⁺ ≥ 5/33",
        ),
    }
    for name, (claim, fact, says) in cases.items():
        goal = times(SCALE, plus(times(33, ONE), 1), "goal")
        sides = (times(SCALE, f"{name}.1"), times(33, ONE, f"{name}.2"), fact)
        yield from _either(name, claim, scaled(goal, *sides, using=DECAY), says)
    room = Fraction(33, 2) * FINAL_MOST - (28 + TINY) * SHARE_MOST
    left = plus(times(28 + TINY, "angle-small"), times(33 * FINAL_MOST, "p-below-half"), room)
    yield Line("final-angle.wide", drift <= FINAL_MOST,
        scaled(times(33, ONE, "goal"), "drift.below", times(SCALE, left), using=DECAY), THEOREM,
        "the drift of the angle is at most 1/37, so that it holds where δ_θ ≥ 1/37")  # fmt: skip


def _slope_rows() -> Iterator[Line]:
    """`x-term-1-d`: 22 phi_plus d_n/delta_2 is 4 |Delta_theta|."""
    name, scale, using = "x-term-1-d", times(chart.HALF, "p-positive", V_0s), "delta_2.chart"
    ratio = 1 / SLOPE_STARTS * p * d_later
    yield from (
        Line(f"{name}.above", 4 * angle <= 22 * p * d_later,
            proof(times(2, "p-positive", "eta_bar.least"), using=using)),
        Line(f"{name}.below", 22 * p * d_later <= 4 * angle,
            proof(times(2, "p-positive", of("eta_bar-entry-3")), using=using)),
        Line(f"{name}.fails", 4 * LEAST <= ratio,
            proof(f"{name}.above", times(4, scale, "Delta_theta.least"), using=using), label(name),
            "where h₄δ_x/8 ≤ δ_θ its left side is at least 1/(22 φ⁺) times the right one: there "
            "it fails where φ⁺ < 1/22"),
        Line(f"{name}.holds", ratio <= 4 * SHARE,
            proof(f"{name}.below", times(4, scale, of("Delta_theta-entry-2")), using=using),
            label(name),
            "its left side is at most 1/(22 φ⁺) times the right one: it holds where φ⁺ ≥ 1/22"),
    )  # fmt: skip
