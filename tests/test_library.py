"""The library: two pages of constants are decided, and what is offered is there."""

from __future__ import annotations

import json
import math
import re
import subprocess
import sys
from collections.abc import Callable
from fractions import Fraction
from itertools import chain
from pathlib import Path
from typing import Any

import pytest
from mypy import api

from tests.readme_commands import ROOT
from verify.language.errors import OwnError
from verify.language.terms import any_of, as_term, cos, sqrt
from verify.library import (
    always,
    applies,
    ask,
    assume,
    certificate,
    cite,
    constant,
    for_all,
    lemma,
    prove,
    read_page,
    root_between,
    symbol,
    write_page,
)
from verify.prover.hint import Hint
from verify.prover.prove import prove as decided
from verify.wire import questions as job
from verify.wire.inputs import InputError

FIRST = """
from fractions import Fraction

from verify import ask, certificate, check, constant, for_all, lemma, minimum, prove, sqrt, symbol

a, b, m, x = (symbol(name) for name in ("a", "b", "m", "x"))

numbers = [
    constant("a", sqrt(2)),
    constant("b", a + Fraction(1, 10)),
    constant("m", minimum(a * b, 3 - a)),
]
unit = for_all("unit", {"low": 0 <= x, "high": x <= 1}, point={"x": Fraction(1, 2)})
questions = [
    ask("small", m < Fraction(8, 5)),
    ask("entry", m <= 3 - a),
    ask("parabola", x * (1 - x) <= Fraction(1, 4), unit),
    ask("wrong", x * (1 - x) < Fraction(1, 5), unit),
]
outcome = prove(lemma("A small lemma", questions, numbers, [unit]))
for row, decision in outcome.rows:
    print(row.name, decision.verdict, decision.method)

files = certificate(outcome)
report = check.check(files["statement.json"], files["certificate.json"], {})
print(report.verdict)
"""

FIRST_SAYS = """small proved interval
entry proved entry
parabola proved sum
wrong refuted witness
REFUTED
"""

SECOND = """
from verify import ask, assume, certificate, check, for_all, lemma, prove, symbol

p, q, s = (symbol(name) for name in ("p", "q", "s"))

schwarz = assume("schwarz", "(u.v)^2 <= |u|^2 |v|^2 for the vectors u and v that are meant")
givens = {"p.low": 0 <= p, "q.low": 0 <= q, "cs": s**2 <= p * q}
vectors = for_all("vectors", givens, point={"p": 1, "q": 1, "s": 0})
triangle = ask("triangle", (p + 2 * s + q) <= 2 * p + 2 * q, vectors, uses=[schwarz])
outcome = prove(lemma("|u + v|^2 <= 2 |u|^2 + 2 |v|^2", [triangle], (), [vectors], [schwarz]))
print(outcome.verdict, "given", *(assumption.name for assumption in outcome.assumptions))

files = certificate(outcome)
print(check.check(files["statement.json"], files["certificate.json"], {}).verdict)
"""

SECOND_SAYS = """proved given schwarz
PROVED
"""


@pytest.mark.parametrize(("text", "says"), [(FIRST, FIRST_SAYS), (SECOND, SECOND_SAYS)])
def test_a_page_is_decided(text: str, says: str, capsys: pytest.CaptureFixture[str]) -> None:
    exec(text, {})
    assert capsys.readouterr().out == says


def test_what_is_offered_is_there() -> None:
    import verify

    assert sorted(verify.__all__) == sorted(chain(verify._MODULES, *verify._OFFERED.values()))
    for name in verify.__all__:
        assert getattr(verify, name) is not None
    with pytest.raises(AttributeError, match="no attribute 'nothing'"):
        verify.nothing  # noqa: B018


