"""The particles of a scene in a file of a simulation: CSV, extended XYZ, or a LAMMPS dump.

Numbers are the decimals that are printed there. Each column has a name; those of places,
velocities, masses, radii and diameters are read, those that name or count particles are not needed,
and any other one is refused. A third coordinate that is 0 for all, and stays so, is left out.
"""

from __future__ import annotations

import os
import re
from collections.abc import Mapping, Sequence
from fractions import Fraction
from typing import Any

from verify.language.record import Record
from verify.spheres.scene.scene_files import BOX, KEYS, MASSES, PARTICLES, RADII, number_in
from verify.wire.inputs import InputError, regular_file, shown

MAX_BYTES = 1 << 22
CSV, XYZ, DUMP = (".csv",), (".xyz", ".extxyz"), (".dump", ".lammpstrj")
ENDINGS = CSV + XYZ + DUMP
#: What columns are called.
PLACES = (("x", "y", "z"), ("xu", "yu", "zu"))
VELOCITIES = ("vx", "vy", "vz")
MASS, RADIUS, DIAMETER = "mass", "radius", "diameter"
UNUSED = frozenset(("id", "type", "element", "species", "mol", "ix", "iy", "iz"))
#: What the properties of extended XYZ are called here, where it is something else.
PROPERTIES = {
    **dict.fromkeys(("vel", "velo", "velocity", "velocities"), "velocities"),
    **dict.fromkeys(("mass", "masses"), MASS),
    **dict.fromkeys(("radius", "radii"), RADIUS),
}
#: A key of extended XYZ with its value, and the keys that are used.
KEY = r"""(?<!\S)([^\s="]+)=(?:"([^"]*)"(?!\S)|([^"\s]\S*))"""
USED = ("Lattice", "Properties", "pbc")
LOWER = frozenset(key.lower() for key in USED)


class Rows(Record):
    """The columns of a file, each row with its line, their names, the line before, any periods."""

    names: Sequence[str]
    rows: Sequence[tuple[int, Sequence[str]]]
    line: int
    box: Sequence[Fraction] = ()


def with_particles(where: str, table: Mapping[str, Any]) -> dict[str, Any]:
    """The table of a scene with what the file of its particles has.

    Raises:
        InputError: naming the file, the line, and what to write instead.
    """
    name = table[PARTICLES]
    if not isinstance(name, str) or os.path.splitext(name)[1] not in (*CSV, *XYZ, *DUMP):
        raise InputError(
            f"{where}: {PARTICLES}: write the name of a file that ends in "
            f"{', '.join((*CSV, *XYZ, *DUMP))}"
        )
    path = os.path.join(os.path.dirname(where), name)
    try:
        text = regular_file(path, MAX_BYTES).decode("utf-8-sig")
    except (OSError, ValueError) as error:
        reason = getattr(error, "strerror", None) or error
        raise InputError(f"{where}: {PARTICLES}: {name} cannot be read ({reason})") from error
    read = {CSV: _csv, XYZ: _xyz, DUMP: _dump}
    (reader,) = (read[ends] for ends in read if os.path.splitext(name)[1] in ends)
    rows = reader(path, re.split("\r\n|\r|\n", text))
    found = _entries(path, rows)
    _are_there(path, rows)
    rest = {key: value for key, value in table.items() if key != PARTICLES}
    both = sorted(rest.keys() & found.keys())
    if both:
        raise InputError(f"{where}: {both[0]}: {name} has them too; leave them out here")
    return rest | found


def _are_there(path: str, found: Rows) -> None:
    """Afterwards there is a particle, in a box that has an inside."""
    if not found.rows:
        raise InputError(f"{path}: line {found.line + 1}: has no particle; write a line of each")
    if any(side <= 0 for side in found.box):
        raise InputError(f"{path}: a side of its box is not positive; write its ends in order")


def _entries(path: str, found: Rows) -> dict[str, Any]:
    """The columns as the entries of a scene."""
    names = list(found.names)
    places = next((row for row in PLACES if row[0] in names), PLACES[0])
    used = {*places, *VELOCITIES, MASS, RADIUS, DIAMETER}
    odd = [name for name in names if name not in used | UNUSED]
    if {RADIUS, DIAMETER} <= {*names}:
        raise InputError(
            f"{path}: line {found.line}: has a column {RADIUS} and a column {DIAMETER}; leave one "
            "of them out"
        )
    if odd or len({*names}) < len(names):
        odd = odd or [name for name in names if names.count(name) > 1]
        raise InputError(
            f"{path}: line {found.line}: the column {shown(odd[0])} is not known, or there "
            f"twice; columns are {', '.join((*PLACES[0], *VELOCITIES, MASS, RADIUS, DIAMETER))}"
        )
    dimension = sum(name in names for name in places)
    pairs = list(zip(places, VELOCITIES, strict=True))
    if not dimension or any((x in names) != (v in names) or (x in names) != (k < dimension)
                            for k, (x, v) in enumerate(pairs)):  # fmt: skip
        raise InputError(
            f"{path}: line {found.line}: has not a velocity for each coordinate; write x with "
            "vx, y with vy, z with vz"
        )

    def column(name: str) -> list[Fraction]:
        k = names.index(name)
        return [number_in(f"{path}: line {n}: {name}", row[k]) for n, row in found.rows]

    x, v = ([column(name) for name in row[:dimension]] for row in (places, VELOCITIES))
    box = list(found.box[:dimension])
    if dimension == len(VELOCITIES) and not any((*x[2], *v[2])):
        x, v, box = x[:2], v[:2], box[:2]
    entries: dict[str, Any] = {key: [list(map(str, row)) for row in zip(*rows, strict=True)]
               for key, rows in zip(KEYS[1:], (x, v), strict=True)}  # fmt: skip
    radii = {RADIUS: 1, DIAMETER: 2}
    for name, share in radii.items():
        if name in names:
            entries[RADII] = [str(value / share) for value in column(name)]
    if MASS in names:
        entries[MASSES] = list(map(str, column(MASS)))
    return entries | ({BOX: list(map(str, box))} if box else {})


