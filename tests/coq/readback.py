"""Reads the definitions of an exported file, and a statement, each into plain nested tuples.

Nothing here comes from the exporter or from the checker: the file is read as text, the statement
as JSON.
"""

from __future__ import annotations

import json
import re
from collections.abc import Iterator
from fractions import Fraction
from typing import Any, NamedTuple

Json = Any
OPERATIONS = {
    "NAdd": "add", "NSub": "sub", "NMul": "mul", "NDiv": "div", "NNeg": "neg", "NPow": "pow",
    "NSqrt": "sqrt", "NMin": "min", "NMax": "max", "NCos": "cos", "NCosPi": "cos_pi",
    "NPi": "pi", "NOf Exp": "exp", "NOf Log": "log", "NOf Sin": "sin", "NOf Atan": "atan",
}  # fmt: skip
RELATIONS = {"Less": "<", "AtMost": "<=", "Equal": "=", "Differs": "!="}


class Said(NamedTuple):
    """All that a statement says; terms are numbers of an `Interner`."""

    constants: list[Any]  # context and definition
    contexts: list[Any]  # parent, variables, givens, point
    rows: list[Any]  # context, verdict, whether it is needed, sentence
    cited: list[Any]  # context and claim


class Interner:
    """Each distinct term is a number."""

    def __init__(self) -> None:
        self.numbers: dict[Any, int] = {}

    def __call__(self, *key: Any) -> int:
        return self.numbers.setdefault(key, len(self.numbers))


# --- the exported file ----------------------------------------------------------------------------


def tokens(text: str) -> Iterator[str]:
    """The words and brackets of a definition, without comments and scopes."""
    plain = re.sub(r"\(\*.*?\*\)", "", text, flags=re.DOTALL).replace("%nat", "")
    yield from re.findall(r"[][();,]|[^][();,\s]+", plain)


def parsed(words: Iterator[str], end: str = "") -> list[Any]:
    """Items up to a closing bracket: applications as lists, lists and pairs as tuples."""
    items: list[Any] = []
    item: list[Any] = []
    for word in words:
        if word in (")", "]", ";", ","):
            if item:
                items.append(item[0] if len(item) == 1 else item)
            item = []
            if word == end:
                return items
        elif word == "(":
            inner = parsed(words, ")")
            item.append(inner[0] if len(inner) == 1 else tuple(inner))
        elif word == "[":
            item.append(tuple(parsed(words, "]")))
        else:
            item.append(word)
    return [*items, item]


def definition(text: str, name: str) -> Any:
    """What a definition says."""
    body = re.search(rf"^Definition {name} : [^=]* :=(.*?)\.$", text, re.DOTALL | re.MULTILINE)
    assert body, name
    return parsed(iter([*tokens(body[1])]))[0]


def in_digits(printed: str) -> str:
    """The same with digits for numbers, which Coq prints by their constructors: that is faster.

    A positive number is ``xH`` with its further binary digits, a natural one ``O`` or ``S (S O)``.
    """

    def successors(match: re.Match[str]) -> str:
        more = match[1].count("(")
        return f"{1 + more}{match[2][more:]}"

    text = re.sub(r"\bS((?: \(S)*) O\b(\)*)", successors, printed)
    text = re.sub(r"\bxH((?:~[01])*)", lambda m: str(int("1" + m[1].replace("~", ""), 2)), text)
    return re.sub(r"\b(O|Z0)\b", "0", text.replace("Z.pos ", "").replace("Z.neg ", "-"))


def as_exported(printed: str, module: str) -> str:
    """What Coq has printed of the definitions in a module, as an exported file has them."""
    parts = re.findall(
        rf"^{module}\.(the_\w+) = (.*?)\n {{5}}: (.*?)$", printed, re.DOTALL | re.MULTILINE
    )
    lines = [f"Definition {name} : {kind} :=\n{in_digits(value)}.\n" for name, value, kind in parts]
    # A word of the language keeps the module before it: there it would mean something else.
    return re.sub(rf"\b{module}\.(?=the_(nodes|contexts|rows|citations)\b)", "", "".join(lines))


