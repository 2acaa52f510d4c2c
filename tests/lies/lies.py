"""Lies: pairs that must not pass, each named after its attack, with a code and a reason.

An attack changes an honest pair; what is false afterwards must be answered with ``incorrect`` (1)
or ``malformed`` (4), and with a word of why.
"""

from __future__ import annotations

import copy
import json
from collections.abc import Callable
from hashlib import sha256
from typing import NamedTuple

from tests.check.support import (
    ANGLES,
    BOUNDS,
    COSINE,
    IDENTITY,
    INTERVAL,
    ROOT,
    Json,
    Pair,
    box,
    cases,
    cuts,
    entry,
    induction,
    instance,
    interval,
    least,
    pack,
    term,
    total,
    witness,
)  # fmt: skip

Files = tuple[bytes, bytes]
INCORRECT, MALFORMED = 1, 4


class Lie(NamedTuple):
    """Files that must not pass."""

    files: Callable[[], Files]
    code: int
    word: str


LIES: dict[str, Lie] = {}


def register(name: str, code: int, word: str, files: Callable[[], Files]) -> None:
    """Every lie has a name of its own."""
    if name in LIES:
        raise ValueError(f"two lies have the name {name}")
    LIES[name] = Lie(files, code, word)


# --- an honest pair, in which most rules occur ----------------------------------------------------


def honest() -> Pair:
    """Most rules, contexts inside one another, a refuted printed row, an undecided printed row."""
    pair = Pair().assume("law")
    pair.statement["terms"]["half"] = ["mul", "q", "x"]
    pair.parameter("q", "1/2").constant("m", "min(sqrt(2) - 1, 3)", INTERVAL)
    givens = {"x-pos": ("0 < x", "carried", None), "x-high": ("x <= 1", "carried", None)}
    pair.context("state", {"x": "1"}, givens).inner("state", "d", "x*x")
    premises = [total("goal"), total("goal", "x-pos")]
    pair.context("time", {"t": "0"}, {"t-low": "0 <= t", "t-high": "t <= x"}, premises, "state")
    pair.steps[-1]["givens"] = [INTERVAL, total("goal", "x-pos")]
    pair.context("free", {"v": "1"}, {"v-low": ("0 <= v", "standing", "law")})
    x = interval(("x", "x-pos", "x-high"))
    pair.row("half-pos", "0 < half", total("goal", ["mul", "1/2", "x-pos"], using=["q"]), "state")
    pair.lemma("half-high", "half <= 1", x, "state")
    pair.row("m-less", "m < 1/2", INTERVAL).row("m-entry", "m <= sqrt(2) - 1", entry("lhs", "m"))
    pair.lemma("two", "0 <= 2", INTERVAL)
    pair.row("least", "0 < m", least("rhs", INTERVAL, INTERVAL, equation="m"))
    both = [total(using=["@1"])] * 2
    pair.row(
        "cases", "(min(x, 1/2) - x)*(min(x, 1/2) - 1/2) = 0", cases("min(x, 1/2)", *both), "state"
    )
    pair.row("root", "0 < sqrt(x)", ROOT, "state")
    low, high = interval(("x", "x-pos", "@1")), interval(("x", "@1", "x-high"))
    pair.row("cuts", "x*(1 - x) <= 1/2", cuts("x", ["1/2"], low, high), "state")
    pair.row("cube", "0 <= v*v*v", total("goal", ["pow", "v-low", "3"]), "free")
    pair.row(
        "instance", "0 <= x*x*x", instance("cube", {"v": "x"}, total("goal", "x-pos")), "state"
    )
    apply = {"rule": "instance", "givens": [total("goal", "x-pos", "t-low")]}
    pair.row("applies", ["applies", "free", {"v": ["add", "x", "t"]}], apply, "time")
    proof = induction([INTERVAL, INTERVAL], ["half-pos", "half-high"])
    pair.row("always", ["always", "state", {"x": "1"}, {"x": "half"}], proof)
    lie = witness({"x": "1"}, [INTERVAL, INTERVAL], INTERVAL)
    pair.row("refuted", "x < 1/2", lie, "state", "refuted", "printed")
    pair.row("cosine", "cos_pi(1/2) = 1", INTERVAL, None, "refuted", "printed")
    pair.row("open-question", "m < 1/3", None, None, "undecided", "printed")
    pair.define("e", "d + 1", context="state")
    pair.lemma("e-high", "e <= 2", x, "state")
    rational = {"bits": 64, "ends": ["0.5", "0.5"]}
    pair.enclosures["constants"] = {
        "q": rational,
        "m": {"bits": 64, "ends": ["0.41421", "0.41422"]},
    }
    return pair


