"""Claims whose sides meet at an end of one variable's range, or that hold on an unbounded one.

What holds at a point holds beyond it, if the derivative of the difference has a sign there. That
is a claim of the same kind, and after some derivatives one about a quotient of polynomials, or one
that enclosures decide. Estimates guide; each premise has a proof.
"""

from __future__ import annotations

import math
from collections.abc import Callable, Iterator, Mapping
from fractions import Fraction
from functools import partial
from itertools import islice, pairwise, product
from operator import gt

from flint import fmpq_mpoly

from verify.language.statement import PROVED
from verify.language.terms import (
    Claim,
    Term,
    as_term,
    equal,
    log,
    names_of,
    parts_of,
    substitute_claim,
    symbol,
)
from verify.prover.balls import float_of, fmpq_of, fraction_of
from verify.prover.clearing import ROOTS, Clearing, TooLongError, coefficients, index_of
from verify.prover.goal import Bounds
from verify.prover.proof import Premise, Proof, Value, power_of, product_of, sum_of
from verify.prover.rules import Cuts, Derivative, Have, InRange, Interval, Law, Monotony, Sum
from verify.prover.search.bernstein_boxes import on_interval
from verify.prover.search.compiled import estimates
from verify.prover.search.derivatives import derivative
from verify.prover.search.direct import CIRCULAR, RANGES
from verify.prover.search.exact import ExactRanges
from verify.prover.search.question import Question
from verify.prover.search.tree import Tree
from verify.prover.session import ZERO

#: Derivatives and cuts inside one another, claims that are looked at in all, and those of them
#: that other techniques get.
MAX_DEPTH, MAX_CLAIMS, MAX_ALGEBRAIC = 30, 60, 3
#: With so much work first, where functions of numbers may be isolated as well.
UNITS_FOR_ALGEBRA = 500_000
#: Variables of a claim, of which one grows, and places of the others that estimates look at.
MAX_VARIABLES, PLACES = 3, 12
#: A claim may have so many different terms, each of which costs so many units of work.
MAX_PARTS, PRICE = 100, 1000
#: A numerator may have so many products of powers.
MAX_MONOMIALS = 40
#: Parts of a box that enclosures may take.
LEAVES = 100
#: Of the checker where the variable has a value.
BITS_AT_POINT = 64
#: A difference below this part of the sides may be rounding.
NOISE = 1e-11
#: Where both sides are far from equal if they meet at a point between.
NEAR_BY = 1 / 16
#: Where to cut a range: at the first of these that lies in it and where both sides meet.
_NUMERATORS = (0, 1, -1, 2, -2, 3, -3, 5, 10, 100)
SIMPLE = tuple(Fraction(n, d) for d in (1, 2, 3, 4, 10) for n in _NUMERATORS)
#: The relations of a claim at a point, of the point and the variable, and of 0 and the derivative.
AT_POINT = {("<", "start"): ("<", "<=", "<="), ("<", "slope"): ("<=", "<", "<")}
FUNCTIONS = ("exp", "log", "atan", "sin", "cos", "cos_pi")


def by_growth(question: Question) -> Proof | None:
    """A proof by signs of derivatives, for one variable of the context itself."""
    goal, known = question.plain, question.known
    if goal.context is None or goal.definitions or goal.constants:
        return None
    own = [variable.name for variable in known.contexts[goal.context].variables]
    names = [name for name in goal.variables if name in own]
    ops = {part.op for part in parts_of(goal.claim.lhs, goal.claim.rhs)}
    if not 1 <= len(goal.variables) <= MAX_VARIABLES or ops.isdisjoint(FUNCTIONS):
        return None
    if goal.claim.relation not in ("<", "<=") or goal.claim.lhs == ZERO == goal.claim.rhs:
        return None
    pairs = [{*names_of(g.claim.lhs, g.claim.rhs)} for g in known.contexts[goal.context].givens]
    names.sort(key=lambda name: not any(name in pair and len(pair) > 1 for pair in pairs))
    searches = [Growth(question, name, clears) for clears in (False, True) for name in names]
    found = (s.prove(goal.claim, goal.variables[s.name], (), MAX_DEPTH) for s in searches)
    proof = next(filter(None, found), None)
    if proof is None or not any(map(_is_turned, parts_of(goal.claim.lhs, goal.claim.rhs))):
        return proof
    return Have(goal.claim, (proof, Sum(("goal", "@1"))))


