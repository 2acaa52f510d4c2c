"""The rule *angles*: 2 cos u cos v = cos (u + v) + cos (u - v)."""

from __future__ import annotations

from verify.language.record import Record
from verify.prover.proof import Kinds


class Angles(Record):
    """The angles are read off the claim."""


KINDS: Kinds = {}
