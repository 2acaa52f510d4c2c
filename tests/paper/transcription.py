r"""Blind transcription of the printed proof of Theorem THEORSS4.1ExistenCollapse.

Source: ``collapse.tex`` lines 1108-1598.  The constants are transcribed exactly as
printed and every inequality between constants which the printed proof states or
silently uses becomes one :class:`Row`.  Nothing is judged or repaired; where the
printed step does not follow, or a printed formula is wrong, the comment of the row
starts with ``DEFECT:``.  A comment containing ``EQUALITY`` marks a non-strict
inequality whose two sides are identically equal in the state taken (it cannot be
decided by interval arithmetic, only by algebra).

Standard states (unless the comment says otherwise): ``|eta_{c,0}| = eta_bar``,
``d_0 = d_bar(eta_bar)``, ``zeta_n = zeta_bar``, ``|x_0| = x_0``, and for ``n >= 1``
``|x_n| = delta_x``, ``|y_n| = delta_y``, ``d_n = 3 V_1^(1/2) / V_0 eta_bar``.
"""

from dataclasses import dataclass, replace
from fractions import Fraction
from typing import Any, Literal, Protocol


class Context(Protocol):
    """Arithmetic context: square root, minimum, maximum and absolute value."""

    def sqrt(self, x: Any, /) -> Any:
        """Return the square root of ``x``."""

    def min(self, *xs: Any) -> Any:
        """Return the minimum of the arguments."""

    def max(self, *xs: Any) -> Any:
        """Return the maximum of the arguments."""

    def abs(self, x: Any, /) -> Any:
        """Return the absolute value of ``x``."""


Relation = Literal["<", "<="]


@dataclass(frozen=True)
class Row:
    """One inequality ``lhs relation rhs`` between constants of the proof."""

    label: str
    line: int
    quote: str
    lhs: Any
    relation: Relation
    rhs: Any
    comment: str


def _exact(x: Any) -> Any:
    """Turn an ``int`` into a ``Fraction``, so that a division never makes a float."""
    return Fraction(x) if isinstance(x, int) else x


def constants(K: Context, r: Any, c: Any, V_0: Any, delta_theta: Any) -> dict[str, Any]:
    """Transcribe every constant of the printed proof, exactly as printed.

    ``c`` stands for ``-cos(theta_0)`` and is positive, ``|cos(theta_0)| = c``.
    """
    r, c, V_0, delta_theta = (_exact(x) for x in (r, c, V_0, delta_theta))
    sqrt_2 = K.sqrt(Fraction(2))

    alpha_0 = (1 + r) / 2 * c
    root = K.sqrt(alpha_0**2 - 4 * r)
    phi_minus = (alpha_0 - root) / 2
    phi_plus = (alpha_0 + root) / 2
    delta_1 = alpha_0 / 2 - phi_minus
    delta_2 = (alpha_0 - phi_minus) / 2
    delta_3 = (1 - (alpha_0 - phi_minus)) / 2
    c_eta = 1 - delta_3
    h_4 = (1 - r / (alpha_0 - phi_minus) ** 2) / 2
    # r / (alpha_0 - (phi_minus + delta_4))^2 = 1 - h_4
    delta_4 = alpha_0 - phi_minus - K.sqrt(r / (1 - h_4))
    h_5 = (1 - phi_minus / (alpha_0 - phi_minus) ** 2) / 2
    # phi_minus / (alpha_0 - (phi_minus + delta_5))^2 = 1 - h_5
    delta_5 = alpha_0 - phi_minus - K.sqrt(phi_minus / (1 - h_5))
    v_1 = V_0 * ((1 - h_5 / 2) / (1 - h_5))
    sqrt_v_1 = K.sqrt(v_1)

    delta_x_entries = [delta_1, delta_2, delta_3, delta_4, delta_5]
    delta_x = K.min(*delta_x_entries)

    x_0_entries = [(1 - h_4) * delta_x, V_0 / v_1 * (delta_2**2 * h_5 / 12)]
    x_0 = K.min(*x_0_entries)

    delta_angle_entries = [K.abs(c) / 2, h_4 / 8 * delta_x, delta_theta]
    delta_angle = K.min(*delta_angle_entries)

    eta_bar_entries = [
        Fraction(1),
        (sqrt_2 - 1) / 16 * (V_0 / sqrt_v_1),
        V_0 / (33 * sqrt_v_1) * delta_angle,
        (1 - c_eta) * (v_1 - V_0) / (12 * (sqrt_v_1 + 2)),
        V_0
        / sqrt_v_1
        * (2 / (15 * alpha_0) + h_4 * delta_2 / 6 + h_4 / (12 * alpha_0) + h_4 / 24)
        * delta_x,
    ]
    eta_bar = K.min(*eta_bar_entries)

    zeta_bar_entries = [
        2 * (sqrt_2 - 1),
        V_0 * h_5 / (3 * v_1 * (alpha_0 + 8 * v_1 / V_0)) * delta_2**2,
        (1 + 4 * delta_2 + V_0 / v_1) / 16 * h_4 * delta_x,
    ]
    zeta_bar = K.min(*zeta_bar_entries)

    d_bar_entries = [
        (sqrt_2 - 1) / 4,
        delta_angle / 3,
        (1 + delta_2 * h_4) / 5 * delta_x,
        (1 + 2 * delta_2) / 4 * h_4 * delta_x,
        zeta_bar / (2 * v_1) * eta_bar**2,
    ]
    d_bar = K.min(*d_bar_entries)

    return {
        "r": r,
        "c": c,
        "delta_theta": delta_theta,
        "alpha_0": alpha_0,
        "phi_minus": phi_minus,
        "phi_plus": phi_plus,
        "delta_1": delta_1,
        "delta_2": delta_2,
        "delta_3": delta_3,
        "delta_4": delta_4,
        "delta_5": delta_5,
        "C_eta": c_eta,
        "h_4": h_4,
        "h_5": h_5,
        "V_0": V_0,
        "V_1": v_1,
        "delta_x": delta_x,
        "delta_y": delta_x,
        "x_0": x_0,
        "Delta_theta": delta_angle,
        "eta_bar": eta_bar,
        "zeta_bar": zeta_bar,
        "d_bar": d_bar,
        "delta_x_entries": delta_x_entries,
        "x_0_entries": x_0_entries,
        "Delta_theta_entries": delta_angle_entries,
        "eta_bar_entries": eta_bar_entries,
        "zeta_bar_entries": zeta_bar_entries,
        "d_bar_entries": d_bar_entries,
    }


class _State:
    """The constants and the worst-state bounds shared by the rows."""

    def __init__(self, K: Context, k: dict[str, Any]) -> None:
        """Read the constants ``k`` and prepare the composite bounds."""
        self.K = K
        self.r = k["r"]
        self.c = k["c"]
        self.dtheta = k["delta_theta"]
        self.al = k["alpha_0"]
        self.fm = k["phi_minus"]
        self.fp = k["phi_plus"]
        self.d1 = k["delta_1"]
        self.d2 = k["delta_2"]
        self.d3 = k["delta_3"]
        self.d4 = k["delta_4"]
        self.d5 = k["delta_5"]
        self.ce = k["C_eta"]
        self.h4 = k["h_4"]
        self.h5 = k["h_5"]
        self.v0 = k["V_0"]
        self.v1 = k["V_1"]
        self.dx = k["delta_x"]
        self.dy = k["delta_y"]
        self.x0 = k["x_0"]
        self.dang = k["Delta_theta"]
        self.eta = k["eta_bar"]
        self.zeta = k["zeta_bar"]
        self.d0 = k["d_bar"]
        #: square roots of V_1 and of 2
        self.sv = K.sqrt(self.v1)
        self.s2 = K.sqrt(Fraction(2))
        #: printed bounds of the initial squared norms
        self.low = self.v0 + (self.v1 - self.v0) / 3
        self.high = self.v1 - (self.v1 - self.v0) / 3
        #: alpha_0 - phi_minus, and the smallest |phi_minus - alpha_0 + y_n|
        self.gap = self.al - self.fm
        self.gap_y = self.gap - self.dy
        #: V_1^(1/2) / V_0 * eta_bar
        self.ve = self.sv / self.v0 * self.eta
        #: bound of d_n for n >= 1, and for n >= 0
        self.dn = 3 * self.ve
        self.dmax = K.max(self.d0, self.dn)
        #: tau_n <= 2 eta / V_0 and tau_n <= 2 eta / V_0 zeta
        self.tau = 2 * self.eta / self.v0
        self.tau_z = 2 * self.eta / self.v0 * self.zeta
        #: printed angle bound for n = 0 and its limit n -> infinity
        self.angle_0 = self.d0 + 11 * self.ve
        self.angle = (
            self.angle_0
            + (self.sv / (self.v0 * self.ce))
            * (3 + 11 * self.ce)
            * (self.ce / (1 - self.ce))
            * self.eta
        )
        #: bound of the accumulated variation of the squared norms
        self.norms = 4 * (self.sv + 2) * self.eta / (1 - self.ce)
        #: 1 - sqrt(1 - zeta_bar)
        self.bracket = 1 - K.sqrt(1 - self.zeta)


