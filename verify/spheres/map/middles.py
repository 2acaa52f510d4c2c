"""The scene in the middle of each box of a map: more of it is known than the verdict of the box."""

from __future__ import annotations

from collections.abc import Iterator
from fractions import Fraction

from verify.language.record import Record
from verify.spheres.map.log import Progress
from verify.spheres.map.planes import Plane, Scenes, Side, value_of
from verify.spheres.map.strip import BorderStrip
from verify.spheres.scene.decide import UNDECIDED, Budget, decide_scene
from verify.spheres.scene.scene import Scene
from verify.spheres.scene.scene_files import are_apart, is_in_range
from verify.spheres.scene.verdict import central, time_ends

#: Times of collapses have so many, so that no colour depends on how wide an enclosure is.
DIGITS = 6


class Middle(Record):
    """What is known of a scene: central ball and time of a collapse, and certain collisions."""

    verdict: str
    reason: str
    central: int | None
    collisions: int
    time: Side | None


#: r is not in ]0,1[, particles overlap, or a term divides by zero.
NO_SCENE = Middle(UNDECIDED, "no-scene", None, 0, None)


class Box(Record):
    """A box that was not divided: its verdict as in the log, and its sides."""

    letter: str
    x: Side
    y: Side | None


def boxes(progress: Progress) -> Iterator[Box]:
    """All boxes that were not divided, in the order of their keys."""
    for key, letter in sorted(progress.leaves()):
        yield Box(letter, *_sides(progress.plane, key))


def _sides(plane: Plane | BorderStrip, key: str) -> tuple[Side, Side | None]:
    column = int("".join("01"[int(digit) & 1] for digit in key), 2)
    row = int("".join("01"[int(digit) >> 1] for digit in key), 2)
    parts = 2 ** len(key)
    return _part(plane.x, column, parts), None if plane.y is None else _part(plane.y, row, parts)


def _part(side: Side, place: int, parts: int) -> Side:
    low, high = side
    return (
        low + (high - low) * Fraction(place, parts),
        low + (high - low) * Fraction(place + 1, parts),
    )


def scene_in(plane: Scenes, box: Box) -> Scene:
    """The scene in the middle of a box."""
    x = (box.x[0] + box.x[1]) / 2
    y = Fraction(0) if box.y is None else (box.y[0] + box.y[1]) / 2
    given = plane.coordinates
    positions, velocities = (
        tuple(tuple(value_of(term, x, y, Fraction) for term in row) for row in rows)
        for rows in (given.x, given.v)
    )
    return Scene(value_of(plane.r, x, y, Fraction), positions, velocities)


def middle(plane: Scenes, box: Box) -> Middle:
    """What becomes of the scene in the middle of a box, if there is one."""
    try:
        scene = scene_in(plane, box)
    except ZeroDivisionError:  # by a term of the file
        return NO_SCENE
    if not (is_in_range(scene) and are_apart(scene)):
        return NO_SCENE
    fate = decide_scene(scene, Budget(digits=DIGITS))
    return Middle(fate.verdict, fate.name, central(fate), fate.collisions, time_ends(fate))
