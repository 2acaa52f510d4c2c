"""Terms as functions of floats, and of intervals between floats: fast, and not rigorous.

What they say is an estimate that guides a search. Nothing is claimed because of it: exact numbers
decide after it.
"""

from __future__ import annotations

import math
from collections.abc import Callable, Mapping, Sequence
from fractions import Fraction
from typing import Any

from verify.language.fold import fold
from verify.language.record import Record
from verify.language.terms import Term
from verify.prover.balls import float_of

#: From the ends of all variables, low and high in turn, to the ends of each term.
Ranges = Callable[..., tuple[float, ...]]


class Place(Record):
    """The variable that holds a value, and the value where it is a number of the term."""

    at: str
    number: Fraction | None = None


#: The lines that compute a value, for each operation.
Lines = Mapping[str, Callable[..., list[str]]]


def _code(
    names: Sequence[str],
    terms: Sequence[Term],
    definitions: Mapping[str, Term],
    algebra: Lines,
    ends: Sequence[str],
) -> Callable[..., Any]:
    """A function that computes each subterm once, and has variables with these ends."""
    places = {name: Place(f"x{i}") for i, name in enumerate(names)}
    known: dict[Term, Place] = {}
    lines: list[str] = []

    def writer(write: Callable[..., list[str]]) -> Callable[..., Place]:
        def written(*operands: Any) -> Place:
            at = f"v{len(lines)}"
            lines.extend(write(at, *operands))
            number = operands[0] if operands and type(operands[0]) is Fraction else None
            return Place(at, number)

        return written

    def named(name: str) -> Place:
        return places[name] if name in places else fold(definitions[name], writers, known)

    writers = {**{op: writer(write) for op, write in algebra.items()}, "symbol": named}
    found = [fold(term, writers, known).at + end for term in terms for end in ends]
    arguments = ", ".join(place.at + end for place in places.values() for end in ends)
    body = "\n ".join([*lines, f"return ({', '.join(found)},)"])
    scope: dict[str, Any] = {"pair": _cosine, "pair_of_sine": _sine, "power": math.pow}
    scope |= {name: getattr(math, name) for name in ("cos", "sin", "sqrt", "exp", "log", "atan")}
    scope |= {"pi": math.pi, "inf": math.inf}
    exec(f"def function({arguments}):\n {body}", scope)  # noqa: S102  what is written above
    function: Callable[..., Any] = scope["function"]
    return function


# --- values --------------------------------------------------------------------------------------


def estimates(
    names: Sequence[str], terms: Sequence[Term], definitions: Mapping[str, Term]
) -> Callable[..., tuple[float, ...]]:
    """The values of terms at floats.

    The function raises an ArithmeticError or a ValueError where a term has none, a KeyError is
    raised here for a name that is not known.
    """
    return _code(names, terms, definitions, _VALUES, ("",))


def _written(pattern: str) -> Callable[..., list[str]]:
    """A line with the variables of the operands, of which there may be many."""

    def lines(at: str, *operands: Place) -> list[str]:
        places = [operand.at for operand in operands]
        return [f"{at} = {pattern.format(*places, all=', '.join(places))}"]

    return lines


_VALUES: Lines = {
    "rational": lambda at, value: [f"{at} = {float_of(value)!r}"],
    "add": _written("{} + {}"),
    "sub": _written("{} - {}"),
    "mul": _written("{} * {}"),
    "div": _written("{} / {}"),
    "neg": _written("-{}"),
    "pow": lambda at, a, exponent: [f"{at} = {a.at} ** {exponent}"],
    "sqrt": _written("sqrt({})"),
    "min": _written("min({all})"),
    "max": _written("max({all})"),
    "cos_pi": _written("cos(pi * {})"),
    "pi": _written("pi"),
    "root": lambda at, a, index: [f"{at} = power({a.at}, 1 / {index})"],
    **{op: _written(f"{op}({{}})") for op in ("cos", "sin", "exp", "log", "atan")},
}


# --- ranges --------------------------------------------------------------------------------------


def range_function(
    names: Sequence[str], terms: Sequence[Term], definitions: Mapping[str, Term]
) -> Ranges:
    """The ends between which terms lie, as the checker evaluates them, up to rounding."""
    return _code(names, terms, definitions, _RANGES, ("l", "h"))


