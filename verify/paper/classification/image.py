"""The cone of the text, with the condition that it leaves out: the third collision takes place.

a, b, c < 0 are the normal components just before 0-1, 0-2 and 1-2; t is arbitrary. The image is
that of the printed matrix, in the basis in which the printed matrices are right.
"""

from __future__ import annotations

from collections.abc import Iterator
from fractions import Fraction

from verify.language.argument import Chapter, Item, Line, Opened, identity, plus, proof, times
from verify.language.statement import Given, Obligation, Variable
from verify.language.terms import Term, as_term, equal
from verify.paper.letters import Letters
from verify.paper.rows import SLIP, misprint
from verify.paper.spectrum.collision_matrices import A_A, A_B
from verify.paper.spectrum.cone import NORMAL_12
from verify.paper.spectrum.matrices import Vector, apply, dot, vector
from verify.paper.spectrum.printed import MATRIX, MATRIX_LABEL, THEOREM, h, r, root_3

BOUND = "EQUATSS3.5Minor_z'__Triag"

n = Letters("triple", a="a", b="b", c="c", t="t")
QUARTER = Fraction(1, 4)

#: The row NORMAL_12 in the basis as the text states it, where the fourth coordinate is opposite.
NORMAL_STATED: Vector = vector(*NORMAL_12[:3], -NORMAL_12[3])

#: Values at which `stated_row` is false.
FALSE_AT: dict[str, Term] = {"r": as_term(Fraction(1, 2)), **n.point("-1 -1 -1 1")}


def meeting_state() -> Vector:
    """The coordinates just before 0-1 for which the three collisions meet a, b and c."""
    z = n.b + h * n.a
    difference = 2 * root_3 / 3 * (n.c - (n.a + z) / 2 + h * n.a + h * n.b)
    return n.a, n.t - difference, z, n.t


def chapters() -> Iterator[Chapter]:
    """The state meets a, b, c; its image recedes in all three pairs."""
    found = n.opened(
        "r in ]0,1[; a, b, c < 0 are the normal components before 0-1, 0-2, 1-2",
        "-1 -1 -1 0",
        {"a": n.a < 0, "b": n.b < 0, "c": n.c < 0},
    )
    context = found._replace(
        variables=(Variable("r", "r", "r"), *found.variables),
        givens=(Given("triple-r", 0 < r), Given("triple-r-one", r < 1), *found.givens),
        point={"r": as_term(Fraction(1, 2)), **found.point},
    )
    yield Chapter(None, (Opened(context),))
    yield Chapter(n.context, tuple(_lines()))


def _lines() -> Iterator[Item]:
    start = meeting_state()
    before_2 = apply(A_A, start)
    before_3 = apply(A_B, before_2)
    image = apply(MATRIX, start)
    for name, value, letter in (
        ("01", start[0], n.a),
        ("02", before_2[2], n.b),
        ("12", dot(NORMAL_12, before_3), n.c),
    ):
        yield Line(f"cone-meets-{name}", equal(value, letter), identity(), THEOREM,
                   f"the collision {name[0]}-{name[1]} meets this normal component")  # fmt: skip
    yield Line("cone-stated-12",
               equal(dot(NORMAL_STATED, apply(A_B, apply(A_A, stated_state()))), n.c), identity(),
               MATRIX_LABEL,
               "and so it does, for other y, if c is read in the basis as the text states it",
    )  # fmt: skip
    quarter = plus("triple-r", 1)
    both = times(QUARTER, quarter, plus("triple-b", "triple-c"))
    last = times(QUARTER, quarter, "triple-c")
    for name, value, expected, addends, says in (
        ("x", image[0], -(r * n.a) - h * (n.b + n.c), ("triple-a", both), "x' = -ra - h(b+c)"),
        ("z", image[2], -(r * n.b) - h * n.c, ("triple-b", last), "z' = -rb - hc"),
        ("12", dot(NORMAL_12, image), -(r * n.c), ("triple-c",), "the third is -rc"),
    ):
        yield from (
            Line(f"cone-image-{name}", equal(value, expected), identity(),
                 BOUND, f"the image under the printed matrix: {says}, h = (1+r)/4"),
            Line(f"cone-sign-{name}",  0 < expected,
                 proof(times("triple-r", addends[0]), *addends[1:]),
                 BOUND, "it is positive: this pair recedes after the triple, for every r"),
        )  # fmt: skip


def stated_state() -> Vector:
    """As `meeting_state`, if the third condition is read in the basis as the text states it."""
    z = n.b + h * n.a
    rest = dot(NORMAL_STATED, apply(A_B, apply(A_A, vector(n.a, 0, z, n.t))))
    return n.a, 2 * root_3 / 3 * (rest - n.c), z, n.t


def stated_row(group: str) -> Obligation:
    """The image under the printed matrix, read in the basis as the text states it."""
    return misprint(
        "cone-image-stated",
        MATRIX_LABEL,
        "the printed matrix in the basis as the text states it (ω₂⊥·ω₁ > 0), where 1-2 meets "
        "c = (x - √3y + z - √3t)/2: x' = -ra - h(b+c)",
        equal(apply(MATRIX, stated_state())[0], -(r * n.a) - h * (n.b + n.c)),
        group=group,
        severity=SLIP,
        corrected_by="cone-image-x",
    )._replace(context=n.context)
