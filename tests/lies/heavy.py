"""Files that ask for much: each must be answered within bounds of time and memory."""

from __future__ import annotations

from collections.abc import Callable
from hashlib import sha256
from typing import Any

from tests.check.support import (
    DEFINE,
    INTERVAL,
    Pair,
    box,
    cases,
    cuts,
    entry,
    instance,
    interval,
    pack,
    total,
)  # fmt: skip

Files = dict[str, bytes]
LIMIT = 1 << 22
HEAVY: dict[str, Callable[[], Files]] = {}
BIG = "7" * 4300
MERSENNE = (1 << 61) - 1  # hashes of whole numbers are remainders by it


def heavy(make: Callable[[], Pair | Files]) -> Callable[[], Pair | Files]:
    """Register files under the name of the function that makes them."""

    def files() -> Files:
        made = make()
        found = folder(made) if isinstance(made, Pair) else made
        assert max(map(len, found.values())) <= LIMIT
        return found

    HEAVY[make.__name__.replace("_", "-")] = files
    return make


def folder(pair: Pair, *cited: Pair) -> Files:
    """The files of a folder, with cited statements and their certificates."""
    first, second = pair.files()
    found = {"statement.json": first, "certificate.json": second}
    for i, other in enumerate(cited):
        found[f"cited/{i}.json"], found[f"cited/{i}.certificate.json"] = other.files()
    return found


def texts(first: bytes, second: bytes) -> Files:
    """The files of a folder with these two."""
    return {"statement.json": first, "certificate.json": second}


def true(pair: Pair) -> Pair:
    """The statement with a row that is true."""
    return pair.row("row", "0 <= 1", INTERVAL)


def filled(pair: Pair, make: Callable[[int], dict[str, Any]], limit: int = LIMIT - 4000) -> Pair:
    """As many steps as the file holds."""
    room, i = limit - len(pack(pair.certificate())), 0
    while room > 0:
        step = make(i)
        room -= len(pack(step)) + 2
        if room > 0:
            pair.steps.append(step)
        i += 1
    return pair


def lemma(i: int, claim: Any, proof: Any, context: str | None = None) -> dict[str, Any]:
    return {"lemma": f"l{i}", "context": context, "claim": claim, "proof": proof}


def with_addend(addend: Any) -> Pair:
    """A row about a variable by a sum with an addend."""
    pair = Pair().context("c", {"x": "1", "y": "1"}, {"pos": "0 < x", "y-pos": "0 < y"})
    return pair.row("row", ["<=", "0", "x"], total("goal", addend), "c")


def tower(base: Any, exponents: list[str]) -> Any:
    for exponent in exponents:
        base = ["pow", base, exponent]
    return base


def polynomial(n: int, name: str = "x") -> Any:
    """1 + x + x^2 + ..., in few bytes, with n bits of degree."""
    result: Any = ["add", "1", name]
    for i in range(1, n):
        power = tower(name, ["2"] * i)
        result = ["mul", result, ["add", "1", power]]
    return result


# --- numbers --------------------------------------------------------------------------------------


@heavy
def powers_of_sevenths_nested() -> Pair:
    return with_addend(["square", tower(["add", "x", "1/7"], ["999", "999", "999"])])


@heavy
def powers_of_sevenths_in_products() -> Pair:
    return with_addend(["mul", ["square", tower("1/7", ["999"] * 9)], "pos"])


@heavy
def powers_of_sevenths_in_enclosures() -> Pair:
    return Pair().row("row", ["<=", "0", tower("1/7", ["999"] * 60)], interval(bits=65536))


@heavy
def a_tower_of_powers_of_two() -> Pair:
    return Pair().row("row", ["<=", "0", tower("2", ["2"] * 90)], INTERVAL)


@heavy
def a_tower_of_large_odd_powers_at_full_precision() -> Pair:
    value = tower(f"-{BIG}/{BIG[:-1]}1", ["3"] * 80)
    return Pair().row("row", ["<=", value, "0"], interval(bits=65536))


@heavy
def pi_at_full_precision_in_each_row() -> Pair:
    claim = ["<", ["cos", "1"], "1"]
    return filled(true(Pair()), lambda i: lemma(i, claim, interval(bits=65536 - i % 60000)))


@heavy
def cosines_at_full_precision() -> Pair:
    return filled(
        true(Pair()),
        lambda i: lemma(i, ["<", ["cos_pi", f"{i}/7"], "2"], interval(bits=16384)),
    )


@heavy
def cosines_at_a_thousand_bits() -> Pair:
    return filled(
        true(Pair()), lambda i: lemma(i, ["<", ["cos", f"{i}/7"], "2"], interval(bits=1000))
    )


@heavy
def cosines_of_long_numbers_at_few_bits() -> Pair:
    long = {f"t{i}": f"{BIG[:-4]}{i:04}/{BIG[:-1]}1" for i in range(100)}
    pair = true(Pair())
    pair.terms = long
    return filled(
        pair,
        lambda i: lemma(
            i, ["<", ["cos_pi", ["add", f"t{i % 100}", str(i)]], "2"], interval(bits=2)
        ),
    )


