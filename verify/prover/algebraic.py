"""Equality of numbers made of nested roots and of cosines of rational multiples of pi.

What is to be 0 is a polynomial P in roots, each over earlier ones, and in c = cos(pi/n). With the
latest root, P = A + B s. If the conjugate A - B s is not 0, then P = 0 because (A + B s)(A - B s) =
A^2 - B^2 s^2 is, which has fewer roots; else because A and B are. In the end there is a polynomial
in c, which is 0 modulo the minimal polynomial of c. Each step is a lemma, by *antisymmetry*. The
minimal polynomial divides what *angles* shows to be 0.
"""

from __future__ import annotations

from fractions import Fraction
from math import lcm

from verify.language.terms import Claim, Term, as_term, cos_pi, equal, names_of
from verify.prover import balls
from verify.prover.clearing import Clearing, Polynomial, atoms_of, coefficients
from verify.prover.cosines import HALF, Relations, chebyshev
from verify.prover.goal import definitions_below
from verify.prover.proof import Proof, Value
from verify.prover.rules import Antisymmetry, Sum
from verify.prover.session import ZERO
from verify.prover.tight import Tight

#: Larger numerators and denominators of angles are left alone.
MAX_MULTIPLE = 60
MAX_ROOTS = 8
#: A conjugate that so many bits do not tell from 0 is taken for 0.
BITS = 1024
Equations = list[tuple[str, Polynomial]]


