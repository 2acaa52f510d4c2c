"""Givens that are defined because of what other givens say, and not as they stand.

A given such as 1/n <= 2 is defined where 0 < n is a given before it. Where that only follows from
other givens, such as 2 <= n, it becomes a given, too; and a row in a context of its own, which has
those other givens, shows that it restricts nothing.
"""

from __future__ import annotations

import math
from collections.abc import Callable, Iterable, Iterator, Mapping

from verify.language.record import Record
from verify.language.statement import NEEDED, Context, Given, Obligation, Statement
from verify.language.terms import Claim, Term, names_of, substitute_claim, symbol
from verify.prover.clearing import has_value, inner_first
from verify.prover.session import ZERO

#: Whether each row of a statement is proved.
Proves = Callable[[Statement], bool]


class Support(Record):
    """A context with the givens before some others, and rows that these are defined by."""

    context: Context
    rows: tuple[Obligation, ...]


def completed(statement: Statement, proves: Proves) -> Statement:
    """The statement in which each given is defined by those before it, if that can be shown.

    A given that says the sign of a divisor, a radicand or the like is added to a context only if a
    row for it was proved, which stands in the statement then.
    """
    for context in statement.contexts:
        found = _Completion(statement, context)
        if not found.supports:
            continue
        supports = tuple(support.context for support in found.supports)
        rows = tuple(row for support in found.supports for row in support.rows)
        before = _before(statement, context)
        if proves(statement._replace(contexts=(*before, *supports), obligations=rows)):
            i = len(before)
            others = statement.contexts[i + 1 :]
            statement = statement._replace(
                contexts=(*before, *supports, found.context, *others),
                obligations=(*statement.obligations, *rows),
            )
    return statement


def _before(statement: Statement, context: Context) -> tuple[Context, ...]:
    """The contexts before one."""
    names = [other.name for other in statement.contexts]
    return statement.contexts[: names.index(context.name)]


def _around(statement: Statement, context: Context) -> list[Context]:
    """The contexts around one, the outermost first."""
    found: list[Context] = []
    parent = context.parent
    while parent is not None:
        found.insert(0, next(other for other in statement.contexts if other.name == parent))
        parent = found[0].parent
    return found


class _Completion:
    """A context with the givens that are missing, and what supports them."""

    def __init__(self, statement: Statement, context: Context) -> None:
        self.statement, self.given = statement, context
        self.variables = {variable.name for variable in context.variables}
        self.values = _definitions(statement, context)
        kinds = {given.kind for given in context.givens}
        self.kind = "plain" if kinds <= {"plain"} else "carried"
        self.known: dict[Claim, Given] = {}
        self.supports: list[Support] = []
        waiting = [*context.givens]
        while waiting := [*self._take(waiting)]:
            missing = self._missing(waiting[0])
            if self.known.keys() >= {*missing}:  # nothing, or what no sign defines, as 1/0
                break
            self._support(missing)
        #: Givens that cannot be defined stay where they are, at the end.
        self.context = context._replace(givens=(*self.known.values(), *waiting))

    def _take(self, waiting: Iterable[Given]) -> Iterator[Given]:
        """Afterwards the givens that are defined by those before them are known; the others."""
        for given in waiting:
            parts = inner_first((given.claim.lhs, given.claim.rhs), _children)
            if all(has_value(part, self._is_known) for part in parts):
                self.known.setdefault(given.claim, given)
            else:
                yield given

    def _is_known(self, claim: Claim) -> bool:
        """Whether a claim is a given, or is about what is outside, where it can be a row."""
        return claim in self.known or self.variables.isdisjoint(names_of(claim.rhs))

    def _missing(self, given: Given) -> list[Claim]:
        """The signs that a given needs, each after those that it needs itself."""
        found: list[Claim] = []
        for part in inner_first((given.claim.lhs, given.claim.rhs), _children):
            if not has_value(part, lambda claim: self._is_known(claim) or claim in found):
                number = part.children[-1]
                if part.op == "div" and self._value(number) < 0:
                    found.append(Claim("<", ZERO, -number))
                else:
                    found.append(Claim("<" if part.op in ("div", "log") else "<=", ZERO, number))
        return found

    def _support(self, missing: list[Claim]) -> None:
        """Afterwards signs are known, and a context has rows for them."""
        names = [other.name for other in self.statement.contexts]
        name = f"{self.given.name}.defined.{len(self.supports) + 1}"
        while name in names:
            name = f"{name}.{len(names)}"
        new = {old: symbol(f"{name}.{old}") for old in self.variables}
        givens = [
            Given(f"{name}.{i}", substitute_claim(given.claim, new))
            for i, given in enumerate(self.known.values(), 1)
        ]
        context = self.given._replace(
            name=name,
            variables=tuple(v._replace(name=f"{name}.{v.name}") for v in self.given.variables),
            givens=tuple(givens),
            point={f"{name}.{old}": term for old, term in self.given.point.items()},
            says="",
            constants=(),
        )
        rows = tuple(
            Obligation(
                f"{name}.sign{i}",
                "",
                "",
                NEEDED,
                f"the givens of {self.given.name} are defined",
                substitute_claim(claim, new),
                context=name,
            )
            for i, claim in enumerate(missing, 1)
        )
        self.supports.append(Support(context, rows))
        for row, claim in zip(rows, missing, strict=True):
            self.known[claim] = Given(f"{row.name}.given", claim, self.kind)

    def _value(self, term: Term) -> float:
        """About the value of a term at the point; NaN where it is not known."""
        from verify.prover.search.compiled import estimates  # loaded only where it is used

        try:
            return float(estimates([], [term], self.values)()[0])
        except (ArithmeticError, ValueError, KeyError, RecursionError):
            return math.nan


def _children(term: Term) -> tuple[Term, ...]:
    return term.children


def _definitions(statement: Statement, context: Context) -> Mapping[str, Term]:
    """What names stand for, at the points of a context and of those around it."""
    found = {**statement.parameters, **{one.name: one.term for one in statement.constants}}
    for other in (*_around(statement, context), context):
        found |= {**other.point, **{one.name: one.term for one in other.constants}}
    return found
