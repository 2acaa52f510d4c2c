"""Why a claim is undecided, in words: estimates, which prove nothing; and too long numbers."""

from __future__ import annotations

from collections.abc import Callable, Collection, Iterable, Iterator, Mapping
from fractions import Fraction
from math import log2

from verify.language.fold import fold
from verify.language.terms import OPERATIONS, Claim, Term, parts_of
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
        yield f"it is most nearly false about {at}, where the sides differ by {value:.{DIGITS}g}"


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


# --- numbers that are too long for the checker ---------------------------------------------------

#: The checker reads numbers of at most so many bits.
MAX_BITS = 2**19

#: The sign of a number and the logarithm of its absolute value; None where that is not seen.
Size = tuple[int, float] | None


def is_too_long(terms: Iterable[Term], definitions: Mapping[str, Term]) -> bool:
    """Whether a number in the terms is so large, or so near to 0, that nobody can write it down."""
    known: dict[Term, Size] = {}

    def named(name: str) -> Size:
        return fold(definitions[name], algebra, known) if name in definitions else None

    algebra: dict[str, Callable[..., Size]] = {
        **dict.fromkeys(OPERATIONS, lambda *_: None),
        **_OPERATIONS,
        "symbol": named,
    }
    for part in parts_of(*terms):
        size = fold(part, algebra, known)
        if size is not None and abs(size[1]) > MAX_BITS:
            return True
    return False


def _rational(value: Fraction) -> Size:
    if not value:
        return None
    top, bottom = abs(value.numerator), value.denominator
    return (1 if value > 0 else -1), log2(top) - log2(bottom)


def _sum(a: Size, b: Size) -> Size:
    return (a[0], max(a[1], b[1])) if a and b and a[0] == b[0] else None


def _product(a: Size, b: Size) -> Size:
    return (a[0] * b[0], a[1] + b[1]) if a and b else None


def _negative(a: Size) -> Size:
    return (-a[0], a[1]) if a else None


_OPERATIONS: Mapping[str, Callable[..., Size]] = {
    "rational": _rational,
    "add": _sum,
    "sub": lambda a, b: _sum(a, _negative(b)),
    "neg": _negative,
    "mul": _product,
    "div": lambda a, b: _product(a, (b[0], -b[1]) if b else None),
    "pow": lambda a, k: (a[0] ** k, a[1] * k) if a else None,
}
