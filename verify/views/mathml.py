"""Terms and claims as MathML, which browsers typeset themselves.

The letters of a symbol are given as the small part of LaTeX in which a `Constant` has them: Greek
names, one subscript and superscript, bars, an overline.
"""

from __future__ import annotations

import re
from collections.abc import Mapping
from fractions import Fraction
from html import escape

from verify.language.terms import Claim, Term
from verify.language.typeset import FUNCTION_NAMES, LONG, Lengths, level_of

_SUM, _PRODUCT, _NEGATION, _ATOM = range(4)
_LEVELS = {"add": _SUM, "sub": _SUM, "mul": _PRODUCT, "neg": _NEGATION}
_SIGNS = {"<": "&lt;", "<=": "≤", "=": "="}

_GREEK = {
    "alpha": "α", "beta": "β", "gamma": "γ", "Gamma": "Γ", "delta": "δ", "Delta": "Δ",
    "epsilon": "ε", "varepsilon": "ε", "zeta": "ζ", "eta": "η", "theta": "θ", "vartheta": "ϑ",
    "Theta": "Θ", "iota": "ι", "kappa": "κ", "lambda": "λ", "Lambda": "Λ", "mu": "μ", "nu": "ν",
    "xi": "ξ", "Xi": "Ξ", "pi": "π", "Pi": "Π", "rho": "ρ", "sigma": "σ", "Sigma": "Σ", "tau": "τ",
    "phi": "φ", "varphi": "φ", "Phi": "Φ", "chi": "χ", "psi": "ψ", "Psi": "Ψ", "omega": "ω",
    "Omega": "Ω", "ell": "ℓ",
}  # fmt: skip
#: A name that stands in place of a letter, as it is.
AS_IT_IS = re.compile(r"\\texttt\{([A-Za-z0-9_.:-]+)\}", re.ASCII)
_TOKEN = re.compile(r"\\[A-Za-z]+|[A-Za-z]{3,}|[A-Za-z]|[0-9]+|[_^{}|*+()/,'-]")


