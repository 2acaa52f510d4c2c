"""The jobs `separatrix`: the theorem for all parameters, and f at one q as a certificate.

A point's certificate follows two orbits: that of (q, least), rounded up at each step until it
falls in two steps, and that of (q, most), rounded down until it ends or rises in two
steps. Each step is a row, which says that what the theorem knows of such a step applies.
"""

from __future__ import annotations

from collections.abc import Iterator, Mapping
from contextlib import suppress
from fractions import Fraction
from functools import cache
from math import isqrt

from verify.language.errors import OwnError, UnreadError
from verify.language.record import Record
from verify.language.statement import (
    NEEDED,
    PROVED,
    Applies,
    Assumption,
    Constant,
    Context,
    Obligation,
    Statement,
)
from verify.language.terms import Claim, Number, Term, as_term, sqrt, symbol
from verify.paper.commands.pages import cite, statement
from verify.prover.decimals import exact_number, round_decimal
from verify.prover.ground import Ground
from verify.prover.outcome import Decision, Outcome
from verify.prover.rules import Applying, Interval
from verify.prover.session import Session
from verify.spheres.limit_map import (
    CurveAt,
    Parameters,
    beyond,
    direction,
    has_separatrix,
    root_ends,
)
from verify.spheres.separatrix import Separatrix, staircase
from verify.spheres.separatrix import decide_separatrix as enclose
from verify.wire.judge import judged

#: The theorem, and its page.
NAME = "separatrix"
LABEL, THRESHOLD = "SSSCT3.4.2LineaZhou-Kadan", "EQUATSS3.4ZKCl2CondiStabi"
POINT = "separatrix-point"
GLUE = "glue-point"
#: The parameters of a point; the last two bound f(q). Those of balls that differ come after them.
NAMES = ("r", "c", "ratio", "q", "least", "most")
BALLS = ("m_0", "m_1", "m_2", "R_0", "R_1", "R_2")
#: Digits of the numbers along an orbit, beyond those of f, and how often they are doubled.
MORE_DIGITS, DOUBLINGS = 8, 5
#: The numbers in a step are multiplied; so many bits for each of their digits evaluate it without
#: loss. Where a and ρ are roots that cannot be: so many are far beyond what rounding leaves.
FACTORS, FACTORS_OF_ROOTS = 48, 12
#: Roots in the parameters are rounded at so many times the digits of an orbit.
ROOT_BITS = 8
#: The committed point.
STORED = Parameters(Fraction(3, 100), Fraction(1), Fraction(1)), Fraction(1, 10)
STORED_DIGITS, STORED_STEPS = 12, 10**6
#: So many rows, times the digits of the longest number, are not too much for the checker.
SURELY_FEW = 1000
#: An orbit with more rows is too much for the checker.
MAX_ROWS = 1500

State = tuple[Fraction, Fraction]
Step = tuple[Fraction, Fraction, Fraction, Fraction, Fraction]


class PointParameters(Record):
    """f(q) for these r, -cos, ratio and q, all exact, and what is claimed: least ≤ f(q) ≤ most."""

    of: Parameters
    q: Fraction
    least: Fraction
    most: Fraction

    @property
    def values(self) -> dict[str, Fraction]:
        """By their names in the statement."""
        found = dict(zip(NAMES, (*self.of[:3], *self[1:]), strict=True))
        balls = zip(BALLS, (*self.of.masses, *self.of.radii), strict=True)
        return found | dict(balls) if self.of.is_unlike else found


def read_point(parameters: Mapping[str, Term]) -> PointParameters | None:
    """The point whose parameters these are; None if they are those of no point."""
    names = [*NAMES, *BALLS] if "m_0" in parameters else [*NAMES]
    if {*parameters} != {*names} or any(t.op != "rational" for t in parameters.values()):
        return None
    r, c, ratio, q, least, most, *of_balls = (parameters[name].value for name in names)
    if not (0 < r < 1 and 0 < c <= 1 and ratio > 0 and q >= 0 and all(x > 0 for x in of_balls)):
        return None
    balls = (tuple(of_balls[:3]), tuple(of_balls[3:])) if of_balls else ()
    found = PointParameters(Parameters(r, c, ratio, *balls), q, least, most)
    return found if found.of.is_unlike or not of_balls else None


def point_of(found: Separatrix) -> PointParameters | None:
    """What is to be certified of f at the q that was asked for; None if that is not decided."""
    if found.at is None or found.verdict != PROVED:
        return None
    low, high = next(((s.low, s.high) for s in found.strips), (Fraction(0), Fraction(0)))
    down, up = (_short(end, found.digits, upwards) for end, upwards in ((low, False), (high, True)))
    return PointParameters(found.parameters, found.at, down, up)


