"""The checker's intervals contain the values: true claims pass, and false ones never do."""

from __future__ import annotations

import tempfile
from fractions import Fraction
from pathlib import Path
from typing import Any

import mpmath
import pytest
from hypothesis import assume, example, given, settings
from hypothesis import strategies as st

from tests.lies.small import Json, pack, real, run, write
from tests.lies.small import value as apply

EVERYTHING = ["-1e9999", "1e9999"]
PRECISIONS = (64, 512, 8192, 32768)
DIGITS = 60
ordered = settings(derandomize=True, deadline=None, max_examples=60)

small = st.fractions(-8, 8, max_denominator=50)
nasty = st.sampled_from(["0", "1", "-1", "1" + "0" * 300, "1/1" + "0" * 300, "-1/1" + "0" * 300])
near = st.builds(lambda q, s: q + Fraction(s, 10**50), small, st.sampled_from([-1, 1]))
leaves = st.one_of(small.map(str), small.map(str), near.map(str), nasty)


def grow(terms: st.SearchStrategy[Json]) -> st.SearchStrategy[Json]:
    """Operations on terms."""
    return st.one_of(
        st.tuples(st.sampled_from(["add", "sub", "mul", "div"]), terms, terms).map(list),
        st.tuples(st.sampled_from(["neg", "sqrt", "cos", "cos_pi"]), terms).map(list),
        st.lists(terms, min_size=2, max_size=3).flatmap(
            lambda args: st.sampled_from(["min", "max"]).map(lambda op: [op, *args])
        ),
        st.tuples(st.just("pow"), terms, st.sampled_from(["1", "2", "3"])).map(list),
    )


class Undefined(Exception):  # noqa: N818
    """The term has no value, or a cosine is taken beyond 8."""


def evaluate(term: Json) -> Any:
    """The value: a fraction, or a number of mpmath that is not suspiciously close to nothing."""
    if isinstance(term, str):
        return Fraction(term)
    op, *rest = term
    if op == "pow":
        return evaluate(rest[0]) ** int(rest[1])
    args = [evaluate(arg) for arg in rest]
    irrational = [arg for arg in args if not isinstance(arg, Fraction)]
    if any(abs(arg) < mpmath.mpf(10) ** -1500 for arg in irrational):
        assume(False)
    last = args[-1]
    if (
        (op == "div" and last == 0)
        or (op == "sqrt" and last < 0)
        or (op == "cos" and abs(last) > 8)
    ):
        raise Undefined
    names = {f"arg{i}": arg for i, arg in enumerate(args)}
    return apply([op, *names], names)


def truth(term: Json) -> Any:
    """The value, where two precisions agree on it."""
    values = []
    for digits in (2000, 4000):
        with mpmath.workdps(digits):
            values.append(evaluate(term))
    first, second = values
    if not isinstance(first, Fraction):
        with mpmath.workdps(4000):
            assume(abs(second) > mpmath.mpf(10) ** -1500)
            assume(abs(first - second) < abs(second) * mpmath.mpf(10) ** -200)
    return second


def between(number: Any) -> tuple[Fraction, Fraction]:
    """Rationals close below and above a number."""
    if number == 0:
        return Fraction(-1, 10**DIGITS), Fraction(1, 10**DIGITS)
    with mpmath.workdps(4000):
        exponent = int(mpmath.floor(mpmath.log10(abs(real(number)))))
        assume(abs(exponent) < 3500)
        unit = Fraction(10) ** (exponent - DIGITS)
        middle = int(mpmath.nint(real(number) / real(unit)))
    return (middle - 1) * unit, (middle + 1) * unit


def verdicts(claims: list[Json], bits: int, rule: str = "interval") -> list[bool]:
    """Which claims are proved."""
    statement = {
        "format": "verify-statement/1",
        "theorem": "",
        "title": "",
        "parameters": {},
        "constants": [],
        "obligations": [
            {
                "name": f"o{i}",
                "label": "",
                "role": "printed",
                "says": "",
                "claim": claim,
                "uses": [],
                "variables": {},
            }
            for i, claim in enumerate(claims)
        ],
        "assumptions": [],
    }
    sides = {"lhs": EVERYTHING, "rhs": EVERYTHING}
    proofs = [
        {"obligation": f"o{i}", "rule": rule, "bits": bits, **sides} for i in range(len(claims))
    ]
    certificate = {"format": "verify-certificate/1", "enclosures": {}, "proofs": proofs}
    with tempfile.TemporaryDirectory() as folder:
        code, lines, errors = run(write(Path(folder), pack(statement, certificate)))
    assert code in (0, 1), lines
    assert errors == ""
    result = [line.startswith("proved") for line in lines[:-1]]
    assert len(result) == len(claims)
    assert lines[-1] == ("PROVED" if all(result) else "NOT PROVED")
    return result


