"""Sentences as LaTeX: every sign that the files have, indices, powers of ten, names that break."""

from __future__ import annotations

import re

#: Signs and what they are in math mode, in pairs.
_TABLE = str.split(r"""
α \alpha β \beta γ \gamma δ \delta ε \varepsilon ζ \zeta η \eta θ \theta ι \iota κ \kappa
λ \lambda μ \mu ν \nu ξ \xi π \pi ρ \rho σ \sigma τ \tau υ \upsilon φ \varphi χ \chi ψ \psi
ω \omega Γ \Gamma Δ \Delta Θ \Theta Λ \Lambda Ξ \Xi Π \Pi Σ \Sigma Φ \Phi Ψ \Psi Ω \Omega
ϑ \vartheta ≤ \le ≥ \ge ≠ \ne ≈ \approx · \cdot ⋅ \cdot × \times ± \pm √ \surd ∞ \infty ∧ \wedge
∨ \vee ⊥ \perp … \ldots → \to ↦ \mapsto ∈ \in ∉ \notin ∑ \sum ½ \tfrac12 ° ^\circ ′ ' − - < < > >
| | ¬ \neg ∠ \angle ∪ \cup ∩ \cap ⊂ \subset ∫ \int ∂ \partial ℝ \mathbb{R} 𝔄 \mathfrak{A}
⇒ \Rightarrow ⇔ \Leftrightarrow ∀ \forall ∃ \exists
""")
_SIGNS = dict(zip(_TABLE[::2], _TABLE[1::2], strict=True))
_RAISED = dict(zip("⁰¹²³⁴⁵⁶⁷⁸⁹⁺⁻ⁿ", "0123456789+-n", strict=True))
_LOWERED = dict(zip("₀₁₂₃₄₅₆₇₈₉₊₋ₙ", "0123456789+-n", strict=True))
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
_INDEX = r"[_^](?:\{(?P<braced>[^{}]*)\}|\((?P<round>[^()]*)\)|(?P<word>[^\W\d_]+|[0-9]+|[⁺⁻±∞]))"
_SMALL = "".join((*_RAISED, *_LOWERED))
_TOKEN = re.compile(
    rf"(?P<letter>(?<![^\W\d_])[A-Za-z](?=[_^{_SMALL}]))"
    rf"|(?P<power>10[⁻⁰¹²³⁴⁵⁶⁷⁸⁹]+)|(?P<bar>.\u0304)|(?P<index>{_INDEX})"
    rf"|(?P<raised>[{''.join(_RAISED)}]+)|(?P<lowered>[{''.join(_LOWERED)}]+)|(?P<one>.)",
    re.DOTALL,
)

_RUN = re.compile(f"[{''.join(_RAISED)}]+|[{''.join(_LOWERED)}]+|.", re.DOTALL)


def words(text: str) -> str:
    """A sentence in text mode."""
    return _TOKEN.sub(_set, text).replace("$$", " ")


def _set(match: re.Match[str]) -> str:
    found = match[0]
    if match["letter"]:
        return f"${found}$"
    if match["power"]:
        return rf"$10^{{{_digits(found[2:], _RAISED)}}}$"
    if match["bar"]:
        return rf"$\bar{{{math(found[0])}}}$"
    if match["index"]:
        inner = match["braced"] or match["round"] or match["word"] or ""
        return rf"${found[0]}{{{math(inner)}}}$"
    if match["raised"]:
        return rf"$^{{{_digits(found, _RAISED)}}}$"
    if match["lowered"]:
        return rf"$_{{{_digits(found, _LOWERED)}}}$"
    return _one(found)


def _one(sign: str) -> str:
    if sign in _ESCAPED:
        return _ESCAPED[sign]
    if sign in _SIGNS:
        return rf"${_SIGNS[sign]}$"
    if sign.isascii() or sign in _LETTERS:
        return sign
    if sign in _MARKS:
        return _MARKS[sign]
    return rf"\texttt{{U+{ord(sign):04X}}}"  # no font is asked for what nobody has seen


def math(text: str) -> str:
    """A few letters in math mode, as an index has them; several of them upright."""
    parts = [_in_math(part) for part in _RUN.findall(text)]
    inner = " ".join(parts) if any(p.startswith("\\") for p in parts) else "".join(parts)
    return rf"\mathrm{{{inner}}}" if len(text) > 1 and text.isalpha() and text.isascii() else inner


def _in_math(part: str) -> str:
    """A sign, or several raised or lowered digits."""
    if part[0] in _RAISED:
        return f"^{{{_digits(part, _RAISED)}}}"
    if part[0] in _LOWERED:
        return f"_{{{_digits(part, _LOWERED)}}}"
    return _SIGNS.get(part, _one(part))


def _digits(text: str, table: dict[str, str]) -> str:
    return "".join(table[sign] for sign in text)


def name(text: str) -> str:
    """A name or a label in typewriter letters; it breaks where it is long."""
    parts = re.findall(r"[^-_.\s]{1,8}[-_.]*|[-_.]+|\s", text)
    inner = r"\allowbreak{}".join("".join(map(_one, part)) for part in parts)
    return rf"\texttt{{{inner}}}"


def tex_number(text: str) -> str:
    """A number as people write it, in math mode: ``5.9…·10⁻⁵`` or ``[0.1, 0.2]``."""
    text = re.sub("10([⁻⁰¹²³⁴⁵⁶⁷⁸⁹]+)", lambda found: f"10^{{{_digits(found[1], _RAISED)}}}", text)
    text = text.replace("·", r" \times ").replace("…", r"\ldots{}")
    return text.replace(", ", r",\allowbreak\ ")
