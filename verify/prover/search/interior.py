"""A point at which givens hold, or a combination that shows that there is none.

Givens that are linear in the variables are a linear programme in exact arithmetic: the point that
is farthest from all of them, as their sides differ. If there is none, then by Farkas and Motzkin
the givens have a sum that says 0 < 0. Other givens are looked for from that point, and where they
are violated least.
"""

from __future__ import annotations

import math
from collections.abc import Callable, Iterator, Mapping, Sequence
from fractions import Fraction
from itertools import islice

from flint import fmpq

from verify.language.record import Record
from verify.language.statement import Context, Given, Variable
from verify.language.terms import Claim, Term, as_term, names_of
from verify.language.typeset import Typesetter
from verify.prover.balls import fmpq_of, fraction_of
from verify.prover.budget import SpentError, WorkBudget
from verify.prover.clearing import Clearing, TooLongError
from verify.prover.goal import bounds_of
from verify.prover.points import simple_points
from verify.prover.search.compiled import estimates
from verify.prover.search.local_minima import DISTANCES, Violations
from verify.prover.search.simplex import Column, solution

#: About the number of microseconds that a contradiction may take.
WORK = 300_000
#: The row that says that a sum is strict.
STRICT = 0
#: What is violated by less than this may hold at a short number near by.
NEAR = 1e-6
#: Other givens of more variables are not looked for.
MAX_VARIABLES = 14
#: So many places where little is violated are looked at.
MAX_PLACES = 8

Point = list[Fraction]


#: What it costs to see whether a claim is linear, beside the products of it that are expanded.
CLAIM = 50


class Linear(Record):
    """A claim as c + a_1 x_1 + ... >= 0, > 0 if it is strict, or = 0.

    It is exact unless numbers in it, such as roots, were replaced by floats, or floats alone say
    which sign a divisor has.
    """

    claim: Claim
    constant: fmpq
    slopes: Mapping[int, fmpq]
    is_exact: bool

    def holds(self, point: Sequence[Fraction]) -> bool:
        """Whether it holds at a point, exactly as it stands here."""
        value = fraction_of(self.constant)
        value += sum((fraction_of(a) * point[i] for i, a in self.slopes.items()), Fraction(0))
        relation = self.claim.relation
        return value == 0 if relation == "=" else value > 0 or (value == 0 and relation == "<=")


class Contradiction(Record):
    """How often each claim is added, and what the sum says, which is false."""

    addends: tuple[tuple[Fraction, Claim], ...]
    total: Claim

    @property
    def words(self) -> str:
        """The combination, in a sentence."""
        write = Typesetter({}).claim
        parts = [f"({write(c)})" if n == 1 else f"{n}*({write(c)})" for n, c in self.addends]
        return f"{' + '.join(parts)} says {write(self.total)}"


