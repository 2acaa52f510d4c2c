"""Ways to make Coq prove what is false, or to say less than it seems. `.ci/coq` sees each of them.

    python -m tests.coq.tampering DIRECTORY      # exit code 1 if one is not seen

DIRECTORY has everything that `.ci/coq` has compiled. Each way changes a copy and compiles only what
it has to; a false proof stands there as a proof that takes an axiom, so that all else compiles.
"""

from __future__ import annotations

import re
import subprocess
import sys
import tempfile
from collections.abc import Callable
from pathlib import Path
from typing import NamedTuple

from tests.coq.closing import ROOT, module
from tests.coq.everything import MATRIX, VALUES, conjunction, everything, printed
from tests.coq.record import AnotherError, said_by_coq
from tests.coq.session import session
from tests.coq.sources import unexpected

SOURCES = Path(__file__).resolve().parents[2] / "verify/coq"
ASSUMED = SOURCES / "assumed.txt"
HEAD = "From Verify Require Import Theorem1.\n"
#: A proof of Theorem 1 from nothing.
STUB = f"{HEAD}Axioms lemma1 : {conjunction('')}.\n"
STUB += "Definition all_proved := lemma1.\n"


class Definition(NamedTuple):
    """Another meaning of a definition, which the page that pins it has to see."""

    file: str
    old: str
    new: str


#: Between what the places are in the end and the second condition on the angle there.
LEAST = " /\\\n    4 * sqrt r / (1 + r) <= minus_cosine_at d at_T o a c <= 1 /\\\n    "
#: In Theorem1.v, seen by Pinned.v; and in Meaning.v and Separatrix.v, each seen by its own page.
DEFINITIONS = {
    "time-bound": Definition("Theorem1", "T <= by_time", "T <= - by_time"),
    "vacuous-admissible": Definition("Theorem1", "restitution : 0 <", "restitution : 1 <"),
    "vacuous-initial": Definition("Theorem1", "touch : distance d s B0 B1 = 1", "touch : 1 = 0"),
    "dot-product": Definition("Theorem1", "dot k u v + u k * v k", "dot k u v + u k * u k"),
    "collision": Definition("Theorem1", "velocity s b k + J", "velocity s b k - J"),
    "same-ball": Definition("Theorem1", "B0, B0 | B1, B1 | B2, B2 =>", "B0, B0 | B1, B1 =>"),
    "contact": Definition(
        "Theorem1", "touch_2 : distance at_T B0 B2",
        "touch_2 : distance at_T B0 B1",
    ),
    "positions": Definition("Theorem1", "Rabs (f t - l) < e", "Rabs (f t - l) < e + 1"),
    "angle-at-the-end": Definition("Theorem1", "(minus_cosine at_T - c) <=", "(c - c) <="),
    "only-ball-0": Definition(
        "Theorem1", "exists i j, i <> j /\\ distance s",
        "exists i j, i = B0 /\\ i <> j /\\ distance s",
    ),
    "overlap": Definition(
        "Theorem1", "i <> j -> 1 <= distance s i j",
        "i <> j -> 0 <= distance s i j",
    ),
    "flies-anywhere": Definition("Theorem1", "Z (t + u) = later u (Z t)", "Z (t + u) = Z (t + u)"),
    "arrives-anywhere": Definition(
        "Theorem1", "Z (t - u) = later (- u) arriving", "Z (t - u) = Z (t - u)"
    ),
    "goes-beyond": Definition(
        "Theorem1", "trajectory s T' Z' -> T' <= T;",
        "trajectory s T' Z' -> T <= T;",
    ),
    "determined": Definition("Theorem1", "t < T' -> Z t = Z' t", "t < T' -> Z t = Z t"),
    "no-interior": Definition("Theorem1", "exists s e, 0 < e /\\", "exists s e,"),
    "flat-box": Definition(
        "Theorem1", "position low i k < position high i k",
        "position low i k <= position high i k",
    ),
    "empty-box": Definition("Theorem1", "in_box low high s -> set s", "in_box low high s -> True"),
    "nothing-near": Definition("Theorem1", "close e s s' -> set s'", "close e s s' -> set s"),
    "another-set": Definition("Theorem1", "0 < v <= u ->", "0 < v < u ->"),
    "denominator": Definition("Theorem1", "0 < 1 - h_5 r c", "0 <= 1 - h_5 r c"),
    "tolerance": Definition(
        "Theorem1", "Delta_theta r c V_0 delta_theta <= delta_theta",
        "Delta_theta r c V_0 delta_theta <= 2 * delta_theta",
    ),
    "cube-root": Definition("Theorem1", "Rpower r (1 / 3)", "Rpower r (1 / 4)"),
    "threshold": Definition("Theorem1", "0 < r < 9 - 4 * sqrt 5", "0 < r < 8 - 4 * sqrt 5"),
    "printed-angle": Definition(
        "Theorem1", "by_time (- cos theta_0) delta",
        "by_time (cos theta_0) delta",
    ),
    "constant": Definition("Theorem1", "(sqrt 2 - 1) / 16", "(sqrt 2 - 1) / 15"),
    "notation": Definition(
        "Theorem1", "Open Scope R_scope.",
        'Open Scope R_scope.\nNotation "x <= y" := (x <= x + y) : R_scope.',
    ),
    "arrow": Definition(
        "Theorem1", "Definition theorem_1 :",
        'Notation "A -> B" := (A -> B \\/ True) : type_scope.\nDefinition theorem_1 :',
    ),
    "another-ball": Definition("Theorem1", "B0 | B1 | B2.", "B0 | B1 | B2 | B3."),
    "refuted-is-true": Definition("Meaning", "| Refuted, _ => False", "| Refuted, _ => True"),
    "proved-is-true": Definition(
        "Meaning", "| Proved, s => says (row_context r) s", "| Proved, s => True"
    ),
    "root": Definition("Meaning", "| Sqrt a => sqrt (value v a)", "| Sqrt a => 0 * value v a"),
    "sine": Definition("Meaning", "Sin => sin x", "Sin => cos x"),
    "logarithm": Definition("Meaning", "Log => 0 < x", "Log => 0 <= x"),
    "divisor": Definition("Meaning", " /\\ value v b <> 0", ""),
    "least-of-two": Definition(
        "Meaning", "fold_right (fun x => Min (tree_at x)) (tree_at a) l",
        "match l with [b; c] => Min (tree_at b) (Min (tree_at c) (tree_at a)) | _ => tree_at a end",
    ),
    "separatrix-map": Definition("Separatrix", "- q x - rho * u x.", "- q x - u x."),
    "separatrix-next": Definition("Separatrix", "rho * u x) < p rho", "rho * u x) <= p rho"),
    "separatrix-regime": Definition("Separatrix", "x n)) phi_minus.", "x n)) phi_plus."),
    "separatrix-below": Definition(
        "Separatrix", "u x < f (q x) -> regime r a rho x",
        "u x < f (q x) -> unending r a rho x",
    ),
    "separatrix-cycle": Definition("Separatrix", "rho x <-> x = c)", "rho c \\/ x = c)"),
    "separatrix-if": Definition("Separatrix", "x) <-> s + s ^ 2 < a", "x) -> s + s ^ 2 < a"),
    "another-kind": Definition("Meaning", "Carried | Standing.", "Carried | Standing | Hidden."),
}  # fmt: skip

