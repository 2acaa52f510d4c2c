"""A statement: what is claimed, and nothing about how it is proved."""

from __future__ import annotations

from fractions import Fraction
from typing import NamedTuple

from verify.language.terms import Claim, Term

HYPOTHESES = "hypotheses"
PRINTED = "printed"
REPAIRED = "repaired"
GROUPS = (HYPOTHESES, PRINTED, REPAIRED)


class Constant(NamedTuple):
    r"""A named constant of the paper.

    ``letter`` and ``tex`` are how people read it, ``label`` the paper's ``\label`` nearest to its
    definition. A constant with ``chosen`` is a rational number that the prover may choose: its
    ``term`` is then only the bound, and ``direction`` says on which side of the bound the choice
    lies (``down`` or ``up``).
    """

    name: str
    letter: str
    tex: str
    label: str
    term: Term
    chosen: bool = False
    direction: str = "down"
    base: Term | None = None

    @property
    def short_name(self) -> str:
        """The name without the set it belongs to."""
        return self.name.rpartition(".")[2]


class Variable(NamedTuple):
    """A universally quantified symbol of an obligation: a number in an open interval."""

    name: str
    lower: Fraction | None = None
    upper: Fraction | None = None


class Obligation(NamedTuple):
    """One claim that has to be decided, for all values of its variables.

    ``role`` is ``printed`` (what the paper says) or ``needed`` (what the theorem rests on),
    ``says`` the step in the paper's words, ``uses`` the names of the assumptions that the step
    takes on trust, ``corrected_by`` the name of the row that replaces a refuted one.
    """

    name: str
    group: str
    label: str
    role: str
    says: str
    claim: Claim
    uses: tuple[str, ...] = ()
    corrected_by: str | None = None
    variables: tuple[Variable, ...] = ()


class Assumption(NamedTuple):
    """An estimate for every state, or a law, that is used and not proved here."""

    name: str
    label: str
    sentence: str


class Change(NamedTuple):
    """One line of the table `paper | needed | why`."""

    label: str
    paper: str
    needed: str
    why: str


class Statement(NamedTuple):
    """Named constants, obligations and assumptions over the symbols of the parameters.

    Constants stand in an order in which each uses only parameters and earlier constants.
    """

    theorem: str
    parameters: tuple[str, ...]
    constants: tuple[Constant, ...]
    obligations: tuple[Obligation, ...]
    assumptions: tuple[Assumption, ...]
    changes: tuple[Change, ...] = ()

    def of_group(self, *groups: str) -> Statement:
        """The same statement with only the obligations, and set constants, of some groups."""
        dropped = tuple(f"{group}." for group in GROUPS if group not in groups)
        return Statement(
            self.theorem,
            self.parameters,
            tuple(c for c in self.constants if not c.name.startswith(dropped)),
            tuple(o for o in self.obligations if o.group in groups),
            self.assumptions,
            self.changes,
        )
