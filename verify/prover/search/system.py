"""What is known around a claim, as polynomials in one ring: inequalities, equations, the goal.

Everything that is known of the names in a claim is here, and of the names that occur in that, and
so on: bounds, givens, rows, what minima and maxima say of their entries, that roots are >= 0, and
numbers between which constants lie.
"""

from __future__ import annotations

from collections.abc import Iterable, Iterator

from flint import fmpq_mpoly

from verify.language.record import Record
from verify.language.terms import Claim, Term, symbol
from verify.prover.clearing import Clearing, atoms_of
from verify.prover.proof import Value
from verify.prover.search.direct import CIRCULAR, RANGES
from verify.prover.search.question import Question


class Fact(Record):
    """A polynomial that is >= 0, or > 0 if strict, and its value."""

    polynomial: fmpq_mpoly
    value: Value
    strict: bool


class System:
    """Facts, equations and the negated goal, as polynomials in the atoms of all of them.

    ``goal`` is > 0, or >= 0, if the claim fails.
    """

    def __init__(self, question: Question) -> None:
        self.question, self.using = question, question.using
        claims = dict(_inequalities(question))
        equations = question.equations
        claims |= dict(_entries(question, (*claims.values(), *equations.values())))
        claim = question.goal.claim
        replaced = {symbol(name): term for name, term in question.goal.definitions.items()}
        said = [claim, *claims.values(), *equations.values()]
        self.ranges = dict(_ranges(question, _sides(said), replaced))
        claims |= self.ranges
        terms = _sides((*said, *self.ranges.values()))
        self.enclosures = dict(_enclosures(question, atoms_of(terms, replaced)))
        self.clearing = Clearing(terms, replaced, question.is_negative)
        self.atoms = self.clearing.atoms
        self.context = self.clearing.context
        relation = claim.relation
        self.goal = Fact(self.difference(claim.lhs, claim.rhs), "goal", relation == "<=")
        self.facts = [
            Fact(self.difference(c.rhs, c.lhs), name, c.relation == "<")
            for name, c in (claims | self.enclosures).items()
        ]
        self.facts += [
            Fact(self.clearing.generators[atom], ("root", atom), False)
            for atom in self.atoms
            if atom.op == "sqrt"
        ]
        self.equations = {
            name: polynomial
            for name, c in equations.items()
            if not (polynomial := self.difference(c.lhs, c.rhs)).is_zero()
        }

    def difference(self, lhs: Term, rhs: Term) -> fmpq_mpoly:
        """The polynomial with the sign of lhs - rhs, without squares of roots."""
        return self.reduced(self.clearing.difference(lhs, rhs))

    def reduced(self, polynomial: fmpq_mpoly) -> fmpq_mpoly:
        """The polynomial without squares of roots, if all of them are of polynomials."""
        return self.clearing.reduce(polynomial) if self.is_plain else polynomial

    def named(self, value: Value) -> Value:
        """The value with the names of lemmas for ranges, which are written down now."""
        if isinstance(value, str):
            claim, range_of = self.enclosures.get(value), self.ranges.get(value)
            name = value if claim is None else self.question.known.ground.lemma(claim)
            name = name if range_of is None else self.question.fact(range_of)
            if name is None:
                raise ArithmeticError(f"{claim} was not shown by enclosures")
            return name
        if value[0] in ("add", "mul"):
            return (value[0], *map(self.named, value[1:]))  # type: ignore[arg-type]
        return (value[0], self.named(value[1]), value[2]) if value[0] == "pow" else value  # type: ignore[arg-type]

    @property
    def is_plain(self) -> bool:
        """Whether each root is one of a polynomial."""
        one = self.clearing.one
        roots = (atom for atom in self.atoms if atom.op == "sqrt")
        return all(self.clearing.clear(root.children[0])[1] == one for root in roots)


def _sides(claims: Iterable[Claim]) -> list[Term]:
    return [side for claim in claims for side in (claim.lhs, claim.rhs)]


def _ranges(
    question: Question, terms: Iterable[Term], replaced: dict[Term, Term]
) -> Iterator[tuple[str, Claim]]:
    """The ends of the values of functions of variables; under names for now."""
    for i, atom in enumerate(atoms_of(terms, replaced)):
        if atom.op in RANGES and not question.known.clears_as_number(atom):
            for is_above, end in RANGES[atom.op].items():
                relation = "<=" if atom.op in CIRCULAR else "<"
                sides = (atom, end) if is_above else (end, atom)
                yield f"{'end' if is_above else 'start'} {i}", Claim(relation, *sides)


def _inequalities(question: Question) -> Iterator[tuple[str, Claim]]:
    """Bounds of the variables, givens and rows that the checker can clear."""
    session = question.session
    for bounds in question.goal.variables.values():
        for name in (bounds.low_fact, bounds.high_fact):
            if name in session.claims and session.claims[name].relation != "=":
                yield name, session.claims[name]
    yield from question.given.items()
    for name in sorted(question.known.usable_rows):
        if question.is_usable(name, session.claims[name]):
            yield name, session.claims[name]


def _entries(question: Question, claims: Iterable[Claim]) -> Iterator[tuple[str, Claim]]:
    """What the minima and maxima in claims say of their entries."""
    sides = [side for claim in claims for side in (claim.lhs, claim.rhs)]
    goal = question.goal
    sides += [goal.claim.lhs, goal.claim.rhs, *goal.definitions.values()]
    for atom in atoms_of(sides, {}):
        if atom.op in ("min", "max"):
            for entry in atom.children:
                name = question.entry(atom, entry)
                if name is not None:
                    yield name, question.session.claims[name]


def _enclosures(question: Question, atoms: Iterable[Term]) -> Iterator[tuple[str, Claim]]:
    """Numbers between which roots and other functions of numbers lie; under names for now."""
    for atom in atoms:
        if question.known.clears_as_number(atom):
            for up in (False, True):
                number = question.known.ground.short_bound(atom, up=up)
                if number is not None:
                    sides = (atom, number) if up else (number, atom)
                    yield f"{'above' if up else 'below'} {atom}", Claim("<=", *sides)
