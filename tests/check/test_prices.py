"""What each operation costs: whoever changes a price says so here, too.

A certificate may be too much work, and a file of 4 MB must not take long: both rest on prices.
"""

from __future__ import annotations

import re
import sys
from fractions import Fraction
from hashlib import sha256
from itertools import count
from pathlib import Path
from typing import Any

import pytest

from tests.check.support import Pair, box, cases, cuts, entry, induction, interval, term
from verify import check

F = Fraction
Spent = list[tuple[int, int]]


class Ledger(check.Kernel):
    """A kernel that writes down what is spent: of how many bits, and how often."""

    def __init__(self) -> None:
        self.spent: Spent = []
        super().__init__()

    def spend(self, bits: int, times: int = 1) -> None:
        self.spent.append((bits, times))
        super().spend(bits, times)

    def bill(self) -> Spent:
        """What was spent since the last time."""
        found, self.spent = self.spent, []
        return found

    def term(self, text: Any) -> int:
        """A term, as if it had been there before."""
        found = self.read("", term(text), self.outermost)
        self.bill()
        return found


@pytest.fixture
def ledger() -> Ledger:
    return Ledger()


def clearing(ledger: Ledger, place: check.Place | None = None) -> check.Clearing:
    return check.Clearing(ledger, place or check.Place(ledger.outermost), ())


def test_the_limits_are_those_of_the_format() -> None:
    """What the page about the format says, digit by digit."""
    page = (Path(check.__file__).parents[1] / "certificates/README.md").read_text(encoding="utf-8")
    words = " ".join(page.partition("Limits: ")[2].split())
    numbers = (
        rf"{check.MAX_BYTES >> 20} MiB for a file",
        r"2\^25 bytes for all in `cited/`",
        rf"{check.MAX_NAME} characters for a name",
        rf"{check.MAX_NESTING} nested brackets, and contexts",
        rf"{check.MAX_HEIGHT} levels of a term",
        rf"2 to {check.MAX_BITS} bits for enclosures",
        r"2\^19 bits for a number",
        r"degree 2\^20 of an atom",
        rf"{check.MAX_WORK:_} units of work".replace("_", " "),
        rf"more than {check.MAX_REFUSED} refusals",
    )
    for number in numbers:
        assert re.search(number, words), number
    assert (check.MAX_BYTES, check.MAX_CITED) == (4 * 2**20, 2**25)
    assert (check.MAX_SIZE, check.MAX_DEGREE) == (2**19, 2**20)


