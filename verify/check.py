"""Check that a certificate proves a statement. This file is what has to be trusted.

    python3 -I verify/check.py FOLDER                     (statement.json and certificate.json)
    python3 -I verify/check.py STATEMENT CERTIFICATE

What is believed: Python's integers, ``fractions``, ``json`` and ``hashlib``, and the lines below.
The *statement* says what is claimed: parameters, named constants, obligations, assumptions. The
*certificate* says how each obligation is proved; none of its words is believed, and its enclosures
are only compared with the ones computed here. ``verify/wire.py`` describes both formats.

An obligation without variables claims that both of its sides are defined as real numbers and stand
in the relation; one with variables claims it for all values in their open intervals (so the claim
that such a one fails needs a point where it fails). Every rule below either establishes that or
raises `Refused`; a file that is not in the format raises `Malformed`. Nothing is searched for, and
there are no floating-point numbers: terms are enclosed by intervals of integers times a power of
two, rounded outward. Sizes are bounded, so that checking ends.

Exit codes: 0 everything is proved and no needed row is a negation; 1 something is not proved;
2 the command line cannot be used; 4 a file is malformed or the two do not belong together.
"""

from __future__ import annotations

import json
import os
import re
import sys
from collections.abc import Callable, Iterable
from fractions import Fraction
from hashlib import sha256
from itertools import product
from math import comb, isqrt

# --- The signature: what a statement can say -----------------------------------------------------

#: The operations and how many arguments each has (0: two or more); besides, ["pow", term, "2"].
ARITY = {"add": 2, "sub": 2, "mul": 2, "div": 2, "neg": 1, "sqrt": 1, "cos": 1, "cos_pi": 1}
ARITY |= {"min": 0, "max": 0}
#: not (a < b) is b <= a, not (a <= b) is b < a, not (a = b) is a != b.
OPPOSITE = {"<": "<=", "<=": "<", "=": "!=", "!=": "="}
ROLES = ("needed", "printed")
STATEMENT_FORMAT, CERTIFICATE_FORMAT = "verify-statement/1", "verify-certificate/1"

MAX_BYTES = 1 << 22  # of a file
MAX_NESTING = 100  # of a file
MAX_HEIGHT = 200  # of a term
MAX_DIGITS = 4300  # of an integer; what Python converts without further settings
MAX_BITS = 1 << 16  # of precision
MAX_EXPONENT = 1 << 20  # of the power of two in an interval
MAX_POWER = 1000  # in ["pow", term, power]
MAX_SIZE = 1 << 18  # bits of an exact rational
MAX_DEGREE = 256  # of a polynomial
MAX_WORK = 10_000_000  # about one per microsecond

Interval = tuple[int, int, int]  # (low, high, exp): the numbers from low*2^exp to high*2^exp
Node = tuple[str, tuple[int, ...]]
Box = dict[int, tuple[Fraction | None, Fraction | None]]
Monomial = tuple[tuple[int, int], ...]  # (atom, power), sorted by atom
Polynomial = dict[Monomial, int]
Quotient = tuple[Polynomial, Polynomial]
ZERO, ONE, MINUS_ONE = (0, 0, 0), (1, 1, 0), (-1, -1, 0)


class Malformed(Exception):  # noqa: N818
    """A file is not in the format, or the two files do not belong together."""


class Refused(Exception):  # noqa: N818
    """An obligation is not proved by its evidence."""


# --- Interval arithmetic: each result encloses all results of real arguments in the arguments ----


def rounded(bits: int, low: int, high: int, exp: int) -> Interval:
    """An interval around [low, high]*2^exp whose ends have about ``bits`` bits: `>>` floors."""
    excess = max(low.bit_length(), high.bit_length()) - bits
    if excess > 0:
        low, high, exp = low >> excess, -(-high >> excess), exp + excess
    if abs(exp) > MAX_EXPONENT:
        if low == high == 0:
            return ZERO
        raise Refused(f"a number near 2**{exp + high.bit_length()} is out of range")
    return low, high, exp


