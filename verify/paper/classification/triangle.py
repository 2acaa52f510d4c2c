"""Which pairs go on colliding: a lemma on angles, and that there is no triangular collapse.

A collision with a third ball at a right or an acute angle never brings a pair together: by the law
of collision it adds (J/m) times the cosine of the angle to rho. At a collapse of three balls the
angles at the ends of the longest side are acute: l_01, l_02, l_12 are the limiting distances, and
12 is a pair of the largest one. x and z are the vectors from ball 1 to the balls 0 and 2.
"""

from __future__ import annotations

from collections.abc import Iterator

from verify.language.argument import (
    Chapter,
    Item,
    Line,
    Opened,
    identity,
    plus,
    power,
    proof,
    times,
)
from verify.language.statement import Context
from verify.language.terms import Term, equal
from verify.language.vectors import basis_vector
from verify.paper.letters import Letters, Space, minus

LABEL = "DEFINSS3.5CollapseTriangu"
ORDER = "PROPOSS3.5OrdreTriagColla"

a = Letters("acute", J="J", m="m", cosine="e_ab·e_ak", rho="ρ_ab")


def angle() -> Iterator[Chapter]:
    """Where the angle at the ball that is hit is at most a right one."""
    context = a.opened(
        "a ball a collides with k, with the impulse J; e_ab and e_ak make at most a right angle",
        "1 1 0 0",
        {"impulse": 0 < a.J, "mass": 0 < a.m, "angle": 0 <= a.cosine},
    )
    yield Chapter(None, (Opened(context),))
    line = Line("acute-keeps", a.rho <= a.rho + a.J / a.m * a.cosine,
                proof(times("acute-impulse", "acute-angle")), "DEFINSS2.1DecmpVitesNrmTg",
                "a collision of a with k at which the angle at a is at most a right one lowers "
                "ρ_ab never")  # fmt: skip
    yield Chapter(a.context, (line,))


l = Letters("limit", a="|01|", b="|02|", c="|12|")  # noqa: E741
g = Letters("sides", xx="|x|²", zz="|z|²", xz="x·z")
space = Space({("x", "x"): g.xx, ("z", "z"): g.zz, ("x", "z"): g.xz})


def limit() -> Context:
    """Three limiting distances, 12 the largest or one of the largest."""
    return l.opened(
        "limiting distances of three balls; no pair is farther apart than 12",
        "1 1 1",
        {
            "01": 0 < l.a,
            "02": 0 < l.b,
            "12": 0 < l.c,
            "01-least": l.a <= l.c,
            "02-least": l.b <= l.c,
        },
    )


def cosine(first: Term, second: Term, opposite: Term) -> Term:
    """The cosine of the angle between two sides, by the law of cosines."""
    return (first**2 + second**2 - opposite**2) / (2 * first * second)


def chapters() -> Iterator[Chapter]:
    """The law of cosines, and the two cosines."""
    sides = g.opened("x and z are any two vectors", "1 1 0", {})
    yield Chapter(None, (Opened(limit()), Opened(sides)))
    x, z = basis_vector("x"), basis_vector("z")
    law = Line("law-of-cosines",
               equal(2 * space.dot(x, z), g.xx + g.zz - space.dot(minus(z, x), minus(z, x))),
               identity(), LABEL, "2 x·z = |x|² + |z|² - |z-x|²")  # fmt: skip
    yield Chapter(g.context, (law,))
    yield Chapter("limit", tuple(_lines()))


def _lines() -> Iterator[Item]:
    yield Line("side-12", 0 < 2 * l.c, proof(times(2, "limit-12")))
    for ball, own, other, far in (("1", l.a, "01", l.b), ("2", l.b, "02", l.a)):
        longer = "limit-02-least" if ball == "1" else "limit-01-least"
        apart = "limit-02" if ball == "1" else "limit-01"
        larger = times(longer, plus(longer, times(2, apart)))
        yield from (
            Line(f"side-{other}", 0 < 2 * own * l.c, proof(times(2, f"limit-{other}", "limit-12"))),
            Line(f"cosine-{ball}", own / (2 * l.c) <= cosine(own, l.c, far),
                 proof(times(2, "limit-12", larger)),
                 ORDER, f"the limiting cosine at ball {ball} is at least |{other}|/(2|12|)"),
            Line(f"cosine-{ball}-positive", 0 < cosine(own, l.c, far),
                 proof(power(f"limit-{other}", 2), larger),
                 ORDER, f"the limiting angle at ball {ball} is acute"),
        )  # fmt: skip
