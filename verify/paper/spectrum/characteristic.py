"""The characteristic polynomial (appendix), its factor Q, and the symmetry of its coefficients."""

from __future__ import annotations

from collections.abc import Iterator

from verify.language.statement import Obligation
from verify.language.terms import Term, as_term, equal, substitute, symbol
from verify.paper.spectrum.collision_matrices import COLUMN, ROW
from verify.paper.spectrum.matrices import Matrix, Vector, determinant, form, identity_minus, vector
from verify.paper.spectrum.printed import Q_LABEL, THEOREM, Printed, r, root_3
from verify.paper.spectrum.section import Section

APPENDIX = "APPENSS___PolynChara_Alim"
CHARACTERISTIC = "EQUATSS3.5Alim_PolynCarac"

lam = symbol("lambda")

_FIRST = vector(lam + (12 * r**2 + 72 * r - 4) / 64, 0, -lam + (-12 * r + 4) / 16, 0)
_SECOND = root_3 * (-4 * r**2 - 24 * r - 20) / 64, lam - 1, root_3 * (4 * r + 4) / 16
_THIRD = ((r**3 - 17 * r**2 - 13 * r + 5) / 64, -(root_3 * (r + 1) / 8),
          lam + (-(r**2) + 16 * r + 1) / 16)  # fmt: skip
_FOURTH = (root_3 * (16 * r**2 - 16) / 64, as_term(0),
           -(root_3 * lam) + root_3 * (-16 * r) / 16)  # fmt: skip

#: The four matrices whose determinants the appendix displays.
DETERMINANTS: tuple[Matrix, ...] = (
    (_FIRST, vector(*_SECOND, lam - 1), vector(*_THIRD, root_3 * (r + 1) / 8),
     vector(root_3 * (r**3 - r**2 - 13 * r - 11) / 64, -((3 * r + 3) / 8),
            -(root_3 * (r**2 - 1) / 16), lam + (-5 + 3 * r) / 8)),
    (_FIRST, vector(*_SECOND, lam - 1), vector(*_THIRD, root_3 * (r + 1) / 8),
     vector(*_FOURTH, lam - 1)),
    (_FIRST, vector(*_SECOND, 2 * (lam - 1)), vector(*_THIRD, 0), vector(*_FOURTH, lam - 1)),
    (_FIRST, vector(*_SECOND, 2), vector(*_THIRD, 0), vector(*_FOURTH, 1)),
)  # fmt: skip

_section = Section("characteristic polynomial")
needed, printed = _section.needed, _section.printed


def rows(paper: Printed) -> Iterator[Obligation]:
    """Yield the rows of the appendix, of the factorisation and of the remark on a_1 and a_2."""
    yield from _appendix(paper)
    yield from (
        needed("characteristic",  CHARACTERISTIC, "det(λI - 𝔄) = (λ-1) Q(λ)",
            equal(determinant(identity_minus(lam, paper.matrix)), (lam - 1) * paper.q(lam))),
        needed("Q-at-1", THEOREM, "Q(1) = 27(1+r)³/32", equal(paper.q(1), 27 * (1 + r) ** 3 / 32)),
        needed("Q-at-1-positive", THEOREM, "1 is not a root of Q", 0 < 27 * (1 + r) ** 3 / 32),
    )  # fmt: skip
    yield from _symmetry(paper)


def _appendix(paper: Printed) -> Iterator[Obligation]:
    row_1, row_2, row_3, row_4 = identity_minus(lam, paper.matrix)
    first, second, third, fourth = DETERMINANTS
    combined = (_sum(row_1, row_3, as_term(-1)), _sum(row_2, row_4, as_term(1)), row_3, row_4)
    reduced = (*first[:3], _sum(first[3], first[2], -root_3))
    added = tuple((a, b, c, d + b) for a, b, c, d in second)
    factored = tuple((a, b, c, (lam - 1) * d) for a, b, c, d in fourth)
    steps = (
        ("L₁-L₃ and L₂+L₄ give the first displayed determinant", combined, first),
        ("L₄-√3 L₃ gives the second one", reduced, second),
        ("C₄+C₂ gives the third one", added, third),
        ("λ-1 is taken out of the fourth column", factored, third),
    )
    for number, (says, computed, displayed) in enumerate(steps, 1):
        yield printed(f"appendix-step-{number}", APPENDIX, f"{says}: u A v = u B v for all u, v",
            equal(form(ROW, computed, COLUMN), form(ROW, displayed, COLUMN)))  # fmt: skip
    value = (lam - 1) * paper.q(lam)
    for number, matrix in enumerate(DETERMINANTS[:3], 1):
        yield printed(f"appendix-determinant-{number}", APPENDIX,
            f"the displayed determinant {number} is (λ-1) Q(λ)",
            equal(determinant(matrix), value))  # fmt: skip
    yield printed("appendix-determinant-4", APPENDIX, "the last displayed determinant is Q(λ)",
        equal(determinant(fourth), paper.q(lam)))  # fmt: skip


def _sum(row: Vector, other: Vector, factor: Term) -> Vector:
    return tuple(a + factor * b for a, b in zip(row, other, strict=True))


def _symmetry(paper: Printed) -> Iterator[Obligation]:
    _, a_1, a_2, _ = paper.coefficients
    p = symbol("p")
    displayed = -11 + 171 * r - 9 * r**2 + r**3
    product = r * p
    quotient = -11 * (product**2 + product + 1) + 171 * r * (product + 1) - 9 * r**2
    yield from (
        printed("symmetry-1", Q_LABEL, "the remark after the proof: a₁(1/r) = "
            "(-11+171r-9r²+r³)/(64r³); with p in place of 1/r and times 64r³, the difference is a "
            "multiple of rp-1",
            equal(64 * r**3 * substitute(a_1, {"r": p}) - displayed, (product - 1) * quotient)),
        printed("symmetry-2", Q_LABEL, "the remark after the proof: it is a₂(r)/r³, times 64r³",
            equal(displayed, 64 * a_2)),
    )  # fmt: skip