@heavy
def roots_at_full_precision() -> Pair:
    return filled(
        true(Pair()), lambda i: lemma(i, ["<", "0", ["sqrt", f"{i + 2}"]], interval(bits=65536))
    )


@heavy
def products_of_long_numbers_with_short_results() -> Pair:
    """Differences of sums that nearly cancel, at full precision."""
    pair = true(Pair())
    for i in range(8):
        pair.define(f"a{i}", tower(["add", f"{BIG}/{BIG[:-1]}1", f"1/{i + 1}"], ["4"]))
    return filled(
        pair,
        lambda i: lemma(
            i, ["<", ["sub", f"a{i % 8}", ["add", f"a{i // 8 % 8}", f"{i}"]], "99999"],
            interval(bits=65536),
        ),
    )  # fmt: skip


@heavy
def quotients_of_the_same_long_numbers() -> Pair:
    pair = true(Pair())
    pair.terms = {f"b{i}": ["pow", f"{BIG}/{BIG[:-2]}{i}", "4"] for i in range(10, 99)}
    pairs = [(i, j) for i in range(10, 99) for j in range(10, 99)]
    return filled(
        pair,
        lambda k: lemma(
            k, ["<", ["div", f"b{pairs[k % 7000][0]}", f"b{pairs[k % 7000][1]}"], "3"],
            interval(bits=65536),
        ),
    )  # fmt: skip


@heavy
def signed_products_of_intervals() -> Pair:
    pair = Pair().context("c", {"x": "0"}, {"low": "-1 <= x", "high": "x <= 1"})
    pair.terms = {"t0": ["mul", "x", "x"]}
    for i in range(60):
        pair.terms[f"t{i + 1}"] = ["mul", f"t{i}", ["sub", "x", f"1/{i + 2}"]]
    proof = interval(("x", "low", "high"))
    return filled(true(pair), lambda i: lemma(i, ["<", "t60", f"{i + 9}"], proof, "c"))


@heavy
def enclosures_with_exponents_of_99999() -> Pair:
    pair = Pair()
    for i in range(4000):
        pair.constant(f"c{i}", "1")
        pair.enclosures["constants"][f"c{i}"] = {
            "bits": 64,
            "ends": [f"-{i}e99999", f"{i + 1}e99999"],
        }
    return true(pair)


@heavy
def enclosures_with_exponents_of_minus_99999() -> Pair:
    pair = Pair()
    for i in range(4000):
        pair.constant(f"c{i}", "1")
        ends = [f"-{i}.{i}e-99999", f"{i + 1}.{i}e99999"]
        pair.enclosures["constants"][f"c{i}"] = {"bits": 64, "ends": ends}
    return true(pair)


@heavy
def refusals_that_print_long_numbers() -> Pair:
    pair = true(Pair())
    pair.define("a", tower("2", ["999", "500"]), INTERVAL)
    return filled(pair, lambda i: lemma(i, ["<", "a", "a"], INTERVAL))


@heavy
def refusals_that_print_long_fractions() -> Pair:
    pair = true(Pair())
    pair.define("a", tower(f"{BIG}/{BIG[:-1]}1", ["4"]), interval(bits=65536))
    return filled(pair, lambda i: lemma(i, ["<", "a", "a"], interval(bits=65536)))


@heavy
def numbers_with_the_same_hash() -> Pair:
    pair = Pair()
    numbers = [str(i * MERSENNE + 1) for i in range(130_000)]
    pair.row("row", "0 <= 1", cuts("1", ["0"], None, None))
    pair.steps[-1]["proof"]["term"] = ["max", *numbers]
    return pair


@heavy
def sums_of_fractions_with_other_denominators() -> Pair:
    """A coefficient to which many products with long denominators are added."""
    base = 10**300
    low: Any = "0"
    high: Any = "0"
    terms: dict[str, Any] = {}
    for i in range(180):
        low = ["add", low, ["mul", f"1/{base + 2 * i + 1}", ["pow", "x", str(i + 1)]]]
        high = ["add", high, ["mul", f"1/{base + 2 * i + 2}", ["pow", "x", str(181 - i)]]]
        if i % 30 == 29:  # a file does not nest more than 100 brackets
            terms[f"low{i}"], terms[f"high{i}"] = low, high
            low, high = f"low{i}", f"high{i}"
    pair = with_addend(["square", ["mul", low, high]])
    pair.terms = terms
    return pair


# --- polynomials ----------------------------------------------------------------------------------


@heavy
def a_product_of_long_polynomials() -> Pair:
    return with_addend(["square", ["mul", polynomial(9), polynomial(9, "y")]])


@heavy
def a_power_of_a_sum() -> Pair:
    return with_addend(["pow", ["add", "pos", "y-pos", "1"], "999"])


@heavy
def powers_of_nothing() -> Pair:
    zero = ["sub", "x", "x"]
    pair = with_addend(["square", "t29"])
    pair.terms = {f"t{i}": ["add", tower(zero, [str(999 - i)]), f"t{i - 1}"] for i in range(1, 30)}
    pair.terms["t0"] = zero
    proof = total("goal", ["square", "t29"])
    return filled(pair, lambda i: lemma(i, ["<=", "x", "x"], proof, "c"))


