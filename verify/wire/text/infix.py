"""One formula as people write it, read: ``0 <= x^2 - 2*a*x + sqrt(b) < 1/4``.

A number is exactly what is written: ``0.1`` is 1/10, and ``1/4`` is one rational number, while
``1/(4)`` divides 1 by 4. A power binds more tightly than a minus sign before it, and that more
tightly than a product. Signs of print (``≤``, ``·``, ``√``, ``x²``, ``ψ``) are read too.
"""

from __future__ import annotations

import re
from collections.abc import Callable, Mapping, Sequence
from fractions import Fraction
from functools import partial
from itertools import accumulate
from operator import add
from types import MappingProxyType
from typing import Any

from verify.language.record import TYPE_CHECKING, Record
from verify.language.terms import (
    FUNCTIONS,
    MAX_INDEX,
    MAX_POWER,
    Claim,
    Term,
    absolute,
    any_of,
    as_term,
    exp,
    in_tree,
    joined,
    log,
    names_of,
    nth_root,
    operations_in,
    parts_of,
    pi,
    sqrt,
    symbol,
    unequal,
)
from verify.wire.inputs import InputError, nearest, rational, shown
from verify.wire.text import letters
from verify.wire.text.letters import GREEK, NAMES, name_of
from verify.wire.text.matrices import (
    Spent,
    Table,
    Value,
    entries_of,
    has_value,
    negative,
    over,
    size_of,
    table_of,
    times_zero,
)

if TYPE_CHECKING:
    from verify.wire.text.vectors import Combination, Gram

_LETTERS = f"A-Za-z{''.join(NAMES)}"
#: In a name a Greek letter stands only where a part of it begins: bη is b times η.
_MORE = rf"(?:[A-Za-z0-9_]|(?<=[_.])[{_LETTERS}])"
_NAME = rf"(?:[A-Za-z][A-Za-z0-9_]*:)*[{_LETTERS}]{_MORE}*(?:\.{_MORE}+)*[₀-₉]*"
_TOKEN = re.compile(
    r"\s*(?:(?P<number>(?:[0-9]+\.?[0-9]*|\.[0-9]+)(?:[eE][+-]?[0-9]+)?)"
    rf"|`(?P<quoted>[^`]+)`|(?P<name>{_NAME})|(?P<raised>[⁰¹²³⁴⁵⁶⁷⁸⁹]+)"
    r"|(?P<sign><=|>=|==|!=|\*\*|[-+*/^()<>=,|[\]√≤≥⩽⩾≠·⋅×−]))"
)
_SAME = dict(
    pair.split()
    for pair in ("≤ <=", "⩽ <=", "≥ >=", "⩾ >=", "≠ !=", "== =", "· *", "⋅ *", "× *", "− -", "** ^")
)
_RAISED = str.maketrans("⁰¹²³⁴⁵⁶⁷⁸⁹", "0123456789")
RELATIONS = ("<", "<=", "=", ">=", ">", "!=")

#: What may be a decimal comma, and so long a text is read again for what is meant by it.
_DECIMAL_COMMA, MAX_MENDED = re.compile(r"[0-9],[0-9]"), 400

#: The functions of several numbers, and the names that stand for a number.
MANY = ("min", "max")
NUMBERS: Mapping[str, Term] = {"pi": pi, "e": exp(1)}
#: What a reader writes in operations of the language.
SUGAR: Mapping[str, Callable[[Term], Term]] = {**letters.FUNCTIONS, "ln": log}
#: What joins the terms that stand for the numbers from one to another, and so many terms at most.
SUMS: Mapping[str, Callable[[Term, Term], Term]] = {"sum": Term.__add__, "prod": Term.__mul__}
MAX_TERMS = 1000
#: To use a function or a vector of the page costs as much as to read so many signs.
A_CALL = 150
#: All that is written like a function.
DOT, DIFF = "dot", "diff"
#: What is made of tables, of how many.
OF_TABLES: Mapping[str, int] = {"det": 1, "form": 3}
CALLED = (*FUNCTIONS, *MANY, "root", *SUMS, *SUGAR, DOT, DIFF, *OF_TABLES)


def added(x: Value, y: Value, sign: str) -> Value:
    """The sum or the difference of two terms, or of two tables."""
    if isinstance(x, Term) and isinstance(y, Term):
        return x + y if sign == "+" else x - y
    from verify.wire.text import linear_algebra  # loaded only where there are tables

    return linear_algebra.added(x, y, sign)


