"""Enclose the separatrix of the limit map, the curve between collapse and the end of collisions.

The state just after a collision is a pair: q (the paper's φ₁) is the speed with which the pair that
collided recedes, divided by the one with which the next pair approaches; u stands for the distance
of the next pair. Below the curve u = f(q) collisions go on for ever, above it they end.
"""

from __future__ import annotations

import os
import sys
from fractions import Fraction

from verify.cli import claims
from verify.cli.files import print_document, test_folder, write_certificate, write_file
from verify.cli.options import (
    CERTIFICATE,
    COLOR,
    JSON,
    ROWS,
    VERBOSE,
    Options,
    Usage,
    chosen,
    leave_out,
)
from verify.cli.terminal import show
from verify.spheres.limit_map import Parameters
from verify.spheres.parameters import neg_cos, restitution, three_positive
from verify.spheres.separatrix import DRAWN_DIGITS, Separatrix, decide_separatrix, staircase
from verify.views.separatrix import (
    curves_document,
    curves_screen,
    screen,
    separatrix_document,
    theorem_document,
    theorem_screen,
)
from verify.wire.inputs import InputError, integer, interval, positive, rational, shown

MAX_DIGITS, MAX_BUDGET, MAX_STEPS = 1000, 10**8, 50
#: At how many places each of several curves is decided for a picture.
FEW_CORNERS = 60
#: What only some of the three uses have.
WITH_R = (
    "--r",
    "--neg-cos",
    "--ratio",
    "--masses",
    "--radii",
    "--at",
    "--digits",
    "--budget",
    "--steps",
    "--plot",
)
DEFAULTS = {
    "neg_cos": "1",
    "ratio": "1",
    "balls": "1,1,1",
    "digits": "12",
    "budget": "2000000",
    "steps": "5",
}
#: Of several curves.
CURVE_DIGITS = "8"


USAGE = Usage(
    {
        "--all": "prove the theorem on the limit map for all parameters",
        "--r R": "restitution coefficient in (0, 1) (exact: 0.03, 3/100 or 3e-2), or A..B",
        "--neg-cos C": "-cos of the angle, in (0, 1] (default 1)",
        "--ratio RATIO": "|W|² of the pair that collided, over the next one's (default 1)",
        "--masses M,M,M": "of the middle ball, the one that collided, the next (default 1,1,1)",
        "--radii R,R,R": "of the same balls (default 1,1,1)",
        "--at Q": "enclose f at this q only (default: a table)",
        "--digits N": "how many digits of f (default 12)",
        "--budget N": "follow at most so many collisions (default 2000000)",
        "--steps N": "with --r A..B: that many values of r (default 5)",
        "--plot FILE": "draw the certified strip, or with --r A..B the curves: a file .svg",
        **{name: f"with --all: {says}" for name, says in {**VERBOSE, **ROWS}.items()},
        **JSON,
        **COLOR,
        **CERTIFICATE,
    }
)


def run(options: Options) -> int:
    """Print what is asked for, write the files, return the exit code."""
    if options.all:
        return _theorem(options)
    leave_out(options, ("rows", "verbose"), "has a meaning with --all only; leave it out")
    if options.r is None:
        raise InputError("--r: is missing; write for example --r 0.03, or --all")
    _test_plot(options)
    return _curves(options) if ".." in options.r else _point(options)


def _theorem(options: Options) -> int:
    """The theorem for all parameters."""
    leave_out(options, WITH_R, "leave it out with --all")
    from verify.paper.commands.pages import accepted  # loaded only where they are used
    from verify.paper.source import PAPER

    test_folder("--out", options.out, "statement.json", "certificate.json")
    outcome = accepted("separatrix")
    document, text = theorem_document, theorem_screen
    claims.answer(outcome, options, document, lambda outcome: text(outcome, PAPER))
    return outcome.exit_code


