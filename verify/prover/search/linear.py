"""Sums of facts, of their products and of multiples of equations, by exact linear programming.

By Farkas a linear claim that follows from linear facts is a sum of them; by Handelman a polynomial
that is positive on a polytope is a sum of products of what bounds it. Monomials count as variables.
"""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from fractions import Fraction
from itertools import combinations, combinations_with_replacement, islice

from flint import fmpq, fmpq_mpoly

from verify.language.record import Record
from verify.language.statement import Given
from verify.language.terms import Claim, as_term, symbol
from verify.prover.balls import fraction_of
from verify.prover.clearing import TooLongError, expanded
from verify.prover.proof import Proof, Value, product_of
from verify.prover.rules import Sum
from verify.prover.search.question import Question
from verify.prover.search.simplex import Column, solution
from verify.prover.search.system import Fact, System

#: The row that says that something positive is in the sum.
STRICT = 0
#: Larger programmes lose first the columns that cannot be in a sum.
MAX_COLUMNS = 420
MAX_ROWS = 260
#: Those that are larger then are not tried, nor more products.
MOST_COLUMNS = 2500
MOST_ROWS = 800
MOST_PRODUCTS = 6000
#: The part of the work that is left which one large programme may take, and the least.
PART = 8
LEAST = 300_000
#: The work of one product.
PRODUCT = 20


class Multiple(Record):
    """An equation's difference times a polynomial."""

    polynomial: fmpq_mpoly
    name: str
    cofactor: fmpq_mpoly


def by_linear_sum(question: Question) -> Proof | None:
    """A sum of facts with positive numbers, and of equations with any."""
    system = System(question)
    multiples = [Multiple(p, name, system.clearing.one) for name, p in system.equations.items()]
    return _solved(system, [system.goal, *system.facts], multiples)


