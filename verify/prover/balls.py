"""Ball arithmetic, and rational numbers as FLINT and Python have them.

A ball is an `arb`. Every operation that can leave the real numbers (division, square root) checks
its result, so a value that comes out of a program is finite and encloses the exact one.
Comparisons of balls certify their true side only: ``not a < b`` proves nothing.
"""

from __future__ import annotations

import math
import operator
from collections.abc import Callable, Iterator
from contextlib import contextmanager
from fractions import Fraction
from functools import partial

from flint import arb, ctx, fmpq, fmpz

from verify.language.record import Any
from verify.language.terms import MAX_INDEX
from verify.prover.decimals import round_decimal
from verify.prover.program import UndefinedError

Ball = arb
#: Of two: larger powers are not written down.
LARGEST_EXPONENT = 1 << 18
#: The checker encloses no exponential of a larger number, and one of less than the opposite by 0
#: and the power of two with that exponent.
MAX_EXPONENT = 1 << 16


@contextmanager
def precision(bits: int) -> Iterator[None]:
    """Work with ``bits`` bits of precision inside a ``with`` block."""
    with ctx.workprec(bits):
        yield


def float_of(value: fmpq | Fraction) -> float:
    """The nearest float, or about that; an infinite one beyond the largest."""
    top, bottom = (value.p, value.q) if isinstance(value, fmpq) else value.as_integer_ratio()
    try:
        return int(top) / int(bottom)
    except OverflowError:
        return math.inf if top > 0 else -math.inf


def fmpq_of(value: Fraction | float) -> fmpq:
    """The same number for FLINT."""
    value = Fraction(value)
    return fmpq(value.numerator, value.denominator)


def fraction_of(value: fmpq) -> Fraction:
    """The same number for Python."""
    return Fraction(int(value.p), int(value.q))


def from_fraction(value: Fraction) -> arb:
    """The ball around an exact rational, at the current precision."""
    return arb(fmpq(value.numerator, value.denominator))


def hull(a: arb, b: arb) -> arb:
    """A ball that contains both balls and all that lies between them."""
    return a.union(b)


def around(centre: arb, bits: int) -> arb:
    """All numbers that differ from those of a ball by a relative error of at most 2^-bits."""
    return centre * arb(1, 2.0**-bits)


def middle(ball: arb) -> arb:
    """The midpoint of a ball, an exact number."""
    return ball.mid()


def inside(inner: arb, outer: arb) -> bool:
    """True only if a finite ball lies in the interior of another one."""
    return bool(inner.is_finite() and outer.contains_interior(inner))


def integer_in(ball: arb) -> int | None:
    """The only integer in a ball; None if there is none, or more than one."""
    integer = ball.unique_fmpz()
    return None if integer is None else int(integer)


def root(ball: arb) -> arb:
    """The square root of a ball of positive numbers."""
    return _OPERATIONS["sqrt"](ball)


def cube_root(ball: arb) -> arb:
    """The cube root of a ball of positive numbers."""
    return ball.root(3)


def argument(re: arb, im: arb) -> arb:
    """The argument in ]-pi, pi] of a complex number."""
    return arb.atan2(im, re)


def pi() -> arb:
    """The ball around pi, at the current precision."""
    return arb.pi()


def _finite(function: Callable[..., arb], name: str) -> Callable[..., arb]:
    def checked(*operands: arb) -> arb:
        result = function(*operands)
        if not result.is_finite():
            raise UndefinedError(f"{name} of {', '.join(map(str, operands))} is not finite")
        return result

    return checked


def _cos(x: arb) -> arb:
    return x.cos() + _last_bit()


def _cos_pi(x: arb) -> arb:
    return x.cos_pi() + _last_bit()


def _sin(x: arb) -> arb:
    return x.sin() + _last_bit()


def _root(x: arb, index: int) -> arb:
    return x if x.is_zero() else x.root(index)


def _exp(x: arb) -> arb:
    """What the checker sees of an exponential: nothing of a huge one, and 0 next to a tiny one."""
    if not (x <= MAX_EXPONENT - 1 or x == MAX_EXPONENT):
        raise UndefinedError(f"the exponential of {x} is too large")
    least = hull(arb(0), arb(2) ** -MAX_EXPONENT)
    return x.exp() if x > 1 - MAX_EXPONENT else hull(least, x.exp())


def _last_bit() -> arb:
    """What a cosine may be off by in an arithmetic that knows no exact ones."""
    return arb(0, 1) * arb(2) ** -ctx.prec


_OPERATIONS: dict[str, Callable[..., arb]] = {
    "add": operator.add,
    "sub": operator.sub,
    "mul": operator.mul,
    "div": _finite(operator.truediv, "the quotient"),
    "neg": operator.neg,
    "sqrt": _finite(arb.sqrt, "the square root"),
    "min": arb.min,
    "max": arb.max,
    "cos": _cos,
    "cos_pi": _cos_pi,
    "sin": _sin,
    "exp": _exp,
    "log": _finite(arb.log, "the logarithm"),
    "atan": arb.atan,
    **{
        f"root {index}": _finite(partial(_root, index=index), f"the root of index {index}")
        for index in range(2, MAX_INDEX + 1)
    },
}


def operation(name: str) -> Callable[..., arb]:
    """The ball operation of this name; it raises `UndefinedError` where a result is not finite."""
    return _OPERATIONS[name]


class BallArithmetic:
    """The arithmetic of `verify.prover.program` on balls."""

    def rational(self, value: Fraction) -> Any:
        """The ball around an exact rational."""
        return from_fraction(value)

    def operation(self, name: str) -> Callable[..., arb]:
        """The ball operation of this name."""
        return _OPERATIONS[name]


