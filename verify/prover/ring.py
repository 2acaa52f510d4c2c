"""Claims about names that are short in a chart: cleared into one ring, and proved by sums there.

The chart replaces atoms by equations that are facts; what is left are the variables of a ring, with
facts about their signs. Nothing here is trusted.
"""

from __future__ import annotations

from collections.abc import Iterable, Mapping
from fractions import Fraction

from verify.language.terms import Claim, Term
from verify.prover.clearing import ATOMS, Quotients, expanded, inner_first
from verify.prover.positivity import EntryBound, NotFoundError, Polynomial, Positivity
from verify.prover.proof import Value
from verify.prover.rules import Sum
from verify.prover.session import ZERO, Session


class Ring(Quotients):
    """The facts of a context, and a ring into which its terms are cleared.

    Args:
        session: where lemmas are written down.
        context: where they are proved.
        search: the ring and what is known of its variables.
        atoms: the term of each variable of the ring.
        values: the polynomial of each atom that is not replaced.
        replaced: for each atom that is replaced the name of the equation.
    """

    def __init__(
        self,
        session: Session,
        context: str,
        search: Positivity,
        atoms: Mapping[str, Term],
        values: Mapping[Term, Polynomial],
        replaced: Mapping[Term, str],
    ) -> None:
        super().__init__()
        self.session, self.context, self.search = session, context, search
        self.atoms, self.values, self.replaced = dict(atoms), dict(values), dict(replaced)

    # --- clearing -------------------------------------------------------------------------------

    def constant(self, value: Fraction) -> Polynomial:
        """A number as a polynomial of the ring."""
        return self.search.constant(value)

    def replacement(self, term: Term) -> Term | None:
        """What the equation for an atom replaces it by."""
        name = self.replaced.get(term)
        return None if name is None else self.session.claims[name].rhs

    def atom(self, term: Term) -> Polynomial | None:
        """The polynomial of an atom.

        Raises:
            NotFoundError: for an atom that is not in the ring.
        """
        if term in self.values:
            return self.values[term]
        if term.op in ATOMS:
            raise NotFoundError(f"{term!r} is not in the ring")
        return None

    def term(self, polynomial: Polynomial) -> Term:
        """A polynomial of the ring as a term, expanded."""
        return expanded(polynomial, [self.atoms[name] for name in self.search.names])

    def using(self, *terms: Term) -> tuple[str, ...]:
        """The equations that replace what occurs in terms."""
        found: dict[str, None] = {}
        seen: set[Term] = set()
        waiting = list(terms)
        while waiting:
            term = waiting.pop()
            if term in seen:
                continue
            seen.add(term)
            if term in self.replaced:
                name = self.replaced[term]
                found[name] = None
                waiting.append(self.session.claims[name].rhs)
            else:
                waiting += term.children
        return tuple(sorted(found))

    # --- proving --------------------------------------------------------------------------------

    def ensure(self, *terms: Term) -> None:
        """Afterwards each divisor and radicand in the terms is known to be positive."""
        inside = lambda term: () if term in self.replaced else term.children  # noqa: E731
        for term in inner_first(terms, inside):
            if term.op in ("div", "sqrt") and term not in self.replaced:
                part = term.children[-1]
                if part.op != "rational":
                    self.lemma(0 < part)

    def lemma(self, claim: Claim, name: str | None = None) -> str:
        """The name of a fact, proved if it is not known."""
        known = self.session.known(claim, self.context)
        if known is not None:
            return known
        return self.session.lemma(claim, self.prove(claim), self.context, name)

    def prove(self, claim: Claim, *, extra: Mapping[Term, str] | None = None) -> Sum:
        """A sum that proves a claim; ``extra`` replaces more atoms, by equations of a branch.

        Raises:
            NotFoundError: if no sum is found.
        """
        self.ensure(claim.lhs, claim.rhs)
        using = self.using(claim.lhs, claim.rhs)
        if claim.relation == "=":
            return Sum(using=using)
        found = self.search.find(-self.difference(claim.lhs, claim.rhs))
        if claim.relation == "<" and not found.strict:
            raise NotFoundError("only seen to be >= 0")
        roots = [self.atoms[name] for name in self.search.squares if self.uses(found.value, name)]
        using = self.using(claim.lhs, claim.rhs, *roots)
        goal: Value = ("mul", *found.factors, "goal") if found.factors else "goal"
        addends = (goal,) if found.value == "0" else (goal, found.value)
        return Sum(addends, (*using, *(extra or {}).values()))

    def uses(self, value: Value, name: str) -> bool:
        """Whether the positivity of a variable is used in a value."""
        fact = self.search.positive[name]
        if isinstance(value, str):
            return value == fact
        return any(self.uses(item, name) for item in value[1:] if isinstance(item, str | tuple))

    # --- minima ---------------------------------------------------------------------------------

    def entries(self, name: str, facts: Iterable[tuple[str, Term]]) -> list[EntryBound]:
        """What facts `x <= entry` say of a variable of the ring, without common factors."""
        found = []
        x = self.search.generators[name]
        for fact, entry in facts:
            n, d = self.clear(entry)
            common = n.gcd(d)
            n, d = n // common, d // common
            lemma = self._simplified(fact, n - x * d)
            found.append(EntryBound(lemma, n, d))
        return found

    def _simplified(self, fact: str, polynomial: Polynomial) -> str:
        """The fact that a polynomial is >= 0, of which the given fact is a positive multiple."""
        claim = self.session.claims[fact]
        rest, remainder = divmod(-self.difference(claim.lhs, claim.rhs), polynomial)
        if not remainder.is_zero():
            raise ValueError(f"{fact} says something else")
        sign = self.search.find(rest)
        short = self.term(polynomial)
        using = self.using(claim.lhs, claim.rhs, short)
        addends: tuple[Value, ...] = (("mul", sign.value, "goal"), fact)
        return self.session.lemma(ZERO <= short, Sum(addends, using), self.context)
