"""What `tests.coq.fuzz` gives to both readers of JSON, where no Coq is needed."""

from __future__ import annotations

import pytest

from tests.coq.fuzz import LAXER, READING, ROOT, anything, broken, wanted
from verify import check


def test_some_broken_documents_are_read_and_some_are_not() -> None:
    found = [*broken(1000)]
    accepted = sum(wanted(data) is not None for data in found)
    assert len(found) / 4 < accepted < len(found) * 3 / 4


@pytest.mark.parametrize(("line", "other"), LAXER)
def test_what_makes_a_reader_laxer_is_there_once(line: str, other: str) -> None:
    texts = [(ROOT / f"verify/coq/{name}.v").read_text() for name in READING]
    assert sum(text.count(line) for text in texts) == 1


def test_the_checker_refuses_escapes_with_other_signs() -> None:
    with pytest.raises(check.Malformed):
        check.parsed("document", rb'"\u0_41"', anything)
