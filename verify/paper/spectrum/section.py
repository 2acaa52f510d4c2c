"""How a row is written down, and the contexts in which rows hold.

A row has its name, its label, what it says and its claim. It holds for all values of the symbols
that occur in its claim: of those of the context that it names, in their intervals there.
"""

from __future__ import annotations

from collections.abc import Iterable, Mapping
from fractions import Fraction
from functools import partial

from verify.language.record import Record
from verify.language.statement import Always, Applies, Context, Given, Obligation, Variable
from verify.language.terms import (
    Claim,
    Term,
    as_term,
    names_of,
    substitute,
    substitute_claim,
    symbol,
)
from verify.paper.rows import misprint, needed, printed

Bound = int | Fraction | None
Extent = tuple[Bound, Bound]

UNIT: Extent = (0, 1)
POSITIVE: Extent = (0, None)
NEGATIVE: Extent = (None, 0)
REAL: Extent = (None, None)

#: The usual interval of a symbol; those that are not listed are any real numbers.
USUAL: Mapping[str, Extent] = {
    "r": UNIT,  # the restitution coefficient
    "m": UNIT,  # the cube root of -lambda_0, see `complex_pair`
    "n": UNIT,
    "s": UNIT,  # a root of r
    "k": UNIT,
    "v": UNIT,
    "a": POSITIVE,
    "b": POSITIVE,
    "c": POSITIVE,
    "d": POSITIVE,
    "alpha": POSITIVE,
}

#: How symbols are written in LaTeX, where that is not their name.
TEX = {
    "lambda": r"\lambda",
    "kappa": r"\kappa",
    "mu": r"\mu",
    "epsilon": r"\varepsilon",
    "alpha": r"\alpha",
    "cosine": r"\cos\theta",
    "eta_s": r"\eta_s",
    "eta_c": r"\eta_c",
}


class Scope(Record):
    """A context before its variables are known; ``intervals`` differ from the usual ones."""

    name: str
    says: str
    intervals: Mapping[str, Extent]

    def variable(self, name: str) -> str:
        """The name that a symbol has as a variable of this context."""
        return name if self.name == NUMBERS else f"{self.name}.{name}"

    def context(self, names: Iterable[str], letters: Mapping[str, str]) -> Context:
        """The context with these symbols, each in its interval, and a point inside."""
        chosen = sorted(names)
        ends = {name: self.intervals.get(name, USUAL.get(name, REAL)) for name in chosen}
        return Context(
            self.name,
            tuple(
                Variable(self.variable(name), letters.get(name, name), TEX.get(name, name))
                for name in chosen
            ),
            tuple(g for name in chosen for g in _givens(self.variable(name), ends[name])),
            {self.variable(name): _between(ends[name]) for name in chosen},
            says=self.says,
        )


NUMBERS = "numbers"
ANY = "any"
CONE = "cone"
SMALL = "small"
LARGE = "large"
SHIFTED = "shifted"
LINE = "line"
LINEAR = "linear"
SMALLER = "smaller"
APPROACH = "approach"

SCOPES = {
    scope.name: scope
    for scope in (
        Scope(NUMBERS, "r, m, n, s, k, v are any numbers in ]0,1[; a, b, c, d, α are positive; all "
              "other letters are any real numbers", {}),
        Scope(ANY, "r, s, c and ε are any real numbers", {"r": REAL, "s": REAL, "c": REAL}),
        Scope(CONE, "r is in ]0,1[, x negative, a, b and g are positive, y and t any real numbers",
              {"x": NEGATIVE, "g": POSITIVE}),
        Scope(SMALL, "r is in ]0,1/3[", {"r": (0, Fraction(1, 3))}),
        Scope(LARGE, "r is in ]1/3,1[", {"r": (Fraction(1, 3), 1)}),
        Scope(SHIFTED, "s, which stands for r+1, is in ]1,2[", {"s": (1, 2)}),
        Scope(LINE, "m is in ]0,1[; k, the place in a line of starting points, is any real number",
              {"k": REAL}),
        Scope(LINEAR, "s is in ]0,1[, k in ]0,1/2[, y positive",
              {"k": (0, Fraction(1, 2)), "y": POSITIVE}),
        Scope(SMALLER, "p and v are in ]0,1[", {"p": UNIT}),
        Scope(APPROACH, "r is in ]0,1[, g negative, p, q and the cosine are any real numbers",
              {"g": NEGATIVE}),
    )
}  # fmt: skip


def _givens(variable: str, interval: Extent) -> list[Given]:
    """That a variable lies strictly between the ends that there are."""
    low, high = interval
    x = symbol(variable)
    givens = []
    if low is not None:
        givens.append(Given(f"{variable}.low", Claim("<", as_term(low), x)))
    if high is not None:
        givens.append(Given(f"{variable}.high", Claim("<", x, as_term(high))))
    return givens


def _between(interval: Extent) -> Term:
    """A simple number in an interval."""
    low, high = interval
    if low is not None and high is not None:
        return as_term((Fraction(low) + high) / 2)
    if low is not None:
        return as_term(low + 1)
    return as_term(0 if high is None else high - 1)


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
    """The rows of one step: those of `verify.paper.rows`, in a context where they hold."""

    def __init__(self, group: str) -> None:
        self.needed = partial(needed, group=group, context=NUMBERS)
        self.printed = partial(printed, group=group, context=NUMBERS)
        self.misprint = partial(misprint, group=group, context=NUMBERS)


def placed(row: Obligation) -> Obligation:
    """The row over the variables of its context: in none, if its claim is ground.

    Raises:
        TypeError: if the row neither compares numbers nor cites, or is in no context.
    """
    if isinstance(row.claim, Always) or row.context is None:
        raise TypeError(f"{row.name} is no claim about numbers in a context")
    names = set(names_of(*terms_of(row.claim)))
    if not names:
        return row._replace(context=None)
    if row.context == NUMBERS:
        return row
    scope = SCOPES[row.context]
    variables = {name: symbol(scope.variable(name)) for name in names}
    if isinstance(row.claim, Claim):
        return row._replace(claim=substitute_claim(row.claim, variables))
    at = {name: substitute(term, variables) for name, term in row.claim.at.items()}
    return row._replace(claim=row.claim._replace(at=at))


def terms_of(claim: Claim | Applies) -> tuple[Term, ...]:
    """Both sides of a comparison, or the values at which a cited theorem applies."""
    return (claim.lhs, claim.rhs) if isinstance(claim, Claim) else tuple(claim.at.values())


def symbols(names: str) -> tuple[Term, ...]:
    """The symbols of these names."""
    return tuple(symbol(name) for name in names.split())