def _short(value: Fraction, digits: int, up: bool) -> Fraction:
    mantissa, exponent = round_decimal(value, digits + 2, up=up)
    return mantissa * Fraction(10) ** exponent


# --- orbits in rational numbers -------------------------------------------------------------------


class Orbit:
    """An orbit of the map in short rational numbers, each image rounded up, or each down.

    Images fall as a grows, and grow with the ratio: the end of each is taken that makes them so.
    """

    def __init__(self, of: Parameters, digits: int, up: bool) -> None:
        squares = of.square_a, of.square_rho, 1 / of.square_rho
        a, *ratios = (root_ends(square, ROOT_BITS * digits) for square in squares)
        self.r, self.a, self.ratios = of.r, a[not up], tuple(ends[up] for ends in ratios)
        self.digits, self.up = digits, up

    def steps(self, q: Fraction, u: Fraction) -> Iterator[Step]:
        """rho, q, u and the next q and u, as long as there is a next collision."""
        parity = 0
        while (image := self.image(self.ratios[parity], q, u)) is not None:
            yield (self.ratios[parity], q, u, *image)
            (q, u), parity = image, 1 - parity

    def image(self, rho: Fraction, q: Fraction, u: Fraction) -> tuple[Fraction, Fraction] | None:
        """The next state, rounded; None if there is none, or none below u = 1."""
        p = self.a * (1 - u) - q - rho * u
        top = rho * u * (2 * q + rho * u)
        if p <= 0 or top >= p * p:
            return None
        x, v = self.rounded(self.r * (1 - u) / p), self._root(top / (p * p))
        return (x, v) if v < 1 else None

    def _root(self, h: Fraction) -> Fraction:
        """The v with v(2-v) = h, rounded."""
        size = 10 ** (self.digits + 4)
        small = isqrt(int((1 - h) * size * size))
        root = Fraction(small + (not self.up), size)
        return self.rounded(h / (1 + root))

    def rounded(self, value: Fraction) -> Fraction:
        """A decimal with the digits of the orbit."""
        mantissa, exponent = round_decimal(value, self.digits, up=self.up)
        return mantissa * Fraction(10) ** exponent


class TooLongError(ValueError):
    """The orbits have more steps than a certificate holds, or no digits sufficed."""


def _followed(point: PointParameters, digits: int, most: int, *, up: bool) -> list[Step] | None:
    """The steps from (q, least) until two of them fall, or from (q, most), rounded down.

    Those go on until two of them rise, or no collision follows. None if these digits do not
    suffice.
    """
    found: list[Step] = []
    start = point.least if up else point.most
    for step in Orbit(point.of, digits, up).steps(point.q, start):
        found.append(step)
        if way := _direction(found):
            return found if up == (way < 0) else None
        if len(found) > most:
            raise TooLongError
    return None if up else found


def _direction(steps: list[Step]) -> int:
    """-1 if the last two steps fall, 1 if they rise, 0 if neither."""
    return direction(steps[-2][1:3], steps[-1][3:]) if len(steps) > 1 else 0


# --- the statement --------------------------------------------------------------------------------

#: The letters of the map: of equal balls, and of others.
LETTERS = (
    "The limit map is that of the theorem that is cited, with a = (1+r)/2 c and σ = 1/ρ; c is -cos "
    "θ. "
)
LETTERS_OF_BALLS = (
    "The limit map is that of the theorem that is cited, with the a, ρ and σ below; c is -cos θ, "
    "the ratio is |W_1|²/|W_2|², ball 1 has just collided with 0, and 2 is next. Its q is the "
    "normal speed of 0-1 over that of 0-2, times the root in ρ. "
)
POINT_GLUE = (
    "The second state of each row is the first one of the next row. By the rows of its context "
    "below, the orbit of (q, least) lies below the states in "
    "below-1, below-2, …, one after the other. By below-falls the last one is below the one before "
    "the last two collisions: by the same rows, again and again, the orbit stays below "
    "these, its collisions never end, and least ≤ f(q). Let u ≥ most: as long as the "
    "collisions of (q, u) go on, its orbit lies above the states in above-1, above-2, …, by the "
    "rows of above, and after the last one there is no collision, by above-end. With above-rises "
    "in its place the last state is above the one before the last two collisions, z, and is not "
    "z. If the collisions of (q, u) never ended, z and its image after two collisions would be in "
    "K, and z in the regime, by glue-regime; but by above-x-above and above-v-above u would be at "
    "least that of z after every two collisions. So f(q) ≤ most. "
    "With beyond or flat in their place, f(q) = 0 by glue-none."
)


