"""The constants as a LaTeX table."""

from __future__ import annotations

from verify.language.statement import PRINTED, REPAIRED
from verify.prover.decimals import outward
from verify.prover.outcome import Outcome
from verify.views.words import constants_of, ends_of


def latex(outcome: Outcome) -> str:
    """The constants as a LaTeX table: enclosures of the first and printed ones, repaired values."""
    lines = [
        f"% {outcome.statement.title}",
        "% Enclosures: the true value lies between the two ends.",
        r"\begin{tabular}{lll}",
        r"\hline",
        r"constant & as printed & repaired \\",
        r"\hline",
    ]
    repaired = {c.short_name: c.name for c in constants_of(outcome, REPAIRED)}
    first = [*constants_of(outcome, ""), *constants_of(outcome, PRINTED)]
    known = {constant.short_name for constant in first}
    only = [c for c in constants_of(outcome, REPAIRED) if c.short_name not in known]
    for constant in (*first, *only):
        printed = "" if constant in only else _tex_number(outcome, constant.name)
        other = _tex_number(outcome, repaired.get(constant.short_name, ""))
        lines.append(rf"${constant.tex}$ & {printed} & {other} \\")
    return "\n".join([*lines, r"\hline", r"\end{tabular}"]) + "\n"


def _tex_number(outcome: Outcome, name: str) -> str:
    """An exact decimal, or an interval of 8 digits that contains the enclosure."""
    ends = ends_of(outcome, name)
    if ends is None:
        return ""
    low, high = outward(ends, 8)
    if low == high:
        return f"${_tex_decimal(low)}$"
    return rf"$[{_tex_decimal(low)},\, {_tex_decimal(high)}]$"


def _tex_decimal(text: str) -> str:
    mantissa, _, exponent = text.partition("e")
    return mantissa if not exponent else rf"{mantissa}\cdot 10^{{{exponent}}}"
