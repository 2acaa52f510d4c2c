"""A run in which 0-1 and 0-2 collide in turn: its states, one step of it, and the induction.

Three balls of equal mass, any radii, any dimension. The state is that just after a collision: s is
the ball that just collided with 0, c the one that does so next. omega are the unit vectors from 0
to them and W their relative velocities, s and c the contact distances, D > c the distance of c; u
is the closing speed of the last collision, y the speed at which c approaches. Ghosts go along: b,
the closing speed u_0 of the collision before, and two terms of the comparison sequence.
"""

from __future__ import annotations

from collections.abc import Iterator

from verify.language.argument import (
    ByInduction,
    ByRoot,
    Chapter,
    Defined,
    Item,
    Line,
    Opened,
    identity,
    plus,
    power,
    proof,
    scaled,
    square,
    times,
)
from verify.language.statement import Always, Constant, Context, Given
from verify.language.terms import Claim, Term, as_term, equal, sqrt, substitute_claim, symbol
from verify.language.vectors import add, basis_vector, scale
from verify.paper.classification import flight
from verify.paper.letters import Letters, Space, tex

LABEL = "EQUATSS3.4ZKCl1CondiExist"
LAW = "EQUATSS2.2IterationSystm1"

_STATE = {
    "s": "σ_s",
    "c": "σ_c",
    "D": "|x_c|",
    "y": "-η_c",
    "eta": "η_s",
    "C": "-cos θ",
    "p": "ω_s·W_c",
    "q": "ω_c·W_s",
    "A": "|W_c|²",
    "B": "|W_s|²",
    "w": "W_s·W_c",
    "u": "u_n",
}
#: What goes along: b is (1+r)/2 (-cos theta), and a in the place of it at the first collision.
_GHOSTS = {"b": "b_n", "u_0": "u_{n-1}", "low": "s_{n-2}", "high": "s_{n-1}"}
first = Letters("first", r="r", a="a", **{name: f"({of})₁" for name, of in _STATE.items()})
v = Letters("run", **_STATE, **_GHOSTS)
r, a = first.r, first.a
half = (1 + r) / 2


def physical(n: Letters) -> dict[str, Claim]:
    """What holds after each collision of a run: contact distances, and the pair that collided."""
    return {
        "contact-s": 0 < n.s,
        "contact-c": 0 < n.c,
        "closed": 0 < n.u,
        "recedes": equal(n.eta, r * n.u),
    }


def ghosts() -> dict[str, Claim]:
    """What is carried besides."""
    return {
        "recursion": v.y <= v.b * v.u - r * v.u_0,
        "comparison": 0 <= v.high,
        "casoratian": v.u * v.low < v.u_0 * v.high,
    }


def discriminant(n: Letters) -> Term:
    """Positive where c meets 0, and does not graze it."""
    return n.D**2 * n.y**2 - n.A * (n.D**2 - n.c**2)


def goes_on(n: Letters) -> dict[str, Claim]:
    """What it means that another collision of the run follows."""
    return {"apart": n.c < n.D, "approaches": 0 < n.y, "meets": 0 < discriminant(n)}


def schwarz(n: Letters) -> dict[str, Claim]:
    """The two Cauchy-Schwarz inequalities that are used."""
    return {"cs-c": n.y**2 <= n.A, "cs-s": n.eta**2 <= n.B}


BENT: Claim = v.b <= a

space = Space({
    ("omega_s", "omega_s"): as_term(1), ("omega_c", "omega_c"): as_term(1),
    ("omega_s", "omega_c"): -v.C, ("omega_s", "W_s"): v.eta, ("omega_c", "W_c"): -v.y,
    ("omega_s", "W_c"): v.p, ("omega_c", "W_s"): v.q, ("W_c", "W_c"): v.A, ("W_s", "W_s"): v.B,
    ("W_s", "W_c"): v.w,
})  # fmt: skip
dot = space.dot
S, tau, u_next, E, high_next = map(symbol, ("S", "tau", "u_next", "E", "high_next"))
NUMBERS = ("y", "eta", "C", "p", "q", "A", "B", "w")
next_ = {name: symbol(f"{name}_next") for name in NUMBERS}
omega_s, W_s, omega_c, W_c = map(basis_vector, ("omega_s", "W_s", "omega_c", "W_c"))
end = add(scale(v.s, omega_s), scale(tau, W_s))
meeting = add(scale(v.D, omega_c), scale(tau, W_c))
new_s, new_c = scale(1 / v.c, meeting), scale(1 / E, end)
new_W_s = add(W_c, scale((1 + r) * u_next, new_s))
new_W_c = add(W_s, scale(half * u_next, new_s))


