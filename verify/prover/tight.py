"""Claims that hold with equality, or that no enclosure decides: by replacing names, and algebra.

A name may be replaced by its definition. A name that is a minimum is replaced by one of its
entries; that this makes the claim harder is then proved: with the claim as P(m) <= 0 for a
polynomial P, and the entry as N/D,

    D^k P(m) = D^k P(N/D) - (N - m D) Q,

where N - m D >= 0 is the fact that the minimum is at most its entry, and the sign of Q is decided
by enclosures.
"""

from __future__ import annotations

from collections.abc import Callable
from fractions import Fraction

from flint import fmpq

from verify.language.terms import (
    Claim,
    Term,
    cos,
    cos_pi,
    equal,
    names_of,
    parts_of,
    pi,
    substitute_claim,
    symbol,
)
from verify.prover.balls import fraction_of
from verify.prover.clearing import Clearing, Polynomial, coefficients, has_value
from verify.prover.constants import Constants
from verify.prover.proof import Proof, Value
from verify.prover.rules import Entry, Law, Sum

#: How many names are replaced at most; the longest proof that the paper needs replaces four.
MAX_STEPS = 8

#: A claim that so many bits do not decide may hold with equality: algebra is tried then.
TIGHT_BITS = 1024

#: The factors of a proof are polynomials of at most this many monomials.
MAX_MONOMIALS = 200


class Tight:
    """Proofs of claims of one relation `<=` (or of equations) at one precision."""

    def __init__(self, ground: Constants, bits: int) -> None:
        self.ground, self.bits = ground, bits
        self.session = ground.session

    def prove(self, claim: Claim, budget: int = MAX_STEPS) -> Proof | None:
        """A proof, whose lemmas are written down; None if none is found."""
        return self._search(claim, claim, (), budget)

    def _search(
        self, claim: Claim, current: Claim, using: tuple[str, ...], budget: int
    ) -> Proof | None:
        """Go on after replacing the names in ``using``: ``current`` is the claim after that.

        A name that stands on one side only is replaced before an identity is tried: it cancels
        then, or it never does.
        """
        name = self._latest(current)
        alone = name is not None and not self._on_both_sides(name, current)
        if not alone and claim.relation != "<" and self._is_identity(claim, using):
            return self._identity(claim, using)
        if budget == 0 or name is None:
            return None
        found = self._replace(claim, current, using, name, budget)
        if found is None and alone and claim.relation != "<" and self._is_identity(claim, using):
            return self._identity(claim, using)
        return found

    def _replace(
        self, claim: Claim, current: Claim, using: tuple[str, ...], name: str, budget: int
    ) -> Proof | None:
        """Replace a name by its definition, or a minimum by one of its entries, and go on."""
        definition = self.ground.definitions[name]
        if definition.op != "min":
            following = substitute_claim(current, {name: definition})
            return self._search(claim, following, (*using, name), budget - 1)
        if claim.relation == "=":
            return None
        for entry in definition.children:
            if claim == Claim("<=", symbol(name), entry):
                return self._entry(name, entry)
            harder = substitute_claim(current, {name: entry})
            if self.ground.may_hold(harder, self.bits):
                found = self._lowered(claim, harder, using, name, entry, budget)
                if found is not None:
                    return found
        return None

    def _latest(self, claim: Claim) -> str | None:
        """The name in a claim that was defined last."""
        names = set(names_of(claim.lhs, claim.rhs))
        return next((name for name in reversed(self.ground.definitions) if name in names), None)

    def _on_both_sides(self, name: str, claim: Claim) -> bool:
        return name in names_of(claim.lhs) and name in names_of(claim.rhs)

    # --- identities -----------------------------------------------------------------------------

    def _is_identity(self, claim: Claim, using: tuple[str, ...]) -> bool:
        clearing = Clearing((claim.lhs, claim.rhs), self.session.replaced(using))
        difference = clearing.difference(claim.lhs, claim.rhs)
        return not clearing.reduce(difference).to_dict()

    def _identity(self, claim: Claim, using: tuple[str, ...]) -> Proof | None:
        if not self.cleared(claim.lhs, claim.rhs, *self._definitions(using)):
            return None
        return Sum((), using) if claim.relation == "=" else Sum(("goal",), using)

    # --- minima ---------------------------------------------------------------------------------

    def _entry(self, name: str, entry: Term) -> Proof | None:
        definition = self.ground.definitions[name]
        return Entry("lhs", name) if self.cleared(definition, entry) else None

    def _lowered(
        self,
        claim: Claim,
        harder: Claim,
        using: tuple[str, ...],
        name: str,
        entry: Term,
        budget: int,
    ) -> Proof | None:
        """A proof from the claim at an entry, and that the minimum is at most this entry."""
        m = symbol(name)
        definitions = self._definitions(using)
        if not self.cleared(claim.lhs, claim.rhs, entry, *definitions):
            return None
        terms = (claim.lhs, claim.rhs, harder.lhs, harder.rhs, m, entry)
        negative = lambda term: self.ground.sign(term) < 0  # noqa: E731
        clearing = Clearing(terms, self.session.replaced(using), negative)
        goal = clearing.difference(claim.lhs, claim.rhs)
        n, d = clearing.clear(entry)
        index = clearing.atoms.index(m)
        if n.degrees()[index] or d.degrees()[index]:
            return None
        degree = int(goal.degrees()[index])
        if degree < 1:
            return None
        bottom = clearing.context.constant(0)
        for power, part in coefficients(goal, index).items():
            bottom += part * n**power * d ** (degree - power)
        quotient, rest = divmod(goal * d**degree - bottom, clearing.generators[m] * d - n)
        if rest.to_dict():
            return None
        fact = self._entry_fact(name, entry)
        factor = self._value(clearing, d**degree)
        slope = self._value(clearing, quotient, zero=True)
        if fact is None or factor is None or slope is None:
            return None
        return self._assemble(clearing, bottom, harder, (factor, fact, slope), using, budget)

    def _assemble(
        self,
        clearing: Clearing,
        bottom: Polynomial,
        harder: Claim,
        values: tuple[Value, Value, Value],
        using: tuple[str, ...],
        budget: int,
    ) -> Proof | None:
        """D^k goal + (N - m D) Q - D^k P(N/D) = 0, where the last is 0 or shown by a lemma."""
        factor, fact, slope = values
        addends: list[Value] = [("mul", factor, "goal"), ("mul", fact, slope)]
        if not clearing.reduce(bottom).to_dict():
            return Sum(tuple(addends), using) if harder.relation == "<=" else None
        lemma = self._lemma(harder, budget)
        if lemma is None:
            return None
        other = clearing.difference(harder.lhs, harder.rhs)
        common = bottom.gcd(other)
        left, right = (self._value(clearing, p / common) for p in (other, bottom))
        if left is None or right is None:
            return None
        scaled: list[Value] = [("mul", left, addend) for addend in addends]
        return Sum((*scaled, ("mul", right, lemma)), using)

    def _lemma(self, claim: Claim, budget: int) -> str | None:
        """The name of a fact: known, or seen by enclosures, or proved by algebra."""
        known = self.session.known(claim, None)
        if known is not None:
            return known
        if self.ground.holds_at(claim, TIGHT_BITS):
            return self.ground.lemma(claim)
        proof = self.prove(claim, budget - 1)
        return self.ground.lemma(claim) if proof is None else self.session.lemma(claim, proof)

    def _entry_fact(self, name: str, entry: Term) -> str | None:
        claim = Claim("<=", symbol(name), entry)
        known = self.session.known(claim, None)
        if known is not None:
            return known
        proof = self._entry(name, entry)
        return None if proof is None else self.session.lemma(claim, proof)

    # --- facts that the rule needs --------------------------------------------------------------

    def _value(self, clearing: Clearing, p: Polynomial, *, zero: bool = False) -> Value | None:
        """A polynomial that is positive (or not negative) as a value of a sum."""
        if p.is_constant():
            number = clearing.term(p)
            return str(number.value) if number.value > 0 or (zero and number.value == 0) else None
        if len(p.to_dict()) > MAX_MONOMIALS or not clearing.reduce(p).to_dict():
            return None
        return self.ground.positive(clearing.term(p))

    def _definitions(self, using: tuple[str, ...]) -> list[Term]:
        return [self.ground.definitions[name] for name in using]

    def cleared(self, *terms: Term) -> bool:
        """Afterwards each divisor and radicand has the fact that it needs; or False."""
        seen: set[Term] = set()
        waiting = list(terms)
        while waiting:
            term = waiting.pop()
            if term in seen:
                continue
            seen.add(term)
            waiting += term.children
            if not has_value(term, lambda claim: self.ground.lemma(claim) is not None):
                return False
        return True


