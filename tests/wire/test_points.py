"""The guess of points: a limit of time leaves it less work."""

from __future__ import annotations

from random import Random

import pytest

from tests.cpu import seconds_of
from verify.language.statement import PROVED
from verify.language.terms import as_term
from verify.prover.budget import WorkBudget
from verify.wire.inputs import InputError
from verify.wire.questions import decide_page, read_page_of
from verify.wire.text import points


def hopeless() -> bytes:
    """A page with givens of twelve variables at which no point is found."""
    random, names = Random(5), [f"x_{i}" for i in range(1, 13)]
    parts = [random.choices(names, k=5) for _ in range(14)]
    given = [f"{a}^2*{b} + sin({c}*{a}) + exp({b}) <= {d}*{e} - 3" for a, b, c, d, e in parts]
    given.append("sin(x_11) + sin(x_12) <= -3")
    context = f"[contexts.c]\nvariables = {names}\ngiven = {given}".replace("'", '"')
    return f'title = "t"\n{context}\n[rows]\nr = "x_1 <= 1"\n'.encode()


def test_half_of_the_time_is_for_points(monkeypatch: pytest.MonkeyPatch) -> None:
    budgets: list[WorkBudget] = []

    def kept(work: int) -> WorkBudget:
        budgets.append(WorkBudget(work))
        return budgets[-1]

    monkeypatch.setattr(points, "WorkBudget", kept)
    for seconds in (0.05, 0.2, None):
        with pytest.raises(InputError, match="no point was found"):
            read_page_of("a.toml", hopeless(), {}, seconds)
    short, longer, unlimited = (budget.spent for budget in budgets)
    assert short <= 25_000
    assert short < longer <= 100_000
    assert longer < unlimited


@pytest.mark.parametrize(
    "given",
    [
        '"a > 10^6*b", "b > 10^6*x", "x > 10^6"',
        '"a > 0", "a < 1e-9*b", "b < 1e-9", "x = 0"',
        '"a < b - 1e8", "a^2 < 4", "x = 0"',
        '"a^2 + b^2 <= 1e-12", "a > b", "b > 0", "x = 0"',
        '"a^2 > 1000*a", "a > 0", "b = x", "x = 0"',
        '"a^3 = 2", "b^5 = -7", "x^4 = 3"',
        '"a < b", "b < a + 1e-30", "x = 0"',
        '"a >= exp(300)", "b > exp(1000)", "x >= b"',
        '"a = exp(1000)", "b = a^2", "x <= -exp(2000)"',
        '"exp(1000) < a < exp(1000) + 1", "10^400 <= b <= 10^400 + 1", "0 < x < exp(1000)"',
    ],
)
def test_easy_points_of_any_size_are_found(given: str) -> None:
    """Near equality exact numbers decide, not floats."""
    page = (
        f'title = "t"\n[contexts.c]\nvariables = "a b x"\ngiven = [{given}]\n[rows]\nr = "a = a"\n'
    )
    outcome = decide_page(read_page_of("a.toml", page.encode(), {}), WorkBudget())
    assert outcome.verdict == PROVED


@pytest.mark.parametrize(
    "given",
    [
        '"a < b", "b < a + 1e-30", "a > b - 1e-31", "x > 2*b - 2*a + x"',
        '"a > exp(1000)", "a < exp(1000) + exp(-30)", "a > exp(1000) + exp(-29)", "b < x"',
    ],
)
def test_a_point_that_only_seems_to_be_one_is_none(given: str) -> None:
    page = (
        f'title = "t"\n[contexts.c]\nvariables = "a b x"\ngiven = [{given}]\n[rows]\nr = "a = a"\n'
    )
    with pytest.raises(InputError, match=r"contradict each other|no point was found"):
        read_page_of("a.toml", page.encode(), {})


def test_a_short_time_is_told() -> None:
    with pytest.raises(InputError, match="write a longer --time, or one, as"):
        read_page_of("a.toml", hopeless(), {}, 0.01)
    with pytest.raises(InputError, match="write one, as"):
        read_page_of("a.toml", hopeless(), {}, None)


def test_equations_are_solved_once_for_the_same_values() -> None:
    """Forty times twelve linear equations took seven seconds, whatever --time said."""
    names = [f"x{k}" for k in range(12)]
    given = [f"x{k} + {k + 2}*x{(k + 1) % 12} - x{(k + 3) % 12}/7 = {k}" for k in range(len(names))]
    body = f"variables = {names}\ngiven = {given}\n".replace("'", '"')
    text = 'title = "t"\n' + "".join(
        f'[contexts.c{i}]\n{body}[contexts.c{i}.rows]\nr{i} = "x0 <= {i}"\n' for i in range(40)
    )

    def read() -> str:
        with pytest.raises(InputError) as error:
            read_page_of("a.toml", text.encode(), {}, 1)
        return str(error.value)

    seconds, said = seconds_of(read)
    assert "write a longer --time, or one, as" in said
    assert seconds < 4


def test_high_powers_are_counted_where_claims_are_looked_at() -> None:
    """2 500 of them took a minute and more, whatever --time said."""
    given = [f"(x + y)^{900 + i % 99} = (x - {i})^999" for i in range(400)]
    text = f'title = "t"\n[contexts.o]\nvariables = "x y"\ngiven = {given}\n'.replace("'", '"')

    def read() -> str:
        with pytest.raises(InputError) as error:
            read_page_of("a.toml", f'{text}[rows]\na = "x >= 0"\n'.encode(), {}, 1)
        return str(error.value)

    seconds, said = seconds_of(read)
    assert "no point was found" in said
    assert seconds < 4


def test_without_givens_any_point_will_do() -> None:
    text = "".join(f'[contexts.a{i}]\nvariables = "x y z u v w"\n' for i in range(1000))
    page = read_page_of("a.toml", f'title = "t"\n{text}[rows]\nr = "1 < 2"\n'.encode(), {}, 0.1)
    assert all(set(context.point.values()) == {as_term(1)} for context in page.statement.contexts)
