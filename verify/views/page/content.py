"""What the report says, in the order in which a referee asks."""

from __future__ import annotations

from collections.abc import Iterable, Iterator, Mapping, Sequence
from typing import Any

from verify import __version__
from verify.jobs.report import CertifiedOutcome, Material
from verify.language.statement import (
    NEEDED,
    PROVED,
    REFUTED,
    UNDECIDED,
    Always,
    Applies,
    Assumption,
    Constant,
    Obligation,
)
from verify.language.statement import PRINTED as PRINTED_ROLE
from verify.language.terms import Claim, Term, symbol
from verify.paper.groups import HYPOTHESES, PRINTED, REPAIRED
from verify.paper.parameters import THEOREM
from verify.paper.theorem1 import theorem
from verify.prover.decimals import outward, short
from verify.prover.outcome import Decision, Ends, Outcome
from verify.views.markdown import bound_of_each, witness_text
from verify.views.mathml import MathML
from verify.views.page.blocks import (
    Block,
    Box,
    Cell,
    Code,
    Commands,
    Drawing,
    Facts,
    Heading,
    Items,
    Link,
    Math,
    Number,
    Paragraph,
    Raw,
    RefutedStep,
    RefutedSteps,
    Source,
    Strong,
    Table,
    Text,
    Verdict,
)
from verify.views.plots.figure import Figure
from verify.views.point import in_numbers, place
from verify.views.words import (
    constants_of,
    counts,
    ends_of,
    given_by,
    headline,
    letters,
    sides_of,
)
from verify.wire.write import decimals

Row = tuple[Obligation, Decision]

TITLE = "Three particles collapse: what is proved"
SUBTITLE = (
    "Dolmaire and Velázquez, Collapse of inelastic hard spheres in dimension d ≥ 2: Theorem 1 and "
    "the spectrum of its linear model, every inequality decided in rigorous arithmetic."
)

#: Formulas with more letters than this stay in the statement file.
LONGEST = 400

#: A min with more entries than this is written one entry a line.
MANY = 2

#: A table with more rows than this is folded.
UNFOLDED = 16


def content(
    material: Material, drawings: Mapping[str, Sequence[str]], figures: Sequence[Figure]
) -> list[Block]:
    """The blocks of the page; ``drawings`` has the panels of each figure that was drawn."""
    drawn = [Drawing(figure, drawings.get(figure.name, ())) for figure in figures]
    main = material.about(THEOREM)[0].outcome
    writer = Writer(main)
    return [
        *_result(material, main),
        drawn[0],
        *_recheck(material),
        *_printed_proof(writer),
        *_changes(),
        *_constants(writer),
        *_points(material),
        *_other_theorems(material),
        Heading("plots", "Plots"),
        Paragraph([Text(
            "Nothing here is a sample: each band and each box encloses the values at every point "
            "of its interval or cell (ball arithmetic with the mean value theorem), and what "
            "enclosures do not decide is drawn as undecided."
        )]),
        *drawn[1:],
        *_measurements(material),
        *_assumptions(material),
        *_digests(material),
    ]  # fmt: skip


class Writer:
    """Formulas and numbers of one outcome."""

    def __init__(self, outcome: Outcome) -> None:
        self.outcome = outcome
        self.typesetter = letters(outcome)
        statement = outcome.statement
        tex = {constant.name: constant.tex for constant in statement.constants}
        for context in statement.contexts:
            tex |= {variable.name: variable.tex for variable in context.variables}
            tex |= {constant.name: constant.tex for constant in context.constants}
        self._mathml = MathML(tex | ({"c": r"(-\cos\theta_0)"} if statement.parameters else {}))
        self.rows = {row.name: (row, found) for row, found in outcome.rows}

    def claim(self, claim: Claim | Applies | Always) -> Math | Text | None:
        """A claim, unless it is too long to be read."""
        text = self.typesetter.claim(claim)
        if len(text) > LONGEST:
            return None
        return Math(self._mathml.claim(claim), text) if isinstance(claim, Claim) else Text(text)

    def term(self, term: Term, before: str = "") -> Math:
        """A term after a relation."""
        text = f"{before} {self.typesetter.term(term)}".strip()
        if term.op == "min" and len(term.children) > MANY:
            return Math(self._mathml.entries(term, before), text)
        return Math(self._mathml.term(term, before), text)


