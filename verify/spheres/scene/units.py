"""Units in a scene's file: numbers have none; one unit of length and one of speed are meant."""

from __future__ import annotations

import re
from collections.abc import Collection, Iterator, Mapping
from typing import Any

from verify.wire.inputs import InputError, shown

#: A number with letters, or a sign of a unit, behind it: ``2 cm``, ``0.5 m/s``, ``1e-3 m s^-1``.
_QUANTITY = re.compile(
    r"([+-]?[0-9]*[.,]?[0-9]+(?:/[0-9]+)?(?:[eE][+-]?[0-9]+(?![0-9]))?)[ \t*·]{0,3}"
    r"((?!pi\b|deg|rad|[eE][+-]?[0-9]|[xob][0-9])[^\W\d_][^\W\d_]*|[µμΩÅ'\"′″])"
    r"((?:[ */·]|per\b)*[^\W\d_]*)?((?:\^|\*\*)?-?[0-9⁻¹²³]{0,3})"
)
_PER = re.compile(r"^(?:[ ·*]*/ *|[ ·*]*per +)([^\W\d_]+)$")
_LENGTHS = ("positions", "diameter", "radii")


def refuse_units(where: str, table: Mapping[str, Any], names: Collection[str] = ()) -> None:
    """Afterwards no number of a scene's file has a unit; ``names`` are those of parameters.

    Raises:
        InputError: naming the number, and what to write instead of it.
    """
    for key, place, text in _texts(table):
        found = _QUANTITY.fullmatch(text.strip())
        if found is not None and found[2] not in names:
            raise InputError(
                f"{where}: {place}: {shown(text)} has a unit; {_instead(key, found, table)}"
            )


def _texts(table: Mapping[str, Any]) -> Iterator[tuple[str, str, str]]:
    """The texts that stand for numbers: the key, the key with the particle, and the text."""
    for key in ("r", "restitution", "diameter"):
        if isinstance(table.get(key), str):
            yield key, key, table[key]
    for key in ("positions", "velocities", "masses", "radii"):
        rows = table.get(key)
        for i, row in enumerate(rows if isinstance(rows, list) else []):
            cells = row if isinstance(row, list) else [row]
            yield from ((key, f"{key} of particle {i}", c) for c in cells if isinstance(c, str))


def _instead(key: str, found: re.Match[str], table: Mapping[str, Any]) -> str:
    number, unit = found[1].replace(",", "."), found[2]
    per = _PER.match(found[3] or "")
    if key in ("r", "restitution", "masses"):
        why = "only the ratios of masses matter" if key == "masses" else "it is a ratio of speeds"
        return f"write {number}: {why}"
    own = table.get("length_unit")
    if key == "velocities":
        named = f' (length_unit = "{unit}" and time_unit = "{per[1]}" name it)' if per else ""
        return f"write {number}, with all velocities in one unit{named}"
    if unit.startswith("diameter") and "diameter" not in table:
        return f"write {number}: lengths are in diameters"
    if own is not None and own != unit:
        return f"write the number of {own} in it, which is the length_unit of the file"
    is_set = key != "positions" or "diameter" in table or "radii" in table
    also = "" if is_set else f"; without diameter = (that in {unit}) the unit is the diameter"
    return f'write {number}, with all lengths in one unit (length_unit = "{unit}" names it){also}'
