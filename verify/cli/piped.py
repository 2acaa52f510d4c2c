"""A statement that another program writes, read from standard input."""

from __future__ import annotations

import re
import sys
from codecs import BOM_UTF8

from verify.cli.files import MAX_BYTES
from verify.wire.inputs import InputError


def piped() -> tuple[str, bytes]:
    """What stands on standard input, and a name for it that ends as its format does.

    Raises:
        InputError: if it cannot be read, or has no end in sight.
    """
    try:
        content = sys.stdin.buffer.read(MAX_BYTES + 1)
    except (OSError, ValueError, AttributeError) as error:
        raise InputError("STATEMENT: there is no standard input; name a file") from error
    if len(content) > MAX_BYTES:
        raise InputError(f"STATEMENT: standard input has more than {MAX_BYTES} bytes; write less")
    return f"stdin.{_format(content)}", content


def _format(content: bytes) -> str:
    """The format by the first sign: no page of constants begins with one of these."""
    content = content.removeprefix(BOM_UTF8)
    first = content.lstrip()[:1]
    if first in (b"(", b";"):
        start = re.match(rb"(\s|;[^\n]*\n)*\(\s*FPCore", content)
        return "fpcore" if start else "smt2"
    return "json" if first == b"{" else "toml"
