"""Files in parentheses, as SMT-LIB and FPCore have them: read into lists, and lists into terms."""

from __future__ import annotations

import re
from collections.abc import Callable, Iterator, Mapping
from contextlib import contextmanager
from fractions import Fraction
from functools import reduce
from itertools import pairwise

from verify.language import terms
from verify.language.terms import Claim, Term, as_term, exp, log, maximum, minimum, pi, sqrt
from verify.wire.inputs import InputError, nearest, rational, shown
from verify.wire.text.letters import FUNCTIONS

_TOKEN = re.compile(r'\s+|;[^\n]*|"(?:[^"]|"")*"|\|[^|]*\||[()\[\]]|[^\s()\[\];"|]+')
_NUMBER = re.compile(r"[+-]?([0-9]+\.?[0-9]*|\.[0-9]+)([eE][+-]?[0-9]+)?|[+-]?[0-9]+/[0-9]+")


class Word(str):
    """A word of a file, with the line in which it stands."""

    __slots__ = ("line",)
    line: int


Tree = Word | list["Tree"]


#: So many parentheses are inside of one another at most.
MAX_DEPTH = 300
TOO_DEEP = "it nests too deeply; name its parts"


class Source:
    """A file, for messages that name it and a line."""

    def __init__(self, path: str, content: bytes) -> None:
        self.path = path
        try:
            self.text = content.decode()
        except UnicodeDecodeError as error:
            raise InputError(f"{path}: is not UTF-8; save it as UTF-8") from error

    @contextmanager
    def shallow(self) -> Iterator[None]:
        """Terms and formulas that nest too deeply to be read are bad input."""
        try:
            yield
        except RecursionError as error:
            raise self.error(None, TOO_DEEP) from error

    def error(self, tree: Tree | None, what: str) -> InputError:
        """The error that something is wrong where a tree begins."""
        line = _line(tree)
        return InputError(f"{self.path}{f', line {line}' if line else ''}: {what}")

    def pairs(self, bindings: Tree) -> Iterator[tuple[str, Tree]]:
        """The names in a ``let`` with what they stand for."""
        for binding in bindings if isinstance(bindings, list) else [bindings]:
            if not isinstance(binding, list) or len(binding) != 2:
                raise self.error(bindings, "a let needs pairs of a name and a term")
            yield str(binding[0]), binding[1]

    def trees(self) -> list[Tree]:
        """All that stands in the file.

        Raises:
            InputError: where parentheses do not match, or too many are open.
        """
        stack: list[list[Tree]] = [[]]
        at, line = 0, 1
        while at < len(self.text):
            match = _TOKEN.match(self.text, at)
            word = Word(match[0] if match else self.text[at])
            word.line = line
            if match is None:
                raise self.error(word, f"{shown(word)} has no end; close the quotation")
            at, line = match.end(), line + word.count("\n")
            if word in "([":
                stack.append([])
                if len(stack) > MAX_DEPTH:
                    raise self.error(None, TOO_DEEP)
            elif word in ")]":
                if len(stack) == 1:
                    raise self.error(word, "a parenthesis closes that was not opened")
                closed = stack.pop()
                stack[-1].append(closed)
            elif not (word.isspace() or word.startswith(";")):
                stack[-1].append(word)
        if len(stack) > 1:
            raise self.error(stack[-1], "a parenthesis that opens here is not closed")
        return stack[0]


def _line(tree: Tree | None) -> int:
    while isinstance(tree, list):
        tree = next((part for part in tree if part), None)
    return 0 if tree is None else tree.line


def _minus(*terms: Term) -> Term:
    return -terms[0] if len(terms) == 1 else reduce(lambda x, y: x - y, terms)


def _plus(*terms: Term) -> Term:
    return reduce(lambda x, y: x + y, terms)


def _times(*terms: Term) -> Term:
    return reduce(lambda x, y: x * y, terms)


def _quotient(*terms: Term) -> Term:
    """The quotient; of two numbers it is one number."""
    above, below = terms
    if above.op == below.op == "rational" and below.value:
        return as_term(above.value / below.value)
    return above / below


