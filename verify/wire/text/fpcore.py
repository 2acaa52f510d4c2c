"""Ranges of FPCore: between which bounds are the values of an expression, for all its inputs?

The expression is meant in real numbers: nothing is rounded. Its precondition is what is given. The
bounds that are asked for come from sampled values, with a hundredth of their range to spare on
each side, rounded outwards; the rows say that they hold.
"""

from __future__ import annotations

from collections.abc import Iterator
from fractions import Fraction
from math import floor
from typing import Any

from verify.language.statement import NEEDED, Context, Given, Obligation, Statement, Variable
from verify.language.terms import Claim, Term, as_term, names_of, parts_of, symbol
from verify.prover import balls
from verify.wire.inputs import MAX_EXPONENT, InputError, file_name, nearest, shown
from verify.wire.text.conjunctions import Order, TooManyCasesError, cases, is_large, named
from verify.wire.text.formulas import FPCORE, Reader, Scope, real
from verify.wire.text.lisp import FPCORE as WORDS
from verify.wire.text.lisp import Names, Source, Tree, Word
from verify.wire.text.points import Points
from verify.wire.text.samples import NoValueError, Samples

#: How many points are sampled, and to how many digits the spare hundredth is told.
SAMPLES, DIGITS = 2000, 1
#: So many expressions are in a file; at the samples of all of them, as many parts are looked at,
#: but of each one at least a few.
MAX_CORES, MAX_PARTS, FEW = 256, 1_000_000, 20
#: The properties of FPCore 2.0. Of these only the precondition says which real numbers are meant;
#: those with a hyphen belong to single tools.
PROPERTIES = (
    ":pre",
    *(":name", ":description", ":cite", ":precision", ":round", ":overflow", ":math-library"),
    *(":spec", ":alt", ":example"),
)


