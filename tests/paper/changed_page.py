"""The page of Theorem 1 with some of its text changed, as somebody may change it."""

from __future__ import annotations

from collections.abc import Iterator
from contextlib import contextmanager
from pathlib import Path

import pytest

from verify.paper import theorem1


@contextmanager
def changed_page(folder: Path, *changes: tuple[str, str]) -> Iterator[None]:
    """Inside, the theorem is that of the page with these texts in place of others, each once."""
    text = Path(theorem1.PAGE).read_text(encoding="utf-8")
    for old, new in changes:
        assert text.count(old) == 1, old
        text = text.replace(old, new)
    page = folder / "theorem1.toml"
    page.write_text(text, encoding="utf-8")
    with pytest.MonkeyPatch.context() as patch:
        patch.setattr(theorem1, "PAGE", str(page))
        theorem1.theorem.cache_clear()
        try:
            yield
        finally:
            theorem1.theorem.cache_clear()
