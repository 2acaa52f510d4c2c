"""What people read: lines as wide as their terminal, with colours and symbols where that serves."""

from __future__ import annotations

import os
import re
import sys
from collections.abc import Iterable, Iterator

from verify.cli.options import Options, Parser
from verify.jobs.inputs import InputError, shown

#: The width where no terminal says another.
COLUMNS = 80
#: Text is not squeezed below this width.
NARROWEST = 24
#: From this width on a relation stays on one line with what it relates.
ROOMY = 60

#: Each verdict with its symbol and its colour (of the 16 that every terminal has).
_STYLES = {"proved": ("✓", "32"), "refuted": ("✗", "31"), "undecided": ("?", "33")}
#: A verdict at the start of a line or after a colon.
_VERDICT = r"(^ *|: )(proved|refuted|undecided)(?=$|[ :;,.])"
_SYMBOL = r"[✓✗?] (proved|refuted|undecided)"
#: A relation with a short right side, which stays with what is before it.
_RELATION = r"(?<=\S) ([=≤<]) (?=\S{1,24}(?:\s|$))"


def add_color(parser: Parser) -> None:
    """The option ``--color``."""
    parser.option("--color", "auto (default), always or never", "WHEN", default="auto")


def show(lines: Iterable[str], options: Options) -> None:
    """Print lines for people.

    In a pipe they have neither colours nor symbols; at a terminal both, but no colours where
    ``NO_COLOR`` is set.

    Raises:
        InputError: for an unknown ``--color``.
    """
    when = options.color
    if when not in ("auto", "always", "never"):
        raise InputError(f"--color: {shown(when)} is unknown; write auto, always or never")
    terminal = sys.stdout.isatty()
    symbols = terminal or when == "always"
    colours = symbols and when != "never" and (when == "always" or not os.environ.get("NO_COLOR"))
    if symbols:
        lines = (re.sub(_VERDICT, _with_symbol, line, count=1) for line in lines)
    lines = wrapped(lines, width())
    if colours:
        lines = (re.sub(_SYMBOL, _coloured, line) for line in lines)
    sys.stdout.write("".join(f"{line}\n" for line in lines))


def width() -> int:
    """The width of the terminal: ``COLUMNS`` if that is set, what the terminal says, or 80."""
    text = os.environ.get("COLUMNS", "")
    if text.isdigit() and len(text) < 6 and int(text) > 0:
        return max(int(text), NARROWEST)
    try:
        return max(os.get_terminal_size(sys.stdout.fileno()).columns, NARROWEST)
    except (OSError, ValueError):
        return COLUMNS


def wrapped(lines: Iterable[str], columns: int) -> Iterator[str]:
    """The lines, those that are too long broken at spaces; what follows is indented like them."""
    for line in lines:
        if len(line) <= columns:
            yield line
        else:
            yield from _broken(line, columns)


def _broken(line: str, columns: int) -> Iterator[str]:
    start = line.lstrip(" ")
    if columns >= ROOMY:
        start = re.sub(_RELATION, "\u00a0\\1\u00a0", start)
    indent = min(len(line) - len(start), columns // 2)
    rest, after = " " * indent + start, " " * (indent + 2)
    while len(rest) > columns:
        end = rest.rfind(" ", len(after), columns + 1)
        if end < 0:  # a word that is longer than the line stays whole
            end = rest.find(" ", columns)
            if end < 0:
                break
        yield rest[:end].rstrip().replace("\u00a0", " ")
        rest = after + rest[end:].lstrip(" ")
    if rest.strip():
        yield rest.replace("\u00a0", " ")


def _with_symbol(match: re.Match[str]) -> str:
    return f"{match[1]}{_STYLES[match[2]][0]} {match[2]}"


def _coloured(match: re.Match[str]) -> str:
    return f"\x1b[{_STYLES[match[1]][1]}m{match[0]}\x1b[0m"
