"""True givens that a claim does not need make it harder by a bounded amount, never undecided.

Fifty proved rows of the published collections, of pages and of this test get 1, 5 and 20 more
givens each, drawn at random and true at the point. The suite takes some of them; with ``HEAVY=all``
all. Rows that only signs of derivatives show are left out: the rule for them asks that each given
on the variable bounds it, so that a certificate may not ignore one.
"""

from __future__ import annotations

import json
import math
import os
import random
from collections.abc import Sequence
from pathlib import Path
from typing import Any

import pytest

from tests.prover.test_missing import outcome
from verify.language.statement import Context, Given, Statement
from verify.language.terms import as_term, symbol
from verify.measure.inequalities import entries, question
from verify.prover.budget import WorkBudget
from verify.prover.prove import prove
from verify.prover.search.compiled import estimates
from verify.wire.questions import read_page_of

HERE = Path(__file__).resolve().parents[2]
COUNTS = (1, 5, 20)
HEAVY = os.environ.get("HEAVY") == "all"
WORK = 12_000_000

#: Six of these givens are enough for the row, which is a sum of products of four of them.
PAGE = """title = "t"
[contexts.box]
variables = ["r", "b", "c", "y", "e", "T", "Q", "E"]
given = [
  "0<r", "0<b", "0<c", "0<y", "0<e", "0<T",
  "e<=Q*b*y", "r<=b*c*Q*(1-Q)", "2*Q<1", "1-Q<=E*(1-2*Q)", {more}
]
point = {{ r = "3/50", b = "53/100", c = "53/100", Q = "2/5", E = 3, y = 1, e = "1/20", T = 1 }}
[rows]
row = "0 < Q"
"""
#: Proved rows of the two collections with variables, none by a derivative.
NAMES = (
    "lotka-volterra", "crespo1a", "crespo2a", "coq-sqrt-xy", "coq-cubic-half-line", "coq-abs-plus",
    "hol-sum-prod", "hol-chebyshev7", "hol-dodeca-12", "hol-quartic-cone", "hol-sos-1", "hol-sos-2",
    "hol-sos-4", "hol-deg12", "hol-zeng-1", "hol-zeng-2", "hong-2", "yices-nra-06",
    "metitarski-cos-1", "metitarski-cos-2", "metitarski-cos-low", "fly-2485876245a", "fly-TADIAMB",
    "fly-fs867", "fly-fs868", "affine-legendre-upper", "butcher", "camel6-pvs", "crespo3a",
    "cheb12", "hol-sos-6", "hol-sos-9", "hol-deg14", "hol-zeng-4", "hol-zeng-5", "motzkin",
    "robinson", "choi-lam", "nesbitt", "schur-2", "imo-1964-p2", "imo-1983-p6", "imo-1960-p2",
    "qm-am", "minkowski", "vasc", "sineOrder3", "sqrt-sub-lower", "nonlin2-lower", "minmax-median",
)  # fmt: skip


def asked(name: str) -> Statement:
    holdout: list[dict[str, Any]] = json.loads((Path(__file__).parent / "holdout.json").read_text())
    return question(next(e for e in (*entries(), *holdout) if e["name"] == name))


def drawn(context: Context, count: int, seed: str) -> tuple[Given, ...]:
    """Givens about the variables of a context that are true at its point."""
    draw, found = random.Random(seed), []
    names = [variable.name for variable in context.variables]
    while len(found) < count:
        side = as_term(0)
        for _ in range(draw.randint(1, 3)):
            term = as_term(draw.choice((1, 2, -1, 3)))
            for name in draw.choices(names, k=draw.randint(1, 3)):
                term = term * symbol(name)
            side = side + term
        value = estimates([], [side], context.point)()[0]
        bound = as_term(math.ceil(value) + draw.randint(1, 9))
        found.append(Given(f"extra.{len(found)}", side <= bound))
    return tuple(found)


def with_more(statement: Statement, more: Sequence[Given]) -> Statement:
    (context,) = statement.contexts
    return statement._replace(contexts=(context._replace(givens=(*more, *context.givens)),))


CHOSEN = [(name, count) for name in NAMES for count in COUNTS]


def test_there_are_fifty() -> None:
    assert len(NAMES) == len({*NAMES}) == 50


@pytest.mark.parametrize(("name", "count"), CHOSEN if HEAVY else CHOSEN[::8])
def test_a_proved_row_stays_proved(name: str, count: int) -> None:
    statement = asked(name)
    more = drawn(statement.contexts[0], count, f"{name} {count}")
    found = prove(with_more(statement, more), budget=WorkBudget(WORK))
    assert found.decisions["claim"].claimed == "proved"


MORE = ("r*b<=7", "b^2<=7+e", "e*y<=9", "r+b+c+y+e+T<=100", "c*y*T<=20", "E<=9", "r<=b+9")


@pytest.mark.parametrize("count", [0, 1, 5, 7])
def test_ten_givens_of_which_six_are_enough(count: int) -> None:
    more = ", ".join(f'"{given}"' for given in MORE[:count])
    assert outcome(PAGE.format(more=more)).verdict == "proved"


def test_using_restricts_givens_too() -> None:
    text = 'title = "t"\n[contexts.box]\nvariables = ["x", "y"]\n'
    text += 'given = { a = "x + y <= 1", b = "0 <= x - y", c = "y >= 1/4 - x" }\n'
    text += 'point = { x = "1/2", y = "1/4" }\n'
    text += '[rows]\nrow = { claim = "y <= 1/2", using = ["a", "b"] }\n'
    page = read_page_of("a.toml", text.encode(), {})
    found = prove(page.statement, budget=WorkBudget(WORK), hints=page.hints)
    proof = found.decisions["row"].proof
    assert found.decisions["row"].claimed == "proved"
    assert "'c'" not in repr(proof)
