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
from verify.language.terms import (
    MAX_INDEX,
    Claim,
    Term,
    acos,
    as_term,
    asin,
    exp,
    log,
    names_of,
    nth_root,
    parts_of,
    sqrt,
    substitute,
    tan,
)
from verify.prover.clearing import ROOTS, TooLongError, coefficients, expanded
from verify.prover.goal import Bounds, Goal
from verify.prover.points import failure_test, simple_points
from verify.prover.search.local_minima import DISTANCES, Violations
from verify.prover.search.question import NEAR_ZERO, Question
from verify.prover.search.system import System
from verify.prover.session import ZERO

#: So many ways to solve the equations are tried, and so many points near each descent.
MAX_FORMS = 8
MAX_POINTS = 24

#: What a function that has an inverse is at, where it has a value.
INVERSE: Mapping[str, Callable[[Term], Term]] = {
    "exp": log,
    "log": exp,
    "sin": asin,
    "cos": acos,
    "atan": tan,
}

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
    for more in _where_equal(system):
        for solved in _forms(system, more):
            for values in _Search(wide, solved, is_equal=bool(more)).points():
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


def _where_equal(system: System) -> list[list[fmpq_mpoly]]:
    """Equations of which one is true where the claim is false, if it says that numbers differ."""
    claim = system.question.goal.claim
    square = claim.rhs
    if claim.key[:2] != ("<", ZERO) or square.op != "pow" or square.exponent % 2:
        return [[]]
    above, _ = system.clearing.clear(square.children[0])
    factors = [] if above.is_constant() else above.factor()[1]
    return [*([factor] for factor, _ in factors), []]


def _forms(system: System, more: Sequence[fmpq_mpoly] = ()) -> Iterator[dict[str, Term]]:
    """Ways to solve all equations in which no variable occurs in what it is."""
    equations = [*_equations(system), *more]
    for solved in islice(_solved_forms(system, equations), MAX_FORMS):
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
        for index in range(len(system.atoms)):
            name = _variable(system, index)
            if name not in names or int(equation.degrees()[index]) < 1:
                continue
            if any(other.degrees()[index] > 0 for other in others):
                continue
            for term in _solutions(system, equation, index):
                if not allowed.issuperset(names_of(term)) or name in names_of(term):
                    continue
                for rest in _solved_forms(system, others):
                    yield {name: term, **rest}


def _variable(system: System, index: int) -> str:
    """The variable that an atom is, or that a function which has an inverse is of."""
    atom = system.atoms[index]
    if atom.op in INVERSE and atom.children[0].op == "symbol":
        atom = atom.children[0]
        same = [i for i, other in enumerate(system.atoms) if atom.name in names_of(other)]
        if len([i for i in same if system.atoms[i] != atom]) > 1:
            return ""
    return atom.name if atom.op == "symbol" else ""


def _solutions(system: System, equation: fmpq_mpoly, index: int) -> Iterator[Term]:
    """The terms that a variable may be."""
    parts = coefficients(equation, index)
    top = max(parts)
    if top > MAX_INDEX or parts.keys() - {0, top} or (top > 1 and not parts[top].is_constant()):
        return
    rest, atom = -parts.get(0, system.context.constant(0)), system.atoms[index]
    if parts[top].is_constant():
        term = expanded(rest / parts[top].leading_coefficient(), system.atoms)
    else:
        term = expanded(rest, system.atoms) / expanded(parts[top], system.atoms)
    if atom.op != "symbol":
        if top == 1:
            yield INVERSE[atom.op](term)
    elif top == 1 or term == ZERO:
        yield term
    else:
        for sign in (1, -1):
            root = sqrt(term if sign == 1 or top % 2 == 0 else -term)
            root = root if top == 2 else nth_root(root.children[0], top)
            yield root if sign == 1 else -root


class _Search:
    """The variables that are free, and what has to hold of them.

    Where both sides of the claim are equal, ``is_equal``, it is false whatever estimates say.
    """

    def __init__(
        self, question: Question, solved: dict[str, Term], *, is_equal: bool = False
    ) -> None:
        self.question, self.is_equal = question, is_equal
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
        roots = (part for part in parts_of(*solved.values()) if part.op in ROOTS)
        self.claims += [Claim("<=", ZERO, root.children[0]) for root in roots]

    def points(self) -> Iterator[dict[str, Fraction]]:
        """Short numbers for the free variables, near those where least is violated."""
        is_bad = self._test()
        if not self.free:
            if not is_bad([]):
                yield {}
            return
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
        claims = self.claims if self.is_equal else [negated, *self.claims]
        budget = self.question.budget
        return Violations(self.free, claims, self.definitions, budget, distance).found()

    def _test(self) -> Failure:
        """Whether a given is false at a point, or the claim true."""
        goal, known = self.question.goal, self.question.known
        claims = [*self.claims, *(c for b in self.free.items() for c in _claims(*b))]

        def tested(claim: Claim) -> Failure:
            asked = Goal(claim, goal.context, self.free, (), self.definitions)
            return failure_test(asked, known.enclosed)

        is_false, givens = tested(goal.claim), [*map(tested, claims)]
        certain = (lambda _: True) if self.is_equal else is_false
        return lambda values: any(fails(values) for fails in givens) or not certain(values)


def _claims(name: str, bounds: Bounds) -> Iterator[Claim]:
    """What bounds by numbers say."""
    x = Term("symbol", name)
    if bounds.low is not None and bounds.low_relation != "=":
        yield Claim(bounds.low_relation, as_term(bounds.low), x)
    if bounds.high is not None and bounds.high_relation != "=":
        yield Claim(bounds.high_relation, x, as_term(bounds.high))
