"""The map keeps the order: what lies below a state has an image below that state's image."""

from __future__ import annotations

from collections.abc import Iterable, Iterator, Mapping

from verify.language.argument import (
    Chapter,
    Item,
    Line,
    Opened,
    Value,
    plus,
    power,
    proof,
    scaled,
    times,
)
from verify.language.statement import Constant, Context, Given
from verify.language.terms import Claim, Term, as_term, substitute_claim
from verify.paper.letters import Letters
from verify.paper.separatrix.model import LABEL, LIMIT_MAP, Names, State, constants_of, image, state

up = Letters("up", r="r", a="a", rho="ρ", Q="Q", U="U", X="X", V="V")
below = Letters("below", q="q", u="u")
down = Letters("down", r="r", a="a", rho="ρ", Q="Q", U="U", X="X", V="V")
above = Letters("above", q="q", u="u")
parted = Letters("parted", r="r", a="a", rho="ρ", Q="Q", U="U")
after_parted = Letters("after-parted", q="q", u="u")
missed = Letters("missed", r="r", a="a", rho="ρ", Q="Q", U="U")
after_missed = Letters("after-missed", q="q", u="u")
apart = Letters("apart", r="r", a="a", rho="ρ", q="q", u="u", Q="Q", U="U")


def chapters() -> Iterator[Chapter]:
    """Boxes around orbits from above, then from below, then the strict order."""
    yield from _up()
    yield from _down()
    yield from _parted()
    yield from _missed()
    yield from _strictly()


def outermost(
    letters: Letters, says: str, point: str, givens: Mapping[str, Claim], *states: State
) -> Context:
    """A context at r = 3/100 and a = 103/200, with the images of states as constants."""
    given = constants_of(letters) | dict(givens)
    found = letters.opened(says, f"3/100 103/200 {point}", given)
    return found._replace(constants=_constants(states))


def inside(
    letters: Letters, says: str, outer: Letters, givens: Mapping[str, Claim], *states: State
) -> Chapter:
    """A context of the states (q, u) on one side of (Q, U), open at (Q, U) itself.

    Each given holds there because it is one of the outer context, or an equality.
    """
    point = letters.at(q=outer.Q, u=outer.U)
    named = tuple(Given(f"{letters.context}-{name}", claim) for name, claim in givens.items())
    lines = tuple(
        Line(f"{given.name}-first", substitute_claim(given.claim, point), proof(*known))
        for given in named
        for known in [[f"{outer.context}-{AT_FIRST[name]}"] if name in AT_FIRST else []
                      for name in [given.name.removeprefix(f"{letters.context}-")]]
    )  # fmt: skip
    place = Context(letters.context, letters.variables(), named, point, outer.context, says,
                    _constants(states))  # fmt: skip
    return Chapter(outer.context, (*lines, Opened(place, tuple(line.name for line in lines))))


#: Why a given about (q, u) holds for (Q, U): the given of the outer context that says so.
AT_FIRST = {"q": "Q", "u": "U", "one": "U1", "p": "p", "meets": "meets"}


def _constants(states: Iterable[State]) -> tuple[Constant, ...]:
    return tuple(constant for found in states for constant in found.constants())


# --- lines for any two states, the first below the second -----------------------------------------


def shrink(k: Names, small: State, large: State) -> Iterator[Item]:
    """The smaller state has the larger p and the smaller top."""
    yield from (
        Line(k.above_zero, 0 < large.u, proof(k.u, k.uU)),
        Line(k.one, small.u < 1, proof(k.uU, k.U1)),
        Line(k.p_larger, large.p <= small.p, proof(times(plus(k.a, k.rho), k.uU), k.qQ)),
        Line(k.smaller_p, 0 < small.p, proof(k.p, k.p_larger), LABEL,
             "if (q, u) ≤ (Q, U) and the pair after (Q, U) approaches, so does that after (q, u): "
             "0 < P ≤ p", (LIMIT_MAP,)),
        Line(k.smaller_top, small.top <= large.top,
             proof(times(2, k.rho, k.above_zero, k.qQ), times(2, k.rho, k.q, k.uU),
                   times(k.rho, k.rho, k.uU, plus(k.above_zero, k.u)))),
    )  # fmt: skip


def squares(k: Names) -> Value:
    """p² - P² ≥ 0."""
    return times(k.p_larger, plus(k.p, k.smaller_p))


def corner(letters: Letters, x: Term, v: Term) -> State:
    """The state (Q, U) of a context, and its image, or what stands for that."""
    return State(letters.r, letters.a, letters.rho, letters.Q, letters.U, x, v)


