"""What comes with the program is cited where its statement is the one asked for, and only there."""

from __future__ import annotations

from pathlib import Path

import pytest

from tests.bring import work_of
from tests.paper.spectrum.page import changed
from verify import check
from verify.cli import main
from verify.paper.commands import pages
from verify.paper.commands.spectrum import PAGE, cite_spectrum, state_spectrum
from verify.paper.parameters import ALL, AS_PRINTED
from verify.prover.outcome import Outcome
from verify.wire.judge import known
from verify.wire.packaged import PACKAGED, PACKAGED_FILES, packaged_files, packaged_work
from verify.wire.write import write

CERTIFICATES = Path(__file__).parents[2] / "certificates"


@pytest.mark.parametrize("name", sorted(PACKAGED_FILES.keys() - {AS_PRINTED}))
def test_what_comes_with_the_program_is_what_is_committed(name: str) -> None:
    """If not: python -m tests.bring."""
    for file, content in zip(PACKAGED_FILES[name], packaged_files(name), strict=True):
        assert (CERTIFICATES / name / file).read_bytes() == content
    assert {path.name for path in Path(PACKAGED, name).iterdir()} == set(PACKAGED_FILES[name])


@pytest.mark.parametrize("name", PACKAGED_FILES)
def test_its_work_is_what_the_checker_counts(name: str) -> None:
    """If not: python -m tests.bring."""
    files = packaged_files(name)
    assert packaged_work(*files) == work_of(*files)
    assert packaged_work(files[0], files[1] + b" ") is None


def test_the_printed_rows_come_as_they_are_decided() -> None:
    """If not: python -m tests.bring; there is no such folder among the committed certificates."""
    files = write(pages.decide("printed_rows"))
    assert packaged_files(AS_PRINTED) == (files["statement.json"], files["certificate.json"])
    assert check.check(*packaged_files(AS_PRINTED), {}).verdict == "PROVED"


def test_what_is_cited_is_what_would_be_proved() -> None:
    cited, decided = cite_spectrum(), pages.decide("spectrum")
    assert write(cited) == write(decided)
    assert cited.decisions.keys() == decided.decisions.keys()
    for name, found in decided.decisions.items():
        assert cited.decisions[name].verdict == found.verdict


def test_another_statement_is_not_known() -> None:
    said = state_spectrum()
    assert known(PAGE, said) is not None
    first, *others = said.obligations
    assert known(PAGE, said._replace(obligations=(first._replace(says="?"), *others))) is None
    assert known(PAGE, said._replace(obligations=tuple(others))) is None
    swapped = changed("a_2(r)*x^2 + a_1(r)*x + r^3", "a_1(r)*x^2 + a_2(r)*x + r^3")
    assert known(PAGE, swapped) is None
    assert known(ALL, said) is None


@pytest.mark.parametrize(
    ("words", "work"),
    [
        ("spectrum", "verify.paper.commands.pages.decide"),
    ],
)
def test_a_command_does_not_prove_again_what_comes_with_it(
    words: str, work: str, monkeypatch: pytest.MonkeyPatch
) -> None:
    def never() -> Outcome:
        raise AssertionError(work)

    monkeypatch.setattr(work, never)
    assert main(words.split()) == 0
