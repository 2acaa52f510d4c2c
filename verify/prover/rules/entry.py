"""The rule *entry*: a minimum is at most each of its entries, a maximum at least."""

from __future__ import annotations

from verify.language.record import Record
from verify.prover.proof import Kind, Kinds


class Entry(Record):
    """``equation`` names the fact that the ``side`` of the claim is a minimum (maximum), if any."""

    side: str
    equation: str | None = None


KINDS: Kinds = {"side": Kind.PLAIN, "equation": Kind.PLAIN}
