"""Decimal texts of rational numbers: rounded outward for machines, short for people."""

from __future__ import annotations

from fractions import Fraction

#: Digits of a decimal text whose last place is far below the width that 128 bits earn.
DIGITS = 40

#: Digits of which an enclosure has to have as many in common to be shown by one number.
AGREEING = 3

_SUPERSCRIPTS = str.maketrans("-0123456789", "⁻⁰¹²³⁴⁵⁶⁷⁸⁹")


def decimal_exponent(value: Fraction) -> int:
    """The integer e with 10^e <= |value| < 10^(e+1), for a non-zero value."""
    numerator, denominator = abs(value.numerator), value.denominator
    exponent = (numerator.bit_length() - denominator.bit_length() - 1) * 30103 // 100000 - 1
    power = _power(abs(exponent))
    if exponent < 0:
        numerator *= power
    else:
        denominator *= power
    while numerator >= 10 * denominator:
        denominator *= 10
        exponent += 1
    return exponent


def round_decimal(value: Fraction, digits: int, up: bool) -> tuple[int, int]:
    """The mantissa m and exponent e of m * 10^e, at most ``digits`` digits, rounded one way.

    Exactly representable values are not changed; the mantissa has no trailing zeros.
    """
    if value == 0:
        return 0, 0
    exponent = decimal_exponent(value) - digits + 1
    numerator, denominator = value.numerator, value.denominator
    if exponent < 0:
        numerator *= _power(-exponent)
    else:
        denominator *= _power(exponent)
    mantissa = -(-numerator // denominator) if up else numerator // denominator
    for zeros in (16, 4, 1):
        while mantissa and mantissa % _power(zeros) == 0:
            mantissa //= _power(zeros)
            exponent += zeros
    return mantissa, exponent


def enclosing_decimals(low: int, high: int, divisor: int, digits: int) -> tuple[Fraction, Fraction]:
    """Decimals of about ``digits`` digits below and above two integers over a positive divisor.

    They are the integers over the divisor themselves where these are such decimals.
    """
    size = max(abs(low), abs(high)).bit_length() - divisor.bit_length()
    places = digits - 1 - size * 30103 // 100000
    up, unit = _power(max(places, 0)), _power(max(-places, 0))
    down = divisor * unit
    return Fraction(low * up // down * unit, up), Fraction(-(-high * up // down) * unit, up)


_POWERS: dict[int, int] = {}


def _power(exponent: int) -> int:
    """A power of ten; those of one run are few."""
    power = _POWERS.get(exponent)
    if power is None:
        power = _POWERS[exponent] = 10**exponent
    return power


def decimal_text(mantissa: int, exponent: int) -> str:
    """The decimal m * 10^e, plain where that is short and with an exponent elsewhere."""
    if mantissa == 0:
        return "0"
    sign, digits = ("-" if mantissa < 0 else ""), str(abs(mantissa))
    point = len(digits) + exponent
    if 0 < point <= 25 and exponent >= 0:
        return f"{sign}{digits}{'0' * exponent}"
    if 0 < point < len(digits):
        return f"{sign}{digits[:point]}.{digits[point:]}"
    if -4 < point <= 0:
        return f"{sign}0.{'0' * -point}{digits}"
    tail = f".{digits[1:]}" if digits[1:] else ""
    return f"{sign}{digits[0]}{tail}e{point - 1}"


def outward(ends: tuple[Fraction, Fraction], digits: int = DIGITS) -> list[str]:
    """Two decimal texts that enclose the two ends."""
    low, high = ends
    return [
        decimal_text(*round_decimal(low, digits, up=False)),
        decimal_text(*round_decimal(high, digits, up=True)),
    ]


def short(ends: tuple[Fraction, Fraction], digits: int = 8) -> str:
    """The digits on which the two ends agree, at most ``digits``, followed by … if cut off.

    Where they agree on fewer than `AGREEING` digits, both ends, with as many as tell them apart.
    """
    low, high = ends
    if low == high:
        mantissa, exponent = round_decimal(low, digits, up=low < 0)
        mark = "" if mantissa * Fraction(10) ** exponent == low else "…"
        return people(decimal_text(mantissa, exponent), mark)
    if low < 0 < high or not (low and high) or decimal_exponent(low) != decimal_exponent(high):
        return both_ends(ends)
    exponent = decimal_exponent(low) - digits + 1
    a, b = (_towards_zero(end, exponent) for end in ends)
    while a != b:
        a, b, exponent = _cut(a), _cut(b), exponent + 1
    if abs(a) < 10 ** (min(AGREEING, digits) - 1):
        return both_ends(ends)
    return people(decimal_text(a, exponent), "…")


def both_ends(ends: tuple[Fraction, Fraction]) -> str:
    """The interval, rounded outward to as many digits as tell its ends apart, and two more."""
    low, high = ends
    largest = decimal_exponent(max(abs(low), abs(high)))
    digits = min(max(3, 3 + largest - decimal_exponent(high - low)), DIGITS)
    return f"[{', '.join(map(people, outward(ends, digits)))}]"


def people(text: str, mark: str = "") -> str:
    """A decimal text as people write it: 5.9·10⁻⁵ for 5.9e-5; ``mark`` follows the digits."""
    digits, _, exponent = text.partition("e")
    if not exponent:
        return digits + mark
    power = f"10{exponent.translate(_SUPERSCRIPTS)}"
    return power if digits + mark == "1" else f"{digits}{mark}·{power}"


def told_number(value: Fraction, digits: int = 8) -> str:
    """A rational as people write it: the decimal that it is, or a short fraction, or its digits."""
    text = short((value, value), digits)
    return str(value) if "…" in text and value.denominator < 1000 else text


def exact_number(value: Fraction, digits: int = 12) -> str:
    """A rational exactly: as a decimal where that is short, else as a fraction."""
    text = short((value, value), digits)
    return str(value) if "…" in text else text


def _towards_zero(value: Fraction, exponent: int) -> int:
    numerator, denominator = abs(value.numerator), value.denominator
    if exponent < 0:
        numerator *= 10**-exponent
    else:
        denominator *= 10**exponent
    quotient = numerator // denominator
    return -quotient if value < 0 else quotient


def _cut(mantissa: int) -> int:
    return -(-mantissa // 10) if mantissa < 0 else mantissa // 10


def rational_text(value: Fraction) -> str:
    """``p/q``, or ``p`` for an integer."""
    return str(value)