_P = "EQUATSS4.1"


def _preliminaries(s: _State) -> list[Row]:
    """Rows of the hypotheses and preliminary constants (lines 1108-1190)."""
    r_lab, t_lab = _P + "ThExiCondi_r_1_", _P + "ThExiCondiTheta"
    f_lab, c_lab = _P + "DerivFonctF_1P-", _P + "Quantite_C_eta_"
    ratio = s.fm / s.gap**2
    return [
        Row(r_lab, 1113, r"0 < r", 0, "<", s.r, "hypothesis"),
        Row(
            r_lab,
            1113,
            r"r < r_\text{stabi} with r_\text{stabi} = 9-4\sqrt{5}",
            s.r,
            "<",
            9 - 4 * s.K.sqrt(Fraction(5)),
            "hypothesis",
        ),
        Row(
            r_lab,
            1115,
            r"\theta_0 \in\, ]\pi/2,\pi]",
            s.c,
            "<=",
            1,
            "hypothesis (EQUALITY at theta_0 = pi); theta_0 > pi/2 is the next row",
        ),
        Row(t_lab, 1118, r"0 < -\cos\theta_0", 0, "<", s.c, "hypothesis"),
        Row(
            t_lab,
            1118,
            r"-\cos\theta_0 < \frac{2r^{1/3}(1+r^{1/3})}{1+r}",
            s.al**3,
            "<",
            3 * s.r * s.al + s.r + s.r**2,
            "DEFECT: the printed inequality is reversed (h_5 > 0 needs '>', as in"
            " EQUATSS3.4ZKCl2CondiStabi). Written without cube root: alpha_0 <"
            " u = r^(1/3)+r^(2/3), u the positive root of u^3 = 3 r u + r + r^2",
        ),
        Row(
            t_lab,
            1120,
            r"let $\delta_\theta$ be any positive real number",
            0,
            "<",
            s.dtheta,
            "hypothesis",
        ),
        Row(t_lab, 1133, r"$\alpha_0$ as the positive quantity", 0, "<", s.al, ""),
        Row(t_lab, 1137, r"smaller than $1$", s.al, "<", 1, "alpha_0 < 1"),
        Row(
            t_lab,
            1141,
            r"has the two positive fixed points",
            4 * s.r,
            "<",
            s.al**2,
            "DEFECT: said to follow from 0 < r < r_stabi alone; it needs"
            " -cos(theta_0) > 4 sqrt(r)/(1+r), i.e. the (correct) angle condition",
        ),
        Row(t_lab, 1141, r"the two positive fixed points", 0, "<", s.fm, "phi_minus"),
        Row(t_lab, 1145, r"$\varphi_{1,\alpha_0}^-$, the smaller", s.fm, "<", s.fp, ""),
        Row(
            t_lab,
            1139,
            r"\varphi_1 \mapsto \frac{r}{\alpha_0 - \varphi_1}",
            s.fp,
            "<",
            s.al,
            "silent: both fixed points lie left of the pole alpha_0",
        ),
        Row(
            f_lab,
            1148,
            r"\frac{r}{( \alpha_0 - \varphi_{1,\alpha_0}^- )^2} < 1",
            s.r / s.gap**2,
            "<",
            1,
            "",
        ),
        Row(
            f_lab,
            1145,
            r"where only $\varphi_{1,\alpha_0}^-$, the smaller, is stable",
            1,
            "<",
            s.r / (s.al - s.fp) ** 2,
            "phi_plus is not stable ('only')",
        ),
        Row(
            f_lab,
            1150,
            r"By definition, $\varphi_{1,\alpha_0}^- < \alpha_0/2$",
            s.fm,
            "<",
            s.al / 2,
            "",
        ),
        Row(f_lab, 1152, r"\delta_1 = ... > 0", 0, "<", s.d1, ""),
        Row(
            f_lab,
            1156,
            r"-1 < \varphi_{1,\alpha_0}^- - \alpha_0",
            -1,
            "<",
            s.fm - s.al,
            "",
        ),
        Row(
            f_lab,
            1156,
            r"\varphi_{1,\alpha_0}^- - \alpha_0 < 0",
            s.fm - s.al,
            "<",
            0,
            "",
        ),
        Row(f_lab, 1158, r"the two positive quantities: delta_2", 0, "<", s.d2, ""),
        Row(f_lab, 1158, r"the two positive quantities: delta_3", 0, "<", s.d3, ""),
        Row(c_lab, 1162, r"positive real number $0 < C_\eta < 1$", 0, "<", s.ce, ""),
        Row(c_lab, 1162, r"positive real number $0 < C_\eta < 1$", s.ce, "<", 1, ""),
        Row(c_lab, 1167, r"denote by $h_4$ the positive quantity", 0, "<", s.h4, ""),
        Row(
            c_lab,
            1173,
            r"= 1 - h_4",
            s.h4,
            "<",
            1,
            "silent: 1 - h_4 must be positive for delta_4 and |x_0|",
        ),
        Row(c_lab, 1171, r"the positive quantity $\delta_4$", 0, "<", s.d4, ""),
        Row(
            c_lab,
            1173,
            r"\alpha_0 - (\varphi_{1,\alpha_0}^-+\delta_4)",
            s.d4,
            "<",
            s.gap,
            "silent: choice of the root, the squared quantity is positive",
        ),
        Row(c_lab, 1175, r"ensures that the positive quantity", 0, "<", ratio, ""),
        Row(
            c_lab,
            1179,
            r"is strictly smaller than $1$",
            ratio,
            "<",
            1,
            "DEFECT: said to follow from EQUATSS4.1ThExiCondiTheta; as printed that"
            " assumption is the opposite of what is needed (it gives > 1)",
        ),
        Row(c_lab, 1179, r"denote by $h_5$ the positive quantity", 0, "<", s.h5, ""),
        Row(
            c_lab,
            1185,
            r"= 1 - h_5",
            s.h5,
            "<",
            1,
            "silent: 1 - h_5 must be positive for delta_5 and V_1/V_0",
        ),
        Row(c_lab, 1183, r"the positive quantity $\delta_5$", 0, "<", s.d5, ""),
        Row(
            c_lab,
            1185,
            r"\alpha_0 - (\varphi_{1,\alpha_0}^- + \delta_5)",
            s.d5,
            "<",
            s.gap,
            "silent: choice of the root, the squared quantity is positive",
        ),
        Row(c_lab, 1187, r"two positive numbers $0 < V_0 < V_1$", 0, "<", s.v0, ""),
        Row(c_lab, 1187, r"two positive numbers $0 < V_0 < V_1$", s.v0, "<", s.v1, ""),
        Row(
            c_lab,
            1189,
            r"\frac{V_1}{V_0} = \frac{1-h_5/2}{1-h_5}",
            1,
            "<",
            (1 - s.h5 / 2) / (1 - s.h5),
            "silent: compatibility of the ratio with V_0 < V_1",
        ),
    ]


def _initial_set(s: _State) -> list[Row]:
    """Rows of the definition of the initial set (lines 1262-1304)."""
    x_lab, e_lab = _P + "DefinDeltxDelty", _P + "DefinBorne_Eta_"
    i_lab = _P + "DescrDoIniColla"
    return [
        Row(x_lab, 1265, r"\delta_x = \delta_y = \text{min}", 0, "<", s.dx, "silent"),
        Row(x_lab, 1269, r"\vert x_0 \vert = \text{min}", 0, "<", s.x0, "silent"),
        Row(
            x_lab,
            1273,
            r"\vert \Delta \theta \vert = \text{min}",
            0,
            "<",
            s.dang,
            "silent",
        ),
        Row(
            e_lab,
            1278,
            r"\overline{\eta} = \text{min}",
            0,
            "<",
            s.eta,
            "silent. DEFECT: the fifth entry is a SUM of the four numbers 2/(15"
            " alpha_0), h_4 delta_2/6, h_4/(12 alpha_0), h_4/24 where the proof needs"
            " each of them (their minimum); and the third entry lacks (1-C_eta)",
        ),
        Row(
            _P + "DefinBorne_Zeta",
            1282,
            r"\overline{\zeta} = \text{min}",
            0,
            "<",
            s.zeta,
            "silent. DEFECT: the third entry is a SUM 1 + 4 delta_2 + V_0/V_1 where"
            " the proof needs the minimum of the three numbers",
        ),
        Row(
            _P + "DefinBorne_d_0_",
            1287,
            r"\overline{d}((-\eta_{c,0})) = \text{min}",
            0,
            "<",
            s.d0,
            "silent, at |eta_{c,0}| = eta_bar. DEFECT: entries three and four are SUMS"
            " 1 + delta_2 h_4 and 1 + 2 delta_2 where minima are needed; the third"
            " lacks h_4 in front of 1",
        ),
        Row(
            i_lab,
            1300,
            r"V_0 + \frac{1}{3}(V_1-V_0) \leq ... \leq V_1 - \frac{1}{3}(V_1-V_0)",
            s.low,
            "<",
            s.high,
            "silent: the range of the initial norms has an interior",
        ),
        Row(
            i_lab,
            1297,
            r"\vert \eta_{2,0} \vert \leq \overline{\eta}",
            s.eta**2,
            "<=",
            s.low,
            "silent compatibility |eta_{c,0}| <= |W_{c,0}| on the whole range",
        ),
    ]


