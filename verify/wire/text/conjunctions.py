"""The question whether formulas have a solution, as rows of a statement.

A formula is written as cases, each a conjunction of claims. The row of a case says that it has no
solution: for all values that satisfy most of its claims, what is left of them is false. Which are
left does not matter for what the row says, but for how hard its proof is; so there are several
*forms* of it. Neither cases nor forms depend on the order of the formulas.
"""

from __future__ import annotations

from collections import Counter
from collections.abc import Callable, Iterator, Mapping, Sequence
from functools import partial
from hashlib import sha256

from verify.language.fold import fold
from verify.language.record import Record
from verify.language.statement import NEEDED, Constant, Context, Given, Obligation, Variable
from verify.language.terms import (
    INDEXED,
    LEAVES,
    OPERATIONS,
    Claim,
    Term,
    as_term,
    maximum,
    parts_of,
    symbol,
    unequal,
)
from verify.wire.text import OTHERS, Form
from verify.wire.text.formulas import BOOL, MAX_CASES, Formula
from verify.wire.text.points import Points

#: So many branches are looked at, contradictions among them.
MAX_BRANCHES = 1000
#: And so many alternatives in all of them, those of each branch anew.
MAX_LOOKED_AT = 500_000
#: So many claims are left out of the givens, one after another, until a point of the others is
#: found; fewer where there are many variables and claims.
MAX_LEFT, MAX_SEARCHED = 16, 2000
#: In terms with more signs than this, each part written out where it stands, parts that stand there
#: several times get names.
LARGE = 5000
#: Parts with fewer signs get no name.
SMALL = 3

Part = tuple[Formula, bool]


class TooManyCasesError(ValueError):
    """A formula has more cases than are read."""


# --- an order that does not depend on the file ---------------------------------------------------


def _digest(op: str, *parts: object) -> bytes:
    texts = (part if isinstance(part, bytes) else str(part).encode() for part in parts)
    return sha256(b" ".join((op.encode(), *texts))).digest()


def _size(op: str) -> Callable[..., int]:
    if op in LEAVES:
        return lambda *_: 1
    return (lambda base, _: 1 + base) if op in INDEXED else lambda *parts: 1 + sum(parts)


_DIGESTS: Mapping[str, Callable[..., bytes]] = {op: partial(_digest, op) for op in OPERATIONS}
_SIZES: Mapping[str, Callable[..., int]] = {op: _size(op) for op in OPERATIONS}
#: What may have no value.
_PARTIAL = ("div", "sqrt", "root", "log")


class Order:
    """Sorts claims and formulas by what they say."""

    def __init__(self) -> None:
        self._terms: dict[Term, bytes] = {}
        self._sizes: dict[Term, int] = {}
        self._claims: dict[Claim, tuple[bool, int, bytes]] = {}
        self._formulas: dict[Formula, bytes] = {}

    def size(self, claim: Claim) -> int:
        """The number of signs of a claim, with each part written out where it stands."""
        return sum(fold(side, _SIZES, self._sizes) for side in (claim.lhs, claim.rhs))

    def of_claim(self, claim: Claim) -> tuple[bool, int, bytes]:
        """A key by which claims whose terms may have no value come last, and small ones first."""
        if claim in self._claims:
            return self._claims[claim]
        sides = claim.lhs, claim.rhs
        may_have_none = any(part.op in _PARTIAL for part in parts_of(*sides))
        text = _digest(claim.relation, *(fold(side, _DIGESTS, self._terms) for side in sides))
        found = self._claims[claim] = (may_have_none, self.size(claim), text)
        return found

    def of_formula(self, formula: Formula) -> bytes:
        """A key of a formula, which does not depend on the order of what it joins."""
        waiting = [formula]
        while waiting:
            one = waiting[-1]
            rest = [part for part in one.parts if part not in self._formulas]
            waiting += rest
            if not rest:
                waiting.pop()
                claim = () if one.claim is None else (self.of_claim(one.claim)[-1],)
                parts = [self._formulas[part] for part in one.parts]
                in_order = parts if one.op == "choice" else sorted(parts)
                self._formulas[one] = _digest(one.op, *in_order, *claim)
        return self._formulas[formula]


# --- cases ---------------------------------------------------------------------------------------


