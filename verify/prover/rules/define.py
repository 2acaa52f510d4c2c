"""The rule *define*: a term that clears has a value."""

from __future__ import annotations

from verify.language.record import Record
from verify.prover.proof import Kinds


class Define(Record):
    """Every divisor and radicand of the term has a fact that shows its sign."""


KINDS: Kinds = {}
