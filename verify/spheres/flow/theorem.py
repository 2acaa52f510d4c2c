"""One collision of the flow as a statement: what a scene applies to each of its collisions."""

from __future__ import annotations

from functools import cache

from verify.language.argument import Argument, argue
from verify.spheres.flow import changes, collision, pairs, readings
from verify.spheres.flow.assumptions import ASSUMPTIONS

NAME = "flow"
TITLE = (
    "One collision of three inelastic hard spheres in inner products, for every state from which "
    "it is the next one"
)


@cache
def flow() -> Argument:
    """The statement, built once per process."""
    ends = (*readings.chapters(), *pairs.chapters())
    parts = (*collision.chapters(), *changes.chapters(), *ends)
    return argue(NAME, TITLE, parts, ASSUMPTIONS)
