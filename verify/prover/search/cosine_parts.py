"""Claims with cosines on parts of an interval: by bounds around points near each part.

What is left of the claim is a polynomial in the only variable, with Bernstein coefficients that are
not negative on the part; on other parts enclosures decide.
"""

from __future__ import annotations

from collections.abc import Iterable, Sequence
from fractions import Fraction
from math import ceil, comb, floor

from verify.language.record import TYPE_CHECKING
from verify.language.terms import Term, symbol
from verify.prover.bernstein import coefficients, shift
from verify.prover.clearing import Polynomial
from verify.prover.goal import Bounds
from verify.prover.proof import Proof, Value
from verify.prover.rules import Cuts, Interval
from verify.prover.search.angles import HALF
from verify.prover.search.exact import ExactRanges

if TYPE_CHECKING:
    from verify.prover.search.cosine_bounds import CosineBounds

#: Numbers of terms of the series that are tried, of a lower bound; an upper one has one more.
LENGTHS = (2, 4, 8, 12)
MAX_DEPTH, MAX_LEAVES, MAX_TURNS = 12, 60, 6
MAX_ELEVATION = 3
#: Enclosures have to be so far from each other: other checkers round in other ways.
ROOM = Fraction(1, 2**60)
BITS = 128


class Parts:
    """Proofs of a claim that is linear in cosines, on parts of the interval of its variable."""

    def __init__(self, cosines: CosineBounds) -> None:
        self.cosines, self.goal = cosines, cosines.goal
        ((self.name, self.whole),) = self.goal.variables.items()
        atoms = cosines.linear.atoms
        self.index = next((i for i, atom in enumerate(atoms) if atom == symbol(self.name)), -1)
        self.domain = self.whole.ends or (Fraction(0), Fraction(0))
        self.exact = ExactRanges([self.name], self.goal.definitions, BITS)
        self.leaves = 0

    def proof(self) -> Proof | None:
        """Cuts of the interval, if all coefficients are polynomials in the variable."""
        polynomials = (self.cosines.constant, *self.cosines.parts.values())
        if self.index < 0 or not all(map(self._is_in_variable, polynomials)):
            return None
        if self.whole.interval is None:
            return None
        return self._cover(self.whole, 0)

    def _is_in_variable(self, p: Polynomial) -> bool:
        return all(d <= 0 or i == self.index for i, d in enumerate(p.degrees()))

    def numbers(self, p: Polynomial) -> list[Fraction]:
        """The coefficients of a polynomial in the variable."""
        found = {int(m[self.index]): Fraction(int(c.p), int(c.q)) for m, c in p.to_dict().items()}
        return [found.get(k, Fraction(0)) for k in range(max(found, default=0) + 1)]

    def _cover(self, bounds: Bounds, depth: int) -> Proof | None:
        low, high = bounds.ends or self.domain
        self.leaves += 1
        ranges = self.exact.of([(low, high)], self.goal.claim.lhs, self.goal.claim.rhs)
        if ranges is not None:
            (_, most), (least, _) = ranges
            if least - most > ROOM:
                return Interval(BITS, ((self.name, bounds.low_fact, bounds.high_fact),))
        for length in LENGTHS:
            found = self._leaf(bounds, length)
            if found is not None:
                return found
        if depth == MAX_DEPTH or self.leaves > MAX_LEAVES:
            return None
        cut, hypothesis = self._cut(low, high), f"@{depth + 1}"
        below = bounds._replace(high=cut, high_fact=hypothesis, high_relation="<=")
        above = bounds._replace(low=cut, low_fact=hypothesis, low_relation="<=")
        branches = []
        for part in (below, above):
            proof = self._cover(part, depth + 1)
            if proof is None:
                return None
            branches.append(proof)
        return Cuts(symbol(self.name), (cut,), tuple(branches))

    def _cut(self, low: Fraction, high: Fraction) -> Fraction:
        """The place nearest to the middle where an angle is a multiple of 1/2, or the middle."""
        middle, places = (low + high) / 2, []
        for cosine in self.cosines.parts:
            numbers = self.numbers(self.cosines.linear.angle(cosine))
            if len(numbers) != 2:
                continue
            step = HALF if cosine.op == "cos_pi" else Fraction(10**9)
            turns = (numbers[0] + numbers[1] * middle) / step
            places += [(k * step - numbers[0]) / numbers[1] for k in (floor(turns), ceil(turns))]
        inner = [place for place in places if low < place < high]
        return min(inner, key=lambda place: (abs(place - middle), place), default=middle)

    def _centres(self, cosine: Term, low: Fraction, high: Fraction) -> list[tuple[Fraction, int]]:
        """Where bounds may be developed, with the side on which the interval lies."""
        numbers = self.numbers(self.cosines.linear.angle(cosine))
        if cosine.op == "cos" or len(numbers) != 2:
            return [(Fraction(0), 1)]
        ends = sorted(numbers[0] + numbers[1] * x for x in (low, high))
        all_ends = sorted(numbers[0] + numbers[1] * x for x in self.domain)
        middle = (ends[0] + ends[1]) / 2
        found = [(Fraction(round(middle)), 1)]
        for centre in (floor(middle - HALF) + HALF, floor(middle + HALF) + HALF):
            if centre <= all_ends[0]:
                found.append((centre, 1))
            elif centre >= all_ends[1]:
                found.append((centre, -1))
        found.sort(key=lambda pair: abs(pair[0] - middle))
        return [pair for pair in found if abs(pair[0]) <= MAX_TURNS][:2]

    def _leaf(self, bounds: Bounds, length: int) -> Proof | None:
        """Bernstein coefficients of what is left, on a part."""
        low, high = bounds.ends or self.domain
        choices: list[tuple[Term, list[Fraction], list[tuple[Fraction, int]]]] = []
        for cosine, b in self.cosines.parts.items():
            basis = _basis(self.numbers(b), low, high)
            if basis is None:
                return None
            choices.append((cosine, basis, self._centres(cosine, low, high)))
        for pick in range(max((len(centres) for *_, centres in choices), default=0)):
            found = self._bounded(bounds, length, choices, pick)
            if found is not None:
                return found
        return None

    def _bounded(
        self,
        bounds: Bounds,
        length: int,
        choices: Iterable[tuple[Term, list[Fraction], list[tuple[Fraction, int]]]],
        pick: int,
    ) -> Proof | None:
        low, high = bounds.ends or self.domain
        used, rest = [], -self.cosines.constant
        for cosine, basis, centres in choices:
            if not centres:
                return None
            centre, sign = centres[min(pick, len(centres) - 1)]
            above = max(basis) > 0
            bound = self.cosines.bound(cosine, centre, sign, length, above)
            rest -= self.cosines.parts[cosine] * bound.polynomial
            used.append((cosine, bound, [abs(value) for value in basis]))
        strict = self.goal.claim.relation == "<"
        values = _positive(self.numbers(rest), bounds, strict=strict)
        if values is None:
            return None
        addends = []
        for cosine, bound, basis in used:
            name = self.cosines.fact(cosine, bound)
            if name is None:
                return None
            addends.append(("mul", name, _value(basis, bounds, high - low)))
        return self.cosines.sum([*addends, _value(values, bounds, high - low)])