def test_a_point_of_theorem_1() -> None:
    from verify import Interval, theorem1

    point = theorem1.at(r="0.03")
    phi = point.constants["phi_minus"]
    assert isinstance(phi, Interval)
    r, alpha = Fraction(3, 100), Fraction(103, 200)  # phi is the smaller root of x^2 - alpha x + r
    assert phi.low**2 - alpha * phi.low + r >= 0 >= phi.high**2 - alpha * phi.high + r
    assert 0 < phi.high - phi.low < Fraction(1, 10**20)
    assert str(phi) == "0.066958009…"
    assert (point.verdict, point.verdicts["printed.zeta-total"]) == ("proved", "refuted")
    assert point.verdicts["hypotheses.angle-as-printed"] == "remark"
    assert point.decision("repaired.zeta-total").verdict == "proved"
    assert len(point.refuted) == 13
    files = certificate(point)
    assert {"statement.json", "certificate.json"} <= files.keys()
    same = theorem1.at(Fraction(3, 100), neg_cos=1, delta_theta="0.1", V_0=1)
    assert same.statement == point.statement
    assert theorem1.at("1/100", theta0="5pi/6").verdict == "proved"


def test_what_a_point_prints_is_what_the_command_prints(capsys: pytest.CaptureFixture[str]) -> None:
    from verify import theorem1
    from verify.cli import main

    main(["theorem1", "--r", "0.03"])
    assert str(theorem1.at("0.03")).split() == capsys.readouterr().out.split()


def test_the_spectrum_at_a_point(capsys: pytest.CaptureFixture[str]) -> None:
    from verify import spectrum
    from verify.cli import main

    found = spectrum.at(r="0.03", bits=200)
    main(["spectrum", "--r", "0.03", "--precision", "200", "--json"])
    told = json.loads(capsys.readouterr().out)["eigenvalues"]
    low, high = map(Fraction, told["lambda_0"])
    assert low <= found.lambda_0.low <= found.lambda_0.high <= high
    low, high = map(Fraction, told["lambda_plus"]["im"])
    assert low <= found.plus.imaginary.low <= found.plus.imaginary.high <= high
    one = found.plus.real.low**2 + found.plus.imaginary.low**2
    assert found.modulus.low**2 <= one + Fraction(1, 2**150)
    assert len(found.vector_0) == len(found.vector_plus) == 4
    assert "vector_0 = (1, -0.0623266" in str(found)
    assert "Fraction" not in str(found)
    assert str(found.vector_plus[1]).startswith("0.10549719… - i 0.2458236")


def test_what_is_no_exact_number_is_refused() -> None:
    from verify import spectrum, theorem1

    for at in (theorem1.at, spectrum.at):
        with pytest.raises(TypeError, match="r is a float; write a text"):
            at(0.03)  # type: ignore[operator]
        with pytest.raises(InputError, match=r"^r: .* not in"):
            at("1.5")  # type: ignore[operator]
        with pytest.raises(InputError, match=r"digits|characters"):
            at(10**5000)  # type: ignore[operator]
        for bits in (0, -1, 1, 10**9):
            with pytest.raises(InputError, match="bits: has to be from 2"):
                at("0.03", bits=bits)  # type: ignore[operator]
        for odd in ("128", 128.5, True, None):
            with pytest.raises(TypeError, match="bits is a"):
                at("0.03", bits=odd)  # type: ignore[operator]
        with pytest.raises(TypeError, match="r is a NoneType"):
            at(None)  # type: ignore[operator]
    with pytest.raises(TypeError, match="theta0 is a float"):
        theorem1.at("0.03", theta0=3.0)  # type: ignore[arg-type]
    with pytest.raises(InputError, match="below bits"):
        theorem1.at("0.03", bits=256, max_bits=128)
    with pytest.raises(TypeError, match="V0 is a NoneType"):
        theorem1.at("0.03", V_0=None)  # type: ignore[arg-type]
    with pytest.raises(InputError, match=r"^V_0: "):
        theorem1.at("0.03", V_0=-1)
    with pytest.raises(InputError, match=r"^delta_theta: "):
        theorem1.at("0.03", delta_theta="0,1")
    with pytest.raises(InputError, match="both give the angle"):
        theorem1.at("0.03", theta0="pi", neg_cos=1)


