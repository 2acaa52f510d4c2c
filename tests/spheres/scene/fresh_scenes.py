"""Three thousand random scenes of sixteen kinds against a simulation: a table.

    python -m tests.spheres.scene.fresh_scenes [SEED [SCENES OF EACH KIND]]

Kinds, seed and budget are fixed before a run; exact events (three at once, a graze) are answers.
"""

from __future__ import annotations

import sys
from collections import Counter
from random import Random

from tests.spheres.scene.agreement import contradictions
from tests.spheres.scene.kinds import KINDS, random_scene_of
from verify.language.record import Record
from verify.spheres.scene.decide import EXACT, UNDECIDED, Budget, Fate, decide_scene

SEED, SCENES = 2027, 188
BUDGET = Budget()
#: Digits of the simulation: 1600 bits, and more for each collision, as errors grow.
DIGITS, MORE_DIGITS = 482, 4


class Seen(Record):
    """What was found of the scenes of a kind."""

    kind: str
    verdicts: Counter[str]
    exact: int
    undecided: tuple[int, ...]
    contradictions: tuple[str, ...]


def look(kind: str, seed: int = SEED, count: int = SCENES) -> Seen:
    """Decide so many scenes of a kind, and simulate each."""
    rng, verdicts, exact = Random(f"{kind} {seed}"), Counter[str](), 0
    undecided, wrong = [], []
    for number in range(count):
        found = decide_scene(random_scene_of(kind, rng), BUDGET)
        verdicts[f"{found.verdict} {found.name}"] += 1
        exact += found.why in EXACT
        if found.verdict == UNDECIDED and found.why not in EXACT:
            undecided.append(number)
        wrong += [f"{kind} {number}: {words}" for words in contradictions(found, digits_for(found))]
    return Seen(kind, verdicts, exact, tuple(undecided), tuple(wrong))


def digits_for(found: Fate) -> int:
    """How many digits the simulation has."""
    return DIGITS + MORE_DIGITS * found.collisions


def main(seed: int = SEED, count: int = SCENES) -> None:
    """Print a line for each kind, and the sums."""
    total, exact, undecided, wrong = 0, 0, 0, 0
    for kind in KINDS:
        seen = look(kind, seed, count)
        total, exact = total + count, exact + seen.exact
        undecided, wrong = undecided + len(seen.undecided), wrong + len(seen.contradictions)
        print(f"{kind:20} {dict(seen.verdicts)} undecided {seen.undecided}", flush=True)
        for line in seen.contradictions:
            print(f"  {line}", flush=True)
    print(f"{total} scenes: {wrong} contradictions, {undecided} undecided, {exact} exact events")


if __name__ == "__main__":
    main(*map(int, sys.argv[1:]))
