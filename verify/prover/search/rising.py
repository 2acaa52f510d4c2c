"""Claims about functions that rise, by what they are of; and about roots, by their powers.

A root s of the index n, with s^n = A, is compared with B by B^n - A. If s = B + G for a number G
that the negation of s <= B says is > 0, then

    A - B^n = s^n - B^n = n B^(n-1) G + ... + G^n,

and the same with s and B exchanged.
"""

from __future__ import annotations

from collections.abc import Iterator
from fractions import Fraction
from math import comb

from flint import fmpq_mpoly

from verify.language.fold import replaced
from verify.language.terms import Claim, Term, as_term, equal, exp, log, names_of, parts_of
from verify.prover.balls import fmpq_of, fraction_of
from verify.prover.clearing import ROOTS, Clearing, TooLongError, atoms_of, coefficients, index_of
from verify.prover.proof import Proof, Value, power_of, product_of
from verify.prover.rules import Monotony, Sum
from verify.prover.search.question import Question

EQUATED = ("exp", "log", "atan", "sin", "cos", "cos_pi", *ROOTS)
RISING = ("exp", "log", "atan", *ROOTS)
#: The value of a function that rises at a number, and this number.
VALUES = {"exp": (1, 0), "log": (0, 1), "atan": (0, 0)}


def by_monotony(question: Question) -> Proof | None:
    """Both sides are the same function, which rises, or one is its value at a number."""
    claim = question.plain.claim
    if claim.relation not in ("<", "<="):
        return None
    whole = Claim(claim.relation, _valued(claim.lhs, claim.rhs), _valued(claim.rhs, claim.lhs))
    (f, *a), (g, *b) = ((side.op, *side.args[1:]) for side in (whole.lhs, whole.rhs))
    if f not in RISING or (f, a) != (g, b):
        return None
    fact = question.fact(Claim(claim.relation, whole.lhs.children[0], whole.rhs.children[0]))
    if fact is None or whole == claim:
        return None if fact is None else Monotony(fact)
    sides = ((whole.lhs, claim.lhs), (whole.rhs, claim.rhs))
    equation = next(question.fact(equal(*pair)) for pair in sides if pair[0] != pair[1])
    if equation is None:
        return None
    home = question.known.home(whole, question.goal.context)
    rises = question.session.lemma(whole, Monotony(fact), home)
    return Sum(("goal", rises), (equation,))


def _valued(side: Term, other: Term) -> Term:
    """The side, or for 1 beside an exponential (and the like) the same function of a number.

    Beside an exponential a product or quotient of others is an exponential, too.
    """
    value, at = VALUES.get(other.op, (None, 0))
    if other.op == "exp" and side.op in ("mul", "div", "pow"):
        found = _exponential(side)
        is_other = found is not None and found[0] == as_term(1) and found[1] not in parts_of(side)
        return found[1] if found is not None and is_other else side
    if side.op != "rational" or side.value != value or not names_of(other):
        return side
    return Term(other.op, as_term(at))


def _exponential(product: Term) -> tuple[Term, Term] | None:
    """What stands before the exponential in a product with exponentials, and this one.

    None if there is no exponential, or another one in what stands before it.
    """
    try:
        clearing = Clearing((product,), {})
        parts = [*clearing.clear(product)]
    except TooLongError:
        return None
    total: Term | None = None
    for index, atom in enumerate(clearing.atoms):
        if atom.op != "exp":
            continue
        for i, sign in ((0, 1), (1, -1)):
            powers = coefficients(parts[i], index)
            if len(powers) != 1:
                return None
            (power,) = powers
            if power:
                parts[i] = powers[power]
                exponent = _times(sign * power, atom.children[0])
                total = exponent if total is None else total + exponent
    if total is None:
        return None
    above, below = map(clearing.term, parts)
    return (above if below == as_term(1) else above / below), exp(total)


def _times(number: int, term: Term) -> Term:
    return term if number == 1 else -term if number == -1 else as_term(number) * term


def _logarithm(side: Term) -> Term | None:
    """The logarithm of a product with exponentials."""
    found = _exponential(side)
    if found is None:
        return None
    exponent: Term = found[1].children[0]
    return exponent if found[0] == as_term(1) else log(found[0]) + exponent


def by_logarithms(question: Question) -> Proof | None:
    """One side is a product with an exponential, and both are positive."""
    claim, known, place = question.plain.claim, question.known, question.goal.context
    if claim.relation not in ("<", "<="):
        return None
    sides = (claim.lhs, claim.rhs)
    if all((pair := _exponential(side)) and pair[0] == as_term(1) for side in sides):
        return None  # monotony compares these
    found = [_logarithm(side) for side in sides]
    is_moving = [any(part.op == "exp" and [*names_of(part)] for part in parts_of(s)) for s in sides]
    wanted = [log(side) if f is None else f for side, f in zip(sides, found, strict=True)]
    if all(f is None or not moves for f, moves in zip(found, is_moving, strict=True)):
        return None
    if not known.clears((*map(log, sides), *wanted), place):
        return None
    fact = question.fact(Claim(claim.relation, *wanted))
    if fact is None:
        return None
    pairs = [(log(side), f) for side, f in zip(sides, wanted, strict=True) if log(side) != f]
    laws = [question.fact(equal(*pair)) for pair in pairs]
    using = tuple(law for law in laws if law is not None)
    return Monotony(Sum(("goal", fact), using), "log") if len(using) == len(laws) else None