def number(text: str | list[str]) -> int:
    """A whole number; also in hexadecimal digits."""
    return int(text, 0)  # type: ignore[arg-type]


class Exported:
    """The statement in an exported file."""

    def __init__(self, text: str, intern: Interner) -> None:
        self.intern = intern
        (self.nodes,) = definition(text, "the_nodes")
        self.terms: dict[int, int] = {}
        (contexts,) = definition(text, "the_contexts")
        whole = definition(text, "the_statement")
        assert [*whole[:3], *whole[5:7]] == [
            "Statement", "the_nodes", "the_contexts", "the_rows", "the_citations",
        ]  # fmt: skip
        self.own, own_constants, self.values = whole[3], whole[4], whole[7]
        self.variables = {
            number(name): (i, j)
            for i, context in enumerate(contexts, 1)
            for j, name in enumerate(context[2])
        }
        self.said = Said(
            [self.constant(number(i)) for i in own_constants],
            [self.context(context) for context in contexts],
            [self.row(row) for row in definition(text, "the_rows")[0]],
            [self.fact(fact) for fact in definition(text, "the_citations")[0]],
        )

    def term(self, text: str) -> int:
        """A term by its number in the file."""
        i = number(text)
        if i not in self.terms:
            self.terms[i] = self.node(i, self.nodes[i - 1])
        return self.terms[i]

    def node(self, i: int, node: list[Any]) -> int:
        """A node; a constant is its context and its definition."""
        kind, *rest = [node] if isinstance(node, str) else node
        if kind == "NOf":
            if rest[0][0] == "NthRoot":
                return self.intern("root", self.term(rest[1]), number(rest[0][1]))
            kind, *rest = f"NOf {rest[0]}", *rest[1:]
        if kind == "NRational":
            return self.intern("rational", Fraction(number(rest[0]), number(rest[1])))
        if kind == "NVariable":
            assert self.variables[i][0] == number(rest[0])
            return self.intern("variable", *self.variables[i])
        if kind == "NConstant":
            return self.intern("constant", number(rest[0]), self.term(rest[1]))
        if kind == "NPow":
            return self.intern("pow", self.term(rest[0]), number(rest[1]))
        below = [rest[0], *rest[1]] if kind in ("NMin", "NMax") else rest
        return self.intern(OPERATIONS[kind], *map(self.term, below))

    def constant(self, i: int) -> Any:
        """The context and the definition of a constant."""
        kind, context, term = self.nodes[i - 1]
        assert kind == "NConstant"
        return number(context), self.term(term)

    def claim(self, claim: list[str]) -> Any:
        """A claim."""
        assert claim[0] == "Claim"
        return RELATIONS[claim[1]], self.term(claim[2]), self.term(claim[3])

    def table(self, pairs: Any) -> Any:
        """Terms for variables."""
        return {self.variables[number(name)]: self.term(term) for name, term in pairs}

    def context(self, context: list[Any]) -> Any:
        """A context."""
        _, parent, variables, givens, point = context
        facts = [(self.claim(given[2]), given[3].lower()) for given in givens]
        return number(parent), len(variables), facts, self.table(point)

    def row(self, row: list[Any]) -> Any:
        """A row."""
        _, _, context, verdict, needed, sentence = row
        kind, *rest = sentence
        if kind == "Compare":
            said: Any = self.claim(rest[0])
        else:
            said = (kind.lower(), number(rest[0]), *map(self.table, rest[1:]))
        return number(context), verdict.lower(), needed == "true", said

    def fact(self, fact: Any) -> Any:
        """A fact of a cited statement."""
        return number(fact[1][0]), self.claim(fact[1][1])


# --- the statement --------------------------------------------------------------------------------


