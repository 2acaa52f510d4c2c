"""What the prose of the pages says in numbers, page by page: see `tests.facts`."""

from __future__ import annotations

import json
import re
from fractions import Fraction

from mpmath import mp, mpf

from docs.generated import document, in_coq, point
from tests.facts import (
    AT,
    COUNTED,
    ENTRIES,
    KINDS,
    MEASURED,
    NUMBERS,
    PYPROJECT,
    C,
    F,
    R,
    admissible,
    angle,
    between,
    coded,
    confidence,
    constant,
    digits,
    digits_of,
    file,
    given,
    half,
    has,
    in_line,
    in_thousands,
    limit_map,
    percent,
    printed_by_checker,
    row,
    said,
    sentences,
    separatrix_at,
    sides,
    sine,
    so,
    strip_border,
    told,
    true,
    turned,
)
from verify.check import EXIT_CODES as OF_CHECKER
from verify.cli import OWN_ERROR, USAGE_ERROR
from verify.language.statement import PROVED, REFUTED, UNDECIDED
from verify.language.terms import MAX_POWER
from verify.paper.source import PAPER
from verify.prover.decimals import rounded_inwards, short
from verify.prover.ground import DEFAULT_MAX_PRECISION, DEFAULT_PRECISION
from verify.prover.outcome import EXIT_CODES
from verify.spheres.limit_map import Parameters
from verify.spheres.scene.criteria import SAYS_OF_UNEQUAL
from verify.spheres.scene.middle import Middle, excluded, rests
from verify.spheres.scene.sampling import CELLS
from verify.spheres.scene.scene_files import MAX_DIMENSION
from verify.views.classification import THEOREMS
from verify.views.plots.map_colours import STEPS
from verify.wire.text.formulas import MAX_CASES
from verify.wire.text.linear_algebra import MAX_DETERMINANT
from verify.wire.text.roots import DIGITS as ROOT_DIGITS

# --- everywhere -----------------------------------------------------------------------------------

said("", "{}", PAPER.title)
said("", "({})", PAPER.companion)
said("", "r = {}", point()["parameters"]["r"])
said("", "9 - 4√5", by=row("theorem1-r-3-100", "r-below-stabi"))
said("", "7 - 4√3", by=THEOREMS[2])
said("", "SHA-256", by=given("SHA-256", len(PAPER.source()) == 64))
said("", "Python {} or newer", PYPROJECT["project"]["requires-python"].removeprefix(">="))
said("", "φ₂ = d/η_c²", by=file("verify/views/map.py"))

# --- README.md ------------------------------------------------------------------------------------

said(
    "README.md",
    "{} of its claims are refuted at {}, or at another point that is named. {} of the {} break the "
    "argument, by {} mistakes; {} are false but harmless; {} are slips of wording, one of them "
    "the sign. The {} mistakes:",
    *(
        F["refuted"],
        AT,
        F["breaking"],
        F["refuted"],
        F["breaking_causes"],
        F["harmless"],
        F["slips"],
    ),
    F["breaking_causes"],
)
said("README.md", "more than δ₂²", by=row("theorem1-r-3-100", "zeta-term-2"))
said("README.md", "*{} are true, but the reason given does not suffice*", F["otherwise"])
said("README.md", "*{} are remarks*", F["remarks"])
said(
    "README.md",
    "all {} + {} + {} = {} rows as refuted",
    *(F["refuted"], F["otherwise"], F["remarks"], COUNTED),
)
said(
    "README.md",
    "*Given {} assumptions*: a definition (what hard spheres do), {} textbook theorems, and {} "
    "of *glue*",
    *(
        len(KINDS),
        NUMBERS[KINDS.count("general mathematics")],
        NUMBERS[KINDS.count("numbered glue")],
    ),
)
CODES = (
    *(EXIT_CODES[PROVED], EXIT_CODES[REFUTED], USAGE_ERROR, EXIT_CODES[UNDECIDED]),
    *(OF_CHECKER["MALFORMED"], OWN_ERROR),
)
said(
    "README.md",
    "Exit codes: {} proved, {} refuted, {} unusable input, {} undecided, {} malformed certificate, "
    "{} a bug.",
    *CODES,
)
SIGN, SET = sentences("printed-sign"), sentences("printed-set")

# --- docs/contributing ----------------------------------------------------------------------------

said("docs/contributing/command.md", "the exit code {} follows", USAGE_ERROR)
said("docs/contributing/row.md", "δ₂ < 1/2", by=file("docs/contributing/row.md").split("```")[1])
said(
    "docs/contributing/row.md",
    "Until step 4 is done",
    by=given("step 4", "**4. Make the cert" in file("docs/contributing/row.md")),
)
said(
    "docs/contributing/rule.md",
    "0 ≤ √a, if 0 ≤ a",
    by=coded("0≤√a 0≤a", "docs/contributing/rule.md", "proves `0 <= sqrt(a)`, if `0 <= a`"),
)
said(
    "docs/contributing/rule.md",
    "then steps 1 to 3 of",
    by=given("1 to 3", "**3. Try it" in file("docs/contributing/technique.md")),
)

# --- docs/explanation/findings.md --------------------------------------------------------------

A = "docs/explanation/findings.md"
low, high = sides("zeta-x-bound")
said(A, "δ_x = {} is more than {}", low, high)
terms = [sides(name)[0] for name in ("zeta-term-2", "zeta-remainders", "zeta-total")]
said(A, "the three terms h₅/4", by=row("theorem1-r-3-100", "zeta-remainders"))
said(A, "{}, {} and {}, with", *terms)
said(A, "allows up to {} δ_θ, for δ_θ ≤ {}", angle()[1], angle()[0])
said(A, "begin with δ_θ/{} in its place", angle()[1])
said(A, "the third may be more, {} and not {}", *sides("y-term-3"))
said(A, "only that it is at most 2 is used", by=row("theorem1-r-3-100", "norm-law-as-printed"))
said(A, r"≤ 4ζ_n²/\|W_{c,n}\|⁴", by=row("step-printed", "time-square"))
said(A, r"≤ 2d₀\|W_{c,0}\|²/η_{c,0}²", by=row("theorem1-r-3-100", "init-zeta-bound-2"))
said(A, "the bound 2x", by=row("theorem1-r-3-100", "init-zeta-bound-2"))
said(A, r"d ≤ η₂²/(2\|W₂\|²)", by=row("elsewhere", "distance-half-printed"))
said(A, "above 1/2", by=row("elsewhere", "distance-half-printed"))
said(A, r"\|W\|² can be 4E₀", by=row("elsewhere", "change-bound"))
said(A, "4n - 1 counts", by=row("elsewhere", "dimension"))
said(A, "'1 +' is missing", by=" ".join(text for _, text in PAPER.notes().causes))
said(A, "fails for 1/n²", by=row("elsewhere", "forced-exponential"))
said(A, "has √r", by=row("spectrum", "rate-complex"))
said(
    A,
    "r = 10⁻⁶, -cos θ₀ = 1/20",
    by=coded("r = 10⁻⁶, -cosθ₀ = 1/20", "tests/points.py", '("1/1000000", "1/20")'),
)

