"""Identities of elementary functions, rows in parts of contexts, and witnesses by inverses."""

from __future__ import annotations

import resource

import pytest

from verify.language.statement import PROVED, REFUTED, UNDECIDED
from verify.prover.budget import WorkBudget
from verify.prover.stationary import stationary
from verify.wire.questions import decide_page, read_page_of
from verify.wire.text.estimates import estimate
from verify.wire.text.infix import Names, read_claims, read_term

WORK = 20_000_000

UNIT = "0 < x < 1"
#: Equations, with what is given of x.
IDENTITIES = {
    "sin(x)^2 + cos(x)^2 = 1": "",
    "sin(2*x) = 2*sin(x)*cos(x)": "",
    "sin(x + y) = sin(x)*cos(y) + cos(x)*sin(y)": "",
    "cos(3*x) = 4*cos(x)^3 - 3*cos(x)": "",
    "cos(pi - x) = -cos(x)": "",
    "sin(x + 2*pi) = sin(x)": "",
    "(1 + tan(x)^2)*cos(x)^2 = 1": UNIT,
    "cos(arctan(x)) = 1/sqrt(1 + x^2)": "",
    "cos(2*arctan(x)) = (1 - x^2)/(1 + x^2)": "",
    "cos(arccos(x)) = x": UNIT,
    "tan(arcsin(x)) = x/sqrt(1 - x^2)": UNIT,
    "arctan(tan(x)) = x": UNIT,
    "arctan(x) + arctan(1/x) = pi/2": "0 < x",
    "arctan(-x) = -arctan(x)": "",
    "log(exp(x)) = x": "",
    "exp(log(x)) = x": "0 < x",
    "x^(1/2) = exp(log(x)/2)": "0 < x",
    "sqrt(exp(2*x)) = exp(x)": "",
    "pi = 16*arctan(1/5) - 4*arctan(1/239)": None,
    "arcsin(1/2) = pi/6": None,
    "exp(log(5)/3) = cbrt(5)": None,
    "2^(1/2)*2^(1/3) = 2^(5/6)": None,
    "arcsin(1) = pi/2": None,
    "sqrt(7)^2 + 5*log(sqrt(7)) = 7 + 5/2*log(7)": None,
    "arctan(1/(2 + sqrt(1 - 1^2))) = arctan(1/2)": None,
}
#: Equations that hold at some points, or nearly.
FALSE = {
    "sin(2*x) = 2*sin(x)*cos(x)^2": "",
    "arctan(x) + arctan(1/x) = pi/2": "x < 0",
    "cos(arctan(x)) = -1/sqrt(1 + x^2)": "",
    "arcsin(sin(x)) = x": "",
    "pi = 16*arctan(1/5) - 4*arctan(1/238)": None,
    "arctan(tan(x)) = x": "2 < x < 3",
    "exp(log(5)/3) = sqrt(5)": None,
    "sqrt(7)^2 + 5*log(sqrt(7)) = 7 + 5/3*log(7)": None,
}


def verdicts(row: str, given: str | None, work: int = WORK) -> set[str]:
    """What is found of one row."""
    names = [name for name in "xyab" if name in row.replace("exp", "").replace("tan", "")]
    page = 'title = "t"\n'
    if given is not None:
        context = f"variables = {[*names]}\ngiven = {given.split('; ') if given else []}\n"
        page += f"[contexts.box]\n{context}".replace("'", '"')
    page += f'[rows]\nrow = "{row}"\n'
    found = decide_page(read_page_of("a.toml", page.encode(), {}), WorkBudget(work))
    return {decision.verdict for _, decision in found.rows}


@pytest.mark.parametrize("row", IDENTITIES)
def test_identities_are_proved(row: str) -> None:
    assert verdicts(row, IDENTITIES[row]) == {PROVED}


@pytest.mark.parametrize("row", FALSE)
def test_what_is_no_identity_is_not_proved(row: str) -> None:
    assert PROVED not in verdicts(row, FALSE[row], 1_000_000)


