"""How the time of a job grows with its size: the table of docs/explanation/speed.md.

Run ``python -m tests.measure.benchmarks.growth``. For each job it prints the CPU seconds at several
sizes, each the least of some runs, and the slope between the last two sizes on logarithmic scales.
"""

from __future__ import annotations

from collections.abc import Callable, Iterator
from contextlib import redirect_stdout
from fractions import Fraction
from functools import reduce
from io import StringIO
from itertools import pairwise
from math import isqrt, log
from operator import add
from time import process_time
from typing import Any, NamedTuple

import verify
from verify import check
from verify.cli import main
from verify.language.terms import as_term
from verify.paper.commands.theorem1 import decide_point
from verify.spheres.scene.decide import Budget, decide_scene
from verify.spheres.scene.scene_files import read_scene

#: What is measured takes so many seconds at least, and at most so many runs.
SECONDS, RUNS = 0.2, 20

LINE = """r = "{r}"
positions = [["0"], ["2"], ["-5/2"]]
velocities = [["0"], ["-1"], ["1"]]
"""


class Job(NamedTuple):
    """Work of several sizes; ``prepare`` gives what is measured, ``limit`` is what limits it."""

    name: str
    limit: str
    sizes: tuple[int, ...]
    prepare: Callable[[int], Callable[[], Any]]


def page(rows: int) -> Any:
    """So many polynomial claims about one variable."""
    x = verify.symbol("x")
    real = verify.for_all("real", [], point={"x": 0})
    questions = [
        verify.ask(f"row-{k}", 0 < x**2 - 2 * k * x + k * k + 1, real) for k in range(1, rows + 1)
    ]
    return verify.lemma("A page", questions, contexts=[real])


def chain(variables: int) -> Any:
    """From a chain of inequalities that the first one is less than the last one."""
    names = [verify.symbol(f"x{k}") for k in range(variables)]
    givens = [a < b for a, b in pairwise(names)]
    context = verify.for_all("chain", givens, point={f"x{k}": k for k in range(variables)})
    claim = names[0] < names[-1]
    return verify.lemma("A chain", [verify.ask("ends", claim, context)], contexts=[context])


def form(variables: int) -> Any:
    """A positive quadratic form."""
    names = [verify.symbol(f"x{k}") for k in range(variables)]
    total = reduce(add, names)
    squares = reduce(add, (x**2 for x in names))
    context = verify.for_all("all", [], point={f"x{k}": 0 for k in range(variables)})
    claim = total**2 <= variables * squares
    return verify.lemma("A form", [verify.ask("form", claim, context)], contexts=[context])


def power(degree: int) -> Any:
    """Bernoulli's inequality on an interval."""
    x = verify.symbol("x")
    context = verify.for_all("interval", [0 <= x, x <= 2], point={"x": 1})
    claim = degree * x <= x**degree + degree - 1
    return verify.lemma("A power", [verify.ask("power", claim, context)], contexts=[context])


def proving(statement: Callable[[int], Any]) -> Callable[[int], Callable[[], Any]]:
    """The search for a proof of all rows."""

    def prepare(size: int) -> Callable[[], Any]:
        found = statement(size)

        def work() -> None:
            assert verify.prove(found, seconds=60).verdict == "proved"

        return work

    return prepare


def checking(statement: Callable[[int], Any]) -> Callable[[int], Callable[[], Any]]:
    """The check of the certificate."""

    def prepare(size: int) -> Callable[[], Any]:
        files = verify.certificate(verify.prove(statement(size), seconds=60))
        return lambda: check.check(files["statement.json"], files["certificate.json"], {})

    return prepare


def at_bits(bits: int) -> Callable[[], Any]:
    """All constants and rows of Theorem 1 at r = 3/100."""
    parameters = _parameters(Fraction(3, 100))
    return lambda: decide_point(parameters, "all", bits, bits)


def near_threshold(digits: int) -> Callable[[], Any]:
    """Theorem 1 at a number r that many digits below 9 - 4 sqrt 5."""
    scale = 10 ** (digits + 2)
    parameters = _parameters(Fraction(9 * scale - isqrt(80 * scale * scale) - 100, scale))
    return lambda: decide_point(parameters)


def _parameters(r: Fraction) -> dict[str, Any]:
    values = {"r": r, "c": Fraction(1), "V_0": Fraction(1), "delta_theta": Fraction(1, 10)}
    return {name: as_term(value) for name, value in values.items()}


def on_a_line(distance: int) -> Callable[[], Any]:
    """Balls on a line, with r above 7 - 4 sqrt 3 by one over a number; they part in the end."""
    scale = 10**30
    r = Fraction(7 * scale - isqrt(48 * scale * scale) + scale // distance, scale)
    scene = read_scene("line", LINE.format(r=r).encode())
    return lambda: decide_scene(scene, Budget())


def covering(parts: int) -> Callable[[], Any]:
    """A map at r = 3/100 until one of so many parts of its area is left undecided."""
    words = ["map", "phi", "--r", "3/100", "--undecided", str(Fraction(100, parts)) + "%"]

    def work() -> None:
        with redirect_stdout(StringIO()):
            main(words)

    return work


JOBS = (
    Job(
        "rows of a page, proved",
        "each row may use the rows before it",
        (25, 50, 100),
        proving(page),
    ),
    Job(
        "rows of a page, checked", "reading and summing, row by row", (25, 50, 100), checking(page)
    ),
    Job(
        "links of a chain, proved",
        "one linear programme in exact arithmetic",
        (8, 16, 32),
        proving(chain),
    ),
    Job(
        "variables of a quadratic form, proved",
        "the n² entries of one square matrix",
        (4, 8, 16),
        proving(form),
    ),
    Job(
        "degree on an interval, proved",
        "the coefficients on each part, and the parts",
        (8, 16, 32),
        proving(power),
    ),
    Job(
        "bits of a point run",
        "multiplication in FLINT; below 16 000 bits all that does not depend on bits",
        (4096, 16384, 65536),
        at_bits,
    ),
    Job(
        "digits from the threshold 9-4√5",
        "rational bounds that lie closer and closer, in the search and in the check",
        (50, 200, 800),
        near_threshold,
    ),
    Job(
        "1 over the undecided share of a map",
        "a border is a curve: half the share, twice the boxes",
        (50, 100, 200),
        covering,
    ),
    Job(
        "collisions on a line",
        "setting up; a collision itself costs some microseconds",
        (10**3, 10**5, 10**6),
        on_a_line,
    ),
)


def seconds(work: Callable[[], Any]) -> float:
    """The CPU time of the fastest run."""
    times: list[float] = []
    while not times or (sum(times) < SECONDS and len(times) < RUNS):
        start = process_time()
        work()
        times.append(process_time() - start)
    return min(times)


def lines() -> Iterator[str]:
    """The table in Markdown."""
    yield "| what grows | sizes | CPU time | slope | what limits it |"
    yield "|---|---|---|---|---|"
    for job in JOBS:
        sizes: list[int] = []
        times = []
        for size in job.sizes:
            work = job.prepare(size)
            times.append(seconds(work))
            found = work() if job.prepare is on_a_line else None
            sizes.append(size if found is None else found.collisions)
        slope = log(times[-1] / times[-2]) / log(sizes[-1] / sizes[-2])
        ms = ", ".join(f"{1000 * t:.3g}" for t in times)
        yield f"| {job.name} | {', '.join(map(str, sizes))} | {ms} ms | {slope:.1f} | {job.limit} |"


if __name__ == "__main__":
    for line in lines():
        print(line, flush=True)
