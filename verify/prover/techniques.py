"""The techniques, in the order in which they are tried on a goal, and the loop that calls them."""

from __future__ import annotations

from collections.abc import Callable, Iterator
from functools import partial
from importlib import import_module
from typing import Any

from verify.language.record import Record
from verify.language.terms import parts_of
from verify.prover.clearing import TooLongError
from verify.prover.goal import Goal
from verify.prover.hint import Hint
from verify.prover.proof import Proof
from verify.prover.search.question import Question
from verify.prover.search.relevance import rounds
from verify.prover.universal import Universal

#: With more variables than these a goal is not tried again with those that givens link to its own.
MAX_LINKED = 5
FEW_PARTS, MANY_PARTS = 100, 2000


class Technique(Record):
    """What finds a proof of a claim, or none; the lemmas that the proof needs are written down."""

    name: str
    prove: Callable[[Question], Proof | None]


def _from(module: str, function: str, **settings: Any) -> Callable[[Question], Proof | None]:
    """A function of a module in `search`, which is loaded when it is called first."""

    def prove(question: Question) -> Proof | None:
        found = import_module(f"verify.prover.search.{module}")
        proof: Proof | None = getattr(found, function)(question, **settings)
        return proof

    return prove


COSINES = _from("cosine_parts", "by_cosines")


def _cosines(question: Question, *, near: bool) -> Proof | None:
    return COSINES(question) if question.is_near == near else None


#: For what needs no facts on divisors and radicands.
FREE = (
    Technique("identity", _from("direct", "by_identity")),
    Technique("interval", _from("enclosures", "by_interval")),
)
PARTS = Technique("parts of a context", _from("parts", "by_parts"))
INVERSES = Technique("inverses of variables", _from("inverses", "by_inverses"))
EQUALITY = Technique("equality", _from("equality", "by_equality"))
LAWS = Technique("laws", _from("laws", "by_laws"))
ELEMENTARY = Technique("elementary", _from("elementary", "by_elementary"))
#: For equations.
EQUATIONS = (
    Technique("cosines", COSINES),
    Technique("multiple angles", _from("multiple_angles", "by_multiple_angles")),
    ELEMENTARY,
    Technique("both orders", _from("direct", "by_orders")),
)
#: For what the form of a claim shows, or simple searches.
SIMPLE = (
    Technique("root", _from("direct", "by_root")),
    Technique("range", _from("direct", "by_range")),
    Technique("monotony", _from("rising", "by_monotony")),
    Technique("equal arguments", _from("rising", "by_same_arguments")),
    Technique("extremum", _from("direct", "by_extremum")),
    Technique("signs", _from("signs", "by_signs")),
    Technique("coefficients", _from("bernstein_boxes", "by_coefficients")),
    Technique("cuts", _from("enclosures", "by_cuts")),
    Technique("completed squares", _from("quadratic", "by_completing_squares")),
)
#: For what follows from all that is linked to a claim, by sums.
SUMS = (Technique("linear sums", _from("linear", "by_linear_sum")),)
#: The same for claims that seem to be true.
NORMAL_FORM = Technique("normal form", _from("equations", "by_normal_form"))
PRODUCTS = (
    NORMAL_FORM,
    Technique("differences", _from("differences", "by_differences")),
    Technique("sums of products", _from("linear", "by_products", degree=2)),
    Technique("orders of variables", _from("differences", "by_orders_of_variables")),
    Technique("powers of roots", _from("rising", "by_powers")),
    Technique("squares where equations hold", _from("equations", "squares_on_equations")),
    Technique("powers of both sides", _from("equations", "by_whole_powers")),
    Technique("bounds of variables", _from("bounded", "by_bounds")),
)
#: Groups whose lemmas are of no use to others: without a proof they are taken back.
TIDY = (SUMS, PRODUCTS, (NORMAL_FORM,))
#: For claims that no estimate refutes.
SEARCHES = (
    Technique("cosines", partial(_cosines, near=True)),
    Technique("circles", _from("circles", "by_circles")),
    Technique("a small tree", _from("tree", "by_tree")),
    Technique("cosines", partial(_cosines, near=False)),
    Technique("definitions written out", _from("written_out", "by_definitions")),
    Technique("logarithms of both sides", _from("rising", "by_logarithms")),
    Technique("growth", _from("growth", "by_growth")),
    LAWS,
    ELEMENTARY,
    Technique("products of logarithms", _from("laws", "by_products_of_logarithms")),
    Technique("multiple angles", _from("multiple_angles", "by_multiple_angles")),
    Technique(
        "coefficients on few parts", _from("bernstein_boxes", "by_bernstein", parts=FEW_PARTS)
    ),
    Technique("slopes", _from("mean_values", "by_mean_values")),
    Technique("arguments of functions", _from("arguments_of_functions", "by_arguments")),
    Technique("squaring", _from("squaring", "by_squaring")),
    Technique("factors", _from("factors", "by_factors")),
    Technique("known entries", _from("extrema", "by_known_entries")),
    Technique("entries", _from("extrema", "by_entries")),
    Technique("cases", _from("extrema", "by_cases")),
    Technique("squares", _from("positive", "squares")),
    Technique(
        "coefficients on many parts", _from("bernstein_boxes", "by_bernstein", parts=MANY_PARTS)
    ),
)