def _split(path: str, lines: Sequence[str], line: int, names: Sequence[str], sign: str | None = None
           ) -> Rows:  # fmt: skip
    """The lines from this one on, each with as many words as names; a CSV may have blank ones."""
    rows = []
    for n, text in enumerate(lines, line):
        if sign and not text.strip():
            continue
        words = [word.strip() for word in text.split(sign)]
        if len(words) != len(names):
            raise InputError(
                f"{path}: line {n}: has {len(words)} columns, and the names are {len(names)}"
            )
        rows.append((n, words))
    return Rows(names, rows, line - 1)


def _csv(path: str, lines: Sequence[str]) -> Rows:
    names = [name.strip() for name in lines[0].split(",")] if lines[0].strip() else []
    return _split(path, lines[1:], 2, names, ",")


def _count(path: str, lines: Sequence[str], line: int, first: int) -> list[str]:
    """The lines of so many particles as a line says; there are no others."""
    text = lines[line - 1].strip() if len(lines) >= line else ""
    rest = list(lines[first - 1 :])
    while rest and not rest[-1].strip():
        rest.pop()
    if not rest or not re.fullmatch(r"[0-9]{1,9}", text) or int(text) != len(rest):
        raise InputError(
            f"{path}: line {line}: {shown(text)} is not the number of the {len(rest)} lines of "
            "particles; the file has to have one moment and no more"
        )
    return rest


def _keys(path: str, text: str) -> dict[str, str]:
    """The keys of extended XYZ with their values; none of those that are used stands there twice.

    Raises:
        InputError: also where a key that is used is written in another way.
    """
    pairs = re.findall(KEY, text)
    used = [key for key, _, _ in pairs if key.lower() in LOWER]
    rest = re.sub(KEY, "", text)
    if re.search("""[]="'{}[]""", rest) or {*used} - {*USED} or len({*used}) < len(used):
        raise InputError(
            f"{path}: line 2: write each of {', '.join(USED)} at most once, and like this: "
            'name=value, or name="several values", without spaces around ='
        )
    return {key: quoted or plain for key, quoted, plain in pairs}


def _xyz(path: str, lines: Sequence[str]) -> Rows:
    """Extended XYZ: a number, keys with values, and the particles."""
    rest = _count(path, lines, 1, 3)
    given = _keys(path, lines[1])
    parts = given.get("Properties", "").split(":")
    if len(parts) % 3 or len(parts) < 3:
        raise InputError(f"{path}: line 2: write Properties=species:S:1:pos:R:3:velo:R:3")
    names: list[str] = []
    for name, _, number in zip(*(parts[k::3] for k in range(3)), strict=True):
        width = int(number) if re.fullmatch("[1-9]", number) else 0
        meant = {"pos": PLACES[0], "velocities": VELOCITIES}.get(PROPERTIES.get(name, name))
        if not width or width > (len(meant) if meant else 1):
            raise InputError(f"{path}: line 2: Properties: {shown(name)} has {number} columns")
        names += meant[:width] if meant else [PROPERTIES.get(name, name)]
    found = _split(path, rest, 3, names)
    periodic = given.get("pbc", "T T T" if "Lattice" in given else "F F F").split()
    if {*periodic} == {"F"}:
        return found
    cells = [number_in(f"{path}: line 2: Lattice", a) for a in given.get("Lattice", "").split()]
    if {*periodic} != {"T"} or len(cells) != 9 or any(cells[k] for k in range(9) if k % 4):
        raise InputError(
            f'{path}: line 2: write pbc="T T T" and a Lattice with right angles, or pbc="F F F"'
        )
    return found._replace(box=cells[::4])


def _dump(path: str, lines: Sequence[str]) -> Rows:
    """A dump of LAMMPS with one moment."""
    heads = {
        1: "ITEM: TIMESTEP",
        3: "ITEM: NUMBER OF ATOMS",
        5: "ITEM: BOX BOUNDS",
        9: "ITEM: ATOMS",
    }
    for line, head in heads.items():
        if len(lines) < line or not lines[line - 1].startswith(head):
            raise InputError(f"{path}: line {line}: has to begin with {head}")
    rest = _count(path, lines, 4, 10)
    found = _split(path, rest, 10, lines[8].split()[2:])
    kinds = lines[4].split()[3:]
    bounds = [
        [number_in(f"{path}: line {n}: bounds", a) for a in lines[n - 1].split()] for n in (6, 7, 8)
    ]
    if len(kinds) != 3 or any(len(row) != 2 for row in bounds):
        raise InputError(f"{path}: line 5: write BOX BOUNDS pp pp pp, and a box with right angles")
    if "pp" not in kinds:
        return found
    if {*kinds} != {"pp"}:
        raise InputError(f"{path}: line 5: a box repeats itself in all directions here, or in none")
    return found._replace(box=[high - low for low, high in bounds])
