"""Random statements of every kind, decided as `verify prove` does it, against an oracle.

Contexts, constants, givens, equations, minima, quotients, roots, cosines and powers, with equality
often. What is proved holds at all the points that are tried, at 2000 bits; what is refuted fails at
its witness; nothing that the search claims is refused by the checker, and no search fails. The
suite takes some statements; ``STATEMENT_FIRST`` and ``STATEMENT_ROUNDS`` choose others, and
``STATEMENT_WORK`` the work for each row.
"""

from __future__ import annotations

import os
import random
from collections.abc import Iterator, Mapping
from fractions import Fraction

import mpmath
import pytest

from tests.prover.test_oracle import CONTEXT, TINY, Generator, holds, value
from verify.language.errors import OwnError
from verify.language.statement import (
    NEEDED,
    PROVED,
    REFUTED,
    UNDECIDED,
    Constant,
    Context,
    Given,
    Obligation,
    Statement,
    Variable,
)
from verify.language.terms import Claim, Term, as_term, cos_pi, maximum, minimum, sqrt, symbol
from verify.prover import techniques
from verify.prover.budget import WorkBudget
from verify.prover.outcome import Outcome
from verify.prover.rules import Interval
from verify.prover.techniques import Technique
from verify.wire.questions import decide

FIRST = int(os.environ.get("STATEMENT_FIRST", "0"))
ROUNDS = int(os.environ.get("STATEMENT_ROUNDS", "60"))
#: Seeds of statements that once had a wrong verdict, or none because of an error.
FOUND: tuple[int, ...] = (
    1168,
    1484,
    1612,
    1839,
    1951,
    3859,
    8977,
    19322,
    20099,
    21129,
    60676,
    406001,
    710788,
)
#: Little work, so that many statements are decided in a minute.
WORK, SECONDS = int(os.environ.get("STATEMENT_WORK", "200000")), 5
POINTS = 24
#: What is added to larger numbers may be lost.
LARGE = CONTEXT.mpf(2) ** 1000

Values = dict[str, mpmath.mpf]


class Statements(Generator):
    """Random statements: constants, a context with givens around a point, and rows."""

    def __init__(self, seed: int) -> None:
        super().__init__(seed)
        self.values: Values = {}

    def small(self) -> Fraction:
        r = self.random
        return Fraction(r.choice((0, 0, 1, 1, 2, 3, 4, -1, -2, -3)), r.choice((1, 1, 1, 2, 3, 5)))

    def number(self) -> Term:
        r = self.random
        if r.random() < 0.03:
            return as_term(self.small() * Fraction(10) ** r.choice((-9, -4, 4, 9)))
        return as_term(self.small())

    def term(self, depth: int) -> Term:  # noqa: C901
        r = self.random
        if depth == 0:
            known = bool(self.names) and r.random() < 0.7
            return symbol(r.choice(self.names)) if known else self.number()
        a, b = self.term(depth - 1), self.term(r.randrange(depth))
        match r.randrange(14):
            case 0 | 1 | 2:
                return a + b
            case 3 | 4:
                return a - b
            case 5 | 6:
                return a * b
            case 7:
                return a / b
            case 8:
                return a ** r.choice((2, 2, 3, 4, 7))
            case 9:
                return sqrt(a)
            case 10:
                return minimum(a, b) if r.random() < 0.5 else maximum(a, b, self.term(0))
            case 11:
                return cos_pi(a)
            case 12:
                return sqrt(a**2) if r.random() < 0.5 else cos_pi(self.number())
        return -a

    def compared(self) -> Claim:
        """A claim, with sides that are related in half of the cases."""
        r, relation = self.random, self.random.choice(("<", "<", "<=", "<=", "<=", "="))
        a, b, c = self.term(r.randrange(3)), self.term(1), self.term(0)
        match r.randrange(10):
            case 0:
                return Claim(relation, (a + c) ** 2, a**2 + 2 * a * c + c**2)
            case 1:
                return Claim(relation, a * b, (a**2 + b**2) / 2)
            case 2:
                return Claim(relation, minimum(a, b), a)
            case 3:
                return Claim(relation, a, a + as_term(Fraction(1, 10 ** r.randrange(1, 20))))
            case 4:
                return Claim(relation, a, a)
            case 5:
                return Claim(relation, c * a, c * b)
        return Claim(relation, a, self.term(2))

    def constants(self) -> Iterator[Constant]:
        """Numbers with names, which have values."""
        for i in range(self.random.choice((0, 0, 1, 2))):
            term = self.term(2)
            found = at(term, self.values)
            if found is not None:
                self.values[f"k{i}"] = found
                yield Constant(f"k{i}", f"k{i}", f"k{i}", "", term)
                self.names.append(f"k{i}")

    def context(self) -> tuple[Context, dict[str, tuple[Fraction | None, Fraction | None]]]:
        """Variables between some numbers or none, a point, and givens that hold there."""
        r = self.random
        names = ["x", "y"][: r.choice((1, 1, 1, 2))]
        givens, point, ends = [], {}, {}
        for name in names:
            low, width = self.small(), abs(self.small())
            has_low, has_high = r.random() < 0.75, r.random() < 0.6
            relation = "<" if width and r.random() < 0.3 else "<="
            if has_low:
                givens.append(Given(f"{name}-low", Claim(relation, as_term(low), symbol(name))))
            if has_high:
                high = as_term(low + width)
                givens.append(Given(f"{name}-high", Claim(relation, symbol(name), high)))
            point[name] = low + width / 2 + (0 if has_high or relation == "<=" else 1)
            if has_low and not has_high and relation == "<":
                point[name] = low + width / 2 + 1
            ends[name] = (low if has_low else None, low + width if has_high else None)
        self.names += names
        places = {**self.values, **{n: number(v) for n, v in point.items()}}
        for i in range(r.choice((0, 0, 0, 1, 2))):
            claim = self.compared()
            if claim.relation != "=" and truth(claim, places):
                givens.append(Given(f"given-{i}", claim))
        variables = tuple(Variable(name, name, name) for name in names)
        at_point = {name: as_term(v) for name, v in point.items()}
        return Context("all", variables, tuple(givens), at_point), ends


