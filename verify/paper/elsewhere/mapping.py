"""One collision of 0 and 2 after one of 0 and 1, in inner products with any vector p.

omega_1, omega_2 are unit vectors from 0, W_1 and W_2 relative velocities, 1 + d the distance of 2,
y = -eta_2. The time tau of the collision and S = sqrt(1-zeta) are given by what their formulas
say; c is the cosine of the angle at the collision.

What the definition of the mapping asks for does not keep the outer pair 1 and 2 apart.

In `outer` x is the vector from 1 to 2 and u their relative velocity. In `three` the balls are in a
plane: 1 touches 0 in the direction (1, 0), and 2 is at X.
"""

from __future__ import annotations

from collections.abc import Iterator

from verify.language.argument import (
    Chapter,
    Defined,
    Item,
    Line,
    Opened,
    identity,
    power,
    proof,
    scaled,
    times,
)
from verify.language.statement import Constant
from verify.language.terms import Claim, as_term, equal, symbol
from verify.language.vectors import Combination, add, basis_vector, scale
from verify.paper.letters import Letters, Refuted, Space, minus, refuted
from verify.paper.rows import REMARK, SLIP

STATE = "3/4 1 1/10 1 -3/40 -1/10 2 1/10"

SYSTEM = "EQUATSS2.2IterationSystm1"
TANGENT_1 = "EQUATSS2.2W1prpPrimeVers1"
TANGENT_2 = "EQUATSS2.2W2prpPrimeVers1"
COSINE = "EQUATSS2.2CosinAngleVers1"
NORMAL = "PROPOSS3.4CLineConveNorma"
NEARLY = "PROPOSS3.4CLineConveTangt"
FIRST = "EQUATSS2.2Eta_1PrimeVers1"
TIME = "EQUATSS2.2TempsColliTauV3"

n = Letters(
    "map", r="r", d="d", y="|η₂|", eta="η₁", cos="ω₁·ω₂", a="ω₁·W₂", b="ω₂·W₁", A="|W₂|²",
    B="|W₁|²", w="W₁·W₂", S="√(1-ζ)", tau="τ", D="(1+d')", p_1="p·ω₁", p_2="p·ω₂", q_1="p·W₁",
    q_2="p·W₂",
)  # fmt: skip
omega_1, W_1, omega_2, W_2, p = map(basis_vector, ("omega_1", "W_1", "omega_2", "W_2", "p"))
space = Space({
    ("omega_1", "omega_1"): as_term(1), ("omega_2", "omega_2"): as_term(1),
    ("omega_1", "omega_2"): n.cos, ("omega_1", "W_1"): n.eta, ("omega_2", "W_2"): -n.y,
    ("omega_1", "W_2"): n.a, ("omega_2", "W_1"): n.b, ("W_1", "W_1"): n.B, ("W_2", "W_2"): n.A,
    ("W_1", "W_2"): n.w, ("p", "omega_1"): n.p_1, ("p", "omega_2"): n.p_2, ("p", "W_1"): n.q_1,
    ("p", "W_2"): n.q_2,
})  # fmt: skip
dot = space.dot
half = (1 + n.r) / 2
#: W_2.omega_2' = (1+d) eta_2 + tau |W_2|^2, and omega_1'.omega_2', as names.
kappa, c = symbol("map-kappa"), symbol("map-c")
new_2: Combination = add(scale(1 + n.d, omega_2), scale(n.tau, W_2))
end: Combination = add(omega_1, scale(n.tau, W_1))
new_1: Combination = scale(1 / n.D, end)
grown = (n.eta + n.tau * n.B) / n.D
speed_1 = minus(W_1, scale(half * kappa, new_2))
speed_2 = minus(W_2, scale((1 + n.r) * kappa, new_2))
bracket = minus(scale(c, new_1), new_2)
#: Three balls on a line, of which 1 and 2 are outside, for r = 1/20.
POINT = "1/20 1 1 1/8 -1 1 -1/8 1 1/64 1/8 1/2 1 9/8 1 -1 1/8 1"


def givens() -> dict[str, Claim]:
    """What is known of a state just before the collision."""
    return {
        "r-positive": 0 < n.r,
        "r-one": n.r < 1,
        "d-positive": 0 < n.d,
        "closing": 0 < n.y,
        "receding": 0 < n.eta,
        "S-positive": 0 < n.S,
        "tau-positive": 0 < n.tau,
        "D-positive": 0 < n.D,
        "contact-time": equal((1 + n.d) * n.y * (1 + n.S) * n.tau, n.d * (2 + n.d)),
        "speed-time": equal(n.A * n.tau, (1 + n.d) * n.y * (1 - n.S)),
        "distance": equal(n.D**2, 1 + 2 * n.eta * n.tau + n.B * n.tau**2),
        "cs-1": n.eta**2 <= n.B,
        "cs-2": n.y**2 <= n.A,
        "cs-turn": dot(end, new_2) ** 2 <= dot(end, end) * dot(new_2, new_2),
    }