# --- the other pages of docs/explanation ----------------------------------------------------------

P = "docs/explanation/alexander.md"
A = "verify/paper/alexander.toml"
so(P, "satisfies C²b² > T. If b² ≤ T for", has(A, "C²b² > T.", "If b² ≤ T for each ball"))
said(P, "where t³ = ef", by=coded("t³ = ef", A, "where t³ = ef"))
said(P, "is that of Theorem 1", by="Theorem 1")
so(
    P,
    "Cb > r^{1/3} + r^{2/3}",
    true("r + r + r^(2/3) + r^(4/3) = (r^(1/3) + r^(2/3))^2", between(0.01, 0.9, "r")),
)
so(P, "b² ≤ T if r ≥ 9-4√5", has(A, "b² ≤ e + f + t + t² for r ≥ 9-4√5"))
so(P, "κy² is the gap", has(A, "the gap is d = κy²"))
so(P, "*across* y = 0", has(A, "smooth in them across y = 0"))
so(P, "κ_a < κ_b", has(A, "x is κ_b/κ_a - 1"))
so(P, "S = √(1 - Aκ(2+d)/(1+d)²)", has(A, "S^2*(1 + d)^2 = (1 + d)^2 - k*(2 + d)*A"))
so(P, "T = κ(2+d)/((1+d)(1+S))", has(A, "T = k*(2 + d)/(1 + d)/(1 + S)"))
so(P, "E² = |x_s'|²", has(A, ".E: |x_s'|"))
so(P, "d = κy²,", has(A, "let = 'd: k*y^2;"))
so(P, "(q+BT)/E", has(A, "law-p: p*E = b*(1 + k*y^2)*S*c*E - (q + B*T)"))
so(P, "q' = r(1+d)S/p", has(A, "law-q: x*p = e*(1 + k*y^2)*S"))
so(P, "κ' = T(2q+BT)/((1+E)p²)", has(A, "law-kappa: v*(1 + E)*p^2 = T*(2*q + B*T)"))
so(P, "also at y = 0,", has(A, "y = 0 allowed"))
so(P, "At y = 0,", has(A, "at y = 0 they are those"))
so(P, "S = 1 - AT,   κ = T - AT²/2", has(A, "k: t*(1 - A*t/2);", "s: 1 - A*t;"))
so(P, "p = αS - q - BT", has(A, "p: a*s - q - B*t;"))
so(P, "κ' = T(2q+BT)/(2p²)", has(A, "under-v-is: 2*v*p^2 = t*(2*q + B*t)"))
so(P, "p ≤ β(1+d)S", has(A, "late-p: p <= b*(1 + d)*S;"))
so(P, "q' ≤ Q'", has(A, "under-x: x <= X;"))
so(P, "κ'/K' ≤ (κ/K)(P/p)²", has(A, "under-ratio: v*K*p^2 <= k*V*P^2;"))
so(P, "r(qA+B)(K-κ)/(pP)", has(A, "under-apart: e*(q*A + B)*(K - k) <= (X - x)*(p*P);"))
so(P, "at which it is 1", has(A, "h is where the factor is 1"))
so(P, "z ≥ h", has(A, "record-place: h <= z;"))
so(P, "Let 1+x be the quotient", has(A, "x is κ_b/κ_a - 1"))
so(
    P,
    "q' ≥ r/(α-q) and κ' ≥ κq/(α-q)² but",
    has(A, "below-limit: e <= x*", "below-growth: k*q <= v*(1 + d)*"),
)
so(P, "(x+D)", has(A, "off: H + g*Y + g*(x + D)"))
so(
    P,
    "x' ≥ x + c(x+D) - K(H + gY + g(x+D)),   D' ≥ cx - K(H + gY + g(x+D))",
    has(A, "step-x: x + c*(x + D) - K*off <= x_1;", "step-D-least: c*x - K*off <= D_1"),
)
so(P, "H' ≤ H + Kg(x+D+H+Y)", has(A, "step-H: H_1 <= H + K*g*(x + D + H + Y)"))
so(P, "(4K/c)x, H is at most (c/4K)x", has(A, "N: 4*K/c; s: c/4/K;"))
so(P, "as long as y ≤ g", has(A, "0 < y ≤ g"))
so(P, "c ≤ 1 and K ≥ 1 such", has(A, "apart-c-one: c <= 1;", "apart-K: 1 <= K;"))
M = MEASURED["without momentum"]
said(P, "At r = {}, with -cos θ = {}, one", M["r"], M["cosine"])
said(P, "and the gap {},", M["gap"])
said(P, "speeds {} and {}, tuned to {} digits", *M["tangential speeds"], str(M["digits"]))
said(P, "give {} collisions in turn: the gap falls below {},", str(M["collisions"]), M["last gap"])
said(P, "comes to {}. The", M["last cosine"])
FIRST, M = (
    {key: in_thousands(x) if isinstance(x, int) else x for key, x in MEASURED[name].items()}
    for name in ("first reading", "reading")
)
said(
    P,
    "correct: {} collisions, {} of them with a tangential velocity that vanishes, errors below {}",
    *(FIRST["collisions"], FIRST["of them without a tangential velocity"], FIRST["error"]),
)
said(P, "correct: {} pairs of states", FIRST["pairs"])
said(P, "{} sets of masses for the trap", FIRST["masses"])
said(P, "{} collisions of two orbits over one base point", FIRST["steps"])
said(
    P,
    "and {} collisions, {} of them with a tangential velocity that vanishes; errors below {}",
    *(M["collisions"], M["of them without a tangential velocity"], M["error"]),
)
said(
    P, "{} pairs of states in exact numbers, {} of them with", M["pairs"], M["of them with a zero"]
)
said(P, "{} records of small κ on {} orbits of the limit map", M["records"], M["orbits"])
said(P, "{} orbits of the limit map at the threshold or below: {} ended", M["orbits"], M["ended"])
said(P, "still grew after {} collisions", M["followed"])
said(P, "{} base points, as follows", M["base points"])
said(P, "Of {} starts all", M["starts"])
said(P, "In {} collisions of two orbits", M["steps"])
said(P, "Over {} of the base points", M["near the threshold"])

