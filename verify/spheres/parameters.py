"""The parameters of three particles, as people type them: restitution, angle, velocity."""

from __future__ import annotations

import re
from collections.abc import Mapping
from fractions import Fraction

from verify.language.terms import Term, as_term, cos, cos_pi
from verify.wire.inputs import InputError, check_length, positive, rational, shown

#: ``pi``, ``5pi/6``, ``0.9*pi``, ``5/6*pi``: a factor, and what divides.
_PI = r"(?:([0-9][0-9.eE/+-]*)\*?)?(?:pi|π)(?:/([0-9]+))?"
_DEGREES = r"([0-9][0-9.eE/+-]*) ?(?:deg|degrees|°)"


#: What is meant where nothing is said.
DEFAULTS = {"delta_theta": "1/10", "V0": "1"}


def read_parameters(given: Mapping[str, str | None]) -> dict[str, Term]:
    """The parameters of Theorem 1 as exact terms, from r, theta0 or neg_cos, delta_theta and V0.

    Raises:
        InputError: for a number outside its range, or two angles.
    """
    texts = DEFAULTS | {name: text for name, text in given.items() if text is not None}
    if "theta0" in texts and "neg_cos" in texts:
        raise InputError("--theta0 and --neg-cos both give the angle; write only one of them")
    r = as_term(restitution(texts["r"]))
    if "theta0" in texts:
        c = angle("--theta0", texts["theta0"])
    else:
        c = as_term(neg_cos(texts.get("neg_cos", "1")))
    return {
        "r": r,
        "c": c,
        "V_0": as_term(positive("--V0", texts["V0"])),
        "delta_theta": as_term(positive("--delta-theta", texts["delta_theta"])),
    }


def restitution(text: str, *, elastic: bool = False) -> Fraction:
    """Read a restitution coefficient in (0, 1), or 1 where collisions may be ``elastic``.

    Raises:
        InputError: for any other text.
    """
    r = rational("--r", text)
    if not 0 < r < 1 and not (elastic and r == 1):
        where = "(0, 1]" if elastic else "(0, 1)"
        known = ELASTIC if r == 1 else ""
        raise InputError(f"--r: {shown(text)} is not in {where}; write for example 0.03{known}")
    return r


#: What is known at r = 1, where nothing collapses.
ELASTIC = "; what is proved at 1 is told by verify classification --r 1"


def neg_cos(text: str) -> Fraction:
    """Read -cos of the angle, in (0, 1].

    Raises:
        InputError: for any other text.
    """
    value = rational("--neg-cos", text)
    if not 0 < value <= 1:
        raise InputError(f"--neg-cos: {shown(text)} is not in (0, 1]; write for example 9/10")
    return value


def three_positive(option: str, text: str) -> tuple[Fraction, ...]:
    """Read a number for each of three balls.

    Raises:
        InputError: if they are not three positive numbers.
    """
    found = tuple(rational(option, word.strip()) for word in text.split(","))
    if len(found) != 3 or min(found) <= 0:
        raise InputError(f"{option}: {shown(text)} are not three positive numbers; write 1,2,3")
    return found


def angle(option: str, text: str) -> Term:
    """Read an angle in (pi/2, pi] and return -cos of it as a term.

    The angle is a multiple of pi (``pi``, ``5pi/6``, ``0.9*pi``, ``π``), in degrees (``150deg``,
    ``150°``), or in radians; it is exactly what is written. Where its cosine is rational the term
    is that rational.

    Raises:
        InputError: for another form, or an angle outside the interval.
    """
    check_length(option, text)
    turns = _half_turns(option, text)
    if turns is not None:
        if not Fraction(1, 2) < turns <= 1:
            raise InputError(_outside(option, text))
        # The only rational cosines of rational multiples of pi here (Niven's theorem).
        if turns in (1, Fraction(2, 3)):
            return as_term(1 if turns == 1 else Fraction(1, 2))
        return -cos_pi(turns)
    try:
        radians = rational(option, text)
    except InputError as error:
        raise InputError(
            f"{option}: {shown(text)} is not an angle; write it like pi, 5pi/6, 0.9*pi, 150deg, "
            "or 2.9 (radians)"
        ) from error
    if 90 < radians <= 180:
        raise InputError(f"{option}: {shown(text)} is in radians; write {text}deg for degrees")
    if not is_obtuse(radians):
        raise InputError(_outside(option, text))
    return -cos(radians)


def _half_turns(option: str, text: str) -> Fraction | None:
    """An angle as a multiple of pi, where it is written as one or in degrees."""
    match = re.fullmatch(_PI, text)
    if match:
        factor = rational(option, match[1]) if match[1] else Fraction(1)
        return factor / _positive(option, text, int(match[2] or 1))
    match = re.fullmatch(_DEGREES, text)
    return rational(option, match[1]) / 180 if match else None


def _positive(option: str, text: str, number: int) -> int:
    if number == 0:
        raise InputError(f"{option}: {shown(text)} divides by zero; write pi/n with n > 0")
    return number


def _outside(option: str, text: str) -> str:
    return f"{option}: {shown(text)} is not in (pi/2, pi]; write an obtuse angle such as 5pi/6"


def are_allowed(parameters: Mapping[str, Term]) -> bool:
    """Whether each parameter has a form and a value that the program takes.

    r in (0, 1), V_0 > 0 and delta_theta > 0 are rationals; c is a rational in (0, 1], or
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
