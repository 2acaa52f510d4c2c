"""Why a polynomial is positive: a sum of products of facts, found by algebra. Not trusted.

The variables are positive; some lie below a number; some are known only to be at most each of
several quotients (the entries of a minimum); squares of some are known. What is looked for is a
factor > 0 and a value, built from the names of facts, such that

    factor * polynomial = value

as polynomials, up to the relations for squares. It is found by looking at coefficients (those of
Bernstein for variables with an upper bound), by factoring, and by putting an entry in the place of
the variable that it bounds where the polynomial falls with it.
"""

from __future__ import annotations

import math
from collections.abc import Iterable, Iterator, Mapping, Sequence
from fractions import Fraction

from flint import Ordering, fmpq, fmpq_mpoly, fmpq_mpoly_ctx

from verify.language.record import Record
from verify.prover.bernstein import Forms
from verify.prover.clearing import coefficients
from verify.prover.numbers import float_of, fmpq_of, fraction_of
from verify.prover.proof import Value, power_of, product_of, sum_of

Polynomial = fmpq_mpoly

#: How many polynomials one search looks at, and how deep.
BUDGET = 3000
DEPTH = 14
SAMPLES = 60


class NotFoundError(ArithmeticError):
    """No sum was found."""


class EntryBound(Record):
    """The fact that numerator - x denominator >= 0, where the denominator is positive.

    With ``below`` it is the fact that x denominator - numerator >= 0.
    """

    fact: str
    numerator: Polynomial
    denominator: Polynomial
    below: bool = False


class Square(Record):
    """The relation x^2 denominator = numerator, with the value of the denominator."""

    numerator: Polynomial
    denominator: Polynomial
    value: Value


class Found(Record):
    """factor * polynomial = value >= 0; factors are values > 0, with their product."""

    value: Value
    strict: bool
    factors: tuple[Value, ...] = ()
    product: Polynomial | None = None