@heavy
def powers_of_one() -> Pair:
    pair = with_addend(["square", "t59"])
    pair.terms = {f"t{i}": ["mul", ["pow", "1", str(999 - i)], f"t{i - 1}"] for i in range(1, 60)}
    pair.terms["t0"] = "1"
    proof = total("goal", ["square", "t59"])
    return filled(pair, lambda i: lemma(i, ["<=", "x", "x"], proof, "c"))


@heavy
def a_long_sum_with_short_addends() -> Pair:
    """Each addition of one monomial to ten thousand copies these."""
    long = ["square", polynomial(12)]
    return with_addend(["add", long, *[["mul", "pos", str(i)] for i in range(150_000)]])


@heavy
def long_sums_in_each_proof() -> Pair:
    pair = with_addend(["square", "t"])
    pair.terms = {"t": polynomial(10)}
    proof = total("goal", *[["square", "t"]] * 3)
    return filled(pair, lambda i: lemma(i, ["<=", "x", "x"], proof, "c"))


@heavy
def long_equal_denominators() -> Pair:
    pair = Pair().context("c", {"x": "1"}, {"pos": "0 < x"})
    pair.terms = {"d": polynomial(11)}
    pair.lemma("d-pos", "0 < d", interval(("x", "pos", "pos")), "c")
    pair.statement["contexts"][0]["givens"].append(
        {"name": "given", "claim": ["<", "0", "d"], "kind": "plain", "assumption": None}
    )
    pair.statement["terms"], pair.terms = pair.terms, {}
    pair.steps[0]["givens"].append(INTERVAL)
    pair.steps.pop()
    pair.terms = {f"q{i}": ["div", str(i), "d"] for i in range(100)}
    sums = [["add", f"q{i}", f"q{j}"] for i in range(100) for j in range(100)]
    pair.row("row", ["<=", "0", "x"], total("goal", *[["square", item] for item in sums]), "c")
    return pair


@heavy
def monomials_with_the_same_hash() -> Pair:
    """Exponents that are multiples of 2^61 - 1, built by squaring."""
    pair = with_addend(["square", "s399"])
    square: Any = "x"
    terms: dict[str, Any] = {"p0": square}
    for i in range(61):
        terms[f"p{i + 1}"] = ["pow", f"p{i}", "2"]
    terms["m0"] = "p0"
    for i in range(60):
        terms[f"m{i + 1}"] = ["mul", f"m{i}", f"p{i + 1}"]
    terms |= {"y0": "m60", "s0": "m60"}
    for i in range(100):
        terms[f"y{i + 1}"] = ["mul", f"y{i}", "m60"]
        terms[f"s{i + 1}"] = ["add", f"s{i}", f"y{i + 1}"]
    for i in range(100, 399):
        terms[f"s{i + 1}"] = ["mul", f"s{i % 100}", f"s{(i + 1) % 100}"]
    pair.terms = terms
    return pair


@heavy
def boxes_with_hundreds_of_variables() -> Pair:
    names = [f"v{i}" for i in range(400)]
    givens = {f"g{i}": f"0 < v{i}" for i in range(400)}
    pair = Pair().context("c", dict.fromkeys(names, "1"), givens)
    addend = ["mul", *[["add", f"g{i}", f"g{i + 1}"] for i in range(0, 398, 2)]]
    return pair.row("row", "0 <= v1", total("goal", addend), "c")


@heavy
def long_monomials() -> Pair:
    names = [f"v{i}" for i in range(400)]
    givens = {f"g{i}": f"0 < v{i}" for i in range(400)}
    pair = Pair().context("c", dict.fromkeys(names, "1"), givens)
    product = ["mul", *givens]
    addend = ["mul", product, ["pow", ["add", *givens], "3"]]
    return pair.row("row", "0 <= v1", total("goal", addend), "c")


@heavy
def roots_in_roots() -> Pair:
    pair = Pair().context("c", {"x": "1"}, {"pos": "0 < x"})
    root: Any = "x"
    for i in range(30):
        pair.lemma(
            f"p{i}",
            ["<", "0", ["add", root, "1"]],
            total("goal", "1", ["root", root] if i else "pos"),
            "c",
        )
        root = ["sqrt", ["add", root, "1"]]
    return pair.row(
        "row", "0 <= x", total("goal", ["pow", ["add", ["root", root], ["root", root]], "64"]), "c"
    )


@heavy
def many_roots_reduced() -> Pair:
    roots = [["sqrt", str(i)] for i in range(2, 14)]
    product: Any = "1"
    for root in roots:
        product = ["mul", product, ["add", "x", root]]
    return with_addend(["square", product])


# --- many of a kind -------------------------------------------------------------------------------


