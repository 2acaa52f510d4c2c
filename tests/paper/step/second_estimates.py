"""The paper read a second time: every displayed estimate of the recursion that proves Theorem 1.

Each is read at a state n that the recursion's hypothesis allows (`second_constants.hypothesis`); a
line about n = 0 that comes back for every n is entered once, at n. `right`: true at every such
state. `slip`: false as printed, and the obvious reading is true. `wrong`: false at some such state.
"""

from __future__ import annotations

from flint import fmpq

from .second_constants import turns
from .second_reading import Chain, Number, Place, along, dot, length, reading, root, size

RELATED = "before EQUATSS4.1DefinReste_y_n_"


# Times and gaps.


@reading("zeta by d", "EQUATSS4.1BorneParam_ZK0_")
def _(q: Place) -> Chain:
    return q.n.zeta, "<=", 2 * q.n.d * q.n.Wc2 / q.n.eta_c**2


@reading("crude bound on tau", "after EQUATSS4.1BorneParam_ZK0_")
def _(q: Place) -> Chain:
    eta, first = -q.n.eta_c, 2 * -q.n.eta_c / q.n.Wc2 * (1 - q.n.still)
    return q.n.tau, "<=", first, "<=", 2 * eta / q.K.V_0 * q.n.zeta


@reading("bound on tau", "EQUATSS4.1_Controle_Tau_n")
def _(q: Place) -> Chain:
    eta = -q.n.eta_c
    return q.n.tau, "<=", 2 * eta / q.n.Wc2 * q.n.zeta, "<=", 2 * eta / q.K.V_0


@reading("finer bound on tau", "before EQUATSS4.1Recurrence_Cnd10 at n = 0")
def _(q: Place) -> Chain:
    eta = -q.n.eta_c
    return q.n.tau, "<=", 2 * eta / q.n.Wc2 * q.n.zeta, "<=", 4 * q.n.d / eta


@reading("V_1 tau^2 is small", "EQUATSS4.1_Controle_Tau_n")
def _(q: Place) -> Chain:
    t = q.n.tau
    return q.K.V_1 * t**2, "<=", q.K.speed * t, "<=", fmpq(1)


@reading("bound on d_1", "EQUATSS4.1BorneDista_d_1_")
def _(q: Place) -> Chain:
    t, w = q.n.tau, q.K.speed
    first = q.n.eta_s * t + q.n.Ws2 * t * t / 2
    return q.m.d, "<=", first, "<=", fmpq(3, 2) * w * t, "<=", 3 * w / q.K.V_0 * -q.n.eta_c


def _gap(q: Place, d: Number) -> Chain:
    t, K, n = q.n.tau, q.K, q.n
    first = size(n.eta_s) * t + n.Ws2 * t * t / 2
    second = K.speed * t + K.V_1 * t * t / 2
    last = 3 * K.speed / K.V_0 * -n.eta_c
    return d, "<=", first, "<=", second, "<=", fmpq(3, 2) * K.speed * t, "<=", last


@reading(
    "bound on d_n",
    "before EQUATSS4.1_Controle_Tau_n",
    view="wrong",
    why="the right sides bound d_{n+1}; for d_n take the collision before",
    instead=lambda q: _gap(q, q.m.d),
)
def _(q: Place) -> Chain:
    return _gap(q, q.n.d)


@reading("the particles 1 and 2 start apart", "EQUATSS4.1Recurrence_CndT")
def _(q: Place) -> Chain:
    return fmpq(2), "<=", dot(*(2 * (along(q.n.omega_c, -1, q.n.omega_s),)))


def _passing(q: Place, t: Number) -> Chain:
    n, m, K = q.n, q.m, q.K
    apart = along([(1 + m.d) * x for x in m.omega_c], -1, m.omega_s)
    now = length(along(apart, t, along(m.W_c, -1, m.W_s)))
    start, w = length(along(m.omega_c, -1, m.omega_s)), K.speed
    second = start - fmpq(3, 2) * w * n.tau - 2 * w * m.tau
    third = start - 3 * w / K.V_0 * -n.eta_c - 4 * w / K.V_0 * -m.eta_c
    return third, "<=", second, "<=", start - m.d - 2 * w * t, "<=", now


@reading("no contact of 1 and 2", "EQUATSS4.1Recurrence_CndT at n+1")
def _(q: Place) -> Chain:
    return _passing(q, q.m.tau)


