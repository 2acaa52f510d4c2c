"""What people read: lines as wide as their terminal, with colours and symbols where that serves."""

from __future__ import annotations

import os
import re
import sys
from collections.abc import Iterable, Iterator

from verify.cli.options import Options

#: A space at which no line is broken.
FIXED = "\u00a0"
#: The width where no terminal says another.
COLUMNS = 80
#: Text is not squeezed below this width.
NARROWEST = 24
#: From this width on a relation stays on one line with what it relates.
ROOMY = 60

#: What moves the cursor, ends a line or turns the direction of letters instead of being printed.
_CONTROL = r"[\x00-\x1f\x7f-\x9f\u061c\u200e\u200f\u2028-\u202e\u2066-\u2069\ud800-\udfff]"

#: Symbol and colour (of the 16 that every terminal has): a yes, a no, and what is left open.
_YES, _NO, _OPEN = ("✓", "32"), ("✗", "31"), ("?", "33")
#: Each verdict with its style: of a row, of a file that is checked, of a scene.
_STYLES = {
    **dict.fromkeys(("proved", "PROVED", "collapses", "disperses", "finite"), _YES),
    **dict.fromkeys(("refuted", "REFUTED", "REFUSED", "MALFORMED"), _NO),
    "undecided": _OPEN,
}
_WORDS = "|".join(_STYLES)
#: A verdict: any word of these at the start of a line; after a colon, where prose may follow too,
#: only what a claim has, and only where it ends there.
_AT_END = r"(: )(proved|refuted|undecided)(?=$|[:;,.]| \()"
_VERDICT = rf"^( *)({_WORDS})(?=$|[ :;,.])|{_AT_END}"
_SYMBOL = rf"[✓✗?] ({_WORDS})"
#: How a line begins that is a command, to be pasted into a shell.
_COMMAND = "verify "
#: A relation with a short right side, which stays with what is before it.
_RELATION = r"(?<=\S) ([=≤<]) (?=\S{1,24}(?:\s|$))"


def show(lines: Iterable[str], options: Options, *, records: bool = False) -> None:
    """Print lines for people; ``records`` stay on a line each in a pipe, as other programs want.

    In a pipe they have neither colours nor symbols; at a terminal both, but no colours where
    ``NO_COLOR`` is set. What a title or a sentence has of line feeds and other signs that are not
    printed cannot make a line of its own, or steer the terminal.
    """
    erase()
    lines = (_as_one_line(line.replace("\n", " ")) for line in lines)
    when = options.color or "auto"
    terminal = sys.stdout.isatty()
    symbols = terminal or when == "always"
    colours = symbols and when != "never" and (when == "always" or not os.environ.get("NO_COLOR"))
    if symbols:
        lines = (re.sub(_VERDICT, _with_symbol, line, count=1) for line in lines)
    lines = wrapped(lines, width() if terminal or not records else sys.maxsize)
    if colours:
        lines = (re.sub(_SYMBOL, _coloured, line) for line in lines)
    sys.stdout.write("".join(f"{line}\n" for line in lines))
    sys.stdout.flush()


def _as_one_line(line: str) -> str:
    return line if line.isprintable() else re.sub(_CONTROL, lambda m: ascii(m[0])[1:-1], line)


def is_watched() -> bool:
    """Whether stderr is a terminal."""
    return sys.stderr is not None and sys.stderr.isatty()


class _Line:
    """The line at the end of a terminal's stderr that says how far a job is."""

    is_shown = False


def progress(text: str) -> None:
    """Say on stderr what is being done, in place of what was said before, if that is watched."""
    if is_watched():
        most = max(width() - 1, 1)  # a line that is wrapped could not be erased
        print(f"\r{text[:most]}\x1b[K", end="", file=sys.stderr, flush=True)
        _Line.is_shown = True


def erase() -> None:
    """Afterwards no progress is shown: what is printed then has lines of its own."""
    if _Line.is_shown:
        _Line.is_shown = False
        print("\r\x1b[K", end="", file=sys.stderr, flush=True)


def width() -> int:
    """The width of the terminal: ``COLUMNS`` if that is set, what the terminal says, or 80."""
    text = os.environ.get("COLUMNS", "")
    if re.fullmatch("[0-9]{1,5}", text) and int(text) > 0:
        return max(int(text), NARROWEST)
    try:
        columns = os.get_terminal_size(sys.stdout.fileno()).columns
    except (OSError, ValueError):
        return COLUMNS
    return max(columns, NARROWEST) if columns else COLUMNS


def wrapped(lines: Iterable[str], columns: int) -> Iterator[str]:
    """The lines, those that are too long broken at spaces; what follows is indented like them.

    A command is broken as a shell reads it: with a backslash at the end of each line but the last.
    """
    for line in lines:
        if len(line) <= columns:
            yield line.replace(FIXED, " ")
        elif line.lstrip().startswith(_COMMAND):
            *first, last = _broken(line, columns - 2)
            yield from (f"{part} \\" for part in first)
            yield last
        else:
            yield from _broken(line, columns)


def _broken(line: str, columns: int) -> Iterator[str]:
    start = line.lstrip(" ")
    if columns >= ROOMY:
        start = re.sub(_RELATION, f"{FIXED}\\1{FIXED}", start)
    indent = min(len(line) - len(start), columns // 2)
    rest, after = " " * indent + start, " " * (indent + 2)
    while len(rest) > columns:
        end = rest.rfind(" ", len(after), columns + 1)
        if end < 0:  # a word that is longer than the line stays whole
            end = rest.find(" ", columns)
            if end < 0:
                break
        yield rest[:end].rstrip().replace(FIXED, " ")
        rest = after + rest[end:].lstrip(" ")
    if rest.strip():
        yield rest.replace(FIXED, " ")


def _with_symbol(match: re.Match[str]) -> str:
    before, word = match[1] if match[2] else match[3], match[2] or match[4]
    return f"{before}{_STYLES[word][0]}{FIXED}{word}"


def _coloured(match: re.Match[str]) -> str:
    return f"\x1b[{_STYLES[match[1]][1]}m{match[0]}\x1b[0m"
