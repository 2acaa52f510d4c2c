"""What the prose of the pages says in labels, signs and pieces of code: see `tests.facts`."""

from __future__ import annotations

import re
from fractions import Fraction

from mpmath import mpf

from docs.generated import point
from tests import watched
from tests.facts import (
    ENTRIES,
    alike,
    between,
    file,
    givens,
    half,
    has,
    in_line,
    limit_map,
    names_of_rows,
    number,
    refuses,
    row,
    said,
    sides,
    so,
    true,
)
from verify.paper.glossary import LETTERS
from verify.views.classification import THEOREMS


def meaning(letter: str) -> str:
    """What the program says that a letter stands for."""
    (found,) = (entry.says for entry in LETTERS if entry.letter == letter)
    return found


# --- labels of the paper --------------------------------------------------------------------------

CONDITION = "EQUATSS4.1Recurrence_Cnd"
THEOREM = number("THEORSS4.1ExistenCollapse")
HYPOTHESIS = number("EQUATSS4.1ThExiCondiTheta")
START = number("EQUATSS4.1DescrDoIniColla")
NEXT_ZETA = number(f"{CONDITION}4")
LEAST_ANGLE = number("EQUATSS3.4ZKCl1CondiExist")
STABLE = number("EQUATSS3.4ZKCl2CondiStabi")
X_N, X_NEXT = number("EQUATSS4.1DefinReste_x_n_"), number("EQUATSS4.1Cntrlx_n+1Ameli")
for label in (THEOREM, HYPOTHESIS, START, NEXT_ZETA):
    said("", "{}", label)
for page in ("README.md", "docs/explanation/proof.md", "docs/tutorials/referee.md"):
    said(page, "between {} and {}", X_N, X_NEXT)
so("", "Cnd1 to Cnd10", has("verify/paper/theorem1.toml", "conditions Cnd1 to Cnd10"))

# --- the two readings of the hypothesis -----------------------------------------------------------

PRINTED = "< 2r^(1/3)(1+r^(1/3))/(1+r)" in row("theorem1-r-3-100", "angle-as-printed")
MEANT = "> 2r^(1/3)(1+r^(1/3))/(1+r)" in row("theorem1-r-3-100", "stability")
#: What the paper leaves open of its set, as the certificate has it.
OPEN = "with d_0 > 0 and eta_s > 0" in file("certificates/printed-set/report.md")

P = "README.md"
so(P, "With `<`, as printed", PRINTED)
so(P, "With `>`, for all parameters", MEANT)
so(P, "Coq proves Theorem 1, with `>`", MEANT)
so(P, "As printed, with <:", PRINTED)
so(P, "gap (d₀ > 0) collapses", OPEN)
so(P, "separates (η_s > 0)", OPEN)
LAW = has("verify/paper/glossary.py", "multiplies the normal velocity by -r")
so(P, "relative velocity by -r.", LAW)
so("docs/reference/glossary.md", "relative velocity by -r.", LAW)
so("docs/tutorials/three-particles.md", "relative velocity by -r:", LAW)
so("", "`-v`", has("verify/cli/options.py", "-v, --verbose"))
P = "docs/index.md"
so(P, "As printed, with < in (4.10),", PRINTED)
so(P, "read with > it holds", MEANT)
P = "docs/howto/cite.md"
so(P, "the hypothesis (4.10) read with > and", MEANT)
P = "docs/explanation/separatrix.md"
so(P, "read with >.", MEANT)
P = "docs/tutorials/referee.md"
so(P, "with <: refuted", PRINTED)
so(P, "misprinted. With `<` the", PRINTED)
so(P, "*With >, its set as printed: proved", MEANT)
so(P, "d₀ > 0 and η_s > 0,", OPEN)
so(P, "(η_s > 0 is", OPEN)
so(P, "a gap d₀ > 0 is left", OPEN)
said(P, "own condition {} for", LEAST_ANGLE)
said(P, "same condition, {}, has", STABLE)
so(P, "has >, and only > makes", MEANT)
so(P, "false with < in (4.10), as printed. With >,", PRINTED, MEANT)
CND9 = r"Cnd9 implies \|x_n\| ≤ (V₀/V₁)" in row("theorem1-r-3-100", "zeta-x-bound")
so(P, "|x_n| ≤ δ_x,", CND9)

