"""The committed certificates: which points they are at, and how their files are made."""

from __future__ import annotations

import glob
import os
from collections.abc import Iterator
from fractions import Fraction

from verify.language.record import Record
from verify.language.terms import Term, as_term, cos_pi
from verify.paper.commands import pages, scene, separatrix, theorem1
from verify.paper.commands.citing import STEP
from verify.paper.parameters import ALL_PARAMETERS, THEOREM
from verify.prover.outcome import Outcome
from verify.spheres.scene.decide import UNDECIDED, decide_scene
from verify.spheres.scene.scene_files import read_scene, scene_bytes
from verify.wire.judge import judged


class StoredPoint(Record):
    """A folder of `certificates/` and the parameters of Theorem 1 that it is about."""

    folder: str
    r: str
    neg_cos: Term
    why: str

    @property
    def parameters(self) -> dict[str, Term]:
        """All parameters, with V_0 = 1 and delta_theta = 1/10."""
        return {
            "r": as_term(Fraction(self.r)),
            "c": self.neg_cos,
            "V_0": as_term(1),
            "delta_theta": as_term(Fraction(1, 10)),
        }


POINTS = (
    StoredPoint("theorem1-r-3-100", "3/100", as_term(1), "the main job"),
    StoredPoint("theorem1-r-1-1000", "1/1000", as_term(1), "strong dissipation"),
    StoredPoint("theorem1-r-near-stabi", "0.055728", as_term(1), "r next to 9 - 4√5 = 0.05572809…"),
    StoredPoint("theorem1-angle-near-threshold", "1/64", as_term(Fraction("0.615384616")),
                "-cos θ₀ next to its threshold 8/13 = 0.61538461538…"),
    StoredPoint("theorem1-r-1e-6-wide", "1/1000000", as_term(Fraction(1, 20)),
                "nearly a right angle"),
    StoredPoint("theorem1-theta-5pi-6", "1/100", -cos_pi(Fraction(5, 6)),
                "an angle whose cosine is irrational"),
)  # fmt: skip


class Theorem(Record):
    """What is proved for all values: its folder, its name, and the page that says it."""

    folder: str
    name: str
    page: str

    def decide(self) -> Outcome:
        """The theorem, decided anew."""
        return pages.decide(self.page) if self.page else separatrix.decide_stored()


THEOREMS = (
    Theorem("step", STEP, "step"),
    Theorem("step-printed", "step-printed", "step_as_printed"),
    Theorem("theorem1-all", ALL_PARAMETERS, "all_parameters"),
    Theorem("printed-set", f"{THEOREM}, the set as printed", "printed_set"),
    Theorem("printed-sign", f"{THEOREM}, the sign as printed", "printed_sign"),
    Theorem("thresholds", f"{THEOREM} as printed, where it depends", "thresholds"),
    Theorem("spectrum", "THEORSS3.5SpectMatricVitLm", "spectrum"),
    Theorem("classification", "classification", "classification"),
    Theorem("classification-of-balls", "classification-of-balls", "classification_of_balls"),
    Theorem("alexander", "alexander", "alexander"),
    Theorem("elsewhere", "elsewhere", "sections_1_to_4"),
    Theorem("sharper", "sharper", "sharper"),
    Theorem("sandwich", "sandwich", "sandwich_below"),
    Theorem("outside", "outside", "sandwich_above"),
    Theorem("three-balls", "three-balls", "three_balls"),
    Theorem("flow", "flow", "flow"),
    Theorem("flow-of-balls", "flow-of-balls", "flow_of_balls"),
    Theorem("touching", "touching", "touching"),
    Theorem("line", "line", "line"),
    Theorem("separatrix", "separatrix", "separatrix"),
    Theorem("separatrix-r-3-100", separatrix.POINT, ""),  # no page: it is computed
)


def scene_paths(directory: str) -> list[str]:
    """The files of scenes below a directory."""
    return sorted(glob.glob(os.path.join(directory, "scenes", "*.toml")))


def number_of_folders(directory: str) -> int:
    """How many folders there are at most; a scene may be undecided."""
    return len(POINTS) + len(THEOREMS) + len(scene_paths(directory))


def all_folders(directory: str = "certificates") -> Iterator[tuple[str, Outcome]]:
    """Every folder with its outcome, decided anew; the scenes are the files in its `scenes`."""
    for point in POINTS:
        yield point.folder, theorem1.decide_point(point.parameters)
    for theorem in THEOREMS:
        yield theorem.folder, theorem.decide()
    for path in scene_paths(directory):
        found = decide_scene(read_scene(path, scene_bytes(path)))
        if found.verdict != UNDECIDED:
            stem = os.path.splitext(os.path.basename(path))[0]
            outcome = scene.scene_outcome(found, found.flow.bits)
            yield os.path.join("scenes", stem), judged(outcome)
