"""Scene files: TOML with exact numbers, and one line about each thing that cannot be used.

    r = "3/100"
    positions = [["0", "0"], ["1.1", "0"], ["-1.1", "0.01"]]
    velocities = [["0", "0"], ["-1", "0"], ["1", "0"]]

With a line ``diameter = "0.02"`` lengths are those of the file; without it they are diameters.
``title``, ``time_unit`` and ``length_unit`` are texts that are told with the scene.
A number is a text or a TOML number; either is read as it is written, and no float is ever seen.
"""

from __future__ import annotations

import tomllib
from fractions import Fraction
from typing import Any

from verify.prover import balls
from verify.spheres.scene.scene import PAIRS, Coordinates, Labels, Scene
from verify.wire.inputs import InputError, rational, regular_file, shown

KEYS = ("r", "positions", "velocities")
#: The diameter of the particles in the file's own unit of length; 1 without it.
DIAMETER = "diameter"
#: Texts that are told with a scene.
LABELS = Labels._fields
MAX_LABEL = 80
MAX_DIMENSION = 20
MAX_BYTES = 1 << 20


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
    r = number_in(f"{where}: r", table["r"])
    if not 0 < r < 1:
        raise InputError(f"{where}: r: {shown(str(r))} is not in ]0,1[; write for example 3/100")
    unit = _diameter(where, table)
    positions, velocities = (_rows(where, key, table, unit) for key in KEYS[1:])
    scene = Scene(r, positions, velocities, _labels(where, table))
    lengths = {len(row) for row in (*scene.positions, *scene.velocities)}
    if len(lengths) > 1 or not 1 <= scene.dimension <= MAX_DIMENSION:
        raise InputError(
            f"{where}: the vectors have {', '.join(map(str, sorted(lengths)))} coordinates; write "
            f"the same number for all, from 1 to {MAX_DIMENSION}"
        )
    _apart(where, scene)
    return scene


def is_in_range(scene: Scene) -> bool:
    """Whether r and the dimension are such that a file of this scene can be read."""
    return 0 < scene.r < 1 and 1 <= scene.dimension <= MAX_DIMENSION


def toml_table(where: str, content: bytes, more: tuple[str, ...] = ()) -> dict[str, Any]:
    """The table in a file of a scene; it may have other keys besides those of a scene.

    Raises:
        InputError: naming the file, the key, and what to write instead.
    """
    if len(content) > MAX_BYTES:
        raise InputError(f"{where}: has {len(content)} bytes; write at most {MAX_BYTES}")
    try:
        table = tomllib.loads(content.decode(), parse_float=str)
    except (ValueError, RecursionError) as error:
        is_text = not isinstance(error, UnicodeDecodeError)
        why = " ".join(str(error).split()) if is_text else "it is not UTF-8"
        raise InputError(f"{where}: is no TOML file ({why}); write {', '.join(KEYS)}") from error
    if "parameters" in table and not more:
        raise InputError(
            f"{where}: is a family of scenes; add --sample N, or --at for one of them: --at NAME=A"
        )
    odd = sorted((table.keys() - {*more, DIAMETER, *LABELS}) ^ {*KEYS})
    if odd:
        kind = "is missing" if odd[0] in KEYS else "is not known"
        raise InputError(f"{where}: {shown(odd[0])} {kind}; write just {', '.join(KEYS)}")
    return table


def _labels(where: str, table: dict[str, Any]) -> Labels:
    """The texts, as they are written; the unit of length with the diameter in it."""
    texts = [table.get(name, "") for name in LABELS]
    for name, text in zip(LABELS, texts, strict=True):
        if not isinstance(text, str) or not text.isprintable() or len(text) > MAX_LABEL:
            raise InputError(
                f"{where}: {name}: {shown(str(text))} is no text of one line; write at most "
                f"{MAX_LABEL} letters in quotes"
            )
    found = Labels(*texts)
    if not found.length_unit:
        return found
    return found._replace(length_unit=f"{table.get(DIAMETER, 1)} {found.length_unit}")


def _diameter(where: str, table: dict[str, Any]) -> Fraction:
    given = table.get(DIAMETER, 1)
    unit = number_in(f"{where}: {DIAMETER}", given)
    if unit <= 0:
        raise InputError(f"{where}: {DIAMETER}: {shown(str(given))} is not positive; write 0.02")
    return unit


def _rows(
    where: str, key: str, table: dict[str, Any], unit: Fraction
) -> tuple[tuple[Fraction, ...], ...]:
    rows = table[key]
    if not isinstance(rows, list) or len(rows) != 3 or not all(isinstance(x, list) for x in rows):
        raise InputError(f"{where}: {key}: write three lists of numbers, one for each particle")
    return tuple(
        tuple(number_in(f"{where}: {key} of particle {i}", value) / unit for value in row)
        for i, row in enumerate(rows)
    )


def number_in(where: str, value: Any) -> Fraction:
    """A number, exactly as it is written.

    Raises:
        InputError: for anything else.
    """
    if isinstance(value, str):
        return rational(where, value)
    if type(value) is int:
        return rational(where, str(value))
    raise InputError(f'{where}: {shown(str(value))} is not a number; write it like 0.03 or "3/100"')


def _apart(where: str, scene: Scene) -> None:
    """Afterwards no two particles overlap."""
    given = Coordinates(scene.positions, scene.velocities)
    for i, j in PAIRS:
        gap, _, _ = given.pair(i, j)
        if gap < 0:
            raise OverlapError(
                f"{where}: the particles {i} and {j} overlap by about {_overlap(gap)}: their "
                "distance has to be at least 1"
            )


def _overlap(gap: Fraction) -> str:
    """1 - |x| where |x|² - 1 = gap < 0, with three digits, however small it is."""
    from decimal import Context, Decimal  # loaded only where it is used

    with balls.precision(192):
        reach = balls.from_fraction(1 + gap).sqrt()
        low, high = balls.ends(-balls.from_fraction(gap) / (1 + reach))
    top, divisor = map(Decimal, ((low + high) / 2).as_integer_ratio())
    return f"{Context(prec=3).divide(top, divisor).normalize()}"
