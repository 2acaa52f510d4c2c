"""Claims about functions of one term, such as cos(x + y) or sin(1/x), that has bounds itself.

The term gets a name u, and facts bound u. What is left is a claim about u and about variables that
have bounds; or about u alone, where u = 1/x for some number x > 0: a polynomial in x, divided by
its highest power, is one in u.
"""

from __future__ import annotations

from collections.abc import Iterator
from fractions import Fraction

from verify.language.fold import replaced
from verify.language.terms import Claim, Term, as_term, equal, names_of, parts_of, symbol
from verify.prover.balls import fraction_of
from verify.prover.clearing import Clearing, Polynomial, atoms_of, coefficients, expanded
from verify.prover.goal import Bounds
from verify.prover.proof import Proof, Value, power_of, product_of
from verify.prover.rules import Define, Monotony, Sum
from verify.prover.search.question import Question
from verify.prover.search.rising import EQUATED
from verify.prover.search.tree import Tree
from verify.prover.session import ZERO

#: A number, and the fact that it is a bound of the argument.
End = tuple[Fraction, str]

LEAVES = 300
#: The operations of an argument.
PLAIN = ("symbol", "rational", "add", "sub", "mul", "div", "neg", "pow")


def by_arguments(question: Question) -> Proof | None:
    """A tree in which the argument of all functions is a variable."""
    goal = question.goal
    functions = [*_functions(goal.claim)]
    arguments = {atom.children[0] for atom in functions}
    if goal.definitions or goal.claim.relation == "=" or len(arguments) != 1:
        return None
    (argument,) = arguments
    if argument.op == "symbol" or not all(part.op in PLAIN for part in parts_of(argument)):
        return None
    return Argument(question, argument, functions).proof()


def _functions(claim: Claim) -> Iterator[Term]:
    """The functions in a claim that move."""
    for atom in atoms_of((claim.lhs, claim.rhs), {}):
        if atom.op in EQUATED and next(names_of(atom), None) is not None:
            yield atom


