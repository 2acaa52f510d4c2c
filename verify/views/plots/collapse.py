"""A collapse as an animation without scripts, and the proved bounds of its time.

What moves are floats that follow the certain collisions. The scale grows from collision to
collision, so that the gaps stay as large in the drawing as they were; each flight takes the same
time on the screen.
"""

from __future__ import annotations

import math
from collections.abc import Iterable, Iterator, Sequence
from fractions import Fraction
from html import escape

from verify.language.record import Record
from verify.prover.decimals import short
from verify.views.findings import Instant, Story
from verify.views.plots.drawing import begun
from verify.views.plots.scene_drawing import Leg, Vector, legs, places_at
from verify.views.plots.shapes import Areas, Figure, Panel, Scale, Shape, powers

WIDTH, HEIGHT, RADIUS, GAP = 420, 262, 50, 48
CENTRE = (WIDTH / 2, 98)
#: Seconds of a flight on the screen, and the shares of it at which the places are computed.
FLIGHT, PARTS = 1.8, 8
COLOURS = ("series-1", "series-2", "series-3")


def figure(shown: Story, name: str, title: str) -> Figure:
    """The figure: its first panel is drawn by `animation`."""
    first = next(one for one in shown.instants if one.collapse is not None)
    last = shown.instants[-1]
    caption = (
        f"The gaps are to scale, and the scale grows with each collision; the spheres are "
        f"not, and each flight takes {FLIGHT:g} seconds on the screen. After collision "
        f"{first.number} the sharper theorem shows that collisions go on for ever, at times that "
        f"tend to one between {_between(first)}; this is in the certificate. In the same way ball "
        f"arithmetic shows after collision {last.number} that it lies between {_between(last)}. "
        f"Each bar is what is shown, just after that collision, of the time that is left."
    )
    return Figure(name, title, caption, (_bounds(shown),), moves=True)


def _between(one: Instant) -> str:
    return " and ".join(one.told)


# --- the bounds ----------------------------------------------------------------------------------


def _bounds(shown: Story) -> Panel:
    ends = [one for one in shown.instants if one.collapse is not None]
    latest = ends[-1].time[0]
    bars = [
        (
            one.number,
            float(max(latest - one.time[1], Fraction(0))),
            float(one.collapse[1] - one.time[0]),
        )
        for one in ends
        if one.collapse is not None
    ]
    least = math.floor(math.log10(bars[-1][2])) - 1
    most = math.ceil(math.log10(bars[0][2]))
    x = Scale(
        "after collision", bars[0][0] - 0.7, bars[-1][0] + 0.7, [(n, str(n)) for n, *_ in bars]
    )
    step = 1 + (most - least) // 8
    y = Scale("time left", 10.0**least, 10.0**most, powers(least, most, step), logarithmic=True)

    def drawn() -> Iterable[Shape]:
        floor = 10.0**least
        boxes = [(n - 0.3, n + 0.3, max(low, floor), high) for n, low, high in bars]
        yield Areas(boxes, "proved-area", 0.8, "proved bounds of the time left")

    told = (
        f"{len(bars)} bars, one for each collision from number {bars[0][0]} on; the time that is "
        f"left falls from below {bars[0][2]:.1e} to below {bars[-1][2]:.1e}, nearly on a straight "
        "line: each flight is shorter than the one before by about the same factor."
    )
    return Panel("How long it can still take", x, y, drawn, told)


# --- the animation -------------------------------------------------------------------------------


class Film(Record):
    """A collapse as it moves: the particle in the middle, the flights, and the collisions."""

    middle: int
    path: Sequence[Leg]
    instants: Sequence[Instant]


def film(story: Story) -> Film:
    """What there is to see of a collapse."""
    return Film(story.scene.central, legs(story.scene, story.steps), story.instants)


