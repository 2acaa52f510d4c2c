"""Families of scenes: a scene file with named parameters, each in an interval.

    r = "0.01..0.08"
    positions = [["0", "0"], ["1.1", "0"], ["-1.1", "h"]]
    velocities = [["0", "0"], ["-1", "0"], ["1", "v/2 - h"]]

    [parameters]
    h = "0..0.1"
    v = "-1..1"

A number may be a term: + - * / and whole powers of numbers and parameters, with parentheses. All
is exact. An interval for r makes it a parameter. A scene without parameters is a family of one.
"""

from __future__ import annotations

import ast
import operator
import re
from collections.abc import Callable, Mapping
from fractions import Fraction
from keyword import iskeyword
from typing import Any

from verify.language.record import Record
from verify.language.terms import Term
from verify.prover.decimals import exact_number
from verify.spheres.scene.scene import Scene
from verify.spheres.scene.scene_files import (
    DIAMETER,
    KEYS,
    LABELS,
    MASSES,
    OPTIONAL,
    R_AT_THE_TOP,
    RADII,
    RESTITUTION,
    number_in,
    scene_from,
    toml_table,
)
from verify.wire.inputs import InputError, rational, shown

PARAMETERS = "parameters"
BODIES = {MASSES, RADII}
#: What to write for the direction of a velocity, which has no cosine here.
ANGLES = (
    "; an angle a is given by a parameter t, the tangent of a/2: its cosine is "
    "(1 - t**2)/(1 + t**2), its sine 2*t/(1 + t**2)"
)
NO_NAME = "is no name; write the letters A to Z, a to z, digits and _, beginning with a letter"
MAX_PARAMETERS, MAX_LETTERS, MAX_POWER, MAX_BITS = 20, 500, 20, 10_000
#: What no term has: the reader of terms would take a comment away, and other letters for these.
_NO_TERM = re.compile(r"[^A-Za-z0-9_.+*/(), ^%-]")
Side = tuple[Fraction, Fraction]
_OPERATIONS: dict[type, Callable[[Any, Any], Any]] = {
    ast.Add: operator.add,
    ast.Sub: operator.sub,
    ast.Mult: operator.mul,
    ast.Div: operator.truediv,
}


class FamilyTerms(Record):
    """r, positions and velocities in diameters, and the diameter: numbers and terms."""

    r: Fraction | Term
    positions: list[list[Fraction | Term]]
    velocities: list[list[Fraction | Term]]
    unit: Fraction | Term


class Family(Record):
    """Parameters with their intervals, and what the numbers of a scene are in terms of them.

    ``fixed`` has the values of other parameters.
    """

    where: str
    sides: Mapping[str, Side]
    table: Mapping[str, Any]
    fixed: Mapping[str, Fraction] = {}

    def test_inside(self, option: str, name: str, value: Fraction) -> None:
        """Afterwards the value is in the interval that the file has for the parameter.

        Raises:
            InputError: if it is not, naming the option.
        """
        low, high = self.sides[name]
        if not low <= value <= high:
            ends = f"{exact_number(low)}..{exact_number(high)}"
            raise InputError(
                f"{option}: {name}={exact_number(value)} is not in {ends}, its interval in "
                f"{self.where}; write a number in it"
            )

    def terms(self, values: Mapping[str, Fraction | Term]) -> FamilyTerms:
        """The scenes in which some parameters are numbers and others stay as they are.

        Raises:
            InputError: if a term cannot be used.
        """
        odd = sorted({*BODIES, RESTITUTION} & self.table.keys())
        if odd:
            raise InputError(
                f"{self.where}: {odd[0]}: maps are about equal particles; leave it out, or sample "
                "the family: verify scene FILE --sample 1000"
            )
        found = _replaced(self.where, self.table, values)
        unit = found.get(DIAMETER, Fraction(1))
        if isinstance(unit, Fraction) and unit <= 0:
            raise InputError(f"{self.where}: {DIAMETER}: is not positive; write 0.02")
        rows = []
        for key in ("positions", "velocities"):
            given = found[key]
            if not isinstance(given, list) or len(given) != 3 or {*map(type, given)} != {list}:
                raise InputError(f"{self.where}: {key}: write three lists of numbers")
            rows.append([[cell if unit == 1 else cell / unit for cell in row] for row in given])
        return FamilyTerms(found["r"], rows[0], rows[1], unit)

    def at(self, values: Mapping[str, Fraction]) -> Scene:
        """The scene at a point.

        Raises:
            InputError: if it is none: particles overlap, say, or a term divides by 0.
        """
        if not self.sides and not self.fixed:
            return scene_from(self.where, dict(self.table))
        found = _replaced(self.where, self.table, {**self.fixed, **values})
        labels = {name: self.table[name] for name in LABELS if name in self.table}
        return scene_from(self.where, {key: _texts(value) for key, value in found.items()} | labels)


