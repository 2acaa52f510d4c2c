"""From the names of facts alone: the products of them, and multiples of equations, that add up.

Handelman and Krivine: what is positive where facts hold is a sum of their products. Here the facts
are few, since somebody named them, so that an exact linear programme over all products up to some
degree is small. Equations whose left side is an atom may replace it.
"""

from __future__ import annotations

from collections.abc import Callable, Iterable, Iterator, Mapping, Sequence
from itertools import combinations_with_replacement
from typing import Any

from flint import fmpq, fmpq_mpoly

from verify.language.record import Record
from verify.language.terms import Claim, Term
from verify.prover.balls import fraction_of
from verify.prover.budget import WorkBudget
from verify.prover.clearing import ATOMS, ROOTS, Clearing, expanded, inner_first, variables_in
from verify.prover.proof import Value, product_of
from verify.prover.rules import Sum
from verify.prover.search.eliminated import Elimination, Fact
from verify.prover.search.simplex import solution

#: Products of so many facts, the negated claim included.
MAX_DEGREE = 5
#: Programmes with more products, multiples of equations, or monomials are not tried.
MAX_COLUMNS, MAX_MULTIPLES, MAX_ROWS = 900, 500, 1500
#: Products of two monomials that expanding all of it may take.
MAX_EXPANDED = 2_000_000
#: The work of one product.
PRODUCT = 50

Monomial = tuple[int, ...]
Parts = Mapping[Monomial, fmpq]


class Named(Record):
    """What is known under names, and what may be used of it.

    ``squares`` are values of the kind ``("square", term)``.
    """

    claims: Mapping[str, Claim]
    squares: tuple[Value, ...]
    is_negative: Callable[[Term], bool]


class Product(Record):
    """A product of facts, which is >= 0, or > 0 if strict; its value has the factors."""

    factors: tuple[Value, ...]
    polynomial: fmpq_mpoly
    strict: bool


def by_names(claim: Claim, known: Named, budget: WorkBudget) -> Sum | None:
    """A sum that proves the claim from the facts that are named; None if none is found.

    Raises:
        SpentError: when the work is spent.
        TooLongError: if the terms are too long to be expanded.
    """
    for using in dict.fromkeys((_replacing(known), ())):
        found = _Attempt(claim, known, using, budget).found()
        if found is not None:
            return found
    return None


def _replacing(known: Named) -> tuple[str, ...]:
    """Equations that replace their left sides, which are atoms, and in no circle."""
    atomic = {
        name: c for name, c in known.claims.items() if c.relation == "=" and c.lhs.op in ATOMS
    }
    replaced: dict[Term, Term] = {}
    found: list[str] = []
    for name, c in atomic.items():
        if c.lhs not in replaced and c.lhs not in _parts_of((c.rhs,), replaced):
            replaced[c.lhs] = c.rhs
            found.append(name)
    return tuple(found)


def _sides(claims: Iterable[Claim], squares: Iterable[Value]) -> list[Any]:
    """The terms in claims and squares."""
    return [side for c in claims for side in (c.lhs, c.rhs)] + [value[1] for value in squares]


def _parts_of(terms: Iterable[Term], replaced: Mapping[Term, Term]) -> set[Term]:
    """All that is inside terms, and inside what some of it is replaced by."""

    def inside(term: Term) -> Iterable[Term]:
        return (replaced[term],) if term in replaced else term.children

    return {*inner_first(terms, inside)}


