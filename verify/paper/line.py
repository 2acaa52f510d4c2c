"""Three balls of any masses on a line, the ball 0 in the middle: when they collapse.

Just after a collision of 0 with s let s recede from 0 at the speed eta while c, apart from
0, approaches at the speed y. On a line the next collision is that of 0 with c, after
some time tau, and leaves b y - eta and r y in the place of y and eta; here b is the share of its
speed that c gives to 0, and b' that of s. So only the ratio q = eta/(b y) matters: it becomes
r/(b b'(1 - q)), and below the larger fixed point of this it stays there. For equal masses b = b' =
(1+r)/2.
"""

from __future__ import annotations

from collections.abc import Iterator
from functools import cache

from verify.language.argument import (
    Argument,
    ByInduction,
    Chapter,
    Item,
    Line,
    Opened,
    argue,
    plus,
    proof,
    scaled,
    times,
)
from verify.language.statement import Always, Assumption, Context, Given
from verify.language.terms import Claim, substitute_claim
from verify.paper.assumptions import BOUNDED_MONOTONE
from verify.paper.letters import Letters

NAME = "line"
TITLE = (
    "Three balls on a line collapse from every state just after a collision in which the ratio of "
    "the two relative speeds is at most Qb, where r <= bb'Q(1 - Q) and 2Q < 1; the ball in the "
    "middle gets b and b' of the speeds at which the others meet it, (1+r)/2 if masses are equal"
)
LABEL = "SSSCT3.4.2LineaZhou-Kadan"
LAW = "EQUATSS2.1VitesPost-Colli"

ASSUMPTIONS = (
    Assumption("balls-on-a-line", LAW,
         "Three balls of any masses and radii move freely on a line until two of them touch and "
         "approach each other, at the speed u; then the velocity of each changes by (1+r) u times "
         "the mass of the other over both masses, and they part at the speed r u. Ball 0 is "
         "between s and c; b is (1+r) m_c/(m_0 + m_c), and b' is (1+r) m_s/(m_0 + m_s).",
         "definition"),
    BOUNDED_MONOTONE,
    Assumption("glue-line", LABEL,
         "1. Ball 0 has just met s, and meets c after the time τ if it meets nothing before. As 0 "
         "is between them, s and c never touch; 0 and s part, by line-recedes. So the next "
         "collision is that of 0 with c, and by next-approaches, next-recedes and next-later the "
         "state after it is again such a state, with s and c, b and b' exchanged. By induction "
         "there is an n-th collision for every n, by line-always. Their times increase, and are at "
         "most Eτ₀ after the start, by time-total: the balls collapse by then. As 0 is between the "
         "others, the angle is π.", "numbered glue"),
)  # fmt: skip

s = Letters("start", r="r", b="b₀", b_s="b₀′", Q="Q", E="E", y="y₀", eta="η₀", T="τ₀")
n = Letters("line", b="b", b_s="b′", y="y", eta="η", T="τ", t="t")


def conditions() -> dict[str, Claim]:
    """What is carried from collision to collision."""
    return {
        "share": 0 < n.b,
        "share_s": 0 < n.b_s,
        "fixed": s.r <= n.b * n.b_s * s.Q * (1 - s.Q),
        "approaches": 0 < n.y,
        "recedes": 0 < n.eta,
        "later": 0 < n.T,
        "ratio": n.eta <= s.Q * n.b * n.y,
        "clock": n.t + s.E * n.T <= s.E * s.T,
    }


approach = n.b * n.y - n.eta
following = n.at(b=n.b_s, b_s=n.b, y=approach, eta=s.r * n.y, T=n.eta * n.T / approach, t=n.t + n.T)
beginning = n.at(b=s.b, b_s=s.b_s, y=s.y, eta=s.eta, T=s.T, t=0)


@cache
def line() -> Argument:
    """The theorem, built once per process."""
    return argue(NAME, TITLE, _chapters(), ASSUMPTIONS)


