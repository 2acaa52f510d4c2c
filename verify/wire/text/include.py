"""What a page includes: the tables of other pages, before its own.

    include = "chart.toml"

The file stands beside the page. Its title and theorem do not count, and each file is included once.
A page may add to a table that it includes, such as a context. It must not say anew what stands
there; only `says`, `label` and `point` of a context are those of the page that says them last.
"""

from __future__ import annotations

import os
from collections.abc import Callable, Mapping
from typing import Any

from verify.wire.inputs import InputError, regular_file, shown
from verify.wire.text.places import Places, Where

#: The content of a file, by its path.
Opened = Callable[[str], bytes]
#: What a page may say anew of an included context.
ANEW = ("says", "label", "point")
#: What an included page says of itself alone.
ALONE = ("title", "theorem", "group", "include")
MAX_BYTES = 1 << 20
#: So many pages may include one another in a row.
MAX_DEPTH = 100

Read = Callable[[str, bytes], tuple[dict[str, Any], Places]]


def beside(path: str) -> bytes:
    """The content of a file on disk."""
    return regular_file(path, MAX_BYTES)


class Included:
    """The tables of a page with all that it includes, and where everything stands."""

    def __init__(self, read: Read, opened: Opened) -> None:
        self._read, self._opened = read, opened
        self._open: list[str] = []  # files of which one includes the next
        self._done: dict[str, Places] = {}

    def page(self, path: str, content: bytes) -> tuple[dict[str, Any], Places]:
        """The tables of a page after those that it includes.

        Raises:
            InputError: naming the file and the line, if a file cannot be included.
        """
        table, places = self._read(path, content)
        found = self._with_included(path, table, places)
        return found, places.with_others([*self._done.values()])

    def _with_included(self, path: str, table: dict[str, Any], places: Places) -> dict[str, Any]:
        entry = table.pop("include", [])
        names = entry if isinstance(entry, list) else [entry]
        self._open.append(os.path.normpath(path))
        whole: dict[str, Any] = {}
        for name in names:
            inner = path_beside(path, name, places.where(["include"]))
            if inner in self._open:
                raise places.error(["include"], f"{shown(name)} includes this page; leave one out")
            if len(self._open) > MAX_DEPTH:
                what = (
                    f"{shown(name)} is included by way of {MAX_DEPTH} other pages; name it earlier"
                )
                raise places.error(["include"], what)
            if inner not in self._done:
                whole = merged(whole, self._file(inner, name, places), places, [])
        self._open.pop()
        return merged(whole, table, places, [])

    def _file(self, path: str, name: str, places: Places) -> dict[str, Any]:
        content = content_of(path, name, places.where(["include"]), self._opened)
        table, own = self._read(path, content)
        if "rows_of" in table:
            what = "stands in an included page; write it in the page that includes this one"
            raise own.error(["rows_of"], what)
        found = self._with_included(path, table, own)
        self._done[path] = own
        return {key: value for key, value in found.items() if key not in ALONE}


def path_beside(path: str, name: object, where: Where) -> str:
    """The path of a page beside another one.

    Raises:
        InputError: if it is no name of a page.
    """
    if not isinstance(name, str) or not name.endswith(".toml"):
        what = f"{shown(str(name))} is no page; write the name of a file beside this one"
        raise InputError(f"{where}: {what}")
    return os.path.normpath(os.path.join(os.path.dirname(path), name))


def content_of(path: str, name: object, where: Where, opened: Opened | None) -> bytes:
    """The content of a page beside another one.

    Raises:
        InputError: if it cannot be read.
    """
    named = shown(str(name))
    try:
        return (opened or beside)(path)
    except OSError as error:
        what = f"{named} cannot be read ({error.strerror}); put it beside this page"
        raise InputError(f"{where}: {what}") from error
    except ValueError as error:
        what = f"{named} cannot be read ({error}); put a page beside this one"
        raise InputError(f"{where}: {what}") from error


def merged(
    first: Mapping[str, Any], second: Mapping[str, Any], places: Places, keys: list[str]
) -> dict[str, Any]:
    """Two tables in one; lists one after the other.

    Raises:
        InputError: if both say something under one key.
    """
    found = dict(first)
    for key, value in second.items():
        known = found.get(key)
        if known is None or (len(keys) == 2 and keys[0] == "contexts" and key in ANEW):
            found[key] = value
        elif isinstance(known, dict) and isinstance(value, dict):
            found[key] = merged(known, value, places, [*keys, key])
        elif keys == [] and isinstance(known, list) and isinstance(value, list):
            found[key] = [*known, *value]
        else:
            what = "stands in an included page, too; leave it out, or choose another name"
            raise places.error([*keys, key], what)
    return found