def _basis(numbers: Sequence[Fraction], low: Fraction, high: Fraction) -> list[Fraction] | None:
    """Bernstein coefficients of one sign."""
    shifted = shift(numbers, low, high - low)
    for degree in range(len(numbers) - 1, len(numbers) + MAX_ELEVATION):
        values = coefficients(shifted, degree)
        if min(values) >= 0 or max(values) <= 0:
            return values
    return None


def _positive(
    numbers: Sequence[Fraction], bounds: Bounds, *, strict: bool
) -> list[Fraction] | None:
    """Bernstein coefficients that are >= 0, and show that a number is positive if it must be."""
    low, high = bounds.ends or (Fraction(0), Fraction(1))
    shifted = shift(numbers, low, high - low)
    for degree in range(len(shifted) - 1, len(shifted) + MAX_ELEVATION):
        values = coefficients(shifted, degree)
        if min(values) < 0:
            continue
        first = 0 if bounds.high_relation == "<" else degree
        last = degree if bounds.low_relation == "<" else 0
        if not strict or min(values) > 0 or any(values[first : last + 1]):
            return values
    return None


def _value(values: Sequence[Fraction], bounds: Bounds, width: Fraction) -> Value:
    """A polynomial with these Bernstein coefficients, as a sum of products of facts."""
    n, parts = len(values) - 1, list[Value]()
    smallest = min(values)
    if smallest > 0:  # a number is strict
        parts.append(str(smallest))
    for k, value in enumerate(values):
        if value > smallest:
            number = (value - smallest) * comb(n, k) / width**n
            powers = ((bounds.low_fact, k), (bounds.high_fact, n - k))
            factors = [("pow", fact, e) for fact, e in powers if e]
            parts.append(("mul", str(number), *factors))
    return ("add", *parts) if parts else "0"