def _chapters() -> Iterator[Chapter]:
    space = s.opened(
        "a state just after a collision; Q bounds the ratio of the speeds, and E the time that is "
        "left, in units of the time to the next collision",
        "3/50 53/100 53/100 2/5 3 1 1/20 1",
        {
            "r": 0 < s.r,
            "share": 0 < s.b,
            "share_s": 0 < s.b_s,
            "approaches": 0 < s.y,
            "recedes": 0 < s.eta,
            "later": 0 < s.T,
            "ratio": s.eta <= s.Q * s.b * s.y,
            "fixed": s.r <= s.b * s.b_s * s.Q * (1 - s.Q),
            "fast": 2 * s.Q < 1,
            "rest": 1 - s.Q <= s.E * (1 - 2 * s.Q),
        },
    )
    yield Chapter(None, (Opened(space),))
    carried = tuple(Given(f"line-{name}", claim, "carried") for name, claim in conditions().items())
    at_start = tuple(f"begin-{name}" for name in conditions())
    here = Context(n.context, n.variables(), carried, beginning, s.context,
                   "a state just after a collision")  # fmt: skip
    yield Chapter(s.context, (*_bounds(), *_start(), Opened(here, at_start)))
    yield Chapter(n.context, tuple(_step()))
    always = Line("line-always", Always(n.context, beginning, following),
                  ByInduction(at_start, tuple(f"next-{name}" for name in conditions())), LABEL,
                  "by induction the conditions hold after every collision: it goes on for ever",
                  tuple(assumption.name for assumption in ASSUMPTIONS))  # fmt: skip
    yield Chapter(s.context, (always,))


def _bounds() -> Iterator[Item]:
    yield from (
        Line("Q-positive",    0 < s.Q,
             scaled(times("start-share", "start-approaches", "goal"), "start-ratio",
                    "start-recedes")),
        Line("most-positive", 0 < 1 - s.Q, proof("start-fast", "Q-positive")),
        Line("rest-least",    1 < s.E,
             scaled(times("start-fast", "goal"), "start-rest", "Q-positive")),
    )  # fmt: skip


def _start() -> Iterator[Item]:
    given = {"clock": ""}
    for name, claim in conditions().items():
        known = given.get(name, f"start-{name}")
        yield Line(f"begin-{name}", substitute_claim(claim, beginning),
                   proof(*([known] if known else [])))  # fmt: skip


def _step() -> Iterator[Item]:
    following_claims = {
        name: substitute_claim(claim, following) for name, claim in conditions().items()
    }
    yield from (
        Line("next-share",    following_claims["share"], proof("line-share_s")),
        Line("next-share_s",  following_claims["share_s"], proof("line-share")),
        Line("next-fixed",    following_claims["fixed"], proof("line-fixed")),
        Line("next-approaches", following_claims["approaches"],
             proof("line-ratio", times("most-positive", "line-share", "line-approaches")),
             LAW, "then s approaches 0 at the speed by - η, which is positive"),
        Line("next-recedes",  following_claims["recedes"],
             proof(times("start-r", "line-approaches")),
             LAW, "c recedes at the speed r y"),
        Line("next-later",    following_claims["later"],
             proof(times("line-recedes", "line-later")),
             LAW, "and s meets 0 after η/(by - η) times the time before"),
        Line("next-ratio",    following_claims["ratio"],
             proof(times("line-fixed", "line-approaches"),
                   times("Q-positive", "line-share_s", "line-ratio")),
             LABEL, "the ratio stays at most Q: r/(bb′(1 - q)) ≤ Q"),
        Line("next-clock",    following_claims["clock"],
             proof(times("next-approaches", "line-clock"),
                   times("line-later", "line-share", "line-approaches", "start-rest"),
                   times("line-later", "line-ratio", plus(1, times(2, "rest-least")))), LABEL,
             "each flight is shorter than the one before by the factor Q/(1 - Q) at least"),
        Line("time-total",    n.t <= s.E * s.T,
             proof("line-clock", times("line-later", plus(1, "rest-least"))),
             LABEL, "so all collisions take place within E times the time to the first"),
    )  # fmt: skip
