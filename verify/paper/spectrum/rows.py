"""How a row is written down: its name, its label, what it says, its claim.

A row holds for all values of the symbols that occur in its claim. Each symbol lies in its usual
interval, unless the row gives another one.
"""

from __future__ import annotations

from collections.abc import Iterable
from fractions import Fraction

from verify.language.statement import Obligation, Variable
from verify.language.terms import Claim, Term, symbol

Bound = int | Fraction | None
Interval = tuple[Bound, Bound]

UNIT: Interval = (0, 1)
POSITIVE: Interval = (0, None)
REAL: Interval = (None, None)

#: The usual interval of a symbol; those that are not listed are any real numbers.
INTERVALS: dict[str, Interval] = {
    "r": UNIT,  # the restitution coefficient
    "m": UNIT,  # the cube root of -lambda_0, see `complex_pair`
    "n": UNIT,
    "s": UNIT,  # a root of r
    "k": UNIT,
    "a": POSITIVE,
    "b": POSITIVE,
    "c": POSITIVE,
    "g": POSITIVE,
}

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
        **intervals: Interval,
    ) -> Obligation:
        """A row on which the conclusions rest."""
        return self._row(name, label, "needed", says, claim, uses, None, intervals)

    def printed(
        self,
        name: str,
        label: str,
        says: str,
        claim: Claim,
        corrected_by: str | None = None,
        uses: Iterable[str] = (),
        **intervals: Interval,
    ) -> Obligation:
        """A row of the paper on which nothing rests, or which is false as printed."""
        return self._row(name, label, "printed", says, claim, uses, corrected_by, intervals)

    def _row(
        self,
        name: str,
        label: str,
        role: str,
        says: str,
        claim: Claim,
        uses: Iterable[str],
        corrected_by: str | None,
        intervals: dict[str, Interval],
    ) -> Obligation:
        names = _names(claim)
        unused = set(intervals) - set(names)
        if unused:
            raise ValueError(f"row {name} has intervals for symbols that it does not use: {unused}")
        known = INTERVALS | intervals
        variables = tuple(_variable(symbol_name, known) for symbol_name in sorted(names))
        return Obligation(
            name, self.group, label, role, says, claim, tuple(uses), corrected_by, variables
        )


def _names(claim: Claim) -> set[str]:
    """The names of the symbols that occur in a claim."""
    names: set[str] = set()
    seen: set[Term] = set()
    waiting = [claim.lhs, claim.rhs]
    while waiting:
        term = waiting.pop()
        if term.op == "symbol":
            names.add(term.name)
        elif term not in seen:
            seen.add(term)
            waiting += term.children
    return names


def _variable(name: str, intervals: dict[str, Interval]) -> Variable:
    low, high = intervals.get(name, REAL)
    return Variable(
        name,
        None if low is None else Fraction(low),
        None if high is None else Fraction(high),
    )


def symbols(names: str) -> tuple[Term, ...]:
    """The symbols of these names."""
    return tuple(symbol(name) for name in names.split())