class Written:
    """A statement in JSON, with those that it cites."""

    def __init__(self, document: Json, available: dict[str, bytes], intern: Interner) -> None:
        self.intern, self.available = intern, available
        self.names: dict[str, int] = {}
        self.shared: dict[str, Json] = {}
        self.contexts: dict[str, int] = {}
        self.own: list[int] = []
        self.said = Said([], [], [], [])
        self.read(document, "")

    def read(self, document: Json, prefix: str) -> None:
        """All parts, those of cited statements first."""
        for cite in document["cites"]:
            inner = json.loads(self.available[cite["statement_sha256"]])
            self.read(inner, f"{prefix}{cite['name']}:")
        for name, term in document["parameters"].items():
            self.constant(name, term, 0, prefix)
        self.shared |= {prefix + name: term for name, term in document["terms"].items()}
        for item in document["constants"]:
            self.constant(item["name"], item["term"], 0, prefix)
        for item in document["contexts"]:
            self.context(item, prefix)
        for row in document["obligations"]:
            self.row(row, prefix)

    def term(self, value: Json, prefix: str) -> int:
        """A term."""
        if isinstance(value, str):
            full = prefix + value
            if full in self.names:
                return self.names[full]
            if full in self.shared:
                self.names[full] = self.term(self.shared[full], prefix)
                return self.names[full]
            return self.intern("rational", Fraction(value))
        if value[0] in ("pow", "root"):
            return self.intern(value[0], self.term(value[1], prefix), int(value[2]))
        return self.intern(value[0], *(self.term(part, prefix) for part in value[1:]))

    def claim(self, value: Json, prefix: str) -> Any:
        """A claim."""
        return value[0], self.term(value[1], prefix), self.term(value[2], prefix)

    def constant(self, name: str, value: Json, context: int, prefix: str) -> None:
        """A constant, which a cited statement says is equal to its definition."""
        definition = self.term(value, prefix)
        term = self.names[prefix + name] = self.intern("constant", context, definition)
        if prefix:
            self.said.cited.append((context, ("=", term, definition)))
        else:
            self.said.constants.append((context, definition))

    def table(self, context: int, value: Json, prefix: str) -> Any:
        """Terms for the variables of a context."""
        order = self.order[context]
        return {(context, order[name]): self.term(term, prefix) for name, term in value.items()}

    order: dict[int, dict[str, int]]

    def context(self, item: Json, prefix: str) -> None:
        """A context."""
        number = self.contexts[prefix + item["name"]] = len(self.contexts) + 1
        parent = 0 if item["parent"] is None else self.contexts[prefix + item["parent"]]
        self.order = {**getattr(self, "order", {}), number: {}}
        for i, variable in enumerate(item["variables"]):
            self.names[prefix + variable["name"]] = self.intern("variable", number, i)
            self.order[number][variable["name"]] = i
        givens = [(self.claim(x["claim"], prefix), x["kind"]) for x in item["givens"]]
        point = self.table(number, item["point"], prefix)
        self.said.contexts.append((parent, len(item["variables"]), givens, point))
        if prefix:
            self.said.cited.extend((number, claim) for claim, _ in givens)
        else:
            self.own.append(number)
        for constant in item["constants"]:
            self.constant(constant["name"], constant["term"], number, prefix)

    def row(self, row: Json, prefix: str) -> None:
        """A row."""
        context = 0 if row["context"] is None else self.contexts[prefix + row["context"]]
        kind, *rest = row["claim"]
        if kind in ("applies", "always"):
            number = self.contexts[prefix + rest[0]]
            said: Any = (kind, number, *(self.table(number, part, prefix) for part in rest[1:]))
        else:
            said = self.claim(row["claim"], prefix)
        if not prefix:
            needed = row["role"] == "needed"
            self.said.rows.append((context, row["verdict"], needed, said))
        elif row["verdict"] == "proved" and kind not in ("applies", "always"):
            self.said.cited.append((context, said))
