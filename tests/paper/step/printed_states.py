"""The states at which the page `step_as_printed.toml` says that rows are false, by few numbers.

All that the page has of a state is computed here from these numbers, without a root.
"""

from __future__ import annotations

from collections.abc import Mapping
from fractions import Fraction

from verify.language.record import Record
from verify.language.terms import Term, as_term

AXES = ("1", "2", "3")
VECTORS = ("omega_s", "W_s", "omega_c", "W_c")
Vector = tuple[Fraction, Fraction, Fraction]


class Witnessed(Record):
    """A state by few rational numbers; all else is computed from them without a root.

    ``half`` is tan(θ'/2) for the angle θ' of ω_c against -ω_s. ``turn_c`` has the stereographic
    coordinates of ω_s' seen from ω_c, in the plane of ω_s and ω_c and across it; ``turn_s`` those
    of ω_c' from ω_s. ``n`` is the number of collisions before.
    """

    half: str
    y: str
    ratio: str
    tau: str
    turn_c: tuple[str, str]
    turn_s: tuple[str, str]
    n: int = 2


_SHORT = "13/2000000000"
WITNESSES = {
    "right": Witnessed(
        "1/5", "1/20000", "139/1000", _SHORT, ("273/80000000000", "0"), ("273/80000000000", "0")
    ),
    "left": Witnessed(
        "1/5", "1/20000", "11/1000", _SHORT, ("273/80000000000", "0"), ("273/80000000000", "0")
    ),
    "slow": Witnessed(
        "1/5", "1/20000", "75/1000", _SHORT,
        ("20799999987/6400000000000000000", "0"), ("273/80000000000", "0"),
    ),
    "space": Witnessed(
        "1/5", "1/20000", "75/1000", _SHORT,
        ("-39/80000000000000", "273/80000000000"), ("0", "-273/80000000000"),
    ),
    "late": Witnessed(
        "8/41", "1/60000", "75/1000", "13/6000000000",
        ("91/80000000000", "0"), ("91/80000000000", "0"), 5,
    ),
}  # fmt: skip
#: C_η there.
DECAY = "7/10"
#: What stands for -η_{c,0} and d₀ in the conditions. No orbit is shown that reaches the states.
START = ("11/100000", "1/1000000000000")


def state(numbers: Witnessed) -> Mapping[str, Term]:
    """The coordinates and numbers of a state, all rational, without a root.

    The directions before and after the flight are drawn; with the time they give the velocities.
    """
    t, y, tau = Fraction(numbers.half), Fraction(numbers.y), Fraction(numbers.tau)
    cosine, sine = (1 - t**2) / (1 + t**2), 2 * t / (1 + t**2)
    zero, one = Fraction(0), Fraction(1)
    omega_s, omega_c = (one, zero, zero), (-cosine, sine, zero)
    contact = _turned(omega_c, (sine, cosine, zero), numbers.turn_c)
    distance = _dot(contact, omega_c) + tau * y
    W_c = _velocity(omega_c, distance, contact, one, tau)
    end = _turned(omega_s, (zero, one, zero), numbers.turn_s)
    D = (1 + tau * Fraction(numbers.ratio) * y) / _dot(end, omega_s)
    W_s = _velocity(omega_s, one, end, D, tau)
    vectors = zip(VECTORS, (omega_s, W_s, omega_c, W_c), strict=True)
    found = {
        f"{name}_{i}": x for name, vector in vectors for i, x in zip(AXES, vector, strict=True)
    }
    found |= {"d": distance - 1, "S": -_dot(W_c, contact) / (distance * y), "tau": tau, "D": D}
    g, d_0 = map(Fraction, START)
    found |= {"g": g, "d_0": d_0, "decay": Fraction(DECAY) ** numbers.n}
    return {name: as_term(value) for name, value in found.items()}


def _dot(x: Vector, z: Vector) -> Fraction:
    return x[0] * z[0] + x[1] * z[1] + x[2] * z[2]


def _turned(omega: Vector, side: Vector, turn: tuple[str, str]) -> Vector:
    """The unit vector whose stereographic coordinates from omega are given, the second in space."""
    p, q = map(Fraction, turn)
    scale = 1 + p**2 + q**2
    x, z, up = (((2 - scale) * a + 2 * p * b) / scale for a, b in zip(omega, side, strict=True))
    return x, z, up + 2 * q / scale


def _velocity(old: Vector, before: Fraction, new: Vector, after: Fraction, tau: Fraction) -> Vector:
    """The velocity that takes a particle from one place to the other in the time tau."""
    x, z, up = ((after * b - before * a) / tau for a, b in zip(old, new, strict=True))
    return x, z, up
