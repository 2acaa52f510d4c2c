"""Values that satisfy all givens and at which a claim is false: equations solved, then a descent.

An equation that is of degree 1 in a variable, or says what its square is, says what the variable
is: a quotient, or a root with either sign. The others are looked for where the givens are violated
least, in floats; short rational numbers near such a place are tried in exact arithmetic.
"""

from __future__ import annotations

from collections.abc import Callable, Iterator, Mapping, Sequence
from fractions import Fraction
from itertools import islice

from flint import fmpq_mpoly

from verify.language.statement import Context
from verify.language.terms import Claim, Term, as_term, names_of, parts_of, sqrt, substitute
from verify.prover.clearing import TooLongError, coefficients, expanded
from verify.prover.goal import Bounds, Goal
from verify.prover.points import failure_test, simple_points
from verify.prover.search.local_minima import DISTANCES, Violations
from verify.prover.search.question import NEAR_ZERO, Question
from verify.prover.search.system import System
from verify.prover.session import ZERO

#: So many ways to solve the equations are tried, and so many points near each descent.
MAX_FORMS = 8
MAX_POINTS = 24

Values = dict[str, Term]
Failure = Callable[[Sequence[Fraction]], bool]


def false_points(question: Question, context: Context) -> Iterator[Values]:
    """Values for the variables of a context at which the claim may be false, and the givens hold.

    Nothing is promised of them: each is to be tried.
    """
    wide = question.widened() or question
    if not wide.clears() or not wide.goal.variables.keys() <= context.point.keys():
        return
    try:
        system = System(wide)
    except TooLongError:
        return
    for solved in _forms(system):
        for values in _Search(wide, solved).points():
            yield {**context.point, **_at(values, solved)}


def is_false(question: Question) -> bool:
    """Whether there are short numbers at which the givens hold and the claim does not."""
    undo = question.known.mark()
    try:
        system = System(question)
    except TooLongError:
        return False
    finally:
        undo()
    return any(True for solved in _forms(system) for _ in _Search(question, solved).points())


def _at(values: Mapping[str, Fraction], solved: dict[str, Term]) -> Values:
    """The terms of all variables, where the free ones have values."""
    found: Values = {name: as_term(value) for name, value in values.items()}
    for name in reversed(solved):
        found[name] = substitute(solved[name], found)
    return found


def _equations(system: System) -> list[fmpq_mpoly]:
    """The equations, also those that two inequalities make."""
    found = [*system.equations.values()]
    plain = [fact.polynomial for fact in system.facts if not fact.strict]
    found += [p for i, p in enumerate(plain) if any((p + q).is_zero() for q in plain[:i])]
    return found


def _forms(system: System) -> Iterator[dict[str, Term]]:
    """Ways to solve all equations in which no variable occurs in what it is."""
    for solved in islice(_solved_forms(system, _equations(system)), MAX_FORMS):
        waiting = set(solved)
        for name in reversed(solved):
            if waiting.isdisjoint(names_of(solved[name])):
                waiting.remove(name)
        if not waiting:
            yield solved


def _solved_forms(system: System, equations: list[fmpq_mpoly]) -> Iterator[dict[str, Term]]:
    """Ways to solve all equations: terms for variables, over later ones and those that are free."""
    if not equations:
        yield {}
        return
    names = system.question.goal.variables
    allowed = names.keys() | system.question.known.ground.definitions.keys()
    for i, equation in enumerate(equations):
        others = [*equations[:i], *equations[i + 1 :]]
        for index, atom in enumerate(system.atoms):
            degree = int(equation.degrees()[index])
            if atom.op != "symbol" or atom.name not in names or not 1 <= degree <= 2:
                continue
            if any(other.degrees()[index] > 0 for other in others):
                continue
            for term in _solutions(system, equation, index):
                if not allowed.issuperset(names_of(term)):
                    continue
                for rest in _solved_forms(system, others):
                    yield {atom.name: term, **rest}


def _solutions(system: System, equation: fmpq_mpoly, index: int) -> Iterator[Term]:
    """The terms that a variable may be."""
    parts = coefficients(equation, index)
    top = max(parts)
    if top == 2 and (1 in parts or not parts[2].is_constant()):
        return
    rest = -parts.get(0, system.context.constant(0))
    if parts[top].is_constant():
        term = expanded(rest / parts[top].leading_coefficient(), system.atoms)
    else:
        term = expanded(rest, system.atoms) / expanded(parts[top], system.atoms)
    if top == 1:
        yield term
    else:
        yield sqrt(term)
        yield -sqrt(term)


class _Search:
    """The variables that are free, and what has to hold of them."""

    def __init__(self, question: Question, solved: dict[str, Term]) -> None:
        self.question = question
        goal = question.goal
        ground = question.known.ground.definitions
        numbers = {n: t for n, t in goal.definitions.items() if n in ground}
        local = {n: t for n, t in goal.definitions.items() if n not in ground}
        self.definitions = {**numbers, **dict(reversed(solved.items())), **local}
        self.free = {name: b for name, b in goal.variables.items() if name not in solved}
        bounds = (b for name, b in goal.variables.items() if name in solved)
        facts = [name for b in bounds for name in (b.low_fact, b.high_fact) if name]
        claims = [question.session.claims[name] for name in facts]
        self.claims = [*question.given.values(), *(c for c in claims if c.relation != "=")]
        roots = (part for part in parts_of(*solved.values()) if part.op == "sqrt")
        self.claims += [Claim("<=", ZERO, root.children[0]) for root in roots]

    def points(self) -> Iterator[dict[str, Fraction]]:
        """Short numbers for the free variables, near those where least is violated."""
        is_bad = self._test()
        ends = [(b.low, b.high) for b in self.free.values()]
        is_bounded = all(b.ends for b in self.free.values())
        for distance in DISTANCES[:1] if is_bounded else DISTANCES:
            tried = 0
            for violation, point in self._violations(distance):
                if violation > NEAR_ZERO or tried > MAX_POINTS:
                    break
                for inside in (True, False):
                    for values in simple_points(point, ends, inside=inside):
                        tried += 1
                        if not is_bad(values):
                            yield dict(zip(self.free, values, strict=True))
                            break

    def _violations(self, distance: float) -> list[tuple[float, tuple[float, ...]]]:
        """Where the givens are violated least, and the negated claim."""
        claim = self.question.goal.claim
        negated = Claim("<=" if claim.relation == "<" else "<", claim.rhs, claim.lhs)
        claims, budget = [negated, *self.claims], self.question.budget
        return Violations(self.free, claims, self.definitions, budget, distance).found()

    def _test(self) -> Failure:
        """Whether a given is false at a point, or the claim true."""
        goal, known = self.question.goal, self.question.known
        claims = [*self.claims, *(c for b in self.free.items() for c in _claims(*b))]

        def tested(claim: Claim) -> Failure:
            asked = Goal(claim, goal.context, self.free, (), self.definitions)
            return failure_test(asked, known.enclosed)

        is_false, givens = tested(goal.claim), [*map(tested, claims)]
        return lambda values: any(fails(values) for fails in givens) or not is_false(values)


def _claims(name: str, bounds: Bounds) -> Iterator[Claim]:
    """What bounds by numbers say."""
    x = Term("symbol", name)
    if bounds.low is not None and bounds.low_relation != "=":
        yield Claim(bounds.low_relation, as_term(bounds.low), x)
    if bounds.high is not None and bounds.high_relation != "=":
        yield Claim(bounds.high_relation, x, as_term(bounds.high))
