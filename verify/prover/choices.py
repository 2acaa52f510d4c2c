"""Short decimals on the safe side of bounds: at one point, and at many."""

from __future__ import annotations

from collections.abc import Callable, Mapping
from fractions import Fraction

from verify.language.fold import FAILS, HOLDS, OPEN, RATIONAL, fold, holds
from verify.language.record import Any
from verify.language.statement import Choice, Constant, Statement
from verify.language.terms import FUNCTIONS, Claim, Term, as_term
from verify.prover import balls
from verify.prover.constants import DEFAULT_MAX_PRECISION, DEFAULT_PRECISION
from verify.prover.decimals import round_decimal
from verify.prover.ground import Ground
from verify.prover.session import Session

#: Chosen constants are rounded to this many significant decimal digits.
CHOSEN_DIGITS = 3

#: Bits at which choices are rounded, whatever the precision asked for, so that they depend on the
#: parameters alone.
CHOICE_BITS = 256


class BudgetError(ArithmeticError):
    """The last precision was spent without a result."""


def choose(ground: Ground, choice: Choice) -> Constant:
    """The constant with a short decimal on the safe side of its positive bound.

    The number has `CHOSEN_DIGITS` significant digits (above ``base``, where that is given) and
    depends on the parameters alone, not on the precision asked for.

    Raises:
        BudgetError: if the bound is not known to 64 relative bits at the last precision.
    """
    base = Fraction(0)
    if choice.base is not None:
        exact = ground.exact(choice.base)
        if exact is None:
            raise ValueError(f"the base of {choice.constant.name} is not rational")
        base = exact
    (low, high), bits = _bound(ground, choice)
    if low <= 0:
        what = "positive" if choice.base is None else f"above {base}"
        raise ValueError(f"the bound of {choice.constant.name} is not {what}")
    up = choice.direction == "up"
    candidates = [round_to_digits(end, up) for end in ((low, high) if up else (high, low))]
    value = base + candidates[0]
    if candidates[0] != candidates[1] and not _is_safe(ground, value, choice, bits):
        value = base + candidates[1]
    return choice.constant._replace(term=as_term(value))


def chosen(statement: Statement, choices: Mapping[str, Choice]) -> Statement:
    """The statement of a page, with short decimals for the constants that may be chosen.

    ``choices`` has these by their names; in the statement their terms are the bounds.

    Raises:
        BudgetError: if a constant has no value, or a bound is not known, at the last precision.
        ValueError: if a bound is not positive, or what it shall be above is not rational.
    """
    if not choices:
        return statement
    ground = Ground(Session(), DEFAULT_PRECISION, DEFAULT_MAX_PRECISION)
    given = (Constant(name, name, name, "", term) for name, term in statement.parameters.items())
    found: list[Constant] = []
    for constant in (*given, *statement.constants):
        choice = choices.get(constant.name)
        found.append(constant if choice is None else choose(ground, choice))
        if not ground.define(found[-1]):
            raise BudgetError(f"{constant.name} {ground.why_no_value(constant.term)}")
    return statement._replace(constants=tuple(found[len(statement.parameters) :]))


def _bound(ground: Ground, choice: Choice) -> tuple[tuple[Fraction, Fraction], int]:
    """The ends of an enclosure of the bound, above the base, and its precision."""
    constant = choice.constant
    bound = constant.term if choice.base is None else constant.term - choice.base
    exact, bits = ground.exact(bound), CHOICE_BITS
    if exact is not None:
        return (exact, exact), bits
    while (ball := ground.ball(bound, bits)) is None or balls.accuracy_bits(ball) < 64:
        bits *= 2
        if bits > ground.max_bits:
            raise BudgetError(f"{constant.name} cannot be chosen with {ground.max_bits} bits")
    return balls.ends(ball), bits


def _is_safe(ground: Ground, value: Fraction, choice: Choice, bits: int) -> bool:
    """Whether a candidate that the bound's ball straddles is proved to be allowed."""
    term = choice.constant.term
    if choice.direction == "up":
        claims = [term <= as_term(value)]
    else:
        claims = [as_term(value) <= entry for entry in entries_of(term)]
    return all(ground.holds_at(claim, bits) for claim in claims)


