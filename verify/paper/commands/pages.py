"""The pages of the paper, `verify/paper/NAME.toml`, read once per process."""

from __future__ import annotations

from collections.abc import Mapping
from contextlib import suppress
from functools import cache
from importlib.resources import files
from pathlib import Path

from verify.language.argument import Argument
from verify.language.errors import OwnError
from verify.prover.arguments import proofs_in, write_down
from verify.prover.outcome import Outcome
from verify.prover.proof import Proof
from verify.wire.judge import judged
from verify.wire.packaged import PACKAGED
from verify.wire.read import read
from verify.wire.term_json import WireError
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
def decide(name: str, folder: str) -> Outcome:
    """The theorem of a page, each line proved by what it names; the checker judges.

    Where a line has names only, the sum in the certificate at hand is tried first: that in
    ``folder`` of `certificates`, or of what comes with the program.
    """
    with suppress(OwnError):  # it refuses what is at hand where the page was changed since then
        return judged(write_down(argument(name), _at_hand(folder)))
    return judged(write_down(argument(name)))


def _at_hand(folder: str) -> Mapping[str, Proof]:
    """The proofs in a certificate, if there is one at hand."""
    for place in (PACKAGED, "certificates"):
        both = [Path(place, folder, f"{kind}.json") for kind in ("statement", "certificate")]
        if all(file.exists() for file in both):
            statement, certificate = (file.read_bytes() for file in both)
            with suppress(WireError):
                return proofs_in(read(statement, certificate, {}))
    return {}
