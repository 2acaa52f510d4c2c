"""What becomes of one collision as -eta_c goes to 0: a map of (φ1, φ2) that depends on r and C."""

from __future__ import annotations

from collections.abc import Callable
from fractions import Fraction

from verify.spheres.flow.law import Number
from verify.spheres.map.planes import Phi


def has_limit(plane: Phi) -> bool:
    """Whether one map is the limit at every collision: the tangential speeds are the same."""
    u_c, u_s = plane.tangential
    return u_c**2 == u_s**2


def limit_map(
    plane: Phi,
    phi_1: Number,
    phi_2: Number,
    number: Callable[[Fraction], Number],
    root: Callable[[Number], Number],
) -> tuple[Number, Number]:
    """The ratios after the next collision, by the law without its terms that have η or d."""
    r, C, A = number(plane.r), number(plane.neg_cos), number(plane.tangential[0] ** 2)
    s = root(1 - 2 * A * phi_2)
    T = 2 * phi_2 / (1 + s)
    ratio = (1 + r) / 2 * s * C - phi_1 - A * T
    return r * s / ratio, (phi_1 * T + A * T * T / 2) / (ratio * ratio)
