"""The paper read a second time: the constants of Section 4.1 and the conditions of the recursion.

`Constants` holds them as the paper prints them. `hypothesis` lists what is assumed at collision n:
the conditions Cnd1 to Cnd10 that speak of the states n and n+1 (Cnd6 and Cnd7 without the norms at
n = 0, Cnd8 at its limit for large n).
"""
# ruff: noqa: N802 - the paper's letters

from __future__ import annotations

from dataclasses import dataclass
from functools import cached_property

from flint import fmpq

from .second_reading import Number, Place, along, dot, root, size

Triple = tuple[Number, str, Number]
HALF = fmpq(1, 2)


def least(*entries: Number) -> Number:
    """Return the smallest; a tie or an overlap of balls is an error."""
    best = entries[0]
    for entry in entries[1:]:
        if entry < best:
            best = entry
        elif not best <= entry:
            raise ValueError("the balls do not decide which entry is least")
    return best


@dataclass(frozen=True)
class Constants:
    """From r, c = -cos(theta_0), delta_theta and V_0."""

    r: Number
    c: Number
    delta_theta: Number
    V_0: Number

    @cached_property
    def alpha(self) -> Number:
        return (1 + self.r) / 2 * self.c

    @cached_property
    def phi(self) -> Number:
        """The fixed point phi^-_{1,alpha_0}, the smaller one."""
        return (self.alpha - root(self.alpha**2 - 4 * self.r)) / 2

    @cached_property
    def delta_1(self) -> Number:
        return self.alpha / 2 - self.phi

    @cached_property
    def delta_2(self) -> Number:
        return HALF * (self.alpha - self.phi)

    @cached_property
    def delta_3(self) -> Number:
        return HALF * (1 - (self.alpha - self.phi))

    @cached_property
    def C_eta(self) -> Number:
        return 1 - self.delta_3

    @cached_property
    def h_4(self) -> Number:
        return HALF * (1 - self.r / (self.alpha - self.phi) ** 2)

    @cached_property
    def delta_4(self) -> Number:
        """Solve r / (alpha - phi - delta_4)^2 = 1 - h_4."""
        return self.alpha - self.phi - root(self.r / (1 - self.h_4))

    @cached_property
    def h_5(self) -> Number:
        return HALF * (1 - self.phi / (self.alpha - self.phi) ** 2)

    @cached_property
    def delta_5(self) -> Number:
        """Solve phi / (alpha - phi - delta_5)^2 = 1 - h_5."""
        return self.alpha - self.phi - root(self.phi / (1 - self.h_5))

    @cached_property
    def V_1(self) -> Number:
        return self.V_0 * (1 - self.h_5 / 2) / (1 - self.h_5)

    @cached_property
    def speed(self) -> Number:
        """V_1^{1/2}."""
        return root(self.V_1)

    @cached_property
    def delta_x(self) -> Number:
        return least(self.delta_1, self.delta_2, self.delta_3, self.delta_4, self.delta_5)

    @cached_property
    def x_0(self) -> Number:
        return least(
            (1 - self.h_4) * self.delta_x, self.V_0 / self.V_1 * self.delta_2**2 * self.h_5 / 12
        )

    @cached_property
    def Delta_theta(self) -> Number:
        return least(self.c / 2, self.h_4 / 8 * self.delta_x, self.delta_theta)

    @cached_property
    def eta_bar(self) -> Number:
        V_0, V_1, w, a, h = self.V_0, self.V_1, self.speed, self.alpha, self.h_4
        listed = fmpq(2, 15) / a + h * self.delta_2 / 6 + h / (12 * a) + h / 24
        return least(
            fmpq(1),
            (root(fmpq(2)) - 1) / 16 * V_0 / w,
            V_0 / (33 * w) * self.Delta_theta,
            (1 - self.C_eta) * (V_1 - V_0) / (12 * (w + 2)),
            V_0 / w * listed * self.delta_x,
        )

    @cached_property
    def zeta_bar(self) -> Number:
        V_0, V_1 = self.V_0, self.V_1
        return least(
            2 * (root(fmpq(2)) - 1),
            V_0 * self.h_5 / (3 * V_1 * (self.alpha + 8 * V_1 / V_0)) * self.delta_2**2,
            (1 + 4 * self.delta_2 + V_0 / V_1) * self.h_4 * self.delta_x / 16,
        )

    def d_bar(self, eta: Number) -> Number:
        h, x, y = self.h_4, self.delta_x, self.delta_2
        return least(
            (root(fmpq(2)) - 1) / 4,
            self.Delta_theta / 3,
            (1 + y * h) * x / 5,
            (1 + 2 * y) * h * x / 4,
            self.zeta_bar / (2 * self.V_1) * eta**2,
        )


def hypothesis(q: Place) -> dict[str, list[Triple]]:
    """What the recursion assumes of collision n, by its label's name; CndT at its closest time."""
    K, n = q.K, q.n
    apart = along([(1 + n.d) * x for x in n.omega_c], -1, n.omega_s)
    drift = along(n.W_c, -1, n.W_s)
    return {
        "the state": [(fmpq(0), "<", n.d), (fmpq(0), "<", n.eta_s)],
        "Cnd1": [(n.eta_c, "<", fmpq(0))],
        "Cnd2": [(size(n.eta_c), "<=", K.eta_bar)],
        "Cnd3": [(n.zeta, "<", fmpq(1))],
        "Cnd4": [(n.zeta, "<=", K.zeta_bar)],
        "CndT": [(fmpq(1), "<", _closest(apart, drift, n.tau))],
        "Cnd5": [(K.V_0, "<=", w) for w in (n.Ws2, n.Wc2)]
        + [(w, "<=", K.V_1) for w in (n.Ws2, n.Wc2)],
        "Cnd6 and Cnd7": [(w, "<=", norms(K, K.eta_bar + n.eta_c)) for w in (n.Ws2, n.Wc2)],
        "Cnd8": [(size(q.m.neg_cos - K.c), "<=", turns(K, K.eta_bar))],
        "Cnd9": [(size(q.X - K.phi), "<=", K.delta_x)],
        "Cnd10": [(size(q.rho - (K.alpha - K.phi)), "<=", K.delta_x)],
    }


def norms(K: Constants, spent: Number) -> Number:
    """Return the right sides of Cnd6 and Cnd7 plus the largest norm at n = 0.

    The sum of C_eta^k for k < n, times -eta_{c,0}, is at most (eta_bar - (-eta_{c,n}))/(1 - C_eta),
    by Cnd2.
    """
    return K.V_1 - (K.V_1 - K.V_0) / 3 + 4 * (K.speed + 2) / (1 - K.C_eta) * spent


def turns(K: Constants, eta: Number) -> Number:
    """Return the right side of Cnd8 for large n: the sum is then C_eta / (1 - C_eta)."""
    sums = 11 + (3 + 11 * K.C_eta) / (1 - K.C_eta)
    return K.Delta_theta / 3 + sums * K.speed / K.V_0 * eta


def _closest(apart: list[Number], drift: list[Number], end: Number) -> Number:
    """Return the least of |apart + t drift|^2 for 0 <= t <= end."""
    t = -dot(apart, drift) / dot(drift, drift) if dot(drift, drift) > 0 else fmpq(0)
    times = [fmpq(0), end] + ([t] if 0 < t < end else [])
    return least(*(dot(v, v) for v in (along(apart, s, drift) for s in times)))
