"""Lies: mutations of the small honest pair, each with an exit code and a word of the reason."""

from __future__ import annotations

import json
from collections.abc import Callable
from typing import NamedTuple

from tests.lies.small import ROOT_2, Document, Json, bind, honest, pack

Files = tuple[bytes, bytes]


class Lie(NamedTuple):
    """A pair of files that must not pass."""

    files: Callable[[], Files]
    code: int
    word: str


LIES: dict[str, Lie] = {}


def register(name: str, lie: Lie) -> None:
    """Every lie has a name of its own."""
    name = name.replace("_", "-")
    if name in LIES:
        raise ValueError(f"two lies have the name {name}")
    LIES[name] = lie


def lie(code: int, word: str) -> Callable[[Callable[[Document, Document], object]], object]:
    """A change of both documents, in place; the digest is computed afterwards."""

    def decorate(change: Callable[[Document, Document], object]) -> object:
        def files() -> Files:
            statement, certificate = honest()
            change(statement, certificate)
            return pack(statement, certificate)

        register(change.__name__, Lie(files, code, word))
        return change

    return decorate


def raw(code: int, word: str) -> Callable[[Callable[[bytes, bytes], Files]], object]:
    """A change of the bytes; the digest is what the change makes of it."""

    def decorate(change: Callable[[bytes, bytes], Files]) -> object:
        register(change.__name__, Lie(lambda: change(*pack(*honest())), code, word))
        return change

    return decorate


def row(statement: Document, name: str) -> Document:
    """An obligation."""
    return next(item for item in statement["obligations"] if item["name"] == name)


def proof(certificate: Document, name: str) -> Document:
    """The proof of an obligation."""
    return next(item for item in certificate["proofs"] if item["obligation"] == name)


def constant(statement: Document, name: str) -> Document:
    """A constant."""
    return next(item for item in statement["constants"] if item["name"] == name)


def swap(items: list[Json], i: int, j: int) -> None:
    """Exchange two items."""
    items[i], items[j] = items[j], items[i]


# --- numbers of the statement -------------------------------------------------------------------


@lie(1, "constant root2")
def a_constant_moved_by_its_last_digit(s, c):
    constant(s, "root2")["term"] = ["sqrt", "200000000000000001/100000000000000000"]


@lie(1, "constant cosine")
def a_parameter_moved_by_its_last_digit(s, c):
    s["parameters"]["s"] = "1400000000000000001/1000000000000000000"


@lie(1, "interval-tight")
def a_bound_moved_by_its_last_digit(s, c):
    row(s, "interval-tight")["claim"][2] = ROOT_2.replace("857/", "856/")


@lie(1, "exact")
def a_rational_bound_moved_by_its_last_digit(s, c):
    big = 10**60
    row(s, "exact")["claim"][2] = f"{7 * big - 1}/{15 * big}"


@lie(1, "exact-equal")
def an_equality_moved_by_its_last_digit(s, c):
    big = 10**60
    row(s, "exact-equal")["claim"][2] = f"{16 * big + 1}/{15 * big}"


@lie(1, "exact-equal")
def an_equality_of_roots_by_the_rule_exact(s, c):
    row(s, "exact-equal")["claim"] = ["=", ["pow", "root2", "2"], "2"]
    proof(c, "exact-equal").update(lhs=["2", "2"], rhs=["2", "2"])


@lie(1, "identity")
def an_identity_that_is_false_by_10_to_the_minus_40(s, c):
    row(s, "identity")["claim"][2] = f"{10**40 + 1}/{10**40}"


@lie(1, "identity-box")
def an_identity_with_another_exponent(s, c):
    row(s, "identity-box")["claim"][2][2][2][2] = "3"


@lie(1, "identity-box")
def an_identity_over_a_pole(s, c):
    row(s, "identity-box")["variables"]["x"] = ["0", "2"]


@lie(1, "cos-pi")
def a_tolerance_that_is_negative(s, c):
    claim = row(s, "cos-pi")["claim"]
    claim[2] = "-" + claim[2]


@lie(1, "max")
def a_max_whose_largest_entry_grew(s, c):
    constant(s, "highest")["term"] = ["max", "r", "s", "71/50"]
    c["enclosures"]["highest"] = ["1.42", "1.42"]
    proof(c, "max")["lhs"] = ["1.42", "1.42"]


@lie(1, "pow")
def a_power_with_another_exponent(s, c):
    constant(s, "cube")["term"] = ["pow", "root2", "2"]
    c["enclosures"]["cube"] = ["2", "2"]
    proof(c, "pow")["lhs"] = ["-2", "-2"]


# --- relations ----------------------------------------------------------------------------------