def number(value: Fraction) -> mpmath.mpf:
    return CONTEXT.mpf(value.numerator) / value.denominator


def at(term: Term, names: Values) -> mpmath.mpf | None:
    """The value of a term; None where it has none, or where that is open."""
    try:
        return value(term, names)
    except (ZeroDivisionError, ValueError, OverflowError):
        return None


def truth(claim: Claim, names: Values) -> bool | None:
    """Whether a claim holds at a point; None where it says nothing, or that is open."""
    a, b = at(claim.lhs, names), at(claim.rhs, names)
    if a is None or b is None:
        return None
    size = max(abs(a), abs(b), 1)
    is_less = claim.relation == "<"
    if abs(a - b) <= TINY * size and (size > LARGE or (is_less and a != b)):
        return None
    return holds(claim.relation, a, b)


def random_statement(
    seed: int, kind: type[Statements] = Statements
) -> tuple[Statement, Values, dict[str, tuple[Fraction | None, Fraction | None]]]:
    """A statement, the values of its constants, and the ends of its variables."""
    made = kind(seed)
    constants = tuple(made.constants())
    known = [*made.names]
    context, ends = made.context()
    rows = [
        Obligation(f"row{i}", "", "", NEEDED, "", made.compared(), context="all")
        for i in range(made.random.choice((1, 2, 3)))
    ]
    made.names = known
    rows.append(Obligation("ground", "", "", NEEDED, "", made.compared()))
    title = f"seed {seed}"
    return Statement("random", title, {}, constants, (context,), tuple(rows), ()), made.values, ends


def points(
    context: Context,
    ends: Mapping[str, tuple[Fraction | None, Fraction | None]],
    constants: Values,
    seed: int,
) -> Iterator[Values]:
    """Points at which the givens hold: that of the context, ends, and others."""
    r = random.Random(-seed)
    places = [{name: term.value for name, term in context.point.items()}]
    for _ in range(POINTS):
        place = {}
        for name, (low, high) in ends.items():
            far = Fraction(r.choice((1, 2, 10, 1000)))
            first = low if low is not None else (high or 0) - far
            last = high if high is not None else first + 2 * far
            share = r.choice((0, 1, Fraction(1, 2), Fraction(r.randrange(1000), 1000)))
            place[name] = first + (last - first) * share
        places.append(place)
    for place in places:
        values = {**constants, **{name: number(v) for name, v in place.items()}}
        if all(truth(given.claim, values) for given in context.givens):
            yield values


