"""What every proof has, and the steps of a certificate. Nothing here is trusted.

There is one class of proofs for each rule of the kernel, in the file of that name in
`verify.prover.rules`; its fields are those of the certificate.
"""

from __future__ import annotations

from collections.abc import Mapping
from enum import Enum
from typing import Any

from verify.language.record import Record
from verify.language.terms import Claim, Term

#: A number that is >= 0 for all values in scope: a rational or the name of a fact as a text,
#: "goal", or a tuple: ("add" | "mul", value, …), ("pow", value, exponent), ("square" | "root",
#: term).
Value = str | tuple[object, ...]


def product_of(*values: Value) -> Value:
    """The product of values, without factors 1."""
    kept = [value for value in values if value != "1"]
    return kept[0] if len(kept) == 1 else ("mul", *kept) if kept else "1"


def sum_of(*values: Value) -> Value:
    """The sum of values, of which there is one at least."""
    return values[0] if len(values) == 1 else ("add", *values)


def power_of(value: Value, exponent: int) -> Value:
    """The power of a value."""
    return value if exponent == 1 else ("pow", value, exponent)


class Kind(Enum):
    """How a field of a proof is written down."""

    PLAIN = "plain"  # a name, a number, a list of these, or None
    RATIONALS = "rationals"
    BOUNDS = "bounds"  # triples of names
    TERM = "term"
    TERMS = "terms"  # a table of terms
    PROOF = "proof"
    CLAIM = "claim"  # that compares two terms
    PREMISE = "premise"  # a proof, or the name of a fact
    PREMISES = "premises"  # a list of proofs and names of facts
    VALUES = "values"
    COFACTORS = "cofactors"  # pairs of a name and a term


Kinds = Mapping[str, Kind]

#: A proof of a claim by one rule: a value of one of the classes in `verify.prover.rules`.
Proof = tuple[Any, ...]

#: What shows that a given holds: the name of a fact, or a proof.
Premise = str | Proof


class ConstantStep(Record):
    """The definition of a constant of the statement has a value."""

    name: str
    proof: Proof


class DefinitionStep(Record):
    """A name that the certificate introduces for a term."""

    name: str
    context: str | None
    term: Term
    proof: Proof


class LemmaStep(Record):
    """A claim that the certificate proves on the way."""

    name: str
    context: str | None
    claim: Claim
    proof: Proof


class ObligationStep(Record):
    """An obligation of the statement, or its negation."""

    name: str
    proof: Proof


class OpenStep(Record):
    """The givens of a context hold at its point."""

    name: str
    givens: tuple[Premise, ...]


Step = ConstantStep | DefinitionStep | LemmaStep | ObligationStep | OpenStep
