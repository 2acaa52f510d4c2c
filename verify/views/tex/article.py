"""Statements as a LaTeX document: what is claimed, for which values, given what, with numbers.

It has no tables: everything is a paragraph that breaks. Nothing but amsmath and amssymb is needed.
"""

from __future__ import annotations

from collections.abc import Iterable, Iterator, Mapping

from verify.language.statement import (
    PRINTED,
    PROVED,
    REFUTED,
    Always,
    Applies,
    Assumption,
    Constant,
    Context,
    Obligation,
    Publication,
)
from verify.language.terms import Claim, Term
from verify.prover.decimals import short
from verify.prover.outcome import Decision, Outcome
from verify.views.tex.formulas import Formulas, safe_letter
from verify.views.tex.sentences import name, tex_number, words
from verify.views.words import (
    fair,
    given_by,
    headline,
    in_letters,
    is_about,
    parameter_letters,
    parameters_of,
    sides_of,
    witness_of,
)

PREAMBLE = r"""\documentclass[10pt]{article}
\usepackage[a4paper,margin=2.2cm]{geometry}
\usepackage{amsmath,amssymb}
\setlength{\parindent}{0pt}\setlength{\parskip}{3pt plus 1pt}
\setlength{\lineskiplimit}{2pt}\setlength{\lineskip}{3pt}
\raggedright\emergencystretch=6em
\newcommand{\claim}[1]{\hspace*{1.5em}\hangindent=3em $\displaystyle #1$\par}
\newcommand{\says}[1]{\hspace*{1.5em}\hangindent=3em #1\par}
\begin{document}
"""
END = "\\end{document}\n"

#: A formula between numbers with more LaTeX than this is told by its two sides only.
LONGEST = 800

#: How the parameters of Theorem 1 are written, in LaTeX and in plain text.
PARAMETERS = {
    "c": (r"(-\cos\theta_0)", "(-cos θ₀)"),
    "V_0": ("V_0", "V₀"),
    "delta_theta": (r"\delta_\theta", "δ_θ"),
}

#: Letters that statements have by their names.
SPELLED = {"delta_theta": r"\delta_\theta"}


def tex_document(outcomes: Iterable[Outcome], paper: Publication) -> str:
    """One document about all of them."""
    return PREAMBLE + "".join(part(outcome, paper) for outcome in outcomes) + END


def part(outcome: Outcome, paper: Publication) -> str:
    """What the document says of one statement."""
    return "\n".join(_Part(outcome, paper).lines()) + "\n"


