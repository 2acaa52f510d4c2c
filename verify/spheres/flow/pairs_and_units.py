"""Two readings of a state: its three pairs, and the paper's letters with unit vectors."""

from __future__ import annotations

from collections.abc import Callable

from verify.language.record import Record
from verify.spheres.flow.law import Keep, Number, Pair, State, inner, outer, unnamed

THREE = ("c", "s", "outer")


class Unit(Record):
    """The state with ω_c = x_c/reach: -ω_c·W_c, x_s·W_s, -x_s·ω_c, ω_c·W_s and reach - 1."""

    reach: Number
    closing: Number
    parting: Number
    cosine: Number
    turning: Number
    distance: Number


def pairs_of(state: State, keep: Keep = unnamed) -> dict[str, Pair]:
    """The pairs o, c and o, s and s, c."""
    found = zip(THREE, (*inner(state), outer(state)), strict=True)
    return {
        name: Pair(*(keep(f"{f}_{name}", getattr(pair, f)) for f in Pair._fields))
        for name, pair in found
    }


def unit_of(state: State, root: Callable[[Number], Number], keep: Keep = unnamed) -> Unit:
    """The numbers of the state in the paper's letters."""
    gap = state.eps * state.v**2
    reach = keep("reach", root(1 + gap))
    return Unit(
        reach,
        keep("closing", state.lam * state.v / reach),
        keep("parting", state.rho * state.v),
        keep("cosine", state.C / reach),
        keep("turning", state.b / reach),
        keep("distance", gap / (1 + reach)),
    )
