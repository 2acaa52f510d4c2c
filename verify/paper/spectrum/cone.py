"""The cone of pre-collisional data after the proof of the theorem, before any iteration.

(x, y, z, t) are the coordinates just before a triple of collisions. The conditions x < 0 and
z < h x, h = (1+r)/4, are written x = -a and z = h x - b with a, b > 0; so a claim on the cone is
a claim for all a, b > 0.
"""

from __future__ import annotations

from collections.abc import Iterator

from verify.language.statement import Obligation
from verify.language.terms import Term, as_term, equal, sqrt
from verify.paper.rows import REMARK, SLIP
from verify.paper.spectrum.collision_matrices import (
    A_A,
    A_B,
    flipped,
    inner,
    omega_1,
    omega_1_perp,
    omega_2,
    omega_2_perp,
    omega_3,
)
from verify.paper.spectrum.matrices import Vector, apply, dot, vector
from verify.paper.spectrum.printed import THEOREM, Printed, h, r, root_3
from verify.paper.spectrum.section import ANY, CONE, Section, symbols

BOUND = "EQUATSS3.5Minor_z'__Triag"

x, y, z, t = STATE = symbols("x y z t")
a, b, g = symbols("a b g")

#: The normal component of the relative velocity of 1 and 2, as a row in the printed coordinates.
NORMAL_12: Vector = vector(as_term(1) / 2, -(root_3 / 2), as_term(1) / 2, root_3 / 2)

k_x = (r**2 - 4 * r - 5) / 16
k_z = (r**2 - 16 * r - 1) / 16
_drift = root_3 / 8 * (r + 1)

_section = Section("cone")
needed, printed, misprint = _section.needed, _section.printed, _section.misprint


def bound_x(x: Term, difference: Term) -> tuple[Term, Term]:
    """The two displayed lower bounds of x', where ``difference`` is y - t."""
    first = (-(r**3) + 5 * r**2 - 59 * r - 1) / 64 * x + (1 + r) / 64 * (r**2 - 4 * r - 5) * x
    return first + _drift * difference, (2 * r**2 - 68 * r - 6) / 64 * x + _drift * difference


def bound_z(x: Term, difference: Term) -> tuple[Term, Term]:
    """The two displayed lower bounds of z'."""
    first = (-(r**3) + 17 * r**2 + 13 * r - 5) / 64 * x + _drift * difference
    return (
        first + (1 + r) / 64 * (r**2 - 16 * r - 1) * x,
        (2 * r**2 - 4 * r - 6) / 64 * x + _drift * difference,
    )


def rows(paper: Printed) -> Iterator[Obligation]:
    """Yield the rows on the conditions, the lower bounds and y < t."""
    yield from _conditions()
    yield from _signs()
    yield from _bounds(paper)
    yield from _last_condition(paper)


def _conditions() -> Iterator[Obligation]:
    after_a = apply(A_A, STATE)
    w_1 = tuple(x * u + y * v for u, v in zip(omega_1, omega_1_perp, strict=True))
    w_2 = tuple(z * u + t * v for u, v in zip(omega_2, omega_2_perp, strict=True))
    difference = tuple(v - u for u, v in zip(w_1, w_2, strict=True))
    yield from (
        needed("cone-condition-02", THEOREM, "after 0-1 the normal component of 0-2 is z - "
            "(1+r)/4 x, so that 0-2 is pre-collisional exactly if z < (1+r)/4 x",
            equal(after_a[2], z - h * x)),
        needed("cone-normal-12",    THEOREM, "(W₂-W₁)·ω₃ in the printed coordinates",
            equal(inner(difference, omega_3), dot(NORMAL_12, STATE))),
        needed("cone-condition-12", THEOREM, "the third condition, which the cone of the text "
            "leaves out: after 0-1 and 0-2 the normal component of 1-2 is this, and it must be "
            "negative", equal(dot(NORMAL_12, apply(A_B, after_a)), normal_12(x, z, t - y))),
    )  # fmt: skip


