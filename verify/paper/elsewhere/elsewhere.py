"""The statement of the rest of the text, with its argument and the points of its misprints.

The sentences on which its rows rest lead from them to the propositions of the text.
"""

from __future__ import annotations

from functools import cache

from verify.language.argument import Argument
from verify.language.statement import NEEDED, Assumption, Obligation
from verify.paper.elsewhere import aligned, estimates, generic, mapping, nearly, pair, quoted, sums
from verify.paper.letters import Refuted, sectioned

MATHEMATICS, GLUE = "general mathematics", "numbered glue"

ASSUMPTIONS = (
    Assumption("cauchy-schwarz",   "EQUATSS2.2IterationSystm1",
         "(x·z)² ≤ |x|²|z|² for any two vectors of a Euclidean space, and |x+z| ≤ |x|+|z|.",
         MATHEMATICS),
    Assumption("glue-summable",    "PROPOSS3.2SommaCompNormlV",
         "1. By energy-loss Σ η² over all collisions, each with its own pair, is finite, and "
         "speeds are bounded; by intervals-telescope Σ τ is finite. For a fixed pair, "
         "normal-reversed or third-normal gives its component just after a collision, and "
         "flight-gain, with flight-normal of the classification, the one just before the next. So "
         "each step adds a number a with Σ a² finite, and window-next sums the squares over gaps "
         "of bounded length.", GLUE),
    Assumption("glue-comparisons", "PROPOSS3.3AsympCompa__I__",
         "2. In a collapse speeds are bounded, by energy-loss, and d, τ and, by glue-summable, η₁ "
         "and η₂ tend to 0. As |W|² = η² + |W⊥|² and 2|η||W⊥| ≤ |W|², the printed comparisons are "
         "those of distance-by-time and time-by-distance; travel-upper; normal-1-upper, "
         "normal-1-lower and normal-2-upper; turn-1 and turn-2; change-tangential-1 with flown-1, "
         "bracket-short and hit; change-tangential-2 with flown-2. Where |W₂| does not tend to 0, "
         "zeta-below-one gives d = O(η₂²), and time-by-distance then τ = O(η₂).", GLUE),
    Assumption("glue-regime",      "SSSCT3.3.5CondiSuffiT<<Et",
         "3. By zeta-upper and zeta-lower ζ ~ 2d|W₂|²/η₂² as d tends to 0. By time-leading and "
         "time-trailing τ ~ d/(-η₂) where ζ tends to 0; by distance-by-time and time-by-distance "
         "τ/(-η₂) tends to 0 exactly where d/η₂² does.", GLUE),
)  # fmt: skip

#: What is concluded in words, at the rows from which it is.
CONCLUDES = {
    "window-next": "glue-summable",
    "flight-gain": "glue-summable",
    "flown-1": "glue-comparisons",
    "flown-2": "glue-comparisons",
    "zeta-below-one": "glue-comparisons",
    "time-trailing": "glue-regime",
    "zeta-lower": "glue-regime",
}

#: The contexts that are given Cauchy-Schwarz inequalities.
VECTORS = ("map", "free", "energy")


NAME = "elsewhere"
TITLE = (
    "What the paper prints outside the proof of Theorem 1 and the spectrum: laws, estimates and "
    "claims of Sections 1 to 4.1, for every state"
)

#: The chapters in the order of the text, by the heading of their rows.
SECTIONS = {
    "conditions and counts": quoted.chapters,
    "2.1 the law of a collision": pair.chapters,
    "2.2 the mapping": mapping.chapters,
    "2.2 the next collision": mapping.outer,
    "3.2 times, flights and sums": sums.chapters,
    "3.3 times and distances": estimates.chapters,
    "3.3 what one collision changes": estimates.changes,
    "3.3 large relative velocities": generic.chapters,
    "3.3 a collapse on a line": aligned.chapters,
    "4.1 the nearly-linear collapse": nearly.chapters,
}

#: What is false there; `aligned` has the equations on what one collision changes.
MISPRINTS = {
    "conditions and counts": quoted.misprints,
    "2.1 the law of a collision": pair.misprints,
    "2.2 the mapping": mapping.misprints,
    "2.2 the next collision": mapping.outer_misprints,
    "3.2 times, flights and sums": sums.misprints,
    "3.3 times and distances": estimates.misprints,
    "3.3 large relative velocities": generic.misprints,
    "3.3 a collapse on a line": aligned.misprints,
    "4.1 the nearly-linear collapse": nearly.misprints,
}


@cache
def elsewhere() -> Argument:
    """The statement with its argument, built once per process."""
    written = sectioned(NAME, TITLE, SECTIONS, ASSUMPTIONS)
    false = (
        found.row._replace(group=heading)
        for heading, section in MISPRINTS.items()
        for found in section()
    )
    rows = tuple(_concluding(row) for row in (*written.statement.obligations, *false))
    return written._replace(statement=written.statement._replace(obligations=rows))


def refutations() -> tuple[Refuted, ...]:
    """What is false, in the order of the text, each with a point at which it is."""
    return tuple(found for section in MISPRINTS.values() for found in section())


def _concluding(row: Obligation) -> Obligation:
    uses = ["cauchy-schwarz"] if row.context in VECTORS and row.role == NEEDED else []
    if row.name in CONCLUDES:
        uses.append(CONCLUDES[row.name])
    return row._replace(uses=tuple(uses))
