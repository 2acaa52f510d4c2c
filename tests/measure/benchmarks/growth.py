"""How the time of a job grows with its size: the table of `docs/explanation/speed.md`.

    python -m tests.measure.benchmarks.growth            # prints the table, a line for each job
    python -m tests.measure.benchmarks.growth --write    # and writes it into growth.json

CPU time in one process, the least of a few rounds in which all sizes of a job take turns. The
exponent is the slope of log(time) over log(size), fitted to the larger half of the sizes: the
constant part of a job, such as reading its input, flattens the smaller ones.
"""

from __future__ import annotations

import io
import json
import math
import sys
from collections.abc import Callable, Sequence
from contextlib import redirect_stdout
from fractions import Fraction
from functools import partial
from pathlib import Path
from time import process_time
from typing import Any, NamedTuple

from verify import cli
from verify.language.statement import PROVED
from verify.language.terms import Claim, Term, as_term, symbol
from verify.library import ask, for_all, lemma, prove
from verify.measure.bench import parameters, theorem_program
from verify.measure.engines import ArbEngine, load
from verify.measure.scenes import ordinary
from verify.paper.commands.theorem1 import decide_point
from verify.spheres.scene.decide import Budget, decide_scene

FIGURES = Path(__file__).with_name("growth.json")
ROUNDS = 3
COLUMNS = ("what grows", "job", "sizes", "CPU ms", "exponent", "what limits it")


class Growth(NamedTuple):
    """A job of a size: what is varied, what is done, and what limits larger sizes."""

    varied: str
    job: str
    sizes: tuple[int, ...]
    prepare: Callable[[int], Callable[[], object]]
    limit: str

    @property
    def ends(self) -> str:
        """The least and the largest size, in words."""
        return f"{self.sizes[0]} to {self.sizes[-1]}"


def proved(claims: Sequence[Claim], variables: int, low: int | None = None) -> Callable[[], object]:
    """To prove claims about variables, which are at least ``low``, and to check the proof."""
    names = [f"x{i}" for i in range(variables)]
    givens = {} if low is None else {f"low{name}": low <= symbol(name) for name in names}
    place = for_all("all", givens, dict.fromkeys(names, low or 0))
    asked = lemma("growth", [ask(f"row{i}", c, place) for i, c in enumerate(claims)], (), [place])

    def work() -> None:
        found = prove(asked, work=10**9)
        if any(decision.verdict != PROVED for decision in found.decisions.values()):
            raise RuntimeError("a row of a known truth is not proved")

    return work


def total(terms: Sequence[Term]) -> Term:
    """A sum whose depth is the logarithm of its length."""
    half = len(terms) // 2
    return terms[0] if half == 0 else total(terms[:half]) + total(terms[half:])


def rows(n: int) -> Callable[[], object]:
    """So many rows that have nothing to do with each other."""
    x = symbol("x0")
    return proved([2 * (i + 1) * x <= x**2 + (i + 1) ** 2 for i in range(n)], 1)


def form(n: int) -> Callable[[], object]:
    """One quadratic form in so many variables, with a term for each pair."""
    names = [symbol(f"x{i}") for i in range(n)]
    squares = [n * x**2 for x in names]
    products = [2 * names[i] * names[j] for i in range(n) for j in range(i)]
    return proved([as_term(0) <= total([*squares, *products])], n)


def bernoulli(n: int) -> Callable[[], object]:
    """One polynomial of this degree on a half-line."""
    x = symbol("x0")
    return proved([1 + n * x <= (1 + x) ** n], 1, 0)


def bits(n: int) -> Callable[[], object]:
    """All constants of Theorem 1 and both sides of its rows, with so many bits."""
    engine = ArbEngine()
    program, _ = theorem_program(decide_point(parameters("3/100", "1")))

    def work() -> None:
        with engine.at(n):
            load(program, engine).run(())

    return work


def near(n: int) -> Callable[[], object]:
    """Theorem 1 where r is below 9 - 4 sqrt 5 by 10^-n."""
    r = 9 - Fraction(math.isqrt(80 * 10 ** (2 * n)) + 1, 10**n)
    return partial(decide_point, parameters(str(r), "1"), all_sides=False)


