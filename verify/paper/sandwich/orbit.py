"""One step of the map of two numbers (Q, U), by which the next state is bounded."""

from __future__ import annotations

from collections.abc import Iterator

from verify.language.argument import (
    ByRoot,
    Defined,
    Item,
    Line,
    identity,
    plus,
    power,
    proof,
    scaled,
    times,
)
from verify.language.terms import as_term, equal, sqrt
from verify.paper.sandwich.comparison import LABEL
from verify.paper.sandwich.numbers import G_POSITIVE, U_b, model
from verify.paper.sandwich.state import Q, Q_next, U, U_next, carried, load, pace, rho

PUSH = times("rho-positive", "U-positive")


def lines() -> Iterator[Item]:
    """P, Q' and U', and where they lie."""
    radicand = 1 - load / pace / pace
    both = times(plus("U-room", "U-next-one"), power("pace-positive", 2))
    yield from (
        Line("Q-positive", 0 < Q, scaled(times("goal", "Cnd1"), "q-bound", "recedes")),
        Defined("rho"),
        Line("rho-positive", 0 < rho,
             proof(times(G_POSITIVE, power("w_s-positive", 2)), using="rho")),
        Defined("pace"),
        Line("pace-positive", 0 < pace, proof("approaches", using="pace")),
        Line("pace-law", equal(pace, model.alpha * (1 - U) - Q - rho * U), identity("pace rho"),
             LABEL, "P = α(1-U) - Q - ρU"),
        Defined("load"),
        Line("load-law", equal(load, rho * U * (2 * Q + rho * U)), identity("load rho"),
             LABEL, "P²(1-(1-U')²) = ρU(2Q+ρU)"),
        Line("load-positive", 0 < load,
             proof(times(PUSH, plus(times(2, "Q-positive"), PUSH)),
                   using="load-law")),
        Defined("Q_next"),
        Line("Q-next-law", equal(Q_next * pace, model.share * (1 - U)), identity("Q_next"),
             LABEL, "Q' = R(1-U)/P"),
        Line("meets-here", load <= U_b * (2 - U_b) * pace**2, proof("meets", using="load pace")),
        Line("radicand", 0 < radicand,
             proof("meets-here", times(power("U-room", 2), power("pace-positive", 2)))),
        Line("map-root", 0 < sqrt(radicand), ByRoot()),
        Defined("U_next"),
        Line("U-next-law", equal(U_next * (2 - U_next) * pace**2, load),
             identity("U_next"), LABEL, "1-(1-U')² = ρU(2Q+ρU)/P²"),
        Line("U-next-one", 0 < 1 - U_next, proof("map-root", using="U_next")),
        Line("next-U-bound", carried.at_next("U-bound"),
             scaled(times("goal", both), "meets-here", equations=(("U-next-law", as_term(-1)),)),
             says="U' ≤ U*"),
    )  # fmt: skip
