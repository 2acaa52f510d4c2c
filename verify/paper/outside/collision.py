"""The flight to the next collision, and the collision, for the half outside the set.

First sizes of a state, the time, and how far the other particle is then; then the angle, the
speeds, and the map of two numbers at the next state.
"""

from __future__ import annotations

from collections.abc import Iterator
from fractions import Fraction

from verify.language.argument import (
    ByRoot,
    Defined,
    Item,
    Line,
    Value,
    identity,
    plus,
    power,
    proof,
    scaled,
    square,
    times,
)
from verify.language.terms import as_term, equal, sqrt
from verify.paper.dynamics import laws
from verify.paper.dynamics.carried import start
from verify.paper.dynamics.laws import (
    ANGLE,
    C_NEXT_ONE,
    COMPONENTS,
    DISTANCE,
    IMPACT_POSITIVE,
    NORMS,
    TIME,
    TURN,
    absolute,
    impact,
    parts,
    spin,
    spinning,
    turn,
)
from verify.paper.dynamics.state import (
    A,
    A_next,
    B,
    B_next,
    D,
    S,
    a,
    d,
    eta_s,
    r,
    tau,
    y,
    y_next,
    zeta,
)
from verify.paper.outside.state import (
    G_POSITIVE,
    HALF,
    C_p,
    G,
    Q,
    Q_next,
    U,
    U_next,
    carried,
    g,
    gain,
    half,
    here,
    load,
    pace,
    ratio,
    rho,
    root_here,
    step,
    time_here,
    turning,
    v,
    v_c,
    v_s,
    w_0,
    w_1,
    w_c,
    w_s,
)
from verify.paper.sandwich.collision import GROWTH, IMPACT_BOUND, KEPT_POSITIVE, slower, struck
from verify.paper.sandwich.comparison import LABEL
from verify.paper.sandwich.flight import GROWN, slow

ONE = as_term(1)


def sizes() -> Iterator[Item]:
    """What the conditions say of a state."""
    yield from slow()
    for i, size, most, least in (("c", A, w_c, v_c), ("s", B, w_s, v_s)):
        name = {"c": "A", "s": "B"}[i]
        yield Line(f"v_{i}-positive", 0 < least, proof(f"v_{i}-least", "v-positive"))
        yield Line(f"w_{i}-positive", 0 < most, proof(f"high-{i}", GROWN))
        yield Line(f"{name}-below", size <= most**2,
                   proof(f"{name}-upper", times(GROWN, plus(f"high-{i}", f"w_{i}-positive"))),
                   says=f"|W_{i}| ≤ w_{i}")  # fmt: skip
        yield Line(f"{name}-above", least**2 <= size,
                   proof(f"{name}-lower", times(GROWN, plus(times(2, f"v_{i}-positive"), GROWN))),
                   says=f"|W_{i}| ≥ v_{i}")  # fmt: skip
    yield from absolute("a", a, (w_c, "w_c-positive"), ("cs-a", "A-below"))
    yield from laws.root()
    yield from laws.between_zero_and_one()
    yield from _root()


def _root() -> Iterator[Item]:
    bent = times(power("d-sum-positive", 2), power("Cnd1", 2))
    closer = times("d-positive", plus(2, "d-positive"))
    yield from (
        Line("zeta-least", U * (2 - U) <= zeta,
             scaled(times("goal", bent), "u-bound", times(closer, "A-above"),
                    equations=(("zeta-product", -ONE),))),
        Line("S-most",     S <= 1 - U,
             scaled(times("goal", plus("goal", times(2, "U-one"))), "zeta-least",
                    using="S-square"), LABEL, "u = 1 - √(1-ζ) ≥ U"),
        Line("far-least",  0 < v**2 - start.y**2,
             scaled(times("goal", power(G_POSITIVE, 2)), "start-reach", power("v-positive", 2))),
        Line("reach-here", 1 + d <= G, scaled(*_reach(bent, closer),
                                              equations=(("zeta-product", -ONE),)), TIME,
             "1 + d ≤ Γ"),
    )  # fmt: skip