P = "docs/explanation/classification.md"
said(P, "at least 90°", by=coded("90°", "verify/views/classification.py", "at least a right one"))
said(P, "for r > {}…", digits("7 - 4√3", 3))
said(P, "excludes collapses for r > {}….", digits("7 - 4√3", 3))
said(P, "{}…, and II", digits("9 - 4√5", 3))
said(
    P,
    "α ≥ r^(1/3) + r^(2/3)",
    by="α ≥ "
    + true("r^(1/3) + r^(2/3) = (1 + r)/2 2r^(1/3)(1 + r^(1/3))/(1 + r)", between(0.01, 0.9, "r")),
)

P = "docs/explanation/coq.md"
V = "verify/coq/Theorem1.v"
said(
    P,
    "3rα₀ + r(1+r) < α₀³",
    by=coded(
        "3rα₀+r(1+r)<α₀³", V, "3 * r * ((1 + r) / 2 * c) + r * (1 + r) < ((1 + r) / 2 * c) ^ 3"
    ),
)
said(P, "0 < c ≤ 1", by=coded("0 < c ≤ 1", V, "0 < c <= 1"))
said(P, "d_slope · η_c²", by=coded("d_slopeη_c²", V, "d_slope * y ^ 2"))
said(P, "the distance 1 + d₀", by=coded("1+d₀", V, "1 + d_0"))
said(P, r"\|Δθ\|/4 instead", by=coded("|Δθ|/4", V, "Delta_theta / 4"))
said(P, "particles 0, 1, 2 |", by=coded("0,1,2", V, "ball : Set := B0 | B1 | B2"))
said(P, "2 is at the distance", by=coded("2", V, "distance d s B0 B2 = 1 + d_0"))
said(P, "for d ≥ 2", by=coded("d≥2", V, "(2 <= d)%nat"))
said(P, "and d ≥ 2:", by=coded("d≥2", "verify/coq/PinnedPrintedSet.v", "(2 <= d)%nat"))
said(
    P,
    "each of the 6d coordinates",
    by=coded(
        "6d", V, "position low i k < position high i k /\\ velocity low i k < velocity high i k"
    ),
)
V = "verify/coq/PinnedPrintedSign.v"
said(
    P,
    "collisions of i n and j n, n = 0, 1, …, one",
    by=coded(
        "n=0,1,…",
        "verify/coq/PinnedClassification.v",
        "time O = 0) /\\ forall n, let t := time (S n) - time n in i n <> j n",
    ),
)
said(P, "as printed, π/2 < θ₀ ≤ π", by=coded("π/2<θ₀≤π", V, "PI / 2 < theta_0 <= PI"))
said(P, "each d ≥ 2 |", by=coded("d≥2", V, "(2 <= d)%nat -> hypotheses_as_printed"))
said(P, "in each dimension d ≥ 2:", by=coded("d≥2", V, "(2 <= d)%nat -> 0 < r < 1"))
said(P, "θ₀ = 2π/3,", by=coded("θ₀=2π/3,", "verify/coq/PrintedSignProof.v", "(2 * (PI / 3))"))
said(P, "δ_θ = 1/10);", by=coded("δ_θ=1/10)", "verify/coq/PrintedSignProof.v", "(1 / 10)"))
V = "verify/coq/PinnedLine.v"
said(
    P,
    "r ≤ bb'Q(1 - Q) and 2Q < 1",
    by=coded("r≤bb'Q(1-Q),2Q<1", V, "r <= b * b' * Q * (1 - Q) /\\ 2 * Q < 1"),
)
said(
    P,
    "within (1 - Q)/(1 - 2Q) times",
    by=coded("(1-Q)/(1-2Q)", V, "T <= (1 - Q) / (1 - 2 * Q) * (gap / closing)"),
)
said(P, "and if r < 1, the places", by=coded("r<1", V, "(r < 1 -> exists at_T, settles"))
said(P, "equal balls with r < 1 this", by=coded("r<1", V, "e parting gap closing Q, 0 < r < 1 ->"))
V = "verify/coq/PinnedOutside.v"
said(P, "from the beginning, ζ < 1, and", by=coded("ζ<1", V, "zeta d x v i j < 1"))
said(P, "no trajectory has N+2 collisions", by=coded("N+2", V, "T X V time (N + 2)"))
V = "verify/coq/PinnedSpectrum.v"
said(
    P, "of geometric multiplicity 1;", by=coded("1", V, "exists a b, u' = combination a u (- b) v")
)
said(P, "the collisions 0-1, 0-2, 1-2 of three", by=coded("0-1,0-2,1-2", V, "0-1, 0-2 and 1-2"))
said(P, "With the sign 1 the last vector", by=coded("1", V, "coordinates d 1 x v u e f"))
said(P, "det(λI - 𝔄) = (λ-1) Q(λ)", by=coded("det(λI-𝔄)=(λ-1)Q(λ)", V, "= (l - 1) * Q r l"))
said(
    P,
    "-1 < -r < λ₀ < -r³ < 0",
    by=coded("-1<-r<λ₀<-r³<0", V, "-1 < - r < l_0 /\\ l_0 < - r ^ 3 < 0"),
)
said(
    P,
    r"\|λ₀\| < \|λ±\| < 1;",
    by=coded("|λ₀|<|λ±|<1", V, "l_0 ^ 2 < re ^ 2 + im ^ 2 /\\ re ^ 2 + im ^ 2 < 1"),
)
said(P, "are these and 1, each", by=coded("1", V, "mu = 1 /\\ nu = 0"))
said(
    P,
    "eigenvectors for 1 are the multiples of (0,1,0,1) |",
    by=coded("1(0,1,0,1)", V, "Column 0 y 0 y"),
)
said(P, "multiples of (0,1,0,1); where", by=coded("(0,1,0,1)", V, "Column 0 y 0 y"))
said(P, "in turn take place, 0-1 recedes", by=coded("0-1", V, "0 < rate d x w B0 B1"))
said(
    P,
    "for μ³ where μ³ + hμ² + hμ + r = 0, h = (1+r)/4",
    by=coded(
        "μ³μ³+hμ²+hμ+r=0,h=(1+r)/4", V, "mu ^ 3 + (1 + r) / 4 * mu ^ 2 + (1 + r) / 4 * mu + r = 0"
    ),
)
said(P, "the parameter m with λ₀ = -m³", by=coded("λ₀=-m³", V, "Q r (- m ^ 3) = 0"))
third = (constant("V_1") - 1) / 3
said(P, "in [{}, {}];", *rounded_inwards((1 + third, constant("V_1") - third), 6))
said(P, "by the time {} and", short((constant("T_star"),) * 2))
said(P, "within {} of {}.", told(point()["parameters"]["delta_theta"]), C)
M = MEASURED["coq"]
said(
    P,
    "Coq {} and the packages that Debian {} has for it: coq, libcoq-interval ({})",
    in_coq()["coq"],
    M["debian"],
    M["interval"],
)
said(P, "Debian {}, Coq {} and Interval {},", M["next debian"], M["next coq"], M["next interval"])

