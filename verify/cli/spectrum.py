"""Prove the spectral claims of Sections 4.1, 4.2 and 5 for every r; enclose the spectrum at one."""

from __future__ import annotations

from fractions import Fraction

from verify.cli import claims
from verify.cli.files import test_folder
from verify.cli.options import Options, Usage
from verify.paper.commands.spectrum import cite_spectrum
from verify.paper.source import PAPER
from verify.spheres.parameters import restitution
from verify.views.row_lists import screen
from verify.views.spectrum import point_document, point_lines, spectrum_document, verdict_line
from verify.wire.inputs import integer, interval

MAX_PRECISION = 1 << 22


USAGE = Usage(
    {
        "--r R": "enclose the spectrum at R in (0, 1), or for all r in A..B",
        "--precision BITS": "bits of the enclosures (default 128)",
        **claims.OPTIONS,
    },
    {"precision": "128"},
)


def run(options: Options) -> int:
    """Print the rows or the document, write the files, return the exit code."""
    r = None if options.r is None else _ends(options.r)
    bits = integer("--precision", options.precision, 2, MAX_PRECISION)
    test_folder("--out", options.out, "statement.json", "certificate.json")
    outcome = cite_spectrum()
    document = spectrum_document(outcome)
    found: list[str] = []
    if r is not None:
        from verify.paper.commands import eigenvalues  # loaded only where it is used

        spectrum = eigenvalues.at(r[0], bits) if len(r) == 1 else eigenvalues.over(r[0], r[1], bits)
        document |= point_document(r, spectrum, bits)
        found += point_lines(r, spectrum)
    text = [*screen("Spectral claims, for every r in (0, 1)", outcome, PAPER, found)]
    text += ["", verdict_line(outcome, PAPER)]
    claims.answer(outcome, options, lambda _: document, lambda _: text)
    return outcome.exit_code


def _ends(text: str) -> list[Fraction]:
    """The one number, or the two ends of the interval."""
    return [*interval("--r", text, restitution)] if ".." in text else [restitution(text)]
