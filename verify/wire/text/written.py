"""Terms and claims written as formulas, which `verify.wire.text.infix` reads as the same ones."""

from __future__ import annotations

import re
from collections.abc import Callable, Mapping
from fractions import Fraction

from verify.language.fold import fold
from verify.language.terms import FUNCTIONS, Claim, Term
from verify.wire.text.infix import CALLED, MANY, NUMBERS

#: A name that needs no quotation marks.
PLAIN = re.compile(r"(?:[A-Za-z]\w*:)*[A-Za-z]\w*(?:\.\w+)*", re.ASCII)
#: A decimal with so many digits behind its point is written as a fraction.
LONGEST_DECIMAL = 20
#: How tightly a text holds together, from a sum to what needs no parentheses.
_SUM, _PRODUCT, _FACTOR, _ATOM = range(4)


def _inside(part: tuple[str, int], level: int) -> str:
    text, own = part
    return text if own >= level else f"({text})"


def _number(value: Fraction) -> tuple[str, int]:
    text = _decimal(value)
    if "/" in text:
        return text, _PRODUCT
    return text, _ATOM if value >= 0 else _FACTOR


def _decimal(value: Fraction) -> str:
    """A number as a fraction; if that has many digits, as the decimal that it is."""
    for digits in range(2, LONGEST_DECIMAL) if value.denominator >= 100 else ():
        if 10**digits % value.denominator == 0:
            whole = str(abs(value) * 10**digits).zfill(digits + 1)
            return f"{'-' * (value < 0)}{whole[:-digits]}.{whole[-digits:]}"
    return str(value)


def _sum(sign: str, left: tuple[str, int], right: tuple[str, int]) -> tuple[str, int]:
    text = _inside(right, _PRODUCT)
    return f"{left[0]} {sign} {f'({text})' if text.startswith('-') else text}", _SUM


def _product(sign: str, left: tuple[str, int], right: tuple[str, int]) -> tuple[str, int]:
    first, second = _inside(left, _PRODUCT), _inside(right, _FACTOR)
    second = f"({second})" if second.startswith("-") else second
    if sign == "/" and all(re.fullmatch("-?[0-9.]+", text) for text in (first, second)):
        first = f"({first})"  # a quotient of numbers, and not one number
    return f"{first}{sign}{second}", _PRODUCT


def _negative(part: tuple[str, int]) -> tuple[str, int]:
    text = _inside(part, _FACTOR)
    return f"-({text})" if text[0] in "-0123456789" and "^" not in text else f"-{text}", _FACTOR


def _written_name(name: str) -> tuple[str, int]:
    taken = {*CALLED, *NUMBERS}
    return name if PLAIN.fullmatch(name) and name not in taken else f"`{name}`", _ATOM


def _call(op: str) -> Callable[..., tuple[str, int]]:
    def written(*parts: tuple[str, int]) -> tuple[str, int]:
        return f"{op}({', '.join(text for text, _ in parts)})" if parts else op, _ATOM

    return written


_TEXT: Mapping[str, Callable[..., tuple[str, int]]] = {
    **{op: _call(op) for op in (*FUNCTIONS, *MANY, "pi")},
    "root": lambda base, index: (f"root({base[0]}, {index})", _ATOM),
    "rational": _number,
    "symbol": _written_name,
    "add": lambda left, right: _sum("+", left, right),
    "sub": lambda left, right: _sum("-", left, right),
    "mul": lambda left, right: _product("*", left, right),
    "div": lambda left, right: _product("/", left, right),
    "neg": _negative,
    "pow": lambda base, exponent: (f"{_inside(base, _ATOM)}^{exponent}", _FACTOR),
}


def term_text(term: Term) -> str:
    """The text that `read_term` reads as this term."""
    return fold(term, _TEXT, {})[0]


def claim_text(claim: Claim) -> str:
    """The text that `read_claims` reads as this claim alone."""
    return f"{term_text(claim.lhs)} {claim.relation} {term_text(claim.rhs)}"
