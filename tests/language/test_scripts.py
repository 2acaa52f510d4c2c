"""Sentences: plain words are read at once, which changes nothing."""

from __future__ import annotations

from hypothesis import given, settings
from hypothesis import strategies as st

from verify.language.scripts import Scripted, _piece, pieces

LETTERS, SMALL = st.sampled_from("abA1η)"), st.sampled_from("_^'′\u0304²⁻ⁿ₂ₙ")
BETWEEN = st.sampled_from([*"{}([|-,. \n\u00a0", " of the ", "eta_bar", "C_eta-below-one"])
PARTS = LETTERS | SMALL | BETWEEN


def each_sign(text: str) -> tuple[str | Scripted, ...]:
    """The same without a short way for plain words."""
    found: list[str | Scripted] = []
    at = 0
    while at < len(text):
        piece, at = _piece(text, at)
        if isinstance(piece, str) and found and isinstance(found[-1], str):
            found[-1] += piece
        else:
            found.append(piece)
    return tuple(found)


@settings(derandomize=True, deadline=None, max_examples=1000)
@given(st.lists(PARTS, max_size=10).map("".join))
def test_plain_words_are_what_their_signs_are(text: str) -> None:
    assert pieces(text) == each_sign(text)
