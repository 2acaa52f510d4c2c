"""Which of the sentences that statements take on trust Coq proves, and by which theorems.

Those theorems are pinned in `verify/coq/Sentences.v` and `BeyondSentences.v`, the ones about the
separatrix in `verify/coq/PinnedSeparatrix.v`; `.ci/coq` asks for all of them. A sentence that is a
definition is defined in Coq by what stands here. Coq may also prove what a statement uses of
another one that it cites: then it rests on none of the sentences that the other one takes on trust,
but on its definitions.
"""

from __future__ import annotations

from collections.abc import Mapping

from verify.paper.parameters import THEOREM

_GENERAL = {
    "hard-spheres": ("Theorem1.later", "Theorem1.collided", "Theorem1.first_to_meet"),
    "cauchy-schwarz": ("Vectors.cauchy_schwarz",),
    "bounded-monotone": (
        "Sequences.bounded_increasing_converges", "Sequences.bounded_decreasing_converges",
    ),
}  # fmt: skip
_VECTORS = {"cauchy-schwarz": ("Vectors.cauchy_schwarz", "Vectors.vector_exists")}
_LENGTH = {"finite-length": ("Ending.place_cauchy", "Ending.positions_converge_to_ending")}
_OPEN = {"open-condition": ("Steady.steady_less", "Steady.nearby_both")}
_NEAR = ("OneScene.numbers_of_point_are", "Interior.set_near")
_CURVE = ("SeparatrixProof.separatrix",)
_PAIR = ("SpectrumEigen.spectrum",)
#: Theorem 1 with < in (4.10), and the spectrum.
SIGN, SPECTRUM = f"{THEOREM}, the sign as printed", "THEORSS3.5SpectMatricVitLm"

