"""How pages are set: sentences with minus signs, indices and powers of ten."""

from __future__ import annotations

import re
from functools import lru_cache
from html import escape

from verify.language.scripts import LOWERED, RAISED, Pieces, Scripted, pieces


class Marked(str):
    """Markup: what is set already, and is not escaped any more."""

    __slots__ = ()

    def __html__(self) -> str:  # this is how a template knows it
        return self


_POWER_OF_TEN = re.compile(
    r"(?<![\w.])(?:([0-9]+(?:\.[0-9]+)?)e(-?[0-9]+)(?!\w)"
    r"|(?:([0-9]+(?:\.[0-9]+)?)·)?10([⁻⁰¹²³⁴⁵⁶⁷⁸⁹]+))"
)
_RAISED = re.compile("[⁻⁰¹²³⁴⁵⁶⁷⁸⁹]+")
_MINUS = re.compile(
    r"(?<![^\s(\[{|·≤<=])-(?=[\w(|√])|(?<= )-(?= )|(?<=[0-9₀-₉)])-(?=[0-9]*√|[α-ωh][₀-₉_])"
)
_LOWERED = str.maketrans("⁻⁰¹²³⁴⁵⁶⁷⁸⁹", "-0123456789")


@lru_cache(1 << 12)  # the cells of a table repeat each other
def prose(text: str) -> str:
    """A sentence with its minus signs, subscripts, superscripts and powers of ten set as such."""
    return powers(_line(pieces(_MINUS.sub("−", text))))


def numbers(text: str) -> str:
    """The same of numbers, in which nothing else is small."""
    return powers(escape(_MINUS.sub("−", text), quote=False))


def _line(found: Pieces) -> str:
    return "".join(
        _scripted(piece) if isinstance(piece, Scripted) else escape(piece, quote=False)
        for piece in found
    )


def _scripted(piece: Scripted) -> str:
    """A letter with what is below and above it; digits are small signs of their own."""
    text = escape(piece.base) + ("\u0304" if piece.bar else "")
    for tag, content, small in (("sub", piece.lower, _BELOW), ("sup", piece.upper, _ABOVE)):
        inner = "".join(part for part in content if isinstance(part, str))
        if content == (inner,) and small.keys() >= {*inner}:
            text += "".join([small[sign] for sign in inner])
        elif content:
            text += f"<{tag}>{_line(content)}</{tag}>"
    return text


#: The small signs by what they are in line; a small n is none that is shown.
_BELOW, _ABOVE = (
    {sign: mark for mark, sign in small.items() if sign != "n"} | {"′": "′"}
    for small in (LOWERED, RAISED)
)


def powers(text: str) -> str:
    """Powers of ten with raised exponents, each with the decimal that machines read."""

    def power(match: re.Match[str]) -> str:
        digits = match[1] or match[3] or "1"
        exponent = match[2] or match[4].translate(_LOWERED)
        shown = f"{'' if digits == '1' else f'{digits}·'}10<sup>{exponent.replace('-', '−')}</sup>"
        return f'<data value="{digits}e{exponent}">{shown}</data>'

    return _POWER_OF_TEN.sub(power, text)


def unset(text: str) -> str:
    """Somebody's words as they are, but for powers of ten: an underscore is no subscript there."""
    return powers(escape(printable(text)))


def raised(text: str) -> str:
    """A number whose exponent is raised, inside of what is marked as one already."""
    text = escape(text).replace("-", "−")
    return _RAISED.sub(
        lambda match: f"<sup>{match[0].translate(_LOWERED).replace('-', '−')}</sup>", text
    )


def in_a_line(text: str) -> str:
    """A text without the line breaks and the indentation with which it is written."""
    if "  " not in text and text.isprintable():
        return text
    return re.sub("[ \n]+", " ", printable(text))


def printable(text: str) -> str:
    """A text in which control signs, and signs that nobody sees, are told by their numbers."""
    return text if text.isprintable() else "".join(map(_seen, text))


def _seen(sign: str) -> str:
    if sign.isprintable() or sign in "\n\u00a0":
        return sign
    return " " if sign.isspace() else ascii(sign)[1:-1]
