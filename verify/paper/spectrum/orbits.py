"""Whether an orbit of the linear model can stay in the cone, and for how long.

Let c_0, c_1, c_2, ... be the normal components met successively by 0-1, 0-2, 1-2, 0-1, ... In the
triangle each collision turns its own normal component g into -r g and adds -h g to both others,
h = (1+r)/4. Hence c_{n+3} + h c_{n+2} + h c_{n+1} + r c_n = 0, with positive coefficients: four
successive ones are never all negative.
"""

from __future__ import annotations

from collections.abc import Iterator
from fractions import Fraction

from verify.language.statement import Obligation
from verify.language.terms import Term, as_term, equal, substitute, symbol
from verify.paper.rows import REMARK
from verify.paper.spectrum.characteristic import lam
from verify.paper.spectrum.collision_matrices import A_A, A_B, A_C
from verify.paper.spectrum.complex_pair import FIXED, REAL_EIGENVECTOR, m, modulus, r_of_m
from verify.paper.spectrum.cone import BOUND, NORMAL_12, STATE, a, b, normal_12
from verify.paper.spectrum.matrices import Vector, apply, dot, product_of, sum_of, vector
from verify.paper.spectrum.printed import THEOREM, Printed, h, r, root_3
from verify.paper.spectrum.section import APPROACH, LARGE, LINE, SMALL, Section, symbols

COLLAPSE = "DEFINSS3.5CollapseTriangu"
ORDER = "EQUATSS3.5ConclusionEta1>"

x, y, z, t = STATE
c_0, c_1, c_2 = symbols("c_0 c_1 c_2")
c = symbol("c")

#: The normal components of 0-1, 0-2 and 1-2 as rows in the printed coordinates.
NORMALS: tuple[Vector, ...] = (vector(1, 0, 0, 0), vector(0, 0, 1, 0), NORMAL_12)

_eighth = as_term(Fraction(1, 8))

_section = Section("orbits")
needed, misprint = _section.needed, _section.misprint


def rows(paper: Printed) -> Iterator[Obligation]:
    """Yield the rows on orbits of the linear model, and two on the full dynamics."""
    yield from _recurrence(paper)
    yield from _one_triple(paper)
    yield from _first_condition_alone(paper)
    yield from _printed_cone()
    yield from _formal_paragraph(paper)
    yield from _full_dynamics()


def _recurrence(paper: Printed) -> Iterator[Obligation]:
    weights = symbols("u_1 u_2 u_3")
    for name, matrix, own in (("01", A_A, 0), ("02", A_B, 1), ("12", A_C, 2)):
        before = [dot(normal, STATE) for normal in NORMALS]
        after = [dot(normal, apply(matrix, STATE)) for normal in NORMALS]
        expected = [
            -r * value if i == own else value - h * before[own] for i, value in enumerate(before)
        ]
        yield needed(f"normal-components-{name}", THEOREM, f"the collision {name[0]}-{name[1]} "
            "turns its own normal component g into -rg and adds -(1+r)/4 g to both others (the "
            "three components weighted by u)",
            equal(dot(weights, after), dot(weights, expected)))  # fmt: skip
    first = met(STATE)
    second = met(apply(paper.matrix, STATE))
    sequence = [*first, *second]
    for k in range(3):
        yield needed(f"recurrence-{k + 1}", THEOREM, f"c_{k + 3} + h c_{k + 2} + h c_{k + 1} + r "
            f"c_{k} = 0 along an orbit of the printed matrix", equal(sequence[k + 3]
            + h * sequence[k + 2] + h * sequence[k + 1] + r * sequence[k], 0))  # fmt: skip
    mu = symbol("mu")
    p_1, p_2, p_3 = mu**3 + r, h * mu, h * mu**2
    yield needed("norm", THEOREM, "the eigenvalues other than 1 are the cubes of the roots of "
        "P(μ) = μ³+hμ²+hμ+r: Q(μ³) = P(μ) P(ωμ) P(ω²μ), where ω³ = 1",
        equal(paper.q(mu**3), (p_1 + p_2 + p_3) * (p_1**2 + p_2**2 + p_3**2 - p_1
        * p_2 - p_2 * p_3 - p_3 * p_1)))  # fmt: skip


def met(state: Vector) -> tuple[Term, Term, Term]:
    """The normal components that the next three collisions meet."""
    return state[0], state[2] - h * state[0], normal_12(state[0], state[2], state[3] - state[1])


def _one_triple(paper: Printed) -> Iterator[Obligation]:
    uses = ["signs", "linear-model"]
    # The state with normal components -a, -b, -c met in turn; t is arbitrary.
    third = -(h * a) - b
    difference = 2 * root_3 / 3 * (-c + (a - third) / 2 - h * a - h * b)
    state = (-a, t - difference, third, t)
    found = met(state)
    for k, (value, expected) in enumerate(zip(found, (-a, -b, -c), strict=True)):
        if k:
            yield needed(f"one-triple-state-{k}", THEOREM,
                f"the state x = -a, z = hx - b, t - y = δ meets c_{k} < 0; a, b, c > 0 are any",
                equal(value, expected))  # fmt: skip
    yield from (
        needed("one-triple",      BOUND, "a triple of collisions that takes place (a, b, c > 0) "
            "ends with x' = ra + hb + hc > 0: 0-1 recedes, so an orbit has at most one triple, "
            "for every r", equal(apply(paper.matrix, state)[0], r * a + h * b + h * c), uses),
        needed("one-triple-sign", BOUND, "h is positive", 0 < h, uses),
    )  # fmt: skip


