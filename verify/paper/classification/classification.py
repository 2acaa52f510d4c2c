"""The four theorems as one statement: what they take on trust, and the order of their argument.

They rest on two definitions, four assumptions of mathematics, and glue.
"""

from __future__ import annotations

from functools import cache

from verify.language.argument import Argument
from verify.language.statement import Assumption, Obligation
from verify.paper.classification import (
    collision,
    comparison,
    flight,
    image,
    impulse,
    run,
    scenes,
    second,
    triangle,
)
from verify.paper.letters import sectioned

COLLAPSE = "DEFINSS3.1Collapse_Inelas"
TRIANGLE = "DEFINSS3.5CollapseTriangu"
EXISTENCE = "EQUATSS3.4ZKCl1CondiExist"
SECOND = "EQUATSS3.4ZKCl2CondiStabi"
LAW = "EQUATSS2.1VitesPost-Colli"

DEFINITIONS = (
    Assumption("hard-spheres",    LAW,
         "N balls have masses m_i > 0 and contact distances σ_ij > 0, and are never closer than "
         "these. They move freely between collisions. Two balls i and j collide when they are at "
         "the distance σ_ij with ρ_ij = e_ij·(v_j-v_i) < 0, e_ij the unit vector from i to j: then "
         "J e_ij is taken from the momentum of i and given to that of j, where J ≥ 0 leaves some "
         "ρ' with 0 ≤ ρ' ≤ -ρ, which may be another share of -ρ at each collision; the velocities "
         "of the others do not change. There is no triple contact: no ball that collides touches "
         "another one but its partner. So collisions at one time are of disjoint pairs, and count "
         "as one after the other, in any order. Up to each time before a collapse there are "
         "finitely many collisions; a collapse is the first time at which they accumulate. Where a "
         "theorem says so, masses are equal and ρ' = -rρ with one r in ]0,1].", "definition"),
    Assumption("alternating-run", EXISTENCE,
         "A run of k collisions: three balls of equal mass, one r; 0 collides with one and with "
         "the other in turn, and none of the three collides otherwise meanwhile. While another "
         "collision of the run follows, the ball c that did not just collide is apart from 0, "
         "approaches, and meets 0 after the time τ, at the smaller root of |x_c+τW_c|² = σ_c² and "
         "with positive closing speed. The number a is at least (1+r)/2 (-cos θ_n), for each n "
         "from 2 to k-1. (1+r)/2 is one such a, as -cos θ ≤ 1.", "definition"),
)  # fmt: skip

MATHEMATICS = (
    Assumption("cauchy-schwarz",   COLLAPSE,
         "(x·z)² ≤ |x|²|z|² for any two vectors of a Euclidean space, so that |x+z| ≤ |x|+|z|; "
         "N-tuples of vectors with the product Σ m_i x_i·z_i, all m_i > 0, are such a space, and "
         "so are bivectors with (x∧v)·(y∧w) = (x·y)(v·w) - (x·w)(v·y).", "general mathematics"),
    Assumption("bounded-monotone", COLLAPSE,
         "A bounded monotone sequence of real numbers converges; so a series of vectors converges "
         "if the partial sums of their lengths are bounded. Numbers ≥ 0 have the same sum in any "
         "order.", "general mathematics"),
    Assumption("finite-length",    COLLAPSE,
         "A continuous path on [0,T[, T finite or infinite, that consists of straight pieces, "
         "finitely many in each bounded closed part of [0,T[, and has finite length, has a limit "
         "at T.", "general mathematics"),
    Assumption("smooth-images",    COLLAPSE,
         "The image of a space of smaller dimension under a smooth map has measure zero, and so "
         "has the union of countably many sets of measure zero.", "general mathematics"),
)  # fmt: skip

