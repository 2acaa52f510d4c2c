"""A scene as an SVG file (spheres to scale, a zoom, how the end comes near), or as an animation."""

from __future__ import annotations

import json
import math
from collections.abc import Callable, Iterable, Iterator, Sequence
from itertools import islice

from verify.language.record import Record
from verify.prover import balls
from verify.views.plots.approach import approach, length_unit, several, svg_text
from verify.views.plots.drawing import SCHEMES
from verify.views.scene import Step, Told

SIZE, MARGIN, TOP = 420, 46, 92
COLOURS = ("series-1", "series-2", "series-3")
#: How far the drawing goes on after the last collision, as a share of the time before it.
AFTER = 0.4

Box = tuple[float, float, float, float]
Place = Callable[[float, float], tuple[float, float]]


def scene_svg(told: Told, steps: Sequence[Step]) -> str:
    """The file."""
    path = legs(told, steps)
    end = end_time(told, path)
    across = 3 * SIZE + 4 * MARGIN
    height = SIZE + TOP + MARGIN
    size = f'viewBox="0 0 {across} {height}" font-family="sans-serif" font-size="13"'
    parts = [
        f'<svg xmlns="http://www.w3.org/2000/svg" {size}>',
        _style(),
        f'<rect class="paper" width="{across}" height="{height}"/>',
        *_heading(told),
    ]
    radii, unit = bodies_of(told).radii, length_unit(told)
    zoom, width = _zoom(path, end, radii)
    panels = (_trajectories(path, end, radii, unit), zoom, approach(told, steps))
    pair = " and ".join(path[-1].pair or "01")
    titles = (
        "centre-of-mass frame, to scale",
        f"contact of {pair}, {width:.2g} {several(unit)} wide",
        "from collision to collision",
    )
    for k, (panel, title) in enumerate(zip(panels, titles, strict=True)):
        left = MARGIN + k * (SIZE + MARGIN)
        parts.append(f'<g transform="translate({left} {TOP})">')
        parts.append(svg_text(0, -8, title))
        parts.append(f'<svg width="{SIZE}" height="{SIZE}" overflow="hidden">')
        parts += [*panel, "</svg></g>"]
    return "\n".join([*parts, "</svg>", ""])


def end_time(told: Told, path: Sequence[Leg]) -> float:
    """Until when it is drawn: the collapse, or some time after the last collision."""
    if told.time is not None:
        return float(told.time[1])
    return path[-1].time + (AFTER * path[-1].time or 1.0)


def _style() -> str:
    rules = []
    for scheme, colours in SCHEMES.items():
        found = [".paper{fill:%(paper)s}.ink{fill:%(ink)s}.axis{stroke:%(faint)s;fill:none}"]
        found += [f".c{i}{{stroke:%({name})s;fill:none}}" for i, name in enumerate(COLOURS)]
        found += [f".f{i}{{fill:%({name})s;fill-opacity:.25}}" for i, name in enumerate(COLOURS)]
        text = "".join(found) % colours
        dark = f"@media (prefers-color-scheme: dark){{{text}}}"
        rules.append(text if scheme == "light" else dark)
    return f"<style>{''.join(rules)}</style>"


def _heading(told: Told) -> Iterator[str]:
    for k, line in enumerate(told.lines):
        yield svg_text(MARGIN, 28 + 20 * k, line)


def _frame(points: Sequence[Sequence[float]], room: float) -> Box:
    """A square around points: its centre, and half its side."""
    low = [min(p[k] for p in points) for k in (0, 1)]
    high = [max(p[k] for p in points) for k in (0, 1)]
    half = max(high[0] - low[0], high[1] - low[1]) / 2 + room
    return (low[0] + high[0]) / 2, (low[1] + high[1]) / 2, half, SIZE / (2 * half)


def _point(p: Sequence[float], box: Box) -> tuple[float, float]:
    x, y, half, scale = box
    return (p[0] - x + half) * scale, (y + half - p[1]) * scale


