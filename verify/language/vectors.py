"""Vectors as formal combinations of some that have names, in any dimension."""

from __future__ import annotations

from collections.abc import Mapping

from verify.language.terms import Number, Term, as_term

Combination = Mapping[str, Term]


def scale(number: Number, x: Combination) -> Combination:
    """A multiple of a vector."""
    return {name: _times(as_term(number), value) for name, value in x.items()}


def add(x: Combination, z: Combination) -> Combination:
    """The sum of two vectors."""
    total = dict(x)
    for name, value in z.items():
        total[name] = total[name] + value if name in total else value
    return total


def _times(x: Term, z: Term) -> Term:
    one = as_term(1)
    return z if x is one else x if z is one else x * z
