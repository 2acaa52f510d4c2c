"""What the flow takes on trust: its own definition."""

from __future__ import annotations

from verify.language.statement import Assumption

ASSUMPTIONS = (
    Assumption("hard-spheres", "EQUATSS2.1VitesPost-Colli",
         "Three spheres of equal mass and diameter 1 move freely until two of them are at distance "
         "1 and approach each other. If these are o and c, and ω is the unit vector from o to c, "
         "then v_o and v_c become v_o + J ω and v_c - J ω with J = (1+r)/2 (v_c - v_o)·ω; the "
         "third keeps its velocity.", "definition"),
)  # fmt: skip