def under(k: Names, small: State, large: State, X: Term, V: Term) -> Iterator[Item]:
    """The smaller state has an image, which is at most (X, V) if that of the larger one is."""
    x, v = small.x.name, small.v.name
    yield from shrink(k, small, large)
    yield Line(k.smaller_meets, small.top < small.p**2,
               proof(k.smaller_top, k.top, times(power(k.V1, 2), power(k.p, 2)), squares(k)),
               LABEL, "and the next pair of (q, u) meets: ρu(2q+ρu) < p²", (LIMIT_MAP,),
    )  # fmt: skip
    yield from image(small, k.smaller_p, k.smaller_meets)
    yield from (
        Line(k.x_positive, 0 < small.x,
             scaled(times(k.smaller_p, "goal"), times(k.r, k.one))
             ._replace(equations=((f"{x}-equation", as_term(1)),)),
             LABEL, "the image has x > 0", (LIMIT_MAP,)),
        Line(k.v_positive, 0 < small.v,
             scaled(times("goal", plus(1, f"{v}-one"), power(k.smaller_p, 2)),
                    times(k.rho, k.u, plus(times(2, k.q), times(k.rho, k.u))))
             ._replace(equations=((f"{v}-equation", as_term(-1)),)),
             LABEL, "and v > 0", (LIMIT_MAP,)),
        Line(k.x_below, small.x <= X,
             scaled(times("goal", k.p, k.smaller_p), times(k.x, k.smaller_p),
                    times(k.r, k.one, k.qQ), times(k.r, k.q, k.uU),
                    times(k.r, k.rho, k.uU))
             ._replace(equations=((f"{x}-equation", -large.p),)),
             LABEL, "x ≤ X: the order is kept, since (1-U)p ≥ (1-u)P", (LIMIT_MAP,)),
        Line(k.v_below, small.v <= V,
             scaled(times("goal", plus(f"{v}-one", k.V1), power(k.smaller_p, 2)), k.smaller_top,
                    k.top, times(k.V, plus(1, k.V1), squares(k)))
             ._replace(equations=((f"{v}-equation", as_term(1)),)),
             LABEL, "v ≤ V, since v(2-v)p² = ρu(2q+ρu)", (LIMIT_MAP,)),
    )  # fmt: skip


# --- from above -----------------------------------------------------------------------------------


def _up() -> Iterator[Chapter]:
    large, small = corner(up, up.X, up.V), state(below, up)
    given = {"rho": 0 < up.rho, "Q": 0 <= up.Q, "U": 0 < up.U, "U1": up.U < 1, "V": 0 <= up.V,
             "V1": up.V < 1, **large.leads_to(up.X, up.V)}  # fmt: skip
    outer = outermost(up, "(X, V) lies above the image of (Q, U)", "1 1/10 1/100 1/10 1/100", given)
    lies = {"q": 0 <= below.q, "qQ": below.q <= up.Q, "u": 0 < below.u, "uU": below.u <= up.U}
    k = Names("below", **{n: f"up-{n}" for n in ("r", "a", *given)})
    yield Chapter(None, (Opened(outer),))
    yield inside(below, "(q, u) lies below (Q, U)", up, lies, small)
    yield Chapter(below.context, tuple(under(k, small, large, up.X, up.V)))


# --- from below -----------------------------------------------------------------------------------


def _down() -> Iterator[Chapter]:
    small, large = corner(down, down.X, down.V), state(above, down)
    P, V = small.p, down.V
    given = {"rho": 0 < down.rho, "Q": 0 <= down.Q, "U": 0 < down.U, "U1": down.U < 1,
             **small.goes_on(), "x": down.X * P <= down.r * (1 - down.U), "V": 0 <= V, "V1": V <= 1,
             "top": V * (2 - V) * P**2 <= small.top}  # fmt: skip
    outer = outermost(down, "(X, V) lies below the image of (Q, U)",
                      "1 1/10 1/20 3/50 1/100", given)  # fmt: skip
    lies = {"qQ": down.Q <= above.q, "uU": down.U <= above.u, "one": above.u < 1, **large.goes_on()}
    k = Names("above", **{n: f"down-{n}" for n in ("r", "a", "rho", "Q", "U", "U1", "V", "V1")})
    x, v = large.x.name, large.v.name
    squares = times("above-p-smaller", plus("down-p", "above-p"))
    lines = (
        Line("above-p-smaller", large.p <= P, proof(times(plus(k.a, k.rho), k.uU), k.qQ)),
        Line("above-top", small.top <= large.top, proof(*_more(k))),
        *image(large, "above-p", "above-meets"),
        Line("above-x-above", down.X <= large.x,
             scaled(times("goal", "down-p", "above-p"), times("down-x", "above-p"),
                    times(k.r, k.U1, k.qQ), times(k.r, k.Q, k.uU), times(k.r, k.rho, k.uU))
             ._replace(equations=((f"{x}-equation", P),)),
             LABEL, "if (q, u) ≥ (Q, U) has an image, x ≥ X", (LIMIT_MAP,)),
        Line("above-v-above", V <= large.v,
             scaled(times("goal", plus(f"{v}-one", "down-V1"), power("above-p", 2)), "above-top",
                    "down-top", times("down-V", plus(1, "down-V1"), squares))
             ._replace(equations=((f"{v}-equation", as_term(-1)),)),
             LABEL, "and v ≥ V", (LIMIT_MAP,)),
    )  # fmt: skip
    yield Chapter(None, (Opened(outer),))
    yield inside(above, "(q, u) lies above (Q, U) and has an image", down, lies, large)
    yield Chapter(above.context, lines)


