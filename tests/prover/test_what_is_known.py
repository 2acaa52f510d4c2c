"""Claims that follow from what is known around them: named constants, equations, linear givens.

Each row is decided by the search and judged by the checker. The sources stand beside the cases.
"""

from __future__ import annotations

from collections.abc import Mapping
from itertools import pairwise
from time import perf_counter

import pytest

from verify.language.statement import PROVED, REFUTED, Constant, Obligation
from verify.language.terms import Claim, Term, as_term, equal, maximum, minimum, sqrt, symbol
from verify.library import ask, for_all, lemma, prove
from verify.prover.search.squares import decompose

a, b, c, k, t, u, v, w, x, y, z = map(symbol, "abcktuvwxyz")


def verdicts(
    claims: list[Claim],
    givens: list[Claim],
    point: Mapping[str, Term | int],
    constants: Mapping[str, Term] | None = None,
    first: list[Claim] | None = None,
) -> list[str]:
    """What becomes of claims in a context, after claims about constants at the root."""
    named = {f"g{i}": given for i, given in enumerate(givens)}
    place = for_all("all", named, point)
    rows = [ask(f"first{i}", claim) for i, claim in enumerate(first or [])]
    rows += [ask(f"row{i}", claim, place) for i, claim in enumerate(claims)]
    known = [Constant(name, name, name, name, term) for name, term in (constants or {}).items()]
    found = prove(lemma("title", rows, known, [place]), work=20_000_000)
    return [found.decisions[row.name].verdict for row in rows if isinstance(row, Obligation)]


def psi(term: Term) -> Term:
    return 2 * term**2 - 4 * term + 1


u1, u0, ur, a0, alpha = map(symbol, ("u1", "u0", "ur", "a0", "alpha"))
#: The constants of Smale's alpha-theory (Blum, Cucker, Shub, Smale: Complexity and Real
#: Computation, chapter 8), each of them named.
SMALE = {
    "u1": 1 - sqrt(2) / 2,
    "u0": (5 - sqrt(17)) / 4,
    "ur": (3 - sqrt(7)) / 2,
    "a0": as_term(1307) / 10000,
}
SMALE_ROWS = {
    "below u1": (u, [0 <= u, u < u1], [0 < psi(u), psi(u) <= as_term(1), u < as_term(1)]),
    "below u0": (v, [0 <= v, v < u0], [v < psi(v)]),
    "up to ur": (w, [0 <= w, w <= ur], [0 < psi(w), w / psi(w) <= as_term(1) / 2]),
    "up to a0": (
        a,
        [0 <= a, a <= a0],
        [
            0 < psi(a),
            (a / psi(a)) ** 2 <= a,
            a / psi(a) ** 2 <= as_term(1) / 2,
            (a / psi(a)) ** 2 <= a0,
            a * (1 - a) / psi(a) <= as_term(1) / 2,
        ],
    ),
}


@pytest.mark.parametrize("name", SMALE_ROWS)
def test_smale_with_named_constants(name: str) -> None:
    variable, givens, claims = SMALE_ROWS[name]
    found = verdicts(claims, givens, {variable.name: 0}, SMALE)
    assert found == [PROVED] * len(claims)


def test_a_bound_that_has_a_name() -> None:
    assert verdicts([u <= as_term(1)], [u <= b], {"u": 0}, {"b": as_term(1) / 2}) == [PROVED]


def test_a_proved_row_about_a_constant() -> None:
    low = as_term(293) / 1000
    found = verdicts([u < low], [u < u1], {"u": 0}, {"u1": SMALE["u1"]}, [u1 < low])
    assert found == [PROVED, PROVED]


