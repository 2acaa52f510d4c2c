"""What ``verify explain`` prints: a row with its proof, a formula, a constant of Theorem 1."""

from __future__ import annotations

from collections.abc import Iterator, Mapping
from typing import Any

from verify.language.fold import negation
from verify.language.statement import (
    NEEDED,
    PRINTED,
    PROVED,
    REFUTED,
    UNDECIDED,
    Constant,
    Obligation,
)
from verify.language.terms import Claim, names_of, symbol
from verify.language.typeset import Typesetter
from verify.prover.outcome import Decision, Outcome
from verify.prover.proof import Premise, Shape, shapes
from verify.prover.rules import RULES, Sum, Witness, rule_of
from verify.prover.uses import Node, nodes
from verify.publication import OTHERWISE, REMARK, REPAIRED, Publication
from verify.views.enclosures import exactly
from verify.views.point import parameters_told
from verify.views.row_lists import plain_letters
from verify.views.words import (
    ends_of,
    ends_told,
    fair,
    letters,
    short_name,
    sides_named,
    sides_of,
    sides_told,
)

Row = tuple[Obligation, Decision]


def explain(
    outcome: Outcome,
    name: str,
    paper: Publication,
    *,
    exact: bool = False,
    has_proof: bool = True,
) -> list[str]:
    """The lines about a row or a lemma of what the checker has accepted; none without such a name.

    A row is found by its name, with or without its group. Claims are simplified if not ``exact``.
    Without ``has_proof`` only what is claimed, and the verdict.
    """
    found, outcome = nodes(outcome), exactly(outcome)
    rows = {row.name: (row, decision) for row, decision in outcome.rows}
    full = [row.name for row, _ in rows.values() if name in (row.name, short_name(row))]
    typesetter = letters(outcome) if exact else plain_letters(outcome)
    text: list[str] = []
    for key in full or ([name] if name in found else []):
        if key in found:
            text += _claimed(found[key], rows, typesetter, paper)
            text += _proved(found[key], rows, found, typesetter, paper) if has_proof else []
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
    yield f"{decision.verdict}: obligation {row.name}"
    yield from _said(row, paper)
    yield "  there is no proof"
    yield f"  {typesetter.claim(row.claim)}"


def _claimed(
    node: Node, rows: Mapping[str, Row], typesetter: Typesetter, paper: Publication
) -> Iterator[str]:
    row = rows.get(node.name)
    where = "" if node.context is None else f", for all values of the context {node.context}"
    verdict = "" if row is None else f"{row[1].verdict}: "
    yield f"{verdict}{node.kind} {node.name}{where}"
    if row is not None:
        yield from _said(row[0], paper)
        what = "what is written here" if row[1].verdict == PROVED else "the proof of the opposite"
        yield f"  by the rule {row[1].method}: {what} was accepted by {row[1].judge}"
    elif node.proof is not None:
        yield f"  by the rule {rule_of(node.proof)}"
    yield f"  {typesetter.claim(node.claim)}"
    if row is not None:
        sides = sides_of(*row)
        if sides is not None:
            yield f"  {sides_named(*sides)}"


def _proved(
    node: Node,
    rows: Mapping[str, Row],
    found: dict[str, Node],
    typesetter: Typesetter,
    paper: Publication,
) -> Iterator[str]:
    row, proved = rows.get(node.name), node.claim
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
        texts = ((name, _field(shape.of[0], item, typesetter)) for name, item in value.items())
        return ", ".join(f"{typesetter.term(symbol(name))} = {text}" for name, text in texts)
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


# --- what a formula or a constant comes to -------------------------------------------------------

#: What rows of the paper are called by the verdict on them, where it is worth a line each.
KINDS = {
    REFUTED: "printed, and refuted",
    OTHERWISE: "printed and true, but not by the printed argument",
    REMARK: "false, but the text does not claim it",
    UNDECIDED: "printed, and undecided",
}


