"""The paper read a second time: it agrees with the step, or the difference is explained.

At exact random states in dimensions 2, 3 and 4 both sides of a row of the step are computed from
the statement's terms, and both sides of the reader's line from vectors. An equation has to have the
same sides, an inequality the same slack, after multiplying with what the table names.
"""

from __future__ import annotations

import random
from collections.abc import Callable
from dataclasses import dataclass
from fractions import Fraction
from functools import cache
from typing import Any

import pytest
from flint import arb, fmpq

from verify.language.statement import Constant
from verify.language.terms import Claim, as_term
from verify.paper.commands.citing import MEANING
from verify.paper.commands.theorem1 import decide_point
from verify.paper.parameters import PARAMETERS
from verify.prover.program import ExactArithmetic, Machine, Program

from . import second_estimates
from .second_constants import Constants, hypothesis
from .second_reading import READINGS, Chain, Number, Place, dot, holds, links, root
from .second_states import allowed_place, exact_place
from .states import STEP

Side = Callable[[Number, Place], Number]


#: Constants of both sets that have the same name in both readings.
CONSTANTS = ("delta_1", "delta_2", "delta_3", "delta_4", "delta_5", "C_eta", "h_4", "h_5", "V_1")


@dataclass(frozen=True)
class Match:
    """A row (or its two halves) and a part of a chain: from which place in it to which.

    ``via`` says what was done to each side of the chain, ``more`` what the row's slack has beyond.
    """

    rows: tuple[str, ...]
    reading: str
    ends: tuple[int, int] = (0, 2)
    via: Side = lambda x, q: x
    more: Callable[[Place], Number] = lambda q: fmpq(0)
    why: str = ""


def halves(name: str) -> tuple[str, str]:
    return f"{name}-upper", f"{name}-lower"


def y(q: Place) -> Number:
    return -q.n.eta_c


def _loose(q: Place) -> Number:
    return q.K.speed * q.n.tau - q.K.V_1 * q.n.tau**2


def _sharper(q: Place) -> Number:
    return -q.K.h_4 * q.K.delta_x / 8 * y(q)