P = "docs/explanation/kernel.md"
POSITIVE = between(0.1, 5, "x")
said(
    P,
    "x + 1/x ≥ 2 for x > 0: if it were false, 2x - (x² + 1) would be positive, but with the square "
    "(x - 1)² it adds up to 0.",
    by=true("x + 1/x ≥ 2", POSITIVE) + "x > 0:" + true("2x - (x² + 1) + (x - 1)² = 0", POSITIVE),
)

P = "docs/explanation/literature.md"
M = MEASURED["papers"]
said(P, "since the {},", M["since"])
said(P, "(*Phys. Fluids A* **{}**, {}, {})", *M["McNamara and Young"])
said(P, "(*Phys. Rev. E* **{}**, {}, {}) state", *M["Zhou and Kadanoff"])
said(P, "(*Phys. Rev. E* **{}**, {}, {}) add", *M["Schörghofer and Zhou"])
said(
    P,
    "The numbers {}, {} and {} are",
    *re.findall(r"disperses: after (\d+) collisions", file(P))[:3],
)
said(P, "cos θ > 2√r", by=true("4√r/(1+r) (1+r)/2 = 2√r", between(0.01, 0.9, "r")) + "cosθ>2√r")
said(
    P,
    "from 0, and 2 comes",
    by=coded("0,2", P, '["1.5*(1-t**2)/(1+t**2)", "3*t/(1+t**2)"]') + "0 2",
)
M = MEASURED["diagram"]
said(
    P,
    "After {} boxes {} % of the rectangle collapse, {} % disperse, {} % have",
    in_thousands(M["boxes"]),
    M["collapses"],
    M["disperses"],
    M["finite"],
)
said(
    P,
    "less than {} % is undecided",
    1 + int(100 - sum(float(M[key]) for key in ("collapses", "disperses", "finite"))),
)

P = "docs/explanation/proof.md"
said(P, "only by {} ζ_n", terms[2])
said(P, "is at most {}. But", told(Fraction(1, 2) + Fraction(1, 10)))
said(P, "4√r/(1+r) = {}…", digits("4√0.03/1.03", 2), by=THEOREMS[2])
said(P, "gap by d/η_c²", by=file("verify/views/map.py"))
said("", "Θ/6", by=row("printed-set", "inside-start-C-upper"))
said(P, "δ_θ ≤ {} it breaks", angle()[0])
said(P, "up to {} δ_θ", angle()[1])

P = "docs/explanation/sandwich.md"
M = MEASURED["sandwich"]
CURVE = document("separatrix", "--r", "0.03", "--at", "1/10")["f"]["u"]
said(P, "u = {}:", digits_of(CURVE, 6))
for line in M["table"]:
    said(P, "| {} | {} | {} | {} |", *line)
said(
    P,
    "Of {} random states in dimensions 2 and 3 with closing speeds from {} to {} (relative speeds "
    "from {} to {}), the first half decides {} and the second one {}.",
    *(in_thousands(M["states"]), M["least speed"], M["most speed"], *M["relative speeds"]),
    *(in_thousands(M["first half"]), M["second half"]),
    by=M["run"],
)
said(
    P,
    "the {} were followed with {} digits, and another {} states of the first half with {}",
    M["second half"],
    in_thousands(M["digits"]),
    in_thousands(M["states"]),
    M["digits of the first"],
)
BOXED = MEASURED["outside"]
said(P, "{} % were undecided after {} boxes;", *BOXED["before"])
said(P, "the theorem {} % are after {} boxes.", *BOXED["after"])
said(P, "Of {} boxes in three", BOXED["boxes"])
said(P, "all {} scenes disperse.", in_thousands(BOXED["scenes"]))
said(P, "1 - (1-U')² = ρU(2Q+ρU)/P²", by=row("sandwich", "U-next-law"))
said(P, "|W_c'|²/(|W_s|²(1+d')²)", by=row("sandwich", "exact-u"))
said(
    P,
    "most N+1 collisions",
    by=coded("N+1", "certificates/outside/report.md", "n = 0 … N"),
)
said(P, "Γ bounds 1 + d, and", by=row("sandwich", "reach-here").replace("d ≤ Γ", "d,"))
said(P, "1 - √(1-ζ), which", by=row("sandwich", "exact-p"))

THREE = file("verify/paper/three_balls.toml")
said(P, "the distance at which 0 touches i, and take X_i = (x_i - x_0)/σ_i and", by=THREE)
said(
    P, "V_i = (v_i - v_0)/σ_i in place of x_i - x_0 and W_i, so that contact is |X_i| = 1", by=THREE
)
said(P, "and Y₀Y₁ < 1.", by=given("Y₀Y₁<1", "0 < 1 - Y_0*Y_1" in THREE))
said(
    P,
    "that of 1-2 plays no part",
    by=given(
        "1-2",
        "restitution for each of the two pairs that collide"
        in " ".join(THREE.replace("#", "").split()),
    ),
)
said(
    P,
    "Y = (1+r)Γ/2 and k = 0",
    by=coded(
        "Y=(1+r)Γ/2 k=0",
        "tests/paper/three_balls/equal.toml",
        "Y_0 = Lambda, Y_1 = Lambda, k_0 = 0",
    ),
)