def about_label(outcome: Outcome, label: str, paper: Publication) -> list[str]:
    """What stands at a label: what is false there, what is true, and who uses it."""
    rows = [pair for pair in outcome.rows if pair[0].label == label]
    if not rows:
        return []
    text = [f"{paper.cited(label)}{_place(outcome)}", f"  {_verdict(outcome, rows)}"]
    for verdict, title in KINDS.items():
        for row, found in rows:
            if row.role == PRINTED and fair(outcome, row, found) == verdict:
                text += _false(outcome, row, found, title, paper)
    held = [row for row, d in rows if row.role == PRINTED and d.verdict == PROVED]
    true = [row for row, d in rows if row.role == NEEDED and d.verdict == PROVED]
    text += _named("printed, and proved", held) + _named("needed, and proved", true)
    return text + _named_names("used by", _users(outcome, {row.name for row, _ in rows}))


def _place(outcome: Outcome) -> str:
    return f", at {parameters_told(outcome)}" if outcome.statement.parameters else ""


def _verdict(outcome: Outcome, rows: list[Row]) -> str:
    """In a line: how many of the printed rows there are false, and whether what is needed holds."""
    printed = [fair(outcome, row, d) for row, d in rows if row.role == PRINTED]
    needed = [d.verdict for row, d in rows if row.role == NEEDED]
    parts = []
    if printed:
        parts.append(f"printed: {printed.count(REFUTED)} of {len(printed)} rows refuted")
    if needed:
        parts.append(f"needed: {needed.count(PROVED)} of {len(needed)} rows proved")
    return "; ".join(parts)


def _false(
    outcome: Outcome, row: Obligation, found: Decision, title: str, paper: Publication
) -> Iterator[str]:
    told = paper.severity(row) if fair(outcome, row, found) == REFUTED else ""
    severity = f" ({told})" if told else ""
    yield f"  {title}{severity}: {short_name(row)}: {row.says}"
    yield f"    {letters(outcome).claim(row.claim)}"
    yield from _numbers(row, found)
    better = next((p for p in outcome.rows if p[0].name == row.corrected_by), None)
    if better is not None:
        yield f"    {better[1].verdict} in its place: {better[0].name}: {better[0].says}"
        yield from _numbers(*better)


def _numbers(row: Obligation, found: Decision) -> Iterator[str]:
    numbers = sides_told(row, found)
    if numbers:
        yield f"    {numbers}"


def _named(title: str, rows: list[Obligation]) -> list[str]:
    return _named_names(title, [row.name for row in rows])


def _named_names(title: str, names: list[str]) -> list[str]:
    return [f"  {title}: {', '.join(names)}"] if names else []


def _users(outcome: Outcome, names: set[str]) -> list[str]:
    """What is proved from one of these facts."""
    return [node.name for node in nodes(outcome).values() if names & set(node.uses)]


def about_constant(outcome: Outcome, word: str, paper: Publication) -> list[str]:
    """A constant of Theorem 1 by its name or letter: as printed, repaired, and who uses it."""
    found = [c for c in outcome.statement.constants if word in (c.name, c.short_name, c.letter)]
    if not found:
        return []
    bounds = paper.notes().bounds
    text = [f"{found[0].letter}, {paper.cited(found[0].label)}{_place(outcome)}"]
    for constant in found:
        sign, bound = bounds.get(constant.name, ("=", constant))
        what = "repaired" if constant.name.startswith(f"{REPAIRED}.") else "as printed"
        text.append(f"  {what}: {constant.letter} = {ends_told(ends_of(outcome, constant.name))}")
        text.append(f"    {bound.letter} {sign} {letters(outcome).term(bound.term)}")
    text += _doubts(outcome, found)
    names = {constant.name for constant in found}
    users = [short_name(row) for row, _ in outcome.rows if names & _names(row)]
    text += _named_names("used by the rows", list(dict.fromkeys(users)))
    if any(constant.name.startswith(f"{PRINTED}.") for constant in found):
        text.append(
            "  the set with the printed constants does what the theorem claims: "
            "certificates/printed-set"
        )
    return text


def _doubts(outcome: Outcome, constants: list[Constant]) -> list[str]:
    """What is false of the printed constant, as far as rows about it say; else that nothing is."""
    own = {constant.name for constant in constants if not constant.name.startswith(REPAIRED)}
    rows = [p for p in outcome.rows if fair(outcome, *p) == REFUTED and own & _names(p[0])]
    names = [f"{short_name(row)} ({row.severity})" for row, _ in rows]
    return _named_names("printed rows about it that are false", names)


def _names(row: Obligation) -> set[str]:
    claim = row.claim
    return set(names_of(claim.lhs, claim.rhs)) if isinstance(claim, Claim) else set()