def animation(shown: Film, name: str) -> str:
    """One SVG element that moves by its style sheet; where nothing may move it shows a state."""
    stops = [leg.time for leg in shown.path]
    frames = [_frame(shown, k, j / PARTS) for k in range(len(stops) - 1) for j in range(PARTS)]
    frames.append(_frame(shown, len(stops) - 2, 1.0))
    others = [i for i in range(3) if i != shown.middle]
    first = next(one.number for one in shown.instants if one.collapse is not None)
    total = FLIGHT * len(stops)
    rules = [
        f"#{name}-{i}{{animation:{name}-{i} {total:g}s linear infinite}}"
        f"@keyframes {name}-{i}{{{_keys([frame[i] for frame in frames], len(stops))}}}"
        for i in others
    ]
    lines = list(_lines(shown))
    rules += [
        f"#{name}-t{number}{{animation:{name}-t{number} {total:g}s step-end infinite}}"
        f"@keyframes {name}-t{number}{{{_shown(number, len(stops))}}}"
        for number in range(len(lines))
    ]
    still = frames[PARTS * first]
    body = [_sphere(shown.middle, (0.0, 0.0), "")]
    body += [_sphere(i, still[i], f"{name}-{i}") for i in others]
    for number, (head, *rest) in enumerate(lines):
        hidden = "" if number == first else ' opacity="0"'
        spans = "".join(f'<tspan x="14" dy="19">{escape(line)}</tspan>' for line in rest)
        body.append(
            f'<text id="{name}-t{number}" x="14" y="{HEIGHT - 48}" fill="var(--ink)"{hidden}>'
            f"{escape(head)}{spans}</text>"
        )
    told = (
        f"Three spheres, {shown.middle} in the middle. It is hit in turn by the two others, "
        f"{len(shown.instants)} times here; the gaps between them shrink each time, and the scale "
        "grows with them. Below stands between what times the collapse is proved to lie."
    )
    head = begun(WIDTH, HEIGHT, told, 'role="img" class="moving"')
    return "\n".join([head, f"<style>{''.join(rules)}</style>", *body, "</svg>"])


def _frame(shown: Film, k: int, part: float) -> dict[int, tuple[float, float]]:
    """Where the two other spheres are drawn, seen from the middle one, during a flight."""
    start, end = shown.path[k].time, shown.path[k + 1].time
    places = places_at(shown.path[k : k + 1], start + part * (end - start))
    scale = _largest(shown, k) ** (1 - part) * _largest(shown, k + 1) ** part
    return {
        i: _drawn(places[shown.middle], place, scale)
        for i, place in enumerate(places)
        if i != shown.middle
    }


def _drawn(middle: Vector, other: Vector, scale: float) -> tuple[float, float]:
    (a, b), distance = _seen(middle, other)
    length = 2 * RADIUS + GAP * min(max(distance - 1, 0) / scale, 1.2)
    return a * length, -b * length


def _seen(middle: Vector, other: Vector) -> tuple[tuple[float, float], float]:
    """The direction to another centre, and how far it is."""
    a, b = other[0] - middle[0], other[1] - middle[1]
    distance = math.hypot(a, b)
    return (a / distance, b / distance), distance


def _largest(shown: Film, k: int) -> float:
    """The larger one of the two gaps at the start of a flight."""
    places = shown.path[k].places
    others = [place for i, place in enumerate(places) if i != shown.middle]
    return max(_seen(places[shown.middle], place)[1] - 1 for place in others)


def _keys(places: Sequence[tuple[float, float]], flights: int) -> str:
    """Key frames that move a sphere, and leave it where it is in the last flight."""
    keys = []
    for number, (x, y) in enumerate(places):
        share = 100 * number / PARTS / flights
        at = f"{share:.3g}%,100%" if number == len(places) - 1 else f"{share:.3g}%"
        keys.append(f"{at}{{transform:translate({x:.1f}px,{y:.1f}px)}}")
    return "".join(keys)


def _shown(number: int, flights: int) -> str:
    """Key frames that show a text during one flight."""
    low, high = 100 * number / flights, 100 * (number + 1) / flights
    before = "0%{opacity:0}" if number else ""
    after = f"{high:.3g}%{{opacity:0}}" if number + 1 < flights else ""
    return f"{before}{low:.3g}%{{opacity:1}}{after}"


def _lines(shown: Film) -> Iterator[Sequence[str]]:
    """What stands below: before the first collision, and after each."""
    yield "the start", "no two have collided"
    for one in shown.instants:
        gap = _largest(shown, one.number)
        rounded = Fraction(f"{gap:.1e}")
        size = short((rounded, rounded), 2)
        pair = " and ".join(shown.path[one.number].pair)
        head = f"after collision {one.number}, of {pair}: the other gap is {size}"
        if one.collapse is None:
            yield head, "nothing is proved of the end yet"
        else:
            low, high = one.told
            yield head, f"collapse after time {low}", f"and before {high}"


def _sphere(i: int, at: tuple[float, float], name: str) -> str:
    key = f' id="{name}"' if name else ""
    x, y = CENTRE
    return (
        f'<g transform="translate({x:g} {y:g})"><g{key} transform="translate({at[0]:.1f} '
        f'{at[1]:.1f})"><circle r="{RADIUS}" fill="var(--{COLOURS[i]})" fill-opacity=".2" '
        f'stroke="var(--{COLOURS[i]})" stroke-width="2"/><text text-anchor="middle" y="6" '
        f'font-size="18" fill="var(--ink)">{i}</text></g></g>'
    )
