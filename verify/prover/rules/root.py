"""The rule *root*: the root of a positive number is positive."""

from __future__ import annotations

from verify.language.record import Record
from verify.prover.proof import Kinds


class Root(Record):
    """The radicand has a fact that it is positive."""


KINDS: Kinds = {}
