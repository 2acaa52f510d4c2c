"""What the table and the document of `theorem1` both say."""

from __future__ import annotations

from verify.prover import PROVED, Ends
from verify.statement import Constant, Obligation
from verify.theorem1 import Outcome
from verify.typeset import Typesetter


def verdict_text(outcome: Outcome) -> str:
    """The verdict, with the number of assumptions on which a proof rests."""
    if outcome.verdict != PROVED:
        return outcome.verdict
    return f"{PROVED}, given {len(outcome.assumptions)} listed estimates"


def letters(outcome: Outcome) -> Typesetter:
    """A typesetter in the paper's letters."""
    names = {c.name: c.letter for c in outcome.statement.constants}
    return Typesetter(names | {"V_0": "V₀", "delta_theta": "δ_θ", "c": "(-cos θ₀)"})


def sentence(row: Obligation, typesetter: Typesetter) -> str:
    """The step in the paper's words, then the claim that is decided."""
    return f"{row.says}: {typesetter.claim(row.claim)}"


def entry_ends(outcome: Outcome, constant: Constant) -> list[Ends | None]:
    """Enclosures of the entries of a constant's min."""
    return [outcome.prover.enclose(entry) for entry in constant.term.children]


def least(entries: list[Ends | None]) -> int | None:
    """The index of the entry that is certainly the least, if the enclosures show one."""
    known = [ends for ends in entries if ends is not None]
    if len(known) < len(entries):
        return None
    index = min(range(len(known)), key=lambda i: known[i][1])
    others = known[:index] + known[index + 1 :]
    return index if all(known[index][1] <= ends[0] for ends in others) else None