def _reach(bent: Value, closer: Value) -> Iterator[Value]:
    """(1+d)^2 (v^2 - y_0^2) < v^2, since zeta < 1; and G is that far at least."""
    longer = times("goal", plus("goal", times(2, G_POSITIVE)))
    faster = times("v_c-least", plus("v_c-least", times(2, "v-positive")))
    yield times("far-least", longer)
    yield "start-reach"
    yield times("zeta-one", bent)
    yield times(closer, plus("A-above", faster))
    yield times(power("d-sum-positive", 2), "y-most", plus("start-y", "Cnd1"))


def flight() -> Iterator[Item]:
    """Everything about the time tau between the two collisions, and d_next."""
    yield from laws.time(times("d-positive", plus(2, "d-positive")))
    faster = times("v_c-least", plus("v_c-least", times(2, "v-positive")))
    short = plus("A-above", faster)
    yield from (
        Line("time",        tau <= step * y,
             proof(times("tau-positive", short), times("reach-here", "Cnd1"),
                   times("d-sum-positive", "Cnd1", "S-positive"),
                   equations=(("tau-product", -ONE),)), TIME, "τ ≤ Γ(-η_c)/v²"),
        Line("swift-least", U * y <= w_c**2 * tau,
             proof(times("tau-positive", "A-below"), times("d-positive", "Cnd1", "S-one"),
                   times("Cnd1", "S-most"), equations=(("tau-product", ONE),)), TIME,
             "w_c² τ ≥ U(-η_c)"),
        Defined("rho"),
        Line("rho-positive", 0 < rho, proof(power("v_s-positive", 2), using="rho")),
        Line("pull-least",  rho * U * y <= v_s**2 * tau,
             proof(times(square(v_s), "swift-least"), using="rho"), LABEL, "v_s² τ ≥ ρU(-η_c)"),
        Line("push-least",  rho * U * y <= B * tau,
             proof("pull-least", times("tau-positive", "B-above")), says="|W_s|² τ ≥ ρU(-η_c)"),
        Line("inward",      d <= tau * y,
             scaled(times("goal", plus("goal", 2)), times(power("tau-positive", 2), "cs-c"),
                    equations=(("contact", -ONE),)), DISTANCE, "d ≤ τ(-η_c)"),
    )  # fmt: skip
    yield from laws.distance()
    yield laws.NEXT_D_POSITIVE
    yield laws.NEXT_D_SUM_POSITIVE


# --- the collision  -------------------------------------------------------------------------------


#: How far -cos theta can turn until the next collision.
change = (w_0 + w_1 + 2 * start.y) * tau
#: (1+d')(-eta_c') and (1+d')^2 - 1, without quotients.
closing = half * impact * turn - (eta_s + tau * B)
spread = 2 * eta_s * tau + B * tau**2
PUSH = times("rho-positive", "U-least")
LATER = times("gain-positive", "ratio-positive", "g-positive")
SLOWER = times("gain-positive", "decay-positive", "g-positive")


def lines() -> Iterator[Item]:
    """The laws, then the map, then all conditions at the next state."""
    yield from _angle()
    yield from laws.laws()
    yield TURN
    yield Line("next-angle", carried.at_next("angle"),
               scaled(times("D-positive", "goal"), "turn-room", times("D-one", "angle-room"),
                      equations=(("turn", -ONE),)),
               says="-cos θ' stays below C₊ less the sum of all later changes")  # fmt: skip
    yield C_NEXT_ONE
    yield from _map()
    yield from _speeds()
    yield from _next_speeds()
    yield from _next_point()
    yield from _others()


