"""One row with the facts that its proof uses and the identity that proves it, to check by hand."""

from __future__ import annotations

from collections.abc import Iterator, Mapping
from typing import Any

from verify.language.statement import PROVED, REFUTED, Obligation, Publication
from verify.language.terms import Claim
from verify.language.typeset import Typesetter
from verify.prover.decimals import short
from verify.prover.outcome import Decision, Outcome
from verify.prover.proof import Premise, Proof
from verify.prover.relations import negation
from verify.prover.rules import (
    Antisymmetry,
    Applying,
    Cases,
    Cuts,
    Derivative,
    Entry,
    Have,
    Induction,
    InRange,
    Instance,
    Interval,
    Law,
    Least,
    MeanValue,
    Monotony,
    Root,
    Sum,
    Witness,
    rule_of,
)
from verify.prover.uses import Node, nodes
from verify.views.plain import plain_letters
from verify.views.words import letters, short_name, sides_of

Row = tuple[Obligation, Decision]


def explain(outcome: Outcome, name: str, paper: Publication, *, exact: bool = False) -> list[str]:
    """The lines about a row or a lemma of what the checker has accepted; none without such a name.

    A row is found by its name, with or without its group. Claims are simplified if not ``exact``.
    """
    found = nodes(outcome)
    rows = {row.name: (row, decision) for row, decision in outcome.rows}
    full = [row.name for row, _ in rows.values() if name in (row.name, short_name(row))]
    typesetter = letters(outcome) if exact else plain_letters(outcome)
    text: list[str] = []
    for key in full or ([name] if name in found else []):
        if key in found:
            text += _about(found[key], rows, found, typesetter, paper)
        else:
            text += _undecided(*rows[key], typesetter, paper)
    return text


def labelled(outcome: Outcome, label: str) -> list[str]:
    """A line for each row of a label."""
    return [
        f"{decision.verdict:<9} {row.name}: {row.says}{_by(decision)}"
        for row, decision in outcome.rows
        if row.label == label
    ]


def _by(decision: Decision) -> str:
    return f" (by the rule {decision.method})" if decision.method else ""


def _said(row: Obligation, paper: Publication) -> Iterator[str]:
    """What the text says, after its label and the number that is printed there."""
    text = ": ".join(part for part in (paper.cited(row.label), row.says) if part)
    if text:
        yield f"  {text}"


def _undecided(
    row: Obligation, decision: Decision, typesetter: Typesetter, paper: Publication
) -> Iterator[str]:
    yield f"obligation {row.name}"
    yield from _said(row, paper)
    yield f"  {decision.verdict}, so that there is no proof"
    yield f"  {typesetter.claim(row.claim)}"


def _about(
    node: Node,
    rows: Mapping[str, Row],
    found: dict[str, Node],
    typesetter: Typesetter,
    paper: Publication,
) -> Iterator[str]:
    row = rows.get(node.name)
    where = "" if node.context is None else f", for all values of the context {node.context}"
    yield f"{node.kind} {node.name}{where}"
    if row is not None:
        yield from _said(row[0], paper)
        what = "what is written here" if row[1].verdict == PROVED else "the proof of the opposite"
        by = f"{row[1].verdict} by the rule {row[1].method}"
        yield f"  {by}: {what} is accepted by {row[1].judge}"
    elif node.proof is not None:
        yield f"  by the rule {rule_of(node.proof)}"
    yield f"  {typesetter.claim(node.claim)}"
    if row is not None:
        sides = sides_of(*row)
        if sides is not None:
            yield f"  left side {short(sides[0])}, right side {short(sides[1])}"
    proved = node.claim
    if row is not None and row[1].verdict == REFUTED and not isinstance(node.proof, Witness):
        opposite = negation(proved) if isinstance(proved, Claim) else None
        if opposite is not None:
            proved = opposite
            yield f"  what is proved is the opposite: {typesetter.claim(proved)}"
    if node.proof is not None:
        sign = ">" if isinstance(proved, Claim) and proved.relation == "<=" else "≥"
        yield from (f"  {line}" for line in _proof(node.proof, sign, typesetter))
    if node.uses:
        yield "  where"
    for name in node.uses:
        used = found.get(name)
        claim = "a fact of a cited statement" if used is None else typesetter.claim(used.claim)
        kind = "" if used is None else f"   ({_kind(used, rows, paper)})"
        yield f"    {name}: {claim}{kind}"


def _kind(node: Node, rows: Mapping[str, Row], paper: Publication) -> str:
    """What a fact is, and for a row of the paper where the paper has it."""
    label = rows[node.name][0].label if node.name in rows else ""
    return f"{node.kind}, {paper.number(label)}" if label else node.kind