@pytest.mark.parametrize(
    ("row", "given"),
    [
        ("0 < cos(arctan(x))", ""),
        ("0 <= sin(arctan(x))", "0 <= x"),
        ("sin(arctan(x)) != 0", "x != 0"),
        ("log(x) < sqrt(x)", "0 < x"),
        ("x < 7.39", "1 <= x; log(x) <= 2"),
    ],
)
def test_inequalities_of_compositions(row: str, given: str) -> None:
    assert verdicts(row, given) == {PROVED}


@pytest.mark.parametrize(
    ("row", "given"),
    [
        ("sqrt(2*sin(pi/6)) <= 1", None),
        ("1 <= sqrt(2*sin(pi/6))", None),
        ("exp(sin(pi)) = 1", None),
        ("max(sin(pi), cos(pi/2)) = 0", None),
        ("sqrt(sin(pi))*x/(2*x^2 - 4*x + 1)^2 <= 1/2", "0 <= x <= 1/8"),
        ("max(y*cos(2*x), cos(4*x)) <= max(y*cos(2*x), 8*cos(x)^4 - 8*cos(x)^2 + 1)", ""),
    ],
)
def test_what_is_replaced_may_be_inside_another_function(row: str, given: str | None) -> None:
    """With an equation the checker replaces atoms of a polynomial, and none inside of others."""
    assert verdicts(row, given) == {PROVED}


def test_a_constant_divisor_counts() -> None:
    """10^(-9) is 1/10^9, by which the checker multiplies the claim, and not the fact."""
    assert verdicts("sin(pi) + x < x + 10^(-9)", "0 < x") == {PROVED}


@pytest.mark.parametrize(
    ("row", "given"),
    [
        ("x/x = 1", "x != 0"),
        ("(x^2 - y^2)/(x - y) = x + y", "x != y"),
        ("1/x + 1/x = 2/x", "x^2 > 0"),
        ("|sin(x) - sin(y)| <= |x - y|", ""),
        ("-exp(-1) <= x*log(x)", "0 < x"),
        ("log(x) <= 2/e*sqrt(x)", "0 < x"),
    ],
)
def test_rows_are_shown_in_parts_of_their_contexts(row: str, given: str) -> None:
    assert verdicts(row, given) == {PROVED}


@pytest.mark.parametrize(
    ("row", "given"),
    [
        ("(1 + 1/x)^x < e", "1 <= x"),
        ("(1 - 1/x)^x <= 1/e", "1 < x"),
        ("log(1 + 1/x) < 1/sqrt(x*(x + 1))", "1 <= x"),
        ("log(1 - 1/x) < 1/sqrt(x*(x - 1))", "x < -1"),
        ("x*log(x + 1) - x*log(x) < 1", "1 <= x"),
        ("1 < sqrt(x^2 + 1)*(pi/2 - arctan(x))", "1 <= x"),
    ],
)
def test_where_both_sides_come_together_far_away(row: str, given: str) -> None:
    assert verdicts(row, given, 3_000_000) == {PROVED}


@pytest.mark.parametrize(
    ("row", "given"),
    [
        ("x^a <= 1 + a*(x - 1)", "0 < x; 0 <= a <= 1"),
        ("exp(a*x) <= 1 + a*(exp(x) - 1)", "0 <= x; 0 <= a <= 1"),
        ("cosh(x) <= exp(x^2/2)", ""),
        ("(x + y)*log((x + y)/2) <= x*log(x) + y*log(y)", "0 < x; 0 < y"),
        ("exp(x - x^2) <= 1/e*exp(1)", "1 < x"),
        ("x*exp(-x) <= exp(-1)", "0 < x"),
        ("exp(x*log(x))*(x + 1) <= exp((x + 1)*log(x + 1))", "1 <= x"),
        ("x + 2 <= 2^(x + 1)", "1 <= x; x + 1 <= 2^x"),
        ("1 + 1 <= exp(1*log(2)) + 0*x", ""),
    ],
)
def test_convex_functions_and_their_tangents(row: str, given: str) -> None:
    assert verdicts(row, given) == {PROVED}