def definitions() -> tuple[Constant, ...]:
    """The next collision, and the state after it, in inner products."""
    terms = {
        "S": ("S", sqrt(discriminant(v))),
        "tau": ("τ", (v.D * v.y - S) / v.A),
        "u_next": ("u_{n+1}", S / v.c),
        "E": ("|x_s+τW_s|", sqrt(dot(end, end))),
        "y_next": ("-η_c'", -dot(new_c, new_W_c)),
        "eta_next": ("η_s'", dot(new_s, new_W_s)),
        "C_next": ("-cos θ'", -dot(new_s, new_c)),
        "p_next": ("ω_s'·W_c'", dot(new_s, new_W_c)),
        "q_next": ("ω_c'·W_s'", dot(new_c, new_W_s)),
        "A_next": ("|W_c'|²", dot(new_W_c, new_W_c)),
        "B_next": ("|W_s'|²", dot(new_W_s, new_W_s)),
        "w_next": ("W_s'·W_c'", dot(new_W_s, new_W_c)),
        "high_next": ("s_n", a * v.high - r * v.low),
    }
    return tuple(Constant(n, letter, tex(letter), LAW, term) for n, (letter, term) in terms.items())


def following() -> dict[str, Term]:
    """The next state: the balls have exchanged their roles."""
    return v.at(
        s=v.c, c=v.s, D=E, u=u_next, b=half * next_["C"], u_0=v.u, low=v.high, high=high_next,
        **next_,
    )  # fmt: skip


def beginning() -> dict[str, Term]:
    """The state after the first collision, with ghosts: s_{-1} = -1/r, s_0 = 0."""
    n = first
    state = {name: getattr(n, name) for name in _STATE}
    return v.at(**state, b=a, u_0=(a * n.u - n.y) / r, low=-(1 / r), high=0)


def carried() -> dict[str, Claim]:
    """What is shown from collision to collision."""
    return physical(v) | ghosts()


def standing() -> dict[str, tuple[Claim, str]]:
    """What a run, and vectors, are: for each inequality the assumption that grants it."""
    found = {name: (claim, "alternating-run") for name, claim in goes_on(v).items()}
    found |= {name: (claim, "cauchy-schwarz") for name, claim in schwarz(v).items()}
    return found | {"bent": (BENT, "alternating-run")}


def context() -> Context:
    """The states of a run, as long as it goes on."""
    given = [Given(f"run-{name}", claim, "carried") for name, claim in carried().items()]
    given += [
        Given(f"run-{name}", claim, "standing", by) for name, (claim, by) in standing().items()
    ]
    says = "a state of a run, just after a collision, where another collision of the run follows"
    return Context(
        v.context, v.variables(), tuple(given), beginning(), first.context, says, definitions()
    )


def chapters() -> Iterator[Chapter]:
    """The start, one step, and the induction."""
    start = first.opened(
        "a state just after the first collision of a run that goes on; r > 0, a is any number",
        "1/5 3/5 1 1 2 2/5 1/5 1 2/5 -1/5 4/25 1/25 2/25 1",
        {"r": 0 < r, **physical(first), **goes_on(first), **schwarz(first)},
    )
    yield Chapter(None, (Opened(start),))
    begin = beginning()
    lines = [Line(f"first-{name}", substitute_claim(claim, begin), proof(*addends))
             for (name, claim), addends in zip({**ghosts(), "bent": BENT}.items(),
                                               ((), (), (times("first-r", "first-closed"),), ()),
                                               strict=True)]  # fmt: skip
    premises = [f"first-{name}" for name in (*carried(), *standing())]
    yield Chapter(first.context, (*lines, Opened(context(), tuple(premises))))
    yield Chapter(v.context, (*_meeting(), *_path_c(), *_path_s(), *_laws(), *_count()))
    always = Line("run-always", Always(v.context, begin, following()),
                  ByInduction(tuple(f"first-{name}" for name in carried()),
                              tuple(f"next-{name}" for name in carried())), LABEL,
                  "by induction, as long as the run goes on, u_{n+1} s_{n-1} < u_n s_n, where s_0 "
                  "= 0, s_1 = 1, s_{n+1} = a s_n - r s_{n-1}; so s_n > 0 if there is an (n+1)-th "
                  "collision", ("alternating-run", "cauchy-schwarz"))  # fmt: skip
    yield Chapter(first.context, (always,))


def _meeting() -> Iterator[Item]:
    """The time to the next collision, and its closing speed."""
    yield from (
        Line("speed-positive", 0 < v.A, proof("run-cs-c", power("run-approaches", 2))),
        Line("D-positive", 0 < v.D, proof("run-apart", "run-contact-c")),
        Line("root-positive", 0 < sqrt(discriminant(v)), ByRoot()),
        Defined("S"),
        Line("S-positive", 0 < S, proof("root-positive", using="S")),
        Defined("tau"),
        Line("tau-positive", 0 < tau,
             scaled(times("goal", plus("S-positive", times("D-positive", "run-approaches"))),
                    times("speed-positive", "run-apart",
                          plus("run-apart", times(2, "run-contact-c"))), using="tau S"),
             LAW, "the next collision of the run takes place later"),
        Line("contact", equal(dot(meeting, meeting), v.c**2), identity("tau S"),
             LAW, "at that time 0 and c are in contact"),
        Defined("u_next"),
        Line("u_next-positive", 0 < u_next, proof("S-positive", using="u_next")),
        Line("impact", equal(dot(new_s, W_c), -u_next), identity("tau u_next"),
             LAW, "and u_{n+1} is the speed at which they close"),
    )  # fmt: skip


