"""Terms as quotients of polynomials in atoms, the way the checker clears them. Not trusted.

An atom is a name, a root, a minimum, a maximum, or another function. Names may be replaced by their
definitions. Polynomials are FLINT's, so that they can be divided and factored.
"""

from __future__ import annotations

import operator
from abc import ABC, abstractmethod
from collections.abc import Callable, Iterable, Iterator, Mapping, Sequence
from fractions import Fraction
from functools import cached_property
from math import comb

from flint import Ordering, fmpq, fmpq_mpoly, fmpq_mpoly_ctx

from verify.language.terms import FUNCTIONS, Claim, Term, as_term, in_tree
from verify.prover.balls import fmpq_of, fraction_of
from verify.prover.session import ZERO

Polynomial = fmpq_mpoly
Quotient = tuple[fmpq_mpoly, fmpq_mpoly]

#: Products of two monomials that expanding in one ring may take. The checker expands too: it counts
#: about a hundred units for each, and has six million for a file.
MAX_PRODUCTS = 20_000
#: Where the zero of a variable is moved, a power gets as many monomials, with long numbers.
MAX_DEGREE = 5000
#: A number of so many bits counts as one product more.
BITS = 200

ATOMS = ("symbol", "min", "max", "pi", "root", *FUNCTIONS)
ROOTS = ("sqrt", "root")


class TooLongError(ArithmeticError):
    """Expanding terms takes more products than are allowed, or leads to high degrees."""


def inner_first(terms: Iterable[Term], inside: Callable[[Term], Iterable[Term]]) -> list[Term]:
    """Terms and what is inside them, each once, and after what is inside it."""
    found: dict[Term, None] = {}

    def visit(term: Term) -> None:
        if term not in found:
            for part in inside(term):
                visit(part)
            found[term] = None

    for term in terms:
        visit(term)
    return [*found]


def through(definitions: Mapping[str, Term]) -> Callable[[Term], Iterable[Term]]:
    """What is inside a term, for `inner_first`: inside a name, its definition if it has one."""

    def inside(term: Term) -> Iterable[Term]:
        defined = term.op == "symbol" and term.name in definitions
        return (definitions[term.name],) if defined else term.children

    return inside


def atoms_of(terms: Iterable[Term], replaced: Mapping[Term, Term]) -> list[Term]:
    """The atoms of terms after replacing, each after those inside it."""

    def inside(term: Term) -> Iterable[Term]:
        return (replaced[term],) if term in replaced else term.children

    parts = inner_first(terms, inside)
    return [part for part in parts if part.op in ATOMS and part not in replaced]


def has_value(part: Term, is_fact: Callable[[Claim], bool]) -> bool:
    """Whether a quotient, root or logarithm has the fact that the checker needs; true of others.

    A divisor has to be positive, or its opposite; a radicand must not be negative; what a
    logarithm is of has to be positive.
    """
    if part.op not in ("div", "log", *ROOTS):
        return True
    number = part.children[-1]
    if number.op == "rational":
        value = number.value
        return bool(
            value != 0 if part.op == "div" else value > 0 or (value == 0 and part.op in ROOTS)
        )
    if is_fact(Claim("<", ZERO, number)) or part.op == "log":
        return is_fact(Claim("<", ZERO, number))
    return is_fact(Claim("<", ZERO, -number) if part.op == "div" else Claim("<=", ZERO, number))


def index_of(root: Term) -> int:
    """The index of a root; that of a square root is 2."""
    return root.exponent if root.op == "root" else 2