GLUE = (
    Assumption("glue-lemma",          TRIANGLE,
         "1. Let a and b collide. Just after it ρ_ab ≥ 0, by restitution and "
         "collision-inelastic-lower. In flight ρ_ab does not fall, by flight-normal; a later "
         "collision of a, or of b, with a third ball does not lower it if the angle at the ball "
         "that is hit is at most a right one, by free-i, free-j, impulse-positive and acute-keeps; "
         "collisions of other balls do not change it. So if all later collisions of a and of b "
         "with others are such, then ρ_ab ≥ 0 for ever: their distance never decreases, by "
         "flight-tangent, and they never collide again, though they may stay in contact if ρ' = 0. "
         "In particular no pair collides twice without a collision of one of its balls with "
         "another one between.", "numbered glue"),
    Assumption("glue-classification", TRIANGLE,
         "2. Let three balls collapse at a finite time. Velocities are bounded, as e never rises, "
         "by energy-law and energy-falls; so paths have finite length and positions converge, to "
         "distances that are at least the contact distances. Let 12 be a pair of the largest "
         "limiting distance. By law-of-cosines, cosine-1-positive and cosine-2-positive the angles "
         "at 1 and 2 are acute from some time on, and by glue-lemma 12 collides at most once more. "
         "So 01 and 02 collide in turn, as no pair collides twice in a row. If the limiting angle "
         "at 0 were acute, glue-lemma would stop 01 and 02 too. As it is not, |12|² ≥ |01|² + "
         "|02|² at the limit, by law-of-cosines: more than the square of the contact distance if "
         "all radii are equal.", "numbered glue"),
    Assumption("glue-run",            EXISTENCE,
         "3. By run-always and comparison-positive a run of k collisions has s_1, …, s_{k-1} > 0: "
         "k is at most the least n ≥ 1 with s_n ≤ 0. This number is attained, with a = (1+r)/2, on "
         "a line, ball 0 in the middle: there flight keeps ρ, -cos θ = 1, and free-i makes the "
         "recursion an equation; line-solution and line-positive solve it. A ball on this line "
         "that approaches meets 0, and before that it has been apart from 0, as it receded after "
         "its last collision, by next-recedes: so there is no triple contact. For r ≤ 7-4√3 there "
         "is no such n, by below-real and comparison-endless. In a collapse as in "
         "glue-classification let -cos θ converge to a limit below 4√r/(1+r). Then (1+r)/2 (-cos "
         "θ_n) ≤ a from some n on, for some a < 2√r, by angle-small; by next-recursion and closing "
         "u_{n+2} ≤ a u_{n+1} - r u_n, by ratio-law, ratio-falls and fall-positive the ratio of "
         "closing speeds falls by a fixed amount each time, and after finitely many it is not "
         "positive: a contradiction. For r > 7-4√3 every limit is below 4√r/(1+r), by "
         "bound-above-one: there is no collapse at all.", "numbered glue"),
    Assumption("glue-impulse",        "PROPOSS3.2SommaCompNormlV",
         "4. In the frame of the centre of mass, which momentum keeps in place, sum over all "
         "balls. At the start P = R(0) and I = Σσ J = 0. By induction on the number of collisions "
         "the givens of the context total hold before each flight, by next-path, next-start, "
         "next-virial and next-weighted with virial-law, virial-rises, energy-law and "
         "energy-falls; so total-impulse always holds, and Σ J is bounded. By velocity-change "
         "velocities converge, and by impulse-least Σ |ρ_n| over all collisions is finite. For the "
         "plane of p and q, (x·p)(v·q) - (x·q)(v·p) summed with m is a component of the angular "
         "momentum L = Σ m x∧v: spin-flight and spin-law keep all of them, and so L. By "
         "cauchy-schwarz and spin-length |L| ≤ Σ m |x∧v| ≤ Σ m |x||v| ≤ R e.", "numbered glue"),
    Assumption("glue-endless",        COLLAPSE,
         "5. Let three balls collide infinitely often, without a collapse. By glue-impulse "
         "velocities converge. By glue-lemma two pairs at least collide infinitely often; such a "
         "pair is at its contact distance at arbitrarily late times, so that its relative velocity "
         "tends to 0, or its distance would grow without bound. So e tends to 0 in the frame of "
         "the centre of mass. If A > 0 once, then A/R stays above a positive number from then on, "
         "by ratio-flight and ratio-collision, but A/R ≤ e, by energy-least: a contradiction. So A "
         "≤ 0 always, R² falls, by trapezoid and shrinks, and by induction on the number of "
         "collisions, with next-times, Σσ t_n J_n is at most R(0)²/2, by impulse-times. In this "
         "frame velocities tend to 0, so that |v_i(t)| is at most the sum of J_n/m_i over "
         "collisions after t, by velocity-change, and the length of its path, where each collision "
         "counts up to t_n, at most Σ t_n J_n/m_i, by bounded-monotone: positions converge, by "
         "finite-length, and the rest of glue-classification and of glue-run holds for this orbit "
         "too. As R is bounded, and R e bounds |L|, which is kept, L = 0.", "numbered glue"),
    Assumption("glue-scenes",         COLLAPSE,
         "6. Diameter 1, three equal masses 1. (i) If each pair satisfies scene-away or scene-miss "
         "there is no further collision. (ii) r² - 14r + 1 < 0 means r > 7-4√3, by above-square "
         "and below-square: by glue-run and glue-endless there are finitely many collisions or a "
         "triple contact. (iii) Let A ≥ 0 and R² ≥ 2. If anything moves in the frame of the centre "
         "of mass, R² grows from then on, by scene-outward and virial-rises, but R² ≤ 2 at a "
         "collapse, by glue-classification, spread-law and spread-at-collapse: there is none, and "
         "as A > 0 after any flight there are finitely many collisions, by glue-endless. (iv) Let "
         "L ≠ 0. As A never falls, R² first falls and then rises, by trapezoid; so R² ≤ ρ² = "
         "max(R(0)², 2) up to a collapse at a time T, and e² ≥ |L|²/ρ², by spin-energy and "
         "glue-impulse. By induction with late-slope-next and late-square-next, and at the limit, "
         "the givens of deadline hold: there is no collapse after the time in scene-deadline, and "
         "none at all if scene-radicand fails; then there are finitely many collisions, by "
         "glue-endless. (v) By flight-normal, free-i and free-j a pair with ρ ≥ 0 cannot collide "
         "before a collision of one of its balls with the third at which the angle there is "
         "obtuse.", "numbered glue"),
    Assumption("glue-null",           COLLAPSE,
         "7. Three balls, one r in ]0,1]: the data from which a triple contact follows, after "
         "finitely many collisions, have measure zero. For the states at such a contact, where a "
         "ball touches both others, satisfy two equations: their space has two dimensions less "
         "than that of all data. From there back to the start lead flights backward and, for each "
         "collision, one backward. The latter is smooth, as by equal-inverse the velocities before "
         "it are linear in those after it, the directions given. A flight backward to an earlier "
         "collision ends at a root of |x+tw|² = σ²; there ρ' = -rρ > 0, by collision-approach, so "
         "that the discriminant is positive and the root smooth. Only the time of the last flight "
         "backward is free. So for each of the countably many orders in which pairs may collide, "
         "hard-spheres gives a smooth map from a space of one dimension less than that of all "
         "data: by smooth-images the data of all orders are null.", "numbered glue"),
    Assumption("glue-second",         SECOND,
         "8. In a collapse as in glue-classification, of balls of equal mass with one r in ]0,1], "
         "let -cos θ converge to a limit below 2r^{1/3}(1+r^{1/3})/(1+r). Positions converge, and "
         "the distances of 1 and 2 from 0 to the contact distances, as both pairs collide for "
         "ever; so by second-small there is a t with t³ < r such that α of second-law is at most "
         "t+t² from some collision on. From there on the givens of tail hold, with y = "
         "|x_c|(-η_c)/σ_c and the closing speed u of the next collision: by second-law, "
         "second-closing, and second-distance with second-time at the next state; and by "
         "next-recedes the next q is r u/y'. By second-ratio and second-below q exceeds t² after "
         "finitely many collisions, and by second-above it is at least r/t after the next one, for "
         "ever. By second-growth and second-factor τ/y then grows by a factor r/t³ > 1 with each "
         "collision, and by second-speed |W_c|² → 0. As c is 1 and 2 in turn, and velocities "
         "converge, by glue-impulse, both relative velocities tend to 0. So in a collapse in which "
         "they do not, -cos θ has a limit of at least 2r^{1/3}(1+r^{1/3})/(1+r).", "numbered glue"),
)  # fmt: skip

