"""What no other test sees: limits at the limit and one above, and the room that roundings leave."""

from __future__ import annotations

from fractions import Fraction
from itertools import pairwise
from pathlib import Path
from typing import Any

import mpmath
import pytest

from tests.check.support import (
    IDENTITY,
    INTERVAL,
    Pair,
    answer,
    box,
    cuts,
    entry,
    ground,
    in_box,
    interval,
    term,
    total,
    verdict,
)
from verify import check

F = Fraction


# --- limits --------------------------------------------------------------------------------------


def test_work_and_sizes_up_to_the_limits() -> None:
    kernel = check.Kernel()
    kernel.spend(8)
    assert kernel.work == check.MAX_WORK - 2
    kernel.spend(0, check.MAX_WORK // 2 - 1)
    assert kernel.work == 0
    with pytest.raises(check.Malformed, match="more work"):
        kernel.spend(0)
    kernel = check.Kernel()
    kernel.spend(check.MAX_SIZE)
    with pytest.raises(check.Malformed, match=f"a number of {check.MAX_SIZE + 1} bits"):
        kernel.spend(check.MAX_SIZE + 1)


def test_the_size_of_a_number_is_that_of_both_its_parts() -> None:
    assert check.size(F(3, 16)) == 2 + 5
    assert check.size(7) == 3 + 1


@pytest.mark.parametrize("atom", ["x", "7/5"])
def test_terms_up_to_the_limit(atom: str) -> None:
    def claim(levels: int) -> Any:
        inner: Any = atom
        for _ in range(levels - 1):
            inner = ["neg", inner]
        return ["=", inner, inner]

    kernel = check.Kernel()
    kernel.new_name("x", kernel.outermost)
    kernel.read_claim("", claim(check.MAX_HEIGHT), kernel.outermost)
    with pytest.raises(check.Malformed, match="levels"):
        kernel.read_claim("", claim(check.MAX_HEIGHT + 1), kernel.outermost)


def test_contexts_up_to_the_limit() -> None:
    context = check.Kernel().outermost
    for depth in range(1, check.MAX_NESTING + 1):
        context = check.Context(f"c{depth}", context)
        assert context.depth == depth
    with pytest.raises(check.Malformed, match="more than 100 contexts"):
        check.Context("more", context)


def test_files_up_to_the_limit() -> None:
    pair = Pair().row("row", "0 <= 1", INTERVAL)
    first, second = pair.files()
    room = check.MAX_BYTES - len(second)
    assert answer((first, second + b" " * room))[0] == 0
    code, lines = answer((first, second + b" " * (room + 1)))
    assert (code, "bytes" in lines[-1]) == (4, True)


def test_brackets_up_to_the_limit() -> None:
    check.parsed("file", b"[" * 100 + b"]" * 100, check.anything)
    with pytest.raises(check.Malformed, match="nested brackets"):
        check.parsed("file", b"[" * 101 + b"]" * 101, check.anything)


def test_names_up_to_the_limit() -> None:
    kernel = check.Kernel()
    kernel.introduce("a" * check.MAX_NAME)
    with pytest.raises(check.Malformed, match="a name of 1001 characters"):
        kernel.introduce("a" * (check.MAX_NAME + 1))


def test_files_to_be_cited_up_to_the_limit(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    (tmp_path / "a").write_bytes(b"12345")
    (tmp_path / "b").write_bytes(b"678")
    monkeypatch.setattr(check, "MAX_CITED", 8)
    assert check.read_cited(str(tmp_path)) == ([b"12345", b"678"], [])
    monkeypatch.setattr(check, "MAX_CITED", 7)
    with pytest.raises(OSError, match="more than 7 bytes"):
        check.read_cited(str(tmp_path))
    (tmp_path / "a").unlink()
    (tmp_path / "a").mkdir()
    with pytest.raises(OSError, match="which is no file"):
        check.read_cited(str(tmp_path))


def test_files_are_read_just_beyond_the_limit(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    (tmp_path / "a").write_bytes(b"123456")
    monkeypatch.setattr(check, "MAX_BYTES", 4)
    assert check.read_file(str(tmp_path / "a")) == b"12345"


def test_degrees_up_to_the_limit() -> None:
    kernel, most = check.Kernel(), check.MAX_DEGREE
    assert kernel.merged(((1, most - 1),), ((1, 1), (2, most))) == ((1, most), (2, most))
    with pytest.raises(check.Malformed, match="degree"):
        kernel.merged(((1, most),), ((1, 1),))


@pytest.mark.parametrize("bits", [2, check.MAX_BITS])
def test_precisions_up_to_the_limits(bits: int) -> None:
    check.bits(bits)
    assert ground("1/3 <= 1/2", interval(bits=bits)) == "proved"
    for wrong in (bits - 1 if bits == 2 else bits + 1, str(bits), True, float(bits)):
        with pytest.raises(check.Malformed):
            check.bits(wrong)


def chain(length: int) -> tuple[check.Clearing, int]:
    """Names of which each but the last is replaced by the next one, and the first."""
    kernel = check.Kernel()
    names = [kernel.new_name(f"a{i}", kernel.outermost) for i in range(length)]
    clearing = check.Clearing(kernel, check.Place(kernel.outermost), ())
    clearing.replaced = dict(pairwise(names))
    return clearing, names[0]


def test_chains_of_equations_up_to_the_limit() -> None:
    clearing, first = chain(2 * check.MAX_HEIGHT)
    assert clearing.clear(first)[1] == check.ONE
    clearing, first = chain(2 * check.MAX_HEIGHT + 1)
    with pytest.raises(check.Malformed, match="too deep"):
        clearing.clear(first)


def test_what_is_cleared_is_no_longer_on_the_way() -> None:
    """So a term may have more subterms than a chain may have equations."""
    pair = Pair()
    names = [f"k{i}" for i in range(500)]
    for name in names:
        pair.constant(name, "1")
    terms: list[Any] = list(names)
    while len(terms) > 1:
        terms = [["add", *two] if len(two) == 2 else two[0] for two in pairs_of(terms)]
    assert verdict(pair.row("row", ["=", terms[0], terms[0]], IDENTITY)) == "proved"


def pairs_of(items: list[Any]) -> list[list[Any]]:
    return [items[i : i + 2] for i in range(0, len(items), 2)]


def test_large_powers_of_one_take_no_time() -> None:
    assert check.Kernel().power(check.ONE, 10**18) == check.ONE
    root = {"k": ["pow", ["pow", ["sqrt", "1"], "999"], "999"]}
    pair = Pair()
    pair.statement["terms"] = root
    assert verdict(pair.row("row", "k = sqrt(1)", IDENTITY)) == "proved"


def test_numbers_in_messages_up_to_the_limit() -> None:
    assert check.decimal(F(2**check.MAX_SHOWN)).endswith("e1208")
    assert check.decimal(F(2 ** (check.MAX_SHOWN + 1))) == "2^4097"
    assert check.decimal(F(1, 2**check.MAX_SHOWN)).endswith("e-1249")
    assert check.shown("x" * 199) == "x" * 199
    assert check.shown("x" * 200) == "x" * 160 + "... (200 characters)"


def test_entries_are_counted_from_one() -> None:
    shape = check.array(check.tuple_of(check.name, check.name))
    with pytest.raises(check.Malformed, match=r"^list 2 1: found"):
        check.fits("list", shape, [["a", "b"], ["1", "b"]])


# --- roundings at low precision ------------------------------------------------------------------


def enclosing(bits: int) -> check.Enclosing:
    return check.Enclosing(check.Kernel(), bits, None)


@pytest.mark.parametrize("bits", range(2, 9))
def test_ends_are_shortened_just_beyond_the_limit(bits: int) -> None:
    """Those of at most 2 bits stay; others get so many bits that they are nearly as good."""
    scope = enclosing(bits)
    for n in range(-300, 301, 7):
        for d in range(1, 40):
            end = F(n, d)
            found = scope.shorter(end, 1)
            assert scope.shorter(-end, -1) == -found
            size = check.size(end)
            assert found <= end
            assert end - found <= abs(end) / 2 ** (bits - 1)
            assert size > 2 * bits or found == end
            unit = F(2) ** (end.numerator.bit_length() - end.denominator.bit_length() - bits)
            assert size <= 2 * bits or found == end // unit * unit


def exact(value: Any) -> Fraction:
    sign, man, exp, _ = value._mpf_
    return F(-int(man) if sign else int(man)) * F(2) ** int(exp)


@pytest.mark.parametrize("bits", [*range(2, 40), 64, 333])
def test_pi_with_room_for_each_floor(bits: int) -> None:
    """Each term of the two series may be off by a unit, and so may the rest of the series."""
    x, unit = enclosing(bits).pi(), F(1, 2 ** (bits + 32))
    error = 0
    for factor, n in ((16, 5), (4, 239)):
        terms = sum(n ** (2 * k + 1) * unit <= 1 for k in range(bits + 32))
        error += factor * (terms + 1)
    with mpmath.workprec(bits + 100):
        value = exact(+mpmath.pi)
    assert x.low <= value <= x.high
    assert x.high - x.low >= 2 * error * unit
    assert x.high - x.low <= F(1, 2 ** (bits + 20))


@pytest.mark.parametrize("bits", [*range(2, 12), 53, 64])
def test_cosines_with_room_for_the_rest_of_the_series(bits: int) -> None:
    """2^-n, which bounds it, lies between each end and the value, but where that end is cut off."""
    scope = enclosing(bits)
    rest = F(1, 2 ** (2 * (bits // 2 + 11) + 2))
    for d in (-3, 4, 7, -15, 100, 10**5, 10**99):
        x = scope.cos_pi_at(F(1, d))
        with mpmath.workprec(bits + 200):
            value = exact(mpmath.cos(mpmath.pi / d))
        assert x.low == -1 or x.low <= value - rest
        assert x.high == 1 or value + rest <= x.high
        assert x.high - x.low <= F(16, 2**bits)


@pytest.mark.parametrize("bits", [2, 64])
def test_cosines_are_exact_at_halves_and_nowhere_else(bits: int) -> None:
    scope = enclosing(bits)
    for k in range(-9, 10):
        x = scope.cos_pi_at(F(k, 2))
        assert x.low == x.high == (1, 0, -1, 0)[k % 4]
        for near in (F(k, 2) + F(1, 10**40), F(k, 3) + F(1, 12), F(2 * k + 1, 4)):
            x = scope.cos_pi_at(near)
            assert x.low < x.high
    assert scope.cos(scope.rational(0, 1)) == (1, 1)


@pytest.mark.parametrize("bits", [2, 3, 5, 8, 64])
def test_cosines_are_cut_to_what_cosines_can_be(bits: int) -> None:
    scope = enclosing(bits)
    assert scope.cos_pi_at(F(0)).high == scope.cos_pi_at(F(2)).high == 1
    assert scope.cos_pi_at(F(1)).low == scope.cos_pi_at(F(-1)).low == -1
    for x in (F(0), F(1, 2), F(1), F(-1, 3), F(99, 100)):
        assert scope.cos_pi_at(x) == scope.cos_pi_at(x + 2) == scope.cos_pi_at(x - 4)


@pytest.mark.parametrize("bits", [2, 3, 4, 5, 6, 7, 8])
def test_roots_between_neighbours(bits: int) -> None:
    """The ends are neighbouring multiples of 2^-bits / d, or equal for an exact root."""
    for n in range(60):
        for d in range(1, 12):
            x, value = enclosing(bits).sqrt(check.Interval(F(n, d), F(n, d))), F(n, d)
            assert x.low**2 <= value <= x.high**2
            step = F(1, value.denominator << bits)
            assert x.high - x.low == (0 if x.low**2 == value else step)


@pytest.mark.parametrize("bits", [2, 3, 4, 5, 6, 7, 8])
@pytest.mark.parametrize("n", [2, 3, 5, 6, 11])
def test_powers_at_low_precision(bits: int, n: int) -> None:
    for k in range(-40, 41):
        for m in (k, k + 1, k + 30):
            a, b = F(k, 13), F(m, 13)
            x = enclosing(bits).power(check.Interval(a, b), n)
            values = [a**n, b**n, *[F(0)] * (a <= 0 <= b)]
            assert x.low <= min(values)
            assert max(values) <= x.high
            assert n % 2 or x.low >= 0
            assert (x.low == 0) == (min(values) == 0)


# --- rules ---------------------------------------------------------------------------------------


def test_what_is_not_equal_has_no_sum() -> None:
    pair = Pair().row("next", "0 <= 1", INTERVAL)
    proof = total("goal", "1")
    said = verdict(pair.row("row", "2 = 1", proof, None, "refuted", "printed"))
    assert "found !=, expected <, <= or =" in said


def test_the_root_of_zero_is_defined() -> None:
    assert ground("sqrt(0)*sqrt(0) = 0", IDENTITY) == "proved"
    assert "not known to be >= 0" in ground("sqrt(-1)*sqrt(-1) = -1", IDENTITY)


def test_hypotheses_that_compare_with_another_number_than_zero() -> None:
    """From -1 <= x nothing follows about the root of x."""
    same = "sqrt(x)*sqrt(x) = x"
    for cut, good in (("-1", False), ("0", True)):
        said = in_box(same, cuts("x", [cut], IDENTITY, IDENTITY), ("-1", "1"))
        assert "not known to be >= 0" in said or good
    outer = box(("0", "1")).row("row", same, cuts("x", ["0", "1"], *[IDENTITY] * 3), "box")
    assert verdict(outer) == "proved"


def test_what_clears_in_a_branch_does_not_clear_outside() -> None:
    """The root of x has a value where 0 <= x, and no longer where the branch has ended."""
    nothing = ["mul", "0", ["square", term("sqrt(x)")]]
    branches = [total("goal", "1"), total("goal", "1", nothing)]
    pair = box(("-1", "1")).lemma("f", "0 <= 1", cuts("x", ["0"], *branches), "box")
    said = verdict(pair.row("row", "sqrt(x)*sqrt(x) = x", IDENTITY, "box"))
    assert said.startswith("REFUSED row")
    assert "the root of a term that is not known to be >= 0" in said


def test_what_clears_in_a_branch_does_not_clear_in_another() -> None:
    nothing = ["mul", "0", ["square", term("sqrt(x)")]]
    branches = [total("goal", "1"), total("goal", "1", nothing)]
    pair = box(("-1", "1")).lemma("f", "0 <= 1", cuts("x", ["0"], *branches), "box")
    proof = cuts("x", ["0"], IDENTITY, IDENTITY)
    said = verdict(pair.row("row", "sqrt(x)*sqrt(x) = x", proof, "box"))
    assert said.startswith("REFUSED row")
    assert "the root of a term that is not known to be >= 0" in said


@pytest.mark.parametrize("using", [[], ["other"]])
def test_what_equations_replace_stays_as_it_is_elsewhere(using: list[str]) -> None:
    pair = Pair().context("c", {"x": "1", "y": "2"}, {"is": "x = 1", "other": "y = 2"})
    pair.lemma("f", "x*x = 1", total(using=["is"]), "c")
    said = verdict(pair.row("row", "x*x = 1", total(using=using), "c"))
    assert "found sides that differ" in said


@pytest.mark.parametrize("proof", ["witness", ["witness"], None, True, {}])
def test_what_is_no_proof_of_a_negation(proof: Any) -> None:
    pair = Pair().row("next", "0 <= 1", INTERVAL)
    said = verdict(pair.row("row", "2 = 1", proof, None, "refuted", "printed"))
    assert said.startswith("MALFORMED: obligation row: rule: found ")


def test_each_undecided_row_is_named() -> None:
    pair = Pair().row("a", "0 <= 1", None, None, "undecided")
    code, lines = answer(pair.row("b", "0 <= 1", None, None, "undecided"))
    assert code == 1
    assert lines[:2] == [f"REFUSED {name}: a needed row is undecided" for name in "ab"]


def test_a_divisor_of_unknown_sign_has_no_opposite() -> None:
    """Its negative is no term so far, and none of the first terms, which are positive."""
    names = [f"x{i}" for i in range(9)]
    givens = {f"p{name}": f"0 < {name}" for name in names}
    pair = Pair().context("c", dict.fromkeys([*names, "y"], "1"), givens)
    said = verdict(pair.row("row", "y/y = 1", IDENTITY, "c"))
    assert "found a division by a term" in said


@pytest.mark.parametrize(
    ("claim", "said"),
    [("5/4 <= x", "proved"), ("3/2 <= x", "REFUSED"), ("x <= 7/4", "proved"),
     ("x <= 13/8", "REFUSED")],
)  # fmt: skip
def test_bounds_are_the_outer_ends_of_enclosures(claim: str, said: str) -> None:
    """At two bits the roots of 2 and 3 lie in [5/4, 3/2] and [3/2, 7/4]."""
    givens = {"low": "sqrt(2) <= x", "high": "x <= sqrt(3)"}
    pair = Pair().context("c", {"x": "3/2"}, givens)
    proof = interval(("x", "low", "high"), bits=2)
    assert verdict(pair.row("row", claim, proof, "c")).startswith(said)


@pytest.mark.parametrize(
    "claim",
    [
        "sqrt(2)*sqrt(2) = 3",
        "sqrt(2)*sqrt(2) = 1",
        "sqrt(2)**4 = 2",
        "sqrt(2)**3 = 2",
        "sqrt(2)*sqrt(3) = 6",
        "sqrt(2)*sqrt(2) + 1 = 2",
    ],
)
def test_what_squares_of_roots_are_not(claim: str) -> None:
    assert "found sides that differ" in ground(claim, IDENTITY)


def test_roots_are_reduced_in_each_proof() -> None:
    pair = Pair().lemma("f", "sqrt(2)*sqrt(2) = 2", IDENTITY)
    assert verdict(pair.row("row", "sqrt(2)*sqrt(2) = 2", IDENTITY)) == "proved"


def test_the_entries_that_an_equation_brings_in_must_clear() -> None:
    pair = Pair().define("k", "min(1/cos(1), 2)", INTERVAL)
    pair.lemma("f", "k <= 2", entry("lhs", "k"))
    assert "found a division by a term" in verdict(pair.row("row", "0 <= 1", INTERVAL))


def test_no_folder_at_all() -> None:
    assert check.check_folders([]) == (0, [])


def test_a_fraction_that_is_whole_becomes_an_integer() -> None:
    """Integers are less work from then on."""
    assert [type(check.whole(Fraction(n, 2))) for n in (4, 3)] == [int, Fraction]


def test_a_folder_and_a_file_are_no_statement_and_certificate(tmp_path: Path) -> None:
    """One folder among two arguments, and both are taken for folders."""
    file = tmp_path / "statement.json"
    file.write_text("{}")
    with pytest.raises(OSError, match=r"certificate\.json"):
        check.read_folders([str(tmp_path), str(file)])


# --- words of the format -------------------------------------------------------------------------


@pytest.mark.parametrize(
    ("shape", "words"),
    [
        (check.side, ["lhs", "rhs"]),
        (check.exponent, ["1", "999"]),
        (check.name, ["a", "A" + 99 * "."]),
        (check.number, ["0", "-7/12"]),
    ],
)
def test_words_are_whole(shape: check.Shape, words: list[str]) -> None:
    for word in words:
        shape(word)
        for other in (word[:-1] if len(word) > 1 else "", word + "?", " " + word):
            if other not in (words[0], "-7/1", "99", "A" + 98 * "."):
                with pytest.raises(check.Malformed, match=r"^: found"):
                    shape(other)


@pytest.mark.parametrize("last", ["format", "kind", "role", "verdict"])
def test_words_of_a_statement_are_whole(last: str) -> None:
    """Each of the words that may stand there, without its last letter."""
    words = {
        "format": ["verify-statement/2"],
        "kind": ["plain", "carried", "standing"],
        "role": ["needed", "printed"],
        "verdict": ["proved", "refuted", "undecided"],
    }[last]
    for word in words:
        pair = Pair().context("c", {"x": "1"}, {"g": "0 < x"}).row("row", "0 < 1", INTERVAL)
        for item, name in (
            (pair.statement, "format"),
            (pair.statement["contexts"][0]["givens"][0], "kind"),
            (pair.statement["obligations"][0], "role"),
            (pair.statement["obligations"][0], "verdict"),
        ):
            if name == last:
                item[name] = word[:-1]
        code, lines = answer(pair)
        assert (code, f": found {word[:-1]}, expected" in lines[-1]) == (4, True)


def test_the_format_of_a_certificate_is_whole() -> None:
    pair = Pair().row("row", "0 < 1", INTERVAL)
    first, second = pair.files()
    assert answer((first, second.replace(b"verify-certificate/2", b"verify-certificate/")))[0] == 4


def test_odd_powers_of_roots_leave_one_factor() -> None:
    kernel = check.Kernel()
    clearing = check.Clearing(kernel, check.Place(kernel.outermost), ())
    root = kernel.read("", ["sqrt", "3"], kernel.outermost)
    clearing.clear(root)
    for power, number, left in ((1, 1, 1), (2, 3, 0), (3, 3, 1), (4, 9, 0), (5, 9, 1)):
        found = clearing.reduce({((root, power),): 7, ((root - 1, 1),): 1})
        once = {((root, 1),): 7 * number} if left else {(): 7 * number}
        assert found == {**once, ((root - 1, 1),): 1}


def test_numbers_are_looked_up_by_texts() -> None:
    """A file can foresee the hashes of whole numbers, and so make all of them the same."""
    node = check.Node("rational", (), (2**61 - 1, 7))
    assert check.key(*node) == (hex(2**61 - 1), "0x7")
