"""Sines and cosines of sums, of multiples and of inverse tangents, in one normal form.

An angle is a sum of multiples of a few *generators*: products of atoms, quarter turns, and inverse
tangents. Sines and cosines of it become polynomials in those of the generators; what an inverse
tangent of t is the angle of becomes algebraic in t. In what is left the square of a sine is 1 less
that of the cosine. So identities are found, and so are equations between angles: two angles whose
difference has the sine 0, and lies between -pi and pi, are the same.
"""

from __future__ import annotations

from collections.abc import Iterator, Mapping, Sequence
from fractions import Fraction
from math import gcd, lcm

from flint import fmpq_mpoly

from verify.language.terms import Claim, Term, as_term, atan, cos, equal, pi, sin, sqrt
from verify.prover.clearing import Clearing, TooLongError, atoms_of, coefficients
from verify.prover.cosines import HALF, Relations
from verify.prover.multiple import outside_atoms
from verify.prover.proof import Proof, Value, product_of
from verify.prover.rules import (
    Antisymmetry,
    Cosine,
    Cuts,
    Have,
    InRange,
    Interval,
    Law,
    Monotony,
    Sum,
)
from verify.prover.search.laws import linear_parts, step_of
from verify.prover.search.question import Question
from verify.prover.session import ZERO

ONE = as_term(1)
QUARTER = pi / 2
TRIGONOMETRIC = ("sin", "cos", "cos_pi")
#: Multiples of the generators that an angle may be the sum of, and multiples of quarter turns.
MAX_MULTIPLES, MAX_TURNS = 40, 8
#: Coefficients of y and -y^3 in a bound below sin(pi y).
SERIES = (Fraction(31415926, 10**7), Fraction(5167713, 10**6))
BITS = 64

#: How often each generator is in an angle.
Angle = tuple[tuple[Term, int], ...]


def by_elementary(question: Question) -> Proof | None:
    """The claim in the normal form, or an equation between angles by the sine of a difference."""
    claim, known = question.plain.claim, question.known
    if claim.relation == "<" and claim.lhs == ZERO and claim.rhs.op == "cos":
        found = positive_cosine(question, claim.rhs.children[0])
        if found is not None:
            return Sum(("goal", found))
    try:
        normal = Normal(question, (claim.lhs, claim.rhs))
        if claim.relation == "=":
            return normal.identity(claim) or Angles(question).proof(claim)
        if not normal.replaced or not normal.is_algebraic:
            return None
        sides = [outside_atoms(side, normal.replaced) for side in (claim.lhs, claim.rhs)]
    except TooLongError:
        return None
    if sides == [claim.lhs, claim.rhs] or not known.clears(sides, question.goal.context):
        return None
    return question.from_fact(claim, question.fact(Claim(claim.relation, *sides)), normal.used)


