"""What has another meaning does not look the same, and a formula in letters says what it means."""

from __future__ import annotations

import re
from pathlib import Path

import pytest

from verify.cli import main
from verify.language.terms import Claim, Term, as_term, exp, symbol
from verify.language.typeset import Typesetter, level_of
from verify.views.mathml import MathML
from verify.views.tex.formulas import Formulas

PAGE = """title = "t"
[constants]
"one.b" = "1"
"two.b" = "2"
a = "7"
b = "3"
"a-b" = "5"
alpha1 = "1"
alpha_1 = "2"
pi = "3"
[contexts.c]
variables = { x = { letter = "x" }, y = { letter = "x" }, z = { letter = "α₁" } }
given = ["0 <= x <= 1", "2 <= y <= 3", "z = 5"]
[rows]
r1 = "one.b < two.b"
r2 = "x < y"
r3 = "`a-b` < a + b"
r4 = "alpha1 < alpha_1"
r5 = "alpha_1 < z"
r6 = { claim = "y < x", role = "printed" }
r7 = "pi < 3.1"
"""
X, Y = symbol("x"), symbol("y")


def test_two_that_have_one_letter_are_shown_by_their_names(
    tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    (tmp_path / "p.toml").write_text(PAGE)
    assert main(["prove", str(tmp_path / "p.toml"), "--out", str(tmp_path / "p")]) == 0
    text = capsys.readouterr().out
    claims = ["one.b < two.b", "x < y", "a-b < a + b", "alpha1 < alpha_1", "alpha_1 < z"]
    for claim in [*claims, "y < x", "pi < 31/10", "false at x = 0, y = 2, z = 5"]:
        assert f"  {claim}  " in text.replace("\n", "  ") or claim in text
    assert main(["check", "--markdown", str(tmp_path / "p")]) == 0
    report = capsys.readouterr().out
    assert all(f"| {claim} " in report for claim in claims)
    assert "Variables: x, y, z." in report
    assert "| one.b | 1 |" in report
    assert main(["check", "--latex", str(tmp_path / "p")]) == 0
    tex = capsys.readouterr().out
    assert r"\texttt{one.b} < \texttt{two.b}" in tex
    assert r"\texttt{a-b} < a + b" in tex  # no difference
    assert r"\texttt{alpha\_1} < \texttt{z}" in tex
    assert r"\pi" not in tex


@pytest.mark.parametrize(
    ("letter", "tex", "term", "plain", "latex", "html"),
    [
        ("1+d", "1+d", 1 / X, "1/(1+d)", r"\frac{1}{1+d}", "11+d"),
        ("1+d", "1+d", X * Y, "(1+d)·y", r"(1+d)\, y", "(1+d)y"),
        ("-η", r"-\eta", X**2, "(-η)²", r"(-\eta)^{2}", "(−η)2"),
        ("-η", r"-\eta", Y * X, "y·-η", r"y\, -\eta", "y(−η)"),
        ("cos θ", r"\cos \theta", X * Y, "(cos θ)·y", r"(\cos \theta)\, y", "(cosθ)y"),
        ("u·v", r"u\cdot v", X**2, "(u·v)²", r"(u\cdot v)^{2}", "(u⋅v)2"),
        ("u·v", r"u\cdot v", Y / X, "y/(u·v)", r"\frac{y}{u\cdot v}", "yu⋅v"),
        ("|v|²", "|v|^2", X**2, "(|v|²)²", "(|v|^2)^{2}", "(|v|2)2"),
        ("x_1", "x_1", X**2, "x_1²", "{x_1}^{2}", "x12"),
        ("T*", "T^*", Y / X, "y/T*", r"\frac{y}{T^*}", "yT*"),
    ],
)
def test_a_letter_is_held_together_as_what_it_looks_like(
    letter: str, tex: str, term: Term, plain: str, latex: str, html: str
) -> None:
    assert Typesetter({"x": letter}).term(term) == plain
    assert Formulas({"x": tex, "y": "y"}, {"x": letter}).term(term) == latex
    found = re.sub(r"<[^>]*>|&#x206[12];", "", MathML({"x": tex, "y": "y"}).term(term))
    assert found == html


def test_levels_of_letters() -> None:
    loose = ("1+d'", "-η", "cos θ", "a-b", "η/(1+d)", "Λⁿη₀", "2v", r"\tau|W|^2/(1+d')")
    tight = ("η", "(1+d')", "|η_c|", "Q_{n+1}", "T*", "(-η)₀", "x_row", r"\overline{\eta}")
    assert all(level_of(one) < level_of("x") for one in loose)
    assert all(level_of(one) == level_of("x") for one in tight)
    assert level_of("(" * 10**6 + ")" * 10**6) < level_of("x")  # at once


def test_a_name_that_is_e_is_no_exponential() -> None:
    formulas = Formulas({"e": "e"}, {})
    assert formulas.claim(Claim("<", symbol("e") ** 2, exp(as_term(2)))) == r"{e}^{2} < \exp(2)"
