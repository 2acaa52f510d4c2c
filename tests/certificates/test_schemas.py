"""The JSON schemas describe the examples, and refuse what the checker calls malformed."""

import copy
import hashlib
import json
from collections.abc import Callable
from pathlib import Path
from typing import Any

import jsonschema
import pytest

from verify import check

CERTIFICATES = Path(__file__).parents[2] / "certificates"
FILES = ("statement", "certificate")
EXAMPLES = sorted(path for path in (CERTIFICATES / "examples").iterdir() if path.is_dir())
INSTANCE, STANDING = (CERTIFICATES / "examples" / n for n in ("instance", "induction-standing"))


def load(path: Path) -> Any:
    return json.loads(path.read_text(encoding="utf-8"))


def schema(file: str) -> jsonschema.Draft202012Validator:
    return jsonschema.Draft202012Validator(load(CERTIFICATES / "schema" / f"{file}.schema.json"))


SCHEMAS = {file: schema(file) for file in FILES}


def accepted(folder: Path, change: Callable[[dict[str, Any]], None]) -> dict[str, bool]:
    """Whether both schemas, and the checker, accept an example after a change of its files."""
    files = {file: copy.deepcopy(load(folder / f"{file}.json")) for file in FILES}
    change(files)
    first = json.dumps(files["statement"]).encode()
    if files["certificate"]["statement_sha256"]:
        files["certificate"]["statement_sha256"] = hashlib.sha256(first).hexdigest()
    good = all(SCHEMAS[file].is_valid(files[file]) for file in FILES)
    try:
        found = check.check(first, json.dumps(files["certificate"]).encode(), {}).verdict
    except check.Malformed:
        found = "MALFORMED"
    return {"schema": good, "checker": found != "MALFORMED"}


@pytest.mark.parametrize("file", FILES)
def test_schema_is_a_schema(file: str) -> None:
    jsonschema.Draft202012Validator.check_schema(SCHEMAS[file].schema)


@pytest.mark.parametrize("folder", EXAMPLES, ids=lambda path: path.name)
@pytest.mark.parametrize("file", FILES)
def test_examples_are_valid(folder: Path, file: str) -> None:
    assert not [error.message for error in SCHEMAS[file].iter_errors(load(folder / f"{file}.json"))]


def step(files: dict[str, Any], i: int) -> dict[str, Any]:
    return files["certificate"]["steps"][i]


def row(files: dict[str, Any], i: int) -> dict[str, Any]:
    return files["statement"]["obligations"][i]


def given(files: dict[str, Any], i: int) -> dict[str, Any]:
    return files["statement"]["contexts"][0]["givens"][i]


BOTH: dict[str, Callable[[dict[str, Any]], Any]] = {
    "no change": lambda files: None,
    "another title": lambda files: files["statement"].update(title="\u221a2"),
    "another precision": lambda files: step(files, 0)["givens"][0].update(bits=65536),
    "a proof that is refused": lambda files: step(files, 1)["proof"]["addends"].append("1/2"),
}
NEITHER: dict[str, Callable[[dict[str, Any]], Any]] = {
    "format": lambda files: files["statement"].update(format="verify-statement/1"),
    "format of the certificate": lambda files: files["certificate"].update(format=2),
    "a key too many": lambda files: files["statement"].update(date="today"),
    "a key too few": lambda files: row(files, 0).pop("says"),
    "a key too many in a proof": lambda files: step(files, 1)["proof"].update(bits=64),
    "a name with a blank": lambda files: row(files, 0).update(name="number two"),
    "a name from a digit on": lambda files: step(files, 2).update(obligation="2nd"),
    "a relation the other way": lambda files: row(files, 0)["claim"].__setitem__(0, ">="),
    "a claim of two parts": lambda files: row(files, 0)["claim"].pop(),
    "an unknown operation": lambda files: row(files, 0)["claim"].__setitem__(1, ["sinh", "x"]),
    "a minimum of one": lambda files: row(files, 0)["claim"].__setitem__(1, ["min", "2"]),
    "a sum of three": lambda files: row(files, 0)["claim"].__setitem__(1, ["add", "1", "1", "0"]),
    "a JSON number": lambda files: row(files, 0)["claim"].__setitem__(1, 2),
    "a decimal term": lambda files: row(files, 0)["claim"].__setitem__(1, "2.0"),
    "a denominator of 0": lambda files: row(files, 0)["claim"].__setitem__(1, "2/0"),
    "an exponent of 0": lambda files: row(files, 0)["claim"].__setitem__(1, ["pow", "2", "0"]),
    "an unknown verdict": lambda files: row(files, 0).update(verdict="true"),
    "an unknown role": lambda files: row(files, 0).update(role="wanted"),
    "no needed row": lambda files: [row(files, i).update(role="printed") for i in (0, 1)],
    "an unknown kind": lambda files: given(files, 0).update(kind="fixed"),
    "an assumption of a plain given": lambda files: given(files, 0).update(assumption="a"),
    "an unknown rule": lambda files: step(files, 1)["proof"].update(rule="obvious"),
    "a rule of steps in a proof": lambda files: step(files, 0).update(givens=[{"rule": "define"}]),
    "a step of two kinds": lambda files: step(files, 1).update(open="positive"),
    "no proof": lambda files: step(files, 1).update(proof=None),
    "one bit": lambda files: step(files, 0)["givens"][0].update(bits=1),
    "a fraction of bits": lambda files: step(files, 0)["givens"][0].update(bits=64.5),
    "true bits": lambda files: step(files, 0)["givens"][0].update(bits=True),
    "an unknown value": lambda files: step(files, 1)["proof"]["addends"].append(["cube", "x"]),
    "a nested list of nothing": lambda files: step(files, 1)["proof"]["addends"].append([]),
    "an end that is NaN": lambda files: files["certificate"]["enclosures"]["rows"][
        "at-root"
    ].update(lhs=["NaN", "2"]),
    "a digest that is empty": lambda files: files["certificate"].update(statement_sha256=""),
}
OF_STANDING: dict[str, Callable[[dict[str, Any]], Any]] = {
    "a standing given without an assumption": lambda files: given(files, 0).update(assumption=None),
    "a carried given with an assumption": lambda files: given(files, 0).update(kind="carried"),
    "for ever, refuted": lambda files: row(files, 0).update(verdict="refuted"),
    "for ever, without a next state": lambda files: row(files, 0)["claim"].pop(),
    "induction as a premise": lambda files: step(files, 0).update(givens=[step(files, 7)["proof"]]),
}


@pytest.mark.parametrize("change", BOTH)
def test_schema_and_checker_accept(change: str) -> None:
    assert accepted(INSTANCE, BOTH[change]) == {"schema": True, "checker": True}


@pytest.mark.parametrize("change", NEITHER)
def test_schema_and_checker_refuse(change: str) -> None:
    assert accepted(INSTANCE, NEITHER[change]) == {"schema": False, "checker": False}


@pytest.mark.parametrize("change", OF_STANDING)
def test_schema_and_checker_refuse_standing(change: str) -> None:
    assert accepted(STANDING, OF_STANDING[change]) == {"schema": False, "checker": False}
