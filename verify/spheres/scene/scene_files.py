"""Scene files: TOML with exact numbers, and one line about each thing that cannot be used.

    r = "3/100"
    positions = [["0", "0"], ["1.1", "0"], ["-1.1", "0.01"]]
    velocities = [["0", "0"], ["-1", "0"], ["1", "0"]]

With a line ``diameter = "0.02"`` lengths are those of the file; without it they are diameters.
Lines ``masses = ["1", "2", "1"]`` and ``radii = ["1", "1", "0.5"]`` give each particle its own;
without them all masses are 1, and all diameters the same. Different radii are lengths of the file.
In place of ``r``, a line ``restitution = {"01" = "0.9", "02" = "0.8", "12" = "0.9"}`` gives each
pair its own coefficient; ``restitution = "0.9"`` is the same as ``r = "0.9"``.
``title``, ``time_unit`` and ``length_unit`` are texts that are told with the scene.
A number is a text or a TOML number; either is read as it is written, and no float is ever seen.
"""

from __future__ import annotations

import re
from collections import Counter
from collections.abc import Mapping, Sequence
from fractions import Fraction
from typing import Any

from verify.prover import balls
from verify.prover.decimals import exact_number
from verify.spheres.scene.scene import HALF, PAIRS, Bodies, Labels, Scene, coordinates, pair_name
from verify.wire.inputs import InputError, rational, regular_file, shown
from verify.wire.toml import toml_of

KEYS = ("r", "positions", "velocities")
#: A number with a unit: ``2 cm``, ``-1.4 m/s``.
_QUANTITY = re.compile(
    r"([+-]?[0-9][0-9./]*(?:[eE][+-]?[0-9]+)?) ?(?!pi|deg|rad|[eE][+-]?[0-9]|[xob][0-9])[^\W\d_].*"
)
#: The diameter of the particles in the file's own unit of length; 1 without it.
DIAMETER = "diameter"
#: In place of r, for each pair by its name.
RESTITUTION = "restitution"
#: Numbers of which each particle has one.
MASSES, RADII = "masses", "radii"
#: Keys that a file may do without.
OPTIONAL = (DIAMETER, MASSES, RADII, RESTITUTION)
#: Texts that are told with a scene.
LABELS = Labels._fields
MAX_LABEL = 80
#: What people ask for, and what these spheres do not have.
NO_PHYSICS = frozenset(("force", "forces", "friction", "rotation", "spin", "spins"))
#: What only a file that is decided alone may have; it may have more than three particles, too.
GRAVITY, WALLS, BOX = SURROUNDINGS = ("gravity", "walls", "box")
#: In place of positions and velocities: the name of a file beside that of the scene.
PARTICLES = "particles"
MAX_DIMENSION = 20
MAX_BYTES = 1 << 20


R_AT_THE_TOP = (
    'stands below [parameters]; write it at the top, also as an interval: r = "0.01..0.09"'
)

#: What to write where a line is not TOML, and nobody knows what was meant.
LIKE_THIS = f"write {', '.join(KEYS)}, such as r = 0.03"


#: What to do with a scene of many where scenes of three are asked for.
ALONE = (
    "scenes of a folder, of a family or with --at have three particles and nothing else; decide "
    "this file alone: verify scene FILE"
)


class OverlapError(InputError):
    """Two particles overlap."""


def scene_bytes(where: str) -> bytes:
    """The bytes of a scene's file.

    Raises:
        InputError: if it cannot be read, or is no file.
    """
    try:
        return regular_file(where, MAX_BYTES)
    except (OSError, ValueError) as error:
        reason = getattr(error, "strerror", None) or error
        raise InputError(f"{where}: cannot be read ({reason}); name a scene's file") from error


def read_scene(where: str, content: bytes) -> Scene:
    """The scene in a file.

    Raises:
        InputError: naming the file, the key, and what to write instead.
    """
    return scene_from(where, toml_table(where, content))


