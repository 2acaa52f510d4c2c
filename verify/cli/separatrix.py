"""Enclose the separatrix of the limit map, the curve between collapse and the end of collisions.

The state just after a collision is a pair: q (the paper's φ₁) is the speed with which the pair that
collided recedes, divided by the one with which the next pair approaches; u stands for the distance
of the next pair. Below the curve u = f(q) collisions go on for ever, above it they end.
"""

from __future__ import annotations

from verify.cli.files import print_document
from verify.cli.options import Options, Parser
from verify.cli.terminal import add_color, show
from verify.spheres.limit_map import Parameters
from verify.spheres.separatrix import decide_separatrix
from verify.views.separatrix import screen, separatrix_document
from verify.wire.inputs import InputError, integer, neg_cos, positive, rational, restitution, shown

MAX_DIGITS, MAX_BUDGET = 1000, 10**8


def add_arguments(parser: Parser) -> None:
    """The options; every number is kept as the text that was written."""
    texts = {
        "--r": ("R", "restitution coefficient in ]0,1[ (exact: 0.03, 3/100 or 3e-2)", None),
        "--neg-cos": ("C", "-cos of the angle, in ]0, 1] (default 1)", "1"),
        "--ratio": (
            "RATIO",
            "|W|² of the pair that collided, over the next one's (default 1)",
            "1",
        ),
        "--at": ("Q", "enclose f at this q only (default: a table)", None),
        "--digits": ("N", "how many digits of f (default 12)", "12"),
        "--budget": ("N", "follow at most so many collisions (default 2000000)", "2000000"),
    }
    for name, (value, text, default) in texts.items():
        parser.option(name, text, value, default=default)
    parser.flag("--json", text="one JSON document on stdout")
    add_color(parser)


def run(options: Options) -> int:
    """Print the table or the document, return the exit code."""
    if options.r is None:
        raise InputError("--r: is missing; write for example --r 0.03")
    parameters = Parameters(
        restitution(options.r), neg_cos(options.neg_cos), positive("--ratio", options.ratio)
    )
    at = None if options.at is None else rational("--at", options.at)
    if at is not None and at < 0:
        raise InputError(f"--at: {shown(options.at)} is negative; write for example 1/10")
    digits = integer("--digits", options.digits, 1, MAX_DIGITS)
    budget = integer("--budget", options.budget, 1, MAX_BUDGET)
    found = decide_separatrix(parameters, at, digits, budget)
    if options.json:
        print_document(separatrix_document(found))
    else:
        show(screen(found), options)
    return found.exit_code
