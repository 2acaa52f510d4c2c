"""Reports and LaTeX sources: the same from an outcome that is fresh and from its files."""

from __future__ import annotations

import re
from collections import Counter
from collections.abc import Callable
from functools import partial
from pathlib import Path

import pytest

from tests.citing import cited, cited_in
from tests.points import parameters
from verify.language.statement import PRINTED, PROVED, REFUTED
from verify.paper.commands import spectrum, theorem1
from verify.paper.source import PAPER
from verify.prover.decimals import short
from verify.prover.outcome import Outcome
from verify.publication import Publication
from verify.views.markdown import report
from verify.views.tex.article import part
from verify.views.tex.sentences import name
from verify.views.words import fair
from verify.wire.judge import read_judged as read
from verify.wire.write import write

CERTIFICATES = Path(__file__).parents[2] / "certificates"


def point() -> Outcome:
    return theorem1.decide_point(parameters("3/100", "1"))


@pytest.mark.parametrize("view", [report, partial(part, full=True)])
@pytest.mark.parametrize("decide", [point, spectrum.cite_spectrum])
def test_a_view_does_not_see_whether_an_outcome_is_fresh(
    decide: Callable[[], Outcome], view: Callable[[Outcome, Publication], str]
) -> None:
    outcome = decide()
    files = write(outcome)
    again = read(files["statement.json"], files["certificate.json"], cited(files))
    text = view(outcome, PAPER)
    assert text == view(again, PAPER)
    for row, _ in outcome.rows:
        assert row.label in text or name(row.label) in text
    assert text.count("{") == text.count("}")


def test_a_report_has_the_value_of_each_parameter() -> None:
    folder = CERTIFICATES / "scenes/bead"
    files = [(folder / name).read_bytes() for name in ("statement.json", "certificate.json")]
    scene = read(*files, cited_in(folder))
    for outcome in (point(), scene):
        table = report(outcome, PAPER).partition("## Parameters")[2].partition("\n## ")[0]
        rows = re.findall(r"(?m)^\| (.+) \| (\S+) \|$", table)[1:]
        values = [str(value.value) for value in outcome.statement.parameters.values()]
        assert sorted(value for _, value in rows) == sorted(values)
    assert "undefined" not in report(scene, PAPER)  # what was not asked for may be defined


def test_a_report_says_on_what_its_verdict_depends() -> None:
    """*Proved* alone would say that what is printed is proved, of which 13 rows are refuted."""
    outcome = point()
    found = Counter(fair(outcome, row, d) for row, d in outcome.rows if row.role == PRINTED)
    above = report(outcome, PAPER).partition("\n## ")[0]
    assert (
        f"{sum(found.values())} printed ({found[PROVED]} proved, {found[REFUTED]} refuted" in above
    )


def test_a_report_has_every_refuted_row_with_its_evidence() -> None:
    for outcome in (point(), spectrum.cite_spectrum()):
        text = report(outcome, PAPER)
        section = text[text.index("## What is printed") :].partition("\n## ")[0]
        refuted = [(row, d) for row, d in outcome.rows if fair(outcome, row, d) == REFUTED]
        assert len(refuted) == section.count("\n| ") - 1  # the head
        for row, decision in refuted:
            assert row.says.replace("|", "\\|") in section
            assert decision.sides is not None or decision.witness
            if decision.sides is not None:
                assert short(decision.sides.ends[0]) in section