def scene_from(where: str, table: dict[str, Any]) -> Scene:
    """The scene that a table describes.

    Raises:
        InputError: naming the file, the key, and what to write instead.
    """
    both = _restitutions(where, table)
    unit = diameter_in(where, table)
    masses, radii = each_of(where, MASSES, table), each_of(where, RADII, table)
    if radii and DIAMETER in table:
        raise InputError(f"{where}: {RADII}: the file has a {DIAMETER} too; write one of them")
    if len({*radii}) == 1:
        unit, radii = 2 * radii[0], ()
    positions, velocities = (rows_in(where, key, table, unit) for key in KEYS[1:])
    labels = labels_in(where, table, None if radii else unit)
    same_dimension(where, {"position": positions, "velocity": velocities})
    mass = masses[0] if masses else Fraction(1)
    several = None if len({*both}) == 1 else both
    bodies = _bodies(masses, radii, are_equal=several is None)
    scene = Scene(max(both), positions, velocities, labels, bodies, mass, several)
    _apart(where, scene, unit)
    return scene


def are_apart(scene: Scene) -> bool:
    """Whether no two particles overlap."""
    given = coordinates(scene, Fraction)
    return all(given.pair(i, j)[0] >= 0 for i, j in PAIRS)


def is_in_range(scene: Scene) -> bool:
    """Whether r and the dimension are such that a file of this scene can be read."""
    are_right = all(0 < scene.restitution(i, j) <= 1 for i, j in PAIRS)
    return are_right and 1 <= scene.dimension <= MAX_DIMENSION


def toml_table(where: str, content: bytes, more: tuple[str, ...] = ()) -> dict[str, Any]:
    """The table in a file of a scene; it may have other keys besides those of a scene.

    Raises:
        InputError: naming the file, the key, and what to write instead.
    """
    if len(content) > MAX_BYTES:
        raise InputError(f"{where}: has {len(content)} bytes; write at most {MAX_BYTES}")
    table, _ = toml_of(where, content, LIKE_THIS)
    is_family = "parameters" in table or ".." in str(table.get("r"))
    if is_family and not more:
        raise InputError(
            f"{where}: is a family of scenes; add --sample N, or --at for one of them: --at "
            "NAME=A, or --grid NAME=A..B:N; verify map draws it"
        )
    keys = {*KEYS[1:]} if RESTITUTION in table else {*KEYS}
    if RESTITUTION in table and "r" in table:
        raise InputError(f"{where}: {RESTITUTION}: the file has an r too; write one of them")
    odd = sorted((table.keys() - {*more, *OPTIONAL, *LABELS}) ^ keys)
    if odd:
        below = table.get("parameters")
        if odd[0] == "r" and isinstance(below, dict) and "r" in below:
            raise InputError(f"{where}: r: {R_AT_THE_TOP}")
        if odd[0] in KEYS:
            raise InputError(f"{where}: {shown(odd[0])} is missing; write {', '.join(KEYS)}")
        if odd[0] in (PARTICLES, *SURROUNDINGS):
            raise InputError(f"{where}: {odd[0]}: {ALONE}")
        if odd[0].lower() in NO_PHYSICS:
            raise InputError(
                f"{where}: {shown(odd[0])} is not part of the model: smooth spheres without spin, "
                "friction or forces but gravity; leave it out"
            )
        others = ", ".join([*OPTIONAL, *LABELS])
        raise InputError(
            f"{where}: {shown(odd[0])} is not known{_meant_key(odd[0], table)}; a parameter stands "
            f"below [parameters], and besides {', '.join(KEYS)} there may be {others}"
        )
    return table


def _meant_key(odd: str, table: dict[str, Any]) -> str:
    """A question that names a key like this one, or else the only one that is missing."""
    from difflib import get_close_matches  # loaded only where it is used

    missing = [key for key in KEYS if key not in table]
    like = get_close_matches(odd, [*KEYS, *OPTIONAL, *LABELS], 1)
    meant = like or (missing if len(missing) == 1 else [])
    return f" (do you mean {meant[0]}?)" if meant else ""


