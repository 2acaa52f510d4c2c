"""Every number, sign and formula in the prose of the pages is watched: see `tests.prose`."""

from __future__ import annotations

from pathlib import Path

import pytest

from tests.changes import name_of, problems, unnoticed
from tests.facts import said, so, true
from tests.prose import PAGES, ROOT
from tests.signs import TEXTS

#: One change in so many is tried; all are with ``-m slow``. At most this share may pass.
EVERY, PASSES = 23, 0.02


@pytest.mark.parametrize("page", PAGES, ids=name_of)
def test_every_number_is_proved(page: Path) -> None:
    found = problems(name_of(page), page.read_text(encoding="utf-8"))
    assert not found, f"say in tests/watched.py where these come from, or write them right: {found}"


def test_entries_are_of_pages() -> None:
    assert {entry.page for entry in TEXTS} <= {"", *map(name_of, PAGES)}


def test_changes_are_noticed() -> None:
    tried, found = unnoticed(EVERY)
    assert tried > 150
    assert len(found) <= PASSES * tried, found


def test_each_change_is_noticed() -> None:
    tried, found = unnoticed(1)
    assert tried > 4000
    assert len(found) <= PASSES * tried, found


@pytest.mark.parametrize(
    ("page", "old", "new"),
    [
        ("README.md", "1 refuted, 2 unusable input, 3 und", "1 undecided, 2 unusable input, 3 ref"),
        ("README.md", "4√r/(1+r)", "5√r/(1+r)"),
        ("README.md", "4√r/(1+r)", "4√r/(1-r)"),
        ("docs/explanation/proof.md", "up to 1.54", "up to 1.34"),
        ("docs/explanation/proof.md", "δ_θ ≤ 0.0107", "δ_θ ≤ 0.0170"),
        ("docs/howto/masses.md", "(σ_oa + σ_ob)²", "(σ_oa - σ_ob)²"),
        ("docs/howto/masses.md", "(σ_oa + σ_ob)²", "(σ_oa + σ_ob)³"),
        ("docs/explanation/classification.md", "r > 9 - 4√5", "r > 9 - 4√3"),
        ("docs/explanation/separatrix.md", "801 | 40.1", "810 | 40.1"),
    ],
)
def test_what_was_once_changed_and_not_noticed(page: str, old: str, new: str) -> None:
    text = (ROOT / page).read_text(encoding="utf-8")
    other = text.replace(old, new, 1)
    assert other != text
    assert problems(page, other)


def test_an_entry_proves_its_numbers() -> None:
    with pytest.raises(ValueError, match="nothing says '17'"):
        said("README.md", "at most 17 rows")
    with pytest.raises(ValueError, match="nothing says"):
        said("README.md", "x + 1/x ≥ 3", by=true("x + 1/x ≥ 2", lambda draw: {"x": draw.random()}))
    with pytest.raises(ValueError, match="is not so"):
        so("README.md", "at most 17 rows", len(TEXTS) == 17)
    with pytest.raises(ValueError, match="is false"):
        true("x + 1/x ≥ 3", lambda draw: {"x": 1})
    assert all("17 rows" not in entry.text for entry in TEXTS)