def _angle() -> Iterator[Item]:
    """The turn of the angle until the next collision."""
    yield from spinning((w_s, "w_s-positive"))
    speeds = plus("w_0-positive", "w_1-positive", times(2, "start-y"))
    later = times("turning-positive", plus("g-bound", times("decay-positive", "g-positive")))
    room = plus("C-room", times("turning-positive", "g-positive"))
    yield from (
        Line("turned",     change <= turning * (1 - ratio) * y,
             scaled(times("goal", power("v-positive", 2)), times(speeds, "time"),
                    equations=(("turning-sum", y),))),
        Line("angle-room", 0 <= C_p - turning * (ratio * g), proof("angle-start", later)),
        Line("turn-room",  turn <= C_p - turning * (ratio * g),
             proof(times("angle", "d-sum-positive"), times("d-positive", room), times(2, "inward"),
                   times(2, "tau-positive", "y-most"), times("tau-positive", "a-lower"),
                   times("tau-positive", "spin-lower"), "turned",
                   times("turning-positive", "decay-positive", "Cnd2"),
                   equations=(("w-sum", -tau),)),
             ANGLE, "(1+d')(-cos θ') stays below C₊ less the sum of all later changes"),
        Line("turn-most",  turn <= C_p,
             proof("turn-room", times("turning-positive", "ratio-positive", "g-positive"))),
        Line("C_p-least",  0 <= C_p, proof("angle-start", times("turning-positive", "start-y"))),
    )  # fmt: skip


def _map() -> Iterator[Item]:
    """(1+d')(-eta_c') is at most P(-eta_c), so that P > 0 where the run goes on."""
    strong = times("half-C", "reach-here", "Cnd1", "S-positive")
    yield IMPACT_POSITIVE
    yield from parts()
    yield from (
        IMPACT_BOUND,
        Line("impact-most",   impact <= G * y * (1 - U),
             proof(times("d-sum-positive", "Cnd1", "S-most"),
                   times("Cnd1", "reach-here", "U-one")), COMPONENTS,
             "|W_c·ω_s'| ≤ Γ(1-U)(-η_c)"),
        Line("half-C",        0 <= half * C_p, proof(times(HALF, "C_p-least"))),
        Line("closing-law",   equal(D * y_next, closing), identity("law-eta-c",
             (("turn", D * half * impact),)), COMPONENTS),
        Line("time-is",       equal(time_here, tau), identity("tau", (("time-law", ONE),))),
        Line("root-is",       equal(root_here, S), identity("S", (("root-law", ONE),))),
        Line("next-closing",  0 < closing, proof("approaches-again", using="time-is root-is")),
        Line("closing-positive", 0 < D * y_next,
             proof("next-closing", equations=(("closing-law", ONE),))),
        Line("next-Cnd1",     carried.at_next("Cnd1"),
             scaled(times("goal", "D-positive"), "closing-positive"), says="η_c' < 0"),
        Defined("pace"),
        Line("pace-law",      equal(pace, half * G * C_p * (1 - U) - Q - rho * U),
             identity("pace rho"), LABEL, "P = α(1-U) - Q - ρU"),
        Line("pace-most",     D * y_next <= pace * y,
             proof(times(HALF, "impact-positive", "turn-most"), times("half-C", "impact-most"),
                   "q-bound", "push-least", using="pace-law", equations=(("closing-law", -ONE),)),
             GROWTH, "(1+d')(-η_c') ≤ P(-η_c)"),
        Line("pace-positive", 0 < pace,
             scaled(times("goal", "Cnd1"), "pace-most", "closing-positive")),
        Line("approaches",    0 < here.P, proof("pace-positive", using="pace"), LABEL,
             "where the run goes on, the map goes on: P > 0"),
        Line("order",         D * y_next * (1 - U) <= pace * y * S,
             proof(times("U-one", HALF, "impact-positive", "turn-most"), times("U-one", strong),
                   times("U-one", plus("q-bound", "push-least")),
                   times(plus("Q-least", PUSH), "Cnd1", "S-most"), using="pace-law",
                   equations=(("closing-law", -(1 - U)),)), GROWTH,
             "√(1-ζ)/(1-U) ≥ (1+d')(η_c'/η_c)/P: the step keeps the order"),
        Defined("load"),
        Line("load-law",      equal(load, rho * U * (2 * Q + rho * U)), identity("load rho"),
             LABEL, "P²(1-(1-U')²) = ρU(2Q+ρU)"),
        Line("load-least",    0 <= load,
             proof(times(PUSH, plus(times(2, "Q-least"), PUSH)), using="load-law")),
    )  # fmt: skip


