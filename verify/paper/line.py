"""Three balls of equal mass on a line, the ball 0 in the middle: when they collapse.

Just after a collision of 0 with s let s recede from 0 at the speed eta while c, apart from
0, approaches at the speed y. On a line the next collision is that of 0 with c, after
some time tau, and leaves (1+r)/2 y - eta and r y in the place of y and eta. So only the ratio q =
eta/y matters: it becomes r/((1+r)/2 - q), and below the larger fixed point it stays there.
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
    "Three balls of equal mass on a line collapse from every state just after a collision in which "
    "the ratio of the two relative speeds is at most Q, where r <= Q((1+r)/2 - Q) and 2Q < (1+r)/2"
)
LABEL = "SSSCT3.4.2LineaZhou-Kadan"
LAW = "EQUATSS2.1VitesPost-Colli"

ASSUMPTIONS = (
    Assumption("balls-on-a-line", LAW,
         "Three balls of equal mass and any radii move freely on a line until two of them touch "
         "and approach each other, at the speed u; then each gives the other (1+r)/2 u of its "
         "velocity, and they part at the speed r u. Ball 0 is between s and c.", "definition"),
    BOUNDED_MONOTONE,
    Assumption("glue-line", LABEL,
         "1. Ball 0 has just met s, and meets c after the time τ if it meets nothing before. As 0 "
         "is between them, s and c never touch; 0 and s part, by line-recedes. So the next "
         "collision is that of 0 with c, and by next-approaches, next-recedes and next-later the "
         "state after it is again such a state, with s and c exchanged. By induction there is an "
         "n-th collision for every n, by line-always. Their times increase, and are at most Eτ₀ "
         "after the start, by time-total: the balls collapse by then. As 0 is between the others, "
         "the angle is π.", "numbered glue"),
)  # fmt: skip

s = Letters("start", r="r", Q="Q", E="E", y="y₀", eta="η₀", T="τ₀")
n = Letters("line", y="y", eta="η", T="τ", t="t")
half = (1 + s.r) / 2


def conditions() -> dict[str, Claim]:
    """What is carried from collision to collision."""
    return {
        "approaches": 0 < n.y,
        "recedes": 0 < n.eta,
        "later": 0 < n.T,
        "ratio": n.eta <= s.Q * n.y,
        "clock": n.t + s.E * n.T <= s.E * s.T,
    }


approach = half * n.y - n.eta
following = n.at(y=approach, eta=s.r * n.y, T=n.eta * n.T / approach, t=n.t + n.T)
beginning = n.at(y=s.y, eta=s.eta, T=s.T, t=0)


@cache
def line() -> Argument:
    """The theorem, built once per process."""
    return argue(NAME, TITLE, _chapters(), ASSUMPTIONS)


def _chapters() -> Iterator[Chapter]:
    space = s.opened(
        "a state just after a collision; Q bounds the ratio of the speeds, and E the time that is "
        "left, in units of the time to the next collision",
        "3/50 1/5 3 1 1/20 1",
        {
            "r": 0 < s.r,
            "approaches": 0 < s.y,
            "recedes": 0 < s.eta,
            "later": 0 < s.T,
            "ratio": s.eta <= s.Q * s.y,
            "fixed": s.r <= s.Q * (half - s.Q),
            "fast": 2 * s.Q < half,
            "rest": half - s.Q <= s.E * (half - 2 * s.Q),
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
             scaled(times("start-approaches", "goal"), "start-ratio", "start-recedes")),
        Line("most-positive", 0 < half - s.Q, proof("start-fast", "Q-positive")),
        Line("rest-least",    1 < s.E,
             scaled(times("start-fast", "goal"), "start-rest", "Q-positive")),
    )  # fmt: skip


def _start() -> Iterator[Item]:
    given = {"ratio": "start-ratio", "clock": ""}
    for name, claim in conditions().items():
        known = given.get(name, f"start-{name}")
        yield Line(f"begin-{name}", substitute_claim(claim, beginning),
                   proof(*([known] if known else [])))  # fmt: skip


def _step() -> Iterator[Item]:
    following_claims = {
        name: substitute_claim(claim, following) for name, claim in conditions().items()
    }
    slower = times("line-ratio")
    yield from (
        Line("next-approaches", following_claims["approaches"],
             proof(slower, times("most-positive", "line-approaches")),
             LAW, "then s approaches 0 at the speed (1+r)/2 y - η, which is positive"),
        Line("next-recedes",  following_claims["recedes"],
             proof(times("start-r", "line-approaches")),
             LAW, "c recedes at the speed r y"),
        Line("next-later",    following_claims["later"],
             proof(times("line-recedes", "line-later")),
             LAW, "and s meets 0 after η/((1+r)/2 y - η) times the time before"),
        Line("next-ratio",    following_claims["ratio"],
             proof(times("start-fixed", "line-approaches"), times("Q-positive", "line-ratio")),
             LABEL, "the ratio stays at most Q: r/((1+r)/2 - q) ≤ Q"),
        Line("next-clock",    following_claims["clock"],
             proof(times("next-approaches", "line-clock"),
                   times("line-later", "line-approaches", "start-rest"),
                   times("line-later", "line-ratio", plus(1, times(2, "rest-least")))), LABEL,
             "each flight is shorter than the one before by the factor Q/((1+r)/2 - Q) at least"),
        Line("time-total",    n.t <= s.E * s.T,
             proof("line-clock", times("line-later", plus(1, "rest-least"))),
             LABEL, "so all collisions take place within E times the time to the first"),
    )  # fmt: skip
