"""The rule *cases*: a minimum or maximum is one of its entries."""

from __future__ import annotations

from verify.language.record import Record
from verify.language.terms import Term
from verify.prover.proof import Kind, Kinds, Proof


class Cases(Record):
    """One branch for each entry."""

    of: Term
    branches: tuple[Proof, ...]


KINDS: Kinds = {"of": Kind.TERM, "branches": Kind.PREMISES}
