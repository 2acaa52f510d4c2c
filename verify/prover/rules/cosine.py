"""The rule *cosine*: partial sums of the series of a cosine are above it and below, in turn."""

from __future__ import annotations

from verify.language.record import Record
from verify.prover.proof import Kinds


class Cosine(Record):
    """The coefficients are read off the claim."""


KINDS: Kinds = {}
