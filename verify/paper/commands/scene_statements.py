"""All statements that the program makes of a scene, from its parameters alone."""

from __future__ import annotations

from collections.abc import Iterator, Mapping

from verify.language.terms import Term
from verify.paper.commands.scene import is_settled_at_start, precisions, scene_outcome
from verify.prover.outcome import Outcome
from verify.prover.program import UndefinedError
from verify.spheres.scene.decide import (
    MAX_COLLISIONS,
    MAX_DIGITS,
    UNDECIDED,
    Budget,
    Fate,
    decide_scene,
)
from verify.spheres.scene.scene import Scene
from verify.spheres.scene.scene_files import is_in_range

#: No more bits are needed for these than without digits.
FEW_DIGITS = 16


def read_back(parameters: Mapping[str, Term]) -> Scene | None:
    """The scene whose parameters these are; None if they are those of no scene that is accepted."""
    count = sum(name.startswith("x.0.") for name in parameters)
    rows = {
        letter: [[f"{letter}.{i}.{k}" for k in range(1, count + 1)] for i in range(3)]
        for letter in ("x", "v")
    }
    names = {"r", *(name for table in rows.values() for row in table for name in row)}
    numbers = all(term.op == "rational" for term in parameters.values())
    if count < 1 or {*parameters} != names or not numbers:
        return None
    positions, velocities = (
        tuple(tuple(parameters[name].value for name in row) for row in rows[letter])
        for letter in ("x", "v")
    )
    scene = Scene(parameters["r"].value, positions, velocities)
    return scene if is_in_range(scene) else None


def statements_of(scene: Scene, collisions: int) -> Iterator[Outcome]:
    """What the program makes of a scene with so many rows about collisions.

    It depends on the number of digits, and of collisions, that were asked for.
    """
    for limits in _budgets(collisions):
        found = decide_scene(scene, limits)
        told = 0 if is_settled_at_start(found) else len(found.flow.collisions)
        if found.verdict != UNDECIDED and told == collisions:
            yield _evaluable(found)


def _budgets(collisions: int) -> Iterator[Budget]:
    """What may have been asked for.

    Whoever asks for digits is told of a collapse what shows it after the last collision that was
    followed; so it does not matter how many digits these were, but for the bits that they need.
    """
    yield Budget(max(MAX_COLLISIONS, collisions + 1))
    yield Budget(collisions)
    yield Budget(collisions, FEW_DIGITS)
    yield Budget(collisions, MAX_DIGITS)


def _evaluable(found: Fate) -> Outcome:
    """The outcome with the fewest bits that suffice to evaluate its numbers."""
    *few, last = precisions(found)
    for bits in few:
        try:
            return scene_outcome(found, bits)
        except UndefinedError:
            continue
    return scene_outcome(found, last)
