"""Statements of one's own, in a few lines: what `from verify import …` offers.

Names, claims and values are all that is needed; labels and letters are left empty.
"""

from __future__ import annotations

from collections.abc import Iterable, Mapping

from verify.language.statement import (
    NEEDED,
    Assumption,
    Constant,
    Context,
    Given,
    Obligation,
    Statement,
    Variable,
)
from verify.language.terms import Claim, Number, as_term, symbol
from verify.prover.budget import WorkBudget
from verify.prover.outcome import Outcome
from verify.wire.questions import decide
from verify.wire.write import write


def constant(name: str, value: Number) -> Constant:
    """A number with a name: an exact one, or a term over earlier names."""
    return Constant(name, name, name, "", as_term(value))


def for_all(name: str, givens: Mapping[str, Claim], point: Mapping[str, Number]) -> Context:
    """All values with these givens; ``point`` has for each variable a value that is one of them."""
    return Context(
        name,
        tuple(Variable(v, v, v) for v in point),
        tuple(Given(given, claim) for given, claim in givens.items()),
        {v: as_term(value) for v, value in point.items()},
    )


def ask(
    name: str, claim: Claim, within: Context | None = None, uses: Iterable[Assumption] = ()
) -> Obligation:
    """The question whether a claim holds, for all values of a context if it is about one.

    ``uses`` are the assumptions without which it would not say what it should.
    """
    names = tuple(assumption.name for assumption in uses)
    context = None if within is None else within.name
    return Obligation(name, "", "", NEEDED, "", claim, uses=names, context=context)


def assume(name: str, sentence: str) -> Assumption:
    """A sentence that is used and not proved."""
    return Assumption(name, "", sentence, "assumption")


def lemma(
    title: str,
    questions: Iterable[Obligation],
    constants: Iterable[Constant] = (),
    contexts: Iterable[Context] = (),
    assumptions: Iterable[Assumption] = (),
) -> Statement:
    """A statement, for `verify.prove`."""
    return Statement(
        title, title, {}, tuple(constants), tuple(contexts), tuple(questions), tuple(assumptions)
    )


def prove(statement: Statement, budget: WorkBudget | None = None) -> Outcome:
    """The statement with its rows decided, where that is found; the checker accepts the proofs.

    ``budget`` is how much work each row may be, and how long all of them may take.

    Raises:
        InputError: for a statement that the checker cannot read.
        OwnError: if the checker refuses a proof.
    """
    return decide(statement, budget)


def certificate(outcome: Outcome) -> dict[str, bytes]:
    """The files of a certificate, by name, for `verify.check.check` or for a folder."""
    return write(outcome)


__all__ = ["ask", "assume", "certificate", "constant", "for_all", "lemma", "prove", "symbol"]