class Givens:
    """The givens of a context, with about what the names in them that are no variables stand for.

    Raises:
        SpentError: by each method, if it takes too much work.
    """

    def __init__(
        self,
        variables: Sequence[str],
        claims: Sequence[Claim],
        values: Mapping[str, float],
        budget: WorkBudget,
    ) -> None:
        self.variables, self.claims = [*variables], [*claims]
        self.numbers = {
            name: as_term(Fraction(value))
            for name, value in values.items()
            if math.isfinite(value) and name not in self.variables
        }
        self.budget = budget
        found = map(self._linear, self.claims)
        self.linear = [one for one in found if one is not None]

    # --- linear givens --------------------------------------------------------------------------

    def centre(self) -> Point | None:
        """A point at which all linear givens hold, far from those with < or <= if it can be."""
        every = [one.claim.relation != "=" for one in self.linear]
        strict = [one.claim.relation == "<" for one in self.linear]
        for moved in (every, strict) if any(strict) else (every,):
            found = self._farthest(moved)
            if found is not None and (found[0] or not any(strict)):
                return self._short(found[1])
        return None

    def contradiction(self) -> Contradiction | None:
        """How often each given is added so that they say 0 < 0."""
        exact = [one for one in self.linear if one.is_exact]
        facts = [one for one in exact if one.claim.relation != "="]
        equations = [one for one in exact if one.claim.relation == "="]

        def column(one: Linear) -> Column:
            found = {i + 2: a for i, a in one.slopes.items()}
            found |= {1: one.constant} if one.constant else {}
            return found | ({STRICT: fmpq(1)} if one.claim.relation == "<" else {})

        positive = {1: fmpq(1), STRICT: fmpq(1)}
        columns = [positive, *map(column, facts)]
        found = solution(columns, [*map(column, equations)], {STRICT: fmpq(1)}, self.budget)
        if found is None:
            return None
        (below, *weights), shares = found
        added = zip((*weights, *shares), (*facts, *equations), strict=True)
        addends = [(fraction_of(w), one.claim) for w, one in added if w]
        numbers = [n for n, _ in addends]
        unit = Fraction(
            math.gcd(*(n.numerator for n in numbers)), math.lcm(*(n.denominator for n in numbers))
        )
        addends = [(n / unit, claim) for n, claim in addends]
        strict = any(claim.relation == "<" for _, claim in addends)
        right = as_term(-fraction_of(below) / unit)
        total = Claim("<" if strict else "<=", as_term(0), right)
        return Contradiction(tuple(addends), total)

    def _farthest(self, moved: Sequence[bool]) -> tuple[fmpq, Point] | None:
        """The largest t at most 1 by which these givens can be sharpened, with such a point."""
        minus = fmpq(-1)
        rows = range(1, len(self.linear) + 1)
        distance: dict[int, fmpq] = {0: fmpq(1)}
        distance |= {row: minus for row, moves in zip(rows, moved, strict=True) if moves}
        slack: list[Column] = [{0: fmpq(1)}]
        free: list[dict[int, fmpq]] = [{} for _ in self.variables]
        wanted = {0: fmpq(1)}
        for row, one in zip(rows, self.linear, strict=True):
            if one.claim.relation != "=":
                slack.append({row: minus})
            for i, a in one.slopes.items():
                free[i][row] = a
            if one.constant:
                wanted[row] = -one.constant
        found = solution([distance, *slack], free, wanted, self.budget, [minus])
        return None if found is None else (found[0][0], [*map(fraction_of, found[1])])

    def _short(self, point: Point) -> Point:
        """Shorter numbers near a point at which the linear givens hold, if there are any."""
        floats = [float(x) for x in point]
        for near in simple_points(floats, [(None, None)] * len(point), inside=False):
            if all(one.holds(near) for one in self.linear):
                return near
        return point

    def _linear(self, claim: Claim) -> Linear | None:
        """A claim that is linear in the variables, if it is one."""
        sides = claim.rhs, claim.lhs
        clearing = Clearing(sides, {}, lambda term: self._value(term) < 0)
        try:
            divisors = [clearing.clear(side)[1] for side in sides]
            polynomial = clearing.difference(*sides)
        except (TooLongError, ArithmeticError):
            return None
        finally:
            self.budget.spend(CLAIM + clearing.products)
        places = [self._place(atom) for atom in clearing.atoms]
        if any(d for p in divisors for x, d in zip(places, p.degrees(), strict=True) if x != -1):
            return None
        slopes: dict[int, fmpq] = {}
        is_exact = all(divisor.is_constant() for divisor in divisors)
        for exponents, coefficient in polynomial.to_dict().items():
            value, variable = coefficient, -1
            for atom, place, power in zip(clearing.atoms, places, exponents, strict=True):
                if not power:
                    continue
                if place == -1:
                    is_exact, number = False, self._value(atom)
                    if not math.isfinite(number):
                        return None
                    value *= fmpq_of(number) ** int(power)
                elif place is None or variable != -1 or power > 1:
                    return None
                else:
                    variable = place
            slopes[variable] = slopes.get(variable, fmpq(0)) + value
        constant = slopes.pop(-1, fmpq(0))
        return Linear(claim, constant, {i: a for i, a in slopes.items() if a}, is_exact)

    def _place(self, atom: Term) -> int | None:
        """The index of a variable, -1 of a number, or nothing of a function of variables."""
        names = names_of(atom)
        if not {*names} & {*self.variables}:
            return -1
        return self.variables.index(atom.name) if atom.op == "symbol" else None

    def _value(self, term: Term) -> float:
        """About the value of a term without variables; NaN where that is not known."""
        try:
            return float(estimates([], [term], self.numbers)()[0])
        except (ArithmeticError, ValueError, KeyError):
            return math.nan

    # --- other givens ---------------------------------------------------------------------------

    def near_misses(self) -> Iterator[Point]:
        """Short numbers near the places where the givens are violated least."""
        names = {name for claim in self.claims for name in names_of(claim.lhs, claim.rhs)}
        is_small = len(self.variables) <= MAX_VARIABLES
        if not (is_small and names <= {*self.variables, *self.numbers}):
            return
        givens = tuple(Given("", claim) for claim in self.claims)
        own = tuple(Variable(name, name, name) for name in self.variables)
        bounds = bounds_of(Context("", own, givens, {}))
        ends = [(b.low, b.high) for b in bounds.values()]
        for distance in DISTANCES:
            places = Violations(bounds, self.claims, self.numbers, self.budget, distance).found()
            for violation, point in islice(places, MAX_PLACES):
                if violation > NEAR:
                    break
                for inside in (True, False):
                    yield from simple_points(point, ends, inside=inside)


def interior(
    variables: Sequence[str],
    claims: Sequence[Claim],
    values: Mapping[str, float],
    holds: Callable[[Point], bool],
    budget: WorkBudget,
) -> Point | None:
    """A point at which the claims hold, as the caller sees it; None if the work ends before.

    ``values`` has about what the other names stand for.
    """
    try:
        givens = Givens(variables, claims, values, budget)
        centre = givens.centre()
        if centre is None or holds(centre):
            return centre
        return next((point for point in givens.near_misses() if holds(point)), None)
    except (SpentError, OverflowError):
        return None


def contradiction_of(variables: Sequence[str], claims: Sequence[Claim]) -> Contradiction | None:
    """A sum of the claims that are linear which is false."""
    try:
        return Givens(variables, claims, {}, WorkBudget(WORK)).contradiction()
    except (SpentError, OverflowError):
        return None
