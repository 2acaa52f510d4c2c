"""One step of the full dynamics as a map of q = eta_s/(-eta_c) and u = 1 - sqrt(1-zeta), exactly.

S stands for sqrt(1-zeta), T for the time to the next collision, D for 1 + d'. In any dimension p =
alpha (1-u) - beta (q + rho u), q' = R (1-u)/p and zeta' = gamma ((q + rho u)^2 - q^2)/p^2.
"""

from __future__ import annotations

from collections.abc import Iterator

from verify.language.argument import Chapter, Item, Line, Opened, identity, proof
from verify.language.terms import as_term, equal
from verify.language.vectors import Frame, W_c, W_s, add, omega_c, omega_s, scale
from verify.paper.dynamics.state import root_of, zeta_of
from verify.paper.letters import Letters

LABEL = "EQUATSS4.1SysteDynamColSp"

x = Letters(
    "exact", r="r", y="-η_c", eta="η_s", C="-cos θ", a="ω_s·W_c", b="ω_c·W_s", A="|W_c|²",
    B="|W_s|²", w="W_s·W_c", d="d", S="√(1-ζ)", T="τ", D="1+d'",
    Y="-η_c'", N="η_s'", E="-cos θ'", M="|W_c'|²",
)  # fmt: skip
frame = Frame(x.y, x.eta, x.C, x.a, x.b, x.A, x.B, x.w, x.d)
dot = frame.dot
half = (1 + x.r) / 2

contact = add(scale(1 + x.d, omega_c), scale(x.T, W_c))
end = add(omega_s, scale(x.T, W_s))
kappa = dot(W_c, contact)
new_W_c = add(W_s, scale(-(half * kappa), contact))
new_W_s = add(W_c, scale(-((1 + x.r) * kappa), contact))

#: The map, and its parameters.
q, u = x.eta / x.y, 1 - x.S
alpha, beta = half * (1 + x.d) * x.E, 1 / x.D
rho, gamma, R = (1 + x.d) * x.B / x.A, x.M / x.B / x.D / x.D, x.r * (1 + x.d)
p = x.Y / x.y
zeta_next = (x.D**2 - 1) / x.D / x.D * (x.M / x.Y / x.Y)


def chapters() -> Iterator[Chapter]:
    """The step, for every state whose next collision is followed by an approach."""
    context = x.opened(
        "a state just after a collision, its next collision, and the state after that",
        "1/5 1 1/10 1 1 -1/10 1 1/100 1/10 1 1/2 1 11/10 1/2 1/5 1 1/4",
        {
            "approaches": 0 < x.y,
            "distance": 0 < 1 + x.d,
            "speed-c": 0 < x.A,
            "speed-s": 0 < x.B,
            "next-distance": 0 < x.D,
            "next-approaches": 0 < x.Y,
            "meets": 0 < 1 - zeta_of(frame),
            "root": equal(x.S, root_of(frame)),
            "time": equal(x.T, (1 + x.d) / x.A * x.y * (1 - x.S)),
            "end": equal(x.D**2, dot(end, end)),
            "angle": equal(x.E * x.D, -dot(contact, end)),
            "closing": equal(x.Y * x.D, -dot(new_W_c, end)),
            "parting": equal(x.N, dot(new_W_s, contact)),
            "speed": equal(x.M, dot(new_W_c, new_W_c)),
        },
    )
    yield Chapter(None, (Opened(context),))
    yield Chapter(x.context, tuple(_lines()))


def _lines() -> Iterator[Item]:
    hit, pull = (1 + x.d) * x.y * x.S, x.B * x.T
    moved = (("exact-contact", -((1 + x.r) * kappa)), ("exact-impact", -x.r))
    turned = half * x.E * x.D
    struck = (
        ("exact-closing", as_term(1)),
        ("exact-angle", half * kappa),
        ("exact-impact", -turned),
    )
    load = gamma * ((q + rho * u) ** 2 - q**2) / p / p
    common = x.D**2 * x.Y**2 * x.M * x.y**4
    lost = 2 * x.eta * x.A + x.A * pull + (1 + x.d) * x.B * u * x.y
    yield from (
        Line("exact-contact", equal(dot(contact, contact), 1), identity("exact-time exact-root"),
             LABEL, "after the time τ particle c is in contact"),
        Line("exact-impact", equal(kappa, -hit), identity("exact-time")),
        Line("exact-pull", equal(pull, rho * u * x.y), identity("exact-time")),
        Line("exact-eta", equal(x.N, x.r * hit), identity("exact-parting", moved)),
        Line("exact-fall", equal(x.Y * x.D, turned * hit - (x.eta + pull)), identity("", struck)),
        Line("exact-p", equal(p, alpha * (1 - u) - beta * (q + rho * u)),
             identity("", (("exact-fall", x.y * x.A), ("exact-pull", -x.y))), LABEL,
             "η_c'/η_c = p = α(1-u) - β(q+ρu), α = (1+r)/2 (1+d)(-cos θ'), β = 1/(1+d'), ρ = "
             "(1+d)|W_s|²/|W_c|²"),
        Line("exact-p-positive", 0 < p, proof("exact-next-approaches")),
        Line("exact-q", equal(x.N / x.Y, R * (1 - u) / p), identity("exact-eta"), LABEL,
             "q' = R(1-u)/p, R = r(1+d)"),
        Line("exact-u", equal(zeta_next, load),
             identity("", (("exact-end", common * x.B * x.A**2), ("exact-pull", common * lost))),
             LABEL,
             "ζ' = γ((q+ρu)² - q²)/p², γ = |W_c'|²/(|W_s|²(1+d')²)"),
    )  # fmt: skip