def _init_zeta_norms(s: _State) -> list[Row]:
    """Rows of the initialization of Cnd1 to Cnd7 (lines 1370-1378)."""
    z_lab = _P + "BorneParam_ZK0_"
    fraction = s.d0 * (2 + s.d0) / (1 + s.d0) ** 2
    return [
        Row(
            _P + "Recurrence_Cnd1",
            1371,
            r"By assumption, $\eta_{2,0} = \eta_{c,0} < 0$",
            -s.eta,
            "<",
            0,
            "eta_{c,0} = -eta_bar",
        ),
        Row(
            _P + "Recurrence_Cnd2",
            1371,
            r"By construction, the first inequality in ... holds true",
            s.eta,
            "<=",
            s.eta,
            "EQUALITY, |eta_{c,0}| = eta_bar",
        ),
        Row(
            z_lab,
            1377,
            r"the quantity $x(2+x)/(1+x)^2$ is always bounded from above by $2$",
            fraction,
            "<=",
            2,
            "x = d_bar. DEFECT: the bound needed (and used in the display) is 2x, not"
            " 2; see the next row",
        ),
        Row(
            z_lab,
            1375,
            r"\zeta_0 ... \leq 2d_0 \frac{\vert W_{c,0} \vert^2}{(\eta_{c,0})^2}",
            fraction,
            "<=",
            2 * s.d0,
            "d_0 = d_bar",
        ),
        Row(
            z_lab,
            1377,
            r"$\vert W_{c,0} \vert^2 \leq V_1 - \frac{1}{3}(V_1-V_0) \leq V_1$",
            s.high,
            "<=",
            s.v1,
            "",
        ),
        Row(
            _P + "Recurrence_Cnd4",
            1377,
            r"we deduce that ... hold ... according to our assumptions",
            2 * s.d0 * s.v1 / s.eta**2,
            "<=",
            s.zeta,
            "2 d_0 V_1/eta^2 with d_0 = d_bar(eta_bar), |eta| = eta_bar; EQUALITY"
            " when the last entry of d_bar is the smallest",
        ),
        Row(
            _P + "Recurrence_Cnd4",
            1377,
            r"we deduce that ... hold ... according to our assumptions",
            2 * (s.zeta / (2 * s.v1)) * s.v1,
            "<=",
            s.zeta,
            "EQUALITY; alternative state: any |eta_{c,0}| <= eta_bar, with d_0 the"
            " last entry of d_bar",
        ),
        Row(
            _P + "Recurrence_Cnd3",
            1377,
            r"we deduce that Cnd3 ... hold",
            s.zeta,
            "<",
            1,
            "zeta_0 = zeta_bar",
        ),
        Row(
            _P + "Recurrence_Cnd5",
            1378,
            r"Cnd5 holds by construction",
            s.v0,
            "<=",
            s.low,
            "lower side at the smallest initial norm",
        ),
        Row(
            _P + "Recurrence_Cnd5",
            1378,
            r"Cnd5 holds by construction",
            s.high,
            "<=",
            s.v1,
            "upper side at the largest initial norm",
        ),
        Row(
            _P + "Recurrence_Cnd6",
            1378,
            r"Cnd6 is trivial since $n=0$",
            0,
            "<=",
            0,
            "EQUALITY (empty sum, independent of the parameters). DEFECT: n = 0 is"
            " even, the condition concerned is Cnd7",
        ),
    ]


def _init_collision_angle(s: _State) -> list[Row]:
    """Rows of the initialization of CndT and Cnd8 (lines 1379-1403)."""
    t_lab, d_lab = _P + "Recurrence_CndT", _P + "BorneDista_d_1_"
    a_lab = _P + "Recurrence_Cnd8"
    x = s.sv * s.tau
    return [
        Row(
            t_lab,
            1381,
            r"\tau_0 \leq 2 \frac{(-\eta_{c,0})}{\vert W_{c,0} \vert^2} [...]",
            1 + s.d0,
            "<=",
            2,
            "d_0 = d_bar",
        ),
        Row(
            t_lab,
            1381,
            r"[ 1 - \sqrt{1-\zeta_0} ] ... \leq ... \zeta_0",
            s.bracket,
            "<=",
            s.zeta,
            "zeta_0 = zeta_bar",
        ),
        Row(
            t_lab,
            1381,
            r"\leq 2\frac{(-\eta_{c,0})}{V_0} \zeta_0",
            s.v0,
            "<=",
            s.low,
            "|W_{c,0}|^2 at the smallest initial norm",
        ),
        Row(
            t_lab,
            1383,
            r"by assumption $\cos\theta_0 < 0$",
            0,
            "<",
            s.c,
            "",
        ),
        Row(
            t_lab,
            1385,
            r"\vert \omega_{1,0} - \omega_{2,0} \vert \geq \sqrt{2}",
            s.s2,
            "<=",
            s.K.sqrt(2 + 2 * s.c),
            "|omega_1 - omega_2|^2 = 2 - 2 cos(theta_0)",
        ),
        Row(
            t_lab,
            1389,
            r"\geq \sqrt{2} - d_0 - 2V_1^{1/2}\tau_0",
            2 * s.K.sqrt(s.high),
            "<=",
            2 * s.sv,
            "|W_{c,0}| + |W_{s,0}| at the largest initial norms",
        ),
        Row(
            t_lab,
            1391,
            r"which is strictly larger than $1$ according to the assumptions",
            1,
            "<",
            s.s2 - s.d0 - 2 * s.sv * s.tau_z,
            "d_0 = d_bar, tau_0 = 2 eta_bar zeta_bar/V_0 (the printed crude bound)",
        ),
        Row(
            d_lab,
            1395,
            r"\sqrt{1 + 2\eta\tau + |W|^2\tau^2} - 1 \leq \eta\tau + |W|^2\tau^2/2",
            s.K.sqrt(1 + 2 * x + x**2) - 1,
            "<=",
            x + x**2 / 2,
            "|eta_{s,0}| = |W_{s,0}| = V_1^(1/2), tau_0 = 2 eta_bar/V_0",
        ),
        Row(
            d_lab,
            1398,
            r"small enough to have $V_1 \tau_0^2 \leq V_1^{1/2}\tau_0$",
            s.v1 * s.tau**2,
            "<=",
            x,
            "tau_0 = 2 eta_bar/V_0",
        ),
        Row(
            d_lab,
            1398,
            r"$V_1^{1/2}\tau_0 \leq 1$",
            x,
            "<=",
            1,
            "tau_0 = 2 eta_bar/V_0",
        ),
        Row(
            d_lab,
            1396,
            r"\leq \frac{3}{2} V_1^{1/2} \tau_0",
            x + s.v1 * s.tau**2 / 2,
            "<=",
            x * 3 / 2,
            "|eta_{s,0}| = |W_{s,0}| = V_1^(1/2), tau_0 = 2 eta_bar/V_0",
        ),
        Row(
            d_lab,
            1396,
            r"\frac{3}{2} V_1^{1/2}\tau_0 \leq 3 \frac{V_1^{1/2}}{V_0}(-\eta_{c,0})",
            s.sv * s.tau_z * 3 / 2,
            "<=",
            3 * s.ve,
            "tau_0 = 2 eta_bar zeta_bar/V_0; uses zeta_bar <= 1",
        ),
        Row(
            a_lab,
            1400,
            r"... + 2 \tau_0 \vert W_{s,0} \vert + ...",
            (1 + s.d0) / (1 + Fraction(0)),
            "<=",
            2,
            "(1+d_0)/(1+d_1) <= 2 with d_0 = d_bar, d_1 = 0",
        ),
        Row(
            a_lab,
            1401,
            r"|\frac{1+d_0}{1+d_1} - 1| (-\cos\theta_0) \leq d_0 + d_1",
            s.K.max(s.d0, s.dn / (1 + s.dn)) * s.c,
            "<=",
            s.d0 + s.dn,
            "extremes d_1 = 0, d_0 = d_bar and d_0 = 0, d_1 = 3 V_1^(1/2)/V_0 eta_bar;"
            " uses -cos(theta_0) <= 1",
        ),
        Row(
            a_lab,
            1401,
            r"\tau_0|W_{c,0}| + 2\tau_0|W_{s,0}| + \tau_0^2 ... \leq 4V_1^{1/2}\tau_0",
            3 * x + s.v1 * s.tau**2,
            "<=",
            4 * x,
            "tau_0 = 2 eta_bar/V_0, |W|^2 = V_1",
        ),
        Row(
            a_lab,
            1402,
            r"\leq d_0 + 11 \frac{V_1^{1/2}}{V_0}(-\eta_{c,0})",
            s.d0 + s.dn + 4 * x,
            "<=",
            s.angle_0,
            "EQUALITY; d_1 = 3 V_1^(1/2)/V_0 eta_bar, tau_0 = 2 eta_bar/V_0",
        ),
        Row(
            a_lab,
            1392,
            r"The condition Cnd8 on the variation of the angle (n = 0)",
            s.angle_0,
            "<=",
            s.dang,
            "silent: 'Delta theta will be used to measure the maximal variation of"
            " the angles'; n = 0, empty sum",
        ),
    ]