def each_of(where: str, key: str, table: dict[str, Any], number: int = 3) -> tuple[Fraction, ...]:
    """A positive number for each particle; none if the file does not have them.

    Raises:
        InputError: naming the file, the key, and what to write instead.
    """
    if key not in table:
        return ()
    given = table[key]
    if not isinstance(given, list) or len(given) != number:
        raise InputError(
            f'{where}: {key}: write one for each particle, {number} in all, like ["1", "2", "1"]'
        )
    found = tuple(
        number_in(f"{where}: {key} of particle {i}", value) for i, value in enumerate(given)
    )
    for i, value in enumerate(found):
        if value <= 0:
            raise InputError(
                f"{where}: {key} of particle {i}: {shown(str(given[i]))} is not positive; write 1"
            )
    return found


def _restitutions(where: str, table: dict[str, Any]) -> tuple[Fraction, Fraction, Fraction]:
    """The coefficient of restitution of each pair."""
    key = RESTITUTION if RESTITUTION in table else "r"
    own = table[key]
    if key == "r" or not isinstance(own, (dict, list)):
        given = dict.fromkeys(_PAIR_NAMES, (key, own))
    elif isinstance(own, dict) and {*own} == {*_PAIR_NAMES}:
        given = {name: (f"{key} of {name}", own[name]) for name in _PAIR_NAMES}
    else:
        raise InputError(
            f"{where}: {key}: write one for each pair, like "
            '{"01" = "0.9", "02" = "0.8", "12" = "0.9"}, or "0.9" for all'
        )
    found = []
    for place, value in given.values():
        r = number_in(f"{where}: {place}", value)
        if not 0 < r <= 1:
            raise InputError(
                f"{where}: {place}: {shown(str(r))} is not in (0, 1]; write for example 3/100"
            )
        found.append(r)
    return found[0], found[1], found[2]


_PAIR_NAMES = tuple(pair_name(i, j) for i, j in PAIRS)


def _bodies(
    masses: tuple[Fraction, ...], radii: tuple[Fraction, ...], *, are_equal: bool
) -> Bodies | None:
    """Masses and radii with their defaults; None if all spheres and pairs are equal."""
    if are_equal and not radii and len({*masses}) <= 1:
        return None
    return Bodies(masses or (Fraction(1),) * 3, radii or (HALF,) * 3)


def labels_in(where: str, table: dict[str, Any], unit: Fraction | None) -> Labels:
    """The texts, as they are written; the unit of length with the diameter in it, if it is that.

    Raises:
        InputError: naming the file, the key, and what to write instead.
    """
    texts = [table.get(name, "") for name in LABELS]
    for name, text in zip(LABELS, texts, strict=True):
        if not isinstance(text, str) or not text.isprintable() or len(text) > MAX_LABEL:
            raise InputError(
                f"{where}: {name}: {shown(str(text))} is no text of one line; write at most "
                f"{MAX_LABEL} letters in quotes"
            )
    found = Labels(*texts)
    if not found.length_unit or unit is None:
        return found
    return found._replace(length_unit=f"{exact_number(unit)} {found.length_unit}")


def diameter_in(where: str, table: dict[str, Any]) -> Fraction:
    """The diameter of all particles, or 1.

    Raises:
        InputError: naming the file, the key, and what to write instead.
    """
    given = table.get(DIAMETER, 1)
    unit = number_in(f"{where}: {DIAMETER}", given)
    if unit <= 0:
        raise InputError(f"{where}: {DIAMETER}: {shown(str(given))} is not positive; write 0.02")
    return unit