def _trajectories(
    path: Sequence[Leg], end: float, radii: Sequence[float], unit: str
) -> Iterator[str]:
    """The paths of the centres, and the spheres at the start and at the end."""
    last = places_at(path, end)
    stops = [leg.places for leg in path] + [last]
    box = _frame([p for places in stops for p in places], 1.2 * max(radii))
    for i in range(3):
        line = " ".join("{:.2f},{:.2f}".format(*_point(places[i], box)) for places in stops)
        yield f'<polyline class="c{i}" points="{line}"/>'
    yield from _spheres(path[0].places, box, "2 3", radii)
    yield from _spheres(last, box, "", radii)
    yield f'<path class="axis" d="M12 {SIZE - 24}v6M12 {SIZE - 21}h{box[3]:.2f}v-3v6"/>'
    yield svg_text(12, SIZE - 6, f"1 {unit}")


def _zoom(path: Sequence[Leg], end: float, radii: Sequence[float]) -> tuple[Iterator[str], float]:
    """The gap of the pair that collided last, at several moments; and the width of the drawing."""
    stops = [leg.places for leg in path[:6]] + [places_at(path, end)]
    i, j = map(int, path[-1].pair or "01")
    ends = radii[i], radii[j]
    (x, y), _ = _contact(stops[-1][i], stops[-1][j], ends)
    gaps = [abs(_contact(places[i], places[j], ends)[1]) for places in stops]
    half = max(2 * max(gaps), 1e-6)
    return _zoomed(stops, (x, y, half, SIZE / (2 * half)), radii), 2 * half


def _zoomed(stops: Sequence[Sequence[Vector]], box: Box, radii: Sequence[float]) -> Iterator[str]:
    for places in stops[:-1]:
        yield from _spheres(places, box, "2 6", radii)
    yield from _spheres(stops[-1], box, "", radii)


def _contact(
    p: Sequence[float], z: Sequence[float], radii: tuple[float, float]
) -> tuple[tuple[float, float], float]:
    """The point between two centres where the spheres touch, and the gap between them."""
    a, b = radii
    middle = (p[0] * b + z[0] * a) / (a + b), (p[1] * b + z[1] * a) / (a + b)
    return middle, math.hypot(p[0] - z[0], p[1] - z[1]) - (a + b)


def _spheres(
    places: Sequence[Sequence[float]], box: Box, dashes: str, radii: Sequence[float]
) -> Iterator[str]:
    for i, place in enumerate(places):
        x, y = _point(place, box)
        radius = box[3] * radii[i]
        circle = f'cx="{x:.2f}" cy="{y:.2f}" r="{radius:.2f}"'
        if dashes:
            yield f'<circle class="c{i}" {circle} stroke-dasharray="{dashes}"/>'
        else:
            yield f'<circle class="f{i}" {circle}/><circle class="c{i}" {circle}/>'
            yield svg_text(x, y, str(i), "middle")


# --- the animation -------------------------------------------------------------------------------


def scene_page(told: Told, steps: Iterable[Step]) -> str:
    """The file."""
    from verify.views.setting import in_html  # loads the templates' library

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
        "box": box,
    }
    schemes = {
        name: " ".join(f"--{key}: {value};" for key, value in colours.items())
        for name, colours in SCHEMES.items()
    }
    content = {"told": told.lines, "data": json.dumps(data), **schemes}
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
    scene, r, masses = told.scene, float(told.scene.r), bodies_of(told).masses
    x = [[float(a) for a in row] for row in scene.positions]
    v = [[float(a) for a in row] for row in scene.velocities]
    x, v = _centred(x, masses), _centred(v, masses)
    path = [Leg(0.0, "", x, v)]
    with balls.precision(told.bits):
        for step in islice(steps, most):
            time = balls.as_float(step.time)
            x = [_moved(a, time - path[-1].time, b) for a, b in zip(x, v, strict=True)]
            v = _collided(x, v, step.hit, r, masses)
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
    """Two orthonormal vectors; in the plane they are the usual ones."""
    axes = [[float(i == k) for i in range(len(x[0]))] for k in range(len(x[0]))]
    if len(axes) == 2:
        return axes[0], axes[1]
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