@lie(1, "exact")
def weak_turned_strict_where_that_is_false(s, c):
    row(s, "exact")["claim"][0] = "<"


@lie(1, "square-identity")
def weak_turned_strict_for_an_identity(s, c):
    row(s, "square-identity")["claim"][0] = "<"


@lie(1, "rewrite-entry")
def weak_turned_equal_for_an_entry(s, c):
    row(s, "rewrite-entry")["claim"][0] = "="


@lie(1, "interval")
def sides_swapped(s, c):
    swap(row(s, "interval")["claim"], 1, 2)
    p = proof(c, "interval")
    p["lhs"], p["rhs"] = p["rhs"], p["lhs"]


@lie(1, "bernstein")
def sides_swapped_for_all(s, c):
    swap(row(s, "bernstein")["claim"], 1, 2)


@lie(1, "negation")
def a_negation_dropped(s, c):
    row(s, "negation")["claim"] = row(s, "negation")["claim"][1]


@lie(1, "witness")
def a_negation_of_a_negation(s, c):
    row(s, "witness")["claim"] = ["not", row(s, "witness")["claim"]]


@lie(1, "interval")
def a_negation_added(s, c):
    row(s, "interval").update(claim=["not", row(s, "interval")["claim"]], role="printed")


@lie(1, "negation")
def a_needed_row_as_a_negation(s, c):
    row(s, "negation")["role"] = "needed"


@lie(1, "witness")
def a_needed_row_as_a_witness(s, c):
    row(s, "witness")["role"] = "needed"


@lie(1, "negation-equal")
def a_negated_equality_that_holds(s, c):
    row(s, "negation-equal")["claim"][1] = ["=", "root2", "root2"]
    proof(c, "negation-equal")["rhs"] = proof(c, "negation-equal")["lhs"]


@lie(4, "negation")
def a_negation_of_two_claims(s, c):
    row(s, "negation")["claim"].append(["<", "0", "1"])


@lie(4, "interval")
def an_unknown_relation(s, c):
    row(s, "interval")["claim"][0] = ">"


@lie(4, "interval")
def a_relation_that_only_failures_have(s, c):
    row(s, "interval")["claim"][0] = "!="


# --- cuts ---------------------------------------------------------------------------------------


def cut(c: Document, cuts: Json, name: str = "cuts", variable: str = "x") -> None:
    proof(c, name)["cuts"][variable] = cuts


@lie(1, "cuts")
def a_cut_missing(s, c):
    cut(c, ["0", "1/4", "3/4", "1"])


@lie(1, "cuts")
def a_cut_missing_and_a_gap_of_nothing(s, c):
    cut(c, ["0", "1/4", "1/2", "1/2", "3/4", "1"])


@lie(1, "cuts")
def cuts_in_the_wrong_order(s, c):
    cut(c, ["0", "1/2", "1/4", "3/4", "1"])


@lie(1, "cuts")
def cuts_reversed(s, c):
    cut(c, ["1", "3/4", "1/2", "1/4", "0"])


@lie(1, "cuts")
def cuts_overlapping(s, c):
    cut(c, ["0", "1/4", "1/2", "3/8", "3/4", "1"])


@lie(1, "cuts")
def the_first_cut_inside(s, c):
    cut(c, ["1/1000000", "1/4", "1/2", "3/4", "1"])


@lie(1, "cuts")
def the_last_cut_inside(s, c):
    cut(c, ["0", "1/4", "1/2", "3/4", "999999/1000000"])


@lie(1, "cuts")
def the_last_cut_outside(s, c):
    cut(c, ["0", "1/4", "1/2", "3/4", "1", "2"])


@lie(1, "cuts")
def no_cuts(s, c):
    cut(c, [])


@lie(1, "cuts")
def one_cut(s, c):
    cut(c, ["0"])


@lie(1, "cuts")
def cuts_of_no_variable(s, c):
    proof(c, "cuts")["cuts"] = {}


@lie(1, "cuts")
def cuts_of_another_variable(s, c):
    proof(c, "cuts")["cuts"] = {"y": proof(c, "cuts")["cuts"]["x"]}


@lie(1, "cuts-two")
def cuts_of_one_of_two_variables(s, c):
    del proof(c, "cuts-two")["cuts"]["y"]


@lie(1, "cuts-two")
def cuts_of_the_second_variable_stop_early(s, c):
    cut(c, ["1", "3/2"], "cuts-two", "y")


@lie(1, "cuts-two")
def the_last_of_all_boxes_false(s, c):
    row(s, "cuts-two")["claim"] = ["<=", ["mul", "x", "y"], "2"]
    row(s, "cuts-two")["claim"][2] = f"{2 * 10**40 - 1}/{10**40}"


