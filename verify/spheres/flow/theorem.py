"""One collision of the flow as a statement: what a scene applies to each of its collisions."""

from __future__ import annotations

from functools import cache

from verify.language.argument import Argument, argue
from verify.language.statement import Assumption
from verify.spheres.flow import changes, collision, pairs, readings

NAME = "flow"
TITLE = (
    "One collision of three inelastic hard spheres in inner products, for every state from which "
    "it is the next one"
)
#: What the flow takes on trust: its own definition.
ASSUMPTIONS = (
    Assumption("hard-spheres", "EQUATSS2.1VitesPost-Colli",
         "Three spheres of equal mass and diameter 1 move freely until two of them are at distance "
         "1 and approach each other. If these are o and c, and ω is the unit vector from o to c, "
         "then v_o and v_c become v_o + J ω and v_c - J ω with J = (1+r)/2 (v_c - v_o)·ω; the "
         "third keeps its velocity.", "definition"),
)  # fmt: skip


@cache
def flow() -> Argument:
    """The statement, built once per process."""
    ends = (*readings.chapters(), *pairs.chapters())
    parts = (*collision.chapters(), *changes.chapters(), *ends)
    return argue(NAME, TITLE, parts, ASSUMPTIONS)