def value_around(name: str, value: Fraction, bits: int) -> tuple[Fraction, Fraction]:
    """Ends around a function at a number, some units of the last of so many bits away from it."""
    with ctx.workprec(bits + 32):
        found = _OPERATIONS[name](from_fraction(value))
        return ends(found * arb(1, 2.0 ** (2 - bits)))


def floor_root(number: int, index: int) -> int:
    """The greatest integer whose power is at most a natural number."""
    return int(fmpz(number).root(index))


def less(a: arb, b: arb) -> bool:
    """True only if every number in a is smaller than every number in b."""
    return bool(a < b)


def strict_sign(ball: arb) -> int:
    """1 if every number in the ball is positive, -1 if every one is negative, else 0."""
    return int(ball > 0) - int(ball < 0)


def ends(ball: arb) -> tuple[Fraction, Fraction]:
    """Rational numbers that enclose a ball: its ends, rounded outward to the precision."""
    return dyadic(ball.lower()), dyadic(ball.upper())


def exact_ends(ball: arb) -> tuple[arb, arb]:
    """The same ends, as balls that are exact numbers."""
    return ball.lower(), ball.upper()


def dyadic(ball: arb) -> Fraction:
    """The number that an exact ball is."""
    mantissa, exponent = map(int, ball.man_exp())
    if exponent >= 0:
        return Fraction(mantissa << exponent)
    return Fraction(mantissa, 1 << -exponent)


def widened_ends(ball: arb, bits: int) -> tuple[int, int, int]:
    """Integers a, b and d > 0: the interval from a/d to b/d contains the ball, and more.

    It also contains all numbers that differ from those of the ball by 2^-bits of its midpoint.
    """
    middle, exponent = map(int, ball.mid().man_exp())
    radius, scale = map(int, ball.rad().man_exp())
    lowest = min(exponent - bits, scale) if radius else exponent - bits
    wide = (abs(middle) << (exponent - bits - lowest)) + (radius << max(scale - lowest, 0))
    centre = middle << (exponent - lowest)
    low, high = centre - wide, centre + wide
    return (low << lowest, high << lowest, 1) if lowest > 0 else (low, high, 1 << -lowest)


def accuracy_bits(ball: arb) -> int:
    """How many relative bits of the ball are known; very large for an exact one."""
    return int(ball.rel_accuracy_bits())


def is_rational(value: Any) -> bool:
    """Whether a number is an exact rational and no ball."""
    return type(value) is fmpq


def shortened(value: Any, bits: int) -> Any:
    """A rational number of at most so many bits as it is; a longer one as a ball."""
    return arb(value) if type(value) is fmpq and value.height_bits() > bits else value


def any_root(value: Any) -> Any:
    """The root of a positive rational or ball: a rational if that is possible."""
    if type(value) is not fmpq:
        return value.sqrt()
    p, q = int(value.p), int(value.q)
    n, d = math.isqrt(p), math.isqrt(q)
    return fmpq(n, d) if (n * n, d * d) == (p, q) else arb(value).sqrt()


def as_ball(value: Any) -> arb:
    """A ball around a rational number, an integer, or a ball."""
    return value if isinstance(value, arb) else arb(value)


def short_rational(value: Any, digits: int = 12) -> Fraction:
    """A rational number with few digits near a ball or a rational number."""
    middle = as_ball(value).mid()
    if middle.is_zero():
        return Fraction(0)
    mantissa, exponent = round_decimal(dyadic(middle), digits, up=False)
    return mantissa * Fraction(10) ** exponent


def exponent(value: Any) -> int:
    """The integer e with 10^e near a positive number."""
    ball = as_ball(value)
    return math.floor(float(ball.mid().log() / arb(10).log()))


def magnitude_bits(value: Any) -> int:
    """The number of bits of the integer part; 0 for a number below 1, or one that is not known."""
    if value is None or not as_ball(value).is_finite():
        return 0
    mantissa, exponent = as_ball(value).abs_upper().man_exp()
    return max(0, int(mantissa).bit_length() + int(exponent))


def ratio(top: int, divisor: int) -> fmpq:
    """An exact quotient."""
    return fmpq(top, divisor)


def decimal(value: Any, places: int, *, above: bool = False) -> fmpq:
    """A decimal with so many places near a number, or no less than the number."""
    power = fmpq(10) ** places
    ball = as_ball(value)
    scaled = ((ball.upper() if above else ball.mid()) * power).upper()
    return fmpq(dyadic(scaled.ceil()).numerator) / power


def larger(a: Any, b: Any) -> arb:
    """The larger one of two numbers."""
    return as_ball(a).max(as_ball(b))


def as_float(value: Any) -> float:
    """A float near a ball or a rational number."""
    return float(as_ball(value).mid())


def is_within_reach(ball: arb) -> bool:
    """Whether a ball is finite, and neither its middle nor its radius too large or small to write.

    Numbers from a scene file are: they have at most a few thousand digits.
    """
    if not ball.is_finite():
        return False
    parts = (part.man_exp() for part in (ball.mid(), ball.rad()) if not part.is_zero())
    return all(abs(int(exponent)) < LARGEST_EXPONENT for _, exponent in parts)


def loosened(ball: arb) -> arb:
    """A ball with the same midpoint and a much larger radius, if it has one at all."""
    return ball + ball.rad() * arb(0, 1 << 12)


def is_same(a: Any, b: Any) -> bool:
    """Whether two numbers are rational, and equal."""
    return type(a) is fmpq and type(b) is fmpq and bool(a == b)
