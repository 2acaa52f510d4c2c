"""Equations between polynomials: what is left of a polynomial, and which multiples were taken off.

A Gröbner basis of the equations is found by Buchberger's algorithm; each element remembers how it
is made of them. Only small bases are of use, as the checker multiplies everything out again.
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from itertools import combinations

from flint import fmpq, fmpq_mpoly

from verify.language.record import Record
from verify.prover.budget import WorkBudget

#: Bases with more elements, from more pairs, or with longer polynomials, are given up.
MAX_ELEMENTS = 16
MAX_PAIRS = 60
MAX_TERMS = 150
MAX_DEGREE = 12
#: The work of one step of a division, for each term.
STEP = 2

Exponents = tuple[int, ...]
Cofactors = dict[str, fmpq_mpoly]


class Element(Record):
    """A polynomial of the ideal, and the multiples of equations that add up to it."""

    polynomial: fmpq_mpoly
    cofactors: Cofactors
    leading: Exponents


class Ideal:
    """The polynomials that are 0 because equations hold; ``equations`` has their differences."""

    def __init__(self, equations: Mapping[str, fmpq_mpoly], budget: WorkBudget) -> None:
        self.equations, self.budget = equations, budget
        self.elements: list[Element] = []
        for name, polynomial in equations.items():
            self._add(polynomial, {name: polynomial.context().constant(1)})
        self._complete()

    def normal_form(self, polynomial: fmpq_mpoly) -> tuple[fmpq_mpoly, Cofactors]:
        """What is left, and how often each equation was taken off."""
        zero = polynomial.context().constant(0)
        rest, left, taken = zero, polynomial, dict.fromkeys(self.equations, zero)
        while not left.is_zero():
            leading, value = _leading(left)
            self.budget.spend(STEP * len(left))
            element = next((e for e in self.elements if _divides(e.leading, leading)), None)
            if element is None:
                term = left.context().from_dict({leading: value})
                rest, left = rest + term, left - term
                continue
            top = element.polynomial.leading_coefficient()
            factor = left.context().from_dict({_minus(leading, element.leading): value / top})
            left -= factor * element.polynomial
            for name, cofactor in element.cofactors.items():
                taken[name] += factor * cofactor
            if len(left) > MAX_TERMS * 4:
                return polynomial, {}
        return rest, {name: cofactor for name, cofactor in taken.items() if not cofactor.is_zero()}

    def has_multiple(self, exponents: Exponents) -> bool:
        """Whether a monomial is a multiple of a leading one."""
        return any(_divides(element.leading, exponents) for element in self.elements)

    def _add(self, polynomial: fmpq_mpoly, cofactors: Cofactors) -> None:
        rest, taken = self.normal_form(polynomial)
        if rest.is_zero() or len(rest) > MAX_TERMS or int(rest.total_degree()) > MAX_DEGREE:
            return
        zero = polynomial.context().constant(0)
        names = [*dict.fromkeys((*cofactors, *taken))]
        made = {name: cofactors.get(name, zero) - taken.get(name, zero) for name in names}
        self.elements.append(Element(rest, made, _leading(rest)[0]))

    def _complete(self) -> None:
        """Add what pairs of elements leave, if that is not too much."""
        waiting = [*combinations(range(len(self.elements)), 2)]
        for _ in range(MAX_PAIRS):
            if not waiting or len(self.elements) >= MAX_ELEMENTS:
                return
            first, second = (self.elements[i] for i in waiting.pop(0))
            if not any(a and b for a, b in zip(first.leading, second.leading, strict=True)):
                continue
            before = len(self.elements)
            self._add(*_difference(first, second))
            if len(self.elements) > before:
                waiting += [(i, before) for i in range(before)]


def _difference(first: Element, second: Element) -> tuple[fmpq_mpoly, Cofactors]:
    """The multiples of two elements in which the leading terms cancel."""
    common = tuple(map(max, first.leading, second.leading))
    total, made = first.polynomial.context().constant(0), Cofactors()
    for element, sign in ((first, 1), (second, -1)):
        value = sign / element.polynomial.leading_coefficient()
        factor = total.context().from_dict({_minus(common, element.leading): fmpq(value)})
        total += factor * element.polynomial
        for name, cofactor in element.cofactors.items():
            made[name] = made.get(name, total.context().constant(0)) + factor * cofactor
    return total, made


def _leading(polynomial: fmpq_mpoly) -> tuple[Exponents, fmpq]:
    return tuple(map(int, polynomial.monoms()[0])), polynomial.leading_coefficient()


def _divides(a: Sequence[int], b: Sequence[int]) -> bool:
    return all(x <= y for x, y in zip(a, b, strict=True))


def _minus(a: Exponents, b: Exponents) -> Exponents:
    return tuple(x - y for x, y in zip(a, b, strict=True))
