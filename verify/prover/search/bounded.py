"""Claims that are linear in a variable or a function which is bounded: shown with the bound there.

From a <= exp(-k) follows a <= 1, since exp(-k) <= 1. If the difference of the sides is p + q a with
q < 0, and a <= T, it is at least p + q T. If it is c + d f for numbers c and d and a function f,
what is left to show compares f with a number, which rules about functions may do.
"""

from __future__ import annotations

from collections.abc import Iterator
from fractions import Fraction

from flint import fmpq_mpoly

from verify.language.terms import Claim, Term, as_term, names_of, parts_of, substitute_claim, symbol
from verify.prover.balls import fraction_of
from verify.prover.clearing import TooLongError, coefficients, expanded, variables_in
from verify.prover.multiple import scale
from verify.prover.proof import Proof, Value, product_of
from verify.prover.rules import Sum
from verify.prover.search.question import Question

FUNCTIONS = ("exp", "log", "atan", "sin", "cos", "cos_pi")
#: What one lemma may cost.
UNITS = 8_000_000


def by_bounds(question: Question) -> Proof | None:
    """The claim follows from the one with a bound in place of a variable, or about one function."""
    p = None if question.goal.definitions else _difference(question)
    if p is None:
        return None
    found = _by_function(question, p)
    for name in sorted(question.goal.variables) if found is None else ():
        q = _factor(question, p, name)
        if q is None:
            continue
        for fact, bound in _bounds(question, name):
            found = _with_bound(question, q, name, fact, bound)
            if found is not None:
                return found
    return found


def _difference(question: Question) -> fmpq_mpoly | None:
    """That of the sides, as a polynomial in atoms; None if it is none."""
    claim = question.goal.claim
    try:
        p, below = question.clearing.clear(claim.rhs - claim.lhs)
    except TooLongError:
        return None
    return p / below.leading_coefficient() if below.is_constant() else None


def _by_function(question: Question, p: fmpq_mpoly) -> Proof | None:
    """A comparison of a function with a number."""
    inside = variables_in(p)
    if len(inside) != 1 or p.total_degree() != 1:
        return None
    atom, parts = question.clearing.atoms[inside[0]], coefficients(p, inside[0])
    factor = fraction_of(parts[1].leading_coefficient())
    rest = parts.get(0)
    number = as_term(-(fraction_of(rest.leading_coefficient()) if rest else Fraction(0)) / factor)
    sides = (number, atom) if factor > 0 else (atom, number)
    claim = Claim(question.goal.claim.relation, *sides)
    if atom.op not in FUNCTIONS or claim == question.goal.claim:
        return None
    return question.from_fact(question.goal.claim, question.fact(claim), question.using)


def _factor(question: Question, p: fmpq_mpoly, name: str) -> fmpq_mpoly | None:
    """By what a variable is multiplied, if the difference of the sides is linear in it."""
    atoms, variable = question.clearing.atoms, symbol(name)
    others = (atom for atom in atoms if atom != variable)
    if variable not in atoms or any(name in names_of(atom) for atom in others):
        return None
    parts = coefficients(p, atoms.index(variable))
    return parts.get(1) if parts.keys() <= {0, 1} else None


def _bounds(question: Question, name: str) -> Iterator[tuple[str, Term]]:
    """Facts that bound a variable by terms with functions, which sums of products leave alone."""
    variable = symbol(name)
    for fact, claim in question.facts.items():
        for side, bound in ((claim.lhs, claim.rhs), (claim.rhs, claim.lhs)):
            is_new = side == variable and name not in names_of(bound)
            if is_new and any(part.op in FUNCTIONS for part in parts_of(bound)):
                yield fact, bound


def _with_bound(
    question: Question, q: fmpq_mpoly, name: str, fact: str, bound: Term
) -> Proof | None:
    """The claim with a bound in place of the variable, and the bound times its factor."""
    known = question.session.claims[fact]
    part = -q if known.lhs == symbol(name) else q  # an upper bound: q has to be negative
    claim, value = question.goal.claim, _positive(question, part)
    if value is None:
        return None
    is_strict = known.relation == "<" and part.is_constant()
    relation = "<=" if is_strict else claim.relation
    there = substitute_claim(Claim(relation, claim.lhs, claim.rhs), {name: bound})
    shown = None
    with question.budget.at_most(UNITS):
        shown = question.fact(there)
    if shown is None:
        return None
    replaced = question.session.replaced(question.using)
    whole, first, second = (scale(one, replaced) for one in (claim, there, known))
    if whole is None or first is None or second is None:
        return None
    shares = str(whole / first), str(whole / second)
    return Sum(
        ("goal", product_of(shares[0], shown), product_of(shares[1], value, fact)), question.using
    )


def _positive(question: Question, part: fmpq_mpoly) -> Value | None:
    """The value of a number above 0, or of a term that is at least 0."""
    if not part.is_constant():
        return question.lemma("<=", part, expanded(part, question.clearing.atoms))
    number = fraction_of(part.leading_coefficient())
    return str(number) if number > 0 else None
