"""Two readings of a state: its three pairs, and the paper's letters with unit vectors."""

from __future__ import annotations

from collections.abc import Callable

from verify.language.record import Record
from verify.spheres.flow.law import EQUAL, Keep, Number, Pair, Sizes, State, inner, outer, unnamed

THREE = ("c", "s", "outer")


class Unit(Record):
    """The state with ω_c = x_c/reach: -ω_c·W_c, x_s·W_s, -x_s·ω_c, ω_c·W_s and reach - 1.

    Where spheres are not equal, the lengths of each pair are in units of its distance of contact.
    """

    reach: Number
    closing: Number
    parting: Number
    cosine: Number
    turning: Number
    distance: Number


def pairs_of(state: State, keep: Keep = unnamed, sizes: Sizes = EQUAL) -> dict[str, Pair]:
    """The pairs o, c and o, s and s, c."""
    found = zip(THREE, (*inner(state), outer(state, sizes)), strict=True)
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


def scaled_unit_of(
    state: State, contacts: tuple[Number, Number], root: Callable[[Number], Number], keep: Keep
) -> Unit:
    """The numbers of the state in the letters of the theorem on three balls.

    The contacts are the distances at which o touches c and s.
    """
    (c, s), gap = contacts, state.eps * state.v**2
    reach = keep("reach", root(c**2 + gap))
    return Unit(
        reach,
        keep("closing", state.lam * state.v / reach / c),
        keep("parting", state.rho * state.v / s / s),
        keep("cosine", state.C / reach / s),
        keep("turning", state.b / reach / s),
        keep("distance", gap / c / (c + reach)),
    )
