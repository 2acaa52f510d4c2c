"""What the report says, in the order in which a referee asks."""

from __future__ import annotations

from collections.abc import Iterator, Mapping, Sequence

from verify.jobs.report import CertifiedOutcome, Material
from verify.language.statement import NEEDED, PROVED, REFUTED, UNDECIDED, Constant
from verify.language.statement import PRINTED as PRINTED_ROLE
from verify.language.terms import Claim, symbol
from verify.paper.glossary import LETTERS
from verify.paper.groups import PRINTED, REPAIRED
from verify.paper.parameters import THEOREM
from verify.paper.source import AUTHORS, COMPANION
from verify.paper.source import TITLE as PAPER_TITLE
from verify.prover.outcome import Outcome
from verify.views.everywhere import THEOREM as EVERYWHERE_IN_WORDS
from verify.views.markdown import bound_of_each
from verify.views.page import blueprint
from verify.views.page.appendix import assumptions, digests, measurements
from verify.views.page.blocks import (
    Block,
    Box,
    Cell,
    Code,
    Commands,
    Drawing,
    Facts,
    Heading,
    Link,
    Math,
    Paragraph,
    RefutedSteps,
    Source,
    Strong,
    Table,
    Text,
    Verdict,
)
from verify.views.page.constants import latex
from verify.views.page.defects import card, changes, printed_proof
from verify.views.page.writer import (
    Writer,
    cell,
    label_cell,
    number_of,
    plain_rows,
    rows_as_printed,
    with_verdict,
)
from verify.views.plots.figure import Figure
from verify.views.plots.letters import letters_drawing
from verify.views.point import in_numbers, place
from verify.views.words import (
    CONDITIONALLY_PROVED,
    constants_of,
    counts,
    ends_of,
    given_by,
    headline,
)

TITLE = "Three particles collapse: what is proved"
SUBTITLE = (
    f"{AUTHORS}, {PAPER_TITLE} (its companion is {COMPANION}): Theorem 1 and the spectrum of its "
    "linear model, every inequality decided in rigorous arithmetic."
)
EVERYWHERE = f"{THEOREM} for all parameters"

#: Where the scenes are: a folder of folders.
SCENES = "scenes/"


def content(
    material: Material, drawings: Mapping[str, Sequence[str]], figures: Sequence[Figure]
) -> list[Block]:
    """The blocks of the page; ``drawings`` has the panels of each figure that was drawn."""
    drawn = [Drawing(figure, drawings.get(figure.name, ())) for figure in figures]
    main = material.about(THEOREM)[0].outcome
    writer = Writer(main)
    return [
        *_result(material, main),
        *_command(),
        drawn[0],
        *_numbers(main),
        *_recheck(material),
        *_letters(bool(drawings)),
        *_proof(material, main, bool(drawings)),
        *printed_proof(writer),
        *changes(),
        *_others_in_short(material),
        *_scenes(material),
        *_constants(writer),
        *_points(material),
        Heading("plots", "Plots"),
        Paragraph([Text(
            "Nothing here is a sample: each band and each box encloses the values at every point "
            "of its interval or cell (ball arithmetic with the mean value theorem), and what "
            "enclosures do not decide is drawn as undecided."
        )]),
        *drawn[1:4],
        *assumptions(material),
        *_other_theorems(material),
        *measurements(material, drawn[4:]),
        *digests(material),
    ]  # fmt: skip


# --- the first screen ----------------------------------------------------------------------------


def _result(material: Material, main: Outcome) -> Iterator[Block]:
    repaired, printed = main.of_group(REPAIRED), rows_as_printed(main)
    proved, refuted = with_verdict(repaired, PROVED), with_verdict(printed, REFUTED)
    closing = [row for row, _ in proved if isinstance(row.claim, Claim)]
    for folder in material.about(EVERYWHERE):
        if headline(folder.outcome) == PROVED:
            yield Box("The theorem, repaired", [Text(EVERYWHERE_IN_WORDS)])
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
        *_conditional(material),
    ])  # fmt: skip


