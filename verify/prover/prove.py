"""Any statement, decided: its contexts opened, its constants defined, its rows one by one."""

from __future__ import annotations

import re
from collections.abc import Callable, Container, Iterable, Mapping, Sequence
from functools import partial
from time import monotonic
from types import MappingProxyType

from verify.language.statement import (
    PROVED,
    UNDECIDED,
    Applies,
    Constant,
    Context,
    Given,
    Obligation,
    Statement,
)
from verify.language.terms import Claim, Term, equal, names_of, substitute, substitute_claim, symbol
from verify.prover.budget import SpentError, WorkBudget
from verify.prover.constants import DEFAULT_MAX_PRECISION, DEFAULT_PRECISION
from verify.prover.goal import Goal
from verify.prover.ground import Ground
from verify.prover.hint import Hint
from verify.prover.lengths import MAX_BITS
from verify.prover.outcome import Decision, Enclosure, Outcome
from verify.prover.proof import Proof, Step
from verify.prover.session import Session
from verify.prover.universal import Universal

NOTHING_FOUND = "neither a proof nor an example against it was found"

TRY = "name the facts from which it follows, as by = ..., or write a lemma before it"
TOO_LONG = f"a number in it has more than {MAX_BITS} bits, which the checker does not read"

#: So often another proof is looked for where the checker cannot afford one.
MAX_REFUSED = 3
NO_HINTS: Mapping[str, Hint] = MappingProxyType({})

#: Why steps that show a row (none: what all rows rest on) are too much for the checker; or nothing.
Price = Callable[[Obligation | None, str, Sequence[Step]], str]
#: Opens a context; False if that is not found.
Opens = Callable[[Universal, Context], bool]


def prove(
    statement: Statement,
    start_bits: int = DEFAULT_PRECISION,
    max_bits: int = DEFAULT_MAX_PRECISION,
    budget: WorkBudget | None = None,
    price: Price = lambda _row, _claimed, _steps: "",
    hints: Mapping[str, Hint] = NO_HINTS,
    cited: Iterable[tuple[str, Statement]] = (),
) -> Outcome:
    """Decide every row of a statement; what is not found is left undecided, with the reason.

    Args:
        statement: what is claimed.
        start_bits: the first precision for claims without variables.
        max_bits: the last one.
        budget: how much work each row may be.
        price: asked before anything is claimed of a row.
        hints: where to look for the proofs of some rows, by their names.
        cited: statements with their proved rows, and what their names begin with here.
    """
    ground = Ground(Session(unused_prefix(statement)), start_bits, max_bits)
    universal = Universal(ground, budget or WorkBudget(), _find)
    for prefix, other in cited:
        make_known(prefix, other, universal)
    missing = constants_defined(statement, universal)
    for context in statement.contexts:
        opened(context, universal, missing)
    spent = price(None, "", ground.session.steps)
    rows = statement.obligations
    decisions = {}
    for left, row in zip(range(len(rows), 0, -1), rows, strict=True):
        universal.budget.begin(row.name, left)
        hint = hints.get(row.name, Hint())
        reason = spent or next((missing[name] for name in names_about(row) if name in missing), "")
        decisions[row.name] = (
            Decision(UNDECIDED, reason=reason)
            if reason
            else decide_row(row, universal, price, hint)
        )
    enclosures = {} if spent else enclosures_of(statement, ground, missing)
    spent = spent or next(iter(missing.values()), "")
    return Outcome(statement, decisions, tuple(ground.session.steps), enclosures, spent)


def unused_prefix(statement: Statement, others: Iterable[str] = ()) -> str:
    """What begins the names of lemmas, and no name of the statement, nor one of the others."""
    prefix = "l"
    names = [*others, *(row.name for row in statement.obligations)]
    names += [given.name for context in statement.contexts for given in context.givens]
    while any(re.fullmatch(rf"{prefix}\.[0-9]+", name) for name in names):
        prefix += "l"
    return prefix


def constants_defined(statement: Statement, universal: Universal) -> dict[str, str]:
    """Define all constants without variables; the names of those that could not be, and why."""
    missing = dict[str, str]()
    parameters = [Constant(n, n, n, "", term) for n, term in statement.parameters.items()]
    for constant in (*parameters, *statement.constants):
        names = (*names_of(constant.term),)
        failed = partial(_undefined, constant, universal)
        note(missing, constant.name, names, failed, universal.budget)
    return missing


def opened(
    context: Context, universal: Universal, missing: dict[str, str], opens: Opens = Universal.open
) -> None:
    """Open a context, or note why that could not be."""
    universal.budget.refill()
    names = (context.parent or "", *names_of(*_terms(context)))
    failed = partial(_unopened, context, universal, opens)
    note(missing, context.name, names, failed, universal.budget)
    if context.name in missing:
        missing |= {one.name: missing[context.name] for one in context.constants}


