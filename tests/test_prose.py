"""Every number and formula in the prose of the pages is watched: see `tests.prose`."""

from __future__ import annotations

import re
from functools import cache
from pathlib import Path

import pytest

from tests.facts import Said, said, true
from tests.prose import PAGES, ROOT, WATCHED, covered, equations, idioms, labels, prose, unwatched
from tests.watched import TEXTS

#: On pages other than README.md one change in so many is tried; all are with ``-m slow``.
EVERY = 9

UP = {**dict(zip("⁰¹²³⁴⁵⁶⁷⁸⁹", "¹²³⁴⁵⁶⁷⁸⁹⁰", strict=True)), "√": ""}


def name_of(page: Path) -> str:
    return page.relative_to(ROOT).as_posix()


@cache
def pattern(entry: Said) -> re.Pattern[str]:
    return re.compile(r"\s+".join(map(re.escape, entry.text.split())))


def problems(name: str, text: str) -> list[str]:
    """What is not watched on a page, and what should stand on it and does not."""
    seen = prose(text)
    spans, missing = list(covered(text, seen)), []
    for entry in TEXTS:
        if entry.page in ("", name):
            found = [match.span() for match in pattern(entry).finditer(seen)]
            missing += [f"write: {entry.text}"] if entry.page and not found else []
            spans += found
    return missing + [f"line {line}: {word}" for line, word in unwatched(text, spans)]


@pytest.mark.parametrize("page", PAGES, ids=name_of)
def test_every_number_is_proved(page: Path) -> None:
    found = problems(name_of(page), page.read_text(encoding="utf-8"))
    assert not found, f"say in tests/watched.py where these come from, or write them right: {found}"


def test_entries_are_of_pages() -> None:
    assert {entry.page for entry in TEXTS} <= {"", *map(name_of, PAGES)}


def changed(text: str, place: int) -> str:
    """The page with one digit raised by 1, or one root left out."""
    old = text[place]
    return (
        text[:place]
        + UP.get(old, str((int(old) + 1) % 10) if old.isdecimal() else "")
        + text[place + 1 :]
    )


def excused(text: str, place: int) -> bool:
    """Whether what was changed is a label that exists, another particle, or true: √2 < 4/2."""
    spans = [span for rule in (labels, idioms, equations) for span in rule(prose(text))]
    return any(start <= place < end for start, end in spans)


def unnoticed(page: Path, every: int) -> list[str]:
    """The changes of numbers on a page that nothing notices."""
    text = page.read_text(encoding="utf-8")
    places = [match.start() for match in WATCHED.finditer(prose(text))][::every]
    texts = ((changed(text, place), place) for place in places)
    return [
        text[max(0, place - 20) : place + 10]
        for other, place in texts
        if not excused(other, place) and not problems(name_of(page), other)
    ]


@pytest.mark.parametrize("page", PAGES, ids=name_of)
def test_a_change_is_noticed(page: Path) -> None:
    assert not unnoticed(page, 1 if page.name == "README.md" else EVERY)


@pytest.mark.parametrize("page", PAGES, ids=name_of)
def test_each_change_is_noticed(page: Path) -> None:
    assert not unnoticed(page, 1)


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
    with pytest.raises(ValueError, match="is false"):
        true("x + 1/x ≥ 3", lambda draw: {"x": 1})
    assert all("17 rows" not in entry.text for entry in TEXTS)