def _init_ratios(s: _State) -> list[Row]:
    """Rows of the initialization of Cnd9 and Cnd10 (lines 1404-1418)."""
    x_lab, y_lab = _P + "Recurrence_Cnd9", _P + "Recurrence_Cnd10"
    quarter = s.h4 * s.dx / 4
    three = s.K.max(s.d0, 2 * s.zeta)
    five = s.v1 * 4 * s.d0 / s.eta**2
    small = r"all the five terms ..., except $|x_0|$, are smaller than h_4 \delta_x/4"
    return [
        Row(
            x_lab,
            1404,
            r"holds true by assumption for $n=0$",
            s.x0,
            "<=",
            s.dx,
            "|x_0| at its bound",
        ),
        Row(
            y_lab,
            1413,
            r"By assumption on $x_0$, $|\eta_{s,0}/\eta_{c,0}| \leq \alpha_0/2$",
            s.fm + s.x0,
            "<=",
            s.al / 2,
            "|x_0| at its bound. DEFECT: EQUATSS4.1EvoluCompoNormC, on which the"
            " decomposition rests, is stated 'for all n >= 1' but used here at n = 0",
        ),
        Row(
            y_lab,
            1417,
            small + " (first term)",
            s.dn * s.al / 2,
            "<=",
            quarter,
            "|1/(1+d_1) - 1| <= d_1 = 3 V_1^(1/2)/V_0 eta_bar (BorneDista_d_1_)."
            " DEFECT: not guaranteed by eta_bar, whose fifth entry is a sum",
        ),
        Row(
            y_lab,
            1413,
            r"$x_0$, which is smaller in absolute value than $(1-h_4)\delta_x$",
            s.x0,
            "<=",
            (1 - s.h4) * s.dx,
            "second term; EQUALITY when the first entry of x_0 is the smallest",
        ),
        Row(
            y_lab,
            1413,
            r"the third term is bounded from above by $\text{Max}(d_0,2\zeta_0)$",
            (1 + s.r) / 2,
            "<=",
            1,
            "silent: the factor (1+r)/2 is dropped (third and fourth terms)",
        ),
        Row(
            y_lab,
            1413,
            r"the third term is bounded from above by $\text{Max}(d_0,2\zeta_0)$",
            s.K.max(s.d0, s.bracket),
            "<=",
            three,
            "|(1+d_0) sqrt(1-zeta_0) - 1| extremes: zeta_0 = 0, d_0 = d_bar and"
            " d_0 = 0, zeta_0 = zeta_bar",
        ),
        Row(
            y_lab,
            1417,
            small + " (third term, d_0)",
            s.d0,
            "<=",
            quarter,
            "d_0 = d_bar. DEFECT: not guaranteed by entries three and four of d_bar,"
            " which are sums",
        ),
        Row(
            y_lab,
            1417,
            small + r" (third term, 2\zeta_0)",
            2 * s.zeta,
            "<=",
            quarter,
            "zeta_0 = zeta_bar. DEFECT: not guaranteed by the third entry of zeta_bar,"
            " which is a sum",
        ),
        Row(
            y_lab,
            1417,
            small + " (fourth term)",
            s.angle_0,
            "<=",
            quarter,
            "bound d_0 + 11 V_1^(1/2)/V_0 eta of the variation of the angle",
        ),
        Row(
            y_lab,
            1415,
            r"\tau_0 \leq 2\frac{(-\eta_{c,0})}{|W_{c,0}|^2}\zeta_0 \leq 4 d_0/(-\eta)",
            (2 * s.eta / s.v1) * (2 * s.d0 * s.v1 / s.eta**2),
            "<=",
            4 * s.d0 / s.eta,
            "EQUALITY; zeta_0 = 2 d_0 |W|^2/eta^2 with |W|^2 = V_1",
        ),
        Row(
            y_lab,
            1417,
            small + " (fifth term)",
            five,
            "<=",
            quarter,
            "V_1 tau_0/(-eta) with tau_0 = 4 d_0/(-eta), d_0 = d_bar(eta_bar)."
            " DEFECT: not guaranteed by zeta_bar (sum)",
        ),
        Row(
            y_lab,
            1417,
            small + " (fifth term)",
            s.v1 * 4 * (s.zeta / (2 * s.v1)),
            "<=",
            quarter,
            "alternative state: d_0 = last entry of d_bar, the supremum over all"
            " |eta_{c,0}| <= eta_bar. DEFECT: as in the previous row",
        ),
        Row(
            y_lab,
            1417,
            r"we deduce that the bound Cnd10 holds initially",
            4 * quarter + (1 - s.h4) * s.dx,
            "<=",
            s.dy,
            "EQUALITY; the four small terms at h_4 delta_x/4",
        ),
        Row(
            y_lab,
            1417,
            r"we deduce that the bound Cnd10 holds initially",
            s.dn * s.al / 2 + s.x0 + three + s.angle_0 + five,
            "<=",
            s.dy,
            "the five terms added at their own bounds (n = 0)",
        ),
    ]


