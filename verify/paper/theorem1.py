"""`THEORSS4.1ExistenCollapse`, as the page `theorem1.toml` states it: constants, rows, assumptions.

The page comes with the program in a compiled form, too, which is taken where it is about the text
of the page; after any change to the text, or to that form, the page is read.
"""

from __future__ import annotations

import os
from collections.abc import Iterable, Mapping
from functools import cache
from hashlib import sha256

from verify.language.record import Record
from verify.language.statement import Assumption, Choice, Constant, Obligation
from verify.language.terms import Claim
from verify.paper.parameters import HYPOTHESES, PRINTED, REPAIRED
from verify.publication import Cause, Change, Remark
from verify.wire.compiled import Compiled, Kept, read_compiled
from verify.wire.packaged import PACKAGED, recorded

#: The page, and what is compiled of it.
PAGE = os.path.join(os.path.dirname(__file__), "theorem1.toml")
COMPILED = os.path.join(PACKAGED, "theorem1.txt")


class Part(Record):
    """The constants and the rows of one group."""

    group: str
    constants: tuple[Constant | Choice, ...]
    obligations: tuple[Obligation, ...]

    @property
    def bounds(self) -> tuple[Constant, ...]:
        """The constants, with the bound where one may be chosen."""
        return tuple(c.constant if isinstance(c, Choice) else c for c in self.constants)


class Theorem(Record):
    """Theorem 1 over the symbols r, c, V_0 and delta_theta.

    ``common`` are the constants of both sets; they exist where the hypotheses hold. ``kept`` has
    what is known of claims that enclosures do not decide: see `verify.paper.commands.kept`.
    """

    name: str
    parameters: tuple[str, ...]
    common: tuple[Constant, ...]
    parts: dict[str, Part]
    assumptions: tuple[Assumption, ...]
    kept: Mapping[Claim, Kept]

    @property
    def changes(self) -> tuple[Change, ...]:
        """What the repaired set changes."""
        from verify.paper.commentary import CHANGES  # texts are loaded where they are shown

        return CHANGES

    @property
    def causes(self) -> tuple[Cause, ...]:
        """Why rows of the printed set are refuted."""
        from verify.paper.commentary import CAUSES

        return CAUSES

    @property
    def remarks(self) -> tuple[Remark, ...]:
        """Remarks on the text, where no inequality decides."""
        from verify.paper.commentary import REMARKS

        return REMARKS


@cache
def theorem() -> Theorem:
    """The theorem, made once per process.

    Raises:
        InputError: if the page was changed and cannot be read.
        OwnError: if a constant is not defined as in the paper.
    """
    with open(PAGE, "rb") as file:
        content = file.read()
    found = _at_hand(content) or as_read(content)
    constants: dict[str, list[Constant | Choice]] = {HYPOTHESES: [], PRINTED: [], REPAIRED: []}
    for item in found.constants:
        bound = item.constant if isinstance(item, Choice) else item
        constants[_group(bound.name)].append(item)
    common = tuple(item for item in constants.pop(HYPOTHESES) if isinstance(item, Constant))
    parts = {HYPOTHESES: Part(HYPOTHESES, (), _rows(found.rows, HYPOTHESES))}
    for group, items in constants.items():
        parts[group] = Part(group, tuple(items), _rows(found.rows, group))
    return Theorem(found.theorem, found.parameters, common, parts, found.assumptions, found.kept)


def _at_hand(content: bytes) -> Compiled | None:
    """What comes with the program, if it is about this text and nobody has changed it since."""
    try:
        with open(COMPILED, "rb") as file:
            lines = file.read()
    except FileNotFoundError:
        return None
    if sha256(lines).hexdigest() != dict(recorded("compiled")).get("theorem1.txt"):
        return None
    return read_compiled(lines.decode(), content)


def as_read(content: bytes) -> Compiled:
    """What a text of the page says.

    Raises:
        InputError: if it cannot be read.
        OwnError: if a constant is not defined as in the paper.
    """
    from verify.paper.printed_definitions import check_definitions  # loaded only where it is used
    from verify.wire.text.read_page import read_page

    page = read_page("verify/paper/theorem1.toml", content)
    said = page.statement
    check_definitions(constant for constant in said.constants if _group(constant.name) != REPAIRED)
    constants = tuple(page.choices.get(constant.name, constant) for constant in said.constants)
    parameters = tuple(said.parameters)
    return Compiled(said.theorem, parameters, constants, said.obligations, said.assumptions, {})


def _group(name: str) -> str:
    """The set of a constant; those of both sets stand before them, with the hypotheses."""
    before, _, _ = name.partition(".")
    return before if before in (PRINTED, REPAIRED) else HYPOTHESES


def _rows(rows: Iterable[Obligation], group: str) -> tuple[Obligation, ...]:
    return tuple(row for row in rows if row.group == group)
