"""The readable report beside a certificate, in Markdown, for every theorem."""

from __future__ import annotations

from collections.abc import Iterable, Iterator

from verify.language.statement import (
    NEEDED,
    PRINTED,
    REFUTED,
    REPAIRED,
    Always,
    Applies,
    Assumption,
    Constant,
    Context,
    Obligation,
    Publication,
)
from verify.language.terms import Claim, symbol
from verify.language.typeset import Typesetter
from verify.prover.decimals import short
from verify.prover.outcome import Decision, Ends, Outcome
from verify.views.enclosures import minimum_of
from verify.views.point import in_numbers
from verify.views.words import (
    ends_of,
    groups,
    is_about,
    letters,
    short_name,
    sides_of,
    verdict_text,
)

_SIGNS = {"<": "<", "<=": "≤", "=": "="}

#: A longer formula is left to the statement file; what the row says names it.
LONGEST = 400
LONG = "(long: see the statement file)"

Row = tuple[Obligation, Decision]


def report(outcome: Outcome, paper: Publication) -> str:
    """The whole report, ending with a line feed."""
    return "\n".join(_lines(outcome, paper)) + "\n"


def _lines(outcome: Outcome, paper: Publication) -> Iterator[str]:
    yield f"# {outcome.statement.title}"
    yield ""
    if is_about(outcome, paper):
        yield from (f"About {paper.authors}, *{paper.title}*.", "")
    yield f"Verdict: **{verdict_text(outcome, paper)}**."
    numbers = in_numbers(outcome) if REPAIRED in groups(outcome) else None
    if numbers is not None:
        yield from ("", numbers)
    yield ""
    yield "Check it with nothing but Python: `python3 -I verify/check.py` and this folder."
    if any(_is_defect(*pair) for pair in outcome.rows):
        yield from section("What is printed and refuted here")
        yield from defects(outcome, paper)
    if _is_theorem_1(outcome, paper):
        yield from section("What was changed")
        yield from table(
            ("Label", "Paper", "Needed", "Why"),
            ((marked(c.label, paper), c.paper, c.needed, c.why) for c in paper.notes().changes),
        )
    if outcome.statement.constants:
        yield from section("Constants")
        yield from table(("Constant", "Value", "Definition or bound"), _constants(outcome, paper))
    for context in outcome.statement.contexts:
        yield from _context(context, letters(outcome))
    for group in groups(outcome):
        yield from section(f"All rows: {group}" if group else "All rows")
        yield from _rows(outcome, outcome.of_group(group), paper)
    yield from section("Taken on trust")
    yield from (_assumption(one, paper) for one in outcome.assumptions)
    if outcome.printed_assumptions:
        yield from section("What only printed rows take on trust")
        yield from (_assumption(one, paper) for one in outcome.printed_assumptions)


def _is_theorem_1(outcome: Outcome, paper: Publication) -> bool:
    return outcome.statement.theorem == paper.theorem and is_about(outcome, paper)


def _assumption(assumption: Assumption, paper: Publication) -> str:
    who = marked(assumption.label, paper) or f"`{assumption.name}`"
    return f"- {who} ({assumption.kind}): {assumption.sentence}"


def _context(context: Context, typesetter: Typesetter) -> Iterator[str]:
    """What a context assumes: a row of it holds for all values that satisfy its givens."""
    inside = f", inside `{context.parent}`" if context.parent else ""
    yield from section(f"Context `{context.name}`{inside}")
    if context.says:
        yield from (context.says, "")
    yield f"Variables: {', '.join(v.letter or v.name for v in context.variables) or 'none'}."
    if context.givens:
        yield ""
        yield from table(
            ("Given", "Claim", "Kind"),
            (
                (f"`{g.name}`", _short_claim(g.claim, typesetter), g.assumption or g.kind)
                for g in context.givens
            ),
        )
    if context.constants:
        yield ""
        terms = ((c, typesetter.term(c.term)) for c in context.constants)
        yield from table(
            ("Constant", "Definition"),
            ((f"{c.letter} (`{c.name}`)", t if len(t) <= LONGEST else LONG) for c, t in terms),
        )