def _step_norms(s: _State) -> list[Row]:
    """Rows of the propagation of the norm bounds (lines 1420-1452)."""
    n_lab, t_lab = _P + "EvoluNormeVitRl", _P + "_Controle_Tau_n"
    b_lab = _P + "Recurrence_Cnd5"
    x = s.sv * s.tau
    factor = 4 * (s.sv + 2)
    return [
        Row(
            n_lab,
            1428,
            r"\leq 2 |W_{s,n}| \cdot |W_{c,n} \cdot \omega_{s,n+1}| + ...",
            1 + s.r,
            "<=",
            2,
            "coefficient (1+r) of the cross term",
        ),
        Row(
            n_lab,
            1428,
            r"... + 2 |W_{c,n} \cdot \omega_{s,n+1}|^2",
            (1 + s.r) ** 2 / 2,
            "<=",
            2,
            "coefficient of the square as printed. DEFECT: in EQUATSS4.1EvoluNormeVitRl"
            " the coefficient must be (1+r)^2/4",
        ),
        Row(
            n_lab,
            1430,
            r"2 V_1^{1/2}(1+d_n)(-\eta) + 2(1+d_n)^2(-\eta)^2 \leq 4(V_1^{1/2}+2)...",
            2 * s.sv * (1 + s.d0) * s.eta + 2 * (1 + s.d0) ** 2 * s.eta**2,
            "<=",
            factor * s.eta,
            "n = 0: d_0 = d_bar, |eta| = eta_bar",
        ),
        Row(
            n_lab,
            1430,
            r"2 V_1^{1/2}(1+d_n)(-\eta) + 2(1+d_n)^2(-\eta)^2 \leq 4(V_1^{1/2}+2)...",
            2 * s.sv * (1 + s.dn) * s.eta + 2 * (1 + s.dn) ** 2 * s.eta**2,
            "<=",
            factor * s.eta,
            "n >= 1: d_n = 3 V_1^(1/2)/V_0 eta_bar, |eta| = eta_bar",
        ),
        Row(
            n_lab,
            1432,
            r"$(-\eta_{c,n})^2 \leq (-\eta_{c,n})$",
            s.eta**2,
            "<=",
            s.eta,
            "EQUALITY when eta_bar = 1 (its first entry)",
        ),
        Row(
            n_lab,
            1432,
            r"$(-\eta_{c,n}) \leq 1$",
            s.eta,
            "<=",
            1,
            "EQUALITY when eta_bar = 1",
        ),
        Row(
            n_lab,
            1434,
            r"V_1^{1/2}\tau_n + \frac{1}{2}V_1\tau_n^2 \leq \frac{3}{2}V_1^{1/2}\tau_n",
            x + s.v1 * s.tau**2 / 2,
            "<=",
            x * 3 / 2,
            "tau = 2 eta_bar/V_0. DEFECT: shifted index, the display bounds d_{n+1}:"
            " d_n is bounded by tau_{n-1} and |eta_{c,n-1}|, not |eta_{c,n}|",
        ),
        Row(
            n_lab,
            1434,
            r"\frac{3}{2} V_1^{1/2}\tau_n \leq 3 \frac{V_1^{1/2}}{V_0}(-\eta_{c,n})",
            x * 3 / 2,
            "<=",
            s.dn,
            "EQUALITY; tau = 2 eta_bar/V_0. DEFECT: index, as in the previous row",
        ),
        Row(
            t_lab,
            1439,
            r"\tau_n \leq 2 \frac{(-\eta_{c,n})}{|W_{c,n}|^2}\zeta_n (1+d_n \leq 2)",
            s.d0,
            "<=",
            1,
            "silent, n = 0: d_0 = d_bar",
        ),
        Row(
            t_lab,
            1439,
            r"\tau_n \leq 2 \frac{(-\eta_{c,n})}{|W_{c,n}|^2}\zeta_n (1+d_n \leq 2)",
            s.dn,
            "<=",
            1,
            "silent, n >= 1: d_n = 3 V_1^(1/2)/V_0 eta_bar. DEFECT: d_n <= 1 is used"
            " but never stated",
        ),
        Row(
            t_lab,
            1439,
            r"1 - \sqrt{1-\zeta_n} \leq \zeta_n",
            s.bracket,
            "<=",
            s.zeta,
            "silent: zeta_n = zeta_bar",
        ),
        Row(
            t_lab,
            1439,
            r"2\frac{(-\eta_{c,n})}{|W_{c,n}|^2}\zeta_n \leq 2\frac{(-\eta)}{V_0}",
            s.tau_z,
            "<=",
            s.tau,
            "|W|^2 = V_0, zeta_n = zeta_bar; uses zeta_bar <= 1",
        ),
        Row(
            t_lab,
            1441,
            r"$V_1 \tau_n^2 \leq V_1^{1/2} \tau_n$",
            s.v1 * s.tau**2,
            "<=",
            x,
            "tau_n = 2 eta_bar/V_0",
        ),
        Row(t_lab, 1441, r"$V_1^{1/2} \tau_n \leq 1$", x, "<=", 1, "idem"),
        Row(
            t_lab,
            1443,
            r"|W_{s,n+1}|^2 - |W_{c,n}|^2 \leq (1+d_n)^2 (-\eta_{c,n})^2",
            s.r**2 - 1,
            "<=",
            1,
            "coefficient r^2 - 1 of (W_c.omega)^2. DEFECT: only an upper bound (the"
            " left side is <= 0); the lower bound -(1+d_n)^2 eta^2 is the useful one",
        ),
        Row(
            t_lab,
            1443,
            r"(1+d_n)^2 (-\eta_{c,n})^2 \leq 4 (-\eta_{c,n})",
            (1 + s.dmax) ** 2 * s.eta**2,
            "<=",
            4 * s.eta,
            "d_n = max(d_bar, 3 V_1^(1/2)/V_0 eta_bar)",
        ),
        Row(
            _P + "Recurrence_Cnd7",
            1443,
            r"In the same way, for $|W_{s,n+1}|^2$ we find ... 4(-\eta_{c,n})",
            4 * s.eta,
            "<=",
            factor * s.eta,
            "silent: 4 <= 4 (V_1^(1/2) + 2)",
        ),
        Row(
            _P + "Recurrence_Cnd7",
            1449,
            r"\leq 4(V_1^{1/2} + 2) (\sum_{k=0}^{n} C_\eta^k)(-\eta_{2,0})",
            factor * s.ce * s.eta + factor * s.eta,
            "<=",
            factor * (1 + s.ce) * s.eta,
            "EQUALITY; n = 1 as representative, |eta_{c,n}| = C_eta^n eta_bar",
        ),
        Row(
            b_lab,
            1452,
            r"$\sum_{k=0}^n C_\eta^k < (1-C_\eta)^{-1}$",
            1 + s.ce,
            "<",
            1 / (1 - s.ce),
            "n = 1 as representative",
        ),
        Row(
            b_lab,
            1452,
            r"smaller than $(1-C_\eta)(V_1-V_0)\cdot(12 (V_1^{1/2} + 2))^{-1}$",
            s.eta,
            "<=",
            (1 - s.ce) * (s.v1 - s.v0) / (12 * (s.sv + 2)),
            "by construction; EQUALITY when that entry of eta_bar is the smallest",
        ),
        Row(
            b_lab,
            1452,
            r"we deduce that the inequalities Cnd5 holds also for $n+1$ (upper)",
            s.high + s.norms,
            "<=",
            s.v1,
            "initial norm V_1 - (V_1-V_0)/3 plus the limit of the sum; EQUALITY when"
            " the fourth entry of eta_bar is the smallest",
        ),
        Row(
            b_lab,
            1452,
            r"we deduce that the inequalities Cnd5 holds also for $n+1$ (lower)",
            s.v0,
            "<=",
            s.low - s.norms,
            "initial norm V_0 + (V_1-V_0)/3 minus the limit of the sum; EQUALITY when"
            " the fourth entry of eta_bar is the smallest. DEFECT: Cnd6,"
            " Cnd7 and their proof only bound the increase from above; no lower bound"
            " of the norms is proved",
        ),
    ]


def _step_eta(s: _State) -> list[Row]:
    """Rows of the propagation of Cnd1 and Cnd2 (lines 1454-1482)."""
    lab = _P + "Recurrence_Cnd10"
    two = _P + "Recurrence_Cnd2"
    return [
        Row(
            lab,
            1476,
            r"\vert y_n \vert \leq \delta_2",
            s.dy,
            "<=",
            s.d2,
            "|y_n| = delta_y; EQUALITY when delta_2 is the smallest. DEFECT: Cnd10 at"
            " rank n is used although line 1421 only"
            " assumes Cnd1-Cnd8 (line 1420 likewise announces Cnd1-Cnd8)",
        ),
        Row(
            lab,
            1476,
            r"\vert y_n \vert \leq \delta_3",
            s.dy,
            "<=",
            s.d3,
            "idem; EQUALITY when delta_3 is the smallest",
        ),
        Row(lab, 1480, r"-1 < -1 + \delta_3", -1, "<", s.d3 - 1, ""),
        Row(
            lab,
            1480,
            r"-1 + \delta_3 \leq \varphi_{1,\alpha_0}^- - \alpha_0 + y_n",
            s.d3 - 1,
            "<=",
            s.fm - s.al - s.dy,
            "y_n = -delta_y; EQUALITY when delta_y = delta_3",
        ),
        Row(
            _P + "Recurrence_Cnd1",
            1480,
            r"\varphi_{1,\alpha_0}^- - \alpha_0 + y_n \leq - \delta_2",
            s.fm - s.al + s.dy,
            "<=",
            -s.d2,
            "y_n = delta_y; EQUALITY when delta_y = delta_2",
        ),
        Row(_P + "Recurrence_Cnd1", 1480, r"- \delta_2 < 0", -s.d2, "<", 0, ""),
        Row(
            two,
            1482,
            r"we have in addition $|\eta_{c,n+1}| \leq C_\eta |\eta_{c,n}|$",
            s.gap + s.dy,
            "<=",
            s.ce,
            "y_n = -delta_y; EQUALITY when delta_y = delta_3",
        ),
        Row(
            two,
            1482,
            r"the estimates Cnd1 and Cnd2 are proved for $n+1$",
            s.ce * s.eta,
            "<=",
            s.eta,
            "|eta_{c,n}| = eta_bar",
        ),
    ]