def _number(ends: Ends | None, digits: int = 8) -> Number | None:
    """An enclosure with both ends as they stand in the certificate."""
    if ends is None:
        return None
    low, high = decimals(ends)
    return Number(short(ends, digits), (low, high))


def _sides(row: Obligation, found: Decision) -> tuple[Number | None, Number | None]:
    sides = sides_of(row, found)
    return (None, None) if sides is None else (_number(sides[0]), _number(sides[1]))


def _cell(*parts: Math | Number | Text | None) -> Cell:
    return [part for part in parts if part is not None]


def _with(rows: Iterable[Row], verdict: str) -> list[Row]:
    return [(row, found) for row, found in rows if found.verdict == verdict]


def _of_role(rows: Iterable[Row], role: str) -> list[Row]:
    return [(row, found) for row, found in rows if row.role == role]


def _printed(outcome: Outcome) -> list[Row]:
    return _of_role(outcome.of_group(HYPOTHESES, PRINTED), PRINTED_ROLE)


def _result(material: Material, main: Outcome) -> Iterator[Block]:
    repaired, printed = main.of_group(REPAIRED), _printed(main)
    proved, refuted = _with(repaired, PROVED), _with(printed, REFUTED)
    closing = [row for row, _ in proved if isinstance(row.claim, Claim)]
    yield Facts([
        (headline(main), [
            Strong("The theorem holds with repaired constants. "),
            Text(f"At {place(main)} all {len(closing)} inequalities that close the proof are "
                 "proved, and so is that the step applies to them; given "
                 f"{given_by(main)}, "),
            Link("#trust", "listed below"), Text("."),
        ]),
        (REFUTED, [
            Strong("The proof as printed does not close. "),
            Text(f"{len(refuted)} of its {len(printed)} steps, taken one by one, are refuted "
                 "there; each is "),
            Link("#printed", "listed with both sides and its repair"), Text("."),
        ]),
        *_other_facts(material),
    ])  # fmt: skip
    numbers = in_numbers(main)
    if numbers is not None:
        yield Box("Theorem 1, in numbers", [Text(numbers)])


def _other_facts(material: Material) -> Iterator[tuple[str, Cell]]:
    for folder in _others(material):
        outcome = folder.outcome
        parts = [
            f"Claims: {counts(outcome, NEEDED)}, given {given_by(outcome)}",
            counts(outcome, PRINTED_ROLE),
        ]
        yield (
            headline(outcome),
            [
                Strong(f"{_title(outcome)}. "),
                Text(f"{'; '.join(part for part in parts if part)} ("),
                Link(f"#{folder.name}", "list"),
                Text(")."),
            ],
        )


def _title(outcome: Outcome) -> str:
    """The title of a theorem as the start of a sentence."""
    title = outcome.statement.title
    return title[:1].upper() + title[1:]


def _others(material: Material) -> list[CertifiedOutcome]:
    return [f for f in material.folders if f.outcome.statement.theorem != THEOREM]


def _recheck(material: Material) -> Iterator[Block]:
    yield Heading("check", "Check it yourself")
    yield Paragraph([
        Text("The program need not be believed. It writes what it claims and how each claim is "
             "proved into two files, and "), Code("verify/check.py"),
        Text(", one file that needs nothing but Python's standard library and searches for "
             "nothing, checks them again. This page was written after it accepted all "
             f"{len(material.folders)} certificates. One command does the same, in the folder "
             "of the project:"),
    ])  # fmt: skip
    yield Commands(
        [
            "for file in certificates/*/statement.json",
            'do python3 -I verify/check.py "${file%/*}" | tail -n 1',
            "done",
        ]
    )
    yield Paragraph([
        Text("With the program installed, "), Code("verify check --statement FOLDER"),
        Text(" also makes the statement anew and compares it byte for byte, and "),
        Code("verify report --compare"), Text(" does so with the numbers of this page."),
    ])  # fmt: skip