#: What the page of sentences pins, with the end of its part of the file, and the theorem there.
SPELLED = {
    "fewer-scenes": (
        Definition("FromNumbers", "0 < y <= eta_bar;", "0 < y <= eta_bar / 2;"),
        "\nDefinition numbers_context", "initial_by_numbers",
    ),
    "another-distance": (
        Definition("AnyStep", "scaled (1 + d m) q /", "scaled (2 + d m) q /"),
        "\n(* --- the step", "has_numbers",
    ),
    "another-product": (
        Definition("AnyStep", "dot dimension p q = - C m", "dot dimension p q = C m"),
        "\n(* --- the step", "has_numbers",
    ),
}  # fmt: skip

#: What the page of the printed set pins, in its definitions and in those that they use.
PRINTED = {
    "the-same": Definition("PrintedSet", "", ""),
    "printed-constant": Definition("PrintedSet", "V_0 / (33 * sqrt V_1)", "V_0 / (28 * sqrt V_1)"),
    "repaired-set": Definition(
        "PrintedSet", "delta_4; delta_5].",
        "delta_4; delta_5; V_0 / V_1 * (delta_2 ^ 2 * h_5 / 12)].",
    ),
    "angle-not-fixed": Definition(
        "PrintedSet", "Prop := with_slack 0.",
        "Prop := with_slack (Theta / 6).",
    ),
    "less-room": Definition("PrintedSet", "(Theta / 6)", "(Theta / 7)"),
    "no-parameters": Definition("PrintedSet", "PI / 2 < theta_0", "PI < theta_0"),
    "no-scene": Definition("PrintedSet", "(exists s, as_printed s)", "(exists s, roomy s)"),
    "with-interior": Definition("PrintedSet", "~ has_interior d as", "has_interior d as"),
    "only-as-printed": Definition(
        "PrintedSet", "(forall s, roomy s ->",
        "(forall s, as_printed s ->",
    ),
    "any-angle": Definition("PrintedSet", "delta_theta) c Theta)", "delta_theta) c 2)"),
    "far-from-the-angle": Definition(
        "PrintedSet", "Theta <= delta_theta.",
        "Theta <= 2 * delta_theta.",
    ),
    "fewer-printed": Definition("FromNumbers", "0 < y <= eta_bar;", "0 < y < eta_bar;"),
    "no-flight": Definition("FromNumbers", "/\\ s = later u s_0.", "/\\ s = later 0 s_0."),
}  # fmt: skip
PRINTED_STUB = "From Verify Require PrintedSet.\nAxioms lemma1 : PrintedSet.printed_set_theorem.\n"
PRINTED_STUB += "Definition printed_set_theorem_holds := lemma1.\n"

