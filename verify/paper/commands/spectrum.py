"""The job `spectrum`: the page `spectrum`, all of whose claims the search decides."""

from __future__ import annotations

from verify.language.statement import Statement
from verify.language.terms import Claim, Term
from verify.paper.commands import pages
from verify.prover.outcome import Outcome

PAGE = "spectrum"


def state_spectrum() -> Statement:
    """What is claimed, for every r in (0, 1)."""
    return pages.statement(PAGE)


def cite_spectrum() -> Outcome:
    """Every row, from the certificate that comes with the program; else decided anew."""
    return pages.accepted(PAGE, anew=False)


def roots_of_q() -> tuple[Term, Term, Term]:
    """Terms in m: r, and the real part and the squared imaginary part of the complex roots of Q.

    They are read off the rows `viete` and `modulus`; the real root is -m^3.
    """
    viete, modulus = _claim("viete"), _claim("modulus")
    (restitution,), (real_part, imaginary_square) = viete.rhs.children, modulus.lhs.children
    return restitution, real_part.children[0], imaginary_square


def _claim(name: str) -> Claim:
    (found,) = (row.claim for row in state_spectrum().obligations if row.name == name)
    if not isinstance(found, Claim):
        raise TypeError(f"the row {name} compares no numbers")
    return found