class Argument:
    """One claim with functions of one term."""

    def __init__(self, question: Question, argument: Term, functions: list[Term]) -> None:
        self.question, self.argument, self.functions = question, argument, functions
        self.session, self.place = question.session, question.goal.context

    def proof(self) -> Proof | None:
        """A proof by a tree, if the argument has bounds."""
        ends = self._inverse_ends() or self._given_ends()
        if ends is None or self._tree("u", Bounds(ends[0][0], ends[1][0], "u", "u")) is None:
            return None
        if not self.question.known.clears((self.argument,), self.place):
            return None
        session, place, name = self.session, self.place, self.session.fresh()
        u = session.define(name, self.argument, Define(), place)
        (low, below), (high, above) = ends
        facts = [
            session.lemma(claim, Sum(("goal", fact), (name,)), place)
            for claim, fact in (
                (Claim("<=", as_term(low), u), below),
                (Claim("<=", u, as_term(high)), above),
            )
        ]
        found = self._tree(name, Bounds(low, high, *facts))
        if found is None:
            return None
        fact = session.lemma(*found, place)
        addends = self._addends(found[0], u, fact)
        same = session.known(equal(u, self.argument), place) or name
        equations = [
            session.lemma(equal(self._of(f, u), f), Monotony(same), place) for f in self.functions
        ]
        return None if addends is None else Sum(addends, (name, *equations))

    # --- the claim about the name ---------------------------------------------------------------

    def _of(self, function: Term, u: Term) -> Term:
        return Term(function.op, u, *function.args[1:])

    def _tree(self, name: str, bounds: Bounds) -> tuple[Claim, Proof] | None:
        """The claim about the name, and its proof."""
        goal, u = self.question.goal, symbol(name)
        chosen = {f: self._of(f, u) for f in self.functions}
        relation, lhs, rhs = goal.claim.key
        claim = Claim(relation, replaced(lhs, chosen), replaced(rhs, chosen))
        own = {*names_of(claim.lhs, claim.rhs)} - {name}
        rest = {n: b for n, b in goal.variables.items() if n in own}
        if not all(b.ends for b in rest.values()):
            term = self._divided(u, chosen)
            if term is None:
                return None
            claim, rest = Claim(relation, ZERO, term), {}
        proof = Tree(claim, {name: bounds} | rest, {}, self.question.budget).prove(LEAVES)
        return None if proof is None else (claim, proof)

    def _divided(self, u: Term, chosen: dict[Term, Term]) -> Term | None:
        """The difference of the sides, divided by a power of x, for u = 1/x."""
        clearing, claim = self.question.clearing, self.question.goal.claim
        if self.argument.op != "div" or self.argument.children[1] not in clearing.atoms:
            return None
        x = self.argument.children[1]
        if self.argument.children[0] != as_term(1) or x.op != "symbol":
            return None
        atoms = [chosen.get(atom, atom) for atom in clearing.atoms]
        p = clearing.difference(claim.rhs, claim.lhs)
        parts = coefficients(p, clearing.atoms.index(x))
        term = ZERO
        for power, part in parts.items():
            less = max(parts) - power
            term = term + (expanded(part, atoms) * u**less if less else expanded(part, atoms))
        return None if any(name != u.name for name in names_of(term)) else term

    def _addends(self, claim: Claim, u: Term, fact: str) -> tuple[Value, Value] | None:
        """The goal and the fact, both times what makes their sum 0."""
        _, lhs, rhs = self.question.goal.claim.key
        same = {self._of(f, u): f for f in self.functions} | {u: self.argument}
        sides = lhs, rhs, claim.lhs, claim.rhs
        clearing = Clearing(sides, same, self.question.is_negative)
        first, second = clearing.difference(rhs, lhs), clearing.difference(claim.rhs, claim.lhs)
        if first == second:
            return "goal", fact
        x = self.argument.children[1]
        positive = self.question.fact(Claim("<", ZERO, x))
        index = clearing.atoms.index(x)
        least = [min(coefficients(p, index)) for p in (first, second)]
        top, gen = max(least), clearing.context.gens()[index]
        first, second = (p * gen ** (top - k) for p, k in zip((first, second), least, strict=True))
        ratio = first.leading_coefficient() / second.leading_coefficient()
        if positive is None or ratio < 0 or first != ratio * second:
            return None
        powers = [power_of(positive, top - k) if top > k else "1" for k in least]
        return product_of("goal", powers[0]), product_of(str(ratio), fact, powers[1])

    # --- bounds of the argument -----------------------------------------------------------------

    def _inverse_ends(self) -> tuple[End, End] | None:
        """0 <= 1/x <= 1/a, where a <= x."""
        if self.argument.op != "div" or self.argument.children[1].op != "symbol":
            return None
        low = self.question.goal.variables[self.argument.children[1].name].low
        if low is None or low <= 0:
            return None
        number = 1 / low
        return self._ends(Fraction(0), number)

    def _given_ends(self) -> tuple[End, End] | None:
        """The numbers that givens say the argument is between."""
        low = high = None
        for claim in self.question.given.values():
            clearing = Clearing((claim.lhs, claim.rhs, self.argument), {})
            argument, below = clearing.clear(self.argument)
            p = clearing.difference(claim.rhs, claim.lhs)
            if below != clearing.one:
                return None
            if (p - argument).is_constant():
                low = -_number(p - argument) if low is None else max(low, -_number(p - argument))
            elif (p + argument).is_constant():
                high = _number(p + argument) if high is None else min(high, _number(p + argument))
        return None if low is None or high is None else self._ends(low, high)

    def _ends(self, low: Fraction, high: Fraction) -> tuple[End, End] | None:
        below = self.question.fact(Claim("<=", as_term(low), self.argument))
        above = self.question.fact(Claim("<=", self.argument, as_term(high)))
        return None if below is None or above is None else ((low, below), (high, above))


def _number(polynomial: Polynomial) -> Fraction:
    return Fraction(0) if polynomial.is_zero() else fraction_of(polynomial.leading_coefficient())
