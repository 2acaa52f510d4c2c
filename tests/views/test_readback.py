"""What LaTeX and HTML say is read back by another way, and is what was to be said."""

from __future__ import annotations

import random
import re
from collections.abc import Iterator, Mapping
from fractions import Fraction
from functools import cache
from typing import Any

import pytest
from mpmath import mp, mpf

from tests.views.test_tex import committed, random_term
from verify.language.scripts import Scripted, pieces
from verify.language.terms import Claim, Term, as_term, minimum, names_of, sqrt, symbol
from verify.prover.outcome import Outcome
from verify.views.tex.formulas import Formulas
from verify.views.tex.sentences import _SIGNS, words
from verify.views.typesetting import prose

LETTERS = {tex: sign for sign, tex in _SIGNS.items() if tex.startswith("\\")} | {r"\prime": "′"}
TOKEN = re.compile(r"\\[A-Za-z]+ ?|\\.|\$|[{}_^]|.", re.DOTALL)


# --- sentences -----------------------------------------------------------------------------------


def sentences(outcome: Outcome) -> Iterator[str]:
    statement = outcome.statement
    yield statement.title
    yield from (assumption.sentence for assumption in statement.assumptions)
    yield from (context.says for context in statement.contexts)
    yield from (row.says for row in statement.obligations)


@cache
def committed_sentences() -> list[str]:
    return sorted({text for outcome in committed() for text in sentences(outcome)})


def in_line(text: str) -> str:
    """A sentence with a brace around each index and power, one below and one above a letter."""
    return "".join(part if isinstance(part, str) else in_braces(part) for part in pieces(text))


def in_braces(part: Scripted) -> str:
    text = part.base + ("\u0304" if part.bar else "")
    for sign, content in (("_", part.lower), ("^", part.upper)):
        if content:
            inner = "".join(p if isinstance(p, str) else in_braces(p) for p in content)
            text += f"{sign}{{{inner}}}"
    return text


def from_tex(tex: str) -> str:
    """The same, read from LaTeX: braces that hold an index or a power stay."""
    for sign, command in _SIGNS.items():
        tex = tex.replace(command, sign) if "{" in command else tex
    accents = re.sub(r"(\\[~^]|\\textbackslash)\{\}", r"\1", tex)  # over nothing
    tokens = TOKEN.findall(accents)[::-1]
    return "".join(group(tokens)).replace("-", "−")


def group(tokens: list[str], end: str = "") -> Iterator[str]:
    while tokens and tokens[-1] != end:
        token = tokens.pop()
        name = token.strip()
        if token in "$":
            continue
        if name in (r"\mathrm", r"\bar"):
            assert tokens.pop() == "{"
            inner = "".join(group(tokens, "}"))
            tokens.pop()
            yield inner + ("\u0304" if name == r"\bar" else "")
        elif token in "_^" and tokens[-1] == "{":
            tokens.pop()
            inner = "".join(group(tokens, "}"))
            tokens.pop()
            yield f"{token}{{{inner}}}"
        elif name in LETTERS:
            yield LETTERS[name]
        elif name == r"\textbackslash":
            yield "\\"
        else:
            assert not re.match(r"\\[A-Za-z]", token), token
            yield token.removeprefix("\\") if len(token) > 1 else token
    assert tokens or not end


def plain(text: str) -> str:
    """The letters that have two forms in one form."""
    for old, new in (("<=", "≤"), (">=", "≥"), ("⋅", "·"), ("-", "−"), ("∑", "Σ"), ("’", "'")):
        text = text.replace(old, new)
    return text


def test_every_committed_sentence_is_read_back() -> None:
    assert len(committed_sentences()) > 1000
    for text in committed_sentences():
        assert plain(from_tex(words(text))) == plain(in_line(text)), text


SQUARED = re.compile(r"([α-ωA-Za-z])_(?:\{([^{}]*)\}|([A-Za-z]))([²³])")


def test_a_power_after_an_index_is_of_the_letter() -> None:
    """η_c² is the square of η_c: no index is squared, in LaTeX and on the page."""
    found = 0
    for text in committed_sentences():
        for base, braced, word, power in SQUARED.findall(text):
            index, number = braced or word, {"²": "2", "³": "3"}[power]
            said = f"{base}_{{{index}}}^{{{number}}}"
            assert plain(said) in from_tex(words(text)), text
            assert f"{base}<sub>{index.replace('-', '−')}</sub>{power}" in prose(text).replace(
                "-", "−"
            )
            found += 1
    assert found > 20


