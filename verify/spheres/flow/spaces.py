"""Contexts of the flow: their variables, with values at which all that is given holds."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from fractions import Fraction

from verify.language.statement import Context, Given, Variable
from verify.language.terms import Claim, Term, as_term, symbol
from verify.spheres.flow.law import State

#: How people read the numbers of a state and of a flight.
LETTERS = {
    "v": ("v", "v"),
    "lam": ("λ", r"\lambda"),
    "rho": ("ρ", r"\rho"),
    "eps": ("ε", r"\varepsilon"),
    "sig": ("σ", r"\sigma"),
    "A": ("A", "A"),
    "B": ("B", "B"),
    "C": ("C", "C"),
    "a": ("a", "a"),
    "b": ("b", "b"),
    "w": ("w", "w"),
    "y": ("y", "y"),
    "q": ("q", "q"),
    "kap": ("κ", r"\kappa"),
    "s": ("s", "s"),
    "T": ("T", "T"),
    "time": ("t", "t"),
}


def variable(name: str) -> Variable:
    """A variable; what comes before the last dot says where it is used."""
    stem, _, later = name.rpartition(".")[2].partition("_")
    letter, tex = LETTERS.get(stem, (stem, stem))
    if later == "next":
        return Variable(name, f"{letter}'", f"{tex}'")
    return Variable(name, f"{letter}_{later}" if later else letter, f"{tex}_{{{later}}}")


def space(
    name: str,
    says: str,
    point: Mapping[str, int | Fraction | Term],
    givens: Mapping[str, Claim],
    parent: str | None = None,
) -> Context:
    """A context whose variables are those of its point."""
    values = {key: as_term(value) for key, value in point.items()}
    found = tuple(Given(key, claim) for key, claim in givens.items())
    return Context(name, tuple(map(variable, values)), found, values, parent, says)


def state_of(prefix: str, names: Sequence[str] = State._fields) -> State:
    """A state whose numbers are variables."""
    return State(*(symbol(f"{prefix}{name}") for name in names))
