"""Short decimals on the safe side of bounds."""

from __future__ import annotations

from fractions import Fraction

from verify.language.statement import Choice, Constant
from verify.language.terms import Term, as_term
from verify.prover import balls
from verify.prover.decimals import round_decimal
from verify.prover.ground import Ground

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
    up = choice.direction == "up"
    candidates = [round_to_digits(end, up) for end in ((low, high) if up else (high, low))]
    value = base + candidates[0]
    if candidates[0] != candidates[1] and not _is_safe(ground, value, choice, bits):
        value = base + candidates[1]
    return choice.constant._replace(term=as_term(value))


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