class Algebraic:
    """Proofs of `=`, and of `<=` between equal sides, for one claim without variables."""

    def __init__(self, tight: Tight) -> None:
        self.ground = tight.ground
        self.session, self._tight = tight.session, tight
        self._zero: dict[Term, str | None] = {}

    def prove(self, claim: Claim) -> Proof | None:
        """A proof, whose lemmas are written down; None if the sides are not seen to be equal."""
        if claim.relation == "<" or not self._may_be_equal(claim):
            return None
        below = definitions_below(names_of(claim.lhs, claim.rhs), self.ground.definitions)
        names = tuple(sorted(below))
        replaced = dict(self.session.replaced(names))
        atoms = atoms_of((claim.lhs, claim.rhs), replaced)
        if not self._is_plain(atoms) or not self._tight.cleared(
            claim.lhs, claim.rhs, *below.values()
        ):
            return None
        self._cosines = Cosines(self, {atom for atom in atoms if atom.op == "cos_pi"})
        self._using = (*names, *self._cosines.equations)
        replaced |= self.session.replaced(self._cosines.equations)
        more = (self._cosines.generator,) if self._cosines.relation else ()
        self._clearing = Clearing((claim.lhs, claim.rhs, *more), replaced)
        roots = [atom for atom in self._clearing.atoms if atom.op == "sqrt"]
        one = self._clearing.one
        if any(self._clearing.clear(root.children[0])[1] != one for root in roots):
            return None
        found = self._vanishes(self._clearing.difference(claim.lhs, claim.rhs))
        if found is None:
            return None
        sign = self._sign(claim)
        if claim.relation == "=":
            return Sum((), self._using, self._cofactors(found, sign))
        return Sum(("goal",), self._using, self._cofactors(found, -sign))

    def _sign(self, claim: Claim) -> int:
        """-1 where the product of the denominators, which the checker makes positive, is not."""
        (_, d), (_, e) = map(self._clearing.clear, (claim.lhs, claim.rhs))
        ball = self.ground.ball(self._clearing.term(self._clearing.times(d, e)), BITS)
        return -1 if ball is not None and balls.strict_sign(ball) < 0 else 1

    def _may_be_equal(self, claim: Claim) -> bool:
        ball = self.ground.ball(claim.lhs - claim.rhs, BITS)
        return ball is not None and not balls.strict_sign(ball)

    def _is_plain(self, atoms: list[Term]) -> bool:
        """Whether there are roots or cosines that a proof could use, and not too many of them."""
        roots = [atom for atom in atoms if atom.op == "sqrt"]
        cosines = [atom.children[0] for atom in atoms if atom.op == "cos_pi"]
        if any(atom.op in ("min", "max") for atom in atoms) or not (roots or cosines):
            return False
        known = [angle for angle in map(self._angle, cosines) if angle is not None]
        if len(known) < len(cosines):
            return False
        n = lcm(*(angle.denominator for angle in known))
        largest = max((abs(angle) * n for angle in known), default=0)
        return len(roots) <= MAX_ROOTS and max(n, largest) <= MAX_MULTIPLE

    def _angle(self, term: Term) -> Fraction | None:
        """The rational number that an angle is, as the checker clears it."""
        angle = None if [*names_of(term)] else self.ground.exact(term)
        if angle is None:
            return None
        clearing = Clearing((term,), {})
        rest = clearing.reduce(clearing.difference(term, as_term(angle)))
        return None if rest.to_dict() else angle

    # --- polynomials that are 0 -----------------------------------------------------------------

    def _vanishes(self, p: Polynomial) -> Equations | None:
        """Equations with cofactors that add up to p, modulo the squares of roots."""
        p, found = self._reduced(p)
        if not p.to_dict():
            return found
        name = self._lemma(p)
        return None if name is None else [*found, (name, self._clearing.one)]

    def _reduced(self, p: Polynomial) -> tuple[Polynomial, Equations]:
        """The rest modulo squares of roots and the minimal polynomial, which has a cofactor."""
        p = self._clearing.reduce(p)
        if not self._cosines.relation:
            return p, []
        n, _ = self._clearing.clear(self.session.claims[self._cosines.relation].lhs)
        quotient, rest = divmod(p, n)
        return rest, [(self._cosines.relation, quotient)] if quotient.to_dict() else []

    def _lemma(self, p: Polynomial) -> str | None:
        """The name of the fact p = 0."""
        term = self._clearing.term(p)
        if term not in self._zero:
            self._zero[term] = self._show(p, equal(term, ZERO))
        return self._zero[term]

    def _show(self, p: Polynomial, claim: Claim) -> str | None:
        atoms, degrees = self._clearing.atoms, p.degrees()
        used = [i for i, atom in enumerate(atoms) if atom.op == "sqrt" and degrees[i]]
        if not used:
            return None
        parts = coefficients(p, used[-1])
        zero = self._clearing.context.constant(0)
        a, b = parts.get(0, zero), parts.get(1, zero)
        s = self._clearing.context.gens()[used[-1]]
        conjugate = self._clearing.term(a - b * s)
        ball = self.ground.ball(conjugate, BITS)
        sign = 0 if ball is None else balls.strict_sign(ball)
        if sign:
            norm = self._vanishes(a * a - b * b * s * s)
            fact = self.ground.positive(conjugate if sign > 0 else -conjugate)
            if norm is None or fact is None:
                return None
            proof = self._both(("mul", "goal", fact), norm, sign)
            return self.session.lemma(claim, proof)
        first, second = self._vanishes(a), self._vanishes(b)
        if first is None or second is None:
            return None
        equations = [*first, *((name, q * s) for name, q in second)]
        return self.session.lemma(claim, Sum((), self._using, self._cofactors(equations, 1)))

    def _both(self, addend: Value, equations: Equations, sign: int) -> Proof:
        """Both orders: goal times a positive number is what the equations say is 0."""
        orders = (-sign, sign)
        first, second = (
            Sum((addend,), self._using, self._cofactors(equations, order)) for order in orders
        )
        return Antisymmetry((first, second))

    def _cofactors(self, equations: Equations, sign: int) -> tuple[tuple[str, Term], ...]:
        return tuple((name, self._clearing.term(p * sign)) for name, p in equations)