P = "docs/explanation/proof.md"
so(P, "has `<` where `>` is meant", PRINTED, MEANT)
said(P, "quotes the same bound in {}", LEAST_ANGLE)
so(P, "*With `>`, the", MEANT)
so(P, "d₀ > 0 and η_s > 0, with", OPEN)
so(P, "as printed (with <) is", PRINTED)
so(P, "below φ⁻ + X", has("verify/paper/printed_set.toml", "phi_minus + x_most"))
so(P, "|cos θ - cos θ₀| ≤ Θ/6;", has("verify/coq/PinnedPrintedSet.v", "- c) <= Theta / 6"))
so(P, "x_n = φ₁ - φ⁻", meaning("x_n") == "η_{s,n}/(-η_{c,n}) = φ⁻ + x_n")
so(P, "|x_n| ≤ δ_x,", CND9)
STEP = "certificates/step/report.md"
SAYS = {f"Cnd{n}": number(f"{CONDITION}{n}") for n in range(1, 11)}
so(P, "| Cnd1, Cnd2 | the next", has(STEP, "| `Cnd1` | 0 < -η_c |", "| `Cnd2` | -η_c ≤ C_ηⁿ"))
so(P, "| Cnd3, Cnd4 |", has(STEP, "| `Cnd3` | 0 < 1 - d·(2 + d)", "| `Cnd4` | d·(2 + d)"))
so(P, "ζ_n ≤ ζ̄ |", "ζ' ≤ ζ̄ |" in row("step", "next-Cnd4"))
so(P, "| Cnd5, Cnd6, Cnd7 |", SAYS["Cnd5"] == "(4.49)", SAYS["Cnd6"] in row("step", "next-A-upper"))
so(P, "| Cnd8 | the angle", SAYS["Cnd8"] in row("step", "next-Cnd8-upper"))
so(
    P,
    "| Cnd9, Cnd10 |",
    SAYS["Cnd9"] in row("step", "next-Cnd9-upper"),
    SAYS["Cnd10"] in row("step", "angle-upper"),
)
so(P, "it has Cnd9,", CND9)
so(P, "Sections 1 to 4.1:", has("verify/paper/sections_1_to_4.toml", "Sections 1 to 4.1"))
so(
    P,
    "Sections 4.1, 4.2 and 5 for",
    has("verify/paper/spectrum.toml", "Section 5, its appendix and Sections 4.1-4.2"),
)
flight, tangential, rate = (
    number(f"PROPOSS3.{name}")
    for name in ("2SommaCompNormlV", "3AsympCompa__I__", "4CLineConveNorma")
)
said(P, "proof of {} forgets", flight)
said(P, "last claim of {} fails", tangential)
said(P, "convergence in {} is", rate)

# --- docs/explanation -----------------------------------------------------------------------------

P = "docs/explanation/findings.md"
so(P, "Cnd9 *implies*", CND9)
so(P, "| Cnd9 is", CND9)
so(P, "that Cnd9 implies it is not", CND9)
so(P, r"\|x_n\| ≤ δ_x,", CND9)
so(P, "| Cnd8, summed,", has("verify/paper/theorem1.toml", "Cnd8"))
so(P, "(Cnd8, summed,", has("verify/paper/theorem1.toml", "Cnd8"))
so(P, "max(d_n, 2ζ_n)/δ₂ ≤ h₄δ_x/2", "≤ h₄δ_x/2" in row("theorem1-r-3-100", "x-term-1-d"))
so(P, "with < the second ratio", PRINTED)
so(P, f"{STABLE} has >.", MEANT)
so(P, "literally, < makes", PRINTED)
so(P, "| Cnd6 and Cnd7 give", "Cnd6" in row("theorem1-r-3-100", "Cnd5-lower-as-printed"))
so(P, "last term has - | ≤, and + |", row("step-printed", "angle-sign"))
so(P, "x_n < 0 |", row("step-printed", "term-2-sign"))
so(P, "r < r_stabi ensures", "r < r_stabi" in row("theorem1-r-3-100", "r_stabi-gives-fixed-points"))
so(P, "with >, as it is meant,", MEANT)
so(P, "which < allows", PRINTED)
so(P, "## Sections 1 to 4.1", has("verify/paper/sections_1_to_4.toml", "Sections 1 to 4.1"))
so(P, "which Section 4 includes", number("EQUATSS4.1SysteDynamColSp"))
for text in ("rate of {}. Its", "the rate of {} has r"):
    said(P, text, rate)
