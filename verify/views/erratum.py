"""An erratum for the authors of the paper: what to replace, by what, and which rows prove it."""

from __future__ import annotations

import re
from collections.abc import Iterator, Mapping

from verify import __version__
from verify.language.statement import PROVED, REFUTED, Constant, Obligation
from verify.language.terms import Claim, Term
from verify.prover.outcome import Outcome
from verify.publication import BREAKS, REPAIRED, Publication
from verify.views import all_parameters
from verify.views import words as said
from verify.views.findings import Whole
from verify.views.point import printed_lines
from verify.views.tex.formulas import Formulas
from verify.views.tex.sentences import name, words

PREAMBLE = r"""\documentclass[10pt]{article}
\usepackage[a4paper,margin=1.5cm]{geometry}
\usepackage{amsmath,amssymb}
\setlength{\parindent}{0pt}\setlength{\parskip}{3pt}
\raggedright\emergencystretch=6em\pagestyle{empty}
\begin{document}\footnotesize
"""
END = "\\end{document}\n"
ROWS = (
    "A row in brackets is proved for all parameters. Minima lack the entries that are proved to be "
    "at least another one (the rows called redundant). The proofs are in"
)


def erratum(
    everywhere: Outcome,
    printed: Outcome,
    whole: Whole,
    as_printed: Mapping[str, str],
    paper: Publication,
) -> str:
    """A page of LaTeX: for each formula that changes what is printed, what to read, and the rows.

    ``everywhere`` has the rows for all parameters, and ``printed`` those of the print; ``whole``
    has the constants and the set.
    """
    return PREAMBLE + "\n".join(_Erratum(everywhere, printed, whole, paper).lines(as_printed)) + END


class _Erratum:
    """What it says; ``proved`` are the rows for all parameters, ``false`` the printed ones."""

    def __init__(
        self, everywhere: Outcome, printed: Outcome, whole: Whole, paper: Publication
    ) -> None:
        self.whole, self.paper, self.notes = whole, paper, paper.notes()
        tex = {one: letters[1] for one, letters in whole.letters.items()}
        self.formulas = Formulas(tex, {one: letters[0] for one, letters in whole.letters.items()})
        self.proved = {row.name: row for row, d in everywhere.rows if d.verdict == PROVED}
        self.false = [row for row, d in printed.rows if said.fair(printed, row, d) == REFUTED]

    def lines(self, as_printed: Mapping[str, str]) -> Iterator[str]:
        """Paragraphs: what is true, and one for each formula."""
        paper = self.paper
        yield rf"\textbf{{Erratum}} to {words(paper.authors)}, \emph{{{words(paper.title)}}}.\par"
        yield from (rf"{words(line.strip())}\par" for line in printed_lines(as_printed, paper))
        yield rf"{words(all_parameters.CLAIM)}\par"
        yield rf"{ROWS} {name('certificates/theorem1-all')} of verify-collapse {__version__}.\par"
        for label in self._labels():
            yield rf"\textbf{{{words(paper.number(label))}}} {' '.join(self._about(label))}\par"
        yield ""

    def _labels(self) -> list[str]:
        """The labels of what is changed, and of what breaks the argument, in the paper's order."""
        found = [change.label for change in self.notes.changes]
        found += [row.label for row in self.false if row.severity == BREAKS]
        return sorted(dict.fromkeys(found), key=self._place)

    def _place(self, label: str) -> tuple[int, ...]:
        number = [int(part) for part in re.findall(r"[0-9]+", self.paper.number(label))]
        return (*number,) if len(number) > 1 else (1 << 10,)  # the theorem comes last

    def _about(self, label: str) -> Iterator[str]:
        changes = [change for change in self.notes.changes if change.label == label]
        for one in changes:
            instead = f"For {one.paper} read" if one.paper != "(nothing)" else "Add"
            yield words(f"{instead} {one.needed}: {one.why}")
        breaking = [r for r in self.false if r.label == label and r.severity == BREAKS]
        names = {row.name for row in breaking}
        causes = [text for rows, text in self.notes.causes if names & {*rows}]
        yield from (words(text) for text in causes if not changes)
        for constant in (one for one in self.whole.constants if one.label == label):
            if constant.name.startswith(f"{REPAIRED}."):
                term = self.formulas.term(self.least(constant))
                yield rf"$\displaystyle {constant.tex} = {term}$;"
        rows = [f"{REPAIRED}.{one}" for change in changes for one in change.rows]
        rows += [row.corrected_by or "" for row in breaking]
        if f"{REPAIRED}.set-interior" in rows:
            givens = ", ".join(f"${self.formulas.claim(given)}$" for given in self.whole.givens)
            yield f"{words(all_parameters.SET)} {givens}; {words(all_parameters.FLIGHT)}"
        yield from (self._row(self.proved[one]) for one in dict.fromkeys(rows))

    def _row(self, row: Obligation) -> str:
        claim = f" ${self.formulas.claim(row.claim)}$" if isinstance(row.claim, Claim) else ""
        return f"[{name(said.short_name(row))}:{claim}]"

    def least(self, constant: Constant) -> Term:
        """The definition of a constant without the entries of its minimum that can be left out."""
        rows = [f"redundant.{constant.short_name}-{k + 1}" for k in range(len(constant.term.args))]
        if constant.term.op != "min" or not any(row in self.proved for row in rows):
            return constant.term
        pairs = zip(constant.term.children, rows, strict=True)
        kept = [entry for entry, row in pairs if row not in self.proved]
        return kept[0] if len(kept) == 1 else Term("min", *kept)