class _Branch:
    """Formulas that hold or do not, and alternatives that are not decided yet."""

    def __init__(self, parts: Sequence[Part]) -> None:
        self.waiting = [*parts]
        self.known: set[Part] = set()
        self.claims: dict[Claim, None] = {}
        self.open: list[list[tuple[Part, ...]]] = []

    def with_parts(self, parts: Sequence[Part]) -> _Branch:
        """The same, where more holds."""
        found = _Branch(parts)
        found.known, found.claims, found.open = {*self.known}, {**self.claims}, [*self.open]
        return found

    def is_contradictory(self) -> bool:
        """Afterwards what waits is in the lists; or it contradicts what is known."""
        while self.waiting:
            part = formula, holds = self.waiting.pop()
            if part in self.known:
                continue
            if _opposite(part) in self.known:
                return True
            self.known.add(part)
            if holds and formula.claim is not None:
                excluded = _excluded(formula.claim)
                if any((other, True) in self.known for other in excluded):
                    return True
                self.known |= {(other, False) for other in excluded}
            self._enter(formula, holds)
        return False

    def _enter(self, formula: Formula, holds: bool) -> None:
        parts, claim = formula.parts, formula.claim
        if formula.op.startswith(BOOL):  # a constant, which is true in this branch, or false
            return
        if claim is not None:
            if holds:
                self.claims[claim] = None
            elif claim.relation == "=":
                self.open.append([((other, True),) for other in _excluded(claim)])
            else:
                self.waiting += [(other, True) for other in _excluded(claim)]
        elif formula.op == "not":
            self.waiting.append((parts[0], not holds))
        elif formula.op == "choice":
            pairs = zip(parts[::2], parts[1::2], strict=True)
            self.open.append([((when, True), (what, holds)) for when, what in pairs])
        elif holds:
            self.waiting += [(part, True) for part in parts]
        else:
            self.open.append([((part, False),) for part in parts])

    def alternatives(self) -> list[tuple[Part, ...]] | None:
        """What is decided next: alternatives of which one has to hold; None if none are left."""
        kept = []
        for choices in self.open:
            if not any(self.known.issuperset(parts) for parts in choices):
                possible = [p for p in choices if self.known.isdisjoint(map(_opposite, p))]
                kept.append(possible)
        self.open = kept
        if not kept:
            return None
        least = min(kept, key=len)
        self.open.remove(least)
        return least


def _opposite(part: Part) -> Part:
    return part[0], not part[1]


def _excluded(claim: Claim) -> tuple[Formula, ...]:
    """The claims that cannot hold beside a claim; if it does not hold, one of them does."""
    if claim.relation == "=":
        others = [Claim("<", claim.lhs, claim.rhs), Claim("<", claim.rhs, claim.lhs)]
    else:
        others = [Claim("<=" if claim.relation == "<" else "<", claim.rhs, claim.lhs)]
    return tuple(Formula("claim", (), other) for other in others)


def cases(formulas: Sequence[Formula], order: Order) -> list[list[Claim]]:
    """Conjunctions of claims of which one holds just where all formulas do.

    None of them has all the claims of another one.

    Raises:
        TooManyCasesError: if there are too many.
    """
    first = sorted(dict.fromkeys(formulas), key=order.of_formula)
    branches, found = [_Branch([(formula, True) for formula in first])], []
    looked_at = 0
    for _ in range(MAX_BRANCHES):
        if not branches or looked_at > MAX_LOOKED_AT:
            break
        branch = branches.pop()
        if branch.is_contradictory():
            continue
        looked_at += len(branch.open)
        alternatives = branch.alternatives()
        if alternatives is None:
            found.append(frozenset(branch.claims))
        branches += [branch.with_parts(parts) for parts in alternatives or ()]
    least = [case for case in dict.fromkeys(found) if not any(one < case for one in found)]
    if branches or len(least) > MAX_CASES:
        raise TooManyCasesError
    listed = [sorted(case, key=order.of_claim) for case in least]
    return sorted(listed, key=lambda case: [*map(order.of_claim, case)])


# --- rows ----------------------------------------------------------------------------------------


class Asked(Record):
    """A case: its names, the variables in it with how they are shown, and where it stands."""

    context: str
    row: str
    says: str
    variables: tuple[Variable, ...]


