"""What a page of the paper says, by name, for tests that compare it with something else."""

from __future__ import annotations

from verify.language.statement import Context, Obligation
from verify.language.terms import Claim, Number, Term, as_term, symbol
from verify.paper.commands.pages import page


def context(name: str, which: str) -> Context:
    """The context of this name on a page."""
    return page(name).statement.context(which)


def rows(name: str, of: str | None = None) -> dict[str, Obligation]:
    """The rows of a page, or those in one context, by their names."""
    found = page(name).statement.obligations
    return {row.name: row for row in found if of in (None, row.context)}


def claim(name: str, row: str) -> Claim:
    """What a row of a page claims, if that is a comparison."""
    found = rows(name)[row].claim
    assert isinstance(found, Claim)
    return found


def headings(name: str) -> list[str]:
    """The headings of the rows of a page, in order."""
    return list(dict.fromkeys(row.group for row in page(name).statement.obligations))


class Variables:
    """The variables of a context, by their names without that of the context: `v.r` is `run.r`."""

    def __init__(self, name: str, which: str) -> None:
        self.context = context(name, which)
        self.names = [v.name.removeprefix(f"{which}.") for v in self.context.variables]

    def __getattr__(self, name: str) -> Term:
        """The variable."""
        return symbol(self.full(name))

    def full(self, name: str) -> str:
        """Its name in the statement."""
        return self.context.variables[self.names.index(name)].name

    def at(self, **values: Number) -> dict[str, Term]:
        """Values for all variables."""
        assert set(values) == set(self.names)
        return {self.full(name): as_term(value) for name, value in values.items()}
