"""A statement as LaTeX source beside the numbers of its certificate, for a referee."""

from __future__ import annotations

from collections.abc import Iterable, Iterator, Mapping

from verify.language.statement import (
    PROVED,
    REFUTED,
    Always,
    Applies,
    Constant,
    Context,
    Obligation,
)
from verify.language.terms import Claim, Term, symbol
from verify.language.typeset import Typesetter
from verify.prover.outcome import Decision, Outcome
from verify.wire.write import decimals

_PREAMBLE = r"""\documentclass{article}
\usepackage[landscape,margin=1cm]{geometry}
\usepackage{amsmath,amssymb,longtable}
\begin{document}"""


def statement_source(outcome: Outcome) -> str:
    """A LaTeX document with every constant, context and obligation of an outcome."""
    return "\n".join(_lines(outcome)) + "\n"


def _lines(outcome: Outcome) -> Iterator[str]:
    statement = outcome.statement
    typesetter = Typesetter(_letters(outcome), latex=True)
    yield _PREAMBLE
    yield rf"\section*{{{_escape(statement.title)}}}"
    yield from _table(_constant(c, outcome, typesetter) for c in statement.constants)
    for context in statement.contexts:
        yield from _context(context, outcome, typesetter)
    yield from _table(_row(row, found, typesetter) for row, found in outcome.rows)
    yield r"\end{document}"


def _table(rows: Iterable[tuple[str, ...]]) -> Iterator[str]:
    lines = [f"{' & '.join(row)} \\\\" for row in rows]
    if lines:
        yield from (r"\begin{longtable}{lll}", *lines, r"\end{longtable}")


def _constant(constant: Constant, outcome: Outcome, typesetter: Typesetter) -> tuple[str, ...]:
    letter, term = typesetter.term(symbol(constant.name)), typesetter.term(constant.term)
    found = outcome.enclosures.get(constant.name)
    ends = "" if found is None else f"$[{', '.join(decimals(found.ends[0]))}]$"
    return f"${letter}$", rf"$\displaystyle {term}$", ends


def _context(context: Context, outcome: Outcome, typesetter: Typesetter) -> Iterator[str]:
    variables = ", ".join(f"${typesetter.term(symbol(v.name))}$" for v in context.variables)
    inside = f" inside {_escape(context.parent)}" if context.parent else ""
    says = f": {_escape(context.says)}" if context.says else ""
    yield rf"\paragraph{{{_escape(context.name)}}} For all {variables}{inside}{says}"
    yield from _table((f"${typesetter.claim(g.claim)}$", g.kind, "") for g in context.givens)
    yield from _table(_constant(c, outcome, typesetter) for c in context.constants)


def _row(row: Obligation, found: Decision, typesetter: Typesetter) -> tuple[str, ...]:
    claim = _claim(row.claim, typesetter)
    if found.verdict == REFUTED:
        claim = rf"\neg\left({claim}\right)"
    elif found.verdict != PROVED:
        claim = rf"{claim} \quad \text{{({found.verdict})}}"
    place = f" in {_escape(row.context)}" if row.context else ""
    return (
        rf"\texttt{{{_escape(row.label)}}}{place}",
        rf"$\displaystyle {claim}$",
        _numbers(found, typesetter),
    )


def _numbers(found: Decision, typesetter: Typesetter) -> str:
    if found.sides is not None:
        pairs = zip(("lhs", "rhs"), found.sides.ends, strict=True)
        return " ".join(f"${side}$: $[{', '.join(decimals(ends))}]$" for side, ends in pairs)
    return f"at ${_values(found.witness, typesetter)}$" if found.witness else ""


def _claim(claim: Claim | Applies | Always, typesetter: Typesetter) -> str:
    if isinstance(claim, Claim):
        return typesetter.claim(claim)
    name = rf"\text{{{_escape(claim.context)}}}"
    if isinstance(claim, Applies):
        return rf"{name} \text{{ at }} {_values(claim.at, typesetter)}"
    start, following = (_values(values, typesetter) for values in (claim.start, claim.next))
    return rf"{name} \text{{ always, from }} {start} \text{{ by }} {following}"


def _values(values: Mapping[str, Term], typesetter: Typesetter) -> str:
    pairs = sorted(values.items())
    return ", ".join(f"{typesetter.term(symbol(n))} = {typesetter.term(t)}" for n, t in pairs)


def _letters(outcome: Outcome) -> dict[str, str]:
    statement = outcome.statement
    letters = {"r": "r", "c": r"(-\cos\theta_0)", "V_0": "V_0", "delta_theta": r"\delta_\theta"}
    constants = list(statement.constants)
    for context in statement.contexts:
        letters |= {variable.name: f"{{{variable.tex}}}" for variable in context.variables}
        constants += context.constants
    for constant in constants:
        group = constant.name.rpartition(".")[0]
        mark = rf"^{{\text{{{_escape(group)}}}}}" if group else ""
        letters[constant.name] = f"{{{constant.tex}}}{mark}"
    return letters


def _escape(text: str) -> str:
    for character in "&%#_{}":
        text = text.replace(character, "\\" + character)
    return text.replace("^", r"\^{}").replace("θ", r"$\theta$").replace("√", r"$\surd$")