def claims_about(term: Json) -> tuple[list[Json], list[Json]]:
    """Narrow claims about a term that are true, and some that are false."""
    low, high = map(str, between(truth(term)))
    true = [["<", term, high], ["<=", low, term], ["not", ["<=", term, low]]]
    false = [["<", high, term], ["<=", term, low], ["=", term, low], ["not", ["<", term, high]]]
    return true, false


@given(st.recursive(leaves, grow, max_leaves=6))
@example(["sub", ["add", "1" + "0" * 300, "1/3"], "1" + "0" * 300])
@example(["cos_pi", "1" + "0" * 300])
@example(["cos_pi", "-7/2"])
@example(["cos", "8"])
@example(["cos", "-8"])
@example(["cos", "0"])
@example(["sqrt", "1/1" + "0" * 300])
@example(["sqrt", "0"])
@example(["pow", "-5/3", "3"])
@example(["pow", ["neg", ["sqrt", "2"]], "2"])
@example(["mul", ["neg", ["sqrt", "2"]], ["neg", ["sqrt", "3"]]])
@example(["div", "1", ["sub", ["sqrt", "2"], "3/2"]])
@ordered
def test_every_operation(term) -> None:
    if isinstance(term, str):
        return
    try:
        true, false = claims_about(term)
    except Undefined:
        for bits in PRECISIONS[:2]:
            assert not any(verdicts([["<=", term, term], ["not", ["<", term, term]]], bits))
        return
    accepted = [False] * len(true)
    for bits in PRECISIONS:
        found = verdicts(true + false, bits)
        assert not any(found[len(true) :]), f"a false claim is proved at {bits} bits"
        accepted = [a or b for a, b in zip(accepted, found, strict=False)]
        if all(accepted):
            return
    assert all(accepted), "a true claim is not proved"


OPERATIONS = st.sampled_from(["add", "sub", "mul", "div", "min", "max"])


@given(OPERATIONS, leaves, leaves)
@ordered
def test_rational_values_are_exact(op, a, b) -> None:
    term = [op, a, b]
    if op == "div" and Fraction(b) == 0:
        assert not any(verdicts([["=", term, "0"], ["<=", term, term]], 64, "exact"))
        return
    exact = str(evaluate(term))
    claims = [["=", term, exact], ["<=", term, exact], ["<", term, exact], ["<", exact, term]]
    assert verdicts(claims, 64, "exact") == [True, True, False, False]


@given(small, st.integers(1, 10**6), st.integers(2, 400))
@ordered
def test_division_by_an_interval_around_zero(middle, width, bits) -> None:
    root = ["sqrt", str(1 + Fraction(1, width))]
    zero = ["sub", root, root]
    quotient = ["div", str(middle), zero]
    claims = [["<=", quotient, quotient], ["not", ["<", quotient, "0"]], ["=", quotient, "0"]]
    assert not any(verdicts(claims, bits))


@given(small, small, st.integers(2, 64))
@settings(ordered, max_examples=25)
def test_few_bits_never_prove_what_is_false(a, b, bits) -> None:
    cos = ["cos", str(a)]
    _, false = claims_about(["add", cos, ["mul", ["sqrt", str(abs(b))], ["cos_pi", str(b)]]])
    assert not any(verdicts(false, bits))


@pytest.mark.parametrize("bits", [2, 3, 64, 1000])
def test_the_same_term_is_not_below_itself(bits) -> None:
    for term in (["sqrt", "2"], ["cos", "1"], ["cos_pi", "1/7"], ["pow", ["sqrt", "2"], "2"]):
        assert not any(verdicts([["<", term, term], ["not", ["<=", term, term]]], bits))
