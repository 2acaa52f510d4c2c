"""The first screen: the theorem, what is proved and what is not, and how to check it oneself."""

from __future__ import annotations

from collections.abc import Iterator, Sequence

from verify.language.statement import PROVED, REFUTED, REPAIRED, Publication
from verify.language.terms import Claim
from verify.prover.outcome import Outcome
from verify.views.everywhere import THEOREM as EVERYWHERE_IN_WORDS
from verify.views.material import CertifiedOutcome, Material
from verify.views.page.blocks import (
    Block,
    Box,
    Button,
    Cell,
    Commands,
    Facts,
    Link,
    Paragraph,
    Strong,
    Text,
)
from verify.views.page.writer import rows_as_printed, with_verdict
from verify.views.point import in_numbers, place
from verify.views.words import CONDITIONALLY_PROVED, given_by, headline, in_letters


def result(material: Material, others: Sequence[CertifiedOutcome]) -> Iterator[Block]:
    """The theorem, and the verdicts on it."""
    main, paper = material.main, material.paper
    repaired, printed = main.of_group(REPAIRED), rows_as_printed(main)
    proved, refuted = with_verdict(repaired, PROVED), with_verdict(printed, REFUTED)
    alone = [row for row, _ in refuted if row.name.startswith("printed.alone-")]
    closing = [row for row, _ in proved if isinstance(row.claim, Claim)]
    for folder in material.about(material.plotted.region.everywhere.statement.theorem):
        if headline(folder.outcome) == PROVED:
            yield Box("The theorem, repaired", [Text(EVERYWHERE_IN_WORDS)])
    yield Facts([
        (headline(main), [
            Strong("The theorem holds with repaired constants. "),
            Text(f"At {place(main)} all {len(closing)} inequalities that close the proof are "
                 "proved, and so is that the step applies to them; given "
                 f"{given_by(main, paper)}, "),
            Link("#assumptions", "listed below"), Text("."),
        ]),
        (REFUTED, [
            Strong("The proof as printed does not close. "),
            Text(f"{len(refuted)} of its {len(printed)} rows are refuted there, {len(alone)} of "
                 "them ask of one entry of a minimum alone what the text claims of the whole "
                 "minimum; each is "),
            Link("#printed", "listed with both sides and its repair"), Text("."),
        ]),
        *_conditional(others, paper),
    ])  # fmt: skip


def _conditional(
    others: Sequence[CertifiedOutcome], paper: Publication
) -> Iterator[tuple[str, Cell]]:
    """What is proved from more than definitions, general mathematics and numbered glue."""
    for folder in others:
        if headline(folder.outcome) == CONDITIONALLY_PROVED:
            yield (
                CONDITIONALLY_PROVED,
                [
                    Strong(f"{title_of(folder.outcome)}: "),
                    Text(f"given {given_by(folder.outcome, paper)} ("),
                    Link(f"#{folder.name}", "list"),
                    Text("). Everything else on this page is complete, given what it names."),
                ],
            )


def command() -> Iterator[Block]:
    """The button, and what it leads to in one line."""
    yield Paragraph([
        Button("#check", "Check it yourself"),
        Text(" with nothing but Python, in the folder of the project:"),
    ])  # fmt: skip
    yield Commands(["python3 -I verify/check.py certificates/theorem1-all certificates/step"])


def numbers(main: Outcome) -> Iterator[Block]:
    """The theorem at the point of the main job."""
    found = in_numbers(main)
    if found is not None:
        yield Box("Theorem 1, in numbers", [Text(found)])


def title_of(outcome: Outcome) -> str:
    """The title of a theorem as the start of a sentence."""
    title = in_letters(outcome.statement.title)
    return title[:1].upper() + title[1:]
