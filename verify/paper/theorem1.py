"""`THEORSS4.1ExistenCollapse`, assembled: constants, obligations, assumptions."""

from __future__ import annotations

from functools import cache

from verify.language.record import Record
from verify.language.statement import Assumption, Choice, Constant, Obligation
from verify.paper import initial_data, recursion
from verify.paper.assumptions import ASSUMPTIONS
from verify.paper.hypotheses import hypotheses, observations
from verify.paper.initial_data import CONSTANTS, ConstantSet
from verify.paper.parameters import HYPOTHESES, PARAMETERS, PRINTED, REPAIRED, THEOREM
from verify.paper.printed_definitions import check_definitions
from verify.paper.rows import Cause, Remark
from verify.publication import Change


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

    ``common`` are the constants of both sets; they exist where the hypotheses hold.
    """

    name: str
    parameters: tuple[str, ...]
    common: tuple[Constant, ...]
    parts: dict[str, Part]
    assumptions: tuple[Assumption, ...]

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
    """The theorem, built once per process.

    Raises:
        OwnError: if a constant is not defined as in the paper.
    """
    first = (observations, initial_data.rows, recursion.initialization)
    sections = (*first, recursion.rows, recursion.conclusion)
    parts = {HYPOTHESES: Part(HYPOTHESES, (), tuple(hypotheses()))}
    for group in (PRINTED, REPAIRED):
        k = ConstantSet(group)
        rows = tuple(row for section in sections for row in section(k))
        parts[group] = Part(group, tuple(k.constants()), rows)
    check_definitions((*CONSTANTS, *parts[PRINTED].bounds))
    return Theorem(THEOREM, PARAMETERS, CONSTANTS, parts, ASSUMPTIONS)