@pytest.mark.parametrize(
    ("text", "said"),
    [
        ("η_c²", "η_{c}^{2}"),
        ("η_{c,n+1}²", "η_{c,n+1}^{2}"),
        ("V₁^{1/2}", "V_{1}^{1/2}"),
        ("C_η^n", "C_{η}^{n}"),
        ("C_ηη̄", "C_{η}η̄"),
        ("η_sτ", "η_{s}τ"),
        ("tW_s'", "tW_{s}^{′}"),
        ("ρ'²", "ρ^{′2}"),
        ("x^{n_1}", "x^{n_{1}}"),
        ("r^(1/3)(1+r)", "r^{1/3}(1+r)"),
        ("10⁻⁵", "10^{-5}"),
        ("'the φ⁻'", "'the φ^{-}'"),
        ("C_eta-below-one", "C_eta-below-one"),
        ("eta_bar, V_0", "eta_bar, V_{0}"),
        ("W_c-W_s", "W_{c}-W_{s}"),
        ("a_, _b, 2^, x^{y", "a_, _b, 2^, x^{y"),
    ],
)
def test_scripts(text: str, said: str) -> None:
    assert in_line(text) == said
    assert plain(from_tex(words(said))) == plain(said)


# --- terms ---------------------------------------------------------------------------------------

FORMULA = re.compile(
    r"\\allowbreak\\? ?|\\[A-Za-z]+ ?|\\.|[0-9]+|\{s[0-9]+\}|e(?=\^)|[{}()^/+,<=\[\]-]"
    r"|(?P<space>\s)|(?P<other>.)"
)


class Reader:
    """Reads LaTeX as people do: a bar or a brace holds together, then powers, products, sums."""

    def __init__(self, tex: str, values: Mapping[str, Any]) -> None:
        found = [m for m in FORMULA.finditer(tex) if not m["space"]]
        assert not [m[0] for m in found if m["other"]]
        words_ = [m[0].strip() for m in found]
        taller = (r"\Bigl", r"\Bigr", "\\")
        self.left = [w for w in words_ if not w.startswith(r"\allowbreak") and w not in taller][
            ::-1
        ]
        self.values = values

    def next(self, *wanted: str) -> str:
        return self.left.pop() if self.left and self.left[-1] in wanted else ""

    def need(self, wanted: str) -> None:
        assert self.next(wanted), (wanted, self.left[::-1])

    def sum(self) -> Any:
        total = -self.product() if self.next("-") else self.product()
        while sign := self.next("+", "-"):
            total = total + self.product() if sign == "+" else total - self.product()
        return total

    def product(self) -> Any:
        total = self.power()
        while sign := self.next(r"\,", r"\cdot", "/"):
            total = total / self.power() if sign == "/" else total * self.power()
        return total

    def power(self) -> Any:
        base = self.atom()
        if not self.next("^"):
            return base
        exponent = self.braced()
        if base == mp.e:
            return mp.exp(exponent)
        return mp.sqrt(base) if exponent == mpf(1) / 2 else base ** int(exponent)

    def braced(self) -> Any:
        self.need("{")
        value = self.sum()
        self.need("}")
        return value

    def index(self) -> int:
        """The index of a root, 2 if none is written."""
        if not self.next("["):
            return 2
        found = self.left.pop()
        self.need("]")
        return int(found)

    def atom(self) -> Any:
        token = self.left.pop()
        if token.isdigit():
            while self.left and self.left[-1].isdigit():
                token += self.left.pop()
            return mpf(token)
        if token == "(":
            value = self.sum()
            self.need(")")
            return value
        if token == "{":
            self.left.append(token)
            return self.braced()
        if token == r"\frac":
            return self.braced() / self.braced()
        if token == r"\sqrt":
            index = self.index()
            return mp.root(self.braced(), index)
        if token == "e":
            return mp.e
        if token == r"\mathit":
            return self.values[self.left.pop()]
        if token == r"\pi":
            return mp.pi
        return self.function(token)

    def function(self, name: str) -> Any:
        self.need("(")
        values = [self.sum()]
        while self.next(","):
            values.append(self.sum())
        self.need(")")
        known = {
            r"\cos": mp.cos,
            r"\sin": mp.sin,
            r"\exp": mp.exp,
            r"\log": mp.log,
            r"\arctan": mp.atan,
            r"\min": lambda *v: min(v, key=real),
            r"\max": largest,
        }
        return known[name](*values)