def by_products(question: Question, degree: int) -> Proof | None:
    """The same with products of at most so many facts, squares, and multiples of equations."""
    system, proof = System(question), None
    with question.budget.at_most(max(question.budget.left // PART, LEAST)):
        columns = [*islice(_columns(system, degree), MOST_PRODUCTS)]
        most = max(_degree(column.polynomial) for column in columns)
        left = MOST_PRODUCTS - len(columns)
        multiples = [*islice(_multiples(system, most), max(0, left + 1))]
        if len(multiples) <= left:
            proof = _solved(system, columns, multiples)
    return proof


def find_ranges(question: Question) -> bool:
    """Afterwards variables have the bounds that linear facts give them; whether that is news."""
    known, place = question.known, question.goal.context
    try:
        system, found = System(question), False
    except TooLongError:
        return False
    for name, bounds in question.goal.variables.items():
        if not known.is_at_home(name, place):
            continue
        if bounds.low is None:
            found |= _bounded(system, name, 1)
        if bounds.high is None:
            found |= _bounded(system, name, -1)
    return found


def _bounded(system: System, name: str, sign: int) -> bool:
    """Whether a variable (with sign -1: its opposite) has a least value, by a sum of facts."""
    if symbol(name) not in system.clearing.generators:
        return False
    target = sign * system.clearing.generators[symbol(name)]
    multiples = [Multiple(p, key, system.clearing.one) for key, p in system.equations.items()]
    facts = system.facts
    found = least(system, facts, target, multiples)
    is_round = any(int(fact.polynomial.total_degree()) == 2 for fact in facts)
    if found is None and (multiples or is_round):
        facts = [*facts, *_squares(system)]
        found = least(system, facts, target, multiples)
    if found is None:
        return False
    bound, weights, shares = found
    strict = any(w and fact.strict for w, fact in zip(weights, facts, strict=True))
    number, variable = as_term(sign * bound), symbol(name)
    sides = (number, variable) if sign > 0 else (variable, number)
    claim = Claim("<" if strict else "<=", *sides)
    proof = sum_of_facts(system, ("goal",), (weights, facts), (shares, multiples))
    known, place = system.question.known, system.question.goal.context
    known.narrow(name, Given(known.session.lemma(claim, proof, place), claim))
    return True


def _squares(system: System) -> Iterator[Fact]:
    """The squares of variables, and of their distances from 1 and -1.

    With them x^2 + y^2 = 1 bounds x and y.
    """
    for x in (system.clearing.generators[a] for a in system.atoms if a.op == "symbol"):
        for base in (x, x - 1, x + 1):
            yield Fact(base * base, ("square", expanded(base, system.atoms)), False)


def least(
    system: System,
    facts: Sequence[Fact],
    target: fmpq_mpoly,
    multiples: Sequence[Multiple],
) -> tuple[Fraction, list[fmpq], list[fmpq]] | None:
    """The largest number that facts show to be at most a polynomial, and how often each counts."""
    rows: dict[tuple[int, ...], int] = {}
    every = [*(f.polynomial for f in facts), *(m.polynomial for m in multiples)]
    constant = (0,) * len(system.atoms)
    split = [{tuple(map(int, m)): c for m, c in p.to_dict().items()} for p in every]
    costs = [parts.pop(constant, fmpq(0)) for parts in split]
    columns = [{rows.setdefault(m, len(rows)): c for m, c in parts.items()} for parts in split]
    wanted = {tuple(map(int, m)): c for m, c in target.to_dict().items()}
    if any(m not in rows for m in wanted):
        return None
    count = len(facts)
    right = {rows[m]: c for m, c in wanted.items()}
    budget = system.question.budget
    found = solution(columns[:count], columns[count:], right, budget, costs)
    if found is None:
        return None
    weights, shares = found
    total = sum((w * c for w, c in zip((*weights, *shares), costs, strict=True)), fmpq(0))
    return -fraction_of(total), weights, shares


def _columns(system: System, degree: int) -> Iterator[Fact]:
    """Products of at most so many facts, and squares of atoms and their differences."""
    single = [system.goal, *system.facts]
    yield from single
    for chosen in combinations_with_replacement(single, 2):
        yield _product(system, chosen)
    for count in range(3, degree + 1):
        for several in combinations_with_replacement(single, count):
            yield _product(system, several)
    gens = system.context.gens()
    bases = [*gens, *(a - b for a, b in combinations(gens, 2))]
    bases += [a + b for a, b in combinations(gens, 2)]
    bases += _roots(system)
    for base in bases:
        square: Value = ("square", expanded(base, system.atoms))
        yield Fact(system.reduced(base * base), square, False)
        if degree > 2:
            for fact in single:
                yield Fact(
                    system.reduced(base * base * fact.polynomial),
                    ("mul", square, fact.value),
                    False,
                )


def _roots(system: System) -> Iterator[fmpq_mpoly]:
    """The monomials of degree 2 or more whose squares are monomials of facts or of the goal."""
    every = [system.goal, *system.facts]
    found = dict.fromkeys(tuple(map(int, m)) for fact in every for m in fact.polynomial.monoms())
    for monomial in found:
        if sum(monomial) > 2 and not any(power % 2 for power in monomial):
            yield system.context.from_dict({tuple(k // 2 for k in monomial): fmpq(1)})


def _product(system: System, facts: Sequence[Fact]) -> Fact:
    polynomial = system.clearing.one
    system.question.budget.spend(PRODUCT)
    for fact in facts:
        polynomial = polynomial * fact.polynomial
    value = product_of(*(fact.value for fact in facts))
    return Fact(system.reduced(polynomial), value, all(fact.strict for fact in facts))


def _multiples(system: System, degree: int) -> Iterator[Multiple]:
    """Equations times monomials, up to a degree."""
    gens = system.context.gens()
    for name, p in system.equations.items():
        for power in range(max(0, degree - _degree(p)) + 1):
            for chosen in combinations_with_replacement(gens, power):
                cofactor = system.clearing.one
                system.question.budget.spend(PRODUCT)
                for x in chosen:
                    cofactor = cofactor * x
                yield Multiple(system.reduced(p * cofactor), name, cofactor)


def _degree(polynomial: fmpq_mpoly) -> int:
    return int(polynomial.total_degree())


def _solved(system: System, facts: Sequence[Fact], multiples: Sequence[Multiple]) -> Proof | None:
    """The sum that is zero although something in it is positive."""
    rows: dict[tuple[int, ...], int] = {}

    def column(polynomial: fmpq_mpoly, strict: bool) -> Column:
        found = {rows.setdefault(m, len(rows) + 1): c for m, c in polynomial.to_dict().items()}
        return found | {STRICT: fmpq(1)} if strict else found

    one = Fact(system.clearing.one, "1", True)
    known = [one, *facts]
    columns = [column(fact.polynomial, fact.strict) for fact in known]
    free = [column(multiple.polynomial, strict=False) for multiple in multiples]
    if len(rows) > MAX_ROWS or len(columns) + len(free) > MAX_COLUMNS + 1:
        useful = _useful(columns, free)
        known, columns = [known[i] for i in useful], [columns[i] for i in useful]
        count = len({row for each in (*columns, *free) for row in each})
        if count > MOST_ROWS or len(columns) + len(free) > MOST_COLUMNS:
            return None
        if not any(fact.strict for fact in known):
            return None
    found = solution(columns, free, {STRICT: fmpq(1)}, system.question.budget)
    if found is None:
        return None
    weights, shares = found
    return sum_of_facts(system, (), (weights, known), (shares, multiples))


def _useful(columns: Sequence[Column], free: Sequence[Column]) -> list[int]:
    """The columns without those with a monomial that no other one can cancel, again and again."""
    signs = [{row: value > 0 for row, value in one.items() if row != STRICT} for one in columns]
    kept = {row for one in free for row in one}
    left = [*range(len(columns))]
    while True:
        found: dict[int, set[bool]] = {}
        for i in left:
            for row, sign in signs[i].items():
                found.setdefault(row, set()).add(sign)
        bad = {row for row, seen in found.items() if len(seen) == 1} - kept
        if not bad:
            return left
        left = [i for i in left if bad.isdisjoint(signs[i])]


def sum_of_facts(
    system: System,
    first: tuple[Value, ...],
    facts: tuple[Sequence[fmpq], Sequence[Fact]],
    multiples: tuple[Sequence[fmpq], Sequence[Multiple]],
) -> Sum:
    """The sum of some values, of facts, and of multiples of equations."""
    addends = tuple(
        product_of(str(fraction_of(weight)), system.named(fact.value))
        for weight, fact in zip(*facts, strict=True)
        if weight
    )
    cofactors: dict[str, fmpq_mpoly] = {}
    for share, multiple in zip(*multiples, strict=True):
        if share:
            cofactors.setdefault(multiple.name, system.context.constant(0))
            cofactors[multiple.name] += share * multiple.cofactor
    equations = tuple((name, expanded(p, system.atoms)) for name, p in cofactors.items())
    return Sum((*first, *addends), system.using, equations)
