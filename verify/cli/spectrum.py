"""Prove the spectral claims of Sections 4.1, 4.2 and 5 for every r; enclose the spectrum at one."""

from __future__ import annotations

from fractions import Fraction

from verify.cli import claims
from verify.cli.files import test_folder
from verify.cli.options import Options, Parser
from verify.paper.commands.spectrum import cite_spectrum
from verify.paper.source import PAPER
from verify.views.row_lists import screen
from verify.views.spectrum import (
    point_document,
    point_lines,
    spectrum_document,
    verdict_line,
)
from verify.wire.inputs import InputError, integer, rational, shown

MAX_PRECISION = 1 << 22


def add_arguments(parser: Parser) -> None:
    """The options; every number is kept as the text that was written."""
    parser.option("--r", "enclose the spectrum at R in ]0,1[, or for all r in A..B")
    parser.option("--precision", "bits of the enclosures (default 128)", "BITS", default="128")
    claims.add_arguments(parser)


def read_r(text: str) -> list[Fraction]:
    """The one number, or the two ends of the interval.

    Raises:
        InputError: for a number outside ]0,1[, an empty or a reversed interval.
    """
    ends = [rational("--r", part) for part in text.split("..", 1)]
    for end in ends:
        if not 0 < end < 1:
            raise InputError(f"--r: {shown(text)} is not in ]0,1[; write for example 0.03")
    if len(ends) == 2 and ends[0] >= ends[1]:
        kind = "empty" if ends[0] == ends[1] else "reversed"
        raise InputError(
            f"--r: the interval {shown(text)} is {kind}; write the smaller end first, as 0.02..0.04"
        )
    return ends


def run(options: Options) -> int:
    """Print the rows or the document, write the files, return the exit code."""
    r = None if options.r is None else read_r(options.r)
    bits = integer("--precision", options.precision, 2, MAX_PRECISION)
    test_folder("--out", options.out, "statement.json", "certificate.json")
    outcome = cite_spectrum()
    document = spectrum_document(outcome)
    text = [*screen("Spectral claims, for every r in ]0,1[", outcome, PAPER)]
    if r is not None:
        from verify.paper.commands import eigenvalues  # loaded only where it is used

        spectrum = eigenvalues.at(r[0], bits) if len(r) == 1 else eigenvalues.over(r[0], r[1], bits)
        document |= point_document(r, spectrum, bits)
        text += point_lines(r, spectrum)
    text += ["", verdict_line(outcome, PAPER)]
    claims.answer(outcome, options, lambda: document, lambda: text)
    return outcome.exit_code
