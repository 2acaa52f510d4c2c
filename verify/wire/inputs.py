"""Exact reading of what people type: every number stays the number that was written."""

from __future__ import annotations

import os
import re
import stat
from collections.abc import Callable, Iterable
from fractions import Fraction

#: Longer texts are refused before any arithmetic.
MAX_LENGTH = 4000
#: Larger decimal exponents are refused: 1e99999999 would fill the memory.
MAX_EXPONENT = 4000

#: Numerators and denominators are smaller than 10^4200, so that any reader of JSON can read them.
MAX_DIGITS = 4200

_RATIONAL = r"([+-]?[0-9]+)/([0-9]+)"
_DECIMAL = r"([+-]?)([0-9]*)\.?([0-9]*)(?:[eE]([+-]?[0-9]+))?"


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
    check_length(option, text)
    match = re.fullmatch(_RATIONAL, text)
    if match:
        denominator = int(match[2])
        if denominator == 0:
            raise InputError(f"{option}: {shown(text)} divides by zero; write p/q with q > 0")
        return Fraction(int(match[1]), denominator)
    match = re.fullmatch(_DECIMAL, text)
    if not match or not (match[2] or match[3]):
        from verify.wire.meant import number  # loaded only where it is used

        raise InputError(f"{option}: {shown(text)} is not an exact number; write {number(text)}")
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


def positive(option: str, text: str) -> Fraction:
    """Read a positive number.

    Raises:
        InputError: for any other text.
    """
    value = rational(option, text)
    if value <= 0:
        raise InputError(f"{option}: {shown(text)} is not positive; write for example 1/10")
    return value


def share(option: str, text: str, *, inside: bool = False) -> Fraction:
    """Read a share from 0 to 1, which may be in percent; one ``inside`` is neither 0 nor 1.

    Raises:
        InputError: for any other text.
    """
    number = text.removesuffix("%").replace(",", ".")
    if text.endswith("%") and "," in text:
        raise InputError(f"{option}: {shown(text)} is no share; write {number}%")
    value = rational(option, text.removesuffix("%")) / (100 if text.endswith("%") else 1)

    def fits(one: Fraction) -> bool:
        return 0 < one < 1 if inside else 0 <= one <= 1

    if not fits(value):
        is_percent = value > 1 and fits(value / 100) and not text.endswith("%")
        meant = f"{text}%" if is_percent else "for example 99%" if inside else "for example 0.1%"
        where = "(0, 1)" if inside else "[0, 1]"
        raise InputError(f"{option}: {shown(text)} is not in {where}; write {meant}")
    return value


def interval(
    option: str, text: str, read: Callable[[str], Fraction], *, points: bool = False
) -> tuple[Fraction, Fraction]:
    """Read the ends of an interval ``A..B``; with ``points`` also a number, which is both ends.

    Raises:
        InputError: for any other text, or if the ends are not in order.
    """
    words = text.split("..") * (2 if points and ".." not in text else 1)
    from verify.wire.meant import between  # loaded only where it is used

    meant = between(text)
    if len(words) != 2 or meant or "" in map(str.strip, words):
        instead = meant or "it as 0.01..0.05"
        raise InputError(f"{option}: {shown(text)} is no interval; write {instead}")
    low, high = map(read, words)
    if not (low < high or (points and low == high)):
        raise InputError(
            f"{option}: the interval {shown(text)} is not A < B; write the smaller end first"
        )
    return low, high


def integer(option: str, text: str, least: int, most: int) -> int:
    """Read a whole number between two bounds.

    Raises:
        InputError: for anything else.
    """
    longest = max(9, len(str(most)))
    if not re.fullmatch(f"[0-9]{{1,{longest}}}", text) or not least <= int(text) <= most:
        from verify.wire.meant import whole  # loaded only where it is used

        meant = whole(text, least, most) or f"a whole number from {least} to {most}"
        raise InputError(f"{option}: {shown(text)} is not usable; write {meant}")
    return int(text)


def check_length(option: object, text: str) -> None:
    """Refuse what is too long to be a number.

    Raises:
        InputError: naming the option.
    """
    if len(text) > MAX_LENGTH:
        raise InputError(
            f"{option}: {shown(text)} has {len(text)} characters; write at most {MAX_LENGTH}"
        )


def shown(text: str, most: int = 40) -> str:
    """A text as an error message quotes it: in quotes, and cut if longer than ``most``."""
    return repr(cut(text, most))


def cut(text: str, most: int = 100) -> str:
    """A text, without its middle if it is longer."""
    return text if len(text) <= most else f"{text[: most // 2]}...{text[-most // 4 :]}"


def file_name(path: str) -> str:
    """The last part of a path, as a title has it: what cannot be printed is escaped."""
    letters = os.path.basename(path)
    return "".join(x if x.isprintable() else ascii(x)[1:-1] for x in letters)


def near(name: str, known: Iterable[str]) -> str:
    """The known name that is like this one, apart from capitals, or nothing."""
    from difflib import get_close_matches  # loaded only where it is used

    small = {other.lower(): other for other in known}
    found = [name.lower()] if name.lower() in small else get_close_matches(name.lower(), small, 1)
    return small[found[0]] if found else ""


def nearest(name: str, known: Iterable[str], otherwise: str = "") -> str:
    """What to write instead of a name: the known one that is like it, or some of those."""
    names = list(known)
    meant = near(name, names)
    if meant:
        return f"did you mean {cut(meant)}?"
    some = ", ".join(map(cut, names[:8])) + (", ..." if len(names) > 8 else "")
    return otherwise or (f"write one of {some}" if some else "there is none")
