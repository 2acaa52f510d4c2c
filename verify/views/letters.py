"""The letters of a statement as they are shown: what looks alike in one sentence is told apart."""

from __future__ import annotations

import re
from collections import Counter
from collections.abc import Iterable, Iterator, Mapping

from verify.language.statement import Applies, Constant, Statement, Variable
from verify.language.terms import Claim, names_of

#: A name with a hyphen, which is a difference where formulas are typeset.
_HYPHENATED = re.compile(r"[A-Za-z][A-Za-z0-9_.]*(?:[-+][A-Za-z0-9_.]*)+", re.ASCII)
#: What stands for a number, and for no name.
_NUMBER = re.compile(r"[0-9./]+|π|\\pi ?")

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
    if is_alike or _NUMBER.fullmatch(one.letter) or _NUMBER.fullmatch(one.tex):
        return one.name, rf"\texttt{{{one.name}}}"
    if _HYPHENATED.fullmatch(one.letter) and one.tex in ("", one.letter):
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
