"""Why only finitely many collisions are possible although they were not all followed.

R² = Σ|x_i|², A = Σ x_i·v_i and L², the square of the angular momentum, belong to the frame of the
centre of mass; they are polynomials in the inner products of a state.
"""

from __future__ import annotations

from verify.language.record import Record
from verify.spheres.flow.law import Number, State, inner, outer

INELASTIC, RECEDING, TURNING = "restitution", "receding", "turning"
#: What each criterion says, in words.
SAYS = {
    INELASTIC: "r > 7 - 4√3: three equal spheres with this r never collapse",
    RECEDING: "A >= 0 and R² >= 2: the spheres recede as a whole; a collapse would need R² <= 2",
    TURNING: "A²R² < (R² - 2)L² and R² >= 2: with this angular momentum R² never falls to 2",
}


class Whole(Record):
    """R², A and L² of three spheres."""

    R2: Number
    A: Number
    L2: Number


def whole(state: State) -> Whole:
    """The three numbers of a state."""
    pairs = (*inner(state), outer(state))
    R2 = 1 + (pairs[0].g + pairs[1].g + pairs[2].g) / 3
    A = (pairs[0].p + pairs[1].p + pairs[2].p) / 3
    return Whole(R2, A, angular(state))


def angular(state: State) -> Number:
    """L² for L = (2/3)(x_s∧W_s + x_c∧W_c) - (1/3)(x_s∧W_c + x_c∧W_s)."""
    v = state.v
    xx = {"ss": 1 + state.sig * v**2, "cc": 1 + state.eps * v**2, "sc": -state.C}
    ww = {"ss": state.B, "cc": state.A, "sc": state.w}
    xw = {"ss": state.rho * v, "cc": -(state.lam * v), "sc": state.a, "cs": state.b}

    def product(i: str, j: str, k: str, m: str) -> Number:
        """(x_i∧W_j)·(x_k∧W_m)."""
        return _of(xx, i, k) * _of(ww, j, m) - xw[i + m] * xw[k + j]

    blades = ((2, "s", "s"), (2, "c", "c"), (-1, "s", "c"), (-1, "c", "s"))
    parts = [n * k * product(i, j, x, y) for n, i, j in blades for k, x, y in blades]
    total = parts[0]
    for part in parts[1:]:
        total = total + part
    return total / 9


def _of(table: dict[str, Number], i: str, j: str) -> Number:
    return table["sc"] if i != j else table[i + j]


def inelastic(r: Number) -> Number:
    """What is negative if r > 7 - 4√3, for r in ]0,1[."""
    return r**2 - 14 * r + 1


def turning(now: Whole) -> Number:
    """What is positive if the angular momentum keeps R² above 2, where R² >= 2 now."""
    return (now.R2 - 2) * now.L2 - now.A**2 * now.R2