def test_the_package_is_cheap_to_import() -> None:
    text = "import sys, verify; print([n for n in sys.modules if n.startswith('verify')])"
    done = subprocess.run([sys.executable, "-c", text], capture_output=True, text=True, check=True)
    assert done.stdout.strip() == "['verify']"
    text = "import verify; print(verify.theorem1.at, verify.spectrum.__name__)"
    done = subprocess.run([sys.executable, "-c", text], capture_output=True, text=True, check=True)
    assert done.stdout.strip().endswith("verify.spectrum")


def test_what_the_checker_does_not_accept_is_an_error(monkeypatch: pytest.MonkeyPatch) -> None:
    x = symbol("x")
    unit = for_all("unit", {"low": 0 <= x, "high": x <= 1}, point={"x": 0})
    true = lemma("true", [ask("row", x * (1 - x) <= Fraction(1, 4), unit)], (), [unit])
    false = lemma("false", [ask("row", x * (1 - x) <= Fraction(1, 5), unit)], (), [unit])
    found = decided(true)
    monkeypatch.setattr(job, "prove", lambda *_, **__: found._replace(statement=false))
    with pytest.raises(OwnError, match="does not accept"):
        prove(false)


# --- typed, and told what is wrong ---------------------------------------------------------------


def programs() -> list[str]:
    """The programs in README.md and docs/ that import the library."""
    pages = [ROOT / "README.md", *sorted((ROOT / "docs").rglob("*.md"))]
    text = "\n".join(page.read_text(encoding="utf-8") for page in pages)
    block = r"^```(?:python|\{code-block\} python\n(?::[^\n]*\n)*)\n(.*?)^```"
    blocks = re.findall(block, text, re.MULTILINE | re.DOTALL)
    return [block for block in blocks if re.search(r"^from verify import", block, re.M)]


def test_a_type_checker_accepts_the_programs_of_the_documentation(tmp_path: Path) -> None:
    found = [*programs(), FIRST, SECOND]
    assert len(found) >= 4
    paths = [tmp_path / f"program_{i}.py" for i in range(len(found))]
    for path, text in zip(paths, found, strict=True):
        path.write_text(text, encoding="utf-8")
    out, err, code = api.run(["--strict", "--no-incremental", *map(str, paths)])
    assert (code, err) == (0, ""), out
    wrong = tmp_path / "wrong.py"
    wrong.write_text(f'{FIRST}\nask("same", a == b)\nconstant("c", 0.5)\n', encoding="utf-8")
    out, _, code = api.run(["--strict", "--no-incremental", str(wrong)])
    assert code == 1
    assert out.count("[arg-type]") == 2


x, y, t = symbol("x"), symbol("y"), symbol("t")
UNIT = for_all("unit", [0 <= x, x <= 1], point={"x": Fraction(1, 2)})


def test_contexts_in_contexts_moduli_and_roles() -> None:
    inner = for_all(
        "inner", [-x <= y, y <= x], {"y": 0}, within=UNIT, constants=[constant("s", x + y)]
    )
    rows = [
        ask("above", 0 <= symbol("s"), inner),
        ask("modulus", abs(y) <= x, inner),
        ask("cosine", cos(y) <= 1, inner),
        ask("false", x < 1, UNIT, role="printed"),
    ]
    outcome = prove(lemma("Two contexts", rows, (), [UNIT, inner]))
    assert outcome.decision("above").verdict == "proved"
    assert outcome.decision("false").verdict == "refuted"
    assert outcome.verdict == outcome.decision("cosine").verdict


def test_an_induction_and_an_application() -> None:
    state = for_all("state", (), {"t": 1}, carried=[1 <= t])
    rows = [
        ask("always", always(state, {"t": 1}, {"t": (t + 1) / 2})),
        ask("at-2", applies(state, {"t": sqrt(2)})),
    ]
    outcome = prove(lemma("An induction", rows, (), [state]))
    assert [found.verdict for _, found in outcome.rows] == ["proved", "proved"]


