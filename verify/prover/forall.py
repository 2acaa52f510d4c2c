"""The prover of claims that hold for all values of their variables.

Nothing here is trusted. An equation is expanded; an inequality in one variable gets a Bernstein
degree, one in several bounded variables a grid; a claim that fails gets a point where it fails.
"""

from __future__ import annotations

from collections.abc import Callable, Iterator, Mapping
from fractions import Fraction
from itertools import pairwise, product
from types import MappingProxyType
from typing import Any, NamedTuple

from verify.language.statement import Obligation, Variable
from verify.language.terms import Claim
from verify.prover import balls
from verify.prover.algebra import is_identity
from verify.prover.ground import PROVED, REFUTED, UNDECIDED, Decision, Ends
from verify.prover.polynomials import NotPolynomialError, bernstein, coefficients, formal_degree
from verify.prover.program import ExactArithmetic, Machine, Program

BITS = 128

#: A Bernstein degree is at most this much larger than the degree of the polynomial.
MAX_ELEVATION = 40

#: The finest grid has this many cells in each variable.
MAX_CELLS = 64

#: How many points are tried before a claim is left undecided.
MAX_POINTS = 64

Point = Mapping[str, Fraction]
Cuts = Mapping[str, tuple[Fraction, ...]]


class Finding(NamedTuple):
    """A decision on a claim with variables, with its evidence.

    ``degree`` is the Bernstein degree, ``cuts`` the grid, ``point`` a place where a refuted claim
    fails.
    """

    decision: Decision
    degree: int = 0
    cuts: Cuts = MappingProxyType({})
    point: Point = MappingProxyType({})

    @property
    def verdict(self) -> str:
        """The verdict."""
        return self.decision.verdict

    @property
    def method(self) -> str:
        """The rule that shows it; for an expansion ``identity``."""
        return self.decision.closing or self.decision.method


def decide_row(row: Obligation) -> Finding:
    """Decide one row."""
    claim, variables = row.claim, row.variables
    if not variables:
        return _closed(claim)
    for attempt in (_identity, _bernstein, _grid):
        found = attempt(claim, variables)
        if found is not None:
            return found
    point = refuting_point(claim, variables)
    if point is not None:
        return _finding(REFUTED, "witness", point=point)
    return _finding(UNDECIDED, "")


def _finding(verdict: str, method: str, closing: str = "", **evidence: Any) -> Finding:
    return Finding(Decision(verdict, method, BITS, None, None, (), closing), **evidence)


# --- without variables ---------------------------------------------------------------------------


def _closed(claim: Claim) -> Finding:
    program = Program(())
    sides = program.add(claim.lhs), program.add(claim.rhs)
    run = Machine(program, ExactArithmetic()).run(())
    a, b = (run.values[slot] for slot in sides)
    if a is not None and b is not None:
        verdict = PROVED if _exact_holds(claim.relation, a, b) else REFUTED
        return Finding(Decision(verdict, "exact", BITS, (a, a), (b, b)))
    with balls.precision(BITS):
        values = Machine(program, balls.BallArithmetic()).run(()).values
        x, y = (values[slot] for slot in sides)
        if x is None or y is None:
            return _finding(UNDECIDED, "")
        lhs, rhs = balls.ends(x), balls.ends(y)
        holds, fails = _ball_holds(claim.relation, x, y), _ball_fails(claim.relation, x, y)
    if holds or fails:
        verdict = PROVED if holds else REFUTED
        return Finding(Decision(verdict, "interval", BITS, lhs, rhs))
    return _closed_identity(claim, lhs, rhs)


def _closed_identity(claim: Claim, lhs: Ends, rhs: Ends) -> Finding:
    if claim.relation != "<" and is_identity(claim.lhs, claim.rhs):
        return Finding(Decision(PROVED, "rewrite", BITS, lhs, rhs, (), "identity"))
    return Finding(Decision(UNDECIDED, "", BITS, lhs, rhs))


def _exact_holds(relation: str, a: Fraction, b: Fraction) -> bool:
    return {"<": a < b, "<=": a <= b, "=": a == b}[relation]


def _ball_holds(relation: str, x: balls.Ball, y: balls.Ball) -> bool:
    if relation == "<":
        return balls.less(x, y)
    if relation == "<=":
        return balls.less_equal(x, y)
    return balls.less_equal(x, y) and balls.less_equal(y, x)


def _ball_fails(relation: str, x: balls.Ball, y: balls.Ball) -> bool:
    if relation == "<":
        return balls.less_equal(y, x)
    if relation == "<=":
        return balls.less(y, x)
    return balls.less(x, y) or balls.less(y, x)


# --- for all values ------------------------------------------------------------------------------


def _identity(claim: Claim, _variables: tuple[Variable, ...]) -> Finding | None:
    if claim.relation != "<" and is_identity(claim.lhs, claim.rhs):
        return _finding(PROVED, "rewrite", closing="identity")
    return None