def _printed_proof(writer: Writer) -> Iterator[Block]:
    printed = _printed(writer.outcome)
    refuted, holding = _with(printed, REFUTED), _with(printed, PROVED)
    undecided = _with(printed, UNDECIDED)
    yield Heading("printed", f"The printed proof: {len(refuted)} steps refuted")
    yield Paragraph([Text(
        f"At {place(writer.outcome)}, in the paper's order. Each step is judged at the worst state "
        f"that the printed set allows. A refuted one comes with certified enclosures of both sides "
        f"(the digits shown are those on which both ends agree; touch a number for its ends) and "
        f"with the row that takes its place. A step that names its own r and θ₀ is an implication, "
        f"refuted by an exact counterexample."
    )])  # fmt: skip
    yield RefutedSteps([_step(writer, *pair) for pair in refuted])
    yield _rows_table(writer, f"The {len(holding)} printed steps that hold", holding)
    if undecided:
        yield _rows_table(writer, f"The {len(undecided)} undecided printed steps", undecided)
    repaired = writer.outcome.of_group(REPAIRED)
    yield _rows_table(writer, f"The {len(repaired)} rows of the repaired proof", repaired)
    needed = _of_role(writer.outcome.of_group(HYPOTHESES), NEEDED)
    yield _rows_table(writer, f"The {len(needed)} hypotheses", needed)


def _step(writer: Writer, row: Obligation, found: Decision) -> RefutedStep:
    claim = writer.claim(row.claim)
    lhs, rhs = _sides(row, found)
    return RefutedStep(
        row.name,
        row.label,
        row.says,
        claim if isinstance(claim, Math) else Math("", "in the statement file"),
        lhs,
        rhs,
        _margin(writer, row, found),
        _repair(writer, row),
    )


def _margin(writer: Writer, row: Obligation, found: Decision) -> Cell:
    """An enclosure of right - left, from the certified ends of both; or where the claim fails."""
    sides = sides_of(row, found)
    if sides is None:
        where = witness_text(found, writer.typesetter) if found.witness else ""
        return [Text(f"(false at {where})" if where else "")]
    lhs, rhs = sides
    margin = (rhs[0] - lhs[1], rhs[1] - lhs[0])
    low, high = outward(margin, 20)
    return [Number(short(margin, 4), (low, high))]


def _repair(writer: Writer, row: Obligation) -> Cell:
    other = writer.rows.get(row.corrected_by or "")
    if other is None and row.corrected_by:
        return [
            Text("Corrected by "),
            Code(row.corrected_by),
            Text(", a row of another statement."),
        ]
    if other is None:
        return [Text("No repair is needed: nothing rests on it.")]
    needed, found = other
    parts: list[Any] = [
        Verdict(found.verdict), Text(" "), Code(needed.name), Text(f": {needed.says}")
    ]  # fmt: skip
    claim = writer.claim(needed.claim)
    if claim is not None:
        parts += [Text(", "), claim]
    lhs, rhs = _sides(needed, found)
    if lhs is not None and rhs is not None and isinstance(needed.claim, Claim):
        sign = "≤" if needed.claim.relation == "<=" else needed.claim.relation
        parts += [Text(": "), lhs, Text(f" {sign} "), rhs]
    return parts


def _rows_table(writer: Writer, title: str, rows: Sequence[Row], folded: bool = True) -> Table:
    sides = any(sides_of(row, found) is not None for row, found in rows)
    head = ["Verdict", "Label", "Step", "Claim", *(("Left", "Right") if sides else ("Proof",))]
    return Table(title, head, [_row(writer, *pair, sides) for pair in rows], folded)


