"""Check that a certificate proves a statement. This file is all that has to be trusted.

    python3 -I verify/check.py FOLDER                     (statement.json and certificate.json)
    python3 -I verify/check.py STATEMENT CERTIFICATE

What is believed: Python's integers, ``fractions``, ``json`` and ``hashlib``, and these lines. The
statement says what is claimed, the certificate how each obligation is proved; no word of the
certificate is believed, and its enclosures are only compared with those computed here. The
docstring of ``verify/wire.py`` describes both files.

An obligation without variables claims that its two sides are defined as real numbers and stand in
the relation; one with variables claims that for all values in their open intervals, and its
negation claims one point there where both sides are defined and the relation fails. Every rule
below establishes this or raises `Refused`; what is not in the format raises `Malformed`. Nothing
is searched for, there is no floating point, and sizes are bounded, so that checking ends.

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

#: The operations and how many terms they take (min, max: two or more; pow: an exponent as well).
ARITY = {"add": 2, "sub": 2, "mul": 2, "div": 2, "neg": 1, "sqrt": 1, "cos": 1, "cos_pi": 1}
#: What the failure of a relation says about the two sides, swapped.
OPPOSITE = {"<": "<=", "<=": "<", "=": "!="}
FORMATS = ("verify-statement/1", "verify-certificate/1")
NAME = "[A-Za-z][A-Za-z0-9_.-]{0,99}"
RATIONAL = "-?[0-9]{1,4300}(/0*[1-9][0-9]{0,4290})?"  # int() reads at most 4300 digits
DECIMAL = r"-?[0-9]{1,400}(\.[0-9]{1,400})?(e-?[0-9]{1,5})?"
MAX_BYTES, MAX_NESTING = 1 << 22, 100  # of a file
MAX_HEIGHT = 200  # of a term, with the definitions of its symbols
MAX_BITS, MAX_SIZE = 1 << 16, 1 << 18  # of precision; of a numerator with its denominator
MAX_TERMS, MAX_DEGREE = 4000, 256  # of a product of polynomials; of a power of one atom
MAX_WORK = 10_000_000  # about the number of microseconds

Interval = tuple[Fraction, Fraction]
Box = dict[int, tuple[Fraction | None, Fraction | None]]  # variable to ends, None if unbounded
Polynomial = dict[tuple[tuple[int, int], ...], Fraction]  # sorted (atom, power) to coefficient
ZERO, ONE = Fraction(0), Fraction(1)


class Malformed(Exception):  # noqa: N818
    """A file is not in the format, or the two files do not belong together."""


class Refused(Exception):  # noqa: N818
    """The evidence does not prove the obligation."""


# --- Intervals: a result encloses the results for all real numbers in the arguments -------------


def size(x: Fraction) -> int:
    """The bits of numerator and denominator."""
    return x.numerator.bit_length() + x.denominator.bit_length()


def down(bits: int, x: Fraction) -> Fraction:
    """A number of about ``bits`` bits not above x; x itself if it is short, or if ``bits`` is 0."""
    n, d = x.numerator, x.denominator
    if size(x) > MAX_SIZE:
        raise Refused(f"a number of more than {MAX_SIZE} bits")
    if size(x) <= 2 * bits or bits == 0:
        return x
    shift = bits - n.bit_length() + d.bit_length()
    left, right = max(shift, 0), max(-shift, 0)
    return Fraction((n << left) // (d << right) << right, 1 << left)


def outward(bits: int, x: Interval) -> Interval:
    """An interval around x with short ends."""
    return down(bits, x[0]), -down(bits, -x[1])


def mul(_: int, x: Interval, y: Interval) -> Interval:
    """A product is linear in each factor, so that its extremes are products of ends."""
    (a, b), (c, d) = x, y
    ends = (a * c, b * d) if a >= 0 and c >= 0 else (a * c, a * d, b * c, b * d)
    return min(ends), max(ends)


def div(bits: int, x: Interval, y: Interval) -> Interval:
    """On an interval without 0 the inverse falls."""
    if y[0] <= 0 <= y[1]:
        raise Refused(f"a division by {shown(y)}, which contains 0")
    low, high = (Fraction(end.denominator, end.numerator) for end in y)
    return mul(bits, x, (high, low))


def power(bits: int, x: Interval, n: int) -> Interval:
    """x^n for n >= 1: x^(m+1) is x * x^m, and x^(2m) is the square of |x^m|."""
    if n == 1 or n % 2:
        return x if n == 1 else mul(bits, x, power(bits, x, n - 1))
    low, high = outward(bits, power(bits, x, n // 2))
    root = (low, high) if low >= 0 else (max(ZERO, -high), max(-low, high))
    return mul(bits, root, root)


def sqrt(bits: int, x: Interval) -> Interval:
    """The root of n/d is that of 4^bits nd, which lies between integers, over 2^bits d."""
    ends = []
    for n, d in (end.as_integer_ratio() for end in x):
        if n < 0:
            raise Refused(f"a square root of {shown(x)}, which reaches below 0")
        square = n * d << 2 * bits
        root = isqrt(square)
        if root * root < square and bits == 0:
            raise Refused("a square root that is not rational")
        ends += [Fraction(root, d << bits), Fraction(root + (root * root < square), d << bits)]
    return ends[0], ends[3]


def pi(bits: int) -> Interval:
    """Machin: pi = 16 arctan(1/5) - 4 arctan(1/239).

    arctan(1/n) is the sum of (-1)^k / ((2k+1) n^(2k+1)), alternating and decreasing. ``scaled`` is
    the floor of 2^bits / n^(2k+1), as nested floors are one floor, so that each term, and the rest
    of the sum once ``scaled`` is 0, are off by less than 2^-bits.
    """
    total = error = 0
    for factor, n in ((16, 5), (-4, 239)):
        scaled, k = (1 << bits) // n, 0
        while scaled:
            total += factor * (-1 if k % 2 else 1) * (scaled // (2 * k + 1))
            scaled, k = scaled // (n * n), k + 1
        error += abs(factor) * (k + 1)
    return Fraction(total - error, 1 << bits), Fraction(total + error, 1 << bits)


def cos(bits: int, x: Interval) -> Interval:
    """The cosine of |x| <= 64, cut to [-1, 1].

    The sum over k < m of (-1)^k x^(2k)/(2k)! is off by at most x^(2m)/(2m)! (Taylor's theorem: the
    derivatives of cos are bounded by 1). The loop ends with that sum in ``total`` and with
    x^(2m)/(2m)!, which is then at most 2^-bits, in ``term``. No term exceeds e^64 < 2^93.
    """
    if bits == 0 or max(-x[0], x[1]) > 64:
        raise Refused(f"a cosine of {shown(x)}, which is not rational, or reaches beyond 64")
    square, term, total, n = power(bits, x, 2), (ONE, ONE), (ZERO, ZERO), 0
    while term[1] * (1 << bits) > 1:
        low, high = (-term[1], -term[0]) if n % 4 else term
        total = outward(bits + 128, (total[0] + low, total[1] + high))
        n += 2
        low, high = mul(bits, term, square)
        term = outward(bits + 128, (low * Fraction(1, n * n - n), high * Fraction(1, n * n - n)))
    return max(total[0] - term[1], -ONE), min(total[1] + term[1], ONE)


def cos_pi(bits: int, x: Interval) -> Interval:
    """cos(pi x) = cos(pi (x - 2k)), here with k = floor(low end / 2)."""
    turns = x[0].numerator // (2 * x[0].denominator) * 2
    return cos(bits, mul(bits, (x[0] - turns, x[1] - turns), pi(bits + 32)))


#: The operations at a precision; at 0 bits they are exact on single numbers, or refused.
INTERVALS: dict[str, Callable[..., Interval]] = {
    "rational": lambda _, p, q: (Fraction(p, q), Fraction(p, q)),
    "add": lambda _, x, y: (x[0] + y[0], x[1] + y[1]),
    "sub": lambda _, x, y: (x[0] - y[1], x[1] - y[0]),
    "neg": lambda _, x: (-x[1], -x[0]),
    "min": lambda _, *xs: (min(x[0] for x in xs), min(x[1] for x in xs)),
    "max": lambda _, *xs: (max(x[0] for x in xs), max(x[1] for x in xs)),
    "mul": mul, "div": div, "pow": power, "sqrt": sqrt, "cos": cos, "cos_pi": cos_pi,
}  # fmt: skip


def decide(relation: str, x: Interval, y: Interval) -> None:
    """Afterwards the relation holds between any number in x and any number in y."""
    (a, b), (c, d) = x, y
    if not {"<": b < c, "<=": b <= c, "=": b <= c and d <= a, "!=": b < c or d < a}[relation]:
        raise Refused(f"found lhs in {shown(x)}, rhs in {shown(y)}; expected lhs {relation} rhs")


# --- Terms ---------------------------------------------------------------------------------------


class Checker:
    """The terms and definitions of a statement, and the work that may still be done.

    Each distinct subterm is stored once; a term is its index in ``nodes``, above those of its
    subterms. A ``rational`` has numerator and denominator, a ``pow`` its exponent, a ``symbol`` a
    number of its own and, unless it is a variable, its definition as a subterm.
    """

    def __init__(self) -> None:
        self.nodes: list[tuple[str, tuple[int, ...], tuple[int, ...]]] = []
        self.heights: list[int] = []
        self.index: dict[tuple[str, tuple[int, ...], tuple[int, ...]], int] = {}
        self.leaves: dict[str, int] = {}  # the names in scope, and the rationals read so far
        self.scopes: dict[int, Scope] = {}
        self.work = MAX_WORK

    def spend(self, bits: int, times: int = 1) -> None:
        """Count operations with so many bits; give up when they are too many."""
        self.work -= times * (8 + (bits * bits >> 20))
        if self.work < 0:
            raise Refused("this takes too much work to check")

    def node(self, op: str, subterms: Sequence[int], *rest: int) -> int:
        """The term of an operation and its arguments."""
        node = op, tuple(subterms), rest
        if node not in self.index:
            self.heights.append(1 + max((self.heights[term] for term in subterms), default=0))
            if self.heights[-1] > MAX_HEIGHT:
                raise Refused(f"a term of more than {MAX_HEIGHT} levels")
            self.index[node] = len(self.nodes)
            self.nodes.append(node)
        return self.index[node]

    def define(self, name: object, *definition: int) -> int:
        """A new name in scope: a variable, or a constant with its definition."""
        key = text(name, NAME)
        if key in self.leaves:
            raise wrong(name, "a name that is not in use")
        self.leaves[key] = self.node("symbol", definition, len(self.nodes))
        return self.leaves[key]

    def read(self, value: object) -> int:
        """The term that is written over the names in scope."""
        if isinstance(value, str):
            if value not in self.leaves:
                number = Fraction(text(value, RATIONAL, "a rational or a name in scope"))
                self.leaves[value] = self.node("rational", (), *number.as_integer_ratio())
            return self.leaves[value]
        op, *args = array(value) or [None]
        rest = [int(text(args.pop(), "[1-9][0-9]{0,2}"))] if op == "pow" and len(args) == 2 else []
        arity = {"min": max(2, len(args)), "max": max(2, len(args)), "pow": len(rest)} | ARITY
        if not isinstance(op, str) or len(args) != arity.get(op):
            raise wrong(op, f"an operation that has {len(args)} arguments")
        return self.node(op, [self.read(arg) for arg in args], *rest)

    def substitute(self, term: int, done: dict[int, int]) -> int:
        """The term after replacing what ``done`` replaces; ``done`` learns the subterms."""
        op, subterms, rest = self.nodes[term]
        if term not in done and op != "symbol":
            done[term] = self.node(op, [self.substitute(arg, done) for arg in subterms], *rest)
        return done.get(term, term)

    def squared(self, term: int) -> int:
        """A term for the square of a term, where that is defined."""
        op, subterms, _ = self.nodes[term]
        if op in ("mul", "div"):
            return self.node(op, [self.squared(arg) for arg in subterms])
        return subterms[0] if op == "sqrt" else self.node("pow", [term], 2)

    def scope(self, bits: int, box: Box) -> Scope:
        """The enclosures at a precision for all values of the variables in a box."""
        if bits not in self.scopes:
            self.scopes[bits] = Scope(self, bits, {})
        known = {x: (a, b) for x, (a, b) in box.items() if a is not None and b is not None}
        return Scope(self, bits, known) if known else self.scopes[bits]


class Scope:
    """Enclosures at one precision, each computed once, for given enclosures of some symbols."""

    def __init__(self, checker: Checker, bits: int, known: dict[int, Interval]) -> None:
        self.checker, self.bits, self.known = checker, bits, known

    def enclose(self, term: int) -> Interval:
        """An interval around the value of a term; refused where it may be undefined."""
        if term not in self.known:
            op, subterms, rest = self.checker.nodes[term]
            if op == "symbol" and not subterms:
                raise Refused("a variable without bounds")
            if op == "symbol":
                self.known[term] = self.checker.scope(self.bits, {}).enclose(subterms[0])
            else:
                value = INTERVALS[op](self.bits, *map(self.enclose, subterms), *rest)
                self.known[term] = value = outward(self.bits, value)
                self.checker.spend(size(value[1]))
        return self.known[term]

    def sign(self, term: int) -> int:
        """1 if a term is nowhere negative, -1 if it is nowhere positive, 0 if that is unknown."""
        low, high = self.enclose(term)
        return 1 if low >= 0 else -1 if high <= 0 else 0

    def moves(self, symbol: int, term: int, seen: dict[int, set[int]]) -> set[int]:
        """How a term moves when the symbol rises within its interval, all else being fixed.

        1 in the result: perhaps up; -1: perhaps down; 0: unknown; nothing: it does not move. A
        product moves with each factor times the sign of the other one, as a(t)b(t) - a(s)b(s) =
        (a(t) - a(s)) b(t) + a(s) (b(t) - b(s)); 1/b moves against b, which does not vanish.
        """
        if term not in seen:
            op, subterms, rest = self.checker.nodes[term]
            signs = {"sub": [1, -1], "neg": [-1], "cos": [0], "cos_pi": [0]}.get(op)
            if op in ("mul", "div"):
                a, b = map(self.sign, subterms)
                signs = [b, a if op == "mul" else -a]
            elif op == "pow" and rest[0] % 2 == 0:
                signs = [self.sign(subterms[0])]
            pairs = [] if op == "symbol" else zip(subterms, signs or [1] * len(subterms))
            moves = {s * m for arg, s in pairs for m in self.moves(symbol, arg, seen)}
            seen[term] = {1} if term == symbol else moves
        return seen[term]


class Expansion:
    """Terms as polynomials of atoms, equal to them in value; refused where they may be undefined.

    An atom is 2t for a term t that is a symbol, root, minimum, maximum or cosine, and 2t+1 for the
    inverse of a term t. ``relations`` has the polynomial of the square of a root, and that of the
    inverse of an inverse; their atoms are smaller.
    """

    def __init__(self, scope: Scope, variables: Box) -> None:
        self.scope, self.variables = scope, variables
        self.known: dict[int, Polynomial] = {}
        self.relations: dict[int, Polynomial] = {}

    def expand(self, term: int) -> Polynomial:
        """The polynomial of a term."""
        if term in self.known:
            return self.known[term]
        op, subterms, rest = self.scope.checker.nodes[term]
        a, *others = [self.expand(arg) for arg in subterms if op != "symbol"] or [{}]
        if op == "rational":
            result = {(): Fraction(*rest)} if rest[0] else {}
        elif op in ("add", "sub"):
            result = plus(a, others[0], ONE if op == "add" else -ONE)
        elif op == "neg":
            result = plus({}, a, -ONE)
        elif op in ("mul", "pow"):
            result = a
            for factor in others or [a] * (rest[0] - 1):
                result = self.times(result, factor)
        else:
            atom = 2 * term
            if op == "div":
                self.relations[2 * subterms[1] + 1] = others[0]
                div(...)
                result = self.times(a, {((2 * subterms[1] + 1, 1),): ONE})
            else:
                if op == "sqrt" : self.relations[2*term] = a
                if op == "sqrt" or op == symbol and not in variables: self.scope.enclose(term)
                result = {((2 * term, 1),): ONE}
        self.known[term] = result
        return result

    def times(self, a: Polynomial, b: Polynomial) -> Polynomial:
        """The product."""
        bits = max((size(c) for p in (a, b) for c in p.values()), default=0)
        self.scope.checker.spend(bits, len(a) * len(b))
        if len(a) * len(b) > MAX_TERMS:
            raise Refused(f"a product of polynomials of {len(a)} and {len(b)} terms")
        total: Polynomial = {}
        for m, c in a.items():
            for n, d in b.items():
                powers = dict(m)
                for atom, k in n:
                    powers[atom] = powers.get(atom, 0) + k
                    if powers[atom] > MAX_DEGREE: raise Refused
                total = ...
        return total

    def reduced(self, p: Polynomial) -> Polynomial:
        """A multiple of p by non-zero values, without squares of roots and without inverses."""
        for atom in sorted(self.relations, reverse=True):
            base, total = self.relations[atom], {}
            top = max((dict(monomial).get(atom, 0) for monomial in p), default=0)
            for monomial, coefficient in p.items():
                powers = dict(monomial)
                k = powers.pop(atom, 0)
                if atom % 2 == 0 and k % 2: powers[atom] = 1
                part = {tuple(sorted(powers.items())): coefficient}
                for _ in range(top - k if atom % 2 else k // 2):
                    part = self.times(part, base)
                total = plus(total, part, ONE)
            p = total
        return p


def plus(a: Polynomial, b: Polynomial, factor: Fraction) -> Polynomial:
    """a + factor * b."""
    total = dict(a)
    for monomial, coefficient in b.items():
        value = total.pop(monomial, ZERO) + factor * coefficient
        if value: total[monomial] = value
    return total
