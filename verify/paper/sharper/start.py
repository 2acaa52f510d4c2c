"""The conditions hold at the start, and for some vectors with the same normal components."""

from __future__ import annotations

from collections.abc import Iterator

from verify.language.terms import substitute_claim
from verify.paper.argument import ByInstance, BySum, Item, Line, Value, plus, power, proof, times
from verify.paper.dynamics.plane import CONTEXT as PLANE
from verify.paper.dynamics.state import inequalities, tau_of
from verify.paper.sharper.numbers import C_0, V_0, V, start
from verify.paper.sharper.state import PAIRS, beginning, conditions, point, point_frame

#: Conditions that the point has under names of its own; of the others it says what the start says.
OWN = ("A-positive", "Cnd3", "A-upper", "B-upper", "angle-upper", "angle-lower")


def zeta_below(prefix: str, size: str, bound: str) -> BySum:
    """Zeta < 1, where d <= k y^2 and |W_c|^2 <= V^2: `size` says 0 < |W_c|^2, and `bound` that."""
    d, d_small = f"{prefix}d-positive", f"{prefix}d-small"
    d2, y2 = power(f"{prefix}d-sum-positive", 2), power(f"{prefix}Cnd1", 2)
    return proof(
        times(2, d2, size, d_small),
        times(2, "k-positive", d2, y2, bound),
        times(size, power(d, 2), plus(3, times(2, d))),
        times(d2, y2, "zeta-room"),
    )


def lines() -> Iterator[Item]:
    """First at the start, then at the point."""
    claims = {name: substitute_claim(c, beginning) for name, c in conditions().items()}
    faster = times("speed-least", plus("speed-least", times(2, "V_0-positive")))
    more = times("V-above", plus("V-above", times(2, "V_0-positive")))
    reasons: dict[str, BySum] = {
        "g-bound": proof(),
        "d-sum-positive": proof(1, "start-d-positive"),
        "Cnd3": zeta_below("start-", "start-A-positive", "start-A-below"),
        "A-upper": proof("start-A-bound", faster),
        "B-upper": proof("start-B-bound", faster),
        "clock-bound": proof(),
    }
    yield Line("start-A-below", start.A <= V**2, proof("start-A-bound", more))
    for name, reason in reasons.items():
        yield Line(f"start-{name}", claims[name], reason, says="the condition holds for n = 0")
    yield from _at_the_point(faster, more)


def _at_the_point(faster: Value, more: Value) -> Iterator[Item]:
    claims = {name: substitute_claim(c, point) for name, c in conditions().items()}
    reasons = {
        "A-positive": proof(power("V_0-positive", 2)),
        "Cnd3": zeta_below("start-", "at-A-positive", "at-A-below"),
        "A-upper": proof(faster),
        "B-upper": proof(faster),
        "angle-upper": proof("Theta-room"),
        "angle-lower": proof("Theta-room"),
    }
    yield Line("at-A-below", V_0**2 <= V**2, proof(more))
    for name in OWN:
        yield Line(f"at-{name}", claims[name], reasons[name])
    yield from _vectors()


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
    time = tau_of(p)
    values = {"u_y": p.y, "u_s": p.eta_s, "u_C": p.C, "u_A": p.A, "u_B": p.B, "u_d": p.d}
    values["u_t"] = time
    givens = ("at-angle", "at-room-c", "at-room-s")
    for name, claim in inequalities(p, time, PAIRS).items():
        yield Line(f"at-{name}", claim, ByInstance(f"{PLANE}-{name}", values, givens))


def opening() -> tuple[str, ...]:
    """Why the givens of a state hold at the point."""
    carried = (f"at-{n}" if n in OWN else f"start-{n}" for n in conditions())
    return (*carried, *(f"at-{name}" for name in PAIRS))
