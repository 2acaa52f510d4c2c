"""A scene of many balls: follow it, say what ended the run, write its tables and the three."""

from __future__ import annotations

import os
from fractions import Fraction
from typing import Any

from verify.cli.files import CERTIFICATE, print_document, test_folder, write_all, write_file
from verify.cli.options import Options, leave_out
from verify.cli.scene_certificate import write_scene
from verify.cli.steps import watched
from verify.cli.terminal import FIXED, show
from verify.prover.decimals import exact_number
from verify.spheres.many.decide import Ending, decide_system
from verify.spheres.many.system_file import system_from
from verify.spheres.scene.decide import COLLAPSES, Budget, decide_scene
from verify.spheres.scene.scene_files import read_scene
from verify.spheres.scene.verdict import shown_ends
from verify.views.many import (
    event_rows,
    exit_code,
    many_document,
    many_lines,
    origin_lines,
    scene_text,
)
from verify.views.scene_table import csv_text

#: The file with the three that collapse, and the folder beside it with its certificate.
FILE, FOLDER = "three.toml", "three"
TITLE_DIGITS = 30


def run_many(
    options: Options, table: dict[str, Any], limits: Budget, until: Fraction | None
) -> int:
    """Print what ended the run, write what is asked for, return the exit code."""
    others = ("digits", "cutoff", "at", "plot", "trajectory")
    leave_out(options, others, "it is for a scene of three particles; leave it out")
    system = system_from(options.scene, table)
    test_folder("--out", options.out, FILE)
    if options.out is not None:
        test_folder("--out", os.path.join(options.out, FOLDER), *sorted(CERTIFICATE))
    found = decide_system(system, limits, until, watched)
    if options.csv is not None:
        write_file("--csv", options.csv, csv_text(event_rows(found)))
    certificate, why = None, ""
    if options.out is not None:
        certificate, why = _write_three(options.out, found, limits)
    if options.json:
        print_document(many_document(found, certificate))
        return exit_code(found)
    lines = []
    if options.verbose:
        lines += [" ".join(row).replace(" ", FIXED) for row in event_rows(found)]
    show([*lines, *many_lines(found, shown_ends), *origin_lines(found, why)], options)
    return exit_code(found)


def _write_three(out: str, found: Ending, limits: Budget) -> tuple[str | None, str]:
    """The folder with the certificate of the three, and what is told of it."""
    if found.verdict != COLLAPSES:
        return None, "no certificate: no three balls collapse"
    if found.wall is not None:
        return None, "no certificate: of a ball at a wall there is none yet"
    if found.scene is None or found.since is None:
        return None, "no certificate: no decimals near the three collapse in the same way"
    time = exact_number(found.since, TITLE_DIGITS)
    names = "{}, {} and {}".format(*found.members)
    title = f"balls {names} at {time}, seen from the first"
    content = scene_text(found.scene, title[:80]).encode()
    path, folder = os.path.join(out, FILE), os.path.join(out, FOLDER)
    fate = decide_scene(read_scene(path, content), limits)
    missing = write_scene("--out", folder, fate)
    write_all("--out", out, {FILE: content})
    if missing:
        return None, f"{path} has the three; no certificate: {missing}"
    return folder, (
        f"certified: the balls {names}, as decimals in {path}, collapse; the certificate is in "
        f"{folder}"
    )
