"""A box across a grazing state is followed in both branches."""

from __future__ import annotations

from fractions import Fraction

import numpy as np

from verify import check_map
from verify.spheres.flow.law import State
from verify.spheres.map.boxes import INTERVALS, MODELS, sides
from verify.spheres.map.branches import advance
from verify.spheres.map.log import plane_document
from verify.spheres.map.planes import Phi, start

ACROSS = Phi(
    Fraction(3, 100),
    Fraction(1),
    x=(Fraction(1, 20), Fraction(3, 50)),
    y=(Fraction(49, 100), Fraction(51, 100)),
)


def test_some_states_meet_and_some_end() -> None:
    for kind in (INTERVALS, MODELS):
        with np.errstate(all="ignore"):
            x, y = map(kind.parameter, (0, 1), sides(ACROSS, ["0"]))
            found = start(ACROSS, x, y, kind.number, lambda z: z.root())
            state = State(*(z if isinstance(z, int) else kind.spread(z, 1) for z in found))
            step = advance(kind.number(ACROSS.r), state)
        assert step.ends.all()
        assert not step.unclear.any()
        assert [places.tolist() for places, _ in step.states] == [[0]]


def test_the_checker_follows_both_too() -> None:
    plane = check_map.plane_of(plane_document(ACROSS))
    for kind in (check_map.INTERVALS, check_map.MODELS):
        law = check_map.law_of(plane.r, kind)
        may_end, states = check_map.after(law, check_map.beginning(law, plane)("0")[0])
        assert may_end
        assert len(states) == 1