@reading("at first 1 and 2 stay apart", "EQUATSS4.1Recurrence_CndT at n = 0")
def _(q: Place) -> Chain:
    n, t = q.n, q.n.tau
    apart = along([(1 + n.d) * x for x in n.omega_c], -1, n.omega_s)
    now = length(along(apart, t, along(n.W_c, -1, n.W_s)))
    low = root(fmpq(2)) - n.d - 2 * q.K.speed * t
    return fmpq(1), "<", low, "<=", now


# Norms.


@reading("step of |W_c|^2", RELATED)
def _(q: Place) -> Chain:
    eta, d, K, hit = -q.n.eta_c, q.n.d, q.K, size(q.hit)
    first = 2 * length(q.n.W_s) * hit + 2 * hit**2
    second = 2 * K.speed * (1 + d) * eta + 2 * (1 + d) ** 2 * eta**2
    return q.m.Wc2 - q.n.Ws2, "<=", first, "<=", second, "<=", 4 * (K.speed + 2) * eta


@reading("step of |W_s|^2", RELATED)
def _(q: Place) -> Chain:
    eta = -q.n.eta_c
    return q.m.Ws2 - q.n.Wc2, "<=", (1 + q.n.d) ** 2 * eta**2, "<=", 4 * eta


@reading("room for the norms", "EQUATSS4.1Recurrence_Cnd5 at n+1")
def _(q: Place) -> Chain:
    K = q.K
    return 4 * (K.speed + 2) / (1 - K.C_eta) * K.eta_bar, "<=", (K.V_1 - K.V_0) / 3


# The remainders x_n and y_n.


@reading("y_n and x_n", "EQUATSS4.1Lien_x_n_&_y_n_")
def _(q: Place) -> Chain:
    K, n, m, half = q.K, q.n, q.m, (1 + q.r) / 2
    y, x = m.eta_c / -n.eta_c - K.phi + K.alpha, q.X - K.phi
    swell = half * ((1 + n.d) * n.still - 1) * m.neg_cos
    pull = n.Ws2 / (1 + m.d) * n.tau / -n.eta_c
    return y, "=", (1 / (1 + m.d) - 1) * q.X - swell - half * (m.neg_cos - K.c) + pull + x


@reading("ratio at the start", "before EQUATSS4.1Recurrence_Cnd10 at n = 0")
def _(q: Place) -> Chain:
    K, n, m, half = q.K, q.n, q.m, (1 + q.r) / 2
    first = (1 / (1 + m.d) - 1) * n.eta_s / n.eta_c + (K.phi - q.X)
    second = ((1 + n.d) * n.still - 1) * half * m.neg_cos + (half * m.neg_cos - K.alpha)
    return q.rho - K.alpha + K.phi, "=", first + second + n.tau / n.eta_c * n.Ws2 / (1 + m.d)


@reading("third term at the start", "before EQUATSS4.1Recurrence_Cnd10 at n = 0")
def _(q: Place) -> Chain:
    swell = ((1 + q.n.d) * q.n.still - 1) * (1 + q.r) / 2 * q.m.neg_cos
    return size(swell), "<=", max(q.n.d, 2 * q.n.zeta)


@reading("eta_{c,n+1} is negative and smaller", "EQUATSS4.1DefinReste_y_n_")
def _(q: Place) -> Chain:
    K, ratio = q.K, q.m.eta_c / -q.n.eta_c
    return fmpq(-1), "<", -1 + K.delta_3, "<=", ratio, "<=", -K.delta_2, "<", fmpq(0)


@reading("|eta_{c,n+1}| <= C_eta |eta_{c,n}|", "EQUATSS4.1Recurrence_Cnd2 at n+1")
def _(q: Place) -> Chain:
    return size(q.m.eta_c), "<=", q.K.C_eta * size(q.n.eta_c)


@reading("x_{n+1}", "before EQUATSS4.1Cntrlx_n+1Ameli")
def _(q: Place) -> Chain:
    K, n, m = q.K, q.n, q.m
    y = m.eta_c / -n.eta_c - K.phi + K.alpha
    first = size(q.r * ((1 + n.d) * n.still - 1) / q.rho)
    x = m.eta_s / -m.eta_c - K.phi
    law = q.r * (1 + n.d) * n.still / q.rho - K.phi
    second = size(q.r / (K.alpha - K.phi - y) - K.phi)
    return size(x), "=", size(law), "<=", first + second


