"""No command takes half as much again, against `import flint`, as `ratios.txt` says of it.

    python -m tests.measure.benchmarks.ratios            # exit code 1 if one does
    python -m tests.measure.benchmarks.ratios --write    # writes the figures of this machine down

CPU time of whole processes that take turns, the least of several each.
"""

from __future__ import annotations

import sys
from collections.abc import Mapping
from pathlib import Path

from verify.measure.bench import process_table

FIGURES = Path(__file__).with_name("ratios.txt")
ROUNDS = 9
#: How much more than the figure is too much.
TOLERANCE = 1.5


def committed() -> dict[str, float]:
    """The figures, by the commands."""
    lines = FIGURES.read_text(encoding="utf-8").splitlines()
    return {name: float(figure) for figure, _, name in (line.partition("  ") for line in lines)}


def grown(found: Mapping[str, float], figures: Mapping[str, float]) -> list[str]:
    """A line for each command that takes too much, or that only one of both knows."""
    lines = [f"{name}: not in both" for name in sorted({*found} ^ {*figures})]
    return lines + [
        f"{name}: {found[name]:.2f} times `import flint`, {figures[name]:.2f} in ratios.txt"
        for name in figures
        if found.get(name, 0) > TOLERANCE * figures[name]
    ]


def main(arguments: list[str]) -> int:
    """Measure, and compare or write."""
    found = {
        row[0]: float(row[-1]) for row in process_table(ROUNDS)["rows"] if row[0][:7] == "verify "
    }
    text = "".join(f"{figure:.2f}  {name}\n" for name, figure in found.items())
    if arguments == ["--write"]:
        FIGURES.write_text(text, encoding="utf-8")
        return 0
    lines = grown(found, committed())
    print(text + "\n".join(lines), end="\n" * bool(lines))
    return bool(lines)


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))