def _named(place: Values, context: str) -> Values:
    """The values, also under the names of a context that shows that givens are defined."""
    return place | {f"{context}.{name}": value for name, value in place.items()}


def wrong(seed: int, kind: type[Statements] = Statements) -> tuple[str, Outcome]:
    """What is wrong with the outcome of a random statement, or nothing."""
    statement, constants, ends = random_statement(seed, kind)
    outcome = decide(statement, WorkBudget(WORK, SECONDS))
    places = [*points(statement.contexts[0], ends, constants, seed)]
    for row, found in outcome.rows:
        if "search failed" in found.reason:
            return f"{row.name}: {found.reason}", outcome
        here = [_named(place, row.context) for place in places] if row.context else [constants]
        if found.verdict == PROVED and any(truth(row.claim, p) is False for p in here):
            return f"{row.name} is proved, and false", outcome
        if found.verdict == REFUTED and found.method != "witness":
            if any(truth(row.claim, place) for place in here):
                return f"{row.name} is refuted everywhere, and true somewhere", outcome
        elif found.verdict == REFUTED:
            values = {**constants, **{n: at(t, constants) for n, t in found.witness.items()}}
            if truth(row.claim, values) is True:
                return f"{row.name} is refuted, and true", outcome
            givens = statement.contexts[0].givens if row.context else ()
            if any(truth(given.claim, values) is False for given in givens):
                return f"{row.name} is refuted where a given is false", outcome
    return ("the search failed" if "search failed" in outcome.spent else ""), outcome


@pytest.mark.parametrize("seed", sorted({*range(FIRST, FIRST + ROUNDS), *FOUND}))
def test_a_random_statement(seed: int) -> None:
    assert wrong(seed)[0] == ""


def test_many_rows_are_decided() -> None:
    decisions = [d for seed in range(40) for d in wrong(seed)[1].decisions.values()]
    verdicts = [decision.verdict for decision in decisions]
    assert verdicts.count(UNDECIDED) < len(verdicts) * 2 // 3
    assert {PROVED, REFUTED} <= {*verdicts}
    assert {"interval", "sum", "witness"} <= {decision.method for decision in decisions}


def test_a_lie_is_noticed(monkeypatch: pytest.MonkeyPatch) -> None:
    honest = decide
    opposite = {PROVED: REFUTED, REFUTED: PROVED, UNDECIDED: UNDECIDED}

    def lies(statement: Statement, budget: WorkBudget) -> Outcome:
        outcome = honest(statement, budget)
        decisions = {
            name: found._replace(judged=found.judged._replace(verdict=opposite[found.verdict]))
            for name, found in outcome.decisions.items()
            if found.judged
        }
        return outcome._replace(decisions={**outcome.decisions, **decisions})

    monkeypatch.setattr(f"{__name__}.decide", lies)
    said = [wrong(seed)[0] for seed in range(20)]
    assert any("is proved, and false" in words for words in said)
    assert any("is refuted" in words for words in said)


def test_a_search_that_fails_is_noticed(monkeypatch: pytest.MonkeyPatch) -> None:
    def fails(*_: object) -> None:
        raise ValueError("an empty sequence")

    monkeypatch.setattr("verify.prover.rows_in_contexts.RowsInContexts.decide", fails)
    said = [wrong(seed)[0] for seed in range(10)]
    assert any("the search failed: ValueError: an empty sequence" in words for words in said)


def test_a_refused_proof_is_noticed(monkeypatch: pytest.MonkeyPatch) -> None:
    refused = Technique("interval", lambda _: Interval(64, ()))
    monkeypatch.setattr(techniques, "FREE", (*techniques.FREE[:1], refused))
    with pytest.raises(OwnError, match="does not accept"):
        list(map(wrong, range(20)))
