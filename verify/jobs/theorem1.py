"""The job `theorem1`: decide Theorem 1 at one choice of the parameters."""

from __future__ import annotations

from collections.abc import Callable, Iterable, Mapping
from fractions import Fraction

from verify.prover import balls
from verify.paper.theorem1 import theorem
from verify.prover.program import Machine, Program
from verify.prover.ground import (
    DEFAULT_MAX_PRECISION,
    DEFAULT_PRECISION,
    PROVED,
    REFUTED,
    UNDECIDED,
    BudgetError,
    Decision,
    Prover,
)
from verify.language.statement import HYPOTHESES, PRINTED, REPAIRED, Assumption, Obligation, Statement
from verify.language.terms import Term

Rows = list[tuple[Obligation, Decision]]

#: The groups that each value of ``--constants`` asks for.
SELECTIONS = {
    "printed": (PRINTED,),
    "repaired": (REPAIRED,),
    "all": (PRINTED, REPAIRED),
}


class Outcome:
    """What was found at one choice of the parameters.

    ``rows`` has the decided rows of each group; a set is missing where a needed hypothesis does
    not hold, or where the precision did not suffice to choose its constants.
    """

    def __init__(
        self,
        parameters: Mapping[str, Term],
        selection: str,
        statement: Statement,
        prover: Prover,
    ) -> None:
        self.parameters = parameters
        self.selection = selection
        self.statement = statement
        self.prover = prover
        self.rows: dict[str, Rows] = {}
        self.spent = ""

    @property
    def groups(self) -> tuple[str, ...]:
        """The sets asked for."""
        return SELECTIONS[self.selection]

    @property
    def hypotheses_verdict(self) -> str:
        """The verdict on the needed hypotheses."""
        return conjunction(d for row, d in self.rows[HYPOTHESES] if row.role == "needed")

    def set_verdict(self, group: str) -> str:
        """The verdict on all rows of one set."""
        return conjunction(decision for _, decision in self.rows[group])

    @property
    def verdict(self) -> str:
        """The verdict on what was asked: the needed rows, or the printed set alone."""
        if self.hypotheses_verdict != PROVED:
            return self.hypotheses_verdict
        asked = PRINTED if self.selection == "printed" else REPAIRED
        return self.set_verdict(asked) if asked in self.rows else UNDECIDED

    @property
    def assumptions(self) -> tuple[Assumption, ...]:
        """The assumptions that the rows shown take on trust."""
        used = {name for rows in self.rows.values() for row, _ in rows for name in row.uses}
        return tuple(a for a in self.statement.assumptions if a.name in used)

    @property
    def all_rows(self) -> Rows:
        """All rows, in the statement's order."""
        return [pair for rows in self.rows.values() for pair in rows]

    @property
    def decided_rows(self) -> Rows:
        """The rows that have a verdict: those that a certificate can have."""
        return [(row, found) for row, found in self.all_rows if found.verdict != UNDECIDED]

    @property
    def exit_code(self) -> int:
        """0 proved, 1 refuted, 3 undecided."""
        return {PROVED: 0, REFUTED: 1, UNDECIDED: 3}[self.verdict]


def conjunction(decisions: Iterable[Decision]) -> str:
    """``refuted`` if one is, else ``undecided`` if one is, else ``proved``; never of nothing."""
    verdicts = {decision.verdict for decision in decisions}
    if not verdicts:
        raise ValueError("an empty list of obligations proves nothing")
    for verdict in (REFUTED, UNDECIDED):
        if verdict in verdicts:
            return verdict
    return PROVED


def decide(
    parameters: Mapping[str, Term],
    selection: str = "all",
    start_bits: int = DEFAULT_PRECISION,
    max_bits: int = DEFAULT_MAX_PRECISION,
) -> Outcome:
    """Decide the hypotheses, and where they hold every row of the sets asked for.

    Args:
        parameters: r, c, V_0, delta_theta as terms without symbols.
        selection: a key of `SELECTIONS`.
        start_bits: the first precision.
        max_bits: the last one.
    """
    statement = theorem().of_group(HYPOTHESES, *SELECTIONS[selection])
    common = theorem().of_group(HYPOTHESES)
    prover = Prover(common, parameters, start_bits, max_bits)
    outcome = Outcome(parameters, selection, statement, prover)
    outcome.rows[HYPOTHESES] = _decide_rows(prover, common)
    if outcome.hypotheses_verdict != PROVED:
        return outcome
    for group in outcome.groups:
        part = theorem().of_group(group)
        try:
            for constant in part.constants[len(common.constants) :]:
                prover.define(constant)
        except BudgetError as error:
            outcome.spent = str(error)
            continue
        outcome.rows[group] = _decide_rows(prover, part)
    return outcome


def _decide_rows(prover: Prover, statement: Statement) -> Rows:
    return [(row, prover.decide(row.claim)) for row in statement.obligations]


def constants_enclosure(bits: int) -> Callable[[Mapping[str, Fraction]], dict[str, balls.Ball]]:
    """A function that encloses all constants of the printed proof, for many parameters.

    The program is compiled once, here. The function takes the values of r, c, V_0 and delta_theta
    and returns a ball for each constant that exists there.
    """
    statement = theorem().of_group(PRINTED)
    program = Program(statement.parameters)
    for constant in statement.constants:
        program.define(constant.name, constant.term)
    slots = [(constant.name, program.slots[constant.name]) for constant in statement.constants]
    with balls.precision(bits):
        machine = Machine(program, balls.BallArithmetic())
        machine.load()

    def enclose(parameters: Mapping[str, Fraction]) -> dict[str, balls.Ball]:
        with balls.precision(bits):
            inputs = [balls.from_fraction(parameters[name]) for name in statement.parameters]
            values = machine.run(inputs).values
        return {name: values[slot] for name, slot in slots if values[slot] is not None}

    return enclose
