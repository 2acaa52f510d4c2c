"""Exact terms and claims: the language in which the paper is transcribed.

A term *builds* an expression and computes nothing; ``a < b`` builds a claim and decides nothing.
Numbers enter as integers or fractions. A float is refused, because it is already rounded.
"""

from __future__ import annotations

from collections.abc import Callable, Iterator, Mapping, Sequence
from fractions import Fraction
from functools import reduce
from math import prod

from verify.language.record import Any, TypeVar

Part = TypeVar("Part")

RELATIONS = ("<", "<=", "=")

#: The largest index of a root.
MAX_INDEX = 99
#: The largest exponent of a power that the wire format has.
MAX_EXPONENT = 999
#: The largest exponent that is read. One that is too large for one power is that of several.
MAX_POWER = 99_999

#: Longer terms are not written out where Python shows them.
MAX_SHOWN = 1000

#: The operations without terms as arguments.
LEAVES = ("rational", "symbol", "pi")
#: The operations with a natural number after the one term: a power, and a root of some index.
INDEXED = ("pow", "root")
#: The functions of one number.
FUNCTIONS = ("sqrt", "cos", "cos_pi", "sin", "exp", "log", "atan")
#: All operations.
OPERATIONS = (*LEAVES, *INDEXED, "add", "sub", "mul", "div", "neg", "min", "max", *FUNCTIONS)


#: Every term that was built, by operation and arguments.
_TERMS: dict[tuple[str, tuple[Any, ...]], Term] = {}