def read_family(where: str, content: bytes) -> Family:
    """The family in a file.

    Raises:
        InputError: naming the file, the key, and what to write instead.
    """
    table = toml_table(where, content, more=(PARAMETERS,))
    given = table.pop(PARAMETERS, {})
    if not isinstance(given, dict):
        raise InputError(f'{where}: {PARAMETERS}: write a table such as v = "0..1"')
    if "r" in given:
        raise InputError(f"{where}: r: {R_AT_THE_TOP}")
    for name in given:
        _test_name(where, name)
    sides = {name: _side(where, name, text) for name, text in given.items()}
    if isinstance(table.get("r"), str) and ".." in table["r"]:
        sides["r"] = _side(where, "r", table["r"])
        table["r"] = "r"
    if len(sides) > MAX_PARAMETERS:
        raise InputError(f"{where}: has {len(sides)} parameters; write at most {MAX_PARAMETERS}")
    family = Family(where, dict(sorted(sides.items())), table)
    _used(family)
    return family


def _test_name(where: str, name: str) -> None:
    """Afterwards a parameter may be called so."""
    is_taken = iskeyword(name) or name in (*KEYS, *OPTIONAL, *LABELS)
    if is_taken or not re.fullmatch("[A-Za-z][A-Za-z0-9_]{0,30}", name):
        what = "is a word of terms or scenes; write another name" if is_taken else NO_NAME
        raise InputError(f"{where}: {shown(name)} {what}")


def _side(where: str, name: str, text: object) -> Side:
    place = f"{where}: {name}"
    words = text.split("..") if isinstance(text, str) else []
    if len(words) != 2:
        raise InputError(f'{place}: {shown(str(text))} is no interval; write it like "0..0.1"')
    low, high = (rational(place, word) for word in words)
    if not low < high:
        raise InputError(f"{place}: {shown(str(text))} is not A < B; write such an interval")
    return low, high


def _used(family: Family) -> None:
    """Afterwards each parameter occurs in some term."""
    texts = " ".join(str(family.table.get(key)) for key in (*KEYS, *OPTIONAL))
    names = {*re.findall(r"[A-Za-z]\w*", texts)}
    unused = sorted(family.sides.keys() - names)
    if unused:
        raise InputError(
            f"{family.where}: the parameter {unused[0]} does not occur in r, positions or "
            "velocities; use it, or leave it out"
        )


def _replaced(
    where: str, table: Mapping[str, Any], values: Mapping[str, Fraction | Term]
) -> dict[str, Any]:
    """The table with values for its terms."""

    def rows(key: str) -> Any:
        given = table[key]
        if not isinstance(given, list) or not all(isinstance(row, list) for row in given):
            return given
        return [
            [_value(f"{where}: {key} of particle {i}", cell, values) for cell in row]
            for i, row in enumerate(given)
        ]

    found = {key: rows(key) for key in ("positions", "velocities")}
    if DIAMETER in table:
        found[DIAMETER] = _value(f"{where}: {DIAMETER}", table[DIAMETER], values)
    for key in BODIES & table.keys():
        given = table[key]
        if isinstance(given, list):
            given = [
                _value(f"{where}: {key} of particle {i}", cell, values)
                for i, cell in enumerate(given)
            ]
        found[key] = given
    own = table.get(RESTITUTION)
    if isinstance(own, dict):
        found[RESTITUTION] = {
            name: _value(f"{where}: {RESTITUTION} of {name}", cell, values)
            for name, cell in own.items()
        }
    else:
        key = RESTITUTION if RESTITUTION in table else "r"
        found[key] = _value(f"{where}: {key}", table[key], values)
    return found