def glue(point: PointParameters) -> Assumption:
    """What is believed of a point beside its rows."""
    letters = LETTERS_OF_BALLS if point.of.is_unlike else LETTERS
    return Assumption(GLUE, LABEL, letters + POINT_GLUE, "numbered glue")


def decide_value(point: PointParameters) -> Outcome:
    """The claim about f(q) as a statement with its certificate; the checker has judged it.

    Raises:
        TooLongError: if its orbits are too long for the checker.
        UnreadError: if the checker does not get to the end of short ones.
    """
    outcome = point_outcome(point)
    try:
        return judged(outcome)
    except UnreadError as error:
        digits = max(len(str(value)) for value in point.values.values())
        if len(outcome.statement.obligations) * digits <= SURELY_FEW:
            raise
        raise TooLongError from error


def stored_curve() -> tuple[Separatrix, tuple[CurveAt, ...]]:
    """What is enclosed of the curve of the committed point, and the places for its picture."""
    found = enclose(STORED[0], None, STORED_DIGITS, STORED_STEPS)
    return found, staircase(found, STORED_STEPS)


@cache
def decide_stored() -> Outcome:
    """The committed point, to twelve digits."""
    found = point_of(enclose(*STORED, STORED_DIGITS, STORED_STEPS))
    if found is None:
        raise OwnError("the committed point of the separatrix is not decided")
    return decide_value(found)


def outcomes_at(point: PointParameters, most: int) -> Iterator[Outcome]:
    """Yield the statement at these parameters, if it has at most so many rows."""
    with suppress(TooLongError):
        yield point_outcome(point, most)


def point_outcome(point: PointParameters, most: int | None = None) -> Outcome:
    """The statement at these parameters with its proofs, before the checker reads it.

    Raises:
        TooLongError: if an orbit has more collisions than ``most``, or than the checker can read.
    """
    rows, digits = _rows(point, MAX_ROWS if most is None else min(most, MAX_ROWS))
    parameters = {name: as_term(value) for name, value in point.values.items()}
    given = [Constant(name, name, name, "", x) for name, x in parameters.items()]
    constants = _constants(point)
    statement = Statement(
        POINT, _title(point), parameters, constants, (), tuple(rows), (glue(point),), (cite(NAME),)
    )
    session = Session()
    ground = Ground(session)
    names = [constant.name for constant in (*given, *constants)]
    for constant in (*given, *constants):
        ground.define(constant)
    decisions = {}
    for row in rows:
        if isinstance(row.claim, Claim):
            decisions[row.name] = ground.decide(row)._replace(judged=None)
            continue
        givens = _contexts()[row.claim.context.removeprefix(f"{NAME}:")].givens
        factors = FACTORS_OF_ROOTS if point.of.is_unlike else FACTORS
        proof = Applying((Interval(factors * digits),) * len(givens))
        session.prove_row(row, proof)
        decisions[row.name] = Decision(PROVED, proof)
    found = {name: ground.enclose(ground.definitions[name]) for name in names}
    enclosures = {name: ends for name, ends in found.items() if ends is not None}
    return Outcome(statement, decisions, tuple(session.steps), enclosures)


def _constants(point: PointParameters) -> tuple[Constant, ...]:
    r, c, ratio = map(symbol, NAMES[:3])
    if not point.of.is_unlike:
        return (
            Constant("a", "a", "a", LABEL, (1 + r) * c / 2),
            Constant("sigma", "σ", r"\sigma", LABEL, 1 / ratio),
        )
    m0, m1, m2, middle, last, after = map(symbol, BALLS)
    shares = m1 * m2 / ((m0 + m1) * (m0 + m2))
    scale = m1 * (m0 + m2) / (m2 * (m0 + m1))
    rho = ratio * (middle + after) / (middle + last) * sqrt(scale)
    return (
        Constant("a", "a", "a", LABEL, (1 + r) * c * sqrt(shares)),
        Constant("rho", "ρ", r"\rho", LABEL, rho),
        Constant("sigma", "σ", r"\sigma", LABEL, 1 / symbol("rho")),
    )


def _title(point: PointParameters) -> str:
    r, c, ratio, q, least, most, *balls = (
        exact_number(x, max(12, len(str(x.numerator * x.denominator))))
        for x in point.values.values()
    )
    where = f"at r = {r}, -cos θ = {c}, ratio {ratio}"
    if balls:
        where += f", masses {', '.join(balls[:3])}, radii {', '.join(balls[3:])}"
    if not point.most:
        return f"The separatrix of the limit map {where}: f({q}) = 0"
    return f"The separatrix of the limit map {where}: f({q}) lies between {least} and {most}"


