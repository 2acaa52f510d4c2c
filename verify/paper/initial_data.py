"""The constants of the initial data: delta_x, x_0, Delta_theta, eta_bar, zeta_bar, d_bar.

`printed` transcribes the paper. `repaired` is the list of what the later steps need: each constant
may be any positive rational below its bound, and every sum inside a min of the paper is read as
the bounds that it is meant to provide.

In both sets d_bar is a function of the initial normal speed, min(const, slope * eta_{c,0}^2); the
constant named ``d_bar`` is its value at |eta_{c,0}| = eta_bar, its largest on the set.

The first constants stand before it: alpha_0, the fixed points, delta_1 to delta_5, C_eta, h_4, h_5,
V_1. All but V_1 = V_1(V_0, h_5) depend on r and c alone.
"""

from __future__ import annotations

from collections.abc import Iterable, Iterator

from verify.language.statement import Choice, Constant, Obligation
from verify.language.terms import Claim, Term, as_term, maximum, minimum, sqrt, symbol
from verify.paper.parameters import PRINTED, REPAIRED, THEOREM, V_0, c, delta_theta, r
from verify.paper.rows import OTHERWISE, misprint, needed, printed

alpha_0 = symbol("alpha_0")
phi_minus = symbol("phi_minus")
phi_plus = symbol("phi_plus")
delta_1 = symbol("delta_1")
delta_2 = symbol("delta_2")
delta_3 = symbol("delta_3")
delta_4 = symbol("delta_4")
delta_5 = symbol("delta_5")
C_eta = symbol("C_eta")
h_4 = symbol("h_4")
h_5 = symbol("h_5")
V_1 = symbol("V_1")

discriminant = alpha_0**2 - 4 * r

#: What the paper writes ``alpha_0 - phi_minus``; it is also the larger fixed point.
gap = alpha_0 - phi_minus

CONSTANTS = (
    Constant("alpha_0", "α₀", r"\alpha_0", THEOREM, (1 + r) / 2 * c),
    # (alpha_0 - sqrt(discriminant))/2 cancels as r -> 0; a row shows that the two forms agree.
    Constant("phi_minus", "φ⁻", r"\varphi^-", THEOREM, 2 * r / (alpha_0 + sqrt(discriminant))),
    Constant("phi_plus", "φ⁺", r"\varphi^+", THEOREM, (alpha_0 + sqrt(discriminant)) / 2),
    Constant("delta_1", "δ₁", r"\delta_1", THEOREM, alpha_0 / 2 - phi_minus),
    Constant("delta_2", "δ₂", r"\delta_2", THEOREM, gap / 2),
    Constant("delta_3", "δ₃", r"\delta_3", THEOREM, (1 - gap) / 2),
    Constant("C_eta", "C_η", r"C_\eta", "EQUATSS4.1Quantite_C_eta_", 1 - delta_3),
    Constant("h_4", "h₄", "h_4", "EQUATSS4.1DerivFonctF_1P-", (1 - r / gap**2) / 2),
    # The solution of r / (alpha_0 - (phi_minus + delta_4))^2 = 1 - h_4; likewise delta_5.
    Constant("delta_4", "δ₄", r"\delta_4", THEOREM, gap - sqrt(r / (1 - h_4))),
    Constant("h_5", "h₅", "h_5", "EQUATSS4.1ThExiCondiTheta", (1 - phi_minus / gap**2) / 2),
    Constant("delta_5", "δ₅", r"\delta_5", THEOREM, gap - sqrt(phi_minus / (1 - h_5))),
    Constant("V_1", "V₁", "V_1", "EQUATSS4.1Recurrence_Cnd5", V_0 * ((1 - h_5 / 2) / (1 - h_5))),
)


# --- the constants of the set ---------------------------------------------------------------------


DELTA = "EQUATSS4.1DefinDeltxDelty"
X_0 = "EQUATSS4.1DescrDoIniColla"
ETA = "EQUATSS4.1DefinBorne_Eta_"
ZETA = "EQUATSS4.1DefinBorne_Zeta"
D_0 = "EQUATSS4.1DefinBorne_d_0_"

