"""Check that certificates prove their statements. This file is all that has to be trusted.

    python3 -I verify/check.py FOLDER [FOLDER ...]        (statement.json and certificate.json)
    python3 -I verify/check.py STATEMENT CERTIFICATE

Believed are Python's integers, ``fractions``, ``json``, ``re``, ``hashlib``, and these lines; not
the certificate. ``certificates/README.md`` describes both files. As in the kernels of HOL, a fact
can only be made by a rule, from facts. A fact says: for all real values of the variables in scope
that satisfy the givens in scope, both sides are defined and stand in the relation. Each rule
establishes this, for the reason that its docstring gives, or raises `Refused`; what is not in the
format, or asks for too much work, raises `Malformed`. Nothing is searched for, there is no
floating point, and no tolerance.

Exit codes: 0 all is proved; 1 a needed row is refuted, or a proof is refused; 2 a file cannot be
read; 3 all is proved but for what is cited; 4 a file is malformed, or the two do not belong
together; 5 this program fails, for example where there is too little memory.
"""

from __future__ import annotations

import gc
import json
import os
import re
import sys
from collections.abc import Callable, Iterable, Mapping, Sequence
from fractions import Fraction
from functools import cache
from hashlib import sha256
from itertools import islice, pairwise
from math import isqrt
from typing import Any, NamedTuple

MAX_BYTES = 1 << 22  # of a file
MAX_CITED = 1 << 25  # bytes of all files that lie beside a statement to be cited
MAX_NAME = 1000  # characters of a name with those of the citations before it
MAX_NESTING = 100  # of brackets in a file, and of contexts
MAX_HEIGHT = 200  # of a term
MAX_BITS = 1 << 16  # of precision
MAX_SIZE = 1 << 19  # bits of a numerator with its denominator
MAX_DEGREE = 1 << 20  # of a name or another atom in a polynomial
MAX_SHOWN = 1 << 12  # bits before or after the point, in messages
MAX_KEPT = 1 << 20  # work of reading what is kept from one folder to the next
MAX_REFUSED = 1000  # of steps, enclosures, and needed rows that are undecided
MAX_TOLD = 4  # monomials, and factors of one, in messages
MAX_WORK = 6_000_000  # about the number of microseconds
MAX_EXPONENT = 1 << 16  # of an exponential, in enclosures
SERIES_BITS = 128  # of the coefficients of cosines
CERTIFIED = ".certificate.json"  # ends the name of the certificate of what is cited
#: The verdicts about a folder; of several folders the last one in this order counts.
EXIT_CODES = {"PROVED": 0, "UNDECIDED": 3, "REFUTED": 1, "REFUSED": 1, "MALFORMED": 4}


class Malformed(Exception):  # noqa: N818
    """A file is not in the format, asks for too much work, or does not belong to the other."""


class Refused(Exception):  # noqa: N818
    """The evidence does not prove the claim."""


class Interval(NamedTuple):
    """All real numbers from one end to the other, both included."""

    low: Fraction
    high: Fraction


class Node(NamedTuple):
    """A term: an operation, its subterms (numbers of nodes), and what else it needs.

    A ``rational`` has a numerator and a denominator, a ``pow`` its exponent, a ``root`` its index,
    a ``name`` a number of its own.
    """

    op: str
    subterms: tuple[int, ...]
    rest: tuple[int, ...] = ()


class Claim(NamedTuple):
    """The sentence ``lhs relation rhs``; ``!=`` occurs only as the negation of ``=``."""

    relation: str
    lhs: int
    rhs: int


class Applies(NamedTuple):
    """The values satisfy all givens of a context: what is proved there holds for them."""

    context: Context
    at: dict[int, int]


class Always(NamedTuple):
    """Whatever starts so and goes on so, as long as it does, satisfies all givens at each step."""

    context: Context
    start: dict[int, int]
    next: dict[int, int]


class Given(NamedTuple):
    """What a context assumes; ``kind`` is plain, carried or standing."""

    name: str
    claim: Claim
    kind: str


class Context:
    """Variables with what is given about them, inside another context; fixed once it is read.

    ``point`` has a term over the parent's names for each variable. ``outside`` are the contexts
    in which it lies, by depth.
    """

    def __init__(self, name: str, parent: Context | None) -> None:
        self.name, self.parent = name, parent
        self.depth: int = 0 if parent is None else parent.depth + 1
        need(self.depth <= MAX_NESTING, Malformed, "found more than {} contexts", MAX_NESTING)
        self.outside: tuple[Context, ...] = () if parent is None else (*parent.outside, parent)
        self.variables: dict[str, int] = {}
        self.givens: list[Given] = []
        self.point: dict[int, int] = {}

    def is_inside(self, other: Context) -> bool:
        """Whether this is the other context, or lies in it."""
        return self is other or (other.depth < self.depth and self.outside[other.depth] is other)


class Fact(NamedTuple):
    """A claim that is proved, or given, in a context."""

    claim: Claim
    context: Context


class Place(NamedTuple):
    """Where a claim is to be proved: a context, and the hypotheses of the branches around it."""

    context: Context
    hypotheses: tuple[Claim, ...] = ()

    def branch(self, *more: Claim) -> Place:
        """The same place inside a branch that adds hypotheses."""
        return Place(self.context, self.hypotheses + more)


Monomial = tuple[tuple[int, int], ...]  # sorted pairs of an atom and its exponent
Polynomial = dict[Monomial, int | Fraction]
Quotient = tuple[Polynomial, Polynomial]
Cleared = tuple[dict[int, Quotient], dict[int, Quotient]]  # terms, and radicands of roots
Proof = dict[str, Any]

ONE: Polynomial = {(): 1}
UNIT = Interval(Fraction(1), Fraction(1))
#: The functions of one number; the indexed ones have a natural number besides.
FUNCTIONS = ("sqrt", "cos", "cos_pi", "sin", "exp", "log", "atan")
INDEXED = ("pow", "root")
#: How many terms an operation without an index has (None: two or more).
ARITY = {"pi": 0, **dict.fromkeys(("neg", *FUNCTIONS), 1)}
ARITY |= dict.fromkeys(("add", "sub", "mul", "div"), 2)
ARITY_OR_MORE: dict[str, int | None] = {**ARITY, "min": None, "max": None}
#: The operations that a polynomial cannot look into, and that an equation may replace.
ATOMS = ("name", "min", "max", "pi", "root", *FUNCTIONS)
COSINES = ("cos", "cos_pi")
CIRCULAR = (*COSINES, "sin")
ROOTS = ("sqrt", "root")
#: The functions that rise, and those of them that are known by another one.
RISING = (*ROOTS, "exp", "log", "atan")
INVERSE = {"exp": "log", "log": "exp"}
#: The negation of a claim is this relation between the two sides, swapped.
NEGATION = {"<": "<=", "<=": "<", "=": "!="}
#: For each relation at x those at c, of c and x, and of 0 and the derivative between them.
PARTS_OF_RELATION = {"<": ("<", "<=", "<="), "<=": ("<=", "<=", "<="), "=": ("=", "<=", "=")}
#: Whether a relation holds between all numbers of two intervals.
HOLDS: dict[str, Callable[[Interval, Interval], bool]] = {
    "<": lambda x, y: x.high < y.low,
    "<=": lambda x, y: x.high <= y.low,
    "=": lambda x, y: x.low == x.high == y.low == y.high,
    "!=": lambda x, y: x.high < y.low or y.high < x.low,
}


def need(condition: object, kind: type[Exception], message: str, *values: Any) -> None:
    """Afterwards the condition holds. The values are put into the message about its failure."""
    if not condition:
        raise kind(message.format(*map(shown, values)))


def shown(value: Any) -> str:
    """An interval in decimals, a text as it is, and another value as Python writes it; cut."""
    if isinstance(value, Interval):
        return f"[{decimal(value.low)}, {decimal(value.high)}]"
    text = value if isinstance(value, str) and value.isprintable() else ascii(value)
    return text if len(text) < 200 else f"{text[:160]}... ({len(text)} characters)"


def size(value: int | Fraction) -> int:
    """The bits of a number."""
    if type(value) is int:
        return value.bit_length() + 1
    n, d = value.as_integer_ratio()
    return n.bit_length() + d.bit_length()


def whole(value: int | Fraction) -> int | Fraction:
    """The same number, as an integer if it is one."""
    return value if type(value) is int or value.denominator > 1 else value.numerator


def decimal(value: Fraction) -> str:
    """About twenty digits of a number, or its size, for a message."""
    n, d = value.numerator, value.denominator
    bits = n.bit_length() - d.bit_length()
    if abs(bits) > MAX_SHOWN:
        return f"{'-' if n < 0 else ''}2^{bits}"
    exponent = bits * 3 // 10 - 20
    factor: int = 10 ** abs(exponent)
    digits = n * factor // d if exponent < 0 else n // (d * factor)
    return f"{digits}e{exponent}" if n else "0"


# --- terms, names, contexts and facts ------------------------------------------------------------