#: For each theorem with such sentences their names, in its order.
IN_COQ: Mapping[str, Mapping[str, tuple[str, ...]]] = {
    "step": {
        **_GENERAL | _VECTORS,
        **_LENGTH,
        **_OPEN,
        "glue-next": ("OneStep.meets", "OneStep.shows_next"),
        "glue-collapse": ("Trajectory.scenes_collide_in_turn", "Trajectory.finite_time"),
        "glue-angle": ("Trajectory.angle_converges", "Ending.in_turn_collapses"),
        "glue-interior": (*_NEAR, "Interior.the_set_has_an_interior"),
    },
    "sharper": {
        **_GENERAL,
        **_LENGTH,
        "glue-next": (
            "SharperStep.sharper_step",
            "SharperStep.new_numbers",
            "AnyStep.meets",
            "AnyStep.shows_next",
        ),
        "glue-collapse": ("SharperCollapse.collide_in_turn", "SharperCollapse.time_bounded"),
        "glue-angle": ("SharperCollapse.angle_stays", "SharperCollapse.sharper_collapse"),
    },
    "sandwich": {
        "hard-spheres": _GENERAL["hard-spheres"],
        "comparison": ("Sandwich.inner_goes_on",),
        "cauchy-schwarz": _GENERAL["cauchy-schwarz"],
        "bounded-monotone": _GENERAL["bounded-monotone"],
        **_LENGTH,
        "glue-next": (
            "SandwichStep.sandwich_step",
            "SandwichStep.new_numbers",
            "AnyStep.meets",
            "AnyStep.shows_next",
        ),
        "glue-stairs": ("SandwichProof.inner_stair_theorem_holds",),
        "glue-collapse": ("SandwichProof.sandwich_theorem_holds",),
        "glue-angle": ("SandwichProof.sandwich_theorem_holds",),
    },
    "three-balls": {
        "any-balls": ("Line.meets_next", "Line.parts"),
        "comparison": ("ThreeBalls.goes_on",),
        "cauchy-schwarz": _GENERAL["cauchy-schwarz"],
        "bounded-monotone": _GENERAL["bounded-monotone"],
        "finite-length": ("Settling.settles_in_time",),
        "glue-next": (
            "ThreeBallsStep.balls_step",
            "AnyStep.balls_meet",
            "AnyStep.balls_after",
            "Bounces.bounced_parts",
            "ThreeBallsStep.new_numbers",
        ),
        "glue-stairs": ("ThreeBallsMap.stair_theorem_holds",),
        "glue-collapse": ("ThreeBallsCollapse.three_balls_theorem_holds",),
        "glue-angle": (
            "ThreeBallsCollapse.three_balls_theorem_holds",
            "ThreeBallsCollapse.three_equal_balls_holds",
        ),
    },
    "outside": {
        "hard-spheres": _GENERAL["hard-spheres"],
        "goes-on": ("Outside.strikes_in_turn",),
        "cauchy-schwarz": _GENERAL["cauchy-schwarz"],
        "glue-next": (
            "OutsideStep.next_theorem_holds",
            "AnyStep.contact_next",
            "OutsideProof.new_numbers",
            "OutsideStep.two_strikes",
        ),
        "glue-ends": (
            "OutsideProof.outside_theorem_holds",
            "OutsideProof.no_collapse_theorem_holds",
        ),
        "glue-floor": ("OutsideProof.floor_theorem_holds",),
    },
    "flow": {"hard-spheres": _GENERAL["hard-spheres"]},
    "flow-of-balls": {"any-balls": ("Line.meets_next", "Line.parts")},
    "line": {
        "balls-on-a-line": ("Line.parts", "Line.share"),
        "bounded-monotone": _GENERAL["bounded-monotone"],
        "glue-line": ("LineProof.line_theorem_holds",),
    },
    f"{THEOREM}, the set as printed": {
        **_VECTORS,
        **_OPEN,
        "glue-interior": (*_NEAR, "PrintedProof.room_has_an_interior"),
    },
    "classification": {
        "cauchy-schwarz": (
            "Vectors.cauchy_schwarz",
            "Calculus.wedge_by_coordinates",
            "Turning.spin_bounded",
            "Calculus.tuples_bounded",
            "Calculus.lengths_add",
        ),
        "bounded-monotone": (
            *_GENERAL["bounded-monotone"],
            "Calculus.vectors_summable",
            "Calculus.any_order",
        ),
        "finite-length": ("Settling.settles_in_time", "Unbounded.settles_late"),
        "glue-lemma": ("ManyBalls.apart_from_then_on", "ManyBalls.one_in_between"),
        "glue-classification": ("ClassificationProof.no_triangle_holds",),
        "glue-run": (
            "AlternatingRuns.run_theorem_holds",
            "AlternatingRuns.run_on_a_line_holds",
            "AlternatingRuns.run_without_end_holds",
            "ClassificationProof.least_angle_any_radii_holds",
            "ClassificationProof.never_any_radii_holds",
        ),
        "glue-impulse": ("Impulse.exchange_theorem_holds",),
        "glue-endless": (
            "ClassificationProof.comes_to_rest_holds",
            "ClassificationProof.least_angle_any_radii_holds",
        ),
        "glue-scenes": (
            "Runs.never_by_parting",
            "Runs.never_by_passing",
            "Runs.never_any",
            "FiniteScenes.finite_by_restitution",
            "FiniteScenes.finite_outward",
            "Deadline.deadline",
            "Deadline.never_late",
            "ManyBalls.not_before",
        ),
        "glue-second": ("ClassificationProof.least_angle_any_radii_holds",),
    },
    "elsewhere": {"cauchy-schwarz": ("Vectors.cauchy_schwarz", "Calculus.lengths_add")},
    SIGN: {"glue-as-printed": ("PrintedSignProof.printed_sign_theorem_holds",)},
    SPECTRUM: {
        "collision-law": ("Theorem1.collided", "Spectrum.triple"),
        "any-dimension": ("SpectrumMatrix.basis_holds", "SpectrumMatrix.matrix"),
        "signs": ("SpectrumSentences.signs",),
        "intermediate-value": ("SpectrumRoots.roots", "SpectrumRoots.increasing"),
        "every-r": ("SpectrumOrbits.parameter", *_PAIR),
        "polynomials": _PAIR,
        "linear-algebra": ("SpectrumRoots.characteristic", *_PAIR),
        "monotone": ("Calculus.falls_and_rises",),
        "linear-model": ("Spectrum.orbit",),
        "spiral": (
            "SpectrumOrbits.orbits",
            "SpectrumSentences.left_eigenvector",
            "SpectrumSentences.plane_of_the_pair",
            "SpectrumSentences.transverse",
        ),
        "spectral-radius": (
            "SpectrumSentences.rates",
            "SpectrumSentences.no_rate_when_forced",
        ),
        "zhou-kadanoff": ("ClassificationProof.least_angle_holds",),
        "no-triangular-collapse": ("ClassificationProof.no_triangle_holds",),
    },
    "separatrix": {
        "limit-map": ("Separatrix.goes_on", "Separatrix.next"),
        "unending": ("Separatrix.unending",),
        "bounded-monotone": _GENERAL["bounded-monotone"],
        "glue-regime": _CURVE,
        "glue-exists": _CURVE,
        "glue-none": _CURVE,
    },
}

#: For a statement the theorems that it cites and Coq proves, as far as they are used there.
CITED_IN_COQ: Mapping[str, Mapping[str, tuple[str, ...]]] = {
    SIGN: {"classification": ("ClassificationProof.least_angle_holds",)},
    SPECTRUM: {"classification": ("ClassificationProof.least_angle_holds",)},
}

#: What Coq proves as a whole, from its definitions alone.
WHOLE_IN_COQ: Mapping[str, tuple[str, ...]] = {SIGN: ("PinnedPrintedSign.printed_sign_proved",)}
