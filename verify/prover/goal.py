"""What a search gets: a claim, its context, and the facts that bound its variables."""

from __future__ import annotations

from collections.abc import Iterable, Iterator, Mapping
from fractions import Fraction

from verify.language.record import Record
from verify.language.statement import Context, Given
from verify.language.terms import Claim, Term, names_of
from verify.prover.program import Program


class Bounds(Record):
    """The numbers between which a variable lies, and the facts that say so, with their relation."""

    low: Fraction | None = None
    high: Fraction | None = None
    low_fact: str = ""
    high_fact: str = ""
    low_relation: str = "<"
    high_relation: str = "<"

    @property
    def ends(self) -> tuple[Fraction, Fraction] | None:
        """Both numbers, if there are both."""
        return None if self.low is None or self.high is None else (self.low, self.high)

    @property
    def interval(self) -> tuple[Fraction, Fraction] | None:
        """Both numbers, if they are different, and facts say that they are bounds.

        Polynomials are written with the distances from both, over the distance between the two;
        an equation is no number >= 0.
        """
        if self.low is None or self.high is None or self.low >= self.high:
            return None
        return None if "=" in (self.low_relation, self.high_relation) else (self.low, self.high)


class Goal(Record):
    """A claim that is to be proved for all values in a context.

    ``variables`` has the bounds of the variables that occur in it, ``definitions`` the terms of
    names that stand for terms with variables, each after those in it, ``constants`` the other
    names.
    """

    claim: Claim
    context: str | None
    variables: Mapping[str, Bounds]
    constants: tuple[str, ...]
    definitions: Mapping[str, Term]

    def program(self) -> tuple[Program, tuple[int, int]]:
        """A program whose inputs are variables and constants, and the slots of the two sides."""
        program = Program((*self.variables, *self.constants))
        for name, term in self.definitions.items():
            program.define(name, term)
        return program, (program.add(self.claim.lhs), program.add(self.claim.rhs))

    @property
    def box(self) -> dict[str, tuple[Fraction, Fraction]] | None:
        """The ends of all variables, if all are bounded."""
        box = {name: bounds.ends for name, bounds in self.variables.items()}
        return {name: ends for name, ends in box.items() if ends} if all(box.values()) else None


def definitions_below(names: Iterable[str], definitions: Mapping[str, Term]) -> dict[str, Term]:
    """The definitions of names, and of those in them, in the order in which they were made."""
    wanted = {*names}
    for name in reversed([*definitions]):
        if name in wanted:
            wanted.update(names_of(definitions[name]))
    return {name: term for name, term in definitions.items() if name in wanted}


def bounds_of(context: Context, others: Iterable[Given] = ()) -> dict[str, Bounds]:
    """For each variable of a context the best bounds by numbers among its givens, and others."""
    found = {variable.name: Bounds() for variable in context.variables}
    for given in (*context.givens, *others):
        for name, bounds in _bounds(given):
            if name in found:
                found[name] = _narrowed(found[name], bounds)
    return found


def narrowed(bounds: Bounds, name: str, given: Given) -> Bounds:
    """The bounds of a variable with what a given says of it, if that is a better one."""
    for variable, other in _bounds(given):
        if variable == name:
            bounds = _narrowed(bounds, other)
    return bounds


def _bounds(given: Given) -> Iterator[tuple[str, Bounds]]:
    relation, lhs, rhs = given.claim.key
    fact, is_equation = given.name, relation == "="
    for number, variable, is_low in ((lhs, rhs, True), (rhs, lhs, False)):
        if number.op == "rational" and variable.op == "symbol":
            if is_low or is_equation:
                yield variable.name, Bounds(low=number.value, low_fact=fact, low_relation=relation)
            if is_equation or not is_low:
                high = Bounds(high=number.value, high_fact=fact, high_relation=relation)
                yield variable.name, high


def _narrowed(old: Bounds, new: Bounds) -> Bounds:
    """The better bounds of two; of equal ones those that are strict."""
    if new.low is not None and (
        old.low is None or (old.low, old.low_relation == "<") < (new.low, new.low_relation == "<")
    ):
        old = old._replace(low=new.low, low_fact=new.low_fact, low_relation=new.low_relation)
    if new.high is not None and (
        old.high is None
        or (new.high, new.high_relation != "<") < (old.high, old.high_relation != "<")
    ):
        old = old._replace(high=new.high, high_fact=new.high_fact, high_relation=new.high_relation)
    return old
