"""No lie passes, and each is answered by a line that says why."""

from __future__ import annotations

import pytest

from tests.check.support import answer
from tests.lies.lies import LIES, honest


def test_enough_lies() -> None:
    assert len(LIES) >= 300
    files = {lie.files() for lie in LIES.values()}
    assert len(files) > len(LIES) * 0.97  # some odd values are the same when they are written


def test_the_honest_pair_is_proved() -> None:
    code, lines = answer(honest())
    assert (code, lines[-1].partition(":")[0]) == (0, "PROVED")


@pytest.mark.parametrize("name", LIES)
def test_lie(name: str) -> None:
    lie = LIES[name]
    code, lines = answer(lie.files())
    assert code in ([lie.code] if lie.code else [1, 4])
    word = "MALFORMED: " if code == 4 else "REFUSED: "
    assert lines[-1].startswith(word)
    reasons = lines[-1:] if code == 4 else [line for line in lines if line.startswith("REFUSED ")]
    assert reasons
    assert any(lie.word in line and line.partition(": ")[2] for line in reasons), lines
    assert all(len(line) < 2000 for line in lines)