def _first_condition_alone(paper: Printed) -> Iterator[Obligation]:
    a_0, a_1, a_2, _ = paper.coefficients
    uses = ["signs"]
    states = [STATE]
    for _ in range(3):
        states.append(apply(paper.matrix, states[-1]))
    n_1, n_0 = as_term(Fraction(11, 64)), as_term(Fraction(15, 1024))
    multiple = (
        n_0 * a_0,
        n_1 * a_0 + n_0 * a_1,
        a_0 + n_1 * a_1 + n_0 * a_2,
        a_1 + n_1 * a_2 + n_0,
        a_2 + n_1,
    )
    powers = (as_term(1), lam, lam**2, lam**3, lam**4)
    yield from (
        needed("x-recurrence", THEOREM,
            "x_{k+3} + a₂ x_{k+2} + a₁ x_{k+1} + a₀ x_k = 0 along every orbit",
            equal(states[3][0] + a_2 * states[2][0] + a_1 * states[1][0] + a_0 * x, 0)),
        needed("x-multiple",   THEOREM,
            "a multiple of Q with positive coefficients: Q(λ)(λ²+11λ/64+15/1024)",
            equal(paper.q(lam) * (lam**2 + n_1 * lam + n_0), lam**5 + dot(multiple, powers))),
    )  # fmt: skip
    for k, value in enumerate(multiple):
        yield needed(f"x-multiple-{k}", THEOREM, f"its coefficient of λ^{k} is positive, so that "
            "no orbit has six successive x < 0, whatever else it does", 0 < value,
            uses)  # fmt: skip
    # Five successive ones occur at r = 1/100.
    known = [as_term(-1), as_term(Fraction(-1, 400)), as_term(Fraction(-9, 10000))]
    hundredth = as_term(Fraction(1, 100))
    at = [substitute(value, {"r": hundredth}) for value in (a_0, a_1, a_2)]
    for _ in range(3):
        known.append(-(at[2] * known[-1]) - at[1] * known[-2] - at[0] * known[-3])
    says = "five are possible: r = 1/100, x₀ = -1, x₁ = -1/400, x₂ = -9/10000 give"
    yield from (
        needed("x-five-3", THEOREM, f"{says} x₃ < 0", known[3] < as_term(0)),
        needed("x-five-4", THEOREM, f"{says} x₄ < 0", known[4] < as_term(0)),
        needed("x-five-5", THEOREM, f"{says} x₅ > 0", 0 < known[5]),
    )  # fmt: skip


def sequence(first: Term, second: Term, third: Term, length: int) -> list[Term]:
    """The solution of the recurrence with these first values."""
    values = [first, second, third]
    while len(values) < length:
        values.append(-(h * values[-1]) - h * values[-2] - r * values[-3])
    return values


def _printed_cone() -> Iterator[Obligation]:
    uses = ["signs", "linear-model"]
    c_ = sequence(c_0, c_1, c_2, 7)
    n_4 = h - h**2 + r - _eighth
    n_3 = _eighth + h * (r - _eighth) - h**2 + r
    n_1 = h / 8 + r * (r - _eighth)
    yield needed("C1", BOUND, "the cone of the two conditions alone: c₆ + n₄c₄ + n₃c₃ + n₁c₁ + "
        "(r/8)c₀ = 0, so that c₀, c₁, c₃, c₄ < 0 give x₂ = c₆ > 0: at most two successive states, "
        "for every r",
        equal(c_[6] + n_4 * c_[4] + n_3 * c_[3] + n_1 * c_[1] + r * _eighth * c_[0], 0),
        uses)  # fmt: skip
    for k, value in ((4, n_4), (3, n_3), (1, n_1)):
        yield needed(f"C1-n{k}", BOUND, f"n_{k} is positive", 0 < value, uses)
    tenth = as_term(Fraction(-1, 10))
    at = sequence(tenth, tenth, as_term(1), 5)
    for k in (3, 4):
        yield needed(f"C1-two-{k}", BOUND,
            f"two are possible for every r: c₀ = c₁ = -1/10, c₂ = 1 give c_{k} < 0",
            at[k] < as_term(0))  # fmt: skip
    yield from _cone_c2(c_, uses)


