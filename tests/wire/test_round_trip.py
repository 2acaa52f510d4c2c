"""What is written and read back is the same outcome, and every view says the same of it."""

from __future__ import annotations

import json
from fractions import Fraction
from functools import cache

import pytest

from tests.citing import cited
from tests.points import parameters
from verify.language.terms import cos_pi
from verify.paper.commands import pages, spectrum, theorem1
from verify.paper.source import PAPER
from verify.prover.outcome import Outcome
from verify.views import document, markdown, row_lists, table, words
from verify.views import spectrum as spectral
from verify.wire.judge import judged
from verify.wire.judge import read_judged as read
from verify.wire.term_json import WireError
from verify.wire.write import write

OUTCOMES = ["proved", "printed", "refuted", "cosine", "spectrum"]


@cache
def fresh(name: str) -> Outcome:
    point = parameters("3/100", "1")
    match name:
        case "proved":
            return judged(theorem1.decide_point(point))
        case "printed":
            return judged(theorem1.decide_point(point, "printed"))
        case "refuted":
            return judged(theorem1.decide_point(parameters("1/2", "1")))
        case "cosine":
            angle = -cos_pi(Fraction(5, 6))
            return judged(
                theorem1.decide_point(parameters("1/1000", "1") | {"c": angle}, "repaired")
            )
    return pages.accepted(spectrum.PAGE)


@cache
def files(name: str) -> tuple[bytes, bytes]:
    written = write(fresh(name))
    return written["statement.json"], written["certificate.json"]


def again(name: str) -> Outcome:
    return read(*files(name), cited(write(fresh(name))))


@pytest.mark.parametrize("name", OUTCOMES)
def test_reading_is_the_inverse_of_writing(name: str) -> None:
    assert again(name) == fresh(name)
    assert write(again(name)) == write(fresh(name))


@pytest.mark.parametrize("name", OUTCOMES)
def test_views_say_the_same_of_what_is_read_back(name: str) -> None:
    one, two = fresh(name), again(name)
    views = [lambda o: markdown.report(o, PAPER), *(
        (lambda o: spectral.spectrum_document(o), lambda o: [*row_lists.all_rows(o, PAPER)],
         lambda o: spectral.verdict_line(o, PAPER))
        if name == "spectrum"
        else (document.document, lambda o: [*table.report_lines(o, PAPER)])
    )]  # fmt: skip
    for view in views:
        assert view(one) == view(two)


@pytest.mark.parametrize("name", OUTCOMES)
def test_views_agree_on_the_verdict(name: str) -> None:
    outcome = fresh(name)
    if name == "spectrum":
        found, last = (
            spectral.spectrum_document(outcome),
            spectral.verdict_line(outcome, PAPER),
        )
    else:
        found, last = document.document(outcome), [*table.report_lines(outcome, PAPER)][-1]
    assert last.startswith(f"Verdict: {found['headline']}: ")
    told = words.summary(outcome, PAPER)
    assert last.endswith(told.partition(f": {outcome.statement.title}: ")[2])
    assert found["headline"] in markdown.report(outcome, PAPER)


@pytest.mark.parametrize(
    ("old", "new"),
    [
        (b'"rule": "sum"', b'"rule": "magic"'),
        (b'"obligation": ', b'"oblation": '),
        (b'"ends": ["', b'"ends": ["x'),
        (b'"proof": 224', b'"proof": "224"'),
    ],
)
def test_other_files_are_no_outcome(old: bytes, new: bytes) -> None:
    first, second = files("proved")
    assert old in second
    with pytest.raises(WireError):
        read(first, second.replace(old, new, 1), cited(write(fresh("proved"))))


@pytest.mark.parametrize("content", [b"", b"{}", b"[]", b"null", b"\xff", b"[" * 5000])
def test_no_statement_at_all(content: bytes) -> None:
    with pytest.raises(WireError):
        read(content, files("refuted")[1], {})
    with pytest.raises(WireError):
        read(files("refuted")[0], content, {})


def test_files_have_sorted_keys_and_end_with_a_line_feed() -> None:
    for content in files("proved"):
        assert content.endswith(b"}\n")
        keys = list(json.loads(content))
        assert keys == sorted(keys)
