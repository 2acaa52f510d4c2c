"""The rule *antisymmetry*: two numbers are equal if each is at most the other."""

from __future__ import annotations

from verify.language.record import Record
from verify.prover.proof import Kind, Kinds, Proof


class Antisymmetry(Record):
    """A proof that the left side is at most the right one, and one of the other order."""

    branches: tuple[Proof, Proof]


KINDS: Kinds = {"branches": Kind.PREMISES}
