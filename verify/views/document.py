"""The JSON document of ``theorem1 --json``, and the shape that rows have in every document."""

from __future__ import annotations

from collections.abc import Mapping
from hashlib import sha256
from typing import Any

from verify.language.statement import PRINTED, REFUTED, Assumption, Cite, Constant, Obligation
from verify.language.terms import Claim, Term
from verify.language.typeset import Typesetter
from verify.prover.decimals import DIGITS, decimal_exponent, outward, rational_text
from verify.prover.outcome import Decision, Ends, Outcome
from verify.publication import HYPOTHESES
from verify.views import words
from verify.views.point import in_numbers

FORMAT = "verify-theorem1/1"

#: The names of the parameters in the document, and in the statement.
PARAMETERS = {"r": "r", "neg_cos_theta0": "c", "delta_theta": "delta_theta", "V_0": "V_0"}


def document(outcome: Outcome, as_printed: Mapping[str, str] | None = None) -> dict[str, Any]:
    """The outcome as one JSON document; every number is a string.

    ``as_printed`` has the verdicts on the theorem with its sign, and its set, as printed.
    """
    typesetter = words.letters(outcome)
    names = ["V_0", *(constant.name for constant in words.constants_of(outcome, ""))]
    return {
        "format": FORMAT,
        "command": "theorem1",
        "verdict": words.DOES_NOT_APPLY
        if words.group_fails(outcome, HYPOTHESES)
        else outcome.verdict,
        "headline": words.headline(outcome),
        "parameters": {key: _parameter(outcome, name) for key, name in PARAMETERS.items()},
        "theorem": in_numbers(outcome) or outcome.statement.title,
        "assumptions": [assumption_document(a) for a in outcome.assumptions],
        "assumptions_of_printed_rows": [
            assumption_document(a) for a in outcome.printed_assumptions
        ],
        "cites": [cite_document(cite) for cite in outcome.statement.cites],
        "hypotheses": _rows(outcome, HYPOTHESES, typesetter),
        "constants": {name: pair(words.ends_of(outcome, name)) for name in names},
        "sets": {
            group: _set(outcome, group, typesetter)
            | (dict(as_printed or {}) if group == PRINTED else {})
            for group in words.groups(outcome)
            if group != HYPOTHESES
        },
        "spent": outcome.spent or None,
    }


def claims_document(outcome: Outcome, command: str, form: str) -> dict[str, Any]:
    """A theorem about all values as one JSON document: its rows are its claims."""
    typesetter = words.letters(outcome)
    return {
        "format": form,
        "command": command,
        "verdict": outcome.verdict,
        "headline": words.headline(outcome),
        "theorem": outcome.statement.title,
        "assumptions": [
            assumption_document(a) for a in (*outcome.assumptions, *outcome.printed_assumptions)
        ],
        "claims": [row_document(outcome, row, found, typesetter) for row, found in outcome.rows],
    }


def pair(ends: Ends | None) -> list[str] | None:
    """An enclosure as two decimal texts, outward rounded, and not by much."""
    if ends is None:
        return None
    low, high = ends
    width = high - low
    if width == 0:
        return outward(ends)
    return outward(ends, max(DIGITS, 3 - decimal_exponent(width / max(abs(low), abs(high)))))


def _parameter(outcome: Outcome, name: str) -> str | list[str] | None:
    term = outcome.statement.parameters[name]
    if term.op == "rational":
        return rational_text(term.value)
    return pair(words.ends_of(outcome, name))


def _set(outcome: Outcome, group: str, typesetter: Typesetter) -> dict[str, Any]:
    own = words.constants_of(outcome, group)
    return {
        "verdict": words.group_verdict(outcome, group),
        "constants": {c.short_name: pair(words.ends_of(outcome, c.name)) for c in own},
        "minima": {c.short_name: _minimum(outcome, c) for c in own if c.term.op == "min"},
        "obligations": _rows(outcome, group, typesetter),
    }


def _minimum(outcome: Outcome, constant: Constant) -> dict[str, Any]:
    from verify.views.enclosures import minimum_of  # loads flint

    minimum = minimum_of(outcome, constant)
    return {"entries": [pair(ends) for ends in minimum.entries], "minimum": minimum.least}


def _rows(outcome: Outcome, group: str, typesetter: Typesetter) -> list[dict[str, Any]]:
    rows = outcome.of_group(group)
    return [row_document(outcome, row, decision, typesetter) for row, decision in rows]


def row_document(
    outcome: Outcome, row: Obligation, decision: Decision, typesetter: Typesetter
) -> dict[str, Any]:
    """A row in the one shape that rows have; its ``statement`` says and claims it in one line.

    A row whose claim is false has the key ``corrected_by``; one without variables has ``lhs`` and
    ``rhs``; one with an example at which it is false has it as ``witness``.
    """
    found: dict[str, Any] = {
        "name": row.name,
        "group": row.group,
        "label": row.label,
        "role": row.role,
        "severity": row.severity if decision.verdict == REFUTED else None,
        "says": row.says,
        "claim": typesetter.claim(row.claim),
        "statement": words.sentence(row, typesetter),
        "verdict": words.fair(outcome, row, decision),
        "judged_by": decision.judge,
        "method": decision.method or None,
        "bits": decision.bits,
        "uses": list(row.uses),
    }
    if decision.verdict == REFUTED:
        found["corrected_by"] = row.corrected_by
    if row.context is None and isinstance(row.claim, Claim):
        sides = words.sides_of(row, decision)
        found["lhs"], found["rhs"] = (None, None) if sides is None else map(pair, sides)
    if decision.witness:
        values = words.witness_of(row, decision)
        found["witness"] = {name: value_text(term, typesetter) for name, term in values.items()}
    return found


def value_text(term: Term, typesetter: Typesetter) -> str:
    """A rational as ``p/q``, another value as a formula."""
    return rational_text(term.value) if term.op == "rational" else typesetter.term(term)


def cite_document(cite: Cite) -> dict[str, str]:
    """A cited statement as the file of a statement names it."""
    return {
        "name": cite.name,
        "theorem": cite.theorem,
        "statement_sha256": sha256(cite.content).hexdigest(),
    }


def assumption_document(assumption: Assumption) -> dict[str, str]:
    """An assumption: its name and label, its kind, and the sentence."""
    return {
        "name": assumption.name,
        "label": assumption.label,
        "kind": assumption.kind,
        "statement": assumption.sentence,
    }
