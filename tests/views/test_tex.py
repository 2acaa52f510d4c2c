"""LaTeX of statements: it compiles, no line sticks out, and formulas keep their value."""

from __future__ import annotations

import random
import re
import shutil
import subprocess
from collections.abc import Callable
from fractions import Fraction
from functools import cache
from hashlib import sha256
from pathlib import Path

import pytest

from verify import ask, assume, for_all, lemma, prove
from verify.language.simplify import simplified
from verify.language.statement import PRINTED
from verify.language.terms import Term, as_term, sqrt, symbol
from verify.paper.commands.repaired_theorem import whole
from verify.paper.parameters import ALL_PARAMETERS as EVERYWHERE
from verify.paper.source import PAPER
from verify.prover.outcome import Outcome
from verify.views.all_parameters import latex
from verify.views.markdown import report
from verify.views.tex.article import END, PREAMBLE, part
from verify.views.tex.formulas import Formulas, safe_letter
from verify.views.tex.sentences import name, tex_number, words
from verify.wire.judge import read_judged
from verify.wire.read import read

CERTIFICATES = Path(__file__).resolve().parents[2] / "certificates"
TOLD = {EVERYWHERE: lambda: latex(whole())}
x, y = symbol("x"), symbol("y")


@cache
def committed(read: Callable[..., Outcome] = read) -> list[Outcome]:
    """Every committed certificate, read back; as it is, nothing says that it was checked."""
    found = sorted(CERTIFICATES.rglob("*.json"))
    contents = {sha256(path.read_bytes()).hexdigest(): path.read_bytes() for path in found}
    folders = [path.parent for path in found if path.name == "certificate.json"]
    return [
        read((f / "statement.json").read_bytes(), (f / "certificate.json").read_bytes(), contents)
        for f in folders
    ]


@pytest.mark.skipif(shutil.which("pdflatex") is None, reason="pdflatex is not installed")
def test_all_committed_statements_compile_and_no_line_sticks_out(tmp_path: Path) -> None:
    outcomes = committed()
    assert len(outcomes) > 30
    in_full = [o for o in outcomes if o.statement.theorem in ("step", "separatrix", PAPER.theorem)]
    parts = [part(o, PAPER, TOLD, number=n) for n, o in enumerate(outcomes)]
    parts += [part(o, PAPER, full=True, number=100 + n) for n, o in enumerate(in_full[:4])]
    text = "".join([PREAMBLE, *parts, END])
    referred = set(re.findall(r"\\ref\{(.*?)\}", text))
    labels = re.findall(r"\\label\{(.*?)\}", text)
    assert len(referred) > 100
    assert referred <= set(labels)
    assert len(labels) == len(set(labels))
    (tmp_path / "all.tex").write_text(text, encoding="utf-8")
    command = ["pdflatex", "-interaction=nonstopmode", "-draftmode", "-no-shell-escape", "all.tex"]
    done = subprocess.run(command, cwd=tmp_path, capture_output=True, check=False)
    log = (tmp_path / "all.log").read_text(encoding="utf-8", errors="replace")
    assert re.findall(r"^!.*|Overfull.*|Missing character.*", log, re.MULTILINE) == []
    assert done.returncode == 0


def strange() -> Outcome:
    """A theorem of somebody else, with names that ours have too, and a sentence of its own."""
    glue, every = assume("glue", "c is meant"), for_all("all", {}, point={"x": 1})
    question = ask("square", 0 <= x**2 + symbol("c"), every, uses=[glue])
    return prove(lemma("step", [question], (), [every], [glue], parameters={"c": 2}))


def test_a_theorem_of_somebody_else_says_nothing_about_our_paper() -> None:
    for text in (part(strange(), PAPER), report(strange(), PAPER)):
        assert "glue" in text
        for ours in ("Dolmaire", "inelastic", "theta", "θ", "certificates/step", "``", "texttt{}"):
            assert ours not in text, ours
    for outcome in committed():
        ours = outcome.statement.obligations[0].label != ""
        assert (
            ("Dolmaire" in part(outcome, PAPER)) == ("Dolmaire" in report(outcome, PAPER)) == ours
        )


def test_the_short_article_has_the_theorem_and_what_is_false() -> None:
    found = {outcome.statement.theorem: outcome for outcome in committed(read_judged)}
    everywhere = part(found[EVERYWHERE], PAPER, TOLD)
    theorem = everywhere[everywhere.index(r"\begin{theorem}") : everywhere.index(r"\end{theorem}")]
    assert r"collide infinitely often" in theorem
    assert r"\overline{\eta} = \min\Bigl(" in theorem
    assert r"$0 < d$" in theorem
    brief, full = (part(found["step"], PAPER, full=full) for full in (False, True))
    assert "time-" in brief
    assert r"\begin{row}" not in brief
    assert full.count(r"\begin{row}") == len(found["step"].rows)
    point = part(found[PAPER.theorem], PAPER)
    printed = [row for row, d in found[PAPER.theorem].rows if row.role == PRINTED]
    assert 10 < point.count(r"\begin{row}") < len(printed) / 5
    assert "proved" not in re.findall(r"as printed, \\textbf\{(\w+)\}", point)


def test_every_sign_of_the_files_is_known() -> None:
    assert not re.findall(
        r"U\+[0-9A-F]{4}", "".join(part(outcome, PAPER) for outcome in committed())
    )


