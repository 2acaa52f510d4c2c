"""The parameters in a chart where every constant is short.

With p = phi_plus, u = phi_minus/p^2 and v = V_1^(1/2) the parameters are r = u p^3,
c = 2(p + u p^2)/(1 + u p^3) and V_0 = 2 v^2 (1+u)/(3+u); the stability threshold is the edge u = 1,
and c <= 1 gives p < 1/2.
"""

from __future__ import annotations

from collections.abc import Iterator
from fractions import Fraction

from verify.language.argument import (
    ByInterval,
    ByRoot,
    Defined,
    Item,
    Line,
    Value,
    identity,
    plus,
    proof,
    scaled,
    times,
)
from verify.language.statement import Constant, Context, Given, Variable
from verify.language.terms import Claim, Term, as_term, equal, sqrt, symbol
from verify.paper.initial_data import (
    CONSTANTS,
    V_1,
    ConstantSet,
    alpha_0,
    discriminant,
    gap,
    h_4,
    h_5,
    phi_minus,
    phi_plus,
)
from verify.paper.parameters import HYPOTHESES, REPAIRED, THEOREM, V_0, c, r
from verify.paper.theorem1 import theorem

CONTEXT = "everywhere"
HALF = Fraction(1, 2)
#: What the theorem assumes; that the fixed points exist, and r < 9 - 4 sqrt 5, follows.
ASSUMED = (
    "r-positive",
    "r-below-one",
    "angle-obtuse",
    "angle-real",
    "stability",
    "V_0-positive",
    "delta-theta-positive",
)
DERIVED = ("existence", "r-below-stabi")

REPAIRED_SET = ConstantSet(REPAIRED)
p, m = phi_plus, phi_minus
u, v = symbol("u"), symbol("v")
root = sqrt(discriminant)
root_two = sqrt(2)
#: What is left of it above 7/5, which is between 0 and 1/50.
REST_ABOVE, REST_BELOW = Fraction(7, 5), Fraction(1, 50)
rest = root_two - REST_ABOVE
#: A bound from below of delta_x in both sets of constants.
LEAST_DELTA = p * (1 - u) / 4
root_4, root_5 = sqrt(r / (1 - h_4)), sqrt(phi_minus / (1 - h_5))

U = Constant("u", "u", "u", THEOREM, m / p**2)


def constants(k: ConstantSet = REPAIRED_SET) -> tuple[Constant, ...]:
    """All constants of a set, with the unrounded minima, and u and v of the chart."""
    v = Constant("v", "V₁^{1/2}", "V_1^{1/2}", THEOREM, k.speed)
    own = [*CONSTANTS, U, *theorem().parts[k.group].bounds]
    own.insert([constant.name for constant in own].index(k.V_1.name) + 1, v)
    return tuple(own)


def context(k: ConstantSet = REPAIRED_SET) -> Context:
    """All parameters that the theorem admits."""
    letters = {"V_0": "V₀", "delta_theta": "δ_θ"}
    variables = tuple(
        Variable(name, letters.get(name, name), name) for name in theorem().parameters
    )
    values = {"r": "3/100", "c": "1", "V_0": "1", "delta_theta": "1/10"}
    return Context(
        CONTEXT,
        variables,
        tuple(Given(hypothesis(name), _claim(name)) for name in ASSUMED),
        {name: as_term(Fraction(text)) for name, text in values.items()},
        says="all parameters that the theorem admits",
        constants=constants(k),
    )


def ground_lines() -> Iterator[Item]:
    """The square root of two."""
    yield from (
        Line("root-two",      0 < root_two, ByInterval()),
        Line("rest-positive", 0 < rest, ByInterval()),
        Line("rest-small",    0 < REST_BELOW - rest, ByInterval()),
    )  # fmt: skip


def lines(k: ConstantSet = REPAIRED_SET) -> Iterator[Item]:
    """From the hypotheses to the chart."""
    yield from _hypotheses()
    yield from _fixed_points()
    yield from _region()
    yield from _first_constants()
    yield from _norms(k)


def hypothesis(name: str) -> str:
    """The full name of a hypothesis."""
    return f"{HYPOTHESES}.{name}"


R, C, ONE = hypothesis("r-positive"), hypothesis("angle-obtuse"), hypothesis("r-below-one")
PLUS_R: Value = plus(1, R)