def _step_zeta(s: _State) -> list[Row]:
    """Rows of the propagation of Cnd3 and Cnd4 (lines 1483-1532)."""
    y_lab, z_lab = _P + "DefinReste_x_n_", _P + "Recurrence_Cnd4"
    x_lab = _P + "Recurrence_Cnd9"
    ratio = s.v1 / s.v0
    x_cap = s.v0 / s.v1 * (s.d2**2 * s.h5) / 12
    half = s.zeta / 2 + s.zeta**2 / 4
    second = ratio / s.d2**2 * s.dx
    rest = ratio / s.d2**2 * (s.al / 2 + 4 * ratio) * s.zeta
    main = ratio * s.fm / s.gap_y**2
    exact_tau = (1 + s.dmax) / s.v0 * s.bracket
    return [
        Row(
            y_lab,
            1486,
            r"\frac{d_{n+1}(2+d_{n+1})}{(1+d_{n+1})^2} \leq 2 d_{n+1}",
            s.dn * (2 + s.dn) / (1 + s.dn) ** 2,
            "<=",
            2 * s.dn,
            "d_{n+1} = 3 V_1^(1/2)/V_0 eta_bar",
        ),
        Row(
            y_lab,
            1490,
            r"bounding $\tau/(-\eta_{c,n})$ by $4\zeta_n^2/|W_{c,n}|^4$",
            exact_tau,
            "<=",
            4 * s.zeta**2 / s.v0**2,
            "literal, |W|^2 = V_0, d_n = max(d_bar, 3 V_1^(1/2)/V_0 eta_bar). DEFECT:"
            " the left side must be squared, tau_n^2/eta^2; see the next row",
        ),
        Row(
            y_lab,
            1492,
            r"\frac{\tau_n^2}{(-\eta_{c,n})^2} \leq 4\zeta_n^2/|W_{c,n}|^4 (used)",
            exact_tau**2,
            "<=",
            4 * s.zeta**2 / s.v0**2,
            "the inequality actually used, same state",
        ),
        Row(
            y_lab,
            1498,
            r"holds as soon as $\zeta_n \leq 2(\sqrt{2} - 1)$",
            s.zeta,
            "<=",
            2 * (s.s2 - 1),
            "zeta_n = zeta_bar; EQUALITY when that entry is the smallest",
        ),
        Row(
            y_lab,
            1496,
            r"[1 - \sqrt{1-\zeta_n}] \leq \frac{1}{2}\zeta_n + \frac{1}{4}\zeta_n^2",
            s.bracket,
            "<=",
            half,
            "zeta_n = zeta_bar",
        ),
        Row(
            y_lab,
            1500,
            r"2 [1-\sqrt{1-\zeta_n}](1+d_n) -> \zeta_n + \zeta_n^2",
            2 * half * (1 + s.dmax),
            "<=",
            s.zeta + s.zeta**2,
            "zeta_n = zeta_bar, d_n = max(d_bar, 3 V_1^(1/2)/V_0 eta_bar). DEFECT: the"
            " factor (1+d_n) of line 1492 is dropped; the slack zeta_n^2/2 absorbs it"
            " only if d_n <= zeta_n/(2+zeta_n), which is not shown",
        ),
        Row(
            x_lab,
            1503,
            r"Cnd9 implies ... that $|x_n| \leq (V_0/V_1)(\delta_2^2 h_5)/12$",
            s.x0,
            "<=",
            x_cap,
            "n = 0: |x_0| at its bound; EQUALITY when its second entry is the smallest",
        ),
        Row(
            x_lab,
            1503,
            r"Cnd9 implies ... that $|x_n| \leq (V_0/V_1)(\delta_2^2 h_5)/12$",
            s.dx,
            "<=",
            x_cap,
            "n >= 1: |x_n| = delta_x. DEFECT: (V_0/V_1) delta_2^2 h_5/12 is not an"
            " entry of delta_x, so Cnd9 does not imply it",
        ),
        Row(
            x_lab,
            1507,
            r"$|\varphi_{1,\alpha_0}^- - \alpha_0 + y_n| \geq \delta_2$",
            s.d2,
            "<=",
            s.gap_y,
            "y_n = delta_y; EQUALITY when delta_y = delta_2",
        ),
        Row(
            x_lab,
            1505,
            r"... x_n| \leq \frac{V_1}{V_0} \frac{1}{\delta_2^2} x_n",
            ratio / s.gap_y**2 * s.dx,
            "<=",
            second,
            "|x_n| = delta_x, y_n = delta_y, |W_{c,n+1}|^2 = V_1, |W_{c,n}|^2 = V_0"
            " (the paper cites Cnd6, Cnd7 where Cnd5 is used)",
        ),
        Row(
            x_lab,
            1505,
            r"\frac{V_1}{V_0}\frac{1}{\delta_2^2} x_n \leq \frac{1}{12}h_5",
            ratio / s.d2**2 * s.x0,
            "<=",
            s.h5 / 12,
            "n = 0: |x_0| at its bound; EQUALITY when its second entry is the smallest",
        ),
        Row(
            x_lab,
            1505,
            r"\frac{V_1}{V_0}\frac{1}{\delta_2^2} x_n \leq \frac{1}{12}h_5",
            second,
            "<=",
            s.h5 / 12,
            "n >= 1: |x_n| = delta_x. DEFECT: as for line 1503",
        ),
        Row(
            x_lab,
            1512,
            r"$|x_n| \leq \delta_1$",
            s.dx,
            "<=",
            s.d1,
            "|x_n| = delta_x; EQUALITY when delta_1 is the smallest",
        ),
        Row(
            x_lab,
            1512,
            r"so that $\eta_{s,n}/(-\eta_{c,n}) \leq \alpha_0/2$",
            s.fm + s.dx,
            "<=",
            s.al / 2,
            "|x_n| = delta_x; EQUALITY when delta_x = delta_1",
        ),
        Row(
            x_lab,
            1510,
            r"| \frac{\eta_{s,n}}{(-\eta_{c,n})} ... | \leq ... \alpha_0/2",
            -s.al / 2,
            "<=",
            s.fm - s.dx,
            "silent: the absolute value on the negative side, x_n = -delta_x",
        ),
        Row(
            x_lab,
            1510,
            r"\leq \frac{V_1}{V_0} \frac{\alpha_0/2}{\delta_2^2}",
            ratio * (s.fm + s.dx) / s.gap_y**2,
            "<=",
            ratio * (s.al / 2) / s.d2**2,
            "third term: |x_n| = delta_x, y_n = delta_y",
        ),
        Row(
            x_lab,
            1514,
            r"\leq \frac{V_1^2}{V_0^2} \frac{4}{\delta_2^2}",
            ratio**2 * 4 / s.gap_y**2,
            "<=",
            ratio**2 * 4 / s.d2**2,
            "fourth term: y_n = delta_y",
        ),
        Row(
            z_lab,
            1518,
            r"\frac{V_1}{2V_0\delta_2^2}(\alpha_0+\frac{8V_1}{V_0})\zeta_n\leq h_5/6",
            ratio / (2 * s.d2**2) * (s.al + 8 * ratio) * s.zeta,
            "<=",
            s.h5 / 6,
            "zeta_n = zeta_bar; EQUALITY when its second entry is the smallest",
        ),
        Row(
            z_lab,
            1522,
            r"(three remainder terms) \leq \frac{h_5}{12} + \frac{h_5}{6}",
            second + rest,
            "<=",
            s.h5 / 12 + s.h5 / 6,
            "|x_n| = delta_x, zeta_n = zeta_bar. DEFECT: inherits line 1503",
        ),
        Row(
            z_lab,
            1522,
            r"\frac{h_5}{12} + \frac{h_5}{6} = \frac{h_5}{4}",
            s.h5 / 12 + s.h5 / 6,
            "<=",
            s.h5 / 4,
            "EQUALITY",
        ),
        Row(
            z_lab,
            1526,
            r"(main term), by the estimate Cnd10 on $|y_n|$",
            s.dy,
            "<=",
            s.d5,
            "silent: |y_n| <= delta_5; EQUALITY when delta_5 is the smallest",
        ),
        Row(
            z_lab,
            1526,
            r"... \leq \frac{V_1}{V_0}(1-h_5)",
            main,
            "<=",
            ratio * (1 - s.h5),
            "y_n = delta_y; EQUALITY when delta_y = delta_5",
        ),
        Row(
            z_lab,
            1526,
            r"\frac{V_1}{V_0}(1-h_5) \leq 1- \frac{h_5}{2}",
            ratio * (1 - s.h5),
            "<=",
            1 - s.h5 / 2,
            "EQUALITY (definition of V_1/V_0)",
        ),
        Row(
            z_lab,
            1530,
            r"( 1 - h_5/2 ) \zeta_n + (h_5/4) \zeta_n = ( 1 - h_5/4 ) \zeta_n",
            1 - s.h5 / 2 + s.h5 / 4,
            "<=",
            1 - s.h5 / 4,
            "EQUALITY",
        ),
        Row(
            z_lab,
            1530,
            r"\zeta_{n+1} \leq ( 1 - \frac{h_5}{4} ) \zeta_n",
            main + second + rest,
            "<=",
            1 - s.h5 / 4,
            "the four terms at their own bounds, divided by zeta_n: |x_n| = delta_x,"
            " y_n = delta_y, zeta_n = zeta_bar. DEFECT: inherits lines 1500 and 1503",
        ),
        Row(
            z_lab,
            1532,
            r"so that we obtained ... Cnd4 for $n+1$",
            (1 - s.h5 / 4) * s.zeta,
            "<=",
            s.zeta,
            "zeta_n = zeta_bar",
        ),
        Row(
            _P + "Recurrence_Cnd3",
            1532,
            r"so that we obtained Cnd3 ... for $n+1$",
            (1 - s.h5 / 4) * s.zeta,
            "<",
            1,
            "zeta_n = zeta_bar",
        ),
    ]