def _command() -> Iterator[Block]:
    yield Paragraph([
        Text("Check it yourself, with nothing but Python, in the folder of the project ("),
        Link("#check", "what that does"), Text("):"),
    ])  # fmt: skip
    yield Commands(["python3 -I verify/check.py certificates/theorem1-all certificates/step"])


def _numbers(main: Outcome) -> Iterator[Block]:
    numbers = in_numbers(main)
    if numbers is not None:
        yield Box("Theorem 1, in numbers", [Text(numbers)])


def _conditional(material: Material) -> Iterator[tuple[str, Cell]]:
    """What is proved from more than definitions, general mathematics and numbered glue."""
    for folder in _others(material):
        if headline(folder.outcome) == CONDITIONALLY_PROVED:
            yield (
                CONDITIONALLY_PROVED,
                [
                    Strong(f"{_title(folder.outcome)}: "),
                    Text(f"given {given_by(folder.outcome)} ("),
                    Link(f"#{folder.name}", "list"),
                    Text("). Everything else on this page is complete, given what it names."),
                ],
            )


def _recheck(material: Material) -> Iterator[Block]:
    yield Heading("check", "Check it yourself")
    yield Paragraph([
        Text("You need not believe the program. What it claims and how each claim is proved are "
             "files, and "), Code("verify/check.py"),
        Text(", which needs nothing but Python's standard library and searches for nothing, "
             "checks them: at a point, for all parameters, and the step for every state. "
             f"This page was written after it accepted all {len(material.folders)} certificates. "
             "With the program installed, "), Code("verify check --statement FOLDER"),
        Text(" also makes the statement anew and compares it byte for byte, and "),
        Code("verify report --compare"), Text(" does so with the numbers of this page."),
    ])  # fmt: skip


# --- letters, and the proof as a graph -----------------------------------------------------------


def _letters(draw: bool) -> Iterator[Block]:
    yield Heading("letters", "The letters")
    caption = "Three spheres just after a collision of 0 and s; the next one is that of 0 and c."
    figure = Figure("letters", "A state just after a collision", caption, ())
    yield Drawing(figure, [letters_drawing()] if draw else [])
    rows = [([Text(item.letter)], [Text(item.says)], label_cell(item.label)) for item in LETTERS]
    yield Table("What each letter stands for", ("Letter", "Meaning", "Paper"), rows, folded=True)


def _proof(material: Material, main: Outcome, draw: bool) -> Iterator[Block]:
    found = material.about(EVERYWHERE)
    if not found:
        return
    yield Heading("proof", "The proof as a graph")
    outcome = found[0].outcome
    caption = (
        f"Each box is a formula of the paper, by its printed number; lines lead down from what it "
        f"rests on. A box leads to its rows. Hatched: printed steps with this label are refuted "
        f"at {place(main)}. All facts, {len(outcome.steps)} steps of the certificate, one by one: "
        "verify graph --out proof.svg."
    )
    figure = Figure("proof", "Theorem 1, repaired, for all parameters", caption, ())
    yield Drawing(figure, [blueprint.proof_drawing(outcome, main)] if draw else [])


# --- other theorems ------------------------------------------------------------------------------


def _title(outcome: Outcome) -> str:
    """The title of a theorem as the start of a sentence."""
    title = outcome.statement.title
    for plain, letter in (("delta_theta", "δ_θ"), ("theta_0", "θ₀"), ("V_0", "V₀"), ("<=", "≤")):
        title = title.replace(plain, letter)
    return title[:1].upper() + title[1:]


def _others(material: Material) -> list[CertifiedOutcome]:
    return [
        folder
        for folder in material.folders
        if folder.outcome.statement.theorem != THEOREM and not folder.name.startswith(SCENES)
    ]