def _hypotheses() -> Iterator[Item]:
    yield from (
        Defined("alpha_0"),
        Line("alpha-sign",      0 < alpha_0, proof(times(HALF, PLUS_R, C), using="alpha_0")),
        Line("alpha-stability", 3 * r * alpha_0 + r * (1 + r) < alpha_0**3,
            proof(hypothesis("stability"), using="alpha_0")),
        Line("alpha-angle",     alpha_0 <= (1 + r) / 2,
            proof(times(HALF, PLUS_R, hypothesis("angle-real")), using="alpha_0")),
        Line("alpha-existence", 4 * r < alpha_0**2, scaled(times("alpha-sign", "goal"),
            "alpha-stability", times(R, plus("alpha-angle", times(HALF, PLUS_R))))),
        Line(hypothesis("existence"), _claim("existence"),
            proof("alpha-existence", using="alpha_0")),
        Line("alpha-stabi",     18 * r - r**2 < as_term(1),
            scaled(times(Fraction(1, 8), PLUS_R, "goal"), "alpha-stability", times("alpha-angle",
            plus(times(3, "alpha-existence"), times(9, R), times("alpha-angle",
            plus(times(3, "alpha-sign"), "alpha-angle")))))),
        Line(hypothesis("r-below-stabi"), _claim("r-below-stabi"), proof("alpha-stabi")),
    )  # fmt: skip


def _claim(name: str) -> Claim:
    rows = theorem().parts[HYPOTHESES].obligations
    claims = {row.name: row.claim for row in rows if isinstance(row.claim, Claim)}
    return claims[hypothesis(name)]


def _fixed_points() -> Iterator[Item]:
    both = "phi_minus phi_plus"
    yield from (
        Line("discriminant-positive", 0 < discriminant, proof("alpha-existence")),
        Line("discriminant-root",     0 < root, ByRoot()),
        Line("phi-divisor",           0 < alpha_0 + root, proof("discriminant-root", "alpha-sign")),
        Defined("phi_minus"),
        Defined("phi_plus"),
        Line("p-positive",            0 < p, proof(times(HALF, "phi-divisor"), using="phi_plus")),
        Line("m-positive",            0 < m, proof(times(2, R), using="phi_minus")),
        Line("r-of-m",                equal(r, m * p), identity(both)),
        Line("alpha-of-m",            equal(alpha_0, m + p), identity(both)),
        Line("root-of-m",             equal(root, p - m), identity(both)),
        Line("m-below-p",             0 < p - m, proof("discriminant-root", using="root-of-m")),
    )  # fmt: skip


def _region() -> Iterator[Item]:
    of_m = "r-of-m alpha-of-m"
    yield from (
        Line("m-below-one",       0 < 1 - m, scaled(times("goal", plus(1, "m-positive")), ONE,
            times("m-positive", "m-below-p"), using="r-of-m")),
        Line("p-square",          0 < p**2 - m,
            scaled(times("goal", plus("m-below-p", times("m-positive", "m-below-one"))),
            "alpha-stability", using=of_m)),
        Line("p-square-positive", 0 < p**2, proof(times("p-positive", "p-positive"))),
        Defined("u"),
        Line("u-positive",        0 < u, proof("m-positive", using="u")),
        Line("u-below-one",       0 < 1 - u, proof("p-square", using="u")),
        Line("p-below-one",       0 < 1 - p, scaled(times(2, "goal"), times(2, "alpha-angle"),
            ONE, times(2, "m-positive"), using=of_m)),
        Line("p-below-half",      0 < HALF - p, scaled(times(2, "goal"), times(2, "alpha-angle"),
            times("m-positive", plus("p-below-one", 1)), using=of_m)),
        Line("m.chart",           equal(m, u * p**2), identity("u")),
        Line("r.chart",           equal(r, u * p**3), identity("r-of-m m.chart")),
        Line("alpha.chart",       equal(alpha_0, p + u * p**2), identity("alpha-of-m m.chart")),
        Line("root.chart",        equal(root, p - u * p**2), identity("root-of-m m.chart")),
        Line("r-sum",             0 < 1 + r, proof(1, R)),
        Line("c-of-alpha",        equal(c, 2 * alpha_0 / (1 + r)), identity("alpha_0")),
        Line("c-sum", 0 < 1 + u * p**3, proof(1, times("u-positive", ("pow", "p-positive", 3)))),
        Line("c.chart",           equal(c, 2 * (p + u * p**2) / (1 + u * p**3)),
            identity("c-of-alpha alpha.chart r.chart")),
    )  # fmt: skip


