"""The page of Theorem 1 with some of its text changed, as somebody may change it."""

from __future__ import annotations

import re
from collections.abc import Iterator
from contextlib import contextmanager
from pathlib import Path

import pytest

from verify.paper import theorem1


def with_changes(text: str, *changes: tuple[str, str]) -> str:
    """The text of a page with others in place of some texts, each once, over any line breaks."""
    for old, new in changes:
        places = re.findall(r"\s+".join(map(re.escape, old.split())), text)
        assert len(places) == 1, old
        text = text.replace(places[0], new)
    return text


@contextmanager
def changed_page(folder: Path, *changes: tuple[str, str]) -> Iterator[None]:
    """Inside, the theorem is that of the page with these texts in place of others, each once."""
    page = folder / "theorem1.toml"
    text = with_changes(Path(theorem1.PAGE).read_text(encoding="utf-8"), *changes)
    page.write_text(text, encoding="utf-8")
    with pytest.MonkeyPatch.context() as patch:
        patch.setattr(theorem1, "PAGE", str(page))
        theorem1.theorem.cache_clear()
        try:
            yield
        finally:
            theorem1.theorem.cache_clear()
