"""What holds in each test."""

from __future__ import annotations

import pytest


@pytest.fixture(autouse=True)
def whole_lines(monkeypatch: pytest.MonkeyPatch) -> None:
    """Lines are not broken: tests of the terminal say themselves how wide it is."""
    monkeypatch.setenv("COLUMNS", "99999")
