"""A value of another type, anywhere in the two files, is refused."""

from __future__ import annotations

import copy
import json
from collections.abc import Iterator
from typing import Any

import pytest

from tests.lies.small import honest, pack, run, write

OTHERS = [None, True, 0, 1.5, "", "x", [], {}]
FREE = {"title", "says", "label", "tex", "sentence", "theorem"}
Path = tuple[Any, ...]


def paths(value: Any, path: Path = ()) -> Iterator[Path]:
    """Where the values inside a document are, the document itself included."""
    yield path
    if isinstance(value, dict | list):
        for key in value if isinstance(value, dict) else range(len(value)):
            yield from paths(value[key], (*path, key))


def replaced(document: Any, path: Path, value: Any) -> Any:
    """A copy with another value at a path."""
    if not path:
        return value
    new = copy.copy(document)
    new[path[0]] = replaced(document[path[0]], path[1:], value)
    return new


def harmless(which: int, path: Path, other: Any) -> bool:
    """Whether the changed document may pass: another free text, less used, a step that is fine."""
    if which == 1:
        steps = ("proofs", NAMES.index("rewrite-interval"), "steps")
        return (path, other) in ((steps, []), ((*steps, 0, 1), 0)) and other is not True
    if path[-1:] == ("uses",):
        return other == []
    if other is None:  # a witness in a smaller interval is one in a larger interval
        witnesses = [NAMES.index("witness"), NAMES.index("witness-two")]
        return len(path) == 5 and path[1] in witnesses and path[2] == "variables"
    unused = path == ("assumptions", 1, "name") and other == "x"
    return unused or (isinstance(other, str) and path[-1] in FREE)


#: The variables have names that do not occur among the other values.
DOCUMENTS = [
    json.loads(json.dumps(document).replace('"x"', '"u"').replace('"y"', '"v"'))
    for document in honest()
]
ALIKE = {"interval-tight", "interval-box", "negation-weak", "negation-equal", "max", "pow", "cos"}
for document, rows, key in zip(
    DOCUMENTS, ("obligations", "proofs"), ("name", "obligation"), strict=True
):
    document[rows] = [item for item in document[rows] if item[key] not in ALIKE]
NAMES = [row["name"] for row in DOCUMENTS[0]["obligations"]]


@pytest.mark.parametrize("other", OTHERS, ids=json.dumps)
@pytest.mark.parametrize("which", [0, 1], ids=["statement", "certificate"])
def test_another_type_everywhere(which, other, tmp_path) -> None:
    wrong = []
    for path in paths(DOCUMENTS[which]):
        documents = list(DOCUMENTS)
        documents[which] = replaced(documents[which], path, other)
        if json.dumps(documents) == json.dumps(DOCUMENTS):
            continue
        code, lines, errors = run(write(tmp_path, pack(*documents)))
        last = "PROVED" if code == 0 else "NOT PROVED"
        allowed = {0, 1, 4} if path and harmless(which, path, other) else {1, 4}
        if code not in allowed or lines[-1:] != [last] or errors:
            wrong.append((path, code, lines[-3:], errors))
    assert not wrong


@pytest.mark.parametrize("other", OTHERS, ids=json.dumps)
def test_another_type_as_the_digest(other, tmp_path) -> None:
    first, second = pack(*honest())
    certificate = json.loads(second) | {"statement_sha256": other}
    code, lines, _ = run(write(tmp_path, (first, json.dumps(certificate).encode())))
    assert (code, lines[-1]) == (4, "NOT PROVED")
