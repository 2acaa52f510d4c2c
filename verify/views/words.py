"""What the table and the document of `theorem1` both say."""

from __future__ import annotations

from verify.decimals import outward, short
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


def theorem_in_numbers(outcome: Outcome) -> str:
    """The theorem with the repaired constants as the short decimals that they are."""
    definitions = outcome.prover.definitions

    def value(name: str) -> str:
        number = definitions[f"repaired.{name}"].value
        return outward((number, number))[0]

    typesetter = letters(outcome)
    r, c, v_0, delta = (typesetter.term(definitions[name]) for name in outcome.statement.parameters)
    third = (definitions["repaired.V_1"].value - definitions["V_0"].value) / 3
    low, high = definitions["V_0"].value + third, definitions["repaired.V_1"].value - third
    phi = outcome.prover.enclose(definitions["phi_minus"])
    root = "undefined" if phi is None else short(phi)
    return (
        f"Let r = {r}. Three particles, 0 and 1 in contact and just collided, with "
        f"0 < -η_c ≤ {value('eta_bar')}, |η_s/(-η_c) - φ⁻| ≤ {value('x_0')} and η_s > 0 "
        f"(φ⁻ = {root}), 0 < d ≤ min({value('d_const')}, {value('d_slope')} η_c²), "
        f"|W_c|² and |W_s|² in [{low}, {high}], and |cos θ + {c}| ≤ "
        f"{value('Delta_theta')}/4, collide for ever in the order 0-2, 0-1, 0-2, …, within the "
        f"time {value('T_star')} (unit of length: a diameter; |W|² ≥ V₀ = {v_0}), and -cos of "
        f"the final angle differs from {c} by at most {value('Delta_theta')} ≤ δ_θ = {delta}."
    )
