"""Where u does not tend to 0: then no orbit goes on for ever, since below it u would have to.

Two weights do not shrink, but for the ratio: u/q² once q ≥ F, where r ≤ F(a-F) fails or is equal;
and u q/(s-q)³, s³ = r, as long as q < s² and if a ≤ s + s². For u = 0 and a = s + s² the second one
is kept exactly.
"""

from __future__ import annotations

from collections.abc import Iterator, Mapping

from verify.language.argument import (
    ByInduction,
    BySum,
    Chapter,
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
from verify.language.statement import Always, Context, Given
from verify.language.terms import Claim, Term, as_term, equal, substitute_claim
from verify.paper.letters import Letters
from verify.paper.separatrix.model import (
    LIMIT_MAP,
    THRESHOLD,
    UNENDING,
    Names,
    State,
    constants_of,
    image,
    state,
)
from verify.paper.separatrix.order import outermost

NONE = "glue-none"
HALF = as_term(1) / 2

stay = Letters("stay", r="r", a="a", rho="ρ", sigma="σ", F="F", c="c", q="q", u="u", m="m")
grows = Letters("grows", rho="ρ", sigma="σ", q="q", u="u", m="m")
short = Letters("short", r="r", a="a", rho="ρ", sigma="σ", s="s", c="c", q="q", u="u", m="m")
climbs = Letters("climbs", rho="ρ", sigma="σ", q="q", u="u", m="m")
beyond = Letters("beyond", r="r", a="a", F="F")
flat = Letters("flat", r="r", a="a", s="s")


def chapters() -> Iterator[Chapter]:
    """The two weights, and that the first one serves from phi_plus on."""
    yield from _grows()
    yield from _climbs()
    yield from _beyond()
    yield from _flat()


def _common(of: State, sigma: Term, c: Term, m: Term) -> dict[str, Claim]:
    return {
        "rho": 0 < of.rho,
        "sigma": 0 < sigma,
        "inverse": equal(of.rho * sigma, 1),
        "u": 0 < of.u,
        "u1": of.u < 1,
        "m": c <= m,
        "rm": c <= of.rho * m,
    }


def _induction(
    outer: Letters,
    inner: Letters,
    carried: Mapping[str, Claim],
    standing: Mapping[str, Claim],
    says: str,
    reasons: tuple[Item, ...],
    told: str,
) -> Iterator[Chapter]:
    """The context of the states, what is shown in it, and the induction in the outer one."""
    here, prefix = _inner(outer, inner), inner.context
    begin = inner.at(**{name: getattr(outer, name) for name in inner.letters})
    following = inner.at(rho=inner.sigma, sigma=inner.rho, q=here.x, u=here.v,
                         m=inner.rho * inner.m)  # fmt: skip
    givens = [Given(f"{prefix}-{name}", claim, "carried") for name, claim in carried.items()]
    givens += [Given(f"{prefix}-{n}", claim, "standing", UNENDING) for n, claim in standing.items()]
    premises = tuple(f"{outer.context}-{name}" for name in carried)
    more = tuple(f"{outer.context}-{name}" for name in standing)
    place = Context(prefix, inner.variables(), tuple(givens), begin, outer.context, says,
                    here.constants())  # fmt: skip
    yield Chapter(outer.context, (Opened(place, (*premises, *more)),))
    k, inverse = Names(prefix), ((f"{prefix}-inverse", as_term(1)),)
    simple: dict[str, BySum] = {
        "rho": proof(k.sigma),
        "sigma": proof(k.rho),
        "inverse": identity(equations=inverse),
        "u": proof(k.v_positive),
        "u1": proof(f"{here.v.name}-one"),
        "m": proof(k.rm),
        "rm": proof(k.m, equations=((f"{prefix}-inverse", inner.m),)),
    }
    lines = [
        Line(f"{prefix}-next-{name}", substitute_claim(claim, following), simple[name])
        for name, claim in carried.items() if name in simple
    ]  # fmt: skip
    yield Chapter(prefix, (*_image(here, k), *reasons, *lines))
    always = Line(f"{prefix}-always", Always(prefix, begin, following),
                  ByInduction(premises, tuple(f"{prefix}-next-{name}" for name in carried)),
                  THRESHOLD, told, (LIMIT_MAP, UNENDING, NONE))  # fmt: skip
    yield Chapter(outer.context, (always,))


def _inner(outer: Letters, inner: Letters) -> State:
    return state(inner, outer)._replace(rho=inner.rho)


def _image(here: State, k: Names) -> Iterator[Item]:
    """The image, with v > 0 and m > 0; q > 0 has to be known as ``k.q_positive``."""
    v = here.v.name
    outer = {"grows": "stay", "climbs": "short"}[k.prefix]
    positive = k.q if k.prefix == "climbs" else plus(k.q, "stay-F")
    yield from image(here, k.p, k.meets)
    yield from (
        Line(k.v_positive, 0 < here.v,
             scaled(times("goal", plus(1, f"{v}-one"), power(k.p, 2)),
                    times(k.rho, k.u, plus(times(2, positive), times(k.rho, k.u))))
             ._replace(equations=((f"{v}-equation", as_term(-1)),))),
        Line(k.m_positive, 0 < (grows if outer == "stay" else climbs).m,
             proof(k.m, f"{outer}-c")),
    )  # fmt: skip


# --- u/q² -----------------------------------------------------------------------------------------


def _grows() -> Iterator[Chapter]:
    def claims(n: Letters) -> dict[str, Claim]:
        of = _inner(stay, n)
        return {
            "q": stay.F <= n.q,
            **_common(of, n.sigma, stay.c, n.m),
            "weight": n.m * n.q**2 <= n.u,
        }

    here, first = _inner(stay, grows), _inner(stay, stay)
    given = {"F": 0 < stay.F, "size": stay.r**2 <= stay.F**3,
             "fixed": stay.F * (stay.a - stay.F) <= stay.r, "c": 0 < stay.c,
             **claims(stay), **first.goes_on()}  # fmt: skip
    says = "F(a-F) ≤ r and r² ≤ F³; a state with q ≥ F, and a number m with mq² ≤ u"
    outer = outermost(stay, says, "1 1 23/50 1/1000 23/50 1/1000 1/1000", given)
    yield Chapter(None, (Opened(outer),))
    k, x, v = Names("grows", r="stay-r", a="stay-a", F="stay-F"), here.x, here.v
    rest, m, q, u = 1 - here.u, grows.m, grows.q, grows.u
    reasons = (
        Line("grows-next-q", stay.F <= x,
             scaled(times("goal", k.p), times("stay-fixed", k.u1),
                    times(k.F, plus(k.q, times(k.F, k.u), times(k.rho, k.u))))
             ._replace(equations=((f"{x.name}-equation", as_term(1)),)),
             THRESHOLD, "if F(a-F) ≤ r, then q ≥ F stays: x ≥ r/(a-F) ≥ F", (LIMIT_MAP,)),
        Line("grows-next-weight", grows.rho * m * x**2 <= v,
             scaled(times(2, "goal", power(k.p, 2)), times(power(k.v_positive, 2), power(k.p, 2)),
                    times(power(k.rho, 2), power(k.u, 2)),
                    times(2, k.rho, k.m_positive, power(k.r, 2), k.u, plus(1, k.u1)),
                    times(2, k.rho, k.m_positive, "stay-size"),
                    times(2, k.rho, k.m_positive, k.q,
                          plus(square(q), times(plus(k.q, k.F), k.F), power(k.F, 2))),
                    times(2, k.rho, plus(k.q, k.F), k.weight))
             ._replace(equations=(
                 (f"{x.name}-equation", -2 * grows.rho * m * (x * here.p + stay.r * rest)),
                 (f"{v.name}-equation", as_term(-1)))),
             THRESHOLD, "u/q² grows at least by the ratio ρ if q³ ≥ F³ ≥ r²", (LIMIT_MAP,)),
        Line("grows-bound", stay.c * stay.F**2 <= u,
             proof(k.weight, times(k.m, square(q)), times("stay-c", k.q, plus(k.q, times(2, k.F)))),
             THRESHOLD, "so u is at least cF²", (UNENDING, NONE)),
    )  # fmt: skip
    told = "by induction, as long as the collisions go on, q ≥ F and u ≥ cF²"
    yield from _induction(stay, grows, claims(grows), here.goes_on(), "a state with q ≥ F",
                          reasons, told)  # fmt: skip


# --- uq/(s-q)³ ------------------------------------------------------------------------------------


def _climbs() -> Iterator[Chapter]:
    s = short.s

    def claims(n: Letters) -> dict[str, Claim]:
        of = _inner(short, n)
        found = _common(of, n.sigma, short.c, n.m)
        return {"q": 0 < n.q, **found, "weight": n.m * (s - n.q) ** 3 <= n.u * n.q}

    here, first = _inner(short, climbs), _inner(short, short)
    given = {"s": 0 < s, "cube": equal(s**3, short.r), "low": short.a <= s + s**2,
             "c": 0 < short.c, **claims(short), **first.goes_on(),
             "below": short.q < s**2}  # fmt: skip
    says = "s³ = r and a ≤ s + s²; a state with q < s², and a number m with m(s-q)³ ≤ uq"
    outer = short.opened(says, "1/27 4/9 1 1 1/3 1/1000 1/10 1/100 1/1000",
                         constants_of(short) | given)  # fmt: skip
    k, x, v = Names("climbs", r="short-r", a="short-a", s="short-s"), here.x, here.v
    p, rest, m, q, u = here.p, 1 - here.u, climbs.m, climbs.q, climbs.u
    y, z = (s - x) * p, s * rest * (s - q)
    yield Chapter(None, (Opened(outer),))
    one = as_term(1)
    yield Chapter(short.context, (
        Line("short-one", s < 1,
             scaled(times("goal", plus(power("short-s", 2), "short-s", 1)), "short-r-one")
             ._replace(equations=(("short-cube", -one),))),
        Line("short-fits", s**2 * (short.a - s**2) <= short.r,
             proof(times(power("short-s", 2), "short-low"), equations=(("short-cube", -one),)),
             THRESHOLD, "if a ≤ s + s², then F = s² has F(a-F) ≤ r", (NONE,)),
        Line("short-size", short.r**2 <= (s**2) ** 3,
             proof(equations=(("short-cube", s**3 + short.r),)),
             THRESHOLD, "and F³ = r²", (NONE,)),
    ))  # fmt: skip
    reasons = (
        Line("climbs-next-q", 0 < x,
             scaled(times(k.p, "goal"), times(k.r, k.u1))
             ._replace(equations=((f"{x.name}-equation", one),))),
        Line("climbs-slope", y <= z,
             proof(times(k.s, k.u1, "short-low"), times(k.s, k.u, plus(k.q, k.rho)),
                   equations=((f"{x.name}-equation", one), ("short-cube", -rest))),
             THRESHOLD, "(s-x)p ≤ s(1-u)(s-q), as a ≤ s + s²", (LIMIT_MAP,)),
        Line("climbs-cube", y**3 <= z**3,
             proof(times("climbs-slope", plus(square(z + HALF * y), times("3/4", square(y)))))),
        Line("climbs-next-weight", climbs.rho * m * (s - x) ** 3 <= v * x,
             scaled(times(2, "goal", power(k.p, 3)), times(2, k.rho, k.m_positive, "climbs-cube"),
                    times(2, k.rho, power(k.s, 3), power(k.u1, 3), k.weight),
                    times(power(k.v_positive, 2), power(k.p, 3), "climbs-next-q"),
                    times(power(k.rho, 2), power(k.u, 2), k.r, k.u1),
                    times(2, k.rho, k.u, k.q, power(k.s, 3), k.u1, k.u, plus(1, k.u1)))
             ._replace(equations=((f"{v.name}-equation", -x * p),
                                  (f"{x.name}-equation", here.top),
                                  ("short-cube", -2 * climbs.rho * u * q * rest))),
             THRESHOLD, "uq/(s-q)³ grows at least by the ratio ρ", (LIMIT_MAP,)),
        Line("climbs-far", 0 < s - s**2, proof(times(k.s, "short-one"))),
        Line("climbs-bound", short.c * (s - s**2) ** 3 <= u,
             proof(k.weight, times(k.u, "short-one", plus(1, k.s)), times(k.u, k.below),
                   times(k.m, power(plus(k.below, "climbs-far"), 3)),
                   times("short-c", k.below, plus(
                       power(plus(k.below, "climbs-far"), 2),
                       times(plus(k.below, "climbs-far"), "climbs-far"), power("climbs-far", 2)))),
             THRESHOLD, "so u is at least c(s-s²)³", (UNENDING, NONE)),
    )  # fmt: skip
    told = "by induction, as long as the collisions go on and q < s², u ≥ c(s-s²)³"
    standing = {**here.goes_on(), "below": q < s**2}
    yield from _induction(short, climbs, claims(climbs), standing, "a state with q < s²", reasons,
                          told)  # fmt: skip


def _beyond() -> Iterator[Chapter]:
    """From phi_plus on, F = q will do."""
    F, r = beyond.F, beyond.r
    given = {
        "half": beyond.a <= 2 * F,
        "fixed": F * (beyond.a - F) <= r,
        "real": 4 * r <= beyond.a**2,
    }
    place = outermost(beyond, "F ≥ φ⁺, where φ± are real", "23/50", given)
    lines = (
        Line("beyond-positive", 0 < F, scaled(times(2, "goal"), "beyond-half", "beyond-a")),
        Line("beyond-square", r <= F**2,
             proof(times("1/4", "beyond-real"),
                   times("1/4", "beyond-half", plus("beyond-half", times(2, "beyond-a"))))),
        Line("beyond-larger", r < F,
             scaled(times("goal", plus("beyond-r", "beyond-positive")), "beyond-square",
                    times("beyond-r", "beyond-r-one"))),
        Line("beyond-size", r**2 <= F**3,
             proof(times("beyond-positive", "beyond-square"), times("beyond-r", "beyond-larger")),
             THRESHOLD, "from φ⁺ on, F = q has F(a-F) ≤ r and r² ≤ F³", (NONE,)),
    )  # fmt: skip
    yield Chapter(None, (Opened(place),))
    yield Chapter(beyond.context, lines)


def _flat() -> Iterator[Chapter]:
    """The threshold without a cube root."""
    a, r, s = flat.a, flat.r, flat.s
    given = {"s": 0 < s, "cube": equal(s**3, r), "cubic": a**3 - 3 * r * a <= r * (1 + r)}
    place = flat.opened("s³ = r, and a³ - 3ra ≤ r(1+r)", "1/27 4/9 1/3", constants_of(flat) | given)
    rest = plus(power("flat-a", 2), times("flat-a", "flat-s", plus(1, "flat-s")),
                times("1/2", power("flat-s", 2)), times("1/2", square(s * (1 - s))),
                times("1/2", power("flat-s", 4)))  # fmt: skip
    line = Line("flat-low", a <= s + s**2,
                scaled(times("goal", rest), "flat-cubic")
                ._replace(equations=(("flat-cube", 3 * a + 1 + s**3 + r),)),
                THRESHOLD, "a³ - 3ra ≤ r(1+r) is the same as a ≤ s + s²", (NONE,))  # fmt: skip
    yield Chapter(None, (Opened(place),))
    yield Chapter(flat.context, (line,))