class Facts:
    """Lemmas about sines and cosines at one place."""

    def __init__(self, question: Question) -> None:
        self.question, self.known, self.session = question, question.known, question.session
        self.place = question.goal.context
        self.relations = Relations(self.session, self.place)

    def lemma(self, claim: Claim, proof: Proof) -> str:
        """The name of a claim that is usable, or else proved by this."""
        return self.session.ensure(claim, proof, self.place)

    def from_one(self, claim: Claim, fact: str, using: Sequence[str]) -> str:
        """The name of an equation of which another one is a factor."""
        of = self.session.claims[fact]
        clearing = Clearing((*claim.key[1:], *of.key[1:]), self.session.replaced(using))
        whole = clearing.difference(claim.lhs, claim.rhs)
        factor = clearing.term(whole / clearing.difference(of.lhs, of.rhs))
        return self.lemma(claim, Sum((), tuple(using), ((fact, factor),)))

    def pi(self) -> str:
        """The fact that pi is positive."""
        return self.session.ensure(Claim("<", ZERO, pi), Interval(BITS))

    def quarter(self) -> str:
        """The fact that the cosine of a quarter turn is 0."""
        half = Term("cos_pi", as_term(HALF))
        law = self.lemma(equal(cos(QUARTER), half), Law())
        zero = self.relations.exact(half, 0)
        return self.lemma(equal(cos(QUARTER), ZERO), Sum((), (law, zero)))

    def as_cosine(self, angle: Term) -> str:
        """The law of the sine of an angle, which is a cosine."""
        return self.lemma(equal(sin(angle), cos(QUARTER - angle)), Law())

    def sum(self, whole: Term, u: Term, v: Term) -> tuple[str, str]:
        """The cosine and the sine of u + v."""
        zero, law_u, law_v = self.quarter(), self.as_cosine(u), self.as_cosine(v)
        co_u, co_v, co_whole = QUARTER - u, QUARTER - v, QUARTER - whole
        product = self.relations.product
        left, turned = u - v, pi - whole
        parts = (
            product(cos(u), cos(v), cos(whole), cos(left)),
            product(cos(co_v), cos(co_u), cos(turned), cos(left)),
            product(cos(QUARTER), cos(co_whole), cos(turned), cos(whole)),
        )
        factors = [as_term(Fraction(sign, 2)) for sign in (-1, 1, -1)]
        cosine = self.lemma(
            equal(cos(whole), cos(u) * cos(v) - sin(u) * sin(v)),
            _by(parts, factors, law_u, law_v, zero),
        )
        more, less = QUARTER + left, QUARTER - left
        parts = (
            product(cos(co_u), cos(v), cos(less), cos(co_whole)),
            product(cos(co_v), cos(u), cos(more), cos(co_whole)),
            product(cos(QUARTER), cos(left), cos(more), cos(less)),
        )
        factors = [as_term(Fraction(sign, 2)) for sign in (-1, -1, 1)]
        sine = self.lemma(
            equal(sin(whole), sin(u) * cos(v) + cos(u) * sin(v)),
            _by(parts, factors, self.as_cosine(whole), law_u, law_v, zero),
        )
        return cosine, sine

    def opposite(self, whole: Term, u: Term) -> tuple[str, str]:
        """The cosine and the sine of -u."""
        cosine = self.relations.written(cos(whole), cos(u), same=False)
        turned = QUARTER + u
        law = self.lemma(equal(sin(whole), cos(turned)), Law())
        product = self.relations.product(cos(QUARTER), cos(u), cos(turned), cos(QUARTER - u))
        using = law, self.as_cosine(u), self.quarter()
        sine = equal(sin(whole), -sin(u))
        return cosine, self.lemma(sine, _by([product], [as_term(-1)], *using))

    def squares(self, angle: Term) -> str:
        """The law of the squares of sine and cosine."""
        return self.lemma(equal(sin(angle) ** 2 + cos(angle) ** 2, ONE), Law())

    # --- inverse tangents -----------------------------------------------------------------------

    def slope(self, angle: Term) -> tuple[str, str]:
        """The law of sine and cosine of an inverse tangent, and the square of the cosine."""
        (t,) = angle.children
        law = self.lemma(equal(sin(angle), t * cos(angle)), Law())
        square = equal((ONE + t**2) * cos(angle) ** 2, ONE)
        return law, self.from_one(square, self.squares(angle), (law,))

    def twice(self, whole: Term, angle: Term) -> tuple[str, str] | None:
        """The cosine and the sine of twice an inverse tangent, as quotients."""
        (t,) = angle.children
        below = ONE + t**2
        if not self.known.clears((t / below,), self.place):
            return None
        (law, square), (cosine, sine) = self.slope(angle), self.sum(whole, angle, angle)
        return (
            self.from_one(equal(cos(whole), (ONE - t**2) / below), square, (cosine, law)),
            self.from_one(equal(sin(whole), 2 * t / below), square, (sine, law)),
        )

    def once(self, angle: Term) -> tuple[str, str] | None:
        """The cosine and the sine of an inverse tangent, with a root."""
        (t,) = angle.children
        root, clearing = sqrt(ONE + t**2), Clearing((t,), {})
        positive, scale = positive_cosine(self.question, angle), self._denominator(clearing, t)
        if not positive or not scale or not self.known.clears((ONE / root,), self.place):
            return None
        law, square = self.slope(angle)
        value = product_of("goal", ("add", ("mul", positive, ("root", root)), "1"), scale)
        above, below = (Sum((value,), (), ((square, as_term(sign)),)) for sign in (-1, 1))
        return self.lemma(equal(cos(angle), ONE / root), Antisymmetry((above, below))), law

    def _denominator(self, clearing: Clearing, t: Term) -> Value | None:
        """The square of the denominator of a term, as a value; 1 if it has none."""
        below = clearing.clear(t)[1]
        if below.is_constant():
            return "1"
        fact = self.question.fact(Claim("<", ZERO, clearing.term(below)))
        return None if fact is None else ("pow", fact, 2)


