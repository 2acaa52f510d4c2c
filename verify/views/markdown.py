"""The readable report beside a certificate, in Markdown, for every theorem."""

from __future__ import annotations

from collections.abc import Iterator
from typing import Any

from verify.language.statement import Always, Applies, Obligation
from verify.language.terms import Claim, symbol
from verify.language.typeset import LONG
from verify.prover.outcome import Decision, Outcome
from verify.publication import REPAIRED, Publication
from verify.views import words
from verify.views.enclosures import exactly, minimum_of
from verify.views.point import in_numbers
from verify.views.typesetting import apart, markdown_template
from verify.views.words import fair as verdict_of


def report(outcome: Outcome, paper: Publication) -> str:
    """The whole report, ending with a line feed."""
    return apart(markdown_template("report.j2").render(_content(outcome, paper)))


def defects(outcome: Outcome, paper: Publication) -> str:
    """The table of the refuted printed rows, in the paper's order."""
    module: Any = markdown_template("report.j2").make_module(_content(outcome, paper))
    return str(module.defects()).strip()


def _content(outcome: Outcome, paper: Publication) -> dict[str, Any]:
    """What the template speaks of."""
    outcome = exactly(outcome)
    typesetter, about = words.letters(outcome), words.is_about(outcome, paper)
    main = about and outcome.statement.theorem == paper.theorem

    def brief(text: str) -> str:
        return text if len(text) <= words.MAX_FORMULA else LONG

    def claim(one: Claim | Applies | Always) -> str:
        return brief(typesetter.claim(one))

    def told(row: Obligation) -> str:
        """The claim; in a theorem of somebody else's also for all values of which context."""
        where = "" if about or row.context is None else f" for all values of `{row.context}`"
        return claim(row.claim) + where

    def evidence(row: Obligation, decision: Decision) -> str:
        """The numbers that show a row, or the values at which it is false."""
        numbers = words.sides_told(row, decision)
        if numbers:
            return numbers
        return f"at {words.values_told(decision.witness, typesetter)}" if decision.witness else ""

    def constants() -> Iterator[tuple[str, ...]]:
        """Letter, value, and definition or bound of each constant."""
        bounds = paper.notes().bounds if main else {}
        for one in outcome.statement.constants:
            group, ends = one.name.rpartition(".")[0], words.ends_of(outcome, one.name)
            sign, bound = bounds.get(one.name, ("=", one))
            least = minimum_of(outcome, one).least if one.term.op == "min" else None
            told = "" if least is None else f" (entry {least} is the least)"
            letter = typesetter.term(symbol(one.name))
            letter += f" ({group})" if group and letter != one.name else ""
            yield letter, words.ends_told(ends), f"{sign} {typesetter.term(bound.term)}{told}"

    return {
        "outcome": outcome,
        "about": about,
        "paper": paper,
        "changes": paper.notes().changes if main else (),
        "verdict": words.verdict_text(outcome, paper),
        "numbers": in_numbers(outcome) if REPAIRED in words.groups(outcome) else None,
        "groups": words.groups(outcome),
        "constants": list(constants()),
        "printed": paper.printed,
        "claim": claim,
        "told": told,
        "symbol": symbol,
        "term": lambda one: brief(typesetter.term(one)),
        "evidence": evidence,
        "short_name": words.short_name,
        "verdict_of": lambda row, found: verdict_of(outcome, row, found),
    }