def round_to_digits(value: Fraction, up: bool, digits: int = CHOSEN_DIGITS) -> Fraction:
    """A positive rational rounded up or down to a number of significant decimal digits."""
    if value <= 0:
        raise ValueError("only a positive bound can be rounded to significant digits")
    mantissa, exponent = round_decimal(value, digits, up)
    return mantissa * Fraction(10) ** exponent


def entries_of(term: Term) -> tuple[Term, ...]:
    """The entries of a minimum, or the one bound itself."""
    return term.children if term.op == "min" else (term,)


class OpenChoiceError(ArithmeticError):
    """Balls do not tell how a bound is rounded."""


class Chooser:
    """Rounds the bounds of choices at many points, like `choose`, from balls.

    ``values`` has the exact value of each parameter, set for a point, and of each chosen constant
    so far; ``definitions`` the term of each other constant.
    """

    def __init__(self) -> None:
        self.values: dict[str, Fraction] = {}
        self.definitions: dict[str, Term] = {}
        self._known: dict[Term, Fraction | None] = {}
        self._algebra = {**_EXACT, "symbol": self._named}

    def rounding(self, choice: Choice) -> Callable[..., Any]:
        """A function from the ball of the bound above the base, and of its entries, to a ball.

        It raises `OpenChoiceError` where the balls leave open what is chosen.
        """
        constant, up = choice.constant, choice.direction == "up"
        entries = entries_of(constant.term)

        def rounded(ball: Any, *parts: Any) -> Any:
            if balls.strict_sign(ball) != 1 or balls.accuracy_bits(ball) < 64:
                raise OpenChoiceError
            low, high = balls.ends(ball)
            far, near = (round_to_digits(end, up) for end in ((high, low) if up else (low, high)))
            value = far
            if far != near and self._is_safe(near, entries, parts, up):
                value = near
            base = Fraction(0) if choice.base is None else self._exact(choice.base)
            if base is None:
                raise OpenChoiceError
            self.values[constant.name] = base + value
            return balls.from_fraction(base + value)

        return rounded

    def _is_safe(self, value: Fraction, entries: Any, parts: Any, up: bool) -> bool:
        """Whether the bolder candidate is allowed."""
        number = balls.from_fraction(value)
        for entry, part in zip(entries, parts, strict=True):
            exact = self._exact(entry)
            pair: tuple[Any, Any] = (part, number) if exact is None else (exact, value)
            a, b = pair if up else reversed(pair)
            if not a <= b:
                if b < a:
                    return False
                raise OpenChoiceError
        return True

    def verdict(self, claim: Claim) -> int:
        """What exact values say of a claim, as `verify.prover.straight` writes it."""
        lhs, rhs = self._exact(claim.lhs), self._exact(claim.rhs)
        if lhs is None or rhs is None:
            return OPEN
        return HOLDS if holds(claim.relation, lhs, rhs) else FAILS

    def start(self, parameters: Mapping[str, Fraction]) -> None:
        """Begin a new point."""
        self.values = dict(parameters)
        self._known = {}

    def _exact(self, term: Term) -> Fraction | None:
        """The value of a term, if it is computed within the rational numbers."""
        return fold(term, self._algebra, self._known)

    def _named(self, name: str) -> Fraction | None:
        return self.values[name] if name in self.values else self._exact(self.definitions[name])


def _known(function: Callable[..., Fraction]) -> Callable[..., Fraction | None]:
    """The function where all operands are known, and nothing elsewhere."""
    return lambda *operands: None if any(o is None for o in operands) else function(*operands)


_EXACT: dict[str, Callable[..., Fraction | None]] = {
    **{op: _known(function) for op, function in RATIONAL.items()},
    "min": _known(min),
    "max": _known(max),
    **dict.fromkeys((*FUNCTIONS, "root", "pi"), lambda *_: None),
}
