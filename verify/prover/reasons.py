"""Why a claim is undecided, in words: estimates, which prove nothing."""

from __future__ import annotations

from collections.abc import Collection, Iterator, Mapping
from fractions import Fraction

from verify.language.terms import Claim, Term
from verify.language.typeset import Typesetter
from verify.prover.clearing import inner_first
from verify.prover.goal import Goal
from verify.prover.search.question import Question
from verify.prover.universal import Universal

#: Digits of an estimate.
DIGITS = 4


def hardest(goal: Goal, known: Universal, spent: int) -> tuple[str, ...]:
    """How much was tried, where the claim is most nearly false, and which part of a box is left.

    ``spent`` are the units of work that it took.
    """
    return (*_tried(known, spent), *_nearest(Question(goal, known)), *_left(known))


def _tried(known: Universal, spent: int) -> Iterator[str]:
    if known.tried:
        *_, last = known.tried
        yield (
            f"{len(known.tried)} techniques were tried with {spent} of {known.budget.work} units "
            f"of work, the last one was: {last}"
        )


def _nearest(question: Question) -> Iterator[str]:
    """The point of the least difference of the sides, among those where the givens hold."""
    wide = question.widened() or question
    if wide.goal.claim.relation == "=" or wide.equations or not wide.goal.variables:
        return
    for value, point in wide.minima[:1]:
        at = ", ".join(
            f"{name} = {x:.{DIGITS}g}" for name, x in zip(wide.goal.variables, point, strict=True)
        )
        gap = f"{value + 0.0:.{DIGITS}g}"  # 0 has no sign
        yield f"it is most nearly false about {at}, where the sides differ by {gap}"


def _left(known: Universal) -> Iterator[str]:
    if known.left:
        sides = (f"{name} in [{_short(a)}, {_short(b)}]" for name, (a, b) in known.left.items())
        yield f"a part of the box that is left: {', '.join(sides)}"


def _short(value: Fraction) -> str:
    return f"{float(value):.{DIGITS}g}"


# --- terms without a value ------------------------------------------------------------------------

#: What a root needs, and what others need.
RADICAND = "a radicand must not be negative"
NEEDS: Mapping[str, str] = {
    "div": "a divisor must not be 0",
    "log": "what a logarithm is of must be positive",
}


def without_value(claim: Claim, valueless: Collection[Term]) -> Iterator[str]:
    """The innermost of these terms in a claim, and what it needs to have a value."""
    for part in inner_first((claim.lhs, claim.rhs), lambda term: term.children):
        if part in valueless:
            text, need = Typesetter({}).term(part), NEEDS.get(part.op, RADICAND)
            yield f"{text} was not seen to have a value everywhere: {need}"
            return