P = "docs/explanation/separatrix.md"
said(P, "becomes 1/ρ at", by=true("1/ρ = R", lambda draw: {"ρ": mpf(2), "R": mpf(1) / 2}))
said(P, "u(2 - u) = 2 φ₂ |W_c|²;", by=true("u(2 - u) = 2 φ₂ |W_c|²", limit_map))
said(P, "u'(2 - u') = ρu(2φ₁ + ρu)/p²", by=true("u'(2 - u') = ρu(2φ₁ + ρu)/p²", limit_map))
said(
    P,
    "if and only if α > r^(1/3) + r^(2/3).*",
    by=coded("α>r^(1/3)+r^(2/3)", "verify/views/separatrix.py", "s + s² < a, where s³ = r"),
)
said(
    P,
    "α ≥ r^(1/3) + r^(2/3)",
    by=coded("α≥r^(1/3)+r^(2/3)", "verify/views/classification.py", "2r^(1/3)(1+r^(1/3))/(1+r)"),
)
said(P, "1 - u, φ₁ and", by=coded("1-u,φ₁", "verify/coq/SeparatrixProjective.v", "1 - u"))
said(P, "u/q² after that", by=row("separatrix", "grows-next-weight"))
said(P, "as long as q < s²,", by=coded("q<s²", "certificates/separatrix/report.md", "q < s²"))
said(P, "with q = s² go on", by=coded("q=s²", "certificates/separatrix/report.md", "q_n ≥ s²"))
STRIP, SEPARATRIX = strip_border(), separatrix_at("1/100")
said(
    P,
    "has φ₂ = {} where φ₁ = {}. The separatrix has φ₂ = {} there, {} % more.",
    STRIP,
    "0.01",
    SEPARATRIX,
    round(100 * (float(SEPARATRIX) / float(STRIP) - 1)),
)
M = MEASURED["scenes"]
S = M["kinds"] * M["of each"]
said(P, "on {} random scenes", in_thousands(S))
said(
    P,
    "{} of each, with a seed fixed before and at most {} collisions each: {} collapse, {} "
    "disperse, {} are undecided.",
    M["of each"],
    M["collisions"],
    M["collapses"],
    M["disperses"],
    S - M["collapses"] - M["disperses"],
)
for what in (
    "at the first, without the sandwich theorem",
    "at the first",
    "at the first, with its other half",
):
    said(P, "| {} | {} % |", M[what], percent(M[what], S))
said(P, "these {} scenes are followed", M["at the first, with its other half"] - M["at the first"])
said(P, "it applies to {} of the scenes", M["where its other half applies"])
said(
    P,
    "alone decides {} of the {} collapses off a line at the first collision, the sandwich theorem "
    "these and {} more",
    M["by the sharper theorem alone"],
    M["collapses off a line"],
    M["by the sandwich theorem besides"],
)
said(P, "At {} states", M["states where the sandwich theorem comes later"])
said(P, "{} more in all, of {}.", M["collisions more"], in_thousands(M["of collisions"]))
said(P, "on {},", MEASURED["search"]["day"])

P = "docs/explanation/sharper.md"
said(
    P,
    "below 10⁻¹⁷ diameters",
    by=given("10⁻¹⁷", constant("d_slope") * constant("eta_bar") ** 2 < Fraction(1, 10**17)),
)
said(
    P,
    "below κ η_c²",
    by=coded("κη_c²", "verify/paper/sharper.toml", "start-d-small: d_start <= k*y_start^2"),
)
said(
    P,
    r"A, B, C are |W_c|², |W_s|²",
    by=coded("|W_c|²,|W_s|²", "verify/paper/commands/repaired_theorem.py", '"A": ("|W_c|²"')
    + "|W_c|²,|W_s|²,",
)

P = "docs/explanation/speed.md"
said(P, "about {} times as long", MEASURED["process"]["theorem1"])
said(
    P,
    "Z3 and cvc5",
    by=given("Z3 cvc5", all(name in file("tests/measure/peers.py") for name in ("Z3", "cvc5"))),
)

said(
    "docs/explanation/trust.md",
    "computation with {} bits",
    re.findall(r"CONTEXT.prec = (\d+)", file("tests/prover/test_oracle.py"))[0],
)

# --- docs/howto -----------------------------------------------------------------------------------

said("docs/howto/dask.md", "with 5%,", by=coded("5%", "docs/howto/dask.md", "--undecided 5%"))
P = "docs/howto/family.md"
said(P, "the tangent of a/2:", by=true("(1 - t²)/(1 + t²) = C", lambda draw: half(draw)) + "a/2")
said(P, "2³² equidistant", by=given("2³²", CELLS == 32))
said(P, "is at most {} %, and {} % with", *confidence())
said(P, "wider than {} of the bar", f"1/{STEPS}")
said(
    P,
    "mass × diameter²/time²; each mass is 1 unless",
    by="mass × diameter²/time²;" + coded("1", "docs/howto/masses.md", "masses = [1, 5"),
)
ELASTIC = coded("r = 1", "verify/spheres/scene/scene_files.py", "if not 0 < r <= 1:")
P = "docs/howto/masses.md"
said(P, "Some of them, or all, may be 1:", by=ELASTIC.removeprefix("r = "))
MASSES = between(1, 2, "m₀", "m₁", "u", "r")
true("m₀ (1 + r) u m₁/(m₀ + m₁) = m₁ (1 + r) u m₀/(m₀ + m₁)", MASSES)
said(
    P,
    "the speed of 0 changes by (1 + r) u m₁/(m₀ + m₁), that of 1 by (1 + r) u m₀/(m₀ + m₁)",
    by="0, of 1" + true("u - (1 + r) u m₁/(m₀ + m₁) - (1 + r) u m₀/(m₀ + m₁) = -r u", MASSES),
)
UNEQUAL = " ".join(SAYS_OF_UNEQUAL.values()).replace(">=", "≥").replace("<=", "≤")
said(P, "Let R² = Σ m|x|²", by=UNEQUAL)
said(
    P,
    "R² is at most B",
    by=coded("R²", "verify/spheres/scene/criteria.py", "a collapse would need R² <= B"),
)
said(
    P,
    "(m_o m_a σ_oa² + m_o m_b σ_ob² + m_a m_b (σ_oa + σ_ob)²)/M",
    by=true("(m_o m_a σ_oa² + m_o m_b σ_ob² + m_a m_b (σ_oa + σ_ob)²)/M = B", in_line),
)
said(
    P,
    "(R²)' = 2A",
    by=file("certificates/classification/report.md"),
)
said(P, "A' = e²", by=file("certificates/classification/report.md"))
said(P, "e² = Σ m|v|²", by=THEOREMS[4])
said(
    P,
    "A ≥ 0 and R² ≥ B, then R² grows",
    by=given("A≥0 R²≥B R²", "A ≥ 0 and R² = Σ m|x|² ≥ B" in UNEQUAL),
)
said(
    P,
    "A²R² < (R² - B)L² and R² ≥ B, then",
    by=UNEQUAL + given("R²≥B", "L² and R² = Σ m|x|² ≥ B" in UNEQUAL),
)
said(
    P,
    "R² is at most its value R₀² now, so that e² ≥ L²/R₀²; hence R² ≥ R₀² + 2tA + t²L²/R₀² after a",
    by="R²≥"
    + true("R₀² + 2tA + t²L²/R₀² ≥ R₀² - A²R₀²/L² > B", turned)
    + coded("e²≥L²/R₀²", "verify/paper/classification.toml", "(iv) e² ≥ L²/ρ² while R² ≤ ρ²"),
)
said(
    P,
    "b = (1+r)m/(m_o + m) for an outer particle",
    by=coded("b=(1+r)m/(m_o+m)", "certificates/line/report.md", "b is (1+r) m_c/(m_0 + m_c)"),
)
said(
    P,
    "bb' cos²θ > 4r:",
    by=coded("bb'cos²θ>4r", "certificates/line/report.md", "r <= bb'Q(1 - Q) and 2Q < 1"),
)
EQUAL = {
    r: Middle(0, (1, 2), Fraction(1), (Fraction(1),) * 2, (Fraction(r),) * 2)
    for r in ("0.0717", "0.0718", "0.0557", "0.0558")
}
so(
    P,
    "if bb' < 4r. The lightest particle decides; for equal masses this says that r > 7 - 4√3",
    excluded(EQUAL["0.0717"]) is None,
    excluded(EQUAL["0.0718"]) is not None,
)
so(
    P,
    "bb' < (r^(1/3) + r^(2/3))² for each particle in the middle",
    rests(EQUAL["0.0557"]) is None,
    rests(EQUAL["0.0558"]) is not None,
)
so(P, "L is not 0, and", "0 < L2" in file("verify/spheres/scene/statement.py"))
so(P, "angular momentum is 0: for", "angular momentum is 0" in UNEQUAL)
SMALL = "certificates/scenes/small-bead.toml"
said(
    P,
    "Here r = 4/5, and the three balls have one density; the one in the middle has 15 % of",
    by=coded("15 %", SMALL, "15 % of the") + coded(" r=4/5", SMALL, 'r = "4/5"'),
)
said(
    P,
    "of their mass at r = 3/10",
    by=coded("r=3/10", "certificates/scenes/bead.toml", 'r = "3/10"'),
)
LIGHT = "certificates/scenes/light-bead.toml"
said(P, "a thousandth at r = 9/10", by=coded("r=9/10", LIGHT, 'r = "9/10"'))
P = "docs/howto/second-checker.md"
for word in ("PROVED", "REFUSED", "MALFORMED"):
    said(P, "| {} |", OF_CHECKER[word])

