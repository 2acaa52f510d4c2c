r"""The collision map in inner products, for numbers of any kind: terms, balls, or rationals.

The paper's map `EQUATSS2.2IterationSystm1` closes on inner products: nothing else of the scene is
needed, in any dimension. Speeds are measured in units of the last closing speed, so that the ratio
of the two normal components comes out of numbers of order 1 only: where collisions go on for ever,
an error in it shrinks from one to the next.
"""

from __future__ import annotations

from collections.abc import Callable
from typing import Any

from verify.language.record import Record

#: A term, a ball or an exact rational; all know + - * / and ** with one another and integers.
Number = Any
#: Gives a name to a number on its way: nothing for values, a new constant for terms.
Keep = Callable[[str, Number], Number]


class Sizes(Record):
    """What the law needs besides r: the squares of the contact distances, and 1 + m_o/m_c.

    ``c``, ``s`` and ``outer`` are the pairs o and c, o and s, s and c. Without other numbers the
    spheres are equal, with diameter 1.
    """

    c: Number = 1
    s: Number = 1
    outer: Number = 1
    ratio: Number = 2


EQUAL = Sizes()


class State(Record):
    """A central sphere o and two others, s (the spectator) and c, at some moment.

    x_s and x_c are their centres seen from that of o, W_s and W_c their velocities. With v > 0, a
    unit of speed: x_c·W_c = -lam v, |x_c|² = 1 + eps v², x_s·W_s = rho v, |x_s|² = 1 + sig v²;
    A = |W_c|², B = |W_s|², C = -x_s·x_c, a = x_s·W_c, b = x_c·W_s, w = W_s·W_c. Where spheres are
    not equal, the squares of their contact distances take the place of 1.
    """

    v: Number
    lam: Number
    rho: Number
    eps: Number
    sig: Number
    A: Number
    B: Number
    C: Number
    a: Number
    b: Number
    w: Number


class Flight(Record):
    """How o and c meet: the speed is y = -x_c·W_c now and y s at impact, after the time y T.

    q = x_s·W_s/y and kap = (|x_c|² - 1)/y².
    """

    y: Number
    q: Number
    kap: Number
    s: Number
    T: Number


class Pair(Record):
    """Two spheres: g = |x|² - 1, p = x·w and m = |w|², so that |x + tw|² = 1 + g + 2pt + mt².

    Where spheres are not equal, the square of their contact distance takes the place of 1.
    """

    g: Number
    p: Number
    m: Number


def unnamed(_: str, value: Number) -> Number:
    """Keep a value as it is."""
    return value


def flight(state: State, root: Callable[[Number], Number], keep: Keep = unnamed) -> Flight:
    """The flight until o and c are in contact, where 0 < lam and A kap < 1."""
    y = keep("y", state.lam * state.v)
    q = keep("q", state.rho / state.lam)
    kap = keep("kap", state.eps / state.lam / state.lam)
    s = keep("s", root(1 - state.A * kap))
    T = keep("T", kap / (1 + s))
    return Flight(y, q, kap, s, T)


def collided(
    r: Number, state: State, way: Flight, keep: Keep = unnamed, sizes: Sizes = EQUAL
) -> State:
    """The state just after o and c have collided; now c is the spectator.

    With ω = x_c at contact, W_c becomes W_c + (1+r) y s ω and W_s becomes W_s + (1+r)/2 y s ω. For
    other sizes both changes are divided by the square of the contact distance, and 1 + m_o/m_c
    takes the place of 2.
    """
    _, _, _, _, _, A, B, C, a, b, w = state
    y, q, _, s, T = way
    ratio = sizes.ratio
    speed, time, half = y * s, y * T, (1 + r) / ratio
    push, turned = half * speed, time * w
    f, TB = b + turned, T * B
    C = keep("C", C - time * (a + f))
    lam = keep("lam", _over(half * s * C, sizes.c) - q - TB)
    A_next = keep("A", B + _over(push * (2 * f + push), sizes.c))
    B_next = keep("B", A - _over((1 - r**2) * speed**2, sizes.c))
    a_next = keep("a", f + push)
    b_next = keep("b", a + turned - _over(ratio * push * C, sizes.c))
    w_next = keep("w", w + _over(push * (ratio * f + r * speed), sizes.c))
    eps = keep("eps", parted(state, way))
    return State(y, lam, r * s, eps, 0, A_next, B_next, C, a_next, b_next, w_next)


def _over(value: Number, square: Number) -> Number:
    return value if isinstance(square, int) else value / square


def parted(state: State, way: Flight) -> Number:
    """(|x_s|² - 1)/y² when o and c meet."""
    return state.sig / state.lam / state.lam + way.T * (2 * way.q + way.T * state.B)


def outer(state: State, sizes: Sizes = EQUAL) -> Pair:
    """The pair s, c."""
    v, lam, rho, eps, sig, A, B, C, a, b, w = state
    rest = sizes.c + sizes.s - sizes.outer
    return Pair(rest + (eps + sig) * v**2 + 2 * C, (rho - lam) * v - a - b, A + B - 2 * w)


def inner(state: State) -> tuple[Pair, Pair]:
    """The pairs o, c and o, s."""
    v = state.v
    return (
        Pair(state.eps * v**2, -(state.lam * v), state.A),
        Pair(state.sig * v**2, state.rho * v, state.B),
    )


def recentred(state: State, keep: Keep = unnamed, sizes: Sizes = EQUAL) -> State:
    """The same moment seen from s: now s is central, o the spectator, and c stays c."""
    v, _, rho, _, sig, _, B, C, a, b, w = state
    g, p, m = outer(state, sizes)
    return State(
        1,
        keep("lam", -p),
        keep("rho", rho * v),
        keep("eps", g),
        keep("sig", sig * v**2),
        keep("A", m),
        B,
        keep("C", -C - sizes.s - sig * v**2),
        keep("a", rho * v - a),
        keep("b", rho * v - b),
        keep("w", B - w),
    )


def drifted(state: State, time: Number, keep: Keep = unnamed) -> State:
    """The state after a free flight."""
    v, lam, rho, eps, sig, A, B, C, a, b, w = state
    u = time / v
    return State(
        v,
        keep("lam", lam - u * A),
        keep("rho", rho + u * B),
        keep("eps", eps - u * (2 * lam - u * A)),
        keep("sig", sig + u * (2 * rho + u * B)),
        A,
        B,
        keep("C", C - time * (a + b + time * w)),
        keep("a", a + time * w),
        keep("b", b + time * w),
        w,
    )
