"""Exact reading of what people type: every number stays the number that was written."""

from __future__ import annotations

import os
import re
import stat
from collections.abc import Callable, Iterable, Mapping
from fractions import Fraction

from verify.language.terms import Term, as_term, cos, cos_pi
from verify.prover.decimals import decimal_text, round_decimal

#: Longer texts are refused before any arithmetic.
MAX_LENGTH = 4000
#: Larger decimal exponents are refused: 1e99999999 would fill the memory.
MAX_EXPONENT = 4000

#: Numerators and denominators are smaller than 10^4200, so that any reader of JSON can read them.
MAX_DIGITS = 4200

_RATIONAL = r"([+-]?[0-9]+)/([0-9]+)"
_DECIMAL = r"([+-]?)([0-9]*)\.?([0-9]*)(?:[eE]([+-]?[0-9]+))?"
#: ``pi``, ``5pi/6``, ``0.9*pi``, ``5/6*pi``: a factor, and what divides.
_PI = r"(?:([0-9][0-9.eE/+-]*)\*?)?(?:pi|π)(?:/([0-9]+))?"
_DEGREES = r"([0-9][0-9.eE/+-]*) ?(?:deg|degrees|°)"


class InputError(ValueError):
    """A text that cannot be used: the message says what, where and what to write instead."""


class TooDeepError(InputError):
    """Terms of an input nest more deeply than the checker reads."""


def regular_file(path: str, most: int) -> bytes:
    """The content of a file that has an end: nothing is waited for, and no device is read.

    Raises:
        OSError: if there is none that can be read.
        ValueError: if it is no regular file, or has more than ``most`` bytes.
    """
    with open(os.open(path, os.O_RDONLY | os.O_NONBLOCK), "rb") as file:
        if not stat.S_ISREG(os.fstat(file.fileno()).st_mode):
            raise ValueError("it is no regular file")
        content = file.read(most + 1)
    if len(content) > most:
        raise ValueError(f"it has more than {most} bytes")
    return content


def rational(option: object, text: str) -> Fraction:
    """Read ``3/100``, ``0.03`` or ``3e-2`` exactly.

    Raises:
        InputError: for anything else, naming the option.
    """
    _check_length(option, text)
    match = re.fullmatch(_RATIONAL, text)
    if match:
        denominator = int(match[2])
        if denominator == 0:
            raise InputError(f"{option}: {shown(text)} divides by zero; write p/q with q > 0")
        return Fraction(int(match[1]), denominator)
    match = re.fullmatch(_DECIMAL, text)
    if not match or not (match[2] or match[3]):
        raise InputError(f"{option}: {shown(text)} is not an exact number; write {_meant(text)}")
    exponent_text = match[4] or "0"
    if len(exponent_text.lstrip("+-0")) > 6 or abs(int(exponent_text)) > MAX_EXPONENT:
        raise InputError(
            f"{option}: the exponent of {shown(text)} is too large; "
            f"write an exponent between -{MAX_EXPONENT} and {MAX_EXPONENT}"
        )
    digits = int(match[1] + (match[2] + match[3]))
    value = digits * Fraction(10) ** (int(exponent_text) - len(match[3]))
    if max(abs(value.numerator), value.denominator) >= 10**MAX_DIGITS:
        raise InputError(
            f"{option}: {shown(text)} has more than {MAX_DIGITS} digits as a fraction; "
            "write fewer digits or a smaller exponent"
        )
    return value


#: What people type for a point, and for a minus sign.
_TYPED = str.maketrans({",": ".", "−": "-", "–": "-", "\N{ZERO WIDTH NO-BREAK SPACE}": None})


def hundredth(percent: str) -> str:
    """The number that is so many percent, for a decimal with a few digits."""
    return decimal_text(*round_decimal(Fraction(percent) / 100, 40, up=False))


def _meant(text: str) -> str:
    """The number that was probably meant, or how numbers are written."""
    mended = text.translate(_TYPED).strip()
    percent = re.fullmatch(r"([0-9]{1,9}(?:\.[0-9]{1,9})?) ?%", mended)
    if percent:
        return hundredth(percent[1])
    is_one = re.fullmatch(rf"(?=.*[0-9])(?:{_RATIONAL}|{_DECIMAL})", mended)
    return mended if is_one else "it like 0.03, 3/100 or 3e-2"


