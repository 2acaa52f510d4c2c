"""Claims about exponentials and logarithms, taken apart by their laws.

Exponentials of sums become products of a few, such as exp(a/2) and exp(b/2), and logarithms of
products become sums. What is left is a claim about those. A comparison of sums of logarithms
follows from one of products.
"""

from __future__ import annotations

from collections.abc import Iterable, Iterator, Mapping, Sequence
from fractions import Fraction
from functools import reduce
from math import comb, gcd, lcm
from operator import add, mul

from flint import fmpz

from verify.language.fold import replaced
from verify.language.terms import Claim, Term, as_term, equal, exp, log, nth_root, parts_of, sqrt
from verify.prover.balls import fraction_of
from verify.prover.clearing import ROOTS, Clearing, TooLongError, atoms_of, index_of
from verify.prover.proof import Proof, Value, power_of, product_of
from verify.prover.rules import Antisymmetry, InRange, Interval, Law, Monotony, Sum
from verify.prover.search.question import Question
from verify.prover.session import ZERO

ONE = as_term(1)
#: A product may have so many factors, and a number such factors.
MAX_FACTORS, MAX_NUMBER = 24, 10**9
#: Enough for exp 0 and log 1, which are exact.
BITS = 32

#: Numbers of factors, by what each is the exponential of.
Powers = Mapping[Term, int]


def by_laws(question: Question) -> Proof | None:
    """A claim about parts of the exponentials and logarithms in the claim.

    Those inside other functions stay: with an equation the checker replaces none there.
    """
    claim, laws = question.plain.claim, Laws(question)
    atoms = atoms_of((claim.lhs, claim.rhs), {})
    inside = {*parts_of(*(child for atom in atoms for child in atom.children))}
    chosen = laws.of([atom for atom in atoms if atom not in inside])
    simpler = Claim(claim.relation, *(replaced(s, chosen) for s in (claim.lhs, claim.rhs)))
    if simpler == claim or not question.known.clears((simpler.lhs, simpler.rhs), laws.place):
        return None
    return question.from_fact(claim, laws.fact(simpler), laws.used)


def by_products_of_logarithms(question: Question) -> Proof | None:
    """Both sides are sums of multiples of logarithms, of which one product is the larger."""
    claim, laws = question.plain.claim, Laws(question)
    parts = None if claim.relation == "=" else _multiples(claim)
    if parts is None:
        return None
    whole = lcm(*(part.denominator for part in parts.values()))
    sides = [
        [(atom, int(sign * part * whole)) for atom, part in parts.items() if sign * part > 0]
        for sign in (-1, 1)
    ]
    if not all(sides) or sum(n for side in sides for _, n in side) > MAX_FACTORS:
        return None
    low, high = (_product(a.children[0] for a, n in side for _ in range(n)) for side in sides)
    if not question.known.clears((log(low), log(high)), laws.place):
        return None
    inner = question.fact(Claim(claim.relation, low, high))
    if inner is None:
        return None
    compared = laws.lemma(Claim(claim.relation, log(low), log(high)), Monotony(inner))
    try:
        for side in sides:
            laws.sum_of_logarithms([atom.children[0] for atom, n in side for _ in range(n)])
    except StuckError:
        return None
    return Sum(("goal", product_of(str(Fraction(1, whole)), compared)), (*laws.used,))


def _multiples(claim: Claim) -> dict[Term, Fraction] | None:
    """The logarithms in the difference of the sides with their factors; None if more is there."""
    try:
        clearing = Clearing((claim.lhs, claim.rhs), {})
        p = clearing.difference(claim.rhs, claim.lhs)
    except TooLongError:
        return None
    found: dict[Term, Fraction] = {}
    for monomial, factor in p.to_dict().items():
        if sum(monomial) != 1 or (atom := clearing.atoms[[*monomial].index(1)]).op != "log":
            return None
        found[atom] = fraction_of(factor)
    return found


class StuckError(ValueError):
    """A product of positive factors was not shown to be positive."""


