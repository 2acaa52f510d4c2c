"""Claims for all values in a context: what is found, near misses, and what stays undecided.

Whatever is decided here is written down, accepted by the checker, and read back unchanged.
"""

from __future__ import annotations

from fractions import Fraction

import pytest
from flint import Ordering, fmpq_mpoly_ctx

from verify import check
from verify.language.statement import (
    NEEDED,
    PROVED,
    REFUTED,
    UNDECIDED,
    Applies,
    Constant,
    Context,
    Given,
    Obligation,
    Statement,
    Variable,
)
from verify.language.terms import (
    Claim,
    Term,
    as_term,
    equal,
    maximum,
    minimum,
    sqrt,
    symbol,
)
from verify.prover.balls import fraction_of
from verify.prover.bernstein import Tensor
from verify.prover.outcome import Decision, Outcome
from verify.prover.prove import prove
from verify.prover.rules import Cuts, Witness
from verify.wire.read import read
from verify.wire.write import write

#: x and y are any numbers, r and k lie in (0, 1), a in [0, oo[, p in ]0, oo[, q in [-1, oo[.
x, y, r, k, a, p, q = (symbol(name) for name in "xyrkapq")
TINY = Fraction(1, 10**30)
HALF = Fraction(1, 2)

GIVENS = {
    "r.low": 0 < r,
    "r.high": r < as_term(1),
    "k.low": 0 < k,
    "k.high": k < as_term(1),
    "a.low": as_term(0) <= a,
    "p.low": 0 < p,
    "q.low": as_term(-1) <= q,
}
POINT = {"x": 0, "y": 0, "r": HALF, "k": HALF, "a": 0, "p": 1, "q": 0}


def context(
    givens: dict[str, Claim], point: dict[str, int | Fraction], name: str = "all"
) -> Context:
    return Context(
        name,
        tuple(Variable(v, v, v) for v in point),
        tuple(Given(given, claim) for given, claim in givens.items()),
        {v: as_term(value) for v, value in point.items()},
    )


def row(claim: Claim | Applies, within: str | None = "all", name: str = "row") -> Obligation:
    return Obligation(name, "", "", NEEDED, "", claim, context=within)


def statement(*rows: Obligation, contexts: tuple[Context, ...] = ()) -> Statement:
    contexts = contexts or (context(GIVENS, POINT),)
    return Statement("test", "test", {}, (), contexts, rows, ())


def checked(stated: Statement) -> Outcome:
    """The outcome, after the checker has accepted it, if nothing is undecided."""
    outcome = prove(stated)
    if outcome.claimed != UNDECIDED:
        files = write(outcome)
        report = check.check(files["statement.json"], files["certificate.json"], {})
        assert report.verdict.lower() == outcome.claimed, report.lines
        assert read(files["statement.json"], files["certificate.json"], {}) == outcome.draft
    return outcome


def decide(claim: Claim) -> Decision:
    return checked(statement(row(claim))).decisions["row"]