#: The letter of each constant, for people and in LaTeX, and its label.
WRITTEN = {
    "V_1": ("V₁", "V_1", "EQUATSS4.1Recurrence_Cnd5"),
    "delta_x": ("δ_x", r"\delta_x", DELTA),
    "delta_y": ("δ_y", r"\delta_y", DELTA),
    "x_0": ("|x₀|", "|x_0|", X_0),
    "Delta_theta": ("|Δθ|", r"|\Delta\theta|", X_0),
    "eta_bar": ("η̄", r"\overline{\eta}", ETA),
    "zeta_bar": ("ζ̄", r"\overline{\zeta}", ZETA),
    "d_slope": ("k_d", "k_d", D_0),
    "d_const": ("c_d", "c_d", D_0),
    "d_bar": ("d̄", r"\overline{d}", D_0),
    "T_star": ("T*", "T^*", "THEORSS4.1ExistenCollapse"),
}


class ConstantSet:
    """The constants of one set as symbols, and the quantities of the proof built from them."""

    def __init__(self, group: str) -> None:
        self.group = group
        self.printed = group == PRINTED
        self.V_1 = V_1 if self.printed else self._symbol("V_1")
        self.delta_x = self._symbol("delta_x")
        self.delta_y = self._symbol("delta_y")
        self.x_0 = self._symbol("x_0")
        self.Delta_theta = self._symbol("Delta_theta")
        self.eta_bar = self._symbol("eta_bar")
        self.zeta_bar = self._symbol("zeta_bar")
        self.d_slope = self._symbol("d_slope")
        self.d_const = self._symbol("d_const")
        self.d_bar = self._symbol("d_bar")
        self.T_star = self._symbol("T_star")
        self.speed = sqrt(self.V_1)
        self.unit = V_0 / self.speed

    def _symbol(self, name: str) -> Term:
        return symbol(f"{self.group}.{name}")

    @property
    def initial_slack(self) -> Term | int:
        """How far the initial -cos may be from c: the paper fixes it, the repair leaves a share."""
        return 0 if self.printed else self.Delta_theta / 4

    @property
    def d_later(self) -> Term:
        """The paper's bound on d_n for n >= 1, at |eta_c| = eta_bar."""
        return 3 * self.speed / V_0 * self.eta_bar

    @property
    def d_any(self) -> Term:
        """A bound on d_n for every n."""
        return maximum(self.d_bar, self.d_later)

    @property
    def tau_crude(self) -> Term:
        """The bound 2 eta / V_0 on tau_n."""
        return 2 * self.eta_bar / V_0

    @property
    def drift(self) -> Term:
        """A bound on |(-cos theta_n) - c| for every n: `EQUATSS4.1Recurrence_Cnd8` summed."""
        tail = self.d_bar + 14 / (1 - C_eta) * (self.speed / V_0) * self.eta_bar
        return tail if self.printed else self.initial_slack + tail

    @property
    def norm_drift(self) -> Term:
        """The sum over all collisions in `EQUATSS4.1Recurrence_Cnd6` and `..._Cnd7`."""
        return 4 * (self.speed + 2) / (1 - C_eta) * self.eta_bar

    def row(
        self,
        name: str,
        label: str,
        says: str,
        claim: Claim,
        uses: Iterable[str] = (),
        *,
        if_false: str | None = None,
    ) -> Obligation:
        """A row that both sets have, each about its own constants.

        ``if_false`` is the severity of a row that may be refuted for the printed constants; the
        row of the same name corrects it.
        """
        full = f"{self.group}.{name}"
        if not self.printed:
            return needed(full, label, says, claim, uses, group=self.group)
        if if_false is None:
            return printed(full, label, says, claim, uses, group=self.group)
        better = f"{REPAIRED}.{name}"
        return misprint(full, label, says, claim, if_false, better, uses, group=self.group)

    def misprint(
        self,
        name: str,
        label: str,
        says: str,
        claim: Claim,
        severity: str,
        corrected_by: str,
        uses: Iterable[str] = (),
    ) -> Iterator[Obligation]:
        """A row that only the printed set has, with the name of the row that takes its place.

        That is a row of the repaired set, or of this one where the sentence is true as it stands.
        """
        if self.printed:
            where = self.group if severity == OTHERWISE else REPAIRED
            full, better = f"{self.group}.{name}", f"{where}.{corrected_by}"
            yield misprint(full, label, says, claim, severity, better, uses, group=self.group)

    def aside(
        self, name: str, label: str, says: str, claim: Claim, uses: Iterable[str] = ()
    ) -> Iterator[Obligation]:
        """A row that only the printed set has, against which nothing is known."""
        if self.printed:
            yield printed(f"{self.group}.{name}", label, says, claim, uses, group=self.group)

    def repair(
        self, name: str, label: str, says: str, claim: Claim, uses: Iterable[str] = ()
    ) -> Iterator[Obligation]:
        """A row that only the repaired set has."""
        if not self.printed:
            yield needed(f"{self.group}.{name}", label, says, claim, uses, group=self.group)

    def bounds(self) -> dict[str, tuple[Term, ...]]:
        """The entries of the min that defines or bounds each constant, in the paper's order."""
        return _printed_bounds(self) if self.printed else _repaired_bounds(self)

    def constants(self) -> Iterator[Constant | Choice]:
        """The set's constants, each after those it uses."""
        for name, entries in self.bounds().items():
            term = entries[0] if len(entries) == 1 else minimum(*entries)
            constant = Constant(f"{self.group}.{name}", *WRITTEN[name], term)
            if self.printed or name in {"delta_y", "d_bar"}:
                yield constant
            else:
                base = V_0 if name == "V_1" else None
                yield Choice(constant, "up" if name == "T_star" else "down", base)


