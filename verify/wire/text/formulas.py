"""Terms and formulas of SMT-LIB and FPCore: what a tree of words stands for, in a scope of names.

A name stands for a value, whichever sort it has: there is one table for terms, formulas and
functions, and an inner name hides an outer one of any sort. A value is made once, where it is
defined, and shared wherever it is used. A term with ``ite`` in it has several alternatives, each
under conditions.
"""

from __future__ import annotations

import re
from collections.abc import Callable, Iterable, Iterator, Mapping, Sequence
from fractions import Fraction
from functools import reduce
from itertools import combinations, pairwise
from operator import add, mul, sub

from verify.language import terms
from verify.language.record import Record
from verify.language.terms import Claim, Term, as_term, exp, log, maximum, minimum, pi, sqrt
from verify.wire.inputs import InputError, nearest, rational, shown
from verify.wire.text.letters import FUNCTIONS
from verify.wire.text.lisp import Source, Tree, Word

#: A formula, or a term, with more alternatives than this is refused.
MAX_CASES = 64
#: So many trees are read at most, those of a function each time that it is called.
MAX_READ = 100_000
#: What is ``distinct`` has at most half as many pairs.
MAX_PAIRS = 50_000

_NUMBER = re.compile(
    r"[+-]?(?:[0-9]++(?:\.[0-9]*+)?|\.[0-9]++)(?:[eE][+-]?[0-9]++)?|[+-]?[0-9]++/[0-9]++"
)

REAL, BOOL = "Real", "Bool"


#: Every formula that was made, by its operation and parts.
_FORMULAS: dict[tuple[str, tuple[Formula, ...], object], Formula] = {}


class Formula:
    """A formula: a ``claim``, or an operation of others; what is written alike is one object.

    ``and`` of no parts is true, and ``not`` of that is false. The parts of a ``choice`` are
    conditions, of which just one holds, each with the formula that is meant if it holds. That of
    a constant of the sort Bool is this word with its name.
    """

    __slots__ = ("claim", "op", "parts")

    op: str
    parts: tuple[Formula, ...]
    claim: Claim | None

    def __new__(
        cls, op: str, parts: tuple[Formula, ...] = (), claim: Claim | None = None
    ) -> Formula:
        """The one formula that is written like this."""
        key = (op, parts, claim)
        found = _FORMULAS.get(key)
        if found is None:
            found = _FORMULAS[key] = super().__new__(cls)
            found.op, found.parts, found.claim = op, parts, claim
        return found


TRUE = Formula("and")
FALSE = Formula("not", (TRUE,))

#: Conditions: formulas, with whether they hold.
Conditions = frozenset[tuple[Formula, bool]]
ALWAYS: Conditions = frozenset()
#: A term by its alternatives; at any values of the variables the conditions of one of them hold.
Real = tuple[tuple[Conditions, Term], ...]
Value = Real | Formula


class Function:
    """A function of a file: its parameters with their sorts, the sort of its values, its body."""

    def __init__(self, parameters: Mapping[str, str], sort: str, body: Tree) -> None:
        self.parameters, self.sort, self.body = tuple(parameters.items()), sort, body


class Scope:
    """Names with what they stand for; those that are not in it are looked for around it."""

    def __init__(self, around: Scope | None = None) -> None:
        self.own: dict[str, Value | Function] = {}
        self.around = around

    def find(self, name: str) -> Value | Function | None:
        """What a name stands for here; None if for nothing."""
        scope: Scope | None = self
        while scope is not None:
            if name in scope.own:
                return scope.own[name]
            scope = scope.around
        return None

    def names(self) -> Iterator[str]:
        """All names that are known here."""
        scope: Scope | None = self
        while scope is not None:
            yield from scope.own
            scope = scope.around


def real(term: Term) -> Real:
    """A term as the only alternative."""
    return ((ALWAYS, term),)


# --- operations ----------------------------------------------------------------------------------


def _minus(*parts: Term) -> Term:
    """The difference; a number with a minus sign is one number."""
    if len(parts) > 1:
        if len(parts) > terms.LONG:
            return parts[0] - _plus(*parts[1:])
        return reduce(sub, parts)
    return as_term(-parts[0].value) if parts[0].op == "rational" else -parts[0]


