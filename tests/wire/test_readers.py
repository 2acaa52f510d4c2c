"""Random files of SMT-LIB and FPCore mean what a second reader, and Z3, take them for.

What the package makes of a file is compared where the variables have values: with `naive.py`, which
only evaluates the text, and with the answers and models of Z3. ``READER_FILES`` says how many are
drawn: 200 by default, 1000 in CI.
"""

from __future__ import annotations

import os
import re
from collections import defaultdict
from collections.abc import Iterable, Mapping
from fractions import Fraction
from itertools import islice
from random import Random

import pytest
import z3

from tests.wire import naive
from tests.wire.random_files import Draw
from verify.language.fold import RATIONAL, fold
from verify.language.terms import Claim
from verify.wire.inputs import InputError
from verify.wire.text.conjunctions import Asked, forms
from verify.wire.text.fpcore import read_fpcore
from verify.wire.text.lisp import SMTLIB, Source
from verify.wire.text.points import Points
from verify.wire.text.smtlib import _File

FILES = int(os.environ.get("READER_FILES", "200"))
#: Files are drawn from here on.
FIRST = int(os.environ.get("READER_FIRST", "0"))
#: So many files are one test.
BATCH = 50
VALUES = [Fraction(text) for text in ("-3", "-1", "-2/5", "0", "1/4", "1/3", "1", "2", "10")]
POINTS = 8
#: Files whose reading was wrong before.
ONCE_WRONG: tuple[int, ...] = ()

At = dict[str, Fraction]


def is_true(claim: Claim, at: Mapping[str, Fraction]) -> bool:
    """Whether a claim holds at exact values."""
    algebra = {**RATIONAL, "symbol": lambda name: at[name], "max": max, "min": min}
    a, b = (fold(side, algebra, {}) for side in (claim.lhs, claim.rhs))
    return {"<": a < b, "<=": a <= b, "=": a == b}[claim.relation]


class Reading:
    """A file of SMT-LIB as the package reads it: for each question its cases."""

    def __init__(self, text: str) -> None:
        self.file = _File(Source("f.smt2", text.encode(), SMTLIB))
        self.file.read()
        self.cases: dict[int, list[tuple[Asked, list[Claim]]]] = defaultdict(list)
        for asked, claims in self.file.rows():
            number = int(re.split("[-.]", asked.row)[1])
            self.cases[number].append((asked, claims))

    def values(self, asked: Asked, at: At) -> At:
        """Values by the names of the statement."""
        known = {self.file.names[name.removeprefix("|")]: value for name, value in at.items()}
        names = [variable.name for variable in asked.variables]
        return {name: known[name.removeprefix(f"{asked.context}.")] for name in names}

    def holds(self, number: int, at: At) -> bool:
        """Whether the claims of some case of a question hold."""
        return any(
            all(is_true(claim, self.values(asked, at)) for claim in claims)
            for asked, claims in self.cases[number]
        )


def read(text: str) -> Reading | None:
    """A file as it is read; None if it has too many cases."""
    try:
        return Reading(text)
    except InputError as error:
        assert "cases" in str(error), text  # noqa: PT017
        return None


def points(names: Iterable[str], seed: int) -> list[At]:
    random, known = Random(seed), [*names]
    return [{name: random.choice(VALUES) for name in known} for _ in range(POINTS)]


def batches() -> list[int]:
    return [*range(FIRST, FIRST + FILES, BATCH)]


@pytest.mark.parametrize("first", batches())
def test_files_of_smtlib_mean_what_they_say(first: int) -> None:
    compared = 0
    for seed in (*range(first, first + BATCH), *(ONCE_WRONG if first == FIRST else ())):
        text = Draw(seed).smtlib()
        reading = read(text)
        if reading is None:
            continue
        asked = naive.Session(text).asked
        assert len(asked) == len(reading.file.questions), text
        for number, (names, asserted) in enumerate(asked, 1):
            for at in points(names, seed):
                assert reading.holds(number, at) == naive.holds(asserted, at), (seed, at, text)
                compared += 1
    assert compared > BATCH