class _Part:
    """One statement with its formulas."""

    def __init__(self, outcome: Outcome, paper: Publication) -> None:
        self.paper = paper
        self.outcome, self.statement = outcome, outcome.statement
        self.formulas = Formulas(*_letters(outcome))
        self.contexts = {context.name: context for context in self.statement.contexts}

    def lines(self) -> Iterator[str]:
        title = in_letters(self.statement.title)
        yield rf"\section*{{{words(title[:1].upper() + title[1:])}}}"
        if is_about(self.outcome, self.paper):
            yield rf"About {words(self.paper.authors)}, \emph{{{words(self.paper.title)}}}.\par"
        yield rf"Verdict: \textbf{{{headline(self.outcome)}}},"
        yield f"given {words(given_by(self.outcome, self.paper))}."
        yield from self._parameters()
        yield from self._assumptions("What is taken on trust", self.outcome.assumptions)
        yield from self._assumptions(
            "What only printed rows take on trust", self.outcome.printed_assumptions
        )
        if self.statement.constants:
            yield r"\subsection*{Constants}"
            yield from map(self._constant, self.statement.constants)
        yield from self._rows(None)
        for context in self.statement.contexts:
            yield from self._context(context)

    def _parameters(self) -> Iterator[str]:
        if self.statement.parameters:
            values = self.formulas.values(parameters_of(self.outcome))
            yield rf"\par Parameters: ${values}$."

    def _assumptions(self, title: str, found: Iterable[Assumption]) -> Iterator[str]:
        items = []
        for a in found:
            where = f"; {tex_label(a.label, self.paper)}" if a.label else ""
            who = rf"\textbf{{{words(a.name)}}} ({a.kind}{where})"
            items.append(rf"\says{{{who}: {words(a.sentence)}}}")
        if items:
            yield from (rf"\subsection*{{{title}}}", *items)

    def _constant(self, constant: Constant) -> str:
        letter, term = self.formulas.symbol(constant.name), self.formulas.term(constant.term)
        found = self.outcome.enclosures.get(constant.name)
        value = "" if found is None else short(found.ends[0])
        shown = "" if value in ("", term) else rf"\quad ({tex_number(value)})"
        return rf"\claim{{{letter} = {term}{shown}}}"

    def _context(self, context: Context) -> Iterator[str]:
        yield rf"\subsection*{{Context {name(context.name)}}}"
        if context.says:
            yield rf"{words(context.says)}.\par"
        yield self._quantifier(context)
        for given in context.givens:
            note = "" if given.kind == "plain" else rf"\quad\text{{({given.kind})}}"
            yield rf"\claim{{{self._claim(given.claim)}{note}}}"
        if context.constants:
            yield r"Write\par"
            yield from map(self._constant, context.constants)
        yield from self._rows(context)

    def _quantifier(self, context: Context) -> str:
        letters = [f"${self.formulas.symbol(v.name)}$" for v in context.variables]
        inside = rf", inside of the context {name(context.parent)}" if context.parent else ""
        such = " such that" if context.givens else "."
        who = f"For all real {', '.join(letters)}" if letters else "With no variables of its own"
        return rf"{who}{inside}{such}\par"

    # --- rows ------------------------------------------------------------------------------------

    def _rows(self, context: Context | None) -> Iterator[str]:
        key = None if context is None else context.name
        rows = [(row, found) for row, found in self.outcome.rows if row.context == key]
        if not rows:
            return
        if context is None:
            yield r"\subsection*{Claims about these numbers}"
        else:
            yield rf"\paragraph{{For all values of {name(context.name)}:}}\par"
        for row, found in rows:
            yield from self._row(row, found)

    def _row(self, row: Obligation, found: Decision) -> Iterator[str]:
        role = "as printed, " if row.role == PRINTED else ""
        where = f" {tex_label(row.label, self.paper)}" if row.label else ""
        verdict = fair(self.outcome, row, found)
        yield rf"\par\medskip\textbf{{{name(row.name)}}}{where}: {role}\textbf{{{verdict}}}"
        if row.says:
            yield rf"\says{{{words(in_letters(row.says))}}}"
        claim = self._claim(row.claim)
        if row.context is None and len(claim) > LONGEST:
            yield r"\says{(a long formula without variables: see the statement file)}"
        else:
            yield rf"\claim{{{claim}}}"
        notes = [*self._evidence(row, found)]
        notes += [f"by {found.method}"] if found.verdict == PROVED and found.method else []
        if row.uses:
            notes.append(f"with {', '.join(map(words, row.uses))}")
        if found.verdict == REFUTED:
            notes += [words(row.severity)] if row.severity and verdict == REFUTED else []
            notes += [f"corrected by {name(row.corrected_by)}"] if row.corrected_by else []
        if notes:
            yield rf"\says{{{'; '.join(notes)}}}"

    def _evidence(self, row: Obligation, found: Decision) -> Iterator[str]:
        sides = sides_of(row, found)
        left, right = ("", "") if sides is None else map(short, sides)
        if left and not (left + right).count("["):  # an equality has no digits on which both agree
            yield rf"left side ${tex_number(left)}$, right side ${tex_number(right)}$"
        if found.verdict == REFUTED and found.witness:
            values = self.formulas.values(in_order(witness_of(row, found) or found.witness))
            yield rf"false at ${values}$"

    def _claim(self, claim: Claim | Applies | Always) -> str:
        if isinstance(claim, Claim):
            return self.formulas.claim(claim)
        where = rf"\text{{{name(claim.context)}}}"
        if isinstance(claim, Applies):
            return rf"{where}\text{{ applies at }} {self.formulas.values(in_order(claim.at))}"
        start, then = (self.formulas.values(in_order(v)) for v in (claim.start, claim.next))
        return (
            rf"{where}\text{{ holds for ever, from }} {start}"
            rf"\text{{, where the next state is }} {then}"
        )


def in_order(values: Mapping[str, Term]) -> dict[str, Term]:
    """The values by name: a table in a file has no other order."""
    return dict(sorted(values.items()))


def tex_label(text: str, paper: Publication) -> str:
    """A label of the paper, after the number that is printed there; another as it is."""
    printed = paper.printed(text)
    return words(text) if printed is None else f"{words(printed)} {name(text)}"


def _letters(outcome: Outcome) -> tuple[dict[str, str], dict[str, str]]:
    """For each name of a statement its letter in LaTeX, and in plain text."""
    statement = outcome.statement
    found = {
        key: PARAMETERS[key] if letter != key else ("", key)
        for key, letter in parameter_letters(outcome).items()
    }
    constants = list(statement.constants)
    for context in statement.contexts:
        found |= {
            v.name: (SPELLED.get(v.tex, v.tex), v.letter or v.name) for v in context.variables
        }
        constants += context.constants
    found |= {c.name: (c.tex, c.letter or c.name) for c in constants}
    tex = {name: safe_letter(*pair) for name, pair in found.items()}
    sets = {row.group for row in statement.obligations}
    for constant in statement.constants:
        group = constant.name.rpartition(".")[0]
        if group and group in sets:  # the same letter in the printed and in the repaired set
            tex[constant.name] = rf"{{{tex[constant.name]}}}^{{\text{{{words(group)}}}}}"
    return tex, {name: plain for name, (_, plain) in found.items()}
