"""The paper read a second time, from its text alone: the collision and the laws of Section 4.1.

Nothing here is shared with the transcription under test. A state is two unit vectors, two
velocities and a gap, all vectors of any dimension; a collision is done on positions and
velocities in the frame where particle 0 starts at rest. Numbers are exact rationals; the root of a
number that is no square is a ball of some 270 digits.

Every `Reading` holds one displayed chain of relations as the paper prints it, the reader's own view
of it (`right`, `slip` or `wrong`) and, if it is not right, the chain that should be there. The
estimates of the proof are in `second_estimates`.
"""
# ruff: noqa: N802 - the paper's letters

from __future__ import annotations

from collections.abc import Callable, Sequence
from dataclasses import dataclass
from functools import cached_property
from typing import Any

from flint import arb, ctx, fmpq

Number = Any  # an fmpq, or an arb where a root is not rational
Vector = list[Number]
DIGITS = 270


def root(x: Number) -> Number:
    """Return the square root: a rational if it is one, else a ball of `DIGITS` digits."""
    ctx.dps = DIGITS
    if isinstance(x, fmpq):
        p, q = x.p.sqrtrem(), x.q.sqrtrem()
        return fmpq(p[0], q[0]) if p[1] == 0 and q[1] == 0 else arb(x).sqrt()
    return x.sqrt()


def size(x: Number) -> Number:
    """Return the absolute value."""
    return abs(x) if isinstance(x, arb) else max(x, -x)


def dot(a: Vector, b: Vector) -> Number:
    return sum((x * y for x, y in zip(a, b, strict=True)), fmpq(0))


def along(a: Vector, t: Number, b: Vector) -> Vector:
    """Return a + t b."""
    return [x + t * y for x, y in zip(a, b, strict=True)]


def length(a: Vector) -> Number:
    return root(dot(a, a))


@dataclass(frozen=True)
class State:
    """Just after a collision: `s` touches particle 0 and looks on, `c` is at 1 + d and comes."""

    omega_s: Vector
    W_s: Vector
    d: Number
    omega_c: Vector
    W_c: Vector

    @cached_property
    def eta_s(self) -> Number:
        return dot(self.W_s, self.omega_s)

    @cached_property
    def eta_c(self) -> Number:
        return dot(self.W_c, self.omega_c)

    @cached_property
    def Ws2(self) -> Number:
        return dot(self.W_s, self.W_s)

    @cached_property
    def Wc2(self) -> Number:
        return dot(self.W_c, self.W_c)

    @cached_property
    def neg_cos(self) -> Number:
        return -dot(self.omega_s, self.omega_c)

    @cached_property
    def tau(self) -> Number:
        """The first time at which |(1+d) omega_c + t W_c| = 1 (EQUATSS2.2CondiColliFutur)."""
        far = along([fmpq(0)] * len(self.W_c), 1 + self.d, self.omega_c)
        a, b, c = self.Wc2, dot(far, self.W_c), dot(far, far) - 1
        return (-b - root(b * b - a * c)) / a

    @cached_property
    def zeta(self) -> Number:
        """EQUATSS2.2DefinParZK_zeta."""
        return self.d * (2 + self.d) * self.Wc2 / ((1 + self.d) ** 2 * self.eta_c**2)

    @cached_property
    def still(self) -> Number:
        """The square root of 1 - zeta."""
        return root(1 - self.zeta)