def restitution(text: str) -> Fraction:
    """Read a restitution coefficient in ]0,1[.

    Raises:
        InputError: for any other text.
    """
    r = rational("--r", text)
    if not 0 < r < 1:
        raise InputError(f"--r: {shown(text)} is not in ]0,1[; write for example 0.03")
    return r


def neg_cos(text: str) -> Fraction:
    """Read -cos of the angle, in ]0,1].

    Raises:
        InputError: for any other text.
    """
    value = rational("--neg-cos", text)
    if not 0 < value <= 1:
        raise InputError(f"--neg-cos: {shown(text)} is not in ]0,1]; write for example 9/10")
    return value


def positive(option: str, text: str) -> Fraction:
    """Read a positive number.

    Raises:
        InputError: for any other text.
    """
    value = rational(option, text)
    if value <= 0:
        raise InputError(f"{option}: {shown(text)} is not positive; write for example 1/10")
    return value


def share(option: str, text: str) -> Fraction:
    """Read a share between 0 and 1, which may be in percent.

    Raises:
        InputError: for any other text.
    """
    value = rational(option, text.removesuffix("%")) / (100 if text.endswith("%") else 1)
    if not 0 <= value <= 1:
        raise InputError(f"{option}: {shown(text)} is no share; write a share such as 0.1%")
    return value


def interval(
    option: str, text: str, read: Callable[[str], Fraction], *, points: bool = False
) -> tuple[Fraction, Fraction]:
    """Read the ends of an interval ``A..B``; with ``points`` also a number, which is both ends.

    Raises:
        InputError: for any other text, or if the ends are not in order.
    """
    words = text.split("..") * (2 if points and ".." not in text else 1)
    if len(words) != 2:
        raise InputError(f"{option}: {shown(text)} is no interval; write it as 0.01..0.05")
    low, high = map(read, words)
    if not (low < high or (points and low == high)):
        raise InputError(
            f"{option}: the interval {shown(text)} is not A < B; write the smaller end first"
        )
    return low, high


def angle(option: str, text: str) -> Term:
    """Read an angle in ]pi/2, pi] and return -cos of it as a term.

    The angle is a multiple of pi (``pi``, ``5pi/6``, ``0.9*pi``, ``π``), in degrees (``150deg``,
    ``150°``), or in radians; it is exactly what is written. Where its cosine is rational the term
    is that rational.

    Raises:
        InputError: for another form, or an angle outside the interval.
    """
    _check_length(option, text)
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


def integer(option: str, text: str, least: int, most: int) -> int:
    """Read a whole number between two bounds.

    Raises:
        InputError: for anything else.
    """
    if not re.fullmatch(r"[0-9]{1,9}", text) or not least <= int(text) <= most:
        raise InputError(
            f"{option}: {shown(text)} is not usable; write a whole number from {least} to {most}"
        )
    return int(text)


def _check_length(option: object, text: str) -> None:
    if len(text) > MAX_LENGTH:
        raise InputError(
            f"{option}: {shown(text)} has {len(text)} characters; write at most {MAX_LENGTH}"
        )


def _positive(option: str, text: str, number: int) -> int:
    if number == 0:
        raise InputError(f"{option}: {shown(text)} divides by zero; write pi/n with n > 0")
    return number


def _outside(option: str, text: str) -> str:
    return f"{option}: {shown(text)} is not in ]pi/2, pi]; write an obtuse angle such as 5pi/6"


def shown(text: str, most: int = 40) -> str:
    """A text as an error message quotes it: in quotes, and cut if longer than ``most``."""
    return repr(text if len(text) <= most else f"{text[: most // 2]}...{text[-most // 4 :]}")


def nearest(name: str, known: Iterable[str], otherwise: str = "") -> str:
    """What to write instead of a name: the known one that is like it, or some of those."""
    from difflib import get_close_matches  # loaded only where it is used

    names = list(known)
    near = get_close_matches(name, names, 1)
    if near:
        return f"did you mean {near[0]}?"
    some = ", ".join(names[:8]) + (", ..." if len(names) > 8 else "")
    return otherwise or (f"write one of {some}" if some else "there is none")


# --- the parameters of Theorem 1 -----------------------------------------------------------------


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
