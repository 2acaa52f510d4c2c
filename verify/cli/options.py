"""The options of a command: how the words after it are read, and the help that lists them.

A small part of what `argparse` does; to load that and to build a parser would take longer than all
the intervals of the main job.
"""

from __future__ import annotations

import re
from collections.abc import Iterator, Sequence
from types import SimpleNamespace

from verify.language.record import TYPE_CHECKING
from verify.wire.inputs import InputError, shown

if TYPE_CHECKING:
    from argparse import Action, ArgumentParser

#: What follows an option as its value although it starts with a minus sign.
_NEGATIVE = r"-([0-9.]|pi|inf|nan)"

#: The column in which the help of an option starts.
_COLUMN = 24


class Options(SimpleNamespace):
    """What was chosen, or the defaults: an attribute for each option and each place."""


def field(name: str) -> str:
    """The attribute of `Options` for an option or a place."""
    return name.lstrip("-").replace("-", "_")


class Parser:
    """The options and places of one command, and how they are read.

    An option is written ``--name VALUE`` or ``--name=VALUE``, a flag ``--name``; what does not
    start with a minus sign goes to the places, in order. Each option is given at most once.
    """

    def __init__(self, program: str, about: str) -> None:
        self.program, self.about = program, about
        self._defaults: dict[str, object] = {}
        self._fields: dict[str, str] = {}
        self._flags = {"-h", "--help"}
        self._choices: dict[str, Sequence[str]] = {}
        self._required: list[str] = []
        self._places: list[str] = []
        self._many = ""
        self._help: list[tuple[str, str]] = []

    # --- what there is --------------------------------------------------------------------------

    def option(
        self,
        name: str,
        text: str,
        value: str = "",
        *,
        default: str | None = None,
        required: bool = False,
        choices: Sequence[str] = (),
    ) -> None:
        """An option with a value, which the help calls ``value``; one of ``choices`` if given."""
        self._add(name, name, default)
        self._choices[name] = choices
        self._help.append((f"{name} {value or name[2:].upper()}", text))
        if required:
            self._required.append(name)

    def flag(self, *names: str, text: str) -> None:
        """An option without a value, perhaps with a short name; its field has the last name."""
        for name in names:
            self._add(name, names[-1], False)
            self._flags.add(name)
        self._help.append((", ".join(names), text))

    def place(self, name: str, text: str, *, required: bool = True) -> None:
        """A word without an option."""
        self._add(name, name, None)
        self._places.append(name)
        self._help.append((name if required else f"[{name}]", text))
        if required:
            self._required.append(name)

    def places(self, name: str, text: str) -> None:
        """All words without an option, at least one; the field has the list of them."""
        self._add(name, name, ())
        self._many = name
        self._required.append(name)
        self._help.append((f"{name} [{name} ...]", text))

    def _add(self, name: str, last: str, default: object) -> None:
        self._fields[name] = field(last)
        self._defaults[self._fields[name]] = default

    def names(self) -> list[str]:
        """The options that have a value."""
        return list(self._choices)

    # --- what was written -----------------------------------------------------------------------

    def read(self, words: Sequence[str]) -> Options | None:
        """What was chosen; None where help is asked for.

        Raises:
            InputError: for an unknown, repeated or incomplete option, or a word too many.
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
            self._once(name, found)
            if name in self._flags:
                if equals:
                    raise self._error(f"{name} takes no value, and {shown(value)} is given")
                found[self._fields[name]] = True
            else:
                value = value if equals else self._value(name, waiting)
                found[self._fields[name]] = self._one_of(name, value)
        self._place(loose, found)
        missing = [name for name in self._required if self._fields[name] not in found]
        if missing:
            raise self._error(f"{', '.join(missing)}: is missing")
        return Options(**(self._defaults | found))

    def _once(self, name: str, found: dict[str, object]) -> None:
        if not name.startswith("-") or name not in self._fields:
            raise self._error(f"{shown(name)} is no option")
        if self._fields[name] in found:
            raise InputError(f"{shown(name)} is given more than once; write it once")

    def _value(self, name: str, waiting: list[str]) -> str:
        if not waiting or (waiting[-1].startswith("-") and not re.match(_NEGATIVE, waiting[-1])):
            raise self._error(f"{name}: its value is missing")
        return waiting.pop()

    def _one_of(self, name: str, value: str) -> str:
        """The value, which has to be one of the choices if there are some."""
        *most, last = self._choices[name] or [value]
        if value not in (*most, last):
            written = f"{', '.join(most)} or {last}"
            raise InputError(f"{name}: {shown(value)} is unknown; write {written}")
        return value

    def _place(self, words: list[str], found: dict[str, object]) -> None:
        if self._many and words:
            found[self._many] = words
        elif len(words) > len(self._places):
            raise self._error(f"{shown(words[len(self._places)])} is a word too many")
        else:
            found.update(zip(self._places, words, strict=False))

    def _error(self, message: str) -> InputError:
        return InputError(f"{message}; see {self.program} --help")

    def add_to(self, other: ArgumentParser) -> Iterator[Action]:
        """Make the same options and places known to a parser of the standard library."""
        for name, text in self._help:
            about = text.replace("%", "%%")
            if not name.startswith("-"):
                yield other.add_argument(name.strip("[]").split()[0], nargs="*", help=about)
            elif name.split(", ")[0] in self._flags:
                yield other.add_argument(*name.split(", "), action="store_true", help=about)
            else:
                option, _, value = name.partition(" ")
                choices = self._choices[option] or None
                yield other.add_argument(option, metavar=value, choices=choices, help=about)

    # --- the help -------------------------------------------------------------------------------

    def help(self, columns: int) -> str:
        """What `--help` prints, in so many columns."""
        places = [name for name, _ in self._help if not name.startswith("-")]
        usage = " ".join([self.program, "[options]", *places])
        lines = [f"usage: {usage}", "", *beside("", self.about, 0, columns), ""]
        for name, text in [*self._help, ("-h, --help", "show this help")]:
            lines += beside(f"  {name}", text, _COLUMN, columns)
        return "\n".join(lines)


def beside(first: str, text: str, start: int, columns: int) -> list[str]:
    """A few words, and beside them, or below if they are long, a text that starts in a column."""
    from textwrap import wrap  # loaded only where it is used

    lines = wrap(text, max(columns - start, start), break_on_hyphens=False) or [""]
    above = [first] if len(first) >= start > 0 else []
    firsts = ["" if above else first, *([""] * (len(lines) - 1))]
    return [*above, *(f"{left:<{start}}{line}" for left, line in zip(firsts, lines, strict=True))]
