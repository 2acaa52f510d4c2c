"""Terms and claims as LaTeX that breaks into lines.

Lines break before relations and operators outside of braces: so parentheses have no braces, and
only what is short is a fraction with a bar or stands below a root.
"""

from __future__ import annotations

import re
from collections.abc import Mapping
from fractions import Fraction

from verify.language.simplify import simplified, simplified_claim
from verify.language.terms import FUNCTIONS, Claim, Term
from verify.language.typeset import FUNCTION_NAMES, LONG, Lengths, Typesetter, level_of
from verify.views.mathml import AS_IT_IS, in_braces
from verify.views.mathml import letter as read_letter
from verify.views.tex.sentences import math

#: A fraction whose sides have at most so many signs has a bar; a root of so many has one too.
LONGEST = 30

_SUM, _PRODUCT, _NEGATION, _ATOM = range(4)
_LONG = rf"\text{{{LONG}}}"
_RELATIONS = {"<": "<", "<=": r"\le", "=": "="}


class Formulas:
    """Writes terms with given letters.

    Args:
        letters: for each symbol its letter in LaTeX (see `safe_letter`).
        plain: for each symbol its letter in plain text.
    """

    def __init__(self, letters: Mapping[str, str], plain: Mapping[str, str]) -> None:
        self._letters, self._plain = letters, Typesetter(plain)
        self._lengths = Lengths(letters)
        self._texts: dict[Term, str] = {}

    def claim(self, claim: Claim) -> str:
        """Two sides and their relation."""
        if self._lengths.is_long_claim(claim):
            return _LONG
        claim = simplified_claim(claim)
        sides = map(with_tall_parentheses, (self._term(claim.lhs), self._term(claim.rhs)))
        return f" {_RELATIONS[claim.relation]} ".join(sides)

    def term(self, term: Term) -> str:
        """A term, simplified, unless it is very long."""
        if self._lengths.is_long(term):
            return _LONG
        return with_tall_parentheses(self._term(simplified(term)))

    def symbol(self, name: str) -> str:
        """The letter of a symbol."""
        return self._letters.get(name) or safe_letter("", name)

    def values(self, values: Mapping[str, Term]) -> str:
        """Values for some names, one after the other."""
        pairs = (f"{self.symbol(name)} = {self.term(term)}" for name, term in values.items())
        return r",\allowbreak\ ".join(pairs)

    def _term(self, term: Term) -> str:
        text = self._texts.get(term)
        if text is None:
            text = self._texts[term] = self._write(term)
        return text

    def _write(self, term: Term) -> str:
        op, parts = term.op, term.children
        if op == "symbol":
            return self.symbol(term.name)
        if op == "rational":
            return tex_rational(term.value)
        if op in ("add", "sub"):
            sign = "+" if op == "add" else "-"
            return f"{self._term(parts[0])} {sign} {self._inside(parts[1], _PRODUCT)}"
        if op == "mul":
            left, right = self._inside(parts[0], _PRODUCT), self._inside(parts[1], _NEGATION)
            return rf"{left} \cdot {right}" if _digit_first(parts[1]) else rf"{left}\, {right}"
        if op == "div":
            return self._quotient(*parts)
        if op == "neg":
            return f"-{self._inside(parts[0], _PRODUCT)}"
        if op == "pow":
            return f"{self._base(parts[0])}^{{{term.exponent}}}"
        if op == "root":
            return rf"\sqrt[{term.exponent}]{{{self._term(parts[0])}}}"
        if op == "pi":
            return r"\pi "
        return self._function(op, parts)

    def _quotient(self, above: Term, below: Term) -> str:
        if self._short(above) and self._short(below):
            return rf"\frac{{{self._term(above)}}}{{{self._term(below)}}}"
        return f"{self._inside(above, _PRODUCT)} / {self._inside(below, _ATOM)}"

    def _base(self, term: Term) -> str:
        text = self._term(term)
        if term.op in ("min", "max", "div", "pow", "root", *FUNCTIONS):
            return f"({text})"
        if term.op == "rational":
            return text if text.isdigit() else f"({text})"
        if term.op == "symbol":  # the power of r^{1/3} is no higher exponent
            return f"({text})" if "^" in text or level_of(text) < _ATOM else f"{{{text}}}"
        return self._inside(term, _ATOM)

    def _function(self, op: str, parts: tuple[Term, ...]) -> str:
        if op == "sqrt":
            if self._short(parts[0]):
                return rf"\sqrt{{{self._term(parts[0])}}}"
            return f"({self._term(parts[0])})^{{1/2}}"
        if op == "exp" and self._short(parts[0]) and "e" not in self._letters.values():
            return f"e^{{{self._term(parts[0])}}}"
        if op == "cos_pi":
            return rf"\cos({self._inside(parts[0], _PRODUCT)}\, \pi)"
        return (
            rf"\{FUNCTION_NAMES.get(op, op)}("
            + r",\allowbreak\ ".join(map(self._term, parts))
            + ")"
        )

    def _short(self, term: Term) -> bool:
        return not self._plain.lengths.is_long(term) and len(self._plain.term(term)) <= LONGEST

    def _inside(self, term: Term, level: int) -> str:
        text = self._term(term)
        return text if self._level(term) >= level else f"({text})"

    def _level(self, term: Term) -> int:
        if term.op in ("add", "sub"):
            return _SUM
        if term.op == "neg" or (term.op == "rational" and term.value < 0):
            return _SUM
        if term.op == "div":
            barred = all(map(self._short, term.children))
            return _NEGATION if barred else _PRODUCT
        if term.op == "symbol":
            return min(level_of(self.symbol(term.name)), _ATOM)
        return _PRODUCT if term.op == "mul" else _ATOM