def note(
    missing: dict[str, str],
    name: str,
    names: Iterable[str],
    failed: Callable[[], str],
    budget: WorkBudget,
) -> None:
    """Afterwards it is known why something is missing, if it is, or what it rests on."""
    reason = next((missing[other] for other in names if other in missing), "")
    try:
        with budget.alarm():
            reason = reason or failed()
    except (ArithmeticError, RecursionError) as error:
        reason = f"{name} was not decided: {_why(error)}"
    if reason:
        missing[name] = reason


def _undefined(constant: Constant, universal: Universal) -> str:
    """Why a constant without variables could not be defined, or nothing."""
    ground = universal.ground
    if universal.lengths.is_too_long((constant.term,), ground.definitions):
        return f"{constant.name}: {TOO_LONG}"
    return (
        "" if ground.define(constant) else f"{constant.name} {ground.why_no_value(constant.term)}"
    )


def _unopened(context: Context, universal: Universal, opens: Opens) -> str:
    """Why a context could not be opened, or nothing."""
    if universal.lengths.is_too_long(_terms(context), universal.ground.definitions):
        return f"the context {context.name}: {TOO_LONG}"
    undo, is_open = universal.mark(), False
    universal.failed = universal.undefined = None
    try:
        is_open = opens(universal, context)
    finally:
        entered, made = context.name in universal.contexts, {*universal.session.definitions}
        if not is_open:
            undo()
            universal.contexts.pop(context.name, None)
    if is_open:
        return ""
    if entered:
        valueless = next(one.name for one in context.constants if one.name not in made)
        return f"{valueless} was not seen to have a value"
    reason = f"the context {context.name} was not seen to have a point"
    failed, undefined = universal.failed, universal.undefined
    if undefined is not None:
        return f"{reason}: its given {undefined.name} was not seen to be defined by the others"
    return reason if failed is None else f"{reason}: its given {failed.name} was not shown there"


def _terms(context: Context) -> tuple[Term, ...]:
    """The terms of its givens, of its point, and of its constants."""
    sides = (side for given in context.givens for side in given.claim.key[1:])
    return (*sides, *context.point.values(), *(one.term for one in context.constants))


def names_about(row: Obligation) -> set[str]:
    """The contexts and the names that a row is about."""
    claim = row.claim
    if isinstance(claim, Claim):
        found = {*names_of(claim.lhs, claim.rhs)}
    elif isinstance(claim, Applies):
        found = {claim.context, *names_of(*claim.at.values())}
    else:
        found = {claim.context, *names_of(*claim.start.values(), *claim.next.values())}
    return found | ({row.context} if row.context else set())


def decide_row(row: Obligation, universal: Universal, price: Price, hint: Hint) -> Decision:
    """The decision on a row that may use what its hint says."""
    if hint == Hint() or not isinstance(row.claim, Claim):
        return _priced(row, universal, price)
    follows = _following(row, row.claim, hint, universal, price) if hint.follows else None
    if follows is not None:
        return follows
    universal.hints = {row.claim: hint}
    try:
        for hidden in _hidden(row, hint, universal):
            universal.hidden, universal.is_restricted = hidden, hint.using is not None
            found = _priced(row, universal, price)
            if found.claimed != UNDECIDED:
                break
    finally:
        universal.hidden, universal.is_restricted, universal.hints = frozenset(), False, {}
    return found


def _following(
    row: Obligation, claim: Claim, hint: Hint, universal: Universal, price: Price
) -> Decision | None:
    """The decision that a row follows from the facts that are named, if a sum of them is found."""
    from verify.prover.search.named import Named, by_names  # loaded only where they are used

    session, place = universal.session, row.context
    claims = {name: session.claims[name] for name in hint.using or () if name in session.claims}
    universal.budget.refill()
    undo, first = universal.mark(), len(session.steps)
    try:
        if not universal.clears((claim.lhs, claim.rhs), place):
            return None
        known = Named(claims, (), lambda term: universal.is_negative(term, place))
        proof = by_names(claim, known, universal.budget)
    except ArithmeticError:  # the work is spent, or terms are too long
        proof = None
    if proof is not None:
        session.prove_row(row, proof)
        universal.rows.add(row.name)
        if not price(row, PROVED, session.steps[first:]):
            return Decision(PROVED, proof)
    undo()
    return None


def _hidden(row: Obligation, hint: Hint, universal: Universal) -> list[frozenset[str]]:
    """What is not used: givens and rows that a hint does not name; then only such rows."""
    if hint.using is None:
        return [frozenset()]
    rows = frozenset(universal.rows).difference(hint.using)
    goal = universal.goal(row.claim, row.context) if isinstance(row.claim, Claim) else None
    from verify.prover.search.relevance import facts_around  # loaded only where it is used

    facts = () if goal is None else facts_around(goal, universal)
    others = rows.union(facts).difference(hint.using)
    return [others] if hint.follows else [*dict.fromkeys((others, rows))]


def _priced(row: Obligation, universal: Universal, price: Price) -> Decision:
    """The decision on a row, if the checker can afford to read its proof; else another proof."""
    universal.refused.clear()
    universal.budget.refill()
    found = _tried(row, universal, price)
    for _ in range(MAX_REFUSED):
        if found.claimed != UNDECIDED or not universal.refused:
            break
        other = _tried(row, universal, price)
        found = other if other.claimed != UNDECIDED else found
    universal.refused.clear()
    return found


