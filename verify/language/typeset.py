"""Terms and claims as people write them: plain text in the paper's letters, and which those are.

What looks alike in one sentence is told apart.
"""

from __future__ import annotations

import re
from collections import Counter
from collections.abc import Iterable, Iterator, Mapping
from functools import lru_cache

from verify.language.statement import Always, Applies, Constant, Statement, Variable
from verify.language.terms import Claim, Term, names_of, signs_in

_SUM, _PRODUCT, _NEGATION, _POWER, _ATOM = range(5)
_LEVELS = {
    "add": _SUM,
    "sub": _SUM,
    "mul": _PRODUCT,
    "div": _PRODUCT,
    "neg": _NEGATION,
    "pow": _POWER,
}
_SUPERSCRIPTS = str.maketrans("0123456789", "⁰¹²³⁴⁵⁶⁷⁸⁹")
#: What people write for functions where it is not the name of the operation.
FUNCTION_NAMES = {"atan": "arctan"}
#: A longer formula is left to the file with the statement, in which shared parts have names.
MAX_SIGNS = 1 << 15
#: So is a formula with more operations inside of one another: nobody can read it.
MAX_LEVELS = 100
LONG = "(long: see the statement file)"
_BINARY = ("add", "sub", "mul", "div")

_SPELLED = ((r"\cdot", "·"), (r"\sqrt", "√"), ("−", "-"))
_BRACKETS = r"\([^()]*\)|\{[^{}]*\}|\|[^|]*\|"
#: A function of what follows, or signs of a sum behind the first.
_OF_A_SUM = r"(?<![A-Za-z])(?:cos|sin|tan|exp|log|ln)(?![A-Za-z])|.[-+]"
#: Signs of a product, and what stands beside another without one.
_OF_A_PRODUCT = r"[/·]|.\*\w|[⁰¹²³⁴⁵⁶⁷⁸⁹ⁿ][^\W\d_]|^[0-9]+[^\W\d]"
_OF_A_POWER = r"[⁰¹²³⁴⁵⁶⁷⁸⁹ⁿ]|^√"


#: A longer letter is taken for a sum.
MAX_LETTER = 200


@lru_cache(1000)
def level_of(letter: str) -> int:
    """How tightly a letter, plain or in LaTeX, holds together: as the term that it looks like.

    The letters 1+d', -η and r^(1/3) stand for one symbol, and are read as a sum, a negation and a
    power; what is in brackets, in an index or in an exponent does not matter.
    """
    if len(letter) > MAX_LETTER:
        return _SUM
    for sign, other in _SPELLED:
        letter = letter.replace(sign, other)
    rest, before = letter, ""
    while rest != before:
        rest, before = re.sub(_BRACKETS, "x", rest), rest
    is_power = "^" in rest
    rest = re.sub(r"[\^_].", "", rest)
    if re.search(_OF_A_SUM, rest):
        return _SUM
    if re.search(_OF_A_PRODUCT, rest) or rest.startswith("-"):
        return _NEGATION
    return _POWER if is_power or re.search(_OF_A_POWER, rest) else _ATOM


class Lengths:
    """How long and how deep terms are, each part written wherever it stands, in given letters.

    Args:
        letters: what is written for each symbol; a file may have letters of any length.
    """

    def __init__(self, letters: Mapping[str, str]) -> None:
        self._letters = letters
        self._known: dict[Term, tuple[int, int]] = {}

    def is_long(self, *terms: Term) -> bool:
        """Whether terms are together longer, or one of them is deeper, than they are written."""
        sizes = [self._size(term) for term in terms]
        return sum(signs for signs, _ in sizes) > MAX_SIGNS or any(n > MAX_LEVELS for _, n in sizes)

    def is_long_claim(self, claim: Claim | Applies | Always) -> bool:
        """Whether a claim is longer or deeper than it is written."""
        if isinstance(claim, Claim):
            return self.is_long(claim.lhs, claim.rhs)
        tables = (claim.at,) if isinstance(claim, Applies) else (claim.start, claim.next)
        return self.is_long(*(term for table in tables for term in table.values()))

    def _size(self, term: Term) -> tuple[int, int]:
        found = self._known.get(term)
        if found is None:
            if term.op == "symbol":
                found = len(self._letters.get(term.name) or term.name), 0
            elif not term.children:
                found = signs_in(term), 0
            else:
                sizes = [self._size(child) for child in term.children]
                found = sum(signs for signs, _ in sizes) + 1, max(n for _, n in sizes) + 1
            self._known[term] = found
        return found


