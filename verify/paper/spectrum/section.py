"""How a row is written down: its name, its label, what it says, its claim.

A row holds for all values of the symbols that occur in its claim: of those of the context that it
names, in their intervals there.
"""

from __future__ import annotations

from collections.abc import Iterable

from verify.language.statement import Obligation
from verify.language.terms import Claim, Term, names_of, substitute_claim, symbol
from verify.paper.rows import misprint, needed, printed
from verify.paper.spectrum.contexts import NUMBERS, SCOPES

LETTERS = {
    "lambda": "λ",
    "kappa": "κ",
    "mu": "μ",
    "epsilon": "ε",
    "alpha": "α",
    "cosine": "cos",
    "eta_s": "η_s",
    "eta_c": "η_c",
    **{f"{letter}_{i}": letter + "₀₁₂₃₄₅₆"[i] for letter in "cpquvw" for i in range(7)},
}


class Section:
    """The rows of one step: those of `verify.paper.rows`, each placed in its context."""

    def __init__(self, group: str) -> None:
        self.group = group

    def needed(
        self,
        name: str,
        label: str,
        says: str,
        claim: Claim,
        uses: Iterable[str] = (),
        *,
        within: str = NUMBERS,
    ) -> Obligation:
        """A row on which the conclusions rest, for all values in the context ``within``."""
        return _placed(needed(name, label, says, claim, uses, group=self.group), claim, within)

    def printed(
        self,
        name: str,
        label: str,
        says: str,
        claim: Claim,
        uses: Iterable[str] = (),
        *,
        within: str = NUMBERS,
    ) -> Obligation:
        """A row of the paper on which nothing rests, and against which nothing is known."""
        return _placed(printed(name, label, says, claim, uses, group=self.group), claim, within)

    def misprint(
        self,
        name: str,
        label: str,
        says: str,
        claim: Claim,
        severity: str,
        corrected_by: str,
        uses: Iterable[str] = (),
        *,
        within: str = NUMBERS,
    ) -> Obligation:
        """A row of the paper that is refuted."""
        row = misprint(
            name,
            label,
            says,
            claim,
            uses,
            group=self.group,
            severity=severity,
            corrected_by=corrected_by,
        )
        return _placed(row, claim, within)


def _placed(row: Obligation, claim: Claim, within: str) -> Obligation:
    """The row over the variables of a context: in none, if its claim is ground."""
    names = set(names_of(claim.lhs, claim.rhs))
    if not names:
        return row
    scope = SCOPES[within]
    variables = {name: symbol(scope.variable(name)) for name in names}
    there = claim if within == NUMBERS else substitute_claim(claim, variables)
    return row._replace(claim=there, context=within)


def symbols(names: str) -> tuple[Term, ...]:
    """The symbols of these names."""
    return tuple(symbol(name) for name in names.split())
