"""Facts bound one variable after the other, until a polynomial on a box is left.

A fact such as `z <= b` replaces z by its bound in a polynomial that decreases in z: what it was
before is what it is then, plus the fact times a quotient. Both have to be at least 0, which other
facts show in the same way. What is left has variables between two numbers, or on one side of one:
its coefficients in the basis of Bernstein, or in powers of the distance, show the rest.
"""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from math import prod

from flint import Ordering, fmpq, fmpq_mpoly, fmpq_mpoly_ctx

from verify.language.record import Record
from verify.prover.balls import fraction_of
from verify.prover.budget import WorkBudget
from verify.prover.clearing import ROOTS, Clearing, coefficients, index_of, variables_in
from verify.prover.proof import Value, power_of, product_of, sum_of

#: Polynomials that are looked at for one claim, one inside the other, and their monomials.
MAX_STEPS, MAX_DEPTH, MAX_MONOMIALS = 200, 8, 6000
#: Polynomials with more monomials are not factored.
MAX_FACTORED = 300
#: A degree in each variable of the box is raised by at most so much.
MAX_ELEVATION = 3
#: The work for a monomial.
MONOMIAL = 20


class Fact(Record):
    """A polynomial that is >= 0, or > 0 if strict, by the value that says so."""

    value: Value
    polynomial: fmpq_mpoly
    strict: bool


class Bound(Record):
    """A fact of one variable: it is a positive multiple of the distance from a number."""

    value: Value
    number: fmpq
    scale: fmpq
    strict: bool


class Shown(Record):
    """A polynomial times a number > 0 is a number >= 0, or > 0 if strict; None is 0."""

    times: Value
    value: Value | None
    strict: bool


