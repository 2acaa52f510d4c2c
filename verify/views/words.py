"""What the table and the document of `theorem1` both say."""

from __future__ import annotations

from fractions import Fraction

from verify.prover import balls
from verify.prover.decimals import outward, short
from verify.prover.ground import PROVED, Ends
from verify.language.statement import Constant, Obligation
from verify.jobs.theorem1 import Outcome
from verify.views.typeset import Typesetter

#: Bits of the thresholds that are only shown; the hypotheses are decided without them.
THRESHOLD_BITS = 192


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


def least(outcome: Outcome, constant: Constant) -> int | None:
    """The index of the first entry that is proved to be at most each other one."""
    entries = constant.term.children
    ends = [outcome.prover.enclose(entry) for entry in entries]
    known = [(pair[1], index) for index, pair in enumerate(ends) if pair is not None]
    if len(known) < len(entries):
        return None
    index = min(known)[1]
    claims = (entries[index] <= other for other in entries if other is not entries[index])
    return index if all(outcome.prover.decide(c).verdict == PROVED for c in claims) else None


def thresholds(outcome: Outcome) -> str:
    """Where r and -cos(theta_0) would have to lie, in numbers."""
    r, c = (outcome.prover.definitions[name] for name in ("r", "c"))
    with balls.precision(THRESHOLD_BITS):
        stabi = short(balls.ends(9 - 4 * balls.root(balls.from_fraction(Fraction(5)))))
        root = balls.cube_root(balls.from_fraction(r.value))
        bound = short(balls.ends(2 * root * (1 + root) / (1 + balls.from_fraction(r.value))))
    found = outcome.prover.enclose(c)
    own = "undefined" if found is None else short(found)
    r_text = short((r.value, r.value))
    return f"r = {r_text}, r_stabi = {stabi}; -cos θ₀ = {own}, its threshold = {bound}"


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