def _path_c() -> Iterator[Item]:
    """The ball that will collide does not approach faster."""
    at_c = flight.values(v.D, -v.y, v.A, tau, v.c)
    yield from (
        Line("path-c",    flight.given_at("distance", at_c),
             identity("", (("contact", as_term(-1)),))),
        Line("cs-path-c", flight.given_at("cs", at_c),
             proof(times(power("D-positive", 2), "run-cs-c"))),
    )  # fmt: skip
    premises = ("D-positive", "run-contact-c", "tau-positive", "cs-path-c", "path-c")
    yield from flight.used("flight-c", flight.NORMAL, at_c, premises)
    yield Line("closing", u_next <= v.y,
               scaled(times("speed-positive", "goal"), "flight-c", using="u_next tau"), LABEL,
               "u_{n+1} ≤ y: in flight the speed of approach does not grow", ("cauchy-schwarz",),
    )  # fmt: skip


def _path_s() -> Iterator[Item]:
    """The ball that has collided does not recede more slowly."""
    at_s = flight.values(v.s, v.eta, v.B, tau, E)
    yield from (
        Line("eta-positive", 0 < v.eta,
             proof(times("first-r", "run-closed"), equations=(("run-recedes", as_term(1)),))),
        Line("path-positive", 0 < dot(end, end),
             proof(power("run-contact-s", 2),
                   times(2, "run-contact-s", "tau-positive", "eta-positive"),
                   times(power("tau-positive", 2), "run-cs-s"), square(tau * v.eta))),
        Line("E-root", 0 < sqrt(dot(end, end)), ByRoot()),
        Defined("E"),
        Line("E-positive", 0 < E, proof("E-root", using="E")),
        Line("path-s", flight.given_at("distance", at_s), identity("E")),
        Line("cs-path-s", flight.given_at("cs", at_s),
             proof(times(power("run-contact-s", 2), "run-cs-s"))),
    )  # fmt: skip
    premises = ("run-contact-s", "E-positive", "tau-positive", "cs-path-s", "path-s")
    yield from flight.used("flight-s", flight.NORMAL, at_s, premises)


def _laws() -> Iterator[Item]:
    for name in NUMBERS:
        yield Defined(f"{name}_next")
    yield from (
        Line("law-approach",   equal(next_["y"],
                                     half * next_["C"] * u_next - (v.s * v.eta + tau * v.B) / E),
             identity("y_next C_next"), LAW,
             "-η_c' = (1+r)/2 (-cos θ') u_{n+1} - ρ, ρ the speed at which s recedes at the "
             "collision", ("hard-spheres",)),
        Line("next-recedes",   equal(next_["eta"], r * u_next),
             identity("eta_next", (("contact", (1 + r) * u_next), ("impact", v.c))),
             LAW, "the pair that collided recedes at r times its closing speed", ("hard-spheres",)),
        Line("next-recursion", next_["y"] <= half * next_["C"] * u_next - r * v.u,
             scaled(times("E-positive", "goal"), "flight-s")
             ._replace(equations=(("law-approach", as_term(-1)), ("run-recedes", E))), LABEL,
             "so u_{n+2} ≤ (1+r)/2 (-cos θ_{n+1}) u_{n+1} - r u_n, by `closing` at the next state",
             ("hard-spheres", "cauchy-schwarz")),
    )  # fmt: skip


def _count() -> Iterator[Item]:
    yield Defined("high_next")
    for name in ("contact-s", "contact-c"):
        other = "contact-c" if name == "contact-s" else "contact-s"
        yield Line(f"next-{name}", 0 < (v.c if name == "contact-s" else v.s), proof(f"run-{other}"))
    yield from (
        Line("next-closed",         0 < u_next, proof("u_next-positive")),
        Line("speed-bound",         v.y <= a * v.u - r * v.u_0,
             proof("run-recursion", times("run-bent", "run-closed")),
             LABEL, "u_{n+1} ≤ y ≤ a u_n - r u_{n-1}, if (1+r)/2 (-cos θ_n) ≤ a"),
        Line("casoratian-speed",    v.y * v.high < v.u * high_next,
             proof(times("run-comparison", "speed-bound"), times("first-r", "run-casoratian"),
                   using="high_next")),
        Line("comparison-positive", 0 < high_next,
             scaled(times("goal", "run-closed"), "casoratian-speed",
                    times("run-approaches", "run-comparison")),
             LABEL, "s_n > 0 while collision n+1 takes place"),
        Line("next-comparison",     0 <= high_next, proof("comparison-positive")),
        Line("next-casoratian",     u_next * v.high < v.u * high_next,
             proof("casoratian-speed", times("closing", "run-comparison")), LABEL,
             "u_{n+1} s_{n-1} < u_n s_n: the Casoratian of the speeds and the comparison sequence"),
    )  # fmt: skip
