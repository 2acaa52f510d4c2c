"""Random pages with chapters, and a naive evaluator of their text with fractions.

The evaluator knows nothing of the reader: a formula is Python with `F(...)` around its numbers, and
a name means what the nearest context says, as a person reads a page.
"""

from __future__ import annotations

import random
import re
from collections.abc import Iterator, Mapping
from fractions import Fraction
from typing import Any, NamedTuple

NAMES = ("x", "y", "z", "u", "x_1", "t")
RANGES = (("0", "1"), ("-1", "1"), ("0", "2"), ("1", "2"), ("-2", "0"))
Values = Mapping[str, Any]


class Context:
    """A context as it is written."""

    def __init__(self, name: str, parent: Context | None, variables: list[str]) -> None:
        self.name, self.parent, self.variables = name, parent, variables
        self.givens: dict[str, str] = {}
        self.before: dict[str, str] = {}  # abbreviations of the context, then its constants
        self.let: dict[str, str] = {}  # those of chapters so far
        self.states: dict[str, dict[str, str]] = {}

    @property
    def chain(self) -> list[Context]:
        """The contexts around it, from the outside in, and itself."""
        return [*(self.parent.chain if self.parent else []), self]


class Row(NamedTuple):
    """A row: its context, what it claims there, at which values, and with which abbreviations."""

    name: str
    context: Context | None
    claim: str
    let: dict[str, str]
    of: Context | None = None
    at: Mapping[str, str] | None = None
    negated: bool = False