def _tried(row: Obligation, universal: Universal, price: Price) -> Decision:
    """The same for the first proof that is found."""
    undo, first = universal.mark(), len(universal.session.steps)
    for table in (universal.reasons, universal.tried, universal.left, universal.valueless):
        table.clear()
    try:
        with universal.budget.alarm():
            found = _decide(row, universal.ground, universal)
    except Exception as error:
        found = Decision(UNDECIDED, reason=_why(error))
    except KeyboardInterrupt:
        if not universal.budget.catches:
            raise
        universal.budget.interrupted = True
        found = Decision(UNDECIDED, reason="the search was interrupted")
    if found.claimed == UNDECIDED:
        undo()
        return found._replace(reason=_reason(found, row, universal))
    begin = monotonic()
    reason = price(row, found.claimed, universal.session.steps[first:])
    universal.budget.set_aside(monotonic() - begin)
    if reason:
        undo()
        universal.refused.add(universal.found_by)
        return Decision(UNDECIDED, reason=reason)
    return found


def _reason(found: Decision, row: Obligation, universal: Universal) -> str:
    """Why a row is undecided: what was tried, and where it is open."""
    from verify.prover.reasons import hardest, without_value  # loaded only where they are used

    in_context = isinstance(row.claim, Claim) and row.context in universal.contexts
    if isinstance(row.claim, Claim) and in_context and not universal.budget.is_over:
        spent = universal.budget.spent
        universal.reasons |= dict.fromkeys(without_value(row.claim, universal.valueless))
        universal.budget.refill()
        try:
            where = hardest(universal.goal(row.claim, row.context), universal, spent)
        except (ArithmeticError, ValueError, RecursionError):
            where = ()
    else:
        where = ()
    what_to_try = (TRY,) if in_context and not universal.is_restricted else ()
    return "; ".join((found.reason or NOTHING_FOUND, *universal.reasons, *where, *what_to_try))


def _why(error: Exception) -> str:
    """In words why a search ended."""
    if isinstance(error, SpentError):
        return str(error)
    if isinstance(error, RecursionError):
        return "its terms are too deep"
    return f"the search failed: {type(error).__name__}: {error!s:.200}"


def _find(goal: Goal, known: Universal) -> Proof | None:
    from verify.prover.techniques import find  # loaded only where it is used

    return find(goal, known)


def _decide(row: Obligation, ground: Ground, universal: Universal) -> Decision:
    universal.budget.spend(0)  # no row is begun when the time is over
    if isinstance(row.claim, Claim):
        sides = (row.claim.lhs, row.claim.rhs)
        if universal.lengths.is_too_long(sides, universal.every_definition):
            return Decision(UNDECIDED, reason=TOO_LONG)
        names = names_of(row.claim.lhs, row.claim.rhs)
        if all(name in ground.definitions for name in names):
            found = ground.decide(row)
            if found.claimed != UNDECIDED:
                if found.claimed == PROVED:
                    universal.rows.add(row.name)
                return found
    from verify.prover.rows_in_contexts import RowsInContexts  # loaded only where it is used

    return RowsInContexts(universal).decide(row)


def enclosures_of(
    statement: Statement, ground: Ground, missing: Container[str]
) -> dict[str, Enclosure]:
    """The enclosures of parameters and constants that are not missing."""
    names = (*statement.parameters, *(constant.name for constant in statement.constants))
    known = [name for name in names if name not in missing]
    found = {name: ground.enclose(ground.definitions[name]) for name in known}
    return {name: enclosure for name, enclosure in found.items() if enclosure is not None}


# --- what is cited -------------------------------------------------------------------------------


def make_known(prefix: str, statement: Statement, universal: Universal) -> None:
    """Afterwards what a cited statement proves of numbers is known, with a prefix to each name."""
    session = universal.session
    constants = {one.name: one.term for one in statement.constants}
    full = {name: symbol(prefix + name) for name in (*statement.parameters, *constants)}
    for name, term in {**statement.parameters, **constants}.items():
        definition = substitute(term, full)
        session.definitions[prefix + name] = definition
        universal.ground.know(prefix + name, definition)
        session.install(prefix + name, equal(full[name], definition), None)
    for context in statement.contexts:
        if context.parent is None:
            universal.contexts[prefix + context.name] = context._replace(
                givens=tuple(_renamed(given, full) for given in context.givens),
                constants=tuple(
                    one._replace(term=substitute(one.term, full)) for one in context.constants
                ),
            )
            session.parents[prefix + context.name] = None
    for row in statement.obligations:
        if row.context is None and isinstance(row.claim, Claim):
            session.install(prefix + row.name, substitute_claim(row.claim, full), None)
            universal.rows.add(prefix + row.name)


def _renamed(given: Given, names: dict[str, Term]) -> Given:
    return given._replace(claim=substitute_claim(given.claim, names))
