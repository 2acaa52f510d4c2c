"""Check that a certificate proves a statement. This file is all that has to be trusted.

    python3 -I verify/check.py FOLDER                     (statement.json and certificate.json)
    python3 -I verify/check.py STATEMENT CERTIFICATE

What is believed: Python's integers, ``fractions``, ``json`` and ``hashlib``, and these lines. The
*statement* says what is claimed; the *certificate* says how each obligation is proved. No word of
the certificate is believed, and its enclosures are only compared with those computed here.
``verify/wire.py`` describes the two formats.

An obligation without variables claims that its two sides are defined as real numbers and stand in
the relation; one with variables claims that for all values in their open intervals, and the
negation of such a one claims values where both sides are defined and the relation fails. Every
rule below establishes this or raises `Refused`; what is not in the format raises `Malformed`.
Nothing is searched for. There are no floating-point numbers: a real number is enclosed between
integer multiples of a power of two, rounded outward. Sizes are bounded, so that checking ends.

Exit codes: 0 all is proved and no needed row is a negation; 1 something is not proved; 2 unusable
command line; 4 a file is malformed, or the two do not belong together.
"""

from __future__ import annotations

import json
import os
import re
import sys
from collections.abc import Callable, Sequence
from fractions import Fraction
from hashlib import sha256
from itertools import pairwise, product
from math import comb, isqrt
from typing import Any

# --- The signature: what a statement can say, and how much of it --------------------------------

STATEMENT_FORMAT, CERTIFICATE_FORMAT = "verify-statement/1", "verify-certificate/1"
#: Each operation with its number of arguments (None: two or more); and ["pow", term, exponent].
ARITY = {"add": 2, "sub": 2, "mul": 2, "div": 2, "neg": 1, "sqrt": 1, "cos": 1, "cos_pi": 1}
MANY = ("min", "max")
#: What the failure of a relation means for the two sides in the opposite order (= has no order).
OPPOSITE = {"<": "<=", "<=": "<", "=": "!="}
ROLES = ("needed", "printed")
NAME = "[A-Za-z][A-Za-z0-9_.-]{0,99}"
RATIONAL = "-?[0-9]{1,4300}(/0*[1-9][0-9]{0,4299})?"  # Python converts 4300 digits
DECIMAL = r"-?[0-9]{1,999}(\.[0-9]{1,999})?(e-?[0-9]{1,5})?"

MAX_BYTES = 1 << 22  # of a file
MAX_NESTING = 100  # of brackets in a file
MAX_HEIGHT = 200  # of a term
MAX_BITS = 1 << 16  # of precision
MAX_EXPONENT = 1 << 20  # of the power of two in an interval
MAX_POWER = 1000  # as an exponent in a term
MAX_SIZE = 1 << 18  # bits of an exact value
MAX_DEGREE = 256  # of a polynomial in one atom
MAX_PRODUCT = 4000  # of the numbers of terms of two polynomials that are multiplied
MAX_WORK = 10_000_000  # about the number of microseconds

Interval = tuple[int, int, int]  # (low, high, exp): the numbers from low*2^exp to high*2^exp
Monomial = tuple[tuple[int, int], ...]  # (atom, power), sorted by atoms, which are terms
Polynomial = dict[Monomial, int]
Quotient = tuple[Polynomial, Polynomial]
Ends = tuple[Fraction, Fraction]
Box = dict[int, tuple[Fraction | None, Fraction | None]]  # variable to ends, None if unbounded
ONE, UNIT = (1, 1, 0), {(): 1}


class Malformed(Exception):  # noqa: N818
    """A file is not in the format, or the two files do not belong together."""


class Refused(Exception):  # noqa: N818
    """The evidence does not prove the obligation."""


# --- Interval arithmetic: a result encloses the results for all real numbers in the arguments ---


def rounded(bits: int, low: int, high: int, exp: int) -> Interval:
    """An interval around [low, high] 2^exp with ends of about ``bits`` bits, as >> rounds down."""
    excess = max(low.bit_length(), high.bit_length()) - bits
    if excess > 0:
        low, high, exp = low >> excess, -(-high >> excess), exp + excess
    if abs(exp) > MAX_EXPONENT:
        raise Refused(f"a number near 2^{exp} is out of range")
    return low, high, exp