class Quotients(ABC):
    """Terms as quotients N/D of polynomials in one ring, put together as the checker does it."""

    def __init__(self) -> None:
        self._known: dict[Term, Quotient] = {}

    @abstractmethod
    def constant(self, value: Fraction) -> Polynomial:
        """A number as a polynomial of the ring."""

    @cached_property
    def one(self) -> Polynomial:
        """The number 1, always the same object."""
        return self.constant(Fraction(1))

    @abstractmethod
    def replacement(self, term: Term) -> Term | None:
        """What an equation replaces the term by, if one does."""

    @abstractmethod
    def atom(self, term: Term) -> Polynomial | None:
        """The polynomial of an atom; None for an operation."""

    def is_negative(self, _: Term) -> bool:
        """Whether the checker will know that this divisor is negative."""
        return False

    def clear(self, term: Term) -> Quotient:
        """Numerator and denominator of a term whose atoms are in the ring."""
        found = self._known.get(term)
        if found is None:
            found = self._known[term] = self._clear(term)
        return found

    def _clear(self, term: Term) -> Quotient:
        other = self.replacement(term)
        if other is not None:
            return self.clear(other)
        atom = self.atom(term)
        if atom is not None:
            return atom, self.one
        if term.op == "rational":
            return self.constant(term.value), self.one
        return self._combine(term)

    def _combine(self, term: Term) -> Quotient:
        (n, d), *others = map(self.clear, term.children)
        if term.op == "neg":
            return -n, d
        if term.op == "pow":
            return self.power(n, term.exponent), self.power(d, term.exponent)
        m, e = others[0]
        if term.op == "mul":
            return self.times(n, m), self.times(d, e)
        if term.op == "div":
            divisor = term.children[1]
            if divisor.op == "rational" and divisor.value != 0:
                return n * self.constant(1 / divisor.value), d
            if self.is_negative(divisor):
                n, m = -n, -m
            return self.times(n, e), self.times(d, m)
        if d is not e and d != e:
            n, m, d = self.times(n, e), self.times(m, d), self.times(d, e)
        return (n + m if term.op == "add" else n - m), d

    def difference(self, lhs: Term, rhs: Term) -> Polynomial:
        """N D' - N' D, which has the sign of lhs - rhs where both denominators are positive."""
        (n, d), (m, e) = self.clear(lhs), self.clear(rhs)
        return self.times(n, e) - self.times(m, d)

    def times(self, p: Polynomial, q: Polynomial) -> Polynomial:
        """The product; most denominators are 1, and cost nothing."""
        if q is self.one:
            return p
        return q if p is self.one else p * q

    def power(self, p: Polynomial, exponent: int) -> Polynomial:
        """The power, with a number that is not negative."""
        return p**exponent


