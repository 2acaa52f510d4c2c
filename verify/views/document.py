"""The JSON document of ``theorem1 --json``."""

from __future__ import annotations

from typing import Any

from verify.prover.decimals import outward, rational_text
from verify.prover.ground import REFUTED, Decision, Ends
from verify.paper.groups import HYPOTHESES
from verify.language.statement import Obligation
from verify.language.terms import Term, symbol
from verify.jobs.theorem1 import Outcome
from verify.views.words import entry_ends, least, letters, sentence, verdict_text


def document(outcome: Outcome) -> dict[str, Any]:
    """The outcome as one JSON document; every number is a string."""
    digits = max(40, int(outcome.prover.start_bits * 0.30103) + 3)
    definitions = outcome.prover.definitions
    typesetter = letters(outcome)
    parameters = {
        "r": "r",
        "neg_cos_theta0": "c",
        "delta_theta": "delta_theta",
        "V_0": "V_0",
    }

    def pair(ends: Ends | None) -> list[str] | None:
        return None if ends is None else outward(ends, digits)

    def enclosure(name: str) -> list[str] | None:
        return pair(outcome.prover.enclose(symbol(name)))

    def exact_or_pair(term: Term, name: str) -> Any:
        return rational_text(term.value) if term.op == "rational" else enclosure(name)

    def row(obligation: Obligation, decision: Decision) -> dict[str, Any]:
        entry = {
            "name": obligation.name,
            "label": obligation.label,
            "statement": sentence(obligation, typesetter),
            "role": obligation.role,
            "verdict": decision.verdict,
            "lhs": pair(decision.lhs),
            "rhs": pair(decision.rhs),
        }
        if decision.verdict == REFUTED and obligation.corrected_by:
            entry["corrected_by"] = obligation.corrected_by
        return entry

    def one_set(group: str) -> dict[str, Any]:
        own = [c for c in outcome.statement.constants if c.name.startswith(f"{group}.")]
        return {
            "verdict": outcome.set_verdict(group),
            "constants": {c.short_name: enclosure(c.name) for c in own},
            "minima": {
                c.short_name: {
                    "entries": [pair(ends) for ends in entry_ends(outcome, c)],
                    "minimum": least(outcome, c),
                }
                for c in own
                if c.term.op == "min"
            },
            "obligations": [row(*pair_) for pair_ in outcome.rows[group]],
        }

    shared = [c.name for c in outcome.statement.constants if "." not in c.name]
    found = {name: enclosure(name) for name in ["V_0", *shared]}
    return {
        "command": "theorem1",
        "verdict": verdict_text(outcome),
        "parameters": {
            key: exact_or_pair(definitions[name], name) for key, name in parameters.items()
        },
        "assumptions": [
            {"label": a.label, "statement": a.sentence, "name": a.name} for a in outcome.assumptions
        ],
        "hypotheses": [row(*pair_) for pair_ in outcome.rows[HYPOTHESES]],
        "constants": {name: value for name, value in found.items() if value is not None},
        "sets": {group: one_set(group) for group in outcome.groups if group in outcome.rows},
    }