def _plus(*parts: Term) -> Term:
    return terms.joined(parts, add)


def _times(*parts: Term) -> Term:
    return terms.joined(parts, mul)


def _over(above: Term, below: Term) -> Term:
    """The quotient; of two numbers it is one number."""
    if above.op == below.op == "rational" and below.value:
        return as_term(above.value / below.value)
    return above / below


def _quotient(*parts: Term) -> Term:
    if len(parts) == 1:
        raise ValueError("a quotient needs two terms")
    return reduce(_over, parts)


def _power(base: Term, exponent: Term) -> Term:
    found = exponent.value if exponent.op == "rational" else Fraction(0)
    if found == Fraction(1, 2):
        return sqrt(base)
    if found.denominator != 1 or not 0 < abs(found) <= terms.MAX_POWER:
        raise ValueError(f"an exponent has to be a whole number up to {terms.MAX_POWER}, and not 0")
    whole = base ** abs(int(found))
    return whole if found > 0 else 1 / whole


def _cosine(angle: Term) -> Term:
    """The cosine; of pi times a number it is the operation that a page writes cos_pi."""
    half_turns = _over_pi(angle)
    return terms.cos(angle) if half_turns is None else terms.cos_pi(half_turns)


def _over_pi(term: Term) -> Term | None:
    """A term divided by pi, if pi is one of its factors."""
    if term is pi:
        return as_term(1)
    if term.op not in ("mul", "div", "neg"):
        return None
    if term.op == "mul":
        left: Term
        right: Term
        left, right = term.children
        pairs: tuple[tuple[Term, Term], ...] = ((left, right), (right, left))
        for factor, other in pairs:
            found = _over_pi(factor)
            if found is not None:
                return other if found is as_term(1) else found * other
        return None
    found = _over_pi(term.children[0])
    return None if found is None else Term(term.op, found, *term.children[1:])


def _cube_root(term: Term) -> Term:
    """The cube root of a real number: that of a negative number is negative."""
    above, below = terms.maximum(term, 0), terms.maximum(-term, 0)
    return terms.nth_root(above, 3) - terms.nth_root(below, 3)


Operation = Callable[..., Term]
_COMMON: Mapping[str, Operation] = {
    "+": _plus,
    "-": _minus,
    "*": _times,
    "/": _quotient,
    **{name: getattr(terms, name) for name in ("atan", "sqrt", "exp", "log", "sin")},
    "cos": _cosine,
    **{name: FUNCTIONS[name] for name in ("tan", "asin", "acos", "sinh", "cosh", "tanh")},
    "cbrt": _cube_root,
    "pow": _power,
}


class Dialect(Record):
    """The words of a language: operations, relations, numbers with names.

    ``truths`` are false and true; ``words`` are those that no name may be. ``last`` says whether
    ``(! ...)`` has its term as the last part; that is how FPCore has it. ``foreign`` are words of
    the language that are not read.
    """

    operations: Mapping[str, Operation]
    relations: Mapping[str, str]
    unequal: str
    numbers: Mapping[str, Term]
    truths: tuple[str, str]
    conditional: str
    words: frozenset[str]
    last: bool
    foreign: frozenset[str] = frozenset()