MATCHES = (
    # the laws
    Match(("tau-product",), "time of the next collision", via=lambda x, q: x * q.n.Wc2),
    Match(("D-square",), "law of d", via=lambda x, q: (1 + x) ** 2),
    Match(("law-eta-c",), "law of eta_c", via=lambda x, q: -x),
    Match(("law-eta-s",), "law of eta_s"),
    Match(("law-norm-c",), "law of |W_c|^2", why="printed with 2 for 4 in the last term"),
    Match(("law-norm-s",), "law of |W_s|^2"),
    Match(("law-angle",), "law of -cos theta"),
    Match(("impact-speed",), "normal velocity at the touch", (0, 4)),
    # times and gaps
    Match(("time-product",), "bound on tau", via=lambda x, q: x * q.n.Wc2),
    Match(("time-crude",), "bound on tau", (0, 4), via=lambda x, q: x * q.K.V_0),
    Match(("time",), "crude bound on tau", (0, 4), via=lambda x, q: x * q.K.V_0),
    Match(
        ("time-product",), "tau / (-eta_c) by zeta^2",
        via=lambda x, q: root(x) * q.n.Wc2 * y(q), why="printed without the square",
    ),
    Match(("time-square",), "V_1 tau^2 is small"),
    Match(("time-speed",), "V_1 tau^2 is small", (2, 4)),
    Match(("distance",), "bound on d_1"),
    Match(("distance-time",), "bound on d_1", (0, 4)),
    Match(("distance-speed",), "bound on d_1", (0, 6), via=lambda x, q: x * q.K.V_0),
    Match(("distance",), "bound on d_n", why="printed for d_n instead of d_{n+1}"),
    Match(("distance-time",), "bound on d_n", (0, 6), why="the same"),
    Match(("C-positive",), "the particles 1 and 2 start apart", via=lambda x, q: x / 2 - 1),
    Match(("outer-pair-apart",), "at first 1 and 2 stay apart", (0, 4), via=lambda x, q: x**2),
    # norms
    Match(("norm-c-upper",), "step of |W_c|^2", (0, 6)),
    Match(
        ("norm-s-upper",), "step of |W_s|^2", (0, 4),
        more=lambda q: 4 * (q.K.speed + 1) * y(q), why="the step takes the larger bound of Cnd6",
    ),
    Match(("Cnd5-upper",), "room for the norms"),
    # ratios
    Match(
        ("law-eta-c",), "y_n and x_n",
        via=lambda x, q: -(x + q.K.phi - q.K.alpha) * y(q),
    ),
    Match(
        ("law-eta-c",), "ratio at the start",
        via=lambda x, q: (x + q.K.alpha - q.K.phi) * y(q),
    ),
    Match(("y-contracts",), "|eta_{c,n+1}| <= C_eta |eta_{c,n}|"),
    Match(("y-contracts",), "eta_{c,n+1} is negative and smaller", (2, 4), lambda x, q: x * y(q)),
    Match(("y-survives",), "eta_{c,n+1} is negative and smaller", (4, 6), lambda x, q: x * y(q)),
    Match(("next-Cnd1",), "eta_{c,n+1} is negative and smaller", (4, 8), lambda x, q: x * y(q)),
    Match(
        ("y-upper-bound", "y-lower-bound"), "main term of x_{n+1}", (2, 4),
        via=lambda x, q: x * y(q) / (1 - q.K.h_4),
    ),
    Match(halves("next-Cnd9"), "improved bound on x_{n+1}", via=lambda x, q: x * -q.m.eta_c),
    Match(("ratio-bound",), "eta_s / (-eta_c) <= alpha_0 / 2", via=lambda x, q: x * y(q)),
    Match(
        ("y-term-kept",), "first term at the start is a quarter", via=lambda x, q: x * y(q),
        more=_sharper, why="an eighth at n = 0 too",
    ),
    Match(
        ("y-term-gained",), "fifth term at the start is a quarter", via=lambda x, q: x * y(q),
        more=_sharper, why="an eighth at n = 0 too",
    ),
    # zeta and the angle
    Match(("root-fine",), "1 - sqrt(1 - zeta)"),
    Match(halves("angle-step"), "first angle", (0, 4)),
    Match(
        halves("angle-step"), "step of the angle", (0, 4), more=_loose,
        why="printed with = and - for <= and +; then V_1 tau^2 <= V_1^{1/2} tau",
    ),
)  # fmt: skip

#: What only the second reading has as a line of its own, and where the first has it.
ONLY_SECOND = {
    "law of W_c": "the collision map: its inner products are compared below",
    "law of W_s": "the same",
    "law of omega_c": "the same",
    "law of omega_s": "the same",
    "law of zeta": "the same",
    "zeta by d": "inside the proof of start-Cnd4; the theorem's row init-Cnd4",
    "finer bound on tau": "not used: gained is bounded through zeta_bar",
    "no contact of 1 and 2": "outer-pair-apart proves 1 < distance for all times at once",
    "third term at the start": "root-product-upper, root-product-lower, without a factor below 1",
    "third term at the start is a quarter": "d-share, and the theorem's row init-y-term-3-zeta",
    "x_{n+1}": "inside the proof of next-Cnd9: x' is never divided out",
    "first term of x_{n+1}": "root-product-upper, root-product-lower times r",
    "first term of x_{n+1} is half of h_4 delta_x": "d-small and zeta_bar-small",
    "y_{n+1}": "inside the proofs of y-upper-bound and y-lower-bound",
    "first term of y_{n+1} is an eighth": "y-term-kept, sharper by 1/(1+d') - 1 for d'",
    "second term of y_{n+1} is an eighth": "d-share, next-d-share and the row y-term-2-zeta",
    "fourth term of y_{n+1} is an eighth": "y-term-gained, sharper by |W_s|^2/(1+d') for V_1",
    "zeta_{n+1}, a priori": "zeta-product-next and zeta-cleared",
    "zeta_{n+1} by zeta_n": "zeta-term-4 with V_1/V_0 for the ratios of norms",
    "zeta_{n+1} in four terms": "root-twice, compared below",
    "x_n is small": "the theorem's row zeta-x-bound, at |x_n| = delta_x",
    "second term of zeta_{n+1}": "the theorem's row zeta-term-2, at |x_n| = delta_x",
    "third term of zeta_{n+1}": "the theorem's row zeta-term-3, at the worst state",
    "fourth term of zeta_{n+1}": "the theorem's row zeta-term-4, at the worst state",
    "zeta_n is small enough": "the theorem's row zeta-small, at zeta_bar",
    "three remainder terms": "the theorem's row zeta-remainders, at the worst state",
    "main term of zeta_{n+1}": "the theorem's rows zeta-main-y and zeta-main",
    "zeta_{n+1} <= (1 - h_5/4) zeta_n": "next-Cnd4 needs zeta' <= zeta_bar; the row zeta-total",
    "next angle": "two angle-step with distance-speed and time-crude: in next-Cnd8",
    "all turns together are at most |Delta theta|": "the theorem's row angle-absorbed",
}

