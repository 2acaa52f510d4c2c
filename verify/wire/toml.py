"""TOML as people send it: what would take its reader long, or much memory, is refused first."""

from __future__ import annotations

import re
import tomllib
from typing import Any

from verify.wire.inputs import InputError

#: Of a word outside of quotation marks: a number, or a part of a key.
MAX_WORD = 4300
#: Of the parts of a key, and of brackets inside of one another.
MAX_PARTS, MAX_NESTING = 100, 100

#: Texts in quotation marks, and comments; a text without an end goes to that of its line.
_QUOTED = re.compile(
    r'"""[^"\\]*+(?:(?:\\.|"{1,2}(?!"))[^"\\]*+)*+"{3,5}|'
    r"""'''[^']*+(?:'{1,2}(?!')[^']*+)*+'{3,5}|"""
    r'"[^"\\\n]*+(?:\\.[^"\\\n]*+)*+"?|'
    r"'[^'\n]*+'|#[^\n]*+",
    re.DOTALL,
)
_WORD = re.compile(r"[^\s\[\]{},=.]++")
_PART = r"[^\s\[\]{},=.]"
_KEY = re.compile(rf"(?<!{_PART})(?={_PART})(?:{_PART}*+[ \t]*+\.[ \t]*+){{{MAX_PARTS}}}")


class TooLongError(ValueError):
    """A text has a longer part than is read."""


def toml_of(path: str, content: bytes, otherwise: str) -> tuple[dict[str, Any], str]:
    """The table in a file of TOML, where a number is the text that is written, and its text.

    A byte order mark at the beginning is skipped.

    Raises:
        InputError: naming the file, the line, and what to write there; ``otherwise`` where that is
            not known.
    """
    try:
        text = content.decode("utf-8-sig")
    except UnicodeDecodeError as error:
        raise InputError(
            f"{path}: is not valid TOML (it is not UTF-8); save it as UTF-8"
        ) from error
    try:
        _check(text)
        return tomllib.loads(text, parse_float=str), text
    except RecursionError as error:
        raise InputError(f"{path}: {_NESTED}; make it shorter") from error
    except TooLongError as error:
        raise InputError(f"{path}: {error}; make it shorter") from error
    except ValueError as error:
        from verify.wire.mend_toml import error_about  # loaded only where it is used

        raise error_about(path, text, str(error), otherwise) from error


_NESTED = f"brackets are more than {MAX_NESTING} deep"


def _check(text: str) -> None:
    """Afterwards the reader of TOML takes about as long as the text is.

    Raises:
        TooLongError: naming the line.
    """
    # A text becomes a sign that stands for it; the lines stay.
    rest = _QUOTED.sub(lambda found: "_" + "\n" * found[0].count("\n"), text)
    long = next((found for found in _WORD.finditer(rest) if len(found[0]) > MAX_WORD), None)
    deep = _KEY.search(rest)
    for found, words in (
        (long, f"a number or a name has more than {MAX_WORD} signs"),
        (deep, f"a key has more than {MAX_PARTS} parts"),
    ):
        if found is not None:
            line = rest.count("\n", 0, found.start()) + 1
            raise TooLongError(f"line {line}: {words}")
    depth = 0
    for bracket in re.findall(r"[\[\]{}]", rest):
        depth += 1 if bracket in "[{" else -1
        if depth > MAX_NESTING:
            raise TooLongError(_NESTED)
