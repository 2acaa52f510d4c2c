"""What is known by citations: constants and proved rows without variables, and contexts.

A context may be applied to values; its variables keep their own names, which the values replace.
"""

from __future__ import annotations

from verify.language.statement import Given, Statement
from verify.language.terms import Claim, Term, equal, substitute, substitute_claim, symbol
from verify.prover.universal import Universal


def make_known(prefix: str, statement: Statement, universal: Universal) -> None:
    """Afterwards what a cited statement proves of numbers is known, with a prefix to each name."""
    session = universal.session
    constants = {one.name: one.term for one in statement.constants}
    full = {name: symbol(prefix + name) for name in (*statement.parameters, *constants)}
    for name, term in {**statement.parameters, **constants}.items():
        definition = substitute(term, full)
        session.definitions[prefix + name] = definition
        universal.ground.know(prefix + name, definition)
        session.install(prefix + name, equal(full[name], definition), None)
    for context in statement.contexts:
        if context.parent is None:
            universal.contexts[prefix + context.name] = context._replace(
                givens=tuple(_renamed(given, full) for given in context.givens),
                constants=tuple(
                    one._replace(term=substitute(one.term, full)) for one in context.constants
                ),
            )
            session.parents[prefix + context.name] = None
    for row in statement.obligations:
        if row.context is None and isinstance(row.claim, Claim):
            session.install(prefix + row.name, substitute_claim(row.claim, full), None)
            universal.rows.add(prefix + row.name)


def _renamed(given: Given, names: dict[str, Term]) -> Given:
    return given._replace(claim=substitute_claim(given.claim, names))