class Term:
    """An immutable expression: an operation and its arguments.

    Leaves are ``rational`` (one Fraction), ``symbol`` (one name) and ``pi``; the other operations
    are those of `OPERATIONS`, where ``pow`` has an integer exponent, ``root`` a natural index, and
    ``cos_pi(x)`` is cos(pi x). Two terms are equal when they are written alike.
    """

    __slots__ = ("args", "children", "op")

    op: str
    args: tuple[Any, ...]
    #: The arguments that are terms themselves.
    children: tuple[Any, ...]

    def __new__(cls, op: str, *args: Term | Fraction | int | str) -> Term:
        """The one term that is written like this: terms that are equal are the same object."""
        key = (op, args)
        term = _TERMS.get(key)
        if term is None:
            term = _TERMS[key] = super().__new__(cls)
            term.op = op
            term.args = args
            term.children = () if op in LEAVES else args[:1] if op in INDEXED else args
        return term

    def __repr__(self) -> str:
        if operations_in(self) > MAX_SHOWN:
            return f"<a term {self.op} of more than {MAX_SHOWN} operations>"
        return f"Term({self.op!r}, {', '.join(map(repr, self.args))})"

    def __add__(self, other: Number) -> Term:
        return Term("add", self, as_term(other))

    def __radd__(self, other: Number) -> Term:
        return Term("add", as_term(other), self)

    def __sub__(self, other: Number) -> Term:
        return Term("sub", self, as_term(other))

    def __rsub__(self, other: Number) -> Term:
        return Term("sub", as_term(other), self)

    def __mul__(self, other: Number) -> Term:
        return Term("mul", self, as_term(other))

    def __rmul__(self, other: Number) -> Term:
        return Term("mul", as_term(other), self)

    def __truediv__(self, other: Number) -> Term:
        return Term("div", self, as_term(other))

    def __rtruediv__(self, other: Number) -> Term:
        return Term("div", as_term(other), self)

    def __pow__(self, exponent: int) -> Term:
        if type(exponent) is not int or exponent < 1:
            raise TypeError(f"a power needs a positive integer exponent, not {exponent!r}")
        if exponent <= MAX_EXPONENT:
            return Term("pow", self, exponent)
        half = self ** (exponent // 2)
        return half**2 * self if exponent % 2 else half**2

    def __neg__(self) -> Term:
        return Term("neg", self)

    def __abs__(self) -> Term:
        return Term("max", self, -self)

    def __lt__(self, other: Number) -> Claim:
        return Claim("<", self, as_term(other))

    def __le__(self, other: Number) -> Claim:
        return Claim("<=", self, as_term(other))

    def __gt__(self, other: Number) -> Claim:
        return Claim("<", as_term(other), self)

    def __ge__(self, other: Number) -> Claim:
        return Claim("<=", as_term(other), self)

    def __bool__(self) -> bool:
        raise TypeError("a term has no truth value; build a claim and let the prover decide it")

    @property
    def name(self) -> str:
        """The name of a symbol."""
        name = self.args[0]
        if self.op != "symbol" or not isinstance(name, str):
            raise TypeError(f"{self!r} is not a symbol")
        return name

    @property
    def value(self) -> Fraction:
        """The value of a rational leaf."""
        value = self.args[0]
        if self.op != "rational" or not isinstance(value, Fraction):
            raise TypeError(f"{self!r} is not a rational leaf")
        return value

    @property
    def exponent(self) -> int:
        """The exponent of a power, or the index of a root."""
        exponent = self.args[-1] if self.args else None
        if self.op not in INDEXED or not isinstance(exponent, int):
            raise TypeError(f"{self!r} is neither a power nor a root of some index")
        return exponent


#: What may be written where a term is meant.
Number = Term | int | Fraction


class Claim:
    """The sentence ``lhs < rhs``, ``lhs <= rhs`` or ``lhs = rhs``; building it decides nothing.

    Two claims are equal when they are written alike.
    """

    __slots__ = ("lhs", "relation", "rhs")

    def __init__(self, relation: str, lhs: Term, rhs: Term) -> None:
        if relation not in RELATIONS:
            raise ValueError(f"{relation!r} is not a relation; write one of {', '.join(RELATIONS)}")
        self.relation = relation
        self.lhs = lhs
        self.rhs = rhs

    def __repr__(self) -> str:
        return f"Claim({self.relation!r}, {self.lhs!r}, {self.rhs!r})"

    def __eq__(self, other: object) -> bool:
        return isinstance(other, Claim) and self.key == other.key

    def __hash__(self) -> int:
        return hash(self.key)

    @property
    def key(self) -> tuple[str, Term, Term]:
        """The relation and the two sides."""
        return self.relation, self.lhs, self.rhs

    def __bool__(self) -> bool:
        raise TypeError("a claim has no truth value; chain two claims as two rows")


_INTEGERS: dict[int, Term] = {}


def as_term(number: Number) -> Term:
    """Return the term for an integer, a fraction or a term.

    Raises:
        TypeError: for a float (and anything else), saying what to write instead.
    """
    if isinstance(number, Term):
        return number
    if type(number) is int:
        term = _INTEGERS.get(number)
        if term is None:
            term = _INTEGERS[number] = Term("rational", Fraction(number))
        return term
    if type(number) is Fraction:
        return Term("rational", number)
    if isinstance(number, float):
        raise TypeError(
            f"the float {number!r} is already rounded: write a fraction such as Fraction('0.03')"
        )
    raise TypeError(f"{number!r} is not an exact number: write an int, a Fraction or a term")


def equal(lhs: Number, rhs: Number) -> Claim:
    """The claim ``lhs = rhs``; ``==`` compares how terms are written."""
    return Claim("=", as_term(lhs), as_term(rhs))


def unequal(lhs: Number, rhs: Number) -> Claim:
    """The claim that two numbers differ: the square of their difference is positive."""
    return Claim("<", as_term(0), _less(as_term(lhs), as_term(rhs)) ** 2)


def any_of(*claims: Claim) -> Claim:
    """The claim that at least one of some claims is true, all of whose terms have to be defined.

    For inequalities it says that the greatest of the differences of their sides is positive (or at
    least 0); for equations, that the product of the differences is 0.

    Raises:
        TypeError: for what is no claim, such as a list of some.
        ValueError: for claims of more than one relation, for which one claim does not stand.
    """
    for claim in claims:
        if not isinstance(claim, Claim):
            raise TypeError(f"{claim!r:.60} is no claim; write any_of(x <= 1, 2 <= x)")
    if len({claim.relation for claim in claims}) != 1:
        written = " and ".join(dict.fromkeys(claim.relation for claim in claims)) or "no claim"
        raise ValueError(f"alternatives need one relation in all of them, not {written}")
    if len(claims) == 1:
        return claims[0]
    relation = claims[0].relation
    if relation == "=":
        first, *others = (_less(claim.lhs, claim.rhs) for claim in claims)
        return Claim(relation, as_term(0), prod(others, start=first))
    return Claim(relation, as_term(0), maximum(*(_less(c.rhs, c.lhs) for c in claims)))


def _less(term: Term, other: Term) -> Term:
    zero = as_term(0)
    return term if other is zero else -other if term is zero else term - other


def symbol(name: str) -> Term:
    """A named quantity whose definition or value is given elsewhere."""
    return Term("symbol", name)


def sqrt(number: Number) -> Term:
    """The non-negative square root."""
    return Term("sqrt", as_term(number))


def nth_root(number: Number, index: int) -> Term:
    """The root of this index of a number that is not negative; it is not negative either."""
    if type(index) is not int or not 2 <= index <= MAX_INDEX:
        raise TypeError(f"a root needs an index from 2 to {MAX_INDEX}, not {index!r}")
    return Term("root", as_term(number), index)


def minimum(*numbers: Number) -> Term:
    """The least of at least two numbers, each entry kept visible."""
    return Term("min", *map(as_term, numbers))


def maximum(*numbers: Number) -> Term:
    """The greatest of at least two numbers."""
    return Term("max", *map(as_term, numbers))


#: More parts than this are joined to a tree.
LONG = 150


def in_tree(parts: Sequence[Part], join: Callable[[Part, Part], Part]) -> Part:
    """Parts joined, each with its neighbour, to a tree of small height; there is at least one."""
    while len(parts) > 1:
        pairs = [join(*pair) for pair in zip(parts[::2], parts[1::2], strict=False)]
        parts = [*pairs, *parts[len(pairs) * 2 :]]
    return parts[0]


def joined(parts: Sequence[Part], join: Callable[[Part, Part], Part]) -> Part:
    """Parts joined from the left, as they are written; very many in a tree of small height."""
    return reduce(join, parts) if len(parts) <= LONG else in_tree(parts, join)


def cos(radians: Number) -> Term:
    """The cosine of an angle in radians."""
    return Term("cos", as_term(radians))


def cos_pi(half_turns: Number) -> Term:
    """cos(pi x)."""
    return Term("cos_pi", as_term(half_turns))


def sin(radians: Number) -> Term:
    """The sine of an angle in radians."""
    return Term("sin", as_term(radians))


def tan(radians: Number) -> Term:
    """The tangent of an angle in radians, which is its sine over its cosine."""
    return sin(radians) / cos(radians)


def atan(number: Number) -> Term:
    """The angle between -pi/2 and pi/2 with this tangent."""
    return Term("atan", as_term(number))


def asin(number: Number) -> Term:
    """The angle between -pi/2 and pi/2 with this sine, for a number from -1 to 1.

    Half of it has the tangent x/(1 + sqrt(1 - x^2)).
    """
    x = as_term(number)
    return 2 * atan(x / (1 + sqrt(1 - x**2)))


def acos(number: Number) -> Term:
    """The angle between 0 and pi with this cosine, for a number from -1 to 1."""
    return pi / 2 - asin(number)


def sinh(number: Number) -> Term:
    """The hyperbolic sine, with 1/e^x for e^-x."""
    return (exp(number) - 1 / exp(number)) / 2


def cosh(number: Number) -> Term:
    """The hyperbolic cosine, with 1/e^x for e^-x."""
    return (exp(number) + 1 / exp(number)) / 2


def tanh(number: Number) -> Term:
    """The hyperbolic tangent, which is 1 - 2/(e^2x + 1)."""
    return 1 - 2 / (exp(number) ** 2 + 1)


def exp(number: Number) -> Term:
    """The exponential."""
    return Term("exp", as_term(number))


def log(number: Number) -> Term:
    """The natural logarithm of a positive number."""
    return Term("log", as_term(number))


def absolute(number: Number) -> Term:
    """The absolute value, which is the greater one of the number and its negative."""
    return maximum(number, -as_term(number))


#: Half the circumference of the circle with radius 1.
pi = Term("pi")


def parts_of(*terms: Term) -> Iterator[Term]:
    """Terms and all their parts, each once, in an order that depends on the terms only."""
    seen: set[Term] = set()
    waiting = [*reversed(terms)]
    while waiting:
        term = waiting.pop()
        if term not in seen:
            seen.add(term)
            waiting += reversed(term.children)
            yield term


_OPERATIONS: dict[Term, int] = {}


def operations_in(term: Term) -> int:
    """How many operations a term has if each part is written wherever it stands.

    A part that stands in many places is counted once: the number may be very large.
    """
    found = _OPERATIONS.get(term)
    if found is None:
        count = sum(map(operations_in, term.children), 1) if term.children else 0
        found = _OPERATIONS[term] = count
    return found


_SIGNS: dict[Term, int] = {}


def signs_in(term: Term) -> int:
    """About how many signs a term takes if each part is written wherever it stands."""
    found = _SIGNS.get(term)
    if found is None:
        if term.op == "rational":
            bits = term.value.numerator.bit_length() + term.value.denominator.bit_length()
            found = 1 + bits * 3 // 10
        else:
            found = len(term.name) if term.op == "symbol" else sum(map(signs_in, term.children), 1)
        _SIGNS[term] = found
    return found


def names_of(*terms: Term) -> Iterator[str]:
    """The names in terms, each once, in the order of `parts_of`."""
    return (part.name for part in parts_of(*terms) if part.op == "symbol")


def substitute(term: Term, values: Mapping[str, Term]) -> Term:
    """The term with every occurrence of some names replaced, all at once."""
    done: dict[Term, Term] = {}

    def new(part: Term) -> Term:
        found = done.get(part)
        if found is None:
            if part.op == "symbol":
                found = values.get(part.name, part)
            else:
                children = part.children
                args = [new(child) for child in children]
                found = Term(part.op, *args, *part.args[len(children) :]) if children else part
            done[part] = found
        return found

    return new(term)


def substitute_claim(claim: Claim, values: Mapping[str, Term]) -> Claim:
    """The claim with every occurrence of some names replaced, all at once."""
    return Claim(claim.relation, substitute(claim.lhs, values), substitute(claim.rhs, values))