@pytest.mark.parametrize(
    ("claim", "expected"),
    [
        (equal((x + y) ** 2, x**2 + 2 * x * y + y**2), (PROVED, "sum")),
        (equal((x + y) ** 2, x**2 + (2 + TINY) * x * y + y**2), (REFUTED, "witness")),
        ((x + y) ** 2 <= x**2 + 2 * x * y + y**2, (PROVED, "sum")),
        ((x + y) ** 2 < x**2 + 2 * x * y + y**2, (REFUTED, "witness")),
        (equal(sqrt(3) * x * sqrt(3), 3 * x), (PROVED, "sum")),
        (equal(sqrt(3) * x * sqrt(3), (3 + TINY) * x), (REFUTED, "witness")),
        (equal(r / (1 + r) + 1 / (1 + r), 1), (PROVED, "sum")),
        (equal(r / (1 + r) + 1 / (1 + r), 1 + TINY), (REFUTED, "witness")),
        (equal(1 / (r * (r - 2)) * (2 - r), -1 / r), (PROVED, "sum")),
        (equal(x / x, 1), (UNDECIDED, "")),
        (equal(x / 0, x / 0), (UNDECIDED, "")),
        (as_term(0) / (r - r) <= as_term(0), (UNDECIDED, "")),
        (equal(sqrt(1 + x**2) ** 2, 1 + x**2), (PROVED, "sum")),
        (equal(sqrt(x) ** 2, x), (UNDECIDED, "")),
        (equal(sqrt(p) ** 2, p), (PROVED, "sum")),
        (equal(sqrt(a) ** 2, a), (PROVED, "sum")),
        (0 < r * (1 - r), (PROVED, "sum")),
        (0 < r * (1 - TINY - r), (UNDECIDED, "")),
        (0 < r / (1 + r), (PROVED, "sum")),
        (r**2 < r, (PROVED, "sum")),
        (r < r**2, (REFUTED, "witness")),
        ((2 * r - 1) ** 2 <= as_term(1), (PROVED, "interval")),
        (0 < (2 * r - 1) ** 2 + TINY, (PROVED, "interval")),
        (0 < 4 * r**2 - 4 * r + 1 + Fraction(1, 20), (PROVED, "sum")),
        (0 < 4 * r**2 - 4 * r + 1 + TINY, (PROVED, "sum")),
        (0 < (2 * r - 1) ** 2, (REFUTED, "witness")),
        (0 <= (2 * r - 1) ** 2 - Fraction(1, 100), (REFUTED, "witness")),
        (0 < 1 + r * k, (PROVED, "interval")),
        (r * k - r - k < Fraction(1, 8), (PROVED, "cuts")),
        (r * k - r - k < as_term(0), (PROVED, "sum")),
        (1 < 1 + r * k, (PROVED, "sum")),
        (maximum(r, k) < as_term(2), (PROVED, "interval")),
        (maximum(r, k) < as_term(HALF), (REFUTED, "witness")),
        (minimum(r, x) <= x, (PROVED, "entry")),
        (minimum(r, x) < x, (REFUTED, "witness")),
        (x <= minimum(r, x), (REFUTED, "witness")),
        (x <= maximum(r, x, k), (PROVED, "entry")),
        (0 < minimum(p, 1 + x**2), (PROVED, "least")),
        (0 < minimum(p, x**2), (REFUTED, "witness")),
        (maximum(r, r * r) <= r, (PROVED, "least")),
        (maximum(-p, r - 1) < as_term(0), (PROVED, "least")),
        (maximum(r - 1, -1 - x**2) < as_term(0), (PROVED, "least")),
    ],
)
def test_verdicts(claim: Claim, expected: tuple[str, str]) -> None:
    found = decide(claim)
    assert (found.claimed, found.method) == expected


@pytest.mark.parametrize(
    ("claim", "expected"),
    [
        (0 < p + a, PROVED),
        (0 < a, REFUTED),
        (0 <= a * p + x**2, PROVED),
        (0 < a * p + x**2, REFUTED),
        (0 < p**3 / 2 + x * x, PROVED),
        (0 < 1 + (x - y) ** 4, PROVED),
        (0 <= (x - y) ** 3, REFUTED),
        (0 <= sqrt(p) + a, PROVED),
        (0 < sqrt(p), PROVED),
        (as_term(0) <= sqrt(p), PROVED),
        (as_term(0) <= sqrt(1 + x**2), PROVED),
        (x - x <= Term("cos_pi", as_term(HALF)), PROVED),
        (0 < sqrt(1 + x**2), PROVED),
        (0 < sqrt(a), REFUTED),
        (0 <= sqrt(p) / p, PROVED),
        (0 < q, REFUTED),
        (0 <= q + 2, PROVED),
        (0 < (p + 1) / 3, PROVED),
        (0 < (p - 1) / -3, REFUTED),
    ],
)
def test_signs_without_upper_bounds(claim: Claim, expected: str) -> None:
    assert decide(claim).claimed == expected


