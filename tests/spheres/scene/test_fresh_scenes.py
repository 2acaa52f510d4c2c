"""Three thousand random scenes of sixteen kinds: no contradiction, and hardly one undecided."""

from __future__ import annotations

from random import Random

import pytest

from tests.spheres.scene.agreement import contradictions
from tests.spheres.scene.fresh_scenes import SCENES, digits_for, look
from tests.spheres.scene.kinds import KINDS, KINDS_ON_A_LINE, random_scene_of
from verify.spheres.flow.line import is_on_a_line
from verify.spheres.scene.decide import COLLAPSES, DISPERSES, decide_scene

#: At most 1 % of a kind.
MOST_UNDECIDED = SCENES // 100


@pytest.mark.parametrize("kind", KINDS)
def test_three_thousand_scenes(kind: str) -> None:
    seen = look(kind)
    assert seen.verdicts.total() == SCENES
    assert seen.contradictions == ()
    assert len(seen.undecided) <= (0 if kind in KINDS_ON_A_LINE else MOST_UNDECIDED)


@pytest.mark.parametrize("kind", KINDS_ON_A_LINE)
def test_the_kinds_on_a_line_are_on_a_line(kind: str) -> None:
    rng = Random(kind)
    assert all(is_on_a_line(random_scene_of(kind, rng)) for _ in range(20))


def test_a_false_verdict_contradicts_the_simulation() -> None:
    rng = Random(1)
    found = decide_scene(random_scene_of("nearly-aligned", rng))
    assert found.verdict == COLLAPSES
    digits = digits_for(found)
    assert contradictions(found, digits) == []
    assert contradictions(found._replace(verdict=DISPERSES, collapse=None), digits)
