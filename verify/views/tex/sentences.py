"""Sentences as LaTeX: every sign that the files have, indices, powers of ten, names that break."""

from __future__ import annotations

import re
from collections.abc import Iterable
from itertools import groupby
from operator import itemgetter

from verify.language.scripts import LOWERED, RAISED, Pieces, Scripted, pieces

#: Signs and what they are in math mode, in pairs.
_TABLE = str.split(r"""
α \alpha β \beta γ \gamma δ \delta ε \varepsilon ζ \zeta η \eta θ \theta ι \iota κ \kappa
λ \lambda μ \mu ν \nu ξ \xi π \pi ρ \rho σ \sigma τ \tau υ \upsilon φ \varphi χ \chi ψ \psi
ω \omega Γ \Gamma Δ \Delta Θ \Theta Λ \Lambda Ξ \Xi Π \Pi Σ \Sigma Φ \Phi Ψ \Psi Ω \Omega
ϑ \vartheta ≤ \le ≥ \ge ≠ \ne ≈ \approx · \cdot ⋅ \cdot × \times ± \pm √ \surd ∞ \infty ∧ \wedge
∨ \vee ⊥ \perp … \ldots → \to ↦ \mapsto ∈ \in ∉ \notin ∑ \sum ½ \tfrac12 ° ^\circ ′ \prime
− - < < > >
| | ¬ \neg ∠ \angle ∪ \cup ∩ \cap ⊂ \subset ∫ \int ∂ \partial ℝ \mathbb{R} 𝔄 \mathfrak{A}
⇒ \Rightarrow ⇔ \Leftrightarrow ∀ \forall ∃ \exists
""")
_SIGNS = dict(zip(_TABLE[::2], _TABLE[1::2], strict=True))
_MARKS = {"–": "--", "—": "---", "’": "'", "‘": "`", "“": "``", "”": "''"}
#: Letters with accents that every LaTeX reads.
_LETTERS = "ÀÁÂÄÇÈÉÊËÍÎÏÑÓÔÖØÙÚÛÜàáâäçèéêëíîïñóôöøùúûüß"
_ESCAPED = {
    **{sign: "\\" + sign for sign in "&%#_{}"},
    "$": r"\textdollar{}",
    "\\": r"\textbackslash{}",
    "^": r"\^{}",
    "~": r"\~{}",
}
#: A hyphen between words, numbers and names is one; after anything else it is a minus sign.
_MINUS = re.compile(r"(?<![\w)\]'.…-])-(?!-)")
_RELATIONS = {"<=": r"\le", ">=": r"\ge"}


def words(text: str) -> str:
    """A sentence in text mode."""
    found: list[tuple[bool, str]] = []
    for piece in pieces(text):
        if isinstance(piece, Scripted):
            found.append((True, _scripted(piece)))
        else:
            found += map(_one, re.findall("<=|>=|.", _MINUS.sub("−", piece), re.DOTALL))
    return "".join(
        f"${_joined(tex for _, tex in group)}$" if is_math else "".join(tex for _, tex in group)
        for is_math, group in groupby(found, key=itemgetter(0))
    )


def _one(sign: str) -> tuple[bool, str]:
    """Whether a sign is mathematics, and its LaTeX."""
    for mark, table in (("^", RAISED), ("_", LOWERED)):
        if sign in table:
            return True, f"{{}}{mark}{{{table[sign]}}}"
    if sign in _RELATIONS or sign in _SIGNS:
        return True, (_RELATIONS.get(sign) or _SIGNS[sign])
    return False, _in_text(sign)


def _in_text(sign: str) -> str:
    if sign in _ESCAPED:
        return _ESCAPED[sign]
    if sign.isascii() or sign in _LETTERS:
        return sign
    if sign in _MARKS:
        return _MARKS[sign]
    return rf"\texttt{{U+{ord(sign):04X}}}"  # no font is asked for what nobody has seen


def math(text: str) -> str:
    """A few letters in math mode; words are upright."""
    return _formula(pieces(text))


def _formula(inner: Pieces) -> str:
    return _joined(
        _scripted(part) if isinstance(part, Scripted) else _letters(part) for part in inner
    )


def _scripted(piece: Scripted) -> str:
    """A letter with its bar, index and power, in math mode."""
    base = _letters(piece.base)
    text = rf"\bar{{{base}}}" if piece.bar else base
    if piece.lower:
        text += f"_{{{_formula(piece.lower)}}}"
    return text + (f"^{{{_formula(piece.upper)}}}" if piece.upper else "")


def _letters(text: str) -> str:
    parts = re.findall("[A-Za-z]+|.", text, re.DOTALL)
    return _joined(
        rf"\mathrm{{{part}}}" if part.isalpha() and len(part) > 1 else _one(part)[1]
        for part in parts
    )


def _joined(parts: Iterable[str]) -> str:
    """Formulas one after the other; a command ends where letters begin."""
    text = ""
    for part in parts:
        is_command = re.search(r"\\[A-Za-z]+$", text) and part[:1].isalpha()
        text += f" {part}" if is_command else part
    return text


def name(text: str) -> str:
    """A name or a label in typewriter letters; it breaks where it is long."""
    parts = re.findall(r"[^-_.\s]{1,8}[-_.]*|[-_.]+|\s", text)
    inner = r"\allowbreak{}".join("".join(map(_in_text, part)) for part in parts)
    return rf"\texttt{{{inner}}}"


def tex_number(text: str) -> str:
    """A number as people write it, in math mode: ``5.9…·10⁻⁵`` or ``[0.1, 0.2]``."""
    signs = {"·": r" \times ", "…": r"\ldots{}", "±": r"\pm{}", ", ": r",\allowbreak\ "}
    parts = []
    for piece in pieces(text):
        if isinstance(piece, Scripted):
            parts.append(_scripted(piece))
        else:
            parts += [signs.get(sign, sign) for sign in re.findall(", |.", piece)]
    return "".join(parts)