def from_ratio(bits: int, p: int, q: int) -> Interval:
    """An interval around p/q, where q > 0: floor and ceiling of 2^shift * p/q."""
    shift = bits + q.bit_length()
    return rounded(bits, (p << shift) // q, -((-p << shift) // q), -shift)


def moved(low: int, high: int, shift: int) -> tuple[int, int]:
    """[low, high] * 2^shift with its ends rounded outward to integers."""
    return (low << shift, high << shift) if shift >= 0 else (low >> -shift, -(-high >> -shift))


def aligned(bits: int, x: Interval, y: Interval) -> tuple[int, int, int, int, int]:
    """x and y over one power of two, at most 2*bits below the larger one; 0 fits any power."""
    (a, b, e), (c, d, f) = x, y
    e, f = (f if a == b == 0 else e), (e if c == d == 0 else f)
    exp = max(min(e, f), max(e, f) - 2 * bits)
    return *moved(a, b, e - exp), *moved(c, d, f - exp), exp


def add(bits: int, x: Interval, y: Interval) -> Interval:
    """Encloses x + y: the sum rises with both."""
    a, b, c, d, exp = aligned(bits, x, y)
    return rounded(bits, a + c, b + d, exp)


def neg(_bits: int, x: Interval) -> Interval:
    """Encloses -x, exactly."""
    return -x[1], -x[0], x[2]


def sub(bits: int, x: Interval, y: Interval) -> Interval:
    """Encloses x - y."""
    return add(bits, x, neg(bits, y))


def minimum(bits: int, x: Interval, y: Interval) -> Interval:
    """Encloses the smaller one: it rises with both."""
    a, b, c, d, exp = aligned(bits, x, y)
    return rounded(bits, min(a, c), min(b, d), exp)


def maximum(bits: int, x: Interval, y: Interval) -> Interval:
    """Encloses the larger one: it rises with both."""
    a, b, c, d, exp = aligned(bits, x, y)
    return rounded(bits, max(a, c), max(b, d), exp)


def mul(bits: int, x: Interval, y: Interval) -> Interval:
    """Encloses x * y: it is linear in each, so its extremes are at ends."""
    (a, b, e), (c, d, f) = x, y
    if a >= 0 and c >= 0:
        return rounded(bits, a * c, b * d, e + f)
    ends = (a * c, a * d, b * c, b * d)
    return rounded(bits, min(ends), max(ends), e + f)


def div(bits: int, x: Interval, y: Interval) -> Interval:
    """Encloses x / y where y does not contain 0: with y > 0, a low end falls by a small divisor
    if it is negative and by a large one otherwise; a high end the other way round.
    """  # noqa: D205
    (a, b, e), (c, d, f) = x, y
    if d < 0:
        a, b, c, d = -b, -a, -d, -c
    if c <= 0:
        raise Refused(f"division by {shown(y)}, which contains 0")
    shift = max(0, bits + 2 + d.bit_length() - max(a.bit_length(), b.bit_length()))
    a, b = a << shift, b << shift
    return rounded(bits, a // (d if a >= 0 else c), -(-b // (c if b >= 0 else d)), e - f - shift)


def sqrt(bits: int, x: Interval) -> Interval:
    """Encloses the square root of x >= 0: floor and ceiling of the roots of the ends, scaled."""
    low, high, exp = x
    if low < 0:
        raise Refused(f"a square root of {shown(x)}, which reaches below 0")
    shift = max(0, 2 * bits - high.bit_length())
    shift += (exp - shift) & 1
    top = isqrt((high << shift) - 1) + 1 if high else 0
    return rounded(bits, isqrt(low << shift), top, (exp - shift) >> 1)


def power(bits: int, x: Interval, n: int) -> Interval:
    """Encloses x^n for n >= 1: x^2m is the square of |x^m|, x^(m+1) is x * x^m."""
    if n == 1:
        return x
    if n & 1:
        return mul(bits, x, power(bits, x, n - 1))
    low, high, exp = power(bits, x, n >> 1)
    if low < 0:
        low, high = max(0, -high), max(-low, high)
    return rounded(bits, low * low, high * high, 2 * exp)


def inverse_arctan(n: int, bits: int) -> tuple[int, int]:
    """Integers t and e with |t - 2^bits * arctan(1/n)| <= e, for n >= 2.

    arctan(1/n) is the sum of (-1)^k / ((2k+1) n^(2k+1)), alternating and decreasing. As nested
    floors are one floor, ``scaled`` is floor(2^bits / n^(2k+1)) and each term is off by less than
    1; the tail is at most its first term, less than 1 once ``scaled`` is 0.
    """
    scaled, total, k = (1 << bits) // n, 0, 0
    while scaled:
        term = scaled // (2 * k + 1)
        total, scaled, k = total + (-term if k & 1 else term), scaled // (n * n), k + 1
    return total, k + 1


def pi(bits: int) -> Interval:
    """Encloses pi = 16 arctan(1/5) - 4 arctan(1/239) (Machin 1706)."""
    (a, i), (b, j) = inverse_arctan(5, bits + 32), inverse_arctan(239, bits + 32)
    middle, error = 16 * a - 4 * b, 16 * i + 4 * j
    return rounded(bits, middle - error, middle + error, -bits - 32)


def cos(bits: int, x: Interval) -> Interval:
    """Encloses cos(x), where |x| < 64, within [-1, 1].

    By Taylor's theorem |cos x - sum_{k<m} (-1)^k x^(2k)/(2k)!| <= |x|^(2m)/(2m)!, as every
    derivative of cos is bounded by 1. The loop leaves with the sum over k < m in ``total`` and
    with x^(2m)/(2m)! >= 0, below 2^-work, in ``term``. The terms stay below e^64 < 2^93.
    """
    if max(-x[0], x[1]).bit_length() + x[2] > 6:
        raise Refused(f"the cosine of {shown(x)}: only arguments below 64 are supported")
    work = bits + 128
    square, term, total, n = power(work, x, 2), ONE, ZERO, 0
    while term[1].bit_length() + term[2] > -work and term[1]:
        total = (sub if n & 2 else add)(work, total, term)
        n += 2
        factor = n * (n - 1)
        term = div(work, mul(work, term, square), (factor, factor, 0))
    total = add(bits, total, (-term[1], term[1], term[2]))
    return minimum(bits, ONE, maximum(bits, MINUS_ONE, total))


def cos_pi(bits: int, x: Interval) -> Interval:
    """Encloses cos(pi x) = cos(pi (x - 2k)) for the integer k = floor(low end / 2)."""
    turns = 2 * (moved(x[0], x[0], x[2] - 1)[0])
    return cos(bits, mul(bits + 32, sub(bits + 32, x, (turns, turns, 0)), pi(bits + 32)))


OPERATIONS: dict[str, Callable[..., Interval]] = {
    "add": add, "sub": sub, "mul": mul, "div": div, "neg": neg, "sqrt": sqrt, "pow": power,
    "min": minimum, "max": maximum, "cos": cos, "cos_pi": cos_pi,
}  # fmt: skip


def holds(relation: str, a: Fraction | int, b: Fraction | int, c: Fraction | int,
          d: Fraction | int) -> bool:  # fmt: skip
    """Whether the relation holds between every number of [a, b] and every one of [c, d]."""
    if relation == "<":
        return b < c
    if relation == "<=":
        return b <= c
    return b <= c and d <= a if relation == "=" else b < c or d < a


def decide(relation: str, x: Interval, y: Interval) -> None:
    """Afterwards the relation holds between all numbers of x and all numbers of y."""
    exp = min(x[2], y[2])
    if not holds(relation, *moved(*x[:2], x[2] - exp), *moved(*y[:2], y[2] - exp)):
        raise Refused(f"found {shown(x)} and {shown(y)}, expected lhs {relation} rhs")


# --- Terms ---------------------------------------------------------------------------------------


class Terms:
    """Each distinct subterm once: a term is an index, larger than the indices of its arguments.

    A node is an operation with the terms of its arguments; ``rational`` has numerator and
    denominator instead, ``symbol`` a number, and ``pow`` a term and its exponent.
    """

    def __init__(self) -> None:
        self.nodes: list[Node] = []
        self.heights: list[int] = []
        self.index: dict[Node, int] = {}
        self.leaves: dict[str, int] = {}  # the names in scope, and the rationals read so far

    def node(self, op: str, *args: int) -> int:
        """The term with this operation and these arguments."""
        node = (op, args)
        if node not in self.index:
            height = 1 + max((self.heights[arg] for arg in arguments(node)), default=0)
            if height > MAX_HEIGHT:
                raise Refused(f"a term of more than {MAX_HEIGHT} levels")
            self.index[node] = len(self.nodes)
            self.nodes.append(node)
            self.heights.append(height)
        return self.index[node]

    def symbol(self, name: str) -> int:
        """A new name in scope."""
        self.leaves[name] = self.node("symbol", len(self.nodes))
        return self.leaves[name]

    def read(self, where: str, value: object) -> int:
        """The term that a JSON value writes over the names in scope."""
        if isinstance(value, str):
            if value not in self.leaves:
                number = rational(where, value)
                self.leaves[value] = self.node("rational", number.numerator, number.denominator)
            return self.leaves[value]
        op, *args = array(where, value, "a text or a list that starts with an operation")
        if op == "pow" and len(args) == 2:
            if not (isinstance(args[1], str) and re.fullmatch("[1-9][0-9]{0,3}", args[1])):
                raise wrong(where, args[1], f"an exponent from 1 to {MAX_POWER}, as a text")
            exponent = int(args[1])
            if exponent > MAX_POWER:
                raise wrong(where, args[1], f"an exponent from 1 to {MAX_POWER}")
            return self.node("pow", self.read(where, args[0]), exponent)
        arity = ARITY.get(op) if isinstance(op, str) else None
        if arity is None or len(args) != (arity or max(2, len(args))):
            raise wrong(where, op, f"an operation with its arguments, not {len(args)} of them")
        return self.node(str(op), *[self.read(where, arg) for arg in args])

    def substitute(self, term: int, done: dict[int, int]) -> int:
        """The term with the symbols of ``done`` replaced; what was found is added to ``done``."""
        if term not in done:
            op, args = node = self.nodes[term]
            inner = arguments(node)
            new = [self.substitute(arg, done) for arg in inner]
            done[term] = self.node(op, *new, *args[len(inner) :]) if inner else term
        return done[term]


def arguments(node: Node) -> tuple[int, ...]:
    """The arguments of a node that are terms."""
    return node[1][: {"rational": 0, "symbol": 0, "pow": 1}.get(node[0])]


class Checker:
    """The definitions of a statement, and what has been computed from them."""

    def __init__(self) -> None:
        self.terms = Terms()
        self.definitions: dict[int, int] = {}  # symbol to term, in an order that resolves names
        self.work = MAX_WORK
        self._scopes: dict[int, Scope] = {}
        self._exact: dict[int, Fraction] | None = None

    def spend(self, bits: int, times: int = 1) -> None:
        """Count operations on numbers of this many bits, and give up when there were too many."""
        self.work -= times * (8 + (bits * bits >> 20))
        if self.work < 0:
            raise Refused("the certificate takes too much work to check")

    def scope(self, bits: int, box: Box | None = None) -> Scope:
        """The enclosures at ``bits`` bits, for all values of the variables in their intervals."""
        if bits not in self._scopes:
            base = self._scopes[bits] = Scope(self, bits, {})
            for symbol, term in self.definitions.items():
                try:
                    base.known[symbol] = base.enclose(term)
                except Refused as why:
                    base.failures[symbol] = str(why)
        if not box:
            return self._scopes[bits]
        known = {
            s: self._scopes[bits].known[s]
            for s in self.definitions
            if s in self._scopes[bits].known
        }
        for symbol, ends in box.items():
            if None not in ends:
                low, high = (
                    from_ratio(bits, *end.as_integer_ratio()) for end in ends if end is not None
                )
                known[symbol] = hull(bits, low, high)
        return Scope(self, bits, known)
