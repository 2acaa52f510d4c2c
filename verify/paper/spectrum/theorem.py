"""All spectral claims, assembled."""

from __future__ import annotations

from verify.language.statement import Statement
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
from verify.paper.spectrum.printed import THEOREM, Printed


def theorem(paper: Printed | None = None) -> Statement:
    """The statement, for the printed matrix and polynomial or for altered ones."""
    paper = Printed() if paper is None else paper
    sections = (collision_matrices, characteristic, real_root, complex_pair, cone, orbits)
    rows = [row for section in sections for row in section.rows(paper)]
    rows += [*linear_matrix.rows(), *zhou_kadanoff.rows()]
    return Statement(THEOREM, (), (), tuple(rows), ASSUMPTIONS)
