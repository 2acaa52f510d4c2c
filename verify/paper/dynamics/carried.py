"""A recursion from collision to collision: its start, and conditions carried from state to state.

At the start there are some numbers, and constants that bound the sums of what all later collisions
change. The conditions hold at the start; where they hold at a state, they hold at the next one.
"""

from __future__ import annotations

from collections.abc import Iterable, Iterator, Mapping
from fractions import Fraction

from verify.language.argument import (
    ByInduction,
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
from verify.paper.dynamics.state import CONTEXT, LETTERS, NAMES, collision_map, frame, time_of
from verify.paper.parameters import THEOREM

START = "start"
CAUCHY_SCHWARZ = "cauchy-schwarz"
#: The first state, in inner products.
start = Frame(*(symbol(f"{name}_start") for name in NAMES))

#: A number of the start, as people write it: in Unicode, in LaTeX.
Letter = tuple[str, str]
#: A sum of a geometric sequence: its first term over 1 less the ratio.
Sum = tuple[Term, Term]


def starting(
    numbers: Mapping[str, Letter],
    givens: Mapping[str, Claim],
    point: Mapping[str, str],
    sums: Mapping[str, Sum],
    letters: Mapping[str, str],
) -> Context:
    """The numbers and the first state, with the sums over all later collisions."""
    first = {f"{name}_start": (f"({text})₀", f"({tex})_0") for name, (text, tex) in LETTERS.items()}
    return Context(
        START,
        tuple(Variable(name, *letter) for name, letter in (*numbers.items(), *first.items())),
        tuple(Given(name, claim) for name, claim in givens.items()),
        {name: as_term(Fraction(point[name])) for name in (*numbers, *first)},
        says="a state just after a collision, with numbers that satisfy the inequalities",
        constants=tuple(
            Constant(name, letters[name], letters[name], "", over / under)
            for name, (over, under) in sums.items()
        ),
    )


def summed(name: str, sums: Mapping[str, Sum], positive: Value) -> Iterator[Item]:
    """What defines such a sum, without its quotient, and its sign."""
    over, under = sums[name]
    yield Defined(name)
    yield Line(f"{name}-sum", equal(symbol(name) * under, over), identity(name))
    yield Line(f"{name}-positive", 0 < symbol(name), proof(positive, using=name))


class Carried(Record):
    """What is carried from state to state, and the numbers of the next state."""

    conditions: Mapping[str, Claim]
    following: Mapping[str, Term]

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

    def givens(self, standing: Mapping[str, Claim]) -> Iterator[Given]:
        """The conditions, and what holds for the inner products of all vectors."""
        yield from (Given(name, claim, "carried") for name, claim in self.conditions.items())
        for name, claim in standing.items():
            yield Given(name, claim, "standing", CAUCHY_SCHWARZ)

    def always(
        self,
        beginning: Mapping[str, Term],
        premises: Iterable[str],
        uses: Iterable[Assumption],
        where: str = "",
    ) -> Line:
        """All conditions hold in every state, by induction."""
        says = "by induction on n all conditions hold after the n-th collision, for every n"
        return Line("always", Always(CONTEXT, beginning, self.following),
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