class Pages:
    """One random page, with its rows and what they mean."""

    def __init__(self, seed: int) -> None:
        self.draw, self.count = random.Random(seed), 0
        self.top: dict[str, str] = {}
        self.contexts: list[Context] = []
        self.rows: list[Row] = []
        self.facts: dict[str, Context | None] = {}
        self.text = "\n".join(['title = "drawn"', *self._page()]) + "\n"

    # --- what is written ------------------------------------------------------------------------

    def _names(self, context: Context | None) -> list[str]:
        found = [*self.top]
        for place in context.chain if context else ():
            found += [*place.variables, *place.before, *place.let]
        return [*found, *(f"f({name})" for name in (context.variables if context else ["1/2"]))]

    def _term(self, names: list[str], depth: int = 2) -> str:
        draw = self.draw
        if depth == 0 or draw.random() < 0.3:
            is_name = names and draw.random() < 0.75
            return draw.choice(names if is_name else ["1", "2", "1/2", "3", "1/3", "0"])
        a, b = (self._term(names, depth - 1) for _ in "ab")
        forms = (f"({a} + {b})", f"({a} - {b})", f"({a})*({b})", f"({a})^2", f"min({a}, {b})")
        return draw.choice((*forms, f"max({a}, {b})", f"({a})/(1 + ({b})^2)"))

    def _claim(self, names: list[str]) -> str:
        sign = self.draw.choice(("<=", "<=", "<", ">=", ">", "="))
        return f"{self._term(names)} {sign} {self._term(names)}"

    def _new(self, letter: str) -> str:
        self.count += 1
        return f"{letter}{self.count}"

    def _page(self) -> Iterator[str]:
        draw = self.draw
        self.top["L"] = self._term([], 1)
        yield from ("[let]", f'L = "{self.top["L"]}"', '"f(w)" = "w + L"', "[constants]")
        self.top["c"] = self._term(["L"], 1)
        yield f'c = "{self.top["c"]}"'
        for name in ("P", "Q", "R")[: draw.randint(1, 3)]:
            yield from self._context(name)
        for _ in range(draw.randint(1, 4)):
            yield from self._chapter(draw.choice([*self.contexts, None]))

    def _context(self, name: str) -> Iterator[str]:
        draw = self.draw
        taken = {v for context in self.contexts for v in context.variables}
        free = [v for v in NAMES if v not in taken]
        variables = draw.sample(free, draw.randint(1, 2))
        context = Context(name, draw.choice([None, None, *self.contexts]), variables)
        for variable in variables:
            low, high = draw.choice(RANGES)
            context.givens[self._new("g")] = f"{low} <= {variable}"
            context.givens[self._new("g")] = f"{variable} {draw.choice(('<=', '<'))} {high}"
        own = [v for place in context.chain for v in place.variables] + [*self.top]
        if draw.random() < 0.2:
            context.givens[self._new("g")] = self._claim(own)
        self.facts |= dict.fromkeys(context.givens, context)
        context.states["next"] = {v: self._term(own, 1) for v in variables}
        context.states["one"] = {v: self._term([], 1) for v in variables}
        short, constant = self._new("h"), self._new("k")
        context.before[short] = self._term(own, 1)
        context.before[constant] = self._term([*own, short], 1)
        yield f'[contexts.{name}]\nvariables = "{" ".join(variables)}"'
        if context.parent:
            yield f'in = "{context.parent.name}"'
        yield f'let = {{ {short} = "{context.before[short]}" }}'
        yield f'constants = {{ {constant} = "{context.before[constant]}" }}'
        states = (f'{key} = "{_values(state)}"' for key, state in context.states.items())
        yield f"states = {{ {', '.join(states)} }}"
        givens = (f'{key} = "{claim}"' for key, claim in context.givens.items())
        yield f"given = {{ {', '.join(givens)} }}"
        self.contexts.append(context)

    def _chapter(self, context: Context | None) -> Iterator[str]:
        draw = self.draw
        yield "[[chapters]]" + (f'\nin = "{context.name}"' if context else "")
        if context and draw.random() < 0.5:
            name = draw.choice([*(["L"] if "L" not in context.let else []), self._new("q")])
            context.let = context.let | {name: self._term(self._names(context), 1)}
            yield f'let = {{ {name} = "{context.let[name]}" }}'
        yield "[chapters.rows]"
        for _ in range(draw.randint(1, 4)):
            other = context if draw.random() < 0.8 else draw.choice(self.contexts)
            yield self._line(other, "" if other is context else f', in = "{other.name}"')

    def _line(self, context: Context | None, extra: str) -> str:
        draw, name = self.draw, self._new("r")
        kind, by = draw.random(), self._by(context)
        row = Row(name, context, self._claim(self._names(context)), context.let if context else {})
        around = [place for place in self.contexts if context in (place, place.parent)]
        if kind < 0.2 and around:
            of = draw.choice(around)
            given, state = draw.choice([*of.givens]), draw.choice(("one", "next"))
            state = state if of is context else "one"
            row = row._replace(of=of, at=of.states[state], claim=of.givens[given], let={})
            self.rows.append(row)
            self.facts[name] = context
            return f'{name} = {{ claim = "{given} at {state}"{by}{extra} }}'
        if kind < 0.4 and context:
            at = {v: draw.choice(("0", "1", "1/2", "-1")) for v in context.variables}
            key = draw.choice(("at", "false_at"))
            if key == "at":
                row = row._replace(context=context.parent, of=context, at=at)
            self.rows.append(row)
            return f'{name} = {{ claim = "{row.claim}", {key} = "{_values(at)}"{extra} }}'
        row = row._replace(negated=kind > 0.85 and bool(by))
        self.rows.append(row)
        if row.negated:
            return f'{name} = {{ claim = "{row.claim}", verdict = "refuted"{by}{extra} }}'
        self.facts[name] = context
        word = "lemma" if kind < 0.55 else "claim"
        return f'{name} = {{ {word} = "{row.claim}"{by}{extra} }}'

    def _by(self, context: Context | None) -> str:
        draw = self.draw
        around = (*context.chain, None) if context else (None,)
        known = [name for name, home in self.facts.items() if home in around]
        if not known or draw.random() < 0.4:
            return ""
        some = draw.sample(known, min(len(known), draw.randint(1, 4)))
        squared = f"square({self._term(self._names(context), 1)})"
        forms = (" ".join(some), " ".join([*some, squared]), f"goal + {some[0]}")
        product = f"goal*2 + {'*'.join(some)}"
        return f', by = "{draw.choice((*forms, product))}"'

    # --- what it means --------------------------------------------------------------------------

    def _meanings(
        self, context: Context | None, values: Mapping[str, Fraction], let: Mapping[str, str]
    ) -> dict[str, Any]:
        """What each name means in a context, at values of the variables."""
        found: dict[str, Any] = {}
        for name, text in self.top.items():
            found[name] = _value(text, found)
        least = found["L"]
        found["f"] = lambda w: w + least
        chain = context.chain if context else []
        for place in chain:
            found |= {v: values[v] for v in place.variables}
            here = let if place is context else place.let
            for name, text in (*place.before.items(), *here.items()):
                found[name] = _value(text, found)
        return found

    def points(self, context: Context | None, number: int = 60) -> Iterator[dict[str, Fraction]]:
        """Values at which all givens hold."""
        draw, chain = random.Random(3), context.chain if context else []
        for _ in range(number):
            values = {
                v: Fraction(draw.randint(-16, 16), 8) for place in chain for v in place.variables
            }
            if all(
                holds(given, self._meanings(place, values, {}))
                for place in chain
                for given in place.givens.values()
            ):
                yield values

    def is_true(self, row: Row, values: dict[str, Fraction]) -> bool:
        """Whether a row holds at values of the variables in scope."""
        if row.of is None or row.at is None:
            return holds(row.claim, self._meanings(row.context, values, row.let))
        here = self._meanings(row.context, values, {})  # where the values of a state are written
        there = values | {name: _value(text, here) for name, text in row.at.items()}
        return holds(row.claim, self._meanings(row.of, there, row.let))


def _values(state: Mapping[str, str]) -> str:
    return ", ".join(f"{name} = {text}" for name, text in state.items())


def _value(text: str, names: Values) -> Any:
    python = re.sub(r"(?<![\w^])\d+", lambda found: f"F({found[0]})", text).replace("^", "**")
    return eval(python, {"F": Fraction, "min": min, "max": max}, dict(names))


def holds(claim: str, names: Values) -> bool:
    """Whether a comparison of two terms is true."""
    left, sign, right = re.split(r" (<=|>=|<|>|=) ", claim)
    a, b = _value(left, names), _value(right, names)
    return {"<=": a <= b, ">=": a >= b, "<": a < b, ">": a > b, "=": a == b}[sign]
