"""Speed against error of verdicts on scenes, and against a plain simulation with mpmath."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from fractions import Fraction
from functools import partial
from pathlib import Path
from tempfile import TemporaryDirectory
from typing import Any

from verify.measure import Table, table, timed
from verify.measure.simulation import simulate
from verify.spheres.scene.decide import COLLAPSES, Budget, decide_scene
from verify.spheres.scene.scene import Scene
from verify.spheres.scene.scene_files import read_scene
from verify.spheres.scene.verdict import time_ends

#: The precision of the comparison with a simulation, in bits and in decimal digits.
BITS, DIGITS = 128, 38
#: Digits of a number that are lost, at most, on the way to the time of a collapse.
LOST = 6

FILE = """r = "{r}"
positions = [["0", "0"], ["1.002", "0"], ["-1.006", "0.08"]]
velocities = [["0", "0"], ["-1.4", "0"], ["0.7", "-0.1"]]
"""


def ordinary(r: Fraction) -> Scene:
    """One particle nearly between two others that run into it."""
    return read_scene("ordinary", FILE.format(r=r).encode())


def precision_rows(precisions: Sequence[int], rounds: int) -> list[list[Any]]:
    """For each precision: bits, collisions, milliseconds, and the width of the collapse time."""
    scene, rows = ordinary(Fraction(3, 100)), []
    for bits in precisions:
        digits = max(3, bits * 3 // 10 - LOST)
        budget = Budget(digits=digits, bits=bits, max_bits=bits)
        seconds, found = timed(partial(decide_scene, scene, budget), rounds + 1)
        low, high = time_ends(found) or (Fraction(0), Fraction(1))
        width = f"{float((high - low) / high):.1e}"
        rows.append([bits, found.collisions, f"{1000 * seconds:.2f}", width])
    return rows


def simulation_rows(rounds: int) -> list[list[Any]]:
    """For some scenes: the verdict, milliseconds of it and of the simulation, and their ratio."""
    rows: list[list[Any]] = []
    for r, digits in (("3/100", None), ("3/100", 6), ("3/100", 12), ("3/10", None)):
        scene, budget = ordinary(Fraction(r)), Budget(digits=digits)
        decide = partial(decide_scene, scene, budget)
        found = decide()
        # Until nothing meets any more; a collapse would go on for ever.
        most = found.collisions + (found.verdict != COLLAPSES)
        turns: list[Callable[[], Any]] = [decide, partial(simulate, scene, most, DIGITS)]
        pairs = [[timed(work)[0] for work in turns] for _ in range(rounds + 1)]
        ours, plain = map(min, zip(*pairs, strict=True))
        name = f"r = {r}" + ("" if digits is None else f", {digits} digits")
        cells = [f"{1000 * seconds:.2f}" for seconds in (ours, plain)]
        rows.append([name, found.verdict, found.collisions, *cells, f"{ours / plain:.2f}"])
    return rows


def process_ratio(cpu: Callable[[list[str]], float], rounds: int) -> float:
    """CPU of a whole process that decides a scene, over that of one that imports flint.

    ``cpu`` measures Python with some words after it.
    """
    with TemporaryDirectory() as folder:
        path = Path(folder) / "scene.toml"
        path.write_text(FILE.format(r="3/100"), encoding="utf-8")
        turns = ["-m", "verify", "scene", str(path)], ["-c", "import flint"]
        pairs = [[cpu(list(words)) for words in turns] for _ in range(rounds)]
    return min(scene for scene, _ in pairs) / min(flint for _, flint in pairs)


def scene_tables(
    precisions: Sequence[int], rounds: int, cpu: Callable[[list[str]], float]
) -> dict[str, Table]:
    """Time and width against precision; time against a simulation; a whole process."""
    ratio = process_ratio(cpu, rounds)
    precision = "A scene: time and relative width of the collapse time against precision"
    simulation = (
        f"Verdicts on scenes at {BITS} bits against a plain simulation with mpmath; a "
        f"whole process is {ratio:.2f} times one that imports flint"
    )
    columns = ["scene", "verdict", "collisions", "ms", "simulation ms", "ratio"]
    rows = precision_rows(precisions, rounds)
    return {
        "scene_precision": table(precision, ["bits", "collisions", "ms", "width"], rows),
        "scene_simulation": table(simulation, columns, simulation_rows(rounds)),
    }