@lie(1, "cuts")
def cuts_of_an_unbounded_variable(s, c):
    row(s, "cuts")["variables"]["x"] = ["0", None]


@lie(1, "cuts")
def cuts_of_a_wider_interval(s, c):
    row(s, "cuts")["variables"]["x"] = ["0", "2"]


@lie(1, "interval-box")
def a_box_that_grew(s, c):
    row(s, "interval-box")["variables"]["x"] = ["0", "11/10"]


@lie(1, "interval-box")
def a_box_without_end(s, c):
    row(s, "interval-box")["variables"]["x"] = ["0", None]


@lie(4, "cuts")
def an_interval_reversed(s, c):
    row(s, "cuts")["variables"]["x"] = ["1", "0"]


@lie(4, "cuts")
def an_interval_without_points(s, c):
    row(s, "cuts")["variables"]["x"] = ["1", "1"]
    cut(c, ["1", "1"])


# --- witnesses ----------------------------------------------------------------------------------


def at(c: Document, **point: Json) -> None:
    proof(c, "witness")["point"] = point


@lie(1, "witness")
def a_witness_outside_its_interval(s, c):
    at(c, x="3")


@lie(1, "witness")
def a_witness_on_the_boundary(s, c):
    at(c, x="2")


@lie(1, "witness")
def a_witness_where_the_claim_is_true(s, c):
    at(c, x="7/5")


@lie(1, "witness")
def a_witness_for_the_wrong_variable(s, c):
    at(c, y="3/2")


@lie(1, "witness")
def a_witness_for_a_constant(s, c):
    at(c, x="3/2", root2="2")


@lie(1, "witness-two")
def a_witness_without_a_variable(s, c):
    del proof(c, "witness-two")["point"]["y"]


@lie(1, "witness")
def a_witness_where_a_side_is_undefined(s, c):
    row(s, "witness")["claim"][1][1] = ["div", "1", ["sub", "x", "3/2"]]


@lie(1, "cuts")
def a_witness_for_a_claim_for_all(s, c):
    c["proofs"][[r["name"] for r in s["obligations"]].index("cuts")] = {
        "obligation": "cuts",
        "rule": "witness",
        "bits": 128,
        "point": {"x": "1/2"},
    }


@lie(4, "witness")
def a_witness_as_a_decimal(s, c):
    at(c, x="1.5")


@lie(1, "witness")
def an_interval_for_a_witness(s, c):
    p = proof(c, "witness")
    del p["point"]
    p["rule"] = "interval"


# --- enclosures ---------------------------------------------------------------------------------


def enclose(low: Json, high: Json) -> Callable[[Document, Document], None]:
    return lambda s, c: c["enclosures"].update(root2=[low, high])


for name, code, low, high in (
    (
        "an_enclosure_shrunk_to_a_disjoint_one",
        1,
        "14142135623730950500e-19",
        "14142135623730950501e-19",
    ),
    ("an_enclosure_shifted", 1, "2.4142135623730950488", "2.4142135623730950489"),
    ("an_enclosure_of_the_other_root", 1, "-1.5", "-1.4"),
    ("an_enclosure_with_another_exponent", 1, "1.41e1", "1.42e1"),
    ("an_enclosure_reversed", 4, "1.5", "1.4"),
    ("an_enclosure_that_is_nan", 4, "NaN", "NaN"),
    ("an_enclosure_that_is_infinite", 4, "-Infinity", "Infinity"),
    ("an_enclosure_that_is_inf", 4, "-inf", "inf"),
    ("an_enclosure_with_a_huge_exponent", 4, "1.4", "1e999999"),
    ("an_enclosure_with_a_plus", 4, "1.4", "+1.5"),
    ("an_enclosure_with_spaces", 4, " 1.4", "1.5 "),
    ("an_enclosure_with_a_line_feed", 4, "1.4", "1.5\n"),
    ("an_enclosure_as_fractions", 4, "14/10", "15/10"),
    ("an_enclosure_without_ends", 4, None, None),
    ("an_enclosure_in_floats", 4, 1.4, 1.5),
    ("an_enclosure_in_hexadecimal", 4, "0x1", "0x2"),
):
    change = enclose(low, high)
    change.__name__ = name
    lie(code, {1: "constant root2", 4: ""}[code])(change)


@lie(1, "interval")
def an_enclosure_of_a_side_shifted(s, c):
    proof(c, "interval")["lhs"] = ["1.4142135623730950489", "1.4142135623730950490"]


