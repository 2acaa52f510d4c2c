"""How a row is written down: its name, its label, what it says, its claim.

A row holds for all values of the symbols that occur in its claim: of those of the context that it
names, in their intervals there.
"""

from __future__ import annotations

from collections.abc import Iterable, Iterator

from verify.language.statement import NEEDED, PRINTED, Obligation
from verify.language.terms import Claim, Term, substitute_claim, symbol
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
    """The rows of one step."""

    def __init__(self, group: str) -> None:
        self.group = group

    def needed(
        self,
        name: str,
        label: str,
        says: str,
        claim: Claim,
        uses: Iterable[str] = (),
        within: str = NUMBERS,
    ) -> Obligation:
        """A row on which the conclusions rest, for all values in the context ``within``."""
        claim, context = _placed(claim, within)
        return Obligation(
            name, self.group, label, NEEDED, says, claim, tuple(uses), context=context
        )

    def printed(
        self,
        name: str,
        label: str,
        says: str,
        claim: Claim,
        corrected_by: str | None = None,
        uses: Iterable[str] = (),
        within: str = NUMBERS,
    ) -> Obligation:
        """A row of the paper on which nothing rests, or which is false as printed."""
        claim, context = _placed(claim, within)
        return Obligation(
            name, self.group, label, PRINTED, says, claim, tuple(uses), corrected_by,
            context=context,
        )  # fmt: skip


def _placed(claim: Claim, within: str) -> tuple[Claim, str | None]:
    """The claim over the variables of a context, and its context: none for a ground claim."""
    names = set(names_of(claim))
    if not names:
        return claim, None
    scope = SCOPES[within]
    variables = {name: symbol(scope.variable(name)) for name in names}
    return (claim if within == NUMBERS else substitute_claim(claim, variables)), within


def names_of(claim: Claim) -> Iterator[str]:
    """The names that occur in a claim, each once."""
    seen: set[Term] = set()
    waiting = [claim.lhs, claim.rhs]
    while waiting:
        term = waiting.pop()
        if term not in seen:
            seen.add(term)
            waiting += term.children
            if term.op == "symbol":
                yield term.name


def symbols(names: str) -> tuple[Term, ...]:
    """The symbols of these names."""
    return tuple(symbol(name) for name in names.split())
