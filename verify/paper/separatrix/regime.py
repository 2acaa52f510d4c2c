"""Below an orbit that never ends, u tends to 0: the sum of all u is bounded.

L is u/U at the start. At each step u ≤ l U and l falls to l(1 - (1-L)U), so that (1-L)u is at most
what l loses.
"""

from __future__ import annotations

from collections.abc import Iterator

from verify.language.argument import (
    ByInduction,
    Chapter,
    Item,
    Line,
    Opened,
    Value,
    identity,
    plus,
    power,
    proof,
    scaled,
    times,
)
from verify.language.statement import Always, Context, Given
from verify.language.terms import Claim, as_term, equal, substitute_claim
from verify.paper.letters import Letters
from verify.paper.separatrix.model import LABEL, LIMIT_MAP, UNENDING, Names, State, image, state
from verify.paper.separatrix.order import outermost, under

REGIME = "glue-regime"

pair = Letters("pair", r="r", a="a", rho="ρ", sigma="σ", q="q", u="u", Q="Q", U="U", L="L")
n = Letters("falls", rho="ρ", sigma="σ", q="q", u="u", Q="Q", U="U", l="l", t="t")


def _state(letters: Letters, names: str) -> State:
    found = state(letters, pair, names)
    return found._replace(rho=letters.rho)


small, large = _state(n, "q u x v"), _state(n, "Q U X V")
first = _state(pair, "Q U X V")
factor = 1 - (1 - pair.L) * n.U


def conditions() -> dict[str, Claim]:
    """What is shown from collision to collision."""
    return {
        "rho": 0 < n.rho,
        "sigma": 0 < n.sigma,
        "inverse": equal(n.rho * n.sigma, 1),
        "q": 0 <= n.q,
        "qQ": n.q <= n.Q,
        "u": 0 < n.u,
        "share": n.u <= n.l * n.U,
        "U1": n.U < 1,
        "l": 0 < n.l,
        "less": n.l <= pair.L,
        "t": 0 <= n.t,
        "sum": n.t * (1 - pair.L) + n.l <= pair.L,
    }


following = n.at(rho=n.sigma, sigma=n.rho, q=small.x, u=small.v, Q=large.x, U=large.v,
                 l=n.l * factor, t=n.t + n.u)  # fmt: skip
beginning = n.at(rho=pair.rho, sigma=pair.sigma, q=pair.q, u=pair.u, Q=pair.Q, U=pair.U,
                 l=pair.L, t=0)  # fmt: skip


def chapters() -> Iterator[Chapter]:
    """The start, one step, and the induction."""
    given = {"rho": 0 < pair.rho, "sigma": 0 < pair.sigma,
             "inverse": equal(pair.rho * pair.sigma, 1), "q": 0 <= pair.q, "qQ": pair.q <= pair.Q,
             "u": 0 < pair.u, "share": pair.u <= pair.L * pair.U, "U1": pair.U < 1,
             "l": 0 < pair.L, "L1": pair.L < 1, **first.goes_on()}  # fmt: skip
    says = "(q, u) lies below (Q, U), and u ≤ LU with L < 1; (Q, U) has an image"
    outer = outermost(pair, says, "1 1 1/20 1/200 1/10 1/100 1/2", given)
    start = [
        Line(f"begin-{name}", substitute_claim(claim, beginning),
             proof(*([f"pair-{name}"] if name in given else [])))
        for name, claim in conditions().items() if name != "inverse"
    ]  # fmt: skip
    premises = ["pair-inverse" if name == "inverse" else f"begin-{name}" for name in conditions()]
    place = Context(
        n.context, n.variables(), (*_givens("carried", conditions()),
                                   *_givens("standing", large.goes_on())), beginning,
        pair.context, "two states after the same number of collisions",
        (*large.constants(), *small.constants()),
    )  # fmt: skip
    yield Chapter(None, (Opened(outer),))
    yield Chapter(
        pair.context, (*start, Opened(place, (*premises, *(f"pair-{g}" for g in large.goes_on()))))
    )
    yield Chapter(n.context, tuple(_step()))
    always = Line("falls-always", Always(n.context, beginning, following),
                  ByInduction(tuple(premises), tuple(f"next-{name}" for name in conditions())),
                  LABEL, "by induction, as long as the collisions of (Q, U) go on, so do those of "
                  "(q, u), and u₀ + … + u_n ≤ L/(1-L)",
                  (LIMIT_MAP, UNENDING, "bounded-monotone", REGIME),
    )  # fmt: skip
    yield Chapter(pair.context, (always,))


