"""All spectral claims, assembled, with what their rows do not prove.

A row proves its claim and nothing else. Where a sentence of the paper follows from rows by an
argument in words, the argument is one of the sentences here; the others are definitions.
"""

from __future__ import annotations

from collections.abc import Iterable

from verify.language.statement import Applies, Assumption, Cite, Context, Obligation, Statement
from verify.language.terms import Claim, names_of
from verify.paper.spectrum import (
    characteristic,
    collision_matrices,
    complex_pair,
    cone,
    orbits,
    real_root,
    zhou_kadanoff,
)
from verify.paper.spectrum.collision_matrices import DEFINITION, LAW_A, SPACE_F
from verify.paper.spectrum.complex_pair import COMPLEX_PAIR
from verify.paper.spectrum.orbits import COLLAPSE
from verify.paper.spectrum.printed import THEOREM, Printed
from verify.paper.spectrum.real_root import REAL_ROOT
from verify.paper.spectrum.section import LETTERS, SCOPES, placed, terms_of
from verify.paper.spectrum.zhou_kadanoff import EXISTENCE, RATE

ASSUMPTIONS = (
    Assumption("collision-law", LAW_A,
        "A collision of i and j along ω with normal component g = (v_i-v_j)·ω takes (1+r)/2 g ω "
        "from v_i and gives it to v_j (EQUATSS2.1VitesPost-Colli).", "definition"),
    Assumption("any-dimension", SPACE_F,
        "A vector of R^d is p ω₁ + q ω₂ + k e with a unit vector e orthogonal to both, and the "
        "collisions use nothing but inner products with ω₁, ω₂, ω₃ = ω₂-ω₁."),
    Assumption("signs", THEOREM,
        "Sums and products of positive numbers are positive; the square of a number is not "
        "negative; a linear form with coefficients ≥ 0, one of them > 0 at an argument < 0, is "
        "negative where all its arguments are; positive numbers stand as their squares do.",
        "general mathematics"),
    Assumption("intermediate-value", REAL_ROOT,
        "A continuous function takes every value between two of its values, and a strictly "
        "increasing one takes it once: Q has exactly one real root, between -r and -r³."),
    Assumption("every-r", COMPLEX_PAIR,
        "Every r in ]0,1[ is r(m) = m(4m²-m+1)/(m²-m+4) for exactly one m in ]0,1[ (rows "
        "m-denominator to m-increasing and the intermediate value theorem); a sum (λ-x)²+w with w "
        "> 0 has the roots x ± i√w, of squared modulus x²+w."),
    Assumption("polynomials", THEOREM,
        "A real cubic with leading coefficient 1 and negative discriminant has one real root and "
        "two complex conjugated ones; a polynomial whose discriminant is not 0 has distinct roots.",
        "general mathematics"),
    Assumption("linear-algebra", THEOREM,
        "Eigenvalues are the roots of the characteristic polynomial; n distinct ones of an n×n "
        "matrix have geometric multiplicity 1; a matrix with a minor of size n-1 that is not 0 "
        "has a kernel of dimension at most 1.", "general mathematics"),
    Assumption("monotone", THEOREM,
        "A function with positive second derivative whose first derivative changes sign decreases "
        "strictly up to a point and increases strictly from there.", "calculus"),
    Assumption("linear-model", DEFINITION,
        "The sentences on orbits concern the linear model: the velocities just before each triple "
        "0-1, 0-2, 1-2 are the images of the previous ones by the limiting matrix, and a "
        "collision takes place only if the normal component that it meets is negative.",
        "definition"),
    Assumption("spiral", THEOREM,
        "By the moduli of the eigenvalues an orbit converges exponentially to a multiple of "
        "(0,1,0,1); modulo it, the plane of the complex pair is the kernel of the left "
        "eigenvector for λ₀, and it is transverse to the kernel of a form that is no multiple of "
        "it."),
    Assumption("spectral-radius", RATE,
        "The rate of convergence that a limiting matrix gives is its spectral radius. The rows "
        "judge that rate alone: with a forcing term that is only summable the recursion need not "
        "converge exponentially at all."),
    Assumption("zhou-kadanoff", EXISTENCE,
        "1. The paper quotes the necessity of the first condition for the full dynamics; it is "
        "theorem II of the cited classification, which existence-cited applies. The inequality "
        "behind it is rate-existence.", "numbered glue"),
    Assumption("no-triangular-collapse", COLLAPSE,
        "2. That the triangular collapse, called a priori possible, does not exist in the full "
        "dynamics is theorem I of the cited classification, for three balls of equal mass and "
        "radius; full-jump and full-convex are computations behind it.", "numbered glue"),
)  # fmt: skip


TITLE = "Spectral claims of Section 5, its appendix and Sections 4.1-4.2, for every r in ]0,1["


def statement(classification: Cite, paper: Printed | None = None) -> Statement:
    """The statement, for the printed matrix and polynomial or for altered ones."""
    paper = Printed() if paper is None else paper
    sections = (collision_matrices, characteristic, real_root, complex_pair, cone, orbits)
    found = [row for section in sections for row in section.rows(paper)]
    found += [*zhou_kadanoff.linear_rows(), *zhou_kadanoff.rows()]
    rows = [placed(row) for row in found]
    contexts, cites = tuple(contexts_of(rows)), (classification,)
    return Statement(THEOREM, TITLE, {}, (), contexts, tuple(rows), ASSUMPTIONS, cites)


def contexts_of(rows: Iterable[Obligation]) -> list[Context]:
    """The contexts of some rows, with the symbols that occur in them."""
    names: dict[str, set[str]] = {}
    for row in rows:
        if row.context is not None and isinstance(row.claim, Claim | Applies):
            found = {name.rpartition(".")[2] for name in names_of(*terms_of(row.claim))}
            names.setdefault(row.context, set()).update(found)
    return [SCOPES[name].context(names[name], LETTERS) for name in SCOPES if name in names]
