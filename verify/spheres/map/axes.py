"""From a scene file to a plane: which of its numbers vary, and in which intervals.

An axis is a parameter of the file, or r, or a number of the scene by its place. Two places in a
scene without parameters make a plane through that scene; all else is a family.
"""

from __future__ import annotations

import re
from collections.abc import Callable, Mapping, Sequence
from fractions import Fraction

from verify.check_map import MAX_OPERATIONS
from verify.language.fold import fold
from verify.language.record import Record
from verify.language.terms import Term, symbol
from verify.spheres.map import planes
from verify.spheres.map.planes import FamilyPlane, Place, Scenes, Side, Through
from verify.spheres.scene.families import Family, FamilyTerms, read_family
from verify.spheres.scene.scene import Coordinates
from verify.spheres.scene.scene_files import OPTIONAL, read_scene
from verify.wire.inputs import InputError, rational, shown
from verify.wire.meant import between

#: The letters of the operations of terms.
LETTERS = {"add": "+", "sub": "-", "mul": "*", "div": "/"}
EXAMPLE = "velocities[2][0]=-1.5..0"


class Axis(Record):
    """The option that it was written for, its name, and its interval if one was written."""

    option: str
    name: str
    side: Side | None

    @property
    def place(self) -> Place | None:
        """The number of the scene that it is, if it is one."""
        match = re.fullmatch(r"(positions|velocities)\[([0-2])\]\[([0-9]{1,2})\]", self.name)
        return None if match is None else (match[1], int(match[2]), int(match[3]))


def axis_in(option: str, text: str) -> Axis:
    """An axis as it is written: NAME=A..B, or NAME alone for a parameter of the file.

    Raises:
        InputError: saying what to write instead.
    """
    name, equals, ends = text.partition("=")
    if not re.fullmatch(r"[A-Za-z][A-Za-z0-9_]{0,30}(\[[0-9]{1,2}\]){0,2}", name):
        raise InputError(f"{option}: {shown(text)} is not usable; write it like {EXAMPLE}")
    return Axis(option, name, interval_in(option, ends) if equals else None)


def interval_in(option: str, text: str) -> Side:
    """An interval.

    Raises:
        InputError: saying what to write instead.
    """
    words = text.split("..")
    if len(words) != 2:
        meant = between(text) or "A..B"
        raise InputError(f"{option}: {shown(text)} is no interval; write {meant}")
    low, high = (rational(option, word) for word in words)
    if not low < high:
        raise InputError(f"{option}: {shown(text)} is not A < B; write such an interval")
    return low, high


def plane_in(
    where: str, content: bytes, axes: Sequence[Axis], fixed: Mapping[str, Fraction]
) -> Scenes:
    """The plane, or the interval, of scenes.

    Raises:
        InputError: if an axis is none of the file, or a parameter is neither fixed nor an axis.
    """
    if len({axis.name for axis in axes}) < len(axes):
        raise InputError("--y: is the number that --x varies; name another one")
    family = read_family(where, content)
    if not family.sides and len(axes) == 2 and all(axis.place for axis in axes):
        found = None if family.table.keys() & {*OPTIONAL} else _through(where, content, axes)
        if found is not None:
            return found
    sides = [_side(family, axis) for axis in axes]
    letters = dict(zip((axis.name for axis in axes), map(symbol, "xy"), strict=False))
    here = family.terms(_values(family, letters, fixed))
    for axis in axes:
        if axis.name == "r":
            here = here._replace(r=letters["r"])
        if axis.place is not None:
            _put(here, axis, letters[axis.name])
    _test_length(where, here)
    rows = ([[as_plane_term(cell) for cell in row] for row in given] for given in here[1:3])
    names = tuple(axis.name for axis in axes)
    return FamilyPlane(as_plane_term(here.r), Coordinates(*rows), names, *sides)


#: How many operations a term has as `as_plane_term` writes it, without sharing.
_WRITTEN: Mapping[str, Callable[..., int]] = {
    **dict.fromkeys(LETTERS, lambda one, two: one + two + 1),
    "rational": lambda _: 0,
    "symbol": lambda _: 0,
    "neg": lambda one: one + 1,
    "pow": lambda one, exponent: exponent * (one + 1) - 1,
}


