"""The display with the wrong sign fails for all parameters.

At the state of `angle_state` the two directions W_s and W_c, seen from the contact, are opposite,
so that the last term is positive; and the pair that is apart comes closer until the next contact:
(1 + d)/(1 + d') is at least 1. So the change of -cos theta exceeds what the display allows by twice
the last term.
"""

from __future__ import annotations

from collections.abc import Iterator
from fractions import Fraction

from verify.language.argument import (
    ByEntry,
    ByLeast,
    ByRoot,
    BySum,
    Defined,
    Item,
    Line,
    ToBeFound,
    plus,
    power,
    proof,
    scaled,
    times,
)
from verify.language.statement import Constant, Context, Given, Variable
from verify.language.terms import Claim, as_term, equal, maximum, sqrt, symbol
from verify.paper.everywhere.chart import HALF, hypothesis
from verify.paper.initial_data import ConstantSet, phi_minus
from verify.paper.parameters import PRINTED, V_0
from verify.paper.recursion import (
    COSINE,
    angle_claim,
    angle_state,
    contact_time,
    contact_zeta,
    next_distance,
)

CONTEXT = "display"
ROW = f"{PRINTED}.angle-sign"
FAILS = "display-fails"
NAMES = ("eta", "spectator", "distance", "norm_c", "norm_s", "product", "cosine")
LETTERS = ("η", "η_s", "d", "A", "B", "P", "C")
e, s, d, a, b, w, cosine = map(symbol, NAMES)
zeta, time, following = map(symbol, ("display.zeta", "display.time", "display.following"))


def given(name: str) -> str:
    """The name of a given of the context."""
    return f"{CONTEXT}.{name}"


def givens() -> dict[str, Claim]:
    """What the context assumes of a state."""
    return {
        **{f"{name}-positive": 0 < symbol(name) for name in NAMES},
        "spectator-slower": s <= e,
        "contact": d * (2 + d) * a < (1 + d) ** 2 * e**2,
        "slow": (a + b) * d <= e * (e - s),
    }


def context() -> Context:
    """States with which the display is judged."""
    values = {"eta": "1", "spectator": "1/10", "distance": "1/100", "cosine": "1/2"}
    return Context(
        CONTEXT,
        tuple(
            Variable(name, letter, letter.replace("η", r"\eta"))
            for name, letter in zip(NAMES, LETTERS, strict=True)
        ),
        tuple(Given(given(name), claim) for name, claim in givens().items()),
        {name: as_term(Fraction(values.get(name, "1"))) for name in NAMES},
        says="a state before a contact, as the display after EQUATSS4.1EvoluCosinAngle needs it",
        constants=(
            Constant(zeta.name, "ζ", r"\zeta", COSINE, contact_zeta(e, d, a)),
            Constant(time.name, "τ", r"\tau", COSINE, contact_time(e, d, a, zeta)),
            Constant(following.name, "D", "D", COSINE, next_distance(s, b, time)),
        ),
    )


E, S, D, A, B, W, C = (given(f"{name}-positive") for name in NAMES)
ONE_D, TWO_D = plus(1, D), plus(2, D)


def lines() -> Iterator[Item]:
    """In the context: from the next contact to the negation of the display."""
    root = sqrt(1 - zeta)
    whole = times("one-plus-square", "eta-square")
    radicand = 1 + 2 * s * time + b * time**2
    yield from (
        Line("one-plus-square", 0 < (1 + d) ** 2, proof(power(ONE_D, 2))),
        Line("eta-square",      0 < e**2, proof(power(E, 2))),
        Defined(zeta.name),
        Line("zeta-below-one",  0 < 1 - zeta, proof(given("contact"), using=zeta.name)),
        Line("zeta-root",       0 < root, ByRoot()),
        Line("root-lost",       0 < 1 - root, scaled(times(whole, plus(1, "zeta-root"), "goal"),
            times(D, TWO_D, A), using=zeta.name)),
        Defined(time.name),
        Line("time-positive",   0 < time, proof(times(ONE_D, E, "root-lost"), using=time.name)),
        Line("next-square",     0 < radicand,
            proof(1, times(2, S, "time-positive"), times(B, power("time-positive", 2)))),
        Line("next-root",       0 < sqrt(radicand), ByRoot()),
        Defined(following.name),
        Line("next-positive",   0 < following, proof("next-root", using=following.name)),
        Line("next-law",        equal(following**2, radicand), BySum(using=(following.name,))),
        Line("contact-law",     equal(d * (2 + d), 2 * (1 + d) * e * time - a * time**2),
            BySum(using=(time.name, zeta.name))),
    )  # fmt: skip
    yield from _closer()
    yield from _display()


