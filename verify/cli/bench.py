"""Measure speed against error; times are medians, errors are exact."""

from __future__ import annotations

from verify.cli import columns
from verify.cli.files import test_folder
from verify.cli.options import Options, Usage
from verify.cli.steps import Steps

USAGE = Usage(
    {
        **columns.OPTIONS,
        "--out DIR": "write bench.json there",
        "--peers": "only the table of Z3 and cvc5 on public sets",
    }
)


def run(options: Options) -> int:
    """Measure, print the tables, and return 0."""
    test_folder("--out", options.out, "bench.json")
    if options.peers:
        from verify.measure.peers import peers_table  # loads what decides statements

        columns.publish("bench", {"peers": peers_table(options.quick)}, options)
        return 0
    from verify.measure import bench  # loads mpmath

    columns.publish("bench", bench.run_benchmarks(options.quick, Steps(bench.STEPS)), options)
    return 0
