"""Measure speed against error; times are medians, errors are exact."""

from __future__ import annotations

from verify.cli import columns
from verify.cli.files import test_folder
from verify.cli.options import Options, Parser
from verify.cli.steps import Steps


def add_arguments(parser: Parser) -> None:
    """The options."""
    columns.add_arguments(parser, "bench")


def run(options: Options) -> int:
    """Measure, print the tables, and return 0."""
    from verify.measure import bench  # loads mpmath

    test_folder("--out", options.out, "bench.json")
    columns.publish("bench", bench.run_benchmarks(options.quick, Steps(bench.STEPS)), options)
    return 0