def _ends(low: str, high: str) -> Callable[..., list[str]]:
    """A line for each end."""

    def lines(at: str, *operands: Place) -> list[str]:
        places = [operand.at for operand in operands]
        every = {f"all_{end}": ", ".join(place + end for place in places) for end in "lh"}
        return [
            f"{at}l = {low.format(*places, **every)}",
            f"{at}h = {high.format(*places, **every)}",
        ]

    return lines


def _quotient(at: str, a: Place, b: Place) -> list[str]:
    guard = f"if {b.at}l <= 0.0 <= {b.at}h: raise ZeroDivisionError"
    inverse = f"{at}il = 1.0 / {b.at}h; {at}ih = 1.0 / {b.at}l"
    return [guard, inverse, *_product(at, a._replace(number=None), Place(f"{at}i"))]


def _product(at: str, a: Place, b: Place) -> list[str]:
    for c, x in ((a, b.at), (b, a.at)):
        if c.number is not None:
            low, high = (f"{x}l", f"{x}h") if c.number >= 0 else (f"{x}h", f"{x}l")
            return [f"{at}l = {c.at}l * {low}", f"{at}h = {c.at}l * {high}"]
    p, q = a.at, b.at
    return [
        f"if {p}l >= 0.0 and {q}l >= 0.0:",
        f"  {at}l = {p}l * {q}l; {at}h = {p}h * {q}h",
        "else:",
        f"  p, q, r, s = {p}l * {q}l, {p}l * {q}h, {p}h * {q}l, {p}h * {q}h",
        f"  {at}l = min(p, q, r, s); {at}h = max(p, q, r, s)",
    ]


def _power(at: str, base: Place, n: int) -> list[str]:
    a, low, high = base.at, f"{at}l", f"{at}h"
    if n % 2:
        return [f"{low} = {a}l ** {n}", f"{high} = {a}h ** {n}"]
    return [
        f"if {a}l >= 0.0: {low} = {a}l ** {n}; {high} = {a}h ** {n}",
        f"elif {a}h <= 0.0: {low} = {a}h ** {n}; {high} = {a}l ** {n}",
        f"else: {low} = 0.0; {high} = max(-{a}l, {a}h) ** {n}",
    ]


def _root(at: str, base: Place, index: int) -> list[str]:
    return [f"{at}{end} = power({base.at}{end}, 1 / {index})" for end in "lh"]


_RANGES: Lines = {
    "rational": lambda at, value: [f"{at}l = {at}h = {float_of(value)!r}"],
    "add": _ends("{0}l + {1}l", "{0}h + {1}h"),
    "sub": _ends("{0}l - {1}h", "{0}h - {1}l"),
    "neg": _ends("-{0}h", "-{0}l"),
    "mul": _product,
    "div": _quotient,
    "pow": _power,
    "sqrt": _ends("sqrt({0}l)", "sqrt({0}h)"),
    "min": _ends("min({all_l})", "min({all_h})"),
    "max": _ends("max({all_l})", "max({all_h})"),
    "cos": lambda at, x: [f"{at}l, {at}h = pair({x.at}l / pi, {x.at}h / pi)"],
    "cos_pi": lambda at, x: [f"{at}l, {at}h = pair({x.at}l, {x.at}h)"],
    "sin": lambda at, x: [f"{at}l, {at}h = pair_of_sine({x.at}l, {x.at}h)"],
    "pi": _ends("pi", "pi"),
    "root": _root,
    **{op: _ends(f"{op}({{0}}l)", f"{op}({{0}}h)") for op in ("exp", "log", "atan")},
}


def _sine(low: float, high: float) -> tuple[float, float]:
    """The ends of sin x between two numbers."""
    low, high = 0.5 - high / math.pi, 0.5 - low / math.pi
    return _cosine(low, high)


def _cosine(low: float, high: float) -> tuple[float, float]:
    """The ends of cos(pi x) between two numbers."""
    first = math.ceil(low)
    ends = [math.cos(math.pi * low), math.cos(math.pi * high)]
    ends += [1.0 - 2.0 * (k % 2) for k in (first, first + 1) if k <= high]
    return min(ends), max(ends)
