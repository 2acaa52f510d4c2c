"""What a collision does to velocities, and that what is assumed of vectors can be.

The law of collision gives the relative velocities of the collision map. Particle 0 is hit by
particle c; omega points from 0 to c, kappa = (v_c - v_0).omega < 0. Vectors are compared by their
components along an arbitrary direction e.

Cauchy-Schwarz holds where both velocities are normal but for parts orthogonal to all else. For
W_s = eta_s omega_s + ... and W_c = -y omega_c + ..., the dots orthogonal to one another and to the
omegas, each inequality is a sum of squares. This shows that what is assumed of the vectors of
every state does not contradict the rest.
"""

from __future__ import annotations

from collections.abc import Iterable, Iterator
from fractions import Fraction

from verify.language.argument import (
    ByInstance,
    Chapter,
    Item,
    Line,
    Opened,
    Value,
    identity,
    plus,
    power,
    proof,
    square,
    times,
)
from verify.language.statement import Context, Given, Variable
from verify.language.terms import Term, as_term, equal, symbol
from verify.language.vectors import Frame
from verify.paper.dynamics.state import inequalities

PLANE = "plane"

IMPACT = "impact"
LAW = "EQUATSS2.2IterationSystm1"
LETTERS = {
    "e_r": ("r", "r"),
    "e_0": ("v₀·e", r"v_0\cdot e"),
    "e_c": ("v_c·e", r"v_c\cdot e"),
    "e_s": ("v_s·e", r"v_s\cdot e"),
    "e_omega": ("ω·e", r"\omega\cdot e"),
    "n_0": ("v₀·ω", r"v_0\cdot\omega"),
    "n_c": ("v_c·ω", r"v_c\cdot\omega"),
    "s_0": ("|v₀|²", "|v_0|^2"),
    "s_c": ("|v_c|²", "|v_c|^2"),
}
r, e_0, e_c, e_s, e_omega, n_0, n_c, s_0, s_c = map(symbol, LETTERS)
kappa = n_c - n_0
jump = (1 + r) / 2 * kappa


def impact() -> Context:
    """The components of the velocities before a collision."""
    variables = tuple(Variable(name, *letters) for name, letters in LETTERS.items())
    point = {name: as_term(Fraction(1, 2)) for name in LETTERS}
    return Context(IMPACT, variables, (), point, None, "two particles that collide")


def _impact_lines() -> Iterator[Item]:
    """After it v_0' = v_0 + J omega and v_c' = v_c - J omega with J = (1+r)/2 kappa."""
    new_0, new_c = e_0 + jump * e_omega, e_c - jump * e_omega
    before, after = s_0 + s_c, s_0 + 2 * jump * n_0 + jump**2 + (s_c - 2 * jump * n_c + jump**2)
    for name, claim, says in (
        ("momentum", equal(new_0 + new_c, e_0 + e_c), "v_0' + v_c' = v_0 + v_c"),
        ("restitution", equal((n_c - jump) - (n_0 + jump), -(r * kappa)),
         "(v_c' - v_0')·ω = -r (v_c - v_0)·ω"),
        ("velocity-s", equal(new_c - new_0, (e_c - e_0) - (1 + r) * kappa * e_omega),
         "W_s' = W_c - (1+r)(W_c·ω) ω"),
        ("velocity-c", equal(e_s - new_0, (e_s - e_0) - (1 + r) / 2 * kappa * e_omega),
         "W_c' = W_s - (1+r)/2 (W_c·ω) ω"),
        ("energy", equal(after, before - (1 - r**2) / 2 * kappa**2),
         "|v_0'|² + |v_c'|² = |v_0|² + |v_c|² - (1-r²)/2 ((v_c - v_0)·ω)²"),
    ):  # fmt: skip
        yield Line(f"impact-{name}", claim, identity(), LAW, says)


NAMES = ("u_y", "u_s", "u_C", "u_A", "u_B", "u_d", "u_t")
y, eta_s, C, A, B, d, t = map(symbol, NAMES)


def aligned(y: Term, eta_s: Term, C: Term, A: Term, B: Term, d: Term) -> Frame:
    """The inner products of such vectors."""
    return Frame(y, eta_s, C, y * C, -(eta_s * C), A, B, eta_s * y * C, d)


def plane() -> Context:
    """A cosine, and norms that leave room for the normal parts."""
    values = {name: as_term(1 if name in ("u_A", "u_B") else 0) for name in NAMES}
    givens = (
        Given("u-angle", C**2 <= 1),
        Given("u-room-c", y**2 <= A),
        Given("u-room-s", eta_s**2 <= B),
    )
    variables = tuple(Variable(name, name, name) for name in NAMES)
    return Context(PLANE, variables, givens, values, None, "velocities with orthogonal parts")


def _plane_lines(names: Iterable[str]) -> Iterator[Item]:
    """Each of the inequalities that a state assumes."""
    for name, claim in inequalities(aligned(y, eta_s, C, A, B, d), t, names).items():
        yield Line(f"{PLANE}-{name}", claim, proof(*_squares()[name]))


def _squares() -> dict[str, tuple[Value, ...]]:
    angle, room_c, room_s = "u-angle", "u-room-c", "u-room-s"
    height, reach = square(1 + d - t * y), square(1 + t * eta_s)
    y2, s2, t2 = square(y), square(eta_s), square(t)
    apart = plus(square(1 + (1 + d) * C), times(square(1 + d), angle))
    path = plus(height, times(t2, room_c))
    return {
        "cs-omega": (angle,),
        "cs-s": (room_s,),
        "cs-c": (room_c,),
        "cs-a": (room_c, times(y2, angle)),
        "cs-b": (room_s, times(s2, angle)),
        "cs-w": (times(room_s, plus(room_c, y2)), times(s2, room_c), times(s2, y2, angle)),
        "cs-outer": (room_c, room_s, times(s2, angle)),
        "cs-apart": (times(square(y + (1 + d) * eta_s), angle), times(apart, plus(room_c, room_s))),
        "cs-impact": (
            times(room_s, path),
            times(s2, plus(times(height, angle), times(t2, room_c))),
        ),
        "cs-angle": (
            times(height, reach, angle),
            times(height, t2, room_s),
            times(t2, room_c, reach),
            times(power(t2, 2), room_c, room_s),
        ),
    }


def at_the_point(
    p: Frame, time: Term, names: Iterable[str], givens: tuple[str, str, str]
) -> Iterator[Item]:
    """The inequalities at such velocities; ``givens`` has why the three of this context hold."""
    values = dict(zip(NAMES, (p.y, p.eta_s, p.C, p.A, p.B, p.d, time), strict=True))
    for name, claim in inequalities(p, time, names).items():
        yield Line(f"at-{name}", claim, ByInstance(f"{PLANE}-{name}", values, givens))


def spaces() -> tuple[Opened, ...]:
    """Where both contexts open."""
    return Opened(plane()), Opened(impact())


def chapters(names: Iterable[str]) -> Iterator[Chapter]:
    """The law of collision, and the inequalities of these names."""
    yield Chapter(IMPACT, tuple(_impact_lines()))
    yield Chapter(PLANE, tuple(_plane_lines(names)))