@reading("first term of x_{n+1}", "before EQUATSS4.1Cntrlx_n+1Ameli")
def _(q: Place) -> Chain:
    n = q.n
    first = size(q.r * ((1 + n.d) * n.still - 1) / q.rho)
    return first, "<=", max(n.d, 2 * n.zeta) / q.K.delta_2


@reading(
    "first term of x_{n+1} is half of h_4 delta_x",
    "before EQUATSS4.1Cntrlx_n+1Ameli",
    why="zeta_bar adds what should be entries of its min, but its second entry is always less",
)
def _(q: Place) -> Chain:
    return max(q.n.d, 2 * q.n.zeta) / q.K.delta_2, "<=", q.K.h_4 * q.K.delta_x / 2


@reading("main term of x_{n+1}", "before EQUATSS4.1Cntrlx_n+1Ameli")
def _(q: Place) -> Chain:
    K = q.K
    y = q.m.eta_c / -q.n.eta_c - K.phi + K.alpha
    main, h = size(q.r / (K.alpha - K.phi - y) - K.phi), 1 - K.h_4
    return main, "<=", h * size(y), "<=", h * K.delta_x


@reading("improved bound on x_{n+1}", "EQUATSS4.1Cntrlx_n+1Ameli")
def _(q: Place) -> Chain:
    return size(q.m.eta_s / -q.m.eta_c - q.K.phi), "<=", (1 - q.K.h_4 / 2) * q.K.delta_x


@reading("y_{n+1}", "EQUATSS4.1Recurrence_Cnd10 at n+1")
def _(q: Place) -> Chain:
    K, m, k = q.K, q.m, q.k
    y = k.eta_c / -m.eta_c - K.phi + K.alpha
    X = m.eta_s / -m.eta_c
    turn = size(k.neg_cos - K.c)
    near = k.d * X + max(m.d, 2 * m.zeta) + turn
    return size(y), "<=", near + K.V_1 * m.tau / -m.eta_c + size(X - K.phi)


@reading("eta_s / (-eta_c) <= alpha_0 / 2", "EQUATSS4.1Recurrence_Cnd9")
def _(q: Place) -> Chain:
    return q.X, "<=", q.K.alpha / 2


@reading(
    "second term of y_{n+1} is an eighth",
    "EQUATSS4.1Recurrence_Cnd10 at n+1",
    why="zeta_bar adds what should be entries of its min, but its second entry is always less",
)
def _(q: Place) -> Chain:
    return max(q.m.d, 2 * q.m.zeta), "<=", q.K.h_4 * q.K.delta_x / 8


@reading(
    "fourth term of y_{n+1} is an eighth",
    "EQUATSS4.1Recurrence_Cnd10 at n+1",
    why="zeta_bar adds what should be entries of its min, but its second entry is always less",
)
def _(q: Place) -> Chain:
    return q.K.V_1 * q.m.tau / -q.m.eta_c, "<=", q.K.h_4 * q.K.delta_x / 8


# The parameter zeta.


@reading("zeta_{n+1}, a priori", "after EQUATSS4.1DefinReste_x_n_")
def _(q: Place) -> Chain:
    n, m, e = q.n, q.m, q.m.eta_c**2
    far = m.Wc2 * n.Ws2 * n.tau**2 / e
    third = 2 * m.Wc2 * size(n.eta_s) * n.tau / e + far
    fourth = 2 * m.Wc2 / n.Wc2 * n.eta_s * -n.eta_c * (1 - n.still) / e * (1 + n.d) + far
    return m.zeta, "<=", 2 * m.Wc2 * m.d / e, "<=", third, "<=", fourth


def _square(q: Place) -> Chain:
    return (q.n.tau / q.n.eta_c) ** 2, "<=", 4 * q.n.zeta**2 / q.n.Wc2**2


@reading(
    "tau / (-eta_c) by zeta^2",
    "after EQUATSS4.1DefinReste_x_n_",
    view="wrong",
    why="the square of the left side is meant",
    instead=_square,
)
def _(q: Place) -> Chain:
    return q.n.tau / -q.n.eta_c, "<=", 4 * q.n.zeta**2 / q.n.Wc2**2


