"""The derivative of a term by a variable, as the checker builds it: nothing in it is left out."""

from __future__ import annotations

from collections.abc import Callable

from verify.language.terms import Term, as_term, cos, names_of, pi, sin

ONE = as_term(1)


def derivative(term: Term, name: str) -> Term | None:
    """The derivative by a variable that occurs in the term; None where there is none."""
    return _Derivatives(name).of(term)


def _times(a: Term, b: Term) -> Term:
    return b if a is ONE else a if b is ONE else a * b


def _power(base: Term, exponent: int) -> Term:
    return base if exponent == 1 else base**exponent


class _Derivatives:
    def __init__(self, name: str) -> None:
        self.name = name
        self.known: dict[Term, Term | None] = {}

    def occurs(self, term: Term) -> bool:
        return self.name in names_of(term)

    def of(self, term: Term) -> Term | None:
        if term not in self.known:
            self.known[term] = self._of(term)
        return self.known[term]

    def _of(self, term: Term) -> Term | None:
        if term.op == "symbol":
            return ONE
        if term.op in ("min", "max"):
            return None
        moving = [child for child in term.children if self.occurs(child)]
        slopes = [self.of(child) for child in moving]
        if any(slope is None for slope in slopes):
            return None
        found = [slope for slope in slopes if slope is not None]
        if term.op in _TWO:
            both = len(moving) == len(term.children)
            return _TWO[term.op](*term.children, *found) if both else self._one(term, found[0])
        return _chain(term, found[0])

    def _one(self, term: Term, slope: Term) -> Term:
        """The derivative where the variable occurs in one of two terms."""
        left: Term = term.children[0]
        right: Term = term.children[1]
        is_left = self.occurs(left)
        if term.op == "mul":
            return _times(right if is_left else left, slope)
        if term.op == "div":
            return slope / right if is_left else -(_times(left, slope) / right**2)
        return slope if is_left or term.op == "add" else -slope


_TWO: dict[str, Callable[[Term, Term, Term, Term], Term]] = {
    "add": lambda _, __, da, db: da + db,
    "sub": lambda _, __, da, db: da - db,
    "mul": lambda a, b, da, db: _times(b, da) + _times(a, db),
    "div": lambda a, b, da, db: (_times(b, da) - _times(a, db)) / b**2,
}


def _chain(term: Term, slope: Term) -> Term:
    inner: Term = term.children[0]
    match term.op:
        case "neg":
            return -slope
        case "pow":
            n = term.exponent
            return slope if n == 1 else _times(n * _power(inner, n - 1), slope)
        case "sqrt":
            return slope / (2 * term)
        case "root":
            return slope / (term.exponent * _power(term, term.exponent - 1))
        case "log":
            return slope / inner
        case "atan":
            return slope / (ONE + inner**2)
        case "exp":
            return _times(term, slope)
        case "sin":
            return _times(cos(inner), slope)
        case "cos":
            return -_times(sin(inner), slope)
    return -_times(pi * sin(pi * inner), slope)