def _point(options: Options) -> int:
    """F at one q, or a table of it."""
    parameters = _parameters(options, restitution(options.r))
    at = _at(options)
    leave_out(options, ("steps",), "has a meaning with --r A..B only; leave it out")
    digits, budget = _digits(options), _budget(options)
    test_folder("--out", options.out, "statement.json", "certificate.json")
    found = decide_separatrix(parameters, at, digits, budget)
    certified = "" if options.out is None else _certify(options.out, found)
    if options.plot is not None:
        from verify.cli.drawable import drawable  # loaded only where they are used
        from verify.views.plots.separatrix import strip_svg

        drawn = found if at is None else decide_separatrix(parameters, None, DRAWN_DIGITS, budget)
        strips = staircase(drawn, budget)
        if not strips:
            raise InputError("--plot: no curve is known there; choose parameters that have one")
        with drawable():
            drawing = strip_svg(drawn, strips)
        write_file("--plot", options.plot, drawing)
    if options.json:
        print_document(separatrix_document(found, certified))
    else:
        show(screen(found, certified), options)
    return found.exit_code


def _curves(options: Options) -> int:
    """How f moves with r."""
    leave_out(options, ("at", "out"), "takes a single r; write for example --r 0.03")
    count = integer("--steps", chosen(options.steps, DEFAULTS["steps"]), 2, MAX_STEPS)
    digits, budget = _digits(options, CURVE_DIGITS), _budget(options)
    points = [_parameters(options, r) for r in _values(options.r, count)]
    found = [decide_separatrix(point, None, digits, budget) for point in points]
    if options.plot is not None:
        from verify.cli.drawable import drawable  # loaded only where they are used
        from verify.views.plots.separatrix import curves_svg

        strips = [staircase(one, budget, FEW_CORNERS) for one in found]
        if not any(strips):
            raise InputError("--plot: no curve is known there; choose smaller values of --r")
        with drawable():
            drawing = curves_svg(list(zip(found, strips, strict=True)))
        write_file("--plot", options.plot, drawing)
    if options.json:
        print_document(curves_document(found))
    else:
        show(curves_screen(found), options)
    return max(one.exit_code for one in found)


# --- what was written -----------------------------------------------------------------------------


def _parameters(options: Options, r: Fraction) -> Parameters:
    c, ratio = (
        chosen(options.neg_cos, DEFAULTS["neg_cos"]),
        chosen(options.ratio, DEFAULTS["ratio"]),
    )
    given = {"--masses": options.masses, "--radii": options.radii}
    balls = (three_positive(name, chosen(text, DEFAULTS["balls"])) for name, text in given.items())
    return Parameters(r, neg_cos(c), positive("--ratio", ratio), *balls)


def _at(options: Options) -> Fraction | None:
    at = None if options.at is None else rational("--at", options.at)
    if at is not None and at < 0:
        raise InputError(f"--at: {shown(options.at)} is negative; write for example 1/10")
    if at is None and options.out is not None:
        raise InputError("--out: certifies f at one q; write for example --at 1/10, or --all")
    return at


def _digits(options: Options, otherwise: str = DEFAULTS["digits"]) -> int:
    return integer("--digits", chosen(options.digits, otherwise), 1, MAX_DIGITS)


def _budget(options: Options) -> int:
    return integer("--budget", chosen(options.budget, DEFAULTS["budget"]), 1, MAX_BUDGET)


def _values(text: str, count: int) -> list[Fraction]:
    """So many values of r from one end of the interval to the other."""
    low, high = interval("--r", text, restitution)
    return [low + (high - low) * Fraction(k, count - 1) for k in range(count)]


# --- what is written ------------------------------------------------------------------------------


def _certify(folder: str, found: Separatrix) -> str:
    """Write the certificate of f at one q, or say why there is none; return what it says."""
    from verify.paper.commands.separatrix import (  # loads the rows
        TooLongError,
        decide_value,
        point_of,
    )

    point = point_of(found)
    if point is None:
        print("verify: f is undecided; no certificate was written", file=sys.stderr)
        return ""
    try:
        outcome = decide_value(point)
    except TooLongError:
        why = "the orbits next to f are too long for the checker"
        what = "ask for fewer --digits, and write --r and the other numbers with fewer"
        print(f"verify: no certificate was written: {why}; {what}", file=sys.stderr)
        return ""
    write_certificate("--out", folder, outcome)
    return outcome.statement.title


def _test_plot(options: Options) -> None:
    if options.plot is None:
        return
    if os.path.splitext(options.plot)[1] != ".svg":
        raise InputError(f"--plot: {shown(options.plot)} does not end in .svg; write such a name")
    folder, name = os.path.split(options.plot)
    test_folder("--plot", folder or os.curdir, name)
