"""The rule *interval*: the enclosures of the two sides decide."""

from __future__ import annotations

from verify.language.record import Record
from verify.prover.proof import Kind, Kinds


class Interval(Record):
    """Evaluate both sides with ``bits`` bits.

    ``bounds`` has for each variable the names of a fact that bounds it from below and of one that
    bounds it from above, in an order in which each bound can be evaluated.
    """

    bits: int
    bounds: tuple[tuple[str, str, str], ...] = ()


KINDS: Kinds = {"bits": Kind.PLAIN, "bounds": Kind.BOUNDS}
