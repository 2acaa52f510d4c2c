"""The rules of the kernel, on the side that searches: a class of proofs for each, and one table.

The fields of a class are those of the certificate; `RULES` says how each is written down.
"""

from __future__ import annotations

from collections.abc import Mapping
from fractions import Fraction
from typing import Any

from verify.language.record import Record
from verify.language.terms import Claim, Term
from verify.prover.proof import Kind, Kinds, Premise, Proof, Value

# --- enclosures ----------------------------------------------------------------------------------


class Interval(Record):
    """The enclosures of the two sides, evaluated with ``bits`` bits, decide.

    ``bounds`` has for each variable the names of a fact that bounds it from below and of one that
    bounds it from above, in an order in which each bound can be evaluated.
    """

    bits: int
    bounds: tuple[tuple[str, str, str], ...] = ()


class Cuts(Record):
    """A term lies between neighbouring cuts.

    There is one branch below the first cut, one between any two neighbours, one above the last.
    """

    term: Term
    at: tuple[Fraction, ...]
    branches: tuple[Proof, ...]


class MeanValue(Record):
    """On a box, the value at a point, and for each variable a slope times its change, decide.

    ``bits`` and ``bounds`` are as in `Interval`; ``at`` has a number for variables.
    """

    bits: int
    bounds: tuple[tuple[str, str, str], ...]
    at: Mapping[str, Term]


# --- algebra -------------------------------------------------------------------------------------


class Sum(Record):
    """The negation of the claim would make a positive number zero.

    The number is the sum of addends that are >= 0 and of multiples of equations, after the
    equations in ``using`` have replaced atoms.
    """

    addends: tuple[Value, ...] = ()
    using: tuple[str, ...] = ()
    equations: tuple[tuple[str, Term], ...] = ()


class Antisymmetry(Record):
    """Two numbers are equal, because each is at most the other: one branch for each order."""

    branches: tuple[Proof, Proof]


class Root(Record):
    """The root of a number is positive, because there is a fact that the number is."""


class Define(Record):
    """A term has a value, because each divisor and radicand has a fact that shows its sign."""


# --- minima and maxima ---------------------------------------------------------------------------


class Entry(Record):
    """A minimum is at most each of its entries, a maximum at least.

    ``equation`` names the fact that the ``side`` of the claim is a minimum (maximum), if any.
    """

    side: str
    equation: str | None = None


class Least(Record):
    """What is less than each entry is less than their minimum.

    There is one branch for each entry of the minimum (on the left side: the maximum).
    """

    side: str
    branches: tuple[Proof, ...]
    equation: str | None = None


class Cases(Record):
    """A minimum or maximum is one of its entries: one branch for each of them."""

    of: Term
    branches: tuple[Proof, ...]


# --- cosines -------------------------------------------------------------------------------------


class Angles(Record):
    """2 cos u cos v = cos (u + v) + cos (u - v), with the angles of the claim."""


class Cosine(Record):
    """Partial sums of the series of a cosine are above it and below, in turn."""


class InRange(Record):
    """A value of an exponential, a sine, a cosine or an inverse tangent is in their range."""


class Law(Record):
    """An identity of functions, such as exp (a + b) = exp a exp b."""


class Monotony(Record):
    """A function that rises keeps the order; with ``under`` the order is read off from it."""

    premise: Premise
    under: str | None = None


class Have(Record):
    """A claim is shown at first, and is a hypothesis for what follows: two branches."""

    claim: Claim
    branches: tuple[Proof, Proof]


class Derivative(Record):
    """What holds at a number still holds at a variable, as the derivative has a sign between.

    Premises say so at the number (``start``), compare the two (``order``), give the sign of the
    derivative, which is ``term``, and show that bounds of the variable hold for the number.
    """

    variable: str
    at: Term
    term: Term
    side: str
    strict: str
    start: Premise
    order: Premise
    sign: Premise
    bounds: tuple[Premise, ...]


# --- contexts ------------------------------------------------------------------------------------


class Instance(Record):
    """What holds for all values that satisfy the givens holds for these.

    The fact ``of`` is taken at values for the variables of its context, which satisfy its givens.
    """

    of: str
    at: Mapping[str, Term]
    givens: tuple[Premise, ...]


class Applying(Record):
    """The values in the claim itself satisfy the givens of its context."""

    givens: tuple[Premise, ...]


class Induction(Record):
    """What holds at the start and goes on holds always.

    For each carried given, why it holds at the start and at the next state.
    """

    start: tuple[Premise, ...]
    next: tuple[Premise, ...]


class Witness(Record):
    """The claim is false at values that satisfy the givens; its negation there has a proof."""

    at: Mapping[str, Term]
    givens: tuple[Premise, ...]
    negation: Proof


#: For each class of proofs the name of its rule, and the kinds of its fields.
RULES: dict[type[Any], tuple[str, Kinds]] = {
    Interval: ("interval", {"bits": Kind.PLAIN, "bounds": Kind.BOUNDS}),
    MeanValue: (
        "mean_value",
        {"bits": Kind.PLAIN, "bounds": Kind.BOUNDS, "at": Kind.TERMS},
    ),
    Cuts: (
        "cuts",
        {"term": Kind.TERM, "at": Kind.RATIONALS, "branches": Kind.PREMISES},
    ),
    Sum: (
        "sum",
        {"addends": Kind.VALUES, "using": Kind.PLAIN, "equations": Kind.COFACTORS},
    ),
    Entry: ("entry", {"side": Kind.PLAIN, "equation": Kind.PLAIN}),
    Least: (
        "least",
        {"side": Kind.PLAIN, "branches": Kind.PREMISES, "equation": Kind.PLAIN},
    ),
    Cases: ("cases", {"of": Kind.TERM, "branches": Kind.PREMISES}),
    Root: ("root", {}),
    Antisymmetry: ("antisymmetry", {"branches": Kind.PREMISES}),
    Angles: ("angles", {}),
    Cosine: ("cosine", {}),
    InRange: ("range", {}),
    Law: ("law", {}),
    Monotony: ("monotony", {"under": Kind.PLAIN, "premise": Kind.PREMISE}),
    Have: ("have", {"claim": Kind.CLAIM, "branches": Kind.PREMISES}),
    Derivative: (
        "derivative",
        {
            "variable": Kind.PLAIN,
            "at": Kind.TERM,
            "term": Kind.TERM,
            "side": Kind.PLAIN,
            "strict": Kind.PLAIN,
            "start": Kind.PREMISE,
            "order": Kind.PREMISE,
            "sign": Kind.PREMISE,
            "bounds": Kind.PREMISES,
        },
    ),
    Define: ("define", {}),
    Instance: (
        "instance",
        {"of": Kind.PLAIN, "at": Kind.TERMS, "givens": Kind.PREMISES},
    ),
    Applying: ("instance", {"givens": Kind.PREMISES}),
    Induction: ("induction", {"start": Kind.PREMISES, "next": Kind.PREMISES}),
    Witness: (
        "witness",
        {"at": Kind.TERMS, "givens": Kind.PREMISES, "negation": Kind.PROOF},
    ),
}


def rule_of(proof: Proof) -> str:
    """The name of the rule by which a proof shows its claim."""
    return RULES[type(proof)][0]
