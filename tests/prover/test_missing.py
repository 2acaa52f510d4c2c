"""A row is judged with what it uses: what has no value, or no point, leaves the others alone."""

from __future__ import annotations

import json
from pathlib import Path

import pytest

from tests.prover.test_interior import page
from verify.cli import main
from verify.prover.outcome import Outcome
from verify.wire.questions import decide, read_page_of


def outcome(text: str | bytes) -> Outcome:
    content = text if isinstance(text, bytes) else text.encode()
    return decide(read_page_of("a.toml", content, {}).statement)


def verdicts(found: Outcome) -> dict[str, str]:
    return {name: decision.verdict for name, decision in found.decisions.items()}


def chain(length: int, following: str) -> str:
    constants = "".join(f'c{i} = "{following.format(f"c{i - 1}")}"\n' for i in range(1, length))
    rows = f'[rows]\nfirst = "c1 < 3"\nlast = "c{length - 1} < 3"\n'
    return f'title = "t"\n[constants]\nc0 = "1/2"\n{constants}{rows}'


@pytest.mark.parametrize("following", ["{0}/2 + 1/3", "sqrt({0} + 1)", "3*{0}^2/4 + 1/10"])
def test_a_long_chain_of_constants_has_no_wall(following: str) -> None:
    assert verdicts(outcome(chain(400, following))) == {"first": "proved", "last": "proved"}


def test_rows_without_what_is_missing_are_decided() -> None:
    text = 'title = "t"\n[constants]\na = "1/2"\nb = "1/(a - 1/2)"\nc = "b + 1"\n'
    text += '[contexts.empty]\nvariables = ["x"]\ngiven = ["0 < x < c"]\npoint = { x = 1 }\n'
    text += '[contexts.fine]\nvariables = ["y"]\ngiven = ["0 < y < a"]\n'
    text += '[rows]\none = "a < 1"\ntwo = "c < 1"\nthree = "y < 1"\nfour = "x < c"\n'
    found = outcome(text)
    assert verdicts(found) == {
        "one": "proved",
        "two": "undecided",
        "three": "proved",
        "four": "undecided",
    }
    assert found.exit_code == 3
    assert found.decisions["two"].reason.startswith("b has no value")


def test_a_context_without_a_point_leaves_the_others_alone() -> None:
    text = page(["x"], ["0 < x"]).decode().replace('row = "0 < 1"', 'row = "0 < x + 1"')
    text = text.replace(
        "[rows]",
        '[contexts.none]\nvariables = ["y"]\ngiven = ["y < 0"]\n'
        'point = { y = 1 }\n[rows]\nother = "y < 1"',
    )
    assert verdicts(outcome(text)) == {"other": "undecided", "row": "proved"}


VALUELESS = """title = "t"
[constants]
p = "1/3"
q = "{}"
s = "q + 1"
[contexts.c]
variables = ["x"]
given = ["0 < x", "x < {}"]
[rows]
a = "x < {}"
b = "p < 1"
"""


@pytest.mark.parametrize(
    ("term", "why"),
    [
        ("sqrt(2 - sqrt(5))", "it has the root of a negative number"),
        ("root(p - 1, 3)", "it has the root of a negative number"),
        ("log(p - 1)", "it has the logarithm of a negative number"),
        ("log(p - 1/3)", "it has the logarithm of 0"),
        ("asin(2)", "it has the root of a negative number"),
        ("1/(p - 1/3)", "it divides by 0"),
    ],
)
def test_a_constant_without_a_value_is_told_with_its_line(
    term: str, why: str, tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    """Whether a row uses it, or what is given: there it was said that no point was found."""
    path = tmp_path / "page.toml"
    path.write_text(VALUELESS.format(term, "1", "2*q + 3"))
    assert main(["prove", str(path), "--json"]) == 3
    document = json.loads(capsys.readouterr().out)
    assert document["spent"] == f"{path}, line 4: constants.q has no value: {why}"
    assert [row["verdict"] for row in document["obligations"]] == ["undecided", "proved"]
    path.write_text(VALUELESS.format(term, "s", "2"))
    assert main(["prove", str(path)]) == 2
    err = capsys.readouterr().err
    assert err.startswith(f"verify: {path}, line 4: constants.q: has no value: {why}")
    assert err.count("\n") == 1