class Typesetter:
    """Writes terms with given letters.

    Args:
        letters: what to write for each symbol.
    """

    def __init__(self, letters: Mapping[str, str]) -> None:
        self.letters, self.lengths = letters, Lengths(letters)
        self._texts: dict[Term, str] = {}

    def claim(self, claim: Claim | Applies | Always) -> str:
        """``lhs < rhs``, ``lhs ≤ rhs`` or ``lhs = rhs``; or the values put into a context."""
        if self.lengths.is_long_claim(claim):
            return LONG
        if isinstance(claim, Applies):
            return f"{claim.context} at {self._values(claim.at)}"
        if isinstance(claim, Always):
            first, then = self._values(claim.start), self._values(claim.next)
            return f"{claim.context} always, from {first}, then {then}"
        relation = "≤" if claim.relation == "<=" else claim.relation
        return f"{self.term(claim.lhs)} {relation} {self.term(claim.rhs)}"

    def _values(self, values: Mapping[str, Term]) -> str:
        named = sorted(values.items())  # a table in a file has no other order
        pairs = ((self.letters.get(name, name), self.term(term)) for name, term in named)
        return ", ".join(f"{letter} = {text}" for letter, text in pairs)

    def term(self, term: Term) -> str:
        """The term, with as few parentheses as its reading needs, unless it is very long."""
        text = self._texts.get(term)
        if text is None:
            is_long = self.lengths.is_long(term)
            text = self._texts[term] = LONG if is_long else self._write(term)
        return text

    def _write(self, term: Term) -> str:
        op = term.op
        if op in _BINARY:
            return self._binary(op, *term.children)
        if op == "symbol":
            return self.letters.get(term.name, term.name)
        if op == "rational":
            return str(term.value)
        if op == "neg":
            return f"-{self._inside(term.children[0], _PRODUCT)}"
        if op == "pow":
            exponent = str(term.exponent).translate(_SUPERSCRIPTS)
            return self._inside(term.children[0], _ATOM) + exponent
        if op == "pi":
            return "π"
        if op in ("sqrt", "root"):
            index = str(term.exponent).translate(_SUPERSCRIPTS) if op == "root" else ""
            return f"{index}√{self._inside(term.children[0], _ATOM)}"
        return self._function(op, term)

    def _binary(self, op: str, left: Term, right: Term) -> str:
        if op == "add":
            return f"{self._inside(left, _SUM)} + {self._inside(right, _PRODUCT)}"
        if op == "sub":
            return f"{self._inside(left, _SUM)} - {self._inside(right, _PRODUCT)}"
        sign = "/" if op == "div" else "·"
        level = _POWER if op == "div" else _NEGATION
        return f"{self._inside(left, _PRODUCT)}{sign}{self._inside(right, level)}"

    def _inside(self, term: Term, level: int) -> str:
        text = self.term(term)
        own = _LEVELS.get(term.op, _ATOM)
        if term.op == "symbol":
            own = level_of(text)
        if term.op == "rational" and (term.value < 0 or term.value.denominator > 1):
            own = _NEGATION if term.value < 0 else _PRODUCT
        return text if own >= level else f"({text})"

    def _function(self, op: str, term: Term) -> str:
        if op == "cos_pi":
            name, arguments = "cos", self._inside(term.children[0], _ATOM) + "π"
        else:
            name = FUNCTION_NAMES.get(op, op)
            arguments = ", ".join(map(self.term, term.children))
        return f"{name}({arguments})"


# --- letters --------------------------------------------------------------------------------------

#: A name with a hyphen, which is a difference where formulas are typeset.
_HYPHENATED = r"[A-Za-z][A-Za-z0-9_.]*(?:[-+][A-Za-z0-9_.]*)+"
#: What stands for a number, and for no name.
_NUMBER = r"[0-9./]+|π|\\pi ?"

Letters = Mapping[str, tuple[str, str]]


def letters_apart(statement: Statement) -> Letters:
    """For each constant and variable its letter, plain and in LaTeX.

    Two that have one letter and occur in one sentence are shown by their names, and so is what has
    a number as its letter. In LaTeX these names, and others with a hyphen, are in typewriter type.
    """
    symbols = {one.name: one for one in _symbols(statement)}
    alike = _alike(statement, symbols)
    return {name: _shown(one, is_alike=name in alike) for name, one in symbols.items()}


def _symbols(statement: Statement) -> Iterator[Constant | Variable]:
    yield from statement.constants
    for context in statement.contexts:
        yield from context.variables
        yield from context.constants


def _shown(one: Constant | Variable, *, is_alike: bool) -> tuple[str, str]:
    if is_alike or re.fullmatch(_NUMBER, one.letter) or re.fullmatch(_NUMBER, one.tex):
        return one.name, rf"\texttt{{{one.name}}}"
    if re.fullmatch(_HYPHENATED, one.letter) and one.tex in ("", one.letter):
        return one.letter, rf"\texttt{{{one.letter}}}"
    return one.letter or one.name, one.tex


def _alike(statement: Statement, symbols: Mapping[str, Constant | Variable]) -> set[str]:
    """The names that have the letter of another one in one sentence of the statement."""
    kinds = [{name: one.letter or name for name, one in symbols.items()}]
    kinds.append({name: one.tex or name for name, one in symbols.items()})
    found: set[str] = set()
    shared = [{c for c, n in Counter(kind.values()).items() if n > 1} for kind in kinds]
    several = {
        name
        for kind, common in zip(kinds, shared, strict=True)
        for name, letter in kind.items()
        if letter in common
    }
    for sentence in _sentences(statement) if several else ():
        names = several & {*sentence}
        for kind in kinds if len(names) > 1 else ():
            count = Counter(kind[name] for name in names)
            found |= {name for name in names if count[kind[name]] > 1}
    return found


def _sentences(statement: Statement) -> Iterator[Iterable[str]]:
    """The names that occur together: in a claim, in a definition, as variables of a context."""
    for context in statement.contexts:
        yield [variable.name for variable in context.variables]
        yield from (names_of(g.claim.lhs, g.claim.rhs) for g in context.givens)
        yield from map(_definition, context.constants)
    yield from map(_definition, statement.constants)
    for row in statement.obligations:
        claim = row.claim
        if isinstance(claim, Claim):
            yield names_of(claim.lhs, claim.rhs)
            continue
        for values in (claim.at,) if isinstance(claim, Applies) else (claim.start, claim.next):
            yield from ([*values], names_of(*values.values()))


def _definition(constant: Constant) -> Iterable[str]:
    """The names in a definition; one that only names another constant anew may have its letter."""
    return () if constant.term.op == "symbol" else {constant.name, *names_of(constant.term)}