def _by(equations: Sequence[str], factors: Sequence[Term], *using: str) -> Sum:
    """A proof of an equation by others, after each atom is replaced by one of ``using``."""
    return Sum((), (*dict.fromkeys(using),), tuple(zip(equations, factors, strict=True)))


def positive_cosine(question: Question, angle: Term) -> str | None:
    """The fact that the cosine of an angle is positive, if it lies between quarter turns."""
    claim, place = Claim("<", ZERO, cos(angle)), question.goal.context
    known = question.session.known(claim, place)
    if known is None:
        proof = _positive_cosine(question, angle)
        known = None if proof is None else question.session.lemma(claim, proof, place)
    return known


def _positive_cosine(question: Question, angle: Term) -> Proof | None:
    """The cosine of an angle between quarter turns, to both sides of 0, is positive."""
    facts, place = Facts(question), question.goal.context
    low, high = _ends(question, angle)
    if low is None or high is None or not question.known.clears((angle / pi,), place):
        return None
    positive, branches = facts.pi(), []
    for sign, fact in ((-1, low), (1, high)):
        turned = angle if sign == 1 else -angle
        u = as_term(HALF) - (angle / pi if sign == 1 else -(angle / pi))
        first, third = SERIES
        bound = u * (as_term(first) + u**2 * as_term(-third))
        below = Term("cos_pi", as_term(HALF) - u)
        using = [facts.lemma(equal(cos(turned), below), Law())]
        if sign == -1:
            using.insert(0, facts.relations.written(cos(angle), cos(turned), same=False))
        rest = Claim("<", ZERO, as_term(first) + u**2 * as_term(-third))
        why = Sum(
            (
                "goal",
                product_of(str(first - third / 4), ("pow", positive, 2)),
                product_of(str(third), "@1", ("add", "@2", ("mul", "1/2", positive))),
            )
        )
        last = Sum((product_of("goal", ("pow", positive, 3)), "@3", ("mul", "@2", "@4")), (*using,))
        chain: Proof = Have(rest, (why, last))
        chain = Have(Claim("<=", bound, below), (Cosine(), chain))
        branches.append(Have(Claim("<", ZERO, u), (Sum(("goal", fact)), chain)))
    return Cuts(angle, (Fraction(0),), (branches[0], branches[1]))


def _ends(question: Question, angle: Term) -> tuple[str | None, str | None]:
    """The facts that an angle lies between quarter turns."""
    place = question.goal.context
    claims = Claim("<", -QUARTER, angle), Claim("<", angle, QUARTER)
    if angle.op == "atan" and question.known.clears((angle,), place):
        for claim in claims:
            question.session.ensure(claim, InRange(), place)
    low, high = (question.session.known(claim, place) for claim in claims)
    return low, high


