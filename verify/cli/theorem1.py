"""Decide Theorem 1 at given parameters: constants, every inequality of the proof, verdict."""

from __future__ import annotations

from collections.abc import Iterable

from verify.cli.options import CERTIFICATE, CHOICES, COLOR, JSON, ROWS, Options, Usage, leave_out
from verify.cli.terminal import show
from verify.cli.theorem1_point import DEFAULTS
from verify.language.record import Any
from verify.paper.commands.citing import as_printed
from verify.paper.commands.theorem1 import decide_point
from verify.paper.parameters import SELECTIONS
from verify.paper.source import PAPER
from verify.prover.outcome import Outcome
from verify.spheres.parameters import read_parameters
from verify.views.point import screen
from verify.wire.inputs import InputError, integer

MAX_PRECISION = 1 << 16

#: The bits of the enclosures in an outcome; whoever starts with more sees more digits.
ENCLOSED_BITS = 128


USAGE = Usage(
    {
        "--all": "prove it for all parameters, without --r",
        "--r R": "restitution coefficient in (0, 1) (exact: 0.03, 3/100 or 3e-2), or an interval "
        "A..B",
        "--theta0 ANGLE": "5pi/6, 0.9*pi, 150deg or radians, in (pi/2, pi]",
        "--neg-cos C": "-cos of the angle, in (0, 1] (default 1), or an interval A..B",
        "--delta-theta D": "allowed deviation of the final -cos (default 1/10)",
        "--V0 V": "lower bound of the squared relative speeds (default 1)",
        "--erratum": "print a page of LaTeX: what to replace in the paper, and the rows behind it",
        "--constants SET": "printed, repaired or all (default)",
        "--precision BITS": f"starting bits (default {DEFAULTS['precision']})",
        "--max-precision BITS": f"last bits (default {DEFAULTS['max_precision']})",
        "--steps N": "with --r A..B: that many values of r, one verdict each",
        "--jobs N": "with --steps: processes (default 1)",
        "--csv FILE": "with --steps: a line for each point, with its refuted rows",
        **ROWS,
        **CERTIFICATE,
        "-v, --verbose": "print every row",
        **JSON,
        **COLOR,
    },
    DEFAULTS,
    {**CHOICES, "--constants": (*SELECTIONS,)},
)


def run(options: Options) -> int:
    """Print the table or the document, write the files, return the exit code."""
    if options.erratum:
        return _erratum(options)
    if not options.all and options.r is None:
        raise InputError("--r: is missing; write for example --r 0.03, or --all")
    if options.all or options.steps is not None or ".." in f"{options.r} {options.neg_cos}":
        from verify.cli.many_points import run_many  # loaded only where it is used

        return run_many(options)
    return _point(options)


def _erratum(options: Options) -> int:
    """Print the erratum, which is for all parameters."""
    others = [name for name in vars(options) if name not in ("erratum", "color")]
    leave_out(options, others, "leave it out with --erratum", DEFAULTS)
    from verify.paper.commands.citing import verdicts_as_printed  # loaded only where they are used
    from verify.paper.commands.pages import accepted
    from verify.paper.commands.repaired_theorem import whole
    from verify.views.erratum import erratum

    everywhere, printed = accepted("all_parameters"), accepted("printed_rows")
    print(erratum(everywhere, printed, whole(), verdicts_as_printed(), PAPER), end="")
    return everywhere.exit_code


def _point(options: Options) -> int:
    """Decide Theorem 1 at a point; print, write, return the exit code."""
    why = "has a meaning with --r A..B --steps N only; leave it out"
    leave_out(options, ("csv", "jobs"), why, DEFAULTS)
    parameters = read_parameters(vars(options))
    bits, last = _precisions(options)
    if options.out is not None:
        from verify.cli.files import test_folder  # loaded only where it is used

        test_folder("--out", options.out, "statement.json", "certificate.json")
    table = options.verbose or options.rows is not None
    more = options.out or options.json or table
    outcome = decide_point(parameters, options.constants, bits, last, all_sides=bool(more))
    if not more:
        show(screen(outcome, PAPER, as_printed(outcome)), options)
        return outcome.exit_code
    from verify.cli import claims  # loaded only where it is used

    def whole(outcome: Outcome) -> dict[str, Any]:
        from verify.views.document import document  # loaded only where they are used
        from verify.views.enclosures import sharpened

        shown = sharpened(outcome, bits) if bits > ENCLOSED_BITS else outcome
        return document(shown, as_printed(outcome))

    def text(outcome: Outcome) -> Iterable[str]:
        if not options.verbose or options.rows is not None:
            return screen(outcome, PAPER, as_printed(outcome))
        from verify.views.table import report_lines  # loaded only where it is used

        return report_lines(outcome, PAPER, as_printed(outcome))

    claims.answer(outcome, options, whole, text, has_rows=True)
    return outcome.exit_code


def _precisions(options: Options) -> tuple[int, int]:
    bits = integer("--precision", options.precision, 2, MAX_PRECISION)
    last = integer("--max-precision", options.max_precision, 2, MAX_PRECISION)
    if last < bits:
        raise InputError(
            f"--max-precision: {last} is below --precision {bits}; write at least {bits}"
        )
    return bits, last