#: Rows of a state that only the first reading has.
ONLY_FIRST = {
    "said in words, or a condition that the reader has in `hypothesis`": """
        A-above A-below B-above B-below zeta-bound zeta-one next-d-positive next-Cnd2 next-g-bound
        next-Cnd3 next-Cnd4 next-Cnd8-upper next-Cnd8-lower next-A-upper next-A-lower next-B-upper
        next-B-lower zeta-positive tau-positive contact S-square zeta-product impact-positive""",
    "d_n <= 1, which the paper uses and does not carry": "next-d-one",
    "a bound from below, which the paper leaves out": "norm-c-lower norm-s-lower",
    "a half of a line that the reader has with its factor": """
        root-crude root-product-upper root-product-lower y-term-root-upper y-term-root-lower
        x-term-upper x-term-lower kept-loss ratio-worst""",
    "worked out where the paper says nothing": """
        C_next-one C_next-positive angle-upper angle-lower spin-upper spin-lower impact-bound
        zeta-distance zeta-dropped root-twice zeta-terms-1-to-3 zeta-term-4 zeta-all
        next-recedes""",
    "the end of the theorem, which the paper does not prove": """
        next-clock-bound angle-final-upper angle-final-lower time-total angle-monotone-upper
        angle-monotone-lower""",
    "what particles do between collisions": "approach colliding-pair-apart spectator-apart",
}


# --- the terms of the step at a state -------------------------------------------------------------


@cache
def rows() -> dict[str, Claim]:
    found = {o.name: o.claim for o in STEP.obligations if isinstance(o.claim, Claim)}
    givens = {g.name: g.claim for c in STEP.contexts for g in c.givens}
    return givens | found


def fraction(x: fmpq) -> Fraction:
    return Fraction(int(x.p), int(x.q))


def inputs(q: Place) -> dict[str, Fraction]:
    """The names of the statement: the numbers, and the inner products of a state."""
    n, K = q.n, q.K
    names = {*MEANING} & {*dir(K)}
    numbers = {name: getattr(K, name) for name in sorted(names)}
    numbers |= {"alpha_0": K.alpha, "phi_minus": K.phi, "delta_y": K.delta_x}
    numbers |= {"y": y(q), "eta_s": n.eta_s, "C": n.neg_cos, "A": n.Wc2, "B": n.Ws2, "d": n.d}
    numbers |= {"a": dot(n.omega_s, n.W_c), "b": dot(n.omega_c, n.W_s), "w": dot(n.W_s, n.W_c)}
    numbers |= {"g": y(q), "clock": fmpq(0), "t": n.tau}
    return {name: fraction(value) for name, value in numbers.items()}


@cache
def machine() -> Machine:
    """All rows of the table, and the collision map, as one program of exact arithmetic."""
    program = Program(inputs(exact_place(random.Random(0), 2)))
    for constant in collision_map():
        program.define(constant.name, constant.term)
    for match in MATCHES:
        for row in match.rows:
            program.add(rows()[row].lhs)
            program.add(rows()[row].rhs)
    program.add(rows()["root-twice"].lhs)
    program.add(rows()["root-twice"].rhs)
    return Machine(program, ExactArithmetic())


def collision_map() -> tuple[Constant, ...]:
    """The constants of the context of a state."""
    return STEP.context("state").constants


