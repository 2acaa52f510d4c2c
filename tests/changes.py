"""Pages with one sign or number changed: what the tests of the prose have to notice.

``python -m tests.changes [EVERY]`` tries each change (or one in so many) and prints those that
stay unnoticed, with their share.
"""

from __future__ import annotations

import re
import sys
from collections.abc import Iterator
from functools import cache
from pathlib import Path
from typing import NamedTuple

from tests.facts import Said
from tests.prose import PAGES, ROOT, WATCHED, blocks, covered, marks, paragraphs, prose, unwatched
from tests.signs import TEXTS

_UP = "⁰¹²³⁴⁵⁶⁷⁸⁹"
#: What a sign is mistaken for.
_OTHER = {
    "<": ">≤",
    ">": "<≥",
    "≤": "≥<",
    "≥": "≤>",
    "≠": "=",
    "+": "-",
    "-": "+",
    "→": "↦",
    "↦": "→",
    "√": " ",
}


def name_of(page: Path) -> str:
    return page.relative_to(ROOT).as_posix()


@cache
def pattern(entry: Said) -> re.Pattern[str]:
    return re.compile(r"\s+".join(map(re.escape, entry.text.split())))


@cache
def entries(name: str, text: str) -> list[tuple[Said, tuple[int, int]]]:
    """The entries that stand in a paragraph, with their places."""
    of_page = [entry for entry in TEXTS if entry.page in ("", name)]
    return [(entry, m.span()) for entry in of_page for m in pattern(entry).finditer(text)]


def problems(name: str, text: str) -> list[str]:
    """What is not watched on a page, and what should stand on it and does not."""
    seen, shown_here = prose(text), blocks(text)
    spans, found = list(marks(seen)), set()
    for start, part in paragraphs(seen):
        there = entries(name, part)
        found |= {entry for entry, _ in there}
        for low, high in (*covered(shown_here, part), *(span for _, span in there)):
            spans.append((start + low, start + high))
    missing = [f"write: {e.text}" for e in TEXTS if e.page == name and e not in found]
    return missing + [f"line {line}: {word}" for line, word in unwatched(seen, spans)]


class Change(NamedTuple):
    """One character of a page, and what stands there instead."""

    page: str
    place: int
    new: str

    def of(self, text: str) -> str:
        """The page with the change."""
        return text[: self.place] + self.new + text[self.place + 1 :]


def instead_of(sign: str) -> str:
    """What a character is changed to: a digit to the next one, and to that four further on."""
    if sign in _UP:
        return _UP[(_UP.index(sign) + 1) % 10]
    return _OTHER.get(sign) or "".join(str((int(sign) + more) % 10) for more in (1, 5))


def changes(page: str, text: str) -> Iterator[Change]:
    """Every change on a page, outside blocks of code and what the program writes."""
    for match in WATCHED.finditer(prose(text)):
        for new in instead_of(match[0]):
            yield Change(page, match.start(), new)


def unnoticed(every: int) -> tuple[int, list[str]]:
    """How many changes were tried, one in so many, and those that nothing notices."""
    tried, found = 0, []
    for path in PAGES:
        text, page = path.read_text(encoding="utf-8"), name_of(path)
        for change in list(changes(page, text))[::every]:
            tried += 1
            if not problems(page, change.of(text)):
                line = text.count("\n", 0, change.place) + 1
                near = text[max(0, change.place - 30) : change.place + 20].replace("\n", " ")
                found.append(f"{page}:{line}: {near!r}: {text[change.place]} -> {change.new}")
    return tried, found


if __name__ == "__main__":
    number, left = unnoticed(int(sys.argv[1]) if len(sys.argv) > 1 else 1)
    print(*left, f"{len(left)} of {number} changes are not noticed", sep="\n")
