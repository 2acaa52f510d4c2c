"""The two files: the checker accepts them, and a second reading of the format agrees."""

from __future__ import annotations

import json
from collections.abc import Callable, Iterator
from fractions import Fraction
from functools import cache
from hashlib import sha256
from typing import Any

import mpmath
import pytest
import sympy

from tests.paper.spectrum.page import with_a_broken_entry
from verify import check
from verify.paper.commands import pages
from verify.prover.outcome import Outcome
from verify.wire.write import write

BITS = 400

Document = dict[str, Any]
Files = tuple[Document, Document]


def cited(files: dict[str, bytes]) -> dict[str, bytes]:
    """The cited statements by their digests, as a folder has them, with their certificates."""
    return {
        name.removeprefix("cited/").removesuffix(".json"): data
        for name, data in files.items()
        if name.startswith("cited/")
    }


@pytest.fixture(scope="module")
def outcome() -> Outcome:
    return pages.decide("spectrum")


@pytest.fixture(scope="module")
def contents(outcome: Outcome) -> dict[str, bytes]:
    return write(outcome)


@pytest.fixture
def documents(contents: dict[str, bytes]) -> Files:
    return json.loads(contents["statement.json"]), json.loads(contents["certificate.json"])


def test_the_checker_accepts_the_certificate(contents: dict[str, bytes]) -> None:
    report = check.check(contents["statement.json"], contents["certificate.json"], cited(contents))
    assert report.verdict == "PROVED", report.lines
    assert "194 needed proved" in report.summary
    assert "9 printed refuted" in report.summary
    assert ", 0 needed undecided, 0 printed undecided" in report.summary


def test_refuted_needed_rows_have_a_certificate_too() -> None:
    files = write(with_a_broken_entry())
    report = check.check(files["statement.json"], files["certificate.json"], cited(files))
    assert report.verdict == "REFUTED", [line for line in report.lines if "REFUSED" in line]


# --- lies ----------------------------------------------------------------------------------------


@cache
def what_it_cites() -> dict[str, bytes]:
    """The statements that the spectrum cites, by their digests."""
    return cited(write(pages.decide("spectrum")))


class Lie:
    """The two documents, and in them one row with its proof."""

    def __init__(self, documents: Files, name: str) -> None:
        self.statement, self.certificate = documents
        self.cited = what_it_cites()
        self.row = next(r for r in self.statement["obligations"] if r["name"] == name)
        steps = self.certificate["steps"]
        self.proof = next(step["proof"] for step in steps if step.get("obligation") == name)

    def told(self) -> str:
        """What the checker says of it."""
        data = json.dumps(self.statement).encode()
        self.certificate["statement_sha256"] = sha256(data).hexdigest()
        try:
            return check.check(data, json.dumps(self.certificate).encode(), self.cited).verdict
        except check.Malformed:
            return "MALFORMED"


def wrong_side(lie: Lie) -> None:
    relation, lhs, rhs = lie.row["claim"]
    lie.row["claim"] = [relation, lhs, ["add", rhs, "1/64"]]


def wrong_sign(lie: Lie) -> None:
    relation, lhs, rhs = lie.row["claim"]
    lie.row["claim"] = [relation, rhs, lhs]


def wrong_interval(lie: Lie) -> None:
    context = next(c for c in lie.statement["contexts"] if c["name"] == lie.row["context"])
    for given in context["givens"]:
        if given["name"].endswith("high"):
            given["claim"][2] = "9"


def wrong_context(lie: Lie) -> None:
    lie.row["context"] = "any"


def wrong_point(lie: Lie) -> None:
    lie.proof["at"]["r"] = "1"


def true_point(lie: Lie) -> None:
    lie.proof["at"] |= {f"u_{i}": "0" for i in range(1, 5)}


def missing_value(lie: Lie) -> None:
    del lie.proof["at"]["u_4"]


def missing_addend(lie: Lie) -> None:
    del lie.proof["addends"][-1]


def without_goal(lie: Lie) -> None:
    lie.proof["addends"] = ["0"]


def missing_branch(lie: Lie) -> None:
    del lie.proof["branches"][-1]


def proved_instead(lie: Lie) -> None:
    lie.row["verdict"] = "proved"


def refuted_instead(lie: Lie) -> None:
    lie.row["verdict"] = "refuted"


def left_out(lie: Lie) -> None:
    steps = lie.certificate["steps"]
    lie.certificate["steps"] = [s for s in steps if s.get("obligation") != lie.row["name"]]


def without_lemmas(lie: Lie) -> None:
    steps = lie.certificate["steps"]
    lie.certificate["steps"] = [s for s in steps if s.get("context") != lie.row["context"]]


def test_the_unchanged_row_is_accepted(documents: Files) -> None:
    assert Lie(documents, "characteristic").told() == "PROVED"


