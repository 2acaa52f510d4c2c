"""The rule *sum*: the negation of the claim would make a positive number zero."""

from __future__ import annotations

from verify.language.record import Record
from verify.language.terms import Term
from verify.prover.proof import Kind, Kinds, Value


class Sum(Record):
    """Addends that are >= 0, multiples of equations, and the equations that replace atoms."""

    addends: tuple[Value, ...] = ()
    using: tuple[str, ...] = ()
    equations: tuple[tuple[str, Term], ...] = ()


KINDS: Kinds = {
    "addends": Kind.VALUES,
    "using": Kind.PLAIN,
    "equations": Kind.COFACTORS,
}