@pytest.mark.parametrize(
    ("claim", "expected"),
    [
        (equal(as_term(2) * 3, 6), PROVED),
        (equal(as_term(2) * 3, 6 + TINY), REFUTED),
        (sqrt(3) < as_term(2), PROVED),
        (equal(sqrt(3) * sqrt(3), 3), PROVED),
        (sqrt(3) * sqrt(3) <= as_term(3), PROVED),
        (equal(sqrt(3) * sqrt(3), 3 + TINY), REFUTED),
        (sqrt(as_term(-1)) < as_term(3), UNDECIDED),
        (equal(as_term(1) / (as_term(2) - 2), 1), UNDECIDED),
        (equal(as_term(1) / 0, as_term(1) / 0), UNDECIDED),
        (as_term(0) * (as_term(1) / 0) <= as_term(0), UNDECIDED),
    ],
)
@pytest.mark.parametrize("within", [None, "all"])
def test_verdicts_without_variables(claim: Claim, expected: str, within: str | None) -> None:
    outcome = prove(statement(row(claim, within)), max_bits=1024)
    assert outcome.decisions["row"].claimed == expected


@pytest.mark.parametrize(
    ("givens", "expected"),
    [
        ({"low": 0 < r, "high": r < as_term(1)}, PROVED),
        ({"low": 0 < r, "high": r <= as_term(1)}, REFUTED),
        ({"low": 0 < r, "high": r < as_term(2)}, REFUTED),
        ({"low": 0 < r, "high": r < as_term(2), "higher": r < as_term(1)}, PROVED),
        ({"low": 0 < r}, REFUTED),
        ({}, REFUTED),
    ],
)
def test_the_interval_matters(givens: dict[str, Claim], expected: str) -> None:
    stated = statement(row(r**2 < r), contexts=(context(givens, {"r": HALF}),))
    found = prove(stated).decisions["row"].claimed
    if expected == PROVED:
        assert found == PROVED
    else:
        assert found != PROVED


def test_a_context_whose_point_is_outside_is_not_opened() -> None:
    """Nothing is proved for all of no numbers."""
    stated = statement(row(r < r), contexts=(context({"r.low": 1 < r}, {"r": 1}),))
    outcome = prove(stated)
    assert outcome.claimed == UNDECIDED
    assert "context all" in outcome.spent


def test_a_claim_that_fails_in_a_corner_alone_is_refuted() -> None:
    givens = {
        "r.low": 0 <= r,
        "r.high": r <= as_term(1),
        "k.low": 0 <= k,
        "k.high": k <= as_term(1),
    }
    corner = context(givens, {"r": HALF, "k": HALF})
    found = checked(statement(row(r * k < as_term(1)), contexts=(corner,))).decisions["row"]
    assert (found.claimed, found.witness) == (REFUTED, {"r": as_term(1), "k": as_term(1)})


@pytest.mark.parametrize(
    ("claim", "expected"),
    [
        (a / (-1 - a) <= as_term(0), PROVED),
        (as_term(0) <= a / (-1 - a), REFUTED),
        (as_term(0) <= r / (-1 - r), REFUTED),
        ((x - y) ** 2 / (-1 - a) <= as_term(0), PROVED),
        (a / (-1 - p / (-1 - a)) <= a, REFUTED),
        (1 / (1 / (-1 - a) - 1) <= as_term(0), PROVED),
    ],
)
def test_divisors_may_be_negative(claim: Claim, expected: str) -> None:
    """What is decided is accepted by the checker, which turns a/b into -a/-b."""
    assert decide(claim).claimed == expected


def test_divisors_inside_a_maximum_may_be_negative() -> None:
    """What is written down is accepted, if anything is: the cases are about the quotients, too."""
    claim = maximum(1, 2) + 1 / (r - 1) <= maximum(1 + 1 / (r - 1), 2 + 1 / (r - 1))
    assert decide(claim).claimed != REFUTED


