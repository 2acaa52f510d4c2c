"""A scene as an SVG file (spheres to scale, a zoom, how the end comes near), or as an animation."""

from __future__ import annotations

import json
import math
from collections.abc import Callable, Iterable, Iterator, Sequence
from html import escape
from itertools import islice

from verify.language.record import Record
from verify.prover import balls
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
    width = 3 * SIZE + 4 * MARGIN
    height = SIZE + TOP + MARGIN
    size = f'viewBox="0 0 {width} {height}" font-family="sans-serif" font-size="13"'
    parts = [
        f'<svg xmlns="http://www.w3.org/2000/svg" {size}>',
        _style(),
        f'<rect class="paper" width="{width}" height="{height}"/>',
        *_heading(told),
    ]
    panels = (_trajectories(path, end), _zoom(path, end), approach(told, steps))
    titles = ("centre-of-mass frame, to scale", "zoom on a contact", "how the end comes near")
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


def svg_text(x: float, y: float, text: str, anchor: str = "start") -> str:
    """A text at a place."""
    where = f'x="{x:.2f}" y="{y:.2f}" text-anchor="{anchor}"'
    return f'<text class="ink" {where}>{escape(text)}</text>'


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


def _trajectories(path: Sequence[Leg], end: float) -> Iterator[str]:
    """The paths of the centres, and the spheres at the start and at the end."""
    last = places_at(path, end)
    stops = [leg.places for leg in path] + [last]
    box = _frame([p for places in stops for p in places], 0.6)
    for i in range(3):
        line = " ".join("{:.2f},{:.2f}".format(*_point(places[i], box)) for places in stops)
        yield f'<polyline class="c{i}" points="{line}"/>'
    yield from _spheres(path[0].places, box, "2 3")
    yield from _spheres(last, box, "")


def _zoom(path: Sequence[Leg], end: float) -> Iterator[str]:
    """The gap of the pair that collided last, at the start, after collisions, and at the end."""
    stops = [leg.places for leg in path[:6]] + [places_at(path, end)]
    i, j = map(int, path[-1].pair or "01")
    (x, y), _ = _contact(stops[-1][i], stops[-1][j])
    gaps = [abs(_contact(places[i], places[j])[1]) for places in stops]
    half = max(2 * max(gaps), 1e-6)
    box = x, y, half, SIZE / (2 * half)
    for places in stops[:-1]:
        yield from _spheres(places, box, "2 6")
    yield from _spheres(stops[-1], box, "")
    yield svg_text(6, SIZE - 8, f"{i} and {j}; the width is {2 * half:.2g} diameters")


def _contact(p: Sequence[float], z: Sequence[float]) -> tuple[tuple[float, float], float]:
    """The point midway between two centres, and the gap between the spheres."""
    middle = (p[0] + z[0]) / 2, (p[1] + z[1]) / 2
    return middle, math.hypot(p[0] - z[0], p[1] - z[1]) - 1


def _spheres(places: Sequence[Sequence[float]], box: Box, dashes: str) -> Iterator[str]:
    for i, place in enumerate(places):
        x, y = _point(place, box)
        radius = box[3] / 2
        circle = f'cx="{x:.2f}" cy="{y:.2f}" r="{radius:.2f}"'
        if dashes:
            yield f'<circle class="c{i}" {circle} stroke-dasharray="{dashes}"/>'
        else:
            yield f'<circle class="f{i}" {circle}/><circle class="c{i}" {circle}/>'
            yield svg_text(x, y, str(i), "middle")


# --- time to collapse, and distance --------------------------------------------------------------


def approach(told: Told, steps: Iterable[Step]) -> Iterator[str]:
    """Distance against time to the collapse, on logarithmic axes, with their enclosures."""
    points = approach_points(told, steps)
    if not points:
        yield svg_text(20, SIZE / 2, "no collapse to come near to")
        return
    times = [t for t, _, _ in points] + [t for _, t, _ in points]
    low_x, high_x = math.floor(min(times)), math.ceil(max(times))
    sizes = [d for _, _, d in points]
    low_y, high_y = math.floor(min(sizes)), math.ceil(max(sizes))

    def place(x: float, y: float) -> tuple[float, float]:
        across = 44 + (SIZE - 60) * (x - low_x) / max(high_x - low_x, 1)
        return across, SIZE - 44 - (SIZE - 60) * (y - low_y) / max(high_y - low_y, 1)

    yield from _axes(place, (low_x, high_x), (low_y, high_y))
    for low, high, size in points:
        (x, y), (x_high, _) = place(low, size), place(high, size)
        yield f'<line class="c0" x1="{x:.2f}" y1="{y:.2f}" x2="{x_high:.2f}" y2="{y:.2f}"/>'
        yield f'<circle class="c0" cx="{(x + x_high) / 2:.2f}" cy="{y:.2f}" r="3"/>'


