"""Prove which collapses there are: no triangular one, the least final angle, finite or not."""

from __future__ import annotations

from verify.cli import claims
from verify.cli.files import test_folder
from verify.cli.options import Options, Usage
from verify.paper.commands.classification import (
    at_masses,
    at_restitution,
    on_a_line,
    verdict_at,
)
from verify.paper.commands.pages import accepted
from verify.paper.meaning import MEANING
from verify.paper.source import PAPER
from verify.prover.outcome import EXIT_CODES
from verify.spheres.parameters import restitution, three_positive
from verify.views.classification import (
    classification_document,
    line_document,
    line_lines,
    masses_document,
    masses_lines,
    meaning_lines,
    restitution_document,
    restitution_lines,
    theorem_lines,
)
from verify.views.row_lists import screen

USAGE = Usage(
    {
        "--r R": "what the theorems say at R in (0, 1] (exact: 0.08, 2/25 or 8e-2)",
        "--masses M,M,M": "what is possible for these masses, at R or by r",
        **claims.OPTIONS,
    }
)


def run(options: Options) -> int:
    """Print the theorems or the document, write the files, return the exit code."""
    r = None if options.r is None else restitution(options.r, elastic=True)
    masses = None if options.masses is None else three_positive("--masses", options.masses)
    test_folder("--out", options.out, "statement.json", "certificate.json")
    outcome = accepted("classification")
    found = None if r is None else at_restitution(r)
    verdict = verdict_at(outcome, found)
    document = classification_document(outcome)
    asked: list[str] = []
    if found is not None:
        if not found.excluded or masses is not None:
            accepted("alexander")
        document |= restitution_document(found)
        asked += restitution_lines(found)
    if masses is not None:
        accepted("classification_of_balls")
        if r is None:
            by_r = on_a_line(masses)
            document |= line_document(masses, by_r)
            asked += line_lines(masses, by_r)
        else:
            about = at_masses(masses, r)
            document |= masses_document(about)
            asked += ["", *masses_lines(about)]
    text = [*meaning_lines(MEANING, PAPER), ""] if options.verbose else []
    text += theorem_lines(outcome, PAPER)
    if verdict != outcome.verdict:
        document |= {"verdict": verdict, "headline": verdict}
        text += [f"{verdict.capitalize()}: the longest run at this r"]
    title = screen("Which collapses there are", outcome, PAPER, asked)
    claims.answer(outcome, options, lambda _: document, lambda _: [*title, "", *text])
    return EXIT_CODES[verdict]
