"""Section 4.1: speeds that fall, forcing that is only summable, and the bound with the energy.

In `plane` three balls are given by coordinates: 1 touches 0 in the direction (1, 0), 2 is at the
distance 1+d in the direction o, and v_0, v_1, v_2 are the velocities.
"""

from __future__ import annotations

from collections.abc import Iterator
from fractions import Fraction

from verify.language.argument import Chapter, Item, Line, plus, proof, times
from verify.language.terms import Claim, Term, equal
from verify.paper.letters import Letters, Refuted, refuted, subject
from verify.paper.rows import HARMLESS, OTHERWISE

NORMAL = "PROPOSS3.4CLineConveNorma"
TANGENT = "PROPOSS3.4CLineConveTangt"

run = Letters("speeds", r="r", C="-cos θ", u_0="u_{n-1}", u="u_n", u_2="u_{n+1}")
forced = Letters("forced", n="n", q="q")
energy = Letters("energy", s_0="|v₀|²", s_1="|v₁|²", s_2="|v₂|²", m="v₀·v₁")
plane = Letters("plane", r="r", d="d", tau="τ", D="(1+d')", o_x="(ω₂)₁", o_y="(ω₂)₂", a_x="(v₀)₁",
                a_y="(v₀)₂", b_x="(v₁)₁", b_y="(v₁)₂", c_x="(v₂)₁", c_y="(v₂)₂")  # fmt: skip
Pair = tuple[Term, Term]


def chapters() -> Iterator[Chapter]:
    """One context a subject."""
    recursion = run.u_2 <= (1 + run.r) / 2 * run.C * run.u - run.r * run.u_0
    signs = {"r": 0 < run.r, "r-one": run.r < 1, "angle": run.C <= 1, "before": 0 < run.u_0,
             "now": 0 < run.u, "fallen": run.u <= (1 + run.r) / 2 * run.u_0}  # fmt: skip
    yield from subject(
        run,
        "closing speeds of three collisions in a row of a nearly-linear collapse, after the first",
        "1/20 1 1 2/5 4/25",
        {**signs, "recursion": recursion},
        _speeds(),
    )
    late = {"later": 4 <= forced.n, "late": 2 <= forced.n * (1 - forced.q)}
    yield from subject(
        forced,
        "n collisions, and a factor q below 1 such that n(1-q) ≥ 2",
        "4 1/2",
        {"q": 0 < forced.q, "q-one": forced.q < 1, **late},
        _forced(),
    )
    yield from subject(
        energy,
        "three velocities; the energy is half the sum of the squares of the speeds",
        "1 1 0 -1",
        {"sum": 0 <= energy.s_0 + energy.s_1 + 2 * energy.m, "third": 0 <= energy.s_2},
        _energy(),
    )
    says = "three balls in a plane, just after a collision of 0 and 1"
    yield from subject(plane, says, STATE, givens())


def _speeds() -> Iterator[Item]:
    yield Line("speeds-fall", run.u_2 <= (1 + run.r) / 2 * run.u,
               proof("speeds-recursion", times("speeds-r", "speeds-before"),
                     times(Fraction(1, 2), plus(1, "speeds-r"), "speeds-angle", "speeds-now")),
               NORMAL,
               "u_{n+1} ≤ (1+r)/2 u_n in a nearly-linear collapse, as u_{n+1} ≤ (1+r)/2 (-cos "
               "θ)u_n - r u_{n-1}: so the normal components do fall exponentially; the proposition "
               "has the rate (1+r)/2 |cos θ̄|")  # fmt: skip
    yield Line("speeds-rate", run.u_2 <= ((1 + run.r) / 2 * run.C - run.r) * run.u,
               proof("speeds-recursion", times("speeds-r", "speeds-fallen"),
                     times(Fraction(1, 2), "speeds-r", "speeds-r-one", "speeds-before")),
               NORMAL,
               "u_{n+1} ≤ ((1+r)/2 (-cos θ) - r) u_n, as u_n ≤ u_{n-1} too: so the closing speeds "
               "fall at the printed rate as the angle converges, and even faster")  # fmt: skip


def _forced() -> Iterator[Item]:
    n, q = forced.n, forced.q
    yield from (
        Line("forcing-positive", 0 <= 2 * n**2 - (n + 1) ** 2,
             proof(times("forced-later", plus("forced-later", 6)), 7),
             NORMAL, "x_n = 1/n² satisfies x_{n+1} = x_n/2 + f_n with f_n ≥ 0 …"),
        Line("forcing-summable", n * (n + 1) <= (n + 1) ** 2, proof("forced-later", 5),
             NORMAL, "… and f_n ≤ 1/(n+1)² ≤ 1/n - 1/(n+1), which is summable; but …"),
        Line("forcing-slow",     q * (n + 1) ** 2 < n**2,
             proof(times("forced-late", plus("forced-later", 6)), "forced-q-one", 3),
             NORMAL, "… x_{n+1} > q x_n from some n on, for every q < 1"),
    )  # fmt: skip


