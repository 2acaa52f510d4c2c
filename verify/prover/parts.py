"""Rows that are shown in two parts of their context: where a term is at most another, and at least.

In each part more is known: a divisor that is not 0 has a sign, an absolute value has no bars, and
a range ends where both sides meet, even if that is no rational number. The parts are contexts of
their own, with a row each, and the row itself follows from the two. Where both sides come together
far away there is one context, of the inverse of the variable.
"""

from __future__ import annotations

import math
from collections.abc import Callable, Iterator, Mapping, Sequence
from fractions import Fraction
from itertools import combinations

from verify.language.record import Record
from verify.language.statement import NEEDED, Context, Given, Obligation, Statement
from verify.language.terms import (
    FUNCTIONS,
    Claim,
    Term,
    as_term,
    exp,
    names_of,
    parts_of,
    pi,
    sqrt,
    substitute_claim,
    symbol,
)
from verify.prover.goal import Bounds, bounds_of
from verify.prover.search.compiled import estimates
from verify.prover.session import ZERO

#: Values for some variables at which givens seem to hold; None if none were found.
Finds = Callable[[Sequence[str], Sequence[Given]], dict[str, Term] | None]
#: Whether each row of a statement is proved.
Proves = Callable[[Statement], bool]

#: So many ways to take a context apart are tried, and parts of parts.
MAX_WAYS, MAX_DEPTH = 4, 2
#: Points between the ends of a range, and where a difference is nearly 0, for sides of size 1.
POINTS, NEAR = 60, 1e-6
#: What is far away.
FAR = (100.0, 1000.0, 10000.0)


class Order(Record):
    """Two terms that are compared; ``is_strict`` where givens say that they differ."""

    lhs: Term
    rhs: Term
    is_strict: bool = False


class Parts(Record):
    """Contexts with a row each, from which a row follows."""

    contexts: tuple[Context, ...]
    rows: tuple[Obligation, ...]


def in_parts(
    statement: Statement, open_rows: Sequence[str], finds: Finds, proves: Proves
) -> Statement:
    """The statement with parts of contexts for those of the rows which are shown in them."""
    for name in open_rows:
        row = next(row for row in statement.obligations if row.name == name)
        if isinstance(row.claim, Claim) and row.context is not None:
            statement = _shown(statement, row, finds, proves, 0) or statement
    return statement


def _shown(
    statement: Statement, row: Obligation, finds: Finds, proves: Proves, depth: int
) -> Statement | None:
    """The statement with parts in which the row is shown; None if that was not found."""
    context = next(c for c in statement.contexts if c.name == row.context)
    if context.constants or any(given.kind != "plain" for given in context.givens):
        return None
    ways = [one for one in _orders(context, row) if _is_news(context, one)][:MAX_WAYS]
    for order in (None, *ways):
        if order is None:
            parts = _inverse(statement, context, row, finds)
        else:
            parts = _parts(statement, context, row, order, finds)
        if parts is None:
            continue
        found: Statement | None = _with(statement, context, row, parts)
        for part in parts.rows:
            if found is None or proves(_alone(found, part)):
                continue
            found = _shown(found, part, finds, proves, depth + 1) if depth < MAX_DEPTH else None
        if found is not None:
            return found
    return None


def _with(statement: Statement, context: Context, row: Obligation, parts: Parts) -> Statement:
    """The statement with parts behind the context, and their rows before the row."""
    contexts, rows = [*statement.contexts], [*statement.obligations]
    i, j = contexts.index(context) + 1, rows.index(row)
    while i < len(contexts) and contexts[i].name.startswith(f"{context.name}.part"):
        i += 1
    contexts[i:i], rows[j:j] = parts.contexts, parts.rows
    return statement._replace(contexts=tuple(contexts), obligations=tuple(rows))


def _alone(statement: Statement, row: Obligation) -> Statement:
    """One row, with its context and those around it."""
    wanted, kept = row.context, list[Context]()
    for context in reversed(statement.contexts):
        if context.name == wanted:
            kept.insert(0, context)
            wanted = context.parent
    return statement._replace(contexts=tuple(kept), obligations=(row,))


