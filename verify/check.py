"""Check that a certificate proves a statement. This file is all that has to be trusted.

    python3 -I verify/check.py FOLDER                     (statement.json and certificate.json)
    python3 -I verify/check.py STATEMENT CERTIFICATE

Believed are Python's integers, ``fractions``, ``json``, ``re``, ``hashlib``, and these lines; not
the certificate. ``verify/wire.py`` describes both files. An obligation without variables claims
that its two sides are defined as real numbers and stand in the relation; one with variables claims
that for all values in their open intervals, and its negation claims one point there where both
sides are defined and the relation fails. Every rule establishes this or raises `Refused`; what is
not in the format raises `Malformed`. Nothing is searched for, there is no floating point, and
sizes are bounded, so that checking ends.

Exit codes: 0 all is proved and no needed row is a negation; 1 something is not proved; 2 unusable
command line; 4 a file is malformed, or the two do not belong together.
"""

from __future__ import annotations

import gc
import json
import os
import re
import sys
from collections import namedtuple
from collections.abc import Callable, Sequence
from fractions import Fraction
from functools import cache
from hashlib import sha256
from itertools import pairwise, product, zip_longest
from math import isqrt

TYPE_CHECKING = False  # a type checker takes it for True
if TYPE_CHECKING:
    from typing import Any

MAX_BYTES, MAX_NESTING = 1 << 24, 100  # of a file
MAX_HEIGHT = 200  # of a term, with the definitions of its symbols
MAX_BITS, MAX_SIZE = 1 << 16, 1 << 18  # of precision; of a numerator with its denominator
MAX_WORK = 10_000_000  # about the number of microseconds

# The signature. A shape is a pattern for a text, a range for an integer, a dict for an object with
# just these keys (ANY: with any keys), a list for a list of any length, a tuple for one of this
# length, a set for null or what is in the set, None for a value that is looked at later.
ANY, TEXT, NAME = "any", "(?s).*", "[A-Za-z][A-Za-z0-9_.-]{0,99}"
RATIONAL = "-?(0|[1-9][0-9]{0,4299})(/[1-9][0-9]{0,4299})?"  # int() reads at most 4300 digits
DECIMAL = r"-?(0|[1-9][0-9]{0,99})(\.[0-9]{1,99})?(e-?[0-9]{1,5})?"
PAIR = (DECIMAL, DECIMAL)
ROW: dict[str, Any] = {"name": NAME, "label": TEXT, "role": "needed|printed", "says": TEXT}
ROW |= {"claim": None, "uses": [NAME], "variables": {ANY: ({RATIONAL}, {RATIONAL})}}
STATEMENT: dict[str, Any] = {"format": "verify-statement/1", "theorem": TEXT, "title": TEXT}
STATEMENT |= {"parameters": {ANY: None}, "obligations": [ROW]}
STATEMENT |= {"constants": [{"name": NAME, "label": TEXT, "tex": TEXT, "term": None}]}
STATEMENT |= {"assumptions": [{"name": NAME, "label": TEXT, "sentence": TEXT}]}
CERTIFICATE: dict[str, Any] = {"format": "verify-certificate/1", "statement_sha256": "[0-9a-f]{64}"}
CERTIFICATE |= {"enclosures": {ANY: PAIR}, "proofs": [None]}
PROOF: dict[str, Any] = {"rule": NAME, "bits": range(2, MAX_BITS + 1)}

#: How many terms an operation has (0: two or more); pow has an exponent besides.
ARITY = {"add": 2, "sub": 2, "mul": 2, "div": 2, "neg": 1, "sqrt": 1, "cos": 1, "cos_pi": 1}
ARITY |= {"min": 0, "max": 0}
OPPOSITE = {"<": "<=", "<=": "<", "=": "!="}  # what a failure says about the two sides swapped
HOLDS: dict[str, Callable[[Interval, Interval], bool]] = {  # between all numbers of intervals
    "<": lambda x, y: x[1] < y[0],
    "<=": lambda x, y: x[1] <= y[0],
    "=": lambda x, y: x[1] <= y[0] and y[1] <= x[0],
    "!=": lambda x, y: x[1] < y[0] or y[1] < x[0],
}
Interval = tuple[Fraction, Fraction]
Polynomial = dict[tuple[int, ...], Fraction | int]  # sorted atoms, repeated, to coefficient
ONE = (Fraction(1), Fraction(1))
#: lhs relation rhs for all values (or for some) of the symbols in the box, between the two ends
#: which it gives them, or None.
Goal = namedtuple("Goal", "relation lhs rhs box some")
rational = cache(Fraction)  # the value of a text


