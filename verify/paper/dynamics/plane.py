"""Cauchy-Schwarz where both velocities are normal but for parts orthogonal to all else.

For W_s = eta_s omega_s + ... and W_c = -y omega_c + ..., the dots orthogonal to one another and to
the omegas, each inequality is a sum of squares. This shows that what is assumed of the vectors of
every state does not contradict the rest.
"""

from __future__ import annotations

from collections.abc import Iterable, Iterator

from verify.language.argument import Item, Line, Value, plus, power, proof, square, times
from verify.language.statement import Context, Given, Variable
from verify.language.terms import Term, as_term, symbol
from verify.language.vectors import Frame
from verify.paper.dynamics.state import inequalities

CONTEXT = "plane"
NAMES = ("u_y", "u_s", "u_C", "u_A", "u_B", "u_d", "u_t")
y, eta_s, C, A, B, d, t = map(symbol, NAMES)


def aligned(y: Term, eta_s: Term, C: Term, A: Term, B: Term, d: Term) -> Frame:
    """The inner products of such vectors."""
    return Frame(y, eta_s, C, y * C, -(eta_s * C), A, B, eta_s * y * C, d)


def context() -> Context:
    """A cosine, and norms that leave room for the normal parts."""
    values = {name: as_term(1 if name in ("u_A", "u_B") else 0) for name in NAMES}
    givens = (
        Given("u-angle", C**2 <= 1),
        Given("u-room-c", y**2 <= A),
        Given("u-room-s", eta_s**2 <= B),
    )
    variables = tuple(Variable(name, name, name) for name in NAMES)
    return Context(CONTEXT, variables, givens, values, None, "velocities with orthogonal parts")


def lines(names: Iterable[str]) -> Iterator[Item]:
    """Each of the inequalities that a state assumes."""
    for name, claim in inequalities(aligned(y, eta_s, C, A, B, d), t, names).items():
        yield Line(f"{CONTEXT}-{name}", claim, proof(*_squares()[name]))


def _squares() -> dict[str, tuple[Value, ...]]:
    angle, room_c, room_s = "u-angle", "u-room-c", "u-room-s"
    height, reach = square(1 + d - t * y), square(1 + t * eta_s)
    y2, s2, t2 = square(y), square(eta_s), square(t)
    apart = plus(square(1 + (1 + d) * C), times(square(1 + d), angle))
    path = plus(height, times(t2, room_c))
    return {
        "cs-omega": (angle,),
        "cs-s": (room_s,),
        "cs-c": (room_c,),
        "cs-a": (room_c, times(y2, angle)),
        "cs-b": (room_s, times(s2, angle)),
        "cs-w": (
            times(room_s, plus(room_c, y2)),
            times(s2, room_c),
            times(s2, y2, angle),
        ),
        "cs-outer": (room_c, room_s, times(s2, angle)),
        "cs-apart": (
            times(square(y + (1 + d) * eta_s), angle),
            times(apart, plus(room_c, room_s)),
        ),
        "cs-impact": (
            times(room_s, path),
            times(s2, plus(times(height, angle), times(t2, room_c))),
        ),
        "cs-angle": (
            times(height, reach, angle),
            times(height, t2, room_s),
            times(t2, room_c, reach),
            times(power(t2, 2), room_c, room_s),
        ),
    }
