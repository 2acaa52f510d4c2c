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
establishes this or raises `Refused`; what is not in the format raises `Malformed`. Nothing is
searched for, there is no floating point, and sizes are bounded, so that checking ends.

Exit codes: 0 all is proved and no needed row is a negation; 1 something is not proved; 2 unusable
command line; 4 a file is malformed, or the two do not belong together.
"""

from __future__ import annotations

import json
import os
import re
import sys
from collections.abc import Callable, Mapping, Sequence
from decimal import ROUND_CEILING, ROUND_FLOOR, Context
from fractions import Fraction
from hashlib import sha256
from itertools import pairwise, product
from math import comb, isqrt
from typing import Any

MAX_BYTES, MAX_NESTING = 1 << 22, 100  # of a file
MAX_HEIGHT = 200  # of a term, with the definitions of its symbols
MAX_BITS, MAX_SIZE = 1 << 16, 1 << 18  # of precision; of a numerator with its denominator
MAX_TERMS, MAX_DEGREE = 4000, 256  # of a product of polynomials; of a power of one atom
MAX_WORK = 10_000_000  # about the number of microseconds

# The signature. A shape is a pattern for a text, a range for an integer, a dict for an object with
# these keys (ANY: any), a list for a list of any length, a tuple for one of this length, a set for
# null or its member, None for what is checked elsewhere.
ANY, TEXT, NAME = "any", ".*", "[A-Za-z][A-Za-z0-9_.-]{0,99}"
RATIONAL = "-?[0-9]{1,4300}(/0*[1-9][0-9]{0,4290})?"  # int() reads at most 4300 digits
DECIMAL = r"-?[0-9]{1,400}(\.[0-9]{1,400})?(e-?[0-9]{1,5})?"
STATEMENT = {
    "format": "verify-statement/1", "theorem": TEXT, "title": TEXT, "parameters": {ANY: None},
    "constants": [{"name": NAME, "label": TEXT, "tex": TEXT, "term": None}],
    "obligations": [{"name": NAME, "label": TEXT, "role": "needed|printed", "says": TEXT,
                     "claim": None, "uses": [NAME], "variables": {ANY: ({RATIONAL}, {RATIONAL})}}],
    "assumptions": [{"name": NAME, "label": TEXT, "sentence": TEXT}],
}  # fmt: skip
CERTIFICATE = {
    "format": "verify-certificate/1", "statement_sha256": "[0-9a-f]{64}",
    "enclosures": {ANY: (DECIMAL, DECIMAL)}, "proofs": [None],
}  # fmt: skip
#: Operations with the number of their terms; min and max have two or more, pow an exponent as well.
ARITY = {"add": 2, "sub": 2, "mul": 2, "div": 2, "neg": 1, "sqrt": 1, "cos": 1, "cos_pi": 1}
#: What the failure of a relation says about the two sides, swapped.
OPPOSITE = {"<": "<=", "<=": "<", "=": "!="}

Interval = tuple[Fraction, Fraction]
Box = dict[int, tuple[Fraction | None, Fraction | None]]  # variable to ends, None if unbounded
Polynomial = dict[tuple[tuple[int, int], ...], Fraction]  # sorted (atom, power) to coefficient
ZERO, ONE = Fraction(0), Fraction(1)


class Malformed(Exception):  # noqa: N818
    """A file is not in the format, or the two files do not belong together."""


class Refused(Exception):  # noqa: N818
    """The evidence does not prove the obligation."""


class Terms:
    """The terms of a statement, and the work that may still be done.

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

    def define(self, name: str, *definition: int) -> int:
        """A new name in scope: a variable, or a constant with its definition."""
        if name in self.leaves or not re.fullmatch(NAME, name):
            raise Malformed(f"found the name {quoted(name)}, expected one that is not in use")
        self.leaves[name] = self.node("symbol", definition, len(self.nodes))
        return self.leaves[name]

    def read(self, value: object) -> int:
        """The term that is written over the names in scope."""
        if isinstance(value, str) and value in self.leaves:
            return self.leaves[value]
        if isinstance(value, str) and re.fullmatch(RATIONAL, value):
            self.leaves[value] = self.node("rational", (), *Fraction(value).as_integer_ratio())
            return self.leaves[value]
        op, *args = value if isinstance(value, list) and value else [value]
        rest = [int(args.pop())] if op == "pow" and args and fits(args[-1], EXPONENT) else []
        arity = {"min": max(2, len(args)), "max": max(2, len(args)), "pow": len(rest)} | ARITY
        if not isinstance(op, str) or arity.get(op) != len(args) ...:
            raise Malformed(f"found {quoted(value)}, expected a rational, a name in scope, or an operation with its terms")
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