# --- docs/reference -------------------------------------------------------------------------------

said("docs/reference/exit-codes.md", "exits with {}:", EXIT_CODES[PROVED])
said("docs/reference/exit-codes.md", "is refuted gives {}, too", EXIT_CODES[REFUTED])
said("docs/reference/exit-codes.md", "tests for {} never", EXIT_CODES[PROVED])
P = "docs/reference/text.md"
said(
    P,
    "or where both sides meet, as at e². Then there are rows `row.part1` and `row.part2`, in",
    by=coded("e² row.part1 row.part2", "verify/prover/parts.py", 'f"{row.name}.part{k}"'),
)
said(
    P,
    "a row `row.inverse` about 1/x",
    by=coded("row.inverse 1/x", "verify/prover/parts.py", 'f"{row.name}.inverse"'),
)
said(
    P,
    "as with `a != 0` and `1/a < b`, there are two contexts, with the rows `row.1` and `row.2`",
    by=coded(
        "a != 0 1/a < b row.1 row.2", "verify/wire/halves.py", 'name=f"{row.name}.{self.number}"'
    ),
)
said(P, "counted from {};", coded("1", "verify/wire/text/matrices.py", "counted from 1"))
said(P, "of at most {} rows", MAX_DETERMINANT)
said(P, "with exponents up to {};", MAX_POWER)
said(
    P,
    "is {} if a question is refuted, else {} if one is undecided, else {}.",
    *(EXIT_CODES[verdict] for verdict in (REFUTED, UNDECIDED, PROVED)),
)
said(P, "for each case, {} at most", MAX_CASES)
said(P, "numbers that are {} apart", short((2 * Fraction(1, 10**ROOT_DIGITS),) * 2))
said(P, "(negative) from 1 to 2.", by="1 2" + coded("", P, "between = [1, 2]"))
said(P, "no other one from 1 to 2,", by="1 2" + coded("", P, "between = [1, 2]"))
said(P, "rho^3 = rho + 1,", by=coded("rho^3=rho+1", P, 'root = "rho^3 - rho - 1"'))
ANGLES = between(-1, 1, "x")
said(P, "between -π/2 and π/2", by=true("-π/2 < atan(x) < π/2", ANGLES))
said(
    P,
    "the arc sine 2 atan(x/(1 + √(1 - x²))), and π/2 less it, for x from -1 to 1",
    by=true("2 atan(x/(1 + √(1 - x²))) = A", lambda draw: sine(draw))
    + true("π/2 - A = C", lambda draw: sine(draw))
    + true("-1 ≤ x ≤ 1", lambda draw: sine(draw))
    + "-1 1",
)
said(
    P,
    "is 1 - 2/(exp(x)² + 1)",
    by=true("1 - 2/(exp(x)² + 1) = T", lambda draw: {"x": mpf(2), "T": mp.tanh(2)}),
)
said(
    P,
    "k = 1, 2, ..., 10; here k^0 is 1",
    by=coded("1,2,...,10", P, "sum(1/k^2, k, 1, 10)")
    + "k=1,2,...,10;"
    + true("k^0 = 1", between(1, 9, "k")),
)
said(P, "is -(x²), and", by=true("-x² = -(x²)", ANGLES))
P = "docs/reference/glossary.md"
said(P, "With r = 1 no", by=true("1 - r² = 0", lambda draw: {"r": mpf(1)}) + "r = 1")
said(P, "{} hexadecimal digits", len(PAPER.source()))
said(P, "({} bits, doubled up to {})", DEFAULT_PRECISION, DEFAULT_MAX_PRECISION)
said(P, "W and √V are", by=coded("√V", "verify/paper/glossary.py", "V₀"))

# --- docs/tutorials -------------------------------------------------------------------------------

