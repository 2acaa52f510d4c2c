"""A guess of a point at which the givens of a context hold, where an author writes none.

Floating-point numbers only choose between exact candidates: the checker decides whether the givens
hold at the one that is chosen.
"""

from __future__ import annotations

import math
from collections import defaultdict
from collections.abc import Collection, Iterator, Mapping, Sequence
from fractions import Fraction

from verify.language.statement import Given
from verify.language.terms import Claim, Term, as_term, names_of, parts_of, substitute
from verify.prover.budget import WorkBudget
from verify.wire.text.estimates import estimate, seems, simplest

#: How many candidates are looked at one variable after another.
MOST = 2_000
#: Parts of givens that are looked at, for one context and for all of a file.
WORK, WORK_OF_FILE = 10_000_000, 15_000_000
#: So many of them take a microsecond; and so many microseconds a linear programme may take.
UNITS, PROGRAMME = 5, 300_000
#: To find where the sides of a claim are equal costs as much as so many looks at its parts.
SAMPLES = 40
#: Floats beyond this are so far apart that one next to a bound may be on its other side.
FAR = 2.0**50
_SIMPLE = tuple(map(Fraction, ("1", "0", "1/2", "2", "-1", "-1/2", "1/10", "3", "10", "-2", "100")))


class Points:
    """The search for the points of one file, which looks at so much in all."""

    def __init__(self, seconds: float | None = None) -> None:
        """Half of some seconds may go into the search, as far as its work is counted."""
        parts = math.inf if seconds is None else 500_000 * UNITS * seconds
        self.left, self._is_short = int(min(WORK_OF_FILE, parts)), parts < WORK_OF_FILE

    @property
    def in_time(self) -> str:
        """What to write first, where the time has ended the search."""
        is_over = self._is_short and self.left < UNITS
        return "a longer --time, or " if is_over else ""

    def find(
        self,
        variables: Sequence[str],
        givens: Sequence[Given],
        values: Mapping[str, float],
        around: Collection[str] = (),
    ) -> dict[str, Term] | None:
        """Terms for the variables at which the givens seem to hold; None if none were found.

        ``values`` has about what the other names stand for, those that vary ``around`` at one
        point.
        """
        if not givens:
            return dict.fromkeys(variables, as_term(1))
        if self.left <= 0:
            return None
        claims = [given.claim for given in givens]
        search = _Search(variables, claims, around, min(WORK, self.left))
        self.left -= search.left
        found = search.run(values)
        self.left += max(search.left, 0)
        if found is None:
            budget = WorkBudget(min(PROGRAMME, self.left // UNITS))
            from verify.wire.text.middle import in_the_middle  # only where it is needed

            found = in_the_middle(variables, claims, values, budget)
            self.left -= UNITS * (budget.work - budget.left)
        return found


class _Search:
    """Terms for the variables, each chosen after those before it, while there is work left."""

    def __init__(
        self, variables: Sequence[str], claims: Sequence[Claim], around: Collection[str], left: int
    ) -> None:
        self.variables, self.claims, self.around, self.left = variables, claims, around, left
        self._tried = iter(range(MOST))
        self._complete_at = _by_last_variable(variables, claims)
        self._parts = {claim: sum(1 for _ in parts_of(claim.lhs, claim.rhs)) for claim in claims}
        self._known: dict[tuple[object, ...], list[Term]] = {}

    def run(self, values: Mapping[str, float]) -> dict[str, Term] | None:
        """The terms, where ``values`` has about what other names stand for."""
        try:
            return self._complete({}, dict(values))
        except RecursionError:
            return None

    def _complete(self, found: dict[str, Term], at: dict[str, float]) -> dict[str, Term] | None:
        if len(found) == len(self.variables):
            return found
        name, ready = self.variables[len(found)], self._complete_at[len(found)]
        looks = sum(self._parts[claim] for claim in ready)
        self.left -= sum(self._parts.values())
        for term in self._candidates(name, ready, dict(found), at):
            self.left -= len(at) + looks
            if next(self._tried, None) is None or self.left < 0:
                return None
            there = at | {name: estimate(term, at)}
            found[name] = term
            if all(seems(claim, there, found) for claim in ready):
                result = self._complete(dict(found), there)
                if result is not None:
                    return result
        return None

    def _candidates(
        self, name: str, ready: list[Claim], found: dict[str, Term], at: dict[str, float]
    ) -> Iterator[Term]:
        yield from _bounded(name, self.claims, found, at, self.around)
        yield from self._solved(name, [c for c in ready if c.relation == "="], found)
        yield from map(as_term, _SIMPLE)
        yield from self._solved(name, [c for c in ready if c.relation != "="], found)

    def _solved(self, name: str, claims: list[Claim], found: dict[str, Term]) -> Sequence[Term]:
        """Where equations hold, or numbers on both sides of where inequalities are equations."""
        key = (name, *claims, *map(found.get, _names_in(claims)))
        if key not in self._known and claims:
            self.left -= SAMPLES * sum(self._parts[claim] for claim in claims)
            from verify.wire.text.solutions import between, equal  # loaded only where it is used

            solve = equal if claims[0].relation == "=" else between
            self._known[key] = [*solve(name, claims, found)] if self.left > 0 else []
        return self._known.get(key, ())


def _names_in(claims: Sequence[Claim]) -> list[str]:
    return [*names_of(*(side for claim in claims for side in (claim.lhs, claim.rhs)))]


def _by_last_variable(
    variables: Sequence[str], claims: Sequence[Claim]
) -> Mapping[int, list[Claim]]:
    """The claims, each where the last of its variables stands."""
    places = {name: i for i, name in enumerate(variables)}
    found: dict[int, list[Claim]] = defaultdict(list)
    for claim in claims:
        at = (places.get(name, 0) for name in _names_in([claim]))
        found[max(at, default=0)].append(claim)
    return found


def _bounded(
    name: str,
    claims: Sequence[Claim],
    found: Mapping[str, Term],
    at: Mapping[str, float],
    around: Collection[str],
) -> Iterator[Term]:
    """Between the bounds of a variable, then the bounds themselves."""
    low, high = _tightest(*_bounds(name, claims, found, at))
    ends = [end[1] for end in (low, high) if end]
    are_far = any(end and abs(end[0]) > FAR for end in (low, high))
    moves = are_far or not {*around}.isdisjoint(names_of(*ends))
    if low and high and (low[0] < high[0] or are_far):
        middle = (low[1] + high[1]) / 2
        yield middle if moves else as_term(simplest(low[0], high[0]))
    elif low:
        yield _beyond(low, 1) if moves else as_term(math.floor(low[0]) + 1)
    elif high:
        yield _beyond(high, -1) if moves else as_term(math.ceil(high[0]) - 1)
    yield from ends


Bound = tuple[float, Term]


def _beyond(bound: Bound, step: int) -> Term:
    """A term above a bound, or below it; its distance is one that can be seen."""
    value, term = bound
    if abs(value) <= FAR:
        return term + 1 if step > 0 else term - 1
    return 2 * term if value * step > 0 else term / 2


def _tightest(lows: Sequence[Bound], highs: Sequence[Bound]) -> tuple[Bound | None, Bound | None]:
    """The greatest lower and the least upper bound, unless it is beyond floats and says little."""
    low = max(lows, key=lambda pair: pair[0], default=None)
    high = min(highs, key=lambda pair: pair[0], default=None)
    if low and high and low[0] == high[0]:
        return low, high
    return (
        None if low and low[0] == -math.inf else low,
        None if high and high[0] == math.inf else high,
    )


def _bounds(
    name: str, claims: Sequence[Claim], found: Mapping[str, Term], at: Mapping[str, float]
) -> tuple[list[Bound], list[Bound]]:
    """The terms that are below and above a variable, with about their values."""
    lows: list[Bound] = []
    highs: list[Bound] = []
    others = {key: x for key, x in at.items() if key != name}
    for claim in claims:
        for side, other, bounds in (
            (claim.lhs, claim.rhs, [highs]),
            (claim.rhs, claim.lhs, [lows]),
        ):
            if side.op != "symbol" or side.name != name:
                continue
            value = estimate(other, others)
            if not math.isnan(value):
                for one in bounds if claim.relation != "=" else (lows, highs):
                    one.append((value, substitute(other, found)))
    return lows, highs