EQUATIONS = {
    "product": ([equal(x + y, 1)], {"x": 0, "y": 1}, x * y <= as_term(1) / 4),
    "circle": ([equal(a**2 + b**2, 2)], {"a": 1, "b": 1}, a * b <= as_term(1)),
    # miniF2F, algebra_apbpceq2_abpbcpcaeq1_aleq1on3anbleq1ancleq4on3
    "three": (
        [a <= b, b <= c, equal(a + b + c, 2), equal(a * b + b * c + c * a, 1)],
        {"a": 0, "b": 1, "c": 1},
        c <= as_term(4) / 3,
    ),
}


@pytest.mark.parametrize("name", EQUATIONS)
def test_equations_among_givens_are_used(name: str) -> None:
    givens, point, claim = EQUATIONS[name]
    assert verdicts([claim], givens, point) == [PROVED]


def test_a_chain_of_any_length() -> None:
    names = [f"x{i}" for i in range(12)]
    links = [symbol(m) < symbol(n) for m, n in pairwise(names)]
    point = {name: i for i, name in enumerate(names)}
    ends = symbol(names[0]), symbol(names[-1])
    assert verdicts([ends[0] < ends[1], ends[1] <= ends[0]], links, point) == [PROVED, REFUTED]


@pytest.mark.parametrize("power", [3, 5, 7])
def test_odd_powers_rise(power: int) -> None:
    assert verdicts([x**power < y**power], [x < y], {"x": 0, "y": 1}) == [PROVED]


def test_even_powers_and_roots_rise_from_0() -> None:
    claims = [x**2 < y**2, sqrt(x) < sqrt(y)]
    assert verdicts(claims, [0 <= x, x < y], {"x": 0, "y": 1}) == [PROVED, PROVED]
    assert verdicts([x**2 < y**2], [x < y], {"x": 0, "y": 1}) == [REFUTED]


def test_minima_and_maxima_in_givens() -> None:
    size = maximum(x, -x)
    assert verdicts([x**2 <= as_term(1)], [size <= as_term(1)], {"x": 0}) == [PROVED]
    assert verdicts([0 <= x * y], [0 <= minimum(x, y)], {"x": 0, "y": 0}) == [PROVED]
    # miniF2F: |x - 1| + |x| + |x + 1| = x + 2 has solutions in [0, 1] only
    total = maximum(x - 1, -(x - 1)) + size + maximum(x + 1, -(x + 1))
    assert verdicts([0 <= x, x <= as_term(1)], [equal(total, x + 2)], {"x": 0}) == [PROVED] * 2


def test_a_further_condition_does_no_harm() -> None:
    givens = [1 <= b, b <= a, a <= as_term(2)]
    assert verdicts([sqrt(a * b) <= (a + b) / 2], givens, {"a": 2, "b": 1}) == [PROVED]


#: Equations are solved for variables: what is left is looked for.
WITNESSES = {
    "the point of the context": (y**2 <= as_term(-3), [x < y], {"x": 0, "y": 1}),
    "a linear equation": (x < 2 * y, [equal(z**2 - x, y), 1 < y, 1 < z], {"x": 2, "y": 2, "z": 2}),
    "a root": (0 <= x, [equal(x**2, 2)], {"x": sqrt(2)}),
    "an equation in two parts": (x < y, [x + y <= as_term(1), 1 <= x + y], {"x": 0, "y": 1}),
}


@pytest.mark.parametrize("name", WITNESSES)
def test_false_claims_are_refuted_where_the_givens_hold(name: str) -> None:
    claim, givens, point = WITNESSES[name]
    assert verdicts([claim], givens, point) == [REFUTED]


def test_fista() -> None:
    """The step of the induction that the k-th number is (k + 2)/2 at least (Beck, Teboulle)."""
    claim = (k + 3) / 2 <= (1 + sqrt(1 + 4 * t**2)) / 2
    assert verdicts([claim], [0 <= k, (k + 2) / 2 <= t], {"k": 0, "t": 1}) == [PROVED]