def _short_claim(claim: Claim | Applies | Always, typesetter: Typesetter) -> str:
    text = typesetter.claim(claim)
    return text if len(text) <= LONGEST else LONG


# --- rows ----------------------------------------------------------------------------------------


def _is_defect(row: Obligation, decision: Decision) -> bool:
    return row.role == PRINTED and decision.verdict == REFUTED


def defects(outcome: Outcome, paper: Publication) -> Iterator[str]:
    """The refuted printed rows, in the paper's order, each with its two sides or its witness."""
    typesetter = letters(outcome)
    yield from table(
        ("Label", "As printed", "Claim that would be needed", "False", "Corrected by"),
        (
            (
                marked(row.label, paper),
                row.says,
                _claim(row, typesetter),
                _evidence(row, decision, typesetter),
                f"`{row.corrected_by}`" if row.corrected_by else "",
            )
            for row, decision in outcome.rows
            if _is_defect(row, decision)
        ),
    )


def _evidence(row: Obligation, decision: Decision, typesetter: Typesetter) -> str:
    """The numbers that show a row, or the values at which it is false."""
    sides = sides_of(row, decision)
    if sides is not None and isinstance(row.claim, Claim):
        sign = _SIGNS[row.claim.relation]
        return f"{short(sides[0])} {sign} {short(sides[1])}"
    return "at " + witness_text(decision, typesetter) if decision.witness else ""


def witness_text(decision: Decision, typesetter: Typesetter) -> str:
    """The values at which a claim about all values is false."""
    pairs = decision.witness.items()
    return ", ".join(f"{typesetter.term(symbol(n))} = {typesetter.term(t)}" for n, t in pairs)


def _rows(outcome: Outcome, rows: Iterable[Row], paper: Publication) -> Iterator[str]:
    typesetter = letters(outcome)
    yield from table(
        ("Verdict", "Name", "Label", "Step", "Claim", "Left and right", "By"),
        (
            (
                decision.verdict + ("" if row.role == NEEDED else f" ({row.role})"),
                f"`{short_name(row)}`",
                marked(row.label, paper),
                row.says,
                _claim(row, typesetter),
                _evidence(row, decision, typesetter),
                decision.method,
            )
            for row, decision in rows
        ),
    )


def _claim(row: Obligation, typesetter: Typesetter) -> str:
    return _short_claim(row.claim, typesetter)


# --- constants -----------------------------------------------------------------------------------


def _constants(outcome: Outcome, paper: Publication) -> Iterator[tuple[str, ...]]:
    typesetter = letters(outcome)
    bounds = paper.notes().bounds if _is_theorem_1(outcome, paper) else {}
    for constant in outcome.statement.constants:
        group = constant.name.rpartition(".")[0]
        sign, bound = bounds.get(constant.name, ("=", constant))
        text = f"{sign} {typesetter.term(bound.term)}{_minimum(outcome, constant)}"
        letter = constant.letter + (f" ({group})" if group else "")
        yield letter, _short(ends_of(outcome, constant.name)), text


def _minimum(outcome: Outcome, constant: Constant) -> str:
    if constant.term.op != "min":
        return ""
    number = minimum_of(outcome, constant).least
    return "" if number is None else f" (entry {number} is the least)"


def _short(ends: Ends | None) -> str:
    return "undefined" if ends is None else short(ends)


# --- Markdown ------------------------------------------------------------------------------------


def marked(label: str, paper: Publication) -> str:
    """A label of the paper, after the number that is printed there; nothing for no label."""
    number = paper.printed(label)
    if not label:
        return ""
    return f"`{label}`" if number is None else f"{number} `{label}`"


def section(title: str) -> Iterator[str]:
    """A heading between empty lines."""
    yield from ("", f"## {title}", "")


def table(head: tuple[str, ...], rows: Iterable[tuple[str, ...]]) -> Iterator[str]:
    """A table; bars inside a cell are escaped."""
    yield f"| {' | '.join(head)} |"
    yield f"|{'---|' * len(head)}"
    for row in rows:
        cells = (cell.replace("|", "\\|") for cell in row)
        yield f"| {' | '.join(cells)} |"
