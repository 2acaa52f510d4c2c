"""How likely a verdict is in a family of scenes: random points, each decided exactly."""

from __future__ import annotations

import os
import re
from collections import Counter
from fractions import Fraction
from functools import partial

from verify.cli.files import print_document, read_bytes, write_file
from verify.cli.options import Options, leave_out
from verify.cli.steps import in_order, watched
from verify.cli.terminal import show
from verify.prover.decimals import exact_number
from verify.prover.ground import FLINT
from verify.spheres.scene.decide import COLLAPSES, DISPERSES, FINITE, Budget, decide_scene
from verify.spheres.scene.families import Family, read_family
from verify.spheres.scene.sampling import Drawn, draw, share_between
from verify.spheres.scene.scene import Scene
from verify.spheres.scene.verdict import told
from verify.views.scene_table import COLUMNS, Cells, cells, csv_text, sample_document, sample_lines
from verify.wire.inputs import InputError, integer, rational, share, shown

MAX_SAMPLE, MAX_SEED = 10**6, 2**64


def scene_at(options: Options) -> Scene:
    """The scene of a family that --at names."""
    family = read_family(options.scene, read_bytes("scene", options.scene))
    known = ", ".join(family.sides) or "none"
    values = point_in("--at", options.at, f"each of {known}")
    odd = sorted(values.keys() - family.sides.keys())
    if odd:
        raise InputError(f"--at: {shown(odd[0])}: write NAME=A once for each of {known}")
    missing = sorted(family.sides.keys() - values.keys())
    if missing:
        raise InputError(f"--at: {missing[0]} is missing; write {missing[0]}=A too")
    for name, (low, high) in family.sides.items():
        if not low <= values[name] <= high:
            ends = f"{exact_number(low)}..{exact_number(high)}"
            raise InputError(
                f"--at: {name}={exact_number(values[name])} is not in {ends}, its interval in "
                f"{options.scene}; write a number in it"
            )
    return family.at(values)


def point_in(option: str, text: str, each: str = "each parameter") -> dict[str, Fraction]:
    """The values of parameters: NAME=A,NAME=B.

    Raises:
        InputError: if they are written in another way.
    """
    values: dict[str, Fraction] = {}
    for word in text.split(","):
        name, sign, number = word.partition("=")
        if not sign:
            raise InputError(f"{option}: {shown(word)}: write NAME=A for {each}{_decimal(text)}")
        if name in values:
            raise InputError(f"{option}: {shown(word)}: write NAME=A once for {each}")
        values[name] = rational(option, number)
    return values


def _decimal(text: str) -> str:
    """A remark on a comma between digits, which was probably meant as a decimal point."""
    return ", with a decimal point" if re.search(r"=-?[0-9]+,[0-9]", text) else ""


def run_sample(options: Options, limits: Budget, jobs: int) -> int:
    """Decide random points of a family, and print how many there are of each kind."""
    others = ("plot", "verbose", "trajectory", "out", "at")
    leave_out(options, others, "leave it out with --sample")
    count = integer("--sample", options.sample, 1, MAX_SAMPLE)
    seed = integer("--seed", options.seed, 0, MAX_SEED)
    level = _confidence(options.confidence)
    family = read_family(options.scene, read_bytes("scene", options.scene))
    if not family.sides:
        raise InputError(f"scene: {shown(options.scene)} has no parameters; add [parameters]")
    work = partial(_decide, options.scene, limits)
    found = list(watched(in_order(work, draw(family, count, seed), jobs), count))
    left_out, rows = found[-1][0], [row for _, row in found]
    if options.csv is not None:
        names = (*family.sides, *COLUMNS)
        write_file("--csv", options.csv, csv_text([names, *rows]))
    document = _document(family, rows, seed, left_out, level)
    if options.json:
        print_document(document)
    else:
        show(list(sample_lines(document)), options)
    return 0


def _confidence(text: str) -> Fraction:
    level = share("--confidence", text)
    if not 0 < level < 1:
        raise InputError(f"--confidence: {shown(text)} is not in ]0,1[; write for example 99%")
    return level


def _decide(where: str, limits: Budget, drawn: Drawn) -> tuple[int, Cells]:
    """What is left out up to here, and the line of a table."""
    found = told(decide_scene(drawn.scene, limits))
    row = cells(os.path.basename(where), found, FLINT)
    return drawn.left_out, (*map(str, drawn.values.values()), *row)


def _document(
    family: Family, rows: list[Cells], seed: int, left_out: int, level: Fraction
) -> dict[str, object]:
    """What is found; shares with their intervals."""
    skip = len(family.sides)
    counts = Counter((row[skip + 1], row[skip + 2]) for row in rows)
    kinds = {
        verdict: sum(n for (v, _), n in counts.items() if v == verdict) for verdict, _ in counts
    }
    collapses, ends = kinds.get(COLLAPSES, 0), kinds.get(DISPERSES, 0) + kinds.get(FINITE, 0)
    total, alpha = len(rows), 1 - level
    shares = {
        "infinitely_many": share_between(total, collapses, total - ends, alpha),
        "finitely_many": share_between(total, ends, total - collapses, alpha),
    }
    return sample_document(family.sides, counts, seed, left_out, level, shares)