def test_squares_on_a_circle() -> None:
    circle = [equal(x**2 + y**2, 1)]
    claims = [3 * x + 4 * y <= as_term(5), x**3 + y**3 <= as_term(1), x <= as_term(1)]
    assert verdicts(claims, circle, {"x": 1, "y": 0}) == [PROVED] * 3


def test_factors_and_orders_of_variables() -> None:
    positive = [0 < a, 0 < b, 0 < c]
    ones = {"a": 1, "b": 1, "c": 1}
    # Schur's inequality, as in the tests of Coq's micromega
    schur = a * (a - b) * (a - c) + b * (b - a) * (b - c) + c * (c - a) * (c - b)
    # miniF2F, algebra_sumasqdivbsqgeqsumbdiva
    quotients = b / a + c / b + a / c <= a**2 / b**2 + b**2 / c**2 + c**2 / a**2
    assert verdicts([0 <= schur, quotients], positive, ones) == [PROVED, PROVED]


def test_givens_that_fail_on_parts_of_a_box() -> None:
    """From cos-3410-b of the SMT-LIB's QF_NRA: five quadratic givens and a quadratic claim."""
    half = as_term(1) / 2
    near = as_term(51) / 100
    far = as_term(251) / 100
    box = [claim for v in (x, y, z) for claim in (as_term(-3) / 2 < v, v < as_term(3) / 2)]
    givens = [
        far - half * x**2 + y * (x - y) < z * (z * half - y),
        near - half * y**2 < z * (z * half - y),
        far - x**2 + y * (x - half * y) < z * (z * half - x),
        near - half * x**2 < z * (z * half - x),
        near - half * x**2 < y * (y * half - x),
    ]
    claim = z * (z - x - y) <= far - half * x**2 - half * y**2
    point = {"x": as_term(-5) / 4, "y": as_term(5) / 4, "z": 0}
    assert verdicts([claim], givens + box, point) == [PROVED]


def test_a_variable_that_is_bounded_where_the_claim_fails() -> None:
    """On all x > 2 the claim is linear; below that the given fails."""
    given = as_term(1) <= x * (x - 3) * (x - 4)
    assert verdicts([x < as_term(5)], [given, x < as_term(3)], {"x": 1}) == [PROVED]
    assert verdicts([as_term(4) < x], [given, 3 < x], {"x": 5}) == [PROVED]


def test_the_search_ends_when_its_work_is_used_up() -> None:
    """Eleven variables, ten givens and an equation, whose products would be very many."""
    names = [f"x{i}" for i in range(11)]
    every = [symbol(name) for name in names]
    givens = [m * n < m * m + n * n + 1 for m, n in pairwise(every)]
    givens.append(equal(every[0] ** 2, 1))
    point = {name: int(name == "x0") for name in names}
    claim = every[0] * every[5] * every[9] < every[3] ** 2 + every[7] ** 4 + 1000 + every[9] ** 4
    named = {f"g{i}": given for i, given in enumerate(givens)}
    row = ask("row", claim, place := for_all("all", named, point))
    start = perf_counter()
    prove(lemma("title", [row], [], [place]), work=1_000_000)
    assert perf_counter() - start < 60  # some seconds; without a limit on products, hours


def test_many_rows_do_not_enter_a_sum_of_squares(monkeypatch: pytest.MonkeyPatch) -> None:
    """A square needs none of the rows before it, so that a long page costs no more for each row."""
    sizes = []

    def counted(p, domain, polynomials, blocks, budget):
        sizes.append(len(blocks))
        return decompose(p, domain, polynomials, blocks, budget)

    monkeypatch.setattr("verify.prover.search.positive.decompose", counted)
    real = for_all("real", [], point={"x": 0, "y": 0})
    rows = [ask(f"row-{n}", 0 < x**4 + y**4 - n * x * y + n * n, real) for n in range(1, 13)]
    assert prove(lemma("A page", rows, contexts=[real])).verdict == "proved"
    assert max(sizes) <= 7
