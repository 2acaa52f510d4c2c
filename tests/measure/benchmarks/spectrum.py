"""Enclose the whole spectrum at 1000 values of r in one process, at 128 bits.

Run ``python tests/measure/benchmarks/spectrum.py``; it prints how many values per second are
enclosed as balls, and how many are also written as decimal texts.
"""

from __future__ import annotations

from collections.abc import Callable
from fractions import Fraction
from statistics import median
from time import process_time

from verify.paper.commands import eigenvalues
from verify.views.spectrum import point_document

BITS = 128
COUNT = 1000
ROUNDS = 5
VALUES = [Fraction(2 * k + 1, 2 * COUNT) for k in range(COUNT)]


def rate(job: Callable[[Fraction], object]) -> float:
    """Values per second, the median of several rounds."""
    times = []
    for _ in range(ROUNDS):
        start = process_time()
        for r in VALUES:
            job(r)
        times.append(process_time() - start)
    return COUNT / median(times)


def main() -> None:
    """Print both rates."""

    def enclose(r: Fraction) -> object:
        return eigenvalues.at(r, BITS)

    def write(r: Fraction) -> object:
        return point_document([r], eigenvalues.at(r, BITS), BITS)

    print(f"enclosed: {rate(enclose):.0f} per second")
    print(f"enclosed and written: {rate(write):.0f} per second")


if __name__ == "__main__":
    main()
