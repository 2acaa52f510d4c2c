"""The conditions hold at the start, and for some vectors with the same normal components."""

from __future__ import annotations

from collections.abc import Iterator, Mapping

from verify.language.argument import (
    ByInstance,
    ByRoot,
    Item,
    Line,
    Value,
    plus,
    power,
    proof,
    square,
    times,
)
from verify.language.terms import Term, substitute_claim
from verify.paper.dynamics import plane
from verify.paper.dynamics.state import frame, inequalities, root_of, time_of
from verify.paper.sharper.numbers import C_0, V_0, V, start
from verify.paper.sharper.state import PAIRS, beginning, conditions, point, point_frame

#: Conditions that the point has under names of its own; of the others it says what the start says.
OWN = ("Cnd3", "root-sum", "A-upper", "B-upper", "angle-upper", "angle-lower")


def zeta_small(prefix: str, bound: str) -> Value:
    """Why zeta <= 2 k V^2, where d <= k y^2 and the bound is |W_c|^2 <= V^2."""
    d, d2 = f"{prefix}d-positive", power(f"{prefix}d-sum-positive", 2)
    return plus(
        times(d, plus(2, d), bound),
        times(2, d2, square(V), f"{prefix}d-small"),
        times(square(V), power(d, 2), plus(3, times(2, d))),
    )


def root_lines(prefix: str, values: Mapping[str, Term], reason: Value) -> Iterator[Line]:
    """Zeta < 1 for these values, and so there is a root; given why zeta <= 2 k V^2."""
    names = "start-" if prefix == "at-" else prefix
    room = times(power(f"{names}d-sum-positive", 2), power(f"{names}Cnd1", 2), "zeta-room")
    claims = {name: substitute_claim(c, values) for name, c in conditions().items()}
    root = substitute_claim(0 < root_of(frame), values)
    yield Line(f"{prefix}Cnd3", claims["Cnd3"], proof(reason, room), says="ζ < 1")
    yield Line(f"{prefix}root", root, ByRoot())
    yield Line(f"{prefix}root-sum", claims["root-sum"], proof(1, f"{prefix}root"))


def lines() -> Iterator[Item]:
    """First at the start, then at the point."""
    claims = {name: substitute_claim(c, beginning) for name, c in conditions().items()}
    faster = times("speed-least", plus("speed-least", times(2, "V_0-positive")))
    more = times("V-above", plus("V-above", times(2, "V_0-positive")))
    says = "the condition holds for n = 0"
    reasons = {
        "g-bound": proof(),
        "d-sum-positive": proof(1, "start-d-positive"),
        "A-upper": proof("start-A-bound", faster),
        "B-upper": proof("start-B-bound", faster),
        "clock-bound": proof(),
    }
    for name, reason in reasons.items():
        yield Line(f"start-{name}", claims[name], reason, says=says)
    yield Line("start-A-below", start.A <= V**2, proof("start-A-bound", more))
    yield from root_lines("start-", beginning, zeta_small("start-", "start-A-below"))
    yield Line("at-A-below", V_0**2 <= V**2, proof(more))
    yield from root_lines("at-", point, zeta_small("start-", "at-A-below"))
    yield from _at_the_point(faster)
    yield from _vectors()


def _at_the_point(faster: Value) -> Iterator[Item]:
    claims = {name: substitute_claim(c, point) for name, c in conditions().items()}
    for name in ("A-upper", "B-upper"):
        yield Line(f"at-{name}", claims[name], proof(faster))
    for name in ("angle-upper", "angle-lower"):
        yield Line(f"at-{name}", claims[name], proof("Theta-room"))


def _vectors() -> Iterator[Item]:
    """Cauchy-Schwarz at the point."""
    p = point_frame
    slower = times("speed-start", plus("eta_0-positive", "V_0-positive"))
    smaller = times("start-Cnd2", plus("start-Cnd1", "eta_0-positive"))
    least = times("start-Cnd1", "ratio-below")
    along = times(plus("start-ratio-upper", least), plus("start-Cnd1", "start-recedes"))
    angle = proof(times("angle-real", plus(1, "obtuse", "Theta-positive")))
    yield Line("at-angle", C_0**2 <= 1, angle)
    yield Line("at-room-c", p.y**2 <= p.A, proof(slower, smaller))
    yield Line("at-room-s", p.eta_s**2 <= p.B, proof(slower, smaller, along))
    time = time_of(p)
    values = {"u_y": p.y, "u_s": p.eta_s, "u_C": p.C, "u_A": p.A, "u_B": p.B, "u_d": p.d}
    values["u_t"] = time
    givens = ("at-angle", "at-room-c", "at-room-s")
    for name, claim in inequalities(p, time, PAIRS).items():
        yield Line(f"at-{name}", claim, ByInstance(f"{plane.CONTEXT}-{name}", values, givens))


def opening() -> tuple[str, ...]:
    """Why the givens of a state hold at the point."""
    carried = (f"at-{n}" if n in OWN else f"start-{n}" for n in conditions())
    return (*carried, *(f"at-{name}" for name in PAIRS))
