"""Claims where equations hold.

*Normal form*: what is left of a claim after multiples of the equations are taken off has fewer
variables, or a lower degree. It is shown as a lemma, from givens of which the same multiples are
taken off.

*Squares*: a sum of squares in the ring of polynomials modulo the ideal of the equations, such as
those on a circle. What it differs by in the whole ring is a sum of multiples of the equations.

*Powers*: an equation of degree k says something about the k-th power of R rather than about R, in a
claim c <= R about a number c > 0. For a b c = 1 it is (a + b + c)^3 >= 27 a b c that squares show.
With R >= 0 and c^k <= R^k,

    (c - R)(c^(k-1) + c^(k-2) R + ... + R^(k-1)) + R^k - c^k = 0.
"""

from __future__ import annotations

from collections.abc import Iterator, Mapping
from functools import reduce
from itertools import combinations
from operator import add

from flint import fmpq_mpoly

from verify.language.terms import Claim, Term, as_term
from verify.prover.clearing import Clearing, atoms_of, expanded
from verify.prover.proof import Proof, Value
from verify.prover.rules import Sum
from verify.prover.search.bases import Gradings, all_monomials
from verify.prover.search.domain import Domain, Factor, multiplied
from verify.prover.search.faces import Block
from verify.prover.search.ideal import Cofactors, Ideal
from verify.prover.search.positive import Attempt, is_small, written
from verify.prover.search.question import MAX_FACTS, Question
from verify.prover.search.squares import Summand, decompose
from verify.prover.search.system import System
from verify.prover.session import ZERO

#: Facts that are shorter than this are rewritten too.
MAX_TERMS = 60
#: Higher powers than these are not tried.
MAX_POWER = 4


def by_normal_form(question: Question) -> Proof | None:
    """The claim without what the equations replace."""
    system = System(question)
    if not system.equations:
        return None
    ideal = Ideal(system.equations, question.budget)
    rest, taken = ideal.normal_form(system.goal.polynomial)
    if question.goal.claim.relation == "=":
        return None if not rest.is_zero() else _sum(system, (), taken, sign=1)
    if not taken:
        return None
    _rewrite(system, ideal)
    question.known.ranged.discard(question.goal.context)
    value = question.lemma(question.goal.claim.relation, -rest, expanded(-rest, system.atoms))
    return None if value is None else _sum(system, ("goal", value), taken, sign=-1)


def _rewrite(system: System, ideal: Ideal) -> None:
    """Afterwards inequalities without what the equations replace are known, too."""
    question = system.question
    for fact in system.facts:
        if not isinstance(fact.value, str) or fact.value in system.enclosures | system.ranges:
            continue
        rest, taken = ideal.normal_form(fact.polynomial)
        if not taken or rest.is_constant() or len(rest) > MAX_TERMS:
            continue
        claim = Claim("<" if fact.strict else "<=", ZERO, expanded(rest, system.atoms))
        place = question.goal.context
        if question.session.known(claim, place) is None:
            proof = _sum(system, ("goal", fact.value), taken, sign=-1)
            question.known.rows.add(question.session.lemma(claim, proof, place))


def _sum(system: System, addends: tuple[Value, ...], taken: Cofactors, *, sign: int) -> Sum:
    """Values, and multiples of equations."""
    equations = tuple((name, expanded(sign * p, system.atoms)) for name, p in taken.items())
    return Sum(addends, system.using, equations)


# --- sums of squares ------------------------------------------------------------------------------


class Variety(Domain):
    """The domain of a claim on which equations hold."""

    def __init__(self, question: Question, facts: Mapping[str, Claim]) -> None:
        self.ideal: Ideal | None = None
        equations = question.equations
        super().__init__(question.goal, {**facts, **equations}, None, question.is_negative)
        self.facts = {name: f for name, f in self.facts.items() if name not in equations}
        found = {name: self._difference(claim) for name, claim in equations.items()}
        self.equations = {name: p for name, p in found.items() if not p.is_zero()}
        self.whole = self.p
        self.ideal = Ideal(self.equations, question.budget)
        self.p = self.reduced(self.p)

    def _difference(self, claim: Claim) -> fmpq_mpoly:
        return self.reduced(self.scaled(self.clearing.difference(claim.lhs, claim.rhs)))

    def reduced(self, polynomial: fmpq_mpoly) -> fmpq_mpoly:
        """A polynomial without squares of roots, and without what the equations replace."""
        found = super().reduced(polynomial)
        return found if self.ideal is None else self.ideal.normal_form(found)[0]

    def basis(self, degree: int) -> tuple[fmpq_mpoly, ...]:
        """The monomials of at most this degree that no equation replaces."""
        every = all_monomials(self, degree, range(len(self.atoms)))
        leading = [tuple(map(int, m.monoms()[0])) for m in every]
        ideal = self.ideal
        return tuple(
            m
            for m, exponents in zip(every, leading, strict=True)
            if ideal is None or not ideal.has_multiple(exponents)
        )


