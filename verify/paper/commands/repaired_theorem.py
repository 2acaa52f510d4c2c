"""Theorem 1 with the repaired constants, whole: hypotheses, constants, set, and it in Coq."""

from __future__ import annotations

from importlib.resources import files

from verify.language.statement import NEEDED
from verify.paper.commands.citing import MEANING, STEP
from verify.paper.commands.pages import statement
from verify.paper.theorem1 import theorem
from verify.publication import HYPOTHESES, REPAIRED
from verify.views.findings import Whole

#: How the state at the start is written in the inequalities of the set.
START = {
    "y": ("(-η_c)", r"(-\eta_c)"),
    "eta_s": ("η_s", r"\eta_s"),
    "C": ("(-cos θ)", r"(-\cos\theta)"),
    "A": ("|W_c|²", "|W_c|^2"),
    "B": ("|W_s|²", "|W_s|^2"),
    "d": ("d", "d"),
}
PARAMETERS = {
    "r": ("r", "r"),
    "c": ("(-cos θ₀)", r"(-\cos\theta_0)"),
    "V_0": ("V₀", "V_0"),
    "delta_theta": ("δ_θ", r"\delta_\theta"),
}
#: Where the constants begin in the sentence of Coq; it ends with the file.
COQ, FIRST = "coq/Theorem1.v", "Definition alpha_0"


def whole() -> Whole:
    """The theorem, from the tables of its rows, of its constants and of the step."""
    own = theorem().parts[REPAIRED].bounds
    every = (*theorem().common, *own)
    constants = tuple(c for c in every if c.name != f"{REPAIRED}.V_1")  # it is V_1
    letters = PARAMETERS | {c.name: (c.letter, c.tex) for c in every}
    letters |= {f"{name}_start": pair for name, pair in START.items()}
    letters |= {name: letters[term.name] for name, term in MEANING.items()}
    derived = {row.name for row in statement("all_parameters").obligations}
    hypotheses = tuple(
        row.says
        for row in theorem().parts[HYPOTHESES].obligations
        if row.role == NEEDED and row.name not in derived
    )
    text = files("verify").joinpath(COQ).read_text(encoding="utf-8")
    coq = text[text.index(FIRST) :].rstrip()
    givens = tuple(statement(STEP).context("initial").claims.values())
    return Whole(hypotheses, constants, givens, letters, coq)
