"""Sentences: plain words are read at once, which changes nothing."""

from __future__ import annotations

from hypothesis import given
from hypothesis import strategies as st

from verify.language.scripts import Scripted, _piece, pieces

PARTS = st.sampled_from(
    [
        *"abxAB12η_^{}()[]|'′-,. \n\t\u00a0\u0304²⁻ⁿ₂ₙ",
        *("eta_bar", "C_eta-below-one", "C_{s, n+1}", "η_c²", "10⁻⁵", " of the ", "paper's"),
    ]
)


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


@given(st.lists(PARTS, max_size=14).map("".join))
def test_plain_words_are_what_their_signs_are(text: str) -> None:
    assert pieces(text) == each_sign(text)
