"""The guess of points: a limit of time leaves it less work."""

from __future__ import annotations

from random import Random

import pytest

from verify.prover.budget import WorkBudget
from verify.wire.inputs import InputError
from verify.wire.questions import read_page_of
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
