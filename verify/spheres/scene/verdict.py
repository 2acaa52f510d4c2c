"""The verdict on a scene in a sentence, with short decimals that enclose its numbers."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from fractions import Fraction
from itertools import pairwise

from verify.language.record import Record
from verify.prover import balls
from verify.prover.decimals import exact_number, outward, short
from verify.spheres.flow.collapse import LINE, SANDWICH, SHARPER, THREE_BALLS, Start, start_of
from verify.spheres.flow.contexts import FLOW, FLOW_OF_BALLS, TOUCHING
from verify.spheres.flow.follow import RECENTRE, name_of
from verify.spheres.flow.law import Number
from verify.spheres.scene.criteria import SAYS, SAYS_OF_UNEQUAL
from verify.spheres.scene.decide import COLLAPSES, DISPERSES, FINITE, Fate
from verify.spheres.scene.energy import energy_lost, normal_speeds
from verify.spheres.scene.scene import Scene
from verify.spheres.scene.statement import CLASSIFICATION, CLASSIFICATION_OF_BALLS

#: Bits of an angle in degrees, of which at most 60 digits are shown.
ANGLE_BITS = 512
#: An enclosure of a time that is longer is told with fewer digits.
MOST_LETTERS = 40
#: How the theorems on collapses are called.
WORDS = {
    LINE: "theorem on a line",
    SHARPER: "sharper theorem",
    SANDWICH: "sandwich theorem",
    THREE_BALLS: "theorem on three balls",
}


class Told(Record):
    """What is told of a scene; ``time`` and ``angle`` enclose those of a collapse.

    ``reason`` is a name, and ``says`` tells it; ``event`` encloses the time of what is known to
    happen although it is no verdict; ``energy`` encloses what all collisions take; ``degrees`` is
    the angle of a collapse for a reader, empty without one.
    """

    scene: Scene
    bits: int
    verdict: str
    reason: str
    says: str
    theorems: Sequence[str]
    central: int | None
    collisions: int
    pairs: Sequence[str]
    time: tuple[Fraction, Fraction] | None
    angle: tuple[Fraction, Fraction] | None
    event: tuple[Fraction, Fraction] | None
    energy: tuple[Fraction, Fraction]
    impacts: Sequence[Impact]
    lines: Sequence[str]
    degrees: str


class Impact(Record):
    """A collision: its pair, and between what its time and the normal speed before it lie."""

    pair: str
    time: tuple[Fraction, Fraction]
    speed: tuple[Fraction, Fraction]


class Step(Record):
    """A collision: its pair (o and c), its time, the normal speed before, the state after it."""

    pair: str
    hit: tuple[int, int]
    time: Number
    speed: Number
    after: Start


def told(found: Fate) -> Told:
    """The verdict on a scene, with its numbers in decimals."""
    end = found.collapse
    return Told(
        found.flow.scene,
        found.flow.bits,
        found.verdict,
        found.name,
        reason(found),
        theorems(found),
        central(found),
        found.collisions,
        pairs_of(found),
        time_ends(found),
        None if end is None else end.angle,
        event_ends(found),
        energy_lost(found),
        list(impacts(found)),
        list(scene_lines(found)),
        "" if end is None else degrees(end.angle),
    )


def steps(found: Fate) -> Iterator[Step]:
    """The collisions that were followed, each seen from the particle that collides next, too."""
    moves = found.flow.moves
    seen = {id(a): b.after for a, b in pairwise(moves) if b.kind == RECENTRE}
    with balls.precision(found.flow.bits):
        speeds = normal_speeds(found)
        for move, speed in zip(found.flow.collisions, speeds, strict=True):
            o, _, c = move.before.frame
            now = seen.get(id(move), move.after)
            after = start_of(now.state, found.flow.sizes(now.frame))
            yield Step(name_of(move.before.frame), (o, c), move.after.time, speed, after)


def impacts(found: Fate) -> Iterator[Impact]:
    """The collisions that were followed, in decimals."""
    bits, speeds = found.flow.bits, normal_speeds(found)
    for move, speed in zip(found.flow.collisions, speeds, strict=True):
        time = ball_ends(move.after.time, bits)
        yield Impact(name_of(move.before.frame), time, ball_ends(speed, bits))


def pairs_of(found: Fate) -> list[str]:
    """The pairs that collide, in order."""
    return [name_of(move.before.frame) for move in found.flow.collisions]


def central(found: Fate) -> int | None:
    """The particle that collides with the two others in turn for ever."""
    now = found.flow.now
    return now.frame[0] if found.collapse is not None and now is not None else None


def ball_ends(value: Number, bits: int) -> tuple[Fraction, Fraction]:
    """Rational numbers around a ball."""
    with balls.precision(bits):
        return balls.ends(balls.as_ball(value))


def time_ends(found: Fate) -> tuple[Fraction, Fraction] | None:
    """The enclosure of the time of the collapse."""
    if found.collapse is None:
        return None
    low, high = (ball_ends(end, found.flow.bits) for end in found.collapse.time)
    return low[0], high[1]


def event_ends(found: Fate) -> tuple[Fraction, Fraction] | None:
    """The enclosure of the time of what happens exactly."""
    return None if found.event is None else ball_ends(found.event.time, found.flow.bits)


def reason(found: Fate) -> str:
    """What shows the verdict, or why there is none."""
    if found.verdict == COLLAPSES:
        which = WORDS[found.name]
        holds = f"the conditions of the {which} hold after the last collision"
        return f"{holds}; not as tight as asked for: {found.reason}" if found.reason else holds
    if found.criterion is not None:
        words = SAYS if found.flow.scene.bodies is None else SAYS_OF_UNEQUAL
        return words[found.criterion.name]
    return found.reason


def theorems(found: Fate) -> list[str]:
    """The names of the theorems on which a verdict rests; none without a verdict."""
    are_equal = found.flow.scene.bodies is None
    flow = FLOW if are_equal else FLOW_OF_BALLS
    finite = CLASSIFICATION if are_equal else CLASSIFICATION_OF_BALLS
    last = {COLLAPSES: [found.name], FINITE: [finite], DISPERSES: []}
    if found.verdict not in last:
        return []
    moves = [] if is_settled_at_start(found) else found.flow.moves
    touching = [TOUCHING] if any(move.weights is not None for move in moves) else []
    return [flow, *touching, *last[found.verdict]]


def is_settled_at_start(found: Fate) -> bool:
    """Whether no collision has to be followed for the verdict."""
    return found.criterion is not None and found.criterion.at_start


def scene_lines(found: Fate) -> Iterator[str]:
    """The verdict for a reader."""
    count = found.collisions
    after = f"after {count} collision{'' if count == 1 else 's'}"
    time, end, labels = time_ends(found), found.collapse, found.flow.scene.labels
    unit = f" {labels.time_unit}" if labels.time_unit else ""
    if labels.title:
        yield labels.title
    if end is not None and time is not None and found.flow.now is not None:
        o, s, c = found.flow.now.frame
        pairs = ", ".join(f"{min(o, x)}{max(o, x)}" for x in (c, s, c))
        yield (
            f"collapses: particle {o} central; from collision {count + 1} on {pairs}, … for ever;"
        )
        low, high = shown_ends(time)
        least, most = shown_ends(end.angle)
        yield f"collapse time in [{low}, {high}]{unit}; final -cos θ in [{least}, {most}]"
        if found.reason:
            yield f"not as tight as asked for: {found.reason}"
    elif found.verdict == FINITE:
        yield f"finite: {reason(found)};"
        yield "only finitely many collisions are possible, unless three touch at once or two graze"
    elif found.verdict == DISPERSES:
        yield (
            f"disperses: {after} no two collide again"
            if count
            else "disperses: no two ever collide"
        )
    else:
        when = event_ends(found)
        at = "" if when is None else f", at the time {_event_time(when)}{unit}"
        certain = f"certain: {count} collision{'' if count == 1 else 's'}"
        yield f"undecided: {found.reason}{at}; {certain}"
    if labels.length_unit:
        unit = labels.length_unit
        in_diameters = found.flow.scene.is_in_diameters
        yield f"lengths are in diameters, each {unit}" if in_diameters else f"lengths are in {unit}"


def degrees(neg_cos: tuple[Fraction, Fraction]) -> str:
    """The angle between two values of -cos; rounded outward."""
    least, most = (_angle(min(end, Fraction(1))) for end in neg_cos)
    low, high = shown_ends((least[0], min(most[1], Fraction(180))))
    return f"final θ = {low}°" if low == high else f"final θ between {low}° and {high}°"


def _angle(neg_cos: Fraction) -> tuple[Fraction, Fraction]:
    """An enclosure of the angle in degrees; it rises with its -cos."""
    if neg_cos == 1:
        return Fraction(180), Fraction(180)
    with balls.precision(ANGLE_BITS):
        sine = balls.root(balls.from_fraction(1 - neg_cos**2))
        angle = balls.argument(balls.from_fraction(-neg_cos), sine)
        return balls.ends(180 * angle / balls.pi())


def _event_time(ends: tuple[Fraction, Fraction]) -> str:
    """A number with those of its digits that are certain, a few of them."""
    low, high = ends
    if low == high and len(exact_number(low)) <= MOST_LETTERS:
        return exact_number(low)
    text = short(ends)
    if len(text) <= MOST_LETTERS:
        return text
    low_text, high_text = outward(ends, 12)  # next to a short decimal, no digits agree
    return f"[{low_text}, {high_text}]"


def shown_ends(ends: tuple[Fraction, Fraction]) -> list[str]:
    """Both ends with the digits on which they differ, rounded outward."""
    low, high = ends
    digits, width = 4, high - low
    while width and digits < 60 and abs(high) * 10 > width * 10 ** (digits - 2):
        digits += 1
    return outward(ends, digits)
