"""Where the collisions never end: two boxes that the map exchanges, and one for every a > s + s².

The boxes are q ≤ Q, u ≤ U and q ≤ Q, u ≤ W. With Q = s², s³ = r, and W = ρU small they are such
if a > s + s².
"""

from __future__ import annotations

from collections.abc import Iterator
from fractions import Fraction

from verify.language.argument import (
    ByApplying,
    ByInduction,
    BySum,
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
    times,
)
from verify.language.statement import Always, Applies, Constant, Context, Given
from verify.language.terms import Claim, Term, as_term, equal, substitute_claim, symbol
from verify.paper.letters import Letters
from verify.paper.separatrix.model import (
    LABEL,
    LIMIT_MAP,
    THRESHOLD,
    Names,
    State,
    constants_of,
    state,
)
from verify.paper.separatrix.order import outermost, under

EXISTS = "glue-exists"

trap = Letters("trap", r="r", a="a", rho="ρ", sigma="σ", Q="Q", U="U", W="W", q="q", u="u")
n = Letters("trapped", rho="ρ", sigma="σ", q="q", u="u", U="U", W="W")
room = Letters("room", r="r", a="a", rho="ρ", sigma="σ", s="s")

SMALL, U, W = (symbol(f"room.{name}") for name in ("e", "U", "W"))


def box(rho: Term, inside: Term, then: Term) -> dict[str, Claim]:
    """The map with this ratio takes (Q, inside) below (Q, then)."""
    return State(trap.r, trap.a, rho, trap.Q, inside, inside, inside).leads_to(trap.Q, then)


def conditions(of: Letters) -> dict[str, Claim]:
    """What holds in each of the two boxes in turn."""
    there = {f"back-{name}": claim for name, claim in box(of.sigma, of.W, of.U).items()}
    return {
        "rho": 0 < of.rho,
        "sigma": 0 < of.sigma,
        "q": 0 <= of.q,
        "qQ": of.q <= trap.Q,
        "u": 0 < of.u,
        "uU": of.u <= of.U,
        "U1": of.U < 1,
        "V": 0 <= of.W,
        "V1": of.W < 1,
        **box(of.rho, of.U, of.W),
        **there,
    }


def chapters() -> Iterator[Chapter]:
    """The two boxes, the induction, and boxes for every a > s + s²."""
    outer = outermost(trap, "two boxes that the map exchanges, and a state in the first one",
                      "1 1 1/10 1/1000 1/1000 1/10 1/1000", conditions(trap))  # fmt: skip
    start = n.at(**{name: getattr(trap, name) for name in n.letters})
    small = state(n, trap)._replace(rho=n.rho)
    large = State(trap.r, trap.a, n.rho, trap.Q, n.U, n.U, n.U)
    given = tuple(Given(f"trapped-{name}", c, "carried") for name, c in conditions(n).items())
    premises = tuple(f"trap-{name}" for name in conditions(n))
    place = Context(n.context, n.variables(), given, start, trap.context,
                    "a state in the box whose turn it is", small.constants())  # fmt: skip
    following = n.at(rho=n.sigma, sigma=n.rho, q=small.x, u=small.v, U=n.W, W=n.U)
    k = Names("trapped", r="trap-r", a="trap-a")
    yield Chapter(None, (Opened(outer),))
    yield Chapter(trap.context, (Opened(place, premises),))
    yield Chapter(n.context, (*under(k, small, large, trap.Q, n.W), *_next(k, following)))
    always = Line("trapped-always", Always(n.context, start, following),
                  ByInduction(premises, tuple(f"next-trapped-{name}" for name in conditions(n))),
                  LABEL, "by induction the collisions never end from a state in the boxes",
                  (LIMIT_MAP, EXISTS))  # fmt: skip
    yield Chapter(trap.context, (always,))
    yield from _room()


def _next(k: Names, following: dict[str, Term]) -> Iterator[Item]:
    because = {"rho": "sigma", "sigma": "rho", "q": "x-positive", "qQ": "x-below",
               "u": "v-positive", "uU": "v-below", "U1": "V1", "V1": "U1"}  # fmt: skip
    for role in ("p", "x", "top"):
        because |= {role: f"back-{role}", f"back-{role}": role}
    for role, claim in conditions(n).items():
        known = [k.u, k.uU] if role == "V" else [f"{k.prefix}-{because[role]}"]
        yield Line(f"next-trapped-{role}", substitute_claim(claim, following), proof(*known))


# --- boxes for every a > s + s² -------------------------------------------------------------------


def _room() -> Iterator[Chapter]:
    s, a = room.s, room.a
    excess = a - s - s**2
    terms = {SMALL: s * excess / (4 * (1 + a)), U: SMALL / (1 + room.rho),
             W: room.rho * SMALL / (1 + room.rho)}  # fmt: skip
    given = {**constants_of(room), "rho": 0 < room.rho, "sigma": 0 < room.sigma,
             "inverse": equal(room.rho * room.sigma, 1), "s": 0 < s, "cube": equal(s**3, room.r),
             "excess": 0 < excess}  # fmt: skip
    place = room.opened("s³ = r and a > s + s²", "1/125 2/5 1 1 1/5", given)
    constants = tuple(
        Constant(name.name, letter := name.name.rpartition(".")[2], letter, THRESHOLD, term)
        for name, term in terms.items()
    )
    at = {"r": room.r, "a": a, "rho": room.rho, "sigma": room.sigma, "Q": s**2, "U": U, "W": W,
          "q": s**2, "u": U}  # fmt: skip
    values = trap.at(**at)
    yield Chapter(None, (Opened(place._replace(constants=constants)),))
    lines = tuple(_fits())
    claims = {**constants_of(trap), **conditions(trap)}
    given_lines = tuple(
        Line(f"trap-fits-{role}", substitute_claim(claim, values), _why(role))
        for role, claim in claims.items()
        if role.removeprefix("back-") not in ("p", "x", "top")
    )
    fits = tuple(f"trap-fits-{role}" for role in claims)
    applies = Line("room-trap", Applies(trap.context, values), ByApplying(fits), THRESHOLD,
                   "if a > s + s², then Q = s², U and W = ρU are two such boxes",
                   (LIMIT_MAP, EXISTS))  # fmt: skip
    yield Chapter(room.context, (*lines, *given_lines, applies))


