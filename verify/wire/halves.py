"""Rows decided in parts of their contexts, or in cases: the one of two numbers is less, or more.

A divisor that is not 0 has no sign, which the checker needs to know. Where a row of a context stays
undecided, or the context is not seen to have a point, there is another statement that says the
same: in place of the context it has one for each sign, with all rows in each of them.
"""

from __future__ import annotations

import re
from collections.abc import Callable, Collection, Iterator, Mapping
from functools import partial
from itertools import product

from verify.language.statement import PROVED, UNDECIDED, Context, Given, Obligation, Statement
from verify.language.terms import Claim, Term, substitute, substitute_claim, symbol
from verify.prover.budget import WorkBudget
from verify.prover.outcome import Outcome
from verify.prover.parts import in_parts
from verify.prover.session import ZERO
from verify.wire.text import Page
from verify.wire.text.points import Points

#: Of so many differences the signs are told apart.
MAX_SPLIT = 2
#: So long points are looked for, in seconds: what the work is worth that is counted.
SECONDS = 1


def decided_in_parts(
    first: Outcome, page: Page, budget: WorkBudget, decide: Callable[..., Outcome]
) -> Outcome | None:
    """The outcome with parts, or cases, of the contexts in which rows are open.

    None if no more is decided there.
    """
    statement = first.statement
    found = {row.name for row, decision in first.rows if decision.claimed == UNDECIDED}
    open_rows = [r.name for r in statement.obligations if r.name in found and r.context]
    points, shares = Points(SECONDS), 2.5 * max(1, len(open_rows))

    def proves(part: Statement) -> bool:
        if budget.is_over:
            return False
        with budget.part(4, shares) as share:
            return decide(part, share).claimed == PROVED

    def parted() -> Statement | None:
        other = in_parts(statement, open_rows, lambda n, g: points.find(n, g, {}), proves)
        return None if other is statement else other

    makers: tuple[Callable[[], Statement | None], ...]
    makers = (parted, partial(halved, statement, open_rows))
    for make in makers:
        try:
            other = make()
            second = None if other is None else decide(other, budget, page.hints)
        except (ArithmeticError, ValueError, RecursionError):  # nobody has asked for the parts
            continue
        if second and sum(d.claimed == UNDECIDED for _, d in second.rows) < len(found):
            return second
    return None


def halved(statement: Statement, open_rows: Collection[str]) -> Statement | None:
    """The statement with cases for contexts of these rows; None if that is nothing new.

    Only contexts that nothing else refers to are taken apart. Cases are numbered from 1 on, or
    behind all numbers in names if another name is like that.
    """
    numbers = (int(n) for name in _names(statement) for n in re.findall("[0-9]+", name))
    for first in (1, max(numbers, default=0) + 1):
        found = _halved(statement, open_rows, first)
        names = [] if found is None else [*_names(found)]
        if len({*names}) == len(names):
            return found
    return None


def _names(statement: Statement) -> Iterator[str]:
    """The names of which each has to be another one."""
    yield from statement.parameters
    yield from (one.name for one in statement.constants)
    yield from (row.name for row in statement.obligations)
    for context in statement.contexts:
        yield context.name
        yield from (one.name for one in context.variables)
        yield from (one.name for one in context.constants)
        yield from (one.name for one in context.givens)


def _halved(statement: Statement, open_rows: Collection[str], first: int) -> Statement | None:
    """The same with cases that are numbered from here on."""
    rows: dict[str, list[Obligation]] = {}
    for row in statement.obligations:
        if row.context is not None:
            rows.setdefault(row.context, []).append(row)
    held = {c.parent for c in statement.contexts}
    held |= {getattr(row.claim, "context", None) for row in statement.obligations}
    points, parts = Points(SECONDS), dict[str, list[_Part]]()
    for context in statement.contexts:
        own = rows.get(context.name, [])
        good = all(isinstance(row.claim, Claim) for row in own)
        if good and context.name not in held and any(row.name in open_rows for row in own):
            found = [*_parts(context, points, first)]
            if found:
                parts[context.name] = found
    if not parts:
        return None
    contexts: list[Context] = []
    for context in statement.contexts:
        contexts += [part.context for part in parts.get(context.name, ())] or [context]
    obligations: list[Obligation] = []
    for row in statement.obligations:
        each = parts.get(row.context or "", ())
        obligations += [part.row(row) for part in each] or [row]
    return statement._replace(contexts=tuple(contexts), obligations=tuple(obligations))


class _Part:
    """One case of a context: its names end with a number."""

    def __init__(self, context: Context, number: int, more: Mapping[str, list[Claim]]) -> None:
        name = f"{context.name}.{number}"
        own = [variable.name for variable in context.variables]
        own += [constant.name for constant in context.constants]
        self.number, self.names = number, {old: symbol(f"{name}.{old}") for old in own}
        givens: list[Given] = []
        for given in context.givens:
            for i, claim in enumerate(more.get(given.name, ()), 1):
                givens.append(Given(f"{given.name}.{number}.sign{i}", self._here(claim)))
            claim = self._here(given.claim)
            givens.append(given._replace(name=f"{given.name}.{number}", claim=claim))
        self.context = context._replace(
            name=name,
            variables=tuple(v._replace(name=f"{name}.{v.name}") for v in context.variables),
            givens=tuple(givens),
            constants=tuple(
                c._replace(name=f"{name}.{c.name}", term=substitute(c.term, self.names))
                for c in context.constants
            ),
        )

    def _here(self, claim: Claim) -> Claim:
        return substitute_claim(claim, self.names)

    def with_point(self, points: Points) -> bool:
        """Whether values are found at which all givens seem to hold: the context has them then."""
        names = [variable.name for variable in self.context.variables]
        found = points.find(names, self.context.givens, {})
        if found is not None:
            self.context = self.context._replace(point=found)
        return found is not None

    def row(self, row: Obligation) -> Obligation:
        """A row in this case."""
        claim = row.claim
        claim = self._here(claim) if isinstance(claim, Claim) else claim
        return row._replace(
            name=f"{row.name}.{self.number}", claim=claim, context=self.context.name
        )


def _parts(context: Context, points: Points, first: int) -> Iterator[_Part]:
    """The cases of a context; none unless each of them is seen to have a point."""
    different = {
        given.name: given.claim.rhs.children[0]
        for given in context.givens
        if given.kind == "plain" and _is_difference(given.claim)
    }
    chosen = [*different.items()][:MAX_SPLIT]
    found = []
    for number, signs in enumerate(product((-1, 1), repeat=len(chosen)), first):
        more = {name: _signed(term, sign) for (name, term), sign in zip(chosen, signs, strict=True)}
        part = _Part(context, number, more)
        if not part.with_point(points):
            return
        found.append(part)
    if chosen:
        yield from found


def _is_difference(claim: Claim) -> bool:
    """Whether the claim says that a square is positive."""
    square = claim.rhs
    return claim.key[:2] == ("<", ZERO) and square.op == "pow" and square.exponent == 2


def _signed(term: Term, sign: int) -> list[Claim]:
    """What says that a term is positive, or negative."""
    if sign > 0:
        return [Claim("<", ZERO, term)]
    bound = [Claim("<", term, ZERO)] if term.op == "symbol" else []
    return [*bound, Claim("<", ZERO, -term)]