Change = Callable[[Pair], object]


def lie(code: int, word: str) -> Callable[[Change], Change]:
    """A change of the honest pair, in place; the digest is computed afterwards."""

    def decorate(change: Change) -> Change:
        def files() -> Files:
            pair = honest()
            change(pair)
            return pair.files()

        register(change.__name__.replace("_", "-"), code, word, files)
        return change

    return decorate


def row(pair: Pair, name: str) -> Json:
    """An obligation."""
    return next(item for item in pair.statement["obligations"] if item["name"] == name)


def of(pair: Pair, name: str) -> Json:
    """The step of an obligation, lemma, constant, definition or context."""
    kinds = ("obligation", "lemma", "constant", "define", "open")
    return next(item for item in pair.steps if any(item.get(kind) == name for kind in kinds))


def given(pair: Pair, claim: str) -> None:
    """Another given of ``free``, with rows of its own only."""
    item = {"name": "odd", "claim": term(claim), "kind": "plain", "assumption": None}
    context(pair, "free")["givens"].append(item)
    of(pair, "free")["givens"].append(INTERVAL)
    for name in ("applies", "instance"):
        pair.statement["obligations"].remove(row(pair, name))
        pair.steps.remove(of(pair, name))


def context(pair: Pair, name: str) -> Json:
    """A context."""
    return next(item for item in pair.statement["contexts"] if item["name"] == name)


# --- a family of claims that are false or senseless, for each kind of proof -----------------------

PROOFS: dict[str, Json] = {
    "interval": INTERVAL,
    "interval-bounded": interval(BOUNDS),
    "identity": IDENTITY,
    "sum": total("goal"),
    "sum-with-facts": total("goal", "x-low", "x-high"),
    "entry-of-lhs": entry("lhs"),
    "entry-of-rhs": entry("rhs"),
    "root": ROOT,
    "cuts": cuts("x", ["1/2"], interval(("x", "x-low", "@1")), interval(("x", "@1", "x-high"))),
    "least-of-rhs": least("rhs", interval(BOUNDS), interval(BOUNDS)),
    "least-of-lhs": least("lhs", interval(BOUNDS), interval(BOUNDS)),
    "cases": cases("min(x, 1/2)", total("goal", "@2", using=["@1"]), total("goal", using=["@1"])),
    "antisymmetry": {"rule": "antisymmetry", "branches": [interval(BOUNDS), interval(BOUNDS)]},
    "antisymmetry-of-goals": {"rule": "antisymmetry", "branches": [total("goal"), total("goal")]},
    "angles": ANGLES,
    "cosine": COSINE,
}
SQUARE = ["pow", "x", "2"]
FALSE = {
    "a-strict-bound-at-its-end": "x < 1",
    "a-bound-below-the-end": "x <= 99/100",
    "equal-numbers-in-order": "1 < 1",
    "a-minimum-with-an-undefined-entry": "min(x, 1/(x - x)) <= x",
    "a-maximum-with-an-undefined-entry": "x <= max(x, 1/(x - x))",
    "a-minimum-with-an-undefined-root": "min(x, sqrt(x - 2)) <= x",
    "a-quotient-by-what-may-be-zero": "0 <= x/x",
    "a-product-of-zero-and-nothing": "0*(1/(x - x)) <= 1",
    "a-root-of-what-may-be-negative": "0 <= sqrt(x - 1/2)",
    "an-entry-that-is-none": "min(x, 1/2) <= 1/3",
    "an-entry-on-the-wrong-side": "max(x, 1/2) <= x",
    "a-minimum-above-an-entry": "1/2 <= min(x, 1/2)",
    "a-root-that-may-be-zero": "0 < sqrt(x)",
    "two-names-for-one": "x = 1/2",
    "a-square-below-zero": "x*x < 0",
    "a-cosine-above-one": "1 < cos(x)",
    "a-power-that-falls": "x <= x**3",
    "a-cosine-of-nothing": "cos(1/(x - x)) <= 1",
    "a-sum-of-angles-of-nothing": "2*(cos(1/(x - x))*cos(x)) = cos(1/(x - x) + x) + cos(0)",
    "angles-in-another-order": "2*(cos(x)*cos(1)) = cos(x - 1) + cos(x - 1)",
    "a-cosine-that-is-a-sine": "2*(cos_pi(x)*cos_pi(1/2)) = cos_pi(x) + cos_pi(x)",
    "a-parabola-that-is-too-wide": ["<=", ["add", "1", ["mul", SQUARE, "-1/4"]], ["cos", "x"]],
    "a-parabola-on-the-other-side": ["<=", ["cos", "x"], ["add", "1", ["mul", SQUARE, "-1/2"]]],
    "a-line-below-a-cosine": ["<=", ["add", "1", ["mul", "x", "-1/4"]], ["cos", "x"]],
    "a-parabola-of-another-angle": ["<=", ["add", "1", ["mul", SQUARE, "-1/2"]], ["cos", "2"]],
    "a-sine-below-its-tangent": ["<=", ["mul", "x", "4"], ["cos_pi", ["sub", "1/2", "x"]]],
    "a-sine-of-less": ["<=", ["cos_pi", ["sub", "1/2", "x"]], ["mul", "x", "1"]],
    "a-series-with-a-name": ["<=", ["add", "1", ["mul", SQUARE, "x"]], ["cos", "x"]],
}
for claim_name, claim in FALSE.items():
    for proof_name, proof in PROOFS.items():

        def false_files(claim: Json = claim, proof: Json = proof) -> Files:
            return box(("0", "1")).row("row", claim, copy.deepcopy(proof), "box").files()

        register(f"{claim_name}-by-{proof_name}", 0, "", false_files)


