"""The pages of the paper, `verify/paper/NAME.toml`: what each says, and its proof.

A certificate of each comes with the program. Where the text of the page is the one from which it
was made, its files are taken; after any change to the text the page is read.
"""

from __future__ import annotations

import os
import re
from collections.abc import Mapping
from contextlib import suppress
from functools import cache

from verify.language.argument import Argument
from verify.language.errors import OwnError
from verify.language.record import TYPE_CHECKING
from verify.language.statement import UNDECIDED, Cite, Statement
from verify.prover.budget import WorkBudget
from verify.prover.outcome import Outcome
from verify.prover.proof import Proof
from verify.wire.judge import judged, packaged
from verify.wire.packaged import PAGES, became, cited_digests, packaged_files, packaged_statements
from verify.wire.read import cite_of, read, statement_of
from verify.wire.term_json import WireError
from verify.wire.toml import toml_of

if TYPE_CHECKING:
    from verify.wire.text import Page

#: The folder of the pages, and how their files end.
FOLDER, END = os.path.dirname(os.path.dirname(__file__)), ".toml"
#: The same, in messages.
ROOM = "verify/paper"


def names() -> list[str]:
    """The names of all pages."""
    return sorted(n.removesuffix(END) for n in os.listdir(FOLDER) if n.endswith(END))


def content(name: str) -> bytes:
    """The text of the page of this name."""
    return _file(name + END)


def included(name: str) -> dict[str, bytes]:
    """The files that a page includes or whose rows it shows, and those that they include."""
    found: dict[str, bytes] = {}

    def follow(text: bytes, folder: str) -> None:
        for written in re.findall(rb"^(?:include|rows_of) = (.+)$", text, re.MULTILINE):
            for inner in re.findall(rb'"([^"]+)"', written):
                path = os.path.normpath(os.path.join(folder, inner.decode()))
                if path not in found:
                    found[path] = _file(path)
                    follow(found[path], os.path.dirname(path))

    follow(content(name), "")
    return found


def whole(name: str) -> bytes:
    """The text of a page, and of all that it includes."""
    return b"".join((content(name), *included(name).values()))


def _file(path: str) -> bytes:
    """A file below the folder of the pages."""
    with open(os.path.join(FOLDER, path), "rb") as file:
        return file.read()


@cache
def page(name: str) -> Page:
    """The page of this name, read now."""
    from verify.wire.text.read_page import read_page  # loaded only where it is used

    path = f"{ROOM}/{name}{END}"
    return read_page(path, content(name), cited_by(name), lambda p: _file(p.removeprefix(ROOM)[1:]))


def cited_by(name: str) -> tuple[Cite, ...]:
    """What the page of this name cites: the theorems of other pages."""
    text = content(name)
    if b"[cites]" not in text:
        return ()
    table, _ = toml_of(f"{ROOM}/{name}{END}", text, "mend it")
    pages = {theorem: page for page, (theorem, _) in PAGES.items()}
    return tuple(cite(pages[theorem]) for theorem in table.get("cites", {}).values())


def argument(name: str) -> Argument:
    """The statement of a page with its argument, read now."""
    return Argument(page(name).statement, page(name).chapters)


def is_argued(name: str) -> bool:
    """Whether a line of the page says what it follows from."""
    return page(name).is_argued


@cache
def decide(name: str) -> Outcome:
    """The theorem of a page; the checker judges.

    What is at hand for its lines is tried first. Where that does not suffice, since the page was
    changed, or where no line names anything, it is decided as a page of any author.
    """
    from verify.wire import questions  # loaded only where it is used

    if is_argued(name):
        with suppress(OwnError):
            found = judged(_written_down(name))
            if found.claimed != UNDECIDED:
                return found
    return questions.decide_page(page(name), WorkBudget())


def _written_down(name: str) -> Outcome:
    """Where a line has names only, the sum in the certificate at hand is tried first."""
    from verify.prover.arguments import proofs_in, write_down  # loaded only where it is used

    at_hand: Mapping[str, Proof] = {}
    with suppress(OwnError, WireError):
        content, certificate = packaged_files(PAGES[name][0])
        cited = packaged_statements(cited_digests(content))
        at_hand = proofs_in(read(content, certificate, cited))
    return write_down(argument(name), at_hand)


# --- without reading a page whose text has become what comes with the program ---------------------


@cache
def statement(name: str) -> Statement:
    """What a page says.

    Raises:
        OwnError: if the files that came with the program were changed.
    """
    known = became(name, whole(name))
    if known is None:
        return page(name).statement
    found, _ = packaged_files(known)
    return statement_of(found, packaged_statements(cited_digests(found)))


@cache
def accepted(name: str, *, anew: bool = True) -> Outcome:
    """The theorem of a page; every verdict is the checker's of this run.

    Without `anew` the verdicts on what comes with the program are those that the checker has given.

    Raises:
        OwnError: if the files that came with the program were changed, or the checker refuses them.
    """
    known = became(name, whole(name))
    return decide(name) if known is None else packaged(known, anew=anew)


@cache
def cite(name: str) -> Cite:
    """The theorem of a page, to be cited; whoever writes what cites it has both checked.

    Raises:
        OwnError: if the files that came with the program were changed.
    """
    known = became(name, whole(name))
    if known is not None:
        found, certificate = packaged_files(known)
        return cite_of(found, certificate, packaged_statements(cited_digests(found)))
    from verify.wire.write import cite_of_outcome  # loaded only where it is used

    return cite_of_outcome(_written_down(name) if is_argued(name) else decide(name))
