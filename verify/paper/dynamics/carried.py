"""A recursion from collision to collision: its start, and conditions carried from state to state.

At the start there are some numbers, and constants that bound the sums of what all later collisions
change. The conditions hold at the start; where they hold at a state, they hold at the next one.
"""

from __future__ import annotations

from collections.abc import Iterable, Iterator, Mapping
from fractions import Fraction

from verify.language.argument import (
    ByInduction,
    ByRoot,
    Defined,
    Factor,
    Item,
    Line,
    Value,
    identity,
    proof,
)
from verify.language.record import Record
from verify.language.statement import Always, Assumption, Constant, Context, Given, Variable
from verify.language.terms import Claim, Term, as_term, equal, sqrt, substitute_claim, symbol
from verify.language.vectors import Frame
from verify.paper.dynamics.state import (
    CONTEXT,
    LETTERS,
    NAMES,
    after_the_collision,
    collision_map,
    frame,
    root_of,
    time_of,
)
from verify.paper.parameters import THEOREM

START = "start"
CAUCHY_SCHWARZ = "cauchy-schwarz"
#: The first state, in inner products.
start = Frame(*(symbol(f"{name}_start") for name in NAMES))

#: A number of the start: in Unicode, in LaTeX, at the point at which the context opens.
Number = tuple[str, str, str]
#: A number that goes along: in Unicode, in LaTeX, at the start, after the next collision.
Ghost = tuple[str, str, Term, Term]


class Sum(Record):
    """A sum of a geometric sequence: its first term over 1 less the ratio."""

    letter: str
    over: Term
    under: Term

    @property
    def term(self) -> Term:
        """The sum itself."""
        return self.over / self.under


def starting(
    numbers: Mapping[str, Number], state: str, givens: Mapping[str, Claim], sums: Mapping[str, Sum]
) -> Context:
    """The numbers and the first state, with the sums over all later collisions.

    The inner products of the state at the point stand in a text, in the order of `NAMES`.
    """
    letters = {name: (text, tex) for name, (text, tex, _) in numbers.items()}
    letters |= {f"{n}_start": (f"({text})₀", f"({tex})_0") for n, (text, tex) in LETTERS.items()}
    point = (*(value for _, _, value in numbers.values()), *state.split())
    return Context(
        START,
        tuple(Variable(name, *letter) for name, letter in letters.items()),
        tuple(Given(name, claim) for name, claim in givens.items()),
        {name: as_term(Fraction(value)) for name, value in zip(letters, point, strict=True)},
        says="a state just after a collision, with numbers that satisfy the inequalities",
        constants=tuple(Constant(n, x.letter, x.letter, "", x.term) for n, x in sums.items()),
    )


def summed(name: str, sums: Mapping[str, Sum], positive: Value) -> Iterator[Item]:
    """What defines such a sum, without its quotient, and its sign."""
    yield Defined(name)
    claim = equal(symbol(name) * sums[name].under, sums[name].over)
    yield Line(f"{name}-sum", claim, identity(name))
    yield Line(f"{name}-positive", 0 < symbol(name), proof(positive, using=name))


class Carried(Record):
    """What is carried from state to state, and the numbers that go along."""

    conditions: Mapping[str, Claim]
    ghosts: Mapping[str, Ghost]

    @property
    def following(self) -> dict[str, Term]:
        """The numbers of the next state."""
        return after_the_collision() | {name: after for name, (*_, after) in self.ghosts.items()}

    def begun(self, state: Frame = start) -> dict[str, Term]:
        """The numbers where the recursion starts, from a state."""
        return state._asdict() | {name: first for name, (_, _, first, _) in self.ghosts.items()}

    def at(self, values: Mapping[str, Term]) -> dict[str, Claim]:
        """The conditions at a state, by their names."""
        return {name: substitute_claim(c, values) for name, c in self.conditions.items()}

    def at_next(self, name: str) -> Claim:
        """A condition at the next state."""
        return substitute_claim(self.conditions[name], self.following)

    def line(
        self,
        name: str,
        says: str,
        *addends: Factor,
        label: str = "",
        using: str = "",
        equations: tuple[tuple[str, Term], ...] = (),
    ) -> Line:
        """A condition at the next state, with its proof."""
        reason = proof(*addends, using=using, equations=equations)
        return Line(f"next-{name}", self.at_next(name), reason, label, says)

    def root(self, prefix: str, values: Mapping[str, Term]) -> Iterator[Item]:
        """The root in the time to the next collision is positive at a state with zeta < 1."""
        root = substitute_claim(0 < root_of(frame), values)
        yield Line(f"{prefix}root", root, ByRoot())
        yield Line(f"{prefix}root-sum", self.at(values)["root-sum"], proof(1, f"{prefix}root"))

    def context(
        self,
        standing: Mapping[str, Claim],
        point: Mapping[str, Term],
        constants: tuple[Constant, ...],
        *,
        parent: str = START,
        says: str = "",
        goes_on: Iterable[Given] = (),
    ) -> Context:
        """The states that satisfy the conditions, and what holds for all vectors."""
        letters = LETTERS | {name: (text, tex) for name, (text, tex, *_) in self.ghosts.items()}
        carried = (Given(name, claim, "carried") for name, claim in self.conditions.items())
        vectors = (Given(n, claim, "standing", CAUCHY_SCHWARZ) for n, claim in standing.items())
        return Context(
            CONTEXT,
            tuple(Variable(name, *letter) for name, letter in letters.items()),
            (*carried, *vectors, *goes_on),
            point,
            parent,
            f"a state just after a collision that satisfies the conditions{says}",
            constants,
        )

    def always(
        self,
        premises: Iterable[str],
        uses: Iterable[Assumption],
        where: str = "",
    ) -> Line:
        """All conditions hold in every state, by induction."""
        says = "by induction on n all conditions hold after the n-th collision, for every n"
        return Line("always", Always(CONTEXT, self.begun(), self.following),
                    ByInduction(tuple(premises), tuple(f"next-{name}" for name in self.conditions)),
                    THEOREM, says + where, tuple(one.name for one in uses))  # fmt: skip


def followed(
    label: str, rho: Term, pace: Term, load: Term, share: Term, U: Term
) -> tuple[Constant, ...]:
    """The collision map, and beside it the map of two numbers (Q, U) to which it is compared."""
    here, weight = symbol("pace"), symbol("load")
    more = {
        "rho": ("ρ", r"\rho", rho),
        "pace": ("P", "P", pace),
        "load": ("L", "L", load),
        "Q_next": ("Q'", "Q'", share * (1 - U) / here),
        "U_next": ("U'", "U'", 1 - sqrt(1 - weight / here / here)),
    }
    constants = (
        Constant(name, letter, tex, label, term) for name, (letter, tex, term) in more.items()
    )
    return (*collision_map(time_of(frame)), *constants)