# --- whole proofs of what is false, each with one wrong step -----------------------------


def proof_of(claim: str, proof: Json, low: str = "-1") -> Callable[[], Files]:
    return lambda: box((low, "1")).row("row", claim, proof, "box").files()


def a_bound_by_a_maximum() -> Files:
    pair = box(("0", "1")).lemma("le", "x <= max(x, 2)", entry("rhs"), "box")
    return pair.row("row", "2 <= x", entry("rhs", "le"), "box").files()


def a_divisor_that_is_the_second_term() -> Files:
    pair = Pair().context("c", {"p": "0", "x": "1"}, {"pos": "0 < x"})
    return pair.row("row", "1/p = 1/p", IDENTITY, "c").files()


ROOTS = "sqrt(x) = sqrt(x)"
WHOLE = {
    "a-sine-of-negative-angles": proof_of("cos_pi(1/2 - x) <= x*4", COSINE),
    "a-sine-whose-angle-is-known-elsewhere": proof_of(
        "cos_pi(1/2 - x) <= x*4", cuts("x", ["0"], COSINE, COSINE)
    ),
    "one-order-for-both": proof_of(
        "x = 1", {"rule": "antisymmetry", "branches": [total("goal", "x-high")] * 2}, "0"
    ),
    "an-inequality-used-as-an-equation": proof_of("x = 1", total(using=["x-high"])),
    "an-inequality-used-as-a-definition": a_bound_by_a_maximum,
    "a-comparison-of-a-term-with-itself-as-a-sign": proof_of(
        ROOTS, cases("max(x, x)", IDENTITY, IDENTITY)
    ),
    "a-sign-of-another-term": proof_of(ROOTS, cases("max(0, 0)", IDENTITY, IDENTITY)),
    "a-divisor-that-is-the-second-term": a_divisor_that_is_the_second_term,
    "a-weak-sign-of-a-divisor": proof_of("x/x = 1", IDENTITY, "0"),
    "the-negative-of-what-is-known": proof_of("sqrt(-x) = sqrt(-x)", IDENTITY, "0"),
    "an-operation-taken-for-a-case": proof_of(
        "1 <= x", cases("1 + 1", *[total("goal", equations=[("@1", "-1")])] * 2)
    ),
}
for whole_name, whole in WHOLE.items():
    register(whole_name, INCORRECT, "", whole)


# --- values put in the place of others ------------------------------------------------------------