class Values:
    """The values of the step's terms at a place."""

    def __init__(self, q: Place) -> None:
        self.run = machine().run(inputs(q).values())

    def side(self, term: Any) -> fmpq:
        value = self.run[term]
        assert value is not None, term
        return fmpq(value.numerator, value.denominator)

    def constant(self, name: str) -> fmpq:
        value = self.run.values[machine().program.slots[name]]
        return fmpq(value.numerator, value.denominator)


def same(a: Number, b: Number) -> bool:
    return holds(a, "=", b) is True


def agree(match: Match, chain: Chain, q: Place, values: Values) -> bool:
    """The same sides of an equation, the same slack of an inequality."""
    left, right = (match.via(chain[i], q) for i in match.ends)
    claims = [rows()[row] for row in match.rows]
    slacks = [values.side(c.rhs) - values.side(c.lhs) for c in claims]
    equations = {relation == "=" for relation in chain[match.ends[0] + 1 : match.ends[1] : 2]}
    if equations != {claims[0].relation == "="}:
        return False
    if equations == {True}:
        return same(left, values.side(claims[0].lhs)) and same(right, values.side(claims[0].rhs))
    return same(right - left + match.more(q), min(slacks))


def right(match: Match, q: Place) -> Chain:
    reading = READINGS[match.reading]
    return (reading.instead or reading.chain)(q)


@pytest.mark.parametrize("dimension", [2, 3, 4])
def test_both_readings_have_the_same_lines(dimension: int) -> None:
    rng = random.Random(dimension)
    for _ in range(20):
        q = exact_place(rng, dimension)
        values = Values(q)
        assert [m for m in MATCHES if not agree(m, right(m, q), q, values)] == []


@pytest.mark.parametrize("dimension", [2, 3, 4])
def test_both_readings_have_the_same_collision(dimension: int) -> None:
    rng = random.Random(10 + dimension)
    for _ in range(20):
        q = exact_place(rng, dimension)
        n, m, values = q.n, q.m, Values(q)
        found = {
            "zeta": n.zeta, "S": n.still, "tau": n.tau, "kappa": q.hit, "D": 1 + m.d,
            "d_next": m.d, "C_next": m.neg_cos, "y_next": -m.eta_c, "eta_s_next": m.eta_s,
            "A_next": m.Wc2, "B_next": m.Ws2, "a_next": dot(m.omega_s, m.W_c),
            "b_next": dot(m.omega_c, m.W_s), "w_next": dot(m.W_s, m.W_c),
            "kept": n.eta_s / (1 + m.d), "gained": n.tau * n.Ws2 / (1 + m.d),
        }  # fmt: skip
        assert set(found) == {constant.name for constant in collision_map()}
        assert {name: values.constant(name) for name in found} == found


@pytest.mark.parametrize("dimension", [2, 3, 4])
def test_both_readings_have_the_same_law_of_collision(dimension: int) -> None:
    """With the central particle at any velocity, along each axis."""
    rng = random.Random(20 + dimension)
    q = exact_place(rng, dimension)
    base = [fmpq(rng.randint(-9, 9), 5) for _ in range(dimension)]
    v_c = [x + z for x, z in zip(base, q.n.W_c, strict=True)]
    v_s = [x + z for x, z in zip(base, q.n.W_s, strict=True)]
    omega = q.m.omega_s
    for axis in range(dimension):
        values = {
            "e_r": q.r, "e_0": base[axis], "e_c": v_c[axis], "e_s": v_s[axis],
            "e_omega": omega[axis], "n_0": dot(base, omega), "n_c": dot(v_c, omega),
            "s_0": dot(base, base), "s_c": dot(v_c, v_c),
        }  # fmt: skip
        assert set(values) == {v.name for v in STEP.context("impact").variables}
        program = Program(values)
        for name, new in (("impact-velocity-s", q.m.W_s), ("impact-velocity-c", q.m.W_c)):
            sides = [program.add(side) for side in (rows()[name].lhs, rows()[name].rhs)]
            run = Machine(program, ExactArithmetic()).run(fraction(v) for v in values.values())
            assert {run.values[slot] for slot in sides} == {fraction(new[axis])}