#: In the files that say which collapses there are, what balls do on a line and in space, that the
#: printed sign is wrong, and what the spectrum is, each seen by the page that pins it: hypotheses
#: that nothing satisfies, a witness that satisfies not all of them, another order or ball, <= for
#: <, the plane for R^d, less.
OTHERS = {
    "the-same-classification": Definition("Classification", "", ""),
    "the-same-sign": Definition("PrintedSign", "", ""),
    "the-same-spectrum": Definition("Spectrum", "", ""),
    "sign-of-no-r": Definition("PrintedSign", "0 < r < 9 - 4", "0 < r < 8 - 4"),
    "sign-as-corrected": Definition(
        "PrintedSign",
        "0 < - cos theta_0 < 2 * cube_root r * (1 + cube_root r) / (1 + r)",
        "2 * cube_root r * (1 + cube_root r) / (1 + r) < - cos theta_0",
    ),
    "sign-in-the-plane": Definition(
        "PrintedSign", "(2 <= d)%nat -> hyp", "(2 = d)%nat -> hyp"
    ),
    "sign-without-room": Definition("PrintedSign", "/\\ 0 < delta_theta.", "/\\ 0 <= delta_theta."),
    "sign-at-the-bound": Definition(
        "PrintedSign",
        "- cos theta_0 + delta_theta < 4 * sqrt r / (1 + r)) /\\",
        "- cos theta_0 + delta_theta <= 4 * sqrt r / (1 + r)) /\\",
    ),
    "sign-at-in-the-plane": Definition(
        "PrintedSign", "(2 <= d)%nat -> 0 < r < 1", "(2 = d)%nat -> 0 < r < 1"
    ),
    "sign-at-no-angle": Definition(
        "PrintedSign",
        "- cos theta_0 + delta_theta < 2 * cube",
        "- cos theta_0 + delta_theta < - cube",
    ),
    "sign-at-another-angle": Definition(
        "PrintedSign",
        "~ as_printed_at d r theta_0 delta_theta) /\\",
        "~ as_printed_at d r 0 delta_theta) /\\",
    ),
    "sign-much-spin": Definition("PrintedSign", "0 < spin2 d s", "1 < spin2 d s"),
    "sign-spin-at-the-bound": Definition(
        "PrintedSign", "    c + delta_theta < 2 * cube", "    c + delta_theta < cube"
    ),
    "sign-another-ball": Definition(
        "PrintedSign", "in_turn_from N i j B0 a b", "in_turn_from N i j a B0 b"
    ),
    "sign-any-angle": Definition("PrintedSign", "(minus_cosine d at_T - c) <=", "(c - c) <="),
    "sign-no-interior": Definition(
        "PrintedSign", "has_interior d set /\\", "(exists s : scene, set s) /\\"
    ),
    "sign-fewer-angles": Definition("PrintedSign", "c + delta_theta < 4", "c + delta_theta < 3"),
    "collapse-parts-at-once": Definition(
        "Classification", "0 <= rate d s' i j", "0 < rate d s' i j"
    ),
    "collapse-one-order": Definition(
        "Classification",
        "scenes (S n) = collided d r (i n) (j n) arriving",
        "scenes (S n) = collided d r B0 (j n) arriving",
    ),
    "collapse-least-angle": Definition(
        "Classification",
        "at_T o c = 1 /\\\n    4 * sqrt r / (1",
        "at_T o c = 1 /\\\n    3 * sqrt r / (1",
    ),
    "collapse-second": Definition("Classification", f"= 1{LEAST}(2 *", f"= 1{LEAST}("),
    "collapse-radii-least-angle": Definition(
        "Classification", "radius c /\\\n    4 * sqrt r", "radius c /\\\n    3 * sqrt r"
    ),
    "collapse-radii-second": Definition(
        "Classification", f"radius c{LEAST}(2 *", f"radius c{LEAST}("
    ),
    "collapse-radii-of-one": Definition(
        "Classification",
        "strikes d (fun _ => m) radius scenes time i j -> restituted d r scenes time i j ->",
        "strikes d (fun _ => m) (fun _ => 1) scenes time i j -> restituted d r scenes time i j ->",
    ),
    "collapse-radii-elastic": Definition(
        "Classification", "    - r * rate d (later", "    - r * r * rate d (later"
    ),
    "collapse-radii-in-time": Definition(
        "Classification",
        "0 < r <= 1 ->\n  strikes d (fun _ => m) radius scenes time i j ->",
        "0 < r <= 1 -> (exists T, Un_cv time T) ->\n"
        "  strikes d (fun _ => m) radius scenes time i j ->",
    ),
    "collapse-radii-at-no-r": Definition(
        "Classification",
        "7 - 4 * sqrt 3 < r <= 1 ->\n  strikes",
        "8 - 4 * sqrt 3 < r <= 1 ->\n  strikes",
    ),
    "rest-in-time": Definition(
        "Classification",
        "scenes time i j -> ~ (exists T, Un_cv time T) ->",
        "scenes time i j -> (exists T, Un_cv time T) ->",
    ),
    "rest-of-equal-masses": Definition(
        "Classification",
        "strikes d mass radius scenes time i j -> ~ (exists",
        "strikes d (fun _ => mass B0) radius scenes time i j -> ~ (exists",
    ),
    "rest-recedes": Definition(
        "Classification", "(rate d (scenes n)) <= 0) /\\", "(rate d (scenes n)) <= 1) /\\"
    ),
    "rest-later": Definition(
        "Classification",
        "(forall n, over_pairs mass (rate d (scenes n))",
        "(exists n, over_pairs mass (rate d (scenes n))",
    ),
    "rest-spins": Definition(
        "Classification", "(moment (scenes n) k l) = 0)", "(moment (scenes n) k k) = 0)"
    ),
    "rest-without-weights": Definition(
        "Classification", "mass B1 * mass B2 * f B1 B2.", "mass B1 * mass B1 * f B1 B2."
    ),
    "rest-moves": Definition(
        "Classification", "  stops d scenes /\\\n  (forall n", "  (forall n"
    ),
    "the-same-bounds": Definition("Bounds", "", ""),
    "bounds-of-no-mass": Definition(
        "Bounds", "J, (forall b, 0 < mass b)", "J, (forall b, mass b < 0)"
    ),
    "bounds-three-balls": Definition(
        "Bounds", "  forall d last mass sigma", "  let last := 2%nat in forall d mass sigma"
    ),
    "bounds-in-the-plane": Definition(
        "Bounds", "  forall d last mass sigma", "  let d := 2%nat in forall last mass sigma"
    ),
    "bounds-wins-energy": Definition(
        "Bounds", "<= - opening (x (S n)) (v n) (i n) (j n).", "<= opening (x n) (v n) (i n) (j n)."
    ),
    "bounds-in-flight": Definition("Bounds", "    0 <= t n /\\", "    0 < t n /\\"),
    "bounds-one-way": Definition(
        "Bounds", "v n (j n) k + J n / mass (j n)", "v n (j n) k - J n / mass (j n)"
    ),
    "bounds-larger": Definition(
        "Bounds", "- product d last mass x_0 v_0) /\\", "+ product d last mass x_0 x_0) /\\"
    ),
    "bounds-each": Definition(
        "Bounds", "exists bound, forall n, sum_f_R0 J n <=", "exists bound, forall n, J n <="
    ),
    "bounds-speeds": Definition(
        "Bounds",
        "sum_f_R0 (fun m => - opening d (x (S m)) (v m)",
        "sum_f_R0 (fun m => - opening d (x m) (v m)",
    ),
    "bounds-no-limit": Definition(
        "Bounds", "exists l, Un_cv (fun n => v n b k) l", "exists l, Un_cv (fun n => v 0%nat b k) l"
    ),
    "bounds-another-frame": Definition(
        "Bounds", "x b k - weighted x k / sum_f_R0 mass last.", "x b k - weighted x k."
    ),
    "bounds-turning": Definition(
        "Bounds", "(x b k * v b l - x b l * v b k)) last.", "(x b k * v b l - x b k * v b l)) last."
    ),
    "run-in-the-plane": Definition(
        "Bounds",
        "run_theorem : Prop :=\n  forall d m",
        "run_theorem : Prop :=\n  let d := 2%nat in forall m",
    ),
    "run-elastic": Definition(
        "Bounds",
        "0 < r <= 1 ->\n  distinct_balls o a c -> run d",
        "r = 1 ->\n  distinct_balls o a c -> run d",
    ),
    "run-another-order": Definition(
        "Bounds",
        "Prop :=\n  forall n, (n < k)%nat -> let b := if Nat.even n then c else a in",
        "Prop :=\n  forall n, (n < k)%nat -> let b := if Nat.even n then a else c in",
    ),
    "run-parts": Definition("Bounds", "o b = - r * rate d", "o b <= - r * rate d"),
    "run-bent-later": Definition("Bounds", "(2 <= n < k)%nat", "(1 <= n < k)%nat"),
    "run-longer": Definition(
        "Bounds",
        "o a c <= most) ->\n  forall n, (1 <= n < k)%nat",
        "o a c <= most) ->\n  forall n, (1 <= n < k - 1)%nat",
    ),
    "run-at-least": Definition(
        "Bounds", "(1 <= n < k)%nat -> 0 < s most r n.", "(1 <= n < k)%nat -> 0 <= s most r n."
    ),
    "run-another-sequence": Definition("Bounds", "(q, a * q - r * p)", "(q, a * q - p)"),
    "run-line-longer": Definition(
        "Bounds",
        "(forall n, (1 <= n < k)%nat -> 0 < s ((1 + r) / 2) r n) ->",
        "(forall n, (1 <= n <= k)%nat -> 0 < s ((1 + r) / 2) r n) ->",
    ),
    "run-line-bent": Definition(
        "Bounds",
        "minus_cosine_at d (scenes n) o a c = 1.",
        "minus_cosine_at d (scenes n) o a c <= 1.",
    ),
    "run-line-others-meet": Definition(
        "Bounds",
        "meets_next d radius (scenes n) o b t /\\",
        "distance d (later t (scenes n)) o b = radius o + radius b /\\",
    ),
    "run-line-in-the-plane": Definition("Bounds", "(1 <= d)%nat -> 0 < m", "(2 <= d)%nat -> 0 < m"),
    "run-end": Definition("Bounds", "0 < r <= 7 - 4", "0 < r <= 6 - 4"),
    "collapse-acute": Definition(
        "Classification", "(to at_T o c) <= 0.\n\n", "(to at_T o c) <= 1.\n\n"
    ),
    "collapse-at-no-r": Definition(
        "Classification", "time i j, 7 - 4 * sqrt 3 < r", "time i j, 8 - 4 * sqrt 3 < r"
    ),
    "collapse-in-a-line": Definition(
        "Classification", "forall d r s scenes time i j, 9",
        "forall r s scenes time i j, let d := 1%nat in 9",
    ),
    "collapse-later": Definition("Classification", "0 < t < T -> coll", "0 < t < T / 2 -> coll"),
    "collapse-slower": Definition("Classification", "6 <= size d s ->", "7 <= size d s ->"),
    "the-same-line": Definition("Line", "", ""),
    "line-of-no-Q": Definition("Line", "-> 0 < r -> distinct", "-> r < 0 -> distinct"),
    "line-parting": Definition("Line", "rate d s' i j = - r *", "rate d s' i j <= - r *"),
    "line-another-law": Definition(
        "Line", "velocity s b k + J / mass j", "velocity s b k - J / mass j"
    ),
    "line-equal-masses": Definition(
        "Line", "(1 + r) * mass b / (mass o + mass b)", "(1 + r) * mass b / (mass b + mass b)"
    ),
    "line-another-order": Definition(
        "Line", "Nat.even n then c else a in", "Nat.even n then a else c in"
    ),
    "line-others-meet": Definition(
        "Line", "radius i + radius k < distance d (later t s) i k",
        "0 < distance d (later t s) i k",
    ),
    "line-overlap": Definition(
        "Line", "a <> b -> radius a + radius b < distance", "a <> b -> 0 < distance"
    ),
    "line-in-the-plane": Definition(
        "Line", "Prop :=\n  forall d mass", "Prop :=\n  let d := 2%nat in forall mass"
    ),
    "line-slower": Definition(
        "Line", "share mass r o a * Q * (1 - Q) ->", "share mass r o a * Q * (1 - 2 * Q) ->"
    ),
    "line-time": Definition(
        "Line", "T <= (1 - Q) / (1 - 2 * Q) *", "T <= (1 - Q) / (1 - 2 * Q) ^ 2 *"
    ),
    "line-angle": Definition("Line", "(scenes n) o a c = 1) /\\", "(scenes n) o a c <= 1) /\\"),
    "line-touch": Definition(
        "Line", "distance d at_T o a = radius o", "distance d at_T o a >= radius o"
    ),
    "line-equal-later": Definition("Line", "(gap / closing)) 1 0.", "(gap / closing)) 1 1."),
    "the-same-three": Definition("ThreeBalls", "", ""),
    "three-of-no-r": Definition(
        "ThreeBalls", "(forall b, 0 < r b <= 1)", "(forall b, 0 < r b <= 0)"
    ),
    "three-inelastic": Definition(
        "ThreeBalls", "(forall b, 0 < r b <= 1)", "(forall b, 0 < r b < 1)"
    ),
    "three-of-no-speed": Definition("ThreeBalls", "0 < gap /\\ 0 < y /\\", "0 < gap /\\ y < 0 /\\"),
    "three-another-order": Definition("ThreeBalls", "then c else a.", "then a else c."),
    "three-one-restitution": Definition(
        "ThreeBalls", "parts d mass (r b) o b", "parts d mass (r c) o b"
    ),
    "three-equal-masses": Definition(
        "ThreeBalls", "mass b / (mass o + mass b)", "mass b / (mass b + mass b)"
    ),
    "three-equal-radii": Definition(
        "ThreeBalls", "(reach_of b / reach_of b')", "(reach_of b / reach_of b)"
    ),
    "three-in-the-plane": Definition(
        "ThreeBalls",
        "forall d mass radius r o a c w Y k E",
        "let d := 2%nat in forall mass radius r o a c w Y k E",
    ),
    "three-later": Definition("ThreeBalls", "T <= E c * closing", "T <= 2 * E c * closing"),
    "three-angle": Definition(
        "ThreeBalls", "at_T o a c - C_0) <= Theta.", "at_T o a c - C_0) <= 2 * Theta."
    ),
    "three-touch": Definition(
        "ThreeBalls", "distance d at_T o c = rad", "distance d at_T o c >= rad"
    ),
    "three-never": Definition("ThreeBalls", "Un_cv time T /\\ T <=", "T <="),
    "three-map": Definition("ThreeBalls", "(2 * fst p + rho", "(fst p + rho"),
    "three-map-stops": Definition(
        "ThreeBalls",
        "forall n, 0 < pace (alpha_of n)",
        "forall n, 0 <= pace (alpha_of n)",
    ),
    "three-stair": Definition("ThreeBalls", "(n <= S N)%nat", "(n <= S (S N))%nat"),
    "three-outer-pair": Definition(
        "ThreeBalls", "(radius a + radius c) ^ 2 <", "(radius a + radius c) ^ 2 <="
    ),
    "three-equal-later": Definition(
        "ThreeBalls", "B0 B2 s) C_0 Theta.", "B0 B2 s) C_0 (2 * Theta)."
    ),
    "law-another-ball": Definition("ThreeBalls", "radius z o c i y", "radius z o i c y"),
    "law-of-no-flight": Definition("ThreeBalls", "0 < kap /\\", "kap < 0 /\\"),
    "law-masses": Definition("ThreeBalls", "(1 + mass o / mass c)", "(1 + mass c / mass o)"),
    "law-angle": Definition("ThreeBalls", "(to x o c) = - C /\\", "(to x o c) = C /\\"),
    "law-outer-pair": Definition("ThreeBalls", "  0 < K_c + K_s - K_o", "  0 <= K_c + K_s - K_o"),
    "the-same-sandwich": Definition("Sandwich", "", ""),
    "sandwich-no-r": Definition("Sandwich", "0 < r /\\ 1 <= G", "r < 0 /\\ 1 <= G"),
    "sandwich-no-room": Definition("Sandwich", "0 < gap /\\ 0 < y", "0 < gap /\\ y < 0"),
    "sandwich-another-map": Definition("Sandwich", "(r * G) (inner n) end", "r (inner n) end"),
    "sandwich-another-order": Definition(
        "Sandwich", "w (last_ball B1 B2 n) / w (next", "w (next_ball B1 B2 n) / w (next"
    ),
    "sandwich-stops": Definition(
        "Sandwich", "forall n, 0 < pace alpha", "forall n, 0 <= pace alpha"
    ),
    "sandwich-faster": Definition(
        "Sandwich", "speed B1 <= w B1 - gain * y", "speed B1 <= w B1 - 2 * gain * y"
    ),
    "sandwich-angle": Definition("Sandwich", "* y <= Theta.", "* y <= Theta / 2."),
    "sandwich-later": Definition("Sandwich", "collapse d r s (G *", "collapse d r s (2 * G *"),
    "sandwich-in-the-plane": Definition(
        "Sandwich", "forall d r G slow", "let d := 2%nat in forall r G slow"
    ),
    "sandwich-stair": Definition("Sandwich", "(n <= S N)%nat", "(n <= S (S N))%nat"),
    "the-same-outside": Definition("Outside", "", ""),
    "outside-approaches": Definition("Outside", "rate d s i j < 0.", "rate d s i j <= 0."),
    "outside-never-strikes": Definition(
        "Outside", "distance d s i j = 1 /\\ rate", "distance d s i j < 1 /\\ rate"
    ),
    "outside-near": Definition("Outside", "zeta_of d s i j < 1 /\\", "zeta_of d s i j <= 1 /\\"),
    "outside-time": Definition(
        "Outside", "(1 + sqrt (1 - zeta_of", "(1 - sqrt (1 - zeta_of"
    ),
    "outside-another-map": Definition(
        "Outside", "(1 + r) / 2 * G * C_most.", "(1 + r) / 3 * G * C_most."
    ),
    "outside-another-ratio": Definition(
        "Outside", "(v (collides_with (S n)) / w", "(v (collides_with n) / w"
    ),
    "outside-stops-late": Definition("Outside", "rho p <= 0 \\/", "rho p < 0 \\/"),
    "outside-always-stops": Definition("Outside", "rho p ^ 2 <= load rho p.", "rho p ^ 2 <= 1."),
    "outside-floor": Definition("Outside", "(n < N)%nat -> let p", "(n <= N)%nat -> let p"),
    "outside-floor-from-above": Definition("Outside", "Q O <= Q_0 /\\", "Q O = Q_0 /\\"),
    "outside-floor-later": Definition("Outside", "(M <= N)%nat /\\", "(N <= M)%nat /\\"),
    "outside-no-r": Definition("Outside", "0 < r /\\ 1 <= G", "r < 0 /\\ 1 <= G"),
    "outside-decay": Definition("Outside", "(1 + r) / 2 * G < 1 /\\", "(1 + r) * G < 1 /\\"),
    "outside-no-gap": Definition("Outside", "0 < gap /\\ 0 < y /\\", "0 < gap /\\ y < 0 /\\"),
    "outside-speed": Definition(
        "Outside", "speed_at s B2 <= w B2 - gain * y", "speed_at s B2 <= w B2 - 2 * gain * y"
    ),
    "outside-angle": Definition(
        "Outside", "minus_cosine d s <= C_most - turning * y.", "minus_cosine d s <= 0."
    ),
    "outside-other-flight": Definition(
        "Outside", "Z t = later (t - time n) (Z (time n)))", "Z t = later 0 (Z (time n)))"
    ),
    "outside-another-order": Definition(
        "Outside", "(Z (time n))) B0 (collides_with n).", "(Z (time n))) B0 (collides_with (S n))."
    ),
    "outside-too-late": Definition("Outside", "T Z time (S (S N)).", "T Z time (S (S (S N)))."),
    "outside-no-trajectory": Definition(
        "Outside", "trajectory d r s T Z -> ~", "trajectory d r s T Z -> T < 0 -> ~"
    ),
    "outside-in-the-plane": Definition(
        "Outside",
        "outside_theorem : Prop :=\n  forall d r G",
        "outside_theorem : Prop :=\n  let d := 2%nat in forall r G",
    ),
    "outside-slow-collapse": Definition(
        "Outside", "~ collapse d r s by_time c", "by_time < 1 -> ~ collapse d r s by_time c"
    ),
    "matrix-entry": Definition("Spectrum", "- 59 * r - 1) / 64", "- 59 * r + 1) / 64"),
    "matrix-order": Definition(
        "Spectrum",
        "collided d r B1 B2 (collided d r B0 B2",
        "collided d r B0 B2 (collided d r B1 B2",
    ),
    "matrix-in-the-plane": Definition(
        "Spectrum", "Prop := forall d r s u e f, ", "Prop := forall r s u e f, let d := 2%nat in "
    ),
    "matrix-no-triangle": Definition(
        "Spectrum", "/\\ distance d s B1 B2 = 1.", "/\\ distance d s B1 B2 = 0."
    ),
    "spectrum-real": Definition("Spectrum", "0 < im /\\", "0 <= im /\\"),
    "spectrum-closed-disk": Definition("Spectrum", "im ^ 2 < 1 /\\", "im ^ 2 <= 1 /\\"),
    "spectrum-one-way": Definition(
        "Spectrum", "eigenvector r mu nu u v) <->", "eigenvector r mu nu u v) ->"
    ),
    "spectrum-some-r": Definition(
        "Spectrum",
        "spectrum_theorem : Prop := forall r, 0 < r < 1",
        "spectrum_theorem : Prop := forall r, 0 < r < 1 / 2",
    ),
    "spectrum-no-decay": Definition("Spectrum", "exists q, 0 < q < 1 /\\", "exists q, 0 < q /\\"),
}  # fmt: skip
#: The page that pins each of the eight, and the files with proofs on which it rests, with what they
#: prove: a theorem for each proposition.
PAGES = {
    "Classification": (
        "PinnedClassification",
        {
            "ClassificationProof": (
                "no_triangle", "least_angle", "least_angle_any_radii", "never_any_radii", "never",
                "bounded_impulse", "no_spin", "comes_to_rest", "never_with_spin", "never_outward",
            ),
            "Turning": ("never_turning",),
            "Finite": ("finite_or_endless",),
        },
    ),
    "Bounds": (
        "PinnedBounds",
        {
            "Impulse": ("exchange_theorem",),
            "AlternatingRuns": ("run_theorem", "run_on_a_line", "run_without_end"),
        },
    ),
    "Line": ("PinnedLine", {"LineProof": ("line_theorem", "equal_on_a_line")}),
    "ThreeBalls": (
        "PinnedThreeBalls",
        {
            "ThreeBallsMap": ("stair_theorem",),
            "ThreeBallsCollapse": ("three_balls_theorem", "three_equal_balls"),
            "BallsFlowStep": ("law_theorem",),
        },
    ),
    "Sandwich": (
        "PinnedSandwich",
        {"SandwichProof": ("sandwich_theorem", "inner_stair_theorem")},
    ),
    "Outside": (
        "PinnedOutside",
        {
            "OutsideStep": ("next_theorem",),
            "OutsideProof": ("outside_theorem", "floor_theorem", "no_collapse_theorem"),
        },
    ),
    "PrintedSign": ("PinnedPrintedSign", {"PrintedSignProof": ("printed_sign_theorem",)}),
    "Spectrum": ("PinnedSpectrum", {"SpectrumProof": ()}),
}  # fmt: skip

