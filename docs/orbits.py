"""The orbits of `docs/explanation/alexander.md`: over one base point, and with both speeds tuned.

Three equal balls in the plane are followed, in decimals of many digits; nothing rests on them. As a
program it writes the picture.
"""

from __future__ import annotations

from collections.abc import Iterator, Mapping, Sequence
from decimal import Decimal, localcontext
from pathlib import Path

from verify.language.record import Record
from verify.views.plots.drawing import standalone, svg
from verify.views.plots.shapes import Curve, Panel, Scale, Shape, marks, powers

PICTURE = Path(__file__).parent / "explanation/alexander.svg"
Vector = tuple[Decimal, Decimal]
#: The coefficient of restitution.
R = Decimal("0.03")
#: The base point: q, the closing speed, -cos θ; both tangential speeds are 1.
Q, Y, C = Decimal("0.1"), Decimal("0.01"), Decimal("0.99")
#: How much larger or smaller κ is at the start than on the border, with the strokes of its curve.
OFFSETS = {"0.01": "", "0.0001": "6 2", "0": "1.5 3", "-0.0001": "6 2", "-0.01": ""}
MOST = 15


class State(Record):
    """Just after a collision of 0 with s, seen from 0; c is next, at the distance 1 + d."""

    at_s: Vector
    at_c: Vector
    v_s: Vector
    v_c: Vector
    d: Decimal

    @property
    def kappa(self) -> Decimal:
        """The gap over the square of the closing speed."""
        return self.d / dot(self.v_c, self.at_c) ** 2


def start(kappa: Decimal) -> State:
    """The state over the base point with this κ."""
    s, c = (-C, (1 - C * C).sqrt()), (Decimal(1), Decimal(0))
    v_s = plus((s[1], -s[0]), Q * Y, s)
    return State(s, c, v_s, (-Y, Decimal(1)), kappa * Y * Y)


def after(state: State, r: Decimal = R) -> State | None:
    """The state after the collision with c, or None where there is none."""
    speed, d = -dot(state.v_c, state.at_c), state.d
    root = ((1 + d) * speed) ** 2 - dot(state.v_c, state.v_c) * d * (2 + d)
    if speed <= 0 or root <= 0:
        return None
    time = d * (2 + d) / ((1 + d) * speed + root.sqrt())
    zero = (Decimal(0), Decimal(0))
    contact = plus(plus(zero, 1 + d, state.at_c), time, state.v_c)
    end = plus(state.at_s, time, state.v_s)
    closing, reach = -dot(state.v_c, contact), dot(end, end).sqrt()
    v_s = plus(state.v_c, (1 + r) * closing, contact)
    v_c = plus(state.v_s, (1 + r) / 2 * closing, contact)
    return State(contact, plus(zero, 1 / reach, end), v_s, v_c, reach - 1)


def orbit(kappa: Decimal, most: int) -> list[Decimal]:
    """κ after each collision, until they end or there are so many."""
    state: State | None = start(kappa)
    found: list[Decimal] = []
    while state is not None and len(found) <= most:
        found.append(state.kappa)
        state = after(state)
    return found


def border() -> Decimal:
    """The largest κ from which there are 60 collisions in turn."""
    low, high = Decimal(0), Decimal(1)
    for _ in range(150):
        middle = (low + high) / 2
        low, high = (middle, high) if len(orbit(middle, 60)) > 60 else (low, middle)
    return low


def without_momentum(collisions: int) -> tuple[Decimal, Decimal, State]:
    """Tangential speeds from which there are so many collisions, an even number, and their end.

    At r = 0.06, with -cos θ = 0.97 and the gap 1/1000. What is left of the tangential speeds after
    2, 4, 8 and more collisions is taken from those at the start.
    """
    r, c = Decimal("0.06"), Decimal("0.97")
    a = (1 + r) / 2 * c
    q = (a - (a * a - 4 * r).sqrt()) / 2
    at_s, at_c = (Decimal(1), Decimal(0)), (-c, (1 - c * c).sqrt())
    at_start = [Decimal(0), Decimal(0)]
    followed = 1
    while followed < collisions:
        followed = min(2 * followed, followed + 32, collisions)
        for _ in range(6):
            speeds = zip((at_s, at_c), (q, Decimal(-1)), at_start, strict=True)
            v_s, v_c = ((h * x - t * y, h * y + t * x) for (x, y), h, t in speeds)
            state = State(at_s, at_c, v_s, v_c, Decimal("0.001"))
            for _ in range(followed):
                following = after(state, r)
                if following is None:
                    raise ArithmeticError(f"there are no {followed} collisions")
                state = following
            left = cross(state.at_s, state.v_s), cross(state.at_c, state.v_c)
            at_start = [t - rest for t, rest in zip(at_start, left, strict=True)]
    return *at_start, state


def dot(a: Vector, b: Vector) -> Decimal:
    """a·b."""
    return a[0] * b[0] + a[1] * b[1]


def cross(a: Vector, b: Vector) -> Decimal:
    """The speed b in the direction of a turned by a right angle."""
    return a[0] * b[1] - a[1] * b[0]


def plus(a: Vector, factor: Decimal, b: Vector) -> Vector:
    """A + factor b."""
    return a[0] + factor * b[0], a[1] + factor * b[1]


def drawn() -> str:
    """The picture."""
    with localcontext() as context:
        context.prec = 160
        at = border()
        orbits = {offset: orbit(at * (1 + Decimal(offset)), MOST) for offset in OFFSETS}
    x = Scale("collisions", 0, MOST + 0.5, marks("0", "5", "10", "15"))
    y = Scale("", 1e-3, 1, powers(-3, 0), logarithmic=True)
    told = "κ after each collision: two orbits that begin close together move apart."
    panel = Panel("κ = d/y²", x, y, lambda: curves(orbits), told, 440, 400)
    return standalone(svg("orbits", [panel], told))


def curves(orbits: Mapping[str, Sequence[Decimal]]) -> Iterator[Shape]:
    """One for each orbit, as long as κ is within the picture."""
    for number, (offset, found) in enumerate(orbits.items(), 1):
        points = [(float(n), float(kappa)) for n, kappa in enumerate(found) if 1e-3 < kappa < 1]
        name = f"κ*(1 {'-+'[offset > '0']} {offset.lstrip('-')})" if offset != "0" else "κ*"
        yield Curve(points, f"series-{number}", number % 3, name, OFFSETS[offset])


if __name__ == "__main__":
    PICTURE.write_text(drawn(), encoding="utf-8")
