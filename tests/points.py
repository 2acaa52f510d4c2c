"""Points of the parameter plane that the tests share."""

from __future__ import annotations

from fractions import Fraction

from verify.language.terms import Term, as_term

#: (r, c) inside the admissible region: the corners, the middle, and next to both thresholds.
ADMISSIBLE = [
    ("3/100", "1"),
    ("1/1000", "1"),
    ("1/100", "1"),
    ("1/20", "1"),
    ("11/200", "1"),
    ("1/1000000", "1/20"),
    ("1/100", "9/10"),
    ("1/60", "99/100"),
    ("3/100", "0.790819784574657985385940817856816171"),
    ("0.055728090000841214363305325073", "1"),
]


def parameters(r: str, c: str, v_0: str = "1", delta_theta: str = "1/10") -> dict[str, Term]:
    """The parameters of the theorem as exact terms."""
    texts = {"r": r, "c": c, "V_0": v_0, "delta_theta": delta_theta}
    return {name: as_term(Fraction(text)) for name, text in texts.items()}
