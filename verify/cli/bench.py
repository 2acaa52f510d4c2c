"""Measure speed against error; times are medians, errors are exact."""

from __future__ import annotations

from verify.cli import columns
from verify.cli.files import test_folder
from verify.cli.options import Options, Usage
from verify.cli.steps import Steps

USAGE = Usage({**columns.OPTIONS, "--out DIR": "write bench.json there"})


def run(options: Options) -> int:
    """Measure, print the tables, and return 0."""
    test_folder("--out", options.out, "bench.json")
    from verify.measure import bench  # loads mpmath

    columns.publish("bench", bench.run_benchmarks(options.quick, Steps(bench.STEPS)), options)
    return 0