#: What takes most of the work, and is tried when nothing else is left.
LAST = (Technique("sums of longer products", _from("linear", "by_products", degree=3)),)

ANYWHERE = Hint()
#: The names of all techniques, which hints may have words of.
TECHNIQUES = tuple(
    technique.name
    for group in (FREE, EQUATIONS, SIMPLE, SUMS, PRODUCTS, SEARCHES)
    for technique in group
)


def find(goal: Goal, known: Universal) -> Proof | None:
    """The first proof that a technique finds; why one of them gave up is kept as a reason.

    Among many facts it is looked for with the nearest ones first.
    """
    if known.is_restricted:
        return _found(goal, known)
    finished, known.is_restricted = set[frozenset[str]](), True
    try:
        for hidden, units in rounds(goal, known):
            if hidden in finished:
                continue
            undo, known.hidden = known.mark(), hidden
            with known.budget.at_most(units) as share:
                proof = _found(goal, known)
                if proof is not None:
                    return proof
            if not share.is_over:
                finished.add(hidden)
            undo()
    finally:
        known.hidden, known.is_restricted = frozenset(), False
    return None


def _found(goal: Goal, known: Universal) -> Proof | None:
    """The first proof that a technique finds with what may be used."""
    hint = known.hints.get(goal.claim, ANYWHERE)
    for question, techniques in _stages(goal, known):
        for technique in techniques:
            if technique.name in known.refused or not hint.admits(technique.name):
                continue
            known.tried[technique.name] = None
            undo = known.mark() if techniques in TIDY else _nothing
            try:
                proof = technique.prove(question)
            except TooLongError:
                known.reasons[f"{technique.name}: expanding the claim is too much work"] = None
                proof = None
            if proof is not None:
                known.found_by = technique.name
                return proof
            undo()
    return None


def _nothing() -> None:
    """Lemmas of a technique that finds no proof may help the next."""


def _stages(goal: Goal, known: Universal) -> Iterator[tuple[Question, tuple[Technique, ...]]]:
    """What is tried on which form of the goal; the next is looked at if nothing is found."""
    question = Question(goal, known)
    if known.contexts.keys() & {f"{goal.context}.part1", f"{goal.context}.inverse"}:
        yield question, (PARTS, INVERSES)
    if goal.claim.relation == "=":
        yield from _of_equation(question)
        return
    yield question, FREE
    if not _clears(question):
        return
    claim = known.turned(goal.claim, goal.context)
    if claim != goal.claim:
        question = Question(goal._replace(claim=claim), known)
        if not _clears(question):
            return
    if not question.goal.variables:
        yield question, (EQUALITY,)
    yield question, SIMPLE
    yield from _of_all_that_is_known(question)


def _of_equation(question: Question) -> Iterator[tuple[Question, tuple[Technique, ...]]]:
    yield question, FREE[:1]
    if not _clears(question):
        return
    widened = question.widened() or question
    if widened.clears():
        yield widened, (NORMAL_FORM,)
    yield question, (LAWS,)
    if question.clears() and widened.may_be_equal():
        yield question, EQUATIONS


def _of_all_that_is_known(question: Question) -> Iterator[tuple[Question, tuple[Technique, ...]]]:
    """What is tried with the names that are linked to those in a claim."""
    known, place = question.known, question.goal.context
    widened = question.widened() or question
    if widened.clears():
        yield widened, SUMS
        if _find_inverse_ranges(widened):
            question = Question(known.goal(question.plain.claim, place), known)
            widened = question.widened() or question
            yield question, (*FREE, *SIMPLE)
            yield widened, SUMS
        from verify.prover.search.linear import find_ranges  # loaded only where they are needed
        from verify.prover.search.witnesses import is_false

        if is_false(widened):
            return
        if place not in known.ranged:
            known.ranged.add(place)
            if find_ranges(widened):
                question = Question(known.goal(question.plain.claim, place), known)
                widened = question.widened() or question
                yield question, (*FREE, *SIMPLE)
        yield widened, PRODUCTS
    for group in (SEARCHES, LAST):
        for asked in dict.fromkeys((question, widened)):
            if _is_small(asked) and asked.clears() and not asked.is_refuted():
                yield asked, group
            elif group is LAST and asked is widened and asked.equations and asked.clears():
                yield asked, LAST  # estimates do not look at equations


def _find_inverse_ranges(question: Question) -> bool:
    """Afterwards facts are known by what is given of exponentials and logarithms; whether new."""
    parts = parts_of(*(side for given in question.givens() for side in given.claim.key[1:]))
    if not any(part.op in ("exp", "log") for part in parts):
        return False
    from verify.prover.search.inverse_ranges import find_inverse_ranges  # only where it is needed

    return find_inverse_ranges(question)


def _is_small(question: Question) -> bool:
    """Whether there are not too many variables for all searches."""
    return len(question.goal.variables) <= max(MAX_LINKED, len(question.plain.variables))


def _clears(question: Question) -> bool:
    claim = question.plain.claim
    return question.known.clears((claim.lhs, claim.rhs), question.plain.context)
