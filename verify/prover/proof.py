"""What every proof has, and the steps of a certificate. Nothing here is trusted.

There is one class of proofs for each rule of the kernel, in `verify.prover.rules`. The annotation
of a field says what it holds: by it proofs are written, read and searched for the facts they use.
"""

from __future__ import annotations

import sys
from collections.abc import Callable, Iterable, Iterator, Mapping
from fractions import Fraction
from functools import cache

from verify.language.record import Annotated, Any, Record
from verify.language.terms import MAX_EXPONENT, Claim, Term

#: A number that is >= 0 for all values in scope: a rational or the name of a fact as a text,
#: "goal", or a tuple: ("add" | "mul", value, …), ("pow", value, exponent), ("square" | "root",
#: term).
Value = Annotated[str | tuple[object, ...], "value"]


def product_of(*values: Value) -> Value:
    """The product of values, without factors 1."""
    kept = [value for value in values if value != "1"]
    return kept[0] if len(kept) == 1 else ("mul", *kept) if kept else "1"


def sum_of(*values: Value) -> Value:
    """The sum of values, of which there is one at least."""
    return values[0] if len(values) == 1 else ("add", *values)


def power_of(value: Value, exponent: int) -> Value:
    """The power of a value; a large one is a product of powers."""
    if exponent > MAX_EXPONENT:
        half = power_of(value, exponent // 2)
        return product_of(("pow", half, 2), *([value] if exponent % 2 else []))
    return value if exponent == 1 else ("pow", value, exponent)


def every(proofs: Iterable[Proof | None]) -> tuple[Proof, ...] | None:
    """All proofs; None as soon as one is missing."""
    found: list[Proof] = []
    for proof in proofs:
        if proof is None:
            return None
        found.append(proof)
    return tuple(found)


#: What the fields of proofs hold; the text is the name in the JSON schema.
Bits = Annotated[int, "bits"]
Fact = Annotated[str, "reference"]
Name = Annotated[str, "context_name"]
Side = Annotated[str, ("lhs", "rhs")]
_NAMED = {Term: "term", Claim: "claim", Fraction: "number"}

#: A proof of a claim by one rule: a value of one of the classes in `verify.prover.rules`.
Proof = Annotated[tuple[Any, ...], "proof"]

#: What shows that a given holds: the name of a fact, or a proof.
Premise = Annotated[str | Proof, "premise"]


class Shape(Record):
    """What a field holds, read off from its annotation.

    ``form`` is "leaf", whose name is in ``of``; "choice" of the texts in ``of``; "optional",
    "list" or "table" of the one shape in ``of``; or "row" of its shapes. A list has ``least``
    entries or more.
    """

    form: str
    of: tuple[Any, ...]
    least: int = 0


@cache
def shapes(proofs: Any) -> Mapping[str, Shape]:
    """The shapes of the fields of a class of proofs."""
    known, hints = vars(sys.modules[proofs.__module__]), proofs.__annotations__
    return {field: _shape(eval(hints[field], known)) for field in proofs._fields}  # noqa: S307


def leaf_names(proof: Proof) -> frozenset[str]:
    """The names of the leaves that proofs by the same rule may have."""
    return _leaf_names_of(type(proof))


@cache
def _leaf_names_of(proofs: Any) -> frozenset[str]:
    return frozenset(name for shape in shapes(proofs).values() for name in _leaf_names(shape))


def _leaf_names(shape: Shape) -> Iterator[str]:
    if shape.form == "leaf":
        yield shape.of[0]
    elif shape.form != "choice":
        for inner in shape.of:
            yield from _leaf_names(inner)


def _shape(hint: Any) -> Shape:
    if hint in _NAMED:
        return Shape("leaf", (_NAMED[hint],))
    origin, (first, *others) = getattr(hint, "__origin__", None), hint.__args__
    if origin is Annotated:
        (told,) = others
        if isinstance(told, int):
            return _shape(first)._replace(least=told)
        return Shape("choice", told) if isinstance(told, tuple) else Shape("leaf", (told,))
    if origin is Mapping:
        return Shape("table", (_shape(others[0]),))
    if type(None) in others:
        return Shape("optional", (_shape(first),))
    if others == [...]:
        return Shape("list", (_shape(first),))
    return Shape("row", tuple(map(_shape, hint.__args__)))


def leaves(proof: Proof) -> Iterator[tuple[str, Any]]:
    """What is in the fields of a proof, each with the name of its leaf, in order."""
    for field, shape in shapes(type(proof)).items():
        yield from _leaves(shape, getattr(proof, field))


def _leaves(shape: Shape, value: Any) -> Iterator[tuple[str, Any]]:
    if shape.form == "leaf":
        yield shape.of[0], value
    elif shape.form == "row":
        for inner, item in zip(shape.of, value, strict=True):
            yield from _leaves(inner, item)
    elif value is not None and shape.form != "choice":
        items = value.values() if shape.form == "table" else value
        for item in (value,) if shape.form == "optional" else items:
            yield from _leaves(shape.of[0], item)


def mapped(proof: Any, leaf: Callable[[str, Any], Any]) -> dict[str, Any]:
    """The fields of a proof with other leaves; lists and rows become tuples."""
    return made_of(type(proof), proof._asdict(), leaf)


def made_of(
    proofs: Any, values: Mapping[str, Any], leaf: Callable[[str, Any], Any]
) -> dict[str, Any]:
    """The fields of a class of proofs from values with other leaves."""
    return {name: _mapped(shape, values[name], leaf) for name, shape in shapes(proofs).items()}


def _mapped(shape: Shape, value: Any, leaf: Callable[[str, Any], Any]) -> Any:
    if shape.form == "leaf":
        return leaf(shape.of[0], value)
    if shape.form == "choice" or value is None:
        return value
    if shape.form == "row":
        pairs = zip(shape.of, value, strict=True)
        return tuple(_mapped(inner, item, leaf) for inner, item in pairs)
    (inner,) = shape.of
    if shape.form == "optional":
        return _mapped(inner, value, leaf)
    if shape.form == "table":
        return {name: _mapped(inner, item, leaf) for name, item in value.items()}
    return tuple(_mapped(inner, item, leaf) for item in value)


class ConstantStep(Record):
    """The definition of a constant of the statement has a value."""

    name: str
    proof: Proof


class DefinitionStep(Record):
    """A name that the certificate introduces for a term."""

    name: str
    context: str | None
    term: Term
    proof: Proof


class LemmaStep(Record):
    """A claim that the certificate proves on the way."""

    name: str
    context: str | None
    claim: Claim
    proof: Proof


class ObligationStep(Record):
    """An obligation of the statement, or its negation."""

    name: str
    proof: Proof


class OpenStep(Record):
    """The givens of a context hold at its point."""

    name: str
    givens: tuple[Premise, ...]


Step = ConstantStep | DefinitionStep | LemmaStep | ObligationStep | OpenStep
