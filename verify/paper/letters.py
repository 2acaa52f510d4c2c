"""Contexts with letters of their own, their vectors, and rows that are false at a point of one."""

from __future__ import annotations

from collections.abc import Callable, Iterable, Mapping
from fractions import Fraction
from itertools import chain

from verify.language.argument import Argument, Chapter, Item, Line, Opened, argue
from verify.language.record import Record
from verify.language.statement import Assumption, Context, Given, Obligation, Variable
from verify.language.terms import Claim, Number, Term, as_term, symbol
from verify.language.vectors import Combination, add, scale
from verify.paper.rows import misprint

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


def minus(x: Combination, z: Combination) -> Combination:
    """The difference of two vectors."""
    return add(x, scale(-1, z))


class Space(Record):
    """What is known of the inner products of named vectors: only those that are listed."""

    products: Mapping[tuple[str, str], Term]

    def known(self, i: str, j: str) -> Term:
        """The inner product of two of the named vectors."""
        return self.products[(i, j) if (i, j) in self.products else (j, i)]

    def dot(self, x: Combination, z: Combination) -> Term:
        """The inner product of two combinations."""
        total: Term | None = None
        for i, p in x.items():
            for j, q in z.items():
                part = p * q * self.known(i, j)
                total = part if total is None else total + part
        return as_term(0) if total is None else total


def subject(
    letters: Letters, says: str, point: str, givens: Mapping[str, Claim], lines: Iterable[Item] = ()
) -> tuple[Chapter, ...]:
    """The chapters that open a context without a parent, and prove lines in it."""
    opened = Chapter(None, (Opened(letters.opened(says, point, givens)),))
    return opened, Chapter(letters.context, tuple(lines))


class Refuted(Record):
    """A misprint in a context, and a point of the context at which the claim is false."""

    row: Obligation
    at: Mapping[str, Term]


def refuted(
    letters: Letters,
    name: str,
    claim: Claim,
    at: str,
    *,
    label: str,
    says: str,
    severity: str,
    corrected_by: str,
) -> Refuted:
    """The row, and the numbers of the point in the order of the letters."""
    row = misprint(name, label, says, claim, group="", severity=severity, corrected_by=corrected_by,
                   context=letters.context)  # fmt: skip
    return Refuted(row, letters.point(at))


def sectioned(
    name: str,
    title: str,
    sections: Mapping[str, Callable[[], Iterable[Chapter]]],
    assumptions: tuple[Assumption, ...],
) -> Argument:
    """The statement whose chapters stand under headings; its rows have these for their groups."""
    chapters = {heading: tuple(section()) for heading, section in sections.items()}
    written = argue(name, title, chain(*chapters.values()), assumptions)
    headings = {
        item.name: heading
        for heading, own in chapters.items()
        for chapter in own
        for item in chapter.items
        if isinstance(item, Line)
    }
    rows = (row._replace(group=headings[row.name]) for row in written.statement.obligations)
    return written._replace(statement=written.statement._replace(obligations=tuple(rows)))