P = "docs/tutorials/referee.md"
said(P, "*{} are true, but the reason given does not suffice*", F["otherwise"])
said(P, "*{} are remarks*", F["remarks"])
said(P, "*Given {} assumptions*", len(KINDS))
said(
    P,
    "the {} refuted rows, the {} that are true for another reason, and the {} remarks together, {} "
    "printed rows",
    F["refuted"],
    F["otherwise"],
    F["remarks"],
    COUNTED,
)
said(
    P,
    "The first verdict rests on {} assumptions, of which Coq has proved {}; the",
    *SIGN,
)
said(P, "prints {}, since it has", printed_by_checker("printed-sign"))
said(P, "rests on {} assumptions, of which Coq has proved {};", *SET)
said(P, "every δ_θ ≤ {}.", angle()[0])
said(
    P,
    "With this, 2, 3 and the smaller",
    by=coded("2,3", P, "3. The set of initial data as printed") + "2, 3 and",
)
said(P, "proof of (4.47) for n+1,", by="(4.47)n+1")
said(
    P,
    "{} means that everything asked for is proved, {} that something is refuted",
    EXIT_CODES[PROVED],
    EXIT_CODES[REFUTED],
)
P = "docs/tutorials/three-particles.md"
said(P, "With r = 1 they are elastic", by=ELASTIC)
said(P, "from {} to {}.", 1, MAX_DIMENSION)
said(P, "part with {} % of", told(100 * Fraction(point()["parameters"]["r"])))
said(P, "{}: the moment", re.findall(r"collapse time in (\[[^]]+\])", file(P))[0] + "**")
said(P, "{}: θ is", re.findall(r"final -cos θ in (\[[^]]+\])", file(P))[0] + "**")
said(P, "from collision {}", re.findall(r"from collision (\d+ on 02, 01, 02)", file(P))[0])
said(P, "distance 1.", by=coded("1", "verify/paper/step.toml", "diameter 1 move freely"))
said(P, "is 501/500 and", by=true("1.002 = 501/500", lambda draw: {}))
said(P, "at 45° has", by=coded("45°", P, "`[1, -1]`"))
said(P, "speed is √2; ", by=true("√2 = √(1 + 1)", lambda draw: {}))
said(P, "the speed 1 exactly", by=true("(4/5)² + (3/5)² = 1", lambda draw: {}) + "1")
said(P, "is {}, as of everything", EXIT_CODES[UNDECIDED])
said(
    P,
    "velocities by 10, the same collisions happen 10 times",
    by=true("10 v t/10 = v t", between(1, 2, "v", "t")) + "by 10, 10 times",
)
P = "docs/tutorials/page-of-constants.md"
said(P, "q = (3 - √5)/4", by=coded("q=(3-√5)/4", P, 'q = "(3 - sqrt(5))/4"'))
said(P, "δ = min(q/2, 1/10)", by=coded("δ=min(q/2,1/10)", P, 'delta = "min(q/2, 0.1)"'))
said(P, "2(q + x) with", by=coded("2(q+x)", P, 'slope = "2*(q + x) <= 1 - h"'))
said(P, "1 - 2(q + δ) > 0", by=coded("1-2(q+δ)>0", P, 'h = "1 - 2*(q + delta)"'))
said(P, "2(q + x) - (1 - h)", by=coded("2(q+x)-(1-h)", P, 'slope = "2*(q + x) <= 1 - h"'))

# --- points and bounds that several pages name ----------------------------------------------------

POINT = row("theorem1-r-3-100", "C_eta-below-one")
said(
    "docs/explanation/findings.md",
    "-cos θ₀ = 1/2,",
    by=row("theorem1-r-3-100", "r_stabi-gives-fixed-points"),
)
said(
    "docs/tutorials/referee.md", "and -cos θ₀ = 1/2: there", by=row("printed-sign", "printed-angle")
)
said("docs/explanation/literature.md", "s₁ = 1", by=THEOREMS[2].replace("s_1", "s₁"))
MOVES = coded(
    "", "docs/explanation/literature.md", 'velocities = [[0, 0], ["-0.1", 0], ["-(1-t**2)/(1+t**2)"'
)
said("docs/explanation/literature.md", "particle 1 parts slowly", by="1" + MOVES)
P = "docs/explanation/proof.md"
said(P, "α₀ - φ⁻ < 1, and the", by=true("α - (α - √(α² - 4r))/2 < 1", admissible) + "α₀-φ⁻<1")
said(P, "C_η < 1 |", by=POINT)
said(P, "ζ_n < 1, so", by=row("theorem1-r-3-100", "Cnd3").replace("ζ̄ < 1", "ζ_n < 1,"))
UNIT = dict(
    zip(
        ("neg_cos", "ratio"),
        map(str, Parameters(Fraction(3, 100), Fraction(1), Fraction(1))[1:3]),
        strict=True,
    )
)
said("docs/explanation/sandwich.md", "-cos θ = {}, equal", UNIT["neg_cos"])
P = "docs/explanation/separatrix.md"
said(P, "(for ρ = {}, to", UNIT["ratio"])
said(P, "if ρ = {}.", UNIT["ratio"])
said(
    P,
    "the particles 0-1 and 0-2 do not",
    by=coded(
        "0-1 0-2", "docs/explanation/sandwich.md", "0-1 and 0-2 do not go on colliding in turn"
    ),
)
#: A proof by hand: each formula, and where the program has it.
P, W = "docs/explanation/wall.md", "verify/spheres/flow/wall.py"
DECAYS = "G**2 * x.pair.share(i) <= G * Y[i] + k[i]"
STEP = "x.pair.share(0) * C * (1 - U) - Q"
RATIO = "x.pair.r[0] * x.G * (1 - U) / P, x.G * Q * U / P**2"
LAST = "load > U_next * (2 - U_next) * P**2"
HIGH = "x.pair.share(1) * x.Y[0] / (1 - x.Y[0] * x.Y[1])"
TIME = "G * x.U_b + x.z_b * Y[0] <= x.E * x.w**2 * (1 - Y[0] * Y[1])"
WIDE = "wide = x.U_b * (2 - x.U_b) * x.G**2"
for phrase, code in (
    ("y = -V·ω the", "the speeds at which ball 0 meets ball 1 and leaves the wall"),
    ("u (2 - u) = d (2 + d) |V|²/((1 + d)² y²)", "d * (2 + d) * w * w <= exact(U * (2 - U))"),
    ("flight τ = (1 + d) y u/|V|²,", "later = above(float(G * widest + z_b * fall[0])"),
    ("contact (1 + d) y (1 - u).", "reach = (1 + d) * y"),
    ("b = (1 + r) m_c/(m_o + m_c)", "b_1 = (1+r_1) m_1/(m_0+m_1)"),
    ("b' = 1 + r'.", "b_w = 1 + r_w"),
    ("y' = b (1 + d) y (1 - u) C' - η,", STEP),
    ("r (1 + d) y (1 - u);", RATIO),
    ("S = C₀ - Θ,", "C = x.C_0 - x.Theta"),
    ("q = η/y ≤ Q₀, k ≤ q, u ≤ U₀", "eta <= exact(Q) * y"),
    ("U ≤ U\\*, all z ≤ z\\*;", "0 <= U <= x.U_b < 1 and once[1] <= x.z_b"),
    ("P' > 0 in", "P <= 0 or x.pair.r[1] > Q_next * P"),
    ("P = b S (1 - U) - Q,   Q' = r Γ (1 - U)/P,   z = Γ Q U/P²,", RATIO),
    ("P' = b' S - Q' - z,   r' ≤ Q'' P',   z (2 Q' + z) ≤ U'' (2 - U'') P'²,", LAST),
    ("Γb ≤ Y + k/Γ, Γb' ≤ Y' + k'/Γ,", DECAYS),
    ("k'Y ≤ r(1 - U\\*), kY' ≤ r',", "k[1] * Y[0] <= r[0] * (1 - x.U_b)"),
    ("YY' < 1;", "Y[0] * Y[1] < 1"),
    ("|V| + b'Yy/(1 - YY') ≤ w and", HIGH),
    ("U\\*(2 - U\\*) y²Γ² ≤ w²(Γ² - 1);", WIDE),
    ("ΓU\\* + z\\*Y ≤ E w²(1 - YY'), |C - C₀| + wEy ≤ Θ,", TIME),
    ("(R_c - R_o)/(R_c + R_o).", "``least_cosine`` keeps ball 1 off the wall"),
    ("than |V| ≤ w, so", "and A <= high * high"),
    ("(1+d)² - 1 is at most", "exact(wide) * y * y <= w * w * exact(x.G**2 - 1)"),
    ("times (y/w)²: at most U\\*(2-U\\*)(y/w)²,", WIDE),
    ("1 + d ≤ Γ.", "reach = (1 + d) * y"),
    ("C' ≥ S and 1 + d ≥ 1;", "C = x.C_0 - x.Theta"),
    ("bounds w² times the", TIME),
    ("y'/y ≤ Γb - q ≤ Y since q ≥ k at", DECAYS),
    ("next ≤ b' - q'/Γ ≤ Y' since q' ≥ k' at", DECAYS),
    ("q' ≥ r(1 - U\\*)/Y ≥ k', q'' ≥ r'/Y' ≥ k.", "k[0] * Y[1] <= r[1]"),
    ("at most YY' < 1.", "Y[0] * Y[1] < 1"),
    ("b'Yy/(1 - YY') at most.", HIGH),
    ("ΓU\\*y/w² and z\\*y'/w² each:", TIME),
):
    said(P, phrase, by=coded(phrase, W, code))