class _Attempt:
    """One way to look at the facts: some equations replace their left sides."""

    def __init__(
        self, claim: Claim, known: Named, using: tuple[str, ...], budget: WorkBudget
    ) -> None:
        self.claim, self.known, self.using, self.budget = claim, known, using, budget
        replaced = {known.claims[name].lhs: known.claims[name].rhs for name in using}
        terms = _sides((claim, *known.claims.values()), known.squares)
        self.clearing = Clearing(terms, replaced, known.is_negative, MAX_EXPANDED)
        self.goal = self.clearing.difference(claim.lhs, claim.rhs)
        self.equations: dict[str, fmpq_mpoly] = {}
        self.facts: list[Product] = []
        for name, c in known.claims.items():
            if c.relation != "=":
                self._add(name, self.clearing.difference(c.rhs, c.lhs), c.relation == "<")
            elif name not in using:
                polynomial = self.clearing.difference(c.lhs, c.rhs)
                if not polynomial.is_zero():
                    self.equations[name] = polynomial
        for value in known.squares:
            numerator, _ = self.clearing.clear(value[1])  # type: ignore[arg-type]
            self._add(value, numerator * numerator, strict=False)
        self.facts = self._relevant()

    def _relevant(self) -> list[Product]:
        """The facts with variables that are in the claim, or in others of them with such ones.

        The square of a root has those of its radicand.
        """
        within = {*variables_in(self.goal)}.union(*map(variables_in, self.equations.values()))
        left, count = self.facts, -1
        while count < len(within):
            count = len(within)
            for index in [i for i in within if self.clearing.atoms[i].op in ROOTS]:
                for part in self.clearing.clear(self.clearing.atoms[index].children[0]):
                    within |= {*variables_in(part)}
            for fact in left:
                variables = {*variables_in(fact.polynomial)}
                if within & variables:
                    within |= variables
        return [fact for fact in left if within.intersection(variables_in(fact.polynomial))]

    def _used(self, addends: tuple[Value, ...], cofactors: tuple[tuple[str, Term], ...]) -> Sum:
        """The sum, with the equations that replace what is in it."""
        names = {*_names_in(addends), *(name for name, _ in cofactors)}
        claims = [c for name, c in self.known.claims.items() if name in names]
        squares = [*_squares_in(addends), *(("square", term) for _, term in cofactors)]
        terms = _sides((self.claim, *claims), squares)
        present = _parts_of(terms, self.clearing.replaced)
        using = tuple(name for name in self.using if self.known.claims[name].lhs in present)
        return Sum(addends, using, cofactors)

    def _add(self, value: Value, polynomial: fmpq_mpoly, strict: bool) -> None:
        if not polynomial.is_constant():
            self.facts.append(Product((value,), polynomial, strict))

    def found(self) -> Sum | None:
        """The sum of products of the smallest degree."""
        if self.claim.relation == "=":
            (goal,) = self.clearing.reduced([self.goal])
            return self._used((), ()) if goal.is_zero() else self._identity()
        found = self._eliminated()
        if found is not None:
            return found
        for degree in range(MAX_DEGREE + 1):
            products = [*self._products(degree)]
            if len(products) > MAX_COLUMNS:
                return None
            found = self._sum(products)
            if found is not None:
                return found
        return None

    def _eliminated(self) -> Sum | None:
        """A sum that bounds one variable after the other, and ends with a polynomial on a box."""
        facts = [Fact(f.factors[0], f.polynomial, f.strict) for f in self.facts]
        found = Elimination(self.clearing, facts, self.budget).shown(-self.goal)
        if found is None or not (found.strict or self.claim.relation == "<="):
            return None
        goal = product_of(found.times, "goal")
        return self._used((goal,) if found.value is None else (goal, found.value), ())

    def _products(self, degree: int) -> Iterator[Product]:
        """Products of at most so many facts, with the negated claim at most twice."""
        goal = Product(("goal",), self.goal, self.claim.relation == "<=")
        for goals in range(min(degree, 2) + 1):
            for count in range(degree - goals + 1):
                for chosen in combinations_with_replacement(self.facts, count):
                    yield self._product((*(goal,) * goals, *chosen))

    def _product(self, factors: Sequence[Product]) -> Product:
        self.budget.spend(PRODUCT)
        polynomial = self.clearing.one
        for factor in factors:
            polynomial = polynomial * factor.polynomial
        values = tuple(value for factor in factors for value in factor.factors)
        strict = all(factor.strict for factor in factors)
        return Product(values, polynomial, strict)

    def _sum(self, products: list[Product]) -> Sum | None:
        plain = [product.polynomial for product in products]
        present = {m for p in (*plain, *self.clearing.reduced(plain)) for m in _parts(p)}
        multiples = [*self._multiples(present)]
        both = self.clearing.reduced([*plain, *(p for _, _, p in multiples)])
        every = [*map(_parts, both)]
        parts, free = every[: len(plain)], every[len(plain) :]
        kept = useful(parts, free)
        if not any(products[i].strict for i in kept):
            return None
        rows: dict[Monomial, int] = {}

        def column(part: Parts, *, strict: bool = False) -> dict[int, fmpq]:
            found = {rows.setdefault(m, len(rows) + 1): c for m, c in part.items()}
            return found | {0: fmpq(1)} if strict else found

        columns = [column(parts[i], strict=products[i].strict) for i in kept]
        others = [column(part) for part in free]
        if len(rows) > MAX_ROWS:
            return None
        found = solution(columns, others, {0: fmpq(1)}, self.budget)
        if found is None:
            return None
        weights, shares = found
        addends = tuple(
            product_of(str(fraction_of(weight)), *products[i].factors)
            for weight, i in zip(weights, kept, strict=True)
            if weight
        )
        return self._used(addends, self._cofactors(multiples, shares))

    def _multiples(
        self, present: Iterable[Monomial]
    ) -> Iterator[tuple[str, fmpq_mpoly, fmpq_mpoly]]:
        """Equations times the monomials that lead to monomials that there are."""
        wanted = sorted(present)
        count = 0
        for name, equation in self.equations.items():
            parts = _parts(equation)
            quotients = {
                quotient
                for monomial in wanted
                for part in parts
                if min(quotient := tuple(a - b for a, b in zip(monomial, part, strict=True))) >= 0
            }
            for quotient in sorted(quotients, key=lambda q: (sum(q), q)):
                count += 1
                if count > MAX_MULTIPLES:
                    return
                self.budget.spend(PRODUCT)
                cofactor = self.clearing.context.from_dict({quotient: fmpq(1)})
                yield name, cofactor, equation * cofactor

    def _cofactors(
        self, multiples: Sequence[tuple[str, fmpq_mpoly, fmpq_mpoly]], shares: Sequence[fmpq]
    ) -> tuple[tuple[str, Term], ...]:
        found: dict[str, fmpq_mpoly] = {}
        for (name, cofactor, _), share in zip(multiples, shares, strict=True):
            if share:
                found[name] = found.get(name, self.clearing.context.constant(0)) + share * cofactor
        return tuple((name, expanded(p, self.clearing.atoms)) for name, p in found.items())

    def _identity(self) -> Sum | None:
        """Multiples of equations that add up to the difference of the sides."""
        present = {*_parts(self.goal)}
        multiples: list[tuple[str, fmpq_mpoly, fmpq_mpoly]] = []
        for _ in range(3):
            multiples = [*self._multiples(present)]
            both = self.clearing.reduced([self.goal, *(p for _, _, p in multiples)])
            present |= {m for p in (*both, *(p for _, _, p in multiples)) for m in _parts(p)}
        goal, *others = map(_parts, both)
        rows: dict[Monomial, int] = {}

        def column(part: Parts) -> dict[int, fmpq]:
            return {rows.setdefault(m, len(rows)): c for m, c in part.items()}

        free = [column(part) for part in others]
        found = solution([], free, column(goal), self.budget)
        if found is None:
            return None
        return self._used((), self._cofactors(multiples, found[1]))


