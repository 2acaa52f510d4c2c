"""A scene as an SVG file (spheres to scale, how the end comes near), or as an animation."""

from __future__ import annotations

import json
import math
from collections.abc import Callable, Iterable, Iterator, Sequence
from itertools import islice

from verify.language.record import Record
from verify.prover import balls
from verify.views.plots.approach import HIGH, SIDE, approach, counted, length_unit
from verify.views.plots.drawing import standalone, svg
from verify.views.plots.shapes import Disc, Panel, Point, Scale, Shape, Trace, Words, round_below
from verify.views.scene import Step, Told
from verify.views.style import SCHEMES

COLOURS = ("series-1", "series-2", "series-3")
#: How far the drawing goes on after the last collision, as a share of the time before it.
AFTER = 0.4


def scene_svg(told: Told, steps: Sequence[Step]) -> str:
    """The file."""
    path, radii, unit = legs(told, steps), bodies_of(told).radii, length_unit(told)
    panels = [_trajectories(path, end_time(told, path), radii, unit), approach(told, steps)]
    titles = "; ".join(panel.title for panel in panels)
    return standalone(svg("scene", panels, f"Three spheres: {titles}", told.lines))


def end_time(told: Told, path: Sequence[Leg]) -> float:
    """Until when it is drawn: the collapse, or some time after the last collision."""
    if told.time is not None:
        return float(told.time[1])
    return path[-1].time + (AFTER * path[-1].time or 1.0)


def _square(title: str, middle: Point, half: float, drawn: Callable[[], Iterator[Shape]]) -> Panel:
    """A panel without axes, of so much of the plane to each side of a point."""
    x, y = (Scale("", at - half, at + half, ()) for at in middle)
    return Panel(title, x, y, drawn, "", SIDE, HIGH, axes=False)


def _trajectories(path: Sequence[Leg], end: float, radii: Sequence[float], unit: str) -> Panel:
    """The paths of the centres, and the spheres at the start and at the end."""
    last = places_at(path, end)
    stops = [leg.places for leg in path] + [last]
    sides = [sorted(p[k] for places in stops for p in places) for k in (0, 1)]
    x, y = ((side[0] + side[-1]) / 2 for side in sides)
    half = max(side[-1] - side[0] for side in sides) / 2 + 1.2 * max(radii)

    def drawn() -> Iterator[Shape]:
        for i, colour in enumerate(COLOURS):
            yield Trace([_at(places[i]) for places in stops], colour)
        yield from _spheres(path[0].places, "2 3", radii)
        yield from _spheres(last, "", radii)
        corner, bar = (x - half, y - 0.98 * half), round_below(half)
        yield Trace([corner, (corner[0] + bar, corner[1])], "ink")
        yield Words((corner[0], corner[1] - half / 10), counted(bar, unit))
        yield Words((x + half, corner[1] - half / 10), "dotted: start; filled: end", "end")

    return _square("centre-of-mass frame, to scale", (x, y), half, drawn)


def _spheres(
    places: Sequence[Sequence[float]], dashes: str, radii: Sequence[float]
) -> Iterator[Shape]:
    for i, (place, radius) in enumerate(zip(places, radii, strict=True)):
        yield Disc(_at(place), radius, COLOURS[i], dashes, filled=not dashes)
        if not dashes:
            yield Words(_at(place), str(i), "middle")


def _at(place: Sequence[float]) -> Point:
    return place[0], place[1]


# --- the animation -------------------------------------------------------------------------------


def scene_page(told: Told, steps: Iterable[Step]) -> str:
    """The file."""
    from verify.views.template import in_html  # loads the templates' library

    path = legs(told, steps, most=60)
    points = [p for leg in path for p in leg.places]
    radii = bodies_of(told).radii
    low, high = (
        [best(p[k] for p in points) + 1.4 * room for k in (0, 1)]
        for best, room in ((min, -max(radii)), (max, max(radii)))
    )
    box = {"x": (low[0] + high[0]) / 2, "y": (low[1] + high[1]) / 2}
    box |= {"width": high[0] - low[0], "height": high[1] - low[1]}
    data = {
        "legs": [leg._asdict() for leg in path],
        "end": end_time(told, path),
        "colours": COLOURS,
        "radii": radii,
        "unit": told.scene.labels.time_unit,
        "box": box,
    }
    schemes = {
        name: " ".join(f"--{key}: {value};" for key, value in colours.items())
        for name, colours in SCHEMES.items()
    }
    content = {"told": told.lines, "data": json.dumps(data).replace("<", "\\u003c"), **schemes}
    return in_html("scene.html", content) + "\n"