def test_words() -> None:
    assert words("|x_n| ≤ δ₂²/12 & 50%") == r"$|x_{n}|$ $\le$ $\delta_{2}^{2}$/12 \& 50\%"
    assert words("0 < -η_c, a - b, -cos θ, 0-2 and C_eta-below-one") == (
        r"0 $<$ $-\eta_{c}$, a $-$ b, $-$cos $\theta$, 0-2 and C\_eta-below-one"
    )
    assert words("ζ̄ = 5·10⁻⁵") == r"$\bar{\zeta}$ = 5$\cdot10^{-5}$"
    assert words("η_c², η_{c,n}² ≤ 4k_d/V₀") == (
        r"$\eta_{c}^{2}$, $\eta_{c,n}^{2}$ $\le$ 4$k_{d}$/$V_{0}$"
    )
    assert words("C_ηη̄ and ρ'² with C_eta-below-one") == (
        r"$C_{\eta}\bar{\eta}$ and $\rho^{\prime2}$ with C\_eta-below-one"
    )
    assert words("\\input{x} $ ~ ☃") == (
        r"\textbackslash{}input\{x\} \textdollar{} \~{} \texttt{U+2603}"
    )
    assert name("a_b-cd") == r"\texttt{a\_\allowbreak{}b-\allowbreak{}cd}"
    assert tex_number("2.9…·10⁻⁵") == r"2.9\ldots{} \times 10^{-5}"


def test_a_letter_of_a_file_is_a_letter() -> None:
    assert safe_letter(r"\varphi^-", "") == r"\varphi^-"
    assert safe_letter("g_c_{5}", "") == "{g_c}_{5}"
    assert safe_letter("r^(1/3)", "") == "r^{1/3}"
    assert safe_letter("m_outer_{5}", "") == r"m_{\mathrm{outer},5}"
    for text in (r"\input{/etc/passwd}", "}", r"x_{", "a_1_2_3", "$", ""):
        assert safe_letter(text, "x.1") == r"\mathit{x.1}"


@pytest.mark.parametrize(
    ("term", "tex"),
    [
        (as_term(-1) * as_term(-1) + x, "1 + x"),
        (as_term(-1) * x + 1 * y, "-x + y"),
        (x - (-y), "x + y"),
        (-(x - y) / 3, r"-\frac{x - y}{3}"),
        ((x / y) ** 2, r"\Bigl(\frac{x}{y}\Bigr)^{2}"),
        (((x + 1) * (x + 1 / y)) ** 2, r"\Bigl((x + 1)\, \Bigl(x + \frac{1}{y}\Bigr)\Bigr)^{2}"),
        (sqrt((x + 1 / y) ** 2), r"\sqrt{(x + \frac{1}{y})^{2}}"),
        (as_term(10) ** 10 * x, r"10^{10}\, x"),
        ((as_term(1) / 2 - 1) ** 3, r"\Bigl(\frac{1}{2} - 1\Bigr)^{3}"),
        (-sqrt(x) * -sqrt(y), r"\sqrt{x}\, \sqrt{y}"),
        (2 * (as_term(3) * x), r"2 \cdot (3\, x)"),
        (x - (y - 1), "x - (y - 1)"),
        (x / (y * (x + 1)), r"\frac{x}{y\, (x + 1)}"),
    ],
)
def test_formulas(term: Term, tex: str) -> None:
    assert (
        Formulas({}, {}).term(term).replace(r"\mathit{x}", "x").replace(r"\mathit{y}", "y") == tex
    )


def test_the_power_of_a_letter_with_an_exponent_has_parentheses() -> None:
    letters = {"x": "r^{1/3}", "y": r"\delta_2"}
    assert Formulas(letters, {}).term(x**3 * y**2) == r"(r^{1/3})^{3}\, {\delta_2}^{2}"


def test_a_name_at_the_beginning_of_a_sentence_stays_as_it_is() -> None:
    places = [
        for_all("a", [0 <= x], {"x": 1}, says="x is at least 0"),
        for_all("b", [0 <= y], {"y": 1}, says="the other one"),
    ]
    rows = [ask("r", -1 < x, places[0]), ask("s", -1 < y, places[1])]
    text = prove(lemma("x and y", rows, [], places)).latex()
    assert "\nx is at least 0.\\par\n" in text
    assert "\nThe other one.\\par\n" in text
    assert r"\section{x and y}" in text
    assert r"\section{A lemma on x}" in prove(lemma("a lemma on x", rows, [], places)).latex()


def value(term: Term, at: dict[str, Fraction]) -> Fraction:
    """The value of a term of the four operations and powers."""
    if term.op == "rational":
        return term.value
    if term.op == "symbol":
        return at[term.name]
    parts = [value(child, at) for child in term.children]
    if term.op == "pow":
        return parts[0] ** term.exponent
    if term.op == "neg":
        return -parts[0]
    a, b = parts
    return {"add": a + b, "sub": a - b, "mul": a * b, "div": a / b if b else Fraction(0)}[term.op]


def random_term(choose: random.Random, depth: int) -> Term:
    if depth == 0 or choose.random() < 0.2:
        return choose.choice((x, y, *(as_term(Fraction(n, 2)) for n in (-3, -2, 0, 2, 5))))
    op = choose.choice(("add", "sub", "mul", "div", "neg", "pow"))
    first = random_term(choose, depth - 1)
    if op == "neg":
        return -first
    if op == "pow":
        return first ** choose.randint(1, 3)
    return Term(op, first, random_term(choose, depth - 1))


def test_a_simplified_term_has_the_same_value() -> None:
    choose = random.Random(7)
    at = {"x": Fraction(7, 11), "y": Fraction(-13, 5)}
    changed = 0
    for _ in range(2000):
        term = random_term(choose, 4)
        found = simplified(term)
        assert value(found, at) == value(term, at)
        assert simplified(found) == found
        changed += found != term
    assert changed > 500