def by_same_arguments(question: Question) -> Proof | None:
    """The claim with one function for all whose arguments are equal, or equal to a number."""
    claim = question.plain.claim
    equations, chosen = dict[Term, str](), dict[Term, Term]()
    seen: dict[tuple[str, object, str], Term] = {}
    atoms = atoms_of((claim.lhs, claim.rhs), {})
    inner = {a for atom in atoms for a in atoms_of(atom.children, {})}
    for atom in atoms:
        if atom.op not in EQUATED or atom in inner or atom.children[0].op in ("rational", "symbol"):
            continue
        other = _same(question, seen, atom)
        name = None if other is None else _equation(question, atom, other)
        if name is not None and other is not None:
            equations[atom], chosen[atom] = name, other
    if not chosen:
        return None
    sides = [replaced(side, chosen) for side in (claim.lhs, claim.rhs)]
    return question.from_fact(
        claim, question.fact(Claim(claim.relation, *sides)), equations.values()
    )


def _same(question: Question, seen: dict[tuple[str, object, str], Term], atom: Term) -> Term | None:
    """What was seen before and is equal to this function; or it is one of a number."""
    argument = atom.children[0]
    number = None if [*names_of(argument)] else question.known.ground.exact(argument)
    if number is not None:
        return Term(atom.op, as_term(number), *atom.args[1:])
    try:
        clearing = Clearing((argument,), {})
        above, below = clearing.clear(argument)
    except TooLongError:
        return None
    if below.is_zero():
        return None
    common = above.gcd(below) * below.leading_coefficient()
    above, below = above / common, below / common
    if above.is_constant() and below.is_constant():
        value = Fraction(0) if above.is_zero() else fraction_of(above.leading_coefficient())
        return Term(atom.op, as_term(value), *atom.args[1:])
    terms = clearing.term(above), clearing.term(below)
    key = (atom.op, terms, str(atom.args[1:]))
    first = seen.setdefault(key, atom)
    return None if first is atom else first


def _equation(question: Question, atom: Term, other: Term) -> str | None:
    """The fact that two functions are equal, as their arguments are."""
    claim, place = equal(atom, other), question.goal.context
    known = question.session.known(claim, place)
    if known is not None:
        return known
    inner = question.fact(equal(atom.children[0], other.children[0]))
    if inner is None or not question.known.clears((atom, other), place):
        return None
    return question.session.lemma(claim, Monotony(inner), question.known.home(claim, place))


def by_powers(question: Question) -> Proof | None:
    """A root with a number before it and no other function of it, by its power."""
    powers = Powers(question)
    found = (powers.proof(root, factor, rest) for root, factor, rest in powers.isolated())
    return next(filter(None, found), None)


class Powers:
    """One claim, cleared; of functions no powers above the fourth are taken."""

    def __init__(self, question: Question) -> None:
        self.question, self.clearing = question, question.clearing
        self.relation = question.goal.claim.relation

    def isolated(self) -> Iterator[tuple[Term, Fraction, fmpq_mpoly]]:
        """Each root r inside no other atom with q and P, where the sides differ by P + q r."""
        claim, clearing = self.question.goal.claim, self.clearing
        p = clearing.difference(claim.rhs, claim.lhs)
        atoms = [a for a, d in zip(clearing.atoms, p.degrees(), strict=True) if d > 0]
        inside = {a for atom in atoms for child in atom.children for a in atoms_of((child,), {})}
        functions = {"exp", "log", "atan", "sin", "cos", "cos_pi"}
        moves = any(a.op in functions and bool([*names_of(a)]) for a in atoms)
        roots = (a for a in atoms if a.op in ROOTS and a not in inside)
        for atom in (a for a in roots if index_of(a) <= 4 or not moves):
            parts = coefficients(p, clearing.atoms.index(atom))
            factor = parts.get(1)
            if parts.keys() <= {0, 1} and factor is not None and factor.is_constant():
                rest = parts.get(0, clearing.one - clearing.one)
                yield atom, fraction_of(factor.leading_coefficient()), rest

    def proof(self, root: Term, factor: Fraction, rest: fmpq_mpoly) -> Proof | None:
        """A proof that r <= B, or B <= r, for B = -P/q."""
        bound, power = -rest / fmpq_of(factor), index_of(root)
        radicand, denominator = self.clearing.clear(root.children[0])
        if denominator != self.clearing.one:
            return None
        try:
            whole = self.clearing.power(bound, power)
            difference = self.clearing.reduce(whole) - radicand
        except TooLongError:
            return None
        if difference + radicand != whole and self._has_denominators():
            return None
        smaller: Value | None = ("root", root)
        if factor < 0:
            smaller = self._lemma("<=", bound)
        else:
            difference = -difference
        last = None if smaller is None else self._lemma(self.relation, difference)
        if smaller is None or last is None:
            return None
        gap = product_of(str(1 / abs(factor)), "goal")
        addends = (self._addend(smaller, gap, power, k) for k in range(1, power + 1))
        return Sum((*addends, last), self.question.using)

    def _has_denominators(self) -> bool:
        """Whether a root may be one of a quotient: a polynomial is multiplied to reduce it."""
        roots = (atom for atom in self.clearing.atoms if atom.op in ROOTS)
        return any(self.clearing.clear(r.children[0])[1] != self.clearing.one for r in roots)

    def _addend(self, smaller: Value, gap: Value, power: int, k: int) -> Value:
        """One term of the difference of two powers."""
        factors = [str(comb(power, k)), power_of(gap, k)]
        return product_of(*factors, *([power_of(smaller, power - k)] if k < power else []))

    def _lemma(self, relation: str, polynomial: fmpq_mpoly) -> Value | None:
        return self.question.lemma(relation, polynomial, self.clearing.term(polynomial))