def _proof(  # noqa: C901  one case a rule
    proof: Proof, sign: str, typesetter: Typesetter
) -> Iterator[str]:
    """The proof in words; ``sign`` says how the difference of the sides compares to 0 in a sum."""
    match proof:
        case Interval(bits=bits):
            yield f"by enclosures of both sides with {bits} bits"
        case MeanValue(bits=bits, at=at):
            values = ", ".join(f"{key} = {typesetter.term(term)}" for key, term in at.items())
            yield f"by enclosures with {bits} bits: right - left at {values},"
            yield "and for each of these variables its derivative on the box, times the distance"
        case Sum():
            yield from _sum(proof, sign, typesetter)
        case Entry():
            yield "a minimum is at most each of its entries (a maximum at least)"
        case Root():
            yield "the root of a positive number is positive"
        case Cases(of=term, branches=branches) | Cuts(term=term, branches=branches):
            yield f"in {len(branches)} cases, for {typesetter.term(term)}"
            for i, branch in enumerate(branches, 1):
                yield from (f"  case {i}: {line}" for line in _proof(branch, sign, typesetter))
        case Least(branches=branches):
            yield f"for each of {len(branches)} entries"
            for i, branch in enumerate(branches, 1):
                yield from (f"  entry {i}: {line}" for line in _proof(branch, sign, typesetter))
        case Antisymmetry(branches=branches):
            yield "each side is at most the other"
            for i, branch in enumerate(branches, 1):
                yield from (f"  order {i}: {line}" for line in _proof(branch, ">", typesetter))
        case Instance(of=name, at=at):
            values = ", ".join(f"{key} = {typesetter.term(term)}" for key, term in at.items())
            yield f"{name} at {values}"
        case Applying(givens=givens):
            yield f"each of the {len(givens)} givens holds"
        case Have(claim=claim, branches=(first, then)):
            yield f"at first: {typesetter.claim(claim)}"
            yield from (f"  {line}" for line in _premise(first, ">", typesetter))
            yield from _proof(then, sign, typesetter)
        case Derivative(variable=name, at=at, term=term, side=side, sign=why):
            where = f"{typesetter.term(at)} {'≤' if side == 'above' else '≥'} {name}"
            yield f"it holds at {name} = {typesetter.term(at)}, and for {where}"
            yield f"the derivative of right - left is {'≥' if side == 'above' else '≤'} 0:"
            yield f"  {typesetter.term(term)}"
            yield from (f"  {line}" for line in _premise(why, ">", typesetter))
        case Monotony(under=None):
            yield "the function rises"
        case Monotony(under=function):
            yield f"{function} rises, so it is enough that {function} of both sides compare so"
        case InRange():
            yield "no value of the function is outside its range"
        case Law():
            yield "this holds identically"
        case Induction():
            yield "by induction: each carried given holds at the start, and at the next state"
        case Witness(at=at):
            values = ", ".join(f"{key} = {typesetter.term(term)}" for key, term in at.items())
            yield f"false at {values}"
        case _:
            yield f"by the rule {rule_of(proof)}"


def _premise(premise: Premise, sign: str, typesetter: Typesetter) -> Iterator[str]:
    if isinstance(premise, str):
        yield f"it is {premise}"
    else:
        yield from _proof(premise, sign, typesetter)


def _sum(proof: Sum, sign: str, typesetter: Typesetter) -> Iterator[str]:
    if proof.using:
        yield f"after replacing what these equations define: {', '.join(proof.using)}"
    parts = [_value(addend, typesetter) for addend in proof.addends]
    parts += [f"({typesetter.term(term)})·[{name}]" for name, term in proof.equations]
    if proof.addends:
        yield f"if it failed, goal = (left - right), cleared of fractions, would be {sign} 0, and"
        yield f"  {' + '.join(parts)} = 0"
        yield "identically, with a positive addend (a name is the difference of its sides)"
    else:
        yield f"left - right = {' + '.join(parts) or '0'} identically, cleared of fractions"


def _value(value: Any, typesetter: Typesetter) -> str:
    if isinstance(value, str):
        return value if value[0].isdigit() or value == "goal" else f"[{value}]"
    op, *rest = value
    if op == "square":
        return f"({typesetter.term(rest[0])})²"
    if op == "root":
        return typesetter.term(rest[0])
    if op == "pow":
        return f"{_value(rest[0], typesetter)}^{rest[1]}"
    parts = [_value(item, typesetter) for item in rest]
    if op == "mul" and len(parts) > 1 and parts[0] == "1":
        parts = parts[1:]
    inner = (" + " if op == "add" else "·").join(parts)
    return f"({inner})" if op == "add" else inner