def times(x: Value, y: Value) -> Value:
    """The product of two terms, two tables, or a term and a table."""
    if isinstance(x, Term) and isinstance(y, Term):
        return x * y
    from verify.wire.text import linear_algebra  # loaded only where there are tables

    return linear_algebra.times(x, y)


class Formula(Record):
    """What a text says: terms with the relations between them, of which a term alone has none.

    ``moduli`` has for each term that is written ``|t|`` the term t.
    """

    terms: tuple[Term, ...]
    relations: tuple[str, ...]
    moduli: tuple[Term | None, ...]

    def claims(self) -> tuple[Claim, ...]:
        """A claim for each relation; ``a > b`` is the claim ``b < a``."""
        sides = zip(self.terms, self.terms[1:], strict=False)
        return tuple(
            _claim(relation, left, right)
            for relation, (left, right) in zip(self.relations, sides, strict=True)
        )

    def bounds(self) -> tuple[Claim, ...]:
        """The same, with the two claims ``-b <= t`` and ``t <= b`` for ``|t| <= b``."""
        inside = zip(self.moduli, self.moduli[1:], strict=False)
        found: list[Claim] = []
        for claim, relation, pair in zip(self.claims(), self.relations, inside, strict=True):
            term = pair[1] if relation[0] == ">" else pair[0]
            if term is None or relation in ("=", "!="):
                found.append(claim)
            else:
                bound = claim.rhs
                low = as_term(-bound.value) if bound.op == "rational" else -bound
                found.append(Claim(claim.relation, low, term))
                found.append(Claim(claim.relation, term, bound))
        return tuple(found)


class Joined(Record):
    """Formulas with and between them, or with or; some of them may be joined themselves."""

    word: str
    parts: tuple[Formula | Joined, ...]


def _claim(relation: str, left: Term, right: Term) -> Claim:
    if relation == "!=":
        return unequal(left, right)
    return (
        Claim("<" + relation[1:], right, left)
        if relation[0] == ">"
        else Claim(relation, left, right)
    )


class PageFunction(Record):
    """A function that a page defines: its formula is read anew wherever it is used.

    It knows the names that are known where it is defined.
    """

    place: object
    parameters: tuple[str, ...]
    body: object
    names: Names


class Names:
    """What the names in a formula stand for.

    Args:
        known: for each name that may be written the name that is meant.
        hidden: for names that are not usable here, why not.
        short: the terms and tables for which abbreviations stand.
        vectors: the texts of vectors, and none for those whose products are known.
        gram: these inner products.
        functions: those that the page defines, by their names.
        spent: what the functions and tables of the page have cost so far.
        are_variables: for variables and for numbers with names whether they are variables.
    """

    def __init__(
        self,
        known: Mapping[str, str],
        hidden: Mapping[str, str] = MappingProxyType({}),
        short: Mapping[str, Value] = MappingProxyType({}),
        vectors: Mapping[str, str | None] = MappingProxyType({}),
        gram: Gram = MappingProxyType({}),
        functions: Mapping[str, PageFunction] = MappingProxyType({}),
        spent: Spent | None = None,
        are_variables: Mapping[str, bool] = MappingProxyType({}),
    ) -> None:
        self.known, self.hidden, self.short = known, hidden, short
        self.vectors, self.gram, self.functions = vectors, gram, functions
        self.spent, self.are_variables = spent or Spent(), are_variables

    def of_vectors(self) -> Names:
        """The same, and the names of vectors."""
        known = {name: name for name in self.vectors} | dict(self.known)
        return self._with(known, self.short)

    def of(self, values: Mapping[str, Value]) -> Names:
        """The same, and the values of the parameters of a function."""
        return self._with(self.known, {**self.short, **values})

    def _with(self, known: Mapping[str, str], short: Mapping[str, Value]) -> Names:
        others = (self.vectors, self.gram, self.functions, self.spent, self.are_variables)
        return Names(known, self.hidden, short, *others)

    def term(self, where: object, name: str) -> Value:
        """What a name stands for: a symbol, or what it abbreviates.

        Raises:
            InputError: for a name that stands for nothing, with a name that is like it.
        """
        if name in self.short:
            return self.short[name]
        if name in self.known:
            return symbol(self.known[name])
        if name in self.hidden:
            raise InputError(f"{where}: {shown(name)} {self.hidden[name]}")
        raise InputError(f"{where}: {shown(name)} is not defined here; {self._instead(name)}")

    def _instead(self, name: str) -> str:
        from verify.wire.text import instead  # loaded only where it is used

        if name in self.functions or name in CALLED:
            return f"it is a function; write {name}(...)"
        if name in instead.FUNCTIONS:
            return instead.FUNCTIONS[name]
        if name in instead.WORDS:
            return instead.WORDS[name]
        short = ", ".join(list(self.known)[:8])
        what = f"what is defined is {short}" if short else "nothing is defined here"
        otherwise = f"define it before, under constants, or as a variable; {what}"
        known = [*self.known, *self.short, *self.functions, *NUMBERS, *CALLED]
        return nearest(name, known, otherwise)


