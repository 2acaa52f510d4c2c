"""Claims whose parts have variables of their own: each part is enclosed first, as a number.

A part S of a claim gets a name u = S and two facts, low <= u and u <= high, by trees in its own
variables. What is left is a claim about a few such numbers.
"""

from __future__ import annotations

from collections.abc import Iterator
from fractions import Fraction

from verify.language.fold import replaced
from verify.language.terms import Claim, Term, as_term, names_of, operations_in, symbol
from verify.prover.goal import Bounds
from verify.prover.proof import Proof
from verify.prover.rules import Define, Sum
from verify.prover.search.local_minima import Minima
from verify.prover.search.question import Question
from verify.prover.search.tree import Tree
from verify.prover.session import ZERO

#: Parts with fewer operations are left as they are.
LEAST_SIZE = 6
MAX_PARTS = 4
#: What the enclosure of a part is wider by, as a share of it.
MARGINS = (Fraction(1, 20), Fraction(1, 200), Fraction(1, 2000))
LEAVES = 3000


def by_subterms(question: Question) -> Proof | None:
    """A proof from enclosures of the largest parts that do not have all variables."""
    goal = question.goal
    parts = list(dict.fromkeys(_parts(question, goal.claim.lhs, goal.claim.rhs)))
    if goal.box is None or not 1 <= len(parts) <= MAX_PARTS:
        return None
    ends = [(_least(question, part), _least(question, -part)) for part in parts]
    names = {part: f"u.{i}" for i, part in enumerate(parts)}
    inner = {part: symbol(name) for part, name in names.items()}
    for margin in MARGINS:
        bounds = {}
        for part, (low, high) in zip(parts, ends, strict=True):
            if low is None or high is None:
                return None
            room = (-high - low) * margin
            bounds[names[part]] = Bounds(_short(low - room), _short(-high + room), "low", "high")
        claim = Claim(goal.claim.relation, *(replaced(t, inner) for t in goal.claim.key[1:]))
        rest = {n: b for n, b in goal.variables.items() if n in names_of(claim.lhs, claim.rhs)}
        if Tree(claim, bounds | rest, goal.definitions, question.budget).prove(LEAVES):
            return _written(question, {names[part]: part for part in parts}, bounds, claim, rest)
    return None


def _parts(question: Question, *terms: Term) -> Iterator[Term]:
    """The largest subterms that have some but not all of the variables, and are not small."""
    everything, seen = set(question.goal.variables), set[Term]()
    waiting = [*reversed(terms)]
    while waiting:
        term = waiting.pop()
        own = {*names_of(term)} & everything
        if not own or term in seen:
            continue
        seen.add(term)
        if own < everything and operations_in(term) >= LEAST_SIZE:
            yield term
        else:
            waiting += reversed(term.children)


def _least(question: Question, term: Term) -> Fraction | None:
    goal = question.goal
    variables = {n: b for n, b in goal.variables.items() if n in names_of(term)}
    part = goal._replace(claim=Claim("<=", ZERO, term), variables=variables)
    found = Minima(part, question.budget).found()
    return Fraction(found[0][0]) if found else None


def _short(value: Fraction) -> Fraction:
    """A number with few digits near the value; the room around it is larger."""
    return value.limit_denominator(10**4)


def _written(
    question: Question,
    parts: dict[str, Term],
    bounds: dict[str, Bounds],
    claim: Claim,
    rest: dict[str, Bounds],
) -> Proof | None:
    """The same, with lemmas: first the enclosures, then the claim about them."""
    goal, session = question.goal, question.session
    place = goal.context
    named: dict[str, str] = {}
    known: dict[str, Bounds] = {}
    for name, part in parts.items():
        variables = {n: b for n, b in goal.variables.items() if n in names_of(part)}
        found = []
        for sides in (
            (as_term(bounds[name].low or 0), part),
            (part, as_term(bounds[name].high or 0)),
        ):
            inner = Claim("<=", *sides)
            proof = Tree(inner, variables, goal.definitions, question.budget).prove(LEAVES)
            if proof is None:
                return None
            found.append((inner, session.lemma(inner, proof, place)))
        if not question.known.clears((part,), place):
            return None
        named[name] = session.fresh()
        session.define(named[name], part, Define(), place)
        facts = []
        for inner, lemma in found:
            enclosed = (symbol(named[name]) if t == part else t for t in inner.key[1:])
            proof = Sum(("goal", lemma), (named[name], *question.using))
            facts.append(session.lemma(Claim("<=", *enclosed), proof, place))
        known[named[name]] = bounds[name]._replace(low_fact=facts[0], high_fact=facts[1])
    terms = {symbol(old): symbol(new) for old, new in named.items()}
    outer = Claim(claim.relation, *(replaced(t, terms) for t in claim.key[1:]))
    proof = Tree(outer, known | rest, goal.definitions, question.budget).prove(LEAVES)
    if proof is None:
        return None
    lemma = session.lemma(outer, proof, place)
    return Sum(("goal", lemma), (*known, *question.using))