def rows_in(
    where: str, key: str, table: dict[str, Any], unit: Fraction, number: int = 3
) -> tuple[tuple[Fraction, ...], ...]:
    """The lists of coordinates, one for each particle, in this unit.

    Raises:
        InputError: naming the file, the key, and what to write instead.
    """
    rows = table[key]
    if not isinstance(rows, list) or not all(isinstance(x, list) for x in rows):
        rows = []
    if len(rows) > number == 3:
        raise InputError(f"{where}: {key}: {len(rows)} particles: {ALONE}")
    if len(rows) != number:
        raise InputError(
            f"{where}: {key}: write {'three' if number == 3 else number} lists of numbers, one for "
            "each particle, like "
            "[[0, 0], [2, 0], [1, -3]] without quotes around them"
        )
    return tuple(
        tuple(_coordinate(f"{where}: {key} of particle {i}", value) / unit for value in row)
        for i, row in enumerate(rows)
    )


def _coordinate(where: str, value: Any) -> Fraction:
    if isinstance(value, str) and re.search(r"[*()°]", value):
        raise InputError(
            f"{where}: {shown(value)} is not a number; write coordinates, not angles; terms such "
            "as 2*h need a parameter below [parameters]"
        )
    return number_in(where, value)


def number_in(where: str, value: Any) -> Fraction:
    """A number, exactly as it is written.

    Raises:
        InputError: for anything else.
    """
    if isinstance(value, str):
        try:
            return rational(where, value)
        except InputError as error:
            quantity = _QUANTITY.fullmatch(value)
            if quantity is None:
                raise
            raise InputError(
                f"{where}: {shown(value)} has a unit; write {quantity[1]}: all lengths are in "
                "one unit, also the diameter, and so are all velocities and all masses"
            ) from error
    if type(value) is int:
        return rational(where, str(value))
    raise InputError(f'{where}: {shown(str(value))} is not a number; write it like 0.03 or "3/100"')


def same_dimension(where: str, vectors: Mapping[str, Sequence[Sequence[Fraction]]]) -> None:
    """Afterwards all vectors have the same number of coordinates, not too many, and at least one.

    Raises:
        InputError: naming those that have another number than most.
    """
    found = {
        f"the {key} of particle {i}": len(row)
        for key, rows in vectors.items()
        for i, row in enumerate(rows)
    }
    ((usual, times),) = Counter(found.values()).most_common(1)
    others = {name: length for name, length in found.items() if length != usual}
    if others:
        is_clear = times > len(others)
        told = (f"{name} has {n}" for name, n in (others if is_clear else found).items())
        advice = f"{usual} for each, as most have" if is_clear else "the same number for all"
        if all(n > usual for n in others.values()) and is_clear:
            advice += "; a decimal has a point, 0.5 for 0,5"
        raise InputError(f"{where}: numbers of coordinates: {', '.join(told)}; write {advice}")
    if not 1 <= usual <= MAX_DIMENSION:
        raise InputError(
            f"{where}: the vectors have {usual} coordinates; write 1 to {MAX_DIMENSION} for each"
        )


def _apart(where: str, scene: Scene, unit: Fraction) -> None:
    """Afterwards no two particles overlap."""
    length = scene.labels.length_unit or exact_number(unit)
    diameters = ""
    if unit != 1:
        diameters = f", in diameters of {length}"
    elif scene.bodies is None:
        diameters = ", in diameters; if your lengths are in metres, write diameter = 0.02, say"
    given = coordinates(scene, Fraction)
    for i, j in PAIRS:
        gap, _, _ = given.pair(i, j)
        if gap < 0:
            reach = scene.contact(i, j)
            raise OverlapError(
                f"{where}: the particles {i} and {j} overlap by about {_overlap(gap, reach)}: "
                f"their distance has to be at least {exact_number(reach)}{diameters}"
            )


def _overlap(gap: Fraction, least: Fraction) -> str:
    """How much |x| is below that where |x|² less its square is negative, with three digits."""
    from decimal import Context, Decimal  # loaded only where it is used

    with balls.precision(192):
        reach = balls.from_fraction(least**2 + gap).sqrt()
        low, high = balls.ends(-balls.from_fraction(gap) / (balls.from_fraction(least) + reach))
    top, divisor = map(Decimal, ((low + high) / 2).as_integer_ratio())
    return f"{Context(prec=3).divide(top, divisor).normalize()}"
