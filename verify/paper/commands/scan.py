"""Theorem 1 at many points: every row of both sets, from code that is compiled once.

Rows that balls cannot decide, because they hold with equality, are proved by algebra at the first
point. That proof rests on claims that balls can decide; wherever these hold, it proves the row
again. Where balls leave anything open the point is decided as a single one.
"""

from __future__ import annotations

from collections.abc import Iterator, Mapping, Sequence
from fractions import Fraction
from functools import cache
from typing import Any, NamedTuple

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
from verify.paper.parameters import GROUPS, HYPOTHESES, PRINTED, REPAIRED
from verify.paper.theorem1 import theorem
from verify.prover import balls
from verify.prover.choices import Chooser, OpenChoiceError, entries_of
from verify.prover.outcome import Outcome
from verify.prover.proof import LemmaStep, ObligationStep, Proof
from verify.prover.rules import Interval, Sum
from verify.prover.straight import StraightLine
from verify.views.findings import ScannedPoint
from verify.views.words import fair_verdict

#: The precision at which the points are computed, as in a single run.
BITS = 192

#: How many proofs by algebra are kept.
MAX_ALGEBRAS = 12

_VERDICTS = {HOLDS: PROVED, FAILS: REFUTED}


class Scan:
    """Decides points one after another.

    The code is compiled at the first point at which both sets exist, and again where a point needs
    another proof by algebra, up to `MAX_ALGEBRAS` times.
    """

    def __init__(self) -> None:
        self._algebras: list[Algebra] = []
        self._compiled: Compiled | None = None

    def at(self, parameters: Mapping[str, Fraction]) -> ScannedPoint:
        """The verdicts that `verify.paper.commands.theorem1.decide` finds at this point."""
        found = None if self._compiled is None else self._compiled.at(parameters)
        if found is not None:
            return found
        outcome = decide_point({name: as_term(value) for name, value in parameters.items()})
        if outcome.of_group(REPAIRED) and len(self._algebras) < MAX_ALGEBRAS:
            self._algebras.append(Algebra(outcome))
            self._compiled = Compiled(self._algebras)
        rows = {row.name: decision.verdict for row, decision in outcome.rows}
        return ScannedPoint(outcome.verdict, _told(rows))


class Compiled:
    """Code for all rows, and for the claims on which proofs by algebra rest."""

    def __init__(self, algebras: Sequence[Algebra]) -> None:
        self._algebras = tuple(algebras)
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
        self._algebraic = {name for algebra in algebras for name in algebra.verdicts}
        self._needed = [row.name for row in self._rows if row.role == NEEDED]
        first = parts[HYPOTHESES].obligations
        self._hypotheses = [row.name for row in first if row.role == NEEDED]
        claims = [*self._claims.values(), *(c for a in algebras for c in a.lemmas)]
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

    def at(self, parameters: Mapping[str, Fraction]) -> ScannedPoint | None:
        """The verdicts at a point; None if a constant cannot be rounded with so many bits."""
        self._chooser.start(parameters)
        with balls.precision(BITS):
            try:
                values = self._run(*map(balls.from_fraction, list(parameters.values())))
            except OpenChoiceError:
                return None
        verdicts = dict(zip(self._claims, values, strict=False))
        if any(verdicts[name] != HOLDS for name in self._hypotheses):
            return None
        left = [name for name, value in verdicts.items() if not value]
        for name in left:
            if name not in self._algebraic:
                verdicts[name] = self._chooser.verdict(self._claims[name])
        left = [name for name in left if not verdicts[name]]
        if left and not self._close(left, verdicts, values[len(self._claims) :]):
            return None
        refuted = any(verdicts[name] == FAILS for name in self._needed)
        rows = {name: _VERDICTS[value] for name, value in verdicts.items()}
        rows[COLLAPSE] = PROVED if applies(rows) else UNDECIDED
        return ScannedPoint(REFUTED if refuted else PROVED, _told(rows))

    def _close(self, left: list[str], verdicts: dict[str, int], lemmas: tuple[int, ...]) -> bool:
        """Fill in the rows that are left by a proof by algebra that holds here."""
        start = 0
        for algebra in self._algebras:
            here = lemmas[start : start + len(algebra.lemmas)]
            start += len(algebra.lemmas)
            if (
                algebra.verdicts.keys() >= set(left)
                and all(value == HOLDS for value in here)
                and all(verdicts[name] in (HOLDS, OPEN) for name in algebra.rows)
            ):
                verdicts.update({name: algebra.verdicts[name] for name in left})
                return True
        return False


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


class Algebra:
    """The rows of an outcome that are proved by algebra, whatever the values of the parameters.

    ``verdicts`` has these rows; their proofs rest on the claims ``lemmas`` and on the ``rows``.
    """

    def __init__(self, outcome: Outcome) -> None:
        numbers = {*theorem().parameters}
        for part in theorem().parts.values():
            numbers |= {c.constant.name for c in part.constants if isinstance(c, Choice)}
        self._numbers = numbers
        self.lemmas: list[Claim] = []
        self.rows: set[str] = set()
        self.verdicts: dict[str, int] = {}
        for step in outcome.steps:
            if isinstance(step, LemmaStep) and isinstance(step.proof, Interval):
                self.lemmas.append(step.claim)
            elif isinstance(step, LemmaStep | ObligationStep):
                self._add(step.name, step.proof, outcome)
        self.rows &= outcome.decisions.keys()

    def _add(self, name: str, proof: Proof, outcome: Outcome) -> None:
        if isinstance(proof, Interval):
            return
        if isinstance(proof, Sum):
            if self._numbers & {*proof.using}:
                return  # the proof is about the values at this point
            self.rows |= set(_names(proof.addends))
        if name in outcome.decisions:
            holds = outcome.decisions[name].verdict == PROVED
            self.verdicts[name] = HOLDS if holds else FAILS


def _names(values: tuple[Any, ...]) -> Iterator[str]:
    for value in values:
        if isinstance(value, str):
            yield value
        elif isinstance(value, tuple):
            yield from _names(value)


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
