"""Where in a page a key stands, for messages."""

from __future__ import annotations

import re
from collections.abc import Sequence
from functools import cached_property

from verify.wire.inputs import InputError, cut


class Where:
    """A place in a file, whose line is looked for only if somebody asks."""

    def __init__(self, places: Places, keys: tuple[str, ...], value: object) -> None:
        self.places, self.keys, self.value = places, keys, value

    def __str__(self) -> str:
        return self.places.told(self.keys, self.value)


_KEY_IN_LINE = re.compile(r'\s*+([A-Za-z0-9_."\'-]++(?:\s*+\.\s*+[A-Za-z0-9_"-]++)*+)\s*+=')
_QUOTES = re.compile(r"""\s*('''|\"""|'|")""")
#: What begins an entry of a text, of which the last word is the name.
_HEAD = re.compile(r"""(?:^|; )([^\s:;"][^:;"]*):(?=\s|$)""")


class Places:
    """Where in a file a key stands, for messages."""

    def __init__(self, path: str, text: str, others: Sequence[Places] = ()) -> None:
        self.path, self.text, self.lines, self.others = path, text, text.splitlines(), others

    def with_others(self, others: Sequence[Places]) -> Places:
        """These places, and those of files that the page includes."""
        return Places(self.path, self.text, others)

    def error(self, keys: Sequence[str], what: str, value: object = None) -> InputError:
        """The error that something is wrong with a key, or with a value under it."""
        return InputError(f"{self.where(keys, value)}: {what}")

    def where(self, keys: Sequence[str], value: object = None) -> Where:
        """The file, the line and the key, which are looked for where they are told."""
        return Where(self, tuple(keys), value)

    def told(self, keys: Sequence[str], value: object = None) -> str:
        """The same, in words."""
        best = max((self, *self.others), key=lambda places: places.known(keys))
        if best is not self:
            return best.told(keys, value)
        line = self._line(keys, value)
        place = f", line {line}" if line else ""
        return f"{self.path}{place}" + (f": {'.'.join(map(cut, keys))}" if keys else "")

    def known(self, keys: Sequence[str]) -> int:
        """How many of the keys lead to a line of this file."""
        lengths = range(len(keys), 0, -1)
        return next((n for n in lengths if tuple(keys[:n]) in self.key_lines), 0)

    def _line(self, keys: Sequence[str], value: object) -> int:
        """The line in which the key stands, or the value if it stands below; 0 if none is found."""
        found = self._key_line(list(keys))
        if isinstance(value, str) and value:
            below = range(found, len(self.lines) + 1) if found else range(1, len(self.lines) + 1)
            return next((i for i in below if i and value in self.lines[i - 1]), found)
        return found

    def _key_line(self, keys: list[str]) -> int:
        """The line with the longest part of the keys that a line has."""
        parts = (tuple(keys[:length]) for length in range(len(keys), 0, -1))
        return next((self.key_lines[part] for part in parts if part in self.key_lines), 0)

    @cached_property
    def key_lines(self) -> dict[tuple[str, ...], int]:
        """For each key the first line in which it stands; so for the entries of a text."""
        table: list[str] = []
        keys: tuple[str, ...] = ()
        found: dict[tuple[str, ...], int] = {}
        quotes = ""  # those at the end of the text that has begun, over several lines
        for number, line in enumerate(self.lines, 1):
            rest = line
            if quotes:
                quotes = "" if quotes in line else quotes
            elif header := re.match(r"\s*\[+([^\[\]]+)\]+\s*(#|$)", line):
                table = keys_of(header[1])
                found.setdefault(tuple(table), number)
                continue
            elif match := _KEY_IN_LINE.match(line):
                keys, rest = (*table, *keys_of(match[1])), line[match.end() :]
                for length in range(len(table) + 1, len(keys) + 1):
                    found.setdefault(keys[:length], number)
                begins = _QUOTES.match(rest)
                if begins is None:
                    continue
                rest = rest[begins.end() :]
                quotes = begins[1] if len(begins[1]) == 3 and begins[1] not in rest else ""
            for head in _HEAD.findall(rest):
                found.setdefault((*keys, head), number)
                found.setdefault((*keys, head.rpartition(" ")[2]), number)
        return found


def keys_of(text: str) -> list[str]:
    """The keys in a header, or before a `=`, some of them in quotes."""
    return [key.strip("\"' ") for key in re.findall(r'"[^"]*"|\'[^\']*\'|[^.]+', text)]