said(P, "basis of {} is stated", number("EQUATSS3.5MatrixAlim_ResF"))
for folder, names in {
    "theorem1-r-3-100": "set-interior zeta-x-bound zeta-total final-angle y-term-3 x-term-1-d "
    "norm-law-as-printed second-assumption-as-printed phi-minus-called-unstable d-index "
    "Cnd5-lower-as-printed zeta-time-square angle-sign init-zeta-bound-2 CndT-as-printed "
    "r_stabi-gives-fixed-points angle-absorbed angle-as-printed",
    "step-printed": "term-2-sign",
    "elsewhere": "flight-forgotten tangential-large window-same distance-half-printed "
    "change-bound dimension-less",
}.items():
    for name in names.split():
        (label,) = {*re.findall(r"\| (\([0-9.]+\)|[A-Z][a-z]+ [0-9]+) `", row(folder, name))}
        said(P, f"`{name}` {label} |", by=name + label)
so(
    P,
    "## Sections 4.2 and 5",
    has("verify/paper/spectrum.toml", "Section 5, its appendix and Sections 4.1-4.2"),
)
so(P, "is right with <.", "ω₂⊥·ω₁" in row("spectrum", "matrix-stated"))
so(P, "> is printed between equal", row("spectrum", "cone-x-bound-2"))

