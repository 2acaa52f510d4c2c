"""The library: two pages of constants are decided, and what is offered is there."""

from __future__ import annotations

from fractions import Fraction

import pytest

from verify.language.errors import OwnError
from verify.library import ask, for_all, lemma, prove, symbol
from verify.prover.prove import prove as decided
from verify.wire import questions as job

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
parabola proved cuts
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

    for name in verify._OFFERED:
        assert getattr(verify, name) is not None
    with pytest.raises(AttributeError, match="no attribute 'nothing'"):
        verify.nothing  # noqa: B018


def test_what_the_checker_does_not_accept_is_an_error(monkeypatch: pytest.MonkeyPatch) -> None:
    x = symbol("x")
    unit = for_all("unit", {"low": 0 <= x, "high": x <= 1}, point={"x": 0})
    true = lemma("true", [ask("row", x * (1 - x) <= Fraction(1, 4), unit)], (), [unit])
    false = lemma("false", [ask("row", x * (1 - x) <= Fraction(1, 5), unit)], (), [unit])
    found = decided(true)
    monkeypatch.setattr(job, "prove", lambda *_, **__: found._replace(statement=false))
    with pytest.raises(OwnError, match="does not accept"):
        prove(false)
