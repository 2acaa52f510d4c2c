"""A step that is repeated at many boxes, against a loop at each of them."""

from __future__ import annotations

import numpy as np
import pytest

from verify.spheres.map.trees import chosen_of, repeated


@pytest.mark.parametrize("most", [1, 3, 40])
def test_a_step_is_repeated_at_each_box_until_it_ends(most: int) -> None:
    """x is halved until it is below 1, in at most twelve rounds; then it has ended."""
    start = 2.0 ** np.arange(-2, 18)
    fixed, state = np.full(20, 0.25), (start, np.zeros(20))

    def step(fixed, state):
        x, count = state[0] / 2 + fixed, state[1] + 1
        return (x, count), x < 1, ~(x < 1) & (count < 12)

    for chosen in (np.arange(1, 20), np.arange(4, 8), np.flatnonzero(start > 100)):
        (x, count), ended = repeated(step, most, *chosen_of((fixed, state), chosen))
        for place, box in enumerate(chosen):
            value, rounds = start[box] / 2 + 0.25, 1
            while value >= 1 and rounds < min(most, 12):
                value, rounds = value / 2 + 0.25, rounds + 1
            assert ended[place] == (value < 1)
            assert not ended[place] or (x[place], count[place]) == (value, rounds)