def test_a_citation_carries_its_certificate() -> None:
    square = lemma("square", [ask("s", x**2 <= 1, UNIT)], (), [UNIT])
    files = certificate(prove(square))
    outcome = prove(lemma("citing", [ask("one", 0 < as_term(1))], cites=[cite("m", files)]))
    assert outcome.verdict == "proved"
    written = certificate(outcome)
    assert sum(name.startswith("cited/") for name in written) == 2
    with pytest.raises(InputError, match="no statement"):
        cite("m", {})


def test_rows_that_begin_are_watched_and_work_is_limited() -> None:
    asked = lemma("t", [ask("a", x <= 1, UNIT), ask("b", x**2 <= 1, UNIT)], (), [UNIT])
    seen: list[str] = []
    assert prove(asked, watch=seen.append).verdict == "proved"
    assert seen == ["a", "b"]
    assert prove(asked, seconds=1e-9).verdict == "undecided"


def test_hints_restrict_the_search() -> None:
    asked = lemma("t", [ask("a", x**4 <= 1, UNIT)], (), [UNIT])
    assert prove(asked, hints={"a": Hint(by=("angles",))}).verdict == "undecided"
    assert prove(asked, hints={"a": Hint(by=("squares", "tree"))}).verdict == "proved"


def test_a_page_is_read_and_written(tmp_path: Path) -> None:
    asked = lemma("t", [ask("a", x <= 1, UNIT)], [constant("alpha_0", sqrt(2))], [UNIT])
    path = tmp_path / "page.toml"
    path.write_text(write_page(asked), encoding="utf-8")
    assert read_page(path) == asked
    with pytest.raises(InputError, match="cannot be read"):
        read_page(tmp_path / "none.toml")


def test_a_notebook_shows_the_formulas_and_the_verdicts() -> None:
    rows = [ask("a", x <= symbol("alpha_0"), UNIT), ask("b", x < 1, UNIT, role="printed")]
    outcome = prove(lemma("<t>", rows, [constant("alpha_0", sqrt(2))], [UNIT]))
    page = outcome._repr_html_()
    assert "<b>&lt;t&gt;</b>: proved" in page
    assert "<msub><mi>α</mi>" in page
    assert page.count("for all values of unit") == 2
    assert "<b>refuted</b>" in page
    assert "at x = 1" in page
    assert "\\alpha_{0}" in outcome.latex()
    assert str(outcome).splitlines()[0].startswith("proved    a  x ≤ α₀")