def real(value: Any) -> Any:
    return mp.re(value)


def largest(*values: Any) -> Any:
    return max(values, key=real)


def value_of(term: Term, at: Mapping[str, Any], known: dict[Term, Any]) -> Any:
    if term not in known:
        known[term] = _value_of(term, at, known)
    return known[term]


def _value_of(term: Term, at: Mapping[str, Any], known: dict[Term, Any]) -> Any:
    if term.op == "rational":
        return mpf(term.value.numerator) / term.value.denominator
    if term.op == "symbol":
        return at[term.name]
    parts = [value_of(child, at, known) for child in term.children]
    first, last = (parts[0], parts[-1]) if parts else (None, None)
    table = {
        "add": lambda: first + last,
        "sub": lambda: first - last,
        "mul": lambda: first * last,
        "div": lambda: first / last,
        "neg": lambda: -first,
        "pow": lambda: first**term.exponent,
        "sqrt": lambda: mp.sqrt(first),
        "root": lambda: mp.root(first, term.exponent),
        "exp": lambda: mp.exp(first),
        "log": lambda: mp.log(first),
        "sin": lambda: mp.sin(first),
        "atan": lambda: mp.atan(first),
        "pi": lambda: +mp.pi,
        "cos": lambda: mp.cos(first),
        "cos_pi": lambda: mp.cos(first * mp.pi),
        "min": lambda: min(parts, key=real),
        "max": lambda: largest(*parts),
    }
    return table[term.op]()


def assert_reads(claim: Claim, choose: random.Random) -> None:
    """The two sides of a claim in LaTeX have the values of the two terms."""
    names = sorted(set(names_of(claim.lhs, claim.rhs)))
    short = {name: f"{{s{i}}}" for i, name in enumerate(names)}
    values = {name: mpf(choose.randint(3, 40)) / choose.randint(7, 19) for name in names}
    writer = Formulas({name: rf"\mathit{text}" for name, text in short.items()}, {})
    tex = writer.claim(claim)
    relation = {"<": " < ", "<=": r" \le ", "=": " = "}[claim.relation]
    sides = tex.split(relation)
    assert len(sides) == 2, tex
    known: dict[Term, Any] = {}
    for term, side in zip((claim.lhs, claim.rhs), sides, strict=True):
        try:
            expected = value_of(term, values, known)
        except ZeroDivisionError:
            continue
        reader = Reader(side, {short[name]: values[name] for name in names})
        found = reader.sum()
        assert reader.left == []
        assert abs(found - expected) <= mpf(10) ** -40 * (1 + abs(expected)), side


def test_every_committed_claim_is_read_back() -> None:
    choose, found = random.Random(3), 0
    with mp.workdps(120):
        for outcome in committed():
            for row in outcome.statement.obligations[:: 1 if len(outcome.rows) < 250 else 4]:
                if isinstance(row.claim, Claim):
                    assert_reads(row.claim, choose)
                    found += 1
    assert found > 1000


def test_random_claims_are_read_back() -> None:
    choose = random.Random(9)
    x = symbol("x")
    long = as_term(Fraction(12345678, 9876543211))
    with mp.workdps(120):
        for term in (x / long, x / (long * x), (x / long) ** 2, -long / x, sqrt(x) / (x / long)):
            assert_reads(term < long - minimum(x, -x), choose)
        for _ in range(1500):
            claim = random_term(choose, 5) < sqrt(random_term(choose, 4) ** 2)
            assert_reads(claim, choose)


def test_a_wrong_formula_is_seen(monkeypatch: pytest.MonkeyPatch) -> None:
    x, y = symbol("x"), symbol("y")
    choose = random.Random(1)
    monkeypatch.setattr(Formulas, "_inside", lambda self, term, _: self._term(term))
    with mp.workdps(120), pytest.raises(AssertionError):
        assert_reads(x * (x + y) < x, choose)