# --- where the spheres are: floats, which follow the certain collisions ---------------------------


Vector = list[float]


class Sizes(Record):
    """Masses and radii."""

    masses: Sequence[float]
    radii: Sequence[float]


def bodies_of(told: Told) -> Sizes:
    """The masses and radii of a scene."""
    bodies = told.scene.bodies
    if bodies is None:
        return Sizes((1.0,) * 3, (0.5,) * 3)
    return Sizes([float(mass) for mass in bodies.masses], [float(x) for x in bodies.radii])


class Leg(Record):
    """From a time on all spheres move straight; ``pair`` has just collided, if any."""

    time: float
    pair: str
    places: list[Vector]
    velocities: list[Vector]


def legs(told: Told, steps: Iterable[Step], most: int = 200) -> list[Leg]:
    """The flight after the start and after each collision, seen from the centre of mass."""
    scene, masses = told.scene, bodies_of(told).masses
    x = [[float(a) for a in row] for row in scene.positions]
    v = [[float(a) for a in row] for row in scene.velocities]
    x, v = _centred(x, masses), _centred(v, masses)
    path = [Leg(0.0, "", x, v)]
    with balls.precision(told.bits):
        for step in islice(steps, most):
            time = balls.as_float(step.time)
            x = [_moved(a, time - path[-1].time, b) for a, b in zip(x, v, strict=True)]
            v = _collided(x, v, step.hit, float(scene.restitution(*step.hit)), masses)
            path.append(Leg(time, step.pair, x, v))
    return _in_plane(path)


def places_at(path: Sequence[Leg], time: float) -> list[Vector]:
    """The centres at a time."""
    leg = next((leg for leg in reversed(path) if leg.time <= time), path[0])
    pairs = zip(leg.places, leg.velocities, strict=True)
    return [_moved(x, time - leg.time, v) for x, v in pairs]


def _moved(x: Vector, time: float, v: Vector) -> Vector:
    return [a + time * b for a, b in zip(x, v, strict=True)]


def _centred(rows: list[Vector], masses: Sequence[float]) -> list[Vector]:
    middle = [_dot(masses, column) / sum(masses) for column in zip(*rows, strict=True)]
    return [[a - b for a, b in zip(row, middle, strict=True)] for row in rows]


def _collided(
    x: list[Vector], v: list[Vector], pair: tuple[int, int], r: float, masses: Sequence[float]
) -> list[Vector]:
    i, j = pair
    e = [b - a for a, b in zip(x[i], x[j], strict=True)]
    length = math.sqrt(_dot(e, e)) or 1.0
    e = [part / length for part in e]
    a, b = masses[i], masses[j]
    push = (1 + r) / (a + b) * _dot(e, [q - p for p, q in zip(v[i], v[j], strict=True)])
    new = list(v)
    new[i], new[j] = _moved(v[i], b * push, e), _moved(v[j], -(a * push), e)
    return new


def _dot(x: Sequence[float], z: Sequence[float]) -> float:
    return sum(a * b for a, b in zip(x, z, strict=True))


def _in_plane(path: list[Leg]) -> list[Leg]:
    """The path projected to the plane of the three centres at its end."""
    first, second = _basis(path[-1].places)

    def flat(rows: list[Vector]) -> list[Vector]:
        return [[_dot(row, first), _dot(row, second)] for row in rows]

    return [Leg(leg.time, leg.pair, flat(leg.places), flat(leg.velocities)) for leg in path]


def _basis(x: list[Vector]) -> tuple[Vector, Vector]:
    """Two orthonormal vectors; in the plane they are the usual ones, on a line the second is 0."""
    axes = [[float(i == k) for i in range(len(x[0]))] for k in range(len(x[0]))]
    if len(axes) <= 2:
        return axes[0], [*axes, [0.0]][1]
    spans = [_moved(x[2], -1.0, x[1]), _moved(x[0], -1.0, x[1]), *axes]
    found: list[Vector] = []
    for span in spans:
        rest = list(span)
        for unit in found:
            rest = _moved(rest, -_dot(rest, unit), unit)
        length = math.sqrt(_dot(rest, rest))
        if length > 1e-9 and len(found) < 2:
            found.append([a / length for a in rest])
    return found[0], found[1]