#: In PinnedAlexander.v: a weaker hypothesis, another sign, another order; none has a proof.
ALEXANDER = {
    name: Definition("PinnedAlexander", old, new)
    for name, (old, new) in {
        "the-same": ("", ""),
        "collision-time": ("kappa * (2 + gap) / ((1 + gap)", "kappa * (2 - gap) / ((1 + gap)"),
        "collision-approach": ("dot d n_c V_c = - y ->", "dot d n_c V_c = y ->"),
        "collision-restitution": ("(1 + e) * U * x_c i in", "(1 - e) * U * x_c i in"),
        "collision-angle": ("(1 + gap) * - dot d x_c m_s", "(1 + gap) * dot d x_c m_s"),
        "collision-gap": ("(E - 1) / (p * y) ^ 2", "(E - 1) / p ^ 2"),
        "order-swapped": ("0 < q <= Q /\\", "0 < Q <= q /\\"),
        "order-no-image": ("/\\ 0 < p_ Q K.", "/\\ 0 <= p_ Q K."),
        "order-speed": ("0 <= B /\\", "B <= 0 /\\"),
        "order-strict": ("0 < kappa' <= K'", "0 < kappa' < K'"),
        "order-power": ("(P / p) ^ 2 /\\", "(P / p) ^ 3 /\\"),
        "growth-faster": ("c * M <= 2 * (m * l)", "c * M <= 4 * (m * l)"),
        "beneath-faster": ("(1 - m * (1 - L)", "(1 - 3 * m * (1 - L)"),
        "orbits-far": ("80 * K ^ 3 * g", "80 * K ^ 2 * g"),
        "orbits-faster": ("(1 + c / 2) ^ n", "(1 + c) ^ n"),
        "orbits-distance": ("0 <= H (S n) <=", "H (S n) <= H (S n) <="),
        "turn-one-pair": ("q'' := f / p'", "q'' := e / p'"),
        "turn-sign": ("e * (D - e - z) /", "e * (D - e + z) /"),
        "trap-threshold": ("e + f + t + t ^ 2 < D", "e + f + t < D"),
        "trap-never": ("kappa 1%nat <= kappa O ->", "0 <= kappa O ->"),
        "threshold-above": ("(t <= z ->", "(0 <= z ->"),
        "threshold-below": ("(z <= t ->", "(z <= 2 * t ->"),
        "stays-error": ("(1 - t + L) / (1 - m)", "L / (1 - m)"),
    }.items()
}  # fmt: skip
#: In the files of scenes, where each changed number and each other order is refused.
SCENE, CUT, LATER = "Scene_nearly_aligned", "Scene_cut", "Scene_turning_later"
SCENES = {
    "cut-the-same": ("", ""),
    "scene-velocity": ("- (7 / 5)", "- (8 / 5)"),
    "scene-order": (
        "[(Theorem1.B0, Theorem1.B1, the_time_1); (Theorem1.B0, Theorem1.B2, the_time_2)]",
        "[(Theorem1.B0, Theorem1.B2, the_time_1); (Theorem1.B0, Theorem1.B1, the_time_2)]",
    ),
    "scene-next-ball": (
        "the_time_2)] Theorem1.B0 Theorem1.B2 Theorem1.B1",
        "the_time_2)] Theorem1.B0 Theorem1.B1 Theorem1.B2",
    ),
    "scene-latest": ("(8953 / 1250000) (9753 / 1250000)", "(8953 / 1250000) (9752 / 1250000)"),
    "scene-angle": ("(99483 / 100000) (249719 / 250000)", "(99484 / 100000) (249719 / 250000)"),
    # Twice the time until the flight is cut: in what is said, and in the scene there.
    "cut-time": ("the_time_1 : R := (", "the_time_1 : R := 2 * ("),
    "cut-scene": ("scene_drift_0_1 : Theorem1.scene := Theorem1.later (",
        "scene_drift_0_1 : Theorem1.scene := Theorem1.later (2 * "),
    "later-no-collision": ("[(Theorem1.B0, Theorem1.B2, the_time_1)]", "[]"),
    "later-another-criterion": ("finite_by_turning", "finite_by_receding"),
}  # fmt: skip

