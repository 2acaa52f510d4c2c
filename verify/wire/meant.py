"""What was probably meant by a text that is no number: for messages, and nothing else."""

from __future__ import annotations

import re
from fractions import Fraction

from verify.prover.decimals import decimal_text, round_decimal

_THOUSANDS = {"k": 10**3, "thousand": 10**3, "m": 10**6, "million": 10**6}
#: What people type for a point, and for a minus sign.
_TYPED = str.maketrans({",": ".", "−": "-", "–": "-", "\N{ZERO WIDTH NO-BREAK SPACE}": None})


def hundredth(percent: str) -> str:
    """The number that is so many percent, for a decimal with a few digits."""
    return decimal_text(*round_decimal(Fraction(percent) / 100, 40, up=False))


def in_seconds(text: str) -> str:
    """The seconds that 5s, 2min or 0:30 are; nothing for another text."""
    timed = re.fullmatch(r"([0-9]{1,6}(?:\.[0-9]{1,6})?) ?(s|m(?!s)|h)[a-z]*", text)
    if timed:
        seconds = Fraction(timed[1]) * {"s": 1, "m": 60, "h": 3600}[timed[2]]
        return f"{float(seconds):g}"
    minutes = re.fullmatch(r"([0-9]{1,6}):([0-5][0-9])", text)
    return str(60 * int(minutes[1]) + int(minutes[2])) if minutes else ""


#: A number of a few digits.
_FEW = r"[+-]?(?:[0-9]{1,9}(?:\.[0-9]{0,40})?|\.[0-9]{1,40})"
#: Digits in groups, and what may stand behind them.
_GROUPED = re.compile(
    r"(-?[1-9][0-9]{0,2})((?:([,.'’_  ])[0-9]{3})(?:\3[0-9]{3})*)(?:[.,]([0-9]+))?"
)


def ungrouped(text: str) -> str:
    """What to write for a number whose digits stand in groups, as in 1,000; else nothing."""
    match = _GROUPED.fullmatch(text.strip())
    if match is None or (match[3] == "." and match[2].count(".") == 1 and match[4] is None):
        return ""
    whole = match[1] + re.sub("[^0-9]", "", match[2]) + (f".{match[4]}" if match[4] else "")
    if match[3] == "," and match[2].count(",") == 1 and match[4] is None:
        return f"{whole}, or {match[1]}.{match[2][1:]} if the comma is a decimal comma"
    return whole


def number(text: str) -> str:
    """The number that was probably meant, or how numbers are written."""
    plain = ungrouped(text)
    if plain:
        return plain
    mended = re.sub(
        r"^(?:[^\W\d]\w*)? ?[=:<>~≈≤≥]+ ?", "", text.translate(_TYPED).strip(" \t{}()\"'`")
    )
    percent = re.fullmatch(r"([0-9]{1,9}(?:\.[0-9]{1,9})?) ?%", mended)
    if percent:
        return hundredth(percent[1])
    part = re.fullmatch(r"([0-9]{1,9})/([1-9][0-9]{0,8}) ?%", mended)
    if part:
        return str(Fraction(int(part[1]), 100 * int(part[2])))
    ends = between(text)
    if ends:
        return f"{ends} where an interval may stand, or one number"
    found = re.match(rf"(?:{_FEW}/{_FEW}|{_FEW})(?:e[+-]?[0-9]{{1,3}})?(?![0-9.,/eE])", mended)
    is_one = found and re.fullmatch(r"[ *]?(?:[^\W\d_]|[°'\"µμ%]|/)*", mended[found.end() :])
    return found[0] if found and is_one else "it like 0.03, 3/100 or 3e-2"


def between(text: str) -> str:
    """The interval that is meant by two numbers with another sign between, or in brackets."""
    found = re.fullmatch(rf"[\[(\]]?({_FEW})(?:-|–|—|:|\.{{3,}}|…|,|;| to )({_FEW})[\])\[]?", text)
    is_decimal = found is not None and text == f"{found[1]},{found[2]}"
    return f"{found[1]}..{found[2]}" if found and not is_decimal else ""


def whole(text: str, least: int, most: int) -> str:
    """The whole number that is meant by 1e3, 1,000, 5s or 2.0; nothing if it is out of bounds."""
    number = re.match(r"([0-9]{1,9}(?:\.[0-9]{1,9})?)(?:[eE]\+?([0-9]))?", text.strip())
    if number is None:
        return ""
    power = re.fullmatch(r"([0-9]{1,3})(?:\^|\*\*)([0-9]{1,2})", text)
    value = Fraction(number[1]) * 10 ** int(number[2] or 0)
    rest = text.strip()[number.end() :].strip()
    if power:
        value = Fraction(int(power[1]) ** int(power[2]))
    elif ungrouped(text):
        value = Fraction(ungrouped(text).split(",")[0])
    elif rest.lower() in _THOUSANDS:
        value *= _THOUSANDS[rest.lower()]
    elif re.search(r"[0-9]", rest):
        return ""
    is_within = value.denominator == 1 and least <= value <= most
    return f"{value} (a whole number from {least} to {most})" if is_within else ""