def forms(asked: Asked, claims: Sequence[Claim], order: Order, points: Points) -> Iterator[Form]:
    """Rows that say that claims have no solution, those that are tried first at the beginning."""
    names = [variable.name for variable in asked.variables]
    if not names and len(claims) < 2:
        claim = denied(claims) if claims else as_term(0) < 0
        yield None, _row(asked, claim, None)
        return
    if is_large([side for claim in claims for side in (claim.lhs, claim.rhs)]):
        yield _last_form(asked, claims, order, points)
        return
    solution = points.find(names, [Given("", claim) for claim in claims], {})
    count, tries = 0, max(1, min(MAX_LEFT, MAX_SEARCHED // (len(names) * len(claims) or 1)))
    for left in sorted(claims, key=lambda claim: _rank(claim, order), reverse=True)[:tries]:
        others = [given for claim in claims if claim is not left for given in _parts(claim)]
        point = solution or points.find(names, [Given("", claim) for claim in others], {})
        if point is not None:
            yield _form(asked, others, denied([left]), point)
            count += 1
        if count > OTHERS:
            return
    if not count:
        yield _last_form(asked, claims, order, points)


def _last_form(asked: Asked, claims: Sequence[Claim], order: Order, points: Points) -> Form:
    """A form with bounds as givens, or with none that could fail, and all else denied together.

    If some of what is denied is strict and some is not, a variable of its own is below the gaps of
    the strict claims, so that none is strict.
    """
    names = [variable.name for variable in asked.variables]
    givens = [claim for claim in claims if _rank(claim, order)[0] == 0]
    point = points.find(names, [Given("", claim) for claim in givens], {})
    if point is None or len(givens) == len(claims):
        givens, point = [], {name: as_term(1) for name in names}
    left = [claim for claim in claims if claim not in givens]
    if len({claim.relation == "<" for claim in left}) > 1:
        more = Variable(f"{asked.context}.less-", "less", "less")
        less = symbol(more.name)
        asked = asked._replace(variables=(*asked.variables, more))
        givens.append(as_term(0) < less)
        left = [less <= c.rhs - c.lhs if c.relation == "<" else c for c in left]
        point = {**point, more.name: as_term(1)}
    relation, lhs, rhs = denied(left).key
    sides, constants = named(f"{asked.context}.part-", [lhs, rhs])
    context, row = _form(asked, givens, Claim(relation, *sides), point)
    return context._replace(constants=constants), row


def _form(
    asked: Asked, givens: Sequence[Claim], claim: Claim, point: Mapping[str, Term]
) -> tuple[Context, Obligation]:
    named = [Given(f"{asked.context}.{i}", given) for i, given in enumerate(givens, 1)]
    context = Context(asked.context, asked.variables, tuple(named), point)
    return context, _row(asked, claim, asked.context)


def _row(asked: Asked, claim: Claim, context: str | None) -> Obligation:
    return Obligation(asked.row, "", "", NEEDED, asked.says, claim, context=context)


def _rank(claim: Claim, order: Order) -> tuple[int, tuple[bool, int, bytes]]:
    """Inequalities are left before equations, bounds of a variable last, and large ones first."""
    sides = {claim.lhs.op, claim.rhs.op}
    is_bound = "symbol" in sides and not {*sides} - {"symbol", "rational"}
    return 0 if is_bound else 1 if claim.relation == "=" else 2, order.of_claim(claim)


def _parts(claim: Claim) -> list[Claim]:
    """A claim as a given: one for each entry of a maximum that is below a bound."""
    relation, lhs, rhs = claim.key
    if relation != "=" and lhs.op == "max":
        low = as_term(-rhs.value) if rhs.op == "rational" else -rhs
        return [
            part
            for entry in reversed(lhs.children)
            for part in _parts(
                Claim(relation, low, entry.children[0])
                if entry.op == "neg"
                else Claim(relation, entry, rhs)
            )
        ]
    if relation != "=" and rhs.op == "min":
        return [part for entry in rhs.children for part in _parts(Claim(relation, lhs, entry))]
    return [claim]


def named(prefix: str, terms: Sequence[Term]) -> tuple[Sequence[Term], tuple[Constant, ...]]:
    """Terms, if they are large with names for parts that stand there several times; and the names.

    Each name is defined over those before it. Written out, they and the terms have about as many
    signs as the terms have different parts.
    """
    if not is_large(terms):
        return terms, ()
    used = Counter(child for part in parts_of(*terms) for child in part.children)
    short: dict[Term, Term] = {}
    constants: list[Constant] = []

    def shorter(term: Term) -> Term:
        if term not in short:
            children = term.children
            found = term
            if children:
                args = [shorter(child) for child in children]
                found = Term(term.op, *args, *term.args[len(children) :])
            if used[term] > 1 and fold(found, _SIZES, {}) >= SMALL:
                name = f"{prefix}{len(constants) + 1}"
                constants.append(Constant(name, name, name, "", found))
                found = symbol(name)
            short[term] = found
        return short[term]

    return [*map(shorter, terms)], tuple(constants)


def is_large(terms: Sequence[Term]) -> bool:
    """Whether terms have many signs, with each part written out where it stands."""
    known: dict[Term, int] = {}
    return sum(fold(term, _SIZES, known) for term in terms) > LARGE


def denied(claims: Sequence[Claim]) -> Claim:
    """The claim that not all of these hold; either all of them are strict, or none is."""
    if len(claims) == 1:
        relation, lhs, rhs = claims[0].key
        if relation == "=":
            return unequal(lhs, rhs)
        return Claim("<=" if relation == "<" else "<", rhs, lhs)
    gaps = [(c.lhs - c.rhs) ** 2 if c.relation == "=" else c.lhs - c.rhs for c in claims]
    return Claim("<=" if claims[0].relation == "<" else "<", as_term(0), maximum(*gaps))