def read_term(where: object, text: str, names: Names) -> Term:
    """The term that a text stands for.

    Raises:
        InputError: naming the place, and what to write instead.
    """
    found = read_value(where, text, names)
    if isinstance(found, Table):
        raise InputError(f"{where}: {shown(text)} is {found.shape}; write a number, such as {_AS}")
    return found


def read_value(where: object, text: str, names: Names) -> Value:
    """The term, the vector or the matrix that a text stands for.

    Raises:
        InputError: naming the place, and what to write instead.
    """
    found = _read(where, text, names)
    if isinstance(found, Joined) or found.relations:
        raise InputError(f"{where}: {shown(text)} is a claim; write a term, such as (1 + x)/2")
    return found.terms[0]


def read_entries(where: object, body: object, names: Names) -> Value:
    """The same of a text, or of a list of texts or of lists of them, which is a table.

    Raises:
        InputError: as above, and if an entry is no text, or a row has another length.
    """
    if not isinstance(body, list):
        return read_value(where, _entry_text(where, body), names)
    is_matrix = any(isinstance(row, list) for row in body)
    rows = body if is_matrix else [body]
    if not all(isinstance(row, list) for row in rows):
        raise InputError(f"{where}: a row is no list; write [[a, b], [c, d]]")
    read = [[read_term(where, _entry_text(where, text), names) for text in row] for row in rows]
    try:
        return table_of(read, is_matrix)
    except ValueError as error:
        raise InputError(f"{where}: {error}; write [a, b] or [[a, b], [c, d]]") from error


def _entry_text(where: object, entry: object) -> str:
    if type(entry) is int:
        return str(entry)
    if not isinstance(entry, str):
        raise InputError(f'{where}: {shown(repr(entry))} is no text; write a formula in "quotes"')
    return entry


def read_claims(where: object, text: str, names: Names) -> tuple[Claim, ...]:
    """The claims in a text, of which a chain ``0 <= x <= b`` has several, and ``a and b`` too.

    The claims in ``a or b`` are one, which `any_of` makes of them; ``a or (b and c)`` is read as
    ``a or b`` and ``a or c``.

    Raises:
        InputError: as above, or where the text has no relation.
    """
    return _joined(where, text, names, Formula.claims)


def read_givens(where: object, text: str, names: Names) -> tuple[Claim, ...]:
    """The same of what is given, where ``|t| <= b`` is the two bounds of t.

    Raises:
        InputError: as above.
    """
    return _joined(where, text, names, Formula.bounds)


def _read(where: object, text: str, names: Names) -> Formula | Joined:
    """What a whole text says."""
    if _DECIMAL_COMMA.search(text):
        _test_commas(where, text)
    try:
        return _Reader(where, text, names).whole()
    except RecursionError as error:
        raise InputError(f"{where}: {shown(text)} nests too deeply; name its parts") from error
    except InputError as error:
        from verify.wire.text import instead  # loaded only where it is used

        meant = instead.of_whole(text) if len(text) <= MAX_MENDED else ""
        if not meant:
            raise
        raise InputError(f"{where}: {shown(text, 80)}: {meant}") from error


def _test_commas(where: object, text: str) -> None:
    """Afterwards no comma between arguments may be that of a decimal, as in ``min(1/2, 0,1)``."""
    from verify.wire.text import instead  # loaded only where it is used

    meant = instead.with_points(text, ()) if len(text) <= MAX_MENDED else text
    if meant != text and any(f"{name}(" in text for name in MANY):
        raise InputError(
            f"{where}: {shown(text, 80)}: a comma may be that of a decimal; write {meant}, or a "
            "space behind each comma between numbers"
        )


