"""Statements as a LaTeX article: theorem, assumptions, settings, and the rows, with references.

Everything is a paragraph that breaks: a formula of a certificate may be longer than a page is wide.
"""

from __future__ import annotations

import re
from collections.abc import Callable, Iterable, Iterator, Mapping, Sequence

from verify.language.statement import (
    NEEDED,
    PRINTED,
    PROVED,
    REFUTED,
    Always,
    Applies,
    Assumption,
    Constant,
    Context,
    Obligation,
)
from verify.language.terms import Claim, Term
from verify.language.typeset import letters_apart
from verify.prover.decimals import as_one_or_two, short
from verify.prover.outcome import Decision, Outcome
from verify.prover.uses import nodes
from verify.publication import REPAIRED, Publication
from verify.views.enclosures import exactly
from verify.views.mathml import AS_IT_IS
from verify.views.point import in_numbers
from verify.views.tex.formulas import Formulas, safe_letter
from verify.views.tex.sentences import name, tex_number, words
from verify.views.words import (
    INSTEAD_WORDS,
    begun,
    fair,
    given_by,
    groups,
    headline,
    in_letters,
    is_about,
    parameter_letters,
    parameters_of,
    sides_of,
    witness_of,
)

_NUMBER = re.compile(r"-?\d[^, ]*(?: ± [^, ]+)?")

