"""The rule *define*: a term that clears has a value."""

from __future__ import annotations

from typing import NamedTuple

from verify.prover.proof import Kinds


class Define(NamedTuple):
    """Every divisor and radicand of the term has a fact that shows its sign."""


KINDS: Kinds = {}