def _printed_bounds(k: ConstantSet) -> dict[str, tuple[Term, ...]]:
    return {
        "delta_x": (delta_1, delta_2, delta_3, delta_4, delta_5),
        "delta_y": (k.delta_x,),
        "x_0": ((1 - h_4) * k.delta_x, _x_bound(k)),
        "Delta_theta": (c / 2, h_4 / 8 * k.delta_x, delta_theta),
        "eta_bar": _eta_bar_printed(k),
        "zeta_bar": _zeta_bar_printed(k),
        "d_slope": (k.zeta_bar / (2 * k.V_1),),
        "d_const": _d_const_printed(k),
        "d_bar": (k.d_const, k.d_slope * k.eta_bar**2),
        "T_star": (_collapse_time(k),),
    }


def _repaired_bounds(k: ConstantSet) -> dict[str, tuple[Term, ...]]:
    return {
        "V_1": (V_1,),
        "delta_x": (delta_1, delta_2, delta_3, delta_4, delta_5, _x_bound(k)),
        "delta_y": (k.delta_x,),
        "x_0": ((1 - h_4) * k.delta_x, _x_bound(k)),
        "Delta_theta": (c / 2, h_4 * k.delta_x / 8, delta_theta),
        "eta_bar": _eta_bar_repaired(k),
        "zeta_bar": _zeta_bar_repaired(k),
        "d_slope": (k.zeta_bar / (2 * k.V_1),),
        "d_const": _d_const_repaired(k),
        "d_bar": (k.d_const, k.d_slope * k.eta_bar**2),
        "T_star": (_collapse_time(k),),
    }


def _x_bound(k: ConstantSet) -> Term:
    """(V₀/V₁) δ₂² h₅/12: in the print for x₀ alone, in the repair for every x_n."""
    return V_0 / k.V_1 * (delta_2**2 * h_5 / 12)


def _eta_bar_printed(k: ConstantSet) -> tuple[Term, ...]:
    """The five entries of `EQUATSS4.1DefinBorne_Eta_`; the last is a sum."""
    return (
        as_term(1),
        (sqrt(2) - 1) / 16 * k.unit,
        V_0 / (33 * k.speed) * k.Delta_theta,
        (1 - C_eta) * (k.V_1 - V_0) / (12 * (k.speed + 2)),
        k.unit
        * (2 / (15 * alpha_0) + h_4 * delta_2 / 6 + h_4 / (12 * alpha_0) + h_4 / 24)
        * k.delta_x,
    )