FALSE = "Theorem proved : False. Proof. exact wrong. Qed.\n"
#: Whole files that prove False, each with a word that the judge has to say.
ASSUMPTIONS = {
    "axioms": ("Axioms wrong : False.\n", "wrong"),
    "axiom-with-digits": ("Axiom lemma1 : False.\nDefinition wrong := lemma1.\n", "lemma1"),
    "parameter": ("Parameters wrong : False.\n", "wrong"),
    "hypothesis": ("Hypothesis wrong : False.\n", "wrong"),
    "variable": ("Variable wrong : False.\n", "wrong"),
    "conjecture": ("Conjecture wrong : False.\n", "wrong"),
    "context": ("Context (wrong : False).\n", "wrong"),
    "admitted": ("Lemma wrong : False. Proof. Admitted.\n", "wrong"),
    "declared-instance": (
        "Class C := c : False.\nDeclare Instance i : C.\nDefinition wrong : False := i.\n",
        "Verify.Tampered.i",
    ),
    "module-type": (
        "Module Type T. Parameter wrong : False. End T.\nDeclare Module M : T.\nImport M.\n",
        "Tampered.M.wrong",
    ),
    "guard": (
        ("Unset Guard Checking.\nFixpoint loop (n : nat) {struct n} : False := loop n.\n"
        "Definition wrong := loop 0.\n"),
        "loop",
    ),
    "bypassed-guard": (
        ("#[bypass_check(guard)] Fixpoint loop (n : nat) {struct n} : False := loop n.\n"
        "Definition wrong := loop 0.\n"),
        "loop",
    ),
    "positivity": (
        ("Unset Positivity Checking.\nInductive bad : Set := Bad (f : bad -> False).\n"
        "Definition no (b : bad) : False := match b with Bad f => f b end.\n"
        "Definition wrong : False := no (Bad no).\n"),
        "bad",
    ),
    "bypassed-positivity": (
        ("#[bypass_check(positivity)] Inductive bad : Set := Bad (f : bad -> False).\n"
        "Definition no (b : bad) : False := match b with Bad f => f b end.\n"
        "Definition wrong : False := no (Bad no).\n"),
        "bad",
    ),
    "universes": (
        ("Require Import Hurkens.\nUnset Universe Checking.\n"
        "Definition small (A : Type) : Type := A.\n"
        "Definition wrong : False := TypeNeqSmallType.paradox Type eq_refl.\n"),
        "wrong",
    ),
    "type-in-type": (
        ("Require Import Hurkens.\n"
        "Definition wrong : False := TypeNeqSmallType.paradox Type eq_refl.\n"),
        "wrong",
    ),
    "exported-option": (
        ("#[export] Unset Guard Checking.\nUnset Guard Checking.\n"
        "Fixpoint loop (n : nat) {struct n} : False := loop n.\nDefinition wrong := loop 0.\n"),
        "loop",
    ),
    "loaded": ('Load "Evil".\n', "wrong"),
}  # fmt: skip
#: What is no sentence of ours, whether or not something false follows.
SENTENCES = (
    'Declare ML Module "ltac_plugin".', 'Add ML Path ".".', 'Add LoadPath "." as Coq.',
    'Redirect "assumed" Print nat.', "#[global] Unset Guard Checking.", "Drop.",
    "Set Universe Polymorphism.", "Global Set Printing Width 3.", "Admit Obligations.",
    "Program Definition x := 0.",
    "Primitive add := #int63_add.", "Register nat as core.nat.", "Coercion f : A >-> B.",
    'Infix "<=" := Rlt.', 'Notation "x <= y" := (Rlt x y).', 'Extract Constant f => "x".',
    "Canonical Structure x := y.", "Include T.", "Fail Lemma x : False.",
    "Obligation Tactic := idtac.", "Hint Resolve x : core.", "Existing Instance x.",
    "Proof using.", "Guarded.",
    "Section A. End A. Variable x : False.", "(* x *) Axiom (* y *) x : False.",
    "Lemma x : True. Proof. trivial. Axiom y : False. Qed.", "Reset Initial.", "Abort.",
    "Lemma x : True. Proof. - { trivial. } Admitted.", "Lemma x : True. Proof. 1: Admitted.",
    "Notation theorem_1 := True.", "Section A. Notation theorem_1 := True. End A.",
    'Section A. Notation "x <= y" := True. End A.', "Module Meaning := Fake.", "Opaque plus.",
    "Open Scope type_scope.",
    'Fixpoint f (n : nat) : nat := n where "x <= y" := (f x) : R_scope.',
    'Inductive f (x y : R) : Prop := F where"x <= y" := (f x y).',
    "Record x := X { f :> bool }.", "Inductive x := X (f :> bool).",
    "Lemma x : True. Proof. refine ?[a]. [a]: { Axiom y : False. trivial. } Qed.",
    "Lemma x : True. Proof. refine ?[a']. [ a' ]:{ Axiom y : False. trivial. } Qed.",
)  # fmt: skip