ODD: dict[str, Json] = {
    "null": None, "true": True, "false": False, "zero": 0, "minus-one": -1, "an-object": {},
    "a-list": [], "a-text": "text", "an-empty-text": "", "a-float": 1.5, "a-nested-list": [[[]]],
    "arabic-digits": "\u0663", "a-large-number": 10**30,
}  # fmt: skip
SPOTS: dict[str, Callable[[Pair, Json], object]] = {
    "the-format": lambda pair, v: pair.statement.update(format=v),
    "the-parameters": lambda pair, v: pair.statement.update(parameters=v),
    "the-terms": lambda pair, v: pair.statement.update(terms=v or None),
    "the-constants": lambda pair, v: pair.statement.update(constants=v or None),
    "a-context": lambda pair, v: pair.statement["contexts"].append(v),
    "a-given": lambda pair, v: context(pair, "free")["givens"].append(v),
    "a-point": lambda pair, v: context(pair, "free")["point"].update(v=v),
    "a-parent": lambda pair, v: context(pair, "time").update(parent=v),
    "an-obligation": lambda pair, v: pair.statement["obligations"].append(v),
    "a-role": lambda pair, v: row(pair, "root").update(role=v),
    "a-verdict": lambda pair, v: row(pair, "root").update(verdict=v),
    "a-claim": lambda pair, v: row(pair, "root").update(claim=v),
    "a-side": lambda pair, v: row(pair, "root")["claim"].__setitem__(1, v),
    "a-relation": lambda pair, v: row(pair, "root")["claim"].__setitem__(0, v),
    "an-exponent": lambda pair, v: row(pair, "root")["claim"].__setitem__(2, ["pow", "x", v]),
    "a-cite": lambda pair, v: pair.statement["cites"].append(v),
    "a-step": lambda pair, v: pair.steps.append(v),
    "a-proof": lambda pair, v: of(pair, "root").update(proof=v),
    "a-rule": lambda pair, v: of(pair, "root").update(proof={"rule": v}),
    "a-premise": lambda pair, v: of(pair, "always")["proof"]["next"].__setitem__(0, v),
    "a-branch": lambda pair, v: of(pair, "cuts")["proof"]["branches"].__setitem__(0, v),
    "an-addend": lambda pair, v: of(pair, "cube")["proof"]["addends"].append(v or {}),
    "a-cofactor": lambda pair, v: of(pair, "cube")["proof"]["equations"].append(["q", v or {}]),
    "bits": lambda pair, v: of(pair, "m-less")["proof"].update(bits=v),
    "an-end": lambda pair, v: pair.enclosures["constants"].update(
        q={"bits": 64, "ends": ["0.5", v]}
    ),
    "all-steps": lambda pair, v: setattr(pair, "steps", v),
    "a-cut": lambda pair, v: of(pair, "cuts")["proof"].update(at=[v]),
    "a-bound": lambda pair, v: of(pair, "half-high")["proof"].update(bounds=[v]),
    "a-reference": lambda pair, v: of(pair, "m-entry")["proof"].update(equation=v),
}
for spot_name, put in SPOTS.items():
    for odd_name, odd in ODD.items():

        def odd_files(put: Callable[[Pair, Json], object] = put, odd: Json = odd) -> Files:
            pair = honest()
            put(pair, copy.deepcopy(odd))
            return pair.files()

        register(f"{odd_name}-for-{spot_name}", 0, "", odd_files)

# --- what is proved -------------------------------------------------------------------------------


@lie(INCORRECT, "expected < between them")
def a_bound_moved_by_its_last_digit(pair: Pair) -> None:
    row(pair, "m-less")["claim"][2] = "4142135623730950488/10000000000000000000"


@lie(INCORRECT, "found a number".replace("a number", ""))
def a_weak_bound_made_strict(pair: Pair) -> None:
    row(pair, "cube")["claim"][0] = "<"


@lie(INCORRECT, "found <, expected <=")
def an_entry_strictly_above_the_minimum(pair: Pair) -> None:
    row(pair, "m-entry")["claim"][0] = "<"


@lie(INCORRECT, "found a side that is no entry of the min")
def an_entry_of_another_minimum(pair: Pair) -> None:
    row(pair, "m-entry")["claim"][2] = "2"


@lie(INCORRECT, "expected < between them")
def the_verdicts_exchanged(pair: Pair) -> None:
    row(pair, "m-less")["verdict"] = "refuted"
    row(pair, "m-less")["role"] = "printed"
    of(pair, "m-less")["proof"] = interval()
    row(pair, "m-less")["claim"] = ["<=", "m", "1/2"]


@lie(MALFORMED, "expected one of ['interval'")
def a_refuted_row_called_proved(pair: Pair) -> None:
    row(pair, "refuted")["verdict"] = "proved"


@lie(INCORRECT, "m-less: a needed row is undecided")
def a_needed_row_left_undecided(pair: Pair) -> None:
    row(pair, "m-less")["verdict"] = "undecided"
    pair.steps.remove(of(pair, "m-less"))


@lie(MALFORMED, "found a proof of an undecided row")
def an_undecided_row_with_a_proof(pair: Pair) -> None:
    pair.step(obligation="open-question", proof=INTERVAL)


@lie(MALFORMED, "found no needed row, which proves nothing")
def no_needed_row(pair: Pair) -> None:
    for item in pair.statement["obligations"]:
        item["role"] = "printed"