def _eta_bar_repaired(k: ConstantSet) -> tuple[Term, ...]:
    """1/33 becomes (1-C_η)/28, and the sum becomes the three bounds that the steps need."""
    share = h_4 * k.delta_x
    return (
        as_term(1),
        (sqrt(2) - 1) / 16 * k.unit,
        (1 - C_eta) / 28 * k.unit * k.Delta_theta,
        (1 - C_eta) * (k.V_1 - V_0) / (12 * (k.speed + 2)),
        k.unit / (12 * alpha_0) * share,
        k.unit * (delta_2 / 6) * share,
        k.unit / 24 * share,
    )


def _zeta_bar_printed(k: ConstantSet) -> tuple[Term, ...]:
    """The three entries of `EQUATSS4.1DefinBorne_Zeta`; the last is a sum."""
    return (
        2 * (sqrt(2) - 1),
        V_0 * h_5 / (3 * k.V_1 * (alpha_0 + 8 * k.V_1 / V_0)) * delta_2**2,
        (1 + 4 * delta_2 + V_0 / k.V_1) / 16 * h_4 * k.delta_x,
    )


def _zeta_bar_repaired(k: ConstantSet) -> tuple[Term, ...]:
    """The sum becomes three bounds."""
    share = h_4 * k.delta_x
    return (
        2 * (sqrt(2) - 1),
        V_0 * h_5 / (3 * k.V_1 * (alpha_0 + 8 * k.V_1 / V_0)) * delta_2**2,
        share / 16,
        delta_2 / 4 * share,
        V_0 / k.V_1 / 16 * share,
    )


def _d_const_printed(k: ConstantSet) -> tuple[Term, ...]:
    """The entries of `EQUATSS4.1DefinBorne_d_0_` that do not depend on η_{c,0}."""
    return (
        (sqrt(2) - 1) / 4,
        k.Delta_theta / 3,
        (1 + delta_2 * h_4) * k.delta_x / 5,
        (1 + 2 * delta_2) / 4 * h_4 * k.delta_x,
    )


def _d_const_repaired(k: ConstantSet) -> tuple[Term, ...]:
    """A quarter of |Δθ| is left for the initial angle, and the sums become two bounds."""
    share = h_4 * k.delta_x
    return (
        (sqrt(2) - 1) / 4,
        k.Delta_theta / 4,
        delta_2 / 2 * share,
        share / 8,
    )


def _collapse_time(k: ConstantSet) -> Term:
    """2 η̄ ζ̄/(V₀ (1-C_η)), which bounds Σ τ_n."""
    return 2 / (V_0 * (1 - C_eta)) * k.eta_bar * k.zeta_bar


def rows(k: ConstantSet) -> Iterator[Obligation]:
    """Both halves of each definition: every constant is positive and below each of its bounds."""
    label = WRITTEN["V_1"][2]
    yield k.row("V_1-above-V_0", label, "0 < V₀ < V₁", V_0 < k.V_1)
    says = "V₁/V₀ = (1-h₅/2)/(1-h₅), of which ≤ is needed"
    yield k.row("V_1-ratio", label, says, k.V_1 / V_0 <= (1 - h_5 / 2) / (1 - h_5))
    bounds = k.bounds()
    for name, constant in (
        ("delta_x", k.delta_x),
        ("x_0", k.x_0),
        ("Delta_theta", k.Delta_theta),
        ("eta_bar", k.eta_bar),
        ("zeta_bar", k.zeta_bar),
        ("d_slope", k.d_slope),
        ("d_const", k.d_const),
        ("d_bar", k.d_bar),
    ):
        yield from _definition(k, name, constant, bounds[name])


def _definition(
    k: ConstantSet, name: str, constant: Term, entries: tuple[Term, ...]
) -> Iterator[Obligation]:
    letter, _, label = WRITTEN[name]
    yield k.row(f"{name}-positive", label, f"0 < {letter}", 0 < constant)
    for index, entry in enumerate(entries, 1):
        says = f"{letter} is at most entry {index} of its min"
        yield k.row(f"{name}-entry-{index}", label, says, constant <= entry)