P = "docs/explanation/coq.md"
V = "verify/coq/Theorem1.v"
so(P, "`touch_1`, `touch_2`", has(V, "touch_1 :", "touch_2 :"))
so(
    P,
    "they are if r > 7 - 4√3; if r > 9 - 4√5 and the",
    has("verify/coq/PinnedClassification.v", "7 - 4 * sqrt 3 < r \\/ 9 - 4 * sqrt 5 < r /\\"),
)
B = "verify/coq/PinnedBounds.v"
so(
    P,
    "A ≤ 0 always, L = 0, and the",
    has(
        "verify/coq/PinnedClassification.v",
        "over_pairs mass (rate d (places n) (velocities n)) <= 0",
        "over_pairs mass (moment (places n) (velocities n) k l) = 0",
    ),
)
so(P, "the balls 0, …, `last`", has(B, "(i n <= last)%nat /\\ (j n <= last)%nat"))
so(P, "Σσ J ≤ R e - A, as", has(B, "sum_f_R0 (fun m => sigma (i m) (j m) * J m) n <="))
so(
    P,
    "s₀ = 0, s₁ = 1, s_{n+2} = a s_{n+1} - r s_n",
    has(B, "s 0%nat = 0 /\\ s 1%nat = 1 /\\ forall n, s (S (S n)) = a * s (S n) - r * s n"),
)
so(
    P,
    "if (1+r)/2 (-cos θ_n) ≤ a for n from 2 to k-1, then s_n > 0 for n from 1 to k-1",
    has(B, "(2 <= n < k)%nat -> (1 + r) / 2 *", "forall n, (1 <= n < k)%nat -> 0 < s n"),
)
so(P, "with a = (1+r)/2 there", has(B, "compares ((1 + r) / 2) r s -> (forall n"))
so(P, "for 0 < r ≤ 7 - 4√3 and", has(B, "0 < r <= 7 - 4 * sqrt 3 -> compares ((1 + r) / 2) r s"))
so(
    "docs/explanation/classification.md",
    "for every r < 1 there",
    has("verify/paper/classification_of_balls.toml", "bead-exists:"),
)
so(
    "docs/explanation/classification.md",
    "needs r < 9 - 4√5",
    row("theorem1-r-3-100", "r-below-stabi"),
)
said(P, "collision law {}: with", number("EQUATSS2.1_Loi_de_Newton_"))
so(
    P,
    "v_i + Jω and v_j becomes v_j - Jω",
    has(V, "velocity s b k + J * omega k"),
    has(V, "velocity s b k - J * omega k"),
)
so(P, "the time t > 0, i", has(V, "after_a_time : 0 < t;"))
so(P, "`admissible r c V_0 delta_theta`", has(V, "admissible r c V_0 delta_theta"))
so(P, "(4.10) with >, written", MEANT)
DELTA_X, ETA_BAR, D_BAR = (
    number(f"EQUATSS4.1{name}")
    for name in ("DefinDeltxDelty", "DefinBorne_Eta_", "DefinBorne_d_0_")
)
said(P, "| {} with the additional", DELTA_X)
said(P, "{} to {} with the changes", ETA_BAR, D_BAR)
said(P, "{} to {} as printed;", DELTA_X, START)
so(P, "`initial d s d_0 y`", has(V, "Record initial (d : nat) (s : scene) (d_0 y : R)"))
so(P, r"\|(-cos θ) - c\| ≤", has(V, "Rabs (minus_cosine d s - c) <= Delta_theta / 4"))
so(P, "included, with > |", MEANT)
so(P, "as it is printed, with > in", MEANT)
so(P, '"post-collisional" is η_s > 0; that a gap is left (d₀ > 0)', OPEN)
so(P, "hypotheses with >, and", MEANT)
so(P, "theorem with `<` in", PRINTED)
so(
    P,
    r"\|(-cos θ̄) - c\| ≤ `tolerance`;",
    has("verify/coq/PinnedPrintedSign.v", "Rabs (minus_cosine d at_T - c) <= tolerance"),
)
said(P, "| {} and {} as printed,", number("EQUATSS4.1ThExiCondi_r_1_"), HYPOTHESIS)
so(
    P,
    "`hypotheses_as_printed r theta_0 delta_theta`",
    has("verify/coq/PinnedPrintedSign.v", "hypotheses_as_printed r theta_0 delta_theta"),
)
so(
    P,
    "`as_printed_at d r theta_0 delta_theta`",
    has("verify/coq/PinnedPrintedSign.v", "as_printed_at d r theta_0 delta_theta"),
)
so(P, "Coq proves of Section 5,", number("THEORSS3.5SpectMatricVitLm"))
so(P, "basis has ω₂⊥·ω₁ < 0 |", "ω₂⊥·ω₁" in row("spectrum", "matrix-stated"))
said(P, "| `spectrum_theorem` | {}", number("THEORSS3.5SpectMatricVitLm"))
RELATIONS = has("verify/check.py", '"<"', '"<="', '"!="')
so(P, "`<`, `<=`, `=` or `!=`", RELATIONS)
P = "docs/explanation/kernel.md"
so(P, "*goal* = left - right is", has("verify/prover/rules.py", "goal"))
P = "docs/explanation/literature.md"
so(P, "with s_n ≤ 0, where s₀ = 0,", "s_n ≤ 0, where s_0 = 0" in " ".join(THEOREMS))
so(P, "r < 7 - 4√3, and", has(P, "r=0.0717\ncollapses", "r=0.0718\ndisperses"))
so(P, "-cos θ ≥ 4√r/(1+r)", "4√r/(1+r)" in " ".join(THEOREMS))
LINE = has(P, '["-(1-t**2)/(1+t**2)"', true("2t/(1 + t²) = 0", lambda draw: {"t": mpf(0)}) and "t")
so(P, "meet t = 0 stay", LINE)
so(P, "at t = 0 the spheres", LINE)
P = "docs/explanation/sandwich.md"
START_OF = "certificates/sandwich/report.md"
so(P, "with U ≤ U\\*.", has(START_OF, "| U_n ≤ U* |"))
so(P, "η_s/(-η_c) ≤ Q and u ≤ U hold", has(START_OF, "| Q ≤ Q_n |", "| U ≤ U_n |"))
so(
    P,
    "counted from 0: P ≤ 0, or",
    has("certificates/outside/report.md", "| 0 < α·(1 - U) - Q - ρ·U |"),
)
for formula in ("p = η_c'/η_c = α(1-u) - β(q+ρu),", "ζ' = γ((q+ρu)² - q²)/p²,"):
    so(P, formula, row("sandwich", "exact-p"), row("sandwich", "exact-u"))