@pytest.mark.parametrize(
    ("row", "given"),
    [
        ("x^a <= 1 + a*(x - 1)", "0 < x; 0 <= a <= 1.01"),
        ("exp(a*x) <= 1 + a*(exp(x) - 1)", "-0.01 <= a <= 1"),
        ("cosh(x) <= exp(0.499*x^2)", ""),
        ("(x + y)*log((x + y)/2) <= x*log(x) + 0.999*y*log(y)", "1 < x; 1 < y"),
        ("exp(x - x^2) <= 0.999", "1/2 < x"),
        ("x + 3 <= 2^(x + 1)", "1 <= x; x + 1 <= 2^x"),
    ],
)
def test_what_is_no_tangent(row: str, given: str) -> None:
    assert PROVED not in verdicts(row, given, 1_000_000)


@pytest.mark.parametrize(
    "row",
    [
        "sin(x) + sin(2*x)/2 <= 3*sqrt(3)/4",
        "sin(x)*cos(x)^2 <= 2*sqrt(3)/9",
        "cos(x) + sqrt(3)*sin(x) <= 2",
        "-1 - 3*sqrt(3)/4 <= sin(x) - cos(y) - sin(x)*cos(x)",
    ],
)
def test_sines_that_are_sharp_where_they_are_no_rational_numbers(row: str) -> None:
    assert verdicts(row, "") == {PROVED}


@pytest.mark.parametrize(
    "row",
    [
        "sin(x) + sin(2*x)/2 <= 1.299",
        "sin(x)*cos(x)^2 < 2*sqrt(3)/9",
        "cos(x) + sqrt(3)*sin(x) < 2",
        "-1 - 3*sqrt(3)/4 <= sin(x) - 1.0001*cos(y) - sin(x)*cos(x)",
    ],
)
def test_sines_beyond_what_is_sharp(row: str) -> None:
    assert PROVED not in verdicts(row, "", 1_000_000)


@pytest.mark.parametrize(
    ("row", "given"),
    [
        ("(1 + 1/x)^x < 2.718281", "1 <= x"),
        ("(1 - 1/x)^x <= 0.367879", "1 < x"),
        ("log(1 + 1/x) < 1/sqrt(x*(x + 1)) - 1/(25*x^3)", "1 <= x"),
        ("1.0001 < sqrt(x^2 + 1)*(pi/2 - arctan(x))", "1 <= x"),
    ],
)
def test_what_fails_far_away(row: str, given: str) -> None:
    assert PROVED not in verdicts(row, given, 1_000_000)


@pytest.mark.parametrize(
    ("row", "given"),
    [
        ("4*x*(1 - x) <= (-x*log(x) - (1 - x)*log(1 - x))/log(2)", UNIT),
        ("log(x) <= x^(1/10)*10/e", "2 <= x"),
        ("log(x) <= 6*x^(1/6)/e", "1 < x"),
    ],
)
def test_chords_from_an_end_without_values_and_powers_of_roots(row: str, given: str) -> None:
    assert verdicts(row, given) == {PROVED}


@pytest.mark.parametrize(
    ("row", "given"),
    [
        ("4*x*(1 - x) <= 0.9999*(-x*log(x) - (1 - x)*log(1 - x))/log(2)", UNIT),
        ("x*(1 - x)*1.01 <= -x*log(x)", UNIT),
        ("log(x) <= 0.9999*x^(1/10)*10/e", "2 <= x"),
    ],
)
def test_what_is_below_a_chord_or_a_root_somewhere(row: str, given: str) -> None:
    assert PROVED not in verdicts(row, given, 1_000_000)


def test_a_given_that_only_a_case_defines() -> None:
    page = """
title = "t"
[contexts.box]
variables = ["a", "b", "c"]
given = ["a != 0", "1/a < b", "b < c"]
[rows]
row = "1/a < c"
"""
    found = decide_page(read_page_of("a.toml", page.encode(), {}), WorkBudget(WORK))
    assert [row.name for row, _ in found.rows] == ["row.1", "row.2"]
    assert found.claimed == PROVED
    wrong = page.replace('row = "1/a < c"', 'row = "1/a < c - 1"')
    found = decide_page(read_page_of("a.toml", wrong.encode(), {}), WorkBudget(1_000_000))
    assert found.claimed != PROVED


@pytest.mark.parametrize(
    ("row", "given"),
    [
        ("40*x*x != 30", ""),
        ("log(x) != 1", "2 < x < 3"),
        ("1/3 - x^4 + y != 0", "y^5 = 0"),
        ("sin(x) != 1/2", "0 < x < 1"),
    ],
)
def test_witnesses_that_are_no_rational_numbers(row: str, given: str) -> None:
    assert verdicts(row, given) == {REFUTED}


