"""Theorem 1 at many points: every row of both sets, from code that is compiled once.

Rows that balls cannot decide, because they hold with equality, are decided by what is kept of
algebra, where balls show all claims on which that rests. Where balls leave anything open the point
is decided as a single one.
"""

from __future__ import annotations

from collections.abc import Iterator, Mapping
from fractions import Fraction
from functools import cache
from typing import NamedTuple

from verify.language.fold import FAILS, HOLDS, OPEN
from verify.language.statement import (
    NEEDED,
    PROVED,
    REFUTED,
    UNDECIDED,
    Choice,
    Constant,
    Obligation,
)
from verify.language.terms import Claim, as_term
from verify.paper.commands.citing import COLLAPSE, applies
from verify.paper.commands.theorem1 import decide_point
from verify.paper.parameters import GROUPS, HYPOTHESES, PRINTED
from verify.paper.theorem1 import theorem
from verify.prover import balls
from verify.prover.choices import Chooser, OpenChoiceError, entries_of
from verify.prover.straight import StraightLine
from verify.views.findings import ScannedPoint
from verify.views.words import fair_verdict

#: The precision at which the points are computed, as in a single run.
BITS = 192

_VERDICTS = {HOLDS: PROVED, FAILS: REFUTED}
_KEPT = {verdict: value for value, verdict in _VERDICTS.items()}


class Scan:
    """Decides points one after another, by code for all rows and for what is kept of algebra."""

    def __init__(self) -> None:
        self._chooser = Chooser()
        self._code = StraightLine(theorem().parameters)
        parts = theorem().parts
        self._rows: list[Obligation] = []
        for group in GROUPS:
            if group == PRINTED:
                self._define(theorem().common)
            self._define(parts[group].constants)
            self._rows += parts[group].obligations
        self._claims = {row.name: row.claim for row in self._rows if isinstance(row.claim, Claim)}
        kept = theorem().kept
        self._kept = {name: kept[claim] for name, claim in self._claims.items() if claim in kept}
        self._needed = [row.name for row in self._rows if row.role == NEEDED]
        first = parts[HYPOTHESES].obligations
        self._hypotheses = [row.name for row in first if row.role == NEEDED]
        self._needs = [need for found in self._kept.values() for need in found.needs]
        claims = [*self._claims.values(), *self._needs]
        self._run = self._code.function(map(self._code.verdict, claims), BITS)

    def _define(self, constants: tuple[Constant | Choice, ...]) -> None:
        for item in constants:
            if isinstance(item, Choice):
                self._choose(item)
            else:
                self._code.define(item.name, item.term)
                self._chooser.definitions[item.name] = item.term

    def _choose(self, choice: Choice) -> None:
        constant, base = choice.constant, choice.base
        bound = constant.term if base is None else constant.term - base
        entries = entries_of(constant.term) if base is None else (bound,)
        self._code.call(constant.name, self._chooser.rounding(choice), bound, *entries)

    def at(self, parameters: Mapping[str, Fraction]) -> ScannedPoint:
        """The verdicts that `verify.paper.commands.theorem1.decide` finds at this point."""
        found = self._by_balls(parameters)
        if found is not None:
            return found
        outcome = decide_point({name: as_term(value) for name, value in parameters.items()})
        rows = {row.name: decision.verdict for row, decision in outcome.rows}
        return ScannedPoint(outcome.verdict, _told(rows))

    def _by_balls(self, parameters: Mapping[str, Fraction]) -> ScannedPoint | None:
        """The verdicts at a point; None if the hypotheses or a row are left open there."""
        self._chooser.start(parameters)
        with balls.precision(BITS):
            try:
                values = self._run(*map(balls.from_fraction, list(parameters.values())))
            except OpenChoiceError:
                return None
        verdicts = dict(zip(self._claims, values, strict=False))
        if any(verdicts[name] != HOLDS for name in self._hypotheses):
            return None
        held = {
            need
            for need, value in zip(self._needs, values[len(verdicts) :], strict=True)
            if value == HOLDS
        }
        for name in [name for name, value in verdicts.items() if value == OPEN]:
            found = self._kept.get(name)
            if found is None:
                verdicts[name] = self._chooser.verdict(self._claims[name])
            elif held.issuperset(found.needs):
                verdicts[name] = _KEPT[found.verdict]
        if OPEN in verdicts.values():
            return None
        refuted = any(verdicts[name] == FAILS for name in self._needed)
        rows = {name: _VERDICTS[value] for name, value in verdicts.items()}
        rows[COLLAPSE] = PROVED if applies(rows) else UNDECIDED
        return ScannedPoint(REFUTED if refuted else PROVED, _told(rows))


def _told(rows: dict[str, str]) -> dict[str, str]:
    """The verdicts on rows, those on printed rows as fair as on a single point."""
    return rows | {
        row.name: fair_verdict(row, rows[row.name], rows.get(row.corrected_by or ""))
        for row in _printed()
        if row.name in rows
    }


@cache
def _printed() -> tuple[Obligation, ...]:
    """The printed rows that may be false."""
    rows = (row for part in theorem().parts.values() for row in part.obligations)
    return tuple(row for row in rows if row.severity)


class Grid(NamedTuple):
    """Values of r between two ends, both included, at equal distances.

    ``parameters`` has r, c, V_0 and delta_theta in this order; its r is not used. Two values at
    least.
    """

    low: Fraction
    high: Fraction
    steps: int
    parameters: Mapping[str, Fraction]

    def part(self, places: range) -> list[tuple[Fraction, ScannedPoint]]:
        """The points at some places of the grid, from 0 on."""
        return [(r, _job().at({**self.parameters, "r": r})) for r in map(self.value, places)]

    def value(self, i: int) -> Fraction:
        """A value of r, from 0 on."""
        return self.low + (self.high - self.low) * i / (self.steps - 1)

    def parts(self, size: int) -> Iterator[range]:
        """The places in groups of a size."""
        places = range(self.steps)
        return (places[i : i + size] for i in range(0, self.steps, size))


@cache
def _job() -> Scan:
    """What this process has compiled."""
    return Scan()
