"""A row is judged with what it uses: what has no value, or no point, leaves the others alone."""

from __future__ import annotations

import pytest

from tests.prover.test_interior import page
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