def _closer() -> Iterator[Line]:
    """The pair that is apart is not farther apart at the next contact."""
    more = plus(given("spectator-slower"), times(2, E), times(2, D, E))
    yield from (
        Line("time-most",  a * time <= (1 + d) * e,
            proof(times(A, ONE_D, E, "zeta-root"), using=time.name)),
        Line("time-small", (1 + d) * e * time <= d * (2 + d),
            proof(times("time-positive", "time-most"), equations=(("contact-law", as_term(1)),))),
        Line("room",       0 <= 2 * ((1 + d) * e - s) - (a + b) * time,
            scaled(times(ONE_D, E, "goal"), times(plus(A, B), "time-small"),
            times(TWO_D, given("slow")), times(E, D, more))),
        Line("closer",     following <= 1 + d,
            BySum((times(plus("next-positive", ONE_D), "goal"), times("time-positive", "room")),
            (), (("next-law", as_term(-1)), ("contact-law", as_term(1))))),
    )  # fmt: skip


def _display() -> Iterator[Line]:
    """The display has the difference to 1 on the right, and that plus the last term on the left."""
    display = angle_claim(d, time, following, w, cosine)
    excess = (1 + d) / following - 1
    most = maximum(excess, -excess)
    change = display.lhs.children[0]
    last = w * time**2 / following
    yield from (
        Line("excess-positive", 0 <= excess, proof("closer")),
        Line("excess-most",     most <= excess,
            ByLeast((proof(), proof(times(2, "excess-positive", "next-positive"))), side="lhs")),
        Line("change-least",    change <= display.lhs, ByEntry(side="rhs")),
        Line("last-positive",   0 < last, proof(times(W, power("time-positive", 2)))),
        Line(FAILS, display.rhs < display.lhs,
            proof(times(C, "excess-most"), "change-least", times(2, "last-positive"))),
    )  # fmt: skip


# --- the state, for all parameters ---------------------------------------------------------------


def premises() -> tuple[str, ...]:
    """The facts which say that the state satisfies the givens."""
    return tuple(f"state-{name}" for name in givens())


def state_lines(k: ConstantSet) -> Iterator[Line]:
    """In the context of all parameters: the state satisfies the givens."""
    at = angle_state(k)
    x, y, z, n_c, n_s, product, cos = (at[name] for name in NAMES)
    eta, V_0s, V_1s = f"{PRINTED}.eta_bar-positive", hypothesis("V_0-positive"), "V_1-sign"
    above, angle = f"{PRINTED}.V_1-above-V_0", hypothesis("angle-real")
    ex, sp, di, co = (f"state-{n}-positive" for n in ("eta", "spectator", "distance", "cosine"))
    e2, half = times(ex, ex, V_0s, V_0s), times(HALF, plus(V_0s, V_1s), "sine")
    mixed = times(sp, ex, co, V_0s, V_0s)
    hundredth, decay = Fraction(1, 100), f"{PRINTED}.C_eta-positive"
    lost = times(f"{PRINTED}.C_eta-below-one", plus(1, decay))
    rest = plus(times(Fraction(51, 100), above), times(Fraction(99, 100), V_1s))
    slower = times(V_0s, V_0s, "state-spectator-slower", plus(ex, sp))
    two = plus(2, di)
    yield from (
        Line(ex, 0 < x, ToBeFound()),
        Line(sp, 0 < y, ToBeFound()),
        Line(di, 0 < z, ToBeFound()),
        Line(co, 0 < cos, ToBeFound()),
        Line("cos-below", 0 < 1 - cos, proof(times(V_0s, angle), times(11, "V_1-root", eta))),
        Line("sine",                   0 < 1 - cos**2, proof(times("cos-below", plus(V_0s, co)))),
        Line("state-norm_c-positive",  0 < n_c, proof(half, e2)),
        Line("state-norm_s-positive",  0 < n_s, proof(half, times(sp, sp, V_0s, V_0s))),
        Line("state-product-positive", 0 < product, proof(times(half, V_0s), mixed)),
        Line("state-spectator-slower", y <= x, proof(times(ex, "m-below-one"))),
        Line("eta-speed",              k.eta_bar <= Fraction(11, 100) * k.speed, ToBeFound()),
        Line("sine-share",             x**2 / (1 - cos**2) <= V_0 / 100,
            proof(times(hundredth, V_0s, "cos-below", co),
            times(hundredth, V_0s, V_0s, V_0s, angle), times(V_0s, V_0s, eta, "eta-speed"),
            times(V_0s, V_0s, eta, eta, lost))),
        Line("norm_c-most",            n_c <= 2 * k.V_1, proof("sine-share", times("sine", rest))),
        Line("norm_s-most", n_s <= 2 * k.V_1, proof("sine-share", slower, times("sine", rest))),
        Line("slope-small",            4 * k.V_1 * k.d_slope <= 1 - phi_minus, ToBeFound()),
        Line("state-contact",          z * (2 + z) * n_c < (1 + z) ** 2 * x**2,
            proof(times(di, two, "norm_c-most"), times("sine", ex, ex, HALF, two, "slope-small"),
            times("sine", ex, ex,
            plus(times(HALF, "m-positive", two), times(Fraction(3, 2), di), times(di, di))))),
        Line("state-slow",             (n_c + n_s) * z <= x * (x - y),
            proof(times(di, plus("norm_c-most", "norm_s-most")),
            times("sine", ex, ex, "slope-small"))),
    )  # fmt: skip