@pytest.mark.parametrize("bits", [0, 255, 256, 1023, 1024, 5000, 2**19])
@pytest.mark.parametrize("times", [1, 3])
def test_a_unit_is_the_time_of_an_operation_on_short_numbers(bits: int, times: int) -> None:
    kernel = check.Kernel()
    kernel.spend(bits, times)
    assert check.MAX_WORK - kernel.work == times * (2 + bits // 2**8 + bits**2 // 2**20)


# --- terms, names and facts ----------------------------------------------------------------------


def test_a_new_term_is_stored(ledger: Ledger) -> None:
    a, b = ledger.term("2"), ledger.term("3")
    ledger.node("add", (a, b))
    ledger.node("add", (a, b))
    ledger.node("neg", (a,))
    assert ledger.bill() == [(0, 6), (0, 5)]


def test_a_number_is_read_and_made_once(ledger: Ledger) -> None:
    found = ledger.read("", "-1023/16", ledger.outermost)
    assert ledger.bill() == [(10 + 5, 1), (0, 4)]
    for _ in range(2):
        assert ledger.number(found, -1023, 16) == F(-1023, 16)
    assert ledger.bill() == [(11 + 6, 1)]


@pytest.mark.parametrize("length", [1, 3, 4, 7, 8, 1000])
def test_a_name_is_looked_up(ledger: Ledger, length: int) -> None:
    ledger.introduce("a" * length)
    assert ledger.bill() == [(0, 1 + length // 4)]


@pytest.mark.parametrize("depth", [0, 15, 16, 33])
@pytest.mark.parametrize("hypotheses", [0, 2])
def test_hypotheses_and_contexts_are_looked_through(
    ledger: Ledger, depth: int, hypotheses: int
) -> None:
    context = ledger.outermost
    for i in range(depth):
        context = check.Context(f"c{i}", context)
    one = ledger.term("1")
    place = check.Place(context, (check.Claim("<", one, one),) * hypotheses)
    assert not ledger.knows("<", one, place)
    assert ledger.bill() == [(0, 1 + hypotheses + depth // 16)]


def test_each_term_below_others_is_visited_once(ledger: Ledger) -> None:
    three = ledger.term("min(1, 2, 1 + 2)")
    assert len(ledger.below((three, three), lambda _: False)) == 4
    assert sorted(ledger.bill()) == [(0, 1), (0, 1), (0, 3), (0, 4)]


def test_an_instance_of_a_fact(ledger: Ledger) -> None:
    context = check.Context("c", ledger.outermost)
    x, seven = ledger.new_name("x", context), ledger.term("7")
    lhs = ledger.node("neg", (x,))
    ledger.bill()
    claim = ledger.substitute(check.Claim("<", lhs, x), context, {x: seven})
    assert claim == check.Claim("<", ledger.node("neg", (seven,)), seven)
    assert ledger.bill() == [(0, 2), (0, 2), (0, 5)]


# --- polynomials ---------------------------------------------------------------------------------

X, LONG = ((1, 1),), tuple((atom, 1) for atom in range(35))


def test_sums_of_polynomials(ledger: Ledger) -> None:
    """Each coefficient of the first is copied, and each of the second one is added."""
    first = {X: 7, (): 1, ((2, 1),): 1}
    ledger.plus(first, {X: 1023, LONG: F(3, 16), (): F(1, 2)}, -5)
    assert ledger.bill() == [
        (0, 4),
        (4 + 11, 1),
        (1 + 2 + 5, 2 + 2),
        (2 + 1 + 2, 2),
    ]


def test_products_of_polynomials(ledger: Ledger) -> None:
    """Each coefficient of the one is multiplied with each of the other."""
    ledger.times({X: 7, (): 3}, {LONG: F(3, 16), (): 2})
    assert ledger.bill() == [
        (0, 1 + 2),
        (4 + 7 + 1, 1 + 35),  # the two monomials have 35 atoms together
        (4 + 3 + 1, 1 + 1),
        (3 + 7 + 1, 1 + 35),
        (3 + 3 + 1, 1),
    ]
    ledger.times({X: 1, (): 1}, {X: 1, (): 2})
    before = 2 + 1  # 2 and 1 times x are added
    assert ledger.bill() == [(0, 3), (5, 2), (6, 2), (before + 4, 2), (6, 1)]
    ledger.times(check.ONE, {X: 7})
    ledger.times({X: 7}, check.ONE)
    assert ledger.bill() == []


def test_a_term_is_cleared_once(ledger: Ledger) -> None:
    product = ledger.term("2*3")
    found = clearing(ledger)
    found.clear(product)
    found.clear(product)
    two = three = [(0, 2), (3 + 2, 1)]  # each a term, and a number over 1
    assert ledger.bill() == [(0, 2 + 2), *two, *three, (0, 1 + 1), (3 + 3 + 1, 1)]


def test_sums_look_at_both_denominators(ledger: Ledger) -> None:
    names = [ledger.new_name(name, ledger.outermost) for name in "abcd"]
    a, b, c, d = names
    found = clearing(ledger)
    one, other = {((c, 1), (d, 1)): 1, ((c, 2),): 1}, {((d, 1),): 1}
    three = {X: 1, ((2, 1),): 1, LONG: 1}
    found.cleared |= {a: (three, one), b: ({(): 2}, other)}
    total = ledger.node("add", (a, b))
    ledger.bill()
    found.clear(total)
    products = [(0, 1 + 3), (0, 1 + 1), (0, 1 + 3), (0, 1 + 2)]  # with the sum of two of them
    assert [found for found in ledger.bill() if not found[0]] == [(0, 4), (0, 5), *products]


def test_squares_of_roots_are_looked_for(ledger: Ledger) -> None:
    found = clearing(ledger)
    root = ledger.term("sqrt(2)")
    found.clear(root)
    ledger.bill()
    p = {((root, 1), (root + 1, 1)): 1, ((root, 1),): 1, (): 1}
    assert found.reduce(p) == p
    assert ledger.bill() == [(0, 1 + 2 + 1)]


# --- rules ---------------------------------------------------------------------------------------


def bill_of(pair: Pair, rule: str) -> Spent:
    """What is spent by a rule itself, in the last step of a pair."""
    ledger = Ledger()
    reader = check.Reader(ledger, {})
    checking = check.Checking(ledger, reader, reader.read(pair.statement))
    for step in pair.steps[:-1]:
        checking.step(step)
    direct: Spent = []

    def seen(bits: int, times: int = 1) -> None:
        if sys._getframe(1).f_code.co_name == rule:
            direct.append((bits, times))

    ledger.spend = seen  # type: ignore[method-assign]
    checking.step(pair.steps[-1])
    assert not checking.complaints
    return direct


BOUNDS = interval(("x", "x-low", "x-high"))


def test_branches_have_hypotheses() -> None:
    inner = cuts("x", ["1/3"], BOUNDS, BOUNDS)
    pair = box(("0", "1")).row("row", "x <= 2", cuts("x", ["1/2"], inner, BOUNDS), "box")
    assert bill_of(pair, "cuts") == [(0, 2), (0, 2 + 1), (0, 2 + 1), (0, 2)]
    least = cases("min(x, 2, 3)", BOUNDS, BOUNDS, BOUNDS)
    pair = box(("0", "1")).row("row", "x <= 2", cuts("x", ["1/2"], least, BOUNDS), "box")
    assert bill_of(pair, "cases") == [(0, 2 * 3 + 1)] * 3


def test_what_is_proved_in_between_is_a_hypothesis() -> None:
    claim = ["<=", "x", "3"]
    inner = {"rule": "have", "claim": claim, "branches": [BOUNDS, BOUNDS]}
    outer = {"rule": "have", "claim": claim, "branches": [inner, inner]}
    pair = box(("0", "1")).row("row", "x <= 2", cuts("x", ["1/2"], inner, outer), "box")
    assert bill_of(pair, "have") == [(0, 2 + n) for n in (1, 1, 1, 2)]


def test_an_entry_is_looked_for() -> None:
    for n in (1, 15, 16, 47):
        entries = [str(i) for i in range(48)]
        pair = Pair().row("row", ["<=", ["min", *entries], str(n)], entry("lhs"))
        assert bill_of(pair, "entry") == [(0, n // 16)]


def test_coefficients_become_fractions() -> None:
    square = ["pow", "x", "2"]
    bound = ["add", "1", ["mul", square, ["add", "-1/2", ["mul", square, "1/16"]]]]
    pair = box(("0", "1")).row("row", ["<=", ["cos", "x"], bound], {"rule": "cosine"}, "box")
    assert bill_of(pair, "coefficients") == [(2 + 2, 2), (2 + 3, 2), (2 + 6, 2)]


def test_givens_of_what_always_holds() -> None:
    givens = {"p": ("0 < x", "carried", None), "q": ("0 <= x", "carried", None)}
    pair = Pair().context("s", {"x": "1"}, givens)
    premises = ["p", "q"]
    proof = induction([interval(), interval()], premises)
    pair.row("row", ["always", "s", {"x": "1"}, {"x": "x"}], proof)
    assert bill_of(pair, "induction") == [(0, 2)]


# --- enclosures ----------------------------------------------------------------------------------


def test_ends_are_counted_where_they_are_used(ledger: Ledger) -> None:
    """Twice for each argument of an operation, and twice for the result."""
    five, third = ledger.term("5"), ledger.term("1/3")
    product = ledger.term(["mul", "5", "1/3"])
    scope = check.Enclosing(ledger, 64, None)
    scope.enclose(five), scope.enclose(third)
    ledger.bill()
    assert scope.enclose(product) == (F(5, 3), F(5, 3))
    arguments = [(2 * (3 + 1), 2), (2 * (1 + 2), 2)]
    rounded = [(3 + 2, 1), (3 + 2, 1)]
    assert ledger.bill() == [(0, 1 + 2), *arguments, *rounded, (2 * (3 + 2), 2)]


@pytest.mark.parametrize("bits", [2, 64])
def test_roundings_and_roots(ledger: Ledger, bits: int) -> None:
    scope = check.Enclosing(ledger, bits, None)
    scope.shorter(F(-1023, 16), 1)
    assert ledger.bill() == [(10 + 5, 1)]
    scope.sqrt(check.Interval(F(3), F(5, 4)))
    assert ledger.bill() == [(2 + 2 * bits, 1), (5 + 2 * bits, 1)]


@pytest.mark.parametrize("bits", [2, 64, 4000])
def test_each_term_of_the_series_of_pi(ledger: Ledger, bits: int) -> None:
    """One where the rest of the series is not 0, for a number of so many bits and 32 more."""
    scope = check.Enclosing(ledger, bits, None)
    scope.pi()
    scope.pi()
    length = bits + 32
    terms = sum(next(k for k in count() if n ** (2 * k + 1) > 2**length) for n in (5, 239))
    assert ledger.bill() == [(0, 1 + length // 2000)] * terms


@pytest.mark.parametrize("bits", [2, 64, 333])
def test_each_term_of_the_series_of_a_cosine(ledger: Ledger, bits: int) -> None:
    scope = check.Enclosing(ledger, bits, None)
    scope.pi()
    ledger.bill()
    scope.cos_pi_at(F(1, 7))
    assert ledger.bill()[-(bits // 2 + 11) :] == [(bits + 32, 2)] * (bits // 2 + 11)
    scope.cos_pi_at(F(1, 2))
    assert ledger.bill() == []


# --- files ---------------------------------------------------------------------------------------


def test_a_cited_statement_is_parsed() -> None:
    other = Pair("other").row("row", "0 <= 1", interval())
    data, _ = other.files()
    ledger = Ledger()
    digest = sha256(data).hexdigest()
    reader = check.Reader(ledger, {digest: data})
    reader.cite({"name": "o", "theorem": "other", "statement_sha256": digest}, "")
    brackets = data.count(b"[") + data.count(b"{")
    assert ledger.bill()[:3] == [(0, 1), (0, 100 + len(data) // 3), (0, brackets)]


@pytest.mark.parametrize("end", ["-1.25e-30", "3e77", "3"])
def test_the_exponents_of_decimals(end: str) -> None:
    ledger = Ledger()
    reader = check.Reader(ledger, {})
    checking = check.Checking(ledger, reader, reader.read(Pair().statement))
    one = ledger.term("1")
    checking.enclosed("name", one, [end, "1e99"], 64)
    exponent = {"-1.25e-30": 30, "3e77": 77, "3": 0}[end]
    assert ledger.bill()[:2] == [(4 * (exponent + len(end)), 1), (4 * (99 + 4), 1)]


def test_both_files_are_parsed() -> None:
    pair = Pair().row("row", "0 <= 1", interval())
    room, spent = check.MAX_WORK, []

    class Kernel(Ledger):
        def spend(self, bits: int, times: int = 1) -> None:
            spent.append((bits, times))

    with pytest.MonkeyPatch.context() as patch:
        patch.setattr(check, "Kernel", Kernel)
        check.check(*pair.files(), {}, room)
    first, second = pair.files()
    brackets = sum(data.count(sign) for data in (first, second) for sign in (b"[", b"{"))
    assert spent[:2] == [(0, (len(first) + len(second)) // 8), (0, brackets)]


def test_a_quotient_by_a_number_is_a_product_with_each_monomial(ledger: Ledger) -> None:
    found = clearing(ledger)
    name, half = ledger.new_name("n", ledger.outermost), ledger.term("1/2")
    quotient = ledger.node("div", (name, half))
    found.cleared |= {name: ({X: 1, LONG: 1, (): 1}, check.ONE), half: ({(): F(1, 2)}, check.ONE)}
    ledger.bill()
    assert found.clear(quotient) == ({X: 2, LONG: 2, (): 2}, check.ONE)
    assert ledger.bill()[:2] == [(0, 2 + 2), (0, 1 + 3)]


def test_the_first_factor_is_gone_through(ledger: Ledger) -> None:
    found = clearing(ledger)
    a, b = (ledger.new_name(name, ledger.outermost) for name in "ab")
    one, three = {X: 2}, {X: 2, LONG: 2, (): 2}
    found.cleared |= {a: (one, three), b: (three, one)}
    for first, second, bill in ((a, b, [2, 4]), (b, a, [4, 2])):
        product = ledger.node("mul", (first, second))
        ledger.bill()
        found.clear(product)
        assert [times for bits, times in ledger.bill() if not bits] == [4, *bill]


def test_what_has_no_variables_is_enclosed_once(ledger: Ledger) -> None:
    """Whatever bounds other names have: all enclosures of a precision share it."""
    context = check.Context("c", ledger.outermost)
    x, root = ledger.new_name("x", context), ledger.term("sqrt(2)")
    total = ledger.node("add", (x, root))
    base = check.Enclosing(ledger, 64, None)
    for _ in range(2):
        scope = check.Enclosing(ledger, 64, base)
        scope.known[x] = check.UNIT
        scope.enclose(total)
        assert {*scope.known} == {x, total}
    assert root in base.known