def approach_points(told: Told, steps: Iterable[Step]) -> list[tuple[float, float, float]]:
    """log10 of the least and largest time to the collapse, and of the distance, per collision."""
    if told.time is None:
        return []
    points = []
    with balls.precision(told.bits):
        for step in steps:
            low, high = balls.ends(balls.as_ball(step.time))
            size = balls.as_float(step.after.d)
            if told.time[0] > high and size > 0:
                least, most = float(told.time[0] - high), float(told.time[1] - low)
                points.append((math.log10(least), math.log10(most), math.log10(size)))
    return points


def _axes(place: Place, xs: tuple[int, int], ys: tuple[int, int]) -> Iterator[str]:
    (left, bottom), (right, top) = place(xs[0], ys[0]), place(xs[1], ys[1])
    yield f'<path class="axis" d="M{left:.1f} {top:.1f}V{bottom:.1f}H{right:.1f}"/>'
    for x in range(xs[0], xs[1] + 1, max(1, (xs[1] - xs[0]) // 5)):
        yield svg_text(place(x, ys[0])[0], bottom + 18, _ten(x), "middle")
    for y in range(ys[0], ys[1] + 1, max(1, (ys[1] - ys[0]) // 6)):
        yield svg_text(left - 6, place(xs[0], y)[1] + 4, _ten(y), "end")
    yield svg_text((left + right) / 2, bottom + 36, "time to collapse", "middle")
    yield svg_text(left, top - 4, "distance d of the next pair")


def _ten(exponent: int) -> str:
    digits = str(exponent).translate(str.maketrans("-0123456789", "⁻⁰¹²³⁴⁵⁶⁷⁸⁹"))
    return f"10{digits}"


# --- the animation -------------------------------------------------------------------------------


def scene_page(told: Told, steps: Iterable[Step]) -> str:
    """The file."""
    from verify.views.setting import in_html  # loads the templates' library

    path = legs(told, steps, most=60)
    points = [p for leg in path for p in leg.places]
    low = [min(p[k] for p in points) - 0.7 for k in (0, 1)]
    high = [max(p[k] for p in points) + 0.7 for k in (0, 1)]
    box = {"x": (low[0] + high[0]) / 2, "y": (low[1] + high[1]) / 2}
    box |= {"width": high[0] - low[0], "height": high[1] - low[1]}
    data = {
        "legs": [leg._asdict() for leg in path],
        "end": end_time(told, path),
        "colours": COLOURS,
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


class Leg(Record):
    """From a time on all spheres move straight; ``pair`` has just collided, if any."""

    time: float
    pair: str
    places: list[Vector]
    velocities: list[Vector]


def legs(told: Told, steps: Iterable[Step], most: int = 200) -> list[Leg]:
    """The flight after the start and after each collision, seen from the centre of mass."""
    scene, r = told.scene, float(told.scene.r)
    x = [[float(a) for a in row] for row in scene.positions]
    v = [[float(a) for a in row] for row in scene.velocities]
    x, v = _centred(x), _centred(v)
    path = [Leg(0.0, "", x, v)]
    with balls.precision(told.bits):
        for step in islice(steps, most):
            time = balls.as_float(step.time)
            x = [_moved(a, time - path[-1].time, b) for a, b in zip(x, v, strict=True)]
            v = _collided(x, v, step.hit, r)
            path.append(Leg(time, step.pair, x, v))
    return _in_plane(path)


def places_at(path: Sequence[Leg], time: float) -> list[Vector]:
    """The centres at a time."""
    leg = next((leg for leg in reversed(path) if leg.time <= time), path[0])
    pairs = zip(leg.places, leg.velocities, strict=True)
    return [_moved(x, time - leg.time, v) for x, v in pairs]


def _moved(x: Vector, time: float, v: Vector) -> Vector:
    return [a + time * b for a, b in zip(x, v, strict=True)]


def _centred(rows: list[Vector]) -> list[Vector]:
    middle = [sum(column) / 3 for column in zip(*rows, strict=True)]
    return [[a - b for a, b in zip(row, middle, strict=True)] for row in rows]


def _collided(x: list[Vector], v: list[Vector], pair: tuple[int, int], r: float) -> list[Vector]:
    i, j = pair
    e = [b - a for a, b in zip(x[i], x[j], strict=True)]
    length = math.sqrt(_dot(e, e)) or 1.0
    e = [a / length for a in e]
    push = (1 + r) / 2 * _dot(e, [b - a for a, b in zip(v[i], v[j], strict=True)])
    new = list(v)
    new[i], new[j] = _moved(v[i], push, e), _moved(v[j], -push, e)
    return new


def _dot(x: Vector, z: Vector) -> float:
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
