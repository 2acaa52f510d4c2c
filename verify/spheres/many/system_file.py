"""Scene files with any number of particles, walls, gravity or a box: TOML with exact numbers.

Besides what a scene of three has there may be ``gravity = [0, "-9.81"]``, an acceleration,
``walls = [{normal = [0, 1], level = 0, r = "0.5"}]``, each the half-space normal·x >= level, or
``box = [10, 10]``, the periods of a box that repeats itself in all directions. Where pairs differ,
``restitution = {"others" = "0.9", "0-1" = "0.5"}`` gives them their own coefficients. Lengths are
in the unit of the file; without ``radii`` all particles have the ``diameter``, or else 1. In place
of positions and velocities ``particles = "state.csv"`` names a file that has them.
"""

from __future__ import annotations

import re
from collections.abc import Iterator, Mapping
from fractions import Fraction
from itertools import product
from typing import Any

from verify.prover.decimals import exact_number
from verify.spheres.many.motion import Motion
from verify.spheres.many.nearby import Nearby
from verify.spheres.many.particles_file import with_particles
from verify.spheres.many.system import System, Wall, name_of
from verify.spheres.scene.scene import PAIRS, pair_name
from verify.spheres.scene.scene_files import (
    BOX,
    DIAMETER,
    GRAVITY,
    KEYS,
    LABELS,
    LIKE_THIS,
    MASSES,
    MAX_BYTES,
    OPTIONAL,
    PARTICLES,
    RADII,
    RESTITUTION,
    SURROUNDINGS,
    WALLS,
    OverlapError,
    diameter_in,
    each_of,
    labels_in,
    number_in,
    rows_in,
    same_dimension,
)
from verify.wire.inputs import InputError, nearest, shown
from verify.wire.toml import toml_of

MOST, MOST_WALLS = 2000, 100
#: To so many bits it is looked at which particles are near one another.
BITS = 64
#: In a box floats tell which images may come near: numbers have to be within these.
LEAST_SIZE, MOST_SIZE = Fraction(1, 10**60), Fraction(10**60)
OTHERS = "others"
WALL = ("normal", "level", "r")


def is_many(table: Mapping[str, Any]) -> bool:
    """Whether a file has more particles than three, or what a scene of three has not."""
    rows = table.get(KEYS[1])
    has_more = isinstance(rows, list) and len(rows) > len(KEYS)
    own = (PARTICLES, *SURROUNDINGS)
    return "parameters" not in table and (has_more or any(key in table for key in own))


def table_in(where: str, content: bytes) -> dict[str, Any]:
    """The table in a file.

    Raises:
        InputError: if it is no TOML, or too long.
    """
    if len(content) > MAX_BYTES:
        raise InputError(f"{where}: has {len(content)} bytes; write at most {MAX_BYTES}")
    return toml_of(where, content, LIKE_THIS)[0]


def system_from(where: str, table: dict[str, Any]) -> System:
    """The system that a table describes.

    Raises:
        InputError: naming the file, the key, and what to write instead.
    """
    if PARTICLES in table:
        table = with_particles(where, table)
    _check_keys(where, table)
    given = table[KEYS[1]]
    number = len(given) if isinstance(given, list) else 0
    if not 1 <= number <= MOST:
        raise InputError(f"{where}: {KEYS[1]}: write 1 to {MOST} lists of numbers")
    r, restitutions = _restitutions(where, table, number)
    masses, radii = (each_of(where, key, table, number) for key in (MASSES, RADII))
    if radii and DIAMETER in table:
        raise InputError(f"{where}: {RADII}: the file has a {DIAMETER} too; write one of them")
    unit = diameter_in(where, table)
    x, v = (rows_in(where, key, table, Fraction(1), number) for key in KEYS[1:])
    more = {key: _vector(where, key, table[key]) for key in (GRAVITY, BOX) if key in table}
    walls = _walls(where, table.get(WALLS, []))
    normals = {f"normal of wall {k}": [wall.normal] for k, wall in enumerate(walls)}
    own = {key: [row] for key, row in more.items()}
    same_dimension(where, {"position": x, "velocity": v, **own, **normals})
    masses, radii = masses or (Fraction(1),) * number, radii or (unit / 2,) * number
    gravity, box = more.get(GRAVITY, ()), more.get(BOX, ())
    labels = labels_in(where, table, None)
    system = System(r, masses, radii, x, v, labels, restitutions, gravity, walls, box)
    _check_box(where, system)
    _check_apart(where, system)
    return system


def _check_keys(where: str, table: Mapping[str, Any]) -> None:
    if RESTITUTION in table and "r" in table:
        raise InputError(f"{where}: {RESTITUTION}: the file has an r too; write one of them")
    r = RESTITUTION if RESTITUTION in table else "r"
    needed = (r, *KEYS[1:])
    missing = [key for key in needed if key not in table]
    if missing:
        raise InputError(f"{where}: {shown(missing[0])} is missing; write {', '.join(needed)}")
    known = (*needed, *OPTIONAL, *SURROUNDINGS, *LABELS)
    odd = sorted(table.keys() - {*known})
    if odd:
        raise InputError(f"{where}: {shown(odd[0])} is not known; {nearest(odd[0], known)}")
    if BOX in table and (GRAVITY in table or WALLS in table):
        other = GRAVITY if GRAVITY in table else WALLS
        raise InputError(f"{where}: {BOX}: the file has {other} too; write one of them")