def _fits() -> Iterator[Item]:
    """The two boxes, and that the map exchanges them."""
    s, a, rho, sigma = room.s, room.a, room.rho, room.sigma
    one = as_term(1)
    yield from (
        Line("room-four", 0 < 4 * (1 + a), proof(4, times(4, "room-a"))),
        Line("room-sum", 0 < 1 + rho, proof(1, "room-rho")),
        Defined(SMALL.name),
        Defined(U.name),
        Defined(W.name),
        Line("e-equation", equal(4 * SMALL * (1 + a), s * (a - s - s**2)),
             identity(using=SMALL.name)),
        Line("U-equation", equal(U * (1 + rho), SMALL), identity(using=U.name)),
        Line("W-equation", equal(rho * U, W), identity(using=f"{U.name} {W.name}")),
        Line("W-back", equal(sigma * W, U),
             identity(equations=(("W-equation", -sigma), ("room-inverse", U)))),
        Line("room-one", s < 1,
             scaled(times("goal", plus(times("room-s", "room-s"), "room-s", 1)), "room-r-one")
             ._replace(equations=(("room-cube", -one),))),
        Line("room-below", 0 < a - s**2, proof("room-excess", "room-s")),
        Line("e-positive", 0 < SMALL,
             scaled(times("goal", "room-four"), times("room-s", "room-excess"))
             ._replace(equations=(("e-equation", one),))),
        Line("e-one", SMALL < 1,
             scaled(times("goal", "room-four"), times("room-excess", "room-one"), 4,
                    times(3, "room-a"), "room-s", times("room-s", "room-s"))
             ._replace(equations=(("e-equation", -one),))),
        Line("U-positive", 0 < U,
             scaled(times("goal", "room-sum"), "e-positive")
             ._replace(equations=(("U-equation", one),))),
        Line("W-positive", 0 < W,
             proof(times("room-rho", "U-positive"), equations=(("W-equation", -one),))),
        Line("U-small", U <= SMALL,
             proof(times("room-rho", "U-positive"), equations=(("U-equation", -one),))),
        Line("W-small", W <= SMALL,
             proof("U-positive", equations=(("U-equation", -one), ("W-equation", one)))),
        Line("U-one", U < 1, proof("U-small", "e-one")),
        Line("W-one", W < 1, proof("W-small", "e-one")),
    )  # fmt: skip
    yield from _exchanged("", rho, (U, W), "W-equation")
    yield from _exchanged("back-", sigma, (W, U), "W-back")


def _exchanged(which: str, ratio: Term, boxes: tuple[Term, Term], equation: str) -> Iterator[Item]:
    """The map with this ratio takes the first box below the other one."""
    s, a = room.s, room.a
    excess, (u, v) = a - s - s**2, boxes
    first, other = (name.name.removeprefix("room.") for name in boxes)
    there = State(room.r, a, ratio, s**2, u, u, u)
    wide = Fraction(3, 4)
    part = times(wide, "room-excess")
    second = plus(times("room-excess", "room-one"), "room-s", times("room-s", "room-s"))
    claims = there.leads_to(s**2, v)
    yield from (
        Line(f"{which}wide", s + wide * excess <= there.p,
             proof(times("1/4", "room-excess", "room-one"), times("room-a", f"{first}-small"),
                   f"{other}-small",
                   equations=(("e-equation", as_term(Fraction(-1, 4))), (equation, as_term(-1))))),
        Line(f"{which}little", v * (1 + s**2 + Fraction(3, 2) * s * excess) <= 3 * s * excess,
             proof(times(12, f"{other}-small", plus(1, "room-a")),
                   times(f"{other}-positive", plus(11, times("19/2", "room-a"), "room-below",
                                                   times("3/2", second))),
                   equations=(("e-equation", as_term(-3)),))),
        Line(f"trap-fits-{which}p", claims["p"], proof(f"{which}wide", "room-s", part)),
        Line(f"trap-fits-{which}x", claims["x"],
             proof(times("room-s", "room-s", plus(f"{which}wide", part)),
                   times(power("room-s", 3), f"{first}-positive"),
                   equations=(("room-cube", 1 - u),))),
        Line(f"trap-fits-{which}top", claims["top"],
             proof(times(f"{other}-positive", plus(1, f"{other}-one"), f"{which}wide",
                         plus(f"trap-fits-{which}p", "room-s", part)),
                   times(f"{other}-positive", plus(1, f"{other}-one"), power(part, 2)),
                   times(f"{other}-positive", f"{which}little"),
                   equations=((equation, -(2 * s**2 + ratio * u + v)),))),
    )  # fmt: skip


def _why(role: str) -> BySum:
    """Why a given of the trap holds in the room, where it is no line of its own."""
    known = {"r": "room-r", "r-one": "room-r-one", "a": "room-a", "rho": "room-rho",
             "sigma": "room-sigma", "u": "U-positive", "U1": "U-one", "V": "W-positive",
             "V1": "W-one", "q": times("room-s", "room-s")}  # fmt: skip
    return proof(*([known[role]] if role in known else []))
