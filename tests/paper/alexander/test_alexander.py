"""Almost every start: all givens are needed, and near misses of the rows are not proved."""

from __future__ import annotations

from decimal import Decimal, localcontext
from random import Random

import mpmath
import pytest

from docs.orbits import PICTURE, cross, dot, drawn, without_momentum
from tests.facts import MEASURED
from tests.paper.changed_statements import answer, without
from verify.language.statement import PROVED
from verify.paper.commands.pages import content, decide, page
from verify.prover.budget import WorkBudget
from verify.wire.questions import decide_page
from verify.wire.text.read_page import read_page

PAGE = "alexander"
STATEMENT = page(PAGE).statement
#: Each row with a wrong sign, factor or index, or strict where it is not: what is written, and what
#: stands there instead.
LIES = {
    "exact-S-law": ("(1 - S)", "(1 - S^2)"),
    "exact-contact": ("= 1", "= 1 + k*y^2"),
    "exact-impact": ("y*(1 + k*y^2)*S", "y*S"),
    "exact-reach": ("2*q", "q"),
    "law-p": ("- (q + B*T)", "- q"),
    "law-q": ("(1 + k*y^2)*S", "S"),
    "law-kappa": ("(1 + E)", "2*E"),
    "moved-s": ("k*y*omega_c", "k*omega_c"),
    "moved-c": ("T*V_s", "T*V_c"),
    "moved-along-s": ("(1 + d)*S*meeting", "S*meeting"),
    "moved-along-c": ("p*new_c", "new_c"),
    "late-q": ("b*(1 + d)*S*E", "b*S"),
    "late-x": ("e <= b*x", "e <= x"),
    "late-A": ("(1 + d)^2", "1"),
    "late-B": ("b*(1 + d)^2*E", "b"),
    "below-limit": ("- q", "- 2*q"),
    "below-growth": ("k*q", "2*k*q"),
    "under-p": ("(Q - q)", "2*(Q - q)"),
    "under-approaches": ("0 < p", "P < p"),
    "under-x": ("x <= X", "x < X"),
    "under-ratio": ("v*K*p^2 <= k*V*P^2", "v*K*p^3 <= k*V*P^3"),
    "under-v": ("v <= V", "v < V"),
    "under-apart": ("(K - k)", "2*(K - k)"),
    "under-most": ("p < a", "p < a - Q"),
    "under-limit": ("a - q", "a - 2*q"),
    "under-growth": ("k*q", "2*k*q"),
    "spread-expands": ("c*(x + D)", "2*c*(x + D)"),
    "next-x": ("1/2*c", "c"),
    "next-D": ("0 <= D_1", "c*x <= D_1"),
    "next-D-most": ("N*x_1", "1/8*N*x_1"),
    "next-Y-most": ("N*x_1", "1/8*N*x_1"),
    "next-H-most": ("s*x_1", "s*x"),
    "turn-product": ("= z", "= z + e"),
    "turn-factor": ("(z + e)", "(z + f)"),
    "turn-next": ("- f - e*f/z", "- e - e*f/z"),
    "record-place": ("h <= z", "h < z"),
    "inside-falls": ("(z + e)*z^2", "z^3"),
    "inside-keeps": ("e*f/z", "2*e*f/z"),
    "trap-high": ("t < h", "2*t < h"),
    "trap-rises": ("e*f/h", "2*e*f/h"),
    "level-next": ("t*(z - t)", "t^2*(z - t)"),
    "level-factor": ("(1 + 3*t)/t/t", "1/t/t"),
    "low-next": ("<= t", "< t"),
    "low-factor": ("<=", "<"),
    "weigh-keeps": ("(1 - W_1)", "(1 - W)"),
    "beneath-falls": ("m*(1 - L)*c", "2*m*(1 - L)*c"),
    "share-below": ("1 + e*f", "e*f"),
    "decay-falls": ("n + R/n - d", "2*n + R/n - d"),
    "decayed-stays": ("<=", "<"),
    "volume-positive": ("0 <", "y^2 <"),
    "equal-cube": ("9 - 4", "9 - 3"),
    "equal-regime": ("<=", "<"),
}


