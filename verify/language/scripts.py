"""Mathematics in a line of text, as data: a letter with its indices and powers is one thing.

A sentence has ``η_c²``, ``C_{s,n+1}``, ``10⁻⁵`` or ``ζ̄``; whoever writes it in another form writes
what is read here, and looks for no signs himself.
"""

from __future__ import annotations

import re

from verify.language.record import Record

#: Signs that are raised, or lowered, and what they are in line.
RAISED = dict(zip("⁰¹²³⁴⁵⁶⁷⁸⁹⁺⁻ⁿ", "0123456789+-n", strict=True))
LOWERED = dict(zip("₀₁₂₃₄₅₆₇₈₉₊₋ₙ", "0123456789+-n", strict=True))

_SMALL = "".join([*RAISED, *LOWERED])

_BAR = "\u0304"
_CLOSING = ")]|}"
_ENDS = {"{": "}", "(": ")"}
#: Names of rows and constants, in which an underscore stands for no index: ``eta_bar``,
#: ``C_eta-below-one``.
_NAME = re.compile(
    r"(?![a-z][A-Z]_)[A-Za-z]{2,}_[A-Za-z0-9_]+(-[A-Za-z0-9_]+)*|[A-Za-z]_\w+(-\w+)*-[A-Za-z]{3,}(-\w+)*",
    re.ASCII,
)
#: Words in which nothing is, or begins, an index, a power, a prime or a bar, with the blanks after.
_PLAIN = re.compile(rf"(?:[^\s_^'′{_BAR}{_SMALL}]*+(?:\s+|\Z))+")
_IS_SMALL = re.compile(f"[_^'′{_SMALL}]")
_WORD = re.compile(r"[a-z](?=[A-Z]_)|[A-Za-z]+|[0-9]+|.", re.ASCII | re.DOTALL)
#: An index without braces: a word, a number, one letter of another alphabet, or a sign.
_INDEX = re.compile(r"[A-Za-z]+|[0-9]+|[^\W\d_]|[⁺⁻±∞]")


class Scripted(Record):
    """A letter, a number or a closing sign, with a bar, what is below it and what is above."""

    base: str
    bar: bool
    lower: tuple[str | Scripted, ...]
    upper: tuple[str | Scripted, ...]


Pieces = tuple["str | Scripted", ...]


def pieces(text: str) -> Pieces:
    """The text in order: what is plain, and letters with what belongs to them."""
    found: list[str | Scripted] = []
    at = 0
    while at < len(text):
        plain = _PLAIN.match(text, at)
        piece, at = (plain[0], plain.end()) if plain else _piece(text, at)
        if isinstance(piece, str) and found and isinstance(found[-1], str):
            found[-1] += piece
        else:
            found.append(piece)
    return tuple(found)


def _piece(text: str, at: int) -> tuple[str | Scripted, int]:
    name = _NAME.match(text, at)
    if name:
        return name[0], name.end()
    word = _WORD.match(text, at)
    base = word[0] if word else text[at]
    if len(base) > 1 and text[at + len(base) :].startswith(_BAR):
        base = base[:-1]  # the bar is over the last letter alone
    if not (base.isalnum() or base in _CLOSING) or base in RAISED or base in LOWERED:
        return base, at + len(base)
    end = at + len(base)
    bar = text[end : end + 1] == _BAR
    lower, upper, after = _scripts(text, end + bar, base)
    if not (bar or lower or upper):
        return base, end
    return Scripted(base, bar, lower, upper), after


def _scripts(text: str, at: int, base: str) -> tuple[Pieces, Pieces, int]:
    """What is below and above the sign that ends here, each at most once, and where it ends."""
    found: dict[str, Pieces] = {}
    is_letter, prime = len(base) == 1 and base.isalpha(), ""
    while _IS_SMALL.match(text, at):
        place, content, end = _script(text, at)
        if is_letter and not prime and "^" not in found and text[at] in "'′":
            prime, at = "′", at + 1
            continue
        if not place or place in found or (base.isdigit() and text[at] == "_"):
            break
        found[place], at = content, end
    above: Pieces = found.get("^", ())
    return found.get("_", ()), (prime, *above) if prime else above, at


def _script(text: str, at: int) -> tuple[str, Pieces, int]:
    """An index or a power that begins here: its place, what it is, and where it ends."""
    for place, table in (("^", RAISED), ("_", LOWERED)):
        end = at
        while text[end : end + 1] in table:
            end += 1
        if end > at:
            return place, ("".join(table[sign] for sign in text[at:end]),), end
    if text[at] not in "_^":
        return "", (), at
    if text[at + 1 : at + 2] in _ENDS:
        end = _closing(text, at + 1)
        if end:
            return text[at], pieces(text[at + 2 : end - 1]), end
    index = _INDEX.match(text, at + 1)
    return (text[at], pieces(_in_line(index[0])), index.end()) if index else ("", (), at)


def _in_line(index: str) -> str:
    return RAISED.get(index, index)


def _closing(text: str, at: int) -> int:
    """Where what opens here is closed again; 0 if it is not."""
    opening, depth = text[at], 0
    for end in range(at, len(text)):
        depth += (text[end] == opening) - (text[end] == _ENDS[opening])
        if depth == 0:
            return end + 1
    return 0