def squares_on_equations(question: Question) -> Proof | None:
    """A sum of squares times facts, with multiples of equations."""
    if not question.equations:
        return None
    facts = dict([*question.facts.items()][:MAX_FACTS])
    domain = Variety(question, facts)
    if not domain.is_plain or domain.p.is_zero() or not domain.equations:
        return None
    for attempt in _attempts(domain):
        polynomials = [factor.polynomial for factor in attempt.factors]
        every = [*polynomials, *domain.equations.values()]
        gradings = Gradings(domain.p, every, domain.squares)
        blocks = [part for block in attempt.blocks for part in gradings.split(block)]
        if is_small(blocks):
            terms = decompose(domain.p, domain, polynomials, blocks, question.budget)
            proof = None if terms is None else _proof(question, domain, attempt, terms)
            if proof is not None:
                return proof
    return None


def _attempts(domain: Variety) -> Iterator[Attempt]:
    """Facts, then products of two, with squares of higher and higher degree."""
    one = Factor(domain.number(1), "1", True, ())
    facts = [*domain.facts.values()]
    pairs = [multiplied(a, b) for a, b in combinations(facts, 2)]
    goal = Factor(-domain.whole, domain.goal, not domain.strict, (domain.whole,))
    again = [goal, *(multiplied(goal, f) for f in (*facts, goal))]
    top = max(2, int(domain.p.total_degree()))
    top += top % 2
    for higher in (top, top + 2):
        for factors in ([one, *facts], [one, *facts, *pairs], [one, *facts, *again]):
            halves = [(higher - int(f.polynomial.total_degree())) // 2 for f in factors]
            blocks = [Block(i, domain.basis(h)) for i, h in enumerate(halves) if h >= 0]
            yield Attempt(factors, blocks)


def _proof(
    question: Question, domain: Variety, attempt: Attempt, terms: list[Summand]
) -> Proof | None:
    """The sum with what it differs by in the whole ring."""
    found = written(domain, attempt, terms, None)
    if found is None or domain.ideal is None:
        return None
    difference = -domain.whole
    for weight, index, square in terms:
        factor = attempt.factors[index].polynomial
        difference += domain.number(weight) * factor * square * square
    rest, taken = domain.ideal.normal_form(Domain.reduced(domain, difference))
    if not rest.is_zero():
        return None
    equations = tuple((name, domain.term(-cofactor)) for name, cofactor in taken.items())
    return Sum(found.addends, question.using, equations)


# --- powers of both sides ------------------------------------------------------------------------


def by_whole_powers(question: Question) -> Proof | None:
    """A proof by the powers whose exponents are the degrees of the equations."""
    claim, parts = question.plain.claim, question.clearing
    number, other = claim.lhs, claim.rhs
    if number.op != "rational" or number.value <= 0 or not question.equations:
        return None
    if any(atom.op != "symbol" for atom in atoms_of((other,), {})):
        return None
    cleared, divisor = parts.clear(other)
    if divisor != parts.one or cleared.is_constant():
        return None
    least = question.fact(Claim("<=", ZERO, other))
    if least is None:
        return None
    c = number.value
    for power, left, equations in _powers(question, int(cleared.total_degree())):
        fact = question.fact(Claim(claim.relation, as_term(c**power) * left, other**power))
        if fact is not None:
            terms: list[Value] = [str(c ** (power - 1))]
            terms += [
                ("mul", str(c ** (power - 1 - i)), ("pow", least, i)) for i in range(1, power)
            ]
            scaled = tuple((name, as_term(c**power) * term) for name, term in equations)
            return Sum((("mul", "goal", ("add", *terms)), fact), question.using, scaled)
    return None


def _powers(
    question: Question, degree: int
) -> Iterator[tuple[int, Term, tuple[tuple[str, Term], ...]]]:
    """Exponents k, with a term that is 1 by an equation, and by which multiple of it.

    For an equation e = b about a number b > 0 the term is a power of e/b of the degree of R^k.
    """
    for name, equation in question.equations.items():
        sides = equation.lhs, equation.rhs
        k = int(Clearing(sides, {}).difference(*sides).total_degree())
        if not 2 <= k <= MAX_POWER:
            continue
        turned = equation.lhs.op == "rational"
        e, b = (equation.rhs, equation.lhs) if turned else (equation.lhs, equation.rhs)
        if b.op == "rational" and b.value > 0:
            unit = e / b if b.value != 1 else e
            total = reduce(add, (unit**i for i in range(1, degree)), as_term(1))
            yield k, unit**degree, ((name, -total / b if turned else total / b),)
        else:
            yield k, as_term(1), ()