def _power(base: Term, exponent: Term) -> Term:
    found = exponent.value if exponent.op == "rational" else Fraction(0)
    if found == Fraction(1, 2):
        return sqrt(base)
    if found.denominator != 1 or not 0 < abs(found) < 1000:
        raise ValueError("an exponent has to be a whole number up to 999, and not 0")
    return base ** int(found) if found > 0 else 1 / base ** int(-found)


#: Operations by their names in these files, for terms.
OPERATIONS: dict[str, Callable[..., Term]] = {
    "+": _plus,
    "-": _minus,
    "*": _times,
    "/": _quotient,
    "^": _power,
    "pow": _power,
    **dict.fromkeys(("min", "fmin"), minimum),
    **dict.fromkeys(("max", "fmax"), maximum),
    **FUNCTIONS,
    "fabs": FUNCTIONS["abs"],
    **{name: getattr(terms, name) for name in ("atan", "sqrt", "exp", "log", "sin", "cos")},
}
#: Numbers by their names in FPCore.
NUMBERS: Mapping[str, Term] = {"PI": pi, "E": exp(1), "LN2": log(2), "LN10": log(10)}

RELATIONS = ("<", "<=", "=", ">=", ">", "==")


class Formulas:
    """Reads terms and comparisons, with the names that are known.

    ``claims`` has names of formulas, each with what is known where it was given its name.
    """

    def __init__(self, source: Source, names: Mapping[str, Term]) -> None:
        self.source, self.names = source, dict(names)
        self.claims: dict[str, tuple[Tree, Formulas]] = {}

    def copy(self) -> Formulas:
        """The same names, to which others may be added."""
        found = Formulas(self.source, self.names)
        found.claims = dict(self.claims)
        return found

    def term(self, tree: Tree) -> Term:
        """The term that a tree stands for.

        Raises:
            InputError: for another operation, or a name that is not known.
        """
        if isinstance(tree, Word):
            return self._leaf(tree)
        if not tree or not isinstance(tree[0], Word):
            raise self.source.error(tree, "an operation is missing after the parenthesis")
        op, arguments = tree[0], tree[1:]
        if op in ("let", "let*") and len(arguments) == 2:
            return self.within(op, arguments[0]).term(arguments[1])
        if not arguments:
            raise self.source.error(op, f"{shown(op)} stands alone; write what it is applied to")
        if op == "!":  # a term with its name
            return self.term(arguments[0])
        if op not in OPERATIONS:
            instead = nearest(op, OPERATIONS, f"write {', '.join(OPERATIONS)}")
            raise self.source.error(op, f"the operation {shown(op)} cannot be used; {instead}")
        terms = [self.term(argument) for argument in arguments]
        try:
            return OPERATIONS[op](*terms)
        except (TypeError, ValueError) as error:
            raise self.source.error(op, f"{shown(op)} of {len(terms)} terms: {error}") from error

    def _leaf(self, word: Word) -> Term:
        if _NUMBER.fullmatch(word):
            text = word.rstrip(".") if "." in word and word.endswith(".") else word
            return as_term(rational(f"{self.source.path}, line {word.line}", text.lstrip("+")))
        if word in self.names:
            return self.names[word]
        if word in NUMBERS:
            return NUMBERS[word]
        instead = nearest(word, self.names, "declare it before")
        raise self.source.error(word, f"{shown(word)} is not known; {instead}")

    def within(self, op: str, bindings: Tree) -> Formulas:
        """The same with the names of a ``let``; each of a ``let*`` knows those before it."""
        inner = self.copy()
        for name, body in self.source.pairs(bindings):
            reader = inner if op == "let*" else self
            inner.names[name] = reader.term(body)
        return inner

    def comparison(self, tree: list[Tree]) -> list[Claim]:
        """The claims of a chain ``(< a b c)``."""
        relation = "=" if tree[0] == "==" else str(tree[0])
        terms = [self.term(part) for part in tree[1:]]
        if len(terms) < 2:
            raise self.source.error(tree, f"{relation} needs at least two terms")
        if relation[0] == ">":
            relation, terms = "<" + relation[1:], terms[::-1]
        return [Claim(relation, left, right) for left, right in pairwise(terms)]
