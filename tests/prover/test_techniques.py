"""The loop that calls the techniques, and what each of them may rely on."""

from __future__ import annotations

import time
from collections.abc import Sequence
from itertools import pairwise

import pytest

from verify.language.fold import replaced
from verify.language.statement import PROVED, REFUTED, UNDECIDED
from verify.language.terms import (
    Claim,
    Term,
    as_term,
    cos,
    cos_pi,
    exp,
    log,
    minimum,
    sqrt,
    symbol,
)
from verify.library import ask, constant, for_all, lemma, prove
from verify.prover import techniques
from verify.prover.bernstein import Tensor
from verify.prover.clearing import TooLongError, has_value
from verify.prover.outcome import Decision
from verify.prover.proof import Proof
from verify.prover.search import bases
from verify.prover.search.question import Question
from verify.prover.techniques import (
    EQUATIONS,
    FREE,
    LAST,
    PRODUCTS,
    SEARCHES,
    SIMPLE,
    SUMS,
    Technique,
)

x, y = symbol("x"), symbol("y")
HALF_LINE = for_all("all", {"low": 1 <= x}, {"x": 1})


def decided(claim: Claim) -> Decision:
    return prove(lemma("title", [ask("row", claim, HALF_LINE)], (), [HALF_LINE])).decisions["row"]


def too_long(_: Question) -> Proof | None:
    raise TooLongError


def test_a_technique_that_is_too_long_does_not_end_the_search(
    monkeypatch: pytest.MonkeyPatch,
) -> None:
    monkeypatch.setattr(techniques, "SIMPLE", (Technique("a long one", too_long), *SIMPLE))
    assert decided(2 * x <= x**2 + 1).verdict == PROVED


def test_an_undecided_row_says_what_was_too_long(monkeypatch: pytest.MonkeyPatch) -> None:
    for name in ("FREE", "SUMS", "PRODUCTS", "LAST"):
        monkeypatch.setattr(techniques, name, ())
    for name in ("SIMPLE", "SEARCHES"):
        monkeypatch.setattr(techniques, name, (Technique("a long one", too_long),))
    found = decided(2 * x <= x**2 + 1)
    assert found.verdict == UNDECIDED
    assert "; a long one: expanding the claim is too much work" in found.reason
    monkeypatch.setattr(techniques, "SIMPLE", ())
    monkeypatch.setattr(techniques, "SEARCHES", ())
    reason = decided(2 * x <= x**2 + 1).reason
    assert reason.startswith("neither a proof nor an example against it was found; ")
    assert "most nearly false about x = 1, where the sides differ by 0" in reason


def test_each_technique_is_called_with_a_question_alone(monkeypatch: pytest.MonkeyPatch) -> None:
    called: list[str] = []

    def watched(technique: Technique) -> Technique:
        def prove_nothing(question: Question) -> None:
            called.append(technique.name)
            technique.prove(question)

        return technique._replace(prove=prove_nothing)

    groups = {"FREE": FREE, "SIMPLE": SIMPLE, "SUMS": SUMS, "PRODUCTS": PRODUCTS}
    for name, every in (groups | {"SEARCHES": SEARCHES, "LAST": LAST}).items():
        monkeypatch.setattr(techniques, name, tuple(map(watched, every)))
    assert decided(2 * x <= x**2 + 1).verdict == UNDECIDED
    assert called == [
        technique.name for technique in (*FREE, *SIMPLE, *SUMS, *PRODUCTS, *SEARCHES, *LAST)
    ]
    assert {technique.name for technique in EQUATIONS} == {
        "cosines",
        "multiple angles",
        "elementary",
        "both orders",
    }


@pytest.mark.parametrize(
    ("part", "facts", "expected"),
    [
        (x / y, [0 < y], True),
        (x / y, [0 < -y], True),
        (x / y, [0 <= y], False),
        (x / y, [0 < x], False),
        (sqrt(x), [0 <= x], True),
        (sqrt(x), [0 < x], True),
        (sqrt(x), [0 < -x], False),
        (x / as_term(-2), [], True),
        (x / as_term(0), [], False),
        (sqrt(as_term(0)), [], True),
        (sqrt(as_term(-1)), [], False),
        (x * y, [], True),
    ],
)
def test_what_a_quotient_or_a_root_needs(part: object, facts: list[Claim], expected: bool) -> None:
    assert has_value(part, facts.__contains__) is expected


def test_parts_of_a_term_are_replaced_all_at_once() -> None:
    term = minimum(sqrt(x), cos_pi(y / 2) ** 3) - x
    assert replaced(term, {}) is term
    assert replaced(term, {x: y, sqrt(x): x}) == minimum(x, cos_pi(y / 2) ** 3) - y