P, M = "docs/explanation/separatrix.md", "verify/spheres/limit_map.py"
said(P, "Let ball {} be in", coded("0", M, "The first ball is the one in the middle"))
said(P, "let {} have just", coded("1", M, "the second has just collided with it"))
said(P, "let {} be next;", coded("2", M, "the third one is the next"))
said(P, "each pair {}-i by", "0")
said(P, "root of {},", coded("m_i/(m₀+m_i)", M, "shares = m1 * m2 / ((m0 + m1) * (m0 + m2))"))
said(
    P,
    "α = {} and",
    coded(
        "(1+r)(-cos θ) √(m₁m₂/((m₀+m₁)(m₀+m₂)))", M, "((1 + self.r) * self.neg_cos) ** 2 * shares"
    ),
)
said(
    P,
    "ρ = {} ·",
    coded("|W₁|²/|W₂|²", M, "The ratio is |W|² of the second over that of the third"),
)
said(P, "· {} ·", coded("(R₀+R₂)/(R₀+R₁)", M, "sizes = (middle + after) / (middle + last)"))
said(P, "· {}\n", coded("√(m₁(m₀+m₂)/(m₂(m₀+m₁))),", M, "return m1 * (m0 + m2) / (m2 * (m0 + m1))"))
NEAR = "tests/spheres/test_separatrix_of_balls.py"
said(P, "that start {} %\nbelow", coded("3", NEAR, "strip.low * F(97, 100)"))
said(P, "about ball {}, and", coded("0", NEAR, "collapse about ball 0"))
said(P, "that start {} % above", coded("3", NEAR, "strip.high * F(103, 100)"))
PLANE = json.loads(file("certificates/map/strip/map.json"))["plane"]
said(
    P,
    "At r = {}, -cos θ = {} and the closing speed {},",
    told(PLANE["r"]),
    PLANE["neg_cos"],
    PLANE["speed"],
)
said(
    "docs/explanation/sharper.md",
    "p + Y < 1 |",
    by=coded("p+Y<1", "verify/paper/sharper.toml", "decay-positive: 0 < 1 - ratio"),
)
said("docs/index.md", "at r = {},", R)
said(
    "docs/reference/glossary.md",
    "if ζ < 1.",
    by=row("step", "start-Cnd3").replace("0 < 1 -", "ζ<1."),
)
said(
    "docs/tutorials/page-of-constants.md",
    "t₁ = 1 and t' =",
    by=coded("t₁=1", "docs/tutorials/page-of-constants.md", "start = { k = 1, t = 1 }"),
)
said(
    "docs/tutorials/page-of-constants.md",
    "(1 + √(1 + 4t²))/2, and the proof needs t_k ≥ (k + 1)/2:",
    by=coded("(1+√(1+4t²))/2,", "docs/tutorials/page-of-constants.md", "(1 + sqrt(1 + 4*t^2))/2")
    + coded("t_k≥(k+1)/2", "docs/tutorials/page-of-constants.md", "(k + 1)/2 <= t"),
)
P = "docs/tutorials/three-particles.md"
said(
    P,
    "particle 1 comes from the right, particle 2 from the left, and particle 0 rests",
    by=coded(
        "1 2 0",
        P,
        "positions  = [[0, 0], [1.002, 0], [-1.004, 0.06]] velocities = [[0, 0], [-1.5, 0]",
    ),
)
said(
    P,
    "and -cos θ = 1.",
    by=true("-C = 1", lambda draw: {"C": mp.cos(mp.pi)}).replace("-C", "-cosθ"),
)
said(P, "< 1 |", by=row("step", "start-Cnd3").replace("0 < 1 -", "1"))
ZETA = row("theorem1-r-3-100", "zeta-total")
said("docs/explanation/findings.md", "bounds d_{n+1}", by=row("step-printed", "d-index"))
said("docs/explanation/proof.md", "to ζ_{n+1}, between", by=ZETA)
said("docs/tutorials/referee.md", "term of ζ_{n+1} by", by=ZETA)
A = "docs/explanation/findings.md"
said(A, "at r = 1/60, -cos θ₀ = 38/61", by=row("theorem1-r-3-100", "second-assumption-as-printed"))
said(A, "r = 1/20, -cos θ₀ = 1/2,", by=row("theorem1-r-3-100", "r_stabi-gives-fixed-points"))
said("docs/explanation/proof.md", "for δ_θ = {}.", point()["parameters"]["delta_theta"])
said(
    "docs/explanation/sandwich.md",
    "q = {}, where",
    document("separatrix", "--r", "0.03", "--at", "1/10")["at"],
)
said(
    "docs/explanation/separatrix.md",
    "α ≤ s + s². Along",
    by=coded("α≤s+s²", "verify/coq/SeparatrixExists.v", "LOW : a <= s + s ^ 2"),
)

#: All that was said.
TEXTS = tuple(ENTRIES)
