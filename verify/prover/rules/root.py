"""The rule *root*: the root of a positive number is positive."""

from __future__ import annotations

from typing import NamedTuple

from verify.prover.proof import Kinds


class Root(NamedTuple):
    """The radicand has a fact that it is positive."""


KINDS: Kinds = {}