def _others_in_short(material: Material) -> Iterator[Block]:
    others = _others(material)
    if not others:
        return
    yield Heading("others", "What else is proved")
    rows: list[list[Cell]] = []
    for folder in others:
        outcome = folder.outcome
        claims = (counts(outcome, NEEDED), counts(outcome, PRINTED_ROLE))
        rows.append([
            [Link(f"#{folder.name}", _title(outcome))],
            [Verdict(headline(outcome))],
            [Text("; ".join(part for part in claims if part))],
            [Text(given_by(outcome))],
        ])  # fmt: skip
    yield Table("Theorems for all values", ("Theorem", "Verdict", "Claims", "Given"), rows)


def _scenes(material: Material) -> Iterator[Block]:
    scenes = [folder for folder in material.folders if folder.name.startswith(SCENES)]
    if not scenes:
        return
    yield Heading("scenes", "Scenes: what happens to three given particles")
    rows: list[list[Cell]] = [
        [
            [Link(f"{folder.name}/report.md", folder.name.removeprefix(SCENES))],
            [Text(_title(folder.outcome))],
            [Verdict(headline(folder.outcome))],
            [Text(counts(folder.outcome, NEEDED))],
        ]
        for folder in scenes
    ]
    yield Table("Certificates of scenes", ("Scene", "What is proved", "Verdict", "Claims"), rows)


def _other_theorems(material: Material) -> Iterator[Block]:
    if _others(material):
        yield Heading("rows", "The other theorems, row by row")
    for folder in _others(material):
        outcome = folder.outcome
        yield Heading(folder.name, _title(outcome), 3)
        writer = Writer(outcome)
        refuted = with_verdict(outcome.rows, REFUTED)
        others = [(row, found) for row, found in outcome.rows if found.verdict != REFUTED]
        if refuted:
            yield Paragraph([Text(
                f"{len(refuted)} printed claims are refuted; each has a point at which it is false "
                "in the certificate, and the claim that takes its place:"
            )])  # fmt: skip
            yield RefutedSteps([card(writer, *pair) for pair in refuted])
        open_ones = with_verdict(others, UNDECIDED)
        rest = f", and {len(open_ones)} are undecided" if open_ones else ""
        yield Paragraph([Text(
            f"{len(with_verdict(others, PROVED))} claims are proved, each by a rule of the "
            f"checker{rest}."
        )])  # fmt: skip
        yield plain_rows(writer, f"The {len(others)} claims, one by one", others)


# --- numbers -------------------------------------------------------------------------------------


def _constants(writer: Writer) -> Iterator[Block]:
    outcome = writer.outcome
    yield Heading("constants", f"Constants at {place(outcome)}")
    yield Paragraph([Text(
        "Certified enclosures; touch a number for both ends (elsewhere they are its tooltip). The "
        "repaired constants are chosen: short decimals on the safe side of their bounds, so they "
        "are exact."
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
    number = number_of(ends_of(writer.outcome, constant.name), unfolds=True)
    return [[letter], cell(number), [definition], label_cell(constant.label)]


def _points(material: Material) -> Iterator[Block]:
    yield Heading("points", "The same at other points")
    rows: list[list[Cell]] = []
    for folder in material.about(THEOREM):
        outcome = folder.outcome
        printed = rows_as_printed(outcome)
        rows.append([
            [Link(f"{folder.name}/report.md", place(outcome))],
            [Verdict(headline(outcome))],
            [Text(f"{len(with_verdict(outcome.of_group(REPAIRED), PROVED))} proved")],
            [Text(f"{len(with_verdict(printed, REFUTED))} of {len(printed)}")],
            *(cell(number_of(ends_of(outcome, f"{REPAIRED}.{name}")))
              for name in ("delta_x", "eta_bar", "zeta_bar", "T_star")),
        ])  # fmt: skip
    yield Table(
        "Certificates of Theorem 1",
        ("Point", "Verdict", "Repaired rows", "Printed steps refuted", "δ_x", "η̄", "ζ̄", "T*"),
        rows,
    )