class Clearing(Quotients):
    """Terms as quotients of polynomials in the atoms of some terms, or a TooLongError."""

    def __init__(
        self,
        terms: Iterable[Term],
        replaced: Mapping[Term, Term],
        is_negative: Callable[[Term], bool] | None = None,
        most: int = MAX_PRODUCTS,
    ) -> None:
        super().__init__()
        self.most = most
        self.replaced, self._is_negative = replaced, is_negative
        self.atoms = atoms_of(terms, replaced)
        names = tuple(f"x{i}" for i in range(len(self.atoms)))
        self.context = fmpq_mpoly_ctx.get(names, Ordering.lex)
        self.generators = dict(zip(self.atoms, self.context.gens(), strict=True))
        self.products = 0

    def times(self, p: Polynomial, q: Polynomial) -> Polynomial:
        """The product, counted."""
        self._count(len(p) * len(q))
        return super().times(p, q)

    def power(self, p: Polynomial, exponent: int) -> Polynomial:
        """The power, counted."""
        if int(p.total_degree()) * exponent > MAX_DEGREE:
            raise TooLongError
        bits = max((c.height_bits() for c in p.coeffs()), default=0)
        self._count(comb(len(p) + exponent - 1, exponent) if len(p) > 1 else 1)
        self._count(bits * exponent // BITS)
        return super().power(p, exponent)

    def _count(self, products: int) -> None:
        self.products += products
        if self.products > self.most:
            raise TooLongError

    def constant(self, value: Fraction) -> Polynomial:
        """A number as a polynomial in the atoms."""
        return self.context.constant(fmpq_of(value))

    def replacement(self, term: Term) -> Term | None:
        """What the term is replaced by, if it is."""
        return self.replaced.get(term)

    def is_negative(self, term: Term) -> bool:
        """True only if the caller has declared the divisor negative."""
        return self._is_negative is not None and self._is_negative(term)

    def atom(self, term: Term) -> Polynomial | None:
        """The generator of an atom."""
        return self.generators[term] if term.op in ATOMS else None

    def reduce(self, polynomial: Polynomial) -> Polynomial:
        """The polynomial, times denominators, after replacing squares of roots, latest first."""
        return self.reduced([polynomial])[0]

    def reduced(self, polynomials: Sequence[Polynomial]) -> list[Polynomial]:
        """The same of several polynomials, all times the same denominators."""
        found = [*polynomials]
        for index in reversed(range(len(self.atoms))):
            atom = self.atoms[index]
            if atom.op not in ROOTS:
                continue
            highest = max((int(p.degrees()[index]) for p in found if not p.is_zero()), default=0)
            times = highest // index_of(atom)
            if times:
                n, d = self.clear(atom.children[0])
                needless = d == self.one
                found = [
                    p
                    if needless and (p.is_zero() or p.degrees()[index] < index_of(atom))
                    else self._eliminate(p, index, (n, d), times)
                    for p in found
                ]
        return found

    def _eliminate(
        self, polynomial: Polynomial, index: int, radicand: Quotient, most: int
    ) -> Polynomial:
        n, d = radicand
        x, root_index = self.context.gens()[index], index_of(self.atoms[index])
        total = self.context.constant(0)
        for power, part in coefficients(polynomial, index).items():
            times, odd = divmod(power, root_index)
            scale = self.times(self.power(n, times), self.power(d, most - times))
            total += self.times(part * x**odd, scale)
        return total

    def term(self, polynomial: Polynomial) -> Term:
        """A polynomial as a term, expanded."""
        return expanded(polynomial, self.atoms)


def variables_in(polynomial: Polynomial) -> list[int]:
    """The variables that occur in a polynomial, by their places."""
    return [index for index, degree in enumerate(polynomial.degrees()) if int(degree) > 0]


def coefficients(polynomial: Polynomial, index: int) -> dict[int, Polynomial]:
    """The coefficient of each power of one variable, by the powers that occur, in order."""
    parts: dict[int, dict[tuple[int, ...], fmpq]] = {}
    for monomial, value in polynomial.to_dict().items():
        rest = (*monomial[:index], 0, *monomial[index + 1 :])
        parts.setdefault(int(monomial[index]), {})[rest] = value
    context = polynomial.context()
    return {power: context.from_dict(part) for power, part in sorted(parts.items())}


def expanded(polynomial: Polynomial, atoms: Sequence[Term]) -> Term:
    """A polynomial as a sum of products of atoms, one for each variable of its ring."""
    parts = [_monomial(m, value, atoms) for m, value in polynomial.to_dict().items()]
    return in_tree(parts, operator.add) if parts else as_term(0)


def _monomial(exponents: tuple[int, ...], value: fmpq, atoms: Sequence[Term]) -> Term:
    number = fraction_of(value)
    factors = [
        atom if exponent == 1 else atom ** int(exponent)
        for atom, exponent in zip(atoms, exponents, strict=True)
        if exponent
    ]
    if number != 1 or not factors:
        factors.insert(0, as_term(number))
    return in_tree(factors, operator.mul)


def divisors(term: Term) -> Iterator[Term]:
    """The divisors in a term that are no numbers, each as often as clearing multiplies by it."""
    found: dict[Term, None] = {}

    def visit(part: Term) -> None:
        if part.op == "div" and part.children[1].op != "rational":
            found[part.children[1]] = None
        for child in part.children:
            visit(child)

    visit(term)
    return iter(found)