def commanded(*words: str) -> Callable[[], object]:
    """A command, whose text is thrown away."""

    def work() -> None:
        with redirect_stdout(io.StringIO()):
            cli.main(words)

    return work


def undecided(n: int) -> Callable[[], object]:
    """A map of the plane, until 1/n of it is undecided."""
    return commanded("map", "phi", "--r", "0.03", "--undecided", f"{100 / n:.6f}%")


def collisions(n: int) -> Callable[[], object]:
    """A collapse whose time is asked for to n digits: 1.2 collisions are followed for each."""
    return partial(decide_scene, ordinary(Fraction(3, 100)), Budget(digits=n))


JOBS = (
    Growth(
        "rows",
        "`prove`, rows of one context",
        (10, 20, 40, 80, 160),
        rows,
        "each row is decided and written for itself, and finds what is known among those before it",
    ),
    Growth(
        "variables",
        "`prove`, a quadratic form",
        (6, 9, 13, 19, 28),
        form,
        "n(n+1)/2 terms, and n squares of up to n terms, which the checker expands: at most cubic",
    ),
    Growth(
        "degree",
        "`prove`, (1+x)ⁿ ≥ 1 + nx for x ≥ 0",
        (16, 32, 64, 128, 256),
        bernoulli,
        "the expansion of the claim in exact numbers, here and in the checker",
    ),
    Growth(
        "collisions (1.2 for each digit of the time)",
        "`scene`, a collapse",
        (12, 24, 48, 96, 192),
        collisions,
        "each collision is a few dozen operations on balls, whose bits grow with the digits",
    ),
    Growth(
        "1/undecided share",
        "`map phi`",
        (10, 20, 40, 80, 160),
        undecided,
        "what stays undecided lies along curves: half the share takes twice the boxes",
    ),
    Growth(
        "bits",
        "`theorem1`, all enclosures",
        (1 << 12, 1 << 13, 1 << 14, 1 << 15, 1 << 16),
        bits,
        "FLINT's multiplication of long numbers; below some 1000 bits Python is all of the time",
    ),
    Growth(
        "digits of 1/(9-4√5-r)",
        "`theorem1`, next to a threshold",
        (250, 500, 1000, 2000, 4000),
        near,
        "3.3 bits are needed for each digit, and tried from 128 on in doubled steps",
    ),
)


def slope(sizes: Sequence[int], seconds: Sequence[float]) -> float:
    """The exponent that fits the larger half of the sizes best."""
    half = len(sizes) // 2
    points = [(math.log(n), math.log(t)) for n, t in zip(sizes[half:], seconds[half:], strict=True)]
    x, y = (sum(values) / len(points) for values in zip(*points, strict=True))
    return sum((a - x) * (b - y) for a, b in points) / sum((a - x) ** 2 for a, _ in points)


def measured(growth: Growth, rounds: int) -> list[float]:
    """The least seconds for each size."""
    jobs = [growth.prepare(size) for size in growth.sizes]
    least = [math.inf] * len(jobs)
    for _ in range(rounds):
        for i, job in enumerate(jobs):
            start = process_time()
            job()
            least[i] = min(least[i], process_time() - start)
    return least


def table(rounds: int) -> dict[str, Any]:
    """The table, with the columns that the page shows."""
    found = []
    for growth in JOBS:
        seconds = measured(growth, rounds)
        times = f"{1000 * seconds[0]:.3g} to {1000 * seconds[-1]:.3g}"
        exponent = f"{slope(growth.sizes, seconds):.1f}"
        found.append([growth.varied, growth.job, growth.ends, times, exponent, growth.limit])
        print(" | ".join(found[-1]), flush=True)
    return {"columns": list(COLUMNS), "rows": found}


def main(arguments: list[str]) -> int:
    """Measure, print, and write."""
    made = table(ROUNDS)
    if arguments == ["--write"]:
        text = json.dumps(made, ensure_ascii=False, indent=1)
        FIGURES.write_text(f"{text}\n", encoding="utf-8")
    return 0


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))