def _more(k: Names) -> tuple[Value, ...]:
    """The larger state has the larger top: these add up to the difference."""
    return (
        times(2, k.rho, plus(k.U, k.uU), k.qQ),
        times(2, k.rho, k.Q, k.uU),
        times(k.rho, k.rho, k.uU, plus(times(2, k.U), k.uU)),
    )


def _parted() -> Iterator[Chapter]:
    here, over = corner(parted, parted.Q, parted.U), state(after_parted, parted)
    given = {"rho": 0 < parted.rho, "Q": 0 <= parted.Q, "U": 0 < parted.U, "ends": here.p <= 0}
    lies = {"qQ": parted.Q <= after_parted.q, "uU": parted.U <= after_parted.u}
    k = Names(after_parted.context, a="parted-a", rho="parted-rho")
    line = Line("after-parted-ends", over.p <= 0,
                proof("parted-ends", times(plus(k.a, k.rho), k.uU), k.qQ),
                LABEL, "if the pair after (Q, U) does not approach, nor does that after "
                "(q, u) ≥ (Q, U)", (LIMIT_MAP,))  # fmt: skip
    says = "the pair after (Q, U) does not approach"
    yield Chapter(None, (Opened(outermost(parted, says, "1 1/2 1/2", given)),))
    yield inside(after_parted, "(q, u) lies above (Q, U)", parted, lies)
    yield Chapter(after_parted.context, (line,))


def _missed() -> Iterator[Chapter]:
    here, over = corner(missed, missed.Q, missed.U), state(after_missed, missed)
    given = {"rho": 0 < missed.rho, "Q": 0 <= missed.Q, "U": 0 < missed.U, "p": 0 < here.p,
             "ends": here.p**2 <= here.top}  # fmt: skip
    lies = {"qQ": missed.Q <= after_missed.q, "uU": missed.U <= after_missed.u, "p": 0 < over.p}
    k = Names(after_missed.context, **{n: f"missed-{n}" for n in ("a", "rho", "Q", "U")})
    squares = times("after-p-smaller", plus("missed-p", "after-missed-p"))
    lines = (
        Line("after-p-smaller", over.p <= here.p, proof(times(plus(k.a, k.rho), k.uU), k.qQ)),
        Line("after-missed-ends", over.p**2 <= over.top,
             proof("missed-ends", squares, *_more(k)), LABEL,
             "if the pair after (Q, U) misses, so does that after (q, u) ≥ (Q, U), if it "
             "approaches", (LIMIT_MAP,)),
    )  # fmt: skip
    says = "the pair after (Q, U) misses"
    yield Chapter(None, (Opened(outermost(missed, says, "1 1/10 1/5", given)),))
    says = "(q, u) lies above (Q, U), and the next pair approaches"
    yield inside(after_missed, says, missed, lies)
    yield Chapter(after_missed.context, lines)


# --- strictly -------------------------------------------------------------------------------------


def _strictly() -> Iterator[Chapter]:
    small, large = state(apart, apart), state(apart, apart, "Q U X V")
    given = {"rho": 0 < apart.rho, "q": 0 <= apart.q, "qQ": apart.q < apart.Q, "u": 0 < apart.u,
             "uU": apart.u <= apart.U, "U1": apart.U < 1, **large.goes_on()}  # fmt: skip
    says = "two states with q < Q and u ≤ U; the second one has an image"
    place = outermost(apart, says, "1 1/20 1/100 1/10 1/100", given, small, large)
    k = Names("apart")
    v, V = small.v.name, large.v.name
    one = as_term(1)
    lines = (
        *shrink(k, small, large),
        Line(k.smaller_meets, small.top < small.p**2, proof(k.smaller_top, k.meets, squares(k))),
        *image(large, k.p, k.meets),
        *image(small, k.smaller_p, k.smaller_meets),
        *largest(k, large),
        Line("apart-strictly", small.v < large.v,
             scaled(times("goal", plus(f"{v}-one", f"{V}-one"), power(k.smaller_p, 2)),
                    times(2, k.rho, k.above_zero, k.qQ), times(2, k.rho, k.q, k.uU),
                    times(k.rho, k.rho, k.uU, plus(k.above_zero, k.u)),
                    times(k.V, plus(1, f"{V}-one"), squares(k)))
             ._replace(equations=((f"{v}-equation", one), (f"{V}-equation", -one))),
             LABEL, "if q < Q and u ≤ U, then v < V: after one step the order is strict in u",
             (LIMIT_MAP,)),
    )  # fmt: skip
    yield Chapter(None, (Opened(place),))
    yield Chapter(apart.context, lines)


def largest(k: Names, large: State) -> Iterator[Item]:
    """The image of the larger state has V > 0."""
    V = large.v.name
    yield Line(k.V, 0 < large.v,
               scaled(times("goal", plus(1, f"{V}-one"), power(k.p, 2)),
                      times(k.rho, k.above_zero, plus(times(2, k.q), times(2, k.qQ),
                                                      times(k.rho, k.above_zero))))
               ._replace(equations=((f"{V}-equation", as_term(-1)),)))  # fmt: skip