@pytest.mark.parametrize("context", [context.name for context in STATEMENT.contexts])
def test_each_given_is_used(context: str) -> None:
    outcome = decide(PAGE)
    claims = STATEMENT.context(context).claims
    assert [name for name in claims if answer(without(outcome, name)) == PROVED.upper()] == []


def test_every_row_has_a_near_miss_that_is_not_proved() -> None:
    text = content(PAGE).decode()
    for name, (right, wrong) in LIES.items():
        before, found, rest = text.partition(f"\n{name}: ")
        claim, end, after = rest.partition(";")
        assert found
        assert right in claim, name
        text = before + found + claim.replace(right, wrong) + end + after
    lying = read_page("a", text.encode(), (), lambda _: b"")
    verdicts = {row.name: found.claimed for row, found in decide_page(lying, WorkBudget()).rows}
    assert {row.name for row in STATEMENT.obligations} == LIES.keys()
    assert [name for name in LIES if verdicts[name] == PROVED] == []


# --- true ----------------------------------------------------------------------------------------


def test_the_rows_of_a_collision_are_what_three_balls_do() -> None:
    """Masses and velocities as they are: the next q, κ and y are those of the rows."""
    rng, met, dot = Random(1), 0, mpmath.fdot
    with mpmath.workdps(80):
        for _ in range(300):
            m, m_c, r = (mpmath.mpf(10) ** rng.uniform(-2, b) for b in (2, 2, -0.01))
            w_s, w_c = (unit(vector(rng)) for _ in "sc")
            k, y, q = (mpmath.mpf(10) ** rng.uniform(a, 0) for a in (-3, -9, -2))
            d, speeds = k * y * y, (rng.choice((0, 1)), rng.choice((0, 1)))
            v_s, v_c = (
                along * w + speed * (u - dot(u, w) * w)
                for along, w, speed, u in zip(
                    (q * y, -y), (w_s, w_c), speeds, (vector(rng), vector(rng)), strict=True
                )
            )
            root = ((1 + d) * y) ** 2 - dot(v_c, v_c) * d * (2 + d)
            if root <= 0:
                continue
            time = d * (2 + d) / ((1 + d) * y + mpmath.sqrt(root))
            contact, end = (1 + d) * w_c + time * v_c, w_s + time * v_s
            impulse = (1 + r) * -dot(v_c, contact) / (1 / m + 1 / m_c)  # 0 is at rest before
            v_0 = -impulse / m * contact
            apart = mpmath.norm(end)
            y_next = -dot(v_s - v_0, end) / apart
            if y_next <= 0:
                continue
            q_next = dot(v_c + impulse / m_c * contact - v_0, contact) / y_next
            # the letters of the page
            b, s = (1 + r) * m_c / (m + m_c), mpmath.sqrt(root) / (1 + d) / y
            t, c = k * (2 + d) / (1 + d) / (1 + s), -dot(contact, end) / apart
            p = (b * (1 + d) * s * c * apart - (q + dot(v_s, v_s) * t)) / apart
            kappa = t * (2 * q + dot(v_s, v_s) * t) / (1 + apart) / p**2
            near = mpmath.mpf(10) ** -40
            assert abs(p - y_next / y) < near * p
            assert abs(r * (1 + d) * s / p - q_next) < near * q_next
            assert abs(kappa * y_next**2 - (apart - 1)) < near * (apart - 1) + near * y**2
            met += 1
    assert met > 50


def test_the_picture_of_the_page_is_the_one_that_is_drawn() -> None:
    assert drawn() == PICTURE.read_text(encoding="utf-8")


def test_two_speeds_are_tuned_until_there_are_hundreds_of_collisions() -> None:
    told = MEASURED["without momentum"]
    with localcontext() as context:
        context.prec = told["digits"]
        *speeds, end = without_momentum(told["collisions"])
        assert [f"{speed:.10f}" for speed in speeds] == told["tangential speeds"]
        assert Decimal("1e-153") < end.d < Decimal("1e-152")
        assert f"{-dot(end.at_s, end.at_c):.10f}" == told["last cosine"]
        assert abs(cross(end.at_s, end.v_s)) < Decimal("1e-80")


def vector(rng: Random) -> mpmath.matrix:
    return mpmath.matrix([mpmath.mpf(rng.uniform(-1, 1)) for _ in range(3)])


def unit(x: mpmath.matrix) -> mpmath.matrix:
    return x / mpmath.norm(x)
