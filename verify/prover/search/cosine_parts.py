"""Claims with cosines on parts of an interval: by bounds around points near each part.

What is left of the claim is a polynomial in the only variable, with Bernstein coefficients that are
not negative on the part; on other parts enclosures decide.
"""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from fractions import Fraction
from math import ceil, floor

from verify.language.record import Record
from verify.language.terms import Claim, Term, symbol
from verify.prover.balls import fraction_of
from verify.prover.bernstein import ANY, Side, Tensor
from verify.prover.clearing import Polynomial
from verify.prover.cosines import HALF
from verify.prover.goal import Bounds
from verify.prover.proof import Proof, Value, every, product_of, sum_of
from verify.prover.rules import Cuts, Interval, Sum
from verify.prover.search.angles import Linear
from verify.prover.search.cosine_bounds import CosineBounds
from verify.prover.search.exact import ExactRanges
from verify.prover.search.levels import by_levels
from verify.prover.search.question import Question
from verify.prover.session import ZERO

#: Numbers of terms of the series that are tried, of a lower bound; an upper one has one more.
LENGTHS = (2, 4, 8, 12)
MAX_DEPTH, MAX_LEAVES, MAX_TURNS = 12, 60, 6
MAX_ELEVATION = 3
#: Enclosures have to be so far from each other: other checkers round in other ways.
ROOM = Fraction(1, 2**60)
BITS = 128


class Choice(Record):
    """A cosine, the coefficients of its factor, and where bounds of it may be developed."""

    cosine: Term
    tensor: Tensor
    centres: list[tuple[Fraction, int]]


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
        found = {int(m[self.index]): fraction_of(c) for m, c in p.to_dict().items()}
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
        branches = every(self._cover(part, depth + 1) for part in (below, above))
        return None if branches is None else Cuts(symbol(self.name), (cut,), branches)

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
        sides = self._sides(bounds)
        choices: list[Choice] = []
        for cosine, b in self.cosines.parts.items():
            tensors = (t for t in self._tensors(b, sides) if _has_sign(t))
            tensor = next(tensors, None)
            if tensor is None:
                return None
            choices.append(Choice(cosine, tensor, self._centres(cosine, *sides[self.index].ends)))
        for pick in range(max((len(choice.centres) for choice in choices), default=0)):
            found = self._bounded(sides, length, choices, pick)
            if found is not None:
                return found
        return None

    def _sides(self, bounds: Bounds) -> list[Side]:
        """A side for each atom, on none of which but the variable anything depends."""
        side = Side.of(bounds) or ANY
        return [side if i == self.index else ANY for i in range(len(self.cosines.linear.atoms))]

    def _tensors(self, p: Polynomial, sides: Sequence[Side]) -> Iterator[Tensor]:
        """The Bernstein coefficients of degrees that rise, divided by the scale of proofs."""
        tensor = Tensor.of(p, [side.ends for side in sides])
        for _ in range(MAX_ELEVATION + 1):
            yield tensor.scaled(1 / tensor.scale(sides))
            tensor = tensor.raised(self.index)

    def _bounded(
        self, sides: Sequence[Side], length: int, choices: Sequence[Choice], pick: int
    ) -> Proof | None:
        used, rest = [], -self.cosines.constant
        for choice in choices:
            if not choice.centres:
                return None
            centre, sign = choice.centres[min(pick, len(choice.centres) - 1)]
            above = max(choice.tensor.coefficients) > 0
            bound = self.cosines.bound(choice.cosine, centre, sign, length, above)
            rest -= self.cosines.parts[choice.cosine] * bound.polynomial
            used.append((choice.cosine, bound, choice.tensor.scaled(Fraction(1 if above else -1))))
        strict = self.goal.claim.relation == "<"
        found = (t.addends(sides, strict=strict) for t in self._tensors(rest, sides))
        values = next((v for v in found if v is not None), None)
        if values is None:
            return None
        addends: list[Value] = []
        for cosine, bound, tensor in used:
            name = self.cosines.fact(cosine, bound)
            weight = tensor.addends(sides, strict=False)
            if name is None or not weight:
                return None
            addends.append(product_of(name, sum_of(*weight)))
        return self.cosines.sum([*addends, *values])


def _has_sign(tensor: Tensor) -> bool:
    return min(tensor.coefficients) >= 0 or max(tensor.coefficients) <= 0


# --- what finds a proof --------------------------------------------------------------------------


def by_cosines(question: Question) -> Proof | None:
    """A proof of a claim that is linear in cosines, after products of them are replaced."""
    linear = Linear(question.goal, question.session, question.using)
    if not linear.is_plain:
        return None
    proof = linear.identity(question.goal.claim.relation)
    if proof is not None or question.goal.claim.relation == "=":
        return proof
    found = next(filter(None, _proofs(CosineBounds(question, linear))), None)
    return found or _by_linear_claim(question, linear)


def _by_linear_claim(question: Question, linear: Linear) -> Proof | None:
    """The claim with sums for products, if that has fewer cosines."""
    parts = {cosine: p for cosine, p in linear.parts.items() if not p.is_zero()}
    if not linear.equations or len(parts) >= len(linear.cosines):
        return None
    term: Term = ZERO
    for cosine, p in parts.items():
        part = linear.clearing.term(p)
        term = term + (part if cosine is None else part * cosine)
    fact = question.fact(Claim(question.goal.claim.relation, term, ZERO))
    if fact is None:
        return None
    return Sum(("goal", fact), tuple(linear.using), linear.cofactors(-1))


def _proofs(bounds: CosineBounds) -> Iterator[Proof | None]:
    """By factors, on parts of an interval, or on the whole domain; -1 and 1 come first."""
    yield by_levels(bounds)
    yield bounds.whole(1)
    if len(bounds.goal.variables) == 1 and bounds.goal.box:
        yield Parts(bounds).proof()
    for length in LENGTHS[:2]:
        yield bounds.whole(length)