def _joined(
    where: object, text: str, names: Names, claims: Callable[[Formula], tuple[Claim, ...]]
) -> tuple[Claim, ...]:
    found = _read(where, text, names)
    if any(not formula.relations for formula in _formulas(found)):
        word = found.word if isinstance(found, Joined) else ""
        instead = (
            f"; write a claim on each side of {word}" if word else f"; write for example {text} > 0"
        )
        raise InputError(f"{where}: {shown(text)} claims nothing{instead}")
    try:
        return tuple(any_of(*clause) for clause in _clauses(found, claims))
    except ValueError as error:
        raise InputError(f"{where}: {shown(text)}: {error}") from error


def _formulas(found: Formula | Joined) -> list[Formula]:
    if isinstance(found, Formula):
        return [found]
    return [formula for part in found.parts for formula in _formulas(part)]


def _clauses(
    found: Formula | Joined, claims: Callable[[Formula], tuple[Claim, ...]]
) -> list[tuple[Claim, ...]]:
    """Claims of which at least one holds, and of others, and so on."""
    if isinstance(found, Formula):
        return [(claim,) for claim in claims(found)]
    if found.word == "and":
        return [clause for part in found.parts for clause in _clauses(part, claims)]
    from verify.wire.text.alternatives import one_of_each  # loaded only where it is used

    chains = any(isinstance(part, Formula) and len(part.relations) > 1 for part in found.parts)
    return one_of_each([_clauses(part, Formula.claims) for part in found.parts], chains=chains)


_JOINING = (("name", "and"), ("name", "or"))
#: How a number is had from a table.
_AS = "u*v, A[1, 2] or det(A)"

#: So many parentheses are inside of one another at most.
MAX_DEPTH = 100