class Positivity:
    """A search in one ring.

    Args:
        names: the variables, each after those that bound it.
        positive: for each variable the fact that it is positive.
        below: for some a number and the fact that the number minus the variable is positive.
        numbers: estimates of variables that stand for numbers.
    """

    def __init__(
        self,
        names: Sequence[str],
        positive: Mapping[str, str],
        below: Mapping[str, tuple[Fraction, str]],
        numbers: Mapping[str, float] | None = None,
    ) -> None:
        self.names, self.numbers = tuple(names), numbers or {}
        self.ring = fmpq_mpoly_ctx.get(self.names, Ordering.lex)
        self.generators = dict(zip(self.names, self.ring.gens(), strict=True))
        self.positive, self.below = positive, below
        self.boxed = [self.names.index(name) for name in below]
        self.entries: dict[str, list[EntryBound]] = {}
        self.squares: dict[str, Square] = {}
        self.points: list[list[float]] = []
        self.left = BUDGET
        self._known: dict[str, Found | None] = {}
        self._bernstein = Forms([bound for bound, _ in below.values()])

    def constant(self, value: Fraction | int) -> Polynomial:
        """A number as a polynomial."""
        value = Fraction(value)
        return self.ring.constant(fmpq_of(value))

    # --- what is known --------------------------------------------------------------------------

    def bound(self, name: str, entries: Iterable[EntryBound]) -> None:
        """From now on a variable is known to be at most each entry."""
        self.entries[name] = list(entries)
        self._known.clear()
        self._sample()

    def bound_below(self, name: str, fact: str, numerator: Polynomial) -> None:
        """From now on a variable that has entries is known to be at least a polynomial."""
        self.entries[name].append(EntryBound(fact, numerator, self.constant(1), below=True))
        self._known.clear()
        self._sample()

    def relate(self, name: str, square: Square) -> None:
        """From now on the square of a variable is known."""
        self.squares[name] = square
        self._known.clear()
        self._sample()

    def _sample(self) -> None:
        """Points that satisfy all that is known, to see at once what cannot be positive."""
        chosen, self.points = _shares(), []
        for _ in range(SAMPLES):
            point = dict.fromkeys(self.names, 1.0)
            for name in self.names:
                point[name] = self._coordinate(name, point, chosen)
            self.points.append([point[name] for name in self.names])

    def _coordinate(self, name: str, point: dict[str, float], chosen: Iterator[float]) -> float:
        values = [point[other] for other in self.names]
        if name in self.numbers:
            return self.numbers[name]
        if name in self.squares:
            square = self.squares[name]
            return math.sqrt(_float(square.numerator, values) / _float(square.denominator, values))
        if name in self.entries:
            ends: dict[bool, list[float]] = {True: [0.0], False: []}
            for entry in self.entries[name]:
                end = _float(entry.numerator, values) / _float(entry.denominator, values)
                ends[entry.below].append(end)
            low, high = max(ends[True]), min(ends[False])
            return low + (high - low) * max(next(chosen), 2 * next(chosen) // 1)
        if name in self.below:
            top, share, tiny = float(self.below[name][0]), next(chosen), 10**-6 * next(chosen)
            return top * (share, tiny, 1 - tiny)[int(3 * next(chosen))]
        return math.pow(10, 8 * next(chosen) - 4)

    def may_be_positive(self, f: Polynomial) -> bool:
        """False if the polynomial is negative at a point that satisfies all that is known."""
        terms = _terms(f)
        for point in self.points:
            parts = _parts(terms, point)
            if sum(parts) < -1e-9 * sum(map(abs, parts)):
                return False
        return True

    # --- the search -----------------------------------------------------------------------------

    def find(self, f: Polynomial) -> Found:
        """Why the polynomial is > 0, or >= 0.

        Raises:
            NotFoundError: if it is not seen.
        """
        self.left = BUDGET
        return self._find(f, 0)

    def _find(self, f: Polynomial, depth: int) -> Found:
        reduced, factors, product = self._reduce(f)
        if reduced.is_zero():
            return Found("0", False, factors, product)
        key = str(reduced)
        if key not in self._known:
            self.left -= 1
            if depth > DEPTH or self.left < 0:
                raise NotFoundError("too many polynomials")
            self._known[key] = None
            self._known[key] = self._search(reduced, depth)
        found = self._known[key]
        if found is None:
            raise NotFoundError("seen before")
        return found._replace(
            factors=found.factors + factors, product=_times(found.product, product)
        )

    def _search(self, f: Polynomial, depth: int) -> Found:
        if not self.may_be_positive(f):
            raise NotFoundError("negative at a sample")
        value = self._coefficients(f)
        if value is not None:
            return Found(value, True)
        content, parts = f.factor()
        if len(parts) > 1 or parts[0][1] > 1:
            return self._product(fraction_of(content), parts, depth)
        part = parts[0][0] if content > 0 else -parts[0][0]
        if abs(content) != 1:
            found = self._find(part, depth + 1)
            return found._replace(value=product_of(str(abs(fraction_of(content))), found.value))
        for name in self.squares:
            if f.degrees()[self.names.index(name)] == 1:
                found_root = self._conjugate(f, name, depth)
                if found_root is not None:
                    return found_root
        return self._entry(f, depth)

    def _product(
        self, content: Fraction, parts: Sequence[tuple[Polynomial, int]], depth: int
    ) -> Found:
        sign, strict = 1 if content > 0 else -1, True
        values: list[Value] = [] if abs(content) == 1 else [str(abs(content))]
        factors: list[Value] = []
        product: Polynomial | None = None
        for part, exponent in parts:
            k = int(exponent)
            try:
                found = self._find(part, depth + 1)
            except NotFoundError:
                found = self._find(-part, depth + 1)
                sign = -sign if k % 2 else sign
            values.append(power_of(found.value, k))
            factors += found.factors * k
            for _ in range(k):
                product = _times(product, found.product)
            strict = strict and found.strict
        if sign < 0:
            raise NotFoundError("negative product")
        return Found(product_of(*values), strict, tuple(factors), product)

    def _conjugate(self, f: Polynomial, name: str, depth: int) -> Found | None:
        """For f = p + q x with p > 0 > q: (p - q x) f = p^2 - q^2 x^2."""
        x, q = self.generators[name], f.derivative(name)
        p = f - q * x
        try:
            other = self._find(p - q * x, depth + 1)
            if not other.strict or other.factors:
                return None
            found = self._find(f * (p - q * x), depth + 1)
        except NotFoundError:
            return None
        factors = (*found.factors, other.value)
        return found._replace(factors=factors, product=_times(found.product, p - q * x))

    def _entry(self, f: Polynomial, depth: int) -> Found:
        """Put an entry in the place of the last variable that has entries."""
        for name in reversed(self.names):
            index = self.names.index(name)
            degree = int(f.degrees()[index])
            if name in self.entries and degree:
                parts = self._by_degree(f, index, degree)
                for entry in self.entries[name]:
                    try:
                        return self._at_entry(name, parts, entry, depth)
                    except NotFoundError:
                        continue
                break
        raise NotFoundError("nothing left to try")

    def _at_entry(self, name: str, parts: list[Polynomial], entry: EntryBound, depth: int) -> Found:
        """D^k f(x) = D^k f(N/D) + (N - xD) Q, or + (xD - N) Q, where Q must be >= 0."""
        n, d, x = entry.numerator, entry.denominator, self.generators[name]
        degree = len(parts) - 1
        at_entry = slope = self.constant(0)
        sign = 1 if entry.below else -1
        for k, part in enumerate(parts):
            at_entry += part * n**k * d ** (degree - k)
            for j in range(k):
                slope += sign * part * d ** (degree - k) * n ** (k - 1 - j) * (x * d) ** j
        q, h, below = (self._find(g, depth + 1) for g in (slope, at_entry, d))
        if below.factors or not below.strict:
            raise NotFoundError("a denominator without a plain sign")
        values = [product_of(*h.factors, entry.fact, q.value)]
        if h.value != "0":
            values.append(product_of(*q.factors, h.value))
        scale = () if below.value == "1" else (below.value,) * degree
        factors = (*q.factors, *h.factors, *scale)
        product = _times(_times(q.product, h.product), d**degree)
        return Found(sum_of(*values), h.strict, factors, product)

    def _by_degree(self, f: Polynomial, index: int, degree: int) -> list[Polynomial]:
        parts = coefficients(f, index)
        return [parts.get(power, self.constant(0)) for power in range(degree + 1)]

    def _reduce(self, f: Polynomial) -> tuple[Polynomial, tuple[Value, ...], Polynomial | None]:
        """F times factors, with squares replaced."""
        factors: list[Value] = []
        product: Polynomial | None = None
        for name, square in self.squares.items():
            index = self.names.index(name)
            while (degree := int(f.degrees()[index])) > 1:
                x, top = self.generators[name], degree // 2
                total = self.constant(0)
                for k, part in enumerate(self._by_degree(f, index, degree)):
                    half, odd = divmod(k, 2)
                    scale = square.numerator**half * square.denominator ** (top - half)
                    total += part * x**odd * scale
                f = total
                if square.value != "1":
                    factors += [square.value] * top
                    product = _times(product, square.denominator**top)
        return f, tuple(factors), product

    # --- coefficients ---------------------------------------------------------------------------

    def _coefficients(self, f: Polynomial) -> Value | None:
        """A sum of monomials >= 0 that is the polynomial, in variables and their complements."""
        groups: dict[tuple[int, ...], dict[tuple[int, ...], fmpq]] = {}
        for monomial, value in f.to_dict().items():
            inner = tuple(int(monomial[i]) for i in self.boxed)
            outer = tuple(0 if i in self.boxed else int(e) for i, e in enumerate(monomial))
            groups.setdefault(outer, {})[inner] = value
        values = []
        for outer, group in groups.items():
            terms = self._bernstein.terms(group)
            if terms is None:
                return None
            values.append(product_of(*self._outer(outer), sum_of(*map(self._inner, terms))))
        return sum_of(*values)

    def _outer(self, monomial: tuple[int, ...]) -> Iterator[Value]:
        for name, exponent in zip(self.names, monomial, strict=True):
            if exponent:
                yield power_of(self.positive[name], exponent)

    def _inner(self, term: tuple[Fraction, tuple[tuple[int, int], ...]]) -> Value:
        number, exponents = term
        values: list[Value] = [] if number == 1 else [str(number)]
        for (name, (_, fact)), (low, high) in zip(self.below.items(), exponents, strict=True):
            values += [power_of(self.positive[name], low)] if low else []
            values += [power_of(fact, high)] if high else []
        return product_of(*values)


def _shares() -> Iterator[float]:
    """Numbers that fill ]0, 1[ evenly."""
    share = 0.5
    while True:
        yield share
        share = (share + 0.7548776662466927) % 1


def _terms(f: Polynomial) -> list[tuple[float, list[tuple[int, int]]]]:
    """The coefficients of a polynomial with the exponents that are not 0."""
    return [
        (float_of(value), [(i, int(k)) for i, k in enumerate(monomial) if k])
        for monomial, value in f.to_dict().items()
    ]


def _parts(terms: list[tuple[float, list[tuple[int, int]]]], point: Sequence[float]) -> list[float]:
    """The values of the monomials at a point."""
    parts = []
    for value, exponents in terms:
        for i, k in exponents:
            value *= point[i] ** k
        parts.append(value)
    return parts


def _float(f: Polynomial, point: Sequence[float]) -> float:
    return sum(_parts(_terms(f), point))


def _times(a: Polynomial | None, b: Polynomial | None) -> Polynomial | None:
    return b if a is None else a if b is None else a * b