@lie(MALFORMED, "found no needed row, which proves nothing")
def no_obligations(pair: Pair) -> None:
    pair.statement["obligations"] = []


@lie(MALFORMED, "steps: found none for ['root']")
def a_row_without_a_step(pair: Pair) -> None:
    pair.steps.remove(of(pair, "root"))


@lie(MALFORMED, "steps: found none for ['m']")
def a_constant_without_a_step(pair: Pair) -> None:
    pair.steps.remove(of(pair, "m"))
    for name in ("m-entry", "least"):
        pair.statement["obligations"].remove(row(pair, name))
        pair.steps.remove(of(pair, name))


@lie(MALFORMED, "found free, which is not open so far")
def a_context_that_never_opens(pair: Pair) -> None:
    pair.steps.remove(of(pair, "free"))


@lie(MALFORMED, "open free: found a second step")
def a_context_opened_twice(pair: Pair) -> None:
    pair.steps.append(of(pair, "free"))


@lie(MALFORMED, "obligation root: found a second step")
def a_row_proved_twice(pair: Pair) -> None:
    pair.steps.append(of(pair, "root"))


@lie(MALFORMED, "lemma two: found the name two twice")
def a_lemma_proved_twice(pair: Pair) -> None:
    pair.steps.append(of(pair, "two"))


@lie(MALFORMED, "found time, which is not open")
def a_child_opened_before_its_parent(pair: Pair) -> None:
    pair.steps.remove(of(pair, "time"))


@lie(MALFORMED, "found half-pos, which is no fact so far")
def a_fact_used_before_it_is_proved(pair: Pair) -> None:
    pair.steps.append(pair.steps.pop(pair.steps.index(of(pair, "half-pos"))))


@lie(MALFORMED, "found root, which is no fact so far")
def a_row_proved_by_itself(pair: Pair) -> None:
    of(pair, "root")["proof"] = total("goal", "root")


@lie(INCORRECT, "REFUSED open free")
def a_context_without_a_point(pair: Pair) -> None:
    context(pair, "free")["point"]["v"] = "-1"


@lie(INCORRECT, "REFUSED open free: found a division")
def a_point_that_is_undefined(pair: Pair) -> None:
    context(pair, "free")["point"]["v"] = ["div", "1", ["sub", "1", "1"]]


@lie(INCORRECT, "REFUSED open free: found a division")
def a_given_with_an_undefined_side(pair: Pair) -> None:
    given(pair, "v <= 1/v")


@lie(INCORRECT, "REFUSED open free: found a division")
def a_given_defined_by_a_later_one(pair: Pair) -> None:
    given(pair, "0 < v")
    context(pair, "free")["givens"][0]["claim"] = term("0 <= 1/v")


@lie(INCORRECT, "REFUSED open free")
def contradictory_givens(pair: Pair) -> None:
    given(pair, "v < 0")


@lie(MALFORMED, "found 0 proofs, expected 1")
def a_given_without_a_proof_at_the_point(pair: Pair) -> None:
    of(pair, "free")["givens"] = []


@lie(MALFORMED, "open free: found v-low, which is no fact so far")
def a_given_that_proves_itself_at_the_point(pair: Pair) -> None:
    of(pair, "free")["givens"] = ["v-low"]


@lie(MALFORMED, "point: found a name of free, which is not in scope")
def a_point_over_the_context_itself(pair: Pair) -> None:
    context(pair, "free")["point"]["v"] = "v"


@lie(MALFORMED, "found a fact of state only".replace("found a fact", "which is a fact"))
def a_fact_of_a_child(pair: Pair) -> None:
    of(pair, "cube")["proof"]["addends"] = ["goal", "x-pos"]


@lie(MALFORMED, "which is a fact of free only")
def a_fact_of_a_sibling(pair: Pair) -> None:
    of(pair, "root")["proof"] = total("goal", "v-low")


@lie(MALFORMED, "found a name of state, which is not in scope")
def a_name_of_a_child(pair: Pair) -> None:
    row(pair, "m-less")["claim"][1] = "x"


@lie(MALFORMED, "found a name of state, which is not in scope")
def a_name_of_a_sibling(pair: Pair) -> None:
    row(pair, "cube")["claim"][1] = "x"


@lie(MALFORMED, "found names of state and free in a term")
def names_of_two_siblings_in_a_term(pair: Pair) -> None:
    row(pair, "cube")["claim"][1] = ["sub", "x", "v"]


@lie(MALFORMED, "found a name of state, which is not in scope")
def a_shared_term_of_a_sibling(pair: Pair) -> None:
    row(pair, "cube")["claim"][1] = "half"