def from_ratio(bits: int, p: int, q: int) -> Interval:
    """An interval around p/q, for q > 0."""
    shift = bits + q.bit_length()
    return rounded(bits, (p << shift) // q, -((-p << shift) // q), -shift)


def moved(x: Interval, exp: int) -> tuple[int, int]:
    """The ends of x in multiples of 2^exp, rounded outward (exact where exp is not larger)."""
    low, high, shift = x[0], x[1], x[2] - exp
    return (low << shift, high << shift) if shift >= 0 else (low >> -shift, -(-high >> -shift))


def lift(function: Callable[[int, int], int]) -> Callable[..., Interval]:
    """The operation on intervals for a function that rises with both of its arguments.

    It has to commute with scaling (like +, min and max): ends of the result come from ends of the
    arguments in multiples of one 2^exp, exact or far below the larger argument's last bit. As
    zero fits any exponent, it takes the other one's.
    """

    def lifted(bits: int, x: Interval, *others: Interval) -> Interval:
        for y in others:
            e, f = x[2] if x[0] or x[1] else y[2], y[2] if y[0] or y[1] else x[2]
            exp = max(min(e, f), max(e, f) - 2 * bits)
            (a, b), (c, d) = moved(x, exp), moved(y, exp)
            x = rounded(bits, function(a, c), function(b, d), exp)
        return x

    return lifted


add, minimum, maximum = lift(int.__add__), lift(min), lift(max)


def neg(_: int, x: Interval) -> Interval:
    """The negatives of x."""
    return -x[1], -x[0], x[2]


def mul(bits: int, x: Interval, y: Interval) -> Interval:
    """A product is linear in each factor, so its extremes are products of ends."""
    (a, b, e), (c, d, f) = x, y
    ends = (a * c, b * d) if a >= 0 and c >= 0 else (a * c, a * d, b * c, b * d)
    return rounded(bits, min(ends), max(ends), e + f)


def div(bits: int, x: Interval, y: Interval) -> Interval:
    """For a positive divisor in [c, d], the least quotient is a/d or, for a < 0, a/c."""
    (a, b, e), (c, d, f) = x, y if y[0] > 0 else neg(bits, y)
    if c <= 0:
        raise Refused(f"a division by {shown(y)}, which contains 0")
    if y[0] < 0:
        a, b = -b, -a
    shift = max(0, bits + 2 + d.bit_length() - max(a.bit_length(), b.bit_length()))
    a, b = a << shift, b << shift
    return rounded(bits, a // (d if a >= 0 else c), -(-b // (c if b >= 0 else d)), e - f - shift)


def sqrt(bits: int, x: Interval) -> Interval:
    """Floor and ceiling of the roots of the ends, after scaling by an even power of two."""
    low, high, exp = x
    if low < 0:
        raise Refused(f"a square root of {shown(x)}, which reaches below 0")
    shift = max(0, 2 * bits - high.bit_length())
    shift += (exp - shift) % 2
    top = isqrt((high << shift) - 1) + 1 if high else 0
    return rounded(bits, isqrt(low << shift), top, (exp - shift) // 2)


def power(bits: int, x: Interval, n: int) -> Interval:
    """x^n for n >= 1, where x^(m+1) is x * x^m and x^(2m) is the square of |x^m|."""
    if n == 1:
        return x
    if n % 2:
        return mul(bits, x, power(bits, x, n - 1))
    low, high, exp = power(bits, x, n // 2)
    root = (low, high, exp) if low >= 0 else (max(0, -high), max(-low, high), exp)
    return mul(bits, root, root)


def inverse_arctan(n: int, bits: int) -> tuple[int, int]:
    """Integers t and e with |t - 2^bits arctan(1/n)| <= e, for n >= 2.

    arctan(1/n) is the sum of (-1)^k / ((2k+1) n^(2k+1)), alternating and decreasing. ``scaled`` is
    the floor of 2^bits / n^(2k+1) (nested floors are one floor), so each term is off by less than
    1; once ``scaled`` is 0, so is the rest of the sum.
    """
    scaled, total, k = (1 << bits) // n, 0, 0
    while scaled:
        total += scaled // (2 * k + 1) * (-1 if k % 2 else 1)
        scaled, k = scaled // (n * n), k + 1
    return total, k + 1


def pi(bits: int) -> Interval:
    """Machin: pi = 16 arctan(1/5) - 4 arctan(1/239)."""
    (a, i), (b, j) = inverse_arctan(5, bits + 32), inverse_arctan(239, bits + 32)
    middle, error = 16 * a - 4 * b, 16 * i + 4 * j
    return rounded(bits, middle - error, middle + error, -bits - 32)


def cos(bits: int, x: Interval) -> Interval:
    """The cosine of |x| < 64, cut to [-1, 1].

    The sum over k < m of (-1)^k x^(2k)/(2k)! is off by at most x^(2m)/(2m)! (Taylor's theorem, as
    all derivatives of cos are bounded by 1). The loop ends with that sum in ``total``, and with
    x^(2m)/(2m)!, which is then below 2^-work, in ``term``. No term exceeds e^64 < 2^93.
    """
    if max(-x[0], x[1]).bit_length() + x[2] > 6:
        raise Refused(f"a cosine of {shown(x)}, which reaches beyond 64")
    work = bits + 128
    square, term, total, n = power(work, x, 2), ONE, (0, 0, 0), 0
    while term[1] and term[1].bit_length() + term[2] > -work:
        total = add(work, total, neg(work, term) if n % 4 else term)
        n += 2
        term = div(work, mul(work, term, square), (n * n - n, n * n - n, 0))
    total = add(bits, total, (-term[1], term[1], term[2]))
    return minimum(bits, ONE, maximum(bits, neg(bits, ONE), total))


def cos_pi(bits: int, x: Interval) -> Interval:
    """cos(pi x) = cos(pi (x - 2k)), here with k = floor(low end / 2)."""
    k = moved(x, 1)[0]
    return cos(bits, mul(bits + 32, add(bits + 32, x, (-2 * k, -2 * k, 0)), pi(bits + 32)))


INTERVALS: dict[str, Callable[..., Interval]] = {
    "rational": from_ratio, "pow": power, "add": add, "mul": mul, "div": div, "neg": neg,
    "sub": lambda bits, x, y: add(bits, x, neg(bits, y)),
    "sqrt": sqrt, "min": minimum, "max": maximum, "cos": cos, "cos_pi": cos_pi,
}  # fmt: skip


# --- Exact arithmetic ----------------------------------------------------------------------------


def exact_div(_: int, x: Fraction, y: Fraction) -> Fraction:
    """The quotient, for y != 0."""
    if y == 0:
        raise Refused("a division by 0")
    return x * Fraction(y.denominator, y.numerator)


def exact_sqrt(_: int, x: Fraction) -> Fraction:
    """The root of a rational square."""
    root = Fraction(isqrt(max(x.numerator, 0)), isqrt(x.denominator))
    if root * root != x:
        raise Refused("a square root that is not rational")
    return root


def exact_power(_: int, x: Fraction, n: int) -> Fraction:
    """x^n for n >= 1."""
    if n * size(x) > 2 * MAX_SIZE:
        raise Refused(f"a power of more than {MAX_SIZE} bits")
    return Fraction(x.numerator**n, x.denominator**n)


def no_value(_: int, *__: Fraction) -> Fraction:
    """A cosine has no exact value here."""
    raise Refused("a cosine, which has no exact value here")


def size(x: Fraction) -> int:
    """The bits that numerator and denominator take."""
    return x.numerator.bit_length() + x.denominator.bit_length()


EXACT: dict[str, Callable[..., Fraction]] = {
    "rational": lambda _, p, q: Fraction(p, q), "pow": exact_power, "neg": lambda _, x: -x,
    "add": lambda _, x, y: x + y, "sub": lambda _, x, y: x - y, "mul": lambda _, x, y: x * y,
    "div": exact_div, "sqrt": exact_sqrt, "cos": no_value, "cos_pi": no_value,
    "min": lambda _, *xs: min(xs), "max": lambda _, *xs: max(xs),
}  # fmt: skip


def decide(relation: str, x: Any, y: Any) -> None:
    """Afterwards the relation holds between any numbers of the enclosures (or values) x and y."""
    exp = 0 if isinstance(x, Fraction) else min(x[2], y[2])
    (a, b), (c, d) = ((z, z) if isinstance(z, Fraction) else moved(z, exp) for z in (x, y))
    holds = {"<": b < c, "<=": b <= c, "=": b <= c and d <= a, "!=": b < c or d < a}
    if not holds[relation]:
        raise Refused(f"found {shown(x)} and {shown(y)}, expected {relation} between them")


# --- Terms, and what is computed from them -------------------------------------------------------


class Checker:
    """Terms and definitions of a statement.

    Each distinct subterm is stored once, and a term is its index in ``nodes``. A node is an
    operation and its arguments; ``rational`` has a numerator and a denominator, ``symbol`` a
    number. ``definitions`` takes the symbols of parameters and constants to their terms, which
    have only earlier symbols.
    """

    def __init__(self) -> None:
        self.nodes: list[tuple[str, tuple[int, ...]]] = []
        self.heights: list[int] = []
        self.index: dict[tuple[str, tuple[int, ...]], int] = {}
        self.leaves: dict[str, int] = {}  # the names in scope, and the rationals read so far
        self.names: dict[int, str] = {}
        self.definitions: dict[int, int] = {}
        self.scopes: dict[int, Scope] = {}
        self.work = MAX_WORK

    def spend(self, bits: int, times: int = 1) -> None:
        """Count operations with so many bits; give up when they were too many."""
        self.work -= times * (8 + (bits * bits >> 20))
        if self.work < 0:
            raise Refused("this takes too much work to check")

    def node(self, op: str, *args: int) -> int:
        """The term of an operation and its arguments."""
        key = op, args
        if key not in self.index:
            height = 1 + max((self.heights[term] for term in args[: terms_in(op)]), default=0)
            if height > MAX_HEIGHT:
                raise Refused(f"a term of more than {MAX_HEIGHT} levels")
            self.index[key] = len(self.nodes)
            self.nodes.append(key)
            self.heights.append(height)
        return self.index[key]

    def symbol(self, where: str, name: object) -> int:
        """A new name in scope."""
        if text(where, name, NAME) in self.leaves:
            raise wrong(where, name, "a name that is not in use")
        symbol = self.leaves[str(name)] = self.node("symbol", len(self.nodes))
        self.names[symbol] = str(name)
        return symbol

    def read(self, where: str, value: object) -> int:
        """The term that is written over the names in scope."""
        if isinstance(value, str):
            if value not in self.leaves:
                number = rational(where, value, "a rational or the name of something defined above")
                self.leaves[value] = self.node("rational", number.numerator, number.denominator)
            return self.leaves[value]
        op, *args = array(where, value) or [None]
        if op == "pow" and len(args) == 2:
            exponent = int(text(where, args[1], "[1-9][0-9]{0,3}"))
            if exponent > MAX_POWER:
                raise wrong(where, args[1], f"an exponent of at most {MAX_POWER}")
            return self.node("pow", self.read(where, args[0]), exponent)
        if not isinstance(op, str) or not (len(args) == ARITY.get(op) or (op in MANY and args[1:])):
            raise wrong(where, op, f"an operation that has {len(args)} arguments")
        return self.node(op, *[self.read(where, arg) for arg in args])

    def substitute(self, term: int, done: dict[int, int]) -> int:
        """The term after replacing what ``done`` replaces; ``done`` learns the subterms."""
        if term not in done:
            op, args = self.nodes[term]
            count = terms_in(op)
            inner = [self.substitute(arg, done) for arg in args[:count]]
            done[term] = self.node(op, *inner, *(args[count:] if count is not None else ()))
        return done[term]

    def scope(self, bits: int, box: Box | None = None, **_: object) -> Scope:
        """x"""
        raise NotImplementedError