@pytest.mark.parametrize(
    ("givens", "verdict", "most"),
    [
        ([0 <= x, x <= 2], REFUTED, 0),  # false at an end, in whatever degree
        ([0 < x, x <= 2], REFUTED, 0),
        ([0 < x, x < 2], PROVED, 40),
    ],
)
def test_no_degree_is_raised_where_an_end_of_the_interval_decides(
    givens: list[Claim], verdict: str, most: int, monkeypatch: pytest.MonkeyPatch
) -> None:
    raised: list[int] = []
    raise_ = Tensor.raised

    def counted(tensor: Tensor, index: int) -> Tensor:
        raised.append(index)
        return raise_(tensor, index)

    monkeypatch.setattr(Tensor, "raised", counted)
    within = for_all("within", givens, {"x": 1})
    claim = 0 < x * (2 - x) * (10 * x**2 - 20 * x + 11)
    found = prove(lemma("title", [ask("row", claim, within)], (), [within]))
    assert found.decisions["row"].verdict == verdict
    assert min(most, 1) <= len(raised) <= most


def test_a_quadratic_form_needs_few_of_the_directions(monkeypatch: pytest.MonkeyPatch) -> None:
    """Each monomial of its squares is seen to be one of p; only 1 is tested, and is outside."""
    products: list[object] = []
    dot = bases._dot

    def counted(a: Sequence[int], b: Sequence[int]) -> int:
        products.append(a)
        return dot(a, b)

    monkeypatch.setattr(bases, "_dot", counted)
    monkeypatch.setattr(techniques, "SIMPLE", ())
    names = [symbol(f"x{i}") for i in range(12)]
    form = sum((a**2 + a * b + b**2 for a, b in pairwise(names)), as_term(0))
    context = for_all("all", [], {f"x{i}": 0 for i in range(12)})
    asked = lemma("title", [ask("row", 0 <= form, context)], (), [context])
    for group in ("SUMS", "PRODUCTS"):
        squares = [one for one in getattr(techniques, group) if "square" in one.name]
        monkeypatch.setattr(techniques, group, tuple(squares))
    found = prove(asked)
    assert found.decisions["row"].verdict == PROVED
    assert 0 < len(products) < 3000


def summed(terms: Sequence[Term]) -> Term:
    """A sum whose depth is the logarithm of its length."""
    half = len(terms) // 2
    return terms[0] if half == 0 else summed(terms[:half]) + summed(terms[half:])


def expanded_squares(n: int) -> Term:
    """The squares of n sums of variables, expanded."""
    names = [symbol(f"x{i}") for i in range(n)]
    rows = [[0] * i + [1 + (i * j + j) % 5 for j in range(n - i)] for i in range(n)]
    return summed(
        [
            sum(row[j] * row[k] for row in rows) * names[j] * names[k]
            for j in range(n)
            for k in range(n)
        ]
    )


def test_a_quadratic_form_is_proved_by_completing_squares(
    monkeypatch: pytest.MonkeyPatch,
) -> None:
    for name in ("SUMS", "PRODUCTS", "SEARCHES", "LAST"):
        monkeypatch.setattr(techniques, name, ())
    place = for_all("all", {}, {f"x{i}": 0 for i in range(30)})
    x0, x1 = symbol("x0"), symbol("x1")
    claims = {
        "form": as_term(0) <= expanded_squares(30),
        "shifted": 2 * x0 < expanded_squares(5) + x0**2 + 2,
        "linear": as_term(0) <= x0,
        "zero": 2 * x0 < x0**2 + 1,
        "saddle": 4 * x0 * x1 <= x0**2 + x1**2,
        "flat": 2 * x0 * x1 <= x0**2,
    }
    rows = [ask(name, claim, place) for name, claim in claims.items()]
    found = prove(lemma("title", rows, (), [place]))
    proved = {name for name, decision in found.decisions.items() if decision.verdict == PROVED}
    assert proved == {"form", "shifted"}
    assert {found.decisions[name].method for name in proved} == {"sum"}


def test_squares_are_completed_only_with_constants_that_the_checker_can_clear() -> None:
    """What shows that a constant has a value is an enclosure, and no fact."""
    place, x, k = for_all("all", {}, {"x": 0}), symbol("x"), symbol("k")
    rows = [ask("mean", k * x <= (k**2 + x**2) / 2, place)]
    for value in (log(exp(as_term(2) / 3)), 1 / cos(as_term(4))):
        found = prove(lemma("title", rows, [constant("k", value)], [place]), work=300_000)
        assert found.decisions["mean"].verdict == PROVED


@pytest.mark.parametrize(
    "claim",
    [
        x**900 * exp(-x) <= 900**900,
        x**999 <= exp(999 * x) * 999**999,
        log(x**998 + 1) <= 998 * log(x + 1),
        log((x**999) ** 999 + 1) >= 0,
        0 <= log((x**999) ** 999),
        1 <= sqrt(((x**99) ** 99) ** 99),
        x**999 <= as_term(2) ** 999 + 1,
    ],
)
def test_large_degrees_take_no_time(claim: Claim) -> None:
    place = for_all("all", {"low": 1 <= x, "high": x <= 2}, {"x": 1})
    before = time.process_time()
    found = prove(lemma("title", [ask("row", claim, place)], (), [place]), work=1_000_000)
    assert found.decisions["row"].verdict != REFUTED
    assert time.process_time() - before < 8