@pytest.mark.parametrize("first", batches()[::10])
def test_each_form_of_a_row_says_the_same(first: int) -> None:
    compared = 0
    for seed in range(first, first + BATCH):
        reading = read(Draw(seed).smtlib())
        for number, cases in reading.cases.items() if reading else ():
            for asked, claims in cases:
                for context, row in islice(forms(asked, claims, reading.file.order, Points()), 2):
                    givens = [] if context is None else [g.claim for g in context.givens]
                    names = [v.name for v in (context.variables if context else ())]
                    for at in points(names, seed + number):
                        if f"{asked.context}.less-" in at:
                            at[f"{asked.context}.less-"] = Fraction(1, 10**30)
                        rest = all(is_true(given, at) for given in givens)
                        assert isinstance(row.claim, Claim)
                        found = rest and not is_true(row.claim, at)
                        wanted = all(is_true(claim, at) for claim in claims)
                        assert found == wanted, (seed, row, context)
                        compared += 1
    assert compared > BATCH


# --- Z3 ------------------------------------------------------------------------------------------


def asked_z3(text: str) -> list[tuple[str, At]] | None:
    """What Z3 answers to each question, with a rational model; None if it refuses the file."""
    lines = []
    for part in re.split(r"(\(check-sat\))", text):
        lines.append(part)
        if part == "(check-sat)":
            lines.append("(get-model)")
    asked = "(set-option :timeout 300)" + "".join(lines)
    context = z3.Context()
    try:
        said = z3.Z3_eval_smtlib2_string(context.ref(), asked)
    except z3.Z3Exception:
        return None
    answers: list[tuple[str, At]] = []
    for tree in naive.trees(said):
        if tree in ("sat", "unsat", "unknown", "timeout"):
            answers.append((tree, {}))
        elif tree[:1] == ["error"]:
            if "model is not available" not in tree[1]:
                return None
        else:
            answers[-1][1].update(model_of(tree))
    return answers


def model_of(tree: list[object]) -> At:
    """The rational numbers in a model."""
    found = {}
    for part in tree:
        if isinstance(part, list) and part[1:3] == [[], "Real"]:
            part.insert(1, "|")  # Z3 prints nothing for the name of no letters
        if isinstance(part, list) and part[:1] == ["define-fun"] and part[2:4] == [[], "Real"]:
            try:
                found[naive.name_of(part[1])] = Fraction(naive.evaluate(part[4], {}))
            except (KeyError, ValueError):  # an algebraic number
                return {}
    return found


@pytest.mark.parametrize("first", batches()[::2])
def test_z3_reads_the_same(first: int) -> None:
    answered = models = 0
    for seed in range(first, first + BATCH):
        text = Draw(seed).smtlib()
        reading, answers = read(text), asked_z3(text)
        if reading is None or answers is None:
            continue
        asked = naive.Session(text).asked
        assert len(answers) == len(asked), (seed, text)
        for number, ((names, _), (answer, model)) in enumerate(zip(asked, answers, strict=True), 1):
            answered += answer in ("sat", "unsat")
            if answer == "unsat":
                at = next((p for p in points(names, seed) if reading.holds(number, p)), None)
                assert at is None, (seed, at, text)
            elif answer == "sat" and model:
                at = {name: model.get(name, Fraction(0)) for name in names}
                assert reading.holds(number, at), (seed, at, text)
                models += 1
    assert answered > BATCH // 4
    assert models > BATCH // 10


# --- FPCore --------------------------------------------------------------------------------------


@pytest.mark.parametrize("first", batches()[::5])
def test_files_of_fpcore_mean_what_they_say(first: int) -> None:
    compared = 0
    for seed in range(first, first + BATCH // 2):
        text = Draw(seed, fpcore=True).fpcores()
        statement = read_fpcore("f.fpcore", text.encode())
        for context, (inputs, pre, body) in zip(statement.contexts, naive.core(text), strict=True):
            row = next(row for row in statement.obligations if row.context == context.name)
            names = [variable.name for variable in context.variables]
            assert len({*names}) == len(inputs)
            for values in points(inputs, seed):
                at = dict(zip(names, values.values(), strict=True))
                given = all(is_true(one.claim, at) for one in context.givens)
                assert given == naive.evaluate(pre, dict(values)), (seed, values, text)
                assert isinstance(row.claim, Claim)
                algebra = {**RATIONAL, "symbol": at.get, "max": max, "min": min}
                assert not context.constants
                value = fold(row.claim.rhs, algebra, {})
                assert value == naive.evaluate(body, dict(values)), (seed, values, text)
                compared += 1
    assert compared > BATCH
