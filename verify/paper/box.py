"""A box of parameters: the hypotheses hold at all its points, or at none, and corners decide.

With alpha_0 = (1+r)c/2 the stability condition is (1+r) g(r, c) > 0, where

    g(r, c) = (1+r)^2 c^3/8 - 3rc/2 - r.

g falls in r, as 0 < c <= 1 and r < 1; and g(r, c)/c grows in c. So the worst point of a box has the
largest r and the smallest c, and the best one the other two ends.
"""

from __future__ import annotations

from collections.abc import Mapping
from fractions import Fraction

from verify.language.argument import (
    BySum,
    Line,
    ToBeFound,
    Value,
    plus,
    power,
    proof,
    scaled,
    times,
)
from verify.language.statement import (
    NEEDED,
    Applies,
    Cite,
    Context,
    Given,
    Obligation,
    Statement,
    Variable,
)
from verify.language.terms import Term, as_term, substitute, symbol
from verify.paper.parameters import ALL_PARAMETERS, HYPOTHESES, THEOREM, V_0, c, delta_theta, r
from verify.paper.theorem1 import theorem

CONTEXT = "box"
CITED = "all"
#: The context of all parameters in the page `all_parameters.toml`.
EVERYWHERE = "everywhere"
APPLIED = "theorem"
NAME = f"{THEOREM} on a box"
TITLES = {
    True: "the hypotheses hold, and so does the theorem",
    False: "the stability condition fails",
}

r_low, r_high, c_low, c_high = map(symbol, ("r_low", "r_high", "c_low", "c_high"))
PARAMETERS = ("r_low", "r_high", "c_low", "c_high", "V_0", "delta_theta")


def hypothesis(name: str) -> str:
    """The full name of a hypothesis."""
    return f"{HYPOTHESES}.{name}"


STABILITY = hypothesis("stability")
R, C, BELOW_ONE = map(hypothesis, ("r-positive", "angle-obtuse", "r-below-one"))

#: The number g(r, c), which is positive where the stability condition holds.
EXCESS = (1 + r) ** 2 * c**3 / 8 - 3 * r * c / 2 - r


def statement(values: Mapping[str, Term], everywhere: Cite, *, holds: bool) -> Statement:
    """That the theorem applies at each point of a box; or only the condition that fails there.

    ``everywhere`` is the theorem for all parameters.
    """
    context = Context(
        CONTEXT,
        (Variable("r", "r", "r"), Variable("c", "c", "c")),
        (
            Given("r-from", r_low <= r),
            Given("r-to", r <= r_high),
            Given("c-from", c_low <= c),
            Given("c-to", c <= c_high),
        ),
        {"r": r_low, "c": c_high},
        says="the parameters of the box",
    )
    rows, cites = ((_stability(), _applied()), (everywhere,)) if holds else ((_stability(),), ())
    title = f"At all points with {_words(values)}: {TITLES[holds]}"
    return Statement(NAME, title, values, (), (context,), rows, (), cites)


def _words(values: Mapping[str, Term]) -> str:
    value = {name: term.value for name, term in values.items()}
    return (
        f"{value['r_low']} <= r <= {value['r_high']}, "
        f"{value['c_low']} <= -cos theta_0 <= {value['c_high']}, "
        f"V_0 = {value['V_0']}, delta_theta = {value['delta_theta']}"
    )


def _stability() -> Obligation:
    rows = theorem().parts[HYPOTHESES].obligations
    row = next(row for row in rows if row.name == STABILITY)
    return row._replace(context=CONTEXT, says=f"{row.says}, at all points of the box")


def _applied() -> Obligation:
    at = {"r": r, "c": c, "V_0": V_0, "delta_theta": delta_theta}
    says = f"the hypotheses hold, and so does all of '{ALL_PARAMETERS}', at all points of the box"
    theorem_there = Applies(f"{CITED}:{EVERYWHERE}", at)
    return Obligation(APPLIED, HYPOTHESES, THEOREM, NEEDED, says, theorem_there, context=CONTEXT)


EIGHTH = Fraction(1, 8)
PLUS_R = plus(1, R)
#: For how the excess falls in r; at both ends, where it is as small as it can be.
FALL_HIGH = 1 + 3 * c_low / 2 - c_low**3 * (1 + r_high) / 4
FALL_LOW = 1 + 3 * c_high / 2 - c_high**3 * (3 + r_low) / 8


def numbers(*, holds: bool) -> tuple[Line, ...]:
    """What the ends of the box have to satisfy; the corner decides."""
    found = ToBeFound()
    ends = {"r": r_high, "c": c_low} if holds else {"r": r_low, "c": c_high}
    corner = substitute(EXCESS, ends)
    return (
        Line("r-ends", r_low <= r_high, found),
        Line("c-ends", c_low <= c_high, found),
        Line("r-there", r_low <= r_low, proof()),
        Line("c-there", c_high <= c_high, proof()),
        Line("r_low-positive", 0 < r_low, found),
        Line("r_high-below-one", r_high < 1, found),
        Line("c_low-positive", 0 < c_low, found),
        Line("c_high-at-most-one", c_high <= 1, found),
        Line("corner", 0 < corner if holds else 0 <= -corner, found),
        Line("fall", 0 < (FALL_HIGH if holds else FALL_LOW), found),
        Line(hypothesis("V_0-positive"), 0 < V_0, found),
        Line(hypothesis("delta-theta-positive"), 0 < delta_theta, found),
    )


def lines() -> tuple[Line, ...]:
    """The hypotheses that are about r or about c."""
    return (
        Line(R, 0 < r, proof("r-from", "r_low-positive")),
        Line(BELOW_ONE, r < 1, proof("r-to", "r_high-below-one")),
        Line(C, 0 < c, proof("c-from", "c_low-positive")),
        Line(hypothesis("angle-real"), c <= as_term(1), proof("c-to", "c_high-at-most-one")),
    )


def stable() -> BySum:
    """The stability condition follows from the corner with the largest r and the smallest c."""
    end = "c_low-positive"
    room = plus("fall", times(EIGHTH, power(end, 3), "r-to"))
    return _from_corner(end, times("r-to", room), "c-from")


def unstable() -> BySum:
    """It fails everywhere if it fails at the corner with the smallest r and the largest c."""
    end = plus("c_low-positive", "c-ends")
    room = plus("fall", times(EIGHTH, power(end, 3), BELOW_ONE))
    return _from_corner(end, times("r-from", room), "c-to")


def _from_corner(end: Value, fall: Value, side: Value) -> BySum:
    """The excess, times the end of c, is c times that at the end, and what it gains in between."""
    growth = times(EIGHTH, power(PLUS_R, 2), C, end, plus(C, end))
    value = plus(times(C, plus("corner", fall)), times(side, plus(growth, R)))
    return scaled(times(end, "goal"), times(PLUS_R, value))
