"""What to write in a formula for what is written otherwise in mathematics and in programs."""

from __future__ import annotations

import re
import unicodedata
from collections.abc import Collection, Mapping, Sequence
from fractions import Fraction

from verify.language.terms import FUNCTIONS as OF_ONE
from verify.wire.inputs import shown
from verify.wire.meant import ungrouped
from verify.wire.text.letters import FUNCTIONS as SHORT

#: By what an unread part of a text begins with.
_SIGNS: Mapping[str, str] = {
    r"[\\\\{}$]": "TeX is not read, write for example (a/b)*sqrt(x) <= alpha",
    "! *[a-z(]": "write !=",
    "!": "write prod(k, k, 1, 5) for 5!",
    "[⁺⁻]": "write x^-2 for x⁻²",
    r"_\d": "write a number without signs between its digits, such as 1000",
    r"['’]\d": "a formula has no quotes in it",
    "['′]": "a name has no prime; write for example x_next",
    "_": "a name begins with a letter",
    "; *.": 'write a list of claims, ["x^2 <= 2", "x > 0"]',
    ";": "leave it out; each claim is a text of its own",
    "[≪≫]": "write a bound, such as x < y/100",
    "∞": "leave a bound out that is infinite",
    "∈": "write 0 <= x <= 1 for x in [0, 1]",
    "&|∧": "write and",
    "∨": "write or",
    "¬": "write the opposite claim, such as x > 1 for not x <= 1",
    "[→⇒⟹⟶⇔↔]": "there is no implication; write what is given under contexts",
    "%": "write 1/2 for 50%; there are no remainders",
    "°": "angles are in radians; write a*pi/180",
    "∛": "write root(x, 3)",
    "∜": "write root(x, 4)",
    "÷": "write /",
    "[∙•]": "write *",
    "[–—]": "write -",
    "±": "write a claim with + and one with -",
    "[≈~≃∼]": "write two bounds, such as 3.1 < x < 3.2",
    ":=": "write =",
    ":": "write a claim; what it is about stands under contexts",
    "#": "a comment stands outside the quotes",
    '["“”„]': "a formula has no quotes in it",
    "[‖⟨]": "write sqrt(v*v) for the length of a vector v",
    "[∑Σ]": "write sum(1/k^2, k, 1, 10)",
    "[∏Π]": "write prod(k, k, 1, 10)",
}

#: Words of logic and of programs that are not read.
WORDS: Mapping[str, str] = {
    "not": "write the opposite claim, such as x > 1 for not x <= 1",
    "if": "write what is given under contexts",
    "then": "write what is given under contexts",
    "implies": "write what is given under contexts",
    "iff": "write two claims, each in a context of its own",
    "where": "write what is given under contexts",
    "forall": "write its variables under contexts",
    "for": "write its variables under contexts",
    "in": "write 0 <= x <= 1 for x in [0, 1]",
    "mod": "there are no remainders",
    "is": "write =, <= or >=",
    **dict.fromkeys(("exists", "some"), "a claim is for all values; write a row at one of them"),
    **dict.fromkeys(
        ("integer", "integers", "natural", "whole"),
        "variables are real numbers; write what you use of it, such as n >= 1",
    ),
    **dict.fromkeys(("all", "every", "any", "each"), "write its variables under contexts"),
    "and": "it stands between two claims",
    "or": "it stands between two claims",
    **dict.fromkeys(
        ("inf", "infinity", "oo", "infty"),
        "leave a bound out that is infinite; a sum has finitely many terms",
    ),
}

