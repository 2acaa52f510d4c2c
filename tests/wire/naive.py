"""A second reader of SMT-LIB and FPCore: it only evaluates a text where its variables have values.

Written apart from the package, and as plainly as possible: numbers are fractions, a scope is a
dictionary that is copied, and everything is evaluated anew whenever it is met.
"""

from __future__ import annotations

from collections.abc import Iterator
from fractions import Fraction
from itertools import combinations, pairwise
from typing import Any

At = dict[str, Fraction]


def tokens(text: str) -> Iterator[str]:
    """The words and brackets of a text; a quoted symbol loses its bars, with a mark before it."""
    i = 0
    while i < len(text):
        sign = text[i]
        if sign in " \t\r\n":
            i += 1
        elif sign == ";":
            while i < len(text) and text[i] != "\n":
                i += 1
        elif sign in "()[]":
            yield {"[": "(", "]": ")"}.get(sign, sign)
            i += 1
        elif sign in '"|':
            end = i + 1
            while text[end] != sign:
                end += 2 if text[end] == "\\" and sign == '"' else 1
            yield sign + text[i + 1 : end]
            i = end + 1
        else:
            end = i
            while end < len(text) and text[end] not in ' \t\r\n()[];"|':
                end += 1
            yield text[i:end]
            i = end


def trees(text: str) -> list[Any]:
    """The lists in a text."""
    stack: list[list[Any]] = [[]]
    for token in tokens(text):
        if token == "(":
            stack.append([])
        elif token == ")":
            done = stack.pop()
            stack[-1].append(done)
        else:
            stack[-1].append(token)
    (found,) = stack
    return found


def name_of(token: str) -> str:
    """A name without its bars, except where it would be no name."""
    plain = token.removeprefix("|")
    return token if plain[:1] in set('0123456789":#') else plain


def evaluate(tree: Any, scope: dict[str, Any]) -> Any:
    """A number, or a truth value."""
    if isinstance(tree, str):
        if name_of(tree) in scope:
            return scope[name_of(tree)]
        return {"true": True, "false": False, "TRUE": True}.get(tree) or number(tree)
    head, *rest = tree
    if head in ("let", "let*"):
        inner = dict(scope)
        for name, body in rest[0]:
            inner[name_of(name)] = evaluate(body, inner if head == "let*" else scope)
        return evaluate(rest[1], inner)
    if head == "!":
        return evaluate(rest[-1] if rest[0].startswith(":") else rest[0], scope)
    if name_of(head) in scope:
        parameters, body, around = scope[name_of(head)]
        values = [evaluate(part, scope) for part in rest]
        return evaluate(body, {**around, **dict(zip(parameters, values, strict=True))})
    if head in ("ite", "if"):
        return evaluate(rest[1] if evaluate(rest[0], scope) else rest[2], scope)
    return applied(head, [evaluate(part, scope) for part in rest])


def number(text: str) -> Any:
    return False if text in ("false", "FALSE") else Fraction(text)


def applied(head: str, found: list[Any]) -> Any:
    """An operation of values."""
    first, *others = found
    if head in ("<", "<=", "=", "==", ">=", ">"):
        return all(related(head, a, b) for a, b in pairwise(found))
    if head in ("distinct", "!="):
        return all(a != b for a, b in combinations(found, 2))
    if head == "not":
        return not first
    if head in ("and", "or"):
        return all(found) if head == "and" else any(found)
    if head == "=>":
        return found[-1] if all(found[:-1]) else True
    if head in ("xor", "+", "*", "-", "/"):
        if not others:
            return -first if head == "-" else first
        for other in others:
            first = step(head, first, other)
        return first
    if head in ("^", "pow"):
        return first ** int(others[0])
    return {"min": min, "max": max, "fmin": min, "fmax": max, "abs": abs, "fabs": abs}[head](*found)


def related(head: str, a: Any, b: Any) -> bool:
    signs = {"<": a < b, "<=": a <= b, "=": a == b, "==": a == b, ">=": a >= b, ">": a > b}
    return signs[head]


def step(head: str, a: Any, b: Any) -> Any:
    if head == "xor":
        return a != b
    if head == "/":
        return a / b
    return a + b if head == "+" else a * b if head == "*" else a - b


class Session:
    """What a file of SMT-LIB has said; at each ``(check-sat)`` what is asserted there."""

    def __init__(self, text: str) -> None:
        self.asked: list[tuple[list[str], list[tuple[Any, dict[str, Any]]]]] = []
        self.stack: list[tuple[dict[str, Any], list[Any]]] = [({}, [])]
        for command in trees(text):
            if command[0] == "exit":
                break
            self.do(command)

    def do(self, command: list[Any]) -> None:
        """Do a command."""
        head, *rest = command
        names, asserted = self.stack[-1]
        if head in ("declare-const", "declare-fun"):
            names[name_of(rest[0])] = None
        elif head in ("define-const", "define-fun"):
            pairs = rest[1] if head == "define-fun" else []
            parameters = [name_of(name) for name, _ in pairs]
            names[name_of(rest[0])] = (parameters, rest[-1], self.scope(), len(parameters))
        elif head == "assert":
            body = rest[0]
            if isinstance(body, list) and body[0] == "!":
                names[name_of(body[3])] = ([], body[1], self.scope(), 0)
                body = body[1]
            asserted.append((body, self.scope()))
        elif head == "push":
            names, asserted = self.stack[-1]
            for _ in range(int(rest[0]) if rest else 1):
                self.stack.append((dict(names), list(asserted)))
        elif head == "pop":
            del self.stack[len(self.stack) - (int(rest[0]) if rest else 1) :]
        elif head in ("reset-assertions", "reset"):
            self.stack = [({}, [])]
        elif head == "check-sat":
            self.asked.append(([n for n, v in names.items() if v is None], list(asserted)))

    def scope(self) -> dict[str, Any]:
        return dict(self.stack[-1][0])


def ready(scope: dict[str, Any], at: At) -> dict[str, Any]:
    """A scope in which variables have their values, and what was defined stands for its value."""
    found: dict[str, Any] = {}
    for name, value in scope.items():
        if value is None:
            found[name] = at[name]
        else:
            parameters, body, around, count = value
            inner = ready(around, at)
            found[name] = (parameters, body, inner) if count else evaluate(body, inner)
    return found


def holds(asserted: list[tuple[Any, dict[str, Any]]], at: At) -> bool:
    """Whether all assertions hold at some values."""
    return all(evaluate(body, ready(scope, at)) for body, scope in asserted)


def core(text: str) -> list[tuple[list[str], Any, Any]]:
    """The inputs, the precondition and the body of each expression of FPCore."""
    found = []
    for _, *rest in trees(text):
        inputs, *properties, body = rest if isinstance(rest[0], list) else rest[1:]
        table = dict(zip(properties[::2], properties[1::2], strict=True))
        found.append((inputs, table.get(":pre", "TRUE"), body))
    return found