def test_no_witness_where_the_givens_exclude_it() -> None:
    assert REFUTED not in verdicts("x != sqrt(2)", "x < sqrt(2)", 1_000_000)
    assert verdicts("log(x) != 1", "3 < x < 4") == {PROVED}
    assert verdicts("sin(x) != 2", "0 < x < 1", 1_000_000) != {UNDECIDED}


def test_a_product_of_many_bounded_numbers() -> None:
    names = [f"x{i}" for i in range(12)]
    page = f"""
title = "t"
[contexts.box]
variables = {names}
given = ["{" + ".join(f"{name}^2" for name in names)} < 1"]
[rows]
row = "{"*".join(names)} <= 1"
""".replace("'", '"')
    found = decide_page(read_page_of("a.toml", page.encode(), {}), WorkBudget(WORK))
    assert found.claimed == PROVED


@pytest.mark.parametrize(
    ("row", "given"),
    [
        ("abs(3 - 2) != max(2, 1.25)", "x != 1"),
        ("max(1, sqrt(2)) <= 1", "0 < x"),
        ("x <= 10^999*y", "x != y"),
    ],
)
def test_rows_about_few_variables_are_taken_apart(row: str, given: str) -> None:
    assert verdicts(row, given, 1_000_000) <= {PROVED, REFUTED, UNDECIDED}


@pytest.mark.parametrize(
    "row",
    [
        "y - y*(x + 1)^3 - 3/max(3, y) <= -1",
        "abs(min(y, y)) - y*(x + 1)^3 - max(1/2, 3)/max(3, y) <= -1",
        "(min(y, y) + x)/max(3, y) <= max(5/3, x)",
    ],
)
def test_a_known_entry_of_a_maximum_that_divides(row: str) -> None:
    page = f"""title = "t"
[contexts.b]
variables = ["x", "y"]
given = ["1 <= x <= 4", "0 <= y <= 1"]
[rows]
q = {{ claim = "{row}", in = "b" }}
"""
    found = decide_page(read_page_of("a.toml", page.encode(), {}), WorkBudget(WORK))
    assert found.claimed == PROVED


HALVES = """
title = "t"
[contexts.c]
variables = ["x"]
given = {{ g = "x != 0" }}
constants = {{ k = "x^2" }}
rows = {{ row = "k/x <= abs(x)" }}
[contexts."{}"]
variables = ["y"]
given = {{ "{}" = "y >= 0" }}
rows = {{ "{}" = "y^2 >= 0" }}
"""


@pytest.mark.parametrize(
    "names", [("d", "h", "z"), ("c.1", "h", "z"), ("d", "g.2", "z"), ("d", "h", "row.1")]
)
def test_names_of_a_page_that_are_like_those_of_cases(names: tuple[str, str, str]) -> None:
    page = HALVES.format(*names)
    found = decide_page(read_page_of("a.toml", page.encode(), {}), WorkBudget(WORK))
    assert {decision.verdict for _, decision in found.rows} == {PROVED}


@pytest.mark.parametrize(("given", "other"), [("", "part1"), ("x > 0", "inverse")])
def test_contexts_of_a_page_that_are_called_like_parts(given: str, other: str) -> None:
    page = f"""
title = "t"
[contexts.c]
variables = ["x"]
given = ["x <= 5"]
rows = {{ main = {{ claim = "x^2 + 1 > 0", by = "parts" }} }}
[contexts."c.{other}"]
variables = ["x"]
given = {[given] if given else []}
rows = {{ p1 = "x^2 + 1 > 0" }}
[contexts."c.part2"]
variables = ["x"]
rows = {{ p2 = "x^2 + 1 > 0" }}
""".replace("'", '"')
    found = decide_page(read_page_of("a.toml", page.encode(), {}), WorkBudget(WORK))
    reasons = {row.name: decision.reason for row, decision in found.rows}
    assert "Error" not in reasons["main"]


