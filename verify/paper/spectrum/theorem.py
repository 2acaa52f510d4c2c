"""All spectral claims, assembled."""

from __future__ import annotations

from collections.abc import Iterable

from verify.language.statement import Context, Obligation, Statement
from verify.language.terms import Claim, names_of
from verify.paper.spectrum import (
    characteristic,
    collision_matrices,
    complex_pair,
    cone,
    linear_matrix,
    orbits,
    real_root,
    zhou_kadanoff,
)
from verify.paper.spectrum.assumptions import ASSUMPTIONS
from verify.paper.spectrum.contexts import SCOPES
from verify.paper.spectrum.printed import THEOREM, Printed
from verify.paper.spectrum.section import LETTERS

TITLE = "Spectral claims of Section 5, its appendix and Sections 4.1-4.2, for every r in ]0,1["


def statement(paper: Printed | None = None) -> Statement:
    """The statement, for the printed matrix and polynomial or for altered ones."""
    paper = Printed() if paper is None else paper
    sections = (collision_matrices, characteristic, real_root, complex_pair, cone, orbits)
    rows = [row for section in sections for row in section.rows(paper)]
    rows += [*linear_matrix.rows(), *zhou_kadanoff.rows()]
    return Statement(THEOREM, TITLE, {}, (), tuple(contexts_of(rows)), tuple(rows), ASSUMPTIONS)


def contexts_of(rows: Iterable[Obligation]) -> list[Context]:
    """The contexts of some rows, with the symbols that occur in them."""
    names: dict[str, set[str]] = {}
    for row in rows:
        if row.context is not None and isinstance(row.claim, Claim):
            found = {name.rpartition(".")[2] for name in names_of(row.claim.lhs, row.claim.rhs)}
            names.setdefault(row.context, set()).update(found)
    return [SCOPES[name].context(names[name], LETTERS) for name in SCOPES if name in names]