_CONNECTIVES = ("not", "and", "or", "=>", "xor", "ite")
_ORDERS = {name: name for name in ("<", "<=", ">=", ">")}
SMTLIB = Dialect(
    {
        **_COMMON,
        **FUNCTIONS,
        "^": _power,
        "min": minimum,
        "max": maximum,
    },
    {**_ORDERS, "=": "="},
    "distinct",
    {"real.pi": pi, "pi": pi},
    ("false", "true"),
    "ite",
    frozenset(
        [
            *(*_CONNECTIVES, *_ORDERS, *"=+-*/", "distinct", "let", "!", "true", "false"),
            *("forall", "exists", "match", "par", "as", "_"),
        ]
    ),
    last=False,
    foreign=frozenset(
        ["forall", "exists", "match", "as", "_", "mod", "div", "is_int", "to_int", "to_real"]
    ),
)
#: What ``(! ...)`` may say in FPCore: how to round, which real numbers do not care about.
ROUNDING = frozenset([":precision", ":round", ":overflow", ":math-library"])
#: What FPCore has besides, and no page.
_FOREIGN = frozenset(
    [
        *("fma", "exp2", "expm1", "log2", "log10", "log1p", "hypot", "fmod", "remainder", "fdim"),
        *("asinh", "acosh", "atanh", "erf", "erfc", "tgamma", "lgamma", "atan2", "copysign"),
        *("ceil", "floor", "trunc", "round", "nearbyint", "cast", "while", "while*", "for", "for*"),
        *("tensor", "tensor*", "array", "dim", "size", "ref", "digits", "data"),
        *("isfinite", "isinf", "isnan", "isnormal", "signbit", "INFINITY", "NAN"),
        *("LOG2E", "LOG10E", "PI_2", "PI_4", "M_1_PI", "M_2_PI", "M_2_SQRTPI", "SQRT2", "SQRT1_2"),
    ]
)
FPCORE = Dialect(
    {**_COMMON, "fabs": FUNCTIONS["abs"], "fmin": minimum, "fmax": maximum},
    {**_ORDERS, "==": "="},
    "!=",
    {"PI": pi, "E": exp(1), "LN2": log(2), "LN10": log(10)},
    ("FALSE", "TRUE"),
    "if",
    frozenset([*_ORDERS, *"+-*/", "==", "!=", "not", "and", "or", "if", "let", "let*", "!"]),
    last=True,
    foreign=_FOREIGN,
)


# --- alternatives --------------------------------------------------------------------------------


def _joined(one: Conditions, other: Conditions) -> Conditions | None:
    """Both conditions; None where they contradict each other."""
    both = one | other
    return None if any((formula, not holds) in both for formula, holds in both) else both


def _under(condition: Formula, holds: bool, value: Real) -> Iterator[tuple[Conditions, Term]]:
    for others, term in value:
        both = _joined(others, frozenset([(condition, holds)]))
        if both is not None:
            yield both, term


def _negated(formula: Formula) -> Formula:
    return formula.parts[0] if formula.op == "not" else Formula("not", (formula,))


def _conjunction(parts: Sequence[Formula]) -> Formula:
    if any(part is FALSE for part in parts):
        return FALSE
    found = tuple(dict.fromkeys(part for part in parts if part is not TRUE))
    return found[0] if len(found) == 1 else Formula("and", found) if found else TRUE


def _disjunction(parts: Sequence[Formula]) -> Formula:
    return _negated(_conjunction([_negated(part) for part in parts]))


def _choice(condition: Formula, one: Formula, other: Formula) -> Formula:
    """The one formula if a condition holds, and the other if it does not."""
    if condition in (TRUE, FALSE):
        return one if condition is TRUE else other
    return Formula("choice", (condition, one, _negated(condition), other))


def _is_same(one: Formula, other: Formula) -> Formula:
    return _choice(one, other, _negated(other))


def _extremum(condition: Formula, one: Term, other: Term) -> Term | None:
    """The minimum, maximum or modulus that a conditional term is; None for another one.

    ``ite (l <= r) l r`` is the least of the two, and so on; |x| is written as max(x, -x).
    """
    claim = condition.claim
    if claim is None or claim.relation == "=":
        return None
    sides = (claim.lhs, claim.rhs)
    if sides == (one, other):
        return minimum(one, other)
    if sides == (other, one):
        return maximum(other, one)
    zero = as_term(0)
    for x, is_one in ((one, sides == (zero, one)), (other, sides == (other, zero))):
        if is_one and {one, other} == {x, -x}:
            return maximum(x, -x)
    return None