def chapters() -> Iterator[Chapter]:
    """The equations of the mapping that the step does not have: with p, and as vectors."""
    context = n.opened(
        "0 and 1 have just collided, 0 and 2 will next, after the time τ; p is any vector",
        POINT,
        givens(),
    )
    values = {"map-kappa": ("W₂·ω₂'", dot(W_2, new_2)), "map-c": ("ω₁'·ω₂'", dot(new_1, new_2))}
    constants = tuple(Constant(k, x, x, SYSTEM, term) for k, (x, term) in values.items())
    yield Chapter(None, (Opened(context._replace(constants=constants)),))
    yield Chapter(n.context, (*_places(), *_speeds(), *_tangents()))


def _places() -> Iterator[Item]:
    yield from (
        Defined("map-kappa"),
        Defined("map-c"),
        Line("meets", equal(dot(new_2, new_2), 1),
             identity("", (("map-speed-time", n.tau), ("map-contact-time", as_term(-1)))),
             "EQUATSS2.2DefinOmeg2Prime", "after the time τ balls 0 and 2 touch: |ω₂'| = 1"),
        Line("path-square",
             equal(dot(new_2, new_2),
                   (1 + n.d) ** 2 + 2 * (1 + n.d) * -n.y * n.tau + n.A * n.tau**2), identity(),
             "EQUATSS2.2CondiColliFutur",
             "|x₂-x₀|² = (1+d)² + 2(1+d)(ω₂·W₂)τ + |W₂|²τ² after a flight of length τ"),
        Line("turned-unit", equal(dot(new_1, new_1), 1),
             identity("", (("map-distance", as_term(-1)),)),
             "EQUATSS2.2DefinOmeg1Prime", "|ω₁'| = 1"),
        Line("hit", equal(kappa, -((1 + n.d) * n.y * n.S)),
             identity("map-kappa", (("map-speed-time", as_term(1)),)),
             TIME, "W₂·ω₂' = (1+d)η₂ + τ|W₂|² = (1+d)√(1-ζ) η₂"),
        Line("cosine",
             equal(n.D * c, (1 + n.d) * n.cos + (n.a + (1 + n.d) * n.b) * n.tau + n.w * n.tau**2),
             identity("map-c"), COSINE,
             "(1+d') ω₁'·ω₂' = (1+d) ω₁·ω₂ + (ω₁·W₂ + (1+d) ω₂·W₁)τ + W₁·W₂ τ²"),
    )  # fmt: skip


def _speeds() -> Iterator[Item]:
    yield from (
        Line("far-component", equal(dot(W_2, scale(1 + n.d, omega_2)), (1 + n.d) * -n.y),
             identity(), NORMAL, "W₂·(x₂-x₀) = (1+d)η₂, where 0 and 2 are apart"),
        Line("grown",         equal(dot(W_1, new_1), grown), identity(),
             FIRST, "W₁·ω₁' = (η₁ + τ|W₁|²)/(1+d')"),
        Line("normal-1",      equal(dot(speed_1, new_1), grown - half * c * kappa),
             identity("map-c"), FIRST, "η₁' = (η₁ + τ|W₁|²)/(1+d') - (1+r)/2 (ω₁'·ω₂') W₂·ω₂'"),
        Line("normal-2",      equal(dot(speed_2, new_2), -n.r * kappa),
             identity("", (("meets", -((1 + n.r) * kappa)), ("map-kappa", as_term(-1)))),
             "EQUATSS2.2Eta_1PrimeVers2", "η₂' = -r W₂·ω₂'"),
    )  # fmt: skip


def _tangents() -> Iterator[Item]:
    after = minus(speed_2, scale(-n.r * kappa, new_2))
    yield from (
        Line("tangential-1", equal(dot(p, projected(speed_1, new_1)), dot(p, rest_1())),
             identity("map-c"), TANGENT_1,
             "p·(W₁⊥)' = p·(W₁ - (η₁+τ|W₁|²)/(1+d') ω₁' + (1+r)/2 (W₂·ω₂')[(ω₁'·ω₂')ω₁' - ω₂'])"),
        Line("tangential-2", equal(dot(p, after), dot(p, minus(W_2, scale(kappa, new_2)))),
             identity(), TANGENT_2, "p·(W₂⊥)' = p·(W₂ - (W₂·ω₂')ω₂')"),
    )  # fmt: skip


def projected(speed: Combination, direction: Combination) -> Combination:
    """What is left of a velocity without its component along a unit vector."""
    return minus(speed, scale(dot(speed, direction), direction))