def read_fpcore(path: str, content: bytes, seconds: float | None = None) -> Statement:
    """The statement that the expressions of a file stay between bounds.

    Raises:
        InputError: for what is not about real numbers in bounded ranges, naming the line.
    """
    source = Source(path, content, WORDS)
    with source.shallow():
        points, trees = Points(seconds), source.trees()
        if len(trees) > MAX_CORES:
            raise source.error(
                trees[MAX_CORES], f"there are more than {MAX_CORES} expressions; split the file"
            )
        parts = [_Core(source, tree, number, points) for number, tree in enumerate(trees, 1)]
        rows = [row for part in parts for row in part.rows(MAX_PARTS // len(parts))]
    if not parts:
        raise InputError(f"{path}: has no expression; write (FPCore (x) :pre (<= 0 x 1) (* x x))")
    name = file_name(path)
    return Statement(
        name,
        f"ranges of the expressions in {name}, in real numbers",
        {},
        (),
        tuple(part.context() for part in parts),
        tuple(rows),
        (),
    )


class _Core:
    """One expression with its inputs, and with what is given of them."""

    def __init__(self, source: Source, tree: Tree, number: int, points: Points) -> None:
        self.source, self.tree = source, tree
        self.label = f"core-{number}"
        match tree:
            case ["FPCore", [*inputs], *rest] | ["FPCore", Word(), [*inputs], *rest] if rest:
                *properties, self.body = rest
            case _:
                raise source.error(tree, "is no expression; write (FPCore (x) ... (* x x))")
        self.properties = self._table(properties)
        self.inputs = [self._input(item) for item in inputs]
        for place, name in enumerate(self.inputs):
            if name in self.inputs[:place]:
                raise source.error(inputs[place], f"{shown(name)} is an argument twice")
        self.letters = Names()
        prefix = f"{self.label}." if number > 1 else ""
        self.names = {old: symbol(f"{prefix}{self.letters[old]}") for old in self.inputs}
        self.reader, self.scope = Reader(source, FPCORE), Scope()
        self.scope.own |= {old: real(term) for old, term in self.names.items()}
        self.claims = self._given(self.properties.get(":pre"))
        (self.term,), self.constants = named(f"{self.label}.part-", [self._body()])
        self.givens = [Given(f"{self.label}.{i}", c) for i, c in enumerate(self.claims, 1)]
        self.variables = [term.name for term in self.names.values()]
        self.samples = Samples(self.variables, self.claims, self.constants)
        self.point = self._point(points)

    def _table(self, properties: list[Tree]) -> dict[str, Tree]:
        """The properties, of which each stands there once."""
        found: dict[str, Tree] = {}
        if len(properties) % 2:
            raise self.source.error(self.tree, "each property, such as :pre, has one value")
        for key, value in zip(properties[::2], properties[1::2], strict=True):
            if not (isinstance(key, Word) and key.startswith(":")):
                raise self.source.error(key, "is no property; write a name such as :pre")
            if key not in PROPERTIES and "-" not in key:
                raise self.source.error(
                    key, f"{shown(key)} is not known; {nearest(key, PROPERTIES)}"
                )
            if key in found:
                raise self.source.error(key, f"{key} stands there twice; write it once")
            found[key] = value
        return found

    def _input(self, item: Tree) -> str:
        if not isinstance(item, Word):
            raise self.source.error(item, "an input has to be a name; sizes cannot be used")
        if not item.is_symbol or item in FPCORE.words:
            raise self.source.error(item, f"{shown(item)} cannot be a name; choose another one")
        return str(item)

    def _given(self, tree: Tree | None) -> list[Claim]:
        """The claims of the precondition."""
        if tree is None:
            return []
        formula, order = self.reader.formula(tree, self.scope), Order()
        try:
            found = cases([formula], order)
        except TooManyCasesError as error:
            raise self.source.error(
                tree, "write the precondition as comparisons, with and"
            ) from error
        if len(found) > 1:
            raise self.source.error(tree, "write the precondition as comparisons, with and")
        claims = found[0] if found else [as_term(1) <= 0]
        if is_large([side for claim in claims for side in (claim.lhs, claim.rhs)]):
            raise self.source.error(tree, "with its names written out it is too long; ask for less")
        return claims

    def _body(self) -> Term:
        found = self.reader.real(self.body, self.scope)
        if len(found) > 1:
            raise self.source.error(self.body, "if cannot be used here; write a core for each case")
        return found[0][1]

    def _point(self, points: Points) -> dict[str, Term]:
        found = points.find(self.variables, self.givens, {})
        found = self._middle() if found is None else found
        if found is None:
            raise self.source.error(self.tree, "no input was found that satisfies :pre; mend it")
        return found

    def _middle(self) -> dict[str, Term] | None:
        """The middle of the box of the inputs, if it seems to satisfy the precondition."""
        ends = [self.samples.range(name) for name in self.variables]
        point = [(low + high) / 2 for low, high in ends if low is not None and high is not None]
        exact = [*map(balls.fmpq_of, point)]
        if len(point) < len(ends) or not [*self.samples.values(as_term(0), [exact])]:
            return None
        return dict(zip(self.variables, map(as_term, point), strict=True))

    def context(self) -> Context:
        """All inputs that satisfy the precondition."""
        letters = [
            Variable(term.name, *[self.letters.letter(old)] * 2) for old, term in self.names.items()
        ]
        says = " ".join(str(self.properties.get(":name", "")).strip('"').split())
        return Context(
            self.label,
            tuple(letters),
            tuple(self.givens),
            self.point,
            None,
            says,
            self.constants,
        )

    def rows(self, parts: int) -> Iterator[Obligation]:
        """That the expression is between two bounds; so many parts are looked at."""
        sides = [side for claim in self.claims for side in (claim.lhs, claim.rhs)]
        size = sum(1 for _ in parts_of(self.term, *(c.term for c in self.constants), *sides))
        points = self._points(min(SAMPLES, max(FEW, parts // size)))
        try:
            found = [*self.samples.values(self.term, points)]
        except NoValueError as error:
            raise self.source.error(
                self.tree,
                f"at some of its inputs the expression has no value that is at most "
                f"10^{MAX_EXPONENT}; leave them out by :pre",
            ) from error
        if not found:
            raise self.source.error(self.tree, "the expression has no value at any sampled point")
        low = balls.dyadic(min(low for low, _ in found))
        high = balls.dyadic(max(high for _, high in found))
        spare = (high - low) / 100 or abs(high) / 100 or Fraction(1)
        unit = Fraction(10) ** (_log10(spare) - DIGITS)
        below, above = floor((low - spare) / unit) * unit, -floor(-(high + spare) / unit) * unit
        claims = {"low": as_term(below) <= self.term, "high": self.term <= as_term(above)}
        for name, claim in claims.items():
            yield Obligation(f"{self.label}-{name}", "", "", NEEDED, "", claim, context=self.label)

    def _points(self, count: int) -> Iterator[list[Any]]:
        """Points of the box of the inputs, its corners among them; the same in each run."""
        ranges = [self._range(name) for name in self.variables]
        box = [(balls.fmpq_of(low), balls.fmpq_of(high - low)) for low, high in ranges]
        state = 1
        for _ in range(count):
            at = []
            for low, width in box:
                state = state * 6364136223846793005 % 2**64
                part = min(max((state >> 32) * 3 - (1 << 31), 0), 1 << 33)  # often an end
                at.append(low + width * balls.ratio(part, 1 << 33))
            yield at

    def _range(self, name: str) -> tuple[Fraction, Fraction]:
        low, high = self.samples.range(name)
        is_used = name in names_of(self.term, *(c.term for c in self.constants))
        if is_used and (low is None or high is None):
            letter = name.rpartition(".")[2]
            raise self.source.error(
                self.tree, f"{letter} has no bounds; write for example :pre (<= 0 {letter} 1)"
            )
        return low or Fraction(0), high or Fraction(0)


def _log10(number: Fraction) -> int:
    """The exponent of the greatest power of ten that is at most a positive number."""
    found = len(str(number.numerator)) - len(str(number.denominator))
    return found if Fraction(10) ** found <= number else found - 1