@lie(4, "interval")
def an_enclosure_of_a_side_missing(s, c):
    del proof(c, "interval")["lhs"]


@lie(4, "cuts")
def an_enclosure_of_a_side_with_variables(s, c):
    proof(c, "cuts")["lhs"] = ["0", "1"]


@lie(4, "root2")
def an_enclosure_missing(s, c):
    del c["enclosures"]["root2"]


@lie(4, "root5")
def an_enclosure_too_many(s, c):
    c["enclosures"]["root5"] = ["2.2", "2.3"]


@lie(4, "enclosures")
def an_enclosure_with_three_ends(s, c):
    c["enclosures"]["root2"].append("1.5")


# --- rewriting ----------------------------------------------------------------------------------


def steps(index: Json, name: Json = "lowest") -> Callable[[Document, Document], None]:
    return lambda s, c: proof(c, "rewrite-entry").update(steps=[[name, index]])


for name, code, index, symbol in (
    ("an_entry_out_of_range", 1, 3, "lowest"),
    ("an_entry_just_below_a_thousand", 1, 999, "lowest"),
    ("an_entry_with_a_huge_index", 4, 10**8, "lowest"),
    ("an_entry_with_a_negative_index", 4, -1, "lowest"),
    ("an_entry_with_a_truth_value", 4, False, "lowest"),
    ("an_entry_with_a_text", 4, "0", "lowest"),
    ("an_entry_with_a_float", 4, 0.0, "lowest"),
    ("an_entry_that_proves_nothing", 1, 1, "lowest"),
    ("an_entry_of_a_root", 1, 0, "root2"),
    ("an_entry_of_a_quotient", 1, 0, "half"),
    ("a_step_for_an_unknown_constant", 4, None, "nothing"),
    ("a_step_for_a_rational", 4, None, "7/15"),
):
    change = steps(index, symbol)
    change.__name__ = name
    lie(code, "" if index in (-1, 0.0) else "rewrite-entry")(change)  # JSON refuses the number


@lie(4, "identity-box")
def a_step_for_a_variable(s, c):
    proof(c, "identity-box")["steps"].append(["x", None])


@lie(1, "rewrite-entry")
def a_step_missing(s, c):
    proof(c, "rewrite-entry")["steps"] = []


@lie(4, "rewrite-entry")
def a_step_with_three_items(s, c):
    proof(c, "rewrite-entry")["steps"][0].append(0)


@lie(1, "rewrite-entry")
def an_entry_that_makes_the_claim_easier(s, c):
    # lowest >= half is false, and would be true for the entry half in its place.
    row(s, "rewrite-entry")["claim"] = ["<=", "half", "lowest"]
    p = proof(c, "rewrite-entry")
    p.update(steps=[["lowest", 1]], lhs=c["enclosures"]["half"], rhs=c["enclosures"]["lowest"])


@lie(1, "rewrite-entry")
def an_entry_that_makes_a_negative_side_easier(s, c):
    claim = ["<=", ["neg", "lowest"], ["neg", "half"]]
    row(s, "rewrite-entry")["claim"] = claim
    lhs, rhs = (["-0.4666666666666666667", "-0.4666666666666666666"], ["-0.5", "-0.5"])
    proof(c, "rewrite-entry").update(steps=[["lowest", 1]], lhs=lhs, rhs=rhs)


@lie(1, "rewrite-entry")
def an_entry_for_a_symbol_on_both_sides(s, c):
    row(s, "rewrite-entry")["claim"] = ["<=", "lowest", ["mul", "lowest", "1"]]
    p = proof(c, "rewrite-entry")
    p["rhs"] = p["lhs"]


@lie(1, "rewrite-entry")
def an_entry_in_an_even_power_of_unknown_sign(s, c):
    # (lowest - 12/25)^2 falls while lowest rises to 12/25, and rises afterwards.
    claim = ["<=", ["pow", ["sub", "lowest", "12/25"], "2"], "1/10"]
    row(s, "rewrite-entry")["claim"] = claim
    p = {"closing": "interval", "steps": [["lowest", 1]], "lhs": ["0", "1"], "rhs": ["0.1", "0.1"]}
    proof(c, "rewrite-entry").update(p)


@lie(4, "closing")
def an_unknown_closing(s, c):
    proof(c, "identity")["closing"] = "trust"


@lie(1, "identity")
def an_interval_that_closes_an_identity(s, c):
    proof(c, "identity")["closing"] = "interval"


@lie(1, "rewrite-root")
def an_identity_of_a_root_that_stays_a_name(s, c):
    proof(c, "rewrite-root")["steps"] = []


