"""Terms as people write them: signs and units in order, nothing else changed.

What is made has the same value wherever the term has one; it is shown, and proves nothing.
"""

from __future__ import annotations

from collections.abc import Callable, Mapping
from fractions import Fraction
from functools import partial

from verify.language.fold import TERMS, fold
from verify.language.terms import Claim, Term, as_term

ONE = Fraction(1)


def simplified_claim(claim: Claim, known: dict[Term, Term] | None = None) -> Claim:
    """Both sides, simplified; ``known`` keeps what terms come to for other claims."""
    known = {} if known is None else known
    lhs, rhs = (fold(side, _ALGEBRA, known) for side in (claim.lhs, claim.rhs))
    return Claim(claim.relation, lhs, rhs)


def simplified(term: Term) -> Term:
    """The term without factors 1, double signs, and products of numbers."""
    return fold(term, _ALGEBRA, {})


def _negated(term: Term) -> Term:
    if term.op == "neg":
        inner: Term = term.children[0]
        return inner
    return as_term(-term.value) if term.op == "rational" else Term("neg", term)


def _sign(term: Term) -> tuple[bool, Term]:
    """Whether a minus sign stands before a term, and the term without it."""
    if term.op == "neg" or (term.op == "rational" and term.value < 0):
        return True, _negated(term)
    if term.op in ("mul", "div"):
        minus, first = _sign(term.children[0])
        if minus:
            rest: Term = term.children[1]
            return True, _product(first, rest) if term.op == "mul" else _quotient(first, rest)
    return False, term


def _sum(op: str, left: Term, right: Term) -> Term:
    minus, size = _sign(right)
    subtracted = minus != (op == "sub")
    if size.op == "rational" and size.value == 0:
        return left
    if left.op == "rational" and left.value == 0:
        return _negated(size) if subtracted else size
    return Term("sub" if subtracted else "add", left, size)


def _product(left: Term, right: Term) -> Term:
    (minus, x), (other, y) = _sign(left), _sign(right)
    if minus != other:
        return _negated(_product(x, y))
    if x.op == "rational" and y.op == "rational":
        return as_term(x.value * y.value)
    if x.op == "rational" and x.value == ONE:
        return y
    if y.op == "rational":
        return x if y.value == ONE else Term("mul", y, x)
    return Term("mul", x, y)


def _quotient(left: Term, right: Term) -> Term:
    (minus, x), (other, y) = _sign(left), _sign(right)
    if minus != other:
        return _negated(_quotient(x, y))
    if y.op == "rational" and y.value != 0:
        if x.op == "rational":
            return as_term(x.value / y.value)
        if y.value == ONE:
            return x
    return Term("div", x, y)


_ALGEBRA: Mapping[str, Callable[..., Term]] = {
    **TERMS,
    "neg": _negated,
    "add": partial(_sum, "add"),
    "sub": partial(_sum, "sub"),
    "mul": _product,
    "div": _quotient,
    "pow": lambda base, exponent: base if exponent == 1 else base**exponent,
}