#: Functions that have another name, or none.
FUNCTIONS: Mapping[str, str] = {
    **dict.fromkeys(("log10", "lg", "log_10"), "write log(x)/log(10)"),
    **dict.fromkeys(("log2", "log_2", "lb", "ld"), "write log(x)/log(2)"),
    "log1p": "write log(1 + x)",
    "expm1": "write exp(x) - 1",
    "tg": "write tan(x)",
    "arctg": "write arctan(x)",
    "atan2": "write atan(y/x)",
    **dict.fromkeys(("cot", "ctg", "cotan"), "write 1/tan(x)"),
    "sec": "write 1/cos(x)",
    **dict.fromkeys(("csc", "cosec"), "write 1/sin(x)"),
    "coth": "write 1/tanh(x)",
    **dict.fromkeys(("asinh", "arsinh", "arcsinh"), "write log(x + sqrt(x^2 + 1))"),
    **dict.fromkeys(("acosh", "arcosh", "arccosh"), "write log(x + sqrt(x^2 - 1))"),
    **dict.fromkeys(("atanh", "artanh", "arctanh"), "write log((1 + x)/(1 - x))/2"),
    **dict.fromkeys(("sgn", "sign"), "write a claim for x > 0 and one for x < 0"),
    **dict.fromkeys(("floor", "ceil", "round"), "write bounds, such as n <= x and x < n + 1"),
    "cbrt": "write root(x, 3)",
    "sqr": "write x^2, or sqrt(x)",
    **dict.fromkeys(("pow", "power"), "write x^y"),
    "fabs": "write abs(x)",
    "factorial": "write prod(k, k, 1, 5)",
    **dict.fromkeys(
        ("integral", "integrate", "lim", "limit", "limsup", "liminf", "sup"),
        "there are no limits and no integrals; name its value, with the bounds that are known",
    ),
    **dict.fromkeys(("derivative", "deriv", "grad"), "write diff(x^2, x)"),
    **dict.fromkeys(
        ("Gamma", "gamma", "lgamma", "zeta", "erf", "erfc", "besselj", "Li", "li"),
        "name the value that you need, with the bounds that are known",
    ),
    "not": WORDS["not"],
}


_RAISED = str.maketrans("⁰¹²³⁴⁵⁶⁷⁸⁹", "0123456789")


def of_unread(text: str, unread: str) -> str:
    """What is said of the end of a text, which begins with a sign that no formula has."""
    number = re.search(r"[0-9][0-9.,'’_ ]*$", text.rstrip()[: -len(unread)])
    digits = re.match(r"[0-9.,'’_ ]*", unread)
    whole = ungrouped(number[0] + digits[0]) if number and digits else ""
    what = f"write {whole}" if whole else _of_sign(unread)
    return f"cannot read {shown(unread[:12])}{what and f'; {what}'}"


def _of_sign(unread: str) -> str:
    for pattern, instead in _SIGNS.items():
        if re.match(pattern, unread):
            return instead
    value = unicodedata.numeric(unread[0], None)
    return "" if value is None else f"write {Fraction(value).limit_denominator(100)}"


def of_two(one: str, other: str) -> str:
    """What is said where a number, or what may be the rest of one, follows a number."""
    if one == "0" and re.fullmatch(r"[xbo][0-9a-fA-F]+", other):
        return f"0{other} is no number in decimal digits; write 8 or 0.5"
    if other in ("e", "E"):
        return f"no exponent follows {one}{other}; write {one}e-3, or {one}*e"
    if other[0] == ".":
        return f"{one}{other} is no number"
    whole = ungrouped(f"{one} {other}")
    if whole:
        return f"a number has no spaces in it; write {whole}"
    return f"no sign stands between {one} and {other}; write {one}*{other}"


def of_function(name: str, following: Sequence[tuple[str, str]]) -> str:
    """What is said of a function without parentheses, before these tokens."""
    kind, word = following[0]
    if kind == "raised" or word == "^":
        power = word.translate(_RAISED) if kind == "raised" else following[1][1]
        return f"{name} is a function; write {name}(...)^{power}"
    inside = word if kind in ("name", "number") else "..."
    return f"{name} is a function; write {name}({inside})"


_END = r"\s*([^,;\[\](){}]+?(?:\([^()]*\))?)\s*"
_IN = re.compile(rf"(.+?)\s*(?:\bin\b|∈)\s*([\[\](]){_END}[,;]{_END}([\[\])])")
_AMONG = re.compile(r"(.+?)\s*(?:\bin\b|∈)\s*\{([^{}]+)\}")
_ENDLESS = re.compile(r"[-+]?(?:inf|infinity|infty|oo|∞)")
_IMPLIES = re.compile(r"(?:if\b)?(.+?)(<==?>|<->|==?>|->|[⇔↔→⇒⟹⟶]|\b(?:implies|then|iff)\b)(.+)")
_SOME = re.compile(r"∃|\(?(?:exists|there (?:is|are|exists?))\b|.*\bfor some\b")
_RELATION = re.compile(r"[<>=≤≥≠]")
_IS = {"positive": "> 0", "negative": "< 0", "nonnegative": ">= 0", "non-negative": ">= 0"}
_ADJECTIVE = re.compile(rf"(.+?)\s+is\s+({'|'.join(map(re.escape, _IS))}|zero|nonzero)")
_NARROW = re.compile(r"\d,\d")
_CALL = re.compile(r"\b([A-Za-z]\w*)\(")