def with_tall_parentheses(tex: str) -> str:
    """The formula, with parentheses that are as tall as the fractions between them."""
    signs, depth = re.findall(r"\\[A-Za-z]+|\\.|.", tex), 0
    opened: list[int] = []
    for place, sign in enumerate(signs):
        depth += (sign == "{") - (sign == "}")
        if depth:
            continue
        if sign == "(":
            opened.append(place)
        elif sign == ")" and opened:
            if signs[opened[-1]] == r"\Bigl(":
                signs[place] = r"\Bigr)"
            opened.pop()
        elif sign == r"\frac":
            for begin in opened:
                signs[begin] = r"\Bigl("
    return "".join(signs)


def tex_rational(value: Fraction) -> str:
    """A fraction, or the decimal that it is where a fraction would be long."""
    sign = "-" if value < 0 else ""
    above, below = str(abs(value.numerator)), str(value.denominator)
    if below == "1":
        return sign + grouped(above)
    if max(len(above), len(below)) > 6:
        return f"{sign}{grouped(above)}/{grouped(below)}"
    return rf"{sign}\frac{{{above}}}{{{below}}}"


def grouped(digits: str) -> str:
    """Many digits, in groups between which a line may break."""
    if len(digits) <= 15:
        return digits
    groups = [digits[i : i + 10] for i in range(0, len(digits), 10)]
    return r"\allowbreak ".join(groups)


def safe_letter(tex: str, plain: str) -> str:
    """The LaTeX of a letter where it is one, else its plain text: files have what they like."""
    if AS_IT_IS.fullmatch(tex):
        return tex.replace("_", r"\_")
    try:
        if not tex:
            raise ValueError("no letter")
        read_letter(tex)
    except ValueError:
        return rf"\mathit{{{math(plain)}}}"
    tex = re.sub(
        r"_([A-Za-z]{2,})_\{([^{}]*)\}", r"_{\\mathrm{\1},\2}", in_braces(tex)
    )  # m_outer_5
    tex = re.sub(r"^([A-Za-z]_\w)(?=_)", r"{\1}", tex.replace("_{}", ""))
    if re.search(r"_(\w|\{[^{}]*\})_", tex):  # LaTeX refuses an index after an index
        return rf"\mathit{{{math(plain)}}}"
    return tex


def _digit_first(term: Term) -> bool:
    """Whether a number stands first, which would run into the one before it."""
    while term.op in ("mul", "pow"):
        term = term.children[0]
    return term.op in ("rational", "div")