P = "docs/explanation/separatrix.md"
so(P, "p = α(1 - u) - φ₁ - ρu is", true("p = α(1 - u) - φ₁ - ρu", limit_map))
V = "verify/coq/Separatrix.v"
so(P, "(p > 0) and", has(V, "0 < p rho x"))
so(P, "*Let 0 < r < 1, α > 0 and ρ > 0.*", has(V, "0 < r < 1", "0 < a", "0 < rho"))
so(P, "φ₂ → 0 and φ₁ → φ⁻.*", has(V, "u tends to 0, q tends to phi_minus"))
so(P, "with φ₂ → 0", has(V, "u tends to 0"))
so(P, "and f = 0 from φ⁺ on", "φ⁺" in file("certificates/separatrix/report.md"))
so(
    P,
    "φ₁ ↦ r/(α - φ₁)",
    meaning("φ⁻, φ⁺") == "fixed points of φ ↦ r/(α₀ - φ), the smaller one stable",
)
so(P, "--r 0.01..0.05 --plot", has("tests/cli/test_separatrix.py", "--r 0.01..0.05 --plot"))
P = "docs/explanation/sharper.md"
RATIO = row("sharper", "next-ratio-upper")
so(
    P,
    "between m - X and m + X |",
    "≤ m + X" in RATIO,
    has("certificates/sharper/report.md", "(m - X)·-η_c ≤ η_s"),
)
so(P, "at most m + X again", "≤ m + X" in RATIO)
so(P, "between p - Y and", has("certificates/sharper/report.md", "| p - Y ≤"))
P = "docs/explanation/speed.md"
so(P, "`pip install z3-solver cvc5`", has("tests/measure/peers.py", "`pip install z3-solver cvc5`"))

# --- docs/howto, docs/contributing, docs/tutorials ------------------------------------------------

so(
    "docs/howto/cite.md",
    "[2], `certificates/theorem1-all`",
    file("docs/howto/cite.md").index("[1],") < file("docs/howto/cite.md").index("[2],"),
)
P = "docs/howto/family.md"
so(P, "with + - * / ** and", has("verify/spheres/scene/families.py", "write + - * / ** of numbers"))
so(
    P,
    "its cosine is `(1 - t**2)/(1 + t**2)` and its sine `2*t/(1 + t**2)`",
    true("(1 - t²)/(1 + t²) = C", half),
    true("2t/(1 + t²) = S", half),
)
so(P, "with `--confidence 99%`. Points", has("verify/wire/inputs.py", "for example 99%"))
so(P, "`positions[1][0]`", has(P, "positions  = [["))
P = "docs/howto/masses.md"
so(P, "at most σ_oa + σ_ob, so", true("σ_oa + σ_ob = σ_ob + σ_oa", in_line))
so(P, "A' = e² ≥ 0, where", true("m² + v² ≥ 0", between(-1, 1, "m", "v")))
so(
    P,
    "b = (1+r)m/(m_o + m) for an outer particle of mass m, and b' for the other one",
    has("certificates/line/report.md", "b is (1+r) m_c/(m_0 + m_c), and b' is"),
)
P = "docs/howto/many.md"
so(P, "normal·x ≥ level", has("verify/spheres/many/system.py", "normal·x >= level"))
BOUNCES = between(0.1, 0.9, "r", "u", "g")
so(P, "after the time 2u/g, where", true("u - g (2u/g)/2 = 0", BOUNCES))
so(
    P,
    "then after 2ur/g, and so on: infinitely many bounces are over after 2u/(g(1 - r))",
    true("2u/g + r (2u/(g(1 - r))) = 2u/(g(1 - r))", BOUNCES),
    true("2ur/g = r (2u/g)", BOUNCES),
)
P = "docs/contributing/function.md"
so(P, "operations + - · /,", has("verify/check.py", "FUNCTIONS"))
so(P, "`maximum(a, -a)`", has("verify/language/terms.py", "maximum(number, -as_term(number))"))
so(
    P,
    "`nth_root(a, 3)`",
    has("verify/language/terms.py", "def nth_root(number: Number, index: int)"),
)
so(P, "`floor(7/2)`", has(P, "floor(Fraction(7, 2))"))
so(
    P,
    "`floor(3) = 3`, `floor(3*sqrt(2)) <= 4`, `0 <= floor(-1/2)`",
    has(P, "floor(3 * sqrt(2)) <= 4", "0 <= floor(Fraction(-1, 2))"),
)
P = "docs/contributing/house.md"
so(P, "formulas of Section 4 with", has("verify/paper/formulas.md", "Section 4"))
so(P, "such as `3/100`", has("tests/points.py", '"3/100"'))
P = "docs/contributing/row.md"
so(P, "δ₂ > 0 is a row", "0 < δ₂" in row("theorem1-r-3-100", "delta_2-positive"))
P = "docs/contributing/rule.md"
so(P, "`python -m tests.mutation verify/check.py --match", has("tests/mutation.py", "--match"))
so(P, "only 0 < a and 0 <= a", has("verify/check.py", "Whether 0 < t, or 0 <= t, is a usable fact"))
P = "docs/tutorials/page-of-constants.md"
so(P, "with |x| ≤ δ. You want it to be at most 1 - h,", has(P, "2*(q + x) <= 1 - h", "-delta <= x"))
P = "docs/tutorials/three-particles.md"
so(P, "`--collisions 10000`", has("verify/cli/scene.py", "--collisions"))
so(P, '`diameter = "0.02"`', has("verify/spheres/scene/scene_files.py", '"diameter"'))
so(P, "`[1, -1]` if its speed is √2", true("√(1² + 1²) = √2", between(0, 1)))
so(P, '`["4/5", "-3/5"]`', true("(4/5)² + (3/5)² = 1", between(0, 1)))
so(P, '`"501/500"`', true("1.002 = 501/500", between(0, 1)))
so(P, "`η` < 0 and", "ω_c·W_c < 0" in meaning("η_c"))