class Malformed(Exception):  # noqa: N818
    """A file is not in the format, or the two files do not belong together."""


class Refused(Exception):  # noqa: N818
    """The evidence does not prove the obligation."""


def need(condition: object, kind: type[Exception], message: str, *values: Any) -> None:
    """Afterwards the condition holds. The values are put into the message about its failure."""
    if not condition:
        raise kind(message.format(*map(shown, values)))


def shown(value: Any) -> str:
    """An interval in decimals, a text as it is, and another value as Python writes it; cut."""
    if isinstance(value, tuple) and isinstance(value[0], Fraction):
        bits = max(end.numerator.bit_length() - end.denominator.bit_length() for end in value)
        k = 20 - bits * 3 // 10
        low, high = (end * Fraction(10) ** k for end in value)
        return f"[{low // 1}e{-k}, {-(-high // 1)}e{-k}]"
    text = value if isinstance(value, str) and value.isprintable() else ascii(value)
    return text if len(text) < 200 else f"{text[:160]}... ({len(text)} characters)"


class Scope:
    """Intervals around terms at one precision, for given ones of some symbols; and polynomials.

    The result of an operation on intervals encloses its results for all real numbers in them. A
    polynomial has the value of its term. An atom is 2t for a term t that is a symbol, root,
    minimum, maximum or cosine, and 2t+1 for the inverse of a term t. ``relations`` has the
    polynomials of squares of roots and of inverses of inverses, in smaller atoms.
    """

    def __init__(self, terms: Terms, bits: int, known: dict[int, Interval]) -> None:
        self.terms, self.bits, self.known = terms, bits, known
        self.polynomials: dict[int, Polynomial] = {}
        self.relations: dict[int, Polynomial] = {}

    def enclose(self, term: int) -> Interval:
        """An interval around the value of a term; refused where it may be undefined."""
        if term not in self.known:
            op, subterms, rest = self.terms.nodes[term]
            need(op != "symbol" or subterms, Refused, "found a variable without bounds")
            if op == "symbol":
                x = self.terms.scope(self.bits, {}).enclose(subterms[0])
            else:
                x = OPERATIONS[op](self, *map(self.enclose, subterms), *rest)
            self.known[term] = self.outward(x)
        return self.known[term]

    def sign(self, term: int) -> int:
        """1 if a term is nowhere negative, -1 if it is nowhere positive, 0 if that is unknown."""
        low, high = self.enclose(term)
        return 1 if low >= 0 else -1 if high <= 0 else 0

    def moves(self, symbol: int, term: int, seen: dict[int, set[int]]) -> set[int]:
        """How a term may move as the symbol rises in its interval: 1 up, -1 down, 0 unknown.

        A product moves with each factor times the sign of the other one, as a(t)b(t) - a(s)b(s) =
        (a(t) - a(s)) b(t) + a(s) (b(t) - b(s)); 1/b moves against b, which does not vanish.
        """
        if term not in seen:
            op, subterms, rest = self.terms.nodes[term]
            signs = {"sub": [1, -1], "neg": [-1], "cos": [0], "cos_pi": [0], "symbol": []}.get(op)
            if op in ("mul", "div"):
                a, b = map(self.sign, subterms)
                signs = [b, a if op == "mul" else -a]
            elif op == "pow" and rest[0] % 2 == 0:
                signs = [self.sign(subterms[0])]
            pairs = zip(subterms, [1] * len(subterms) if signs is None else signs, strict=False)
            moves = {s * m for arg, s in pairs for m in self.moves(symbol, arg, seen)}
            seen[term] = {1} if term == symbol else moves
        return seen[term]

    def outward(self, x: Interval, more: int = 0) -> Interval:
        """x, or an interval around it with shorter ends."""
        bits, ends = self.bits + more, []
        for sign, end in ((1, x[0]), (-1, x[1])):
            n, d = sign * end.numerator, end.denominator
            size = n.bit_length() + d.bit_length()
            self.terms.spend(size)
            if size > 2 * bits:
                shift = bits - n.bit_length() + d.bit_length()
                up, back = max(shift, 0), max(-shift, 0)
                end = Fraction(sign * ((n << up) // (d << back) << back), 1 << up)
            ends.append(end)
        return ends[0], ends[1]

    def mul(self, x: Interval, y: Interval) -> Interval:
        """A product is linear in each factor, so that its extremes are products of ends."""
        (a, b), (c, d) = x, y
        ends = (a * c, b * d) if a.numerator >= 0 <= c.numerator else (a * c, a * d, b * c, b * d)
        return min(ends), max(ends)

    def div(self, x: Interval, y: Interval) -> Interval:
        """On an interval without 0 the inverse falls."""
        need(y[0] > 0 or y[1] < 0, Refused, "found a division by {}, which contains 0", y)
        low, high = (Fraction(end.denominator, end.numerator) for end in y)
        return self.mul(x, (high, low))

    def power(self, x: Interval, n: int) -> Interval:
        """x^n for n >= 1: x^(m+1) is x * x^m, and x^(2m) is the square of |x^m|."""
        if n == 1 or n % 2:
            return x if n == 1 else self.mul(x, self.power(x, n - 1))
        low, high = self.outward(self.power(x, n // 2))
        root = (low, high) if low >= 0 else (max(0 * low, -high), max(-low, high))
        return self.mul(root, root)

    def sqrt(self, x: Interval) -> Interval:
        """The root of n/d is that of 4^bits nd, which lies between integers, over 2^bits d."""
        need(x[0] >= 0, Refused, "found a square root of {}, which reaches below 0", x)
        ends = []
        for n, d in map(Fraction.as_integer_ratio, x):
            square = n * d << 2 * self.bits
            root = isqrt(square)
            ends += [Fraction(root + i, d << self.bits) for i in (0, root * root < square)]
        return ends[0], ends[3]

    def cos(self, x: Interval) -> Interval:
        """The cosine of |x| <= 8, cut to [-1, 1].

        The sum over k <= m of (-1)^k x^(2k)/(2k)!, here 1 - x^2/2 (1 - x^2/12 (1 - ...)), is off by
        at most 8^n/n! < (8e/n)^n < 2^-n for n = 2m + 2 >= 44 (Taylor's theorem: the derivatives of
        cos are bounded by 1).
        """
        need(max(-x[0], x[1]) <= 8, Refused, "found a cosine of {}, which reaches beyond 8", x)
        square, total, error = self.power(x, 2), ONE, Fraction(1, 1 << self.bits)
        for k in range(self.bits // 2 + 21, 0, -1):
            low, high = (end * Fraction(1, 2 * k * (2 * k - 1)) for end in self.mul(square, total))
            total = self.outward((1 - high, 1 - low), 32)
        return max(total[0] - error, -ONE[0]), min(total[1] + error, ONE[0])

    def cos_pi(self, x: Interval) -> Interval:
        """cos(pi x) = cos(pi (x - 2k)), with k = floor(low end / 2), and Machin's formula for pi.

        pi is 16 arctan(1/5) - 4 arctan(1/239), and arctan(1/n) is the alternating, decreasing sum
        of (-1)^k / ((2k+1) n^(2k+1)). ``scaled`` is floor(2^bits / n^(2k+1)), as nested floors are
        one floor, so that each term, and the rest of the sum, is off by less than 2^-bits.
        """
        bits, total, error = self.bits + 32, 0, 0
        for factor, n in ((16, 5), (-4, 239)):
            scaled, k = (1 << bits) // n, 0
            while scaled:
                total += factor * (-1 if k % 2 else 1) * (scaled // (2 * k + 1))
                scaled, k = scaled // (n * n), k + 1
            error += abs(factor) * (k + 1)
        pi = Fraction(total - error, 1 << bits), Fraction(total + error, 1 << bits)
        turns = x[0] // 2 * 2
        return self.cos(self.mul((x[0] - turns, x[1] - turns), pi))

    def expand(self, term: int) -> Polynomial:
        """The polynomial of a term; refused where the term may be undefined."""
        if term not in self.polynomials:
            op, subterms, rest = self.terms.nodes[term]
            parts = [self.expand(arg) for arg in subterms if op != "symbol"]
            p: Polynomial = {(2 * term,): 1}
            if op == "rational":
                p = plus({}, {(): Fraction(*rest) if rest[1] > 1 else rest[0]}, 1)
            elif op in ("add", "sub", "neg"):
                p = plus(parts[0] if parts[1:] else {}, parts[-1], 1 if op == "add" else -1)
            elif op in ("mul", "pow"):
                p = parts[0]
                for factor in parts[1:] or parts * (rest[0] - 1):
                    p = self.times(p, factor)
            elif op == "div":
                self.div(ONE, self.enclose(subterms[1]))
                self.relations[2 * subterms[1] + 1] = parts[1]
                p = self.times(parts[0], {(2 * subterms[1] + 1,): 1})
            elif subterms:
                self.enclose(term)
                self.relations |= {2 * term: parts[0]} if op == "sqrt" else {}
            self.polynomials[term] = p
        return self.polynomials[term]

    def times(self, a: Polynomial, b: Polynomial) -> Polynomial:
        """The product."""
        total: Polynomial = {}
        for (m, c), (n, d) in product(a.items(), b.items()):
            self.terms.spend(c.numerator.bit_length() + d.numerator.bit_length(), 9 + len(m + n))
            monomial = tuple(sorted(m + n))
            total[monomial] = total.get(monomial, 0) + c * d
        return plus({}, total, 1)

    def vanishes(self, p: Polynomial) -> bool:
        """Whether p is 0 once squares of roots are replaced and inverses are multiplied away."""
        known = self.relations
        while atoms := {a for m in p for a in m if a in known and (a % 2 or m.count(a) > 1)}:
            atom = max(atoms)
            total: Polynomial = {}
            top = max(monomial.count(atom) for monomial in p)
            for monomial, coefficient in p.items():
                k = monomial.count(atom)
                times, left = (top - k, 0) if atom % 2 else divmod(k, 2)
                rest = [a for a in monomial if a != atom] + [atom] * left
                part: Polynomial = {tuple(sorted(rest)): coefficient}
                for _ in range(times):
                    part = self.times(part, known[atom])
                for m, c in part.items():
                    total[m] = total.get(m, 0) + c
            p = plus({}, total, 1)
        return not p


def plus(a: Polynomial, b: Polynomial, factor: int) -> Polynomial:
    """The sum of a and of b times an integer."""
    total = dict(a)
    for monomial, coefficient in b.items():
        total[monomial] = total.get(monomial, 0) + factor * coefficient
    return {monomial: coefficient for monomial, coefficient in total.items() if coefficient}


OPERATIONS: dict[str, Callable[..., Interval]] = {
    "rational": lambda _, p, q: (Fraction(p, q), Fraction(p, q)),
    "add": lambda _, x, y: (x[0] + y[0], x[1] + y[1]),
    "sub": lambda _, x, y: (x[0] - y[1], x[1] - y[0]),
    "neg": lambda _, x: (-x[1], -x[0]),
    "min": lambda _, *xs: (min(x[0] for x in xs), min(x[1] for x in xs)),
    "max": lambda _, *xs: (max(x[0] for x in xs), max(x[1] for x in xs)),
    "mul": Scope.mul, "div": Scope.div, "pow": Scope.power, "sqrt": Scope.sqrt,
    "cos": Scope.cos, "cos_pi": Scope.cos_pi,
}  # fmt: skip


class Terms:
    """The terms of a statement, the work that may still be done, and the rules.

    Each distinct subterm is stored once; a term is its index in ``nodes``, above those of its
    subterms. A ``rational`` has numerator and denominator, a ``pow`` its exponent, a ``symbol`` a
    number of its own and, unless it is a variable, its definition as a subterm. Rules are methods
    that return only if their goal is proved.
    """

    def __init__(self) -> None:
        self.nodes: list[tuple[str, tuple[int, ...], tuple[int, ...]]] = []
        self.heights: list[int] = []
        self.index: dict[object, int] = {}
        self.leaves: dict[str, int] = {}  # the names in scope, and the rationals read so far
        self.scopes: dict[int, Scope] = {}
        self.work = MAX_WORK

    def spend(self, bits: int, times: int = 1) -> None:
        """Count operations with so many bits; give up when these, or they, are too many."""
        self.work -= times * (4 + (bits * bits >> 20))
        if self.work < 0 or bits > MAX_SIZE:
            raise Refused(f"found too much work, or a number of too many bits: {bits}")

    def node(self, op: str, subterms: Sequence[int], *rest: int) -> int:
        """The term of an operation and its arguments."""
        node = op, tuple(subterms), rest
        if node not in self.index:
            height = 1 + max((self.heights[term] for term in subterms), default=0)
            need(height <= MAX_HEIGHT, Malformed, "found a term of more than {} levels", MAX_HEIGHT)
            self.heights.append(height)
            self.index[node] = len(self.nodes)
            self.nodes.append(node)
        return self.index[node]

    def define(self, name: str, *definition: int) -> int:
        """A new name in scope: a variable, or a constant with its definition."""
        shaped("name", name, NAME)
        need(name not in self.leaves, Malformed, "found the name {}, which is in use", name)
        self.leaves[name] = self.node("symbol", definition, len(self.nodes))
        return self.leaves[name]

    def read(self, where: str, value: Any) -> int:
        """The term that is written over the names in scope."""
        if isinstance(value, str):
            if value not in self.leaves:
                shaped(where, value, RATIONAL)
                self.leaves[value] = self.node("rational", (), *rational(value).as_integer_ratio())
            return self.leaves[value]
        op, *args = value if isinstance(value, list) and value else [""]
        if op == "pow":
            shaped(where, args, (None, "[1-9][0-9]{0,2}"))
            return self.node(op, [self.read(where, args[0])], int(args[1]))
        arity = ARITY.get(op, -1) if isinstance(op, str) else -1
        good = len(args) == arity if arity else len(args) > 1
        need(good, Malformed, "{}: found {}, expected a term", where, value)
        return self.node(op, [self.read(where, arg) for arg in args])

    def substitute(self, goal: Goal, done: dict[int, int]) -> Goal:
        """The goal after replacing some symbols by terms."""

        def new(term: int) -> int:
            self.spend(0)
            op, subterms, rest = self.nodes[term]
            if term not in done and op != "symbol":
                done[term] = self.node(op, [new(arg) for arg in subterms], *rest)
            return done.get(term, term)

        return goal._replace(lhs=new(goal.lhs), rhs=new(goal.rhs))

    def scope(self, bits: int, box: dict[int, Any]) -> Scope:
        """The enclosures at a precision, for given intervals of symbols (None: unbounded)."""
        self.spend(0)
        if bits not in self.scopes:
            self.scopes[bits] = Scope(self, bits, {})
        known = {symbol: ends for symbol, ends in box.items() if None not in ends}
        return Scope(self, bits, known) if known else self.scopes[bits]

    def interval(self, goal: Goal, proof: dict[str, Any]) -> None:
        """The enclosures of the two sides, for all values of the variables, decide."""
        scope = self.scope(proof["bits"], goal.box)
        x, y = scope.enclose(goal.lhs), scope.enclose(goal.rhs)
        message = "found {} and {}, expected {} between them"
        need(HOLDS[goal.relation](x, y), Refused, message, x, y, goal.relation)

    def exact(self, goal: Goal, _: dict[str, Any]) -> None:
        """The same with so many bits that rational values are exact."""
        self.interval(goal, {"bits": MAX_BITS})

    def identity(self, goal: Goal, proof: dict[str, Any]) -> None:
        """The two sides are defined, and the same function of symbols and roots."""
        scope = self.scope(proof["bits"], goal.box)
        same = scope.vanishes(plus(scope.expand(goal.lhs), scope.expand(goal.rhs), -1))
        need(same, Refused, "found sides that differ, expected an identity")
        need(goal.relation in ("<=", "="), Refused, "found equal sides, not {}", goal.relation)

    def rewrite(self, goal: Goal, proof: dict[str, Any]) -> None:
        """Symbols are replaced; then the goal is proved by an interval or an identity.

        A symbol may be replaced by its definition. It may be replaced by an entry of the min that
        defines it if raising it, from its value up to the entry, cannot lower lhs or raise rhs:
        the goal at the entry implies the goal. For an entry of a max it is lowered instead.
        """
        for name, index in proof["steps"]:
            symbol = self.leaves.get(name, 0)
            op, definition, _ = self.nodes[symbol]
            need(op == "symbol" and definition, Malformed, "found {}, expected a constant", name)
            new = definition[0]
            if index is not None:
                op, entries, _ = self.nodes[new]
                good = op in ("min", "max") and index < len(entries) and "<" in goal.relation
                need(good, Refused, "found entry {} of {}, which has none such", index, name)
                new, up = entries[index], 1 if op == "min" else -1
                scope = self.scope(proof["bits"], goal.box)
                ends = *scope.enclose(symbol), *scope.enclose(new)
                scope = self.scope(proof["bits"], goal.box | {symbol: (min(ends), max(ends))})
                scope.enclose(goal.lhs), scope.enclose(goal.rhs)
                lhs, rhs = (scope.moves(symbol, side, {}) for side in (goal.lhs, goal.rhs))
                message = "found entry {} of {}, which may make the claim easier"
                need(lhs <= {up} and rhs <= {-up}, Refused, message, index, name)
            goal = self.substitute(goal, {symbol: new})
        (self.interval if proof["closing"] == "interval" else self.identity)(goal, proof)

    def bernstein(self, goal: Goal, proof: dict[str, Any]) -> None:
        """For one variable, rhs - lhs is a polynomial with no negative Bernstein coefficient.

        With x = (a + b s)/(1 + s), which runs through ]a, b[ for s > 0, the sum of the c_k x^k is
        that of the c_k (a + b s)^k (1 + s)^(n - k), whose coefficients these are, over (1 + s)^n:
        not negative if none of them is, and positive if there is one besides.
        """
        scope, n = self.scope(proof["bits"], goal.box), proof["degree"]
        good = len(goal.box) == len(scope.known) == 1 and "<" in goal.relation
        need(good, Refused, "found no inequality in one variable with a bounded interval")
        ((x, (a, b)),) = goal.box.items()
        total: Polynomial = {}
        p = plus(scope.expand(goal.rhs), scope.expand(goal.lhs), -1)
        for monomial, coefficient in p.items():
            part: Polynomial = {(): coefficient}
            need(monomial.count(2 * x) <= n, Refused, "found a degree above {}", n)
            for atom in monomial + (-2,) * (n - monomial.count(2 * x)):
                factor: Polynomial = {(): a, (x,): b} if atom == 2 * x else {(): 1, (x,): 1}
                if atom not in (-2, 2 * x):
                    low, high = scope.enclose(atom // 2)
                    need(low == high, Refused, "found a coefficient in {}", (low, high))
                    factor = {(): Fraction(low.denominator, low.numerator) if atom % 2 else low}
                part = scope.times(part, factor)
            total = plus(total, part, 1)
        least = Fraction(min(total.values(), default=0))
        positive = least >= 0 and (total or goal.relation == "<=")
        need(positive, Refused, "found {} as the least coefficient", (least, least))

    def cuts(self, goal: Goal, proof: dict[str, Any]) -> None:
        """Enclosures decide between neighbouring cuts, which lead from end to end of intervals."""
        sides = []
        symbols = {self.leaves.get(name, -1): cuts for name, cuts in proof["cuts"].items()}
        need(symbols.keys() == goal.box.keys(), Refused, "found cuts of {}", [*proof["cuts"]])
        for symbol, texts in symbols.items():
            points = [rational(cut) for cut in texts]
            pieces, ends = list(pairwise(points)), goal.box[symbol]
            good = pieces and (points[0], points[-1]) == ends and all(a < b for a, b in pieces)
            need(good, Refused, "found cuts {} that do not increase from end to end", texts)
            sides.append([(symbol, piece) for piece in pieces])
        for box in product(*sides):
            self.interval(goal._replace(box=dict(box)), proof)

    def witness(self, goal: Goal, proof: dict[str, Any]) -> None:
        """Enclosures decide at one point inside the intervals."""
        done = {}
        point = {self.leaves.get(name, -1): text for name, text in proof["point"].items()}
        need(point.keys() == goal.box.keys(), Refused, "found a point with {}", [*proof["point"]])
        for symbol, (low, high) in goal.box.items():
            value = rational(point[symbol])
            inside = (low is None or low < value) and (high is None or value < high)
            need(inside, Refused, "found {}, expected a value inside", (value, value))
            done[symbol] = self.node("rational", (), *value.as_integer_ratio())
        self.interval(self.substitute(goal, done)._replace(box={}), proof)

    def square(self, goal: Goal, proof: dict[str, Any]) -> None:
        """Both sides are not negative, and their squares stand in the same relation."""
        scope = self.scope(proof["bits"], goal.box)
        for x in (scope.enclose(goal.lhs), scope.enclose(goal.rhs)):
            need(x[0] >= 0, Refused, "found {}, expected a side that is not negative", x)
        lhs, rhs = (self.node("pow", [term], 2) for term in (goal.lhs, goal.rhs))
        self.prove(goal._replace(lhs=lhs, rhs=rhs), proof["then"], PROOF)

    def prove(self, goal: Goal, proof: Any, shape: dict[str, Any]) -> None:
        """Afterwards the goal is proved."""
        rule: Any = proof.get("rule") if isinstance(proof, dict) else proof
        good = isinstance(rule, str) and rule in RULES
        need(good, Malformed, "rule: found {}, expected one of {}", rule, [*RULES])
        shaped("proof", proof, shape | RULES[rule][1])
        good = goal.some == (rule == "witness")
        need(good, Refused, "found {}, expected witness for not-for-all, and only for that", rule)
        RULES[rule][0](self, goal, proof)


#: Each rule with the shapes of its fields.
RULES: dict[str, tuple[Callable[[Terms, Goal, dict[str, Any]], None], dict[str, Any]]] = {
    "interval": (Terms.interval, {}),
    "exact": (Terms.exact, {}),
    "rewrite": (Terms.rewrite, {"steps": [(NAME, {range(1000)})], "closing": "interval|identity"}),
    "bernstein": (Terms.bernstein, {"degree": range(257)}),
    "cuts": (Terms.cuts, {"cuts": {ANY: [RATIONAL]}}),
    "witness": (Terms.witness, {"point": {ANY: RATIONAL}}),
    "square": (Terms.square, {"then": None}),
}


def shaped(where: str, value: Any, shape: Any) -> None:
    """Afterwards a JSON value has a shape."""
    kind, good = type(shape), shape is None
    entries: dict[Any, Any] = {}
    if kind is str and isinstance(value, str):
        good = re.fullmatch(shape, value) is not None
    elif kind is dict and isinstance(value, dict):
        entries = dict.fromkeys(value, shape[ANY]) if ANY in shape else shape
        good = value.keys() == entries.keys()
    elif kind in (list, tuple) and isinstance(value, list):
        entries = dict(enumerate(shape if kind is tuple else shape * len(value)))
        good = len(entries) == len(value)
    elif kind is range:
        good = type(value) is int and value in shape
    elif kind is set and value is not None:
        return shaped(where, value, *shape)
    found = [*value] if isinstance(value, dict) else value
    need(good or kind is set, Malformed, "{}: found {}, expected {}", where, found, shape)
    for key, inner in entries.items():
        item = value[key]
        if not (isinstance(inner, str) and isinstance(item, str) and re.fullmatch(inner, item)):
            shaped(f"{where}: {key}", item, inner)
    return None


def parse(where: str, data: bytes, shape: dict[str, Any]) -> Any:
    """The document in a JSON file, where natural numbers below 10^9 are the only numbers."""

    def unique(pairs: list[tuple[str, Any]]) -> dict[str, Any]:
        need(len(dict(pairs)) == len(pairs), Malformed, "{}: found a key twice: {}", where, pairs)
        return dict(pairs)

    def number(text: str) -> int:
        good = re.fullmatch("0|[1-9][0-9]{0,8}", text)
        need(good, Malformed, "{}: found {}, expected numbers as texts", where, text)
        return int(text)

    need(len(data) <= MAX_BYTES, Malformed, "{}: found more than {} bytes", where, MAX_BYTES)
    table, others = bytes.maketrans(b"{}", b"[]"), bytes(set(range(256)) - set(b'[]{}"'))
    flat = re.sub(rb"\\.", b"", data, flags=re.DOTALL).translate(table, others)
    flat = re.sub(rb'"[^"]*"', b"", flat.replace(b'""', b""))
    for _ in range(MAX_NESTING):
        flat = flat.replace(b"[]", b"")
    message = "{}: found brackets without partner, or more than {} inside each other"
    need(not flat, Malformed, message, where, MAX_NESTING)
    hooks: Any = {"parse_int": number, "parse_float": number, "parse_constant": number}
    try:
        value = json.loads(data.decode(), object_pairs_hook=unique, **hooks)
    except ValueError as error:
        raise Malformed(f"{where}: {error}") from error
    shaped(where, value, shape)
    return value


def claimed(terms: Terms, row: dict[str, Any]) -> tuple[Goal, dict[str, int], str]:
    """What an obligation claims: a goal, the sides that have enclosures, and the claim in words."""
    claim, negated, box = row["claim"], False, {}
    for name, texts in row["variables"].items():
        low, high = (None if text is None else rational(text) for text in texts)
        good = low is None or high is None or low < high
        need(good, Malformed, "found the variable {} between {}", name, texts)
        box[terms.define(name)] = (low, high)
    while isinstance(claim, list) and len(claim) == 2 and claim[0] == "not":
        claim, negated = claim[1], not negated
    shaped("claim", claim, ("<|<=|=", None, None))
    relation, lhs, rhs = claim[0], terms.read("lhs", claim[1]), terms.read("rhs", claim[2])
    words = f"lhs {relation} rhs" + (f" for all {', '.join(row['variables'])}" if box else "")
    goal = Goal(relation, lhs, rhs, box, False)
    if negated:
        goal, words = Goal(OPPOSITE[relation], rhs, lhs, box, bool(box)), f"not ({words})"
    return goal, {} if box else {"lhs": lhs, "rhs": rhs}, words


def overlap(found: list[str], x: Interval) -> None:
    """Afterwards an enclosure of the certificate has a number in common with one from here."""
    low, high = map(rational, found)
    need(low <= high, Malformed, "found the enclosure {}, whose ends are in no order", found)
    need(low <= x[1] and x[0] <= high, Refused, "found {}, expected {}", (low, high), x)


def judged(terms: Terms, row: dict[str, Any], proof: Any, assumed: dict[str, Any]) -> str:
    """The line of the report for an obligation."""
    why = words = ""
    try:
        unknown = set(row["uses"]) - assumed.keys()
        need(not unknown, Malformed, "uses: found {}, which no assumption has", unknown)
        goal, sides, words = claimed(terms, row)
        terms.prove(goal, proof, PROOF | {"obligation": NAME} | dict.fromkeys(sides, PAIR))
        for side, term in sides.items():
            overlap(proof[side], terms.scope(proof["bits"], {}).enclose(term))
        wanted = row["role"] != "needed" or not words.startswith("not")
        need(wanted, Refused, "the negation is proved, but the row is needed")
    except Malformed as error:
        raise Malformed(f"obligation {row['name']}: {error}") from error
    except Refused as error:
        why = f": {error}"
    for name in row["variables"]:
        del terms.leaves[name]
    verdict = "REFUSED" if why else "proved "
    return f"{verdict} {row['name']} [{row['label']}] {words}{why}"


def check(first: bytes, second: bytes) -> tuple[bool, list[str]]:
    """Whether the certificate in ``second`` proves the statement in ``first``, and a report."""
    statement = parse("statement", first, STATEMENT)
    certificate = parse("certificate", second, CERTIFICATE)
    digest, given = sha256(first).hexdigest(), certificate["statement_sha256"]
    need(given == digest, Malformed, "statement_sha256: found {}, expected {}", given, digest)
    rows, proofs, terms = statement["obligations"], certificate["proofs"], Terms()
    need(rows, Malformed, "obligations: found none, which proves nothing")
    assumed = {item["name"]: item for item in statement["assumptions"]}
    for key in ("obligations", "assumptions"):
        names = [item["name"] for item in statement[key]]
        need(len(set(names)) == len(names), Malformed, "{}: found a name twice in {}", key, names)
    found = [proof.get("obligation") if isinstance(proof, dict) else proof for proof in proofs]
    odd = [pair for pair in zip_longest(found, (row["name"] for row in rows)) if pair[0] != pair[1]]
    need(not odd, Malformed, "proofs: found and expected are {}", odd)
    for name, term in statement["parameters"].items():
        terms.define(name, terms.read(f"parameter {name}", term))
    for item in statement["constants"]:
        terms.define(item["name"], terms.read(f"constant {item['name']}", item["term"]))
    enclosures = certificate["enclosures"]
    keys = enclosures.keys() ^ {item["name"] for item in statement["constants"]}
    need(not keys, Malformed, "enclosures: found too many or too few names: {}", sorted(keys))
    lines = [judged(terms, row, proof, assumed) for row, proof in zip(rows, proofs, strict=True)]
    bits = max(128, *(proof["bits"] for proof in proofs))
    for item in statement["constants"]:
        try:
            x = terms.scope(bits, {}).enclose(terms.leaves[item["name"]])
            overlap(enclosures[item["name"]], x)
        except Refused as error:
            lines.append(f"REFUSED constant {item['name']} [{item['label']}]: {error}")
    proved = not any(line.startswith("REFUSED") for line in lines)
    lines += [f"assumed {item['label']}: {item['sentence']}" for item in statement["assumptions"]]
    return proved, [*lines, "PROVED" if proved else "NOT PROVED"]


def main(arguments: Sequence[str]) -> int:
    """Check the files that the command line names, print the report, and return the exit code."""
    names = ("statement.json", "certificate.json")
    paths = [os.path.join(*arguments, name) for name in names] if len(arguments) == 1 else arguments
    try:
        need(len(paths) == 2, OSError, "found {} words, expected a folder or two files", len(paths))
        with open(paths[0], "rb") as first, open(paths[1], "rb") as second:
            contents = first.read(MAX_BYTES + 1), second.read(MAX_BYTES + 1)
    except (OSError, ValueError) as error:
        print(f"check: {error}", file=sys.stderr)
        return 2
    try:
        proved, lines = check(*contents)
        code = 0 if proved else 1
    except Malformed as error:
        code, lines = 4, [f"malformed: {error}", "NOT PROVED"]
    except KeyboardInterrupt:
        print("check: interrupted", file=sys.stderr)
        return 130
    text = "\n".join(line if line.isprintable() else ascii(line) for line in lines)
    encoding = sys.stdout.encoding or "ascii"
    try:
        print(text.encode(encoding, "backslashreplace").decode(encoding), flush=True)
    except BrokenPipeError:
        os.dup2(os.open(os.devnull, os.O_WRONLY), sys.stdout.fileno())
    return code


if __name__ == "__main__":
    gc.disable()  # almost no garbage is cyclic here, and looking for it takes time
    sys.exit(main(sys.argv[1:]))