@pytest.mark.parametrize("claim", [2 <= p**2, 1 <= p, p / 2 + 1 / p <= p])
def test_what_is_given_of_one_variable_may_be_more_than_a_bound(claim: Claim) -> None:
    """The step of Heron for the root of 2: what it starts from is no bound by a number."""
    beyond = context({"p.low": 0 < p, "beyond": 2 <= p * p}, {"p": 2})
    assert checked(statement(row(claim), contexts=(beyond,))).claimed == PROVED


@pytest.mark.parametrize(
    ("givens", "expected"),
    [
        ({"low": 0 < x, "room": 1 / x <= as_term(2)}, PROVED),
        ({"room": 1 / x <= as_term(2), "low": 0 < x}, UNDECIDED),
        ({"room": 1 / x <= as_term(2)}, UNDECIDED),
        ({"low": 0 <= x, "room": sqrt(x) <= as_term(2)}, PROVED),
        ({"room": sqrt(x) <= as_term(2)}, UNDECIDED),
        ({"room": x / (1 - sqrt(2)) <= as_term(2)}, PROVED),
    ],
)
def test_givens_are_defined_by_those_before(givens: dict[str, Claim], expected: str) -> None:
    stated = statement(row(x <= x + 1), contexts=(context(givens, {"x": 1}),))
    assert checked(stated).claimed == expected


def test_givens_about_other_variables_are_used() -> None:
    """From 0 < x <= y <= k <= 1 follows what names x and k leave unsaid."""
    givens = {"low": 0 < x, "xy": x <= y, "yk": y <= k, "high": k <= as_term(1)}
    linked = context(givens, {"x": 1, "y": 1, "k": 1})
    rows = (row(x <= k, name="a"), row(0 < k, name="b"), row(x <= as_term(1), name="c"))
    assert checked(statement(*rows, contexts=(linked,))).claimed == PROVED
    assert checked(statement(row(k <= x), contexts=(linked,))).claimed != PROVED


def test_witnesses_have_simple_values() -> None:
    found = decide(r * k < x)
    assert isinstance(found.proof, Witness)
    assert found.witness["x"] == as_term(0)
    assert found.witness["r"] == found.witness["k"] == as_term(HALF)
    assert set(found.witness) == set(POINT)


def test_branches_are_cut_where_they_are_needed() -> None:
    found = decide(r * k - r - k < Fraction(1, 8))
    assert isinstance(found.proof, Cuts)
    assert found.proof.at == (HALF,)


def nested(inner: dict[str, Claim], point: dict[str, Term]) -> tuple[Context, Context]:
    variables = tuple(Variable(v, v, v) for v in point)
    givens = tuple(Given(name, claim) for name, claim in inner.items())
    return (
        context({"r.low": 0 < r, "r.high": r < as_term(1)}, {"r": HALF}, "outer"),
        Context("all", variables, givens, point, parent="outer"),
    )


def test_nested_contexts() -> None:
    contexts = nested({"y.low": 0 < y, "y.high": y < as_term(1)}, {"y": r})
    stated = statement(row(y * r <= as_term(1)), row(r < y, name="other"), contexts=contexts)
    outcome = prove(stated)
    assert outcome.decisions["row"].claimed == PROVED
    assert outcome.decisions["other"].claimed == REFUTED  # y = r, whatever r is
    first = checked(statement(row(y * r <= as_term(1)), contexts=contexts))
    assert first.claimed == PROVED


def test_a_witness_in_a_nested_context_is_false_for_all_of_the_outer_one() -> None:
    contexts = nested({"y.low": 0 < y}, {"y": as_term(1)})
    outcome = checked(statement(row(r < y - 1), contexts=contexts))
    assert outcome.decisions["row"].claimed == REFUTED
    assert outcome.decisions["row"].witness == {"y": as_term(1)}