class _Reader:
    """Reads one text from left to right; each method reads what its name says and goes on."""

    def __init__(self, where: object, text: str, names: Names) -> None:
        self.where, self.text, self.names = where, text, names
        self.tokens = self._tokens()
        signs = [word for kind, word in self.tokens if kind == "sign"]
        if (
            max(accumulate((word in "([") - (word in ")]") for word in signs), default=0)
            > MAX_DEPTH
        ):
            raise RecursionError
        self.at = 0
        self.moduli: dict[tuple[int, int], Term] = {}  # by where their texts begin and end
        self.indices: dict[str, Term] = {}  # the numbers for which the letters of sums stand
        self.terms_left = MAX_TERMS

    def _tokens(self) -> list[tuple[str, str]]:
        found: list[tuple[str, str]] = []
        at, end = 0, len(self.text.rstrip())
        while at < end:
            match = _TOKEN.match(self.text, at)
            if match is None:
                unread = self.text[at:].strip()
                from verify.wire.text import instead  # loaded only where it is used

                raise self.error(instead.of_unread(self.text, unread))
            kind = match.lastgroup or ""
            word = match[kind]
            found.append((kind, _SAME.get(word, word) if kind == "sign" else word))
            at = match.end()
        return [*found, ("end", "")]

    def error(self, what: str) -> InputError:
        """The error that something is wrong with this text."""
        return InputError(f"{self.where}: {shown(self.text, 80)}: {what}")

    @property
    def sign(self) -> str:
        """The sign that comes next, if it is one."""
        kind, word = self.tokens[self.at]
        return word if kind == "sign" else ""

    def take(self, *signs: str) -> str:
        """Go on if one of these signs comes next; the sign, or nothing."""
        found = self.sign
        if found in signs:
            self.at += 1
            return found
        return ""

    def expect(self, sign: str) -> None:
        """Go on after a sign that has to come next."""
        if not self.take(sign):
            what = ""
            if self.tokens[self.at][0] == "end" and len(self.text) <= MAX_MENDED // 4:
                lacking = self.text.count("(") - self.text.count(")") if sign == ")" else 1
                what = f"; write {self.text.strip()}{sign * lacking}"
            raise self.error(f"{self.next_word()}, where {sign} is missing{what}")

    def next_word(self) -> str:
        """What comes next, in words."""
        kind, word = self.tokens[self.at]
        return "it ends" if kind == "end" else f"{shown(word)} follows"

    def whole(self) -> Formula | Joined:
        """The whole text."""
        found = self.joined()
        if self.tokens[self.at][0] != "end":
            raise self.error(self._too_much())
        return found

    def joined(self) -> Formula | Joined:
        """Formulas with the word and, or the word or, between them."""
        found, words = [self._part()], []
        while self.tokens[self.at] in _JOINING:
            words.append(self.tokens[self.at][1])
            self.at += 1
            found.append(self._part())
        if len({*words}) > 1:
            raise self.error(
                "has both and and or in it; write two claims, or parentheses: a or (b and c)"
            )
        return Joined(words[0], tuple(found)) if words else found[0]

    def _part(self) -> Formula | Joined:
        """A formula, or what is joined in parentheses; there a chain is joined, too."""
        if not self._is_claim_in_parentheses():
            return self.formula()
        self.at += 1
        found = self.joined()
        self.expect(")")
        return Joined("and", (found,)) if isinstance(found, Formula) else found

    def _is_claim_in_parentheses(self) -> bool:
        """Whether a parenthesis opens here, with a relation before it closes."""
        depth = 0
        for kind, word in self.tokens[self.at :]:
            if kind == "sign":
                depth += (word == "(") - (word == ")")
            if depth < 1:
                return False
            if kind == "sign" and word in RELATIONS:
                return True
        return False

    def formula(self) -> Formula:
        """What stands up to the end, or to the next and or or."""
        start = self.at
        terms: list[Any] = [self.sum()]
        relations, begin, moduli = [], start, []
        moduli.append(self.moduli.get((begin, self.at)))
        while relation := self.take(*RELATIONS):
            relations.append(relation)
            begin = self.at
            terms.append(self.sum())
            moduli.append(self.moduli.get((begin, self.at)))
        upwards = {relation[0] for relation in relations} & {"<", ">"}
        if len(upwards) > 1:
            raise self.error("a chain has < and > in it; write two claims")
        if relations:
            terms = [self.number(term) for term in terms]
        return Formula(tuple(terms), tuple(relations), tuple(moduli))

    def _too_much(self) -> str:
        from verify.wire.text import instead  # loaded only where it is used

        kind, word = self.tokens[self.at]
        before = self.tokens[self.at - 1]
        if word in instead.WORDS:
            return f"{word} cannot be used; {instead.WORDS[word]}"
        if before[0] == "number" and (kind == "number" or word[0] in "xboeE"):
            return instead.of_two(before[1], word)
        if kind in ("name", "number", "quoted") or word == "(":
            inside = "(...)" if word == "(" else word
            return f"no sign stands between {before[1]} and {word}; write {before[1]}*{inside}"
        return f"{self.next_word()}, and does not belong there{self._after(before, word)}"

    def _after(self, before: tuple[str, str], word: str) -> str:
        """What to write for a sign that does not belong where it stands."""
        sides = self.tokens[: self.at], self.tokens[self.at :]
        following = self.tokens[min(self.at + 1, len(self.tokens) - 1)]
        if word == "|" == following[1]:
            return "; write or"
        if word != ",":
            return ""
        if all(any(w in RELATIONS for _, w in side) for side in sides):
            return "; write each claim as a text of its own, in a list"
        if before[0] == "number" == following[0]:
            number = f"{before[1]},{following[1]}"
            from verify.wire.meant import ungrouped  # loaded only where it is used

            return f"; write {ungrouped(number) or number.replace(',', '.')}"
        return ""

    def number(self, value: Value) -> Term:
        """The value, which is no table."""
        if isinstance(value, Table):
            raise self.error(f"{value.shape} stands where a number is needed; write {_AS}")
        return value

    def with_tables(self, joined: Callable[..., Value], *values: Any) -> Value:
        """What is made of terms and tables that fit together."""
        try:
            if any(isinstance(value, Table) for value in values):
                self.names.spent.spend(size_of(*values))
            return joined(*values)
        except ValueError as error:
            raise self.error(str(error)) from error

    def _spend(self, work: int) -> None:
        """Count what is read anew."""
        try:
            self.names.spent.spend(work)
        except ValueError as error:
            raise self.error(str(error)) from error

    def sum(self) -> Value:
        """Products with signs between them; see `joined`."""
        found = [("+", self.product())]
        while sign := self.take("+", "-"):
            found.append((sign, self.product()))
        return joined(found, self._signed)[1]

    def _signed(self, one: tuple[str, Value], other: tuple[str, Value]) -> tuple[str, Value]:
        """Two neighbours of a sum with their signs, as one: - b + c is -(b - c)."""
        sign = "+" if one[0] == other[0] else "-"
        return one[0], self.with_tables(added, one[1], other[1], sign)

    def product(self) -> Value:
        """Factors with signs between them; very many numbers are a tree, as in a sum."""
        first, is_number = self.factor()
        factors = [first]
        while sign := self.take("*", "/"):
            other, too = self.factor()
            if sign == "*" and isinstance(first, Term) and isinstance(other, Term):
                factors.append(other)
            elif sign == "*":
                first = self.with_tables(times, self._product(factors), other)
                factors = [first]
            elif is_number and too:
                factors = [self._quotient(self.number(first).value, self.number(other).value)]
            elif self.indices and other is as_term(0):
                raise self.error("divides by zero")
            else:
                factors = [self.with_tables(over, self._product(factors), other)]
            is_number = False
        return self._product(factors)

    def _product(self, factors: Sequence[Value]) -> Value:
        return joined(factors, partial(self.with_tables, times))

    def _quotient(self, above: Fraction, below: Fraction) -> Term:
        if below == 0:
            raise self.error("divides by zero")
        return as_term(above / below)

    def factor(self) -> tuple[Value, bool]:
        """A power, or minus one; and whether it is a number as such."""
        if not self.take("-"):
            return self.power()
        term, is_number = self.factor()
        return (as_term(-self.number(term).value), True) if is_number else (negative(term), False)

    def power(self) -> tuple[Value, bool]:
        """An atom, perhaps with an exponent; and whether it is a number as such."""
        is_number = self.tokens[self.at][0] == "number"
        found = self.atom()
        while isinstance(found, Table) and self.sign == "[":
            found = self._entry(found)
        kind, word = self.tokens[self.at]
        if kind != "raised" and word != "^":
            return found, is_number
        self.at += 1
        raised = kind == "raised"
        exponent = as_term(int(word.translate(_RAISED))) if raised else self._exponent()
        if self.sign == "^" or self.tokens[self.at][0] == "raised":
            raise self.error("a power of a power needs parentheses: (x^2)^3")
        return self._raised(self.number(found), exponent), False

    def _entry(self, table: Table) -> Value:
        """The rest of ``A[1, 2]``, or of ``A[1]``."""
        self.expect("[")
        at = [self._index()]
        while self.take(","):
            at.append(self._index())
        self.expect("]")
        return self.with_tables(table.entry, at)

    def _index(self) -> int:
        found = self.number(self.sum())
        if found.op != "rational" or found.value.denominator > 1:
            raise self.error("the place of an entry is no whole number; write A[1, 2]")
        return int(found.value)

    def _listed(self) -> Value:
        """The rest of ``[a, b]``, a vector, or of ``[[a, b], [c, d]]``, a matrix."""
        entries = [self.sum()]
        while self.take(","):
            entries.append(self.sum())
        self.expect("]")
        rows = [entry for entry in entries if isinstance(entry, Table)]
        if any(row.is_matrix for row in rows) or len(rows) not in (0, len(entries)):
            raise self.error("an entry of a table is a table; write [a, b] or [[a, b], [c, d]]")
        listed: list[Sequence[Term]] = [row.rows[0] for row in rows] or [
            [self.number(entry) for entry in entries]
        ]
        return self.with_tables(table_of, listed, bool(rows))

    def _exponent(self) -> Term:
        minus = bool(self.take("-"))
        found = self.number(self.atom())
        if not minus:
            return found
        return as_term(-found.value) if found.op == "rational" else -found

    def _raised(self, base: Term, exponent: Term) -> Term:
        """A power by products, roots, or the exponential, whichever is simplest."""
        if base is NUMBERS["e"]:
            return exp(exponent)
        if exponent.op != "rational":
            return exp(exponent * log(base))
        if exponent.value == 0 and self.indices:
            return as_term(1) if has_value(base) else 1 + times_zero(base)
        above, below = abs(exponent.value.numerator), exponent.value.denominator
        if below > MAX_INDEX or not 0 < above <= MAX_POWER:
            raise self.error(
                f"the exponent {exponent.value} is not usable; write m or m/n, m from 1 to "
                f"{MAX_POWER} and n to {MAX_INDEX}, or exp({exponent.value}*log(x))"
            )
        root = base if below == 1 else sqrt(base) if below == 2 else nth_root(base, below)
        is_power = above > 1 or (exponent.value == 1 and not self.indices)
        found = root**above if is_power else root
        return found if exponent.value > 0 else 1 / found

    def atom(self) -> Value:
        """A number, a name, a function, a root, a modulus, a table, or what is in parentheses."""
        kind, word = self.tokens[self.at]
        start = self.at
        self.at += 1
        if kind == "number":
            return as_term(rational(self.where, word))
        if kind == "quoted":
            return self.indices[word] if word in self.indices else self.names.term(self.where, word)
        if kind == "name":
            return self._named(word)
        if word == "(":
            found = self.sum()
            self.expect(")")
            return found
        if word == "[":
            return self._listed()
        if word == "√":
            return sqrt(self.number(self.atom()))
        if word == "|":
            found = self.number(self.sum())
            self.expect("|")
            self.moduli[start, self.at] = found
            return absolute(found)
        self.at -= 1
        from verify.wire.text import instead  # loaded only where it is used

        what = instead.of_missing(word, self.tokens[self.at - 1])
        raise self.error(f"{self.next_word()}, where a number or a name is missing{what}")

    def _named(self, word: str) -> Value:
        named = word in self.names.known or word in self.names.short
        if self.sign == "(" and word in self.names.functions:
            return self._defined(word)
        if self.sign == "(" and (word in CALLED or not named):
            return self._function(word)
        if name_of(word) in self.indices:
            return self.indices[name_of(word)]
        if word in CALLED and not named:
            from verify.wire.text import instead  # loaded only where it is used

            raise self.error(instead.of_function(word, self.tokens[self.at :]))
        name = word if named else name_of(word)
        if name not in self.names.known and name not in self.names.short and name in NUMBERS:
            return NUMBERS[name]
        return self.names.term(self.where, name)

    def _arguments(self) -> list[Value]:
        """What stands between parentheses, with commas between."""
        self.expect("(")
        found = [self.sum()]
        while self.take(","):
            found.append(self.sum())
        self.expect(")")
        return found

    def _defined(self, word: str) -> Value:
        """The value of a function of the page."""
        function, values = self.names.functions[word], self._arguments()
        if len(values) != len(function.parameters):
            wanted = f"{word}({', '.join(function.parameters)})"
            raise self.error(f"{word} is of {len(function.parameters)} values; write {wanted}")
        self.names.spent.used.add(word)
        self._spend(A_CALL + len(str(function.body)))
        names = function.names.of(dict(zip(function.parameters, values, strict=True)))
        found = read_entries(function.place, function.body, names)
        return self._with_values(found, values)

    def _with_values(self, found: Value, values: Sequence[Value]) -> Value:
        """What a function gives, if the values that it is of have one: also those not used."""
        entries = [entry for value in values for entry in entries_of(value)]
        doubtful = [entry for entry in entries if not has_value(entry)]
        if doubtful:
            parts = {*parts_of(*entries_of(found))}
            self._spend(len(parts))
            for entry in doubtful:
                if entry not in parts:
                    more = partial(add, times_zero(entry))
                    found = more(found) if isinstance(found, Term) else found.each(more)
        return found

    def _function(self, word: str) -> Term:
        if word in OF_TABLES:
            from verify.wire.text import linear_algebra  # loaded only where it is used

            count, values = OF_TABLES[word], self._arguments()
            if len(values) != count:
                raise self.error(f"{word} is of {count}, and {len(values)} stand there")
            made = linear_algebra.determinant if word == "det" else linear_algebra.form
            return self.number(self.with_tables(made, *values))
        self.expect("(")
        if word not in CALLED:
            raise self.error(f"{shown(word)} is no function; {self._instead_of(word)}")
        if word in SUMS:
            return self._summed(word)
        if word == DOT:
            return self._dot()
        self.at -= 1
        values = self._arguments()
        if word == DIFF:
            return self._derived([self.number(value) for value in values])
        if word in MANY and len(values) == 1 and isinstance(values[0], Table):
            values = [entry for row in values[0].rows for entry in row]
        arguments = [self.number(value) for value in values]
        if word == "root":
            return self._root(arguments)
        if (len(arguments) > 1) != (word in MANY):
            wanted = "at least two terms" if word in MANY else "one term"
            raise self.error(f"{word} is of {wanted}, and {len(arguments)} stand there")
        return SUGAR[word](*arguments) if word in SUGAR else Term(word, *arguments)

    def _derived(self, arguments: Sequence[Term]) -> Term:
        """The derivative of a term by a variable, where both have a value."""
        from verify.wire.text.slopes import slope  # loaded only where it is used

        try:
            found = slope(arguments, self.names.are_variables)
        except ValueError as error:
            raise self.error(f"{error}; write diff(x^2, x)") from error
        self._spend(operations_in(found))
        return found

    def _dot(self) -> Term:
        """The rest of ``dot(x, z)``."""
        from verify.wire.text.vectors import dot  # loaded only where it is used

        if not self.names.gram:
            raise self.error(
                "no inner products are known here; say by in = which context has them, or write "
                "gram or products in its own"
            )
        x = self._vector()
        if not self.take(","):
            raise self.error("an inner product is of two vectors; write dot(x, z)")
        z = self._vector()
        self.expect(")")
        self._spend(len(x) * len(z))
        try:
            return dot(self.names.gram, x, z)
        except ValueError as error:
            raise self.error(str(error)) from error

    def _vector(self) -> Combination:
        """A combination of vectors, up to the comma or the parenthesis after it."""
        inside = _Reader(self.where, "", self.names.of_vectors())
        inside.text, inside.indices = self.text, self.indices
        inside.tokens, inside.at = self.tokens, self.at
        term = inside.number(inside.sum())
        self.at = inside.at
        return self._combined(term)

    def _combined(self, term: Term) -> Combination:
        from verify.wire.text.vectors import basis, combination  # loaded only where they are used

        known = {}
        for name in self.names.vectors:
            text = self.names.vectors[name]
            if name in set(names_of(term)):
                self._spend(A_CALL + len(text or ""))
                known[name] = (
                    basis(name)
                    if text is None
                    else self._combined(read_term(self.where, text, self.names.of_vectors()))
                )
        try:
            return combination(term, known)
        except ValueError as error:
            raise self.error(str(error)) from error

    def _instead_of(self, word: str) -> str:
        """What to write for a name before a parenthesis that is no function's."""
        from verify.wire.text import instead  # loaded only where it is used

        is_name = word in self.names.known or word in self.names.hidden
        if word in instead.FUNCTIONS and not (is_name and word in GREEK):
            return instead.FUNCTIONS[word]
        if word in NUMBERS or word == "π":
            return f"it is a number; write {word}"
        return f"write {word}*(...)" if is_name or word in GREEK else nearest(word, CALLED)

    def _summed(self, word: str) -> Term:
        """The rest of ``sum(1/k^2, k, 1, 10)``: its term for each number, joined."""
        start, comma = self.at, self._next_comma()
        self.at = comma
        example = f"write {word}(1/k^2, k, 1, 10)"
        if not self.take(","):
            raise self.error(f"a {word} has a term, a letter and two whole numbers; {example}")
        kind, written = self.tokens[self.at]
        letter = name_of(written)
        if kind != "name" or letter in self.indices or letter in self.names.known:
            raise self.error(f"{shown(written)} is no new letter to number terms by; {example}")
        self.at += 1
        first, last = (self._whole(example) for _ in range(2))
        self.expect(")")
        end = self.at
        if last < first:
            raise self.error(f"there is no number from {first} to {last}; {example}")
        terms: list[Term] = []
        for number in range(first, last + 1):
            self.terms_left -= 1
            if self.terms_left < 0:
                raise self.error(f"it has more than {MAX_TERMS} terms; split it, or name its parts")
            self._spend(3 * (comma - start))
            self.at, self.indices[letter] = start, as_term(number)
            terms.append(self.number(self.sum()))
            if self.at != comma:
                raise self.error(f"{self.next_word()}, and does not belong there")
        del self.indices[letter]
        self.at = end
        return in_tree(terms, SUMS[word])

    def _next_comma(self) -> int:
        """Where the argument ends that begins here."""
        depth = 0
        for at in range(self.at, len(self.tokens)):
            kind, word = self.tokens[at]
            depth += (word in {"(", "["}) - (word in {")", "]"}) if kind == "sign" else 0
            if kind == "end" or depth < 0 or (depth == 0 and (kind, word) == ("sign", ",")):
                return at
        return self.at

    def _whole(self, example: str) -> int:
        self.expect(",")
        found = self.number(self.sum())
        if found.op != "rational" or found.value.denominator > 1:
            raise self.error(f"a bound is no whole number; {example}")
        return int(found.value)

    def _root(self, arguments: list[Term]) -> Term:
        index = arguments[-1].value if arguments[-1].op == "rational" else Fraction(0)
        if len(arguments) != 2 or index.denominator > 1 or not 2 <= index <= MAX_INDEX:
            raise self.error("a root has a term and an index, such as root(x, 3)")
        return nth_root(arguments[0], int(index))
