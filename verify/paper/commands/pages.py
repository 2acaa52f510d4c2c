"""The pages of the paper, `verify/paper/NAME.toml`, read once per process."""

from __future__ import annotations

from functools import cache
from importlib.resources import files

from verify.language.argument import Argument
from verify.prover.arguments import write_down
from verify.prover.outcome import Outcome
from verify.wire.judge import judged
from verify.wire.text import Page
from verify.wire.text.read_page import read_page


@cache
def page(name: str) -> Page:
    """The page of this name."""
    content = files("verify.paper").joinpath(f"{name}.toml").read_bytes()
    return read_page(f"verify/paper/{name}.toml", content)


def argument(name: str) -> Argument:
    """The statement of a page with its argument."""
    return Argument(page(name).statement, page(name).chapters)


@cache
def decide(name: str) -> Outcome:
    """The theorem of a page, each line with the proof that the page names; the checker judges."""
    return judged(write_down(argument(name)))