def test_powers_of_powers_take_no_memory() -> None:
    """The exact value at a point has 10^9 bits; the limit of 2^19 is counted at each product."""
    before = resource.getrusage(resource.RUSAGE_SELF).ru_maxrss
    assert verdicts("(((x + 1)^999)^999)^999 >= 0", "", 1_000_000) == {UNDECIDED}
    assert resource.getrusage(resource.RUSAGE_SELF).ru_maxrss < before + 400_000  # kB


#: What follows from a given exponential or logarithm, and what is next to it.
READ_BACK = {
    ("x <= exp(7)", "2 <= x; log(x) <= 7"): PROVED,
    ("x <= exp(6.99)", "2 <= x; log(x) <= 7"): REFUTED,
    ("y <= log(7)", "exp(y) <= 7"): PROVED,
    ("y < log(7)", "exp(y) <= 7"): UNDECIDED,
    ("x <= exp(3)", "0 < x; 2*log(x) + 1 <= 7"): PROVED,
    ("2*x + 1 <= 2*exp(7) + 1", "2 <= x; 7 >= log(x)"): PROVED,
    ("x < y", "0 < x; 0 < y; log(x) < log(y)"): PROVED,
    ("y < x", "0 < x; 0 < y; log(x) < log(y)"): REFUTED,
    ("x <= y", "exp(x) <= exp(y)"): PROVED,
    ("x <= e*y", "0 < x; 0 < y; log(x) - log(y) <= 1"): PROVED,
    ("x <= y", "0 < x; 0 < y; log(x) - log(y) <= 1"): REFUTED,
}


@pytest.mark.parametrize(("row", "given"), READ_BACK)
def test_a_given_function_is_read_back(row: str, given: str) -> None:
    found = verdicts(row, given, 3_000_000)
    assert found & {REFUTED, UNDECIDED} == {READ_BACK[row, given]} - {PROVED}


#: Bounds that are reached where the derivatives of both sides agree, and one that is not.
STATIONARY = {
    ("x - exp(x)/3 <= log(3) - 1", "0 <= x <= 3"): PROVED,
    ("(1 + log(2))/2 <= x + exp(-2*x)", ""): PROVED,
    ("-1/e^2 <= x*log(x) + x", "0 < x"): PROVED,
    ("5*x - exp(x) <= 5*log(5) - 5.00001", "0 <= x"): REFUTED,
}


@pytest.mark.parametrize(("row", "given"), STATIONARY)
def test_what_is_reached_at_a_stationary_point(row: str, given: str) -> None:
    assert verdicts(row, given) == {STATIONARY[row, given]}


@pytest.mark.parametrize(
    ("row", "near", "number"),
    [
        ("log(1 + x) - x/sqrt(2) <= 1", 0.41421356, "sqrt(2) - 1"),
        ("arctan(x^2) - x <= 1", 0.5, None),
        ("x^3 - sqrt(2)*x <= 1", 0.68658905, "sqrt(sqrt(2)/3)"),
        ("sqrt(log(x)) - log(x) <= 1", 1.28402542, "exp(1/4)"),
    ],
)
def test_a_stationary_point_is_a_term(row: str, near: float, number: str | None) -> None:
    names = Names({"x": "x"})
    (claim,) = read_claims("", row, names)
    found = stationary(claim, "x", near)
    if number is None or found is None:
        assert found is number
    else:
        value = estimate(read_term("", number, names), {})
        assert estimate(found, {}) == pytest.approx(value, abs=1e-12)
    assert stationary(claim, "x", near + 0.01) is None


#: Inequalities between numbers that are equal, or not, and chords that end at such numbers.
EQUAL = {
    ("pi/4 <= arctan(1)", None): PROVED,
    ("arctan(1) < pi/4", None): REFUTED,
    ("arctan(sqrt(3)) + e <= pi/3 + exp(1)", None): PROVED,
    ("2*arctan(1/2) <= arctan(4/3) - exp(-90)", None): REFUTED,
    ("pi/4*x <= arctan(x)", "0 <= x <= 1"): PROVED,
    ("0.78540*x <= arctan(x)", "0 <= x <= 1"): REFUTED,
}


@pytest.mark.parametrize(("row", "given"), EQUAL)
def test_what_is_equal_is_at_most_that(row: str, given: str | None) -> None:
    assert verdicts(row, given, 3_000_000) == {EQUAL[row, given]}