@lie(MALFORMED, "found a name of state, which is not in scope")
def a_constant_of_a_context_at_the_root(pair: Pair) -> None:
    row(pair, "m-less")["claim"][1] = "d"


@lie(MALFORMED, "which is no name so far and no number")
def a_constant_of_the_certificate_in_the_statement(pair: Pair) -> None:
    row(pair, "root")["claim"][1] = "e"


@lie(MALFORMED, "found self, which is no name so far")
def a_shared_term_in_itself(pair: Pair) -> None:
    pair.statement["terms"]["self"] = ["add", "self", "1"]


@lie(MALFORMED, "which is no name so far")
def shared_terms_in_a_circle(pair: Pair) -> None:
    pair.statement["terms"] |= {"one": ["neg", "other"], "other": ["neg", "one"]}


@lie(MALFORMED, "found 1 proofs, expected 2")
def a_branch_missing(pair: Pair) -> None:
    of(pair, "cuts")["proof"]["branches"].pop()


@lie(MALFORMED, "found 1 proofs, expected 2")
def a_case_missing(pair: Pair) -> None:
    of(pair, "cases")["proof"]["branches"].pop()


@lie(MALFORMED, "found 1 proofs, expected 2")
def an_entry_missing(pair: Pair) -> None:
    of(pair, "least")["proof"]["branches"].pop()


@lie(MALFORMED, "found @3, which no branch adds")
def a_hypothesis_of_another_branch(pair: Pair) -> None:
    of(pair, "cuts")["proof"]["branches"][0] = interval(("x", "x-pos", "@3"))


@lie(MALFORMED, "found @1, which no branch adds")
def a_hypothesis_after_its_branch(pair: Pair) -> None:
    pair.lemma("after", "x <= 1/2", total("goal", "@1"), "state")


@lie(INCORRECT, "found a variable without bounds")
def a_variable_without_bounds(pair: Pair) -> None:
    of(pair, "half-high")["proof"]["bounds"] = []


@lie(INCORRECT, "found a proof".replace("found a proof", "found "))
def a_step_that_leads_away(pair: Pair) -> None:
    row(pair, "always")["claim"][3]["x"] = ["sub", "half", "1"]
    of(pair, "always")["proof"]["next"][0] = total("goal", ["mul", "1/2", "x-pos"])


@lie(INCORRECT, "neither carried nor standing: ['x-high']")
def a_given_that_is_not_carried(pair: Pair) -> None:
    context(pair, "state")["givens"][1]["kind"] = "plain"


@lie(MALFORMED, "found the assumption None of a standing given")
def a_standing_given_without_an_assumption(pair: Pair) -> None:
    context(pair, "free")["givens"][0]["assumption"] = None


@lie(MALFORMED, "found the assumption nobody of a standing given")
def a_standing_given_by_an_assumption_that_is_none(pair: Pair) -> None:
    context(pair, "free")["givens"][0]["assumption"] = "nobody"


@lie(MALFORMED, "which are no assumptions")
def an_assumption_used_and_not_listed(pair: Pair) -> None:
    row(pair, "root")["uses"] = ["nobody"]


@lie(MALFORMED, "assumptions: found a name twice")
def an_assumption_twice(pair: Pair) -> None:
    pair.assume("law")


@lie(INCORRECT, "found another claim than cube at these values")
def another_instance(pair: Pair) -> None:
    row(pair, "instance")["claim"][2] = ["mul", "x", "x"]


@lie(INCORRECT, "found a sum that is not 0")
def an_instance_outside_the_givens(pair: Pair) -> None:
    row(pair, "instance")["claim"] = term("0 <= (x - 2)*(x - 2)*(x - 2)")
    of(pair, "instance")["proof"]["at"]["v"] = term("x - 2")


@lie(INCORRECT, "found a witness".replace("found a witness", "expected <= between them"))
def a_witness_outside_the_givens(pair: Pair) -> None:
    row(pair, "refuted")["claim"][2] = "2"
    of(pair, "refuted")["proof"]["at"]["x"] = "3"


@lie(INCORRECT, "expected <= between them")
def a_witness_on_the_boundary(pair: Pair) -> None:
    row(pair, "refuted")["claim"] = ["<", "x", "2"]


@lie(INCORRECT, "found a witness, but no variable")
def a_witness_without_variables(pair: Pair) -> None:
    of(pair, "cosine")["proof"] = witness({}, [], INTERVAL)


