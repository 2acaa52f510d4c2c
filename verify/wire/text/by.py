"""What a line of a page follows from, as text: names of facts, or the products that are added.

    by = "tau-positive B-positive D-one"
    by = "goal*Cnd1 + next-Cnd4*(1 + 2*eta_bar-positive) + square(x - y)"

Names alone leave it to the search to find the products. In a sum every number is at least 0: the
difference of the sides of a fact, ``goal`` for that of the claim if it were false, a rational
number, a square or a root. The rule is `sum` in `verify/check.py`.
"""

from __future__ import annotations

import re
from collections.abc import Callable, Sequence

from verify.language.argument import Value
from verify.language.terms import MAX_EXPONENT, Term
from verify.wire.inputs import InputError, shown
from verify.wire.text.written import term_text

GOAL = "goal"
#: What is at least 0 for any term, and for a root.
TERMS = ("square", "root")
MINUS = "a - is not possible, since each part has to be at least 0; write + and * only"
_TOKEN = re.compile(
    r"\s*(?:(?P<number>[0-9]+(?:/[0-9]+|\.[0-9]+)?)|(?P<name>@[0-9]+|[A-Za-z][A-Za-z0-9_.:-]*)|(?P<sign>[-+*^()]))"
)


class Facts(tuple[Value, ...]):
    """Facts, and squares, of which the products are to be found."""

    __slots__ = ()


def read_by(
    where: object, text: str, fact: Callable[[str], None], term: Callable[[str], Term]
) -> Facts | tuple[Value, ...]:
    """The addends of a sum, or the facts if the text has names only.

    Args:
        where: the place in a file, for messages.
        text: what is read.
        fact: raises the error of a name that may not be used.
        term: reads what stands in ``square(...)``.

    Raises:
        InputError: naming the place, and what to write instead.
    """
    try:
        return _Reader(where, text, fact, term).all()
    except RecursionError as error:
        raise InputError(f"{where}: {shown(text)} nests too deeply; name its parts") from error


class _Reader:
    """Reads one text from left to right."""

    def __init__(
        self, where: object, text: str, fact: Callable[[str], None], term: Callable[[str], Term]
    ) -> None:
        self.where, self.text, self.fact, self.term = where, text, fact, term
        self.at = 0

    def error(self, what: str) -> InputError:
        return InputError(f"{self.where}: {shown(self.text, 80)}: {what}")

    def peek(self) -> tuple[str, str]:
        """The kind of the next token, and its text; nothing at the end."""
        match = _TOKEN.match(self.text, self.at)
        if match is None:
            if self.text[self.at :].strip():
                raise self.error(f"cannot read {shown(self.text[self.at :].strip()[:12])}")
            return "end", ""
        return match.lastgroup or "", match[match.lastgroup or 0]

    def take(self) -> tuple[str, str]:
        """The next token, and go on."""
        found, match = self.peek(), _TOKEN.match(self.text, self.at)
        self.at = match.end() if match else self.at
        return found

    def sign(self, *signs: str) -> bool:
        """Go on if one of these signs comes next."""
        kind, word = self.peek()
        if kind == "sign" and word in signs:
            self.take()
            return True
        return False

    def all(self) -> Facts | tuple[Value, ...]:
        if self.peek()[0] == "end":
            return Facts()
        found = self.addends()
        if self.peek()[0] == "end" and not (len(found) == 1 and self.is_fact(found[0])):
            return found
        facts = list(found)
        while self.peek()[0] in ("name", "number"):
            facts.append(self.factor())
        if self.peek()[0] != "end":
            word = self.take()[1]
            raise self.error(MINUS if word == "-" else f"{shown(word)} does not belong there")
        for fact in facts:
            if not self.is_fact(fact):
                raise self.error(
                    "names of facts stand beside a product; write a + between, and goal for the "
                    "claim if it were false"
                )
        return Facts(facts)

    @staticmethod
    def is_fact(value: Value) -> bool:
        """Whether this is the name of a fact, or a square or root."""
        if isinstance(value, tuple):
            return value[0] in TERMS
        return value != GOAL and not value[0].isdigit()

    def addends(self) -> tuple[Value, ...]:
        found = [self.product()]
        while self.sign("+"):
            found.append(self.product())
        return tuple(found)

    def product(self) -> Value:
        factors = [self.power()]
        while self.sign("*"):
            factors.append(self.power())
        return factors[0] if len(factors) == 1 else ("mul", *factors)

    def power(self) -> Value:
        base = self.factor()
        if not self.sign("^"):
            return base
        kind, word = self.take()
        if kind != "number" or not word.isdigit() or not 1 <= int(word[:9]) <= MAX_EXPONENT:
            raise self.error(f"an exponent is a whole number from 1 to {MAX_EXPONENT}")
        return ("pow", base, int(word))

    def factor(self) -> Value:
        kind, word = self.take()
        if kind == "number":
            return str(self.term(word).value)
        if (kind, word) == ("sign", "("):
            inner = self.addends()
            self.expect(")")
            return inner[0] if len(inner) == 1 else ("add", *inner)
        if (kind, word) == ("sign", "-"):
            raise self.error(MINUS)
        if kind != "name":
            raise self.error(
                f"{shown(word) if word else 'it ends'}, where the name of a fact is missing"
            )
        if word in TERMS and self.peek() == ("sign", "("):
            return (word, self.enclosed())
        if word != GOAL:
            self.fact(word)
        return word

    def enclosed(self) -> Term:
        """The term between the parentheses that come next."""
        self.expect("(")
        depth, start = 1, self.at
        while depth and self.at < len(self.text):
            depth += {"(": 1, ")": -1}.get(self.text[self.at], 0)
            self.at += 1
        if depth:
            raise self.error("a ) is missing")
        return self.term(self.text[start : self.at - 1])

    def expect(self, sign: str) -> None:
        if not self.sign(sign):
            raise self.error(f"a {sign} is missing")


# --- writing -------------------------------------------------------------------------------------


def by_text(addends: Sequence[Value], written: Callable[[Term], str] = term_text) -> str:
    """The text that `read_by` reads as these addends, or these facts."""
    if isinstance(addends, Facts):
        return " ".join(_factor(value, written) for value in addends)
    return " + ".join(_product(value, written) for value in addends)


def _product(value: Value, written: Callable[[Term], str]) -> str:
    if isinstance(value, tuple) and value[0] == "mul":
        return "*".join(_factor(part, written) for part in value[1:])  # type: ignore[arg-type]
    return _factor(value, written)


def _factor(value: Value, written: Callable[[Term], str]) -> str:
    if isinstance(value, str):
        return value
    kind, *parts = value
    if kind in TERMS:
        return f"{kind}({written(parts[0])})"  # type: ignore[arg-type]
    if kind == "pow":
        return f"{_factor(parts[0], written)}^{parts[1]}"  # type: ignore[arg-type]
    if kind == "mul":
        return f"({_product(value, written)})"
    return f"({by_text(parts, written)})"  # type: ignore[arg-type]
