"""What the rows on the text rest on, and the sentences that lead from them to its propositions."""

from __future__ import annotations

from verify.language.statement import Assumption

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