NAMES = {
    "a-variable": "x", "a-constant": "m", "a-parameter": "q", "a-context": "state",
    "a-given": "x-pos", "a-row": "root", "a-shared-term": "half", "the-goal": "goal",
    "a-constant-of-a-context": "d",
}  # fmt: skip
TAKERS: dict[str, Callable[[Pair, str], object]] = {
    "lemma": lambda pair, name: pair.lemma(name, "0 <= 1", INTERVAL),
    "definition": lambda pair, name: pair.define(name, "1"),
    "term-of-the-certificate": lambda pair, name: pair.terms.update({name: "1"}),
    "constant": lambda pair, name: pair.constant(name, "1"),
    "parameter": lambda pair, name: pair.statement["parameters"].update(
        {name: "1", f"{name}_": "1"}
    ),
    "context": lambda pair, name: pair.context(name, {}, {}),
    "variable": lambda pair, name: pair.context("new", {name: "1"}, {}),
    "given": lambda pair, name: pair.context("new", {}, {name: "0 <= 1"}),
    "row": lambda pair, name: pair.row(name, "0 <= 1", INTERVAL),
}
for owner, taken in NAMES.items():
    for taker, take in TAKERS.items():
        if (owner, taker) == ("a-parameter", "parameter"):
            continue  # an object has each key once

        def taken_files(take: Callable[[Pair, str], object] = take, name: str = taken) -> Files:
            pair = honest()
            take(pair, name)
            return pair.files()

        register(f"a-{taker}-with-the-name-of-{owner}", MALFORMED, "", taken_files)


# --- enclosures -----------------------------------------------------------------------------------


def enclosing(kind: str, name: str, *ends: str, bits: int = 64) -> Callable[[], Files]:
    def files() -> Files:
        pair = honest()
        shape = {"ends": [*ends]} if kind == "constants" else {"lhs": [*ends], "rhs": ["-9", "9"]}
        pair.enclosures[kind][name] = {"bits": bits, **shape}
        return pair.files()

    return files


ENDS: dict[str, tuple[int, tuple[str, str]]] = {
    "that-overlaps-from-below": (INCORRECT, ("0", "0.4142135623")),
    "that-overlaps-from-above": (INCORRECT, ("0.4142135624", "1")),
    "that-is-below": (INCORRECT, ("0", "0.1")),
    "that-is-above": (INCORRECT, ("1", "2")),
    "that-is-a-point-beside": (INCORRECT, ("0.4142135623", "0.4142135623")),
    "that-misses-the-last-digit": (INCORRECT, ("0.41421356237309504880168872", "1")),
    "that-is-narrower-than-the-precision": (
        INCORRECT,
        ("0.414213562373095048801688724209698078", "0.414213562373095048801688724209698079"),
    ),
    "whose-ends-are-in-no-order": (MALFORMED, ("1", "0")),
    "whose-end-is-nan": (MALFORMED, ("NaN", "1")),
    "whose-end-is-infinite": (MALFORMED, ("0", "inf")),
    "whose-end-is-a-fraction": (MALFORMED, ("0", "1/1")),
    "whose-end-has-a-plus": (MALFORMED, ("0", "+1")),
    "whose-end-has-six-digits-in-its-exponent": (MALFORMED, ("0", "1e100000")),
    "whose-end-has-a-large-e": (MALFORMED, ("0", "1E1")),
    "whose-end-has-a-space": (MALFORMED, ("0", "1 ")),
    "whose-end-has-a-new-line": (MALFORMED, ("0", "1\n")),
    "whose-end-has-arabic-digits": (MALFORMED, ("0", "\u0661")),
    "whose-end-begins-with-a-point": (MALFORMED, ("0", ".5")),
}
for ends_name, (ends_code, ends) in ENDS.items():
    register(f"a-constant-{ends_name}", ends_code, "", enclosing("constants", "m", *ends))
    register(f"a-side-{ends_name}", ends_code, "", enclosing("rows", "m-less", *ends))
register("an-enclosure-of-a-name-that-is-none", MALFORMED, "unknown names: ['nobody']",
         enclosing("constants", "nobody", "0", "1"))  # fmt: skip
register("an-enclosure-of-a-row-with-variables", MALFORMED, "unknown names: ['root']",
         enclosing("rows", "root", "0", "1"))  # fmt: skip
register("an-enclosure-of-an-undecided-row", MALFORMED, "unknown names: ['open-question']",
         enclosing("rows", "open-question", "0", "1"))  # fmt: skip
register("an-enclosure-of-a-constant-of-a-context", MALFORMED, "unknown names: ['d']",
         enclosing("constants", "d", "0", "1"))  # fmt: skip


# --- bytes ----------------------------------------------------------------------------------------