def _test_length(where: str, here: FamilyTerms) -> None:
    """Afterwards the terms are not longer than the checker reads them."""
    cells = (cell for rows in (here.positions, here.velocities) for row in rows for cell in row)
    terms = [cell for cell in (here.r, *cells) if isinstance(cell, Term)]
    if sum(fold(term, _WRITTEN, {}) for term in terms) > MAX_OPERATIONS:
        raise InputError(
            f"{where}: r, positions and velocities have more than {MAX_OPERATIONS} operations, "
            "with powers as products; write shorter terms"
        )


def _through(where: str, content: bytes, axes: Sequence[Axis]) -> Through | None:
    """The plane of a scene of equal particles whose lengths are diameters."""
    scene = read_scene(where, content)
    (x_at, x), (y_at, y) = ((axis.place, axis.side) for axis in axes)
    for axis, place in zip(axes, (x_at, y_at), strict=True):
        if place is not None and place[2] >= scene.dimension:
            raise InputError(f"{axis.option}: {axis.name} is not in the scene; write {EXAMPLE}")
    if x_at is None or y_at is None or x is None or y is None or scene.dimension < 2:
        return None
    return Through(scene, x_at, y_at, x, y)


def _side(family: Family, axis: Axis) -> Side:
    known = axis.name in family.sides or axis.name == "r" or axis.place is not None
    if not known:
        names = ", ".join(("r", *(name for name in family.sides if name != "r")))
        raise InputError(
            f"{axis.option}: {shown(axis.name)} is no parameter of the file; write one of {names}, "
            f"or a place: {EXAMPLE}"
        )
    side = axis.side or family.sides.get(axis.name)
    for end in axis.side or () if axis.name in family.sides else ():
        family.test_inside(axis.option, axis.name, end)
    if side is None:
        raise InputError(f"{axis.option}: {axis.name} has no interval; write {axis.name}=A..B")
    return side


def _values(
    family: Family, letters: Mapping[str, Term], fixed: Mapping[str, Fraction]
) -> dict[str, Fraction | Term]:
    odd = sorted(fixed.keys() - (family.sides.keys() - letters.keys()))
    if odd:
        raise InputError(f"--at: {odd[0]} is no parameter that is left; leave it out")
    missing = sorted(family.sides.keys() - letters.keys() - fixed.keys())
    if missing:
        raise InputError(f"--at: {missing[0]} is neither an axis nor fixed; add {missing[0]}=A")
    for name, value in fixed.items():
        family.test_inside("--at", name, value)
    return {name: letters.get(name, fixed.get(name, Fraction(0))) for name in family.sides}


def _put(here: FamilyTerms, axis: Axis, letter: Term) -> None:
    """Afterwards that number of the scene is the parameter, in the file's own unit of length."""
    kind, particle, coordinate = axis.place or ("", 0, 0)
    rows = here.positions if kind == "positions" else here.velocities
    if coordinate >= len(rows[particle]):
        raise InputError(f"{axis.option}: {axis.name} is not in the scene; write {EXAMPLE}")
    rows[particle][coordinate] = letter if here.unit == 1 else letter / here.unit


def as_plane_term(term: Fraction | Term) -> planes.Term:
    """A term as planes and logs have it: operations on two terms, and powers as products."""
    if isinstance(term, Fraction):
        return term
    if term.op == "rational":
        return term.value
    if term.op == "symbol":
        return term.name
    if term.op == "neg":
        return "-", Fraction(0), as_plane_term(term.args[0])
    if term.op == "pow":
        return _power(as_plane_term(term.args[0]), term.exponent)
    one, two = map(as_plane_term, term.args)
    return LETTERS[term.op], one, two


def _power(base: planes.Term, exponent: int) -> planes.Term:
    if exponent == 1:
        return base
    half = _power(base, exponent // 2)
    whole = ("*", half, half)
    return ("*", whole, base) if exponent % 2 else whole