class MathML:
    """Writes terms with given letters.

    Args:
        letters: for each symbol its letter in LaTeX; others are read as ``alpha_0`` or ``x_0``.
    """

    def __init__(self, letters: Mapping[str, str]) -> None:
        self._letters, self._lengths = dict(letters), Lengths(letters)
        self._texts: dict[Term, str] = {}

    def claim(self, claim: Claim) -> str:
        """A claim as several formulas in a row, so that lines can break before each sign.

        Browsers do not break lines inside of a formula.
        """
        if self._lengths.is_long_claim(claim):
            return formula(f"<mtext>{LONG}</mtext>")
        left, right = self._summands(claim.lhs), self._summands(claim.rhs)
        right[0] = f'<mo form="infix">{_SIGNS[claim.relation]}</mo>{right[0]}'
        return "<wbr>".join(map(formula, (*left, *right)))

    def _summands(self, term: Term) -> list[str]:
        if term.op not in ("add", "sub"):
            return [self._term(term)]
        left, right = term.children
        sign = "+" if term.op == "add" else "−"
        last = self._after_sign(right, _PRODUCT)
        return [*self._summands(left), f'<mo form="infix">{sign}</mo>{last}']

    def entries(self, term: Term, before: str) -> str:
        """A min with each entry on a line of its own."""
        lines = (formula(self._term(entry)) for entry in term.children)
        entries = "".join(f'<span class="entry">{line}</span>' for line in lines)
        return f"{formula(f'<mo>{escape(before)}</mo><mi>min</mi>')} of{entries}"

    def term(self, term: Term, before: str = "") -> str:
        """A whole formula for a term, after a sign such as ≤."""
        return formula((f"<mo>{escape(before)}</mo>" if before else "") + self._term(term))

    def _term(self, term: Term) -> str:
        text = self._texts.get(term)
        if text is None:
            is_long = self._lengths.is_long(term)
            text = f"<mtext>{LONG}</mtext>" if is_long else f"<mrow>{self._write(term)}</mrow>"
            self._texts[term] = text
        return text

    def _write(self, term: Term) -> str:
        op = term.op
        if op == "symbol":
            return self._letter(term.name)
        if op == "rational":
            return _rational(term.value)
        if op == "div":
            return f"<mfrac>{self._term(term.children[0])}{self._term(term.children[1])}</mfrac>"
        if op in ("sqrt", "root"):
            return self._root(term)
        if op == "pow":
            base = self._inside(term.children[0], _ATOM, power=True)
            return f"<msup>{base}<mn>{term.exponent}</mn></msup>"
        if op == "neg":
            return f"<mo>−</mo>{self._after_sign(term.children[0], _PRODUCT)}"
        if op in ("add", "sub"):
            left, right = term.children
            sign = "+" if op == "add" else "−"
            return f"{self._inside(left, _SUM)}<mo>{sign}</mo>{self._after_sign(right, _PRODUCT)}"
        if op == "mul":
            return self._product(*term.children)
        return self._function(op, term)

    def _root(self, term: Term) -> str:
        below = self._term(term.children[0])
        if term.op == "sqrt":
            return f"<msqrt>{below}</msqrt>"
        return f"<mroot>{below}<mn>{term.exponent}</mn></mroot>"

    def _letter(self, name: str) -> str:
        """The letter of a symbol; where it is other LaTeX, that of its name, or the name."""
        return self._letter_and_level(name)[0]

    def _letter_and_level(self, name: str) -> tuple[str, int]:
        """The letter, and how tightly it holds together."""
        found = self._letters.get(name, "")
        if as_it_is := AS_IT_IS.fullmatch(found):
            return f"<mi>{escape(as_it_is[1])}</mi>", _ATOM
        for tex in (found, _spelled(name)):
            try:
                if tex:
                    return letter(tex), min(level_of(tex), _ATOM)
            except ValueError:
                continue
        return f"<mi>{escape(name)}</mi>", _ATOM

    def _product(self, left: Term, right: Term) -> str:
        # Two numbers side by side would read as one.
        sign = "⋅" if _starts_with_digit(right) else "&#x2062;"
        return f"{self._inside(left, _PRODUCT)}<mo>{sign}</mo>{self._after_sign(right, _NEGATION)}"

    def _function(self, op: str, term: Term) -> str:
        if op == "pi":
            return "<mi>π</mi>"
        arguments = "<mo>,</mo>".join(map(self._term, term.children))
        if op == "cos_pi":
            op, arguments = "cos", f"{self._inside(term.children[0], _PRODUCT)}<mi>π</mi>"
        name = FUNCTION_NAMES.get(op, op)
        return f"<mi>{name}</mi><mo>&#x2061;</mo>{_fenced(arguments)}"

    def _after_sign(self, term: Term, level: int) -> str:
        """The same after an operator, where a minus sign must not stand first."""
        text = self._term(term)
        if _starts_with_minus(term) or text.startswith("<mrow><mo>−</mo>"):
            return f"<mrow>{_fenced(text)}</mrow>"
        return self._inside(term, level)

    def _inside(self, term: Term, level: int, power: bool = False) -> str:
        own = _LEVELS.get(term.op, _ATOM)
        if term.op == "rational" and term.value < 0:
            own = _NEGATION
        if term.op == "symbol":
            own = self._letter_and_level(term.name)[1]
        if power and (
            term.op in ("div", "pow") or (term.op == "rational" and term.value.denominator > 1)
        ):
            own = _NEGATION
        text = self._term(term)
        if power and term.op == "symbol" and "<msup>" in text and "′" not in text:
            own = _NEGATION  # the power of a letter with an exponent is no higher exponent
        return text if own >= level else f"<mrow>{_fenced(text)}</mrow>"


def formula(inner: str) -> str:
    """A formula in a line of text."""
    return f"<math><mrow>{inner}</mrow></math>"


def in_braces(tex: str) -> str:
    """The letter with an exponent that parentheses hold together, as in r^(1/3), in braces."""
    return re.sub(r"\^\(([^()]*)\)", r"^{\1}", tex)


def letter(tex: str) -> str:
    r"""The MathML of a letter such as ``\varphi^-``, ``\overline{\eta}`` or ``|x_0|``.

    Raises:
        ValueError: for other LaTeX.
    """
    tex = in_braces(tex)
    tokens = _TOKEN.findall(tex)
    if "".join(tokens) != tex.replace(" ", ""):
        raise ValueError(f"{tex!r} is not a letter")
    inner, rest = _row(tokens)
    if rest:
        raise ValueError(f"{tex!r} closes a brace that is not open")
    return inner