def _givens(kind: str, claims: dict[str, Claim]) -> Iterator[Given]:
    by = UNENDING if kind == "standing" else None
    return (Given(f"falls-{name}", claim, kind, by) for name, claim in claims.items())


def _step() -> Iterator[Item]:
    k = Names("falls", r="pair-r", a="pair-a", L="pair-l", L1="pair-L1", V1="falls.V-one")
    V, X = large.v.name, large.x.name
    one = as_term(1)
    yield from (
        Line("falls-U-positive", 0 < n.U, scaled(times(k.l, "goal"), k.share, k.u)),
        Line("falls-uU", n.u <= n.U,
             proof(k.share, times("falls-U-positive", plus(k.less, k.L1)))),
    )  # fmt: skip
    yield from image(large, k.p, k.meets)
    yield from (
        Line(k.x, pair.r * (1 - n.U) <= large.x * large.p,
             proof(equations=((f"{X}-equation", one),))),
        Line(k.top, large.top <= large.v * (2 - large.v) * large.p**2,
             proof(equations=((f"{V}-equation", -one),))),
    )  # fmt: skip
    yield from _positive(k)
    yield from under(k, small, large, large.x, large.v)
    yield from _shares(k)
    yield from _next(k)
    yield Line("falls-total", n.t * (1 - pair.L) <= pair.L, proof(k.sum, k.l), LABEL,
               "so all u together are at most L/(1-L)", (UNENDING, REGIME))  # fmt: skip


def _positive(k: Names) -> Iterator[Item]:
    """V > 0, before the order of the states is known."""
    V = large.v.name
    yield Line(k.V, 0 < large.v,
               scaled(times("goal", plus(1, f"{V}-one"), power(k.p, 2)),
                      times(k.rho, "falls-U-positive", plus(times(2, k.q), times(2, k.qQ),
                                                            times(k.rho, "falls-U-positive"))))
               ._replace(equations=((f"{V}-equation", as_term(-1)),)))  # fmt: skip


def _shares(k: Names) -> Iterator[Item]:
    """By which factor u/U falls."""
    p, P, v, V = small.p, large.p, small.v, large.v
    U = "falls-U-positive"
    both: Value = plus(k.V1, 1)
    yield from (
        Line("falls-factor", 0 < factor, proof(k.U1, times(k.L, U))),
        Line("falls-gain", P <= p * factor,
             proof(times(k.rho, k.uU), k.qQ, times(k.a, k.share), times(k.a, k.less, U),
                   times(k.L1, U, plus(times(k.a, k.u), k.q, times(k.rho, k.u)))),
             LABEL, "P ≤ (1 - (1-L)U)p: the ratio of successive speeds is smaller above",
             (LIMIT_MAP,)),
        Line("falls-top-share", small.top <= n.l * large.top,
             proof(times(k.rho, k.share, plus(times(2, k.q), times(2, k.qQ), times(k.rho, U))),
                   times(k.rho, k.u, plus(times(2, k.qQ), times(k.rho, k.uU))))),
        Line("next-share", v <= n.l * factor * V,
             scaled(times("goal", both, power(k.smaller_p, 2)),
                    times(k.v_positive, k.v_below, power(k.smaller_p, 2)), "falls-top-share",
                    times(k.V, both, k.l, "falls-gain",
                          plus(k.p, times("falls-factor", k.smaller_p))),
                    times(k.V, both, k.l, power(k.smaller_p, 2), "falls-factor", k.L1, U))
             ._replace(equations=((f"{v.name}-equation", as_term(1)),
                                  (f"{V.name}-equation", -n.l))),
             LABEL, "v ≤ l(1-(1-L)U) V, since u(2-u)/u falls with u", (LIMIT_MAP,)),
    )  # fmt: skip


def _next(k: Names) -> Iterator[Item]:
    claims = {name: substitute_claim(claim, following) for name, claim in conditions().items()}
    U = "falls-U-positive"
    because = {
        "rho": (k.sigma,),
        "sigma": (k.rho,),
        "q": (k.x_positive,),
        "qQ": (k.x_below,),
        "u": (k.v_positive,),
        "U1": (k.V1,),
        "l": (times(k.l, "falls-factor"),),
        "less": (k.less, times(k.l, k.L1, U)),
        "t": (k.t, k.u),
        "sum": (k.sum, times(k.L1, k.share)),
    }
    for name, claim in claims.items():
        if name == "inverse":
            yield Line(f"next-{name}", claim, identity(equations=((k.inverse, as_term(1)),)))
        elif name in because:
            yield Line(f"next-{name}", claim, proof(*because[name]))