def _coefficient(where: str, value: Any) -> Fraction:
    r = number_in(where, value)
    if not 0 < r <= 1:
        raise InputError(f"{where}: {shown(str(value))} is not in (0, 1]; write for example 3/100")
    return r


def _restitutions(
    where: str, table: Mapping[str, Any], number: int
) -> tuple[Fraction, dict[tuple[int, int], Fraction]]:
    """The coefficient of most pairs, and those of others."""
    key = RESTITUTION if RESTITUTION in table else "r"
    given = table[key]
    if not isinstance(given, dict):
        return _coefficient(f"{where}: {key}", given), {}
    own = {name: value for name, value in given.items() if name != OTHERS}
    if {*own} == {pair_name(i, j) for i, j in PAIRS} and number == len(PAIRS):
        own = {f"{name[0]}-{name[1]}": value for name, value in own.items()}
    pairs = {name: _pair(name, number) for name in own}
    for name, pair in pairs.items():
        if not pair:
            raise InputError(
                f"{where}: {key}: {shown(name)} is no pair; write two numbers of particles, the "
                f'smaller one first, like "0-1", or "{OTHERS}"'
            )
    found = {
        pair: _coefficient(f"{where}: {key} of {name}", own[name])
        for name, pair in pairs.items()
        if pair
    }
    if OTHERS in given:
        return _coefficient(f"{where}: {key} of {OTHERS}", given[OTHERS]), found
    if len(found) < number * (number - 1) // 2 or not found:
        raise InputError(f'{where}: {key}: not all pairs have one; write "{OTHERS}" = "0.9", too')
    return max(found.values()), found


def _pair(name: str, number: int) -> tuple[int, int] | None:
    """The pair that is written so, like 3-12; None if none is."""
    parts = name.split("-")
    if len(parts) != 2 or not all(re.fullmatch("[0-9]{1,9}", part) for part in parts):
        return None
    i, j = map(int, parts)
    return (i, j) if i < j < number and name == name_of(i, j) else None


def _vector(where: str, key: str, given: Any) -> tuple[Fraction, ...]:
    if not isinstance(given, list):
        raise InputError(f'{where}: {key}: write a number for each coordinate, like [0, "-9.81"]')
    return tuple(number_in(f"{where}: {key}", value) for value in given)


def _walls(where: str, given: Any) -> tuple[Wall, ...]:
    like = 'write walls = [{normal = [0, 1], level = 0, r = "0.5"}]'
    if not isinstance(given, list) or len(given) > MOST_WALLS:
        raise InputError(f"{where}: {WALLS}: {like}, at most {MOST_WALLS}")
    found = []
    for k, one in enumerate(given):
        here = f"{where}: wall {k}"
        if not isinstance(one, dict) or {*one} != {*WALL}:
            raise InputError(f"{here}: has not exactly {', '.join(WALL)}; {like}")
        normal = _vector(here, "normal", one["normal"])
        if not any(normal):
            raise InputError(f"{here}: its normal is 0; {like}")
        level, r = number_in(f"{here}: level", one["level"]), _coefficient(f"{here}: r", one["r"])
        found.append(Wall(normal, level, r))
    return tuple(found)


def _check_box(where: str, system: System) -> None:
    """Afterwards no particle touches two images of another one, and floats can tell images."""
    if not system.box:
        return
    least = 4 * max(system.radii)
    for side in system.box:
        if not side > least:
            raise InputError(
                f"{where}: {BOX}: {exact_number(side)} is too short; each side has to be longer "
                f"than two diameters, {exact_number(least)}"
            )
    sizes = (*system.radii, *system.box)
    rest = [abs(a) for row in (*system.positions, *system.velocities) for a in row]
    if not all(LEAST_SIZE < a < MOST_SIZE for a in (*sizes, *(a for a in rest if a))):
        raise InputError(
            f"{where}: {BOX}: a number is beyond 10^60, or nearer to 0 than 10^-60; write others"
        )


def _check_apart(where: str, system: System) -> None:
    """Afterwards no two particles overlap, and none overlaps a wall."""
    nearby = Nearby(Motion(system, BITS))
    for i, j in ((k, j) for k in range(system.number) for j in nearby.others(k, 0.0) if k < j):
        difference = [b - a for a, b in zip(system.positions[i], system.positions[j], strict=True)]
        if any(
            sum(a * a for a in x) < system.contact(i, j) ** 2 for x in _images(system, difference)
        ):
            raise OverlapError(
                f"{where}: the particles {i} and {j} overlap: their distance has to be at least "
                f"{exact_number(system.contact(i, j))}"
            )
    for i, x in enumerate(system.positions):
        for k, wall in enumerate(system.walls):
            above = sum(a * b for a, b in zip(wall.normal, x, strict=True)) - wall.level
            if above < 0 or above**2 < system.radii[i] ** 2 * sum(a * a for a in wall.normal):
                raise OverlapError(
                    f"{where}: the particle {i} overlaps wall {k}: its centre has to be at least "
                    f"{exact_number(system.radii[i])} above it"
                )


def _images(system: System, x: list[Fraction]) -> Iterator[tuple[Fraction, ...]]:
    """A difference, or its images that are nearest to 0 in each direction."""
    near: list[tuple[Fraction, ...]] = [(a,) for a in x]
    if system.box:
        near = [(a % side, a % side - side) for a, side in zip(x, system.box, strict=True)]
    yield from product(*near)