def test_the_factor_that_the_print_drops_is_the_only_difference() -> None:
    """From `zeta_{n+1} by zeta_n` to `four terms`: root-twice times |W'|^2/|W|^2 X/rho^2."""
    rng = random.Random(5)
    for dimension in (2, 3, 4):
        q = exact_place(rng, dimension)
        before = READINGS["zeta_{n+1} by zeta_n"].chain(q)[2]
        after = READINGS["zeta_{n+1} in four terms"].chain(q)[2]
        row, values = rows()["root-twice"], Values(q)
        slack = values.side(row.rhs) - values.side(row.lhs)
        assert after - before == q.m.Wc2 / q.n.Wc2 * q.X / q.rho**2 * slack


# --- what each has alone --------------------------------------------------------------------------


def test_every_line_of_the_second_reading_is_accounted_for() -> None:
    assert second_estimates.SAID
    matched = {match.reading for match in MATCHES}
    assert matched | set(ONLY_SECOND) == set(READINGS)
    assert not matched & set(ONLY_SECOND)


def test_every_row_of_a_state_is_accounted_for() -> None:
    contexts = {"state", "before", "meanwhile"}
    listed = {name for names in ONLY_FIRST.values() for name in names.split()}
    matched = {row for match in MATCHES for row in match.rows} - {"Cnd5-upper"}
    here = {row.name for row in STEP.obligations if row.context in contexts}
    assert matched | listed == here
    assert not matched & listed


def test_where_the_print_is_wrong_the_reader_put_the_steps_formula() -> None:
    rng = random.Random(6)
    q = exact_place(rng, 3)
    values = Values(q)
    for match in MATCHES:
        reading = READINGS[match.reading]
        if reading.instead is not None:
            assert match.why
            assert not agree(match, reading.chain(q), q, values)


# --- the constants --------------------------------------------------------------------------------

POINTS = (("3/100", "95/103", "1", "1/10"), ("1/1000", "3/10", "7/3", "1/1000"))


@pytest.mark.parametrize("point", POINTS)
def test_both_readings_have_the_same_printed_constants(point: tuple[str, ...]) -> None:
    values = dict(zip(PARAMETERS, map(Fraction, point), strict=True))
    terms = {name: as_term(value) for name, value in values.items()}
    found = decide_point(terms, "printed").enclosures
    K = Constants(**{name: fmpq(x.numerator, x.denominator) for name, x in values.items()})
    names = {name: getattr(K, name) for name in CONSTANTS}
    names |= {"alpha_0": K.alpha, "phi_minus": K.phi}
    own = {"delta_x", "x_0", "Delta_theta", "eta_bar", "zeta_bar"}
    names |= {f"printed.{name}": getattr(K, name) for name in own}
    names |= {"printed.delta_y": K.delta_x, "printed.d_bar": K.d_bar(K.eta_bar)}
    for name, value in names.items():
        low, high = (fmpq(end.numerator, end.denominator) for end in found[name].ends[0])
        assert high - low < fmpq(1, 10**20)
        assert low <= value <= high, name


# --- what the reader makes of each line -----------------------------------------------------------


def allowed(seed: int, count: int) -> list[Place]:
    """States at which all conditions of the recursion are seen to hold."""
    rng, found = random.Random(seed), []
    while len(found) < count:
        q = allowed_place(rng, rng.choice([2, 3, 4]))
        try:
            if q is not None and all(
                holds(*part) for parts in hypothesis(q).values() for part in parts
            ):
                found.append(q)
        except ValueError:
            continue
    return found


def test_each_view_of_the_reader_is_what_random_states_show() -> None:
    """What is called right is never violated at an allowed state; what is called wrong is."""
    violated = set()
    for q in allowed(1, 150):
        for name, reading in READINGS.items():
            if any(holds(*part) is False for part in reading.parts(q)):
                violated.add(name)
            if reading.instead is not None:
                assert all(holds(*part) is not False for part in links(reading.instead(q)))
    assert violated == {name for name, reading in READINGS.items() if reading.view == "wrong"}


def test_a_ball_never_decides_more_than_it_knows() -> None:
    two = arb(2).sqrt() ** 2
    assert holds(two, "=", fmpq(2)) is True
    assert holds(two, "<=", fmpq(2)) is None
    assert holds(two, "=", fmpq(3)) is False
    assert holds(arb(0, 1), "=", fmpq(0)) is None
    assert holds(fmpq(1), "<", fmpq(1)) is False
