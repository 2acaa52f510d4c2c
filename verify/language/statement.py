"""A statement: what is claimed, and nothing about how it is proved.

A statement has named constants, contexts (variables with what is given about them) and
obligations; and, listed beside them, what is believed. Everything here is data: two statements
that say the same are equal.
"""

from __future__ import annotations

from collections.abc import Mapping
from types import MappingProxyType

from verify.language.record import Record
from verify.language.terms import Claim, Term

NEEDED = "needed"
PRINTED = "printed"

PROVED = "proved"
REFUTED = "refuted"
UNDECIDED = "undecided"

NOTHING: Mapping[str, Term] = MappingProxyType({})


class Constant(Record):
    r"""A named constant.

    ``letter`` and ``tex`` are how people read it, ``label`` the paper's ``\label`` nearest to its
    definition.
    """

    name: str
    letter: str
    tex: str
    label: str
    term: Term

    @property
    def short_name(self) -> str:
        """The name without the set it belongs to."""
        return self.name.rpartition(".")[2]


class Choice(Record):
    """A constant that may be any rational number on one side of a bound.

    The ``constant`` has the bound as its term; the choice is rounded from it ``down`` or ``up``
    (above ``base``, where that is given).
    """

    constant: Constant
    direction: str = "down"
    base: Term | None = None


class Variable(Record):
    """A universally quantified number of a context."""

    name: str
    letter: str
    tex: str


class Given(Record):
    """What a context assumes of its variables.

    ``kind`` is plain; or, in a context for an induction, carried (shown at the start and from
    state to state) or standing (an assumption gives it for every state).
    """

    name: str
    claim: Claim
    kind: str = "plain"
    assumption: str | None = None


class Context(Record):
    """Variables with what is given about them, inside another context (None: the outermost).

    Givens are in an order in which each is defined by those before it. ``point`` has values, over
    the names of the parent, at which all givens hold.
    """

    name: str
    variables: tuple[Variable, ...]
    givens: tuple[Given, ...]
    point: Mapping[str, Term]
    parent: str | None = None
    says: str = ""
    constants: tuple[Constant, ...] = ()

    @property
    def claims(self) -> dict[str, Claim]:
        """What is given, by its names."""
        return {given.name: given.claim for given in self.givens}


class Applies(Record):
    """The claim that these values satisfy all givens of a context, so that its theorems hold."""

    context: str
    at: Mapping[str, Term]


class Always(Record):
    """The claim that from this start, with this next state, the givens hold for ever."""

    context: str
    start: Mapping[str, Term]
    next: Mapping[str, Term]


class Obligation(Record):
    """One claim that has to be decided, for all values of the variables in scope.

    ``role`` is ``printed`` (what the paper says) or ``needed`` (what the theorem rests on),
    ``says`` the step in the paper's words, ``uses`` the names of the assumptions that the step
    takes on trust, ``severity`` how bad it is if it is false, ``corrected_by`` the name of the row
    that replaces it then.
    """

    name: str
    group: str
    label: str
    role: str
    says: str
    claim: Claim | Applies | Always
    uses: tuple[str, ...] = ()
    corrected_by: str | None = None
    severity: str | None = None
    context: str | None = None


class Assumption(Record):
    """What is used and not proved here.

    ``kind`` is definition (of the model), law of motion, calculus, general mathematics, glue (a
    sentence of the argument), or numbered glue, which names the facts that it puts together.
    """

    name: str
    label: str
    sentence: str
    kind: str = "glue"


class Cite(Record):
    """Another statement, whose theorems may be used.

    ``content`` is its file, ``cites`` has what is cited there, and ``assumptions`` what it takes on
    trust. ``certificate`` proves it, and is empty if none is at hand.
    """

    name: str
    theorem: str
    content: bytes
    cites: tuple[Cite, ...] = ()
    assumptions: tuple[Assumption, ...] = ()
    certificate: bytes = b""

    @property
    def trusted(self) -> tuple[Assumption, ...]:
        """What is taken on trust there, and in what is cited there."""
        inner = (assumption for cite in self.cites for assumption in cite.trusted)
        return tuple(dict.fromkeys((*self.assumptions, *inner)))


class Statement(Record):
    """Constants, contexts, obligations and assumptions.

    Constants stand in an order in which each uses only parameters and earlier constants; contexts
    come after their parents.
    """

    theorem: str
    title: str
    parameters: Mapping[str, Term]
    constants: tuple[Constant, ...]
    contexts: tuple[Context, ...]
    obligations: tuple[Obligation, ...]
    assumptions: tuple[Assumption, ...]
    cites: tuple[Cite, ...] = ()

    def context(self, name: str) -> Context:
        """The context of this name.

        Raises:
            ValueError: if there is none.
        """
        (found,) = (context for context in self.contexts if context.name == name)
        return found
