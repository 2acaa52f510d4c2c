"""Check that a certificate proves a statement. This file is all that has to be trusted.

    python3 -I verify/check.py FOLDER                     (statement.json and certificate.json)
    python3 -I verify/check.py STATEMENT CERTIFICATE

Believed are Python's integers, ``fractions``, ``json``, ``re`` and ``hashlib``, and these lines; no
word of the certificate is. ``verify/wire.py`` describes both files. An obligation without variables
claims that its two sides are defined as real numbers and stand in the relation; one with variables
claims that for all values in their open intervals, and its negation claims one point there where
both sides are defined and the relation fails. Every rule establishes this or raises `Refused`;
what is not in the format raises `Malformed`. Nothing is searched for, there is no floating point,
and sizes are bounded, so that checking ends.

Exit codes: 0 all is proved and no needed row is a negation; 1 something is not proved; 2 unusable
command line; 4 a file is malformed, or the two do not belong together.
"""

from __future__ import annotations

import json
import os
import re
import sys
from collections.abc import Callable, Sequence
from decimal import ROUND_CEILING, ROUND_FLOOR, Context, Decimal
from fractions import Fraction
from hashlib import sha256
from itertools import pairwise, product
from math import isqrt
from typing import Any, NamedTuple

MAX_BYTES, MAX_NESTING = 1 << 22, 100  # of a file
MAX_HEIGHT = 200  # of a term, with the definitions of its symbols
MAX_BITS, MAX_SIZE = 1 << 16, 1 << 18  # of precision; of a numerator with its denominator
MAX_WORK = 10_000_000  # about the number of microseconds

# A shape is a pattern for a text, a range for an integer, a dict for an object with just these
# keys (ANY: with any keys), a list for a list of any length, a tuple for one of this length, a set
# for null or what is in the set, None for a value that is looked at later.
ANY, TEXT, NAME = "any", ".*", "[A-Za-z][A-Za-z0-9_.-]{0,99}"
RATIONAL = "-?[0-9]{1,4300}(/0*[1-9][0-9]{0,4290})?"  # int() reads at most 4300 digits
DECIMAL = r"-?[0-9]{1,400}(\.[0-9]{1,400})?(e-?[0-9]{1,5})?"
PAIR = (DECIMAL, DECIMAL)
OBLIGATION = {"name": NAME, "label": TEXT, "role": "needed|printed", "says": TEXT, "claim": None}
OBLIGATION |= {"uses": [NAME], "variables": {ANY: ({RATIONAL}, {RATIONAL})}}
STATEMENT = {"format": "verify-statement/1", "theorem": TEXT, "title": TEXT}
STATEMENT |= {"parameters": {ANY: None}, "obligations": [OBLIGATION]}
STATEMENT |= {"constants": [{"name": NAME, "label": TEXT, "tex": TEXT, "term": None}]}
STATEMENT |= {"assumptions": [{"name": NAME, "label": TEXT, "sentence": TEXT}]}
CERTIFICATE = {"format": "verify-certificate/1", "statement_sha256": "[0-9a-f]{64}"}
CERTIFICATE |= {"enclosures": {ANY: PAIR}, "proofs": [None]}
PROOF = {"rule": NAME, "bits": range(2, MAX_BITS + 1)}

#: How many terms an operation has; min and max have two or more, and pow has an exponent besides.
ARITY = {"add": 2, "sub": 2, "mul": 2, "div": 2, "neg": 1, "sqrt": 1, "cos": 1, "cos_pi": 1}
OPPOSITE = {"<": "<=", "<=": "<", "=": "!="}  # what a failure says about the two sides swapped
HOLDS: dict[str, Callable[..., bool]] = {  # for all numbers in [a, b] and all in [c, d]
    "<": lambda a, b, c, d: b < c,
    "<=": lambda a, b, c, d: b <= c,
    "=": lambda a, b, c, d: b <= c and d <= a,
    "!=": lambda a, b, c, d: b < c or d < a,
}
Node = tuple[str, tuple[int, ...], tuple[int, ...]]
Interval = tuple[Fraction, Fraction]
Polynomial = dict[tuple[tuple[int, int], ...], Fraction]  # sorted (atom, power) to coefficient
ZERO, ONE = Fraction(0), Fraction(1)


