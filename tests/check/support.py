"""Small statements with one obligation, and the checker's verdict on them."""

from __future__ import annotations

import json
from collections.abc import Mapping
from hashlib import sha256
from typing import Any

from verify import check

WIDE = ["-1e99", "1e99"]


def files(
    claim: Any,
    rule: str,
    *,
    variables: Mapping[str, Any] | None = None,
    constants: Mapping[str, Any] | None = None,
    role: str = "printed",
    **fields: Any,
) -> tuple[bytes, bytes]:
    """The bytes of a statement with one obligation and of its certificate."""
    constants = constants or {}
    statement = {
        "format": "verify-statement/1",
        "theorem": "T",
        "title": "a test",
        "parameters": {},
        "constants": [
            {"name": name, "label": "L", "tex": name, "term": term}
            for name, term in constants.items()
        ],
        "obligations": [
            {
                "name": "row",
                "label": "LABEL",
                "role": role,
                "says": "says",
                "claim": claim,
                "uses": [],
                "variables": dict(variables or {}),
            }
        ],
        "assumptions": [],
    }
    proof = {"obligation": "row", "rule": rule, "bits": 64, **fields}
    if not variables:
        proof = {"lhs": WIDE, "rhs": WIDE} | proof
    first = json.dumps(statement).encode()
    certificate = {
        "format": "verify-certificate/1",
        "statement_sha256": sha256(first).hexdigest(),
        "enclosures": dict.fromkeys(constants, WIDE),
        "proofs": [proof],
    }
    return first, json.dumps(certificate).encode()


def verdict(claim: Any, rule: str, **fields: Any) -> str:
    """``proved``, or why not: the reason after the row's name, or ``malformed: ...``."""
    try:
        proved, lines = check.check(*files(claim, rule, **fields))
    except check.Malformed as error:
        return f"malformed: {error}"
    assert lines[-1] == ("PROVED" if proved else "NOT PROVED")
    assert lines[0].startswith(("proved  row [LABEL] ", "REFUSED row [LABEL] "))
    return "proved" if proved else next(line for line in lines if line.startswith("REFUSED"))


def proves(claim: Any, rule: str, **fields: Any) -> bool:
    """Whether the checker accepts the proof; a malformed file is an error here."""
    found = verdict(claim, rule, **fields)
    assert not found.startswith("malformed"), found
    return found == "proved"