#: What is written instead of signs of other languages, in SMT-LIB and (true) in FPCore.
_WRITTEN: Mapping[str, Mapping[bool, str]] = {
    "==": {False: "="},
    "=": {True: "=="},
    "!=": {False: "distinct"},
    "distinct": {True: "!="},
    "<>": {False: "distinct", True: "!="},
    "=<": {False: "<=", True: "<="},
    "**": {False: "^", True: "pow"},
    "^": {True: "pow"},
    "ite": {True: "if"},
    "abs": {True: "fabs"},
    "min": {True: "fmin"},
    "max": {True: "fmax"},
}


class Reader:
    """Reads what trees stand for."""

    def __init__(self, source: Source, dialect: Dialect) -> None:
        self.source, self.dialect = source, dialect
        self.globals = Scope()
        #: Operations and numbers of the language that were meant by their names so far.
        self.meant: set[str] = set()
        self._left = MAX_READ
        self._called: dict[tuple[Function, tuple[Value, ...]], Value] = {}

    # --- values of a sort ------------------------------------------------------------------------

    def formula(self, tree: Tree, scope: Scope) -> Formula:
        """The formula that a tree stands for.

        Raises:
            InputError: for a term, or for what stands for nothing.
        """
        found = self.value(tree, scope)
        if not isinstance(found, Formula):
            raise self.source.error(tree, f"{_head(tree)} is a number, where a formula is meant")
        return found

    def real(self, tree: Tree, scope: Scope) -> Real:
        """The alternatives of the term that a tree stands for.

        Raises:
            InputError: for a formula, or for what stands for nothing.
        """
        found = self.value(tree, scope)
        if isinstance(found, Formula):
            raise self.source.error(tree, f"{_head(tree)} is a formula, where a number is meant")
        return found

    def of_sort(self, sort: str, tree: Tree, scope: Scope) -> Value:
        """The value that a tree stands for, which is of a sort."""
        return self.formula(tree, scope) if sort == BOOL else self.real(tree, scope)

    def value(self, tree: Tree, scope: Scope) -> Value:
        """What a tree stands for.

        Raises:
            InputError: for an unknown name or operation, or too many parts.
        """
        self._left -= 1
        if self._left < 0:
            raise self.source.error(
                tree, f"with its functions written out the file has more than {MAX_READ} parts"
            )
        if isinstance(tree, Word):
            return self._leaf(tree, scope)
        if not tree or not isinstance(tree[0], Word):
            raise self.source.error(tree, "an operation is missing after the parenthesis")
        head, parts = tree[0], tree[1:]
        if not head.quoted and head in ("let", "let*", "!") and head in self.dialect.words:
            return self._let(tree, scope) if head != "!" else self._annotated(tree, scope)
        known = scope.find(head) if head.is_symbol else None
        if known is not None:
            return self._call(head, known, parts, scope)
        if not parts:
            raise self.source.error(
                head, f"{shown(head)} stands alone; write what it is applied to"
            )
        if head in self.dialect.operations:
            self.meant.add(head)
            return self._applied(head, [self.real(part, scope) for part in parts])
        if head in self.dialect.words:
            found = self._formula(head, parts, scope)
            if found is not None:
                return found
        instead = self._instead(head, self.dialect.operations)
        raise self.source.error(head, f"the operation {shown(head)} cannot be used; {instead}")

    def _leaf(self, word: Word, scope: Scope) -> Value:
        known = scope.find(word) if word.is_symbol else None
        if isinstance(known, Function):
            raise self.source.error(word, f"{shown(word)} is a function; write ({word} ...)")
        if known is not None:
            return known
        if not word.quoted and _NUMBER.fullmatch(word):
            rest = re.sub(r"^[+-]?[0-9]+(\.[0-9]+)?", "", word)
            if rest and not self.dialect.last and scope.find(rest) is not None:
                what = f"{shown(word)} can be read as a number, or followed by the name {rest}"
                raise self.source.error(word, f"{what}; choose another name")
            text = word.rstrip(".") if "." in word and word.endswith(".") else word
            where = f"{self.source.path}, line {word.line}"
            return real(as_term(rational(where, text.lstrip("+"))))
        if word in self.dialect.numbers:
            self.meant.add(word)
            return real(self.dialect.numbers[word])
        if word in self.dialect.truths:
            return (FALSE, TRUE)[self.dialect.truths.index(word)]
        if not word.quoted and re.match(r"[+-]?\.?[0-9]", word):
            raise self.source.error(
                word, f"{shown(word)} is no number in decimal digits; write 8 or 0.5"
            )
        known_names = [*scope.names(), *self.dialect.numbers]
        raise self.source.error(
            word, f"{shown(word)} is not known; {self._instead(word, known_names)}"
        )

    def _instead(self, word: Word, known: Iterable[str]) -> str:
        """What to write for a word that is not read; nothing like it if the language has it."""
        if word in self.dialect.foreign:
            return "it is not read; write what it means with + - * / exp log ..."
        written = _WRITTEN.get(word, {}).get(self.dialect.last)
        if written:
            return f"write {written}"
        if known is self.dialect.operations:
            return nearest(word, known)
        if not word.is_symbol:
            return "write a name or a number"
        otherwise = "write it among the arguments" if self.dialect.last else "declare it before"
        return nearest(word, known, otherwise)

    # --- names -----------------------------------------------------------------------------------

    def _let(self, tree: list[Tree], scope: Scope) -> Value:
        """The body of a ``let`` with its names; each of a ``let*`` knows those before it."""
        match tree:
            case [Word() as op, list() as bindings, body]:
                inner = Scope(scope)
            case _:
                raise self.source.error(tree, "a let needs a list of pairs, and a body")
        for name, term in self.source.pairs(bindings):
            if name in self.dialect.words:
                raise self.source.error(name, f"{shown(name)} is a word of the language, no name")
            if op == "let*":
                inner = Scope(inner)
            elif name in inner.own:
                raise self.source.error(name, f"{shown(name)} has two values in one let")
            inner.own[name] = self.value(term, inner if op == "let*" else scope)
        return self.value(body, inner)

    def _annotated(self, tree: list[Tree], scope: Scope) -> Value:
        """A term of FPCore for which a way to round is said, which does not matter here."""
        keys = tree[1:-1:2]
        is_table = len(tree) % 2 == 0 and all(
            isinstance(key, Word) and key.startswith(":") for key in keys
        )
        if not (self.dialect.last and is_table) or not {*keys} <= ROUNDING:
            raise self.source.error(tree, "an annotation cannot be used here; leave it out")
        return self.value(tree[-1], scope)

    def _call(
        self, head: Word, known: Value | Function, parts: Sequence[Tree], scope: Scope
    ) -> Value:
        """The value of a function of the file, with its arguments in place of its parameters."""
        if not isinstance(known, Function):
            raise self.source.error(head, f"{shown(head)} is no function, and is applied to terms")
        if len(parts) != len(known.parameters):
            wanted = len(known.parameters)
            raise self.source.error(head, f"{shown(head)} needs {wanted} terms, not {len(parts)}")
        values = tuple(
            self.of_sort(sort, part, scope)
            for part, (_, sort) in zip(parts, known.parameters, strict=True)
        )
        return self.called(known, values)

    def called(self, function: Function, values: tuple[Value, ...]) -> Value:
        """The value of a function at these arguments.

        In its body are known its parameters, and what stands around its definition: names of a
        file that are declared never change, and those that are ``meant`` are not declared later.
        """
        key = (function, values)
        if key not in self._called:
            inner = Scope(self.globals)
            for (name, _), value in zip(function.parameters, values, strict=True):
                inner.own[name] = value
            self._called[key] = self.of_sort(function.sort, function.body, inner)
        return self._called[key]

    # --- operations ------------------------------------------------------------------------------

    def _applied(self, head: Word, values: Sequence[Real]) -> Real:
        operation = self.dialect.operations[head]
        try:
            return tuple(
                (conditions, operation(*parts)) for conditions, parts in self._each(head, values)
            )
        except (TypeError, ValueError) as error:
            if isinstance(error, InputError):
                raise
            raise self.source.error(
                head, f"{shown(head)} of {len(values)} terms: {error}"
            ) from error

    def _each(
        self, head: Word, values: Sequence[Real]
    ) -> Sequence[tuple[Conditions, tuple[Term, ...]]]:
        """The alternatives of several terms together."""
        found: list[tuple[Conditions, tuple[Term, ...]]] = [(ALWAYS, ())]
        for value in values:
            found = [
                (both, (*before, term))
                for conditions, before in found
                for others, term in value
                if (both := _joined(conditions, others)) is not None
            ]
            self._check_cases(head, len(found))
        return found

    def _check_cases(self, head: Word, count: int) -> None:
        if count > MAX_CASES:
            raise self.source.error(head, f"it has more than {MAX_CASES} cases; split the file")

    def _formula(self, head: Word, parts: Sequence[Tree], scope: Scope) -> Value | None:
        """The formula, or conditional, with an operation; None if it is not one of those."""
        if head in self.dialect.relations or head == self.dialect.unequal:
            return self._related(head, parts, scope)
        if head == self.dialect.conditional:
            return self._chosen(head, parts, scope)
        if head not in _CONNECTIVES:
            return None
        found = [self.formula(part, scope) for part in parts]
        least = 1 if head in ("not", "and", "or") else 2
        if len(found) < least or (head == "not" and len(found) > 1):
            raise self.source.error(head, f"{shown(head)} of {len(found)} parts is no formula")
        match head:
            case "not":
                return _negated(found[0])
            case "and":
                return _conjunction(found)
            case "xor":
                return reduce(lambda p, q: _negated(_is_same(p, q)), found)
            case "=>":
                found[:-1] = map(_negated, found[:-1])
        return _disjunction(found)

    def _chosen(self, head: Word, parts: Sequence[Tree], scope: Scope) -> Value:
        if len(parts) != 3:
            raise self.source.error(head, f"{shown(head)} needs a formula and two values")
        condition, one = self.formula(parts[0], scope), self.value(parts[1], scope)
        if isinstance(one, Formula):
            return _choice(condition, one, self.formula(parts[2], scope))
        second = self.real(parts[2], scope)
        if condition in (TRUE, FALSE):
            return one if condition is TRUE else second
        if len(one) == len(second) == 1:
            found = _extremum(condition, one[0][1], second[0][1])
            if found is not None:
                return real(found)
        choices = (*_under(condition, True, one), *_under(condition, False, second))
        self._check_cases(head, len(choices))
        return choices

    def _related(self, head: Word, parts: Sequence[Tree], scope: Scope) -> Formula:
        """What a chain such as ``(< a b c)`` says, of numbers; of formulas that they are equal."""
        if len(parts) < 2:
            raise self.source.error(head, f"{head} needs at least two terms")
        if head == self.dialect.unequal and len(parts) ** 2 > MAX_PAIRS:
            raise self.source.error(
                head, f"{head} of {len(parts)} terms has too many pairs; write parts of it"
            )
        first, is_same = self.value(parts[0], scope), self.dialect.relations.get(head) == "="
        pairs = combinations if head == self.dialect.unequal else lambda items, _: pairwise(items)
        if isinstance(first, Formula) and (is_same or head == self.dialect.unequal):
            formulas = [first, *(self.formula(part, scope) for part in parts[1:])]
            equal = [_is_same(p, q) for p, q in pairs(formulas, 2)]
            return _conjunction(equal if is_same else [*map(_negated, equal)])
        values = [self.real(part, scope) for part in parts]
        return _conjunction([self._compared(head, p, q) for p, q in pairs(values, 2)])

    def _compared(self, head: Word, left: Real, right: Real) -> Formula:
        relation = self.dialect.relations.get(head, "=")
        cases: list[Formula] = []
        for conditions, (a, b) in self._each(head, (left, right)):
            sides = (b, a) if relation[0] == ">" else (a, b)
            claim = Formula("claim", (), Claim(relation.replace(">", "<"), *sides))
            found = claim if head in self.dialect.relations else _negated(claim)
            given = [f if holds else _negated(f) for f, holds in conditions]
            cases += (_conjunction(given), found)
        return Formula("choice", tuple(cases)) if len(cases) > 2 else cases[1]


def _head(tree: Tree) -> str:
    while isinstance(tree, list) and tree:
        tree = tree[0]
    return shown(str(tree or "()"))