def _step_collision_angle(s: _State) -> list[Row]:
    """Rows of the propagation of CndT and Cnd8 (lines 1532-1560)."""
    t_lab, a_lab = _P + "Recurrence_CndT", _P + "Recurrence_Cnd8"
    x = s.sv * s.tau
    distance = s.s2 - 3 * s.ve - 4 * s.ve
    state = "|eta_{c,n}| = |eta_{c,n+1}| = eta_bar"
    return [
        Row(
            t_lab,
            1539,
            r"- d_{n+1} ... \geq - \frac{3}{2} V_1^{1/2} \tau_n",
            x + s.v1 * s.tau**2 / 2,
            "<=",
            x * 3 / 2,
            "tau_n = 2 eta_bar/V_0, |eta_{s,n}| = |W_{s,n}| = V_1^(1/2)",
        ),
        Row(
            t_lab,
            1540,
            r"\frac{3}{2}V_1^{1/2}\tau_n \leq 3\frac{V_1^{1/2}}{V_0}(-\eta_{c,n})",
            x * 3 / 2,
            "<=",
            3 * s.ve,
            "EQUALITY; tau_n = 2 eta_bar/V_0",
        ),
        Row(
            t_lab,
            1540,
            r"2V_1^{1/2}\tau_{n+1} \leq 4\frac{V_1^{1/2}}{V_0}(-\eta_{c,n+1})",
            2 * x,
            "<=",
            4 * s.ve,
            "EQUALITY; tau_{n+1} = 2 eta_bar/V_0",
        ),
        Row(
            t_lab,
            1542,
            r"Cnd8, together with the upper bound Cnd2, imply $\cos\theta_{n+1} < 0$",
            s.angle,
            "<",
            s.c,
            "angle bound of Cnd8 including its tail for all n. DEFECT: eta_bar lacks"
            " the factor (1-C_eta), so Cnd8 is not below |Delta theta| (next row)",
        ),
        Row(
            t_lab,
            1542,
            r"(maximal variation of the angles, all n, by $|\Delta\theta|$)",
            s.angle,
            "<=",
            s.dang,
            "silent: sum of Cnd8 with its tail C_eta/(1-C_eta). DEFECT: the tail"
            " (3+11 C_eta)/(1-C_eta) V_1^(1/2)/V_0 eta_bar is not bounded by"
            " |Delta theta|/3 since the third entry of eta_bar has no (1-C_eta)",
        ),
        Row(
            t_lab,
            1542,
            r"imply $\cos\theta_{n+1} < 0$",
            s.dang,
            "<",
            s.c,
            "with |Delta theta| <= |cos theta_0|/2",
        ),
        Row(
            t_lab,
            1544,
            r"|\omega_{c,n+1} - \omega_{s,n+1}| \geq \sqrt{2}",
            s.s2,
            "<=",
            s.K.sqrt(2 + 2 * (s.c - s.dang)),
            "-cos(theta_{n+1}) = -cos(theta_0) - |Delta theta|",
        ),
        Row(
            t_lab,
            1546,
            r"is always larger than $\frac{1}{2}( \sqrt{2} - 1 )$",
            (s.s2 - 1) / 2,
            "<",
            distance,
            state + ", literal. DEFECT: CndT needs the distance to exceed 1; the"
            " printed bound 0.207 is below 1 ('1 +' is missing)",
        ),
        Row(
            t_lab,
            1546,
            r"that is, the $(n+2)$-th collision cannot involve the pair 1-2",
            1,
            "<",
            distance,
            state + "; the inequality CndT needs",
        ),
        Row(
            t_lab,
            1546,
            r"(1 + ) \frac{1}{2}( \sqrt{2} - 1 )",
            1 + (s.s2 - 1) / 2,
            "<",
            distance,
            state + "; the printed bound read with the missing '1 +'",
        ),
        Row(
            a_lab,
            1553,
            r"\frac{1+d_{n+1}}{1+d_{n+2}} ... \leq ... 2 V_1^{1/2} \tau_{n+1}",
            1 + s.dn,
            "<=",
            2,
            "d_{n+1} = 3 V_1^(1/2)/V_0 eta_bar, d_{n+2} = 0. DEFECT: in the display of"
            " line 1551 '=' must be '<=' and the last term must carry '+', not '-'",
        ),
        Row(
            a_lab,
            1553,
            r"|\frac{1+d_{n+1}}{1+d_{n+2}} - 1|(-\cos\theta) \leq d_{n+1} + d_{n+2}",
            s.dn,
            "<=",
            2 * s.dn,
            "extreme d_{n+2} = 0, and -cos(theta_{n+1}) <= 1",
        ),
        Row(
            a_lab,
            1555,
            r"bounded by $2(-\eta_{c,n+1})/V_0$, which is small enough",
            x,
            "<=",
            1,
            "V_1^(1/2) tau_{n+1} <= 1 at tau_{n+1} = 2 eta_bar/V_0",
        ),
        Row(
            a_lab,
            1558,
            r"3V_1^{1/2}\tau_{n+1} + V_1\tau_{n+1}^2 \leq 8V_1^{1/2}(-\eta)/V_0",
            3 * x + s.v1 * s.tau**2,
            "<=",
            8 * s.ve,
            "tau_{n+1} = 2 eta_bar/V_0",
        ),
        Row(
            a_lab,
            1558,
            r"d_{n+1} + d_{n+2} \leq 3..(-\eta_{c,n}) + 3..(-\eta_{c,n+1})",
            s.sv * s.tau * 3 / 2 + s.sv * s.ce * s.tau * 3 / 2,
            "<=",
            3 * s.ve + 3 * s.ve * s.ce,
            "EQUALITY; |eta_{c,n}| = eta_bar, |eta_{c,n+1}| = C_eta eta_bar",
        ),
        Row(
            a_lab,
            1560,
            r"we deduce that this last estimate holds also for $n+1$",
            3 * s.ve + 11 * s.ve * s.ce,
            "<=",
            s.sv / (s.v0 * s.ce) * (3 + 11 * s.ce) * s.ce * s.eta,
            "EQUALITY; n = 0 as representative, |eta_{c,k}| = C_eta^k eta_bar",
        ),
    ]


