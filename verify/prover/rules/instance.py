"""The rule *instance*: what holds for all values that satisfy the givens holds for these."""

from __future__ import annotations

from collections.abc import Mapping

from verify.language.record import Record
from verify.language.terms import Term
from verify.prover.proof import Kind, Kinds, Premise


class Instance(Record):
    """The fact ``of`` at values for the variables of its context, which satisfy its givens."""

    of: str
    at: Mapping[str, Term]
    givens: tuple[Premise, ...]


class Applying(Record):
    """The values in the claim itself satisfy the givens of its context."""

    givens: tuple[Premise, ...]


INSTANCE_KINDS: Kinds = {"of": Kind.PLAIN, "at": Kind.TERMS, "givens": Kind.PREMISES}
APPLYING_KINDS: Kinds = {"givens": Kind.PREMISES}