# --- docs/reference -------------------------------------------------------------------------------

P = "docs/reference/commands.md"
so(P, "`0.03`, `3/100` and `3e-2`", alike("0.03", "3/100", "3e-2"))
P = "docs/reference/glossary.md"
so(
    P,
    "`delta_x`, `x_0`, `Delta_theta`, `eta_bar`",
    has("verify/paper/theorem1.toml", "printed.delta_x:", "printed.x_0:", "printed.Delta_theta:"),
)
so(P, "`left < right`, `left ≤ right`", alike("a ≤ b", "a <= b"))
said(P, "Printed as `{}`", sides("zeta-x-bound")[0] + "…")
so(P, "`EQUATSS4.1Recurrence_Cnd8`", number(f"{CONDITION}8"))
so(P, "numbers, + - · /,", has("verify/check.py", "FUNCTIONS"))
NAMED = ("h_4", "h_5", "V_0", "V_1")
said(P, "`C_eta`, {} | α₀", ", ".join(f"`{name}`" for name in NAMED))
P = "docs/reference/json.md"
so(P, "`verify-error/1`", has("verify/cli/__init__.py", '"verify-error/1"'))
so(P, '`"3/100"`', has("tests/points.py", '"3/100"'))
so(
    P,
    '`["0.0669", "0.0670"]`',
    "0.0669" < str(float(sum(map(Fraction, point()["constants"]["phi_minus"])) / 2)) < "0.0670",
)
P = "docs/reference/python.md"
so(P, "`a + b`, `a - b`, `a * b`, `a / b`, `a ** 2` and `-a`", alike("a ** 2", "a^2"))
so(P, "`a < b`, `a <= b`, `a > b` and `a >= b`", alike("a >= b", "b <= a"))
so(P, "is max(a, -a).", alike("abs(a)", "max(a, -a)"))
P = "docs/reference/text.md"
so(P, '`{ x = "1/2" }`: values', has(P, 'start = "r = 1/2'))
so(
    P,
    '`"0 < a <= b"`, which is a row for each sign, `NAME.1`, `NAME.2`,',
    names_of_rows("0 < a <= b") == ["r.1", "r.2"],
)
so(P, '`{ x = "sqrt(2)" }`', alike("sqrt(2)", "√2"))
so(P, '`loses = "1/4 <= loss"`', has(P, "lemma loses: 1/4 <= loss"))
so(P, "`NAME-1`, `NAME-2`,", has("certificates/step/report.md", "`x_0-entry-1`"))
so(P, '`by = "a b square(x - y)"`', has(P, "square(s)"))
so(P, '`by = "goal*a + 2*b*c"`', has(P, "goal + square(v - s)"))
so(P, "in them `@1` says that it is the entry, and `@2`,", has("verify/wire/text/by.py", "@"))
so(P, "`0.1`, `1/10`, `1e-1`", alike("0.1", "1/10", "1e-1"))
so(P, "`a + b`, `a - b`, `a*b`, `a/b`, `-a`", not refuses("a + (a - b)*(-a/b)"))
so(P, "`2*x`, not `2x`", refuses("2x"), not refuses("2*x"))
so(P, "`x^2`, `x**2`, `x²`, `x^-2`, `x^(2/3)`,", alike("x^2", "x**2", "x²"), alike("x^-2", "1/x^2"))
so(P, "`√x`, `root(x, 3)`", alike("√x", "sqrt(x)"), alike("root(x, 3)", "x^(1/3)"))
so(P, "<code>&#124;x&#124;</code>", alike("|x|", "abs(x)"))
so(P, "`sum(1/k^2, k, 1, 10)`", not refuses("sum(1/k^2, k, 1, 10)"))
so(
    P,
    "`<`, `<=`, `=`, `>=`, `>`, `≤`, `≥`,",
    alike("a <= b", "a ≤ b", "b >= a", "b ≥ a"),
    alike("a < b", "b > a"),
)
so(P, "`a > b` is read as `b < a`", alike("a > b", "b < a"))
so(P, "| `a != b`, `a ≠ b` | 0 < (a - b)² |", alike("a != b", "a ≠ b", "0 < (a - b)²"))
so(P, "| `a < b and c < d` |", names_of_rows("a < b and c < d") == ["r.1", "r.2"])
so(
    P,
    "| `a < b or c < d` | 0 < max(b - a, d - c);",
    alike("a < b or c < d", "0 < max(b - a, d - c)"),
)
so(
    P,
    "with `<=` or `=` in each part, it is 0 <= max(...),",
    alike("a <= b or c <= d", "0 <= max(b - a, d - c)"),
)
so(P, "`δ_1` | the same", alike("delta_1", "δ₁", "δ_1"))
so(
    P,
    "`|t| <= b` is the two bounds `-b <= t` and `t <= b`",
    sorted(map(str, givens("|t| <= b")))
    == sorted(map(str, (*givens("-b <= t"), *givens("t <= b")))),
)
so(
    P,
    "`-x^2` is -(x²), and `1/4*x` is a quarter of x",
    alike("-x^2", "-(x²)"),
    alike("1/4*x", "(1/4)*x"),
)
so(
    P,
    '`["a", 1]`, `[["a", 0], [1, "b"]]`',
    alike("[a, 1][2]", "1"),
    alike("[[a, 0], [1, b]][1, 1]", "a"),
)
so(P, "without the quotes: `[a, 1]`", alike("[a, 1][1]", "a"))
so(
    P,
    "`v[1]`, `A[1, 2]`, `A[2]`",
    alike("[[a, b], [c, d]][1, 2]", "b"),
    alike("[[a, b], [c, d]][2][1]", "c"),
)
so(P, "`u + v`, `A - B`, `-A`,", alike("([a] + [b])[1]", "a + b"), alike("(-[a])[1]", "-a"))
so(P, "`f(1, a)`", has(P, "P(x, c, s)"))
so(P, "| `.smt2` |", has("verify/wire/questions.py", ".smt2"))
so(
    P,
    "`=>`, `xor`, `=`, `distinct`, `ite`, `let`, `<`, `<=`, `>`, `>=` |",
    has("verify/wire/text/formulas.py", '"=>", "xor", "ite"'),
)
so(P, "Terms have `+ - * / ^`,", has("verify/wire/text/formulas.py", '"^": _power'))
so(P, "`(ite (<= a b) a b)`", has("verify/wire/text/formulas.py", "def _extremum"))

#: All that was said, there and here.
TEXTS = tuple(dict.fromkeys((*watched.TEXTS, *ENTRIES)))
