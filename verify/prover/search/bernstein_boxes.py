"""Polynomials in a few variables, by Bernstein coefficients on a box or on parts of it.

A part is cut where a zero is known, else in the middle. A claim about a maximum need only hold for
one entry of it on each part.
"""

from __future__ import annotations

from collections.abc import Sequence
from fractions import Fraction
from math import prod

from flint import fmpq, fmpq_mpoly

from verify.language.record import Record
from verify.language.terms import Term, symbol
from verify.prover.balls import fraction_of
from verify.prover.bernstein import ANY, Side, Tensor
from verify.prover.clearing import Clearing, coefficients
from verify.prover.goal import Goal
from verify.prover.proof import Proof, Value, every, product_of
from verify.prover.rules import Cuts, Sum
from verify.prover.search.question import Question
from verify.prover.search.system import System

#: More coefficients, or nested cuts, are not tried.
MAX_SIZE = 800
MAX_DEPTH = 40
#: A degree in one variable is at most this much larger than that of the polynomial.
MAX_ELEVATION = 40
#: What leaves may cost the checker, in its units, for each part that may be tried; and at most.
UNITS = 15_000
MAX_UNITS = 4_500_000


def on_interval(goal: Goal) -> Sum | None:
    """A proof for a polynomial in one variable between two numbers, of degrees that are raised.

    The divisors in the claim need their facts.
    """
    claim = goal.claim
    if claim.relation == "=" or goal.constants or len(goal.variables) != 1:
        return None
    ((name, bounds),) = goal.variables.items()
    replaced = {symbol(known): term for known, term in goal.definitions.items()}
    clearing = Clearing((claim.lhs, claim.rhs), replaced)
    side = Side.of(bounds)
    if side is None or clearing.atoms != [symbol(name)]:
        return None
    difference = clearing.difference(claim.rhs, claim.lhs)
    if difference.total_degree() >= MAX_SIZE:
        return None
    tensor = Tensor.of(difference, [side.ends])
    strict = claim.relation == "<"
    if _fails_at_an_end(tensor, side, strict=strict):
        return None  # no degree changes the values at the ends
    for _ in range(MAX_ELEVATION + 1):
        addends = tensor.addends([side], strict=strict)
        if addends is not None:
            first = product_of(str(tensor.scale([side])), "goal")
            return Sum((first, *addends), tuple(goal.definitions))
        tensor = tensor.raised(0)
    return None


def _fails_at_an_end(tensor: Tensor, side: Side, *, strict: bool) -> bool:
    """Whether a polynomial in one variable is < 0 at an end, or 0 at one where it has to be > 0."""
    values = zip(tensor.corners(), side.strict, strict=True)
    return any(value < 0 or (strict and value == 0 and not open_) for value, open_ in values)


class Alternative(Record):
    """A polynomial for which values, with which it adds up to 0, are >= 0 if the claim fails.

    One of the values or the polynomial has to be positive: the latter, if it is ``strict``.
    """

    polynomial: fmpq_mpoly
    values: tuple[Value, ...]
    strict: bool


class Part(Record):
    """A box, and the coefficients of each alternative that may be >= 0 on it."""

    sides: tuple[Side, ...]
    tensors: tuple[tuple[int, Tensor], ...]
    depth: int


def by_coefficients(question: Question) -> Proof | None:
    """The proof of `on_interval`, without the definitions of constants."""
    return on_interval(question.plain)


def by_bernstein(question: Question, parts: int) -> Proof | None:
    """A proof for a polynomial, or a quotient, in variables between numbers.

    So many ``parts`` are tried at most. On parts where a given fails nothing else has to be shown.
    """
    goal = question.goal
    system = System(question) if question.given else None
    clearing = question.clearing if system is None else system.clearing
    p = clearing.difference(goal.claim.rhs, goal.claim.lhs)
    found = _alternatives(question, clearing, p)
    if system is not None:
        found += _failing_givens(system, p)
    names = [atom.name if atom.op == "symbol" else "" for atom in clearing.atoms]
    sides = [Side.of(goal.variables.get(name)) for name in names]
    used = {i for a in found for i, d in enumerate(a.polynomial.degrees()) if d > 0}
    if not used or any(sides[i] is None for i in used):
        return None
    box = tuple(ANY if side is None else side for side in sides)
    tensors = []
    for i, alternative in enumerate(found):
        if prod(max(int(d), 0) + 1 for d in alternative.polynomial.degrees()) > MAX_SIZE:
            return None
        question.budget.spend(1000)
        tensors.append((i, Tensor.of(alternative.polynomial, [side.ends for side in box])))
    tensors.sort(key=lambda pair: len(pair[1].coefficients))
    points = [[zero.get(name, Fraction(0)) for name in names] for zero in question.simple_zeros]
    search = _Search(question, names, sorted(used), found, points)
    search.most = parts
    return search.cover(Part(box, tuple(tensors), 0))


def _alternatives(question: Question, clearing: Clearing, p: fmpq_mpoly) -> list[Alternative]:
    """For p = P + c m, where m is a maximum and c > 0 (or a minimum and c < 0), each P + c e."""
    extrema = [
        (i, atom)
        for i, (atom, degree) in enumerate(zip(clearing.atoms, p.degrees(), strict=True))
        if degree > 0 and atom.op in ("min", "max")
    ]
    strict = question.goal.claim.relation == "<"
    if not extrema:
        return [Alternative(p, ("goal",), strict)]
    index, term = extrema[-1]
    parts = coefficients(p, index)
    factor = parts.get(1)
    if len(extrema) > 1 or max(parts) > 1 or factor is None or not factor.is_constant():
        return []
    c = factor.leading_coefficient()
    if (c > 0) != (term.op == "max"):
        return []
    rest = parts.get(0, clearing.one - clearing.one)
    return [
        Alternative(rest + factor * n, ("goal", ("mul", str(fraction_of(abs(c))), fact)), strict)
        for entry, fact in _entries(question, term)
        for n, d in (clearing.clear(entry),)
        if d == clearing.one
    ]


