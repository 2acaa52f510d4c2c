"""Polynomials in squares of variables: their squares become the variables, of half the degrees."""

from __future__ import annotations

from fractions import Fraction

from flint import fmpq_mpoly

from verify.language.terms import Claim, as_term, symbol
from verify.prover.clearing import Clearing, expanded
from verify.prover.goal import Bounds
from verify.prover.proof import Proof, Value
from verify.prover.rules import Define, Sum
from verify.prover.search.bernstein_boxes import by_bernstein
from verify.prover.search.question import Question
from verify.prover.session import ZERO

PARTS = 200


def by_even_powers(question: Question) -> Proof | None:
    """A proof in the squares of all variables, which lie between numbers that are not negative."""
    goal, clearing = question.goal, question.clearing
    p = clearing.difference(goal.claim.rhs, goal.claim.lhs)
    names = [atom.name if atom.op == "symbol" else "" for atom in clearing.atoms]
    if not all(_is_usable(goal.variables.get(name)) for name in names):
        return None
    if any(power % 2 for monomial in p.to_dict() for power in monomial):
        return None
    undo = question.known.mark()
    squares = {name: _square(question, name, goal.variables[name]) for name in names}
    atoms = [symbol(square) for square, _ in squares.values()]
    claim = Claim(goal.claim.relation, ZERO, expanded(_halved(clearing, p), atoms))
    variables = dict(squares.values())
    halved = Question(
        goal._replace(claim=claim, variables=variables, definitions={}), question.known
    )
    proof = by_bernstein(halved, PARTS)
    if proof is None:
        undo()
        return None
    lemma = question.session.lemma(claim, proof, goal.context)
    return Sum(("goal", lemma), (*variables, *question.using))


def _is_usable(bounds: Bounds | None) -> bool:
    return bounds is not None and bounds.interval is not None and bounds.interval[0] >= 0


def _halved(clearing: Clearing, p: fmpq_mpoly) -> fmpq_mpoly:
    parts = {tuple(int(k) // 2 for k in monomial): c for monomial, c in p.to_dict().items()}
    return clearing.context.from_dict(parts)


def _square(question: Question, name: str, bounds: Bounds) -> tuple[str, Bounds]:
    """A new constant for the square of a variable, with the facts that bound it."""
    session, place = question.session, question.goal.context
    low, high = bounds.interval or (Fraction(0), Fraction(0))
    square = session.fresh()
    session.define(square, symbol(name) ** 2, Define(), place)
    below, above = bounds.low_fact, bounds.high_fact
    # y^2 - a^2 = (y - a)^2 + 2a (y - a) and b^2 - y^2 = (b - y) ((y - a) + (a + b))
    first: Value = ("add", ("pow", below, 2), ("mul", str(2 * low), below))
    last: Value = ("mul", above, ("add", below, str(low + high)))
    facts = []
    for sides, value in (
        ((as_term(low * low), symbol(square)), first),
        ((symbol(square), as_term(high * high)), last),
    ):
        proof = Sum(("goal", value), (square,))
        facts.append(session.lemma(Claim("<=", *sides), proof, place))
    return square, Bounds(low * low, high * high, facts[0], facts[1], "<=", "<=")