@lie(1, "rewrite-root")
def an_identity_with_a_root_of_another_sign(s, c):
    row(s, "rewrite-root")["claim"] = ["<=", ["neg", ["sqrt", ["pow", "root2", "2"]]], "root2"]
    p = {"lhs": ["-1.5", "-1.4"], "rhs": ["1.4", "1.5"], "steps": [["root2", None]]}
    proof(c, "rewrite-root").update(p)


# --- Bernstein, squares, division, roots --------------------------------------------------------


@lie(1, "bernstein")
def a_coefficient_negative_by_its_last_digit(s, c):
    row(s, "bernstein")["claim"][1][1] = f"{2 * 10**40 + 1}/{10**40}"


@lie(1, "bernstein")
def a_polynomial_with_roots(s, c):
    row(s, "bernstein")["claim"][1][1] = "3"


@lie(1, "bernstein")
def a_polynomial_that_is_zero(s, c):
    row(s, "bernstein")["claim"] = ["<", "x", "x"]


@lie(1, "bernstein")
def a_degree_too_small(s, c):
    proof(c, "bernstein")["degree"] = 1


@lie(4, "bernstein")
def a_degree_too_huge(s, c):
    proof(c, "bernstein")["degree"] = 10**8


@lie(4, "")
def a_degree_below_zero(s, c):
    proof(c, "bernstein")["degree"] = -1


@lie(4, "bernstein")
def a_degree_that_is_true(s, c):
    proof(c, "bernstein")["degree"] = True


@lie(1, "bernstein")
def bernstein_for_two_variables(s, c):
    row(s, "bernstein")["variables"]["y"] = ["0", "1"]


@lie(1, "bernstein")
def bernstein_without_an_upper_end(s, c):
    row(s, "bernstein")["variables"]["x"] = ["0", None]


@lie(1, "bernstein")
def bernstein_with_an_irrational_coefficient(s, c):
    row(s, "bernstein")["claim"][1][1] = "root2"


@lie(1, "bernstein")
def bernstein_for_an_equality(s, c):
    row(s, "bernstein")["claim"] = ["=", "x", "x"]


@lie(1, "bernstein")
def bernstein_for_a_quotient_by_the_variable(s, c):
    row(s, "bernstein")["claim"] = ["<", ["div", "x", "x"], "2"]


@lie(1, "square")
def a_negative_side_in_a_square(s, c):
    row(s, "square")["claim"] = ["<", ["neg", "root2"], ["neg", "root3"]]
    proof(c, "square").update(lhs=["-1.5", "-1.4"], rhs=["-1.8", "-1.7"])


@lie(1, "square")
def a_square_that_does_not_hold(s, c):
    row(s, "square")["claim"][2] = ["sqrt", "9"]
    proof(c, "square")["rhs"] = ["3", "3"]


@lie(4, "square")
def a_square_without_a_proof(s, c):
    del proof(c, "square")["then"]


@lie(4, "square")
def a_square_of_a_trusted_claim(s, c):
    proof(c, "square")["then"] = {"rule": "trust", "bits": 128}


@lie(1, "")
def squares_of_squares_until_the_numbers_are_huge(s, c):
    then: Json = {"rule": "interval", "bits": 65536}
    for _ in range(40):
        then = {"rule": "square", "bits": 65536, "then": then}
    proof(c, "square")["then"] = then


@lie(1, "pow")
def a_division_by_zero(s, c):
    row(s, "pow")["claim"][1] = ["div", "1", ["sub", "root2", "root2"]]


@lie(1, "exact")
def an_exact_division_by_zero(s, c):
    row(s, "exact")["claim"] = ["=", ["div", "0", "0"], ["div", "0", "0"]]


@lie(1, "identity")
def an_identity_that_divides_by_zero(s, c):
    row(s, "identity")["claim"] = ["=", ["div", "1", ["sub", "r", "r"]]] * 1 + [
        ["div", "1", ["sub", "r", "r"]]
    ]


@lie(1, "constant half")
def a_constant_that_divides_by_zero(s, c):
    constant(s, "half")["term"][2] = "0"


@lie(1, "pow")
def a_square_root_of_a_negative_number(s, c):
    row(s, "pow")["claim"][1] = ["sqrt", ["neg", "root2"]]


@lie(1, "interval-box")
def a_square_root_over_a_box_with_negative_numbers(s, c):
    row(s, "interval-box")["claim"][1] = ["sqrt", ["sub", "x", "1/2"]]


@lie(1, "cuts")
def a_square_root_undefined_in_one_box(s, c):
    row(s, "cuts")["claim"][1] = ["mul", "0", ["sqrt", ["sub", "1", ["mul", "5/4", "x"]]]]