@pytest.mark.parametrize(
    ("make", "error", "says"),
    [
        (lambda: ask("r", x == y), TypeError, "== compares how terms are written; write equal"),
        (lambda: ask("r", x), TypeError, "is no claim; write for example x <= 1"),
        (lambda: ask("r", x <= 1, "unit"), TypeError, "'unit' is no context; make one by for_all"),
        (lambda: ask("r", x <= 1, role="must"), InputError, "role 'must' is unknown; write needed"),
        (lambda: for_all("c", 0 <= x, {"x": 1}), TypeError, "write a list of givens, also of one"),
        (lambda: for_all("c", [x == y], {"x": 1}), TypeError, "== compares how terms are written"),
        (lambda: for_all("c", [], {x: 1}), TypeError, "is no name; write the name, such as 'x'"),
        (lambda: applies(UNIT, {"y": 1}), InputError, "write values of x"),
        (lambda: always(UNIT, {"x": 1}, {}), InputError, "x has no value; write values of x"),
        (lambda: lemma("t", ask("r", x <= 1)), TypeError, "write a list of questions, also of one"),
        (lambda: lemma("t", [x <= 1]), TypeError, "is none of the questions; make it by ask"),
        (lambda: lemma("t", [ask("r", x <= 1, UNIT)]), InputError, "which the lemma does not have"),
        (lambda: lemma("t", [ask("r", y <= 1)], (), [UNIT]), InputError, "r: y is not defined"),
        (lambda: lemma("t", [ask("r", y <= 1)]), InputError, "y is not defined; no constant or"),
        (lambda: lemma("t", [ask("r 1", x <= 1, UNIT)], (), [UNIT]), InputError,
         "the row 'r 1': it is no name; write ASCII letters"),
        (lambda: lemma("t", [], [constant("é", 1)]), InputError, "the constant 'é': it is no name"),
        (lambda: lemma("t", [ask("x", x <= 1, UNIT)], (), [UNIT]), InputError,
         "x is the name of a variable and of a row; choose another"),
        (lambda: lemma("t", [ask("r", 0 < as_term(1), None, [assume("g", "so")])]), InputError,
         "the row r uses g, which the lemma does not have"),
        (lambda: lemma("t", [], (), [for_all("v", [], {"y": 0}, within=UNIT), UNIT]), InputError,
         "the context v is within unit, which has to come before it"),
        (lambda: prove(lemma("t", [ask("r", 0 < as_term(1))])).decision("s"), InputError,
         "there is no row 's'; write one of r"),
        (lambda: applies("unit", {"x": 1}), TypeError, "'unit' is no context; make one by for_all"),
        (lambda: always("unit", {}, {}), TypeError, "'unit' is no context; make one by for_all"),
        (lambda: ask("r", x <= 1, uses=["g"]), TypeError, "its uses is 'g'; make it by assume"),
        (lambda: any_of([x <= 1, 2 <= x]), TypeError, "is no claim; write any_of(x <= 1, 2 <= x)"),
        (lambda: prove("page.toml"), TypeError, "is 'page.toml'; make it by lemma or read_page"),
        (lambda: prove(lemma("t", []), hints={"r": "squares"}), TypeError,
         "the hint for r is 'squares'; make it by Hint"),
        (lambda: certificate(lemma("t", [])), TypeError, "make it by prove"),
        (lambda: write_page(prove(lemma("t", [ask("r", 0 < as_term(1))]))), TypeError,
         "make it by lemma"),
    ],
)  # fmt: skip
def test_what_is_said_of_a_mistake(
    make: Callable[[], object], error: type[Exception], says: str
) -> None:
    with pytest.raises(error) as found:
        make()
    assert says in str(found.value)


def test_a_root_is_a_context_with_the_rows_that_show_it() -> None:
    x, c = symbol("x"), constant("c", 2)
    golden = root_between("golden", x**2 - x - (symbol("c") - 1), x, (1, 2), constants=[c])
    rows = [*golden.rows, ask("size", x < Fraction("1.618034"), golden.context)]
    found = prove(lemma("golden", rows, [c], [golden.context, golden.range]))
    assert found.claimed == "proved"
    with pytest.raises(InputError, match="does not change its sign"):
        root_between("none", x**2 + 1, x, (0, 1))
    with pytest.raises(TypeError, match="two rational numbers"):
        root_between("none", x**2 - 2, x, (0, sqrt(3)))
    with pytest.raises(TypeError, match="no variable"):
        root_between("none", x**2 - 2, 2 * x, (0, 2))


@pytest.mark.parametrize(
    ("limits", "what"),
    [
        ({"seconds": math.inf}, "seconds = inf: write a number below"),
        ({"seconds": math.nan}, "seconds = nan"),
        ({"seconds": 1e300}, "seconds = 1e[+]300"),
        ({"seconds": "2"}, "seconds = '2'"),
        ({"work": "3"}, "work = '3': write how many units"),
        ({"work": 1.5}, "work = 1.5"),
    ],
)
def test_limits_are_numbers(limits: dict[str, Any], what: str) -> None:
    with pytest.raises(InputError, match=what):
        prove(lemma("t", [ask("r", as_term(0) < 1)]), **limits)
    assert prove(lemma("t", [ask("r", as_term(0) < 1)]), seconds=Fraction(5)).verdict == "proved"


def test_a_word_of_certificates_and_half_a_letter_are_refused() -> None:
    with pytest.raises(InputError, match="the row goal: that is a word of certificates"):
        lemma("t", [ask("goal", as_term(0) < 1)])
    for title, says in (("\udc80", ""), ("t", "\udc80")):
        with pytest.raises(InputError, match="half of a letter"):
            prove(lemma(title, [ask("r", as_term(0) < 1, says=says)]))
