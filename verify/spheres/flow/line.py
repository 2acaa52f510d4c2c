"""Three spheres on a line: the ratio of two speeds is all, and loses no digits.

While the middle sphere o meets s and c in turn, let q be the speed at which it parts from the one
that it just met, in units of the speed at which it approaches the other. On a line a pair that
approaches meets, and the outer two never do. The next collision leaves the speeds r and b - q in
the same unit, where b is (1+r)/(1 + m_o/m) for the mass m of the other: so another one follows
just if q < b, with r/(b - q). For equal masses b is (1+r)/2.
"""

from __future__ import annotations

from collections.abc import Sequence
from fractions import Fraction

from verify.language.record import Record
from verify.prover import balls
from verify.spheres.flow.follow import Flow
from verify.spheres.flow.law import EQUAL, recentred
from verify.spheres.scene.scene import Scene, difference


class LineRun(Record):
    """How many collisions there are, if that is certain, and whether they repeat for ever."""

    collisions: int
    ends: bool
    repeats: bool = False


def is_on_a_line(scene: Scene) -> bool:
    """Whether all relative positions and velocities are multiples of one vector."""
    both = (scene.positions, scene.velocities)
    vectors = [difference(rows, 0, i) for rows in both for i in (1, 2)]
    first = vectors[0]
    return all(_parallel(first, other) for other in vectors[1:])


def _parallel(x: Sequence[Fraction], z: Sequence[Fraction]) -> bool:
    k = next(i for i, value in enumerate(x) if value)
    return all(a * z[k] == b * x[k] for a, b in zip(x, z, strict=True))


def follow_line(flow: Flow, most: int) -> LineRun | None:
    """All collisions of a scene on a line; None where balls do not show how often it goes on.

    The first collision is that of the flow; from then on the sphere in the middle is looked at.
    """
    if not flow.collisions or not is_on_a_line(flow.scene):
        return None
    first = flow.collisions[0].after
    state, (o, s, c) = first.state, first.frame
    if state.C < 0:
        state, (o, s, c) = recentred(state, sizes=flow.sizes(first.frame)), (s, o, c)
    if not state.C > 0:
        return None
    if state.lam <= 0:
        return LineRun(1, ends=True)
    if not state.lam > 0:
        return None
    sizes = flow.sizes((o, s, c))
    restitutions = [balls.fmpq_of(flow.scene.restitution(o, i)) for i in (c, s)]
    both = zip(restitutions, (sizes, flow.sizes((o, c, s))), strict=True)
    shares = [(1 + r) / of.ratio for r, of in both]
    reach = balls.any_root(sizes.c + state.eps * state.v**2)
    near = 1 if sizes is EQUAL else balls.any_root(sizes.s)
    q, before, count = state.rho / state.lam * reach / near, None, 1
    while count < most:
        count += 1
        rest = shares[count % 2] - q
        if rest <= 0:
            return LineRun(count, ends=True)
        if not rest > 0:
            return None
        new = balls.shortened(restitutions[count % 2] / rest, flow.bits)
        if balls.is_same(new, before):
            return LineRun(count, ends=False, repeats=True)
        q, before = new, q
    return LineRun(count, ends=False)