# --- rules and proofs ---------------------------------------------------------------------------


@lie(4, "trust")
def an_unknown_rule(s, c):
    proof(c, "interval")["rule"] = "trust"


@lie(4, "prove")
def a_rule_named_as_a_function_of_the_checker(s, c):
    proof(c, "interval")["rule"] = "prove"


@lie(1, "interval")
def a_rule_of_the_wrong_kind(s, c):
    proof(c, "interval").update(rule="witness", point={})


@lie(4, "interval")
def a_rule_with_the_fields_of_another(s, c):
    proof(c, "interval")["cuts"] = {}


@lie(4, "rule")
def a_proof_without_a_rule(s, c):
    del proof(c, "interval")["rule"]


@lie(1, "interval-tight")
def bits_too_few(s, c):
    proof(c, "interval-tight")["bits"] = 64


for name, bits in {
    "zero": 0,
    "one": 1,
    "huge": 10**8,
    "enormous": 10**40,
    "negative": -128,
    "true": True,
    "as_a_text": "128",
    "as_a_float": 128.0,
    "infinite": float("inf"),
    "not_a_number": float("nan"),
}.items():

    def change(s, c, bits=bits):
        proof(c, "interval")["bits"] = bits

    change.__name__ = f"bits_{name}"
    lie(4, "")(change)


@lie(4, "proofs")
def proofs_in_another_order(s, c):
    swap(c["proofs"], 0, 1)


@lie(4, "proofs")
def a_proof_missing(s, c):
    c["proofs"].pop()


@lie(4, "proofs")
def a_proof_too_many(s, c):
    c["proofs"].append(c["proofs"][0])


@lie(4, "proofs")
def no_proofs(s, c):
    c["proofs"] = []


@lie(4, "obligations")
def no_obligations(s, c):
    s["obligations"], c["proofs"] = [], []


@lie(4, "interval")
def an_obligation_twice(s, c):
    s["obligations"].insert(1, s["obligations"][0])
    c["proofs"].insert(1, c["proofs"][0])


@lie(4, "model")
def an_obligation_with_the_name_of_an_assumption(s, c):
    s["assumptions"][1]["name"] = "model"


# --- names --------------------------------------------------------------------------------------


@lie(4, "root2")
def a_constant_twice(s, c):
    s["constants"].append(constant(s, "root2"))


@lie(4, "lowest")
def a_constant_before_its_definition(s, c):
    swap(s["constants"], 0, 3)


@lie(4, "half")
def a_constant_defined_by_itself(s, c):
    constant(s, "half")["term"] = ["div", "half", "1"]


@lie(4, "r")
def a_constant_that_shadows_a_parameter(s, c):
    constant(s, "half")["name"] = "r"


@lie(4, "root2")
def a_variable_that_shadows_a_constant(s, c):
    row(s, "interval")["variables"] = {"root2": ["0", "1"]}
    del proof(c, "interval")["lhs"], proof(c, "interval")["rhs"]


@lie(4, "interval")
def a_variable_of_another_obligation(s, c):
    row(s, "interval")["claim"][1] = "x"


@lie(4, "root5")
def an_unknown_symbol(s, c):
    row(s, "interval")["claim"][1] = "root5"


@lie(4, "name")
def a_name_that_is_a_number(s, c):
    s["parameters"]["2"] = "3"


@lie(4, "name")
def a_name_with_a_line_feed(s, c):
    s["parameters"]["PROVED\nPROVED"] = "3"


@lie(4, "rumour")
def an_unknown_assumption(s, c):
    row(s, "interval")["uses"] = ["rumour"]


@lie(4, "role")
def an_unknown_role(s, c):
    row(s, "interval")["role"] = "optional"


@lie(4, "format")
def an_unknown_format_of_the_statement(s, c):
    s["format"] = "verify-statement/2"


@lie(4, "format")
def an_unknown_format_of_the_certificate(s, c):
    c["format"] = "verify-certificate/0"


@lie(4, "format")
def the_two_formats_swapped(s, c):
    s["format"], c["format"] = c["format"], s["format"]


@lie(4, "proved")
def an_unknown_key(s, c):
    s["proved"] = "all"


@lie(4, "skip")
def an_unknown_key_of_an_obligation(s, c):
    row(s, "interval")["skip"] = "true"


@lie(4, "trusted")
def an_unknown_key_of_a_proof(s, c):
    proof(c, "interval")["trusted"] = "true"


@lie(4, "found")
def a_missing_key(s, c):
    del s["assumptions"]


@lie(4, "found")
def a_missing_key_of_an_obligation(s, c):
    del row(s, "interval")["role"]


