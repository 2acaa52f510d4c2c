"""Numbers that are positive, or not negative, by the way in which they are written."""

from __future__ import annotations

from collections.abc import Callable

from verify.language.terms import Claim, Term, parts_of
from verify.prover.proof import Value
from verify.prover.rules import Sum
from verify.prover.search.question import Question
from verify.prover.session import ZERO

#: The name of the fact that 0 < t, or 0 <= t, if there is one.
Known = Callable[[Claim], str | None]

#: A number that is >= 0, and whether it is > 0.
Sign = tuple[Value, bool]


def by_signs(question: Question) -> Sum | None:
    """A proof of 0 < t or 0 <= t, where t is a sum of products of such numbers."""
    claim, place = question.plain.claim, question.goal.context
    if claim.relation not in ("<", "<=") or claim.lhs != ZERO or _has_denominator(claim.rhs):
        return None
    found = _sign(claim.rhs, lambda wanted: question.session.known(wanted, place))
    if found is None or (claim.relation == "<" and not found[1]):
        return None
    return Sum(("goal", found[0]))


def _has_denominator(term: Term) -> bool:
    return any(part.op == "div" and part.children[1].op != "rational" for part in parts_of(term))


def _sign(term: Term, known: Known) -> Sign | None:
    """The term itself, which has no denominator, as a value of a sum."""
    if term.op == "rational":
        return (str(term.value), term.value > 0) if term.value >= 0 else None
    for relation in ("<", "<="):
        name = known(Claim(relation, ZERO, term))
        if name is not None:
            return name, relation == "<"
    return _OPERATIONS.get(term.op, _nothing)(term, known)


def _nothing(_: Term, __: Known) -> None:
    return None


def _sum(term: Term, known: Known) -> Sign | None:
    a, b = (_sign(child, known) for child in term.children)
    return (("add", a[0], b[0]), a[1] or b[1]) if a and b else None


def _product(term: Term, known: Known) -> Sign | None:
    if term.children[0] == term.children[1]:
        return _square(term.children[0], known)
    a, b = (_sign(child, known) for child in term.children)
    return (("mul", a[0], b[0]), a[1] and b[1]) if a and b else None


def _quotient(term: Term, known: Known) -> Sign | None:
    top, divisor = term.children
    if divisor.op != "rational" or divisor.value <= 0:
        return None
    found = _sign(top, known)
    return (("mul", str(1 / divisor.value), found[0]), found[1]) if found else None


def _power(term: Term, known: Known) -> Sign | None:
    base, exponent = term.children[0], term.exponent
    found = _sign(base, known)
    if found is not None:
        return ("pow", found[0], exponent), found[1]
    if exponent % 2:
        return None
    square: Value = ("square", base)
    return (square if exponent == 2 else ("pow", square, exponent // 2)), False


def _square(term: Term, known: Known) -> Sign:
    found = _sign(term, known)
    return (("square", term), False) if found is None else (("pow", found[0], 2), found[1])


def _root(term: Term, _: Known) -> Sign:
    return ("root", term), False


_OPERATIONS: dict[str, Callable[[Term, Known], Sign | None]] = {
    "add": _sum,
    "mul": _product,
    "div": _quotient,
    "pow": _power,
    "sqrt": _root,
    "root": _root,
}