def rest_1() -> Combination:
    """The right side of the law of the tangential component of W_1."""
    return add(minus(W_1, scale(grown, new_1)), scale(half * kappa, bracket))


def misprints() -> Iterator[Refuted]:
    """What is false here, each with a point at which it is."""
    yield from (
        refuted(n, "far-component-printed", equal(dot(W_2, scale(1 + n.d, omega_2)), -n.y), POINT,
                label=NORMAL,
                says="η_{i,n} = W_i·ω_i = (v_i-v_0)·(x_i-x_0), for the pair that is apart too: so "
                     "with ω_i = x_i-x_0, as Section 3.2 has it, and not with the unit vector of "
                     "the mapping",
                severity=REMARK, corrected_by="far-component"),
        refuted(n, "tangential-scalar",
                equal(dot(p, projected(speed_1, new_1)),
                      n.q_1 - grown + half * kappa * dot(p, bracket)),
                "1/20 1 1 1/8 -1 1 -1/8 1 1/64 1/8 1/2 1 9/8 0 0 0 0", label=NEARLY,
                says="W_{1,n+1}⊥ = W_{1,n} - (η_{1,n}+τ_n|W_{1,n}|²)/(1+d_{n+1}) + …, twice: a "
                     "number is taken from a vector, ω_{1,n+1} is missing (read along p, as if "
                     "from each component)", severity=SLIP, corrected_by="tangential-1"),
    )  # fmt: skip


o = Letters("outer", G="|x|²", k="x·u", U="|u|²", t="t", tau="τ")
three = Letters(
    "three", X_1="X₁", X_2="X₂", a_1="(W₁)₁", a_2="(W₁)₂", b_1="(W₂)₁", b_2="(W₂)₂", tau="τ", t="t",
)  # fmt: skip


def outer() -> Iterator[Chapter]:
    """What keeps them apart, and states that satisfy what the definition asks for."""
    apart = o.opened(
        "1 and 2 are apart now, and so far that they are at the time τ of the next collision too",
        "4 -1 1 1/2 1",
        {
            "now": 1 < o.G,
            "later": 1 < o.G + 2 * o.tau * o.k,
            "speed": 0 <= o.U,
            "time": 0 < o.t,
            "before": o.t <= o.tau,
        },
    )
    says = "three balls in a plane, as in the definition of the mapping, at a time t before τ"
    yield Chapter(None, (Opened(apart), Opened(three.opened(says, STATE, conditions()))))
    yield Chapter(o.context, tuple(_outer()))


def conditions() -> dict[str, Claim]:
    """What the definition asks for; that 1 and 2 are apart; and the time of 0 and 2."""
    inner, size = three.X_1 * three.b_1 + three.X_2 * three.b_2, three.X_1**2 + three.X_2**2
    speed = three.b_1**2 + three.b_2**2
    end_1, end_2 = three.X_1 + three.tau * three.b_1, three.X_2 + three.tau * three.b_2
    return {
        "apart": 1 < size,
        "recedes": 0 < three.a_1,
        "approaches": inner < 0,
        "zeta": (size - 1) * speed < inner**2,
        "outer": 1 < (three.X_1 - 1) ** 2 + three.X_2**2,
        "meets": equal(end_1**2 + end_2**2, 1),
        "impact": end_1 * three.b_1 + end_2 * three.b_2 < 0,
        "time": 0 < three.t,
        "before": three.t < three.tau,
    }


def _outer() -> Iterator[Item]:
    yield from (
        Line("tau-positive", 0 < o.tau, proof("outer-time", "outer-before")),
        Line("outer-apart",  1 < o.G + 2 * o.t * o.k + o.t**2 * o.U,
             scaled(times("goal", "tau-positive"), times("outer-now", "outer-before"),
                    times("outer-later", "outer-time"),
                    times("tau-positive", power("outer-time", 2), "outer-speed")), SYSTEM,
             "they stay apart if 1 < |x|² + 2τx·u besides: then 0 and 2 are the next to collide"),
    )  # fmt: skip


def outer_misprints() -> Iterator[Refuted]:
    """What is false here, each with a point at which it is."""
    yield refuted(three, "next-collision",
                  1 <= (three.X_1 + three.t * (three.b_1 - three.a_1) - 1) ** 2
                  + (three.X_2 + three.t * (three.b_2 - three.a_2)) ** 2, STATE, label=SYSTEM,
                  says="that 0 and 2 are the next to collide is assumed in words in the definition "
                       "of the mapping; η₁ > 0, η₂ < 0 and ζ < 1, which follow there, do not say "
                       "so: here 1 and 2 meet before",
                  severity=REMARK, corrected_by="outer-apart")  # fmt: skip