@lie(4, "found")
def a_missing_key_of_the_certificate(s, c):
    del c["enclosures"]


# --- terms --------------------------------------------------------------------------------------

TERMS: dict[str, Json] = {
    "an_unknown_operation": ["log", "2"],
    "an_operation_that_the_checker_has_inside": ["rational", "1", "2"],
    "an_operation_named_symbol": ["symbol", "root2"],
    "an_operation_that_is_a_list": [["add"], "1", "1"],
    "an_operation_without_arguments": ["add"],
    "an_operation_with_one_argument_too_few": ["sub", "1"],
    "an_operation_with_one_argument_too_many": ["add", "1", "1", "1"],
    "a_root_of_two_arguments": ["sqrt", "1", "2"],
    "a_min_with_one_entry": ["min", "1"],
    "a_max_without_entries": ["max"],
    "a_power_with_exponent_zero": ["pow", "1", "0"],
    "a_power_with_a_negative_exponent": ["pow", "1", "-1"],
    "a_power_with_a_huge_exponent": ["pow", "1", "1000000"],
    "a_power_with_a_fraction_as_exponent": ["pow", "1", "1/2"],
    "a_power_with_a_number_as_exponent": ["pow", "1", 2],
    "a_power_with_a_term_as_exponent": ["pow", "1", ["add", "1", "1"]],
    "a_power_without_an_exponent": ["pow", "1"],
    "an_empty_term": [],
    "an_empty_text": "",
    "a_term_that_is_a_number": 1,
    "a_term_that_is_a_float": 1.25,
    "a_term_that_is_nan": float("nan"),
    "a_term_that_is_infinite": float("-inf"),
    "a_term_that_is_the_text_nan": "NaN",
    "a_term_that_is_the_text_infinity": "Infinity",
    "a_term_that_is_null": None,
    "a_term_that_is_true": True,
    "a_term_that_is_an_object": {"add": ["1", "1"]},
    "a_term_that_is_a_decimal": "1.25",
    "a_term_that_is_a_power_of_ten": "1e3",
    "a_denominator_zero": "1/0",
    "a_denominator_that_is_many_zeros": "1/000",
    "a_sign_in_the_denominator": "1/-2",
    "a_leading_plus": "+1",
    "a_leading_zero": "01",
    "two_signs": "--1",
    "a_space_before_a_rational": " 1",
    "a_space_inside_a_rational": "1 /2",
    "a_line_feed_after_a_rational": "1\n",
    "an_underscore_in_a_rational": "1_0",
    "arabic_digits": "١/٢",
    "a_superscript": "1²",
    "two_slashes": "1/2/3",
    "a_number_above_the_digits_that_are_read": "1" * 5000,
    "a_lone_surrogate": "\ud800",
    "a_null_character": "1\0",
}
for name, term in TERMS.items():

    def change(s, c, term=term):
        row(s, "interval")["claim"][1] = term

    change.__name__ = name
    lie(4, "")(change)


@lie(4, "")
def a_term_with_too_many_levels(s, c):
    for i in range(90):
        term: Json = f"deep{i - 1}" if i else "1"
        for _ in range(50):
            term = ["neg", term]
        s["constants"].append({"name": f"deep{i}", "label": "", "tex": "", "term": term})
        c["enclosures"][f"deep{i}"] = ["1", "1"]


@lie(1, "")
def a_tower_of_powers(s, c):
    for i in range(30):
        term = ["pow", f"tower{i - 1}" if i else "3/2", "999"]
        s["constants"].append({"name": f"tower{i}", "label": "", "tex": "", "term": term})
        c["enclosures"][f"tower{i}"] = ["1", "1"]


@lie(1, "found")
def more_work_than_the_checker_does(s, c):
    cuts = [f"{i}/3000" if i else "0" for i in range(3000)] + ["1"]
    proof(c, "cuts-two")["cuts"] = {
        "x": cuts,
        "y": ["1", *(f"{3000 + i}/3000" for i in range(1, 3000)), "2"],
    }


@lie(1, "identity")
def an_expansion_without_end(s, c):
    total = ["add", ["add", "root2", "root3"], ["add", "half", ["add", "cosine", "third-turn"]]]
    power = ["pow", ["pow", total, "999"], "999"]
    row(s, "identity")["claim"] = ["=", power, ["mul", power, "1"]]


# --- bytes --------------------------------------------------------------------------------------


@raw(4, "statement_sha256")
def a_forged_digest(first, second):
    certificate = json.loads(second)
    certificate["statement_sha256"] = "0" * 64
    return first, json.dumps(certificate).encode()


@raw(4, "statement_sha256")
def a_digest_of_other_bytes(first, second):
    return first + b"\n", second