def _speeds() -> Iterator[Item]:
    """What the collision does to the speeds."""
    low_s, low_c = v_s + gain * g, v_c + gain * g
    hit = times(HALF, "impact-positive")
    yield from (
        Line("impact-short",  impact <= gain * (1 - ratio) * g,
             proof("impact-bound", times(G_POSITIVE, "Cnd2"), equations=(("gain-sum", g),))),
        Line("half-short",    half * impact <= gain * (1 - ratio) * g,
             proof("impact-short", times(Fraction(1, 2), "r-below-one", "impact-positive"))),
        *struck(),
        Line("struck-room",   0 < low_s - half * impact,
             proof("half-short", "v_s-positive", LATER)),
        Line("struck-least",  (low_s - half * impact) ** 2 <= A_next,
             scaled(times("goal", plus("v_s-positive", GROWN)), times(hit, "spin-square"),
                    times("struck-room", "B-lower"), times(hit, square(spin + low_s)),
                    using="law-norm-c impact-speed"),
             NORMS, "|W_c'| ≥ |W_s| - (1+r)/2 |W_c·ω_s'|, with a bound for |W_s|"),
        Line("left-room",     0 < low_c - impact,
             proof("impact-short", "v_c-positive", LATER)),
        Line("left-least",    (low_c - impact) ** 2 <= B_next,
             proof("A-lower",
                   times("impact-positive",
                         plus(times(2, "left-room"), times(power("r-positive", 2),
                                                           "impact-positive"))),
                   using="law-norm-s impact-speed"),
             NORMS, "|W_s'| ≥ |W_c| - |W_c·ω_s'|, with a bound for |W_c|"),
    )  # fmt: skip


def _next_speeds() -> Iterator[Item]:
    """Each bound leaves room for the sum of all later changes."""
    energy = times("r-below-one", plus(1, "r-positive"), power("impact-positive", 2))
    hit = times(HALF, "impact-positive")
    most, least = "stays below the bound less", "stays above the bound and"
    rest = "the sum of all later changes"
    yield from (
        carried.line("high-c", "w_s stays above the bound of |W_c'|", "high-s", SLOWER),
        carried.line("high-s", "w_c stays above the bound of |W_s'|", "high-c", SLOWER),
        carried.line("A-upper", f"|W_c'| {most} {rest}", "struck-most",
                     times("half-short", plus("next-high-c", "high-s", hit))),
        carried.line("B-upper", f"|W_s'| {most} {rest}", "A-upper", energy,
                     times(SLOWER, plus("high-c", "next-high-s")),
                     using="law-norm-s impact-speed"),
        carried.line("A-lower", f"|W_c'| {least} {rest}", "struck-least",
                     times("half-short", plus("struck-room", "v_s-positive", LATER))),
        carried.line("B-lower", f"|W_s'| {least} {rest}", "left-least",
                     times("impact-short", plus("left-room", "v_c-positive", LATER))),
        Line("next-A-above", v_s**2 <= A_next,
             proof("next-A-lower", times(LATER, plus(times(2, "v_s-positive"), LATER)))),
    )  # fmt: skip


