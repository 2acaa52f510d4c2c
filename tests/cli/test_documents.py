"""Every JSON document has a format and a schema that describes it."""

from __future__ import annotations

from importlib import import_module
from pathlib import Path
from typing import Any

import pytest

from tests.cli.running import parsed, validator
from verify.cli import COMMANDS, main

ROOT = Path(__file__).resolve().parents[2]
EXAMPLE = str(ROOT / "certificates/examples/witness")

DOCUMENTS = [
    ("theorem1", ["theorem1", "--r", "0.03"]),
    ("theorem1", ["theorem1", "--r", "0.03", "--constants", "printed"]),
    ("theorem1", ["theorem1", "--r", "1/1000", "--theta0", "5*pi/6", "--constants", "repaired"]),
    ("theorem1", ["theorem1", "--r", "0.5"]),
    ("theorem1-all", ["theorem1", "--all"]),
    ("theorem1-box", ["theorem1", "--r", "0.02..0.04", "--neg-cos", "0.97..1"]),
    ("theorem1-box", ["theorem1", "--r", "0.02..0.08", "--neg-cos", "0.9..1"]),
    ("theorem1-box", ["theorem1", "--r", "0.06..0.08"]),
    ("theorem1-scan", ["theorem1", "--r", "0.02..0.2", "--steps", "5"]),
    ("spectrum", ["spectrum"]),
    ("spectrum", ["spectrum", "--r", "1/20"]),
    ("spectrum", ["spectrum", "--r", "0.05..0.06"]),
    ("classification", ["classification"]),
    ("classification", ["classification", "--r", "2/25"]),
    ("classification", ["classification", "--r", "1/20"]),
    ("separatrix", ["separatrix", "--r", "3/100"]),
    ("separatrix", ["separatrix", "--r", "3/100", "--at", "1/10", "--ratio", "2/3"]),
    ("separatrix", ["separatrix", "--r", "3/100", "--budget", "9"]),
    ("separatrix", ["separatrix", "--r", "2/25"]),
    ("separatrix-curves", ["separatrix", "--r", "0.03..0.09", "--steps", "3"]),
    ("separatrix-theorem", ["separatrix", "--all"]),
    ("elsewhere", ["elsewhere"]),
    ("check", ["check", EXAMPLE]),
    ("prove", ["prove", f"{EXAMPLE}/statement.json"]),
    ("prove", ["prove", f"{ROOT}/certificates/examples/minimum/statement.json"]),
    ("measurements", ["stress", "--quick"]),
    ("explain", ["explain", "zeta-x-bound"]),
    ("explain", ["explain", "--r", "0.03", "delta_x"]),
    ("explain", ["explain", "step", "4.47"]),
]


def document(capsys: pytest.CaptureFixture[str], words: list[str]) -> dict[str, Any]:
    main([*words, "--json"])
    captured = capsys.readouterr()
    assert captured.err == ""
    found: dict[str, Any] = parsed(captured.out)
    return found


@pytest.mark.parametrize(("name", "words"), DOCUMENTS)
def test_the_schema_describes_the_document(
    capsys: pytest.CaptureFixture[str], name: str, words: list[str]
) -> None:
    found = document(capsys, words)
    assert [error.message for error in validator(name).iter_errors(found)] == []


@pytest.mark.parametrize(
    "command",
    [name for name in COMMANDS if "--json" in import_module(f"verify.cli.{name}").USAGE.meanings],
)
def test_an_error_is_a_document_too(command: str, capsys: pytest.CaptureFixture[str]) -> None:
    """Whatever is wrong: an option, its value, or what a place names."""
    places = [w for w in import_module(f"verify.cli.{command}").USAGE.meanings if w[0] != "-"]
    asked = [["--nonsense"], ["--out", ""], *([["no/such/file"]] if places else [["word"]])]
    for words in asked:
        code = main([command, *words, "--json"])
        out, err = capsys.readouterr()
        found = parsed(out)
        validator("error").validate(found)
        assert (code, found["exit_code"], found["command"]) == (2, 2, command)
        assert err == f"verify: {found['error']}\n"


def test_the_schema_refuses_other_documents(capsys: pytest.CaptureFixture[str]) -> None:
    schema = validator("theorem1")
    found = document(capsys, ["theorem1", "--r", "0.03"])
    row = next(r for r in found["sets"]["printed"]["obligations"] if r["verdict"] == "refuted")
    changes: list[tuple[dict[str, Any], str, Any]] = [
        (found, "format", "verify-theorem1/2"),
        (found, "verdict", "proved, given 3"),
        (found["parameters"], "r", 0.03),
        (found["constants"], "h_4", ["0.1", 0.2]),
        (row, "verdict", "proved"),
        (row, "lhs", ["1"]),
        (row, "surplus", 1),
    ]
    assert schema.is_valid(found)
    for table, key, value in changes:
        old = table.get(key)
        table[key] = value
        assert not schema.is_valid(found), key
        table[key] = old
        if old is None:
            del table[key]
    assert schema.is_valid(found)


@pytest.mark.parametrize(
    ("words", "name", "count"),
    [
        (["theorem1", "--r", "0.03"], "zeta-total", 2),
        (["theorem1", "--all"], "4.47", 20),
        (["spectrum"], "A_a", 1),
        (["classification"], "restitution", 1),
        (["elsewhere"], "quoted-limit", 1),
        (["separatrix", "--all"], "below-x-positive", 1),
    ],
)
def test_a_document_has_the_rows_that_are_asked_for(
    capsys: pytest.CaptureFixture[str], words: list[str], name: str, count: int
) -> None:
    found = document(capsys, [*words, "--rows", name])
    sets = [
        found.get("hypotheses", []),
        *(s["obligations"] for s in found.get("sets", {}).values()),
    ]
    assert len(found.get("claims") or [row for rows in sets for row in rows]) == count
    assert found["verdict"] in ("proved", "refuted")
    assert main([*words, "--json", "--rows", f"{name}x"]) == 2
    assert f"is it {name}" in capsys.readouterr().err or not name[0].isalpha()


#: The verdicts on rows whose claim is false.
FALSE = ("refuted", "remark", "proved; not by the printed argument")


def test_rows_have_one_shape_in_all_documents(capsys: pytest.CaptureFixture[str]) -> None:
    shapes = []
    for words in (["theorem1", "--r", "0.03"], ["spectrum"]):
        found = document(capsys, words)
        rows = found.get("claims") or [
            *found["hypotheses"],
            *(row for one in found["sets"].values() for row in one["obligations"]),
        ]
        shapes.append({key for row in rows for key in row} - {"witness"})
        for row in rows:
            assert (row["verdict"] in FALSE) == ("corrected_by" in row)
            assert row["verdict"] in FALSE or row["severity"] is None
    assert shapes[0] == shapes[1]