def _failing_givens(system: System, p: fmpq_mpoly) -> list[Alternative]:
    """The opposites of what givens say is >= 0, as large as p."""
    found, largest = [], max((abs(c) for c in p.coeffs()), default=fmpq(1))
    variables = system.question.goal.variables
    for fact in system.facts:
        polynomial = -fact.polynomial
        used = [a for a, d in zip(system.atoms, polynomial.degrees(), strict=True) if d > 0]
        is_given = fact.value in system.question.given
        if (
            polynomial.is_zero()
            or not (is_given and used)
            or any(atom.op != "symbol" or not variables[atom.name].ends for atom in used)
        ):
            continue
        if prod(max(int(d), 0) + 1 for d in polynomial.degrees()) <= MAX_SIZE:
            size = largest / max(abs(c) for c in polynomial.coeffs())
            value = product_of(str(fraction_of(size)), fact.value)
            found.append(Alternative(size * polynomial, (value,), not fact.strict))
    return found


def _entries(question: Question, term: Term) -> list[tuple[Term, str]]:
    facts = [(entry, question.entry(term, entry)) for entry in term.children]
    return [(entry, fact) for entry, fact in facts if fact is not None]


class _Search:
    """A tree of cuts."""

    def __init__(
        self,
        question: Question,
        names: Sequence[str],
        used: Sequence[int],
        alternatives: Sequence[Alternative],
        zeros: Sequence[Sequence[Fraction]],
    ) -> None:
        self.names, self.used, self.zeros = names, used, zeros
        self.alternatives = alternatives
        self.budget, self.using = question.budget, question.using
        self.parts = self.units = self.most = 0

    def cover(self, part: Part) -> Proof | None:
        """A proof on a part."""
        proof = self._leaf(part)
        if proof is not None:
            return proof
        self.parts += 1
        if (
            self.parts > self.most
            or self.units > min(UNITS * self.most, MAX_UNITS)
            or part.depth >= MAX_DEPTH
        ):
            return None
        if self._fails(part):
            return None
        index, cut, halves = self._best(part)
        branches = every(map(self.cover, halves))
        return None if branches is None else Cuts(symbol(self.names[index]), (cut,), branches)

    @staticmethod
    def _fails(part: Part) -> bool:
        """Whether all alternatives are negative at a corner; False if there are many corners."""
        corners = [[*tensor.corners()] for _, tensor in part.tensors]
        return any(all(v < 0 for v in values) for values in zip(*corners, strict=True))

    def _best(self, part: Part) -> tuple[int, Fraction, tuple[Part, Part]]:
        """The cut after which the negative coefficients are smallest."""
        found = []
        for index in self.used:
            low, high = part.sides[index].ends
            cut = self._cut(part, index)
            halves = self._halves(part, index, cut)
            score = sum((_worst(half) for half in halves), fmpq(0)), high - low
            found.append((score, (index, cut, halves)))
        return max(found, key=lambda pair: pair[0])[1]

    def _cut(self, part: Part, index: int) -> Fraction:
        """The coordinate of a zero in the part, or its middle."""
        low, high = part.sides[index].ends
        for zero in self.zeros:
            inside = all(
                part.sides[i].ends[0] <= zero[i] <= part.sides[i].ends[1] for i in self.used
            )
            if inside and low < zero[index] < high:
                return zero[index]
        return (low + high) / 2

    def _halves(self, part: Part, index: int, cut: Fraction) -> tuple[Part, Part]:
        """The parts below and above a cut."""
        low, high = part.sides[index].ends
        sides = part.sides[index].cut(cut, f"@{part.depth + 1}")
        tensors: tuple[list[tuple[int, Tensor]], list[tuple[int, Tensor]]] = ([], [])
        for i, tensor in part.tensors:
            self.budget.spend(len(tensor.coefficients) * (1 + tensor.degrees[index]) // 2)
            for known, half in zip(
                tensors, tensor.halves(index, (cut - low) / (high - low)), strict=True
            ):
                known.append((i, half))
        return (
            _part(part, index, sides[0], tensors[0]),
            _part(part, index, sides[1], tensors[1]),
        )

    def _leaf(self, part: Part) -> Sum | None:
        """The sum for the first alternative without negative coefficients."""
        for i, tensor in part.tensors:
            alternative = self.alternatives[i]
            addends = tensor.addends(part.sides, strict=alternative.strict)
            if addends is not None:
                scale = tensor.scale(part.sides)
                self.units += tensor.units()
                scaled = (product_of(str(scale), value) for value in alternative.values)
                return Sum((*scaled, *addends), self.using)
        return None


def _part(part: Part, index: int, side: Side, tensors: list[tuple[int, Tensor]]) -> Part:
    """The part with another side; without alternatives that are negative everywhere on it."""
    kept = [(i, t) for i, t in tensors if max(t.coefficients) >= 0]
    sides = (*part.sides[:index], side, *part.sides[index + 1 :])
    return Part(sides, tuple(kept or tensors[:1]), part.depth + 1)


def _worst(part: Part) -> fmpq:
    """The least coefficient of the alternative for which it is largest, if that is negative."""
    return min(fmpq(0), max(min(tensor.coefficients) for _, tensor in part.tensors))
