"""The rule *least*: what is less than each entry is less than their minimum."""

from __future__ import annotations

from verify.language.record import Record
from verify.prover.proof import Kind, Kinds, Proof


class Least(Record):
    """One branch for each entry of the minimum (on the left side: the maximum)."""

    side: str
    branches: tuple[Proof, ...]
    equation: str | None = None


KINDS: Kinds = {"side": Kind.PLAIN, "branches": Kind.PREMISES, "equation": Kind.PLAIN}