@cache
def _contexts() -> dict[str, Context]:
    """The contexts of the theorem."""
    return {context.name: context for context in statement(NAME).contexts}


def _rows(point: PointParameters, most: int) -> tuple[list[Obligation], int]:
    """The rows, and the digits of the numbers in them."""
    exists, at_zero = has_separatrix(point.of), point.least == point.most == 0
    if not exists and at_zero:
        r, a = symbol("r"), symbol("a")
        claim = a**3 - 3 * r * a <= r * (1 + r)
        says = "a ≤ s + s², where s³ = r: no orbit goes on for ever"
        return [_row("flat", says, claim, THRESHOLD)], 1
    if at_zero and beyond(point.of, point.q):
        says = "q ≥ φ⁺: no orbit from there goes on for ever"
        digits = sum(len(str(x)) for x in point.values.values())
        return [_applied(point, "beyond", says, "beyond", 0, {"F": symbol("q")})], digits
    return _orbit_rows(point, most)


def _orbit_rows(point: PointParameters, most: int) -> tuple[list[Obligation], int]:
    digits = MORE_DIGITS + max(len(str(x.numerator)) for x in (point.least, point.most))
    for _ in range(DOUBLINGS):
        low, high = (_followed(point, digits, most, up=up) for up in (True, False))
        if low is not None and high is not None:
            rows = [*_below(point, low), *_above(point, high, digits)]
            longest = max(len(str(x)) for x in point.values.values())
            return rows, longest + digits
        digits *= 2
    raise TooLongError


def _below(point: PointParameters, steps: list[Step]) -> Iterator[Obligation]:
    state: tuple[Number, ...] = symbol("q"), symbol("least")
    for number, step in enumerate(steps, 1):
        says = f"the state after {number} collisions of (q, least) lies below the second one"
        at = dict(zip("QUXV", (*state, *step[3:]), strict=True))
        yield _applied(point, f"below-{number}", says, "up", number - 1, at)
        state = step[3:]
    says = "and not above the one two collisions before"
    yield from _compared("below-falls", says, steps[-1][3:], steps[-2][1:3])


def _above(point: PointParameters, steps: list[Step], digits: int) -> Iterator[Obligation]:
    state: tuple[Number, ...] = symbol("q"), symbol("most")
    for number, step in enumerate(steps, 1):
        says = f"the state after {number} collisions of (q, u), u ≥ most, lies above the second one"
        at = dict(zip("QUXV", (*state, *step[3:]), strict=True))
        yield _applied(point, f"above-{number}", says, "down", number - 1, at)
        state = step[3:]
    if _direction(steps) > 0:
        says = "and not below the one two collisions before"
        yield from _compared("above-rises", says, steps[-2][1:3], steps[-1][3:])
        says = "and it is another state"
        yield _row("above-rises", says, as_term(sum(steps[-2][1:3])) < sum(steps[-1][3:]))
        return
    orbit = Orbit(point.of, digits, up=False)
    q, u = steps[-1][3:] if steps else (point.q, point.most)
    left = orbit.a * (1 - u) - q - orbit.ratios[len(steps) % 2] * u
    ends = "parted" if left <= 0 else "missed"
    says = "and after that there is no collision"
    yield _applied(point, "above-end", says, ends, len(steps), dict(zip("QU", state, strict=True)))


def _compared(name: str, says: str, low: State, high: State) -> Iterator[Obligation]:
    for letter, less, more in zip("qu", low, high, strict=True):
        yield _row(f"{name}-{letter}", f"{letter}: {says}", as_term(less) <= more)


def _applied(
    point: PointParameters,
    name: str,
    says: str,
    context: str,
    number: int,
    at: Mapping[str, Number],
) -> Obligation:
    """The row that a context applies after so many collisions, to r, a, the ratio and numbers."""
    ratios = (symbol("rho" if point.of.is_unlike else "ratio"), symbol("sigma"))
    known: dict[str, Number] = {"r": symbol("r"), "a": symbol("a"), "rho": ratios[number % 2]}
    known |= {"sigma": ratios[1 - number % 2], **at}
    names = [variable.name for variable in _contexts()[context].variables]
    values = {full: as_term(known[full.removeprefix(f"{context}.")]) for full in names}
    return _row(name, says, Applies(f"{NAME}:{context}", values))


def _row(name: str, says: str, claim: Claim | Applies, label: str = LABEL) -> Obligation:
    return Obligation(name, POINT, label, NEEDED, says, claim, (GLUE,))