def _row(writer: Writer, row: Obligation, found: Decision, sides: bool) -> list[Cell]:
    claim = writer.claim(row.claim)
    first: list[Cell] = [
        [Verdict(found.verdict)],
        [Code(row.label)],
        [Text(row.says)],
        [Text("(long: see the statement file)") if claim is None else claim],
    ]
    if not sides:
        return [*first, [Text(found.method)]]
    lhs, rhs = _sides(row, found)
    return [*first, _cell(lhs), _cell(rhs)]


def _changes() -> Iterator[Block]:
    yield Heading("changes", "What is changed")
    yield Table(
        "Paper, needed, why",
        ("Label", "Paper", "Needed", "Why"),
        [
            ([Code(c.label)], [Text(c.paper)], [Text(c.needed)], [Text(c.why)])
            for c in theorem().changes
        ],
    )


def _constants(writer: Writer) -> Iterator[Block]:
    outcome = writer.outcome
    yield Heading("constants", f"Constants at {place(outcome)}")
    yield Paragraph([Text(
        "Certified enclosures; touch a number for both ends. The repaired constants are chosen: "
        "short decimals on the safe side of their bounds, so they are exact."
    )])  # fmt: skip
    bounds = bound_of_each()
    groups = {
        "": "The first constants",
        PRINTED: "The set as printed",
        REPAIRED: "The repaired set",
    }
    for group, title in groups.items():
        rows = []
        for constant in constants_of(outcome, group):
            sign, bound = bounds[constant.name]
            rows.append(_constant(writer, constant, writer.term(bound.term, sign)))
        yield Table(title, ("Constant", "Value", "Definition or bound", "Label"), rows)
    yield Source("The constants as a LaTeX table (also in constants.tex)", latex(outcome))


def _constant(writer: Writer, constant: Constant, definition: Math) -> list[Cell]:
    letter = writer.term(symbol(constant.name))
    number = _number(ends_of(writer.outcome, constant.name))
    return [[letter], _cell(number), [definition], [Code(constant.label)]]


def _points(material: Material) -> Iterator[Block]:
    yield Heading("points", "The same at other points")
    rows: list[list[Cell]] = []
    for folder in material.about(THEOREM):
        outcome = folder.outcome
        printed = _printed(outcome)
        rows.append([
            [Link(f"{folder.name}/report.md", place(outcome))],
            [Verdict(headline(outcome))],
            [Text(f"{len(_with(outcome.of_group(REPAIRED), PROVED))} proved")],
            [Text(f"{len(_with(printed, REFUTED))} of {len(printed)}")],
            *(_cell(_number(ends_of(outcome, f"{REPAIRED}.{name}")))
              for name in ("delta_x", "eta_bar", "zeta_bar", "T_star")),
        ])  # fmt: skip
    yield Table(
        "Certificates of Theorem 1",
        ("Point", "Verdict", "Repaired rows", "Printed steps refuted", "δ_x", "η̄", "ζ̄", "T*"),
        rows,
    )


def _other_theorems(material: Material) -> Iterator[Block]:
    for folder in _others(material):
        outcome = folder.outcome
        yield Heading(folder.name, _title(outcome))
        writer = Writer(outcome)
        refuted = _with(outcome.rows, REFUTED)
        others = [(row, found) for row, found in outcome.rows if found.verdict != REFUTED]
        if refuted:
            yield Paragraph([Text(
                f"{len(refuted)} printed claims are refuted; each has a point at which it is false "
                "in the certificate, and the claim that takes its place:"
            )])  # fmt: skip
            yield RefutedSteps([_step(writer, *pair) for pair in refuted])
        yield Paragraph([Text(
            f"{len(_with(others, PROVED))} claims are proved, each by a rule of the checker, and "
            f"{len(_with(others, UNDECIDED))} are undecided. By label of the paper:"
        )])  # fmt: skip
        for label in dict.fromkeys(row.label for row, _ in others):
            rows = [(row, found) for row, found in others if row.label == label]
            yield _rows_table(writer, f"{label} ({len(rows)})", rows)


