"""What is proved so far, and the steps that prove it: the mirror of the checker's kernel.

A session keeps the facts of each context, so that searches can use them, and writes down each step
in the order in which it was made. Nothing here is trusted: a step that proves nothing is refused
by `verify/check.py`.
"""

from __future__ import annotations

from collections.abc import Callable, Iterable, Mapping

from verify.language.record import Any
from verify.language.statement import Constant, Context, Obligation
from verify.language.terms import Claim, Term, as_term, equal
from verify.prover.proof import (
    ConstantStep,
    DefinitionStep,
    LemmaStep,
    ObligationStep,
    OpenStep,
    Premise,
    Proof,
    Step,
)

ZERO = as_term(0)


class Session:
    """Facts by name and by claim, in contexts, and the steps so far.

    ``prefix`` begins the names of lemmas that get no name of their own.
    """

    def __init__(self, prefix: str = "l") -> None:
        self.steps: list[Step] = []
        self.claims: dict[str, Claim] = {}
        self.homes: dict[str, str | None] = {}
        self.parents: dict[str | None, str | None] = {None: None}
        self.definitions: dict[str, Term] = {}
        self._known: dict[tuple[str | None, Claim], str] = {}
        self._prefix, self._count = prefix, 0

    def mark(self) -> Callable[[], None]:
        """What undoes all that is done from now on."""
        count, steps = self._count, len(self.steps)
        tables: list[dict[Any, Any]] = [
            self.claims,
            self.homes,
            self.parents,
            self.definitions,
            self._known,
        ]
        copies = [dict(table) for table in tables]

        def undo() -> None:
            self._count = count
            del self.steps[steps:]
            for table, copy in zip(tables, copies, strict=True):
                table.clear()
                table.update(copy)

        return undo

    # --- looking things up ----------------------------------------------------------------------

    def chain(self, context: str | None) -> Iterable[str | None]:
        """A context and those around it, from the inside out."""
        while context is not None:
            yield context
            context = self.parents[context]
        yield None

    def known(self, claim: Claim, context: str | None) -> str | None:
        """The name of a fact that is written like this and usable in the context, if any."""
        for place in self.chain(context):
            name = self._known.get((place, claim))
            if name is not None:
                return name
        return None

    def fresh(self) -> str:
        """A name for a lemma."""
        self._count += 1
        return f"{self._prefix}.{self._count}"

    # --- making facts ---------------------------------------------------------------------------

    def install(self, name: str, claim: Claim, context: str | None) -> str:
        """Remember a fact; return its name.

        Raises:
            ValueError: if the name is in use.
        """
        if name in self.claims:
            raise ValueError(f"the name {name} is in use")
        self.claims[name], self.homes[name] = claim, context
        self._known.setdefault((context, claim), name)
        return name

    def lemma(
        self, claim: Claim, proof: Proof, context: str | None = None, name: str | None = None
    ) -> str:
        """Prove a claim on the way; return the name of the fact."""
        name = self.fresh() if name is None else name
        self.steps.append(LemmaStep(name, context, claim, proof))
        return self.install(name, claim, context)

    def ensure(self, claim: Claim, proof: Proof, context: str | None = None) -> str:
        """The name of a fact that is usable in the context, or else is proved by this."""
        return self.known(claim, context) or self.lemma(claim, proof, context)

    def prove_row(self, row: Obligation, proof: Proof, *, holds: bool = True) -> None:
        """Write down the proof of an obligation, or of its negation."""
        self.steps.append(ObligationStep(row.name, proof))
        if holds and isinstance(row.claim, Claim):
            self.install(row.name, row.claim, row.context)

    def constant(self, constant: Constant, proof: Proof, context: str | None = None) -> Term:
        """Write down that a constant of the statement has a value; return it as a symbol."""
        self.steps.append(ConstantStep(constant.name, proof))
        return self._defined(constant.name, constant.term, context)

    def define(self, name: str, term: Term, proof: Proof, context: str | None = None) -> Term:
        """Introduce a name for a term; return it as a symbol."""
        self.steps.append(DefinitionStep(name, context, term, proof))
        return self._defined(name, term, context)

    def _defined(self, name: str, term: Term, context: str | None) -> Term:
        symbol = Term("symbol", name)
        self.definitions[name] = term
        self.install(name, equal(symbol, term), context)
        return symbol

    def open(self, context: Context, premises: Iterable[Premise]) -> None:
        """Write down that the givens of a context hold at its point; they are facts now."""
        self.parents[context.name] = context.parent
        self.steps.append(OpenStep(context.name, tuple(premises)))
        for given in context.givens:
            self.install(given.name, given.claim, context.name)

    # --- small proofs that are always the same --------------------------------------------------

    def replaced(self, names: Iterable[str]) -> Mapping[Term, Term]:
        """What an equation, or the definition of a name, replaces."""
        return {self.claims[name].lhs: self.claims[name].rhs for name in names}
