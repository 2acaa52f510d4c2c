"""Points of givens: each system of linear givens has one, or a sum that says what is false."""

from __future__ import annotations

import random
from fractions import Fraction

import pytest

from verify.language.fold import RATIONAL, fold, holds
from verify.language.terms import Claim, Term, as_term, symbol
from verify.prover.budget import WorkBudget
from verify.prover.search.interior import contradiction_of, interior
from verify.wire.inputs import InputError
from verify.wire.questions import decide, read_page_of


def page(variables: list[str], given: list[str], row: str = "0 < 1") -> bytes:
    table = f"variables = {variables}\ngiven = {given}\n".replace("'", '"')
    return f'title = "t"\n[contexts.box]\n{table}[rows]\nrow = "{row}"\n'.encode()


def verdict(variables: list[str], given: list[str], row: str) -> str:
    asked = read_page_of("a.toml", page(variables, given, row), {}).statement
    return decide(asked).decisions["row"].verdict


def value(term: Term, at: dict[str, Fraction]) -> Fraction:
    return fold(term, RATIONAL, {symbol(name): x for name, x in at.items()})


def at_point(claims: list[Claim], at: dict[str, Fraction]) -> bool:
    return all(holds(c.relation, value(c.lhs, at), value(c.rhs, at)) for c in claims)


def drawn(seed: int) -> tuple[list[str], list[Claim]]:
    """Linear claims, many with a common point, some with none."""
    draw = random.Random(seed)
    names = [f"x{i}" for i in range(draw.randint(1, 7))]
    claims = []
    for _ in range(draw.randint(1, 12)):
        side = as_term(draw.randint(-3, 3))
        for name in draw.sample(names, draw.randint(1, len(names))):
            side = side + draw.choice((-2, -1, 1, Fraction(1, 3), 5)) * symbol(name)
        sides = (side, as_term(0)) if draw.random() < 0.5 else (as_term(0), side)
        claims.append(Claim(draw.choice(("<", "<=", "<=", "=")), *sides))
    return names, claims


@pytest.mark.parametrize("seed", range(80))
def test_linear_claims_have_a_point_or_contradict_each_other(seed: int) -> None:
    names, claims = drawn(seed)
    point = interior(
        names,
        claims,
        {},
        lambda p: at_point(claims, dict(zip(names, p, strict=True))),
        WorkBudget(300_000),
    )
    wrong = contradiction_of(names, claims)
    assert (point is None) == (wrong is not None)
    if wrong is None:
        return
    assert all(claim.relation == "=" or weight > 0 for weight, claim in wrong.addends)
    for seed_of_point in range(3):  # the sum is a number, wherever it is looked at
        draw = random.Random(seed_of_point)
        at = {name: Fraction(draw.randint(-9, 9), draw.randint(1, 5)) for name in names}
        gap = sum(w * (value(c.rhs, at) - value(c.lhs, at)) for w, c in wrong.addends)
        assert gap == wrong.total.rhs.value
    is_strict = any(claim.relation == "<" for _, claim in wrong.addends)
    assert not holds("<" if is_strict else "<=", Fraction(0), wrong.total.rhs.value)


SIMPLEX = [f"x{i}" for i in range(30)]


@pytest.mark.parametrize(
    ("variables", "given", "row"),
    [
        (
            [*"ABstpq"],
            ["0 < A", "A <= 1", "1 <= B", "s <= B", "t <= B", "0 <= p", "0 <= q", "p < A", "q < A"],
            "p <= B",
        ),
        (SIMPLEX[:7], [*(f"{x} >= 0" for x in SIMPLEX[:7]), "+".join(SIMPLEX[:7]) + " <= 1"],
         "x0 <= 1"),
        (SIMPLEX, [*(f"{x} >= 0" for x in SIMPLEX), "+".join(SIMPLEX) + " <= 1"], "x9 <= 1"),
        (SIMPLEX, [*(f"{x} >= 0" for x in SIMPLEX), "+".join(SIMPLEX) + " = 1"], "x9 <= 1"),
        ([*"xyz"], ["2*x+y+z = 4", "x+2*y+z = 5", "x+y+2*z = 6"], "z = 9/4"),
        (["x"], ["0 < x", "x < exp(1000)"], "0 <= x"),
    ],
)  # fmt: skip
def test_a_point_of_linear_givens_is_found(
    variables: list[str], given: list[str], row: str
) -> None:
    assert verdict(variables, given, row) == "proved"


def test_a_point_of_other_givens_is_found() -> None:
    ball = "+".join(f"{x}^2" for x in SIMPLEX[:14]) + " < 1"
    assert verdict(SIMPLEX[:14], [ball], "x0 <= 1") == "proved"
    assert verdict([*"xyz"], ["x^2+y^2+z^2 <= 1/100", "x+y+z > 17/100"], "x <= 1/10") == "proved"
    assert verdict(["x"], ["x^2 = 2"], "x < 1") == "refuted"


@pytest.mark.parametrize(
    ("variables", "given"),
    [
        (["x"], ["x < 0", "1 < x"]),
        ([*"xyz"], ["x < y", "y <= z", "z <= x"]),
        (SIMPLEX, [*(f"{x} >= 0" for x in SIMPLEX), "+".join(SIMPLEX) + " < 0"]),
        ([*"xy"], ["x + y = 1", "2*x + 2*y = 3"]),
    ],
)
def test_the_page_says_how_givens_contradict_each_other(
    variables: list[str], given: list[str]
) -> None:
    with pytest.raises(InputError, match=r"line 2: .* the givens contradict each other"):
        read_page_of("a.toml", page(variables, given), {})


@pytest.mark.parametrize("divisor", ["(a - b)", "(1 - sqrt(2))", "c", "(-2)"])
def test_a_divisor_of_unknown_sign_shows_no_contradiction(divisor: str) -> None:
    """All divisors are negative, so that the first two givens hold for all x from 1 on."""
    given = [f"x/{divisor} <= 0", "x >= 1", "exp(y) = 3", "y > 1"]
    around = (
        "[contexts.around]\nvariables = ['c']\ngiven = ['c < 0']\n[contexts.box]\nin = 'around'"
    )
    text = page([*"xy"], given).decode().replace("[contexts.box]", around)
    constants = "[constants]\na = '1'\nb = 'sqrt(2)'\n[contexts.around]"
    text = text.replace("[contexts.around]", constants)
    with pytest.raises(InputError, match="no point was found"):
        read_page_of("a.toml", text.encode(), {})


def test_no_point_is_proposed_that_violates_the_givens() -> None:
    with pytest.raises(InputError, match=r"write one, as point = { x = \.\.\. }"):
        read_page_of("a.toml", page(["x"], ["exp(x) = x"]), {})
