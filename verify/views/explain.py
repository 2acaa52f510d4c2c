"""One row with the facts that its proof uses and the identity that proves it, to check by hand."""

from __future__ import annotations

from collections.abc import Iterator, Mapping
from typing import Any

from verify.language.statement import PROVED, REFUTED, Obligation, Publication
from verify.language.terms import Claim
from verify.language.typeset import Typesetter
from verify.prover.decimals import short
from verify.prover.outcome import Decision, Outcome
from verify.prover.proof import Premise, Shape, shapes
from verify.prover.relations import negation
from verify.prover.rules import RULES, Sum, Witness, rule_of
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
        yield from (f"  {line}" for line in _proof(node.proof, typesetter))
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


def _proof(proof: Premise, typesetter: Typesetter) -> Iterator[str]:
    """The proof in words, with those of its proofs that its rule shows."""
    if isinstance(proof, str):
        yield f"it is {proof}"
        return
    if isinstance(proof, Sum):
        yield from _sum(proof, typesetter)
        return
    rule = RULES[type(proof)]
    fields = {
        name: _field(shape, getattr(proof, name), typesetter)
        for name, shape in shapes(type(proof)).items()
    }
    yield from rule.says.format_map(fields).splitlines()
    if rule.shown:
        field, called = rule.shown
        parts = getattr(proof, field)
        many = shapes(type(proof))[field].form != "leaf"
        for i, part in enumerate(parts if many else (parts,), 1):
            name = f"{called} {i}" if many else called
            yield from (f"  {name}: {line}" for line in _proof(part, typesetter))


def _field(shape: Shape, value: Any, typesetter: Typesetter) -> str:
    """A field within a sentence; a list of proofs counts them."""
    if shape.form == "table":
        return ", ".join(f"{name} = {typesetter.term(term)}" for name, term in value.items())
    if shape.form in ("list", "row"):
        return str(len(value))
    if shape.of == ("claim",):
        return typesetter.claim(value)
    return typesetter.term(value) if shape.of == ("term",) else str(value)


def _sum(proof: Sum, typesetter: Typesetter) -> Iterator[str]:
    if proof.using:
        yield f"after replacing what these equations define: {', '.join(proof.using)}"
    parts = [_value(addend, typesetter) for addend in proof.addends]
    parts += [f"({typesetter.term(term)})·[{name}]" for name, term in proof.equations]
    if proof.addends:
        yield "if it failed, goal = (left - right), cleared of fractions, is > 0 (≥ 0 for <), and"
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
