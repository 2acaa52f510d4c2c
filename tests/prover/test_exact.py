"""The search's own intervals, beside those of the checker, on random terms."""

from __future__ import annotations

import random
from fractions import Fraction

import pytest

from verify import check
from verify.language.fold import MissingOperationError, fold
from verify.language.terms import Term, as_term, cos, cos_pi, maximum, minimum, sqrt, symbol
from verify.prover.search.exact import ExactRanges, Range

x, y, u = symbol("x"), symbol("y"), symbol("u")


class Checker:
    """The interval of a term by the checker's operations; None where it refuses."""

    def __init__(self, names: dict[str, Range], definitions: dict[str, Term], bits: int) -> None:
        kernel = check.Kernel()
        kernel.work = 1 << 62
        self.scope = check.Enclosing(kernel, bits, None)
        self.known = {name: check.Interval(*ends) for name, ends in names.items()}
        self.definitions = definitions

    def of(self, term: Term) -> Range | None:
        try:
            return tuple(self.value(term))
        except check.Refused:
            return None

    def value(self, term: Term) -> check.Interval:
        if term.op == "symbol":
            if term.name not in self.known:
                self.known[term.name] = self.value(self.definitions[term.name])
            return self.known[term.name]
        rest = (term.exponent,) if term.op == "pow" else ()
        if term.op == "rational":
            rest = term.value.as_integer_ratio()
        operands = [self.value(child) for child in term.children]
        return self.scope.outward(check.OPERATIONS[term.op](self.scope, *operands, *rest))


def random_term(r: random.Random, depth: int) -> Term:
    if depth == 0:
        return r.choice(
            (x, y, u, as_term(Fraction(r.randrange(-9, 10), r.choice((1, 2, 7, 10**9)))))
        )
    a, b = random_term(r, depth - 1), random_term(r, r.randrange(depth))
    one = r.choice((lambda: sqrt(a), lambda: cos(a), lambda: cos_pi(a), lambda: -a))
    two = r.choice((a + b, a - b, a * b, minimum(a, b), maximum(a, b, x), a ** r.randrange(1, 8)))
    return r.choice((one, lambda: two, lambda: two, lambda: a / (b**2 + 1), lambda: a / b))()


@pytest.mark.parametrize("seed", range(300))
def test_the_ends_are_those_of_the_checker(seed: int) -> None:
    r = random.Random(seed)
    bits = r.choice((8, 48, 64, 128))
    numbers = [Fraction(r.randrange(-99, 100), r.choice((1, 2, 10, 3**30))) for _ in range(4)]
    first, second = sorted(numbers[:2]), sorted(numbers[2:])
    definitions = {"u": x * y + r.randrange(3)}
    term = random_term(r, r.randrange(1, 5))
    ends: list[Range] = [(first[0], first[1]), (second[0], second[1])]
    found = ExactRanges(["x", "y"], definitions, bits).of(ends, term)
    names = dict(zip("xy", ends, strict=True))
    assert (None if found is None else found[0]) == Checker(names, definitions, bits).of(term)


def test_most_random_terms_have_an_interval() -> None:
    zero = [(Fraction(1, 3), Fraction(1, 2))] * 3
    terms = [random_term(random.Random(seed), 3) for seed in range(100)]
    found = [ExactRanges("xyu", {}, 48).of(zero, term) for term in terms]
    assert found.count(None) < 50
    assert sum(r is not None and r[0][0] < r[0][1] for r in found) > 30


def test_an_operation_that_is_missing_is_an_error() -> None:
    algebra = {"add": lambda a, b: a + b, "rational": lambda value: value}
    assert fold(as_term(1) + as_term(2), algebra, {}) == 3
    with pytest.raises(MissingOperationError, match="there is no mul among add, rational"):
        fold(as_term(2) * symbol("x"), algebra, {symbol("x"): Fraction(1)})