def normal_12(x: Term, z: Term, difference: Term) -> Term:
    """The normal component of 1-2 after 0-1 and 0-2, where ``difference`` is t - y."""
    return (x + z) / 2 + root_3 / 2 * difference - h * x - h * (z - h * x)


def _signs() -> Iterator[Obligation]:
    root = sqrt(65)
    yield from (
        needed("cone-sign-x", THEOREM, "(r²-4r-5)/16 < 0, for every r in ]0,1[", k_x < as_term(0)),
        needed("cone-sign-z", THEOREM, "(r²-16r-1)/16 < 0, for every r in ]0,1[", k_z < as_term(0)),
        printed("cone-sign-x-range", THEOREM,
            "'for r small enough': the first one is negative exactly for -1 < r < 5",
            equal(k_x, (r + 1) * (r - 5) / 16), ["signs"], context=ANY),
        printed("cone-sign-z-range", THEOREM, "the second one exactly for 8-√65 < r < 8+√65",
            equal(k_z, (r - (8 - root)) * (r - (8 + root)) / 16), ["signs"], context=ANY),
        printed("cone-sign-z-below", THEOREM, "8-√65 < 0, so that ]0,1[ lies in it",
            8 - root < as_term(0)),
    )  # fmt: skip


def _bounds(paper: Printed) -> Iterator[Obligation]:
    image = apply(paper.matrix, STATE)
    for letter, value, label, bounds, factor in (
        ("x", image[0], THEOREM, bound_x(x, y - t), k_x),
        ("z", image[2], BOUND, bound_z(x, y - t), k_z),
    ):
        first, second = bounds
        name = f"cone-{letter}"
        yield needed(f"{name}-bound-1", label, f"{letter}' exceeds the first displayed bound by a "
            "negative number times z - (1+r)/4 x, which is negative on the cone",
            equal(value - first, factor * (z - h * x)), ["signs"])  # fmt: skip
        yield misprint(f"{name}-bound-2", label,
            f"{letter}' is larger than a bound, and that is larger than another one: they are "
            f"equal, and all that is used, {letter}' > the second one, is true",
            second < first, REMARK, f"{name}-bound-2-equal", context=CONE)  # fmt: skip
        yield needed(f"{name}-bound-2-equal", label,
            f"the two displayed bounds of {letter}' are equal", equal(first, second))  # fmt: skip


def _last_condition(paper: Printed) -> Iterator[Obligation]:
    factor = (2 * r**2 - 4 * r - 6) / 64
    at = (-a, y, -(h * a) - b, t)
    image = apply(paper.matrix, at)[2]
    stated = apply(flipped(paper.matrix), at)[2]
    solved = -t - (g + (-factor) * a + (-k_z) * b) / _drift
    yield from (
        needed("cone-y-sign",     BOUND, "(2r²-4r-6)/64 < 0, for every r in ]0,1[",
            factor < as_term(0)),
        printed("cone-y-range",   BOUND,
            "'for r small enough': it is negative exactly for -1 < r < 3",
            equal(factor, (r - 3) * (r + 1) / 32), ["signs"], context=ANY),
        needed("cone-y",          BOUND, "z' < 0 imposes y < t: with x = -a, z = hx - b the "
            "number √3(1+r)/8 (t-y) is -z' plus positive multiples of a and b",
            equal(_drift * (t - y), -image + (-factor) * a + (-k_z) * b), ["signs"]),
        needed("cone-y-flipped",  BOUND, "in the basis as the text states it the condition is y + "
            "t < 0: -√3(1+r)/8 (y+t) is -z' plus positive multiples of a and b",
            equal(-(_drift * (y + t)), -stated + (-factor) * a + (-k_z) * b), ["signs"]),
        misprint("cone-y-stated", BOUND, "y < t in the basis as the text states it (ω₂⊥·ω₁ > 0), "
            "where x = -a, z = hx - b, z' = -g give this y", solved < t, SLIP, "cone-y-flipped",
            context=CONE),
    )  # fmt: skip