def _next_point() -> Iterator[Item]:
    """The map goes on, and the next state lies above where it leads."""
    pushed = times(PUSH, "Cnd1")
    faster = times("pace-most", plus(times("pace-positive", "Cnd1"),
                                     times("D-positive", "next-Cnd1")))  # fmt: skip
    both = ("closing-law", D * y_next + closing)
    radicand = 1 - load / pace / pace
    pulled = times(square(v_s), "tau-positive")
    yield from (
        Line("spread-positive", 0 < spread,
             proof(times(2, "recedes", "tau-positive"),
                   times("B-positive", power("tau-positive", 2)))),
        Line("spread-least",  load * y**2 <= v_s**2 * spread,
             proof(times(2, "pull-least", "recedes"), times(2, pushed, "q-bound"),
                   times(square(v_s * tau), "B-above"),
                   times("pull-least", plus(pulled, pushed)), using="load-law")),
        Line("next-meets",    spread * A_next < closing**2,
             proof("meets-again", using="time-is root-is law-norm-c impact-speed")),
        Line("goes-below",    load < pace**2,
             scaled(times("goal", power("Cnd1", 2)), "spread-least",
                    times("spread-positive", "next-A-above"), "next-meets", faster,
                    equations=(both,))),
        Line("meets",         here.meets, proof("goes-below", using="load pace rho"), LABEL,
             "and ρU(2Q+ρU) < P²: where the run goes on, the map goes on"),
        Defined("Q_next"),
        Line("Q-next-law",    equal(Q_next * pace, r * (1 - U)), identity("Q_next"), LABEL,
             "Q' = r(1-U)/P"),
        Line("next-Q-least",  carried.at_next("Q-least"),
             scaled(times("goal", "pace-positive"), times("r-positive", "U-one"),
                    equations=(("Q-next-law", ONE),)), says="0 ≤ Q'"),
        carried.line("recedes", "η_s' > 0: the pair that just met separates",
                     times("r-positive", "impact-positive"), using="law-eta-s"),
        Line("next-q-bound",  carried.at_next("q-bound"),
             scaled(times("goal", "pace-positive"), times("r-positive", "order"),
                    times("r-positive", "d-positive", "Cnd1", "S-positive", "pace-positive"),
                    times("r-positive", "U-one", "next-Cnd1", "D-one"),
                    equations=(("Q-next-law", -y_next),), using="law-eta-s"),
             says="η_s'/(-η_c') ≥ Q'"),
        Line("radicand",      0 < radicand, proof("goes-below")),
        Line("map-root",      0 < sqrt(radicand), ByRoot()),
        Defined("U_next"),
        Line("U-next-law",    equal(U_next * (2 - U_next) * pace**2, load), identity("U_next"),
             LABEL, "1-(1-U')² = ρU(2Q+ρU)/P²"),
        carried.line("U-one", "U' < 1", "map-root", using="U_next"),
        Line("next-U-least",  carried.at_next("U-least"),
             scaled(times("goal", plus("goal", 2), power("pace-positive", 2)), "load-least",
                    equations=(("U-next-law", ONE),)), says="0 ≤ U'"),
        Line("next-u-bound",  carried.at_next("u-bound"),
             scaled(times("goal", power("pace-positive", 2)), times("load-least", faster),
                    times(power("pace-positive", 2), "spread-least"), using="d_next",
                    equations=(("U-next-law", -((D * y_next) ** 2)),
                               ("D-square", pace**2 * v_s**2))),
             says="u' ≥ U'"),
        Line("next-Cnd3",     carried.at_next("Cnd3"),
             proof("next-meets", using="d_next", equations=(("D-square", -A_next), both)),
             says="ζ' < 1"),
    )  # fmt: skip
    yield from carried.root("next-", carried.following)


def _others() -> Iterator[Item]:
    yield KEPT_POSITIVE
    yield from slower(carried)
    for name, other in (("v_c-least", "v_s-least"), ("v_s-least", "v_c-least")):
        yield Line(f"next-{name}", carried.at_next(name), proof(other))
    for name in ("root-law", "time-law"):
        yield Line(f"next-{name}", carried.at_next(name), identity())
    yield Line("next-w-sum", carried.at_next("w-sum"), identity("", (("w-sum", ONE),)))
