"""The readable report beside a certificate, for every theorem: in Markdown, and for a page."""

from __future__ import annotations

import re
from collections.abc import Iterable, Iterator, Sequence

from verify.language.record import TYPE_CHECKING
from verify.language.statement import NEEDED, PRINTED, REFUTED
from verify.language.terms import symbol
from verify.language.typeset import LONG
from verify.publication import REPAIRED
from verify.views import words
from verify.views.enclosures import exactly, minimum_of
from verify.views.point import in_numbers
from verify.views.typesetting import Marked, in_a_line

if TYPE_CHECKING:
    from verify.language.statement import Always, Applies, Assumption, Context, Obligation
    from verify.language.terms import Claim, Term
    from verify.language.typeset import Typesetter
    from verify.prover.outcome import Decision, Outcome
    from verify.publication import Publication

#: In Markdown a backslash, and what begins a tag or a picture.
_MARKUP = re.compile(r"\\|<(?=[A-Za-z/!?])|(?<=!)\[")
#: And what begins, at the start of a line, something else than a paragraph.
_BEGINS = re.compile(r"(?=[-#>+*=~`|_\[])|[0-9]+(?=[.)])")


def report(outcome: Outcome, paper: Publication, *, is_sent: bool = False) -> str:
    """The whole report, ending with a line feed; the checker is beside it where it is sent."""
    written = Report(outcome, paper, words.letters(outcome), is_sent=is_sent).blocks()
    return re.sub("\n{3,}", "\n\n", "".join(written)).lstrip("\n")