def _first_constants() -> Iterator[Item]:
    chart = "r.chart alpha.chart m.chart"
    terms = {
        "delta_1": (p - u * p**2) / 2,
        "delta_2": p / 2,
        "delta_3": (1 - p) / 2,
        "C_eta": (1 + p) / 2,
    }
    using = chart
    for name, term in terms.items():
        yield Defined(name)
        yield Line(f"{name}.chart", equal(symbol(name), term), identity(f"{using} {name}"))
        using = f"{using} {name}.chart"
    square = times("p-positive", "p-positive")
    small = plus(HALF, times(HALF, "u-positive", "p-positive"))
    cube = times("u-positive", ("pow", "p-positive", 3))
    half = plus(HALF, times(HALF, "u-positive"))
    yield from (
        Line("gap-square",    0 < gap**2, proof(square, using="alpha.chart m.chart")),
        Defined("h_4"),
        Line("h_4.chart",     equal(h_4, (1 - u * p) / 2), identity(f"{chart} h_4")),
        Line("h_4-room",      0 < 1 - h_4, proof(small, using="h_4.chart")),
        Line("radicand-4",    0 < r / (1 - h_4), proof(cube, using="r.chart h_4.chart")),
        Line("root-4",        0 < root_4, ByRoot()),
        Defined("delta_4"),
        Line("delta_4.chart", equal(symbol("delta_4"), p - root_4),
            identity("alpha.chart m.chart delta_4")),
        Defined("h_5"),
        Line("h_5.chart",     equal(h_5, (1 - u) / 2), identity("alpha.chart m.chart h_5")),
        Line("h_5-room",      0 < 1 - h_5, proof(half, using="h_5.chart")),
        Line("radicand-5",    0 < m / (1 - h_5),
            proof(times("u-positive", square), using="m.chart h_5.chart")),
        Line("root-5",        0 < root_5, ByRoot()),
        Defined("delta_5"),
        Line("delta_5.chart", equal(symbol("delta_5"), p - root_5),
            identity("alpha.chart m.chart delta_5")),
    )  # fmt: skip


def _norms(k: ConstantSet) -> Iterator[Item]:
    positive, first = hypothesis("V_0-positive"), k.V_1.name
    quarter = Fraction(1, 4)
    more = times(positive, plus(Fraction(3, 4), times(quarter, "u-positive")))
    yield Defined("V_1")
    if not k.printed:
        yield Defined(first)
    both = "V_1" if k.printed else f"{first} V_1"
    yield from (
        Line("V_1-sign",   0 < k.V_1, proof(more, using=f"{both} h_5.chart")),
        Line("V_1-root",   0 < k.speed, ByRoot()),
        Defined("v"),
        Line("v-positive", 0 < v, proof("V_1-root", using="v")),
        Line("speed",      equal(k.speed, v), identity("v")),
    )  # fmt: skip
    same = () if k.printed else ((first, as_term(-1)),)
    if not k.printed:
        yield Line("V_1.repaired", equal(k.V_1, v**2), identity("v"))
    yield from (
        Line("V_1.chart",   equal(V_1, v**2), identity("v", same)),
        Line("V_0-divisor", 0 < 3 + u, proof(3, "u-positive")),
    )  # fmt: skip
    same = () if k.printed else ((first, -2 * (1 + u)),)
    yield Line("V_0.chart", equal(V_0, v**2 * (2 * (1 + u) / (3 + u))),
        identity("v h_5.chart", (("V_1", as_term(-4)), *same)))  # fmt: skip


def replacements(k: ConstantSet = REPAIRED_SET) -> dict[Term, str]:
    """For each atom that the chart replaces the line that says so."""
    found = {
        r: "r.chart",
        alpha_0: "alpha.chart",
        m: "m.chart",
        c: "c.chart",
        root: "root.chart",
        V_0: "V_0.chart",
        V_1: "V_1.chart",
        k.V_1: "V_1.chart" if k.printed else "V_1.repaired",
        k.speed: "speed",
        h_4: "h_4.chart",
        h_5: "h_5.chart",
    }
    names = ("delta_1", "delta_2", "delta_3", "delta_4", "delta_5", "C_eta")
    return found | {symbol(name): f"{name}.chart" for name in names}