def _row(tokens: list[str]) -> tuple[str, list[str]]:
    parts: list[str] = []
    while tokens and tokens[0] != "}":
        if tokens[0] in "_^":
            kind = "msub" if tokens[0] == "_" else "msup"
            script, tokens = _one(tokens[1:])
            base = parts.pop() if parts else "<mrow></mrow>"
            parts.append(f"<{kind}>{base}{script}</{kind}>")
        elif tokens[0] == "'":
            base, tokens = parts.pop() if parts else "<mrow></mrow>", tokens[1:]
            parts.append(f"<msup>{base}<mo>′</mo></msup>")
        else:
            part, tokens = _one(tokens)
            parts.append(part)
    return "".join(parts), tokens


#: Commands that take no argument, and how those that take one begin and end.
_SIGNS_OF_COMMANDS = {r"\cos": "<mi>cos</mi><mo>&#x2061;</mo>", r"\cdot": "<mo>⋅</mo>"}
_AROUND = {r"\overline": ("<mover>", "<mo>¯</mo></mover>"), r"\sqrt": ("<msqrt>", "</msqrt>")}


def _one(tokens: list[str]) -> tuple[str, list[str]]:
    if not tokens or tokens[0] in "}_^'":
        raise ValueError("a letter ends where something should follow")
    head, *rest = tokens
    if head == "{":
        inner, rest = _row(rest)
        if not rest:
            raise ValueError("a letter does not close its brace")
        return f"<mrow>{inner}</mrow>", rest[1:]
    if head in _AROUND:
        inner, rest = _one(rest)
        begin, end = _AROUND[head]
        return f"{begin}{inner}{end}", rest
    return _token(head), rest


def _token(text: str) -> str:
    if text.startswith("\\"):
        if text in _SIGNS_OF_COMMANDS:
            return _SIGNS_OF_COMMANDS[text]
        if text[1:] not in _GREEK:
            raise ValueError(f"{text!r} is not a letter")
        return f"<mi>{_GREEK[text[1:]]}</mi>"
    if text.isdigit():
        return f"<mn>{text}</mn>"
    if text.isalpha():
        return f"<mi>{text}</mi>"
    fence = ' stretchy="false"' if text in "|()" else ""
    return f"<mo{fence}>{text.replace('-', '−')}</mo>"


def _spelled(name: str) -> str:
    """``alpha_0``, ``W_s``, ``map.kappa`` or ``x.2.1`` as LaTeX; longer words stay upright."""
    if numbered := re.fullmatch(r"(?:.*[.:-])?([A-Za-z]+)((?:\.[0-9]+)+)", name):
        indices = numbered[2][1:].replace(".", ",")
        return f"{_spelled(numbered[1])}_{{{indices}}}"
    own = re.split(r"[.-]", name)[-1]
    parts = [f"\\{part}" if part in _GREEK else part for part in own.split("_")]
    head, *rest = parts
    return head if not rest else f"{head}_{{{''.join(rest)}}}"


def _rational(value: Fraction) -> str:
    sign = "<mo>−</mo>" if value < 0 else ""
    if value.denominator == 1:
        return f"{sign}<mn>{abs(value.numerator)}</mn>"
    top, bottom = abs(value.numerator), value.denominator
    return f"{sign}<mfrac><mn>{top}</mn><mn>{bottom}</mn></mfrac>"


def _starts_with_digit(term: Term) -> bool:
    if term.op in ("mul", "pow", "add", "sub"):
        return term.op in ("mul", "pow") and _starts_with_digit(term.children[0])
    return term.op == "rational" or (term.op == "div" and term.children[0].op == "rational")


def _starts_with_minus(term: Term) -> bool:
    if term.op == "mul":
        return _starts_with_minus(term.children[0])
    return term.op == "neg" or (term.op == "rational" and term.value < 0)


def _fenced(inner: str) -> str:
    return f"<mo>(</mo>{inner}<mo>)</mo>"