Bytes = Callable[[bytes, bytes], Files]


def resigned(first: bytes, second: bytes) -> Files:
    """With the digest of what the statement has become."""
    certificate = json.loads(second)
    certificate["statement_sha256"] = sha256(first).hexdigest()
    return first, pack(certificate)


RAW: dict[str, tuple[str, Bytes]] = {
    "a-statement-changed-after-the-proof": ("statement_sha256: found", lambda a, b: (a + b" ", b)),
    "a-digest-of-zeros": (
        "statement_sha256: found",
        lambda a, b: (a, b.replace(sha256(a).hexdigest().encode(), b"0" * 64)),
    ),
    "a-digest-in-capitals": (
        "expected a digest",
        lambda a, b: (a, b.replace(sha256(a).hexdigest().encode(), b"A" * 64)),
    ),
    "a-key-twice": (
        "found a key twice",
        lambda a, b: resigned(a.replace(b'"cites": []', b'"cites": [], "cites": []'), b),
    ),
    "a-key-twice-in-a-proof": (
        "found a key twice", lambda a, b: (a, b.replace(b'"bits": 64', b'"bits": 64, "bits": 64')),
    ),
    "an-empty-statement": ("statement: ", lambda a, b: resigned(b"", b)),
    "an-empty-certificate": ("certificate: ", lambda a, b: (a, b"")),
    "a-statement-of-half-its-bytes": ("statement: ", lambda a, b: resigned(a[: len(a) // 2], b)),
    "a-certificate-of-half-its-bytes": ("certificate: ", lambda a, b: (a, b[: len(b) // 2])),
    "a-certificate-for-a-statement": ("statement: found", lambda a, b: resigned(b, b)),
    "a-statement-for-a-certificate": ("certificate: found", lambda a, b: (a, a)),
    "a-second-document": ("Extra data", lambda a, b: resigned(a + b"{}", b)),
    "a-byte-order-mark": ("BOM", lambda a, b: resigned(b"\xef\xbb\xbf" + a, b)),
    "utf-16": ("statement: ", lambda a, b: resigned(a.decode().encode("utf-16"), b)),
    "latin-1": ("statement: ", lambda a, b: resigned(a.replace(b"title", b"titl\xe9"), b)),
    "a-number-for-a-text": ("", lambda a, b: resigned(a.replace(b'"1/2"', b"0.5"), b)),
    "not-a-number": ("found NaN", lambda a, b: resigned(a.replace(b'"1/2"', b"NaN"), b)),
    "infinity": ("found -Infinity", lambda a, b: resigned(a.replace(b'"1/2"', b"-Infinity"), b)),
    "bits-as-a-float": ("found 64.0", lambda a, b: (a, b.replace(b'"bits": 64', b'"bits": 64.0'))),
    "bits-with-an-exponent": ("found 64e0", lambda a, b: (a, b.replace(b": 64", b": 64e0"))),
    "bits-of-ten-digits": ("found 1234567890",
                           lambda a, b: (a, b.replace(b": 64", b": 1234567890"))),
    "too-many-bits": ("found 99999999, expected 2 to 65536",
                      lambda a, b: (a, b.replace(b": 64", b": 99999999"))),
    "format-1": ("expected verify-statement/2",
                 lambda a, b: resigned(a.replace(b"ment/2", b"ment/1"), b)),
    "format-3": ("expected verify-certificate/2",
                 lambda a, b: (a, b.replace(b"cate/2", b"cate/3"))),
    "a-comment": ("statement: ", lambda a, b: resigned(a + b"// true", b)),
    "single-quotes": ("statement: ", lambda a, b: resigned(a.replace(b'"', b"'"), b)),
    "a-null-byte": ("statement: ", lambda a, b: resigned(a + b"\0", b)),
    "too-many-bytes": ("found more than 4194304 bytes",
                       lambda a, b: resigned(a + b" " * (1 << 22), b)),
    "an-unknown-key": ("too many or too few keys: ['extra']",
                       lambda a, b: resigned(a.replace(b'"cites"', b'"extra": 0, "cites"'), b)),
    "a-term-101-brackets-deep": (
        "nested brackets",
        lambda a, b: resigned(a.replace(b'"1/2"', b'["neg", ' * 101 + b'"1"' + b"]" * 101), b),
    ),
}  # fmt: skip
for raw_name, (raw_word, change_bytes) in RAW.items():

    def raw_files(change: Bytes = change_bytes) -> Files:
        return change(*honest().files())

    register(raw_name, MALFORMED, raw_word, raw_files)