class Kernel:
    """The terms, names, contexts and facts of a statement and its certificate.

    Each distinct term is stored once and is its number in ``nodes``, above those of its subterms;
    the number of a defined name is above that of its definition. ``homes`` has the innermost
    context of the names in a term. ``signs`` has <, t and a context if 0 < t is a fact of this very
    context, and the same for <=; ``cleared`` is what was cleared in a context outside of branches.
    """

    def __init__(self) -> None:
        self.nodes: list[Node] = []
        self.index: dict[tuple[Any, ...], int] = {}  # of the nodes, by their keys
        self.heights: list[int] = []
        self.homes: list[Context] = []
        self.outermost = Context("", None)
        self.contexts: dict[str, Context] = {}
        self.opened: set[Context] = {self.outermost}
        self.signs: set[tuple[str, int, Context]] = set()
        self.cleared: dict[Context, Cleared] = {}
        self.numbers: dict[int, int | Fraction] = {}  # the values of terms that are numbers
        self.names: dict[str, int] = {}  # variables and constants
        self.labels: dict[int, str] = {}  # their names
        self.definitions: dict[int, int] = {}
        self.defined: set[int] = set()  # constants whose definition is known to have a value
        self.facts: dict[str, Fact] = {}
        self.refused: set[str] = set()
        self.taken: set[str] = {"goal"}
        self.grounds: dict[int, Enclosing] = {}
        self.slopes: dict[tuple[int, int], int] = {}  # derivatives, for `mean_value`
        self.prefix = ""  # of the names of a cited statement, while that is read
        self.shared: dict[str, Any] = {}  # shared terms that are not read yet
        self.abbreviations: dict[str, int] = {}  # and those that are
        self.work = MAX_WORK

    def close(self) -> None:
        """Afterwards nothing in it refers to itself in a circle: it is freed without a search."""
        self.grounds.clear()

    def begin(self, other: Kernel, work: int) -> None:
        """Afterwards a new kernel is as the other one, in tables of its own; that was so much work.

        What is in the tables of the other one does not change: nothing is proved there.
        """
        left = self.work - work
        for name, value in vars(other).items():
            setattr(self, name, value.copy() if isinstance(value, dict | list | set) else value)
        self.work = left
        self.spend(0, 0)

    def spend(self, bits: int, times: int = 1) -> None:
        """Count operations on numbers of so many bits; give up when it is too much."""
        self.work -= times * (2 + (bits >> 8) + (bits * bits >> 20))
        if self.work < 0 or bits > MAX_SIZE:
            need(self.work >= 0, Malformed, "found more work than the limit")
            need(False, Malformed, "found a number of {} bits", bits)

    def node(self, op: str, subterms: Sequence[int], *rest: int) -> int:
        """The number of the term of an operation and its arguments."""
        found = self.index.get(key(op, subterms, rest))
        if found is None:
            height = 1 + max([self.heights[term] for term in subterms], default=0)
            message = "found a term of more than {} levels"
            need(height <= MAX_HEIGHT, Malformed, message, MAX_HEIGHT)
            home = self.outermost
            for term in subterms:
                other = self.homes[term]
                good = home.is_inside(other) or other.is_inside(home)
                need(good, Malformed, "found names of {} and {} in a term", home.name, other.name)
                home = other if other.depth > home.depth else home
            return self.add(Node(op, tuple(subterms), rest), height, home)
        return found

    def add(self, node: Node, height: int, home: Context) -> int:
        """Store a new node."""
        self.spend(0, 4 + len(node.subterms))
        self.index[key(*node)] = len(self.nodes)
        self.nodes.append(node)
        self.heights.append(height)
        self.homes.append(home)
        return len(self.nodes) - 1

    def is_ground(self, term: int) -> bool:
        """Whether all names in a term are of the root, which has no variables."""
        return self.homes[term] is self.outermost

    def rational(self, value: Fraction) -> int:
        """The term of a number."""
        return self.node("rational", (), value.numerator, value.denominator)

    def number(self, term: int, n: int, d: int) -> int | Fraction:
        """The number n/d, which is a term; its common factors are looked for once."""
        if term not in self.numbers:
            self.spend(size(n) + size(d))
            self.numbers[term] = n if d == 1 else Fraction(n, d)
        return self.numbers[term]

    def introduce(self, name: str) -> None:
        """Take a name, which nothing else may have."""
        self.spend(0, 1 + len(name) // 4)
        need(len(name) <= MAX_NAME, Malformed, "found a name of {} characters", len(name))
        need(name not in self.taken, Malformed, "found the name {} twice", name)
        self.taken.add(name)

    def new_name(self, name: str, context: Context, definition: int | None = None) -> int:
        """A new variable of a context, or a constant in it with its definition."""
        self.introduce(name)
        term = self.add(Node("name", (), (len(self.nodes),)), 1, context)
        self.names[name], self.labels[term] = term, name
        if definition is not None:
            self.definitions[term] = definition
        return term

    def install(self, name: str, claim: Claim, context: Context) -> None:
        """Make a fact of a claim: only for rules, givens and cited theorems."""
        self.facts[name] = Fact(claim, context)
        if self.nodes[claim.lhs] == Node("rational", (), (0, 1)):
            self.signs.add((claim.relation, claim.rhs, context))

    def fact(self, name: str, place: Place) -> Claim:
        """The usable fact of this name; ``@k`` is the k-th hypothesis of the branches around."""
        if name.startswith("@"):
            good = re.fullmatch(HYPOTHESIS, name) and int(name[1:]) <= len(place.hypotheses)
            need(good, Malformed, "found {}, which no branch adds", name)
            return place.hypotheses[int(name[1:]) - 1]
        need(name not in self.refused, Refused, "found {}, whose proof was refused", name)
        need(name in self.facts, Malformed, "found {}, which is no fact so far", name)
        claim, context = self.facts[name]
        message = "found {}, which is a fact of {} only"
        need(place.context.is_inside(context), Malformed, message, name, context.name)
        return claim

    def knows(self, relation: str, term: int, place: Place) -> bool:
        """Whether 0 < t, or 0 <= t, is a usable fact as it stands."""
        self.spend(0, 1 + len(place.hypotheses) + (place.context.depth >> 4))
        for claim in place.hypotheses:
            zero = self.nodes[claim.lhs] == Node("rational", (), (0, 1))
            if zero and claim.relation == relation and claim.rhs == term:
                return True
        around = (*place.context.outside, place.context)
        return any((relation, term, context) in self.signs for context in around)

    def below(self, terms: Iterable[int], is_leaf: Callable[[int], bool]) -> list[int]:
        """The terms, their subterms and definitions down to leaves, which are left out, ascending.

        A term comes after its subterms, and a defined name after its definition.
        """
        seen, waiting = set(), list(terms)
        while waiting:
            term = waiting.pop()
            if term not in seen and not is_leaf(term):
                seen.add(term)
                self.spend(0, 1 + len(self.nodes[term].subterms))
                waiting += self.nodes[term].subterms
                if term in self.definitions:
                    waiting.append(self.definitions[term])
        return sorted(seen)

    def substitute(self, claim: Claim, context: Context, at: Mapping[int, int]) -> Claim:
        """The claim at terms for the variables of a context, whose constants are unfolded."""
        self.spend(0, 2)
        new: dict[int, int] = {}  # the values are looked up where they are, however many there are

        def is_leaf(term: int) -> bool:
            return term in at or self.homes[term] is not context

        for term in self.below((claim.lhs, claim.rhs), is_leaf):
            node = self.nodes[term]
            if term in self.definitions:
                definition = self.definitions[term]
                new[term] = new.get(definition, at.get(definition, definition))
            else:
                args = [new.get(arg, at.get(arg, arg)) for arg in node.subterms]
                new[term] = self.node(node.op, args, *node.rest)
        lhs, rhs = (new.get(side, at.get(side, side)) for side in (claim.lhs, claim.rhs))
        return Claim(claim.relation, lhs, rhs)

    # --- the rules; each returns only if its claim is proved at the place -----------------------

    def interval(self, place: Place, claim: Claim, proof: Proof) -> None:
        """The enclosures of the two sides decide.

        The two sides are evaluated with intervals in which the values of their names lie, for all
        values in scope: those that the bounding facts show, and those of definitions. So both
        sides are defined, and their values lie in the two intervals.
        """
        scope = self.enclosing(place, *precision(proof))
        x, y = scope.enclose(claim.lhs), scope.enclose(claim.rhs)
        message = "found {} and {}, expected {} between them"
        need(HOLDS[claim.relation](x, y), Refused, message, x, y, claim.relation)

    def cuts(self, place: Place, claim: Claim, proof: Proof) -> None:
        """A defined term lies between neighbouring cuts, or beyond the first or last one.

        For each value of the term one of the branches has true hypotheses.
        """
        term = self.read("term", proof["term"], place.context)
        Clearing(self, place, ()).clear(term)
        points = [rational(text) for text in proof["at"]]
        good = points and all(a < b for a, b in pairwise(points))
        need(good, Refused, "found cuts {} that do not increase", proof["at"])
        ends = [None, *map(self.rational, points), None]
        for (low, high), inner in self.paired([*pairwise(ends)], proof["branches"]):
            self.spend(0, 2 + len(place.hypotheses))
            hypotheses = [] if low is None else [Claim("<=", low, term)]
            hypotheses += [] if high is None else [Claim("<=", term, high)]
            self.prove(place.branch(*hypotheses), claim, inner)

    def cases(self, place: Place, claim: Claim, proof: Proof) -> None:
        """A minimum is one of its entries, the least (a maximum the greatest).

        For all values one of the branches, which say so of each entry, has true hypotheses.
        """
        term = self.read("of", proof["of"], place.context)
        op, entries, _ = self.nodes[term]
        need(op in ("min", "max"), Refused, "of: found {}, expected min or max", op)
        Clearing(self, place, ()).clear(term)
        for i, (entry, inner) in enumerate(self.paired(entries, proof["branches"])):
            self.spend(0, 2 * len(entries) + len(place.hypotheses))
            hypotheses = [Claim("=", term, entry)]
            for other in entries[:i] + entries[i + 1 :]:
                sides = (entry, other) if op == "min" else (other, entry)
                hypotheses.append(Claim("<=", *sides))
            self.prove(place.branch(*hypotheses), claim, inner)

    def entry(self, place: Place, claim: Claim, proof: Proof) -> None:
        """A minimum is at most each of its entries (a maximum at least)."""
        op, entries, other = self.extremum(place, claim, proof, {"lhs": "min", "rhs": "max"})
        need(claim.relation == "<=", Refused, "found {}, expected <=", claim.relation)
        found = entries.index(other) if other in entries else len(entries)
        self.spend(0, found >> 4)
        need(found < len(entries), Refused, "found a side that is no entry of the {}", op)

    def least(self, place: Place, claim: Claim, proof: Proof) -> None:
        """What is less than each entry is less than their minimum (for a maximum: greater)."""
        _, entries, other = self.extremum(place, claim, proof, {"lhs": "max", "rhs": "min"})
        need(claim.relation in ("<", "<="), Refused, "found {}, expected < or <=", claim.relation)
        for entry, inner in self.paired(entries, proof["branches"]):
            sides = (entry, other) if proof["side"] == "lhs" else (other, entry)
            self.prove(place, Claim(claim.relation, *sides), inner)

    def extremum(
        self, place: Place, claim: Claim, proof: Proof, expected: dict[str, str]
    ) -> tuple[str, tuple[int, ...], int]:
        """The min or max on a side of a claim with its defined entries, and the other side."""
        term, other = claim.lhs, claim.rhs
        if proof["side"] == "rhs":
            term, other = other, term
        clearing = Clearing(self, place, ())
        clearing.clear(term), clearing.clear(other)
        if proof["equation"] is not None:
            equation = self.fact(proof["equation"], place)
            good = equation.relation == "=" and equation.lhs == term
            need(good, Refused, "found {}, which says nothing of this side", proof["equation"])
            term = equation.rhs
            clearing.clear(term)
        op, entries, _ = self.nodes[term]
        wanted = expected[proof["side"]]
        need(op == wanted, Refused, "found {} on the {}, expected {}", op, proof["side"], wanted)
        return op, entries, other

    def root(self, place: Place, claim: Claim, __: Proof) -> None:
        """The root of a positive number is positive."""
        op, radicands, _ = self.nodes[claim.rhs]
        zero = self.nodes[claim.lhs] == Node("rational", (), (0, 1))
        need(zero and claim.relation == "<" and op in ROOTS, Refused, "expected 0 < a root")
        known = self.knows("<", radicands[0], place)
        need(known, Refused, "found a radicand that is not known to be positive")

    def antisymmetry(self, place: Place, claim: Claim, proof: Proof) -> None:
        """Two numbers are equal if each is at most the other."""
        need(claim.relation == "=", Refused, "found {}, expected =", claim.relation)
        orders = [Claim("<=", claim.lhs, claim.rhs), Claim("<=", claim.rhs, claim.lhs)]
        for order, inner in self.paired(orders, proof["branches"]):
            self.prove(place, order, inner)

    def have(self, place: Place, claim: Claim, proof: Proof) -> None:
        """What is proved at a place is a hypothesis there that all values satisfy."""
        found = self.read_claim("claim", proof["claim"], place.context)
        first, then = self.paired([found, claim], proof["branches"])
        self.prove(place, *first)
        self.spend(0, 2 + len(place.hypotheses))
        self.prove(place.branch(found), *then)

    def angles(self, place: Place, claim: Claim, __: Proof) -> None:
        """2 cos u cos v = cos s + cos t, where s = u + v and t = u - v are identities."""
        two, product = self.parts("mul", claim.lhs)
        sums = self.parts("add", claim.rhs)
        good = claim.relation == "=" and self.nodes[two] == Node("rational", (), (2, 1))
        need(good, Refused, "expected 2 cos u cos v = cos s + cos t")
        op = self.nodes[sums[0]].op
        need(op in COSINES, Refused, "found {}, expected a cosine", op)
        u, v, s, t = self.parts(op, *self.parts("mul", product), *sums)
        clearing = Clearing(self, place, ())
        for kind, angle in (("add", s), ("sub", t)):
            rest = clearing.reduce(clearing.difference(self.node(kind, (u, v)), angle))
            need(not rest, Refused, "found angles that differ, by {}", clearing.told(rest))

    def range(self, place: Place, claim: Claim, __: Proof) -> None:
        """0 < exp a; sines and cosines lie in [-1, 1]; inverse tangents in ]-pi/2, pi/2[."""
        half = self.node("div", (self.node("pi", ()), self.rational(Fraction(2))))
        lower = {"exp": self.rational(Fraction(0)), "atan": self.node("neg", (half,))}
        lower |= dict.fromkeys(CIRCULAR, self.rational(Fraction(-1)))
        upper = {"atan": half, **dict.fromkeys(CIRCULAR, self.rational(Fraction(1)))}
        relation, lhs, rhs = claim
        left, right = self.nodes[lhs].op, self.nodes[rhs].op
        good = upper.get(left, -1) == rhs or lower.get(right, -1) == lhs
        op = left if upper.get(left, -1) == rhs else right
        good = good and relation == ("<=" if op in CIRCULAR else "<")
        need(good, Refused, "expected an end of the range of exp, sin, cos or atan, and a value")
        clearing = Clearing(self, place, ())
        clearing.clear(lhs), clearing.clear(rhs)

    def law(self, place: Place, claim: Claim, __: Proof) -> None:
        """An identity of functions, whose sides are defined.

        exp(log a) = a and log(exp a) = a; and those of `same_terms`, which has the two terms that
        have to be the same identically.
        """
        need(claim.relation == "=", Refused, "found {}, expected =", claim.relation)
        clearing = Clearing(self, place, ())
        clearing.clear(claim.lhs), clearing.clear(claim.rhs)
        op, subterms, _ = self.nodes[claim.lhs]
        if op in INVERSE and self.nodes[subterms[0]] == Node(INVERSE[op], (claim.rhs,)):
            return
        rest = clearing.reduce(clearing.difference(*self.same_terms(claim.lhs, claim.rhs)))
        need(not rest, Refused, "found terms that differ, by {}", clearing.told(rest))

    def same_terms(self, lhs: int, rhs: int) -> tuple[int, int]:
        """Two terms that make lhs = rhs a law if they are equal, and both sides are defined.

        exp s = exp a exp b if s = a + b; log s = log a + log b if s = a b; sin u = cos v if v =
        pi/2 - u; cos u = cos_pi v if u = pi v; sin(a) = t cos(a) if a = atan t; and
        sin(u)^2 + cos(v)^2 = 1 if u = v.
        """
        pi = self.node("pi", ())
        kinds = self.nodes[lhs].op, self.nodes[rhs].op
        if kinds in (("exp", "mul"), ("log", "add")):
            op = "add" if kinds[0] == "exp" else "mul"
            factors = self.parts(kinds[0], *self.parts(kinds[1], rhs))
            return self.parts(kinds[0], lhs)[0], self.node(op, factors)
        if kinds in (("sin", "cos"), ("cos", "cos_pi")):
            u, v = *self.parts(kinds[0], lhs), *self.parts(kinds[1], rhs)
            half = self.node("div", (pi, self.rational(Fraction(2))))
            is_sine = kinds[0] == "sin"
            return (v, self.node("sub", (half, u))) if is_sine else (u, self.node("mul", (pi, v)))
        if kinds == ("sin", "mul"):
            (angle,), (t, cosine) = self.parts("sin", lhs), self.parts("mul", rhs)
            need(self.nodes[angle] == Node("atan", (t,)), Refused, "found another angle")
            return angle, self.parts("cos", cosine)[0]
        good = kinds[0] == "add" and self.nodes[rhs] == Node("rational", (), (1, 1))
        squares = self.nodes[lhs].subterms
        good = good and all(self.nodes[square].rest == (2,) for square in squares)
        need(good, Refused, "found {} = {}, which is no law", *kinds)
        sine, cosine = self.parts("pow", *squares)
        return self.parts("sin", sine)[0], self.parts("cos", cosine)[0]

    def monotony(self, place: Place, claim: Claim, proof: Proof) -> None:
        """exp, log, atan and roots rise, so that f(a) and f(b) stand in the relation of a and b.

        If a = b, f(a) = f(b) also for sines and cosines. With ``under`` the claim is about a and b,
        and the premise about f(a) and f(b): the function rises, so it is one to one.
        """
        relation, lhs, rhs = claim
        clearing = Clearing(self, place, ())
        clearing.clear(lhs), clearing.clear(rhs)
        if proof["under"] is None:
            (op, subterms, index), other = self.nodes[lhs], self.nodes[rhs]
            good = op in RISING or (op in CIRCULAR and relation == "=")
            good = good and (op, index) == (other.op, other.rest)
            need(good, Refused, "found {} and {}, expected the same function", op, other.op)
            below = Claim(relation, subterms[0], other.subterms[0])
        else:
            lhs, rhs = (self.node(proof["under"], (side,)) for side in (lhs, rhs))
            below = Claim(relation, lhs, rhs)
        self.premise(place, below, proof["premise"])

    def derivative(self, place: Place, claim: Claim, proof: Proof) -> None:
        """What holds at a number c still holds at x, as its derivative has a sign between them.

        Let h be rhs - lhs, and s strictly between c and x. A bound on x from the side of x holds
        for s, too; one from the side of c does, since it holds for c. So s satisfies all givens of
        the context and all hypotheses: what is proved here of x holds for s. Hence h is defined
        between c and x, its derivative D has the sign there, and h is continuous from c to x, as
        all operations are where they are defined. By the mean value theorem h(x) - h(c) is
        (x - c) D(s) for such an s, so that it has the sign of (x - c) D, or is 0 if x = c.
        """
        relation, context = claim.relation, place.context
        name = proof["variable"]
        need(name in context.variables, Malformed, "found {}, no variable of the context", name)
        x, c = context.variables[name], self.read("at", proof["at"], context)
        slopes, clearing = Slopes(self, context, x), Clearing(self, place, ())
        need(not slopes.has(c), Refused, "at: found a term in which {} occurs", name)
        for term in (claim.lhs, claim.rhs, c):
            clearing.clear(term)
        found = self.read("term", proof["term"], context)
        same = slopes.of(self.node("sub", (claim.rhs, claim.lhs))) == found
        need(same, Refused, "term: found another term than the derivative")
        good = relation in PARTS_OF_RELATION
        need(good, Refused, "found {}, expected <, <= or =", relation)
        at_c, order, sign = PARTS_OF_RELATION[relation]
        if relation == "<" and proof["strict"] == "slope":
            at_c, order, sign = "<=", "<", "<"
        is_above, zero = proof["side"] == "above", self.rational(Fraction(0))
        start = self.substitute(Claim(at_c, claim.lhs, claim.rhs), context, {x: c})
        self.premise(place, start, proof["start"])
        self.premise(place, Claim(order, *((c, x) if is_above else (x, c))), proof["order"])
        sides = (zero, found) if is_above else (found, zero)
        self.premise(place, Claim(sign, *sides), proof["sign"])
        given = [given.claim for given in context.givens] + [*place.hypotheses]
        ends = [other for g in given for other in slopes.near_end(g, is_above)]
        for end, premise in self.paired(ends, proof["bounds"]):
            self.premise(place, Claim("<=", *((end, c) if is_above else (c, end))), premise)

    def mean_value(self, place: Place, claim: Claim, proof: Proof) -> None:
        """On a box a term is its value at a point, and for each variable a slope times its change.

        Let h be rhs - lhs. The box has the intervals that the bounds show, so that the values in
        scope are one of its points; what is not a variable with an entry in ``at`` keeps its value.
        h has an enclosure on the box, so it is defined on all of it, and where its derivative D by
        a variable is, that is the derivative of h there, as in `derivative`. The point c of ``at``
        lies in the box. Go from c to the values in scope, changing one variable x after the other:
        all on the way lies in the box, so by the mean value theorem each step changes h by the
        value of D at a point of the box, times the change of x, which is at least x.low - c and
        at most x.high - c.
        """
        relation, lhs, rhs = claim
        need(relation in ("<", "<="), Refused, "found {}, expected < or <=", relation)
        box = self.enclosing(place, *precision(proof))
        centre = Enclosing(self, proof["bits"], self.grounds[proof["bits"]])
        for name, _, _ in proof["bounds"]:
            variable = self.names[name]
            need(variable not in self.definitions, Refused, "found bounds of the constant {}", name)
            centre.known[variable] = box.known[variable]
        h, changes = self.node("sub", (rhs, lhs)), []
        box.enclose(h)
        for name, text in proof["at"].items():
            x, c = place.context.variables.get(name, FREE), rational(text)
            need(x in centre.known, Refused, "at: found {}, expected a variable with bounds", name)
            low, high = box.known[x]
            need(low <= c <= high, Refused, "at: found {} outside of {}", name, box.known[x])
            if (h, x) not in self.slopes:
                self.slopes[h, x] = Slopes(self, place.context, x).of(h)
            slope = box.enclose(self.slopes[h, x])
            changes.append(box.outward(box.mul(slope, Interval(low - c, high - c))))
            centre.known[x] = Interval(c, c)
        least, zero = centre.enclose(h), Fraction(0)
        for change in changes:
            least = box.outward(box.add(least, change))
        good = HOLDS[relation](Interval(zero, zero), least)
        need(good, Refused, "found {} for rhs - lhs, expected 0 {} it", least, relation)

    def cosine(self, place: Place, claim: Claim, __: Proof) -> None:
        """The partial sums of the series of a cosine lie above it and below it, in turn.

        Integrating cos y <= 1 from 0 again and again shows this of 1 - y^2/2! + ... and cos y for
        all y, and of y - y^3/3! + ... and sin y for y >= 0. Here y is u, or pi u. As the powers
        of u in it are >= 0, coefficients may be more in a bound above, and less in one below.
        """
        is_above = self.nodes[claim.lhs].op in COSINES
        found, bound = (claim.lhs, claim.rhs) if is_above else (claim.rhs, claim.lhs)
        op = self.nodes[found].op
        good = claim.relation == "<=" and op in COSINES
        need(good, Refused, "expected <= between a cosine and a polynomial")
        (u,) = self.parts(op, found)
        Clearing(self, place, ()).clear(u)
        is_sine = op == "cos_pi" and self.nodes[bound].op == "mul"  # cos(pi/2 - y) = sin y
        if is_sine:
            half, angle = self.parts("sub", u)
            u, bound = self.parts("mul", bound)
            good = u == angle and self.nodes[half] == Node("rational", (), (1, 2))
            need(good, Refused, "expected u times a polynomial, and cos_pi(1/2 - u)")
            known = self.knows("<=", u, place) or self.knows("<", u, place)
            need(known, Refused, "found a sine of an angle that is not known to be >= 0")
        coefficients = self.coefficients(bound, u)
        good = len(coefficients) % 2 == is_above
        need(good, Refused, "found a bound on the other side, of {} terms", len(coefficients))
        for c, exact in zip(coefficients, self.series(op, is_sine), strict=False):
            good = exact.high <= c if is_above else c <= exact.low
            need(good, Refused, "found the coefficient {} on the wrong side of {}", str(c), exact)

    def coefficients(self, term: int, u: int) -> list[Fraction]:
        """The coefficients of a polynomial in u^2 that is a number c, or c + u^2 (...)."""
        numbers, square = [], Node("pow", (u,), (2,))
        while self.nodes[term].op == "add":
            number, product = self.nodes[term].subterms
            power, term = self.parts("mul", product)
            need(self.nodes[power] == square, Refused, "found no square of the angle")
            numbers.append(number)
        nodes = [self.nodes[number] for number in (*numbers, term)]
        good = all(node.op == "rational" for node in nodes)
        need(good, Refused, "found a coefficient that is no number")
        for node in nodes:
            self.spend(sum(map(size, node.rest)), 2)
        return [Fraction(*node.rest) for node in nodes]

    def series(self, op: str, is_sine: bool) -> Iterable[Interval]:
        """Intervals around the coefficients of cos u or cos(pi u), or of sin(pi u)."""
        scope, n = Enclosing(self, SERIES_BITS, None), int(is_sine)
        y = scope.pi() if op == "cos_pi" else UNIT
        exact, factor = y if is_sine else UNIT, scope.neg(scope.mul(y, y))
        while True:
            yield exact
            divisor = scope.rational((n + 1) * (n + 2), 1)
            exact, n = scope.outward(scope.div(scope.mul(exact, factor), divisor)), n + 2

    def parts(self, op: str, *terms: int) -> list[int]:
        """The subterms of terms of this operation."""
        nodes = [self.nodes[term] for term in terms]
        for node in nodes:
            need(node.op == op, Refused, "found {}, expected {}", node.op, op)
        return [part for node in nodes for part in node.subterms]

    def sum(self, place: Place, claim: Claim, proof: Proof) -> None:
        """The negation of the claim would make a positive number zero; or: an identity.

        With the two sides cleared to N/D and N'/D', D and D' > 0, the goal G = N D' - N' D has the
        sign of lhs - rhs. If < failed G would be >= 0, if <= failed it would be > 0. Addends are
        sums of products of G and of what facts say is >= 0 or > 0; an equation is worth 0. If all
        that adds up to the zero polynomial, and an addend is > 0, the negation is impossible. The
        claim = holds if G is identically a sum of multiples of equations.
        """
        clearing = Clearing(self, place, proof["using"])
        goal = clearing.difference(claim.lhs, claim.rhs)
        zeros: Polynomial = {}
        for name, cofactor in proof["equations"]:
            relation, lhs, rhs = self.fact(name, place)
            need(relation == "=", Refused, "found {}, which is no equation", name)
            factor, _ = clearing.clear(self.read("cofactor", cofactor, place.context))
            product = self.times(clearing.difference(lhs, rhs), factor)
            zeros = self.plus(zeros, product, 1)
        if claim.relation == "=":
            need(not proof["addends"], Refused, "found addends, but = has no negation")
            rest = clearing.reduce(self.plus(goal, zeros, -1))
            need(not rest, Refused, "found sides that differ, by {}", clearing.told(rest))
            return
        need(claim.relation != "!=", Refused, "found !=, expected <, <= or =")
        clearing.goal = goal, claim.relation == "<="
        total, strict = clearing.value(["add", *proof["addends"]])
        rest = clearing.reduce(self.plus(total, zeros, 1))
        need(not rest, Refused, "found a sum that is not 0, but {}", clearing.told(rest))
        need(strict, Refused, "found no addend that is positive")

    def instance(self, place: Place, claim: Claim | Applies, proof: Proof) -> None:
        """What holds for all values that satisfy the givens holds for these.

        The fact that is instanced is a fact of the context; the values are defined terms at the
        place, which lies in the parent of that context, so that all else in the fact is in scope
        and has the same meaning here; and the givens at these values are proved here.
        """
        if isinstance(claim, Applies):
            self.givens_hold(place, claim.context, claim.at, proof["givens"])
            return
        name = proof["of"]
        need(name not in self.refused, Refused, "found {}, whose proof was refused", name)
        need(name in self.facts, Malformed, "found {}, which is no fact so far", name)
        fact = self.facts[name]
        at = self.values("at", proof["at"], fact.context, place)
        self.givens_hold(place, fact.context, at, proof["givens"])
        same = self.substitute(fact.claim, fact.context, at) == claim
        need(same, Refused, "found another claim than {} at these values", name)

    def givens_hold(
        self, place: Place, context: Context, at: Mapping[int, int], premises: list[Any]
    ) -> None:
        """Afterwards the values are defined here, and all givens of the context hold for them."""
        good = context.parent is not None and place.context.is_inside(context.parent)
        need(good, Refused, "found a place outside the parent of {}", context.name)
        clearing = Clearing(self, place, ())
        for term in at.values():
            clearing.clear(term)
        for given, premise in self.paired(context.givens, premises):
            self.premise(place, self.substitute(given.claim, context, at), premise)

    def premise(self, place: Place, claim: Claim, premise: Any) -> None:
        """Afterwards the claim is proved: the premise names this very fact, or is a proof."""
        if isinstance(premise, str):
            same = self.fact(premise, place) == claim
            need(same, Refused, "found {}, which is another claim than is needed", premise)
        else:
            self.prove(place, claim, premise)

    def induction(self, place: Place, claim: Always, proof: Proof) -> None:
        """What holds at the start, and at the next state whenever at this one, holds always.

        By induction on n all givens hold of the n-th state: those that are carried by the two
        proofs, the standing ones because this is assumed of every state. Hence so do all facts.
        """
        context = claim.context
        self.spend(0, len(context.givens))
        need(context.parent is place.context, Refused, "found {} elsewhere", context.name)
        carried = [given for given in context.givens if given.kind == "carried"]
        plain = [given.name for given in context.givens if given.kind == "plain"]
        need(not plain, Refused, "found givens that are neither carried nor standing: {}", plain)
        inside = Place(context)
        for key, at, here in (("start", claim.start, place), ("next", claim.next, inside)):
            clearing = Clearing(self, here, ())
            for term in at.values():
                clearing.clear(term)
            for given, premise in self.paired(carried, proof[key]):
                self.premise(here, self.substitute(given.claim, context, at), premise)

    def witness(self, place: Place, claim: Claim, proof: Proof) -> None:
        """Not for all values: at these, which satisfy the givens, the negation holds.

        The values are terms of the parent context, which has a point, so that there are values.
        """
        context = place.context
        need(context.parent is not None, Refused, "found a witness, but no variable")
        outside = Place(context.parent or context)
        at = self.values("at", proof["at"], context, outside)
        self.givens_hold(outside, context, at, proof["givens"])
        self.prove(outside, negated(self.substitute(claim, context, at)), proof["negation"])

    def prove(self, place: Place, claim: Claim, proof: Any) -> None:
        """Afterwards the claim is a fact at the place."""
        RULES[rule_of(proof, RULES)][0](self, place, claim, proof)

    def define(self, place: Place, term: int, proof: Any) -> None:
        """Afterwards a term has a value at the place: it clears, or it has an enclosure."""
        if rule_of(proof, DEFINING) == "define":
            Clearing(self, place, ()).clear(term)
        else:
            self.enclosing(place, *precision(proof)).enclose(term)

    def open(self, outside: Place, context: Context, premises: list[Any]) -> None:
        """Afterwards the givens are facts of the context: it has a point, so it is not empty.

        Outside is its parent. What they say of the point is proved there.
        """
        clearing = Clearing(self, outside, ())
        for term in context.point.values():
            clearing.clear(term)
        for given, premise in self.paired(context.givens, premises):
            self.premise(outside, self.substitute(given.claim, context, context.point), premise)
            inside = Clearing(self, Place(context), ())
            inside.clear(given.claim.lhs), inside.clear(given.claim.rhs)
            self.install(given.name, given.claim, context)
        self.opened.add(context)

    def enclosing(self, place: Place, bits: int, bounds: Sequence[Any] = ()) -> Enclosing:
        """Enclosures at a precision, with bounds on names from usable facts."""
        if bits not in self.grounds:
            self.grounds[bits] = Enclosing(self, bits, None)
        if not bounds:
            return self.grounds[bits]
        scope = Enclosing(self, bits, self.grounds[bits])
        for name, lower, upper in bounds:
            need(name in self.names, Malformed, "bounds: found {}, which is no name", name)
            term, found = self.names[name], []
            good = term not in scope.known and not self.is_ground(term)
            need(good, Refused, "found bounds of {}, whose value is known", name)
            for fact, side in ((lower, 2), (upper, 1)):
                claim = self.fact(fact, place)
                other = {claim.lhs: claim.rhs} if side == 1 else {claim.rhs: claim.lhs}
                if claim.relation == "=":
                    other = {claim.lhs: claim.rhs, claim.rhs: claim.lhs}
                need(term in other, Refused, "found {}, which does not bound {}", fact, name)
                found.append(scope.enclose(other[term])[2 - side])
            need(found[0] <= found[1], Refused, "found bounds of {} that exclude each other", name)
            scope.known[term] = Interval(*found)
        return scope

    def paired(self, expected: Sequence[Any], proofs: Sequence[Any]) -> Iterable[tuple[Any, Any]]:
        """Each thing that is to be proved with its proof."""
        good = len(proofs) == len(expected)
        need(good, Malformed, "found {} proofs, expected {}", len(proofs), len(expected))
        return zip(expected, proofs, strict=True)

    # --- polynomials ----------------------------------------------------------------------------

    def plus(self, a: Polynomial, b: Polynomial, factor: int) -> Polynomial:
        """The sum of a and of b times an integer."""
        self.spend(0, 1 + len(a))
        total = dict(a)
        for monomial, coefficient in b.items():
            before = total.get(monomial, 0)
            times = (1 if type(coefficient) is int else 2) + (len(monomial) >> 4)
            self.spend(size(before) + size(coefficient), times)
            value = before + factor * coefficient
            if value:
                total[monomial] = value
            else:
                total.pop(monomial, None)
        return total

    def times(self, a: Polynomial, b: Polynomial) -> Polynomial:
        """The product."""
        if ONE in (a, b):
            return b if a == ONE else a
        self.spend(0, 1 + len(a))
        total: Polynomial = {}
        for m, c in a.items():
            for n, d in b.items():
                monomial = self.merged(m, n) if m and n else m or n
                before = total.get(monomial, 0)
                self.spend(size(before) + size(c) + size(d), 1 + len(monomial))
                total[monomial] = before + c * d
        return {monomial: whole(value) for monomial, value in total.items() if value}

    def merged(self, m: Monomial, n: Monomial) -> Monomial:
        """The product of two monomials."""
        exponents = dict(m)
        for atom, exponent in n:
            exponents[atom] = exponents.get(atom, 0) + exponent
            need(exponents[atom] <= MAX_DEGREE, Malformed, "found a degree above 2^20")
        return tuple(sorted(exponents.items()))

    def power(self, base: Polynomial, exponent: int) -> Polynomial:
        """The power with a natural exponent."""
        if base == ONE:
            return ONE  # whose products are not counted as work
        result = ONE
        for _ in range(exponent):
            result = self.times(result, base)
        return result

    # --- reading terms and claims ---------------------------------------------------------------

    def read(self, where: str, value: Any, context: Context) -> int:
        """The term that is written over the names in scope."""
        term = self.parse(where, value)
        good = context.is_inside(self.homes[term])
        message = "{}: found a name of {}, which is not in scope"
        need(good, Malformed, message, where, self.homes[term].name)
        return term

    def parse(self, where: str, value: Any) -> int:
        """The term that is written over any names."""
        if isinstance(value, str):
            return self.parse_leaf(where, value)
        op, *args = value if isinstance(value, list) and value else [""]
        if op in INDEXED:
            fits(where, tuple_of(anything, exponent if op == "pow" else index), args)
            return self.node(op, [self.parse(where, args[0])], int(args[1]))
        known = isinstance(op, str) and op in ARITY_OR_MORE
        need(known, Malformed, "{}: found {}, expected a term", where, value)
        arity = ARITY_OR_MORE[op]
        good = len(args) > 1 if arity is None else len(args) == arity
        need(good, Malformed, "{}: found {}, expected other numbers of terms", where, value)
        return self.node(op, [self.parse(where, arg) for arg in args])

    def parse_leaf(self, where: str, value: str) -> int:
        """The term of a name, of an abbreviation, or of a rational number."""
        name = self.prefix + value
        if name in self.names:
            return self.names[name]
        if name in self.shared:
            self.abbreviations[name] = self.parse(name, self.shared.pop(name))
        if name in self.abbreviations:
            return self.abbreviations[name]
        good = is_rational(value)
        need(good, Malformed, "{}: found {}, which is no name so far and no number", where, value)
        number = rational(value)
        self.spend(size(number))
        return self.rational(number)

    def read_claim(self, where: str, value: Any, context: Context) -> Claim:
        """The claim that compares two terms."""
        good = isinstance(value, list) and len(value) == 3 and isinstance(value[0], str)
        good = good and value[0] in NEGATION
        need(good, Malformed, "{}: found {}, expected [<, <= or =, lhs, rhs]", where, value)
        lhs, rhs = (self.read(where, side, context) for side in value[1:])
        return Claim(value[0], lhs, rhs)

    def values(self, where: str, value: Any, context: Context, place: Place) -> dict[int, int]:
        """The terms, over the names at a place, that a table has for the variables of a context."""
        names = {name.rpartition(":")[2]: term for name, term in context.variables.items()}
        odd = sorted(names.keys() ^ value.keys())
        need(not odd, Malformed, "{}: found too many or too few variables: {}", where, odd)
        return {names[name]: self.read(where, text, place.context) for name, text in value.items()}


def key(op: str, subterms: Sequence[int], rest: Sequence[int]) -> tuple[Any, ...]:
    """What tells a node from others, with a hash that a file cannot foresee."""
    if op == "rational":
        return (*map(hex, rest),)
    return op, *subterms, *rest


def negated(claim: Claim) -> Claim:
    """The negation of a claim whose sides are defined."""
    return Claim(NEGATION[claim.relation], claim.rhs, claim.lhs)


class Clearing:
    """Terms without fractions, at a place, after replacing atoms by what equations say they are.

    A cleared term is a pair of polynomials N and D in atoms, where D > 0 and the term is defined
    and equal to N/D, for all values in scope. ``radicands`` has, for each root among the atoms,
    its radicand; roots come after those in their radicands.
    """

    def __init__(self, kernel: Kernel, place: Place, using: Sequence[str]) -> None:
        self.kernel, self.place = kernel, place
        self.replaced: dict[int, int] = {}
        for name in using:
            relation, atom, term = kernel.fact(name, place)
            good = relation == "=" and kernel.nodes[atom].op in ATOMS
            need(good, Refused, "using: found {}, expected an equation for an atom", name)
            need(atom not in self.replaced, Refused, "using: found {} for an atom again", name)
            self.replaced[atom] = term
        alone = not using and not place.hypotheses  # what clears here will do so later, too
        new: Cleared = {}, {}
        known = kernel.cleared.setdefault(place.context, new) if alone else new
        self.cleared, self.radicands = known
        self.busy: set[int] = set()
        self.goal: tuple[Polynomial, bool] = {}, False

    def clear(self, term: int) -> Quotient:
        """The cleared term."""
        if term not in self.cleared:
            need(term not in self.busy, Refused, "using: found equations in a circle")
            need(len(self.busy) < 2 * MAX_HEIGHT, Malformed, "found equations that are too deep")
            self.busy.add(term)
            node = self.kernel.nodes[term]
            self.kernel.spend(0, 2 + len(node.subterms))
            if term in self.replaced:
                result = self.clear(self.replaced[term])
            else:
                result = CLEARED[node.op](self, term, node)
            self.busy.discard(term)
            self.cleared[term] = result
        return self.cleared[term]

    def atom(self, term: int, node: Node) -> Quotient:
        """A name that has a value, or another operation that is defined, of cleared terms."""
        kernel = self.kernel
        if node.op == "name":
            good = term in kernel.defined or term not in kernel.definitions
            need(good, Refused, "found a constant before its definition is proved to have a value")
        if node.op in ROOTS or node.op == "log":
            inner, is_root = node.subterms[0], node.op in ROOTS
            op, _, rest = kernel.nodes[inner]
            known = op == "rational" and (rest[0] > 0 or (rest[0] == 0 and is_root))
            known = known or kernel.knows("<", inner, self.place)
            known = known or (is_root and kernel.knows("<=", inner, self.place))
            message = "found the {} of a term that is not known to be {} 0"
            words = ("root", ">=") if is_root else ("logarithm", ">")
            need(known, Refused, message, *words)
        parts = [self.clear(part) for part in node.subterms]
        if node.op in ROOTS:
            self.radicands[term] = parts[0]
        return {((term, 1),): 1}, ONE

    def number(self, term: int, node: Node) -> Quotient:
        """A rational number."""
        value = self.kernel.number(term, *node.rest)
        return {(): value} if value else {}, ONE

    def added(self, _: int, node: Node) -> Quotient:
        """A sum or difference; equal denominators are kept."""
        (n, d), (m, e) = map(self.clear, node.subterms)
        self.kernel.spend(0, sum(map(len, d)) + len(d))
        sign, times = 1 if node.op == "add" else -1, self.kernel.times
        if d == e:
            return self.kernel.plus(n, m, sign), d
        return self.kernel.plus(times(n, e), times(m, d), sign), times(d, e)

    def negative(self, _: int, node: Node) -> Quotient:
        """The negative of a term."""
        n, d = self.clear(node.subterms[0])
        return self.kernel.plus({}, n, -1), d

    def multiplied(self, _: int, node: Node) -> Quotient:
        """A product."""
        (n, d), (m, e) = map(self.clear, node.subterms)
        return self.kernel.times(n, m), self.kernel.times(d, e)

    def raised(self, _: int, node: Node) -> Quotient:
        """A power."""
        n, d = self.clear(node.subterms[0])
        return self.kernel.power(n, *node.rest), self.kernel.power(d, *node.rest)

    def divided(self, _: int, node: Node) -> Quotient:
        """A quotient, where the divisor is a number, or known to be positive or negative."""
        kernel, divisor = self.kernel, node.subterms[1]
        (n, d), (m, e) = map(self.clear, node.subterms)
        node = kernel.nodes[divisor]
        if node.op == "rational" and node.rest[0]:
            return kernel.times(n, {(): Fraction(node.rest[1], node.rest[0])}), d
        opposite = kernel.index.get(key("neg", (divisor,), ()), -1)
        sign = 1 if kernel.knows("<", divisor, self.place) else -1
        known = sign == 1 or kernel.knows("<", opposite, self.place)
        need(known, Refused, "found a division by a term that is not known to be > 0 or < 0")
        n, m = kernel.plus({}, n, sign), kernel.plus({}, m, sign)
        return kernel.times(n, e), kernel.times(d, m)

    def difference(self, lhs: int, rhs: int) -> Polynomial:
        """A polynomial with the sign of lhs - rhs: N D' - N' D."""
        (n, d), (m, e) = self.clear(lhs), self.clear(rhs)
        return self.kernel.plus(self.kernel.times(n, e), self.kernel.times(m, d), -1)

    def value(self, item: Any) -> tuple[Polynomial, bool]:
        """A polynomial that is >= 0 for all values in scope, and whether it is > 0 for all."""
        if isinstance(item, str):
            return self.goal if item == "goal" else self.known(item)
        good = isinstance(item, list) and item and item[0] in VALUES
        need(good, Malformed, "found {}, expected a value that is >= 0", item)
        kind = item[0]
        if kind in ("square", "root"):
            fits(kind, tuple_of(anything, anything), item)
            term = self.kernel.read(kind, item[1], self.place.context)
            root = self.kernel.nodes[term].op in ROOTS or kind == "square"
            need(root, Refused, "root: found another term")
            n, _ = self.clear(term)
            return (self.kernel.times(n, n) if kind == "square" else n), False
        if kind == "pow":
            fits("pow", tuple_of(anything, anything, exponent), item)
            p, strict = self.value(item[1])
            return self.kernel.power(p, int(item[2])), strict
        parts = [self.value(part) for part in item[1:]]
        total: Polynomial = {} if kind == "add" else ONE
        for p, _ in parts:
            total = self.kernel.plus(total, p, 1) if kind == "add" else self.kernel.times(total, p)
        flags = [strict for _, strict in parts]
        return total, any(flags) if kind == "add" else all(flags)

    def known(self, name: str) -> tuple[Polynomial, bool]:
        """A number >= 0, or the difference of the sides of a usable inequality."""
        if is_rational(name):
            number = rational(name)
            need(number >= 0, Refused, "found {}, expected a number >= 0", name)
            return {(): number} if number else {}, number > 0
        relation, lhs, rhs = self.kernel.fact(name, self.place)
        need(relation in ("<", "<="), Refused, "found {}, which is no inequality", name)
        return self.difference(rhs, lhs), relation == "<"

    def reduce(self, p: Polynomial) -> Polynomial:
        """The polynomial, times a positive one, after replacing powers of roots, latest first."""
        for atom in reversed(self.radicands):
            self.kernel.spend(0, 1 + sum(map(len, p)))
            index = (*self.kernel.nodes[atom].rest, 2)[0]
            top = max((dict(monomial).get(atom, 0) // index for monomial in p), default=0)
            p = self.without_powers(p, atom, index, top) if top else p
        return p

    def told(self, p: Polynomial) -> str:
        """Some monomials of a polynomial, for a message."""
        if not p:
            return "0"
        parts = []
        for monomial, coefficient in islice(p.items(), MAX_TOLD):
            bits = size(coefficient)
            factors = [str(coefficient) if bits < MAX_SHOWN else f"(a number of {bits} bits)"]
            for atom, exponent in monomial[:MAX_TOLD]:
                name = self.kernel.labels.get(atom, f"{self.kernel.nodes[atom].op}(...)")
                factors.append(name if exponent == 1 else f"{name}^{exponent}")
            parts.append("*".join(factors))
        left = len(p) - len(parts)
        return " + ".join(parts) + (f" + {left} monomials" if left > 0 else "")

    def without_powers(self, p: Polynomial, atom: int, index: int, top: int) -> Polynomial:
        """The polynomial times d^top, where root^index = n/d, without powers from that on.

        In p the exponents of the root are below index (top + 1).
        """
        n, d = self.radicands[atom]
        total: Polynomial = {}
        for monomial, coefficient in p.items():
            whole_times, odd = divmod(dict(monomial).get(atom, 0), index)
            left = [pair for pair in monomial if pair[0] != atom] + [(atom, odd)] * (odd > 0)
            part: Polynomial = {tuple(sorted(left)): coefficient}
            for factor, times in ((n, whole_times), (d, top - whole_times)):
                part = self.kernel.times(part, self.kernel.power(factor, times))
            total = self.kernel.plus(total, part, 1)
        return total


class Slopes:
    """Derivatives of terms by a variable of a context.

    Where such a term is defined, it is the derivative: nothing in it is left out because it is 0,
    so that roots and logarithms of what depends on the variable keep their divisors.
    """

    def __init__(self, kernel: Kernel, context: Context, x: int) -> None:
        self.kernel, self.context, self.x = kernel, context, x

    def moving(self, term: int) -> dict[int, bool]:
        """For the parts of a term that lie in the context, whether the variable occurs in them."""
        kernel = self.kernel
        found: dict[int, bool] = {}
        for part in kernel.below((term,), lambda part: kernel.homes[part] is not self.context):
            inner = [*kernel.nodes[part].subterms, kernel.definitions.get(part, -1)]
            found[part] = part == self.x or any(found.get(arg, False) for arg in inner)
        return found

    def has(self, term: int) -> bool:
        """Whether the variable occurs in a term, or in the definition of a name in it."""
        return self.moving(term).get(term, False)

    def near_end(self, claim: Claim, is_above: bool) -> list[int]:
        """The end of a bound on the variable below (or above) it; refused for another claim."""
        self.kernel.spend(0, 4)
        if not self.has(claim.lhs) and not self.has(claim.rhs):
            return []
        is_lower = claim.rhs == self.x
        end = claim.lhs if is_lower else claim.rhs
        good = self.x in (claim.lhs, claim.rhs) and claim.relation in ("<", "<=")
        need(good and not self.has(end), Refused, "found a given that is no bound of the variable")
        return [end] if is_lower == is_above else []

    def of(self, term: int) -> int:
        """The derivative of a term in which the variable occurs."""
        kernel, moving = self.kernel, self.moving(term)
        need(moving.get(term), Refused, "found sides in which the variable does not occur")
        slopes = {self.x: self.number(1)}
        for part in (part for part in moving if moving[part] and part != self.x):
            node = kernel.nodes[part]
            inner = [slopes.get(arg, FREE) for arg in node.subterms]
            if part in kernel.definitions:
                slopes[part] = slopes[kernel.definitions[part]]
            elif node.op in BY_PARTS:
                slopes[part] = BY_PARTS[node.op](self, *node.subterms, *inner)
            else:
                slopes[part] = self.chain(part, node, inner[0])
        return slopes[term]

    def number(self, value: int) -> int:
        """The term of a number."""
        return self.kernel.rational(Fraction(value))

    def node(self, op: str, *terms: int) -> int:
        """The term of an operation."""
        return self.kernel.node(op, terms)

    def times(self, a: int, b: int) -> int:
        """The product of two terms, one of which may be 1."""
        if self.number(1) in (a, b):
            return b if a == self.number(1) else a
        return self.node("mul", a, b)

    def power(self, a: int, n: int) -> int:
        """A power, or the term itself."""
        return a if n == 1 else self.kernel.node("pow", (a,), n)

    def added(self, _: int, __: int, da: int, db: int) -> int:
        """(a + b)' = a' + b'."""
        if FREE in (da, db):
            return da if db == FREE else db
        return self.node("add", da, db)

    def subtracted(self, _: int, __: int, da: int, db: int) -> int:
        """(a - b)' = a' - b'."""
        if FREE in (da, db):
            return da if db == FREE else self.node("neg", db)
        return self.node("sub", da, db)

    def negative(self, _: int, da: int) -> int:
        """(-a)' = -a'."""
        return self.node("neg", da)

    def multiplied(self, a: int, b: int, da: int, db: int) -> int:
        """(a b)' = b a' + a b'."""
        if FREE in (da, db):
            return self.times(b, da) if db == FREE else self.times(a, db)
        return self.node("add", self.times(b, da), self.times(a, db))

    def divided(self, a: int, b: int, da: int, db: int) -> int:
        """(a/b)' = (b a' - a b')/b^2."""
        if db == FREE:
            return self.node("div", da, b)
        square = self.power(b, 2)
        if da == FREE:
            return self.node("neg", self.node("div", self.times(a, db), square))
        change = self.node("sub", self.times(b, da), self.times(a, db))
        return self.node("div", change, square)

    def chain(self, part: int, node: Node, da: int) -> int:
        """f(a)' = f'(a) a'."""
        op, subterms, rest = node
        need(op in CHAINED, Refused, "found no derivative of {}", op)
        a, n = subterms[0], (*rest, 2)[0]
        if op == "pow":
            scaled = self.node("mul", self.number(n), self.power(a, n - 1)) if n > 1 else None
            return da if scaled is None else self.times(scaled, da)
        if op in ROOTS:
            return self.node("div", da, self.node("mul", self.number(n), self.power(part, n - 1)))
        if op == "log":
            return self.node("div", da, a)
        if op == "atan":
            return self.node("div", da, self.node("add", self.number(1), self.power(a, 2)))
        if op in ("exp", "sin"):
            return self.times(part if op == "exp" else self.node("cos", a), da)
        outer = self.node("sin", a)
        if op == "cos_pi":
            pi = self.node("pi")
            outer = self.node("mul", pi, self.node("sin", self.node("mul", pi, a)))
        return self.node("neg", self.times(outer, da))


FREE = -1  # stands for the derivative of a term in which the variable does not occur
#: The operations of whose derivatives the derivatives of all subterms are parts, and functions.
BY_PARTS: dict[str, Callable[..., int]] = {
    "add": Slopes.added,
    "sub": Slopes.subtracted,
    "neg": Slopes.negative,
    "mul": Slopes.multiplied,
    "div": Slopes.divided,
}
CHAINED = ("pow", "root", *FUNCTIONS)


#: How each operation is cleared.
CLEARED: dict[str, Callable[[Clearing, int, Node], Quotient]] = {
    **dict.fromkeys(ATOMS, Clearing.atom),
    "rational": Clearing.number,
    "add": Clearing.added,
    "sub": Clearing.added,
    "neg": Clearing.negative,
    "mul": Clearing.multiplied,
    "pow": Clearing.raised,
    "div": Clearing.divided,
}
VALUES = ("square", "root", "add", "mul", "pow")


# --- enclosures ----------------------------------------------------------------------------------


class Enclosing:
    """Intervals around terms at one precision, for given ones of some names.

    The result of an operation on intervals encloses its results for all real numbers in them.
    ``base`` has the enclosures of terms without variables.
    """

    def __init__(self, kernel: Kernel, bits: int, base: Enclosing | None) -> None:
        self.kernel, self.bits, self.base = kernel, bits, base
        self.known: dict[int, Interval] = {}
        self.pi_known: Interval | None = None

    def enclose(self, term: int) -> Interval:
        """An interval around the value of a term; refused where it may be undefined."""
        kernel, base = self.kernel, self.base

        def is_leaf(part: int) -> bool:
            return part in self.known or (base is not None and kernel.is_ground(part))

        for part in kernel.below((term,), is_leaf):
            op, subterms, rest = kernel.nodes[part]
            if part in kernel.definitions:
                self.known[part] = self.value(kernel.definitions[part])
                continue
            need(op != "name", Refused, "found a variable without bounds")
            xs = [self.value(arg) for arg in subterms]
            for low, high in xs:
                kernel.spend(size(low) + size(high), 2)
            self.known[part] = self.outward(OPERATIONS[op](self, *xs, *rest))
        low, high = self.value(term)
        kernel.spend(size(low) + size(high), 2)
        return Interval(low, high)

    def value(self, term: int) -> Interval:
        """The interval of a term that is evaluated already, or has no variables."""
        if term in self.known or self.base is None:
            return self.known[term]
        return self.base.enclose(term)

    def outward(self, x: Interval) -> Interval:
        """x, or an interval around it with shorter ends."""
        return Interval(self.shorter(x.low, 1), self.shorter(x.high, -1))

    def shorter(self, end: Fraction, sign: int) -> Fraction:
        """The number, or a shorter one that is a little smaller (greater, if the sign is -1)."""
        length = size(end)
        self.kernel.spend(length)
        if length <= 2 * self.bits:
            return end
        n, d = sign * end.numerator, end.denominator
        shift = self.bits - n.bit_length() + d.bit_length()
        if shift < 0:
            return Fraction(sign * (n // (d << -shift) << -shift))
        return Fraction(sign * ((n << shift) // d), 1 << shift)

    def add(self, x: Interval, y: Interval) -> Interval:
        """Addition is increasing in both terms."""
        return Interval(x.low + y.low, x.high + y.high)

    def sub(self, x: Interval, y: Interval) -> Interval:
        """Subtraction is increasing in the first term and decreasing in the second."""
        return Interval(x.low - y.high, x.high - y.low)

    def neg(self, x: Interval) -> Interval:
        """Negation is decreasing."""
        return Interval(-x.high, -x.low)

    def mul(self, x: Interval, y: Interval) -> Interval:
        """A product is linear in each factor, so that its extremes are products of ends."""
        (a, b), (c, d) = x, y
        if a.numerator >= 0 and c.numerator >= 0:
            return Interval(a * c, b * d)
        ends = (a * c, a * d, b * c, b * d)
        return Interval(min(ends), max(ends))

    def div(self, x: Interval, y: Interval) -> Interval:
        """On an interval without 0 the inverse falls."""
        need(y.low > 0 or y.high < 0, Refused, "found a division by {}, which contains 0", y)
        return self.mul(x, Interval(1 / y.high, 1 / y.low))

    def power(self, x: Interval, n: int) -> Interval:
        """Odd powers rise; an even power is that of the absolute value, and rises with it."""
        low, high = x
        if n % 2 == 0 and low < 0:
            low, high = max(Fraction(0), -high), max(-low, high)
        return Interval(self.powers(low, n).low, self.powers(high, n).high)

    def powers(self, end: Fraction, n: int) -> Interval:
        """An interval around a power of one number."""
        if n == 1:
            return Interval(end, end)
        half = self.outward(self.powers(end, n // 2))
        square = self.mul(half, half)
        return self.mul(square, Interval(end, end)) if n % 2 else square

    def sqrt(self, x: Interval) -> Interval:
        """The root of n/d is that of 4^bits nd, which lies between integers, over 2^bits d."""
        need(x.low >= 0, Refused, "found a square root of {}, which reaches below 0", x)
        ends = []
        for n, d in map(Fraction.as_integer_ratio, x):
            square = n * d << 2 * self.bits
            self.kernel.spend(square.bit_length())
            root = isqrt(square)
            ends += [Fraction(root + i, d << self.bits) for i in (0, root * root < square)]
        return Interval(ends[0], ends[3])

    def least(self, *xs: Interval) -> Interval:
        """A minimum rises with each entry."""
        return Interval(min(x.low for x in xs), min(x.high for x in xs))

    def greatest(self, *xs: Interval) -> Interval:
        """A maximum rises with each entry."""
        return Interval(max(x.low for x in xs), max(x.high for x in xs))

    def rational(self, n: int, d: int) -> Interval:
        """A rational number."""
        value = Fraction(n, d)
        return Interval(value, value)

    def cos(self, x: Interval) -> Interval:
        """A cosine of x is a cosine of pi times x/pi."""
        return self.cos_pi(self.outward(self.div(x, self.pi())))

    def cos_pi(self, x: Interval) -> Interval:
        """Between its ends cos(pi x) has its extremes at the integers k, where it is (-1)^k."""
        first = -(-x.low // 1)
        extremes = [(-1) ** (k % 2) for k in (first, first + 1) if k <= x.high]
        ends = [self.cos_pi_at(end) for end in x]
        return Interval(
            min([end.low for end in ends] + [Fraction(e) for e in extremes]),
            max([end.high for end in ends] + [Fraction(e) for e in extremes]),
        )

    def cos_pi_at(self, x: Fraction) -> Interval:
        """cos(pi x), cut to [-1, 1], where x may be shifted by an even number into [-1, 1].

        At -1, -1/2, 0 and 1/2 it is 1 - 2 |x|. Elsewhere:
        For |y| <= 4 the sum over k <= m of (-1)^k y^(2k)/(2k)!, here 1 - y^2/2 (1 - y^2/12 (...)),
        is off by at most 4^n/n! < (4e/n)^n < 2^-n for n = 2m + 2 >= 22 (Taylor's theorem: the
        derivatives of cos are bounded by 1).
        """
        turned = x - (x + 1) // 2 * 2
        if turned.denominator <= 2:
            return Interval(1 - 2 * abs(turned), 1 - 2 * abs(turned))
        y = self.mul(Interval(turned, turned), self.pi())
        ratios = ((1, 2 * k * (2 * k - 1)) for k in range(self.bits // 2 + 11, 0, -1))
        low, high = self.nested(self.neg(self.power(y, 2)), (1, 1), ratios)
        error = Fraction(1, 1 << self.bits)
        return Interval(max(low - error, -UNIT.low), min(high + error, UNIT.high))

    def nested(
        self, x: Interval, last: tuple[int, int], ratios: Iterable[tuple[int, int]]
    ) -> Interval:
        """1 + x p/d t for each ratio p/d, where t is what the one before gave.

        The first t lies between the integers ``last``. All is in units of 2^-(bits + 32).
        """
        shift = self.bits + 32
        one = 1 << shift
        low, high = x.low * one // 1, -(-x.high * one // 1)
        least, most = last[0] * one, last[1] * one
        for p, d in ratios:
            self.kernel.spend(shift, 2)
            products = [low * least, low * most, high * least, high * most]
            down, up = min(products) >> shift, -max(products) >> shift
            least, most = one + down * p // d, one - up * p // d
        return Interval(Fraction(least, one), Fraction(most, one))

    def sin(self, x: Interval) -> Interval:
        """A sine of x is a cosine of pi times 1/2 - x/pi."""
        half = self.rational(1, 2)
        return self.cos_pi(self.outward(self.sub(half, self.div(x, self.pi()))))

    def exp(self, x: Interval) -> Interval:
        """An exponential rises."""
        return Interval(self.exp_at(x.low).low, self.exp_at(x.high).high)

    def exp_at(self, x: Fraction) -> Interval:
        """For x > 0 this is exp(x/n)^n, where 0 < x/n <= 1/256; and exp(-x) = 1/exp x.

        With r = x/n the sum of r^k/k! is 1 + r/1 (1 + r/2 (1 + ...)), and each bracket lies between
        1 and exp r < 2. For the power there are 48 bits more, as n may have 24.
        """
        if x < 0:
            if x < -MAX_EXPONENT:
                return Interval(Fraction(0), Fraction(1, 1 << MAX_EXPONENT))
            return self.div(UNIT, self.exp_at(-x))
        need(x <= MAX_EXPONENT, Refused, "found an exponential of {}", Interval(x, x))
        n, fine = -(-256 * x // 1), Enclosing(self.kernel, self.bits + 48, None)
        if n == 0:
            return UNIT
        part = fine.rational(x.numerator, x.denominator * n)
        low, high = fine.nested(part, (1, 2), ((1, k) for k in range(self.bits // 8 + 12, 0, -1)))
        return Interval(fine.powers(low, n).low, fine.powers(high, n).high)

    def log(self, x: Interval) -> Interval:
        """A logarithm rises, and is defined above 0."""
        need(x.low > 0, Refused, "found a logarithm of {}, which reaches 0", x)
        return Interval(self.log_at(x.low).low, self.log_at(x.high).high)

    def log_at(self, x: Fraction) -> Interval:
        """For x = 2^k y, 1 <= y < 2, this is k log 2 + log y; and log(1/x) = -log x.

        Here log y is twice the inverse hyperbolic tangent of (y - 1)/(y + 1), log 2 that of 1/3.
        """
        n, d = x.numerator, x.denominator
        self.kernel.spend(size(x), 4)
        if n < d:
            return self.neg(self.log_at(Fraction(d, n)))
        k = (n // d).bit_length() - 1
        two, rest = Fraction(1, 3), Fraction(n - (d << k), n + (d << k))
        halves = self.mul(self.rational(k, 1), self.inverse(two, 1))
        return self.mul(self.rational(2, 1), self.add(halves, self.inverse(rest, 1)))

    def atan(self, x: Interval) -> Interval:
        """An inverse tangent rises."""
        return Interval(self.atan_at(x.low).low, self.atan_at(x.high).high)

    def atan_at(self, x: Fraction) -> Interval:
        """atan(-x) = -atan x, and for x > 0 what is added to pi/2 or pi/4 is at most 3/7 in size.

        These are the angles of (1 + ix)/(1 + i) = (1 + x + i(x - 1))/2 and of (1 + ix)/i = x - i.
        """
        self.kernel.spend(size(x), 4)
        if x < 0:
            return self.neg(self.atan_at(-x))
        if x > Fraction(5, 2):
            return self.add(self.mul(self.pi(), self.rational(1, 2)), self.inverse(-1 / x, -1))
        if x > Fraction(2, 5):
            rest = self.inverse((x - 1) / (x + 1), -1)
            return self.add(self.mul(self.pi(), self.rational(1, 4)), rest)
        return self.inverse(x, -1)

    def inverse(self, z: Fraction, sign: int) -> Interval:
        """The inverse hyperbolic tangent of z (sign 1) or its inverse tangent (-1), |z| <= 3/7.

        This is z times the sum of q^j/(2j + 1), where q = z^2 or -z^2, or 1 + q/3 (1 + 3q/5 (...)).
        Each bracket lies between 0 and 2, as its terms are less than those of the sum of |q|^j.
        """
        self.kernel.spend(2 * size(z), 2)
        q, count = sign * z * z, self.bits // 2 + 18
        ratios = ((2 * j + 1, 2 * j + 3) for j in range(count, -1, -1))
        return self.mul(Interval(z, z), self.nested(Interval(q, q), (0, 2), ratios))

    def root(self, x: Interval, k: int) -> Interval:
        """The root of n/d is that of 2^(k bits) n d^(k-1), between integers, over 2^bits d."""
        need(x.low >= 0, Refused, "found a root of {}, which reaches below 0", x)
        ends = []
        for n, d in map(Fraction.as_integer_ratio, x):
            self.kernel.spend(k * (size(n) + size(d) + self.bits))
            power = n * d ** (k - 1) << k * self.bits
            root = self.whole_root(power, k)
            ends += [Fraction(root + i, d << self.bits) for i in (0, root**k < power)]
        return Interval(ends[0], ends[3])

    def whole_root(self, power: int, k: int) -> int:
        """The greatest integer whose k-th power is at most this one, by Newton's method.

        From above each step stays above the root or ends there, as k-th powers are convex.
        """
        root = 1 << -(-power.bit_length() // k)
        while power:
            self.kernel.spend(power.bit_length(), 2)
            lower = ((k - 1) * root + power // root ** (k - 1)) // k
            if lower >= root:
                return root
            root = lower
        return 0

    def pi(self) -> Interval:
        """Machin's formula, pi = 16 arctan(1/5) - 4 arctan(1/239).

        arctan(1/n) is the alternating, decreasing sum of (-1)^k / ((2k+1) n^(2k+1)). ``scaled`` is
        floor(2^bits / n^(2k+1)), as nested floors are one floor, so that each term, and the rest
        of the sum, is off by less than 2^-bits.
        """
        if self.pi_known is None:
            bits, total, error = self.bits + 32, 0, 0
            for factor, n in ((16, 5), (-4, 239)):
                scaled, k = (1 << bits) // n, 0
                while scaled:
                    self.kernel.spend(0, 1 + bits // 2000)
                    total += factor * (-1 if k % 2 else 1) * (scaled // (2 * k + 1))
                    scaled, k = scaled // (n * n), k + 1
                error += abs(factor) * (k + 1)
            ends = [Fraction(total + sign * error, 1 << bits) for sign in (-1, 1)]
            self.pi_known = Interval(*ends)
        return self.pi_known


OPERATIONS: dict[str, Callable[..., Interval]] = {
    "rational": Enclosing.rational,
    "add": Enclosing.add,
    "sub": Enclosing.sub,
    "neg": Enclosing.neg,
    "mul": Enclosing.mul,
    "div": Enclosing.div,
    "pow": Enclosing.power,
    "sqrt": Enclosing.sqrt,
    "min": Enclosing.least,
    "max": Enclosing.greatest,
    "cos": Enclosing.cos,
    "cos_pi": Enclosing.cos_pi,
    "sin": Enclosing.sin,
    "exp": Enclosing.exp,
    "log": Enclosing.log,
    "atan": Enclosing.atan,
    "root": Enclosing.root,
    "pi": Enclosing.pi,
}


# --- shapes of JSON values -----------------------------------------------------------------------

Shape = Callable[[Any], None]  # it complains of a value, with the way to the part that is wrong

BRACKETS = dict, list
NAME = "[A-Za-z][A-Za-z0-9_.-]{0,99}"
HYPOTHESIS = "@[1-9][0-9]{0,2}"
RATIONAL = "-?(0|[1-9][0-9]{0,4299})(/[1-9][0-9]{0,4299})?"  # int() reads at most 4300 digits
DECIMAL = r"-?(0|[1-9][0-9]{0,99})(\.[0-9]{1,99})?(e-?[0-9]{1,5})?"
is_rational = re.compile(RATIONAL).fullmatch
rational = cache(Fraction)  # the value of a text


def fits(where: str, shape: Shape, value: Any) -> None:
    """Afterwards a value, which is found there, has the shape."""
    try:
        shape(value)
    except Malformed as error:
        raise Malformed(f"{where}{error}") from None


def anything(_: Any) -> None:
    """Any value, which is looked at later."""


def any_text(value: Any) -> None:
    """A text."""
    if not isinstance(value, str):
        need(False, Malformed, ": found {}, expected a text", value)


def text(pattern: str, expected: str) -> Shape:
    """A text that matches a pattern."""
    matches = re.compile(pattern).fullmatch

    def check_text(value: Any) -> None:
        if not (isinstance(value, str) and matches(value)):
            need(False, Malformed, ": found {}, expected {}", value, expected)

    return check_text


def integer(low: int, high: int) -> Shape:
    """A whole number between two others."""

    def check_integer(value: Any) -> None:
        good = type(value) is int and low <= value <= high
        need(good, Malformed, ": found {}, expected {} to {}", value, low, high)

    return check_integer


def optional(shape: Shape) -> Shape:
    """Null, or a value of this shape."""

    def check_optional(value: Any) -> None:
        if value is not None:
            shape(value)

    return check_optional


def array(shape: Shape) -> Shape:
    """A list of any length."""

    def check_array(value: Any) -> None:
        need(isinstance(value, list), Malformed, ": found {}, expected a list", value)
        for i, item in enumerate(value, 1):
            try:
                shape(item)
            except Malformed as error:
                raise Malformed(f" {i}{error}") from None

    return check_array


def tuple_of(*shapes: Shape) -> Shape:
    """A list with one entry for each shape."""

    def check_tuple(value: Any) -> None:
        good = isinstance(value, list) and len(value) == len(shapes)
        need(good, Malformed, ": found {}, expected {} entries", value, len(shapes))
        for i, (item, shape) in enumerate(zip(value, shapes, strict=True), 1):
            fits(f" {i}", shape, item)

    return check_tuple


def table(shape: Shape) -> Shape:
    """An object with any names as keys."""

    def check_table(value: Any) -> None:
        need(isinstance(value, dict), Malformed, ": found {}, expected an object", value)
        for key, item in value.items():
            name(key)
            fits(f".{key}", shape, item)

    return check_table


def record(**shapes: Shape) -> Shape:
    """An object with just these keys."""

    def check_record(value: Any) -> None:
        need(isinstance(value, dict), Malformed, ": found {}, expected an object", value)
        if value.keys() != shapes.keys():
            odd = sorted(value.keys() ^ shapes.keys())
            need(False, Malformed, ": found too many or too few keys: {}", odd)
        for key, shape in shapes.items():
            try:
                shape(value[key])
            except Malformed as error:
                raise Malformed(f".{key}{error}") from None

    return check_record


name = text(NAME, "a name")
long_name = f"({NAME}:){{0,{MAX_NAME // 2}}}{NAME}"
reference = text(f"{HYPOTHESIS}|{long_name}", "the name of a fact")
context_name = text(long_name, "the name of a context")
number = text(RATIONAL, "a rational number")
exponent = text("[1-9][0-9]{0,2}", "an exponent from 1 to 999")
index = text("[2-9]|[1-9][0-9]", "the index of a root from 2 to 99")
bits = integer(2, MAX_BITS)
ends = tuple_of(text(DECIMAL, "a decimal number"), text(DECIMAL, "a decimal number"))

CONSTANT = record(name=name, label=any_text, letter=any_text, tex=any_text, term=anything)
GIVEN = record(
    name=name,
    claim=anything,
    kind=text("plain|carried|standing", "plain, carried or standing"),
    assumption=optional(name),
)
CONTEXT = record(
    name=name,
    parent=optional(name),
    says=any_text,
    variables=array(record(name=name, letter=any_text, tex=any_text)),
    givens=array(GIVEN),
    point=table(anything),
    constants=array(CONSTANT),
)
ROW = record(
    name=name,
    context=optional(name),
    group=any_text,
    label=any_text,
    role=text("needed|printed", "needed or printed"),
    severity=optional(any_text),
    says=any_text,
    claim=anything,
    verdict=text("proved|refuted|undecided", "proved, refuted or undecided"),
    uses=array(name),
    corrected_by=optional(any_text),
)
ASSUMPTION = record(name=name, kind=any_text, label=any_text, sentence=any_text)
CITE = record(name=name, theorem=any_text, statement_sha256=text("[0-9a-f]{64}", "a digest"))
STATEMENT = record(
    format=text("verify-statement/2", "verify-statement/2"),
    theorem=any_text,
    title=any_text,
    parameters=table(anything),
    terms=table(anything),
    constants=array(CONSTANT),
    contexts=array(CONTEXT),
    obligations=array(ROW),
    assumptions=array(ASSUMPTION),
    cites=array(CITE),
)
CERTIFICATE = record(
    format=text("verify-certificate/2", "verify-certificate/2"),
    statement_sha256=text("[0-9a-f]{64}", "a digest"),
    terms=table(anything),
    steps=array(anything),
    enclosures=record(
        constants=table(record(bits=bits, ends=ends)),
        rows=table(record(bits=bits, lhs=ends, rhs=ends)),
    ),
)

rule, proofs = text(NAME, "a rule"), array(anything)
side = text("lhs|rhs", "lhs or rhs")
bounds = array(tuple_of(context_name, reference, reference))
#: Each rule with the shape of its proofs.
RULES: dict[str, tuple[Callable[..., None], Shape]] = {
    "interval": (Kernel.interval, record(rule=rule, bits=bits, bounds=bounds)),
    "cuts": (
        Kernel.cuts,
        record(rule=rule, term=anything, at=array(number), branches=proofs),
    ),
    "mean_value": (
        Kernel.mean_value,
        record(rule=rule, bits=bits, bounds=bounds, at=table(number)),
    ),
    "sum": (
        Kernel.sum,
        record(
            rule=rule,
            using=array(reference),
            addends=array(anything),
            equations=array(tuple_of(reference, anything)),
        ),
    ),
    "entry": (Kernel.entry, record(rule=rule, side=side, equation=optional(reference))),
    "least": (
        Kernel.least,
        record(rule=rule, side=side, equation=optional(reference), branches=proofs),
    ),
    "cases": (Kernel.cases, record(rule=rule, of=anything, branches=proofs)),
    "root": (Kernel.root, record(rule=rule)),
    "antisymmetry": (Kernel.antisymmetry, record(rule=rule, branches=proofs)),
    "have": (Kernel.have, record(rule=rule, claim=anything, branches=proofs)),
    "range": (Kernel.range, record(rule=rule)),
    "law": (Kernel.law, record(rule=rule)),
    "monotony": (
        Kernel.monotony,
        record(
            rule=rule,
            under=optional(text("exp|log|atan|sqrt", "exp, log, atan or sqrt")),
            premise=anything,
        ),
    ),
    "derivative": (
        Kernel.derivative,
        record(
            rule=rule,
            side=text("above|below", "above or below"),
            strict=text("start|slope", "start or slope"),
            variable=context_name,
            bounds=proofs,
            **dict.fromkeys(("at", "term", "start", "order", "sign"), anything),
        ),
    ),
    "angles": (Kernel.angles, record(rule=rule)),
    "cosine": (Kernel.cosine, record(rule=rule)),
    "instance": (
        Kernel.instance,
        record(rule=rule, of=context_name, at=table(anything), givens=proofs),
    ),
}
#: The rules that show that a term has a value, and those with whole steps of their own.
DEFINING: dict[str, tuple[Callable[..., None], Shape]] = {
    "define": (Kernel.define, record(rule=rule)),
    "interval": RULES["interval"],
}
APPLYING = {"instance": (Kernel.instance, record(rule=rule, givens=proofs))}
REPEATING = {"induction": (Kernel.induction, record(rule=rule, start=proofs, next=proofs))}
FAILING = {
    "witness": (
        Kernel.witness,
        record(rule=rule, at=table(anything), givens=proofs, negation=anything),
    )
}


def rule_of(proof: Any, rules: Mapping[str, tuple[Callable[..., None], Shape]]) -> str:
    """The rule of a proof, which is one of these, and whose proof has its shape."""
    if type(proof) is int and "interval" in rules:
        fits("interval", bits, proof)
        return "interval"
    found = proof.get("rule") if isinstance(proof, dict) else proof
    if not (isinstance(found, str) and found in rules):
        need(False, Malformed, "rule: found {}, expected one of {}", found, [*rules])
    fits(str(found), rules[str(found)][1], proof)
    return str(found)


def precision(proof: Any) -> tuple[int, Sequence[Any]]:
    """The bits of enclosures, and the bounds; bits alone are a proof by `interval`, without any."""
    return (proof, ()) if type(proof) is int else (proof["bits"], proof["bounds"])


# --- statements, certificates, and the report ----------------------------------------------------


class Row(NamedTuple):
    """An obligation of a statement."""

    name: str
    context: Context
    role: str
    verdict: str
    claim: Claim | Applies | Always
    words: str
    uses: frozenset[str]


class Cite(NamedTuple):
    """A citation: its name, the theorem, the digest of its statement, and what that assumes."""

    name: str
    theorem: str
    digest: str
    sentences: Mapping[str, str]


class Statement(NamedTuple):
    """What a statement claims, read into a kernel."""

    title: str
    constants: list[str]  # those of the root, with the parameters
    rows: dict[str, Row]
    sentences: dict[str, str]  # what is assumed
    standing: set[str]  # those of them that grant a given
    cites: list[Cite]  # also those of the cited statements

    def printed(self) -> frozenset[str]:
        """The names of the sentences that printed rows use, and nothing else does."""
        used: dict[str, set[str]] = {"needed": set(self.standing), "printed": set()}
        for row in self.rows.values():
            used[row.role] |= row.uses
        return frozenset(used["printed"] - used["needed"])


#: What is cited, with the kernel into which it was read, the work, and all citations.
BEGINNINGS: dict[Any, tuple[Kernel, int, list[Cite]]] = {}


class Reader:
    """Reads a statement, and those that it cites, into a kernel."""

    def __init__(self, kernel: Kernel, available: Mapping[str, bytes]) -> None:
        self.kernel, self.available = kernel, available
        self.own: dict[str, tuple[Context, int]] = {}  # constants that are to be defined

    def read(self, document: dict[str, Any], prefix: str = "") -> Statement:
        """The statement; if it is cited, its contexts are open and its proved rows are facts."""
        kernel = self.kernel
        cites = self.cites(document["cites"], prefix)
        kernel.prefix = prefix
        assumptions = {item["name"]: item["sentence"] for item in document["assumptions"]}
        good = len(assumptions) == len(document["assumptions"])
        need(good, Malformed, "assumptions: found a name twice")
        terms = {
            name: kernel.read(f"parameter {name}", term, kernel.outermost)
            for name, term in document["parameters"].items()
        }
        for name, term in terms.items():
            self.constant(name, term, kernel.outermost, prefix)
        kernel.shared |= {prefix + name: term for name, term in document["terms"].items()}
        for name in document["terms"]:
            kernel.introduce(prefix + name)
        self.constants(document["constants"], kernel.outermost, prefix)
        for item in document["contexts"]:
            self.context(item, prefix, assumptions)
        for name in document["terms"]:
            kernel.parse_leaf("terms", name)
        rows = {}
        for item in document["obligations"]:
            row = self.row(item, prefix, assumptions)
            rows[row.name] = row
            kernel.introduce(prefix + row.name)
            if prefix and row.verdict == "proved" and isinstance(row.claim, Claim):
                kernel.install(prefix + row.name, row.claim, row.context)
        constants = [*terms, *(item["name"] for item in document["constants"])]
        givens = [given for item in document["contexts"] for given in item["givens"]]
        standing = {given["assumption"] for given in givens if given["assumption"] is not None}
        return Statement(document["title"], constants, rows, assumptions, standing, cites)

    def cites(self, items: list[dict[str, Any]], prefix: str) -> list[Cite]:
        """Read what is cited; of a statement that is not cited itself, this is the beginning.

        Statements that begin alike share it: what is cited is named by its digest.
        """
        if prefix:
            return [found for item in items for found in self.cite(item, prefix)]
        asked = tuple(tuple(sorted(item.items())) for item in items)
        if asked not in BEGINNINGS:
            if sum(work for _, work, _ in BEGINNINGS.values()) > MAX_KEPT:
                BEGINNINGS.clear()
            other = Reader(Kernel(), self.available)
            other.kernel.work = left = self.kernel.work
            found = [found for item in items for found in other.cite(item, "")]
            BEGINNINGS[asked] = other.kernel, left - other.kernel.work, found
        kernel, work, found = BEGINNINGS[asked]
        for cite in found:
            self.at_hand(cite.digest)
        self.kernel.begin(kernel, work)
        return [*found]

    def at_hand(self, digest: str) -> bytes:
        """The statement that has this digest."""
        data = self.available.get(digest, b"")
        message = "cites: found {}, whose statement is not at hand"
        need(sha256(data).hexdigest() == digest, Malformed, message, digest)
        return data

    def cite(self, cite: dict[str, Any], prefix: str) -> list[Cite]:
        """Read a cited statement, whose names get its name and a colon before them.

        What is returned is the citation, and those in the cited statement.
        """
        digest, full = cite["statement_sha256"], prefix + cite["name"]
        data = self.at_hand(digest)
        self.kernel.introduce(full)
        self.kernel.spend(0, 100 + len(data) // 3)
        self.kernel.spend(0, brackets(data))
        document = parsed("cited statement", data, STATEMENT)
        good = document["theorem"] == cite["theorem"]
        need(good, Malformed, "cites: found {} under another title", cite["theorem"])
        inner = self.read(document, f"{full}:")
        for name in inner.sentences:  # each is told under the name that it has here
            self.kernel.spend(0, 1 + len(f"{full}:{name}") // 4)
        return [Cite(full, cite["theorem"], digest, inner.sentences), *inner.cites]

    def constants(self, items: list[dict[str, Any]], context: Context, prefix: str) -> None:
        """Introduce constants in order, each over earlier names."""
        for item in items:
            term = self.kernel.read(f"constant {item['name']}", item["term"], context)
            self.constant(item["name"], term, context, prefix)

    def constant(self, short: str, definition: int, context: Context, prefix: str) -> None:
        """Introduce one constant; that its definition has a value is proved by a step."""
        full = prefix + short
        term = self.kernel.new_name(full, context, definition)
        if prefix:
            self.kernel.defined.add(term)
            self.kernel.install(full, Claim("=", term, definition), context)
        else:
            self.own[full] = context, definition

    def context(self, item: dict[str, Any], prefix: str, assumptions: Mapping[str, str]) -> None:
        """Introduce a context with its variables, givens, point and constants."""
        kernel, full = self.kernel, prefix + item["name"]
        parent = self.find(item["parent"], prefix)
        kernel.introduce(full)
        context = kernel.contexts[full] = Context(full, parent)
        for variable in item["variables"]:
            term = kernel.new_name(prefix + variable["name"], context)
            context.variables[prefix + variable["name"]] = term
        for given in item["givens"]:
            claim = kernel.read_claim(f"given {given['name']}", given["claim"], context)
            known = given["assumption"] in (assumptions if given["kind"] == "standing" else [None])
            message = "given {}: found the assumption {} of a {} given"
            need(known, Malformed, message, given["name"], given["assumption"], given["kind"])
            kernel.introduce(prefix + given["name"])
            context.givens.append(Given(prefix + given["name"], claim, given["kind"]))
        context.point = kernel.values("point", item["point"], context, Place(parent))
        if prefix:
            kernel.opened.add(context)
            for given in context.givens:
                kernel.install(given.name, given.claim, context)
        self.constants(item["constants"], context, prefix)

    def find(self, name: str | None, prefix: str) -> Context:
        """The context of this name, or the root."""
        if name is None:
            return self.kernel.outermost
        need(prefix + name in self.kernel.contexts, Malformed, "found no context {} so far", name)
        return self.kernel.contexts[prefix + name]

    def row(self, item: dict[str, Any], prefix: str, assumptions: Mapping[str, str]) -> Row:
        """An obligation."""
        unknown = [name for name in item["uses"] if name not in assumptions]
        need(not unknown, Malformed, "uses: found {}, which are no assumptions", unknown)
        context = self.find(item["context"], prefix)
        claim, words = self.claim(item["name"], item["claim"], context, prefix)
        good = isinstance(claim, Claim) or item["verdict"] == "proved"
        need(good, Malformed, "{}: found {} of such a claim", item["name"], item["verdict"])
        inside = f" throughout the context {context.name}"
        where = "" if context is self.kernel.outermost else inside
        words = f"{words}{where}" if item["verdict"] == "proved" else f"not ({words}{where})"
        label = f" [{item['label']}]" if item["label"] else ""
        words = f"{item['name']}{label} {words}"
        uses = frozenset(item["uses"])
        return Row(item["name"], context, item["role"], item["verdict"], claim, words, uses)

    def claim(
        self, where: str, value: Any, context: Context, prefix: str
    ) -> tuple[Claim | Applies | Always, str]:
        """What an obligation claims, and in words."""
        kernel, place = self.kernel, Place(context)
        kind = value[0] if isinstance(value, list) and value else value
        if kind == "applies":
            fits(where, tuple_of(anything, context_name, table(anything)), value)
            other = self.find(value[1], prefix)
            at = kernel.values(where, value[2], other, place)
            return Applies(other, at), f"the theorems of {other.name} apply"
        if kind == "always":
            fits(where, tuple_of(anything, context_name, *2 * [table(anything)]), value)
            other = self.find(value[1], prefix)
            start = kernel.values(where, value[2], other, place)
            following = kernel.values(where, value[3], other, Place(other))
            return Always(other, start, following), f"{other.name} always"
        claim = kernel.read_claim(where, value, context)
        return claim, f"lhs {claim.relation} rhs"


STEPS: dict[str, Shape] = {
    "obligation": record(obligation=name, proof=anything),
    "lemma": record(lemma=name, context=optional(context_name), claim=anything, proof=anything),
    "constant": record(constant=name, proof=anything),
    "define": record(define=name, context=optional(context_name), term=anything, proof=anything),
    "open": record(open=name, givens=proofs),
}


class Checking:
    """A certificate, step by step."""

    def __init__(self, kernel: Kernel, reader: Reader, statement: Statement) -> None:
        self.kernel, self.reader, self.statement = kernel, reader, statement
        self.lines: list[str] = []
        self.complaints: list[str] = []
        self.done: set[str] = set()
        self.accepted: dict[str, str] = {}  # what is proved of a row: proved, or refuted

    def step(self, step: Any) -> None:
        """Afterwards the step has made its fact, or its refusal is in the report."""
        kinds = [kind for kind in STEPS if isinstance(step, dict) and kind in step]
        if len(kinds) != 1:
            need(False, Malformed, "steps: found {}, expected one of {}", step, [*STEPS])
        kind = kinds[0]
        fits("step", STEPS[kind], step)
        what = f"{kind} {step[kind]}"
        try:
            STEP[kind](self, step)
        except Malformed as error:
            raise Malformed(f"{what}: {error}") from error
        except Refused as error:
            self.kernel.refused.add(step[kind])
            row = self.statement.rows.get(step[kind])
            what = row.words if row else what
            self.complain(f"{what}: {error}")

    def complain(self, words: str) -> None:
        """Put a refusal into the report, if there is room."""
        good = len(self.complaints) < MAX_REFUSED
        need(good, Malformed, "found more than {} refusals", MAX_REFUSED)
        self.complaints.append(f"REFUSED {words}")
        self.lines.append(self.complaints[-1])

    def place(self, context: Context) -> Place:
        """The context, which must be open."""
        good = context.name not in self.kernel.refused
        need(good, Refused, "found {}, which could not be opened", context.name)
        is_open = context in self.kernel.opened
        need(is_open, Malformed, "found {}, which is not open so far", context.name)
        return Place(context)

    def once(self, item: str) -> None:
        """Each item of the statement is dealt with once."""
        need(item not in self.done, Malformed, "found a second step")
        self.done.add(item)

    def obligation(self, step: dict[str, Any]) -> None:
        """Prove a row of the statement, or its negation if it is refuted."""
        name, kernel = step["obligation"], self.kernel
        need(name in self.statement.rows, Malformed, "found no such row")
        self.once(name)
        row = self.statement.rows[name]
        need(row.verdict != "undecided", Malformed, "found a proof of an undecided row")
        place, claim, proof = self.place(row.context), row.claim, step["proof"]
        found = "proved"
        if isinstance(claim, Applies):
            APPLYING[rule_of(proof, APPLYING)][0](kernel, place, claim, proof)
        elif isinstance(claim, Always):
            REPEATING[rule_of(proof, REPEATING)][0](kernel, place, claim, proof)
        elif row.verdict == "proved":
            kernel.prove(place, claim, proof)
            kernel.install(name, claim, row.context)
        elif isinstance(proof, dict) and proof.get("rule") == "witness":
            found = "refuted"
            FAILING[rule_of(proof, FAILING)][0](kernel, place, claim, proof)
        else:
            found = "refuted"
            kernel.prove(place, negated(claim), proof)
        self.accepted[name] = found
        self.lines.append(f"proved  {row.words}")

    def lemma(self, step: dict[str, Any]) -> None:
        """Prove a claim of the certificate."""
        kernel, context = self.kernel, self.context(step["context"])
        kernel.introduce(step["lemma"])
        claim = kernel.read_claim("claim", step["claim"], context)
        kernel.prove(self.place(context), claim, step["proof"])
        kernel.install(step["lemma"], claim, context)

    def constant(self, step: dict[str, Any]) -> None:
        """Show that the definition of a constant of the statement has a value."""
        name = step["constant"]
        need(name in self.reader.own, Malformed, "found no such constant")
        self.once(name)
        context, definition = self.reader.own[name]
        self.make_defined(name, self.kernel.names[name], definition, context, step["proof"])

    def define(self, step: dict[str, Any]) -> None:
        """Introduce a constant of the certificate."""
        context = self.context(step["context"])
        definition = self.kernel.read("term", step["term"], context)
        term = self.kernel.new_name(step["define"], context, definition)
        self.make_defined(step["define"], term, definition, context, step["proof"])

    def make_defined(
        self, name: str, term: int, definition: int, context: Context, proof: Any
    ) -> None:
        """Make a fact of a definition that has a value."""
        self.kernel.define(self.place(context), definition, proof)
        self.kernel.defined.add(term)
        self.kernel.install(name, Claim("=", term, definition), context)

    def open(self, step: dict[str, Any]) -> None:
        """Show that there are values that satisfy the givens of a context."""
        name = step["open"]
        need(name in self.kernel.contexts, Malformed, "found no such context")
        self.once(name)
        context = self.kernel.contexts[name]
        self.kernel.open(self.place(context.parent or context), context, step["givens"])

    def context(self, name: str | None) -> Context:
        """The context of this name, or the root."""
        return self.reader.find(name, "")

    def rows(self) -> dict[str, str]:
        """What is accepted of each row; undecided where the statement claims nothing."""
        asked = {name: row.verdict for name, row in self.statement.rows.items()}
        other = {name: "undecided" for name in asked if asked[name] == "undecided"}
        return {name: self.accepted.get(name, other.get(name, "refused")) for name in asked}

    def finish(self, enclosures: dict[str, Any]) -> None:
        """Afterwards nothing of the statement is left, and all enclosures are right."""
        decided = {name for name, row in self.statement.rows.items() if row.verdict != "undecided"}
        expected = (
            decided
            | self.reader.own.keys()
            | {name for name in self.kernel.contexts if ":" not in name}
        )
        left = sorted(expected - self.done)
        need(not left, Malformed, "steps: found none for {}", left)
        for name, row in self.statement.rows.items():
            if row.role == "needed" and row.verdict == "undecided":
                self.complain(f"{name}: a needed row is undecided")
        rows = {
            name: row.claim
            for name, row in self.statement.rows.items()
            if name in decided and isinstance(row.claim, Claim) and self.is_ground(row.claim)
        }
        terms = {name: self.kernel.names[name] for name in self.statement.constants}
        for key, wanted in (("constants", terms), ("rows", rows)):
            odd = sorted(enclosures[key].keys() - wanted.keys())
            need(not odd, Malformed, "enclosures of {}: found unknown names: {}", key, odd)
        for name, found in enclosures["constants"].items():
            self.enclosed(name, terms[name], found["ends"], found["bits"])
        for name, found in enclosures["rows"].items():
            self.enclosed(name, rows[name].lhs, found["lhs"], found["bits"])
            self.enclosed(name, rows[name].rhs, found["rhs"], found["bits"])

    def is_ground(self, claim: Claim) -> bool:
        """Whether a claim has no variables."""
        return self.kernel.is_ground(claim.lhs) and self.kernel.is_ground(claim.rhs)

    def enclosed(self, name: str, term: int, found: list[str], bits: int) -> None:
        """Afterwards the value lies between the ends, or the complaint is in the report."""
        for end in found:
            exponent = abs(int(end.partition("e")[2] or 0))
            self.kernel.spend(4 * (exponent + len(end)))
        given = Interval(*map(rational, found))
        need(given.low <= given.high, Malformed, "{}: found ends in no order: {}", name, given)
        try:
            inner = self.kernel.enclosing(Place(self.kernel.outermost), bits).enclose(term)
            good = given.low <= inner.low and inner.high <= given.high
            need(good, Refused, "found the enclosure {}, expected one around {}", given, inner)
        except Refused as error:
            self.complain(f"enclosure of {name}: {error}")


STEP: dict[str, Callable[[Checking, dict[str, Any]], None]] = {
    "obligation": Checking.obligation,
    "lemma": Checking.lemma,
    "constant": Checking.constant,
    "define": Checking.define,
    "open": Checking.open,
}


class Folder(NamedTuple):
    """A statement and its certificate, and what lies beside them to be cited.

    ``proofs`` has those of the cited statements that lie there with a certificate, and it.
    """

    path: str
    statement: bytes
    certificate: bytes
    cited: Sequence[bytes]
    proofs: Sequence[tuple[bytes, bytes]] = ()


class Report(NamedTuple):
    """What was found about one statement: a verdict of `EXIT_CODES`, and the lines about it.

    ``rows`` says of each obligation what the steps that were accepted show, whatever the statement
    says of it: proved, refuted, undecided, or refused. ``printed`` are the names of the sentences
    that only printed rows use, ``cites`` has all citations, also those in what is cited, and
    ``work`` is what was counted.
    """

    verdict: str
    lines: list[str]
    summary: str
    digest: str
    cites: Sequence[Cite] = ()
    rows: Mapping[str, str] = {}
    sentences: Mapping[str, str] = {}
    printed: frozenset[str] = frozenset()
    work: int = 0


def brackets(data: bytes) -> int:
    """How many lists and objects a file has at most: they take most memory for their bytes."""
    return data.count(b"[") + data.count(b"{")


def parsed(where: str, data: bytes, shape: Shape) -> Any:
    """The document in a JSON file, where natural numbers below 10^9 are the only numbers."""

    def unique(pairs: list[tuple[str, Any]]) -> dict[str, Any]:
        found = dict(pairs)
        if len(found) != len(pairs):
            need(False, Malformed, "{}: found a key twice in {}", where, [*found])
        return found

    def natural(text: str) -> int:
        good = re.fullmatch("0|[1-9][0-9]{0,8}", text)
        need(good, Malformed, "{}: found {}, expected numbers as texts", where, text)
        return int(text)

    need(len(data) <= MAX_BYTES, Malformed, "{}: found more than {} bytes", where, MAX_BYTES)
    hooks: Any = {"parse_int": natural, "parse_float": natural, "parse_constant": natural}
    try:
        value = json.loads(data.decode(), object_pairs_hook=unique, **hooks)
    except (ValueError, RecursionError) as error:
        raise Malformed(f"{where}: {error}") from error
    level, depth = [value] if isinstance(value, BRACKETS) else [], 0
    while level:
        depth += 1
        good = depth <= MAX_NESTING
        need(good, Malformed, "{}: found more than {} nested brackets", where, MAX_NESTING)
        lists = [item.values() if isinstance(item, dict) else item for item in level]
        level = [item for inner in lists for item in inner if isinstance(item, BRACKETS)]
    fits(where, shape, value)
    return value


def check(
    first: bytes, second: bytes, available: Mapping[str, bytes], work: int | None = None
) -> Report:
    """Whether the certificate in ``second`` proves the statement in ``first``, and a report.

    ``available`` has the bytes of statements that may be cited, by their digests; ``work`` is the
    limit, if it is another one.
    """
    kernel = Kernel()
    kernel.work = limit = MAX_WORK if work is None else work
    try:
        kernel.spend(0, (len(first) + len(second)) // 8)
        kernel.spend(0, brackets(first) + brackets(second))
        document = parsed("statement", first, STATEMENT)
        certificate = parsed("certificate", second, CERTIFICATE)
        digest, found = sha256(first).hexdigest(), certificate["statement_sha256"]
        need(found == digest, Malformed, "statement_sha256: found {}, expected {}", found, digest)
        reader = Reader(kernel, available)
        return checked(reader, reader.read(document), certificate, digest, limit)
    finally:
        kernel.close()


def checked(
    reader: Reader, statement: Statement, certificate: dict[str, Any], digest: str, limit: int
) -> Report:
    """The report about a statement that has just been read, and its certificate."""
    kernel = reader.kernel
    needed = [row for row in statement.rows.values() if row.role == "needed"]
    need(needed, Malformed, "obligations: found no needed row, which proves nothing")
    kernel.shared |= certificate["terms"]
    for name in certificate["terms"]:
        kernel.introduce(name)
    checking = Checking(kernel, reader, statement)
    for step in certificate["steps"]:
        checking.step(step)
    checking.finish(certificate["enclosures"])
    refuted = any(row.verdict == "refuted" for row in needed)
    verdict = "REFUTED" if refuted else "PROVED"
    lines = checking.lines + [f"assumed {name}: {s}" for name, s in statement.sentences.items()]
    report = Report(
        verdict, lines, summary(statement), digest, statement.cites, checking.rows(),
        statement.sentences, statement.printed(), limit - kernel.work,
    )  # fmt: skip
    return refused(report, statement.title, checking.complaints)


def refused(report: Report, title: str, complaints: Sequence[str]) -> Report:
    """The report, where what the statement claims is not counted as if it were shown."""
    words = f"{title}: not shown; refused above: {len(complaints)}"
    return report._replace(verdict="REFUSED", summary=words) if complaints else report


def summary(statement: Statement) -> str:
    """The title, and how many rows of each kind there are."""
    counts = []
    for verdict in ("proved", "refuted", "undecided"):
        for role in ("needed", "printed"):
            n = sum((row.role, row.verdict) == (role, verdict) for row in statement.rows.values())
            counts.append(f"{n} {role} {verdict}")
    return f"{statement.title}: {', '.join(counts)}"


def examined(first: bytes, second: bytes, available: Mapping[str, bytes], work: int) -> Report:
    """The same as `check`, with a report also about what is malformed."""
    try:
        return check(first, second, available, work)
    except (Malformed, RecursionError) as error:
        return Report("MALFORMED", [], str(error), sha256(first).hexdigest())


def judged(folders: Sequence[Folder]) -> Iterable[tuple[Report, list[Report]]]:
    """For each folder its report, and those about the certificates of what it cites.

    What lies in one folder shares one limit of work, whatever is known of it from another one.
    """
    everything = [data for folder in folders for data in (folder.statement, *folder.cited)]
    available = {sha256(data).hexdigest(): data for data in everything}
    known: dict[tuple[bytes, bytes], Report] = {}
    for folder in folders:
        found: list[Report] = []
        room = MAX_WORK
        for pair in ((folder.statement, folder.certificate), *folder.proofs):
            report = known.get(pair) or examined(*pair, available, room)
            if report.work > room:
                report = examined(*pair, available, room)
            found.append(report)
            if report.verdict == "MALFORMED":
                break
            known[pair] = report
            room -= report.work
        yield with_cited(found[0], found[1:]), found[1:]


def with_cited(report: Report, cited: Sequence[Report]) -> Report:
    """The report about a folder in which those about certificates of what it cites are good."""
    if report.verdict == "MALFORMED":
        return report
    complaints = []
    for other in cited:
        if other.verdict == "MALFORMED":
            words = f"cited certificate of {other.digest}: {other.summary}"
            return Report("MALFORMED", [], words, report.digest)
        if other.verdict != "PROVED":
            said = [line for line in other.lines if line.startswith("REFUSED")]
            why = said[0] if said else f"{other.verdict}: {other.summary}"
            complaints.append(f"REFUSED cited certificate of {other.digest}: {why}")
    title = report.summary.rpartition(": ")[0]
    return refused(report._replace(lines=[*report.lines, *complaints]), title, complaints)


def closed_by(found: Iterable[tuple[Report, list[Report]]]) -> dict[str, Report]:
    """The reports that close citations, by the digests of the statements: what is proved."""
    reports = [report for folder, cited in found for report in (folder, *cited)]
    return {report.digest: report for report in reports if report.verdict == "PROVED"}


def rests_on(report: Report) -> list[Cite]:
    """The citations on which the rows rest, each statement once.

    Any fact of a cited statement may be used, and of what that cites, so all of them count.
    """
    return [*{cite.digest: cite for cite in reversed(report.cites)}.values()][::-1]


def verdict(report: Report, closed: Mapping[str, Report]) -> str:
    """The verdict about a folder; without a proof of all that is cited, it is UNDECIDED."""
    is_open = any(cite.digest not in closed for cite in report.cites)
    return "UNDECIDED" if is_open and report.verdict in ("PROVED", "REFUTED") else report.verdict


def exit_code(verdicts: Iterable[str]) -> int:
    """The code of the worst of these verdicts."""
    return EXIT_CODES[max(verdicts, key=[*EXIT_CODES].index, default="PROVED")]


def conclusion(report: Report, closed: Mapping[str, Report]) -> list[str]:
    """All lines about a folder: also the sentences of what it cites, and the last line."""
    lines = [
        f"assumed {cite.name}:{name}: {sentence}"
        for cite in rests_on(report)
        for name, sentence in cite.sentences.items()
    ]
    return [*report.lines, *lines, last_line(report, closed)]


def last_line(report: Report, closed: Mapping[str, Report]) -> str:
    """The verdict, what it is about, and the sentences on which the needed rows rest.

    Also those of all that is cited: its theorem is that its rows follow from them. A proof in the
    same run closes a citation; one that stays open is named.
    """
    words = f"{verdict(report, closed)}: {report.summary}"
    if report.verdict not in ("PROVED", "REFUTED"):
        return words
    cited = rests_on(report)
    given = [name for name in report.sentences if name not in report.printed]
    given += [f"{cite.name}:{name}" for cite in cited for name in cite.sentences]
    words += f"; given {', '.join(given) or 'nothing'}"
    apart = [name for name in report.sentences if name in report.printed]
    words += f"; for printed rows only, also given {', '.join(apart)}" if apart else ""
    for cite in (cite for cite in cited if cite.digest not in closed):
        words += f"; citing {cite.theorem}, which is not proved here ({cite.digest})"
    return words


def read_file(path: str) -> bytes:
    """The bytes of a file, and one more than is allowed at most."""
    with open(path, "rb") as file:
        return file.read(MAX_BYTES + 1)


def read_cited(folder: str) -> tuple[list[bytes], list[tuple[bytes, bytes]]]:
    """The statements in a folder, if there is one; and those with a certificate, and it."""
    found, room = {}, MAX_CITED
    for name in sorted(os.listdir(folder)) if os.path.isdir(folder) else []:
        path = os.path.join(folder, name)
        need(os.path.isfile(path), OSError, "found {}, which is no file", path)
        found[name] = read_file(path)
        room -= len(found[name])
        need(room >= 0, OSError, "found more than {} bytes in {}", MAX_CITED, folder)
    proofs = []
    for name in [name for name in found if name.endswith(CERTIFIED)]:
        first, second = f"{name.removesuffix(CERTIFIED)}.json", found.pop(name)
        message = "found {} in {}, but no {} beside it"
        need(first in found, OSError, message, name, folder, first)
        proofs.append((found[first], second))
    return [*found.values()], proofs


def read_folders(arguments: Sequence[str]) -> list[Folder]:
    """For each folder its name, its two files, and what lies there to be cited."""
    found = []
    names = ("statement.json", "certificate.json")
    pairs = [(path, *(os.path.join(path, name) for name in names)) for path in arguments]
    if len(arguments) == 2 and not any(map(os.path.isdir, arguments)):
        pairs = [(arguments[1], arguments[0], arguments[1])]
    else:  # nobody waits for a pipe that lies in a folder
        for path in (path for _, *files in pairs for path in files if os.path.exists(path)):
            need(os.path.isfile(path), OSError, "found {}, which is no file", path)
        for path, *files in pairs:
            found_both = all(map(os.path.exists, files))
            need(found_both, OSError, NO_FOLDER, *no_folder(path, names))
    for path, first, second in pairs:
        others = read_cited(os.path.join(os.path.dirname(first), "cited"))
        found.append(Folder(path, read_file(first), read_file(second), *others))
    return found


#: What is said of a path without a certificate: which, why, what it needs, and what is near it.
NO_FOLDER = "{} {}; name one with {}; in {} there is {}"


def no_folder(path: str, names: Sequence[str]) -> tuple[str, ...]:
    """The parts of what is said of a path that is no folder of a certificate."""
    is_folder = os.path.isdir(path)
    what = "has no statement with its certificate" if is_folder else "is no folder"
    near = path if is_folder else os.path.dirname(path)
    inside = sorted(os.listdir(near or os.curdir)) if os.path.isdir(near or os.curdir) else []
    known = [f for f in inside if all(os.path.isfile(os.path.join(near, f, n)) for n in names)]
    there = ", ".join(known[:4]) + (", ..." if len(known) > 4 else "") or "none"
    return repr(path), what, " and ".join(names), near or "this folder", there


def check_folders(folders: Sequence[Folder]) -> tuple[int, list[str]]:
    """The exit code and the report about folders, of which some may cite others."""
    found = [*judged(folders)]
    closed = closed_by(found)
    lines = []
    for folder, (report, _) in zip(folders, found, strict=True):
        lines += [f"{folder.path}:"] if len(folders) > 1 else []
        lines += conclusion(report, closed)
    return exit_code(verdict(report, closed) for report, _ in found), lines


def main(arguments: Sequence[str]) -> int:
    """Check what the command line names, print the report, and return the exit code."""
    try:
        need(arguments, OSError, "found no folder; write: check.py FOLDER")
        need(all(arguments), OSError, "found an empty name of a folder")
        folders = read_folders(arguments)
        code, lines = check_folders(folders)
    except (OSError, ValueError) as error:
        return complaint(str(error), 2)
    except KeyboardInterrupt:
        return complaint("interrupted", 130)
    return output(lines, code)


def complaint(words: str, code: int) -> int:
    """Say why there is no report, if anybody listens, and return the exit code."""
    try:
        if sys.stderr is not None:
            print(f"check: {words}", file=sys.stderr, flush=True)
    except OSError:
        os.dup2(os.open(os.devnull, os.O_WRONLY), sys.stderr.fileno())
    return code


def unexpected(kind: type[BaseException], *_: object) -> None:
    """End with code 5 where nobody has caught an error: Python ends with 1, which means refused."""
    os.write(2, b"check: no verdict, as this program failed: %s\n" % kind.__name__.encode())
    os._exit(5)


def output(lines: list[str], code: int) -> int:
    """Print the report, and return the exit code; 141 if its reader has left, 2 if it cannot be."""
    text = "\n".join(line if line.isprintable() else ascii(line) for line in lines)
    try:
        if sys.stdout is None:
            raise OSError("stdout is closed")
        encoding = sys.stdout.encoding or "ascii"
        print(text.encode(encoding, "backslashreplace").decode(encoding), flush=True)
    except OSError as error:
        if sys.stdout is not None:
            os.dup2(os.open(os.devnull, os.O_WRONLY), sys.stdout.fileno())
        if isinstance(error, BrokenPipeError):
            return 141
        return complaint(f"the report cannot be written ({error})", 2)
    return code


if __name__ == "__main__":
    sys.excepthook = unexpected
    gc.disable()  # almost no garbage is cyclic here, and looking for it takes time
    sys.exit(main(sys.argv[1:]))