class Malformed(Exception):  # noqa: N818
    """A file is not in the format, or the two files do not belong together."""


class Refused(Exception):  # noqa: N818
    """The evidence does not prove the obligation."""


class Goal(NamedTuple):
    """lhs relation rhs for all values of the variables in their intervals, or for some."""

    relation: str
    lhs: int
    rhs: int
    variables: dict[str, int]
    box: dict[int, Any]
    some: bool


def need(condition: object, kind: type[Exception], message: str, *values: Any) -> None:
    """Afterwards the condition holds. The values are put into the message about its failure."""
    if not condition:
        raise kind(message.format(*map(shown, values)))


def shown(value: Any) -> str:
    """An interval as decimals, a name as it is, and another value in short."""
    if isinstance(value, tuple):
        down, up = (Context(17, way) for way in (ROUND_FLOOR, ROUND_CEILING))
        low, high = (end.as_integer_ratio() for end in value)
        return f"[{down.divide(*low)}, {up.divide(*high)}]"
    text = value if isinstance(value, str) and value.isprintable() else ascii(value)
    return text if len(text) < 90 else f"{text[:60]}... ({len(text)} characters)"


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
            size, shift = n.bit_length() + d.bit_length(), bits - n.bit_length() + d.bit_length()
            self.terms.spend(size)
            need(size <= MAX_SIZE, Refused, "found a number of {} bits", size)
            up, back = max(shift, 0), max(-shift, 0)
            short = sign * ((n << up) // (d << back) << back)
            ends.append(end if size <= 2 * bits else Fraction(short, 1 << up))
        return ends[0], ends[1]

    def mul(self, x: Interval, y: Interval) -> Interval:
        """A product is linear in each factor, so that its extremes are products of ends."""
        (a, b), (c, d) = x, y
        ends = (a * c, b * d) if a >= 0 and c >= 0 else (a * c, a * d, b * c, b * d)
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
        root = (low, high) if low >= 0 else (max(ZERO, -high), max(-low, high))
        return self.mul(root, root)

    def sqrt(self, x: Interval) -> Interval:
        """The root of n/d is that of 4^bits nd, which lies between integers, over 2^bits d."""
        need(x[0] >= 0, Refused, "found a square root of {}, which reaches below 0", x)
        ends = []
        for n, d in (end.as_integer_ratio() for end in x):
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
        square, total, error = self.power(x, 2), (ONE, ONE), Fraction(1, 1 << self.bits)
        for k in range(self.bits // 2 + 21, 0, -1):
            low, high = (end * Fraction(1, 2 * k * (2 * k - 1)) for end in self.mul(square, total))
            total = self.outward((1 - high, 1 - low), 32)
        return max(total[0] - error, -ONE), min(total[1] + error, ONE)

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
        turns = x[0].numerator // (2 * x[0].denominator) * 2
        return self.cos(self.mul((x[0] - turns, x[1] - turns), pi))

    def expand(self, term: int) -> Polynomial:
        """The polynomial of a term; refused where the term may be undefined."""
        if term not in self.polynomials:
            op, subterms, rest = self.terms.nodes[term]
            parts = [self.expand(arg) for arg in subterms if op != "symbol"]
            p = {((2 * term, 1),): 1}
            if op == "rational":
                p = {(): Fraction(*rest) if rest[1] > 1 else rest[0]} if rest[0] else {}
            elif op in ("add", "sub", "neg"):
                p = plus(parts[0] if parts[1:] else {}, parts[-1], 1 if op == "add" else -1)
            elif op in ("mul", "pow"):
                p = parts[0]
                for factor in parts[1:] or parts * (rest[0] - 1):
                    p = self.times(p, factor)
            elif op == "div":
                self.div((ONE, ONE), self.enclose(subterms[1]))
                self.relations[2 * subterms[1] + 1] = parts[1]
                p = self.times(parts[0], {((2 * subterms[1] + 1, 1),): 1})
            elif subterms:
                self.enclose(term)
                self.relations |= {2 * term: parts[0]} if op == "sqrt" else {}
            self.polynomials[term] = p
        return self.polynomials[term]

    def times(self, a: Polynomial, b: Polynomial) -> Polynomial:
        """The product."""
        total: Polynomial = {}
        for (m, c), (n, d) in product(a.items(), b.items()):
            self.terms.spend(c.numerator.bit_length() + d.numerator.bit_length(), 8)
            powers = dict(m)
            for atom, k in n:
                powers[atom] = powers.get(atom, 0) + k
            add(total, powers, c * d)
        return {monomial: coefficient for monomial, coefficient in total.items() if coefficient}

    def vanishes(self, p: Polynomial) -> bool:
        """Whether p is 0 once squares of roots are replaced and inverses are multiplied away."""
        for atom in sorted(self.relations, reverse=True):
            top = max((k for monomial in p for a, k in monomial if a == atom), default=0)
            if top > 1 - atom % 2:
                total: Polynomial = {}
                for monomial, coefficient in p.items():
                    powers = dict(monomial)
                    k = powers.pop(atom, 0)
                    powers |= {atom: 1} if k % 2 and atom % 2 == 0 else {}
                    part = {tuple(sorted(powers.items())): coefficient}
                    for _ in range(top - k if atom % 2 else k // 2):
                        part = self.times(part, self.relations[atom])
                    total = plus(total, part, 1)
                p = total
        return not p


def add(total, powers, coefficient):
    monomial = tuple(sorted(powers.items()))
    total[monomial] = total.get(monomial, 0) + coefficient


def plus(a: Polynomial, b: Polynomial, factor: Fraction) -> Polynomial:
    """a + factor * b."""
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
        self.nodes: list[Node] = []
        self.heights: list[int] = []
        self.index: dict[Node, int] = {}
        self.leaves: dict[str, int] = {}  # the names in scope, and the rationals read so far
        self.scopes: dict[int, Scope] = {}
        self.work = MAX_WORK

    def spend(self, bits: int, times: int = 1) -> None:
        """Count operations with so many bits; give up when they are too many."""
        self.work -= times * (4 + (bits * bits >> 20))
        need(self.work >= 0, Refused, "found too much work, expected at most {}", MAX_WORK)

    def node(self, op: str, subterms: Sequence[int], *rest: int) -> int:
        """The term of an operation and its arguments."""
        node = op, tuple(subterms), rest
        if node not in self.index:
            self.index[node] = len(self.nodes)
            self.nodes.append(node)
            self.heights.append(1 + max((self.heights[term] for term in subterms), default=0))
            need(self.heights[-1] <= MAX_HEIGHT, Refused, "found a term of {} levels", MAX_HEIGHT)
        return self.index[node]

    def define(self, name: str, *definition: int) -> int:
        """A new name in scope: a variable, or a constant with its definition."""
        shaped("name", name, NAME)
        need(name not in self.leaves, Malformed, "the name {} is in use already", name)
        self.leaves[name] = self.node("symbol", definition, len(self.nodes))
        return self.leaves[name]

    def read(self, where: str, value: Any) -> int:
        """The term that is written over the names in scope."""
        if isinstance(value, str) and value in self.leaves:
            return self.leaves[value]
        if isinstance(value, str):
            shaped(where, value, RATIONAL)
            self.leaves[value] = self.node("rational", (), *Fraction(value).as_integer_ratio())
            return self.leaves[value]
        need(isinstance(value, list), Malformed, "x")
        op, rest = value[0] if value else None, []
        if op == "pow":
            shaped(where, value, ("pow", None, "[1-9][0-9]{0,2}"))
            rest = [int(value.pop())]
        count = len(value) - 1
        arity = ARITY | {"pow": 1} | dict.fromkeys(("min", "max"), max(2, count))
        good = isinstance(op, str) and arity.get(op) == count
        need(good, Malformed, "{}: found {} of {} terms, expected an operation", where, op, count)
        return self.node(op, [self.read(where, arg) for arg in value[1:]], *rest)

    def substitute(self, term: int, done: dict[int, int]) -> int:
        """The term after replacing what ``done`` replaces; ``done`` learns the subterms."""
        op, subterms, rest = self.nodes[term]
        if term not in done and op != "symbol":
            done[term] = self.node(op, [self.substitute(arg, done) for arg in subterms], *rest)
        return done.get(term, term)

    def replace(self, goal: Goal, done: dict[int, int]) -> Goal:
        """The goal after replacing symbols by terms."""
        lhs, rhs = self.substitute(goal.lhs, done), self.substitute(goal.rhs, done)
        return goal._replace(lhs=lhs, rhs=rhs)

    def scope(self, bits: int, box: dict[int, Any]) -> Scope:
        """The enclosures at a precision, for given intervals of symbols (None: unbounded)."""
        if bits not in self.scopes:
            self.scopes[bits] = Scope(self, bits, {})
        known = {symbol: ends for symbol, ends in box.items() if None not in ends}
        return Scope(self, bits, known) if known else self.scopes[bits]

    def interval(self, goal: Goal, proof: dict[str, Any]) -> None:
        """The enclosures of the two sides, for all values of the variables, decide."""
        scope = self.scope(proof["bits"], goal.box)
        x, y = scope.enclose(goal.lhs), scope.enclose(goal.rhs)
        message = f"found {{}} and {{}}, expected {goal.relation} between them"
        need(HOLDS[goal.relation](*x, *y), Refused, message, x, y)

    def exact(self, goal: Goal, _: dict[str, Any]) -> None:
        """The same with so many bits that rational values are exact."""
        self.interval(goal, {"bits": MAX_BITS})

    def identity(self, goal: Goal, proof: dict[str, Any]) -> None:
        """The two sides are defined, and the same function of symbols and roots."""
        scope = self.scope(proof["bits"], goal.box)
        same = scope.vanishes(plus(scope.expand(goal.lhs), scope.expand(goal.rhs), -1))
        need(same, Refused, "found sides that differ, expected an identity")
        need(goal.relation in ("<=", "="), Refused, "found equal sides, not lhs {} rhs", goal.relation)

    def rewrite(self, goal: Goal, proof: dict[str, Any]) -> None:
        """Symbols are replaced; then the goal is proved by an interval or an identity.

        A symbol may be replaced by its definition. It may be replaced by an entry of the min that
        defines it if raising it, from its value up to the entry, cannot lower lhs or raise rhs:
        the goal at the entry implies the goal. For an entry of a max it is lowered instead.
        """
        for name, index in proof["steps"]:
            symbol = self.leaves.get(name, 0)
            op, definition, _ = self.nodes[symbol]
            need(op == "symbol" and definition, Malformed, "found a step for {}, no constant", name)
            new = definition[0]
            if index is not None:
                op, entries, _ = self.nodes[new]
                good = op in ("min", "max") and index < len(entries) and goal.relation in ("<", "<=")
                need(good, Refused, "found entry {} of {}, which has no such entry", index, name)
                new, up, scope = entries[index], 1 if op == "min" else -1, self.scope(proof["bits"], goal.box)
                ends = *scope.enclose(symbol), *scope.enclose(new)
                scope = self.scope(proof["bits"], goal.box | {symbol: (min(ends), max(ends))})
                scope.enclose(goal.lhs), scope.enclose(goal.rhs)
                lhs, rhs = (scope.moves(symbol, side, {}) for side in (goal.lhs, goal.rhs))
                good = lhs <= {up} and rhs <= {-up}
                need(good, Refused, "found entry {} of {}, which may make the claim easier", index, name)
            goal = self.replace(goal, {symbol: new})
        (self.interval if proof["closing"] == "interval" else self.identity)(goal, proof)

    def bernstein(self, goal: Goal, proof: dict[str, Any]) -> None:
        """rhs - lhs is a polynomial in one variable with no negative Bernstein coefficient.

        For x = (a + b s)/(1 + s), which runs through ]a, b[ for s > 0, the polynomial p(x) of
        degree at most n becomes (1 + s)^n p(x) = sum of c_k (a + b s)^k (1 + s)^(n - k), which is
        not negative if no coefficient of it in s is, and positive if one is.
        """
        n, scope = proof["degree"], self.scope(proof["bits"], goal.box)
        good = len(goal.box) == 1 == len(scope.known) and goal.relation in ("<", "<=")
        need(good, Refused, "expected an inequality in one variable with a bounded interval")
        ((x, (a, b)),) = goal.box.items()
        total: Polynomial = {}
        for monomial, coefficient in plus(scope.expand(goal.rhs), scope.expand(goal.lhs), -ONE).items():
            part, k = {(): coefficient}, dict(monomial).get(2 * x, 0)
            need(k <= n, Refused, "found a power {}, expected at most {}", k, n)
            for atom, power in monomial:
                low, high = scope.enclose(atom // 2)
                need(low == high or atom == 2 * x, Refused, "found a coefficient that is not rational")
                value = Fraction(low.denominator, low.numerator) if atom % 2 else low
                for _ in range(power):
                    part = scope.times(part, {(): a, ((2*x, 1),): b} if atom == 2 * x else {(): value})
            for _ in range(n - k):
                part = scope.times(part, {(): ONE, ((2*x, 1),): ONE})
            total = plus(total, part, ONE)
        good = all(c > 0 for c in total.values()) and (goal.relation == "<=" or total)
        need(good, Refused, "found Bernstein coefficients {}, expected", )

    def cuts(self, goal: Goal, proof: dict[str, Any]) -> None:
        """Enclosures decide between neighbouring cuts, which lead from end to end of intervals."""
        sides = []
        need(proof["cuts"].keys() == goal.variables.keys(), Malformed, "found cuts of {}, expected of")
        for name, cuts in proof["cuts"].items():
            points = [Fraction(cut) for cut in cuts]
            pieces, ends = list(pairwise(points)), goal.box[goal.variables[name]]
            good = pieces and (points[0], points[-1]) == ends and all(a < b for a, b in pieces)
            need(good, Refused, "the cuts of {} do not increase from end to end", name)
            sides.append([(goal.variables[name], piece) for piece in pieces])
        for box in product(*sides):
            self.interval(goal._replace(box=dict(box)), proof)

    def witness(self, goal: Goal, proof: dict[str, Any]) -> None:
        """Enclosures decide at one point inside the intervals."""
        done = {}
        for name, text in proof["point"].items():
            value, (low, high) = Fraction(text), goal.box[goal.variables[name]]
            inside = (low is None or low < value) and (high is None or value < high)
            need(inside, Refused, "found {} = {}, expected a value inside its interval", name, text)
            done[goal.variables[name]] = self.node("rational", (), *value.as_integer_ratio())
        self.interval(self.replace(goal, done)._replace(box={}), proof)

    def square(self, goal: Goal, proof: dict[str, Any]) -> None:
        """Both sides are not negative, and their squares stand in the same relation."""
        scope = self.scope(proof["bits"], goal.box)
        for x in (scope.enclose(goal.lhs), scope.enclose(goal.rhs)):
            need(x[0] >= 0, Refused, "found {}, expected a side that is not negative", x)
        lhs, rhs = (self.node("pow", [term], 2) for term in (goal.lhs, goal.rhs))
        self.prove(goal._replace(lhs=lhs, rhs=rhs), proof["then"], PROOF)

    def prove(self, goal: Goal, proof: Any, shape: dict[str, Any]) -> None:
        """Afterwards the goal is proved."""
        rule = proof.get("rule") if isinstance(proof, dict) else None
        good = isinstance(rule, str) and rule in RULES
        need(good, Malformed, "found the rule {}, expected one of {}", rule, ", ".join(RULES))
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
    if isinstance(shape, str):
        good = isinstance(value, str) and re.fullmatch(shape, value) and value.isprintable()
        need(good, Malformed, "{}: found {}, expected the pattern {}", where, value, shape)
    elif isinstance(shape, range):
        good = type(value) is int and value in shape
        need(good, Malformed, "{}: found {}, expected an integer in {}", where, value, shape)
    elif isinstance(shape, set):
        for inner in shape if value is not None else ():
            shaped(where, value, inner)
    elif isinstance(shape, dict):
        need(isinstance(value, dict), Malformed, "{}: found {}, expected an object", where, value)
        keys, found = sorted(value if ANY in shape else shape), sorted(value)
        need(found == keys, Malformed, "{}: found the keys {}, expected {}", where, found, keys)
        for key in value:
            shaped(f"{where}: {key}", value[key], shape[ANY if ANY in shape else key])
    elif shape is not None:
        need(isinstance(value, list), Malformed, "{}: found {}, expected a list", where, value)
        inner = list(shape) if isinstance(shape, tuple) else shape * len(value)
        good = len(value) == len(inner)
        need(good, Malformed, "{}: found {}, expected {} entries", where, value, len(inner))
        for number, entry in enumerate(value):
            shaped(f"{where} {number}", entry, inner[number])


OTHERS = bytes(set(range(256)) - set(b'[]{}"'))


def parse(where: str, data: bytes, shape: dict[str, Any]) -> Any:
    """The document in a JSON file, where plain integers are the only numbers."""

    def unique(pairs: list[tuple[str, Any]]) -> dict[str, Any]:
        keys = [key for key, _ in pairs]
        need(len(set(keys)) == len(keys), Malformed, "{}: found a key twice in {}", where, keys)
        return dict(pairs)

    def integer(text: str) -> int:
        good = re.fullmatch("[0-9]{1,9}", text)
        need(good, Malformed, "{}: found the number {}, expected numbers as texts", where, text)
        return int(text)

    need(len(data) <= MAX_BYTES, Malformed, "{}: found more than {} bytes", where, MAX_BYTES)
    flat = re.sub(rb"\\.", b"", data, flags=re.S).translate(None, OTHERS).replace(b'""', b"")
    brackets = re.sub(rb'"[^"]*"', b"", flat)
    for _ in range(MAX_NESTING):
        brackets = brackets.replace(b"[]", b"").replace(b"{}", b"")
    message = "{}: found brackets without partner, or more than {} inside each other"
    need(not brackets, Malformed, message, where, MAX_NESTING)
    hooks = {"parse_int": integer, "parse_float": integer, "parse_constant": integer}
    try:
        value = json.loads(data.decode(), object_pairs_hook=unique, **hooks)
    except ValueError as error:
        raise Malformed(f"{where}: {error}") from error
    shaped(where, value, shape)
    return value


def overlap(x: Interval, texts: list[str]) -> None:
    """Afterwards the certificate's enclosure and the one computed here are not disjoint."""
    low, high = map(Decimal, texts)
    (a, b), (c, d) = (end.as_integer_ratio() for end in (low, high))
    need(low <= high, Malformed, "found the enclosure {}, expected its ends in order", (low, high))
    need(a * x[1].denominator <= b * x[1].numerator and x[0].numerator * d <= c * x[0].denominator, Refused, "found {}, expected about {}", (low, high), x)


def read_goal(terms: Terms, row: dict[str, Any]) -> tuple[Goal, tuple[int, int], str]:
    """What an obligation claims, the two sides as they are written, and the claim in words."""
    claim, negated, variables, box = row["claim"], False, {}, {}
    for name, texts in row["variables"].items():
        low, high = (None if text is None else Fraction(text) for text in texts)
        empty = low is not None and high is not None and low >= high
        need(not empty, Malformed, "found no value between {} for {}", texts, name)
        variables[name] = terms.define(name)
        box[variables[name]] = (low, high)
    while isinstance(claim, list) and claim[:1] == ["not"] and len(claim) == 2:
        claim, negated = claim[1], not negated
    shaped("claim", claim, ("<|<=|=", None, None))
    relation, lhs, rhs = claim[0], terms.read("claim", claim[1]), terms.read("claim", claim[2])
    for name in variables:
        del terms.leaves[name]
    words = f"lhs {relation} rhs" + (f" for all {', '.join(variables)}" if variables else "")
    if negated:
        goal = Goal(OPPOSITE[relation], rhs, lhs, variables, box, bool(variables))
        return goal, (lhs, rhs), f"not ({words})"
    return Goal(relation, lhs, rhs, variables, box, False), (lhs, rhs), words


def check(first: bytes, second: bytes) -> tuple[bool, list[str]]:
    """Whether the certificate in ``second`` proves the statement in ``first``, and the report."""
    statement = parse("statement", first, STATEMENT)
    certificate = parse("certificate", second, CERTIFICATE)
    digest, given = sha256(first).hexdigest(), certificate["statement_sha256"]
    need(given == digest, Malformed, "statement_sha256: found {}, expected {}", given, digest)
    rows, proofs, terms = statement["obligations"], certificate["proofs"], Terms()
    for name, term in statement["parameters"].items():
        terms.define(name, terms.read(f"parameter {name}", term))
    for item in statement["constants"]:
        terms.define(item["name"], terms.read(f"constant {item['name']}", item["term"]))
    names, known = ([item["name"] for item in statement[key]] for key in ("obligations", "assumptions"))
    for name in [name for name in names + known if names.count(name) + known.count(name) > 1]:
        need(False, Malformed, "found the name {} twice", name)
    need(rows, Malformed, "found no obligation, which proves nothing")
    found = [proof.get("obligation") if isinstance(proof, dict) else None for proof in proofs]
    need(found == names, Malformed, "proofs: found {}, expected {}", found, names)
    constants, enclosures = [c["name"] for c in statement["constants"]], certificate["enclosures"]
    need(sorted(constants) == sorted(enclosures), Malformed, "enclosures: found {}, expected {}", sorted(enclosures), sorted(constants))
    lines, good = [], True
    for row, proof in zip(rows, proofs, strict=True):
        words = ""
        try:
            need(set(row["uses"]) <= set(known), Malformed, "found uses {}, expected {}", row["uses"], known)
            goal, sides, words = read_goal(terms, row)
            shape = PROOF | {"obligation": NAME} | ({} if goal.box else {"lhs": PAIR, "rhs": PAIR})
            terms.prove(goal, proof, shape)
            for side, key in zip(sides, ("lhs", "rhs") if not goal.box else (), strict=False):
                overlap(terms.scope(proof["bits"], {}).enclose(side), proof[key])
            verdict = "refuted" if words.startswith("not") and row["role"] == "needed" else "proved"
        except Malformed as error: raise Malformed(f"obligation {row['name']}: {error}") from error
        except Refused as why:
            verdict = f"failed: {why}"
        good = good and verdict == "proved"
        lines.append(f"{verdict}  {row['name']}  [{row['label']}]  {words}")
    for constant in statement["constants"]:
        try: overlap(terms.scope(128,{}).enclose(terms.leaves[constant["name"]]), enclosures[constant["name"]])
        except Refused as why:
            lines.append()
    lines += [f"assumed  {item['label']}: {item['sentence']}" for item in statement["assumptions"]]
    return good, [*lines, "PROVED" if good else "NOT PROVED"]


def main(arguments: Sequence[str]) -> int:
    """Check the files named on the command line, print the report, and return the exit code."""
    names = ("statement.json", "certificate.json")
    paths = [os.path.join(arguments[0], name) for name in names] if len(arguments) == 1 else arguments
    try:
        if len(paths) != 2: raise ValueError("expected a folder, or a statement and a certificate")
        contents = []
        for path in paths:
            with open(path, "rb") as file:
                contents.append(file.read(MAX_BYTES + 1))
    except (OSError, ValueError) as error:
        print(f"check: {error}", file=sys.stderr)
        return 2
    try:
        proved, lines = check(*contents)
        code = 0 if proved else 1
    except Malformed as error:
        code, lines = 4, [f"malformed: {error}", "NOT PROVED"]
    except KeyboardInterrupt: return 130
    encoding = sys.stdout.encoding
    text = "\n".join(lines)+"\n"
    try:
        sys.stdout.write(text)
        sys.stdout.flush()
    except BrokenPipeError:
        os.dup2(os.open(os.devnull, os.O_WRONLY), sys.stdout.fileno())
    return code


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))
