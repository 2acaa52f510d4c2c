"""Tables of a page that are written as a text, which says the same in fewer lines.

    given = 'r-positive: 0 < r; r-small: r <= 3/4'
    rows = '''
    lemma loses: 1/4 <= 1 - r; by r-small
    slower: r*v <= 1; "the speed never rises"; by loses v-small
    always goes-on: state; start start; next next'''

A semicolon ends a part, and so does a line break before a line that is not indented. A part
`NAME: VALUE` begins an entry; the parts after it are its other keys, each before its value. What
stands in quotation marks may have semicolons; alone it is what the entry `says`. A line that
begins with # is a comment.
"""

from __future__ import annotations

import re
from collections.abc import Iterator, Mapping, Sequence
from typing import Any

from verify.wire.inputs import InputError, shown
from verify.wire.text.places import Places

#: The key of the value behind the name of an entry, in each table that may be a text.
ROW, GIVEN, VALUE = "claim", "given", "value"
PAGE = {
    "parameters": VALUE,
    "assumptions": "sentence",
    "let": VALUE,
    "constants": VALUE,
    "rows": ROW,
}
CONTEXT = {
    **dict.fromkeys(("given", "carried", "standing"), GIVEN),
    **dict.fromkeys(("let", "constants", "states", "gram", "products", "vectors"), VALUE),
    "rows": ROW,
}
CHAPTER = {"let": VALUE, "constants": VALUE, "rows": ROW}
#: What a row is, before its name, if it is no claim.
KINDS = ("lemma", "applies", "always", "instance", "entries")
#: Equations that a sum for one entry of a minimum uses.
BRANCH = ("using", "plus")

_NAME = r"[^\s:;\"()]+"
_ROW = re.compile(rf"(?:({'|'.join(KINDS)})\s+)?({_NAME}):(?:\s+|$)")
#: Two vectors have an inner product; a function has its parameters behind its name.
_ENTRY = re.compile(rf"()({_NAME}(?: {_NAME})?(?:\([^():;\"]*\))?):(?:\s+|$)")
_QUOTED = re.compile(r'"[^"]*"')
#: What has a quotation mark without another one goes on to the end of its line.
_PART = re.compile(r'(?:[^;"]++|"[^"]*+(?:"|$))++')


def spelled_out(table: Mapping[str, Any], places: Places) -> dict[str, Any]:
    """The tables of a page, in which none is a text.

    Raises:
        InputError: naming the entry, if a part of a text is unclear.
    """
    found: dict[str, Any] = _spelled_out(table, PAGE, [], places)
    contexts, chapters = table.get("contexts"), table.get("chapters")
    if isinstance(contexts, dict):
        found["contexts"] = {
            name: _spelled_out(context, CONTEXT, ["contexts", name], places)
            for name, context in contexts.items()
        }
    if isinstance(chapters, list):
        found["chapters"] = [_spelled_out(c, CHAPTER, ["chapters"], places) for c in chapters]
    return found


def _spelled_out(table: Any, known: Mapping[str, str], keys: Sequence[str], places: Places) -> Any:
    """One table, and those in it that may be texts."""
    if not isinstance(table, dict):
        return table
    found = dict(table)
    for key in known.keys() & table.keys():
        text, first = table[key], known[key]
        is_claim = first == GIVEN and isinstance(text, str) and not _ENTRY.match(text.strip())
        if isinstance(text, str) and not is_claim:
            found[key] = _Text(first, [*keys, key], places).table(text)
    return found


class _Text:
    """Reads one text."""

    def __init__(self, first: str, keys: Sequence[str], places: Places) -> None:
        self.first, self.keys, self.places = first, keys, places

    def error(self, name: str, what: str) -> InputError:
        return self.places.error([*self.keys, *([name] if name else [])], what)

    def table(self, text: str) -> dict[str, Any]:
        """Each entry under its name; one that has a value only is that, unless it is a row."""
        found: dict[str, dict[str, Any]] = {}
        name, head = "", _ROW if self.first == ROW else _ENTRY
        for part in parts(text):
            if begins := head.match(part):
                name = begins[2]
                if name in found:
                    raise self.error(name, "stands there twice; choose another name")
                key = begins[1] or ("claim" if self.first == GIVEN else self.first)
                found[name], value = {}, part[begins.end() :]
            elif not name:
                raise self.error("", f"{shown(part)} has no name; write NAME: before it")
            elif part.startswith('"'):
                key, value = "says", part
            else:
                key, _, value = part.partition(" ")
            self._add(name, found[name], key, value.strip())
        if self.first == ROW:
            return found
        return {name: self._short(entry) for name, entry in found.items()}

    def _add(self, name: str, entry: dict[str, Any], key: str, value: str) -> None:
        """Another key of an entry; several `by` are a list, each with the equations after it."""
        if '"' in value and not _QUOTED.fullmatch(value):
            raise self.error(name, f"a quotation mark in {shown(value)} is unclear; leave it out")
        text: Any = value[1:-1] if value.startswith('"') else value
        if key == "uses":
            text = value.split()
        if key == "by" and key in entry:
            entry[key] = [*_branches(entry), text]
        elif key in BRANCH and isinstance(entry.get("by"), list):
            *others, last = entry["by"]
            branch = last if isinstance(last, dict) else {"by": last}
            entry["by"] = [*others, self._with(name, branch, key, text)]
        else:
            self._with(name, entry, key, text)

    def _with(self, name: str, entry: dict[str, Any], key: str, text: Any) -> dict[str, Any]:
        """The entry, after the key has got its value."""
        if key in entry:
            raise self.error(name, f"{key} stands there twice; leave one out")
        entry[key] = text
        return entry

    @staticmethod
    def _short(entry: dict[str, Any]) -> Any:
        """The entry, or what stands under its only key."""
        (first, *others) = entry
        return entry if others else entry[first]


def _branches(entry: dict[str, Any]) -> list[Any]:
    """What was said by now of how the entry follows, as a list."""
    equations = {key: entry.pop(key) for key in BRANCH if key in entry}
    by = entry["by"]
    if isinstance(by, list):
        return by
    return [{"by": by, **equations} if equations else by]


def parts(text: str) -> Iterator[str]:
    """The parts of a text, each in one line."""
    lines: list[str] = []
    for line in text.splitlines():
        if line[:1].isspace() and lines:
            lines[-1] += f" {line.strip()}"
        elif line.strip() and not line.startswith("#"):
            lines.append(line.strip())
    for line in lines:
        yield from (part for found in _PART.findall(line) if (part := found.strip()))
