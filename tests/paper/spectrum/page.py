"""The page of the spectrum, for tests: terms that it has, and the page with a change."""

from __future__ import annotations

from functools import cache

from verify.language.statement import Statement
from verify.language.terms import Claim, Term
from verify.paper.commands import pages
from verify.prover.outcome import Outcome
from verify.wire.questions import decide
from verify.wire.text.read_page import read_page

PAGE = "spectrum"
TEXT = pages.content(PAGE).decode()


def read(text: str) -> Statement:
    """The statement of a text that is a page like that of the spectrum."""
    return read_page(f"{PAGE}.toml", text.encode(), pages.cited_by(PAGE)).statement


@cache
def terms(*formulas: str) -> tuple[Term, ...]:
    """What formulas mean on the page."""
    rows = [f'asked-{i} = {{ claim = "0 < {text}" }}' for i, text in enumerate(formulas)]
    asked = read("\n".join([TEXT, "[[chapters]]", 'in = "numbers"', "[chapters.rows]", *rows]))
    claims = [row.claim for row in asked.obligations[-len(rows) :]]
    return tuple(claim.rhs for claim in claims if isinstance(claim, Claim))


def table(name: str, rows: int = 4, columns: int = 4) -> tuple[tuple[Term, ...], ...]:
    """The entries of a matrix of the page."""
    places = [f"{name}[{i}, {j}]" for i in range(1, rows + 1) for j in range(1, columns + 1)]
    found = terms(*places)
    return tuple(found[i : i + columns] for i in range(0, len(found), columns))


def changed(old: str, new: str) -> Statement:
    """The statement of the page with another formula in one place.

    Raises:
        ValueError: unless the formula stands at just one place.
    """
    if TEXT.count(old) != 1:
        raise ValueError(f"{old} stands there {TEXT.count(old)} times")
    return read(TEXT.replace(old, new))


@cache
def with_a_broken_entry() -> Outcome:
    """The outcome if the first entry of the printed matrix is larger by 1/64."""
    entry = '"(-r^3 + 5*r^2 - 59*r - 1)/64", "root_3*(r + 1)/8",'
    return decide(changed(entry, entry.replace(")/64", ")/64 + 1/64", 1)))