def run(directory: Path, *command: str) -> subprocess.CompletedProcess[str]:
    """A command there; its two streams together."""
    return subprocess.run(
        command, cwd=directory, text=True, stdout=subprocess.PIPE, stderr=subprocess.STDOUT,
        timeout=300,
    )  # fmt: skip


def coqc(directory: Path, name: str, *options: str) -> subprocess.CompletedProcess[str]:
    """A file compiled."""
    return run(directory, "coqc", "-q", *options, "-R", ".", "Verify", f"{name}.v")


def written(directory: Path, name: str, text: str) -> None:
    """A file for Coq instead of a compiled one."""
    for suffix in ("v", "vo"):
        (directory / f"{name}.{suffix}").unlink(missing_ok=True)
    (directory / f"{name}.v").write_text(text)


def modules(parts: dict[str, str]) -> dict[str, str]:
    """Files of ours as modules of one text; which axioms they use is not asked."""

    def required(match: re.Match[str]) -> str:
        names = match[2].split()
        others = [name for name in names if name not in parts]
        here = [name for name in names if name in parts]
        lines = f"From Verify Require {match[1] or ''}{' '.join(others)}." if others else ""
        return lines + (f" Import {' '.join(here)}." if match[1] and here else "")

    sentence = re.compile(r"From Verify Require (Import )?([\w\s]+)\.")
    silent = {
        name: re.sub("^Print Assumptions .*", "", text, flags=re.MULTILINE)
        for name, text in parts.items()
    }
    # What is compiled comes first: else it would take the short names of what is changed.
    lines = [sentence.findall(text) for text in parts.values()]
    needed = {name for found in lines for _, names in found for name in names.split()} - {*parts}
    first = f"From Verify Require {' '.join(sorted(needed))}.\n" if needed else ""
    texts = {
        name: f"Module {name}.\n{sentence.sub(required, text)}\nEnd {name}.\n"
        for name, text in silent.items()
    }
    name, text = next(iter(texts.items()))
    return {**texts, name: first + text}


