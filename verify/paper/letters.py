"""Contexts with letters of their own."""

from __future__ import annotations

from collections.abc import Mapping
from fractions import Fraction

from verify.language.statement import Context, Given, Variable
from verify.language.terms import Claim, Number, Term, as_term, symbol

#: How letters are written in LaTeX, where that is not their name.
TEX = {
    "cos ": r"\cos ",
    "√r": r"\sqrt r",
    "·": r"\cdot ",
    "²": "^2",
    "η": r"\eta",
    "θ": r"\theta",
    "μ": r"\mu",
    "ρ": r"\rho",
    "σ": r"\sigma",
    "τ": r"\tau ",
    "ω": r"\omega",
    "₁": "_1",
}


class Letters:
    """The variables of one context; their names begin with its name, as in ``flight.W``."""

    def __init__(self, context: str, **letters: str) -> None:
        self.context, self.letters = context, letters

    def __getattr__(self, name: str) -> Term:
        """The variable of this name."""
        if name.startswith("_") or name not in self.letters:
            raise AttributeError(name)
        return symbol(self.full(name))

    def full(self, name: str) -> str:
        """The name of a variable as it stands in files."""
        return f"{self.context}.{name}"

    def variables(self) -> tuple[Variable, ...]:
        """The variables, in order."""
        return tuple(
            Variable(self.full(name), letter, tex(letter)) for name, letter in self.letters.items()
        )

    def at(self, **values: Number) -> dict[str, Term]:
        """Values for all variables, by their names in files."""
        if set(values) != set(self.letters):
            raise ValueError(f"{self.context} has the variables {', '.join(self.letters)}")
        return {self.full(name): as_term(values[name]) for name in self.letters}

    def point(self, text: str) -> dict[str, Term]:
        """Rational values for all variables, written with spaces between."""
        numbers = map(Fraction, text.split())
        return self.at(**dict(zip(self.letters, numbers, strict=True)))

    def opened(
        self, says: str, point: str, givens: Mapping[str, Claim], parent: str | None = None
    ) -> Context:
        """The context, with the names of its givens, and a point with rational coordinates."""
        named = tuple(Given(f"{self.context}-{name}", claim) for name, claim in givens.items())
        return Context(self.context, self.variables(), named, self.point(point), parent, says)


def tex(letter: str) -> str:
    """A letter in LaTeX."""
    for sign, command in TEX.items():
        letter = letter.replace(sign, command)
    return letter
