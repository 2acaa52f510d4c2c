"""Random states for the second reading: rational to the last digit, or allowed by the recursion."""

from __future__ import annotations

import random
from math import isqrt
from types import SimpleNamespace

from flint import arb, fmpq

from .second_constants import Constants, norms
from .second_reading import Number, Place, State, Vector, along, dot


def share(rng: random.Random) -> fmpq:
    """A number in (0, 1), often close to an end."""
    tiny = fmpq(1, 10**9)
    return rng.choice([tiny, 1 - tiny, fmpq(rng.randint(1, 999), 1000)])


def units(rng: random.Random, dimension: int) -> tuple[Vector, Vector]:
    """Two rational unit vectors with a small angle, by stereographic projection."""
    t = [fmpq(rng.randint(-7, 7), rng.randint(1, 7)) for _ in range(dimension - 1)]
    turned = [x + fmpq(rng.randint(-9, 9), 40) for x in t]
    return _unit(t), _unit(turned)


def _unit(t: Vector) -> Vector:
    square = dot(t, t)
    return [*((2 * x) / (1 + square) for x in t), (1 - square) / (1 + square)]


def exact_place(rng: random.Random, dimension: int) -> Place:
    """A state whose collision time, zeta's root and next gap are rational; rational constants.

    Directions before and after the flight, both gaps and the time are drawn; they give the
    velocities. The constants are any numbers with the relations by which they are defined.
    """
    while True:
        (old_c, new_s), (old_s, new_c) = units(rng, dimension), units(rng, dimension)
        d, e, tau = (fmpq(rng.randint(1, 9), rng.randint(1, 40)) for _ in range(3))
        W_c = [(z - (1 + d) * x) / tau for x, z in zip(old_c, new_s, strict=True)]
        W_s = [((1 + e) * z - x) / tau for x, z in zip(old_s, new_c, strict=True)]
        state = State(old_s, W_s, d, old_c, W_c)
        phi, gap, h_4, h_5, C_eta = (fmpq(rng.randint(1, 99), 100) for _ in range(5))
        r, speed = phi * gap, fmpq(rng.randint(1, 99), 10)
        if dot(W_c, new_s) < 0 < state.eta_s and Place(r, state).m.eta_c < 0:
            break
    names = ("V_0", "delta_x", "eta_bar", "zeta_bar", "Delta_theta", "delta_theta")
    drawn = {name: fmpq(rng.randint(1, 99), rng.randint(1, 99)) for name in names}
    constants = SimpleNamespace(
        r=r, c=2 * (phi + gap) / (1 + r), alpha=phi + gap, phi=phi, h_4=h_4, h_5=h_5, speed=speed,
        V_1=speed**2, C_eta=C_eta, delta_2=gap / 2, delta_3=1 - C_eta, x_0=drawn["delta_x"] / 2,
        **drawn,
    )  # fmt: skip
    return Place(r, state, constants)


# --- states that the recursion's hypothesis allows ------------------------------------------------


def constants(rng: random.Random) -> Constants:
    """The printed constants at a point of the theorem's range with rational fixed points."""
    while True:
        large, small = fmpq(rng.randint(200, 494), 1000), fmpq(rng.randint(5, 999), 10000)
        r = large * small
        c = 2 * (large + small) / (1 + r)
        if c <= 1 and small < large**2 and r < fmpq(55, 1000):
            delta_theta, V_0 = (fmpq(rng.choice([1, 10, 1000]), 100) for _ in range(2))
            return Constants(r, c, delta_theta, V_0)


def near(x: Number) -> fmpq:
    """A rational close to a number, and a little below it."""
    scale = 10**40
    if isinstance(x, arb):
        return fmpq(int((x * scale).floor().unique_fmpz()), scale)
    return fmpq(x)


def near_root(x: Number) -> fmpq:
    """A rational a little below the square root."""
    scale = 10**40
    q = near(x)
    return fmpq(isqrt(int(q.p) * scale**2 // int(q.q)), scale)


def _tangent(rng: random.Random, omega: Vector) -> Vector:
    draw = [fmpq(rng.randint(-99, 99), 100) for _ in omega]
    draw[-1] += fmpq(1, 1000)
    return along(draw, -dot(draw, omega), omega)


def _velocity(rng: random.Random, omega: Vector, normal: fmpq, square: fmpq) -> Vector:
    side = _tangent(rng, omega)
    size = near_root((square - normal**2) / dot(side, side))
    return along([normal * x for x in omega], size, side)


def allowed_place(rng: random.Random, dimension: int) -> Place | None:
    """A state drawn so that the conditions at n may hold; None if that fails at once."""
    K = constants(rng)
    V_0, V_1 = near(K.V_0), near(K.V_1)
    y, zeta = near(K.eta_bar) * share(rng), near(K.zeta_bar) * share(rng)
    top = min(V_1, near(norms(K, K.eta_bar - y)))
    A, B = (V_0 + (top - V_0) * share(rng) for _ in range(2))
    X = near(K.phi) + rng.choice([-1, 1]) * near(K.delta_x) * share(rng)
    half = near_root((1 + K.c) / (1 - K.c)) if K.c < 1 else fmpq(10**6)
    half *= 1 + rng.choice([-1, 0, 1]) * near(K.Delta_theta) * share(rng) / 9
    omega_s = [fmpq(1)] + [fmpq(0)] * (dimension - 1)
    cosine = (1 - half**2) / (1 + half**2)
    omega_c = [cosine, 2 * half / (1 + half**2)] + [fmpq(0)] * (dimension - 2)
    if not X > 0:
        return None
    W_s, W_c = _velocity(rng, omega_s, X * y, B), _velocity(rng, omega_c, -y, A)
    # d(2+d)/(1+d)^2 <= 2d: zeta stays below what was drawn.
    return Place(K.r, State(omega_s, W_s, zeta * y**2 / (2 * A), omega_c, W_c), K)