class Report:
    """A report, in Markdown; whatever is no `Marked` is words, which can make no markup."""

    def __init__(
        self, outcome: Outcome, paper: Publication, letters: Typesetter, *, is_sent: bool
    ) -> None:
        self._outcome, self._paper, self._letters = exactly(outcome), paper, letters
        self._about, self._is_sent = words.is_about(outcome, paper), is_sent

    def _words(self, text: str) -> str:
        return _MARKUP.sub(lambda match: f"\\{match[0]}", in_a_line(text))

    def _line(self, *parts: str) -> Marked:
        found = [part if type(part) is Marked else self._words(part) for part in parts]
        return Marked("".join(found).strip(" "))

    def _numbers(self, text: str) -> str:
        return text

    def _code(self, text: str) -> Marked:
        """Words between backticks, where only a backtick means something else."""
        return Marked(f"`{in_a_line(text).strip(' ').replace('`', chr(39))}`")

    def _in(self, tag: str, text: str) -> Marked:
        around = {"strong": "**", "em": "*"}[tag]
        return Marked(f"{around}{self._line(text)}{around}")

    def _verdict(self, word: str) -> Marked:
        return Marked(word)

    def _claim(self, claim: Claim | Applies | Always) -> str:
        return _brief(self._letters.claim(claim))

    def _term(self, term: Term, before: str = "") -> str:
        return f"{before} {_brief(self._letters.term(term))}".strip()

    def _letter(self, name: str) -> str:
        return self._term(symbol(name))

    def _heading(self, _name: str, *parts: str, level: int = 2) -> str:
        return f"\n{'#' * level} {self._line(*parts)}\n\n"

    def _paragraph(self, *parts: str) -> str:
        line = self._line(*parts)
        begins = _BEGINS.match(line)
        at = begins.end() if begins else 0
        return f"\n{line[:at]}\\{line[at:]}\n\n" if begins else f"\n{line}\n\n"

    def _items(self, lines: Iterable[str]) -> str:
        return "".join(f"- {line}\n" for line in lines)

    def _grid(
        self, head: Sequence[str], rows: Iterable[Iterable[str]], _blocks: bool = False
    ) -> str:
        cells = ([self._line(cell).replace("|", "\\|") for cell in row] for row in rows)
        lines = "".join(f"| {' | '.join(row)} |\n" for row in cells)
        return f"\n| {' | '.join(head)} |\n|{'---|' * len(head)}\n{lines}" if lines else ""

    def blocks(self) -> Iterator[str]:
        """The blocks, in their order."""
        outcome, paper = self._outcome, self._paper
        yield self._heading("title", outcome.statement.title, level=1)
        if self._about:
            yield self._paragraph(f"About {paper.authors}, ", self._in("em", paper.title), ".")
        verdict = self._in("strong", words.verdict_text(outcome, paper))
        yield self._paragraph("Verdict: ", verdict, ".")
        beside = words.counts(outcome, PRINTED)
        if beside:
            yield self._paragraph(
                f"It depends on the rows that the proof needs: {words.counts(outcome, NEEDED)}. "
                f"What is printed is judged beside them: {beside}."
            )
        numbers = in_numbers(outcome) if REPAIRED in words.groups(outcome) else None
        if numbers:
            yield self._paragraph(numbers)
        yield self._how_to_check()
        rows = [*self._refuted()]
        if rows:
            yield self._heading("refuted", "What is printed and refuted here")
            head = ["Label", "As printed", "Claim that would be needed", "False", "Severity"]
            yield self._grid([*head, "Corrected by"], rows)
        if self._is_main() and paper.notes().changes:
            yield self._heading("changed", "What was changed")
            changes = paper.notes().changes
            rows = [[self._label(one.label), one.paper, one.needed, one.why] for one in changes]
            yield self._grid(["Label", "Paper", "Needed", "Why"], rows)
        parameters = words.parameters_of(outcome)
        if parameters:
            yield self._heading("parameters", "Parameters")
            rows = [[self._letter(name), self._term(value)] for name, value in parameters.items()]
            yield self._grid(["Parameter", "Value"], rows)
        if outcome.statement.constants:
            yield self._heading("constants", "Constants")
            yield self._grid(["Constant", "Value", "Definition or bound"], self._constants())
        for context in outcome.statement.contexts:
            yield from self._context(context)
        for number, group in enumerate(words.groups(outcome), 1):
            yield self._heading(f"rows-{number}", f"All rows: {group}" if group else "All rows")
            head = ["Verdict", "Name", "Label", "Step", "Claim", "Left and right", "By"]
            yield self._grid(head, map(self._row, outcome.of_group(group)), True)
        yield from self._trust()

    def _is_main(self) -> bool:
        return self._about and self._outcome.statement.theorem == self._paper.theorem

    def _how_to_check(self) -> str:
        if self._is_sent:
            how = "Check it with nothing but Python 3.11 or newer, in this folder: "
            return self._paragraph(how, self._code("python3 -I check.py ."))
        command = self._code("python3 -I verify/check.py")
        return self._paragraph("Check it with nothing but Python: ", command, " and this folder.")

    def _label(self, name: str) -> str:
        number = self._paper.printed(name) if name else None
        if number:
            return self._line(f"{number} ", self._code(name))
        return self._code(name) if name and self._about else name or ""

    def _told(self, row: Obligation) -> str:
        """The claim; in a theorem of somebody else's also for all values of which context."""
        claim = self._claim(row.claim)
        if self._about or not row.context:
            return claim
        return self._line(claim, " for all values of ", self._code(row.context))

    def _evidence(self, row: Obligation, found: Decision) -> str:
        """The numbers that show a row, or the values at which it is false."""
        numbers = words.sides_told(row, found)
        if numbers or not found.witness:
            return self._numbers(numbers)
        return f"at {words.values_told(found.witness, self._letters)}"

    def _refuted(self) -> Iterator[list[str]]:
        """The refuted printed rows, each with its two sides or its witness."""
        for row, found in self._outcome.rows:
            if row.role == PRINTED and words.fair(self._outcome, row, found) == REFUTED:
                yield [
                    *(self._label(row.label), row.says, self._told(row)),
                    *(self._evidence(row, found), self._paper.severity(row)),
                    self._code(row.corrected_by) if row.corrected_by else "",
                ]

    def _constants(self) -> Iterator[list[str]]:
        """Letter and group, value, definition or bound of each, and which entry is least."""
        bounds = self._paper.notes().bounds if self._is_main() else {}
        for one in self._outcome.statement.constants:
            is_named = self._letters.term(symbol(one.name)) == one.name
            group = "" if is_named else one.name.rpartition(".")[0]
            ends = words.ends_of(self._outcome, one.name)
            sign, bound = bounds.get(one.name, ("=", one))
            least = minimum_of(self._outcome, one).least if one.term.op == "min" else None
            letter = self._line(self._letter(one.name), f" ({group})" if group else "")
            which = f" (entry {least} is the least)" if least else ""
            # A scene asks for few enclosures; a number without one need not be undefined.
            value = "" if ends is None else words.ends_told(ends)
            yield [letter, value, self._line(self._term(bound.term, sign), which)]

    def _context(self, one: Context) -> Iterator[str]:
        """What a context assumes: a row of it holds for all values that satisfy its givens."""
        inside = (", inside ", self._code(one.parent)) if one.parent else ()
        yield self._heading(f"context-{one.name}", "Context ", self._code(one.name), *inside)
        yield self._paragraph(one.says)
        letters = [part for x in one.variables for part in (", ", self._letter(x.name))]
        yield self._paragraph("Variables: ", *(letters[1:] or ["none"]), ".")
        givens = (
            (self._code(x.name), self._claim(x.claim), x.assumption or x.kind) for x in one.givens
        )
        yield self._grid(["Given", "Claim", "Kind"], givens)
        own = one.constants
        named = [self._line(self._letter(x.name), " (", self._code(x.name), ")") for x in own]
        terms = [self._term(x.term) for x in own]
        yield self._grid(["Constant", "Definition"], zip(named, terms, strict=True))

    def _row(self, one: tuple[Obligation, Decision]) -> list[str]:
        row, found = one
        verdict = self._verdict(words.fair(self._outcome, row, found))
        return [
            verdict if row.role == NEEDED else self._line(verdict, f" ({row.role})"),
            *(self._code(words.short_name(row)), self._label(row.label), row.says),
            *(self._told(row), self._evidence(row, found), found.method),
        ]

    def _trust(self) -> Iterator[str]:
        outcome = self._outcome
        yield self._heading("trust", "Taken on trust")
        yield self._items(map(self._assumption, outcome.assumptions))
        if not (self._about or outcome.assumptions):
            yield self._paragraph("Nothing: what is proved rests on the definitions above alone.")
        if outcome.printed_assumptions:
            yield self._heading("trust-printed", "What only printed rows take on trust")
            yield self._items(map(self._assumption, outcome.printed_assumptions))

    def _assumption(self, one: Assumption) -> str:
        label = self._label(one.label) if one.label else self._code(one.name)
        return self._line(label, f" ({one.kind}): {one.sentence}")


def _brief(text: str) -> str:
    """What is longer than a line is left to the statement file."""
    return text if len(text) <= words.MAX_FORMULA else LONG