@reading("zeta_{n+1} by zeta_n", "after EQUATSS4.1DefinReste_x_n_")
def _(q: Place) -> Chain:
    n, m = q.n, q.m
    first = 2 * m.Wc2 / n.Wc2 * q.X / q.rho**2 * (1 - n.still) * (1 + n.d)
    return m.zeta, "<=", first + m.Wc2 * n.Ws2 / n.Wc2**2 * 4 / q.rho**2 * n.zeta**2


@reading("1 - sqrt(1 - zeta)", "after EQUATSS4.1DefinReste_x_n_")
def _(q: Place) -> Chain:
    return 1 - q.n.still, "<=", q.n.zeta / 2 + q.n.zeta**2 / 4


def _four(q: Place, swell: Number) -> Chain:
    n, m, K = q.n, q.m, q.K
    W, s = m.Wc2 / n.Wc2, q.rho**2
    two = W * K.phi / s * n.zeta + W / s * (q.X - K.phi) * n.zeta
    three = W * q.X / s * swell
    return m.zeta, "<=", two + three + m.Wc2 * n.Ws2 / n.Wc2**2 * 4 / s * n.zeta**2


@reading(
    "zeta_{n+1} in four terms",
    "after EQUATSS4.1DefinReste_x_n_",
    why="1 + d_n is dropped without a word; zeta^2 for zeta^2/2 pays for it since |eta_c| << |W_c|",
)
def _(q: Place) -> Chain:
    return _four(q, q.n.zeta**2)


@reading(
    "x_n is small",
    "EQUATSS4.1Recurrence_Cnd9",
    view="wrong",
    why="Cnd9 says |x_n| <= delta_x only; |x_0| is bounded like this, x_n for n >= 1 is not",
)
def _(q: Place) -> Chain:
    K = q.K
    return size(q.X - K.phi), "<=", K.V_0 / K.V_1 * K.delta_2**2 * K.h_5 / 12


def _second(q: Place, x: Number) -> Chain:
    K = q.K
    left = size(q.m.Wc2 / q.n.Wc2 / q.rho**2 * (q.X - K.phi))
    return left, "<=", K.V_1 / K.V_0 / K.delta_2**2 * x, "<=", K.h_5 / 12


@reading(
    "second term of zeta_{n+1}",
    "after EQUATSS4.1DefinReste_x_n_",
    view="wrong",
    why="|x_n| on the right (slip); and |x_n| need not be that small",
)
def _(q: Place) -> Chain:
    return _second(q, q.X - q.K.phi)


@reading("third term of zeta_{n+1}", "after EQUATSS4.1DefinReste_x_n_")
def _(q: Place) -> Chain:
    K = q.K
    left = size(q.m.Wc2 / q.n.Wc2 * q.X / q.rho**2)
    return left, "<=", K.V_1 / K.V_0 * K.alpha / 2 / K.delta_2**2


@reading("fourth term of zeta_{n+1}", "after EQUATSS4.1DefinReste_x_n_")
def _(q: Place) -> Chain:
    K = q.K
    left = q.m.Wc2 * q.n.Ws2 / q.n.Wc2**2 * 4 / q.rho**2
    return left, "<=", (K.V_1 / K.V_0) ** 2 * 4 / K.delta_2**2


@reading("zeta_n is small enough", "after EQUATSS4.1DefinReste_x_n_")
def _(q: Place) -> Chain:
    K = q.K
    return (
        K.V_1 / (2 * K.V_0 * K.delta_2**2) * (K.alpha + 8 * K.V_1 / K.V_0) * q.n.zeta,
        "<=",
        K.h_5 / 6,
    )


@reading(
    "three remainder terms",
    "after EQUATSS4.1DefinReste_x_n_",
    view="wrong",
    why="through x_n, which need not be that small",
)
def _(q: Place) -> Chain:
    n, W = q.n, q.m.Wc2 / q.n.Wc2
    rest = (q.X + 4 * n.Ws2 / n.Wc2) * n.zeta
    return size(W / q.rho**2 * (q.X - q.K.phi) + W / q.rho**2 * rest), "<=", q.K.h_5 / 4


@reading("main term of zeta_{n+1}", "after EQUATSS4.1DefinReste_x_n_")
def _(q: Place) -> Chain:
    K = q.K
    left = q.m.Wc2 / q.n.Wc2 * K.phi / q.rho**2
    return left, "<=", K.V_1 / K.V_0 * (1 - K.h_5), "<=", 1 - K.h_5 / 2


