"""The rule *witness*: values that satisfy the givens, at which the claim is false."""

from __future__ import annotations

from collections.abc import Mapping

from verify.language.record import Record
from verify.language.terms import Term
from verify.prover.proof import Kind, Kinds, Premise, Proof


class Witness(Record):
    """The values, why they satisfy the givens, and a proof of the negation there."""

    at: Mapping[str, Term]
    givens: tuple[Premise, ...]
    negation: Proof


KINDS: Kinds = {"at": Kind.TERMS, "givens": Kind.PREMISES, "negation": Kind.PROOF}