def _measurements(material: Material) -> Iterator[Block]:
    titles = {
        "bench": ("speed", "Speed", "verify bench"),
        "stress": ("stability", "Numerical stability on hard cases", "verify stress"),
    }
    for name, tables in material.measurements.items():
        anchor, title, command = titles[name]
        yield Heading(anchor, title)
        yield Paragraph([Text("As measured and committed; made anew by "), Code(command),
                         Text(".")])  # fmt: skip
        for table in tables.values():
            rows = [[[Raw(str(value))] for value in row] for row in table["rows"]]
            yield Table(table["title"], table["columns"], rows, len(rows) > UNFOLDED)


def _assumptions(material: Material) -> Iterator[Block]:
    yield Heading("trust", "Taken on trust")
    yield Paragraph([Text(
        "What is used and not proved by the program, here or in a statement that is cited. The "
        "checker prints the names with each verdict."
    )])  # fmt: skip
    seen: set[str] = set()
    for folder in material.folders:
        statement = folder.outcome.statement
        if statement.theorem not in seen:
            seen.add(statement.theorem)
            yield Paragraph([Strong("For "), Code(statement.theorem), Text(":")])
            yield Items([_assumption(a) for a in folder.outcome.assumptions])
            if folder.outcome.printed_assumptions:
                yield Paragraph([Text("and for its printed rows only:")])
                yield Items([_assumption(a) for a in folder.outcome.printed_assumptions])


def _assumption(assumption: Assumption) -> Cell:
    return [Code(assumption.label), Text(f" ({assumption.kind}): {assumption.sentence}")]


def _digests(material: Material) -> Iterator[Block]:
    yield Heading("versions", "Versions and digests")
    yield Paragraph([Text(f"verify-collapse {__version__}. SHA-256 of the files behind this page; "
                          "a certificate carries the digest of its statement.")])  # fmt: skip
    rows: list[list[Cell]] = [
        [[Code(f"{folder.name}/{file}")], [Code(digest)]]
        for folder in material.folders
        for file, digest in folder.digests.items()
    ]
    rows += [[[Code(file)], [Code(digest)]] for file, digest in material.digests.items()]
    yield Table("Files", ("File", "SHA-256"), rows, folded=True)


def latex(outcome: Outcome) -> str:
    """The constants as a LaTeX table: enclosures of the first and printed ones, repaired values."""
    lines = [
        f"% {outcome.statement.title}",
        "% Enclosures: the true value lies between the two ends.",
        r"\begin{tabular}{lll}",
        r"\hline",
        r"constant & as printed & repaired \\",
        r"\hline",
    ]
    repaired = {c.short_name: c.name for c in constants_of(outcome, REPAIRED)}
    first = [*constants_of(outcome, ""), *constants_of(outcome, PRINTED)]
    known = {constant.short_name for constant in first}
    only = [c for c in constants_of(outcome, REPAIRED) if c.short_name not in known]
    for constant in (*first, *only):
        printed = "" if constant in only else _tex_number(outcome, constant.name)
        other = _tex_number(outcome, repaired.get(constant.short_name, ""))
        lines.append(rf"${constant.tex}$ & {printed} & {other} \\")
    return "\n".join([*lines, r"\hline", r"\end{tabular}"]) + "\n"


def _tex_number(outcome: Outcome, name: str) -> str:
    """An exact decimal, or an interval of 8 digits that contains the enclosure."""
    ends = ends_of(outcome, name)
    if ends is None:
        return ""
    low, high = outward(ends, 8)
    if low == high:
        return f"${_tex_decimal(low)}$"
    return rf"$[{_tex_decimal(low)},\, {_tex_decimal(high)}]$"


def _tex_decimal(text: str) -> str:
    mantissa, _, exponent = text.partition("e")
    return mantissa if not exponent else rf"{mantissa}\cdot 10^{{{exponent}}}"
