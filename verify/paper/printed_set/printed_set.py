"""The set as printed, as a statement about all parameters: the sharper theorem applies."""

from __future__ import annotations

from collections.abc import Iterable, Iterator

from verify.language.argument import Item, Line
from verify.language.statement import NEEDED, Applies, Cite, Obligation, Statement
from verify.language.terms import symbol
from verify.paper.assumptions import STEP_ASSUMPTIONS
from verify.paper.dynamics.carried import START
from verify.paper.everywhere import chart
from verify.paper.groups import PRINTED
from verify.paper.parameters import THEOREM
from verify.paper.printed_set import initial, numbers
from verify.paper.sharper.sharper import ASSUMPTIONS as CITED
from verify.paper.sharper.sharper import NAME as SHARPER
from verify.paper.step.initial import CONTEXT

NAME = f"{THEOREM}, the set as printed"
TITLE = (
    "For all 0 < r < 1, V_0 > 0, delta_theta > 0 and all theta_0 with 0 < -cos theta_0 <= 1 that "
    "satisfy the stability condition: from every state of the set as printed with d_0 > 0 and "
    "eta_s > 0 the particles collapse, with -cos of the final angle within delta_theta of "
    "-cos theta_0; so also where -cos of the angle at the start is off by at most Theta/6, which "
    "is the room that an interior needs"
)
#: The row that the sharper theorem applies to each state of the set.
COLLAPSE = "collapse"
#: That the set has an interior is the step's glue, from rows of the same names.
ASSUMPTIONS = tuple(
    one
    for one in STEP_ASSUMPTIONS
    if one.name in ("cauchy-schwarz", "open-condition", "glue-interior")
)


def rows() -> Iterator[Obligation]:
    """What is claimed of the numbers, of a point of the set, and of each state."""
    yield from _said((*numbers.room(), *numbers.conclusions(), *initial.inside()), chart.CONTEXT)
    at = dict(numbers.MEANING) | {name: symbol(name) for name in initial.point}
    uses = tuple(assumption.name for assumption in ASSUMPTIONS)
    yield Obligation(COLLAPSE, PRINTED, THEOREM, NEEDED,
        "the sharper theorem applies to each state of the set: the particles collapse",
        Applies(f"{SHARPER}:{START}", at), uses, context=CONTEXT)  # fmt: skip


def _said(items: Iterable[Item], context: str) -> Iterator[Obligation]:
    for item in items:
        if isinstance(item, Line) and item.says:
            yield Obligation(item.name, PRINTED, item.label, NEEDED, item.says, item.claim,
                             item.uses, context=context)  # fmt: skip


def statement(sharper: bytes, certificate: bytes) -> Statement:
    """The statement; it cites the sharper theorem, whose statement and certificate are given."""
    space = chart.context(numbers.k)
    space = space._replace(constants=(*space.constants, *numbers.CONSTANTS, *numbers.TURNED))
    cite = Cite(SHARPER, SHARPER, sharper, (), CITED, certificate)
    return Statement(
        NAME, TITLE, {}, (), (space, initial.context()), tuple(rows()), ASSUMPTIONS, (cite,)
    )
