"""Decide what becomes of three given particles: collapses, disperses, finite, or undecided."""

from __future__ import annotations

import sys

from verify.cli.files import print_document, read_bytes
from verify.cli.options import Options, Parser
from verify.jobs.inputs import integer
from verify.jobs.scene_files import read_scene
from verify.prover.scene import Budget, Found, decide
from verify.views.scene import exit_code, scene_document, scene_lines, table


def add_arguments(parser: Parser) -> None:
    """The options."""
    parser.place("scene", "a scene file, or a folder of them")
    parser.option("--digits", "digits of the collapse time and of the final angle", "N")
    parser.option("--collisions", "how many are followed (default 1000)", "N", default="1000")
    parser.option("--precision", "bits to begin with (default 128)", "BITS", default="128")
    parser.option("--max-precision", "last bits (default 4096)", "BITS", default="4096")
    parser.flag("-v", "--verbose", text="a table of the collisions")
    parser.flag("--json", text="one JSON document on stdout")


def budget(options: Options) -> Budget:
    """How far scenes are followed."""
    digits = None if options.digits is None else integer("--digits", options.digits, 1, 200)
    bits = integer("--precision", options.precision, 8, 1 << 16)
    last = integer("--max-precision", options.max_precision, 8, 1 << 16)
    return Budget(integer("--collisions", options.collisions, 0, 10**7), digits, bits, last)


def run(options: Options) -> int:
    """Print the verdict, write what is asked for, return the exit code."""
    limits = budget(options)
    scene = read_scene(options.scene, read_bytes("scene", options.scene))
    found = decide(scene, limits)
    if options.json:
        print_document(scene_document(found))
    else:
        sys.stdout.write("".join(f"{line}\n" for line in _text(found, options)))
    return exit_code(found)


def _text(found: Found, options: Options) -> list[str]:
    lines = [*scene_lines(found)]
    return [*table(found), "", *lines] if options.verbose else lines
