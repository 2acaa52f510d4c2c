"""Theorem 1 with the repaired constants, whole, in words and in LaTeX."""

from __future__ import annotations

from collections.abc import Iterator

from verify.language.typeset import Typesetter
from verify.views.everywhere import CLAIM
from verify.views.material import Whole
from verify.views.tex.formulas import Formulas
from verify.views.tex.sentences import words

CONSTANTS = "Its constants:"
SET = (
    "Its set: 0 and 1 are in contact and have just collided, s is 1 and c is 2, d is the gap "
    "between 0 and 2, and"
)
MORE = "and what free flight reaches from there before the next collision."


def constants_and_set(whole: Whole) -> Iterator[str]:
    """Constants and set for a terminal."""
    typesetter = plain(whole)
    yield CONSTANTS
    for constant in whole.constants:
        yield f"  {constant.letter} = {typesetter.term(constant.term)}"
    yield f"{SET} {', '.join(map(typesetter.claim, whole.givens))}; {MORE}"


def plain(whole: Whole) -> Typesetter:
    """A typesetter in its letters."""
    return Typesetter({name: letter for name, (letter, _) in whole.letters.items()})


def latex(whole: Whole) -> str:
    """Theorem, constants and set, to be copied into a theorem environment; every line breaks."""
    tex = {name: letter for name, (_, letter) in whole.letters.items()}
    formulas = Formulas(tex, {name: letter for name, (letter, _) in whole.letters.items()})
    constants = [rf"{c.tex} = {formulas.term(c.term)}" for c in whole.constants]
    return "\n".join(
        [
            words(f"{CLAIM} {CONSTANTS}"),
            r"\begin{itemize}",
            *(rf"\item $\displaystyle {text}$" for text in constants),
            r"\end{itemize}",
            f"{words(SET)} {', '.join(f'${formulas.claim(given)}$' for given in whole.givens)};",
            words(MORE),
        ]
    )