def _step_ratios(s: _State) -> list[Row]:
    """Rows of the propagation of Cnd9 and Cnd10 (lines 1562-1590)."""
    x_lab, i_lab = _P + "Recurrence_Cnd9", _P + "Cntrlx_n+1Ameli"
    y_lab = _P + "Recurrence_Cnd10"
    half, eighth = s.h4 * s.dx / 2, s.h4 * s.dx / 8
    big = s.K.max(s.dmax, 2 * s.zeta)
    two = s.K.max(s.dn, 2 * s.zeta)
    main = s.K.abs(s.r / s.gap_y - s.fm)
    improved = (1 - s.h4 / 2) * s.dx
    four = s.v1 * 2 * s.zeta / s.v0
    bound = r"the bound is itself smaller than $(h_4 \delta_x)/2$"
    small = r"the four first terms are bounded by $(h_4\delta_x)/8$"
    return [
        Row(
            x_lab,
            1568,
            r"Since $|y_n| \leq \delta_2$",
            s.dy,
            "<=",
            s.d2,
            "|y_n| = delta_y; EQUALITY when delta_2 is the smallest",
        ),
        Row(
            x_lab,
            1570,
            r"|\frac{r[...]}{...}| \leq \frac{\text{Max}(d_n,2\zeta_n)}{\delta_2}",
            s.r * s.K.max(s.dmax, s.bracket) / s.gap_y,
            "<=",
            big / s.d2,
            "d_n = max(d_bar, 3 V_1^(1/2)/V_0 eta_bar), zeta_n = zeta_bar, y_n ="
            " delta_y; uses r <= 1",
        ),
        Row(
            x_lab,
            1572,
            bound + " (d_0)",
            s.d0 / s.d2,
            "<=",
            half,
            "n = 0: d_0 = d_bar. DEFECT: not guaranteed by entries three and four of"
            " d_bar (sums); the paper names only eta and zeta_0",
        ),
        Row(
            x_lab,
            1572,
            bound + " (d_n)",
            s.dn / s.d2,
            "<=",
            half,
            "n >= 1: d_n = 3 V_1^(1/2)/V_0 eta_bar. DEFECT: not guaranteed by the"
            " fifth entry of eta_bar (sum)",
        ),
        Row(
            x_lab,
            1572,
            bound + r" (2\zeta_n)",
            2 * s.zeta / s.d2,
            "<=",
            half,
            "zeta_n = zeta_bar. DEFECT: not guaranteed by the third entry of zeta_bar (sum)",
        ),
        Row(
            x_lab,
            1573,
            r"since we have also $|y_n| \leq \delta_4$",
            s.dy,
            "<=",
            s.d4,
            "|y_n| = delta_y; EQUALITY when delta_4 is the smallest",
        ),
        Row(
            x_lab,
            1575,
            r"... \leq (1-h_4) |y_n| (derivative of F_1 on the interval)",
            s.r / s.gap_y**2,
            "<=",
            1 - s.h4,
            "silent: mean value inequality, y_n = delta_y; EQUALITY when delta_y = delta_4",
        ),
        Row(
            x_lab,
            1575,
            r"|\frac{r}{\alpha_0-\varphi^- -y_n} - \varphi^-| \leq (1-h_4)|y_n|",
            main,
            "<=",
            (1 - s.h4) * s.dy,
            "y_n = delta_y (the worse sign)",
        ),
        Row(
            x_lab,
            1575,
            r"(1-h_4) |y_n| \leq (1-h_4) \delta_x",
            (1 - s.h4) * s.dy,
            "<=",
            (1 - s.h4) * s.dx,
            "EQUALITY; |y_n| = delta_y = delta_x",
        ),
        Row(
            i_lab,
            1580,
            r"\frac{1}{2}h_4\delta_x + (1-h_4)\delta_x = ( 1-\frac{h_4}{2} )\delta_x",
            half + (1 - s.h4) * s.dx,
            "<=",
            improved,
            "EQUALITY",
        ),
        Row(
            i_lab,
            1580,
            r"|x_{n+1}| \leq ... ( 1 - \frac{h_4}{2} ) \delta_x",
            big / s.d2 + main,
            "<=",
            improved,
            "the two terms at their own bounds, all n >= 0. DEFECT: inherits line 1572",
        ),
        Row(
            x_lab,
            1582,
            r"that is, the inequality Cnd9 propagates to the rank $n+1$",
            improved,
            "<=",
            s.dx,
            "",
        ),
        Row(
            y_lab,
            1584,
            r"|y_{n+1}| \leq d_{n+2} ... + \text{Max}(d_{n+1},2\zeta_{n+1}) + ...",
            (1 + s.r) / 2,
            "<=",
            1,
            "silent: the factor (1+r)/2 is dropped in the second and third terms",
        ),
        Row(
            y_lab,
            1586,
            r"we have $\eta_{s,n+1}/(-\eta_{c,n+1}) \leq \alpha_0/2$",
            s.fm + s.dx,
            "<=",
            s.al / 2,
            "|x_{n+1}| = delta_x; EQUALITY when delta_x = delta_1",
        ),
        Row(
            y_lab,
            1586,
            small + " (first)",
            s.dn * s.al / 2,
            "<=",
            eighth,
            "d_{n+2} = 3 V_1^(1/2)/V_0 eta_bar. DEFECT: not guaranteed by the fifth"
            " entry of eta_bar (sum)",
        ),
        Row(
            y_lab,
            1586,
            small + " (second, d_{n+1})",
            s.dn,
            "<=",
            eighth,
            "d_{n+1} = 3 V_1^(1/2)/V_0 eta_bar. DEFECT: idem",
        ),
        Row(
            y_lab,
            1586,
            small + r" (second, 2\zeta_{n+1})",
            2 * s.zeta,
            "<=",
            eighth,
            "zeta_{n+1} = zeta_bar. DEFECT: not guaranteed by the third entry of zeta_bar (sum)",
        ),
        Row(
            y_lab,
            1586,
            small + " (third, angles)",
            s.angle,
            "<=",
            eighth,
            "Cnd8 at rank n+1 with its tail for all n. DEFECT: missing (1-C_eta) in"
            " the third entry of eta_bar",
        ),
        Row(
            y_lab,
            1586,
            small + r" (third, via $|\Delta\theta|$)",
            s.dang,
            "<=",
            eighth,
            "by construction; EQUALITY when that entry of Delta_theta is the smallest",
        ),
        Row(
            y_lab,
            1586,
            small + " (fourth)",
            four,
            "<=",
            eighth,
            "V_1 tau_{n+1}/(-eta) with tau <= 2 eta zeta_bar/V_0. DEFECT: not"
            " guaranteed by the third entry of zeta_bar (sum)",
        ),
        Row(
            y_lab,
            1588,
            r"4 \frac{h_4}{8}\delta_x + ( 1 - \frac{h_4}{2} )\delta_x = \delta_x",
            4 * eighth + improved,
            "<=",
            s.dx,
            "EQUALITY",
        ),
        Row(
            y_lab,
            1588,
            r"|y_{n+1}| \leq ... = \delta_x",
            s.dn * s.al / 2 + two + s.angle + four + improved,
            "<=",
            s.dy,
            "the five terms at their own bounds, |x_{n+1}| = (1-h_4/2) delta_x."
            " DEFECT: inherits the four rows of line 1586",
        ),
    ]


def _conclusion(s: _State) -> list[Row]:
    """Rows of the conclusion of the theorem (lines 1592 and 1121-1124)."""
    lab = "THEORSS4.1ExistenCollapse"
    inside = r"a set $\mathcal{ZK}$ ... with a non trivial interior"
    return [
        Row(
            lab,
            1123,
            r"|(-\cos\overline{\theta}) - (-\cos\theta_0)| \leq \delta_\theta",
            s.angle,
            "<=",
            s.dtheta,
            "Cnd8 with its tail. DEFECT: the proof ends without deriving the statement"
            " on the final angle, and the tail is not below |Delta theta|",
        ),
        Row(
            lab,
            1123,
            r"|(-\cos\overline{\theta}) - (-\cos\theta_0)| \leq \delta_\theta",
            s.dang,
            "<=",
            s.dtheta,
            "by construction; EQUALITY when that entry of Delta_theta is the smallest",
        ),
        Row(
            lab,
            1592,
            r"experiences a nearly-linear collapse in finite time",
            0,
            "<",
            (1 - s.ce) * s.v0 / (2 * s.eta),
            "silent: sum of tau_n <= 2 eta_bar/(V_0 (1-C_eta)) is finite and positive."
            " DEFECT: the proof never shows that the sum of the tau_n is finite",
        ),
        Row(
            lab,
            1121,
            inside + " (eta)",
            0,
            "<",
            s.eta,
            "DEFECT: the last line of EQUATSS4.1DescrDoIniColla fixes the angle by an"
            " equality, so the printed set has empty interior",
        ),
        Row(
            lab,
            1121,
            inside + " (ratio)",
            0,
            "<",
            s.x0,
            "the interval of eta_{s,0}/(-eta_{c,0}) has an interior",
        ),
        Row(lab, 1121, inside + " (d_0)", 0, "<", s.d0, "0 < d_0 <= d_bar"),
        Row(
            lab,
            1121,
            inside + " (post-collisional)",
            0,
            "<",
            s.fm + s.x0,
            "eta_{s,0} > 0 is compatible with the interval of the ratio",
        ),
        Row(
            lab,
            1121,
            inside + " (norms)",
            s.low,
            "<",
            s.high,
            "",
        ),
    ]


def _lead(row: Row) -> Row:
    """Move a ``DEFECT:`` remark to the front of the comment, the state after it."""
    state, mark, defect = row.comment.partition("DEFECT:")
    if not mark or not state:
        return row
    state = state.rstrip(" .")
    return replace(row, comment=f"DEFECT:{defect} [State: {state}]")


def rows(K: Context, k: dict[str, Any]) -> list[Row]:
    """Return every inequality between constants of the printed proof, in order."""
    s = _State(K, k)
    found = [
        *_preliminaries(s),
        *_initial_set(s),
        *_init_zeta_norms(s),
        *_init_collision_angle(s),
        *_init_ratios(s),
        *_step_norms(s),
        *_step_eta(s),
        *_step_zeta(s),
        *_step_collision_angle(s),
        *_step_ratios(s),
        *_conclusion(s),
    ]
    return [_lead(row) for row in found]
