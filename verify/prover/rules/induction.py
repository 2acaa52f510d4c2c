"""The rule *induction*: what holds at the start and goes on holds always."""

from __future__ import annotations

from verify.language.record import Record
from verify.prover.proof import Kind, Kinds, Premise


class Induction(Record):
    """For each carried given, why it holds at the start and at the next state."""

    start: tuple[Premise, ...]
    next: tuple[Premise, ...]


KINDS: Kinds = {"start": Kind.PREMISES, "next": Kind.PREMISES}