def _names_in(value: object) -> Iterator[str]:
    if isinstance(value, str):
        yield value
    elif isinstance(value, tuple):
        yield from (name for part in value for name in _names_in(part))


def _squares_in(value: object) -> Iterator[Value]:
    if isinstance(value, tuple):
        if value[:1] in (("square",), ("root",)):
            yield value
        else:
            yield from (found for part in value for found in _squares_in(part))


def _parts(polynomial: fmpq_mpoly) -> dict[Monomial, fmpq]:
    return {tuple(map(int, m)): c for m, c in polynomial.to_dict().items()}


def useful(columns: Sequence[Parts], free: Sequence[Parts]) -> list[int]:
    """The columns whose monomials can all be cancelled.

    A monomial that has one sign in all columns, and is in none that is free, cannot: the columns
    with it are left out, and then there may be more such monomials.
    """
    anywhere = {m for part in free for m in part}
    left = [*range(len(columns))]
    while True:
        signs: dict[Monomial, set[bool]] = {}
        for i in left:
            for m, c in columns[i].items():
                signs.setdefault(m, set()).add(c > 0)
        alone = {m for m, found in signs.items() if len(found) == 1 and m not in anywhere}
        if not alone:
            return left
        left = [i for i in left if alone.isdisjoint(columns[i])]
