"""Where each name on a page of the paper is written, without reading the pages.

The program brings along what `verify.paper.commands.places` has found, with a digest of the sources
in which it looked. Where the sources are others now, it looks again.
"""

from __future__ import annotations

import json
import os
from collections.abc import Iterable, Iterator
from difflib import get_close_matches
from functools import cache
from hashlib import sha256

from verify.paper.commands.place import ROOT, Place
from verify.wire.packaged import PACKAGED

#: A line with the digest of the sources, then one for each place.
INDEX = os.path.join(PACKAGED, "places.txt")

#: The folder of the pages.
PAGES = "verify/paper"


def sources() -> str:
    """The digest of all pages."""
    found = sha256()
    for path in sorted(_files()):
        with open(os.path.join(ROOT, path), "rb") as file:
            content = file.read()
        found.update(f"{path} {len(content)}\n".encode())
        found.update(content)
    return found.hexdigest()


def _files() -> Iterator[str]:
    """The paths of the pages, from the folder in which `verify` is."""
    for folder, _, files in os.walk(os.path.join(ROOT, PAGES)):
        inside = os.path.relpath(folder, ROOT).replace(os.sep, "/")
        yield from (f"{inside}/{name}" for name in files if name.endswith(".toml"))


@cache
def lines() -> list[str] | None:
    """The lines of the index, if it is about the sources as they are; else None."""
    try:
        with open(INDEX, encoding="utf-8") as file:
            digest, *found = file.read().removesuffix("\n").split("\n")
    except (OSError, ValueError):
        return None
    return found if digest == sources() else None


def text(places: Iterable[Place]) -> str:
    """The index of these places."""
    found = [json.dumps(list(place), ensure_ascii=False) for place in places]
    return "\n".join([sources(), *found, ""])


def written(word: str) -> list[Place]:
    """Where a name stands, with or without its group, or a label of the paper."""
    end = json.dumps(word, ensure_ascii=False)[1:]
    return [place for place in _places(end) if word in (place.name, place.short, place.label)]


def near(word: str) -> list[str]:
    """Names and labels that resemble a word."""
    names = {text for p in _places("") for text in (p.name, p.short, p.label) if text}
    return get_close_matches(word, sorted(names), 3, 0.6)


def _places(end: str) -> Iterable[Place]:
    """All places, or at least those of which a text ends like this in the index."""
    found = lines()
    if found is None:
        from verify.paper.commands.places import places  # loaded only where it is used

        return places()
    return (Place(*json.loads(line)) for line in found if end in line)
