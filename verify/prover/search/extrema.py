"""Minima and maxima in claims: by what their entries say, or by cases.

To show lhs <= max(e_1, …) it suffices to show lhs <= e_i where the other entries are below lhs: if
the claim failed all of them would be, as no entry is above the maximum.
"""

from __future__ import annotations

from verify.language.terms import Claim, Term, equal
from verify.prover.multiple import outside_atoms
from verify.prover.proof import Proof, Value
from verify.prover.rules import Antisymmetry, Cases, Entry, Least, Sum
from verify.prover.search.domain import Domain
from verify.prover.search.positive import by_squares
from verify.prover.search.question import Question

#: Claims with more cases are left alone.
MAX_CASES = 64
MAX_ENTRIES = 9
#: Known orders are looked for among so many entries, with so much work for each.
MAX_KNOWN, UNITS_FOR_ORDER = 3, 1_000_000


def by_entries(question: Question) -> Proof | None:
    """The claim for one entry of its maximum (minimum), with the negation of it for the others."""
    facts = question.facts
    claim, names = question.goal.claim, {c: name for name, c in facts.items()}
    for term, is_left in ((claim.rhs, False), (claim.lhs, True)):
        if term.op != ("min" if is_left else "max") or len(term.children) > MAX_ENTRIES:
            continue
        plain = {n: c for n, c in facts.items() if term not in (c.lhs, c.rhs)}
        said = [
            names.get(Claim("<=", *((term, e) if is_left else (e, term)))) for e in term.children
        ]
        if None in said:
            return None
        for i, entry in enumerate(term.children):
            proof = _for_entry(question, plain, [str(name) for name in said], i, entry, is_left)
            if proof is not None:
                return proof
    return None


def _for_entry(
    question: Question,
    facts: dict[str, Claim],
    said: list[str],
    index: int,
    entry: Term,
    is_left: bool,
) -> Proof | None:
    goal = question.goal
    claim, term = goal.claim, goal.claim.lhs if is_left else goal.claim.rhs
    sides = (entry, claim.rhs) if is_left else (claim.lhs, entry)
    # Each of the other entries is beyond the other side: facts in the proof that it builds.
    beyond = {
        f"@{i}": Claim("<", *((claim.rhs, e) if is_left else (e, claim.lhs)))
        for i, e in enumerate(term.children)
        if i != index
    }
    harder = goal._replace(claim=Claim(claim.relation, *sides))
    domain = Domain(harder, {**facts, **beyond}, None, question.is_negative)
    if not domain.is_plain or domain.has_denominators:
        return None
    for i in range(len(term.children)):
        if i != index:
            factor = domain.facts[f"@{i}"]
            value = _renamed(factor.value, f"@{i}", ("add", "goal", said[i]))
            strict = claim.relation == "<="
            domain.facts[f"@{i}"] = factor._replace(value=value, strict=strict)
    domain.goal = ("add", "goal", said[index])
    return by_squares(domain, question.zeros(domain), question.budget, question.using)


def _renamed(value: Value, name: str, other: Value) -> Value:
    if value == name:
        return other
    if isinstance(value, tuple):
        return tuple(_renamed(part, name, other) for part in value)  # type: ignore[arg-type]
    return value


def by_known_entries(question: Question) -> Proof | None:
    """The claim with the least entry of a minimum, or the greatest of a maximum, where it is known.

    Simple orders are looked for: whether an entry is beyond the others for all values in scope.
    """
    claim, equations, chosen = question.plain.claim, dict[str, None](), dict[Term, Term]()
    for term in question.extrema:
        if question.goal.definitions or len(term.children) > MAX_KNOWN:
            return None
        entry, name = _known_entry(question, term)
        if entry is not None:
            equations[name], chosen[term] = None, entry
    if not chosen:
        return None
    sides = [outside_atoms(side, chosen, divisors=False) for side in (claim.lhs, claim.rhs)]
    if claim.key[1:] == tuple(sides):
        return None
    return question.from_fact(claim, question.fact(Claim(claim.relation, *sides)), equations)


def _known_entry(question: Question, term: Term) -> tuple[Term | None, str]:
    """The entry that a minimum or maximum always is, and the fact that says so."""
    is_least = term.op == "min"
    for entry in term.children:
        facts = []
        for other in term.children:
            claim = Claim("<=", *((entry, other) if is_least else (other, entry)))
            fact: str | None = "" if other == entry else None
            with question.budget.at_most(UNITS_FOR_ORDER):
                fact = fact if fact == "" else question.fact(claim)
            if fact is None:
                break
            facts.append(Sum(("goal", fact) if fact else ("goal",)))
        else:
            side = "rhs" if is_least else "lhs"
            orders = Entry("lhs" if is_least else "rhs"), Least(side, tuple(facts))
            proof = Antisymmetry(orders if is_least else orders[::-1])
            home = question.known.home(equal(term, entry), question.goal.context)
            return entry, question.session.ensure(equal(term, entry), proof, home)
    return None, ""


def by_cases(question: Question) -> Proof | None:
    """A proof in which each minimum or maximum, in the claim or a given, is one of its entries."""
    facts, terms = question.facts, [*question.given_extrema, *question.extrema]
    count = 1
    for term in terms:
        count *= len(term.children)
    if not terms or count > MAX_CASES:
        return None
    plain = {n: c for n, c in facts.items() if not _is_of_an_entry(c, terms)}
    return _split(question, terms, plain, {}, 0)


def _is_of_an_entry(claim: Claim, terms: list[Term]) -> bool:
    """Whether a claim says only that an extremum is not beyond one of its entries."""
    sides = (claim.lhs, claim.rhs), (claim.rhs, claim.lhs)
    return any(term in terms and entry in term.children for term, entry in sides)


def _split(
    question: Question,
    terms: list[Term],
    facts: dict[str, Claim],
    equations: dict[str, Claim],
    count: int,
) -> Proof | None:
    """The rest of the cases, below so many hypotheses."""
    goal = question.goal
    if not terms:
        replaced = {claim.lhs: claim.rhs for claim in equations.values()}
        domain = Domain(goal, facts, replaced, question.is_negative)
        if not domain.is_plain:
            return None
        using = (*question.using, *equations)
        return by_squares(domain, question.zeros(domain), question.budget, using)
    term, *others = terms
    branches = []
    for i, entry in enumerate(term.children):
        equation = {f"@{count + 1}": equal(term, entry)}
        rest = [other for j, other in enumerate(term.children) if j != i]
        order = {
            f"@{count + 2 + j}": Claim("<=", *((entry, e) if term.op == "min" else (e, entry)))
            for j, e in enumerate(rest)
        }
        proof = _split(
            question, others, {**facts, **order}, {**equations, **equation}, count + 1 + len(rest)
        )
        if proof is None:
            return None
        branches.append(proof)
    return Cases(term, tuple(branches))