def first_that_fails(directory: Path, parts: dict[str, str]) -> str:
    """The first of some files that does not compile, each beside those before it; or empty."""
    return session(directory).first_that_fails(modules(parts))


def changed(way: Definition) -> str:
    """The text of the file with a change, which has to be possible at one place only."""
    text = (SOURCES / f"{way.file}.v").read_text()
    if way.old and text.count(way.old) != 1:
        raise ValueError(f"{way.old}: {text.count(way.old)} times in {way.file}.v")
    return text.replace(way.old, way.new) if way.old else text


def pinned(file: str, text: str, directory: Path) -> bool:
    """Whether the page that pins a file is content with this text; all else has to compile."""
    page = f"Pinned{file.removeprefix('Theorem1')}"
    source = (SOURCES / f"{page}.v").read_text()
    parts = {file: text} | ({"AllProved": STUB} if page == "Pinned" else {})
    failed = first_that_fails(directory, {**parts, page: source.replace("Verify.Meaning", file)})
    if failed not in ("", page):
        raise ValueError(f"{failed} does not compile")
    return not failed


def definition(name: str, directory: Path) -> bool:
    """Whether the page that pins a definition sees another one."""
    way = DEFINITIONS[name]
    return not pinned(way.file, changed(way), directory)


def the_same_definition(name: str, directory: Path) -> bool:
    """Whether a page is content with the file that it pins."""
    return pinned(name, (SOURCES / f"{name}.v").read_text(), directory)


def spelled(name: str, directory: Path) -> bool:
    """Whether the page of sentences sees another definition, and is content with the same."""
    way, end, theorem = SPELLED[name]
    page = (SOURCES / "Sentences.v").read_text()
    head = page[page.index("From Verify Require Import") : page.index("(* --- hard-spheres")]
    head = re.sub(r"^From Verify Require (?!Import).*\n", "", head, flags=re.MULTILINE)
    proof = re.search(rf"^Definition {theorem} .*?^Qed\.$", page, re.DOTALL | re.MULTILINE)
    assert proof
    last = f"From Verify Require {way.file}.\n{head}{proof[0]}\n"
    texts = ((SOURCES / f"{way.file}.v").read_text(), changed(way))
    same, other = (
        first_that_fails(directory, {way.file: text[: text.index(end)], "Sentences": last})
        for text in texts
    )
    if same:
        raise ValueError(f"{same} does not compile")
    return other == "Sentences"


def printed_set(name: str, directory: Path) -> bool:
    """Whether the page of the printed set sees another definition, and is content with the same."""
    way, page = PRINTED[name], "PinnedPrintedSet"
    numbers, definitions, last = (
        changed(way if way.file == file else Definition(file, "", ""))
        for file in ("FromNumbers", "PrintedSet", page)
    )
    numbers = numbers.split("\nDefinition numbers_context")[0]
    parts = {"FromNumbers": numbers, "PrintedSet": definitions}
    parts |= {"PrintedProof": PRINTED_STUB, page: last}
    failed = first_that_fails(directory, parts)
    if failed not in ("", page):
        raise ValueError(f"{failed} does not compile")
    return bool(failed) == (name != "the-same")


def stub(page: str, file: str, propositions: tuple[str, ...]) -> str:
    """A file that proves from nothing what the page says."""
    lines = [f"From Verify Require {page}."]
    for name in propositions:
        lines.append(f"Axioms lemma_{name} : {page}.{name}.")
        lines.append(f"Definition {name}_holds := lemma_{name}.")
    if file == "SpectrumProof":
        for name, parts in (("matrix_proved", MATRIX), ("spectrum_proved", VALUES)):
            lines.append(f"Axioms lemma_{name} : {conjunction(f'{page}.', parts)}.")
            lines.append(f"Definition {name} := lemma_{name}.")
    return "\n".join([*lines, ""])


