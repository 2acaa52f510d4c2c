"""Terms as people write them: signs and units in order, nothing else changed.

What is made has the same value wherever the term has one; it is shown, and proves nothing.
"""

from __future__ import annotations

from fractions import Fraction

from verify.language.terms import LEAVES, Claim, Term, as_term, nth_root

ONE = Fraction(1)


def simplified_claim(claim: Claim) -> Claim:
    """Both sides, simplified."""
    return Claim(claim.relation, simplified(claim.lhs), simplified(claim.rhs))


def simplified(term: Term) -> Term:
    """The term without factors 1, double signs, and products of numbers."""
    known: dict[Term, Term] = {}
    for part in _in_order(term):
        if part.op in LEAVES:
            known[part] = part
        elif part.op == "root":
            known[part] = nth_root(known[part.children[0]], part.exponent)
        elif part.op == "pow":
            base = known[part.children[0]]
            known[part] = base if part.exponent == 1 else base**part.exponent
        else:
            known[part] = _rebuilt(part.op, [known[child] for child in part.children])
    return known[term]


def _in_order(term: Term) -> list[Term]:
    """The parts of a term, each after its own parts."""
    found: dict[Term, None] = {}
    waiting = [(term, False)]
    while waiting:
        part, ready = waiting.pop()
        if ready:
            found[part] = None
        elif part not in found:
            waiting.append((part, True))
            waiting += [(child, False) for child in part.children]
    return list(found)


def _rebuilt(op: str, parts: list[Term]) -> Term:
    if op == "neg":
        return _negated(parts[0])
    if op in ("add", "sub"):
        return _sum(op, *parts)
    if op == "mul":
        return _product(*parts)
    if op == "div":
        return _quotient(*parts)
    return Term(op, *parts)


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