def collide(state: State, r: Number) -> State:
    """Fly until `c` touches 0 (EQUATSS2.1_Loi_de_Newton_), then EQUATSS2.1VitesPost-Colli."""
    still = [fmpq(0)] * len(state.W_c)
    t = state.tau
    x_0 = still
    x_1 = along(state.omega_s, t, state.W_s)
    x_2 = along(along(still, 1 + state.d, state.omega_c), t, state.W_c)
    v_0, v_1, v_2 = still, state.W_s, state.W_c
    omega = along(x_0, -1, x_2)  # of length 1: they touch
    pulse = (1 + r) / 2 * dot(along(v_0, -1, v_2), omega)
    v_0, v_2 = along(v_0, -pulse, omega), along(v_2, pulse, omega)
    apart = along(x_1, -1, x_0)
    far = length(apart)
    return State(
        omega_s=along(x_2, -1, x_0),
        W_s=along(v_2, -1, v_0),
        d=far - 1,
        omega_c=[x / far for x in apart],
        W_c=along(v_1, -1, v_0),
    )


@dataclass(frozen=True)
class Place:
    """Where a line of the paper is read: three states in a row, and the theorem's constants."""

    r: Number
    n: State
    K: Any = None

    @cached_property
    def m(self) -> State:
        """The state n+1."""
        return collide(self.n, self.r)

    @cached_property
    def k(self) -> State:
        """The state n+2."""
        return collide(self.m, self.r)

    @cached_property
    def hit(self) -> Number:
        """W_{c,n} . omega_{s,n+1}."""
        return dot(self.n.W_c, self.m.omega_s)

    @cached_property
    def X(self) -> Number:
        """eta_{s,n} / (-eta_{c,n})."""
        return self.n.eta_s / -self.n.eta_c

    @cached_property
    def rho(self) -> Number:
        """eta_{c,n+1} / eta_{c,n}."""
        return self.m.eta_c / self.n.eta_c


Chain = tuple[Any, ...]  # value, relation, value, relation, …, value


@dataclass(frozen=True)
class Reading:
    """One chain of the paper: what is printed, what the reader makes of it, what is right."""

    name: str
    label: str
    chain: Callable[[Place], Chain]
    view: str
    why: str
    instead: Callable[[Place], Chain] | None

    def parts(self, place: Place) -> list[tuple[Number, str, Number]]:
        return links(self.chain(place))


def links(chain: Chain) -> list[tuple[Number, str, Number]]:
    """Cut a <= b <= c into (a, <=, b) and (b, <=, c)."""
    return [(chain[i], chain[i + 1], chain[i + 2]) for i in range(0, len(chain) - 2, 2)]


def holds(a: Number, relation: str, b: Number) -> bool | None:
    """Decide one link; None if the balls cannot. Balls are equal if they meet and are thin."""
    if not isinstance(a, arb) and not isinstance(b, arb):
        a, b = fmpq(a), fmpq(b)
        return {"=": a == b, "<": a < b, "<=": a <= b}[relation]
    gap = arb(b) - arb(a)
    if relation == "=":
        return False if not gap.contains(0) else (True if gap.rad() < arb(10) ** -200 else None)
    if gap > 0:
        return True
    return False if gap < 0 else None


READINGS: dict[str, Reading] = {}


def reading(
    name: str,
    label: str,
    view: str = "right",
    why: str = "",
    instead: Callable[[Place], Chain] | None = None,
) -> Callable[[Callable[[Place], Chain]], Callable[[Place], Chain]]:
    """Enter a chain under a name that nothing else has."""

    def enter(chain: Callable[[Place], Chain]) -> Callable[[Place], Chain]:
        assert name not in READINGS
        READINGS[name] = Reading(name, label, chain, view, why, instead)
        return chain

    return enter


def same(a: Sequence[Number], b: Sequence[Number]) -> Chain:
    """Two vectors are equal: the square of their distance is 0."""
    gap = along(list(a), -1, list(b))
    return dot(gap, gap), "=", fmpq(0)


# The laws (EQUATSS4.1SysteDynamColSp to EQUATSS4.1EvoluCosinAngle).


@reading("law of W_c", "EQUATSS4.1SysteDynamColSp")
def _(q: Place) -> Chain:
    return same(q.m.W_c, along(q.n.W_s, -(1 + q.r) / 2 * q.hit, q.m.omega_s))


