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

FOLDER = files("verify.paper")


def names() -> list[str]:
    """The names of all pages."""
    found = [path.name for path in FOLDER.iterdir() if path.name.endswith(".toml")]
    return sorted(name.removesuffix(".toml") for name in found)


def content(name: str) -> bytes:
    """The text of the page of this name."""
    return FOLDER.joinpath(f"{name}.toml").read_bytes()


@cache
def page(name: str) -> Page:
    """The page of this name."""
    return read_page(f"verify/paper/{name}.toml", content(name))


def argument(name: str) -> Argument:
    """The statement of a page with its argument."""
    return Argument(page(name).statement, page(name).chapters)


@cache
def decide(name: str) -> Outcome:
    """The theorem of a page, each line with the proof that the page names; the checker judges."""
    return judged(write_down(argument(name)))