class Elimination:
    """Shows that polynomials are positive from facts, in the ring of a clearing."""

    def __init__(self, clearing: Clearing, facts: Sequence[Fact], budget: WorkBudget) -> None:
        self.clearing, self.budget, self.steps = clearing, budget, 0
        self.depth = 0
        self.lower: dict[int, Bound] = {}
        self.upper: dict[int, Bound] = {}
        self.choices = [*self._choices([fact for fact in facts if not self._bounds(fact)])]
        self._seen: dict[tuple[object, ...], Shown | None] = {}

    def _bounds(self, fact: Fact) -> bool:
        """Whether a fact bounds one variable by a number; then it is remembered."""
        indices = variables_in(fact.polynomial)
        if len(indices) != 1 or fact.polynomial.total_degree() != 1:
            return False
        (index,) = indices
        parts = coefficients(fact.polynomial, index)
        slope = _number(parts[1])
        number = -_number(parts[0]) / slope if 0 in parts else fmpq(0)
        table, sign = (self.lower, 1) if slope > 0 else (self.upper, -1)
        known = table.get(index)
        if known is None or (number - known.number) * sign > 0:
            table[index] = Bound(fact.value, number, slope * sign, fact.strict)
        return True

    def shown(self, polynomial: fmpq_mpoly) -> Shown | None:
        """Why a polynomial is >= 0 where the facts hold; None if nothing is found."""
        key = (tuple(polynomial.monoms()), tuple(polynomial.coeffs()))
        if key not in self._seen:
            self._seen[key] = None
            self.depth += 1
            self._seen[key] = self._shown(polynomial)
            self.depth -= 1
        return self._seen[key]

    def _shown(self, polynomial: fmpq_mpoly) -> Shown | None:
        self.steps += 1
        if self.steps > MAX_STEPS or self.depth > MAX_DEPTH or len(polynomial) > MAX_MONOMIALS:
            return None
        self.budget.spend(MONOMIAL * (len(polynomial) + 1))
        if polynomial.is_zero():
            return Shown("1", None, strict=False)
        reduced, times = self._reduced(polynomial)
        if reduced is None:
            return None
        found = self._on_box(reduced) or self._by_factors(reduced)
        found = found or self._by_root(reduced) or self._by_facts(reduced)
        return found and found._replace(times=product_of(*times, found.times))

    def _reduced(self, polynomial: fmpq_mpoly) -> tuple[fmpq_mpoly | None, tuple[Value, ...]]:
        """The polynomial without squares of roots, and the denominators that multiply it."""
        times: list[Value] = []
        for index, atom in reversed([*enumerate(self.clearing.atoms)]):
            if atom.op not in ROOTS or polynomial.is_zero():
                continue
            power = int(polynomial.degrees()[index]) // index_of(atom)
            _, d = self.clearing.clear(atom.children[0])
            if power and d != self.clearing.one:
                positive = self._positive(d)
                if positive is None:
                    return None, ()
                times.append(power_of(positive, power))
        return self.clearing.reduced([polynomial])[0], tuple(times)

    def _positive(self, polynomial: fmpq_mpoly) -> Value | None:
        """The value of a polynomial that is > 0 on the box, if it is."""
        found = self._on_box(polynomial)
        return found.value if found is not None and found.strict else None

    # --- on a box -------------------------------------------------------------------------------

    def _on_box(self, polynomial: fmpq_mpoly) -> Shown | None:
        """Coefficients that are >= 0, of products of distances from bounds."""
        indices = variables_in(polynomial)
        if any(i not in self.lower and i not in self.upper for i in indices):
            return None
        boxed = [i for i in indices if i in self.lower and i in self.upper]
        for more in range(MAX_ELEVATION + 1 if boxed else 1):
            found = self._in_distances(polynomial, indices, more)
            self.budget.spend(MONOMIAL * len(found))
            parts = {tuple(map(int, m)): c for m, c in found.to_dict().items()}
            if all(c > 0 for c in parts.values()):
                return self._value(parts, len(self.clearing.atoms))
            if more == 0 and any(c < 0 and self._is_corner(m, boxed) for m, c in parts.items()):
                return None  # no degree changes the values at corners
        return None

    def _is_corner(self, monomial: tuple[int, ...], boxed: Sequence[int]) -> bool:
        count = len(self.clearing.atoms)
        return all(not (monomial[i] and monomial[count + i]) for i in boxed) and not any(
            monomial[i] + monomial[count + i] for i in range(count) if i not in boxed
        )

    def _in_distances(
        self, polynomial: fmpq_mpoly, indices: Sequence[int], more: int
    ) -> fmpq_mpoly:
        """The polynomial in the distances from lower, and after these from upper bounds."""
        count = len(self.clearing.atoms)
        names = tuple(f"x{i}" for i in range(2 * count))
        ring = fmpq_mpoly_ctx.get(names, Ordering.lex)
        gens = ring.gens()
        found = ring.from_dict({(*m, *(0,) * count): c for m, c in polynomial.to_dict().items()})
        for i in indices:
            low, high = self.lower.get(i), self.upper.get(i)
            parts = coefficients(found, i)
            if low and high:
                width = high.number - low.number
                degree = max(parts) + more
                one = (gens[i] + gens[count + i]) * (1 / width)
                x = (gens[i] * high.number + gens[count + i] * low.number) * (1 / width)
                found = sum((c * x**k * one ** (degree - k) for k, c in parts.items()), one * 0)
            else:
                x = gens[i] + low.number if low else -gens[count + i]
                x = x + high.number if high else x
                found = sum((c * x**k for k, c in parts.items()), x * 0)
        return found

    def _value(self, parts: dict[tuple[int, ...], fmpq], count: int) -> Shown:
        """A sum of products of bounds, with the common factors in front."""
        bounds = [table.get(i) for table in (self.lower, self.upper) for i in range(count)]
        common = tuple(map(min, zip(*parts, strict=True))) or (0,) * (2 * count)
        addends, strict = [], False
        for monomial, number in parts.items():
            used = [b for b, e in zip(bounds, monomial, strict=True) if e and b is not None]
            strict = strict or all(b.strict for b in used)
            scaled = prod(
                (1 / b.scale**e for b, e in zip(bounds, monomial, strict=True) if e and b),
                start=number,
            )
            rest = tuple(e - c for e, c in zip(monomial, common, strict=True))
            factor = product_of(str(fraction_of(scaled)), *_powers(bounds, rest))
            addends.append(factor)
        return Shown("1", product_of(*_powers(bounds, common), sum_of(*addends)), strict)

    # --- factors, roots and facts ---------------------------------------------------------------

    def _by_factors(self, polynomial: fmpq_mpoly) -> Shown | None:
        """Factors that are >= 0, or the opposites of two of which are, and squares of others."""
        if len(polynomial) > MAX_FACTORED:
            return None
        number, factors = polynomial.factor()
        if len(factors) == 1 and factors[0][1] == 1:
            return None
        positive, strict = number > 0, True
        times: list[Value] = []
        values: list[Value] = [str(fraction_of(abs(number)))]
        by_size = sorted(factors, key=lambda pair: (pair[1] % 2, len(pair[0])))
        for place, (factor, power) in enumerate(by_size, 1):
            exponent = int(power)
            found, turned = self._signed(factor, either=place < len(factors), positive=positive)
            if found is None and exponent % 2 == 0:
                value: Value = ("square", self.clearing.term(factor ** (exponent // 2)))
                values, strict = [*values, value], False
                continue
            if found is None or found.value is None:
                return None
            positive = positive is not (turned and exponent % 2 == 1)
            times += [found.times] * exponent
            values.append(power_of(found.value, exponent))
            strict = strict and found.strict
        return Shown(product_of(*times), product_of(*values), strict) if positive else None

    def _signed(
        self, factor: fmpq_mpoly, *, either: bool, positive: bool
    ) -> tuple[Shown | None, bool]:
        """A factor or its opposite, and which; the last one has the sign that is wanted."""
        found = self.shown(factor) if either or positive else None
        if found is not None:
            return found, False
        return (self.shown(-factor), True) if either or not positive else (None, False)

    def _by_root(self, polynomial: fmpq_mpoly) -> Shown | None:
        """The difference a - b*root is positive if its product with a + b*root is."""
        for index in variables_in(polynomial):
            atom = self.clearing.atoms[index]
            if atom.op not in ROOTS or index_of(atom) != 2 or index not in self.lower:
                continue
            parts = coefficients(polynomial, index)
            other = parts.get(0, polynomial * 0) - parts[1] * self.clearing.context.gens()[index]
            first = self._positive(other)
            if first is None:
                continue
            found = self.shown(polynomial * other)
            if found is not None:
                return found._replace(times=product_of(found.times, first))
        return None

    def _by_facts(self, polynomial: fmpq_mpoly) -> Shown | None:
        """A fact that is linear in a variable replaces it by its bound."""
        present = {*variables_in(polynomial)}
        for fact, index in self.choices:
            if index in present:
                found = self._by_fact(polynomial, fact, index)
                if found is not None:
                    return found
        return None

    def _choices(self, facts: Sequence[Fact]) -> Iterator[tuple[Fact, int]]:
        """Facts with variables that they may replace: those first that no numbers bound."""
        for fact in facts:
            degrees = fact.polynomial.degrees()
            linear = [i for i in variables_in(fact.polynomial) if int(degrees[i]) == 1]
            free = [i for i in linear if i not in self.lower or i not in self.upper]
            sizes = {i: len(coefficients(fact.polynomial, i)[1]) for i in free or linear}
            yield from ((fact, i) for i in sorted(sizes, key=lambda i: sizes[i]))

    def _by_fact(self, polynomial: fmpq_mpoly, fact: Fact, index: int) -> Shown | None:
        """With f = a*z + b, and s = a or -a that is > 0: s^k*p = f*q + r, without z in r."""
        parts = coefficients(fact.polynomial, index)
        slope, rest = parts[1], parts.get(0, fact.polynomial * 0)
        powers = coefficients(polynomial, index)
        degree = max(powers)
        for sign in (1, -1):
            scale = self._positive(slope * sign)
            if scale is None:
                continue
            bound = -rest * sign
            left = sum(
                (c * bound**k * (slope * sign) ** (degree - k) for k, c in powers.items()),
                polynomial * 0,
            )
            quotient, remainder = divmod(
                polynomial * (slope * sign) ** degree - left, fact.polynomial
            )
            if not remainder.is_zero():
                continue
            found = self._both(fact, quotient, left)
            if found is not None:
                return found._replace(times=product_of(*[scale] * degree, found.times))
        return None

    def _both(self, fact: Fact, quotient: fmpq_mpoly, left: fmpq_mpoly) -> Shown | None:
        first = self.shown(quotient)
        if first is None:
            return None
        second = self.shown(left)
        if second is None:
            return None
        addends = []
        if first.value is not None:
            addends.append(product_of(second.times, fact.value, first.value))
        if second.value is not None:
            addends.append(product_of(first.times, second.value))
        strict = (fact.strict and first.strict) or second.strict
        value = sum_of(*addends) if addends else None
        return Shown(product_of(first.times, second.times), value, strict)


def _number(polynomial: fmpq_mpoly) -> fmpq:
    (value,) = polynomial.coeffs()
    return fmpq(value)


def _powers(bounds: Sequence[Bound | None], monomial: Sequence[int]) -> Iterator[Value]:
    for bound, exponent in zip(bounds, monomial, strict=True):
        if exponent and bound is not None:
            yield power_of(bound.value, exponent)