def of_whole(text: str) -> str:
    """What is said of a whole text that no reader of formulas understands; nothing if unknown."""
    text = text.strip()
    if _SOME.match(text):
        return WORDS["exists"]
    inside = _IN.fullmatch(text)
    if inside:
        return f"an interval is two bounds; write {_bounds(*inside.groups())}"
    among = _AMONG.fullmatch(text)
    if among:
        parts = [f"{among[1]} = {part.strip()}" for part in among[2].split(",")]
        return f"there are no sets; write {' or '.join(parts)}"
    said = _ADJECTIVE.fullmatch(text)
    if said:
        return f"write {said[1]} {_IS.get(said[2], '= 0' if said[2] == 'zero' else '!= 0')}"
    implied = _IMPLIES.fullmatch(text)
    if implied and all(_RELATION.search(side) for side in implied.group(1, 3)):
        given, claim = (side.strip() for side in implied.group(1, 3))
        if implied[2] in ("iff", "<=>", "<==>", "<->", "⇔", "↔"):
            return "there is no equivalence; write a claim for each direction, with a context each"
        return (
            f'there is no implication; write given = ["{given}"] in its context, and the claim '
            f'"{claim}"'
        )
    mended = _with_commas(text)
    return f"write {mended}" if mended != text else ""


def _bounds(name: str, opening: str, low: str, high: str, closing: str) -> str:
    """The bounds of what is in an interval."""
    below = "" if _ENDLESS.fullmatch(low) else f"{low} {'<=' if opening == '[' else '<'} "
    above = "" if _ENDLESS.fullmatch(high) else f" {'<=' if closing == ']' else '<'} {high}"
    return f"{below}{name}{above}" if below or above else "nothing: a variable is any number"


def _with_commas(text: str) -> str:
    """The text with commas between arguments, and with decimal points in them."""
    around: list[str] = []  # the function of each open parenthesis; none, or a bracket
    signs = list(text)
    for i, sign in enumerate(text):
        if sign == "(":
            around.append((re.findall(r"[A-Za-z]\w*$", text[:i]) or [""])[0])
        elif sign == "[":
            around.append(sign)
        elif sign in ")]":
            del around[-1:]
        elif sign == ";" and around and around[-1]:
            is_decimal = around[-1] in (*OF_ONE, *SHORT) and text[i + 1 : i + 2].isdigit()
            signs[i] = "." if is_decimal else ","
    mended = "".join(signs)
    if mended == text:
        return with_points(text, (*OF_ONE, *SHORT))
    return "".join(
        "." if sign == "," and _NARROW.match(text[max(0, i - 1) :]) else signs[i]
        for i, sign in enumerate(text)
    )


def with_points(text: str, of_one: Collection[str]) -> str:
    """The text with a point for each comma between arguments that is that of a decimal.

    So it is for a comma between digits where others in the same parentheses have a space behind
    them, and in a function ``of_one`` argument.
    """
    signs = list(text)
    for call in _CALL.finditer(text):
        depth, commas = 1, []
        for i in range(call.end(), len(text)):
            depth += (text[i] in "([") - (text[i] in ")]")
            if depth == 0:
                break
            if depth == 1 and text[i] == ",":
                commas.append(i)
        narrow = [i for i in commas if text[i - 1].isdigit() and text[i + 1 : i + 2].isdigit()]
        if call[1] in of_one or any(text[i + 1 : i + 2] == " " for i in commas):
            for i in narrow:
                signs[i] = "."
    return "".join(signs)


def of_missing(word: str, before: tuple[str, str]) -> str:
    """What to write where a relation follows a relation."""
    kind, sign = before
    if kind != "sign":
        return ""
    if word in ("<", ">") and sign == "=":
        return f"; write {word}=" + (", or what is given under contexts" if word == ">" else "")
    if word == ">" and sign == "<":
        return "; write !="
    return f"; write {sign}" if word == "=" and sign in ("<=", ">=") else ""


#: What stands in the place of a letter and is none: a range, a comparison, a number, a domain.
_NO_LETTER = re.compile(
    r"[][<>≤≥∈]|\.\.|^[-+0-9./\s]*$|^\(.*,.*\)$"
    "|^(real|rational|integer|natural|positive|negative|non-?negative|number|int|float)s?$|^[ℝℚℤℕ]",
    re.IGNORECASE,
)


def of_letter(letter: str, name: str) -> str:
    """What is said of what stands in the place of a variable's letter; nothing if it may be one."""
    if not _NO_LETTER.search(letter):
        return ""
    return (
        f"{shown(letter)} is no letter of {name}; what is known of a variable is given: "
        f'given = ["0 <= {name}"]'
    )