def _parts(
    statement: Statement, context: Context, row: Obligation, order: Order, finds: Finds
) -> Parts | None:
    """The parts of a context; None if one of them is not seen to have a point."""
    taken, contexts, rows = {c.name for c in statement.contexts}, [], []
    number = next(n for n in range(1, 1000, 2) if f"{context.name}.part{n}" not in taken)
    for k, is_low in ((number, True), (number + 1, False)):
        name = f"{context.name}.part{k}"
        new = {v.name: symbol(f"{name}.{v.name}") for v in context.variables}
        sides = (order.lhs, order.rhs) if is_low else (order.rhs, order.lhs)
        claims = [Claim("<" if order.is_strict else "<=", *sides)]
        claims += [given.claim for given in context.givens]
        givens = tuple(
            Given(f"{name}.{i}", substitute_claim(claim, new)) for i, claim in enumerate(claims)
        )
        variables = tuple(v._replace(name=f"{name}.{v.name}") for v in context.variables)
        point = finds([v.name for v in variables], givens)
        if point is None or not isinstance(row.claim, Claim):
            return None
        contexts.append(Context(name, variables, givens, point, context.parent))
        says = f"{row.says or row.name}, in part {2 - is_low} of {context.name}"
        claim = substitute_claim(row.claim, new)
        rows.append(Obligation(f"{row.name}.part{k}", "", "", NEEDED, says, claim, context=name))
    return Parts(tuple(contexts), tuple(rows))


def _inverse(statement: Statement, context: Context, row: Obligation, finds: Finds) -> Parts | None:
    """The context of the inverse of a variable at whose far end both sides come together."""
    name, claim = f"{context.name}.inverse", row.claim
    taken = {c.name for c in statement.contexts}
    if not isinstance(claim, Claim) or claim.relation == "=" or name in taken:
        return None
    from verify.prover.inverses import inverted  # loaded only where it is used

    new = {v.name: symbol(f"{name}.{v.name}") for v in context.variables}
    for x, sign in _far(context, claim):
        rests = [g.claim for g in context.givens if x not in names_of(*g.claim.key[1:])]
        ends = [g.claim for g in context.givens if g.claim not in rests]
        found = inverted(claim, symbol(x), new[x], sign)
        if found is None or not all(_is_end(end, x, sign) for end in ends):
            continue
        claims = [Claim("<", ZERO, new[x])]
        for relation, lhs, rhs in (end.key for end in ends):
            end = abs((lhs if sign > 0 else rhs).value)
            claims += [Claim(relation, new[x], as_term(1 / end))] if end else []
        claims += [substitute_claim(rest, new) for rest in rests]
        givens = tuple(Given(f"{name}.{i}", one) for i, one in enumerate(claims))
        variables = tuple(v._replace(name=f"{name}.{v.name}") for v in context.variables)
        point = finds([v.name for v in variables], givens)
        if point is None:
            continue
        says = f"{row.says or row.name}, for the inverse of {x}"
        asked = Obligation(
            f"{row.name}.inverse",
            "",
            "",
            NEEDED,
            says,
            substitute_claim(found[0], new),
            context=name,
        )
        return Parts((Context(name, variables, givens, point, context.parent),), (asked,))
    return None


def _is_end(claim: Claim, x: str, sign: int) -> bool:
    """Whether the claim says that a variable is beyond a number, seen from 0."""
    near, far = (claim.lhs, claim.rhs) if sign > 0 else (claim.rhs, claim.lhs)
    good = claim.relation in ("<", "<=") and far == symbol(x) and near.op == "rational"
    return good and (sign * near.value > 0 or (near.value == 0 and claim.relation == "<"))


def _far(context: Context, claim: Claim) -> Iterator[tuple[str, int]]:
    """Variables without an end, and the way there, on which both sides come together."""
    names = sorted({*names_of(claim.lhs, claim.rhs)})
    bounds = bounds_of(context)
    if not any(part.op in FUNCTIONS for part in parts_of(claim.lhs, claim.rhs)):
        return
    if not all(name in bounds for name in names):
        return
    values = estimates(names, [claim.lhs, claim.rhs], {})
    places = [next(_between(bounds[name])) for name in names]
    for i, name in enumerate(names):
        for sign, end in ((1, bounds[name].high), (-1, bounds[name].low)):
            gaps = []
            for x in FAR if end is None else ():
                try:
                    low, high = values(*places[:i], sign * x, *places[i + 1 :])
                    gaps.append(abs(high - low) / (abs(low) + abs(high) + 1e-300))
                except (ArithmeticError, ValueError, TypeError):
                    break
            if len(gaps) == len(FAR) and gaps[-1] < min(0.1, gaps[0] / 4):
                yield name, sign


# --- where to take a context apart ---------------------------------------------------------------


def _orders(context: Context, row: Obligation) -> Iterator[Order]:
    """Terms to compare: those that differ, entries of extrema, and where both sides meet."""
    claim = row.claim
    if not isinstance(claim, Claim):
        return
    for given in context.givens:
        square = given.claim.rhs
        if given.claim.key[:2] == ("<", ZERO) and square.op == "pow" and square.exponent == 2:
            yield _compared(square.children[0], is_strict=True)
    found: dict[Order, int] = {}
    for part in parts_of(claim.lhs, claim.rhs):
        if part.op in ("min", "max") and len(part.children) == 2:
            a, b = part.children
            order = _compared(a) if b == -a else _compared(a - b)
            found[order] = sum(1 for _ in parts_of(order.lhs, order.rhs))
    yield from sorted(found, key=found.__getitem__)
    yield from _meetings(context, claim)


