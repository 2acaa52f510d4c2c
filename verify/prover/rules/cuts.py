"""The rule *cuts*: a term lies between neighbouring cuts."""

from __future__ import annotations

from fractions import Fraction

from verify.language.record import Record
from verify.language.terms import Term
from verify.prover.proof import Kind, Kinds, Proof


class Cuts(Record):
    """One branch below the first cut, one between any two neighbours, one above the last."""

    term: Term
    at: tuple[Fraction, ...]
    branches: tuple[Proof, ...]


KINDS: Kinds = {"term": Kind.TERM, "at": Kind.RATIONALS, "branches": Kind.PREMISES}
