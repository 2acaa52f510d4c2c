"""With < in `EQUATSS4.1ThExiCondiTheta`, as it is printed, the theorem is false.

For parameters with -cos theta_0 + delta_theta < 4 sqrt(r)/(1+r) the theorem claims a collapse that
Theorem II of the classification excludes. The printed hypotheses hold for many of these.
"""

from __future__ import annotations

from collections.abc import Iterator
from fractions import Fraction
from functools import cache

from verify.language.argument import (
    Argument,
    ByRoot,
    Chapter,
    Item,
    Line,
    Opened,
    argue,
    identity,
    plus,
    power,
    proof,
    square,
    times,
)
from verify.language.statement import (
    NEEDED,
    Applies,
    Assumption,
    Cite,
    Context,
    Given,
    Obligation,
    Variable,
)
from verify.language.terms import as_term, equal, sqrt, symbol
from verify.paper.hypotheses import ANGLE, RESTITUTION
from verify.paper.parameters import THEOREM, c, delta_theta, r

NAME = f"{THEOREM}, the sign as printed"
TITLE = (
    "With -cos theta_0 < 2 r^(1/3) (1 + r^(1/3))/(1+r), as printed, the theorem is false: where "
    "-cos theta_0 + delta_theta < 4 sqrt(r)/(1+r) no collapse has a final angle that is within "
    "delta_theta of it, and the printed hypotheses admit such parameters"
)
EXCLUDED, ROOTS, COLLAPSE = "excluded", "cube-roots", "no-collapse"
C, alpha, s = symbol("C"), symbol("alpha"), symbol("s")
#: r, -cos theta_0 and delta_theta that the printed hypotheses admit.
POINT = {"r": "3/100", "c": "1/2", "delta_theta": "1/10"}
GLUE = Assumption(
    "glue-as-printed",
    THEOREM,
    "1. The theorem claims a set with interior points, so a datum, from which the particles "
    "collapse with |(-cos of the final angle) - (-cos θ₀)| ≤ δ_θ. By no-collapse and theorem II "
    "of the classification, -cos of the final angle is at least 4√r/(1+r), and it is not. So for "
    "these parameters there is no such datum; they satisfy the printed hypotheses, at the point "
    "by printed-angle and printed-restitution.",
    "numbered glue",
)


def contexts() -> tuple[Context, Context]:
    """Parameters and a final angle near theta_0; and the cube root of r."""
    sides = {"upper": C - c <= delta_theta, "lower": c - C <= delta_theta}
    near = {
        "positive": 0 < r,
        "sum": 0 < 1 + r,
        "below": c + delta_theta < 4 * sqrt(r) / (1 + r),
        **sides,
    }
    letters = {"r": "r", "c": "(-cos θ₀)", "delta_theta": "δ_θ", "C": "(-cos θ̄)"}
    tex = {"r": "r", "c": r"(-\cos\theta_0)", "delta_theta": r"\delta_\theta"}
    excluded = Context(
        EXCLUDED,
        tuple(
            Variable(name, letter, tex.get(name, r"(-\cos\overline{\theta})"))
            for name, letter in letters.items()
        ),
        tuple(Given(f"{EXCLUDED}-{name}", claim) for name, claim in near.items()),
        {name: as_term(Fraction(text)) for name, text in (POINT | {"C": "1/2"}).items()},
        says="parameters, and a final angle as the theorem claims it",
    )
    roots = Context(
        ROOTS,
        (Variable("alpha", "α₀", r"\alpha_0"), Variable("s", "r^{1/3}", "r^{1/3}")),
        (Given("roots-alpha", 0 < alpha), Given("roots-s", 0 < s)),
        {"alpha": as_term(1), "s": as_term(1)},
        says="the cube root s of r, and α₀",
    )
    return excluded, roots


@cache
def sign(classification: Cite) -> Argument:
    """The statement and its argument, with the classification that it cites."""
    found = argue(NAME, TITLE, _chapters(), (GLUE,))
    row = Obligation(COLLAPSE, NAME, THEOREM, NEEDED,
        "-cos of a final angle that is within δ_θ of -cos θ₀ is below 4√r/(1+r): theorem II "
        "excludes the collapse", Applies(f"{classification.name}:final",
        {"final.s": sqrt(r), "final.C": C}), (GLUE.name,), context=EXCLUDED)  # fmt: skip
    old = found.statement
    rows = (*at_the_point(), *old.obligations, row)
    return found._replace(statement=old._replace(obligations=rows, cites=(classification,)))


#: Why the row that cites the classification holds: its givens in order.
PREMISES = ("final-root", "final-size", "final-below")


def _chapters() -> Iterator[Chapter]:
    excluded, roots = contexts()
    yield Chapter(None, (Opened(excluded), Opened(roots)))
    root = sqrt(r)
    yield Chapter(EXCLUDED, (
        Line("final-root",   0 < root, ByRoot()),
        Line("final-size",   0 < 1 + root**2, proof(1, f"{EXCLUDED}-positive")),
        Line("final-below",  C < 4 * root / (1 + root**2),
             proof(times(f"{EXCLUDED}-sum", f"{EXCLUDED}-upper"), f"{EXCLUDED}-below")),
    ))  # fmt: skip
    yield Chapter(ROOTS, tuple(_threshold()))


def at_the_point() -> Iterator[Obligation]:
    """That the printed hypotheses admit such parameters: numbers, which enclosures decide."""
    r, c, delta_theta = (as_term(Fraction(text)) for text in POINT.values())
    half = (1 + r) / 2 * c
    where = "at r = 3/100, -cos θ₀ = 1/2, δ_θ = 1/10"
    for name, label, says, claim in (
        ("printed-restitution", RESTITUTION, "r < 9 - 4√5", 18 * r - r**2 < as_term(1)),
        ("printed-angle", ANGLE, "-cos θ₀ < 2r^(1/3)(1+r^(1/3))/(1+r), as printed,",
         half**3 < 3 * r * half + r * (1 + r)),
        ("printed-below", ANGLE, "-cos θ₀ + δ_θ < 4√r/(1+r)",
         c + delta_theta < 4 * sqrt(r) / (1 + r)),
    ):  # fmt: skip
        yield Obligation(name, NAME, label, NEEDED, f"{says} {where}", claim)


def _threshold() -> Iterator[Item]:
    """The hypothesis in cube roots is a polynomial inequality: the other factor is positive."""
    cubic = alpha**3 - 3 * s**3 * alpha - s**3 * (1 + s**3)
    other = alpha**2 + (s + s**2) * alpha + s**2 - s**3 + s**4
    half = Fraction(1, 2)
    rest = plus(power("roots-alpha", 2),
                times(plus("roots-s", power("roots-s", 2)), "roots-alpha"),
                times(half, power("roots-s", 2)), times(half, power("roots-s", 2), square(1 - s)),
                times(half, power("roots-s", 4)))  # fmt: skip
    yield from (
        Line("threshold-factors", equal(cubic, (alpha - s - s**2) * other), identity(),
             ANGLE, "α₀³ - 3rα₀ - r(1+r) is α₀ - r^{1/3} - r^{2/3} times another factor"),
        Line("threshold-other",   0 < other, proof(rest),
             ANGLE, "and that factor is positive: so the hypothesis is the sign of a polynomial"),
    )  # fmt: skip