ASSUMPTIONS = (*DEFINITIONS, *MATHEMATICS, *GLUE)


NAME = "classification"
TITLE = (
    "Which collapses three balls have: no triangular one, at least a certain final angle, bounded "
    "total impulse, and when there are finitely many collisions; for every state"
)

CONE = "the cone of the text"

#: The chapters in the order of the proof, by the heading of their rows.
SECTIONS = {
    "lemma: flight": flight.chapters,
    "lemma: collision": collision.chapters,
    "lemma: the angle": triangle.angle,
    "I: no triangular collapse": triangle.chapters,
    "II: the recursion of closing speeds": comparison.chapters,
    "II: runs of collisions": run.chapters,
    "II: the second condition": second.chapters,
    "III: total impulse": impulse.chapters,
    "IV: finite or infinite time": impulse.endless,
    "criteria for scenes": scenes.chapters,
    CONE: image.chapters,
}

#: What is concluded in words, at the rows from which it is.
CONCLUDES = {
    "acute-keeps": ("hard-spheres", "glue-lemma"),
    "cosine-2-positive": ("hard-spheres", "finite-length", "glue-classification"),
    "fall-positive": ("glue-run",),
    "run-always": ("glue-run",),
    "bound-above-one": ("glue-run", "smooth-images", "glue-null"),
    "second-factor": ("hard-spheres", "bounded-monotone", "glue-second"),
    "total-impulse": ("hard-spheres", "bounded-monotone", "glue-impulse"),
    "spin-length": ("glue-impulse",),
    "impulse-times": ("finite-length", "glue-endless"),
    "scene-miss": ("glue-scenes",),
    "scene-outward": ("glue-scenes",),
    "scene-deadline": ("glue-scenes",),
}


@cache
def classification() -> Argument:
    """The statement with its argument, built once per process."""
    written = sectioned(NAME, TITLE, SECTIONS, ASSUMPTIONS)
    rows = tuple(_concluding(row) for row in written.statement.obligations)
    rows = (*rows, image.stated_row(CONE))
    return written._replace(statement=written.statement._replace(obligations=rows))


def _concluding(row: Obligation) -> Obligation:
    more = (name for name in CONCLUDES.get(row.name, ()) if name not in row.uses)
    return row._replace(uses=(*row.uses, *more))
