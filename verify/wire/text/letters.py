"""Names as people write them: of functions, and the letters that stand for names."""

from __future__ import annotations

import re
from collections.abc import Callable, Mapping

from verify.language import terms

_GREEK = (
    (
        "αβγδεζηθικλμνξπ",
        "alpha beta gamma delta epsilon zeta eta theta iota kappa lambda mu nu xi pi",
    ),
    ("ρστφχψω", "rho sigma tau phi chi psi omega"),
    ("ΓΔΘΛΞΣΦΨΩ", "Gamma Delta Theta Lambda Xi Sigma Phi Psi Omega"),
)
GREEK = {
    name: letter
    for letters, names in _GREEK
    for letter, name in zip(letters, names.split(), strict=True)
}
#: Functions of one number that are written with the operations of the language.
FUNCTIONS: Mapping[str, Callable[[terms.Term], terms.Term]] = {
    **{name: getattr(terms, name) for name in ("tan", "sinh", "cosh", "tanh")},
    "abs": terms.absolute,
    "cbrt": lambda term: terms.nth_root(term, 3),
    "arctan": terms.atan,
    **dict.fromkeys(("asin", "arcsin"), terms.asin),
    **dict.fromkeys(("acos", "arccos"), terms.acos),
}
NAMES = {letter: name for name, letter in GREEK.items()}
LOWERED = str.maketrans("0123456789", "₀₁₂₃₄₅₆₇₈₉")
RAISED = str.maketrans("₀₁₂₃₄₅₆₇₈₉", "0123456789")


def letter_of(name: str) -> tuple[str, str]:
    r"""The letter of a name and the same in LaTeX: ``alpha_0`` is α₀, ``\alpha_{0}``.

    ``u1`` and ``u_1`` are u with an index. A name that is not a letter with an index stays as it
    is, and a name with dots is read from its last part if that begins with a letter.
    """
    last = name.rpartition(".")[2]
    last = last if last[:1].isalpha() else name
    match = re.fullmatch(r"([A-Za-z]+?)_?([0-9]*)", last)
    if match is None or (match[1] not in GREEK and len(match[1]) > 1):
        return last, last
    plain, tex = GREEK.get(match[1], match[1]), match[1]
    tex = f"\\{tex}" if tex in GREEK else tex
    index = match[2]
    return plain + index.translate(LOWERED), f"{tex}_{{{index}}}" if index else tex


#: A Greek letter that begins a name or a part of it; behind another letter it would be a factor.
_FIRST = re.compile(rf"(?<![A-Za-z0-9{''.join(NAMES)}])[{''.join(NAMES)}]")


def name_of(text: str) -> str:
    """The ASCII name of what a formula writes with Greek letters and lowered digits.

    Different names stay different: what is left of other signs is in no name.
    """
    index = re.sub(
        r"(?:_|(?<![₀-₉_]))([₀-₉]+)$", lambda found: f"_{found[1].translate(RAISED)}", text
    )
    return _FIRST.sub(lambda found: NAMES[found[0]], index)


#: How signs of a letter are written in LaTeX, beside Greek.
_TEX: Mapping[str, str] = {
    "cos ": r"\cos ",
    "√r": r"\sqrt r",
    "·": r"\cdot ",
    "²": "^2",
    **{letter: f"\\{name}" for name, letter in GREEK.items()},
    "τ": r"\tau ",
    "₁": "_1",
}


def tex_of(letter: str) -> str:
    """A letter that people read, in LaTeX."""
    for sign, command in _TEX.items():
        letter = letter.replace(sign, command)
    return letter
