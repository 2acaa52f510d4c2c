"""Terms and claims as people write them: plain text in the paper's letters, or LaTeX."""

from __future__ import annotations

from collections.abc import Mapping
from fractions import Fraction

from verify.language.statement import Always, Applies
from verify.language.terms import Claim, Term

_SUM, _PRODUCT, _NEGATION, _POWER, _ATOM = range(5)
_LEVELS = {
    "add": _SUM,
    "sub": _SUM,
    "mul": _PRODUCT,
    "div": _PRODUCT,
    "neg": _NEGATION,
    "pow": _POWER,
}
_SUPERSCRIPTS = str.maketrans("0123456789", "⁰¹²³⁴⁵⁶⁷⁸⁹")
_BINARY = ("add", "sub", "mul", "div")


class Typesetter:
    """Writes terms with given letters.

    Args:
        letters: what to write for each symbol.
        latex: LaTeX source instead of plain text.
    """

    def __init__(self, letters: Mapping[str, str], latex: bool = False) -> None:
        self._letters = letters
        self._latex = latex
        self._texts: dict[Term, str] = {}

    def claim(self, claim: Claim | Applies | Always) -> str:
        """``lhs < rhs``, ``lhs ≤ rhs`` or ``lhs = rhs``; or the values put into a context."""
        if isinstance(claim, Applies):
            return f"{claim.context} at {self._values(claim.at)}"
        if isinstance(claim, Always):
            first, then = self._values(claim.start), self._values(claim.next)
            return f"{claim.context} always, from {first}, then {then}"
        relation = claim.relation
        if relation == "<=":
            relation = r"\le" if self._latex else "≤"
        return f"{self.term(claim.lhs)} {relation} {self.term(claim.rhs)}"

    def _values(self, values: Mapping[str, Term]) -> str:
        named = sorted(values.items())  # a table in a file has no other order
        pairs = ((self._letters.get(name, name), self.term(term)) for name, term in named)
        return ", ".join(f"{letter} = {text}" for letter, text in pairs)

    def term(self, term: Term) -> str:
        """The term, with as few parentheses as its reading needs."""
        text = self._texts.get(term)
        if text is None:
            text = self._texts[term] = self._write(term)
        return text

    def _write(self, term: Term) -> str:
        op = term.op
        if op in _BINARY:
            return self._binary(op, *term.children)
        if op == "symbol":
            return self._letters.get(term.name, term.name)
        if op == "rational":
            return self._rational(term.value)
        if op == "neg":
            return f"-{self._inside(term.children[0], _PRODUCT)}"
        if op == "pow":
            return self._power(self._inside(term.children[0], _ATOM), term.exponent)
        if op == "sqrt":
            return self._root(term.children[0])
        return self._function(op, term)

    def _binary(self, op: str, left: Term, right: Term) -> str:
        if op == "add":
            return f"{self._inside(left, _SUM)} + {self._inside(right, _PRODUCT)}"
        if op == "sub":
            return f"{self._inside(left, _SUM)} - {self._inside(right, _PRODUCT)}"
        if op == "div" and self._latex:
            return rf"\frac{{{self.term(left)}}}{{{self.term(right)}}}"
        sign = "/" if op == "div" else (r" \cdot " if self._latex else "·")
        level = _POWER if op == "div" else _NEGATION
        return f"{self._inside(left, _PRODUCT)}{sign}{self._inside(right, level)}"

    def _inside(self, term: Term, level: int) -> str:
        text = self.term(term)
        own = _LEVELS.get(term.op, _ATOM)
        if term.op == "rational" and (term.value < 0 or term.value.denominator > 1):
            own = _NEGATION if term.value < 0 else _PRODUCT
        if self._latex and term.op == "div":
            own = _NEGATION
        if own >= level:
            return text
        return rf"\left({text}\right)" if self._latex else f"({text})"

    def _rational(self, value: Fraction) -> str:
        if self._latex and value.denominator > 1:
            sign = "-" if value < 0 else ""
            return rf"{sign}\frac{{{abs(value.numerator)}}}{{{value.denominator}}}"
        return str(value)

    def _root(self, term: Term) -> str:
        if self._latex:
            return rf"\sqrt{{{self.term(term)}}}"
        return f"√{self._inside(term, _ATOM)}"

    def _function(self, op: str, term: Term) -> str:
        if op == "cos_pi":
            pi = r" \pi" if self._latex else "π"
            name, arguments = "cos", self._inside(term.children[0], _ATOM) + pi
        else:
            name, arguments = op, ", ".join(map(self.term, term.children))
        if self._latex:
            return rf"\{name}\left({arguments}\right)"
        return f"{name}({arguments})"

    def _power(self, base: str, exponent: int) -> str:
        if self._latex:
            return f"{{{base}}}^{{{exponent}}}"
        return base + str(exponent).translate(_SUPERSCRIPTS)
