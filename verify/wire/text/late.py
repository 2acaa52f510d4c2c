"""Which abbreviations of a page are over its constants, and so are read after these."""

from __future__ import annotations

import re
from typing import Any

from verify.wire.text.letters import name_of

CALL = re.compile(r"(.+?)\((.*)\)")
WORD = re.compile(r"[^\W\d]\w*")


def split(lets: Any, constants: Any) -> tuple[Any, dict[str, object]]:
    """The others, and those in which the name of a constant stands, or that of one of these.

    Both tables are taken as they stand in the page; what is no table has nothing in it.
    """
    if not isinstance(lets, dict) or not isinstance(constants, dict):
        return lets, {}
    names, found = {name_of(name) for name in constants}, dict[str, object]()
    while True:
        more = {
            key: body
            for key, body in lets.items()
            if key not in found and _words(key, body) & names
        }
        if not more:
            return {key: body for key, body in lets.items() if key not in found}, found
        found = {key: body for key, body in lets.items() if key in found | more}
        names |= {name_of(key.partition("(")[0]) for key in more}


def _words(key: str, body: object) -> set[str]:
    """The names in a body, but for the parameters of a function."""
    call = CALL.fullmatch(key)
    parameters = call[2].split(",") if call else []
    return set(map(name_of, WORD.findall(str(body)))) - {name.strip() for name in parameters}