class Cosines:
    """Cosines as polynomials in c = cos(pi/n), and the equation that c satisfies.

    ``equations`` are the names of `cos_pi(k/n) = T(c)`, ``relation`` that of `R(c) = 0`, where R is
    irreducible; both are empty without cosines.
    """

    def __init__(self, algebraic: Algebraic, atoms: set[Term]) -> None:
        self.ground, self.session = algebraic.ground, algebraic.session
        self.relations = Relations(self.session, None)
        self.equations: tuple[str, ...] = ()
        self.relation = ""
        self.generator = cos_pi(Fraction(1))
        if not atoms:
            return
        terms = {atom.children[0] for atom in atoms}
        values = {term: self.ground.exact(term) or Fraction(0) for term in terms}
        angles = {*values.values()}
        self.n = max(2, lcm(*(angle.denominator for angle in angles)))
        self.generator = cos_pi(Fraction(1, self.n))
        self._shown: dict[int, str] = {}
        wanted = {abs(int(angle * self.n)) for angle in angles}
        m = self.n // 2
        middle = {m, self.n - m}
        for k in range(max(wanted | middle) + 1):
            self._chebyshev(k)
        self.relation = self._minimal(sorted(middle))
        self.equations = tuple(
            name for k, name in sorted(self._shown.items()) if k != 1 and k in wanted
        )
        other = [term for term in values if term.op != "rational" or term.value < 0]
        self.equations += tuple(self._other(term, values[term]) for term in sorted(other, key=repr))

    def _at(self, k: int) -> Term:
        return cos_pi(Fraction(k, self.n))

    def _chebyshev(self, k: int) -> None:
        """cos(k pi/n) is a polynomial in the generator."""
        claim = equal(self._at(k), chebyshev(self.generator, k))
        known = self.session.known(claim, None)
        if k == 0:
            known = self.relations.exact(self._at(0), 1)
        elif k > 1 and known is None:
            u, v = self._at(k - 1), self.generator
            product = self.relations.product(u, v, self._at(k), self._at(k - 2))
            using = tuple(self._shown[i] for i in (k - 2, k - 1) if i != 1)
            known = self.session.lemma(claim, Sum((), using, ((product, as_term(-1)),)))
        if known is not None:
            self._shown[k] = known

    def _other(self, angle: Term, value: Fraction) -> str:
        """The cosine of an angle that is written in another way, or is negative."""
        k = abs(int(value * self.n))
        cosine, same, zero = Term("cos_pi", angle), cos_pi(abs(value)), cos_pi(Fraction(0))
        using = (self.relations.exact(zero, 1), *((self._shown[k],) if k > 1 else ()))
        pair = (zero, same, same, cosine) if value < 0 else (same, zero, cosine, same)
        proof = Sum((), using, ((self.relations.product(*pair), as_term(-1)),))
        return self.session.ensure(equal(cosine, chebyshev(self.generator, k)), proof)

    def _minimal(self, middle: list[int]) -> str:
        """The irreducible polynomial of the generator is 0: it divides one that is."""
        whole = self._middle(middle)
        clearing = Clearing((self.generator,), {})
        p = clearing.clear(self.session.claims[whole].lhs)[0]
        factor = next(f for f, _ in p.factor()[1] if self._is_zero(clearing.term(f)))
        claim = equal(clearing.term(factor), ZERO)
        known = self.session.known(claim, None)
        if known is not None:
            return known
        rest = clearing.term(p / factor)
        sign = self.ground.sign(rest)
        fact = self.ground.positive(rest if sign > 0 else -rest)
        addend: Value = ("mul", "goal", fact or "")
        first, second = (Sum((addend,), (), ((whole, as_term(o)),)) for o in (-sign, sign))
        return self.session.lemma(claim, Antisymmetry((first, second)))

    def _middle(self, middle: list[int]) -> str:
        """cos(pi/2) = 0, or cos(pi/2 - x) + cos(pi/2 + x) = 0, in terms of the generator."""
        none = self.relations.exact(cos_pi(HALF), 0)
        total, *others = (chebyshev(self.generator, k) for k in middle)
        using, equation = [none], (none, as_term(1))
        if not others:
            using.clear()
        else:
            total = total + others[0]
            rest = HALF - Fraction(middle[0], self.n)
            sums = cos_pi(HALF + rest), cos_pi(HALF - rest)
            product = self.relations.product(cos_pi(HALF), cos_pi(rest), *sums)
            equation = product, as_term(-1)
        using += [self._shown[k] for k in middle if k > 1]
        return self.session.ensure(equal(total, ZERO), Sum((), tuple(using), (equation,)))

    def _is_zero(self, term: Term) -> bool:
        ball = self.ground.ball(term, BITS)
        return ball is not None and not balls.strict_sign(ball)
