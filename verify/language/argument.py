"""An argument, line by line: what is claimed, and which known inequalities are multiplied for it.

A line that `says` something is an obligation of the statement; the others are lemmas on the way.
A reason is data: the prover turns it into a proof by the rule of the same name, and the checker
accepts that or not. Nothing here decides anything.
"""

from __future__ import annotations

from collections.abc import Mapping
from fractions import Fraction

from verify.language.record import Record
from verify.language.statement import Always, Applies, Context, Statement
from verify.language.terms import Claim, Term

#: A number that is >= 0: a rational, the name of an inequality, ``goal``, or one built from these.
Value = str | tuple[object, ...]
Factor = Value | int | Fraction


def _value(factor: Factor) -> Value:
    return str(factor) if isinstance(factor, int | Fraction) else factor


def times(*factors: Factor) -> Value:
    """A product of numbers that are >= 0."""
    return ("mul", *map(_value, factors))


def plus(*values: Factor) -> Value:
    """A sum of numbers that are >= 0."""
    return ("add", *map(_value, values))


def power(value: Factor, exponent: int) -> Value:
    """A power of a number that is >= 0."""
    return ("pow", _value(value), exponent)


class BySum(Record):
    """If the claim were false these numbers, which are >= 0, would add up to 0, and one is > 0.

    ``using`` names equations by which atoms are replaced, ``equations`` those that are added,
    each times a term.
    """

    addends: tuple[Value, ...] = ()
    using: tuple[str, ...] = ()
    equations: tuple[tuple[str, Term], ...] = ()


class ByNames(Record):
    """The sum of products of these facts, and squares, that has to be found."""

    facts: tuple[Value, ...]


class ByRoot(Record):
    """The root of a positive number is positive."""


class ByEntry(Record):
    """A minimum on the left is at most its entry; a maximum on the right is at least its entry."""

    equation: str | None = None
    side: str = "lhs"


class ByLeast(Record):
    """What is below each entry is below the minimum on the right; so for a maximum on the left."""

    branches: tuple[BySum | ByNames, ...]
    equation: str | None = None
    side: str = "rhs"


class ByCases(Record):
    """A minimum or maximum is one of its entries: a sum for each.

    In the sum for an entry ``@1`` is the equation that it is the entry, ``@2`` and on say that the
    entry is the least, or greatest.
    """

    of: Term
    branches: tuple[BySum, ...]


class ByInterval(Record):
    """Both sides are numbers: enclosures decide."""


class ByInstance(Record):
    """A known fact at values of its variables; ``givens`` names why they satisfy its givens."""

    fact: str
    values: Mapping[str, Term]
    givens: tuple[str, ...]


class ByApplying(Record):
    """Values satisfy the givens of another context; ``givens`` names why."""

    givens: tuple[str, ...]


class ByInduction(Record):
    """Why each condition holds at the start, and at the next state."""

    start: tuple[str, ...]
    next: tuple[str, ...]


class ByWitness(Record):
    """The claim is false at these values, which satisfy all that is given."""

    at: Mapping[str, Term]


class ByNegation(Record):
    """The claim is false for all values: why its negation holds."""

    reason: Reason


class ToBeFound(Record):
    """A sum that the prover has to find."""


Reason = (
    ToBeFound
    | BySum
    | ByNames
    | ByRoot
    | ByEntry
    | ByLeast
    | ByCases
    | ByInterval
    | ByInstance
    | ByApplying
    | ByInduction
    | ByWitness
    | ByNegation
)


def proof(*addends: Factor) -> BySum:
    """The addends besides the negated claim itself."""
    return BySum(("goal", *map(_value, addends)))


def scaled(goal: Value, *addends: Factor) -> BySum:
    """The same where the negated claim enters in a product."""
    return BySum((goal, *map(_value, addends)))


class Line(Record):
    """A claim for all values in a context, with its reason."""

    name: str
    claim: Claim | Applies | Always
    reason: Reason
    label: str = ""
    says: str = ""
    uses: tuple[str, ...] = ()


class Defined(Record):
    """Here a constant of the context is known to have a value."""

    name: str


class Opened(Record):
    """Here the next context opens; ``premises`` names why its givens hold at its point.

    Without premises the point has numbers, and enclosures show it.
    """

    context: Context
    premises: tuple[str, ...] | None = None


Item = Line | Defined | Opened


class Chapter(Record):
    """Lines in one context, in order."""

    context: str | None
    items: tuple[Item, ...]


class Argument(Record):
    """A statement with its argument."""

    statement: Statement
    chapters: tuple[Chapter, ...]
