"""The options of a command: how the words after it are read, and the help that lists them.

A small part of what `argparse` does; to load that and to build a parser would take longer than all
the intervals of the main job.
"""

from __future__ import annotations

import os
import re
from collections.abc import Iterable, Mapping, Sequence
from types import SimpleNamespace

from verify.language.record import Record
from verify.wire.inputs import InputError, near, shown

#: What follows an option as its value although it starts with a minus sign.
_NEGATIVE = r"-([0-9.]|pi|inf|nan)"

#: The column in which the help of an option starts.
_COLUMN = 24


class Options(SimpleNamespace):
    """What was chosen, or the defaults: an attribute for each option and each place."""


def field(name: str) -> str:
    """The attribute of `Options` for an option or a place."""
    return name.lstrip("-").replace("-", "_")


def chosen(value: str | None, default: str) -> str:
    """What was written, or the default where nothing was; an empty text was written, too."""
    return default if value is None else value


def leave_out(
    options: Options,
    names: Iterable[str],
    why: str,
    defaults: Mapping[str, str | None] | None = None,
) -> None:
    """Refuse options that would not be used.

    Raises:
        InputError: for the first of these that has another value than by default: why not.
    """
    for name in names:
        if getattr(options, field(name)) not in (None, False, (defaults or {}).get(field(name))):
            raise InputError(f"--{name.lstrip('-').replace('_', '-')}: {why}")


#: What several commands have.
VERBOSE = {"-v, --verbose": "print every row and every assumption"}
ROWS = {"--rows NAME": "print the rows of this name, label or (4.47) only"}
JSON = {"--json": "one JSON document on stdout"}
COLOR = {"--color WHEN": "auto (default), always or never"}
CERTIFICATE = {"--out DIR": "write a folder to send: certificate, check.py, report.html"}
#: Options that name a file for a table with commas, and how that may end.
TABLES, ENDINGS = ("--csv", "--trajectory"), (".csv", ".txt")
CHOICES = {"--color": ("auto", "always", "never")}


class Usage(Record):
    """What may be written after a command.

    ``meanings`` has each option as the help shows it, and what it means: ``--name VALUE``, or
    ``-n, --name`` without a value; and each word without an option, in order: ``name``, ``[name]``
    if it may be left out, ``name [name ...]`` for one or more. Each of these has a field in
    `Options`; ``defaults`` are the values there of options that are not written. An option with
    ``choices`` has one of these values; ``example`` is what may be written where all is missing.
    """

    meanings: Mapping[str, str]
    defaults: Mapping[str, str] = {}
    choices: Mapping[str, Sequence[str]] = CHOICES
    required: Sequence[str] = ()
    example: str = ""