def _energy() -> Iterator[Item]:
    n = energy
    yield Line("relative-speed", n.s_0 + n.s_1 - 2 * n.m <= 2 * (n.s_0 + n.s_1 + n.s_2),
               proof("energy-sum", times(2, "energy-third")), TANGENT,
               "|W₁|² ≤ 4E₀: with flown-1, hit and bracket-short |δ_n| ≤ 4τE₀ + (1+r)/2 (1+d)|η₂|",
    )  # fmt: skip


# --- a state in the plane -------------------------------------------------------------------------

p = plane
W_1: Pair = (p.b_x - p.a_x, p.b_y - p.a_y)
W_2: Pair = (p.c_x - p.a_x, p.c_y - p.a_y)
omega_2: Pair = (p.o_x, p.o_y)
far: Pair = ((1 + p.d) * p.o_x, (1 + p.d) * p.o_y)
met: Pair = (far[0] + p.tau * W_2[0], far[1] + p.tau * W_2[1])
flown: Pair = (1 + p.tau * W_1[0], p.tau * W_1[1])
apart: Pair = (far[0] - 1, far[1])
drift: Pair = (W_2[0] - W_1[0], W_2[1] - W_1[1])


def inner(x: Pair, z: Pair) -> Term:
    """The inner product in the plane."""
    return x[0] * z[0] + x[1] * z[1]


def givens() -> dict[str, Claim]:
    """0 and 1 recede, 0 and 2 meet after the time τ for the first time, 1 and 2 stay apart."""
    return {
        "r": 0 < p.r,
        "r-one": p.r < 1,
        "d": 0 < p.d,
        "tau": 0 < p.tau,
        "D": 0 < p.D,
        "unit": equal(inner(omega_2, omega_2), 1),
        "recede": 0 < W_1[0],
        "approach": inner(W_2, omega_2) < 0,
        "meet": equal(inner(met, met), 1),
        "impact": inner(W_2, met) < 0,
        "distance": equal(p.D**2, inner(flown, flown)),
        "outer-now": 1 < inner(apart, apart),
        "outer-later": 1 < inner(apart, apart) + 2 * p.tau * inner(apart, drift),
    }


def _change() -> Pair:
    """delta_n: what one collision changes of the tangential component of W_1."""
    hit = inner(W_2, met)
    grown = (W_1[0] + p.tau * inner(W_1, W_1)) / p.D
    cosine = inner(flown, met) / p.D
    half = (1 + p.r) / 2

    def component(i: int) -> Term:
        old = W_1[0] if i == 0 else 0 * W_1[0]
        turned = flown[i] / p.D
        return old - grown * turned + half * hit * (cosine * turned - met[i])

    return component(0), component(1)


def _bound() -> Term:
    speeds = (p.a_x, p.a_y, p.b_x, p.b_y, p.c_x, p.c_y)
    energy_0 = sum((v**2 for v in speeds[1:]), speeds[0] ** 2) / 2
    normal_2 = -inner(W_2, omega_2)
    return 2 * W_1[0] + p.tau * energy_0 + (1 + p.r) * (2 * normal_2 + p.tau * energy_0)


def _state() -> str:
    """Ball 1 flies nearly across, ball 2 comes slowly head-on; the centre of mass is at rest."""
    tau, speed, q = Fraction(1, 100), Fraction(1, 10000), Fraction(1, 100)
    cosine, sine = (1 - q**2) / (1 + q**2), 2 * q / (1 + q**2)
    grown = (1 + Fraction(1, 10**6)) / cosine
    first = ((grown * cosine - 1) / tau, grown * sine / tau)
    zero = (-(first[0] + speed) / 3, -first[1] / 3)
    velocities = (*zero, zero[0] + first[0], zero[1] + first[1], zero[0] + speed, zero[1])
    numbers = (Fraction(1, 20), speed * tau, tau, grown, Fraction(-1), Fraction(0), *velocities)
    return " ".join(map(str, numbers))


STATE = _state()


def misprints() -> Iterator[Refuted]:
    """What is false here, each with a point at which it is."""
    yield from (
        refuted(forced, "forced-exponential", forced.n**2 <= forced.q * (forced.n + 1) ** 2,
                "4 1/2", label=NORMAL,
                says="matrices with a norm below 1 and forcing terms that are summable give "
                     "exponential convergence; here x_{n+1} = x_n/2 + f_n with x_n = 1/n², q = "
                     "1/2, n = 4; the normal components fall at the printed rate all the same",
                severity=OTHERWISE, corrected_by="speeds-rate"),
        refuted(plane, "change-bound", inner(_change(), _change()) <= _bound() ** 2, STATE,
                label=TANGENT,
                says="|δ_n| ≤ 2|η_{1,n}| + τ_n E₀ + (1+r)(2|η_{2,n}| + τ_n E₀), squared, with the "
                     "energy E₀ for |W|²: |W|² can be 4E₀, and is 3E₀ here", severity=HARMLESS,
                corrected_by="relative-speed"),
    )  # fmt: skip