class Normal:
    """Sines and cosines in some terms as what they are in those of generators.

    ``used`` names the equations, each of an atom, and ``replaced`` has what they say.
    """

    def __init__(self, question: Question, terms: Sequence[Term]) -> None:
        self.facts, self.question = Facts(question), question
        self.used: dict[str, None] = {}
        self.replaced: dict[Term, Term] = {}
        self.generators: dict[Term, None] = {}
        self.done: set[Angle] = set()
        atoms = [atom for atom in atoms_of(terms, {}) if atom.op in TRIGONOMETRIC]
        atoms = [atom for atom in atoms if not _is_ground_cosine(atom)]
        self.is_algebraic = bool(atoms)
        parts = {atom: found for atom in atoms if (found := _parts(atom)) is not None}
        steps = _steps(list(parts.values()))
        for atom, found in parts.items():
            self._atom(atom, tuple(_multiples(found, steps)))
        self.is_algebraic &= len(parts) == len(atoms) and not self.generators

    def _use(self, name: str) -> None:
        claim = self.question.session.claims[name]
        if claim.lhs not in self.replaced and claim.lhs != claim.rhs:
            self.used[name] = None
            self.replaced[claim.lhs] = claim.rhs

    def _atom(self, atom: Term, angle: Angle) -> None:
        """Afterwards the atom is replaced, if its angle is not one generator."""
        if sum(abs(n) for _, n in angle) > MAX_MULTIPLES:
            raise TooLongError
        (own,), whole = atom.children, _written(angle)
        if atom.op == "cos_pi":
            law = self.facts.lemma(equal(cos(whole), atom), Law())
            turned = equal(atom, cos(whole))
            self._use(self.facts.lemma(turned, Sum((), (), ((law, as_term(-1)),))))
        elif own != whole:
            self._use(self.facts.lemma(equal(atom, Term(atom.op, whole)), Monotony(Sum(()))))
        self._angle(angle)

    def _angle(self, angle: Angle) -> None:
        """Afterwards the sine and the cosine of an angle are known in those of generators."""
        if angle in self.done:
            return
        self.done.add(angle)
        whole, facts = _written(angle), self.facts
        if not angle:
            self._use(facts.relations.exact(cos(ZERO), 1))
            using = facts.as_cosine(ZERO), facts.quarter()
            same_angle = facts.lemma(equal(cos(QUARTER - ZERO), cos(QUARTER)), Monotony(Sum(())))
            zero = Sum((), (using[0], same_angle, using[1]))
            self._use(facts.lemma(equal(sin(ZERO), ZERO), zero))
            return
        if len(angle) == 1:
            ((generator, n),) = angle
            if self._generated(generator, n, whole):
                return
            if n < 0:
                other = ((generator, -n),)
                self._both(facts.opposite(whole, _written(other)))
                self._angle(other)
                return
            halves: tuple[Angle, Angle] = ((generator, n - n // 2),), ((generator, n // 2),)
        else:
            halves = angle[: len(angle) // 2], angle[len(angle) // 2 :]
        self._both(facts.sum(whole, *map(_written, halves)))
        for half in halves:
            self._angle(half)

    def _both(self, names: tuple[str, str]) -> None:
        for name in names:
            self._use(name)

    def _generated(self, generator: Term, n: int, whole: Term) -> bool:
        """Whether the sine and the cosine of a multiple of a generator are known by themselves."""
        if generator == QUARTER and n == 1:
            self._use(self.facts.quarter())
            sine = self.facts.lemma(equal(sin(QUARTER), cos(ZERO)), Law())
            self._use(sine)
            self._use(self.facts.relations.exact(cos(ZERO), 1))
            return True
        if generator.op == "atan" and n in (1, 2):
            found = self.facts.once(whole) if n == 1 else self.facts.twice(whole, generator)
            if found is not None:
                self._both(found)
                return True
        if n == 1:
            self.generators[generator] = None
        return n == 1

    def identity(self, claim: Claim) -> Proof | None:
        """A proof of an equation, if both sides are the same."""
        if not self.replaced and not self.generators:
            return None
        laws = [self.facts.squares(g) for g in self.generators]
        sides = [side for law in laws for side in self.question.session.claims[law].key[1:]]
        clearing = Clearing((*claim.key[1:], *sides), self.replaced)
        rest = clearing.difference(claim.lhs, claim.rhs)
        equations = []
        for generator, law in zip(self.generators, laws, strict=True):
            rest, factor = without_squares(rest, clearing, sin(generator), cos(generator))
            if not factor.is_zero():
                equations.append((law, clearing.term(factor)))
        if not clearing.reduce(rest).is_zero():
            return None
        if not self.question.known.clears(claim.key[1:], self.question.goal.context):
            return None
        return Sum((), (*self.used,), tuple(equations))


def _is_ground_cosine(atom: Term) -> bool:
    """Whether this is a number that intervals know exactly."""
    return atom.op == "cos_pi" and atom.children[0].op == "rational"


def without_squares(
    p: fmpq_mpoly, clearing: Clearing, sine: Term, cosine: Term
) -> tuple[fmpq_mpoly, fmpq_mpoly]:
    """The polynomial with 1 - cos^2 for sin^2, and what it is less by, over sin^2 + cos^2 - 1.

    Sine and cosine may be exchanged.
    """
    ring = clearing.context
    s, c = clearing.generators[sine], clearing.generators[cosine]
    index = clearing.atoms.index(sine)
    factor = ring.constant(0)
    parts = coefficients(p, index)
    for power in range(max(parts, default=0), 1, -1):
        part = parts.pop(power, None)
        if part is not None and not part.is_zero():
            factor += part * s ** (power - 2)
            lower = part * (1 - c**2)
            parts[power - 2] = parts[power - 2] + lower if power - 2 in parts else lower
    rest = ring.constant(0)
    for power, part in parts.items():
        rest += part * s**power
    return rest, factor


def _parts(atom: Term) -> dict[Term, Fraction] | None:
    """The angle of a sine or cosine as a sum of multiples."""
    (angle,) = atom.children
    return linear_parts(pi * angle if atom.op == "cos_pi" else angle)


def _steps(angles: Sequence[Mapping[Term, Fraction]]) -> dict[Term, Fraction]:
    """For each part of some angles the number of whose multiples all its factors are."""
    steps: dict[Term, Fraction] = {}
    for part in {part: None for found in angles for part in found}:
        factors = [found[part] for found in angles if part in found]
        if part == pi:
            factors = [rest for f in factors if (rest := f - Fraction(round(2 * f), 2))]
        if factors:
            above = 1 if part.op == "atan" else gcd(*(f.numerator for f in factors))
            steps[part] = Fraction(above, lcm(*(f.denominator for f in factors)))
    return steps


def _multiples(
    parts: Mapping[Term, Fraction], steps: Mapping[Term, Fraction]
) -> Iterator[tuple[Term, int]]:
    """How often each generator is in an angle."""
    for part, factor in parts.items():
        if part == pi:
            turns = round(2 * factor)
            factor -= Fraction(turns, 2)
            if turns:
                yield QUARTER, turns
        if factor:
            yield step_of(part, steps[part]), int(factor / steps[part])


def _written(angle: Angle) -> Term:
    """An angle as a term."""
    found: Term | None = None
    for generator, n in angle:
        part = generator if n == 1 else as_term(n) * generator
        found = part if found is None else found + part
    return ZERO if found is None else found


class Angles:
    """Equations between sums of multiples of inverse tangents and of pi."""

    def __init__(self, question: Question) -> None:
        self.question, self.facts = question, Facts(question)

    def proof(self, claim: Claim) -> Proof | None:
        """Both orders, if the sine of the difference is 0 and it is less than two quarter turns."""
        parts = linear_parts(claim.lhs - claim.rhs)
        if not parts or all(part.op != "atan" for part in parts):
            return None
        scale = lcm(*(factor.denominator for factor in parts.values()))
        multiples = [(part, int(factor * scale)) for part, factor in parts.items()]
        multiples = [(QUARTER, 2 * n) if part == pi else (part, n) for part, n in multiples]
        half = as_term(HALF) * _written(tuple(multiples))
        ends = self._ends(half, multiples)
        if ends is None or not self._has_zero_sine(half, multiples):
            return None
        orders = [self._order(half, scale, sign, ends) for sign in (1, -1)]
        fact = self.facts.lemma(claim, Antisymmetry((orders[0], orders[1])))
        return Sum((), (), ((fact, ONE),))

    def _has_zero_sine(self, half: Term, multiples: Sequence[tuple[Term, int]]) -> bool:
        """Whether sin of twice the half is 0: afterwards 2 sin cos of the half is, in a fact."""
        facts, whole = self.facts, _written(tuple(multiples))
        normal = Normal(self.question, (sin(whole),))
        proof = normal.identity(equal(sin(whole), ZERO))
        if proof is None:
            return False
        zero = facts.lemma(equal(sin(whole), ZERO), proof)
        _, sine = facts.sum(half + half, half, half)
        law = facts.lemma(equal(sin(half + half), sin(whole)), Monotony(Sum(())))
        self.zero = facts.lemma(
            equal(sin(half) * cos(half), ZERO),
            Sum((), (zero,), ((law, as_term(HALF)), (sine, as_term(-HALF)))),
        )
        return True

    def _ends(self, half: Term, multiples: Sequence[tuple[Term, int]]) -> tuple[str, str] | None:
        """The facts that the half lies between quarter turns."""
        facts = self.facts
        low, high = Claim("<", -QUARTER, half), Claim("<", half, QUARTER)
        found = [facts.known.ground.prove(c) for c in (low, high)] if self._is_ground() else []
        if found:
            proofs = [proof for verdict, proof in found if verdict == "proved"]
            names = [facts.lemma(c, p) for c, p in zip((low, high), proofs, strict=False) if p]
            return (names[0], names[1]) if len(names) == 2 else None
        if any(part != QUARTER and part.op != "atan" for part, _ in multiples):
            first = self.question.fact(low)
            second = None if first is None else self.question.fact(high)
            return (first, second) if first and second else None
        sums = []
        for claim, side in ((low, -1), (high, 1)):
            total, addends = Fraction(0), []
            for part, n in multiples:
                share = Fraction(abs(n), 2)
                if part == QUARTER:
                    total += side * Fraction(n, 2)
                    continue
                name, end = self._end(part, is_above=(n > 0) == (side > 0))
                total += share * end
                addends.append(product_of(str(share), name))
            slack = 1 - total
            if slack < 0:
                return None
            if slack:
                addends.append(product_of(str(slack / 2), facts.pi()))
            sums.append(facts.lemma(claim, Sum(("goal", *addends))))
        return sums[0], sums[1]

    def _is_ground(self) -> bool:
        return not self.question.goal.variables and not self.question.goal.definitions

    def _end(self, angle: Term, *, is_above: bool) -> tuple[str, int]:
        """A fact that an inverse tangent is less than an end, which is so many quarter turns."""
        facts, (t,) = self.facts, angle.children
        sides = (t, ZERO) if is_above else (ZERO, t)
        inner = facts.known.fact(Claim("<", *sides), facts.place)
        if inner is not None:
            zero = facts.lemma(equal(atan(ZERO), ZERO), Interval(BITS))
            sides = (angle, atan(ZERO)) if is_above else (atan(ZERO), angle)
            rises = facts.lemma(Claim("<", *sides), Monotony(inner))
            sides = (angle, ZERO) if is_above else (ZERO, angle)
            return facts.lemma(Claim("<", *sides), Sum(("goal", rises), (zero,))), 0
        sides = (angle, QUARTER) if is_above else (-QUARTER, angle)
        return facts.lemma(Claim("<", *sides), InRange()), 1

    def _order(self, half: Term, scale: int, sign: int, ends: tuple[str, str]) -> Proof:
        """A proof that the one side is at most the other: ``turned`` is a multiple of the goal.

        If it were positive its sine would be, and the cosine is; but their product is 0.
        """
        facts, turned = self.facts, half if sign == 1 else -half
        above, positive = facts.pi(), positive_cosine(self.question, half) or ""
        facts.known.clears((turned / pi,), facts.place)
        u, (first, third) = turned / pi, SERIES
        rest = as_term(first) + u**2 * as_term(-third)
        below, cosine = Term("cos_pi", as_term(HALF) - u), cos(QUARTER - turned)
        using, zero = [facts.as_cosine(turned)], self.zero
        if sign == -1:
            _, sine = facts.opposite(turned, half)
            zero = facts.from_one(equal(sin(turned) * cos(half), ZERO), zero, (sine,))
        zero = facts.from_one(equal(cosine * cos(half), ZERO), zero, using)
        square = product_of(str(first - third / 4), ("pow", above, 2))
        why = Sum(("goal", square, product_of(str(third), ("mul", *ends))))
        fact = facts.lemma(Claim("<", ZERO, rest), why)
        value = product_of(str(Fraction(scale, 2)), "goal", fact, positive)
        law = facts.lemma(equal(cosine, below), Law())
        last = Sum((value, ("mul", "@3", positive)), (law,), ((zero, -(pi**3)),))
        inner: Proof = Have(Claim("<=", u * rest, below), (Cosine(), last))
        inner = Have(Claim("<=", ZERO, u), (Sum(("goal", "@1")), inner))
        easy = Sum(("goal", product_of(str(Fraction(2, scale)), "@1")))
        return Cuts(turned, (Fraction(0),), (easy, inner))