def _size(claim: Claim) -> int:
    return sum(1 for _ in parts_of(claim.lhs, claim.rhs))


def _has_divisor(claim: Claim) -> bool:
    parts = parts_of(claim.lhs, claim.rhs)
    return any(part.op == "div" and part.children[1].op != "rational" for part in parts)


def _is_turned(term: Term) -> bool:
    """Whether the claim may be another one than was asked for, with -a/-b in place of a/b."""
    return term.op == "div" and all(child.op == "neg" for child in term.children)


class Growth:
    """Proofs of claims about one variable, in branches with bounds of it.

    Args:
        question: the claim.
        name: the variable.
        clears: whether claims are multiplied with their divisors before derivatives are taken.
    """

    def __init__(self, question: Question, name: str, clears: bool) -> None:
        self.question, self.known, self.name = question, question.known, name
        self.goal, self.x = question.plain, symbol(name)
        self.context = self.goal.context or ""
        self.givens = [given.claim for given in self.known.contexts[self.context].givens]
        self.others = {n: b for n, b in self.goal.variables.items() if n != name}
        self.places = [*islice(_places(self.others), PLACES)]
        self.claims = self.algebraic = self.searches = 0
        self.clears = clears
        self.numerators: set[Claim] = set()  # without divisors

    def prove(
        self, claim: Claim, bounds: Bounds, cuts: tuple[Claim, ...], depth: int
    ) -> Proof | None:
        """A proof where the variable has these bounds, among them the hypotheses of cuts."""
        self.claims += 1
        size = _size(claim)
        self.question.budget.spend(PRICE * size)
        if depth <= 0 or self.claims > MAX_CLAIMS or size > MAX_PARTS:
            return None
        if self.goal.variables.keys().isdisjoint(names_of(claim.lhs, claim.rhs)):
            return self._ground(claim)
        if self.name not in names_of(claim.lhs, claim.rhs):
            return self._without(claim)
        gaps = [*self._gaps(claim, bounds)]
        if not gaps or min(gap for _, gap in gaps) < 0:
            return None
        if not self.known.clears((claim.lhs, claim.rhs), self.context):
            return None
        touches = min(gap for _, gap in gaps) < 1e-3
        found = self._simple(claim, bounds, cuts) or self._by_factors(claim, bounds)
        found = found or (None if touches else self._tree(claim, bounds, cuts))
        parts = [*parts_of(claim.lhs, claim.rhs)]
        is_algebraic = not any(map(self._moves, parts))
        if any(part.op in FUNCTIONS for part in parts):
            if is_algebraic:
                with self.question.budget.at_most(UNITS_FOR_ALGEBRA):
                    found = found or self._by_factors(claim, bounds, lemmas=True)
                    found = found or self._algebraic(claim)
            found = found or self._isolated(claim, bounds, cuts, depth)
            found = found or self._cleared(claim, bounds, cuts, depth)
            found = found or self._grown(claim, bounds, cuts, depth)
            found = found or self._divided(claim, bounds, cuts, depth)
        if is_algebraic:
            found = found or self._by_factors(claim, bounds, lemmas=True) or self._algebraic(claim)
        return found or self._cut(claim, bounds, cuts, depth)

    def _moves(self, part: Term) -> bool:
        """Whether this is a function of variables, and no number."""
        return part.op in FUNCTIONS and bool(self.goal.variables.keys() & {*names_of(part)})

    # --- estimates ------------------------------------------------------------------------------

    def _gaps(self, claim: Claim, bounds: Bounds) -> Iterator[tuple[float, float]]:
        """At points between the bounds, how far the sides are apart, as a part of their size.

        It is 0 where that may be rounding.
        """
        givens = self.givens if self.others else []
        terms = [side for c in (claim, *givens) for side in (c.lhs, c.rhs)]
        try:
            values = estimates([self.name, *self.others], terms, {})
        except KeyError:
            return
        for x, place in product(_points(bounds), self.places):
            try:
                low, high, *sides = values(x, *place)
                if any(map(gt, sides[::2], sides[1::2])):
                    continue
            except (ArithmeticError, ValueError, TypeError):
                continue
            size = abs(low) + abs(high)
            if isinstance(size, float) and math.isfinite(size):
                gap = high - low
                yield x, 0.0 if abs(gap) <= NOISE * (size + NOISE) else gap / (size + 1e-300)

    def _sign(self, term: Term, bounds: Bounds) -> int:
        """The sign that a term seems to have everywhere between the bounds; or 0."""
        gaps = [gap for _, gap in self._gaps(Claim("<=", ZERO, term), bounds)]
        if not gaps or min(gaps) < 0 < max(gaps):
            return 0
        return 1 if min(gaps) >= 0 else -1

    # --- proofs without derivatives -------------------------------------------------------------

    def _ground(self, claim: Claim) -> Proof | None:
        """A claim without the variable, perhaps one whose sides are equal, as exp 0 and 1 are."""
        ranges = ExactRanges((), self.known.ground.definitions, BITS_AT_POINT)
        found = ranges.of((), claim.lhs, claim.rhs)
        if found is not None:
            (_, low), (high, _) = found
            if low < high or (low == high and claim.relation == "<="):
                return Interval(BITS_AT_POINT)
        verdict, proof = self.known.ground.prove(claim)
        if verdict == PROVED:
            return proof
        return self.known.prove(self.known.goal(claim, None))

    def _without(self, claim: Claim) -> Proof | None:
        """A claim about the other variables alone, as a lemma."""
        if self.searches == MAX_ALGEBRAIC:
            return None
        self.searches += 1
        fact = self.question.fact(claim)
        return None if fact is None else Sum(("goal", fact))

    def _simple(self, claim: Claim, bounds: Bounds, cuts: tuple[Claim, ...]) -> Proof | None:
        """A quotient of polynomials, or what the range of a function shows."""
        claim = self.known.turned(claim, self.context)
        try:
            found = on_interval(self.goal._replace(claim=claim, variables=self._variables(bounds)))
            if found is not None:
                return found
            clearing = Clearing((claim.lhs, claim.rhs), {})
            difference = clearing.difference(claim.rhs, claim.lhs)
        except TooLongError:
            return None
        if clearing.atoms == [self.x]:
            return self._on_half_line(claim, bounds, difference)
        if any(atom.op in ROOTS for atom in clearing.atoms):
            from verify.prover.search.roots_of_variables import in_root  # only where it is used

            in_the_root = in_root(claim, self.x, bounds, clearing, difference, len(cuts))
            if in_the_root is not None:
                return in_the_root
        return self._by_range(claim, clearing, difference, f"@{len(cuts) + 1}")

    def _on_half_line(self, claim: Claim, bounds: Bounds, polynomial: fmpq_mpoly) -> Sum | None:
        """A polynomial whose coefficients around the one end are not negative."""
        is_above = bounds.low is not None
        end = bounds.low if is_above else bounds.high
        if end is None:
            return None
        fact = bounds.low_fact if is_above else bounds.high_fact
        ring = polynomial.context()
        shifted = ring.constant(fmpq_of(end)) + (ring.gen(0) if is_above else -ring.gen(0))
        moved = polynomial.compose(shifted)
        parts = {int(powers[0]): fraction_of(value) for powers, value in moved.to_dict().items()}
        if any(value < 0 for value in parts.values()):
            return None
        relation = bounds.low_relation if is_above else bounds.high_relation
        if claim.relation == "<" and not parts.get(0) and not (relation == "<" and parts):
            return None
        values = (
            product_of(str(value), power_of(fact, power)) if power else str(value)
            for power, value in parts.items()
        )
        return Sum(("goal", *values))

    def _by_range(
        self, claim: Claim, clearing: Clearing, difference: fmpq_mpoly, hypothesis: str
    ) -> Proof | None:
        """A function with numbers before and after it."""
        functions = [(i, atom) for i, atom in enumerate(clearing.atoms) if atom.op in RANGES]
        if len(functions) != 1:
            return None
        index, atom = functions[0]
        parts = {
            power: clearing.term(part) for power, part in coefficients(difference, index).items()
        }
        numbers = [parts.get(power, ZERO) for power in (0, 1)]
        if parts.keys() - {0, 1} or any(number.op != "rational" for number in numbers):
            return None
        rest, factor = (number.value for number in numbers)
        end = RANGES[atom.op].get(factor < 0, atom)
        if end.op != "rational" or factor == 0 or factor * end.value + rest < 0:
            return None
        relation = "<=" if atom.op in CIRCULAR else "<"
        left = factor * end.value + rest
        if claim.relation == "<" and left == 0 and relation == "<=":
            return None
        bound = Claim(relation, *((atom, end) if factor < 0 else (end, atom)))
        last = Sum(("goal", product_of(str(abs(factor)), hypothesis), str(left)))
        return Have(bound, (InRange(), last))

    def _algebraic(self, claim: Claim) -> Proof | None:
        """What other techniques find where it holds in the whole context."""
        if claim == self.goal.claim:
            return None  # they are tried on it already
        gaps = [gap for _, gap in self._gaps(claim, self.goal.variables[self.name])]
        self.algebraic += 1
        if not gaps or min(gaps) < 0 or self.algebraic > MAX_ALGEBRAIC:
            return None
        return self.known.prove(self.goal._replace(claim=claim))

    def _by_factors(self, claim: Claim, bounds: Bounds, *, lemmas: bool = False) -> Proof | None:
        """A product of factors whose signs bounds show, or lemmas."""
        is_negative = partial(self.known.is_negative, context=self.context)
        try:
            clearing = Clearing((claim.lhs, claim.rhs), {}, is_negative)
            difference = clearing.difference(claim.rhs, claim.lhs)
            number, factors = (
                self._in_root(clearing, difference) if lemmas else difference
            ).factor()
        except TooLongError:
            return None
        scale, values = fraction_of(number), list[Value]()
        for factor, power in factors:
            signed = self._signed(clearing, factor, bounds, claim.relation, lemmas=lemmas)
            if signed is not None:
                values.append(power_of(signed[0], power))
                scale *= signed[1] ** power
            elif power % 2 == 0 and claim.relation == "<=":
                values.append(power_of(("square", clearing.term(factor)), power // 2))
            else:
                return None
        return Sum(("goal", product_of(str(scale), *values))) if scale > 0 else None

    def _in_root(self, clearing: Clearing, polynomial: fmpq_mpoly) -> fmpq_mpoly:
        """The polynomial with a power of a root of the variable in its place."""
        roots = (a for a in clearing.atoms if a.op in ROOTS and a.children[0] == self.x)
        root = next(roots, None)
        if root is None or self.x not in clearing.atoms:
            return polynomial
        ways = [*clearing.context.gens()]
        ways[clearing.atoms.index(self.x)] = clearing.generators[root] ** index_of(root)
        return polynomial.compose(*ways, ctx=clearing.context)

    def _signed(
        self,
        clearing: Clearing,
        factor: fmpq_mpoly,
        bounds: Bounds,
        relation: str,
        *,
        lemmas: bool,
    ) -> tuple[Value, int] | None:
        """The value of a factor or, with the sign -1, of its opposite."""
        for sign in (1, -1):
            found = self._linear(clearing, factor * sign, bounds, relation)
            if found is not None:
                return found, sign
        for sign in (1, -1):
            claim = Claim(relation, ZERO, clearing.term(factor * sign))
            if lemmas and self._sign(claim.rhs, self.goal.variables[self.name]) == 1:
                name = self.question.fact(claim)
                return None if name is None else (name, sign)
        return None

    def _linear(
        self, clearing: Clearing, polynomial: fmpq_mpoly, bounds: Bounds, relation: str
    ) -> Value | None:
        """The value of a sum of multiples of variables, by their bounds, or of an exponential."""
        variables, addends = self._variables(bounds), list[Value]()
        least, is_strict = Fraction(0), False
        end: Fraction | None
        fact: Value | None
        for monomial, value in polynomial.to_dict().items():
            number, degree = fraction_of(value), sum(monomial)
            if degree == 0:
                least += number
                continue
            atom = clearing.atoms[[*monomial].index(1)] if degree == 1 else ZERO
            if atom.op in ("exp", *ROOTS) and number > 0:
                fact = self.known.fact(Claim("<", ZERO, atom), self.context)
                end, strict = Fraction(0), fact is not None
                fact = fact or (("root", atom) if atom.op in ROOTS else None)
            elif atom.op == "symbol" and atom.name in variables:
                low, high, low_fact, high_fact, *relations = variables[atom.name]
                end, fact = (low, low_fact) if number > 0 else (high, high_fact)
                strict = relations[number < 0] == "<"
            else:
                return None
            if end is None or fact is None:
                return None
            addends.append(product_of(str(abs(number)), fact))
            least, is_strict = least + number * end, is_strict or strict
        if least < 0 or (relation == "<" and least == 0 and not is_strict):
            return None
        return sum_of(*addends, *([str(least)] if least else [])) if addends else None

    def _tree(self, claim: Claim, bounds: Bounds, cuts: tuple[Claim, ...]) -> Proof | None:
        variables = self._variables(bounds)
        if any(b.ends is None for b in variables.values()):
            return None
        tree = Tree(claim, variables, {}, self.question.budget, hypotheses=len(cuts))
        return tree.prove(LEAVES)

    def _variables(self, bounds: Bounds) -> dict[str, Bounds]:
        """The bounds of all variables, with these of the one that grows."""
        return {self.name: bounds, **self.others}

    # --- isolating a function -------------------------------------------------------------------

    def _isolated(
        self, claim: Claim, bounds: Bounds, cuts: tuple[Claim, ...], depth: int
    ) -> Proof | None:
        """Divide by what stands before a logarithm, or take one of what bounds an exponential.

        The derivative has no such function any more.
        """
        try:
            clearing = Clearing((claim.lhs, claim.rhs), {})
            difference = clearing.difference(claim.rhs, claim.lhs)
        except TooLongError:
            return None
        atoms = [*enumerate(clearing.atoms)]
        functions = [(i, atom) for i, atom in atoms if atom.op in ("log", "atan", "exp")]
        if len(functions) != 1 or len(atoms) != 2 or functions[0][1] in (claim.lhs, claim.rhs):
            return None
        index, atom = functions[0]
        parts = coefficients(difference, index)
        if parts.keys() != {0, 1}:
            return None
        rest, factor = clearing.term(parts[0]), clearing.term(parts[1])
        sign = self._sign(factor, bounds)
        if sign == 0 or (factor.op == "rational" and atom.op != "exp"):
            return None
        if sign < 0:
            rest, factor = clearing.term(-parts[0]), clearing.term(-parts[1])
        bound = -rest / factor
        sides = (bound, atom) if sign > 0 else (atom, bound)
        isolated = Claim(claim.relation, *sides)
        if not self.known.clears(sides, self.context):
            return None
        prove = self._by_logarithm if atom.op == "exp" else self._grown
        proof = prove(isolated, bounds, cuts, depth - 1)
        scale = str(factor.value) if factor.op == "rational" else "1"
        last = Sum(("goal", product_of(scale, f"@{len(cuts) + 1}")))
        return None if proof is None else Have(isolated, (proof, last))

    def _by_logarithm(
        self, claim: Claim, bounds: Bounds, cuts: tuple[Claim, ...], depth: int
    ) -> Proof | None:
        """A claim about exp u and r, from one about u and log r."""
        exponential = claim.lhs if claim.lhs.op == "exp" else claim.rhs
        inner = exponential.children[0]
        other = claim.rhs if exponential is claim.lhs else claim.lhs
        if self._sign(other, bounds) != 1 or not self.known.clears(
            (log(other), log(exponential)), self.context
        ):
            return None
        sides = (inner, log(other)) if exponential is claim.lhs else (log(other), inner)
        below = Claim(claim.relation, *sides)
        proof = self._grown(below, bounds, cuts, depth)
        if proof is None:
            return None
        law = equal(log(exponential), inner)
        name = self.known.session.ensure(law, Law(), self.known.home(law, self.context))
        premise = Sum(("goal", f"@{len(cuts) + 1}"), (name,))
        return Have(below, (proof, Monotony(premise, "log")))

    # --- without divisors -----------------------------------------------------------------------

    def _cleared(
        self, claim: Claim, bounds: Bounds, cuts: tuple[Claim, ...], depth: int
    ) -> Proof | None:
        """By the numerator of the difference, without the factors whose signs are known."""
        if not self.clears or claim in self.numerators:
            return None
        is_negative = partial(self.known.is_negative, context=self.context)
        try:
            clearing = Clearing((claim.lhs, claim.rhs), {}, is_negative)
            difference = clearing.difference(claim.rhs, claim.lhs)
        except TooLongError:
            return None
        rest, values = self._without_factors(clearing, difference, bounds, claim.relation)
        if rest.is_constant() or len(rest) > MAX_MONOMIALS:
            return None
        cleared = Claim(claim.relation, ZERO, clearing.term(rest))
        self.numerators.add(cleared)
        if cleared == claim or not (_has_divisor(claim) or _size(cleared) < _size(claim)):
            return None
        proof = self.prove(cleared, bounds, cuts, depth)
        last = Sum(("goal", product_of(f"@{len(cuts) + 1}", *values)))
        return None if proof is None else Have(cleared, (proof, last))

    def _without_factors(
        self, clearing: Clearing, polynomial: fmpq_mpoly, bounds: Bounds, relation: str
    ) -> tuple[fmpq_mpoly, list[Value]]:
        """A polynomial divided by the powers of the variable and of exponentials in it.

        The same with what is linear in the variable, as 1 - x. With the polynomial the values of
        the facts that these powers are positive.
        """
        values: list[Value] = []
        for index, atom in enumerate(clearing.atoms):
            power = min(coefficients(polynomial, index), default=0)
            found = self._positive(atom, bounds, relation) if power else None
            if found is not None:
                value, sign = found
                polynomial = polynomial / clearing.context.gens()[index] ** power * sign**power
                values.append(power_of(value, power))
        for factor, power in polynomial.factor()[1] if len(polynomial) <= MAX_MONOMIALS else ():
            if factor.total_degree() == 1 and len(factor) == 2:
                signs = ((s, self._linear(clearing, factor * s, bounds, relation)) for s in (1, -1))
                known = next(((s, value) for s, value in signs if value is not None), None)
                if known is not None:
                    polynomial = polynomial / factor**power * known[0] ** power
                    values.append(power_of(known[1], power))
        return polynomial, values

    def _positive(self, atom: Term, bounds: Bounds, relation: str) -> tuple[Value, int] | None:
        """The value of an atom or, with the sign -1, of its opposite, which is positive."""
        if atom.op == "exp":
            fact = self.known.fact(Claim("<", ZERO, atom), self.context)
            return None if fact is None else (fact, 1)
        if atom != self.x:
            return None
        low = None if bounds.low is None else (bounds.low, bounds.low_fact, bounds.low_relation, 1)
        high = bounds.high
        top = None if high is None else (-high, bounds.high_fact, bounds.high_relation, -1)
        for end in (low, top):
            if end is not None and end[0] >= 0:
                distance, fact, sign = *end[:2], end[3]
                if distance > 0:
                    return ("add", fact, str(distance)), sign
                if relation in (end[2], "<="):
                    return fact, sign
        return None

    def _divided(
        self, claim: Claim, bounds: Bounds, cuts: tuple[Claim, ...], depth: int
    ) -> Proof | None:
        """By the slope of chords from an end where both sides vanish, as x log x does at 0."""
        if not self.clears or self.others or _has_divisor(claim):
            return None
        for end, relation, sign in (
            (bounds.low, bounds.low_relation, 1),
            (bounds.high, bounds.high_relation, -1),
        ):
            if end is None or relation != "<" or not self._vanishes(claim, float_of(end), sign):
                continue
            distance = as_term(end) - self.x if sign < 0 else self.x - end if end else self.x
            chord = (claim.rhs - claim.lhs) / distance
            divided = Claim(claim.relation, ZERO, chord)
            if not self.known.clears((chord,), self.context):
                continue
            proof = self._grown(divided, bounds, cuts, depth - 1)
            if proof is not None:
                return Have(divided, (proof, Sum(("goal", f"@{len(cuts) + 1}"))))
        return None

    def _vanishes(self, claim: Claim, end: float, sign: int) -> bool:
        """Whether both sides seem to come together at an end where they have no values."""
        values = estimates([self.name], [claim.lhs, claim.rhs], {})
        gaps: list[float] = []
        for distance in (2.0**-10, 2.0**-20, 0.0):
            try:
                low, high = values(end + sign * distance)
                gaps.append(high - low)
            except (ArithmeticError, ValueError, TypeError):
                return distance == 0 and abs(gaps[1]) < abs(gaps[0]) / 100
        return False

    # --- derivatives ----------------------------------------------------------------------------

    def _grown(
        self, claim: Claim, bounds: Bounds, cuts: tuple[Claim, ...], depth: int
    ) -> Proof | None:
        slope = derivative(claim.rhs - claim.lhs, self.name)
        if slope is None or not self.known.clears((claim.lhs, claim.rhs, slope), self.context):
            return None
        sign = self._sign(slope, bounds)
        ends = self._ends(bounds, cuts, is_above=sign > 0) if sign else ()
        found = (self._from(claim, slope, bounds, cuts, depth, end) for end in ends)
        return next(filter(None, found), None)

    def _ends(
        self, bounds: Bounds, cuts: tuple[Claim, ...], *, is_above: bool
    ) -> Iterator[tuple[Term, str, str]]:
        """Terms at which a range of the variable begins (or ends), each with the fact that says so.

        With the fact its relation.
        """
        for given in self.known.contexts[self.context].givens:
            relation, lhs, rhs = given.claim.key
            near, far = (rhs, lhs) if is_above else (lhs, rhs)
            is_end = near == self.x and far.op != "rational" and relation in ("<", "<=")
            others = self.known.variables_in(names_of(far))
            if is_end and others <= self.others.keys():
                yield far, given.name, relation
        end = bounds.low if is_above else bounds.high
        if end is not None:
            order = self._order(as_term(end), bounds, cuts, is_above=is_above)
            if order is not None:
                yield as_term(end), *order

    def _from(
        self,
        claim: Claim,
        slope: Term,
        bounds: Bounds,
        cuts: tuple[Claim, ...],
        depth: int,
        end: tuple[Term, str, str],
    ) -> Proof | None:
        """A proof from the claim at an end of the range."""
        at, fact, relation = end
        is_above = self._sign(slope, bounds) > 0
        near = self._near(cuts, at, is_above=is_above)
        if near is None:
            return None
        for strict in ("start", "slope") if claim.relation == "<" else ("start",):
            relations = AT_POINT.get((claim.relation, strict), ("<=", "<=", "<="))
            start = self._at(Claim(relations[0], claim.lhs, claim.rhs), at, bounds)
            comparison = _weaker(fact, relation, relations[1])
            if start is None or comparison is None:
                continue
            sides = (ZERO, slope) if is_above else (slope, ZERO)
            proof = self.prove(Claim(relations[2], *sides), bounds, cuts, depth - 1)
            if proof is not None:
                side = "above" if is_above else "below"
                fields = self.name, at, slope, side, strict, start, comparison, proof, near
                return Derivative(*fields)
        return None

    def _at(self, claim: Claim, end: Term, bounds: Bounds) -> Premise | None:
        """A proof of the claim at an end."""
        found = substitute_claim(claim, {self.name: end})
        if self.goal.variables.keys().isdisjoint(names_of(found.lhs, found.rhs)):
            return self._ground(found) if self.known.clears((found.lhs, found.rhs), None) else None
        least = min((gap for _, gap in self._gaps(found, bounds)), default=-1.0)
        seems = least > 0 or (least == 0 and claim.relation == "<=")
        if not seems or not self.known.clears((found.lhs, found.rhs), self.context):
            return None
        return self._without(found)

    def _order(
        self, at: Term, bounds: Bounds, cuts: tuple[Claim, ...], *, is_above: bool
    ) -> tuple[str, str] | None:
        """The fact that compares the variable and an end of its range, and its relation."""
        name = bounds.low_fact if is_above else bounds.high_fact
        claim = cuts[int(name[1:]) - 1] if name[:1] == "@" else self.known.session.claims.get(name)
        sides = (at, self.x) if is_above else (self.x, at)
        good = claim is not None and (claim.lhs, claim.rhs) == sides and claim.relation != "="
        return (name, claim.relation) if good and claim is not None else None

    def _near(
        self, cuts: tuple[Claim, ...], at: Term, *, is_above: bool
    ) -> tuple[Premise, ...] | None:
        """Why each bound on the side of an end holds for it; None if a given is no bound."""
        found: list[Premise] = []
        for claim in (*self.givens, *cuts):
            if self.name not in names_of(claim.lhs, claim.rhs):
                continue
            is_lower = claim.rhs == self.x
            end = claim.lhs if is_lower else claim.rhs
            if self.x not in (claim.lhs, claim.rhs) or claim.relation == "=":
                return None
            if self.name in names_of(end):
                return None
            if is_lower == is_above:
                premise = self._not_beyond(end, at, is_above=is_above)
                if premise is None:
                    return None
                found.append(premise)
        return tuple(found)

    def _not_beyond(self, bound: Term, at: Term, *, is_above: bool) -> Premise | None:
        """Why a bound is not beyond an end, seen from the variable."""
        if bound == at:
            return Sum(("goal",))
        claim = Claim("<=", *((bound, at) if is_above else (at, bound)))
        if not [*names_of(bound, at)]:
            return self._ground(claim)
        return self.question.fact(claim)

    # --- cuts -----------------------------------------------------------------------------------

    def _cut(
        self, claim: Claim, bounds: Bounds, cuts: tuple[Claim, ...], depth: int
    ) -> Proof | None:
        for number in self._numbers(claim, bounds):
            fact, at = f"@{len(cuts) + 1}", as_term(number)
            below = bounds._replace(high=number, high_fact=fact, high_relation="<=")
            above = bounds._replace(low=number, low_fact=fact, low_relation="<=")
            left = self.prove(claim, below, (*cuts, Claim("<=", self.x, at)), depth - 3)
            if left is None:
                continue
            right = self.prove(claim, above, (*cuts, Claim("<=", at, self.x)), depth - 3)
            if right is not None:
                return Cuts(self.x, (number,), (left, right))
        return None

    def _numbers(self, claim: Claim, bounds: Bounds) -> Iterator[Fraction]:
        """Where the sides meet; else where the derivative changes its sign; else the middle."""
        inside = [q for q in dict.fromkeys(SIMPLE) if _is_inside(q, bounds)]
        if self.others:
            yield from inside[:1]
            return
        values = estimates([self.name], [claim.lhs, claim.rhs], {})
        meeting = next((number for number in inside if _meets(values, float_of(number))), None)
        if meeting is not None:
            yield meeting
            return
        changes = [*self._turns(claim, bounds)]
        yield from changes[:2]
        if bounds.ends is not None and not changes:
            low, high = map(float_of, bounds.ends)
            yield _short((low + high) / 2, (high - low) / 8)
        elif not changes:
            yield from inside[:2]

    def _turns(self, claim: Claim, bounds: Bounds) -> Iterator[Fraction]:
        """Numbers at or near which the derivative changes its sign."""
        slope = derivative(claim.rhs - claim.lhs, self.name)
        signs = [] if slope is None else sorted(self._gaps(Claim("<=", ZERO, slope), bounds))
        meets = [x for x, sign in signs if sign == 0]
        for (a, before), (b, after) in pairwise((x, sign) for x, sign in signs if sign):
            if before * after < 0:
                at = [x for x in meets if a < x < b]
                yield Fraction(at[0]) if len(at) == 1 else _short((a + b) / 2, (b - a) / 8)


def _meets(values: Callable[..., tuple[float, ...]], x: float) -> bool:
    """Whether two sides seem to be equal at a point, and not near by."""
    try:
        low, high = values(x)
        if abs(high - low) <= NOISE * (abs(low) + abs(high) + NOISE):
            return True
        around = [values(x + step) for step in (-NEAR_BY, NEAR_BY)]
    except (ArithmeticError, ValueError, TypeError):
        return False
    return all(abs(high - low) <= NOISE * abs(b - a) for a, b in around)


def _weaker(name: str, relation: str, wanted: str) -> Premise | None:
    """The fact, or what it implies with the other relation."""
    if relation == wanted:
        return name
    return Sum(("goal", name)) if wanted == "<=" else None


def _is_inside(number: Fraction, bounds: Bounds) -> bool:
    return (bounds.low is None or bounds.low < number) and (
        bounds.high is None or number < bounds.high
    )


def _short(value: float, width: float) -> Fraction:
    """A fraction with few digits near a number."""
    digits = max(1, 1 - math.floor(math.log2(width))) if width > 0 else 20
    return Fraction(round(value * 2**digits), 2**digits)


def _places(variables: Mapping[str, Bounds]) -> Iterator[tuple[float, ...]]:
    """Values of variables; where there are several, mixed in many ways."""
    values = [[*_points(bounds)] for bounds in variables.values()]
    if not values:
        yield ()
        return
    for k in range(PLACES):
        yield tuple(
            each[(k * (3 + 4 * i) + i) * len(each) // PLACES % len(each)]
            for i, each in enumerate(values)
        )


def _points(bounds: Bounds) -> Iterator[float]:
    """Points between bounds, of which many are near the ends, or far away."""
    low = None if bounds.low is None else float_of(bounds.low)
    high = None if bounds.high is None else float_of(bounds.high)
    far = [2.0**k for k in range(-8, 8)]
    if low is not None and high is not None:
        parts = [(i + 0.5) / 24 for i in range(24)] + [2.0**-k for k in range(5, 9)]
        yield from (low + (high - low) * t for t in parts)
        yield from (high - (high - low) * 2.0**-k for k in range(5, 9))
    elif low is not None:
        yield from (low + step for step in far)
    elif high is not None:
        yield from (high - step for step in far)
    else:
        yield from (sign * step for step in far for sign in (1, -1))