class Laws:
    """Equations of exponentials and logarithms at a place, each proved once it is used."""

    def __init__(self, question: Question) -> None:
        self.question, self.known = question, question.known
        self.session, self.place = question.session, question.goal.context
        self.used: dict[str, None] = {}
        self.keeps_exponentials = False
        self._given: dict[tuple[Term, Fraction], Term] | None = None

    def fact(self, claim: Claim) -> str | None:
        """The name of a claim that is proved now."""
        found = self.question.fact(claim)
        if found is not None or self.known.home(claim, self.place) is not None:
            return found
        proof = self.known.prove(self.known.goal(claim, None))
        return None if proof is None else self.session.lemma(claim, proof)

    def lemma(self, claim: Claim, proof: Proof) -> str:
        """The name of a claim with this proof."""
        return self.session.ensure(claim, proof, self.known.home(claim, self.place))

    def use(self, claim: Claim, proof: Proof) -> None:
        """An equation, which tells what its left side is."""
        self.used[self.lemma(claim, proof)] = None

    def clears(self, *terms: Term) -> bool:
        """Whether all divisors, and what logarithms are of, have the signs that they need."""
        return self.known.clears(terms, self.place)

    def of(self, atoms: Sequence[Term]) -> dict[Term, Term]:
        """What the exponentials and logarithms among some terms are, in simpler ones."""
        chosen = self.exponentials([atom for atom in atoms if atom.op == "exp"])
        chosen |= self.roots([atom for atom in atoms if atom.op in ROOTS])
        for atom in atoms:
            if atom.op == "log":
                try:
                    chosen |= self.logarithm(atom)
                except StuckError:
                    continue
        return chosen

    # --- exponentials ---------------------------------------------------------------------------

    def exponentials(self, atoms: Sequence[Term]) -> dict[Term, Term]:
        """For each of them the product of powers of a few that it is, if that is simpler."""
        sums = {
            atom: found for atom in atoms if (found := linear_parts(atom.children[0])) is not None
        }
        steps: dict[Term, Fraction] = {}
        for part in {part for found in sums.values() for part in found}:
            factors = [found[part] for found in sums.values() if part in found]
            above = 1 if part.op == "log" else gcd(*(f.numerator for f in factors))
            step = Fraction(above, lcm(*(f.denominator for f in factors)))
            steps[part] = -step if all(f < 0 for f in factors) else step
        chosen = {}
        for atom, found in sums.items():
            powers = {
                self._written(part, steps[part]): int(f / steps[part]) for part, f in found.items()
            }
            if sum(map(abs, powers.values())) > MAX_FACTORS:
                continue
            if powers == {atom.children[0]: 1} and self._plain(atom) == atom:
                continue
            inner = [exp(part) for part in powers]
            is_short = sum(part.op != "log" for part in steps) <= len(sums)
            if is_short and self.clears(atom, *inner):
                chosen[atom] = self._product(atom, powers)
        return chosen

    def _written(self, part: Term, step: Fraction) -> Term:
        """A multiple of a term, as it is written in an exponential that is given."""
        if self._given is None:
            self._given = {}
            sides = (side for given in self.question.givens() for side in given.claim.key[1:])
            for atom in parts_of(*sides):
                found = linear_parts(atom.children[0]) if atom.op == "exp" else None
                if found is not None and len(found) == 1:
                    self._given.setdefault(next(iter(found.items())), atom.children[0])
        return self._given.get((part, step), step_of(part, step))

    def _product(self, atom: Term, powers: Powers) -> Term:
        """The product that an exponential is."""
        factors = [(part, 1 if n > 0 else -1) for part, n in powers.items() for _ in range(abs(n))]
        if not factors:
            if atom != exp(0):
                self.use(equal(atom, exp(0)), Monotony(Sum(())))
            self.use(equal(exp(0), ONE), Interval(BITS))
            return ONE
        if len(factors) > 1:
            halves = factors[: len(factors) // 2], factors[len(factors) // 2 :]
            parts = [exp(_sum(half)) for half in halves]
            self.use(equal(atom, parts[0] * parts[1]), Law())
            return _product([self._part(*pair) for pair in zip(parts, halves, strict=True)])
        ((part, sign),) = factors
        if sign < 0:
            return self._inverse(atom, exp(part))
        if atom != exp(part):
            self.use(equal(atom, exp(part)), Monotony(Sum(())))
        return self._plain(exp(part))

    def _part(self, atom: Term, factors: Sequence[tuple[Term, int]]) -> Term:
        powers: dict[Term, int] = {}
        for part, sign in factors:
            powers[part] = powers.get(part, 0) + sign
        return self._plain(atom) if powers == {atom.children[0]: 1} else self._product(atom, powers)

    def _plain(self, atom: Term) -> Term:
        """An exponential, or what it is the exponential of the logarithm of, or a root of that."""
        inner, root = atom.children[0], _root_of(atom)
        if root is not None and not self.keeps_exponentials and self._is_root(atom, root):
            return root
        if inner.op != "log":
            return atom
        number: Term = inner.children[0]
        self.use(equal(atom, number), Law())
        return number

    def _inverse(self, atom: Term, other: Term) -> Term:
        """The inverse of another exponential, which the product of both shows."""
        one = exp(0)
        product = self.lemma(equal(one, other * atom), Law())
        unit = self.lemma(equal(one, ONE), Interval(BITS))
        self.clears(ONE / other)
        self.use(equal(atom, ONE / other), Sum((), (unit,), ((product, as_term(-1)),)))
        plain = self._plain(other)
        self.clears(ONE / plain)
        return ONE / plain

    # --- roots ----------------------------------------------------------------------------------

    def roots(self, atoms: Sequence[Term]) -> dict[Term, Term]:
        """For roots of one number what they are as powers of one root of it."""
        chosen = {}
        for radicand in {atom.children[0]: None for atom in atoms}:
            own = [atom for atom in atoms if atom.children[0] == radicand]
            index = lcm(*map(index_of, own))
            common = nth_root(radicand, index) if index <= MAX_FACTORS else own[0]
            for atom in own if len({*map(index_of, own)}) > 1 and self.clears(common) else ():
                power = index // index_of(atom)
                if power > 1:
                    chosen[atom] = common**power
                    smaller = (power_of(("root", common), power), ("root", atom))
                    first, second = (Sum(between(index_of(atom), s)) for s in smaller)
                    self.use(equal(atom, common**power), Antisymmetry((first, second)))
        return chosen

    def _is_root(self, atom: Term, root: Term) -> bool:
        """Whether an exponential is a root of what its argument has the logarithm of."""
        (number,), index, whole = root.children, index_of(root), Laws(self.question)
        clearing, logarithm = Clearing((number,), {}), log(number)
        if not self.clears(exp(logarithm), root) or not clearing.clear(number)[1].is_constant():
            return False
        whole.keeps_exponentials = True
        whole._product(exp(logarithm), {atom.children[0]: index})
        law = self.lemma(equal(exp(logarithm), number), Law())
        power = self.lemma(equal(atom**index, number), Sum((), (*whole.used,), ((law, ONE),)))
        positive = self.lemma(Claim("<", ZERO, atom), InRange())
        above = Sum(between(index, ("root", root)), (), ((power, as_term(-1)),))
        below = Sum(between(index, positive), (), ((power, ONE),))
        self.use(equal(atom, root), Antisymmetry((above, below)))
        return True

    # --- logarithms -----------------------------------------------------------------------------

    def logarithm(self, atom: Term) -> dict[Term, Term]:
        """The sum of multiples of simpler logarithms that it is, if it is one."""
        if atom.children[0].op in ("exp", "sqrt"):
            whole = self._of_factor(atom.children[0])
            return {} if whole == atom else {atom: whole}
        found = _factors(atom.children[0])
        if found is None:
            return {}
        above, below = found
        parts = [*dict.fromkeys((*above, *below))]
        if parts == [atom.children[0]] or not self.clears(*map(log, parts)):
            return {}
        top, bottom = (_product(side or [ONE]) for side in (above, below))
        if not self.clears(log(top), log(bottom)):
            return {}
        if below or atom.children[0] != top:
            law = self.lemma(equal(log(top), atom + log(bottom)), Law())
            self.use(equal(atom, log(top) - log(bottom)), Sum((), (), ((law, as_term(-1)),)))
        return {atom: self.sum_of_logarithms(above) - self.sum_of_logarithms(below)}

    def sum_of_logarithms(self, factors: Sequence[Term]) -> Term:
        """What the logarithm of their product is."""
        if not factors:
            self.use(equal(log(ONE), ZERO), Interval(BITS))
            return ZERO
        product = factors[0]
        for factor in factors[1:]:
            whole = product * factor
            if not self.clears(log(whole)):
                raise StuckError
            self.use(equal(log(whole), log(product) + log(factor)), Law())
            product = whole
        return reduce(add, [self._of_factor(factor) for factor in factors])

    def _of_factor(self, factor: Term) -> Term:
        """The logarithm of a factor, of an exponential, or of a root."""
        atom = log(factor)
        if factor.op == "exp":
            argument: Term = factor.children[0]
            self.use(equal(atom, argument), Law())
            return argument
        if factor.op == "sqrt" and self.clears(log(factor.children[0])):
            inner = log(factor.children[0])
            law = self.lemma(equal(inner, atom + atom), Law())
            half = Sum((), (), ((law, as_term(Fraction(-1, 2))),))
            self.use(equal(atom, inner / 2), half)
            return inner / 2
        return atom


def _product(factors: Iterable[Term]) -> Term:
    return reduce(mul, factors)


def step_of(part: Term, step: Fraction) -> Term:
    """A multiple of a term, as short as it can be written."""
    if part == ONE:
        return as_term(step)
    return part if step == 1 else as_term(step) * part


def between(index: int, smaller: Value) -> tuple[Value, ...]:
    """What the power of a sum of a number and of the goal has beside that of the number."""
    return tuple(
        product_of(
            str(comb(index, k)),
            power_of("goal", k),
            *([power_of(smaller, index - k)] if k < index else []),
        )
        for k in range(1, index + 1)
    )


def _root_of(atom: Term) -> Term | None:
    """The root that an exponential of 1/n times a logarithm is."""
    inner = atom.children[0]
    if inner.op != "mul" or inner.children[0].op != "rational" or inner.children[1].op != "log":
        return None
    share, (number,) = inner.children[0].value, inner.children[1].children
    if share.numerator != 1 or not 2 <= share.denominator <= MAX_FACTORS:
        return None
    return sqrt(number) if share == Fraction(1, 2) else nth_root(number, share.denominator)


def _sum(factors: Sequence[tuple[Term, int]]) -> Term:
    """What the product of exponentials is the exponential of."""
    return reduce(add, (part if sign > 0 else -part for part, sign in factors))


def linear_parts(argument: Term) -> dict[Term, Fraction] | None:
    """The rational factors of the different products in a polynomial."""
    try:
        clearing = Clearing((argument,), {})
        above, below = clearing.clear(argument)
    except TooLongError:
        return None
    if not below.is_constant() or below.is_zero():
        return None
    polynomial = above / below.leading_coefficient()
    found = {}
    for monomial, factor in polynomial.to_dict().items():
        powers = sorted(zip(clearing.atoms, map(int, monomial), strict=False), key=str)
        factors = [atom if n == 1 else atom**n for atom, n in powers if n]
        found[_product(factors or [ONE])] = fraction_of(factor)
    return found


def _factors(term: Term) -> tuple[list[Term], list[Term]] | None:
    """The factors of a quotient of polynomials, above and below; prime numbers among them."""
    try:
        clearing = Clearing((term,), {})
        quotient = clearing.clear(term)
    except TooLongError:
        return None
    common = quotient[0].gcd(quotient[1])
    sides: list[list[Term]] = []
    scale = Fraction(1)
    for sign, polynomial in zip((1, -1), quotient, strict=True):
        if polynomial.is_zero():
            return None
        number, factors = (polynomial / common).factor()
        scale *= fraction_of(number) ** sign
        sides.append([clearing.term(f) for f, n in factors for _ in range(int(n))])
    if scale < 0 and len(sides[0]) == 1:
        sides[0], scale = [-sides[0][0]], -scale
    if scale <= 0 or max(scale.numerator, scale.denominator) > MAX_NUMBER:
        return None
    sides[0] += _primes(scale.numerator)
    sides[1] += _primes(scale.denominator)
    return (sides[0], sides[1]) if len(sides[0] + sides[1]) <= MAX_FACTORS else None


def _primes(number: int) -> Iterator[Term]:
    return (as_term(int(p)) for p, n in fmpz(number).factor() for _ in range(int(n)))
