"""Theorem 1 at many points: for all parameters, on a box of them, or on a grid."""

from __future__ import annotations

import sys
from collections.abc import Iterable, Iterator
from fractions import Fraction
from itertools import chain

from verify.cli import claims
from verify.cli.files import print_document, test_folder, write_file
from verify.cli.options import Options, chosen, leave_out
from verify.cli.terminal import show
from verify.cli.theorem1_point import DEFAULTS, POINT_OPTIONS
from verify.language.record import TYPE_CHECKING
from verify.language.statement import REFUTED, UNDECIDED
from verify.paper.parameters import PRINTED
from verify.paper.source import PAPER
from verify.prover.decimals import exact_number
from verify.prover.outcome import EXIT_CODES, Outcome, conjunction
from verify.spheres.parameters import neg_cos, read_parameters, restitution
from verify.wire.inputs import InputError, integer, interval, positive

if TYPE_CHECKING:
    from typing import Any

    from verify.views.findings import ScannedPoint

#: So many points of a grid are given to a process at a time.
TOGETHER = 50
#: What stands for an angle where there are many points.
OF_MANY = "is for one point; write --neg-cos, the number -cos of it"


def run_many(options: Options) -> int:
    """Print, write the files, return the exit code."""
    if options.all:
        return _everywhere(options)
    return _box(options) if options.steps is None else _scan(options)


def _everywhere(options: Options) -> int:
    """Prove Theorem 1 for all parameters; print, write, return the exit code."""
    others = ("r", "neg_cos", "V0", "delta_theta", "steps", "csv", "jobs")
    leave_out(options, (*POINT_OPTIONS, *others), "leave it out with --all", DEFAULTS)
    test_folder("--out", options.out, "statement.json", "certificate.json")
    from verify.paper.commands import (  # loaded only where they are used
        pages,
        thresholds,
    )
    from verify.paper.commands.citing import verdicts_as_printed
    from verify.views import all_parameters as view
    from verify.views.document import claims_document

    printed = options.constants == PRINTED
    outcome = pages.accepted("printed_rows" if printed else "all_parameters")
    argument = conjunction(outcome.decisions.values())
    verdicts = verdicts_as_printed()

    def document(outcome: Outcome) -> dict[str, Any]:
        found = claims_document(outcome, "theorem1", view.FORMAT)
        return found | ({"sets": {"printed": {"verdict": argument, **verdicts}}} if printed else {})

    def screen(outcome: Outcome) -> Iterable[str]:
        if printed:
            where = pages.accepted("thresholds")
            shares = thresholds.all_shares(where)
            return view.printed_screen(outcome, where, shares, PAPER, verdicts)
        from verify.paper.commands.repaired_theorem import whole
        from verify.paper.parameters import AS_PRINTED
        from verify.views.all_parameters import constants_and_set
        from verify.wire.judge import packaged

        as_printed = packaged(AS_PRINTED)
        return view.screen(outcome, PAPER, verdicts, as_printed, constants_and_set(whole()))

    claims.answer(outcome, options, document, screen)
    return EXIT_CODES[argument]


def _box(options: Options) -> int:
    """Prove Theorem 1 at all points of a box; print, write, return the exit code."""
    others = (*POINT_OPTIONS, "constants", "jobs")
    leave_out(options, ("theta0",), OF_MANY)
    leave_out(options, ("csv",), "a table is of points; add --steps N")
    leave_out(options, others, "leave it out with A..B", DEFAULTS)
    r = interval("--r", options.r, restitution, points=True)
    c = interval("--neg-cos", chosen(options.neg_cos, "1"), neg_cos, points=True)
    v_0 = positive("--V0", options.V0)
    delta_theta = positive("--delta-theta", options.delta_theta)
    test_folder("--out", options.out, "statement.json", "certificate.json")
    from verify.paper.commands import box  # loaded only where they are used
    from verify.views import box as view
    from verify.views.findings import ParameterBox

    found = box.answer(ParameterBox(r, c), v_0, delta_theta)
    if options.out is not None and found.verdict == UNDECIDED:
        print("verify: no certificate was written; ask for the certified part", file=sys.stderr)
        options.out = None
    claims.answer(
        found.outcome,
        options,
        lambda _: view.box_document(found, found.outcome.assumptions),
        lambda _: view.screen(found, PAPER),
    )
    return EXIT_CODES[found.verdict]


def _noted(
    points: Iterable[tuple[Fraction, ScannedPoint]], rows: list[tuple[str, str, str]]
) -> Iterator[tuple[Fraction, ScannedPoint]]:
    """The points; each leaves a row: r, its verdict, and which rows of the paper are refuted."""
    for r, point in points:
        refuted = (name for name, verdict in point.rows.items() if verdict == REFUTED)
        rows.append((exact_number(r), point.verdict, " ".join(refuted)))
        yield r, point


def _scan(options: Options) -> int:
    """Print the verdict at many values of r; the exit code is that of the worst."""
    from verify.cli.steps import MAX_JOBS, in_order, watched  # loaded only where they are used
    from verify.paper.commands.scan import Grid
    from verify.views.box import range_lines, ranges, ranges_document, verdict_of
    from verify.views.scene_table import csv_text

    if ".." not in options.r:
        raise InputError("--steps: needs an interval of r; write --r 0.02..0.04 --steps 9")
    others = (*POINT_OPTIONS, "out", "constants", "verbose", "rows")
    leave_out(options, ("theta0",), OF_MANY)
    leave_out(options, others, "leave it out with --steps", DEFAULTS)
    ends = interval("--r", options.r, restitution)
    steps = integer("--steps", options.steps, 2, 10**7)
    options.r = options.r.split("..", 1)[0]
    jobs = integer("--jobs", options.jobs, 1, MAX_JOBS)
    values = {name: term.value for name, term in read_parameters(vars(options)).items()}
    grid = Grid(*ends, steps, values)
    parts = in_order(grid.part, grid.parts(1 if jobs == 1 else TOGETHER), jobs)
    rows: list[tuple[str, str, str]] = []
    points = watched(chain.from_iterable(parts), steps)
    found = list(ranges(points if options.csv is None else _noted(points, rows)))
    if options.csv is not None:
        write_file("--csv", options.csv, csv_text([("r", "verdict", "refuted"), *rows]))
    if options.json:
        print_document(ranges_document(found))
    else:
        show(range_lines(found), options)
    return EXIT_CODES[verdict_of(found)]