# --- sines and cosines of rational multiples of pi -----------------------------------------------


def by_half_turns(
    tight: Tight, claim: Claim, prove: Callable[[Claim], Proof | None]
) -> Proof | None:
    """A proof of a claim by one of the same about values of `cos_pi`, if it has such angles."""
    equations: dict[Term, tuple[str, Term]] = {}
    for part in parts_of(claim.lhs, claim.rhs):
        if part.op in ("cos", "sin") and tight.cleared(part):
            turns = _half_turns(part.children[0])
            if turns is not None:
                equations |= _equations(tight, part, turns)
    if not equations:
        return None
    from verify.prover.multiple import from_fact, outside_atoms  # loaded only where they are used

    values = {atom: value for atom, (_, value) in equations.items()}
    sides = [outside_atoms(side, values) for side in (claim.lhs, claim.rhs)]
    simpler = Claim(claim.relation, *sides)
    if simpler == claim or not tight.cleared(claim.lhs, claim.rhs, *sides):
        return None
    session, proof = tight.session, prove(simpler)
    if proof is None:
        return None
    lemma = session.ensure(simpler, proof)
    return from_fact(session, claim, lemma, [name for name, _ in equations.values()])


def _equations(tight: Tight, part: Term, turns: Fraction) -> dict[Term, tuple[str, Term]]:
    """For each atom on the way from a sine or cosine to `cos_pi` the equation, and what it is."""
    found: dict[Term, tuple[str, Term]] = {}
    session = tight.session
    if part.op == "sin":
        turns = Fraction(1, 2) - turns
        shifted = cos(turns * pi)
        found[part] = session.lemma(equal(part, shifted), Law()), shifted
        part = shifted
    value = cos_pi(turns)
    found[part] = session.lemma(equal(part, value), Law()), value
    return found


def _half_turns(angle: Term) -> Fraction | None:
    """The rational q of an angle q pi; None for any other."""
    clearing = Clearing((angle,), {})
    if clearing.atoms not in ([], [pi]):
        return None
    above, below = clearing.clear(angle)
    quotient = above / below.leading_coefficient() if below.is_constant() else None
    if quotient is None:
        return None
    powers = {int(m[0]) if m else 0: c for m, c in quotient.to_dict().items()}
    return fraction_of(powers.get(1, fmpq(0))) if powers.keys() <= {1} else None
