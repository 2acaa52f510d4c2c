"""Terms as functions of floats, and of intervals between floats: fast, and not rigorous.

What they say is an estimate that guides a search. Nothing is claimed because of it: exact numbers
decide after it.
"""

from __future__ import annotations

import math
from collections.abc import Callable, Mapping, Sequence
from typing import Any

from verify.language.terms import Term
from verify.prover.numbers import float_of

Estimate = Callable[..., float]
#: From the ends of all variables, low and high in turn, to the ends of each term.
Ranges = Callable[..., tuple[float, ...]]


def _code(
    names: Sequence[str],
    terms: Sequence[Term],
    definitions: Mapping[str, Term],
    write: Callable[[Term, str, list[str]], list[str]],
    inputs: Callable[[str], str],
    results: Callable[[str], str],
) -> Callable[..., Any]:
    """A function that computes each subterm once."""
    places = {name: f"x{i}" for i, name in enumerate(names)}
    known: dict[Term, str] = {}
    lines: list[str] = []

    def place(term: Term) -> str:
        if term.op == "symbol":
            if term.name in places:
                return places[term.name]
            return place(definitions[term.name])
        found = known.get(term)
        if found is None:
            children = [place(child) for child in term.children]
            found = known[term] = f"v{len(known)}"
            lines.extend(write(term, found, children))
        return found

    found = ", ".join(results(place(term)) for term in terms)
    arguments = ", ".join(inputs(x) for x in places.values())
    body = "\n ".join([*lines, f"return ({found},)"])
    scope: dict[str, Any] = {"cos": math.cos, "sqrt": math.sqrt, "pair": _cosine}
    scope |= {"pi": math.pi, "inf": math.inf}
    exec(f"def function({arguments}):\n {body}", scope)  # noqa: S102  what is written above
    function: Callable[..., Any] = scope["function"]
    return function


def estimates(
    names: Sequence[str], terms: Sequence[Term], definitions: Mapping[str, Term]
) -> Callable[..., tuple[float, ...]]:
    """The values of terms at floats.

    The function raises an ArithmeticError or a ValueError where a term has none, a KeyError is
    raised here for a name that is not known.
    """
    return _code(names, terms, definitions, _value, lambda x: x, lambda v: v)


def _value(term: Term, at: str, children: list[str]) -> list[str]:
    signs = {"add": "+", "sub": "-", "mul": "*", "div": "/"}
    if term.op == "rational":
        return [f"{at} = {float_of(term.value)!r}"]
    if term.op in signs:
        return [f"{at} = {children[0]} {signs[term.op]} {children[1]}"]
    if term.op == "neg":
        return [f"{at} = -{children[0]}"]
    if term.op == "pow":
        return [f"{at} = {children[0]} ** {term.exponent}"]
    if term.op == "cos_pi":
        return [f"{at} = cos(pi * {children[0]})"]
    return [f"{at} = {term.op}({', '.join(children)})"]


def range_function(
    names: Sequence[str], terms: Sequence[Term], definitions: Mapping[str, Term]
) -> Ranges:
    """The ends between which terms lie, as the checker evaluates them, up to rounding."""
    return _code(
        names, terms, definitions, _range, lambda x: f"{x}l, {x}h", lambda v: f"{v}l, {v}h"
    )


def _range(term: Term, at: str, children: list[str]) -> list[str]:
    op, low, high = term.op, f"{at}l", f"{at}h"
    if op == "rational":
        return [f"{low} = {high} = {float_of(term.value)!r}"]
    a = children[0]
    if op == "add":
        b = children[1]
        return [f"{low} = {a}l + {b}l", f"{high} = {a}h + {b}h"]
    if op == "sub":
        b = children[1]
        return [f"{low} = {a}l - {b}h", f"{high} = {a}h - {b}l"]
    if op == "neg":
        return [f"{low} = -{a}h", f"{high} = -{a}l"]
    if op == "mul":
        return _product(at, a, children[1], term)
    if op == "div":
        b = children[1]
        guard = f"if {b}l <= 0.0 <= {b}h: raise ZeroDivisionError"
        return [guard, f"{at}il = 1.0 / {b}h", f"{at}ih = 1.0 / {b}l", *_product(at, a, f"{at}i")]
    if op == "pow":
        return _power(at, a, term.exponent)
    if op == "sqrt":
        return [f"{low} = sqrt({a}l)", f"{high} = sqrt({a}h)"]
    if op in ("min", "max"):
        ends = [", ".join(f"{child}{end}" for child in children) for end in "lh"]
        return [f"{low} = {op}({ends[0]})", f"{high} = {op}({ends[1]})"]
    scale = "" if op == "cos_pi" else " / pi"
    return [f"{low}, {high} = pair({a}l{scale}, {a}h{scale})"]


def _product(at: str, a: str, b: str, term: Term | None = None) -> list[str]:
    if term is not None:
        for child, other in (term.children, term.children[::-1]):
            if child.op == "rational":
                x = b if other is term.children[1] else a
                c = a if x == b else b
                ends = (f"{x}l", f"{x}h") if child.value >= 0 else (f"{x}h", f"{x}l")
                return [f"{at}l = {c}l * {ends[0]}", f"{at}h = {c}l * {ends[1]}"]
    return [
        f"if {a}l >= 0.0 and {b}l >= 0.0:",
        f"  {at}l = {a}l * {b}l; {at}h = {a}h * {b}h",
        "else:",
        f"  p, q, r, s = {a}l * {b}l, {a}l * {b}h, {a}h * {b}l, {a}h * {b}h",
        f"  {at}l = min(p, q, r, s); {at}h = max(p, q, r, s)",
    ]


def _power(at: str, a: str, n: int) -> list[str]:
    low, high = f"{at}l", f"{at}h"
    if n % 2:
        return [f"{low} = {a}l ** {n}", f"{high} = {a}h ** {n}"]
    return [
        f"if {a}l >= 0.0: {low} = {a}l ** {n}; {high} = {a}h ** {n}",
        f"elif {a}h <= 0.0: {low} = {a}h ** {n}; {high} = {a}l ** {n}",
        f"else: {low} = 0.0; {high} = max(-{a}l, {a}h) ** {n}",
    ]


def _cosine(low: float, high: float) -> tuple[float, float]:
    """The ends of cos(pi x) between two numbers."""
    first = math.ceil(low)
    ends = [math.cos(math.pi * low), math.cos(math.pi * high)]
    ends += [1.0 - 2.0 * (k % 2) for k in (first, first + 1) if k <= high]
    return min(ends), max(ends)