class Parser:
    """How the words after a command are read.

    An option is written ``--name VALUE`` or ``--name=VALUE``, a flag ``--name``; what does not
    start with a minus sign goes to the places, in order. Each option is given at most once.
    """

    def __init__(self, program: str, about: str, usage: Usage) -> None:
        self.program, self.about, self.usage = program, about, usage
        self.flags: dict[str, str] = {}
        self.valued: dict[str, str] = {}
        self._places: list[str] = []
        self._many = ""
        self._required: list[str] = []
        for written in usage.meanings:
            names = written.split(", ")
            last, _, rest = names[-1].partition(" ")
            if not last.startswith("-"):
                name = last.strip("[]")
                self._many = name if rest else self._many
                self._places.append(name)
                self._required += [] if last.startswith("[") else [name]
            elif rest:
                self.valued[last] = field(last)
            else:
                self.flags |= dict.fromkeys(names, field(last))
        self._required += usage.required

    def read(self, words: Sequence[str]) -> Options | None:
        """What was chosen; None where help is asked for.

        Raises:
            InputError: for an unknown, repeated or incomplete option, or an unexpected argument.
        """
        found: dict[str, object] = {}
        loose: list[str] = []
        waiting = list(reversed(words))
        while waiting:
            word = waiting.pop()
            if not word.startswith("-") or word == "-":
                loose.append(word)
                continue
            name, equals, value = word.partition("=")
            if name in ("-h", "--help"):
                return None
            key = self._once(name, found)
            if name in self.valued:
                found[key] = self._one_of(name, value if equals else self._value(name, waiting))
            elif equals:
                raise self._error(f"{name} takes no value, and {shown(value)} is given")
            else:
                found[key] = True
        self._place(loose, found)
        missing = [name for name in self._required if field(name) not in found]
        if missing:
            raise self._error(f"{', '.join(missing)}: is missing{self._meant(loose)}")
        blank = dict.fromkeys((*self._places, *self.valued.values()))
        unset = {**blank, **dict.fromkeys(self.flags.values(), False), **self.usage.defaults}
        return Options(**(unset | found))

    def _meant(self, words: list[str]) -> str:
        """What to write where a word stands in the place of the one before it."""
        if not words and self.usage.example:
            return f"; write for example {self.program} {self.usage.example}"
        first = self.usage.choices.get(self._places[0], ()) if self._places else ()
        if len(words) != 1 or not first:
            return ""
        chosen = words if words[0] in first else [*first]
        rest = "FOLDER" if words is chosen or shown(words[0]) != f"'{words[0]}'" else words[0]
        return f"; write {' or '.join(f'{self.program} {name} {rest}' for name in chosen)}"

    def _once(self, name: str, found: dict[str, object]) -> str:
        """The field of an option."""
        key = self.flags.get(name) or self.valued.get(name)
        if key is None:
            known = {option.lstrip("-"): option for option in (*self.flags, *self.valued)}
            meant = known.get(near(name.lstrip("-"), known), "")
            raise self._error(
                f"unknown option {shown(name)}{meant and f' (did you mean {meant}?)'}"
            )
        if key in found:
            raise InputError(f"{shown(name)} is given more than once; write it once")
        return key

    def _value(self, name: str, waiting: list[str]) -> str:
        if not waiting or (waiting[-1].startswith("-") and not re.match(_NEGATIVE, waiting[-1])):
            raise self._error(f"{name}: its value is missing")
        return waiting.pop()

    def _one_of(self, name: str, value: str) -> str:
        """The value, which has to be one of the choices if there are some."""
        *most, last = self.usage.choices.get(name) or [value]
        if value not in (*most, last):
            written = f"{', '.join(most)} or {last}"
            raise InputError(f"{name}: {shown(value)} is unknown; write {written}")
        before, dot, ending = os.path.basename(value).rpartition(".")
        if name in TABLES and dot and f".{ending}" not in ENDINGS:
            raise InputError(
                f"{name}: {shown(value)} ends in .{ending}; write {before or 'table'}.csv "
                "(.txt is a table with commas, too)"
            )
        return value

    def _place(self, words: list[str], found: dict[str, object]) -> None:
        if self._many and words:
            found[self._many] = words
        elif len(words) > len(self._places):
            raise self._error(f"unexpected argument {shown(words[len(self._places)])}")
        else:
            found.update(zip(self._places, words, strict=False))

    def _error(self, message: str) -> InputError:
        return InputError(f"{message}; see {self.program} --help")

    def help(self, columns: int) -> str:
        """What `--help` prints, in so many columns."""
        places = [written for written in self.usage.meanings if not written.startswith("-")]
        usage = " ".join([self.program, "[options]", *places])
        lines = [f"usage: {usage}", "", *beside("", self.about, 0, columns), ""]
        for name, text in {**self.usage.meanings, "-h, --help": "show this help"}.items():
            lines += beside(f"  {name}", text, _COLUMN, columns)
        return "\n".join(lines)


def beside(first: str, text: str, start: int, columns: int) -> list[str]:
    """A few words, and beside them, or below if they are long, a text that starts in a column."""
    from textwrap import wrap  # loaded only where it is used

    lines = wrap(text, max(columns - start, start), break_on_hyphens=False) or [""]
    above = [first] if len(first) >= start > 0 else []
    firsts = ["" if above else first, *([""] * (len(lines) - 1))]
    return [*above, *(f"{left:<{start}}{line}" for left, line in zip(firsts, lines, strict=True))]