def _cone_c2(c_: list[Term], uses: list[str]) -> Iterator[Obligation]:
    """The cone C_2: in the normal components, sqrt(3)/2 (t - y) is a linear form."""
    image = tangential(c_[3], c_[4], c_[5])
    k = (3 * r - 1) / (1 + r)
    start = -((1 - 3 * r) / 4)
    at = sequence(start, start, as_term(1), 6)
    says = "for r < 1/3 two are possible: c₀ = c₁ = -(1-3r)/4, c₂ = 1 give"
    yield from (
        needed("C2-form",         BOUND,
            "(√3/2)(t-y) = c₂ - (1-h)/2 c₀ - (1/2-h) c₁ for every state",
            equal(root_3 / 2 * (t - y), tangential(*met(STATE)))),
        needed("C2-image",        BOUND, "(√3/2)(t'-y') = (r/2)c₀ + ((5r+1)/8)c₁ + ((1-3r)/4)c₂",
            equal(image, r / 2 * c_0 + (5 * r + 1) / 8 * c_1 + (1 - 3 * r) / 4 * c_2)),
        needed("C2-large-r",      BOUND, "the same in c₀, c₁, c₃, which are negative if two "
            "successive states lie in the cone; so for r > 1/3 two are impossible", equal(image,
            r * (as_term(1) / 2 + k) * c_0 + ((5 * r + 1) / 8 + k * h) * c_1 + k * c_[3]), uses),
        needed("C2-large-r-sign", BOUND, "3r - 1 > 0 for r > 1/3",
            0 < 3 * r - 1, uses, context=LARGE),
    )  # fmt: skip
    for name, what, value in (
        ("c0", "c₀ < 0", start),
        ("c3", "c₃ < 0", at[3]),
        ("c4", "c₄ < 0", at[4]),
        ("y", "y < t", -tangential(*at[:3])),
        ("y-next", "y' < t'", -tangential(*at[3:6])),
    ):
        yield needed(f"C2-two-{name}", BOUND, f"{says} {what}", value < as_term(0), context=SMALL)


def tangential(first: Term, second: Term, third: Term) -> Term:
    """(sqrt(3)/2)(t - y) from the three normal components met next."""
    return third - (1 - h) / 2 * first - (as_term(1) / 2 - h) * second


def _formal_paragraph(paper: Printed) -> Iterator[Obligation]:
    c_ = sequence(c_0, c_1, c_2, 4)
    at_m = [substitute(value, {"r": r_of_m}) for value in c_]
    h_m = substitute(h, {"r": r_of_m})
    weights = (modulus, h_m - m, as_term(1))
    k = symbol("k")
    orbit = [
        -entry if fixed == as_term(0) else sum_of(-entry, product_of(k, fixed))
        for entry, fixed in zip(REAL_EIGENVECTOR, FIXED, strict=True)
    ]
    first_row = [substitute(entry, {"r": r_of_m}) for entry in paper.matrix[0]]
    yield from (
        needed("spiral-plane",      THEOREM, "the plane of the spiral is where ψ = (r/m)c₀ + "
            "(h-m)c₁ + c₂ vanishes: one collision multiplies ψ by -m, at r = r(m)",
            equal(dot(weights, at_m[1:4]), -m * dot(weights, at_m[:3])), ["every-r", "spiral"]),
        needed("spiral-transverse", THEOREM, "it is transverse to x = 0, to z = hx and to y = t: "
            "their forms are no multiples of ψ, because r/m > 0 and -(1-h)/2 < 0", 0 < (1 - h) / 2,
            ["spiral"]),
        misprint("manifold",        THEOREM, "the text confines a triangular collapse to a "
            "manifold of dimension 1 and does not claim that its orbits stay in the cone: those "
            "of E₁ + ker(𝔄-λ₀) with x = -1 keep x' < 0 (r = r(m))",
            dot(first_row, orbit) < as_term(0), REMARK, "manifold-empty", context=LINE),
        needed("manifold-empty",    THEOREM,
            "these orbits have x' = m³ > 0: they leave the cone at once, and the manifold is empty",
            equal(dot(first_row, orbit), m**3), ["every-r"], context=LINE),
    )  # fmt: skip


def _full_dynamics() -> Iterator[Obligation]:
    g, cosine, p, q = symbols("g cosine p q")
    uses = ["no-triangular-collapse"]
    p_1, p_2, q_1, q_2 = symbols("p_1 p_2 q_1 q_2")
    yield from (
        needed("full-jump",   ORDER, "a collision of i with k, normal component g < 0, changes "
            "(v_j-v_i)·e by -(1+r)/2 g times the cosine of the angle at i: p = v_j·e, q = v_i·e, "
            "and n·e is minus that cosine",
            equal((p - (q - (1 + r) / 2 * g * -cosine)) - (p - q), -((1 + r) / 2 * g * cosine)),
            uses, context=APPROACH),
        needed("full-convex", COLLAPSE, "|W|²ρ² - (W·x)² is a square in the plane of W and x: the "
            "distance ρ is convex in free flight",
            equal((p_1**2 + p_2**2) * (q_1**2 + q_2**2) - (p_1 * q_1 + p_2 * q_2) ** 2,
            (p_1 * q_2 - p_2 * q_1) ** 2), uses),
    )  # fmt: skip
