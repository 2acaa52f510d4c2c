"""The readable report beside a certificate, for every theorem: in Markdown, and as a page."""

from __future__ import annotations

from collections.abc import Iterator
from typing import Any

from verify.language.statement import (
    NEEDED,
    PRINTED,
    Always,
    Applies,
    Constant,
    Obligation,
    Variable,
)
from verify.language.terms import Claim, Term, symbol
from verify.language.typeset import LONG, Typesetter
from verify.prover.outcome import Decision, Outcome
from verify.publication import REPAIRED, Publication
from verify.views import words
from verify.views.enclosures import exactly, minimum_of
from verify.views.point import in_numbers
from verify.views.typesetting import apart, markdown_template
from verify.views.words import fair as verdict_of


class Texts:
    """Formulas as text; what is longer than a line is left to the statement file."""

    blocks = "markdown.j2"

    def __init__(self, typesetter: Typesetter) -> None:
        self._typesetter = typesetter

    def claim(self, claim: Claim | Applies | Always) -> str:
        """A claim."""
        return _brief(self._typesetter.claim(claim))

    def term(self, term: Term, before: str = "") -> str:
        """A term, after a relation."""
        return f"{before} {_brief(self._typesetter.term(term))}".strip()

    def letter(self, one: Constant | Variable) -> str:
        """The letter of a constant or a variable."""
        return self._typesetter.term(symbol(one.name))


def _brief(text: str) -> str:
    return text if len(text) <= words.MAX_FORMULA else LONG


def report(outcome: Outcome, paper: Publication, *, is_sent: bool = False) -> str:
    """The whole report, ending with a line feed; the checker is beside it where it is sent."""
    texts = Texts(words.letters(outcome))
    told = content(outcome, paper, texts) | {"is_sent": is_sent}
    found: Any = markdown_template("report.j2").make_module(told)
    return apart(str(found.report()))


def content(outcome: Outcome, paper: Publication, write: Any) -> dict[str, Any]:
    """What the template speaks of; ``write`` has its blocks, and writes formulas."""
    outcome = exactly(outcome)
    typesetter, about = words.letters(outcome), words.is_about(outcome, paper)
    main = about and outcome.statement.theorem == paper.theorem

    def evidence(row: Obligation, decision: Decision) -> str:
        """The numbers that show a row, or the values at which it is false."""
        numbers = words.sides_told(row, decision)
        if numbers:
            return numbers
        return f"at {words.values_told(decision.witness, typesetter)}" if decision.witness else ""

    def constants() -> Iterator[tuple[Any, ...]]:
        """Letter, group, value, definition or bound of each constant, and which entry is least."""
        bounds = paper.notes().bounds if main else {}
        for one in outcome.statement.constants:
            group, ends = one.name.rpartition(".")[0], words.ends_of(outcome, one.name)
            sign, bound = bounds.get(one.name, ("=", one))
            least = minimum_of(outcome, one).least if one.term.op == "min" else None
            definition = write.term(bound.term, sign)
            letter, group = (
                write.letter(one),
                "" if typesetter.term(symbol(one.name)) == one.name else group,
            )
            # A scene asks for few enclosures; a number without one need not be undefined.
            value = "" if ends is None else words.ends_told(ends)
            yield letter, group, value, definition, least

    return {
        "blocks": write.blocks,
        "outcome": outcome,
        "about": about,
        "paper": paper,
        "changes": paper.notes().changes if main else (),
        "verdict": words.verdict_text(outcome, paper),
        "numbers": in_numbers(outcome) if REPAIRED in words.groups(outcome) else None,
        "needed": words.counts(outcome, NEEDED),
        "beside": words.counts(outcome, PRINTED),
        "groups": words.groups(outcome),
        "parameters": [
            (write.term(symbol(name)), write.term(value))
            for name, value in words.parameters_of(outcome).items()
        ],
        "constants": list(constants()),
        "printed": paper.printed,
        "claim": write.claim,
        "term": write.term,
        "letter": write.letter,
        "evidence": evidence,
        "short_name": words.short_name,
        "verdict_of": lambda row, found: verdict_of(outcome, row, found),
        "files": {},
        "is_sent": False,
    }
