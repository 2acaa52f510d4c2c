"""Identities between terms, decided by expansion.

A term is read as a quotient of polynomials, with integer coefficients, in its symbols and in one
atom for each square root (and each min, max or cosine, which stay opaque). The square of a root's
atom is replaced by its argument. What is left of ``lhs - rhs`` is zero only if the two sides agree
wherever both are defined.
"""

from __future__ import annotations

from functools import cache

from verify.language.terms import Term

Monomial = tuple[tuple[int, int], ...]
Polynomial = dict[Monomial, int]
Quotient = tuple[Polynomial, Polynomial]

_ONE: Polynomial = {(): 1}

#: Beyond this many terms an expansion is given up; the identities of the paper need a few dozen.
LIMIT = 4000


class TooLargeError(ArithmeticError):
    """An expansion has more terms than the limit."""


@cache
def is_identity(lhs: Term, rhs: Term) -> bool:
    """True only if lhs = rhs wherever both are defined; False says nothing."""
    if lhs == rhs:
        return True
    atoms = _Atoms()
    try:
        a, b = atoms.quotient(lhs), atoms.quotient(rhs)
        return not atoms.reduce(_sum(_product(a[0], b[1]), _product(b[0], a[1]), -1))
    except TooLargeError:
        return False


class _Atoms:
    """Symbols, square roots and opaque terms, numbered in order of appearance."""

    def __init__(self) -> None:
        self._numbers: dict[Term, int] = {}
        self._squares: dict[int, Quotient] = {}
        self._known: dict[Term, Quotient] = {}

    def quotient(self, term: Term) -> Quotient:
        found = self._known.get(term)
        if found is None:
            found = self._known[term] = self._read(term)
        return found

    def _read(self, term: Term) -> Quotient:
        if term.op == "rational":
            value = term.value
            numerator: Polynomial = {(): value.numerator} if value else {}
            return numerator, _ONE if value.denominator == 1 else {(): value.denominator}
        if term.op == "sqrt":
            square = self.quotient(term.children[0])
            atom = self._number(term)
            self._squares[atom] = square
            return {((atom, 1),): 1}, _ONE
        if term.op in ("symbol", "min", "max", "cos", "cos_pi"):
            return {((self._number(term), 1),): 1}, _ONE
        return self._combine(term)

    def _combine(self, term: Term) -> Quotient:
        (num, den), *others = (self.quotient(child) for child in term.children)
        if term.op == "neg":
            return _sum({}, num, -1), den
        if term.op == "pow":
            base = num, den
            for _ in range(term.exponent - 1):
                num, den = _product(num, base[0]), _product(den, base[1])
            return num, den
        num_2, den_2 = others[0]
        if term.op == "mul":
            return _product(num, num_2), _product(den, den_2)
        if term.op == "div":
            return _product(num, den_2), _product(den, num_2)
        sign = 1 if term.op == "add" else -1
        return _sum(_product(num, den_2), _product(num_2, den), sign), _product(den, den_2)

    def _number(self, term: Term) -> int:
        return self._numbers.setdefault(term, len(self._numbers))

    def reduce(self, polynomial: Polynomial) -> Polynomial:
        """Replace even powers of roots, the outermost first; multiplies by denominators."""
        for atom in sorted(self._squares, reverse=True):
            polynomial = self._eliminate(polynomial, atom)
        return polynomial

    def _eliminate(self, polynomial: Polynomial, atom: int) -> Polynomial:
        parts: dict[int, Polynomial] = {}
        for monomial, coefficient in polynomial.items():
            power = dict(monomial).get(atom, 0)
            odd = ((atom, 1),) if power % 2 else ()
            rest = tuple(sorted(tuple(f for f in monomial if f[0] != atom) + odd))
            parts.setdefault(power // 2, {})[rest] = coefficient
        num, den = self._squares[atom]
        top = max(parts, default=0)
        total: Polynomial = {}
        for power, part in parts.items():
            for factor in [num] * power + [den] * (top - power):
                part = _product(part, factor)
            total = _sum(total, part, 1)
        return total


def _sum(a: Polynomial, b: Polynomial, sign: int) -> Polynomial:
    total = dict(a)
    for monomial, coefficient in b.items():
        value = total.get(monomial, 0) + sign * coefficient
        if value:
            total[monomial] = value
        else:
            del total[monomial]
    return total


def _product(a: Polynomial, b: Polynomial) -> Polynomial:
    if a is _ONE or b is _ONE:
        return b if a is _ONE else a
    if len(a) * len(b) > LIMIT:
        raise TooLargeError
    total: Polynomial = {}
    for monomial_a, coefficient_a in a.items():
        for monomial_b, coefficient_b in b.items():
            powers = dict(monomial_a)
            for atom, power in monomial_b:
                powers[atom] = powers.get(atom, 0) + power
            monomial = tuple(sorted(powers.items()))
            total[monomial] = total.get(monomial, 0) + coefficient_a * coefficient_b
    return {monomial: value for monomial, value in total.items() if value}