def _bernstein(claim: Claim, variables: tuple[Variable, ...]) -> Finding | None:
    """A degree for which the Bernstein coefficients of rhs - lhs show the claim."""
    if claim.relation == "=" or len(variables) != 1:
        return None
    lower, upper = variables[0].lower, variables[0].upper
    if lower is None or upper is None:
        return None
    difference = claim.rhs - claim.lhs
    try:
        polynomial = coefficients(difference, variables[0].name)
    except NotPolynomialError:
        return None
    # At least the formal degree, so that a reader of the certificate need not cancel terms.
    least = formal_degree(difference)
    for degree in range(least, least + MAX_ELEVATION + 1):
        values = bernstein(polynomial, lower, upper, degree)
        if min(values) >= 0 and (claim.relation == "<=" or any(values)):
            return _finding(PROVED, "bernstein", degree=degree)
    return None


def _grid(claim: Claim, variables: tuple[Variable, ...]) -> Finding | None:
    """A uniform grid on whose cells the enclosures decide."""
    ends = [(v.name, v.lower, v.upper) for v in variables]
    if claim.relation == "=" or len(ends) < 2:
        return None
    cells = 1
    while cells <= MAX_CELLS:
        cuts = {
            name: tuple(lower + (upper - lower) * i / cells for i in range(cells + 1))
            for name, lower, upper in ends
            if lower is not None and upper is not None
        }
        if len(cuts) < len(ends):
            return None
        if _holds_on_cells(claim, cuts):
            return _finding(PROVED, "cuts", cuts=cuts)
        cells *= 2
    return None


def _holds_on_cells(claim: Claim, cuts: Cuts) -> bool:
    program = Program(cuts)
    sides = program.add(claim.lhs), program.add(claim.rhs)
    with balls.precision(BITS):
        machine = Machine(program, balls.BallArithmetic())
        sections = [
            [
                balls.hull(balls.from_fraction(a), balls.from_fraction(b))
                for a, b in pairwise(points)
            ]
            for points in cuts.values()
        ]
        for box in product(*sections):
            values = machine.run(box).values
            x, y = (values[slot] for slot in sides)
            if x is None or y is None or not _ball_holds(claim.relation, x, y):
                return False
    return True


# --- a point where a claim fails -----------------------------------------------------------------

_FRACTIONS = tuple(map(Fraction, ("1/2", "1/4", "3/4", "1/5", "2/3", "1/7", "9/10", "1/100")))
_POSITIVE = tuple(map(Fraction, ("1", "2", "1/2", "3", "10", "1/10", "7")))
_NUMBERS = tuple(map(Fraction, ("0", "1", "-1", "2", "-3", "10", "-10", "5", "-7", "1/3", "-100")))


def refuting_point(claim: Claim, variables: tuple[Variable, ...]) -> Point | None:
    """A point where the claim is false, with simple values; None if none is found."""
    fails = _failure_test(claim, variables)
    candidates = [_candidates(variable) for variable in variables]
    for values in _points(candidates):
        if fails(values):
            break
    else:
        return None
    for i, simple in enumerate(candidates):
        for value in simple:
            if value == values[i]:
                break
            simpler = [*values[:i], value, *values[i + 1 :]]
            if fails(simpler):
                values = simpler
                break
    return {variable.name: value for variable, value in zip(variables, values, strict=True)}


def _candidates(variable: Variable) -> tuple[Fraction, ...]:
    lower, upper = variable.lower, variable.upper
    if lower is not None and upper is not None:
        return tuple(lower + (upper - lower) * part for part in _FRACTIONS)
    if lower is not None:
        return tuple(lower + step for step in _POSITIVE)
    if upper is not None:
        return tuple(upper - step for step in _POSITIVE)
    return _NUMBERS


def _points(candidates: list[tuple[Fraction, ...]]) -> Iterator[list[Fraction]]:
    """Points that mix the candidates of the variables in many ways, always the same ones."""
    for attempt in range(MAX_POINTS):
        yield [values[attempt * (i + 1) % len(values)] for i, values in enumerate(candidates)]


def _failure_test(
    claim: Claim, variables: tuple[Variable, ...]
) -> Callable[[list[Fraction]], bool]:
    """Whether the claim is false at a point: by exact values, or else by enclosures."""
    program = Program(variable.name for variable in variables)
    sides = program.add(claim.lhs), program.add(claim.rhs)
    exact, enclosed = (Machine(program, a) for a in (ExactArithmetic(), balls.BallArithmetic()))

    def fails(values: list[Fraction]) -> bool:
        found = exact.run(values).values
        a, b = (found[slot] for slot in sides)
        if a is not None and b is not None:
            return not _exact_holds(claim.relation, a, b)
        with balls.precision(BITS):
            found = enclosed.run(map(balls.from_fraction, values)).values
            x, y = (found[slot] for slot in sides)
            return x is not None and y is not None and _ball_fails(claim.relation, x, y)

    return fails