PREAMBLE = r"""\documentclass[10pt]{article}
\usepackage[a4paper,margin=2.2cm]{geometry}
\usepackage{amsmath,amssymb,amsthm}
\usepackage[hidelinks]{hyperref}
\setlength{\parindent}{0pt}\setlength{\parskip}{3pt plus 1pt}
\setlength{\lineskiplimit}{2pt}\setlength{\lineskip}{3pt}
\raggedright\emergencystretch=6em
\newtheorem{theorem}{Theorem}
\theoremstyle{definition}
\newtheorem{statement}[theorem]{Statement}
\newtheorem{assumption}{Assumption}
\newtheorem{setting}{Setting}
\newtheorem{row}{Row}
\newcommand{\formula}[1]{\hspace*{1.5em}\hangindent=3em $\displaystyle #1$\par}
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

#: The LaTeX of theorems that are told in words of their own, by the names of their statements.
Told = Mapping[str, Callable[[], str]]


def tex_document(
    outcomes: Iterable[Outcome], paper: Publication, told: Told | None = None, *, full: bool = False
) -> str:
    """One document about all of them; only the full one has all rows."""
    parts = (
        part(outcome, paper, told, full=full, number=number)
        for number, outcome in enumerate(outcomes, 1)
    )
    return PREAMBLE + "".join(parts) + END


def part(
    outcome: Outcome,
    paper: Publication,
    told: Told | None = None,
    *,
    full: bool = False,
    number: int = 1,
) -> str:
    """What the document says of one statement; its labels begin with its number."""
    return "\n".join(_Part(outcome, paper, told or {}, full, number).lines()) + "\n"


class _Part:
    """One statement with its formulas.

    ``final`` are the needed rows that no proof of another row uses, and what is not proved of them.
    """

    def __init__(
        self, outcome: Outcome, paper: Publication, told: Told, full: bool, number: int
    ) -> None:
        self.paper, self.full, self.number = paper, full, number
        outcome = exactly(outcome)
        self.outcome, self.statement = outcome, outcome.statement
        tex, plain = _letters(outcome)
        self.formulas, self.names = Formulas(tex, plain), {*plain, *plain.values()}
        self.words = self._in_words(told)
        used = {fact for node in nodes(outcome).values() for fact in node.uses}
        needed = [(row, found) for row, found in outcome.rows if row.role == NEEDED]
        self.final = [(r, d) for r, d in needed if d.verdict != PROVED or r.name not in used]
        self.listed = [pair for pair in outcome.rows if full or self._is_printed_and_false(*pair)]
        # A theorem in words has its hypotheses there; what the short article leaves out has none.
        rows = [*self.listed, *([] if self.words else self.final)]
        self.contexts = self._contexts({row.context for row, _ in rows})
        self.shown = {row.name for row, _ in self.listed}

    def lines(self) -> Iterator[str]:
        title = in_letters(self.statement.title)
        yield rf"\section{{{words(begun(title, self.names))}}}"
        if is_about(self.outcome, self.paper):
            yield rf"About {words(self.paper.authors)}, \emph{{{words(self.paper.title)}}}.\par"
        yield rf"Verdict: \textbf{{{headline(self.outcome)}}},"
        yield f"given {words(given_by(self.outcome, self.paper))}."
        if self.statement.parameters:
            values = self.formulas.values(parameters_of(self.outcome))
            yield rf"\par Parameters: ${values}$."
        yield from self._theorem()
        own, others = self.outcome.assumptions, self.outcome.printed_assumptions
        yield from self._assumptions("What is taken on trust", own)
        yield from self._assumptions("What only printed rows take on trust", others, len(own))
        if self.statement.constants:
            yield r"\subsection*{Constants}"
            yield from map(self._constant, self.statement.constants)
        if self.contexts:
            yield r"\subsection*{Settings}"
        for context in self.contexts:
            yield from self._setting(context)
        yield from self._rows()

    # --- the theorem -----------------------------------------------------------------------------

    def _in_words(self, told: Told) -> str:
        """The theorem in words, where it has words of its own and is proved."""
        if self.outcome.verdict != PROVED:
            return ""
        if self.statement.theorem in told:
            return told[self.statement.theorem]()
        if self.statement.theorem == self.paper.theorem and REPAIRED in groups(self.outcome):
            return words(in_numbers(self.outcome) or "")
        return ""

    def _theorem(self) -> Iterator[str]:
        kind = "theorem" if self.outcome.verdict == PROVED else "statement"
        note = "" if kind == "theorem" else f"[{headline(self.outcome)}]"
        yield rf"\begin{{{kind}}}{note}\label{{{self._key('theorem')}}}"
        if self.words:
            yield self.words
        else:
            yield f"{self._given()}the following holds."
            yield r"\par"
            for context in (None, *(context.name for context in self.contexts)):
                rows = [pair for pair in self.final if pair[0].context == context]
                if rows and context is not None:
                    yield rf"\par In {self._setting_of(context)}:\par"
                for row, found in rows:
                    yield from self._in_theorem(row, found)
        yield rf"\end{{{kind}}}"

    def _given(self) -> str:
        places = range(len(self.outcome.assumptions))
        own = [self._reference("assumption", str(place)) for place in places]
        if not own:
            return "Without assumptions, " if not self.statement.cites else ""
        plural = "s" if len(own) > 1 else ""
        last = f"{', '.join(own[:-1])} and {own[-1]}" if plural else own[0]
        return f"Under Assumption{plural}~{last}, "

    def _in_theorem(self, row: Obligation, found: Decision) -> Iterator[str]:
        verdict = "" if found.verdict == PROVED else rf" (\textbf{{{found.verdict}}})"
        yield rf"\formula{{{self._brief(row)}\quad\text{{{self._named(row.name)}{verdict}}}}}"

    # --- what it rests on ------------------------------------------------------------------------

    def _assumptions(
        self, title: str, found: Sequence[Assumption], start: int = 0
    ) -> Iterator[str]:
        if found:
            yield rf"\subsection*{{{title}}}"
        for place, a in enumerate(found, start):
            where = f"; {tex_label(a.label, self.paper)}" if a.label else ""
            key = self._key(f"assumption:{place}")
            yield rf"\begin{{assumption}}[{{{words(a.name)}; {a.kind}{where}}}]\label{{{key}}}"
            yield rf"{words(a.sentence)}\end{{assumption}}"

    def _constant(self, constant: Constant) -> str:
        letter, term = self.formulas.symbol(constant.name), self.formulas.term(constant.term)
        found = self.outcome.enclosures.get(constant.name)
        value = "" if found is None else short(found.ends[0])
        shown = "" if value in ("", term) else rf"\quad ({tex_number(value)})"
        return rf"\formula{{{letter} = {term}{shown}}}"

    def _contexts(self, names: set[str | None]) -> list[Context]:
        """The contexts of these names, and those around them, in the statement's order."""
        around = {context.name: context.parent for context in self.statement.contexts}
        wanted = set(names)
        for key in names:
            while key in around:
                wanted.add(key)
                key = around[key]
        return [context for context in self.statement.contexts if context.name in wanted]

    def _setting(self, context: Context) -> Iterator[str]:
        key = self._key(f"setting:{context.name}")
        yield rf"\begin{{setting}}[{name(context.name)}]\label{{{key}}}"
        if context.says:
            yield rf"{words(begun(context.says, self.names))}.\par"
        letters = [f"${self.formulas.symbol(v.name)}$" for v in context.variables]
        inside = f", in {self._setting_of(context.parent)}" if context.parent else ""
        such = " such that" if context.givens else "."
        who = f"For all real {', '.join(letters)}" if letters else "With no variables of its own"
        yield rf"{who}{inside}{such}\par"
        for given in context.givens:
            note = "" if given.kind == "plain" else rf"\quad\text{{({given.kind})}}"
            yield rf"\formula{{{self._claim(given.claim)}{note}}}"
        if context.constants:
            yield r"Write\par"
            yield from map(self._constant, context.constants)
        yield r"\end{setting}"

    # --- rows ------------------------------------------------------------------------------------

    def _is_printed_and_false(self, row: Obligation, found: Decision) -> bool:
        return row.role == PRINTED and fair(self.outcome, row, found) == REFUTED

    def _rows(self) -> Iterator[str]:
        if self.listed:
            yield rf"\subsection*{{{'All rows' if self.full else 'What is printed and false'}}}"
        for row, found in self.listed:
            yield from self._row(row, found)
        told = self.shown | ({row.name for row, _ in self.final} if not self.words else set())
        left = len(self.outcome.rows) - len(told)
        if left and not self.full:
            yield rf"\par The other rows ({left}) are in the full article:"
            yield r"\texttt{verify check -{}-latex -{}-full}."

    def _row(self, row: Obligation, found: Decision) -> Iterator[str]:
        role = "as printed, " if row.role == PRINTED else ""
        where = f" {tex_label(row.label, self.paper)}" if row.label else ""
        verdict = fair(self.outcome, row, found)
        yield rf"\begin{{row}}[{{{name(row.name)}{where}}}]\label{{{self._key(f'row:{row.name}')}}}"
        inside = f" (in {self._setting_of(row.context)})" if row.context else ""
        yield rf"{role}\textbf{{{verdict}}}{inside}\par"
        if row.says:
            yield rf"\says{{{words(in_letters(row.says))}}}"
        yield rf"\formula{{{self._brief(row)}}}"
        notes = [*self._evidence(row, found)]
        notes += [f"by {found.method}"] if found.verdict == PROVED and found.method else []
        if row.uses:
            notes.append(f"with {', '.join(map(self._assumed, row.uses))}")
        if found.verdict == REFUTED:
            notes += (
                [words(self.paper.severity(row))] if row.severity and verdict == REFUTED else []
            )
            better = INSTEAD_WORDS.get(verdict, "corrected by")
            notes += [f"{better} {self._named(row.corrected_by)}"] if row.corrected_by else []
        if notes:
            yield rf"\says{{{'; '.join(notes)}}}"
        yield r"\end{row}"

    def _brief(self, row: Obligation) -> str:
        claim = self._claim(row.claim)
        if row.context is None and len(claim) > LONGEST:
            return r"\text{a long formula without variables: see the statement file}"
        return claim

    def _evidence(self, row: Obligation, found: Decision) -> Iterator[str]:
        sides = sides_of(row, found)
        texts = () if sides is None else as_one_or_two(*sides)
        if len(texts) == 1:
            yield "both sides " + _NUMBER.sub(lambda m: f"${tex_number(m[0])}$", texts[0])
        elif texts and "[" not in "".join(texts):
            yield "left side ${}$, right side ${}$".format(*map(tex_number, texts))
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

    # --- references ------------------------------------------------------------------------------

    def _key(self, what: str) -> str:
        return f"{self.number}:{what}"

    def _reference(self, kind: str, what: str) -> str:
        return rf"\ref{{{self._key(f'{kind}:{what}')}}}"

    def _assumed(self, what: str) -> str:
        """An assumption of this statement; one of a cited statement may have the same name."""
        every = (*self.outcome.assumptions, *self.outcome.printed_assumptions)
        place = next(place for place, a in enumerate(every) if a.name == what)
        return f"Assumption~{self._reference('assumption', str(place))}"

    def _setting_of(self, context: str) -> str:
        return f"Setting~{self._reference('setting', context)}"

    def _named(self, row: str) -> str:
        """The name of a row, after its number if the article lists it."""
        if row in self.shown:
            return f"Row~{self._reference('row', row)}, {name(row)}"
        return name(row)


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
    for symbol, (letter, own) in letters_apart(statement).items():
        found[symbol] = (SPELLED.get(own, own), letter)
    tex = {name: safe_letter(*pair) for name, pair in found.items()}
    sets = {row.group for row in statement.obligations}
    for constant in statement.constants:
        group = constant.name.rpartition(".")[0]
        if group and group in sets and not AS_IT_IS.fullmatch(found[constant.name][0]):
            # the same letter in the printed and in the repaired set
            tex[constant.name] = rf"{{{tex[constant.name]}}}^{{\text{{{words(group)}}}}}"
    tex = {
        name: f"({letter})" if letter.startswith("-") else letter for name, letter in tex.items()
    }
    return tex, {name: plain for name, (_, plain) in found.items()}