def _texts(value: Any) -> Any:
    """Numbers as texts, in lists and tables too."""
    if isinstance(value, dict):
        return {name: _texts(cell) for name, cell in value.items()}
    return [*map(_texts, value)] if isinstance(value, list) else str(value)


def _value(where: str, cell: Any, values: Mapping[str, Fraction | Term]) -> Fraction | Term:
    if not isinstance(cell, str) or re.fullmatch("[-+0-9./]*([eE][-+0-9./]+)?", cell):
        return number_in(where, cell)
    odd = _NO_TERM.search(cell.strip())
    if odd is not None:
        raise InputError(
            f"{where}: {shown(cell)}: {shown(odd[0])} is not known; write + - * / ** of numbers "
            "and of parameters, which have the letters A to Z"
        )
    if len(cell) > MAX_LETTERS:
        raise InputError(f"{where}: the term has {len(cell)} letters; write at most {MAX_LETTERS}")
    try:
        tree = ast.parse(cell.strip(), mode="eval").body
    except (SyntaxError, ValueError, RecursionError, MemoryError) as error:
        raise InputError(f"{where}: {shown(cell)} is no term; write one like 1 + 2*v") from error
    return _of(_Place(where, cell.strip(), values), tree)


class _Place(Record):
    where: str
    text: str
    values: Mapping[str, Fraction | Term]


def _of(place: _Place, node: ast.expr) -> Fraction | Term:
    """The value of a term; each number in it is read as it is written."""
    if isinstance(node, ast.Constant):
        return rational(place.where, ast.get_source_segment(place.text, node) or "")
    if isinstance(node, ast.Name) and node.id in place.values:
        return place.values[node.id]
    if isinstance(node, ast.UnaryOp) and isinstance(node.op, ast.USub):
        return -_of(place, node.operand)
    if isinstance(node, ast.BinOp) and type(node.op) in _OPERATIONS:
        sides = _of(place, node.left), _of(place, node.right)
        try:
            found: Fraction | Term = _OPERATIONS[type(node.op)](*sides)
            return found
        except ZeroDivisionError as error:
            raise InputError(
                f"{place.where}: {shown(place.text)} divides by zero; choose other intervals"
            ) from error
    if isinstance(node, ast.BinOp) and isinstance(node.op, ast.Pow):
        base, exponent = _of(place, node.left), _power(place, node.right)
        if isinstance(base, Term):
            return base**exponent if exponent else Fraction(1)
        if exponent * (base.numerator.bit_length() + base.denominator.bit_length()) > MAX_BITS:
            raise InputError(
                f"{place.where}: {shown(place.text)} is too long; write a shorter term"
            )
        return base**exponent
    part = ast.get_source_segment(place.text, node) or place.text
    known = ", ".join(place.values) or "none"
    is_angle = re.search(r"\b(cos|sin|tan|pi)\b", part) is not None
    raise InputError(
        f"{place.where}: {shown(part)} is no term; write + - * / ** of numbers and of the "
        f"parameters ({known})" + ANGLES * is_angle
    )


def _power(place: _Place, node: ast.expr) -> int:
    written = ast.get_source_segment(place.text, node) or ""
    exponent = int(written) if re.fullmatch("[0-9]{1,9}", written) else -1
    if not 0 <= exponent <= MAX_POWER:
        raise InputError(
            f"{place.where}: {shown(place.text)}: write a whole power from 0 to {MAX_POWER}"
        )
    return exponent