@heavy
def a_list_of_zeros() -> Files:
    first, _ = true(Pair()).files()
    return texts(first, b'{"steps":[' + b"0," * (LIMIT // 2 - 20) + b"0]}")


@heavy
def a_list_of_zeros_among_the_steps() -> Files:
    pair = true(Pair())
    pair.steps = [[0] * 1_300_000]
    return folder(pair)


@heavy
def empty_lists() -> Files:
    return texts(b"[" + b"[]," * (LIMIT // 3 - 9) + b"[]]", b"{}")


@heavy
def empty_objects() -> Files:
    return texts(b"[" + b"{}," * (LIMIT // 3 - 9) + b"{}]", b"{}")


@heavy
def small_objects() -> Files:
    return texts(b"[" + b'{"":{}},' * (LIMIT // 8 - 9) + b"{}]", b"{}")


@heavy
def brackets_that_do_not_close() -> Files:
    return texts(b"[" * LIMIT, b"{}")


@heavy
def brackets_a_hundred_deep() -> Files:
    part = b"[" * 99 + b"]" * 99
    return texts(b"[" + b",".join([part] * 20_000) + b"]", b"{}")


@heavy
def one_long_text() -> Files:
    return texts(b'"' + b"\\u00e9" * (LIMIT // 6 - 9) + b'"', b"{}")


@heavy
def a_long_label() -> Pair:
    pair = true(Pair())
    pair.statement["obligations"][0]["label"] = "\N{GREEK SMALL LETTER ALPHA}" * 600_000
    return pair


@heavy
def many_keys() -> Pair:
    pair = true(Pair())
    pair.statement["parameters"] = {f"k{i}": "1" for i in range(40_000)}
    return pair


@heavy
def many_terms() -> Pair:
    pair = true(Pair())
    pair.terms = {f"t{i}": ["add", f"t{i - 1}" if i % 150 else "1", "1"] for i in range(100_000)}
    pair.lemma("last", "0 <= 1", total("goal", "1", ["square", "t140"]))
    return pair


@heavy
def terms_in_the_wrong_order() -> Pair:
    pair = true(Pair())
    pair.terms = {f"t{i}": ["add", f"t{i + 1}", "1"] for i in range(100_000)} | {"t100000": "1"}
    pair.lemma("last", "0 <= 1", total("goal", "1", ["square", "t0"]))
    return pair


@heavy
def many_constants_each_of_two_names() -> Pair:
    pair = Pair()
    for i in range(36_000):
        pair.constant(f"c{i}", ["add", f"c{i - 1}", f"c{i - 2}"] if i > 1 else "1")
    return true(pair)


@heavy
def names_of_a_deep_context_in_a_long_minimum() -> Pair:
    pair = Pair()
    parent = None
    for i in range(99):
        pair.context(f"c{i}", {f"v{i}": "1"}, {}, [], parent)
        parent = f"c{i}"
    pair.lemma(
        "l", "0 <= 1", cuts(["max", *["v98", "v0"] * 200_000], ["0"], INTERVAL, INTERVAL), parent
    )
    return true(pair)


@heavy
def facts_in_a_deep_context() -> Pair:
    pair = Pair()
    parent = None
    for i in range(99):
        pair.context(f"c{i}", {f"v{i}": "1"}, {f"g{i}": f"0 < v{i}"}, None, parent)
        parent = f"c{i}"
    root = ["div", "v0", "v0"]
    return filled(true(pair), lambda i: lemma(i, ["<=", root, root], total("goal", "g0"), "c98"))


@heavy
def contexts_in_a_chain_that_is_too_long() -> Pair:
    pair = Pair()
    parent = None
    for i in range(5000):
        pair.context(f"c{i}", {}, {}, [], parent)
        parent = f"c{i}"
    return true(pair)


@heavy
def many_contexts() -> Pair:
    pair = Pair()
    for i in range(10_000):
        pair.context(f"c{i}", {f"v{i}": "1"}, {f"g{i}": ["<", "0", f"v{i}"]})
    return true(pair)


@heavy
def branches_for_each_of_many_entries() -> Pair:
    entries = [str(i) for i in range(60_000)]
    pair = Pair()
    proof = cases(["max", *entries], *[INTERVAL] * 60_000)
    return pair.row("row", "0 <= 1", proof)


@heavy
def hypotheses_of_many_entries_looked_through() -> Pair:
    entries = ["x", *[str(i) for i in range(2, 2_000)]]
    inner = total("goal", *[["square", ["div", str(i), "x"]] for i in range(2_000)])
    pair = Pair().context("c", {"x": "1"}, {"low": "1 <= x"})
    branches = [inner, *[INTERVAL] * 1_998]
    return pair.row("row", "0 <= x", cases(["max", *entries], *branches), "c")


@heavy
def cuts_in_cuts() -> Pair:
    proof: Any = INTERVAL
    for _ in range(14):
        proof = cuts("1", ["0"], proof, proof)
    return Pair().row("row", "0 <= 1", proof)


@heavy
def very_many_cuts() -> Pair:
    at = [str(i) for i in range(60_000)]
    return Pair().row("row", "0 <= 1", cuts("1", at, *[INTERVAL] * 60_001))


@heavy
def many_proofs_over_a_long_minimum() -> Pair:
    pair = true(Pair())
    pair.terms = {"m": ["min", *[str(i) for i in range(100_000)]]}
    return filled(pair, lambda i: lemma(i, ["<=", "m", "5"], entry("lhs")))


@heavy
def instances_with_a_long_minimum() -> Pair:
    pair = Pair().context("c", {"x": "1"}, {}, [])
    pair.terms = {"m": ["min", "x", *[str(i) for i in range(100_000)]]}
    pair.lemma("fact", ["<=", "m", "5"], entry("lhs"), "c")
    claim = ["<=", "1", "5"]
    return filled(true(pair), lambda i: lemma(i, claim, instance("fact", {"x": str(i)})))


@heavy
def instances_with_many_givens() -> Pair:
    givens = {f"g{i}": ["<=", "0", "x"] for i in range(12_000)}
    pair = Pair().context("c", {"x": "1"}, givens)
    pair.lemma("fact", "0 <= x", total("goal", "g0"), "c").lemma("one", "0 <= 1", INTERVAL)
    proof = instance("fact", {"x": "1"}, *["one"] * 12_000)
    return filled(true(pair), lambda i: lemma(i, ["<=", "0", "1"], proof))


@heavy
def instances_that_make_new_terms() -> Pair:
    pair = Pair().context("c", {"x": "1"}, {}, [])
    pair.terms = {"t0": ["add", "x", "1"]}
    for i in range(150):
        pair.terms[f"t{i + 1}"] = ["add", ["cos", f"t{i}"] if i % 3 else f"t{i}", "1"]
    pair.lemma("fact", ["=", "t150", "t150"], total(), "c")
    pair.terms |= {"small": "1"}
    return filled(
        true(pair), lambda i: lemma(i, ["=", "1", "1"], instance("fact", {"x": f"{i}/7"}))
    )


@heavy
def bounds_for_each_proof() -> Pair:
    pair = Pair().context("c", {"x": "1"}, {"low": "0 <= x", "high": "x <= 2"})
    pair.terms = {"t0": ["mul", "x", "x"]}
    for i in range(90):
        pair.terms[f"t{i + 1}"] = ["sub", ["mul", f"t{i}", "1/3"], "x"]
    proof = interval(("x", "low", "high"))
    return filled(true(pair), lambda i: lemma(i, ["<=", "t90", f"{i + 9}"], proof, "c"))


@heavy
def equations_that_replace_in_a_chain() -> Pair:
    pair = Pair().constant("c0", "1")
    for i in range(390):
        pair.constant(f"c{i + 1}", f"c{i}")
    proof = total("goal", "1", using=[f"c{i}" for i in range(391)])
    return pair.row("row", "0 <= c390", proof)


@heavy
def equations_that_replace_in_each_proof() -> Pair:
    pair = Pair().constant("c0", "1")
    for i in range(300):
        pair.constant(f"c{i + 1}", ["add", f"c{i}", f"c{i}"])
    proof = total("goal", using=[f"c{i}" for i in range(120)])
    return filled(true(pair), lambda i: lemma(i, ["<=", "c100", "c100"], proof))


# --- exp, log, sin, atan and roots ---------------------------------------------------------------


def enclosures(make: Callable[[int], Any], bits: int) -> Pair:
    """As many rows as there is room for, each of another number; all but the first are false."""
    proof = interval(bits=bits)
    return filled(true(Pair()), lambda i: lemma(i, ["<", make(i), "-9"], proof))


@heavy
def exponentials_at_full_precision() -> Pair:
    return enclosures(lambda i: ["exp", f"{i}/7"], 65536)


@heavy
def logarithms_at_full_precision() -> Pair:
    return enclosures(lambda i: ["log", f"{i + 2}/7"], 65536)


@heavy
def inverse_tangents_at_full_precision() -> Pair:
    return enclosures(lambda i: ["atan", f"{i}/7"], 65536)


@heavy
def sines_at_a_thousand_bits() -> Pair:
    return enclosures(lambda i: ["sin", f"{i}/7"], 1000)


@heavy
def logarithms_at_few_bits() -> Pair:
    return enclosures(lambda i: ["log", f"{i + 2}/7"], 2)


@heavy
def exponentials_of_towers() -> Pair:
    return enclosures(lambda i: ["exp", tower("10", ["9"] * (i % 40))], 64)


@heavy
def exponentials_of_negative_towers() -> Pair:
    return enclosures(lambda i: ["exp", ["neg", tower("10", ["9"] * (i % 40))]], 64)


@heavy
def exponentials_of_exponentials() -> Pair:
    pair = true(Pair())
    pair.terms = {"t0": ["exp", "1/3"]} | {f"t{i + 1}": ["exp", f"t{i}"] for i in range(400)}
    return filled(pair, lambda i: lemma(i, ["<", f"t{i % 400}", "-9"], interval(bits=64 + i)))


@heavy
def sines_of_towers() -> Pair:
    return enclosures(lambda i: ["sin", tower("10", ["9"] * (i % 40))], 64)


@heavy
def logarithms_of_towers() -> Pair:
    return enclosures(lambda i: ["log", tower(f"{i + 3}/{i + 2}", ["99"] * (i % 40))], 64)


@heavy
def inverse_tangents_of_long_numbers() -> Pair:
    return enclosures(lambda i: ["atan", f"{BIG[:-4]}{i % 10000:04}/{BIG[:-1]}1"], 64)


@heavy
def roots_of_high_degree_at_full_precision() -> Pair:
    return enclosures(lambda i: ["root", f"{i}/7", "99"], 65536)


@heavy
def roots_of_towers() -> Pair:
    return enclosures(lambda i: ["root", tower(f"{i + 3}/{i + 2}", ["99"] * (i % 9)), "97"], 64)


def slopes(pair: Pair, last: str, slope: Any = "1") -> Pair:
    """A proof by the sign of the derivative for each bound of a term; no derivative is right."""

    def step(i: int) -> dict[str, Any]:
        fields = {"variable": "x", "at": f"{i}/7", "side": "above", "strict": "start"}
        proof = {
            "rule": "derivative", **fields, "term": slope, "start": INTERVAL, "order": "low",
            "sign": INTERVAL, "bounds": [INTERVAL],
        }  # fmt: skip
        return lemma(i, ["<=", f"{i}/9", last], proof, "c")

    return filled(true(pair), step)


@heavy
def derivatives_of_a_chain_of_exponentials() -> Pair:
    pair = Pair().context("c", {"x": "1"}, {"low": "0 <= x"})
    pair.terms = {"t0": ["exp", "x"]} | {f"t{i + 1}": ["exp", f"t{i}"] for i in range(190)}
    return slopes(pair, "t190")


@heavy
def derivatives_of_repeated_squares() -> Pair:
    pair = Pair().context("c", {"x": "1"}, {"low": "0 <= x"})
    pair.terms = {"t0": ["add", "x", "1"]} | {
        f"t{i + 1}": ["mul", f"t{i}", f"t{i}"] for i in range(190)
    }
    return slopes(pair, "t190")


@heavy
def derivatives_of_repeated_quotients() -> Pair:
    pair = Pair().context("c", {"x": "1"}, {"low": "0 <= x"})
    pair.terms = {"t0": ["add", "x", "1"]} | {
        f"t{i + 1}": ["div", f"t{i}", ["add", f"t{i}", "1"]] for i in range(190)
    }
    return slopes(pair, "t190")


@heavy
def derivatives_through_many_definitions() -> Pair:
    pair = Pair().context("c", {"x": "1"}, {"low": "0 <= x"})
    for i in range(300):
        pair.define(f"d{i}", ["mul", "x", f"d{i - 1}"] if i else ["mul", "x", "x"], INTERVAL, "c")
    return slopes(pair, "d299")


@heavy
def laws_of_long_products() -> Pair:
    product = ["mul", *["2"] * 2]
    for _ in range(90):
        product = ["mul", product, "2"]
    claim = ["=", ["log", product], ["add", ["log", product], ["log", "2"]]]
    return filled(true(Pair()), lambda i: lemma(i, claim, {"rule": "law"}))


@heavy
def claims_in_between_inside_of_one_another() -> Pair:
    proof: Any = INTERVAL
    for i in range(20):
        proof = {"rule": "have", "claim": ["<", str(i), str(i + 1)], "branches": [INTERVAL, proof]}
    return filled(true(Pair()), lambda i: lemma(i, ["<", f"{i}/7", "-1"], proof))


@heavy
def very_many_small_steps() -> Pair:
    return filled(true(Pair()), lambda i: lemma(i, ["<", "1", "2"], {"rule": "root"}))


@heavy
def very_many_intervals() -> Pair:
    return filled(true(Pair()), lambda i: lemma(i, ["<", f"{i}/7", str(i + 1)], interval(bits=2)))


@heavy
def one_enclosure_for_each_precision() -> Pair:
    pair = true(Pair())
    pair.define("d", ["add", *[["sqrt", "2"]] * 2], INTERVAL)
    pair.terms = {"t0": ["sqrt", "2"]}
    for i in range(150):
        pair.terms[f"t{i + 1}"] = ["sub", ["mul", f"t{i}", "1/3"], "t0"]
    return filled(pair, lambda i: lemma(i, ["<", "t150", f"{9 + i}"], interval(bits=64 + i)))


@heavy
def a_power_for_each_precision() -> Pair:
    return filled(
        true(Pair()),
        lambda i: lemma(i, ["<", ["pow", f"3/{i % 1000 + 7}", "999"], "2"], interval(bits=64 + i)),
    )


@heavy
def an_enclosure_of_one_row_after_the_other() -> Pair:
    pair = Pair()
    for i in range(7_000):
        pair.row(f"r{i}", ["<", ["sqrt", str(i)], str(i + 1)], INTERVAL)
    return pair


@heavy
def cosines_with_long_coefficients() -> Pair:
    """All the coefficients are on their side."""
    pair = true(box(("0", "1")))
    pair.terms["t0"] = "1" + "0" * 4290
    for i in range(1, 97):
        number = f"{'2' * 4290}/{'1' * 4289}{i % 9 + 1}"
        pair.terms[f"t{i}"] = ["add", number, ["mul", ["pow", "x", "2"], f"t{i - 1}"]]
    claim = ["<=", ["cos", "x"], "t96"]
    return filled(pair, lambda i: lemma(i, claim, {"rule": "cosine"}, "box"))


# --- what was once too much ----------------------------------------------------------------------


def long_number(i: int) -> str:
    """A rational that fills the limit of digits."""
    return f"{7**5085 + i}/{3**9005 + i}"


@heavy
def a_minimum_of_long_rationals_in_each_branch() -> Pair:
    """Each branch adds hypotheses about all entries, and clears them anew."""
    pair = true(Pair())
    pair.statement["terms"] = {f"e{i}": long_number(i) for i in range(470)}
    term = ["min", *pair.statement["terms"]]
    branches = [total("goal", "1")] * 470
    return pair.lemma("l", ["<", term, ["add", term, "1"]], cases(term, *branches))


@heavy
def refused_sums_beside_many_names() -> Pair:
    pair = true(Pair())
    for i in range(25_000):
        pair.statement["parameters"][f"p{i}"] = "1"
        pair.step(constant=f"p{i}", proof=DEFINE)
    pair.enclosures["constants"] = {f"p{i}": {"bits": 2, "ends": ["1", "1"]} for i in range(25_000)}
    return filled(pair, lambda i: lemma(i, ["=", "p1", "2"], total()))


@heavy
def refused_sums() -> Pair:
    return filled(true(Pair()), lambda i: lemma(i, ["=", "0", "2"], total()))


@heavy
def rows_that_use_one_of_many_assumptions() -> Pair:
    pair = Pair()
    for i in range(17_000):
        pair.assume(f"a{i}")
    for i in range(7_000):
        pair.row(f"r{i}", ["<", "x", "1"], None, verdict="undecided", role="printed")
    pair.context("c", {"x": "1"}, {}, [])
    for row in pair.statement["obligations"]:
        row |= {"uses": ["a1"], "context": "c"}
    return true(pair)


@heavy
def inductions_over_many_standing_givens() -> Pair:
    """None of the givens has to be shown, but each induction looks through all of them."""
    pair = true(Pair()).assume("a")
    givens = {f"g{i}": (["<", "0", "1"], "standing", "a") for i in range(26_000)}
    pair.context("c", {}, givens, [INTERVAL] * 26_000)
    for i in range(8_000):
        pair.row(f"r{i}", ["always", "c", {}, {}], {"rule": "induction", "start": [], "next": []})
    return pair


@heavy
def entries_of_a_long_minimum() -> Pair:
    """Each looks for its side among all entries, and it is the last one."""
    pair = true(Pair())
    pair.terms = {"m": ["min", *[str(i) for i in range(100_000)]]}
    pair.define("d", "m")
    return filled(pair, lambda i: lemma(i, ["<=", "m", "99999"], entry("lhs")))


@heavy
def sums_of_one_long_monomial() -> Pair:
    """Its hash is worked out again in each table."""
    names = [f"v{i}" for i in range(10_000)]
    pair = true(Pair()).context("c", dict.fromkeys(names, "1"), {}, [])
    level = names
    for depth in range(14):
        pairs = [level[i : i + 2] for i in range(0, len(level), 2)]
        made = {f"t{depth}.{i}": ["mul", *two] for i, two in enumerate(pairs) if len(two) == 2}
        pair.terms |= made
        level = [*made, *(two[0] for two in pairs if len(two) == 1)]
    proof = total("goal", "1")
    return filled(pair, lambda i: lemma(i, ["<", level[0], ["add", level[0], "1"]], proof, "c"))


@heavy
def premises_that_are_names() -> Pair:
    """Thousands of givens, each shown by the same fact, in hundreds of instances."""
    givens = {f"g{i}": ["<=", "0", "x"] for i in range(3_000)}
    pair = Pair().context("c", {"x": "1"}, givens)
    pair.lemma("fact", "0 <= x", total("goal", "g0"), "c").lemma("a", "0 <= 1", INTERVAL)
    proof = instance("fact", {"x": "1"}, *["a"] * 3_000)
    return filled(true(pair), lambda i: lemma(i, ["<=", "0", "1"], proof))


@heavy
def roots_in_a_deep_context() -> Pair:
    """Whether a radicand is known is looked up in a hundred contexts."""
    pair = Pair()
    parent = None
    for i in range(99):
        pair.context(f"c{i}", {f"v{i}": "1"}, {f"g{i}": f"0 < v{i}"}, None, parent)
        parent = f"c{i}"
    claim, proof = ["<", "0", ["sqrt", "v98"]], {"rule": "root"}
    return filled(true(pair), lambda i: lemma(i, claim, proof, "c98"))


@heavy
def names_with_many_colons() -> Pair:
    return true(Pair()).lemma("l", "0 < 1", total("goal", using=["a:" * 2_000_000 + "a"]))


@heavy
def one_small_statement_cited_many_times() -> Files:
    other = true(Pair("T"))
    pair = true(Pair())
    pair.cite("c0", other)
    (item,) = pair.statement["cites"]
    pair.statement["cites"] = [item | {"name": f"c{i}"} for i in range(30_000)]
    return folder(pair, other)


@heavy
def long_statements_cited() -> Files:
    """Seven of them, each with as many variables as it holds."""
    others, pair = [], true(Pair())
    for k in range(7):
        other = true(Pair(f"T{k}"))
        other.context("c", {f"v{i}": "1" for i in range(45_000)}, {}, [])
        others.append(other)
        pair.cite(f"c{k}", other)
    return folder(pair, *others)


def chain(length: int, limit: int = LIMIT) -> Files:
    """Statements of which each cites the next, all of them at hand while the last one is read.

    Empty lists in lists are what takes most memory for its bytes.
    """
    found, pair = {}, true(Pair("T"))
    for k in range(length):
        empty = (limit - len(pair.files()[0]) - 100) // 5
        first = pair.files()[0].replace(
            b'"terms": {', b'"terms": {"t": [' + b"[[]]," * empty + b"[]]"
        )
        found[f"cited/{k}.json"] = first
        pair = true(Pair(f"T{k}"))
        item = {"name": "c", "theorem": f"T{k - 1}" if k else "T"}
        pair.statement["cites"] = [item | {"statement_sha256": sha256(first).hexdigest()}]
    return found | folder(pair)


@heavy
def a_chain_of_long_statements_cited() -> Files:
    return chain(7)


@heavy
def cited_certificates_that_are_much_work_each() -> Files:
    others, pair = [], true(Pair())
    for k in range(7):
        other = true(Pair(f"T{k}"))
        filled(other, lambda i: lemma(i, ["<", f"{i}/7", str(i + 1)], interval(bits=2)))
        others.append(other)
        pair.cite(f"c{k}", other)
    return folder(pair, *others)


@heavy
def cited_certificates_that_are_too_much_work() -> Files:
    others, pair = [], true(Pair())
    for k in range(20):
        other = Pair(f"T{k}").row("row", "0 <= 1", INTERVAL)
        other.lemma("l", ["<", ["cos", "1"], "2"], interval(bits=60_000 + k))
        for i in range(40):
            other.lemma(f"l{i}", ["<", ["cos", f"{i}"], "2"], interval(bits=4_000))
        others.append(other)
        pair.cite(f"c{k}", other)
    return folder(pair, *others)


@heavy
def polynomials_that_are_kept() -> Pair:
    """Each term is cleared once and kept: two hundred negatives of a long sum, and so on."""
    pair = true(Pair()).context("c", {"x": "1", "y": "1"}, {}, [])
    number = str(2**250 + 1)
    pair.terms = {"t": ["pow", ["add", ["mul", number, "x"], "y"], "400"]}
    return filled(
        pair, lambda i: lemma(i, ["<=", ["mul", str(i), "t"], ["mul", str(i), "t"]],
                              total("goal", "1"), "c")
    )  # fmt: skip


@heavy
def tables_that_are_kept() -> Pair:
    pair = true(Pair()).context("c", {"x": "1"}, {}, [])
    pair.terms = {"t0": polynomial(12)}
    for i in range(180):
        pair.terms[f"t{i + 1}"] = ["neg", f"t{i}"]
    return pair.lemma("l", ["=", "t180", "t180"], total(), "c")


@heavy
def enclosures_of_very_many_constants() -> Pair:
    pair = Pair()
    for i in range(25_000):
        pair.statement["parameters"][f"p{i}"] = "1/3"
        pair.step(constant=f"p{i}", proof=DEFINE)
    pair.enclosures["constants"] = {f"p{i}": {"bits": 2, "ends": ["0", "0"]} for i in range(25_000)}
    return true(pair)


@heavy
def derivatives_in_a_context_with_many_givens() -> Pair:
    """Each looks for bounds of its variable among all of them."""
    givens = {f"g{i}": ["<", "0", "1"] for i in range(5_000)} | {"low": ["<=", "0", "x"]}
    pair = true(Pair()).context("c", {"x": "1"}, givens, [INTERVAL] * 5_001)
    proof = {
        "rule": "derivative", "variable": "x", "side": "above", "strict": "start", "at": "0",
        "term": "1", "start": INTERVAL, "order": "low", "sign": INTERVAL, "bounds": [INTERVAL],
    }  # fmt: skip
    return filled(pair, lambda i: lemma(i, ["<=", "0", "x"], proof, "c"), limit=600_000)


@heavy
def a_context_with_many_variables_and_givens() -> Pair:
    """Each given is read at the point, which has a value for each variable."""
    names = [f"v{i}" for i in range(22_000)]
    givens = {f"g{i}": ["<", "0", "1"] for i in range(22_000)}
    return true(Pair()).context("c", dict.fromkeys(names, "1"), givens, [64] * 22_000)


@heavy
def sentences_that_are_told_under_long_names() -> Files:
    """A statement with very many of them is cited by one that is cited, and so on."""
    found, pair = {}, true(Pair("T"))
    empty = {"kind": "", "label": "", "sentence": ""}
    pair.statement["assumptions"] = [{"name": f"a{i}"} | empty for i in range(60_000)]
    for k in range(9):
        first = found[f"cited/{k}.json"] = pair.files()[0]
        item = {"name": "c" * 100, "theorem": pair.statement["theorem"]}
        pair = true(Pair(f"T{k}"))
        pair.statement["cites"] = [item | {"statement_sha256": sha256(first).hexdigest()}]
    return found | folder(pair)