@reading(
    "zeta_{n+1} <= (1 - h_5/4) zeta_n",
    "EQUATSS4.1Recurrence_Cnd4 at n+1",
    view="wrong",
    why="true at n = 0; later only if x_n is small enough",
)
def _(q: Place) -> Chain:
    return q.m.zeta, "<=", (1 - q.K.h_5 / 4) * q.n.zeta


# The angle.


def _turn(q: Place, sign: int) -> tuple[Number, Number]:
    n, m, t = q.n, q.m, q.n.tau
    near, far = (1 + n.d) / (1 + m.d), 1 + m.d
    side = size(dot(n.omega_s, n.W_c)) * t / far + near * size(dot(n.omega_c, n.W_s)) * t
    last = size(dot(n.W_s, n.W_c)) * t * t / far
    return size(m.neg_cos - n.neg_cos), size(near - 1) * n.neg_cos + side + sign * last


def _angle(q: Place, relation: str, sign: int) -> Chain:
    left, right = _turn(q, sign)
    K, t = q.K, q.n.tau
    return left, relation, right, "<=", q.n.d + q.m.d + 3 * K.speed * t + K.V_1 * t * t


@reading(
    "step of the angle",
    "after EQUATSS4.1Recurrence_Cnd8",
    view="wrong",
    why="<= for the first =, and + for the last -",
    instead=lambda q: _angle(q, "<=", 1),
)
def _(q: Place) -> Chain:
    return _angle(q, "=", -1)


@reading("first angle", "EQUATSS4.1BorneDista_d_1_")
def _(q: Place) -> Chain:
    n, m, K, t = q.n, q.m, q.K, q.n.tau
    left, c, s = size(m.neg_cos - n.neg_cos), length(n.W_c), length(n.W_s)
    first = size((1 + n.d) / (1 + m.d) - 1) * n.neg_cos + t * c + 2 * t * s + t * t * s * c
    last = n.d + 11 * K.speed / K.V_0 * -n.eta_c
    return left, "<=", first, "<=", n.d + m.d + 4 * K.speed * t, "<=", last


@reading("next angle", "EQUATSS4.1Recurrence_Cnd8 at n+1")
def _(q: Place) -> Chain:
    m, k, w = q.m, q.k, q.K.speed / q.K.V_0
    last = 3 * w * -q.n.eta_c + 3 * w * -m.eta_c + 8 * w * -m.eta_c
    return size(k.neg_cos - m.neg_cos), "<=", last


def _quarters(q: Place, term: Number) -> Chain:
    return size(term), "<=", q.K.h_4 * q.K.delta_x / 4


@reading("first term at the start is a quarter", "before EQUATSS4.1Recurrence_Cnd10 at n = 0")
def _(q: Place) -> Chain:
    return _quarters(q, (1 / (1 + q.m.d) - 1) * q.X)


@reading("third term at the start is a quarter", "before EQUATSS4.1Recurrence_Cnd10 at n = 0")
def _(q: Place) -> Chain:
    return _quarters(q, max(q.n.d, 2 * q.n.zeta))


@reading("fifth term at the start is a quarter", "before EQUATSS4.1Recurrence_Cnd10 at n = 0")
def _(q: Place) -> Chain:
    return _quarters(q, q.n.tau / q.n.eta_c * q.n.Ws2 / (1 + q.m.d))


@reading("first term of y_{n+1} is an eighth", "EQUATSS4.1Recurrence_Cnd10 at n+1")
def _(q: Place) -> Chain:
    return q.k.d * q.m.eta_s / -q.m.eta_c, "<=", q.K.h_4 * q.K.delta_x / 8


def _all_turns(q: Place, eta_bar: Number) -> Chain:
    return turns(q.K, eta_bar), "<=", q.K.Delta_theta


def _slower(q: Place) -> Number:
    K, C = q.K, q.K.C_eta
    return K.V_0 / K.speed * K.Delta_theta * (1 - C) / (3 * (3 + 11 * C))


@reading(
    "all turns together are at most |Delta theta|",
    "EQUATSS4.1DefinBorne_Eta_",
    view="wrong",
    why="1/33 pays for 11 but not for (3 + 11 C)/(1 - C): that asks for C <= 4/11, and C > 1/2",
    instead=lambda q: _all_turns(q, _slower(q)),
)
def _(q: Place) -> Chain:
    return _all_turns(q, q.K.eta_bar)


