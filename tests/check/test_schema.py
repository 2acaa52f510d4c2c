"""The JSON Schemas: valid, strict, true of every certificate, and as strict as the checker."""

from __future__ import annotations

import copy
import json
from collections.abc import Iterator
from pathlib import Path
from typing import Any

import pytest
from jsonschema import Draft202012Validator

from tests.check.support import files
from verify import check

ROOT = Path(__file__).parents[2]
SCHEMAS = {
    name: json.loads((ROOT / "certificates" / "schema" / f"{name}.schema.json").read_text())
    for name in ("statement", "certificate")
}
COMMITTED = sorted(path.parent for path in (ROOT / "certificates").glob("*/statement.json"))
STORED = sorted(
    path.parent for path in (ROOT / "tests" / "certificates" / "correct").glob("*/statement.json")
)


def subschemas(schema: Any) -> Iterator[dict[str, Any]]:
    if isinstance(schema, dict):
        yield schema
        for value in schema.values():
            yield from subschemas(value)
    elif isinstance(schema, list):
        for value in schema:
            yield from subschemas(value)


@pytest.mark.parametrize("name", SCHEMAS)
def test_the_schemas_are_valid_versioned_and_strict(name: str) -> None:
    schema = SCHEMAS[name]
    Draft202012Validator.check_schema(schema)
    assert schema["$schema"] == "https://json-schema.org/draft/2020-12/schema"
    assert schema["$id"].endswith(f"{name}:1")
    formats = {"statement": check.STATEMENT, "certificate": check.CERTIFICATE}
    assert schema["properties"]["format"]["const"] == formats[name]["format"]
    for part in subschemas(schema):
        if part.get("type") == "object":
            open_keys = part["additionalProperties"]
            assert open_keys is False or "propertyNames" in part


@pytest.mark.parametrize("folder", COMMITTED + STORED, ids=lambda folder: folder.name)
@pytest.mark.parametrize("name", SCHEMAS)
def test_every_committed_certificate_is_valid(folder: Path, name: str) -> None:
    document = json.loads((folder / f"{name}.json").read_bytes())
    Draft202012Validator(SCHEMAS[name]).validate(document)


PROOFS = {
    "interval": {},
    "exact": {},
    "rewrite": {"steps": [["k", None], ["k", 0]], "closing": "identity"},
    "bernstein": {"degree": 2},
    "cuts": {"cuts": {"x": ["0", "1"]}},
    "witness": {"point": {"x": "1/2"}},
    "square": {"then": {"rule": "rewrite", "bits": 64, "steps": [], "closing": "interval"}},
}
VALUES = [None, True, 0, 7, -1, 10**6, "", "x", "1/2", "1/0", [], ["x"], {}, {"x": []}, [1, 2]]


def paths(value: Any, path: tuple[Any, ...] = ()) -> Iterator[tuple[Any, ...]]:
    if path:
        yield path
    if isinstance(value, dict | list):
        for key, inner in value.items() if isinstance(value, dict) else enumerate(value):
            yield from paths(inner, (*path, key))


def edited(document: Any, path: tuple[Any, ...], value: Any) -> Any:
    document = copy.deepcopy(document)
    target = document
    for key in path[:-1]:
        target = target[key]
    target[path[-1]] = value
    return document


def accepted(name: str, document: Any) -> bool:
    shapes = {"statement": check.STATEMENT, "certificate": check.CERTIFICATE}
    try:
        check.parse(name, json.dumps(document).encode(), shapes[name])
    except check.Malformed:
        return False
    return True


@pytest.mark.parametrize("rule", PROOFS)
def test_proofs_are_read_as_the_schema_says(rule: str) -> None:
    """Whatever is put into a proof, schema and checker agree on whether its shape is right."""
    assert PROOFS.keys() == check.RULES.keys()
    validator = Draft202012Validator(SCHEMAS["certificate"])
    certificate = json.loads(files(["<", "1", "2"], rule, **PROOFS[rule])[1])
    validator.validate(certificate)
    proof = certificate["proofs"][0]
    shape = check.PROOF | {"obligation": check.NAME, "lhs": check.PAIR, "rhs": check.PAIR}
    for path in paths(proof):
        if path[0] in ("then", "rule"):
            continue
        for value in VALUES:
            changed = edited(proof, path, value)
            try:
                check.shaped("proof", changed, shape | check.RULES[rule][1])
                good = True
            except check.Malformed:
                good = False
            names = changed.get("cuts", {}), changed.get("point", {})
            if good and any("x" not in name and name for name in names):
                continue
            assert good == validator.is_valid({**certificate, "proofs": [changed]}), changed


@pytest.mark.parametrize("name", SCHEMAS)
def test_the_schema_refuses_what_the_checker_refuses(name: str) -> None:
    """The schema describes the format whole; the checker reads terms and proofs later."""
    validator = Draft202012Validator(SCHEMAS[name])
    claim = ["not", ["<", ["pow", ["min", "1", "k"], "2"], ["neg", "x"]]]
    pair = files(claim, "witness", variables={"x": ["0", None]}, constants={"k": "1/2"},
                 point={"x": "1"})  # fmt: skip
    document = json.loads(pair[name == "certificate"])
    validator.validate(document)
    for path in paths(document):
        for value in VALUES:
            changed = edited(document, path, value)
            if validator.is_valid(changed):
                assert accepted(name, changed), (path, value)


def test_missing_and_unknown_keys() -> None:
    for name, document in zip(
        SCHEMAS, map(json.loads, files(["<", "1", "2"], "exact")), strict=True
    ):
        validator = Draft202012Validator(SCHEMAS[name])
        validator.validate(document)
        for key in document:
            assert not validator.is_valid({k: v for k, v in document.items() if k != key})
        assert not validator.is_valid({**document, "extra": 1})