@pytest.mark.parametrize(
    ("name", "alter"),
    [
        ("characteristic", wrong_side),
        ("characteristic", wrong_context),
        ("characteristic", refuted_instead),
        ("characteristic", left_out),
        ("Q-factorised", without_lemmas),
        ("matrix", wrong_side),
        ("entry-3-2", wrong_side),
        ("Q-prime-positive", wrong_sign),
        ("Q-prime-positive", without_goal),
        ("q-negative", wrong_sign),
        ("q-negative", wrong_interval),
        ("Q-minus-r-negative", wrong_interval),
        ("m-increasing", wrong_sign),
        ("m-increasing", missing_branch),
        ("matrix-stated", wrong_point),
        ("matrix-stated", true_point),
        ("matrix-stated", missing_value),
        ("matrix-stated", proved_instead),
        ("x-multiple-1", missing_addend),
        ("r_exist-above", wrong_sign),
    ],
)
def test_the_checker_refuses_a_lie(
    documents: Files, name: str, alter: Callable[[Lie], None]
) -> None:
    lie = Lie(documents, name)
    alter(lie)
    assert lie.told() in ("REFUSED", "MALFORMED")


# --- a second reading ----------------------------------------------------------------------------


def test_statement_and_certificate_belong_together(
    contents: dict[str, bytes], documents: Files
) -> None:
    statement, certificate = documents
    assert certificate["statement_sha256"] == sha256(contents["statement.json"]).hexdigest()
    names = [row["name"] for row in statement["obligations"]]
    found = [step["obligation"] for step in certificate["steps"] if "obligation" in step]
    assert found == names
    known = {assumption["name"] for assumption in statement["assumptions"]}
    for row in statement["obligations"]:
        assert set(row["uses"]) <= known
        assert row["verdict"] == "proved" or row["role"] == "printed"


class Reading:
    """Terms of the file, evaluated by the functions of another library."""

    def __init__(
        self, statement: Document, values: dict[str, Any], number: Callable[[Fraction], Any]
    ) -> None:
        self.shared, self.values, self.number = statement["terms"], dict(values), number
        self.root, self.greatest = mpmath.sqrt, max

    def term(self, term: Any) -> Any:
        if isinstance(term, str):
            if term not in self.values:
                known = term in self.shared
                self.values[term] = (
                    self.term(self.shared[term]) if known else self.number(Fraction(term))
                )
            return self.values[term]
        op, *args = term
        if op == "pow":
            return self.term(args[0]) ** int(args[1])
        parts = [self.term(arg) for arg in args]
        if op in ("neg", "sqrt", "max"):
            return {"neg": lambda x: -x, "sqrt": self.root, "max": self.greatest}[op](*parts)
        a, b = parts
        return {"add": a + b, "sub": a - b, "mul": a * b, "div": a / b if op == "div" else 0}[op]


def with_proofs(documents: Files) -> Iterator[tuple[Document, Document]]:
    statement, certificate = documents
    steps = {step["obligation"]: step for step in certificate["steps"] if "obligation" in step}
    for row in statement["obligations"]:
        yield row, steps[row["name"]]["proof"]


def test_identities_hold_at_a_transcendental_point(documents: Files) -> None:
    """Each equation, read from the file, at a point where no false one could hold by chance."""
    statement, _ = documents
    variables = [v["name"] for context in statement["contexts"] for v in context["variables"]]
    count = 0
    with mpmath.workprec(BITS):
        point = {name: mpmath.exp(-mpmath.sqrt(i + 2)) for i, name in enumerate(sorted(variables))}

        def number(value: Fraction) -> mpmath.mpf:
            return mpmath.mpf(value.numerator) / value.denominator

        reading = Reading(statement, point, number)
        for row, proof in with_proofs(documents):
            relation, *sides = row["claim"]
            if relation == "=" and isinstance(proof, dict) and proof["rule"] == "sum":
                a, b = map(reading.term, sides)
                assert abs(a - b) < mpmath.mpf(2) ** (60 - BITS) * (1 + abs(a)), row["name"]
                count += 1
    assert count > 100


def test_sums_are_zero_by_sympy(documents: Files) -> None:
    """The goal and the addends with their facts add up to zero, in every inequality."""
    statement, _ = documents
    contexts = statement["contexts"]
    names = {v["name"]: sympy.Symbol(v["name"]) for c in contexts for v in c["variables"]}
    reading = Reading(statement, names, lambda q: sympy.Rational(q.numerator, q.denominator))
    givens = {given["name"]: given["claim"] for c in contexts for given in c["givens"]}
    count = 0

    def value(item: Any, goal: Any) -> Any:
        if isinstance(item, str):
            if item == "goal":
                return goal
            if item in givens:
                _, lhs, rhs = givens[item]
                return reading.term(rhs) - reading.term(lhs)
            assert Fraction(item) >= 0
            return reading.term(item)
        op, *rest = item
        if op == "pow":
            return value(rest[0], goal) ** int(rest[1])
        parts = [value(part, goal) for part in rest]
        return sympy.Add(*parts) if op == "add" else sympy.Mul(*parts)

    for row, proof in with_proofs(documents):
        relation, lhs, rhs = row["claim"]
        cleared = row["name"] == "existence-below"  # of divisors, which the checker does
        is_sum = isinstance(proof, dict) and proof["rule"] == "sum"
        if relation in ("<", "<=") and is_sum and not cleared:
            goal = reading.term(lhs) - reading.term(rhs)
            total = sum(value(addend, goal) for addend in proof["addends"])
            assert sympy.expand(total) == 0, row["name"]
            count += 1
    assert count > 30
