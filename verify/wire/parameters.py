"""Which values the parameters of Theorem 1 may have, and in which form they are written."""

from __future__ import annotations

from collections.abc import Mapping
from fractions import Fraction

from verify.language.terms import Term


def are_allowed(parameters: Mapping[str, Term]) -> bool:
    """Whether each parameter has a form and a value that the program takes.

    r in ]0,1[, V_0 > 0 and delta_theta > 0 are rationals; c is a rational in ]0,1], or
    -cos_pi(q) with 1/2 < q <= 1, or -cos(q) with pi/2 < q <= pi, for a rational q.
    """
    if parameters.keys() != {"r", "c", "V_0", "delta_theta"}:
        return False
    r, v_0, delta = (_rational(parameters[name]) for name in ("r", "V_0", "delta_theta"))
    if r is None or v_0 is None or delta is None:
        return False
    return 0 < r < 1 and 0 < v_0 and 0 < delta and _is_cosine(parameters["c"])


def _rational(term: Term) -> Fraction | None:
    return term.value if term.op == "rational" else None


def _is_cosine(c: Term) -> bool:
    """Whether a term is an allowed value of -cos theta_0."""
    value = _rational(c)
    if value is not None:
        return 0 < value <= 1
    if c.op != "neg" or c.children[0].op not in ("cos", "cos_pi"):
        return False
    cosine = c.children[0]
    angle = _rational(cosine.children[0])
    if angle is None:
        return False
    return Fraction(1, 2) < angle <= 1 if cosine.op == "cos_pi" else is_obtuse(angle)


def is_obtuse(radians: Fraction) -> bool:
    """Decide pi/2 < x <= pi for a rational x; pi is irrational, so some precision decides."""
    if not 1 < radians < 4:  # so that what follows compares numbers of one size
        return False
    from verify.prover import balls  # flint is loaded only where it is used

    bits = 64
    while True:
        with balls.precision(bits):
            x, pi = balls.from_fraction(radians), balls.pi()
            for bound in (pi, pi / 2):
                if not (balls.less(x, bound) or balls.less(bound, x)):
                    break
            else:
                return balls.less(pi / 2, x) and balls.less(x, pi)
        bits *= 2
