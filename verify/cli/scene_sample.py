"""Points of a family of scenes, random or evenly spaced: each is decided exactly."""

from __future__ import annotations

import os
import re
from collections import Counter
from collections.abc import Mapping
from fractions import Fraction
from functools import partial
from itertools import product
from math import prod
from typing import Any

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
from verify.spheres.scene.scene_files import OverlapError
from verify.spheres.scene.verdict import told
from verify.views.scene import exit_code
from verify.views.scene_table import (
    COLUMNS,
    Cells,
    cells,
    counts_of,
    csv_text,
    parameter_cells,
    parameter_heads,
    sample_document,
    sample_lines,
    unusable_cells,
)
from verify.wire.inputs import InputError, integer, interval, nearest, rational, share, shown

MAX_SAMPLE, MAX_SEED = 10**6, 2**64
#: The verdict where particles overlap.
UNUSABLE = "unusable"


def scene_at(options: Options) -> tuple[Scene, Mapping[str, Fraction]]:
    """The scene of a family that --at names, and its parameters."""
    family = family_of(options, whole=True)
    return family.at({}), family.fixed


def family_of(options: Options, *, whole: bool = False) -> Family:
    """The family in the file, in which the parameters that --at names have these values.

    ``whole`` means that it has to name all of them.
    """
    family = read_family(options.scene, read_bytes("scene", options.scene))
    if options.at is None:
        return family
    known = _parameters("--at", family)
    values = point_in("--at", options.at, f"each of {known}")
    odd = sorted(values.keys() - family.sides.keys())
    if odd:
        instead = nearest(odd[0], family.sides, f"write NAME=A once for each of {known}")
        raise InputError(f"--at: {shown(odd[0])} has no interval in the file; {instead}")
    missing = sorted(family.sides.keys() - values.keys())
    if whole and missing:
        raise InputError(f"--at: {missing[0]} is missing; write {missing[0]}=A too")
    for name, value in values.items():
        family.test_inside("--at", name, value)
    sides = {name: side for name, side in family.sides.items() if name not in values}
    return family._replace(sides=sides, fixed=dict(sorted(values.items())))


def _parameters(option: str, family: Family) -> str:
    """The names of the parameters that have no value yet; an error if there are none."""
    if not family.sides:
        raise InputError(
            f"{option}: {family.where} has no parameter without a value; write an interval there, "
            'like r = "0.02..0.06", or others below [parameters]'
        )
    return ", ".join(family.sides)


def point_in(option: str, text: str, each: str = "each parameter") -> dict[str, Fraction]:
    """The values of parameters: NAME=A,NAME=B.

    Raises:
        InputError: if they are written in another way.
    """
    values: dict[str, Fraction] = {}
    meant = _meant_point(text)
    if meant:
        raise InputError(f"{option}: {shown(text)} is not NAME=A for {each}; write {meant}")
    for word in text.split(","):
        name, sign, number = word.partition("=")
        if not sign:
            raise InputError(f"{option}: {shown(word)}: write NAME=A for {each}")
        if name in values:
            raise InputError(f"{option}: {shown(word)}: write NAME=A once for {each}")
        values[name] = rational(option, number)
    return values


def _meant_point(text: str) -> str:
    """The point that is meant by ``r=0,02`` or ``{r: 0.02; h = 0}``; nothing if it is one."""
    mended = re.sub(r"\s+|^[{([]|[])}]$", "", text).replace(";", ",")
    mended = re.sub(r"(?<=[A-Za-z0-9_])(?::=?|==)(?=[-+.0-9])", "=", mended)
    mended = re.sub(r"(=[-+]?[0-9]+),([0-9]+)(?=,|$)", r"\1.\2", mended)
    one = r"[A-Za-z][A-Za-z0-9_]*=[^,=]+"
    return mended if mended != text and re.fullmatch(rf"{one}(,{one})*", mended) else ""


def run_sample(options: Options, limits: Budget, jobs: int) -> int:
    """Decide random points of a family, and print how many there are of each kind."""
    others = ("verbose", "trajectory", "out", "grid")
    leave_out(options, others, "leave it out with --sample")
    if options.plot is not None and not options.plot.endswith(".svg"):
        raise InputError(
            f"--plot: {shown(options.plot)}: a sample is drawn as .svg; write FILE.svg"
        )
    count = integer("--sample", options.sample, 1, MAX_SAMPLE)
    seed = integer("--seed", options.seed, 0, MAX_SEED)
    level = share("--confidence", options.confidence, inside=True)
    family = family_of(options)
    if not family.sides and not family.fixed:
        raise InputError(f"scene: {shown(options.scene)} has no parameters; add [parameters]")
    if not family.sides:
        raise InputError("--sample: --at names all parameters; leave out one of the two")
    work = partial(_decide, options.scene, family.fixed, limits)
    found = list(watched(in_order(work, draw(family, count, seed), jobs), count))
    left_out, rows = found[-1][0], [row for _, row in found]
    if options.csv is not None:
        write_file("--csv", options.csv, csv_text([(*_heads(family), *COLUMNS), *rows]))
    document = _document(family, rows, seed, left_out, level)
    if options.plot is not None:
        from verify.cli.drawable import drawable  # loaded only where they are used
        from verify.views.plots.distributions import sample_svg

        skip = len(_heads(family))
        named = [dict(zip(COLUMNS, row[skip:], strict=True)) for row in rows]
        with drawable():
            drawing = sample_svg(document, named, limits.digits)
        write_file("--plot", options.plot, drawing)
    if options.json:
        print_document(document)
    else:
        show(list(sample_lines(document)), options)
    return 0