def other_page(name: str, directory: Path) -> bool:
    """Whether a page sees another definition in its file, and is content with the same."""
    way = OTHERS[name]
    page, proofs = PAGES[way.file]
    parts = {way.file: changed(way)}
    parts |= {file: stub(way.file, file, names) for file, names in proofs.items()}
    failed = first_that_fails(directory, parts | {page: (SOURCES / f"{page}.v").read_text()})
    if failed not in ("", page):
        raise ValueError(f"{failed} does not compile")
    return bool(failed) != name.startswith("the-same")


def alexander(name: str, directory: Path) -> bool:
    """Whether the proofs do not fit another page, and fit the same."""
    page, proofs = "PinnedAlexander", "AlexanderProof"
    parts = {page: changed(ALEXANDER[name]), proofs: (SOURCES / f"{proofs}.v").read_text()}
    failed = first_that_fails(directory, parts)
    if failed not in ("", proofs):
        raise ValueError(f"{failed} does not compile")
    return bool(failed) == (name != "the-same")


def unknown(output: str) -> list[str]:
    """What Coq says of assumptions that is not in the committed file."""
    known = {line.strip() for line in ASSUMED.read_text().splitlines()}
    lines = [line.strip() for line in output.splitlines() if not line.endswith(": <none>")]
    return [line for line in lines if line not in known]


def rests_on(directory: Path, text: str, *options: str) -> list[str]:
    """What is new in the summary of `coqchk` about a file with this text."""
    written(directory, "Tampered", text)
    done = coqc(directory, "Tampered", *options)
    if done.returncode:
        raise ValueError(f"it does not compile: {done.stdout}")
    arguments = ("-silent", "-o", "-bytecode-compiler", "yes", "-R", ".", "Verify")
    return unknown(run(directory, "coqchk", *arguments, "-norec", "Verify.Tampered").stdout)


def assumption(name: str, directory: Path) -> bool:
    """Whether `coqchk` sees what a proof of False rests on, and the list of commands the line."""
    text, word = ASSUMPTIONS[name]
    (directory / "Evil.v").write_text("Axioms wrong : False.\n")
    options = ["-type-in-type"] if name == "type-in-type" else []
    found = rests_on(directory, text + FALSE, *options)
    return any(word in line for line in found) and (bool(options) or bool(unexpected(text)))


def no_assumption(_: str, directory: Path) -> bool:
    """Whether nothing is said about a file that has nothing wrong."""
    text = "Theorem proved : True. Proof. exact I. Qed.\n"
    return not rests_on(directory, text) and not unexpected(text)


ONE, CITING = ROOT / "examples/interval", ROOT / "examples/mean-applied"
NOTHING = {
    "the-same": ("", ""),
    "closed-without-theorems": ("Closed", ""),
    "exported-nothing": (module(ONE), ""),
    "exported-another-theorem": (
        module(ONE),
        (
            f"From Verify Require {module(ROOT / 'examples/root')}.\n"
            f"Definition the_statement := {module(ROOT / 'examples/root')}.the_statement.\n"
            "Theorem proved : True. Proof. exact I. Qed.\n"
        ),
    ),
}


def nothing(name: str, directory: Path) -> bool:
    """Whether the theorems that are asked for are missed, where they are not there."""
    file, text = NOTHING[name]
    if file:
        written(directory, file, text)
        coqc(directory, file)
    asked = everything([ONE, CITING]).rpartition("Print Assumptions")[0]
    written(directory, "Everything", asked)
    done = coqc(directory, "Everything")
    return (done.returncode == 0) == (name == "the-same")


def another_statement(name: str, directory: Path) -> bool:
    """Whether a proof of another statement than that of the folder is seen."""
    own = module(ONE)
    if name == "another-statement":
        written(directory, own, (directory / f"{module(ROOT / 'examples/root')}.v").read_text())
    elif name == "another-word":
        text = (directory / f"{own}.v").read_text()
        head = "Open Scope positive_scope.\n"
        written(directory, own, text.replace(head, f"{head}Definition AtMost := Less.\n"))
    if name != "the-same" and coqc(directory, own).returncode:
        raise ValueError("it does not compile")
    written(directory, "Printed", printed([own]))
    try:
        said_by_coq(ONE, coqc(directory, "Printed").stdout, {})
    except (AnotherError, KeyError):
        return name != "the-same"
    return name == "the-same"


def another_scene(name: str, directory: Path) -> bool:
    """Whether a scene with another number, or another order of collisions, is refused."""
    (old, new), kind = SCENES[name], name.partition("-")[0]
    file = {"cut": CUT, "later": LATER}.get(kind, SCENE)
    text = (directory / f"{file}.v").read_text()
    if old and text.count(old) != 1:
        raise ValueError(f"{old}: {text.count(old)} times in {file}.v")
    written(directory, file, text.replace(old, new) if old else text)
    return (coqc(directory, file).returncode == 0) == name.endswith("the-same")


Way = tuple[str, Callable[[str, Path], bool]]
#: These ask the one toplevel, and write no file.
IN_SESSION = (definition, spelled, printed_set, other_page, alexander, the_same_definition)


def ways() -> list[Way]:
    """Each with what says whether it is seen; and where there is nothing to see, that."""
    found: list[Way] = [(name, definition) for name in DEFINITIONS]
    found += [(name, spelled) for name in SPELLED]
    found += [(name, printed_set) for name in PRINTED]
    found += [(name, other_page) for name in OTHERS]
    found += [(name, alexander) for name in ALEXANDER]
    found += [(name, assumption) for name in ASSUMPTIONS]
    found += [(name, nothing) for name in NOTHING]
    found += [(name, another_scene) for name in SCENES]
    statements = ("another-statement", "another-word", "the-same")
    found += [(name, another_statement) for name in statements]
    found += [(name, the_same_definition) for name in ("Theorem1", "Meaning", "Separatrix")]
    return [*found, ("nothing-wrong", no_assumption)]


def tried(source: Path, way: Way) -> str:
    """A line if a way is not seen."""
    name, judge = way
    with tempfile.TemporaryDirectory() as path:
        directory = source if judge in IN_SESSION else Path(path)
        for file in source.glob("*.v*") if directory != source else ():
            if file.suffix in (".v", ".vo"):
                (directory / file.name).symlink_to(file)
        try:
            return "" if judge(name, directory) else f"NOT SEEN {name} ({judge.__name__})"
        except ValueError as error:
            return f"NOT TRIED {name} ({judge.__name__}): {error}"


def main(source: Path) -> int:
    """Try each of them on a copy."""
    lines = [f"NOT SEEN {text}" for text in SENTENCES if not unexpected(text)]
    lines += filter(None, (tried(source, way) for way in ways()))
    for line in lines:
        print(line)
    print(f"{len(ways()) + len(SENTENCES)} ways to tamper, {len(lines)} not seen")
    return bool(lines)


if __name__ == "__main__":
    sys.exit(main(Path(sys.argv[1]).resolve()))