@raw(4, "statement_sha256")
def a_digest_in_capitals(first, second):
    certificate = json.loads(second)
    certificate["statement_sha256"] = certificate["statement_sha256"].upper()
    return first, json.dumps(certificate).encode()


@raw(4, "statement_sha256")
def a_digest_that_is_empty(first, second):
    certificate = json.loads(second)
    certificate["statement_sha256"] = ""
    return first, json.dumps(certificate).encode()


@raw(4, "statement_sha256")
def no_digest(first, second):
    certificate = json.loads(second)
    del certificate["statement_sha256"]
    return first, json.dumps(certificate).encode()


@raw(4, "title")
def a_key_twice(first, second):
    return bind(first.replace(b'"title":', b'"title": "Another", "title":', 1), second)


@raw(4, "root2")
def a_key_of_an_inner_object_twice(first, second):
    return first, second.replace(b'"root2":', b'"root2": ["1", "2"], "root2":', 1)


@raw(4, "twice")
def a_key_twice_with_an_escape(first, second):
    return first, second.replace(b'"proofs":', b'"\\u0070roofs": [], "proofs":', 1)


@raw(4, "")
def trailing_junk(first, second):
    return bind(first + b"{}", second)


@raw(4, "")
def trailing_junk_in_the_certificate(first, second):
    return first, second + b"true"


@raw(4, "")
def a_certificate_that_is_cut_off(first, second):
    return first, second[: len(second) // 2]


@raw(4, "")
def bytes_that_are_not_utf_8(first, second):
    return bind(first.replace(b"A small theorem", b"A sm\xffll theorem"), second)


@raw(4, "")
def an_encoded_surrogate(first, second):
    return bind(first.replace(b"A small theorem", b"\xed\xa0\x80"), second)


@raw(4, "")
def a_byte_order_mark(first, second):
    return bind(b"\xef\xbb\xbf" + first, second)


@raw(4, "")
def a_statement_in_utf_16(first, second):
    return bind(first.decode().encode("utf-16"), second)


@raw(4, "")
def an_empty_statement(first, second):
    return bind(b"", second)


@raw(4, "")
def an_empty_certificate(first, second):
    return first, b""


@raw(4, "")
def a_list_instead_of_an_object(first, second):
    return bind(b"[" + first + b"]", second)


@raw(4, "")
def a_certificate_that_is_null(first, second):
    return first, b"null"


@raw(4, "")
def two_certificates(first, second):
    return first, second + second


@raw(4, "")
def a_control_character_in_a_text(first, second):
    return bind(first.replace(b"A small theorem", b"A\x00small"), second)


@raw(4, "statement_sha256")
def the_two_files_are_the_same(first, second):
    return first, first


def deep(left: bytes, right: bytes) -> bytes:
    return left * 100_000 + b'"1"' + right * 100_000


@raw(4, "")
def nesting_of_lists(first, second):
    return bind(first.replace(b'"1/3"', deep(b"[", b"]"), 1), second)


@raw(4, "")
def nesting_of_negations(first, second):
    return bind(first.replace(b'"1/3"', deep(b'["neg",', b"]"), 1), second)


@raw(4, "")
def nesting_of_objects(first, second):
    return first, deep(b'{"a":', b"}")


@raw(4, "")
def nesting_that_never_ends(first, second):
    return first, b"[" * 100_000


@raw(4, "")
def nesting_of_squares(first, second):
    inner = b'{"rule":"square","bits":2,"then":' * 100_000 + b"1" + b"}" * 100_000
    return first, second.replace(b'"then": {', b'"then": ' + inner + b',"then": {', 1)


@raw(4, "")
def a_text_of_10_mb_as_a_number(first, second):
    return bind(first.replace(b'"1/3"', b'"' + b"9" * 10_000_000 + b'"', 1), second)


@raw(4, "")
def a_number_of_10_mb(first, second):
    return first, second.replace(b'"bits": 128', b'"bits": ' + b"9" * 10_000_000, 1)


@raw(4, "")
def a_number_of_3_mb(first, second):
    return first, second.replace(b'"bits": 128', b'"bits": ' + b"9" * 3_000_000, 1)


@raw(4, "")
def a_text_of_3_mb_as_a_number(first, second):
    return bind(first.replace(b'"1/3"', b'"' + b"9" * 3_000_000 + b'"', 1), second)


@raw(4, "")
def a_file_of_20_mb(first, second):
    return bind(first + b" " * 20_000_000, second)


@raw(4, "")
def a_certificate_of_20_mb(first, second):
    return first, second + b"\n" * 20_000_000