@reading("law of W_s", "EQUATSS4.1SysteDynamColSp")
def _(q: Place) -> Chain:
    return same(q.m.W_s, along(q.n.W_c, -(1 + q.r) * q.hit, q.m.omega_s))


@reading("law of omega_c", "EQUATSS4.1SysteDynamColSp")
def _(q: Place) -> Chain:
    flown = along(q.n.omega_s, q.n.tau, q.n.W_s)
    return same(q.m.omega_c, [x / (1 + q.m.d) for x in flown])


@reading("law of omega_s", "EQUATSS4.1SysteDynamColSp")
def _(q: Place) -> Chain:
    far = [(1 + q.n.d) * x for x in q.n.omega_c]
    return same(q.m.omega_s, along(far, q.n.tau, q.n.W_c))


@reading("law of d", "EQUATSS4.1SysteDynamColSp")
def _(q: Place) -> Chain:
    t = q.n.tau
    return q.m.d, "=", root(1 + 2 * q.n.eta_s * t + q.n.Ws2 * t * t) - 1


@reading("time of the next collision", "EQUATSS2.2TempsColliTauV3")
def _(q: Place) -> Chain:
    return q.n.tau, "=", (1 + q.n.d) / q.n.Wc2 * -q.n.eta_c * (1 - q.n.still)


@reading("law of zeta", "EQUATSS2.2DefinParZK_zeta")
def _(q: Place) -> Chain:
    d = q.m.d
    return q.m.zeta, "=", d * (2 + d) / (1 + d) ** 2 * q.m.Wc2 / q.m.eta_c**2


@reading("law of eta_c", "EQUATSS4.1EvoluCompoNormC")
def _(q: Place) -> Chain:
    share = (1 + q.r) / 2 * (1 + q.n.d) * q.n.still * q.m.neg_cos * -q.n.eta_c
    far = 1 + q.m.d
    return q.m.eta_c, "=", q.n.eta_s / far - share + q.n.tau * q.n.Ws2 / far


@reading("law of eta_s", "EQUATSS4.1EvoluCompoNormC")
def _(q: Place) -> Chain:
    return q.m.eta_s, "=", q.r * (1 + q.n.d) * q.n.still * -q.n.eta_c


def _norm_law(q: Place, share: int) -> Chain:
    side = dot(q.n.W_s, q.m.omega_s)
    fallen = (1 + q.r) * q.hit * side
    return q.m.Wc2, "=", q.n.Ws2 - fallen + (1 + q.r) ** 2 / fmpq(share) * q.hit**2


@reading(
    "law of |W_c|^2",
    "EQUATSS4.1EvoluNormeVitRl",
    view="wrong",
    why="the last term is the square of (1+r)/2: divided by 4",
    instead=lambda q: _norm_law(q, 4),
)
def _(q: Place) -> Chain:
    return _norm_law(q, 2)


@reading("law of |W_s|^2", "EQUATSS4.1EvoluNormeVitRl")
def _(q: Place) -> Chain:
    return q.m.Ws2, "=", q.n.Wc2 + (q.r**2 - 1) * q.hit**2


@reading("law of -cos theta", "EQUATSS4.1EvoluCosinAngle")
def _(q: Place) -> Chain:
    n, t, far = q.n, q.n.tau, 1 + q.m.d
    first = (1 + n.d) / far * n.neg_cos - t / far * dot(n.omega_s, n.W_c)
    last = (1 + n.d) / far * t * dot(n.omega_c, n.W_s) + t * t / far * dot(n.W_s, n.W_c)
    return q.m.neg_cos, "=", first - last


@reading("normal velocity at the touch", "before the norms' estimate")
def _(q: Place) -> Chain:
    direct = (1 + q.n.d) * q.n.eta_c + q.n.tau * q.n.Wc2
    return q.hit, "=", direct, "=", -(1 + q.n.d) * q.n.still * -q.n.eta_c
