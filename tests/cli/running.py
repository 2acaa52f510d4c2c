"""Commands as a person runs them."""

from __future__ import annotations

import json
from collections.abc import Callable
from pathlib import Path
from typing import Any

import jsonschema
import pytest

from verify.cli import main

ROOT = Path(__file__).resolve().parents[2]
#: The exit code, and what stands on both streams.
Found = tuple[int, str, str]


def command(*first: str) -> Callable[..., Found]:
    """What runs the command that begins with these words."""

    def run(capsys: pytest.CaptureFixture[str], *words: object) -> Found:
        code = main([*first, *map(str, words)])
        captured = capsys.readouterr()
        return code, captured.out, captured.err

    return run


def parsed(out: str) -> Any:
    """A JSON document, whose numbers are integers or texts."""
    return json.loads(out, parse_float=_no_float)


def _no_float(text: str) -> None:
    raise AssertionError(f"{text} is a JSON float")


def validator(name: str) -> jsonschema.Draft202012Validator:
    """What refuses a document that is not as the schema of this name says."""
    path = ROOT / "certificates/schema" / f"{name}.schema.json"
    schema = json.loads(path.read_text(encoding="utf-8"))
    jsonschema.Draft202012Validator.check_schema(schema)
    return jsonschema.Draft202012Validator(schema)


def check_refused(found: Found, why: str = "") -> None:
    """Unusable input: one line on stderr that has these words, and nothing else."""
    code, out, err = found
    assert (code, out, err.count("\n")) == (2, "", 1), err
    assert err.startswith("verify: ")
    assert why in err