def _compared(term: Term, *, is_strict: bool = False) -> Order:
    """The two sides of a difference, or a term and 0."""
    if term.op == "sub":
        return Order(term.children[0], term.children[1], is_strict)
    return Order(term, ZERO, is_strict)


def _is_news(context: Context, order: Order) -> bool:
    """Whether the order is not given."""
    given = {one.claim.key[1:] for one in context.givens}
    return bool(names_in(order)) and not given & {(order.lhs, order.rhs), (order.rhs, order.lhs)}


def names_in(order: Order) -> set[str]:
    """The names in both terms."""
    return {*names_of(order.lhs, order.rhs)}


def _meetings(context: Context, claim: Claim) -> Iterator[Order]:
    """Two variables, or the variable and numbers, at which both sides of a claim nearly meet."""
    names = sorted({*names_of(claim.lhs, claim.rhs)})
    bounds = bounds_of(context)
    if claim.relation == "=" or not all(name in bounds for name in names):
        return
    if len(names) == 1:
        yield from (Order(symbol(names[0]), n) for n in _numbers(bounds[names[0]], claim, names))
    elif len(names) in (2, 3):
        for pair in combinations(names, 2):
            if _meets_where_equal(bounds, claim, [*pair, *(n for n in names if n not in pair)]):
                yield Order(symbol(pair[0]), symbol(pair[1]))


def _numbers(bounds: Bounds, claim: Claim, names: Sequence[str]) -> Iterator[Term]:
    """The irrational numbers, of simple form or stationary, at which both sides nearly meet."""
    values = estimates(names, [claim.lhs, claim.rhs], {})

    def gap(x: float) -> float:
        try:
            low, high = values(x)
            return (high - low) / (abs(low) + abs(high) + 1e-300)
        except (ArithmeticError, ValueError, TypeError):
            return math.inf

    points = [*_between(bounds)]
    gaps = [gap(x) for x in points]
    for i in range(1, len(points) - 1):
        if gaps[i] <= min(gaps[i - 1], gaps[i + 1]) and math.isfinite(gaps[i]):
            x = _least(gap, points[i - 1], points[i + 1])
            if abs(gap(x)) < NEAR and abs(x - _simple(x)) >= 1e-7:
                number = _number(x)
                if number is None:
                    from verify.prover.stationary import stationary  # loaded only where it is used

                    number = stationary(claim, names[0], x)
                if number is not None:
                    yield number


def _meets_where_equal(bounds: Mapping[str, Bounds], claim: Claim, names: Sequence[str]) -> bool:
    """Whether both sides seem to be equal wherever the first two variables are."""
    values, found = estimates(names, [claim.lhs, claim.rhs], {}), 0
    rest = [[*_between(bounds[name])] for name in names[2:]]
    for i, x in enumerate(_between(bounds[names[0]])):
        try:
            low, high = values(x, x, *(points[i * 7 % len(points)] for points in rest))
        except (ArithmeticError, ValueError, TypeError):
            continue
        if abs(high - low) > NEAR * (abs(low) + abs(high) + NEAR):
            return False
        found += 1
    return found > 1


def _between(bounds: Bounds) -> Iterator[float]:
    """Points of a range, in order."""
    low, high = (None if end is None else float(end) for end in (bounds.low, bounds.high))
    if low is not None and high is not None:
        yield from (low + (high - low) * k / POINTS for k in range(1, POINTS))
    elif low is not None:
        yield from (low + 1.5**k for k in range(-POINTS // 2, POINTS // 2))
    elif high is not None:
        yield from (high - 1.5**-k for k in range(-POINTS // 2, POINTS // 2))
    else:
        yield from (k / 4 for k in range(-POINTS, POINTS))


def _least(gap: Callable[[float], float], low: float, high: float) -> float:
    """About where a function is least between two numbers."""
    for _ in range(80):
        a, b = low + (high - low) * 0.382, low + (high - low) * 0.618
        low, high = (low, b) if gap(a) < gap(b) else (a, high)
    return (low + high) / 2


def _number(x: float) -> Term | None:
    """The irrational number of simple form that is near by; None if there is none."""
    if x > 0 and abs(math.log(x) - (q := _simple(math.log(x)))) < 1e-5:
        return exp(1) ** q.numerator if q.denominator == 1 < q else exp(as_term(q))
    if abs(x / math.pi - (q := _simple(x / math.pi))) < 1e-5:
        return as_term(q) * pi
    if abs(x * x - (q := _simple(x * x))) < 1e-5:
        return sqrt(q) if x > 0 else -sqrt(q)
    return None


def _simple(x: float) -> Fraction:
    return Fraction(x).limit_denominator(12)
