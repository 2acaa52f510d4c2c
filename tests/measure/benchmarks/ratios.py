"""No command takes half as much again, against `import flint`, as `ratios.txt` says of it.

Nor does a scene's certificate, against its verdict, in a folder of scenes.

    python -m tests.measure.benchmarks.ratios            # exit code 1 if one does
    python -m tests.measure.benchmarks.ratios --write    # writes the figures of this machine down

CPU time of whole processes that take turns, the least of several each; of scenes in one process, in
which each kind was decided before, so that what is done once is not counted.
"""

from __future__ import annotations

import gc
import os
import sys
from collections.abc import Mapping
from pathlib import Path
from random import Random
from tempfile import TemporaryDirectory

from tests.spheres.scene.kinds import KINDS, random_scene_of
from verify.cli.scene_folder import decide_file
from verify.measure.bench import process_table
from verify.spheres.scene.decide import Budget
from verify.spheres.scene.scene import Scene

FIGURES = Path(__file__).with_name("ratios.txt")
ROUNDS = 9
#: How much more than the figure is too much.
TOLERANCE = 1.5
#: A certificate of a scene against its verdict, with so many scenes of each kind.
CERTIFICATE, EACH = "verify scene FOLDER --out DIR, against verify scene FOLDER", 8


def committed() -> dict[str, float]:
    """The figures, by the commands."""
    lines = FIGURES.read_text(encoding="utf-8").splitlines()
    return {name: float(figure) for figure, _, name in (line.partition("  ") for line in lines)}


def grown(
    found: Mapping[str, float], figures: Mapping[str, float], most: float = TOLERANCE
) -> list[str]:
    """A line for each command that takes more than so many times its figure, or has none."""
    lines = [f"{name}: not in both" for name in sorted({*found} ^ {*figures})]
    return lines + [
        f"{name}: {found[name] / figures[name]:.2f} times what was written down"
        for name in figures
        if found.get(name, 0) > most * figures[name]
    ]


def scene_text(scene: Scene) -> str:
    """The file of a scene."""
    rows = ([[str(x) for x in row] for row in rows] for rows in (scene.positions, scene.velocities))
    return 'r = "{}"\npositions = {}\nvelocities = {}\n'.format(scene.r, *rows)


def certificate_ratio(rounds: int, each: int) -> float:
    """What a scene costs with a certificate, in times of what its verdict costs, for all kinds."""
    with TemporaryDirectory() as folder:
        names = []
        for kind in KINDS:
            rng = Random(kind)
            for number in range(each):
                names.append(f"{kind}-{number}.toml")
                text = scene_text(random_scene_of(kind, rng))
                Path(folder, names[-1]).write_text(text, encoding="utf-8")
        gc.disable()  # as the command does
        pairs = [
            (_seconds(folder, None, names), _seconds(folder, f"{folder}/out-{i}", names))
            for i in range(rounds + 1)
        ]
        gc.enable()
    verdict, certificate = map(min, zip(*pairs[1:], strict=True))
    return certificate / verdict


def _seconds(folder: str, out: str | None, names: list[str]) -> float:
    """What all scenes take, with certificates if there is a folder for them.

    What the system does is left out: to make a file costs ten times more on some than on others.
    """
    start = os.times().user
    for name in names:
        if decide_file(folder, out, Budget(), out is not None, name)["code"] not in (0, 3):
            raise ValueError(f"{name} fails")
    return os.times().user - start


def main(arguments: list[str]) -> int:
    """Measure, and compare or write."""
    found = {
        row[0]: float(row[-1]) for row in process_table(ROUNDS)["rows"] if row[0][:7] == "verify "
    }
    found[CERTIFICATE] = certificate_ratio(ROUNDS, EACH)
    text = "".join(f"{figure:.2f}  {name}\n" for name, figure in found.items())
    if arguments == ["--write"]:
        FIGURES.write_text(text, encoding="utf-8")
        return 0
    lines = grown(found, committed())
    print(text + "\n".join(lines), end="\n" * bool(lines))
    return bool(lines)


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))