def _decide(
    where: str, fixed: Mapping[str, Fraction], limits: Budget, drawn: Drawn
) -> tuple[int, Cells]:
    """How many draws were left out before a scene, and its line of the table."""
    found = told(decide_scene(drawn.scene, limits))
    row = cells(os.path.basename(where), found, FLINT)
    return drawn.left_out, (*parameter_cells({**fixed, **drawn.values}), *row)


def _heads(family: Family) -> Cells:
    """The heads of the columns for parameters."""
    return parameter_heads({**family.fixed, **family.sides})


def _document(
    family: Family, rows: list[Cells], seed: int, left_out: int, level: Fraction
) -> dict[str, Any]:
    """What is found; shares with their intervals."""
    skip = len(_heads(family))
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
    sides = {name: (value, value) for name, value in family.fixed.items()} | dict(family.sides)
    return sample_document(dict(sorted(sides.items())), counts, seed, left_out, level, shares)


# --- evenly spaced points ------------------------------------------------------------------------


def run_grid(options: Options, limits: Budget, jobs: int) -> int:
    """Decide evenly spaced points of a family; the exit code is that of the worst."""
    others = ("plot", "verbose", "trajectory", "out", "json")
    leave_out(options, others, "leave it out with --grid")
    family = family_of(options)
    axes = _axes(options.grid, family)
    missing = sorted(family.sides.keys() - axes.keys())
    if missing:
        raise InputError(f"--grid: {missing[0]} has no value; add --at {missing[0]}=A")
    points = (dict(zip(axes, values, strict=True)) for values in product(*axes.values()))
    work = partial(_decide_point, family, limits)
    count, rows, codes = prod(map(len, axes.values())), [], []
    for code, lines, row in watched(in_order(work, points, jobs), count, apart=True):
        codes.append(code)
        rows.append(row)
        if options.csv is None:
            show([" ".join(lines)], options, records=True)
    if options.csv is not None:
        heads = parameter_heads({**family.fixed, **family.sides})
        write_file("--csv", options.csv, csv_text([(*heads, *COLUMNS), *rows]))
        show(counts_of([row[len(heads) :] for row in rows]), options)
    return max(codes)


def _axes(text: str, family: Family) -> dict[str, list[Fraction]]:
    """The values of each parameter that is named: NAME=A..B:N is N of them, from A to B."""
    axes: dict[str, list[Fraction]] = {}
    known = _parameters("--grid", family)
    meant = re.sub(r"([0-9]),([0-9])", r"\1.\2", text)
    if meant != text:
        raise InputError(f"--grid: {shown(text)} has a decimal comma; write {meant}")
    for word in text.split(","):
        name, _, rest = word.partition("=")
        ends, sign, steps = rest.partition(":")
        if not sign or name in axes or name not in family.sides:
            some = f"{word}:5 for 5 values" if not sign and ".." in rest else "NAME=A..B:N"
            raise InputError(f"--grid: {shown(word)}: write {some}, once for some of {known}")
        low, high = interval("--grid", ends, partial(rational, "--grid"))
        for end in (low, high):
            family.test_inside("--grid", name, end)
        count = integer("--grid", steps, 2, MAX_SAMPLE)
        axes[name] = [low + (high - low) * Fraction(i, count - 1) for i in range(count)]
    if prod(map(len, axes.values())) > MAX_SAMPLE:
        raise InputError(f"--grid: these are more than {MAX_SAMPLE} points; write smaller numbers")
    return axes


def _decide_point(
    family: Family, limits: Budget, point: Mapping[str, Fraction]
) -> tuple[int, list[str], Cells]:
    """The exit code of a point, the words about it, and the line of a table."""
    values, name = {**family.fixed, **point}, os.path.basename(family.where)
    here = ",".join(f"{key}={exact_number(value)}" for key, value in point.items())
    try:
        found = told(decide_scene(family.at(point), limits))
    except OverlapError:
        row = unusable_cells(name, UNUSABLE)
        return 0, [f"{here}: particles overlap"], (*parameter_cells(values), *row)
    row = cells(name, found, FLINT)
    labels = found.scene.labels  # the title and the unit of length are the same at all points
    lines = found.lines[bool(labels.title) : len(found.lines) - bool(labels.length_unit)]
    return exit_code(found), [f"{here}:", *lines], (*parameter_cells(values), *row)