def test_constants_of_a_context() -> None:
    z = Constant("z", "z", "z", "", r / (1 + r))
    all_r = context({"r.low": 0 < r, "r.high": r < as_term(1)}, {"r": HALF})
    stated = statement(
        row(symbol("z") < as_term(Fraction(51, 100)), name="bernstein"),
        row(equal(symbol("z") * (1 + r), r), name="identity"),
        row(symbol("z") <= as_term(1), name="interval"),
        contexts=(all_r._replace(constants=(z,)),),
    )
    outcome = checked(stated)
    assert {row.name: found.method for row, found in outcome.rows} == {
        "bernstein": "sum",
        "identity": "sum",
        "interval": "interval",
    }


def test_constants_without_variables() -> None:
    root = Constant("root", "√2", "", "", sqrt(2))
    stated = statement(
        row(symbol("root") * r < as_term(Fraction(3, 2))),
        row(equal((symbol("root") + x) ** 2, 2 + 2 * symbol("root") * x + x**2), name="identity"),
    )
    outcome = checked(stated._replace(constants=(root,)))
    assert outcome.claimed == PROVED


def test_theorems_apply_where_the_givens_hold() -> None:
    small = context({"s.low": 0 < symbol("s")}, {"s": 1}, "small")
    contexts = (small, context(GIVENS, POINT))
    stated = statement(row(Applies("small", {"s": r / (1 + r)})), contexts=contexts)
    assert checked(stated).claimed == PROVED
    stated = statement(row(Applies("small", {"s": r - HALF})), contexts=contexts)
    assert prove(stated).claimed == UNDECIDED


@pytest.mark.parametrize("sides", [(x, x), (r, r + 1)])
def test_an_unknown_relation_is_left_undecided(sides: tuple[Term, Term]) -> None:
    claim = Claim("<=", *sides)
    claim.relation = ">="
    found = prove(statement(row(claim))).decisions["row"]
    assert found.claimed == UNDECIDED
    assert "'>=' is not a relation" in found.reason


@pytest.mark.parametrize("given", [equal(r, HALF), equal(HALF, r)])
def test_a_given_equation_bounds_on_both_sides(given: Claim) -> None:
    contexts = (context({"given": given}, {"r": HALF}),)
    rows = row(r * r <= as_term(Fraction(1, 4))), row(1 - r < r + TINY, name="other")
    assert checked(statement(*rows, contexts=contexts)).claimed == PROVED
    found = checked(statement(row(1 - r < r), contexts=contexts)).decisions["row"]
    assert found.claimed == REFUTED
    assert found.witness == {"r": as_term(HALF)}


def test_a_mutated_proof_is_refused() -> None:
    """The checker looks at what the search wrote down."""
    outcome = prove(statement(row(r**2 < r)))
    files = write(outcome)
    certificate = files["certificate.json"].replace(b"r.high", b"k.high")
    assert certificate != files["certificate.json"]
    report = check.check(files["statement.json"], certificate, {})
    assert report.verdict == "REFUSED"


def test_bernstein_coefficients_are_those_of_the_polynomial() -> None:
    polynomial = [Fraction(c) for c in (1, -3, 0, 2)]
    low, high = Fraction(-1, 2), Fraction(3, 2)
    (u,) = (ring := fmpq_mpoly_ctx.get(("u",), Ordering.lex)).gens()
    p = sum((ring.constant(int(c)) * u**i for i, c in enumerate(polynomial)), ring.constant(0))
    tensor = Tensor.of(p, [(low, high)])
    for degree in range(3, 8):
        values = [fraction_of(value) for value in tensor.coefficients]
        assert len(values) == degree + 1
        assert values[0] == sum(c * low**i for i, c in enumerate(polynomial))
        assert values[-1] == sum(c * high**i for i, c in enumerate(polynomial))
        # The mean of the coefficients is the mean of the polynomial.
        integral = sum(
            c * (high ** (i + 1) - low ** (i + 1)) / (i + 1) for i, c in enumerate(polynomial)
        )
        assert sum(values) / (degree + 1) == integral / (high - low)
        tensor = tensor.raised(0)
