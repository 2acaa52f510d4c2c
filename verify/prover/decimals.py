"""Decimal texts of rational numbers: rounded outward for machines, short for people."""

from __future__ import annotations

from fractions import Fraction

#: Digits of a decimal text whose last place is far below the width that 128 bits earn.
DIGITS = 40

#: Digits of which an enclosure has to have as many in common to be shown by one number.
AGREEING = 3

#: A decimal with as many digits is short.
NEAR_DIGITS = 12

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

    Where they agree on fewer than `AGREEING` digits, a short decimal between them with what they
    differ from it at most, or both ends, with as many digits as tell them apart.
    """
    low, high = ends
    if low == high:
        mantissa, exponent = round_decimal(low, digits, up=low < 0)
        if mantissa * Fraction(10) ** exponent == low:
            return people(decimal_text(mantissa, exponent))
    if low < 0 < high or not (low and high) or decimal_exponent(low) != decimal_exponent(high):
        return both_ends(ends)
    exponent = decimal_exponent(low) - digits + 1
    a, b = (_towards_zero(end, exponent) for end in ends)
    while a != b:
        a, b, exponent = _cut(a), _cut(b), exponent + 1
    if abs(a) < 10 ** (min(AGREEING, digits) - 1):
        return both_ends(ends)
    return _cut_off(a, exponent)


def _cut_off(mantissa: int, exponent: int) -> str:
    """The first digits of a number."""
    if exponent <= 0:
        return people(decimal_text(mantissa, exponent), "…")
    head, rest = str(abs(mantissa))[0], str(abs(mantissa))[1:]  # the zeros of 99000… were digits
    shown = f"{head}.{rest}" if rest else head
    return people(f"{'-' if mantissa < 0 else ''}{shown}e{exponent + len(rest)}", "…")


def near_decimal(ends: tuple[Fraction, Fraction]) -> Fraction | None:
    """The short decimal between two ends that are so near to it that no other one is."""
    low, high = ends
    a, b = low.as_integer_ratio()
    c, d = high.as_integer_ratio()
    left, right = a * d, b * c
    if not 0 < (right - left) * _power(2 * NEAR_DIGITS) <= max(abs(left), abs(right)):
        return None
    exponent = decimal_exponent(high if abs(right) > abs(left) else low) - NEAR_DIGITS + 1
    up, down = _power(max(-exponent, 0)), _power(max(exponent, 0))
    whole = 2 * b * d * down
    near = ((left + right) * up * 2 + whole) // (2 * whole) * down  # over `up`
    return Fraction(near, up) if a * up <= near * b and near * d <= c * up else None


def both_ends(ends: tuple[Fraction, Fraction]) -> str:
    """The interval, rounded outward to as many digits as tell its ends apart, and two more.

    Around a short decimal: this, and a power of ten that it differs from it at most.
    """
    digits = min(max(AGREEING, _telling(*ends)), DIGITS)
    return _around(ends) or f"[{', '.join(map(people, outward(ends, digits)))}]"


def _around(ends: tuple[Fraction, Fraction]) -> str:
    near = near_decimal(ends)
    if near is None:
        return ""
    most = max(near - ends[0], ends[1] - near)
    exponent = decimal_exponent(most) + (most != Fraction(10) ** decimal_exponent(most))
    return f"{exact_number(near)} ± {people(decimal_text(1, exponent))}"


def rounded_inwards(ends: tuple[Fraction, Fraction], digits: int) -> list[str]:
    """Two decimals between the ends, as people write them, with at least ``digits`` digits.

    There are as many more as it takes for nine tenths of what is between the ends to be between
    the decimals.
    """
    low, high = ends
    while True:
        down, up = round_decimal(low, digits, up=True), round_decimal(high, digits, up=False)
        a, b = (mantissa * Fraction(10) ** exponent for mantissa, exponent in (down, up))
        if 10 * (b - a) >= 9 * (high - low):
            return [people(decimal_text(*end)) for end in (down, up)]
        digits = max(digits + 1, _telling(low, high) - 1)


def told_apart(
    left: tuple[Fraction, Fraction], right: tuple[Fraction, Fraction], digits: int = 8
) -> tuple[str, str]:
    """Two narrow enclosures in short, with so many digits that these show which number is larger.

    Where the enclosures do not show it, with ``digits``.
    """
    if left[1] < right[0] or right[1] < left[0]:
        for more in range(digits, DIGITS):
            if _shows(left, right, more) or _shows(right, left, more):
                texts = _to_digits(left, more), _to_digits(right, more)
                if all(texts):
                    return texts
    return short(left, digits), short(right, digits)


def as_one_or_two(
    left: tuple[Fraction, Fraction], right: tuple[Fraction, Fraction], digits: int = 8
) -> tuple[str] | tuple[str, str]:
    """Two numbers in one text, and how far apart they are, where no digits tell them apart.

    In two texts where digits do, where the numbers are exact and are shown whole, or where so
    little is known of them that they have no digits in common.
    """
    texts = told_apart(left, right, digits)
    near = max(right[0] - left[1], left[0] - right[1])
    if near > 0 and texts[0] != texts[1]:
        return texts
    common = short((min(left[0], right[0]), max(left[1], right[1])), digits)
    if common.startswith("["):
        return texts
    far = max(right[1] - left[0], left[1] - right[0])
    if far == 0:
        return (f"{common}, exactly equal",) if common.endswith("…") else texts
    most = people(decimal_text(*round_decimal(far, 1, up=True)))
    least = people(decimal_text(*round_decimal(near, 1, up=False))) if near > 0 else ""
    return (f"{common}, {least and f'at least {least} and '}at most {most} apart",)


def _to_digits(ends: tuple[Fraction, Fraction], digits: int) -> str:
    """An enclosure in short with all these digits, if it has as many; else nothing."""
    low, high = ends
    if low == high:
        return short(ends, digits)
    exponent = decimal_exponent(low or high) - digits + 1
    shown = _towards_zero(low, exponent)
    agree = shown == _towards_zero(high, exponent)
    return _around(ends) or (_cut_off(shown, exponent) if agree else "")


def _shows(
    smaller: tuple[Fraction, Fraction], larger: tuple[Fraction, Fraction], digits: int
) -> bool:
    """Whether the digits that are shown leave no doubt that one number is smaller."""
    up, n = round_decimal(smaller[1], digits, up=True)
    down, m = round_decimal(larger[0], digits, up=False)
    if n != m or up != down:
        return up * _power(max(n - m, 0)) < down * _power(max(m - n, 0))
    # 0.99… is below 1, and -0.99… above -1, but 1.00… may be 1
    shown = up * Fraction(10) ** n
    return shown != 0 and (smaller[1] < shown if up > 0 else shown < larger[0])


def _telling(low: Fraction, high: Fraction) -> int:
    """Digits that tell two ends apart, and two more."""
    return 3 + decimal_exponent(max(abs(low), abs(high))) - decimal_exponent(high - low)


def people(text: str, mark: str = "") -> str:
    """A decimal text as people write it: 5.9·10⁻⁵ for 5.9e-5; ``mark`` follows the digits."""
    digits, _, exponent = text.partition("e")
    if not exponent:
        return digits + mark
    power = f"10{exponent.translate(_SUPERSCRIPTS)}"
    if digits in ("1", "-1") and not mark:
        return digits.removesuffix("1") + power
    return f"{digits}{mark}·{power}"


def exact_number(value: Fraction, digits: int = 12) -> str:
    """A rational exactly: a decimal where that has few digits or is no longer, else a fraction."""
    fraction = str(value)
    mantissa, exponent = round_decimal(value, max(digits, len(fraction)), up=False)
    text = people(decimal_text(mantissa, exponent))
    if mantissa * Fraction(10) ** exponent != value:
        return fraction
    return text if len(str(abs(mantissa))) <= digits or len(text) <= len(fraction) else fraction


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
