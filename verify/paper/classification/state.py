"""A state of a run in which 0-1 and 0-2 collide in turn, and the state after it.

Three balls of equal mass, any radii, any dimension. The state is that just after a collision: s is
the ball that just collided with 0, c the one that does so next. omega are the unit vectors from 0
to them and W their relative velocities, s and c the contact distances, D > c the distance of c; u
is the closing speed of the last collision, y the speed at which c approaches. Ghosts go along: b,
the closing speed u_0 of the collision before, and two terms of the comparison sequence.
"""

from __future__ import annotations

from verify.language.statement import Constant, Context, Given
from verify.language.terms import Claim, Term, as_term, equal, sqrt, symbol
from verify.language.vectors import add, basis_vector, scale
from verify.paper.classification.settings import Letters, Space, tex

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
