"""Terms as they are shown: simplified, long fractions as the decimals that they are."""

from __future__ import annotations

from verify.language.simplify import simplified, simplified_claim
from verify.language.statement import Always, Applies
from verify.language.terms import Claim, Term
from verify.language.typeset import Typesetter
from verify.prover.decimals import exact_number
from verify.prover.outcome import Outcome
from verify.views.words import letters

#: Fractions with a smaller denominator stay fractions.
LONG = 100


class PlainTypesetter(Typesetter):
    """Writes terms that have the same values as those that it is given, and are easier to read."""

    def claim(self, claim: Claim | Applies | Always) -> str:
        """The claim, its sides simplified."""
        return super().claim(simplified_claim(claim) if isinstance(claim, Claim) else claim)

    def term(self, term: Term) -> str:
        """The term, simplified."""
        return super().term(simplified(term))

    def _write(self, term: Term) -> str:
        if term.op == "rational" and term.value.denominator >= LONG:
            return exact_number(term.value)
        return super()._write(term)


def plain_letters(outcome: Outcome) -> PlainTypesetter:
    """A typesetter in the letters of an outcome, for what is shown and not checked."""
    return PlainTypesetter(letters(outcome).letters)