# What the paper says in words. (where, what, view, why)

SAID = (
    ("EQUATSS2.2LoiEvDistaInit1", "1 + d = |x_2 - x_1|", "slip", "|x_2 - x_0|"),
    ("EQUATSS2.2IterationSystm1", "1 + d = |x_2 - x_0| > 0", "slip", "> 1"),
    (
        "EQUATSS4.1ThExiCondi_r_1_",
        "ensures two fixed points",
        "wrong",
        "-cos theta_0 must be large",
    ),
    ("EQUATSS4.1ThExiCondiTheta", "ensures phi/(alpha-phi)^2 < 1", "wrong", "the sign is reversed"),
    (
        "THEORSS4.1ExistenCollapse",
        "a non trivial interior",
        "wrong",
        "theta at 0 is exactly theta_0",
    ),
    (
        "THEORSS4.1ExistenCollapse",
        "the last angle is within delta_theta",
        "wrong",
        "1/33 in eta_bar",
    ),
    ("EQUATSS4.1DerivFonctF_1P-", "only the smaller fixed point is stable", "right", ""),
    ("EQUATSS4.1DerivFonctF_1P-", "by definition phi < alpha/2", "right", ""),
    ("EQUATSS4.1DerivFonctF_1P-", "-1 < phi - alpha < 0", "right", ""),
    (
        "EQUATSS4.1SysteDynamColSp",
        "necessary and sufficient for the collapse",
        "slip",
        "and sum tau_n",
    ),
    ("EQUATSS4.1EvoluCompoNormC", "for all n >= 1", "slip", "n >= 0: it is used at 0"),
    ("EQUATSS4.1DescrDoIniColla", "d_0 <= d_bar", "slip", "0 < d_0 too"),
    (
        "EQUATSS4.1DefinBorne_Eta_",
        "the last entry is a sum",
        "slip",
        "four entries; never the least",
    ),
    (
        "EQUATSS4.1DefinBorne_Zeta",
        "the last entry is a sum",
        "slip",
        "three entries; never the least",
    ),
    ("EQUATSS4.1DefinBorne_d_0_", "two entries are sums", "slip", "entries; never the least"),
    ("EQUATSS4.1Recurrence_Cnd9", "the unstable fixed point", "slip", "stable"),
    ("EQUATSS4.1BorneParam_ZK0_", "x(2+x)/(1+x)^2 <= 2", "slip", "2x is used"),
    ("EQUATSS4.1BorneParam_ZK0_", "we deduce Cnd3, Cnd4 at 0", "right", ""),
    ("EQUATSS4.1Recurrence_Cnd5", "holds by construction at 0", "right", ""),
    ("EQUATSS4.1Recurrence_Cnd6", "trivial since n = 0", "slip", "0 is even: Cnd7"),
    ("EQUATSS4.1Recurrence_Cnd8", "conditions Cnd1-Cnd8 propagate", "slip", "Cnd1-Cnd10"),
    (
        "EQUATSS4.1Recurrence_Cnd5",
        "we deduce Cnd5 at n+1",
        "wrong",
        "Cnd6, Cnd7 give no lower bound",
    ),
    ("EQUATSS4.1Recurrence_Cnd10", "implies |y_n| <= delta_2, delta_3", "right", ""),
    (
        "EQUATSS4.1Recurrence_Cnd9",
        "implies the bound of |x_0| for x_n",
        "wrong",
        "an entry of delta_x",
    ),
    ("EQUATSS4.1Recurrence_Cnd6", "bounds |W_c|^2 in zeta's terms", "slip", "Cnd5 does"),
    ("EQUATSS4.1Recurrence_CndT", "is always larger than (sqrt 2 - 1)/2", "slip", "1 plus that"),
    (
        "EQUATSS4.1Recurrence_Cnd8",
        "implies cos theta_{n+1} < 0",
        "right",
        "with room, despite 1/33",
    ),
    ("EQUATSS4.1Recurrence_Cnd8", "we deduce Cnd8 at n+1", "right", ""),
    (
        "EQUATSS4.1Recurrence_Cnd10",
        "we deduce the collapse",
        "right",
        "sum tau_n: geometric, not said",
    ),
)
